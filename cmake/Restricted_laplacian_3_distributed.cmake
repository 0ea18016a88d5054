# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# The target Restricted_laplacian_3::distributed, a library of its own, where MPI, PETSc and SLEPc are
# found: the headers in distributed/. -DRESTRICTED_LAPLACIAN_3_DISTRIBUTED=OFF turns it off, and
# PKG_CONFIG_PATH leads to another PETSc than that of the system.

set(RESTRICTED_LAPLACIAN_3_PETSC "")
if(NOT RESTRICTED_LAPLACIAN_3_DISTRIBUTED OR NOT TARGET Restricted_laplacian_3_compiled)
  return()
endif()
# PETSc's libraries are those of C.
get_property(languages GLOBAL PROPERTY ENABLED_LANGUAGES)
if(NOT "C" IN_LIST languages)
  enable_language(C)
endif()
find_package(MPI QUIET COMPONENTS C)
find_package(PkgConfig QUIET)
if(NOT MPI_C_FOUND OR NOT PKG_CONFIG_FOUND)
  return()
endif()
pkg_check_modules(PETSC QUIET IMPORTED_TARGET petsc>=3.17)
pkg_check_modules(SLEPC QUIET IMPORTED_TARGET slepc>=3.17)
if(NOT PETSC_FOUND OR NOT SLEPC_FOUND)
  return()
endif()
set(RESTRICTED_LAPLACIAN_3_PETSC "${PETSC_VERSION}, SLEPc ${SLEPC_VERSION}")

file(GLOB sources CONFIGURE_DEPENDS src/Restricted_laplacian_3/distributed/*.cpp)
add_library(Restricted_laplacian_3_distributed ${sources})
add_library(Restricted_laplacian_3::distributed ALIAS Restricted_laplacian_3_distributed)
set_target_properties(Restricted_laplacian_3_distributed PROPERTIES EXPORT_NAME distributed
  OUTPUT_NAME CGAL_Restricted_laplacian_3_distributed POSITION_INDEPENDENT_CODE ON UNITY_BUILD OFF
  VERSION "${PROJECT_VERSION}" SOVERSION "${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")
target_link_libraries(Restricted_laplacian_3_distributed PUBLIC Restricted_laplacian_3_compiled
  PkgConfig::SLEPC PkgConfig::PETSC MPI::MPI_C)
if(NOT is_top_level)
  set_target_properties(Restricted_laplacian_3_distributed PROPERTIES EXCLUDE_FROM_ALL ON)
endif()

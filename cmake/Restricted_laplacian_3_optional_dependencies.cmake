# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Creates the target Restricted_laplacian_3::optional_dependencies with what this machine has of the
# libraries that the headers use when they are there. The project itself includes this file, and so
# does its installed package: an installation carries no path of the machine where it was made.
#
# -DCMAKE_DISABLE_FIND_PACKAGE_CHOLMOD=ON and -DSpectra_INCLUDE_DIR=OFF turn them off.

if(TARGET Restricted_laplacian_3::optional_dependencies)
  return()
endif()

set(Restricted_laplacian_3_module_path "${CMAKE_MODULE_PATH}")
list(INSERT CMAKE_MODULE_PATH 0 "${CMAKE_CURRENT_LIST_DIR}")
find_package(CHOLMOD MODULE QUIET)
set(CMAKE_MODULE_PATH "${Restricted_laplacian_3_module_path}")
unset(Restricted_laplacian_3_module_path)

find_path(Spectra_INCLUDE_DIR NAMES Spectra/SymGEigsShiftSolver.h)
mark_as_advanced(Spectra_INCLUDE_DIR)

add_library(Restricted_laplacian_3::optional_dependencies INTERFACE IMPORTED GLOBAL)
# for dlsym(), where that is not in the C library
set_property(TARGET Restricted_laplacian_3::optional_dependencies APPEND PROPERTY
  INTERFACE_LINK_LIBRARIES ${CMAKE_DL_LIBS})
if(CHOLMOD_FOUND)
  set_property(TARGET Restricted_laplacian_3::optional_dependencies APPEND PROPERTY
    INTERFACE_COMPILE_DEFINITIONS CGAL_RESTRICTED_LAPLACIAN_3_USE_CHOLMOD)
  set_property(TARGET Restricted_laplacian_3::optional_dependencies APPEND PROPERTY
    INTERFACE_INCLUDE_DIRECTORIES "${CHOLMOD_INCLUDE_DIR}")
  set_property(TARGET Restricted_laplacian_3::optional_dependencies APPEND PROPERTY
    INTERFACE_LINK_LIBRARIES "${CHOLMOD_LIBRARY}")
endif()
if(Spectra_INCLUDE_DIR)
  set_property(TARGET Restricted_laplacian_3::optional_dependencies APPEND PROPERTY
    INTERFACE_INCLUDE_DIRECTORIES "${Spectra_INCLUDE_DIR}")
endif()

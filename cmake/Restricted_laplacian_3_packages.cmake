# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Packages of what is installed, made by `cpack` in the build folder: a Debian package of the headers,
# one of the compiled library and one of the programs, and an archive of all of them. The target
# `package_source` makes an archive of the sources.

if(CMAKE_VERSION VERSION_LESS 3.19 OR NOT RESTRICTED_LAPLACIAN_3_INSTALL)
  message(STATUS "Packages are off: they need CMake 3.19 and RESTRICTED_LAPLACIAN_3_INSTALL")
  return()
endif()

set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_GENERATOR DEB TGZ)
# the one place for this name; what cannot read it is compared with it by the test one_name
file(STRINGS package_info/Restricted_laplacian_3/maintainer CPACK_PACKAGE_VENDOR LIMIT_COUNT 1)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
  package_info/Restricted_laplacian_3/maintainer)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_COMPONENTS_ALL headers)
set(CPACK_PACKAGE_FILE_NAME "Restricted_laplacian_3-${PROJECT_VERSION}-noarch")
if(TARGET Restricted_laplacian_3_compiled)
  list(APPEND CPACK_COMPONENTS_ALL compiled)
  set(CPACK_PACKAGE_FILE_NAME
    "Restricted_laplacian_3-${PROJECT_VERSION}-${CMAKE_SYSTEM_NAME}-${CMAKE_SYSTEM_PROCESSOR}")
endif()
if(TARGET solve_poisson)
  list(APPEND CPACK_COMPONENTS_ALL programs)
  set(CPACK_PACKAGE_FILE_NAME
    "Restricted_laplacian_3-${PROJECT_VERSION}-${CMAKE_SYSTEM_NAME}-${CMAKE_SYSTEM_PROCESSOR}")
endif()
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_RESOURCE_FILE_README "${PROJECT_SOURCE_DIR}/README.md")
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_PACKAGE_CONTACT "${CPACK_PACKAGE_VENDOR}")
set(CPACK_PROJECT_CONFIG_FILE "${PROJECT_SOURCE_DIR}/cmake/Restricted_laplacian_3_maintainer.cmake")

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION TRUE)

set(CPACK_DEBIAN_HEADERS_PACKAGE_NAME libcgal-restricted-laplacian-3-dev)
set(CPACK_DEBIAN_HEADERS_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_HEADERS_PACKAGE_DEPENDS "libcgal-dev (>= 5.5), libeigen3-dev (>= 3.4)")
set(CPACK_DEBIAN_HEADERS_PACKAGE_RECOMMENDS
  "libsuitesparse-dev, libopenblas-dev, libspectra-dev, libtbb-dev")
set(CPACK_DEBIAN_HEADERS_PACKAGE_SUGGESTS "cmake, libcgal-demo, libopenmesh-dev")
if(RESTRICTED_LAPLACIAN_3_BUILD_DOC)
  string(APPEND CPACK_DEBIAN_HEADERS_PACKAGE_RECOMMENDS ", libjs-mathjax")
endif()
set(CPACK_DEBIAN_HEADERS_DESCRIPTION
"Headers for Poisson problems, spectra, curvature, fits of functions and
colors of scans on triangle meshes, triangle soups and oriented points, in
the style of CGAL. The functions do not depend on the triangulation: they are
B-splines on an octree, restricted to the surface.")

set(CPACK_DEBIAN_COMPILED_PACKAGE_NAME libcgal-restricted-laplacian-3-compiled-dev)
set(CPACK_DEBIAN_COMPILED_PACKAGE_DEPENDS
  "${CPACK_DEBIAN_HEADERS_PACKAGE_NAME} (= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")
if(CHOLMOD_FOUND)
  string(APPEND CPACK_DEBIAN_COMPILED_PACKAGE_DEPENDS ", libsuitesparse-dev")
endif()
if(TARGET CGAL::TBB_support)
  string(APPEND CPACK_DEBIAN_COMPILED_PACKAGE_DEPENDS ", libtbb-dev")
endif()
set(CPACK_DEBIAN_COMPILED_PACKAGE_RECOMMENDS "libopenblas-dev")
set(CPACK_DEBIAN_COMPILED_DESCRIPTION
"The functions that do not depend on types of the caller, compiled: programs
that are linked with this library compile in less time and memory than with
the headers alone.")

set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME restricted-laplacian-3)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SECTION math)
find_program(DPKG_SHLIBDEPS dpkg-shlibdeps)
mark_as_advanced(DPKG_SHLIBDEPS)
if(DPKG_SHLIBDEPS)
  set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SHLIBDEPS ON)
endif()
if(BUILD_SHARED_LIBS)
  set(CPACK_DEBIAN_PROGRAMS_PACKAGE_DEPENDS
    "${CPACK_DEBIAN_COMPILED_PACKAGE_NAME} (= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")
endif()
set(CPACK_DEBIAN_PROGRAMS_DESCRIPTION
"Programs for the command line that solve Poisson problems on surfaces, compute
spectra, descriptors, curvature and distances, fit functions, and color meshes
from scans. They read triangle meshes and oriented points in the usual formats,
and write tables, meshes, and pages to turn surfaces around in a browser.")
set(CPACK_PRE_BUILD_SCRIPTS "${PROJECT_SOURCE_DIR}/cmake/Restricted_laplacian_3_debian.cmake")

# All but what .gitignore lists.
set(CPACK_SOURCE_GENERATOR TGZ)
set(CPACK_SOURCE_PACKAGE_FILE_NAME "Restricted_laplacian_3-${PROJECT_VERSION}-source")
set(CPACK_SOURCE_IGNORE_FILES "/compile_commands\\.json$" "/CMakeUserPresets\\.json$" "~$"
  "\\.swp$" "/\\.git(/|$)" "/\\.(cache|vscode|idea|mypy_cache|pytest_cache)/")
foreach(dir IN ITEMS "${PROJECT_SOURCE_DIR}/build" "${PROJECT_SOURCE_DIR}/demo_output"
    "${PROJECT_BINARY_DIR}")
  string(REGEX REPLACE "([][+.*()^$?|\\])" "\\\\\\1" dir "${dir}")
  list(APPEND CPACK_SOURCE_IGNORE_FILES "^${dir}/")
endforeach()

include(CPack)

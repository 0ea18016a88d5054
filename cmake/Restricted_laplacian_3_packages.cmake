# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Packages of what is installed, made by `cpack` in the build folder: a Debian package and an
# archive. The target `package_source` makes an archive of the sources.

if(CMAKE_VERSION VERSION_LESS 3.19 OR NOT RESTRICTED_LAPLACIAN_3_INSTALL)
  message(STATUS "Packages are off: they need CMake 3.19 and RESTRICTED_LAPLACIAN_3_INSTALL")
  return()
endif()

set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_GENERATOR DEB TGZ)
set(CPACK_PACKAGE_VENDOR "The Restricted_laplacian_3 developers")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_FILE_NAME "Restricted_laplacian_3-${PROJECT_VERSION}-noarch")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_RESOURCE_FILE_README "${PROJECT_SOURCE_DIR}/README.md")
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

# Who makes a package is its maintainer, by the environment variables of Debian's tools.
if(DEFINED ENV{DEBFULLNAME} AND DEFINED ENV{DEBEMAIL})
  set(CPACK_PACKAGE_CONTACT "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
else()
  set(CPACK_PACKAGE_CONTACT "Unknown <unknown@localhost>")
endif()

set(CPACK_DEBIAN_PACKAGE_NAME libcgal-restricted-laplacian-3-dev)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libcgal-dev (>= 5.5), libeigen3-dev (>= 3.4)")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS
  "libsuitesparse-dev, libopenblas-dev, libspectra-dev, libtbb-dev")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "cmake, libcgal-demo, libopenmesh-dev, libpng-dev")
if(RESTRICTED_LAPLACIAN_3_BUILD_DOC)
  string(APPEND CPACK_DEBIAN_PACKAGE_RECOMMENDS ", libjs-mathjax")
endif()
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION TRUE)
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"Headers for Poisson problems, spectra, curvature, fits of functions and
colours of scans on triangle meshes, triangle soups and oriented points, in
the style of CGAL. The functions do not depend on the triangulation: they are
B-splines on an octree, restricted to the surface.")
set(CPACK_PRE_BUILD_SCRIPTS "${PROJECT_SOURCE_DIR}/cmake/Restricted_laplacian_3_debian.cmake")

# All but what .gitignore lists.
set(CPACK_SOURCE_GENERATOR TGZ)
set(CPACK_SOURCE_PACKAGE_FILE_NAME "Restricted_laplacian_3-${PROJECT_VERSION}-source")
set(CPACK_SOURCE_IGNORE_FILES "/compile_commands\\.json$" "/CMakeUserPresets\\.json$" "~$"
  "\\.swp$" "/\\.git(/|$)" "/\\.(cache|vscode|idea)/")
foreach(dir IN ITEMS "${PROJECT_SOURCE_DIR}/build" "${PROJECT_SOURCE_DIR}/demo_output"
    "${PROJECT_BINARY_DIR}")
  string(REGEX REPLACE "([][+.*()^$?|\\])" "\\\\\\1" dir "${dir}")
  list(APPEND CPACK_SOURCE_IGNORE_FILES "^${dir}/")
endforeach()

include(CPack)

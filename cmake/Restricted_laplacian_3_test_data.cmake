# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# The meshes of tests, benchmarks and the demonstration. Sets
#
# RESTRICTED_LAPLACIAN_3_DATA_DIR       folder with the meshes below, taken out of the archive of
#                                       CGAL's data, beside points_3 with the points; empty if
#                                       there is no archive
# RESTRICTED_LAPLACIAN_3_SHARED_MESHES  folder with a larger set of meshes; may be empty

set(meshes
  armadillo.off bear.off blade.off boeing.off bunny00.off camel.off cow.off degtri_sliding.off
  elephant.off elephant-with-holes.off fandisk.off fandisk_large.off femur.off lion-head.off
  mannequin-devil.off nefertiti.off rotor.off rotor_small.off turbine.off)
set(points kitten.xyz)

set(RESTRICTED_LAPLACIAN_3_DATA_ARCHIVE "/usr/share/doc/libcgal-dev/data.tar.gz" CACHE FILEPATH
  "CGAL's data, as Debian's package libcgal-demo installs it")

if(DEFINED ENV{RESTRICTED_LAPLACIAN_3_SHARED_MESHES})
  set(default_shared_meshes "$ENV{RESTRICTED_LAPLACIAN_3_SHARED_MESHES}")
elseif(IS_DIRECTORY "${PROJECT_SOURCE_DIR}/../shared/meshes")
  get_filename_component(default_shared_meshes "${PROJECT_SOURCE_DIR}/../shared/meshes" ABSOLUTE)
else()
  set(default_shared_meshes "")
endif()
set(RESTRICTED_LAPLACIAN_3_SHARED_MESHES "${default_shared_meshes}" CACHE PATH
  "Folder with the larger set of meshes; tests that need one are skipped where it is empty")

set(RESTRICTED_LAPLACIAN_3_DATA_DIR "")
if(NOT EXISTS "${RESTRICTED_LAPLACIAN_3_DATA_ARCHIVE}")
  return()
endif()
if(CMAKE_VERSION VERSION_LESS 3.18)
  message(STATUS "Restricted_laplacian_3: reading CGAL's data needs CMake 3.18")
  return()
endif()

set(RESTRICTED_LAPLACIAN_3_DATA_DIR "${PROJECT_BINARY_DIR}/data/meshes")
list(TRANSFORM meshes PREPEND data/meshes/)
list(TRANSFORM points PREPEND data/points_3/)
set(missing_files "")
foreach(file IN LISTS meshes points)
  if(NOT EXISTS "${PROJECT_BINARY_DIR}/${file}")
    list(APPEND missing_files "${file}")
  endif()
endforeach()
if(missing_files)
  file(ARCHIVE_EXTRACT INPUT "${RESTRICTED_LAPLACIAN_3_DATA_ARCHIVE}"
    DESTINATION "${PROJECT_BINARY_DIR}" PATTERNS ${missing_files})
endif()

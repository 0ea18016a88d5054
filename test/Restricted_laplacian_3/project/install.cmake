# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Installs the project ROOT, built in BUILD_DIR, into an empty PREFIX. Every header and example must
# have gone there, LIBRARY, if it is not empty, into the folder LIBDIR, and what other build systems
# read must name no path of this machine.

cmake_minimum_required(VERSION 3.16)

file(REMOVE_RECURSE "${PREFIX}")
execute_process(COMMAND "${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${PREFIX}"
  RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "cannot install")
endif()

# all_installed(source_dir dir): all files of one folder are in the other
function(all_installed source_dir dir)
  file(GLOB_RECURSE files RELATIVE "${source_dir}" "${source_dir}/*")
  foreach(file IN LISTS files)
    if(NOT EXISTS "${dir}/${file}")
      message(SEND_ERROR "${file} was not installed")
    endif()
  endforeach()
endfunction()

set(doc "${PREFIX}/share/doc/Restricted_laplacian_3")
all_installed("${ROOT}/include" "${PREFIX}/include")
all_installed("${ROOT}/examples/Restricted_laplacian_3" "${doc}/examples")
foreach(file IN ITEMS README.md CHANGELOG.md LICENSE)
  if(NOT EXISTS "${doc}/${file}")
    message(SEND_ERROR "${file} was not installed")
  endif()
endforeach()
set(manual "doc/Restricted_laplacian_3/html/index.html")
if(EXISTS "${BUILD_DIR}/${manual}" AND NOT EXISTS "${doc}/html/index.html")
  message(SEND_ERROR "the manual was not installed")
endif()

set(viewer "viewer/viewer.html")
if(EXISTS "${BUILD_DIR}/${viewer}" AND NOT EXISTS "${PREFIX}/share/Restricted_laplacian_3/viewer.html")
  message(SEND_ERROR "the viewer was not installed")
endif()

set(expected_number 6)
if(LIBRARY)
  set(expected_number 11)
  get_filename_component(name "${LIBRARY}" NAME)
  if(NOT EXISTS "${PREFIX}/${LIBDIR}/${name}")
    message(SEND_ERROR "${name} was not installed into ${LIBDIR}")
  endif()
endif()

file(GLOB_RECURSE files "${PREFIX}/*.cmake" "${PREFIX}/*.pc")
list(FILTER files EXCLUDE REGEX "/examples/")
list(LENGTH files number)
if(NOT number EQUAL expected_number)
  message(SEND_ERROR "CMake's or pkg-config's files are not ${expected_number}: ${files}")
endif()
foreach(file IN LISTS files)
  file(READ "${file}" text)
  foreach(path "${ROOT}" "${BUILD_DIR}" "${PREFIX}" "/usr/")
    string(FIND "${text}" "${path}" position)
    if(NOT position EQUAL -1)
      message(SEND_ERROR "${file} holds the path ${path}")
    endif()
  endforeach()
endforeach()

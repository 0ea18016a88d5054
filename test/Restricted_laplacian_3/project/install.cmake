# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Installs the project ROOT, configured in BUILD_DIR, into an empty PREFIX. Every header must have
# gone there, and the CMake files must name no path of this machine.

cmake_minimum_required(VERSION 3.16)

file(REMOVE_RECURSE "${PREFIX}")
execute_process(COMMAND "${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${PREFIX}"
  RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "cannot install")
endif()

file(GLOB_RECURSE headers RELATIVE "${ROOT}/include" "${ROOT}/include/*.h")
foreach(header IN LISTS headers)
  if(NOT EXISTS "${PREFIX}/include/${header}")
    message(SEND_ERROR "${header} was not installed")
  endif()
endforeach()

file(GLOB_RECURSE files "${PREFIX}/*.cmake")
if(NOT files)
  message(SEND_ERROR "no CMake file was installed")
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

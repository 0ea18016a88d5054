# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Checks that all sources of ROOT are laid out as .clang-format says.

cmake_minimum_required(VERSION 3.16)

set(version "")
if(CLANG_FORMAT)
  execute_process(COMMAND "${CLANG_FORMAT}" --version OUTPUT_VARIABLE version)
endif()
if(NOT version MATCHES "version 14\\.")
  message("SKIPPED: clang-format 14 was not found")
  return()
endif()

set(sources "")
foreach(dir include examples tools test benchmark python)
  file(GLOB_RECURSE found "${ROOT}/${dir}/*.h" "${ROOT}/${dir}/*.cpp")
  list(APPEND sources ${found})
endforeach()
if(NOT sources)
  message(FATAL_ERROR "there is no source in ${ROOT}")
endif()

# clang-format leaves comments as they are.
string(REPEAT "." 101 too_long)
foreach(source IN LISTS sources)
  file(STRINGS "${source}" lines REGEX "${too_long}")
  if(lines)
    string(REPLACE ";" "\n" lines "${lines}")
    message(SEND_ERROR "${source}: more than 100 columns\n${lines}")
  endif()
endforeach()

execute_process(COMMAND "${CLANG_FORMAT}" --dry-run -Werror ${sources} RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "mend with: ${CLANG_FORMAT} -i FILE...")
endif()

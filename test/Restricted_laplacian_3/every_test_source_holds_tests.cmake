# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Fails if one of SOURCES is compiled into TEST_EXECUTABLE but adds no test to it. With
# --filenames-as-tags each test carries the name of its file; a list of tests returns their number.

foreach(source IN LISTS SOURCES)
  get_filename_component(name "${source}" NAME_WE)
  execute_process(
    COMMAND "${TEST_EXECUTABLE}" --filenames-as-tags --list-test-names-only "[#${name}]"
    OUTPUT_VARIABLE tests RESULT_VARIABLE number_of_tests)
  if(NOT number_of_tests GREATER 0)
    message(SEND_ERROR "${source} holds no test")
  endif()
endforeach()

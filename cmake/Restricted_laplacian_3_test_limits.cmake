# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# No test without an end: to be included at the end of a folder, for its tests that set none.

get_property(tests DIRECTORY PROPERTY TESTS)
foreach(test IN LISTS tests)
  get_test_property(${test} TIMEOUT limit)
  if(NOT limit)
    set_tests_properties(${test} PROPERTIES TIMEOUT 120)
  endif()
endforeach()

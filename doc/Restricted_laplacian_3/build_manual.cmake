# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Runs DOXYGEN on DOXYFILE, whose output goes to OUTPUT_DIR, and prints its warnings. With STRICT a
# warning is an error.

cmake_minimum_required(VERSION 3.16)

# Doxygen leaves pages of former runs as they are.
file(REMOVE_RECURSE "${OUTPUT_DIR}/html")
file(MAKE_DIRECTORY "${OUTPUT_DIR}")
execute_process(COMMAND "${DOXYGEN}" "${DOXYFILE}" RESULT_VARIABLE result
  OUTPUT_VARIABLE messages ERROR_VARIABLE messages)
if(NOT result EQUAL 0 OR NOT EXISTS "${OUTPUT_DIR}/html/index.html")
  message(FATAL_ERROR "Doxygen failed:\n${messages}")
endif()

string(STRIP "${messages}" messages)
if(messages)
  message("${messages}")
  if(STRICT)
    message(FATAL_ERROR "Doxygen has warnings")
  endif()
endif()

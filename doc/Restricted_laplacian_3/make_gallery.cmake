# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Runs SCRIPT, make_gallery.sh, with BASH on PROGRAM_DIR, DATA_DIR and OUTPUT_DIR, if there is the file VIEWER.

file(MAKE_DIRECTORY "${OUTPUT_DIR}")
if(NOT EXISTS "${VIEWER}")
  message("SKIPPED: there is no viewer, so the gallery has no pages to turn around")
  return()
endif()
execute_process(COMMAND "${BASH}" "${SCRIPT}" "${PROGRAM_DIR}" "${DATA_DIR}" "${OUTPUT_DIR}"
  RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "The gallery could not be made")
endif()

# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Makes BINARY/viewer.html of the folder SOURCE, with the programs NODE and NPM. No error where the
# packages cannot be had: then there is no such file.

file(COPY "${SOURCE}/package.json" "${SOURCE}/package-lock.json" "${SOURCE}/build.js" "${SOURCE}/src"
  DESTINATION "${BINARY}")
set(command "${NPM}" ci --ignore-scripts --no-audit --no-fund)
if(NOT WITH_TESTS)
  list(APPEND command --omit=dev)
endif()
execute_process(COMMAND ${command} WORKING_DIRECTORY "${BINARY}"
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(result EQUAL 0)
  execute_process(COMMAND "${NODE}" build.js viewer.html WORKING_DIRECTORY "${BINARY}"
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
endif()
if(NOT result EQUAL 0)
  file(REMOVE "${BINARY}/viewer.html")
  message("The viewer is left out, pages for browsers (--html) are off:\n${output}")
endif()

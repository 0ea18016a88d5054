# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Who holds the copyright, maintains the package and is to be cited, is said once, in package_info of
# ROOT: what cannot read it there must say the same.

cmake_minimum_required(VERSION 3.16)

set(info "${ROOT}/package_info/Restricted_laplacian_3")
file(STRINGS "${info}/maintainer" name)
file(STRINGS "${info}/copyright" holder)
if(NOT name MATCHES "[^ ]" OR NOT holder STREQUAL name)
  message(SEND_ERROR "maintainer is '${name}', copyright is '${holder}'")
endif()

file(READ "${ROOT}/CITATION.cff" citation)
if(NOT citation MATCHES "\nauthors:\n  - name: \"${name}\"\n")
  message(SEND_ERROR "CITATION.cff does not name ${name} as the authors")
endif()

set(files "${ROOT}/CMakeLists.txt" "${ROOT}/CITATION.cff" "${ROOT}/.ci/run")
foreach(dir benchmark cmake doc examples include scripts src test tools)
  foreach(kind h cpp cmake txt in py sh awk)
    file(GLOB_RECURSE found "${ROOT}/${dir}/*.${kind}")
    list(APPEND files ${found})
  endforeach()
endforeach()
# what programs print, words, and what goes into other files
list(FILTER files EXCLUDE REGEX "/(outputs|results|fig)/|_log\\.txt$|/rooms\\.txt$")
set(number 0)
foreach(file IN LISTS files)
  file(STRINGS "${file}" lines LIMIT_COUNT 4)
  if(lines MATCHES "Copyright")
    math(EXPR number "${number} + 1")
    if(NOT lines MATCHES "Copyright \\(c\\) [0-9]+ ${name}(;|$)")
      message(SEND_ERROR "${file}: the copyright is not that of ${name}")
    endif()
  elseif(file MATCHES "\\.(h|cpp|cmake|py|sh)$")
    message(SEND_ERROR "${file} does not begin with its copyright")
  endif()
endforeach()
if(number LESS 300)
  message(SEND_ERROR "only ${number} files have a copyright")
endif()

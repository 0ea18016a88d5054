# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Lays the package out as CGAL's repository wants it, checks what is there, and compiles and runs some of
# it as CGAL's test suite does, with the CGAL in CGAL_DIR. Options: ROOT, OUTPUT (a folder that is
# replaced), BASH, CGAL_DIR, DATA_DIR (CGAL's data), CXX_COMPILER, GENERATOR, and PROGRAMS, such as
# `test:test_RL3_basics`, in a list.

cmake_minimum_required(VERSION 3.16)

set(name Restricted_laplacian_3)
set(tree "${OUTPUT}/tree")
set(package "${tree}/${name}")
file(REMOVE_RECURSE "${OUTPUT}")
if(NOT EXISTS "${CGAL_DIR}/CGALConfig.cmake")
  message("SKIPPED: there is no CGAL in \"${CGAL_DIR}\"")
  return()
endif()

# run(command...): stops the test if it fails; what it prints is in `printed`
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE out ERROR_VARIABLE out)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGN}: ${result}\n${out}")
  endif()
  set(printed "${out}" PARENT_SCOPE)
endfunction()

# CGAL's lists that the package enters, once
set(license_list "Installation/include/CGAL/license/gpl_package_list.txt")
set(package_list "Documentation/doc/Documentation/packages.txt")
file(WRITE "${tree}/${license_list}" "QP_solver Q\nRidges_3 R\n")
file(WRITE "${tree}/${package_list}" "\\package_listing{Heat_method_3}\n\\package_listing{Mesh_3}\n")
run("${BASH}" "${ROOT}/scripts/make_cgal_tree.sh" "${tree}")
run("${BASH}" "${ROOT}/scripts/make_cgal_tree.sh" "${tree}")
file(READ "${tree}/${license_list}" licenses)
file(READ "${tree}/${package_list}" packages)
if(NOT licenses MATCHES "^QP_solver Q\n${name} [A-Za-z ]+\nRidges_3 R\n$" OR NOT packages MATCHES
    "^.package_listing{Heat_method_3}\n.package_listing{${name}}\n.package_listing{Mesh_3}\n$")
  message(SEND_ERROR "CGAL's lists are\n${licenses}\nand\n${packages}")
endif()

# what CGAL asks of packages and headers
foreach(file package_info/${name}/copyright package_info/${name}/description.txt
    package_info/${name}/license.txt package_info/${name}/maintainer
    package_info/${name}/dependencies doc/${name}/PackageDescription.txt
    doc/${name}/dependencies doc/${name}/examples.txt doc/${name}/Doxyfile.in)
  if(NOT EXISTS "${package}/${file}")
    message(SEND_ERROR "there is no ${file}")
  endif()
endforeach()
file(GLOB_RECURSE headers "${package}/include/*.h")
file(GLOB_RECURSE own_headers "${ROOT}/include/CGAL/${name}/*.h")
list(FILTER own_headers EXCLUDE REGEX "/distributed/")
list(APPEND own_headers "${ROOT}/include/CGAL/${name}.h")
list(LENGTH headers number_of_headers)
list(LENGTH own_headers number_of_own_headers)
if(NOT number_of_headers EQUAL number_of_own_headers)
  message(SEND_ERROR "${number_of_headers} headers in place of ${number_of_own_headers}")
endif()
foreach(header IN LISTS headers)
  file(READ "${header}" text)
  if(NOT text MATCHES "^// Copyright [^\n]*\n// All rights reserved.\n//\n// This file is part of CGAL")
    message(SEND_ERROR "${header} does not begin with CGAL's comment")
  endif()
  string(REGEX MATCHALL "#include <CGAL/license/${name}.h>" includes "${text}")
  list(LENGTH includes number)
  if(NOT number EQUAL 1)
    message(SEND_ERROR "${header} includes the license ${number} times")
  endif()
endforeach()

# CGAL keeps the bibliography of all packages in one file: keys have a prefix, and each that is cited is
# there.
file(READ "${tree}/Documentation/doc/biblio/cgal_manual.bib" bibliography)
string(REPLACE ";" "," bibliography "${bibliography}") # no list separator
file(READ "${ROOT}/doc/${name}/Bibliography.txt" text)
string(REGEX MATCHALL "\\\\cgalBibEntry{[^\n]*" own_entries "${text}")
string(CONCAT entry "\n@misc{cgal:rl3-[^\n]*,\n  author = {[^\n]+},\n  title = {{[^\n]+}},\n"
  "  note = {[^\n]+}\n}")
string(REGEX MATCHALL "${entry}" entries "${bibliography}")
list(LENGTH own_entries number_of_own_entries)
list(LENGTH entries number_of_entries)
if(NOT number_of_entries EQUAL number_of_own_entries)
  message(SEND_ERROR "${number_of_entries} entries in place of ${number_of_own_entries}:\n"
    "${bibliography}")
endif()
file(GLOB_RECURSE files "${package}/include/*.h" "${package}/doc/*.txt" "${package}/doc/*.h")
foreach(file IN LISTS files)
  file(READ "${file}" text)
  string(REGEX MATCHALL "\\\\cgal(Cite|PkgBib){[^}]*" citations "${text}")
  foreach(citation IN LISTS citations)
    string(REGEX REPLACE ".*{" "" key "${citation}")
    string(FIND "${bibliography}" "@misc{${key}," position)
    if(position EQUAL -1)
      message(SEND_ERROR "${file}: there is no ${key} in the bibliography")
    endif()
  endforeach()
endforeach()

# Who defines CGAL_LICENSE_ERROR is told of the license, in CGAL's tree and in ours.
set(include_options "-I${package}/include" "-I${tree}/Installation/include")
set(cgal_include_dir "")
if(EXISTS "${CGAL_DIR}/include/CGAL/config.h")
  set(cgal_include_dir -idirafter "${CGAL_DIR}/include")
endif()
foreach(options IN ITEMS "${include_options}" "-I${ROOT}/include")
  execute_process(COMMAND "${CXX_COMPILER}" -std=c++17 ${options} ${cgal_include_dir}
      -DCGAL_LICENSE_ERROR -E -x c++ -include CGAL/${name}/foundation/internal/compiled.h /dev/null
    ERROR_VARIABLE errors OUTPUT_QUIET)
  if(NOT errors MATCHES "package ${name} under the terms of the GPLv3")
    message(SEND_ERROR "CGAL_LICENSE_ERROR has no effect:\n${errors}")
  endif()
endforeach()

# the tests' macros
set(program "${OUTPUT}/check_catch")
run("${CXX_COMPILER}" -std=c++17 -Wall -Wextra -Werror "-I${package}/test/${name}"
  "${CMAKE_CURRENT_LIST_DIR}/check_catch.cpp" -o "${program}")
execute_process(COMMAND "${program}" OUTPUT_VARIABLE printed ERROR_QUIET RESULT_VARIABLE result)
string(REGEX REPLACE "FAILED fails[^\n]*\n" "" others "${printed}")
if(result EQUAL 0 OR others MATCHES "FAILED|passed fails|slow" OR
    NOT printed MATCHES "\n15 tests, 10 failed\n")
  message(SEND_ERROR "check_catch returned ${result} and printed\n${printed}")
endif()
execute_process(COMMAND "${program}" "no such test" RESULT_VARIABLE result OUTPUT_QUIET)
if(result EQUAL 0)
  message(SEND_ERROR "a run without a test passes")
endif()

# a program of each kind, as CGAL's test suite compiles and runs them. Include folders of packages are
# added by CGAL itself where it is a clone.
string(REPLACE ";" " " flags "${include_options}")
foreach(program IN LISTS PROGRAMS)
  string(REGEX MATCH "^([a-z]+):(.*)$" ignored "${program}")
  set(build "${OUTPUT}/build_${CMAKE_MATCH_1}")
  run("${CMAKE_COMMAND}" -S "${package}/${CMAKE_MATCH_1}/${name}" -B "${build}" -G "${GENERATOR}"
    "-DCGAL_DIR=${CGAL_DIR}" "-DCGAL_DATA_DIR=${DATA_DIR}" "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
    "-DCMAKE_CXX_FLAGS=${flags}" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O0
    -DBUILD_TESTING=ON -DCGAL_ENABLE_TESTING=ON)
  run("${CMAKE_CTEST_COMMAND}" --test-dir "${build}" --output-on-failure --no-tests=error
    -R "^execution.*of *_*${CMAKE_MATCH_2}$")
  message("${printed}")
  if(NOT printed MATCHES "execution[ _]+of[ _]+${CMAKE_MATCH_2} [ .]*Passed")
    message(SEND_ERROR "${program} was not run")
  endif()
endforeach()

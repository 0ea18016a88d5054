# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Checks what the manual repeats from the sources in ROOT and Doxygen cannot check.

cmake_minimum_required(VERSION 3.16)

set(doc "${ROOT}/doc/Restricted_laplacian_3")
set(examples "${ROOT}/examples/Restricted_laplacian_3")
file(GLOB pages "${doc}/*.txt")

# CMake wraps the text of its own errors.
set(number_of_errors 0)
macro(complain text)
  message("${text}")
  math(EXPR number_of_errors "${number_of_errors} + 1")
endmacro()

# require_same(what IN_MANUAL list IN_SOURCES list): the same elements
function(require_same what)
  cmake_parse_arguments(PARSE_ARGV 1 "" "" "" "IN_MANUAL;IN_SOURCES")
  if(NOT _IN_MANUAL OR NOT _IN_SOURCES)
    complain("found no ${what}; has their form changed?")
  endif()
  foreach(element IN LISTS _IN_SOURCES)
    if(NOT element IN_LIST _IN_MANUAL)
      complain("${what}: the manual does not know ${element}")
    endif()
  endforeach()
  foreach(element IN LISTS _IN_MANUAL)
    if(NOT element IN_LIST _IN_SOURCES)
      complain("${what}: the sources do not know ${element}")
    endif()
  endforeach()
  set(number_of_errors "${number_of_errors}" PARENT_SCOPE)
endfunction()

# all_matches(file pattern result): the first group of each match
function(all_matches file pattern result)
  file(READ "${file}" text)
  string(REGEX MATCHALL "${pattern}" matches "${text}")
  set(groups "")
  foreach(match IN LISTS matches)
    string(REGEX REPLACE "${pattern}" "\\1" group "${match}")
    list(APPEND groups "${group}")
  endforeach()
  list(REMOVE_DUPLICATES groups)
  set(${result} "${groups}" PARENT_SCOPE)
endfunction()

# rooms, and what each may use
all_matches("${ROOT}/test/Restricted_laplacian_3/project/rooms.txt"
  "\n([a-z]+: ?[a-z ]*)" in_sources)
list(FILTER in_sources EXCLUDE REGEX "^without_meshes")
all_matches("${doc}/Developer.txt" "\n\\| (`[a-z]+` \\|[a-z, ]*) \\|" rows)
string(REGEX REPLACE "`([a-z]+)` \\|" "\\1:" in_manual "${rows}")
string(REPLACE "," "" in_manual "${in_manual}")
string(REGEX REPLACE " +(;|$)" "\\1" in_manual "${in_manual}")
string(REGEX REPLACE " +(;|$)" "\\1" in_sources "${in_sources}")
require_same("rooms" IN_MANUAL ${in_manual} IN_SOURCES ${in_sources})

# example programs
all_matches("${doc}/examples.txt" "\\\\example Restricted_laplacian_3/([a-z0-9_]+\\.cpp)" in_manual)
file(GLOB in_sources RELATIVE "${examples}" "${examples}/*.cpp")
require_same("examples" IN_MANUAL ${in_manual} IN_SOURCES ${in_sources})

# pages and how they are reached
set(in_manual "")
file(GLOB files "${doc}/*.txt")
foreach(file IN LISTS files)
  all_matches("${file}" "\\\\page ([A-Za-z_]+)" found)
  list(APPEND in_manual ${found})
endforeach()
all_matches("${doc}/DoxygenLayout.xml" "url=\"@ref ([A-Za-z_]+)\"" in_navigation)
require_same("pages in DoxygenLayout.xml" IN_MANUAL ${in_navigation} IN_SOURCES ${in_manual})

# programs, what they print, and their --help
all_matches("${doc}/Programs.txt" "\\\\ref Restricted_laplacian_3/([a-z0-9_]+\\.cpp)" in_manual)
require_same("programs on the page about them" IN_MANUAL ${in_manual} IN_SOURCES ${in_sources})
set(in_outputs "")
foreach(source IN LISTS in_sources)
  string(REPLACE ".cpp" ".txt" output "${source}")
  list(APPEND in_outputs ${output})
  file(STRINGS "${examples}/${source}" includes REGEX "^#include \"support/command_line\\.h\"")
  if(includes)
    list(APPEND in_outputs help_${output})
  endif()
endforeach()
file(GLOB files RELATIVE "${doc}/outputs" "${doc}/outputs/*")
require_same("outputs of programs" IN_MANUAL ${files} IN_SOURCES ${in_outputs})
set(in_manual "")
foreach(page IN LISTS pages)
  all_matches("${page}" "\\\\verbinclude ([A-Za-z0-9_.]+)" found)
  list(APPEND in_manual ${found})
endforeach()
require_same("shown outputs" IN_MANUAL ${in_manual} IN_SOURCES ${files})

# named parameters; the manual also describes those of CGAL that the package uses
all_matches("${doc}/PackageDescription.txt" "\\\\cgalParamNBegin\\{([a-z_]+)\\}" in_manual)
all_matches("${ROOT}/include/CGAL/Restricted_laplacian_3/foundation/parameters.h"
  "\nCGAL_RESTRICTED_LAPLACIAN_3_PARAMETER\\(([a-z_]+)\\)" in_sources)
require_same("named parameters" IN_MANUAL ${in_manual}
  IN_SOURCES ${in_sources} vertex_point_map number_of_iterations vertex_is_constrained_map
  vertex_normal_map callback point_map normal_map)

# their defaults, as far as comments in the headers have the form "- `name`: ...; default value"
file(READ "${doc}/PackageDescription.txt" manual)
set(number_of_defaults 0)
foreach(header splines/Spline_space_3.h problems/make_poisson_solver.h solve_poisson.h
    laplace_spectrum.h)
  file(READ "${ROOT}/include/CGAL/Restricted_laplacian_3/${header}" text)
  string(REPLACE ";" "|" text "${text}") # no list separator
  set(pattern "/// - `([a-z_]+)`:[^`]*\\|[ \n/]*default `?([A-Za-z0-9._-]*[A-Za-z0-9])")
  string(REGEX MATCHALL "${pattern}" matches "${text}")
  foreach(match IN LISTS matches)
    string(REGEX MATCH "${pattern}" ignored "${match}")
    set(name "${CMAKE_MATCH_1}")
    set(value "${CMAKE_MATCH_2}")
    math(EXPR number_of_defaults "${number_of_defaults} + 1")
    string(FIND "${manual}" "\\cgalParamNBegin{${name}}" position)
    string(SUBSTRING "${manual}" ${position} -1 rest)
    string(REGEX MATCH "cgalParamDefault{`([A-Za-z0-9._-]+)" ignored "${rest}")
    if(NOT CMAKE_MATCH_1 STREQUAL value)
      complain("${header}: the default of ${name} is ${value}, in the manual ${CMAKE_MATCH_1}")
    endif()
  endforeach()
endforeach()
if(number_of_defaults LESS 6)
  complain("found only ${number_of_defaults} defaults of named parameters; has their form changed?")
endif()

# command line options that the manual names
set(in_sources "")
file(GLOB files "${examples}/*.cpp" "${examples}/support/*.h")
foreach(file IN LISTS files)
  all_matches("${file}" "add\\(\"([a-z-]+)\"" found)
  list(APPEND in_sources ${found})
endforeach()
set(in_manual "")
foreach(page IN LISTS pages)
  all_matches("${page}" "`--([a-z-]+)" found)
  list(APPEND in_manual ${found})
endforeach()
list(REMOVE_DUPLICATES in_manual)
if(NOT in_manual)
  complain("found no options; has their form changed?")
endif()
foreach(option IN LISTS in_manual)
  if(NOT option IN_LIST in_sources)
    complain("no example program has the option --${option}")
  endif()
endforeach()

# excerpts: Doxygen shows nothing, or too much, where a line that it looks for is gone
foreach(page IN LISTS pages)
  file(STRINGS "${page}" commands REGEX "^\\\\(dontinclude|skip|until) ")
  foreach(command IN LISTS commands)
    string(REGEX MATCH "^.([a-z]+) (.*)$" ignored "${command}")
    set(argument "${CMAKE_MATCH_2}")
    if(CMAKE_MATCH_1 STREQUAL "dontinclude")
      file(GLOB file "${ROOT}/examples/${argument}" "${ROOT}/scripts/${argument}")
      set(rest "")
      if(file)
        file(READ "${file}" rest)
      endif()
    else()
      string(FIND "${rest}" "${argument}" position)
      if(position EQUAL -1)
        complain("${page}: looks for '${argument}' in ${file}")
      else()
        string(LENGTH "${argument}" length)
        math(EXPR position "${position} + ${length}")
        string(SUBSTRING "${rest}" ${position} -1 rest)
      endif()
    endif()
  endforeach()
endforeach()

# Doxygen takes an asterisk at the beginning of a line for decoration of the comment.
foreach(page IN LISTS pages)
  file(STRINGS "${page}" lines REGEX "^[*][^/]")
  foreach(line IN LISTS lines)
    complain("${page}: a line must not begin with an asterisk: ${line}")
  endforeach()
endforeach()

if(number_of_errors GREATER 0)
  message(FATAL_ERROR "${number_of_errors} errors")
endif()

# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

set(programs_in_one_templates "${CMAKE_CURRENT_LIST_DIR}")

# add_programs_in_one(TARGET PROGRAM...) builds the programs of the current folder as one executable,
# in two translation units. There is a link to it for each program, and a target of that name.
function(add_programs_in_one target)
  set(dir "${CMAKE_CURRENT_BINARY_DIR}/${target}_sources")
  set(sources "")
  set(declarations "")
  set(entries "")
  foreach(program IN LISTS ARGN)
    set(source "${CMAKE_CURRENT_SOURCE_DIR}/${program}.cpp")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${source}")
    file(READ "${source}" text)
    # What comes before the first declaration: the headers must not end in a namespace.
    string(REGEX MATCH "^([/#][^\n]*\n|\n)*" preamble "${text}")
    set(arguments "")
    if(text MATCHES "int main\\(int argc")
      set(arguments "argc, argv")
    endif()
    configure_file("${programs_in_one_templates}/program.cpp.in" "${dir}/${program}.cpp" @ONLY)
    list(APPEND sources "${dir}/${program}.cpp")
    string(APPEND declarations "int call_${program}(int argc, char* argv[]);\n")
    string(APPEND entries "    {\"${program}\", call_${program}},\n")
  endforeach()
  configure_file("${programs_in_one_templates}/main.cpp.in" "${dir}/main.cpp" @ONLY)
  set_source_files_properties("${dir}/main.cpp" PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)

  add_executable(${target} "${dir}/main.cpp" ${sources})
  target_include_directories(${target} PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
  list(LENGTH sources number)
  math(EXPR half "(${number} + 1) / 2")
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${half})
  foreach(program IN LISTS ARGN)
    add_custom_command(TARGET ${target} POST_BUILD COMMAND ${CMAKE_COMMAND} -E create_symlink
      "$<TARGET_FILE_NAME:${target}>" "$<TARGET_FILE_DIR:${target}>/${program}")
    add_custom_target(${program} DEPENDS ${target})
  endforeach()
endfunction()

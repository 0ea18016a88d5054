# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Runs DOXYGEN on DOXYFILE, whose output goes to OUTPUT_DIR, and prints its warnings. With STRICT a
# warning is an error. Then copies from MATHJAX_DIR what formulas need, if it is given.

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

# For Doxygen, a concept is a class, and each of its models needs a title.
file(GLOB concepts "${CMAKE_CURRENT_LIST_DIR}/Concepts/*.h")
foreach(concept IN LISTS concepts)
  get_filename_component(name "${concept}" NAME_WE)
  string(REPLACE "_" "__" name "${name}")
  set(page "${OUTPUT_DIR}/html/class${name}.html")
  file(READ "${page}" text)
  string(REPLACE "Class Reference" "Concept Reference" text "${text}")
  set(title "<dt>Has Model</dt><dd>")
  set(two_models "(${title}[^\n]*)</dd></dl>\n<dl class=\"section user\">${title}")
  while(text MATCHES "${two_models}")
    string(REGEX REPLACE "${two_models}" "\\1<br />" text "${text}")
  endwhile()
  file(WRITE "${page}" "${text}")
endforeach()

# Figures have names in the sources, and numbers on their page.
file(GLOB pages "${OUTPUT_DIR}/html/*.html")
foreach(page IN LISTS pages)
  file(READ "${page}" text)
  string(REGEX MATCHALL "id=\"fig__[a-z_]+\"" figures "${text}")
  get_filename_component(file "${page}" NAME)
  set(number 0)
  foreach(figure IN LISTS figures)
    math(EXPR number "${number} + 1")
    string(REGEX REPLACE "id=\"fig__(.*)\"" "\\1" name "${figure}")
    set(link "href=\"${file}#fig__${name}\">")
    string(REPLACE "${link}${name}</a>" "${link}${number}</a>" text "${text}")
  endforeach()
  if(figures)
    file(WRITE "${page}" "${text}")
  endif()
  if(STRICT AND text MATCHES "#fig__[a-z_]+\">[a-z]")
    message(FATAL_ERROR "${file}: a figure without a number: ${CMAKE_MATCH_0}")
  endif()
endforeach()

# The tree beside the pages has no room for namespaces.
file(GLOB trees "${OUTPUT_DIR}/html/group__*.js")
foreach(tree IN LISTS trees)
  file(READ "${tree}" text)
  string(REPLACE "[ \"CGAL::Restricted_laplacian_3::" "[ \"" text "${text}")
  file(WRITE "${tree}" "${text}")
endforeach()

# Formulas are drawn as SVG: browsers load no fonts for a page that is opened as a file. That takes
# a tenth of MathJax.
if(MATHJAX_DIR)
  set(mathjax "${OUTPUT_DIR}/html/mathjax")
  foreach(part MathJax.js extensions/MathEvents.js extensions/MathMenu.js extensions/MathZoom.js
      extensions/tex2jax.js extensions/TeX jax/element jax/input/TeX jax/output/SVG/autoload
      jax/output/SVG/config.js jax/output/SVG/jax.js jax/output/SVG/fonts/TeX)
    get_filename_component(folder "${part}" DIRECTORY)
    file(COPY "${MATHJAX_DIR}/${part}" DESTINATION "${mathjax}/${folder}")
  endforeach()
  # Debian's text of its license
  if(EXISTS /usr/share/doc/libjs-mathjax/copyright)
    file(COPY /usr/share/doc/libjs-mathjax/copyright DESTINATION "${mathjax}")
  endif()
endif()

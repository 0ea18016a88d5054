# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# CPack runs this script on the installed files before it packs them. In a Debian package the
# documentation has a folder of the package's name, with the license and the changes in the form
# that Debian's policy asks for, and the manual uses Debian's MathJax. The package of the library
# depends on that of the headers, and needs only a link to its documentation.

if(NOT CPACK_GENERATOR STREQUAL "DEB")
  return()
endif()

set(temporary "${CPACK_TEMPORARY_DIRECTORY}")
set(package ${CPACK_DEBIAN_HEADERS_PACKAGE_NAME})
set(share "${temporary}/headers/usr/share")
set(doc "${share}/doc/${package}")
set(viewer "share/Restricted_laplacian_3/viewer.html")
file(RENAME "${share}/doc/Restricted_laplacian_3" "${doc}")

string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
set(contact "${CPACK_PACKAGE_CONTACT}")
if(NOT contact MATCHES "<.*>$")
  string(APPEND contact " <>") # the form of a changelog
endif()
set(version "${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}")

# add_documents(doc package [files of others]): license and changes
function(add_documents doc package)
  file(WRITE "${doc}/copyright"
"Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: Restricted_laplacian_3

Files: *
Copyright: 2026 ${CPACK_PACKAGE_VENDOR}
License: GPL-3.0+
 This package is free software: you can redistribute it and/or modify it under
 the terms of the GNU General Public License, version 3 of the License, or (at
 your option) any later version. It comes without any warranty.
 .
 On Debian systems the text of the GNU General Public License version 3 is in
 /usr/share/common-licenses/GPL-3.
${ARGN}")
  file(WRITE "${doc}/changelog.Debian"
"${package} (${version}) unstable; urgency=medium

  * Version ${CPACK_PACKAGE_VERSION}; its changes are in changelog.gz.

 -- ${contact}  ${date}
")
  execute_process(COMMAND gzip -9 -n changelog changelog.Debian WORKING_DIRECTORY "${doc}"
    COMMAND_ERROR_IS_FATAL ANY)
endfunction()

set(expat
"
License: Expat
 Permission is hereby granted, free of charge, to any person obtaining a copy of
 this software and associated documentation files (the \"Software\"), to deal in
 the Software without restriction, including without limitation the rights to
 use, copy, modify, merge, publish, distribute, sublicense, and/or sell copies of
 the Software, and to permit persons to whom the Software is furnished to do so,
 subject to the following conditions:
 .
 The above copyright notice and this permission notice shall be included in all
 copies or substantial portions of the Software.
 .
 THE SOFTWARE IS PROVIDED \"AS IS\", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
 IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY, FITNESS
 FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE AUTHORS OR
 COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER
 IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM, OUT OF OR IN
 CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE.
")
set(with_three_js
"Copyright: 2010-2025 three.js authors
           2026 ${CPACK_PACKAGE_VENDOR}
License: GPL-3.0+ and Expat
Comment: three.js, which is under the Expat license, is a part of the viewer.
")

# the headers, with the manual
file(REMOVE "${doc}/LICENSE")
file(RENAME "${doc}/CHANGELOG.md" "${doc}/changelog")
if(EXISTS "${doc}/html/mathjax/MathJax.js")
  file(REMOVE_RECURSE "${doc}/html/mathjax")
  file(CREATE_LINK ../../../javascript/mathjax "${doc}/html/mathjax" SYMBOLIC)
endif()
set(others "")
if(IS_DIRECTORY "${doc}/html")
  set(others
"
Files: usr/share/doc/*/html/*.js
Copyright: 1997-2020 Dimitri van Heesch
           OpenJS Foundation and other contributors
           jQuery Foundation and other contributors
           Steven Benner
           Vasil Dinkov, Vadikom Web Ltd.
License: Expat
Comment: Doxygen adds these files to the pages that it makes.

Files: usr/share/doc/*/html/gallery/*
${with_three_js}${expat}")
endif()
set(changes "${temporary}/changelog")
configure_file("${doc}/changelog" "${changes}" COPYONLY)
add_documents("${doc}" ${package} "${others}")
file(WRITE "${share}/lintian/overrides/${package}"
"# CGAL's interval arithmetic needs this option of GCC.
${package}: pkg-config-bad-directive -frounding-math *
")

# the library, which depends on the headers
set(usr "${temporary}/compiled/usr")
if(IS_DIRECTORY "${usr}")
  file(MAKE_DIRECTORY "${usr}/share/doc")
  file(CREATE_LINK ${package} "${usr}/share/doc/${CPACK_DEBIAN_COMPILED_PACKAGE_NAME}" SYMBOLIC)
endif()

# the programs
set(usr "${temporary}/programs/usr")
if(IS_DIRECTORY "${usr}")
  set(doc "${usr}/share/doc/${CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME}")
  file(MAKE_DIRECTORY "${doc}")
  configure_file("${changes}" "${doc}/changelog" COPYONLY)
  set(others "")
  if(EXISTS "${usr}/${viewer}")
    set(others "
Files: usr/${viewer}
${with_three_js}${expat}")
  endif()
  add_documents("${doc}" ${CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME} "${others}")
endif()
file(REMOVE "${changes}")

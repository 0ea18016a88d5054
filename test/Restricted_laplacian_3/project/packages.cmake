# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Makes all packages of the project ROOT, which is built in BUILD_DIR, and unpacks them into
# OUTPUT_DIR/deb (those of Debian), OUTPUT_DIR/archive and OUTPUT_DIR/source. The first two must hold what
# is installed in PREFIX, those of Debian without the programs for several machines, and the last one what
# belongs to the sources. If there is a LIBRARY, its package is for ARCHITECTURE, as that of the programs,
# and DEPENDS is what it depends on besides the headers. Without DPKG_DEB the Debian packages are only
# made; with LINTIAN they must have no error.

cmake_minimum_required(VERSION 3.19)

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output
    ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "failed: ${ARGN}\n${output}")
  endif()
endfunction()

# contents(dir result): `path hash` of each file, without links that lead outside
function(contents dir result)
  file(GLOB_RECURSE files RELATIVE "${dir}" "${dir}/*")
  list(FILTER files EXCLUDE REGEX "^\\.git/")
  set(lines "")
  foreach(file IN LISTS files)
    if(EXISTS "${dir}/${file}")
      file(SHA1 "${dir}/${file}" hash)
      list(APPEND lines "${file} ${hash}")
    endif()
  endforeach()
  set(${result} "${lines}" PARENT_SCOPE)
endfunction()

function(require_same what expected found)
  set(missing "${expected}")
  list(REMOVE_ITEM missing ${found})
  set(superfluous "${found}")
  list(REMOVE_ITEM superfluous ${expected})
  foreach(line IN LISTS missing)
    message(SEND_ERROR "${what} lacks ${line}")
  endforeach()
  foreach(line IN LISTS superfluous)
    message(SEND_ERROR "${what} should not hold ${line}")
  endforeach()
endfunction()

# The version
file(STRINGS "${ROOT}/CHANGELOG.md" sections REGEX "^## ")
list(GET sections 0 section)
string(REPLACE "." "\\." pattern "${VERSION}")
if(NOT section MATCHES "^## ${pattern}($|[^.0-9])")
  message(SEND_ERROR "CHANGELOG.md begins with '${section}', not with version ${VERSION}")
endif()

# All packages
file(REMOVE_RECURSE "${OUTPUT_DIR}")
set(ENV{DEBFULLNAME} "Ada Lovelace")
set(ENV{DEBEMAIL} "ada@debian.org")
foreach(config IN ITEMS CPackConfig.cmake CPackSourceConfig.cmake)
  run("${CPACK}" --config "${BUILD_DIR}/${config}" -B "${OUTPUT_DIR}/packages")
endforeach()
contents("${PREFIX}" installed)
if(NOT installed MATCHES "include/CGAL/Restricted_laplacian_3/solve_poisson\\.h")
  message(FATAL_ERROR "nothing was installed")
endif()

# The archive
set(name "Restricted_laplacian_3-${VERSION}")
include("${BUILD_DIR}/CPackConfig.cmake")
file(ARCHIVE_EXTRACT INPUT "${OUTPUT_DIR}/packages/${CPACK_PACKAGE_FILE_NAME}.tar.gz"
  DESTINATION "${OUTPUT_DIR}/archive")
contents("${OUTPUT_DIR}/archive/${CPACK_PACKAGE_FILE_NAME}" found)
require_same("the archive" "${installed}" "${found}")
list(FILTER installed EXCLUDE REGEX "^bin/[a-z_]+_mpi ")

# The sources: where Git knows better than this test what belongs to them, all of that
file(ARCHIVE_EXTRACT INPUT "${OUTPUT_DIR}/packages/${name}-source.tar.gz"
  DESTINATION "${OUTPUT_DIR}/source")
file(GLOB_RECURSE found RELATIVE "${OUTPUT_DIR}/source/${name}-source"
  "${OUTPUT_DIR}/source/${name}-source/*")
set(expected "")
if(GIT AND EXISTS "${ROOT}/.git")
  execute_process(COMMAND "${GIT}" -C "${ROOT}" ls-files --cached --others --exclude-standard
    OUTPUT_VARIABLE files RESULT_VARIABLE result)
  if(result EQUAL 0)
    string(REGEX REPLACE "\n" ";" files "${files}")
    foreach(file IN LISTS files)
      if(file AND EXISTS "${ROOT}/${file}")
        list(APPEND expected "${file}")
      endif()
    endforeach()
  endif()
endif()
if(expected)
  require_same("the archive of sources" "${expected}" "${found}")
else()
  foreach(file IN ITEMS CMakeLists.txt LICENSE scripts/test.sh .clang-format)
    if(NOT file IN_LIST found)
      message(SEND_ERROR "the archive of sources lacks ${file}")
    endif()
  endforeach()
  if(found MATCHES "CMakeCache\\.txt|\\.git/")
    message(SEND_ERROR "the archive of sources holds a build folder or .git")
  endif()
endif()

# The Debian packages
set(package libcgal-restricted-laplacian-3-dev)
set(deb "${OUTPUT_DIR}/packages/${package}_${VERSION}-1_all.deb")
set(debs "${deb}")
if(LIBRARY)
  set(compiled_package libcgal-restricted-laplacian-3-compiled-dev)
  set(compiled_deb "${OUTPUT_DIR}/packages/${compiled_package}_${VERSION}-1_${ARCHITECTURE}.deb")
  list(APPEND debs "${compiled_deb}")
endif()
set(programs_package restricted-laplacian-3)
set(programs_deb "")
if("programs" IN_LIST CPACK_COMPONENTS_ALL)
  set(programs_deb "${OUTPUT_DIR}/packages/${programs_package}_${VERSION}-1_${ARCHITECTURE}.deb")
  list(APPEND debs "${programs_deb}")
endif()
foreach(file IN LISTS debs)
  if(NOT EXISTS "${file}")
    message(FATAL_ERROR "there is no ${file}")
  endif()
endforeach()
if(NOT DPKG_DEB)
  return()
endif()

# The manual has a link to Debian's MathJax in place of a copy.
run("${DPKG_DEB}" -x "${deb}" "${OUTPUT_DIR}/deb")
contents("${OUTPUT_DIR}/deb/usr" found)
set(doc "share/doc/${package}")
list(TRANSFORM installed REPLACE "^share/doc/Restricted_laplacian_3/" "${doc}/")
list(FILTER installed EXCLUDE REGEX "/(LICENSE|CHANGELOG\\.md) |/html/mathjax/")
set(of_debian "^(${doc}/(copyright|changelog\\.gz|changelog\\.Debian\\.gz)|share/lintian/.*) ")
set(additional "${found}")
list(FILTER additional INCLUDE REGEX "${of_debian}")
list(LENGTH additional number)
if(NOT number EQUAL 4)
  message(SEND_ERROR "the Debian package holds, of Debian's own files, only ${additional}")
endif()
list(FILTER found EXCLUDE REGEX "${of_debian}|/html/mathjax/")

# Programs, which have lost their symbols, and the viewer are in their package and nowhere else.
set(of_programs "^(bin|share/Restricted_laplacian_3)/")
set(expected "${installed}")
list(FILTER expected INCLUDE REGEX "${of_programs}")
list(FILTER installed EXCLUDE REGEX "${of_programs}")
if(programs_deb)
  run("${DPKG_DEB}" -x "${programs_deb}" "${OUTPUT_DIR}/programs_deb")
  contents("${OUTPUT_DIR}/programs_deb/usr" found_of_programs)
  list(TRANSFORM expected REPLACE "^(bin/.*) [0-9a-f]+$" "\\1")
  list(TRANSFORM found_of_programs REPLACE "^(bin/.*) [0-9a-f]+$" "\\1")
  foreach(document IN ITEMS copyright changelog.gz changelog.Debian.gz)
    if(NOT found_of_programs MATCHES "share/doc/${programs_package}/${document} ")
      message(SEND_ERROR "the Debian package of the programs lacks ${document}")
    endif()
  endforeach()
  list(FILTER found_of_programs EXCLUDE REGEX "^share/doc/")
  require_same("the Debian package of the programs" "${expected}" "${found_of_programs}")
  run("${OUTPUT_DIR}/programs_deb/usr/bin/solve_poisson" --version)
endif()

# What depends on the processor is in the package of the library and nowhere else.
if(LIBRARY)
  set(of_library "(\\.a|\\.so|\\.so\\.[0-9.]+|/[^/]*_compiled[^/]*\\.(cmake|pc)) ")
  set(expected "${installed}")
  list(FILTER expected INCLUDE REGEX "${of_library}")
  list(FILTER installed EXCLUDE REGEX "${of_library}")
  run("${DPKG_DEB}" -x "${compiled_deb}" "${OUTPUT_DIR}/compiled_deb")
  contents("${OUTPUT_DIR}/compiled_deb/usr" found_of_library)
  require_same("the Debian package of the library" "${expected}" "${found_of_library}")
  run("${DPKG_DEB}" -x "${compiled_deb}" "${OUTPUT_DIR}/deb")
  if(NOT EXISTS "${OUTPUT_DIR}/deb/usr/share/doc/${compiled_package}/copyright")
    message(SEND_ERROR "the Debian package of the library has no documentation")
  endif()
endif()
require_same("the Debian package" "${installed}" "${found}")

# require_fields(deb [NAME=value]...)
function(require_fields deb)
  foreach(field IN LISTS ARGN ITEMS "Version=${VERSION}-1"
      "Maintainer=Ada Lovelace <ada@debian.org>")
    string(REGEX MATCH "^([A-Za-z]+)=(.*)$" ignored "${field}")
    set(expected "${CMAKE_MATCH_2}")
    execute_process(COMMAND "${DPKG_DEB}" --field "${deb}" "${CMAKE_MATCH_1}"
      OUTPUT_VARIABLE value OUTPUT_STRIP_TRAILING_WHITESPACE)
    if(NOT value STREQUAL expected)
      message(SEND_ERROR "${CMAKE_MATCH_1} of ${deb} is '${value}', not '${expected}'")
    endif()
  endforeach()
endfunction()

require_fields("${deb}"
  "Package=${package}"
  "Section=libdevel"
  "Architecture=all"
  "Depends=libcgal-dev (>= 5.5), libeigen3-dev (>= 3.4)")
execute_process(COMMAND "${DPKG_DEB}" --field "${deb}" Recommends OUTPUT_VARIABLE value)
if(NOT value MATCHES "^libsuitesparse-dev, libopenblas-dev, libspectra-dev, libtbb-dev")
  message(SEND_ERROR "the Debian package recommends '${value}'")
endif()
if(LIBRARY)
  require_fields("${compiled_deb}"
    "Package=${compiled_package}"
    "Section=libdevel"
    "Architecture=${ARCHITECTURE}"
    "Depends=${package} (= ${VERSION}-1)${DEPENDS}"
    "Recommends=libopenblas-dev")
endif()

if(programs_deb)
  require_fields("${programs_deb}"
    "Package=${programs_package}"
    "Section=math"
    "Architecture=${ARCHITECTURE}")
endif()

if(LINTIAN)
  run("${LINTIAN}" --allow-root --fail-on error ${debs})
endif()

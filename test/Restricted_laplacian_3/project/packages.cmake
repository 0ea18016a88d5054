# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Configures the project ROOT in BUILD_DIR with OPTIONS, makes all packages, and unpacks them into
# BUILD_DIR/deb, BUILD_DIR/archive and BUILD_DIR/source. The first two must hold what is installed
# into BUILD_DIR/prefix, and the last one what belongs to the sources. Without DPKG_DEB the Debian
# package is only made; with LINTIAN it must have no error.

cmake_minimum_required(VERSION 3.19)

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output
    ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "failed: ${ARGN}\n${output}")
  endif()
endfunction()

# contents(dir result): `path hash` of each file
function(contents dir result)
  file(GLOB_RECURSE files RELATIVE "${dir}" "${dir}/*")
  list(FILTER files EXCLUDE REGEX "^\\.git/")
  set(lines "")
  foreach(file IN LISTS files)
    file(SHA1 "${dir}/${file}" hash)
    list(APPEND lines "${file} ${hash}")
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
file(REMOVE_RECURSE "${BUILD_DIR}")
set(ENV{DEBFULLNAME} "Ada Lovelace")
set(ENV{DEBEMAIL} "ada@debian.org")
run("${CMAKE_COMMAND}" -S "${ROOT}" -B "${BUILD_DIR}" ${OPTIONS}
  -DRESTRICTED_LAPLACIAN_3_BUILD_TESTS=OFF -DRESTRICTED_LAPLACIAN_3_BUILD_EXAMPLES=OFF
  -DRESTRICTED_LAPLACIAN_3_BUILD_DOC=OFF)
run("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${BUILD_DIR}/prefix")
foreach(config IN ITEMS CPackConfig.cmake CPackSourceConfig.cmake)
  run("${CPACK}" --config "${BUILD_DIR}/${config}" -B "${BUILD_DIR}/packages")
endforeach()
set(name "Restricted_laplacian_3-${VERSION}")
contents("${BUILD_DIR}/prefix" installed)
if(NOT installed MATCHES "include/CGAL/Restricted_laplacian_3/solve_poisson\\.h")
  message(FATAL_ERROR "nothing was installed")
endif()

# The archive
file(ARCHIVE_EXTRACT INPUT "${BUILD_DIR}/packages/${name}-noarch.tar.gz"
  DESTINATION "${BUILD_DIR}/archive")
contents("${BUILD_DIR}/archive/${name}-noarch" found)
require_same("the archive" "${installed}" "${found}")

# The sources: where Git knows better than this test what belongs to them, all of that
file(ARCHIVE_EXTRACT INPUT "${BUILD_DIR}/packages/${name}-source.tar.gz"
  DESTINATION "${BUILD_DIR}/source")
file(GLOB_RECURSE found RELATIVE "${BUILD_DIR}/source/${name}-source"
  "${BUILD_DIR}/source/${name}-source/*")
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

# The Debian package
set(package libcgal-restricted-laplacian-3-dev)
set(deb "${BUILD_DIR}/packages/${package}_${VERSION}-1_all.deb")
if(NOT EXISTS "${deb}")
  message(FATAL_ERROR "there is no ${deb}")
endif()
if(NOT DPKG_DEB)
  return()
endif()
run("${DPKG_DEB}" -x "${deb}" "${BUILD_DIR}/deb")
contents("${BUILD_DIR}/deb/usr" found)
set(doc "share/doc/${package}")
list(TRANSFORM installed REPLACE "^share/doc/Restricted_laplacian_3/" "${doc}/")
list(FILTER installed EXCLUDE REGEX "/(LICENSE|CHANGELOG\\.md) ")
set(of_debian "^(${doc}/(copyright|changelog\\.gz|changelog\\.Debian\\.gz)|share/lintian/.*) ")
set(additional "${found}")
list(FILTER additional INCLUDE REGEX "${of_debian}")
list(LENGTH additional number)
if(NOT number EQUAL 4)
  message(SEND_ERROR "the Debian package holds, of Debian's own files, only ${additional}")
endif()
list(FILTER found EXCLUDE REGEX "${of_debian}")
require_same("the Debian package" "${installed}" "${found}")

foreach(field IN ITEMS
    "Package=${package}"
    "Version=${VERSION}-1"
    "Architecture=all"
    "Section=libdevel"
    "Maintainer=Ada Lovelace <ada@debian.org>"
    "Depends=libcgal-dev (>= 5.5), libeigen3-dev (>= 3.4)"
    "Recommends=libsuitesparse-dev, libopenblas-dev, libspectra-dev, libtbb-dev")
  string(REGEX MATCH "^([A-Za-z]+)=(.*)$" ignored "${field}")
  set(expected "${CMAKE_MATCH_2}")
  execute_process(COMMAND "${DPKG_DEB}" --field "${deb}" "${CMAKE_MATCH_1}"
    OUTPUT_VARIABLE value OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT value STREQUAL expected)
    message(SEND_ERROR "${CMAKE_MATCH_1} of the Debian package is '${value}', not '${expected}'")
  endif()
endforeach()

if(LINTIAN)
  run("${LINTIAN}" --allow-root --fail-on error "${deb}")
endif()

#!/usr/bin/env bash
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Usage: scripts/test_versions.sh
#
# Tests the package with compilers and libraries that are newer than those of scripts/test.sh: installs
# what is missing; builds library, unit tests, examples and tools in build/versions/ with warnings as
# errors, and without what CGAL keeps for old code; runs the unit tests that are not marked [slow], one
# program on a mesh, and the tests of the package as a part of that CGAL and installed; and compares
# package_info/Restricted_laplacian_3/dependencies with what the headers include. The last line names the
# versions and counts the tests; the exit status is 0 if all went well. CGAL_DIR in the environment is the
# folder of the CGALConfig.cmake of another CGAL than that of the system, and JOBS the number of parallel
# jobs, 2 if not set.

set -euo pipefail
export LC_ALL=C

cd "$(dirname "${BASH_SOURCE[0]}")/.."
name=Restricted_laplacian_3
build=$PWD/build/versions
output=$build/output.txt
mkdir -p "$build"
failed=

# step TEXT COMMAND...: what fails does not keep the next from being tried
step() {
  echo "=== $1"
  "${@:2}" || failed+=" $1;"
}

# cached NAME: what CMake has found
cached() {
  sed -n "s/^$1:[A-Z]*=//p" "$build/CMakeCache.txt"
}

# Which headers of CGAL belong to which package says a line in each of them.
check_dependencies() {
  local found
  found=$("$(cached CMAKE_CXX_COMPILER)" -std=c++17 -DCGAL_USE_GMPXX=1 -M -Iinclude ${include:+"-isystem$include"} \
    -isystem /usr/include/eigen3 include/CGAL/$name.h |
    tr ' ' '\n' | grep '/include/CGAL/' | grep -v "$name" | sort -u |
    xargs sed -n 's|.*[$]URL: .*/blob/[^/]*/\([^/]*\)/include/.*|\1|p')
  diff <(printf '%s\n' "$found" $name | sort -u) package_info/$name/dependencies
}

unit_tests() {
  OPENBLAS_NUM_THREADS=1 "$build/test/$name/test_restricted_laplacian_3" "~[slow]" >"$output" ||
    { cat "$output"; return 1; }
}

# It has to say what it says with the CGAL of Debian 12, as the manual shows.
program() {
  local folder=$build/data/meshes
  [[ -d $folder ]] || { echo "there are no meshes of CGAL"; return 1; }
  (cd "$folder" && "$build/examples/$name/minimal_poisson" elephant.off) >"$build/program.txt"
  diff <(tail -n 1 "$build/program.txt") <(tail -n 1 doc/$name/outputs/minimal_poisson.txt)
}

bash scripts/install_dependencies.sh
cmake -S . -B "$build" -DCMAKE_BUILD_TYPE=Release -DRESTRICTED_LAPLACIAN_3_BUILD_TESTS=ON \
  -DRESTRICTED_LAPLACIAN_3_PROGRAM_OPTIONS=-O1 -DCMAKE_CXX_FLAGS=-DCGAL_NO_DEPRECATED_CODE \
  -DRESTRICTED_LAPLACIAN_3_WARNINGS_AS_ERRORS=ON -DRESTRICTED_LAPLACIAN_3_BUILD_DOC=OFF
cgal=$(cached CGAL_DIR)
include= # of a CGAL that is not in the compiler's own folders
[[ ! -d $cgal/include/CGAL ]] || include=$cgal/include
step "compilation of library and unit tests" \
  cmake --build "$build" --parallel "${JOBS:-2}" --target test_restricted_laplacian_3
step "unit tests" unit_tests
step "compilation of all else" cmake --build "$build" --parallel "${JOBS:-2}"
step "dependencies" check_dependencies
step "program" program
step "the package in CGAL's tree, and installed" ctest --test-dir "$build" --output-on-failure \
  --no-tests=error -R '^(consumer:.*|cgal_tree:.*)$'

version=$(printf '#include <CGAL/version.h>\n#include <Eigen/Core>\n#include <boost/version.hpp>
CGAL_VERSION EIGEN_WORLD_VERSION EIGEN_MAJOR_VERSION EIGEN_MINOR_VERSION EIGEN_PATCH_VERSION BOOST_LIB_VERSION' |
  "$(cached CMAKE_CXX_COMPILER)" -E -P -x c++ ${include:+"-isystem$include"} -isystem /usr/include/eigen3 - | tail -n 1)
read -r version_of_cgal world major minor patch boost <<<"$version"
eigen=$world.$major.$minor
((major < 5)) || eigen=$major.$minor.$patch # whose first number is still 3
boost=${boost//\"/}
summary="CGAL $version_of_cgal, Eigen $eigen, Boost ${boost/_/.}, GCC $("$(cached CMAKE_CXX_COMPILER)" -dumpfullversion),"
summary+=" CMake $(cmake --version | sed -n 's/^cmake version //p');"
summary+=" $(sed -n 's/^All tests passed (\(.*\))$/\1/p' "$output"),"
summary+=" $(grep -c 'SKIPPED: ' "$output" || true) of them skipped"
if [[ -n $failed ]]; then
  echo "FAILED:$failed $summary"
  exit 1
fi
echo "$summary"

#!/usr/bin/env bash
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Usage: scripts/test_cgal_6.sh CGAL_DIR
#
# Tests the package with another CGAL than that of the system: CGAL_DIR is the folder of its
# CGALConfig.cmake, for example unpacked sources of CGAL 6. Builds library, unit tests, examples and
# tools in build/cgal_6/ with warnings as errors; runs the unit tests that are not marked [slow], one
# program on a mesh, and the tests of the package as a part of that CGAL; and compares
# package_info/Restricted_laplacian_3/dependencies with what the headers include. What was tested, and
# the result, goes to test/Restricted_laplacian_3/project/cgal_6_log.txt; the exit status is 0 if all
# went well. JOBS in the environment is the number of parallel jobs, 2 if not set.

set -euo pipefail
export LC_ALL=C

if (($# != 1)) || [[ ! -f $1/CGALConfig.cmake ]]; then
  echo "Usage: scripts/test_cgal_6.sh CGAL_DIR, a folder with CGALConfig.cmake" >&2
  exit 2
fi
cgal=$(cd "$1" && pwd)
cd "$(dirname "${BASH_SOURCE[0]}")/.."
name=Restricted_laplacian_3
build=$PWD/build/cgal_6
log=test/$name/project/cgal_6_log.txt
output=$build/output.txt
mkdir -p "$build"
commit=$(git describe --always --dirty --exclude='*' 2>/dev/null || echo unknown)

failed=0
details= # for the line of the log that comes next

# report TEXT COMMAND...: runs the command, and a line of the log says how it ended. What cannot be
# compiled is the end.
report() {
  local text=$1 result=passed
  echo "=== $text"
  "${@:2}" || result=FAILED
  echo "$result: $text$details" >>"$log"
  details=
  if [[ $result == FAILED ]]; then
    failed=1
    [[ $text != configuration && $text != compilation* ]] || exit 1
  fi
}

# Which headers of the named CGAL belong to which package says a line in each of them.
check_dependencies() {
  local found
  found=$("${CXX:-c++}" -std=c++17 -DCGAL_USE_GMPXX=1 -M -Iinclude "-isystem$cgal/include" \
    -isystem /usr/include/eigen3 include/CGAL/$name.h |
    tr ' ' '\n' | grep "^$cgal/include/CGAL/" | sort -u |
    xargs sed -n 's|.*[$]URL: .*/blob/[^/]*/\([^/]*\)/include/.*|\1|p')
  diff <(printf '%s\n' "$found" $name | sort -u) package_info/$name/dependencies
}

unit_tests() {
  OPENBLAS_NUM_THREADS=1 "$build/test/$name/test_restricted_laplacian_3" "~[slow]" >"$output" ||
    { cat "$output"; return 1; }
  details=", $(sed -n 's/^All tests passed (\(.*\))$/\1/p' "$output")"
  details+=", $(grep -c 'SKIPPED: ' "$output" || true) of them skipped"
}

# It has to say what it says with the CGAL of the system, as the manual shows.
program() {
  local folder=$build/data/meshes
  [[ -d $folder ]] || { echo "there are no meshes of CGAL"; return 1; }
  (cd "$folder" && "$build/examples/$name/minimal_poisson" elephant.off) >"$output"
  diff <(tail -n 1 "$output") <(tail -n 1 doc/$name/outputs/minimal_poisson.txt)
}

version=$(sed -n 's/^#define CGAL_VERSION \(.*\)/\1/p' "$cgal/include/CGAL/version.h")
cat >"$log" <<END
# command: scripts/test_cgal_6.sh CGAL_DIR
# commit: $commit
# CGAL: $version
END
report "configuration" cmake -S . -B "$build" "-DCGAL_DIR=$cgal" -DCMAKE_BUILD_TYPE=Release \
  -DRESTRICTED_LAPLACIAN_3_PROGRAM_OPTIONS=-O1 -DRESTRICTED_LAPLACIAN_3_WARNINGS_AS_ERRORS=ON \
  -DRESTRICTED_LAPLACIAN_3_BUILD_DOC=OFF "-DRESTRICTED_LAPLACIAN_3_CGAL_6_DIR=$cgal"
compiler=$(sed -n 's/^CMAKE_CXX_COMPILER:[A-Z]*=//p' "$build/CMakeCache.txt")
echo "# compiler: $("$compiler" --version | head -n 1)" >>"$log"
report "headers include what package_info says" check_dependencies
report "compilation of library and unit tests" \
  cmake --build "$build" --parallel "${JOBS:-2}" --target test_restricted_laplacian_3
report "unit tests but the slow ones" unit_tests
report "the package in CGAL's tree, and installed" ctest --test-dir "$build" --output-on-failure \
  --no-tests=error -R '^(consumer:install|consumer:cgal_6|cgal_tree:6)$'
report "compilation of all programs" cmake --build "$build" --parallel "${JOBS:-2}"
report "minimal_poisson prints what it prints in the manual" program

if ((failed)); then
  echo "FAILED" >>"$log"
else
  echo "all passed" >>"$log"
fi
cat "$log"
exit "$failed"

#!/usr/bin/env bash
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Usage: scripts/test.sh
#
# Installs what is missing, builds examples and tests in build/ with warnings as errors, runs the
# tests, which build and check the manual, too, then builds the unit tests in build/sanitizers/ with
# AddressSanitizer and UndefinedBehaviorSanitizer, runs them, and compiles each header alone. The last
# line counts both runs together. JOBS in the environment is the number of parallel jobs, 2 if not
# set.

set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
jobs=${JOBS:-2}
passed=0 failed=0 skipped=0 status=0

# count FILE PATTERN
count() {
  grep --count "$2" "$1" || true
}

# run_tests BUILD_FOLDER [OPTION OF CTEST]...
run_tests() {
  local results="$PWD/$1/results.xml" all ok ignored
  rm -f "$results"
  ctest --test-dir "$1" --parallel "$jobs" --output-on-failure --no-tests=error \
    --output-junit "$results" "${@:2}" || status=1
  # What could not be started is neither.
  all=$(count "$results" '<testcase ')
  ok=$(count "$results" '<testcase .* status="run"')
  ignored=$(count "$results" '<skipped message="SKIP_')
  passed=$((passed + ok))
  skipped=$((skipped + ignored))
  failed=$((failed + all - ok - ignored))
}

bash scripts/install_dependencies.sh

cmake -S . -B build -DCMAKE_BUILD_TYPE=Release -DRESTRICTED_LAPLACIAN_3_WARNINGS_AS_ERRORS=ON \
  -DRESTRICTED_LAPLACIAN_3_BUILD_TESTS=ON -DRESTRICTED_LAPLACIAN_3_BUILD_EXAMPLES=ON \
  -DRESTRICTED_LAPLACIAN_3_BUILD_DOC=ON
cmake --build build --parallel "$jobs"
run_tests build --label-exclude '^headers$'

# Clang compiles the checks faster than GCC and in half the memory, and its warnings are others.
# Debug stands for the assertions of Eigen and CGAL, -g1 for line numbers in reports.
cmake -S . -B build/sanitizers -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=Debug \
  -DCMAKE_CXX_FLAGS_DEBUG="-O1 -g1" -DRESTRICTED_LAPLACIAN_3_SANITIZE=address,undefined \
  -DRESTRICTED_LAPLACIAN_3_WARNINGS_AS_ERRORS=ON -DCGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE=ON \
  -DRESTRICTED_LAPLACIAN_3_BUILD_TESTS=ON -DRESTRICTED_LAPLACIAN_3_BUILD_EXAMPLES=OFF \
  -DRESTRICTED_LAPLACIAN_3_BUILD_DOC=OFF
cmake --build build/sanitizers --parallel "$jobs" --target test_restricted_laplacian_3
ASAN_OPTIONS=detect_leaks=1:halt_on_error=1 UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1 \
  run_tests build/sanitizers --label-regex '^(unit|headers)$'

echo "$passed passed, $failed failed, $skipped skipped"
exit "$status"

#!/usr/bin/env bash
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Usage: scripts/test.sh
#
# What a change must pass. Installs what is missing; builds with warnings as errors, in build/ the
# library, tests and examples, and in build/sanitizers/ the benchmarks, and with AddressSanitizer and
# UndefinedBehaviorSanitizer the library and tests of what touches raw memory, input or threads; and runs
# the tests, which build and check the manual, too. Where ccache is installed, it answers for what has
# been compiled before. Prints how long each stage took, what took longest, and what was compiled with
# too much memory, which counts as a failure: more than 1.5 GB, or 2.6 GB for tests, benchmarks and
# headers only. (CCACHE_RECACHE=1 in the environment compiles all of it again: what the cache has
# answered for in every run of this folder has not been measured.) The last line counts all tests. JOBS in
# the environment is the number of parallel jobs, 2 if not set.

set -euo pipefail
export LC_ALL=C

cd "$(dirname "${BASH_SOURCE[0]}")/.."
jobs=${JOBS:-2}
compilations=$PWD/build/compilations.txt
results=$PWD/build/results.xml
stages=()

# stage NAME COMMAND...: how long the command takes, on the wall and of all processors
stage() {
  local name=$1 start=$SECONDS before
  read_cpu_seconds
  before=$cpu_seconds
  echo "=== $name"
  "${@:2}"
  read_cpu_seconds
  stages+=("$(printf '%-13s %5d s, %5d s of processors' "$name" $((SECONDS - start)) \
    $((cpu_seconds - before)))")
}

# read_cpu_seconds: of all commands until now, into a variable: a subshell would tell its own
read_cpu_seconds() {
  times >build/times.txt
  cpu_seconds=$(awk -F'[ms ]' 'NR == 2 { printf "%d", 60 * ($1 + $4) + $2 + $5 }' build/times.txt)
}

# configure FOLDER OPTION...
configure() {
  cmake -S . -B "$1" -G "Unix Makefiles" -DRESTRICTED_LAPLACIAN_3_WARNINGS_AS_ERRORS=ON \
    -DRESTRICTED_LAPLACIAN_3_BUILD_TESTS=ON "-DCMAKE_CXX_COMPILER_LAUNCHER=$launcher" "${@:2}"
}

# What the Python package is built and tested with, in an environment of its own. Where PyPI cannot be
# reached, that package is left out.
make_python_environment() {
  local environment=$PWD/build/python_environment
  if { [[ -x $environment/bin/python ]] || python3 -m venv "$environment"; } &&
    "$environment/bin/python" -m pip install --quiet --disable-pip-version-check --retries 1 \
      --requirement python/requirements.txt; then
    python_options=(-DRESTRICTED_LAPLACIAN_3_BUILD_PYTHON=ON
      "-DPython_EXECUTABLE=$environment/bin/python")
  else
    echo "SKIPPED: the Python package is not tested, python/requirements.txt could not be installed" >&2
    python_options=(-DRESTRICTED_LAPLACIAN_3_BUILD_PYTHON=OFF)
  fi
}

# The library at the speed that users have; in programs little is left to optimize. (Without any
# optimization they compile in a fifth less, and their tests run five times as long.)
configure_all() {
  configure build -DCMAKE_BUILD_TYPE=Release -DRESTRICTED_LAPLACIAN_3_PROGRAM_OPTIONS=-O1 \
    -DRESTRICTED_LAPLACIAN_3_BUILD_EXAMPLES=ON -DRESTRICTED_LAPLACIAN_3_BUILD_DOC=ON \
    "${python_options[@]}"
  # Clang compiles the checks faster than GCC and in half the memory, and its warnings are others.
  # Debug stands for the assertions of Eigen and CGAL, -g1 for line numbers in reports. It compiles
  # the benchmarks, too.
  configure build/sanitizers -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=Debug \
    -DCMAKE_CXX_FLAGS_DEBUG="-O1 -g1 -ffile-prefix-map=$PWD=." \
    -DRESTRICTED_LAPLACIAN_3_SANITIZE=address,undefined \
    -DCGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE=ON -DRESTRICTED_LAPLACIAN_3_BUILD_EXAMPLES=OFF \
    -DRESTRICTED_LAPLACIAN_3_BUILD_PROGRAMS=OFF \
    -DRESTRICTED_LAPLACIAN_3_BUILD_BENCHMARKS=ON -DRESTRICTED_LAPLACIAN_3_BUILD_DOC=OFF \
    -DRESTRICTED_LAPLACIAN_3_BUILD_VIEWER=OFF \
    -DRESTRICTED_LAPLACIAN_3_INSTALL=OFF "${python_options[@]}"
}

# One call of make for both folders keeps all processors busy.
build_all() {
  printf '%s\n' '.PHONY: all build build/sanitizers' 'all: build build/sanitizers' \
    'build build/sanitizers:' $'\t+$(MAKE) -C $@ all' |
    make --no-print-directory --jobs "$jobs" --file -
}

# One call of ctest, too. Leak detection finds what tests leave.
run_all() {
  mkdir -p build/all_tests
  printf 'subdirs("%s")\n' "$PWD/build" "$PWD/build/sanitizers" >build/all_tests/CTestTestfile.cmake
  rm -f "$results"
  CMAKE_CXX_COMPILER_LAUNCHER=$launcher \
    ASAN_OPTIONS=detect_leaks=1:halt_on_error=1 \
    UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1 \
    ctest --test-dir build/all_tests --parallel "$jobs" --output-on-failure --no-tests=error \
    --output-junit "$results" || true
}

# count PATTERN
count() {
  grep --count "$1" "$results" || true
}

# measured_last: of each file that still exists its last compilation, also one of an earlier run if the
# cache has answered since, which takes no memory
measured_last() {
  local seconds memory name
  awk '$2 > 50 || !($3 in last) { last[$3] = $0 } END { for (name in last) print last[name] }' \
    "$compilations" | while read -r seconds memory name; do
    if [[ -e $name ]]; then echo "$seconds $memory $name"; fi
  done
}

mkdir -p build
stage dependencies bash scripts/install_dependencies.sh
stage python make_python_environment
python=$(python3 -c 'import sys; print(sys.executable)')
launcher="$python;$PWD/scripts/measure_compilation.py;$compilations"
# A cache of compilations, where there is one. Names in it are relative to this folder, so it serves
# clones in other folders too.
if command -v ccache >/dev/null; then
  launcher+=";ccache"
  export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1 CCACHE_STATSLOG=$PWD/build/ccache.txt
  rm -f "$CCACHE_STATSLOG"
fi
touch "$compilations"
measured_last >"$compilations.kept"
mv "$compilations.kept" "$compilations"
stage configuration configure_all
stage compilation build_all
stage tests run_all

echo
echo "The slowest compilations (seconds, MiB):"
measured_last | sort -rn | awk 'NR <= 10'
echo
echo "The slowest tests (seconds):"
sed -n 's/.*<testcase name="\([^"]*\)".* time="\([^"]*\)".*/\2 \1/p' "$results" | sort -rn |
  awk 'NR <= 20 { printf "%.1f %s\n", $1, $2 }'
echo
printf '%s\n' "${stages[@]}"
if [[ -n ${CCACHE_STATSLOG-} ]]; then
  echo
  echo "Cache of compilations:"
  ccache --show-log-stats
fi

# What could not be started is neither passed nor skipped.
all=$(count '<testcase ')
passed=$(count '<testcase .* status="run"')
skipped=$(count '<skipped message="SKIP_')
failed=$((all - passed - skipped))
too_large=$(measured_last |
  awk '$2 > ($3 ~ "/(test|benchmark)/" && $3 !~ "/consumer/" ? 2.6e9 : 1.5e9) / 2^20')
if [[ -n $too_large ]]; then
  echo "Too much memory (seconds, MiB):"
  echo "$too_large"
  failed=$((failed + 1))
fi
echo "$passed passed, $failed failed, $skipped skipped"
((failed == 0 && all > 0))

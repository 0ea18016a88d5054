#!/usr/bin/env bash
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Usage: scripts/test_everything.sh [STAGE]...
#
# What takes too long for each change, some hours in all; to be run before a release. Stages, all of
# them unless some are named:
#
#   release     all that scripts/test.sh runs without sanitizers, with every header alone, each way to use
#               the package without the compiled library, and benchmarks by the same compiler
#   headers     the unit tests without the compiled library
#   sanitizers  all unit tests but the slow ones with AddressSanitizer and UndefinedBehaviorSanitizer
#   threads     ThreadSanitizer over the tests with the tag [threads]
#   python      pip install in a clone, with build isolation; the source archive, and the wheel where there is
#               neither a compiler nor this repository; notebooks; needs PyPI
#   portability the library and the Python module read by Clang with its own C++ library, and by the compiler
#               for Windows; needs Debian's clang, libc++-dev, libc++abi-dev and g++-mingw-w64-x86-64-posix
#   random      many random surfaces, and every allocation failing
#   shapes      ordinary shapes in all sizes, idle and beside other work, and the spectra of all meshes
#   fuzz        scripts/fuzz.sh: ten minutes for the reader of each format
#   debian      scripts/test.sh and scripts/demo.sh in a bare Debian 12 and a bare Debian 13; needs root
#   unstable    scripts/test_versions.sh in Debian's unstable; needs root
#
# Each stage builds in build/everything/STAGE/. How it ended goes to
# test/Restricted_laplacian_3/project/everything_log.txt, in place of what the last run of the stage left
# there. The exit status is 0 if all went well. JOBS in the environment is the number of parallel jobs, 2
# if not set, ROUNDS the number of random surfaces, 1000 if not set, FUZZ_SECONDS the time for a format, 600 if
# not set, and PYTHONS the interpreters, python3 if not set.

set -euo pipefail
export LC_ALL=C

cd "$(dirname "${BASH_SOURCE[0]}")/.."
all_stages=(release headers sanitizers threads python portability random shapes fuzz debian unstable)
for name in "$@"; do
  if [[ " ${all_stages[*]} " != *" $name "* ]]; then
    sed -n '/^# Usage/,/^$/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2
    exit 2
  fi
done
jobs=${JOBS:-2}
log=$PWD/test/Restricted_laplacian_3/project/everything_log.txt
# what earlier stages left in the log does not count as a change
commit=$(git describe --always --exclude='*' 2>/dev/null || echo unknown)
if [[ -n $(git status --porcelain --untracked-files=no -- . ":(exclude)$log" 2>/dev/null) ]]; then
  commit+=-dirty
fi
launcher=
if command -v ccache >/dev/null; then
  launcher=ccache
  export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1
fi

# build STAGE OPTION...
build() {
  cmake -S . -B "build/everything/$1" -G "Unix Makefiles" \
    -DRESTRICTED_LAPLACIAN_3_WARNINGS_AS_ERRORS=ON -DRESTRICTED_LAPLACIAN_3_BUILD_TESTS=ON \
    -DRESTRICTED_LAPLACIAN_3_TEST_EVERYTHING=ON "-DCMAKE_CXX_COMPILER_LAUNCHER=$launcher" "${@:2}" &&
    cmake --build "build/everything/$1" --parallel "$jobs"
}

# run STAGE JOBS OPTION...: tests of a build, counted for the log
run() {
  local results=$PWD/build/everything/$1/results.xml status=0
  rm -f "$results"
  CMAKE_CXX_COMPILER_LAUNCHER=$launcher ctest --test-dir "build/everything/$1" --parallel "$2" \
    --output-on-failure --no-tests=error --output-junit "$results" "${@:3}" || status=1
  details=$(awk '
    /<testcase / { ++all }
    /<testcase .* status="run"/ { ++passed }
    /<skipped message="SKIP_/ { ++skipped }
    END { printf "%d passed, %d failed, %d skipped", passed, all - passed - skipped, skipped }
  ' "$results")
  return "$status"
}

release() {
  build release -DCMAKE_BUILD_TYPE=Release -DRESTRICTED_LAPLACIAN_3_PROGRAM_OPTIONS=-O1 \
    -DRESTRICTED_LAPLACIAN_3_BUILD_EXAMPLES=ON -DRESTRICTED_LAPLACIAN_3_BUILD_BENCHMARKS=ON \
    -DRESTRICTED_LAPLACIAN_3_BUILD_DOC=ON &&
    run release "$jobs"
}

headers() {
  build headers -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O1\ -DNDEBUG \
    -DRESTRICTED_LAPLACIAN_3_COMPILED=OFF -DRESTRICTED_LAPLACIAN_3_TEST_BUNDLE=1 \
    -DRESTRICTED_LAPLACIAN_3_BUILD_EXAMPLES=OFF \
    -DRESTRICTED_LAPLACIAN_3_BUILD_PROGRAMS=OFF -DRESTRICTED_LAPLACIAN_3_BUILD_DOC=OFF &&
    run headers "$jobs" --label-regex unit
}

# sanitized STAGE SANITIZERS
sanitized() {
  build "$1" -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=Debug \
    -DCMAKE_CXX_FLAGS_DEBUG="-O1 -g1" "-DRESTRICTED_LAPLACIAN_3_SANITIZE=$2" \
    -DCGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE=ON -DRESTRICTED_LAPLACIAN_3_BUILD_EXAMPLES=OFF \
    -DRESTRICTED_LAPLACIAN_3_BUILD_PROGRAMS=OFF \
    -DRESTRICTED_LAPLACIAN_3_BUILD_DOC=OFF -DRESTRICTED_LAPLACIAN_3_INSTALL=OFF
}

# Leak detection finds what tests leave.
sanitizers() {
  sanitized sanitizers address,undefined &&
    ASAN_OPTIONS=detect_leaks=1:halt_on_error=1 \
      UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1 run sanitizers "$jobs"
}

# One test after the other: each has threads of its own. Libraries that are not compiled for it, such as
# CHOLMOD with its OpenMP, do not count.
threads() {
  sanitized threads thread &&
    TSAN_OPTIONS=halt_on_error=1:ignore_noninstrumented_modules=1 run threads 1
}

# The lines of the manual in an empty folder, and all tests, by each interpreter; and the packages.
python() {
  local folder interpreter status=0
  details="pip install and tests by $(wc -w <<<"${PYTHONS:-python3}") interpreters, source archive, wheel, notebooks"
  folder=$(mktemp -d)
  git clone --quiet . "$folder/clone" || status=1
  for interpreter in ${PYTHONS:-python3}; do
    rm -rf "$folder/environment"
    "$interpreter" -m venv "$folder/environment" &&
      (
        cd "$folder/clone" && PATH=$folder/environment/bin:$PATH && command pip install '.[files]' &&
          command pip install pytest numpydoc neuromodes && cd "$folder" &&
          command python -c 'import restricted_laplacian as rl; V, F = rl.icosphere(4); l, u = rl.eigs(V, F, 50); print(l[:4], u.shape)' &&
          command python -m pytest -q -rs -p no:cacheprovider clone/python/tests
      ) || status=1
  done
  bash scripts/make_python_packages.sh build/everything/python &&
    bash scripts/run_notebooks.sh "$folder/Notebooks.txt" "$folder/figures" || status=1
  rm -rf "$folder"
  return "$status"
}

# What CGAL, Boost and Eigen are for other systems are the same headers; GMP, TBB and CHOLMOD are left out.
portability() {
  local folder=$PWD/build/everything/portability status=0 source name
  local flags=(-std=c++17 -fsyntax-only -Wall -Wextra -Iinclude -isystem "$folder/include"
    -isystem "$folder/include/eigen3" -DCGAL_DISABLE_GMP -DCGAL_EIGEN3_ENABLED -DBOOST_NO_CXX98_FUNCTION_BASE
    -DCGAL_RESTRICTED_LAPLACIAN_3_COMPILED '-DRESTRICTED_LAPLACIAN_3_VERSION="0"')
  mkdir -p "$folder/include"
  for name in CGAL boost eigen3 Spectra; do
    ln -sfn "/usr/include/$name" "$folder/include/$name"
  done
  details="$(ls src/Restricted_laplacian_3/*.cpp | wc -l) sources by clang++ -stdlib=libc++ and by MinGW"
  for source in src/Restricted_laplacian_3/*.cpp; do
    echo "$source"
    clang++ -stdlib=libc++ "${flags[@]}" "$source" || status=1
    x86_64-w64-mingw32-g++-posix -Wa,-mbig-obj "${flags[@]}" -Wno-use-after-free "$source" || status=1
  done
  return "$status"
}

random() {
  local program=build/everything/release/test/Restricted_laplacian_3 status=0
  [[ -x $program/test_memory ]] || release || status=1
  details="${ROUNDS:-1000} surfaces"
  RESTRICTED_LAPLACIAN_3_FUZZ_ROUNDS=${ROUNDS:-1000} \
    "$program/test_restricted_laplacian_3" random_hostile_surfaces || status=1
  RESTRICTED_LAPLACIAN_3_FAIL_ALL_ALLOCATIONS=1 "$program/test_memory" || status=1
  return "$status"
}

# With the package as pip installs it. Several hours, most of them for the spectra.
shapes() {
  local environment=$PWD/build/everything/shapes status=0 cache=$PWD/build/CMakeCache.txt
  local study=$PWD/benchmark/Restricted_laplacian_3/shape_study.py folders=() folder
  details="ordinary shapes, spectra"
  for folder in SHARED_MESHES DATA_DIR; do
    folder=$(sed -n "s/^RESTRICTED_LAPLACIAN_3_$folder:[^=]*=//p" "$cache" 2>/dev/null || true)
    [[ -d $folder ]] && folders+=("$folder")
  done
  python3 -m venv "$environment" && "$environment/bin/pip" install --quiet . &&
    "$environment/bin/python" "$study" shapes || status=1
  if ((${#folders[@]} > 0)); then
    "$environment/bin/python" "$study" meshes "${folders[@]}" || status=1
  else
    details="ordinary shapes, no meshes found"
  fi
  return "$status"
}

fuzz() {
  details="${FUZZ_SECONDS:-600} s for each format"
  bash scripts/fuzz.sh "${FUZZ_SECONDS:-600}"
}

debian() {
  local suite status=0
  details="its log is bare_debian_log.txt"
  for suite in bookworm trixie; do
    bash scripts/try_bare_debian.sh "$suite" || status=1
  done
  return "$status"
}

unstable() {
  details="its log is bare_debian_log.txt"
  bash scripts/try_bare_debian.sh unstable test_versions.sh
}

touch "$log"
failed=0
(($# > 0)) || set -- "${all_stages[@]}"
for name in "$@"; do
  echo "=== $name"
  details="not built" result=passed start=$SECONDS
  "$name" || result=FAILED failed=1
  line="$result: $name, $details, $((SECONDS - start)) s, commit $commit, $(date -u +%F)"
  { grep -v "^[a-zA-Z]*: $name," "$log" || true; echo "$line"; } >"$log.new"
  mv "$log.new" "$log"
done
cat "$log"
exit "$failed"

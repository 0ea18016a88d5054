#!/usr/bin/env bash
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Usage: scripts/test_threads.sh
#
# Looks for data races: builds in build/threads/, with Clang and ThreadSanitizer, the library and the
# unit tests with the tag [threads], and runs these. JOBS in the environment is the number of
# parallel compilations, 2 if not set.

set -euo pipefail
export LC_ALL=C

cd "$(dirname "${BASH_SOURCE[0]}")/.."
cmake -S . -B build/threads -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=Debug \
  -DCMAKE_CXX_FLAGS_DEBUG="-O1 -g1" -DRESTRICTED_LAPLACIAN_3_SANITIZE=thread \
  -DCGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE=ON -DRESTRICTED_LAPLACIAN_3_BUILD_EXAMPLES=OFF \
  -DRESTRICTED_LAPLACIAN_3_BUILD_DOC=OFF -DRESTRICTED_LAPLACIAN_3_INSTALL=OFF
cmake --build build/threads --parallel "${JOBS:-2}" --target test_restricted_laplacian_3
# One test after the other: each has threads of its own. Libraries that are not compiled for it, such as
# CHOLMOD with its OpenMP, do not count.
TSAN_OPTIONS=halt_on_error=1:ignore_noninstrumented_modules=1 ctest --test-dir build/threads \
  --label-regex sanitized --output-on-failure --no-tests=error

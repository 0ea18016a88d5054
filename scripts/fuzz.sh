#!/usr/bin/env bash
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# usage: fuzz.sh [SECONDS [SUFFIX]...]
#
# Feeds the readers of files of all formats, or of some (.off, .ply, ...), with bytes that libFuzzer
# makes of the files in test/Restricted_laplacian_3/mesh_files/: for so many seconds each, by
# default 600, two at a time. Needs clang with its run-time libraries. What breaks a reader is left in
# build/fuzz/.
#
# The exit status is 0 if nothing broke.

set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
seconds=${1:-600}
shift || true
suffixes=("$@")
((${#suffixes[@]})) || suffixes=(.off .obj .ply .stl .vtk .ts .xyz)
corpus=$PWD/test/Restricted_laplacian_3/mesh_files
mkdir -p build/fuzz
cd build/fuzz
clang++ -std=c++17 -O1 -g -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=undefined \
  -frounding-math -DCGAL_EIGEN3_ENABLED -I../../include -isystem /usr/include/eigen3 \
  ../../test/Restricted_laplacian_3/fuzz/fuzz_mesh_files.cpp -o fuzz_mesh_files -lgmp -lmpfr

fuzz() {
  local suffix=$1
  rm -rf "found$suffix"
  mkdir "found$suffix"
  mkdir -p "seeds$suffix"
  cp "$corpus"/*"$suffix" "seeds$suffix/"
  FUZZED_SUFFIX=$suffix ./fuzz_mesh_files -max_total_time="$seconds" -max_len=4096 -timeout=20 \
    -rss_limit_mb=2048 -artifact_prefix="broken$suffix-" "found$suffix" "seeds$suffix" >"log$suffix.txt" 2>&1 ||
    { echo "$suffix: broken"; tail -n 30 "log$suffix.txt"; return 1; }
  echo "$suffix: $(grep -c . <(ls "found$suffix")) inputs, $(tail -n 1 "log$suffix.txt")"
}

status=0
while ((${#suffixes[@]})); do
  pids=()
  for suffix in "${suffixes[@]:0:2}"; do
    fuzz "$suffix" &
    pids+=($!)
  done
  for pid in "${pids[@]}"; do
    wait "$pid" || status=1
  done
  suffixes=("${suffixes[@]:2}")
done
exit $status

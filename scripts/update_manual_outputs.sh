#!/usr/bin/env bash
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Usage: scripts/update_manual_outputs.sh [--check] BUILD_DIR DATA_DIR
#
# The files of doc/Restricted_laplacian_3/outputs, which the manual shows, hold commands, each after
# "$ ", and what they print. Runs the commands, in the order of the names of the files and in one
# folder that begins as DATA_DIR, CGAL's meshes, with the programs and examples of BUILD_DIR; and writes what
# they print now. A new file needs its commands only. With --check writes nothing, and fails if a
# command fails, or prints other lines than those of its file. Lines are compared word by word:
#
# 1. Words end at spaces and commas. Numbers are words like 12, -0.5 or 1e-3, maybe with a semicolon
#    or colon behind them. Other words must be equal.
# 2. Two numbers without a point or an exponent must be equal, but may differ by 1 in a line that
#    names iterations.
# 3. Other numbers may differ by a thousandth of the larger one. Those below 1e-9 are rounding
#    errors, and any two of them are equal.
# 4. Times, numbers of threads and residuals differ from machine to machine: in a line that names
#    seconds, threads or a residual any number will do, except for iterations.
# 5. Lines that begin with "OpenMesh:" may be missing, as they are in programs without OpenMesh.

set -euo pipefail
export LC_ALL=C

is_check=false
if [[ ${1:-} == --check ]]; then
  is_check=true
  shift
fi
if [[ $# == 2 && $is_check == true && ! -r $2/elephant.off ]]; then
  echo "SKIPPED: there is no $2/elephant.off"
  exit
fi
if [[ $# != 2 || ! -d $1 || ! -d $2 ]]; then
  sed -n '/^# Usage/,/^$/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2
  exit 2
fi
build=$(cd "$1" && pwd)
if [[ $is_check == true && ! -x $build/bin/draw_mesh ]]; then
  echo "SKIPPED: there is no $build/bin/draw_mesh"
  exit
fi
outputs=$(cd "$(dirname "${BASH_SOURCE[0]}")/../doc/Restricted_laplacian_3/outputs" && pwd)

source "$(dirname "${BASH_SOURCE[0]}")/mesh_folder.sh"
enter_mesh_folder "$2"
PATH="$build/bin:$build/examples/Restricted_laplacian_3:$PATH"

# run_commands FILE: the commands of a file, each with what it prints now. A backslash at the end of
# a line continues a command.
run_commands() {
  local line command
  while IFS= read -r line; do
    [[ $line == '$ '* ]] || continue
    command=${line#'$ '}
    printf '%s\n' "$line"
    while [[ $line == *\\ ]]; do
      IFS= read -r line
      command=${command%\\}$line
      printf '%s\n' "$line"
    done
    if ! eval "$command" 2>"$folder/errors" </dev/null || [[ -s $folder/errors ]]; then
      echo "$1: failed: $command" >&2
      cat "$folder/errors" >&2
      return 1
    fi
  done <"$1"
}

# is_same EXPECTED FOUND: compares two files by the rules above, and prints where they differ
is_same() {
  awk '
    function is_number(word) { return word ~ /^[-+]?[0-9]+(\.[0-9]*)?(e[-+]?[0-9]+)?$/ }
    function is_whole(word) { return word ~ /^[-+]?[0-9]+$/ }
    function magnitude(x) { x += 0; return x < 0 ? -x : x }

    function is_same_number(a, b, line,   difference, larger) {
      difference = magnitude(a - b)
      if(is_whole(a) && is_whole(b) && line ~ /iterations/) return difference <= 1
      if(line ~ /seconds|threads|residual/) return 1
      if(is_whole(a) && is_whole(b)) return difference == 0
      larger = magnitude(a)
      if(larger < magnitude(b)) larger = magnitude(b)
      return difference <= 1e-3 * larger || larger < 1e-9
    }
    function is_same_word(a, b, line,   x, y) {
      if(a == b) return 1
      x = a; y = b
      sub(/[;:]$/, "", x); sub(/[;:]$/, "", y)
      return is_number(x) && is_number(y) && substr(a, length(x) + 1) == substr(b, length(y) + 1) &&
             is_same_number(x, y, line)
    }
    function is_same_line(a, b,   n, i, words_of_a, words_of_b) {
      gsub(/,/, " , ", a); gsub(/,/, " , ", b)
      n = split(a, words_of_a)
      if(split(b, words_of_b) != n) return 0
      for(i = 1; i <= n; ++i)
        if(!is_same_word(words_of_a[i], words_of_b[i], a)) return 0
      return 1
    }

    NR == FNR { expected[++number_expected] = $0; next }
    { found[++number_found] = $0 }
    END {
      for(i = j = 1; i <= number_expected || j <= number_found; ++i) {
        if(i <= number_expected && j <= number_found && is_same_line(expected[i], found[j])) {
          ++j
          continue
        }
        if(expected[i] ~ /^OpenMesh:/ && found[j] !~ /^OpenMesh:/) continue
        if(i <= number_expected) print "  line " i ": " expected[i]
        else print "  no such line"
        if(j <= number_found) print "  found:  " found[j++]
        else print "  found nothing"
        is_different = 1
      }
      exit is_different
    }' "$1" "$2"
}

number=0
status=0
for file in "$outputs"/*.txt; do
  run_commands "$file" >"$folder/found"
  if ! grep --quiet '^\$ ' "$folder/found"; then
    echo "$file holds no command" >&2
    exit 1
  fi
  number=$((number + 1))
  if [[ $is_check == false ]]; then
    sed 's/ *$//' "$folder/found" >"$file"
  elif ! is_same "$file" "$folder/found" >"$folder/differences"; then
    echo "$(basename "$file") differs:"
    cat "$folder/differences"
    status=1
  fi
done
if [[ $number == 0 ]]; then
  echo "there is no file in $outputs" >&2
  exit 1
fi
[[ $is_check == false ]] || echo "$number files compared"
exit "$status"

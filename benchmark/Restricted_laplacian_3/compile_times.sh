#!/usr/bin/env bash
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# How long does a user's program take to compile, and how much memory, with the headers alone and with
# the compiled library, next to CGAL's heat method, and to what a mesh and reading one alone take?
#
# usage: compile_times.sh [--repetitions N] [--only REGEX]
#
# Compiles each program N times, by default 3, one after the other so that all of them share what
# else the machine does, without linking, with the flags that CMake passes on, and prints medians. CXX
# in the environment is the compiler. --only takes the rows, `program mode option`, that match.
# Columns: seconds on the wall, seconds of the processor, largest memory in MiB.

set -euo pipefail

usage() {
  sed -n '/^# usage:/,/^$/s/^# \{0,1\}//p' "$0" >&2
  exit 2
}

repetitions=3
only=.
arguments=("$@")
while (($# > 0)); do
  case "$1" in
    --repetitions) repetitions=${2:?}; shift 2 ;;
    --only) only=${2:?}; shift 2 ;;
    *) usage ;;
  esac
done
[[ $repetitions =~ ^[1-9][0-9]*$ ]] || usage

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
examples=$root/examples/Restricted_laplacian_3
cxx=${CXX:-g++}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

cat >"$folder/surface_mesh.cpp" <<'END'
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> mesh;
int main() {}
END
{
  echo '#include <CGAL/Restricted_laplacian_3/solve_poisson.h>'
  cat "$folder/surface_mesh.cpp"
} >"$folder/include_solve_poisson.cpp"

flags=(-std=c++17 -frounding-math -I"$root/include" -isystem /usr/include/eigen3
  -isystem /usr/include/suitesparse -DBOOST_ALL_NO_LIB -DCGAL_EIGEN3_ENABLED -DCGAL_USE_GMPXX=1
  -DCGAL_LINKED_WITH_TBB -DCGAL_RESTRICTED_LAPLACIAN_3_USE_CHOLMOD)

# program, mode, source
programs="\
surface_mesh          alone    $folder/surface_mesh.cpp
read_mesh             alone    $here/compile_times/read_mesh.cpp
heat_method           headers  $here/compile_times/heat_method.cpp
include_solve_poisson headers  $folder/include_solve_poisson.cpp
include_solve_poisson compiled $folder/include_solve_poisson.cpp
minimal_poisson       headers  $examples/minimal_poisson.cpp
minimal_poisson       compiled $examples/minimal_poisson.cpp
minimal_curvature     headers  $examples/minimal_curvature.cpp
minimal_curvature     compiled $examples/minimal_curvature.cpp"

# measure COMMAND...: seconds on the wall, of the processor, MiB
measure() {
  python3 -c '
import resource, subprocess, sys, time
start = time.monotonic()
status = subprocess.call(sys.argv[1:])
wall = time.monotonic() - start
used = resource.getrusage(resource.RUSAGE_CHILDREN)
print("%.2f %.2f %.0f" % (wall, used.ru_utime + used.ru_stime, used.ru_maxrss / 1024))
sys.exit(status)' "$@"
}

# median FILE COLUMN
median() {
  cut -d' ' -f"$2" "$1" | sort -n |
    awk '{ v[NR] = $1 } END { print (v[int((NR + 1) / 2)] + v[int((NR + 2) / 2)]) / 2 }'
}

for ((i = 0; i < repetitions; ++i)); do
  for optimization in -O3 -O0; do
    while read -r program mode source; do
      [[ "$program $mode $optimization" =~ $only ]] || continue
      options=("$optimization" -DNDEBUG)
      if [[ $mode == compiled ]]; then
        options+=(-DCGAL_RESTRICTED_LAPLACIAN_3_COMPILED)
      fi
      measure "$cxx" "${flags[@]}" "${options[@]}" -c "$source" -o "$folder/program.o" \
        >>"$folder/$program $mode $optimization.times"
    done <<<"$programs"
  done
done

commit=$(git -C "$root" rev-parse --short HEAD 2>/dev/null || echo unknown)
changed=$(git -C "$root" status --porcelain -- . ':!benchmark/Restricted_laplacian_3/results' || true)
echo "# commit: $commit${changed:+-dirty}"
echo "# machine: $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1), $(nproc) cores"
echo "# compiler: $("$cxx" --version | head -n 1)"
echo "# command: compile_times.sh${arguments[*]:+ ${arguments[*]}}"
printf '# %-20s %-8s %-6s %9s %9s %6s\n' program mode option seconds cpu_s MiB
for optimization in -O3 -O0; do
  while read -r program mode ignored; do
    times="$folder/$program $mode $optimization.times"
    [[ -e $times ]] || continue
    printf '%-22s %-8s %-6s %9.1f %9.1f %6.0f\n' "$program" "$mode" "$optimization" \
      "$(median "$times" 1)" "$(median "$times" 2)" "$(median "$times" 3)"
  done <<<"$programs"
done

#!/usr/bin/env bash
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Measures again what the paper has in its figures and tables. The manual's page "Reproduction of
# the Paper" compares the results with those of the paper.
#
# usage: reproduce_paper.sh [--meshes DIR] [--quick] BUILD_DIR ITEM...
#        reproduce_paper.sh --list
#
# BUILD_DIR is a build of the package with RESTRICTED_LAPLACIAN_3_BUILD_BENCHMARKS=ON; the programs
# of an item have to be built, it says which are missing. An ITEM is one of those that --list shows,
# or `all`. --meshes gives the folder of meshes beyond CGAL's data, by default the one of the
# build. An item takes the first mesh it finds for each of those of the paper, and says which ones
# it leaves out. --quick takes a smaller depth, or fewer meshes, to see that all runs.
#
# Exit status: 0 if all items ran, 1 if one failed, or had no mesh or no program.

set -eu -o pipefail

# name, program, minutes on one core, roughly, what it is about
items="\
table1    spectrum_study          15 dimensions of the operators, and spectra on three tessellations
figure1   texture_stitching       10 stitched colors of scans
figure3   spectrum_study          15 the same run as table1
figure4   gradient_integration     5 a color map from its gradients, one W-cycle
figure5   curvature_study          2 normals, fitted
figure6   curvature_study          1 mean curvature from the Laplacian of the coordinates
figure7   normal_fitting           3 normals from their gradients, with and without screening
table2    solver_comparison       20 this package and BoomerAMG, Poisson and screened problems
fitting   solver_comparison       10 the same for the mass matrix, where the paper has no figures
pulley    spectrum_study          12 errors of eigenvalues on thin shapes (section 5.5)
setup     assembly_scaling         2 time to the matrices over triangles and depth (section 4.4)
sampling  monte_carlo_convergence 10 sums over samples in place of integrals (section 4.3)"

usage() {
  sed -n '/^# usage:/,/^$/s/^# \{0,1\}//p' "$0"
  echo
  list
}

list() {
  echo "item      program                min what"
  echo "$items"
}

is_quick=0 meshes=
while [ $# -gt 0 ]; do
  case $1 in
  --help | -h) usage; exit 0 ;;
  --list) list; exit 0 ;;
  --meshes) meshes=$2; shift 2 ;;
  --quick) is_quick=1; shift ;;
  *) break ;;
  esac
done
if [ $# -lt 2 ]; then
  usage >&2
  exit 2
fi
build=$1
shift
programs=$build/benchmark/Restricted_laplacian_3
if [ -z "$meshes" ]; then
  meshes=$(sed -n 's/^RESTRICTED_LAPLACIAN_3_SHARED_MESHES:PATH=//p' "$build/CMakeCache.txt")
fi
export OPENBLAS_NUM_THREADS=1
failures=0

# find_mesh NAME...: the first one that exists, in the folder of meshes or in CGAL's data; they stand
# for the same mesh of the paper
find_mesh() {
  local name file
  for name in "$@"; do
    for file in "$meshes/$name.ply" "$build/data/meshes/$name.off"; do
      if [ -f "$file" ]; then
        echo "$file"
        return
      fi
    done
  done
  echo "SKIPPED: there is no mesh $1" >&2
}

# find_meshes NAME...: all that exist
find_meshes() {
  local name
  for name in "$@"; do
    find_mesh "$name"
  done
}

# run PROGRAM OPTION...
run() {
  echo "\$ $*"
  "$programs/$1" "${@:2}"
}

# run_on MESHES PROGRAM OPTION...: nothing if there is no mesh
run_on() {
  if [ -z "$1" ]; then
    return 1
  fi
  # shellcheck disable=SC2086 # a word for each mesh
  run "${@:2}" --mesh $1
}

# paper LINE...: what the paper has
paper() {
  printf 'the paper: %s\n' "$@"
}

depth() { # DEPTH QUICK_DEPTH
  if [ $is_quick = 1 ]; then echo "$2"; else echo "$1"; fi
}

table1() {
  paper "dimensions cotangent low, medium, high; restricted low, medium, high" \
    "sphere 642 2562 10242; 504 504 504" "bimba 6100 12200 74764; 6071 6083 6083" \
    "fish 3700 14800 59200; 3617 3619 3616" "pulley 6459 19499 45676; 6160 6160 6161"
  local found output
  output=$(mktemp -d)
  found=$([ $is_quick = 1 ] || find_meshes bimba_46k fish_22k pulley_28k fandisk_large)
  # shellcheck disable=SC2086
  run spectrum_study --output "$output" sphere $found
  echo "curves: $output/*.csv, drawn by plots/spectrum_study.gp"
}
figure3() { table1; }

figure1() {
  paper "no figures"
  run_on "$(find_meshes head_male_color_18k spot_color_5k8)" texture_stitching
}

figure4() {
  paper "RMS 0.0536, dimension 138288, 2 + 4 s (color map not known)"
  run_on "$(find_meshes head_male_color_18k spot_color_5k8 gcanyon_color_318k)" \
    gradient_integration --depth "$(depth 8 6)" --space paper split
}

figure5() {
  paper "RMS 0.0071, dimension 559839, 11 + 17 s"
  run_on "$(find_mesh bimba_46k bunny00)" curvature_study --study normals --depth "$(depth 8 6)"
}

figure6() {
  paper "zero inside of the faces, not zero near their edges only; dimension 612035, 12 + 19 s"
  run_on "$(find_mesh cow_5k8 cow)" curvature_study --study edges --depth "$(depth 8 6)"
}

figure7() {
  paper "cow RMS 0.3073 -> 0.0962, dimension 189914, 4 + 6 s" \
    "pulley RMS 0.0435 -> 0.0024, dimension 669975, 13 + 18 s"
  run_on "$(find_mesh cow_5k8 cow)" normal_fitting --space paper --stabilization 0 \
    --depth "$(depth 8 6)"
  run_on "$(find_mesh cow_5k8 cow)" normal_fitting --depth "$(depth 8 6)"
  run_on "$(find_mesh pulley_28k rotor_small)" normal_fitting --depth "$(depth 7 5)"
}

# solvers MESH DEPTH OPTION...
solvers() {
  if [ -n "$1" ]; then
    # Debian's Open MPI refuses to run as root unless told twice.
    OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 run solver_comparison \
      --mesh "$1" --depth "$2" --processor-time --rhs normals "${@:3}"
  fi
}

table2() {
  paper "setup + solution in seconds, AMG1, AMG2, theirs; * with screening" \
    "rooster (1062919)  out of memory, out of memory, 30.7 + 76.6" \
    "male    (138288)   14.1 + 26.4,    1.8 + 13.1,   3.9 +  8.5" \
    "cow     (189914)   19.7 + 39.0,    2.5 + 17.2,   5.4 + 11.4" \
    "cow*    (189914)   13.3 + 37.8,    2.1 + 16.7,   5.4 + 13.8" \
    "pulley  (669975)   out of memory, 11.1 + 69.1,  18.2 + 34.7" \
    "pulley* (669975)   74.9 + 171.6,   9.1 + 65.4,  18.2 + 42.1"
  local as_paper=(--paper --stabilization 0 --solver ours ours_paper amg1 amg2 --tolerance 5e-3)
  local default=(--solver ours amg1_pcg amg2_pcg --tolerance 5e-3)
  local cow pulley rooster
  cow=$(find_mesh cow_5k8 cow)
  pulley=$(find_mesh pulley_28k rotor_small)
  rooster=$(find_mesh fish_22k elephant)
  for screening in 0 0.05; do
    solvers "$cow" "$(depth 8 6)" "${as_paper[@]}" --screening $screening
    solvers "$cow" "$(depth 8 6)" "${default[@]}" --screening $screening
    solvers "$pulley" "$(depth 7 5)" "${default[@]}" --screening $screening
  done
  solvers "$rooster" "$(depth 9 6)" "${default[@]}" --repetitions 1
}

fitting() {
  paper "\"the AMG solvers failed to converge on these experiments\""
  local cow options=(--matrix mass --tolerance 5e-3 1e-8)
  cow=$(find_mesh cow_5k8 cow)
  solvers "$cow" "$(depth 8 6)" "${options[@]}" --paper --stabilization 0 \
    --solver ours ours_paper amg1 amg2 amg2_pcg
  solvers "$cow" "$(depth 8 6)" "${options[@]}" --stabilization 1e-4 \
    --solver ours amg1_pcg amg2_pcg
}

pulley() {
  paper "the operator \"fails to define a robust spectrum\""
  local output
  output=$(mktemp -d)
  run spectrum_study --output "$output" thin
}

setup() {
  paper "set-up time O(N d), N triangles or samples, d depth"
  run assembly_scaling
}

sampling() {
  paper "sums over samples are less accurate than integrals"
  run monte_carlo_convergence
}

if [ "$*" = all ]; then
  set -- $(echo "$items" | awk '$1 != "figure3" {print $1}')
fi
for item in "$@"; do
  line=$(echo "$items" | awk -v item="$item" '$1 == item')
  if [ -z "$line" ]; then
    echo "reproduce_paper.sh: there is no item $item; --list shows them" >&2
    exit 2
  fi
  program=$(echo "$line" | awk '{print $2}')
  echo "== $line"
  if [ ! -x "$programs/$program" ]; then
    echo "SKIPPED: cmake --build $build --target $program" >&2
    failures=1
    continue
  fi
  start=$SECONDS
  "$item" || failures=1
  echo "== $item took $((SECONDS - start)) seconds"
  echo
done
exit $failures

#!/usr/bin/env bash
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Measures what is in results/, on one commit: all but panels and sorts_and_inverses, which are built twice.
#
# usage: measure.sh BUILD_DIR [RESULT...]
#        measure.sh --list
#
# Configures and builds the benchmarks in BUILD_DIR, then writes results/RESULT.txt for each RESULT,
# by default for all of them. Refuses to start from files that are not committed, since a result
# names the commit that it was measured on; results themselves may have changed. What depends on
# meshes or libraries that are missing is left out, with a word, and its old result remains. Seconds
# count only if nothing else runs. MEASURE_CPU=N in the environment keeps what runs on one thread to
# processor N.
#
# Exit status: 0 if all results were written.

set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)

# a result, and the command of each of its parts
commands="\
assembly_scaling         assembly_scaling bunny00.off
solver_comparison_bunny  solver_comparison --mesh bunny00 --depth 7 --solver ours ours_point amg1_pcg amg2_pcg cgc_pcg cholmod ic_cg --threads 1 --limit 10
solver_comparison_bunny  solver_comparison --mesh bunny00 --depth 7 --solver ours amg1_pcg amg2_pcg cholmod --threads 2 --limit 10
solver_comparison_depth_8 solver_comparison --mesh bunny00 cow_5k8 fish_22k armadillo fandisk_32k --depth 8 --solver ours amg1_pcg amg2_pcg --tolerance 5e-3 --threads 1
solver_comparison_depth_8 solver_comparison --mesh cow_5k8 fish_22k --depth 8 --solver ours amg1_pcg amg2_pcg --tolerance 5e-3 --threads 2
solver_comparison_loads  solver_comparison --mesh bunny00 cow_5k8 --depth 7 --solver ours amg1_pcg amg2_pcg --tolerance 5e-3 1e-8 --threads 1 --limit 10 --rhs x
solver_comparison_loads  solver_comparison --mesh bunny00 cow_5k8 --depth 7 --solver ours amg1_pcg amg2_pcg --tolerance 5e-3 1e-8 --threads 1 --limit 10 --rhs random
solver_comparison_loads  solver_comparison --mesh bunny00 cow_5k8 --depth 7 --solver ours amg1_pcg amg2_pcg --tolerance 5e-3 1e-8 --threads 1 --limit 10 --rhs normals
solver_comparison_loads  solver_comparison --mesh bunny00 cow_5k8 --depth 7 --solver ours amg1_pcg amg2_pcg --tolerance 5e-3 1e-8 --threads 1 --limit 10 --rhs normals --screening 0.05
solver_comparison_loads  solver_comparison --mesh bunny00 cow_5k8 --depth 7 --solver ours amg1_pcg amg2_pcg --tolerance 5e-3 1e-8 --threads 1 --limit 10 --rhs normals --matrix mass --stabilization 1e-4
solver_comparison_iterations solver_comparison --mesh bunny_closed_70k armadillo fandisk_32k pulley_28k cow_5k8 --solver ours --threads 1 --tolerance 5e-3 1e-8 --repetitions 1
depth_study              depth_study
depth_study              depth_study --mesh armadillo_mc1m --threads 2
accuracy_search          accuracy_search --repetitions 1 --mesh anchor_8k bimba_46k bunny_closed_70k armadillo itokawa_197k fandisk_32k
accuracy_search          accuracy_search --repetitions 1 --mesh cow_5k8 --accuracy 1e-2
accuracy_per_second      accuracy_per_second --part poisson
accuracy_per_second      accuracy_per_second --part spectrum --meshes 4 --spectrum-depth 3 4 5
eigensolver_comparison   eigensolver_comparison --mesh-to-pairs --reference 8 bimba_46k 5 6
eigensolver_comparison   eigensolver_comparison --mesh-to-pairs --reference 8 bunny_closed_70k 5 6
eigensolver_comparison   eigensolver_comparison --mesh-to-pairs --reference 8 armadillo 5 6 7
eigensolver_comparison   eigensolver_comparison --mesh-to-pairs --reference 8 armadillo_mc1m 6 7
eigensolver_comparison   eigensolver_comparison --pairs 20 --tolerance 1e-3 bunny_closed_70k 5
eigensolver_comparison   eigensolver_comparison --pairs 100 --tolerance 1e-3 bunny_closed_70k 5
eigensolver_comparison   eigensolver_comparison --pairs 20 --tolerance 1e-3 bunny_closed_70k 6
eigensolver_comparison   eigensolver_comparison --pairs 100 --tolerance 1e-3 bunny_closed_70k 6
eigensolver_comparison   eigensolver_comparison --pairs 20 bunny_closed_70k 6
eigensolver_comparison   eigensolver_comparison bunny_closed_70k 6
eigensolver_comparison   eigensolver_comparison bunny_closed_70k 7
eigensolver_comparison   eigensolver_comparison --no-peer --stabilization 1e-4 bunny_closed_70k 7
library_comparison       library_comparison
evaluation               evaluation
solvers_on_one_space     solvers_on_one_space
texture_stitching        texture_stitching --threads 2
gradient_integration     gradient_integration --space split --mesh head_male_color_18k --depth 6 7 8
gradient_integration     gradient_integration --space split --mesh spot_color_5k8 --depth 6 7 8
gradient_integration     gradient_integration --space split --mesh gcanyon_color_318k --depth 6 7 8
gradient_integration     gradient_integration --space split --mesh gcanyon_color_318k --depth 9
gradient_integration     gradient_integration --space paper --mesh head_male_color_18k spot_color_5k8 gcanyon_color_318k --depth 8
solver_comparison_paper  solver_comparison --processor-time --repetitions 1 --limit 40 --mesh cow_5k8 --depth 8 --rhs normals --tolerance 5e-3 --paper --stabilization 0 --solver ours ours_paper amg1 amg1_pcg amg2 amg2_pcg
solver_comparison_paper  solver_comparison --processor-time --repetitions 1 --limit 40 --mesh cow_5k8 --depth 8 --rhs normals --tolerance 5e-3 --screening 0.05 --paper --stabilization 0 --solver ours ours_paper amg1 amg2
solver_comparison_paper  solver_comparison --processor-time --repetitions 1 --limit 40 --mesh cow_5k8 --depth 8 --rhs normals --tolerance 5e-3 --solver ours amg1_pcg amg2_pcg
solver_comparison_paper  solver_comparison --processor-time --repetitions 1 --limit 40 --mesh cow_5k8 --depth 8 --rhs normals --tolerance 5e-3 --screening 0.05 --solver ours amg1_pcg amg2_pcg
solver_comparison_paper  solver_comparison --processor-time --repetitions 1 --limit 40 --mesh pulley_28k --depth 7 --rhs normals --tolerance 5e-3 --solver ours amg1_pcg amg2_pcg
solver_comparison_paper  solver_comparison --processor-time --repetitions 1 --limit 40 --mesh pulley_28k --depth 7 --rhs normals --tolerance 5e-3 --screening 0.05 --solver ours amg1_pcg amg2_pcg
solver_comparison_paper  solver_comparison --processor-time --repetitions 1 --limit 40 --mesh fish_22k --depth 9 --rhs normals --tolerance 5e-3 --solver ours amg1_pcg amg2_pcg
solver_comparison_paper  solver_comparison --processor-time --repetitions 1 --limit 60 --mesh cow_5k8 --depth 8 --rhs normals --matrix mass --tolerance 5e-3 1e-8 --paper --stabilization 0 --solver ours ours_paper amg1 amg2 amg2_pcg
solver_comparison_paper  solver_comparison --processor-time --repetitions 1 --limit 40 --mesh cow_5k8 --depth 8 --rhs normals --matrix mass --tolerance 5e-3 1e-8 --stabilization 1e-4 --solver ours amg1_pcg amg2_pcg
iterations_everywhere    iterations_everywhere --threads 1 --depth 4 5 6 --mesh moebius couplingdown bimba_5k cow_5k8 wingnut_6k spot_color_5k8 koala_7k anchor_8k bunny_adaptive_12k cessna_soup_14k fandisk_14k mechpart_15k cat_16k plane_holes_17k bunny_uniform_18k turbine_18k head_male_color_18k fish_22k spot_23k pulley_28k fandisk_32k cycloidal_soup_43k sword_45k bimba_46k mountain_51k bunny_closed_70k bunny_zipper_69k bunscan_045 bunscan_000 armadillo rgbd5_scan1 koala_100k rgbd5_scan2 rgbd5_scan3 rgbd5_scan4 rgbd5_scan5 itokawa_197k gcanyon_color_318k armadillo_mc1m
iterations_everywhere    iterations_everywhere --threads 1 --depth 7 --mesh moebius couplingdown bimba_5k cow_5k8 wingnut_6k spot_color_5k8 koala_7k anchor_8k bunny_adaptive_12k cessna_soup_14k fandisk_14k mechpart_15k cat_16k plane_holes_17k bunny_uniform_18k turbine_18k head_male_color_18k fish_22k spot_23k pulley_28k fandisk_32k cycloidal_soup_43k sword_45k bimba_46k mountain_51k bunny_closed_70k bunny_zipper_69k bunscan_045 bunscan_000 armadillo rgbd5_scan1 koala_100k rgbd5_scan2 rgbd5_scan3 rgbd5_scan4 rgbd5_scan5 itokawa_197k gcanyon_color_318k armadillo_mc1m
iterations_everywhere    iterations_everywhere --threads 1 --depth 8 --cycle v --mesh moebius couplingdown bimba_5k cow_5k8 wingnut_6k spot_color_5k8 koala_7k anchor_8k bunny_adaptive_12k cessna_soup_14k fandisk_14k mechpart_15k cat_16k plane_holes_17k bunny_uniform_18k turbine_18k head_male_color_18k fish_22k spot_23k pulley_28k fandisk_32k cycloidal_soup_43k sword_45k bimba_46k mountain_51k bunny_closed_70k bunny_zipper_69k bunscan_045 bunscan_000 armadillo rgbd5_scan1 koala_100k rgbd5_scan2 rgbd5_scan3 rgbd5_scan4 rgbd5_scan5 itokawa_197k gcanyon_color_318k armadillo_mc1m
stabilization            stabilization cow_5k8 fandisk_32k bunny_closed_70k
boundary_conditions      boundary_conditions
normal_fitting           normal_fitting --mesh cow_5k8 --depth 6 7 8 --threads 1
normal_fitting           normal_fitting --mesh pulley_28k --depth 5 6 7 --threads 1
normal_fitting           normal_fitting --space paper --stabilization 0 --depth 8 --mesh cow_5k8
curvature_study_accuracy curvature_study --study accuracy
curvature_study_change   curvature_study --study change --depth 5 6
curvature_study_edges    curvature_study --study edges --mesh cow --depth 8
curvature_study_normals  curvature_study --study normals --mesh bimba_46k bunny_closed_70k --depth 4 5 6 7 8
monte_carlo_convergence  monte_carlo_convergence
spectrum_study           spectrum_study --output spectrum_study sphere
spectrum_study           spectrum_study --output spectrum_study series
spectrum_study           spectrum_study --output spectrum_study armadillo
spectrum_study           spectrum_study --output spectrum_study thin
smooth_geometry          smooth_geometry
smooth_geometry          smooth_geometry --simplified bunny_closed_70k armadillo bimba_46k
smooth_geometry          smooth_geometry --held-out fandisk_14k fandisk_32k wingnut_6k pulley_28k anchor_8k mechpart_15k spot_23k bimba_46k bunny_closed_70k armadillo
smooth_geometry          smooth_geometry --curvature
thin_features            thin_features
thin_features            thin_features --gaps
distance_study           distance_study --source 0 0.6 --mesh bimba_5k cow_5k8 cat_16k spot_23k bimba_46k sword_45k bunny_closed_70k mechpart_15k fandisk_14k fandisk_32k turbine_18k pulley_28k wingnut_6k anchor_8k moebius cessna_soup_14k koala_100k itokawa_197k
distance_study_paths     distance_study --paths --source 0 --mesh bimba_5k cow_5k8 cat_16k spot_23k bimba_46k sword_45k bunny_closed_70k mechpart_15k fandisk_14k fandisk_32k turbine_18k pulley_28k wingnut_6k anchor_8k moebius cessna_soup_14k koala_100k itokawa_197k
distance_study_points    distance_study --method points --mesh bimba_5k cow_5k8 cat_16k spot_23k bimba_46k sword_45k bunny_closed_70k mechpart_15k fandisk_14k fandisk_32k turbine_18k pulley_28k wingnut_6k anchor_8k koala_7k koala_100k
large_surfaces           large_surfaces armadillo_mc1m 1 2 4 8 10 --depth 6 7 8 9
large_surfaces           large_surfaces armadillo_mc1m 1 2 4 10 --depth 7 --pairs 50
large_surfaces           large_surfaces armadillo_mc1m 10 --depth 7 --format stl
large_surfaces           large_surfaces armadillo_mc1m 16 --depth 7
partition_study          partition_study armadillo_mc1m 16 --depth 12
partition_study          partition_study armadillo_mc1m 1 --depth 9 --ranks 1 2 4
partition_study          partition_study bunny_closed_70k 1 --depth 7 --ranks 1 2 4 8
distributed_comparison   distributed_comparison armadillo_mc1m --depth 9 --tolerance 1e-8 --threads 2 --repetitions 1
distributed_comparison   mpiexec -n 1 distributed_comparison armadillo_mc1m --depth 9 --tolerance 1e-8 --method patches --repetitions 1
distributed_comparison   mpiexec -n 2 distributed_comparison armadillo_mc1m --depth 9 --tolerance 1e-8 --method patches --repetitions 1
distributed_comparison   mpiexec -n 4 distributed_comparison armadillo_mc1m --depth 9 --tolerance 1e-8 --method patches --repetitions 1
distributed_comparison   mpiexec -n 1 distributed_comparison bunny_closed_70k --depth 7 --tolerance 1e-8 --method patches
distributed_comparison   mpiexec -n 2 distributed_comparison bunny_closed_70k --depth 7
distributed_comparison   mpiexec -n 4 distributed_comparison bunny_closed_70k --depth 7 --tolerance 1e-8 --method boomeramg boomeramg_l1 gamg
distributed_comparison   mpiexec -n 8 distributed_comparison bunny_closed_70k --depth 7 --tolerance 1e-8 --method patches
distributed_comparison   mpiexec -n 2 distributed_comparison bunny_closed_70k --depth 8 --method boomeramg_l1 gamg --repetitions 1
distributed_eigensolvers distributed_eigensolvers bunny_closed_70k --depth 6 --tolerance 1e-3 1e-6 --threads 2
distributed_eigensolvers mpiexec -n 2 distributed_eigensolvers bunny_closed_70k --depth 6 --tolerance 1e-3 1e-6 --method lobpcg krylovschur gd
distributed_eigensolvers distributed_eigensolvers bunny_closed_70k --depth 7 --pairs 20 100 --threads 2
distributed_eigensolvers mpiexec -n 1 distributed_eigensolvers bunny_closed_70k --depth 7
distributed_eigensolvers mpiexec -n 2 distributed_eigensolvers bunny_closed_70k --depth 7 --pairs 20 100 --method lobpcg krylovschur
distributed_eigensolvers mpiexec -n 4 distributed_eigensolvers bunny_closed_70k --depth 7
distributed_eigensolvers distributed_eigensolvers bunny_closed_70k --depth 8 --threads 2
distributed_eigensolvers mpiexec -n 2 distributed_eigensolvers bunny_closed_70k --depth 8 --method lobpcg krylovschur
compile_times            compile_times.sh"

# What runs on one thread need not wait for the other processor.
is_on_two_threads() {
  [[ $* == *"threads 2"* || $1 =~ ^(assembly_scaling|evaluation|large_surfaces|partition_study|mpiexec|compile_times) ]]
}

names() {
  awk '!seen[$1]++ {print $1}' <<<"$commands"
}

if [[ ${1:-} == --list ]]; then
  names
  exit
fi
if (($# == 0)) || [[ $1 == -* ]]; then
  sed -n '/^# usage:/,/^$/s/^# \{0,1\}//p' "$0" >&2
  exit 2
fi
mkdir -p "$1"
build=$(cd "$1" && pwd)
shift
changed=$(git -C "$root" status --porcelain -- . ':!benchmark/Restricted_laplacian_3/results')
if [[ -n $changed ]]; then
  printf 'measure.sh: these files are not committed:\n%s\n' "$changed" >&2
  exit 2
fi
if (($# == 0)); then
  # shellcheck disable=SC2046 # names without spaces
  set -- $(names)
fi

cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DRESTRICTED_LAPLACIAN_3_BUILD_BENCHMARKS=ON \
  -DRESTRICTED_LAPLACIAN_3_BUILD_TESTS=OFF -DRESTRICTED_LAPLACIAN_3_BUILD_EXAMPLES=OFF \
  -DRESTRICTED_LAPLACIAN_3_BUILD_PROGRAMS=OFF \
  -DRESTRICTED_LAPLACIAN_3_BUILD_DOC=OFF >&2
cmake --build "$build" --parallel "${JOBS:-2}" >&2
export PATH="$build/benchmark/Restricted_laplacian_3:$here:$PATH"

# Debian's Open MPI refuses to run as root unless told twice, and more processes than cores.
export OPENBLAS_NUM_THREADS=1 OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_MCA_rmaps_base_oversubscribe=1 PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe
status=0
cd "$build/data/meshes"
for name in "$@"; do
  parts=$(awk -v name="$name" '$1 == name {$1 = ""; print substr($0, 2)}' <<<"$commands")
  if [[ -z $parts ]]; then
    echo "measure.sh: there is no result $name; --list shows them" >&2
    exit 2
  fi
  output=$(mktemp)
  separator=
  start=$SECONDS
  is_complete=1
  while read -r -a part; do
    prefix=()
    if [[ -n ${MEASURE_CPU:-} ]] && ! is_on_two_threads "${part[@]}"; then
      prefix=(taskset -c "$MEASURE_CPU")
    fi
    printf '%s' "$separator" >>"$output"
    separator=$'\n\n'
    if ! type "${part[0]}" >/dev/null 2>&1; then
      echo "$name: left out, ${part[0]} was not built" >&2
      is_complete=0
    elif ! "${prefix[@]}" "${part[@]}" >>"$output" 2>"$build/$name.err" </dev/null ||
      grep --quiet SKIPPED "$build/$name.err"; then
      echo "$name: ${part[*]} failed:" >&2
      tail -n 5 "$build/$name.err" >&2
      is_complete=0
    fi
  done <<<"$parts"
  if ((is_complete)); then
    sed 's/[ \t]*$//' "$output" >"$here/results/$name.txt"
    echo "$name: $((SECONDS - start)) s" >&2
  else
    status=1
  fi
  rm -f "$output"
done
# the curves that plots show
for curve in "$here"/results/spectrum_study/*.csv; do
  new=$build/data/meshes/spectrum_study/$(basename "$curve")
  if [[ -e $new ]]; then
    cp "$new" "$curve"
  fi
done
exit $status

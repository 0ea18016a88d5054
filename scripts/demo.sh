#!/usr/bin/env bash
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Usage: scripts/demo.sh
#
# Installs what is missing, builds the library and two programs in build/, solves a Poisson problem on
# CGAL's bunny and computes its spectrum. Tables, colored meshes (PLY) and pictures (PNG) go to
# demo_output/.

set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."

bash scripts/install_dependencies.sh --programs
cmake -S . -B build
cmake --build build --parallel "${JOBS:-2}" --target solve_poisson laplace_spectrum draw_mesh

programs=$PWD/build/examples/Restricted_laplacian_3
mesh=../build/data/meshes/bunny00.off
mkdir -p demo_output
cd demo_output

# run PROGRAM ARGUMENT...: shows the call
run() {
  echo "\$ $*"
  "$programs/$1" "${@:2}"
}

echo
echo "Laplacian u = z on the bunny:"
run solve_poisson "$mesh" --rhs z --depth 7 --refine 2 --output poisson.ply --csv poisson.csv
run draw_mesh poisson.ply poisson.png --property value --isolines 16
echo
echo "The twelve smallest eigenvalues of its Laplacian, and the eigenfunction of the seventh:"
run laplace_spectrum "$mesh" --count 12 --depth 6 --eigenfunction 6 \
  --output eigenfunction.ply --csv spectrum.csv
run draw_mesh eigenfunction.ply eigenfunction.png
echo
echo "Pictures (PNG), colored meshes (PLY) and tables (CSV) are in $PWD:"
ls -l

#!/usr/bin/env bash
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Usage: scripts/demo.sh
#
# Installs what is missing, builds the library and two programs in build/, solves a Poisson problem on
# CGAL's bunny and computes its spectrum. Pages to turn around in a browser (HTML), pictures (PNG), colored
# meshes (PLY) and tables (CSV) go to demo_output/.

set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."

bash scripts/install_dependencies.sh --programs
cmake -S . -B build
cmake --build build --parallel "${JOBS:-2}" --target viewer solve_poisson laplace_spectrum draw_mesh

programs=$PWD/build/bin
mesh=../build/data/meshes/bunny00.off
pages=true
if [[ ! -e build/viewer/viewer.html ]]; then
  pages=false
  echo "There are no pages for browsers: npm could not get three.js." >&2
fi
mkdir -p demo_output
cd demo_output

# page FILE: the option that writes a page, if pages can be written
page() { if $pages; then echo --html "$1"; fi; }

# run PROGRAM ARGUMENT...: shows the call
run() {
  echo "\$ $*"
  "$programs/$1" "${@:2}"
}

echo
echo "Laplacian u = z on the bunny:"
run solve_poisson "$mesh" --rhs z --depth 7 --refine 2 --output poisson.ply --csv poisson.csv $(page poisson.html)
run draw_mesh poisson.ply poisson.png --property value --isolines 16
echo
echo "The twelve smallest eigenvalues of its Laplacian, and the eigenfunction of the seventh:"
run laplace_spectrum "$mesh" --count 12 --depth 6 --eigenfunction 6 \
  --output eigenfunction.ply --csv spectrum.csv $(page eigenfunctions.html)
run draw_mesh eigenfunction.ply eigenfunction.png
echo
echo "Pages to turn around (HTML), pictures (PNG), colored meshes (PLY) and tables (CSV) are in $PWD:"
ls -l

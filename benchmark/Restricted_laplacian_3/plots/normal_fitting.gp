# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# The error of fitted normals over the depth, for split and unsplit spaces with and without
# screening; one picture for each mesh.
#
# usage: gnuplot -e "results='FILE'; output='FOLDER'" plots/normal_fitting.gp

if(!exists("results")) results = 'results/normal_fitting.txt'
if(!exists("output")) output = '.'
set terminal pngcairo size 900, 650 noenhanced
set logscale y
set xlabel 'depth'
set ylabel 'root mean square of |u - n|'
set xtics 1
set offsets 0.2, 0.2, 0, 0
set grid
of(mesh, space, alpha) = \
  strcol(1) eq mesh && strcol(3) eq space && strcol(4) eq alpha ? $14 : NaN
meshes = system("grep -v '^#' ".results." | awk 'NF {print $1}' | sort -u")
alphas = system("grep -v '^#' ".results." | awk 'NF {print $4}' | sort -u")
do for [mesh in meshes] {
  set title mesh
  set output output.'/normal_fitting_'.mesh.'.png'
  plot for [alpha in alphas] results using 2:(of(mesh, 'unsplit', alpha)) \
         with points pt 6 ps 1.5 title 'unsplit, alpha = '.alpha, \
       for [alpha in alphas] '' using 2:(of(mesh, 'split', alpha)) \
         with points pt 7 ps 1.5 title 'split, alpha = '.alpha
}

# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Seconds of setup and solution over the number of unknowns, for each solver; one picture for each
# number of threads and tolerance. Of each family of hypre's configurations the fastest is shown; a
# solver that did not reach the tolerance has no point.
#
# usage: gnuplot -e "results='FILE'; output='FOLDER'" plots/solver_comparison.gp

if(!exists("results")) results = 'results/solver_comparison_bunny.txt'
if(!exists("output")) output = '.'
set terminal pngcairo size 900, 650
set logscale xy
set xlabel 'unknowns'
set ylabel 'setup and solution, seconds'
set format x '10^{%L}'
set key left top
set grid
threads = system("grep -oE '^# [0-9]+ threads, residual [0-9e.+-]+' ".results." | tr ' ' '_'")
do for [block in threads] {
  name = system("echo '".block."' | tr '_' ' ' | cut -c 3-")
  set title name
  set output output.'/solver_comparison_'.word(name, 1).'_'.word(name, 4).'.png'
  plot results index name using 3:6 with points pt 7 ps 1.3 title 'this package', \
       '' index name using 3:7 with points pt 8 title 'BoomerAMG, classical', \
       '' index name using 3:8 with points pt 9 title 'BoomerAMG, tuned', \
       '' index name using 3:9 with points pt 4 title 'CHOLMOD', \
       '' index name using 3:10 with points pt 2 title 'IC-CG'
}

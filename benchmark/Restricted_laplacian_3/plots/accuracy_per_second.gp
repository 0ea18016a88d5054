# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Error over time, all runs; one picture for each shape and problem.
#
# usage: gnuplot -e "results='FILE'; output='FOLDER'" plots/accuracy_per_second.gp

if(!exists("results")) results = 'results/accuracy_per_second.txt'
if(!exists("output")) output = '.'
set terminal pngcairo size 900, 650
set logscale xy
set xlabel 'seconds from mesh to values at its vertices'
set ylabel 'relative error'
set format y '10^{%L}'
set grid
of(method) = strcol(3) eq method ? $10 : NaN
do for [shape in 'sphere torus'] {
  do for [problem in 'poisson spectrum'] {
    set title shape.', '.problem
    set output output.'/accuracy_per_second_'.shape.'_'.problem.'.png'
    name = shape.', '.problem.', all'
    plot results index name using 9:(of('restricted')) with points pt 7 title 'this package', \
         '' index name using 9:(of('restricted_v')) with points pt 6 title 'this package, values at vertices', \
         '' index name using 9:(of('cot_cholmod')) with points pt 4 title 'cotangent, CHOLMOD', \
         '' index name using 9:(of('cot_amg')) with points pt 9 title 'cotangent, BoomerAMG', \
         '' index name using 9:(of('cotangent')) with points pt 5 title 'cotangent, shift-invert'
  }
}

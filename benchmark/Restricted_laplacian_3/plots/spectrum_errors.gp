# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Error of the first 99 eigenvalues above 0 over the number of unknowns, on shapes with thin parts
# and needle triangles, from the part thin of spectrum_study: mean (lines, filled) and largest (open).
#
# usage: gnuplot -e "results='FOLDER'; output='FILE'; shapes='NAME...'" plots/spectrum_errors.gp

if(!exists("results")) results = 'results/spectrum_study'
if(!exists("output")) output = 'spectrum_errors.png'
if(!exists("shapes")) shapes = 'pulley rotor'
set terminal pngcairo size 450 * words(shapes), 360 font 'Sans,9' noenhanced
set output output
set datafile separator ','
set logscale xy
set xlabel 'unknowns'
set ylabel 'relative error' offset 1
set format y '%g'
set format x '%.0s%c'
set grid lc rgb '#dddddd'
set yrange [1e-5:1]
set key bottom right samplen 2
set multiplot layout 1, words(shapes)
do for [shape in shapes] {
  file = results.'/errors_'.shape.'.csv'
  set title shape
  plot "<grep '^cotangent' ".file using 3:5 with linespoints pt 5 lc rgb '#4292c6' title 'cotangent', \
       '' using 3:4 with points pt 4 lc rgb '#4292c6' notitle, \
       "<grep '^paper' ".file using 3:5 with linespoints pt 9 lc rgb '#888888' title "paper's space", \
       '' using 3:4 with points pt 8 lc rgb '#888888' notitle, \
       "<grep '^restricted' ".file using 3:5 with linespoints pt 7 lc rgb '#d94801' title 'restricted', \
       '' using 3:4 with points pt 6 lc rgb '#d94801' notitle
}
unset multiplot

# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Spectra of shapes in three tessellations, in the manner of figure 3 of the paper, one row for each
# shape: all of the spectrum; its upper end, by the cotangent operator; the same by restricted
# elements, over that of the cotangent operator on the finest tessellation.
#
# usage: gnuplot -e "results='FOLDER'; output='FILE'; shapes='NAME...'" plots/spectrum_study.gp

if(!exists("results")) results = 'results/spectrum_study'
if(!exists("output")) output = 'spectrum_study.png'
if(!exists("shapes")) shapes = 'sphere_icosahedral_depth_5 bimba fish pulley'
rows = words(shapes)
set terminal pngcairo size 1050, 60 + 230 * rows font 'Sans,9' noenhanced
set output output
set datafile separator ','
set multiplot layout rows, 3 margins 0.06, 0.99, 0.06, 1 - 0.12 / rows spacing 0.06, 0.2 / rows
last = 199
first = 160
at(index, wanted, value) = index == wanted ? value : NaN
title(shape) = shape[1:(strstrt(shape, '_') > 0 ? strstrt(shape, '_') - 1 : strlen(shape))]
do for [row = 1:rows] {
  file = results.'/'.word(shapes, row).'.csv'
  name = title(word(shapes, row))
  set autoscale
  stats file using (at($1, first, $4 < $10 ? $4 : $10)) nooutput
  bottom = STATS_min
  stats file using (at($1, last, $4)) nooutput
  top = STATS_max
  set xrange [0:last]
  set yrange [0:*]
  set title name offset 0, -0.7
  if(row == 1) { set key left top samplen 1 } else { unset key }
  plot file using 1:2 with lines lw 1 lc rgb '#9ecae1' title 'cotangent, low', \
       '' using 1:3 with lines lw 1 lc rgb '#4292c6' title 'medium', \
       '' using 1:4 with lines lw 1 lc rgb '#08306b' title 'high', \
       '' using 1:8 with lines lw 4 lc rgb '#fdd0a2' title 'restricted, low', \
       '' using 1:9 with lines lw 2 lc rgb '#fd8d3c' title 'medium', \
       '' using 1:10 with lines lw 1 lc rgb '#a63603' title 'high'
  unset key
  set xrange [first:last]
  set yrange [bottom - 0.05 * (top - bottom):top + 0.45 * (top - bottom)]
  set title name.', cotangent'
  plot file using 1:2 with lines lw 1.5 lc rgb '#9ecae1', \
       '' using 1:3 with lines lw 1.5 lc rgb '#4292c6', \
       '' using 1:4 with lines lw 1.5 lc rgb '#08306b'
  set title name.', restricted'
  plot file using 1:4 with lines lw 1.5 lc rgb '#08306b', \
       '' using 1:8 with lines lw 6 lc rgb '#fdd0a2', \
       '' using 1:9 with lines lw 3 lc rgb '#fd8d3c', \
       '' using 1:10 with lines lw 1 lc rgb '#a63603'
}
unset multiplot

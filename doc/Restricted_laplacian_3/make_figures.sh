#!/usr/bin/env bash
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Usage: make_figures.sh BUILD_DIR OUTPUT_DIR
#
# Makes the pictures of the manual that show what programs and examples write, from CGAL's meshes. The
# other ones come from the benchmarks: plots/texture_stitching.sh, and the files plots/*.gp with the
# results. The drawings (*.svg) are made by hand. Needs ImageMagick.

set -euo pipefail

if [[ $# != 2 ]]; then
  sed -n '/^# Usage/,/^$/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2
  exit 2
fi
mkdir -p "$2"
outputs=$(cd "$(dirname "${BASH_SOURCE[0]}")/outputs" && pwd)
build=$(cd "$1" && pwd)
PATH="$build/bin:$build/examples/Restricted_laplacian_3:$PATH"
data=$(cd "$1/data" && pwd)
output=$(cd "$2" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

# draw PICTURE [--isolines N] [--up AXIS] PROGRAM MESH OPTION...
draw() {
  local picture=$1 look=()
  shift
  while [[ $1 == --* ]]; do
    look+=("$1" "$2")
    shift 2
  done
  "$1" "$2" --quiet --output "$picture.ply" "${@:3}"
  draw_mesh "$picture.ply" "$picture.png" "${look[@]}"
}

# side_by_side FIGURE HEIGHT PICTURE...
side_by_side() {
  montage "${@:3}" -tile x1 -geometry "x$2+12+4" -depth 8 -strip "$output/$1.png"
}

# refine MESH.off: each triangle divided into four
refine() {
  awk '
    function midpoint(i, j,   key) {
      key = i < j ? i " " j : j " " i
      if(!(key in number)) {
        number[key] = points
        for(k = 1; k <= 3; ++k) p[points, k] = (p[i, k] + p[j, k]) / 2
        ++points
      }
      return number[key]
    }
    NF == 0 || /^#/ || /OFF/ { next }
    !n_faces { points = n_points = $1; n_faces = $2; next }
    lines++ < n_points { for(k = 1; k <= 3; ++k) p[lines - 1, k] = $k; next }
    {
      a = midpoint($2, $3); b = midpoint($3, $4); c = midpoint($4, $2)
      faces = faces "3 " $2 " " a " " c "\n3 " a " " $3 " " b "\n3 " c " " b " " $4 "\n"
      faces = faces "3 " a " " b " " c "\n"
    }
    END {
      print "OFF\n" points, 4 * n_faces, 0
      for(i = 0; i < points; ++i) print p[i, 1], p[i, 2], p[i, 3]
      printf "%s", faces
    }' "$1"
}

# moved MESH.off TABLE: with the vertices of a table
moved() {
  awk -F '[, ]' '
    FNR == NR { if(/^[0-9]/) p[$1] = $2 " " $3 " " $4; next }
    NF == 0 || /^#/ || /OFF/ { print; next }
    !n { n = $1; print; next }
    v < n { print p[v++]; next }
    { print }' "$2" "$1"
}

meshes=$data/meshes
bunny=$meshes/bunny00.off
elephant=$meshes/elephant.off
lion=$meshes/lion-head.off

draw poisson --isolines 16 solve_poisson "$bunny" --depth 7
draw eigenfunction --isolines 12 laplace_spectrum "$bunny" --depth 5 --count 12 --eigenfunction 9
draw curvature estimate_curvature "$lion" --depth 6
draw signature --isolines 10 spectral_descriptors "$elephant" --depth 5 --time 0.02
side_by_side teaser 400 {poisson,eigenfunction,curvature,signature}.png

for i in 4 5 6 7; do
  draw "depth_$i" estimate_curvature "$lion" --depth "$i"
done
side_by_side depths 400 depth_{4,5,6,7}.png

for i in 1 6 14 40; do
  draw "mode_$i" laplace_spectrum "$meshes/camel.off" --count 50 --depth 6 --eigenfunction "$i"
done
side_by_side eigenfunctions 400 mode_{1,6,14,40}.png

draw screened_weak solve_poisson "$bunny" --rhs random --alpha 1 --depth 7
draw screened_strong solve_poisson "$bunny" --rhs random --alpha 300 --depth 7
side_by_side screened 400 screened_{weak,strong}.png

draw short --isolines 10 spectral_descriptors "$elephant" --depth 5 --time 0.01
draw long --isolines 10 spectral_descriptors "$elephant" --depth 5 --time 0.1
draw wave --isolines 10 spectral_descriptors "$elephant" --depth 5 --descriptor wks --energy 6
side_by_side descriptors 500 {short,long,wave}.png

draw distance --isolines 20 --property distance geodesic_distance "$elephant" --source 0
draw regions geodesic_distance "$elephant" --farthest 8 --show nearest
side_by_side distances 400 {distance,regions}.png

draw normals fit_function "$lion" --normals --depth 7
refine "$meshes/nefertiti.off" >once.off
refine once.off >twice.off
refine twice.off >thrice.off
draw edges estimate_curvature thrice.off --method coordinates --depth 7
side_by_side curvature 480 {normals,curvature,edges}.png

draw points_1 laplace_spectrum "$data/points_3/kitten.xyz" --count 6 --eigenfunction 1
draw points_4 laplace_spectrum "$data/points_3/kitten.xyz" --count 6 --eigenfunction 4
side_by_side points 400 points_{1,4}.png

# three squares on one edge, the soup of the example laplacian_of_soup
printf '%s\n' "OFF" "8 6 0" "0 0 0" "0 0 1" "1 0 0" "1 0 1" "0 1 0" "0 1 1" "-1 0 0" "-1 0 1" \
  "3 0 2 3" "3 0 3 1" "3 0 4 5" "3 0 5 1" "3 0 6 7" "3 0 7 1" >star.off
for i in 1 2 3 4 5 6; do
  refine star.off >finer.off
  mv finer.off star.off
done
for i in 1 2 4; do
  draw "soup_$i" --isolines 10 --up z laplace_spectrum star.off --count 6 --eigenfunction "$i"
done
side_by_side soup 300 soup_{1,2,4}.png

implicit_fairing "$meshes/femur.off" smooth.ply >smooth.txt
draw rough estimate_curvature "$meshes/femur.off"
draw smooth estimate_curvature smooth.ply
side_by_side smoothing 300 {rough,smooth}.png

flow_surface "$elephant" --quiet --depth 6 --steps 12 --time-step 0.01 --conformal --pictures flow_
side_by_side flow 300 flow_{00,01,03,12}.png

# vertices moved by a normal distribution
awk '
  function normal() { return sqrt(-2 * log(1 - rand())) * cos(6.283185307 * rand()) }
  BEGIN { srand(1) }
  NF == 0 || /^#/ || /OFF/ { print; next }
  !n { n = $1; print; next }
  lines++ < n { print $1 + size * normal(), $2 + size * normal(), $3 + size * normal(); next }
  { print }' size=0.0015 "$meshes/fandisk.off" >noisy.off
edit_surface noisy.off --quiet --length 0.2 --csv plain.csv
edit_surface noisy.off --quiet --length 0.2 --crease-angle 30 --csv creased.csv
moved noisy.off plain.csv >plain.off
moved noisy.off creased.csv >creased.off
for name in noisy plain creased; do
  draw_mesh "$name.off" "$name.png"
done
side_by_side editing 360 {noisy,plain,creased}.png

# what the commands write that the page of the programs shows
mkdir shown
cd shown
ln -s "$meshes"/elephant*.off .
for name in solve_poisson laplace_spectrum spectral_descriptors fit_function estimate_curvature \
  bake_scans stitch_colors; do
  awk '/^\$ / { shown = 1 } shown { sub(/^\$ /, ""); print } !/\\$/ { shown = 0 }' \
    "$outputs/$name.txt"
done >commands.sh
bash -e commands.sh >output.txt
for picture in "u --isolines 20" "u5 --isolines 12" hks normals mean colored; do
  read -r name look <<<"$picture"
  # shellcheck disable=SC2086
  draw_mesh "$name.ply" "$name.png" $look
done
montage u.png u5.png hks.png normals.png mean.png colored.png -resize 300x -geometry +12+6 -tile 3x \
  -depth 8 -strip "$output/programs.png"

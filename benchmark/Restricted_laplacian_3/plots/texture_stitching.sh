#!/usr/bin/env bash
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Makes the manual's pictures of colored meshes: stitched scans, synthetic and real ones, and a color
# map from its gradients.
#
# usage: texture_stitching.sh BUILD_DIR MESH_DIR OUTPUT_DIR
#
# BUILD_DIR is a build of the package with its examples and benchmarks, MESH_DIR the folder of shared
# meshes. Needs what scripts/install_dependencies.sh --plots installs.

set -eu -o pipefail

if [ $# -ne 3 ]; then
  echo "usage: texture_stitching.sh BUILD_DIR MESH_DIR OUTPUT_DIR" >&2
  exit 2
fi
programs=$1/bin
benchmarks=$1/benchmark/Restricted_laplacian_3
meshes=$2
output=$3
python=$([ -x /usr/bin/python3 ] && echo /usr/bin/python3 || echo python3)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir -p "$output"

draw() {
  xvfb-run -a "$python" "$(dirname "$0")/draw_colored_meshes.py" "$@"
}

stitch() { # MESH SCANS POSES OUTPUT OPTION...
  "$programs/stitch_colors" "$1" $2 --poses "$3" --output "$4" --depth 8 --quiet "${@:5}"
}

# scans whose exposures differ by up to 30 %
head=$meshes/head_male_color_18k.ply
"$programs/bake_scans" "$head" "$folder/head" --views 8 --resolution 1024 --quiet
for method in nearest gradients; do
  stitch "$head" "$folder/head/scan_*.ply" "$folder/head/poses.conf" "$folder/$method.ply" \
    --method $method
done
draw --output "$output/stitching.png" --direction=-0.7,0.2,1 --zoom 1.35 --shading 0.2 \
  "$folder/nearest.ply" "color of the nearest scan" "$folder/gradients.ply" "stitched" \
  "$folder/head/truth.ply" "truth"

# real scans, on a surface that is another one of them
scans=$(for i in 1 2 4 5; do echo "$meshes/rgbd5_scan$i.ply"; done)
for method in nearest gradients; do
  stitch "$meshes/rgbd5_scan3.ply" "$scans" "$meshes/rgbd5.conf" "$folder/room_$method.ply" \
    --frame rgbd5_scan3.ply --maximum-distance 0.2 --normal-angle 180 --method $method
done
draw --output "$output/stitching_scans.png" --direction 0,0,-1 --up 0,-1,0 --zoom 1.9 --shading 0 \
  --size 640 "$folder/room_nearest.ply" "color of the nearest scan" \
  "$folder/room_gradients.ply" "stitched"

# a color map from its gradients
"$benchmarks/gradient_integration" --mesh head_male_color_18k --depth 8 --space split \
  --write "$folder" > /dev/null
map=$folder/head_male_color_18k
draw --output "$output/gradient_integration.png" --direction=-0.7,0.2,1 --zoom 1.35 --shading 0.2 \
  --gain 20 "$map.ply" "color map" "${map}_d8_w_cycle.ply" "from its gradients, one W-cycle" \
  "${map}_d8_w_cycle.ply-$map.ply" "error, times 20"

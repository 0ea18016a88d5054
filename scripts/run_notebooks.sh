#!/usr/bin/env bash
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Usage: scripts/run_notebooks.sh [PAGE FIGURES]
#
# Runs the notebooks of python/notebooks, and writes them with their results to the page of the manual
# that holds them, or to another file PAGE with pictures in the folder FIGURES. Installs the package
# and what the notebooks use into an environment of its own; needs PyPI. MESH in the environment is a
# mesh to take in place of CGAL's elephant.

set -euo pipefail
export LC_ALL=C.UTF-8

if (($# != 0 && $# != 2)); then
  sed -n '/^# Usage/,/^$/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2
  exit 2
fi
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
page=$(realpath -m "${1:-$root/doc/Restricted_laplacian_3/Notebooks.txt}")
figures=$(realpath -m "${2:-$root/doc/Restricted_laplacian_3/fig}")
mkdir -p "$figures"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

python3 -m venv "$work/environment"
pip=("$work/environment/bin/pip" --quiet --disable-pip-version-check install)
"${pip[@]}" jupyter-client==8.6.3 nbconvert==7.16.6 ipykernel==6.30.1 matplotlib==3.10.7 \
  lapy==1.7.0 robust-laplacian==1.1.0 fast-simplification==0.2.0 neuromodes==0.1.0 scikit-learn==1.9.1
"${pip[@]}" "$root"
if [[ -z ${MESH-} ]]; then
  tar --extract --gzip --file /usr/share/doc/libcgal-dev/data.tar.gz --directory "$work" \
    data/meshes/elephant.off
  export MESH=$work/data/meshes/elephant.off
fi
cp "$root"/python/notebooks/*.ipynb "$work"
cd "$work"
for notebook in *.ipynb; do
  echo "=== $notebook"
  JUPYTER_PLATFORM_DIRS=1 timeout 600 "$work/environment/bin/jupyter" nbconvert --log-level WARN \
    --to notebook --execute --inplace "$notebook"
done
python3 "$root/python/notebooks/render.py" "$page" "$figures" first_steps.ipynb \
  spectra_under_remeshing.ipynb features_for_networks.ipynb from_scans_to_a_texture.ipynb cortex.ipynb

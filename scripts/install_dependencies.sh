#!/usr/bin/env bash
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Usage: scripts/install_dependencies.sh [--programs | --plots]
#
# Installs the Debian packages, 12 or later, that the library, its examples, benchmarks, manual and tests
# need.
# With --programs only those of the library and the examples, with --plots also those that draw what
# benchmarks have measured. Needs root or sudo, and only where a package is missing.

set -euo pipefail

packages=(
  g++ make cmake
  libcgal-dev libcgal-demo libeigen3-dev libboost-program-options-dev
  libsuitesparse-dev libopenblas-dev libspectra-dev libtbb-dev
  libopenmesh-dev libpng-dev zlib1g-dev
)
others=(
  pkg-config ccache clang llvm catch2
  libbenchmark-dev libhypre-dev libpetsc-real-dev libslepc-real-dev
  doxygen libjs-mathjax python3 python3-dev python3-venv hunspell hunspell-en-us
  chromium
)
# Node.js bundles the viewer for HTML pages. Whoever has it from elsewhere keeps it.
if ! command -v npm >/dev/null; then
  packages+=(nodejs npm)
fi
case "$*" in
  '') packages+=("${others[@]}") ;;
  --programs) ;;
  --plots) packages+=("${others[@]}" gnuplot-nox python3-vtk9 xvfb xauth) ;;
  *)
    sed -n '/^# Usage/,/^$/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2
    exit 2
    ;;
esac

# install_packages PACKAGE...: those of them that are missing
install_packages() {
  local package state missing=() as_root=()
  for package; do
    state=$(dpkg-query --show --showformat '${db:Status-Status}' "$package" 2>/dev/null || true)
    [[ $state == installed ]] || missing+=("$package")
  done
  # Small container images leave out /usr/share/doc, where CGAL's data lies.
  local data=/usr/share/doc/libcgal-dev/data.tar.gz
  local options=(-o 'Dpkg::Options::=--path-include=/usr/share/doc/libcgal-dev/*')
  if [[ ! -e $data && " ${missing[*]} " != *" libcgal-demo "* ]]; then
    missing+=(libcgal-demo)
    options+=(--reinstall)
  fi
  ((${#missing[@]} > 0)) || return 0
  if ((EUID != 0)); then
    if ! command -v sudo >/dev/null; then
      echo "Neither root nor sudo; please install: ${missing[*]}" >&2
      exit 1
    fi
    as_root=(sudo)
  fi
  "${as_root[@]}" apt-get update
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install --yes --no-install-recommends "${options[@]}" "${missing[@]}"
}

install_packages "${packages[@]}"
# The sanitizers of clang are a package with its version in the name.
if [[ $* != --programs ]]; then
  version=$(clang++ -dumpversion)
  install_packages "libclang-rt-${version%%.*}-dev"
fi

# CHOLMOD is several times slower with the reference BLAS. Debian prefers OpenBLAS as soon as it is
# installed, unless somebody has chosen another one by hand; then that choice stays.
for library in /usr/lib/*/libblas.so.3 /usr/lib/*/liblapack.so.3; do
  if [[ -e $library && $(readlink --canonicalize "$library") != *openblas* ]]; then
    name="$(basename "$library")-$(basename "$(dirname "$library")")"
    echo "Note: $library is not OpenBLAS. To change that:" \
      "update-alternatives --auto $name" >&2
  fi
done

#!/usr/bin/env bash
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Usage: pkg_config.sh PKG_CONFIG MODULE SOURCE PROGRAM COMPILER...
#
# Compiles SOURCE and links PROGRAM with what PKG_CONFIG says of MODULE, and runs it.

set -euo pipefail

if (($# < 5)); then
  sed -n '/^# Usage/,/^$/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2
  exit 2
fi
pkg_config=$1 module=$2 source=$3 program=$4
compiler=("${@:5}")
read -ra compile_options <<<"$("$pkg_config" --cflags "$module")"
read -ra link_options <<<"$("$pkg_config" --libs "$module")"
"${compiler[@]}" -std=c++17 -O0 "${compile_options[@]}" -c "$source" -o "$program.o"
"${compiler[@]}" "$program.o" -o "$program" "${link_options[@]}"
"$program"

#!/usr/bin/env bash
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Usage: make_gallery.sh PROGRAM_DIR DATA_DIR OUTPUT_DIR
#
# Makes the viewer pages of the manual's gallery: runs the commands of Gallery.txt with the programs of
# PROGRAM_DIR in a folder that begins as DATA_DIR, CGAL's meshes, and puts the pages into OUTPUT_DIR. Fails if
# a command does, or if the gallery links to a page that none of them makes.

set -euo pipefail
export LC_ALL=C

if [[ $# != 3 || ! -d $1 || ! -d $2 ]]; then
  sed -n '/^# Usage/,/^$/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2
  exit 2
fi
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
gallery=$here/Gallery.txt
programs=$(cd "$1" && pwd)
mkdir -p "$3"
output=$(cd "$3" && pwd)
source "$here/../../scripts/mesh_folder.sh"
enter_mesh_folder "$2"

sed -n '/^\\code{.sh}$/,/^\\endcode$/{/^\\/d;p}' "$gallery" >"$folder/commands.sh"
PATH="$programs:$PATH" bash -euo pipefail "$folder/commands.sh" >"$folder/log" ||
  { cat "$folder/log" >&2; exit 1; }
for page in $(sed -n 's/.*href="gallery\/\([a-z_]*\.html\)".*/\1/p' "$gallery"); do
  mv "$page" "$output"
done

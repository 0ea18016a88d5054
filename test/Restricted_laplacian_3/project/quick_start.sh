#!/usr/bin/env bash
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Usage: quick_start.sh PAGE FOLDER
#
# Does what a page of the manual says, word by word, in an empty FOLDER. A block of code after a line
# "Save as `NAME`:" is a file, one in the language {.sh} is typed, and any other one is what the
# commands of the block before it print.

set -euo pipefail
export LC_ALL=C

if [[ $# != 2 || ! -r $1 ]]; then
  sed -n '/^# Usage/,/^$/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2
  exit 2
fi
page=$1
# what the page takes for granted
data=/usr/share/doc/libcgal-dev/data.tar.gz
for needed in "$data" "$(command -v draw_mesh || true)"; do
  if [[ ! -r $needed ]]; then
    echo "SKIPPED: $data and draw_mesh are needed"
    exit
  fi
done
viewer=$(dirname "$(command -v draw_mesh)")/../../viewer/viewer.html
steps=$2.steps
rm -rf "$2" "$steps"
mkdir -p "$2" "$steps"

# a file NUMBER.KIND for each block
awk -v steps="$steps" '
  /^Save as `[^`]+`:$/ || /\. Save as `[^`]+`:$/ {
    name = $0; sub(/^.*Save as `/, "", name); sub(/`:$/, "", name)
    next
  }
  /^\\code\{/ {
    kind = name != "" ? "save_" name : $0 == "\\code{.sh}" ? "sh" : "output"
    file = sprintf("%s/%02d.%s", steps, ++number, kind); name = ""
    printf "" > file
    is_code = 1
    next
  }
  /^\\endcode/ { is_code = 0; close(file) }
  is_code { print > file }' "$page"

cd "$2"
number_of_outputs=0
printed=$steps/printed.txt
step=none
trap 'status=$?; ((status == 0)) || { echo "failed: $step"; cat "$step" "$printed"; }' EXIT
for step in "$steps"/[0-9]*; do
  case $step in
    *.save_*) cp "$step" "${step#*.save_}" ;;
    *.sh)
      if [[ ! -e $viewer ]] && grep --quiet '\.html' "$step"; then
        continue
      fi
      # not in a shell of its own: the page changes the folder
      # shellcheck disable=SC1090
      source "$step" >"$printed" 2>&1
      ;;
    *.output)
      diff "$step" "$printed"
      number_of_outputs=$((number_of_outputs + 1))
      ;;
  esac
done
step=$page
if [[ $number_of_outputs -lt 3 || "$(head -c 4 u.png)" != $'\x89PNG' ]]; then
  echo "$number_of_outputs outputs were compared, and u.png is no picture: has the page another form?"
  exit 1
fi
if [[ -e $viewer ]] && ! grep --quiet 'id="scene"' u.html; then
  echo "u.html is no page"
  exit 1
fi
echo "$number_of_outputs outputs compared"

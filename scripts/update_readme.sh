#!/usr/bin/env bash
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Usage: scripts/update_readme.sh [--check]
#
# Puts source files into README.md, each between the two lines that name it, so that what the README
# shows is what the tests compile and run. With --check changes nothing, and fails if that would change
# something.

set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
updated=$(awk '
  /^<!-- begin / {
    print
    source = $3
    print "```" (source ~ /[.]py$/ ? "python" : "cpp")
    is_shown = 0
    while((getline line < source) > 0) {
      if(source ~ /[.]cpp$/ ? line == "}" : 0) break
      if(is_shown) print substr(line, source ~ /[.]cpp$/ ? 3 : 1)
      # what follows the license, or begins main()
      else is_shown = source ~ /[.]cpp$/ ? line ~ /^int main/ : line == ""
    }
    print "```"
    skipping = 1
    next
  }
  /^<!-- end / { skipping = 0 }
  !skipping { print }' README.md)
if [[ ${1:-} == --check ]]; then
  if [[ $updated != "$(cat README.md)" ]]; then
    echo "README.md does not show the present sources: run scripts/update_readme.sh" >&2
    exit 1
  fi
else
  printf '%s\n' "$updated" >README.md
fi

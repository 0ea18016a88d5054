# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# To be sourced by scripts that test programs: how a check is written, and counted.

number_of_checks=0
number_of_failures=0

# check DESCRIPTION COMMAND...: the command must succeed
check() {
  local description=$1
  shift
  number_of_checks=$((number_of_checks + 1))
  if ! "$@" > check.log 2>&1; then
    number_of_failures=$((number_of_failures + 1))
    echo "FAILED: $description"
    sed 's/^/    /' check.log | head -n 5
  fi
}

# report_checks: says how many there were; fails if one of them did
report_checks() {
  echo "$number_of_checks checks, $number_of_failures failed"
  [ "$number_of_failures" -eq 0 ]
}

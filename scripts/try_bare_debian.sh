#!/usr/bin/env bash
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Usage: scripts/try_bare_debian.sh SUITE [COMMAND]...
#
# Tries scripts where nothing is installed: makes a Debian of its smallest variant by debootstrap, for each
# COMMAND a copy of it, and calls the command there in an archive of the last commit. SUITE is bookworm
# (Debian 12), trixie (Debian 13) or unstable. COMMAND is one of scripts/, for example test_versions.sh;
# without, the two of README.md, demo.sh and test.sh. Needs root, Debian's debootstrap and about 8 GB in
# build/bare_debian/SUITE/, where the output of each command stays. What happened goes to
# test/Restricted_laplacian_3/project/bare_debian_log.txt; the exit status is 0 if all went well. MIRROR in
# the environment is that of Debian, and JOBS the number of parallel jobs. Shared meshes are not taken
# along: tests that need one are skipped.

set -euo pipefail
export LC_ALL=C

cd "$(dirname "${BASH_SOURCE[0]}")/.."
suites=(bookworm trixie unstable)
suite=${1-}
if [[ -z $suite || " ${suites[*]} " != *" $suite "* ]]; then
  sed -n '/^# Usage/,/^$/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2
  exit 2
fi
shift
(($# > 0)) || set -- demo.sh test.sh
for name in "$@"; do
  if [[ ! -f scripts/$name ]]; then
    echo "try_bare_debian.sh: there is no scripts/$name" >&2
    exit 2
  fi
done
if ((EUID != 0)); then
  echo "try_bare_debian.sh: only root may enter another Debian" >&2
  exit 1
fi
mirror=${MIRROR:-http://deb.debian.org/debian}
folder=$PWD/build/bare_debian/$suite
base=$folder/base
log=$PWD/test/Restricted_laplacian_3/project/bare_debian_log.txt

# enter ROOT COMMAND...: with nothing of this machine but its processes, devices, names of hosts, and
# the certificates that pip and npm are told to trust
enter() {
  local root=$1 status=0 variable certificates=()
  cp /etc/resolv.conf "$root/etc/resolv.conf"
  for variable in PIP_CERT NODE_EXTRA_CA_CERTS; do
    [[ -n ${!variable-} ]] || continue
    cp "${!variable}" "$root/etc/$variable.pem"
    certificates+=("$variable=/etc/$variable.pem")
  done
  mount --bind /proc "$root/proc"
  mount --bind /sys "$root/sys"
  mount --bind /dev "$root/dev"
  env --ignore-environment HOME=/root LANG=C.UTF-8 JOBS="${JOBS:-2}" "${certificates[@]}" \
    PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
    chroot "$root" "${@:2}" </dev/null || status=$?
  umount "$root/dev" "$root/sys" "$root/proc"
  return "$status"
}

if [[ ! -e $base/complete ]]; then
  command -v debootstrap >/dev/null || apt-get install --yes --no-install-recommends debootstrap
  rm -rf "$base"
  mkdir -p "$folder"
  debootstrap --variant=minbase "$suite" "$base" "$mirror"
  if [[ $suite == unstable ]]; then # a mirror may lag behind
    echo 'Acquire::Check-Valid-Until "false";' >"$base/etc/apt/apt.conf.d/99valid"
  else
    echo "deb $mirror-security $suite-security main" >>"$base/etc/apt/sources.list"
  fi
  touch "$base/complete"
fi

touch "$log"
failed=0
commit=$(git rev-parse --short HEAD)
for command in "$@"; do
  root=$folder/$command
  umount "$root/dev" "$root/sys" "$root/proc" 2>/dev/null || true # of a run that was interrupted
  rm -rf --one-file-system "$root"
  cp -a "$base" "$root"
  mkdir "$root/root/project"
  git archive HEAD | tar -x -C "$root/root/project"
  packages=$(enter "$root" dpkg-query --show | wc -l)
  start=$SECONDS result=passed
  enter "$root" bash "/root/project/scripts/$command" >"$folder/$command.txt" 2>&1 || result=FAILED
  seconds=$((SECONDS - start))
  last=$(tail -n 1 "$folder/$command.txt")
  [[ $result == passed ]] || failed=1
  line="$result: $suite, $command, $seconds s, commit $commit, $(date -u +%F), $packages packages before,"
  line+=" $(enter "$root" dpkg-query --show | wc -l) after; its last line: $last"
  { grep -v "^[a-zA-Z]*: $suite, $command," "$log" || true; echo "$line"; } >"$log.new"
  mv "$log.new" "$log"
  [[ $result == passed ]] || tail -n 40 "$folder/$command.txt"
done
cat "$log"
exit "$failed"

#!/usr/bin/env bash
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Usage: scripts/make_debian_source.sh FOLDER
#
# Makes a Debian source package of the last commit in FOLDER, by packaging/debian/, and lets lintian check it.
# Needs dpkg-dev, xz-utils and lintian. DEBFULLNAME and DEBEMAIL in the environment are name and address of who
# maintains it, as for Debian's other tools.

set -euo pipefail
export LC_ALL=C

if (($# != 1)) || [[ $1 == -* ]]; then
  sed -n '/^# Usage/,/^$/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2
  exit 2
fi
mkdir -p "$1"
folder=$(cd "$1" && pwd)
cd "$(dirname "${BASH_SOURCE[0]}")/.."
if [[ -z ${DEBEMAIL-} ]]; then
  echo "make_debian_source.sh: say in DEBEMAIL who maintains the package" >&2
  exit 1
fi
name=restricted-laplacian-3
version=$(sed -n 's/^#define .*_VERSION_\(MAJOR\|MINOR\|PATCH\) //p' include/CGAL/Restricted_laplacian_3/version.h |
  paste -sd.)
maintainer="${DEBFULLNAME:-$(cat package_info/Restricted_laplacian_3/maintainer)} <$DEBEMAIL>"
tree=$folder/$name-$version
rm -rf "$tree"
git archive --prefix="$name-$version/" HEAD | xz >"$folder/${name}_$version.orig.tar.xz"
tar --extract --file "$folder/${name}_$version.orig.tar.xz" --directory "$folder"
cp -r "$tree/packaging/debian" "$tree/debian"
sed -i "s/@VERSION@/$version/; s/@MAINTAINER@/$maintainer/; s/@DATE@/$(git log -1 --format=%cD)/" \
  "$tree/debian/changelog" "$tree/debian/control"
(cd "$folder" && dpkg-source --build "$tree")
rm -rf "$tree"
lintian --fail-on error,warning "$folder/${name}_$version-1.dsc"
ls -l "$folder"

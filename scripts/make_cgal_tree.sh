#!/usr/bin/env bash
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Usage: scripts/make_cgal_tree.sh FOLDER [LICENSE]
#
# Lays the package out as CGAL's repository wants it: the package in FOLDER/Restricted_laplacian_3/, and
# its license in FOLDER/Installation/. FOLDER may be a clone of CGAL; then the package also enters
# CGAL's lists. Headers get CGAL's block of copyright and license, and include the license; it is that
# of the sources unless LICENSE is given, for example "GPL-3.0-or-later OR LicenseRef-Commercial",
# which only the copyright holders may grant. Tests and examples get the CMakeLists.txt of CGAL's test
# suite; tests do without Catch2, and have names that no other package has. DEBFULLNAME and DEBEMAIL in
# the environment name the maintainer, as in our packages. What an earlier call wrote is replaced.

set -euo pipefail
export LC_ALL=C

if (($# < 1 || $# > 2)); then
  echo "Usage: scripts/make_cgal_tree.sh FOLDER [LICENSE]" >&2
  exit 2
fi
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
mkdir -p "$1"
cgal=$(cd "$1" && pwd)
license=${2:-GPL-3.0-or-later}
name=Restricted_laplacian_3
title="Laplacian by Restricted Splines"
prefix=cgal:rl3-
package=$cgal/$name
own=$root/test/$name/project/cgal_tree
authors=$(<"$root/package_info/$name/maintainer")

# with_cgal_header FILE...: CGAL's comment in place of the first two lines, and the license before all
# else that is included
with_cgal_header() {
  local file
  for file in "$@"; do
    awk -v license="$license" -v name="$name" -v authors="$authors" '
      NR == 1 {
        print $0 "\n// All rights reserved.\n//\n// This file is part of CGAL (www.cgal.org)\n//"
        print "// $URL$\n// $Id$\n// SPDX-License-Identifier: " license "\n//"
        print "// Author(s)     : " authors
      }
      NR <= 2 || /^#include <CGAL\/license\// { next }
      { print }
      /^#define CGAL_.*_H$/ && !done { print "\n#include <CGAL/license/" name ".h>"; done = 1 }
    ' "$file" >"$file.new"
    mv "$file.new" "$file"
  done
}

# cmake_lists KIND [OPTION]: for the programs of the current folder
cmake_lists() {
  sed -e "s/@KIND@/$1/" -e "s/ @TESTING@/${2:+ $2}/" "$own/CMakeLists.txt.in" >CMakeLists.txt
}

# enter LIST LINE AFTER: a line into a list of CGAL, after the first line that begins with AFTER;
# nothing if it is there
enter() {
  local list=$cgal/$1
  if [[ -f $list ]] && ! grep -qxF -e "$2" "$list"; then
    line=$2 after=$3 awk '
      { print }
      !done && index($0, ENVIRON["after"]) == 1 { print ENVIRON["line"]; done = 1 }
      END { if(!done) print ENVIRON["line"] }' "$list" >"$list.new"
    mv "$list.new" "$list"
  fi
}

# bibtex FILE: our bibliography, whose entries are paragraphs: key; authors; title; where, beginning with
# a tag or an address
bibtex() {
  awk -v RS= -F'\n' -v prefix="$prefix" '
    match($1, /\\cgalBibEntry\{[^}]*\}/) {
      authors = $2
      sub(/\.$/, "", authors)
      gsub(/, and /, " and ", authors)
      gsub(/, /, " and ", authors)
      title = $3
      for(i = 4; i <= NF && $i !~ /^(<|http)/; ++i)
        title = title " " $i
      sub(/\.$/, "", title)
      where = ""
      for(; i <= NF; ++i)
        where = where (where ? " " : "") $i
      gsub(/<[^>]*>/, "", where)
      gsub(/&amp;/, "\\\\\\&", where)
      print "\n@misc{" prefix substr($1, RSTART + 14, RLENGTH - 15) ","
      print "  author = {" authors "},\n  title = {{" title "}},\n  note = {" where "}"
      print "}"
    }' "$1"
}

rm -rf "$package"
for kind in include doc examples test benchmark package_info; do
  mkdir -p "$package/$kind"
  cp -R "$root/$kind/." "$package/$kind"
done

if [[ -n ${DEBEMAIL-} ]]; then
  echo "${DEBFULLNAME-} <$DEBEMAIL>" >"$package/package_info/$name/maintainer"
fi

# what needs MPI
rm -r "$package/include/CGAL/$name/distributed" "$package/test/$name/distributed" \
  "$package/examples/$name/distributed_surface.cpp"
# The license belongs to CGAL's package Installation.
license=Installation/include/CGAL/license
mkdir -p "$cgal/$license"
mv "$package/include/CGAL/license/$name.h" "$cgal/$license"
rmdir "$package/include/CGAL/license"
enter "$license/gpl_package_list.txt" "$name $title" "QP_solver "
find "$package/include" -name "*.h" | while read -r header; do with_cgal_header "$header"; done

cd "$package/test/$name"
rm -rf project programs catch_main.cpp catch_counter.h every_test_source_holds_tests.cmake
cp "$own/catch.h" .
for test in test_*.cpp; do mv "$test" "test_RL3_${test#test_}"; done
cmake_lists Tests

# Programs are run as in the manual, those that read files of CGAL's data only.
cd "$package/examples/$name"
cmake_lists Examples NO_TESTING
for program in *.cpp; do
  program=${program%.cpp}
  output=$package/doc/$name/outputs/$program.txt
  if [[ -f $output ]]; then
    sed -n -E "1s/^\\$ $program( [^\\]*)?\$/run($program\\1)/p" "$output" |
      sed -E 's/ ([^ ()]+\.(off|xyz))/ @\1/g'
  fi
done >>CMakeLists.txt

cd "$package/benchmark/$name"
rm -rf results plots compile_times *.sh
mv studies/*.cpp .
rm -r studies
mkdir "$package/programs"
cp -R "$root/programs/support" "$package/programs" # what benchmarks share with programs
cmake_lists Benchmark NO_TESTING

# CGAL's documentation system has its own layout, and checks of its own.
cd "$package/doc/$name"
rm -f -- *.py *.cmake *.awk *.sh *.css *.xml CMakeLists.txt spelling_words.txt
bibliography=$cgal/Documentation/doc/biblio/cgal_manual.bib
mkdir -p "${bibliography%/*}"
if ! grep -qsF "{$prefix" "$bibliography"; then
  bibtex Bibliography.txt >>"$bibliography"
fi
rm Bibliography.txt
grep -rlE '\\cgal(Cite|PkgBib)\{' "$package/doc" "$package/include" |
  xargs sed -i -E "s/(\\\\cgal(Cite|PkgBib)\{)/\\1$prefix/g"
sed -i 's/\\cgalPkgLicense{[^}]*}/\\cgalPkgLicense{\\ref licensesGPL "GPL"}/' PackageDescription.txt
cat >Doxyfile.in <<END
@INCLUDE = \${CGAL_DOC_PACKAGE_DEFAULTS}
PROJECT_NAME = "CGAL \${CGAL_DOC_VERSION} - $title"

EXTRACT_ALL            = false
EXCLUDE_PATTERNS      += */internal/* *_impl.h
EXCLUDE_SYMBOLS       += CGAL::${name}::internal
EXAMPLE_PATH          += \${CGAL_PACKAGE_DOC_DIR}/outputs
END
(cd fig && printf '%s\n' ./*) | sed 's|^\./|HTML_EXTRA_FILES += ${CGAL_PACKAGE_DOC_DIR}/fig/|' >>Doxyfile.in
enter Documentation/doc/Documentation/packages.txt "\\package_listing{$name}" \
  "\\package_listing{Heat_method_3}"

echo "$package"

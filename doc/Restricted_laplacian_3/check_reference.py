#!/usr/bin/env python3
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that the Reference Manual lists every public name:
check_reference.py TAG_FILE_OF_DOXYGEN PackageDescription.txt

Each class, function, type and constant of the package is in a group, and the classified list of
PackageDescription.txt names those of a group under the title of that group, and nothing else,
unless it refers to the group as a whole.
"""

import collections
import pathlib
import re
import sys
import xml.etree.ElementTree

NAMESPACE = "CGAL::Restricted_laplacian_3"


def names_in(compound):
    """the classes and members of a namespace or group, by their names in the namespace"""
    names = {element.text for element in compound.findall("class")}
    for member in compound.findall("member"):
        if member.get("kind") != "enumvalue":
            name = member.findtext("name")  # in groups, Doxygen 1.9.8 writes all of it
            is_whole = member.get("kind") == "define" or name.startswith(f"{NAMESPACE}::")
            names.add(name if is_whole else f"{NAMESPACE}::{name}")
    return names


def main():
    tags = xml.etree.ElementTree.parse(sys.argv[1]).getroot()
    text = pathlib.Path(sys.argv[2]).read_text(encoding="utf-8")

    as_a_whole = re.findall(r"^- \\ref (\w+)$", text, re.M)
    listed = collections.defaultdict(list)
    title = None
    for line in text.split("\n"):
        section = re.match(r"\\cgalCRPSection\{(.*)\}", line)
        if section:
            title = section.group(1)
        item = re.match(r"- `([\w:]+)(\(\))?`$", line)
        if item:
            listed[title].append(item.group(1))

    errors = []
    public = set()
    grouped = set()
    for compound in tags.findall("compound"):
        kind, name = compound.get("kind"), compound.findtext("name")
        if kind == "namespace" and name == NAMESPACE:
            public |= names_in(compound)
        elif kind in ("class", "struct") and name.startswith(NAMESPACE):
            public.add(name)
        elif kind == "group":
            names = names_in(compound)
            grouped |= names
            title = compound.findtext("title")
            found = listed.pop(title, [])
            if name in as_a_whole:
                continue
            # members of members, such as a class in a class, are reached through it
            top = {name for name in names if name.rpartition("::")[0] in ("", NAMESPACE)}
            errors += [f"{name} is not in the list of '{title}'" for name in top - set(found)]
            errors += [f"{name} is not in the group '{title}'" for name in set(found) - names]
            errors += [f"{name} is in the list twice" for name in set(found)
                       if found.count(name) > 1]
    errors += [f"{name} is in no group" for name in public - grouped]
    errors += [f"there is no group '{title}'" for title in listed]

    print(f"{len(public)} public names, {len(errors)} errors")
    print(*sorted(errors), sep="\n")
    return 1 if errors or not public else 0


if __name__ == "__main__":
    sys.exit(main())

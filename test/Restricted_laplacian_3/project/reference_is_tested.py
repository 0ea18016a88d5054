#!/usr/bin/env python3
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that tests name what the Reference Manual documents:
reference_is_tested.py TAG_FILE_OF_DOXYGEN PARAMETERS_HEADER TEST_SOURCE...

A source of a unit test calls each named parameter, function and member function, reads or writes each
member variable, and names each class, constant and enumerator. Building blocks are left out, and
what is called without its name: constructors, operators and types of members.
"""

import pathlib
import re
import sys
import xml.etree.ElementTree

NAMESPACE = "CGAL::Restricted_laplacian_3::"
BUILDING_BLOCKS = "PkgRestrictedLaplacian3Dev"
# what has no meaning of its own, with the reason
EXEMPT = {
    "Multigrid::Workspace": "its vectors are those of a cycle",
    "Operator_sink::wants_stiffness": "called by the package, overridden by users",
    "Operator_sink::wants_mass": "called by the package, overridden by users",
    "Surface_integration::add_moments": "called by the package, overridden by users",
}


def pattern(kind, name, parent):
    """how a test names it"""
    name = re.escape(name)
    if kind == "function":
        return rf"\b{name}\s*[(<]"
    if kind == "variable" and parent:
        return rf"(\.|->|::){name}\b"
    return rf"\b{name}\b"


def documented(tags):
    """kind, class and name of what is documented, building blocks left out"""
    compounds = {c.findtext("name"): c for c in tags.findall("compound")}
    blocks = compounds[BUILDING_BLOCKS]
    left_out = {e.text for e in blocks.findall("class")}
    left_out |= {NAMESPACE + m.findtext("name") for m in blocks.findall("member")}
    for name, compound in compounds.items():
        if compound.get("kind") not in ("class", "struct", "namespace"):
            continue
        parent = name[len(NAMESPACE):] if name.startswith(NAMESPACE) else ""
        if name + "::" != NAMESPACE and not parent or name in left_out:
            continue
        if parent:
            yield "class", "", parent.split("::")[-1], parent
        for member in compound.findall("member"):
            kind, own = member.get("kind"), member.findtext("name")
            is_constructor = own.strip("~") == parent.split("::")[-1]
            if (kind in ("function", "variable", "enumeration", "enumvalue")
                    and member.get("protection") != "private" and not is_constructor
                    and not own.startswith("operator") and NAMESPACE + own not in left_out):
                yield kind, parent, own, f"{parent}::{own}" if parent else own


def main():
    tags = xml.etree.ElementTree.parse(sys.argv[1]).getroot()
    parameters = re.findall(r"^CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER\((\w+)\)$",
                            pathlib.Path(sys.argv[2]).read_text(encoding="utf-8"), re.M)
    tests = "\n".join(re.sub(r"//.*", "", pathlib.Path(path).read_text(encoding="utf-8"))
                      for path in sys.argv[3:])
    errors = {f"named parameter {name}" for name in parameters
              if not re.search(rf"\b(params|parameters)::{name}\(", tests)}
    number = len(parameters)
    for kind, parent, name, whole in documented(tags):
        number += 1
        exempt = whole in EXEMPT or parent in EXEMPT
        if not exempt and not re.search(pattern(kind, name, parent), tests):
            errors.add(f"{kind} {whole}")
    print(f"{number} names, {len(errors)} of them in no test")
    print(*sorted(errors), sep="\n")
    return 1 if errors or number < 100 else 0


if __name__ == "__main__":
    sys.exit(main())

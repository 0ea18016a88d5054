#!/usr/bin/env python3
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Checks what the headers of the package reach against rooms.txt, which says what is asked of them, and that
the header of the whole package reaches all public ones.

usage: headers_stay_in_their_rooms.py ROOMS INCLUDE_DIR
"""

import pathlib
import re
import sys

PACKAGE = "CGAL/Restricted_laplacian_3"
ABOUT_MESHES = re.compile(
    r"CGAL/(Surface_mesh|Polyhedron_|Linear_cell_complex|HalfedgeDS_|boost/graph/"
    r"|Polygon_mesh_processing|IO/polygon_mesh_io|AABB_)|OpenMesh/")
# what POSIX has and other systems have not, and the file that may call it
POSIX = re.compile(r"(sys/.*|arpa/.*|netinet/.*|unistd|dlfcn|fcntl|pthread|poll|dirent|termios|pwd|sched|semaphore)\.h$")
CALLS_SYSTEM = "foundation/internal/operating_system_impl.h"
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)', re.MULTILINE)


def read_rooms(path):
    """The rooms with those that they may use, also through others; and those without meshes."""
    may_use, without_meshes = {}, []
    for line in path.read_text().splitlines():
        if not line or line.startswith("#"):
            continue
        name, _, others = line.partition(":")
        if name == "without_meshes":
            without_meshes = others.split()
            continue
        allowed = {name}
        for other in others.split():
            # rooms below are listed first: so the rooms form no circle
            allowed |= may_use[other]
        may_use[name] = allowed
    return may_use, without_meshes


def room_of(header):
    folder, _, _ = header.rpartition("/")
    return folder.split("/")[0] or "top"


def reached_from(header, includes):
    """Each header that is reached, with the one that includes it."""
    includer = {header: None}
    stack = [header]
    while stack:
        current = stack.pop()
        for target in includes.get(current, []):
            if target not in includer:
                includer[target] = current
                stack.append(target)
    return includer


def way_to(header, includer):
    way = [header]
    while includer[way[-1]] is not None:
        way.append(includer[way[-1]])
    return " <- ".join(way)


def main():
    rooms_file, include_dir = map(pathlib.Path, sys.argv[1:])
    folder = include_dir / PACKAGE
    may_use, without_meshes = read_rooms(rooms_file)
    errors = []
    headers = sorted(str(p.relative_to(folder)) for p in folder.rglob("*.h"))
    if not headers:
        errors.append(f"there is no header in {folder}")
    includes = {}
    for header in headers:
        room = room_of(header)
        if room not in may_use:
            errors.append(f"{header}: is in no room")
            continue
        # the definitions of a header without which it is incomplete are one with it
        own = includes[header] = []
        for kind, target in INCLUDE.findall((folder / header).read_text()):
            if kind == '"':
                errors.append(f"{header}: write \"{target}\" with <CGAL/...>")
            elif target == PACKAGE + ".h":
                errors.append(f"{header}: includes the header of the whole package")
            elif target.startswith(PACKAGE + "/"):
                target = target[len(PACKAGE) + 1:]
                own.append(target)
                if "/internal/" in target and room_of(target) not in (room, "foundation"):
                    errors.append(f"{header}: includes {target}, which is {room_of(target)}'s own")
            elif POSIX.match(target) and header != CALLS_SYSTEM:
                errors.append(f"{header}: includes {target}, which only {CALLS_SYSTEM} may")
            elif room in without_meshes and ABOUT_MESHES.match(target):
                errors.append(f"{header}: is in {room}, without meshes, and includes {target}")

    for header in includes:
        includer = reached_from(header, includes)
        outside = {}
        for target in includer:
            room = room_of(target)
            if target not in headers:
                errors.append(f"{header}: reaches {target}, which is no file")
            elif room not in may_use[room_of(header)]:
                outside.setdefault(room, target)
        for room, target in outside.items():
            errors.append(f"{header}: is in {room_of(header)} and reaches {room}: "
                          f"{way_to(target, includer)}")
        # a header and its definitions include each other
        for target in includer:
            if target != header and not is_pair(header, target) and \
                    header in reached_from(target, includes):
                if header < target:
                    errors.append(f"{header} and {target} include each other")
    errors += missing_in_umbrella(include_dir, includes)
    for error in errors:
        print(error)
    print(f"{len(headers)} headers, {len(errors)} errors")
    return 1 if errors else 0


def missing_in_umbrella(include_dir, includes):
    """Headers with documented names that the header of the whole package does not reach, where the
    library is compiled; but those that need libraries which other ones do without."""
    declarations = {header: [t for t in targets if not t.endswith("_impl.h")]
                    for header, targets in includes.items()}
    umbrella = (include_dir / (PACKAGE + ".h")).read_text()
    declarations[""] = [target[len(PACKAGE) + 1:] for _, target in INCLUDE.findall(umbrella)]
    reached = reached_from("", declarations)
    optional = ("distributed/", "spectra/shift_invert_eigenpairs.h")
    return [f"{PACKAGE}.h does not include {header}, which is public" for header in includes
            if header not in reached and not header.startswith(optional) and
            not re.search("(^|/)(internal|shared)/|_impl.h$", header) and
            "\\ingroup" in (include_dir / PACKAGE / header).read_text()]


def is_pair(a, b):
    return a.replace("_impl.h", ".h") == b.replace("_impl.h", ".h")


if __name__ == "__main__":
    sys.exit(main())

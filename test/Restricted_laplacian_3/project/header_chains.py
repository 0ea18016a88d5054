#!/usr/bin/env python3
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Writes sources that show that every header compiles alone and twice over.

usage: header_chains.py --all|--public INCLUDE_DIR OUTPUT_DIR [HEADER LEFT OUT]...

--public leaves out what only other headers include: folders named internal or shared, and
definitions (_impl.h).

If B reaches A anyway, then B compiles alone exactly if it compiles after A: so one source that
includes A and then B is about both. A source is a chain of such headers, and there are as few chains
as can be. Definitions that a header includes only where the library is not compiled do not count, nor
does anything else that it includes under a condition. Prints the last header of each chain.
"""

import pathlib
import re
import sys

DIRECTIVE = re.compile(r"[ \t]*#[ \t]*(if|endif|include[ \t]*<(CGAL/[^>]+)>)")


def included_always(text):
    """Only the guard of the header may be around them."""
    depth = 0
    for line in text.splitlines():
        directive = DIRECTIVE.match(line)
        if not directive:
            continue
        if directive[1] == "if":
            depth += 1
        elif directive[1] == "endif":
            depth -= 1
        elif depth == 1:
            yield directive[2]


def reached(header, includes):
    """All headers that a header reaches, not itself."""
    found, stack = set(), [header]
    while stack:
        for target in includes[stack.pop()]:
            if target in includes and target not in found:
                found.add(target)
                stack.append(target)
    return found - {header}


def chains(reached_from):
    """A smallest set of chains that cover all headers: a matching of headers to what comes next."""
    before = {}

    def find_next(header, seen):
        for other in sorted(reached_from):
            if header in reached_from[other] and other not in seen:
                seen.add(other)
                if other not in before or find_next(before[other], seen):
                    before[other] = header
                    return True
        return False

    for header in sorted(reached_from):
        find_next(header, set())
    for last in sorted(set(reached_from) - set(before.values())):
        chain = [last]
        while chain[-1] in before:
            chain.append(before[chain[-1]])
        yield chain[::-1]


def main():
    is_public = sys.argv[1] == "--public"
    include_dir, output_dir = map(pathlib.Path, sys.argv[2:4])
    includes = {}
    for path in include_dir.rglob("*.h"):
        header = path.relative_to(include_dir).as_posix()
        if header not in sys.argv[4:]:
            includes[header] = list(included_always(path.read_text()))
    output_dir.mkdir(parents=True, exist_ok=True)
    names = []
    chosen = {header for header in includes
              if not is_public or not re.search("/internal/|/shared/|_impl[.]h$", header)}
    found = list(chains({header: reached(header, includes) & chosen for header in chosen}))
    if sum(map(len, found)) != len(chosen):
        sys.exit("some headers include each other")
    for chain in found:
        source = "".join(f"#include <{header}>\n" for header in chain)
        path = output_dir / (chain[-1].replace("/", "-") + ".cpp")
        if not path.exists() or path.read_text() != 2 * source:
            path.write_text(2 * source)
        names.append(chain[-1])
    print(";".join(names), end="")


if __name__ == "__main__":
    main()

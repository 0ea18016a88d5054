# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Reads results of benchmarks, and makes tables of them."""

import math
import re
from pathlib import Path

ROOT = Path(".")


# ---- results


def lines_of(result):
    path = ROOT / "benchmark/Restricted_laplacian_3/results" / (result + ".txt")
    return path.read_text().splitlines()


class Row(dict):
    """The values of a line by the names above it, and all of them in their order as `values`. `headings`: the
    comments above since the last command, of which `heading` is the last one, `command` that command, and
    `remark` the comment at the end of the line."""


def words_of(comment):
    for name in ["mean err.", "max. err.", "L2 error", "H1 error", "mean error", "iter."]:
        comment = comment.replace(name, name.replace(". ", "_").replace(" ", "_").rstrip("."))
    return comment.replace("|", "").split()


def values_of(line):
    line = line.split("# ")[0]
    for words, word in [("> ", ">"), ("restricted depth ", "depth_"), (" of vertices", " of_vertices"),
                        (" of faces", " of_faces")]:
        line = line.replace(words, word)
    return [number(v) for v in line.split()]


def rows(result, *names, comment="", command=""):
    """The lines of values under a comment with the names of columns, all `names` among them, in a part
    of the result whose command matches. `comment` filters by the last comment that names no columns."""
    found = []
    header, headings, of_part = None, [""], ""
    lines = lines_of(result)
    for line, following in zip(lines, lines[1:] + [""]):
        if line.startswith("# command:"):
            header, headings, of_part = None, [""], line[len("# command: "):]
        elif line.startswith("#"):
            words = words_of(line[1:])
            if set(names) <= set(words):
                header = words
            elif words and isinstance(number(words[0]), str) and len(words) == len(values_of(following)):
                header = None  # of another table
            else:
                headings = [*headings, line[1:].strip()]
        elif line.strip() and header:
            values = values_of(line)
            if re.search(comment, headings[-1]) and re.search(command, of_part):
                row = Row(zip(header, values))
                row.headings, row.heading, row.command = headings, headings[-1], of_part
                row.values, row.remark = values, line.partition("# ")[2]
                found.append(row)
    if not found:
        raise LookupError(f"results/{result}.txt has no rows with {names}, {comment}, {command}")
    return found


def number(text):
    try:
        return int(text)
    except ValueError:
        try:
            return float(text)
        except ValueError:
            return text


# ---- text


def seconds(x):
    return short(x)


def short(x):
    """two digits, three from 10 on"""
    if not isinstance(x, (int, float)) or math.isnan(x):
        return "-"
    if x == 0:
        return "0"
    digits = 3 if abs(x) >= 9.95 else 2
    decimals = max(0, digits - 1 - math.floor(math.log10(abs(x))))
    text = f"{x:.{decimals}f}"
    return f"{round(float(text)):,}" if decimals == 0 else text


def three_digits(x):
    return f"{x:#.3g}"


def error(x):
    if not isinstance(x, (int, float)) or math.isnan(x):
        return "-"
    text = "0" if x == 0 else re.sub(r"e([+-])0*", lambda m: "e" + m[1].replace("+", ""), f"{x:.1e}")
    return text[:-1] if text.endswith("e") else text


def power(x):
    """a tolerance"""
    return re.sub(r"\.0e|\.0$", lambda m: m[0][2:], error(x))


def whole(x):
    return f"{x:,.0f}" if isinstance(x, (int, float)) and not math.isnan(x) else "-"


def percent(x):
    """of a value in percent"""
    if not isinstance(x, (int, float)):
        return "-"
    return f"{x:.4f}" if x < 0.001 else f"{x:.3f}" if x < 0.095 else short(x) if x < 99.5 else whole(x)


def table(head, body, left=1):
    """\\param left how many columns are of text"""
    rule = ["---" if i < left else "---:" for i in range(len(head))]
    return ["| " + " | ".join(cells) + " |" for cells in [head, rule, *body]]


def pivot(corner, values, keys, columns, text, titles=None):
    """A table of one metric: a row for each key, in the order of the first appearance, and a column for
    each of `columns` (all that appear, if None). `values` yields (key, column, value); a key is a tuple
    with an element for each element of `corner`."""
    cells, seen, seen_columns = {}, [], []
    for key, column, value in values:
        if key not in seen:
            seen.append(key)
        if column not in seen_columns:
            seen_columns.append(column)
        if (key, column) in cells:
            raise ValueError(f"two values for {key}, {column}")
        cells[key, column] = value
    columns = columns or seen_columns
    missing = set(seen_columns) - set(columns)
    if missing:
        raise ValueError(f"no column for {missing}")
    titles = titles or {}
    head = [*corner, *(str(titles.get(c, c)) for c in columns)]
    body = [[*(whole(k) if isinstance(k, int) else str(k) for k in key),
             *(text(cells[key, c]) if (key, c) in cells else "" for c in columns)] for key in seen]
    return table(head, body, keys)


# ---- tables


TABLES = {}


def add_table(name, result, names, keys, column, value, text=None, left=1, columns=None, where=lambda r: True,
              **filters):
    """A table of one metric of a result, by `pivot()`.

    names    columns that the rows have, see `rows()`
    keys     the first columns of the table, by title
    column   that of the table which a row belongs to
    value    and what stands there
    Each of these is the name of a column of the result, or a function of a row."""

    def cell(what, r):
        return r.get(what, "") if isinstance(what, str) else what(r)

    TABLES[name] = lambda: pivot(
        list(keys), ((tuple(cell(k, r) for k in keys.values()), cell(column, r), cell(value, r))
                     for r in (rows(result, *names, **filters) if isinstance(result, str) else result())
                     if where(r)), left, columns, text or str)


def by_depth(r):
    return f"depth {r['depth']}"


def by_threads(r):
    return f"{r['threads']} thread" + "s" * (r["threads"] > 1)


def of(names, column="method"):
    """the name in the tables of what a column names; `{depth}` in it is the value of that column"""
    return lambda r: names[r[column]].format_map(r)


def power_of(column):
    return lambda r: power(r[column])

#!/usr/bin/env python3
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Draws the plots of README.md and of the manual, SVG files in one style, from the results of the benchmarks.

usage: plots.py [--update] ROOT

Without --update the files have to be those already: each holds what PLOTS[NAME]() draws of all rows of its
results.

Exit status: 0 if all plots are those of the results.
"""

import math
import statistics
import sys
from pathlib import Path
from xml.sax.saxutils import escape

import figures
import results
from figures import SPECTRUM
from results import rows

WIDTH, HEIGHT = 640, 420
# Colors that readers tell apart who see few of them (Okabe and Ito); markers differ, too.
STYLES = {
    "restricted": ("#0072b2", "circle"),
    "restricted_v": ("#56b4e9", "ring"),
    "smooth": ("#009e73", "diamond"),
    "smooth_v": ("#7fceb9", "open diamond"),
    "cot_cholmod": ("#d55e00", "square"),
    "cotangent": ("#d55e00", "square"),
    "cot_amg": ("#e69f00", "triangle"),
    "cot_amg_f": ("#d55e00", "square"),
}
# of methods under plots, which have less room than tables
NAMES = {
    "restricted": "flat",
    "restricted_v": "flat, values",
    "smooth": "smooth",
    "smooth_v": "smooth, values",
    "cotangent": "cotangent",
    "cot_amg_f": "AMG",
    "cot_amg": "AMG, values",
}
OF_POISSON = ["restricted", "restricted_v", "smooth", "smooth_v", "cot_amg_f", "cot_amg"]
INK, QUIET, RULE = "#1c2430", "#5b6675", "#dfe4ea"


def coordinate(x):
    return f"{x:.1f}".removesuffix(".0")


def text(x, y, words, anchor="start", color=INK, size=13, extra=""):
    return (f'<text x="{coordinate(x)}" y="{coordinate(y)}" text-anchor="{anchor}" fill="{color}" '
            f'font-size="{size}"{extra}>{escape(words)}</text>')


def line(x1, y1, x2, y2, color=RULE, extra=""):
    return (f'<line x1="{coordinate(x1)}" y1="{coordinate(y1)}" x2="{coordinate(x2)}" y2="{coordinate(y2)}" '
            f'stroke="{color}"{extra}/>')


def marker(x, y, style, size=4.2, faint=False):
    color, shape = style
    fill = f'fill="{color}"' + (' fill-opacity="0.28"' if faint else "")
    if shape == "circle":
        return f'<circle cx="{coordinate(x)}" cy="{coordinate(y)}" r="{size}" {fill}/>'
    if shape == "ring":
        opacity = ' stroke-opacity="0.4"' if faint else ""
        return (f'<circle cx="{coordinate(x)}" cy="{coordinate(y)}" r="{size - 0.8:.1f}" fill="#ffffff" '
                f'stroke="{color}" stroke-width="1.8"{opacity}/>')
    corners = {"square": [(-1, -1), (1, -1), (1, 1), (-1, 1)],
               "triangle": [(0, -1.3), (1.2, 0.9), (-1.2, 0.9)],
               "diamond": [(0, -1.4), (1.4, 0), (0, 1.4), (-1.4, 0)]}[shape.removeprefix("open ")]
    if shape.startswith("open "):
        fill = f'fill="#ffffff" stroke="{color}" stroke-width="1.6"' + (
            ' stroke-opacity="0.4"' if faint else "")
    points = " ".join(f"{coordinate(x + 0.92 * size * a)},{coordinate(y + 0.92 * size * b)}"
                      for a, b in corners)
    return f'<polygon points="{points}" {fill}/>'


def tick(value):
    """a number for a scale"""
    exponent = round(math.log10(value))
    return power_of_ten(exponent) if math.isclose(value, 10.0 ** exponent) else f"{value:g}"


def power_of_ten(exponent):
    if -2 <= exponent <= 3:
        return f"{10.0 ** exponent:g}" if exponent < 3 else "1,000"
    return "10" + "".join("⁻" if c == "-" else "⁰¹²³⁴⁵⁶⁷⁸⁹"[int(c)] for c in str(exponent))


class Scale:
    """Logarithms of numbers, in pixels."""

    def __init__(self, values, low, high):
        self.first, self.last = math.log10(min(values)), math.log10(max(values))
        margin = 0.04 * (self.last - self.first)
        self.first, self.last = self.first - margin, self.last + margin
        self.low, self.high = low, high

    def __call__(self, value):
        t = (math.log10(value) - self.first) / (self.last - self.first)
        return self.low + t * (self.high - self.low)

    def ticks(self):
        """the powers of ten, and what lies between them where there are no two"""
        powers = [10.0 ** e for e in range(math.floor(self.first), math.ceil(self.last) + 1)]
        inside = [p for p in powers if self.first <= math.log10(p) <= self.last]
        between = [p * i for p in powers for i in (1, 2, 5)]
        return inside if len(inside) > 1 else [p for p in between if self.first <= math.log10(p) <= self.last]


def page(body, title, height=HEIGHT):
    return "\n".join([
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{height}" '
        f'viewBox="0 0 {WIDTH} {height}" font-family="system-ui, Liberation Sans, Arial, sans-serif">',
        f"<title>{escape(title)}</title>",
        f'<rect width="{WIDTH}" height="{height}" rx="6" fill="#ffffff"/>',
        text(20, 28, title, size=16, extra=' font-weight="600"'), *body, "</svg>", ""])


def logarithmic(title, x_title, y_title, series, notes=(), lines=True, diagonal=False):
    """\\param series (name, style, points, faint points): a line through the points, none through faint ones"""
    left, right, top, bottom = 68, WIDTH - 20, 76, HEIGHT - 52
    shown = [p for _, _, points, faint in series for p in [*points, *faint]]
    x, y = Scale([p[0] for p in shown], left, right), Scale([p[1] for p in shown], bottom, top)
    body = [text(20, 48, y_title + " ↑, " + x_title + " →", color=QUIET)]
    for value in y.ticks():
        body += [line(left, y(value), right, y(value)), text(left - 8, y(value) + 4.5, tick(value), "end", QUIET, 12)]
    for value in x.ticks():
        body += [line(x(value), top, x(value), bottom), text(x(value), bottom + 18, tick(value), "middle", QUIET, 12)]
    if diagonal:  # where both are the same
        low = max(min(p[0] for p in shown), min(p[1] for p in shown))
        high = min(max(p[0] for p in shown), max(p[1] for p in shown))
        body.append(line(x(low), y(low), x(high), y(high), QUIET, ' stroke-width="1.5"'))
    for _, style, _, faint in series:
        body += [marker(x(a), y(b), style, 3.2, True) for a, b in faint]
    for _, style, points, _ in series:
        path = " ".join(f"{coordinate(x(a))},{coordinate(y(b))}" for a, b in points)
        if lines:
            body.append(f'<polyline points="{path}" fill="none" stroke="{style[0]}" stroke-width="2"/>')
        body += [marker(x(a), y(b), style) for a, b in points]
    at = left
    for name, style, _, _ in series:
        body += [marker(at + 5, HEIGHT - 16, style), text(at + 14, HEIGHT - 11.5, name, size=12)]
        at += 28 + 6.6 * len(name)
    body += [text(right, top - 8 - 15 * i, note, "end", QUIET, 12) for i, note in enumerate(notes)]
    return page(body, title)


def best(points):
    """of (seconds, error) those that no other one is as good as in both"""
    result = []
    for seconds, error in sorted(points):
        if not result or error < result[-1][1]:
            result.append((seconds, error))
    return result


def error_over_time(shape, problem, title, methods):
    series = []
    for method in methods:
        points = [(max(r["total_s"], 5e-4), r["error"]) for r in figures.all_runs(shape, problem)
                  if r["method"] == method and r["ok"] == "yes"]
        front = best(points)
        series.append((NAMES[method], STYLES[method], front, [p for p in points if p not in front]))
    return logarithmic(title, "seconds from mesh to values", "relative error", series)


def by_size(title, column, y_title):
    names = {"restricted": "this package", "cot_cholmod": "cotangent, CHOLMOD",
             "cot_amg": "cotangent, BoomerAMG"}
    found = [r for r in rows("depth_study", "mesh", "method", "unknowns", "MiB") if r["threads"] == 1]
    return logarithmic(title, "unknowns", y_title,
                       [(name, STYLES[method], [(r["unknowns"], max(r[column], 1e-3)) for r in found
                                                if r["method"] == method], [])
                        for method, name in names.items()], lines=False)


def by_triangles(title, column, y_title):
    found = figures.large_runs()
    styles = dict(zip(sorted({depth for _, depth in found}),
                      [STYLES[m] for m in ("restricted_v", "restricted", "smooth", "cotangent")]))
    return logarithmic(title, "triangles", y_title,
                       [(f"depth {depth}", style, [(triangles, r[column]) for (triangles, d), r in found.items()
                                                   if d == depth], []) for depth, style in styles.items()])


def estimates():
    found = [r for r in rows("estimate_study", "problem", "estimate", "ratio")
             if r["estimate"] > 0 and r["error"] > 0]
    styles = {"coordinate": "restricted", "wave": "smooth", "spectrum": "cotangent"}

    def points(problem, trusted):
        return [(r["error"], r["estimate"]) for r in found if r["problem"] == problem and r["trusted"] == trusted]

    return logarithmic("Errors on all meshes, depths 4 and 5", "error", "estimated error",
                       [(name, STYLES[style], points(name, "yes"), points(name, "no"))
                        for name, style in styles.items()], ["pale: not trusted"], lines=False, diagonal=True)


def responses():
    names = {"smooth": ("smooth_surface()", "restricted"), "sharpen": ("sharpen_surface()", "smooth"),
             "edit_0": ("edit_surface(), 0", "cot_cholmod"), "edit_2": ("edit_surface(), 2", "cot_amg")}
    found = rows("editing_peers", "what", "length", "kept", "formula")
    assert all(abs(r["kept"] / r["formula"] - 1) < 0.01 for r in found)
    return logarithmic("What remains of waves on a sphere", "wavelength over the length", "part that remains",
                       [(name, STYLES[style], sorted((r["length"], r["kept"]) for r in found if r["what"] == what), [])
                        for what, (name, style) in names.items()])


def time_by_ranks():
    found = figures.partitions()
    first = found[0]
    values = [("a cycle", "restricted", lambda r: r["cycle_ms"]),
              ("if all of it were divided", "cotangent", lambda r: first["cycle_ms"] * first["ranks"] / r["ranks"]),
              ("levels that all ranks hold", "smooth", lambda r: r["held_ms"])]
    return logarithmic("A cycle for a hundred million unknowns, by the model", "ranks", "milliseconds",
                       [(name, STYLES[style], [(r["ranks"], value(r)) for r in found], [])
                        for name, style, value in values])


def everywhere():
    """iterations, with * where the largest number was not enough"""
    for of_cycle in rows("iterations_everywhere", "mesh", "depth", "c", "unknowns"):
        for problem in list(of_cycle)[list(of_cycle).index("unknowns") + 1:]:
            its = str(of_cycle[problem])
            yield {"mesh": of_cycle["mesh"], "depth": of_cycle["depth"], "c": of_cycle["c"], "problem": problem,
                   "its": int(its.rstrip("*")), "enough": not its.endswith("*")}


def iterations_by_mesh():
    depth = 7
    found = {}
    for r in everywhere():
        if r["depth"] == depth and r["c"] == "v":
            found.setdefault(r["mesh"], []).append(r["its"])
    order = sorted(found, key=lambda mesh: (max(found[mesh]), statistics.median(found[mesh]), mesh))
    left, right, top, step = 170, WIDTH - 24, 84, 14
    height = top + step * len(order) + 40
    most = max(max(its) for its in found.values())

    def x(iterations):
        return left + (right - left) * iterations / (most + 1)

    body = [text(20, 48, f"iterations to a residual of 1e-8, V-cycles, depth {depth}: problems of many kinds "
                 "on each surface", color=QUIET)]
    for tick in range(0, most + 1, 5 if most <= 40 else 10):
        body += [line(x(tick), top - 8, x(tick), height - 36),
                 text(x(tick), top - 14, str(tick), "middle", QUIET, 12)]
    median, worst = ("#56b4e9", "ring"), ("#0072b2", "circle")
    for i, mesh in enumerate(order):
        y = top + step * (i + 0.5)
        a, b = statistics.median(found[mesh]), max(found[mesh])
        body += [text(left - 12, y + 4, mesh, "end", INK, 11), line(x(a), y, x(b), y, "#9fc8e4"),
                 marker(x(b), y, worst, 4), marker(x(a), y, median, 4)]
    body += [marker(left + 5, height - 16, median), text(left + 14, height - 11.5, "median", size=12),
             marker(left + 85, height - 16, worst), text(left + 94, height - 11.5, "worst problem", size=12)]
    return page(body, "Iterations by surface", height)


PLOTS = {
    f"plot_{problem}_{shape}": lambda s=shape, p=problem, t=title, m=methods: error_over_time(
        s, p, f"{t} on a {s}: error over time", m)
    for shape in ["sphere"]
    for problem, title, methods in [("poisson", "Poisson", OF_POISSON),
                                    ("spectrum", "30 eigenvalues", SPECTRUM)]
}
PLOTS["plot_seconds"] = lambda: by_size("Poisson on twelve meshes: time by size", "seconds", "seconds")
PLOTS["plot_memory"] = lambda: by_size("Poisson on twelve meshes: memory by size", "MiB", "MiB")
PLOTS["plot_large_seconds"] = lambda: by_triangles("Poisson, from the file to values: time by triangles", "all_s",
                                                   "seconds")
PLOTS["plot_large_memory"] = lambda: by_triangles("Poisson, from the file to values: memory by triangles",
                                                  "memory_gb", "GB")
PLOTS["plot_estimates"] = estimates
PLOTS["plot_responses"] = responses
PLOTS["plot_partition_time"] = time_by_ranks
PLOTS["plot_iterations"] = iterations_by_mesh


def main():
    arguments = sys.argv[1:]
    update = "--update" in arguments
    results.ROOT = Path(arguments[-1])
    folder = results.ROOT / "doc/Restricted_laplacian_3/fig"
    errors = 0
    for name, draw in PLOTS.items():
        file = folder / f"{name}.svg"
        drawn = draw()
        if update:
            file.write_text(drawn, encoding="utf-8")
        elif not file.exists() or file.read_text(encoding="utf-8") != drawn:
            print(f"{file.name} is not what its results say: run plots.py --update")
            errors += 1
    for file in folder.glob("plot_*.svg"):
        if file.stem not in PLOTS:
            print(f"{file.name} is drawn by nothing")
            errors += 1
    return errors > 0


if __name__ == "__main__":
    sys.exit(main())

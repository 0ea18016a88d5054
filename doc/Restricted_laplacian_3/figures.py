#!/usr/bin/env python3
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Makes the tables of README.md and of the manual's pages on measurements from the results of the
benchmarks, and checks that no other figure stands there.

usage: figures.py [--update] ROOT

A line `<!-- table: NAME -->` stands above each table, which is what TABLES[NAME]() makes of all rows of
its result; `<!-- table: text -->` above a table without measured figures. Without --update the tables
have to be those already.

A figure in the text has to be part of a sentence that facts() makes of the results, or be one of the
plain numbers of PLAIN, such as depths, which are chosen and not measured. Everything else that looks
like a measured figure is an error.

Exit status: 0 if all figures are those of the results.
"""

import math
import re
import sys
from pathlib import Path

PAGES = [
    "README.md",
    "doc/Restricted_laplacian_3/Accuracy_and_performance.txt",
    "doc/Restricted_laplacian_3/Comparison.txt",
]
# Of these pages only the tables.
TABLES_OF = ["doc/Restricted_laplacian_3/Reproduction.txt",
             "doc/Restricted_laplacian_3/Large_surfaces.txt",
             "doc/Restricted_laplacian_3/Restricted_laplacian_3.txt",
             "doc/Restricted_laplacian_3/Theory.txt"]

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


# ---- accuracy per second


METHODS = {
    "restricted": "this package, a function",
    "restricted_v": "this package, values at vertices",
    "smooth": "smooth, a function",
    "smooth_v": "smooth, values at vertices",
    "cot_cholmod": "cotangent, values, CHOLMOD",
    "cot_amg": "cotangent, values, BoomerAMG",
    "cot_cholmod_f": "cotangent, a function, CHOLMOD",
    "cot_amg_f": "cotangent, a function, BoomerAMG",
    "cotangent": "cotangent",
}
POISSON = ["restricted", "restricted_v", "smooth", "smooth_v", "cot_cholmod_f", "cot_amg_f", "cot_cholmod", "cot_amg"]
SPECTRUM = ["restricted", "smooth", "cotangent"]


def least_rows(shape, problem, is_on_one_mesh):
    """of all meshes, or of the second one"""
    return [r for r in rows("accuracy_per_second", "error", "cot/restr", command=f"--part {problem}")
            if re.match(f"{shape}, {problem}, least seconds" + (" on " if is_on_one_mesh else "$"), r.headings[-2])]


def faces_of_one_mesh(shape):
    return int(re.search(r" on (\d+) faces", least_rows(shape, "poisson", True)[0].headings[-2])[1])


def least_seconds(shape, problem, methods, is_on_one_mesh):
    names = [METHODS[m] for m in methods]
    if "restricted_v" not in methods:
        names[:2] = ["this package", "smooth"]
    found = least_rows(shape, problem, is_on_one_mesh)
    return table(["Error at most", *names],
                 [[power(r["error"]), *(seconds(r[m]) for m in methods)] for r in found], 0)


def all_runs(shape, problem):
    return [r for r in rows("accuracy_per_second", "faces", "param", command=f"--part {problem}")
            if r["shape"] == shape]


def add_errors_by_mesh(name, shape, problem, kinds):
    add_table(name, lambda: all_runs(shape, problem), (), {"Triangles": "faces"},
              lambda r: "cotangent" if r["method"].startswith("cot") else "depth " + r["param"][1], "error",
              error, 0, where=lambda r: r["method"] in kinds)


for where, is_on_one_mesh in [("", False), ("_one_mesh", True)]:
    TABLES["seconds_poisson_sphere" + where] = \
        lambda one=is_on_one_mesh: least_seconds("sphere", "poisson", POISSON, one)
    TABLES["seconds_eigenvalues_sphere" + where] = \
        lambda one=is_on_one_mesh: least_seconds("sphere", "spectrum", SPECTRUM, one)
for name, problem, kinds in [
        ("poisson_sphere", "poisson", ["cot_cholmod_f", "restricted"]),
        ("poisson_sphere_vertices", "poisson", ["cot_cholmod", "restricted_v"]),
        ("poisson_sphere_smooth", "poisson", ["smooth"]),
        ("eigenvalues_sphere", "spectrum", ["cotangent", "restricted"]),
        ("eigenvalues_sphere_smooth", "spectrum", ["smooth"])]:
    add_errors_by_mesh("error_" + name, "sphere", problem, kinds)


# ---- points


def slopes():
    """of errors over the number of samples"""
    sampling = surface = ""
    for line in lines_of("monte_carlo_convergence"):
        match = re.match(r"# (\w+), (\d+) triangles, depth (\d)", line)
        surface = f"{match[1]}, depth {match[3]}" if match else surface
        sampling = line.split()[0] if re.match(r"(independent|stratified) ", line) else sampling
        match = re.match(r"# slopes: stiffness (-[\d.]+), mass (-[\d.]+)", line)
        if match:
            yield [surface, sampling, f"{float(match[1]):.2f}", f"{float(match[2]):.2f}"]


TABLES["points_matrices"] = lambda: table(["Surface", "Samples", "Stiffness", "Mass"], slopes(), 2)


def table_points_eigenvalues():
    found = rows("monte_carlo_convergence", "points", "depth", "per_cell", "error", comment="^unit sphere")
    cells = {(r["number"], r["depth"], r["points"]): r for r in found}
    return table(["Points", "Depth", "Points in a cell", "Regular", "Random"],
                 [[whole(n), str(d), whole(cells[n, d, "regular"]["per_cell"]),
                   *(error(cells[n, d, kind]["error"]) for kind in ("regular", "random"))]
                  for n, d in sorted({(n, d) for n, d, _ in cells})], 0)


TABLES["points_eigenvalues"] = table_points_eigenvalues


def scans():
    return rows("monte_carlo_convergence", "surface", "depth", "components")


def difference_of_spectra(r):
    part = next(q for q in scans() if (q["surface"], q["space"], q["depth"]) == ("part", r["space"], r["depth"]))
    return 100 * max(abs(a / b - 1) for a, b in zip(r.values[7:], part.values[7:]))


add_table("scans_eigenvalues", scans, (), {"Elements": "space"}, by_depth, difference_of_spectra, percent,
          where=lambda r: r["surface"] == "points")


# ---- solvers


SOLVERS = {
    "ours": "this package",
    "ours_point": "this package, point Gauss-Seidel",
    "amg1_pcg": "AMG1",
    "amg2_pcg": "AMG2",
    "cgc_pcg": "AMG2, coarsening of Griebel, Metsch, Schweitzer",
    "cholmod": "CHOLMOD, METIS, OpenBLAS",
    "ic_cg": "incomplete Cholesky of Eigen",
}
SOLVER_COLUMNS = ["mesh", "depth", "solver", "tol", "total_s"]


def solver_rows(result):
    return rows(result, *SOLVER_COLUMNS)


def in_time(r, column="total_s"):
    """a value, or more than what it was stopped at"""
    text = (whole if column == "iter" else seconds)(r[column])
    return text if r["ok"] == "yes" else f"> {text}"


def iterations(r):
    return in_time(r, "iter")


def problem_of(command):
    if "--matrix mass" in command:
        return "mass matrix"
    if "--screening" in command:
        return "screened, normals"
    return "Poisson, " + re.search(r"--rhs (\w+)", command)[1]


solver = of(SOLVERS, "solver")
for name, value, threads in [("", in_time, 1), ("_two_threads", in_time, 2)]:
    add_table("same_matrix" + name, "solver_comparison_bunny", SOLVER_COLUMNS, {"Solver": solver},
              power_of("tol"), value, where=lambda r, t=threads: r["th"] == t)
add_table("same_matrix_memory", "solver_comparison_bunny", SOLVER_COLUMNS, {"Solver": solver},
          lambda r: by_threads({"threads": r["th"]}), "MiB", whole, where=lambda r: r["tol"] == 5e-3)
add_table("depth_8", "solver_comparison_depth_8", SOLVER_COLUMNS,
          {"Surface": "mesh", "Threads": "th", "Unknowns": "unknowns"}, solver, in_time)
add_table("loads", "solver_comparison_loads", SOLVER_COLUMNS,
          {"Problem": lambda r: problem_of(r.command), "Surface": "mesh"}, solver, in_time, left=2,
          where=lambda r: r["tol"] == 5e-3)
add_table("iterations", "solver_comparison_iterations", SOLVER_COLUMNS, {"Surface": "mesh"}, by_depth, iterations,
          where=lambda r: r["tol"] == 1e-8 and r["th"] == 1)


def everywhere():
    """iterations, with * where the largest number was not enough"""
    for of_cycle in rows("iterations_everywhere", "mesh", "depth", "c", "unknowns"):
        for problem in list(of_cycle)[list(of_cycle).index("unknowns") + 1:]:
            its = str(of_cycle[problem])
            yield {"mesh": of_cycle["mesh"], "depth": of_cycle["depth"], "c": of_cycle["c"], "problem": problem,
                   "its": int(its.rstrip("*")), "enough": not its.endswith("*")}


def table_iterations_worst():
    """of each surface the problem that takes the most"""
    found = {}
    for r in everywhere():
        if r["c"] == "v":
            found.setdefault(r["mesh"], {}).setdefault(r["problem"], {})[r["depth"]] = r

    def most(of_depths):
        return max(r["its"] for r in of_depths.values())

    worst = {mesh: max(problems.items(), key=lambda item: most(item[1])) for mesh, problems in found.items()}
    depths = sorted({r["depth"] for r in everywhere()})

    def text(r):
        return f"{'' if r['enough'] else '> '}{r['its']}"

    return table(["Surface", "Problem", *(f"depth {d}" for d in depths)],
                 [[f"`{mesh}`", f"`{problem}`", *(text(by[d]) if d in by else "" for d in depths)]
                  for mesh, (problem, by) in sorted(worst.items(), key=lambda item: -most(item[1][1]))[:10]], 2)


TABLES["iterations_worst"] = table_iterations_worst
add_table("tolerance", "stabilization", ["mesh", "depth", "tolerance", "L2", "H1"],
          {"Tolerance": power_of("tolerance")}, "mesh", "L2", error)
add_table("stabilization_errors", "stabilization", ["depth", "unknowns", "factor", "L2_error"],
          {"Depth": "depth"}, power_of("factor"), "L2_error", error, 0)


def table_stabilization_iterations():
    found = rows("stabilization", "mesh", "depth", "1e-04", "1e-03")
    factors = [name for name in found[0] if re.match(r"\d", name)]
    return table(["Mesh", "Depth", *(power(float(f)) for f in factors)],
                 [[r["mesh"], str(r["depth"]), *(str(r[f]).replace(">", "> ") for f in factors)] for r in found])


TABLES["stabilization_iterations"] = table_stabilization_iterations


def paper_matrix(r):
    return "paper's" if "--paper" in r.command else "default"


def is_mass(r):
    return "--matrix mass" in r.command


add_table("paper_systems", "solver_comparison_paper", SOLVER_COLUMNS,
          {"System, depth, matrix": lambda r: f"{r['mesh'].split('_')[0]}{'*' * ('--screening' in r.command)}, "
                                              f"{r['depth']}, {paper_matrix(r)}",
           "Unknowns": "unknowns"},
          of({"ours": "This package", "ours_paper": "Paper's algorithm", "amg1": "AMG1", "amg1_pcg": "AMG1",
              "amg2": "AMG2", "amg2_pcg": "AMG2"}, "solver"),
          lambda r: f"{r['setup_s']:.2f} + {r['solve_s']:.2f} ({r['iter']})",
          where=lambda r: not is_mass(r) and (r["solver"].startswith("ours") or
                                              r["solver"].endswith("_pcg") == (paper_matrix(r) == "default")))


def table_paper_fits():
    rows_of = {}
    for r in filter(is_mass, solver_rows("solver_comparison_paper")):
        rows_of.setdefault((paper_matrix(r), r["solver"]), {})[r["tol"]] = r
    return table(["Matrix, solver", "Setup", "5e-3", "residual", "1e-8", "residual"],
                 [[f"{matrix}, {solver}", f"{by[5e-3]['setup_s']:.2f}",
                   *(t for tol in (5e-3, 1e-8) for t in (f"{by[tol]['solve_s']:.2f} ({whole(by[tol]['iter'])})",
                                                         error(by[tol]["residual"])))]
                  for (matrix, solver), by in rows_of.items()])


TABLES["paper_fits"] = table_paper_fits


# ---- depths and dense meshes


def depth_rows(threads=1):
    command = "--threads 2" if threads == 2 else r"^depth_study$"
    return rows("depth_study", "mesh", "vertices", "method", "edge/h", command=command)


MESH = {"Mesh": "mesh", "Vertices": "vertices"}
depth_method = of({"restricted": "depth {depth}", "cot_cholmod": "cotangent, CHOLMOD",
                   "cot_amg": "cotangent, BoomerAMG"})
for name, value, text in [("seconds", "seconds", seconds), ("error", "error", error)]:
    add_table("depth_" + name, depth_rows, (), MESH, depth_method, value, text,
              columns=["depth 4", "depth 5", "depth 6", "depth 7", "depth 8", "cotangent, CHOLMOD",
                       "cotangent, BoomerAMG"])
for name, value, text in [("unknowns", "unknowns", whole), ("edges", "edge/h", short)]:
    add_table("depth_" + name, depth_rows, (), MESH, by_depth, value, text,
              where=lambda r: r["method"] == "restricted")
add_table("dense_seconds_two_threads", lambda: depth_rows(2), (), {"Threads": "threads"}, depth_method, "seconds",
          seconds, 0)


# ---- eigenpairs


EIGENPAIRS = ["what", "pairs", "MiB"]


def with_peers(r):
    return "--no-peer" not in r.command


def in_heading(pattern, read):
    return lambda r: read(re.search(pattern, r.heading)[1])


for name, value, text in [("seconds", "pairs", seconds), ("memory", "MiB", whole)]:
    add_table("eigenpairs_" + name, "eigensolver_comparison", EIGENPAIRS,
              {"Unknowns": "unknowns", "Pairs": in_heading(r"(\d+) pairs", int),
               "Residual asked": in_heading(r"tolerance (\S+)", lambda t: power(float(t)))},
              of({"shift_invert_cholmod": "factorization", "multigrid_eigenpairs": "multigrid"}, "what"), value,
              text, 0, ["multigrid", "factorization"], with_peers, comment=", depth ")
for name, value, text in [("seconds", lambda r: r["matrices"] + r["pairs"], seconds), ("memory", "MiB", whole),
                          ("mean", "mean_err", error), ("largest", "max_err", error)]:
    add_table("mesh_to_pairs_" + name, "eigensolver_comparison", EIGENPAIRS,
              {"Mesh": in_heading(r"(\w+)", str), "Triangles": in_heading(r"(\d+) triangles", int)},
              lambda r: r["what"].replace("_spectra", "").replace("_", " "), value, text, 1,
              ["depth 5", "depth 6", "depth 7", "cotangent"], with_peers, comment=" triangles, ")


# ---- large surfaces


LARGE = ["triangles", "depth", "all_s", "memory_gb"]
# divisions of a triangle and depth that keep the number of triangles in a cell
GROWING = [(1, 6), (2, 7), (4, 8), (8, 9)]


def large_runs():
    """the rows of the Poisson problem on PLY files, by triangles and depth"""
    return {(r["triangles"], r["depth"]): r for r in rows("large_surfaces", *LARGE)
            if "--pairs" not in r.command and "--format" not in r.command}


def growing_runs():
    found = large_runs()
    least = min(triangles for triangles, _ in found)
    return [found[least * n ** 2, depth] for n, depth in GROWING]


def millions(r):
    return f"{r['triangles'] / 1e6:.0f} million"


def microseconds(r):
    return 1e6 * r["all_s"] / r["triangles"]


def largest_of_all_depths():
    found = large_runs()
    most = max(triangles for triangles, depth in found if depth == 9)
    return [r for (triangles, _), r in found.items() if triangles == most]


def steps_of_largest():
    steps = {"read": "reading", "space": "the space", "assembly": "matrices and load", "solve": "solver",
             "values": "values at vertices"}
    return [Row(step=text, depth=r["depth"], seconds=r[step + "_s"])
            for step, text in steps.items() for r in largest_of_all_depths()]


def reading_of_formats():
    """the file of the largest STL run, in both formats"""
    for r in rows("large_surfaces", *LARGE, command="--format stl"):
        yield Row(r, format="PLY", read_s=large_runs()[r["triangles"], r["depth"]]["read_s"])
        yield Row(r, format="STL")


for name, value, text in [("seconds", "all_s", short), ("memory", "memory_gb", short),
                          ("estimates", "estimate_gb", short), ("unknowns", "unknowns", whole)]:
    add_table("large_" + name, lambda: large_runs().values(), (), {"Triangles": millions}, by_depth, value, text)
add_table("large_growing", growing_runs, (), {"Triangles": millions, "Depth": "depth"}, lambda r: "Microseconds",
          microseconds, short, 2)
add_table("large_steps", steps_of_largest, (), {"Step": "step"}, by_depth, "seconds", short)
for name, value in [("seconds", "all_s"), ("memory", "memory_gb")]:
    add_table("large_pairs_" + name, "large_surfaces", LARGE, {"Triangles": millions}, by_depth, value, short,
              command="--pairs")
add_table("large_reading", reading_of_formats, (), {"Triangles": millions}, "format", "read_s", short)


# ---- several machines


PARTITION = ["ranks", "work", "held_ms"]
DISTRIBUTED = ["ranks", "method", "setup_s", "cycle_ms"]
PRECONDITIONERS = {"patches": "this package", "boomeramg": "BoomerAMG", "boomeramg_l1": "BoomerAMG, l1",
                   "boomeramg_classical": "BoomerAMG, classical", "gamg": "GAMG", "gamg_sor": "GAMG, SOR"}
SLEPC = ["ranks", "method", "pairs", "found"]
EIGENSOLVERS = {"lobpcg": "LOBPCG", "krylovschur": "Krylov-Schur, MUMPS", "gd": "Davidson",
                "threads_2": "one process, 2 threads"}


def by_ranks(r):
    return f"{whole(r['ranks'])} rank" + "s" * (r["ranks"] > 1)


def surface_of(r):
    mesh, depth = re.search(r"(?:_study|_comparison) ([a-z]+)\S* .*--depth (\d+)", r.command).groups()
    return f"{mesh}, depth {depth}"


def like(r, **values):
    """the row with other values"""
    result = Row(r, **values)
    result.command = r.command
    return result


def lines_of_rows(found, names):
    """a row for each row of the result and each of its columns in `names`, which has their titles"""
    return [like(r, what=title, value=r[name]) for name, title in names.items() for r in found]


def partitions():
    return rows("partition_study", *PARTITION, command="--depth 12")


def of_patches():
    return [r for r in rows("distributed_comparison", *DISTRIBUTED) if r["method"] == "patches"]


def with_model(measured, counted, words):
    """what was measured beside what the study of partitions says, where both are there"""
    of_model = {(surface_of(r), r["ranks"]): r for r in rows("partition_study", *PARTITION)}
    seen = set()
    for r in of_patches():
        place = surface_of(r), r["ranks"]
        if place in of_model and place not in seen:
            seen.add(place)
            yield like(r, what=words[0], value=of_model[place][counted])
            yield like(r, what=words[1], value=r[measured])


def steps_on_ranks():
    """the Poisson problem that one process solves on threads, and several on ranks"""
    found = [r for r in rows("distributed_comparison", *DISTRIBUTED)
             if r["tolerance"] == 1e-8 and r["method"] in ("threads_2", "patches")]
    for r in found:
        r["all_s"] = r["space_s"] + r["assembly_s"] + r["setup_s"] + r["solve_s"]
    steps = {"space_s": "the space", "assembly_s": "matrices", "setup_s": "hierarchy", "solve_s": "iteration",
             "all_s": "all"}
    return sorted(lines_of_rows(found, steps), key=surface_of)


def process(r):
    return f"1 process, {r['method'][-1]} threads" if r["method"].startswith("threads") else by_ranks(r)


def if_converged(column):
    return lambda r: r[column] if r["residual"] <= 1.01 * r["tolerance"] else math.nan


def if_found(column):
    return lambda r: r[column] if r["found"] == r["pairs"] else math.nan


def has_peers(r):
    """whether others have solved the problem"""
    return "--method patches" not in r.command and "--threads" not in r.command


def of_two(r):
    """on two ranks, or by one process on two threads"""
    return r["ranks"] == 2 or r["method"] == "threads_2"


for name, names, text in [
        ("loads", {"work": "work of a cycle", "unkns": "unknowns", "fragm": "parts of triangles"}, "{:.3f}".format),
        ("unknowns", {"unknowns": "unknowns, finest level", "ghosts": "ghosts, all levels",
                      "most_gh.": "ghosts, the rank that has most"}, whole),
        ("messages", {"messages": "mean", "most_me.": "the rank that sends most"}, whole),
        ("kilobytes", {"kB": "mean", "most_kB": "the rank that sends most"}, whole),
        ("time", {"cycle_ms": "a cycle", "held_ms": "of it, levels that all ranks hold"}, whole),
        ("efficiency", {"effic": "time of one rank, divided, over time"}, "{:.2f}".format)]:
    add_table("partition_" + name, lambda names=names: lines_of_rows(partitions(), names), (), {"": "what"}, by_ranks,
              "value", text)
add_table("distributed_model", lambda: [r for r in with_model("cycle_ms", "cycle_ms", ("model", "measured"))
                                        if r["ranks"] <= 2],
          (), {"Surface": surface_of, "": "what"}, by_ranks, "value", whole, 2)
for name, column in [("messages", "messages"), ("kilobytes", "kB")]:
    add_table("distributed_" + name,
              lambda c=column: [r for r in with_model(c, c, ("counted", "sent")) if r["ranks"] > 1],
              (), {"Surface": surface_of, "": "what"}, by_ranks, "value", whole, 2)
add_table("distributed_seconds", steps_on_ranks, (), {"Surface": surface_of, "Step": "what"}, process, "value", short,
          2)
# where one problem is solved: memory is the largest up to then
add_table("distributed_memory", lambda: [r for r in steps_on_ranks() if r["what"] == "all"
                                         and "--tolerance" in r.command and not has_peers(r)], (),
          {"Surface": surface_of}, process, "mib", whole)
add_table("distributed_iterations", lambda: {(surface_of(r), r["ranks"]): r for r in of_patches()
                                             if r["tolerance"] == 1e-8}.values(),
          (), {"Surface": surface_of}, by_ranks, "iter", str)
for name, value, text in [("seconds", if_converged("solve_s"), short), ("iterations", if_converged("iter"), whole),
                          ("setup", "setup_s", short)]:
    add_table("preconditioners_" + name, "distributed_comparison", DISTRIBUTED,
              {"Surface": surface_of, "Residual": power_of("tolerance"), "": by_ranks}, of(PRECONDITIONERS), value,
              text, 3, list(PRECONDITIONERS.values()), has_peers)
add_table("preconditioners_messages", "distributed_comparison", DISTRIBUTED, {"Surface": surface_of, "": by_ranks},
          of(PRECONDITIONERS), "messages", whole, 2, list(PRECONDITIONERS.values()),
          lambda r: has_peers(r) and r["tolerance"] == 1e-8)
for name, value, text, where in [
        ("seconds", if_found("solve_s"), short, of_two), ("error", if_found("error"), error, of_two),
        # of one tolerance: memory is the largest up to then
        ("memory", "mib", whole, lambda r: of_two(r) and "--tolerance" not in r.command)]:
    add_table("distributed_pairs_" + name, "distributed_eigensolvers", SLEPC,
              {"Unknowns": "unknowns", "Pairs": "pairs", "Residual": power_of("tolerance")}, of(EIGENSOLVERS), value,
              text, 0, [e for e in EIGENSOLVERS.values() if name != "memory" or e != "Davidson"], where)
add_table("distributed_pairs_ranks", "distributed_eigensolvers", SLEPC,
          {"Unknowns": "unknowns", "Pairs": "pairs", "Residual": power_of("tolerance")}, by_ranks, if_found("solve_s"),
          short, 0, ["1 rank", "2 ranks", "4 ranks"], lambda r: r["method"] == "lobpcg" and r["pairs"] == 20,
          command="--depth 7")


# ---- assembly, compilation, evaluation


def assembly():
    names = {"mesh": "bunny", "unsplit": "bunny, not split"}
    found = rows("assembly_scaling", "surface", "triangles", "space_s", "all_s")
    return table(["Surface", "Triangles", "Depth", "Fragments", "Unknowns", "Octree", "Matrices"],
                 [[names.get(r["surface"], r["surface"]), whole(r["triangles"]), str(r["depth"]),
                   whole(r["fragments"]), whole(r["unknowns"]), seconds(r["space_s"]), seconds(r["all_s"])]
                  for r in found if r["threads"] == 1])


TABLES["assembly"] = assembly

PROGRAMS = {
    "surface_mesh alone": "`CGAL::Surface_mesh` alone",
    "read_mesh alone": "reading a mesh",
    "heat_method headers": "CGAL's heat method",
    "include_solve_poisson headers": "`solve_poisson.h`, not used, headers only",
    "include_solve_poisson compiled": "`solve_poisson.h`, not used, compiled library",
    "minimal_poisson headers": "`minimal_poisson.cpp`, headers only",
    "minimal_poisson compiled": "`minimal_poisson.cpp`, compiled library",
    "minimal_curvature headers": "`minimal_curvature.cpp`, headers only",
    "minimal_curvature compiled": "`minimal_curvature.cpp`, compiled library",
}
for name, value, text in [("seconds", "seconds", lambda x: f"{x:.1f}"), ("memory", "MiB", whole)]:
    add_table("compile_" + name, "compile_times", ["program", "mode", "option"],
              {"Program": lambda r: PROGRAMS[f"{r['program']} {r['mode']}"]}, lambda r: f"`{r['option']}`", value,
              text)
add_table("evaluation", "evaluation", ["what", "threads", "seconds"],
          {"Values of 100 functions": lambda r: r["what"].replace("_", " ")}, by_threads, "seconds", seconds)

ONE_SPACE = {"solver": "solver", "operators": "operators", "of_operators": "solver of operators",
             "tensor": "with a tensor", "steps": "each by itself", "guess": "from the step before"}
for name, value, text, kinds in [("setup", "seconds", seconds, ["solver", "operators", "of_operators", "tensor"]),
                                 ("steps", "seconds", seconds, ["steps", "guess"])]:
    add_table("one_space_" + name, "solvers_on_one_space", ["mesh", "what", "seconds", "iterations"],
              {"Mesh": "mesh"}, of(ONE_SPACE, "what"), value, text, 1, [ONE_SPACE[k] for k in kinds],
              lambda r, k=kinds: r["what"] in k)


PYTHON = {"restricted": "this, 1 thread", "restricted_2": "this, 2 threads", "libigl_superlu": "libigl, SuperLU",
          "libigl_cholmod": "libigl, CHOLMOD", "robust_superlu": "robust-laplacian, SuperLU",
          "robust_cholmod": "robust-laplacian, CHOLMOD", "lapy_superlu": "LaPy, SuperLU",
          "lapy_cholmod": "LaPy, CHOLMOD"}
for name, value, text, methods in [
        ("eigenpairs", "eigs_s", seconds, list(PYTHON)), ("poisson", "poisson_s", seconds, list(PYTHON)),
        ("eigenvalue_errors", "eigs_err", error, ["restricted", "libigl_cholmod", "robust_cholmod", "lapy_cholmod"]),
        ("changes", "change", error, ["restricted", "libigl_cholmod", "robust_cholmod", "lapy_cholmod"]),
        ("poisson_errors", "pois_err", error, ["restricted", "libigl_cholmod", "robust_cholmod", "lapy_cholmod"])]:
    add_table("python_" + name, "python_peers", ["mesh", "vertices", "method", "eigs_s"],
              {"Mesh": "mesh"}, of({m: PYTHON[m] if len(methods) > 4 else PYTHON[m].split(",")[0] for m in methods}),
              value, text, 1, None, lambda r, m=methods: r["method"] in m)


# ---- distances

DISTANCES = {
    "fast": "`fast`",
    "exact": "`exact`",
    "spline_6": "spline, depth 6",
    "spline_7": "spline, depth 7",
    "heat": "heat",
    "heat_idt": "heat, intrinsic Delaunay",
    "cgal_exact": "CGAL, exact",
}
MESH_OF_DISTANCES = {"Mesh": lambda r: f"`{r['mesh']}`", "Vertices": lambda r: whole(r["n"])}
for name, value, text in [("mean", "mean", percent), ("worst", "worst", percent), ("query", "query_s", short)]:
    add_table("distances_" + name, "distance_study", ["mesh", "n", "source", "method", "mean"], MESH_OF_DISTANCES,
              of(DISTANCES), value, text, 1, where=lambda r: r["source"] == 0)

PYTHON_DISTANCES = {"fast": "here, `fast`", "exact": "here, `exact`", "pygeodesic": "pygeodesic",
                    "potpourri3d": "potpourri3d"}
add_table("distance_peers_query", "distance_peers", ["mesh", "n", "method", "mean"], MESH_OF_DISTANCES,
          of(PYTHON_DISTANCES), "query_s", short, 1, list(PYTHON_DISTANCES.values()))


# ---- prescribed values


BOUNDARY_CASES = {
    "annulus_mixed": ("annulus", "values inside, a flux outside"), "annulus_values": ("annulus", "values"),
    "annulus_fluxes": ("annulus", "fluxes"), "sector": ("sixth of a disc", "values on the arc, no flux on its sides"),
    "half_disc": ("half of a disc", "they change on its diameter"), "l_values": ("L", "values"),
    "l_fluxes": ("L", "values at the two sides of its corner, fluxes"),
    "l_mixed": ("L", "the value 0 at one side of its corner, fluxes")}
BOUNDARY = ["boundary", "depth", "unknowns", "error", "order"]
ORDERS = {3: "3", 1: "1", 1.333: "4/3", 0.667: "2/3"}
add_table("boundary_errors", "boundary_conditions", BOUNDARY,
          {"Surface": lambda r: BOUNDARY_CASES[r["boundary"]][0],
           "Conditions": lambda r: BOUNDARY_CASES[r["boundary"]][1],
           "Order in theory": lambda r: ORDERS[r["order"]]}, by_depth, "error", error, 3)
POINTS = ["points", "depth", "value", "miss"]
add_table("one_value", "boundary_conditions", POINTS, {"Value": lambda r: short(r["value"])}, by_depth, "error", error,
          where=lambda r: r["points"] == "sphere" and r["value"] > 0)
add_table("two_sides", "boundary_conditions", POINTS, {"": lambda r: "largest error"}, by_depth, "error", error,
          where=lambda r: r["points"] == "square")


# ---- busy machines


BUSY = ["function", "alone_s", "busy", "two"]
for name, value, title in [("alone", "alone_s", "alone"), ("two", "two", "two at once")]:
    add_table("busy_" + name, "busy_machine", BUSY, {"Function": lambda r: f"`{r['function']}`"},
              lambda r, title=title: title, value, short)


# ---- ordinary shapes


SHAPES = ["family", "application", "time/line", "MiB/line"]
KINDS_OF_SHAPES = {"grid": "grids", "letter": "letters"}
SHAPE_APPLICATIONS = {"poisson": "Poisson", "screened": "screened", "spectrum": "spectra", "fit": "fits",
                      "curvature": "curvature", "gradient": "gradients", "distance": "distances",
                      "exact_distance": "exact distances"}


def shape_rows(value):
    """The largest value of families of one kind, and of spectra with all numbers of pairs."""
    found = {}
    for r in rows("shape_study_shapes", *SHAPES):
        kind, application = r["family"].split("_")[0], re.sub(r"_\d+$", "", r["application"])
        family = KINDS_OF_SHAPES.get(kind, r["family"].replace("_", " "))
        found.setdefault((family, SHAPE_APPLICATIONS[application]), []).append(r[value])
    return [((family,), application, max(v for v in values if v == v))
            for (family, application), values in found.items()]


for name, value in [("time_to_line", "time/line"), ("busy", "busy")]:
    TABLES["shapes_" + name] = lambda value=value: pivot(["Family"], shape_rows(value), 1,
                                                         list(SHAPE_APPLICATIONS.values()), short)


# ---- thin features and tessellations


def of_mesh(result, *names):
    """rows under the name of a mesh, which is the comment before those that tell more"""
    for r in rows(result, *names, comment="^reference: "):
        r["mesh"] = next(h for h in reversed(r.headings) if re.match(r"\w+: \d+ vertices", h)).split(":")[0]
        yield r


add_table("thin_largest", lambda: of_mesh("thin_features", "space", "sheets/cell"), (), {"Mesh": "mesh"},
          lambda r: f"{r['space']}, {r['depth']}",
          lambda r: "reference" if "reference" in r.remark and r["space"] == "split" else percent(r["largest_%"]))
add_table("gaps", lambda: sorted(rows("thin_features", "surface", "depth", "gap", "space", "largest_%"),
                                 key=lambda r: r["space"], reverse=True), (), {"Surface": "surface", "Gap": "gap"},
          lambda r: f"{r['space']}, {r['depth']}", "largest_%", percent, 2)
OPERATORS = {"paper": "paper's space, depth {level}", "restricted": "default space, depth {level}",
             "cotangent": "cotangent, refinements: {level}"}
add_table("needles_largest", lambda: of_mesh("spectrum_study", "operator", "largest_%"), (),
          {"Operator": of(OPERATORS, "operator")}, "mesh",
          lambda r: "reference" if "reference" in r.remark else percent(r["largest_%"]))


# ---- smooth geometry


def geometry(r):
    return f"{r['geometry']}, depth {r['depth']}"


for name, value, text in [("errors", "largest", error), ("seconds", "matrices_s", seconds)]:
    add_table("smooth_" + name, "smooth_geometry", ["shape", "geometry", "largest"],
              {"Shape": "shape", "Triangles": "triangles"}, geometry, value, text, 2,
              [f"{kind}, depth {depth}" for depth in (5, 6) for kind in ("flat", "smooth", "projected")])
TABLES["smooth_simplified"] = lambda: table(
    ["Mesh", "Vertices kept", "Triangles", "flat", "smooth", "Folded faces"],
    [[r["mesh"], f"{r['percent']} %", whole(r["triangles"]), error(r["flat"]) if r["flat"] else "-",
      error(r["smooth"]), whole(r["folded"])]
     for r in rows("smooth_geometry", "mesh", "percent", "smooth")], 1)
TABLES["smooth_curvature"] = lambda: table(
    ["Depth", "flat, median", "smooth, median", "flat, 95 %", "smooth, 95 %"],
    [[str(d), *(percent(by[d, g][c]) for c in ("median_%", "95th_%") for g in ("flat", "smooth"))]
     for by in [{(r["depth"], r["geometry"]): r for r in rows("smooth_geometry", "geometry", "depth", "median_%")}]
     for d in sorted({d for d, _ in by})], 0)


# ---- finite elements of high order


HIGH_ORDER = {
    "smooth": "this package, smooth",
    "projected": "this package, projected",
    "curved_2": "curved triangles, order 2",
    "curved_3": "order 3",
    "curved_4": "order 4",
    "trace_2": "trace, order 2",
    "trace_3": "trace, order 3",
}
for problem in ["poisson", "spectrum"]:
    TABLES[f"high_order_{problem}_sphere"] = lambda p=problem: table(
        ["Error at most", *HIGH_ORDER.values()],
        [[power(r["error"]), *(seconds(r[m]) for m in HIGH_ORDER)]
         for r in rows("ngsolve_peers", "error", "projected", comment=f"sphere, {p}, least")], 0)


# ---- curvature


SHAPE = {"Shape": "shape", "Triangulation": "triangles", "Triangles": "number"}
for value in ["H_median", "H_95"]:
    add_table("curvature_" + value, "curvature_study_accuracy", ["shape", "triangles", "H_median"], SHAPE,
              lambda r: r["method"] if r["depth"] == "-" else by_depth(r), value, percent, 2,
              ["cotangent", "depth 4", "depth 5", "depth 6", "depth 7"],
              lambda r: r["method"] in ("cotangent", "normals") and 7e4 < r["number"] < 9e4)
add_table("curvature_change_H", "curvature_study_change", ["mesh", "change", "rms_of_H"],
          {"Mesh": "mesh", "Change": "change"},
          of({"cotangent": "cotangent", "normals": "`normals`, {depth}",
              "face-normals": "`face_normals`, {depth}", "coordinates": "`coordinates`, {depth}"}),
          "rms_of_H", lambda x: "" if x == "-" else short(x), 2)


# ---- gradients and colors


GRADIENTS = {"guess": "first guess", "w_cycle": "one W-cycle", "converged": "converged",
             "details_1e-03": "with details, 1e-3", "details_1e-05": "with details, 1e-5"}
add_table("gradients_error", "gradient_integration", ["mesh", "space", "method", "rms"],
          {"Mesh": "mesh", "Space": "space", "Depth": "depth"}, of(GRADIENTS), "rms",
          lambda x: f"{x:.4f}" if x < 10 else "diverges", 2, where=lambda r: r["method"] in GRADIENTS)
STITCHING = {"nearest": "nearest scan", "chosen": "chosen scan", "paper": "paper",
             "paper+exp": "paper, matched", "bp": "back-projected", "bp+exp": "the same, matched",
             "bp+exp+det": "default"}
add_table("stitching_error", "texture_stitching", ["mesh", "lamp", "method", "contrast"],
          {"Mesh": "mesh", "Light": lambda r: "exposures and lamp" if r["lamp"] > 0 else "exposures"},
          of(STITCHING), "rms", lambda x: f"{x:.4f}", 2)


# ---- the paper


SPACES = {"cotangent": "cotangent", "paper": "paper's space", "restricted": "default space"}


def of_shapes(comment, *names):
    """of each shape once, the paper's sphere under its name"""
    found = {}
    for r in rows("spectrum_study", *names, comment=comment):
        r["shape"] = r["shape"].replace("sphere_icosahedral_depth_3", "sphere")
        if "_" not in r["shape"]:
            found[r["shape"], r.get("mesh"), r.get("operator")] = r
    return found.values()


def table_dimensions():
    paper = {}
    for line in lines_of("spectrum_study"):
        match = re.match(r"# the paper: (\w+) +\d+ +(.*)", line)
        if match:
            paper[match[1]] = [int(v) for v in match[2].split()]
    return table(["Shape, depth", "Cotangent, low", "medium", "high", "Paper's space, low", "medium", "high",
                  "Default space, low", "medium", "high"],
                 [[f"{r['shape']}, {r['depth']}",
                   *(whole(v) + (f" ({whole(paper[r['shape']][i])})" if i < 6 else "")
                     for i, v in enumerate(r.values[2:]))]
                  for r in of_shapes("^dimensions", "shape", "depth", "cotangent", "restricted")
                  if r["shape"] in paper])


TABLES["dimensions"] = table_dimensions
add_table("change", lambda: of_shapes("^relative change", "shape", "mesh", "operator", "mean_100"), (),
          {"Shape": "shape"}, lambda r: f"{SPACES[r['operator']]}, {r['mesh']}", "mean_100", error,
          where=lambda r: r["shape"] != "sphere")


def table_sphere():
    body, title = [], ""
    for line in lines_of("spectrum_study"):
        match = re.match(r"# sphere_icosahedral_depth_(\d), (\d+) vertices, (\w+), depth \d, (\d+) unknowns", line)
        if match:
            depth, vertices, operator, unknowns = match.groups()
            title = f"cotangent, {whole(int(vertices))} vertices" if operator == "cotangent" else \
                f"{SPACES[operator]}, depth {depth}"
        elif title and line.startswith("largest_abs"):
            errors = [float(v) for v in line.split()[1:]]
            row = [title, whole(int(unknowns)), error(max(errors[:6])), error(max(errors[:13]))]
            body += [row] if row not in body else []
            title = ""
    return table(["Operator", "Unknowns", r"\f$l \le 6\f$", r"\f$l \le 13\f$"], body)


TABLES["sphere"] = table_sphere
for name, value, text in [("unknowns", "unknowns", whole), ("error", "rms", lambda x: f"{x:.4f}")]:
    add_table("one_cycle_" + name, "gradient_integration", ["mesh", "space", "method", "rms"], {"Mesh": "mesh"},
              lambda r: SPACES.get(r["space"], "default space"), value, text,
              where=lambda r: r["method"] == "w_cycle" and r["depth"] == 8 and r["space"] in ("paper", "split"))
for name, value, text in [("normals", "rms", three_digits), ("normals_iterations", "iter", whole),
                          ("normals_unknowns", "unknowns", whole)]:
    add_table(name, "curvature_study_normals", ["mesh", "normals", "depth"], {"Mesh": "mesh"}, by_depth, value,
              text, where=lambda r: r["normals"] == "of_vertices")
TABLES["edges"] = lambda: table(
    ["Distance in cell widths", "Part of the area, %", r"Part of \f$\int \lvert H \rvert\f$, %",
     r"Root mean square of \f$h H\f$"],
    [[r["distance/h"], f"{r['area_%']:.2f}", f"{r['abs_H_%']:.2f}", three_digits(r["rms_of_hH"])]
     for r in rows("curvature_study_edges", "mesh", "distance/h", "rms_of_hH")])
SCREENING = {"0": "", "0.05/h^2": r", \f$\alpha = \frac{1}{20} h^{-2}\f$"}
for name, value, text, screenings in [("screening", "rms", three_digits, SCREENING),
                                      ("screening_unknowns", "unknowns", whole, ["0"])]:
    add_table(name, "normal_fitting", ["mesh", "depth", "space", "alpha"],
              {"Space": lambda r: SPACES.get(r["space"], r["space"]) + SCREENING[str(r["alpha"])]},
              lambda r: f"{r['mesh'].split('_')[0]}, {by_depth(r)}", value, text,
              where=lambda r, s=screenings: str(r["alpha"]) in s)


# ---- libigl


LIBRARIES = {"min_quad_with_fixed": "libigl, `min_quad_with_fixed()`", "spectra_eigs": "libigl, `spectra::eigs()`",
             "solve_poisson": "this package, depth {depth}", "laplace_spectrum": "this package, depth {depth}"}
for name, problem, title, value, text in [
        ("poisson_seconds", "Poisson", "seconds", "seconds", seconds),
        ("poisson_error", "Poisson", "error", "error", error),
        ("eigenvalues_seconds", "spectrum", "seconds", "seconds", seconds),
        ("eigenvalues_largest", "spectrum", "largest error", "largest", error),
        ("eigenvalues_mean", "spectrum", "mean error", "mean_error", error)]:
    add_table("libigl_" + name, "library_comparison", [problem, "depth"], {"Method": of(LIBRARIES, problem)},
              lambda r, t=title: t, value, text)


# ---- pages


# with the empty lines behind it: Markdown takes a line of text for a row
TABLE = re.compile(r"<!-- table: (\w+) -->\n+((?:\|[^\n]*\n)*)\n*")


def with_tables(text):
    """the text with its tables made again"""

    def make(match):
        if match[1] == "text":
            return match[0]
        made = TABLES[match[1]]()
        return f"<!-- table: {match[1]} -->\n\n" + "\n".join(made) + "\n\n"

    return TABLE.sub(make, text)


def without_tables(text):
    """what is left to check: prose"""
    text = re.sub(r"(?m)^//.*$", "", TABLE.sub("", text))
    text = re.sub(r"```.*?```", "", text, flags=re.S)
    text = re.sub(r"(?m)^    \S.*$", "", text)  # code of the manual
    text = re.sub(r"`[^`]*`|\]\([^)]*\)|\\cgalCite\{[^}]*\}|\\(ref|sa|page|section|subsection) \S+", "", text)
    return re.sub(r"\s+", " ", text)


# Figures that are chosen or quoted, not measured.
PLAIN = re.compile(r"""
    \b[dD]epths?\ \d(,\ \d)*(\ (and|to)\ \d)? | \b[dD]egrees?\ \d+((,|\ to|\ and)\ \d+)*
    | \\f\$.*?\\f\$ | \bC\+\+\d\d | \bv?\d+\.\d+(\.\d+)+\b | \b(19|20)\d\d\b
    | \b[Ff]irst\ \d+\ eigenvalues | \babove\ 0\b | \bnear\ 0\b | GPL-3\.0-or-later | 1e-\d\b
""", re.X)
PHRASES = [
    # programs and versions
    "bare Debian 12 or 13", "On Debian 12 or 13", "CGAL 5.5 or later, Eigen 3.4", "returns 0 only",
    "and 30 commits", "and 18 commits", "and 280 commits",
    # citations
    "by Restricting 3D Functions", "> by Restricting 3D Functions", "28(5), 1475-1484",
    "published with 10.5 seconds for 100 pairs of a mesh of 85,000 vertices", "and 18.0 to",
    "with 35.8 and 68.9 for 270,000 vertices",
    # what the benchmarks do
    "at most 15 iterations", "from 1e-6 to 1e6 over the area",
    "by less than 1e-12 if", "100 of them", "first 40", "from 5 to 8", "more than 16 unknowns", "fewer than 1/32",
    "to 30 % of", "by up to 30 %", "estimated areas of 100,000 points", "first 99", "all 99",
    "largest difference of 20 eigenvalues", "radii 1 and 0.4", "axes 1, 0.7 and 0.5", "by up to 0.3 of",
    "95th percentile", "units of 1 / (longest", "1024 times 1024 pixels", "Values of 100 functions",
    "From the mesh to 100 eigenvalues", "First 30 eigenvalues", "of 2 to 120 squares", "of 7 to 128 pairs",
    "with 7 to 128 pairs", "(times below 0.05 s", "(what is below 20 MiB",
    # counts of operations
    "takes 32 evaluations", "about 75 entries", "12 bytes an entry",
]


def span(values, text=error):
    values = sorted(values)
    low, high = text(values[0]), text(values[-1])
    return low if low == high else f"{low} to {high}"


# ---- pages


def table_of_pages(columns, text):
    return table(["Mesh", "Triangles", "Fields", *columns.values()],
                 [[r["mesh"], whole(r["triangles"]), str(r["fields"]), *(text(r[c]) for c in columns)]
                  for r in rows("viewer_pages", "mesh", "triangles", "page_MB")])


TABLES["viewer_sizes"] = lambda: table_of_pages({"page_MB": "page", "viewer_MB": "of it the viewer"}, short)
TABLES["viewer_times"] = lambda: table_of_pages(
    {"decode_ms": "decoding", "first_ms": "first picture", "picture_ms": "a picture", "frame_ms": "a frame while it turns",
     "hover_ms": "a reading"}, short)


def facts():
    """the sentences with figures, by page"""
    bunny = {(r["solver"], r["th"], r["tol"]): r for r in solver_rows("solver_comparison_bunny")}
    stabilization = rows("stabilization", "depth", "unknowns", "factor", "L2_error")
    cost = max(r["L2_error"] / q["L2_error"] for r in stabilization for q in stabilization
               if r["depth"] == q["depth"] and r["factor"] == 1e-3 and q["factor"] == 0)

    def fastest(problem, methods, is_on_one_mesh):
        """in how many rows of the tables of both shapes the cotangent Laplacian is, and this package"""
        cotangent = [m for m in methods if m.startswith("cot")]
        found = [r for s in ("sphere", "torus") for r in least_rows(s, problem, is_on_one_mesh)]

        def least(r, of_cotangent):
            return min((r[m] for m in methods if (m in cotangent) == of_cotangent and not math.isnan(r[m])),
                       default=math.inf)

        wins = sum(least(r, True) < least(r, False) for r in found)
        return wins, len(found) - wins

    poisson, poisson_one = (fastest("poisson", POISSON, one) for one in (False, True))

    def factors(problem, t):
        """by how much the faster of the peers that arrive is slower, over the surfaces"""
        found = {}
        for r in solver_rows("solver_comparison_loads"):
            if problem_of(r.command) == problem and r["tol"] == t:
                ours, peers = found.setdefault(r["mesh"], ([], []))
                (ours if r["solver"] == "ours" else peers).append(
                    r["total_s"] if r["ok"] == "yes" else math.inf)
        return span((min(peers) / ours[0] for ours, peers in found.values()), lambda x: f"{x:.1f}")

    shapes = rows("shape_study_shapes", *SHAPES)
    paths = rows("distance_study_paths", "mesh", "method", "paths", "long")
    of_points = rows("distance_study_points", "mesh", "n", "source", "method", "mean")
    by_mesh = {}
    for r in depth_rows():
        by_mesh.setdefault(r["mesh"], []).append(r)
    at_default = []
    for group in by_mesh.values():
        ours = [r for r in group if r["method"] == "restricted" and 5 <= r["depth"] <= 8]
        default = next((r for r in ours if r["edge/h"] >= 0.5), ours[-1])
        peers = [r for r in group if r["method"] != "restricted"]
        at_default.append((min(r["error"] for r in peers) / default["error"],
                           default["seconds"] / min(r["seconds"] for r in peers)))
    depth_text = (
        f"At the default depth the error is below that of the cotangent Laplacian on "
        f"{sum(gain > 1 for gain, _ in at_default)} of the {len(at_default)} meshes, by a factor of "
        f"{span((gain for gain, _ in at_default), lambda x: f'{x:.2g}')}, in "
        f"{span((loss for _, loss in at_default), lambda x: f'{x:.2g}')} times the time"
    )

    largest = next(r for r in largest_of_all_depths() if r["depth"] == 9)
    vertices = re.search(r"(\d+) vertices", "\n".join(lines_of("library_comparison")))[1]
    return {
        "README.md": [
            f"Where each method chooses its mesh, the cotangent Laplacian is the fastest in {poisson[0]} of the "
            f"{sum(poisson)} rows of the Poisson tables, on a given mesh in {poisson_one[0]} of {sum(poisson_one)}",
            f"The bunny takes {bunny['ours', 1, 1e-8]['iter']} iterations to a residual of 1e-8",
            f"Reading 100 million triangles and solving at depth 9 takes {short(largest['all_s'])} s and "
            f"{short(largest['memory_gb'])} GB",
        ],
        "doc/Restricted_laplacian_3/Accuracy_and_performance.txt": [
            f"up to {cost:.1f} times the error",
            depth_text,
            f"Of the {sum(poisson)} rows of the Poisson tables the cotangent Laplacian is the fastest in "
            f"{poisson[0]}, this package in {poisson[1]}",
            f"{whole(faces_of_one_mesh('sphere'))} triangles on the sphere",
            f"Of these {sum(poisson_one)} rows the cotangent Laplacian is the fastest in {poisson_one[0]}, this "
            f"package in {poisson_one[1]}",
            f"To 5e-3 the faster of both takes {factors('Poisson, x', 5e-3)} times as long as this package for "
            f"the right-hand side, {factors('Poisson, random', 5e-3)} times for a random one, "
            f"{factors('Poisson, normals', 5e-3)} times for the divergence of a field, "
            f"{factors('screened, normals', 5e-3)} times for a screened problem, and "
            f"{factors('mass matrix', 5e-3)} times for a mass matrix",
            f"{sum(r['long'] for r in paths) or 'none'} of {whole(sum(r['paths'] for r in paths))} paths is longer by "
            "a thousandth",
            f"with mean errors of {span((r['mean'] for r in of_points), percent)} %",
            f"Of {whole(sum(r['trials'] for r in shapes))} trials {sum(r['wrong'] for r in shapes) or 'none'} had a "
            "wrong result",
        ],
        "doc/Restricted_laplacian_3/Comparison.txt": [
            f"with {whole(int(vertices))} vertices",
        ],
    }


def unknown_figures(text, sentences):
    """the figures of a page that are neither of a sentence nor plain, and the sentences that it lacks"""
    prose = re.sub(r"<img [^>]*>", "", without_tables(text))
    lacking = [s for s in sentences if s not in prose]
    for known in [*sentences, *PHRASES]:
        prose = prose.replace(known, "")
    prose = PLAIN.sub("", prose)
    return [prose[max(0, m.start() - 40):m.end() + 20]
            for m in re.finditer(r"(?<![A-Za-z_\d])\d[\d.,]*", prose)], lacking


def main(arguments):
    global ROOT
    is_update = arguments[:1] == ["--update"]
    ROOT = Path(arguments[-1])
    errors = 0
    sentences = facts()
    for page in [*PAGES, *TABLES_OF]:
        text = (ROOT / page).read_text()
        try:
            made = with_tables(text)
        except (KeyError, LookupError, ValueError) as e:
            print(f"{page}: {type(e).__name__}: {e}")
            return 1
        lines = TABLE.sub("", text).splitlines()
        for line in lines if page in PAGES else []:
            if re.match(r"\|", line):
                print(f"{page}: a table without a name: {line}")
                errors += 1
        unknown, lacking = unknown_figures(text, sentences[page]) if page in PAGES else ([], [])
        for figure in unknown:
            print(f"{page}: no result has this figure: ...{figure}...")
        for sentence in lacking:
            print(f"{page}: the results say: {sentence}")
        errors += len(unknown) + len(lacking)
        if made != text:
            if is_update:
                (ROOT / page).write_text(made)
                print(f"{page}: written")
            else:
                for old, new in zip(text.splitlines(), made.splitlines()):
                    if old != new:
                        print(f"{page}: in place of\n{old}\nthe results say\n{new}")
                        break
                errors += 1
    return errors > 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

#!/usr/bin/env python3
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Makes the tables of README.md and of the manual's pages on measurements from the results of the
benchmarks, and checks that no other figure stands there.

usage: figures.py [--update] ROOT

A line `<!-- table: NAME -->` stands above each table, which is what table_NAME() makes of all rows of
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
# Of these pages only the tables that are made here; reproduction_agrees_with_results.awk checks others.
TABLES_OF = ["doc/Restricted_laplacian_3/Reproduction.txt",
             "doc/Restricted_laplacian_3/Restricted_laplacian_3.txt",
             "doc/Restricted_laplacian_3/Theory.txt"]

ROOT = Path(".")


# ---- results


def lines_of(result):
    path = ROOT / "benchmark/Restricted_laplacian_3/results" / (result + ".txt")
    return path.read_text().splitlines()


class Row(dict):
    """the values of a line by the names above it, and the comments that it stands under"""


def words_of(comment):
    for name in ["mean err.", "max. err.", "L2 error", "H1 error", "mean error", "iter."]:
        comment = comment.replace(name, name.replace(". ", "_").replace(" ", "_").rstrip("."))
    return comment.replace("|", "").split()


def values_of(line):
    line = line.split("# ")[0].replace("> ", ">").replace("restricted depth ", "depth_")
    return [number(v) for v in line.split()]


def rows(result, *names, comment="", command=""):
    """The lines of values under a comment with the names of columns, all `names` among them, in a part
    of the result whose command matches. `comment` filters by the last comment that names no columns."""
    found = []
    header, heading, of_part = None, "", ""
    lines = lines_of(result)
    for line, following in zip(lines, lines[1:] + [""]):
        if line.startswith("# command:"):
            header, heading, of_part = None, "", line[len("# command: "):]
        elif line.startswith("#"):
            words = words_of(line[1:])
            if set(names) <= set(words):
                header = words
            elif words and isinstance(number(words[0]), str) and len(words) == len(values_of(following)):
                header = None  # of another table
            else:
                heading = line[1:].strip()
        elif line.strip() and header:
            if re.search(comment, heading) and re.search(command, of_part):
                row = Row(zip(header, values_of(line)))
                row.heading, row.command = heading, of_part
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


def error(x):
    if not isinstance(x, (int, float)) or math.isnan(x):
        return "-"
    return "0" if x == 0 else re.sub(r"e([+-])0*", lambda m: "e" + m[1].replace("+", ""), f"{x:.1e}")


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


# ---- accuracy per second


METHODS = {
    "restricted": "this package, a function",
    "restricted_v": "this package, values at vertices",
    "cot_cholmod": "cotangent, CHOLMOD",
    "cot_amg": "cotangent, BoomerAMG",
    "cotangent": "cotangent",
}


def least_seconds(shape, problem, methods):
    of_shape, heading = [], ""
    for line in lines_of("accuracy_per_second"):
        match = re.match(r"# (\w+), (\w+), least seconds", line)
        if match:
            heading = match.groups()
        elif re.match(r"# \w+, \w+, all", line):
            heading = ""
        elif heading == (shape, problem) and line.strip() and not line.startswith("#"):
            of_shape.append([float(v) for v in line.split()])
    names = [METHODS[m] for m in methods]
    if "restricted_v" not in methods:
        names[0] = "this package"
    return table(["Error at most", *names],
                 [[power(r[0]), *(seconds(x) for x in r[1:1 + len(methods)])] for r in of_shape], 0)


POISSON = ["restricted", "restricted_v", "cot_cholmod", "cot_amg"]


def table_seconds_poisson_sphere():
    return least_seconds("sphere", "poisson", POISSON)


def table_seconds_poisson_torus():
    return least_seconds("torus", "poisson", POISSON)


def table_seconds_eigenvalues_sphere():
    return least_seconds("sphere", "spectrum", ["restricted", "cotangent"])


def table_seconds_eigenvalues_torus():
    return least_seconds("torus", "spectrum", ["restricted", "cotangent"])


def all_runs(shape, problem):
    return [r for r in rows("accuracy_per_second", "faces", "param", command=f"--part {problem}")
            if r["shape"] == shape]


def errors_by_mesh(shape, problem, kinds):
    def column(r):
        return "cotangent" if r["method"].startswith("cot") else "depth " + r["param"][1]

    return pivot(["Triangles"],
                 (((r["faces"],), column(r), r["error"]) for r in all_runs(shape, problem)
                  if r["method"] in kinds), 0, None, error)


def table_error_poisson_sphere():
    return errors_by_mesh("sphere", "poisson", ["cot_cholmod", "restricted"])


def table_error_poisson_torus():
    return errors_by_mesh("torus", "poisson", ["cot_cholmod", "restricted"])


def table_error_poisson_sphere_vertices():
    return errors_by_mesh("sphere", "poisson", ["cot_cholmod", "restricted_v"])


def table_error_poisson_torus_vertices():
    return errors_by_mesh("torus", "poisson", ["cot_cholmod", "restricted_v"])


def table_error_eigenvalues_sphere():
    return errors_by_mesh("sphere", "spectrum", ["cotangent", "restricted"])


def table_error_eigenvalues_torus():
    return errors_by_mesh("torus", "spectrum", ["cotangent", "restricted"])


# ---- points


def table_points_matrices():
    surface = ""
    body = []
    for line in lines_of("monte_carlo_convergence"):
        match = re.match(r"# (\w+), (\d+) triangles, depth (\d)", line)
        if match:
            surface = f"{match[1]}, depth {match[3]}"
        match = re.match(r"(independent|stratified) ", line)
        sampling = match[1] if match else sampling if surface else ""
        match = re.match(r"# slopes: stiffness (-[\d.]+), mass (-[\d.]+)", line)
        if match:
            body.append([surface, sampling, f"{float(match[1]):.2f}", f"{float(match[2]):.2f}"])
    return table(["Surface", "Samples", "Stiffness", "Mass"], body, 2)


def table_points_eigenvalues():
    found = rows("monte_carlo_convergence", "points", "depth", "per_cell", "error", comment="^unit sphere")
    cells = {(r["number"], r["depth"], r["points"]): r for r in found}
    return table(["Points", "Depth", "Points in a cell", "Regular", "Random"],
                 [[whole(n), str(d), whole(cells[n, d, "regular"]["per_cell"]),
                   *(error(cells[n, d, kind]["error"]) for kind in ("regular", "random"))]
                  for n, d in sorted({(n, d) for n, d, _ in cells})], 0)


def table_points_areas():
    values = []
    for line in lines_of("monte_carlo_convergence"):
        match = re.match(r"(sphere|torus) +(regular|random) +(\d+) +(\S+) +\S+ +\S+$", line)
        if match:
            values.append(((match[1], match[2]), f"{match[3]} neighbors", float(match[4])))
    return pivot(["Surface", "Points"], values, 2, None, error)


def scans():
    found = []
    for line in lines_of("monte_carlo_convergence"):
        match = re.match(r"(points|part|whole) (split|unsplit) +(\d) +(\d+) +(\d+) +(\S+) +(\S+) +(.*)", line)
        if match:
            found.append((match[1], match[2], int(match[3]), match[6], match[7],
                          [float(v) for v in match[8].split()]))
    return found


def table_scans_eigenvalues():
    part = {(space, depth): values for what, space, depth, _, _, values in scans() if what == "part"}
    return pivot(["Elements"],
                 (((space,), f"depth {depth}",
                   100 * max(abs(a / b - 1) for a, b in zip(values, part[space, depth])))
                  for what, space, depth, _, _, values in scans() if what == "points"), 1, None, percent)


def table_scans_poisson():
    return pivot(["Elements"], (((space,), f"depth {depth}", 100 * float(difference))
                                for what, space, depth, _, difference, _ in scans() if what == "points"),
                 1, None, percent)


def table_scans_density():
    return pivot(["Elements"], (((space,), f"depth {depth}", float(per_cell))
                                for what, space, depth, per_cell, _, _ in scans() if what == "points"),
                 1, None, whole)


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


def solver_rows(result, **filters):
    return rows(result, "mesh", "depth", "solver", "tol", "total_s", **filters)


def in_time(r, column="total_s"):
    """a value, or more than what it was stopped at"""
    text = (whole if column == "iter" else seconds)(r[column])
    return text if r["ok"] == "yes" else f"> {text}"


def same_matrix(threads):
    return pivot([f"Solver"], (((SOLVERS[r["solver"]],), power(r["tol"]), in_time(r))
                               for r in solver_rows("solver_comparison_bunny") if r["th"] == threads),
                 1, None, str)


def table_same_matrix():
    return same_matrix(1)


def table_same_matrix_two_threads():
    return same_matrix(2)


def table_same_matrix_iterations():
    return pivot(["Solver"], (((SOLVERS[r["solver"]],), power(r["tol"]), in_time(r, "iter"))
                              for r in solver_rows("solver_comparison_bunny") if r["th"] == 1),
                 1, None, str)


def table_same_matrix_memory():
    return pivot(["Solver"], (((SOLVERS[r["solver"]],), f"{r['th']} thread" + "s" * (r["th"] > 1), r["MiB"])
                              for r in solver_rows("solver_comparison_bunny") if r["tol"] == 5e-3),
                 1, None, whole)


def table_depth_8():
    return pivot(["Surface", "Threads", "Unknowns"],
                 (((r["mesh"], r["th"], r["unknowns"]), SOLVERS[r["solver"]], in_time(r))
                  for r in solver_rows("solver_comparison_depth_8")), 1, None, str)


def table_depth_8_iterations():
    return pivot(["Surface", "Threads"],
                 (((r["mesh"], r["th"]), SOLVERS[r["solver"]], in_time(r, "iter"))
                  for r in solver_rows("solver_comparison_depth_8")), 1, None, str)


def problem_of(command):
    if "--matrix mass" in command:
        return "mass matrix"
    if "--screening" in command:
        return "screened, normals"
    return "Poisson, " + re.search(r"--rhs (\w+)", command)[1]


def table_loads():
    return pivot(["Problem", "Surface", "Residual"],
                 (((problem_of(r.command), r["mesh"], power(r["tol"])), SOLVERS[r["solver"]], in_time(r))
                  for r in solver_rows("solver_comparison_loads")), 3, None, str)


def table_iterations():
    return pivot(["Surface"], (((r["mesh"],), f"depth {r['depth']}", in_time(r, "iter"))
                               for r in solver_rows("solver_comparison_iterations")
                               if r["tol"] == 1e-8 and r["th"] == 1), 1, None, str)


def table_iterations_paper():
    return pivot(["Surface"], (((r["mesh"],), f"depth {r['depth']}", in_time(r, "iter"))
                               for r in solver_rows("solver_comparison_iterations")
                               if r["tol"] == 5e-3 and r["th"] == 1), 1, None, str)


def table_tolerance():
    found = rows("stabilization", "mesh", "depth", "tolerance", "L2", "H1")
    return pivot(["Tolerance"], (((power(r["tolerance"]),), r["mesh"], r["L2"]) for r in found), 1, None, error)


def table_tolerance_gradients():
    found = rows("stabilization", "mesh", "depth", "tolerance", "L2", "H1")
    return pivot(["Tolerance"], (((power(r["tolerance"]),), r["mesh"], r["H1"]) for r in found), 1, None, error)


def table_stabilization_iterations():
    values = []
    for line in lines_of("stabilization"):
        if line.startswith("# mesh ") and "tolerance" not in line:
            factors = [power(float(c)) for c in line.split()[4:]]
        match = re.match(r"(\w+) +(\d) +(\d+) ((?: *>? *\d+)+)$", line)
        if match and not match[1].isdigit():
            values += [((match[1], int(match[2])), f, v.replace(">", "> "))
                       for f, v in zip(factors, re.findall(r">? *\d+", match[4].replace("> ", ">")))]
    return pivot(["Mesh", "Depth"], [(k, f, v.strip()) for k, f, v in values], 1, None, str)


def table_stabilization_errors():
    found = rows("stabilization", "depth", "unknowns", "factor", "L2_error")
    return pivot(["Depth"], (((r["depth"],), power(r["factor"]), r["L2_error"]) for r in found), 0, None, error)


def paper_rows(is_mass):
    for r in solver_rows("solver_comparison_paper"):
        if ("--matrix mass" in r.command) == is_mass:
            yield ("paper's" if "--paper" in r.command else "default"), r


def table_paper_systems():
    titles = {"ours": "This package", "ours_paper": "Paper's algorithm", "amg1": "AMG1", "amg2": "AMG2"}
    values = []
    for matrix, r in paper_rows(False):
        is_pcg = r["solver"].endswith("_pcg")
        if r["solver"].startswith("ours") or is_pcg == (matrix == "default"):
            mesh = r["mesh"].split("_")[0] + "*" * ("--screening" in r.command)
            values.append(((f"{mesh}, {r['depth']}, {matrix}", r["unknowns"]),
                           titles[r["solver"].replace("_pcg", "")],
                           f"{r['setup_s']:.2f} + {r['solve_s']:.2f} ({r['iter']})"))
    return pivot(["System, depth, matrix", "Unknowns"], values, 1, list(titles.values()), str)


def table_paper_fits():
    rows_of = {}
    for matrix, r in paper_rows(True):
        rows_of.setdefault((matrix, r["solver"]), {})[r["tol"]] = r
    return table(["Matrix, solver", "Setup", "5e-3", "residual", "1e-8", "residual"],
                 [[f"{matrix}, {solver}", f"{by[5e-3]['setup_s']:.2f}",
                   *(t for tol in (5e-3, 1e-8) for t in (f"{by[tol]['solve_s']:.2f} ({whole(by[tol]['iter'])})",
                                                         error(by[tol]["residual"])))]
                  for (matrix, solver), by in rows_of.items()])


# ---- depths and dense meshes


def depth_rows(threads=1):
    command = "--threads 2" if threads == 2 else r"^depth_study$"
    return rows("depth_study", "mesh", "vertices", "method", "edge/h", command=command)


def depth_table(metric, text, threads=1):
    names = {"cot_cholmod": "cotangent, CHOLMOD", "cot_amg": "cotangent, BoomerAMG"}
    return pivot(["Mesh", "Vertices"],
                 (((r["mesh"], r["vertices"]), names.get(r["method"], f"depth {r['depth']}"), r[metric])
                  for r in depth_rows(threads)), 1,
                 ["depth 4", "depth 5", "depth 6", "depth 7", "depth 8", *names.values()], text)


def table_depth_unknowns():
    return pivot(["Mesh", "Vertices"],
                 (((r["mesh"], r["vertices"]), f"depth {r['depth']}", r["unknowns"])
                  for r in depth_rows() if r["method"] == "restricted"), 1, None, whole)


def table_depth_seconds():
    return depth_table("seconds", seconds)


def table_depth_memory():
    return depth_table("MiB", whole)


def table_depth_error():
    return depth_table("error", error)


def table_depth_edges():
    return pivot(["Mesh", "Vertices"],
                 (((r["mesh"], r["vertices"]), f"depth {r['depth']}", r["edge/h"])
                  for r in depth_rows() if r["method"] == "restricted"), 1, None, short)


def table_dense_seconds_two_threads():
    return pivot(["Threads"],
                 (((2,), "cotangent, CHOLMOD" if r["method"] == "cot_cholmod" else f"depth {r['depth']}",
                   r["seconds"]) for r in depth_rows(2)), 0, None, seconds)


# ---- eigenpairs


def same_pencil(column, text):
    names = {"shift_invert_cholmod": "factorization", "multigrid_eigenpairs": "multigrid"}

    def key(r):
        pairs, tolerance = re.search(r"(\d+) pairs, tolerance (\S+)", r.heading).groups()
        return r["unknowns"], int(pairs), power(float(tolerance))

    return pivot(["Unknowns", "Pairs", "Residual asked"],
                 ((key(r), names[r["what"]], r.get(column, ""))
                  for r in rows("eigensolver_comparison", "what", "pairs", "MiB", comment=", depth ")
                  if "--no-peer" not in r.command), 0, ["multigrid", "factorization"], text)


def table_eigenpairs_seconds():
    return same_pencil("pairs", seconds)


def table_eigenpairs_memory():
    return same_pencil("MiB", whole)


def table_eigenpairs_residual():
    return same_pencil("residual", error)


def table_eigenpairs_error():
    return same_pencil("max_err", error)


def from_mesh(value, text):
    def column(r):
        return "cotangent" if r["what"] == "cotangent_spectra" else r["what"].replace("_", " ")

    return pivot(["Mesh", "Triangles"],
                 (((re.match(r"\w+", r.heading)[0], int(re.search(r"(\d+) triangles", r.heading)[1])),
                   column(r), value(r))
                  for r in rows("eigensolver_comparison", "what", "pairs", "MiB", comment=" triangles, ")
                  if "--no-peer" not in r.command),
                 1, ["depth 5", "depth 6", "depth 7", "cotangent"], text)


def table_mesh_to_pairs_seconds():
    return from_mesh(lambda r: r["matrices"] + r["pairs"], seconds)


def table_mesh_to_pairs_memory():
    return from_mesh(lambda r: r["MiB"], whole)


def table_mesh_to_pairs_mean():
    return from_mesh(lambda r: r["mean_err"], error)


def table_mesh_to_pairs_largest():
    return from_mesh(lambda r: r["max_err"], error)


# ---- assembly, compilation, evaluation


def assembly(threads):
    names = {"mesh": "bunny", "unsplit": "bunny, not split"}
    found = rows("assembly_scaling", "surface", "triangles", "space_s", "all_s")
    return table(["Surface", "Triangles", "Depth", "Fragments", "Unknowns", "Octree", "Matrices"],
                 [[names.get(r["surface"], r["surface"]), whole(r["triangles"]), str(r["depth"]),
                   whole(r["fragments"]), whole(r["unknowns"]), seconds(r["space_s"]), seconds(r["all_s"])]
                  for r in found if r["threads"] == threads])


def table_assembly():
    return assembly(1)


def table_assembly_two_threads():
    return assembly(2)


PROGRAMS = {
    "surface_mesh": "`CGAL::Surface_mesh` alone",
    "read_mesh": "reading a mesh",
    "heat_method": "CGAL's heat method",
    "include_solve_poisson": "`solve_poisson.h`, not used",
    "minimal_poisson": "`minimal_poisson.cpp`",
    "minimal_curvature": "`minimal_curvature.cpp`",
}


def compilation(column, text):
    def name(r):
        kind = {"headers": ", headers only", "compiled": ", compiled library"}.get(r["mode"], "")
        return PROGRAMS[r["program"]] + (kind if r["program"] != "heat_method" else "")

    return pivot(["Program"], (((name(r),), f"`{r['option']}`", r[column])
                               for r in rows("compile_times", "program", "mode", "option")), 1, None, text)


def table_compile_seconds():
    return compilation("seconds", lambda x: f"{x:.1f}")


def table_compile_memory():
    return compilation("MiB", whole)


def table_evaluation():
    found = rows("evaluation", "what", "threads", "seconds")
    return pivot(["Values of 100 functions"],
                 (((r["what"].replace("_", " "),), f"{r['threads']} thread" + "s" * (r["threads"] > 1),
                   r["seconds"]) for r in found), 1, None, seconds)


# ---- thin features and tessellations


def thin(column):
    values, mesh = [], ""
    for line in lines_of("thin_features"):
        match = re.match(r"# (\w+): \d+ vertices", line)
        if match:
            mesh = match[1]
        match = re.match(r"(unsplit|split) +(\d) +(\d+) +(\S+) +(\S+) +(\d+) +(\S+)", line)
        if match:
            is_reference = "reference" in line.split("#")[-1] and "#" in line
            value = "reference" if is_reference and match[1] == "split" else \
                percent(float(match[5 if column == "largest" else 7]))
            values.append(((mesh,), f"{match[1]}, {match[2]}", value))
    return pivot(["Mesh"], values, 1, None, str)


def table_thin_largest():
    return thin("largest")


def table_thin_mean():
    return thin("mean")


def table_gaps():
    found = rows("thin_features", "surface", "depth", "gap", "space", "largest_%")
    return pivot(["Surface", "Gap"], (((r["surface"], r["gap"]), f"{r['space']}, {r['depth']}",
                                       r["largest_%"]) for r in sorted(found, key=lambda r: r["space"],
                                                                       reverse=True)), 2, None, percent)


def needles(column):
    values, mesh = [], ""
    for line in lines_of("spectrum_study"):
        match = re.match(r"# (\w+): \d+ vertices, \d+ triangles; the first", line)
        if match:
            mesh = match[1]
        match = re.match(r"(paper|restricted|cotangent) +(\d) +(\d+) +(\S+) +(\d+) +(\S+)", line)
        if match and mesh:
            operator = {"paper": "paper's space, depth ", "restricted": "default space, depth ",
                        "cotangent": "cotangent, refinements: "}[match[1]] + match[2]
            is_reference = "# the reference" in line
            value = {"unknowns": whole(int(match[3])), "largest": percent(float(match[4])),
                     "mean": percent(float(match[6]))}[column]
            values.append(((operator,), mesh, "reference" if is_reference and column != "unknowns" else value))
    return pivot(["Operator"], values, 1, None, str)


def table_needles_unknowns():
    return needles("unknowns")


def table_needles_largest():
    return needles("largest")


def table_needles_mean():
    return needles("mean")


# ---- curvature


def curvature(column):
    def name(r):
        return r["method"] if r["depth"] == "-" else f"depth {r['depth']}"

    return pivot(["Shape", "Triangulation", "Triangles"],
                 (((r["shape"], r["triangles"], r["number"]), name(r), r[column])
                  for r in rows("curvature_study_accuracy", "shape", "triangles", "H_median")
                  if r["method"] in ("cotangent", "normals")), 2,
                 ["cotangent", "depth 4", "depth 5", "depth 6", "depth 7"], percent)


def table_curvature_H_median():
    return curvature("H_median")


def table_curvature_H_95():
    return curvature("H_95")


def table_curvature_K_median():
    return curvature("K_median")


def table_curvature_K_95():
    return curvature("K_95")


def curvature_change(column):
    def name(r):
        return r["method"] if r["method"] == "cotangent" else \
            f"`{r['method'].replace('-', '_')}`, {r['depth']}"

    return pivot(["Mesh", "Change"], (((r["mesh"], r["change"]), name(r), r[column]) for r in
                                      rows("curvature_study_change", "mesh", "change", "rms_of_H")), 2,
                 None, lambda x: "" if x == "-" else short(x))


def table_curvature_change_H():
    return curvature_change("rms_of_H")


def table_curvature_change_K():
    return curvature_change("rms_of_K")


# ---- gradients and colors


GRADIENTS = {"guess": "first guess", "w_cycle": "one W-cycle", "converged": "converged",
             "details_1e-03": "with details, 1e-3", "details_1e-05": "with details, 1e-5",
             "cholmod": "cotangent, CHOLMOD"}


def gradients(column, text):
    return pivot(["Mesh", "Space", "Depth"],
                 (((r["mesh"], r["space"], r["depth"]), GRADIENTS[r["method"]], r[column])
                  for r in rows("gradient_integration", "mesh", "space", "method", "rms")
                  if r["method"] != "cholmod"), 2, None, text)


def table_gradients_error():
    return gradients("rms", lambda x: f"{x:.4f}" if x < 10 else "diverges")


def table_gradients_steps():
    return gradients("details", whole)


STITCHING = {"nearest": "nearest scan", "chosen": "chosen scan", "paper": "paper",
             "paper+exp": "paper, matched", "bp": "back-projected", "bp+exp": "the same, matched",
             "bp+exp+det": "default"}


def stitching(column):
    return pivot(["Mesh", "Light"],
                 (((r["mesh"], "exposures and lamp" if r["lamp"] > 0 else "exposures"),
                   STITCHING[r["method"]], r[column])
                  for r in rows("texture_stitching", "mesh", "lamp", "method", "contrast")), 2, None,
                 lambda x: f"{x:.4f}")


def table_stitching_error():
    return stitching("rms")


def table_stitching_contrast():
    return stitching("contrast")


# ---- libigl


def libigl(names, columns, text):
    return pivot(["Method"],
                 (((f"libigl, `{'min_quad_with_fixed' if 'min' in method else 'spectra::eigs'}()`"
                    if not r["depth"] else f"this package, depth {r['depth']}",), title, r[column])
                  for r in rows("library_comparison", *names) for method in [r[names[0]]]
                  for title, column in columns), 1, None, text)


def table_libigl_poisson_seconds():
    return libigl(["Poisson", "depth"], [("seconds", "seconds")], seconds)


def table_libigl_poisson_error():
    return libigl(["Poisson", "depth"], [("error", "error")], error)


def table_libigl_eigenvalues_seconds():
    return libigl(["spectrum", "depth"], [("seconds", "seconds")], seconds)


def table_libigl_eigenvalues_largest():
    return libigl(["spectrum", "depth"], [("largest error", "largest")], error)


def table_libigl_eigenvalues_mean():
    return libigl(["spectrum", "depth"], [("mean error", "mean_error")], error)


# ---- pages


# with the empty lines behind it: Markdown takes a line of text for a row
TABLE = re.compile(r"<!-- table: (\w+) -->\n+((?:\|[^\n]*\n)*)\n*")


def with_tables(text, is_partly=False):
    """the text with its tables made again"""

    def make(match):
        if match[1] == "text" or (is_partly and "table_" + match[1] not in globals()):
            return match[0]
        made = globals()["table_" + match[1]]()
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
    "bare Debian 12", "On Debian 12", "CGAL 5.5 or later, Eigen 3.4", "returns 0 only",
    "and 30 commits", "and 18 commits", "and 280 commits",
    # citations
    "by Restricting 3D Functions", "> by Restricting 3D Functions", "28(5), 1475-1484",
    "published with 10.5 seconds for 100 pairs of a mesh of 85,000 vertices", "and 18.0 to",
    "with 35.8 and 68.9 for 270,000 vertices",
    # what the benchmarks do
    "by less than 1e-12 if", "100 of them", "first 40", "from 5 to 8", "more than 16 unknowns", "fewer than 1/32",
    "to 30 % of", "by up to 30 %", "estimated areas of 100,000 points", "first 99", "all 99",
    "largest difference of 20 eigenvalues", "radii 1 and 0.4", "axes 1, 0.7 and 0.5", "by up to 0.3 of",
    "95th percentile", "units of 1 / (longest", "1024 times 1024 pixels", "Values of 100 functions",
    "From the mesh to 100 eigenvalues", "First 30 eigenvalues",
    # counts of operations
    "takes 32 evaluations", "about 75 entries", "12 bytes an entry",
]


def span(values, text=error):
    values = sorted(values)
    low, high = text(values[0]), text(values[-1])
    return low if low == high else f"{low} to {high}"


def facts():
    """the sentences with figures, by page"""
    bunny = {(r["solver"], r["th"], r["tol"]): r for r in solver_rows("solver_comparison_bunny")}
    thin_split = {}
    for line in table_thin_largest()[2:]:
        cells = [c.strip() for c in line.strip("|").split("|")]
        thin_split[cells[0]] = dict(zip(["mesh", 5, 6, 7, "s5", "s6", "s7", "s8"], cells))
    sword = thin_split["sword_45k"]
    stabilization = rows("stabilization", "depth", "unknowns", "factor", "L2_error")
    cost = max(r["L2_error"] / q["L2_error"] for r in stabilization for q in stabilization
               if r["depth"] == q["depth"] and r["factor"] == 1e-3 and q["factor"] == 0)
    tolerance = rows("stabilization", "mesh", "depth", "tolerance", "L2", "H1")

    def differences(t, norm):
        return span(r[norm] for r in tolerance if r["tolerance"] == t)

    machine = next(line[11:] for line in lines_of("solver_comparison_bunny") if line.startswith("# machine: "))
    compiler = next(line[12:] for line in lines_of("solver_comparison_bunny") if line.startswith("# compiler: "))
    pareto = [[float(c.replace(",", "")) if c != "-" else math.inf for c in line.strip("| ").split(" | ")[1:]]
              for shape in ("sphere", "torus") for line in least_seconds(shape, "poisson", POISSON)[2:]]
    wins = [r.index(min(r)) for r in pareto]

    def factors(problem, t):
        """by how much the faster of the peers that arrive is slower, over the surfaces"""
        found = {}
        for r in solver_rows("solver_comparison_loads"):
            if problem_of(r.command) == problem and r["tol"] == t:
                ours, peers = found.setdefault(r["mesh"], ([], []))
                (ours if r["solver"] == "ours" else peers).append(
                    r["total_s"] if r["ok"] == "yes" else math.inf)
        return span((min(peers) / ours[0] for ours, peers in found.values()), lambda x: f"{x:.1f}")

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

    poisson = {r["depth"]: r for r in rows("library_comparison", "Poisson", "depth")}
    vertices = re.search(r"(\d+) vertices", "\n".join(lines_of("library_comparison")))[1]
    ours = bunny["ours", 1, 5e-3]
    return {
        "README.md": [
            f"the bunny with {whole(ours['unknowns'])} unknowns takes {ours['iter']} "
            f"iteration{'s' * (ours['iter'] > 1)} to the paper's accuracy, and "
            f"{bunny['ours', 1, 1e-8]['iter']} to a residual of 1e-8",
            f"the eigenvalues of a sword are off by up to {sword['s5']} % at depth 5 and {sword['s6']} % at "
            f"depth 6, hardly less than without splitting, and by {sword['s8']} % at depth 8",
            f"up to {cost:.1f} times as large",
            f"At depth 6 the solution then differs from the converged one by {differences(1e-3, 'L2')} in L2 "
            f"and {differences(1e-3, 'H1')} in H1, relative, on three meshes (); 5e-3, the accuracy of the "
            f"paper, gives {differences(5e-3, 'L2')} and {differences(5e-3, 'H1')}",
            f"{machine}, {compiler.split(',')[0]}",
            f"meshes of up to {whole(max(r['faces'] for r in all_runs('sphere', 'poisson')))} triangles",
            f"meshes of up to {whole(max(r['faces'] for r in all_runs('sphere', 'spectrum')))} triangles",
            f"Of the {len(wins)} rows of both tables the cotangent Laplacian is the fastest in "
            f"{sum(w > 1 for w in wins)}, this package in {sum(w <= 1 for w in wins)}",
            f"The bunny at depth 7 with {whole(ours['unknowns'])} unknowns",
            f"To 5e-3 the faster of both takes {factors('Poisson, x', 5e-3)} times as long as this package for "
            f"the right-hand side, {factors('Poisson, random', 5e-3)} times for a random one, "
            f"{factors('Poisson, normals', 5e-3)} times for the divergence of a field, "
            f"{factors('screened, normals', 5e-3)} times for a screened problem, and "
            f"{factors('mass matrix', 5e-3)} times for a mass matrix",
            depth_text,
            f"On a bunny with {whole(int(vertices))} vertices",
            f"The errors are {error(poisson[0]['error'])} for libigl, and {error(poisson[4]['error'])}, "
            f"{error(poisson[5]['error'])}, {error(poisson[6]['error'])} and {error(poisson[7]['error'])} for "
            f"this package",
        ],
        "doc/Restricted_laplacian_3/Accuracy_and_performance.txt": [
            f"up to {cost:.1f} times the error",
            depth_text,
        ],
        "doc/Restricted_laplacian_3/Comparison.txt": [
            f"with {whole(int(vertices))} vertices",
        ],
    }


def unknown_figures(text, sentences):
    """the figures of a page that are neither of a sentence nor plain, and the sentences that it lacks"""
    prose = without_tables(text)
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
            made = with_tables(text, page in TABLES_OF)
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

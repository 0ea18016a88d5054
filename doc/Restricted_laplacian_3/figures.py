#!/usr/bin/env python3
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Makes the tables of README.md and of the manual's pages on measurements from the results of the
benchmarks, and checks them.

usage: figures.py [--update] ROOT

A line `<!-- table: NAME -->` stands above each table, which is what TABLES[NAME]() makes of all rows of
its result; `<!-- table: text -->` above a table without measured figures. Without --update the tables
have to be those already, and the sentences of facts() have to be there. README.md has no other figures.

Exit status: 0 if all figures are those of the results.
"""

import math
import re
import sys
from pathlib import Path

import results
from results import (TABLES, Row, add_table, by_depth, by_threads, error, lines_of, of, percent, pivot, power,
                     power_of, rows, seconds, short, table, three_digits, whole)

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


def least_seconds(problem, methods, is_on_one_mesh):
    names = [METHODS[m] for m in methods]
    if "restricted_v" not in methods:
        names[:2] = ["this package", "smooth"]
    found = least_rows("sphere", problem, is_on_one_mesh)
    return table(["Error at most", *names],
                 [[power(r["error"]), *(seconds(r[m]) for m in methods)] for r in found], 0)


def all_runs(shape, problem):
    return [r for r in rows("accuracy_per_second", "faces", "param", command=f"--part {problem}")
            if r["shape"] == shape]


def add_errors_by_mesh(name, shape, problem, kinds):
    add_table(name, lambda: all_runs(shape, problem), (), {"Triangles": "faces"},
              lambda r: "cotangent" if r["method"].startswith("cot") else "depth " + r["param"][1], "error",
              error, 0, where=lambda r: r["method"] in kinds)


TABLES["seconds_poisson_sphere"] = lambda: least_seconds("poisson", POISSON, False)
TABLES["seconds_poisson_sphere_one_mesh"] = lambda: least_seconds("poisson", POISSON, True)
TABLES["seconds_eigenvalues_sphere"] = lambda: least_seconds("spectrum", SPECTRUM, False)
for name, problem, kinds in [
        ("poisson_sphere", "poisson", ["cot_cholmod_f", "restricted"]),
        ("poisson_sphere_smooth", "poisson", ["smooth"]),
        ("eigenvalues_sphere", "spectrum", ["cotangent", "restricted"]),
        ("eigenvalues_sphere_smooth", "spectrum", ["smooth"])]:
    add_errors_by_mesh("error_" + name, "sphere", problem, kinds)


# ---- points


def table_points_eigenvalues():
    found = rows("monte_carlo_convergence", "points", "depth", "per_cell", "error", comment="^unit sphere")
    cells = {(r["number"], r["depth"], r["points"]): r for r in found}
    return table(["Points", "Depth", "Points in a cell", "Regular", "Random"],
                 [[whole(n), str(d), whole(cells[n, d, "regular"]["per_cell"]),
                   *(error(cells[n, d, kind]["error"]) for kind in ("regular", "random"))]
                  for n, d in sorted({(n, d) for n, d, _ in cells})], 0)


TABLES["points_eigenvalues"] = table_points_eigenvalues


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


solver = of(SOLVERS, "solver")
add_table("same_matrix", "solver_comparison_bunny", SOLVER_COLUMNS, {"Solver": solver}, power_of("tol"), in_time,
          where=lambda r: r["th"] == 1)
add_table("depth_8", "solver_comparison_depth_8", SOLVER_COLUMNS,
          {"Surface": "mesh", "Threads": "th", "Unknowns": "unknowns"}, solver, in_time)
add_table("iterations", "solver_comparison_iterations", SOLVER_COLUMNS, {"Surface": "mesh"}, by_depth, iterations,
          where=lambda r: r["tol"] == 1e-8 and r["th"] == 1)


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


def depth_rows():
    return rows("depth_study", "mesh", "vertices", "method", "edge/h", command="^depth_study$")


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


def levels_around_default():
    """of each mesh of depth_study the error over that of the cotangent Laplacian, and how many levels from the default"""
    by_mesh = {}
    for r in depth_rows():
        by_mesh.setdefault(r["mesh"], []).append(r)
    for group in by_mesh.values():
        ours = [r for r in group if r["method"] == "restricted" and r["threads"] == 1]
        default = next((r for r in ours if r["depth"] >= 5 and r["edge/h"] >= 0.5), ours[-1])
        least = min(r["error"] for r in group if r["method"] != "restricted")
        for r in ours:
            if abs(r["depth"] - default["depth"]) <= 1:
                yield Row(r, level=r["depth"] - default["depth"], ratio=r["error"] / least)


LEVELS = {-1: "one level less", 0: "default", 1: "one level more"}
add_table("default_errors", levels_around_default, (), {**MESH, "Default depth": lambda r: r["depth"] - r["level"]},
          of(LEVELS, "level"), "ratio", short, columns=list(LEVELS.values()))
# ---- eigenpairs


EIGENPAIRS = ["what", "pairs", "MiB"]


def with_peers(r):
    return "--no-peer" not in r.command


def in_heading(pattern, read):
    return lambda r: read(re.search(pattern, r.heading)[1])


add_table("eigenpairs_seconds", "eigensolver_comparison", EIGENPAIRS,
          {"Unknowns": "unknowns", "Pairs": in_heading(r"(\d+) pairs", int),
           "Residual asked": in_heading(r"tolerance (\S+)", lambda t: power(float(t)))},
          of({"shift_invert_cholmod": "factorization", "multigrid_eigenpairs": "multigrid"}, "what"), "pairs", seconds,
          0, ["multigrid", "factorization"], with_peers, comment=", depth ")
for name, value, text in [("seconds", lambda r: r["matrices"] + r["pairs"], seconds), ("largest", "max_err", error)]:
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
        ("time", {"cycle_ms": "a cycle", "held_ms": "of it, levels that all ranks hold"}, whole),
        ("efficiency", {"effic": "time of one rank, divided, over time"}, "{:.2f}".format)]:
    add_table("partition_" + name, lambda names=names: lines_of_rows(partitions(), names), (), {"": "what"}, by_ranks,
              "value", text)
add_table("distributed_model", lambda: [r for r in with_model("cycle_ms", "cycle_ms", ("model", "measured"))
                                        if r["ranks"] <= 2],
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
add_table("preconditioners_seconds", "distributed_comparison", DISTRIBUTED,
          {"Surface": surface_of, "Residual": power_of("tolerance"), "": by_ranks}, of(PRECONDITIONERS),
          if_converged("solve_s"), short, 3, list(PRECONDITIONERS.values()), has_peers)
for name, value, text, where in [
        ("seconds", if_found("solve_s"), short, of_two),
        # of one tolerance: memory is the largest up to then
        ("memory", "mib", whole, lambda r: of_two(r) and "--tolerance" not in r.command)]:
    add_table("distributed_pairs_" + name, "distributed_eigensolvers", SLEPC,
              {"Unknowns": "unknowns", "Pairs": "pairs", "Residual": power_of("tolerance")}, of(EIGENSOLVERS), value,
              text, 0, [e for e in EIGENSOLVERS.values() if name != "memory" or e != "Davidson"], where)


# ---- compilation, Python


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
DEBIAN = {"bullseye": "Debian 11", "bookworm": "Debian 12", "trixie": "Debian 13", "forky": "Debian unstable"}
TABLES["wheels"] = lambda: table(
    ["Wheel", "System", "Python", "installation", "with 50 eigenvalues"],
    [[f"{r['processor']}, {r['tag']}", DEBIAN[r["system"]], r["python"], whole(r["install_s"]),
      whole(r["all_s"])]
     for r in rows("wheels", "processor", "tag", "all_s")])
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
EQUAL_ERROR = ["mesh", "vertices", "problem", "method", "parameter", "seconds"]
OWN = ("restricted", "extrapolated")


def equal_error(problem):
    """the least time to each error, of the package and of the fastest of the peers"""
    found = []
    for r in rows("equal_error_peers", *EQUAL_ERROR):
        if r["problem"] != problem or isinstance(r["parameter"], float) and r["parameter"] < 1:
            continue  # what a search takes is another question
        for limit in (1e-2, 3e-3, 1e-3):
            for who in ("this", "peers"):
                value = r["seconds"] if r["error"] <= limit and (r["method"] in OWN) == (who == "this") else math.inf
                found.append((r["mesh"], r["vertices"], f"{power(limit)}, {who}", value))
    least = {}
    for mesh, vertices, column, value in found:
        least[mesh, vertices, column] = min(least.get((mesh, vertices, column), math.inf), value)
    return [Row(mesh=mesh, vertices=vertices, column=column, value=value)
            for (mesh, vertices, column), value in least.items()]


for problem in ("eigenpairs_50", "eigenpairs_100", "poisson"):
    add_table("equal_error_" + problem, lambda p=problem: equal_error(p), [],
              {"Mesh": "mesh", "Vertices": lambda r: whole(r["vertices"])}, "column", "value",
              lambda x: "-" if math.isinf(x) else seconds(x), 1)
SEARCHES = {0.01: "1e-2", 0.003: "3e-3", 0.001: "1e-3"}
for name, value, text in [("seconds", "seconds", seconds), ("errors", "error", error)]:
    add_table("equal_error_search_" + name, "equal_error_peers", EQUAL_ERROR,
              {"Mesh": "mesh", "Problem": lambda r: {"eigenpairs_50": "50 pairs", "poisson": "Poisson"}[r["problem"]]},
              lambda r: SEARCHES.get(r["parameter"], r["parameter"]), value, text, 2, ["default", *SEARCHES.values()],
              lambda r: r["method"] == "restricted" and r["problem"] != "eigenpairs_100" and (
                  r["parameter"] == "default" or r["parameter"] in SEARCHES))
add_table("equal_error_of_peers", "equal_error_peers", EQUAL_ERROR, {"Mesh": "mesh", "Problem": lambda r: {
    "eigenpairs_50": "50 pairs", "eigenpairs_100": "100 pairs", "poisson": "Poisson"}[r["problem"]]},
          lambda r: {"robust": "robust-laplacian", "lapy": "LaPy"}.get(r["method"], r["method"]), "error", error, 2,
          None, lambda r: r["method"] not in OWN)
CORTEX = {"neuromodes": "neuromodes", "depth_5": "this, depth 5", "depth_6": "this, depth 6", "depth_7": "this, depth 7",
          "linear": "linear elements", "restricted": "this", "restricted_1e-2": "this, tolerance 1e-2",
          **{f"steps_{n}": f"linear elements, {n} step" + "s" * (n > 1) for n in (1, 16, 64, 256)}}
OPERATORS = {"laplacian": "Laplacian", "myelin": "with the map as diffusion"}
MODES = ["operator", "method", "modes_s"]
for name, value, text in [("errors", "divided_mean", error), ("seconds", "modes_s", seconds)]:
    add_table("cortex_" + name, "cortex_peers", MODES, {"Operator": of(OPERATORS, "operator")}, of(CORTEX), value, text)
add_table("cortex_meshes", "cortex_peers", ["diffusion", "mesh", "method", "change_mean"],
          {"Diffusion": "diffusion", "Mesh": "mesh"}, of(CORTEX), "change_mean", error, 2)
add_table("cortex_widths", lambda: [Row(r, column=title, value=r[column]) for column, title in (
    ("deviation_mean", "mean deviation from 10 mm"), ("deviation_max", "largest"),
    ("from_256", "mean from 256 steps")) for r in rows("cortex_peers", "width", "method", "deviation_mean")],
          [], {"Method": of(CORTEX)}, "column", "value", error)
FLOWS = {"linear": "linear elements", "cgal": "CGAL", "pmp": "pmp", **{f"depth_{d}": f"this, depth {d}" for d in range(4, 8)}}
for name, value, text in [("seconds", "step_s", seconds), ("deviation", "sphere_30", error),
                          ("distortion", "distortion_30", lambda x: f"{x:.3f}")]:
    add_table("flow_" + name, "flow_peers", ["mesh", "conformal", "step_s"],
              {"Mesh": "mesh", "Method": of(FLOWS, "conformal")}, lambda r, n=name: n, value, text, 2)
add_table("flow_triangles", "flow_peers", ["mesh", "triangles", "flow", "before", "after"],
          {"Mesh": "mesh", "Other triangles": "triangles"},
          lambda r: "linear elements" if r["flow"] == "linear" else "this", "after",
          lambda x: "not finite" if math.isinf(x) else "-" if math.isnan(x) else error(x), 2)
MAPS = {"restricted": "this", "pyFM": "pyFM"}
for name, value, text in [("first", "first_mean", error), ("last", "last_mean", error), ("seconds", None, seconds)]:
    add_table("maps_" + name, "map_peers", ["source", "method", "first_mean"], {"Source": "source"}, of(MAPS),
              value or (lambda r: r["spectra_s"] + r["map_s"] + r["zoomout_s"]), text, 1)
MATRIX = {"restricted": "this, two threads", "pygeodesic": "pygeodesic, exact", "potpourri3d": "potpourri3d, heat method"}
for name, value in (("square", "square_s"), ("row", "row_s"), ("near", "near_s")):
    add_table("matrix_" + name, "distance_matrix", ["method", "square_s"], {"Method": of(MATRIX)}, lambda r: "seconds",
              value, seconds, 1)
add_table("matrix_all", "distance_matrix", ["method", "all_s"], {"Method": of(MATRIX)}, lambda r: "minutes",
          lambda r: r["all_s"] / 60, seconds, 1)
add_table("matrix_errors", lambda: [Row(r, column=title, value=r[column]) for column, title in (
    ("mean_error", "mean"), ("max_error", "largest")) for r in rows("distance_matrix", "method", "mean_error")],
          [], {"Method": of(MATRIX)}, "column", "value", error)
FILTERS = {"none": "none", "implicit": "a step of linear elements", "filter": "linear elements with this filter",
           "restricted": "this", "no_angle": "this", "anisotropic_10": "this, `anisotropic=10`",
           "crease_angle": "this, `crease_angle=30`"}
EDGES = {"Smoothing": of(FILTERS, "smoothing"), "Length in edges": "edges"}


def smoothing_rows(first, *columns):
    return [Row(r, smoothing=r[first], column=title, value=r[column])
            for r in rows("editing_peers", first, "edges", "error", "angle", columns[-1][0]) for column, title in columns]


add_table("smoothing_noise", lambda: smoothing_rows(
    "filter", ("error", "distance to the clean surface, over the noise"), ("angle", "degrees between normals"),
    ("noisy_s", "seconds")), [], EDGES, "column", "value", lambda x: f"{x:.2g}")
add_table("smoothing_creases", lambda: smoothing_rows(
    "creases", ("error", "distance to the clean surface, over the noise"), ("angle", "degrees between normals"),
    ("within_5", "creases within 5 degrees")), [], EDGES, "column", "value", lambda x: f"{x:.2g}")
add_table("smoothing_triangles", "editing_peers", ["mesh", "other", "smoothing", "hundredths", "before", "after"],
          {"Mesh": "mesh", "Other triangles": "other", "Length, %": "hundredths"}, of(FILTERS, "smoothing"), "after",
          lambda x: "not finite" if not math.isfinite(x) else error(x), 2)
EDITS = {"space": "the space", "editor": "`Surface_editor`", "number": "a number", "map": "a number at each vertex",
         "anisotropic": "`Surface_editor` with another metric"}
add_table("editing_seconds", "editing_peers", ["editing", "depth", "seconds"], {"What": of(EDITS, "editing")},
          lambda r: f"depth {r['depth']}", "seconds", seconds)
add_table("cortex_smoothing", "cortex_peers", ["channels", "method", "smoothing_s"],
          {"Method": of(CORTEX)}, lambda r: f"{r['channels']} channel" + "s" * (r["channels"] > 1), "smoothing_s", seconds)


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
OF_DISTANCES = ["bimba_5k", "cat_16k", "bimba_46k", "sword_45k", "bunny_closed_70k", "fandisk_32k", "turbine_18k",
                "pulley_28k", "cessna_soup_14k", "itokawa_197k"]
for name, value, text in [("mean", "mean", percent), ("query", "query_s", short)]:
    add_table("distances_" + name, "distance_study", ["mesh", "n", "source", "method", "mean"],
              {"Mesh": lambda r: f"`{r['mesh']}`", "Vertices": lambda r: whole(r["n"])}, of(DISTANCES), value, text, 1,
              where=lambda r: r["source"] == 0 and r["mesh"] in OF_DISTANCES)


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
add_table("two_sides", "boundary_conditions", POINTS, {"": lambda r: "largest error"}, by_depth, "error", error,
          where=lambda r: r["points"] == "square")


# ---- busy machines


add_table("busy_two", "busy_machine", ["function", "alone_s", "busy", "two"],
          {"Function": lambda r: f"`{r['function']}`"}, lambda r: "two at once", "two", short)


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


def table_mesh_spectra():
    found = rows("shape_study_meshes", "spectra", "runs", "wrong")
    return table(["Meshes", "Runs", "Wrong"],
                 [[whole(len(found)), whole(sum(r["runs"] for r in found)), whole(sum(r["wrong"] for r in found))]], 0)


TABLES["mesh_spectra"] = table_mesh_spectra


def table_estimates():
    """How estimates compare with errors, by problem and depth, apart for those that count as trusted."""
    found = rows("estimate_study", "problem", "estimate", "ratio")
    lines = []
    for problem in ["coordinate", "wave", "spectrum"]:
        for depth in sorted({r["depth"] for r in found}):
            for trusted, word in (("yes", "trusted"), ("no", "not trusted")):
                ratios = sorted(r["ratio"] for r in found if r["problem"] == problem and r["depth"] == depth
                                and r["trusted"] == trusted and not math.isnan(r["ratio"]))
                if ratios:
                    lines.append([problem, whole(depth), word, whole(len(ratios)), short(ratios[0]),
                                  short(ratios[len(ratios) // 2]), short(ratios[-1]),
                                  whole(sum(0.4 <= r <= 3 for r in ratios))])
            none = sum(math.isnan(r["estimate"]) for r in found if r["problem"] == problem and r["depth"] == depth)
            if none:
                lines.append([problem, whole(depth), "none", whole(none), "-", "-", "-", "-"])
    return table(["Problem", "Depth", "Estimate", "Meshes", "least estimate / error", "median", "largest",
                  "from 0.4 to 3"], lines, 3)


TABLES["estimates"] = table_estimates


def table_accuracy(title, value):
    """a line for each problem and accuracy: how many, least, median and largest of what is known"""
    lines = []
    for problem in ["poisson", "spectrum"]:
        for accuracy in (1e-2, 1e-3):
            found = sorted(value(r) for r in rows("accuracy_search", "whole_s", "last_s")
                           if r["problem"] == problem and r["accuracy"] == accuracy and not math.isnan(value(r)))
            lines.append([problem.capitalize(), short(100 * accuracy) + " %", whole(len(found)), short(found[0]),
                          short(found[len(found) // 2]), short(found[-1])])
    return table(["Problem", "Accuracy", "Meshes", f"least {title}", "median", "largest"], lines, 2)


TABLES["accuracy_time"] = lambda: table_accuracy("time / last space", lambda r: r["ratio"])
TABLES["accuracy_error"] = lambda: table_accuracy("error / accuracy", lambda r: r["error"] / r["accuracy"])


# ---- thin features and tessellations


def of_mesh(result, *names):
    """rows under the name of a mesh, which is the comment before those that tell more"""
    for r in rows(result, *names, comment="^reference: "):
        r["mesh"] = next(h for h in reversed(r.headings) if re.match(r"\w+: \d+ vertices", h)).split(":")[0]
        yield r


add_table("thin_largest", lambda: of_mesh("thin_features", "space", "sheets/cell"), (), {"Mesh": "mesh"},
          lambda r: f"{r['space']}, {r['depth']}",
          lambda r: "reference" if "reference" in r.remark and r["space"] == "split" else percent(r["largest_%"]))
# ---- smooth geometry


add_table("smooth_errors", "smooth_geometry", ["shape", "geometry", "largest"],
          {"Shape": "shape", "Triangles": "triangles"}, lambda r: f"{r['geometry']}, depth {r['depth']}", "largest",
          error, 2, [f"{kind}, depth {depth}" for depth in (5, 6) for kind in ("flat", "smooth", "projected")])
TABLES["smooth_simplified"] = lambda: table(
    ["Mesh", "Vertices kept", "Triangles", "flat", "smooth", "Folded faces"],
    [[r["mesh"], f"{r['percent']} %", whole(r["triangles"]), error(r["flat"]) if r["flat"] else "-",
      error(r["smooth"]), whole(r["folded"])]
     for r in rows("smooth_geometry", "mesh", "percent", "smooth")], 1)
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


add_table("curvature_H_median", "curvature_study_accuracy", ["shape", "triangles", "H_median"],
          {"Shape": "shape", "Triangulation": "triangles", "Triangles": "number"},
          lambda r: r["method"] if r["depth"] == "-" else by_depth(r), "H_median", percent, 2,
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


TABLES["viewer_sizes"] = lambda: table(
    ["Mesh", "Triangles", "Fields", "page", "of it the viewer"],
    [[r["mesh"], whole(r["triangles"]), str(r["fields"]), short(r["page_MB"]), short(r["viewer_MB"])]
     for r in rows("viewer_pages", "mesh", "triangles", "page_MB")])


def fastest(is_on_one_mesh):
    """in how many rows of the Poisson tables of both shapes the cotangent Laplacian is, of how many"""
    found = [r for shape in ("sphere", "torus") for r in least_rows(shape, "poisson", is_on_one_mesh)]

    def least(r, of_cotangent):
        return min((r[m] for m in POISSON if m.startswith("cot") == of_cotangent and not math.isnan(r[m])),
                   default=math.inf)

    return sum(least(r, True) < least(r, False) for r in found), len(found)


def at_default_depth():
    """of each mesh of depth_study the gain in error, and the loss in time, against the cotangent Laplacian"""
    by_mesh = {}
    for r in depth_rows():
        by_mesh.setdefault(r["mesh"], []).append(r)
    for group in by_mesh.values():
        ours = [r for r in group if r["method"] == "restricted" and 5 <= r["depth"] <= 8]
        default = next((r for r in ours if r["edge/h"] >= 0.5), ours[-1])
        peers = [r for r in group if r["method"] != "restricted"]
        yield (min(r["error"] for r in peers) / default["error"],
               default["seconds"] / min(r["seconds"] for r in peers))


def facts():
    """the sentences with figures, by page"""

    def span(values):
        return f"{min(values):.2g} to {max(values):.2g}"

    bunny = next(r for r in solver_rows("solver_comparison_bunny")
                 if (r["solver"], r["th"], r["tol"]) == ("ours", 1, 1e-8))
    largest = next(r for r in largest_of_all_depths() if r["depth"] == 9)
    (wins, of_all), (wins_on_one, of_one) = fastest(False), fastest(True)
    gains, losses = zip(*at_default_depth())
    shapes = rows("shape_study_shapes", *SHAPES)
    vertices = re.search(r"(\d+) vertices", "\n".join(lines_of("library_comparison")))[1]
    return {
        "README.md": [
            f"Where each method chooses its mesh, the cotangent Laplacian is the fastest in {wins} of the {of_all} "
            f"rows of the Poisson tables, on a given mesh in {wins_on_one} of {of_one}",
            f"The bunny takes {bunny['iter']} iterations to a residual of 1e-8",
            f"Reading 100 million triangles and solving at depth 9 takes {short(largest['all_s'])} s and "
            f"{short(largest['memory_gb'])} GB",
        ],
        "doc/Restricted_laplacian_3/Accuracy_and_performance.txt": [
            f"At the default depth the error is below that of the cotangent Laplacian on {sum(g > 1 for g in gains)} "
            f"of the {len(gains)} meshes, by a factor of {span(gains)}, in {span(losses)} times the time",
            f"Of the {of_all} rows of the Poisson tables the cotangent Laplacian is the fastest in {wins}, this "
            f"package in {of_all - wins}",
            f"Of these {of_one} rows the cotangent Laplacian is the fastest in {wins_on_one}, this package in "
            f"{of_one - wins_on_one}",
            f"Of {whole(sum(r['trials'] for r in shapes))} trials {sum(r['wrong'] for r in shapes) or 'none'} had a "
            "wrong result",
        ],
        "doc/Restricted_laplacian_3/Comparison.txt": [f"with {whole(int(vertices))} vertices"],
    }


# Figures of README.md that are not measured.
PLAIN = re.compile(r"bare Debian 12 or 13|On Debian 12 or 13|C\+\+17|\b20\d\d\b|CGAL 5.5 or later, Eigen 3.4|"
                   r"GPL-3\.0-or-later|28\(5\), 1475-1484|3D|0\.2\b")


def unknown_figures(text, sentences):
    """what looks like a measured figure in prose"""
    text = re.sub(r"```.*?```|`[^`]*`|\]\([^)]*\)|<[^>]*>", "", TABLE.sub("", text), flags=re.S)
    text = re.sub(r"\s+", " ", text)
    for known in sentences:
        text = text.replace(known, "")
    text = PLAIN.sub("", text)
    return [text[max(0, m.start() - 40):m.end() + 20] for m in re.finditer(r"(?<![A-Za-z_\d])\d[\d.,]*", text)]


def errors_of(page, text, made, sentences):
    if page in PAGES:
        yield from (f"a table without a name: {line}" for line in TABLE.sub("", text).splitlines()
                    if line.startswith("|"))
    prose = re.sub(r"\s+", " ", text)
    yield from (f"the results say: {sentence}" for sentence in sentences if sentence not in prose)
    if page == "README.md":
        yield from (f"no result has this figure: ...{f}..." for f in unknown_figures(text, sentences))
    if made != text:
        old, new = next((a, b) for a, b in zip(text.splitlines(), made.splitlines()) if a != b)
        yield f"in place of\n{old}\nthe results say\n{new}"


def main(arguments):
    results.ROOT = Path(arguments[-1])
    errors = 0
    sentences = facts()
    for page in [*PAGES, *TABLES_OF]:
        path = results.ROOT / page
        text = path.read_text()
        made = with_tables(text)
        if arguments[0] == "--update" and made != text:
            path.write_text(made)
            print(f"{page}: written")
            text = made
        for message in errors_of(page, text, made, sentences.get(page, [])):
            print(f"{page}: {message}")
            errors += 1
    return errors > 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

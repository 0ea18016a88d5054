#!/usr/bin/env python3
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Estimated errors against those against a space that is two levels deeper, at default settings.

usage: estimate_study.py FOLDER [MESH]...

A line for each mesh, problem and depth: the number of unknowns, by how much it has grown from the level
before, whether the estimate counts as trusted, the estimate, the error, and their ratio. Problems: the
largest relative error of the eigenvalues 1 to 30 (of extrapolated ones, too), and the root mean square over
the vertices of the solutions of Poisson problems with a coordinate and with a wave as right-hand sides.
"""

import pathlib

import numpy as np

import restricted_laplacian as rl
from support.peers import arguments, print_header

DEPTHS, LEVELS_TO_REFERENCE = (4, 5), 2
PAIRS = 31


def right_hand_sides(V):
    side = np.ptp(V, axis=0).max()
    wave = np.sin(36 * (V - (V.min(0) + V.max(0)) / 2) @ np.array([0.5, 0.6, 0.62]) / side)
    return {"coordinate": V[:, 2] / side, "wave": wave}


def largest(values, exact):
    n = min(len(values), len(exact))
    return np.max(np.abs(values[1:n] / exact[1:n] - 1)) if n > 1 else np.nan


def main():
    options = arguments(__doc__, [])
    meshes = options.mesh or sorted(path.stem for path in options.folder.glob("*.ply"))
    print_header(pathlib.Path(__file__).stem, options.mesh, ["numpy"])
    print(f"# {'mesh':<20} {'problem':<10} depth {'unknowns':>8} growth trusted {'estimate':>8} {'error':>8} "
          f"{'ratio':>7} extrapolated")
    for name in meshes:
        V, F = rl.read_mesh(options.folder / f"{name}.ply")
        spaces = {d: rl.Space(V, F, depth=d)
                  for d in range(DEPTHS[0] - 1, DEPTHS[-1] + LEVELS_TO_REFERENCE + 1)}

        def show(problem, depth, report, error, extrapolated=float("nan")):
            unknowns = spaces[depth].dimension
            print(f"{name:<22} {problem:<10} {depth:5} {unknowns:8} "
                  f"{unknowns / spaces[depth - 1].dimension:6.2f} "
                  f"{'yes' if report.is_estimate_trusted else 'no':>7} {report.estimated_error:8.1e} {error:8.1e} "
                  f"{report.estimated_error / error:7.2f} {extrapolated:12.1e}", flush=True)

        spectra = {d: rl.laplace_spectrum(spaces[d], PAIRS, check=False)
                   for d in spaces if d >= DEPTHS[0]}
        for depth in DEPTHS:
            exact = spectra[depth + LEVELS_TO_REFERENCE].eigenvalues
            show("spectrum", depth, spectra[depth].report, largest(spectra[depth].eigenvalues, exact),
                 largest(spectra[depth].extrapolated_eigenvalues, exact))
        for problem, f in right_hand_sides(V).items():
            solutions = {d: rl.solve_poisson(spaces[d], f=f, check=False, return_report=True)
                         for d in spectra}
            for depth in DEPTHS:
                u, report = solutions[depth]
                exact = solutions[depth + LEVELS_TO_REFERENCE][0]
                known = np.isfinite(exact) & np.isfinite(u)
                error = np.linalg.norm((u - exact)[known]) / np.linalg.norm(exact[known])
                show(problem, depth, report, error)


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Seconds to a given error, of Laplacians that Python users can install: equal_error_peers.py FOLDER [MESH...]

FOLDER holds the meshes, MESH are their names without .ply. Needs what python_peers.py needs.

For each mesh 50 and 100 eigenpairs, and the Poisson problem with f = z at the vertices; seconds from
arrays to arrays, on one thread, the least of up to three runs. Errors are against the package two levels
deeper than its default, at depth 9 at most: the largest relative one of the eigenvalues that are not 0,
and the one in the mean square over the surface. Peers take scipy's eigsh with a shift and CHOLMOD, and
the mesh as it is.

Each run of the package gives two rows, one for the eigenvalues and one for the extrapolated ones.

Rows: mesh, vertices, problem, method, its parameter (a depth, the accuracy asked for, or -), seconds,
error, and the error that the package estimates.
"""

import os
import sys

for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ[name] = "1"

import numpy as np  # noqa: E402

import python_peers as peers  # noqa: E402
import restricted_laplacian as rl  # noqa: E402
from support.peers import arguments, print_header  # noqa: E402

MESHES = ["bimba_5k", "anchor_8k", "bunny_adaptive_12k", "turbine_18k", "fandisk_32k", "bimba_46k",
          "bunny_closed_70k", "armadillo", "koala_100k", "itokawa_197k", "gcanyon_color_318k",
          "armadillo_mc1m"]
ACCURACIES = (1e-2, 3e-3, 1e-3)
# scipy's default is machine precision; no error asked for here is below a thousandth
TOLERANCE_OF_PEERS = 1e-4
LONGEST = 20  # seconds: a deeper space, or a smaller accuracy, than one that took longer is not tried


def largest_error(values, reference):
    is_zero = reference < 1e-9 * reference.max()
    a, b = np.sort(values)[~is_zero], reference[~is_zero]
    return float(np.max(abs(a - b) / b))


class Problem:
    """50 or 100 eigenpairs, or the Poisson problem if there is no count."""

    def __init__(self, V, F, fine, eigenvalues, count=None):
        self.V, self.F, self.count = V, F, count
        self.name = f"eigenpairs_{count}" if count else "poisson"
        self.areas = fine._surface.vertex_areas()
        self.reference = (eigenvalues[:count] if count
                          else rl.solve_poisson(fine, None, V[:, 2], tolerance=1e-8))

    def ours(self, **options):
        """Values, and the error that is estimated."""
        if self.count:
            s = rl.laplace_spectrum(self.V, self.F, count=self.count, threads=1, **options)
            return (s.eigenvalues, s.extrapolated_eigenvalues), s.report.estimated_error
        u, report = rl.solve_poisson(self.V, self.F, self.V[:, 2], threads=1, return_report=True, **options)
        return (u,), report.estimated_error

    def of_peer(self, matrices):
        S, M = matrices(self.V, self.F, "cholmod")
        if self.count:
            return (peers.eigenpairs(S, M, "cholmod", self.count, TOLERANCE_OF_PEERS),), np.nan
        return (peers.poisson(S, M, self.V[:, 2], "cholmod"),), np.nan

    def error(self, found):
        if self.count:
            return largest_error(found, self.reference)
        on_surface = self.areas > 0
        d, u, a = (found - self.reference)[on_surface], self.reference[on_surface], self.areas[on_surface]
        return float(np.sqrt((a @ d ** 2) / (a @ u ** 2)))


def main():
    o = arguments(__doc__, MESHES)
    print_header("equal_error_peers", o.mesh, ["numpy", "scipy", "robust-laplacian", "lapy", "libigl",
                                               "scikit-sparse"])
    print(f"# {'mesh':20} {'vertices':>9} {'problem':14} {'method':18} {'parameter':>9} {'seconds':>8} "
          f"{'error':>9} {'estimate':>9}")

    def row(problem, method, parameter, work):
        try:
            (found, estimate), seconds = peers.measure_any(work)
        except Exception as e:
            print(f"# {mesh} {problem.name} {method} {parameter}: {type(e).__name__}: "
                  f"{' '.join(str(e).split())[:90]}", flush=True)
            return np.nan, np.nan
        errors = [problem.error(values) for values in found if len(values) > 0]
        for error, name in zip(errors, (method, "extrapolated")):
            print(f"{mesh:22} {len(V):9} {problem.name:14} {name:18} {parameter:>9} {seconds:8.3f} "
                  f"{error:9.1e} {estimate:9.1e}", flush=True)
        return seconds, errors[0]

    for mesh in o.mesh:
        V, F = rl.read_mesh(o.folder / f"{mesh}.ply")
        default = rl.Space(V, F)
        fine = rl.Space(V, F, depth=min(default.depth + 2, 9))
        print(f"# {mesh}: {len(F)} triangles, default depth {default.depth}, reference depth {fine.depth}")
        eigenvalues = rl.eigs(fine, None, 100, tolerance=1e-5)[0]
        for count in (50, 100, None):
            problem = Problem(V, F, fine, eigenvalues, count)
            for method, matrices in peers.PEERS.items():
                row(problem, method, "-", lambda m=matrices: problem.of_peer(m))
            row(problem, "restricted", "default", problem.ours)
            for accuracy in ACCURACIES if count != 100 else ():
                seconds, _ = row(problem, "restricted", f"{accuracy:.0e}",
                                 lambda a=accuracy: problem.ours(accuracy=a))
                if seconds > LONGEST:
                    break
            for depth in range(3, fine.depth):
                seconds, error = row(problem, "restricted", str(depth), lambda d=depth: problem.ours(depth=d))
                if seconds > LONGEST or error < ACCURACIES[-1] / 3:
                    break
    return 0


if __name__ == "__main__":
    sys.exit(main())

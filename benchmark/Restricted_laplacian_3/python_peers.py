#!/usr/bin/env python3
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Laplacians that Python users can install, side by side: python_peers.py FOLDER [MESH...]

FOLDER holds the meshes, MESH are their names without .ply. Needs the package itself, and

    pip install numpy==2.4.6 scipy==1.17.1 robust-laplacian==1.1.0 lapy==1.7.0 libigl==2.6.3 \\
        scikit-sparse==0.4.16 fast-simplification==0.2.0

For each mesh, and for what quadric simplification leaves of it at 30 % of the triangles: 50 eigenpairs,
and the Poisson problem with f = z at the vertices. Peers take scipy's eigsh with a shift, once with
SuperLU, and once with CHOLMOD, where it is installed. All run on one thread; the package also on two.

Columns: seconds from arrays to arrays; error against the package at two levels more than its default,
the mean relative one of the eigenvalues that are not 0, and the one in the mean square over the surface;
change of the eigenvalues under simplification. The line of a mesh says how far the reference is from
the cotangent Laplacian of a mesh whose triangles are divided into four, once and twice, extrapolated;
nan for meshes that are too large for that.
"""

import os
import sys
import time

for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ[name] = "1"

import numpy as np  # noqa: E402
import scipy.sparse  # noqa: E402
import scipy.sparse.csgraph  # noqa: E402
import scipy.sparse.linalg  # noqa: E402

import restricted_laplacian as rl  # noqa: E402
from support.peers import arguments, print_header, refined  # noqa: E402

K = 50
MESHES = ["cow_5k8", "bimba_46k", "bunny_closed_70k", "armadillo", "fandisk_32k", "cessna_soup_14k",
          "rgbd5_scan1", "rgbd5_scan5"]
SIGMA = -1e-8


def factorize(a, name):
    """A function that solves a x = b."""
    if name == "superlu":
        return scipy.sparse.linalg.splu(a.tocsc()).solve
    from sksparse.cholmod import cholesky
    return cholesky(a.tocsc())


def eigenpairs(S, M, name, count=K, tolerance=0):
    # a shift in units of the matrices keeps the factorization definite
    shift = SIGMA * S.diagonal().sum() / M.diagonal().sum()
    solve = factorize(S - shift * M, name)
    inverse = scipy.sparse.linalg.LinearOperator(S.shape, matvec=solve)
    return scipy.sparse.linalg.eigsh(S, count, M, sigma=shift, OPinv=inverse, tol=tolerance)[0]


def poisson(S, M, f, name):
    # constants of each connected component are in the kernel
    number, label = scipy.sparse.csgraph.connected_components(S)
    weights = M @ np.ones(len(f))

    def without_means(x):
        sums = np.bincount(label, weights * x, number)
        areas = np.bincount(label, weights, number)
        return x - (sums / np.where(areas > 0, areas, 1))[label]

    shift = SIGMA * S.diagonal().sum() / M.diagonal().sum()
    return without_means(factorize(S - shift * M, name)(-(M @ without_means(f))))


def cotangent(V, F, name):
    import igl
    return -igl.cotmatrix(V, F), igl.massmatrix(V, F, igl.MASSMATRIX_TYPE_VORONOI)


def tufted(V, F, name):
    import robust_laplacian
    return robust_laplacian.mesh_laplacian(V, F)


def linear_elements(V, F, name):
    import lapy
    solver = lapy.Solver(lapy.TriaMesh(V, F), lump=False)
    return solver.stiffness, solver.mass


PEERS = {"libigl": cotangent, "robust": tufted, "lapy": linear_elements}


def ours(threads):
    return (lambda V, F: rl.eigs(V, F, K, threads=threads)[0],
            lambda V, F: rl.solve_poisson(V, F, V[:, 2], threads=threads))


def methods():
    """Name, and functions for eigenvalues and for the Poisson problem."""
    yield "restricted", *ours(1)
    yield "restricted_2", *ours(2)
    for peer, matrices in PEERS.items():
        for solver in ("superlu", "cholmod"):
            if solver == "cholmod":
                try:
                    import sksparse.cholmod  # noqa: F401
                except ImportError:
                    continue
            yield (f"{peer}_{solver}",
                   lambda V, F, m=matrices, s=solver: eigenpairs(*m(V, F, s), s),
                   lambda V, F, m=matrices, s=solver: poisson(*m(V, F, s), V[:, 2], s))


def relative(values, reference):
    """The mean relative difference of eigenvalues that are not 0."""
    n = min(len(values), len(reference))
    is_zero = reference[:n] < 1e-9 * reference.max()
    if is_zero.all():
        return np.nan
    a, b = values[:n][~is_zero], reference[:n][~is_zero]
    return float(np.mean(abs(a - b) / b))


def measure_any(work, *arguments):
    """What it returns, and seconds: the least of up to three runs."""
    best = np.inf
    for _ in range(3):
        start = time.perf_counter()
        result = work(*arguments)
        best = min(best, time.perf_counter() - start)
        if best > 5:
            break
    return result, best


def measure(work, *arguments):
    """What it returns, or what went wrong, and seconds."""
    try:
        result, best = measure_any(work, *arguments)
    except Exception as e:
        return e, np.nan
    return (result, best) if np.all(np.isfinite(result[~np.isnan(result)])) else (
        ValueError("not finite"), best)


def main():
    o = arguments(__doc__, MESHES)
    import fast_simplification

    print_header("python_peers", o.mesh, ["numpy", "scipy", "robust-laplacian", "lapy", "libigl",
                                          "scikit-sparse", "fast-simplification"])
    print(f"# {'mesh':20} {'vertices':>9} {'method':17} {'eigs_s':>8} {'eigs_err':>9} {'change':>9} "
          f"{'poisson_s':>9} {'pois_err':>9}")
    for mesh in o.mesh:
        V, F = rl.read_mesh(o.folder / f"{mesh}.ply")
        default = rl.Space(V, F)
        fine = rl.Space(V, F, depth=min(default.depth + 2, 9))
        reference = rl.eigs(fine, None, K, tolerance=1e-4)[0]
        if reference.max() < 1e-9 / fine.area:
            print(f"# {mesh}: left out, its first {K} eigenvalues are all 0")
            continue
        u = rl.solve_poisson(fine, None, V[:, 2], tolerance=1e-8)
        check = np.nan
        if len(V) < 30000:
            values = [reference]
            finer = V, F
            for _ in range(2):
                finer = refined(*finer)
                values.append(eigenpairs(*cotangent(*finer, ""), "cholmod"))
            check = relative((4 * values[2] - values[1]) / 3, reference)
        areas = default._surface.vertex_areas()
        on_surface = areas > 0
        small = fast_simplification.simplify(V.astype(np.float32), F.astype(np.int32), 0.7)
        small = small[0].astype(float), small[1].astype(np.int64)
        print(f"# {mesh}: {len(F)} triangles, depth {default.depth}, reference depth {fine.depth}, "
              f"from refined cotangent Laplacians {check:.1e}; simplified to {len(small[1])}")
        for name, values, solution in methods():
            failures = []
            found, seconds = measure(values, V, F)
            of_small, _ = measure(values, *small)
            error = change = np.nan
            if isinstance(found, Exception):
                failures.append(f"eigenpairs: {type(found).__name__}: {found}")
            else:
                found = np.sort(found)
                error = relative(found, reference)
                if isinstance(of_small, Exception):
                    failures.append(f"simplified: {type(of_small).__name__}: {of_small}")
                else:
                    change = relative(np.sort(of_small), found)
            x, poisson_seconds = measure(solution, V, F)
            poisson_error = np.nan
            if isinstance(x, Exception):
                failures.append(f"Poisson: {type(x).__name__}: {x}")
            else:
                d = (x - u)[on_surface]
                poisson_error = float(np.sqrt((areas[on_surface] @ d ** 2) /
                                              (areas[on_surface] @ u[on_surface] ** 2)))
            print(f"{mesh:22} {len(V):9} {name:17} {seconds:8.3f} {error:9.1e} {change:9.1e} "
                  f"{poisson_seconds:9.3f} {poisson_error:9.1e}"
                  + "".join(f"  # {' '.join(f.split())[:90]}" for f in failures), flush=True)


if __name__ == "__main__":
    sys.exit(main())

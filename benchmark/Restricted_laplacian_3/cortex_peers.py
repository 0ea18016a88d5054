#!/usr/bin/env python3
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A cortical surface: modes, materials, and smoothing, beside packages of neuroimaging: cortex_peers.py

Needs what python_peers.py needs, and pip install neuromodes==0.1.0, whose data it takes: the left
midthickness of the group average fsLR 32k, without the medial wall, and its myelin map. One thread.

Four tables, each with the names of its columns above it; differences are relative:

    first 50 eigenvalues that are not 0, of the Laplacian and with the myelin map as diffusion: seconds; the
        mean and the largest difference from neuromodes on the same mesh, and on that mesh with each triangle
        divided into four
    the same surface with 30 % of its triangles (quadrics) or four times as many, and a diffusion that is a
        function of the point, a number or a tensor: the mean and the largest change of 50 eigenvalues
    point sources away from the boundary, smoothed to 10 mm: the full width at half maximum of a Gaussian with
        the same second moment, by exact distances; its mean and largest deviation from 10 mm, and the mean
        absolute one from that of 256 implicit steps of linear elements
    smoothing of random data to 6 mm, 1 and 100 channels: seconds
"""

import os
import sys

for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ[name] = "1"

import fast_simplification  # noqa: E402
import lapy  # noqa: E402
import numpy as np  # noqa: E402
import scipy.sparse  # noqa: E402
from neuromodes import EigenSolver  # noqa: E402
from neuromodes.io import fetch_example_map, fetch_example_surf  # noqa: E402

import python_peers as peers  # noqa: E402
import restricted_laplacian as rl  # noqa: E402
from support.peers import print_header, refined  # noqa: E402

COUNT = 51
DEPTHS = (5, 6, 7)


def cortex():
    """Points in millimeters, triangles, and the myelin map with mean 1."""
    surface, mask = fetch_example_surf()
    solver = EigenSolver(surface, mask=mask)
    V, F = np.asarray(solver.geometry.v, float), np.asarray(solver.geometry.t, int)
    values = np.asarray(fetch_example_map("myelinmap"), float)[np.asarray(mask, bool)]
    return V, F, values / values.mean()


def linear_elements(V, F, tensors):
    """Stiffness and mass of linear elements with a tensor on each triangle."""
    p = V[F]
    e = p[:, [2, 0, 1]] - p[:, [1, 2, 0]]  # opposite to each corner
    n = np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])
    area = np.linalg.norm(n, axis=1) / 2
    gradients = np.cross((n / (4 * area ** 2)[:, None])[:, None, :], e)
    s = np.einsum("f,fai,fij,fbj->fab", area, gradients, tensors, gradients)
    m = area[:, None, None] * (np.ones((3, 3)) + np.eye(3)) / 12
    i, j = np.repeat(F, 3, axis=1).ravel(), np.tile(F, 3).ravel()
    shape = len(V), len(V)
    return tuple(scipy.sparse.csc_matrix((x.ravel(), (i, j)), shape) for x in (s, m))


def relative(values, reference):
    a, b = np.sort(values)[1:], np.sort(reference)[1:]
    d = abs(a - b) / b
    return d.mean(), d.max()


def row(*cells):
    print(" ".join(f"{c:>14}" if isinstance(c, str) else f"{c:>14.4g}" for c in cells), flush=True)


def heading(*names):
    print("#" + " ".join(f"{n:>14}" for n in names)[1:], flush=True)


def modes(V, F, myelin):
    heading("operator", "method", "modes_s", "mesh_mean", "mesh_max", "divided_mean", "divided_max")
    fine_V, fine_F = refined(V, F)
    fine_myelin = np.empty(len(fine_V))
    fine_myelin[:len(V)] = myelin
    corners, (x, y, z) = fine_F[:len(F)], F.T  # of the first part: x and two middles
    fine_myelin[corners[:, 1]] = (myelin[x] + myelin[y]) / 2
    fine_myelin[corners[:, 2]] = (myelin[x] + myelin[z]) / 2
    of_b = fine_F[len(F):2 * len(F)]
    fine_myelin[of_b[:, 1]] = (myelin[y] + myelin[z]) / 2
    for case, map_, fine_map in (("laplacian", None, None), ("myelin", myelin, fine_myelin)):
        def of_neuromodes(points, faces, values):
            solver = EigenSolver(lapy.TriaMesh(points, faces))
            solver.solve(COUNT, hetero=values)
            return np.asarray(solver.evals)
        on_mesh, seconds = peers.measure_any(of_neuromodes, V, F, map_)
        on_fine = of_neuromodes(fine_V, fine_F, fine_map)
        row(case, "neuromodes", seconds, 0.0, 0.0, *relative(on_mesh, on_fine))
        for depth in DEPTHS:
            values, seconds = peers.measure_any(
                lambda d=depth, m=map_: rl.eigs(V, F, COUNT, depth=d, diffusion=m, threads=1)[0])
            row(case, f"depth_{depth}", seconds, *relative(values, on_mesh), *relative(values, on_fine))


def number_at(p):
    return 1 + 0.5 * np.sin(p[:, 0] / 15) * np.cos(p[:, 1] / 20)


def tensor_at(p):
    """Ten times as fast along a direction that turns."""
    angle = p[:, 1] / 40
    d = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    return np.eye(3) + 9 * d[:, :, None] * d[:, None, :]


def meshes(V, F):
    heading("diffusion", "mesh", "method", "change_mean", "change_max")
    small = fast_simplification.simplify(V.astype(np.float32), F.astype(np.int32), 0.7)
    cases = {"simplified": (small[0].astype(float), small[1].astype(int)), "refined": refined(V, F)}
    for name, function in (("number", number_at), ("tensor", tensor_at)):
        def restricted(points, faces):
            return rl.eigs(points, faces, COUNT, depth=6, diffusion=function, threads=1)[0]

        def cotangent(points, faces):
            d = function(points[faces].mean(axis=1))
            tensors = d if d.ndim == 3 else d[:, None, None] * np.eye(3)
            return peers.eigenpairs(*linear_elements(points, faces, tensors), "cholmod", COUNT)
        for method, values in (("depth_6", restricted), ("linear", cotangent)):
            reference = values(V, F)
            for case, mesh in cases.items():
                row(name, case, method, *relative(values(*mesh), reference))


def implicit_steps(V, F, time, steps):
    """What linear elements make of data in implicit steps."""
    import igl
    S, M = -igl.cotmatrix(V, F), igl.massmatrix(V, F, igl.MASSMATRIX_TYPE_VORONOI)
    solve = peers.factorize(M + time / steps * S, "cholmod")

    def result(u):
        for _ in range(steps):
            u = solve(M @ u)
        return u
    return result


def widths(V, F):
    heading("width", "method", "deviation_mean", "deviation_max", "from_256")
    fwhm = 10
    time = fwhm ** 2 / (16 * np.log(2))
    loops = np.unique(F)[np.isin(np.unique(F), boundary_vertices(F))]
    away = np.flatnonzero(rl.geodesic_distance(V, F, loops) > 3 * fwhm)
    sources = np.sort(np.random.default_rng(3).choice(away, 24, replace=False))
    areas = rl.Space(V, F)._surface.vertex_areas()
    u0 = np.zeros((len(V), len(sources)))
    u0[sources, np.arange(len(sources))] = 1
    distances = [rl.geodesic_distance(V, F, s, exact=True) for s in sources]

    def moment_of_hat(source):
        """The second moment of the linear function that is 1 at a vertex: what a source is."""
        corners = F[(F == source).any(axis=1)]
        others = corners[corners != source].reshape(-1, 2)
        e1, e2 = V[others[:, 0]] - V[source], V[others[:, 1]] - V[source]
        a = np.linalg.norm(np.cross(e1, e2), axis=1)
        return (a * ((e1 ** 2).sum(1) + (e2 ** 2).sum(1) + (e1 * e2).sum(1))).sum() / (10 * a.sum())

    def width(u, k, own):
        moment = np.average(distances[k] ** 2, weights=areas * u[:, k]) - own
        return np.sqrt(moment / 2 * 8 * np.log(2))
    results = {"restricted": rl.smooth(V, F, u0, fwhm=fwhm, threads=1, tolerance=1e-6)}
    for steps in (1, 16, 64, 256):
        results[f"steps_{steps}"] = implicit_steps(V, F, time, steps)(u0)
    # with a lumped mass a source is a point
    of = {name: np.array([width(u, k, moment_of_hat(s) if name == "restricted" else 0)
                          for k, s in enumerate(sources)]) for name, u in results.items()}
    for name, w in of.items():
        row(f"{fwhm}_mm", name, w.mean() / fwhm - 1, abs(w / fwhm - 1).max(),
            abs(w / of["steps_256"] - 1).mean())


def boundary_vertices(F):
    edges = np.sort(F[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    unique, count = np.unique(edges, axis=0, return_counts=True)
    return np.unique(unique[count == 1])


def seconds(V, F):
    heading("channels", "method", "smoothing_s")
    rng = np.random.default_rng(0)
    fwhm = 6
    time = fwhm ** 2 / (16 * np.log(2))
    for channels in (1, 100):
        u = rng.standard_normal((len(V), channels))
        u = u[:, 0] if channels == 1 else u
        for name, tolerance in (("restricted", 1e-4), ("restricted_1e-2", 1e-2)):
            row(str(channels), name, peers.measure_any(
                lambda t=tolerance: rl.smooth(V, F, u, fwhm=fwhm, threads=1, tolerance=t))[1])
        for steps in (16, 64):
            row(str(channels), f"steps_{steps}", peers.measure_any(
                lambda n=steps: implicit_steps(V, F, time, n)(u))[1])


def main():
    print_header("cortex_peers", [], ["numpy", "scipy", "lapy", "neuromodes", "libigl", "scikit-sparse",
                                      "fast-simplification"])
    V, F, myelin = cortex()
    print(f"# {len(V)} vertices, {len(F)} triangles, default depth {rl.Space(V, F).depth}")
    modes(V, F, myelin)
    meshes(V, F)
    widths(V, F)
    seconds(V, F)
    return 0


if __name__ == "__main__":
    sys.exit(main())

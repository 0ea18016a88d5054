#!/usr/bin/env python3
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces that are smoothed, beside linear elements on the triangles: editing_peers.py FOLDER [MESH...]

FOLDER holds the meshes, MESH are their names without .ply. Needs what python_peers.py needs. One thread.
Linear elements take cotangent weights, Voronoi areas and CHOLMOD: implicit is one step of implicit smoothing,
(S + a M) u = a M x with a = (2 pi / length)^2; filter is what smooth_surface() computes, by the same matrices,
one complex system and SuperLU. bilateral are the filtered normals of smooth_surface(crease_angle=30), fitted by
linear elements on the noisy triangles.

Four tables, of which the last one needs only the mesh armadillo_mc1m, and two threads:

    what remains of waves on the unit sphere, by length and by kind of filter, beside the formula
    noise along the normals, of a normal distribution with a deviation of 0.3 % of the diameter. Lengths are in
        mean edges. Of the surface that is left: the root mean square of the distance to the clean one along
        its normals, over that of the noise, and the mean angle of the normals of faces to those of the clean one
    a noisy shape with creases, 0.1 %: which part of its edges with more than 30 degrees has an angle
        within 5 degrees of the clean one
    what smoothing of a mesh and of other triangles differ by: as in flow_peers.py, lengths in hundredths of the
        diameter
"""

import sys
import time

import flow_peers  # first: it asks for one thread
import igl
import numpy as np
import python_peers as peers
import restricted_laplacian as rl
import scipy.sparse.linalg
from support.peers import arguments, print_header

areas, row, heading = flow_peers.areas, flow_peers.row, flow_peers.heading
NOISY, CREASED, LENGTHS = "bunny_closed_70k", "fandisk_14k", (4, 6, 8, 10, 12, 16)
MESHES = [NOISY, CREASED, "bimba_46k", "armadillo_mc1m"]


def weight(length):
    return (2 * np.pi / length) ** 2


def matrices(V, F):
    return -igl.cotmatrix(V, F), igl.massmatrix(V, F, igl.MASSMATRIX_TYPE_VORONOI)


def implicit(V, F, length):
    S, M = matrices(V, F)
    return peers.factorize(S + weight(length) * M, "cholmod")(weight(length) * (M @ V))


def filtered(V, F, length):
    S, M = matrices(V, F)
    a = weight(length)
    return scipy.sparse.linalg.splu((S - 1j * a * M).tocsc()).solve((a * (M @ V)).astype(complex)).imag


def normals(V, F):
    n = np.cross(V[F[:, 1]] - V[F[:, 0]], V[F[:, 2]] - V[F[:, 0]])
    return n / np.linalg.norm(n, axis=1)[:, None]


def noisy(V, F, deviation):
    diameter = np.linalg.norm(np.ptp(V, axis=0))
    at_vertices = igl.per_vertex_normals(V, F)
    noise = np.random.default_rng(1).standard_normal(len(V))
    return V + deviation * diameter * noise[:, None] * at_vertices, at_vertices


def edges(F):
    """Pairs of faces at an edge, and its ends, in the direction of the first one."""
    half = {}
    result = []
    for f, t in enumerate(F):
        for i in range(3):
            a, b = int(t[i]), int(t[(i + 1) % 3])
            if (b, a) in half:
                result.append((half[(b, a)], f, b, a))
            half[(a, b)] = f
    return np.array(result).T


def turns(V, F, at):
    f, g, a, b = at
    n = normals(V, F)
    along = V[b] - V[a]
    along = along / np.linalg.norm(along, axis=1)[:, None]
    return np.degrees(np.arctan2((np.cross(n[f], n[g]) * along).sum(1), (n[f] * n[g]).sum(1)))


def timed(work):
    start = time.perf_counter()
    result = work()
    return result, time.perf_counter() - start


def responses():
    heading("what", "length", "kept", "formula")
    V, F = rl.icosphere(5)
    x, y, z = V.T
    waves = np.column_stack([z, x * y, z * (5 * z * z - 3), x * y * (7 * z * z - 1), z * (63 * z**4 - 70 * z * z + 15),
                             x * y * (33 * z**4 - 18 * z * z + 1)])
    degree = np.arange(1, 7)
    square = degree * (degree + 1.)
    for length in (1., 2.):
        a = weight(length)
        for what, result, formula in (
                ("smooth", rl.smooth_surface(V, F, length, signal=waves, depth=5, threads=1), 1 / (1 + (square / a) ** 2)),
                ("sharpen", rl.sharpen_surface(V, F, length, 2, signal=waves, depth=5, threads=1),
                 2 - 1 / (1 + (square / a) ** 2)),
                *((f"edit_{scale}", rl.edit_surface(V, F, scale, a, signal=waves, depth=5, threads=1),
                   (a + scale * square) / (a + square)) for scale in (0, 2))):
            kept = (result * waves).sum(0) / (waves * waves).sum(0)
            for k in range(len(degree)):
                row(what, 2 * np.pi / np.sqrt(square[k]) / length, kept[k], formula[k])


def noise(V, F):
    heading("filter", "edges", "error", "angle", "noisy_s")
    X, at_vertices = noisy(V, F, 0.003)
    area = areas(V, F)
    edge = np.sqrt(4 / np.sqrt(3) * area.mean())
    mass = igl.massmatrix(V, F, igl.MASSMATRIX_TYPE_VORONOI).diagonal()
    clean = normals(V, F)

    def figures(Y):
        d = ((Y - V) * at_vertices).sum(1)
        angle = np.degrees(np.arccos(np.clip((normals(Y, F) * clean).sum(1), -1, 1)))
        return np.sqrt(mass @ d**2 / mass.sum()), area @ angle / area.sum()
    unit, angle = figures(X)
    row("none", 0, 1., angle, 0.)
    for name, smooth in (("implicit", implicit), ("filter", filtered),
                         ("restricted", lambda X, F, length: rl.smooth_surface(X, F, length, threads=1))):
        for length in LENGTHS:
            Y, seconds = timed(lambda: smooth(X, F, length * edge))
            error, angle = figures(Y)
            row(name, length, error / unit, angle, seconds)


def creases(V, F):
    heading("creases", "edges", "error", "angle", "within_5")
    X, at_vertices = noisy(V, F, 0.001)
    area = areas(V, F)
    edge = np.sqrt(4 / np.sqrt(3) * area.mean())
    at = edges(F)
    of_clean, clean = turns(V, F, at), normals(V, F)
    sharp = abs(of_clean) > 30

    def figures(Y):
        d = ((Y - V) * at_vertices).sum(1)
        angle = np.degrees(np.arccos(np.clip((normals(Y, F) * clean).sum(1), -1, 1)))
        return np.sqrt((d**2).mean()), area @ angle / area.sum(), np.mean(abs(turns(Y, F, at) - of_clean)[sharp] <= 5)
    unit, angle, within = figures(X)
    row("none", 0, 1., angle, within)
    depth = 7
    for name, smooth in (
            ("implicit", implicit),
            ("no_angle", lambda X, F, length: rl.smooth_surface(X, F, length, threads=1)),
            ("anisotropic_10", lambda X, F, length: rl.edit_surface(X, F, 0, weight(length), anisotropic=10, depth=depth,
                                                                   threads=1)),
            ("crease_angle", lambda X, F, length: rl.smooth_surface(X, F, length, crease_angle=30, threads=1))):
        for length in (4, 6, 8, 12):
            error, angle, within = figures(smooth(X, F, length * edge))
            row(name, length, error / unit, angle, within)


def triangles(meshes):
    import fast_simplification

    heading("mesh", "other", "smoothing", "hundredths", "before", "after")
    for name, (V, F) in meshes.items():
        small = fast_simplification.simplify(V.astype(np.float32), F.astype(np.int32), 0.7)
        others = {"simplified": (small[0].astype(float), small[1].astype(np.int64)),
                  "flipped": (V, flow_peers.flipped(V, F))}
        if name == "bunny_closed_70k" and "bunny_uniform_18k" in REMESHED:
            others["remeshed"] = REMESHED["bunny_uniform_18k"]
        diameter = np.linalg.norm(V.max(axis=0) - V.min(axis=0))

        def distance(points, P, G):
            return np.sqrt(igl.point_mesh_squared_distance(points, P, G)[0]).mean() / diameter
        for method, smooth in (("implicit", implicit), ("filter", filtered),
                               ("restricted", lambda X, F, length: rl.smooth_surface(X, F, length, threads=1))):
            for hundredths in (5, 20):
                own = smooth(V, F, hundredths / 100 * diameter)
                for case, (P, G) in others.items():
                    row(name, case, method, hundredths, distance(P, V, F),
                        distance(smooth(P, G, hundredths / 100 * diameter), own, F))


REMESHED = {}


def speed(V, F):
    heading("editing", "depth", "seconds")
    alpha = weight(0.02 * np.linalg.norm(np.ptp(V, axis=0)))
    for depth in (7, 8):
        space, seconds = timed(lambda: rl.Space(V, F, depth=depth, threads=2))
        row("space", depth, seconds)
        editor, seconds = timed(lambda: rl.SurfaceEditor(space, alpha=alpha, threads=2))
        row("editor", depth, seconds)
        row("number", depth, timed(lambda: editor.edit(2))[1])
        scale = np.where(V[:, 1] > 0, 0., 2.)
        row("map", depth, timed(lambda: editor.edit(scale))[1])
        row("anisotropic", depth, timed(lambda: rl.SurfaceEditor(space, alpha=alpha, anisotropic=3, threads=2))[1])


def main():
    o = arguments(__doc__, MESHES)
    print_header("editing_peers", o.mesh, ["numpy", "scipy", "libigl", "scikit-sparse", "fast-simplification"])
    responses()
    meshes = {name: rl.read_mesh(o.folder / f"{name}.ply") for name in o.mesh}
    if NOISY in meshes:
        noise(*meshes[NOISY])
        REMESHED["bunny_uniform_18k"] = rl.read_mesh(o.folder / "bunny_uniform_18k.ply")
    if CREASED in meshes:
        creases(*meshes[CREASED])
    triangles({name: m for name, m in meshes.items() if name not in (CREASED, "armadillo_mc1m")})
    if "armadillo_mc1m" in meshes:
        speed(*meshes["armadillo_mc1m"])
    return 0


if __name__ == "__main__":
    sys.exit(main())

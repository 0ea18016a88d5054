#!/usr/bin/env python3
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces that flow, beside linear elements on the triangles: flow_peers.py FOLDER [MESH...]

FOLDER holds the meshes, MESH are their names without .ply. Needs what python_peers.py needs. One thread.
Linear elements take cotangent weights, Voronoi areas, positions at the vertices, the same implicit steps,
and CHOLMOD, which factorizes in each step, since the matrix changes. Where FLOW_LIBRARIES in the environment names
the program that is built from flow_libraries.cpp, CGAL's smooth_shape() and pmp's implicit_smoothing() run, too.

Two tables:

    steps of the conformal flow of a hundredth of the area: seconds for one, and after 10 and 30 of them the
        deviation from a sphere and the mean distortion, see MeanCurvatureFlow.step
    plain flow for a thousandth of the area in ten steps, of the mesh and of other triangles: what quadric
        simplification leaves of 30 % of them, or the same vertices with edges flipped. The mean distance of
        the vertices of one result from the other one, over the diameter; before is that of the meshes
"""

import os
import pathlib
import subprocess
import sys
import tempfile
import time

for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ[name] = "1"

import igl  # noqa: E402
import numpy as np  # noqa: E402

import python_peers as peers  # noqa: E402
import restricted_laplacian as rl  # noqa: E402
from support.peers import arguments, print_header  # noqa: E402

MESHES = ["bimba_5k", "bimba_46k", "bunny_closed_70k", "armadillo"]


def areas(V, F):
    return np.linalg.norm(np.cross(V[F[:, 1]] - V[F[:, 0]], V[F[:, 2]] - V[F[:, 0]]), axis=1) / 2


def sphere_deviation(X, F):
    a = areas(X, F)
    center = a @ X[F].mean(axis=1) / a.sum()
    d = np.linalg.norm(X[F] - center, axis=2)
    mean = a @ d.mean(axis=1) / a.sum()
    return float(a @ abs(d - mean).mean(axis=1) / a.sum() / mean)


def distortion(V, X, F):
    def metric(P):
        u, v = P[F[:, 1]] - P[F[:, 0]], P[F[:, 2]] - P[F[:, 0]]
        return (u * u).sum(1), (u * v).sum(1), (v * v).sum(1)
    (a, b, c), (e, f, g) = metric(V), metric(X)
    determinant = a * c - b * b
    ratio = np.maximum(e * g - f * f, 0) / determinant
    half_trace = (a * g + c * e - 2 * b * f) / (2 * determinant)
    with np.errstate(divide="ignore"):
        own = half_trace / np.sqrt(ratio)  # (s1 / s2 + s2 / s1) / 2
    w = areas(V, F)
    return float(w @ own / w.sum())


class Linear:
    """The flow of positions at the vertices."""

    def __init__(self, V, F, conformal):
        self.F, self.X, self.conformal, self.area = F, V.copy(), conformal, areas(V, F).sum()
        self.S = -igl.cotmatrix(V, F)

    def step(self, tau):
        S = self.S if self.conformal else -igl.cotmatrix(self.X, self.F)
        M = igl.massmatrix(self.X, self.F, igl.MASSMATRIX_TYPE_VORONOI)
        self.X = peers.factorize(M + tau * S, "cholmod")(M @ self.X)
        if self.conformal:
            a = areas(self.X, self.F)
            center = a @ self.X[self.F].mean(axis=1) / a.sum()
            self.X = (self.X - center) * np.sqrt(self.area / a.sum()) + center


class Restricted:
    def __init__(self, V, F, conformal, depth):
        self.flow = rl.MeanCurvatureFlow(V, F, conformal=conformal, depth=depth, threads=1)

    def step(self, tau):
        self.flow.step(tau)

    @property
    def X(self):
        return self.flow.positions


def by_library(library, V, F, tau, steps):
    """Seconds of a step, and the positions."""
    with tempfile.TemporaryDirectory() as name:
        before, after = pathlib.Path(name) / "before.off", pathlib.Path(name) / "after.off"
        with open(before, "w", encoding="ascii") as out:
            out.write(f"OFF\n{len(V)} {len(F)} 0\n")
            np.savetxt(out, V, "%.17g")
            np.savetxt(out, np.column_stack([np.full(len(F), 3), F]), "%d")
        run = subprocess.run([os.environ["FLOW_LIBRARIES"], library, before, repr(float(tau)), str(steps), after],
                             capture_output=True, text=True, check=False)
        if run.returncode != 0:
            return None
        return float(run.stdout), rl.read_mesh(after)[0]


def row(*cells):
    print(" ".join(f"{c:>18}" if isinstance(c, str) else f"{c:>18.4g}" for c in cells), flush=True)


def heading(*names):
    print("#" + " ".join(f"{n:>18}" for n in names)[1:], flush=True)


def flipped(V, F):
    """The mesh with edges flipped, one after the other, where neither folds nor double edges come of it."""
    F = F.copy()
    rng = np.random.default_rng(5)
    edges = {}
    for f, t in enumerate(F):
        for i in range(3):
            edges.setdefault(frozenset((int(t[i]), int(t[(i + 1) % 3]))), []).append(f)
    inner = [e for e, faces in edges.items() if len(faces) == 2]
    touched, present = set(), set(edges)
    for k in rng.permutation(len(inner)):
        e = inner[k]
        f, g = edges[e]
        if f in touched or g in touched:
            continue
        c, d = (next(int(v) for v in F[x] if int(v) not in e) for x in (f, g))
        t = [int(v) for v in F[f]]
        i = t.index(c)
        a, b = t[(i + 1) % 3], t[(i + 2) % 3]
        if frozenset((c, d)) in present:
            continue
        new = np.array([[c, a, d], [c, d, b]])
        n = np.cross(V[new[:, 1]] - V[new[:, 0]], V[new[:, 2]] - V[new[:, 0]])
        old = np.cross(V[a] - V[c], V[b] - V[c])
        if (n @ old).min() <= 0.3 * np.linalg.norm(n, axis=1).max() * np.linalg.norm(old):
            continue
        F[f], F[g] = new
        present.add(frozenset((c, d)))
        touched.update((f, g))
    return F


def main():
    o = arguments(__doc__, MESHES)
    import fast_simplification

    print_header("flow_peers", o.mesh, ["numpy", "scipy", "libigl", "scikit-sparse", "fast-simplification"])
    meshes = {name: rl.read_mesh(o.folder / f"{name}.ply") for name in o.mesh}
    heading("mesh", "conformal", "step_s", "sphere_10", "sphere_30", "distortion_10", "distortion_30")
    for name, (V, F) in meshes.items():
        depth = rl.Space(V, F).depth
        methods = {"linear": lambda: Linear(V, F, True),
                   **{f"depth_{d}": lambda d=d: Restricted(V, F, True, d) for d in (depth - 1, depth)}}
        area = areas(V, F).sum()
        for method, make in methods.items():
            flow, figures, seconds = make(), [], np.inf
            for i in range(30):
                start = time.perf_counter()
                flow.step(0.01 * area)
                seconds = min(seconds, time.perf_counter() - start)
                if i + 1 in (10, 30):
                    figures.append((sphere_deviation(flow.X, F), distortion(V, flow.X, F)))
            row(name, method, seconds, figures[0][0], figures[1][0], figures[0][1], figures[1][1])
        for library in ("cgal", "pmp") if "FLOW_LIBRARIES" in os.environ else ():
            after = [by_library(library, V, F, 0.01 * area, steps) for steps in (10, 30)]
            if None not in after:
                row(name, library, min(s for s, _ in after), *(sphere_deviation(X, F) for _, X in after),
                    *(distortion(V, X, F) for _, X in after))

    heading("mesh", "triangles", "flow", "before", "after")
    for name, (V, F) in meshes.items():
        depth = rl.Space(V, F).depth
        small = fast_simplification.simplify(V.astype(np.float32), F.astype(np.int32), 0.7)
        others = {"simplified": (small[0].astype(float), small[1].astype(np.int64)), "flipped": (V, flipped(V, F))}
        diameter = np.linalg.norm(V.max(axis=0) - V.min(axis=0))
        tau = 1e-4 * areas(V, F).sum()

        def distance(points, P, G):
            if not abs(points).max() < 1e3 * diameter:  # the flow left all bounds, and the search would take hours
                return np.inf
            return np.sqrt(igl.point_mesh_squared_distance(points, P, G)[0]).mean() / diameter
        for method, make in (("linear", lambda P, G: Linear(P, G, False)),
                             (f"depth_{depth}", lambda P, G: Restricted(P, G, False, depth))):
            def result(P, G):
                flow = make(P, G)
                for _ in range(10):
                    flow.step(tau)
                return flow.X
            own = result(V, F)
            for case, (P, G) in others.items():
                row(name, case, method, distance(P, V, F), distance(result(P, G), own, F))
    return 0


if __name__ == "__main__":
    sys.exit(main())

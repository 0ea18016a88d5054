#!/usr/bin/env python3
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Functional maps beside pyFM, between surfaces whose correspondence is known: map_peers.py

Needs the package itself, and pip install pyfmaps==1.3.1 numpy==2.4.6. One thread.

The surfaces are a sheet without symmetries, with a hole, and the same sheet rolled onto a cylinder. The target
has 60 x 60 squares of two triangles; the source

    same       60 x 60 squares
    coarse     20 x 20 squares
    stretched  20 x 120 rectangles, so six times as high as wide
    graded     60 x 60 rectangles, 30 times as wide on one side as on the other

Both take the same three landmarks and wave kernel signatures, with their default weights, 20 eigenfunctions for a
first map and ZoomOut to 80 from there, by all vertices, about 3000. A line for each source and method: the mean and
the largest distance, in the flat sheet of size 1, from where vertices of the target are found to where they are, for
the first map and after ZoomOut, and seconds for two spectra, the first map, and ZoomOut with its map of points. Both
find places in faces, pyFM by its precise map, or by nearest vertices where that fails; what a nearest vertex is away
in the mean, is in the column vertex.
"""

import os
import pathlib
import sys
import time

for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ[name] = "1"

import numpy as np  # noqa: E402
import scipy.spatial  # noqa: E402
from pyFM.functional import FunctionalMapping  # noqa: E402
from pyFM.mesh import TriMesh  # noqa: E402

import restricted_laplacian as rl  # noqa: E402
from support.peers import print_header  # noqa: E402

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "python/tests"))
from rolled_sheet import rolled_sheet  # noqa: E402

FIRST, LAST = 20, 80
LANDMARKS = np.array([(0.1, 0.1), (0.9, 0.2), (0.2, 0.9)])


def even(n):
    return np.arange(n + 1) / n


def graded(n):
    widths = 30 ** (np.arange(n) / (n - 1))
    return np.concatenate([[0], np.cumsum(widths) / widths.sum()])


SOURCES = {"same": (even(60), even(60)), "coarse": (even(20), even(20)), "stretched": (even(120), even(20)),
           "graded": (graded(60), even(60))}


def restricted(source, target, landmarks, away):
    begin = time.perf_counter()
    spectra = [rl.laplace_spectrum(points, faces, LAST, threads=1) for _, points, faces in (source, target)]
    middle = time.perf_counter()
    initial = rl.functional_map(*spectra, landmarks=landmarks, count=FIRST)
    first = initial.point_map()
    end = time.perf_counter()
    larger = rl.zoomout(initial, number=4000).point_map()
    last = time.perf_counter()

    def errors(found):
        return away(np.einsum("nk,nkc->nc", found.barycentric, source[0][source[2][found.faces]]))
    return errors(first), errors(larger), (middle - begin, end - middle, last - end)


def by_pyfm(source, target, landmarks, away):
    begin = time.perf_counter()
    meshes = [TriMesh(points, faces) for _, points, faces in (source, target)]
    for mesh in meshes:
        mesh.process(k=LAST, intrinsic=False, verbose=False)
    middle = time.perf_counter()
    model = FunctionalMapping(*meshes)
    model.preprocess(n_descr=100, descr_type="WKS", landmarks=np.stack(landmarks, axis=1), k_process=LAST, k_descr=LAST)
    model.fit(K=(FIRST, FIRST))

    def places(matrix):
        try:
            return model.get_precise_map(matrix, n_jobs=1) @ source[0]
        except ValueError:  # where vertices fall on vertices
            return source[0][model.get_p2p(matrix, n_jobs=1)]
    first = places(model.FM_12)
    end = time.perf_counter()
    larger = places(model.zoomout_refine(nit=LAST - FIRST, step=1))
    last = time.perf_counter()
    return away(first), away(larger), (middle - begin, end - middle, last - end)


def row(*cells):
    print(" ".join(f"{c:>12}" if isinstance(c, str) else f"{c:>12.4g}" for c in cells), flush=True)


def main():
    print_header("map_peers", [], ["numpy", "scipy", "pyfmaps"])
    print("#" + " ".join(f"{n:>12}" for n in (
        "source", "method", "first_mean", "first_max", "last_mean", "last_max", "vertex", "spectra_s", "map_s", "zoomout_s"))[1:])
    target = rolled_sheet(even(60), even(60), 2.5)
    for name, (x, y) in SOURCES.items():
        source = rolled_sheet(x, y, 1e-3)
        landmarks = [scipy.spatial.cKDTree(s[0]).query(LANDMARKS)[1] for s in (source, target)]
        vertex = scipy.spatial.cKDTree(source[0]).query(target[0])[0].mean()

        def away(found):
            return np.linalg.norm(found - target[0], axis=1)
        for method, run in (("restricted", restricted), ("pyFM", by_pyfm)):
            first, last, seconds = run(source, target, landmarks, away)
            row(name, method, first.mean(), first.max(), last.mean(), last.max(), vertex, *seconds)
    return 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Distances that Python users can install, side by side: distance_peers.py FOLDER [MESH...]

FOLDER holds the meshes, MESH are their names without .ply. Needs the package itself, and

    pip install numpy==2.4.6 potpourri3d==1.4.0 pygeodesic==0.1.11

Distances from vertex 0 on one thread: by the package, fast and exact; by pygeodesic, exact windows, which is
the reference; and by the heat method of potpourri3d, with its robust (intrinsic Delaunay) Laplacian. A line
for each mesh and method: vertices; the mean and the worst relative error of the vertices farther than
2 % of the largest distance, in percent; seconds of the setup and of a query, from arrays to arrays.
"""

import os
import time

for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ[name] = "1"

import numpy as np  # noqa: E402
import potpourri3d  # noqa: E402
import pygeodesic.geodesic  # noqa: E402

import restricted_laplacian as rl  # noqa: E402
from support.peers import arguments, print_header  # noqa: E402

MESHES = ["cow_5k8", "cat_16k", "mechpart_15k", "fandisk_32k", "turbine_18k", "pulley_28k",
          "bimba_46k", "bunny_closed_70k", "koala_100k"]


def timed(setup, query):
    begin = time.perf_counter()
    solver = setup()
    middle = time.perf_counter()
    distances = query(solver)
    return distances, middle - begin, time.perf_counter() - middle


def study(name, V, F):
    runs = {
        "pygeodesic": (lambda: pygeodesic.geodesic.PyGeodesicAlgorithmExact(V, F),
                       lambda s: s.geodesicDistances(np.array([0]), None)[0]),
        "exact": (lambda: rl.Geodesics(V, F), lambda s: s.distances(0, exact=True).distances),
        "fast": (lambda: rl.Geodesics(V, F), lambda s: s.distances(0).distances),
        "potpourri3d": (lambda: potpourri3d.MeshHeatMethodDistanceSolver(V, F),
                        lambda s: s.compute_distance(0)),
    }
    reference = None
    for method, (setup, query) in runs.items():
        try:
            distances, setup_seconds, seconds = timed(setup, query)
        except Exception as e:  # a peer that fails is told of
            print(f"# {name}: {method} failed: {e}", flush=True)
            continue
        if reference is None:
            reference = distances
        far = np.isfinite(reference) & (reference > 0.02 * reference[np.isfinite(reference)].max())
        errors = 100 * abs(distances[far] / reference[far] - 1)
        print(f"{name:18} {len(V):7} {method:12} {errors.mean():10.6f} {errors.max():10.5f} "
              f"{setup_seconds:8.4f} {seconds:8.4f}", flush=True)


def main():
    o = arguments(__doc__, MESHES)
    print_header("distance_peers", o.mesh, ["numpy", "potpourri3d", "pygeodesic"])
    print(f"# {'mesh':16} {'n':>7} {'method':12} {'mean':>10} {'worst':>10} {'setup_s':>8} "
          f"{'query_s':>8}", flush=True)
    for name in o.mesh:
        study(name, *rl.read_mesh(o.folder / f"{name}.ply"))


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Distances between many vertices of a cortical surface: distance_matrix.py [all]

Needs what cortex_peers.py and distance_peers.py need. The package takes two threads, the others have one. With
"all" the distances between all vertices go to a temporary file, too (3.5 GB, an hour).

Tables:

    seconds for 200 x 200 distances, for a row of all vertices, and for all that is within 10 mm of a vertex:
        means over 200 sources
    relative errors of the distances farther than 2 % of the largest one, from 20 sources: the mean and the
        largest, against exact ones
    with "all": seconds for all pairs, into a memory map of float32; between the 200 sources they are compared
        with those of the first table
"""

import sys
import tempfile
import time

import numpy as np
import potpourri3d
import pygeodesic.geodesic
from cortex_peers import cortex, heading, row
from support.peers import print_header

import restricted_laplacian as rl


def tell(share):
    print(f"{100 * share:.1f} %", end="\r", file=sys.stderr, flush=True)


def main():
    V, F, _ = cortex()
    print_header("distance_matrix", sys.argv[1:], ["numpy", "neuromodes", "potpourri3d", "pygeodesic"])
    print(f"# {len(V)} vertices, {len(F)} triangles")
    some = np.linspace(0, len(V) - 1, 200).astype(int)
    geodesics = rl.Geodesics(V, F, threads=2)

    def seconds(work, number):
        begin = time.perf_counter()
        work()
        return (time.perf_counter() - begin) / number
    heading("method", "square_s", "row_s", "near_s")
    with tempfile.NamedTemporaryFile() as file:
        rows = np.memmap(file, np.float32, "w+", shape=(len(some), len(V)))
        square = []
        row("restricted", seconds(lambda: square.append(geodesics.distance_matrix(some, some)), 1),
            seconds(lambda: geodesics.distance_matrix(some, out=rows), len(some)),
            seconds(lambda: geodesics.distance_matrix(some, maximum_distance=10), len(some)))
    few = some[::10]
    exact = pygeodesic.geodesic.PyGeodesicAlgorithmExact(V, F)
    heat = potpourri3d.MeshHeatMethodDistanceSolver(V, F)
    found = {}

    def by_others(name, work):
        begin = time.perf_counter()
        found[name] = np.stack([work(int(v)) for v in few])
        one = (time.perf_counter() - begin) / len(few)
        row(name, len(some) * one, one, one)
    by_others("pygeodesic", lambda v: exact.geodesicDistances(np.array([v]), None)[0])
    by_others("potpourri3d", heat.compute_distance)
    found["restricted"] = geodesics.distance_matrix(few)
    heading("method", "mean_error", "max_error")
    reference = found.pop("pygeodesic")
    far = reference > 0.02 * reference.max()
    for name, d in found.items():
        errors = abs(d - reference)[far] / reference[far]
        row(name, errors.mean(), errors.max())
    if sys.argv[1:] == ["all"]:
        with tempfile.NamedTemporaryFile() as file:
            every = np.memmap(file, np.float32, "w+", shape=(len(V), len(V)))
            taken = seconds(lambda: (geodesics.distance_matrix(out=every, progress=tell), every.flush()), 1)
            np.testing.assert_allclose(every[np.ix_(some, some)], square[0], rtol=1e-6)
        heading("method", "all_s")
        row("restricted", taken)
    return 0


if __name__ == "__main__":
    sys.exit(main())

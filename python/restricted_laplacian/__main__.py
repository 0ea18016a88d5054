# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""python -m restricted_laplacian MESH: what there is to know about a mesh."""

from __future__ import annotations

import argparse
import sys
import time

import numpy as np

import restricted_laplacian as rl


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m restricted_laplacian", description=__doc__)
    parser.add_argument("mesh", help="any file that read_mesh reads")
    parser.add_argument("--depth", type=int, help="of the octree")
    parser.add_argument("--count", type=int, default=10, help="number of eigenvalues")
    parser.add_argument("--threads", type=int, help="all processors by default")
    parser.add_argument("--version", action="version", version=rl.__version__)
    o = parser.parse_args()
    try:
        start = time.monotonic()
        V, F = rl.read_mesh(o.mesh)
        space = rl.Space(V, F, depth=o.depth, threads=o.threads)
        low, high = np.nanmin(V, axis=0), np.nanmax(V, axis=0)
        print(f"vertices     {len(V)}")
        print(f"faces        {len(F)}")
        print(f"degenerate   {space._surface.number_of_degenerate_faces}")
        print(f"components   {space.components}")
        print(f"area         {space.area:g}")
        print("box          " + " x ".join(f"{x:g}" for x in high - low))
        print(f"depth        {space.depth}")
        print(f"unknowns     {space.dimension}")
        spectrum = rl.laplace_spectrum(space, None, o.count, progress=sys.stderr.isatty())
        zeros = rl.number_of_zero_eigenvalues(spectrum)
        print("eigenvalues  " + " ".join(["0"] * zeros + [f"{x:.4g}" for x in
                                                          spectrum.eigenvalues[zeros:]]))
        print(f"seconds      {time.monotonic() - start:.2f}")
    except (ValueError, RuntimeError, MemoryError) as e:
        print(f"restricted_laplacian: {e}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())

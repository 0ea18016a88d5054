# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the comparisons in Python share: the command line, and the head of a result."""

import argparse
import importlib.metadata
import os
import pathlib
import platform
import subprocess

import numpy as np

import restricted_laplacian as rl


def arguments(doc, meshes):
    """The folder of meshes, and their names, by default `meshes`."""
    parser = argparse.ArgumentParser(description=doc,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("mesh", nargs="*", default=meshes)
    return parser.parse_args()


def print_header(name, meshes, packages):
    """Commit, machine, command, and versions of packages."""
    commit = subprocess.run(["git", "describe", "--always", "--dirty"],
                            cwd=pathlib.Path(__file__).parent, text=True,
                            capture_output=True).stdout.strip() or "unknown"
    print(f"# commit: {commit}")
    print(f"# machine: {platform.machine()}, {os.cpu_count()} cores")
    print("# command:", " ".join([name, *meshes]))
    print("# versions:", ", ".join(f"{p} {importlib.metadata.version(p)}" for p in packages)
          + f", restricted-laplacian {rl.__version__}")


def refined(V, F):
    """Triangles divided into four."""
    edges = np.sort(F[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    unique, number = np.unique(edges, axis=0, return_inverse=True)
    a, b, c = (len(V) + number.reshape(-1, 3)).T
    x, y, z = F.T
    return (np.concatenate([V, V[unique].mean(axis=1)]),
            np.concatenate([np.stack(t, axis=1)
                            for t in ((x, a, c), (y, b, a), (z, c, b), (a, b, c))]))

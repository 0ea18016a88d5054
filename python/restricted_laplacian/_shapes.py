# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Shapes to try things on."""

from __future__ import annotations

import numpy as np

from ._errors import argument_error


def icosphere(subdivisions: int = 3) -> tuple[np.ndarray, np.ndarray]:
    """The unit sphere, by an icosahedron whose triangles are divided into four again and again.

    Parameters
    ----------
    subdivisions : int, default 3
        How often: there are 20 * 4**subdivisions triangles.

    Returns
    -------
    V : numpy.ndarray, (n, 3)
        Points on the sphere.
    F : numpy.ndarray, (m, 3)
        Triangles, with normals outward.

    Raises
    ------
    InputError
        The number is none.

    Examples
    --------
    >>> V, F = icosphere(2)
    >>> V.shape, F.shape
    ((162, 3), (320, 3))
    """
    if isinstance(subdivisions, bool) or not isinstance(subdivisions, (int, np.integer)) or not (
            0 <= subdivisions <= 12):
        raise argument_error("subdivisions", f"must be a whole number from 0 to 12, and is {subdivisions!r}")
    t = (1 + 5 ** 0.5) / 2
    V = np.array([[-1, t, 0], [1, t, 0], [-1, -t, 0], [1, -t, 0], [0, -1, t], [0, 1, t],
                  [0, -1, -t], [0, 1, -t], [t, 0, -1], [t, 0, 1], [-t, 0, -1], [-t, 0, 1]])
    F = np.array([[0, 11, 5], [0, 5, 1], [0, 1, 7], [0, 7, 10], [0, 10, 11], [1, 5, 9], [5, 11, 4],
                  [11, 10, 2], [10, 7, 6], [7, 1, 8], [3, 9, 4], [3, 4, 2], [3, 2, 6], [3, 6, 8],
                  [3, 8, 9], [4, 9, 5], [2, 4, 11], [6, 2, 10], [8, 6, 7], [9, 8, 1]])
    for _ in range(subdivisions):
        edges = np.sort(F[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
        unique, number = np.unique(edges, axis=0, return_inverse=True)
        middles = len(V) + number.reshape(-1, 3)
        V = np.concatenate([V, V[unique].mean(axis=1)])
        a, b, c = middles.T
        F = np.concatenate([np.stack(f, axis=1) for f in (
            (F[:, 0], a, c), (F[:, 1], b, a), (F[:, 2], c, b), (a, b, c))])
    return V / np.linalg.norm(V, axis=1)[:, np.newaxis], F

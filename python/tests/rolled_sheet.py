# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""A surface that can be bent without changing lengths, for tests and benchmarks of maps."""

from __future__ import annotations

import numpy as np


def rolled_sheet(x, y, curvature):
    """Places in the plane, points and triangles of a sheet without symmetries, with a hole, rolled onto a cylinder.

    x and y are the coordinates of its columns and rows, from 0 to 1.
    """
    plane = np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2)
    m, n = len(y) - 1, len(x) - 1
    a = (np.arange(m)[:, None] * (n + 1) + np.arange(n)).ravel()
    faces = np.concatenate([np.stack([a, a + 1, a + n + 2], axis=1), np.stack([a, a + n + 2, a + n + 1], axis=1)])
    middle = plane[faces].mean(axis=1)
    is_cut = ((middle > [0.6, 0.5]).all(axis=1)) | ((abs(middle - [0.3, 0.6]) < [0.1, 0.15]).all(axis=1))
    used, faces = np.unique(faces[~is_cut], return_inverse=True)
    plane = plane[used]
    u, v = plane.T
    points = np.stack([np.sin(curvature * u) / curvature, v, (1 - np.cos(curvature * u)) / curvature], axis=1)
    return plane, points, faces.reshape(-1, 3)

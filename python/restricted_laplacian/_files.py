# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Meshes in files."""

from __future__ import annotations

import os
from typing import Union

import numpy as np

from . import _core


def read_mesh(file: Union[str, "os.PathLike[str]"]) -> tuple[np.ndarray, np.ndarray]:
    """Points and triangles of a file: off, obj, ply, stl or ts.

    Nothing is merged, cut or turned. Faces that are not triangles are divided.

    Parameters
    ----------
    file : path

    Returns
    -------
    V : numpy.ndarray, (n, 3)
    F : numpy.ndarray, (m, 3)

    Raises
    ------
    InputError
        The file cannot be read, or names no surface.
    """
    surface = _core.Surface.of_file(os.fspath(file))
    return surface.points(), surface.faces()

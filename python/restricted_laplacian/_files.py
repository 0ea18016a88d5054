# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Meshes in files."""

from __future__ import annotations

import os
from typing import Union

import numpy as np

from . import _core
from ._input import Progress, listener


def read_mesh(file: Union[str, "os.PathLike[str]"], *, progress: Progress = None
              ) -> tuple[np.ndarray, np.ndarray]:
    """Points and triangles of a file: off, obj, ply, stl, vtk (legacy PolyData) or ts.

    Nothing is merged (but in stl files, which have no indices), cut or turned. Faces that are not
    triangles are divided. What is passed over, as bytes behind the end, is a warning.

    Parameters
    ----------
    file : path
    progress : bool or callable, optional
        A bar, or what is called with the part of the file that is read.

    Returns
    -------
    V : numpy.ndarray, (n, 3)
    F : numpy.ndarray, (m, 3)

    Raises
    ------
    InputError
        The file cannot be read, or names no surface: with the line or byte and what is wrong there,
        and the vertex or face as attributes.
    """
    surface = _core.Surface.of_file(os.fspath(file), listener(progress))
    return surface.points(), surface.faces()

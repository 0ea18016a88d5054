# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""What callers give: surfaces, functions on them, threads, progress."""

from __future__ import annotations

import sys
import time
from typing import Any, Callable, Optional, Union

import numpy as np

from . import _core
from ._errors import InputError, argument_error

Progress = Union[bool, None, Callable[[float], Any]]

_TYPES = {np.dtype(t) for t in (np.float64, np.float32, np.int64, np.int32, np.uint64, np.uint32,
                                np.int16, np.uint16, np.int8, np.uint8)}


def numbers(values: Any, name: str, dtype: Any = None) -> np.ndarray:
    """An array of real numbers; a view where that is possible."""
    try:
        array = np.asarray(values)
    except Exception as e:  # ragged lists
        raise argument_error(name, f"is not an array: {e}") from None
    if array.dtype.kind not in "fiu":
        raise argument_error(name, f"must be an array of numbers, and has the type {array.dtype}")
    if dtype is not None:
        return np.require(array, dtype, ["C", "ALIGNED"])
    if array.dtype not in _TYPES:  # other sizes, and other orders of bytes
        array = array.astype(np.float64 if array.dtype.kind == "f" else np.int64)
    return np.require(array, requirements=["ALIGNED"])  # fields of packed records are not


def rows(values: Any, name: str) -> np.ndarray:
    """An array of float64 with two dimensions, row after row."""
    array = numbers(values, name, np.float64)
    if array.ndim == 1:
        array = array[:, np.newaxis]
    if array.ndim != 2:
        raise argument_error(name, f"has {array.ndim} dimensions, but must have one or two")
    return array


def number_of_threads(threads: Optional[int]) -> int:
    if threads is None:
        return 0
    if isinstance(threads, bool) or not isinstance(threads, (int, np.integer)) or threads < 1:
        raise argument_error("threads", "must be a positive number, or None for all processors")
    return int(threads)


class _Bar:
    """A bar on the standard error stream, a line for every tenth where that is no terminal."""

    width = 30

    def __init__(self) -> None:
        self.is_terminal = sys.stderr.isatty()
        self.shown = -1
        self.start = time.monotonic()

    def __call__(self, done: float) -> None:
        percent = int(100 * done)
        if percent <= self.shown or (not self.is_terminal and percent < self.shown + 10):
            return
        self.shown = percent
        seconds = time.monotonic() - self.start
        if self.is_terminal:
            filled = int(self.width * done)
            bar = "#" * filled + " " * (self.width - filled)
            end = "\n" if percent >= 100 else ""
            print(f"\r[{bar}] {percent:3d} % {seconds:6.1f} s", end=end, file=sys.stderr, flush=True)
        else:
            print(f"{percent} % after {seconds:.1f} s", file=sys.stderr, flush=True)


def listener(progress: Progress) -> Optional[Callable[[float], Any]]:
    """What the C++ library calls with the part that is done."""
    if progress is None or progress is False:
        return None
    if progress is True:
        return _Bar()
    if not callable(progress):
        raise argument_error("progress", "must be True, False or a callable")
    return progress


def _mesh_arrays(mesh: Any) -> Optional[tuple[Any, Any]]:
    """Points and faces of a mesh of trimesh, meshio, or what looks like one."""
    if hasattr(mesh, "vertices") and hasattr(mesh, "faces"):
        return mesh.vertices, mesh.faces
    if hasattr(mesh, "points") and hasattr(mesh, "cells_dict"):
        faces = mesh.cells_dict.get("triangle")
        if faces is None:
            raise argument_error("V", "is a mesh without triangles")
        return mesh.points, faces
    return None


def make_surface(V: Any, F: Any = None, *, normals: Any = None, areas: Any = None,
                 neighbors: Optional[int] = None, threads: Optional[int] = None
                 ) -> _core.Surface:
    """The surface of the C++ library."""
    if isinstance(V, _core.Surface):
        if F is not None or normals is not None:
            raise InputError("a surface needs neither F nor normals")
        return V
    if F is None and normals is None:
        mesh = _mesh_arrays(V)
        if mesh is None:
            raise argument_error("F", "is missing: give faces, or normals for points without faces")
        V, F = mesh
    if F is not None:
        if normals is not None or areas is not None:
            raise argument_error("normals", "and areas belong to points without faces")
        return _core.Surface.of_triangles(numbers(V, "V"), numbers(F, "F"))
    if areas is not None:
        areas = numbers(areas, "areas", np.float64).ravel()
    if neighbors is None:
        neighbors = _core.default_neighbors
    if isinstance(neighbors, bool) or not isinstance(neighbors, (int, np.integer)):
        raise argument_error("neighbors", f"must be a whole number, and is {neighbors!r}")
    return _core.Surface.of_points(numbers(V, "V"), numbers(normals, "normals"), areas,
                                   int(np.clip(neighbors, -1, 10 ** 6)),
                                   number_of_threads(threads))


class Corners:
    """Values at the corners of the faces, which may jump from one face to the next.

    Parameters
    ----------
    values : array_like, (m, 3) or (m, 3, 3) or (m, 3, 3, K)
        Of each face, at its first, second and third vertex: a number; a vector; or the columns of
        a matrix, a vector for each channel.
    """

    def __init__(self, values: Any) -> None:
        self.values = numbers(values, "values", np.float64)
        if self.values.ndim not in (2, 3, 4) or self.values.shape[1] != 3:
            raise argument_error("values", "must have the shape (m, 3), (m, 3, 3) or (m, 3, 3, K)")


def as_function(f: Any, surface: _core.Surface, name: str, vectors: bool = False,
                smooth: Optional[Callable[[np.ndarray], _core.Function]] = None
                ) -> _core.Function:
    """A function on a surface: an array at vertices or faces, a number, or a callable.

    With `vectors` an array has the shape (n, 3), or (n, 3, K) with a vector for each channel.
    `smooth` makes a function of an array at vertices that is not linear between them.
    """
    if callable(f):
        probe = np.ascontiguousarray(surface.points()[:3])
        probe = np.nan_to_num(probe)
        values = np.asarray(f(probe))
        if values.ndim == 0 or values.shape[0] != len(probe):
            raise argument_error(
                name, f"returns an array of the shape {values.shape} for {len(probe)} points; its "
                "first dimension must be that of the points")
        components = int(values.size // max(1, len(probe)))
        wrapped = f
        if vectors and values.ndim == 3:  # (n, 3, K): the channels one after the other
            def wrapped(points: np.ndarray) -> np.ndarray:
                v = np.asarray(f(points))
                return np.moveaxis(v, 2, 1).reshape(len(points), -1)
        return _core.callable_function(wrapped, components, int(getattr(f, "degree", 6)))
    at = ""
    if isinstance(f, Corners):
        at = "corners"
        f = f.values.reshape(-1, *f.values.shape[2:])
    array = numbers(f, name, np.float64)
    n, m = surface.number_of_vertices, surface.number_of_faces
    if array.ndim == 0 and not vectors:
        return _core.array_function(np.full((m, 1), float(array)), "faces")
    if array.ndim == 0:
        raise argument_error(name, "must be an array of vectors")
    length = array.shape[0]
    if at != "corners":
        if length not in (n, m):
            raise argument_error(
                name, f"has {length} rows, but there are {n} vertices and {m} faces")
        at = "vertices" if length == n else "faces"
    if vectors and array.ndim == 3:
        array = np.moveaxis(array, 2, 1)
    if array.ndim > (3 if vectors else 2):
        raise argument_error(name, f"has {array.ndim} dimensions")
    if array.ndim == 1:
        array = array[:, np.newaxis]
    array = np.ascontiguousarray(array.reshape(length, -1))
    if smooth is not None and at == "vertices":
        return smooth(array)
    return _core.array_function(array, at)

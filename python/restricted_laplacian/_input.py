# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""What callers give: surfaces, functions on them, threads, progress."""

from __future__ import annotations

import copyreg
import functools
import sys
import time
from typing import Any, Callable, NamedTuple, Optional, TypeVar, Union

import numpy as np

from . import _core
from ._errors import InputError, argument_error

Progress = Union[bool, None, Callable[[float], Any]]
_Function = TypeVar("_Function", bound=Callable[..., Any])

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


def vertex_numbers(values: Any, name: str, number_of_vertices: int) -> np.ndarray:
    """Vertices: one number, several, or a mask with a truth value for each."""
    array = np.asarray(values)
    if array.dtype.kind == "b":
        if array.shape != (number_of_vertices,):
            raise argument_error(name, f"is a mask of the shape {array.shape}, but must have "
                                 f"({number_of_vertices},): a truth value for each vertex")
        return np.flatnonzero(array)
    return whole_numbers(values, name)


def whole_numbers(values: Any, name: str) -> np.ndarray:
    """Whole numbers from 0 on, in a row."""
    given = numbers(values, name).ravel()
    with np.errstate(invalid="ignore"):  # NaN
        result = given.astype(np.int64)
    if not np.array_equal(result, given) or (result < 0).any():
        raise argument_error(name, "must be whole numbers from 0 on")
    return result


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


class Polygons(NamedTuple):
    """Faces with any number of corners."""
    corners: np.ndarray  #: numbers of points, one face after the other
    sizes: np.ndarray  #: number of corners of each face


def polygons_of(F: Any) -> Optional[Polygons]:
    """Faces, given as rows of more than three columns or as lists, that are not all triangles."""
    if isinstance(F, Polygons):
        return F
    if isinstance(F, (list, tuple)) or getattr(F, "dtype", None) == np.dtype(object):
        try:
            sizes = np.array([len(face) for face in F], np.int64)
        except TypeError:  # not a list of lists
            return None
        if len(np.unique(sizes)) > 1:
            return Polygons(np.concatenate([numbers(face, "F").ravel() for face in F if len(face)]), sizes)
    array = numbers(F, "F")
    if array.ndim != 2 or array.shape[1] <= 3:
        return None
    return Polygons(array.ravel(), np.full(len(array), array.shape[1], np.int64))


def _triangles_or_polygons(corners: np.ndarray, sizes: np.ndarray) -> Any:
    return corners.reshape(-1, 3) if (sizes == 3).all() else Polygons(corners, sizes)


def _of_vtk(mesh: Any) -> tuple[Any, Any]:
    """PolyData of VTK or PyVista: its polygons, without lines and vertices."""
    from vtkmodules.util.numpy_support import vtk_to_numpy  # type: ignore[import-not-found,unused-ignore]
    if mesh.GetNumberOfStrips() > 0:
        from vtkmodules.vtkFiltersCore import vtkTriangleFilter  # type: ignore[import-not-found,unused-ignore]
        divide = vtkTriangleFilter()
        divide.SetInputData(mesh)
        divide.Update()
        mesh = divide.GetOutput()
    polygons = mesh.GetPolys()
    if mesh.GetPoints() is None or polygons.GetNumberOfCells() == 0:
        raise argument_error("V", "is a mesh without faces")
    corners, sizes = (vtk_to_numpy(a) for a in (polygons.GetConnectivityArray(), polygons.GetOffsetsArray()))
    return vtk_to_numpy(mesh.GetPoints().GetData()), _triangles_or_polygons(corners, np.diff(sizes))


def _of_meshio(mesh: Any) -> tuple[Any, Any]:
    """The triangles, quadrangles and polygons of a mesh of meshio, in its order."""
    faces = [np.asarray(block.data) for block in mesh.cells if block.type in ("triangle", "quad", "polygon")]
    if not faces:
        raise argument_error("V", "is a mesh without triangles; it has " + (
            ", ".join(sorted({block.type for block in mesh.cells})) or "no cells"))
    points = np.asarray(mesh.points)
    if points.ndim == 2 and points.shape[1] == 2:  # in a plane
        points = np.column_stack([points, np.zeros(len(points))])
    return points, _triangles_or_polygons(np.concatenate([f.ravel() for f in faces]),
                                          np.concatenate([np.full(len(f), f.shape[1]) for f in faces]))


def _of_gifti(mesh: Any) -> tuple[Any, Any]:
    V, F = mesh.agg_data(("pointset", "triangle"))
    if len(V) == 0 or len(F) == 0:
        raise argument_error("V", "is GIFTI without points and triangles; read_vertex_properties reads data")
    return V, F


def _is_pair(value: Any) -> bool:
    """Whether it is (V, F), and not rows of V."""
    try:
        return len(value) == 2 and np.ndim(value[0]) == 2 and (
            isinstance(value[1], Polygons) or np.ndim(value[1]) == 2)
    except ValueError:  # lists of different lengths, which are polygons
        return np.ndim(value[0]) == 2 if _is_table(value[0]) else False


def _is_table(value: Any) -> bool:
    try:
        return np.ndim(value) == 2
    except ValueError:
        return False


def _of_meshio_or_grid(mesh: Any) -> tuple[Any, Any]:
    if hasattr(mesh, "extract_surface"):  # a grid of PyVista, whose surface has other numbers
        raise argument_error("V", "is a grid; its extract_surface() is a surface")
    return _of_meshio(mesh)


# what meshes of other libraries have, and points and faces of them
_LIBRARIES: tuple[tuple[set[str], Callable[[Any], tuple[Any, Any]]], ...] = (
    ({"agg_data"}, _of_gifti),  # nibabel
    ({"GetPolys"}, _of_vtk),  # VTK, PyVista
    ({"points", "cells_dict"}, _of_meshio_or_grid),
    ({"vertices", "faces"}, lambda m: (m.vertices, m.faces)),  # trimesh
    ({"vertices", "triangles"}, lambda m: (m.vertices, m.triangles)),  # Open3D
    ({"v", "t"}, lambda m: (m.v, m.t)),  # LaPy
    ({"vertex", "triangle"}, lambda m: (m.vertex.positions.numpy(), m.triangle.indices.numpy())),  # Open3D
)


def _library_of(mesh: Any) -> Optional[Callable[[Any], tuple[Any, Any]]]:
    """What takes points and faces out of a mesh of another library, if it is one."""
    return next((read for has, read in _LIBRARIES if all(hasattr(mesh, name) for name in has)), None)


def mesh_arrays(mesh: Any) -> Optional[tuple[Any, Any]]:
    """Points and faces of a pair (V, F), or of a mesh of another library."""
    if isinstance(mesh, (tuple, list)):
        return (mesh[0], mesh[1]) if _is_pair(mesh) else None
    read = _library_of(mesh)
    return read(mesh) if read else None


def is_surface(value: Any) -> bool:
    """Whether it is a surface as a whole: a space, a pair (V, F), or a mesh of another library."""
    if isinstance(value, (tuple, list)):
        return _is_pair(value)
    return (isinstance(value, _core.Surface) or hasattr(value, "_surface")
            or _library_of(value) is not None)


def takes_surface(function: _Function) -> _Function:
    """Lets a surface as a whole stand for the two arguments V and F, as the first of a function."""
    first = 1 if function.__name__ == "__init__" else 0

    @functools.wraps(function)
    def call(*arguments: Any, **options: Any) -> Any:
        if ("F" not in options and len(arguments) > first + 1 and arguments[first + 1] is not None
                and is_surface(arguments[first])):
            arguments = (*arguments[:first + 1], None, *arguments[first + 1:])
        return function(*arguments, **options)
    return call  # type: ignore[return-value]


def make_surface(V: Any, F: Any = None, *, normals: Any = None, areas: Any = None,
                 neighbors: Optional[int] = None, threads: Optional[int] = None
                 ) -> _core.Surface:
    """The surface of the C++ library."""
    if isinstance(V, _core.Surface):
        if F is not None or normals is not None:
            raise InputError("a surface needs neither F nor normals")
        return V
    if hasattr(V, "_surface"):
        return make_surface(V._surface, F, normals=normals)
    if F is None and normals is None:
        mesh = mesh_arrays(V)
        if mesh is None:
            raise argument_error("F", "is missing: give faces, or normals for points without faces")
        V, F = mesh
    if F is not None:
        if normals is not None or areas is not None:
            raise argument_error("normals", "and areas belong to points without faces")
        polygons = polygons_of(F)
        if polygons is None:
            return _core.Surface.of_triangles(numbers(V, "V"), numbers(F, "F"))
        return _core.Surface.of_polygons(numbers(V, "V"), numbers(polygons.corners, "F"),
                                         np.ascontiguousarray(polygons.sizes, np.int64))
    if areas is not None:
        areas = numbers(areas, "areas", np.float64).ravel()
    if neighbors is None:
        neighbors = _core.default_neighbors
    if isinstance(neighbors, bool) or not isinstance(neighbors, (int, np.integer)):
        raise argument_error("neighbors", f"must be a whole number, and is {neighbors!r}")
    return _core.Surface.of_points(numbers(V, "V"), numbers(normals, "normals"), areas,
                                   int(np.clip(neighbors, -1, 10 ** 6)),
                                   number_of_threads(threads))


def _surface_again(points: np.ndarray, faces: Any, normals: Any, areas: Any) -> _core.Surface:
    """What pickle calls."""
    if faces is None:
        return _core.Surface.of_points(points, normals, areas, _core.default_neighbors, 0)
    return make_surface(points, faces)


def surface_state(surface: _core.Surface) -> tuple[Any, Any, Any, Any]:
    """Points, faces, normals and areas; without faces, or without the others."""
    if surface.is_point_set:
        return surface.points(), None, surface.face_normals(), surface.face_areas()
    faces = Polygons(*surface.polygons()) if surface.has_polygons else surface.faces()
    return surface.points(), faces, None, None


# a flat one; a smooth geometry is what a space knows
copyreg.pickle(_core.Surface, lambda s: (_surface_again, surface_state(s)))  # type: ignore[arg-type]


class Corners:
    """Values at the corners of the faces, which may jump from one face to the next.

    Parameters
    ----------
    values : array_like, (m, k) or (m, k, 3) or (m, k, 3, K), or a list of such without the first axis
        Of each face, at its k corners: a number; a vector; or the columns of a matrix, a vector for
        each channel. A list where faces have different numbers of corners.
    """

    def __init__(self, values: Any) -> None:
        self.sizes: Optional[np.ndarray] = None
        polygons = [] if isinstance(values, np.ndarray) else list(values)
        if len({np.shape(face)[:1] for face in polygons}) > 1:
            self.sizes = np.array([len(face) for face in polygons])
            self.values = np.concatenate([numbers(face, "values", np.float64) for face in polygons])[:, np.newaxis]
        else:
            self.values = numbers(values, "values", np.float64)
        if self.values.ndim not in (2, 3, 4) or (self.sizes is None and self.values.shape[1] < 3):
            raise argument_error("values", "must have the shape (m, k), (m, k, 3) or (m, k, 3, K)")

    def _of_triangles(self, surface: _core.Surface, name: str) -> np.ndarray:
        """The values at the corners of the triangles, one after the other."""
        sizes = np.full(len(self.values), self.values.shape[1]) if self.sizes is None else self.sizes
        expected = surface.polygons()[1] if surface.has_polygons else np.full(surface.number_of_faces, 3)
        if not np.array_equal(sizes, expected):
            raise argument_error(name, f"has values at {sizes.sum()} corners of {len(sizes)} faces, but there are "
                                 f"{len(expected)} faces with {expected.sum()} corners")
        values = self.values.reshape(-1, *self.values.shape[2:])
        if not surface.has_polygons:
            return values
        first = np.cumsum(sizes) - sizes
        return values[(first[surface.polygons_of_faces()][:, np.newaxis] + surface.corners_of_polygons()).ravel()]


def _check_finite(array: np.ndarray, surface: _core.Surface, name: str, at: str) -> None:
    """Names the first vertex or face where a number is none, if that matters."""
    is_bad = ~np.isfinite(array).all(axis=1)
    if not is_bad.any():
        return
    counts = surface.face_areas() > 0
    if at == "vertices" and not surface.is_point_set:
        of_faces = counts
        counts = np.zeros(surface.number_of_vertices, bool)
        counts[surface.faces()[of_faces]] = True
    elif at == "corners":
        counts = np.repeat(counts, 3)
    bad = np.flatnonzero(is_bad & counts)
    if len(bad) == 0:
        return
    kind = "vertex" if at == "vertices" or surface.is_point_set else "face"
    number = int(bad[0]) // (3 if at == "corners" else 1)
    if at != "vertices" and surface.has_polygons:
        number = int(surface.polygons_of_faces()[number])
    value = array[bad[0]][~np.isfinite(array[bad[0]])][0]
    error = argument_error(name, f"is {value} at {kind} {number}")
    setattr(error, kind, number)
    raise error


def as_function(f: Any, surface: _core.Surface, name: str, vectors: bool = False,
                smooth: Optional[Callable[[np.ndarray], _core.Function]] = None,
                everywhere: bool = True) -> _core.Function:
    """A function on a surface: an array at vertices or faces, a number, or a callable.

    With `vectors` an array has the shape (n, 3), or (n, 3, K) with a vector for each channel.
    `smooth` makes a function of an array at vertices that is not linear between them. What is not
    wanted `everywhere` may be NaN.
    """
    if f is None:
        raise argument_error(name, "is missing")
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
        f = f._of_triangles(surface, name)
    array = numbers(f, name, np.float64)
    n, m = surface.number_of_vertices, surface.number_of_polygons
    if array.ndim == 0 and not vectors:
        return _core.array_function(np.full((surface.number_of_faces, 1), float(array)), "faces")
    if array.ndim == 0:
        raise argument_error(name, "must be an array of vectors")
    length = array.shape[0]
    if at != "corners":
        if length not in (n, m):
            raise argument_error(
                name, f"has {length} rows, but there are {n} vertices and {m} faces")
        at = "vertices" if length == n else "faces"
        if at == "faces" and surface.has_polygons:
            array = array[surface.polygons_of_faces()]
            length = len(array)
    if vectors and array.ndim == 3:
        array = np.moveaxis(array, 2, 1)
    if array.ndim > (3 if vectors else 2):
        raise argument_error(name, f"has {array.ndim} dimensions")
    if array.ndim == 1:
        array = array[:, np.newaxis]
    array = np.ascontiguousarray(array.reshape(length, -1))
    if everywhere:
        _check_finite(array, surface, name, at)
    if smooth is not None and at == "vertices":
        return smooth(array)
    return _core.array_function(array, at)

# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Functional maps between surfaces, and the maps of points that belong to them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Optional

import numpy as np

from . import _core
from ._errors import Canceled, argument_error
from ._input import Progress, listener, numbers
from ._show import shown
from ._spectra import Spectrum, heat_kernel_times, wave_kernel_signature

__all__ = ["FunctionalMap", "PointMap", "functional_map", "zoomout"]

_BLOCK = 1 << 19  # numbers of a block of products


class _Samples:
    """Points of a surface, the vertices first, with eigenfunctions and areas there.

    On a mesh with few vertices there are points in the faces, too.
    """

    def __init__(self, spectrum: Spectrum, number: int) -> None:
        self.spectrum, surface = spectrum, spectrum.space._surface
        self._surface, n = surface, surface.number_of_vertices
        self.points, self.functions = surface.points(), spectrum.vertex_values
        # in which face a point lies, and where; and in which face each triangle lies
        self._at, self._barycentric = np.arange(n), np.tile([1.0, 0.0, 0.0], (n, 1))
        if surface.is_point_set:
            self.triangles = np.empty((0, 3), np.int64)
            self.areas = surface.vertex_areas()
        else:
            faces = surface.faces().astype(np.int64)
            self.triangles, self._parents = faces, np.arange(len(faces))
            self._at[faces.ravel()] = np.repeat(self._parents, 3)
            self._barycentric[faces.ravel()] = np.tile(np.eye(3), (len(faces), 1))
            if n < number:
                # of equilateral triangles there are twice as many as points
                side = np.sqrt(4 / np.sqrt(3) * spectrum.area / (2 * number))
                # halving longest sides makes more of needles
                a, b, c = self.points[faces].transpose(1, 0, 2)
                longest = np.max([np.linalg.norm((p - q) / side, axis=1) for p, q in ((a, b), (b, c), (c, a))], axis=0)
                excess = (np.maximum(longest, 1) ** 2).sum() / (2 * number)
                side *= np.sqrt(max(1, excess / 4))
                self.points, self.triangles, self._at, self._barycentric, self._parents = _core.refined(
                    surface, float(side))
                is_known = self._at >= 0
                self.functions = np.full((len(self.points), self.functions.shape[1]), np.nan)
                self.functions[is_known] = spectrum.functions()(self._at[is_known], self._barycentric[is_known])
            a, b, c = self.points[self.triangles].transpose(1, 0, 2)
            unit = np.sqrt(spectrum.area)  # whose squares neither overflow nor vanish
            areas = np.linalg.norm(np.cross((b - a) / unit, (c - a) / unit), axis=1) / 2
            self.triangles, self._parents = self.triangles[areas > 0], self._parents[areas > 0]
            self.areas = np.bincount(self.triangles.ravel(), np.repeat(areas[areas > 0] / 3, 3), len(self.points))
        self.known = np.flatnonzero(np.isfinite(self.functions).all(axis=1) & (self.areas > 0))

    def spread(self, number: int) -> np.ndarray:
        """About so many of the points, spread over the surface."""
        step = max(1, len(self.known) // max(number, 1))
        return self.known[::step]

    def locations(self, triangles: np.ndarray, barycentric: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The faces of the surface in which points of triangles lie, and where."""
        if self._surface.is_point_set:
            return triangles, np.tile([1.0, 0.0, 0.0], (len(triangles), 1))
        faces = self._surface.faces().astype(np.int64)
        parents, own = self._parents[triangles], self.triangles[triangles]
        # as sums over vertices, and these are corners of the parents
        vertices, shares = faces[self._at[own]], self._barycentric[own] * barycentric[:, :, None]
        result = np.stack([np.where(vertices == faces[parents, k][:, None, None], shares, 0).sum(axis=(1, 2))
                           for k in range(3)], axis=1)
        return parents, result / result.sum(axis=1, keepdims=True)


def _nearest(queries: np.ndarray, points: np.ndarray) -> np.ndarray:
    """Of each row the nearest one among others, up to single precision."""
    center = points.mean(axis=0)
    scale = abs(points - center).max() or 1.0
    own, others = (((x - center) / scale).astype(np.float32) for x in (queries, points))
    halves = (others ** 2).sum(axis=1) / 2
    result = np.empty(len(own), np.int64)
    rows = max(64, _BLOCK // len(others))
    for begin in range(0, len(own), rows):
        products = own[begin:begin + rows] @ others.T
        products -= halves
        result[begin:begin + rows] = products.argmax(axis=1)
    return result


def _nearest_in_triangles(queries: np.ndarray, corners: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Of each query the nearest point of its triangle, in coordinates there, and the squared distance.

    `queries` are (N, k), `corners` (N, 3, k).
    """
    a = corners[:, 0]
    u, v, d = corners[:, 1] - a, corners[:, 2] - a, queries - a
    uu, uv, vv = ((x * y).sum(axis=1) for x, y in ((u, u), (u, v), (v, v)))
    du, dv, dd = ((d * x).sum(axis=1) for x in (u, v, d))
    determinant = uu * vv - uv * uv
    with np.errstate(divide="ignore", invalid="ignore"):
        s, t = (vv * du - uv * dv) / determinant, (uu * dv - uv * du) / determinant
        of_edges = (np.clip(du / uu, 0, 1), np.clip(dv / vv, 0, 1),
                    np.clip((dv - du + uu - uv) / (uu + vv - 2 * uv), 0, 1))
    is_inside = (determinant > 0) & (s >= 0) & (t >= 0) & (s + t <= 1)
    zero = np.zeros_like(s)
    candidates = [(np.where(is_inside, s, 0), np.where(is_inside, t, 0)), (of_edges[0], zero), (zero, of_edges[1]),
                  (1 - of_edges[2], of_edges[2])]
    best, barycentric = np.full(len(d), np.inf), np.zeros((len(d), 3))
    for x, y in candidates:
        x, y = np.nan_to_num(x), np.nan_to_num(y)
        square = dd - 2 * (x * du + y * dv) + x * x * uu + 2 * x * y * uv + y * y * vv
        is_better = square < best
        best = np.where(is_better, square, best)
        barycentric[is_better] = np.stack([np.maximum(1 - x - y, 0), x, y], axis=1)[is_better]
    return barycentric, best


@shown()
@dataclass(frozen=True, repr=False)
class PointMap:
    """Where points of one surface lie on another one.

    Attributes
    ----------
    faces : numpy.ndarray, (N,)
        Of the source; of points with normals the number of the nearest point. -1 where a vertex of the target has no
        face with an area.
    barycentric : numpy.ndarray, (N, 3)
        Coordinates in these faces.
    points : numpy.ndarray, (N, 3)
        The same in space.
    """

    faces: np.ndarray
    barycentric: np.ndarray
    points: np.ndarray


@shown("matrix")
@dataclass(frozen=True, repr=False)
class FunctionalMap:
    """A map of functions on one surface, the source, to functions on another one, the target.

    If T takes points of the target to points of the source, f on the source becomes f(T(y)) on the target.

    Attributes
    ----------
    matrix : numpy.ndarray, (K, k)
        From coefficients of the first k eigenfunctions of the source to those of the first K of the target.
    source, target : Spectrum
        Of the two surfaces.
    """

    matrix: np.ndarray
    source: Spectrum
    target: Spectrum

    def coefficients(self, values: Any) -> np.ndarray:
        """Of functions on the source, as functions on the target.

        Parameters
        ----------
        values : array_like, (n,) or (n, d)
            At the vertices of the source.

        Returns
        -------
        numpy.ndarray, (K,) or (K, d)
            Of eigenfunctions of the target: ``target.vertex_values[:, :K] @ coefficients`` are values at its vertices.
        """
        own = numbers(values, "values", np.float64)
        return self.matrix @ _coefficients(self.source, own, self.matrix.shape[1], "values")

    def point_map(self, *, number: int = 20000) -> PointMap:
        """Where each vertex of the target lies on the source: anywhere in its faces, not at vertices alone.

        Each vertex is compared with each point of the source: time is in proportion to the product of their numbers.

        Parameters
        ----------
        number : int, default 20000
            If the source has fewer vertices, its faces are divided for the search until there are about so many.

        Returns
        -------
        PointMap
            A row for each vertex of the target.
        """
        k = self.matrix.shape
        samples = _Samples(self.source, int(number))
        values = self.target.vertex_values[:, :k[0]]
        is_known = np.isfinite(values).all(axis=1)
        faces, barycentric = np.full(len(values), -1), np.full((len(values), 3), np.nan)
        points = np.full((len(values), 3), np.nan)
        at, place, where = _points_of(samples, values[is_known] @ self.matrix)
        faces[is_known], barycentric[is_known], points[is_known] = at, place, where
        return PointMap(faces, barycentric, points)


def _points_of(samples: _Samples, embedded: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The points of a surface whose eigenfunctions are nearest: faces, coordinates, and points in space."""
    functions = samples.functions[:, :embedded.shape[1]]
    unit = abs(functions[samples.known]).max() or 1.0
    embedded, functions = embedded / unit, functions / unit
    nearest = samples.known[_nearest(embedded, functions[samples.known])]
    if len(samples.triangles) == 0:
        return (*samples.locations(nearest, np.empty((0, 3))), samples.points[nearest])
    is_known = np.zeros(len(functions), bool)
    is_known[samples.known] = True
    whole = np.flatnonzero(is_known[samples.triangles].all(axis=1))
    order = np.argsort(samples.triangles[whole].ravel(), kind="stable")
    counts = np.bincount(samples.triangles[whole].ravel(), minlength=len(samples.points))
    begins = np.concatenate([[0], np.cumsum(counts)])
    triangles, barycentric = np.zeros(len(embedded), np.int64), np.zeros((len(embedded), 3))
    rows = max(1, _BLOCK // (6 * max(1, embedded.shape[1])))
    for begin in range(0, len(embedded), rows):
        own = nearest[begin:begin + rows]
        size = counts[own]
        query = np.repeat(np.arange(len(own)), size)
        first = np.concatenate([[0], np.cumsum(size)[:-1]])
        candidates = whole[order[begins[own][query] + np.arange(len(query)) - first[query]] // 3]
        place, square = _nearest_in_triangles(embedded[begin:begin + rows][query], functions[samples.triangles[candidates]])
        best = np.lexsort((square, query))[first]
        triangles[begin:begin + rows], barycentric[begin:begin + rows] = candidates[best], place[best]
    points = np.einsum("nk,nkc->nc", barycentric, samples.points[samples.triangles[triangles]])
    return (*samples.locations(triangles, barycentric), points)


def _coefficients(spectrum: Spectrum, values: np.ndarray, k: int, name: str) -> np.ndarray:
    """Of functions at the vertices: least squares, weighted by area."""
    functions = spectrum.vertex_values[:, :k]
    if values.ndim not in (1, 2) or len(values) != len(functions):
        raise argument_error(name, f"has the shape {values.shape}, but there are {len(functions)} vertices")
    weights = spectrum.space._surface.vertex_areas()
    is_known = np.isfinite(functions).all(axis=1) & (weights > 0)
    u, w = functions[is_known], weights[is_known, None]
    own = values[is_known]
    if not np.isfinite(own).all():
        raise argument_error(name, "must be finite")
    return np.linalg.lstsq(np.sqrt(w) * u, (np.sqrt(w) * own.reshape(len(own), -1)), rcond=None)[0].reshape(
        (k,) + own.shape[1:])


def _checked(spectrum: Any, name: str, count: Optional[int]) -> int:
    if not isinstance(spectrum, Spectrum) or spectrum.vertex_values.size == 0:
        raise argument_error(name, "must be a Spectrum with eigenfunctions")
    k = spectrum.vertex_values.shape[1]
    own = k if count is None else int(count)
    if not 1 <= own <= k:
        raise argument_error("count", f"is {own}, but {name} has {k} eigenfunctions")
    return own


def _signatures(source: Spectrum, target: Spectrum) -> tuple[np.ndarray, np.ndarray]:
    """Wave kernel signatures for the same energies; 0 where there are none."""
    lowest, highest = (np.log(f(s.eigenvalues[s.eigenvalues > 1e-6 * s.eigenvalues[-1]][e] for s in (source, target)))
                       for f, e in ((max, 0), (min, -1)))
    number = 100
    width = 7 * (highest - lowest) / number  # seven energies, as for one surface
    energies = np.linspace(lowest, highest, number)
    return tuple(np.nan_to_num(wave_kernel_signature(s, energies, sigma=width)) for s in (source, target))  # type: ignore


def _landmark_functions(spectrum: Spectrum, vertices: np.ndarray, k: int, scales: np.ndarray, name: str) -> np.ndarray:
    """Heat from each landmark at these times: coefficients, a column for each landmark and time."""
    n = len(spectrum.vertex_values)
    if vertices.ndim != 1 or not ((vertices >= 0) & (vertices < n)).all():
        raise argument_error("landmarks", f"must be vertices of the {name}, from 0 to {n - 1}")
    values = spectrum.vertex_values[vertices, :k]
    if not np.isfinite(values).all():
        raise argument_error("landmarks", f"names a vertex of the {name} without a face that has an area")
    decay = np.exp(-np.outer(spectrum.eigenvalues[:k], scales))
    return np.einsum("lk,kt->klt", values, decay).reshape(k, -1)


def functional_map(source: Spectrum, target: Spectrum, descriptors: Any = None, *, landmarks: Any = None,
                   count: Optional[int] = None, laplacian_weight: float = 1e-2) -> FunctionalMap:
    """The functional map that takes descriptors of one surface to those of another one.

    Its matrix C minimizes the sum of the squares of C a - b, over the coefficients a and b of each pair of functions,
    divided by their norms, and laplacian_weight times the mean of squares over functions times the sum of the
    squares of C_ij (l_i - m_j) / l for eigenvalues l_i of the target and m_j of the source and their largest l, so
    that C nearly commutes with the Laplacians (Ovsjanikov and others 2012).

    Parameters
    ----------
    source, target : Spectrum
        Of the two surfaces: `laplace_spectrum`. If one is larger than the other one, scale it first.
    descriptors : (array_like, array_like), optional
        (n, d) and (N, d): functions at the vertices of both that correspond to each other. By default wave kernel
        signatures.
    landmarks : (array_like, array_like), optional
        Vertices of both, as many, that correspond to each other: heat that starts there is taken to be the same.
    count : int, optional
        Number of eigenfunctions of both; all by default.
    laplacian_weight : float, default 1e-2
        How much it matters that the map commutes with the Laplacians.

    Returns
    -------
    FunctionalMap
        From functions on the source to functions on the target.

    Raises
    ------
    InputError
        An argument has a wrong shape, or is not finite.

    Examples
    --------
    A surface and its copy that is moved and has other triangles:

    >>> import numpy as np, restricted_laplacian as rl
    >>> V, F = rl.icosphere(3)
    >>> V = V * [1, 0.8, 0.6] + 0.1 * V ** 2
    >>> source = rl.laplace_spectrum(V, F, 20, depth=4)
    >>> target = rl.laplace_spectrum(V[:, [1, 2, 0]], F, 20, depth=4)
    >>> C = rl.functional_map(source, target, landmarks=([0, 50, 100], [0, 50, 100]))
    >>> C.matrix.shape
    (20, 20)
    """
    k, number = _checked(source, "source", count), _checked(target, "target", count)
    if not (np.isfinite(laplacian_weight) and laplacian_weight >= 0):
        raise argument_error("laplacian_weight", f"is {laplacian_weight}, but must not be negative")
    a, b = [], []
    if descriptors is None:
        descriptors = _signatures(source, target)
    try:
        of_source, of_target = (numbers(d, "descriptors", np.float64) for d in descriptors)
    except (TypeError, ValueError):
        raise argument_error("descriptors", "must be a pair: functions on the source, and on the target") from None
    of_source, of_target = (d.reshape(len(d), -1) for d in (of_source, of_target))
    if of_source.shape[1] != of_target.shape[1]:
        raise argument_error("descriptors", f"has {of_source.shape[1]} functions on the source, but "
                             f"{of_target.shape[1]} on the target")
    a.append(_coefficients(source, of_source, k, "descriptors"))
    b.append(_coefficients(target, of_target, number, "descriptors"))
    if landmarks is not None:
        try:
            here, there = (np.asarray(v, np.int64) for v in landmarks)
        except (TypeError, ValueError):
            raise argument_error("landmarks", "must be a pair: vertices of the source, and of the target") from None
        if here.shape != there.shape:
            raise argument_error("landmarks", f"names {here.size} vertices of the source, but {there.size} of the target")
        scales = heat_kernel_times(source, 5)
        a.append(_landmark_functions(source, here, k, scales, "source"))
        b.append(_landmark_functions(target, there, number, scales, "target"))
    left, right = np.concatenate(a, axis=1), np.concatenate(b, axis=1)
    norms = np.sqrt(np.linalg.norm(left, axis=0)) * np.sqrt(np.linalg.norm(right, axis=0))
    is_used = norms > 0
    left, right = left[:, is_used] / norms[is_used], right[:, is_used] / norms[is_used]
    l, m = target.eigenvalues[:number], source.eigenvalues[:k]
    largest = max(l[-1], m[-1])
    gram, product = left @ left.T, right @ left.T
    scale = laplacian_weight * left.shape[1]
    matrix = np.empty((number, k))
    for i in range(number):
        change = scale * ((l[i] - m) / largest) ** 2 if largest > 0 else np.zeros(k)
        # what neither of the two determines is 0
        matrix[i] = np.linalg.lstsq(gram + np.diag(change + 1e-12 * np.trace(gram)), product[i], rcond=None)[0]
    return FunctionalMap(matrix, source, target)


def zoomout(initial: FunctionalMap, count: Optional[int] = None, *, step: int = 1, number: int = 3000,
            progress: Progress = None) -> FunctionalMap:
    """Make a functional map larger and better, by ZoomOut (Melzi and others 2019).

    From the map of k eigenfunctions follows one of points, from that the map of k + step eigenfunctions, and so on.

    Parameters
    ----------
    initial : FunctionalMap
        A first one; 20 eigenfunctions, and three landmarks, may do.
    count : int, optional
        Number of eigenfunctions of the result; all by default.
    step : int, default 1
        How many are added at a time.
    number : int, default 3000
        Of points of each surface that take part. Meshes with fewer vertices have points inside their faces, too.
    progress : as for solve_poisson
        What is told.

    Returns
    -------
    FunctionalMap
        Between the same surfaces.

    Raises
    ------
    InputError
        An argument is outside its domain.
    Canceled
        A callback of `progress` returned False.

    Examples
    --------
    >>> import numpy as np, restricted_laplacian as rl
    >>> V, F = rl.icosphere(3)
    >>> V = V * [1, 0.8, 0.6] + 0.1 * V ** 2
    >>> source = rl.laplace_spectrum(V, F, 40, depth=4)
    >>> target = rl.laplace_spectrum(V[:, [1, 2, 0]], F, 40, depth=4)
    >>> initial = rl.functional_map(source, target, landmarks=([0, 50, 100], [0, 50, 100]), count=20)
    >>> found = rl.zoomout(initial).point_map()
    >>> bool(np.linalg.norm(found.points - V, axis=1).max() < 1e-2)
    True
    """
    if not isinstance(initial, FunctionalMap):
        raise argument_error("initial", "must be a FunctionalMap")
    source, target = initial.source, initial.target
    last = min(_checked(source, "source", count), _checked(target, "target", count))
    if int(step) != step or step < 1:
        raise argument_error("step", f"is {step}, but must be at least 1")
    if int(number) < 1:
        raise argument_error("number", f"is {number}, but must be at least 1")
    here, there = _Samples(source, int(number)), _Samples(target, int(number))
    # of many vertices a part will do
    from_points, to_points = here.spread(int(number)), there.spread(int(number))
    values = there.functions[to_points]
    dual = values * there.areas[to_points, None]
    gram = dual.T @ values
    matrix = initial.matrix
    size = first = min(matrix.shape)
    tell = listener(progress)
    while size < last:
        nearest = from_points[_nearest(values[:, :matrix.shape[0]] @ matrix, here.functions[from_points, :matrix.shape[1]])]
        size = min(size + int(step), last)
        matrix = np.linalg.lstsq(gram[:size, :size], dual[:, :size].T @ here.functions[nearest, :size], rcond=None)[0]
        if tell is not None and tell((size - first) / (last - first)) is False:
            raise Canceled("canceled by progress")
    return FunctionalMap(matrix, source, target)

# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Distances along a surface."""

from __future__ import annotations

from typing import Any, Callable, NamedTuple, Optional

import numpy as np
import scipy.sparse

from . import _core
from ._errors import Canceled, argument_error
from ._input import (Progress, listener, make_surface, number_of_threads, numbers, rows, takes_surface,
                     vertex_numbers, whole_numbers)
from ._show import shown
from ._space import Space
from ._view import View, Viewable, view_of_surface

_BYTES_AT_ONCE = 256 * 2**20  # of blocks of a matrix that goes elsewhere


@shown()
class Distances(NamedTuple):
    """What `Geodesics.distances` returns, of the vertices.

    Attributes
    ----------
    distances : numpy.ndarray, (n,)
        In units of length; infinite where no source is reached.
    directions : numpy.ndarray, (n, 3)
        Unit vectors along which the way to the source begins; 0 where that is not known.
    labels : numpy.ndarray, (n,)
        Label of the nearest source, or -1.
    """

    distances: np.ndarray
    directions: np.ndarray
    labels: np.ndarray


@shown()
class Path(NamedTuple):
    """A line on a surface.

    Attributes
    ----------
    points : numpy.ndarray, (n + 1, 3)
        The last one is the first one again if the line is closed.
    length : float
        Of the line.
    segments : tuple of numpy.ndarray
        Faces (n,) and barycentric coordinates (n, 3) of both ends, as `Geodesics.distances` takes.
    """

    points: np.ndarray
    length: float
    segments: tuple[np.ndarray, np.ndarray, np.ndarray]


def _barycentric(values: Any, name: str) -> np.ndarray:
    result = rows(np.atleast_2d(numbers(values, name)), name)
    if result.shape[1] != 3:
        raise argument_error(name, "must have three barycentric coordinates for each face")
    return result


def _in_faces(given: Any, name: str) -> tuple[np.ndarray, ...]:
    """Faces and barycentric coordinates of points, or of both ends of segments; perhaps none."""
    number = 3 if name == "segments" else 2
    if given is None:
        return (np.zeros(0, np.int64),) + (np.zeros((0, 3)),) * (number - 1)
    parts = list(given)
    if len(parts) != number:
        raise argument_error(name, "must be faces, and barycentric coordinates"
                             + (" of both ends" if number == 3 else ""))
    return (whole_numbers(parts[0], name), *(_barycentric(p, name) for p in parts[1:]))


def _symmetric(matrix: scipy.sparse.csr_matrix) -> scipy.sparse.csr_matrix:
    """The mean of the entries (i, j) and (j, i), or the one that there is."""
    own = matrix.tocoo()
    places = np.concatenate([own.row, own.col]), np.concatenate([own.col, own.row])
    sums, counts = (scipy.sparse.coo_matrix((np.tile(data, 2), places), matrix.shape).tocsr()
                    for data in (own.data, np.ones(own.nnz)))
    sums.data /= counts.data  # both have the same entries in the same order
    return sums


def _part(tell: Optional[Callable[[float], Any]], begin: float, end: float) -> Optional[Callable[[float], Any]]:
    """What tells the progress of a part of the work."""
    return None if tell is None else lambda done: tell(begin + done * (end - begin))


def _sparse(distances: np.ndarray) -> scipy.sparse.csr_matrix:
    """The finite ones, also those that are 0."""
    is_near = np.isfinite(distances)
    first = np.concatenate([[0], np.cumsum(is_near.sum(axis=1))])
    return scipy.sparse.csr_matrix((distances[is_near], np.nonzero(is_near)[1], first), shape=distances.shape)


def _sources(number_of_vertices: int, sources: Any, points: Any, segments: Any, boundary: bool,
             labels: Any) -> tuple[Any, ...]:
    """Arguments of the C++ library."""
    vertices = vertex_numbers(np.zeros(0, np.int64) if sources is None else sources, "sources",
                              number_of_vertices)
    of_points = _in_faces(points, "points")
    of_segments = _in_faces(segments, "segments")
    faces, starts, ends = (np.concatenate([of_points[i], of_segments[j]]) for i, j in ((0, 0), (1, 1), (1, 2)))
    number = len(vertices) + len(faces) + bool(boundary)
    own_labels = np.arange(number) if labels is None else whole_numbers(labels, "labels")
    return vertices, faces, starts, ends, bool(boundary), own_labels


@shown("geodesics")
class DistanceFunction(Viewable):
    """The distance from sources anywhere on a surface, what `Geodesics.function` returns.

    Attributes
    ----------
    geodesics : Geodesics
        Of the surface.

    Examples
    --------
    >>> import restricted_laplacian as rl
    >>> V, F = rl.icosphere(4)
    >>> d = rl.Geodesics(V, F).function(0)
    >>> middle = d([5], [[1/3, 1/3, 1/3]])
    >>> path = d.shortest_path(100)
    >>> circle, = d.isolines(1.0)
    """

    def __init__(self, geodesics: "Geodesics", function: Any, query: tuple) -> None:
        self.geodesics = geodesics
        self._query = query  # name of a method, and its arguments
        self._surface = geodesics._surface
        self._solver = geodesics._solver
        self._function = function

    def __reduce__(self) -> tuple:
        return _distance_again, (self.geodesics, *self._query)

    def __call__(self, faces: Any, barycentric: Any) -> np.ndarray:
        """Distances at points of faces: (N,) numbers of faces, (N, 3) barycentric coordinates."""
        return self._function.values(whole_numbers(faces, "faces"), _barycentric(barycentric,
                                                                             "barycentric"))

    def gradients(self, faces: Any, barycentric: Any) -> np.ndarray:
        """Gradients along the surface at points of faces.

        Parameters
        ----------
        faces : array_like, (N,)
            Rows of `Space.triangles`: of F, if its faces are triangles.
        barycentric : array_like, (N, 3)
            Coordinates with respect to their vertices.

        Returns
        -------
        numpy.ndarray, (N, 3)
            Unit vectors where there is a gradient.
        """
        return self._function.gradients(whole_numbers(faces, "faces"),
                                        _barycentric(barycentric, "barycentric"))

    def shortest_path(self, start: Any) -> Path:
        """The shortest path to the nearest source.

        Parameters
        ----------
        start : int or (face, barycentric)
            A vertex, or a point of a face.

        Returns
        -------
        Path
            From there to the source.
        """
        if isinstance(start, (tuple, list)):
            if len(start) != 2:
                raise argument_error("start", "must be a vertex, or a face and its coordinates")
            face, place = whole_numbers(start[0], "start"), _barycentric(start[1], "start")
        else:
            vertex = whole_numbers(start, "start")
            if len(vertex) != 1:
                raise argument_error("start", "must be one vertex")
            number, place = self._solver.location(int(vertex[0]))
            face = np.array([number])
        if len(face) != 1:
            raise argument_error("start", "must be one point")
        points, length, *segments = self._function.shortest_path(int(face[0]), place)
        return Path(points, length, tuple(segments))

    def view(self, *, longest_side: float = 0, **options: Any) -> View:
        """A `View` of the distance.

        Parameters
        ----------
        longest_side : float, default 0
            Divides faces until no side is longer, with distances at all vertices; 0 leaves the faces
            as they are.
        **options : as for View
            What it takes.

        Returns
        -------
        View
            With isolines.
        """
        if not longest_side >= 0:
            raise argument_error("longest_side", "must not be negative")
        surface = self._surface
        values = self._function.vertex_values()[:, np.newaxis]
        return view_of_surface(surface, ["distance"], values, self, longest_side,
                               {"title": "Distance", "isolines": 20, **options})

    def isolines(self, value: float) -> list[Path]:
        """The lines on which the distance has a value.

        Parameters
        ----------
        value : float
            The distance.

        Returns
        -------
        list of Path
            Closed ones, and those that end at a boundary.
        """
        return [Path(points, length, tuple(segments))
                for points, length, *segments in self._function.isolines(float(value))]


def _distance_again(geodesics: "Geodesics", method: str, arguments: dict) -> DistanceFunction:
    """What pickle calls."""
    return getattr(geodesics, method)(**arguments)  # type: ignore[no-any-return]


@shown("number_of_vertices", "number_of_faces")
class Geodesics:
    """Distances along a surface, set up once for any number of queries.

    Parameters
    ----------
    V, F : array_like, (n, 3) and (m, 3)
        The triangles, as for `Space`; they need not form a manifold. Or a `Space`.
    normals : array_like, (n, 3), optional
        For points without faces, oriented alike: triangles are made of them. Points that no
        triangle takes have infinite distances; many of these show that the points are too sparse.
    joining_tolerance : float, optional
        Distance up to which vertices on the boundary are one with others, and divide faces on whose
        sides they lie: for soups with cracks and T-junctions.
    maximum_memory : float, optional
        Bytes that a query may take, by default those of the machine. Most need some hundred for
        each face; a `InputError` tells of those that would take more.
    threads : int, optional
        Of `distance_matrix`; by default all processors. Results do not depend on it.

    Examples
    --------
    >>> import restricted_laplacian as rl
    >>> V, F = rl.icosphere(4)
    >>> geodesics = rl.Geodesics(V, F)
    >>> d = geodesics.distances(0).distances  # from vertex 0
    >>> bool(abs(d.max() - 3.1416) < 0.01)
    True
    >>> far = geodesics.farthest_points(6)
    >>> regions = geodesics.distances(far).labels  # Voronoi regions
    """

    @takes_surface
    def __init__(self, V: Any, F: Any = None, *, normals: Any = None,
                 joining_tolerance: Optional[float] = None,
                 maximum_memory: Optional[float] = None, threads: Optional[int] = None) -> None:
        self._maximum_memory = None if maximum_memory is None else float(maximum_memory)
        self._space: Optional[Space] = V if isinstance(V, Space) else None
        self._threads = (self._space._threads if self._space and threads is None
                         else number_of_threads(threads))
        self._surface = V._surface if isinstance(V, Space) else make_surface(
            V, F, normals=normals)
        self._solver = _core.GeodesicSolver.make(
            self._surface, None if joining_tolerance is None else float(joining_tolerance))
        self._joining_tolerance = joining_tolerance
        self._fitter: Any = None

    def __reduce__(self) -> tuple:
        return _geodesics_again, (self._space or self._surface, self._joining_tolerance,
                                  self._maximum_memory, self._threads or None)

    @property
    def number_of_vertices(self) -> int:
        """Number of rows of V."""
        return self._surface.number_of_vertices  # type: ignore[no-any-return,unused-ignore]

    @property
    def number_of_faces(self) -> int:
        """Number of rows of F; of points without faces their number."""
        return self._surface.number_of_polygons  # type: ignore[no-any-return,unused-ignore]

    def _query(self, exact: bool, progress: Progress, maximum_distance: Optional[float] = None) -> Any:
        return _core.DistanceQuery(bool(exact), self._maximum_memory,
                                   None if maximum_distance is None else float(maximum_distance),
                                   self._threads, listener(progress))

    def distances(self, sources: Any = None, *, points: Any = None, segments: Any = None,
                  boundary: bool = False, labels: Any = None, maximum_distance: Optional[float] = None,
                  exact: bool = False, progress: Progress = None) -> Distances:
        """Distances of all vertices from the nearest source.

        Parameters
        ----------
        sources : int or array_like of int, optional
            Vertices, or a mask (n,) of them.
        points : (faces, barycentric), optional
            Points in faces: rows of ``F``, and three coordinates for each.
        segments : (faces, barycentric, barycentric), optional
            Segments from one point of a face to another one. A polyline consists of such.
        boundary : bool, default False
            Whether edges with one face only are sources, too.
        labels : array_like of int, optional
            Of the vertices, points, segments, and the boundary, in that order; by default 0, 1 and
            so on.
        maximum_distance : float, optional
            Distances beyond are infinite, and take no time.
        exact : bool, default False
            Exact up to rounding, in more time; by default errors are of the order of 0.01 %.
        progress : bool or callable, optional
            Is called with the part of the work that is done, and ends it if it returns False;
            ``True`` prints it.

        Returns
        -------
        Distances
            A tuple of ``distances``, ``directions`` and ``labels``.
        """
        own = _sources(self._surface.number_of_vertices, sources, points, segments, boundary, labels)
        return Distances(*self._solver.distances(*own, self._query(exact, progress, maximum_distance)))

    def signed_distances(self, values: Any, *, maximum_distance: Optional[float] = None, exact: bool = False,
                         progress: Progress = None) -> np.ndarray:
        """Distances of all vertices from the boundary of a region, negative inside.

        Parameters
        ----------
        values : array_like, (n,)
            A function that is linear on triangles: distances are those from its zeros, negative where it is negative.
            Or a mask of the vertices that lie inside.
        maximum_distance, exact, progress : as for distances
            How the work is done. Beyond a maximum they are infinite, of both signs.

        Returns
        -------
        numpy.ndarray, (n,)
            In units of length.

        Examples
        --------
        >>> import numpy as np, restricted_laplacian as rl
        >>> V, F = rl.icosphere(4)
        >>> latitude = rl.Geodesics(V, F).signed_distances(V[:, 2])
        >>> bool(abs(latitude - np.arcsin(V[:, 2])).max() < 2e-3)
        True
        """
        n = self._surface.number_of_vertices
        own = np.asarray(values)
        own = np.where(own, -1.0, 1.0) if own.dtype == bool else numbers(own, "values", np.float64)
        if own.shape != (n,):
            raise argument_error("values", f"has the shape {own.shape}, but there are {n} vertices")
        return self._solver.signed_distances(np.ascontiguousarray(own), self._query(exact, progress, maximum_distance))  # type: ignore[no-any-return]

    def distance_matrix(self, sources: Any = None, targets: Any = None, *, points: Any = None,
                        target_points: Any = None, maximum_distance: Optional[float] = None,
                        out: Any = None, exact: bool = False, progress: Progress = None) -> Any:
        """Distances between many places, on several threads.

        Parameters
        ----------
        sources : array_like of int, optional
            Vertices, or a mask (n,) of them; all by default, if there are no points either.
        targets : array_like of int, optional
            Vertices, or a mask (n,) of them; all by default, if there are no points either. A propagation ends when
            it has reached them. If they are the sources, the result is symmetric: the mean of both directions.
        points : (faces, barycentric), optional
            Points in faces that are sources, too, after the vertices: rows of ``F``, and three coordinates for each.
        target_points : (faces, barycentric), optional
            Points in faces that are targets, too, after the vertices. Between the corners of faces distances are
            those of `function`.
        maximum_distance : float, optional
            Distances beyond are left out of a sparse result, and take no time.
        out : numpy.ndarray, (k, m), optional
            Where the distances go, in its type, some rows at a time: a `numpy.memmap` for instance, for what is
            larger than the memory.
        exact, progress : as for distances
            How the work is done.

        Returns
        -------
        numpy.ndarray, (k, m), or scipy.sparse.csr_matrix
            A row for each source, a column for each target; infinite where it is not reached. With a
            `maximum_distance` sparse, with entries that are 0 for the sources themselves.

        Examples
        --------
        >>> import restricted_laplacian as rl
        >>> V, F = rl.icosphere(3)
        >>> geodesics = rl.Geodesics(V, F)
        >>> geodesics.distance_matrix([0, 5, 7]).shape
        (3, 642)
        >>> D = geodesics.distance_matrix([0, 5, 7], [0, 5, 7])
        >>> bool((D == D.T).all())
        True
        >>> geodesics.distance_matrix([0], maximum_distance=0.2).nnz
        6
        >>> centers = [0, 10, 20], [[1/3, 1/3, 1/3]] * 3  # of three faces
        >>> geodesics.distance_matrix(points=centers, target_points=centers).shape
        (3, 3)
        """
        n = self._surface.number_of_vertices

        def places(of: Any, name: str, in_faces: Any, name_in_faces: str) -> tuple[np.ndarray, ...]:
            vertices = np.arange(n if in_faces is None else 0) if of is None else vertex_numbers(of, name, n)
            return vertices, *_in_faces(in_faces, name_in_faces)
        begins, ends = (places(sources, "sources", points, "points"),
                        places(targets, "targets", target_points, "target_points"))
        is_square = all(np.array_equal(a, b) for a, b in zip(begins, ends))
        is_to_all = targets is None and target_points is None
        to = None if is_to_all else _core.Places(*ends)
        height, width = (len(of[0]) + len(of[1]) for of in (begins, ends))
        if maximum_distance is not None and out is not None:
            raise argument_error("out", "is for all distances, not for those up to a maximum")
        if maximum_distance is not None and target_points is None:
            first, found, values = self._solver.near_vertices(_core.Places(*begins), float(maximum_distance),
                                                              self._query(exact, progress))
            near = scipy.sparse.csr_matrix((values, found, first), shape=(height, n))
            near = near if is_to_all else near[:, ends[0]]
            return _symmetric(near) if is_square else near
        if out is None:
            out = np.empty((height if maximum_distance is None else 0, width))
        elif getattr(out, "shape", None) != (height, width):
            raise argument_error("out", f"must have the shape {(height, width)}")
        tell = listener(progress)
        size = max(1, min(256, int(_BYTES_AT_ONCE / (8 * max(width, 1)))))
        blocks = [_sparse(out[:0])]
        for begin in range(0, height, size):
            end, k = min(begin + size, height), len(begins[0])
            own = _core.Places(begins[0][begin:end], *(a[max(begin - k, 0):max(end - k, 0)] for a in begins[1:]))
            part = _part(tell, begin / height, end / height)
            block = self._solver.distance_matrix(own, to, self._query(exact, part, maximum_distance)).reshape(
                end - begin, width)
            if maximum_distance is None:
                out[begin:end] = block
            else:
                blocks.append(_sparse(block))
        if maximum_distance is not None:
            near = scipy.sparse.vstack(blocks, "csr")
            return _symmetric(near) if is_square else near
        for begin in range(0, height if is_square else 0, size):
            for other in range(0, begin + 1, size):
                mean = (out[begin:begin + size, other:other + size] + out[other:other + size, begin:begin + size].T) / 2
                out[begin:begin + size, other:other + size] = mean
                out[other:other + size, begin:begin + size] = mean.T
        return out

    def parcel_distances(self, parcels: Any, *, per_parcel: int = 32, exact: bool = False,
                         progress: Progress = None) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Centers of parcels, and mean distances between parcels.

        Parameters
        ----------
        parcels : array_like of int, (n,)
            The parcel of each vertex; negative ones are none.
        per_parcel : int, default 32
            How many vertices stand for a parcel, spread over it; all of them, if it has no more.
        exact, progress : as for distances
            How the work is done.

        Returns
        -------
        labels : numpy.ndarray, (p,)
            The parcels, ascending.
        centers : numpy.ndarray, (p,)
            Of each the vertex with the smallest sum of squared distances from these: a Frechet mean.
        means : numpy.ndarray, (p, p)
            Mean distances of these vertices of one parcel from those of another one; of one parcel among each other.

        Examples
        --------
        >>> import numpy as np, restricted_laplacian as rl
        >>> V, F = rl.icosphere(3)
        >>> labels, centers, means = rl.Geodesics(V, F).parcel_distances((V[:, 2] > 0).astype(int))
        >>> labels, bool(V[centers[1], 2] > 0.95), means.shape
        (array([0, 1]), True, (2, 2))
        """
        n = self._surface.number_of_vertices
        of_vertices = np.asarray(parcels)
        if of_vertices.shape != (n,) or not np.issubdtype(of_vertices.dtype, np.integer):
            raise argument_error("parcels", f"must be {n} whole numbers")
        if int(per_parcel) != per_parcel or per_parcel < 1:
            raise argument_error("per_parcel", f"is {per_parcel}, but must be at least 1")
        of_vertices = np.where(self._solver.have_faces(), of_vertices, -1)
        labels = np.unique(of_vertices[of_vertices >= 0])
        chosen = []
        for label in labels:
            vertices = np.flatnonzero(of_vertices == label)
            order = np.lexsort(self._surface.points()[vertices].T)  # by place, not by number
            some = np.linspace(0, len(vertices) - 1, min(int(per_parcel), len(vertices))).astype(int)
            chosen.append(vertices[order[some]])
        rows = np.concatenate(chosen) if chosen else np.zeros(0, dtype=int)
        parcel_of_row = np.repeat(np.arange(len(labels)), [len(c) for c in chosen])
        centers = np.zeros(len(labels), dtype=int)
        means = np.zeros((len(labels), len(labels)))
        tell = listener(progress)
        for p, own in enumerate(chosen):
            found = self.distance_matrix(own, exact=exact)
            inside = np.flatnonzero(of_vertices == labels[p])
            centers[p] = inside[np.argmin((found[:, inside] ** 2).sum(axis=0))]
            sums = np.bincount(parcel_of_row, found[:, rows].sum(axis=0), len(labels))
            means[p] = sums / (np.bincount(parcel_of_row, minlength=len(labels)) * len(own))
            if tell is not None and tell((p + 1) / len(labels)) is False:
                raise Canceled("canceled by progress")
        return labels, centers, (means + means.T) / 2

    def function(self, sources: Any = None, *, points: Any = None, segments: Any = None,
                 boundary: bool = False, exact: bool = False,
                 progress: Progress = None) -> DistanceFunction:
        """The distance anywhere on the surface, triangle by triangle, with paths and isolines.

        Parameters
        ----------
        sources, points, segments, boundary, exact, progress : as for distances
            From where, and how the work is done.

        Returns
        -------
        DistanceFunction
            It can be evaluated anywhere on the surface.
        """
        own = _sources(self._surface.number_of_vertices, sources, points, segments, boundary, None)
        query = "function", dict(sources=sources, points=points, segments=segments, boundary=boundary,
                                 exact=exact)
        return DistanceFunction(self, self._solver.function(*own, self._query(exact, progress), None), query)

    def spline(self, sources: Any = None, *, points: Any = None, segments: Any = None,
               boundary: bool = False, exact: bool = False,
               progress: Progress = None) -> DistanceFunction:
        """The same as a spline: smooth over edges, too, but for two cells around ridges.

        Its space is that which the object was made of, or one of the default depth. Paths and
        isolines are those of `function`.

        Parameters
        ----------
        sources, points, segments, boundary, exact, progress : as for distances
            From where, and how the work is done.

        Returns
        -------
        DistanceFunction
            It can be evaluated anywhere on the surface.
        """
        if self._fitter is None:
            space = self._space or Space(self._surface)
            self._fitter = _core.GeodesicFitter.make(space._space, space._threads)
        own = _sources(self._surface.number_of_vertices, sources, points, segments, boundary, None)
        query = "spline", dict(sources=sources, points=points, segments=segments, boundary=boundary,
                               exact=exact)
        return DistanceFunction(self, self._solver.function(*own, self._query(exact, progress),
                                                           self._fitter), query)

    def farthest_points(self, number: int, sources: Any = None, *,
                        progress: Progress = None) -> np.ndarray:
        """Vertices far from each other: each is the one farthest from those before.

        Parameters
        ----------
        number : int
            How many.
        sources : int or array_like of int, optional
            Vertices to begin with, which are not among the results; by default the first vertex
            with a face, which is the first of them.
        progress : bool or callable, optional
            See `distances`.

        Returns
        -------
        numpy.ndarray, (number,)
            Fewer if there are not so many.
        """
        if isinstance(number, bool) or not isinstance(number, (int, np.integer)):
            raise argument_error("number", f"must be a whole number, and is {number!r}")
        own = vertex_numbers(np.zeros(0, np.int64) if sources is None else sources, "sources",
                             self._surface.number_of_vertices)
        return self._solver.farthest_points(int(np.clip(number, -1, 2 ** 32)), own,
                                            self._query(False, progress))


def _geodesics_again(surface: Any, joining_tolerance: Optional[float], maximum_memory: Optional[float],
                     threads: Optional[int]) -> Geodesics:
    """What pickle calls."""
    return Geodesics(surface, joining_tolerance=joining_tolerance, maximum_memory=maximum_memory,
                     threads=threads)


@takes_surface
def geodesic_distance(V: Any, F: Any = None, sources: Any = None, *, normals: Any = None,
                      boundary: bool = False, exact: bool = False,
                      joining_tolerance: Optional[float] = None, maximum_memory: Optional[float] = None,
                      threads: Optional[int] = None, progress: Progress = None) -> np.ndarray:
    """Distances along a surface.

    Parameters
    ----------
    V, F : array_like, (n, 3) and (m, 3)
        The triangles, as for `Space`.
    sources : int or array_like, optional
        Vertices from which distances are measured, or a mask (n,) of them.
    normals, joining_tolerance, maximum_memory, threads : as for Geodesics
        The surface, and what a query may take.
    boundary, exact, progress : as for Geodesics.distances
        That takes other sources, too.

    Returns
    -------
    numpy.ndarray, (n,)
        Of the vertices from the nearest source, in units of length; infinite where none is reached.

    Raises
    ------
    InputError
        There is no source, it is no vertex, or the memory does not suffice.
    Canceled
        A callback of `progress` returned False.

    Examples
    --------
    >>> import restricted_laplacian as rl
    >>> V, F = rl.icosphere(4)
    >>> d = rl.geodesic_distance(V, F, [0, 7])
    >>> bool(d[0] == d[7] == 0)
    True
    """
    geodesics = Geodesics(V, F, normals=normals, joining_tolerance=joining_tolerance,
                          maximum_memory=maximum_memory, threads=threads)
    return geodesics.distances(sources, boundary=boundary, exact=exact,
                               progress=progress).distances


@takes_surface
def farthest_points(V: Any, F: Any = None, number: int = 1, sources: Optional[Any] = None, *,
                    normals: Any = None, joining_tolerance: Optional[float] = None,
                    maximum_memory: Optional[float] = None, threads: Optional[int] = None,
                    progress: Progress = None) -> np.ndarray:
    """Vertices far from each other: each is the one farthest from those before.

    Parameters
    ----------
    V, F : array_like, (n, 3) and (m, 3)
        The triangles, as for `Space`.
    number : int, default 1
        How many.
    sources : int or array_like, optional
        Vertices to begin with, see `Geodesics.farthest_points`.
    normals, joining_tolerance, maximum_memory, threads : as for Geodesics
        The surface, and what a query may take.
    progress : bool or callable, optional
        See `solve_poisson`.

    Returns
    -------
    numpy.ndarray, (number,)
        Vertices; fewer if there are not so many.

    Raises
    ------
    InputError
        A source is no vertex, or the memory does not suffice.
    Canceled
        A callback of `progress` returned False.

    Examples
    --------
    >>> import restricted_laplacian as rl
    >>> V, F = rl.icosphere(3)
    >>> len(rl.farthest_points(V, F, 5))
    5
    """
    return Geodesics(V, F, normals=normals, joining_tolerance=joining_tolerance,
                     maximum_memory=maximum_memory, threads=threads
                     ).farthest_points(number, sources, progress=progress)


@takes_surface
def shortest_path(V: Any, F: Any = None, start: Any = 0, sources: Any = None, *, normals: Any = None,
                  boundary: bool = False, exact: bool = False,
                  joining_tolerance: Optional[float] = None, maximum_memory: Optional[float] = None,
                  threads: Optional[int] = None, progress: Progress = None) -> Path:
    """The shortest path from a point of a surface to the nearest source.

    Parameters
    ----------
    V, F : array_like, (n, 3) and (m, 3)
        The triangles, as for `Space`.
    start : int or (int, array_like), default 0
        A vertex; or a face and barycentric coordinates (3,).
    sources, boundary, exact, progress : as for Geodesics.distances
        Where paths end.
    normals, joining_tolerance, maximum_memory, threads : as for Geodesics
        The surface, and what a query may take.

    Returns
    -------
    Path
        Points (n + 1, 3), the length, and the segments.

    Raises
    ------
    InputError
        There is no source, none is reached, or it is no vertex.
    Canceled
        A callback of `progress` returned False.

    Examples
    --------
    >>> import restricted_laplacian as rl
    >>> V, F = rl.icosphere(4)
    >>> path = rl.shortest_path(V, F, 7, 0)
    >>> bool((path.points[0] == V[7]).all() and (path.points[-1] == V[0]).all())
    True
    """
    geodesics = Geodesics(V, F, normals=normals, joining_tolerance=joining_tolerance,
                          maximum_memory=maximum_memory, threads=threads)
    return geodesics.function(sources, boundary=boundary, exact=exact, progress=progress
                              ).shortest_path(start)

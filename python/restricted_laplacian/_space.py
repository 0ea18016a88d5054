# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Spline spaces: matrices, loads, solvers, functions."""

from __future__ import annotations

import copy
from typing import Any, NamedTuple, Optional

import numpy as np
import scipy.sparse

from . import _core
from ._errors import ConvergenceError, InputError, argument_error
from ._input import (Progress, as_function, listener, make_surface, number_of_threads, numbers, rows,
                     surface_state, takes_surface)
from ._show import shown, table
from ._view import View, Viewable, view_of_surface


class Report(dict):
    """What a solver did, a dictionary whose entries are attributes, too.

    ``converged``, ``status``, ``iterations``, ``relative_residual``, ``relative_energy_error`` (an
    estimate), ``assembly_seconds``, ``setup_seconds``, ``solve_seconds``, ``estimated_error`` (of the finite
    elements, relative; NaN where it is not known) and ``is_estimate_trusted``, and what the function adds.
    """

    def __getattr__(self, name: str) -> Any:
        try:
            return self[name]
        except KeyError:
            raise AttributeError(name) from None

    def _repr_html_(self) -> str:
        return table("Report", self.items())


def checked(result: Any, report: dict, check: bool, return_report: bool, advice: str = "") -> Any:
    """The result of a solver, if it converged or that does not matter."""
    own = Report(report)
    if check and not own.converged:
        what = f"a relative residual of {own.relative_residual:.3g} after {own.iterations} iterations{advice}"
        if own.status == "did not reach the accuracy":
            known = np.isfinite(own.estimated_error)
            what = (f"an estimated error of {own.estimated_error:.3g}" if known else
                    "an error that cannot be estimated: no two depths can be compared")
        error = ConvergenceError(f"the solver did not converge: the iteration {own.status}, with {what}")
        error.result, error.report = result, own
        raise error
    return (result, own) if return_report else result


def _csr(arrays: tuple, is_symmetric: bool) -> scipy.sparse.csr_matrix:
    values, indices, starts, m, n = arrays
    if is_symmetric:  # its columns are its rows
        result = scipy.sparse.csr_matrix((values, indices, starts), shape=(m, n), copy=False)
        result.has_sorted_indices = True
        return result
    return scipy.sparse.csc_matrix((values, indices, starts), shape=(m, n), copy=False).tocsr()


@shown()
class MemoryEstimate(NamedTuple):
    """How large a space is, and how much memory a Poisson problem in it takes.

    Attributes
    ----------
    dimension : float
        Number of splines.
    surface : float
        Bytes of the surface, whatever the depth.
    solver : float
        Bytes of the space, the matrices and the multigrid solver, or of what is needed to make the space,
        if that is more.
    """

    dimension: float
    surface: float
    solver: float

    @property
    def total(self) -> float:
        """Bytes of all."""
        return self.surface + self.solver


@takes_surface
def estimate_memory(V: Any, F: Any = None, *, depth: int, cube_scale: float = 1.1,
                    normals: Any = None, areas: Any = None) -> MemoryEstimate:
    """Tells before any work how much memory a depth takes.

    Right within some percent where the pieces of a surface are larger than the cells; with many
    boundaries, as in ragged scans, there are up to three times as many splines at small depths.
    Eigenvectors and values at vertices come on top, 8 bytes for each number.

    Parameters
    ----------
    V, F, normals, areas : as for Space
        The surface.
    depth : int
        Of the octree.
    cube_scale : float, default 1.1
        Side of the octree over the longest side of the bounding box.

    Returns
    -------
    MemoryEstimate
        The dimension of the space, and bytes.

    Raises
    ------
    InputError
        The surface or an argument cannot be used.

    Examples
    --------
    >>> import restricted_laplacian as rl
    >>> V, F = rl.icosphere(5)
    >>> estimate = rl.estimate_memory(V, F, depth=6)
    >>> bool(abs(estimate.dimension / rl.Space(V, F, depth=6).dimension - 1) < 0.05)
    True
    >>> rl.estimate_memory(V, F, depth=12).total > 1e11
    True
    """
    surface = make_surface(V, F, normals=normals, areas=areas)
    return MemoryEstimate(*_core.estimate_memory(surface, int(depth), float(cube_scale)))


@shown()
class Operators(NamedTuple):
    """Stiffness matrix S (minus the Laplacian) and mass matrix M.

    Attributes
    ----------
    stiffness, mass : scipy.sparse.csr_matrix
        Symmetric; without unit, and in units of area.
    """

    stiffness: scipy.sparse.csr_matrix
    mass: scipy.sparse.csr_matrix


@takes_surface
def cotangent_operators(V: Any, F: Any = None, *, lumped_mass: bool = False) -> Operators:
    """Stiffness and mass matrix of the functions that are linear on each triangle.

    The cotangent Laplacian, with the sign and units of `Space.operators`: for comparison, and as the
    product of functions at vertices. The triangles need not form a manifold; those without area are
    left out, and a vertex without another one has an empty row.

    Parameters
    ----------
    V, F : array_like, (n, 3) and (m, 3)
        The triangles, as for `Space`.
    lumped_mass : bool, default False
        Whether the mass matrix is diagonal: a third of the area of the triangles at each vertex.

    Returns
    -------
    Operators
        ``stiffness``, the cotangent matrix, without unit; and ``mass``, in units of area: both
        (n, n), symmetric, scipy.sparse.csr_matrix.

    Raises
    ------
    InputError
        The surface consists of points.

    See Also
    --------
    Space.operators : Those of splines, which hardly depend on the triangulation.

    Examples
    --------
    >>> import restricted_laplacian as rl
    >>> V, F = rl.icosphere(3)
    >>> S, M = rl.cotangent_operators(V, F)
    >>> S.shape, bool(abs(M.sum() - rl.Space(V, F).area) < 1e-12), bool(abs(S.sum(axis=0)).max() < 1e-12)
    ((642, 642), True, True)
    """
    stiffness, mass = make_surface(V, F).cotangent_operators(bool(lumped_mass))
    return Operators(_csr(stiffness, True), _csr(mass, True))


def _tensors(directions: Any, factors: Any) -> np.ndarray:
    """Symmetric matrices with two factors along two directions."""
    d, w = numbers(directions, "diffusion", np.float64), numbers(factors, "diffusion", np.float64)
    if d.ndim != 3 or d.shape[1:] != (2, 3) or w.shape != d.shape[:2]:
        raise argument_error("diffusion", "of two directions must be a pair of arrays (n, 2, 3) and (n, 2), and these "
                             f"are {d.shape} and {w.shape}")
    return np.einsum("nk,nki,nkj->nij", w / (d ** 2).sum(axis=2), d, d)


@shown("depth", "dimension", "number_of_vertices", "number_of_faces", "components", "area")
class Space:
    """B-splines of degree 2 on an octree, restricted to a surface.

    Parameters
    ----------
    V : array_like, (n, 3)
        Points of any type of numbers; or a mesh with ``.vertices`` and ``.faces`` (trimesh), or
        one of meshio, in place of `V` and `F`.
    F : array_like, (m, k), or list of lists, optional
        Numbers of the points at the corners of each face, three or more, in a list of lists as many
        as each has. The faces need not form a manifold.
    normals : array_like, (n, 3), optional
        For points without faces.
    areas : array_like, (n,), optional
        The area that each of them stands for, estimated by default.
    neighbors : int, optional
        How many nearest points the estimate takes, 16 by default.
    depth : int, optional
        Of the octree. By default from 5 to 8, about as fine as the triangles.
    cube_scale : float, optional
        Side of the octree over the longest side of the bounding box, 1.1 by default.
    joining_tolerance : float, optional
        Distance up to which boundaries that run along each other are joined.
    split : bool, optional
        Whether splines are split where several pieces of the surface are in their support: by
        default for triangles, and not for points.
    paper : bool
        The space of the paper of 2009, for comparison.
    geometry : {"flat", "smooth"} or callable, optional
        Whether the surface consists of the triangles, the default, or is a smooth one through their
        vertices: for meshes whose vertices lie on such a surface, and not for those whose triangles
        were fitted to it. A callable takes points (N, 3) near the surface to points on it.
    vertex_data : {"linear", "smooth"}, optional
        What arrays of values at vertices mean between them, linear by default.
    crease_angle : float
        Of smooth geometry and data: edges at which normals of faces differ by more, in degrees, are
        creases.
    vertex_normals : array_like, (n, 3), optional
        Of smooth geometry and data; estimated by default, and where they are 0 or NaN.
    diffusion : float, array_like or callable, optional
        D of the operator -div(D grad u) / rho, 1 by default: a positive number; (n,) at vertices or (m,) on
        faces; a symmetric matrix at each, (n, 3, 3) or (m, 3, 3), of which the part along the surface counts,
        which is positive definite; or a callable that takes points (N, 3) and returns (N,) or (N, 3, 3). Or a pair
        of directions, (n, 2, 3) or (m, 2, 3), tangential and orthogonal to each other, and of the factors along
        them, (n, 2) or (m, 2).
    anisotropy : float or pair of floats, optional
        In place of the diffusion: factors exp(-a |k|) along each principal direction, where k is the curvature
        along the other one; a is a length, 0 gives 1. Of a pair the first is for the direction of the larger
        curvature. The curvature is that of `curvature` in this space.
    density : float, array_like or callable, optional
        rho of it, positive, 1 by default. Integrals have this weight: mass matrices and loads.
    maximum_memory : float, optional
        Bytes that the surface, the space and a Poisson problem or eigenpairs in it may take, see
        `estimate_memory`: what would take more is refused before any work. By default those of the
        machine.
    threads : int, optional
        By default all processors. Results do not depend on it.

    Examples
    --------
    >>> import restricted_laplacian as rl
    >>> V, F = rl.icosphere(3)
    >>> space = rl.Space(V, F, depth=4)
    >>> space.depth, space.components
    (4, 1)
    >>> S, M = space.operators()
    >>> bool(abs(M.sum() - space.area) < 1e-12)
    True

    The icosphere stands for a sphere, of which it is a coarse mesh:

    >>> import math
    >>> smooth = rl.Space(V, F, depth=4, geometry="smooth")
    >>> round(space.area, 3), round(smooth.area, 3), round(4 * math.pi, 3)
    (12.506, 12.566, 12.566)
    >>> import numpy as np
    >>> project = lambda p: p / np.linalg.norm(p, axis=1, keepdims=True)
    >>> round(rl.Space(V, F, depth=4, geometry=project).area, 3)
    12.566
    """

    @takes_surface
    def __init__(self, V: Any, F: Any = None, *, normals: Any = None, areas: Any = None,
                 neighbors: Optional[int] = None, depth: Optional[int] = None,
                 cube_scale: Optional[float] = None, joining_tolerance: Optional[float] = None,
                 split: Optional[bool] = None, paper: bool = False, geometry: Any = None,
                 vertex_data: Optional[str] = None, crease_angle: float = 40,
                 vertex_normals: Any = None, diffusion: Any = None, anisotropy: Any = None, density: Any = None,
                 maximum_memory: Optional[float] = None,
                 threads: Optional[int] = None) -> None:
        self._threads = number_of_threads(threads)
        self._surface = make_surface(V, F, normals=normals, areas=areas, neighbors=neighbors,
                                     threads=threads)
        if vertex_normals is not None:
            vertex_normals = numbers(vertex_normals, "vertex_normals")
        sectors = float(crease_angle), vertex_normals
        self._flat = None  # what is projected, which does not keep its points
        if callable(geometry):
            self._flat = self._surface
            self._surface = self._surface.projected(geometry)
        elif geometry == "smooth":
            self._surface = self._surface.curved(*sectors)
        elif geometry not in ("flat", None):
            raise argument_error("geometry", "must be flat, smooth or a callable, and is "
                                 f"{geometry!r}")
        if vertex_data not in ("linear", "smooth", None):
            raise argument_error("vertex_data", f"must be linear or smooth, and is {vertex_data!r}")
        # of smooth data; they have no meaning on points
        self._sectors: Optional[tuple[float, Any]] = None
        if vertex_data == "smooth" and not self._surface.is_point_set:
            self._sectors = sectors
        if callable(depth):  # `space_of` says it of the surface
            depth = depth(self._surface)
        depth = _checked_depth(depth)
        self._space = _core.Space.make(self._surface, depth, cube_scale, joining_tolerance, split,
                                       bool(paper), maximum_memory, self._threads)
        self._set_material(diffusion, anisotropy, density)
        self._options = dict(
            depth=depth, cube_scale=cube_scale, joining_tolerance=joining_tolerance, split=split, paper=paper,
            geometry=geometry, vertex_data=vertex_data, crease_angle=crease_angle,
            vertex_normals=vertex_normals,
            diffusion=diffusion, anisotropy=anisotropy, density=density, maximum_memory=maximum_memory, threads=threads)

    def __reduce__(self) -> tuple:
        points, faces, normals, areas = surface_state(self._flat or self._surface)
        of_points = dict(normals=normals, areas=areas) if faces is None else {}
        return _made_again, (Space, (points, faces), dict(of_points, **self._options))

    def _set_material(self, diffusion: Any, anisotropy: Any, density: Any) -> None:
        if isinstance(diffusion, tuple) and len(diffusion) == 2:
            diffusion = _tensors(*diffusion)
        matrices = diffusion is not None and not callable(diffusion) and np.ndim(diffusion) == 3
        lengths: Optional[list[float]] = None
        if anisotropy is not None:
            if diffusion is not None:
                raise argument_error("anisotropy", "is in place of a diffusion, which is given")
            given = numbers(anisotropy, "anisotropy", np.float64).ravel()
            if len(given) not in (1, 2):
                raise argument_error("anisotropy", f"must be one number or two, and is {len(given)}")
            lengths = [float(given[0]), float(given[-1])]
        self._space = self._space.with_material(
            None if diffusion is None else self._function(diffusion, "diffusion", bool(matrices)),
            None if density is None else self._function(density, "density"), lengths)

    def with_material(self, *, diffusion: Any = None, anisotropy: Any = None, density: Any = None) -> "Space":
        """The same space of another material, which shares all but what depends on it.

        Parameters
        ----------
        diffusion, anisotropy, density : as for Space
            Of the operator -div(D grad u) / rho; 1 by default, also if this space has others.

        Returns
        -------
        Space
            Its octree and splines are those of this one, so a function of one is a function of the other.

        Examples
        --------
        >>> import restricted_laplacian as rl
        >>> V, F = rl.icosphere(3)
        >>> space = rl.Space(V, F, depth=4)
        >>> heavy = space.with_material(density=4)
        >>> bool(abs(4 * rl.eigs(heavy, count=4)[0] - rl.eigs(space, count=4)[0]).max() < 1e-6)
        True
        """
        result = copy.copy(self)
        result._set_material(diffusion, anisotropy, density)
        result._options = dict(self._options, diffusion=diffusion, anisotropy=anisotropy, density=density)
        return result

    def _with(self, space: Any) -> "Space":
        """The same of another depth."""
        if space.depth == self.depth:
            return self
        result = copy.copy(self)
        result._space = space
        result._options = dict(self._options, depth=space.depth)
        return result

    @property
    def depth(self) -> int:
        """Depth of the octree."""
        return self._space.depth

    @property
    def dimension(self) -> int:
        """Number of splines: rows of the matrices."""
        return self._space.dimension

    @property
    def cell_width(self) -> float:
        """Width of the finest cells."""
        return self._space.cell_width

    @property
    def components(self) -> int:
        """Number of connected components of the surface."""
        return self._space.components

    @property
    def area(self) -> float:
        """Area of the surface."""
        return self._surface.area

    @property
    def folded_faces(self) -> int:
        """Number of faces of a smooth geometry that remain flat, since they would fold."""
        return self._surface.number_of_folded_faces

    @property
    def number_of_vertices(self) -> int:
        """Number of rows of V."""
        return self._surface.number_of_vertices

    @property
    def triangles(self) -> np.ndarray:
        """(k, 3) rows of V: the triangles that the faces are divided into, to which locations refer.

        They are the rows of F if these are triangles. Points without faces have none.
        """
        return np.zeros((0, 3), int) if self._surface.is_point_set else self._surface.faces()

    @property
    def number_of_faces(self) -> int:
        """Number of rows of F; of points without faces their number."""
        return self._surface.number_of_polygons

    def _function(self, f: Any, name: str, vectors: bool = False, *, everywhere: bool = True
                  ) -> _core.Function:
        """What a caller gives as a function or vector field on the surface."""
        if self._sectors is None:
            return as_function(f, self._surface, name, vectors, None, everywhere)
        crease_angle, vertex_normals = self._sectors

        def smooth(values: np.ndarray) -> _core.Function:
            return _core.smooth_function(self._surface, crease_angle, vertex_normals, values)
        return as_function(f, self._surface, name, vectors, smooth, everywhere)

    def operators(self, stabilization: float = 0, level: Optional[int] = None, *,
                  stabilize_mass: bool = True, progress: Progress = None) -> Operators:
        """Stiffness matrix S and mass matrix M, symmetric, as CSR matrices without a copy.

        Parameters
        ----------
        stabilization : float, default 0
            Factor of the stabilization by derivatives along the normal.
        level : int, optional
            Of the octree, the finest one by default.
        stabilize_mass : bool, default True
            False for eigenvalue problems.
        progress : bool or callable, optional
            True shows a bar; a callable gets the part that is done.

        Returns
        -------
        Operators
            Two matrices, (dimension, dimension).
        """
        s, m = self._space.operators(float(stabilization), level, bool(stabilize_mass),
                                     self._threads, listener(progress))
        return Operators(_csr(s, True), _csr(m, True))

    def stiffness(self, stabilization: float = 0, level: Optional[int] = None
                  ) -> scipy.sparse.csr_matrix:
        """Stiffness matrix, minus the Laplacian: positive semi-definite.

        Parameters
        ----------
        stabilization, level : as for operators
            What is assembled.

        Returns
        -------
        scipy.sparse.csr_matrix, (dimension, dimension)
            Without unit.
        """
        return self.operators(stabilization, level).stiffness

    def mass(self, stabilization: float = 0, level: Optional[int] = None
             ) -> scipy.sparse.csr_matrix:
        """Mass matrix; its entries sum to the area.

        Parameters
        ----------
        stabilization, level : as for operators
            What is assembled.

        Returns
        -------
        scipy.sparse.csr_matrix, (dimension, dimension)
            In units of area.
        """
        return self.operators(stabilization, level).mass

    def prolongation(self, level: int) -> scipy.sparse.csr_matrix:
        """The matrix from coefficients on a level to those on the next finer one.

        Parameters
        ----------
        level : int
            The coarser one.

        Returns
        -------
        scipy.sparse.csr_matrix
            A row for each spline of the finer level, a column for each of the coarser one.
        """
        return _csr(self._space.prolongation(level), False)

    def integrals(self) -> np.ndarray:
        """Integrals of the splines.

        Returns
        -------
        numpy.ndarray, (dimension,)
            In units of area; they sum to the area.
        """
        return self._space.integrals(self._threads)

    def loads(self, f: Any) -> np.ndarray:
        """Integrals of f times each spline: right-hand sides.

        Parameters
        ----------
        f : array_like or callable
            (n,) or (n, K) at vertices, as `vertex_data` says; (m,) or (m, K) on faces; `Corners`;
            or a callable that takes points (N, 3), many at a time, and returns (N,) or (N, K). An
            attribute ``degree`` of it, 6 by default, says which polynomials it is close to.

        Returns
        -------
        numpy.ndarray
            (dimension,), or (dimension, K) if `f` has two dimensions.
        """
        result = self._space.loads(self._function(f, "f"), self._threads)
        is_column = np.ndim(f) == 2 and not callable(f)
        return result if result.shape[1] != 1 or is_column else result[:, 0]

    def gradient_loads(self, v: Any) -> np.ndarray:
        """Integrals of a vector field times the gradient of each spline.

        Parameters
        ----------
        v : array_like or callable
            See `integrate_gradient`.

        Returns
        -------
        numpy.ndarray
            (dimension,), or (dimension, K) of K fields.
        """
        result = self._space.gradient_loads(self._function(v, "v", True),
                                            self._threads)
        return result[:, 0] if result.shape[1] == 1 else result

    def _locations(self, faces: Any, barycentric: Any) -> Any:
        if faces is None:
            return None
        if self._surface.is_point_set and barycentric is None:
            barycentric = np.tile([1.0, 0.0, 0.0], (len(faces), 1))
        if barycentric is None:
            raise argument_error("barycentric", "is missing")
        indices = numbers(faces, "faces", np.int64)
        return _core.locations(indices.ravel(), rows(barycentric, "barycentric"))

    def evaluation_matrix(self, faces: Any = None, barycentric: Any = None
                          ) -> scipy.sparse.csr_matrix:
        """The matrix from coefficients to values: at the vertices, or at points of faces.

        Rows of vertices without a face of positive area are empty.

        Parameters
        ----------
        faces : array_like, (N,), optional
            Rows of `Space.triangles`: of F, if its faces are triangles.
        barycentric : array_like, (N, 3), optional
            Coordinates with respect to their vertices.

        Returns
        -------
        scipy.sparse.csr_matrix, (N, dimension)
            (n, dimension) for the vertices.
        """
        return _csr(self._space.evaluation(self._locations(faces, barycentric), None, None), False)

    def derivative_matrices(self, faces: Any = None, barycentric: Any = None
                            ) -> tuple[scipy.sparse.csr_matrix, ...]:
        """The three matrices from coefficients to derivatives along x, y and z.

        The part along the surface is that of the gradient; that along the normal has no meaning.

        Parameters
        ----------
        faces, barycentric : as for evaluation_matrix
            Where.

        Returns
        -------
        tuple of scipy.sparse.csr_matrix
            Three of the shape (N, dimension), in units of 1 / length.
        """
        where = self._locations(faces, barycentric)
        return tuple(_csr(self._space.evaluation(where, axis, None), False) for axis in range(3))

    def function(self, coefficients: Any) -> "SplineFunction":
        """The function, or functions, of some coefficients.

        Parameters
        ----------
        coefficients : array_like
            (dimension,), or (dimension, K) of K functions.

        Returns
        -------
        SplineFunction
            It can be evaluated anywhere on the surface.
        """
        return SplineFunction(self, coefficients)


def _checked_depth(depth: Any) -> Optional[int]:
    if depth is None:
        return None
    if isinstance(depth, bool) or not isinstance(depth, (int, np.integer)):
        raise argument_error("depth", f"must be a whole number, and is {depth!r}")
    return int(np.clip(depth, -1, 1000))


def _made_again(cls: type, arguments: tuple, options: dict) -> Any:
    """What pickle calls."""
    return cls(*arguments, **options)


@shown("space", "coefficients")
class SplineFunction(Viewable):
    """One function of a space, or several: it can be evaluated anywhere on the surface.

    Parameters
    ----------
    space : Space
        The space.
    coefficients : array_like, (dimension,) or (dimension, K)
        Of the splines.

    Examples
    --------
    >>> import numpy as np, restricted_laplacian as rl
    >>> V, F = rl.icosphere(3)
    >>> u = rl.fit_function(V, F, V[:, 2], depth=4, as_spline=True)
    >>> center = u([0], [[1/3, 1/3, 1/3]])
    >>> bool(abs(center[0] - V[F[0], 2].mean()) < 1e-2)
    True
    """

    def __init__(self, space: Space, coefficients: Any) -> None:
        self.space = space
        self.coefficients = numbers(coefficients, "coefficients", np.float64)
        self._rows = rows(self.coefficients, "coefficients")
        if self._rows.shape[0] != space.dimension:
            raise argument_error("coefficients", f"has {self._rows.shape[0]} rows, but the "
                                 f"dimension of the space is {space.dimension}")

    def _shaped(self, values: np.ndarray) -> np.ndarray:
        return values[:, 0] if self.coefficients.ndim == 1 else values

    def at_vertices(self) -> np.ndarray:
        """Values at the vertices; NaN where no face has an area.

        Returns
        -------
        numpy.ndarray
            (n,), or (n, K) of K functions.
        """
        return self._shaped(self.space._space.values(self._rows, None, self.space._threads))

    def __call__(self, faces: Any, barycentric: Any = None) -> np.ndarray:
        """Values at points of faces: (N,) numbers of faces, and (N, 3) barycentric coordinates."""
        where = self.space._locations(faces, barycentric)
        return self._shaped(self.space._space.values(self._rows, where, self.space._threads))

    def _gradients(self, where: Any, normals: np.ndarray) -> np.ndarray:
        d = self.space._space.derivatives(self._rows, where, self.space._threads)
        g = np.stack(d, axis=1)  # (N, 3, K)
        g = g - normals[:, :, np.newaxis] * np.einsum("nik,ni->nk", g, normals)[:, np.newaxis, :]
        return g[:, :, 0] if self.coefficients.ndim == 1 else g

    def view(self, *, refine: int = 0, names: Any = None, **options: Any) -> View:
        """A `View` of the functions.

        Parameters
        ----------
        refine : int, default 0
            N divides faces until no side is longer than 1/N of the width of a cell, with values of the
            spline at all vertices; 0 leaves the faces as they are.
        names : list of str, optional
            Of the functions.
        **options : as for View
            What it takes.

        Returns
        -------
        View
            With a slider if there are several functions.
        """
        number = self._rows.shape[1]
        if names is None:
            names = ["value"] if number == 1 else [f"value {k}" for k in range(number)]
        elif len(names) != number:
            raise argument_error("names", f"has {len(names)} names of {number} functions")
        if not 0 <= refine <= 64:
            raise argument_error("refine", "must lie between 0 and 64")
        values = self.at_vertices().reshape(-1, number)
        side = self.space.cell_width / refine if refine else 0.0
        return view_of_surface(self.space._surface, list(names), values, self, side, options)

    def gradients(self, faces: Any, barycentric: Any = None) -> np.ndarray:
        """Gradients along the surface at points of faces.

        Parameters
        ----------
        faces : array_like, (N,)
            Rows of `Space.triangles`: of F, if its faces are triangles.
        barycentric : array_like, (N, 3), optional
            Coordinates with respect to their vertices; of point sets none.

        Returns
        -------
        numpy.ndarray
            (N, 3), or (N, 3, K) of K functions.
        """
        where = self.space._locations(faces, barycentric)
        normals = self.space._surface.face_normals()[numbers(faces, "faces", np.int64).ravel()]
        return self._gradients(where, normals)

    def gradients_at_vertices(self) -> np.ndarray:
        """Gradients along the planes that the vertex normals are orthogonal to.

        Returns
        -------
        numpy.ndarray
            (n, 3), or (n, 3, K) of K functions.
        """
        return self._gradients(None, self.space._surface.vertex_normals())


@shown("space", "alpha")
class PoissonSolver:
    """Solves (S + alpha M) x = b by conjugate gradients with a multigrid cycle; set up once.

    Parameters
    ----------
    space : Space
        The space.
    alpha : float, default 0
        Screening weight, in units of 1 / area.
    tolerance : float, optional
        Residual over right-hand side, 1e-3 by default.
    energy_tolerance : float, optional
        Estimated error in the energy norm over that of the solution, at which to end as well.
    stabilization : float, optional
        Factor of the stabilization, 1e-3 by default.
    cycle : {"v", "w"}
        Of multigrid.
    smoother : {"patch", "point"}
        Of multigrid: small systems of splines near each other, or one spline after the other.
    maximum_iterations : int, optional
        Of conjugate gradients, 1000 by default.
    progress : bool or callable, optional
        See `solve_poisson`.

    Examples
    --------
    >>> import restricted_laplacian as rl
    >>> V, F = rl.icosphere(3)
    >>> space = rl.Space(V, F, depth=4)
    >>> solver = rl.PoissonSolver(space, alpha=2.0, tolerance=1e-8)
    >>> x = solver.solve(space.loads(V))
    >>> u = space.function(x).at_vertices()  # (2 - Laplacian) u = V has the solution V / 4
    >>> bool(abs(4 * u - V).max() < 0.02)
    True
    """

    def __init__(self, space: Space, alpha: float = 0, *, tolerance: Optional[float] = None,
                 energy_tolerance: Optional[float] = None, stabilization: Optional[float] = None,
                 cycle: str = "v", smoother: str = "patch", maximum_iterations: Optional[int] = None,
                 progress: Progress = None) -> None:
        self.space, self.alpha = space, float(alpha)
        self._options = dict(tolerance=tolerance, energy_tolerance=energy_tolerance,
                             stabilization=stabilization, cycle=cycle, smoother=smoother,
                             maximum_iterations=maximum_iterations)
        self._solver = _core.make_solver(
            space._space, float(alpha),
            solver_options(tolerance, energy_tolerance, stabilization, cycle, smoother,
                           maximum_iterations),
            space._threads, listener(progress))

    def __reduce__(self) -> tuple:
        return _made_again, (PoissonSolver, (self.space, self.alpha), self._options)

    @property
    def kernel_dimension(self) -> int:
        """Number of components of the surface on which the mean of the solution is set to 0."""
        return self._solver.kernel_dimension

    def solve(self, b: Any, guess: Any = None, *, tolerance: Optional[float] = None,
              progress: Progress = None, check: bool = True, return_report: bool = False) -> Any:
        """Coefficients of the solution, for one right-hand side (dimension,) or many (dimension, K).

        Parameters
        ----------
        b : array_like, (dimension,) or (dimension, K)
            Such as `Space.loads` returns.
        guess : array_like, optional
            A first guess of the shape of `b`.
        tolerance : float, optional
            In place of that of the solver.
        progress : bool or callable, optional
            See `solve_poisson`.
        check : bool, default True
            Whether to raise a `ConvergenceError`.
        return_report : bool, default False
            Whether to return a `Report`, too.

        Returns
        -------
        x : numpy.ndarray
            Coefficients, of the shape of `b`.
        report : Report
            If `return_report`.
        """
        own = numbers(b, "b", np.float64)
        first = None if guess is None else rows(guess, "guess")
        x, report = self._solver.solve(rows(own, "b"), first, tolerance, self.space._threads,
                                       listener(progress))
        return checked(x[:, 0] if own.ndim == 1 else x, report, check, return_report)


def solver_options(tolerance: Any, energy_tolerance: Any, stabilization: Any, cycle: str = "v",
                   smoother: str = "patch", maximum_iterations: Optional[int] = None,
                   **more: Any) -> dict:
    """Options of the C++ library."""
    for name, value, choices in (("cycle", cycle, ("v", "w")),
                                 ("smoother", smoother, ("patch", "point"))):
        if value not in choices:
            raise argument_error(name, f"must be one of {choices}, and is {value!r}")
    options = dict(tolerance=tolerance, energy_tolerance=energy_tolerance,
                   stabilization=stabilization, maximum_iterations=maximum_iterations, **more)
    for name, value in options.items():
        if value is not None and name != "gradients":
            try:
                options[name] = float(value)
            except (TypeError, ValueError):
                raise argument_error(name, f"must be a number, and is {value!r}") from None
    return dict(options, cycle=cycle, smoother=smoother)


def space_of(V: Any, F: Any, threads: Optional[int], accuracy: Optional[float] = None, **options: Any
             ) -> Space:
    """A space, or the one that is given; with an accuracy the first one of the search for it."""
    if not isinstance(V, Space):
        if accuracy is not None:
            if options.get("anisotropy") is not None:
                raise argument_error("anisotropy", "follows the curvature in a space: it needs a depth, no accuracy")
            given = options.get("depth")
            options["depth"] = lambda surface: _core.first_depth_of_search(surface, _checked_depth(given))
        return Space(V, F, threads=threads, **options)  # type: ignore[no-any-return,unused-ignore]
    if F is not None or any(v is not None and v is not False for v in options.values()):
        raise InputError("a space needs neither F nor options of spaces")
    if accuracy is not None:
        raise argument_error("accuracy", "chooses the depth: it needs a surface, not a space")
    return V

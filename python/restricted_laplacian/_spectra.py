# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Eigenvalues, eigenfunctions, and descriptors that are made of them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Optional, Union

import numpy as np
import scipy.linalg
import scipy.sparse

from . import _core
from ._errors import argument_error
from ._input import Progress, listener, number_of_threads, numbers, takes_surface
from ._show import shown
from ._space import (Report, SplineFunction, Space, checked, cotangent_operators, solver_options,
                     space_of)
from ._view import View, Viewable


@shown("eigenvalues", "vertex_values", "area", "space")
@dataclass(frozen=True, repr=False)
class Spectrum(Viewable):
    """The low end of the spectrum of minus the Laplacian.

    Attributes
    ----------
    eigenvalues : numpy.ndarray, (k,)
        Ascending, in units of 1 / area; the first is 0.
    vertex_values : numpy.ndarray, (n, k)
        Eigenfunctions at the vertices; the integral of the square of each is 1. Empty with
        `eigenvalues_only`.
    coefficients : numpy.ndarray, (dimension, k)
        The same as splines.
    area : float
    estimated_errors : numpy.ndarray, (k,)
        How large the relative errors of the eigenvalues are that the finite elements make, by what changed
        from level to level; empty where it is not known. ``report.estimated_error`` is the largest, and
        ``report.is_estimate_trusted`` whether cells resolve the surface.
    extrapolated_eigenvalues : numpy.ndarray, (k,)
        Without the error that falls fourfold from level to level: mostly nearer than `eigenvalues`, which
        are upper bounds up to the stabilization; empty where it is not known.
    space : Space
    report : Report
    """

    eigenvalues: np.ndarray
    vertex_values: np.ndarray
    coefficients: np.ndarray
    area: float
    estimated_errors: np.ndarray
    extrapolated_eigenvalues: np.ndarray
    space: Space
    report: Report

    def functions(self) -> SplineFunction:
        """The eigenfunctions, to be evaluated anywhere.

        Returns
        -------
        SplineFunction
            Of k columns.
        """
        return self.space.function(self.coefficients)

    def view(self, *, refine: int = 0, **options: Any) -> View:
        """A `View` of the eigenfunctions.

        Parameters
        ----------
        refine : int, default 0
            How fine the faces are divided, see `SplineFunction.view`.
        **options : as for View
            What it takes.

        Returns
        -------
        View
            With a slider.
        """
        names = [f"eigenfunction {i}, eigenvalue {x:.6g}" for i, x in enumerate(self.eigenvalues)]
        return self.functions().view(refine=refine, names=names,
                                     **{"title": "Eigenfunctions",
                                        "first": min(1, len(names) - 1), **options})


@takes_surface
def laplace_spectrum(V: Any, F: Any = None, count: int = 50, *, eigensolver: str = "auto",
                     eigenvalues_only: bool = False, orthonormal: str = "surface",
                     accuracy: Optional[float] = None, tolerance: Optional[float] = None,
                     maximum_iterations: Optional[int] = None,
                     stabilization: Optional[float] = None, normals: Any = None,
                     depth: Optional[int] = None, joining_tolerance: Optional[float] = None,
                     geometry: Any = None,
                     diffusion: Any = None, anisotropy: Any = None, density: Any = None,
                     threads: Optional[int] = None, progress: Progress = None,
                     check: bool = True, return_report: bool = False) -> Any:
    """The smallest eigenvalues of minus the Laplacian, and eigenfunctions.

    With a diffusion D and a density rho those of -div(D grad u) = lambda rho u, orthonormal in the density.

    Parameters
    ----------
    V, F, normals, depth, joining_tolerance, geometry, diffusion, anisotropy, density : as for Space
        The surface: points (n, 3) and triangles (m, 3); or a pair of them, a mesh of another library, or a
        `Space` as `V` alone.
    count : int, default 50
        Number of eigenvalues, with multiplicities and zeros.
    eigensolver : {"auto", "multigrid", "shift-invert"}
        The faster one by default; if multigrid stalls, a factorization (shift-invert) where memory
        allows. ``report.eigensolver`` says which one it was.
    eigenvalues_only : bool, default False
        Whether eigenfunctions are of no use: they are not evaluated at the vertices, and the
        iteration ends earlier.
    orthonormal : {"surface", "vertices"}
        Whether the integral of the product of two eigenfunctions is 0 or 1 on the surface; or, with the
        mass matrix of `cotangent_operators` for the values at the vertices (for points, their areas),
        which other libraries check. By default the surface; at the vertices of a coarse mesh the two
        differ by some percent.
    accuracy : float, optional
        Deeper and deeper spaces are tried until the largest estimated relative error of the eigenvalues is
        not larger. `depth` says where that begins then, at 4 by default.
    tolerance : float, optional
        Residual, 1e-3 by default, or 2.5e-3 with `eigenvalues_only`; errors of eigenvalues are
        about its square.
    maximum_iterations : int, optional
        Of multigrid, on each level; 100 by default.
    stabilization : float, optional
        1e-5 by default.
    threads, progress, check, return_report : as for solve_poisson
        How the work is done, and what is returned.

    Returns
    -------
    Spectrum
        Eigenvalues (k,) in units of 1 / area, ascending; eigenfunctions at the vertices (n, k) in units of
        1 / length, and as splines.
    report : Report
        If `return_report`.

    Raises
    ------
    InputError
        A `ValueError` that names the face, the vertex or the argument.
    ConvergenceError
        A `RuntimeError`, with what was found; it says what to try.
    Canceled
        A callback of `progress` returned False.

    Examples
    --------
    >>> import restricted_laplacian as rl
    >>> spectrum = rl.laplace_spectrum(rl.icosphere(4), 9)
    >>> spectrum.eigenvalues.round(1) + 0.
    array([0., 2., 2., 2., 6., 6., 6., 6., 6.])
    """
    if eigensolver not in ("auto", "multigrid", "shift-invert"):
        raise argument_error("eigensolver", f"must be auto, multigrid or shift-invert, and is "
                             f"{eigensolver!r}")
    if isinstance(count, bool) or not isinstance(count, (int, np.integer)):
        raise argument_error("count", f"must be a whole number, and is {count!r}")
    if orthonormal not in ("surface", "vertices"):
        raise argument_error("orthonormal", f"must be surface or vertices, and is {orthonormal!r}")
    space = space_of(V, F, threads, accuracy, normals=normals, depth=depth,
                     joining_tolerance=joining_tolerance, geometry=geometry, diffusion=diffusion,
                     anisotropy=anisotropy, density=density)
    if orthonormal == "vertices" and space._options["density"] is not None:
        raise argument_error("orthonormal", "must be surface where there is a density")
    last, values, at_vertices, vectors, area, errors, extrapolated, report = _core.eigenpairs(
        space._space, int(count), eigensolver, bool(eigenvalues_only), accuracy,
        solver_options(tolerance, None, stabilization, maximum_iterations=maximum_iterations),
        number_of_threads(threads), listener(progress))
    space = space._with(last)
    if orthonormal == "vertices" and not eigenvalues_only:
        at_vertices, vectors = _orthonormal_at_vertices(space, at_vertices, vectors)
    spectrum = Spectrum(values, at_vertices, vectors, area, errors, extrapolated, space, Report(report))
    advice = {"multigrid": '; eigensolver="shift-invert" may find all of them, or a larger '
                           "tolerance or maximum_iterations",
              "shift-invert": "; a smaller count, or another depth, may help"}
    return checked(spectrum, report, check, return_report, advice[report["eigensolver"]])


def _orthonormal_at_vertices(space: Space, functions: np.ndarray, coefficients: np.ndarray
                             ) -> tuple[np.ndarray, np.ndarray]:
    """Both times the matrix that makes the Gram matrix of the functions at the vertices the identity."""
    surface = space._surface
    mass: Any
    if surface.is_point_set:
        mass = scipy.sparse.diags(surface.vertex_areas())
    else:
        mass = cotangent_operators(surface).mass
    known = np.nan_to_num(functions)
    try:
        factor = np.linalg.cholesky(known.T @ (mass @ known))
    except np.linalg.LinAlgError:
        raise argument_error("orthonormal", f"cannot be vertices: {functions.shape[0]} of them do not tell "
                             f"{functions.shape[1]} eigenfunctions apart") from None
    return tuple(scipy.linalg.solve_triangular(factor, a.T, lower=True, check_finite=False).T  # type: ignore
                 for a in (functions, coefficients))


@takes_surface
def eigs(V: Any, F: Any = None, count: int = 50, *, eigensolver: str = "auto", orthonormal: str = "surface",
         accuracy: Optional[float] = None, tolerance: Optional[float] = None, maximum_iterations: Optional[int] = None,
         stabilization: Optional[float] = None, normals: Any = None, depth: Optional[int] = None,
         joining_tolerance: Optional[float] = None, geometry: Any = None, diffusion: Any = None,
         anisotropy: Any = None, density: Any = None,
         threads: Optional[int] = None, progress: Progress = None,
         check: bool = True, return_report: bool = False) -> Any:
    """The smallest eigenvalues of minus the Laplacian, and eigenfunctions at the vertices.

    Parameters
    ----------
    V, F, normals, depth, joining_tolerance, geometry, diffusion, anisotropy, density : as for Space
        The surface: points (n, 3) and triangles (m, 3); or a pair of them, a mesh of another library, or a
        `Space` as `V` alone.
    count : int, default 50
        Number of eigenvalues, with multiplicities and zeros.
    eigensolver, orthonormal, accuracy, tolerance, maximum_iterations, stabilization : as for laplace_spectrum
        How they are computed.
    threads, progress, check, return_report : as for solve_poisson
        How the work is done, and what is returned.

    Returns
    -------
    eigenvalues : numpy.ndarray, (k,)
        Ascending, in units of 1 / area.
    eigenfunctions : numpy.ndarray, (n, k)
        The integral of the square of each is 1. With `return_report` the two are a pair, and a `Report`
        comes after it.

    Raises
    ------
    InputError
        A `ValueError` that names the face, the vertex or the argument.
    ConvergenceError
        A `RuntimeError`, with what was found; it says what to try.
    Canceled
        A callback of `progress` returned False.

    Examples
    --------
    >>> import restricted_laplacian as rl
    >>> V, F = rl.icosphere(4)
    >>> l, u = rl.eigs(V, F, 9)
    >>> l.round(1) + 0.
    array([0., 2., 2., 2., 6., 6., 6., 6., 6.])
    """
    s = laplace_spectrum(V, F, count, eigensolver=eigensolver, orthonormal=orthonormal, accuracy=accuracy,
                         tolerance=tolerance, maximum_iterations=maximum_iterations,
                         stabilization=stabilization, normals=normals, depth=depth, joining_tolerance=joining_tolerance, geometry=geometry,
                         diffusion=diffusion, anisotropy=anisotropy, density=density,
                         threads=threads, progress=progress, check=check)
    pairs = s.eigenvalues, s.vertex_values
    return (pairs, s.report) if return_report else pairs


# a spectrum, or eigenvalues and eigenfunctions at any points
_Pairs = Union[Spectrum, tuple]


def _pairs(spectrum: _Pairs) -> tuple[np.ndarray, np.ndarray]:
    if isinstance(spectrum, Spectrum):
        return (_core.with_exact_zeros(spectrum.eigenvalues, spectrum.area),
                spectrum.vertex_values)
    try:
        values, functions = spectrum
    except (TypeError, ValueError):
        raise argument_error("spectrum", "must be a Spectrum, or a pair: eigenvalues, functions"
                             ) from None
    own = numbers(functions, "spectrum", np.float64)
    if own.ndim != 2:
        raise argument_error("spectrum", "needs eigenfunctions as the columns of an array")
    return numbers(values, "spectrum", np.float64).ravel(), own


def number_of_zero_eigenvalues(spectrum: Any) -> int:
    """How many of the first eigenvalues are 0 up to rounding: the components of the surface.

    Parameters
    ----------
    spectrum : Spectrum, or array_like (k,)
        Of eigenvalues; if all of them are 0, there is no scale to see that by, but the area of the
        surface, which a `Spectrum` knows.

    Returns
    -------
    int
        Their number.

    Raises
    ------
    InputError
        There are no numbers.

    Examples
    --------
    >>> import restricted_laplacian as rl
    >>> s = rl.laplace_spectrum(*rl.icosphere(3), 20, depth=4)
    >>> rl.number_of_zero_eigenvalues(s)
    1
    """
    own = spectrum.eigenvalues if isinstance(spectrum, Spectrum) else spectrum
    own = numbers(own, "eigenvalues", np.float64).ravel()
    if isinstance(spectrum, Spectrum):
        own = _core.with_exact_zeros(own, spectrum.area)
    return _core.number_of_zeros(own)


def heat_kernel_times(spectrum: _Pairs, number: int = 100) -> np.ndarray:
    """Times at which a heat kernel signature is taken: evenly on a logarithmic scale.

    Parameters
    ----------
    spectrum : Spectrum, or (array_like (k,), array_like (n, k))
        Or eigenvalues, and eigenfunctions at any n points.
    number : int, default 100
        How many.

    Returns
    -------
    numpy.ndarray, (number,)
        Times in units of area, ascending.

    Raises
    ------
    InputError
        The spectrum is none, or has no eigenvalue above 0.

    Examples
    --------
    >>> import restricted_laplacian as rl
    >>> s = rl.laplace_spectrum(*rl.icosphere(3), 20, depth=4)
    >>> rl.heat_kernel_times(s, 5).shape
    (5,)
    """
    return _core.heat_kernel_times(_pairs(spectrum)[0], int(number))


def heat_trace(spectrum: _Pairs, times: Any) -> np.ndarray:
    """The sum of exp(-l t) over the eigenvalues l, for each time t.

    Parameters
    ----------
    spectrum : Spectrum, or (array_like (k,), array_like (n, k))
        Or eigenvalues, and eigenfunctions at any n points.
    times : array_like, (N,)
        In units of area, above 0.

    Returns
    -------
    numpy.ndarray, (N,)
        The sums, without unit.

    Raises
    ------
    InputError
        The spectrum is none, or has no eigenvalue above 0.

    Examples
    --------
    >>> import restricted_laplacian as rl
    >>> s = rl.laplace_spectrum(*rl.icosphere(3), 20, depth=4)
    >>> bool(19 < rl.heat_trace(s, [1e-4])[0] < 20)
    True
    """
    return _core.heat_trace(_pairs(spectrum)[0], numbers(times, "times", np.float64).ravel())


def heat_kernel_signature(spectrum: _Pairs, times: Any = None, *, number: int = 100,
                          scaled: bool = False) -> np.ndarray:
    """The heat kernel signature of Sun, Ovsjanikov and Guibas (2009).

    Parameters
    ----------
    spectrum : Spectrum, or (array_like (k,), array_like (n, k))
        Or eigenvalues, and eigenfunctions at any n points.
    times : array_like, (N,), optional
        In units of area; `heat_kernel_times` by default.
    number : int, default 100
        How many of these.
    scaled : bool, default False
        Whether to divide by the heat trace.

    Returns
    -------
    numpy.ndarray, (n, N)
        Of each vertex a row, in units of 1 / area, or without unit if `scaled`.

    Raises
    ------
    InputError
        The spectrum is none, or has no eigenvalue above 0.

    Examples
    --------
    >>> import restricted_laplacian as rl
    >>> V, F = rl.icosphere(3)
    >>> s = rl.laplace_spectrum(V, F, 20, depth=4)
    >>> rl.heat_kernel_signature(s, number=10).shape
    (642, 10)
    """
    l, u = _pairs(spectrum)
    if times is None:
        times = _core.heat_kernel_times(l, int(number))
    return _core.heat_kernel_signature(l, u, numbers(times, "times", np.float64).ravel(),
                                       bool(scaled))


def wave_kernel_signature(spectrum: _Pairs, energies: Any = None, *, sigma: Optional[float] = None,
                          number: int = 100) -> np.ndarray:
    """The wave kernel signature of Aubry, Schlickewei and Cremers (2011).

    Parameters
    ----------
    spectrum : Spectrum, or (array_like (k,), array_like (n, k))
        Or eigenvalues, and eigenfunctions at any n points.
    energies : array_like, (N,), optional
        Logarithms of eigenvalues; evenly over their range by default.
    sigma : float, optional
        Width of the filters; by default seven times the distance of the default energies.
    number : int, default 100
        How many energies.

    Returns
    -------
    numpy.ndarray, (n, N)
        Of each vertex a row, in units of 1 / area.

    Raises
    ------
    InputError
        The spectrum is none, or has no eigenvalue above 0.

    Examples
    --------
    >>> import restricted_laplacian as rl
    >>> s = rl.laplace_spectrum(*rl.icosphere(3), 20, depth=4)
    >>> rl.wave_kernel_signature(s, number=10).shape
    (642, 10)
    """
    l, u = _pairs(spectrum)
    default_energies, default_sigma = _core.wave_kernel_energies(l, int(number))
    own = default_energies if energies is None else numbers(
        energies, "energies", np.float64).ravel()
    return _core.wave_kernel_signature(l, u, own,
                                       float(default_sigma if sigma is None else sigma))


def global_point_signature(spectrum: _Pairs) -> np.ndarray:
    """Eigenfunctions over square roots of eigenvalues (Rustamov 2007), without those of 0.

    Parameters
    ----------
    spectrum : Spectrum, or (array_like (k,), array_like (n, k))
        Or eigenvalues, and eigenfunctions at any n points.

    Returns
    -------
    numpy.ndarray, (n, k - number of zeros)
        Of each vertex a row, without unit.

    Raises
    ------
    InputError
        The spectrum is none, or has no eigenvalue above 0.

    Examples
    --------
    >>> import restricted_laplacian as rl
    >>> s = rl.laplace_spectrum(*rl.icosphere(3), 20, depth=4)
    >>> rl.global_point_signature(s).shape
    (642, 19)
    """
    return _core.global_point_signature(*_pairs(spectrum))


def biharmonic_embedding(spectrum: _Pairs) -> np.ndarray:
    """Coordinates of which the biharmonic distance is the usual one (Lipman and others 2010).

    Parameters
    ----------
    spectrum : Spectrum, or (array_like (k,), array_like (n, k))
        Or eigenvalues, and eigenfunctions at any n points.

    Returns
    -------
    numpy.ndarray, (n, k - number of zeros)
        Of each vertex a row, in units of length.

    Raises
    ------
    InputError
        The spectrum is none, or has no eigenvalue above 0.

    Examples
    --------
    >>> import restricted_laplacian as rl
    >>> s = rl.laplace_spectrum(*rl.icosphere(3), 20, depth=4)
    >>> rl.biharmonic_embedding(s).shape
    (642, 19)
    """
    return _core.biharmonic_embedding(*_pairs(spectrum))


def diffusion_map(spectrum: _Pairs, time: float) -> np.ndarray:
    """Coordinates for the diffusion distance at a time (Coifman and Lafon 2006).

    Parameters
    ----------
    spectrum : Spectrum, or (array_like (k,), array_like (n, k))
        Or eigenvalues, and eigenfunctions at any n points.
    time : float
        In units of area.

    Returns
    -------
    numpy.ndarray, (n, k)
        Of each vertex a row, in units of 1 / length.

    Raises
    ------
    InputError
        The spectrum is none, or has no eigenvalue above 0.

    Examples
    --------
    >>> import restricted_laplacian as rl
    >>> s = rl.laplace_spectrum(*rl.icosphere(3), 20, depth=4)
    >>> rl.diffusion_map(s, 0.1).shape
    (642, 20)
    """
    return _core.diffusion_map(*_pairs(spectrum), float(time))


def shape_dna(spectrum: Spectrum, normalization: str = "area") -> np.ndarray:
    """Eigenvalues in a form that does not depend on size (Reuter and others 2006).

    Parameters
    ----------
    spectrum : Spectrum
        Of the shape.
    normalization : {"area", "first", "weyl", "none"}
        Times area, the default; over the first that is not 0; over the slope of a fitted line; as they are.

    Returns
    -------
    numpy.ndarray, (k,)
        Without unit, unless the normalization is none.

    Raises
    ------
    InputError
        There is no such normalization, or no eigenvalue above 0.

    Examples
    --------
    >>> import restricted_laplacian as rl
    >>> s = rl.laplace_spectrum(*rl.icosphere(3), 20, depth=4)
    >>> rl.shape_dna(s, "first")[:5].round(1) + 0.
    array([0., 1., 1., 1., 3.])
    """
    if normalization not in ("area", "first", "weyl", "none"):
        raise argument_error("normalization", f"must be area, first, weyl or none, and is "
                             f"{normalization!r}")
    return _core.shape_dna(_pairs(spectrum)[0], spectrum.area, normalization)

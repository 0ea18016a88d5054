# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Eigenvalues, eigenfunctions, and descriptors that are made of them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Optional, Union

import numpy as np

from . import _core
from ._errors import argument_error
from ._input import Progress, listener, number_of_threads, numbers
from ._space import Report, SplineFunction, Space, checked, solver_options, space_of
from ._view import View, Viewable


@dataclass(frozen=True)
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
    space : Space
    report : Report
    """

    eigenvalues: np.ndarray
    vertex_values: np.ndarray
    coefficients: np.ndarray
    area: float
    space: Space
    report: Report

    def functions(self) -> SplineFunction:
        """The eigenfunctions, to be evaluated anywhere."""
        return self.space.function(self.coefficients)

    def view(self, *, refine: int = 0, **options: Any) -> View:
        """A `View` of the eigenfunctions, see `SplineFunction.view`."""
        names = [f"eigenfunction {i}, eigenvalue {x:.6g}" for i, x in enumerate(self.eigenvalues)]
        return self.functions().view(refine=refine, names=names,
                                     **{"title": "Eigenfunctions",
                                        "first": min(1, len(names) - 1), **options})


def laplace_spectrum(V: Any, F: Any = None, k: int = 50, *, eigensolver: str = "auto",
                     eigenvalues_only: bool = False, tolerance: Optional[float] = None,
                     max_iterations: Optional[int] = None,
                     stabilization: Optional[float] = None, normals: Any = None,
                     depth: Optional[int] = None, joining_tolerance: Optional[float] = None,
                     geometry: Any = None, threads: Optional[int] = None, progress: Progress = None,
                     check: bool = True) -> Spectrum:
    """The k smallest eigenvalues of minus the Laplacian, and eigenfunctions.

    Parameters
    ----------
    k : int
        Number of eigenvalues, with multiplicities and zeros.
    eigensolver : {"auto", "multigrid", "shift-invert"}
        The faster one by default; if multigrid stalls, a factorization (shift-invert) where memory
        allows. ``report.eigensolver`` says which one it was.
    eigenvalues_only : bool
        Whether eigenfunctions are of no use: they are not evaluated at the vertices, and the
        iteration ends earlier.
    tolerance : float, optional
        Residual, 1e-3 by default, or 2.5e-3 with `eigenvalues_only`; errors of eigenvalues are
        about its square.
    max_iterations : int, optional
        Of multigrid, on each level; 100 by default.
    stabilization : float, optional
        1e-5 by default.
    V, F, normals, depth, joining_tolerance, geometry
        The surface, see `Space`.
    threads, progress, check
        See `solve_poisson`.

    Returns
    -------
    Spectrum
    """
    if eigensolver not in ("auto", "multigrid", "shift-invert"):
        raise argument_error("eigensolver", f"must be auto, multigrid or shift-invert, and is "
                             f"{eigensolver!r}")
    if isinstance(k, bool) or not isinstance(k, (int, np.integer)):
        raise argument_error("k", f"must be a whole number, and is {k!r}")
    space = space_of(V, F, threads, normals=normals, depth=depth,
                     joining_tolerance=joining_tolerance, geometry=geometry)
    values, at_vertices, vectors, area, report = _core.eigenpairs(
        space._space, int(k), eigensolver, True, bool(eigenvalues_only),
        solver_options(tolerance, None, stabilization, max_iterations=max_iterations),
        number_of_threads(threads), listener(progress))
    spectrum = Spectrum(values, at_vertices, vectors, area, space, Report(report))
    advice = {"multigrid": '; eigensolver="shift-invert" may find all of them, or a larger '
                           "tolerance or max_iterations",
              "shift-invert": "; a smaller k, or another depth, may help"}
    return checked(spectrum, report, check, False, advice[report["eigensolver"]])


def eigs(V: Any, F: Any = None, k: int = 50, *, eigensolver: str = "auto",
         tolerance: Optional[float] = None, max_iterations: Optional[int] = None,
         stabilization: Optional[float] = None, normals: Any = None, depth: Optional[int] = None,
         joining_tolerance: Optional[float] = None, geometry: Any = None,
         threads: Optional[int] = None, progress: Progress = None,
         check: bool = True) -> tuple[np.ndarray, np.ndarray]:
    """The k smallest eigenvalues of minus the Laplacian, and eigenfunctions at the vertices.

    Parameters
    ----------
    V, F, k, eigensolver, tolerance, max_iterations, stabilization, normals, depth, \
joining_tolerance, geometry
        See `laplace_spectrum`.
    threads, progress, check
        See `solve_poisson`.

    Returns
    -------
    eigenvalues : numpy.ndarray, (k,)
    eigenfunctions : numpy.ndarray, (n, k)
        The integral of the square of each is 1.

    Examples
    --------
    >>> import restricted_laplacian as rl
    >>> V, F = rl.icosphere(4)
    >>> l, u = rl.eigs(V, F, 9)
    >>> l.round(1) + 0.
    array([0., 2., 2., 2., 6., 6., 6., 6., 6.])
    """
    s = laplace_spectrum(V, F, k, eigensolver=eigensolver, tolerance=tolerance,
                         max_iterations=max_iterations, stabilization=stabilization, normals=normals, depth=depth,
                         joining_tolerance=joining_tolerance, geometry=geometry, threads=threads,
                         progress=progress, check=check)
    return s.eigenvalues, s.vertex_values


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
    spectrum : Spectrum, or array_like
        Of eigenvalues; if all of them are 0, there is no scale to see that by, but the area of the
        surface, which a `Spectrum` knows.
    """
    own = spectrum.eigenvalues if isinstance(spectrum, Spectrum) else spectrum
    own = numbers(own, "eigenvalues", np.float64).ravel()
    if isinstance(spectrum, Spectrum):
        own = _core.with_exact_zeros(own, spectrum.area)
    return _core.number_of_zeros(own)


def heat_kernel_times(spectrum: _Pairs, number: int = 100) -> np.ndarray:
    """Times at which a heat kernel signature is taken: evenly on a logarithmic scale."""
    return _core.heat_kernel_times(_pairs(spectrum)[0], int(number))


def heat_trace(spectrum: _Pairs, times: Any) -> np.ndarray:
    """The sum of exp(-l t) over the eigenvalues, for each time."""
    return _core.heat_trace(_pairs(spectrum)[0], numbers(times, "times", np.float64).ravel())


def heat_kernel_signature(spectrum: _Pairs, times: Any = None, *, number: int = 100,
                          scaled: bool = False) -> np.ndarray:
    """The heat kernel signature of Sun, Ovsjanikov and Guibas (2009).

    Parameters
    ----------
    spectrum : Spectrum, or (eigenvalues, eigenfunctions)
    times : array_like, optional
        In units of area; `heat_kernel_times` by default.
    number : int
        How many of these.
    scaled : bool
        Whether to divide by the heat trace.

    Returns
    -------
    numpy.ndarray, (n, number of times)

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
    spectrum : Spectrum, or (eigenvalues, eigenfunctions)
    energies : array_like, optional
        Logarithms of eigenvalues; evenly over their range by default.
    sigma : float, optional
        Width of the filters; seven times the distance of the default energies.
    number : int
        How many energies.
    """
    l, u = _pairs(spectrum)
    default_energies, default_sigma = _core.wave_kernel_energies(l, int(number))
    own = default_energies if energies is None else numbers(
        energies, "energies", np.float64).ravel()
    return _core.wave_kernel_signature(l, u, own,
                                       float(default_sigma if sigma is None else sigma))


def global_point_signature(spectrum: _Pairs) -> np.ndarray:
    """Eigenfunctions over square roots of eigenvalues (Rustamov 2007), without those of 0."""
    return _core.global_point_signature(*_pairs(spectrum))


def biharmonic_embedding(spectrum: _Pairs) -> np.ndarray:
    """Coordinates of which the biharmonic distance is the usual one (Lipman and others 2010)."""
    return _core.biharmonic_embedding(*_pairs(spectrum))


def diffusion_map(spectrum: _Pairs, time: float) -> np.ndarray:
    """Coordinates for the diffusion distance at a time (Coifman and Lafon 2006)."""
    return _core.diffusion_map(*_pairs(spectrum), float(time))


def shape_dna(spectrum: Spectrum, normalization: str = "area") -> np.ndarray:
    """Eigenvalues in a form that does not depend on size (Reuter and others 2006).

    Parameters
    ----------
    spectrum : Spectrum
    normalization : {"area", "first", "weyl", "none"}
        Times area; over the first that is not 0; over the slope of a fitted line; as they are.
    """
    if normalization not in ("area", "first", "weyl", "none"):
        raise argument_error("normalization", f"must be area, first, weyl or none, and is "
                             f"{normalization!r}")
    return _core.shape_dna(_pairs(spectrum)[0], spectrum.area, normalization)

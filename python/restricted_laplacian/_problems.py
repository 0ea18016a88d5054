# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Poisson problems, fits, curvature, gradient fields: one call each.

All functions take the surface as `V` and `F`, as `Space` does (a mesh object, or points with
``normals=`` and None for `F`), or a `Space` as `V` and None for `F`. They share these arguments:

depth, joining_tolerance, geometry, vertex_data, diffusion, anisotropy, density : of `Space`.
threads : int, optional
    All processors by default. Results do not depend on it.
progress : bool or callable
    True shows a bar on the error stream. A callable is called with the part that is done, from 0 to
    1; if it returns False, the computation ends with `Canceled`.
check : bool
    Whether a solver that does not converge raises `ConvergenceError`.
return_report : bool
    Whether to return a `Report`, too.
"""

from __future__ import annotations

from typing import Any, NamedTuple, Optional

import numpy as np

from . import _core
from ._errors import argument_error
from ._input import Progress, listener, number_of_threads, numbers, takes_surface, vertex_numbers
from ._show import shown
from ._space import PoissonSolver, SplineFunction, checked, solver_options, space_of


def _constraints(constraints: Any, number_of_vertices: int) -> Optional[np.ndarray]:
    """Vertices and values, alternating."""
    if constraints is None:
        return None
    if hasattr(constraints, "items"):  # a mapping, or a series of pandas
        pairs = list(constraints.items())
        constraints = [vertex for vertex, _ in pairs], [value for _, value in pairs]
    elif not isinstance(constraints, (tuple, list, np.ndarray)) or len(constraints) != 2:
        raise argument_error("constraints", "must be a mapping {vertex: value}, or a pair: vertices, and "
                             "values")
    elif all(hasattr(x, "__len__") and len(x) == 2 for x in constraints) and not (
            isinstance(constraints, tuple) and all(isinstance(x, (list, np.ndarray)) for x in constraints)):
        raise argument_error("constraints", "may be two pairs, or vertices and values: give a mapping "
                             "{vertex: value}")
    vertices = vertex_numbers(constraints[0], "constraints", number_of_vertices).astype(np.float64)
    given = numbers(constraints[1], "constraints", np.float64)
    if given.ndim > 1 or given.ndim == 1 and given.shape != vertices.shape:
        raise argument_error("constraints", f"has {len(vertices)} vertices, and values of the shape "
                             f"{given.shape}")
    values = np.broadcast_to(given, vertices.shape)
    return np.ascontiguousarray(np.stack([vertices, values], axis=1).ravel())


def _solve(V: Any, F: Any, f: Any, alpha: Any, boundary_values: Any, boundary_flux: Any,
           constraints: Any, constraint_weight: Optional[float], accuracy: Optional[float], options: dict,
           space_options: dict, threads: Optional[int], progress: Progress, check: bool,
           return_report: bool, as_spline: bool) -> Any:
    space = space_of(V, F, threads, accuracy, **space_options)
    right = space._function(f, "f")
    weight, weight_function = 0.0, None
    if np.ndim(alpha) == 0 and not callable(alpha):
        weight = float(alpha)
    else:
        weight_function = space._function(alpha, "alpha")
    boundary, flux = (None if g is None else space._function(g, name, everywhere=False) for g, name in
                      ((boundary_values, "boundary_values"), (boundary_flux, "boundary_flux")))
    constrained = _constraints(constraints, space.number_of_vertices)
    if right.components > 1 and (boundary is not None or constrained is not None):
        raise argument_error("f", "has several columns, which is possible only where no values are prescribed")
    last, x, report = _core.solve_poisson(
        space._space, right, weight, weight_function, boundary, flux, constrained, constraint_weight,
        accuracy, options, number_of_threads(threads), listener(progress))
    if right.components == 1 and (callable(f) or np.ndim(f) < 2):
        x = x[:, 0]
    u = SplineFunction(space._with(last), x)
    return checked(u if as_spline else u.at_vertices(), report, check, return_report)


@takes_surface
def solve_poisson(V: Any, F: Any = None, f: Any = None, *, boundary_values: Any = None,
                  boundary_flux: Any = None, constraints: Any = None,
                  constraint_weight: Optional[float] = None, accuracy: Optional[float] = None,
                  tolerance: Optional[float] = None, energy_tolerance: Optional[float] = None, stabilization: Optional[float] = None,
                  cycle: str = "v", smoother: str = "patch", maximum_iterations: Optional[int] = None,
                  normals: Any = None, depth: Optional[int] = None,
                  joining_tolerance: Optional[float] = None, geometry: Any = None,
                  diffusion: Any = None, anisotropy: Any = None, density: Any = None,
                  vertex_data: Optional[str] = None, threads: Optional[int] = None,
                  progress: Progress = None, check: bool = True, return_report: bool = False,
                  as_spline: bool = False) -> Any:
    """Solve Laplacian u = f. The Laplacian is negative: on the unit sphere f = z gives u = -z / 2.

    With a diffusion D and a density rho it is div(D grad u) = rho f.

    On each component of the surface without prescribed values u has mean 0, and f is changed by the
    number with which there is a solution: without fluxes, its mean is subtracted. Boundaries have
    the natural condition, u does not change across them, unless something else is prescribed.

    Parameters
    ----------
    V, F, normals, depth, joining_tolerance, geometry, vertex_data, diffusion, anisotropy, density : as for Space
        The surface: points (n, 3) and triangles (m, 3); or a pair of them, a mesh of another library, or a
        `Space` as `V` alone.
    f : array_like or callable
        (n,) at vertices, (m,) on faces, a number, `Corners`, or a callable on points (N, 3). (n, K)
        gives K solutions, where no values are prescribed.
    boundary_values : array_like, callable or float, optional
        What u is on the boundary, given as f is; NaN where u is free. For each edge of the boundary
        its middle decides, so at vertices both ends need a value.
    boundary_flux : array_like, callable or float, optional
        How fast u changes across the boundary, outward, where `boundary_values` are free or not
        given.
    constraints : mapping, or (array_like, array_like), optional
        What u is at vertices, as ``{vertex: value}``; or vertices, or a mask (n,) of them, and values.
        Without `boundary_values` it holds along each edge of the
        boundary, too, both ends of which have a value, linear between them.
    constraint_weight : float, optional
        Values at vertices only pull: u minimizes the energy plus the weight times the squares of
        what is missed. By default they are met exactly.
    accuracy : float, optional
        Deeper and deeper spaces are tried until the estimated error of u, relative to its deviation from its
        mean in the root mean square, is not larger. `depth` says where that begins then, at 4 by default.
    tolerance : float, optional
        Residual over right-hand side: 1e-3, or 1e-8 with prescribed values.
    energy_tolerance, stabilization, cycle, smoother, maximum_iterations : as for PoissonSolver
        When the iteration ends, and what it is.
    threads : int, optional
        All processors by default. Results do not depend on it.
    progress : bool or callable, optional
        True shows a bar on the error stream. A callable is called with the part that is done, from 0 to
        1; if it returns False, the computation ends with `Canceled`.
    check : bool, default True
        Whether a solver that does not converge raises `ConvergenceError`.
    return_report : bool, default False
        Whether to return a `Report`, too.
    as_spline : bool, default False
        Whether to return a `SplineFunction` in place of values at vertices.

    Returns
    -------
    u : numpy.ndarray
        Values at the vertices, (n,) or (n, K), in units of f times area; NaN where no face has an area.
    report : Report
        If `return_report`.

    Raises
    ------
    InputError
        A `ValueError` that names the face, the vertex or the argument.
    ConvergenceError
        A `RuntimeError`, with what was found.
    Canceled
        A callback of `progress` returned False.

    Examples
    --------
    >>> import restricted_laplacian as rl
    >>> V, F = rl.icosphere(4)
    >>> u = rl.solve_poisson(V, F, V[:, 2])
    >>> bool(abs(u + V[:, 2] / 2).max() < 5e-3)
    True
    >>> u = rl.solve_poisson(V, F, lambda p: p[:, 0] * p[:, 1])
    >>> bool(abs(u + V[:, 0] * V[:, 1] / 6).max() < 2e-3)
    True
    """
    options = solver_options(tolerance, energy_tolerance, stabilization, cycle, smoother,
                             maximum_iterations)
    return _solve(V, F, f, 0, boundary_values, boundary_flux, constraints, constraint_weight,
                  accuracy, options,
                  dict(normals=normals, depth=depth, joining_tolerance=joining_tolerance,
                       geometry=geometry, vertex_data=vertex_data, diffusion=diffusion, anisotropy=anisotropy,
                       density=density),
                  threads, progress, check, return_report, as_spline)


@takes_surface
def solve_screened_poisson(V: Any, F: Any = None, f: Any = None, alpha: Any = None, *, boundary_values: Any = None,
                           boundary_flux: Any = None, constraints: Any = None,
                           constraint_weight: Optional[float] = None,
                           accuracy: Optional[float] = None, tolerance: Optional[float] = None,
                           energy_tolerance: Optional[float] = None,
                           stabilization: Optional[float] = None, cycle: str = "v",
                           smoother: str = "patch", maximum_iterations: Optional[int] = None,
                           normals: Any = None, depth: Optional[int] = None,
                           joining_tolerance: Optional[float] = None, geometry: Any = None,
                           diffusion: Any = None, anisotropy: Any = None, density: Any = None,
                           vertex_data: Optional[str] = None, threads: Optional[int] = None,
                           progress: Progress = None, check: bool = True,
                           return_report: bool = False, as_spline: bool = False) -> Any:
    """Solve alpha u - Laplacian u = f. Note the sign of f, which is not that of `solve_poisson`.

    With a diffusion D and a density rho it is alpha rho u - div(D grad u) = rho f.

    Parameters
    ----------
    V, F, normals, depth, joining_tolerance, geometry, vertex_data, diffusion, anisotropy, density : as for Space
        The surface: points (n, 3) and triangles (m, 3); or a pair of them, a mesh of another library, or a
        `Space` as `V` alone.
    f : array_like or callable
        As for `solve_poisson`.
    alpha : float, array_like or callable
        A positive number in units of 1 / area; or weights that are not negative, given as f is.
    boundary_values, boundary_flux, constraints, constraint_weight : as for solve_poisson
        What is prescribed.
    accuracy : as for solve_poisson
        The estimated error to be reached.
    tolerance, energy_tolerance, stabilization, cycle, smoother, maximum_iterations : as for PoissonSolver
        When the iteration ends, and what it is.
    threads, progress, check, return_report, as_spline : as for solve_poisson
        How the work is done, and what is returned.

    Returns
    -------
    u : numpy.ndarray
        Values at the vertices, (n,) or (n, K), in units of f times area; NaN where no face has an area.
    report : Report
        If `return_report`.

    Raises
    ------
    InputError
        A `ValueError` that names the face, the vertex or the argument.
    ConvergenceError
        A `RuntimeError`, with what was found.
    Canceled
        A callback of `progress` returned False.

    Examples
    --------
    >>> import restricted_laplacian as rl
    >>> V, F = rl.icosphere(4)
    >>> u = rl.solve_screened_poisson(V, F, V[:, 2], 3.0)  # (3 + 2) u = z
    >>> bool(abs(u - V[:, 2] / 5).max() < 2e-3)
    True
    """
    if alpha is None:
        raise argument_error("alpha", "is missing")
    if np.ndim(alpha) == 0 and not callable(alpha) and not float(alpha) > 0:
        raise argument_error("alpha", f"must be positive, and is {alpha}")
    options = solver_options(tolerance, energy_tolerance, stabilization, cycle, smoother,
                             maximum_iterations)
    return _solve(V, F, f, alpha, boundary_values, boundary_flux, constraints, constraint_weight,
                  accuracy, options,
                  dict(normals=normals, depth=depth, joining_tolerance=joining_tolerance,
                       geometry=geometry, vertex_data=vertex_data, diffusion=diffusion, anisotropy=anisotropy,
                       density=density),
                  threads, progress, check, return_report, as_spline)


def _time(time: Optional[float], fwhm: Optional[float]) -> float:
    if (time is None) == (fwhm is None):
        raise argument_error("time", "or fwhm has to be given, and not both")
    if time is not None:
        return float(time)
    if not float(fwhm) > 0:  # type: ignore[arg-type]
        raise argument_error("fwhm", f"must be positive, and is {fwhm!r}")
    return float(fwhm) ** 2 / (16 * np.log(2))  # type: ignore[arg-type]


@takes_surface
def diffuse(V: Any, F: Any = None, u0: Any = None, time: Optional[float] = None, *, fwhm: Optional[float] = None,
            source_term: Any = None, boundary_values: Any = None, accuracy: Optional[float] = None,
            tolerance: Optional[float] = None, stabilization: Optional[float] = None,
            maximum_iterations: Optional[int] = None, normals: Any = None, depth: Optional[int] = None,
            joining_tolerance: Optional[float] = None, geometry: Any = None, vertex_data: Optional[str] = None,
            diffusion: Any = None, anisotropy: Any = None, density: Any = None, threads: Optional[int] = None,
            progress: Progress = None, check: bool = True, return_report: bool = False,
            as_spline: bool = False) -> Any:
    """Diffusion in time: what functions become, du/dt = Laplacian u + source_term.

    With a diffusion D and a density rho it is rho du/dt = div(D grad u) + rho source_term. There are no steps in
    time: n digits of a function take 5 + 3 n linear systems or fewer, with one setup. The mean over each
    connected component is kept, unless values are prescribed.

    Parameters
    ----------
    V, F, normals, depth, joining_tolerance, geometry, vertex_data, diffusion, anisotropy, density : as for Space
        The surface: points (n, 3) and triangles (m, 3); or a pair of them, a mesh of another library, or a
        `Space` as `V` alone.
    u0 : array_like or callable
        At the time 0: (n,) or (n, K) at vertices; (m,) or (m, K) on faces; `Corners`; or a callable on points.
    time : float
        In units of squared length.
    fwhm : float, optional
        In place of the time a width: that at half of the maximum of what a point becomes, time = fwhm^2 / (16
        log 2), in units of length.
    source_term : array_like, callable or float, optional
        What is supplied, given as u0 is.
    boundary_values : array_like, callable or float, optional
        What u is along the boundary; by default nothing flows through it.
    accuracy : float, optional
        Deeper and deeper spaces are tried until the estimated error of u, relative to its deviation from its
        mean in the root mean square, is not larger. `depth` says where that begins then, at 4 by default.
    tolerance : float, optional
        Of what the Krylov space leaves, relative to the deviation from the mean: 1e-4 by default.
    stabilization : float, optional
        1e-3 by default.
    maximum_iterations : int, optional
        Largest number of linear systems for each function, 100 by default.
    threads, progress, check, return_report, as_spline : as for solve_poisson
        How the work is done, and what is returned.

    Returns
    -------
    u : numpy.ndarray
        Values at the vertices, (n,) or (n, K), in units of u0; NaN where no face has an area.
    report : Report
        If `return_report`.

    Raises
    ------
    InputError
        A `ValueError` that names the face, the vertex or the argument.
    ConvergenceError
        A `RuntimeError`, with what was found.
    Canceled
        A callback of `progress` returned False.

    See Also
    --------
    smooth : For data with holes.

    Examples
    --------
    >>> import numpy as np, restricted_laplacian as rl
    >>> V, F = rl.icosphere(4)
    >>> u = rl.diffuse(V, F, V[:, 2], 0.5)
    >>> bool(abs(u - np.exp(-1) * V[:, 2]).max() < 3e-3)
    True
    """
    own_time = _time(time, fwhm)
    space = space_of(V, F, threads, accuracy, normals=normals, depth=depth, joining_tolerance=joining_tolerance,
                     geometry=geometry, vertex_data=vertex_data, diffusion=diffusion, anisotropy=anisotropy,
                     density=density)
    initial = space._function(u0, "u0")
    supply, boundary = (None if g is None else space._function(g, name) for g, name in
                        ((source_term, "source_term"), (boundary_values, "boundary_values")))
    last, x, report = _core.diffuse(
        space._space, own_time, initial, supply, boundary, accuracy,
        solver_options(tolerance, None, stabilization, maximum_iterations=maximum_iterations),
        number_of_threads(threads), listener(progress))
    if initial.components == 1 and (callable(u0) or np.ndim(u0) < 2):
        x = x[:, 0]
    u = SplineFunction(space._with(last), x)
    return checked(u if as_spline else u.at_vertices(), report, check, return_report)


@takes_surface
def smooth(V: Any, F: Any = None, data: Any = None, fwhm: Optional[float] = None, *, mask: Any = None,
           **options: Any) -> Any:
    """Smooth data at the vertices by a width on the surface, whatever the triangles are.

    Each value becomes the mean of those around it with the weights that diffusion gives them: a Gaussian, where
    the surface is flat. Vertices that are NaN or outside of the mask have no weight, and are NaN in the result.

    Parameters
    ----------
    V, F : as for Space
        The surface.
    data : array_like
        (n,) or (n, K) at the vertices.
    fwhm : float
        Full width of the weights at half of their maximum, in units of length: millimeters on a cortex.
    mask : array_like of bool, (n,), optional
        Which vertices count.
    **options : as for diffuse
        How it is done.

    Returns
    -------
    numpy.ndarray
        (n,) or (n, K), in units of the data.

    Raises
    ------
    InputError
        A `ValueError` that names the argument.

    Examples
    --------
    >>> import numpy as np, restricted_laplacian as rl
    >>> V, F = rl.icosphere(4)
    >>> data = V[:, 2].copy()
    >>> data[:10] = np.nan
    >>> u = rl.smooth(V, F, data, fwhm=0.2)
    >>> int(np.isnan(u).sum()), bool(np.nanmax(abs(u - V[:, 2])) < 0.03)
    (10, True)
    """
    if fwhm is None:
        raise argument_error("fwhm", "is missing")
    if options.get("return_report") or options.get("as_spline"):
        raise argument_error("return_report", "and as_spline are for diffuse")
    values = numbers(data, "data", np.float64)
    if values.ndim not in (1, 2):
        raise argument_error("data", f"has {values.ndim} dimensions")
    table = values.reshape(len(values), -1)
    counts = ~np.isnan(table)
    if mask is not None:
        inside = np.asarray(mask)
        if inside.dtype != bool or inside.shape != (len(table),):
            raise argument_error("mask", f"must be ({len(table)},) of bool, and is {inside.shape} of {inside.dtype}")
        counts &= inside[:, np.newaxis]
    if counts.all():
        return diffuse(V, F, values, fwhm=fwhm, **options)
    patterns, column = np.unique(counts, axis=1, return_inverse=True)
    both = np.concatenate([np.where(counts, table, 0.0), patterns.astype(float)], axis=1)
    result = diffuse(V, F, both, fwhm=fwhm, **options)
    weights = result[:, table.shape[1]:][:, column.ravel()]
    # where hardly anything is near, there is nothing to say
    has_value = counts & (weights > 1e-3)
    u = np.where(has_value, result[:, :table.shape[1]] / np.where(has_value, weights, 1.0), np.nan)
    return u.reshape(values.shape)


@takes_surface
def fit_function(V: Any, F: Any = None, f: Any = None, *, smoothing: float = 0, refinements: int = 0,
                 accuracy: Optional[float] = None, tolerance: Optional[float] = None, energy_tolerance: Optional[float] = None,
                 stabilization: Optional[float] = None, maximum_iterations: Optional[int] = None,
                 normals: Any = None, depth: Optional[int] = None,
                 joining_tolerance: Optional[float] = None, geometry: Any = None,
                 diffusion: Any = None, anisotropy: Any = None, density: Any = None,
                 vertex_data: Optional[str] = None, threads: Optional[int] = None,
                 progress: Progress = None, check: bool = True, return_report: bool = False,
                 as_spline: bool = False) -> Any:
    """Fit a function by splines: that for which the integral of the squared difference is least.

    Parameters
    ----------
    V, F, normals, depth, joining_tolerance, geometry, vertex_data, diffusion, anisotropy, density : as for Space
        The surface: points (n, 3) and triangles (m, 3); or a pair of them, a mesh of another library, or a
        `Space` as `V` alone.
    f : array_like or callable
        (n,) or (n, K) at vertices; (m,) or (m, K) on faces; `Corners`; or a callable on points.
    smoothing : float, default 0
        Weight of the squared gradient, in units of squared length.
    refinements : int, default 0
        How often what the fit leaves is fitted and added.
    accuracy : float, optional
        Deeper and deeper spaces are tried until the root mean square error of the fit, relative to the
        deviation of f from its mean, is not larger; with smoothing, the estimated one. `depth` says where that
        begins then, at 4 by default.
    tolerance, energy_tolerance, stabilization, maximum_iterations : as for PoissonSolver
        When the iteration ends, and how much is stabilized; by default what does not show.
    threads, progress, check, return_report, as_spline : as for solve_poisson
        How the work is done, and what is returned. The report has ``root_mean_square_errors``.

    Returns
    -------
    u : numpy.ndarray
        Values of the fit at the vertices, (n,) or (n, K), in units of f.
    report : Report
        If `return_report`.

    Raises
    ------
    InputError
        A `ValueError` that names the face, the vertex or the argument.
    ConvergenceError
        A `RuntimeError`, with what was found.
    Canceled
        A callback of `progress` returned False.

    Examples
    --------
    >>> import restricted_laplacian as rl
    >>> V, F = rl.icosphere(4)
    >>> x = rl.fit_function(V, F, V)
    >>> bool(abs(x - V).max() < 5e-3)
    True
    """
    space = space_of(V, F, threads, accuracy, normals=normals, depth=depth,
                     joining_tolerance=joining_tolerance, geometry=geometry, diffusion=diffusion,
                     anisotropy=anisotropy, density=density,
                     vertex_data=vertex_data)
    own = space._function(f, "f")
    options = solver_options(tolerance, energy_tolerance, stabilization,
                             maximum_iterations=maximum_iterations, smoothing=smoothing,
                             refinements=refinements)
    last, x, report = _core.fit_function(space._space, own, accuracy, options, number_of_threads(threads),
                                         listener(progress))
    if x.shape[1] == 1 and (callable(f) or np.ndim(f) < 2):
        x = x[:, 0]
    u = SplineFunction(space._with(last), x)
    return checked(u if as_spline else u.at_vertices(), report, check, return_report)


@shown()
class Curvature(NamedTuple):
    """Curvature at vertices; that of a sphere whose normals point outward is positive.

    Attributes
    ----------
    mean : numpy.ndarray, (n,)
        In units of 1 / length.
    gaussian : numpy.ndarray, (n,)
        In units of 1 / area.
    principal_values : numpy.ndarray, (n, 2)
        The larger one first, in units of 1 / length.
    principal_directions : numpy.ndarray, (n, 2, 3)
        Unit vectors with either sign.
    normals : numpy.ndarray, (n, 3)
        Fitted.
    """

    mean: np.ndarray
    gaussian: np.ndarray
    principal_values: np.ndarray
    principal_directions: np.ndarray
    normals: np.ndarray


@takes_surface
def curvature(V: Any, F: Any = None, *, method: str = "normals", smoothing: Optional[float] = None,
              refinements: Optional[int] = None, accuracy: Optional[float] = None,
              tolerance: Optional[float] = None, energy_tolerance: Optional[float] = None, stabilization: Optional[float] = None,
              maximum_iterations: Optional[int] = None, normals: Any = None,
              depth: Optional[int] = None, joining_tolerance: Optional[float] = None,
              geometry: Any = None, threads: Optional[int] = None, progress: Progress = None,
              check: bool = True, return_report: bool = False) -> Any:
    """Mean, Gaussian and principal curvature at the vertices.

    Parameters
    ----------
    V, F, normals, depth, joining_tolerance, geometry : as for Space
        The surface: points (n, 3) and triangles (m, 3); or a pair of them, a mesh of another library, or a
        `Space` as `V` alone. Its faces must be oriented alike.
    method : {"normals", "face_normals", "coordinates"}
        The derivative of fitted vertex normals; of face normals; or the Laplacian of the
        coordinates, which gives the mean curvature only.
    smoothing : float, optional
        Weight of the squared gradient of the normals, in units of squared length; by default the
        squared width of a cell, and 0 on surfaces with a boundary and on points.
    refinements : int, optional
        How often what the smoothed fit leaves is fitted and added; by default once.
    accuracy : float, optional
        Deeper and deeper spaces are tried until the estimated error of the mean curvature, relative to its
        deviation from its mean in the root mean square, is not larger. `depth` says where that begins then, at
        4 by default. The curvature of edges and of noise grows with the depth, and has no limit.
    tolerance, energy_tolerance, stabilization, maximum_iterations : as for PoissonSolver
        Of the fit.
    threads, progress, check, return_report : as for solve_poisson
        How the work is done, and what is returned.

    Returns
    -------
    c : Curvature
        A sphere of radius r has the mean curvature 1 / r if its normals point outward.
    report : Report
        If `return_report`.

    Raises
    ------
    InputError
        A `ValueError` that names the face, the vertex or the argument.
    ConvergenceError
        A `RuntimeError`, with what was found.
    Canceled
        A callback of `progress` returned False.

    Examples
    --------
    >>> import restricted_laplacian as rl
    >>> V, F = rl.icosphere(4)
    >>> H, K = rl.curvature(2 * V, F)[:2]
    >>> bool(abs(H - 0.5).max() < 0.01 and abs(K - 0.25).max() < 0.01)
    True
    """
    if method not in ("normals", "face_normals", "coordinates"):
        raise argument_error("method", f"must be normals, face_normals or coordinates, and is "
                             f"{method!r}")
    space = space_of(V, F, threads, accuracy, normals=normals, depth=depth,
                     joining_tolerance=joining_tolerance, geometry=geometry)
    options = solver_options(tolerance, energy_tolerance, stabilization,
                             maximum_iterations=maximum_iterations, smoothing=smoothing,
                             refinements=refinements)
    table, report = _core.curvature(space._space, method, accuracy, options, number_of_threads(threads),
                                    listener(progress))
    result = Curvature(table[:, 0], table[:, 1], table[:, 2:4], table[:, 4:10].reshape(-1, 2, 3),
                       table[:, 10:13])
    return checked(result, report, check, return_report)


@takes_surface
def integrate_gradient(V: Any, F: Any = None, v: Any = None, *, target: Any = None, alpha: Any = None,
                       mean: Any = None, details: bool = False, accuracy: Optional[float] = None,
                       tolerance: Optional[float] = None, energy_tolerance: Optional[float] = None,
                       stabilization: Optional[float] = None, maximum_iterations: Optional[int] = None,
                       normals: Any = None, depth: Optional[int] = None,
                       joining_tolerance: Optional[float] = None, geometry: Any = None,
                       diffusion: Any = None, anisotropy: Any = None, density: Any = None,
                       vertex_data: Optional[str] = None, threads: Optional[int] = None,
                       progress: Progress = None, check: bool = True,
                       return_report: bool = False) -> Any:
    """The function whose gradient is nearest to a vector field.

    Parameters
    ----------
    V, F, normals, depth, joining_tolerance, geometry, vertex_data, diffusion, anisotropy, density : as for Space
        The surface: points (n, 3) and triangles (m, 3); or a pair of them, a mesh of another library, or a
        `Space` as `V` alone.
    v : array_like or callable
        (m, 3) on faces; (n, 3) at vertices, see `vertex_data`; `Corners`; with a last dimension K
        for K fields; or a callable on points. Only the part along the surface counts.
    target : array_like or callable, optional
        Values to which the result is drawn, (n,) or (n, K).
    alpha : float, array_like or callable, optional
        How strongly, in units of 1 / area.
    mean : float or array_like, optional
        Of the result, 0 by default; for K fields (K,).
    details : bool, default False
        Whether to correct the values at the vertices by what splines do not resolve.
    accuracy : float, optional
        Deeper and deeper spaces are tried until the estimated error of the result, relative to its deviation
        from its mean in the root mean square, is not larger. `depth` says where that begins then, at 4 by
        default.
    tolerance, energy_tolerance, stabilization, maximum_iterations : as for PoissonSolver
        When the iteration ends, and what it is; the tolerance is 1e-5 by default.
    threads, progress, check, return_report : as for solve_poisson
        How the work is done, and what is returned. The report has ``root_mean_square_residuals``.

    Returns
    -------
    u : numpy.ndarray
        Values at the vertices, (n,) or (n, K), in units of v times length.
    report : Report
        If `return_report`.

    Raises
    ------
    InputError
        A `ValueError` that names the face, the vertex or the argument.
    ConvergenceError
        A `RuntimeError`, with what was found.
    Canceled
        A callback of `progress` returned False.

    Examples
    --------
    >>> import numpy as np, restricted_laplacian as rl
    >>> V, F = rl.icosphere(4)
    >>> u = rl.integrate_gradient(V, F, np.tile([0., 0., 1.], (len(F), 1)))
    >>> bool(abs(u - V[:, 2]).max() < 5e-3)
    True
    """
    space = space_of(V, F, threads, accuracy, normals=normals, depth=depth,
                     joining_tolerance=joining_tolerance, geometry=geometry, diffusion=diffusion,
                     anisotropy=anisotropy, density=density,
                     vertex_data=vertex_data)
    field = space._function(v, "v", True)
    own_target = None if target is None else space._function(target, "target")
    number, function = None, None
    if alpha is not None and np.ndim(alpha) == 0 and not callable(alpha):
        number = float(alpha)
    elif alpha is not None:
        function = space._function(alpha, "alpha")
    means = None
    if mean is not None:
        means = np.atleast_1d(numbers(mean, "mean", np.float64)).ravel()
    options = solver_options(tolerance, energy_tolerance, stabilization,
                             maximum_iterations=maximum_iterations)
    values, _, report = _core.integrate_gradient(
        space._space, field, own_target, number, function, means, bool(details), accuracy, options,
        number_of_threads(threads), listener(progress))
    if values.shape[1] == 1:
        values = values[:, 0]
    return checked(values, report, check, return_report)

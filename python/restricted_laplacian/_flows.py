# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Surfaces that move, and are edited."""

from __future__ import annotations

from typing import Any, Optional

import numpy as np

from . import _core
from ._errors import Canceled, argument_error
from ._input import Progress, listener, number_of_threads, takes_surface
from ._show import shown
from ._space import Report, Space, SplineFunction, checked, space_of

__all__ = ["MeanCurvatureFlow", "SurfaceEditor", "edit_surface", "mean_curvature_flow", "sharpen_surface",
           "smooth_surface", "spherical_parameterization"]


@shown("time", "space")
class MeanCurvatureFlow:
    """Mean-curvature flow of a surface, step by step: dx/dt = Laplacian x.

    Positions are splines on the first surface, with the metric of the moved one.

    Parameters
    ----------
    V, F, depth, joining_tolerance, geometry : as for Space
        The first surface: points (n, 3) and triangles (m, 3); or a pair of them, a mesh of another library, or a
        `Space` as `V` alone.
    conformal : bool, default False
        The energy remains that of the first surface: this flow passes where the other one collapses, and makes a
        sphere of each surface without holes and handles (Kazhdan, Solomon and Ben-Chen 2012).
    rescaling : {"none", "area", "volume"}, optional
        What is kept by scaling about the centroid after each step: by default the area if `conformal`, and nothing
        else.
    fixed_boundary : bool, default True
        Whether the boundary stays where it is; it is free otherwise.
    tolerance : float, optional
        Of the linear systems, 1e-6 by default.
    stabilization : float, optional
        1e-3 by default.
    threads : int, optional
        By default all processors. Results do not depend on it.

    Examples
    --------
    >>> import numpy as np, restricted_laplacian as rl
    >>> V, F = rl.icosphere(4)
    >>> flow = rl.MeanCurvatureFlow(V, F, depth=4)
    >>> for _ in range(10):
    ...     report = flow.step(0.005)
    >>> radius = np.linalg.norm(flow.positions, axis=1)  # sqrt(1 - 4 t), up to the steps
    >>> bool(abs(radius - np.sqrt(1 - 4 * flow.time)).max() < 5e-3)
    True
    """

    @takes_surface
    def __init__(self, V: Any, F: Any = None, *, conformal: bool = False, rescaling: Optional[str] = None,
                 fixed_boundary: bool = True, tolerance: Optional[float] = None,
                 stabilization: Optional[float] = None, depth: Optional[int] = None,
                 joining_tolerance: Optional[float] = None, geometry: Any = None,
                 threads: Optional[int] = None) -> None:
        if rescaling not in ("none", "area", "volume", None):
            raise argument_error("rescaling", f"must be none, area or volume, and is {rescaling!r}")
        self.space: Space = space_of(V, F, threads, depth=depth, joining_tolerance=joining_tolerance, geometry=geometry)
        self._threads = number_of_threads(threads)
        self._flow = _core.Flow.make(self.space._space, bool(conformal), rescaling, bool(fixed_boundary), tolerance,
                                     stabilization, self._threads)

    def step(self, time_step: float, *, check: bool = True) -> Report:
        """Go on by a time, unless that makes the surface collapse.

        Parameters
        ----------
        time_step : float
            In units of squared length.
        check : bool, default True
            Whether it is an error if the solver does not converge.

        Returns
        -------
        Report
            Of the linear systems; and ``time`` since the beginning, ``area``, ``volume`` inside, ``smallest_angle``
            in degrees of the triangles, ``mean_distortion`` and ``largest_distortion``, (a + 1 / a) / 2 of the ratio a
            of the two stretches of a triangle, 1 if the map is conformal; ``sphere_deviation``, the mean deviation of
            the distance from the centroid, relative; and ``collapse``, why the flow has ended, or an empty string: the
            positions are those before the step then.
        """
        report = self._flow.step(float(time_step), self._threads)
        return checked(None, report, check, True)[1]  # type: ignore[no-any-return]

    @property
    def time(self) -> float:
        """Since the beginning, in units of squared length."""
        return float(self._flow.time)

    @property
    def positions(self) -> np.ndarray:
        """Of the vertices, (n, 3)."""
        return np.ascontiguousarray(self._flow.positions())

    def function(self) -> SplineFunction:
        """The positions as functions on the first surface.

        Returns
        -------
        SplineFunction
            Three functions.
        """
        return SplineFunction(self.space, self._flow.coefficients())


@takes_surface
def mean_curvature_flow(V: Any, F: Any = None, time_step: Optional[float] = None, *, steps: int = 1,
                        conformal: bool = False, rescaling: Optional[str] = None, fixed_boundary: bool = True,
                        tolerance: Optional[float] = None, stabilization: Optional[float] = None,
                        depth: Optional[int] = None, joining_tolerance: Optional[float] = None,
                        geometry: Any = None, threads: Optional[int] = None, progress: Progress = None,
                        check: bool = True, return_report: bool = False) -> Any:
    """Move a surface by mean-curvature flow.

    Parameters
    ----------
    V, F, depth, joining_tolerance, geometry : as for Space
        The surface.
    time_step : float
        In units of squared length.
    steps : int, default 1
        How many; fewer are made if the surface collapses, which the report says.
    conformal, rescaling, fixed_boundary, tolerance, stabilization, threads : as for MeanCurvatureFlow
        Which flow it is, and how it is done.
    progress, check, return_report : as for solve_poisson
        What is told, and returned.

    Returns
    -------
    positions : numpy.ndarray, (n, 3)
        Of the vertices.
    report : Report
        If `return_report`: that of the last step, see `MeanCurvatureFlow.step`.

    Raises
    ------
    InputError
        A `ValueError` that names the face, the vertex or the argument.
    ConvergenceError
        A `RuntimeError`.
    Canceled
        A callback of `progress` returned False.

    Examples
    --------
    A conformal map to a sphere, whose area is that of the surface:

    >>> import numpy as np, restricted_laplacian as rl
    >>> V, F = rl.icosphere(3)
    >>> V = V * [1, 0.6, 0.4]
    >>> area = rl.Space(V, F).area
    >>> X, report = rl.mean_curvature_flow(V, F, 0.02 * area, steps=30, conformal=True, depth=4, return_report=True)
    >>> report.sphere_deviation < 0.01, report.mean_distortion < 1.02
    (True, True)
    """
    if time_step is None:
        raise argument_error("time_step", "is missing")
    if int(steps) != steps or steps < 1:
        raise argument_error("steps", f"is {steps}, but must be at least 1")
    flow = MeanCurvatureFlow(V, F, conformal=conformal, rescaling=rescaling, fixed_boundary=fixed_boundary,
                             tolerance=tolerance, stabilization=stabilization, depth=depth,
                             joining_tolerance=joining_tolerance, geometry=geometry, threads=threads)
    tell = listener(progress)
    report = Report()
    for i in range(int(steps)):
        report = flow.step(time_step, check=check)
        if tell is not None and tell((i + 1) / steps) is False:
            raise Canceled("canceled by progress")
        if report.collapse:
            break
    return (flow.positions, report) if return_report else flow.positions


@takes_surface
def spherical_parameterization(V: Any, F: Any = None, *, tolerance: Optional[float] = None,
                               maximum_iterations: Optional[int] = None, stabilization: Optional[float] = None,
                               depth: Optional[int] = None, joining_tolerance: Optional[float] = None,
                               geometry: Any = None, threads: Optional[int] = None, progress: Progress = None,
                               check: bool = True, return_report: bool = False) -> Any:
    """Map a closed surface without holes and handles to the unit sphere, conformally.

    By the conformal flow until the surface is round, and then by the Moebius transformation for which the mean of the
    map over the surface is the center: so it is unique up to rotations.

    Parameters
    ----------
    V, F, depth, joining_tolerance, geometry : as for Space
        The surface.
    tolerance : float, optional
        How far the moved surface may be from a sphere, 1e-3 by default: the mean deviation of the distance from its
        centroid, relative.
    maximum_iterations : int, optional
        Largest number of steps of the flow, 200 by default.
    stabilization : float, optional
        1e-3 by default.
    threads, progress, check, return_report : as for solve_poisson
        How the work is done, and what is returned.

    Returns
    -------
    positions : numpy.ndarray, (n, 3)
        Of the vertices, on the unit sphere.
    report : Report
        If `return_report`: that of `MeanCurvatureFlow.step`, and ``folded_faces``, how many are turned over on the
        sphere.

    Raises
    ------
    InputError
        A `ValueError` that names the face, the vertex or the argument, or says that there is no such map.
    ConvergenceError
        A `RuntimeError`: the flow did not end at a sphere.
    Canceled
        A callback of `progress` returned False.

    Examples
    --------
    >>> import numpy as np, restricted_laplacian as rl
    >>> V, F = rl.icosphere(4)
    >>> X, report = rl.spherical_parameterization(V * [1, 0.6, 0.5], F, depth=4, return_report=True)
    >>> report.folded_faces, report.mean_distortion < 1.01, bool(abs(np.linalg.norm(X, axis=1) - 1).max() < 1e-12)
    (0, True, True)
    """
    space = space_of(V, F, threads, depth=depth, joining_tolerance=joining_tolerance, geometry=geometry)
    X, report = _core.map_to_sphere(space._space, tolerance, maximum_iterations, stabilization,
                                    number_of_threads(threads), listener(progress))
    return checked(np.ascontiguousarray(X), report, check, return_report)


def _rows(signal: Any, space: Space) -> Optional[np.ndarray]:
    """A signal at the vertices as rows, or None for the positions."""
    if signal is None:
        return None
    rows = np.asarray(signal, dtype=float)
    if rows.ndim not in (1, 2) or rows.shape[0] != space.number_of_vertices or rows.size == 0:
        raise argument_error("signal", f"has the shape {rows.shape}, but there are {space.number_of_vertices} vertices")
    return np.ascontiguousarray(rows.reshape(len(rows), -1))


def _like(values: Any, signal: Any) -> np.ndarray:
    """Rows in the shape of the signal."""
    result = np.ascontiguousarray(values)
    return result if signal is None else result.reshape(np.shape(signal))


def _scale_details(V: Any, F: Any, length: Optional[float], factor: float, signal: Any, crease_angle: Optional[float],
                   tolerance: Optional[float], stabilization: Optional[float], threads: Optional[int],
                   progress: Progress, check: bool, return_report: bool, **of_space: Any) -> Any:
    if length is None:
        raise argument_error("length", "is missing")
    has_depth = isinstance(V, Space) or of_space["depth"] is not None
    space = space_of(V, F, threads, **of_space)
    options = {"crease_angle": crease_angle, "tolerance": tolerance, "stabilization": stabilization}
    values, report = _core.scale_details(space._space, has_depth, float(length), float(factor), _rows(signal, space),
                                         options, number_of_threads(threads), listener(progress))
    return checked(_like(values, signal), report, check, return_report)


@takes_surface
def smooth_surface(V: Any, F: Any = None, length: Optional[float] = None, *, crease_angle: Optional[float] = None,
                   signal: Any = None, tolerance: Optional[float] = None, stabilization: Optional[float] = None,
                   depth: Optional[int] = None, joining_tolerance: Optional[float] = None, geometry: Any = None,
                   threads: Optional[int] = None, progress: Progress = None, check: bool = True,
                   return_report: bool = False) -> Any:
    """Smooth a surface, or a signal on it: what is smaller than a length goes.

    Waves of the length are halved, those of twice the length lose a seventeenth, whatever the unit and the triangles
    are: 1 / (1 + (length / wave)^4) is what remains.

    Parameters
    ----------
    V, F, depth, joining_tolerance, geometry : as for Space
        The surface. With a `crease_angle` and without a depth cells are not wider than half of the mean edge.
    length : float
        What goes, and what remains.
    crease_angle : float, optional
        Where normals turn by more degrees, creases are kept: the normals of faces are filtered, and the surface is
        fitted to them.
    signal : array_like, (n,) or (n, K), optional
        Values at the vertices that are smoothed in place of the positions.
    tolerance : float, optional
        Of the linear systems, or of the filter: 1e-4 by default.
    stabilization : float, optional
        1e-3 by default.
    threads, progress, check, return_report : as for solve_poisson
        How the work is done, and what is returned.

    Returns
    -------
    positions : numpy.ndarray, (n, 3)
        Of the vertices, or the signal.
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
    sharpen_surface, edit_surface, smooth

    Examples
    --------
    >>> import numpy as np, restricted_laplacian as rl
    >>> V, F = rl.icosphere(4)
    >>> noisy = V * (1 + 0.01 * np.random.default_rng(1).standard_normal((len(V), 1)))
    >>> X = rl.smooth_surface(noisy, F, 0.5)
    >>> deviation = np.std(np.linalg.norm(X, axis=1))
    >>> bool(deviation < 0.003)
    True
    """
    if crease_angle is not None and signal is not None:
        raise argument_error("crease_angle", "is for positions: a signal has no normals")
    return _scale_details(V, F, length, 0, signal, crease_angle, tolerance, stabilization, threads, progress, check,
                          return_report, depth=depth, joining_tolerance=joining_tolerance, geometry=geometry)


@takes_surface
def sharpen_surface(V: Any, F: Any = None, length: Optional[float] = None, factor: float = 2, *, signal: Any = None,
                    tolerance: Optional[float] = None, stabilization: Optional[float] = None,
                    depth: Optional[int] = None, joining_tolerance: Optional[float] = None, geometry: Any = None,
                    threads: Optional[int] = None, progress: Progress = None, check: bool = True,
                    return_report: bool = False) -> Any:
    """Multiply what is smaller than a length by a factor, and leave what is larger.

    Parameters
    ----------
    V, F, depth, joining_tolerance, geometry : as for Space
        The surface.
    length : float
        What is larger remains.
    factor : float, default 2
        Of what is smaller.
    signal : array_like, (n,) or (n, K), optional
        Values at the vertices that are sharpened in place of the positions.
    tolerance, stabilization : as for smooth_surface
        How well it is done.
    threads, progress, check, return_report : as for solve_poisson
        How the work is done, and what is returned.

    Returns
    -------
    positions : numpy.ndarray, (n, 3)
        Of the vertices, or the signal.
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
    >>> bumps = np.sin(8 * V[:, 2])
    >>> twice = rl.sharpen_surface(V, F, 10, 2, signal=bumps, depth=5)
    >>> bool(abs(twice - (2 * bumps - bumps.mean())).max() < 0.1)
    True
    """
    return _scale_details(V, F, length, factor, signal, None, tolerance, stabilization, threads, progress, check,
                          return_report, depth=depth, joining_tolerance=joining_tolerance, geometry=geometry)


class SurfaceEditor:
    """Edits the positions of a surface, or another signal x on it, by its gradient.

    The result u minimizes the integral of abs(grad u - scale * grad x)^2 + alpha * abs(u - x)^2. What is much longer
    than 2 pi / sqrt(alpha) remains; what is much shorter is multiplied by the scale.

    Parameters
    ----------
    V, F, depth, joining_tolerance, geometry : as for Space
        The surface.
    alpha : float
        Positive, in units of 1 / area.
    anisotropic : float, default 0
        How far it follows the curvature: the metric is that of the surface (x, w n) with its normals, w = anisotropic
        / sqrt(alpha). Creases are wide in it, and survive.
    signal : array_like, (n,) or (n, K), optional
        x at the vertices, in place of the positions.
    tolerance : float, optional
        Of the linear systems, 1e-4 by default.
    stabilization : float, optional
        1e-3 by default.
    threads : int, optional
        By default all processors. Results do not depend on it.

    Examples
    --------
    >>> import numpy as np, restricted_laplacian as rl
    >>> V, F = rl.icosphere(4)
    >>> editor = rl.SurfaceEditor(V, F, 100)
    >>> bool(np.allclose(editor.edit(1), V))
    True
    >>> radius = np.linalg.norm(editor.edit(0), axis=1)  # alpha / (alpha + 2) of it remains
    >>> bool(abs(radius - 100 / 102).max() < 1e-3)
    True
    """

    @takes_surface
    def __init__(self, V: Any, F: Any = None, alpha: Optional[float] = None, *, anisotropic: float = 0,
                 signal: Any = None, tolerance: Optional[float] = None, stabilization: Optional[float] = None,
                 depth: Optional[int] = None, joining_tolerance: Optional[float] = None, geometry: Any = None,
                 threads: Optional[int] = None) -> None:
        if alpha is None:
            raise argument_error("alpha", "is missing")
        self.space: Space = space_of(V, F, threads, depth=depth, joining_tolerance=joining_tolerance, geometry=geometry)
        self._signal = signal
        self._threads = number_of_threads(threads)
        options = {"anisotropic": anisotropic, "tolerance": tolerance, "stabilization": stabilization}
        self._editor = _core.Editor.make(self.space._space, float(alpha), _rows(signal, self.space), options,
                                         self._threads)

    def edit(self, gradient_scale: Any, *, check: bool = True, return_report: bool = False) -> Any:
        """The signal for a scale of its gradient.

        Parameters
        ----------
        gradient_scale : float, array_like or callable
            0 smooths, 1 changes nothing, 2 doubles details; a number for all of the surface, for which nothing has to
            be solved; (n,) at the vertices; (m,) on the faces; or a callable on points.
        check, return_report : as for solve_poisson
            What is checked, and returned.

        Returns
        -------
        positions : numpy.ndarray, (n, 3)
            Of the vertices, or the signal.
        report : Report
            If `return_report`.
        """
        if np.ndim(gradient_scale) == 0 and not callable(gradient_scale):
            values, report = self._editor.edit(float(gradient_scale))
        else:
            scale = self.space._function(gradient_scale, "gradient_scale")
            values, report = self._editor.edit_by(scale, self._threads)
        return checked(_like(values, self._signal), report, check, return_report)


@takes_surface
def edit_surface(V: Any, F: Any = None, gradient_scale: Any = None, alpha: Optional[float] = None, *,
                 anisotropic: float = 0, signal: Any = None, tolerance: Optional[float] = None,
                 stabilization: Optional[float] = None, depth: Optional[int] = None,
                 joining_tolerance: Optional[float] = None, geometry: Any = None, threads: Optional[int] = None,
                 check: bool = True, return_report: bool = False) -> Any:
    """Edit a surface, or a signal on it, by its gradient: `SurfaceEditor` for one scale.

    Parameters
    ----------
    V, F, depth, joining_tolerance, geometry : as for Space
        The surface.
    gradient_scale, alpha, anisotropic, signal, tolerance, stabilization, threads : as for SurfaceEditor
        What is done.
    check, return_report : as for solve_poisson
        What is checked, and returned.

    Returns
    -------
    positions : numpy.ndarray, (n, 3)
        Of the vertices, or the signal.
    report : Report
        If `return_report`.

    Raises
    ------
    InputError
        A `ValueError` that names the face, the vertex or the argument.
    ConvergenceError
        A `RuntimeError`, with what was found.

    Examples
    --------
    Details of the upper half of a sphere go, those of the lower half remain:

    >>> import numpy as np, restricted_laplacian as rl
    >>> V, F = rl.icosphere(4)
    >>> bumpy = V * (1 + 0.02 * np.sin(20 * V[:, :1]))
    >>> X = rl.edit_surface(bumpy, F, np.where(V[:, 2] > 0, 0, 1), 200)
    >>> change = np.linalg.norm(X - bumpy, axis=1)
    >>> bool(change[V[:, 2] > 0.3].mean() > 10 * change[V[:, 2] < -0.3].mean())
    True
    """
    if gradient_scale is None:
        raise argument_error("gradient_scale", "is missing")
    editor = SurfaceEditor(V, F, alpha, anisotropic=anisotropic, signal=signal, tolerance=tolerance,
                           stabilization=stabilization, depth=depth, joining_tolerance=joining_tolerance,
                           geometry=geometry, threads=threads)
    return editor.edit(gradient_scale, check=check, return_report=return_report)

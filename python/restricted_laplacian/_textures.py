# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Colors of a mesh from several scans, without visible seams."""

from __future__ import annotations

import math
from typing import Any, Optional, Sequence

import numpy as np

from . import _core
from ._errors import argument_error
from ._input import (Progress, listener, make_surface, number_of_threads, numbers, rows,
                     takes_surface)
from ._space import checked, solver_options, space_of


class Scan:
    """A colored scan: a mesh, or points with normals.

    Parameters
    ----------
    V, F, normals : as for Space
        The surface, in coordinates of the scan.
    colors : array_like, (n, 3)
        From 0 to 1, or from 0 to 255 if they are integers.
    pose : array_like, (4, 4), optional
        Takes coordinates of the scan to those of the mesh: a rotation, a translation, a scale.
    viewpoint : array_like, (3,)
        Where the scan was seen from, in its coordinates; the origin by default.
    threads : int, optional
        All processors by default. Results do not depend on it.

    Examples
    --------
    >>> import restricted_laplacian as rl
    >>> V, F = rl.icosphere(3)
    >>> front = V[F].mean(axis=1)[:, 2] > 0
    >>> scan = rl.Scan(V, F[front], abs(V), viewpoint=(0, 0, 5))
    """

    @takes_surface
    def __init__(self, V: Any, F: Any = None, colors: Any = None, *, normals: Any = None,
                 pose: Any = None, viewpoint: Any = (0, 0, 0), threads: Optional[int] = None
                 ) -> None:
        given = numbers(colors, "colors")
        own = rows(given, "colors")
        if given.dtype.kind in "iu":
            own = own / 255
        self._scan = _core.make_scan(
            make_surface(V, F, normals=normals, threads=threads), own,
            rows(np.eye(4) if pose is None else pose, "pose"),
            numbers(viewpoint, "viewpoint", np.float64).ravel(), number_of_threads(threads))


@takes_surface
def stitch_colors(V: Any, F: Any = None, scans: Sequence[Scan] = (), *, alpha: Optional[float] = None,
                  gradients: str = "back-projection", maximum_distance: Optional[float] = None,
                  normal_angle: float = 60, oriented: bool = True, match_exposures: bool = True,
                  linear_light: bool = False, details: bool = True,
                  tolerance: Optional[float] = None, stabilization: Optional[float] = None,
                  depth: Optional[int] = None, joining_tolerance: Optional[float] = None,
                  threads: Optional[int] = None, progress: Progress = None, check: bool = True,
                  return_report: bool = False) -> Any:
    """Colors of the vertices, whose gradients are nearest to those of the scan that sees them best.

    Parameters
    ----------
    V, F, depth, joining_tolerance : as for Space
        The mesh: points (n, 3) and triangles (m, 3); or a pair of them, a mesh of another library, or a
        `Space` as `V` alone.
    scans : sequence of Scan
        The scans, each with its pose.
    alpha : float, optional
        How strongly the result is drawn to the colors of the chosen scans; by default 10 / area.
    gradients : {"back-projection", "scans"}
        Gradients of the colors that a scan gives to the vertices, the default, or its own.
    maximum_distance : float, optional
        Of a vertex to a scan that covers it.
    normal_angle : float, default 60
        Largest angle between normals of mesh and scan, in degrees.
    oriented : bool, default True
        Whether the normals of the mesh point to the side from which it is seen.
    match_exposures, linear_light, details : bool
        Multiply colors of scans by factors so that they agree; stitch in linear light; add at the
        vertices what splines do not resolve.
    tolerance, stabilization : as for integrate_gradient
        When the iteration ends, and what it is.
    threads, progress, check, return_report : as for solve_poisson
        How the work is done, and what is returned. The report has ``seam_length``, ``jump_before``, ``jump_after``, and
        ``scans``, the number of the scan of each vertex, or -1.

    Returns
    -------
    colors : numpy.ndarray, (n, 3)
        From 0 to 1.
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
    >>> V, F = rl.icosphere(3)
    >>> z = V[F].mean(axis=1)[:, 2]
    >>> halves = [rl.Scan(V, F[side * z > -0.1], abs(V), viewpoint=(0, 0, 5 * side)) for side in (1, -1)]
    >>> colors = rl.stitch_colors(V, F, halves, depth=4)
    >>> bool(abs(colors - abs(V)).mean() < 0.05)
    True
    """
    if gradients not in ("back-projection", "scans"):
        raise argument_error("gradients", f"must be back-projection or scans, and is {gradients!r}")
    space = space_of(V, F, threads, depth=depth, joining_tolerance=joining_tolerance)
    options = solver_options(
        tolerance, None, stabilization, alpha=alpha, gradients=gradients,
        maximum_distance=maximum_distance,
        normal_angle=normal_angle, oriented=oriented,
        match_exposures=match_exposures, linear_light=linear_light, details=details)
    colors, chosen, report = _core.stitch_colors(
        space._space, [scan._scan for scan in scans], options, number_of_threads(threads),
        listener(progress))
    return checked(colors, dict(report, scans=chosen), check, return_report)

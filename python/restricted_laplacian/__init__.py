# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""The Laplace-Beltrami operator of a surface, by B-splines on an octree restricted to it.

Poisson problems, spectra, fits, curvature, gradient fields, stitched colors and distances of any
triangles, or of points with normals: results that hardly depend on the triangulation, by a multigrid method.

>>> import restricted_laplacian as rl
>>> V, F = rl.icosphere(4)
>>> u = rl.solve_poisson(V, F, V[:, 2])
>>> l, phi = rl.eigs(V, F, 10)
"""

from ._core import __version__
from ._distances import (DistanceFunction, Distances, Geodesics, Path, farthest_points,
                         geodesic_distance, shortest_path)
from ._errors import Canceled, ConvergenceError, InputError
from ._files import read_mesh, read_vertex_properties
from ._flows import (MeanCurvatureFlow, SurfaceEditor, edit_surface, mean_curvature_flow, sharpen_surface,
                     smooth_surface, spherical_parameterization)
from ._input import Corners
from ._maps import FunctionalMap, PointMap, functional_map, zoomout
from ._problems import (Curvature, curvature, diffuse, fit_function, integrate_gradient, smooth,
                        solve_poisson, solve_screened_poisson)
from ._shapes import icosphere
from ._space import (MemoryEstimate, Operators, PoissonSolver, Report, Space, SplineFunction,
                     cotangent_operators, estimate_memory)
from ._spectra import (Spectrum, biharmonic_embedding, diffusion_map, eigs,
                       global_point_signature, heat_kernel_signature, heat_kernel_times,
                       heat_trace, laplace_spectrum, number_of_zero_eigenvalues, shape_dna,
                       wave_kernel_signature)
from ._textures import Scan, stitch_colors
from ._view import View, to_polyscope

__all__ = [
    "Canceled", "ConvergenceError", "Corners", "Curvature", "DistanceFunction", "Distances",
    "FunctionalMap", "Geodesics", "InputError", "MeanCurvatureFlow", "MemoryEstimate", "Operators", "Path",
    "PointMap", "PoissonSolver", "Report",
    "Scan", "Space", "Spectrum", "SplineFunction", "SurfaceEditor", "View", "__version__",
    "biharmonic_embedding", "cotangent_operators", "curvature", "diffuse", "diffusion_map", "edit_surface", "eigs",
    "estimate_memory",
    "farthest_points", "fit_function", "functional_map", "geodesic_distance", "global_point_signature",
    "heat_kernel_signature", "heat_kernel_times", "heat_trace", "icosphere",
    "integrate_gradient", "laplace_spectrum", "mean_curvature_flow", "number_of_zero_eigenvalues", "read_mesh",
    "read_vertex_properties", "shape_dna", "sharpen_surface", "shortest_path", "smooth", "smooth_surface", "solve_poisson",
    "solve_screened_poisson",
    "spherical_parameterization", "stitch_colors",
    "to_polyscope", "wave_kernel_signature", "zoomout",
]

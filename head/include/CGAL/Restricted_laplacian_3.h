// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_H
#define CGAL_RESTRICTED_LAPLACIAN_3_H

/// \file
/// Includes all public headers of the package but those of several machines, in `distributed/`, and
/// `spectra/shift_invert_eigenpairs.h`, which need other libraries.

#include <CGAL/Restricted_laplacian_3/assembly/cotangent_operators.h>
#include <CGAL/Restricted_laplacian_3/diffuse.h>
#include <CGAL/Restricted_laplacian_3/edit_surface.h>
#include <CGAL/Restricted_laplacian_3/estimate_curvature.h>
#include <CGAL/Restricted_laplacian_3/files/read_mesh_file.h>
#include <CGAL/Restricted_laplacian_3/fit_function.h>
#include <CGAL/Restricted_laplacian_3/foundation/memory.h>
#include <CGAL/Restricted_laplacian_3/geodesic_distances.h>
#include <CGAL/Restricted_laplacian_3/input/read_surface.h>
#include <CGAL/Restricted_laplacian_3/integrate_gradient_field.h>
#include <CGAL/Restricted_laplacian_3/integration/Monte_carlo.h>
#include <CGAL/Restricted_laplacian_3/integration/Surface_material.h>
#include <CGAL/Restricted_laplacian_3/integration/Weighted_integration.h>
#include <CGAL/Restricted_laplacian_3/integration/triangle_quadrature.h>
#include <CGAL/Restricted_laplacian_3/laplace_spectrum.h>
#include <CGAL/Restricted_laplacian_3/mean_curvature_flow.h>
#include <CGAL/Restricted_laplacian_3/octree/Surface_windows.h>
#include <CGAL/Restricted_laplacian_3/problems/Geodesic_fitter.h>
#include <CGAL/Restricted_laplacian_3/problems/Multigrid_preconditioner.h>
#include <CGAL/Restricted_laplacian_3/problems/monte_carlo_error.h>
#include <CGAL/Restricted_laplacian_3/smooth_surface.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>
#include <CGAL/Restricted_laplacian_3/spectra/smallest_eigenpairs.h>
#include <CGAL/Restricted_laplacian_3/spectra/sparse_cholesky.h>
#include <CGAL/Restricted_laplacian_3/spectral_descriptors.h>
#include <CGAL/Restricted_laplacian_3/spherical_parameterization.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_functions_3.h>
#include <CGAL/Restricted_laplacian_3/splines/estimate_memory.h>
#include <CGAL/Restricted_laplacian_3/splines/evaluation_matrix.h>
#include <CGAL/Restricted_laplacian_3/splines/prolongation.h>
#include <CGAL/Restricted_laplacian_3/stitch_colors.h>
#include <CGAL/Restricted_laplacian_3/version.h>

#endif // CGAL_RESTRICTED_LAPLACIAN_3_H

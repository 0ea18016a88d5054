// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Restricted_laplacian_3/problems/Curvature_field_impl.h>
#include <CGAL/Restricted_laplacian_3/problems/Function_fitter_impl.h>
#include <CGAL/Restricted_laplacian_3/problems/Geodesic_fitter_impl.h>
#include <CGAL/Restricted_laplacian_3/problems/Poisson_problem_impl.h>
#include <CGAL/Restricted_laplacian_3/problems/Poisson_solver_impl.h>
#include <CGAL/Restricted_laplacian_3/problems/integrate_gradients_impl.h>
#include <CGAL/Restricted_laplacian_3/problems/multigrid_levels_impl.h>
#include <CGAL/Restricted_laplacian_3/problems/shared/search_depth_impl.h>

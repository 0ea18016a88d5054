// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Restricted_laplacian_3/assembly/Boundary_integration_impl.h>
#include <CGAL/Restricted_laplacian_3/assembly/Dirichlet_boundary_impl.h>
#include <CGAL/Restricted_laplacian_3/assembly/Point_constraints_impl.h>
#include <CGAL/Restricted_laplacian_3/assembly/assemble_impl.h>
#include <CGAL/Restricted_laplacian_3/assembly/cotangent_operators_impl.h>
#include <CGAL/Restricted_laplacian_3/assembly/shared/assemble_system_impl.h>
#include <CGAL/Restricted_laplacian_3/assembly/shared/fit_residual_impl.h>

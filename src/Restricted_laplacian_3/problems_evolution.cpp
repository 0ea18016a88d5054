// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Restricted_laplacian_3/problems/Diffusion_solver_impl.h>
#include <CGAL/Restricted_laplacian_3/problems/Mean_curvature_flow_impl.h>
#include <CGAL/Restricted_laplacian_3/problems/Moved_integration_impl.h>
#include <CGAL/Restricted_laplacian_3/problems/Surface_editor_impl.h>
#include <CGAL/Restricted_laplacian_3/problems/map_to_sphere_impl.h>
#include <CGAL/Restricted_laplacian_3/problems/scale_details_impl.h>

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Restricted_laplacian_3/geodesics/Geodesic_function_impl.h>
#include <CGAL/Restricted_laplacian_3/geodesics/Geodesic_solver_impl.h>

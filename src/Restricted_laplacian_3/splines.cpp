// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Restricted_laplacian_3/splines/Spline_function_3_impl.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_functions_3_impl.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3_impl.h>
#include <CGAL/Restricted_laplacian_3/splines/estimate_memory_impl.h>
#include <CGAL/Restricted_laplacian_3/splines/evaluation_matrix_impl.h>
#include <CGAL/Restricted_laplacian_3/splines/prolongation_impl.h>

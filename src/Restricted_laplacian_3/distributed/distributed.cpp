// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Restricted_laplacian_3/distributed/Distributed_functions_impl.h>
#include <CGAL/Restricted_laplacian_3/distributed/Distributed_space_impl.h>
#include <CGAL/Restricted_laplacian_3/distributed/Distributed_surface_impl.h>
#include <CGAL/Restricted_laplacian_3/distributed/surface_slices_impl.h>
#include <CGAL/Restricted_laplacian_3/distributed/vertex_values_impl.h>
#include <CGAL/Restricted_laplacian_3/distributed/write_in_order_impl.h>

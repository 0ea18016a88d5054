// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Restricted_laplacian_3/integration/Monte_carlo_impl.h>
#include <CGAL/Restricted_laplacian_3/integration/Surface_material_impl.h>
#include <CGAL/Restricted_laplacian_3/integration/cubature_impl.h>

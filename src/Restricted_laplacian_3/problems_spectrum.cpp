// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Restricted_laplacian_3/problems/monte_carlo_error_impl.h>
#include <CGAL/Restricted_laplacian_3/problems/space_spectrum_impl.h>

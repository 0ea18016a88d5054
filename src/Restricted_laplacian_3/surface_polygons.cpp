// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Polygons are divided without 3D triangulations, which take much memory to compile.
#define CGAL_HOLE_FILLING_DO_NOT_USE_DT3

#include <CGAL/Restricted_laplacian_3/surface/shared/divide_polygon_impl.h>

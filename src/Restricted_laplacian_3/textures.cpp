// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Restricted_laplacian_3/textures/Color_stitcher_impl.h>
#include <CGAL/Restricted_laplacian_3/textures/Colored_scan_impl.h>
#include <CGAL/Restricted_laplacian_3/textures/back_project_colors_impl.h>

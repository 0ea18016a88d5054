// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Restricted_laplacian_3/input/point_areas_impl.h>
#include <CGAL/Restricted_laplacian_3/patches/curved_surface_impl.h>
#include <CGAL/Restricted_laplacian_3/patches/smooth_vertex_data_impl.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_patches_impl.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_seams_impl.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3_impl.h>
#include <CGAL/Restricted_laplacian_3/surface/sample_surface_impl.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/Divided_surface_impl.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/divide_polygon_impl.h>
#include <CGAL/Restricted_laplacian_3/surface/vertex_normals_impl.h>

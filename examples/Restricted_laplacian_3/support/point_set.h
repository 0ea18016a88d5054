// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_EXAMPLES_POINT_SET_H
#define RESTRICTED_LAPLACIAN_3_EXAMPLES_POINT_SET_H

// Points, normals and properties of a file in CGAL's type, which takes long to compile: only
// sources of this folder include it.

#include "color_map.h"
#include "program.h"

#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <CGAL/Point_set_3.h>

#include <string>
#include <vector>

namespace examples {

// points, their normals if the file has any, and all other numbers of a PLY file
using Point_set = CGAL::Point_set_3<RL::Point_3, RL::Vector_3>;

// The points of a file, or the vertices of a mesh.
Point_set read_points(const std::string& file);

// The colors of points; `file` is for messages.
std::vector<Color> colors(Point_set& points, const std::string& file);

} // namespace examples

#endif // RESTRICTED_LAPLACIAN_3_EXAMPLES_POINT_SET_H

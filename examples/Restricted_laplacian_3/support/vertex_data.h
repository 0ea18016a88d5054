// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_EXAMPLES_VERTEX_DATA_H
#define RESTRICTED_LAPLACIAN_3_EXAMPLES_VERTEX_DATA_H

// What files hold at vertices, as CGAL reads it.

#include "color_map.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace examples {

namespace internal {

// The types of the coordinates and normals of the vertices of a PLY file, by their names; none of
// other files. CGAL takes it for granted that they are there, and float or double.
std::map<std::string, std::string> coordinate_types(const std::string& file);

} // namespace internal

// What a file holds at its vertices beside coordinates, normals and colors: names and values, in
// the order of the file; nothing, unless it is a PLY file.
std::vector<std::pair<std::string, std::vector<double>>>
read_ply_properties(const std::string& file);

// The values of a vertex property of a PLY file, in its order.
std::vector<double> read_ply_property(const std::string& file, const std::string& name);

// The colors of the vertices of a file, and whether it has any.
bool has_colors(const std::string& file);
std::vector<Color> read_colors(const std::string& file);

} // namespace examples

#endif // RESTRICTED_LAPLACIAN_3_EXAMPLES_VERTEX_DATA_H

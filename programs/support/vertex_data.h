// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_PROGRAMS_VERTEX_DATA_H
#define RESTRICTED_LAPLACIAN_3_PROGRAMS_VERTEX_DATA_H

// What files hold at vertices.

#include "color_map.h"
#include "program.h"

#include <CGAL/Restricted_laplacian_3/files/Vertex_property.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>

#include <string>
#include <utility>
#include <vector>

namespace programs {

namespace internal {

using Vertex_properties = std::vector<RL::Vertex_property>;

// the normals among properties; empty if they are not there
std::vector<RL::Vector_3> normals_of(const Vertex_properties& properties);
// the colors; `file` is for messages
std::vector<Color> colors_of(const Vertex_properties& properties, const std::string& file);

} // namespace internal

// What a file holds at its vertices beside coordinates, normals and colors: names and values, in
// the order of the file.
std::vector<std::pair<std::string, std::vector<double>>>
read_vertex_values(const std::string& file);

// The values of a vertex property of a file, in its order.
std::vector<double> read_vertex_property(const std::string& file, const std::string& name);

bool has_vertex_property(const std::string& file, const std::string& name);

// The colors of the vertices of a file, and whether it has any.
bool has_colors(const std::string& file);
std::vector<Color> read_colors(const std::string& file);

} // namespace programs

#endif // RESTRICTED_LAPLACIAN_3_PROGRAMS_VERTEX_DATA_H

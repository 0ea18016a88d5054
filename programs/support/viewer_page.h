// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_PROGRAMS_VIEWER_PAGE_H
#define RESTRICTED_LAPLACIAN_3_PROGRAMS_VIEWER_PAGE_H

// Pages that show functions on surfaces, to be turned around in a browser: one file that needs no
// network. What draws is in the folder viewer/ of the package.

#include "program.h"

#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace programs {

// A function at the vertices.
struct Viewer_field {
  std::string name;
  // NaN and infinity are shown as no value
  std::vector<double> values;
  // or three for each vertex: red, green and blue from 0 to 1
  bool is_color = false;
  // which values have the first and the last color; by default the smallest and the largest value
  std::optional<std::pair<double, double>> range;
  // where the vertices are while it is shown; where those of the surface are if there is none
  std::vector<RL::Point_3> points = {};
};

// Triangles; or points, with or without normals, if there are no triangles.
struct Viewer_surface {
  Viewer_surface() = default;
  Viewer_surface(std::string name, const RL::Triangulated_surface_3& surface);

  std::string name;
  std::vector<RL::Point_3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<RL::Vector_3> normals;
  std::vector<Viewer_field> fields;
  // drawn on the surface: the points of each
  std::vector<std::vector<RL::Point_3>> lines;
};

// One surface, or several side by side under one camera. A slider takes all surfaces to the fields
// of one number.
struct Viewer_page {
  std::string title;
  std::vector<Viewer_surface> surfaces;
  std::size_t first_field = 0; // the one shown first
  int isolines = 0;            // about so many
  char up = 'y';               // the axis that points up, y or z
};

// Writes a page. Coordinates are rounded to a millionth of the longest side of the box around all
// that is shown of a surface, and values to 6e-8 of the difference between the largest and the
// smallest. Faces with a corner that is not finite are left out, and the page says so.
// \param bundle the viewer, a page without a scene, as viewer/build.js makes it
void write_viewer_page(std::ostream& out, const std::string& bundle, const Viewer_page& page);

// The viewer in a file.
// \throws Error that says what to install, if there is none
std::string read_viewer(const std::string& file);

// throws the same error
void check_viewer(const std::string& file);

} // namespace programs

#endif // RESTRICTED_LAPLACIAN_3_PROGRAMS_VIEWER_PAGE_H

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_PROGRAMS_POINT_INPUT_H
#define RESTRICTED_LAPLACIAN_3_PROGRAMS_POINT_INPUT_H

// Reads oriented points: XYZ files with six numbers in each line, and PLY files without faces.

#include "command_line.h"
#include "mesh_input.h"

#include <CGAL/Restricted_laplacian_3/input/point_areas.h>

#include <string>

namespace programs {

struct Point_options {
  int neighbors = RL::default_number_of_neighbors;
};

po::options_description point_options(Point_options& p, Common_options& o);

const char* const about_points = R"(
In place of a mesh, a file .xyz with lines of six numbers, x y z nx ny nz, or a PLY file
without faces but with the properties nx, ny, nz of its vertices, is a set of points with
normals, and stands for a surface without any mesh. Normals must be oriented alike. Unless
--depth is given, the depth is the largest up to 6 that gives 50 points to a cell.
)";

// A mesh, or a set of points.
Mesh_input read_mesh_or_points(const std::string& file,
                               int neighbors = RL::default_number_of_neighbors,
                               const Callback& callback = {});

// The same, for the options of a program.
Mesh_input read_mesh_or_points(const Common_options& o, const Point_options& p,
                               const po::variables_map& given, const Callback& callback);

} // namespace programs

#endif // RESTRICTED_LAPLACIAN_3_PROGRAMS_POINT_INPUT_H

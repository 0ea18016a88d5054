// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_EXAMPLES_POSES_H
#define RESTRICTED_LAPLACIAN_3_EXAMPLES_POSES_H

// Where scans were taken from. A file of poses has a line for each scan: the name of its file, and
// the 16 numbers, row by row, of the matrix that takes its coordinates to those of the world. Lines
// that begin with # are comments.

#include "program.h"

#include <CGAL/Restricted_laplacian_3/Triangulated_surface_3.h>

#include <CGAL/Aff_transformation_3.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace examples {

using Pose = CGAL::Aff_transformation_3<RL::Kernel>;

namespace internal {

// The pose of one line. A rotation and a translation, and perhaps a change of unit: what else an
// affine map may do is taken for a mistake, and the last row must be 0 0 0 1.
inline Pose read_pose(std::istream& numbers, const std::string& where) {
  constexpr double tolerance = 1e-3;
  std::array<double, 16> m;
  for(std::size_t i = 0; i < 16; ++i) {
    require(static_cast<bool>(numbers >> m[i]),
            where + ": a name and 16 numbers are needed, but number " + std::to_string(i + 1) +
                " is missing or not a number");
    require(std::isfinite(m[i]), where + ": number " + std::to_string(i + 1) + " is not finite");
  }
  std::string more;
  require(!(numbers >> more), where + ": there is more than a name and 16 numbers");
  require(m[12] == 0 && m[13] == 0 && m[14] == 0 && m[15] == 1,
          where + ": the last row of the matrix is not 0 0 0 1" +
              (m[3] == 0 && m[7] == 0 && m[11] == 0 ? ": is it written by columns?" : ""));
  const std::array<RL::Vector_3, 3> rows = {RL::Vector_3(m[0], m[1], m[2]),
                                            RL::Vector_3(m[4], m[5], m[6]),
                                            RL::Vector_3(m[8], m[9], m[10])};
  const double determinant = CGAL::cross_product(rows[0], rows[1]) * rows[2];
  require(determinant > 0, where + (determinant < 0 ? ": the matrix is a mirror image"
                                                    : ": the matrix has the determinant 0"));
  const double squared_scale = std::cbrt(determinant * determinant);
  for(std::size_t i = 0; i < 3; ++i)
    for(std::size_t j = 0; j <= i; ++j)
      require(std::abs(rows[i] * rows[j] - (i == j ? squared_scale : 0)) <=
                  tolerance * squared_scale,
              where + ": the matrix is not a rotation with a translation");
  return Pose(m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8], m[9], m[10], m[11]);
}

} // namespace internal

// The poses of a file by the names of the scans.
inline std::map<std::string, Pose> read_poses(const std::string& file) {
  std::ifstream in(file);
  require(in.good(), "cannot open '" + file + "'");
  std::map<std::string, Pose> poses;
  std::size_t number = 0;
  for(std::string line; std::getline(in, line);) {
    ++number;
    std::istringstream words(line);
    std::string name;
    if(!(words >> name) || name[0] == '#')
      continue;
    const std::string where = "'" + file + "': line " + std::to_string(number);
    const Pose pose = internal::read_pose(words, where);
    require(poses.emplace(name, pose).second, where + ": '" + name + "' has a pose already");
  }
  require(!poses.empty(), "'" + file + "' holds no pose");
  return poses;
}

// The pose of the file of a scan: that of its path as given, else that of its name without folders.
inline const Pose& pose_of(const std::map<std::string, Pose>& poses, const std::string& scan,
                           const std::string& file) {
  for(const std::string& name : {scan, std::filesystem::path(scan).filename().string()}) {
    const auto pose = poses.find(name);
    if(pose != poses.end())
      return pose->second;
  }
  throw Error("'" + file + "' has no pose for '" + scan + "'");
}

inline void write_poses(const std::string& file,
                        const std::vector<std::pair<std::string, Pose>>& poses) {
  write_file(file, [&](std::ostream& out) {
    out << "# file, then the 4x4 matrix, row by row, that takes its coordinates to the world\n";
    for(const auto& [name, pose] : poses) {
      out << name;
      for(int row = 0; row < 3; ++row)
        for(int column = 0; column < 4; ++column)
          out << ' ' << pose.m(row, column);
      out << " 0 0 0 1\n";
    }
  });
}

} // namespace examples

#endif // RESTRICTED_LAPLACIAN_3_EXAMPLES_POSES_H

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_PROGRAMS_POSES_H
#define RESTRICTED_LAPLACIAN_3_PROGRAMS_POSES_H

// Where scans were taken from. A file of poses has a line for each scan: the name of its file, and
// the 16 numbers, row by row, of the matrix that takes its coordinates to those of the world. Lines
// that begin with # are comments.

#include "program.h"

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/textures/Colored_scan.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <istream>
#include <map>
#include <sstream>
#include <string>

namespace programs {

namespace internal {

// the pose of one line
inline RL::Scan_pose read_pose(std::istream& numbers, const std::string& where) {
  std::array<double, 16> rows;
  for(std::size_t i = 0; i < rows.size(); ++i)
    require(static_cast<bool>(numbers >> rows[i]),
            where + ": a name and 16 numbers are needed, but number " + std::to_string(i + 1) +
                " is missing or not a number");
  std::string more;
  require(!(numbers >> more), where + ": there is more than a name and 16 numbers");
  try {
    return RL::scan_pose(rows);
  } catch(const RL::Parameter_error& e) {
    throw Error(where + ": " + e.what());
  }
}

} // namespace internal

// The poses of a file by the names of the scans.
inline std::map<std::string, RL::Scan_pose> read_poses(const std::string& file) {
  check_input(file);
  std::ifstream in(file);
  require(in.good(), "cannot open '" + file + "'");
  std::map<std::string, RL::Scan_pose> poses;
  std::size_t number = 0;
  for(std::string line; std::getline(in, line);) {
    ++number;
    std::istringstream words(line);
    std::string name;
    if(!(words >> name) || name[0] == '#')
      continue;
    const std::string where = "'" + file + "': line " + std::to_string(number);
    const RL::Scan_pose pose = internal::read_pose(words, where);
    require(poses.emplace(name, pose).second, where + ": '" + name + "' has a pose already");
  }
  require(!poses.empty(), "'" + file + "' holds no pose");
  return poses;
}

// The pose of the file of a scan: that of its path as given, else that of its name without folders.
inline const RL::Scan_pose& pose_of(const std::map<std::string, RL::Scan_pose>& poses,
                                    const std::string& scan, const std::string& file) {
  for(const std::string& name : {scan, std::filesystem::path(scan).filename().string()}) {
    const auto pose = poses.find(name);
    if(pose != poses.end())
      return pose->second;
  }
  throw Error("'" + file + "' has no pose for '" + scan + "'");
}

} // namespace programs

#endif // RESTRICTED_LAPLACIAN_3_PROGRAMS_POSES_H

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FILES_VERTEX_PROPERTY_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FILES_VERTEX_PROPERTY_H

#include <string>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Functions
/// Numbers that a file holds at its vertices.
struct Vertex_property {
  /// its name in the file; where the file has none: `nx`, `ny`, `nz` of normals, `red`, `green`,
  /// `blue`, `alpha` of colors, `s`, `t` of texture coordinates
  std::string name;
  /// `int8`, `uint8`, `int16`, `uint16`, `int32`, `uint32`, `int64`, `uint64`, `float32` or
  /// `float64`: colors that are integers reach from 0 to the largest one of their type, others from
  /// 0 to 1
  std::string type;
  /// one for each vertex
  std::vector<double> values;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FILES_VERTEX_PROPERTY_H

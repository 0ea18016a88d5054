// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapes.h"

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>

namespace shapes {

Mesh read(const std::string& path) {
  Mesh result;
  if(!path.empty())
    CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(path, result);
  return result;
}

} // namespace shapes

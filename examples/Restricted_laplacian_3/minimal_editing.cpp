// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// A surface without its small details, with twice of them, and with those of one side only.

#include <CGAL/Restricted_laplacian_3/edit_surface.h>
#include <CGAL/Restricted_laplacian_3/smooth_surface.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <iostream>
#include <stdexcept>
#include <string>

namespace RL = CGAL::Restricted_laplacian_3;
namespace PMP = CGAL::Polygon_mesh_processing;

int main(int argc, char* argv[]) try {
  CGAL::Surface_mesh<RL::Point_3> mesh;
  if(argc != 2 || !PMP::IO::read_polygon_mesh(argv[1], mesh))
    throw std::invalid_argument("usage: minimal_editing MESH");
  const double area = PMP::area(mesh), length = 0.1 * std::sqrt(area);
  const auto show = [&](const std::string& what, const auto& edit) {
    CGAL::Surface_mesh<RL::Point_3> edited = mesh;
    const RL::Solve_report report = edit(edited);
    std::cout << what << ": area " << PMP::area(edited) / area << " of what it was, "
              << report.iterations << " systems or iterations\n";
  };
  // what is smaller than the length goes, or is doubled
  show("smooth", [&](auto& m) { return RL::smooth_surface(m, length, m.points()); });
  show("sharp", [&](auto& m) { return RL::sharpen_surface(m, length, 2, m.points()); });

  // gradients of positions are multiplied by 0 on one side, and by 1 on the other one
  const RL::Point_3 middle = PMP::centroid(mesh);
  const auto scale = [&](const RL::Surface_point& p) { return p.point.x() < middle.x() ? 0. : 1.; };
  show("smooth on one side", [&](auto& m) {
    return RL::edit_surface(m, scale, 1e3 / area, m.points(), RL::parameters::depth(6));
  });
} catch(const std::exception& e) {
  std::cerr << e.what() << '\n';
  return 1;
}

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The operator -div(D grad u) / rho in place of minus the Laplacian: the lower half of a surface
// conducts heat a hundred times as well as the upper half, or is twice as heavy, or conducts along
// the x axis only.

#include <CGAL/Restricted_laplacian_3/laplace_spectrum.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Core>

#include <iostream>

namespace RL = CGAL::Restricted_laplacian_3;

int main(int argc, char* argv[]) {
  CGAL::Surface_mesh<RL::Point_3> mesh;
  if(argc != 2 || !CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << "usage: two_materials MESH\n";
    return 1;
  }
  const RL::Spline_space_3 space(mesh, RL::parameters::depth(5));
  const double middle = space.surface().center().z();
  const auto is_low = [&](const RL::Surface_point& p) { return p.point.z() < middle; };

  RL::Surface_material conductor, heavy, directed;
  conductor.set_diffusion([&](const RL::Surface_point& p) { return is_low(p) ? 100. : 1.; });
  heavy.set_density([&](const RL::Surface_point& p) { return is_low(p) ? 2. : 1.; });
  directed.set_diffusion([](const RL::Surface_point&) {
    return Eigen::Matrix3d(Eigen::Vector3d(1, 0.01, 0.01).asDiagonal());
  });

  std::cout.precision(4);
  const auto print = [](const char* name, const RL::Spline_space_3& space) {
    const RL::Laplace_spectrum spectrum = RL::laplace_spectrum(space, 5);
    std::cout << name << ", eigenvalues times area:";
    for(int i = 1; i < 5; ++i)
      std::cout << ' ' << spectrum.eigenvalues[i] * spectrum.area;
    std::cout << '\n';
  };
  print("Laplacian", space);
  // the octree and the splines are those of `space`, and shared
  print("conductor", space.with_material(conductor));
  print("heavy", space.with_material(heavy));
  print("directed", space.with_material(directed));
}

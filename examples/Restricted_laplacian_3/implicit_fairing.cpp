// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// An application, written as the package writes its own: a function for any mesh with named
// parameters, made of the steps of the lower rooms. (RL::smooth_surface() has a better filter.)

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/problems/Poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_functions_3.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>

#include <stdexcept>

namespace RL = CGAL::Restricted_laplacian_3;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace params = RL::parameters;

/// Smooths a surface by one implicit step of the heat flow of its coordinates: the new ones solve
/// x - time * Laplacian x = x_0. What is smaller than the cells of the octree is lost.
/// \param time in units of area
template <class FaceGraph, class NamedParameters = params::Default_named_parameters>
RL::Solve_report fair_implicitly(FaceGraph& tm, double time,
                                 const NamedParameters& np = params::default_values()) {
  const RL::Spline_space_3 space(tm, np);
  Eigen::MatrixXd loads(space.dimension(), 3), coefficients;
  for(int axis = 0; axis < 3; ++axis)
    loads.col(axis) =
        RL::assemble_load(space, [axis](const RL::Surface_point& s) { return s.point[axis]; });
  // alpha x - Laplacian x = alpha x_0
  const double alpha = 1 / time;
  const RL::Solve_report report =
      RL::Poisson_solver(space, alpha, np).solve(alpha * loads, coefficients);

  const Eigen::MatrixXd values = RL::Spline_functions_3(space, coefficients).values_at_vertices();
  auto points = get_property_map(CGAL::vertex_point, tm);
  Eigen::Index row = 0;
  for(auto v : vertices(tm)) {
    const auto x = values.row(row++);
    if(!x.hasNaN()) // else no face uses it
      put(points, v, RL::Point_3(x[0], x[1], x[2]));
  }
  return report;
}

int main(int argc, char* argv[]) try {
  CGAL::Surface_mesh<RL::Point_3> mesh;
  if(argc != 3 || !PMP::IO::read_polygon_mesh(argv[1], mesh))
    throw std::invalid_argument("usage: implicit_fairing MESH OUTPUT");
  const double area = PMP::area(mesh);
  const RL::Solve_report report = fair_implicitly(mesh, 1e-4 * area, params::depth(7));
  std::cout << "the area falls from " << area << " to " << PMP::area(mesh) << '\n';
  return report.converged && CGAL::IO::write_polygon_mesh(argv[2], mesh) ? 0 : 1;
} catch(const std::exception& e) {
  std::cerr << e.what() << '\n';
  return 1;
}

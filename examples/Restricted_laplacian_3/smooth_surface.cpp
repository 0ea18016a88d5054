// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// An application that the package does not have, written as the package writes its own: a function
// for any mesh with named parameters, made of the steps of the lower rooms.

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/problems/make_poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_functions_3.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Core>

#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <system_error>

namespace RL = CGAL::Restricted_laplacian_3;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace params = RL::parameters;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

/// Smooths a surface by one implicit step of the heat flow of its coordinates: the new ones solve
/// x - time * Laplacian x = x_0. What is smaller than the cells of the octree is lost.
/// \param time in units of area
template <class FaceGraph, class NamedParameters = params::Default_named_parameters>
RL::Solve_report smooth_surface(FaceGraph& tm, double time,
                                const NamedParameters& np = params::default_values()) {
  if(!(time > 0))
    throw RL::Parameter_error("time", "must be positive");
  const double alpha = 1 / time; // alpha x - Laplacian x = alpha x_0
  const RL::Spline_space_3 space(tm, np);
  Eigen::MatrixXd loads(space.dimension(), 3), coefficients;
  for(int axis = 0; axis < 3; ++axis)
    loads.col(axis) = alpha * RL::assemble_load(space, [axis](const RL::Surface_point& s) {
                        return s.point[axis];
                      });
  const RL::Solve_report report =
      RL::make_poisson_solver(space, alpha, np).solve(loads, coefficients);

  const Eigen::MatrixXd values = RL::Spline_functions_3(space, coefficients).values_at_vertices();
  auto points = params::choose_parameter(params::get_parameter(np, CGAL::internal_np::vertex_point),
                                         get_property_map(CGAL::vertex_point, tm));
  using Point = typename boost::property_traits<decltype(points)>::value_type;
  Eigen::Index row = 0;
  for(auto v : vertices(tm)) {
    if(!values.row(row).hasNaN()) // not on the surface: no face uses it
      put(points, v, Point(values(row, 0), values(row, 1), values(row, 2)));
    ++row;
  }
  return report;
}

int main(int argc, char* argv[]) {
  Mesh mesh;
  if(argc != 3 || !PMP::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << "usage: smooth_surface MESH OUTPUT\n";
    return 1;
  }
  try {
    std::error_code ignored;
    if(std::filesystem::equivalent(argv[1], argv[2], ignored))
      throw std::runtime_error(std::string("would replace ") + argv[1]);
    if(!std::ofstream(argv[2], std::ios::app)) // now, not after the work
      throw std::runtime_error(std::string("cannot write ") + argv[2]);
    const double area = PMP::area(mesh);
    const RL::Solve_report report = smooth_surface(mesh, 1e-4 * area, params::depth(7));
    std::cout << "the area falls from " << area << " to " << PMP::area(mesh) << '\n';
    if(!CGAL::IO::write_polygon_mesh(argv[2], mesh))
      throw std::runtime_error(std::string("cannot write ") + argv[2]);
    return report.converged ? 0 : 1;
  } catch(const std::exception& e) {
    std::cerr << "smooth_surface: " << e.what() << '\n';
    return 1;
  }
}

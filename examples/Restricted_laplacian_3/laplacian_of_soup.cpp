// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// A surface that no halfedge structure holds: three unit squares on one common edge, one of them
// with vertices of its own. Points and polygons take the place of the mesh.

#include <CGAL/Restricted_laplacian_3/laplace_spectrum.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <array>
#include <exception>
#include <iostream>
#include <vector>

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;
using Point = CGAL::Simple_cartesian<double>::Point_3;

int main() try {
  const std::vector<Point> points = {{0, 0, 0},  {0, 0, 1},   // the common edge
                                     {1, 0, 0},  {1, 0, 1},   // first square
                                     {0, 1, 0},  {0, 1, 1},   // second square
                                     {0, 0, 0},  {0, 0, 1},   // the edge once more
                                     {-1, 0, 0}, {-1, 0, 1}}; // third square
  const std::vector<std::array<int, 4>> squares = {{0, 2, 3, 1}, {0, 4, 5, 1}, {6, 8, 9, 7}};
  const auto surface = RL::soup(points, squares);

  // The third square touches the others, but is not joined to them: one constant for each of the
  // two components is in the kernel.
  const RL::Laplace_spectrum apart = RL::laplace_spectrum(surface, 3, params::depth(5));
  std::cout << "as it is: " << apart.eigenvalues.transpose() << '\n';

  // Sides of polygons that lie along each other, up to a distance, are joined on request. The
  // surface is now a star of three squares; its first eigenvalue above 0 is pi^2 / 4, twice. Across
  // the common edge one of the two eigenfunctions has a kink, which splines only come near to.
  const auto joined = params::depth(5).joining_tolerance(1e-9);
  const RL::Laplace_spectrum star = RL::laplace_spectrum(surface, 3, joined);
  std::cout << "joined:   " << star.eigenvalues.transpose() << '\n';

  // property maps are indexed by the position of a point
  std::vector<double> u(points.size());
  const auto f = [](const RL::Surface_point& p) { return p.point.x(); };
  const RL::Solve_report report = RL::solve_poisson(surface, f, CGAL::make_property_map(u), joined);
  std::cout << "u at the ends of the squares: " << u[2] << ' ' << u[4] << ' ' << u[8] << '\n';
  return report.converged ? 0 : 1;
} catch(const std::exception& e) {
  std::cerr << "laplacian_of_soup: " << e.what() << '\n';
  return 1;
}

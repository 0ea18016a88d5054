// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Restricted_laplacian_3/laplace_spectrum.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <exception>
#include <iostream>

namespace RL = CGAL::Restricted_laplacian_3;
using Point_set = CGAL::Point_set_3<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char* argv[]) try {
  Point_set points;
  if(argc != 2 || !CGAL::IO::read_point_set(argv[1], points) || !points.has_normal_map()) {
    std::cerr << "usage: minimal_points POINTS_WITH_NORMALS\n";
    return 1;
  }
  // the area that each point stands for is estimated; there is no mesh
  const RL::Laplace_spectrum spectrum = RL::laplace_spectrum(points, 8);
  std::cout << "eigenvalues on an area of " << spectrum.area << ':';
  for(double eigenvalue : spectrum.eigenvalues)
    std::cout << ' ' << eigenvalue;
  std::cout << '\n';

  auto u = points.add_property_map<double>("u", 0).first;
  const auto f = [](const RL::Surface_point& s) { return s.point.z(); };
  const RL::Solve_report report = RL::solve_poisson(points, f, u);
  const auto [low, high] = std::minmax_element(u.begin(), u.end());
  std::cout << "u is between " << *low << " and " << *high << '\n';
  return report.converged && spectrum.report.converged ? 0 : 1;
} catch(const std::exception& e) {
  std::cerr << "minimal_points: " << e.what() << '\n';
  return 1;
}

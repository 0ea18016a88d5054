// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// A surface that is known better than by a mesh of it: a torus, of which a formula tells the
// nearest point. Area and first eigenvalue are those of its faces, of a smooth surface through its
// vertices, and of the torus itself, by a projection to it.

#include <CGAL/Restricted_laplacian_3/laplace_spectrum.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;

int main(int argc, char* argv[]) {
  const int n = argc > 1 ? std::atoi(argv[1]) : 20; // faces across, and twice as many around
  if(n < 3) {
    std::cerr << "usage: implicit_surface [N]\n";
    return 1;
  }
  // radii 1 and 0.4, around the z axis
  std::vector<RL::Point_3> points;
  std::vector<std::array<int, 4>> quads;
  for(int i = 0; i < 2 * n; ++i)
    for(int j = 0; j < n; ++j) {
      const double a = CGAL_PI * i / n, b = 2 * CGAL_PI * j / n, r = 1 + 0.4 * std::cos(b);
      points.emplace_back(r * std::cos(a), r * std::sin(a), 0.4 * std::sin(b));
      const int next_i = (i + 1) % (2 * n), next_j = (j + 1) % n;
      quads.push_back({i * n + j, next_i * n + j, next_i * n + next_j, i * n + next_j});
    }
  const auto projection = [](const RL::Point_3& p) {
    const double r = std::hypot(p.x(), p.y());
    const RL::Point_3 center(p.x() / r, p.y() / r, 0); // of the circle that p is nearest to
    const RL::Vector_3 v = p - center;
    return center + 0.4 / std::sqrt(v.squared_length()) * v;
  };

  const auto report = [&](const char* name, const auto& geometry) {
    const RL::Laplace_spectrum s = RL::laplace_spectrum(
        RL::soup(points, quads), 2, params::depth(5).eigenvalues_only(true).geometry(geometry));
    std::cout << name << ": area " << s.area << ", eigenvalue " << s.eigenvalues[1] << '\n';
  };
  std::cout.precision(8);
  report("flat", RL::Surface_geometry::flat);
  report("smooth", RL::Surface_geometry::smooth);
  report("projection", projection);
}

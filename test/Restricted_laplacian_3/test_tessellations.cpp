// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// A small version of the benchmark spectrum_study: the paper's figure 3.

#include "catch.h"
#include "shapes.h"

#include <CGAL/Restricted_laplacian_3/laplace_spectrum.h>

#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;

/// of `count` eigenvalues of the unit sphere the largest relative error of those of degree up to
/// 13, and how many are nearest to each l (l + 1)
struct Sphere_spectrum {
  static constexpr int largest_degree = 13, count = 200;

  explicit Sphere_spectrum(const Eigen::VectorXd& eigenvalues)
    : multiplicity(largest_degree + 2, 0) {
    REQUIRE(eigenvalues.size() == count);
    for(int i = 0; i < count; ++i) {
      // l^2 <= i < (l + 1)^2 for a number, and l (l + 1) is in the middle of the same interval
      const int l = static_cast<int>(std::sqrt(i)),
                found = static_cast<int>(std::sqrt((std::max)(0., eigenvalues[i])));
      if(found < static_cast<int>(multiplicity.size()))
        ++multiplicity[found];
      if(l > 0 && l <= largest_degree)
        error = (std::max)(error, std::abs(eigenvalues[i] / (l * (l + 1)) - 1));
    }
  }

  double error = 0;
  std::vector<int> multiplicity;
};

/// mean relative difference of the eigenvalues above 0
double mean_change(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  const Eigen::Index n = b.size() - 1;
  return ((a - b).tail(n).array() / b.tail(n).array()).abs().mean();
}

} // namespace

TEST_CASE("multiplicities_of_the_sphere_up_to_degree_13", "[spectrum][slow]") {
  const shapes::Mesh mesh = shapes::mesh(shapes::sphere(6));
  const RL::Laplace_spectrum spectrum =
      RL::laplace_spectrum(mesh, Sphere_spectrum::count, params::octree_depth(4));
  REQUIRE(spectrum.report.converged);
  const Sphere_spectrum sphere(spectrum.eigenvalues);
  for(int l = 0; l <= Sphere_spectrum::largest_degree; ++l) {
    INFO("degree " << l);
    CHECK(sphere.multiplicity[l] == 2 * l + 1);
  }
  CHECK(sphere.error <= 2e-3);
}

TEST_CASE("spectrum_stays_when_a_mesh_is_simplified", "[spectrum][slow]") {
  // QSlim moves the surface a little; what the spectrum changes beyond that is the fault of the
  // elements.
  const shapes::Mesh fine = shapes::read(cgal_mesh("bear.off"));
  if(fine.is_empty())
    SKIP_TEST("no such file: bear.off");
  const shapes::Mesh coarse = shapes::simplified(fine, fine.number_of_vertices() * 3 / 10);
  REQUIRE(coarse.number_of_vertices() == fine.number_of_vertices() * 3 / 10);
  REQUIRE(CGAL::is_closed(coarse));
  constexpr int count = 100;
  const double restricted =
      mean_change(RL::laplace_spectrum(coarse, count, params::octree_depth(4)).eigenvalues,
                  RL::laplace_spectrum(fine, count, params::octree_depth(4)).eigenvalues);
  const double cotangent = mean_change(RL::cotangent_spectrum(coarse, count).eigenvalues,
                                       RL::cotangent_spectrum(fine, count).eigenvalues);
  INFO("mean change: restricted " << restricted << ", cotangent " << cotangent);
  CHECK(restricted <= 1e-3);
  CHECK(restricted <= cotangent / 50);
}

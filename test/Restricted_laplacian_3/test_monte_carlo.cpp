// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Sums over random samples in place of integrals.

#include "catch.h"
#include "matrices.h"
#include "point_shapes.h"
#include "shapes.h"

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/integration/Monte_carlo.h>
#include <CGAL/Restricted_laplacian_3/laplace_spectrum.h>
#include <CGAL/Restricted_laplacian_3/problems/monte_carlo_error.h>
#include <CGAL/Restricted_laplacian_3/problems/shared/Running_mean.h>
#include <CGAL/Restricted_laplacian_3/spectra/smallest_eigenpairs.h>
#include <CGAL/Restricted_laplacian_3/surface/sample_surface.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;

RL::Spline_space_3 sampled_space(const shapes::Triangles& t, int depth, bool is_parallel = false) {
  const auto np = params::depth(depth);
  return is_parallel ? RL::Spline_space_3(RL::soup(t.points, t.faces),
                                          np.concurrency_tag(CGAL::Parallel_if_available_tag()))
                     : RL::Spline_space_3(RL::soup(t.points, t.faces), np);
}

/// all eigenvalues of it are different
shapes::Triangles three_sided_ellipsoid(int subdivisions) {
  shapes::Triangles t = shapes::sphere(subdivisions);
  for(RL::Point_3& p : t.points)
    p = RL::Point_3(p.x(), 0.8 * p.y(), 0.55 * p.z());
  return t;
}

/// slope of the line of least squares
double fitted_slope(const std::vector<double>& x, const std::vector<double>& y) {
  double mean_x = 0, mean_y = 0, xx = 0, xy = 0;
  for(std::size_t i = 0; i < x.size(); ++i) {
    mean_x += x[i] / x.size();
    mean_y += y[i] / x.size();
  }
  for(std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
  }
  return xy / xx;
}

/// slopes of the error of stiffness and mass matrix over the number of samples, logarithmic
std::array<double, 2> slopes_of_errors(const RL::Spline_space_3& space, RL::Sampling sampling) {
  const RL::Operators exact = RL::assemble_operators(space);
  std::vector<double> sizes, stiffness_errors, mass_errors;
  for(std::size_t number = 1000; number <= 256000; number *= 4) {
    double stiffness = 0, mass = 0;
    const int number_of_seeds = 4;
    for(int seed = 0; seed < number_of_seeds; ++seed) {
      const RL::Operators operators = RL::assemble_operators(
          space.integrated_by(RL::Monte_carlo(space.octree(), number, seed + number, sampling)));
      stiffness += (operators.stiffness.coeffs() - exact.stiffness.coeffs()).square().sum();
      mass += (operators.mass.coeffs() - exact.mass.coeffs()).square().sum();
    }
    sizes.push_back(std::log(static_cast<double>(number)));
    stiffness_errors.push_back(std::log(stiffness / number_of_seeds) / 2);
    mass_errors.push_back(std::log(mass / number_of_seeds) / 2);
  }
  return {fitted_slope(sizes, stiffness_errors), fitted_slope(sizes, mass_errors)};
}

/// Root mean squares, over entries of a matrix, of what should be normal numbers: the mean over
/// seeds minus the exact entry, over its standard error; and, minus 1, the ratio of the mean
/// squared error bar to the variance over the seeds.
struct Calibration {
  double bias, bars;
};

Calibration calibration_of_operators(const RL::Spline_space_3& space, RL::Sampling sampling) {
  const RL::Operators exact = RL::assemble_operators(space);
  const auto np = params::samples(2000).sampling(sampling);
  const int number_of_seeds = 100;
  RL::internal::Running_mean stiffness, bars;
  for(int seed = 0; seed < number_of_seeds; ++seed) {
    const RL::Estimated_operators estimate =
        RL::estimate_operators(space, space.depth(), np.seed(1 + seed));
    stiffness.add(estimate.operators.stiffness.coeffs());
    bars.add(estimate.standard_errors.stiffness.coeffs().square());
  }
  // entries that are large enough to be estimated by that many samples
  const double largest = exact.stiffness.coeffs().abs().maxCoeff();
  const Eigen::ArrayXd error = stiffness.standard_error();
  double bias = 0, variance = 0, squared_bars = 0;
  int count = 0;
  for(Eigen::Index i = 0; i < error.size(); ++i)
    if(std::abs(exact.stiffness.coeffs()[i]) > 0.1 * largest) {
      bias += std::pow((stiffness.mean()[i] - exact.stiffness.coeffs()[i]) / error[i], 2);
      variance += error[i] * error[i] * number_of_seeds;
      squared_bars += bars.mean()[i];
      ++count;
    }
  REQUIRE(count > 100);
  return {std::sqrt(bias / count), squared_bars / variance - 1};
}

} // namespace

TEST_CASE("matrices_of_samples_converge_with_their_square_root", "[monte_carlo][slow]") {
  const RL::Spline_space_3 space = sampled_space(shapes::sphere(3), 3);
  for(double slope : slopes_of_errors(space, RL::Sampling::independent)) {
    CHECK(slope >= -0.55);
    CHECK(slope <= -0.45);
  }
}

TEST_CASE("matrices_of_stratified_samples_converge_faster", "[monte_carlo][slow]") {
  const RL::Spline_space_3 space = sampled_space(shapes::sphere(3), 3);
  for(double slope : slopes_of_errors(space, RL::Sampling::stratified))
    CHECK(slope <= -0.85);
}

TEST_CASE("matrices_of_samples_are_unbiased_and_their_error_bars_right", "[monte_carlo][slow]") {
  const RL::Spline_space_3 space = sampled_space(three_sided_ellipsoid(2), 2);
  for(RL::Sampling sampling : {RL::Sampling::independent, RL::Sampling::stratified}) {
    const Calibration c = calibration_of_operators(space, sampling);
    CHECK(c.bias >= 0.7);
    CHECK(c.bias <= 1.3);
    CHECK(std::abs(c.bars) <= 0.1);
  }
}

TEST_CASE("sums_of_samples", "[monte_carlo]") {
  const RL::Spline_space_3 space = sampled_space(shapes::box(1, 0.7, 0.5, 4, 1), 3);
  for(RL::Sampling sampling : {RL::Sampling::independent, RL::Sampling::stratified}) {
    const RL::Operators operators = RL::assemble_operators(
        space.integrated_by(RL::Monte_carlo(space.octree(), 5000, 3, sampling)));
    CHECK(operators.mass.sum() == Approx(space.surface().area()).epsilon(1e-12));
    CHECK((operators.stiffness * Eigen::VectorXd::Ones(space.dimension())).cwiseAbs().maxCoeff() <=
          1e-12 * operators.stiffness.coeffs().maxCoeff());
  }
}

TEST_CASE("samples_are_uniformly_distributed", "[monte_carlo]") {
  // Faces of very different area, one of them with most of it.
  shapes::Triangles t = shapes::box(1, 1, 1, 3, 1);
  t.points.insert(t.points.end(), {{0, 0, 2}, {9, 0, 2}, {0, 9, 2}, {9, 9, 2}});
  const auto last = static_cast<std::uint32_t>(t.points.size() - 1);
  t.faces.push_back({last - 3, last - 2, last - 1});
  t.faces.push_back({last, last, last}); // degenerate
  const RL::Triangulated_surface_3 surface(t.points, t.faces);
  const std::size_t number = 100000;
  for(RL::Sampling sampling : {RL::Sampling::independent, RL::Sampling::stratified}) {
    const bool is_stratified = sampling == RL::Sampling::stratified;
    const auto samples = RL::sample_surface(surface, number, 5, sampling);
    std::vector<double> counts(surface.number_of_faces(), 0);
    // a grid of 16 x 16 parallelograms, of which 120 lie in a triangle
    std::vector<double> counts_of_parts(256, 0);
    bool are_valid = true;
    for(const RL::Surface_location& s : samples) {
      ++counts[s.face];
      const auto& b = s.barycentric;
      are_valid = are_valid && b[0] >= 0 && b[1] >= 0 && b[2] >= 0 &&
                  std::abs(b[0] + b[1] + b[2] - 1) <= 1e-14;
      if(s.face == surface.number_of_faces() - 2)
        ++counts_of_parts[static_cast<std::size_t>(15.999999 * b[1]) * 16 +
                          static_cast<std::size_t>(15.999999 * b[2])];
    }
    CHECK(are_valid);
    CHECK(counts.back() == 0);
    double chi_squared = 0;
    for(std::size_t f = 0; f + 1 < counts.size(); ++f) {
      const double expected = surface.area(f) / surface.area() * number;
      if(is_stratified)
        CHECK(std::abs(counts[f] - expected) <= 2);
      chi_squared += (counts[f] - expected) * (counts[f] - expected) / expected;
    }
    CHECK(chi_squared <= 54 + 5 * std::sqrt(2 * 54.)); // 55 faces
    double chi_squared_of_parts = 0;
    const double expected = counts[counts.size() - 2] * 2 / 256;
    for(std::size_t i = 0; i < 16; ++i)
      for(std::size_t j = 0; i + j < 15; ++j)
        chi_squared_of_parts += std::pow(counts_of_parts[16 * i + j] - expected, 2) / expected;
    CHECK(chi_squared_of_parts <= 120 + 5 * std::sqrt(2 * 120.));
    if(is_stratified) // far more evenly than by chance
      CHECK(chi_squared_of_parts <= 30);
    else
      CHECK(chi_squared_of_parts >= 120 - 5 * std::sqrt(2 * 120.));
  }
}

TEST_CASE("samples_do_not_depend_on_threads", "[monte_carlo][threads]") {
  const shapes::Triangles t = shapes::sphere(4);
  for(RL::Sampling sampling : {RL::Sampling::independent, RL::Sampling::stratified}) {
    const auto np = params::samples(50000).sampling(sampling).seed(7);
    const RL::Estimated_operators expected = RL::estimate_operators(sampled_space(t, 4), 4, np);
    RL::Monte_carlo_options options = np;
    CHECK(options.seed != 1234);
    options.seed = 1234;
    const auto mass = [&](const RL::Monte_carlo_options& of_mass) {
      return RL::estimate_operators(sampled_space(t, 4), 4, of_mass).operators.mass;
    };
    CHECK((mass(options).coeffs() == mass(np.seed(1234)).coeffs()).all());
    for(std::size_t threads : {1, 2}) {
#ifdef CGAL_LINKED_WITH_TBB
      const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
#endif
      INFO(threads << " threads");
      const RL::Estimated_operators found =
          RL::estimate_operators(sampled_space(t, 4, true), 4, np);
      CHECK((found.operators.stiffness.coeffs() == expected.operators.stiffness.coeffs()).all());
      CHECK((found.operators.mass.coeffs() == expected.operators.mass.coeffs()).all());
      CHECK((found.standard_errors.mass.coeffs() == expected.standard_errors.mass.coeffs()).all());
    }
    const RL::Estimated_operators other =
        RL::estimate_operators(sampled_space(t, 4), 4, np.seed(8));
    CHECK(relative_difference(other.operators.mass, expected.operators.mass) > 1e-4);
  }
}

TEST_CASE("estimated_eigenvalues_and_their_error_bars", "[monte_carlo]") {
  const RL::Spline_space_3 space = sampled_space(three_sided_ellipsoid(2), 2);
  const int k = 6;
  const RL::Operators exact_operators = RL::assemble_operators(space);
  const RL::Eigenpairs exact =
      RL::smallest_eigenpairs(exact_operators.stiffness, exact_operators.mass, k);
  const int number_of_seeds = 12;
  double sum = 0;
  for(int seed = 0; seed < number_of_seeds; ++seed) {
    const RL::Estimated_eigenvalues found =
        RL::estimate_eigenvalues(space, k, params::samples(40000).seed(100 + seed));
    REQUIRE(found.values.size() == k);
    CHECK(std::abs(found.values[0]) <= 1e-9);
    CHECK(found.standard_errors[0] <= 1e-9);
    for(int i = 1; i < k; ++i) {
      sum += std::pow((found.values[i] - exact.values[i]) / found.standard_errors[i], 2);
      CHECK(found.standard_errors[i] <= 0.02 * exact.values[i]);
    }
  }
  // about the root mean square of a variable with a t distribution with 9 degrees of freedom, 1.13
  const double rms = std::sqrt(sum / number_of_seeds / (k - 1));
  CHECK(rms >= 0.8);
  CHECK(rms <= 1.5);
}

TEST_CASE("spectrum_of_a_sphere_by_a_million_samples", "[monte_carlo][slow]") {
  const RL::Spline_space_3 space = sampled_space(shapes::sphere(6), 4);
  for(RL::Sampling sampling : {RL::Sampling::independent, RL::Sampling::stratified}) {
    const Eigen::VectorXd eigenvalues =
        RL::laplace_eigenpairs(
            space.integrated_by(RL::Monte_carlo(space.octree(), 1000000, 1, sampling)), 36)
            .eigenvalues;
    Eigen::Index i = 1;
    for(int l = 1; l <= 5; ++l)
      for(int multiplicity = 0; multiplicity < 2 * l + 1; ++multiplicity, ++i)
        CHECK(eigenvalues[i] ==
              Approx(l * (l + 1)).epsilon(sampling == RL::Sampling::stratified ? 1e-3 : 1e-2));
  }
}

TEST_CASE("options_of_estimates_outside_their_domain", "[monte_carlo]") {
  const RL::Spline_space_3 space = sampled_space(shapes::sphere(1), 1);
  CHECK_THROWS_AS(RL::estimate_operators(space, 1, params::batches(1)), RL::Parameter_error);
  CHECK_THROWS_AS(RL::estimate_operators(space, 1, params::samples(9)), RL::Parameter_error);
  CHECK_THROWS_AS(RL::estimate_operators(space, 2), RL::Parameter_error);
  CHECK_THROWS_AS(RL::estimate_eigenvalues(space, 0), RL::Parameter_error);
  CHECK_THROWS_AS(RL::sample_surface(space.surface(), 0, 1, RL::Sampling::stratified),
                  RL::Parameter_error);
  const std::vector<RL::Surface_location> one =
      RL::sample_surface(space.surface(), 1, 1, RL::Sampling::stratified);
  CHECK(one.size() == 1);
}

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Errors that are estimated from levels, against those that there are.

#include "catch.h"
#include "shapes.h"

#include <CGAL/Restricted_laplacian_3/estimate_curvature.h>
#include <CGAL/Restricted_laplacian_3/fit_function.h>
#include <CGAL/Restricted_laplacian_3/integrate_gradient_field.h>
#include <CGAL/Restricted_laplacian_3/laplace_spectrum.h>
#include <CGAL/Restricted_laplacian_3/problems/internal/level_estimate.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_functions_3.h>

#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;

/// an ellipsoid of few triangles, so that cells are smaller than facets, or of many
RL::Triangulated_surface_3 ellipsoid(int subdivisions, double scale = 1) {
  shapes::Triangles t = shapes::sphere(subdivisions);
  for(RL::Point_3& p : t.points)
    p = RL::Point_3(scale * p.x(), scale * 0.8 * p.y(), scale * 0.55 * p.z());
  return RL::read_surface(RL::soup(t.points, t.faces));
}

double largest_difference(const Eigen::VectorXd& values, const Eigen::VectorXd& exact) {
  const Eigen::Index n = exact.size() - 1;
  return ((values.tail(n) - exact.tail(n)).array() / exact.tail(n).array()).abs().maxCoeff();
}

/// of solutions in two spaces on one surface
double root_mean_square_difference(const RL::Spline_space_3& space, const Eigen::VectorXd& u,
                                   const RL::Spline_space_3& finer, const Eigen::VectorXd& exact) {
  const Eigen::MatrixXd e = RL::internal::values_over_surface(finer, exact);
  const auto places = RL::sample_surface(space.surface(), static_cast<std::size_t>(e.rows()), 1,
                                         RL::Sampling::stratified);
  const Eigen::MatrixXd v = RL::Spline_functions_3(space, u).values_at_locations(places);
  return (v - e).norm() / e.norm();
}

/// \param noise that comes from the eigenvalues of the coarser level, which are not exact
bool is_near(double estimate, double error, double most, double noise) {
  // where splines are smooth on the facets, the next error is smaller than a fourth
  return estimate >= error / 2 && estimate <= most * error + noise;
}

} // namespace

TEST_CASE("changes_are_continued_by_a_factor_from_two_to_four", "[estimates]") {
  using RL::internal::error_of_changes;
  CHECK(error_of_changes(3, 9) == Approx(1.5));
  CHECK(error_of_changes(3, 48) == Approx(1));
  CHECK(error_of_changes(3, 3) == Approx(3));
  CHECK(error_of_changes(3, 0) == Approx(3));
  CHECK(error_of_changes(3, std::numeric_limits<double>::quiet_NaN()) == Approx(3));
  CHECK(error_of_changes(0, 1) == 0);
  CHECK(error_of_changes(0, 0) == 0);
}

TEST_CASE("errors_of_eigenvalues_are_estimated", "[estimates]") {
  for(const int subdivisions : {0, 2, 5}) {
    const RL::Triangulated_surface_3 surface = ellipsoid(subdivisions);
    const RL::Spline_space_3 finest(surface, params::depth(6));
    const Eigen::VectorXd exact =
        RL::laplace_spectrum(finest, 16, params::eigenvalues_only(true).tolerance(1e-4))
            .extrapolated_eigenvalues;
    for(int depth = 4; depth <= 5; ++depth) {
      const RL::Spline_space_3 space(surface, params::depth(depth));
      const RL::Laplace_spectrum found = RL::laplace_spectrum(space, 16);
      const double error = largest_difference(found.eigenvalues, exact), most = depth == 4 ? 16 : 4;
      INFO(subdivisions << " subdivisions, depth " << depth << ": error " << error << ", estimate "
                        << found.report.estimated_error << ", of extrapolated "
                        << largest_difference(found.extrapolated_eigenvalues, exact));
      CHECK(found.report.is_estimate_trusted);
      REQUIRE(found.estimated_errors.size() == 16);
      CHECK(found.estimated_errors[0] == 0);
      CHECK(found.estimated_errors.maxCoeff() == Approx(found.report.estimated_error));
      CHECK(found.estimated_errors.minCoeff() >= 0);
      CHECK(is_near(found.report.estimated_error, error, most, 3e-4));
      // by a factorization on each level, too
      const RL::Laplace_spectrum factorized =
          RL::laplace_spectrum(space, 16, params::eigensolver(RL::Eigensolver::shift_invert));
      CHECK(is_near(factorized.report.estimated_error, error, most, 0));
    }
  }
}

TEST_CASE("errors_of_solutions_are_estimated", "[estimates]") {
  const RL::Triangulated_surface_3 surface = ellipsoid(3);
  const auto smooth = [](const RL::Surface_point& p) { return p.point.z() + p.point.x(); };
  const auto kink = [](const RL::Surface_point& p) { return std::abs(p.point.x() - 0.3); };
  const RL::Spline_space_3 finest(surface, params::depth(6));
  for(const RL::Surface_function_view f :
      {RL::Surface_function_view(smooth), RL::Surface_function_view(kink)})
    for(const bool is_screened : {false, true}) {
      const auto solve = [&](const RL::Spline_space_3& space, double tolerance) {
        return is_screened ? RL::solve_screened_poisson(space, f, 5., params::tolerance(tolerance))
                           : RL::solve_poisson(space, f, params::tolerance(tolerance));
      };
      const Eigen::VectorXd exact = solve(finest, 1e-6).coefficients;
      for(int depth = 4; depth <= 5; ++depth) {
        const RL::Spline_space_3 space(surface, params::depth(depth));
        const RL::Poisson_solution found = solve(space, 1e-4);
        double error = root_mean_square_difference(space, found.coefficients, finest, exact);
        INFO("screened: " << is_screened << ", depth " << depth << ": error " << error
                          << ", estimate " << found.estimated_error);
        CHECK(found.is_estimate_trusted);
        CHECK(found.estimated_error >= error / 2);
        CHECK(found.estimated_error <= 6 * error);
      }
    }
}

TEST_CASE("estimates_do_not_depend_on_units_or_threads", "[estimates]") {
  const auto f = [](double scale, double factor) {
    return [=](const RL::Surface_point& p) { return factor * (p.point.z() / scale + 0.2); };
  };
  const auto spectrum_of = [](const RL::Spline_space_3& space) {
    return RL::laplace_spectrum(space, 10).report.estimated_error;
  };
  const RL::Spline_space_3 space(ellipsoid(3), params::depth(4));
  const double of_spectrum = spectrum_of(space),
               of_solution = RL::solve_poisson(space, f(1, 1)).estimated_error;
  CHECK(of_solution > 0);
  for(const double scale : {1e-6, 1e6}) {
    const RL::Spline_space_3 scaled(ellipsoid(3, scale), params::depth(4));
    CHECK(spectrum_of(scaled) == Approx(of_spectrum).epsilon(1e-2));
    for(const double factor : {1e-6, 1e6})
      CHECK(RL::solve_poisson(scaled, f(scale, factor)).estimated_error ==
            Approx(of_solution).epsilon(1e-2));
  }
  const RL::Spline_space_3 parallel(
      ellipsoid(3), params::depth(4).concurrency_tag(CGAL::Parallel_if_available_tag()));
  CHECK(spectrum_of(parallel) == of_spectrum);
  CHECK(RL::solve_poisson(parallel, f(1, 1),
                          params::concurrency_tag(CGAL::Parallel_if_available_tag()))
            .estimated_error == of_solution);
}

TEST_CASE("what_is_not_known_is_not_estimated", "[estimates]") {
  const RL::Triangulated_surface_3 surface = ellipsoid(3);
  const auto f = [](const RL::Surface_point& p) { return p.point.z(); };
  const auto one = [](const RL::Surface_point&) { return 1.; };
  // a constant is exact
  const RL::Spline_space_3 space(surface, params::depth(4));
  CHECK(RL::solve_screened_poisson(space, one, 2.).estimated_error <= 1e-6);
  CHECK(RL::solve_poisson(space, one).estimated_error == 0);
  // no nested levels
  const RL::Spline_space_3 paper(surface, params::depth(4).paper(true));
  CHECK_FALSE(RL::laplace_spectrum(paper, 5).report.is_estimate_trusted);
  CHECK(RL::laplace_spectrum(paper, 5).estimated_errors.size() == 0);
  CHECK_FALSE(RL::solve_poisson(paper, f).is_estimate_trusted);
  // pieces that are smaller than cells: the number of unknowns grows slowly
  shapes::Triangles pieces;
  const shapes::Triangles sphere = shapes::sphere(2);
  for(const auto& t : sphere.faces)
    for(int i = 0; i < 3; ++i) {
      const auto first = static_cast<std::uint32_t>(pieces.points.size());
      if(i == 0)
        pieces.faces.push_back({first, first + 1, first + 2});
      const RL::Point_3 a = sphere.points[t[0]];
      pieces.points.push_back(a + 0.3 * (sphere.points[t[i]] - a));
    }
  const RL::Spline_space_3 crowded(RL::soup(pieces.points, pieces.faces), params::depth(4));
  CHECK_FALSE(RL::solve_poisson(crowded, f).is_estimate_trusted);
  // a space of so few unknowns that it is solved at once tells nothing
  const RL::Spline_space_3 small(RL::soup(sphere.points, sphere.faces), params::depth(1));
  CHECK(std::isnan(RL::solve_poisson(small, f).estimated_error));
}

TEST_CASE("spectra_have_the_accuracy_that_is_asked_for", "[estimates]") {
  shapes::Triangles t = shapes::sphere(3);
  for(RL::Point_3& p : t.points)
    p = RL::Point_3(p.x(), 0.8 * p.y(), 0.55 * p.z());
  const auto surface = RL::soup(t.points, t.faces);
  const Eigen::VectorXd exact =
      RL::laplace_spectrum(surface, 30, params::depth(6)).extrapolated_eigenvalues;
  std::vector<Eigen::Index> unknowns;
  for(const double accuracy : {0.1, 1e-2, 1e-3}) {
    const RL::Laplace_spectrum found =
        RL::laplace_spectrum(surface, 30, params::accuracy(accuracy));
    INFO("accuracy " << accuracy << ", estimate " << found.report.estimated_error << ", error "
                     << largest_difference(found.eigenvalues, exact));
    CHECK(found.report.converged);
    CHECK(found.report.estimated_error <= accuracy);
    CHECK(largest_difference(found.eigenvalues, exact) <= accuracy);
    CHECK(found.vertex_values.rows() == static_cast<Eigen::Index>(t.points.size()));
    CHECK(found.vertex_values.cols() == 30);
    unknowns.push_back(found.pairs.vectors.rows());
  }
  CHECK(unknowns[0] < unknowns[2]);
  // many pairs need many unknowns
  const RL::Laplace_spectrum many =
      RL::laplace_spectrum(surface, 110, params::accuracy(0.2).eigenvalues_only(true));
  CHECK(many.pairs.vectors.rows() >= 2200);
  CHECK(many.report.estimated_error <= 0.2);
  CHECK(many.vertex_values.size() == 0);
}

TEST_CASE("solutions_have_the_accuracy_that_is_asked_for", "[estimates]") {
  shapes::Triangles t = shapes::sphere(4);
  const auto surface = RL::soup(t.points, t.faces);
  // a harmonic of degree 10 (its zonal one), for which the coarsest space is too coarse
  const auto harmonic = [](const RL::Surface_point& p) {
    const double z = p.point.z() / std::sqrt((p.point - CGAL::ORIGIN).squared_length()), x = z * z;
    return ((((46189 * x - 109395) * x + 90090) * x - 30030) * x + 3465) * x / 256 - 63. / 256;
  };
  const auto solve = [&](const auto& f, const auto& np) {
    std::vector<double> u(t.points.size());
    const RL::Solve_report report = RL::solve_poisson(surface, f, CGAL::make_property_map(u), np);
    return std::make_pair(u, report);
  };
  const auto difference = [](const std::vector<double>& u, const std::vector<double>& exact) {
    double sum = 0, all = 0;
    for(std::size_t v = 0; v < u.size(); ++v) {
      sum += (u[v] - exact[v]) * (u[v] - exact[v]);
      all += exact[v] * exact[v];
    }
    return std::sqrt(sum / all);
  };
  const auto exact = solve(harmonic, params::depth(6).tolerance(1e-6)).first;
  for(const double accuracy : {1e-1, 1e-2, 1e-3}) {
    const auto [u, report] = solve(harmonic, params::accuracy(accuracy));
    INFO("accuracy " << accuracy << ", estimate " << report.estimated_error << ", error "
                     << difference(u, exact));
    CHECK(report.converged);
    CHECK(report.estimated_error <= accuracy);
    CHECK(difference(u, exact) <= 1.5 * accuracy);
  }
}

TEST_CASE("what_is_narrower_than_the_first_cells_is_found", "[estimates]") {
  // a bump a third as wide as the cells that the search begins with, on a finer mesh
  const shapes::Triangles t = shapes::sphere(6);
  const auto surface = RL::soup(t.points, t.faces);
  const double width = 0.04;
  const auto bump = [width](const RL::Surface_point& p) {
    return std::exp(-(p.point - RL::Point_3(0.5, 0.5, std::sqrt(0.5))).squared_length() /
                    (2 * width * width));
  };
  std::vector<double> u(t.points.size());
  const auto map = CGAL::make_property_map(u);
  const auto solve = [&](const auto& np) {
    const RL::Solve_report report = RL::solve_poisson(surface, bump, map, np);
    CHECK(report.converged);
    return u;
  };
  const std::vector<double> exact = solve(params::depth(7).tolerance(1e-6));
  for(const double accuracy : {1e-1, 1e-2}) {
    const std::vector<double> found = solve(params::accuracy(accuracy));
    double sum = 0, all = 0;
    for(std::size_t v = 0; v < u.size(); ++v) {
      sum += (found[v] - exact[v]) * (found[v] - exact[v]);
      all += exact[v] * exact[v];
    }
    INFO("accuracy " << accuracy << ", error " << std::sqrt(sum / all));
    CHECK(std::sqrt(sum / all) <= accuracy);
  }
  const RL::Fit_report fit = RL::fit_function(surface, bump, map, params::accuracy(1e-2));
  CHECK(fit.converged);
  CHECK(fit.root_mean_square_error() < 1.1e-2 * width / 2); // the root mean square of the bump
}

TEST_CASE("few_points_have_the_accuracy_that_is_asked_for", "[estimates]") {
  // whose deepest space has nothing coarser to compare with, unless the search begins there
  for(const int subdivisions : {5, 6}) {
    std::vector<RL::Point_3> points = shapes::sphere(subdivisions).points;
    std::vector<RL::Vector_3> normals;
    for(const RL::Point_3& p : points)
      normals.push_back(p - CGAL::ORIGIN);
    const auto surface = RL::point_set(points, normals);
    std::vector<double> u(points.size());
    const RL::Solve_report report = RL::solve_poisson(
        surface, [](const RL::Surface_point& p) { return p.point.z(); }, CGAL::make_property_map(u),
        params::accuracy(1e-2));
    CHECK(report.converged);
    CHECK(report.estimated_error <= 1e-2);
    for(std::size_t i = 0; i < points.size(); ++i)
      CHECK(-2 * u[i] == Approx(points[i].z()).margin(1e-2));
  }
}

TEST_CASE("problems_with_prescribed_values_have_the_accuracy_that_is_asked_for", "[estimates]") {
  // spaces are compared with each other
  const shapes::Triangles t = shapes::bumpy_square(12, 0.3, 2, 1);
  const auto surface = RL::soup(t.points, t.faces);
  const auto f = [](const RL::Surface_point& p) { return p.point.x(); };
  const auto on_boundary = [](const RL::Surface_point& p) { return p.point.x() * p.point.y(); };
  const auto solve = [&](const auto& np) {
    std::vector<double> u(t.points.size());
    const RL::Solve_report report =
        RL::solve_poisson(surface, f, CGAL::make_property_map(u), np.boundary_values(on_boundary));
    return std::make_pair(u, report);
  };
  const auto exact = solve(params::depth(7)).first;
  for(const double accuracy : {2e-2, 2e-3}) {
    const auto [u, report] = solve(params::accuracy(accuracy));
    double sum = 0, all = 0;
    for(std::size_t v = 0; v < u.size(); ++v) {
      sum += (u[v] - exact[v]) * (u[v] - exact[v]);
      all += exact[v] * exact[v];
    }
    INFO("accuracy " << accuracy << ", estimate " << report.estimated_error << ", error "
                     << std::sqrt(sum / all));
    CHECK(report.converged);
    CHECK(report.estimated_error <= accuracy);
    CHECK(std::sqrt(sum / all) <= 2 * accuracy);
  }
}

TEST_CASE("accuracy_that_cannot_be_reached_is_said", "[estimates]") {
  const shapes::Triangles t = shapes::sphere(2);
  const auto surface = RL::soup(t.points, t.faces);
  // less than depth 6 takes
  const auto few = params::maximum_memory(2e7).accuracy(1e-7);
  const RL::Laplace_spectrum found = RL::laplace_spectrum(surface, 10, few);
  CHECK(found.report.status == RL::Solve_status::inaccurate);
  CHECK_FALSE(found.report.converged);
  CHECK(found.report.estimated_error > 1e-7);
  CHECK(found.report.estimated_error < 1e-2);
  CHECK(found.eigenvalues.size() == 10);
  // depth 5 would do for a Poisson problem, and not for so many pairs
  const RL::Laplace_spectrum many = RL::laplace_spectrum(
      surface, 200, params::maximum_memory(5e7).accuracy(1e-7).eigenvalues_only(true));
  CHECK(many.report.status == RL::Solve_status::inaccurate);
  CHECK(many.eigenvalues.size() == 200);
  const auto f = [](const RL::Surface_point& p) { return p.point.z(); };
  std::vector<double> u(t.points.size());
  const RL::Solve_report report = RL::solve_poisson(surface, f, CGAL::make_property_map(u), few);
  CHECK(report.status == RL::Solve_status::inaccurate);
  CHECK(report.space_seconds > 0);
  // values at points hold less and less of the solution, which has no limit
  std::vector<double> prescribed(t.points.size(), std::numeric_limits<double>::quiet_NaN());
  prescribed[4] = 10;
  prescribed[5] = -10;
  CHECK(RL::solve_poisson(surface, f, CGAL::make_property_map(u),
                          params::maximum_memory(2e8).accuracy(1e-3).constraints(
                              CGAL::make_property_map(prescribed)))
            .status == RL::Solve_status::inaccurate);
  // the first space
  using Space_options = RL::Spline_space_options;
  CHECK(RL::Spline_space_3(surface, params::depth(3)).octree().cell_width(0) ==
        Approx(2 * Space_options::default_cube_scale).epsilon(0.06));
  CHECK(RL::laplace_spectrum(surface, 10, params::depth(3).accuracy(0.5)).pairs.vectors.rows() <
        1000);
  for(const double accuracy : {0., -1., 1., std::numeric_limits<double>::quiet_NaN()})
    CHECK_THROWS_AS(RL::laplace_spectrum(surface, 10, params::accuracy(accuracy)),
                    RL::Parameter_error);
}

TEST_CASE("fits_have_the_accuracy_that_is_asked_for", "[estimates]") {
  const shapes::Triangles t = shapes::sphere(4);
  const auto surface = RL::soup(t.points, t.faces);
  const RL::Spline_space_3 fine(surface, params::depth(6));
  const auto wave = [](const RL::Surface_point& p) { return 5 + std::sin(20 * p.point.x()); };
  std::vector<double> u(t.points.size());
  const auto map = CGAL::make_property_map(u);
  // the error against the function itself, where nothing is smoothed
  for(const double accuracy : {1e-1, 1e-2, 1e-3}) {
    const RL::Fit_report report = RL::fit_function(surface, wave, map, params::accuracy(accuracy));
    CHECK(report.converged);
    CHECK(report.is_estimate_trusted);
    CHECK(report.estimated_error <= accuracy);
    // of a sine of many waves
    CHECK(report.root_mean_square_error() ==
          Approx(report.estimated_error * std::sqrt(0.5)).epsilon(0.05));
  }
  // against the function that smoothing makes of it; the estimate is not exact
  const auto smoothing = params::smoothing(2e-3);
  const Eigen::MatrixXd exact = RL::fit_function(fine, wave, smoothing).coefficients;
  const Eigen::MatrixXd values = RL::Spline_functions_3(fine, exact).values_at_vertices();
  const double deviation = (values.array() - values.mean()).matrix().norm();
  for(const double accuracy : {3e-2, 3e-3}) {
    const RL::Fit_report report =
        RL::fit_function(surface, wave, map, smoothing.accuracy(accuracy));
    const double error =
        (Eigen::Map<const Eigen::VectorXd>(u.data(), values.rows()) - values).norm() / deviation;
    INFO("accuracy " << accuracy << ", estimate " << report.estimated_error << ", error " << error);
    CHECK(report.converged);
    CHECK(report.estimated_error <= accuracy);
    CHECK(error <= accuracy);
  }
  // the worst of several components counts, and a constant has no error
  const auto both = [&](const RL::Surface_point& p) {
    return std::array<double, 3>{p.point.z(), wave(p), 7};
  };
  std::vector<std::array<double, 3>> three(t.points.size());
  const RL::Fit_report report =
      RL::fit_function(surface, both, CGAL::make_property_map(three), params::accuracy(1e-2));
  CHECK(report.estimated_error <= 1e-2);
  CHECK(report.estimated_error ==
        Approx(report.root_mean_square_errors[1] * std::sqrt(2)).epsilon(0.05));
  // a step has no such fit: that is seen long before the memory ends
  const shapes::Triangles bar = shapes::box(1, 0.1, 0.1, 3, 1);
  std::vector<double> of_bar(bar.points.size());
  const auto step = [](const RL::Surface_point& p) { return p.point.x() > 0.4 ? 1. : 0.; };
  const RL::Fit_report of_step =
      RL::fit_function(RL::soup(bar.points, bar.faces), step, CGAL::make_property_map(of_bar),
                       params::accuracy(1e-4).maximum_memory(4e9));
  CHECK(of_step.status == RL::Solve_status::inaccurate);
  CHECK(of_step.estimated_error > 1e-2);
}

TEST_CASE("gradient_fields_have_the_accuracy_that_is_asked_for", "[estimates]") {
  const shapes::Triangles t = shapes::sphere(4);
  const auto surface = RL::soup(t.points, t.faces);
  // the gradient of sin 6 x and a part that is orthogonal to all gradients
  const auto field = [](const RL::Surface_point& p) {
    const RL::Vector_3 along(6 * std::cos(6 * p.point.x()), 0, 0);
    return along + CGAL::cross_product(RL::Vector_3(0, 0, 1), p.point - CGAL::ORIGIN);
  };
  std::vector<double> u(t.points.size());
  const auto integrate = [&](const auto& np) {
    const RL::Gradient_report report =
        RL::integrate_gradient_field(surface, field, CGAL::make_property_map(u), np);
    return std::make_pair(u, report);
  };
  const auto exact = integrate(params::depth(7)).first;
  for(const double accuracy : {1e-1, 1e-2, 1e-3}) {
    const auto [found, report] = integrate(params::accuracy(accuracy).mean(3.));
    double sum = 0, all = 0;
    for(std::size_t v = 0; v < u.size(); ++v) {
      sum += (found[v] - 3 - exact[v]) * (found[v] - 3 - exact[v]);
      all += exact[v] * exact[v];
    }
    INFO("accuracy " << accuracy << ", estimate " << report.estimated_error << ", error "
                     << std::sqrt(sum / all));
    CHECK(report.converged);
    CHECK(report.estimated_error <= accuracy);
    CHECK(std::sqrt(sum / all) <= 1.5 * accuracy);
  }
}

TEST_CASE("curvature_has_the_accuracy_that_is_asked_for", "[estimates]") {
  // with the normals of the ellipsoid, and its curvature: 2 H = div n
  const double a = 1, b = 0.8, c = 0.55;
  shapes::Triangles t = shapes::sphere(5);
  std::vector<RL::Vector_3> normals;
  std::vector<double> exact;
  for(RL::Point_3& p : t.points) {
    p = RL::Point_3(a * p.x(), b * p.y(), c * p.z());
    const RL::Vector_3 g(p.x() / (a * a), p.y() / (b * b), p.z() / (c * c));
    const double s = g.squared_length();
    normals.push_back(g / std::sqrt(s));
    const double square = p.x() * p.x() + p.y() * p.y() + p.z() * p.z();
    exact.push_back((a * a + b * b + c * c - square) / (2 * a * a * b * b * c * c) /
                    std::pow(s, 1.5));
  }
  const double mean = std::accumulate(exact.begin(), exact.end(), 0.) / exact.size();
  std::vector<RL::Surface_curvature> curvatures(t.points.size());
  const auto map = CGAL::make_property_map(curvatures);
  for(const double accuracy : {1e-1, 2e-2}) {
    const RL::Fit_report report = RL::estimate_curvature(
        RL::soup(t.points, t.faces), map,
        params::accuracy(accuracy).vertex_normal_map(CGAL::make_property_map(normals)));
    double sum = 0, all = 0;
    for(std::size_t v = 0; v < exact.size(); ++v) {
      sum += (curvatures[v].mean - exact[v]) * (curvatures[v].mean - exact[v]);
      all += (exact[v] - mean) * (exact[v] - mean);
    }
    INFO("accuracy " << accuracy << ", estimate " << report.estimated_error << ", error "
                     << std::sqrt(sum / all));
    CHECK(report.converged);
    CHECK(report.estimated_error <= accuracy);
    CHECK(std::sqrt(sum / all) <= 1.5 * accuracy);
  }
  // edges have no curvature that a finer space would come near
  const shapes::Triangles cube = shapes::box(1, 1, 1, 3, 1);
  std::vector<RL::Surface_curvature> of_cube(cube.points.size());
  const RL::Fit_report report = RL::estimate_curvature(
      RL::soup(cube.points, cube.faces), CGAL::make_property_map(of_cube),
      params::accuracy(1e-2).method(RL::Curvature_method::face_normals).maximum_memory(1e9));
  CHECK(report.status == RL::Solve_status::inaccurate);
  CHECK(report.estimated_error > 0.1);
  // a depth that is given has no estimate of the curvature
  CHECK(std::isnan(
      RL::estimate_curvature(RL::soup(t.points, t.faces), map, params::depth(4)).estimated_error));
}

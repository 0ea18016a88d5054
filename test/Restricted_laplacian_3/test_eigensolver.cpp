// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "shapes.h"
#include "special_shapes.h"

#include <CGAL/Restricted_laplacian_3/foundation/internal/Single_blas_thread.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/symmetric_eigenpairs.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/vector_lanes.h>
#include <CGAL/Restricted_laplacian_3/laplace_spectrum.h>
#include <CGAL/Restricted_laplacian_3/problems/multigrid_levels.h>
#include <CGAL/Restricted_laplacian_3/solvers/Multigrid.h>
#include <CGAL/Restricted_laplacian_3/solvers/shared/Symmetric_matrix.h>
#include <CGAL/Restricted_laplacian_3/solvers/shared/panel_kernels.h>
#include <CGAL/Restricted_laplacian_3/spectra/internal/Column_panels.h>
#include <CGAL/Restricted_laplacian_3/spectra/internal/Nested_lobpcg.h>
#include <CGAL/Restricted_laplacian_3/spectra/internal/eigenproblem.h>
#include <CGAL/Restricted_laplacian_3/spectra/internal/largest_pairs.h>
#include <CGAL/Restricted_laplacian_3/spectra/multigrid_eigenpairs.h>
#include <CGAL/Restricted_laplacian_3/spectra/smallest_eigenpairs.h>
#include <CGAL/Restricted_laplacian_3/splines/prolongation.h>

#include <CGAL/assertions.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;
using shapes::Mesh;

struct Level_matrices {
  std::vector<RL::Sparse_matrix> stiffness, mass, prolongations;
  std::vector<RL::Smoothing_patches> patches;
};

Level_matrices level_matrices(const RL::Spline_space_3& space, int coarsest, double c = 1e-5) {
  std::vector<RL::Operators> operators = RL::assemble_operators_of_levels(
      space, coarsest, space.depth(), c, RL::Stabilized::stiffness);
  Level_matrices result;
  for(RL::Operators& o : operators) {
    result.stiffness.push_back(o.stiffness);
    result.mass.push_back(o.mass);
  }
  RL::Multigrid_levels levels = RL::multigrid_levels(space, coarsest);
  result.prolongations = std::move(levels.prolongations);
  result.patches = std::move(levels.patches);
  return result;
}

RL::Eigenpairs multigrid_pairs(const Level_matrices& m, int k,
                               const RL::Multigrid_eigenpairs_options& options) {
  return RL::multigrid_eigenpairs(m.stiffness, m.mass, m.prolongations, m.patches, k, options);
}

/// Compares with a factorization, and checks what the result promises.
void check_pairs(const Mesh& mesh, int depth, int k) {
  const RL::Spline_space_3 space(mesh, params::depth(depth));
  const Level_matrices m = level_matrices(space, 2);
  RL::Multigrid_eigenpairs_options options;
  options.tolerance = 1e-6;
  const RL::Eigenpairs pairs = multigrid_pairs(m, k, options);
  const RL::Eigenpairs expected = RL::smallest_eigenpairs(m.stiffness.back(), m.mass.back(), k);
  CHECK(pairs.converged);
  CHECK(pairs.iterations >= 2);
  CHECK(pairs.iterations <= 25);
  CHECK(pairs.shift == Approx(expected.shift));
  REQUIRE(pairs.values.size() == k);
  CHECK(std::is_sorted(pairs.values.begin(), pairs.values.end(), [](double a, double b) {
    return a < b * (1 - 1e-9) - 1e-9; // copies of an eigenvalue may be out of order by rounding
  }));
  for(int i = 0; i < k; ++i)
    CHECK(pairs.values[i] ==
          Approx(expected.values[i]).epsilon(1e-9).margin(1e-9 * expected.values[k - 1]));
  const Eigen::MatrixXd sx = m.stiffness.back() * pairs.vectors, mx = m.mass.back() * pairs.vectors;
  CHECK((pairs.vectors.transpose() * mx - Eigen::MatrixXd::Identity(k, k)).cwiseAbs().maxCoeff() <=
        1e-9);
  for(int i = 0; i < k; ++i) {
    const double residual = (sx.col(i) - pairs.values[i] * mx.col(i)).norm() /
                            (sx.col(i) - pairs.shift * mx.col(i)).norm();
    CHECK(residual <= 1e-6);
    CHECK(pairs.residuals[i] == Approx(residual).epsilon(1e-3).margin(1e-10));
    CHECK(pairs.vectors.col(i).maxCoeff() >= -pairs.vectors.col(i).minCoeff());
  }
}

/// Makes room between the columns. (A copy has none.)
void uncompress(RL::Sparse_matrix& a) {
  a.reserve(Eigen::VectorXi::Constant(a.cols(), 3));
  REQUIRE_FALSE(a.isCompressed());
}

} // namespace

TEST_CASE("multigrid_eigenpairs_are_those_of_a_factorization", "[eigensolver]") {
  check_pairs(shapes::mesh(shapes::sphere(5)), 4, 40);
  check_pairs(shapes::mesh(shapes::box(1, 0.7, 0.4, 6, 1)), 4, 30);
  // open, and several components, one of them in few cells
  check_pairs(shapes::mesh(shapes::stairs(3, 0.4)), 5, 25);
  const auto small_sphere = [](int n, double radius, const RL::Vector_3& center) {
    return shapes::moved(shapes::scaled(shapes::sphere(n), radius), center);
  };
  check_pairs(
      shapes::mesh(shapes::joined(shapes::sphere(4),
                                  shapes::joined(small_sphere(3, 0.4, RL::Vector_3(2, 0, 0)),
                                                 small_sphere(2, 0.02, RL::Vector_3(0, 1.5, 0))))),
      5, 30);
}

TEST_CASE("multigrid_eigenpairs_do_not_miss_copies_of_a_multiple_eigenvalue",
          "[eigensolver][slow]") {
  const RL::Spline_space_3 space(shapes::mesh(shapes::sphere(4)), params::depth(4));
  const Level_matrices m = level_matrices(space, 2);
  const Eigen::VectorXd expected =
      RL::smallest_eigenpairs(m.stiffness.back(), m.mass.back(), 40).values;
  for(int k = 1; k <= 40; k += 3) {
    const RL::Eigenpairs pairs = multigrid_pairs(m, k, {});
    CHECK(pairs.converged);
    REQUIRE(pairs.values.size() == k);
    CHECK((pairs.values - expected.head(k)).cwiseAbs().maxCoeff() <= 1e-5 * expected[39]);
  }
}

TEST_CASE("multigrid_eigenpairs_do_not_depend_on_threads_or_scale", "[eigensolver][threads]") {
  const shapes::Triangles box = shapes::box(1, 0.7, 0.4, 6, 1);
  const auto spectrum = [](const shapes::Triangles& t, bool is_parallel) {
    const auto np = params::depth(4).eigensolver(RL::Eigensolver::multigrid);
#ifdef CGAL_LINKED_WITH_TBB
    if(is_parallel)
      return RL::laplace_spectrum(shapes::mesh(t), 20, np.concurrency_tag(CGAL::Parallel_tag()));
#endif
    static_cast<void>(is_parallel);
    return RL::laplace_spectrum(shapes::mesh(t), 20, np);
  };
  const RL::Laplace_spectrum expected = spectrum(box, false), parallel = spectrum(box, true);
  REQUIRE(expected.report.converged);
  CHECK(expected.report.iterations > 0);
  CHECK(expected.eigenvalues == parallel.eigenvalues);
  CHECK(expected.pairs.vectors == parallel.pairs.vectors);
  for(double scale : {1e-80, 1e-12, 1e12, 1e80}) {
    shapes::Triangles scaled = box;
    for(RL::Point_3& p : scaled.points)
      p = CGAL::ORIGIN + scale * (p - CGAL::ORIGIN);
    const RL::Laplace_spectrum of_scaled = spectrum(scaled, false);
    CHECK(of_scaled.report.converged);
    CHECK((scale * scale * of_scaled.eigenvalues - expected.eigenvalues).cwiseAbs().maxCoeff() <=
          1e-8 * expected.eigenvalues[19]);
  }
}

TEST_CASE("multigrid_eigenpairs_say_when_they_have_not_converged", "[eigensolver]") {
  const RL::Spline_space_3 space(shapes::mesh(shapes::sphere(4)), params::depth(4));
  const Level_matrices m = level_matrices(space, 2);
  RL::Multigrid_eigenpairs_options options;
  options.maximum_iterations = 1;
  const RL::Eigenpairs few = multigrid_pairs(m, 20, options);
  CHECK_FALSE(few.converged);
  CHECK(few.iterations == 1);
  CHECK(few.residuals.maxCoeff() > options.tolerance);
  CHECK(few.values[1] == Approx(2.00637).epsilon(1e-4)); // our own output
  CHECK((few.vectors.transpose() * m.mass.back() * few.vectors - Eigen::MatrixXd::Identity(20, 20))
            .cwiseAbs()
            .maxCoeff() <= 1e-9);
  // a tolerance that cannot be reached ends the iteration, too
  options.maximum_iterations = 200;
  options.tolerance = 1e-18;
  const RL::Eigenpairs best = multigrid_pairs(m, 20, options);
  CHECK(best.status == RL::Solve_status::stalled);
  CHECK(best.iterations < 100); // how many depends on rounding, which processors differ in
  CHECK(best.residuals.maxCoeff() <= 1e-9);
}

TEST_CASE("pairs_that_come_within_the_number_do_not_stop_the_iteration", "[eigensolver]") {
  // a wheel with twelve teeth: a pair comes in, with a residual that is larger than all before
  constexpr int teeth = 12, per_tooth = 8, rings = 12;
  shapes::Triangles t;
  for(int j = 0; j <= rings; ++j)
    for(int i = 0; i < teeth * per_tooth; ++i) {
      const double angle = 2 * CGAL_PI * i / (teeth * per_tooth), s = double(j) / rings,
                   r = (1 + 0.25 * std::cos(teeth * angle)) *
                       std::sqrt((std::max)(0.02, 1 - std::pow(2 * s - 1, 4)));
      t.points.emplace_back(r * std::cos(angle), r * std::sin(angle), 0.3 * (s - 0.5));
    }
  const auto vertex = [](int j, int i) {
    return static_cast<std::uint32_t>(j * teeth * per_tooth + i % (teeth * per_tooth));
  };
  for(int j = 0; j < rings; ++j)
    for(int i = 0; i < teeth * per_tooth; ++i) {
      t.faces.push_back({vertex(j, i), vertex(j, i + 1), vertex(j + 1, i + 1)});
      t.faces.push_back({vertex(j, i), vertex(j + 1, i + 1), vertex(j + 1, i)});
    }
  const RL::Spline_space_3 space(shapes::mesh(t), params::depth(5));
  const RL::Laplace_spectrum spectrum =
      RL::laplace_eigenpairs(space, 62, params::eigensolver(RL::Eigensolver::multigrid));
  CHECK(spectrum.report.converged);
  CHECK(spectrum.report.status == RL::Solve_status::converged);
  CHECK(spectrum.eigensolver == RL::Eigensolver::multigrid);
  CHECK(spectrum.report.iterations < 20);
}

TEST_CASE("an_iteration_is_started_anew_once_for_each_growth", "[eigensolver]") {
  RL::internal::Convergence convergence(1e-3);
  const auto add = [&](std::initializer_list<double> residuals) {
    for(const double r : residuals)
      convergence.add(r);
  };
  add({0.1, 0.03, 0.01, 0.015});
  CHECK_FALSE(convergence.has_grown());
  convergence.add(0.2);
  CHECK(convergence.has_grown());
  convergence.start_anew();
  // what comes now is compared with what follows the start
  add({0.2, 0.19});
  CHECK_FALSE(convergence.has_grown());
  CHECK_FALSE(convergence.stagnates());
  add({0.05, 0.01, 0.0009});
  CHECK_FALSE(convergence.has_grown());
  CHECK_FALSE(convergence.stagnates());
  CHECK(convergence.progress() == 1);
  SECTION("eight steps without gain are enough") {
    for(int step = 0; step < 7; ++step)
      convergence.add(0.0009);
    CHECK_FALSE(convergence.stagnates());
    convergence.add(0.0009);
    CHECK(convergence.stagnates());
  }
  SECTION("three starts without gain, too") {
    for(int start = 0; start < 3; ++start) {
      CHECK_FALSE(convergence.stagnates());
      add({0.0008, 0.002});
      CHECK(convergence.has_grown());
      convergence.start_anew();
    }
    CHECK(convergence.stagnates());
  }
}

TEST_CASE("a_start_level_that_cannot_be_solved_is_not_the_end", "[eigensolver]") {
  const RL::Spline_space_3 space(shapes::mesh(shapes::sphere(4)), params::depth(5));
  const Level_matrices intact = level_matrices(space, 2);
  Level_matrices broken = intact;
  // The iteration for 20 pairs begins on level 3. With a negative eigenvalue there is no factor,
  // while the cycles are for a matrix that remains definite.
  RL::Sparse_matrix& s = broken.stiffness[1];
  REQUIRE(s.rows() < 1000);
  s -= 1.5 * broken.mass[1];
  CHECK_THROWS_AS(RL::smallest_eigenpairs(s, broken.mass[1], 20), RL::Numerical_error);
  const RL::Eigenpairs expected = multigrid_pairs(intact, 20, {}),
                       pairs = multigrid_pairs(broken, 20, {});
  CHECK(pairs.converged);
  CHECK((pairs.values - expected.values).cwiseAbs().maxCoeff() <= 1e-4 * expected.values[19]);
}

TEST_CASE("a_factorization_follows_where_multigrid_stalls", "[eigensolver]") {
  // as good as no stabilization, and more accuracy than the cycles have so
  const auto hard = params::stabilization(1e-16).tolerance(1e-6);
  const auto mesh = shapes::mesh(shapes::ragged_square(12, 0.3, 1));
  const RL::Spline_space_3 space(mesh, params::depth(5));
  REQUIRE(space.dimension() > 5000); // automatic begins with multigrid
  const RL::Laplace_spectrum stalled =
      RL::laplace_eigenpairs(space, 9, hard.eigensolver(RL::Eigensolver::multigrid));
  CHECK(stalled.report.status == RL::Solve_status::stalled);
  CHECK(stalled.eigensolver == RL::Eigensolver::multigrid);
  const RL::Laplace_spectrum automatic = RL::laplace_eigenpairs(space, 9, hard);
  CHECK(automatic.report.converged);
  CHECK(automatic.eigensolver == RL::Eigensolver::shift_invert);
  REQUIRE(automatic.report.relative_residuals.size() == 9);
  CHECK(automatic.report.relative_residual <= 1e-6);
  CHECK((automatic.eigenvalues - stalled.eigenvalues).cwiseAbs().maxCoeff() <
        1e-6 * automatic.eigenvalues[8]);
  // not where memory does not allow it
  const RL::Spline_space_3 small(mesh, params::depth(5).maximum_memory(6e7));
  const RL::Laplace_spectrum in_small = RL::laplace_eigenpairs(small, 9, hard);
  CHECK(in_small.eigensolver == RL::Eigensolver::multigrid);
  CHECK(in_small.report.status == RL::Solve_status::stalled);
  // not where the iteration ended as it was asked to
  const RL::Laplace_spectrum ended = RL::laplace_eigenpairs(space, 9, hard.maximum_iterations(2));
  CHECK(ended.eigensolver == RL::Eigensolver::multigrid);
  CHECK(ended.report.status == RL::Solve_status::iteration_limit);
  CHECK(ended.report.iterations == 2);
  // better, and not good enough
  const RL::Laplace_spectrum impossible = RL::laplace_eigenpairs(space, 9, hard.tolerance(1e-18));
  CHECK(impossible.eigensolver == RL::Eigensolver::shift_invert);
  CHECK(impossible.report.status == RL::Solve_status::stalled);
}

TEST_CASE("factorizations_use_the_calling_thread", "[eigensolver]") {
  using RL::internal::number_of_blas_threads;
  const int before = number_of_blas_threads();
  if(before == 0)
    SKIP_TEST("the BLAS library does not say how many threads it has");
  const RL::Spline_space_3 space(shapes::mesh(shapes::sphere(3)), params::depth(4));
  const RL::Operators operators = RL::assemble_operators(space);
  const auto pairs_with = [&](int threads, const std::function<bool(double)>& callback) {
    RL::internal::set_number_of_blas_threads(threads);
    CHECK(number_of_blas_threads() == threads);
    RL::Eigenpairs_options options;
    options.progress = callback;
    RL::Eigenpairs pairs =
        RL::smallest_eigenpairs(operators.stiffness, operators.mass, 10, options);
    CHECK(number_of_blas_threads() == threads);
    return pairs;
  };
  std::set<int> numbers;
  const auto note = [&](double) {
    numbers.insert(number_of_blas_threads());
    return true;
  };
  const RL::Eigenpairs one = pairs_with(1, note), several = pairs_with(3, note);
  CHECK(numbers == std::set<int>{1});
  CHECK(one.values == several.values);
  CHECK(one.vectors == several.vectors);
  CHECK_THROWS_AS(pairs_with(3, [](double) { return false; }), RL::Canceled);
  CHECK(number_of_blas_threads() == 3);

  // on several threads at once, the last one to end restores
  std::vector<std::thread> threads;
  std::atomic<int> wrong{0};
  for(int i = 0; i < 8; ++i)
    threads.emplace_back([&wrong] {
      for(int j = 0; j < 1000; ++j) {
        const RL::internal::Single_blas_thread single, another;
        wrong += number_of_blas_threads() != 1;
      }
    });
  for(std::thread& thread : threads)
    thread.join();
  CHECK(wrong == 0);
  CHECK(number_of_blas_threads() == 3);
  RL::internal::set_number_of_blas_threads(before);
}

TEST_CASE("values_of_known_products_are_those_of_the_vectors", "[eigensolver]") {
  const RL::Spline_space_3 space(shapes::mesh(shapes::box(1, 0.7, 0.4, 6, 1)), params::depth(4));
  const Level_matrices m = level_matrices(space, 2);
  RL::Multigrid_eigenpairs_options options;
  for(double tolerance : {1e-2, 1e-6}) {
    options.tolerance = tolerance;
    options.eigenvalues_only = false;
    const RL::Eigenpairs verified = multigrid_pairs(m, 20, options);
    options.eigenvalues_only = true;
    const RL::Eigenpairs pairs = multigrid_pairs(m, 20, options);
    CHECK(pairs.converged);
    CHECK(pairs.iterations <= verified.iterations);
    // The last projection has improved pairs that had converged before.
    CHECK(pairs.residuals.maxCoeff() <= tolerance);
    CHECK((pairs.vectors.transpose() * m.mass.back() * pairs.vectors -
           Eigen::MatrixXd::Identity(20, 20))
              .cwiseAbs()
              .maxCoeff() <= 1e-9);
    for(int i = 0; i < 20; ++i) {
      const auto x = pairs.vectors.col(i);
      CHECK(x.dot(m.stiffness.back() * x) == Approx(pairs.values[i]).epsilon(1e-9).margin(1e-9));
      CHECK(pairs.values[i] == Approx(verified.values[i]).epsilon(1e-9).margin(1e-9));
    }
  }
}

TEST_CASE("vectors_that_have_converged_are_made_orthonormal", "[eigensolver]") {
  // Combinations of the eigenfunctions of a multiple eigenvalue have small residuals.
  const RL::Spline_space_3 space(shapes::mesh(shapes::sphere(4)), params::depth(4));
  Level_matrices m = level_matrices(space, 2);
  const Eigen::Index n = m.mass.back().cols();
  const RL::Eigenpairs exact = RL::smallest_eigenpairs(m.stiffness.back(), m.mass.back(), 16);
  Eigen::MatrixXd skewed = exact.vectors;
  skewed.col(2) += 0.7 * skewed.col(1);
  const RL::Sparse_matrix mass = m.mass.back();
  std::vector<RL::Sparse_matrix> coarse;
  for(std::size_t level = 0; level + 1 < m.mass.size(); ++level)
    coarse.push_back(m.stiffness[level] + m.mass[level]);
  RL::Sparse_matrix identity(n, n), a = m.stiffness.back() + mass;
  identity.setIdentity();
  const RL::Multigrid<> multigrid(std::move(a), {m.prolongations, m.patches, coarse});
  RL::internal::Symmetric_matrices<2> pencil;
  pencil.take_halves_of({&m.stiffness.back(), &m.mass.back()});
  const auto progress = [](double) {};
  for(bool is_verified : {false, true}) {
    RL::internal::Nested_lobpcg solver(multigrid, skewed, {1, exact.shift, 100, 1, false});
    solver.prolongate(m.patches.size(), identity, pencil);
    solver.improve(9, 1e-2, is_verified, progress);
    CHECK(solver.iterations() == 0);
    RL::Eigenpairs pairs;
    solver.take_pairs(9, pairs);
    const double largest =
        (pairs.vectors.transpose() * mass * pairs.vectors - Eigen::MatrixXd::Identity(9, 9))
            .cwiseAbs()
            .maxCoeff();
    if(is_verified)
      CHECK(largest <= 1e-9);
    else
      CHECK(largest > 0.1);
    for(int i = 0; i < 9; ++i) {
      CHECK(pairs.values[i] ==
            Approx(exact.values[i]).epsilon(is_verified ? 1e-8 : 1e-2).margin(1e-8));
      CHECK(pairs.residuals[i] <= 1e-2);
    }
  }
}

TEST_CASE("eigensolvers_report_progress_and_can_be_canceled", "[eigensolver]") {
  const Mesh mesh = shapes::mesh(shapes::sphere(4));
  for(RL::Eigensolver solver : {RL::Eigensolver::multigrid, RL::Eigensolver::shift_invert}) {
    std::vector<double> parts;
    const auto np = params::depth(4).eigensolver(solver);
    RL::laplace_spectrum(mesh, 20, np.progress([&parts](double part) {
      parts.push_back(part);
      return true;
    }));
    REQUIRE(parts.size() > 5);
    CHECK(parts.front() >= 0);
    CHECK(parts.back() <= 1);
    CHECK(parts.back() >= 0.7);
    CHECK(std::is_sorted(parts.begin(), parts.end()));
    for(std::size_t calls : {std::size_t(1), parts.size() / 2, parts.size()}) {
      std::size_t call = 0;
      const auto canceling = np.progress([&call, calls](double) { return ++call < calls; });
      CHECK_THROWS_AS(RL::laplace_spectrum(mesh, 20, canceling), RL::Canceled);
      CHECK(call == calls);
    }
  }
}

TEST_CASE("eigensolver_is_chosen_by_size_or_parameter", "[eigensolver]") {
  const Mesh mesh = shapes::mesh(shapes::sphere(4));
  const auto uses_multigrid = [&mesh](int depth, auto np) {
    const RL::Laplace_spectrum spectrum = RL::laplace_spectrum(mesh, 3, np.depth(depth));
    CHECK(spectrum.report.converged);
    CHECK(spectrum.eigenvalues[1] == Approx(2).epsilon(1e-2));
    return spectrum.pairs.regularization == 0;
  };
  const auto automatic = params::eigensolver(RL::Eigensolver::automatic);
  CHECK_FALSE(uses_multigrid(4, automatic));
  CHECK(uses_multigrid(5, automatic));
  CHECK(uses_multigrid(4, params::eigensolver(RL::Eigensolver::multigrid)));
  CHECK_FALSE(uses_multigrid(5, params::eigensolver(RL::Eigensolver::shift_invert)));
  CHECK_FALSE(uses_multigrid(5, params::paper(true)));
  CHECK_THROWS_AS(uses_multigrid(4, params::paper(true).eigensolver(RL::Eigensolver::multigrid)),
                  RL::Parameter_error);
}

TEST_CASE("equal_eigenvalues_of_many_parts_take_few_iterations", "[eigensolver]") {
  // twelve equal spheres in a row: twelve zeros, then three equal eigenvalues of each
  const int number = 12;
  const auto sphere = shapes::sphere(2);
  auto row = sphere;
  row.points.clear();
  row.faces.clear();
  for(int i = 0; i < number; ++i) {
    const std::size_t first = row.points.size();
    for(const auto& p : sphere.points)
      row.points.emplace_back(p.x() + 3 * i, p.y(), p.z());
    for(auto face : sphere.faces) {
      for(auto& v : face)
        v += static_cast<std::uint32_t>(first);
      row.faces.push_back(face);
    }
  }
  const RL::Laplace_spectrum spectrum =
      RL::laplace_spectrum(shapes::mesh(row), 20, params::depth(6));
  CHECK(spectrum.report.converged);
  CHECK(spectrum.pairs.vectors.rows() < 5000);
  CHECK(spectrum.eigensolver == RL::Eigensolver::multigrid);
  CHECK(spectrum.report.iterations < 20);
  for(Eigen::Index i = 0; i < 20; ++i)
    CHECK(spectrum.eigenvalues[i] == Approx(i < number ? 0 : 2).epsilon(0.2).margin(1e-6));
}

TEST_CASE("multigrid_eigenpairs_refuse_bad_input", "[eigensolver]") {
  const Mesh mesh = shapes::mesh(shapes::sphere(4));
  const RL::Spline_space_3 space(mesh, params::depth(4));
  const Level_matrices m = level_matrices(space, 2);
  RL::Multigrid_eigenpairs_options options;
  for(int k : {-1, 0})
    CHECK_THROWS_AS(multigrid_pairs(m, k, options), RL::Parameter_error);
  CHECK_THROWS_AS(multigrid_pairs(m, 1000000, options), RL::Parameter_error);
  CHECK_THROWS_AS(multigrid_pairs(m, std::numeric_limits<int>::max(), options),
                  RL::Parameter_error);
  for(double tolerance : {0., 1., -1., std::nan("")}) {
    options = {};
    options.tolerance = tolerance;
    CHECK_THROWS_AS(multigrid_pairs(m, 10, options), RL::Parameter_error);
  }
  options = {};
  options.smoothing_steps = 0;
  CHECK_THROWS_AS(multigrid_pairs(m, 10, options), RL::Parameter_error);
  options = {};
  options.maximum_iterations = -1;
  CHECK_THROWS_AS(multigrid_pairs(m, 10, options), RL::Parameter_error);
  options = {};
  Level_matrices bad = m;
  bad.mass.pop_back();
  CHECK_THROWS_AS(multigrid_pairs(bad, 10, options), RL::Parameter_error);
  bad = m;
  bad.mass[1].valuePtr()[7] = std::nan("");
  CHECK_THROWS_AS(multigrid_pairs(bad, 10, options), RL::Parameter_error);
  bad = m;
  std::swap(bad.prolongations[0], bad.prolongations[1]);
  CHECK_THROWS_AS(multigrid_pairs(bad, 10, options), RL::Parameter_error);
  bad = m;
  bad.patches.pop_back();
  CHECK_THROWS_AS(multigrid_pairs(bad, 10, options), RL::Parameter_error);
  CHECK_THROWS_AS(RL::multigrid_eigenpairs({}, {}, {}, {}, 10), RL::Parameter_error);
}

TEST_CASE("stabilization_of_the_mass_matrix_can_be_left_out", "[eigensolver]") {
  const RL::Spline_space_3 space(shapes::mesh(shapes::sphere(3)), params::depth(3));
  const RL::Operators plain = RL::assemble_operators(space, 3),
                      both = RL::assemble_operators(space, 3, 0.1),
                      one = RL::assemble_operators(space, 3, 0.1, RL::Stabilized::stiffness);
  const auto difference = [](const RL::Sparse_matrix& a, const RL::Sparse_matrix& b) {
    return (a - b).norm() / b.norm();
  };
  CHECK(difference(one.stiffness, both.stiffness) <= 1e-14);
  CHECK(difference(one.stiffness, plain.stiffness) >= 1e-3);
  CHECK(difference(one.mass, plain.mass) <= 1e-14);
  CHECK(difference(both.mass, plain.mass) >= 1e-3);
}

TEST_CASE("panels_are_multiplied_as_matrices", "[eigensolver][threads]") {
  constexpr int width = RL::internal::panel_width, rows = 1037;
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto random = [&](Eigen::Index n, Eigen::Index m) -> Eigen::MatrixXd {
    return Eigen::MatrixXd::NullaryExpr(n, m, [&]() { return uniform(generator); });
  };
  RL::internal::Column_panels<double> x(rows, 11);
  RL::internal::Column_panels<float> p(rows, 6), result(rows, 13);
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(rows, 3 * width);
  for(int i = 0; i < rows; ++i) {
    for(int j = 0; j < 11; ++j)
      all(i, j) = x.column(j)[width * i] = uniform(generator);
    for(int j = 0; j < 6; ++j)
      all(i, 2 * width + j) = p.column(j)[width * i] = static_cast<float>(uniform(generator));
  }
  std::vector<RL::internal::Panel_view> panels;
  add_views(x, panels);
  add_views(p, panels);
  REQUIRE(panels.size() == 3);
  const RL::internal::Block_vector<width> b = random(rows, width), c = random(rows, width);
  for(std::size_t count : {2, 3})
    for(bool is_parallel : {false, true}) {
      const auto [of_b, of_c] = RL::internal::scalar_products(is_parallel, panels, count, b, c);
      const Eigen::MatrixXd some = all.leftCols(width * count);
      CHECK((of_b - some.transpose() * b).cwiseAbs().maxCoeff() <= 1e-12);
      CHECK((of_c - some.transpose() * c).cwiseAbs().maxCoeff() <= 1e-12);
    }
  const Eigen::MatrixXd of_x = random(3 * width, 11), of_p = random(3 * width, 13);
  RL::internal::combine(true, panels, of_x, x, of_p, result);
  const Eigen::MatrixXd expected = all * of_x, expected_p = all * of_p;
  for(int i = 0; i < rows; ++i) {
    for(int j = 0; j < 11; ++j)
      REQUIRE(x.column(j)[width * i] == Approx(expected(i, j)).margin(1e-13));
    for(int j = 0; j < 13; ++j)
      REQUIRE(result.column(j)[width * i] == Approx(expected_p(i, j)).margin(1e-5));
  }
}

#ifdef CGAL_RESTRICTED_LAPLACIAN_3_HAS_LANES
TEST_CASE("panel_kernels_for_vector_registers_equal_plain_ones", "[eigensolver]") {
  namespace internal = RL::internal;
  if(!internal::processor_has_lanes())
    SKIP_TEST("no vector registers of 256 bits");
  std::mt19937 generator(4);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto random = [&](std::size_t size) {
    std::vector<double> values(size);
    for(double& v : values)
      v = uniform(generator);
    return values;
  };
  // calls `run(sums, 0)`, 1 and 2 for what is plain, and for vectors of both sizes
  const auto compare = [&](std::size_t size, auto&& run) {
    const std::vector<double> start = random(size);
    std::array<std::vector<double>, 3> sums = {start, start, start};
    for(int kind = 0; kind < (internal::processor_has_wide_lanes() ? 3 : 2); ++kind)
      run(sums[kind].data(), kind);
    for(std::size_t i = 0; i < size; ++i)
      CHECK(sums[1][i] == Approx(sums[0][i]).margin(1e-14));
    CHECK((!internal::processor_has_wide_lanes() || sums[2] == sums[1]));
  };
  for(std::size_t rows : {1, 4, 7, 130}) {
    const std::vector<double> q = random(8 * rows), b = random(8 * rows), c = random(64);
    const std::vector<float> floats(q.begin(), q.end());
    compare(64, [&](double* sums, int kind) {
      kind == 0   ? internal::plain::add_scalar_products(q.data(), b.data(), rows, sums)
      : kind == 1 ? internal::lanes::add_scalar_products(q.data(), b.data(), rows, sums)
                  : internal::wide_lanes::add_scalar_products(q.data(), b.data(), rows, sums);
    });
    compare(64, [&](double* sums, int kind) {
      kind == 0   ? internal::plain::add_scalar_products(floats.data(), b.data(), rows, sums)
      : kind == 1 ? internal::lanes::add_scalar_products(floats.data(), b.data(), rows, sums)
                  : internal::wide_lanes::add_scalar_products(floats.data(), b.data(), rows, sums);
    });
    compare(8 * rows, [&](double* sums, int kind) {
      kind == 0   ? internal::plain::add_combination(q.data(), c.data(), rows, sums)
      : kind == 1 ? internal::lanes::add_combination(q.data(), c.data(), rows, sums)
                  : internal::wide_lanes::add_combination(q.data(), c.data(), rows, sums);
    });
  }
  // two matrices, rows 10 to 39, each at most once, as in a column; then the sums of the column
  const std::vector<double> first = random(9), second = random(9), x = random(8 * 40);
  const std::array<const double*, 2> values = {first.data(), second.data()};
  const std::array<int, 9> rows = {10, 11, 13, 17, 20, 21, 30, 38, 39};
  for(std::size_t count : {0, 1, 9})
    compare(2 * 8 * 30 + 16, [&](double* sums, int kind) {
      const std::array<double*, 2> to = {sums, sums + 8 * 30};
      double* const own = sums + 2 * 8 * 30;
      const internal::Column_entries column = {values.data(), rows.data(), count};
      const double* x_own = x.data() + 8;
      double* const* t = to.data();
      kind == 0 ? internal::plain::add_symmetric_column<8, 2>(column, x.data(), x_own, t, 10, own)
      : kind == 1
          ? internal::lanes::add_symmetric_column<8, 2>(column, x.data(), x_own, t, 10, own)
          : internal::wide_lanes::add_symmetric_column<8, 2>(column, x.data(), x_own, t, 10, own);
    });
}
#endif

TEST_CASE("eigensolvers_take_uncompressed_matrices", "[eigensolver]") {
  const RL::Spline_space_3 space(shapes::mesh(shapes::sphere(3)), params::depth(4));
  Level_matrices m = level_matrices(space, 2);
  const RL::Eigenpairs by_multigrid = multigrid_pairs(m, 10, {}),
                       by_factorization =
                           RL::smallest_eigenpairs(m.stiffness.back(), m.mass.back(), 10);
  REQUIRE(by_multigrid.iterations > 0);
  for(auto* matrices : {&m.stiffness, &m.mass, &m.prolongations})
    for(RL::Sparse_matrix& a : *matrices)
      uncompress(a);
  const RL::Eigenpairs pairs = RL::smallest_eigenpairs(m.stiffness.back(), m.mass.back(), 10);
  CHECK(pairs.shift == by_factorization.shift);
  CHECK(pairs.values == by_factorization.values);
  CHECK(RL::multigrid_eigenpairs(std::move(m.stiffness), std::move(m.mass),
                                 std::move(m.prolongations), std::move(m.patches), 10)
            .values == by_multigrid.values);
}

TEST_CASE("eigensolvers_name_a_matrix_with_an_entry_that_is_not_finite", "[eigensolver]") {
  const RL::Spline_space_3 space(shapes::mesh(shapes::sphere(3)), params::depth(3));
  for(double bad : {std::nan(""), std::numeric_limits<double>::infinity()})
    for(const char* name : {"s", "m"}) {
      RL::Operators o = RL::assemble_operators(space);
      (name[0] == 's' ? o.stiffness : o.mass).valuePtr()[100] = bad;
      const auto refused = [&](int k) -> std::string {
        try {
          RL::smallest_eigenpairs(o.stiffness, o.mass, k);
        } catch(const RL::Parameter_error& e) {
          return e.parameter();
        }
        return "nothing";
      };
      CHECK(refused(5) == name);
      CHECK(refused(static_cast<int>(space.dimension()) / 2) == name); // solved densely
    }
}

TEST_CASE("a_decomposition_that_fails_is_thrown", "[eigensolver]") {
  Eigen::MatrixXd a = Eigen::MatrixXd::Identity(5, 5);
  CHECK(RL::internal::symmetric_eigenpairs(a, "a").values == Eigen::VectorXd::Ones(5));
  a(3, 1) = a(1, 3) = std::nan("");
  CHECK_THROWS_WITH(RL::internal::symmetric_eigenpairs(a, "this matrix"),
                    "the eigenvalues of this matrix could not be computed");
  CHECK_THROWS_AS(RL::internal::symmetric_eigenpairs(a, "a"), RL::Numerical_error);
  CHECK_THROWS_AS(RL::internal::orthonormal_basis(a), RL::Numerical_error);
  CHECK_THROWS_AS(RL::internal::largest_pairs(a, a, 2), RL::Numerical_error);
}

TEST_CASE("largest_pairs_leave_dependent_directions_out", "[eigensolver]") {
  // M = C^T D C and A = C^T C with a matrix C of three rows: the values are those of D
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for(Eigen::Index columns : {3, 5}) {
    const Eigen::MatrixXd c =
        Eigen::MatrixXd::NullaryExpr(3, columns, [&]() { return uniform(generator); });
    const Eigen::VectorXd d = Eigen::Vector3d(2, 7, 3);
    const Eigen::MatrixXd m = c.transpose() * d.asDiagonal() * c, a = c.transpose() * c;
    const RL::internal::Dense_pairs pairs = RL::internal::largest_pairs(m, a, 2);
    CHECK(pairs.values[0] == Approx(7));
    CHECK(pairs.values[1] == Approx(3));
    CHECK((pairs.vectors.transpose() * a * pairs.vectors - Eigen::MatrixXd::Identity(2, 2))
              .cwiseAbs()
              .maxCoeff() <= 1e-10);
    CHECK(
        (m * pairs.vectors - a * pairs.vectors * pairs.values.asDiagonal()).cwiseAbs().maxCoeff() <=
        1e-10);
    if(columns == 5)
      CHECK_THROWS_AS(RL::internal::largest_pairs(m, a, 4), RL::Numerical_error);
  }
}

#ifndef NDEBUG
TEST_CASE("eigensolvers_check_symmetry_in_debug_builds", "[eigensolver]") {
  const RL::Spline_space_3 space(shapes::mesh(shapes::sphere(3)), params::depth(3));
  RL::Operators o = RL::assemble_operators(space);
  o.stiffness = o.stiffness.triangularView<Eigen::Upper>();
  CHECK_THROWS_AS(RL::smallest_eigenpairs(o.stiffness, o.mass, 5), CGAL::Precondition_exception);
}
#endif

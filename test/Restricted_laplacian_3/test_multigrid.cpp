// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// What a solver is made of, on small matrices, without a surface.

#include "catch.h"

#include <CGAL/Restricted_laplacian_3/solvers/Poisson_solver.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
using Sparse_matrix = Eigen::SparseMatrix<double>;

/// The Laplacian of a path of `n` unknowns, with a load term, and its linear prolongation.
Sparse_matrix path_matrix(int n, double shift) {
  Sparse_matrix a(n, n);
  std::vector<Eigen::Triplet<double>> entries;
  for(int i = 0; i < n; ++i) {
    entries.emplace_back(i, i, 2 + shift);
    if(i > 0) {
      entries.emplace_back(i, i - 1, -1);
      entries.emplace_back(i - 1, i, -1);
    }
  }
  a.setFromTriplets(entries.begin(), entries.end());
  return a;
}

Sparse_matrix path_prolongation(int n) {
  Sparse_matrix p(2 * n + 1, n);
  std::vector<Eigen::Triplet<double>> entries;
  for(int j = 0; j < n; ++j) {
    entries.emplace_back(2 * j, j, 0.5);
    entries.emplace_back(2 * j + 1, j, 1);
    entries.emplace_back(2 * j + 2, j, 0.5);
  }
  p.setFromTriplets(entries.begin(), entries.end());
  return p;
}

/// patches of `width` consecutive unknowns that overlap by half, in groups of `group`, in two
/// colors
RL::Smoothing_patches path_patches(int n, int width, int group) {
  RL::Smoothing_patches patches;
  std::vector<RL::internal::Number_lists::Pair> pairs;
  std::vector<int> starts;
  for(int begin = 0; begin == 0 || begin + width / 2 < n; begin += width / 2)
    starts.push_back(begin);
  std::uint32_t patch = 0;
  for(int color = 0; color < 2; ++color) {
    for(std::size_t first = color * group; first < starts.size(); first += 2 * group) {
      for(std::size_t k = first; k < first + group && k < starts.size(); ++k, ++patch)
        for(int i = starts[k]; i < std::min(n, starts[k] + width); ++i)
          pairs.emplace_back(patch, i);
      patches.groups.push_back(patch);
    }
    patches.colors.push_back(static_cast<std::uint32_t>(patches.groups.size() - 1));
  }
  patches.number_of_patches = patch;
  patches.unknowns = RL::internal::Number_lists(patch, pairs);
  return patches;
}

Eigen::VectorXd random_vector(Eigen::Index size, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  return Eigen::VectorXd::NullaryExpr(size, [&]() { return normal(generator); });
}

template <class Smoother> void check_cycle() {
  const int coarse = 15, fine = 2 * coarse + 1, finest = 2 * fine + 1;
  const Sparse_matrix a = path_matrix(finest, 0.01);
  const RL::Multigrid<Smoother> multigrid(a, {path_prolongation(coarse), path_prolongation(fine)},
                                          {path_patches(fine, 6, 2), path_patches(finest, 6, 2)});
  REQUIRE(multigrid.number_of_levels() == 3);
  typename RL::Multigrid<Smoother>::template Workspace<1> workspace;
  typename RL::Multigrid<Smoother>::template Workspace<8> workspace_8;
  for(RL::Cycle cycle : {RL::Cycle::V, RL::Cycle::W})
    for(int steps : {1, 2}) {
      const RL::internal::Block_vector<1> x = random_vector(finest, 1),
                                          y = random_vector(finest, 2);
      RL::internal::Block_vector<1> bx, by;
      multigrid.template apply<1>(x, bx, cycle, steps, workspace);
      multigrid.template apply<1>(y, by, cycle, steps, workspace);
      CHECK(bx.dot(y) == Approx(x.dot(by)).epsilon(1e-4));
      CHECK(bx.dot(x) > 0);
      // it is near to the inverse
      CHECK((x - a * bx).norm() <= 0.2 * x.norm());
      // eight vectors at once
      RL::internal::Block_vector<8> eight(finest, 8), result;
      eight.setZero();
      eight.col(0) = x;
      eight.col(1) = y;
      eight.col(3) = 1e30 * x;
      eight.col(7) = y;
      multigrid.template apply<8>(eight, result, cycle, steps, workspace_8);
      CHECK((result.col(0) - bx).norm() <= 1e-5 * bx.norm());
      CHECK((result.col(1) - by).norm() <= 1e-5 * by.norm());
      CHECK(result.col(2).norm() == 0);
      CHECK((result.col(3) - 1e30 * bx).norm() <= 1e25 * bx.norm());
      CHECK(result.col(7) == result.col(1));
    }
}

} // namespace

TEST_CASE("cycle_is_symmetric_and_near_to_the_inverse", "[multigrid]") {
  check_cycle<RL::Patch_smoother>();
  check_cycle<RL::Gauss_seidel_smoother>();
}

TEST_CASE("solution_is_in_double_precision", "[multigrid]") {
  const int fine = 511, finest = 2 * fine + 1;
  // entries of very different size, as those of elements that hardly reach the surface
  Eigen::VectorXd scale(finest);
  for(int i = 0; i < finest; ++i)
    scale[i] = std::pow(10., -6 * (i % 7 == 3) + 60);
  const Sparse_matrix a = scale.asDiagonal() * path_matrix(finest, 1e-6) * scale.asDiagonal();
  const Sparse_matrix p = scale.cwiseInverse().asDiagonal() * path_prolongation(fine);
  const Eigen::VectorXd expected = random_vector(finest, 5), b = a * expected;
  for(RL::Smoother smoother : {RL::Smoother::patch, RL::Smoother::point})
    for(bool is_parallel : {false, true}) {
      RL::Poisson_solver_options options;
      options.smoother = smoother;
      options.is_parallel = is_parallel;
      options.relative_tolerance = 1e-12;
      const RL::Poisson_solver solver(a, {p}, Eigen::VectorXd::Zero(finest), 0, options,
                                      {path_patches(finest, 8, 3)});
      Eigen::VectorXd x;
      const RL::Solve_report report = solver.solve(b, x);
      CHECK(report.converged);
      CHECK(report.iterations <= 20);
      CHECK(report.relative_residual == Approx((b - a * x).norm() / b.norm()).epsilon(1e-3));
      CHECK(report.relative_residual <= 1e-12);
      // another tolerance for the same solver
      CHECK(solver.solve(b, x, 0.1).iterations < report.iterations);
      CHECK_THROWS_AS(solver.solve(b, x, 0.), RL::Parameter_error);
    }
}

TEST_CASE("one_patch_of_everything_is_the_inverse", "[multigrid]") {
  const int n = 53;
  const Sparse_matrix a = path_matrix(n, 0.1);
  RL::Smoothing_patches patches = path_patches(n, 2 * n, 1);
  REQUIRE(patches.number_of_patches == 1);
  const RL::Patch_smoother smoother(a, patches);
  RL::Level_vectors<1> b, x, r;
  b.set_zero(smoother.positions().number_of_positions);
  const Eigen::VectorXd load = random_vector(n, 3);
  for(int i = 0; i < n; ++i)
    b.data()[smoother.positions().of_unknown[i]] =
        static_cast<float>(load[i] * smoother.scale()[i]);
  smoother.pre_smooth<1>(b, x, r, 1);
  Eigen::VectorXd solution(n);
  for(int i = 0; i < n; ++i)
    solution[i] = x.data()[smoother.positions().of_unknown[i]] * smoother.scale()[i];
  // up to the regularization, times the norm of the inverse
  CHECK((load - a * solution).norm() <= 2e-4 * load.norm());
  float largest = 0;
  for(int i = 0; i < n; ++i)
    largest = std::max(largest, std::abs(r.data()[smoother.positions().of_unknown[i]]));
  CHECK(largest <= 2e-4 * load.norm());
}

TEST_CASE("half_of_a_matrix_has_the_products_of_the_whole", "[multigrid]") {
  // several parts, empty rows, a missing diagonal entry
  for(int n : {1, 7, 1024, 20000}) {
    std::vector<Eigen::Triplet<double>> entries;
    for(int j = 0; j < n; j += 1 + j % 3)
      for(int i : {j, j / 2, j - 1, j - 500})
        if(i >= 0 && (i != j || j % 5 != 0)) {
          const double value = std::sin(i + 2. * j);
          entries.emplace_back(i, j, value);
          if(i != j)
            entries.emplace_back(j, i, value);
        }
    Eigen::SparseMatrix<double> a(n, n);
    a.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SparseMatrix<double> whole = a;
    RL::internal::Symmetric_matrix half;
    half.take_half_of(a);
    CHECK(a.nonZeros() == 0);
    CHECK(half.upper_half().nonZeros() <= (whole.nonZeros() + n) / 2);
    RL::internal::Block_vector<8> x(n, 8), y, r;
    for(int c = 0; c < 8; ++c)
      x.col(c) = random_vector(n, 20 + c);
    half.multiply<8>(x, y, false);
    CHECK((y - whole * x).norm() <= 1e-14 * y.norm());
    const RL::internal::Block_vector<8> sequential = y;
    half.multiply<8>(x, y, true);
    CHECK(y == sequential);
    half.residual<8>(x, y, r, true);
    CHECK((r - (x - whole * y)).norm() <= 1e-14 * r.norm());
    const RL::internal::Block_vector<1> x_1 = x.col(0);
    RL::internal::Block_vector<1> y_1;
    half.multiply<1>(x_1, y_1, false);
    CHECK((y_1 - whole * x_1).norm() <= 1e-14 * (1 + y_1.norm()));
  }
}

#ifdef __linux__
TEST_CASE("released_pages_are_empty_and_no_others", "[multigrid]") {
  constexpr std::size_t size = 1 << 20, page = 1 << 16;
  std::vector<double> values(size, 1.);
  RL::internal::release_pages(values.data() + size / 4, values.data() + size / 2);
  const auto sum = [&](std::size_t begin, std::size_t end) {
    double result = 0;
    for(std::size_t i = begin; i < end; ++i)
      result += values[i];
    return result;
  };
  CHECK(sum(0, size / 4) == size / 4);
  CHECK(sum(size / 4 + page / 8, size / 2 - page / 8) == 0);
  CHECK(sum(size / 2, size) == size / 2);
}
#endif

TEST_CASE("inverse_of_a_block_with_dependent_unknowns", "[multigrid]") {
  for(int size : {1, 3, 8, 27, 50}) {
    const int stride = (size + 7) / 8 * 8;
    // of rank `size`, then less: the last unknown repeats the first
    Eigen::MatrixXd factor = Eigen::MatrixXd::Identity(size, size);
    for(int i = 0; i < size; ++i)
      factor.col(i) += 0.3 * random_vector(size, 10 + i);
    for(bool is_singular : {false, true}) {
      if(is_singular && size > 1)
        factor.col(size - 1) = factor.col(0);
      const Eigen::MatrixXd a = factor.transpose() * factor;
      std::vector<double> stored(static_cast<std::size_t>(stride) * stride, 0.);
      for(int i = 0; i < size; ++i)
        for(int j = 0; j <= i; ++j)
          stored[stride * i + j] = a(i, j);
      RL::internal::Symmetric_inverse invert;
      invert(stored.data(), size, stride, 1e-9);
      Eigen::MatrixXd inverse(size, size);
      for(int i = 0; i < size; ++i)
        for(int j = 0; j <= i; ++j)
          inverse(i, j) = inverse(j, i) = stored[stride * i + j];
      if(!is_singular || size == 1)
        CHECK((a * inverse - Eigen::MatrixXd::Identity(size, size)).norm() <= 1e-9);
      else {
        CHECK(inverse.col(size - 1).norm() == 0);
        // a generalized inverse
        CHECK((a * inverse * a - a).norm() <= 1e-9 * a.norm());
      }
    }
  }
}

#ifdef CGAL_RESTRICTED_LAPLACIAN_3_HAS_LANES
TEST_CASE("kernels_for_vector_registers_equal_plain_ones", "[multigrid]") {
  if(!RL::internal::processor_has_lanes())
    SKIP_TEST("no vector registers of 256 bits");
  std::mt19937 generator(1);
  std::uniform_real_distribution<float> uniform(-1, 1);
  const auto random_floats = [&](std::size_t size) {
    RL::internal::Aligned_floats values(size);
    for(float& v : values)
      v = uniform(generator);
    return values;
  };
  const auto compare = [](const float* a, const float* b, std::size_t size) {
    for(std::size_t i = 0; i < size; ++i)
      CHECK(std::abs(a[i] - b[i]) <= 2e-5f);
  };
  for(std::size_t count : {0, 1, 5, 22}) {
    std::vector<std::uint32_t> columns;
    std::vector<RL::internal::Row_entry> entries;
    for(std::size_t k = 0; k < count; ++k) {
      columns.push_back(generator() % 64);
      entries.push_back({columns.back(), uniform(generator)});
    }
    const auto x = random_floats(8 * 64);
    for(int rows = 1; rows <= 8; ++rows) {
      const auto values = random_floats(rows * count + 7);
      auto sum = random_floats(64), same = sum;
      RL::internal::plain::subtract_columns<1>(values.data(), columns.data(), count, rows, x.data(),
                                               sum.data());
      RL::internal::lanes::subtract_columns<1>(values.data(), columns.data(), count, rows, x.data(),
                                               same.data());
      compare(sum.data(), same.data(), rows);
      RL::internal::plain::subtract_columns<8>(values.data(), columns.data(), count, rows, x.data(),
                                               sum.data());
      RL::internal::lanes::subtract_columns<8>(values.data(), columns.data(), count, rows, x.data(),
                                               same.data());
      compare(sum.data() + 8, same.data() + 8, 8 * rows - 8);
    }
    auto sum = random_floats(8), same = sum;
    RL::internal::plain::add_products<8>(entries.data(), count, -0.7f, x.data(), sum.data());
    RL::internal::lanes::add_products<8>(entries.data(), count, -0.7f, x.data(), same.data());
    compare(sum.data(), same.data(), 8);
  }
  for(int size : {1, 2, 7, 27, 33, 49, 64, 71}) {
    const int rows = (size + 7) / 8 * 8, number = rows / 8;
    const auto matrix = random_floats(32 * number * (number + 1)), from = random_floats(8 * rows);
    auto a = random_floats(8 * rows), b = random_floats(8 * rows);
    RL::internal::plain::multiply_symmetric<1>(matrix.data(), number, from.data(), a.data());
    RL::internal::lanes::multiply_symmetric<1>(matrix.data(), number, from.data(), b.data());
    compare(a.data(), b.data(), rows);
    RL::internal::plain::multiply_symmetric<8>(matrix.data(), number, from.data(), a.data());
    RL::internal::lanes::multiply_symmetric<8>(matrix.data(), number, from.data(), b.data());
    compare(a.data(), b.data(), 8 * rows);
    constexpr int vectors = RL::internal::pivots_of_a_sweep;
    std::vector<double> c(static_cast<std::size_t>(rows) * rows, 1.), d = c, p(vectors * rows),
                                                                      q(vectors * rows);
    for(std::size_t i = 0; i < p.size(); ++i) {
      p[i] = uniform(generator);
      q[i] = uniform(generator);
    }
    RL::internal::plain::subtract_outer_products(p.data(), q.data(), c.data(), size, rows);
    RL::internal::lanes::subtract_outer_products(p.data(), q.data(), d.data(), size, rows);
    for(int i = 0; i < size; ++i)
      for(int j = 0; j <= i; ++j)
        CHECK(c[rows * i + j] == Approx(d[rows * i + j]).margin(1e-14));
  }
}
#endif

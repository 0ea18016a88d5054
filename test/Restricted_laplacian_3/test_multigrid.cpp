// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// What a solver is made of, on small matrices, without a surface.

#include "catch.h"

#include <CGAL/Restricted_laplacian_3/foundation/internal/sum_counts.h>
#include <CGAL/Restricted_laplacian_3/solvers/Multigrid.h>
#include <CGAL/Restricted_laplacian_3/solvers/Multigrid_solver.h>
#include <CGAL/Restricted_laplacian_3/solvers/galerkin_product.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/Constant_deflation.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/Patch_groups.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/Regularized_inverse.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/Symmetric_inverse.h>

#include <Eigen/Dense>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <new>
#include <random>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

/// by operator new, in all
std::atomic<std::size_t> allocated_bytes(0);

} // namespace

// Sanitizers need their own operators; nothing is counted then.
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define ALLOCATIONS_ARE_NOT_COUNTED
#endif
#elif defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define ALLOCATIONS_ARE_NOT_COUNTED
#endif

#ifndef ALLOCATIONS_ARE_NOT_COUNTED
// Where only one of them is inlined, GCC takes them for a mismatch.
#ifdef __GNUC__
#define NOT_INLINED __attribute__((noinline))
#else
#define NOT_INLINED
#endif

NOT_INLINED void* operator new(std::size_t size) {
  allocated_bytes += size;
  if(void* const result = std::malloc(size > 0 ? size : 1))
    return result;
  throw std::bad_alloc();
}
NOT_INLINED void operator delete(void* p) noexcept { std::free(p); }
NOT_INLINED void operator delete(void* p, std::size_t) noexcept { std::free(p); }
#endif

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

/// Damped Jacobi iteration, which knows nothing but the concept.
class Jacobi_smoother {
public:
  Jacobi_smoother(const Sparse_matrix& a, const RL::Smoothing_patches&, bool)
    : m_a(a), m_factors(0.7 * a.diagonal().cwiseInverse()) {}

  void smooth(const Eigen::MatrixXd& b, Eigen::MatrixXd& x) const {
    x += m_factors.asDiagonal() * (b - m_a * x);
  }
  void smooth_transposed(const Eigen::MatrixXd& b, Eigen::MatrixXd& x) const { smooth(b, x); }

private:
  const Sparse_matrix& m_a;
  Eigen::VectorXd m_factors;
};

/// the patches through the concept, without their layout
class Plain_patch_smoother {
public:
  Plain_patch_smoother(const Sparse_matrix& a, const RL::Smoothing_patches& patches, bool parallel)
    : m_smoother(a, patches, parallel) {}

  void smooth(const Eigen::MatrixXd& b, Eigen::MatrixXd& x) const { m_smoother.smooth(b, x); }
  void smooth_transposed(const Eigen::MatrixXd& b, Eigen::MatrixXd& x) const {
    m_smoother.smooth_transposed(b, x);
  }

private:
  RL::Patch_smoother m_smoother;
};

constexpr int size_of_coarse = 15, size_of_fine = 2 * size_of_coarse + 1,
              size_of_finest = 2 * size_of_fine + 1;

RL::Multigrid_levels path_levels() {
  return {{path_prolongation(size_of_coarse), path_prolongation(size_of_fine)},
          {path_patches(size_of_fine, 6, 2), path_patches(size_of_finest, 6, 2)},
          {}};
}

/// \param bound of the part that a cycle leaves of a random vector
template <class Smoother> void check_cycle(double bound = 0.2) {
  const int finest = size_of_finest;
  const Sparse_matrix a = path_matrix(finest, 0.01);
  const RL::Multigrid<Smoother> multigrid(a, path_levels());
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
      CHECK((x - a * bx).norm() <= bound * x.norm());
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
  check_cycle<Jacobi_smoother>(0.6);
  check_cycle<Plain_patch_smoother>();
}

TEST_CASE("smoother_through_the_concept_gives_the_same_cycle", "[multigrid]") {
  const Sparse_matrix a = path_matrix(size_of_finest, 0.01);
  const RL::Multigrid<RL::Patch_smoother> fast(a, path_levels());
  const RL::Multigrid<Plain_patch_smoother> plain(a, path_levels());
  const RL::internal::Block_vector<1> b = random_vector(size_of_finest, 3);
  RL::internal::Block_vector<1> x, same;
  RL::Multigrid<RL::Patch_smoother>::Workspace<1> workspace;
  RL::Multigrid<Plain_patch_smoother>::Workspace<1> workspace_of_plain;
  for(int steps : {0, 1, 2}) {
    fast.apply<1>(b, x, RL::Cycle::W, steps, workspace);
    plain.apply<1>(b, same, RL::Cycle::W, steps, workspace_of_plain);
    CHECK((x - same).norm() <= 1e-5 * x.norm());
  }
}

TEST_CASE("hierarchy_takes_the_matrix_over", "[multigrid][threads]") {
  const Sparse_matrix whole = path_matrix(size_of_finest, 0.01);
  Sparse_matrix a = whole;
  const RL::Multigrid<> with(std::move(a), path_levels(), false, true);
  CHECK(a.nonZeros() == 0);
  CHECK((Eigen::MatrixXd(with.finest_matrix().upper_half()) -
         Eigen::MatrixXd(whole.triangularView<Eigen::Upper>()))
            .norm() == 0);
  const RL::Multigrid<> without(whole, path_levels());
  CHECK(without.finest_matrix().upper_half().nonZeros() == 0);
  const RL::Multigrid<Jacobi_smoother> of_jacobi(whole, path_levels(), false, true);
  CHECK(of_jacobi.finest_matrix().upper_half().nonZeros() ==
        with.finest_matrix().upper_half().nonZeros());
}

TEST_CASE("smoothers_read_one_half_of_the_matrix", "[multigrid]") {
  const int n = 200;
  const Sparse_matrix a = path_matrix(n, 0.1), half = a.triangularView<Eigen::Upper>();
  const RL::Smoothing_patches patches = path_patches(n, 6, 2);
  const Eigen::MatrixXd b = random_vector(n, 8);
  const auto compare = [&](const auto& of_whole, const auto& of_half) {
    Eigen::MatrixXd x = Eigen::MatrixXd::Zero(n, 1), same = x;
    of_whole.smooth(b, x);
    of_half.smooth(b, same);
    CHECK(x.norm() > 0);
    CHECK(x == same);
  };
  compare(RL::Patch_smoother(a, patches), RL::Patch_smoother(half, patches));
  compare(RL::Gauss_seidel_smoother(a, patches), RL::Gauss_seidel_smoother(half, patches));
}

TEST_CASE("half_of_the_matrix_is_enough", "[multigrid]") {
  const auto upper = [](const Sparse_matrix& a) -> Sparse_matrix {
    return a.triangularView<Eigen::Upper>();
  };
  // two components, one of them with a constant in the kernel
  const int n = size_of_finest;
  Sparse_matrix a = path_matrix(n, 0);
  a.coeffRef(0, 0) = a.coeffRef(9, 9) = a.coeffRef(10, 10) = 1;
  a.coeffRef(9, 10) = a.coeffRef(10, 9) = 0;
  a.prune(0.);
  const Eigen::VectorXd integrals = Eigen::VectorXd::Ones(n), b = random_vector(n, 7);
  RL::Multigrid_levels levels = path_levels(), halves = path_levels();
  const Sparse_matrix fine = RL::galerkin_product(a, levels.prolongations[1]);
  levels.coarse_matrices = {RL::galerkin_product(fine, levels.prolongations[0]), fine};
  for(const Sparse_matrix& coarse : levels.coarse_matrices)
    halves.coarse_matrices.push_back(upper(coarse));
  const RL::Multigrid_solver of_whole(a, levels, integrals);
  CHECK(of_whole.kernel_dimension() == 1);
  for(const RL::Multigrid_levels& l : {path_levels(), halves}) {
    const RL::Multigrid_solver of_half(upper(a), l, integrals);
    CHECK(of_half.kernel_dimension() == 1);
    Eigen::VectorXd x, same;
    static_cast<void>(of_whole.solve(b, x));
    CHECK(of_half.solve(b, same).converged);
    CHECK((x - same).norm() <= 1e-10 * x.norm());
  }
  const RL::internal::Block_vector<1> load = b;
  RL::internal::Block_vector<1> x, same;
  RL::Multigrid<Jacobi_smoother>::Workspace<1> workspace;
  RL::Multigrid<Jacobi_smoother>(a, levels).apply<1>(load, x, RL::Cycle::V, 1, workspace);
  RL::Multigrid<Jacobi_smoother>(upper(a), halves).apply<1>(load, same, RL::Cycle::V, 1, workspace);
  CHECK((x - same).norm() <= 1e-6 * x.norm());
  // the other half
  const Sparse_matrix lower = a.triangularView<Eigen::Lower>();
  CHECK_THROWS_AS(RL::Multigrid_solver(lower, path_levels(), integrals), RL::Parameter_error);
  halves.coarse_matrices[0] = halves.coarse_matrices[0].transpose();
  CHECK_THROWS_AS(RL::Multigrid_solver(a, halves, integrals), RL::Parameter_error);
}

TEST_CASE("matrices_that_are_not_compressed_give_the_same", "[multigrid]") {
  // makes room that is not used, with numbers that must not be read; a copy would have none
  const auto uncompress = [](Sparse_matrix& a) {
    a.reserve(Eigen::VectorXi::Constant(a.cols(), 3));
    for(int j = 0; j < a.cols(); ++j)
      for(int k = a.outerIndexPtr()[j] + a.innerNonZeroPtr()[j]; k < a.outerIndexPtr()[j + 1];
          ++k) {
        a.valuePtr()[k] = std::numeric_limits<double>::quiet_NaN();
        a.innerIndexPtr()[k] = 0;
      }
  };
  const Sparse_matrix a = path_matrix(size_of_finest, 0.01), p = path_prolongation(size_of_fine);
  Sparse_matrix loose = a, loose_p = p;
  uncompress(loose);
  uncompress(loose_p);
  REQUIRE_FALSE(loose.isCompressed());
  const Sparse_matrix product = RL::galerkin_product(a, p);
  CHECK((product - RL::galerkin_product(loose, loose_p)).norm() == 0);

  const RL::Smoothing_patches patches = path_patches(size_of_finest, 6, 2);
  const Eigen::MatrixXd load = random_vector(size_of_finest, 4);
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(size_of_finest, 1), found = expected;
  RL::Patch_smoother(a, patches).smooth(load, expected);
  RL::Patch_smoother(loose, patches).smooth(load, found);
  CHECK(found == expected);
  found.setZero();
  expected.setZero();
  RL::Gauss_seidel_smoother(a, patches).smooth(load, expected);
  RL::Gauss_seidel_smoother(loose, patches).smooth(load, found);
  CHECK(found == expected);

  const RL::internal::Block_vector<1> b = load;
  RL::internal::Block_vector<1> x, same;
  RL::Multigrid<>::Workspace<1> workspace;
  RL::Multigrid<>(a, path_levels()).apply<1>(b, x, RL::Cycle::V, 1, workspace);
  const auto loose_levels = [&] {
    RL::Multigrid_levels levels = path_levels();
    levels.coarse_matrices = {RL::galerkin_product(product, path_prolongation(size_of_coarse)),
                              product};
    for(Sparse_matrix& prolongation : levels.prolongations)
      uncompress(prolongation);
    for(Sparse_matrix& coarse : levels.coarse_matrices)
      uncompress(coarse);
    return levels;
  };
  RL::Multigrid<>(loose, loose_levels()).apply<1>(b, same, RL::Cycle::V, 1, workspace);
  CHECK(x == same);

  const Eigen::VectorXd integrals = Eigen::VectorXd::Ones(size_of_finest);
  Eigen::VectorXd solution, same_solution;
  static_cast<void>(RL::Multigrid_solver(a, path_levels(), integrals).solve(load.col(0), solution));
  static_cast<void>(
      RL::Multigrid_solver(loose, loose_levels(), integrals).solve(load.col(0), same_solution));
  CHECK(solution == same_solution);
}

TEST_CASE("matrices_are_taken_over_and_not_copied", "[multigrid]") {
  const Sparse_matrix a = path_matrix(size_of_finest, 0.01);
  const Eigen::VectorXd integrals = Eigen::VectorXd::Ones(size_of_finest);
  const auto is_left_empty = [&](auto&& last_argument) {
    Sparse_matrix taken = a;
    const RL::Multigrid_solver solver(std::move(taken), path_levels(), integrals, last_argument);
    return taken.size() == 0;
  };
  CHECK(is_left_empty(0.01));
  CHECK(is_left_empty(Eigen::VectorXd(0.01 * integrals)));
  const Sparse_matrix kept = a;
  static_cast<void>(RL::Multigrid_solver(kept, path_levels(), integrals));
  CHECK(kept.nonZeros() == a.nonZeros());
}

TEST_CASE("products_with_too_many_entries_are_refused", "[multigrid]") {
  std::vector<int> counts = {3, 0, 4};
  CHECK(RL::internal::sum_counts(counts.data(), 3, "a", "product") == 7);
  CHECK(counts == std::vector<int>{3, 3, 7});
  // just as many as an int can number, and one more
  counts = {1 << 30, (1 << 30) - 1, 0};
  CHECK(RL::internal::sum_counts(counts.data(), 3, "a", "product") ==
        std::numeric_limits<int>::max());
  counts = {1 << 30, (1 << 30) - 1, 1};
  CHECK_THROWS_AS(RL::internal::sum_counts(counts.data(), 3, "a", "product"), RL::Parameter_error);
}

TEST_CASE("galerkin_product_refuses_other_sizes", "[multigrid]") {
  CHECK_THROWS_AS(RL::galerkin_product(path_matrix(8, 0), path_prolongation(4)),
                  RL::Parameter_error);
}

TEST_CASE("setup_takes_memory_in_proportion_to_the_size", "[multigrid]") {
  // All that is allocated counts, also what is given back soon: arrays of the size of the problem
  // for each chunk of it would make four times the unknowns cost sixteen times as much.
  const auto bytes_of_setup = [](int coarse) {
    const int fine = 2 * coarse + 1;
    Sparse_matrix a = path_matrix(fine, 0.1);
    RL::Multigrid_levels levels = {{path_prolongation(coarse)}, {path_patches(fine, 2, 5)}, {}};
    // the coarsest level is dense
    Sparse_matrix identity(coarse, coarse);
    identity.setIdentity();
    levels.coarse_matrices.push_back(identity);
    const Sparse_matrix& p = levels.prolongations[0];
    std::size_t before = allocated_bytes;
    const Sparse_matrix product = RL::galerkin_product(a, p);
    const std::size_t of_product = allocated_bytes - before;
    before = allocated_bytes;
    const RL::Multigrid<> multigrid(std::move(a), std::move(levels));
    return std::make_pair(of_product, allocated_bytes - before);
  };
  const auto small = bytes_of_setup(20000), large = bytes_of_setup(80000);
  CHECK(large.first <= 4.5 * small.first);
  CHECK(large.second <= 4.5 * small.second);
}

TEST_CASE("clusters_do_not_mix_groups_that_run_at_the_same_time", "[multigrid][threads]") {
  const int n = 400;
  const Sparse_matrix a = path_matrix(n, 0.1);
  for(int width : {2, 4, 6, 10})
    for(int group : {2, 5}) {
      const RL::Smoothing_patches patches = path_patches(n, width, group);
      const RL::Patch_smoother smoother(a, patches);
      const std::vector<std::uint32_t>& position = smoother.positions().of_unknown;
      const std::size_t clusters = smoother.positions().number_of_clusters();
      for(std::size_t color = 0; color + 1 < patches.colors.size(); ++color) {
        // the groups that write an unknown, and those that read the rows of a cluster
        std::vector<int> writer(n, -1);
        std::vector<int> reader(clusters, -1);
        for(std::uint32_t g = patches.colors[color]; g < patches.colors[color + 1]; ++g)
          for(std::uint32_t p = patches.groups[g]; p < patches.groups[g + 1]; ++p)
            for(std::uint32_t i : patches.unknowns[p]) {
              writer[i] = static_cast<int>(g);
              int& of_cluster = reader[position[i] / 8];
              REQUIRE((of_cluster == -1 || of_cluster == static_cast<int>(g)));
              of_cluster = static_cast<int>(g);
            }
        for(int j = 0; j < n; ++j)
          for(Sparse_matrix::InnerIterator i(a, j); i; ++i) {
            const int of_cluster = reader[position[j] / 8];
            REQUIRE((of_cluster == -1 || writer[i.row()] == -1 || writer[i.row()] == of_cluster));
          }
      }
      // so threads make no difference
      const RL::Patch_smoother parallel(a, patches, true);
      const Eigen::MatrixXd b = random_vector(n, 9);
      Eigen::MatrixXd x = Eigen::MatrixXd::Zero(n, 1), same = x;
      smoother.smooth(b, x);
      parallel.smooth(b, same);
      CHECK(x == same);
    }
}

TEST_CASE("positions_of_no_unknown_have_no_influence", "[multigrid]") {
  const int n = 61;
  const Sparse_matrix a = path_matrix(n, 0.1);
  const RL::Patch_smoother smoother(a, path_patches(n, 6, 2));
  const RL::internal::Level_positions& positions = smoother.positions();
  REQUIRE(positions.number_of_positions > n);
  std::vector<char> is_used(positions.number_of_positions, 0);
  for(std::uint32_t position : positions.of_unknown)
    is_used[position] = 1;
  const auto check = [&](auto block) {
    constexpr int K = decltype(block)::value;
    using Vectors = RL::internal::Level_vectors<K>;
    const auto fill = [&](float of_others) {
      Vectors v;
      v.resize(positions.number_of_positions);
      for(std::size_t i = 0; i < v.size(); ++i)
        v.data()[i] = is_used[i / K] ? std::sin(static_cast<float>(i)) : of_others;
      return v;
    };
    const auto compare = [&](const Vectors& x, const Vectors& y) {
      for(std::size_t i = 0; i < x.size(); ++i)
        if(is_used[i / K])
          REQUIRE(x.data()[i] == y.data()[i]);
    };
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const Vectors b = fill(0), b_nan = fill(nan);
    Vectors x, r, x_nan = fill(nan), r_nan;
    smoother.pre_smooth<K>(b, x, r, 1);
    smoother.pre_smooth<K>(b_nan, x_nan, r_nan, 1);
    compare(x, x_nan);
    compare(r, r_nan);
    x = fill(0);
    x_nan = fill(nan);
    smoother.residual<K>(b, x, r);
    smoother.residual<K>(b_nan, x_nan, r_nan);
    compare(r, r_nan);
    smoother.post_smooth<K>(b, x, 2);
    smoother.post_smooth<K>(b_nan, x_nan, 2);
    compare(x, x_nan);
  };
  check(std::integral_constant<int, 1>());
  check(std::integral_constant<int, 8>());
}

TEST_CASE("coarsest_level_that_cannot_be_solved_is_reported", "[multigrid]") {
  Sparse_matrix a = path_matrix(5, 0.1);
  a.coeffRef(2, 2) = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(RL::Multigrid<>(a, {}), RL::Numerical_error);
  a.coeffRef(2, 2) = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(RL::Multigrid<>(a, {}), RL::Numerical_error);
}

TEST_CASE("solver_can_be_moved", "[multigrid]") {
  const int n = 5;
  const Sparse_matrix a = path_matrix(n, 0.1);
  const Eigen::VectorXd integrals = Eigen::VectorXd::Ones(n), b = random_vector(n, 6);
  RL::Multigrid_solver solver(a, {}, integrals), other(path_matrix(2, 1), {}, integrals.head(2));
  Eigen::VectorXd x;
  Eigen::MatrixXd same;
  CHECK(solver.solve(b, x).converged);
  other = std::move(solver);
  CHECK(other.solve(b, same).converged);
  CHECK(x == same.col(0));
  const RL::Multigrid_solver third = std::move(other);
  CHECK(third.upper_half().rows() == n);
  // no columns
  CHECK(third.solve(Eigen::MatrixXd(n, 0), same).converged);
  CHECK(same.cols() == 0);
}

TEST_CASE("solution_is_in_double_precision", "[multigrid][threads]") {
  const int fine = 511, finest = 2 * fine + 1;
  // entries of very different size, as those of elements that hardly reach the surface
  Eigen::VectorXd scale(finest);
  for(int i = 0; i < finest; ++i)
    scale[i] = std::pow(10., -6 * (i % 7 == 3) + 60);
  const Sparse_matrix a = scale.asDiagonal() * path_matrix(finest, 1e-6) * scale.asDiagonal();
  const Sparse_matrix p = scale.cwiseInverse().asDiagonal() * path_prolongation(fine);
  const Eigen::VectorXd expected = random_vector(finest, 5), b = a * expected;
  for(RL::Smoother_type smoother : {RL::Smoother_type::patch, RL::Smoother_type::point})
    for(bool is_parallel : {false, true}) {
      RL::Poisson_solver_options options;
      options.smoother = smoother;
      options.is_parallel = is_parallel;
      options.tolerance = 1e-12;
      const RL::Multigrid_solver solver(a, {{p}, {path_patches(finest, 8, 3)}, {}},
                                        Eigen::VectorXd::Zero(finest), 0, options);
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

TEST_CASE("constants_of_singular_components_are_removed_from_loads", "[multigrid]") {
  // two paths whose constants are in the kernel, one with a term of order zero
  const int n = 13;
  std::vector<Eigen::Triplet<double>> entries;
  for(int part = 0; part < 3; ++part)
    for(int i = 0; i + 1 < n; ++i) {
      const int first = 3 * i + part, second = first + 3;
      const double weight = std::pow(10., part * i);
      entries.emplace_back(first, first, weight);
      entries.emplace_back(second, second, weight);
      entries.emplace_back(first, second, -weight);
      if(part == 1)
        entries.emplace_back(first, first, 1e-3 * weight);
    }
  Sparse_matrix a(3 * n, 3 * n);
  a.setFromTriplets(entries.begin(), entries.end());
  const RL::internal::Level_positions positions =
      RL::internal::Level_positions::consecutive(static_cast<std::size_t>(a.cols()));
  const std::vector<double> scale = RL::internal::balancing_scale(a);
  const RL::internal::Constant_deflation deflation(a, positions, scale);
  RL::internal::Level_vectors<8> b;
  b.set_zero(positions.number_of_positions);
  const Eigen::MatrixXd load = Eigen::MatrixXd::Random(a.cols(), 8);
  for(int i = 0; i < a.cols(); ++i)
    for(int k = 0; k < 8; ++k)
      b.position(i)[k] = static_cast<float>(load(i, k));
  deflation.remove_from<8>(b);
  for(int k = 0; k < 8; ++k)
    for(int part = 0; part < 3; ++part) {
      double sum = 0, sum_of_squares = 0, changed = 0, along = 0;
      for(int i = part; i < a.cols(); i += 3) {
        sum += b.position(i)[k] / scale[i];
        sum_of_squares += 1 / (scale[i] * scale[i]);
        along += load(i, k) / scale[i];
      }
      for(int i = part; i < a.cols(); i += 3) {
        const double removed = part == 1 ? 0 : along / sum_of_squares / scale[i];
        changed = (std::max)(changed, std::abs(load(i, k) - removed - b.position(i)[k]));
      }
      CHECK(changed <= 1e-6);
      if(part != 1)
        CHECK(std::abs(sum) <= 1e-5 * std::sqrt(sum_of_squares));
    }
}

TEST_CASE("scales_balance_the_diagonal_within_limits", "[multigrid]") {
  const std::vector<double> diagonal = {3e40, 1e40, 2e20, 5e10, 1e-40, 0, -1};
  Sparse_matrix a(7, 7);
  for(int i = 0; i < 7; ++i)
    a.insert(i, i) = diagonal[i];
  const std::vector<double> scale = RL::internal::balancing_scale(a);
  for(int i = 0; i < 4; ++i) {
    CHECK(diagonal[i] * scale[i] * scale[i] >= 0.5);
    CHECK(diagonal[i] * scale[i] * scale[i] <= 2);
  }
  for(int i = 4; i < 7; ++i) {
    CHECK(3e10 * scale[i] * scale[i] >= 0.5);
    CHECK(3e10 * scale[i] * scale[i] <= 2);
  }
  for(const double s : RL::internal::balancing_scale(Sparse_matrix(3, 3)))
    CHECK(s == 1);
}

TEST_CASE("error_in_the_report_is_that_of_four_steps_before", "[multigrid]") {
  const int finest = size_of_finest;
  const Sparse_matrix a = path_matrix(finest, 0.01);
  const Eigen::VectorXd expected = random_vector(finest, 5), b = a * expected;
  const auto energy = [&](const Eigen::VectorXd& x) { return x.dot(a * x); };
  RL::Poisson_solver_options options;
  options.tolerance = 1e-14;
  options.smoother = RL::Smoother_type::point; // slower, so that there are steps to look at
  const auto solver = [&] {
    return RL::Multigrid_solver(a, path_levels(), Eigen::VectorXd::Zero(finest), 0, options);
  };
  std::vector<Eigen::VectorXd> solutions;
  for(options.maximum_iterations = 0; options.maximum_iterations <= 9;
      ++options.maximum_iterations) {
    Eigen::VectorXd x;
    const RL::Solve_report report = solver().solve(b, x);
    const int steps = options.maximum_iterations;
    INFO(steps << " steps");
    REQUIRE(report.iterations == steps);
    CHECK(report.status == RL::Solve_status::iteration_limit);
    CHECK(!report.converged);
    solutions.push_back(x);
    if(steps == 0) {
      CHECK(std::isnan(report.relative_energy_error));
      continue;
    }
    const double before =
        std::sqrt(energy(expected - solutions[(std::max)(0, steps - 4)]) / energy(expected));
    CHECK(report.relative_energy_error <= 1.01 * before);
    if(steps >= 4)
      CHECK(report.relative_energy_error >= 0.98 * before);
    // what it was before the last step is less
    CHECK(report.relative_energy_error > std::sqrt(energy(expected - x) / energy(expected)));
  }
  // it can be asked for
  options.maximum_iterations = 100;
  options.energy_tolerance = 1e-3;
  Eigen::VectorXd x;
  const RL::Solve_report report = solver().solve(b, x);
  CHECK(report.converged);
  CHECK(report.iterations >= 4);
  CHECK(report.iterations < 9);
  CHECK(report.relative_energy_error <= 1e-3);
  CHECK(report.relative_residual > 1e-14);
  CHECK(energy(expected - x) <= 1e-6 * energy(expected));
  for(const double wrong : {-1e-3, 1., std::nan("")}) {
    options.energy_tolerance = wrong;
    CHECK_THROWS_AS(solver(), RL::Parameter_error);
  }
}

TEST_CASE("status_tells_how_an_iteration_ended", "[multigrid]") {
  const int finest = size_of_finest;
  const Sparse_matrix a = path_matrix(finest, 0.01);
  const Eigen::VectorXd b = random_vector(finest, 5);
  RL::Poisson_solver_options options;
  const auto report = [&](double coarse_factor) {
    RL::Multigrid_levels levels = path_levels();
    const Sparse_matrix middle = RL::galerkin_product(a, levels.prolongations[1], false),
                        coarse = RL::galerkin_product(middle, levels.prolongations[0], false);
    levels.coarse_matrices = {coarse_factor * coarse, coarse_factor * middle};
    const RL::Multigrid_solver solver(a, std::move(levels), Eigen::VectorXd::Zero(finest), 0,
                                      options);
    Eigen::VectorXd x;
    const RL::Solve_report result = solver.solve(b, x);
    CHECK(x.allFinite());
    CHECK(result.relative_residual ==
          Approx((b - a * x).norm() / b.norm()).epsilon(1e-3).margin(1e-13));
    CHECK(result.converged == (result.status == RL::Solve_status::converged));
    return result;
  };
  options.tolerance = 1e-10;
  CHECK(report(1).status == RL::Solve_status::converged);
  options.maximum_iterations = 2;
  CHECK(report(1).status == RL::Solve_status::iteration_limit);
  options.maximum_iterations = 1000;
  options.tolerance = 1e-30;
  const RL::Solve_report stalled = report(1);
  CHECK(stalled.status == RL::Solve_status::stalled);
  CHECK(stalled.iterations < 100);
  CHECK(stalled.relative_residual < 1e-13);
  // Coarse corrections that are ten times too large: cycles alone diverge, conjugate gradients do
  // not, and W-cycles, which are worse, become V-cycles.
  options.tolerance = 1e-10;
  const RL::Solve_report v = report(0.1);
  CHECK(v.converged);
  options.cycle = RL::Cycle::W;
  const RL::Solve_report w = report(0.1);
  CHECK(w.converged);
  CHECK(w.iterations <= v.iterations + 5);
  for(const RL::Cycle cycle : {RL::Cycle::V, RL::Cycle::W}) {
    options.cycle = cycle;
    options.stand_alone_multigrid = true;
    const RL::Solve_report alone = report(0.1);
    CHECK(alone.status == RL::Solve_status::diverged);
    CHECK(alone.iterations < 20);
  }
  // a report of several parts is as good as the worst
  RL::Solve_report several;
  CHECK(!several.converged);
  several.set_status(RL::Solve_status::converged);
  CHECK(several.converged);
  several.worsen_status(RL::Solve_status::stalled);
  CHECK(!several.converged);
  several.worsen_status(RL::Solve_status::iteration_limit);
  CHECK(several.status == RL::Solve_status::stalled);
  CHECK(to_string(RL::Solve_status::converged) == "converged");
  CHECK(to_string(RL::Solve_status::iteration_limit) == "reached the largest number of iterations");
  CHECK(to_string(RL::Solve_status::stalled) == "stalled");
  CHECK(to_string(RL::Solve_status::diverged) == "diverged");
}

TEST_CASE("one_patch_of_everything_is_the_inverse", "[multigrid]") {
  const int n = 53;
  const Sparse_matrix a = path_matrix(n, 0.1);
  RL::Smoothing_patches patches = path_patches(n, 2 * n, 1);
  REQUIRE(patches.number_of_patches == 1);
  const RL::Patch_smoother smoother(a, patches);
  RL::internal::Level_vectors<1> b, x, r;
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

TEST_CASE("half_of_a_matrix_has_the_products_of_the_whole", "[multigrid][threads]") {
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

TEST_CASE("halves_of_two_matrices_have_the_products_of_both", "[multigrid][threads]") {
  constexpr int n = 5000;
  // entries in the same places, or in others
  for(bool is_shifted : {false, true}) {
    std::array<Eigen::SparseMatrix<double>, 2> a;
    for(int number = 0; number < 2; ++number) {
      std::vector<Eigen::Triplet<double>> entries;
      for(int j = 0; j < n; ++j)
        for(int distance : {0, 1, 700}) {
          const int i = j - distance - (is_shifted ? number : 0);
          if(i < 0)
            continue;
          entries.emplace_back(i, j, std::cos(i + 3. * j + number));
          if(i != j)
            entries.emplace_back(j, i, std::cos(i + 3. * j + number));
        }
      a[number].resize(n, n);
      a[number].setFromTriplets(entries.begin(), entries.end());
    }
    const auto whole = a;
    RL::internal::Symmetric_matrices<2> halves;
    halves.take_halves_of({&a[0], &a[1]});
    CHECK(a[0].nonZeros() + a[1].nonZeros() == 0);
    CHECK(halves.rows() == n);
    RL::internal::Block_vector<8> x(n, 8), y[2], parallel[2];
    for(int c = 0; c < 8; ++c)
      x.col(c) = random_vector(n, 20 + c);
    halves.multiply<8>(x, {&y[0], &y[1]}, false);
    halves.multiply<8>(x, {&parallel[0], &parallel[1]}, true);
    const RL::internal::Block_vector<1> x_1 = x.col(3);
    RL::internal::Block_vector<1> y_1[2];
    halves.multiply<1>(x_1, {&y_1[0], &y_1[1]}, false);
    for(int number = 0; number < 2; ++number) {
      CHECK((y[number] - whole[number] * x).norm() <= 1e-14 * y[number].norm());
      CHECK(parallel[number] == y[number]);
      CHECK((y_1[number] - y[number].col(3)).norm() <= 1e-14 * y_1[number].norm());
    }
  }
}

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

TEST_CASE("inverse_of_the_coarsest_level_leaves_the_kernel_out", "[multigrid]") {
  using RL::internal::Regularized_inverse;
  // a ring of `size` unknowns with weights, from number `first` on
  const auto add_ring = [](int first, int size, double scale, double screening,
                           Eigen::MatrixXd& a) {
    const Eigen::VectorXd weights = random_vector(size, first + 5).cwiseAbs();
    for(int i = 0; i < size; ++i) {
      const int j = (i + 1) % size;
      const double w = scale * (0.1 + weights[i]);
      a(first + i, first + i) += w + scale * screening;
      a(first + j, first + j) += w;
      a(first + i, first + j) -= w;
      a(first + j, first + i) -= w;
    }
  };
  // two components with constants in the kernel, one without, an unknown without equation, and a
  // component that sees one combination only, which is not that of constants
  const int n = 33;
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, n);
  add_ring(0, 7, 1, 0, a);
  add_ring(7, 13, 1e6, 0, a);
  add_ring(20, 6, 1e-3, 0.01, a);
  const Eigen::VectorXd seen = random_vector(6, 3);
  a.bottomRightCorner(6, 6) = seen * seen.transpose();
  // what these equations can be solved for
  Eigen::VectorXd b = random_vector(n, 1);
  b.head(7).array() -= b.head(7).mean();
  b.segment(7, 13).array() -= b.segment(7, 13).mean();
  b[26] = 0;
  b.tail(6) = seen;
  for(const double epsilon :
      {Regularized_inverse::single_precision, Regularized_inverse::double_precision}) {
    const Regularized_inverse inverse(a.sparseView(), epsilon);
    RL::internal::Block_vector<1> x;
    inverse.apply<1>(b, x);
    // up to the shift, and rounding errors that it amplifies
    CHECK((b - a * x).norm() <= (1e3 * epsilon + 1e-16 / epsilon) * b.norm());
    CHECK(x[26] == 0);
    // with their diagonal entries as weights, solutions have mean 0
    CHECK(std::abs(a.diagonal().head(7).dot(x.head(7))) <= 1e-9 * x.head(7).norm());
    CHECK(std::abs(a.diagonal().segment(7, 13).dot(x.segment(7, 13))) <=
          1e-3 * x.segment(7, 13).norm());
    // the constants of singular components are loads that nothing answers to
    inverse.apply<1>(a.diagonal(), x);
    CHECK(x.head(20).norm() <= 1e-9);
    CHECK((a * x - a.diagonal()).segment(20, 6).norm() <=
          1e3 * epsilon * a.diagonal().segment(20, 6).norm());
    // what is not in the range is not amplified beyond bounds
    inverse.apply<1>(random_vector(n, 7), x);
    CHECK(x.tail(6).norm() <= 1e2 / epsilon);
  }
}

TEST_CASE("packed_symmetric_matrices_are_multiplied", "[multigrid]") {
  for(int size : {1, 2, 5, 8, 9, 15, 16, 27, 36, 47, 64}) {
    const int stride = (size + 7) / 8 * 8;
    std::vector<double> lower(static_cast<std::size_t>(stride) * size,
                              std::numeric_limits<double>::quiet_NaN());
    Eigen::MatrixXf a(size, size);
    for(int i = 0; i < size; ++i)
      for(int j = 0; j <= i; ++j)
        a(i, j) = a(j, i) =
            static_cast<float>(lower[stride * i + j] = std::sin(3. * i + 5. * j + 1));
    RL::internal::Aligned_floats packed(RL::internal::symmetric_size(size) + 8, 7.5f);
    RL::internal::pack_symmetric(lower.data(), size, stride, packed.data());
    CHECK(packed[packed.size() - 8] == 7.5f);
    RL::internal::Aligned_floats x(8 * stride, 0.f), y(8 * stride);
    for(int i = 0; i < 8 * size; ++i)
      x[i] = std::cos(2.f * i);
    RL::internal::Aligned_floats x_1(x.begin(), x.begin() + stride);
    std::fill(x_1.begin() + size, x_1.end(), 0.f);
    RL::internal::multiply_symmetric<1>(packed.data(), size, x_1.data(), y.data());
    CHECK((Eigen::Map<const Eigen::VectorXf>(y.data(), size) -
           a * Eigen::Map<const Eigen::VectorXf>(x_1.data(), size))
              .norm() <= 1e-5f * size);
    using Rows = Eigen::Matrix<float, Eigen::Dynamic, 8, Eigen::RowMajor>;
    RL::internal::multiply_symmetric<8>(packed.data(), size, x.data(), y.data());
    CHECK(
        (Eigen::Map<const Rows>(y.data(), size, 8) - a * Eigen::Map<const Rows>(x.data(), size, 8))
            .norm() <= 1e-5f * size);
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
    const int rows = (size + 7) / 8 * 8;
    // what is after a matrix, and additional rows, must not matter
    auto matrix = random_floats(RL::internal::symmetric_size(size) + 7),
         from = random_floats(8 * rows);
    std::fill(matrix.end() - 7, matrix.end(), std::numeric_limits<float>::quiet_NaN());
    for(std::size_t vectors : {1, 8}) {
      auto x = from;
      std::fill(x.begin() + vectors * size, x.end(), 0.f);
      auto a = random_floats(8 * rows), b = random_floats(8 * rows);
      if(vectors == 1) {
        RL::internal::plain::multiply_symmetric<1>(matrix.data(), size, x.data(), a.data());
        RL::internal::lanes::multiply_symmetric<1>(matrix.data(), size, x.data(), b.data());
      } else {
        RL::internal::plain::multiply_symmetric<8>(matrix.data(), size, x.data(), a.data());
        RL::internal::lanes::multiply_symmetric<8>(matrix.data(), size, x.data(), b.data());
      }
      compare(a.data(), b.data(), vectors * size);
    }
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

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_MULTIGRID_EIGENPAIRS_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_MULTIGRID_EIGENPAIRS_IMPL_H

#include <CGAL/Restricted_laplacian_3/spectra/multigrid_eigenpairs.h>

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/solvers/Multigrid.h>
#include <CGAL/Restricted_laplacian_3/solvers/shared/Symmetric_matrix.h>
#include <CGAL/Restricted_laplacian_3/spectra/internal/Nested_lobpcg.h>
#include <CGAL/Restricted_laplacian_3/spectra/internal/eigenproblem.h>
#include <CGAL/Restricted_laplacian_3/spectra/shared/nested_iteration.h>
#include <CGAL/Restricted_laplacian_3/spectra/smallest_eigenpairs.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// \param stiffness,mass,prolongations compressed
/// \throws Parameter_error see `multigrid_eigenpairs()`
inline void check_levels(const std::vector<Sparse_matrix>& stiffness,
                         const std::vector<Sparse_matrix>& mass,
                         const std::vector<Sparse_matrix>& prolongations,
                         const std::vector<Smoothing_patches>& patches) {
  if(stiffness.empty())
    throw Parameter_error("stiffness", "has no matrix");
  if(mass.size() != stiffness.size() || prolongations.size() + 1 != stiffness.size())
    throw Parameter_error("mass, prolongations", "do not have the number of levels of stiffness");
  for(std::size_t level = 0; level < stiffness.size(); ++level) {
    const auto& s = stiffness[level];
    const auto& m = mass[level];
    if(s.rows() != s.cols() || m.rows() != s.rows() || m.cols() != s.cols() ||
       (level > 0 && (prolongations[level - 1].rows() != s.rows() ||
                      prolongations[level - 1].cols() != stiffness[level - 1].rows())))
      throw Parameter_error("stiffness, mass, prolongations",
                            "do not have matching sizes on level " + std::to_string(level));
    for(const auto* a : {&s, &m})
      if(!a->coeffs().allFinite())
        throw Parameter_error(a == &s ? "stiffness" : "mass",
                              "has an entry that is not a finite number on level " +
                                  std::to_string(level));
  }
  if(patches.size() != prolongations.size())
    throw Parameter_error("patches", "are not given for each level but the coarsest");
  CGAL_precondition(is_symmetric(stiffness.back()));
  CGAL_precondition(is_symmetric(mass.back()));
}

inline double tolerance_of(const Multigrid_eigenpairs_options& options) {
  return options.tolerance.value_or(Multigrid_eigenpairs_options::default_tolerance);
}

/// \throws Parameter_error see `multigrid_eigenpairs()`
inline void check_options(const Multigrid_eigenpairs_options& options) {
  const double tolerance = tolerance_of(options);
  if(!(tolerance > 0 && tolerance < 1))
    throw Parameter_error("tolerance", "must be between 0 and 1");
  if(options.maximum_iterations < 0)
    throw Parameter_error("maximum_iterations", "must not be negative");
  if(options.smoothing_steps < 1)
    throw Parameter_error("smoothing_steps", "must be positive");
}

/// What the iteration needs of the levels after the one that it starts on.
struct Lobpcg_levels {
  std::vector<Symmetric_matrices<2>> pencils; // S and M
  std::vector<Sparse_matrix> prolongations;   // to the level with the same number
  Multigrid<> multigrid;                      // for S + alpha M, of all levels
};

/// Uses the matrices up, one after the other: what is needed at most is little more than they are.
inline Lobpcg_levels make_levels(std::size_t start, double alpha,
                                 std::vector<Sparse_matrix>& stiffness,
                                 std::vector<Sparse_matrix>& mass,
                                 std::vector<Sparse_matrix>& prolongations,
                                 std::vector<Smoothing_patches>& patches, bool is_parallel) {
  Lobpcg_levels levels;
  const std::size_t finest = stiffness.size() - 1;
  std::vector<Sparse_matrix> coarse(finest);
  for(std::size_t level = 0; level < finest; ++level)
    coarse[level] = stiffness[level] + alpha * mass[level];
  Sparse_matrix a = stiffness[finest] + alpha * mass[finest];
  levels.pencils.resize(finest + 1);
  levels.prolongations.resize(finest + 1);
  for(std::size_t level = 0; level <= finest; ++level) {
    if(level > start) {
      levels.pencils[level].take_halves_of({&stiffness[level], &mass[level]});
      levels.prolongations[level] = prolongations[level - 1];
    }
    Sparse_matrix().swap(stiffness[level]);
    Sparse_matrix().swap(mass[level]);
  }
  levels.multigrid = Multigrid<>(
      std::move(a), {std::move(prolongations), std::move(patches), std::move(coarse)}, is_parallel);
  return levels;
}

/// Finds the pairs with which the iteration begins. A level on which that fails is not the end: the
/// next one is another problem.
/// \return whether that succeeds
inline bool solve_start(const Sparse_matrix& stiffness, const Sparse_matrix& mass, int number,
                        const Progress& progress, Eigenpairs& pairs) {
  Eigenpairs_options options;
  options.tolerance = tolerance_of_start;
  options.progress = progress.callback();
  try {
    pairs = smallest_eigenpairs(stiffness, mass, number, options);
  } catch(const Numerical_error&) {
    return false;
  }
  return pairs.values.size() == number;
}

/// The pairs, of matrices that were checked.
inline Eigenpairs nested_eigenpairs(std::vector<Sparse_matrix> stiffness,
                                    std::vector<Sparse_matrix> mass,
                                    std::vector<Sparse_matrix> prolongations,
                                    std::vector<Smoothing_patches> patches, int k,
                                    const Multigrid_eigenpairs_options& options) {
  const double tolerance = tolerance_of(options);
  const std::size_t finest = stiffness.size() - 1;
  Eigenpairs_options start_options;
  start_options.progress = options.progress;
  if(k < 1 || k > stiffness[finest].cols() / unknowns_of_a_start_vector)
    return smallest_eigenpairs(stiffness[finest], mass[finest], k, start_options);
  const int carried = number_of_carried_vectors(k);
  std::size_t start = 0;
  while(start < finest && stiffness[start].cols() < unknowns_of_a_start_vector * carried)
    ++start;

  const Progress progress(options.progress);
  progress(0);
  Eigenpairs at_start;
  double work = 0, done = 0;
  for(; start < finest; ++start) {
    work = 0;
    for(std::size_t level = start; level <= finest; ++level)
      work += static_cast<double>(stiffness[level].cols());
    done = static_cast<double>(stiffness[start].cols()) / work;
    if(solve_start(stiffness[start], mass[start], carried, progress.part(0, done), at_start))
      break;
  }
  if(start == finest)
    return smallest_eigenpairs(stiffness[finest], mass[finest], k, start_options);

  Eigenpairs pairs;
  pairs.shift = natural_shift(mass[finest].coeffs().sum());
  pairs.coarser_values.emplace_back(at_start.values.head(k));
  const double alpha = reaction_of_hierarchy(at_start.values, pairs.shift);
  Lobpcg_levels levels =
      make_levels(start, alpha, stiffness, mass, prolongations, patches, options.is_parallel);
  Nested_lobpcg solver(levels.multigrid, at_start.vectors,
                       {alpha, pairs.shift, options.maximum_iterations, options.smoothing_steps,
                        options.is_parallel});
  for(std::size_t level = start + 1; level <= finest; ++level) {
    const double next = done + static_cast<double>(levels.pencils[level].rows()) / work;
    const Progress of_level = progress.part(done, next);
    done = next;
    of_level(0);
    solver.prolongate(level, levels.prolongations[level], levels.pencils[level]);
    Sparse_matrix().swap(levels.prolongations[level]);
    const bool is_finest = level == finest;
    solver.improve(is_finest ? k : carried, is_finest ? tolerance : tolerance_of_coarse_levels,
                   is_finest && !options.eigenvalues_only,
                   [&of_level](double part) { of_level(part); });
    if(!is_finest)
      pairs.coarser_values.push_back(solver.values(k));
  }
  pairs.iterations = solver.iterations();
  solver.take_pairs(k, pairs);
  // what was given up may have been a pair beyond those that are asked for
  pairs.set_status((pairs.residuals.array() <= tolerance).all() ? Solve_status::converged
                                                                : solver.status());
  return pairs;
}

/// A power of 4 near the sum of the entries of a matrix: dividing by it, or by its root, is exact.
inline double unit_of(const Sparse_matrix& mass) {
  const double sum = mass.coeffs().sum();
  return sum > std::numeric_limits<double>::min() ? std::exp2(2 * (std::ilogb(sum) / 2)) : 1;
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigenpairs multigrid_eigenpairs(
    std::vector<Sparse_matrix> stiffness, std::vector<Sparse_matrix> mass,
    std::vector<Sparse_matrix> prolongations, std::vector<Smoothing_patches> patches, int k,
    const Multigrid_eigenpairs_options& options) {
  for(auto* matrices : {&stiffness, &mass, &prolongations})
    for(Sparse_matrix& matrix : *matrices)
      matrix.makeCompressed();
  internal::check_levels(stiffness, mass, prolongations, patches);
  internal::check_options(options);
  // Numbers of single precision are to stay in their range, whatever the unit of length.
  const double unit = internal::unit_of(mass.back());
  for(Sparse_matrix& matrix : mass)
    matrix /= unit;
  Eigenpairs pairs =
      internal::nested_eigenpairs(std::move(stiffness), std::move(mass), std::move(prolongations),
                                  std::move(patches), k, options);
  pairs.values /= unit;
  pairs.shift /= unit;
  pairs.vectors /= std::sqrt(unit);
  for(Eigen::VectorXd& values : pairs.coarser_values)
    values /= unit;
  return pairs;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_MULTIGRID_EIGENPAIRS_IMPL_H

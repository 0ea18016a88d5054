// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_INTERNAL_NESTED_LOBPCG_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_INTERNAL_NESTED_LOBPCG_H

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Function_view.h>
#include <CGAL/Restricted_laplacian_3/solvers/Multigrid.h>
#include <CGAL/Restricted_laplacian_3/solvers/Solve_report.h>
#include <CGAL/Restricted_laplacian_3/solvers/shared/Symmetric_matrix.h>
#include <CGAL/Restricted_laplacian_3/solvers/shared/block_vectors.h>
#include <CGAL/Restricted_laplacian_3/spectra/eigenpairs.h>
#include <CGAL/Restricted_laplacian_3/spectra/internal/Ritz_basis.h>
#include <CGAL/Restricted_laplacian_3/spectra/internal/largest_pairs.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// What the largest residuals of the steps of an iteration say about it.
///
/// The largest residual grows for two reasons. By rounding: the products that the projection knows
/// are no longer those of its vectors, and the iteration is to be started anew with the vectors
/// alone. Or because a pair has come within the number asked for that nobody has improved: then to
/// start anew does no good, and little harm if it is done once. So what follows a start is compared
/// with what comes after it, not with what was before.
class Convergence {
public:
  explicit Convergence(double tolerance) : m_tolerance(tolerance) {}

  void add(double residual) {
    ++m_steps;
    m_first = (std::max)(m_first, residual);
    m_last = residual;
    if(residual < gain_of_a_step * m_best_since_start) {
      m_best_since_start = residual;
      m_last_gain = m_steps;
    }
    if(residual < gain_of_a_start * m_best) {
      m_best = residual;
      m_starts_without_gain = 0;
    }
  }
  /// the iteration is started anew with the last vectors
  void start_anew() {
    m_best_since_start = (std::numeric_limits<double>::max)();
    m_last_gain = m_steps;
    ++m_starts_without_gain;
  }
  /// whether further steps are of no use
  bool stagnates() const {
    return m_steps - m_last_gain >= steps_without_gain ||
           m_starts_without_gain > most_starts_without_gain;
  }
  /// whether the residual has grown since the last start
  bool has_grown() const { return m_last > growth_of_rounding * m_best_since_start; }
  /// part of the way from the first residual to the tolerance, in powers of ten
  double progress() const {
    return m_last > m_tolerance ? std::log(m_first / m_last) / std::log(m_first / m_tolerance) : 1;
  }

private:
  static constexpr double huge = (std::numeric_limits<double>::max)();
  // Pairs in the middle of a cluster may rest for some steps, while the others converge.
  static constexpr double gain_of_a_step = 0.9;
  static constexpr int steps_without_gain = 8;
  // A step may make the residual larger, but not much, as values fall monotonically.
  static constexpr double growth_of_rounding = 2;
  // Where the limit is that of rounding, about which residuals vary, starts do not help. Pairs that
  // come in are few.
  static constexpr double gain_of_a_start = 0.5;
  static constexpr int most_starts_without_gain = 2;

  double m_tolerance;
  double m_first = 0, m_last = 0, m_best = huge, m_best_since_start = huge;
  int m_steps = 0, m_last_gain = 0, m_starts_without_gain = 0;
};

/// The locally optimal block preconditioned conjugate gradient method (A. V. Knyazev, SIAM J. Sci.
/// Comput. 23, 2001) on one level of a hierarchy after the other, see `multigrid_eigenpairs()`.
///
/// In each iteration the problem is projected to the space of the current vectors \f$X\f$, their
/// preconditioned residuals \f$W\f$, and their last changes \f$P\f$. With \f$A = S + \alpha M\f$
/// the projected problem is solved as \f$M x = \nu A x\f$, \f$\nu = 1 / (\lambda + \alpha)\f$:
/// \f$A\f$ is positive definite, while \f$M\f$ is singular to rounding on functions that nearly
/// vanish on the surface.
///
/// Vectors that have converged, and those beyond the number that is asked for, take part in the
/// projection, but have no \f$W\f$ and \f$P\f$ (soft locking).
class Nested_lobpcg {
public:
  struct Parameters {
    /// \f$\alpha\f$
    double alpha;
    /// the shift by which residuals are measured, see `Eigenpairs`
    double residual_shift;
    /// see `multigrid_eigenpairs()`
    int maximum_iterations, smoothing_steps;
    bool is_parallel;
  };

  /// \param multigrid for \f$S + \alpha M\f$
  /// \param x start vectors on a level
  Nested_lobpcg(const Multigrid<>& multigrid, const Eigen::MatrixXd& x,
                const Parameters& parameters)
    : m_multigrid(multigrid), m_parameters(parameters), m_basis(x, parameters.is_parallel) {}

  /// Continues on the next finer level.
  /// \param p the prolongation to it
  /// \param pencil its matrices \f$S\f$ and \f$M\f$, which have to outlive the work on it
  void prolongate(std::size_t level, const Sparse_matrix& p, const Symmetric_matrices<2>& pencil) {
    m_level = level;
    m_basis.prolongate(p, pencil);
  }

  /// Iterates on a level until the first `count` residuals are at most `tolerance`.
  /// \param is_verified whether the vectors are to be orthonormal to rounding, with all of the
  /// residuals computed from them; else values are those of the last projection, and residuals of
  /// pairs that converged earlier those with which they did
  /// \param progress is told which part of the work on the level is done
  void improve(Eigen::Index count, double tolerance, bool is_verified,
               Function_view<void(double)> progress) {
    m_count = count;
    m_values = m_masses = m_residuals = Eigen::VectorXd::Zero(m_basis.size());
    m_iterations = 0;
    Convergence convergence(tolerance);
    bool is_given_up = false, is_orthonormalized = false;
    start_anew(m_basis.size());
    for(;;) {
      compute_corrections(is_given_up ? (std::numeric_limits<double>::max)() : tolerance);
      if(!is_given_up) {
        convergence.add(m_residuals.maxCoeff());
        progress(convergence.progress());
        is_given_up = !m_active.empty() &&
                      (m_iterations >= m_parameters.maximum_iterations || convergence.stagnates());
        m_status = !is_given_up              ? Solve_status::converged
                   : convergence.stagnates() ? Solve_status::stalled
                                             : Solve_status::iteration_limit;
      }
      if(is_given_up || m_active.empty()) {
        if(!is_verified || (m_is_fresh && (is_orthonormalized || is_orthonormal())))
          return;
        is_orthonormalized = m_is_fresh;
        if(is_orthonormalized)
          project();
        start_anew(count);
        continue;
      }
      ++m_iterations;
      is_orthonormalized = false;
      // never twice in a row, which would leave the vectors as they are
      if(!m_is_fresh && convergence.has_grown()) {
        start_anew(m_basis.size());
        convergence.start_anew();
      }
      project();
      extend_or_cut();
    }
  }

  /// the smallest values that were found on the last level, ascending
  Eigen::VectorXd values(Eigen::Index count) const {
    Eigen::VectorXd result = m_values;
    std::sort(result.begin(), result.end());
    return result.head(count);
  }

  /// of the last level
  int iterations() const { return m_iterations; }
  /// how the iteration on the last level ended
  Solve_status status() const { return m_status; }

  /// Moves the first vectors to `pairs`, normalized, with their values and residuals.
  void take_pairs(Eigen::Index count, Eigenpairs& pairs) {
    // copies of an eigenvalue may be out of order by rounding
    Indices order(static_cast<std::size_t>(count)), place(order.size());
    std::iota(order.begin(), order.end(), Eigen::Index(0));
    std::stable_sort(order.begin(), order.end(),
                     [this](Eigen::Index i, Eigen::Index j) { return m_values[i] < m_values[j]; });
    for(std::size_t i = 0; i < order.size(); ++i)
      place[static_cast<std::size_t>(order[i])] = static_cast<Eigen::Index>(i);
    m_basis.take_vectors(place, pairs.vectors);
    pairs.values.resize(count);
    pairs.residuals.resize(count);
    for(Eigen::Index i = 0; i < count; ++i) {
      const Eigen::Index from = order[static_cast<std::size_t>(i)];
      pairs.values[i] = m_values[from];
      pairs.residuals[i] = m_residuals[from];
      auto x = pairs.vectors.col(i);
      Eigen::Index largest;
      x.cwiseAbs().maxCoeff(&largest);
      x /= x[largest] < 0 ? -std::sqrt(m_masses[from]) : std::sqrt(m_masses[from]);
    }
  }

private:
  using Indices = Ritz_basis::Indices;
  using Block = Ritz_basis::Block;
  using Row = Block_row<panel_width>;

  // Vectors whose values are larger than the last one that is asked for by less than this fraction
  // are improved as well: some of them may fall below it.
  static constexpr double gap_at_the_end = 1e-2;

  // Between vectors that are as good as orthogonal.
  static constexpr double largest_cosine = 1e-11;

  /// Values and residuals of the active pairs, and the preconditioned residuals of those that have
  /// not converged and are near. The latter remain active.
  void compute_corrections(double tolerance) {
    m_basis.start_corrections(m_active.size());
    const bool is_parallel = m_parameters.is_parallel;
    Block x, sx, mx, w;
    for(std::size_t first = 0; first < m_active.size(); first += panel_width) {
      const int width = m_basis.gather(m_active, first, x);
      const auto pair = [&](int c) { return m_active[first + static_cast<std::size_t>(c)]; };
      m_basis.multiply(x, sx, mx);
      if(m_is_fresh)
        m_basis.add_known_products(first / panel_width, width, sx, mx);
      // energies, masses, and squares of the scale of residuals
      using Sums = Eigen::Array<double, 3, panel_width, Eigen::RowMajor>;
      const Sums sums =
          sum_over_rows(is_parallel, x.rows(), Sums(Sums::Zero()), [&](Eigen::Index i, Sums& sum) {
            const Row own = row<panel_width>(x, i), s = row<panel_width>(sx, i),
                      m = row<panel_width>(mx, i);
            sum.row(0) += own * s;
            sum.row(1) += own * m;
            sum.row(2) += (s - m_parameters.residual_shift * m).square();
          });
      Row lambda = Row::Zero();
      for(int c = 0; c < width; ++c)
        lambda[c] = sums(0, c) / sums(1, c);
      Block& residual = sx;
      const Row squares =
          sum_over_rows(is_parallel, x.rows(), Row(Row::Zero()), [&](Eigen::Index i, Row& sum) {
            auto r = row<panel_width>(residual, i);
            r -= lambda * row<panel_width>(mx, i);
            sum += r.square();
          });
      std::array<bool, panel_width> is_improved = {};
      for(int c = 0; c < width; ++c) {
        const Eigen::Index i = pair(c);
        m_masses[i] = sums(1, c);
        m_values[i] = lambda[c];
        m_residuals[i] = is_near(i) ? std::sqrt(squares[c] / sums(2, c)) : 0;
        is_improved[static_cast<std::size_t>(c)] = !(m_residuals[i] <= tolerance);
      }
      if(std::find(is_improved.begin(), is_improved.end(), true) == is_improved.end())
        continue;
      m_multigrid.apply<panel_width>(m_level, residual, w, Cycle::V, m_parameters.smoothing_steps,
                                     m_workspace);
      for(int c = 0; c < width; ++c)
        if(is_improved[static_cast<std::size_t>(c)])
          m_basis.add_correction(pair(c), w, c);
    }
    m_basis.end_corrections();
    m_active = m_basis.owners_of_corrections();
  }

  /// Makes the first vectors active, with nothing known about them but themselves.
  void start_anew(Eigen::Index count) {
    m_basis.restart();
    m_active.resize(static_cast<std::size_t>(count));
    std::iota(m_active.begin(), m_active.end(), Eigen::Index(0));
    m_is_fresh = true;
  }

  /// Whether the vectors are orthogonal to rounding, if nothing else is known about them.
  bool is_orthonormal() const {
    return m_basis.largest_cosine(m_parameters.alpha) <= largest_cosine;
  }

  /// Solves the problem on the space of all \f$X\f$, \f$P\f$ and \f$W\f$, sets \f$X\f$ to the
  /// solution, and \f$P\f$ to the changes of those that had not converged and may be active again.
  /// Values and masses follow from the projection.
  void project() {
    const Ritz_basis::Projection projection = m_basis.projection();
    const Dense_pairs pairs = largest_pairs(
        projection.m, projection.s + m_parameters.alpha * projection.m, m_basis.size());
    m_masses = pairs.values;
    m_values = pairs.values.cwiseInverse().array() - m_parameters.alpha;
    m_is_fresh = false;
    Indices owners = m_basis.owners_of_corrections();
    cut(owners, end_of_near());
    m_basis.update(projection, pairs.vectors, owners);
  }

  /// whether a vector is asked for, or its value is near to those that are
  bool is_near(Eigen::Index i) const {
    return i < m_count || m_values[i] + m_parameters.alpha <=
                              (1 + gap_at_the_end) * (m_values[m_count - 1] + m_parameters.alpha);
  }

  /// the number of the first vectors that are near
  Eigen::Index end_of_near() const {
    Eigen::Index end = m_count;
    while(end < m_basis.size() && is_near(end))
      ++end;
    return end;
  }

  static void cut(Indices& numbers, Eigen::Index end) {
    numbers.erase(std::lower_bound(numbers.begin(), numbers.end(), end), numbers.end());
  }

  /// From the vectors after those that are asked for those remain active, or become so, whose
  /// values are near.
  void extend_or_cut() {
    const Eigen::Index end = end_of_near();
    m_residuals.tail(m_basis.size() - end).setZero();
    cut(m_active, end);
    for(Eigen::Index i = m_count; i < end; ++i)
      if(m_active.empty() || m_active.back() < i)
        m_active.push_back(i);
  }

  const Multigrid<>& m_multigrid;
  Parameters m_parameters;
  std::size_t m_level = 0;
  Eigen::Index m_count = 0; // of vectors that are asked for
  int m_iterations = 0;
  Solve_status m_status = Solve_status::iteration_limit;
  Ritz_basis m_basis;
  Eigen::VectorXd m_values, m_masses, m_residuals;
  // whether nothing is known but products of vectors with themselves
  bool m_is_fresh = true;
  Indices m_active; // vectors whose residuals are computed next, ascending
  Multigrid<>::Workspace<panel_width> m_workspace;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_INTERNAL_NESTED_LOBPCG_H

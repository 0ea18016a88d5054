// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_MULTIGRID_EIGENPAIRS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_MULTIGRID_EIGENPAIRS_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/solvers/Multigrid.h>
#include <CGAL/Restricted_laplacian_3/solvers/Multigrid_levels.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/Symmetric_matrix.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/block_vectors.h>
#include <CGAL/Restricted_laplacian_3/spectra/eigenpairs.h>
#include <CGAL/Restricted_laplacian_3/spectra/internal/Column_panels.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Solvers
/// What `multigrid_eigenpairs()` does unless told otherwise.
struct Multigrid_eigenpairs_options {
  /// the largest of `Eigenpairs::residuals` that counts as converged; the error of an eigenvector
  /// is of the order of its residual, the relative one of an eigenvalue of the order of its square
  double relative_tolerance = 1e-3;
  /// on each level
  int maximum_iterations = 100;
  /// of a cycle: smoothing steps before, and again after the coarse correction
  int smoothing_steps = 1;
  /// whether several threads are used; results do not depend on that
  bool is_parallel = false;
  /// is told which part of the work is done, from 0 to 1; if it returns `false`, the computation
  /// ends with a `Canceled` exception
  std::function<bool(double)> callback;
};

namespace internal {

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
/// projection, but have no \f$W\f$ and \f$P\f$ (soft locking). The products
/// \f$X^T A X\f$, \f$X^T A P\f$, ... follow from those of the last iteration. Only the products of
/// \f$S\f$ and \f$M\f$ with \f$W\f$ are formed.
class Nested_lobpcg {
public:
  using Sparse_matrix = Eigen::SparseMatrix<double>;

  /// \param multigrid for \f$S + \alpha M\f$
  /// \param residual_shift the shift by which residuals are measured, see `Eigenpairs`
  /// \param x start vectors on a level
  Nested_lobpcg(const Multigrid<>& multigrid, double alpha, double residual_shift,
                const Eigen::MatrixXd& x, const Multigrid_eigenpairs_options& options)
    : m_multigrid(multigrid), m_options(options), m_alpha(alpha), m_residual_shift(residual_shift),
      m_x(x.rows(), x.cols()) {
    for(Eigen::Index j = 0; j < x.cols(); ++j)
      for(Eigen::Index i = 0; i < x.rows(); ++i)
        m_x.column(j)[panel_width * i] = x(i, j);
  }

  /// continues on the next finer level
  void prolongate(const Sparse_matrix& p) {
    Column_panels<double> fine(p.rows(), m_x.columns());
    parallel_for(m_options.is_parallel, 0, m_x.number_of_panels(), 1,
                 [&](std::size_t panel, std::size_t) {
                   double* const to = fine.panel(panel);
                   const double* const from = m_x.panel(panel);
                   for(int j = 0; j < p.cols(); ++j)
                     for(Sparse_matrix::InnerIterator i(p, j); i; ++i)
                       for(int c = 0; c < panel_width; ++c)
                         to[panel_width * i.row() + c] += i.value() * from[panel_width * j + c];
                   m_x.release(panel);
                 });
    m_x = std::move(fine);
  }

  /// Iterates on a level until the first `count` residuals are at most `tolerance`. All vectors are
  /// improved once.
  /// \param is_verified whether the vectors are to be orthonormal to rounding, with all of the
  /// residuals computed from them
  /// \param progress is told which part of the work on the level is done
  void improve(std::size_t level, const Symmetric_matrix& s, const Symmetric_matrix& m,
               Eigen::Index count, double tolerance, bool is_verified,
               const std::function<void(double)>& progress) {
    m_level = level;
    m_s = &s;
    m_m = &m;
    m_values = m_masses = m_residuals = Eigen::VectorXd::Zero(m_x.columns());
    m_iterations = 0;
    orthonormalize(count);
    double first = 0, best = std::numeric_limits<double>::max();
    int last_improvement = 0;
    for(bool is_orthonormal = true;; ++m_iterations) {
      compute_corrections(tolerance);
      const double largest = m_residuals.maxCoeff();
      first = (std::max)(first, largest);
      progress(largest > tolerance ? std::log(first / largest) / std::log(first / tolerance) : 1);
      if(largest < gain_of_an_iteration * best) {
        best = largest;
        last_improvement = m_iterations;
      }
      const bool is_over = m_iterations >= m_options.maximum_iterations ||
                           m_iterations - last_improvement >= iterations_without_gain;
      if(!m_unconverged.empty() && !is_over) {
        // Products that follow from others gather rounding errors. When these show, start anew.
        is_orthonormal = largest > growth_of_rounding * best;
        if(is_orthonormal)
          orthonormalize(count);
        else
          project(count);
        extend_or_cut(count);
        continue;
      }
      if(is_orthonormal || !is_verified)
        break;
      orthonormalize(count);
      extend_or_cut(count);
      is_orthonormal = true;
      if(is_over) {
        compute_corrections(std::numeric_limits<double>::max());
        break;
      }
    }
  }

  /// of the last level
  int iterations() const { return m_iterations; }

  /// Moves the first vectors to `pairs`, normalised, with their values and residuals.
  void take_pairs(Eigen::Index count, Eigenpairs& pairs) {
    m_w.keep_columns(0);
    m_p.keep_columns(0);
    // copies of an eigenvalue may be out of order by rounding
    std::vector<Eigen::Index> order(count);
    std::iota(order.begin(), order.end(), Eigen::Index(0));
    std::stable_sort(order.begin(), order.end(),
                     [this](Eigen::Index i, Eigen::Index j) { return m_values[i] < m_values[j]; });
    pairs.values.resize(count);
    pairs.residuals.resize(count);
    Eigen::MatrixXd& result = pairs.vectors;
    result.resize(m_x.rows(), count);
    for(Eigen::Index i = 0; i < count; ++i) {
      pairs.values[i] = m_values[order[i]];
      pairs.residuals[i] = m_residuals[order[i]];
    }
    std::vector<Eigen::Index> place(count);
    for(Eigen::Index i = 0; i < count; ++i)
      place[order[i]] = i;
    for(Eigen::Index j = 0; j < count; ++j) {
      auto column = result.col(place[j]);
      for(Eigen::Index i = 0; i < m_x.rows(); ++i)
        column[i] = m_x.column(j)[panel_width * i];
      Eigen::Index largest;
      column.cwiseAbs().maxCoeff(&largest);
      column /= column[largest] < 0 ? -std::sqrt(m_masses[j]) : std::sqrt(m_masses[j]);
      if(j % panel_width == panel_width - 1)
        m_x.release(static_cast<std::size_t>(j / panel_width));
    }
    m_x = Column_panels<double>();
  }

private:
  using Block = Block_vector<panel_width>;
  using Row = Block_row<panel_width>;

  // The iteration ends if the largest residual does not fall below this fraction in so many steps.
  static constexpr double gain_of_an_iteration = 0.9;
  static constexpr int iterations_without_gain = 8;
  static constexpr double growth_of_rounding = 2;
  // Vectors whose values are larger than the last one that is asked for by less than this fraction
  // are improved as well: some of them may fall below it.
  static constexpr double gap_at_the_end = 1e-2;

  double eigenvalue(Eigen::Index i) const { return 1 / m_nu[i] - m_alpha; }

  /// Values and residuals of the active pairs, and for those that have not converged the
  /// preconditioned residuals. The latter remain active.
  void compute_corrections(double tolerance) {
    m_w.keep_columns(0);
    m_w = Column_panels<float>(m_x.rows(), static_cast<Eigen::Index>(m_active.size()));
    m_columns_of_w.clear();
    m_unconverged.clear();
    Block x(m_x.rows(), panel_width), sx, mx, w;
    for(std::size_t first = 0; first < m_active.size(); first += panel_width) {
      const int width = static_cast<int>(
          (std::min)(m_active.size() - first, static_cast<std::size_t>(panel_width)));
      x.setZero();
      Row lambda = Row::Zero();
      for(int c = 0; c < width; ++c) {
        const double* const from = m_x.column(m_active[first + c]);
        for(Eigen::Index i = 0; i < x.rows(); ++i)
          x(i, c) = from[panel_width * i];
        lambda[c] = eigenvalue(m_active[first + c]);
      }
      m_s->multiply<panel_width>(x, sx, m_options.is_parallel);
      m_m->multiply<panel_width>(x, mx, m_options.is_parallel);
      const Row energy = x.cwiseProduct(sx).colwise().sum(),
                mass = x.cwiseProduct(mx).colwise().sum(),
                scale = (sx - m_residual_shift * mx).colwise().norm();
      sx -= mx * lambda.matrix().asDiagonal();
      const Row norm = sx.colwise().norm();
      const std::size_t unconverged_before = m_unconverged.size();
      for(int c = 0; c < width; ++c) {
        const Eigen::Index i = m_active[first + c];
        m_masses[i] = mass[c];
        m_values[i] = energy[c] / mass[c];
        m_residuals[i] = norm[c] / scale[c];
        if(m_residuals[i] <= tolerance)
          continue;
        m_unconverged.push_back(i);
        m_columns_of_w.push_back(static_cast<Eigen::Index>(first) + c);
      }
      if(m_unconverged.size() == unconverged_before)
        continue;
      m_multigrid.apply<panel_width>(m_level, sx, w, Cycle::V, m_options.smoothing_steps,
                                     m_workspace);
      std::copy_n(w.data(), w.size(), m_w.panel(first / panel_width));
    }
    m_active = m_unconverged;
  }

  /// Makes the vectors orthonormal, and solves the problem in their span. All become active.
  void orthonormalize(Eigen::Index count) {
    m_w.keep_columns(0);
    m_p.keep_columns(0);
    m_columns_of_w.clear();
    m_owners_of_p.clear();
    m_known_s = m_known_m = Eigen::MatrixXd();
    m_unconverged.clear();
    project(count);
    m_active.resize(static_cast<std::size_t>(m_x.columns()));
    std::iota(m_active.begin(), m_active.end(), Eigen::Index(0));
  }

  /// the number of the first vectors, `count` and those after them whose values are near
  Eigen::Index end_of_near(Eigen::Index count) const {
    Eigen::Index end = count;
    while(end < m_x.columns() && m_nu[count - 1] <= (1 + gap_at_the_end) * m_nu[end])
      ++end;
    return end;
  }

  /// From the vectors after the first `count` those remain active, or become so, whose values are
  /// near.
  void extend_or_cut(Eigen::Index count) {
    const Eigen::Index end = end_of_near(count);
    m_residuals.tail(m_x.columns() - end).setZero();
    while(!m_active.empty() && m_active.back() >= end)
      m_active.pop_back();
    for(Eigen::Index i = count; i < end; ++i)
      if(m_active.empty() || m_active.back() < i)
        m_active.push_back(i);
  }

  /// Solves the problem on the space of all \f$X\f$, \f$P\f$ and \f$W\f$, sets \f$X\f$ to the
  /// solution, and \f$P\f$ to the changes of those that had not converged and may be active again.
  void project(Eigen::Index count) {
    const Eigen::Index nx = m_x.columns();
    std::vector<Panel_view> panels;
    add_views(m_x, panels);
    const Eigen::Index first_p = panel_width * static_cast<Eigen::Index>(panels.size());
    add_views(m_p, panels);
    const Eigen::Index first_w = panel_width * static_cast<Eigen::Index>(panels.size());
    add_views(m_w, panels);

    // The columns of the basis: their places among those of the panels, and, for the ones whose
    // products are known, in the matrices of these.
    std::vector<Eigen::Index> places(nx), known(nx);
    std::iota(places.begin(), places.end(), Eigen::Index(0));
    known = places;
    for(std::size_t c = 0; c < m_owners_of_p.size(); ++c)
      if(std::binary_search(m_unconverged.begin(), m_unconverged.end(), m_owners_of_p[c])) {
        places.push_back(first_p + static_cast<Eigen::Index>(c));
        known.push_back(nx + static_cast<Eigen::Index>(c));
      }
    if(m_known_s.size() == 0)
      known.clear();
    for(Eigen::Index c : m_columns_of_w)
      places.push_back(first_w + c);

    const Eigen::Index n = static_cast<Eigen::Index>(places.size()),
                       number_known = static_cast<Eigen::Index>(known.size());
    Eigen::MatrixXd s(n, n), m(n, n);
    for(Eigen::Index j = 0; j < number_known; ++j)
      for(Eigen::Index i = 0; i <= j; ++i) {
        s(i, j) = m_known_s(known[i], known[j]);
        m(i, j) = m_known_m(known[i], known[j]);
      }
    Block block(m_x.rows(), panel_width), sb, mb;
    for(Eigen::Index j = number_known; j < n;) {
      const std::size_t panel = static_cast<std::size_t>(places[j] / panel_width);
      if(panels[panel].doubles)
        std::copy_n(panels[panel].doubles, block.size(), block.data());
      else
        std::copy_n(panels[panel].floats, block.size(), block.data());
      m_s->multiply<panel_width>(block, sb, m_options.is_parallel);
      m_m->multiply<panel_width>(block, mb, m_options.is_parallel);
      const auto [of_s, of_m] = scalar_products(m_options.is_parallel, panels, panel + 1, sb, mb);
      for(; j < n && static_cast<std::size_t>(places[j] / panel_width) == panel; ++j)
        for(Eigen::Index i = 0; i <= j; ++i) {
          s(i, j) = of_s(places[i], places[j] % panel_width);
          m(i, j) = of_m(places[i], places[j] % panel_width);
        }
    }
    s.triangularView<Eigen::StrictlyLower>() = s.transpose();
    m.triangularView<Eigen::StrictlyLower>() = m.transpose();

    Eigen::MatrixXd vectors;
    std::tie(m_nu, vectors) = largest_pairs(m, s + m_alpha * m, nx);

    // X and P in terms of the basis
    const Eigen::Index end = end_of_near(count);
    while(!m_unconverged.empty() && m_unconverged.back() >= end)
      m_unconverged.pop_back();
    const Eigen::Index np = static_cast<Eigen::Index>(m_unconverged.size());
    Eigen::MatrixXd next(n, nx + np);
    next.leftCols(nx) = vectors;
    for(Eigen::Index j = 0; j < np; ++j)
      next.col(nx + j) = vectors.col(m_unconverged[j]);
    next.topRightCorner(nx, np).setZero();
    m_known_s = next.transpose() * (s * next).eval();
    m_known_m = next.transpose() * (m * next).eval();
    Eigen::MatrixXd coefficients =
        Eigen::MatrixXd::Zero(panel_width * static_cast<Eigen::Index>(panels.size()), nx + np);
    for(Eigen::Index i = 0; i < n; ++i)
      coefficients.row(places[i]) = next.row(i);
    // P takes the place of W, which has at least as many columns.
    combine(m_options.is_parallel, panels, coefficients.leftCols(nx), m_x,
            coefficients.rightCols(np), m_w);
    m_w.keep_columns(np);
    std::swap(m_p, m_w);
    m_w.keep_columns(0);
    m_owners_of_p = m_unconverged;
  }

  /// The `k` largest eigenvalues of \f$m y = \nu a y\f$, descending, and vectors with
  /// \f$y^T a y = 1\f$.
  static std::pair<Eigen::VectorXd, Eigen::MatrixXd>
  largest_pairs(const Eigen::MatrixXd& m, const Eigen::MatrixXd& a, Eigen::Index k) {
    constexpr double smallest_pivot = 1e-3, relative_cutoff = 1e-6;
    const Eigen::VectorXd scale =
        a.diagonal().unaryExpr([](double d) { return d > 0 ? 1 / std::sqrt(d) : 0.; });
    const Eigen::MatrixXd scaled_a = scale.asDiagonal() * a * scale.asDiagonal(),
                          scaled_m = scale.asDiagonal() * m * scale.asDiagonal();
    if(!scaled_a.allFinite() || !scaled_m.allFinite())
      throw Numerical_error("the eigenvalue iteration gave numbers that are not finite");
    // b^T a b = 1
    Eigen::MatrixXd basis;
    const Eigen::LLT<Eigen::MatrixXd> cholesky(scaled_a);
    if(cholesky.info() == Eigen::Success &&
       cholesky.matrixLLT().diagonal().minCoeff() > smallest_pivot)
      basis = cholesky.matrixU().solve(Eigen::MatrixXd::Identity(a.rows(), a.cols()));
    else {
      // Directions that are nearly dependent are left out.
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> of_a(scaled_a);
      const double cutoff = relative_cutoff * of_a.eigenvalues().maxCoeff();
      const Eigen::Index rank = (of_a.eigenvalues().array() > cutoff).count();
      if(rank < k)
        throw Numerical_error("the vectors of the eigenvalue iteration are linearly dependent");
      basis = of_a.eigenvectors().rightCols(rank) *
              of_a.eigenvalues().tail(rank).cwiseSqrt().cwiseInverse().asDiagonal();
    }
    const Eigen::MatrixXd reduced = basis.transpose() * (scaled_m * basis).eval();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver((reduced + reduced.transpose()) /
                                                                2);
    const Eigen::MatrixXd y = solver.eigenvectors().rightCols(k).rowwise().reverse();
    return {solver.eigenvalues().tail(k).reverse(), scale.asDiagonal() * (basis * y).eval()};
  }

  const Multigrid<>& m_multigrid;
  Multigrid_eigenpairs_options m_options;
  double m_alpha, m_residual_shift;
  std::size_t m_level = 0;
  const Symmetric_matrix *m_s = nullptr, *m_m = nullptr;
  int m_iterations = 0;
  Column_panels<double> m_x;
  // in single precision: they only have to span a good space
  Column_panels<float> m_p, m_w;
  Eigen::VectorXd m_nu, m_values, m_masses, m_residuals;
  Eigen::MatrixXd m_known_s, m_known_m; // products of the columns of X and P
  // numbers of columns of X, ascending
  std::vector<Eigen::Index> m_active;                     // those whose residuals are computed next
  std::vector<Eigen::Index> m_unconverged, m_owners_of_p; // those that have a column of W, of P
  std::vector<Eigen::Index> m_columns_of_w;               // which columns these are
  Multigrid<>::Workspace<panel_width> m_workspace;
};

/// reports which part of the work is done
class Eigenpairs_progress {
public:
  Eigenpairs_progress(std::function<bool(double)> callback, double total)
    : m_callback(std::move(callback)), m_total(total) {}

  void show(double fraction_of_step) {
    m_shown = (std::max)(m_shown, (m_done + m_step * fraction_of_step) / m_total);
    if(m_callback && !m_callback((std::min)(m_shown, 1.)))
      throw Canceled();
  }
  /// the last step is done, one with this part of the work comes next
  void next_step(double work) {
    m_done += m_step;
    m_step = work;
    show(0);
  }

private:
  std::function<bool(double)> m_callback;
  double m_total, m_done = 0, m_step = 0, m_shown = 0;
};

inline void check_levels(const std::vector<Eigen::SparseMatrix<double>>& stiffness,
                         const std::vector<Eigen::SparseMatrix<double>>& mass,
                         const std::vector<Eigen::SparseMatrix<double>>& prolongations) {
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
      if(!Eigen::Map<const Eigen::ArrayXd>(a->valuePtr(), a->nonZeros()).allFinite())
        throw Parameter_error(a == &s ? "stiffness" : "mass",
                              "has an entry that is not a finite number on level " +
                                  std::to_string(level));
  }
}

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Solvers
/// The `k` smallest eigenvalues of \f$S x = \lambda M x\f$, with multiplicities, and eigenvectors,
/// for symmetric positive semi-definite matrices that are given on all levels of a hierarchy.
///
/// *Nested iteration.* The coarsest level with ten unknowns for each vector is solved by
/// `smallest_eigenpairs()`. The eigenvectors of a level are prolongated to the next finer one and
/// improved there, until their residuals are at most 1e-2, on the finest level at most
/// `relative_tolerance`.
///
/// *Improvement* is by LOBPCG (A. V. Knyazev, *Toward the optimal preconditioned eigensolver*, SIAM
/// J. Sci. Comput. 23, 2001), preconditioned by one V-cycle for \f$S + \alpha M\f$, where
/// \f$\alpha\f$ is half of the tenth eigenvalue. Cycles are applied to eight vectors at a time, in
/// single precision; everything else is in double precision. About a third more vectors than asked
/// for are carried along: the last pairs converge the faster, the larger the gap to the first
/// eigenvalue beyond them is. Pairs that have converged are locked softly; at the end the vectors
/// are made orthonormal and all residuals computed once more, and the iteration goes on if one is
/// too large.
///
/// The stiffness matrix is to be stabilised, the mass matrix is not, see `assemble_operators()`.
/// Without stabilisation it takes more iterations, or does not get to the tolerance.
///
/// Takes a time of the order of \f$k\f$ cycles and of \f$k^2\f$ times the number of unknowns for
/// each iteration, of which 5 to 15 are needed on the finest level. Memory: matrices and hierarchy
/// as in `Poisson_solver`, and about \f$1.4\, k\f$ vectors in double precision and \f$2.4\, k\f$ in
/// single precision.
///
/// The result is the same for any number of threads.
///
/// \param stiffness,mass full symmetric matrices of the levels, coarsest first, each pair with the
/// same pattern
/// \param prolongations from each level to the next finer one
/// \param patches of each level but the coarsest, see `smoothing_patches()`
/// \param k number of pairs
/// \param options tolerance, iterations, threads, callback
/// \return pairs that are orthonormal with respect to \f$M\f$. If not all residuals got below the
/// tolerance, `converged` is `false` and the pairs are the best approximations that were found.
/// `iterations` are those on the finest level; 0 if that was solved by `smallest_eigenpairs()`,
/// because it is small.
/// \throws Parameter_error if sizes do not fit, if an entry is not finite, if `k` is not positive
/// or exceeds the number of independent functions, or if an option is outside its domain
/// \throws Numerical_error if the coarsest problem cannot be solved
/// \throws Canceled if the callback returned `false`
inline Eigenpairs
multigrid_eigenpairs(std::vector<Eigen::SparseMatrix<double>> stiffness,
                     std::vector<Eigen::SparseMatrix<double>> mass,
                     std::vector<Eigen::SparseMatrix<double>> prolongations,
                     std::vector<Smoothing_patches> patches, int k,
                     const Multigrid_eigenpairs_options& options = Multigrid_eigenpairs_options()) {
  using Sparse_matrix = Eigen::SparseMatrix<double>;
  constexpr int unknowns_of_a_start_vector = 10, smallest_number_of_guards = 8;
  constexpr double tolerance_of_coarse_levels = 1e-2;
  internal::check_levels(stiffness, mass, prolongations);
  if(!(options.relative_tolerance > 0 && options.relative_tolerance < 1))
    throw Parameter_error("relative_tolerance", "must be between 0 and 1");
  if(options.maximum_iterations < 0)
    throw Parameter_error("number_of_iterations", "must not be negative");
  if(options.smoothing_steps < 1)
    throw Parameter_error("smoothing_steps", "must be positive");

  if(patches.size() != prolongations.size())
    throw Parameter_error("patches", "are not given for each level but the coarsest");

  const std::size_t finest = stiffness.size() - 1;
  if(k < 1 || k > stiffness[finest].cols() / unknowns_of_a_start_vector) {
    Eigenpairs_options of_finest;
    of_finest.callback = options.callback;
    return smallest_eigenpairs(stiffness[finest], mass[finest], k, of_finest);
  }
  const int guards = (std::max)(smallest_number_of_guards, k / 3);
  const int block =
      (k + guards + internal::panel_width - 1) / internal::panel_width * internal::panel_width;
  std::size_t start = 0;
  while(start < finest && stiffness[start].cols() < unknowns_of_a_start_vector * block)
    ++start;
  double work = 0;
  for(std::size_t level = start; level <= finest; ++level)
    work += static_cast<double>(stiffness[level].cols());
  internal::Eigenpairs_progress progress(options.callback, work);
  progress.next_step(static_cast<double>(stiffness[start].cols()));
  Eigenpairs_options start_options;
  start_options.callback = [&progress](double part) {
    progress.show(part);
    return true;
  };
  if(start == finest)
    return smallest_eigenpairs(stiffness[finest], mass[finest], k, start_options);
  start_options.tolerance = 1e-6;
  const Eigenpairs at_start =
      smallest_eigenpairs(stiffness[start], mass[start], block, start_options);
  if(at_start.values.size() < block)
    throw Numerical_error("the problem on the coarsest level could not be solved");

  Eigenpairs pairs;
  pairs.shift = internal::natural_shift(mass[finest].coeffs().sum());
  const double alpha = (std::max)(at_start.values[(std::min)(block - 1, 9)] / 2, -pairs.shift);
  std::vector<Sparse_matrix> coarse(finest);
  for(std::size_t level = 0; level < finest; ++level)
    coarse[level] = stiffness[level] + alpha * mass[level];
  Sparse_matrix a = stiffness[finest] + alpha * mass[finest];
  std::vector<internal::Symmetric_matrix> s(finest + 1), m(finest + 1);
  for(std::size_t level = 0; level <= finest; ++level) {
    if(level > start) {
      s[level].take_half_of(stiffness[level]);
      m[level].take_half_of(mass[level]);
    }
    Sparse_matrix().swap(stiffness[level]);
    Sparse_matrix().swap(mass[level]);
  }
  std::vector<Sparse_matrix> from_start(prolongations.begin() + start, prolongations.end());
  const Multigrid<> multigrid(std::move(a),
                              {std::move(prolongations), std::move(patches), std::move(coarse)},
                              options.is_parallel);

  internal::Nested_lobpcg solver(multigrid, alpha, pairs.shift, at_start.vectors, options);
  for(std::size_t level = start + 1; level <= finest; ++level) {
    progress.next_step(static_cast<double>(s[level].rows()));
    solver.prolongate(from_start[level - start - 1]);
    Sparse_matrix().swap(from_start[level - start - 1]);
    const bool is_finest = level == finest;
    solver.improve(level, s[level], m[level], is_finest ? k : block,
                   is_finest ? options.relative_tolerance : tolerance_of_coarse_levels, is_finest,
                   [&progress](double part) { progress.show(part); });
  }
  pairs.iterations = solver.iterations();
  solver.take_pairs(k, pairs);
  pairs.converged = (pairs.residuals.array() <= options.relative_tolerance).all();
  return pairs;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_MULTIGRID_EIGENPAIRS_H

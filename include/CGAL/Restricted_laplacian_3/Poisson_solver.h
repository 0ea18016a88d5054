// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_POISSON_SOLVER_H
#define CGAL_RESTRICTED_LAPLACIAN_3_POISSON_SOLVER_H

#include <CGAL/Restricted_laplacian_3/Multigrid.h>
#include <CGAL/Restricted_laplacian_3/Solve_report.h>
#include <CGAL/Restricted_laplacian_3/conjugate_gradient.h>
#include <CGAL/Restricted_laplacian_3/exceptions.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Ref
/// What a `Poisson_solver` does unless told otherwise.
struct Poisson_solver_options {
  /// \f$ \|b - A x\|_2 \le \f$ tolerance times \f$\|b\|_2\f$ ends the iteration
  double relative_tolerance = 1e-3;
  int maximum_iterations = 500;
  Cycle cycle = Cycle::V;
  /// smoothing steps before, and again after the coarse correction
  int smoothing_steps = 1;
  /// iterate cycles alone, instead of preconditioning conjugate gradients with them
  bool stand_alone_multigrid = false;
};

namespace internal {

/// Number of the connected component of each unknown in the graph of a symmetric matrix, counted
/// from 0, and the number of components.
inline std::pair<std::vector<int>, int>
connected_components(const Eigen::SparseMatrix<double>& a) {
  std::vector<int> component(a.cols(), -1), stack;
  int number = 0;
  for(int start = 0; start < a.cols(); ++start) {
    if(component[start] != -1)
      continue;
    component[start] = number;
    stack.push_back(start);
    while(!stack.empty()) {
      const int j = stack.back();
      stack.pop_back();
      for(Eigen::SparseMatrix<double>::InnerIterator i(a, j); i; ++i)
        if(component[i.row()] == -1) {
          component[i.row()] = number;
          stack.push_back(static_cast<int>(i.row()));
        }
    }
    ++number;
  }
  return {std::move(component), number};
}

/// The part of the kernel of a matrix that is known beforehand: functions that are constant on one
/// connected component and 0 on the others, as far as the matrix annihilates them.
class Constant_kernel {
public:
  /// Constants count as annihilated if no entry of \f$A 1_c\f$ exceeds this fraction of the largest
  /// diagonal entry of the component: a thousand times the rounding error of a row sum.
  static constexpr double relative_tolerance = 1e-13;

  /// \param integrals integral of each element: weights of the mean
  Constant_kernel(const Eigen::SparseMatrix<double>& a, Eigen::VectorXd integrals)
    : m_integrals(std::move(integrals)) {
    int number = 0;
    std::tie(m_component, number) = connected_components(a);
    const Eigen::VectorXd sums = a * Eigen::VectorXd::Ones(a.cols());
    const Eigen::VectorXd diagonal = a.diagonal();
    std::vector<double> largest_sum(number, 0.), largest_diagonal(number, 0.);
    m_areas.assign(number, 0.);
    for(std::size_t i = 0; i < m_component.size(); ++i) {
      const int c = m_component[i];
      largest_sum[c] = (std::max)(largest_sum[c], std::abs(sums[i]));
      largest_diagonal[c] = (std::max)(largest_diagonal[c], std::abs(diagonal[i]));
      m_areas[c] += m_integrals[i];
    }
    m_is_annihilated.resize(number);
    for(int c = 0; c < number; ++c) {
      m_is_annihilated[c] = largest_diagonal[c] > 0 && m_areas[c] > 0 &&
                            largest_sum[c] <= relative_tolerance * largest_diagonal[c];
      m_dimension += m_is_annihilated[c];
    }
  }

  int dimension() const { return m_dimension; }

  /// Subtracts the load of a constant on each component, so that the loads of the component sum to
  /// 0: the right-hand side of \f$f\f$ becomes that of \f$f\f$ minus its mean.
  template <int K> void project_load(Block_vector<K>& b) const {
    subtract_means<K>(b, [](double) { return 1.; }, [this](std::size_t i) { return m_integrals[i]; });
  }

  /// Subtracts a constant on each component, so that the mean over the component is 0.
  template <int K> void project_function(Block_vector<K>& x) const {
    subtract_means<K>(x, [](double integral) { return integral; }, [](std::size_t) { return 1.; });
  }

private:
  template <int K, class Weight, class Shift>
  void subtract_means(Block_vector<K>& v, Weight&& weight, Shift&& shift) const {
    if(m_dimension == 0)
      return;
    std::vector<Block_row<K>, Eigen::aligned_allocator<Block_row<K>>> means(m_areas.size(),
                                                                            Block_row<K>::Zero());
    for(std::size_t i = 0; i < m_component.size(); ++i)
      means[m_component[i]] += weight(m_integrals[i]) * row<K>(v, i);
    for(std::size_t c = 0; c < means.size(); ++c)
      means[c] *= m_is_annihilated[c] ? 1 / m_areas[c] : 0.;
    for(std::size_t i = 0; i < m_component.size(); ++i)
      row<K>(v, i) -= shift(i) * means[m_component[i]];
  }

  Eigen::VectorXd m_integrals;
  std::vector<int> m_component;
  std::vector<double> m_areas;
  std::vector<char> m_is_annihilated;
  int m_dimension = 0;
};

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Ref
/// Solves \f$A x = b\f$ for a symmetric positive semi-definite matrix by conjugate gradients that
/// are preconditioned with a multigrid cycle, from a first guess by nested iteration:
/// \f$A = S\f$ for the Poisson problem, \f$A = S + \alpha M\f$ for the screened one. It is set up
/// once and then solves for any number of right-hand sides. Knows matrices only, no surface.
///
/// *Singular systems.* If \f$A\f$ annihilates the functions that are constant on a connected
/// component (of the graph of the matrix), the system has a solution only for right-hand sides whose
/// entries sum to 0 on the component. The load of a constant is subtracted from \f$b\f$ to achieve
/// this, which turns the load of \f$f\f$ into that of \f$f\f$ minus its mean on the component, and
/// of all solutions the one with mean 0 on the component is returned. Near-kernel (combinations of
/// elements that nearly vanish on the surface) is left alone: its coefficients carry no information,
/// and do not change the function on the surface.
class Poisson_solver {
public:
  using Sparse_matrix = Eigen::SparseMatrix<double>;
  using Options = Poisson_solver_options;

  /// \param a the matrix
  /// \param prolongations from each level to the next finer one, coarsest first
  /// \param element_integrals \f$\int b_i\f$ for each unknown
  /// \throws Parameter_error if sizes do not fit or an option is outside its domain
  Poisson_solver(Sparse_matrix a, std::vector<Sparse_matrix> prolongations,
                 Eigen::VectorXd element_integrals, const Options& options = Options())
    : m_options(checked(a, element_integrals, options)), m_timer(started_timer()),
      m_multigrid(std::move(a), std::move(prolongations)),
      m_kernel(m_multigrid.matrix(), reordered(element_integrals)) {
    m_setup_seconds = m_timer.time();
  }

  const Options& options() const { return m_options; }
  /// the hierarchy; it has a numbering of its own
  const Multigrid<>& multigrid() const { return m_multigrid; }
  /// number of connected components whose constants are in the kernel of the matrix
  int kernel_dimension() const { return m_kernel.dimension(); }
  /// wall-clock seconds that the construction took
  double setup_seconds() const { return m_setup_seconds; }

  /// Solves for all columns of `b`; up to four at a time share each pass over the matrices.
  /// \param b right-hand sides, as many rows as the matrix: a vector, or a matrix of columns
  /// \param x on return the solutions, of the same shape; its old content is not used
  /// \throws Parameter_error if the number of rows does not fit, or if an entry is not finite
  template <class RightHandSides, class Solutions>
  Solve_report solve(const Eigen::MatrixBase<RightHandSides>& b,
                     Eigen::PlainObjectBase<Solutions>& x) const {
    if(b.rows() != matrix().rows())
      throw Parameter_error("b", "has " + std::to_string(b.rows()) + " rows, but the matrix has " +
                                     std::to_string(matrix().rows()));
    if(!b.allFinite())
      throw Parameter_error("b", "has an entry that is not a finite number");
    Solve_report report;
    report.converged = true;
    report.setup_seconds = m_setup_seconds;
    CGAL::Real_timer timer;
    timer.start();
    x.derived().resize(b.rows(), b.cols());
    for(Eigen::Index column = 0; column < b.cols();) {
      switch(b.cols() - column) {
      case 1: column += solve_block<1>(b, x, column, report); break;
      case 2: column += solve_block<2>(b, x, column, report); break;
      case 3: column += solve_block<3>(b, x, column, report); break;
      default: column += solve_block<4>(b, x, column, report);
      }
    }
    report.solve_seconds = timer.time();
    return report;
  }

private:
  const Sparse_matrix& matrix() const { return m_multigrid.matrix(); }

  /// rows in the numbering of the hierarchy
  template <class Rows> typename Rows::PlainObject reordered(const Rows& rows) const {
    typename Rows::PlainObject result(rows.rows(), rows.cols());
    for(Eigen::Index i = 0; i < rows.rows(); ++i)
      result.row(i) = rows.row(m_multigrid.order()[i]);
    return result;
  }

  static Options checked(const Sparse_matrix& a, const Eigen::VectorXd& integrals,
                         const Options& options) {
    if(integrals.size() != a.cols())
      throw Parameter_error("element_integrals", "does not fit the size of the matrix");
    if(!(options.relative_tolerance > 0 && options.relative_tolerance < 1))
      throw Parameter_error("relative_tolerance", "must be between 0 and 1");
    if(options.maximum_iterations < 0)
      throw Parameter_error("number_of_iterations", "must not be negative");
    if(options.smoothing_steps < 1)
      throw Parameter_error("smoothing_steps", "must be positive");
    return options;
  }

  static CGAL::Real_timer started_timer() {
    CGAL::Real_timer timer;
    timer.start();
    return timer;
  }

  template <int K, class RightHandSides, class Solutions>
  int solve_block(const Eigen::MatrixBase<RightHandSides>& b_all,
                  Eigen::PlainObjectBase<Solutions>& x_all, Eigen::Index column,
                  Solve_report& report) const {
    using Block = internal::Block_vector<K>;
    using Row = internal::Block_row<K>;
    Block b(b_all.rows(), K), x, r;
    for(Eigen::Index i = 0; i < b.rows(); ++i)
      b.row(i) = b_all.row(m_multigrid.order()[i]).template segment<K>(column);
    m_kernel.project_load<K>(b);
    const Row norm = internal::dot<K>(b, b).sqrt();
    const Row target = m_options.relative_tolerance * norm;

    Multigrid<>::Workspace<K> workspace;
    const auto multiply = [this](const Block& p, Block& q) {
      internal::multiply<K>(matrix(), p, q);
    };
    const auto precondition = [&](const Block& p, Block& q) {
      m_multigrid.apply<K>(p, q, m_options.cycle, m_options.smoothing_steps, workspace);
    };
    const auto project = [this](Block& p) { m_kernel.project_load<K>(p); };

    m_multigrid.nested_iteration<K>(b, x, m_options.cycle, m_options.smoothing_steps, workspace);
    internal::residual<K>(matrix(), b, x, r);
    project(r);

    // The recursively updated residual drifts away from the true one. Start again from the true one
    // as long as that helps.
    int iterations = 0;
    Row residual = internal::dot<K>(r, r).sqrt();
    while((residual > target).any() && iterations < m_options.maximum_iterations) {
      if(m_options.stand_alone_multigrid)
        internal::stationary_iteration<K>(multiply, precondition, project, r, x, target, iterations,
                                          m_options.maximum_iterations);
      else
        internal::conjugate_gradient<K>(multiply, precondition, project, r, x, target, iterations,
                                        m_options.maximum_iterations);
      internal::residual<K>(matrix(), b, x, r);
      project(r);
      const Row next = internal::dot<K>(r, r).sqrt();
      const bool improved = (next.max(target) < residual.max(target) * restart_gain).any();
      residual = next;
      if(!improved)
        break;
    }

    m_kernel.project_function<K>(x);
    for(Eigen::Index i = 0; i < x.rows(); ++i)
      x_all.row(m_multigrid.order()[i]).template segment<K>(column) = x.row(i);
    report.iterations = (std::max)(report.iterations, iterations);
    for(int k = 0; k < K; ++k) {
      const double relative = norm[k] > 0 ? residual[k] / norm[k] : 0;
      report.relative_residuals.push_back(relative);
      report.relative_residual = (std::max)(report.relative_residual, relative);
      report.converged = report.converged && relative <= m_options.relative_tolerance;
    }
    return K;
  }

  /// a restart has to reduce a residual by this factor at least, else the iteration ends
  static constexpr double restart_gain = 0.9;

  Options m_options;
  CGAL::Real_timer m_timer;
  Multigrid<> m_multigrid;
  internal::Constant_kernel m_kernel;
  double m_setup_seconds;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_POISSON_SOLVER_H

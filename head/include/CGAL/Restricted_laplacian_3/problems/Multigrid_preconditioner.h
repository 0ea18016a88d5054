// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MULTIGRID_PRECONDITIONER_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MULTIGRID_PRECONDITIONER_H

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/problems/multigrid_levels.h>
#include <CGAL/Restricted_laplacian_3/solvers/Multigrid.h>
#include <CGAL/Restricted_laplacian_3/solvers/shared/block_vectors.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <Eigen/Core>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Solvers
/// A multigrid cycle as a preconditioner of Eigen's iterative solvers, for a system in a space of
/// splines and with any smoother:
/// \code
/// using Preconditioner = Multigrid_preconditioner<>;
/// Eigen::ConjugateGradient<Sparse_matrix, Eigen::Lower | Eigen::Upper, Preconditioner> solver;
/// solver.preconditioner() = Preconditioner(space, a);
/// solver.compute(a);
/// \endcode
///
/// `Poisson_solver` does the same and more: it splits off the constants of a singular system,
/// starts from a nested iteration, and takes several right-hand sides at once. This class is for
/// other iterations and for smoothers of one's own.
///
/// The cycle is in single precision: relative accuracy of a single application is about
/// \f$10^{-6}\f$, which does not limit that of an iteration. An application takes time
/// and memory proportional to the entries of the matrices of all levels.
///
/// \tparam Smoother a model of `MultigridSmoother_3`
template <class Smoother = Patch_smoother> class Multigrid_preconditioner {
public:
  /// an empty preconditioner, to be assigned to before it is used
  Multigrid_preconditioner() = default;

  /// \param space whose levels make the hierarchy
  /// \param a a symmetric positive semi-definite matrix of the finest level of the space; the
  /// coarse matrices are the Galerkin products
  /// \param is_parallel whether several threads are used; results do not depend on that
  /// \param cycle shape of the cycle
  /// \param smoothing_steps before, and again after the coarse correction; at least 1
  /// \throws Parameter_error if the matrix does not fit the space, or there is no smoothing step
  Multigrid_preconditioner(const Spline_space_3& space, const Sparse_matrix& a,
                           bool is_parallel = false, Cycle cycle = Cycle::V,
                           int smoothing_steps = 1)
    : m_multigrid(a, multigrid_levels(space), is_parallel), m_cycle(cycle),
      m_smoothing_steps(smoothing_steps) {
    if(smoothing_steps < 1)
      throw Parameter_error("smoothing_steps", "must be positive");
  }

  /// the hierarchy
  const Multigrid<Smoother>& multigrid() const { return m_multigrid; }

  /// one cycle for the right-hand side `b`, from \f$x = 0\f$
  /// \throws Parameter_error if `b` does not fit the matrix
  template <class RightHandSide>
  Eigen::VectorXd solve(const Eigen::MatrixBase<RightHandSide>& b) const {
    if(b.rows() != m_multigrid.size() || b.cols() != 1)
      throw Parameter_error("b", "does not fit the size of the matrix");
    const internal::Block_vector<1> load = b;
    internal::Block_vector<1> x;
    typename Multigrid<Smoother>::template Workspace<1> workspace;
    m_multigrid.template apply<1>(load, x, m_cycle, m_smoothing_steps, workspace);
    return x;
  }

  /// \name Interface of Eigen
  /// Eigen's solvers call these for a matrix; the hierarchy remains that of the constructor.
  /// @{

  /// does nothing
  template <class Matrix> Multigrid_preconditioner& analyzePattern(const Matrix&) { return *this; }
  /// does nothing
  template <class Matrix> Multigrid_preconditioner& factorize(const Matrix&) { return *this; }
  /// does nothing
  template <class Matrix> Multigrid_preconditioner& compute(const Matrix&) { return *this; }
  /// always success
  Eigen::ComputationInfo info() const { return Eigen::Success; }
  /// @}

private:
  Multigrid<Smoother> m_multigrid;
  Cycle m_cycle = Cycle::V;
  int m_smoothing_steps = 1;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MULTIGRID_PRECONDITIONER_H

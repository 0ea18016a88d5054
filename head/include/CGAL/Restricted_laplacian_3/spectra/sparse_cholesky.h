// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_SPARSE_CHOLESKY_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_SPARSE_CHOLESKY_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#ifdef CGAL_RESTRICTED_LAPLACIAN_3_USE_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Solvers
/// \f$P K P^T = L L^T\f$ by Eigen, with the AMD ordering.
/// \cgalModels `SparseCholesky_3`
class Eigen_simplicial_cholesky {
public:
  /// factorizes \f$K\f$
  void compute(const Eigen::SparseMatrix<double>& k) { m_factor.compute(k); }
  /// whether that succeeded
  Eigen::ComputationInfo info() const { return m_factor.info(); }
  /// \f$L^{-1} P b\f$
  Eigen::VectorXd solve_lower(const Eigen::VectorXd& b) const {
    return m_factor.matrixL().solve(m_factor.permutationP() * b);
  }
  /// \f$P^T L^{-T} b\f$
  Eigen::VectorXd solve_upper(const Eigen::VectorXd& b) const {
    return m_factor.permutationPinv() * Eigen::VectorXd(m_factor.matrixU().solve(b));
  }
  /// \f$K^{-1} b\f$, for each column of \f$b\f$
  Eigen::MatrixXd solve(const Eigen::MatrixXd& b) const { return m_factor.solve(b); }

private:
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> m_factor;
};

#ifdef CGAL_RESTRICTED_LAPLACIAN_3_USE_CHOLMOD

/// \ingroup PkgRestrictedLaplacian3Solvers
/// \f$P K P^T = L L^T\f$ by CHOLMOD. Exists if the macro
/// `CGAL_RESTRICTED_LAPLACIAN_3_USE_CHOLMOD` is defined.
/// \cgalModels `SparseCholesky_3`
class Cholmod_cholesky {
public:
  /// \cond
  // With the AMD ordering only: others are tried by default, which takes longer than what they save
  // in less than a hundred solves.
  void order_by_amd() { m_factor.order_by_amd(); }
  /// \endcond
  /// factorizes \f$K\f$
  void compute(const Eigen::SparseMatrix<double>& k) { m_factor.compute(k); }
  /// whether that succeeded
  Eigen::ComputationInfo info() const { return m_factor.info(); }
  /// \f$L^{-1} P b\f$
  Eigen::VectorXd solve_lower(const Eigen::VectorXd& b) const {
    return m_factor.step(CHOLMOD_L, m_factor.step(CHOLMOD_P, b));
  }
  /// \f$P^T L^{-T} b\f$
  Eigen::VectorXd solve_upper(const Eigen::VectorXd& b) const {
    return m_factor.step(CHOLMOD_Pt, m_factor.step(CHOLMOD_Lt, b));
  }
  /// \f$K^{-1} b\f$, for each column of \f$b\f$
  Eigen::MatrixXd solve(const Eigen::MatrixXd& b) const { return m_factor.step(CHOLMOD_A, b); }

private:
  /// Eigen's interface offers the whole solve only.
  struct Factor : Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>> {
    // By default CHOLMOD writes a warning to the standard output when a factorization fails.
    Factor() { this->cholmod().print = 0; }

    void order_by_amd() {
      this->cholmod().nmethods = 1;
      this->cholmod().method[0].ordering = CHOLMOD_AMD;
      this->cholmod().postorder = 1;
    }

    /// \tparam Columns a vector or a matrix
    template <class Columns> Columns step(int system, Columns b) const {
      // of this call alone, so that several threads may solve at once
      cholmod_common common;
      cholmod_start(&common);
      common.print = 0;
      cholmod_dense view = Eigen::viewAsCholmod(b);
      cholmod_dense* x = cholmod_solve(system, this->m_cholmodFactor, &view, &common);
      if(x)
        b = Eigen::Map<const Columns>(static_cast<const double*>(x->x), b.rows(), b.cols());
      const bool is_solved = x != nullptr;
      cholmod_free_dense(&x, &common);
      cholmod_finish(&common);
      if(!is_solved)
        throw Numerical_error("CHOLMOD could not solve a system");
      return b;
    }
  };

  Factor m_factor;
};

#endif

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_SPARSE_CHOLESKY_H

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

private:
  /// Eigen's interface offers the whole solve only.
  struct Factor : Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>> {
    // By default CHOLMOD writes a warning to the standard output when a factorization fails.
    Factor() { this->cholmod().print = 0; }

    Eigen::VectorXd step(int system, Eigen::VectorXd b) const {
      // a solve changes only statistics and work space in there
      cholmod_common& common = const_cast<Factor*>(this)->cholmod();
      cholmod_dense view = Eigen::viewAsCholmod(b);
      cholmod_dense* x = cholmod_solve(system, this->m_cholmodFactor, &view, &common);
      if(!x)
        throw Numerical_error("CHOLMOD could not solve a triangular system");
      const Eigen::VectorXd result =
          Eigen::Map<const Eigen::VectorXd>(static_cast<const double*>(x->x), b.size());
      cholmod_free_dense(&x, &common);
      return result;
    }
  };

  Factor m_factor;
};

#endif

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_SPARSE_CHOLESKY_H

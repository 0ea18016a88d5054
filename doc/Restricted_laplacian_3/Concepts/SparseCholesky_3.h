// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\headerfile sparse_cholesky.h <CGAL/Restricted_laplacian_3/spectra/sparse_cholesky.h>
\ingroup PkgRestrictedLaplacian3Concepts
\cgalConcept

A factorization \f$P K P^T = L L^T\f$ of a sparse symmetric positive definite matrix, with a
permutation \f$P\f$ and a triangular matrix \f$L\f$, on which
`CGAL::Restricted_laplacian_3::shift_invert_eigenpairs()` iterates. The two halves of a solve are
needed by themselves.

\cgalRefines `DefaultConstructible`

\cgalHasModel `CGAL::Restricted_laplacian_3::Eigen_simplicial_cholesky`
\cgalHasModel `CGAL::Restricted_laplacian_3::Cholmod_cholesky`
*/
class SparseCholesky_3 {
public:
  /*!
  factorizes a matrix, and gives an earlier factorization up. Is called again, with a matrix that is
  more positive, as long as `info()` says that it failed.
  \param k symmetric; all of its entries are stored, and the rows of each column are sorted
  */
  void compute(const Eigen::SparseMatrix<double>& k);

  /*!
  `Eigen::Success` if the last factorization succeeded, that is if \f$K\f$ is positive definite
  */
  Eigen::ComputationInfo info() const;

  /*!
  \f$L^{-1} P b\f$
  */
  Eigen::VectorXd solve_lower(const Eigen::VectorXd& b) const;

  /*!
  \f$P^T L^{-T} b\f$
  */
  Eigen::VectorXd solve_upper(const Eigen::VectorXd& b) const;
};

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_INTERNAL_INVERTED_PENCIL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_INTERNAL_INVERTED_PENCIL_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cmath>
#include <functional>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The operator \f$C = R^{-T} M R^{-1}\f$ in the form that Spectra takes, where
/// \f$R^T R = K = S - \sigma M + \tau D\f$, \f$D = \mathrm{diag}(S - \sigma M)\f$, is factorized.
///
/// The eigenvalues \f$\nu = 1 / (\lambda - \sigma)\f$ of \f$C\f$ are those of \f$K^{-1} M\f$, the
/// eigenvectors \f$y = R x\f$ are orthogonal in the plain scalar product. An iteration with
/// \f$K^{-1} M\f$ in the scalar product of \f$M\f$ would break down, because \f$M\f$ is singular to
/// rounding: squared norms of near-kernel functions come out negative.
/// \tparam SparseCholesky a model of `SparseCholesky_3`
template <class SparseCholesky> class Inverted_pencil {
public:
  using Scalar = double;

  /// called at each application of the operator
  std::function<void()> on_operation;

  /// largest \f$\tau\f$ that is tried; beyond, eigenvalues would lose more than half of their
  /// digits
  static constexpr double largest_regularization = 1e-8;
  /// factor of \f$\tau\f$ from one attempt to the next
  static constexpr double growth_of_regularization = 100;

  /// \param s,m compressed
  Inverted_pencil(const Eigen::SparseMatrix<double>& s, const Eigen::SparseMatrix<double>& m,
                  double sigma, double tau)
    : m_mass(m), m_regularization(tau) {
    Eigen::SparseMatrix<double> k = s - sigma * m;
    if(k.diagonal().minCoeff() < -largest_regularization * k.diagonal().maxCoeff())
      throw Numerical_error("the shifted stiffness matrix has a negative diagonal entry");
    m_scale = k.diagonal().unaryExpr([](double d) { return d > 0 ? 1 / std::sqrt(d) : 0.; });
    // Scaled to a unit diagonal, so that tau is relative to each entry; an empty row gets a 1.
    for(int j = 0; j < k.cols(); ++j)
      for(Eigen::SparseMatrix<double>::InnerIterator i(k, j); i; ++i)
        i.valueRef() *= m_scale[i.row()] * m_scale[j];
    Eigen::SparseMatrix<double> identity(k.rows(), k.cols()), empty_rows(k.rows(), k.cols());
    identity.setIdentity();
    empty_rows.setIdentity();
    for(int j = 0; j < k.cols(); ++j)
      empty_rows.valuePtr()[j] = m_scale[j] == 0 ? 1 : 0;
    k += empty_rows;
    for(;; m_regularization *= growth_of_regularization) {
      if(m_regularization > largest_regularization)
        throw Numerical_error("the shifted stiffness matrix cannot be factorized: it is not "
                              "positive semi-definite");
      m_cholesky.compute(k + m_regularization * identity);
      if(m_cholesky.info() == Eigen::Success)
        break;
    }
  }

  Eigen::Index rows() const { return m_scale.size(); }
  Eigen::Index cols() const { return m_scale.size(); }
  double regularization() const { return m_regularization; }

  /// \f$x = R^{-1} y\f$
  Eigen::VectorXd vector(const Eigen::VectorXd& y) const {
    return m_scale.cwiseProduct(m_cholesky.solve_upper(y));
  }

  /// \f$ (C - Y \mathrm{diag}(\nu) Y^T)\, y \f$ with the deflated pairs \f$Y, \nu\f$
  void perform_op(const double* in, double* out) const {
    if(on_operation)
      on_operation();
    const Eigen::Map<const Eigen::VectorXd> y(in, rows());
    Eigen::Map<Eigen::VectorXd> result(out, rows());
    const Eigen::VectorXd mx = m_mass * vector(y);
    result = m_cholesky.solve_lower(m_scale.cwiseProduct(mx));
    if(m_deflated.cols() > 0)
      result -= m_deflated * m_deflated_values.cwiseProduct(m_deflated.transpose() * y);
  }

  /// \f$y = R x = R^{-T} K x\f$ for a vector of the kernel of \f$S\f$ with \f$y^T y = 1\f$, up to
  /// \f$\tau\f$
  Eigen::VectorXd kernel_vector(const Eigen::VectorXd& x) const {
    return m_cholesky.solve_lower(m_scale.cwiseProduct(m_mass * x)).normalized();
  }

  /// from now on moves further pairs to the far end of the spectrum
  void deflate(const Eigen::MatrixXd& y, const Eigen::VectorXd& nu) {
    m_deflated.conservativeResize(rows(), m_deflated.cols() + y.cols());
    m_deflated.rightCols(y.cols()) = y;
    m_deflated_values.conservativeResize(m_deflated.cols());
    m_deflated_values.tail(y.cols()) = nu;
  }

private:
  const Eigen::SparseMatrix<double>& m_mass;
  Eigen::VectorXd m_scale;
  double m_regularization;
  SparseCholesky m_cholesky;
  Eigen::MatrixXd m_deflated;
  Eigen::VectorXd m_deflated_values;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_INTERNAL_INVERTED_PENCIL_H

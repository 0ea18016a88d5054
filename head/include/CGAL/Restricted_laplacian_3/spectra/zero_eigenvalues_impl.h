// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_ZERO_EIGENVALUES_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_ZERO_EIGENVALUES_IMPL_H

#include <CGAL/Restricted_laplacian_3/spectra/zero_eigenvalues.h>

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <string>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::VectorXd
checked_eigenvalues(const Eigen::VectorXd& eigenvalues) {
  if(eigenvalues.size() == 0)
    throw Parameter_error("eigenvalues", "is empty");
  if(!eigenvalues.allFinite())
    throw Parameter_error("eigenvalues", "has an entry that is not a finite number");
  if(!std::is_sorted(eigenvalues.begin(), eigenvalues.end()))
    throw Parameter_error("eigenvalues", "is not ascending");
  const double tolerance = zero_eigenvalue_tolerance * eigenvalues.cwiseAbs().maxCoeff();
  if(eigenvalues[0] < -tolerance)
    throw Parameter_error("eigenvalues",
                          "has the negative entry " + std::to_string(eigenvalues[0]));
  return eigenvalues.unaryExpr([tolerance](double l) { return l <= tolerance ? 0. : l; });
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::Index number_of_zeros(const Eigen::VectorXd& checked) {
  return (checked.array() == 0).count();
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::Index
number_of_zeros_before_others(const Eigen::VectorXd& checked) {
  const Eigen::Index zeros = number_of_zeros(checked);
  if(zeros == checked.size())
    throw Parameter_error("eigenvalues", "has no entry but zeros");
  return zeros;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
check_columns(const Eigen::VectorXd& eigenvalues, const Eigen::Ref<const Eigen::MatrixXd>& values) {
  if(values.cols() != eigenvalues.size())
    throw Parameter_error("values", "has " + std::to_string(values.cols()) +
                                        " columns, but there are " +
                                        std::to_string(eigenvalues.size()) + " eigenvalues");
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void check_positive(const char* name,
                                                       const Eigen::VectorXd& numbers) {
  for(double x : numbers)
    if(!(x > 0 && std::isfinite(x)))
      throw Parameter_error(name, "is or contains " + std::to_string(x) +
                                      ", but must be positive and finite");
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void check_positive(const char* name, double number) {
  check_positive(name, Eigen::VectorXd::Constant(1, number));
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::VectorXd
with_exact_zeros(const Eigen::VectorXd& eigenvalues, double area) {
  check_positive("area", area);
  const double tolerance = zero_eigenvalue_tolerance * 4 * 3.14159265358979323846 / area;
  return eigenvalues.unaryExpr([tolerance](double l) { return std::abs(l) <= tolerance ? 0. : l; });
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::Index
number_of_zero_eigenvalues(const Eigen::VectorXd& eigenvalues) {
  return internal::number_of_zeros(internal::checked_eigenvalues(eigenvalues));
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_ZERO_EIGENVALUES_IMPL_H

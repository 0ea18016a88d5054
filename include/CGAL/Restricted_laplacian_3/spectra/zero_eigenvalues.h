// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_ZERO_EIGENVALUES_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_ZERO_EIGENVALUES_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Descriptors
/// An eigenvalue of a sequence counts as 0 if it is at most this fraction of the largest one.
///
/// Computed zeros are rounding error, \f$10^{-14}\f$ of the first other eigenvalue, or up to the
/// tolerance of the eigensolver, \f$10^{-10}\f$. Eigenvalues that are not 0 grow linearly (Weyl's
/// law); the first is smaller than its share only where parts of the surface are nearly separate.
constexpr double zero_eigenvalue_tolerance = 1e-8;

namespace internal {

/// The eigenvalues with those that count as 0 replaced by 0.
/// \throws Parameter_error if there is none, or if they are not finite, ascending and not negative
inline Eigen::VectorXd checked_eigenvalues(const Eigen::VectorXd& eigenvalues) {
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

/// number of leading zeros, for the result of `checked_eigenvalues()`
inline Eigen::Index number_of_zeros(const Eigen::VectorXd& checked) {
  return (checked.array() == 0).count();
}

/// the same, where one that is not 0 is needed
/// \throws Parameter_error if there is none
inline Eigen::Index number_of_zeros_before_others(const Eigen::VectorXd& checked) {
  const Eigen::Index zeros = number_of_zeros(checked);
  if(zeros == checked.size())
    throw Parameter_error("eigenvalues", "has no entry but zeros");
  return zeros;
}

/// \throws Parameter_error if `values` does not have a column for each eigenvalue
inline void check_columns(const Eigen::VectorXd& eigenvalues,
                          const Eigen::Ref<const Eigen::MatrixXd>& values) {
  if(values.cols() != eigenvalues.size())
    throw Parameter_error("values", "has " + std::to_string(values.cols()) +
                                        " columns, but there are " +
                                        std::to_string(eigenvalues.size()) + " eigenvalues");
}

/// \throws Parameter_error if a number is not positive and finite
inline void check_positive(const char* name, const Eigen::VectorXd& numbers) {
  for(double x : numbers)
    if(!(x > 0 && std::isfinite(x)))
      throw Parameter_error(name, "is or contains " + std::to_string(x) +
                                      ", but must be positive and finite");
}
inline void check_positive(const char* name, double number) {
  check_positive(name, Eigen::VectorXd::Constant(1, number));
}

/// tells a `Laplace_spectrum`, or another type with its members `eigenvalues`, `vertex_values` and
/// `area`, from a vector
template <class Spectrum>
using Require_spectrum = std::enable_if_t<
    std::is_convertible_v<decltype(std::declval<const Spectrum&>().area), double> &&
        std::is_convertible_v<decltype(std::declval<const Spectrum&>().vertex_values),
                              const Eigen::MatrixXd&> &&
        std::is_convertible_v<decltype(std::declval<const Spectrum&>().eigenvalues),
                              const Eigen::VectorXd&>,
    int>;

/// The eigenvalues of a spectrum. Here the size of those that are not 0 is known, even if there are
/// only zeros: by Weyl's law they are \f$4 \pi / \mathrm{area}\f$ apart.
template <class Spectrum> Eigen::VectorXd eigenvalues_of(const Spectrum& spectrum) {
  check_positive("area", spectrum.area);
  const double tolerance = zero_eigenvalue_tolerance * 4 * 3.14159265358979323846 / spectrum.area;
  return spectrum.eigenvalues.unaryExpr(
      [tolerance](double l) { return std::abs(l) <= tolerance ? 0. : l; });
}

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Descriptors
/// Number of eigenvalues that count as 0, see `zero_eigenvalue_tolerance`: for the natural boundary
/// condition, the number of connected components of the surface. A sequence of zeros only has no
/// scale, and is recognised if they are exactly 0.
/// \throws Parameter_error if there is no eigenvalue, or if they are not finite, ascending and not
/// negative
inline Eigen::Index number_of_zero_eigenvalues(const Eigen::VectorXd& eigenvalues) {
  return internal::number_of_zeros(internal::checked_eigenvalues(eigenvalues));
}

/// \ingroup PkgRestrictedLaplacian3Descriptors
/// The same for a `Laplace_spectrum`, whose area gives the scale also if there are zeros only.
template <class Spectrum, internal::Require_spectrum<Spectrum> = 0>
Eigen::Index number_of_zero_eigenvalues(const Spectrum& spectrum) {
  return number_of_zero_eigenvalues(internal::eigenvalues_of(spectrum));
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_ZERO_EIGENVALUES_H

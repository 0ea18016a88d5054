// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_ZERO_EIGENVALUES_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_ZERO_EIGENVALUES_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>

#include <Eigen/Core>

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

/// The eigenvalues with those that count as 0 replaced by 0.
/// \throws Parameter_error if there is none, or if they are not finite, ascending and not negative
Eigen::VectorXd checked_eigenvalues(const Eigen::VectorXd& eigenvalues);

/// number of leading zeros, for the result of `checked_eigenvalues()`
Eigen::Index number_of_zeros(const Eigen::VectorXd& checked);

/// the same, where one that is not 0 is needed
/// \throws Parameter_error if there is none
Eigen::Index number_of_zeros_before_others(const Eigen::VectorXd& checked);

/// \throws Parameter_error if `values` does not have a column for each eigenvalue
void check_columns(const Eigen::VectorXd& eigenvalues,
                   const Eigen::Ref<const Eigen::MatrixXd>& values);

/// \throws Parameter_error if a number is not positive and finite
void check_positive(const char* name, const Eigen::VectorXd& numbers);
void check_positive(const char* name, double number);

/// Eigenvalues of a surface with those that count as 0 replaced by 0. Here the size of those that
/// are not is known, even if there are only zeros: by Weyl's law they are
/// \f$4 \pi / \mathrm{area}\f$ apart.
/// \throws Parameter_error if the area is not positive and finite
Eigen::VectorXd with_exact_zeros(const Eigen::VectorXd& eigenvalues, double area);

template <class Spectrum> Eigen::VectorXd eigenvalues_of(const Spectrum& spectrum) {
  return with_exact_zeros(spectrum.eigenvalues, spectrum.area);
}

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Descriptors
/// Number of eigenvalues that count as 0, see `zero_eigenvalue_tolerance`: for the natural boundary
/// condition, the number of connected components of the surface. A sequence of zeros only has no
/// scale, and is recognized if they are exactly 0.
/// \throws Parameter_error if there is no eigenvalue, or if they are not finite, ascending and not
/// negative
Eigen::Index number_of_zero_eigenvalues(const Eigen::VectorXd& eigenvalues);

/// \ingroup PkgRestrictedLaplacian3Descriptors
/// The number of zero eigenvalues of a `Laplace_spectrum`, whose area gives the scale also if there
/// are zeros only.
template <class Spectrum, internal::Require_spectrum<Spectrum> = 0>
Eigen::Index number_of_zero_eigenvalues(const Spectrum& spectrum) {
  return number_of_zero_eigenvalues(internal::eigenvalues_of(spectrum));
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/spectra/zero_eigenvalues_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_ZERO_EIGENVALUES_H

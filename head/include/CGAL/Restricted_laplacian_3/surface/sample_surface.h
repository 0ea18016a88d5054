// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SAMPLE_SURFACE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SAMPLE_SURFACE_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Operators
/// How `sample_surface()` chooses locations.
enum class Sampling {
  /// independent of each other
  independent,
  /// The surface is put in an order in which neighbors mostly stay neighbors, and cut into as
  /// many parts of equal area as there are samples; each part has one. Integrals have the same mean
  /// as those of independent samples, but errors that fall nearly with the number of samples
  /// instead of its square root.
  stratified
};

/// \ingroup PkgRestrictedLaplacian3Operators
/// Locations on a surface, uniformly distributed by area: each stands for the weight area / number
/// of locations (paper, section 4.3).
///
/// The same seed gives the same locations with every compiler, and any number of threads.
/// \throws Parameter_error if `number` is 0
/// \throws Input_error if the surface is a point set
/// Takes \f$O(F + N \log F)\f$ time for \f$F\f$ faces and \f$N\f$ locations, with
/// `Sampling::stratified` \f$O(F \log F + N \log F N)\f$.
std::vector<Surface_location> sample_surface(const Triangulated_surface_3& surface,
                                             std::size_t number, std::uint64_t seed,
                                             Sampling sampling = Sampling::independent);

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/surface/sample_surface_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SAMPLE_SURFACE_H

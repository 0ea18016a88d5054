// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SAMPLE_SURFACE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SAMPLE_SURFACE_H

#include <CGAL/Restricted_laplacian_3/Triangulated_surface_3.h>
#include <CGAL/Restricted_laplacian_3/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// Locations on a surface, independent of each other and uniformly distributed by area: each stands
/// for the weight area / number of locations (paper, section 4.3).
///
/// The same seed gives the same locations with every compiler: the generator, `std::mt19937_64`, is
/// fixed by the standard, and its numbers are scaled here.
/// \throws Parameter_error if `number` is 0
/// Takes \f$O(F + N \log F)\f$ time for \f$F\f$ faces and \f$N\f$ locations.
inline std::vector<Surface_location> sample_surface(const Triangulated_surface_3& surface,
                                                    std::size_t number, std::uint64_t seed) {
  if(number == 0)
    throw Parameter_error("number_of_samples", "is 0, but must be positive");
  std::vector<double> cumulated(surface.number_of_faces());
  double sum = 0;
  for(std::size_t f = 0; f < cumulated.size(); ++f)
    cumulated[f] = sum += surface.area(f);

  std::mt19937_64 generator(seed);
  const auto uniform = [&generator] { return std::ldexp(double(generator() >> 11), -53); };
  std::vector<Surface_location> samples(number);
  for(Surface_location& sample : samples) {
    // The first face whose cumulated area is larger: never a degenerate one.
    const auto it = std::upper_bound(cumulated.begin(), cumulated.end(), uniform() * sum);
    sample.face =
        (std::min)(static_cast<std::size_t>(it - cumulated.begin()), cumulated.size() - 1);
    while(surface.is_degenerate(sample.face))
      --sample.face;
    const double root = std::sqrt(uniform()), v = uniform();
    sample.barycentric = {1 - root, root * (1 - v), root * v};
  }
  return samples;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SAMPLE_SURFACE_H

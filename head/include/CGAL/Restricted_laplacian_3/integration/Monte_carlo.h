// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_MONTE_CARLO_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_MONTE_CARLO_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/integration/Integration_nodes.h>
#include <CGAL/Restricted_laplacian_3/octree/Octree_3.h>
#include <CGAL/Restricted_laplacian_3/surface/sample_surface.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Operators
/// Integration over the surface by samples that are uniformly distributed by area, each of weight
/// area / number of samples (paper, section 4.3). The error of an integral falls with the square
/// root of the number of samples, with `Sampling::stratified` nearly with the number itself.
/// Elements that no sample meets have zero rows.
///
/// \cgalModels `SurfaceIntegration_3`
class Monte_carlo {
public:
  /// The octree, that of a space, must outlive this object.
  Monte_carlo(const Octree_3& octree, std::size_t number_of_samples, std::uint64_t seed,
              Sampling sampling = Sampling::independent);

  /// The same with samples that the caller has drawn, uniformly by area.
  /// \param octree must outlive this object
  /// \param samples at least one
  /// \throws Location_error a sample is not on the surface
  Monte_carlo(const Octree_3& octree, const std::vector<Surface_location>& samples);

  /// the samples on a sheet, whatever the degree
  void add_nodes(std::size_t sheet, int degree, Integration_nodes& nodes) const;

private:
  struct Sample {
    std::array<double, 3> position;
    Surface_location location;
  };

  const Octree_3* m_octree;
  double m_weight;
  std::vector<std::size_t> m_first; // sample of each sheet, and one more
  std::vector<Sample> m_samples;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/integration/Monte_carlo_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_MONTE_CARLO_H

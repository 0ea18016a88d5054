// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_VERTEX_VALUES_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_VERTEX_VALUES_IMPL_H

#include <CGAL/Restricted_laplacian_3/distributed/internal/Element_exchange.h>
#include <CGAL/Restricted_laplacian_3/distributed/vertex_values.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The vertices of a part of a surface, each of which is in the slice of one rank.
inline Element_exchange vertex_exchange(const Distributed_surface& surface,
                                        const Surface_part& part) {
  return Element_exchange(surface.communicator(), surface.first_vertices(),
                          std::vector<std::uint64_t>(part.vertices.begin(), part.vertices.end()));
}

inline void check_number_of_values(const Distributed_surface& surface,
                                   const std::vector<double>& values) {
  surface.communicator().agree([&] {
    if(values.size() != surface.points().size())
      throw Parameter_error("values", "are not those of the vertices of the slice");
  });
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<double>
values_at_vertices(const Distributed_surface& surface, const Distributed_space& space,
                   const Eigen::VectorXd& coefficients) {
  const internal::Element_exchange exchange =
      internal::vertex_exchange(surface, space.surface_part());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const int level = space.depth();
  const Octree_3& octree = space.part().octree();
  const Surface_part& part = space.surface_part();
  std::vector<double> of_part(part.vertices.size(), nan);
  surface.communicator().agree([&] {
    if(coefficients.size() != static_cast<Eigen::Index>(space.part().dimension()))
      throw Parameter_error("coefficients", "do not fit the part of the space");
    // A vertex near to the cells of a rank has all of its faces there: the first one counts, as for
    // values on one rank, unless it has no fragment there.
    for(std::size_t f = 0; f < part.faces.size(); ++f)
      for(std::uint32_t v : part.surface.triangle(f)) {
        if(!std::isnan(of_part[v]) || part.surface.is_degenerate(f))
          continue;
        const auto [sheet, t] = octree.locate(level, part.surface.point(v), f);
        if(sheet == octree.number_of_sheets(level))
          continue;
        const Tensor_basis_3::Values values = Tensor_basis_3::values(t);
        double sum = 0;
        for_each_element(space.part().elements(level, sheet), [&](int i, std::uint32_t element) {
          sum += values[i] * coefficients[element];
        });
        of_part[v] = sum;
      }
  });
  std::vector<double> result(exchange.own_size(), nan);
  exchange.combine(of_part, result, [](double& value, double other) {
    if(std::isnan(value))
      value = other;
  });
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<double>
vertex_values_of_part(const Distributed_surface& surface, const Distributed_space& space,
                      const std::vector<double>& values) {
  internal::check_number_of_values(surface, values);
  return internal::vertex_exchange(surface, space.surface_part()).values(values);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE double surface_mean(const Distributed_surface& surface,
                                                       const std::vector<double>& values) {
  internal::check_number_of_values(surface, values);
  const Surface_part& slice = surface.slice();
  const std::vector<double> of_slice = internal::vertex_exchange(surface, slice).values(values);
  double sum = 0;
  for(std::size_t f = 0; f < slice.faces.size(); ++f)
    for(std::uint32_t v : slice.surface.triangle(f))
      if(slice.surface.area(f) > 0)
        sum += slice.surface.area(f) * of_slice[v] / 3;
  return surface.communicator().sum(sum) / surface.area();
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_VERTEX_VALUES_IMPL_H

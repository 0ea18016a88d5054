// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_TEST_DISTRIBUTED_SLICES_H
#define RESTRICTED_LAPLACIAN_3_TEST_DISTRIBUTED_SLICES_H

#include <CGAL/Restricted_laplacian_3/distributed/Distributed_space.h>
#include <CGAL/Restricted_laplacian_3/distributed/Distributed_surface.h>
#include <CGAL/Restricted_laplacian_3/integration/Surface_material.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <Eigen/Core>

#include <cstddef>
#include <utility>

/// what a rank has of a surface that all of them know; uneven, and with ranks that have nothing
inline CGAL::Restricted_laplacian_3::Surface_slice
slice_of(const CGAL::Restricted_laplacian_3::Triangulated_surface_3& surface,
         const CGAL::Restricted_laplacian_3::Communicator& communicator) {
  const auto part = [&](std::size_t size) {
    const auto ranks = static_cast<std::size_t>(communicator.size()),
               rank = static_cast<std::size_t>(communicator.rank());
    return std::pair<std::size_t, std::size_t>(size * rank * rank / (ranks * ranks),
                                               size * (rank + 1) * (rank + 1) / (ranks * ranks));
  };
  CGAL::Restricted_laplacian_3::Surface_slice slice;
  slice.is_point_set = surface.is_point_set();
  const auto [first, last] = part(surface.number_of_vertices());
  for(std::size_t v = first; v < last; ++v) {
    slice.points.push_back(surface.point(v));
    if(slice.is_point_set) {
      slice.normals.push_back(surface.normal(v));
      slice.areas.push_back(surface.area(v));
    }
  }
  const auto [first_face, last_face] = part(surface.number_of_faces());
  for(std::size_t f = first_face; f < last_face && !slice.is_point_set; ++f)
    slice.triangles.push_back(surface.triangle(f));
  return slice;
}

/// a tensor that is not tangential, and a density, both of the point and thus the same on all ranks
inline CGAL::Restricted_laplacian_3::Surface_material some_material() {
  using CGAL::Restricted_laplacian_3::Surface_point;
  CGAL::Restricted_laplacian_3::Surface_material result;
  result.set_diffusion([](const Surface_point& p) {
    const Eigen::Vector3d direction(p.point.y(), 1, -0.5);
    return Eigen::Matrix3d(Eigen::Matrix3d::Identity() +
                           3 * direction * direction.transpose() / direction.squaredNorm());
  });
  result.set_density([](const Surface_point& p) { return 1.5 + p.point.x(); });
  return result;
}

/// a space that ranks have divided, and the same of one process
struct Spaces {
  using Surface = CGAL::Restricted_laplacian_3::Triangulated_surface_3;
  using Communicator = CGAL::Restricted_laplacian_3::Communicator;

  using Material = CGAL::Restricted_laplacian_3::Surface_material;

  Spaces(const Surface& s, int depth, const Communicator& communicator = Communicator(),
         const Material& material = {})
    : surface(s), distributed_surface(communicator, slice_of(s, communicator)),
      distributed(distributed_surface, options_of(depth, material)),
      whole(surface, options_of(depth, material)) {}

  static CGAL::Restricted_laplacian_3::Spline_space_options options_of(int depth,
                                                                       const Material& material) {
    CGAL::Restricted_laplacian_3::Spline_space_options options;
    options.depth = depth;
    options.material = material;
    return options;
  }

  Surface surface;
  CGAL::Restricted_laplacian_3::Distributed_surface distributed_surface;
  CGAL::Restricted_laplacian_3::Distributed_space distributed;
  CGAL::Restricted_laplacian_3::Spline_space_3 whole;
};

#endif // RESTRICTED_LAPLACIAN_3_TEST_DISTRIBUTED_SLICES_H

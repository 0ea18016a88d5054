// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SURFACE_PATCHES_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SURFACE_PATCHES_IMPL_H

#include <CGAL/Restricted_laplacian_3/surface/Surface_patches.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Surface_patches::Surface_patches(std::vector<Controls> controls, std::size_t number_of_folded_faces)
  : m_controls(std::move(controls)), m_number_of_folded_faces(number_of_folded_faces) {
  for(const Controls& c : m_controls)
    m_is_flat.push_back(
        std::all_of(c.begin(), c.end(), [](const Vector_3& d) { return d == CGAL::NULL_VECTOR; }));
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Vector_3
Surface_patches::deviation(std::size_t face, const std::array<double, 3>& barycentric) const {
  const Controls& c = m_controls[face];
  Vector_3 sum = 6 * barycentric[0] * barycentric[1] * barycentric[2] * c[6];
  for(int i = 0; i < 3; ++i) {
    const double x = barycentric[i], y = barycentric[i == 2 ? 0 : i + 1];
    sum += 3 * x * y * (x * c[2 * i] + y * c[2 * i + 1]);
  }
  return sum;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::array<Vector_3, 3>
Surface_patches::partial_derivatives(std::size_t face,
                                     const std::array<double, 3>& barycentric) const {
  const auto& l = barycentric;
  const Controls& c = m_controls[face];
  std::array<Vector_3, 3> d;
  for(int i = 0; i < 3; ++i)
    d[i] = 6 * l[(i + 1) % 3] * l[(i + 2) % 3] * c[6];
  for(int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const double x = l[i], y = l[j];
    d[i] += 3 * y * (2 * x * c[2 * i] + y * c[2 * i + 1]);
    d[j] += 3 * x * (x * c[2 * i] + 2 * y * c[2 * i + 1]);
  }
  return d;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Vector_3 Surface_patches::derivative(
    std::size_t face, const std::array<Point_3, 3>& corners,
    const std::array<double, 3>& barycentric, const std::array<double, 3>& direction) const {
  const std::array<Vector_3, 3> d = partial_derivatives(face, barycentric);
  Vector_3 sum =
      direction[1] * (corners[1] - corners[0]) + direction[2] * (corners[2] - corners[0]);
  for(int i = 0; i < 3; ++i)
    sum += direction[i] * d[i];
  return sum;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Patch_point
Surface_patches::evaluate(std::size_t face, const std::array<Point_3, 3>& corners,
                          const std::array<double, 3>& barycentric) const {
  const auto& l = barycentric;
  const Vector_3 u = corners[1] - corners[0], v = corners[2] - corners[0];
  const Point_3 flat = internal::point_of_triangle(corners[0], corners[1], corners[2], l);
  const std::array<Vector_3, 3> d = partial_derivatives(face, l);
  const double scale = std::sqrt((std::max)(u.squared_length(), v.squared_length()));
  const Vector_3 cross = CGAL::cross_product((u + d[1] - d[0]) / scale, (v + d[2] - d[0]) / scale);
  const double length = std::sqrt(cross.squared_length());
  return {flat + deviation(face, l), length > 0 ? cross / length : cross,
          length * scale * scale / 2};
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SURFACE_PATCHES_IMPL_H

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_INTERNAL_LEAST_BENT_DIVISION_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_INTERNAL_LEAST_BENT_DIVISION_H

#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <CGAL/Kernel/global_functions_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The division of a polygon into triangles whose largest angle between neighbors is least, and of
/// those the one with the least area: Liepa, "Filling Holes in Meshes", SGP 2003, whose weights
/// CGAL's `triangulate_hole_polyline()` has too. O(n^3) time for n corners.
class Least_bent_division {
public:
  using Triangle = Triangulated_surface_3::Triangle;

  /// \param corners at least three, with finite coordinates of about 1
  explicit Least_bent_division(const std::vector<Point_3>& corners)
    : m_corners(corners), m_best(corners.size() * corners.size()) {
    for(std::size_t length = 2; length < corners.size(); ++length)
      for(std::size_t i = 0; i + length < corners.size(); ++i)
        find_best(i, i + length);
  }

  /// The triangles, as numbers of corners; none if some would have no area in each division.
  std::vector<Triangle> triangles() const {
    std::vector<Triangle> result;
    std::vector<std::pair<std::size_t, std::size_t>> ranges = {{0, m_corners.size() - 1}};
    if(!best(0, m_corners.size() - 1).exists)
      return result;
    while(!ranges.empty()) {
      const auto [i, k] = ranges.back();
      ranges.pop_back();
      if(i + 1 == k)
        continue;
      const std::size_t j = best(i, k).middle;
      result.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j),
                        static_cast<std::uint32_t>(k)});
      ranges.emplace_back(i, j);
      ranges.emplace_back(j, k);
    }
    return result;
  }

private:
  /// of the part of the polygon from one corner to another, which a diagonal closes
  struct Division {
    bool exists = true;
    std::size_t middle = 0; ///< the third corner of the triangle at the diagonal
    double angle = 0, area = 0;

    bool is_better_than(const Division& other) const {
      return std::pair(angle, area) < std::pair(other.angle, other.area);
    }
  };

  const Division& best(std::size_t i, std::size_t k) const {
    return m_best[i * m_corners.size() + k];
  }

  void find_best(std::size_t i, std::size_t k) {
    Division result;
    result.exists = false;
    for(std::size_t j = i + 1; j < k; ++j) {
      const Division &a = best(i, j), &b = best(j, k);
      if(!a.exists || !b.exists || CGAL::collinear(m_corners[i], m_corners[j], m_corners[k]))
        continue;
      Division candidate;
      candidate.middle = j;
      candidate.angle = (std::max)({a.angle, b.angle, angle_at(i, j, k), angle_at(j, k, i)});
      candidate.area =
          a.area + b.area + std::sqrt(CGAL::squared_area(m_corners[i], m_corners[j], m_corners[k]));
      if(!result.exists || candidate.is_better_than(result))
        result = candidate;
    }
    m_best[i * m_corners.size() + k] = result;
  }

  /// between the normals of triangle (i, k, other) and its neighbor at the side from i to k, in
  /// degrees; 0 at a side of the polygon
  double angle_at(std::size_t i, std::size_t k, std::size_t other) const {
    if(i + 1 == k)
      return 0;
    return 180 - std::abs(CGAL::approximate_dihedral_angle(
                     m_corners[i], m_corners[k], m_corners[other], m_corners[best(i, k).middle]));
  }

  const std::vector<Point_3>& m_corners;
  std::vector<Division> m_best;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_INTERNAL_LEAST_BENT_DIVISION_H

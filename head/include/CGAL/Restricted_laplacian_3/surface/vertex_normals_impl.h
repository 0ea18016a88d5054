// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_VERTEX_NORMALS_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_VERTEX_NORMALS_IMPL_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Number_lists.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/Corner_groups.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/Surface_edges.h>
#include <CGAL/Restricted_laplacian_3/surface/vertex_normals.h>

#include <Eigen/Cholesky>
#include <boost/range/iterator_range_core.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Vector_3 unit_or_zero(const Vector_3& v) {
  const double length = std::sqrt(v.squared_length());
  return length > 0 ? v / length : Vector_3(0, 0, 0);
}

/// The normal of a group by the rule of chords: along a curve on a smooth surface
/// \f$\langle n(p) + n(q), q - p \rangle = O(\lvert q - p \rvert^3)\f$. The tangential change of
/// the normal that satisfies it best for all neighbors, with little weight on no change: with a
/// single neighbor, or several in one direction, part of the change is undetermined.
/// \param neighbors groups times 2, plus 1 for those that are oriented against this one
inline Vector_3 normal_by_chords(const Triangulated_surface_3& surface, const Corner_groups& groups,
                                 std::size_t group, const std::vector<Vector_3>& normals,
                                 const boost::iterator_range<const std::uint32_t*>& neighbors) {
  constexpr double weight_of_no_change = 1e-2, largest_change = 1;
  const Vector_3 n = normals[group];
  const Eigen::Vector3d normal(n.x(), n.y(), n.z());
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  for(std::uint32_t code : neighbors) {
    const std::uint32_t neighbor = code / 2;
    const Vector_3 chord = unit_or_zero((surface.point(groups.vertices[neighbor]) -
                                         surface.point(groups.vertices[group])) /
                                        surface.extent()),
                   other = code % 2 == 0 ? normals[neighbor] : -normals[neighbor];
    const Eigen::Vector3d e(chord.x(), chord.y(), chord.z());
    const Eigen::Vector3d tangential = e - e.dot(normal) * normal;
    a += tangential * tangential.transpose();
    b -= ((n + other) * chord) * tangential;
  }
  const double trace = a.trace();
  if(!(trace > 0) || n == CGAL::NULL_VECTOR)
    return n;
  a += trace * (normal * normal.transpose() + weight_of_no_change * Eigen::Matrix3d::Identity());
  const Eigen::LDLT<Eigen::Matrix3d> factorization(a);
  if(factorization.info() != Eigen::Success)
    return n; // all neighbors in the direction of the normal, up to underflow
  Eigen::Vector3d change = factorization.solve(b);
  const double length = change.norm();
  if(length > largest_change)
    change *= largest_change / length;
  return unit_or_zero(n + Vector_3(change.x(), change.y(), change.z()));
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<Vector_3>
group_normals(const Triangulated_surface_3& surface, const Corner_groups& groups) {
  std::vector<Vector_3> normals(groups.vertices.size(), Vector_3(0, 0, 0));
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
    for(int i = 0; i < 3 && !surface.is_degenerate(f); ++i) {
      const Corner_groups::Corner& corner = groups.corners[3 * f + i];
      if(!corner.counts)
        continue;
      const Vector_3 a = (surface.point(f, (i + 1) % 3) - surface.point(f, i)) / surface.extent(),
                     b = (surface.point(f, (i + 2) % 3) - surface.point(f, i)) / surface.extent();
      const double products = a.squared_length() * b.squared_length();
      if(products > 0) // else a side vanishes by rounding
        normals[corner.group] +=
            corner.sign * (std::sqrt(CGAL::cross_product(a, b).squared_length()) / products) *
            surface.normal(f);
    }
  for(Vector_3& n : normals)
    n = unit_or_zero(n);

  std::vector<Number_lists::Pair> pairs;
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
    for(int i = 0; i < 3 && !surface.is_degenerate(f); ++i) {
      const Corner_groups::Corner &a = groups.corners[3 * f + i],
                                  &b = groups.corners[3 * f + (i + 1) % 3];
      const std::uint32_t is_opposite = a.sign != b.sign;
      if(groups.corrections[a.group] != Corner_groups::Correction::none)
        pairs.emplace_back(a.group, 2 * b.group + is_opposite);
      if(groups.corrections[b.group] != Corner_groups::Correction::none)
        pairs.emplace_back(b.group, 2 * a.group + is_opposite);
    }
  // Neighbors change too, hence some sweeps, each from the normals of the last.
  constexpr int sweeps = 10;
  const Number_lists neighbors(normals.size(), pairs);
  const auto& corrections = groups.corrections;
  for(const auto least :
      {Corner_groups::Correction::at_boundary, Corner_groups::Correction::inside}) {
    if(std::find(corrections.begin(), corrections.end(), least) == corrections.end())
      continue;
    for(int sweep = 0; sweep < sweeps; ++sweep) {
      std::vector<Vector_3> next = normals;
      for(std::size_t g = 0; g < normals.size(); ++g)
        if(corrections[g] >= least && !neighbors[g].empty())
          next[g] = normal_by_chords(surface, groups, g, normals, neighbors[g]);
      normals.swap(next);
    }
  }
  return normals;
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<Vector_3>
vertex_normals(const Triangulated_surface_3& surface) {
  if(surface.is_point_set()) {
    std::vector<Vector_3> normals(surface.number_of_vertices());
    for(std::size_t i = 0; i < normals.size(); ++i)
      normals[i] = surface.normal(i);
    return normals;
  }
  internal::Corner_groups groups;
  groups.vertices.resize(surface.number_of_vertices());
  std::iota(groups.vertices.begin(), groups.vertices.end(), 0u);
  groups.corners.reserve(3 * surface.number_of_faces());
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
    for(std::uint32_t v : surface.triangle(f))
      groups.corners.push_back({v, 1, true});
  for(char is_on_boundary :
      internal::Surface_edges(surface, internal::Surface_edges::Faces::not_degenerate)
          .boundary_vertices())
    groups.corrections.push_back(is_on_boundary ? internal::Corner_groups::Correction::at_boundary
                                                : internal::Corner_groups::Correction::none);
  return internal::group_normals(surface, groups);
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_VERTEX_NORMALS_IMPL_H

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_VERTEX_NORMALS_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_VERTEX_NORMALS_IMPL_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Number_lists.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/Surface_edges.h>
#include <CGAL/Restricted_laplacian_3/surface/vertex_normals.h>

#include <Eigen/Dense>
#include <boost/range/iterator_range_core.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Vector_3 unit_or_zero(const Vector_3& v) {
  const double length = std::sqrt(v.squared_length());
  return length > 0 ? v / length : Vector_3(0, 0, 0);
}

/// The neighbors of the vertices that are on the boundary; others have none.
inline Number_lists boundary_neighbors(const Triangulated_surface_3& surface) {
  const Surface_edges edges(surface, Surface_edges::Faces::not_degenerate);
  const std::vector<char> is_on_boundary = edges.boundary_vertices();
  std::vector<Number_lists::Pair> pairs;
  for(std::size_t edge = 0; edge < edges.size(); ++edge) {
    const auto [a, b] = edges.ends(edge);
    if(is_on_boundary[a])
      pairs.emplace_back(a, b);
    if(is_on_boundary[b])
      pairs.emplace_back(b, a);
  }
  return Number_lists(surface.number_of_vertices(), pairs);
}

/// The normal at a boundary vertex by the rule of chords: along a curve on a smooth surface
/// \f$\langle n(p) + n(q), q - p \rangle = O(\lvert q - p \rvert^3)\f$. The tangential change of
/// the normal that satisfies it best for all neighbors, with little weight on no change: with a
/// single neighbor, or several in one direction, part of the change is undetermined.
inline Vector_3 normal_by_chords(const Triangulated_surface_3& surface, std::size_t vertex,
                                 const std::vector<Vector_3>& normals,
                                 const boost::iterator_range<const std::uint32_t*>& neighbors) {
  constexpr double weight_of_no_change = 1e-2, largest_change = 1;
  const Vector_3 n = normals[vertex];
  const Eigen::Vector3d normal(n.x(), n.y(), n.z());
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  for(std::uint32_t neighbor : neighbors) {
    const Vector_3 chord =
        unit_or_zero((surface.point(neighbor) - surface.point(vertex)) / surface.extent());
    const Eigen::Vector3d e(chord.x(), chord.y(), chord.z());
    const Eigen::Vector3d tangential = e - e.dot(normal) * normal;
    a += tangential * tangential.transpose();
    b -= ((n + normals[neighbor]) * chord) * tangential;
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

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<Vector_3>
vertex_normals(const Triangulated_surface_3& surface) {
  std::vector<Vector_3> normals(surface.number_of_vertices(), Vector_3(0, 0, 0));
  if(surface.is_point_set()) {
    for(std::size_t i = 0; i < normals.size(); ++i)
      normals[i] = surface.normal(i);
    return normals;
  }
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
    for(int i = 0; i < 3 && !surface.is_degenerate(f); ++i) {
      const Vector_3 a = (surface.point(f, (i + 1) % 3) - surface.point(f, i)) / surface.extent(),
                     b = (surface.point(f, (i + 2) % 3) - surface.point(f, i)) / surface.extent();
      const double products = a.squared_length() * b.squared_length();
      if(products > 0) // else a side vanishes by rounding
        normals[surface.triangle(f)[i]] +=
            std::sqrt(CGAL::cross_product(a, b).squared_length()) / products * surface.normal(f);
    }
  for(Vector_3& n : normals)
    n = internal::unit_or_zero(n);

  // Neighbors on the boundary change too, hence some sweeps, each from the normals of the last.
  constexpr int sweeps = 10;
  const internal::Number_lists neighbors = internal::boundary_neighbors(surface);
  for(int sweep = 0; sweep < sweeps && !neighbors.numbers().empty(); ++sweep) {
    std::vector<Vector_3> next = normals;
    for(std::size_t v = 0; v < normals.size(); ++v)
      if(!neighbors[v].empty())
        next[v] = internal::normal_by_chords(surface, v, normals, neighbors[v]);
    normals.swap(next);
  }
  return normals;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_VERTEX_NORMALS_IMPL_H

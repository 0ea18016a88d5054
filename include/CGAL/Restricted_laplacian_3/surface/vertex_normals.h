// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_VERTEX_NORMALS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_VERTEX_NORMALS_H

#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <Eigen/Dense>

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

/// \f$v / \lvert v \rvert\f$; the zero vector if \f$v\f$ is
inline Vector_3 unit_or_zero(const Vector_3& v) {
  const double length = std::sqrt(v.squared_length());
  return length > 0 ? v / length : Vector_3(0, 0, 0);
}

/// the neighbours of the vertices that have a side of no second face, sorted by vertex
struct Boundary_neighbors {
  using Pair = std::pair<std::uint32_t, std::uint32_t>;
  std::vector<Pair> pairs;

  explicit Boundary_neighbors(const Triangulated_surface_3& surface) {
    std::vector<Pair> sides;
    for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
      for(int i = 0; i < 3 && !surface.is_degenerate(f); ++i)
        sides.push_back(std::minmax({surface.triangle(f)[i], surface.triangle(f)[(i + 1) % 3]}));
    std::sort(sides.begin(), sides.end());
    std::vector<char> is_on_boundary(surface.number_of_vertices(), 0);
    for(std::size_t i = 0; i < sides.size(); ++i)
      if((i == 0 || sides[i - 1] != sides[i]) &&
         (i + 1 == sides.size() || sides[i + 1] != sides[i]))
        is_on_boundary[sides[i].first] = is_on_boundary[sides[i].second] = 1;
    sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
    for(const auto& [a, b] : sides) {
      if(is_on_boundary[a])
        pairs.emplace_back(a, b);
      if(is_on_boundary[b])
        pairs.emplace_back(b, a);
    }
    std::sort(pairs.begin(), pairs.end());
  }
};

/// The normal at a boundary vertex by the rule of chords: along a curve on a smooth surface
/// \f$\langle n(p) + n(q), q - p \rangle = O(\lvert q - p \rvert^3)\f$. The tangential change of
/// the normal that satisfies it best for all neighbours, with little weight on no change: with a
/// single neighbour, or several in one direction, part of the change is undetermined.
inline Vector_3 normal_by_chords(const Triangulated_surface_3& surface, std::uint32_t vertex,
                                 const std::vector<Vector_3>& normals,
                                 const Boundary_neighbors::Pair* first,
                                 const Boundary_neighbors::Pair* last) {
  constexpr double weight_of_no_change = 1e-2, largest_change = 1;
  const Vector_3 n = normals[vertex];
  const Eigen::Vector3d normal(n.x(), n.y(), n.z());
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  for(auto pair = first; pair != last; ++pair) {
    const Vector_3 chord =
        unit_or_zero((surface.point(pair->second) - surface.point(vertex)) / surface.extent());
    const Eigen::Vector3d e(chord.x(), chord.y(), chord.z());
    const Eigen::Vector3d tangential = e - e.dot(normal) * normal;
    a += tangential * tangential.transpose();
    b -= ((n + normals[pair->second]) * chord) * tangential;
  }
  const double trace = a.trace();
  if(!(trace > 0) || n == CGAL::NULL_VECTOR)
    return n;
  a += trace * (normal * normal.transpose() + weight_of_no_change * Eigen::Matrix3d::Identity());
  Eigen::Vector3d change = a.ldlt().solve(b);
  const double length = change.norm();
  if(length > largest_change)
    change *= largest_change / length;
  return unit_or_zero(n + Vector_3(change.x(), change.y(), change.z()));
}

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Fits
/// Unit normals at the vertices of a surface, in the order of `vertices(tm)`, to the side to which
/// the faces are oriented. The zero vector at vertices without a face of positive area, and where
/// the normals of the faces cancel.
///
/// They are means of the normals of the faces around with the weights of N. Max, *Weights for
/// computing vertex normals from facet normals*, Journal of Graphics Tools 4 (1999): the sine of
/// the angle between the two sides at the vertex, over the product of their lengths. On spheres
/// these are exact, and on smooth surfaces, above all with triangles of different shape, several
/// times as accurate as with areas or angles as weights.
///
/// At the boundary of an open surface the faces lie to one side, and their mean is the normal at
/// some distance from the vertex. There the normals are corrected: along an edge from \f$p\f$ to
/// \f$q\f$, \f$\langle n(p) + n(q), q - p \rangle\f$ is 0 up to terms of third order.
///
/// The points of a point set have their own normals.
///
/// Takes \f$O(F \log F)\f$ time for \f$F\f$ faces.
inline std::vector<Vector_3> vertex_normals(const Triangulated_surface_3& surface) {
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

  // Neighbours on the boundary change too, hence some sweeps, each from the normals of the last.
  constexpr int sweeps = 10;
  const internal::Boundary_neighbors neighbors(surface);
  const auto& pairs = neighbors.pairs;
  for(int sweep = 0; sweep < sweeps && !pairs.empty(); ++sweep) {
    std::vector<Vector_3> next = normals;
    for(std::size_t first = 0, last = 0; first < pairs.size(); first = last) {
      while(last < pairs.size() && pairs[last].first == pairs[first].first)
        ++last;
      next[pairs[first].first] = internal::normal_by_chords(
          surface, pairs[first].first, normals, pairs.data() + first, pairs.data() + last);
    }
    normals.swap(next);
  }
  return normals;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_VERTEX_NORMALS_H

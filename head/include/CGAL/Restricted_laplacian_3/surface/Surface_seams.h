// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SURFACE_SEAMS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SURFACE_SEAMS_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Key_index.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Number_view.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

namespace internal {

/// a side of a face: from corner `number` to corner `number + 1`, modulo 3
struct Face_side {
  std::size_t face;
  int number;
};

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Dev
/// Along which of their sides the faces of a surface are joined.
///
/// A seam is a set of sides of faces that run along the same line in space; the surface continues
/// across a seam from each of its faces to each other one. The sides with the same two vertices,
/// an *edge*, are one seam, any number of them: non-manifold edges need no special treatment, and
/// orientation does not matter. Beyond that,
/// - the three sides of a thin face, whose height over its longest side is at most `thinness`, are
///   one seam: it may have no fragment in a cell where its neighbors have one;
/// - if a joining tolerance is given, a side that is alone so far and another side are one seam if
///   they run along each other: of their four ends, two that are farther apart than the tolerance
///   are each within the tolerance of the other side. That closes duplicate vertices and
///   T-junctions.
///
/// Side `i` of a face goes from corner `i` to corner `(i + 1) % 3`.
///
/// Only seams of several edges are stored. Linear in the number of faces; joining takes
/// \f$O(F \log F)\f$, as long as few sides are near to each other.
class Surface_seams {
public:
  /// What a seam is called: the two vertices of its first edge, the lower one in the upper 32 bits.
  using Key = std::uint64_t;

  /// Parts of the surface that are searched for sides that run along each other, one after the
  /// other: so much less memory is needed. Any two sides that are within the tolerance of each
  /// other must belong to faces of one part.
  using Parts = std::vector<internal::Number_view>;

  /// \param surface a surface of triangles, which must outlive this object
  /// \param thinness in the unit of the coordinates
  /// \param joining_tolerance in the unit of the coordinates; negative: do not join
  /// \param parts of the surface, for joining; empty: all of it at once
  /// \param is_parallel whether several threads are used, if the program is linked with TBB
  /// \throws Input_error the surface is a point set
  Surface_seams(const Triangulated_surface_3& surface, double thinness, double joining_tolerance,
                const Parts& parts = {}, bool is_parallel = false);

  /// the seam that a side belongs to
  Key seam(std::size_t face, int side) const {
    CGAL_precondition(side >= 0 && side < 3);
    const Key edge = edge_of_side(face, side);
    if(m_edges.empty())
      return edge;
    const std::size_t i = m_index.find(m_edges, edge);
    return i == m_edges.size() ? edge : m_seams[i];
  }

  /// whether a seam consists of several edges
  bool is_united(Key seam) const {
    return !m_edges.empty() && m_index.find(m_edges, seam) != m_edges.size();
  }

  /// The sides that are alone in their seam, in the order of faces: the boundary of the surface.
  /// \param sides_at_once about how many are sorted at once, positive, 16 bytes each; for each
  /// such part all faces are looked at
  std::vector<internal::Face_side> lone_sides(std::size_t sides_at_once = std::size_t(1)
                                                                          << 24) const;

private:
  using Keys = std::vector<Key>;
  /// edges of the same seam
  using Pairs = std::vector<std::pair<Key, Key>>;

  Key edge_of_side(std::size_t face, int side) const {
    const auto& t = m_surface.triangle(face);
    const Key a = t[side], b = t[side == 2 ? 0 : side + 1];
    return a < b ? a << 32 | b : b << 32 | a;
  }

  /// an index for some edges, which ascend
  internal::Key_index index_of(const Keys& edges) const;

  void add_sides_of_thin_faces(double thinness, Pairs& pairs) const;
  void add_near_sides(double tolerance, const Parts& parts, Pairs& pairs) const;
  void add_near_sides(double tolerance, const internal::Number_view& part, const Keys& lone_edges,
                      const internal::Key_index& index, Pairs& pairs) const;
  void unite(const Pairs& pairs);

  const Triangulated_surface_3& m_surface;
  bool m_is_parallel;
  // the edges of seams of several edges, ascending, and their seams
  Keys m_edges, m_seams;
  internal::Key_index m_index;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/surface/Surface_seams_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SURFACE_SEAMS_H

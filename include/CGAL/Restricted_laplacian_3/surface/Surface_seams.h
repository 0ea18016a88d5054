// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SURFACE_SEAMS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SURFACE_SEAMS_H

#include <CGAL/Restricted_laplacian_3/foundation/compiled.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <CGAL/assertions.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

class Disjoint_sets;

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Dev
/// Along which of their sides the faces of a surface are joined.
///
/// A seam is a set of sides of faces that run along the same line in space; the surface continues
/// across a seam from each of its faces to each other one. The sides with the same two vertices are
/// one seam, any number of them: non-manifold edges need no special treatment, and orientation does
/// not matter. Beyond that,
/// - the three sides of a thin face, whose height over its longest side is at most `thinness`, are
///   one seam: it may have no fragment in a cell where its neighbors have one;
/// - if a joining tolerance is given, a side that is alone so far and another side are one seam if
///   they run along each other: of their four ends, two that are farther apart than the tolerance
///   are each within the tolerance of the other side. That closes duplicate vertices and
///   T-junctions.
///
/// Side `i` of a face goes from corner `i` to corner `(i + 1) % 3`.
///
/// Linear in the number of faces; joining takes \f$O(F \log F)\f$, as long as few sides are near
/// to each other.
class Surface_seams {
public:
  /// \param surface a surface of triangles; it is read here only
  /// \param thinness in the unit of the coordinates
  /// \param joining_tolerance in the unit of the coordinates; negative: do not join
  /// \throws Input_error the surface is a point set
  Surface_seams(const Triangulated_surface_3& surface, double thinness, double joining_tolerance);

  /// number of seams; a side that is joined to no other is one as well
  std::size_t number_of_seams() const { return m_number_of_seams; }

  /// number of the seam that a side belongs to
  std::uint32_t seam(std::size_t face, int side) const {
    CGAL_precondition(face < m_seams.size() && side >= 0 && side < 3);
    return m_seams[face][side];
  }

  /// whether the sides of a seam may be different edges
  bool is_united(std::uint32_t seam) const {
    CGAL_precondition(seam < m_number_of_seams);
    return !m_is_united.empty() && m_is_united[seam];
  }

private:
  /// gives the sides with the same vertices the same number
  void number_edges(const Triangulated_surface_3& surface);

  bool unite_sides_of_thin_faces(const Triangulated_surface_3& surface, double thinness,
                                 internal::Disjoint_sets& sets) const;

  bool join_lone_sides(const Triangulated_surface_3& surface, double tolerance,
                       internal::Disjoint_sets& sets) const;

  void renumber(internal::Disjoint_sets& sets);

  std::vector<std::array<std::uint32_t, 3>> m_seams;
  std::size_t m_number_of_seams = 0;
  std::vector<char> m_is_united; // empty if no seam is
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/surface/Surface_seams_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SURFACE_SEAMS_H

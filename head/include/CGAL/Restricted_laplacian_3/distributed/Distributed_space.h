// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_DISTRIBUTED_SPACE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_DISTRIBUTED_SPACE_H

#include <CGAL/Restricted_laplacian_3/distributed/Communicator.h>
#include <CGAL/Restricted_laplacian_3/distributed/Distributed_surface.h>
#include <CGAL/Restricted_laplacian_3/distributed/Rank_ranges.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Dev
/// What ranks know of a level of a space that they share.
struct Distributed_level {
  /// number of the first sheet of this rank
  std::uint64_t first_sheet = 0;
  /// how many sheets all ranks have
  std::uint64_t number_of_sheets = 0;
  /// number of the first element that each rank owns, and of all elements
  std::vector<std::uint64_t> first_elements;
  /// of all ranks: elements that are one of several into which an element was split
  std::uint64_t number_of_split_elements = 0;
  /// the numbers in the whole space of the elements of `Distributed_space::part()`, ascending
  std::vector<std::uint64_t> elements;
  /// \cond
  // keys of the cells that the elements of this rank are centered on, if the level is divided
  std::vector<std::uint64_t> own_centers;
  /// \endcond
};

/// \ingroup PkgRestrictedLaplacian3Distributed
/// The depth of the octree for a surface whose slices are on several ranks, as that of one rank.
/// \param surface triangles, or points
/// \param cube_scale side of the domain cube over the longest side of the bounding box
/// \throws Distributed_error if `cube_scale` is not from 1 to \f$10^6\f$
int default_depth(const Distributed_surface& surface, double cube_scale);

/// \ingroup PkgRestrictedLaplacian3Distributed
/// A `Spline_space_3` of which each rank holds a part: the sheets in its cells, with the elements
/// that act on them. Sheets, elements and their numbers are those of the space that one process
/// would make of the whole surface.
///
/// *Levels.* Up to `gathered_level()`, the one above that of the ranges, all ranks hold the whole;
/// on finer levels each holds the cells of its range,
/// see `Rank_ranges`. An element that acts on sheets of several ranks is known to all of them, and
/// owned by the one whose cell it is centered on.
///
/// The pieces of the surface in the cells beside its own tell a rank which elements these are. They
/// are cut on the finest level, because faces that come so near are there as well; on coarser
/// levels ranks tell each other.
class Distributed_space {
public:
  /// \param surface of which the ranks hold slices
  /// \param options as for a `Spline_space_3`; `maximum_memory` has no effect
  /// \throws Distributed_error on all ranks, with the message of what a `Spline_space_3` would
  /// throw
  Distributed_space(const Distributed_surface& surface, const Spline_space_options& options);

  /// the ranks
  const Communicator& communicator() const { return m_communicator; }
  /// the cells of each rank
  const Rank_ranges& ranges() const { return *m_ranges; }
  /// depth of the octree
  int depth() const { return part().depth(); }
  /// the finest level of which all ranks hold the whole
  int gathered_level() const { return m_ranges->level() - 1; }

  /// The part of this rank. On levels finer than `gathered_level()` it has the sheets of this rank
  /// alone, and elements that act on none of them do not exist. Its surface has more faces than
  /// those that meet its cells.
  const Spline_space_3& part() const { return *m_part; }
  /// the faces and vertices of the surface of `part()`
  const Surface_part& surface_part() const { return m_surface_part.front(); }

  /// of the whole space
  const Distributed_level& level(int level) const {
    CGAL_precondition(level >= 0 && level <= depth());
    return m_levels[static_cast<std::size_t>(level)];
  }
  /// number of elements of a level of the whole space
  std::uint64_t dimension(int level) const { return this->level(level).first_elements.back(); }
  /// number of sheets of a level of the whole space
  std::uint64_t number_of_sheets(int level) const { return this->level(level).number_of_sheets; }
  /// area of the whole surface
  double area() const { return m_area; }

private:
  Communicator m_communicator;
  double m_area;
  std::vector<Surface_part> m_surface_part; // one
  std::optional<Rank_ranges> m_ranges;
  std::vector<Distributed_level> m_levels;
  std::optional<Spline_space_3> m_part;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/distributed/Distributed_space_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_DISTRIBUTED_SPACE_H

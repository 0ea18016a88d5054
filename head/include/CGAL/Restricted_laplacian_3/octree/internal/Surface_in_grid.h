// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_SURFACE_IN_GRID_H
#define CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_SURFACE_IN_GRID_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Number_lists.h>
#include <CGAL/Restricted_laplacian_3/octree/internal/Finest_sheets.h>
#include <CGAL/Restricted_laplacian_3/octree/internal/Grid_vertices.h>
#include <CGAL/Restricted_laplacian_3/octree/shared/Octree_level.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/Divided_surface.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

namespace internal {

/// whether a cell is wanted, by its Morton key; may be called from several threads at once
using Cell_filter = std::function<bool(std::uint64_t key)>;

/// What a `Surface_in_grid` is made of.
struct Grid_input {
  const Triangulated_surface_3& surface;
  /// whose pieces the surface consists of; null if it is not smooth
  const Divided_surface* division;
  Grid_vertices vertices;
  /// whether fragments will be joined and linked
  bool is_split;
  /// about how many fragments are in memory at once
  std::size_t fragments_at_once;
  bool is_parallel;
  /// which cells are wanted; null for all
  const Cell_filter* filter;

  /// whether fragments in a cell are wanted
  bool wants(std::uint64_t key) const { return !filter || (*filter)(key); }
};

/// The surface in the grid of the finest cells: what kind of surface it is, of triangles or of
/// points, matters to the octree here alone.
class Surface_in_grid {
public:
  using Links = std::vector<Number_lists::Pair>;

  virtual ~Surface_in_grid() = default;

  /// The fragments are asked for in parts, one for each of some ranges of cells.
  virtual std::size_t number_of_windows() const { return 1; }
  /// about how many there are in all
  virtual std::size_t estimated_number_of_fragments() const = 0;
  /// the fragments of faces in the finest cells of a window, sorted by cell, and by face in a cell
  virtual std::vector<Cell_fragment> fragments(std::size_t window) const = 0;
  /// which fragments of a cell are in the same sheet: see `Join_fragments`
  virtual void join(const Cell_fragment* fragments, std::uint32_t size,
                    Sheet_scratch& scratch) const = 0;
  /// Which sheets of different cells are linked: adds the pairs, both ways.
  virtual void link(const Octree_level& finest, Links& links) const = 0;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_SURFACE_IN_GRID_H

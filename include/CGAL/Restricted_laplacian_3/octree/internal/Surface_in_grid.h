// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_SURFACE_IN_GRID_H
#define CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_SURFACE_IN_GRID_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Number_lists.h>
#include <CGAL/Restricted_laplacian_3/octree/internal/Finest_sheets.h>
#include <CGAL/Restricted_laplacian_3/octree/internal/Grid_vertices.h>
#include <CGAL/Restricted_laplacian_3/octree/internal/Octree_level.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/Divided_surface.h>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

namespace internal {

/// What a `Surface_in_grid` is made of.
struct Grid_input {
  const Triangulated_surface_3& surface;
  /// whose pieces the surface consists of; null if it is not smooth
  const Divided_surface* division;
  Grid_vertices vertices;
  /// whether fragments will be joined and linked
  bool is_split;
  Octree_limits limits;
  bool is_parallel;
};

/// The surface in the grid of the finest cells: what kind of surface it is, of triangles or of
/// points, matters to the octree here alone.
class Surface_in_grid {
public:
  using Links = std::vector<Number_lists::Pair>;

  virtual ~Surface_in_grid() = default;

  /// all fragments of faces in finest cells, sorted by cell, and by face in a cell
  virtual std::vector<Cell_fragment> fragments() const = 0;
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

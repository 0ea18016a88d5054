// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_SHARED_OCTREE_BUILDER_H
#define CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_SHARED_OCTREE_BUILDER_H

#include <CGAL/Restricted_laplacian_3/octree/internal/Grid_vertices.h>
#include <CGAL/Restricted_laplacian_3/octree/internal/Surface_in_grid.h>
#include <CGAL/Restricted_laplacian_3/octree/shared/Octree_level.h>
#include <CGAL/Restricted_laplacian_3/octree/shared/Sheet_sorter.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

class Octree_3;

namespace internal {

/// Makes the levels of an octree whose surface, domain cube and depth are known: all at once, or
/// one by one for those who have a part of the octree only.
class Octree_builder {
public:
  explicit Octree_builder(Octree_3& octree) : m_octree(octree) {}

  /// an octree that has no levels yet; parameters are those of the constructor of `Octree_3`
  static Octree_3 without_levels(Triangulated_surface_3 surface, int depth, double cube_scale,
                                 bool is_split, bool is_parallel);

  /// makes all levels
  void build(double joining_tolerance, std::size_t fragments_at_once);

  /// The finest level, without parents.
  /// \param places receives those of the sheets
  /// \param filter says which cells are wanted; null for all
  Octree_level finest_level(double joining_tolerance, std::size_t fragments_at_once,
                            std::vector<Place>& places, const Cell_filter* filter = nullptr) const;

  /// The next coarser level; parents of the finer one are set.
  /// \param places of the sheets of the finer level; on return of those of the coarser one
  static Octree_level coarser_level(Octree_level& fine, std::vector<Place>& places, bool is_split);

  /// \param levels from 0 to the depth
  void set_levels(std::vector<Octree_level> levels);

  /// the vertices of a surface in the grid of the finest cells of an octree
  static Grid_vertices vertices(const Octree_3& octree, const Triangulated_surface_3& surface);

private:
  std::unique_ptr<Surface_in_grid> surface_in_grid(double joining_tolerance,
                                                   std::size_t fragments_at_once,
                                                   const Cell_filter* filter) const;
  void check_number_of_sheets(std::size_t number) const;

  Octree_3& m_octree;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_SHARED_OCTREE_BUILDER_H

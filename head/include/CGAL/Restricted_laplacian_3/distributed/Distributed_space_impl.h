// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_DISTRIBUTED_SPACE_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_DISTRIBUTED_SPACE_IMPL_H

#include <CGAL/Restricted_laplacian_3/distributed/Distributed_space.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/Level_exchange.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/octree/shared/Octree_builder.h>
#include <CGAL/Restricted_laplacian_3/splines/shared/Partial_space.h>
#include <CGAL/Restricted_laplacian_3/splines/shared/default_depth.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE int default_depth(const Distributed_surface& surface,
                                                     double cube_scale) {
  const Communicator& communicator = surface.communicator();
  const Surface_part& slice = surface.slice();
  double sum = 0;
  std::vector<std::uint64_t> cells;
  communicator.agree([&] {
    const double side = internal::checked_cube_scale(cube_scale) * slice.surface.extent();
    if(slice.faces.empty())
      return;
    if(surface.is_point_set())
      cells = internal::cells_of_points(slice.surface, side);
    else
      sum = internal::sum_of_edges(slice.surface) / side;
  });
  if(!surface.is_point_set())
    return internal::depth_of_edges(communicator.sum(sum), surface.number_of_faces());
  cells = communicator.concatenation(cells);
  std::sort(cells.begin(), cells.end());
  return internal::depth_of_points(std::move(cells), surface.number_of_vertices());
}

namespace internal {

/// of a space whose depth may still be unknown, but 1 then
inline Spline_space_options checked_options(const Distributed_surface& surface,
                                            Spline_space_options options) {
  if(!options.depth)
    options.depth = 1;
  return Partial_space::checked(surface.slice().surface, options);
}

inline void check_has_sheets(const Own_sheets& finest, const Distributed_surface& surface) {
  if(finest.first_sheets.back() == 0)
    throw Distributed_error("the surface has area zero: none of its " +
                            std::to_string(surface.number_of_faces()) +
                            " faces is wider than rounding errors in the octree");
}

/// The sheets of a rank, and those of the level above that all ranks hold: parents and children.
/// \param whole the level of all ranks
/// \param first the number in `whole` of the first sheet of `own`
inline void link_to_coarser(const Octree_level& whole, std::uint64_t first, Octree_level& own,
                            Octree_level& coarser) {
  std::vector<Number_lists::Pair> children;
  for(std::uint32_t sheet = 0; sheet < own.number_of_sheets(); ++sheet) {
    own.parents.push_back(whole.parents[static_cast<std::size_t>(first) + sheet]);
    children.emplace_back(own.parents.back(), sheet);
  }
  coarser.children = Number_lists(coarser.number_of_sheets(), children);
}

/// that all ranks hold, and the first one owns
inline Distributed_level whole_level(const Level_elements& elements, const Octree_level& level,
                                     std::size_t number_of_ranks) {
  Distributed_level result;
  const std::size_t size = elements.first_slots.size();
  result.number_of_sheets = level.number_of_sheets();
  result.first_elements.assign(number_of_ranks + 1, size);
  result.first_elements.front() = 0;
  result.number_of_split_elements = elements.number_of_split_elements;
  for(std::size_t k = 0; k < size; ++k)
    result.elements.push_back(k);
  return result;
}

/// \param part gets the elements of this rank
inline Distributed_level divided_level(const Level_exchange& exchange, const Own_sheets& own,
                                       int rank, Level_elements& part) {
  auto elements = exchange.elements(own);
  part = std::move(elements.part);
  Distributed_level result;
  result.first_sheet = own.first_sheet(rank);
  result.number_of_sheets = own.first_sheets.back();
  result.first_elements = std::move(elements.first_elements);
  result.number_of_split_elements = elements.number_of_split_elements;
  result.elements = std::move(elements.numbers);
  result.own_centers = std::move(elements.own_centers);
  return result;
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Distributed_space::Distributed_space(const Distributed_surface& surface,
                                     const Spline_space_options& given)
  : m_communicator(surface.communicator()), m_area(surface.area()) {
  using internal::Octree_builder;
  using internal::Octree_level;
  using internal::Own_sheets;
  using internal::Partial_space;
  const auto rank = static_cast<std::size_t>(m_communicator.rank());
  Spline_space_options options;
  std::optional<Octree_3> octree; // of the slice, for its cube
  bool is_split = false;
  m_communicator.agree([&] {
    if(given.has_material_of_maps)
      throw Parameter_error("diffusion or density", "has to be a number or a function object, not "
                                                    "a property map, on several ranks");
    options = internal::checked_options(surface, given);
    is_split = Partial_space::is_split(surface.slice().surface, options);
    if(is_split && surface.is_point_set())
      throw Parameter_error("split", "is not possible for points on several ranks");
  });
  if(!given.depth)
    options.depth = default_depth(surface, *options.cube_scale);
  m_communicator.agree([&] {
    octree.emplace(Octree_builder::without_levels(surface.slice().surface, *options.depth,
                                                  *options.cube_scale, is_split,
                                                  options.is_parallel));
  });
  const int depth = *options.depth;
  m_ranges = surface.balanced_ranges(*octree);
  // faces in the cells beside those of this rank; sides that are joined are near
  const double margin =
      1 + 2 * options.joining_tolerance.value_or(0) / octree->cell_width(depth) + 1e-3;
  m_surface_part.push_back(surface.part(*octree, *m_ranges, margin));
  const Surface_part& my_part = surface_part();

  Octree_level finest;
  std::vector<internal::Place> places;
  m_communicator.agree([&] {
    octree.emplace(Octree_builder::without_levels(my_part.surface, depth, *options.cube_scale,
                                                  is_split, options.is_parallel));
    const internal::Cell_filter is_wanted = [&](std::uint64_t key) {
      return !my_part.faces.empty() && m_ranges->is_near(rank, depth, key, 1);
    };
    finest = Octree_builder(*octree).finest_level(options.joining_tolerance.value_or(-1),
                                                  Octree_3::default_fragments_at_once, places,
                                                  &is_wanted);
  });

  const internal::Level_exchange exchange(m_communicator, *m_ranges, is_split, options.paper,
                                          options.is_parallel);
  std::vector<Own_sheets> own(static_cast<std::size_t>(depth) + 1);
  own.back() = exchange.own_sheets(finest, places);
  finest = Octree_level();
  internal::check_has_sheets(own.back(), surface);
  const auto coarsest = static_cast<std::size_t>(m_ranges->level());
  for(std::size_t level = static_cast<std::size_t>(depth); level > coarsest; --level)
    own[level - 1] = exchange.coarser(own[level]);

  // the levels that all ranks hold
  std::vector<Octree_level> levels(static_cast<std::size_t>(depth) + 1);
  Octree_level whole = exchange.gathered(own[coarsest], places);
  std::vector<internal::Level_elements> elements;
  m_communicator.agree([&] {
    for(std::size_t level = coarsest; level > 0; --level)
      levels[level - 1] = Octree_builder::coarser_level(level == coarsest ? whole : levels[level],
                                                        places, is_split);
    internal::link_to_coarser(whole, own[coarsest].first_sheet(m_communicator.rank()),
                              own[coarsest].level, levels[coarsest - 1]);
  });
  for(std::size_t level = 0; level < coarsest; ++level) {
    elements.push_back(
        internal::Element_numbering(levels[level], is_split, options.paper, options.is_parallel)());
    m_levels.push_back(internal::whole_level(elements.back(), levels[level], m_ranges->size()));
  }
  for(std::size_t level = coarsest; level < levels.size(); ++level) {
    elements.emplace_back();
    m_levels.push_back(
        internal::divided_level(exchange, own[level], m_communicator.rank(), elements.back()));
    levels[level] = std::move(own[level].level);
  }
  Octree_builder(*octree).set_levels(std::move(levels));
  m_part.emplace(Partial_space::make(options, std::move(*octree), std::move(elements)));
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_DISTRIBUTED_SPACE_IMPL_H

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
    options = given;
    if(!given.depth)
      options.depth = 1; // until the cube is known
    options = Partial_space::checked(surface.slice().surface, options);
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
  if(own.back().first_sheets.back() == 0)
    throw Distributed_error("the surface has area zero: none of its " +
                            std::to_string(surface.number_of_faces()) +
                            " faces is wider than rounding errors in the octree");
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
    // of the sheets of the coarsest level that is divided, those of this rank
    const std::uint64_t first = own[coarsest].first_sheet(m_communicator.rank());
    Octree_level& level = own[coarsest].level;
    std::vector<internal::Number_lists::Pair> children;
    for(std::uint32_t sheet = 0; sheet < level.number_of_sheets(); ++sheet) {
      level.parents.push_back(whole.parents[static_cast<std::size_t>(first) + sheet]);
      children.emplace_back(level.parents.back(), sheet);
    }
    levels[coarsest - 1].children =
        internal::Number_lists(levels[coarsest - 1].number_of_sheets(), children);
  });
  m_levels.resize(levels.size());
  for(std::size_t i = 0; i < levels.size(); ++i) {
    Distributed_level& level = m_levels[i];
    if(i < coarsest) {
      elements.push_back(
          internal::Element_numbering(levels[i], is_split, options.paper, options.is_parallel)());
      level.number_of_sheets = levels[i].number_of_sheets();
      level.first_elements.assign(m_ranges->size() + 1, elements.back().first_slots.size());
      level.first_elements.front() = 0;
      level.number_of_split_elements = elements.back().number_of_split_elements;
      for(std::size_t k = 0; k < elements.back().first_slots.size(); ++k)
        level.elements.push_back(k);
      continue;
    }
    auto of_level = exchange.elements(own[i]);
    level.first_sheet = own[i].first_sheet(m_communicator.rank());
    level.number_of_sheets = own[i].first_sheets.back();
    level.first_elements = std::move(of_level.first_elements);
    level.number_of_split_elements = of_level.number_of_split_elements;
    level.elements = std::move(of_level.numbers);
    level.own_centers = std::move(of_level.own_centers);
    elements.push_back(std::move(of_level.part));
    levels[i] = std::move(own[i].level);
  }
  Octree_builder(*octree).set_levels(std::move(levels));
  m_part.emplace(Partial_space::make(options, std::move(*octree), std::move(elements)));
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_DISTRIBUTED_SPACE_IMPL_H

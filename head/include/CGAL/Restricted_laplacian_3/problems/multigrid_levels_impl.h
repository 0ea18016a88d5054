// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MULTIGRID_LEVELS_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MULTIGRID_LEVELS_IMPL_H

#include <CGAL/Restricted_laplacian_3/problems/multigrid_levels.h>

#include <CGAL/Restricted_laplacian_3/foundation/internal/Number_lists.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/foundation/morton_key.h>
#include <CGAL/Restricted_laplacian_3/splines/prolongation.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Smoothing_patches smoothing_patches(const Spline_space_3& space,
                                                                       int level) {
  CGAL_precondition(level > 0 && level <= space.depth());
  constexpr int log_block_width = 3, number_of_colors = 8;
  const Octree_3& octree = space.octree();
  const std::size_t number_of_sheets = octree.number_of_sheets(level - 1);
  // Sheets are in Morton order, so those in a block are consecutive.
  struct Block {
    std::size_t begin, end;
  };
  std::array<std::vector<Block>, number_of_colors> blocks;
  std::array<int, 3> last = {-1, -1, -1};
  for(std::size_t sheet = 0; sheet < number_of_sheets; ++sheet) {
    std::array<int, 3> block = octree.cell(level - 1, sheet).index;
    int color = 0;
    for(int axis = 0; axis < 3; ++axis) {
      block[axis] >>= log_block_width;
      color |= (block[axis] & 1) << axis;
    }
    if(block != last)
      blocks[color].push_back({sheet, sheet});
    blocks[color].back().end = sheet + 1;
    last = block;
  }

  Smoothing_patches patches;
  std::vector<std::size_t> first(1, 0);
  std::vector<std::uint32_t> unknowns, of_patch;
  first.reserve(number_of_sheets + 1);
  for(const std::vector<Block>& color : blocks) {
    for(const Block& block : color) {
      for(std::size_t sheet = block.begin; sheet < block.end; ++sheet) {
        of_patch.clear();
        for(std::uint32_t child : octree.children(level - 1, sheet))
          for(std::uint32_t element : space.elements(level, child))
            if(element != Spline_space_3::no_element)
              of_patch.push_back(element);
        std::sort(of_patch.begin(), of_patch.end());
        unknowns.insert(unknowns.end(), of_patch.begin(),
                        std::unique(of_patch.begin(), of_patch.end()));
        first.push_back(unknowns.size());
      }
      patches.groups.push_back(static_cast<std::uint32_t>(first.size() - 1));
    }
    patches.colors.push_back(static_cast<std::uint32_t>(patches.groups.size() - 1));
  }
  // The elements around a corner of coarser cells: each patch has all or some of those around the 8
  // corners of its cell.
  patches.neighborhoods.resize(space.dimension(level));
  for(std::size_t element = 0; element < space.dimension(level); ++element) {
    std::array<int, 3> corner = space.center(level, element).index;
    for(int& x : corner)
      x = (x + 1) >> 1;
    patches.neighborhoods[element] = morton_key(corner);
  }
  patches.number_of_patches = number_of_sheets;
  patches.unknowns = internal::Number_lists(std::move(first), std::move(unknowns));
  return patches;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Multigrid_levels multigrid_levels(const Spline_space_3& space,
                                                                     int coarsest) {
  // of levels but the coarsest
  const std::size_t size = static_cast<std::size_t>((std::max)(space.depth() - coarsest, 0));
  Multigrid_levels result;
  result.prolongations.resize(size);
  result.patches.resize(size);
  // What takes longest comes first.
  internal::parallel_for(space.options().is_parallel, 0, 2 * size, 1,
                         [&](std::size_t task, std::size_t) {
                           const std::size_t i = size - 1 - task / 2;
                           const int level = coarsest + static_cast<int>(i);
                           if(task % 2 == 0)
                             result.patches[i] = smoothing_patches(space, level + 1);
                           else
                             prolongation_matrix(space, level).swap(result.prolongations[i]);
                         });
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Multigrid_levels multigrid_levels(const Spline_space_3& space) {
  return multigrid_levels(space, internal::coarsest_multigrid_level(space));
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MULTIGRID_LEVELS_IMPL_H

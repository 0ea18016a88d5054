// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SMOOTHING_PATCHES_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SMOOTHING_PATCHES_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Number_lists.h>
#include <CGAL/Restricted_laplacian_3/solvers/smoothers.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Solvers
/// The patches of a level on which `Patch_smoother` works: one for each sheet of the next coarser
/// level, with all elements that act on one of its children. On a smooth surface these are about 50
/// of the \f$4 \times 4 \times 4\f$ elements around two cells by two by two.
///
/// A group consists of the patches in one block of \f$8 \times 8 \times 8\f$ coarser cells, its
/// colour is the parity of the coordinates of the block. Two groups of the same colour are 16 cells
/// apart; an element of a patch reaches 2 cells beyond the coarser cell, and elements that are 3
/// cells apart are not coupled.
/// \param space the space whose elements are grouped
/// \param level not 0
inline Smoothing_patches smoothing_patches(const Spline_space_3& space, int level) {
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
  std::vector<internal::Number_lists::Pair> pairs;
  pairs.reserve(64 * number_of_sheets);
  std::uint32_t patch = 0;
  for(const std::vector<Block>& color : blocks) {
    for(const Block& block : color) {
      for(std::size_t sheet = block.begin; sheet < block.end; ++sheet, ++patch)
        for(std::uint32_t child : octree.children(level - 1, sheet))
          for(std::uint32_t element : space.elements(level, child))
            if(element != Spline_space_3::no_element)
              pairs.emplace_back(patch, element);
      patches.groups.push_back(patch);
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
  patches.number_of_patches = patch;
  patches.unknowns = internal::Number_lists(patch, pairs);
  return patches;
}

/// \ingroup PkgRestrictedLaplacian3Solvers
/// The patches of the levels from `coarsest + 1` to depth.
inline std::vector<Smoothing_patches> smoothing_patches_of_levels(const Spline_space_3& space,
                                                                  int coarsest) {
  std::vector<Smoothing_patches> result;
  for(int level = coarsest + 1; level <= space.depth(); ++level)
    result.push_back(smoothing_patches(space, level));
  return result;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SMOOTHING_PATCHES_H

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_INTERNAL_DISTRIBUTED_PATCHES_H
#define CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_INTERNAL_DISTRIBUTED_PATCHES_H

#include <CGAL/Restricted_laplacian_3/distributed/Communicator.h>
#include <CGAL/Restricted_laplacian_3/distributed/Distributed_space.h>
#include <CGAL/Restricted_laplacian_3/foundation/morton_key.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The patches of a level that this rank relaxes: as in `smoothing_patches()`, one for each sheet
/// of the next coarser level.
///
/// Blocks of coarser cells are relaxed color by color, all of one color at the same time, on all
/// ranks. So that a block belongs to one rank it is no larger than a cell of the level of the
/// ranges: at most 8 coarser cells wide with 8 colors, by the parity of its coordinates; one cell
/// wide with 27 colors, by its coordinates modulo 3, on the two coarsest levels that are divided.
/// This does not depend on the number of ranks.
struct Distributed_patches {
  struct Patch {
    std::uint32_t color;
    std::uint64_t block; // Morton key
    std::uint64_t sheet; // number in the coarser level
    std::size_t first, last;
  };
  std::vector<Patch> patches; // sorted by color, block and sheet
  std::uint32_t number_of_colors = 0;
  /// numbers in the whole level, ascending in a patch
  std::vector<std::uint64_t> unknowns;
};

/// \param level finer than the gathered one
inline Distributed_patches distributed_patches(const Distributed_space& space, int level) {
  const Communicator& communicator = space.communicator();
  const Octree_3& octree = space.part().octree();
  const Distributed_level& of_level = space.level(level);
  const int log_width = (std::max)((std::min)(level - 2 - space.gathered_level(), 3), 0);
  const int period = log_width > 0 ? 2 : 3;
  Distributed_patches result;
  result.number_of_colors = static_cast<std::uint32_t>(period * period * period);

  // The children of a sheet of the gathered level may be on several ranks: one of them gets all.
  struct Member {
    std::uint64_t sheet, unknown;
  };
  const std::uint64_t first_sheet = space.level(level - 1).first_sheet;
  const bool are_whole = level - 1 > space.gathered_level();
  std::vector<std::vector<Member>> members(static_cast<std::size_t>(communicator.size()));
  std::vector<std::uint64_t> unknowns;
  // `unknowns` become a patch
  const auto add_patch = [&](std::uint64_t sheet) {
    const std::array<int, 3> cell =
        octree.cell(level - 1, static_cast<std::size_t>(sheet - first_sheet)).index;
    Distributed_patches::Patch patch = {0, 0, sheet, result.unknowns.size(), 0};
    std::array<int, 3> block;
    for(int axis = 2; axis >= 0; --axis) {
      block[axis] = cell[axis] >> log_width;
      patch.color = static_cast<std::uint32_t>(period) * patch.color +
                    static_cast<std::uint32_t>(block[axis] % period);
    }
    patch.block = morton_key(block);
    result.unknowns.insert(result.unknowns.end(), unknowns.begin(), unknowns.end());
    patch.last = result.unknowns.size();
    result.patches.push_back(patch);
  };
  for(std::size_t sheet = 0; sheet < octree.number_of_sheets(level - 1); ++sheet) {
    unknowns.clear();
    for(std::uint32_t child : octree.children(level - 1, sheet))
      for(std::uint32_t element : space.part().elements(level, child))
        if(element != no_element)
          unknowns.push_back(of_level.elements[element]);
    std::sort(unknowns.begin(), unknowns.end());
    unknowns.erase(std::unique(unknowns.begin(), unknowns.end()), unknowns.end());
    if(are_whole) {
      add_patch(first_sheet + sheet);
      continue;
    }
    const std::uint64_t first_child = octree.cell(level - 1, sheet).key() << 3;
    for(std::uint64_t unknown : unknowns)
      members[space.ranges().owner(level, first_child)].push_back({first_sheet + sheet, unknown});
  }
  if(!are_whole) {
    std::vector<Member> all;
    for(const auto& list : communicator.exchange(members))
      all.insert(all.end(), list.begin(), list.end());
    std::sort(all.begin(), all.end(), [](const Member& a, const Member& b) {
      return std::tie(a.sheet, a.unknown) < std::tie(b.sheet, b.unknown);
    });
    for(std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
      unknowns.clear();
      for(; end < all.size() && all[end].sheet == all[begin].sheet; ++end)
        if(unknowns.empty() || unknowns.back() != all[end].unknown)
          unknowns.push_back(all[end].unknown);
      add_patch(all[begin].sheet);
    }
  }
  std::sort(result.patches.begin(), result.patches.end(),
            [](const Distributed_patches::Patch& a, const Distributed_patches::Patch& b) {
              return std::tie(a.color, a.block, a.sheet) < std::tie(b.color, b.block, b.sheet);
            });
  return result;
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_INTERNAL_DISTRIBUTED_PATCHES_H

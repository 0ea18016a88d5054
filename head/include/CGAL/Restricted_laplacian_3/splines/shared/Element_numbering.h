// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SHARED_ELEMENT_NUMBERING_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SHARED_ELEMENT_NUMBERING_H

#include <CGAL/Restricted_laplacian_3/basis/Tensor_basis_3.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Disjoint_sets.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/stable_sort_by_key.h>
#include <CGAL/Restricted_laplacian_3/foundation/morton_key.h>
#include <CGAL/Restricted_laplacian_3/octree/Cell_3.h>
#include <CGAL/Restricted_laplacian_3/octree/shared/Octree_level.h>
#include <CGAL/Restricted_laplacian_3/octree/shared/element_masks.h>
#include <CGAL/Restricted_laplacian_3/splines/shared/Level_elements.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Numbers the elements of a level of an octree: in Morton order of the cells that they are
/// centered on, where those outside the grid follow the cell inside that is nearest to them. So the
/// elements of the cells in a range of Morton keys have consecutive numbers.
class Element_numbering {
public:
  /// \param level must outlive this object
  /// \param is_split whether an element is one for each component of its sheets
  /// \param is_paper_space whether only elements centered inside the grid exist
  Element_numbering(const Octree_level& level, bool is_split, bool is_paper_space, bool is_parallel)
    : m_level(level), m_is_split(is_split), m_is_paper_space(is_paper_space),
      m_is_parallel(is_parallel) {}

  /// A number for the cell that an element is centered on, by which elements are sorted. On all
  /// levels but the coarsest, `center_key() >> 3` is the Morton key of the cell inside the grid
  /// that is nearest to it.
  static std::uint64_t center_key(const Cell_3& cell) {
    std::uint64_t key = 0;
    for(int axis = 0; axis < 3; ++axis)
      key |= part_of_key(cell.level, cell.index[axis]) << axis;
    return key;
  }

  /// the cell of a `center_key()` of a level that is not the coarsest
  static Cell_3 center(int level, std::uint64_t key) {
    Cell_3 cell = {level, morton_index(key)};
    for(int& x : cell.index) {
      const bool is_outside = (x & 1) != 0;
      x >>= 1;
      if(is_outside)
        x = x == 0 ? -1 : x + 1;
    }
    return cell;
  }

  /// Sorts the centers of the elements of all sheets; those of equal center are one element for
  /// each component of their sheets under the links. Chunks of sorted slots are numbered on their
  /// own, first from 0: how many elements a chunk has is known only then.
  Level_elements operator()() const {
    Level_elements l;
    if(m_level.number_of_sheets() == 0)
      return l;
    const std::vector<Key_and_slot> slots = sorted_slots();
    Cell_elements none;
    none.fill(no_element);
    l.elements.assign(m_level.number_of_sheets(), none);

    const std::size_t grain = 1 << 15;
    std::vector<Chunk> chunks((slots.size() - 1) / grain + 1);
    parallel_for(m_is_parallel, 0, slots.size(), grain, [&](std::size_t begin, std::size_t end) {
      number_groups(slots, begin, end, l, chunks[begin / grain]);
    });
    for(Chunk& chunk : chunks) {
      chunk.first = static_cast<std::uint32_t>(l.first_slots.size());
      l.first_slots.insert(l.first_slots.end(), chunk.first_slots.begin(), chunk.first_slots.end());
      l.number_of_split_elements += chunk.number_of_split_elements;
    }
    parallel_for(m_is_parallel, 0, chunks.size(), 1, [&](std::size_t begin, std::size_t) {
      const Chunk& chunk = chunks[begin];
      for(std::size_t i = chunk.begin; i < chunk.end; ++i)
        element(l, slots[i].slot) += chunk.first;
    });
    return l;
  }

private:
  struct Key_and_slot {
    std::uint64_t key;
    std::uint32_t slot;
    std::uint32_t sheet() const { return slot / Tensor_basis_3::size; }
  };

  /// the groups of equal center that begin in a chunk of sorted slots
  struct Chunk {
    std::size_t begin = 0, end = 0; // slots of these groups
    std::uint32_t first = 0;        // number of the first element
    std::vector<std::uint32_t> first_slots;
    std::size_t number_of_split_elements = 0;
  };

  void number_groups(const std::vector<Key_and_slot>& slots, std::size_t begin, std::size_t end,
                     Level_elements& l, Chunk& chunk) const {
    while(begin > 0 && begin < end && slots[begin].key == slots[begin - 1].key)
      ++begin;
    chunk.begin = chunk.end = begin;
    Disjoint_sets components;
    while(chunk.end < end) {
      const Key_and_slot* const group = slots.data() + chunk.end;
      std::uint32_t size = 1;
      while(chunk.end + size < slots.size() && group[size].key == group->key)
        ++size;
      find_components(group, size, components);
      std::size_t count = 0;
      for(std::uint32_t i = 0; i < size; ++i) {
        const std::uint32_t slot = group[i].slot;
        const std::uint32_t first = components.find(i);
        if(first == i) {
          ++count;
          element(l, slot) = static_cast<std::uint32_t>(chunk.first_slots.size());
          chunk.first_slots.push_back(slot);
        } else
          element(l, slot) = element(l, group[first].slot);
      }
      if(count > 1)
        chunk.number_of_split_elements += count;
      chunk.end += size;
    }
  }

  static std::uint32_t& element(Level_elements& level, std::uint32_t slot) {
    return level.elements[slot / Tensor_basis_3::size][slot % Tensor_basis_3::size];
  }

  /// sorted by center, and by sheet
  std::vector<Key_and_slot> sorted_slots() const {
    const std::size_t number_of_sheets = m_level.number_of_sheets(), grain = 1 << 11;
    std::vector<std::vector<Key_and_slot>> of_chunks((number_of_sheets - 1) / grain + 1);
    parallel_for(m_is_parallel, 0, number_of_sheets, grain,
                 [&](std::size_t begin, std::size_t end) {
                   auto& of_chunk = of_chunks[begin / grain];
                   of_chunk.reserve(Tensor_basis_3::size * (end - begin));
                   for(std::size_t sheet = begin; sheet < end; ++sheet)
                     add_slots(sheet, of_chunk);
                 });
    std::size_t size = 0;
    for(const auto& of_chunk : of_chunks)
      size += of_chunk.size();
    std::vector<Key_and_slot> slots;
    slots.reserve(size);
    for(auto& of_chunk : of_chunks) {
      slots.insert(slots.end(), of_chunk.begin(), of_chunk.end());
      std::vector<Key_and_slot>().swap(of_chunk);
    }
    stable_sort_by_key(slots, 3 * (m_level.level + (m_level.level > 0 ? 1 : 2)), m_is_parallel,
                       [](const Key_and_slot& s) { return s.key; });
    return slots;
  }

  void add_slots(std::size_t sheet, std::vector<Key_and_slot>& slots) const {
    const Cell_3 cell = m_level.cell(sheet);
    // the parts of the Morton key along each axis
    std::array<std::array<std::uint64_t, 3>, 3> parts;
    for(int axis = 0; axis < 3; ++axis)
      for(int d = 0; d < 3; ++d)
        parts[axis][d] = part_of_key(cell.level, cell.index[axis] + d - 1) << axis;
    std::uint32_t slot = static_cast<std::uint32_t>(Tensor_basis_3::size * sheet);
    for(int dz = -1; dz <= 1; ++dz)
      for(int dy = -1; dy <= 1; ++dy)
        for(int dx = -1; dx <= 1; ++dx, ++slot)
          if((m_level.element_masks[sheet] >> element_bit(dx, dy, dz) & 1) &&
             (!m_is_paper_space || cell.neighbor(dx, dy, dz).is_inside_grid()))
            slots.push_back({parts[0][dx + 1] | parts[1][dy + 1] | parts[2][dz + 1], slot});
  }

  /// the components of the `size` sheets of one center
  void find_components(const Key_and_slot* slots, std::uint32_t size,
                       Disjoint_sets& components) const {
    components.reset(size);
    if(!m_is_split) {
      for(std::uint32_t i = 1; i < size; ++i)
        components.unite(0, i);
      return;
    }
    // Both the sheets of the group and the links of a sheet ascend.
    for(std::uint32_t i = 1; i < size; ++i) {
      const std::size_t sheet = slots[i].sheet();
      std::uint32_t j = 0;
      for(std::uint32_t other : m_level.links[sheet]) {
        if(other > sheet)
          break;
        while(j < i && slots[j].sheet() < other)
          ++j;
        if(j == i)
          break;
        if(slots[j].sheet() == other)
          components.unite(j, i);
      }
    }
  }

  /// Along an axis, the coordinate of the nearest cell inside the grid, and one more bit for being
  /// outside. Around the only cell of level 0 that would not do.
  static std::uint64_t part_of_key(int level, int x) {
    const int last = (1 << level) - 1, inside = (std::min)((std::max)(x, 0), last);
    return spread_bits_by_three(
        static_cast<std::uint64_t>(level == 0 ? x + 1 : 2 * inside + (x != inside)));
  }

  const Octree_level& m_level;
  bool m_is_split, m_is_paper_space, m_is_parallel;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SHARED_ELEMENT_NUMBERING_H

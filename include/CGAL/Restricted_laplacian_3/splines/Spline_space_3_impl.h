// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SPLINE_SPACE_3_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SPLINE_SPACE_3_IMPL_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Disjoint_sets.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/name_step.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/stable_sort_by_key.h>
#include <CGAL/Restricted_laplacian_3/foundation/memory.h>
#include <CGAL/Restricted_laplacian_3/foundation/morton_key.h>
#include <CGAL/Restricted_laplacian_3/integration/cubature.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/splines/estimate_memory.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Numbers the elements of a level of a space whose octree exists.
class Element_numbering {
public:
  using Level = Spline_space_3::Level;

  explicit Element_numbering(const Spline_space_3& space) : m_space(space) {}

  /// Sorts the centers of the elements of all sheets; those of equal center are one element for
  /// each component of their sheets under the links. Chunks of sorted slots are numbered on their
  /// own, first from 0: how many elements a chunk has is known only then.
  Level operator()(int level) {
    Level l;
    const std::vector<Key_and_slot> slots = sorted_slots(level);
    Cell_elements none;
    none.fill(no_element);
    l.elements.assign(m_space.octree().number_of_sheets(level), none);

    const std::size_t grain = 1 << 15;
    std::vector<Chunk> chunks((slots.size() - 1) / grain + 1);
    parallel_for(m_space.options().is_parallel, 0, slots.size(), grain,
                 [&](std::size_t begin, std::size_t end) {
                   number_groups(level, slots, begin, end, l, chunks[begin / grain]);
                 });
    for(Chunk& chunk : chunks) {
      chunk.first = static_cast<std::uint32_t>(l.first_slots.size());
      l.first_slots.insert(l.first_slots.end(), chunk.first_slots.begin(), chunk.first_slots.end());
      l.number_of_split_elements += chunk.number_of_split_elements;
    }
    parallel_for(m_space.options().is_parallel, 0, chunks.size(), 1,
                 [&](std::size_t begin, std::size_t) {
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

  void number_groups(int level, const std::vector<Key_and_slot>& slots, std::size_t begin,
                     std::size_t end, Level& l, Chunk& chunk) const {
    while(begin > 0 && begin < end && slots[begin].key == slots[begin - 1].key)
      ++begin;
    chunk.begin = chunk.end = begin;
    Disjoint_sets components;
    while(chunk.end < end) {
      const Key_and_slot* const group = slots.data() + chunk.end;
      std::uint32_t size = 1;
      while(chunk.end + size < slots.size() && group[size].key == group->key)
        ++size;
      find_components(level, group, size, components);
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

  static std::uint32_t& element(Level& level, std::uint32_t slot) {
    return level.elements[slot / Tensor_basis_3::size][slot % Tensor_basis_3::size];
  }

  /// sorted by center, and by sheet
  std::vector<Key_and_slot> sorted_slots(int level) const {
    const std::size_t number_of_sheets = m_space.octree().number_of_sheets(level), grain = 1 << 11;
    std::vector<std::vector<Key_and_slot>> of_chunks((number_of_sheets - 1) / grain + 1);
    parallel_for(m_space.options().is_parallel, 0, number_of_sheets, grain,
                 [&](std::size_t begin, std::size_t end) {
                   auto& of_chunk = of_chunks[begin / grain];
                   of_chunk.reserve(Tensor_basis_3::size * (end - begin));
                   for(std::size_t sheet = begin; sheet < end; ++sheet)
                     add_slots(level, sheet, of_chunk);
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
    // Coordinates of centers, shifted by one, are in 0 .. 2^level + 1.
    stable_sort_by_key(slots, 3 * (level + 2), m_space.options().is_parallel,
                       [](const Key_and_slot& s) { return s.key; });
    return slots;
  }

  void add_slots(int level, std::size_t sheet, std::vector<Key_and_slot>& slots) const {
    const Cell_3 cell = m_space.octree().cell(level, sheet);
    // the parts of the Morton key along each axis
    std::array<std::array<std::uint64_t, 3>, 3> parts;
    for(int axis = 0; axis < 3; ++axis)
      for(int d = 0; d < 3; ++d)
        parts[axis][d] = spread_bits_by_three(static_cast<std::uint64_t>(cell.index[axis] + d))
                         << axis;
    std::uint32_t slot = static_cast<std::uint32_t>(Tensor_basis_3::size * sheet);
    for(int dz = -1; dz <= 1; ++dz)
      for(int dy = -1; dy <= 1; ++dy)
        for(int dx = -1; dx <= 1; ++dx, ++slot)
          if(m_space.octree().meets_element(level, sheet, dx, dy, dz) &&
             (!m_space.is_paper_space() || cell.neighbor(dx, dy, dz).is_inside_grid()))
            slots.push_back({parts[0][dx + 1] | parts[1][dy + 1] | parts[2][dz + 1], slot});
  }

  /// the components of the `size` sheets of one center
  void find_components(int level, const Key_and_slot* slots, std::uint32_t size,
                       Disjoint_sets& components) const {
    components.reset(size);
    if(!m_space.is_split()) {
      for(std::uint32_t i = 1; i < size; ++i)
        components.unite(0, i);
      return;
    }
    // Both the sheets of the group and the links of a sheet ascend.
    for(std::uint32_t i = 1; i < size; ++i) {
      const std::size_t sheet = slots[i].sheet();
      std::uint32_t j = 0;
      for(std::uint32_t other : m_space.octree().links(level, sheet)) {
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

  const Spline_space_3& m_space;
};

// `side` is that of the domain cube.
inline int default_depth_of_triangles(const Triangulated_surface_3& surface, double side) {
  constexpr int default_smallest_depth = 5;
  constexpr int default_largest_depth = 8;
  constexpr double least_edge_over_width = 0.5;
  double sum = 0;
  for(std::size_t face = 0; face < surface.number_of_faces(); ++face) {
    for(int i = 0; i < 3; ++i) {
      const Vector_3 edge = surface.point(face, (i + 1) % 3) - surface.point(face, i);
      sum += std::hypot(edge.x() / side, edge.y() / side, edge.z() / side);
    }
  }
  const double mean = sum / (3. * static_cast<double>(surface.number_of_faces()));
  int depth = default_smallest_depth;
  while(depth < default_largest_depth && std::ldexp(mean, depth) < least_edge_over_width)
    ++depth;
  return depth;
}

inline int default_depth_of_points(const Triangulated_surface_3& surface, double side) {
  constexpr std::size_t points_per_cell = 50;
  constexpr int largest_depth = 6;
  const Point_3 center = surface.center();
  std::vector<std::uint64_t> keys;
  keys.reserve(surface.number_of_vertices());
  for(std::size_t i = 0; i < surface.number_of_vertices(); ++i) {
    std::array<int, 3> index;
    for(int axis = 0; axis < 3; ++axis) {
      const double x =
          ((surface.point(i)[axis] - center[axis]) / side + 0.5) * (1 << largest_depth);
      index[axis] = (std::min)((std::max)(static_cast<int>(x), 0), (1 << largest_depth) - 1);
    }
    keys.push_back(morton_key(index));
  }
  std::sort(keys.begin(), keys.end());
  int depth = largest_depth;
  for(;; --depth) {
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    if(depth == 1 || surface.number_of_vertices() >= points_per_cell * keys.size())
      return depth;
    for(std::uint64_t& key : keys)
      key >>= 3;
  }
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE int default_octree_depth(const Triangulated_surface_3& surface,
                                                            double cube_scale) {
  const double side = internal::checked_cube_scale(cube_scale) * surface.extent();
  return surface.is_point_set() ? internal::default_depth_of_points(surface, side)
                                : internal::default_depth_of_triangles(surface, side);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Spline_space_3::Spline_space_3(Triangulated_surface_3 surface, const Options& np)
  : m_options(checked(surface, np)),
    m_octree(std::make_shared<const Octree_3>(make_octree(std::move(surface), m_options))),
    m_integration(default_integration(*m_octree)) {
  internal::Element_numbering number(*this);
  internal::name_step("not enough memory for the elements of the space", [&] {
    std::vector<Level> levels;
    for(int level = 0; level <= depth(); ++level)
      levels.push_back(number(level));
    m_levels = std::make_shared<const std::vector<Level>>(std::move(levels));
  });
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE int
Spline_space_3::checked_level(std::optional<int> level) const {
  const int l = level.value_or(depth());
  if(l < 0 || l > depth())
    throw Parameter_error("level", "is " + std::to_string(l) + ", but must be in 0 .. " +
                                       std::to_string(depth()));
  return l;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Octree_3
Spline_space_3::make_octree(Triangulated_surface_3&& surface, const Options& o) {
  internal::check_memory(surface, *o.octree_depth, *o.cube_scale, *o.maximum_memory);
  const bool is_split = surface.is_point_set() ? o.split_point_set : o.split_elements;
  return internal::name_step("not enough memory for the octree", [&] {
    return Octree_3(std::move(surface), *o.octree_depth, *o.cube_scale, is_split,
                    o.joining_tolerance.value_or(-1), o.is_parallel);
  });
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Spline_space_3::Options
Spline_space_3::checked(const Triangulated_surface_3& surface, Options options) {
  constexpr double default_cube_scale = 1.1, default_cube_scale_of_paper = 1.2;
  if(!options.cube_scale)
    options.cube_scale = options.paper_space ? default_cube_scale_of_paper : default_cube_scale;
  if(!options.octree_depth)
    options.octree_depth = default_octree_depth(surface, *options.cube_scale);
  if(!options.maximum_memory)
    options.maximum_memory = memory_of_machine();
  if(!(*options.maximum_memory > 0))
    throw Parameter_error("maximum_memory", "is " + std::to_string(*options.maximum_memory) +
                                                ", but must be a positive number");
  options.split_elements = options.split_elements && !options.paper_space;
  options.split_point_set = options.split_point_set && !options.paper_space;
  const double tolerance = options.joining_tolerance.value_or(0);
  if(!(tolerance >= 0 && std::isfinite(tolerance)))
    throw Parameter_error("joining_tolerance",
                          "is " + std::to_string(tolerance) +
                              ", but must be a finite number that is not negative");
  return options;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SPLINE_SPACE_3_IMPL_H

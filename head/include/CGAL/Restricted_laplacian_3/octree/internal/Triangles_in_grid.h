// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_TRIANGLES_IN_GRID_H
#define CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_TRIANGLES_IN_GRID_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/stable_sort_by_key.h>
#include <CGAL/Restricted_laplacian_3/foundation/morton_key.h>
#include <CGAL/Restricted_laplacian_3/octree/Surface_windows.h>
#include <CGAL/Restricted_laplacian_3/octree/clip_to_cells.h>
#include <CGAL/Restricted_laplacian_3/octree/internal/Seams_in_grid.h>
#include <CGAL/Restricted_laplacian_3/octree/internal/Surface_in_grid.h>
#include <CGAL/Restricted_laplacian_3/octree/shared/element_masks.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_seams.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// A surface of triangles, which are cut at the walls of the cells. Sheets are fragments that are
/// joined along seams.
class Triangles_in_grid : public Surface_in_grid {
public:
  /// \param clipper cuts at the walls of the cells
  /// \param thin_face_height,joining_tolerance of `Surface_seams`, the former in cell widths
  Triangles_in_grid(Grid_input input, const Cell_clipper& clipper, double thin_face_height,
                    double joining_tolerance)
    : m_input(std::move(input)), m_clipper(clipper),
      m_windows(m_input.surface, m_input.vertices, m_input.fragments_at_once,
                (std::max)(joining_tolerance / m_input.vertices.cell_width(), 0.),
                m_input.is_parallel) {
    if(!m_input.is_split)
      return;
    const double h = m_input.vertices.cell_width();
    Surface_seams::Parts parts;
    for(std::size_t window = 0; window < m_windows.size(); ++window)
      parts.push_back(m_windows.faces(window));
    m_seams.emplace(m_input.surface, thin_face_height * h, joining_tolerance, parts,
                    m_input.is_parallel);
    const double width = (std::max)(2 * thin_face_height, 1.01 * joining_tolerance / h);
    m_seams_in_grid.emplace(m_input.surface, *m_seams, m_input.vertices, width);
  }

  std::size_t number_of_windows() const override { return m_windows.size(); }

  std::size_t estimated_number_of_fragments() const override {
    return static_cast<std::size_t>(m_windows.estimated_number_of_fragments());
  }

  std::vector<Cell_fragment> fragments(std::size_t window) const override {
    const Number_view faces = m_windows.faces(window);
    const auto cells = m_windows.cells(window);
    if(faces.size() == 0)
      return {};
    const std::size_t grain = 1 << 14;
    std::vector<std::vector<Cell_fragment>> of_chunks((faces.size() - 1) / grain + 1);
    parallel_for(m_input.is_parallel, 0, faces.size(), grain,
                 [&](std::size_t begin, std::size_t end) {
                   auto& of_chunk = of_chunks[begin / grain];
                   of_chunk.reserve(3 * (end - begin) / 2);
                   for(std::size_t i = begin; i < end; ++i)
                     if(!m_input.surface.is_degenerate(faces[i]))
                       cut(faces[i], cells, of_chunk);
                 });
    std::size_t number_of_fragments = 0;
    for(const auto& of_chunk : of_chunks)
      number_of_fragments += of_chunk.size();
    std::vector<Cell_fragment> result;
    result.reserve(number_of_fragments);
    for(auto& of_chunk : of_chunks) {
      result.insert(result.end(), of_chunk.begin(), of_chunk.end());
      std::vector<Cell_fragment>().swap(of_chunk);
    }
    stable_sort_by_key(result, 3 * m_input.vertices.depth(), m_input.is_parallel,
                       [](const Cell_fragment& fragment) { return fragment.key; });
    return result;
  }

  void join(const Cell_fragment* fragments, std::uint32_t size,
            Sheet_scratch& scratch) const override {
    m_seams_in_grid->join(fragments, size, scratch);
  }

  void link(const Octree_level& finest, Links& links) const override {
    link_fragments_of_same_face(finest, links);
    link_faces_along_walls(finest, links);
  }

private:
  /// appends those fragments that are in a range of cells
  void cut(std::size_t face, const std::array<std::uint64_t, 2>& cells,
           std::vector<Cell_fragment>& fragments) const {
    const bool has_places = m_seams.has_value(); // one sheet for each cell needs no order
    m_clipper.cut_snapped(m_input.vertices.corners(face), [&](const std::array<int, 3>& cell,
                                                              const Fragment& fragment) {
      const std::uint64_t key = morton_key(cell);
      if(key < cells[0] || key >= cells[1] || !m_input.wants(key))
        return;
      Place place;
      if(has_places)
        place = {fragment.double_area() / 2, fragment.integral_of_linear(sorting_direction())};
      // A patch may leave the walls in which its piece lies.
      const bool is_flat = !m_input.division || m_input.division->is_flat(face);
      const std::uint32_t mask =
          is_flat ? element_mask_of_range([&](int axis) { return range(fragment, axis); }, cell)
                  : all_elements;
      fragments.push_back({key, static_cast<std::uint32_t>(face), mask, place});
    });
  }

  static void add_link(std::size_t sheet, std::size_t other, Links& links) {
    const auto a = static_cast<std::uint32_t>(sheet), b = static_cast<std::uint32_t>(other);
    links.emplace_back(a, b);
    links.emplace_back(b, a);
  }

  void link_fragments_of_same_face(const Octree_level& finest, Links& links) const {
    const std::size_t number_of_cells = finest.number_of_cells(), grain = 1 << 10;
    std::vector<Links> of_chunks((number_of_cells - 1) / grain + 1);
    parallel_for(m_input.is_parallel, 0, number_of_cells, grain,
                 [&](std::size_t begin, std::size_t end) {
                   for(std::size_t i = begin; i < end; ++i)
                     link_with_neighbors(finest, i, of_chunks[begin / grain]);
                 });
    for(const Links& of_chunk : of_chunks)
      links.insert(links.end(), of_chunk.begin(), of_chunk.end());
  }

  /// links the sheets of cell number `i` with those of one half of the 26 neighbors
  static void link_with_neighbors(const Octree_level& finest, std::size_t i, Links& links) {
    const auto [first, last] = finest.sheets(i);
    const Cell_3 cell = finest.cell(first);
    for(int k = 14; k < 27; ++k) {
      const std::size_t j = finest.find(cell.neighbor(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1));
      if(j == finest.number_of_cells())
        continue;
      const auto [other_first, other_last] = finest.sheets(j);
      for(std::size_t sheet = first; sheet < last; ++sheet)
        for(std::size_t other = other_first; other < other_last; ++other)
          if(have_common_face(finest, sheet, other))
            add_link(sheet, other, links);
    }
  }

  static bool have_common_face(const Octree_level& finest, std::size_t sheet, std::size_t other) {
    const auto a = finest.faces[sheet], b = finest.faces[other];
    for(auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end();) {
      if(*i == *j)
        return true;
      if(*i < *j)
        ++i;
      else
        ++j;
    }
    return false;
  }

  void link_faces_along_walls(const Octree_level& finest, Links& links) const {
    std::vector<std::size_t> touching;
    m_seams_in_grid->for_each_piece_in_walls(
        m_input.is_parallel,
        [&](const std::array<int, 3>& low, const std::array<int, 3>& high, const auto& faces) {
          touching.clear();
          Cell_3 cell{finest.level, {}};
          for(cell.index[2] = low[2]; cell.index[2] <= high[2]; ++cell.index[2])
            for(cell.index[1] = low[1]; cell.index[1] <= high[1]; ++cell.index[1])
              for(cell.index[0] = low[0]; cell.index[0] <= high[0]; ++cell.index[0]) {
                const std::size_t i = finest.find(cell);
                if(i == finest.number_of_cells())
                  continue;
                for(std::uint32_t face : faces) {
                  const std::size_t sheet = finest.sheet_of_face(i, face);
                  if(sheet != finest.number_of_sheets())
                    touching.push_back(sheet);
                }
              }
          std::sort(touching.begin(), touching.end());
          touching.erase(std::unique(touching.begin(), touching.end()), touching.end());
          for(std::size_t a = 0; a < touching.size(); ++a)
            for(std::size_t b = 0; b < a; ++b)
              add_link(touching[b], touching[a], links);
        });
  }

  Grid_input m_input;
  Cell_clipper m_clipper;
  Surface_windows m_windows;
  std::optional<Surface_seams> m_seams; // of a surface that is split, as the following
  std::optional<Seams_in_grid> m_seams_in_grid;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_TRIANGLES_IN_GRID_H

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_FINEST_SHEETS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_FINEST_SHEETS_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Disjoint_sets.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Function_view.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/octree/shared/Sheet_sorter.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

/// \file
/// The sheets that the fragments in each cell of the finest level form. Threads take chunks of
/// cells; results of chunks are put one after the other, so they do not depend on the number of
/// threads.

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// a fragment of a face, and the Morton key of its cell
struct Cell_fragment {
  std::uint64_t key;
  std::uint32_t face;
  std::uint32_t element_mask;
  Place place;
};

/// The cells of the finest level, and the sheets in them.
struct Finest_sheets {
  std::vector<std::uint64_t> keys;         // of cells
  std::vector<std::uint32_t> first_sheets; // of cells
  std::vector<std::uint32_t> cells;        // of sheets, as all that follows
  std::vector<std::uint32_t> element_masks;
  std::vector<Place> places;
  std::vector<std::size_t> first_faces;
  std::vector<std::uint32_t> faces; // ascending in a sheet
};

/// What a thread uses again for each cell.
struct Sheet_scratch {
  Disjoint_sets sets;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> sides; // seam, and number of the fragment
  Sheet_sorter sort;
};

/// Unites, in `scratch.sets`, those of the numbers 0 .. size - 1 whose fragments, all in one cell,
/// are in the same sheet. May be called from several threads at once.
using Join_fragments =
    Function_view<void(const Cell_fragment* fragments, std::uint32_t size, Sheet_scratch& scratch)>;

/// the sheets of some consecutive cells
struct Sheets_of_chunk {
  std::vector<std::uint32_t> numbers_of_sheets; // of cells
  std::vector<std::uint32_t> element_masks;     // of sheets, as all that follows
  std::vector<Place> places;
  std::vector<std::size_t> first_faces;
};

/// Appends the sheets of the cell of the fragments `begin` .. `end` - 1; their faces are written to
/// `faces[begin]` .. `faces[end - 1]`.
inline void append_sheets_of_cell(const std::vector<Cell_fragment>& fragments, std::size_t begin,
                                  std::size_t end, const Join_fragments& join,
                                  Sheet_scratch& scratch, std::uint32_t* faces,
                                  Sheets_of_chunk& sheets) {
  const auto size = static_cast<std::uint32_t>(end - begin);
  join(fragments.data() + begin, size, scratch);
  const auto& firsts = scratch.sort(
      scratch.sets, 0, size, [&](std::uint32_t i) { return fragments[begin + i].place; },
      sheets.places);
  sheets.numbers_of_sheets.push_back(static_cast<std::uint32_t>(firsts.size()));
  std::size_t next = begin;
  for(std::uint32_t first : firsts) {
    sheets.first_faces.push_back(next);
    std::uint32_t mask = 0;
    for(std::uint32_t i = first; i < size; ++i)
      if(scratch.sets.find(i) == first) {
        faces[next++] = fragments[begin + i].face;
        mask |= fragments[begin + i].element_mask;
      }
    sheets.element_masks.push_back(mask);
  }
}

/// Groups the fragments of each cell into sheets, and appends these.
/// \param fragments sorted by cell; their cells come after all that are there
inline void group_into_sheets(const std::vector<Cell_fragment>& fragments,
                              const Join_fragments& join, bool is_parallel, Finest_sheets& sheets) {
  std::vector<std::size_t> begins;
  for(std::size_t i = 0; i < fragments.size(); ++i)
    if(i == 0 || fragments[i].key != fragments[i - 1].key) {
      begins.push_back(i);
      sheets.keys.push_back(fragments[i].key);
    }
  const std::size_t number_of_cells = begins.size(), first_fragment = sheets.faces.size(),
                    grain = 1 << 10;
  begins.push_back(fragments.size());
  sheets.faces.resize(first_fragment + fragments.size());
  std::vector<Sheets_of_chunk> of_chunks(number_of_cells / grain + 1);
  parallel_for(is_parallel, 0, number_of_cells, grain, [&](std::size_t begin, std::size_t end) {
    Sheet_scratch scratch;
    for(std::size_t i = begin; i < end; ++i)
      append_sheets_of_cell(fragments, begins[i], begins[i + 1], join, scratch,
                            sheets.faces.data() + first_fragment, of_chunks[begin / grain]);
  });

  const auto append = [](auto& all, const auto& part) {
    all.insert(all.end(), part.begin(), part.end());
  };
  for(const Sheets_of_chunk& of_chunk : of_chunks) {
    for(std::uint32_t number_of_sheets : of_chunk.numbers_of_sheets) {
      const auto cell = static_cast<std::uint32_t>(sheets.first_sheets.size());
      sheets.first_sheets.push_back(static_cast<std::uint32_t>(sheets.cells.size()));
      sheets.cells.insert(sheets.cells.end(), number_of_sheets, cell);
    }
    append(sheets.element_masks, of_chunk.element_masks);
    append(sheets.places, of_chunk.places);
    for(std::size_t first : of_chunk.first_faces)
      sheets.first_faces.push_back(first_fragment + first);
  }
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_FINEST_SHEETS_H

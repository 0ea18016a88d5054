// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_SYMMETRIC_ROWS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_SYMMETRIC_ROWS_H

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/Scratch_memory.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The rows of a symmetric matrix, of which the entries on and above the diagonal are read: refers
/// to the matrix, and has the places of these entries row by row, eight bytes for each.
class Symmetric_rows {
public:
  /// \param room for the entries, used if it is large enough
  explicit Symmetric_rows(const Sparse_matrix& a, Scratch_memory* room = nullptr)
    : m_matrix(a), m_first(static_cast<std::size_t>(a.cols()) + 1, 0) {
    // Ends are counted down to beginnings while the rows are filled from their ends.
    for_each_above([this](int i, const Entry&) { ++m_first[i]; });
    for(std::size_t i = 0; i + 1 < m_first.size(); ++i)
      m_first[i + 1] += m_first[i];
    const std::size_t size = sizeof(Entry) * m_first.back();
    if(!room || room->size() < size) {
      m_own_room = Scratch_memory(size);
      room = &m_own_room;
    }
    m_entries = room->as<Entry>();
    for_each_above([this](int i, const Entry& entry) { m_entries[--m_first[i]] = entry; });
  }

  /// calls `visit(j, value)` for all entries of row `i`
  template <class Visitor> void for_each_entry(int i, Visitor&& visit) const {
    for(Sparse_matrix::InnerIterator k(m_matrix, i); k && k.row() <= i; ++k)
      visit(static_cast<int>(k.row()), k.value());
    for(std::uint32_t k = m_first[i]; k < m_first[i + 1]; ++k)
      visit(m_entries[k].column, m_matrix.valuePtr()[m_entries[k].place]);
  }

private:
  struct Entry {
    int column, place;
  };

  /// calls `visit(row, entry)` for all entries above the diagonal
  template <class Visitor> void for_each_above(Visitor&& visit) const {
    for(int j = 0; j < m_matrix.cols(); ++j)
      for(Sparse_matrix::InnerIterator k(m_matrix, j); k && k.row() < j; ++k)
        visit(static_cast<int>(k.row()),
              Entry{j, static_cast<int>(&k.value() - m_matrix.valuePtr())});
  }

  const Sparse_matrix& m_matrix;
  std::vector<std::uint32_t> m_first; // entry after the diagonal of each row, and one more
  Scratch_memory m_own_room;
  Entry* m_entries;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_SYMMETRIC_ROWS_H

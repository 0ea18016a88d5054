// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INTERNAL_ELEMENT_MATRIX_PATTERN_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INTERNAL_ELEMENT_MATRIX_PATTERN_H

#include <CGAL/Restricted_laplacian_3/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/cell_integrals.h>
#include <CGAL/Restricted_laplacian_3/exceptions.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The pattern of the matrices of a level: two elements are coupled if they act on the same sheet.
class Element_matrix_pattern {
public:
  Element_matrix_pattern(const Spline_space_3& space, int level) {
    const std::size_t n = space.dimension(level);
    const std::size_t number_of_sheets = space.octree().number_of_sheets(level);

    // sheets of each element
    std::vector<std::size_t> first(n + 1, 0);
    for(std::size_t i = 0; i < number_of_sheets; ++i)
      for(std::uint32_t e : space.elements(level, i))
        if(e != Spline_space_3::no_element)
          ++first[e + 1];
    for(std::size_t e = 0; e < n; ++e)
      first[e + 1] += first[e];
    std::vector<std::uint32_t> sheets(first[n]);
    std::vector<std::size_t> next(first.begin(), first.end() - 1);
    for(std::size_t i = 0; i < number_of_sheets; ++i)
      for(std::uint32_t e : space.elements(level, i))
        if(e != Spline_space_3::no_element)
          sheets[next[e]++] = static_cast<std::uint32_t>(i);

    m_outer.reserve(n + 1);
    m_outer.push_back(0);
    std::vector<std::uint32_t> last_seen(n, Spline_space_3::no_element);
    for(std::size_t e = 0; e < n; ++e) {
      const std::size_t begin = m_inner.size();
      for(std::size_t k = first[e]; k < first[e + 1]; ++k)
        for(std::uint32_t other : space.elements(level, sheets[k]))
          if(other != Spline_space_3::no_element && last_seen[other] != e) {
            last_seen[other] = static_cast<std::uint32_t>(e);
            m_inner.push_back(static_cast<int>(other));
          }
      std::sort(m_inner.begin() + begin, m_inner.end());
      if(m_inner.size() > static_cast<std::size_t>((std::numeric_limits<int>::max)()))
        throw Parameter_error("octree_depth", "gives matrices of more than 2^31 entries");
      m_outer.push_back(static_cast<int>(m_inner.size()));
    }
  }

  Eigen::SparseMatrix<double> zero_matrix() const {
    const Eigen::Index n = static_cast<Eigen::Index>(m_outer.size()) - 1;
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.resizeNonZeros(static_cast<Eigen::Index>(m_inner.size()));
    std::copy(m_outer.begin(), m_outer.end(), matrix.outerIndexPtr());
    std::copy(m_inner.begin(), m_inner.end(), matrix.innerIndexPtr());
    std::fill(matrix.valuePtr(), matrix.valuePtr() + m_inner.size(), 0.);
    return matrix;
  }

private:
  std::vector<int> m_outer, m_inner;
};

/// Calls `visit(position, entry)` for the entries of the block of a sheet: position in the arrays
/// of a matrix, number in the block. Both the elements of the sheet and the rows of a column are
/// walked through in ascending order, so each column takes one merge.
template <class Visitor>
void for_each_block_entry(const Cell_elements& elements, const Eigen::SparseMatrix<double>& matrix,
                          Visitor&& visit) {
  std::array<std::pair<std::uint32_t, int>, 27> sorted;
  int count = 0;
  for(int i = 0; i < 27; ++i)
    if(elements[i] != Spline_space_3::no_element)
      sorted[count++] = {elements[i], i};
  std::sort(sorted.begin(), sorted.begin() + count);

  const int* inner = matrix.innerIndexPtr();
  for(int j = 0; j < count; ++j) {
    std::size_t position = matrix.outerIndexPtr()[sorted[j].first];
    const int column = 27 * sorted[j].second;
    for(int i = 0; i < count; ++i, ++position) {
      const int row = static_cast<int>(sorted[i].first);
      while(inner[position] != row)
        ++position;
      visit(position, column + sorted[i].second);
    }
  }
}

/// adds the block of a sheet to a matrix
inline void add_cell_block(const Cell_elements& elements, const Cell_block& block, double factor,
                           Eigen::SparseMatrix<double>& matrix) {
  double* values = matrix.valuePtr();
  for_each_block_entry(elements, matrix, [&](std::size_t position, int entry) {
    values[position] += factor * block[entry];
  });
}

/// adds the blocks of a sheet to two matrices of the same pattern
inline void add_cell_blocks(const Cell_elements& elements, const Cell_block& stiffness,
                            const Cell_block& mass, double mass_factor,
                            Eigen::SparseMatrix<double>& stiffness_matrix,
                            Eigen::SparseMatrix<double>& mass_matrix) {
  double *stiffness_values = stiffness_matrix.valuePtr(), *mass_values = mass_matrix.valuePtr();
  for_each_block_entry(elements, stiffness_matrix, [&](std::size_t position, int entry) {
    stiffness_values[position] += stiffness[entry];
    mass_values[position] += mass_factor * mass[entry];
  });
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INTERNAL_ELEMENT_MATRIX_PATTERN_H

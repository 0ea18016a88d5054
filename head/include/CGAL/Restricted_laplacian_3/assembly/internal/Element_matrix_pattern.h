// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_INTERNAL_ELEMENT_MATRIX_PATTERN_H
#define CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_INTERNAL_ELEMENT_MATRIX_PATTERN_H

#include <CGAL/Restricted_laplacian_3/assembly/internal/Stored_entries.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Number_lists.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/sum_counts.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The pattern of the matrices of a level: two elements are coupled if they act on the same sheet.
///
/// The rows of a column are gathered twice, to count and to write them, straight into the matrix:
/// there is never a second copy of the largest array.
class Element_matrix_pattern {
public:
  Element_matrix_pattern(const Spline_space_3& space, int level) : m_space(space) {
    const std::size_t n = space.dimension(level);
    const std::size_t number_of_sheets = space.octree().number_of_sheets(level);
    group_by_key(
        n, Tensor_basis_3::size * number_of_sheets,
        [&](std::size_t k) -> std::size_t {
          const std::uint32_t e =
              space.elements(level, k / Tensor_basis_3::size)[k % Tensor_basis_3::size];
          return e == Spline_space_3::no_element ? n : e;
        },
        [](std::size_t k) { return static_cast<std::uint32_t>(k / Tensor_basis_3::size); }, m_first,
        m_sheets);
    m_first_words.reserve(number_of_sheets + 1);
    for(std::size_t i = 0; i < number_of_sheets; ++i) {
      m_first_words.push_back(m_words.size());
      for(std::uint32_t e : space.elements(level, i))
        if(e != Spline_space_3::no_element)
          add_to_words(e, m_first_words.back());
    }
    m_first_words.push_back(m_words.size());
  }

  /// the matrix of this pattern with all entries 0
  /// \throws Parameter_error if it has more entries than an `int` can count
  Eigen::SparseMatrix<double> zero_matrix(Stored_entries stored = Stored_entries::all) const {
    const std::size_t n = m_first.size() - 1;
    Eigen::SparseMatrix<double> matrix(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
    int* outer = matrix.outerIndexPtr();
    // the rows of a column that are stored and have a bit in a word
    const auto rows_of = [stored](std::size_t element, const Word& word) {
      if(stored == Stored_entries::all || word.number < element / 64)
        return word.bits;
      const std::uint64_t up_to_element = ~std::uint64_t(0) >> (63 - element % 64);
      return word.number == element / 64 ? word.bits & up_to_element : 0;
    };
    for_each_column([=](std::size_t element, const Words& words) {
      int count = 0;
      for(const Word& word : words)
        count += number_of_bits(rows_of(element, word));
      outer[element + 1] = count;
    });
    matrix.resizeNonZeros(sum_counts(outer + 1, n, "depth", "matrix"));
    int* inner = matrix.innerIndexPtr();
    double* values = matrix.valuePtr();
    for_each_column([=](std::size_t element, Words& words) {
      std::sort(words.begin(), words.end());
      int* row = inner + outer[element];
      for(const Word& word : words)
        for(std::uint64_t bits = rows_of(element, word); bits != 0; bits &= bits - 1)
          *row++ = static_cast<int>(64 * word.number) + lowest_bit(bits);
      std::fill(values + outer[element], values + outer[element + 1], 0.);
    });
    return matrix;
  }

private:
  /// The elements of a sheet, and the rows of a column, are a set of bits, of which few words are
  /// not 0: neighbors in space have near numbers. So few numbers need to be sorted, and elements
  /// are united by the word.
  struct Word {
    std::uint32_t number;
    std::uint64_t bits;
    bool operator<(const Word& other) const { return number < other.number; }
  };
  using Words = std::vector<Word>;

  /// adds neighboring bits, pairs, nibbles and bytes
  static int number_of_bits(std::uint64_t x) {
    x -= x >> 1 & 0x5555555555555555ull;
    x = (x & 0x3333333333333333ull) + (x >> 2 & 0x3333333333333333ull);
    x = (x + (x >> 4)) & 0x0f0f0f0f0f0f0f0full;
    return static_cast<int>((x * 0x0101010101010101ull) >> 56);
  }

  static int lowest_bit(std::uint64_t x) {
#ifdef __GNUC__
    return __builtin_ctzll(x);
#else
    return number_of_bits((x & (~x + 1)) - 1);
#endif
  }

  template <class Visitor> void for_each_column(Visitor&& visit) const {
    const std::size_t n = m_first.size() - 1;
    const std::size_t number_of_words = n / 64 + 1;
    parallel_for(m_space.options().is_parallel, 0, n,
                 (std::max)(std::size_t(4096), number_of_words),
                 [&](std::size_t begin, std::size_t end) {
                   Words words;
                   std::vector<std::uint32_t> place(number_of_words, 0);
                   for(std::size_t e = begin; e < end; ++e) {
                     gather(e, words, place);
                     visit(e, words);
                   }
                 });
  }

  /// adds an element to the words from number `first` on
  void add_to_words(std::uint32_t element, std::size_t first) {
    const std::uint32_t number = element / 64;
    std::size_t i = first;
    while(i < m_words.size() && m_words[i].number != number)
      ++i;
    if(i == m_words.size())
      m_words.push_back({number, 0});
    m_words[i].bits |= std::uint64_t(1) << (element % 64);
  }

  /// \param place where a word was last seen among `words`; checked, so it may be out of date
  void gather(std::size_t element, Words& words, std::vector<std::uint32_t>& place) const {
    words.clear();
    for(std::size_t k = m_first[element]; k < m_first[element + 1]; ++k) {
      const std::size_t sheet = m_sheets[k];
      for(std::size_t w = m_first_words[sheet]; w < m_first_words[sheet + 1]; ++w) {
        const Word& word = m_words[w];
        std::uint32_t& at = place[word.number];
        if(at >= words.size() || words[at].number != word.number) {
          at = static_cast<std::uint32_t>(words.size());
          words.push_back(word);
        } else
          words[at].bits |= word.bits;
      }
    }
  }

  const Spline_space_3& m_space;
  std::vector<std::size_t> m_first; // of elements, numbers in the following
  std::vector<std::uint32_t> m_sheets;
  std::vector<std::size_t> m_first_words; // of sheets, numbers in the following
  Words m_words;
};

/// Copies the entries above the diagonal to below it, in matrices of the same symmetric pattern.
///
/// Column by column, the entries of row \f$i\f$ are met in ascending order, and so are their
/// places in column \f$i\f$: it is enough to remember the last one.
inline void mirror_upper_half(const std::vector<Eigen::SparseMatrix<double>*>& matrices,
                              bool is_parallel) {
  if(matrices.empty())
    return;
  const int* const outer = matrices.front()->outerIndexPtr();
  const int* const inner = matrices.front()->innerIndexPtr();
  const std::size_t n = static_cast<std::size_t>(matrices.front()->cols());
  // few chunks, because each remembers a place for all rows
  const std::size_t grain = (std::max)(n / 16 + 1, std::size_t(1024));
  parallel_for(is_parallel, 0, n, grain, [&](std::size_t begin, std::size_t end) {
    std::vector<int> places(end, -1);
    for(std::size_t j = begin; j < end; ++j)
      for(int k = outer[j]; inner[k] < static_cast<int>(j); ++k) {
        const int i = inner[k];
        int& place = places[i];
        if(place < 0)
          place = static_cast<int>(
              std::lower_bound(inner + outer[i], inner + outer[i + 1], static_cast<int>(j)) -
              inner);
        for(Eigen::SparseMatrix<double>* matrix : matrices)
          matrix->valuePtr()[place] = matrix->valuePtr()[k];
        ++place;
      }
  });
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_INTERNAL_ELEMENT_MATRIX_PATTERN_H

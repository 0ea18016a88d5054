// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_INTERNAL_COLUMN_PANELS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_INTERNAL_COLUMN_PANELS_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/solvers/shared/block_vectors.h>
#include <CGAL/Restricted_laplacian_3/solvers/shared/panel_kernels.h>

#include <Eigen/Core>

#include <boost/align/aligned_allocator.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// number of columns of a panel: as many as a block has vectors
constexpr int panel_width = 8;

/// A matrix with many more rows than columns, in panels of eight columns, each stored row by row.
/// The columns that the last panel has too many are 0. What is done with panels takes less than two
/// thirds of the time of products of Eigen's matrices, unless the program is compiled for a
/// processor with vector registers of 256 bits: then it takes up to a third more (benchmark
/// `panels`).
template <class Number> class Column_panels {
public:
  Column_panels() = default;

  Column_panels(Eigen::Index rows, Eigen::Index columns) : m_rows(rows), m_columns(columns) {
    m_panels.resize(static_cast<std::size_t>((columns + panel_width - 1) / panel_width));
    for(auto& panel : m_panels)
      panel.assign(static_cast<std::size_t>(panel_width * rows), Number(0));
  }

  Eigen::Index rows() const { return m_rows; }
  Eigen::Index columns() const { return m_columns; }
  std::size_t number_of_panels() const { return m_panels.size(); }
  Number* panel(std::size_t i) { return m_panels[i].data(); }
  const Number* panel(std::size_t i) const { return m_panels[i].data(); }

  /// the numbers of a column, one in `panel_width`
  Number* column(Eigen::Index j) { return panel(j / panel_width) + j % panel_width; }
  const Number* column(Eigen::Index j) const { return panel(j / panel_width) + j % panel_width; }

  /// gives the memory of a panel back
  void release(std::size_t i) { Panel().swap(m_panels[i]); }

  /// gives the memory of the panels after the first `columns` columns back
  void keep_columns(Eigen::Index columns) {
    m_panels.resize(static_cast<std::size_t>((columns + panel_width - 1) / panel_width));
    m_columns = columns;
  }

private:
  using Panel = std::vector<Number, boost::alignment::aligned_allocator<Number, 64>>;

  Eigen::Index m_rows = 0, m_columns = 0;
  std::vector<Panel> m_panels;
};

/// a panel in double or in single precision; the other pointer is null
struct Panel_view {
  const double* doubles;
  const float* floats;
};

inline void add_views(const Column_panels<double>& x, std::vector<Panel_view>& views) {
  for(std::size_t i = 0; i < x.number_of_panels(); ++i)
    views.push_back({x.panel(i), nullptr});
}
inline void add_views(const Column_panels<float>& x, std::vector<Panel_view>& views) {
  for(std::size_t i = 0; i < x.number_of_panels(); ++i)
    views.push_back({nullptr, x.panel(i)});
}

/// The scalar products of the columns of the first `count` panels, rows of the result, with those
/// of `b` and of `c`. Rows are summed in a few parts, which are added in their order, so the result
/// is the same for any number of threads.
inline std::pair<Eigen::MatrixXd, Eigen::MatrixXd>
scalar_products(bool is_parallel, const std::vector<Panel_view>& panels, std::size_t count,
                const Block_vector<panel_width>& b, const Block_vector<panel_width>& c) {
  constexpr std::size_t number_of_parts = 16, rows_of_a_chunk = 256, block = 64;
  const std::size_t rows = static_cast<std::size_t>(b.rows());
  const std::size_t grain = rows / number_of_parts + 1;
  std::vector<std::vector<double>> sums((rows + grain - 1) / grain);
  parallel_for(is_parallel, 0, rows, grain, [&](std::size_t begin, std::size_t end) {
    std::vector<double>& own = sums[begin / grain];
    own.assign(2 * block * count, 0.);
    for(std::size_t row = begin; row < end; row += rows_of_a_chunk) {
      const std::size_t size = (std::min)(rows_of_a_chunk, end - row), place = panel_width * row;
      for(std::size_t i = 0; i < count; ++i)
        for(int which = 0; which < 2; ++which) {
          const double* const from = (which == 0 ? b.data() : c.data()) + place;
          double* const to = own.data() + block * (2 * i + which);
          if(panels[i].doubles)
            add_scalar_products(panels[i].doubles + place, from, size, to);
          else
            add_scalar_products(panels[i].floats + place, from, size, to);
        }
    }
  });
  using Block = Eigen::Matrix<double, panel_width, panel_width>;
  const Eigen::Index size = panel_width * static_cast<Eigen::Index>(count);
  std::pair<Eigen::MatrixXd, Eigen::MatrixXd> result(Eigen::MatrixXd::Zero(size, panel_width),
                                                     Eigen::MatrixXd::Zero(size, panel_width));
  for(const std::vector<double>& part : sums)
    for(std::size_t i = 0; i < count; ++i) {
      const Eigen::Index row = panel_width * static_cast<Eigen::Index>(i);
      const double* const from = part.data() + 2 * block * i;
      result.first.middleRows<panel_width>(row) += Eigen::Map<const Block>(from);
      result.second.middleRows<panel_width>(row) += Eigen::Map<const Block>(from + block);
    }
  return result;
}

/// Replaces the first columns of `x` by the product of the panels with the matrix `c`, and those of
/// `p` by that with `d`. Both may be among the panels. The matrices have a row for each column of
/// the panels, of which the ones that a panel has too many are 0.
inline void combine(bool is_parallel, const std::vector<Panel_view>& panels,
                    const Eigen::MatrixXd& c, Column_panels<double>& x, const Eigen::MatrixXd& d,
                    Column_panels<float>& p) {
  constexpr std::size_t rows_of_a_chunk = 128, chunk_size = panel_width * rows_of_a_chunk;
  const std::size_t rows = static_cast<std::size_t>(x.rows());
  // blocks of 8 x 8 coefficients, row by row, panel after panel for each eight columns of a matrix
  const auto blocks = [&panels](const Eigen::MatrixXd& a) {
    using Block = Eigen::Matrix<double, panel_width, panel_width, Eigen::RowMajor>;
    std::vector<double> result;
    for(Eigen::Index column = 0; column < a.cols(); column += panel_width)
      for(std::size_t i = 0; i < panels.size(); ++i) {
        const Eigen::Index width = (std::min)(a.cols() - column, Eigen::Index(panel_width));
        Block block = Block::Zero();
        block.leftCols(width) =
            a.block(panel_width * static_cast<Eigen::Index>(i), column, panel_width, width);
        result.insert(result.end(), block.data(), block.data() + block.size());
      }
    return result;
  };
  const std::vector<double> of_x = blocks(c), of_p = blocks(d);
  parallel_for(is_parallel, 0, rows, 16 * rows_of_a_chunk, [&](std::size_t begin, std::size_t end) {
    std::vector<double> old(chunk_size * panels.size()), sum(chunk_size);
    for(std::size_t row = begin; row < end; row += rows_of_a_chunk) {
      const std::size_t size = (std::min)(rows_of_a_chunk, end - row), place = panel_width * row,
                        count = panel_width * size;
      for(std::size_t i = 0; i < panels.size(); ++i)
        if(panels[i].doubles)
          std::copy_n(panels[i].doubles + place, count, old.data() + chunk_size * i);
        else
          std::copy_n(panels[i].floats + place, count, old.data() + chunk_size * i);
      const auto write = [&](const std::vector<double>& coefficients, auto& result) {
        const std::size_t written =
            coefficients.size() / (panel_width * panel_width * panels.size());
        for(std::size_t k = 0; k < written; ++k) {
          std::fill(sum.begin(), sum.end(), 0.);
          for(std::size_t i = 0; i < panels.size(); ++i)
            add_combination(old.data() + chunk_size * i,
                            coefficients.data() +
                                panel_width * panel_width * (k * panels.size() + i),
                            size, sum.data());
          std::copy_n(sum.data(), count, result.panel(k) + place);
        }
      };
      write(of_x, x);
      write(of_p, p);
    }
  });
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_INTERNAL_COLUMN_PANELS_H

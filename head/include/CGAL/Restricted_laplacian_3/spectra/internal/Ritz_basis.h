// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_INTERNAL_RITZ_BASIS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_INTERNAL_RITZ_BASIS_H

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/solvers/shared/Symmetric_matrix.h>
#include <CGAL/Restricted_laplacian_3/solvers/shared/block_vectors.h>
#include <CGAL/Restricted_laplacian_3/spectra/internal/Column_panels.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The vectors of LOBPCG on one level of a hierarchy after the other: the current ones, \f$X\f$,
/// corrections \f$W\f$ of some of them, and last changes \f$P\f$ of some of them. The vector of
/// \f$X\f$ that a column of \f$W\f$ or \f$P\f$ belongs to is its owner, given by its number.
///
/// The products \f$X^T S X\f$, \f$X^T S P\f$, ... of an update follow from those before it; only
/// \f$S W\f$ and \f$M W\f$ are formed. So they gather rounding errors, until `restart()`.
class Ritz_basis {
public:
  using Block = Block_vector<panel_width>;
  using Indices = std::vector<Eigen::Index>;

  /// The matrices \f$B^T S B\f$ and \f$B^T M B\f$ of a basis \f$B\f$, with those columns of
  /// \f$X\f$, \f$P\f$ and \f$W\f$, in this order, that take part.
  struct Projection {
    Eigen::MatrixXd s, m;
    /// where the columns are among those of all panels
    Indices places;
  };

  /// \param x the vectors on a level
  Ritz_basis(const Eigen::MatrixXd& x, bool is_parallel)
    : m_is_parallel(is_parallel), m_x(x.rows(), x.cols()) {
    for(Eigen::Index j = 0; j < x.cols(); ++j)
      for(Eigen::Index i = 0; i < x.rows(); ++i)
        m_x.column(j)[panel_width * i] = x(i, j);
  }

  /// number of unknowns of the level
  Eigen::Index rows() const { return m_x.rows(); }
  /// number of vectors
  Eigen::Index size() const { return m_x.columns(); }

  /// Writes the vectors in terms of the next finer level, whose matrices \f$S\f$ and \f$M\f$ are
  /// given.
  void prolongate(const Sparse_matrix& p, const Symmetric_matrices<2>& pencil) {
    restart();
    Column_panels<double> fine(p.rows(), m_x.columns());
    parallel_for(m_is_parallel, 0, m_x.number_of_panels(), 1, [&](std::size_t panel, std::size_t) {
      double* const to = fine.panel(panel);
      const double* const from = m_x.panel(panel);
      for(int j = 0; j < p.cols(); ++j)
        for(Sparse_matrix::InnerIterator i(p, j); i; ++i)
          for(int c = 0; c < panel_width; ++c)
            to[panel_width * i.row() + c] += i.value() * from[panel_width * j + c];
      m_x.release(panel);
    });
    m_x = std::move(fine);
    m_pencil = &pencil;
  }

  /// Copies up to `panel_width` vectors, from `first` on in a list of numbers; the others are 0.
  /// \return how many
  int gather(const Indices& numbers, std::size_t first, Block& x) const {
    const std::size_t count =
        (std::min)(numbers.size() - first, static_cast<std::size_t>(panel_width));
    x.setZero(m_x.rows(), panel_width);
    for(std::size_t c = 0; c < count; ++c) {
      const double* const from = m_x.column(numbers[first + c]);
      for(Eigen::Index i = 0; i < x.rows(); ++i)
        x(i, static_cast<Eigen::Index>(c)) = from[panel_width * i];
    }
    return static_cast<int>(count);
  }

  /// \f$S x\f$ and \f$M x\f$
  void multiply(const Block& x, Block& sx, Block& mx) const {
    m_pencil->multiply<panel_width>(x, {&sx, &mx}, m_is_parallel);
  }

  /// Gives \f$W\f$ up, and makes room for so many corrections.
  void start_corrections(std::size_t capacity) {
    m_w = Column_panels<float>();
    m_w = Column_panels<float>(m_x.rows(), static_cast<Eigen::Index>(capacity));
    m_owners_of_w.clear();
  }
  /// Adds column `c` of a block to \f$W\f$. Owners ascend.
  void add_correction(Eigen::Index owner, const Block& w, int c) {
    float* const to = m_w.column(static_cast<Eigen::Index>(m_owners_of_w.size()));
    for(Eigen::Index i = 0; i < w.rows(); ++i)
      to[panel_width * i] = static_cast<float>(w(i, c));
    m_owners_of_w.push_back(owner);
  }
  /// gives the room back that was not needed
  void end_corrections() { m_w.keep_columns(static_cast<Eigen::Index>(m_owners_of_w.size())); }
  /// owners of the columns of \f$W\f$, ascending
  const Indices& owners_of_corrections() const { return m_owners_of_w; }

  /// Adds the scalar products of a panel \f$B\f$ of \f$X\f$ with itself and those before it to
  /// the known products. Those of the panels before it are to be known, and no others.
  /// \param width number of columns of \f$B\f$ that count
  /// \param sb,mb \f$S B\f$ and \f$M B\f$
  void add_known_products(std::size_t panel, int width, const Block& sb, const Block& mb) {
    const Eigen::Index first = panel_width * static_cast<Eigen::Index>(panel), end = first + width;
    CGAL_precondition(m_known.s.cols() == first && end <= size());
    std::vector<Panel_view> panels;
    add_views(m_x, panels);
    const auto [of_s, of_m] = scalar_products(m_is_parallel, panels, panel + 1, sb, mb);
    m_known.s.conservativeResize(end, end);
    m_known.m.conservativeResize(end, end);
    m_known.s.rightCols(width) = of_s.topLeftCorner(end, width);
    m_known.m.rightCols(width) = of_m.topLeftCorner(end, width);
  }

  /// The largest cosine between two of the vectors with known products, for the scalar product of
  /// \f$S + \alpha M\f$ or \f$M\f$.
  double largest_cosine(double alpha) const {
    double largest = 0;
    for(const Eigen::MatrixXd& a : {Eigen::MatrixXd(m_known.s + alpha * m_known.m), m_known.m})
      for(Eigen::Index j = 0; j < a.cols(); ++j)
        for(Eigen::Index i = 0; i < j; ++i)
          largest = (std::max)(largest, std::abs(a(i, j)) / std::sqrt(a(i, i) * a(j, j)));
    return largest;
  }

  /// Gives \f$W\f$, \f$P\f$ and known products up.
  void restart() {
    m_w.keep_columns(0);
    m_p.keep_columns(0);
    m_owners_of_w.clear();
    m_owners_of_p.clear();
    m_known = Projection();
  }

  /// The projection to the span of \f$X\f$, \f$W\f$, and those columns of \f$P\f$ whose owners have
  /// a correction.
  Projection projection() const {
    const std::vector<Panel_view> panels = all_panels();
    Projection result;
    const Indices known = add_places_of_x_and_p(result.places);
    for(std::size_t c = 0; c < m_owners_of_w.size(); ++c)
      result.places.push_back(first_place_of_w() + static_cast<Eigen::Index>(c));
    const Eigen::Index n = static_cast<Eigen::Index>(result.places.size());
    result.s.resize(n, n);
    result.m.resize(n, n);
    // Without P there may be fewer of them than vectors.
    const Eigen::Index number_known =
        m_known.s.cols() < size() ? m_known.s.cols() : static_cast<Eigen::Index>(known.size());
    for(Eigen::Index j = 0; j < number_known; ++j)
      for(Eigen::Index i = 0; i <= j; ++i) {
        result.s(i, j) = m_known.s(known[i], known[j]);
        result.m(i, j) = m_known.m(known[i], known[j]);
      }
    add_products(panels, number_known, result);
    result.s.triangularView<Eigen::StrictlyLower>() = result.s.transpose();
    result.m.triangularView<Eigen::StrictlyLower>() = result.m.transpose();
    return result;
  }

  /// Sets \f$X\f$ to combinations of the basis, and \f$P\f$ to the part of some of them that does
  /// not lie in the old \f$X\f$.
  /// \param projection the latest one
  /// \param x coefficients, a column for each new vector
  /// \param owners of \f$P\f$, not more than there are corrections
  void update(const Projection& projection, const Eigen::MatrixXd& x, const Indices& owners) {
    const Eigen::Index nx = size(), np = static_cast<Eigen::Index>(owners.size());
    Eigen::MatrixXd next(x.rows(), nx + np);
    next.leftCols(nx) = x;
    for(Eigen::Index j = 0; j < np; ++j)
      next.col(nx + j) = x.col(owners[static_cast<std::size_t>(j)]);
    next.topRightCorner(nx, np).setZero();
    m_known.s = next.transpose() * (projection.s * next).eval();
    m_known.m = next.transpose() * (projection.m * next).eval();

    const std::vector<Panel_view> panels = all_panels();
    Eigen::MatrixXd coefficients =
        Eigen::MatrixXd::Zero(panel_width * static_cast<Eigen::Index>(panels.size()), nx + np);
    for(Eigen::Index i = 0; i < next.rows(); ++i)
      coefficients.row(projection.places[static_cast<std::size_t>(i)]) = next.row(i);
    // P takes the place of W, which has at least as many columns.
    combine(m_is_parallel, panels, coefficients.leftCols(nx), m_x, coefficients.rightCols(np), m_w);
    m_w.keep_columns(np);
    std::swap(m_p, m_w);
    m_w.keep_columns(0);
    m_owners_of_p = owners;
    m_owners_of_w.clear();
  }

  /// Moves the first vectors to columns of a matrix. Leaves the object empty.
  void take_vectors(const Indices& columns, Eigen::MatrixXd& result) {
    restart();
    result.resize(m_x.rows(), static_cast<Eigen::Index>(columns.size()));
    for(std::size_t j = 0; j < columns.size(); ++j) {
      const double* const from = m_x.column(static_cast<Eigen::Index>(j));
      for(Eigen::Index i = 0; i < m_x.rows(); ++i)
        result(i, columns[j]) = from[panel_width * i];
      if(j % panel_width == panel_width - 1)
        m_x.release(j / panel_width);
    }
    m_x = Column_panels<double>();
  }

private:
  std::vector<Panel_view> all_panels() const {
    std::vector<Panel_view> panels;
    add_views(m_x, panels);
    add_views(m_p, panels);
    add_views(m_w, panels);
    return panels;
  }
  Eigen::Index first_place_of_p() const {
    return panel_width * static_cast<Eigen::Index>(m_x.number_of_panels());
  }
  Eigen::Index first_place_of_w() const {
    return first_place_of_p() + panel_width * static_cast<Eigen::Index>(m_p.number_of_panels());
  }

  /// Adds the places of \f$X\f$ and of the columns of \f$P\f$ that take part.
  /// \return the numbers of these columns in the matrices of known products
  Indices add_places_of_x_and_p(Indices& places) const {
    Indices known;
    for(Eigen::Index i = 0; i < size(); ++i) {
      places.push_back(i);
      known.push_back(i);
    }
    for(std::size_t c = 0; c < m_owners_of_p.size(); ++c)
      if(std::binary_search(m_owners_of_w.begin(), m_owners_of_w.end(), m_owners_of_p[c])) {
        places.push_back(first_place_of_p() + static_cast<Eigen::Index>(c));
        known.push_back(size() + static_cast<Eigen::Index>(c));
      }
    return known;
  }

  /// Sets the upper halves of the columns of a projection from `first` on.
  void add_products(const std::vector<Panel_view>& panels, Eigen::Index first,
                    Projection& result) const {
    const auto place = [&result](Eigen::Index j) {
      return result.places[static_cast<std::size_t>(j)];
    };
    Block b(rows(), panel_width), sb, mb;
    for(Eigen::Index j = first; j < result.s.cols();) {
      const Eigen::Index number = place(j) / panel_width;
      const Panel_view panel = panels[static_cast<std::size_t>(number)];
      if(panel.doubles)
        std::copy_n(panel.doubles, b.size(), b.data());
      else
        std::copy_n(panel.floats, b.size(), b.data());
      multiply(b, sb, mb);
      const auto [of_s, of_m] =
          scalar_products(m_is_parallel, panels, static_cast<std::size_t>(number) + 1, sb, mb);
      for(; j < result.s.cols() && place(j) / panel_width == number; ++j)
        for(Eigen::Index i = 0; i <= j; ++i) {
          result.s(i, j) = of_s(place(i), place(j) % panel_width);
          result.m(i, j) = of_m(place(i), place(j) % panel_width);
        }
    }
  }

  bool m_is_parallel;
  const Symmetric_matrices<2>* m_pencil = nullptr;
  Column_panels<double> m_x;
  // in single precision: they only have to span a good space
  Column_panels<float> m_p, m_w;
  Indices m_owners_of_p, m_owners_of_w;
  // to the columns of X and P, or to the first columns of X; of these the upper halves
  Projection m_known;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_INTERNAL_RITZ_BASIS_H

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_SMOOTHER_ADAPTOR_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_SMOOTHER_ADAPTOR_H

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/solvers/Multigrid_levels.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/Level_vectors.h>

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Whether a smoother has a layout of its own, as `Group_smoother` has: `Multigrid` uses its
/// functions on `Level_vectors` then.
template <class Smoother, class = void> struct Has_layout : std::false_type {};
template <class Smoother>
struct Has_layout<Smoother, std::void_t<decltype(std::declval<const Smoother&>().positions())>>
  : std::true_type {};

/// Gives a model of `MultigridSmoother_3`, which works in double precision and in the numbering of
/// the matrix, the layout of a level: unknowns in their order, scaled to diagonals near 1. Keeps
/// the matrix, all of its entries, to which the smoother may refer.
template <class Smoother> class Smoother_adaptor {
public:
  /// takes the matrix over
  Smoother_adaptor(Sparse_matrix&& a, const Smoothing_patches& patches, bool is_parallel)
    : m_matrix(kept(a)), m_scale(balancing_scale(*m_matrix)),
      m_positions(Level_positions::consecutive(m_scale.size())),
      m_smoother(*m_matrix, patches, is_parallel) {}

  const Smoother& smoother() const { return m_smoother; }
  const Level_positions& positions() const { return m_positions; }
  const std::vector<double>& scale() const { return m_scale; }

  template <int K>
  void pre_smooth(const Level_vectors<K>& b, Level_vectors<K>& x, Level_vectors<K>& r,
                  int steps) const {
    const Eigen::MatrixXd load = read<K>(b, true);
    Eigen::MatrixXd solution = Eigen::MatrixXd::Zero(load.rows(), K);
    for(int step = 0; step < steps; ++step)
      m_smoother.smooth(load, solution);
    write<K>(solution, false, x);
    write<K>(load - *m_matrix * solution, true, r);
  }

  template <int K>
  void post_smooth(const Level_vectors<K>& b, Level_vectors<K>& x, int steps) const {
    const Eigen::MatrixXd load = read<K>(b, true);
    Eigen::MatrixXd solution = read<K>(x, false);
    for(int step = 0; step < steps; ++step)
      m_smoother.smooth_transposed(load, solution);
    write<K>(solution, false, x);
  }

  template <int K>
  void residual(const Level_vectors<K>& b, const Level_vectors<K>& x, Level_vectors<K>& r) const {
    write<K>(read<K>(b, true) - *m_matrix * read<K>(x, false), true, r);
  }

private:
  // A SparseMatrix of Eigen 3.4 is copied where another class would be moved.
  static std::shared_ptr<const Sparse_matrix> kept(Sparse_matrix& a) {
    const auto result = std::make_shared<Sparse_matrix>();
    result->swap(a);
    return result;
  }

  /// Loads of the level belong to \f$D b\f$, solutions to \f$D^{-1} x\f$.
  template <int K> Eigen::MatrixXd read(const Level_vectors<K>& from, bool is_load) const {
    Eigen::MatrixXd result(static_cast<Eigen::Index>(m_scale.size()), K);
    for(Eigen::Index i = 0; i < result.rows(); ++i)
      for(int c = 0; c < K; ++c)
        result(i, c) = from.position(i)[c] * (is_load ? 1 / m_scale[i] : m_scale[i]);
    return result;
  }

  template <int K>
  void write(const Eigen::MatrixXd& from, bool is_load, Level_vectors<K>& to) const {
    to.set_zero(m_positions.number_of_positions);
    for(Eigen::Index i = 0; i < from.rows(); ++i)
      for(int c = 0; c < K; ++c)
        to.position(i)[c] =
            static_cast<float>(from(i, c) * (is_load ? m_scale[i] : 1 / m_scale[i]));
  }

  std::shared_ptr<const Sparse_matrix> m_matrix;
  std::vector<double> m_scale;
  Level_positions m_positions;
  Smoother m_smoother;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_SMOOTHER_ADAPTOR_H

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SMOOTHERS_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SMOOTHERS_IMPL_H

#include <CGAL/Restricted_laplacian_3/solvers/smoothers.h>

#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/Gauss_seidel_groups.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/Patch_groups.h>

#include <CGAL/assertions.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

template <class Implementation>
const Level_positions& Group_smoother<Implementation>::positions() const {
  return m_implementation->positions;
}

template <class Implementation>
const std::vector<double>& Group_smoother<Implementation>::scale() const {
  return m_implementation->scale;
}

template <class Implementation>
template <int K>
void Group_smoother<Implementation>::pre_smooth(const Level_vectors<K>& b, Level_vectors<K>& x,
                                                Level_vectors<K>& r, int steps) const {
  x.set_zero(positions().number_of_positions);
  for(int step = 0; step < steps; ++step)
    sweep<K>(b, x, false);
  residual<K>(b, x, r);
}

template <class Implementation>
template <int K>
void Group_smoother<Implementation>::post_smooth(const Level_vectors<K>& b, Level_vectors<K>& x,
                                                 int steps) const {
  for(int step = 0; step < steps; ++step)
    sweep<K>(b, x, true);
}

template <class Implementation>
template <int K>
void Group_smoother<Implementation>::residual(const Level_vectors<K>& b, const Level_vectors<K>& x,
                                              Level_vectors<K>& r) const {
  m_implementation->template residual<K>(b, x, r);
}

template <class Implementation>
std::size_t Group_smoother<Implementation>::number_of_colors() const {
  return m_implementation->colors.size() - 1;
}

template <class Implementation>
template <int K>
void Group_smoother<Implementation>::relax_color(std::size_t color, const Level_vectors<K>& b,
                                                 Level_vectors<K>& x, bool is_reversed) const {
  const std::vector<std::uint32_t>& colors = m_implementation->colors;
  parallel_for(m_implementation->is_parallel, colors[color], colors[color + 1], 1,
               [&](std::size_t group, std::size_t) {
                 m_implementation->template relax_group<K>(group, b, x, is_reversed);
               });
}

template <class Implementation>
template <int K>
void Group_smoother<Implementation>::sweep(const Level_vectors<K>& b, Level_vectors<K>& x,
                                           bool is_reversed) const {
  for(std::size_t i = 0; i < number_of_colors(); ++i)
    relax_color<K>(is_reversed ? number_of_colors() - 1 - i : i, b, x, is_reversed);
}

template <class Implementation>
void Group_smoother<Implementation>::smooth(const Eigen::MatrixXd& b, Eigen::MatrixXd& x) const {
  correct(b, x, false);
}

template <class Implementation>
void Group_smoother<Implementation>::smooth_transposed(const Eigen::MatrixXd& b,
                                                       Eigen::MatrixXd& x) const {
  correct(b, x, true);
}

template <class Implementation>
void Group_smoother<Implementation>::correct(const Eigen::MatrixXd& b, Eigen::MatrixXd& x,
                                             bool is_reversed) const {
  const std::vector<double>& d = scale();
  const std::vector<std::uint32_t>& position = positions().of_unknown;
  CGAL_precondition(b.rows() == static_cast<Eigen::Index>(d.size()) && b.rows() == x.rows() &&
                    b.cols() == x.cols());
  const Eigen::Map<const Eigen::ArrayXd> scale(d.data(), b.rows());
  Level_vectors<1> load, solution;
  for(Eigen::Index column = 0; column < b.cols(); ++column) {
    // near to 1, so that single precision holds them
    const double unit = b.rows() > 0 ? (std::max)((scale * b.col(column).array()).abs().maxCoeff(),
                                                  (x.col(column).array() / scale).abs().maxCoeff())
                                     : 0;
    if(!(unit > 0))
      continue;
    load.set_zero(positions().number_of_positions);
    solution.set_zero(positions().number_of_positions);
    for(std::size_t i = 0; i < d.size(); ++i) {
      const Eigen::Index row = static_cast<Eigen::Index>(i);
      *load.position(position[i]) = static_cast<float>(b(row, column) * d[i] / unit);
      *solution.position(position[i]) = static_cast<float>(x(row, column) / d[i] / unit);
    }
    sweep<1>(load, solution, is_reversed);
    for(std::size_t i = 0; i < d.size(); ++i)
      x(static_cast<Eigen::Index>(i), column) = *solution.position(position[i]) * d[i] * unit;
  }
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Gauss_seidel_smoother::Gauss_seidel_smoother(const Sparse_matrix& a,
                                             const Smoothing_patches& patches, bool is_parallel)
  : Group_smoother(std::make_shared<const internal::Gauss_seidel_groups>(a, patches, is_parallel)) {
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Patch_smoother::Patch_smoother(const Sparse_matrix& a, const Smoothing_patches& patches,
                               bool is_parallel)
  : Group_smoother(std::make_shared<const internal::Patch_groups>(a, patches, is_parallel)) {}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SMOOTHERS_IMPL_H

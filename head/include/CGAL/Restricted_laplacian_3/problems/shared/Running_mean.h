// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SHARED_RUNNING_MEAN_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SHARED_RUNNING_MEAN_H

#include <Eigen/Core>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Mean and standard error of the mean of arrays that come one after the other.
class Running_mean {
public:
  template <class Array> void add(const Array& values) {
    if(m_count++ == 0) {
      m_mean = Eigen::ArrayXd::Zero(values.size());
      m_squares = Eigen::ArrayXd::Zero(values.size());
    }
    const Eigen::ArrayXd change = values - m_mean;
    m_mean += change / m_count;
    m_squares += change * (values - m_mean);
  }

  const Eigen::ArrayXd& mean() const { return m_mean; }
  Eigen::ArrayXd standard_error() const { return (m_squares / (m_count - 1.) / m_count).sqrt(); }

private:
  int m_count = 0;
  Eigen::ArrayXd m_mean, m_squares; // sums of squared differences to the mean
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SHARED_RUNNING_MEAN_H

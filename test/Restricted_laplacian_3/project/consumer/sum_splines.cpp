// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Restricted_laplacian_3/basis/Tensor_basis_3.h>
#include <CGAL/Simple_cartesian.h>

#include <Eigen/SparseCore>

#include <cmath>
#include <numeric>

int main() {
  using CGAL::Restricted_laplacian_3::Tensor_basis_3;
  const auto values = Tensor_basis_3::values({0.25, 0.5, 1});
  return std::abs(std::accumulate(values.begin(), values.end(), -1.)) < 1e-15 ? 0 : 1;
}

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_INTERNAL_PADDED_RULE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_INTERNAL_PADDED_RULE_H

#include <CGAL/Restricted_laplacian_3/integration/triangle_quadrature.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// A cubature rule array by array, with weights 0 after the last node up to a multiple of four.
struct Padded_rule {
  std::size_t size;
  std::vector<double> b0, b1, b2, weight;

  explicit Padded_rule(const std::vector<Triangle_quadrature_node>& nodes)
    : size(nodes.size()), b0((size + 3) / 4 * 4), b1(b0.size()), b2(b0.size()), weight(b0.size()) {
    for(std::size_t i = 0; i < size; ++i) {
      b0[i] = nodes[i].b0;
      b1[i] = nodes[i].b1;
      b2[i] = nodes[i].b2;
      weight[i] = nodes[i].weight;
    }
  }

  /// number of nodes with those of weight 0
  std::size_t padded_size() const { return b0.size(); }

  /// that of `triangle_quadrature()`
  static const Padded_rule& of_degree(int degree) {
    static const std::vector<Padded_rule> rules = [] {
      std::vector<Padded_rule> result;
      for(int degree = 0; degree <= 12; ++degree)
        result.emplace_back(triangle_quadrature(degree));
      return result;
    }();
    if(degree < 0 || degree >= static_cast<int>(rules.size()))
      static_cast<void>(triangle_quadrature(degree)); // throws
    return rules[static_cast<std::size_t>(degree)];
  }
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_INTERNAL_PADDED_RULE_H

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_SHARED_LINE_RULE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_SHARED_LINE_RULE_H

#include <array>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// a node of a rule on \f$[-1, 1]\f$
struct Line_node {
  double place, weight;
};

/// The rule of Gauss with 7 nodes, exact up to degree 13: the numbers of Boost.Math, whose header
/// takes seconds to compile.
constexpr std::array<Line_node, 7> line_rule = {{{0, 0.4179591836734694},
                                                 {0.40584515137739718, 0.38183005050511892},
                                                 {-0.40584515137739718, 0.38183005050511892},
                                                 {0.74153118559939446, 0.27970539148927664},
                                                 {-0.74153118559939446, 0.27970539148927664},
                                                 {0.94910791234275849, 0.1294849661688697},
                                                 {-0.94910791234275849, 0.1294849661688697}}};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_SHARED_LINE_RULE_H

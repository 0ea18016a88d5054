// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_INTERNAL_LABELLING_H
#define CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_INTERNAL_LABELLING_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>

#include <boost/range/iterator_range_core.hpp>

#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Labels for the vertices of a graph that make a sum small: of the cost of the label of each
/// vertex, and of the costs of the edges whose ends have different labels. With two labels it is
/// the smallest one; with more, no expansion of one label makes it smaller (Y. Boykov, O. Veksler,
/// R. Zabih, *Fast approximate energy minimization via graph cuts*, IEEE Trans. Pattern Anal. Mach.
/// Intell. 23, 2001).
///
/// \cgal's expansions take seconds for 10^5 vertices. So they are left the vertices at which edges
/// matter, one connected part after the other, each with the labels that matter there.
class Labelling {
public:
  struct Edge {
    std::uint32_t i, j;
    double cost; // not negative
  };

  /// \param costs for each vertex those of all labels; infinite for labels that it must not have,
  /// which are not all
  Labelling(std::vector<std::vector<double>> costs, std::vector<Edge> edges);

  /// of the vertices
  const std::vector<std::uint32_t>& labels() const { return m_labels; }

private:
  using Numbers = boost::iterator_range<const std::uint32_t*>;

  static constexpr std::uint32_t undecided = (std::numeric_limits<std::uint32_t>::max)();

  /// the sums of the costs of the edges of each vertex
  std::vector<double> costs_of_edges() const;

  /// A label that is worse than the best one by all that the edges of a vertex can cost need not be
  /// considered: decides the vertices for which only the best one is left. They leave the graph;
  /// the costs of their edges are added to those of the other ends.
  /// \return whether there were such vertices
  bool decide();

  /// decides a connected part
  /// \param numbers of the vertices in the part; for use here only
  void cut(const Numbers& vertices, const Numbers& edges, const std::vector<double>& around,
           std::vector<std::uint32_t>& numbers);

  // those that are not decided, their costs, and the edges between them
  std::vector<std::vector<double>> m_costs;
  std::vector<Edge> m_edges;
  std::vector<std::uint32_t> m_vertices;
  std::vector<std::uint32_t> m_labels; // of all vertices
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/textures/internal/Labelling_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_INTERNAL_LABELLING_H

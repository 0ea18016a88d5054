// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_INTERNAL_LABELLING_H
#define CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_INTERNAL_LABELLING_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Disjoint_sets.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Number_lists.h>

#include <CGAL/property_map.h>

// GCC does not see that the maximal flow of Boost sets the edge that it reads.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <CGAL/boost/graph/alpha_expansion_graphcut.h>
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

#include <boost/graph/adjacency_list.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
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
  Labelling(std::vector<std::vector<double>> costs, std::vector<Edge> edges)
    : m_costs(std::move(costs)), m_edges(std::move(edges)), m_vertices(m_costs.size()),
      m_labels(m_costs.size(), undecided) {
    std::iota(m_vertices.begin(), m_vertices.end(), 0u);
    while(decide()) {
    }
    Disjoint_sets parts(m_vertices.size());
    for(const Edge& edge : m_edges)
      parts.unite(edge.i, edge.j);
    const std::size_t n = m_vertices.size();
    const Number_lists vertices = Number_lists::by_key(
                           n, n, [&](std::size_t i) { return parts.find(std::uint32_t(i)); }),
                       edges_of_parts =
                           Number_lists::by_key(n, m_edges.size(), [&](std::size_t edge) {
                             return parts.find(m_edges[edge].i);
                           });
    const std::vector<double> around = costs_of_edges();
    std::vector<std::uint32_t> numbers(n);
    for(std::size_t part = 0; part < n; ++part)
      if(!vertices[part].empty())
        cut(vertices[part], edges_of_parts[part], around, numbers);
  }

  /// of the vertices
  const std::vector<std::uint32_t>& labels() const { return m_labels; }

private:
  static constexpr std::uint32_t undecided = (std::numeric_limits<std::uint32_t>::max)();

  /// the sums of the costs of the edges of each vertex
  std::vector<double> costs_of_edges() const {
    std::vector<double> result(m_vertices.size(), 0);
    for(const auto& [i, j, cost] : m_edges) {
      result[i] += cost;
      result[j] += cost;
    }
    return result;
  }

  /// A label that is worse than the best one by all that the edges of a vertex can cost need not be
  /// considered: decides the vertices for which only the best one is left. They leave the graph;
  /// the costs of their edges are added to those of the other ends.
  /// \return whether there were such vertices
  bool decide() {
    const std::vector<double> around = costs_of_edges();
    std::vector<std::uint32_t> numbers(m_vertices.size(), undecided);
    std::uint32_t next = 0;
    for(std::size_t i = 0; i < m_vertices.size(); ++i) {
      const auto best = std::min_element(m_costs[i].begin(), m_costs[i].end());
      const double limit = *best + around[i];
      if(std::count_if(m_costs[i].begin(), m_costs[i].end(),
                       [&](double cost) { return cost < limit; }) > 1)
        numbers[i] = next++;
      else
        m_labels[m_vertices[i]] = static_cast<std::uint32_t>(best - m_costs[i].begin());
    }
    std::vector<Edge> edges;
    for(auto [i, j, cost] : m_edges) {
      if(numbers[i] == undecided)
        std::swap(i, j);
      if(numbers[j] != undecided)
        edges.push_back({numbers[i], numbers[j], cost});
      else if(numbers[i] != undecided)
        for(std::size_t label = 0; label < m_costs[i].size(); ++label)
          m_costs[i][label] += label == m_labels[m_vertices[j]] ? 0 : cost;
    }
    m_edges.swap(edges);
    for(std::size_t i = 0; i < numbers.size(); ++i)
      if(numbers[i] != undecided) {
        m_vertices[numbers[i]] = m_vertices[i];
        m_costs[numbers[i]].swap(m_costs[i]);
      }
    m_vertices.resize(next);
    m_costs.resize(next);
    return next < numbers.size();
  }

  /// decides a connected part
  /// \param numbers of the vertices in the part; for use here only
  template <class Range>
  void cut(const Range& vertices, const Range& edges, const std::vector<double>& around,
           std::vector<std::uint32_t>& numbers) {
    const std::size_t size = m_costs[*vertices.begin()].size();
    std::vector<char> matters(size, 0);
    for(std::uint32_t i : vertices) {
      const double limit = *std::min_element(m_costs[i].begin(), m_costs[i].end()) + around[i];
      for(std::size_t label = 0; label < size; ++label)
        matters[label] |= m_costs[i][label] < limit;
    }
    boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, boost::no_property,
                          boost::property<boost::edge_weight_t, double>>
        graph(vertices.size());
    std::vector<std::vector<double>> costs;
    std::vector<std::size_t> labels;
    for(std::uint32_t i : vertices) {
      numbers[i] = static_cast<std::uint32_t>(costs.size());
      costs.emplace_back();
      for(std::size_t label = 0; label < size; ++label)
        if(matters[label])
          costs.back().push_back(m_costs[i][label]);
      const auto best = std::min_element(costs.back().begin(), costs.back().end());
      labels.push_back(static_cast<std::size_t>(best - costs.back().begin()));
      const double largest = *best + 2 * around[i] + 1; // no expansion gains as much
      for(double& cost : costs.back())
        cost = (std::min)(cost, largest);
    }
    for(std::uint32_t edge : edges)
      boost::add_edge(numbers[m_edges[edge].i], numbers[m_edges[edge].j], m_edges[edge].cost,
                      graph);
    CGAL::alpha_expansion_graphcut(
        graph, get(boost::edge_weight, graph), CGAL::make_property_map(costs),
        CGAL::make_property_map(labels),
        CGAL::parameters::vertex_index_map(get(boost::vertex_index, graph)));
    std::vector<std::uint32_t> names;
    for(std::uint32_t label = 0; label < size; ++label)
      if(matters[label])
        names.push_back(label);
    for(std::uint32_t i : vertices)
      m_labels[m_vertices[i]] = names[labels[numbers[i]]];
  }

  // those that are not decided, their costs, and the edges between them
  std::vector<std::vector<double>> m_costs;
  std::vector<Edge> m_edges;
  std::vector<std::uint32_t> m_vertices;
  std::vector<std::uint32_t> m_labels; // of all vertices
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_INTERNAL_LABELLING_H

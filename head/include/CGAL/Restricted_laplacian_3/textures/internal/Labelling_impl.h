// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_INTERNAL_LABELLING_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_INTERNAL_LABELLING_IMPL_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Disjoint_sets.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Number_lists.h>
#include <CGAL/Restricted_laplacian_3/textures/internal/Labelling.h>

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
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Labelling::Labelling(std::vector<std::vector<double>> costs,
                                                        std::vector<Edge> edges)
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

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<double> Labelling::costs_of_edges() const {
  std::vector<double> result(m_vertices.size(), 0);
  for(const auto& [i, j, cost] : m_edges) {
    result[i] += cost;
    result[j] += cost;
  }
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE bool Labelling::decide() {
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

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void Labelling::cut(const Numbers& vertices,
                                                       const Numbers& edges,
                                                       const std::vector<double>& around,
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
    boost::add_edge(numbers[m_edges[edge].i], numbers[m_edges[edge].j], m_edges[edge].cost, graph);
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

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_INTERNAL_LABELLING_IMPL_H

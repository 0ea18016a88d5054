// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_NEAREST_POINTS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_NEAREST_POINTS_H

#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>

#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/property_map.h>

#include <boost/iterator/counting_iterator.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The points nearest to each point of a set. May be asked from several threads at once.
class Nearest_points {
  using Map = CGAL::Pointer_property_map<Point_3>::const_type;
  using Base = CGAL::Search_traits_3<Double_kernel>;
  using Traits = CGAL::Search_traits_adapter<std::size_t, Map, Base>;
  using Search = CGAL::Orthogonal_k_neighbor_search<Traits>;

public:
  /// \param points must outlive this object
  explicit Nearest_points(const std::vector<Point_3>& points)
    : m_points(points), m_map(CGAL::make_property_map(points)),
      m_tree(Counter(0), Counter(points.size()), typename Search::Tree::Splitter(), Traits(m_map)) {
    m_tree.build();
  }

  /// The `k` points, or all others if there are fewer, that are nearest to point `i`, without it:
  /// nearest first, of equally near ones that of the lowest number.
  void find(std::size_t i, std::size_t k, std::vector<std::uint32_t>& nearest) const {
    const Search search(m_tree, m_points[i], static_cast<unsigned int>(k + 1), 0, true,
                        typename Search::Distance(m_map));
    std::vector<std::pair<double, std::uint32_t>> found;
    for(const auto& neighbor : search)
      if(neighbor.first != i)
        found.emplace_back(neighbor.second, static_cast<std::uint32_t>(neighbor.first));
    std::sort(found.begin(), found.end());
    found.resize((std::min)(found.size(), k)); // more points than k + 1 may be the same
    nearest.clear();
    for(const auto& neighbor : found)
      nearest.push_back(neighbor.second);
  }

  /// the point nearest to any location
  std::size_t nearest_to(const Point_3& location) const {
    const Search search(m_tree, location, 1, 0, true, typename Search::Distance(m_map));
    return search.begin()->first;
  }

private:
  using Counter = boost::counting_iterator<std::size_t>;

  const std::vector<Point_3>& m_points;
  Map m_map;
  typename Search::Tree m_tree;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_NEAREST_POINTS_H

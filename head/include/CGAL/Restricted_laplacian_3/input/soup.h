// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INPUT_SOUP_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INPUT_SOUP_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>

#include <boost/iterator/counting_iterator.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

template <class Range>
using Range_value =
    typename std::iterator_traits<decltype(std::begin(std::declval<const Range&>()))>::value_type;

template <class Range> std::size_t size_of_range(const Range& range) {
  return static_cast<std::size_t>(std::distance(std::begin(range), std::end(range)));
}

/// Points and polygons: references to those of a caller, or values if they are temporary.
template <class PointRange, class PolygonRange> class Polygon_soup {
public:
  Polygon_soup(PointRange&& points, PolygonRange&& polygons)
    : m_points(std::forward<PointRange>(points)), m_polygons(std::forward<PolygonRange>(polygons)) {
  }

  const std::remove_reference_t<PointRange>& points() const { return m_points; }
  const std::remove_reference_t<PolygonRange>& polygons() const { return m_polygons; }

private:
  PointRange m_points;
  PolygonRange m_polygons;
};

/// reads the elements of a range with random access, by their positions
template <class Range> class Range_map {
public:
  using key_type = std::size_t;
  using value_type = Range_value<Range>;
  using reference = value_type;
  using category = boost::readable_property_map_tag;

  explicit Range_map(const Range& range) : m_begin(std::begin(range)) {}

  friend value_type get(const Range_map& map, std::size_t i) {
    return map.m_begin[static_cast<std::ptrdiff_t>(i)];
  }

private:
  decltype(std::begin(std::declval<const Range&>())) m_begin;
};

/// Points and normals, kept as by a soup: the range of their positions, with the maps that a
/// `CGAL::Point_set_3` has.
template <class PointRange, class NormalRange> class Oriented_points {
public:
  using const_iterator = boost::counting_iterator<std::size_t>;
  using iterator = const_iterator;

  Oriented_points(PointRange&& points, NormalRange&& normals)
    : m_points(std::forward<PointRange>(points)), m_normals(std::forward<NormalRange>(normals)) {
    const std::size_t size = size_of_range(m_points), number = size_of_range(m_normals);
    if(number != size)
      throw Parameter_error("normals", "are " + std::to_string(number) + ", but there are " +
                                           std::to_string(size) + " points");
  }

  const_iterator begin() const { return const_iterator(0); }
  const_iterator end() const { return const_iterator(size_of_range(m_points)); }

  auto point_map() const { return Range_map<std::remove_reference_t<PointRange>>(m_points); }
  auto normal_map() const { return Range_map<std::remove_reference_t<NormalRange>>(m_normals); }
  bool has_normal_map() const { return true; }

private:
  PointRange m_points;
  NormalRange m_normals;
};

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Functions
/// A polygon soup as a surface, which need not be a manifold, nor orientable: a model of
/// `RestrictedSurface_3`. Keys of property maps are the indices of the points, `std::size_t`.
///
/// Polygons are divided into triangles. Two of these are joined if they have two indices in common,
/// any number of them at one edge.
/// \param points a range of 3D points; the caller keeps it while the result is in use, unless it is
/// temporary
/// \param polygons a range of ranges of at least three indices into `points`, each of any integer
/// type; kept likewise
template <class PointRange, class PolygonRange>
internal::Polygon_soup<PointRange, PolygonRange> soup(PointRange&& points,
                                                      PolygonRange&& polygons) {
  return {std::forward<PointRange>(points), std::forward<PolygonRange>(polygons)};
}

/// \ingroup PkgRestrictedLaplacian3Functions
/// Oriented points as a surface without any mesh: a model of `RestrictedSurface_3`. Keys of
/// property maps are the positions of the points, `std::size_t`.
///
/// Which side the normals point to does not matter, except for `estimate_point_areas()` and
/// `split(true)`, which need them to be oriented alike.
/// \param points a range of 3D points with random access; the caller keeps it while the result is
/// in use, unless it is temporary
/// \param normals a range of as many 3D vectors with random access, of any length but 0; kept
/// likewise
/// \throws Parameter_error there are not as many normals as points
template <class PointRange, class NormalRange>
internal::Oriented_points<PointRange, NormalRange> point_set(PointRange&& points,
                                                             NormalRange&& normals) {
  return {std::forward<PointRange>(points), std::forward<NormalRange>(normals)};
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INPUT_SOUP_H

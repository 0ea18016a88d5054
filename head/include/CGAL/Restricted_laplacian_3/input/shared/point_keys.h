// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INPUT_SHARED_POINT_KEYS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INPUT_SHARED_POINT_KEYS_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/input/soup.h>

#include <CGAL/property_map.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

template <class Point, class Vector> class Point_set_3;

namespace Restricted_laplacian_3 {
namespace internal {

/// tells property maps from named parameters, options and function objects
template <class T>
using Require_property_map =
    std::enable_if_t<!Is_named_parameters<T>::value &&
                         !std::is_same_v<typename boost::property_traits<T>::category, void>,
                     int>;

/// ranges that know points and normals of their elements
template <class T> struct Is_point_set : std::false_type {};
template <class Point, class Vector>
struct Is_point_set<CGAL::Point_set_3<Point, Vector>> : std::true_type {};
template <class PointRange, class NormalRange>
struct Is_point_set<Oriented_points<PointRange, NormalRange>> : std::true_type {};

/// A point of a range as the key of property maps: its element in the range, as in all of CGAL; or
/// its position, counted from 0, for maps that do not take the element.
template <class Element> struct Point_key {
  const Element& element;
  std::size_t position;

  template <class Map> decltype(auto) of() const {
    using Key = typename boost::property_traits<Map>::key_type;
    if constexpr(std::is_convertible_v<const Element&, Key>)
      return (element);
    else
      return static_cast<Key>(position);
  }
};

/// calls `visit(key)` for all points of a range, in their order
template <class PointRange, class Visitor>
void for_each_point_key(const PointRange& points, Visitor&& visit) {
  using Element = Range_value<PointRange>;
  std::size_t position = 0;
  for(const Element& element : points)
    visit(Point_key<Element>{element, position++});
}

/// the value of a property map, also for a `Point_key`
template <class Map, class Key> decltype(auto) value_at(const Map& map, const Key& key) {
  return get(map, key);
}
template <class Map, class Element>
decltype(auto) value_at(const Map& map, const Point_key<Element>& key) {
  return get(map, key.template of<Map>());
}

/// writes a value to a property map, also for a `Point_key`
template <class Map, class Key, class Value>
void put_value_at(const Map& map, const Key& key, const Value& value) {
  put(map, key, value);
}
template <class Map, class Element, class Value>
void put_value_at(const Map& map, const Point_key<Element>& key, const Value& value) {
  put(map, key.template of<Map>(), value);
}

/// the value of `point_map`; by default that of a point set, or the elements themselves
template <class PointRange, class NamedParameters>
auto point_map_of(const PointRange& points, const NamedParameters& np) {
  if constexpr(is_given_v<NamedParameters, internal_np::point_t>)
    return parameters::get_parameter(np, internal_np::point_map);
  else if constexpr(Is_point_set<PointRange>::value)
    return points.point_map();
  else
    return CGAL::Identity_property_map<Range_value<PointRange>>();
}

/// the value of `normal_map`; by default that of a point set
template <class PointRange, class NamedParameters>
auto normal_map_of(const PointRange& points, const NamedParameters& np) {
  constexpr bool is_given = is_given_v<NamedParameters, internal_np::normal_t>;
  static_assert(is_given || Is_point_set<PointRange>::value,
                "A range of points needs the named parameter normal_map; or see point_set().");
  if constexpr(is_given)
    return parameters::get_parameter(np, internal_np::normal_map);
  else {
    if(!points.has_normal_map())
      throw Input_error("the point set has no normals");
    return points.normal_map();
  }
}

} // namespace internal

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INPUT_SHARED_POINT_KEYS_H

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INPUT_READ_POINT_SET_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INPUT_READ_POINT_SET_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/input/point_areas.h>
#include <CGAL/Restricted_laplacian_3/input/read_surface.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/coordinates.h>

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

template <class T> struct Is_point_set_3 : std::false_type {};
template <class Point, class Vector>
struct Is_point_set_3<CGAL::Point_set_3<Point, Vector>> : std::true_type {};

template <class PointRange>
using Point_range_value =
    typename std::iterator_traits<decltype(std::begin(std::declval<PointRange&>()))>::value_type;

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
  using Element = Point_range_value<const PointRange>;
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

/// the value of `point_map`; by default that of a `CGAL::Point_set_3`, or the elements themselves
template <class PointRange, class NamedParameters>
auto point_map_of(const PointRange& points, const NamedParameters& np) {
  if constexpr(is_given_v<NamedParameters, internal_np::point_t>)
    return parameters::get_parameter(np, internal_np::point_map);
  else if constexpr(Is_point_set_3<PointRange>::value)
    return points.point_map();
  else
    return CGAL::Identity_property_map<Point_range_value<const PointRange>>();
}

/// the value of `normal_map`; by default that of a `CGAL::Point_set_3`
template <class PointRange, class NamedParameters>
auto normal_map_of(const PointRange& points, const NamedParameters& np) {
  constexpr bool is_given = is_given_v<NamedParameters, internal_np::normal_t>;
  static_assert(is_given || Is_point_set_3<PointRange>::value,
                "A range of points needs the named parameter normal_map.");
  if constexpr(is_given)
    return parameters::get_parameter(np, internal_np::normal_map);
  else {
    if(!points.has_normal_map())
      throw Input_error("the point set has no normals");
    return points.normal_map();
  }
}

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Functions
/// Reads a set of oriented points, which stands for a surface without any mesh. Vertices and faces
/// of the surface are the points, numbered in the order of the range.
///
/// \tparam PointRange a model of `ConstRange`, for example `CGAL::Point_set_3` or a vector of pairs
/// of a point and a vector
/// \param points the points, or things that property maps know points and normals of
/// \param np optional named parameters; the keys of property maps are the elements of the range, or
/// their positions, counted from 0, if a map does not take elements:
/// \cgalNamedParamsBegin
///   \named_of_points
///   \named_geom_traits
///   \named_concurrency_tag
/// \cgalNamedParamsEnd
/// Which side the normals point to does not matter, except for `estimate_point_areas()` and
/// `split(true)`, which need them to be oriented alike.
/// \throws Empty_surface_error, Invalid_point_error, Zero_area_error
/// \throws Parameter_error the number of neighbors or the extent is outside its domain
/// \throws Input_error a `CGAL::Point_set_3` has no normals
template <class PointRange, class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0>
Triangulated_surface_3 read_point_set(const PointRange& points,
                                      const NamedParameters& np = parameters::default_values()) {
  const auto point_map = internal::point_map_of(points, np);
  const auto normal_map = internal::normal_map_of(points, np);
  constexpr bool has_areas = internal::is_given_v<NamedParameters, internal_np::area_map_t>;
  const auto area_map = parameters::get_parameter(np, internal_np::area_map);
  const auto traits = internal::geom_traits_of(np);

  std::vector<Point_3> own_points;
  std::vector<Vector_3> normals;
  std::vector<double> areas;
  internal::for_each_point_key(points, [&](const auto& key) {
    own_points.push_back(
        internal::with_coordinates_of<Point_3>(internal::value_at(point_map, key), traits));
    normals.push_back(
        internal::with_coordinates_of<Vector_3>(internal::value_at(normal_map, key), traits));
    if constexpr(has_areas)
      areas.push_back(CGAL::to_double(internal::value_at(area_map, key)));
  });
  if(!has_areas) {
    int neighbors = default_number_of_neighbors;
    internal::read_parameter(np, internal_np::neighbors, neighbors);
    areas = estimate_point_areas(own_points, normals, neighbors, internal::is_parallel(np));
  }
  return Triangulated_surface_3(std::move(own_points), std::move(normals), std::move(areas));
}

namespace internal {

/// a mesh, or a range of oriented points
template <class Surface, class NamedParameters>
Triangulated_surface_3 read_mesh_or_points(const Surface& surface, const NamedParameters& np) {
  if constexpr(is_range_v<Surface>) {
    const Triangulated_surface_3 points = read_point_set(surface, np);
    if(asks_for_smooth_geometry(np))
      points.require_triangles("a smooth geometry");
    return points;
  } else
    return read_surface(surface, np);
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INPUT_READ_POINT_SET_H

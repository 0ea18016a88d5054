// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_TRIANGULATE_POINTS_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_TRIANGULATE_POINTS_IMPL_H

#include <CGAL/Restricted_laplacian_3/geodesics/internal/triangulate_points.h>

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Which triangle of three points the advancing front takes next: the smallest first, and none
/// whose points have normals on different sides of it, or opposite to each other, as those on both
/// sides of something thin.
class Priority_by_normals {
public:
  /// is copied by CGAL, and refers to the surface
  explicit Priority_by_normals(const Triangulated_surface_3& points) : m_points(&points) {}

  template <class Advancing_front, class Cell_handle>
  double operator()(const Advancing_front& front, Cell_handle& cell, const int& index) const {
    std::array<std::size_t, 3> v;
    for(int k = 0; k < 3; ++k) {
      v[k] = cell->vertex((index + k + 1) % 4)->info();
      if(v[k] >= m_points->number_of_vertices())
        return front.infinity();
    }
    const Point_3& p = m_points->point(v[0]);
    const double scale = 1 / m_points->extent();
    const Vector_3 normal = CGAL::cross_product(scale * (m_points->point(v[1]) - p),
                                                scale * (m_points->point(v[2]) - p));
    double low = 0, high = 0;
    for(const std::size_t i : v) {
      low = (std::min)(low, normal * m_points->normal(i));
      high = (std::max)(high, normal * m_points->normal(i));
    }
    const double side = least_cosine * std::sqrt(normal.squared_length());
    bool is_opposite = low < -side && high > side;
    for(int k = 0; k < 3; ++k)
      is_opposite |= m_points->normal(v[k]) * m_points->normal(v[(k + 1) % 3]) < opposite;
    return is_opposite ? front.infinity() : front.smallest_radius_delaunay_sphere(cell, index);
  }

private:
  /// the cosine from which on a normal is on a side of a triangle
  static constexpr double least_cosine = 0.2;
  /// the cosine of the angle from which on normals are opposite
  static constexpr double opposite = -0.5;

  const Triangulated_surface_3* m_points;
};

/// A vertex or cell of a triangulation that CGAL orders by when it was made, in place of by its
/// address.
template <class Base> class With_time_stamp : public Base {
public:
  template <class Tds> struct Rebind_TDS {
    using Other = With_time_stamp<typename Base::template Rebind_TDS<Tds>::Other>;
  };
  using Base::Base;
  using Has_timestamp = CGAL::Tag_true;

  std::size_t time_stamp() const { return m_time_stamp; }
  void set_time_stamp(std::size_t time_stamp) { m_time_stamp = time_stamp; }

private:
  std::size_t m_time_stamp = std::size_t(-1);
};

/// A vertex of CGAL's advancing front with another order of the edges of the front: among equals by
/// their ends, in place of their addresses, of which each run in one process has others. Regular
/// points have many equals.
template <class Base> class Front_vertex : public Base {
public:
  template <class Tds> struct Rebind_TDS {
    using Other = Front_vertex<typename Base::template Rebind_TDS<Tds>::Other>;
  };
  using Base::Base;

  /// an edge of the front, by the name that the advancing front has for it
  struct Radius_ptr_type {
    double first;
    typename Base::IO_edge_type* second;
    std::pair<std::size_t, std::size_t> ends;

    Radius_ptr_type(double value, typename Base::IO_edge_type* edge) : first(value), second(edge) {
      const auto& side = edge->first.first;
      const std::size_t from = side.first->vertex(side.second)->info(),
                        to = side.first->vertex(side.third)->info();
      ends = std::minmax(from, to);
    }
    friend bool operator<(const Radius_ptr_type& a, const Radius_ptr_type& b) {
      return std::tie(a.first, a.ends, a.second) < std::tie(b.first, b.ends, b.second);
    }
  };
};

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<Triangulated_surface_3::Triangle>
triangulate_points(const Triangulated_surface_3& points) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Vertex = CGAL::Advancing_front_surface_reconstruction_vertex_base_3<Kernel>;
  using Cell = CGAL::Advancing_front_surface_reconstruction_cell_base_3<Kernel>;
  using Tds = CGAL::Triangulation_data_structure_3<Front_vertex<With_time_stamp<Vertex>>,
                                                   With_time_stamp<Cell>>;
  using Delaunay = CGAL::Delaunay_triangulation_3<Kernel, Tds>;
  // in the unit of the extent, for squares of radii
  const Point_3 center = points.center();
  std::vector<std::pair<Kernel::Point_3, std::size_t>> unit_points;
  const auto add = [&](double x, double y, double z) {
    unit_points.emplace_back(Kernel::Point_3(x, y, z), unit_points.size());
  };
  for(std::size_t i = 0; i < points.number_of_vertices(); ++i) {
    const Vector_3 v = (points.point(i) - center) / points.extent();
    add(v.x(), v.y(), v.z());
  }
  // Points in a plane need a triangulation in space, too: points far away, of which no triangle is
  // made.
  constexpr double far = 50;
  for(const double x : {-far, far}) {
    add(x, 0, 0);
    add(0, x, 0);
    add(0, 0, x);
  }
  std::vector<std::array<std::size_t, 3>> found;
  Delaunay delaunay(unit_points.begin(), unit_points.end());
  CGAL::Advancing_front_surface_reconstruction<Delaunay, Priority_by_normals> front(
      delaunay, Priority_by_normals(points));
  front.run();
  CGAL::write_triple_indices(std::back_inserter(found), front);
  std::vector<Triangulated_surface_3::Triangle> triangles;
  for(const auto& t : found)
    triangles.push_back({static_cast<std::uint32_t>(t[0]), static_cast<std::uint32_t>(t[1]),
                         static_cast<std::uint32_t>(t[2])});
  return triangles;
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_TRIANGULATE_POINTS_IMPL_H

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_CLIP_TO_CELLS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_CLIP_TO_CELLS_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Dev
/// A corner of a fragment: coordinates in units of the cell width, and barycentric coordinates in
/// the triangle that the fragment was cut from.
struct Fragment_corner {
  /// coordinates in the grid, in units of the cell width
  std::array<double, 3> position;
  /// barycentric coordinates in the triangle; they sum to 1, up to rounding
  std::array<double, 3> barycentric;
};

/// \ingroup PkgRestrictedLaplacian3Dev
/// A convex polygon: the part of one triangle that one cell owns. A triangle cut by six half-spaces
/// has at most 9 corners; rounding can make a polygon slightly non-convex, hence the reserve.
struct Fragment {
  /// largest number of corners
  static constexpr std::size_t capacity = 16;
  /// number of corners; 0 if the triangle has no part in the cell
  std::size_t size = 0;
  /// the corners in order, by the orientation of the triangle; those from `size` on are not
  /// initialized
  std::array<Fragment_corner, capacity> corners;

  /// a polygon without corners
  Fragment() = default;
  /// Copies the corners that exist. Most fragments have 3 to 5: copying the whole array would take
  /// most of the time of clipping.
  Fragment(const Fragment& other) : size(other.size) {
    std::copy_n(other.corners.begin(), other.size, corners.begin());
  }
  /// copies the corners that exist, as the constructor does
  Fragment& operator=(const Fragment& other) {
    size = other.size;
    std::copy_n(other.corners.begin(), other.size, corners.begin());
    return *this;
  }

  /// adds a corner
  /// \throws Numerical_error there are `capacity` of them: a part of the surface would be lost
  void push_back(const Fragment_corner& corner) {
    if(size == capacity)
      throw Numerical_error("a fragment of a triangle has too many corners");
    corners[size++] = corner;
  }

  /// twice the area of the polygon, in units of the squared cell width
  double double_area() const {
    std::array<double, 3> sum = {0, 0, 0};
    for(std::size_t i = 2; i < size; ++i) {
      const auto c = double_area_vector(i);
      for(int axis = 0; axis < 3; ++axis)
        sum[axis] += c[axis];
    }
    return std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
  }

  /// integral over the polygon of a linear function of the position, in units of the squared cell
  /// width
  double integral_of_linear(const std::array<double, 3>& coefficients) const {
    double sum = 0;
    for(std::size_t i = 2; i < size; ++i) {
      const auto c = double_area_vector(i);
      double value = 0;
      for(int axis = 0; axis < 3; ++axis)
        value += coefficients[axis] * (corners[0].position[axis] + corners[i - 1].position[axis] +
                                       corners[i].position[axis]);
      sum += std::sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]) * value / 6;
    }
    return sum;
  }

private:
  /// of the triangle of corners 0, i - 1 and i
  std::array<double, 3> double_area_vector(std::size_t i) const {
    const auto &o = corners[0].position, &p = corners[i - 1].position, &q = corners[i].position;
    const double ux = p[0] - o[0], uy = p[1] - o[1], uz = p[2] - o[2];
    const double vx = q[0] - o[0], vy = q[1] - o[1], vz = q[2] - o[2];
    return {uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx};
  }
};

namespace internal {

/// Moves a coordinate that is within `tolerance` of a wall onto that wall. The nearest wall of
/// the grid to a number below 0 is 0; conversion to an integer is much faster than `std::round()`.
inline double snap_to_wall(double x, double tolerance) {
  const double wall = static_cast<double>(static_cast<std::int32_t>(x + 0.5));
  return std::abs(x - wall) <= tolerance ? wall : x;
}

/// the point in which the segment `a b` crosses the wall `x_axis = wall`; exactly on the wall
inline Fragment_corner cross_wall(const Fragment_corner& a, const Fragment_corner& b, int axis,
                                  double wall, double tolerance) {
  const double t = (wall - a.position[axis]) / (b.position[axis] - a.position[axis]);
  Fragment_corner c;
  for(int i = 0; i < 3; ++i) {
    c.position[i] = snap_to_wall(a.position[i] + t * (b.position[i] - a.position[i]), tolerance);
    c.barycentric[i] = a.barycentric[i] + t * (b.barycentric[i] - a.barycentric[i]);
  }
  c.position[axis] = wall;
  return c;
}

/// the part of `polygon` on the side `sign * (x_axis - wall) >= 0`
inline Fragment half_space(const Fragment& polygon, int axis, double wall, double sign,
                           double tolerance) {
  Fragment result;
  for(std::size_t i = 0; i < polygon.size; ++i) {
    const Fragment_corner& a = polygon.corners[i];
    const Fragment_corner& b = polygon.corners[i + 1 == polygon.size ? 0 : i + 1];
    const double da = sign * (a.position[axis] - wall), db = sign * (b.position[axis] - wall);
    if(da >= 0)
      result.push_back(a);
    if((da > 0 && db < 0) || (da < 0 && db > 0))
      // From the lower end, so that both sides and both neighbors of an edge get the same point.
      result.push_back(a.position[axis] < b.position[axis]
                           ? cross_wall(a, b, axis, wall, tolerance)
                           : cross_wall(b, a, axis, wall, tolerance));
  }
  if(result.size < 3)
    result.size = 0;
  return result;
}

inline std::array<double, 2> range(const Fragment& polygon, int axis) {
  double low = polygon.corners[0].position[axis], high = low;
  for(std::size_t i = 1; i < polygon.size; ++i) {
    low = (std::min)(low, polygon.corners[i].position[axis]);
    high = (std::max)(high, polygon.corners[i].position[axis]);
  }
  return {low, high};
}

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Dev
/// Cuts triangles along the walls of the unit grid \f$\{0, \dots, n\}^3\f$ into convex fragments,
/// each owned by one cell.
///
/// Cells are half-open: a fragment that lies in a wall belongs to the upper one of the two cells,
/// except in the last wall, where only the lower one exists. A fragment never reaches across a
/// wall, so area is neither lost nor counted twice.
///
/// Coordinates, of corners and of the points in which edges cross walls, that are within
/// `tolerance` of a wall are moved onto it. Otherwise a vertex that was meant to lie on a wall, as
/// in symmetric models, whose plane of symmetry is a wall at all depths, would lie beside it by a
/// rounding error and put a cell of zero size into the octree.
class Cell_clipper {
public:
  /// \param cells_per_side number \f$n\f$ of cells along an axis
  /// \param tolerance in units of the cell width
  Cell_clipper(int cells_per_side, double tolerance)
    : m_cells_per_side(cells_per_side), m_tolerance(tolerance) {}

  /// Calls `sink(cell, fragment)` for each fragment of a triangle; `cell` is a
  /// `std::array<int, 3>`. Fragments without area are not reported. The time is proportional to the
  /// number of fragments and to the number of cells between the extremes along the first axis.
  /// \param corners in units of the cell width, inside \f$[0,n]^3\f$ up to rounding
  /// \param sink the function object that is called
  template <class Sink>
  void operator()(const std::array<std::array<double, 3>, 3>& corners, Sink&& sink) const {
    cut_snapped({snapped(corners[0]), snapped(corners[1]), snapped(corners[2])}, sink);
  }

  /// the same for corners that have been `snapped()`
  template <class Sink>
  void cut_snapped(const std::array<std::array<double, 3>, 3>& corners, Sink&& sink) const {
    std::array<int, 3> cell;
    split(triangle(corners), 0, cell, sink);
  }

  /// The fragment of a triangle that a cell owns. The cell must be one for which `operator()`
  /// reported a fragment: what lies in a wall would be found from both sides.
  Fragment fragment(const std::array<std::array<double, 3>, 3>& corners,
                    const std::array<int, 3>& cell) const {
    Fragment polygon = triangle({snapped(corners[0]), snapped(corners[1]), snapped(corners[2])});
    for(int axis = 0; axis < 3 && polygon.size != 0; ++axis) {
      const auto range = internal::range(polygon, axis);
      if(range[0] < cell[axis])
        polygon = internal::half_space(polygon, axis, cell[axis], 1, m_tolerance);
      if(polygon.size != 0 && range[1] > cell[axis] + 1)
        polygon = internal::half_space(polygon, axis, cell[axis] + 1, -1, m_tolerance);
    }
    return polygon;
  }

  /// a corner as the clipper sees it: on the walls that it is near to, and inside the grid
  std::array<double, 3> snapped(std::array<double, 3> corner) const {
    for(double& x : corner)
      x = (std::min)((std::max)(internal::snap_to_wall(x, m_tolerance), 0.),
                     static_cast<double>(m_cells_per_side));
    return corner;
  }

private:
  static Fragment triangle(const std::array<std::array<double, 3>, 3>& corners) {
    Fragment polygon;
    polygon.size = 3;
    for(int i = 0; i < 3; ++i) {
      polygon.corners[i].position = corners[i];
      polygon.corners[i].barycentric = {i == 0 ? 1. : 0., i == 1 ? 1. : 0., i == 2 ? 1. : 0.};
    }
    return polygon;
  }

  template <class Sink>
  void split(const Fragment& polygon, int axis, std::array<int, 3>& cell, Sink&& sink) const {
    if(axis == 3) {
      if(polygon.double_area() > 0)
        sink(static_cast<const std::array<int, 3>&>(cell), polygon);
      return;
    }
    const auto range = internal::range(polygon, axis);
    int slab = static_cast<int>(range[0]); // no coordinate is negative
    if(range[1] <= slab + 1) {
      cell[axis] = (std::min)(slab, m_cells_per_side - 1);
      split(polygon, axis + 1, cell, sink);
      return;
    }
    Fragment rest = polygon;
    while(rest.size != 0 && range[1] > slab + 1) {
      const Fragment low = internal::half_space(rest, axis, slab + 1, -1, m_tolerance);
      if(low.size != 0) {
        cell[axis] = slab;
        split(low, axis + 1, cell, sink);
      }
      rest = internal::half_space(rest, axis, slab + 1, 1, m_tolerance);
      ++slab;
    }
    if(rest.size != 0) {
      cell[axis] = (std::min)(slab, m_cells_per_side - 1);
      split(rest, axis + 1, cell, sink);
    }
  }

  int m_cells_per_side;
  double m_tolerance;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_CLIP_TO_CELLS_H

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_PROGRAMS_REFINED_SURFACE_H
#define RESTRICTED_LAPLACIAN_3_PROGRAMS_REFINED_SURFACE_H

// Divides the faces of a surface, so that functions on it can be shown between its vertices.

#include "program.h"

#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <CGAL/Kernel/global_functions.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace programs {

struct Refined_surface {
  RL::Triangulated_surface_3 surface;
  // of its vertices, on the surface that was refined
  std::vector<RL::Surface_location> locations;
  // whether a vertex has one: it has a face with an area
  std::vector<char> is_located;
  // of its faces, those that they are part of
  std::vector<std::uint32_t> parents;
};

namespace internal {

// Halves triangles at their longest sides. A side that is too long is halved by the triangles on
// both of its sides, sooner or later, and its parts are the same: no cracks arise.
class Surface_refinement {
public:
  using Location = RL::Surface_location;
  using Triangle = RL::Triangulated_surface_3::Triangle;

  Surface_refinement(const RL::Triangulated_surface_3& surface, double longest_side)
    : m_surface(surface), m_longest_square(longest_side * longest_side) {
    for(std::size_t v = 0; v < surface.number_of_vertices(); ++v)
      m_points.push_back(surface.point(v));
    m_locations.resize(m_points.size());
    m_is_located.resize(m_points.size());
    for(std::size_t f = 0; f < surface.number_of_faces(); ++f) {
      if(surface.is_degenerate(f))
        m_triangles.push_back(surface.triangle(f));
      else
        divide(surface.triangle(f), {corner(f, 0), corner(f, 1), corner(f, 2)});
      m_parents.resize(m_triangles.size(), static_cast<std::uint32_t>(f));
    }
  }

  Refined_surface take() {
    return {RL::Triangulated_surface_3(std::move(m_points), std::move(m_triangles)),
            std::move(m_locations), std::move(m_is_located), std::move(m_parents)};
  }

private:
  static Location corner(std::size_t face, int i) {
    Location location;
    location.face = face;
    location.barycentric = {0, 0, 0};
    location.barycentric[i] = 1;
    return location;
  }

  void divide(const Triangle& t, const std::array<Location, 3>& at) {
    std::array<double, 3> squares; // of the side behind each corner
    for(int i = 0; i < 3; ++i)
      squares[i] = CGAL::squared_distance(m_points[t[(i + 1) % 3]], m_points[t[(i + 2) % 3]]);
    const int i =
        static_cast<int>(std::max_element(squares.begin(), squares.end()) - squares.begin());
    if(!(squares[i] > m_longest_square)) {
      for(int k = 0; k < 3; ++k) {
        m_locations[t[k]] = at[k];
        m_is_located[t[k]] = 1;
      }
      m_triangles.push_back(t);
      return;
    }
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    Location location = at[j];
    for(int c = 0; c < 3; ++c)
      location.barycentric[c] = (at[j].barycentric[c] + at[k].barycentric[c]) / 2;
    const std::uint32_t middle = midpoint(t[j], t[k], location);
    divide({t[i], t[j], middle}, {at[i], at[j], location});
    divide({t[i], middle, t[k]}, {at[i], location, at[k]});
  }

  std::uint32_t midpoint(std::uint32_t a, std::uint32_t b, const Location& location) {
    const auto [it, is_new] =
        m_midpoints.insert({std::minmax(a, b), static_cast<std::uint32_t>(m_points.size())});
    if(is_new) {
      m_points.push_back(m_surface.is_smooth() ? m_surface.surface_point(location).point
                                               : CGAL::midpoint(m_points[it->first.first],
                                                                m_points[it->first.second]));
      m_locations.emplace_back();
      m_is_located.push_back(0);
    }
    return it->second;
  }

  const RL::Triangulated_surface_3& m_surface;
  double m_longest_square;
  std::vector<RL::Point_3> m_points;
  std::vector<Triangle> m_triangles;
  std::vector<Location> m_locations;
  std::vector<char> m_is_located;
  std::vector<std::uint32_t> m_parents;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> m_midpoints;
};

} // namespace internal

// Divides faces until no side is longer than `longest_side`. The vertices of the surface remain,
// the first ones, also those that no face uses.
inline Refined_surface refine(const RL::Triangulated_surface_3& surface, double longest_side) {
  return internal::Surface_refinement(surface, longest_side).take();
}

// locations &rarr; a row of values for each of them
using Values_at = std::function<Eigen::MatrixXd(const std::vector<RL::Surface_location>&)>;

// the values at the vertices: a row for each, NaN if it has no location
inline Eigen::MatrixXd values_at_vertices(const Refined_surface& refined, const Values_at& at) {
  std::vector<RL::Surface_location> locations;
  for(std::size_t v = 0; v < refined.locations.size(); ++v)
    if(refined.is_located[v])
      locations.push_back(refined.locations[v]);
  const Eigen::MatrixXd values = at(locations);
  Eigen::MatrixXd result =
      Eigen::MatrixXd::Constant(static_cast<Eigen::Index>(refined.locations.size()), values.cols(),
                                std::numeric_limits<double>::quiet_NaN());
  Eigen::Index row = 0;
  for(std::size_t v = 0; v < refined.locations.size(); ++v)
    if(refined.is_located[v])
      result.row(static_cast<Eigen::Index>(v)) = values.row(row++);
  return result;
}

} // namespace programs

#endif // RESTRICTED_LAPLACIAN_3_PROGRAMS_REFINED_SURFACE_H

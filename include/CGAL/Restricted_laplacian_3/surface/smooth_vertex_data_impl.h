// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SMOOTH_VERTEX_DATA_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SMOOTH_VERTEX_DATA_IMPL_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Number_lists.h>
#include <CGAL/Restricted_laplacian_3/surface/internal/Corner_groups.h>
#include <CGAL/Restricted_laplacian_3/surface/internal/Smooth_sectors.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/Surface_edges.h>
#include <CGAL/Restricted_laplacian_3/surface/smooth_vertex_data.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// An edge end, at which the deviation of the cubic is determined by a gradient, multiplies the
/// largest error of values by no more than twice this number.
constexpr double largest_noise_factor = 8;

/// Fits gradients to the differences of a function between a vertex and its neighbors.
class Vertex_gradient_fit {
public:
  /// Fits by the highest degree, up to 3, that the neighbors determine.
  /// \param normal unit normal of the tangent plane
  /// \param ways from the vertex to the neighbors
  /// \param longest length of the edges that the gradient is for
  void set(const Vector_3& normal, const std::vector<Vector_3>& ways, double longest) {
    m_weights.setZero(3, static_cast<Eigen::Index>(ways.size()));
    m_norm = 0;
    project(normal, ways);
    if(!(fit<9>(ways, longest) || fit<5>(ways, longest)))
      fit<2>(ways, 0);
  }

  /// the gradient is the sum of the columns, each times the difference to a neighbor
  const Eigen::Matrix3Xd& weights() const { return m_weights; }
  /// the sum of the lengths of the columns
  double norm() const { return m_norm; }

private:
  /// in units of the largest distance; those to which the way is too steep do not count
  void project(const Vector_3& normal, const std::vector<Vector_3>& ways) {
    constexpr double least_cosine = 0.3;
    const Eigen::Vector3d n(normal.x(), normal.y(), normal.z());
    Eigen::Index axis;
    n.cwiseAbs().minCoeff(&axis);
    m_tangents.col(0) = n.cross(Eigen::Vector3d::Unit(axis)).normalized();
    m_tangents.col(1) = n.cross(m_tangents.col(0));
    m_radius = 0;
    for(const Vector_3& way : ways)
      m_radius = (std::max)(m_radius, std::sqrt(way.squared_length()));
    m_points.clear();
    for(const Vector_3& way : ways) {
      const Eigen::Vector3d e = Eigen::Vector3d(way.x(), way.y(), way.z()) / m_radius;
      const Eigen::Vector2d p = m_tangents.transpose() * e;
      const double length = e.norm();
      m_points.push_back({p, length > 0 && p.norm() >= least_cosine * length ? 1 / length : 0});
    }
  }

  /// \tparam size number of coefficients of a polynomial without a constant
  /// \return whether the neighbors determine it; if `longest` is 0, any gradient is good enough
  template <int size> bool fit(const std::vector<Vector_3>& ways, double longest) {
    constexpr double least_ratio_of_pivots = 1e-10;
    using Row = Eigen::Matrix<double, size, 1>;
    if(ways.size() < static_cast<std::size_t>(size))
      return false;
    m_rows.resize(size, static_cast<Eigen::Index>(ways.size()));
    Eigen::Matrix<double, size, size> a = Eigen::Matrix<double, size, size>::Zero();
    for(std::size_t i = 0; i < ways.size(); ++i) {
      const double x = m_points[i].place[0], y = m_points[i].place[1], w = m_points[i].weight;
      Eigen::Matrix<double, 9, 1> monomials;
      monomials << x, y, x * x, x * y, y * y, x * x * x, x * x * y, x * y * y, y * y * y;
      const Row row = w * monomials.head<size>();
      a += row * row.transpose();
      m_rows.col(static_cast<Eigen::Index>(i)) = w * row;
    }
    const Eigen::LDLT<Eigen::Matrix<double, size, size>> factorization(a);
    const Row pivots = factorization.vectorD();
    if(factorization.info() != Eigen::Success ||
       !(pivots.minCoeff() > least_ratio_of_pivots * pivots.maxCoeff()))
      return false;
    const Eigen::Matrix<double, size, 2> x =
        factorization.solve(Eigen::Matrix<double, size, 2>::Identity());
    const Eigen::Matrix2Xd in_plane = x.transpose() * m_rows / m_radius;
    const double norm = in_plane.colwise().norm().sum();
    if(!std::isfinite(norm) || norm * longest > largest_noise_factor)
      return false;
    m_weights = m_tangents * in_plane;
    m_norm = norm;
    return true;
  }

  struct Point {
    Eigen::Vector2d place;
    double weight;
  };
  Eigen::Matrix<double, 3, 2> m_tangents;
  double m_radius = 0;
  std::vector<Point> m_points;
  Eigen::MatrixXd m_rows;
  Eigen::Matrix3Xd m_weights;
  double m_norm = 0;
};

/// The gradients of functions at the vertices, one for each sector.
struct Sector_gradients {
  /// three numbers of each component, of each sector
  std::vector<double> gradients;
  /// sums of the absolute values of the weights that values have in them, of each sector
  std::vector<double> norms;
};

inline Sector_gradients sector_gradients(const Triangulated_surface_3& surface,
                                         const Smooth_sectors& sectors,
                                         const std::vector<double>& values,
                                         std::size_t components) {
  const Corner_groups& groups = sectors.groups();
  std::vector<Number_lists::Pair> pairs;
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
    for(int i = 0; i < 3 && !surface.is_degenerate(f); ++i) {
      const std::uint32_t a = groups.corners[3 * f + i].group,
                          b = groups.corners[3 * f + (i + 1) % 3].group;
      pairs.emplace_back(a, b);
      pairs.emplace_back(b, a);
    }
  const std::size_t number = groups.vertices.size();
  const Number_lists neighbors(number, pairs);
  const std::vector<Vector_3> normals = sectors.normals();

  // From a vertex with more neighbors no way leads on to a second ring.
  constexpr std::size_t most_neighbors = 32;
  Sector_gradients result;
  result.gradients.assign(3 * components * number, 0);
  result.norms.assign(number, 0);
  std::vector<std::uint32_t> vertices;
  std::vector<Vector_3> ways;
  Vertex_gradient_fit fit;
  for(std::size_t g = 0; g < number; ++g) {
    if(neighbors[g].empty() || normals[g] == CGAL::NULL_VECTOR)
      continue;
    const std::uint32_t v = groups.vertices[g];
    vertices.clear();
    double longest = 0;
    for(std::uint32_t neighbor : neighbors[g]) {
      vertices.push_back(groups.vertices[neighbor]);
      longest =
          (std::max)(longest, (surface.point(vertices.back()) - surface.point(v)).squared_length());
      if(neighbors[neighbor].size() <= most_neighbors)
        for(std::uint32_t next : neighbors[neighbor])
          if(groups.vertices[next] != v)
            vertices.push_back(groups.vertices[next]);
    }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    ways.clear();
    for(std::uint32_t vertex : vertices)
      ways.push_back(surface.point(vertex) - surface.point(v));
    fit.set(normals[g], ways, std::sqrt(longest));
    result.norms[g] = fit.norm();
    for(std::size_t i = 0; i < vertices.size(); ++i)
      for(std::size_t k = 0; k < components; ++k) {
        const double difference = values[components * vertices[i] + k] - values[components * v + k];
        for(int axis = 0; axis < 3; ++axis)
          result.gradients[3 * (components * g + k) + axis] +=
              fit.weights()(axis, static_cast<Eigen::Index>(i)) * difference;
      }
  }
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<double>
cubic_deviations(const Triangulated_surface_3& surface, const Smooth_geometry& geometry,
                 const std::vector<double>& values, std::size_t components) {
  surface.require_triangles("a function that is smooth between vertices");
  const Surface_edges edges(surface);
  const Smooth_sectors sectors(surface, edges, geometry);
  const Sector_gradients at = sector_gradients(surface, sectors, values, components);

  // The vector from an end of an edge that the gradient there is along, as from corner to corner of
  // a face: three times that to the next control point of the curve over the edge.
  const auto tangent = [&](std::size_t face, int from, int to) {
    const std::array<Point_3, 3> corners = {surface.point(face, 0), surface.point(face, 1),
                                            surface.point(face, 2)};
    if(!surface.is_smooth() || surface.is_degenerate(face))
      return corners[to] - corners[from];
    std::array<double, 3> place = {0, 0, 0}, direction = {0, 0, 0};
    place[from] = direction[to] = 1;
    direction[from] = -1;
    return surface.patches().derivative(face, corners, place, direction);
  };
  std::vector<double> result(7 * components * surface.number_of_faces(), 0);
  const auto at_control = [&](std::size_t face, std::size_t control) {
    return result.data() + components * (7 * face + control);
  };
  std::vector<double> sum(components);
  for(std::size_t edge = 0; edge < edges.size(); ++edge)
    for(const std::uint32_t begin : edges.ends(edge)) {
      const std::uint32_t end =
          edges.ends(edge)[0] == begin ? edges.ends(edge)[1] : edges.ends(edge)[0];
      std::fill(sum.begin(), sum.end(), 0.);
      int count = 0;
      for(const Surface_edges::Side& side : edges.sides(edge)) {
        if(surface.is_degenerate(side.face))
          continue;
        ++count;
        const int first = static_cast<int>(side.number), second = (first + 1) % 3,
                  from = surface.triangle(side.face)[first] == begin ? first : second;
        const std::uint32_t group = sectors.groups().corners[3 * side.face + from].group;
        const Vector_3 t = tangent(side.face, from, first + second - from);
        if(at.norms[group] * std::sqrt(t.squared_length()) > largest_noise_factor)
          continue;
        for(std::size_t k = 0; k < components; ++k) {
          const double* const g = at.gradients.data() + 3 * (components * group + k);
          sum[k] += g[0] * t.x() + g[1] * t.y() + g[2] * t.z() -
                    (values[components * end + k] - values[components * begin + k]);
        }
      }
      for(const Surface_edges::Side& side : edges.sides(edge)) {
        const bool is_first = surface.triangle(side.face)[side.number] == begin;
        double* const control = at_control(side.face, 2 * side.number + (is_first ? 0 : 1));
        for(std::size_t k = 0; k < components && count > 0; ++k)
          control[k] = sum[k] / (3 * count);
      }
    }
  for(std::size_t face = 0; face < surface.number_of_faces(); ++face)
    for(std::size_t control = 0; control < 6; ++control)
      for(std::size_t k = 0; k < components; ++k)
        at_control(face, 6)[k] += at_control(face, control)[k] / 4;
  return result;
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SMOOTH_VERTEX_DATA_IMPL_H

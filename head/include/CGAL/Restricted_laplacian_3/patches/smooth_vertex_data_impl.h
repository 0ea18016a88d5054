// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PATCHES_SMOOTH_VERTEX_DATA_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PATCHES_SMOOTH_VERTEX_DATA_IMPL_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Number_lists.h>
#include <CGAL/Restricted_laplacian_3/patches/internal/Smooth_sectors.h>
#include <CGAL/Restricted_laplacian_3/patches/smooth_vertex_data.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/Corner_groups.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/Surface_edges.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

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
    m_weights.assign(ways.size(), Vector_3(0, 0, 0));
    m_norm = 0;
    project(normal, ways);
    if(!(fit(9, longest) || fit(5, longest)))
      fit(2, 0);
  }

  /// the gradient is the sum of these, each times the difference to a neighbor
  const std::vector<Vector_3>& weights() const { return m_weights; }
  /// the sum of their lengths
  double norm() const { return m_norm; }

private:
  static constexpr int largest_size = 9;
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor,
                               largest_size, largest_size>;

  /// coordinates in units of the largest distance; points to which the way is too steep have the
  /// weight 0
  void project(const Vector_3& normal, const std::vector<Vector_3>& ways) {
    constexpr double least_cosine = 0.3;
    m_tangents = tangent_axes(normal);
    m_radius = 0;
    for(const Vector_3& way : ways)
      m_radius = (std::max)(m_radius, std::sqrt(way.squared_length()));
    m_points.clear();
    for(const Vector_3& way : ways) {
      const Vector_3 e = way / m_radius;
      const double u = e * m_tangents[0], v = e * m_tangents[1], squared = e.squared_length();
      const bool counts = squared > 0 && u * u + v * v >= least_cosine * least_cosine * squared;
      m_points.push_back({u, v, counts ? 1 / squared : 0});
    }
  }

  struct Point {
    double u, v, weight;
    std::array<double, largest_size> monomials() const {
      return {u, v, u * u, u * v, v * v, u * u * u, u * u * v, u * v * v, v * v * v};
    }
  };

  /// \param size number of coefficients of a polynomial without a constant: 2, 5 or 9
  /// \return whether the neighbors determine it; if `longest` is 0, any gradient is good enough
  bool fit(int size, double longest) {
    constexpr double least_ratio_of_pivots = 1e-10;
    if(m_points.size() < static_cast<std::size_t>(size))
      return false;
    Matrix a = Matrix::Zero(size, size);
    for(const Point& p : m_points) {
      const auto monomials = p.monomials();
      for(int i = 0; i < size; ++i)
        for(int j = 0; j < size; ++j)
          a(i, j) += p.weight * monomials[i] * monomials[j];
    }
    const Eigen::LDLT<Matrix> factorization(a);
    const double least = factorization.vectorD().minCoeff(),
                 largest = factorization.vectorD().maxCoeff();
    if(factorization.info() != Eigen::Success || !(least > least_ratio_of_pivots * largest))
      return false;
    const Matrix rows = factorization.solve(Matrix::Identity(size, 2));
    std::vector<Vector_3> weights;
    double norm = 0;
    for(const Point& p : m_points) {
      const auto monomials = p.monomials();
      double along_u = 0, along_v = 0;
      for(int i = 0; i < size; ++i) {
        along_u += rows(i, 0) * monomials[i];
        along_v += rows(i, 1) * monomials[i];
      }
      const double factor = p.weight / m_radius;
      weights.push_back(factor * (along_u * m_tangents[0] + along_v * m_tangents[1]));
      norm += factor * std::hypot(along_u, along_v);
    }
    if(!std::isfinite(norm) || norm * longest > largest_noise_factor)
      return false;
    m_weights.swap(weights);
    m_norm = norm;
    return true;
  }

  std::array<Vector_3, 2> m_tangents;
  double m_radius = 0;
  std::vector<Point> m_points;
  std::vector<Vector_3> m_weights;
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
          result.gradients[3 * (components * g + k) + axis] += fit.weights()[i][axis] * difference;
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
  for(double& x : result)
    if(!std::isfinite(x))
      x = 0;
  return result;
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PATCHES_SMOOTH_VERTEX_DATA_IMPL_H

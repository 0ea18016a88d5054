// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTERNAL_LINEAR_SIGNAL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTERNAL_LINEAR_SIGNAL_H

#include <CGAL/Restricted_laplacian_3/assembly/Boundary_integration.h>
#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_functions_3.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

inline Eigen::Vector3d eigen_vector(const Point_3& p) { return {p.x(), p.y(), p.z()}; }

/// Values at the vertices of a surface, a column for each component, and linear in each triangle.
class Linear_signal {
public:
  /// \param values a row for each vertex; positions, if it is empty
  /// \throws Parameter_error if there are not so many rows, or if a value is not finite at a vertex
  /// that has a face
  Linear_signal(const Spline_space_3& space, Eigen::MatrixXd values)
    : m_space(space), m_values(std::move(values)) {
    const Triangulated_surface_3& surface = m_space.surface();
    const auto number = static_cast<Eigen::Index>(surface.number_of_vertices());
    if(m_values.size() == 0) {
      m_values.resize(number, 3);
      for(Eigen::Index v = 0; v < number; ++v)
        m_values.row(v) = eigen_vector(surface.point(static_cast<std::size_t>(v)));
    }
    if(m_values.rows() != number)
      throw Parameter_error("signal", "has " + std::to_string(m_values.rows()) +
                                          " rows, but there are " + std::to_string(number) +
                                          " vertices");
    for(std::size_t face = 0; face < surface.number_of_faces(); ++face)
      for(const std::uint32_t v : surface.triangle(face))
        if(!m_values.row(v).allFinite())
          throw Parameter_error("signal", "is not finite at vertex " + std::to_string(v));
  }

  /// a row for each vertex
  const Eigen::MatrixXd& values() const { return m_values; }
  /// number of components
  Eigen::Index components() const { return m_values.cols(); }

  /// \f$\int \rho\, x\, b_i\f$, a column for each component
  Eigen::MatrixXd loads() const { return assemble_component_loads(m_space, Values{*this}); }

  /// \f$\int \langle \beta \nabla x, \nabla b_i \rangle\f$
  /// \param factor \f$\beta\f$; a null pointer: 1
  Eigen::MatrixXd gradient_loads(const Surface_function_view* factor = nullptr) const {
    return assemble_gradient_loads(m_space, Gradients{*this, factor});
  }

  /// \f$\int_{\partial \mathcal M} \partial_\nu x\, b_i\f$
  Eigen::MatrixXd flux_loads() const {
    Eigen::MatrixXd result =
        Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(m_space.dimension()), components());
    const Boundary_integration boundary(m_space);
    for(const Boundary_integration::Node& node : boundary.nodes()) {
      const Tensor_basis_3::Values b = Tensor_basis_3::values(node.t);
      const Vector_3& nu = node.flux_direction;
      const Eigen::RowVectorXd flux = node.weight * Eigen::RowVector3d(nu.x(), nu.y(), nu.z()) *
                                      gradients(m_space.surface().triangle(node.location.face));
      for_each_element(boundary.elements(node),
                       [&](int i, std::uint32_t element) { result.row(element) += b[i] * flux; });
    }
    return result;
  }

private:
  /// the gradient of each component in a triangle: a column
  Eigen::Matrix3Xd gradients(const Triangulated_surface_3::Triangle& triangle) const {
    std::array<Eigen::Vector3d, 3> sides; // opposite to the corners
    double unit = 0;
    for(int i = 0; i < 3; ++i) {
      sides[i] = eigen_vector(m_space.surface().point(triangle[(i + 2) % 3])) -
                 eigen_vector(m_space.surface().point(triangle[(i + 1) % 3]));
      unit = (std::max)(unit, sides[i].cwiseAbs().maxCoeff());
    }
    Eigen::Matrix3Xd result = Eigen::Matrix3Xd::Zero(3, components());
    if(!(unit > 0))
      return result;
    for(Eigen::Vector3d& side : sides)
      side /= unit;
    const Eigen::Vector3d normal = sides[0].cross(sides[1]);
    const double square = normal.squaredNorm(); // of twice the area
    if(square > 0)
      for(int i = 0; i < 3; ++i)
        result += (normal / (square * unit)).cross(sides[i]) * m_values.row(triangle[i]);
    return result;
  }

  /// functions of many points at once
  struct Values {
    const Linear_signal& signal;

    int components() const { return static_cast<int>(signal.components()); }
    int degree() const { return 1; }
    void operator()(const Surface_point* points, std::size_t number, double* values) const {
      for(std::size_t k = 0; k < number; ++k)
        for(Eigen::Index c = 0; c < signal.components(); ++c) {
          double sum = 0;
          for(int i = 0; i < 3; ++i)
            sum += points[k].barycentric[i] * signal.m_values(points[k].vertices[i], c);
          *values++ = sum;
        }
    }
  };
  struct Gradients {
    const Linear_signal& signal;
    const Surface_function_view* factor;

    int components() const { return static_cast<int>(3 * signal.components()); }
    int degree() const { return factor ? factor->degree() : 0; }
    void operator()(const Surface_point* points, std::size_t number, double* values) const {
      std::vector<double> factors(number, 1);
      if(factor)
        (*factor)(points, number, factors.data());
      for(std::size_t k = 0; k < number; ++k) {
        const Eigen::Matrix3Xd gradients = factors[k] * signal.gradients(points[k].vertices);
        values = std::copy_n(gradients.data(), gradients.size(), values);
      }
    }
  };

  Spline_space_3 m_space;
  Eigen::MatrixXd m_values;
};

/// what spline functions are at the vertices; at those without a face of positive area, what
/// another signal is there
inline Eigen::MatrixXd values_at_vertices_or(const Spline_space_3& space,
                                             const Eigen::MatrixXd& coefficients,
                                             const Eigen::MatrixXd& other) {
  Eigen::MatrixXd result = Spline_functions_3(space, coefficients).values_at_vertices();
  for(Eigen::Index v = 0; v < result.rows(); ++v)
    if(result.row(v).hasNaN())
      result.row(v) = other.row(v);
  return result;
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTERNAL_LINEAR_SIGNAL_H

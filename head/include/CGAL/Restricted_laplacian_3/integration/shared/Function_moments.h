// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_SHARED_FUNCTION_MOMENTS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_SHARED_FUNCTION_MOMENTS_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/integration/Integration_nodes.h>
#include <CGAL/Restricted_laplacian_3/integration/shared/Cell_load.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_function_view.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The moments of the components of a function on a sheet, of which loads are made.
class Function_moments {
public:
  /// what is integrated against elements
  enum class Of {
    values,
    fluxes // \f$A\, v\f$ with the metric \f$A\f$, of a vector field \f$v\f$
  };

  /// \param name of the function, for errors
  Function_moments(const Surface_function_view& f, const char* name, Of of = Of::values)
    : m_function(f), m_name(name), m_of(of), m_number(static_cast<std::size_t>(f.components())),
      m_moments(m_number), m_squares(m_number, 0.) {}

  /// whether the function is linear on each face, or constant
  bool is_linear() const { return m_function.degree() <= 1; }
  /// of polynomials that rules integrate
  int degree() const {
    const int of_elements = m_of == Of::fluxes ? 5 : 6; // on a plane
    return of_elements + m_function.degree();
  }
  std::size_t number_of_components() const { return m_number; }

  /// of a component
  const Cell_load& operator[](std::size_t k) const { return m_moments[k]; }
  /// the integral of the square of a component, in units of the squared cell width
  double square(std::size_t k) const { return m_squares[k]; }

  /// What is integrated, at some points: all components of a point before the next one.
  /// \param metrics of the points
  /// \throws Parameter_error if a value of the function is not finite; names the face
  const double* values_at(const Surface_point* points, std::size_t size,
                          const Symmetric_tensor_3* metrics) {
    m_values.resize((std::max)(m_values.size(), m_number * size));
    m_function(points, size, m_values.data());
    for(std::size_t i = 0; i < m_number * size; ++i)
      if(!std::isfinite(m_values[i]))
        throw Parameter_error(m_name, "has a value that is not a finite number in face " +
                                          std::to_string(points[i / m_number].polygon));
    if(m_of == Of::fluxes)
      for(std::size_t i = 0; i < size; ++i)
        for(std::size_t k = 0; k < m_number; k += 3) {
          double* const v = m_values.data() + m_number * i + k;
          const auto flux = product(metrics[i], v[0], v[1], v[2]);
          std::copy(flux.begin(), flux.end(), v);
        }
    return m_values.data();
  }

  /// adds the nodes of a block
  void add(const Integration_node_block& block) {
    const double* const values = values_at(block.points.data(), block.size, block.metrics.data());
    for(std::size_t k = 0; k < m_number; ++k) {
      Node_values weighted = {};
      for(std::size_t i = 0; i < block.size; ++i) {
        weighted[i] = block.weights[i] * values[m_number * i + k];
        m_squares[k] += weighted[i] * values[m_number * i + k];
      }
      m_moments[k].add(block.positions, weighted);
    }
  }

  /// Adds a triangle on which what is integrated is linear.
  /// \param corners their local coordinates in the cell
  /// \param area in units of the squared cell width
  /// \param values at the three corners, all components of each
  void add(const std::array<std::array<double, 3>, 3>& corners, double area,
           const std::array<const double*, 3>& values) {
    const Linear_load_nodes nodes = linear_load_nodes(corners, area, degree());
    for(std::size_t k = 0; k < m_number; ++k) {
      const double p = values[0][k], q = values[1][k], r = values[2][k];
      m_squares[k] += area / 6 * (p * p + q * q + r * r + p * q + q * r + r * p);
      m_moments[k].add(nodes, {p, q, r});
    }
  }

private:
  Surface_function_view m_function;
  const char* m_name;
  Of m_of;
  std::size_t m_number;
  std::vector<Cell_load> m_moments;
  std::vector<double> m_squares;
  std::vector<double> m_values;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_SHARED_FUNCTION_MOMENTS_H

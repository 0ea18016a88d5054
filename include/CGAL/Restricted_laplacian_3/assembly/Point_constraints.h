// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_POINT_CONSTRAINTS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_POINT_CONSTRAINTS_H

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/splines/B_spline_1.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Operators
/// Prescribes values at single points by a penalty: minimises the energy plus
/// \f$ \sum_k w_k (u(p_k) - g_k)^2 \f$, which adds \f$ \sum_k w_k b(p_k) b(p_k)^T \f$ to the matrix
/// and \f$ \sum_k w_k g_k b(p_k) \f$ to the right-hand side.
///
/// The weights have the unit of the stiffness matrix: none. With weight \f$w\f$ the solution misses
/// the value by \f$1 / w\f$ times the flux that it takes to hold it, so \f$10^3\f$ or
/// \f$10^4\f$ hold a value to three or four digits, while small weights pull gently. For
/// values along a boundary take `Dirichlet_boundary`.
///
/// A value at a point of a surface has no meaning for the differential equation: the finer the
/// space, the narrower the peak by which it is met.
class Point_constraints {
public:
  /// \param space must outlive this object
  explicit Point_constraints(const Spline_space_3& space) : m_space(&space) {}

  /// \throws Location_error if the location is not on the surface
  /// \throws Parameter_error if the weight is negative, or if a number is not finite
  void add(const Surface_location& location, double value, double weight) {
    const Triangulated_surface_3& surface = m_space->surface();
    if(location.face >= surface.number_of_faces())
      throw Location_error("there is no face " + std::to_string(location.face));
    if(!(weight >= 0 && std::isfinite(weight)))
      throw Parameter_error("constraint_weight", "must be a finite number that is not negative");
    if(!std::isfinite(value))
      throw Parameter_error("constraint_values", "has a value that is not a finite number");
    const int depth = m_space->depth();
    const auto [sheet, t] =
        m_space->locate(depth, surface.surface_point(location).point, location.face);
    if(sheet == m_space->octree().number_of_sheets(depth))
      throw Location_error("a constraint with face " + std::to_string(location.face) +
                           " is not on the surface");
    m_constraints.push_back({sheet, t, value, weight});
  }

  /// number of prescribed values
  std::size_t size() const { return m_constraints.size(); }

  /// adds to a matrix of the finest level that has the pattern of the stiffness matrix
  void add_to_matrix(Sparse_matrix& a) const {
    for(const Constraint& c : m_constraints) {
      const Cell_elements& elements = m_space->elements(m_space->depth(), c.sheet);
      const std::array<double, 27> b = values(c);
      for(int j = 0; j < 27; ++j)
        for(int i = 0; i < 27; ++i)
          if(elements[i] != Spline_space_3::no_element && elements[j] != Spline_space_3::no_element)
            a.coeffRef(elements[i], elements[j]) += c.weight * (b[i] * b[j]);
    }
  }

  /// `dimension()` entries
  Eigen::VectorXd load() const {
    Eigen::VectorXd load = Eigen::VectorXd::Zero(m_space->dimension());
    for(const Constraint& c : m_constraints) {
      const Cell_elements& elements = m_space->elements(m_space->depth(), c.sheet);
      const std::array<double, 27> b = values(c);
      for(int i = 0; i < 27; ++i)
        if(elements[i] != Spline_space_3::no_element)
          load[elements[i]] += c.weight * c.value * b[i];
    }
    return load;
  }

private:
  struct Constraint {
    std::size_t sheet;
    std::array<double, 3> t; // local coordinate in the cell
    double value, weight;
  };

  static std::array<double, 27> values(const Constraint& c) {
    const auto x = B_spline_1::values(c.t[0]), y = B_spline_1::values(c.t[1]),
               z = B_spline_1::values(c.t[2]);
    std::array<double, 27> b;
    for(int i = 0; i < 27; ++i)
      b[i] = x[i % 3] * y[i / 3 % 3] * z[i / 9];
    return b;
  }

  const Spline_space_3* m_space;
  std::vector<Constraint> m_constraints;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_POINT_CONSTRAINTS_H

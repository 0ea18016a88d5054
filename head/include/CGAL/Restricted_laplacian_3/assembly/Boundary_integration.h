// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_BOUNDARY_INTEGRATION_H
#define CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_BOUNDARY_INTEGRATION_H

#include <CGAL/Restricted_laplacian_3/basis/Tensor_basis_3.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_function_view.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_seams.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

namespace internal {

/// the sides of faces that are joined to no other face, see `Surface_seams`
std::vector<Face_side> boundary_sides(const Spline_space_3& space);

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Operators
/// Integrals over the boundary of a surface, or over a part \f$\Gamma\f$ of it.
///
/// The boundary consists of all sides of faces that are joined to no other face, see
/// `Surface_seams`. They are cut at the walls of the finest cells, and each piece has seven nodes.
/// These integrate polynomials of degree 13 exactly: products of two elements along a line have
/// degree 12. On a smooth surface the nodes lie on the curve over the side.
class Boundary_integration {
public:
  /// \ingroup PkgRestrictedLaplacian3Operators
  /// where a value of the function that is integrated counts
  struct Node {
    /// the sheet of the finest level
    std::size_t sheet;
    /// local coordinate in the cell, from 0 to 1, or on a smooth surface a little beyond
    std::array<double, 3> t;
    /// on the surface; the coordinate of the corner opposite to the side is 0
    Surface_location location;
    /// \f$\nu\f$, of unit length, tangential to the surface, points outward
    Vector_3 conormal;
    /// \f$D \nu\f$ with the diffusion of the space, \f$\nu\f$ without one
    Vector_3 flux_direction;
    /// a length
    double weight;
  };

  /// Integrates over the whole boundary. Takes time proportional to the number of faces.
  /// \param space is copied, which costs nothing
  /// \throws Numerical_error if a part of the boundary lies on no sheet; names the face
  explicit Boundary_integration(const Spline_space_3& space);

  /// Integrates over a part of the boundary.
  /// \param space is copied, which costs nothing
  /// \param contains is called with the middle of each side of a face that is at the boundary, and
  /// says whether the side belongs to \f$\Gamma\f$
  /// \throws Numerical_error as above
  Boundary_integration(const Spline_space_3& space,
                       const std::function<bool(const Surface_point&)>& contains);

  /// the length of \f$\Gamma\f$, 0 if there is no boundary
  double length() const { return m_length; }
  /// sorted by sheet
  const std::vector<Node>& nodes() const { return m_nodes; }
  /// the space
  const Spline_space_3& space() const { return m_space; }

  /// what a function is at the nodes
  /// \param g a function object that takes a `const Surface_point&` and returns a number
  /// \param name of the function, for the exception
  /// \throws Parameter_error if a value is not finite; names the face
  Eigen::VectorXd values(const Surface_function_view& g, const char* name) const;

  /// \f$\int_\Gamma h\, b_i\f$, `dimension()` entries: what a flux
  /// \f$\partial_\nu u = h\f$, or \f$\nu^T D\, \nabla u = h\f$, adds to the right-hand side of
  /// \f$S \eta = \dots\f$
  /// \param flux a function object that takes a `const Surface_point&` and returns a number
  /// \throws Parameter_error if a value is not finite; names the face
  Eigen::VectorXd load(const Surface_function_view& flux) const;

  /// \f$\int_\Gamma \nu\, b_i\f$: a row for each element, a column for each coordinate of
  /// \f$\nu\f$
  Eigen::MatrixXd conormal_loads() const;

  /// conormal derivatives \f$\partial_\nu b_i\f$, or \f$\nu^T D\, \nabla b_i\f$, of the elements
  /// of the cell at a node
  Tensor_basis_3::Values conormal_derivatives(const Node& node) const;
  /// the elements of the cell of a node
  const Cell_elements& elements(const Node& node) const {
    return m_space.elements(m_space.depth(), node.sheet);
  }

private:
  Surface_point middle(std::size_t face, int side) const;
  void add_side(std::size_t face, int side);
  void move_to_patch(std::size_t piece, int side, Node& node) const;
  void set_flux_directions();
  std::vector<Surface_point> points() const;
  std::size_t sheet_of_piece(const Surface_location& begin, const Surface_location& end) const;

  Spline_space_3 m_space;
  std::vector<Node> m_nodes;
  double m_length = 0;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/assembly/Boundary_integration_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_BOUNDARY_INTEGRATION_H

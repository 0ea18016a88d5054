// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_DIRICHLET_BOUNDARY_H
#define CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_DIRICHLET_BOUNDARY_H

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/integration/cell_integrals.h>
#include <CGAL/Restricted_laplacian_3/integration/surface_integration.h>
#include <CGAL/Restricted_laplacian_3/octree/internal/wall_crossings.h>
#include <CGAL/Restricted_laplacian_3/splines/B_spline_1.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_seams.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

namespace internal {

/// a side of a face: from corner `side` to corner `side + 1`, modulo 3
struct Face_side {
  std::size_t face;
  int side;
};

/// the sides of faces that are joined to no other face, see `Surface_seams`
inline std::vector<Face_side> boundary_sides(const Spline_space_3& space) {
  const Triangulated_surface_3& surface = space.surface();
  std::vector<Face_side> result;
  const double h = space.octree().cell_width(space.depth());
  const Surface_seams seams(surface, Octree_3::thin_face_height * h,
                            space.options().joining_tolerance);
  std::vector<std::uint32_t> number_of_sides(seams.number_of_seams(), 0);
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
    for(int side = 0; side < 3; ++side)
      ++number_of_sides[seams.seam(f, side)];
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
    for(int side = 0; side < 3; ++side)
      if(!surface.is_degenerate(f) && number_of_sides[seams.seam(f, side)] == 1)
        result.push_back({f, side});
  return result;
}

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Operators
/// Prescribes the values \f$u = g\f$ on the boundary of an open surface, by the symmetric method of
/// Nitsche. With the outward conormal \f$\nu\f$ (unit, tangential to the surface) it adds
/// \f[ A_{ij} = \int_{\partial \mathcal M} -\partial_\nu b_i\, b_j - b_i\, \partial_\nu b_j
///     + \beta\, b_i b_j, \qquad
///     \phi_i = \int_{\partial \mathcal M} g\, (\beta\, b_i - \partial_\nu b_i) \f]
/// to the stiffness matrix and to the right-hand side of \f$S \eta = \dots\f$. The solution of the
/// differential equation satisfies the discrete equations exactly (the method is consistent), so
/// the order of convergence is that of the space; values on the boundary are met up to the
/// discretisation error, not to rounding.
///
/// \f$\beta\f$ is \f$2 \lambda\f$, one for each sheet of the finest level, with the largest
/// \f$\lambda\f$ for which
/// \f$ \int_{\partial \mathcal M} (\partial_\nu u)^2 = \lambda \int \lvert \nabla u \rvert^2 \f$
/// on the sheet for some \f$u\f$: this makes \f$S + A\f$ positive semi-definite however the
/// boundary cuts the cells, and needs no parameter.
///
/// Where the boundary only clips a corner of a cell, \f$\lambda\f$ grows without limit and would
/// dominate all norms. There \f$\beta\f$ is at most `largest_penalty` over the cell width, and the
/// terms with \f$\partial_\nu\f$ are multiplied by \f$\sqrt{\beta / 2 \lambda}\f$, which keeps
/// the matrix positive semi-definite.
///
/// The boundary consists of all sides of faces that are joined to no other face, see
/// `Surface_seams`.
///
/// See J. Nitsche, "Ueber ein Variationsprinzip zur Loesung von Dirichlet-Problemen", 1971; the
/// choice of \f$\beta\f$: M. Griebel and M. A. Schweitzer, "A particle-partition of unity method,
/// part V: boundary conditions", 2003.
class Dirichlet_boundary {
public:
  /// upper bound of \f$\beta\f$ times the cell width of the finest level
  static constexpr double largest_penalty = 1000;

  /// Takes time proportional to the number of faces, and for each sheet at the boundary that of the
  /// eigenvalues of a 27 x 27 matrix.
  /// \param space must outlive this object
  /// \throws Parameter_error if the surface has no boundary
  explicit Dirichlet_boundary(const Spline_space_3& space) : m_space(&space) {
    for(const internal::Face_side& s : internal::boundary_sides(space))
      add_side(s.face, s.side);
    if(m_nodes.empty())
      throw Parameter_error("boundary_values", "are given, but the surface has no boundary");
    std::stable_sort(m_nodes.begin(), m_nodes.end(),
                     [](const Node& a, const Node& b) { return a.sheet < b.sheet; });
    for_each_sheet([this](std::size_t first, std::size_t last) { set_beta(first, last); });
  }

  /// length of the boundary
  double length() const { return m_length; }

  /// adds \f$A\f$ to a matrix of the finest level that has the pattern of the stiffness matrix
  void add_to_matrix(Sparse_matrix& a) const {
    for_each_sheet([&](std::size_t first, std::size_t last) {
      const Cell_elements& elements = m_space->elements(m_space->depth(), m_nodes[first].sheet);
      Eigen::Matrix<double, 27, 27> block;
      block.setZero();
      for(std::size_t k = first; k < last; ++k) {
        const auto [b, d] = values(m_nodes[k]);
        block += m_nodes[k].weight * (m_nodes[k].beta * b * b.transpose() -
                                      m_nodes[k].flux * (b * d.transpose() + d * b.transpose()));
      }
      for(int j = 0; j < 27; ++j)
        for(int i = 0; i < 27; ++i)
          if(elements[i] != Spline_space_3::no_element && elements[j] != Spline_space_3::no_element)
            a.coeffRef(elements[i], elements[j]) += block(i, j);
    });
  }

  /// \f$\phi\f$, `dimension()` entries
  /// \param g a function object that takes a `const Surface_point&` and returns a number
  template <class Function> Eigen::VectorXd load(const Function& g) const {
    Eigen::VectorXd load = Eigen::VectorXd::Zero(m_space->dimension());
    for(const Node& node : m_nodes) {
      const auto [b, d] = values(node);
      const double value =
          node.weight * static_cast<double>(g(m_space->surface().surface_point(node.location)));
      const Cell_elements& elements = m_space->elements(m_space->depth(), node.sheet);
      for(int i = 0; i < 27; ++i)
        if(elements[i] != Spline_space_3::no_element)
          load[elements[i]] += value * (node.beta * b[i] - node.flux * d[i]);
    }
    return load;
  }

  /// \f$ \int_{\partial \mathcal M} \nu\, b_i \f$ with the outward conormal \f$\nu\f$: a row for
  /// each element, a column for each coordinate of \f$\nu\f$
  Eigen::MatrixXd conormal_loads() const {
    Eigen::MatrixXd loads =
        Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(m_space->dimension()), 3);
    for(const Node& node : m_nodes) {
      const auto b = values(node).first;
      const Eigen::RowVector3d conormal(node.conormal.x(), node.conormal.y(), node.conormal.z());
      const Cell_elements& elements = m_space->elements(m_space->depth(), node.sheet);
      for(int i = 0; i < 27; ++i)
        if(elements[i] != Spline_space_3::no_element)
          loads.row(elements[i]) += node.weight * b[i] * conormal;
    }
    return loads;
  }

  /// \f$(\int_{\partial \mathcal M} (u - g)^2 / \mathrm{length})^{1/2}\f$
  template <class Function>
  double root_mean_square_error(const Eigen::VectorXd& coefficients, const Function& g) const {
    double sum = 0;
    for(const Node& node : m_nodes) {
      const auto b = values(node).first;
      const Cell_elements& elements = m_space->elements(m_space->depth(), node.sheet);
      double u = 0;
      for(int i = 0; i < 27; ++i)
        if(elements[i] != Spline_space_3::no_element)
          u += coefficients[elements[i]] * b[i];
      const double difference =
          u - static_cast<double>(g(m_space->surface().surface_point(node.location)));
      sum += node.weight * difference * difference;
    }
    return std::sqrt(sum / m_length);
  }

private:
  using Vector_27 = Eigen::Matrix<double, 27, 1>;
  // 7 nodes integrate degree 13, products of elements along a line have degree 12
  using Rule = boost::math::quadrature::gauss<double, 7>;

  struct Node {
    std::size_t sheet;
    std::array<double, 3> t; // local coordinate in the cell
    Surface_location location;
    Vector_3 conormal;
    double weight; // length
    double beta;
    double flux; // factor of the conormal derivative
  };

  /// cuts a side of a face at the walls of the finest cells
  void add_side(std::size_t face, int side) {
    const Octree_3& octree = m_space->octree();
    const Triangulated_surface_3& surface = m_space->surface();
    const int depth = octree.depth(), other = (side + 1) % 3;
    const Point_3 &p = surface.point(face, side), &q = surface.point(face, other);
    const std::vector<double> cuts = internal::wall_crossings(octree.grid_coordinates(depth, p),
                                                              octree.grid_coordinates(depth, q));
    const double length = std::sqrt((q - p).squared_length());
    if(length == 0)
      return;
    Node node;
    node.location.face = face;
    // the face lies to the left of its sides, seen from the tip of its normal
    node.conormal = CGAL::cross_product((q - p) / length, surface.normal(face));
    node.beta = node.flux = 0;
    const auto place = [&](double s) {
      node.location.barycentric.fill(0);
      node.location.barycentric[side] = 1 - s;
      node.location.barycentric[other] = s;
    };
    for(std::size_t i = 1; i < cuts.size(); ++i) {
      const double center = (cuts[i] + cuts[i - 1]) / 2, half = (cuts[i] - cuts[i - 1]) / 2;
      place(center);
      node.sheet = m_space->locate(depth, surface.surface_point(node.location).point, face).first;
      // a piece of rounding size at a corner of a cell may have lost its fragment
      if(half == 0 || node.sheet == octree.number_of_sheets(depth))
        continue;
      const Cell_3 cell = octree.cell(depth, node.sheet);
      const auto add = [&](double s, double weight) {
        place(center + half * s);
        const auto z = octree.grid_coordinates(depth, surface.surface_point(node.location).point);
        for(int axis = 0; axis < 3; ++axis)
          node.t[axis] = z[axis] - cell.index[axis];
        node.weight = weight * half * length;
        m_length += node.weight;
        m_nodes.push_back(node);
      };
      for(std::size_t k = 0; k < Rule::abscissa().size(); ++k) {
        add(Rule::abscissa()[k], Rule::weights()[k]);
        if(Rule::abscissa()[k] != 0)
          add(-Rule::abscissa()[k], Rule::weights()[k]);
      }
    }
  }

  /// values and conormal derivatives of the 27 elements of the cell at a node
  std::pair<Vector_27, Vector_27> values(const Node& node) const {
    const double h = m_space->octree().cell_width(m_space->depth());
    std::array<std::array<double, 3>, 3> b, d;
    for(int axis = 0; axis < 3; ++axis) {
      b[axis] = B_spline_1::values(node.t[axis]);
      d[axis] = B_spline_1::derivatives(node.t[axis]);
    }
    Vector_27 value, derivative;
    for(int i = 0; i < 27; ++i) {
      const int ix = i % 3, iy = i / 3 % 3, iz = i / 9;
      value[i] = b[0][ix] * b[1][iy] * b[2][iz];
      derivative[i] = (node.conormal.x() * d[0][ix] * b[1][iy] * b[2][iz] +
                       node.conormal.y() * b[0][ix] * d[1][iy] * b[2][iz] +
                       node.conormal.z() * b[0][ix] * b[1][iy] * d[2][iz]) /
                      h;
    }
    return {value, derivative};
  }

  template <class Visitor> void for_each_sheet(Visitor&& visit) const {
    for(std::size_t first = 0, last = 0; first < m_nodes.size(); first = last) {
      while(last < m_nodes.size() && m_nodes[last].sheet == m_nodes[first].sheet)
        ++last;
      visit(first, last);
    }
  }

  void set_beta(std::size_t first, std::size_t last) {
    // functions with less energy than this, relative, vanish on the sheet
    constexpr double relative_cutoff = 1e-10;
    Eigen::Matrix<double, 27, 27> boundary;
    boundary.setZero();
    for(std::size_t k = first; k < last; ++k) {
      const Vector_27 d = values(m_nodes[k]).second;
      boundary += m_nodes[k].weight * d * d.transpose();
    }
    Cell_moments moments;
    moments.clear();
    Cubature(*m_space).add_moments(m_nodes[first].sheet, moments);
    Cell_block block;
    stiffness_block(moments, block);
    const Eigen::MatrixXd energy = Eigen::Map<Eigen::Matrix<double, 27, 27>>(block.data());
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(energy);
    const double cutoff = relative_cutoff * solver.eigenvalues().maxCoeff();
    const Eigen::Index rank = (solver.eigenvalues().array() > cutoff).count();
    const Eigen::MatrixXd basis =
        solver.eigenvectors().rightCols(rank) *
        solver.eigenvalues().tail(rank).cwiseSqrt().cwiseInverse().asDiagonal();
    const Eigen::MatrixXd reduced = basis.transpose() * boundary * basis;
    // a sheet without energy, by underflow, gets the largest penalty and no flux
    const double lambda =
        rank == 0 ? std::numeric_limits<double>::infinity()
                  : Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(reduced, Eigen::EigenvaluesOnly)
                        .eigenvalues()
                        .maxCoeff();
    const double largest = largest_penalty / m_space->octree().cell_width(m_space->depth());
    const double beta = (std::min)(2 * lambda, largest);
    for(std::size_t k = first; k < last; ++k) {
      m_nodes[k].beta = beta;
      m_nodes[k].flux = beta < 2 * lambda ? std::sqrt(beta / (2 * lambda)) : 1;
    }
  }

  const Spline_space_3* m_space;
  std::vector<Node> m_nodes;
  double m_length = 0;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_DIRICHLET_BOUNDARY_H

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_ASSEMBLE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_ASSEMBLE_H

#include <CGAL/Restricted_laplacian_3/assembly/internal/Element_matrix_pattern.h>
#include <CGAL/Restricted_laplacian_3/assembly/internal/Operator_assembly.h>
#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/integration/cell_integrals.h>
#include <CGAL/Restricted_laplacian_3/integration/internal/Cell_load.h>
#include <CGAL/Restricted_laplacian_3/integration/surface_integration.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>
#include <CGAL/Restricted_laplacian_3/surface/internal/function_components.h>
#include <CGAL/Restricted_laplacian_3/surface/vector_fields.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Operators
/// Stiffness and mass matrix of one level. They have the same pattern.
struct Operators {
  /// \f$ S_{ij} = \int_{\mathcal M} \langle \nabla_{\mathcal M} b_i, \nabla_{\mathcal M} b_j\rangle
  /// \f$: symmetric positive semi-definite, minus the matrix \f$L\f$ of the paper (equation 5);
  /// without unit
  Sparse_matrix stiffness;
  /// \f$ M_{ij} = \int_{\mathcal M} b_i b_j \f$: symmetric positive semi-definite, in units of area
  Sparse_matrix mass;
};

/// \ingroup PkgRestrictedLaplacian3Solvers
/// The matrices to which `assemble_operators()` adds the stabilisation.
enum class Stabilized { stiffness_and_mass, stiffness };

// Matrices are exchanged in what follows, because a `SparseMatrix` of Eigen 3.4 is copied where
// another class would be moved.

namespace internal {

inline double checked_normal_stabilization(double c) {
  if(!(c >= 0 && std::isfinite(c)))
    throw Parameter_error("normal_stabilization",
                          "is " + std::to_string(c) +
                              ", but must be a finite number that is not negative");
  return c;
}

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Operators
/// Assembles stiffness and mass matrices of the levels from `coarsest` to `finest`, in this order,
/// in one pass over the surface.
///
/// The surface is integrated on the finest level of the octree only; the coarser levels follow from
/// the moments of the sheets, at a cost that does not depend on the number of triangles. Up to
/// rounding they are the Galerkin products \f$P^T A P\f$ of the finer ones, if the space is not
/// that of the paper.
///
/// *Stabilisation.* Restricted splines are nearly linearly dependent, because a function that
/// varies only along the normal hardly shows on the surface. With \f$c > 0\f$ the matrices are
/// \f[ S + \frac{c}{h} N, \qquad M + c\, h\, N, \qquad
///     N_{ij} = \sum_{\mathrm{sheets}} \int_{\mathrm{cell}} \nabla b_i^T A\, \nabla b_j, \f]
/// where the sum is over the sheets of the finest level of the octree, the integrals over the
/// volumes of their cells, \f$h\f$ is the width of these cells, whatever the level of the matrix,
/// and \f$A\f$ the average of \f$n n^T\f$ over the sheet (by area): a penalty on the derivative
/// along the normal. (On a sheet in a wall between cells, where the elements do not sum to 1 in the
/// volume, the integral is \f$h^3\f$ times the average of \f$(n \cdot \nabla b_i)(n \cdot \nabla
/// b_j)\f$ over the sheet.) Since \f$N 1 = 0\f$, constants remain in the kernel of the stiffness
/// matrix, and the entries of the mass matrix sum to the area. The error of the solution that it
/// causes is of the order of the discretisation error for \f$c\f$ from the order of 1 down to that
/// of
/// \f$h^2\f$. See J. Grande, C. Lehrenfeld, A. Reusken, *Analysis of a high-order trace finite
/// element method for PDEs on level set surfaces*, SIAM J. Numer. Anal. 56 (2018), and E. Burman,
/// P. Hansbo, M. G. Larson, A. Massing, *Cut finite element methods for partial differential
/// equations on embedded manifolds of arbitrary codimensions*, ESAIM: M2AN 52 (2018).
///
/// *Eigenvalue problems* are to be solved with the stiffness matrix alone stabilised. Combinations
/// of elements that vanish on the surface are then eigenvectors for the eigenvalue infinity. With
/// both matrices stabilised their eigenvalues are \f$1 / h^2\f$, amidst those that are looked for.
///
/// Takes time proportional to the number of fragments of triangles in cells, plus the number of
/// sheets; holds the matrices (about 75 entries in a row) and little else.
/// \param space the space whose elements are integrated
/// \param coarsest from 0, the coarsest, to the depth of the space
/// \param finest from 0, the coarsest, to the depth of the space; if it is below `coarsest`, the
/// result is empty
/// \param integration where the nodes of the integrals lie, for example `Cubature(space)`
/// \param normal_stabilization \f$c \ge 0\f$, without unit; 0 gives the operators of the paper
/// \param stabilized which of the matrices are stabilised
/// \tparam SurfaceIntegration a model of `SurfaceIntegration_3`: `Cubature` (exact) or
/// `Monte_carlo`
/// \throws Parameter_error if a level is not from 0 to depth, or if `normal_stabilization` is
/// negative or not finite
template <class SurfaceIntegration>
std::vector<Operators> assemble_operators(const Spline_space_3& space, int coarsest, int finest,
                                          const SurfaceIntegration& integration,
                                          double normal_stabilization = 0,
                                          Stabilized stabilized = Stabilized::stiffness_and_mass) {
  space.checked_level(coarsest);
  space.checked_level(finest);
  internal::checked_normal_stabilization(normal_stabilization);
  std::vector<Operators> operators;
  if(coarsest > finest)
    return operators;
  operators.resize(static_cast<std::size_t>(finest - coarsest) + 1);
  std::vector<internal::Assembly_targets> targets(space.depth() + 1);
  for(int level = coarsest; level <= finest; ++level) {
    Operators& o = operators[level - coarsest];
    internal::Element_matrix_pattern(space, level).zero_matrix().swap(o.stiffness);
    o.mass = o.stiffness;
    targets[level].stiffness = &o.stiffness;
    targets[level].mass = &o.mass;
  }
  internal::Operator_assembly<SurfaceIntegration>(space, integration, normal_stabilization,
                                                  stabilized == Stabilized::stiffness_and_mass,
                                                  std::move(targets));
  return operators;
}

/// \ingroup PkgRestrictedLaplacian3Operators
/// Stiffness and mass matrix of one level, at the cost of one of them.
template <class SurfaceIntegration>
Operators assemble_operators(const Spline_space_3& space, int level,
                             const SurfaceIntegration& integration, double normal_stabilization = 0,
                             Stabilized stabilized = Stabilized::stiffness_and_mass) {
  std::vector<Operators> of_level =
      assemble_operators(space, level, level, integration, normal_stabilization, stabilized);
  Operators result;
  result.stiffness.swap(of_level.front().stiffness);
  result.mass.swap(of_level.front().mass);
  return result;
}

/// \ingroup PkgRestrictedLaplacian3Operators
/// The same by cubature, without stabilisation.
inline Operators assemble_operators(const Spline_space_3& space, int level) {
  return assemble_operators(space, level, Cubature(space));
}

/// \ingroup PkgRestrictedLaplacian3Operators
/// The same on the finest level.
inline Operators assemble_operators(const Spline_space_3& space) {
  return assemble_operators(space, space.depth());
}

namespace internal {

/// The matrices \f$\beta S + \alpha M\f$ of the levels from `coarsest` to depth, coarsest first,
/// and the integrals of the elements of the finest level.
struct System_matrices {
  std::vector<Sparse_matrix> matrices;
  Eigen::VectorXd integrals;
};

/// In one pass over the surface; no matrices are formed whose factor is 0.
template <class SurfaceIntegration>
System_matrices assemble_system(const Spline_space_3& space, int coarsest,
                                const SurfaceIntegration& integration, double alpha,
                                double normal_stabilization, double beta = 1) {
  checked_normal_stabilization(normal_stabilization);
  const std::size_t number_of_levels = static_cast<std::size_t>(space.depth() - coarsest) + 1;
  System_matrices result;
  result.integrals = Eigen::VectorXd::Zero(space.dimension());
  result.matrices.resize(number_of_levels);
  std::vector<Sparse_matrix> mass(alpha != 0 && beta != 0 ? number_of_levels : 0);
  std::vector<Assembly_targets> targets(space.depth() + 1);
  for(std::size_t i = 0; i < number_of_levels; ++i) {
    const int level = coarsest + static_cast<int>(i);
    Element_matrix_pattern(space, level).zero_matrix().swap(result.matrices[i]);
    (beta != 0 ? targets[level].stiffness : targets[level].mass) = &result.matrices[i];
    if(!mass.empty()) {
      mass[i] = result.matrices[i];
      targets[level].mass = &mass[i];
    }
  }
  targets[space.depth()].element_integrals = &result.integrals;
  Operator_assembly<SurfaceIntegration>(space, integration, normal_stabilization, true,
                                        std::move(targets));
  // The patterns are the same, so values can be added without a merge.
  const double factor = beta != 0 ? beta : alpha;
  for(std::size_t i = 0; i < number_of_levels; ++i) {
    if(factor != 1)
      result.matrices[i].coeffs() *= factor;
    if(!mass.empty())
      result.matrices[i].coeffs() += alpha * mass[i].coeffs();
  }
  return result;
}

/// A stiffness matrix and \f$ \int_{\mathcal M} b_i \f$.
struct Stiffness_and_integrals {
  Sparse_matrix stiffness;
  Eigen::VectorXd integrals;
};

/// In one pass over the surface, without a mass matrix.
template <class SurfaceIntegration>
Stiffness_and_integrals assemble_stiffness_and_integrals(const Spline_space_3& space, int level,
                                                         const SurfaceIntegration& integration,
                                                         double normal_stabilization = 0) {
  space.checked_level(level);
  checked_normal_stabilization(normal_stabilization);
  Stiffness_and_integrals result = {Element_matrix_pattern(space, level).zero_matrix(),
                                    Eigen::VectorXd::Zero(space.dimension(level))};
  std::vector<Assembly_targets> targets(space.depth() + 1);
  targets[level].stiffness = &result.stiffness;
  targets[level].element_integrals = &result.integrals;
  Operator_assembly<SurfaceIntegration>(space, integration, normal_stabilization, true,
                                        std::move(targets));
  return result;
}

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Operators
/// The stiffness matrix of one level alone: no mass matrix is formed or held meanwhile.
/// \param space the space whose elements are integrated
/// \param level from 0, the coarsest, to the depth of the space
/// \param integration where the nodes of the integrals lie, for example `Cubature(space)`
/// \param normal_stabilization as in `assemble_operators()`; with \f$c > 0\f$ the matrix is
/// \f$S + \frac{c}{h} N\f$
/// \tparam SurfaceIntegration a model of `SurfaceIntegration_3`
/// \throws Parameter_error if the level is not from 0 to depth, or if `normal_stabilization` is
/// negative or not finite
template <class SurfaceIntegration>
Sparse_matrix assemble_stiffness_matrix(const Spline_space_3& space, int level,
                                        const SurfaceIntegration& integration,
                                        double normal_stabilization = 0) {
  internal::Stiffness_and_integrals result =
      internal::assemble_stiffness_and_integrals(space, level, integration, normal_stabilization);
  Sparse_matrix stiffness;
  stiffness.swap(result.stiffness);
  return stiffness;
}

/// \ingroup PkgRestrictedLaplacian3Operators
/// \f$ S_{ij} = \int_{\mathcal M} \langle \nabla_{\mathcal M} b_i, \nabla_{\mathcal M} b_j \rangle
/// \f$, positive semi-definite (minus the matrix \f$L\f$ of the paper, equation 5),
/// `dimension(level)` rows. Constants are in its kernel (not in the space of the paper, where the
/// surface comes within a cell of the boundary of the domain cube).
inline Sparse_matrix assemble_stiffness_matrix(const Spline_space_3& space, int level) {
  return assemble_stiffness_matrix(space, level, Cubature(space));
}
/// \ingroup PkgRestrictedLaplacian3Operators
/// The same on the finest level.
inline Sparse_matrix assemble_stiffness_matrix(const Spline_space_3& space) {
  return assemble_stiffness_matrix(space, space.depth());
}

/// \ingroup PkgRestrictedLaplacian3Operators
/// \f$ M_{ij} = \int_{\mathcal M} b_i b_j \f$, `dimension(level)` rows. Its entries sum to the
/// area.
inline Sparse_matrix assemble_mass_matrix(const Spline_space_3& space, int level) {
  Sparse_matrix mass;
  assemble_operators(space, level).mass.swap(mass);
  return mass;
}
/// \ingroup PkgRestrictedLaplacian3Operators
/// The same on the finest level.
inline Sparse_matrix assemble_mass_matrix(const Spline_space_3& space) {
  return assemble_mass_matrix(space, space.depth());
}

namespace internal {

/// Visits the nodes on a sheet of `level` through `visit(t, point, weight)`: local coordinate in
/// its cell; weight in units of the squared width of the finest cells.
/// \param degree of what is integrated
template <class SurfaceIntegration, class Visitor>
void for_each_node_of_level(const Spline_space_3& space, int level, std::size_t sheet,
                            const SurfaceIntegration& integration, int degree, Visitor&& visit) {
  const Octree_3& octree = space.octree();
  const int depth = octree.depth();
  std::vector<std::uint32_t> descendants(1, static_cast<std::uint32_t>(sheet)), next;
  for(int l = level; l < depth; ++l, descendants.swap(next)) {
    next.clear();
    for(std::uint32_t s : descendants)
      next.insert(next.end(), octree.children(l, s).begin(), octree.children(l, s).end());
  }
  const Cell_3 coarse = octree.cell(level, sheet);
  // local coordinate in the coarse cell: scale (t + offset)
  const double scale = std::ldexp(1., level - depth);
  for(std::uint32_t s : descendants) {
    const Cell_3 fine = octree.cell(depth, s);
    std::array<double, 3> offset;
    for(int axis = 0; axis < 3; ++axis)
      offset[axis] = fine.index[axis] - (coarse.index[axis] << (depth - level));
    for_each_sheet_node(
        integration, s, degree,
        [&](const std::array<double, 3>& t, const Surface_location& location, double weight) {
          visit(std::array<double, 3>{scale * (t[0] + offset[0]), scale * (t[1] + offset[1]),
                                      scale * (t[2] + offset[2])},
                octree.surface().surface_point(location), weight);
        });
  }
}

/// The vectors, columns of a matrix, that get from each sheet of `level` what
/// `loads_of_sheet(sheet)` returns for its elements, times `factor`. Sheets are computed on several
/// threads, and added in their order.
template <int K, class LoadsOfSheet>
Eigen::Matrix<double, Eigen::Dynamic, K> sum_loads(const Spline_space_3& space, int level,
                                                   double factor, LoadsOfSheet&& loads_of_sheet) {
  constexpr std::size_t grain = 256, sheets_at_once = 64 * grain;
  const std::size_t number_of_sheets = space.octree().number_of_sheets(level);
  Eigen::Matrix<double, Eigen::Dynamic, K> sums;
  sums.setZero(static_cast<Eigen::Index>(space.dimension(level)), K);
  std::vector<std::array<Cell_load::Load, K>> loads((std::min)(sheets_at_once, number_of_sheets));
  for(std::size_t first = 0; first < number_of_sheets; first += sheets_at_once) {
    const std::size_t last = (std::min)(first + sheets_at_once, number_of_sheets);
    parallel_for(space.options().is_parallel, first, last, grain,
                 [&](std::size_t begin, std::size_t end) {
                   for(std::size_t sheet = begin; sheet < end; ++sheet)
                     loads[sheet - first] = loads_of_sheet(sheet);
                 });
    for(std::size_t sheet = first; sheet < last; ++sheet) {
      const Cell_elements& elements = space.elements(level, sheet);
      for(int k = 0; k < K; ++k)
        for(int i = 0; i < 27; ++i)
          if(elements[i] != Spline_space_3::no_element)
            sums(elements[i], k) += factor * loads[sheet - first][k][i];
    }
  }
  return sums;
}

/// the same for one vector
template <class LoadOfSheet>
Eigen::VectorXd sum_loads(const Spline_space_3& space, int level, double factor,
                          LoadOfSheet&& load_of_sheet) {
  return sum_loads<1>(space, level, factor, [&](std::size_t sheet) {
    return std::array<Cell_load::Load, 1>{load_of_sheet(sheet)};
  });
}

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Operators
/// \f$ \phi_i = \int_{\mathcal M} f\, b_i \f$ (paper, equation 4), `dimension(level)` entries.
///
/// The Poisson problem \f$\Delta_{\mathcal M} u = f\f$ is \f$S \eta = -\phi\f$.
/// \param space the space whose elements are integrated
/// \param f a function object that takes a `const Surface_point&` and returns a number. Exact up to
/// rounding if it is a polynomial of degree at most 6 on each triangle, or of the degree that
/// `function_of_degree()` says.
/// It is called by several threads at once if `Spline_space_options::is_parallel` is set.
/// \param level from 0, the coarsest, to the depth of the space
/// \param integration where the nodes of the integrals lie, for example `Cubature(space)`
/// \tparam SurfaceIntegration a model of `SurfaceIntegration_3`
template <class Function, class SurfaceIntegration>
Eigen::VectorXd assemble_load(const Spline_space_3& space, const Function& f, int level,
                              const SurfaceIntegration& integration) {
  space.checked_level(level);
  const double h = space.octree().cell_width(space.depth());
  return internal::sum_loads(space, level, h * h, [&](std::size_t sheet) {
    internal::Cell_load moments;
    internal::for_each_node_of_level(
        space, level, sheet, integration, 6 + internal::degree_on_triangles(f),
        [&](const std::array<double, 3>& t, const Surface_point& p, double weight) {
          moments.add(t, weight * static_cast<double>(f(p)));
        });
    internal::Cell_load::Load values = {};
    moments.add_values_to(values);
    return values;
  });
}

/// \ingroup PkgRestrictedLaplacian3Operators
/// The same by cubature.
template <class Function>
Eigen::VectorXd assemble_load(const Spline_space_3& space, const Function& f, int level) {
  return assemble_load(space, f, level, Cubature(space));
}
/// \ingroup PkgRestrictedLaplacian3Operators
/// The same by cubature, on the finest level.
template <class Function>
Eigen::VectorXd assemble_load(const Spline_space_3& space, const Function& f) {
  return assemble_load(space, f, space.depth());
}

/// \ingroup PkgRestrictedLaplacian3Operators
/// The loads of all components of a function in one pass over the surface: \f$ \gamma_{ik} =
/// \int_{\mathcal M} f_k\, b_i \f$ (paper, section 5.3), a row for each element of `level`, a
/// column for each component.
/// \param space the space whose elements are integrated
/// \param f a function object that takes a `const Surface_point&` and returns a number, a
/// `std::array` of numbers, a vector of Eigen of a fixed size, or a 3D vector or point of \cgal;
/// all else as in `assemble_load()`
/// \param level from 0, the coarsest, to the depth of the space
/// \param integration where the nodes of the integrals lie, for example `Cubature(space)`
template <class Function, class SurfaceIntegration>
Eigen::MatrixXd assemble_component_loads(const Spline_space_3& space, const Function& f, int level,
                                         const SurfaceIntegration& integration) {
  constexpr int number = internal::Components_of<Function>::number;
  space.checked_level(level);
  const double h = space.octree().cell_width(space.depth());
  return internal::sum_loads<number>(space, level, h * h, [&](std::size_t sheet) {
    std::array<internal::Cell_load, number> moments;
    internal::for_each_node_of_level(
        space, level, sheet, integration, 6 + internal::degree_on_triangles(f),
        [&](const std::array<double, 3>& t, const Surface_point& p, double weight) {
          const auto value = internal::components_at(f, p);
          for(int k = 0; k < number; ++k)
            moments[k].add(t, weight * value[k]);
        });
    std::array<internal::Cell_load::Load, number> loads = {};
    for(int k = 0; k < number; ++k)
      moments[k].add_values_to(loads[k]);
    return loads;
  });
}

/// \ingroup PkgRestrictedLaplacian3Operators
/// The loads of all channels of a vector field in one pass over the surface: \f$ \gamma_{ik} =
/// \int_{\mathcal M} \langle v_k, \nabla_{\mathcal M} b_i \rangle \f$ (paper, equation 6), a row
/// for each element of `level`, a column for each channel. In units of \f$v\f$ times length.
///
/// The functions whose gradients are closest to \f$v_k\f$ solve \f$S \eta_k = \gamma_k\f$.
/// \param space the space whose elements are integrated
/// \param v a function object that takes a `const Surface_point&` and returns a 3D vector of \cgal,
/// a `std::array` of such vectors, or a matrix of Eigen of three rows and a fixed number of
/// columns; only the parts tangential to the face count. Exact up to rounding if it is a polynomial
/// of degree at most 6 on each triangle, or of the degree that `function_of_degree()` says. It is
/// called by several threads at once if `Spline_space_options::is_parallel` is set.
/// \param level from 0, the coarsest, to the depth of the space
/// \param integration where the nodes of the integrals lie, for example `Cubature(space)`
/// \tparam SurfaceIntegration a model of `SurfaceIntegration_3`
/// \throws Parameter_error if the level is not from 0 to depth, or if a value of `v` is not finite
template <class VectorField, class SurfaceIntegration>
Eigen::MatrixXd assemble_gradient_loads(const Spline_space_3& space, const VectorField& v,
                                        int level, const SurfaceIntegration& integration) {
  using Channels = internal::Channels_of<VectorField>;
  constexpr int number = Channels::number;
  space.checked_level(level);
  const double h = space.octree().cell_width(space.depth());
  const double coarse_h = space.octree().cell_width(level);
  return internal::sum_loads<number>(space, level, h * h / coarse_h, [&](std::size_t sheet) {
    std::array<std::array<internal::Cell_load, 3>, number> moments;
    // Derivatives of elements are of degree 5 on a plane.
    internal::for_each_node_of_level(
        space, level, sheet, integration, 5 + internal::degree_on_triangles(v),
        [&](const std::array<double, 3>& t, const Surface_point& p, double weight) {
          Eigen::Matrix<double, 3, number> value = Channels::read(v(p));
          if(!value.allFinite())
            throw Parameter_error("v", "has a value that is not a finite number in face " +
                                           std::to_string(p.face));
          const Eigen::Vector3d normal(p.normal.x(), p.normal.y(), p.normal.z());
          value -= normal * (normal.transpose() * value).eval();
          for(int k = 0; k < number; ++k)
            for(int axis = 0; axis < 3; ++axis)
              moments[k][axis].add(t, weight * value(axis, k));
        });
    std::array<internal::Cell_load::Load, number> loads = {};
    for(int k = 0; k < number; ++k)
      for(int axis = 0; axis < 3; ++axis)
        moments[k][axis].add_derivatives_to(axis, loads[k]);
    return loads;
  });
}

/// \ingroup PkgRestrictedLaplacian3Operators
/// The same by cubature, on the finest level.
template <class VectorField>
Eigen::MatrixXd assemble_gradient_loads(const Spline_space_3& space, const VectorField& v) {
  return assemble_gradient_loads(space, v, space.depth(), Cubature(space));
}

/// \ingroup PkgRestrictedLaplacian3Operators
/// The same for one channel: \f$ \gamma_i = \int_{\mathcal M} \langle v, \nabla_{\mathcal M} b_i
/// \rangle \f$, `dimension(level)` entries.
/// \param space the space whose elements are integrated
/// \param v a function object that takes a `const Surface_point&` and returns a 3D vector
/// \param level from 0, the coarsest, to the depth of the space
/// \param integration where the nodes of the integrals lie, for example `Cubature(space)`
template <class VectorField, class SurfaceIntegration>
Eigen::VectorXd assemble_gradient_load(const Spline_space_3& space, const VectorField& v, int level,
                                       const SurfaceIntegration& integration) {
  static_assert(internal::Channels_of<VectorField>::number == 1, "the field has several channels");
  return assemble_gradient_loads(space, v, level, integration);
}

/// \ingroup PkgRestrictedLaplacian3Operators
/// The same by cubature.
template <class VectorField>
Eigen::VectorXd assemble_gradient_load(const Spline_space_3& space, const VectorField& v,
                                       int level) {
  return assemble_gradient_load(space, v, level, Cubature(space));
}
/// \ingroup PkgRestrictedLaplacian3Operators
/// The same by cubature, on the finest level.
template <class VectorField>
Eigen::VectorXd assemble_gradient_load(const Spline_space_3& space, const VectorField& v) {
  return assemble_gradient_load(space, v, space.depth());
}

/// \ingroup PkgRestrictedLaplacian3Operators
/// \f$ \int_{\mathcal M} b_i \f$, `dimension(level)` entries: the load of the constant 1. The
/// surface integral of \f$\sum_i \eta_i b_i\f$ is its scalar product with \f$\eta\f$.
inline Eigen::VectorXd assemble_element_integrals(const Spline_space_3& space, int level) {
  return assemble_load(space, function_of_degree([](const Surface_point&) { return 1.; }, 0),
                       level);
}
/// \ingroup PkgRestrictedLaplacian3Operators
/// The same on the finest level.
inline Eigen::VectorXd assemble_element_integrals(const Spline_space_3& space) {
  return assemble_element_integrals(space, space.depth());
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_ASSEMBLE_H

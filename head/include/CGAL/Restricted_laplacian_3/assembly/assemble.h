// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_ASSEMBLE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_ASSEMBLE_H

#include <CGAL/Restricted_laplacian_3/assembly/Operator_sink.h>
#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/integration/Surface_integration.h>
#include <CGAL/Restricted_laplacian_3/integration/cubature.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_function_view.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <functional>
#include <optional>
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

/// \cond SKIP_IN_MANUAL
/// \ingroup PkgRestrictedLaplacian3Solvers
/// The matrices to which `assemble_operators()` adds the stabilization.
enum class Stabilized { stiffness_and_mass, stiffness };
/// \endcond

/// \ingroup PkgRestrictedLaplacian3Operators
/// Assembles stiffness and mass matrices of the levels from `coarsest` to `finest`, in this order,
/// in one pass over the surface.
///
/// The surface is integrated on the finest level of the octree only; the coarser levels follow from
/// the moments of the sheets, at a cost that does not depend on the number of triangles. Up to
/// rounding they are the Galerkin products \f$P^T A P\f$ of the finer ones, if the space is not
/// that of the paper.
///
/// *Stabilization.* Restricted splines are nearly linearly dependent, because a function that
/// varies only along the normal hardly shows on the surface. With \f$c > 0\f$ the matrices are
/// \f[ S + \frac{c}{h} N, \qquad M + c\, h\, N, \qquad
///     N_{ij} = \sum_{\mathrm{sheets}} \int_{\mathrm{cell}} \nabla b_i^T A\, \nabla b_j, \f]
/// where the sum is over the sheets of the finest level of the octree, the integrals over the
/// volumes of their cells, \f$h\f$ is the width of these cells, whatever the level of the matrix,
/// and
/// \f[ A = \min(1, a / a_0)\, \bigl(\overline{n n^T} + q\, \max(0, 1 - a / a_0)\, I\bigr),
///     \qquad a_0 = 0.03, \quad q = 0.1, \f]
/// with the average of \f$n n^T\f$ over the sheet (by area), whose area is \f$a\, h^2\f$: a penalty
/// on the derivative along the normal, and, where a cell has a tiny piece of the surface only, a
/// smaller one on the whole gradient, because functions hardly vary on such a piece. (On a sheet in
/// a wall between cells, where the elements do not sum to 1 in the volume, the integral is \f$h\f$
/// times that over the face of the cell; in several walls, the mean of such integrals.) Since
/// \f$N 1 = 0\f$, constants remain in the kernel of the stiffness matrix, and the entries of the
/// mass matrix sum to the area. The error of the solution that it causes is of the order of the
/// discretization error for \f$c\f$ from the order of 1 down to that of \f$h^2\f$. See J. Grande,
/// C. Lehrenfeld, A. Reusken, *Analysis of a high-order trace finite element method for PDEs on
/// level set surfaces*, SIAM J. Numer. Anal. 56 (2018), and E. Burman, P. Hansbo, M. G. Larson, A.
/// Massing, *Cut finite element methods for partial differential equations on embedded manifolds of
/// arbitrary codimensions*, ESAIM: M2AN 52 (2018).
///
/// *Eigenvalue problems* are to be solved with the stiffness matrix alone stabilized. Combinations
/// of elements that vanish on the surface are then eigenvectors for the eigenvalue infinity. With
/// both matrices stabilized their eigenvalues are \f$1 / h^2\f$, amid those that are looked for.
///
/// Takes time proportional to the number of fragments of triangles in cells, plus the number of
/// sheets; holds the matrices (about 75 entries in a row) and little else.
/// \param space the space whose elements are integrated
/// \param coarsest from 0, the coarsest, to the depth of the space
/// \param finest from 0, the coarsest, to the depth of the space; if it is below `coarsest`, the
/// result is empty
/// \param stabilization \f$c \ge 0\f$, without unit; 0 gives the operators of the paper
/// \param stabilized which of the matrices are stabilized
/// \param progress is told which part of the work is done, from 0 to 1; if it returns `false`, the
/// computation ends with an exception
/// \throws Parameter_error if a level is not from 0 to depth, or if `stabilization` is
/// negative or not finite
/// \throws Canceled if `progress` returned `false`
std::vector<Operators>
assemble_operators_of_levels(const Spline_space_3& space, int coarsest, int finest,
                             double stabilization = 0,
                             Stabilized stabilized = Stabilized::stiffness_and_mass,
                             const std::function<bool(double)>& progress = {});

/// \ingroup PkgRestrictedLaplacian3Operators
/// Stiffness and mass matrix of one level, at the cost of one of them.
/// \param space the space whose elements are integrated
/// \param level from 0, the coarsest, to the depth of the space; without a value the finest
/// \param stabilization,stabilized as in `assemble_operators_of_levels()`
/// \throws Parameter_error as there
Operators assemble_operators(const Spline_space_3& space, std::optional<int> level = {},
                             double stabilization = 0,
                             Stabilized stabilized = Stabilized::stiffness_and_mass);

/// \cond SKIP_IN_MANUAL
/// \ingroup PkgRestrictedLaplacian3Operators
/// Puts what `assemble_operators_of_levels()` adds up into storage of the caller's, block by block.
/// \param space the space whose elements are integrated
/// \param coarsest from 0, the coarsest, to the depth of the space
/// \param sinks one for each level from `coarsest` on, coarsest first; null pointers are left out
/// \param stabilization \f$c \ge 0\f$, without unit; 0 gives the operators of the paper
/// \param stabilized which of the matrices are stabilized
/// \param progress is told which part of the work is done, from 0 to 1; if it returns `false`, the
/// computation ends with an exception
/// \throws Parameter_error if a level is not from 0 to depth, or if `stabilization` is
/// negative or not finite
/// \throws Canceled if `progress` returned `false`
void assemble_into(const Spline_space_3& space, int coarsest,
                   const std::vector<Operator_sink*>& sinks, double stabilization = 0,
                   Stabilized stabilized = Stabilized::stiffness_and_mass,
                   const std::function<bool(double)>& progress = {});
/// \endcond

/// \ingroup PkgRestrictedLaplacian3Operators
/// \f$ S_{ij} = \int_{\mathcal M} \langle \nabla_{\mathcal M} b_i, \nabla_{\mathcal M} b_j \rangle
/// \f$, positive semi-definite (minus the matrix \f$L\f$ of the paper, equation 5),
/// `dimension(level)` rows. Constants are in its kernel (not in the space of the paper, where the
/// surface comes within a cell of the boundary of the domain cube). No mass matrix is formed or
/// held meanwhile.
/// \param space the space whose elements are integrated
/// \param level from 0, the coarsest, to the depth of the space; without a value the finest
/// \param stabilization as in `assemble_operators_of_levels()`; with \f$c > 0\f$ the matrix
/// is \f$S + \frac{c}{h} N\f$
/// \throws Parameter_error if the level is not from 0 to depth, or if `stabilization` is
/// negative or not finite
Sparse_matrix assemble_stiffness_matrix(const Spline_space_3& space, std::optional<int> level = {},
                                        double stabilization = 0);

/// \ingroup PkgRestrictedLaplacian3Operators
/// \f$ M_{ij} = \int_{\mathcal M} b_i b_j \f$, `dimension(level)` rows. Its entries sum to the
/// area. On the finest level if no level is given.
Sparse_matrix assemble_mass_matrix(const Spline_space_3& space, std::optional<int> level = {});

/// \ingroup PkgRestrictedLaplacian3Operators
/// \f$ \phi_i = \int_{\mathcal M} f\, b_i \f$ (paper, equation 4), `dimension(level)` entries.
///
/// The Poisson problem \f$\Delta_{\mathcal M} u = f\f$ is \f$S \eta = -\phi\f$.
/// \param space the space whose elements are integrated
/// \param f a function object that takes a `const Surface_point&` and returns a number. Exact up to
/// rounding if it is a polynomial of degree at most 6 on each triangle, or of the degree that
/// `function_of_degree()` says.
/// It is called by several threads at once if the space has `CGAL::Parallel_tag`.
/// \param level from 0, the coarsest, to the depth of the space; without a value the finest
/// \throws Parameter_error if the level is not from 0 to depth, or if a value of `f` is not finite
Eigen::VectorXd assemble_load(const Spline_space_3& space, const Surface_function_view& f,
                              std::optional<int> level = {});

/// \ingroup PkgRestrictedLaplacian3Operators
/// The loads of all components of a function in one pass over the surface: \f$ \gamma_{ik} =
/// \int_{\mathcal M} f_k\, b_i \f$ (paper, section 5.3), a row for each element of `level`, a
/// column for each component.
/// \param space the space whose elements are integrated
/// \param f a function object that takes a `const Surface_point&` and returns a number, a
/// `std::array` of numbers, a vector of Eigen of a fixed size, or a 3D vector or point of \cgal;
/// exact, and called by several threads, under the conditions of `assemble_load()`
/// \param level from 0, the coarsest, to the depth of the space; without a value the finest
Eigen::MatrixXd assemble_component_loads(const Spline_space_3& space,
                                         const Surface_function_view& f,
                                         std::optional<int> level = {});

/// \ingroup PkgRestrictedLaplacian3Operators
/// The loads of all channels of a vector field in one pass over the surface: \f$ \gamma_{ik} =
/// \int_{\mathcal M} \langle v_k, \nabla_{\mathcal M} b_i \rangle \f$ (paper, equation 6), a row
/// for each element of `level`, a column for each channel. In units of \f$v\f$ times length.
/// If the metrics \f$A\f$ of the integration are others than that of the surface, the loads are
/// \f$\int_{\mathcal M} v_k^T A\, \nabla b_i\f$; with \f$v_k = \nabla u\f$ they are always
/// \f$S u\f$.
///
/// The functions whose gradients are closest to \f$v_k\f$ solve \f$S \eta_k = \gamma_k\f$.
/// \param space the space whose elements are integrated
/// \param v a function object that takes a `const Surface_point&` and returns a 3D vector of \cgal,
/// a `std::array` of such vectors, or a matrix of Eigen of three rows and a fixed number of
/// columns; only the parts tangential to the face count. Exact up to rounding if it is a polynomial
/// of degree at most 6 on each triangle, or of the degree that `function_of_degree()` says. It is
/// called by several threads at once if the space has `CGAL::Parallel_tag`.
/// \param level from 0, the coarsest, to the depth of the space; without a value the finest
/// \throws Parameter_error if the level is not from 0 to depth, or if a value of `v` is not finite
Eigen::MatrixXd assemble_gradient_loads(const Spline_space_3& space, const Vector_field_view& v,
                                        std::optional<int> level = {});

/// \ingroup PkgRestrictedLaplacian3Operators
/// The load of a vector field of one channel, see `assemble_gradient_loads()`: \f$ \gamma_i =
/// \int_{\mathcal M} \langle v, \nabla_{\mathcal M} b_i \rangle \f$, `dimension(level)` entries.
Eigen::VectorXd assemble_gradient_load(const Spline_space_3& space, const Vector_field_view& v,
                                       std::optional<int> level = {});

/// \ingroup PkgRestrictedLaplacian3Operators
/// \f$ \int_{\mathcal M} b_i \f$, `dimension(level)` entries: the load of the constant 1. The
/// surface integral of \f$\sum_i \eta_i b_i\f$ is its scalar product with \f$\eta\f$.
Eigen::VectorXd assemble_element_integrals(const Spline_space_3& space,
                                           std::optional<int> level = {});

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/assembly/assemble_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_ASSEMBLE_H

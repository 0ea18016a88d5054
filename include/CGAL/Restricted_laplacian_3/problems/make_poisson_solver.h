// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MAKE_POISSON_SOLVER_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MAKE_POISSON_SOLVER_H

#include <CGAL/Restricted_laplacian_3/assembly/Dirichlet_boundary.h>
#include <CGAL/Restricted_laplacian_3/assembly/Point_constraints.h>
#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/assembly/shared/assemble_system.h>
#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/integration/Surface_integration.h>
#include <CGAL/Restricted_laplacian_3/problems/stabilization.h>
#include <CGAL/Restricted_laplacian_3/solvers/Poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

namespace internal {

/// The levels of a space as a multigrid hierarchy, for a system on its finest level.
/// \param coarse_matrices of the levels above the coarsest one of the hierarchy; may be empty
/// \param constant_loads what the matrix maps the constant 1 to
Poisson_solver poisson_solver(const Spline_space_3& space, Sparse_matrix&& a,
                              std::vector<Sparse_matrix> coarse_matrices,
                              const Eigen::VectorXd& integrals,
                              const Eigen::VectorXd& constant_loads,
                              const Poisson_solver_options& options);

/// with the matrices of all levels from one pass over the surface
/// \param constant_loads if not null, on return what the matrix maps the constant 1 to
/// \param mass if not null, on return the mass matrix without stabilization, or its upper half
/// \throws Parameter_error if the reaction or the stabilization is outside its domain
Poisson_solver elliptic_solver(const Spline_space_3& space, const Elliptic_operator& elliptic,
                               const Poisson_solver_options& options,
                               const Progress& progress = Progress(),
                               Eigen::VectorXd* constant_loads = nullptr,
                               Sparse_matrix* mass = nullptr);

/// The same with prescribed values: their matrices are known for the finest level only.
Poisson_solver constrained_solver(const Spline_space_3& space, const Elliptic_operator& elliptic,
                                  const Dirichlet_boundary* boundary,
                                  const Point_constraints* constraints,
                                  const Poisson_solver_options& options, const Progress& progress);

/// the levels from the coarsest of a hierarchy to depth
std::vector<Operators> multigrid_operators(const Spline_space_3& space, double stabilization);

/// \param operators those of the finest level, or of all levels of a hierarchy, coarsest first; the
/// patterns of a level may differ, for instance with a lumped mass matrix
Poisson_solver poisson_solver_of(const Spline_space_3& space, const Operators* operators,
                                 std::size_t number, double alpha,
                                 const Poisson_solver_options& options);

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Solvers
/// A `Poisson_solver` for \f$(S + \alpha M)\, \eta = b\f$ on the finest level of a space, which
/// assembles the matrices of all levels in one pass over the surface.
/// \param space the space; its prolongations and patches make the hierarchy
/// \param alpha screening weight, at least 0, in units of 1 / area
/// \param np optional named parameters:
/// \cgalNamedParamsBegin
///   \named_usual_stabilization
///   \named_of_solver{`1e-3`}
///   \named_progress
///   \named_concurrency_tag
/// \cgalNamedParamsEnd
/// \throws Parameter_error if a parameter is outside its domain
/// \throws Canceled if `progress` returned `false`
template <class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0>
Poisson_solver make_poisson_solver(const Spline_space_3& space, double alpha = 0,
                                   const NamedParameters& np = parameters::default_values()) {
  internal::Elliptic_operator elliptic;
  elliptic.reaction = alpha;
  elliptic.stabilization = internal::stabilization(space, np);
  return internal::elliptic_solver(space, elliptic, np, internal::progress_of(np));
}

/// \ingroup PkgRestrictedLaplacian3Solvers
/// A `Poisson_solver` for \f$(S + \alpha M)\, \eta = b\f$ on the finest level of a space, with
/// operators that were assembled before.
/// \param space the space; its prolongations and patches make the hierarchy
/// \param alpha screening weight, at least 0, in units of 1 / area
/// \param operators the matrices of the finest level of `space`
/// \param np optional named parameters:
/// \cgalNamedParamsBegin
///   \named_of_solver{`1e-3`}
///   \named_concurrency_tag
/// \cgalNamedParamsEnd
/// \throws Parameter_error if a parameter is outside its domain
template <class NamedParameters = parameters::Default_named_parameters>
Poisson_solver make_poisson_solver(const Spline_space_3& space, const Operators& operators,
                                   double alpha = 0,
                                   const NamedParameters& np = parameters::default_values()) {
  return internal::poisson_solver_of(space, &operators, 1, alpha, np);
}

/// \ingroup PkgRestrictedLaplacian3Solvers
/// Assembles the operators of all levels of a multigrid hierarchy on a space, coarsest first, for
/// solvers that differ by their screening weight: time steps of several lengths, for instance.
/// \param space the space
/// \param np optional named parameters:
/// \cgalNamedParamsBegin
///   \named_usual_stabilization
/// \cgalNamedParamsEnd
/// \throws Parameter_error if a parameter is outside its domain
template <class NamedParameters = parameters::Default_named_parameters>
std::vector<Operators>
multigrid_operators(const Spline_space_3& space,
                    const NamedParameters& np = parameters::default_values()) {
  return internal::multigrid_operators(space, internal::stabilization(space, np));
}

/// \ingroup PkgRestrictedLaplacian3Solvers
/// A `Poisson_solver` for \f$(S + \alpha M)\, \eta = b\f$ on the finest level of a space, with
/// operators of all levels: nothing is integrated, and no product of matrices formed.
/// \param space the space; its prolongations and patches make the hierarchy
/// \param operators the result of `multigrid_operators()` for this space
/// \param alpha screening weight, at least 0, in units of 1 / area
/// \param np optional named parameters:
/// \cgalNamedParamsBegin
///   \named_of_solver{`1e-3`}
///   \named_concurrency_tag
/// \cgalNamedParamsEnd
/// \throws Parameter_error if a parameter is outside its domain, or if the operators are not those
/// of the space
template <class NamedParameters = parameters::Default_named_parameters>
Poisson_solver make_poisson_solver(const Spline_space_3& space,
                                   const std::vector<Operators>& operators, double alpha = 0,
                                   const NamedParameters& np = parameters::default_values()) {
  return internal::poisson_solver_of(space, operators.data(), operators.size(), alpha, np);
}

/// \ingroup PkgRestrictedLaplacian3Solvers
/// A `Poisson_solver` for \f$A \eta = b\f$ on the finest level of a space, where \f$A\f$ is the
/// stiffness matrix with other matrices of its pattern added, such as those of `Dirichlet_boundary`
/// and `Point_constraints`.
/// \param space the space; its prolongations and patches make the hierarchy
/// \param a \f$A\f$; it is empty afterwards
/// \param element_integrals \f$\int b_i\f$
/// \param alpha number \f$\alpha\f$ for which \f$A\f$ contains \f$\alpha M\f$, in units of 1 / area
/// \param np optional named parameters:
/// \cgalNamedParamsBegin
///   \named_of_solver{`1e-3`}
///   \named_concurrency_tag
/// \cgalNamedParamsEnd
/// \throws Parameter_error if a parameter is outside its domain
Poisson_solver make_poisson_solver(const Spline_space_3& space, Sparse_matrix&& a,
                                   const Eigen::VectorXd& element_integrals, double alpha = 0,
                                   const Poisson_solver_options& np = {});

/// \ingroup PkgRestrictedLaplacian3Solvers
/// A `Poisson_solver` for \f$A \eta = b\f$ on the finest level of a space, with a copy of the
/// matrix.
/// \param space the space; its prolongations and patches make the hierarchy
/// \param a \f$A\f$: the stiffness matrix, with other matrices of its pattern added
/// \param element_integrals \f$\int b_i\f$
/// \param alpha number \f$\alpha\f$ for which \f$A\f$ contains \f$\alpha M\f$, in units of 1 / area
/// \param np optional named parameters:
/// \cgalNamedParamsBegin
///   \named_of_solver{`1e-3`}
///   \named_concurrency_tag
/// \cgalNamedParamsEnd
/// \throws Parameter_error if a parameter is outside its domain
Poisson_solver make_poisson_solver(const Spline_space_3& space, const Sparse_matrix& a,
                                   const Eigen::VectorXd& element_integrals, double alpha = 0,
                                   const Poisson_solver_options& np = {});

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/problems/make_poisson_solver_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MAKE_POISSON_SOLVER_H

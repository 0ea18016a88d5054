// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_POISSON_SOLVER_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_POISSON_SOLVER_H

#include <CGAL/Restricted_laplacian_3/assembly/Dirichlet_boundary.h>
#include <CGAL/Restricted_laplacian_3/assembly/Point_constraints.h>
#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/assembly/shared/assemble_system.h>
#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/problems/stabilization.h>
#include <CGAL/Restricted_laplacian_3/solvers/Multigrid_solver.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <Eigen/Core>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

namespace internal {

/// A system that a solver assembles: an operator, what is prescribed, and what is wanted beside.
struct Elliptic_system {
  Elliptic_operator elliptic;
  // Their matrices are added. They are known for the finest level only; without them, the matrices
  // of all levels come from one pass over the surface.
  const Dirichlet_boundary* boundary = nullptr;
  const Point_constraints* constraints = nullptr;
  // if not null, on return what the matrix without constraints maps the constant 1 to
  Eigen::VectorXd* constant_loads = nullptr;
  // if not null, on return the mass matrix without stabilization, or its upper half
  Sparse_matrix* mass = nullptr;
};

/// the levels of a space as a multigrid hierarchy, for matrices of its finest levels
Multigrid_solver multigrid_solver(const Spline_space_3& space, System_matrices&& system,
                                  const Poisson_solver_options& options);

/// \param operators those of the finest level, or of all levels of a hierarchy, coarsest first; the
/// patterns of a level may differ, for instance with a lumped mass matrix
Multigrid_solver multigrid_solver(const Spline_space_3& space, const Operators* operators,
                                  std::size_t number, double alpha,
                                  const Poisson_solver_options& options);

/// the levels from the coarsest of a hierarchy to depth
std::vector<Operators> multigrid_operators(const Spline_space_3& space, double stabilization);

template <class NamedParameters>
Elliptic_system screened_poisson_system(const Spline_space_3& space, double alpha,
                                        const NamedParameters& np) {
  Elliptic_system system;
  system.elliptic.reaction = alpha;
  system.elliptic.stabilization = stabilization(space, np);
  return system;
}

} // namespace internal

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
/// Solves \f$(S + \alpha M)\, \eta = b\f$ on the finest level of a space, for any number of
/// right-hand sides: a `Multigrid_solver` whose hierarchy is made of the prolongations and patches
/// of the space.
class Poisson_solver : public Multigrid_solver {
public:
  /// Assembles the matrices of all levels in one pass over the surface.
  /// \param space the space
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
  explicit Poisson_solver(const Spline_space_3& space, double alpha = 0,
                          const NamedParameters& np = parameters::default_values())
    : Poisson_solver(space, internal::screened_poisson_system(space, alpha, np),
                     Poisson_solver_options(np), internal::progress_of(np)) {}

  /// With operators that were assembled before.
  /// \param space the space
  /// \param operators the matrices of the finest level of `space`
  /// \param alpha screening weight, at least 0, in units of 1 / area
  /// \param options named parameters, or the options themselves:
  /// \cgalNamedParamsBegin
  ///   \named_of_solver{`1e-3`}
  ///   \named_concurrency_tag
  /// \cgalNamedParamsEnd
  /// \throws Parameter_error if a parameter is outside its domain
  Poisson_solver(const Spline_space_3& space, const Operators& operators, double alpha = 0,
                 const Poisson_solver_options& options = {})
    : Multigrid_solver(internal::multigrid_solver(space, &operators, 1, alpha, options)) {}

  /// With operators of all levels: nothing is integrated, and no product of matrices formed.
  /// \param space the space
  /// \param operators the result of `multigrid_operators()` for this space
  /// \param alpha screening weight, at least 0, in units of 1 / area
  /// \param options named parameters, or the options themselves:
  /// \cgalNamedParamsBegin
  ///   \named_of_solver{`1e-3`}
  ///   \named_concurrency_tag
  /// \cgalNamedParamsEnd
  /// \throws Parameter_error if a parameter is outside its domain, or if the operators are not
  /// those of the space
  Poisson_solver(const Spline_space_3& space, const std::vector<Operators>& operators,
                 double alpha = 0, const Poisson_solver_options& options = {})
    : Multigrid_solver(
          internal::multigrid_solver(space, operators.data(), operators.size(), alpha, options)) {}

  /// For \f$A \eta = b\f$, where \f$A\f$ is the stiffness matrix with other matrices of its pattern
  /// added, such as those of `Dirichlet_boundary` and `Point_constraints`.
  /// \param space the space
  /// \param a \f$A\f$, which is taken over and left empty
  /// \param element_integrals \f$\int b_i\f$
  /// \param alpha number \f$\alpha\f$ for which \f$A\f$ contains \f$\alpha M\f$, in units of 1 /
  /// area
  /// \param options named parameters, or the options themselves:
  /// \cgalNamedParamsBegin
  ///   \named_of_solver{`1e-3`}
  ///   \named_concurrency_tag
  /// \cgalNamedParamsEnd
  /// \throws Parameter_error if a parameter is outside its domain
  Poisson_solver(const Spline_space_3& space, Sparse_matrix&& a,
                 const Eigen::VectorXd& element_integrals, double alpha = 0,
                 const Poisson_solver_options& options = {});

  /// The same with a copy of `a`.
  Poisson_solver(const Spline_space_3& space, const Sparse_matrix& a,
                 const Eigen::VectorXd& element_integrals, double alpha = 0,
                 const Poisson_solver_options& options = {})
    : Poisson_solver(space, Sparse_matrix(a), element_integrals, alpha, options) {}

  /// \cond
  // Parameter_error if the reaction or the stabilization is outside its domain
  Poisson_solver(const Spline_space_3& space, const internal::Elliptic_system& system,
                 const Poisson_solver_options& options, const internal::Progress& progress = {});
  /// \endcond
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/problems/Poisson_solver_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_POISSON_SOLVER_H

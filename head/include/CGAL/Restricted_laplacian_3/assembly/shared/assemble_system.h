// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_SHARED_ASSEMBLE_SYSTEM_H
#define CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_SHARED_ASSEMBLE_SYSTEM_H

#include <CGAL/Restricted_laplacian_3/assembly/internal/Stored_entries.h>
#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/integration/Surface_integration.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_function_view.h>

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The elliptic operator \f$u \mapsto \alpha u - \beta \Delta u\f$, whose matrix is
/// \f$\beta S + M_\alpha\f$. A diffusion tensor is a matter of the integration, see
/// `Surface_material`.
struct Elliptic_operator {
  /// \f$\beta\f$
  double diffusion = 1;
  /// \f$\alpha\f$, unless it is a function
  double reaction = 0;
  /// \f$\alpha\f$ as a function on the surface
  std::optional<Surface_function_view> reaction_function;
  /// the name of \f$\alpha\f$ in errors
  const char* name_of_reaction = "alpha";
  /// factor \f$c\f$ of `assemble_operators()`
  double stabilization = 0;
};

/// The matrices of an elliptic operator on the levels from `coarsest` to depth, coarsest first.
struct System_matrices {
  std::vector<Sparse_matrix> matrices;
  /// \f$\int b_i\f$, for each element of the finest level
  Eigen::VectorXd integrals;
  /// \f$\int \alpha\, b_i\f$, for each element of the finest level: what \f$M_\alpha\f$ maps the
  /// constant 1 to
  Eigen::VectorXd constant_loads;
};

/// In one pass over the surface; one matrix is formed for each level.
/// \param stored a `Poisson_solver` needs the upper halves only, unless it forms Galerkin products
/// \param mass receives the mass matrix of the finest level without stabilization, or its upper
/// half; may be null
/// \throws Parameter_error if a value of \f$\alpha\f$ is negative or not finite (names the face),
/// or
/// \f$c\f$
System_matrices assemble_system(const Spline_space_3& space, int coarsest,
                                const Elliptic_operator& elliptic,
                                Stored_entries stored = Stored_entries::all,
                                const Progress& progress = Progress(),
                                Sparse_matrix* mass = nullptr);

/// \throws Parameter_error if the factor of the stabilization is negative or not finite
double checked_normal_stabilization(double c);

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/assembly/shared/assemble_system_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_SHARED_ASSEMBLE_SYSTEM_H

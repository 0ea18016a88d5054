// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_VERTEX_VALUES_H
#define CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_VERTEX_VALUES_H

#include <CGAL/Restricted_laplacian_3/distributed/Distributed_space.h>
#include <CGAL/Restricted_laplacian_3/distributed/Distributed_surface.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>

#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Distributed
/// The values of a function at the vertices of the slice of this rank, in their order. A value is
/// NaN where a vertex has no face, or only faces without area.
/// \param surface whose slices the vertices are in
/// \param space a space on it
/// \param coefficients of the elements of `Distributed_space::part()`
std::vector<double> values_at_vertices(const Distributed_surface& surface,
                                       const Distributed_space& space,
                                       const Eigen::VectorXd& coefficients);

/// \ingroup PkgRestrictedLaplacian3Distributed The mean over the surface of the function that is
/// linear in each triangle, or has a value at each point.
/// \param surface whose slices the vertices are in
/// \param values at the vertices of the slice of this rank, in their order; those of vertices
/// without a face of positive area do not count
/// \throws Distributed_error if there are not as many values as vertices on a rank
double surface_mean(const Distributed_surface& surface, const std::vector<double>& values);

/// \cond SKIP_IN_MANUAL
/// \ingroup PkgRestrictedLaplacian3Distributed
/// Values at the vertices of the surface of `Distributed_space::part()`, from those at the vertices
/// of the slices.
/// \param surface whose slices the vertices are in
/// \param space a space on it
/// \param values at the vertices of the slice of this rank, in their order
/// \throws Distributed_error if there are not as many values as vertices on a rank
std::vector<double> vertex_values_of_part(const Distributed_surface& surface,
                                          const Distributed_space& space,
                                          const std::vector<double>& values);
/// \endcond

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/distributed/vertex_values_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_VERTEX_VALUES_H

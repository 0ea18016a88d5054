// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_EVALUATION_MATRIX_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_EVALUATION_MATRIX_H

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>

#include <optional>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Functions
/// The matrix \f$E\f$ that takes the coefficients of a function to its values at the vertices,
/// \f$E_{vi} = b_i(x_v)\f$: a row for each vertex, in the order of `vertices(tm)`, with at most 27
/// entries, that sum to 1; none at vertices that have no face of positive area, for which
/// `Spline_function_3::values_at_vertices()` has NaN. A column for each element.
/// \param space the space
/// \param level from 0, the coarsest, to the depth of the space; without a value the finest
/// \throws Parameter_error if the level is not from 0 to depth
Sparse_matrix evaluation_matrix(const Spline_space_3& space, std::optional<int> level = {});

/// \ingroup PkgRestrictedLaplacian3Functions
/// The same for locations: a row for each.
/// \param space the space
/// \param locations on the surface
/// \param level as above
/// \throws Location_error if there is no such face, or if a location is not on the surface
/// \throws Parameter_error if the level is not from 0 to depth
Sparse_matrix evaluation_matrix(const Spline_space_3& space,
                                const std::vector<Surface_location>& locations,
                                std::optional<int> level = {});

/// \cond SKIP_IN_MANUAL
/// \ingroup PkgRestrictedLaplacian3Functions
/// The matrix that takes the coefficients of a function to its derivatives along an axis of space
/// at the vertices, see `Spline_jets`. Its rows, as in `evaluation_matrix()`, sum to 0.
/// \param space the space
/// \param axis 0, 1 or 2 for \f$x\f$, \f$y\f$ or \f$z\f$
/// \param level from 0, the coarsest, to the depth of the space; without a value the finest
/// \throws Parameter_error if the level is not from 0 to depth, or the axis not from 0 to 2
Sparse_matrix derivative_matrix(const Spline_space_3& space, int axis,
                                std::optional<int> level = {});
/// \endcond

/// \cond SKIP_IN_MANUAL
/// \ingroup PkgRestrictedLaplacian3Functions
/// The same for locations: a row for each.
/// \param space the space
/// \param axis as above
/// \param locations on the surface
/// \param level as above
/// \throws Location_error if there is no such face, or if a location is not on the surface
/// \throws Parameter_error as above
Sparse_matrix derivative_matrix(const Spline_space_3& space, int axis,
                                const std::vector<Surface_location>& locations,
                                std::optional<int> level = {});
/// \endcond

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/splines/evaluation_matrix_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_EVALUATION_MATRIX_H

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_SURFACE_SLICES_H
#define CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_SURFACE_SLICES_H

#include <CGAL/Restricted_laplacian_3/distributed/Communicator.h>
#include <CGAL/Restricted_laplacian_3/distributed/Distributed_surface.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <optional>
#include <string>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Distributed
/// The slices of a surface in a file that `read_mesh_file()` reads: of a binary PLY file of
/// triangles each rank reads its own one, any other file rank 0 reads for all.
/// \param communicator the ranks
/// \param file is there for all ranks
/// \throws Distributed_error on all ranks if one of them cannot read the file
Surface_slice read_surface_slice(const Communicator& communicator, const std::string& file);

/// \cond SKIP_IN_MANUAL
/// \ingroup PkgRestrictedLaplacian3Distributed
/// Each rank reads its slice of a binary PLY file of triangles: about as many vertices, and as many
/// faces, as the others. No rank holds more. Coordinates are `float` or `double`, the vertices of
/// faces lists of 3 numbers with at most 32 bits; what else vertices and faces have is skipped.
/// \param communicator the ranks
/// \param file is there for all ranks
/// \return no value, on all ranks, if the file is of another kind, for example a text file, or if
/// it has faces that are not triangles: then one rank can read it, see `slice_of_first_rank()`
/// \throws Distributed_error on all ranks if one of them cannot read the file
std::optional<Surface_slice> read_binary_ply_slice(const Communicator& communicator,
                                                   const std::string& file);
/// \endcond

/// \ingroup PkgRestrictedLaplacian3Distributed
/// Divides a surface that rank 0 has among all ranks.
/// \param communicator the ranks
/// \param surface what rank 0 has; a null pointer on the others
Surface_slice slice_of_first_rank(const Communicator& communicator,
                                  const Triangulated_surface_3* surface);

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/distributed/surface_slices_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_SURFACE_SLICES_H

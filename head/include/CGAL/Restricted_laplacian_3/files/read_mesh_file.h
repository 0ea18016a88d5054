// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FILES_READ_MESH_FILE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FILES_READ_MESH_FILE_H

#include <CGAL/Restricted_laplacian_3/files/File_error.h>
#include <CGAL/Restricted_laplacian_3/files/Vertex_property.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Functions
/// The mesh that a file holds, see `read_mesh_file()`.
struct Mesh_file {
  /// the vertices, in the order of the file
  std::vector<Point_3> points;
  /// the faces, in the order of the file; what
  /// `Triangulated_surface_3(std::move(points), std::move(triangles))` is made of. None if the file
  /// has points only.
  std::vector<Triangulated_surface_3::Triangle> triangles;
  /// how many faces of the file were no triangles, and are several in `triangles`
  std::size_t number_of_divided_faces = 0;
  /// what was passed over, a sentence each
  std::vector<std::string> warnings;
};

namespace internal {

// `.off` and the others, in lower case
std::vector<std::string> mesh_file_suffixes();

// the functions below; of a file
Mesh_file read_mesh_file(const std::string& file, const Progress& progress);
std::vector<Vertex_property> read_vertex_properties(const std::string& file,
                                                    const Progress& progress);
// of bytes that are in memory, as if they were in a file of that name
Mesh_file read_mesh_file(const std::string& file, std::string_view bytes);
std::vector<Vertex_property> read_vertex_properties(const std::string& file,
                                                    std::string_view bytes);

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Functions
/// Reads a file of a mesh, or of points:
///
/// | suffix | format |
/// | --- | --- |
/// | `.off` | OFF with all of its prefixes, text or binary |
/// | `.obj` | OBJ: vertices, faces and colors |
/// | `.ply` | PLY, text or binary of either order of bytes; also strips of triangles |
/// | `.stl` | STL, text or binary; equal points are one, in the order in which they are met |
/// | `.vtk` | legacy VTK of PolyData, text or binary |
/// | `.ts` | GOCAD TSurf |
/// | `.xyz` | points, with or without normals |
///
/// Nothing is repaired: nothing is merged (but in STL files, which have no indices), cut or turned,
/// and no vertex is left out. Faces that are not triangles are divided into triangles; they need be
/// neither plane nor convex.
///
/// A file is read in pieces, straight into the result: beside it a few megabytes are needed, and
/// for STL files about 10 bytes a vertex. So a hundred million triangles can be read. Takes time
/// linear in the length of the file.
///
/// \param file its name
/// \param np optional named parameters:
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{progress}
///     \cgalParamDescription{called on and on with the part of the file that is read, from 0 to 1;
///     returns `false` to end the work}
///     \cgalParamType{a function object `bool(double)`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throws File_error there is no such file, its suffix is none of these, or something is wrong
/// with it: the exception tells what, and where. Coordinates that are not finite are not wrong
/// here.
/// \throws Canceled `progress` returned `false`
template <class NamedParameters = parameters::Default_named_parameters>
Mesh_file read_mesh_file(const std::string& file,
                         const NamedParameters& np = parameters::default_values()) {
  return internal::read_mesh_file(file, internal::progress_of(np));
}

/// \ingroup PkgRestrictedLaplacian3Functions
/// Reads what a file of a mesh, or of points, has at its vertices: the properties of PLY files with
/// coordinates and without lists, the data at points of VTK files, normals, colors and places in
/// textures of OFF, OBJ and XYZ files. Nothing from other files.
/// \param file,np as for `read_mesh_file()`
/// \return them in the order of the file
/// \throws File_error,Canceled as `read_mesh_file()`
template <class NamedParameters = parameters::Default_named_parameters>
std::vector<Vertex_property>
read_vertex_properties(const std::string& file,
                       const NamedParameters& np = parameters::default_values()) {
  return internal::read_vertex_properties(file, internal::progress_of(np));
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/files/read_mesh_file_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FILES_READ_MESH_FILE_H

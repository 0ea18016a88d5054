// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FILES_READ_MESH_FILE_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FILES_READ_MESH_FILE_IMPL_H

#include <CGAL/Restricted_laplacian_3/files/internal/Byte_source.h>
#include <CGAL/Restricted_laplacian_3/files/internal/File_contents.h>
#include <CGAL/Restricted_laplacian_3/files/internal/Text_source.h>
#include <CGAL/Restricted_laplacian_3/files/internal/gocad_file.h>
#include <CGAL/Restricted_laplacian_3/files/internal/obj_file.h>
#include <CGAL/Restricted_laplacian_3/files/internal/off_file.h>
#include <CGAL/Restricted_laplacian_3/files/internal/ply_file.h>
#include <CGAL/Restricted_laplacian_3/files/internal/stl_file.h>
#include <CGAL/Restricted_laplacian_3/files/internal/vtk_file.h>
#include <CGAL/Restricted_laplacian_3/files/internal/xyz_file.h>
#include <CGAL/Restricted_laplacian_3/files/read_mesh_file.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/explain_out_of_memory.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/divide_polygon.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The formats by suffix.
struct File_format {
  const char* suffix;
  void (*read)(Byte_source& in, File_contents& contents);
};

inline const std::vector<File_format>& file_formats() {
  static const std::vector<File_format> formats = {
      {".off", [](Byte_source& in, File_contents& c) { Off_reader(in, c).read(); }},
      {".obj", [](Byte_source& in, File_contents& c) { Obj_reader(in, c).read(); }},
      {".ply", [](Byte_source& in, File_contents& c) { Ply_reader(in, c).read(); }},
      {".stl", [](Byte_source& in, File_contents& c) { Stl_reader(in, c).read(); }},
      {".vtk", [](Byte_source& in, File_contents& c) { Vtk_reader(in, c).read(); }},
      {".ts", [](Byte_source& in, File_contents& c) { Gocad_reader(in, c).read(); }},
      {".xyz", read_xyz}};
  return formats;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<std::string> mesh_file_suffixes() {
  std::vector<std::string> result;
  for(const File_format& format : file_formats())
    result.emplace_back(format.suffix);
  return result;
}

/// \throws File_error the suffix is not known
inline const File_format& file_format_of(const std::string& file) {
  const std::string suffix = lower(std::filesystem::path(file).extension().string());
  std::string known;
  for(const File_format& format : file_formats()) {
    if(suffix == format.suffix)
      return format;
    known += (known.empty() ? "" : ", ") + std::string(format.suffix);
  }
  throw File_error(
      file, {},
      (suffix.empty() ? "has no suffix" : "has the suffix " + suffix + ", which is not read") +
          "; known are " + known);
}

inline Mesh_file mesh_of(File_contents contents) {
  Mesh_file result;
  for(const std::vector<std::uint32_t>& polygon : contents.polygons) {
    result.number_of_divided_faces += polygon.size() > 3;
    for(const Triangulated_surface_3::Triangle& part : divided_polygon(contents.points, polygon))
      contents.triangles.push_back({polygon[part[0]], polygon[part[1]], polygon[part[2]]});
  }
  result.points = std::move(contents.points);
  result.triangles = std::move(contents.triangles);
  result.warnings = std::move(contents.warnings);
  return result;
}

inline File_contents read_contents(Byte_source& in, const File_format& format,
                                   bool wants_properties) {
  File_contents contents(wants_properties);
  explain_out_of_memory("not enough memory to read the file", [&] { format.read(in, contents); });
  return contents;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Mesh_file read_mesh_file(const std::string& file,
                                                            const Progress& progress) {
  const File_format& format = file_format_of(file);
  Byte_source in(file, progress);
  Mesh_file result = mesh_of(read_contents(in, format, false));
  progress(1);
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<Vertex_property>
read_vertex_properties(const std::string& file, const Progress& progress) {
  const File_format& format = file_format_of(file);
  Byte_source in(file, progress);
  std::vector<Vertex_property> result = read_contents(in, format, true).properties;
  progress(1);
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Mesh_file read_mesh_file(const std::string& file,
                                                            std::string_view bytes) {
  Byte_source in(file, bytes);
  return mesh_of(read_contents(in, file_format_of(file), false));
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<Vertex_property>
read_vertex_properties(const std::string& file, std::string_view bytes) {
  Byte_source in(file, bytes);
  return read_contents(in, file_format_of(file), true).properties;
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FILES_READ_MESH_FILE_IMPL_H

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_SURFACE_SLICES_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_SURFACE_SLICES_IMPL_H

#include <CGAL/Restricted_laplacian_3/distributed/surface_slices.h>
#include <CGAL/Restricted_laplacian_3/files/read_mesh_file.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// What the header of a binary PLY file of triangles says: where its numbers are.
class Ply_layout {
public:
  struct Number {
    std::size_t offset = 0, size = 0;
    bool is_real = false, is_signed = false;
  };

  /// half-open range of bytes
  std::size_t first_vertex = 0, vertex_size = 0, number_of_vertices = 0;
  std::size_t first_face = 0, face_size = 0, number_of_faces = 0;
  std::array<Number, 3> coordinates;
  Number count;                  // of the vertices of a face; the first of them follows
  std::array<Number, 3> corners; // of a face that is a triangle
  bool is_little_endian = true;

  /// no value if the file is none, or of another kind
  static std::optional<Ply_layout> read(std::istream& in) {
    Ply_layout result;
    std::string line, word;
    if(!std::getline(in, line) || trimmed(line) != "ply")
      return {};
    bool has_format = false, has_vertices = false, has_faces = false;
    std::size_t place = 0; // in the part after the header
    std::string element;
    std::size_t number = 0, size = 0, known = 0;
    const auto end_element = [&] {
      if(element == "vertex")
        result.vertex_size = size;
      else if(element == "face")
        result.face_size = size;
      place += number * size;
    };
    while(std::getline(in, line)) {
      std::istringstream words(trimmed(line));
      words >> word;
      if(word == "format") {
        words >> word;
        result.is_little_endian = word == "binary_little_endian";
        has_format = result.is_little_endian || word == "binary_big_endian";
      } else if(word == "element") {
        end_element();
        element.clear();
        if(!(words >> element >> number))
          return {};
        size = 0;
        if(element == "vertex") {
          has_vertices = true;
          result.first_vertex = place;
          result.number_of_vertices = number;
        } else if(element == "face") {
          has_faces = true;
          result.first_face = place;
          result.number_of_faces = number;
        }
      } else if(word == "property") {
        std::string type, name;
        words >> type;
        if(type == "list") {
          std::string of_count, of_items;
          words >> of_count >> of_items >> name;
          if(element != "face" || (name != "vertex_indices" && name != "vertex_index") ||
             !number_of(of_count, size, result.count))
            return {};
          size += result.count.size;
          for(Number& corner : result.corners) {
            if(!number_of(of_items, size, corner) || corner.is_real || corner.size > 4)
              return {};
            size += corner.size;
          }
          ++known;
          continue;
        }
        Number value;
        words >> name;
        if(!number_of(type, size, value))
          return {};
        for(int axis = 0; axis < 3 && element == "vertex"; ++axis)
          if(name == std::string(1, static_cast<char>('x' + axis))) {
            if(!value.is_real)
              return {};
            result.coordinates[axis] = value;
            ++known;
          }
        size += value.size;
      } else if(word == "end_header") {
        end_element();
        const auto header = static_cast<std::size_t>(in.tellg());
        result.first_vertex += header;
        result.first_face += header;
        if(has_format && has_vertices && has_faces && known == 4)
          return result;
        return {};
      }
    }
    return {};
  }

  double real(const char* bytes, const Number& number) const {
    return number.size == 4 ? value<float>(bytes, number) : value<double>(bytes, number);
  }
  std::int64_t integer(const char* bytes, const Number& number) const {
    switch(number.size) {
    case 1:
      return number.is_signed ? std::int64_t(value<std::int8_t>(bytes, number))
                              : std::int64_t(value<std::uint8_t>(bytes, number));
    case 2:
      return number.is_signed ? std::int64_t(value<std::int16_t>(bytes, number))
                              : std::int64_t(value<std::uint16_t>(bytes, number));
    default:
      return number.is_signed ? std::int64_t(value<std::int32_t>(bytes, number))
                              : std::int64_t(value<std::uint32_t>(bytes, number));
    }
  }

private:
  static std::string trimmed(std::string line) {
    while(!line.empty() && (line.back() == '\r' || line.back() == ' '))
      line.pop_back();
    return line;
  }

  static bool number_of(const std::string& type, std::size_t offset, Number& number) {
    static const std::map<std::string, Number> types = {
        {"char", {0, 1, false, true}},    {"int8", {0, 1, false, true}},
        {"uchar", {0, 1, false, false}},  {"uint8", {0, 1, false, false}},
        {"short", {0, 2, false, true}},   {"int16", {0, 2, false, true}},
        {"ushort", {0, 2, false, false}}, {"uint16", {0, 2, false, false}},
        {"int", {0, 4, false, true}},     {"int32", {0, 4, false, true}},
        {"uint", {0, 4, false, false}},   {"uint32", {0, 4, false, false}},
        {"float", {0, 4, true, true}},    {"float32", {0, 4, true, true}},
        {"double", {0, 8, true, true}},   {"float64", {0, 8, true, true}}};
    const auto it = types.find(type);
    if(it == types.end())
      return false;
    number = it->second;
    number.offset = offset;
    return true;
  }

  template <class T> T value(const char* bytes, const Number& number) const {
    std::array<char, sizeof(T)> copy;
    std::copy(bytes + number.offset, bytes + number.offset + sizeof(T), copy.begin());
    const std::uint16_t one = 1;
    const bool is_little = *reinterpret_cast<const char*>(&one) == 1;
    if(is_little != is_little_endian)
      std::reverse(copy.begin(), copy.end());
    T result;
    std::memcpy(&result, copy.data(), sizeof(T));
    return result;
  }
};

/// the part of `size` things that a rank has
inline std::array<std::size_t, 2> slice_range(std::size_t size, int rank, int ranks) {
  const auto of_rank = [&](int r) {
    return size / static_cast<std::size_t>(ranks) * static_cast<std::size_t>(r) +
           size % static_cast<std::size_t>(ranks) * static_cast<std::size_t>(r) /
               static_cast<std::size_t>(ranks);
  };
  return {of_rank(rank), of_rank(rank + 1)};
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::optional<Surface_slice>
read_binary_ply_slice(const Communicator& communicator, const std::string& file) {
  Surface_slice slice;
  int is_readable = 1;
  communicator.agree([&] {
    std::ifstream in(file, std::ios::binary);
    if(!in)
      throw Input_error("cannot open '" + file + "'");
    const std::optional<internal::Ply_layout> layout = internal::Ply_layout::read(in);
    if(!layout) {
      is_readable = 0;
      return;
    }
    // calls visit(bytes) for things of `size` bytes each, many at a time
    const auto for_each = [&](std::size_t start, std::size_t size, std::size_t number,
                              auto&& visit) {
      const auto [first, last] =
          internal::slice_range(number, communicator.rank(), communicator.size());
      constexpr std::size_t at_once = 1 << 16;
      std::vector<char> bytes(size * at_once);
      in.seekg(static_cast<std::streamoff>(start + size * first));
      for(std::size_t begin = first; begin < last; begin += at_once) {
        const std::size_t count = (std::min)(at_once, last - begin);
        if(!in.read(bytes.data(), static_cast<std::streamsize>(size * count)))
          throw Input_error("cannot read '" + file + "': it ends too early");
        for(std::size_t i = 0; i < count; ++i)
          visit(bytes.data() + size * i);
      }
    };
    for_each(layout->first_vertex, layout->vertex_size, layout->number_of_vertices,
             [&](const char* bytes) {
               std::array<double, 3> x;
               for(int axis = 0; axis < 3; ++axis)
                 x[axis] = layout->real(bytes, layout->coordinates[axis]);
               slice.points.emplace_back(x[0], x[1], x[2]);
             });
    for_each(layout->first_face, layout->face_size, layout->number_of_faces,
             [&](const char* bytes) {
               if(is_readable == 0 || layout->integer(bytes, layout->count) != 3) {
                 is_readable = 0;
                 return;
               }
               slice.triangles.emplace_back();
               for(int i = 0; i < 3; ++i)
                 slice.triangles.back()[i] =
                     static_cast<std::uint32_t>(layout->integer(bytes, layout->corners[i]));
             });
  });
  if(communicator.minimum(is_readable) == 0)
    return {};
  return slice;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Surface_slice
slice_of_first_rank(const Communicator& communicator, const Triangulated_surface_3* surface) {
  const auto ranks = static_cast<std::size_t>(communicator.size());
  std::vector<std::vector<Point_3>> points(ranks);
  std::vector<std::vector<Triangulated_surface_3::Triangle>> triangles(ranks);
  std::vector<std::vector<Vector_3>> normals(ranks);
  std::vector<std::vector<double>> areas(ranks);
  const bool is_first = communicator.rank() == 0;
  communicator.agree([&] {
    if(!is_first)
      return;
    for(std::size_t rank = 0; rank < ranks; ++rank) {
      const auto r = static_cast<int>(rank);
      const auto [first, last] =
          internal::slice_range(surface->number_of_vertices(), r, communicator.size());
      for(std::size_t v = first; v < last; ++v) {
        points[rank].push_back(surface->point(v));
        if(!surface->is_point_set())
          continue;
        normals[rank].push_back(surface->normal(v));
        areas[rank].push_back(surface->area(v));
      }
      const auto [first_face, last_face] = internal::slice_range(
          surface->is_point_set() ? 0 : surface->number_of_faces(), r, communicator.size());
      for(std::size_t f = first_face; f < last_face; ++f)
        triangles[rank].push_back(surface->triangle(f));
    }
  });
  Surface_slice slice;
  slice.points = communicator.exchange(points).front();
  slice.triangles = communicator.exchange(triangles).front();
  slice.normals = communicator.exchange(normals).front();
  slice.areas = communicator.exchange(areas).front();
  slice.is_point_set = communicator.maximum(is_first && surface->is_point_set() ? 1 : 0) == 1;
  return slice;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Surface_slice
read_surface_slice(const Communicator& communicator, const std::string& file) {
  if(std::optional<Surface_slice> slice = read_binary_ply_slice(communicator, file))
    return std::move(*slice);
  std::optional<Triangulated_surface_3> surface;
  communicator.agree([&] {
    if(communicator.rank() != 0)
      return;
    Mesh_file mesh = read_mesh_file(file);
    surface.emplace(std::move(mesh.points), std::move(mesh.triangles));
  });
  return slice_of_first_rank(communicator, surface ? &*surface : nullptr);
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_SURFACE_SLICES_IMPL_H

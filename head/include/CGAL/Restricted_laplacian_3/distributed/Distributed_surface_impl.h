// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_DISTRIBUTED_SURFACE_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_DISTRIBUTED_SURFACE_IMPL_H

#include <CGAL/Restricted_laplacian_3/distributed/Distributed_surface.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/octree/Octree_3.h>
#include <CGAL/Restricted_laplacian_3/octree/shared/Faces_in_coarse_cells.h>
#include <CGAL/Restricted_laplacian_3/octree/shared/Octree_builder.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Distributed_surface::Distributed_surface(const Communicator& communicator, Surface_slice slice)
  : m_communicator(communicator),
    m_is_point_set(communicator.maximum(slice.is_point_set ? 1 : 0) == 1) {
  const std::size_t size = slice.points.size();
  if(m_is_point_set) {
    slice.triangles.resize(size);
    slice.normals.resize(size);
    slice.areas.resize(size);
  }
  m_first_vertices = communicator.offsets(size);
  const std::vector<std::uint64_t> first_faces = communicator.offsets(slice.triangles.size());
  m_number_of_faces = first_faces.back();
  std::vector<Vertex_record> vertices;
  std::vector<Face_record> faces;
  std::vector<std::vector<std::uint32_t>> wanted(static_cast<std::size_t>(communicator.size()));
  communicator.agree([&] {
    if(m_number_of_faces == 0)
      throw m_is_point_set ? Empty_surface_error("the point set has no point")
                           : Empty_surface_error();
    internal::check_size_of_surface(static_cast<std::size_t>(m_first_vertices.back()),
                                    static_cast<std::size_t>(m_number_of_faces));
    faces = own_faces(slice, first_faces[static_cast<std::size_t>(communicator.rank())]);
    wanted = far_vertices(faces);
    vertices = own_vertices(slice);
  });
  m_points = std::move(slice.points);
  const std::uint32_t first_vertex = this->first_vertex();
  const auto answers =
      communicator.ask(wanted, [&](std::uint32_t v) { return vertices[v - first_vertex]; });
  for(const auto& list : answers)
    vertices.insert(vertices.end(), list.begin(), list.end());
  find_box(faces, vertices);
  communicator.agree([&] {
    if(m_low == m_high)
      throw m_is_point_set
          ? Zero_area_error("the point set has area zero: all of its " +
                            std::to_string(m_number_of_faces) + " points are the same")
          : Zero_area_error(static_cast<std::size_t>(m_number_of_faces));
    m_slice.push_back(make_part(faces, std::move(vertices)));
  });
  find_area();
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::uint32_t Distributed_surface::first_vertex() const {
  return static_cast<std::uint32_t>(
      m_first_vertices[static_cast<std::size_t>(m_communicator.rank())]);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<Distributed_surface::Face_record>
Distributed_surface::own_faces(const Surface_slice& slice, std::uint64_t first_face) const {
  std::vector<Face_record> result;
  for(std::size_t i = 0; i < slice.triangles.size(); ++i) {
    Triangulated_surface_3::Triangle t = slice.triangles[i];
    if(m_is_point_set)
      t.fill(first_vertex() + static_cast<std::uint32_t>(i));
    for(std::uint32_t v : t)
      if(v >= m_first_vertices.back())
        throw Invalid_face_error(static_cast<std::size_t>(first_face) + i,
                                 "names a vertex that does not exist");
    result.push_back({static_cast<std::uint32_t>(first_face + i), t});
  }
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<Distributed_surface::Vertex_record>
Distributed_surface::own_vertices(const Surface_slice& slice) const {
  std::vector<Vertex_record> result;
  for(std::size_t i = 0; i < slice.points.size(); ++i) {
    const std::uint32_t vertex = first_vertex() + static_cast<std::uint32_t>(i);
    Vector_3 normal(0, 0, 0);
    double area = 0;
    if(m_is_point_set) {
      internal::check_oriented_point(vertex, slice.points[i], slice.normals[i]);
      normal = internal::unit_vector(slice.normals[i]);
      area = slice.areas[i];
      if(!(area >= 0 && std::isfinite(area)))
        throw Invalid_point_error(vertex, "has an area that is negative or not a finite number");
    }
    result.push_back({vertex, slice.points[i], normal, area});
  }
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<std::vector<std::uint32_t>>
Distributed_surface::far_vertices(const std::vector<Face_record>& faces) const {
  std::vector<std::uint32_t> far;
  const std::uint32_t first = first_vertex();
  const std::uint64_t last = m_first_vertices[static_cast<std::size_t>(m_communicator.rank()) + 1];
  for(const Face_record& face : faces)
    for(std::uint32_t v : face.vertices)
      if(v < first || v >= last)
        far.push_back(v);
  std::sort(far.begin(), far.end());
  far.erase(std::unique(far.begin(), far.end()), far.end());
  std::vector<std::vector<std::uint32_t>> result(static_cast<std::size_t>(m_communicator.size()));
  for(std::uint32_t v : far) {
    const auto after = std::upper_bound(m_first_vertices.begin(), m_first_vertices.end(), v);
    result[static_cast<std::size_t>(after - m_first_vertices.begin()) - 1].push_back(v);
  }
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
Distributed_surface::find_box(const std::vector<Face_record>& faces,
                              const std::vector<Vertex_record>& vertices) {
  const double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 3> low = {infinity, infinity, infinity},
                        high = {-infinity, -infinity, -infinity};
  const std::uint32_t first = first_vertex();
  // far vertices are in ascending order, too: ranks are
  const auto vertex_record = [&](std::uint32_t v) -> const Vertex_record& {
    if(v >= first && v < first + m_points.size())
      return vertices[v - first];
    return *std::lower_bound(
        vertices.begin() + static_cast<std::ptrdiff_t>(m_points.size()), vertices.end(), v,
        [](const Vertex_record& record, std::uint32_t w) { return record.vertex < w; });
  };
  m_communicator.agree([&] {
    for(const Face_record& face : faces)
      for(std::uint32_t v : face.vertices)
        for(int axis = 0; axis < 3; ++axis) {
          const double x = vertex_record(v).point[axis];
          if(!std::isfinite(x))
            throw Invalid_vertex_error(v, "has a coordinate that is not a finite number");
          low[axis] = (std::min)(low[axis], x);
          high[axis] = (std::max)(high[axis], x);
        }
  });
  for(int axis = 0; axis < 3; ++axis) {
    low[axis] = m_communicator.minimum(low[axis]);
    high[axis] = m_communicator.maximum(high[axis]);
  }
  m_low = Point_3(low[0], low[1], low[2]);
  m_high = Point_3(high[0], high[1], high[2]);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void Distributed_surface::find_area() {
  const bool is_empty = slice().faces.empty();
  m_area = m_communicator.sum(is_empty ? 0. : slice().surface.area());
  m_number_of_degenerate_faces = m_communicator.sum(
      static_cast<std::uint64_t>(is_empty ? 0 : slice().surface.number_of_degenerate_faces()));
  m_communicator.agree([&] {
    if(!(m_area > 0))
      throw m_is_point_set
          ? Zero_area_error("the point set has area zero: all of its " +
                            std::to_string(m_number_of_faces) + " points have area zero")
          : Zero_area_error(static_cast<std::size_t>(m_number_of_faces));
    if(!std::isfinite(m_area))
      throw Parameter_error("area_map", "has values whose sum is not a finite number");
  });
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Surface_part Distributed_surface::make_part(
    const std::vector<Face_record>& faces, std::vector<Vertex_record> vertices) const {
  std::sort(vertices.begin(), vertices.end(),
            [](const Vertex_record& a, const Vertex_record& b) { return a.vertex < b.vertex; });
  vertices.erase(std::unique(vertices.begin(), vertices.end(),
                             [](const Vertex_record& a, const Vertex_record& b) {
                               return a.vertex == b.vertex;
                             }),
                 vertices.end());
  internal::Part_of_surface part;
  part.is_point_set = m_is_point_set;
  part.low = m_low;
  part.high = m_high;
  std::vector<std::uint32_t> numbers, numbers_of_faces;
  for(const Vertex_record& vertex : vertices) {
    numbers.push_back(vertex.vertex);
    part.points.push_back(vertex.point);
    if(!m_is_point_set)
      continue;
    part.normals.push_back(vertex.normal);
    part.areas.push_back(vertex.area);
  }
  for(const Face_record& face : faces) {
    numbers_of_faces.push_back(face.face);
    part.triangles.emplace_back();
    for(int i = 0; i < 3; ++i)
      part.triangles.back()[i] = static_cast<std::uint32_t>(
          std::lower_bound(numbers.begin(), numbers.end(), face.vertices[i]) - numbers.begin());
  }
  if(faces.empty()) {
    part.points.assign(1, m_low);
    part.triangles.assign(1, {0, 0, 0});
    numbers.clear();
    if(m_is_point_set) {
      part.normals.assign(1, Vector_3(0, 0, 1));
      part.areas.assign(1, 0);
    }
  }
  return {Triangulated_surface_3(std::move(part)), std::move(numbers_of_faces), std::move(numbers)};
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Rank_ranges
Distributed_surface::balanced_ranges(const Octree_3& octree) const {
  // What the unknowns of as much surface as the side of a cell count for: a choice. They take most
  // of the time, unless there are very many triangles in a cell.
  constexpr double fragments_of_cell_area = 50;
  const int level = Rank_ranges::level_of_ranges(octree.depth());
  std::vector<std::uint64_t> weights;
  m_communicator.agree([&] {
    weights.resize(std::size_t(1) << 3 * level);
    if(slice().faces.empty())
      return;
    const internal::Grid_vertices vertices =
        internal::Octree_builder::vertices(octree, slice().surface);
    const internal::Faces_in_coarse_cells faces(slice().surface, vertices, level, 0);
    for(std::size_t face = 0; face < faces.number_of_faces(); ++face) {
      double count = 0;
      faces.for_each_cell(face, [&](std::uint64_t) { ++count; });
      // whole numbers have the same sum in any order
      const double weight = faces.estimated_number_of_fragments(face) +
                            fragments_of_cell_area * faces.relative_area(face);
      const auto of_cell = static_cast<std::uint64_t>(std::ceil(16 * weight / count));
      faces.for_each_cell(face, [&](std::uint64_t cell) { weights[cell] += of_cell; });
    }
  });
  m_communicator.sum(weights);
  return Rank_ranges(level, weights, static_cast<std::size_t>(m_communicator.size()));
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Surface_part Distributed_surface::part(const Octree_3& octree,
                                                                          const Rank_ranges& ranges,
                                                                          double margin) const {
  const std::size_t size = static_cast<std::size_t>(m_communicator.size());
  std::vector<std::vector<Face_record>> faces(size);
  std::vector<std::vector<Vertex_record>> vertices(size);
  m_communicator.agree([&] {
    const Triangulated_surface_3& surface = slice().surface;
    const internal::Grid_vertices grid = internal::Octree_builder::vertices(octree, surface);
    const internal::Faces_in_coarse_cells in_cells(surface, grid, ranges.level(), margin);
    std::vector<std::vector<std::uint32_t>> vertices_of_rank(size);
    std::vector<std::size_t> ranks;
    for(std::size_t i = 0; i < slice().faces.size(); ++i) {
      ranks.clear();
      in_cells.for_each_cell(
          i, [&](std::uint64_t cell) { ranks.push_back(ranges.owner(ranges.level(), cell)); });
      std::sort(ranks.begin(), ranks.end());
      ranks.erase(std::unique(ranks.begin(), ranks.end()), ranks.end());
      Face_record face = {slice().faces[i], surface.triangle(i)};
      for(std::uint32_t& v : face.vertices)
        v = slice().vertices[v];
      for(std::size_t rank : ranks) {
        faces[rank].push_back(face);
        const auto& t = surface.triangle(i);
        vertices_of_rank[rank].insert(vertices_of_rank[rank].end(), t.begin(), t.end());
      }
    }
    for(std::size_t rank = 0; rank < size; ++rank) {
      std::vector<std::uint32_t>& of_rank = vertices_of_rank[rank];
      std::sort(of_rank.begin(), of_rank.end());
      of_rank.erase(std::unique(of_rank.begin(), of_rank.end()), of_rank.end());
      for(std::uint32_t v : of_rank)
        vertices[rank].push_back({slice().vertices[v], surface.point(v),
                                  m_is_point_set ? surface.normal(v) : Vector_3(0, 0, 0),
                                  m_is_point_set ? surface.area(v) : 0});
    }
  });
  std::vector<Face_record> my_faces;
  std::vector<Vertex_record> my_vertices;
  for(const auto& list : m_communicator.exchange(faces))
    my_faces.insert(my_faces.end(), list.begin(), list.end());
  for(const auto& list : m_communicator.exchange(vertices))
    my_vertices.insert(my_vertices.end(), list.begin(), list.end());
  std::vector<Surface_part> result;
  m_communicator.agree([&] { result.push_back(make_part(my_faces, std::move(my_vertices))); });
  return std::move(result.front());
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_DISTRIBUTED_SURFACE_IMPL_H

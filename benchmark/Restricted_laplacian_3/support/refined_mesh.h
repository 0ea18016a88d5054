// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_BENCHMARK_REFINED_MESH_H
#define RESTRICTED_LAPLACIAN_3_BENCHMARK_REFINED_MESH_H

// Large meshes: each triangle of a mesh divided into n^2, on its smooth patch.

#include "meshes.h"

#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/Surface_edges.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace benchmarks {

using Position = std::array<float, 3>;

/// The triangles of a face are named by places (i, j), 0 <= i, j and i + j <= N: the point of
/// barycentric coordinates (N - i - j, i, j) / N.
class Refined_mesh {
public:
  Refined_mesh(const RL::Triangulated_surface_3& surface, std::uint32_t n)
    : m_surface(surface), m_edges(surface), m_n(n), m_edge_of_side(surface.number_of_faces()) {
    m_on_edges.reserve(m_edges.size() * (n - 1));
    for(std::size_t edge = 0; edge < m_edges.size(); ++edge) {
      for(const auto& side : m_edges.sides(edge))
        m_edge_of_side[side.face][side.number] = static_cast<std::uint32_t>(edge);
      // the same points for all faces at the edge: those of the first one
      const auto side = m_edges.sides(edge).front();
      const bool is_reversed = surface.triangle(side.face)[side.number] != m_edges.ends(edge)[0];
      for(std::uint32_t k = 1; k < n; ++k) {
        std::array<std::uint32_t, 3> place = {0, 0, 0};
        place[side.number] = is_reversed ? k : n - k;
        place[(side.number + 1) % 3] = n - place[side.number];
        m_on_edges.push_back(evaluate(side.face, place));
      }
    }
    const std::size_t size = number_of_vertices();
    if(size > (std::numeric_limits<std::uint32_t>::max)())
      throw std::runtime_error("there would be more than 2^32 vertices");
  }

  std::size_t number_of_vertices() const {
    return m_surface.number_of_vertices() + m_edges.size() * (m_n - 1) +
           m_surface.number_of_faces() * inside_a_face();
  }
  std::size_t number_of_triangles() const { return m_surface.number_of_faces() * m_n * m_n; }

  // calls visit(position) for the vertices in the order of their numbers
  template <class Visitor> void visit_vertices(Visitor&& visit) const {
    for(std::size_t v = 0; v < m_surface.number_of_vertices(); ++v)
      visit(position_of(m_surface.point(v)));
    for(const Position& p : m_on_edges)
      visit(p);
    for(std::size_t f = 0; f < m_surface.number_of_faces(); ++f)
      for(std::uint32_t j = 1; j + 1 < m_n; ++j)
        for(std::uint32_t i = 1; i + j < m_n; ++i)
          visit(evaluate(f, {m_n - i - j, i, j}));
  }

  // calls visit(corner, corner, corner) with what of_place(face, i, j) returns for them
  template <class OfPlace, class Visitor>
  void visit_triangles(OfPlace&& of_place, Visitor&& visit) const {
    for(std::size_t f = 0; f < m_surface.number_of_faces(); ++f)
      for(std::uint32_t j = 0; j < m_n; ++j)
        for(std::uint32_t i = 0; i + j < m_n; ++i) {
          visit(of_place(f, i, j), of_place(f, i + 1, j), of_place(f, i, j + 1));
          if(i + j + 2 <= m_n)
            visit(of_place(f, i + 1, j), of_place(f, i + 1, j + 1), of_place(f, i, j + 1));
        }
  }

  std::uint32_t number(std::size_t face, std::uint32_t i, std::uint32_t j) const {
    const std::size_t number_of_corners = m_surface.number_of_vertices();
    const auto inside = [&] {
      // rows j = 1, 2, ... of N - 2, N - 3, ... places
      const std::size_t before = (j - 1) * std::size_t(m_n - 1) - std::size_t(j) * (j - 1) / 2;
      return number_of_corners + m_on_edges.size() + face * inside_a_face() + before + (i - 1);
    };
    return at_place<std::uint32_t>(
        face, i, j, [&](int corner) { return m_surface.triangle(face)[corner]; },
        [&](std::size_t k) { return static_cast<std::uint32_t>(number_of_corners + k); },
        [&] { return static_cast<std::uint32_t>(inside()); });
  }

  Position position(std::size_t face, std::uint32_t i, std::uint32_t j) const {
    return at_place<Position>(
        face, i, j, [&](int corner) { return position_of(m_surface.point(face, corner)); },
        [&](std::size_t k) { return m_on_edges[k]; },
        [&] {
          return evaluate(face, {m_n - i - j, i, j});
        });
  }

private:
  static Position position_of(const RL::Point_3& p) {
    return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
  }

  // what one of three functions returns: for a corner, a position in m_on_edges, or inside
  template <class Result, class OfCorner, class OnEdge, class Inside>
  Result at_place(std::size_t face, std::uint32_t i, std::uint32_t j, OfCorner&& of_corner,
                  OnEdge&& on, Inside&& inside) const {
    const std::array<std::uint32_t, 3> place = {m_n - i - j, i, j};
    for(int corner = 0; corner < 3; ++corner)
      if(place[corner] == m_n)
        return of_corner(corner);
    for(int side = 0; side < 3; ++side)
      if(place[(side + 2) % 3] == 0)
        return on(on_edge(face, side, place));
    return inside();
  }

  std::size_t inside_a_face() const { return std::size_t(m_n - 1) * (m_n - 2) / 2; }

  // position in m_on_edges of a place on a side, which is no corner
  std::size_t on_edge(std::size_t face, int side, const std::array<std::uint32_t, 3>& place) const {
    const std::size_t edge = m_edge_of_side[face][side];
    const bool is_reversed = m_surface.triangle(face)[side] != m_edges.ends(edge)[0];
    const std::uint32_t k = is_reversed ? place[side] : place[(side + 1) % 3];
    return edge * (m_n - 1) + (k - 1);
  }

  Position evaluate(std::size_t face, const std::array<std::uint32_t, 3>& place) const {
    RL::Surface_location location;
    location.face = face;
    for(int corner = 0; corner < 3; ++corner)
      location.barycentric[corner] = static_cast<double>(place[corner]) / m_n;
    return position_of(m_surface.surface_point(location).point);
  }

  const RL::Triangulated_surface_3& m_surface;
  RL::internal::Surface_edges m_edges;
  std::uint32_t m_n;
  std::vector<std::array<std::uint32_t, 3>> m_edge_of_side;
  std::vector<Position> m_on_edges;
};

namespace internal {

// As the formats have it, the lowest byte of a number comes first: so do the machines this is for.
template <class T> void write(std::ofstream& out, const T& value) {
  out.write(reinterpret_cast<const char*>(&value), sizeof value);
}

inline void write_ply(std::ofstream& out, const Refined_mesh& mesh) {
  out << "ply\nformat binary_little_endian 1.0\nelement vertex " << mesh.number_of_vertices()
      << "\nproperty float x\nproperty float y\nproperty float z\nelement face "
      << mesh.number_of_triangles() << "\nproperty list uchar uint vertex_indices\nend_header\n";
  mesh.visit_vertices([&](const Position& p) { write(out, p); });
  mesh.visit_triangles(
      [&](std::size_t f, std::uint32_t i, std::uint32_t j) { return mesh.number(f, i, j); },
      [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        write(out, std::uint8_t(3));
        write(out, std::array<std::uint32_t, 3>{a, b, c});
      });
}

inline void write_stl(std::ofstream& out, const Refined_mesh& mesh) {
  write(out, std::array<char, 80>{});
  write(out, static_cast<std::uint32_t>(mesh.number_of_triangles()));
  mesh.visit_triangles(
      [&](std::size_t f, std::uint32_t i, std::uint32_t j) { return mesh.position(f, i, j); },
      [&](const Position& a, const Position& b, const Position& c) {
        write(out, std::array<Position, 4>{Position{0, 0, 0}, a, b, c}); // a normal comes first
        write(out, std::uint16_t(0));
      });
}

} // namespace internal

/// Writes the mesh piece by piece into a binary .ply or .stl file, with coordinates of four bytes.
inline void write_refined_mesh(const Refined_mesh& mesh, const std::string& file) {
  const std::string extension = std::filesystem::path(file).extension().string();
  if(extension != ".ply" && extension != ".stl")
    throw std::runtime_error("'" + file + "' is no .ply or .stl file");
  std::ofstream out(file, std::ios::binary);
  if(extension == ".ply")
    internal::write_ply(out, mesh);
  else
    internal::write_stl(out, mesh);
  out.close();
  if(out)
    return;
  std::error_code ignored;
  std::filesystem::remove(file, ignored);
  throw std::runtime_error("cannot write '" + file + "'");
}

} // namespace benchmarks

#endif // RESTRICTED_LAPLACIAN_3_BENCHMARK_REFINED_MESH_H

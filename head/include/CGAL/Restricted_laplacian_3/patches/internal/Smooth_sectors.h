// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PATCHES_INTERNAL_SMOOTH_SECTORS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PATCHES_INTERNAL_SMOOTH_SECTORS_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Disjoint_sets.h>
#include <CGAL/Restricted_laplacian_3/patches/Smooth_geometry.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/Corner_groups.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/Surface_edges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The creases of a surface, and the groups of corners between them: the sectors of its vertices,
/// see `curved_surface()`.
class Smooth_sectors {
public:
  /// \param edges of all faces; surface and edges must outlive this object
  Smooth_sectors(const Triangulated_surface_3& surface, const Surface_edges& edges,
                 const Smooth_geometry& geometry)
    : m_surface(surface), m_edges(edges), m_geometry(geometry) {
    constexpr double degree = 3.14159265358979323846 / 180;
    if(!(geometry.crease_angle >= 0 && geometry.crease_angle <= 180))
      throw Parameter_error("crease_angle", "is " + std::to_string(geometry.crease_angle) +
                                                ", but must be in 0 .. 180");
    if(!geometry.vertex_normals.empty() &&
       geometry.vertex_normals.size() != surface.number_of_vertices())
      throw Parameter_error("vertex_normal_map", "has not one normal for each vertex");
    m_crease_cosine = std::cos(geometry.crease_angle * degree);
    find_creases();
    find_plane_parts();
    find_sectors();
  }

  /// cosine of the crease angle
  double crease_cosine() const { return m_crease_cosine; }
  /// whether an edge is a crease or on the boundary
  bool is_crease(std::size_t edge) const { return m_is_crease[edge] != 0; }
  /// the sectors
  const Corner_groups& groups() const { return m_groups; }

  /// whether the normal of a sector is that of a plane part of the surface
  bool is_in_plane(std::size_t group) const {
    return m_groups.corrections[group] == Corner_groups::Correction::none;
  }

  /// the unit normals of the sectors
  std::vector<Vector_3> normals() const {
    std::vector<Vector_3> normals = group_normals(m_surface, m_groups);
    std::vector<std::uint32_t> number_of_sectors(m_surface.number_of_vertices(), 0);
    for(std::size_t g = 0; g < normals.size(); ++g)
      if(normals[g] != CGAL::NULL_VECTOR) // as for degenerate faces
        ++number_of_sectors[m_groups.vertices[g]];
    for(std::size_t g = 0; g < normals.size() && !m_geometry.vertex_normals.empty(); ++g) {
      const std::uint32_t v = m_groups.vertices[g];
      const Vector_3& given = m_geometry.vertex_normals[v];
      const bool is_usable = std::isfinite(given.x()) && std::isfinite(given.y()) &&
                             std::isfinite(given.z()) && given != CGAL::NULL_VECTOR;
      if(!is_usable || number_of_sectors[v] != 1)
        continue;
      const Vector_3 n = unit_vector(given);
      normals[g] = n * normals[g] < 0 ? -n : n;
    }
    return normals;
  }

private:
  static constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();

  /// the two sides of an edge that has two faces that are not degenerate, and whether these are
  /// oriented alike
  struct Pair {
    Surface_edges::Side first, second;
    bool is_oriented;
    double cosine; // of the angle between the normals
  };

  bool is_pair(std::size_t edge, Pair& pair) const {
    int count = 0;
    for(const Surface_edges::Side& side : m_edges.sides(edge)) {
      if(m_surface.is_degenerate(side.face))
        continue;
      if(count == 2)
        return false;
      (count == 0 ? pair.first : pair.second) = side;
      ++count;
    }
    if(count != 2)
      return false;
    pair.is_oriented = m_surface.triangle(pair.first.face)[pair.first.number] !=
                       m_surface.triangle(pair.second.face)[pair.second.number];
    pair.cosine = m_surface.normal(pair.first.face) * m_surface.normal(pair.second.face) *
                  (pair.is_oriented ? 1 : -1);
    return true;
  }

  void find_creases() {
    m_is_crease.assign(m_edges.size(), 0);
    Pair pair;
    for(std::size_t edge = 0; edge < m_edges.size(); ++edge)
      m_is_crease[edge] = !is_pair(edge, pair) || pair.cosine < m_crease_cosine ? 1 : 0;
    for(auto [a, b] : m_geometry.creases) {
      if(a > b)
        std::swap(a, b);
      const std::size_t edge = m_edges.find({a, b});
      if(edge != m_edges.size())
        m_is_crease[edge] = 1;
    }
  }

  /// Faces that lie in one plane are united; a part is plane if one of its faces has three
  /// neighbors in it.
  void find_plane_parts() {
    constexpr double plane_cosine = 1 - 0.5e-8; // 1e-4
    Disjoint_sets sets(m_surface.number_of_faces());
    std::vector<unsigned char> counts(m_surface.number_of_faces(), 0);
    Pair pair;
    for(std::size_t edge = 0; edge < m_edges.size(); ++edge)
      if(!is_crease(edge) && is_pair(edge, pair) && pair.cosine >= plane_cosine) {
        sets.unite(pair.first.face, pair.second.face);
        ++counts[pair.first.face];
        ++counts[pair.second.face];
      }
    std::vector<char> is_plane(m_surface.number_of_faces(), 0);
    for(std::uint32_t f = 0; f < counts.size(); ++f)
      if(counts[f] == 3)
        is_plane[sets.find(f)] = 1;
    m_plane_parts.assign(m_surface.number_of_faces(), none);
    for(std::uint32_t f = 0; f < counts.size(); ++f)
      if(is_plane[sets.find(f)])
        m_plane_parts[f] = sets.find(f);
  }

  /// A corner with the same vertex in a neighbor, or none, and whether that is oriented the other
  /// way round.
  struct Next_corner {
    std::uint32_t corner = none;
    bool changes_orientation = false;
  };
  /// over the side that begins at a corner, and over the one that ends there
  using Next_corners = std::array<Next_corner, 2>;

  /// of all corners; none across creases
  std::vector<Next_corners> next_corners() const {
    std::vector<Next_corners> across(3 * m_surface.number_of_faces());
    Pair pair;
    for(std::size_t edge = 0; edge < m_edges.size(); ++edge) {
      if(is_crease(edge) || !is_pair(edge, pair))
        continue;
      const auto corners = [](const Surface_edges::Side& side) -> std::array<std::uint32_t, 2> {
        return {3 * side.face + side.number, 3 * side.face + (side.number + 1) % 3};
      };
      const auto first = corners(pair.first), second = corners(pair.second);
      for(int end = 0; end < 2; ++end) {
        const int other = pair.is_oriented ? 1 - end : end;
        across[first[end]][end] = {second[other], !pair.is_oriented};
        across[second[end]][end] = {first[other], !pair.is_oriented};
      }
    }
    return across;
  }

  void find_sectors() {
    const std::vector<Next_corners> across = next_corners();
    m_groups.corners.assign(across.size(), {none, 1, true});
    std::vector<std::uint32_t> sector;
    for(std::uint32_t start = 0; start < across.size(); ++start) {
      if(m_groups.corners[start].group != none)
        continue;
      const auto group = static_cast<std::uint32_t>(m_groups.vertices.size());
      m_groups.vertices.push_back(m_surface.triangle(start / 3)[start % 3]);
      m_groups.corners[start].group = group;
      sector.assign(1, start);
      bool is_on_boundary = false;
      for(std::size_t k = 0; k < sector.size(); ++k)
        for(const Next_corner& next : across[sector[k]]) {
          if(next.corner == none) {
            is_on_boundary = true;
            continue;
          }
          Corner_groups::Corner& corner = m_groups.corners[next.corner];
          if(corner.group != none)
            continue;
          corner.group = group;
          corner.sign = static_cast<signed char>(m_groups.corners[sector[k]].sign *
                                                 (next.changes_orientation ? -1 : 1));
          sector.push_back(next.corner);
        }
      add_corrections(sector, is_on_boundary);
    }
  }

  /// Says how the normal of the sector that is the last group is corrected. Plane parts in it
  /// determine the normal: of a single one also that of other faces; of several, each is a group of
  /// its own.
  void add_corrections(const std::vector<std::uint32_t>& sector, bool is_on_boundary) {
    using Correction = Corner_groups::Correction;
    std::vector<std::uint32_t> parts;
    for(std::uint32_t corner : sector)
      if(m_plane_parts[corner / 3] != none)
        parts.push_back(m_plane_parts[corner / 3]);
    std::sort(parts.begin(), parts.end());
    parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
    if(parts.size() < 2) {
      m_groups.corrections.push_back(!parts.empty()   ? Correction::none
                                     : is_on_boundary ? Correction::at_boundary
                                                      : Correction::inside);
      for(std::uint32_t corner : sector)
        m_groups.corners[corner].counts = parts.empty() || m_plane_parts[corner / 3] == parts[0];
      return;
    }
    m_groups.corrections.push_back(Correction::at_boundary);
    const std::uint32_t vertex = m_groups.vertices.back();
    for(std::uint32_t part : parts) {
      const auto group = static_cast<std::uint32_t>(m_groups.vertices.size());
      m_groups.vertices.push_back(vertex);
      m_groups.corrections.push_back(Correction::none);
      for(std::uint32_t corner : sector)
        if(m_plane_parts[corner / 3] == part)
          m_groups.corners[corner].group = group;
    }
  }

  const Triangulated_surface_3& m_surface;
  const Surface_edges& m_edges;
  const Smooth_geometry& m_geometry;
  double m_crease_cosine;
  std::vector<char> m_is_crease;            // of edges
  std::vector<std::uint32_t> m_plane_parts; // of faces, or none
  Corner_groups m_groups;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PATCHES_INTERNAL_SMOOTH_SECTORS_H

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_INTERNAL_SCAN_CHOICE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_INTERNAL_SCAN_CHOICE_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/Surface_edges.h>
#include <CGAL/Restricted_laplacian_3/textures/back_project_colors.h>
#include <CGAL/Restricted_laplacian_3/textures/internal/Labelling.h>
#include <CGAL/Restricted_laplacian_3/textures/internal/scan_properties.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The sides that faces share: two faces and the length. Where more than two faces meet, each is
/// joined to the next one; degenerate faces have none.
struct Shared_side {
  std::uint32_t face, other;
  double length;
};

inline std::vector<Shared_side> shared_sides(const Triangulated_surface_3& surface) {
  const Surface_edges edges(surface, Surface_edges::Faces::not_degenerate);
  std::vector<Shared_side> result;
  result.reserve(edges.size());
  for(std::size_t e = 0; e < edges.size(); ++e) {
    const auto sides = edges.sides(e);
    const auto& [a, b] = edges.ends(e);
    for(auto side = sides.begin(); side + 1 != sides.end(); ++side)
      result.push_back(
          {side->face, side[1].face, safe_length(surface.point(b) - surface.point(a))});
  }
  return result;
}

/// Chooses a scan for each triangle among those that cover its three vertices.
///
/// First the qualities of each scan are smoothed: a step replaces the quality at a vertex by the
/// mean of itself and the mean over its neighbors, as far as the scan covers them. The quality
/// \f$q_s\f$ in a triangle is the smallest of its corners. Then
/// \f[ \sum_{\mathrm{triangles}} \frac{A}{\bar A} \left(1 - q_s\right)
///     + w \sum_{\mathrm{seams}} \frac{\ell}{\bar\ell} \f]
/// is made small by a `Labelling`, where seams are the sides of length \f$\ell\f$ across which the
/// scan changes, and means are taken over all triangles and sides.
class Scan_choice {
public:
  Scan_choice(const Triangulated_surface_3& surface, const std::vector<Back_projection>& scans,
              int smoothing_steps, double seam_weight, bool is_parallel)
    : m_surface(surface), m_qualities(scans.size()) {
    parallel_for(is_parallel, 0, scans.size(), 1, [&](std::size_t begin, std::size_t end) {
      for(std::size_t s = begin; s < end; ++s) {
        spread(scans[s], m_qualities[s]);
        for(int step = 0; step < smoothing_steps; ++step)
          smooth(m_qualities[s]);
      }
    });
    choose_best();
    if(scans.size() > 1)
      m_sides = shared_sides(surface);
    if(seam_weight > 0 && !m_sides.empty())
      shorten_seams(seam_weight);
  }

  /// of the sides across which the scan changes
  double seam_length() const {
    double length = 0;
    for(const Shared_side& side : m_sides) {
      const std::uint32_t s = m_scans[side.face], t = m_scans[side.other];
      if(s != t && s != no_scan && t != no_scan)
        length += side.length;
    }
    return length;
  }

  /// the scan of each face, or `no_scan`
  const std::vector<std::uint32_t>& scans_of_faces() const { return m_scans; }

  /// The scan of each vertex: of those of its faces the one of the largest quality there.
  std::vector<std::uint32_t> scans_of_vertices() const {
    std::vector<std::uint32_t> result(m_surface.number_of_vertices(), no_scan);
    for(std::size_t f = 0; f < m_scans.size(); ++f)
      for(std::uint32_t v : m_surface.triangle(f)) {
        const std::uint32_t s = m_scans[f];
        if(s == no_scan || result[v] == s)
          continue;
        if(result[v] == no_scan || m_qualities[s][v] > m_qualities[result[v]][v] ||
           (m_qualities[s][v] == m_qualities[result[v]][v] && s < result[v]))
          result[v] = s;
      }
    return result;
  }

private:
  using Qualities = std::vector<float>; // negative where the scan does not cover a vertex

  void spread(const Back_projection& scan, Qualities& qualities) const {
    qualities.assign(m_surface.number_of_vertices(), -1);
    for(std::size_t i = 0; i < scan.vertices.size(); ++i)
      qualities[scan.vertices[i]] = static_cast<float>(scan.qualities[i]);
  }

  void smooth(Qualities& qualities) const {
    std::vector<float> sums(qualities.size(), 0), numbers(qualities.size(), 0);
    for(std::size_t f = 0; f < m_surface.number_of_faces(); ++f) {
      const Triangulated_surface_3::Triangle& t = m_surface.triangle(f);
      for(int i = 0; i < 3 && !m_surface.is_degenerate(f); ++i) {
        const std::uint32_t a = t[i], b = t[(i + 1) % 3];
        if(qualities[a] >= 0 && qualities[b] >= 0) {
          sums[a] += qualities[b];
          sums[b] += qualities[a];
          ++numbers[a];
          ++numbers[b];
        }
      }
    }
    for(std::size_t v = 0; v < qualities.size(); ++v)
      if(numbers[v] > 0)
        qualities[v] = (qualities[v] + sums[v] / numbers[v]) / 2;
  }

  /// negative if the scan does not cover all corners
  double quality(std::uint32_t scan, std::size_t face) const {
    const Qualities& q = m_qualities[scan];
    const Triangulated_surface_3::Triangle& t = m_surface.triangle(face);
    return (std::min)({q[t[0]], q[t[1]], q[t[2]]});
  }

  void choose_best() {
    m_scans.assign(m_surface.number_of_faces(), no_scan);
    for(std::size_t f = 0; f < m_scans.size(); ++f) {
      double best = -1;
      for(std::uint32_t s = 0; s < m_qualities.size(); ++s)
        if(quality(s, f) > best && quality(s, f) >= 0) {
          best = quality(s, f);
          m_scans[f] = s;
        }
    }
  }

  void shorten_seams(double seam_weight) {
    std::vector<std::uint32_t> faces, numbers(m_scans.size());
    std::vector<std::vector<double>> costs;
    for(std::size_t f = 0; f < m_scans.size(); ++f)
      if(m_scans[f] != no_scan && !m_surface.is_degenerate(f)) {
        const double area =
            m_surface.area(f) / m_surface.area() * static_cast<double>(m_scans.size());
        numbers[f] = static_cast<std::uint32_t>(faces.size());
        faces.push_back(static_cast<std::uint32_t>(f));
        costs.emplace_back(m_qualities.size(), std::numeric_limits<double>::infinity());
        for(std::uint32_t s = 0; s < m_qualities.size(); ++s)
          if(quality(s, f) >= 0)
            costs.back()[s] = area * (1 - quality(s, f));
      }
    double length = 0;
    for(const Shared_side& side : m_sides)
      length += side.length;
    const double factor = seam_weight * static_cast<double>(m_sides.size()) / length;
    std::vector<Labelling::Edge> edges;
    for(const Shared_side& side : m_sides)
      if(m_scans[side.face] != no_scan && m_scans[side.other] != no_scan)
        edges.push_back({numbers[side.face], numbers[side.other], factor * side.length});
    const Labelling labelling(std::move(costs), std::move(edges));
    for(std::size_t i = 0; i < faces.size(); ++i)
      m_scans[faces[i]] = labelling.labels()[i];
  }

  const Triangulated_surface_3& m_surface;
  std::vector<Qualities> m_qualities; // of each scan at the vertices
  std::vector<std::uint32_t> m_scans; // of the faces
  std::vector<Shared_side> m_sides;   // if there are several scans
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_INTERNAL_SCAN_CHOICE_H

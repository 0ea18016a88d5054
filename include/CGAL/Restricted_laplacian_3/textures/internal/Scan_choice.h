// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_INTERNAL_SCAN_CHOICE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_INTERNAL_SCAN_CHOICE_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>
#include <CGAL/Restricted_laplacian_3/textures/back_project_colors.h>
#include <CGAL/Restricted_laplacian_3/textures/internal/scan_properties.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
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
  struct Side {
    std::uint32_t a, b, face;
  };
  // sorted by counting the lower vertex first: a comparison sort of all sides takes longer
  std::vector<std::uint32_t> first(surface.number_of_vertices() + 1, 0);
  const auto for_each_side = [&](auto&& visit) {
    for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
      for(int i = 0; i < 3 && !surface.is_degenerate(f); ++i) {
        const auto ends = std::minmax({surface.triangle(f)[i], surface.triangle(f)[(i + 1) % 3]});
        visit(Side{ends.first, ends.second, static_cast<std::uint32_t>(f)});
      }
  };
  for_each_side([&](const Side& side) { ++first[side.a + 1]; });
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<Side> sides(first.back(), Side{0, 0, 0});
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for_each_side([&](const Side& side) { sides[next[side.a]++] = side; });
  std::vector<Shared_side> result;
  result.reserve(sides.size() / 2);
  for(std::size_t v = 0; v + 1 < first.size(); ++v) {
    std::sort(
        sides.begin() + first[v], sides.begin() + first[v + 1],
        [](const Side& s, const Side& t) { return s.b != t.b ? s.b < t.b : s.face < t.face; });
    for(std::size_t i = first[v]; i + 1 < first[v + 1]; ++i)
      if(sides[i].b == sides[i + 1].b)
        result.push_back({sides[i].face, sides[i + 1].face,
                          safe_length(surface.point(sides[i].b) - surface.point(sides[i].a))});
  }
  return result;
}

/// Chooses a scan for each triangle among those that cover its three vertices.
///
/// First the qualities of each scan are smoothed: a step replaces the quality at a vertex by the
/// mean of itself and the mean over its neighbours, as far as the scan covers them. The quality
/// \f$q_s\f$ in a triangle is the smallest of its corners. Then
/// \f[ \sum_{\mathrm{triangles}} \frac{A}{\bar A} \left(1 - q_s\right)
///     + w \sum_{\mathrm{seams}} \frac{\ell}{\bar\ell} \f]
/// is decreased, where seams are the sides of length \f$\ell\f$ across which the scan changes, and
/// means are taken over all triangles and sides: from the best scan of each triangle, one triangle
/// after the other takes the scan that makes the sum smallest, until nothing changes (iterated
/// conditional modes; J. Besag, *On the statistical analysis of dirty pictures*, J. R. Stat. Soc. B
/// 48, 1986).
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

  /// The sides of the faces, and the factor by which their lengths are weights.
  struct Neighbors {
    struct Neighbor {
      std::uint32_t face;
      double weight;
    };
    std::vector<std::uint32_t> first; // those of face f: numbers first[f] .. first[f + 1] - 1
    std::vector<Neighbor> neighbors;
  };

  Neighbors neighbors(double seam_weight) const {
    double length = 0;
    for(const Shared_side& side : m_sides)
      length += side.length;
    const double factor = seam_weight * static_cast<double>(m_sides.size()) / length;
    Neighbors result;
    result.first.assign(m_scans.size() + 1, 0);
    for(const Shared_side& side : m_sides) {
      ++result.first[side.face + 1];
      ++result.first[side.other + 1];
    }
    std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());
    result.neighbors.resize(result.first.back());
    std::vector<std::uint32_t> next(result.first.begin(), result.first.end() - 1);
    for(const Shared_side& side : m_sides) {
      result.neighbors[next[side.face]++] = {side.other, factor * side.length};
      result.neighbors[next[side.other]++] = {side.face, factor * side.length};
    }
    return result;
  }

  void shorten_seams(double seam_weight) {
    constexpr int largest_number_of_sweeps = 100;
    const Neighbors all = neighbors(seam_weight);
    bool is_changed = true;
    for(int sweep = 0; is_changed && sweep < largest_number_of_sweeps; ++sweep) {
      is_changed = false;
      for(std::size_t f = 0; f < m_scans.size(); ++f) {
        const std::uint32_t best = best_scan(f, all);
        is_changed = is_changed || best != m_scans[f];
        m_scans[f] = best;
      }
    }
  }

  /// the scan among those of a face and of its neighbours that makes the sum smallest
  std::uint32_t best_scan(std::size_t face, const Neighbors& all) const {
    const std::uint32_t current = m_scans[face];
    const std::size_t begin = all.first[face], end = all.first[face + 1];
    const auto scan_of = [&](std::size_t i) { return m_scans[all.neighbors[i].face]; };
    bool is_inside = true;
    for(std::size_t i = begin; i < end; ++i)
      is_inside = is_inside && scan_of(i) == current;
    if(current == no_scan || is_inside)
      return current;
    const double relative_area =
        m_surface.area(face) / m_surface.area() * static_cast<double>(m_scans.size());
    const auto energy = [&](std::uint32_t s) {
      double sum = relative_area * (1 - quality(s, face));
      for(std::size_t i = begin; i < end; ++i)
        if(scan_of(i) != s)
          sum += all.neighbors[i].weight;
      return sum;
    };
    std::uint32_t best = current;
    double smallest = energy(current);
    for(std::size_t i = begin; i < end; ++i) {
      const std::uint32_t s = scan_of(i);
      if(s == no_scan || s == best || quality(s, face) < 0)
        continue;
      const double e = energy(s);
      if(e < smallest) {
        smallest = e;
        best = s;
      }
    }
    return best;
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

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_STITCH_COLORS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_STITCH_COLORS_H

#include <CGAL/Restricted_laplacian_3/Colored_scan.h>
#include <CGAL/Restricted_laplacian_3/Poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/Solve_report.h>
#include <CGAL/Restricted_laplacian_3/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/back_project_colors.h>
#include <CGAL/Restricted_laplacian_3/exceptions.h>
#include <CGAL/Restricted_laplacian_3/internal/Scan_choice.h>
#include <CGAL/Restricted_laplacian_3/internal/color_values.h>
#include <CGAL/Restricted_laplacian_3/internal/exposure_gains.h>
#include <CGAL/Restricted_laplacian_3/parameters.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>
#include <CGAL/Restricted_laplacian_3/srgb.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Ref
/// The scan of a face or vertex that has none.
constexpr std::uint32_t no_scan = internal::no_scan_number;

/// \ingroup PkgRestrictedLaplacian3Ref
/// Where the vector field that is integrated comes from.
enum class Gradient_source {
  /// gradients of the colours of the chosen scan at its points nearest to the three vertices,
  /// projected to the plane of the triangle and interpolated linearly (paper, section 5.2)
  scans,
  /// the gradient of the linear function that takes the colours of the chosen scan at the three
  /// vertices
  back_projection
};

/// \ingroup PkgRestrictedLaplacian3Ref
/// What a `Color_stitcher` does unless told otherwise.
struct Color_stitching_options {
  /// which vertices a scan covers
  Back_projection_options back_projection;
  Gradient_source gradient_source = Gradient_source::back_projection;
  /// \f$w \ge 0\f$: weight of seams in the choice of scans
  double seam_weight = 0.05;
  /// how often qualities are smoothed before scans are chosen
  int quality_smoothing_steps = 5;
  /// whether each scan's channels are multiplied by factors that make overlapping scans agree
  bool match_exposures = true;
  /// whether colours are taken to linear light before, and back to sRGB after
  bool linear_light = false;
  /// \f$\alpha > 0\f$, in units of 1 / area; without a value `default_screening` / area
  std::optional<double> screening_weight;
  /// whether details below a cell are added at the vertices
  bool vertex_details = true;
  /// factor \f$c\f$ of the stabilisation; without a value `default_normal_stabilization()`
  std::optional<double> normal_stabilization;
  /// of the linear systems
  Poisson_solver_options solver;

  /// \f$A = \alpha \cdot\f$ area unless told otherwise
  static constexpr double default_screening = 1e-2;
};

/// \ingroup PkgRestrictedLaplacian3Ref
/// What one scan gave to a surface. Areas are fractions of the area of the surface, 0 .. 1.
struct Scan_usage {
  /// number of vertices that the scan covers; 0 is worth a message
  std::size_t covered_vertices = 0;
  /// the triangles whose three vertices it covers
  double covered_area = 0;
  /// the triangles for which it was chosen
  double chosen_area = 0;
  /// \f$D\f$, see `Color_back_projector`
  double maximum_distance = 0;
  /// of a vertex from the scan: of those that it covers, or of all if it covers none
  double smallest_distance = std::numeric_limits<double>::infinity();
  /// the number of vertices that face its viewpoint
  std::size_t facing_vertices = 0;
  /// factors of the channels that make scans agree; 1 if exposures are not matched
  Rgb_color gains = {1, 1, 1};
};

/// \ingroup PkgRestrictedLaplacian3Ref
/// Colours of vertices, and where they come from.
struct Vertex_colors {
  /// 0 .. 1; black at vertices without a scan
  std::vector<Rgb_color> colors;
  /// the number of the scan of each vertex, or `no_scan`
  std::vector<std::uint32_t> scans;
};

/// \ingroup PkgRestrictedLaplacian3Ref
/// What `stitch_colors()` did: the solver's report, and what follows. Areas are fractions of the
/// area of the surface, 0 .. 1.
struct Stitching_report : Solve_report {
  std::vector<Scan_usage> scans;
  /// triangles without a scan: filled smoothly
  double uncovered_area = 0;
  /// vertices of which no triangle has a scan
  std::size_t uncovered_vertices = 0;
  /// connected components of the surface of which no triangle has a scan
  std::size_t uncovered_components = 0;
  /// length of the sides across which the scan changes, in units of length
  double seam_length = 0;
  /// components of colours that were outside of 0 .. 1 and are cut off
  std::size_t clamped_values = 0;
  /// `mean_color_jump()` of the colours of the chosen scans across their transitions
  double jump_before = 0;
  /// the same of the stitched colours across the same transitions
  double jump_after = 0;
  /// wall-clock seconds: nearest points and qualities, all scans together
  double back_projection_seconds = 0;
  /// wall-clock seconds: choice of scans and exposures
  double choice_seconds = 0;
};

/// \ingroup PkgRestrictedLaplacian3Ref
/// Stitched colours, and how they came about.
struct Stitched_colors : Stitching_report {
  /// of the vertices, 0 .. 1
  std::vector<Rgb_color> colors;
};

/// \ingroup PkgRestrictedLaplacian3Ref
/// The edges of a surface, as pairs of vertices in ascending order, whose ends have different
/// scans.
/// \param scans of the vertices; edges at vertices with `no_scan` are left out
/// \throws Parameter_error the number of scans is not that of the vertices
inline std::vector<std::pair<std::uint32_t, std::uint32_t>>
scan_transitions(const Triangulated_surface_3& surface, const std::vector<std::uint32_t>& scans) {
  if(scans.size() != surface.number_of_vertices())
    throw Parameter_error("scans", "has another length than the vertices");
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
    for(int i = 0; i < 3 && !surface.is_degenerate(f); ++i) {
      const auto edge = std::minmax({surface.triangle(f)[i], surface.triangle(f)[(i + 1) % 3]});
      const std::uint32_t s = scans[edge.first], t = scans[edge.second];
      if(s != t && s != no_scan && t != no_scan)
        edges.push_back(edge);
    }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

/// \ingroup PkgRestrictedLaplacian3Ref
/// The visible contrast of seams: the mean over edges of the length of the difference of the
/// colours of their ends, \f$\lvert c_v - c_w \rvert_2\f$ over the three channels. What true
/// colours have there is to be subtracted. 0 if there are no edges.
/// \param edges such as `scan_transitions()` returns
/// \throws Parameter_error an edge names a vertex without a colour
inline double mean_color_jump(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& edges,
                              const std::vector<Rgb_color>& colors) {
  double sum = 0;
  for(const auto& [v, w] : edges) {
    if((std::max)(v, w) >= colors.size())
      throw Parameter_error("edges", "name a vertex that has no color");
    sum += (internal::eigen_vector(colors[v]) - internal::eigen_vector(colors[w])).norm();
  }
  return edges.empty() ? 0 : sum / static_cast<double>(edges.size());
}

/// \ingroup PkgRestrictedLaplacian3Ref
/// Colours a surface from several scans without visible seams (paper, section 5.2), in steps, so
/// that progress can be shown between them: `add()` each scan, `choose()`, `stitch()`.
///
/// -# The colours of each scan are taken to the vertices, see `Color_back_projector`.
/// -# A scan is chosen for each triangle, see the section on stitching in the User Manual.
/// -# Exposures are matched: each channel of each scan is multiplied by a factor, such that the
///    median of the ratios of the colours is 1 where two scans overlap, in the least-squares sense
///    over all pairs. The logarithms of the factors sum to 0; scans without overlap keep 1.
/// -# The function \f$u\f$ is found that minimizes, for each channel,
///    \f[ \int_{\mathcal M} \lvert \nabla u - v \rvert^2 + \alpha \int_{\mathcal C} (u - g)^2, \f]
///    where \f$v\f$ is the gradient of the colour of the chosen scan, see `Gradient_source`,
///    \f$g\f$ that colour, and \f$\mathcal C\f$ the triangles that have a scan. In the others \f$v = 0\f$:
///    they are filled by a harmonic function. So the colours of a scan are changed by a smooth
///    function, and steps between scans are spread over about \f$1 / \sqrt\alpha\f$.
/// -# Connected components without any scan take the mean of the others.
class Color_stitcher {
public:
  using Options = Color_stitching_options;

  /// \param space of a mesh or soup, has to outlive this object
  /// \throws Input_error the surface is a point set
  /// \throws Parameter_error an option is outside its domain
  explicit Color_stitcher(const Spline_space_3& space, const Options& options = Options());

  const Spline_space_3& space() const { return *m_space; }
  const Options& options() const { return m_options; }

  /// Takes the colours of a scan to the surface. The scan is not needed any more then.
  /// \return what the scan gives, as far as it is known by then: `Scan_usage::covered_vertices` may
  /// be 0
  const Scan_usage& add(const Colored_scan& scan);

  std::size_t number_of_scans() const { return m_projections.size(); }
  /// The colours of a scan on the surface, in linear light if that is asked for.
  const Back_projection& back_projection(std::size_t scan) const { return m_projections[scan]; }
  const std::vector<Scan_usage>& usages() const { return m_usages; }

  /// Chooses a scan for each triangle, and matches exposures.
  /// \throws Input_error there is no scan, or no scan covers a triangle; the message says how near
  /// they come
  void choose();

  /// the scan of each face, or `no_scan`; empty before `choose()`
  const std::vector<std::uint32_t>& scans_of_faces() const { return m_scans_of_faces; }
  /// the scan of each vertex, one of those of its faces, or `no_scan`; empty before `choose()`
  const std::vector<std::uint32_t>& scans_of_vertices() const { return m_scans_of_vertices; }

  /// The colour of the nearest one of the scans that cover a vertex, as it is in the scan: the
  /// usual way, for comparison (paper, Figure 1, left). Needs no `choose()`.
  Vertex_colors nearest_colors() const;

  /// The colour of the chosen scan of each vertex, as it is in the scan: what is stitched, for
  /// comparison. Calls for `choose()` before.
  Vertex_colors chosen_colors() const;

  /// Stitches the colours; calls `choose()` unless that was done.
  /// \throws Input_error as `choose()`
  Stitched_colors stitch();

private:
  const Spline_space_3* m_space;
  Options m_options;
  Color_back_projector m_projector;
  std::vector<Back_projection> m_projections;
  std::vector<Scan_usage> m_usages;
  std::vector<std::uint32_t> m_scans_of_faces, m_scans_of_vertices;
  double m_seam_length = 0;
  double m_back_projection_seconds = 0;
  double m_choice_seconds = 0;
};

/// \ingroup PkgRestrictedLaplacian3Ref
/// Colours a mesh from several scans without visible seams, see `Color_stitcher`.
/// \tparam FaceGraph a model of `FaceListGraph` and `VertexListGraph`, all of whose faces are
/// triangles
/// \param scans at least one
/// \param colors a model of `WritablePropertyMap` with the vertex descriptor as key and a colour as
/// value: `CGAL::IO::Color`, or a `std::array`, a vector of Eigen or a 3D vector of \cgal of three
/// components, 0 .. 1, or 0 .. 255 if they are integers
/// \param np optional named parameters: those of `Spline_space_3`, and
/// - `maximum_distance`, `minimum_facing_cosine`, `minimum_normal_cosine`, `boundary_width`,
///   `oriented_surface`: as in `Back_projection_options`
/// - `gradient_source`: a `Gradient_source`; default `Gradient_source::back_projection`
/// - `seam_weight`, `quality_smoothing_steps`: of the choice of scans; default 0.05 and 5
/// - `match_exposures`: default `true`
/// - `linear_light`: default `false`
/// - `screening_weight`: \f$\alpha > 0\f$, in units of 1 / area; default 0.01 / area
/// - `vertex_details`: default `true`
/// - `normal_stabilization`, `relative_tolerance`, `number_of_iterations`, `cycle`,
///   `smoothing_steps`, `smoother`, `stand_alone_multigrid`, `concurrency_tag`: as in
///   `make_poisson_solver()`
/// \throws Input_error one of its derived classes names the face, vertex or parameter; or no scan
/// comes near the surface
template <class FaceGraph, class VertexMap,
          class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0>
Stitching_report stitch_colors(const FaceGraph& tm, const std::vector<Colored_scan>& scans,
                               VertexMap colors,
                               const NamedParameters& np = parameters::default_values());

/// \ingroup PkgRestrictedLaplacian3Ref
/// The same on a triangle soup, which need not be a manifold.
/// \param points a range of 3D points
/// \param triangles a range of ranges of three indices into `points`
/// \param scans,colors,np as above, where property maps have the index of a point as key, a
/// `std::size_t`
template <class PointRange, class TriangleRange, class IndexMap,
          class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0>
Stitching_report stitch_colors(const PointRange& points, const TriangleRange& triangles,
                               const std::vector<Colored_scan>& scans, IndexMap colors,
                               const NamedParameters& np = parameters::default_values());

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_STITCH_COLORS_H

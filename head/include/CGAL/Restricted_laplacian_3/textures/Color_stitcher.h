// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_COLOR_STITCHER_H
#define CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_COLOR_STITCHER_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/input/vertex_functions.h>
#include <CGAL/Restricted_laplacian_3/problems/integrate_gradients.h>
#include <CGAL/Restricted_laplacian_3/solvers/Multigrid_solver.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/textures/Colored_scan.h>
#include <CGAL/Restricted_laplacian_3/textures/back_project_colors.h>
#include <CGAL/Restricted_laplacian_3/textures/srgb.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Colors
/// Where the vector field that is integrated comes from.
enum class Gradient_source {
  /// gradients of the colors of the chosen scan at its points nearest to the three vertices,
  /// projected to the plane of the triangle and interpolated linearly (paper, section 5.2)
  scans,
  /// the gradient of the linear function that takes the colors of the chosen scan at the three
  /// vertices
  back_projection
};

/// \ingroup PkgRestrictedLaplacian3Options
/// The named parameters of a `Color_stitcher`.
struct Color_stitching_options {
  /// which vertices a scan covers
  Back_projection_options back_projection;
  /// where the vector field that is integrated comes from
  Gradient_source gradients = Gradient_source::back_projection;
  /// \f$w \ge 0\f$: weight of seams in the choice of scans
  double seam_weight = 0.05;
  /// how often qualities are smoothed before scans are chosen
  int quality_smoothing_steps = 5;
  /// whether each scan's channels are multiplied by factors that make overlapping scans agree
  bool match_exposures = true;
  /// whether colors are taken to linear light before, and back to sRGB after
  bool linear_light = false;
  /// \f$\alpha > 0\f$, in units of 1 / area; without a value `default_screening` / area
  std::optional<double> alpha;
  /// whether details below a cell are added at the vertices
  bool details = true;
  /// relative residual of the details, if it is larger than that of the solver
  double details_tolerance = 1e-3;
  /// factor \f$c\f$ of the stabilization; without a value `default_stabilization()`
  std::optional<double> stabilization;
  /// of the linear systems; without a value the tolerance is 1e-5
  Poisson_solver_options solver;

  /// the defaults
  Color_stitching_options() = default;
  /// what is among named parameters, and the defaults else
  template <class NamedParameters, internal::Require_named_parameters<NamedParameters> = 0>
  Color_stitching_options(const NamedParameters& np) : back_projection(np), solver(np) {
    internal::read_parameter(np, internal_np::gradients, gradients);
    internal::read_parameter(np, internal_np::seam_weight, seam_weight);
    internal::read_parameter(np, internal_np::quality_smoothing_steps, quality_smoothing_steps);
    internal::read_parameter(np, internal_np::match_exposures, match_exposures);
    internal::read_parameter(np, internal_np::linear_light, linear_light);
    internal::read_parameter(np, internal_np::alpha, alpha);
    internal::read_parameter(np, internal_np::details, details);
    internal::read_parameter(np, internal_np::details_tolerance, details_tolerance);
    internal::read_parameter(np, internal_np::stabilization, stabilization);
  }
};

/// \ingroup PkgRestrictedLaplacian3Colors
/// What one scan gave to a surface. Areas are fractions of the area of the surface, from 0 to 1.
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

/// \ingroup PkgRestrictedLaplacian3Colors
/// Colors of vertices, and where they come from.
struct Vertex_colors {
  /// from 0 to 1; black at vertices without a scan
  std::vector<Rgb_color> colors;
  /// the number of the scan of each vertex, or `no_scan`
  std::vector<std::uint32_t> scans;
};

/// \ingroup PkgRestrictedLaplacian3Colors
/// What a `Color_stitcher` did: the report of the integration, where `components_without_weight` is
/// the number of connected components without any scan, and what follows. Areas are fractions of
/// the area of the surface, from 0 to 1.
struct Stitching_report : Gradient_report {
  /// what each scan gave, in the order in which the scans were added
  std::vector<Scan_usage> scans;
  /// triangles without a scan: filled by harmonic functions
  double uncovered_area = 0;
  /// vertices of which no triangle has a scan
  std::size_t uncovered_vertices = 0;
  /// length of the sides across which the scan changes, in units of length
  double seam_length = 0;
  /// components of colors that were outside of 0 to 1 by more than 0.001 and are cut off
  std::size_t clamped_values = 0;
  /// `mean_color_jump()` of the colors of the chosen scans across their transitions
  double jump_before = 0;
  /// the same of the stitched colors across the same transitions
  double jump_after = 0;
  /// wall-clock seconds: nearest points and qualities, all scans together
  double back_projection_seconds = 0;
  /// wall-clock seconds: choice of scans and exposures
  double choice_seconds = 0;
};

/// \ingroup PkgRestrictedLaplacian3Colors
/// Stitched colors, and how they came about.
struct Stitched_colors : Stitching_report {
  /// of the vertices, from 0 to 1
  std::vector<Rgb_color> colors;
};

/// \cond SKIP_IN_MANUAL
/// \ingroup PkgRestrictedLaplacian3Colors
/// The edges of a surface, as pairs of vertices in ascending order, whose ends have different
/// scans.
/// \param surface a surface of triangles
/// \param scans of the vertices; edges at vertices with `no_scan` are left out
/// \throws Parameter_error the number of scans is not that of the vertices
std::vector<std::pair<std::uint32_t, std::uint32_t>>
scan_transitions(const Triangulated_surface_3& surface, const std::vector<std::uint32_t>& scans);
/// \endcond

/// \cond SKIP_IN_MANUAL
/// \ingroup PkgRestrictedLaplacian3Colors
/// The visible contrast of seams: the mean over edges of the length of the difference of the
/// colors of their ends, \f$\lvert c_v - c_w \rvert_2\f$ over the three channels. What true
/// colors have there is to be subtracted. 0 if there are no edges.
/// \param edges such as `scan_transitions()` returns
/// \param colors of the vertices
/// \throws Parameter_error an edge names a vertex without a color
double mean_color_jump(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& edges,
                       const std::vector<Rgb_color>& colors);
/// \endcond

/// \ingroup PkgRestrictedLaplacian3Colors
/// Colors a surface from several scans without visible seams (paper, section 5.2), in steps, so
/// that progress can be shown between them: `add()` each scan, `choose()`, `stitch()`.
///
/// -# The colors of each scan are taken to the vertices, see `Color_back_projector`.
/// -# A scan is chosen for each triangle, see the section on stitching in the User Manual.
/// -# Exposures are matched: each channel of each scan is multiplied by a factor, such that the
///    median of the ratios of the colors is 1 where two scans overlap, in the least-squares sense
///    over all pairs. The logarithms of the factors sum to 0; scans without overlap keep 1.
/// -# The function \f$u\f$ is found that minimizes, for each channel,
///    \f[ \int_{\mathcal M} \lvert \nabla u - v \rvert^2 + \alpha \int_{\mathcal C} (u - g)^2, \f]
///    where \f$v\f$ is the gradient of the color of the chosen scan, see `Gradient_source`,
///    \f$g\f$ that color, and \f$\mathcal C\f$ the triangles that have a scan. In the others
///    \f$v\f$ is the gradient of the harmonic function, linear in each triangle, that continues
///    the colors of the chosen scans. So the colors of a scan are changed by a smooth function,
///    and steps between scans are spread over about \f$1 / \sqrt\alpha\f$.
/// -# Connected components without any scan take the mean of the others.
class Color_stitcher {
  using Options = Color_stitching_options;

public:
  /// the default of `alpha`, in units of 1 / area of the surface
  static constexpr double default_screening = 10;
  /// the default of `tolerance`
  static constexpr double default_tolerance = internal::default_gradient_tolerance;

  /// \param space of a mesh or soup; is copied, which costs nothing
  /// \param options named parameters, or the options themselves:
  /// \cgalNamedParamsBegin
  ///   \named_of_stitching
  /// \cgalNamedParamsEnd
  /// \throws Input_error the surface is a point set
  /// \throws Parameter_error a parameter is outside its domain
  explicit Color_stitcher(const Spline_space_3& space, const Options& options = Options());

  /// the space, as given to the constructor
  const Spline_space_3& space() const { return m_space; }
  /// the values of the named parameters, as given to the constructor
  const Options& options() const { return m_options; }

  /// Takes the colors of a scan to the surface. The scan is not needed any more then.
  /// \return what the scan gives, as far as it is known by then: `Scan_usage::covered_vertices` may
  /// be 0
  Scan_usage add(const Colored_scan& scan);

  /// how many scans were added
  std::size_t number_of_scans() const { return m_projections.size(); }
  /// The colors of a scan on the surface, in linear light if that is asked for.
  const Back_projection& back_projection(std::size_t scan) const { return m_projections[scan]; }
  /// what the scans give; all that it holds is known after `choose()`
  const std::vector<Scan_usage>& usages() const { return m_usages; }

  /// Chooses a scan for each triangle, and matches exposures.
  /// \throws Input_error there is no scan, or no scan covers a triangle; the message says how near
  /// they come
  void choose();

  /// the scan of each face, or `no_scan`; empty before `choose()`
  const std::vector<std::uint32_t>& scans_of_faces() const { return m_scans_of_faces; }
  /// the scan of each vertex, one of those of its faces, or `no_scan`; empty before `choose()`
  const std::vector<std::uint32_t>& scans_of_vertices() const { return m_scans_of_vertices; }

  /// The color of the nearest one of the scans that cover a vertex, as it is in the scan: the
  /// usual way, for comparison (paper, Figure 1, left). Needs no `choose()`.
  Vertex_colors nearest_colors() const;

  /// The color of the chosen scan of each vertex, as it is in the scan: what is stitched, for
  /// comparison. Calls for `choose()` before.
  Vertex_colors chosen_colors() const;

  /// Stitches the colors; calls `choose()` unless that was done.
  /// \param progress is told which part of the work is done, from 0 to 1; if it returns `false`,
  /// the computation ends with an exception
  /// \throws Input_error as `choose()`
  /// \throws Canceled if `progress` returned `false`
  Stitched_colors stitch(const std::function<bool(double)>& progress = {});

private:
  using Corner_colors = Corner_vector_field<Eigen::Vector3d>;

  const Triangulated_surface_3& surface() const { return m_space.surface(); }
  bool is_parallel() const { return m_space.options().is_parallel; }

  /// as colors are given and returned
  Rgb_color encoded(const Rgb_color& color) const;
  /// black at all vertices, which have no scan
  Vertex_colors black() const;
  /// of the triangles whose three vertices have colors, as a fraction of that of the surface
  double covered_area(const Back_projection& projection) const;
  /// \throws Input_error no triangle has a scan
  void check_coverage(const std::vector<std::uint32_t>& scans_of_faces) const;
  /// Three values for each face, at its corners, from the back-projection of its scan; 0 for faces
  /// without one. The channels, in the last dimension of `T`, are multiplied by the gains.
  /// \param value_of `Back_projection` and a position in it &rarr; `T`
  template <class T, class ValueOf> std::vector<T> corner_values(ValueOf&& value_of) const;
  /// Colors for the triangles without a scan: harmonic functions that take the colors of the
  /// chosen scans on the borders.
  void fill(std::vector<Eigen::Vector3d>& colors) const;
  /// of the linear functions that take the colors of the corners
  Eigen::Matrix3d gradient(const Corner_colors& colors, std::size_t face) const;
  Face_function<Eigen::Matrix3d> back_projected_gradients(const Corner_colors& colors) const;
  /// Tangential parts are taken where the field is integrated.
  Corner_vector_field<Eigen::Matrix3d> scan_gradients(const Corner_colors& colors) const;
  /// the solution at the vertices
  Eigen::MatrixXd integrate(const Vector_field_view& field, const Corner_colors& target,
                            const internal::Progress& progress, Stitched_colors& result) const;
  /// colors from the values of the solution, and what is to be reported
  void finish(const Eigen::MatrixXd& values, Stitched_colors& result) const;

  Spline_space_3 m_space;
  Options m_options;
  Color_back_projector m_projector;
  std::vector<Back_projection> m_projections;
  std::vector<Scan_usage> m_usages;
  std::vector<std::uint32_t> m_scans_of_faces, m_scans_of_vertices;
  double m_seam_length = 0;
  double m_back_projection_seconds = 0;
  double m_choice_seconds = 0;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/textures/Color_stitcher_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_COLOR_STITCHER_H

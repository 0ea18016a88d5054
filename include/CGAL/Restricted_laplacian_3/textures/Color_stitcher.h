// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_COLOR_STITCHER_H
#define CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_COLOR_STITCHER_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/foundation/parameters.h>
#include <CGAL/Restricted_laplacian_3/integration/surface_integration.h>
#include <CGAL/Restricted_laplacian_3/problems/integrate_gradients.h>
#include <CGAL/Restricted_laplacian_3/solvers/Poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/solvers/Solve_report.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_functions_3.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/vector_fields.h>
#include <CGAL/Restricted_laplacian_3/textures/Colored_scan.h>
#include <CGAL/Restricted_laplacian_3/textures/back_project_colors.h>
#include <CGAL/Restricted_laplacian_3/textures/internal/Scan_choice.h>
#include <CGAL/Restricted_laplacian_3/textures/internal/color_values.h>
#include <CGAL/Restricted_laplacian_3/textures/internal/exposure_gains.h>
#include <CGAL/Restricted_laplacian_3/textures/internal/harmonic_fill.h>
#include <CGAL/Restricted_laplacian_3/textures/internal/scan_properties.h>
#include <CGAL/Restricted_laplacian_3/textures/srgb.h>

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

/// \ingroup PkgRestrictedLaplacian3Colors
/// The scan of a face or vertex that has none.
constexpr std::uint32_t no_scan = internal::no_scan_number;

/// \ingroup PkgRestrictedLaplacian3Colors
/// Where the vector field that is integrated comes from.
enum class Gradient_source {
  /// gradients of the colours of the chosen scan at its points nearest to the three vertices,
  /// projected to the plane of the triangle and interpolated linearly (paper, section 5.2)
  scans,
  /// the gradient of the linear function that takes the colours of the chosen scan at the three
  /// vertices
  back_projection
};

/// \ingroup PkgRestrictedLaplacian3Colors
/// What a `Color_stitcher` does unless told otherwise.
struct Color_stitching_options {
  Color_stitching_options() { solver.relative_tolerance = internal::default_gradient_tolerance; }

  /// which vertices a scan covers
  Back_projection_options back_projection;
  /// where the vector field that is integrated comes from
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
  /// relative residual of the details, if it is larger than that of the solver
  double details_tolerance = 1e-3;
  /// factor \f$c\f$ of the stabilisation; without a value `default_normal_stabilization()`
  std::optional<double> normal_stabilization;
  /// of the linear systems
  Poisson_solver_options solver;

  /// \f$A = \alpha \cdot\f$ area unless told otherwise
  static constexpr double default_screening = 10;
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
/// Colours of vertices, and where they come from.
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
  /// components of colours that were outside of 0 to 1 by more than 0.001 and are cut off
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

/// \ingroup PkgRestrictedLaplacian3Colors
/// Stitched colours, and how they came about.
struct Stitched_colors : Stitching_report {
  /// of the vertices, from 0 to 1
  std::vector<Rgb_color> colors;
};

/// \ingroup PkgRestrictedLaplacian3Colors
/// The edges of a surface, as pairs of vertices in ascending order, whose ends have different
/// scans.
/// \param surface a surface of triangles
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

/// \ingroup PkgRestrictedLaplacian3Colors
/// The visible contrast of seams: the mean over edges of the length of the difference of the
/// colours of their ends, \f$\lvert c_v - c_w \rvert_2\f$ over the three channels. What true
/// colours have there is to be subtracted. 0 if there are no edges.
/// \param edges such as `scan_transitions()` returns
/// \param colors of the vertices
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

/// \ingroup PkgRestrictedLaplacian3Colors
/// Colours a surface from several scans without visible seams (paper, section 5.2), in steps, so
/// that progress can be shown between them: `add()` each scan, `choose()`, `stitch()`.
///
/// -# The colours of each scan are taken to the vertices, see `Color_back_projector`.
/// -# A scan is chosen for each triangle, see the section on stitching in the User Manual.
/// -# Exposures are matched: each channel of each scan is multiplied by a factor, such that the
///    median of the ratios of the colours is 1 where two scans overlap, in the least-squares sense
///    over all pairs. The logarithms of the factors sum to 0; scans without overlap keep 1.
/// -# The function \f$u\f$ is found that minimises, for each channel,
///    \f[ \int_{\mathcal M} \lvert \nabla u - v \rvert^2 + \alpha \int_{\mathcal C} (u - g)^2, \f]
///    where \f$v\f$ is the gradient of the colour of the chosen scan, see `Gradient_source`,
///    \f$g\f$ that colour, and \f$\mathcal C\f$ the triangles that have a scan. In the others
///    \f$v\f$ is the gradient of the harmonic function, linear in each triangle, that continues
///    the colours of the chosen scans. So the colours of a scan are changed by a smooth function,
///    and steps between scans are spread over about \f$1 / \sqrt\alpha\f$.
/// -# Connected components without any scan take the mean of the others.
class Color_stitcher {
public:
  /// what the constructor takes
  using Options = Color_stitching_options;

  /// \param space of a mesh or soup, has to outlive this object
  /// \param options how scans are chosen and stitched
  /// \throws Input_error the surface is a point set
  /// \throws Parameter_error an option is outside its domain
  explicit Color_stitcher(const Spline_space_3& space, const Options& options = Options())
    : m_space(&space), m_options(checked(options)),
      m_projector(space.surface(), back_projection_options(options), space.options().is_parallel) {}

  /// the space, as given to the constructor
  const Spline_space_3& space() const { return *m_space; }
  /// the options, as given to the constructor
  const Options& options() const { return m_options; }

  /// Takes the colours of a scan to the surface. The scan is not needed any more then.
  /// \return what the scan gives, as far as it is known by then: `Scan_usage::covered_vertices` may
  /// be 0
  Scan_usage add(const Colored_scan& scan) {
    CGAL::Real_timer timer;
    timer.start();
    Back_projection projection = m_projector(scan);
    if(m_options.linear_light)
      take_to_linear_light(projection);
    Scan_usage usage;
    usage.covered_vertices = projection.vertices.size();
    usage.covered_area = covered_area(projection);
    usage.maximum_distance = projection.maximum_distance;
    usage.facing_vertices = projection.number_of_facing_vertices;
    usage.smallest_distance =
        projection.vertices.empty()
            ? m_projector.smallest_distance(scan)
            : *std::min_element(projection.distances.begin(), projection.distances.end());
    m_projections.push_back(std::move(projection));
    m_usages.push_back(usage);
    m_scans_of_faces.clear();
    m_scans_of_vertices.clear();
    m_back_projection_seconds += timer.time();
    return usage;
  }

  /// how many scans were added
  std::size_t number_of_scans() const { return m_projections.size(); }
  /// The colours of a scan on the surface, in linear light if that is asked for.
  const Back_projection& back_projection(std::size_t scan) const { return m_projections[scan]; }
  /// what the scans give; all that it holds is known after `choose()`
  const std::vector<Scan_usage>& usages() const { return m_usages; }

  /// Chooses a scan for each triangle, and matches exposures.
  /// \throws Input_error there is no scan, or no scan covers a triangle; the message says how near
  /// they come
  void choose() {
    CGAL::Real_timer timer;
    timer.start();
    const internal::Scan_choice choice(surface(), m_projections, m_options.quality_smoothing_steps,
                                       m_options.seam_weight, is_parallel());
    check_coverage(choice.scans_of_faces());
    m_scans_of_faces = choice.scans_of_faces();
    m_scans_of_vertices = choice.scans_of_vertices();
    m_seam_length = choice.seam_length();
    for(Scan_usage& usage : m_usages)
      usage.chosen_area = 0;
    for(std::size_t f = 0; f < m_scans_of_faces.size(); ++f)
      if(m_scans_of_faces[f] != no_scan)
        m_usages[m_scans_of_faces[f]].chosen_area += surface().area(f) / surface().area();
    if(m_options.match_exposures) {
      const std::vector<Rgb_color> gains = internal::exposure_gains(m_projections);
      for(std::size_t s = 0; s < gains.size(); ++s)
        m_usages[s].gains = gains[s];
    }
    m_choice_seconds = timer.time();
  }

  /// the scan of each face, or `no_scan`; empty before `choose()`
  const std::vector<std::uint32_t>& scans_of_faces() const { return m_scans_of_faces; }
  /// the scan of each vertex, one of those of its faces, or `no_scan`; empty before `choose()`
  const std::vector<std::uint32_t>& scans_of_vertices() const { return m_scans_of_vertices; }

  /// The colour of the nearest one of the scans that cover a vertex, as it is in the scan: the
  /// usual way, for comparison (paper, Figure 1, left). Needs no `choose()`.
  Vertex_colors nearest_colors() const {
    std::vector<double> distances(surface().number_of_vertices(),
                                  std::numeric_limits<double>::infinity());
    Vertex_colors result = black();
    for(std::uint32_t s = 0; s < m_projections.size(); ++s) {
      const Back_projection& projection = m_projections[s];
      for(std::size_t i = 0; i < projection.vertices.size(); ++i) {
        const std::uint32_t v = projection.vertices[i];
        if(projection.distances[i] < distances[v]) {
          distances[v] = projection.distances[i];
          result.scans[v] = s;
          result.colors[v] = encoded(projection.colors[i]);
        }
      }
    }
    return result;
  }

  /// The colour of the chosen scan of each vertex, as it is in the scan: what is stitched, for
  /// comparison. Calls for `choose()` before.
  Vertex_colors chosen_colors() const {
    Vertex_colors result = black();
    if(m_scans_of_vertices.empty())
      return result;
    result.scans = m_scans_of_vertices;
    for(std::uint32_t s = 0; s < m_projections.size(); ++s)
      for(std::size_t i = 0; i < m_projections[s].vertices.size(); ++i) {
        const std::uint32_t v = m_projections[s].vertices[i];
        if(result.scans[v] == s)
          result.colors[v] = encoded(m_projections[s].colors[i]);
      }
    return result;
  }

  /// Stitches the colours; calls `choose()` unless that was done.
  /// \throws Input_error as `choose()`
  Stitched_colors stitch() {
    if(m_scans_of_faces.empty())
      choose();
    std::vector<Eigen::Vector3d> colors =
        corner_values<Eigen::Vector3d>([](const Back_projection& projection, std::size_t i) {
          return internal::eigen_vector(projection.colors[i]);
        });
    fill(colors);
    const Corner_colors target(std::move(colors));
    Stitched_colors result;
    Eigen::MatrixXd values;
    if(m_options.gradient_source == Gradient_source::scans)
      values = integrate(scan_gradients(target), target, result);
    else
      values = integrate(back_projected_gradients(target), target, result);
    finish(values, result);
    return result;
  }

private:
  using Corner_colors = Corner_vector_field<Eigen::Vector3d>;

  static Options checked(const Options& options) {
    const auto check = [](bool is_good, const char* name, double value, const char* domain) {
      if(!is_good)
        throw Parameter_error(name, "is " + std::to_string(value) + ", but must be " + domain);
    };
    const double weight = options.seam_weight, alpha = options.screening_weight.value_or(1);
    check(weight >= 0 && std::isfinite(weight), "seam_weight", weight,
          "a finite number that is not negative");
    check(alpha > 0 && std::isfinite(alpha), "screening_weight", alpha, "a positive finite number");
    check(options.quality_smoothing_steps >= 0, "quality_smoothing_steps",
          options.quality_smoothing_steps, "0 or more");
    return options;
  }

  static Back_projection_options back_projection_options(const Options& options) {
    Back_projection_options result = options.back_projection;
    result.with_gradients = options.gradient_source == Gradient_source::scans;
    return result;
  }

  const Triangulated_surface_3& surface() const { return m_space->surface(); }
  bool is_parallel() const { return m_space->options().is_parallel; }

  static void take_to_linear_light(Back_projection& projection) {
    for(std::size_t i = 0; i < projection.colors.size(); ++i)
      for(int k = 0; k < 3; ++k) {
        double& x = projection.colors[i][k];
        if(!projection.gradients.empty())
          projection.gradients[i].col(k) *= internal::srgb_to_linear_derivative(x);
        x = srgb_to_linear(x);
      }
  }

  /// as colours are given and returned
  Rgb_color encoded(const Rgb_color& color) const {
    if(!m_options.linear_light)
      return color;
    return {linear_to_srgb(color[0]), linear_to_srgb(color[1]), linear_to_srgb(color[2])};
  }

  Vertex_colors black() const {
    const std::size_t n = surface().number_of_vertices();
    return {std::vector<Rgb_color>(n, Rgb_color{0, 0, 0}), std::vector<std::uint32_t>(n, no_scan)};
  }

  double covered_area(const Back_projection& projection) const {
    std::vector<char> is_covered(surface().number_of_vertices(), 0);
    for(std::uint32_t v : projection.vertices)
      is_covered[v] = 1;
    double area = 0;
    for(std::size_t f = 0; f < surface().number_of_faces(); ++f) {
      const Triangulated_surface_3::Triangle& t = surface().triangle(f);
      if(is_covered[t[0]] && is_covered[t[1]] && is_covered[t[2]])
        area += surface().area(f);
    }
    return area / surface().area();
  }

  void check_coverage(const std::vector<std::uint32_t>& scans_of_faces) const {
    if(m_projections.empty())
      throw Input_error("there is no scan to take colors from");
    for(std::size_t f = 0; f < scans_of_faces.size(); ++f)
      if(scans_of_faces[f] != no_scan && !surface().is_degenerate(f))
        return;
    std::size_t nearest = 0, covered = 0, facing = 0;
    for(std::size_t s = 0; s < m_usages.size(); ++s) {
      if(m_usages[s].smallest_distance < m_usages[nearest].smallest_distance)
        nearest = s;
      covered += m_usages[s].covered_vertices;
      facing += m_usages[s].facing_vertices;
    }
    const Scan_usage& usage = m_usages[nearest];
    if(facing == 0)
      throw Input_error(
          "the surface faces the viewpoint of no scan: viewpoints are on its back, or "
          "it is oriented the other way round");
    if(usage.smallest_distance > usage.maximum_distance)
      throw Input_error("no scan comes near the surface: the smallest distance, of scan " +
                        std::to_string(nearest) + ", is " +
                        std::to_string(usage.smallest_distance) + ", and up to " +
                        std::to_string(usage.maximum_distance) + " counts as near");
    throw Input_error(
        "no scan covers a triangle of the surface: " + std::to_string(covered) +
        " vertices are covered, others face away from the viewpoints, are not near, or "
        "differ from the scans in their normals");
  }

  /// Three values for each face, at its corners, from the back-projection of its scan; 0 for faces
  /// without one. The channels, in the last dimension of `T`, are multiplied by the gains.
  /// \param value_of `Back_projection` and a position in it &rarr; `T`
  template <class T, class ValueOf> std::vector<T> corner_values(ValueOf&& value_of) const {
    std::vector<T> result(3 * surface().number_of_faces(), T(T::Zero()));
    std::vector<std::vector<std::uint32_t>> faces_of_scans(m_projections.size());
    for(std::size_t f = 0; f < m_scans_of_faces.size(); ++f)
      if(m_scans_of_faces[f] != no_scan)
        faces_of_scans[m_scans_of_faces[f]].push_back(static_cast<std::uint32_t>(f));
    std::vector<std::uint32_t> positions(surface().number_of_vertices());
    for(std::size_t s = 0; s < m_projections.size(); ++s) {
      const Back_projection& projection = m_projections[s];
      for(std::size_t i = 0; i < projection.vertices.size(); ++i)
        positions[projection.vertices[i]] = static_cast<std::uint32_t>(i);
      const Eigen::Vector3d gains = internal::eigen_vector(m_usages[s].gains);
      for(std::uint32_t f : faces_of_scans[s])
        for(std::size_t corner = 0; corner < 3; ++corner) {
          T value = value_of(projection, positions[surface().triangle(f)[corner]]);
          if constexpr(T::ColsAtCompileTime == 1)
            value = value.cwiseProduct(gains).eval();
          else
            value = (value * gains.asDiagonal()).eval();
          result[3 * f + corner] = value;
        }
    }
    return result;
  }

  /// Colours for the triangles without a scan: harmonic functions that take the colours of the
  /// chosen scans on the borders.
  void fill(std::vector<Eigen::Vector3d>& colors) const {
    const std::size_t n = surface().number_of_vertices();
    Eigen::MatrixXd values = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(n), 3);
    std::vector<char> is_known(n, 0);
    for(std::size_t f = 0; f < m_scans_of_faces.size(); ++f)
      for(std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t v = surface().triangle(f)[i];
        if(m_scans_of_faces[f] != no_scan && m_scans_of_faces[f] == m_scans_of_vertices[v]) {
          values.row(v) = colors[3 * f + i].transpose();
          is_known[v] = 1;
        }
      }
    internal::fill_harmonically(surface(), is_known, values);
    for(std::size_t f = 0; f < m_scans_of_faces.size(); ++f)
      for(std::size_t i = 0; i < 3 && m_scans_of_faces[f] == no_scan; ++i)
        colors[3 * f + i] = values.row(surface().triangle(f)[i]).transpose();
  }

  /// of the linear functions that take the colours of the corners
  Eigen::Matrix3d gradient(const Corner_colors& colors, std::size_t face) const {
    if(surface().is_degenerate(face))
      return Eigen::Matrix3d::Zero();
    const Eigen::Matrix3d of_hats = internal::hat_gradients(surface(), face);
    const Eigen::Vector3d* const c = colors.values().data() + 3 * face;
    return of_hats.col(1) * (c[1] - c[0]).transpose() + of_hats.col(2) * (c[2] - c[0]).transpose();
  }

  Face_function<Eigen::Matrix3d> back_projected_gradients(const Corner_colors& colors) const {
    std::vector<Eigen::Matrix3d> gradients(surface().number_of_faces());
    internal::parallel_for(is_parallel(), 0, gradients.size(), 1 << 12,
                           [&](std::size_t begin, std::size_t end) {
                             for(std::size_t f = begin; f < end; ++f)
                               gradients[f] = gradient(colors, f);
                           });
    return Face_function<Eigen::Matrix3d>(std::move(gradients));
  }

  /// Tangential parts are taken where the field is integrated.
  Corner_vector_field<Eigen::Matrix3d> scan_gradients(const Corner_colors& colors) const {
    std::vector<Eigen::Matrix3d> gradients = corner_values<Eigen::Matrix3d>(
        [](const Back_projection& projection, std::size_t i) { return projection.gradients[i]; });
    for(std::size_t f = 0; f < m_scans_of_faces.size(); ++f)
      if(m_scans_of_faces[f] == no_scan)
        std::fill_n(gradients.begin() + static_cast<std::ptrdiff_t>(3 * f), 3, gradient(colors, f));
    return Corner_vector_field<Eigen::Matrix3d>(std::move(gradients));
  }

  /// the solution at the vertices
  template <class Field>
  Eigen::MatrixXd integrate(const Field& field, const Corner_colors& target,
                            Stitched_colors& result) const {
    const double alpha =
        m_options.screening_weight.value_or(Options::default_screening / surface().area());
    std::vector<double> weights(surface().number_of_faces(), 0);
    for(std::size_t f = 0; f < weights.size(); ++f)
      if(m_scans_of_faces[f] != no_scan)
        weights[f] = alpha;
    // by reference: the values are three for each face
    const auto target_function =
        function_of_degree([&](const Surface_point& p) -> Eigen::Vector3d { return target(p); }, 1);
    const Face_function<double> weight(std::move(weights));
    const internal::Screening<3, std::decay_t<decltype(target_function)>, Face_function<double>>
        screening(target_function, weight, parameters::default_values());
    internal::Gradient_options options = {
        m_options.solver,
        m_options.normal_stabilization.value_or(default_normal_stabilization(*m_space))};
    options.solver.is_parallel = is_parallel();
    internal::Gradient_solution<3> solution =
        internal::integrate_gradients<3>(*m_space, Cubature(*m_space), field, screening, options);
    Eigen::MatrixXd values =
        Spline_functions_3(*m_space, solution.fit.coefficients).values_at_vertices();
    if(m_options.vertex_details) {
      Poisson_solver_options of_details = options.solver;
      of_details.relative_tolerance =
          (std::max)(of_details.relative_tolerance, m_options.details_tolerance);
      internal::add_details(*m_space, field, screening, of_details, solution, values);
    }
    static_cast<Gradient_report&>(result) = solution.fit;
    return values;
  }

  /// colours from the values of the solution, and what is to be reported
  void finish(const Eigen::MatrixXd& values, Stitched_colors& result) const {
    constexpr double clamping_tolerance = 1e-3; // a quarter of a step of bytes
    const std::size_t n = surface().number_of_vertices();
    result.colors.assign(n, Rgb_color{0, 0, 0});
    for(std::size_t v = 0; v < n; ++v) {
      const auto row = values.row(static_cast<Eigen::Index>(v));
      if(!row.allFinite())
        continue; // no face
      Rgb_color color;
      for(int k = 0; k < 3; ++k) {
        if(row[k] < -clamping_tolerance || row[k] > 1 + clamping_tolerance)
          ++result.clamped_values;
        color[k] = std::clamp(row[k], 0., 1.);
      }
      result.colors[v] = encoded(color);
    }
    result.scans = m_usages;
    for(std::size_t f = 0; f < m_scans_of_faces.size(); ++f)
      if(m_scans_of_faces[f] == no_scan)
        result.uncovered_area += surface().area(f) / surface().area();
    result.uncovered_vertices = static_cast<std::size_t>(
        std::count(m_scans_of_vertices.begin(), m_scans_of_vertices.end(), no_scan));
    result.seam_length = m_seam_length;
    const auto transitions = scan_transitions(surface(), m_scans_of_vertices);
    result.jump_before = mean_color_jump(transitions, chosen_colors().colors);
    result.jump_after = mean_color_jump(transitions, result.colors);
    result.back_projection_seconds = m_back_projection_seconds;
    result.choice_seconds = m_choice_seconds;
  }

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

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_COLOR_STITCHER_H

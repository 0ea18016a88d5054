// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_COLOR_STITCHER_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_COLOR_STITCHER_IMPL_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/integration/cubature.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_functions_3.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/Surface_edges.h>
#include <CGAL/Restricted_laplacian_3/textures/Color_stitcher.h>
#include <CGAL/Restricted_laplacian_3/textures/internal/Scan_choice.h>
#include <CGAL/Restricted_laplacian_3/textures/internal/exposure_gains.h>
#include <CGAL/Restricted_laplacian_3/textures/internal/harmonic_fill.h>
#include <CGAL/Restricted_laplacian_3/textures/internal/scan_properties.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// \throws Parameter_error an option is outside its domain
inline Color_stitching_options checked_options(const Color_stitching_options& options) {
  const auto check = [](bool is_good, const char* name, double value, const char* domain) {
    if(!is_good)
      throw Parameter_error(name, "is " + std::to_string(value) + ", but must be " + domain);
  };
  const double weight = options.seam_weight, alpha = options.alpha.value_or(1);
  check(weight >= 0 && std::isfinite(weight), "seam_weight", weight,
        "a finite number that is not negative");
  check(alpha > 0 && std::isfinite(alpha), "alpha", alpha, "a positive finite number");
  check(options.quality_smoothing_steps >= 0, "quality_smoothing_steps",
        options.quality_smoothing_steps, "0 or more");
  return options;
}

inline Back_projection_options back_projection_options(const Color_stitching_options& options,
                                                       bool is_parallel) {
  Back_projection_options result = options.back_projection;
  result.with_gradients = options.gradients == Gradient_source::scans;
  result.is_parallel = is_parallel;
  return result;
}

inline void take_to_linear_light(Back_projection& projection) {
  for(std::size_t i = 0; i < projection.colors.size(); ++i)
    for(int k = 0; k < 3; ++k) {
      double& x = projection.colors[i][k];
      if(!projection.gradients.empty())
        projection.gradients[i].col(k) *= internal::srgb_to_linear_derivative(x);
      x = srgb_to_linear(x);
    }
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<std::pair<std::uint32_t, std::uint32_t>>
scan_transitions(const Triangulated_surface_3& surface, const std::vector<std::uint32_t>& scans) {
  if(scans.size() != surface.number_of_vertices())
    throw Parameter_error("scans", "has another length than the vertices");
  const internal::Surface_edges edges(surface, internal::Surface_edges::Faces::not_degenerate);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> result;
  for(std::size_t e = 0; e < edges.size(); ++e) {
    const auto& [v, w] = edges.ends(e);
    if(scans[v] != scans[w] && scans[v] != no_scan && scans[w] != no_scan)
      result.emplace_back(v, w);
  }
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE double
mean_color_jump(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& edges,
                const std::vector<Rgb_color>& colors) {
  double sum = 0;
  for(const auto& [v, w] : edges) {
    if((std::max)(v, w) >= colors.size())
      throw Parameter_error("edges", "name a vertex that has no color");
    sum += (internal::eigen_vector(colors[v]) - internal::eigen_vector(colors[w])).norm();
  }
  return edges.empty() ? 0 : sum / static_cast<double>(edges.size());
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Color_stitcher::Color_stitcher(const Spline_space_3& space,
                                                                  const Options& options)
  : m_space(space), m_options(internal::checked_options(options)),
    m_projector(space.surface(),
                internal::back_projection_options(options, space.options().is_parallel)) {}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Scan_usage Color_stitcher::add(const Colored_scan& scan) {
  CGAL::Real_timer timer;
  timer.start();
  Back_projection projection = m_projector(scan);
  if(m_options.linear_light)
    internal::take_to_linear_light(projection);
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

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void Color_stitcher::choose() {
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

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Vertex_colors Color_stitcher::nearest_colors() const {
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

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Vertex_colors Color_stitcher::chosen_colors() const {
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

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Stitched_colors
Color_stitcher::stitch(const std::function<bool(double)>& callback) {
  const internal::Progress progress(callback);
  progress(0);
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
  if(m_options.gradients == Gradient_source::scans)
    values = integrate(scan_gradients(target), target, progress.part(0.2, 1), result);
  else
    values = integrate(back_projected_gradients(target), target, progress.part(0.2, 1), result);
  finish(values, result);
  progress(1);
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Rgb_color Color_stitcher::encoded(const Rgb_color& color) const {
  if(!m_options.linear_light)
    return color;
  return {linear_to_srgb(color[0]), linear_to_srgb(color[1]), linear_to_srgb(color[2])};
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Vertex_colors Color_stitcher::black() const {
  const std::size_t n = surface().number_of_vertices();
  return {std::vector<Rgb_color>(n, Rgb_color{0, 0, 0}), std::vector<std::uint32_t>(n, no_scan)};
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE double
Color_stitcher::covered_area(const Back_projection& projection) const {
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

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
Color_stitcher::check_coverage(const std::vector<std::uint32_t>& scans_of_faces) const {
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
    throw Input_error("the surface faces the viewpoint of no scan: viewpoints are on its back, or "
                      "it is oriented the other way round");
  if(usage.smallest_distance > usage.maximum_distance)
    throw Input_error("no scan comes near the surface: the smallest distance, of scan " +
                      std::to_string(nearest) + ", is " + std::to_string(usage.smallest_distance) +
                      ", and up to " + std::to_string(usage.maximum_distance) + " counts as near");
  throw Input_error("no scan covers a triangle of the surface: " + std::to_string(covered) +
                    " vertices are covered, others face away from the viewpoints, are not near, or "
                    "differ from the scans in their normals");
}

template <class T, class ValueOf>
std::vector<T> Color_stitcher::corner_values(ValueOf&& value_of) const {
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

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
Color_stitcher::fill(std::vector<Eigen::Vector3d>& colors) const {
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

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::Matrix3d
Color_stitcher::gradient(const Corner_colors& colors, std::size_t face) const {
  if(surface().is_degenerate(face))
    return Eigen::Matrix3d::Zero();
  const Eigen::Matrix3d of_hats = internal::hat_gradients(surface(), face);
  const Eigen::Vector3d* const c = colors.values().data() + 3 * face;
  return of_hats.col(1) * (c[1] - c[0]).transpose() + of_hats.col(2) * (c[2] - c[0]).transpose();
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Face_function<Eigen::Matrix3d>
Color_stitcher::back_projected_gradients(const Corner_colors& colors) const {
  std::vector<Eigen::Matrix3d> gradients(surface().number_of_faces());
  internal::parallel_for(is_parallel(), 0, gradients.size(), 1 << 12,
                         [&](std::size_t begin, std::size_t end) {
                           for(std::size_t f = begin; f < end; ++f)
                             gradients[f] = gradient(colors, f);
                         });
  return Face_function<Eigen::Matrix3d>(std::move(gradients));
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Corner_vector_field<Eigen::Matrix3d>
Color_stitcher::scan_gradients(const Corner_colors& colors) const {
  std::vector<Eigen::Matrix3d> gradients = corner_values<Eigen::Matrix3d>(
      [](const Back_projection& projection, std::size_t i) { return projection.gradients[i]; });
  for(std::size_t f = 0; f < m_scans_of_faces.size(); ++f)
    if(m_scans_of_faces[f] == no_scan)
      std::fill_n(gradients.begin() + static_cast<std::ptrdiff_t>(3 * f), 3, gradient(colors, f));
  return Corner_vector_field<Eigen::Matrix3d>(std::move(gradients));
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::MatrixXd
Color_stitcher::integrate(const Vector_field_view& field, const Corner_colors& target,
                          const internal::Progress& progress, Stitched_colors& result) const {
  const double alpha = m_options.alpha.value_or(default_screening / surface().area());
  std::vector<double> weights(surface().number_of_faces(), 0);
  for(std::size_t f = 0; f < weights.size(); ++f)
    if(m_scans_of_faces[f] != no_scan)
      weights[f] = alpha;
  // by reference: the values are three for each face
  const auto target_function =
      function_of_degree([&](const Surface_point& p) -> Eigen::Vector3d { return target(p); }, 1);
  const Face_function<double> weight(std::move(weights));
  Gradient_options options;
  options.screening.target = target_function;
  options.screening.weight_function = weight;
  options.stabilization = m_options.stabilization;
  options.solver = m_options.solver;
  options.solver.is_parallel = is_parallel();
  internal::Gradient_solution solution = internal::integrate_gradients(
      m_space, field, options, progress.part(0, m_options.details ? 0.8 : 1));
  Eigen::MatrixXd values =
      Spline_functions_3(m_space, solution.fit.coefficients).values_at_vertices();
  if(m_options.details) {
    const double tolerance =
        (std::max)(internal::tolerance_of(options.solver), m_options.details_tolerance);
    internal::add_details(m_space, field, options.screening, tolerance,
                          options.solver.maximum_iterations, solution, values);
  }
  static_cast<Gradient_report&>(result) = solution.fit;
  return values;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void Color_stitcher::finish(const Eigen::MatrixXd& values,
                                                               Stitched_colors& result) const {
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

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_COLOR_STITCHER_IMPL_H

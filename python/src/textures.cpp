// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Colors from several scans.

#include "options.h"

#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/textures/Color_stitcher.h>
#include <CGAL/Restricted_laplacian_3/textures/Colored_scan.h>

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <array>
#include <string>

namespace python {
namespace {

using namespace nb::literals;

RL::Colored_scan make_scan(const RL::Triangulated_surface_3& surface, const Rows& colors,
                           const Rows& pose, const Numbers& viewpoint, int threads) {
  std::vector<RL::Rgb_color> own_colors(colors.shape(0));
  if(colors.shape(1) != 3)
    throw RL::Parameter_error("colors", "needs three columns");
  for(std::size_t i = 0; i < own_colors.size(); ++i)
    std::copy_n(colors.data() + 3 * i, 3, own_colors[i].begin());
  if(pose.shape(0) != 4 || pose.shape(1) != 4)
    throw RL::Parameter_error("pose", "must be a matrix of four rows and columns");
  if(viewpoint.size() != 3)
    throw RL::Parameter_error("viewpoint", "must have three coordinates");
  std::array<double, 16> rows;
  std::copy_n(pose.data(), 16, rows.begin());
  const double* const eye = viewpoint.data();
  return run(threads, nb::none(), [&](const auto&) {
    return RL::Colored_scan(surface, std::move(own_colors), RL::scan_pose(rows),
                            RL::Point_3(eye[0], eye[1], eye[2]), threads != 1);
  });
}

nb::tuple stitch_colors(const RL::Spline_space_3& space,
                        const std::vector<const RL::Colored_scan*>& scans, const nb::dict& options,
                        int threads, const nb::object& progress) {
  RL::Color_stitching_options o;
  if(const auto distance = number_of(options, "maximum_distance"))
    o.back_projection.maximum_distance = *distance;
  if(const auto angle = number_of(options, "normal_angle"))
    o.back_projection.normal_angle = *angle;
  o.back_projection.oriented = number_of(options, "oriented").value_or(1) != 0;
  o.gradients = text_of(options, "gradients", "back-projection") == "scans"
                    ? RL::Gradient_source::scans
                    : RL::Gradient_source::back_projection;
  o.match_exposures = number_of(options, "match_exposures").value_or(1) != 0;
  o.linear_light = number_of(options, "linear_light").value_or(0) != 0;
  o.details = number_of(options, "details").value_or(1) != 0;
  o.alpha = number_of(options, "alpha");
  o.stabilization = number_of(options, "stabilization");
  o.solver = solver_options(options, threads);
  std::vector<std::uint32_t> scans_of_vertices;
  RL::Stitched_colors stitched = run(threads, progress, [&](const auto& callback) {
    RL::Color_stitcher stitcher(space, o);
    const RL::internal::Progress whole(callback);
    for(std::size_t i = 0; i < scans.size(); ++i) {
      whole.part(0, 0.5)(static_cast<double>(i) / static_cast<double>(scans.size()));
      stitcher.add(*scans[i]);
    }
    RL::Stitched_colors result = stitcher.stitch(whole.part(0.5, 1).callback());
    scans_of_vertices = stitcher.scans_of_vertices();
    return result;
  });
  std::vector<double> colors;
  for(const RL::Rgb_color& color : stitched.colors)
    colors.insert(colors.end(), color.begin(), color.end());
  std::vector<std::int64_t> chosen;
  for(const std::uint32_t scan : scans_of_vertices)
    chosen.push_back(scan == RL::no_scan ? -1 : static_cast<std::int64_t>(scan));
  nb::dict report = report_of(stitched);
  report["uncovered_area"] = stitched.uncovered_area;
  report["uncovered_vertices"] = stitched.uncovered_vertices;
  report["seam_length"] = stitched.seam_length;
  report["jump_before"] = stitched.jump_before;
  report["jump_after"] = stitched.jump_after;
  report["clamped_values"] = stitched.clamped_values;
  nb::list covered;
  for(const RL::Scan_usage& usage : stitched.scans)
    covered.append(usage.covered_area);
  report["covered_areas"] = covered;
  return nb::make_tuple(array_of_rows(std::move(colors), 3), array_of_rows(std::move(chosen), 1),
                        report);
}

} // namespace

void add_textures(nb::module_& m) {
  nb::class_<RL::Colored_scan>(m, "Scan");
  m.def("make_scan", &make_scan, "surface"_a, "colors"_a, "pose"_a, "viewpoint"_a, "threads"_a);
  m.def("stitch_colors", &stitch_colors, "space"_a, "scans"_a, "options"_a, "threads"_a,
        "progress"_a.none());
}

} // namespace python

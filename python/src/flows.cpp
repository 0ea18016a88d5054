// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces that move, and are edited.

#include "functions.h"
#include "options.h"

#include <CGAL/Restricted_laplacian_3/problems/Mean_curvature_flow.h>
#include <CGAL/Restricted_laplacian_3/problems/Surface_editor.h>
#include <CGAL/Restricted_laplacian_3/problems/map_to_sphere.h>
#include <CGAL/Restricted_laplacian_3/problems/scale_details.h>

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include <optional>
#include <string>
#include <utility>

namespace python {
namespace {

using namespace nb::literals;
using Flow = RL::Mean_curvature_flow;

Flow make_flow(const RL::Spline_space_3& space, bool conformal,
               const std::optional<std::string>& rescaling, bool fixed_boundary,
               std::optional<double> tolerance, std::optional<double> stabilization, int threads) {
  RL::Mean_curvature_flow_options o;
  o.conformal = conformal;
  if(rescaling)
    o.rescaling = *rescaling == "area"     ? RL::Rescaling::area
                  : *rescaling == "volume" ? RL::Rescaling::volume
                                           : RL::Rescaling::none;
  o.fixed_boundary = fixed_boundary;
  o.tolerance = tolerance.value_or(o.tolerance);
  o.stabilization = stabilization;
  return run(threads, nb::none(), [&](const auto&) { return Flow(space, o); });
}

nb::dict flow_report_of(const RL::Flow_report& r) {
  nb::dict report = report_of(r);
  report["time"] = r.time;
  report["area"] = r.area;
  report["volume"] = r.volume;
  report["smallest_angle"] = r.smallest_angle;
  report["mean_distortion"] = r.mean_distortion;
  report["largest_distortion"] = r.largest_distortion;
  report["sphere_deviation"] = r.sphere_deviation;
  report["collapse"] = r.collapse;
  return report;
}

nb::dict step(Flow& flow, double time_step, int threads) {
  return flow_report_of(
      run(threads, nb::none(), [&](const auto&) { return flow.step(time_step); }));
}

// (positions, report)
nb::tuple map_to_sphere(const RL::Spline_space_3& space, std::optional<double> tolerance,
                        std::optional<int> maximum_iterations, std::optional<double> stabilization,
                        int threads, const nb::object& progress) {
  RL::Sphere_map_options o;
  o.tolerance = tolerance.value_or(o.tolerance);
  o.maximum_iterations = maximum_iterations.value_or(o.maximum_iterations);
  o.stabilization = stabilization;
  RL::Sphere_map map = run(threads, progress, [&](const auto& callback) {
    o.progress = callback;
    return RL::map_to_sphere(space, o);
  });
  nb::dict report = flow_report_of(map);
  report["folded_faces"] = map.folded_faces;
  return nb::make_tuple(array_of_matrix(std::move(map.positions)), report);
}

RL::Editing_options editing_options(const nb::dict& options) {
  RL::Editing_options o;
  o.tolerance = number_of(options, "tolerance").value_or(o.tolerance);
  o.stabilization = number_of(options, "stabilization");
  o.crease_angle = number_of(options, "crease_angle");
  o.anisotropic = number_of(options, "anisotropic").value_or(o.anisotropic);
  return o;
}

Eigen::MatrixXd signal_of(const std::optional<Rows>& signal) {
  return signal ? matrix_of(*signal) : Eigen::MatrixXd();
}

nb::tuple edited(RL::Edited_signal result) {
  const nb::dict report = report_of(result);
  return nb::make_tuple(array_of_matrix(std::move(result.values)), report);
}

// (values, report)
nb::tuple scale_details(const RL::Spline_space_3& given, bool has_depth, double length,
                        double factor, const std::optional<Rows>& signal, const nb::dict& options,
                        int threads, const nb::object& progress) {
  RL::Editing_options o = editing_options(options);
  const Eigen::MatrixXd x = signal_of(signal);
  return edited(run(threads, progress, [&](const auto& callback) {
    o.progress = callback;
    const RL::Spline_space_3 space = RL::internal::space_for_details(given, has_depth, o);
    return o.crease_angle ? RL::smooth_between_creases(space, length, o)
                          : RL::scale_details(space, length, factor, o, x);
  }));
}

RL::Surface_editor make_editor(const RL::Spline_space_3& space, double alpha,
                               const std::optional<Rows>& signal, const nb::dict& options,
                               int threads) {
  const RL::Editing_options o = editing_options(options);
  const Eigen::MatrixXd x = signal_of(signal);
  return run(threads, nb::none(), [&](const auto&) {
    return RL::Surface_editor(RL::internal::space_to_edit(space, alpha, o), alpha, o, x);
  });
}

} // namespace

void add_flows(nb::module_& m) {
  m.def("scale_details", &scale_details, "space"_a, "has_depth"_a, "length"_a, "factor"_a,
        "signal"_a.none(), "options"_a, "threads"_a, "progress"_a.none());
  nb::class_<RL::Surface_editor>(m, "Editor")
      .def_static("make", &make_editor, "space"_a, "alpha"_a, "signal"_a.none(), "options"_a,
                  "threads"_a)
      .def("edit", [](const RL::Surface_editor& editor,
                      double gradient_scale) { return edited(editor.edit(gradient_scale)); })
      .def("edit_by",
           [](const RL::Surface_editor& editor, const Function& gradient_scale, int threads) {
             check_function(gradient_scale, editor.space().surface(), "gradient_scale", 1);
             return edited(run(threads, nb::none(),
                               [&](const auto&) { return editor.edit(gradient_scale); }));
           });
  m.def("map_to_sphere", &map_to_sphere, "space"_a, "tolerance"_a.none(),
        "maximum_iterations"_a.none(), "stabilization"_a.none(), "threads"_a, "progress"_a.none());
  nb::class_<Flow>(m, "Flow")
      .def_static("make", &make_flow, "space"_a, "conformal"_a, "rescaling"_a.none(),
                  "fixed_boundary"_a, "tolerance"_a.none(), "stabilization"_a.none(), "threads"_a)
      .def("step", &step, "time_step"_a, "threads"_a)
      .def("positions",
           [](const Flow& flow) {
             return array_of_matrix(Eigen::MatrixXd(flow.vertex_positions()));
           })
      .def("coefficients",
           [](const Flow& flow) { return array_of_matrix(Eigen::MatrixXd(flow.coefficients())); })
      .def("moved_space", &Flow::moved_space)
      .def_prop_ro("time", &Flow::time);
}

} // namespace python

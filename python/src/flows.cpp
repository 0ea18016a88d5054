// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces that move.

#include "functions.h"

#include <CGAL/Restricted_laplacian_3/problems/Mean_curvature_flow.h>

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

nb::dict step(Flow& flow, double time_step, int threads) {
  const RL::Flow_report r =
      run(threads, nb::none(), [&](const auto&) { return flow.step(time_step); });
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

} // namespace

void add_flows(nb::module_& m) {
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

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Poisson problems, fits, curvature, gradient fields.

#include "functions.h"
#include "options.h"

#include <CGAL/Restricted_laplacian_3/problems/Curvature_field.h>
#include <CGAL/Restricted_laplacian_3/problems/Diffusion_solver.h>
#include <CGAL/Restricted_laplacian_3/problems/Function_fitter.h>
#include <CGAL/Restricted_laplacian_3/problems/Poisson_problem.h>
#include <CGAL/Restricted_laplacian_3/problems/Poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/problems/integrate_gradients.h>
#include <CGAL/Restricted_laplacian_3/problems/stabilization.h>
#include <CGAL/Restricted_laplacian_3/solvers/Multigrid_solver.h>

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>

namespace python {
namespace {

using namespace nb::literals;
using Space = RL::Spline_space_3;

// (space, coefficients, report)
nb::tuple solve_poisson(const Space& given, const Function& f, double alpha,
                        const Function* alpha_function, const Function* boundary_values,
                        const Function* boundary_flux, const std::optional<Numbers>& constrained,
                        std::optional<double> constraint_weight, std::optional<double> accuracy,
                        const nb::dict& options, int threads, const nb::object& progress) {
  const RL::Triangulated_surface_3& surface = given.surface();
  check_function(f, surface, "f");
  if(alpha_function)
    check_function(*alpha_function, surface, "alpha", 1);
  if(boundary_values)
    check_function(*boundary_values, surface, "boundary_values", 1);
  if(boundary_flux)
    check_function(*boundary_flux, surface, "boundary_flux", 1);
  RL::Poisson_problem problem(f);
  problem.alpha = alpha;
  if(alpha_function)
    problem.alpha_function = *alpha_function;
  if(boundary_values) {
    problem.boundary_values = *boundary_values;
    problem.has_boundary_value = [boundary_values](const RL::Surface_point& p) {
      double value;
      (*boundary_values)(&p, 1, &value);
      return !std::isnan(value);
    };
  }
  if(boundary_flux)
    problem.boundary_flux = *boundary_flux;
  problem.solver = solver_options(options, threads);
  problem.stabilization = number_of(options, "stabilization");
  if(constrained) {
    // of each: vertex, value
    problem.vertex_values.assign(surface.number_of_vertices(),
                                 std::numeric_limits<double>::quiet_NaN());
    for(std::size_t i = 0; i < constrained->size(); i += 2) {
      const double v = constrained->data()[i], value = constrained->data()[i + 1];
      if(!(v >= 0 && v < static_cast<double>(problem.vertex_values.size()) && v == std::floor(v)))
        throw RL::Parameter_error("constraints",
                                  "names vertex " + std::to_string(v) + ", which does not exist");
      if(!std::isfinite(value))
        throw RL::Parameter_error("constraints", "has a value that is not a finite number");
      double& known = problem.vertex_values[static_cast<std::size_t>(v)];
      if(known != value && !std::isnan(known))
        throw RL::Parameter_error("constraints",
                                  "has two values for vertex " + std::to_string(std::size_t(v)));
      known = value;
    }
    problem.vertex_weight = constraint_weight;
  }
  Space space = given;
  const auto integrated = [&](const Space& s) {
    return recorded(s, {&f, alpha_function, boundary_values});
  };
  RL::internal::Poisson_solutions solution = run(threads, progress, [&](const auto& callback) {
    problem.progress = callback;
    return accuracy ? RL::internal::solve_poisson_to_accuracy(space, problem, *accuracy, integrated)
                    : RL::internal::solve_poisson_problems(integrated(space), problem);
  });
  return nb::make_tuple(space, array_of_matrix(std::move(solution.coefficients)),
                        report_of(solution));
}

nb::dict fit_report_of(const RL::Fit_report& report) {
  nb::dict result = report_of(report);
  result["root_mean_square_errors"] =
      array_of_rows(std::vector<double>(report.root_mean_square_errors), 1);
  result["stabilization"] = report.stabilization;
  return result;
}

RL::Function_fit_options fit_options(const nb::dict& options, int threads) {
  RL::Function_fit_options o;
  o.solver = solver_options(options, threads);
  o.solver.energy_tolerance = 0; // relative to the solution
  o.smoothing = number_of(options, "smoothing").value_or(0);
  o.refinements = whole_number_of(options, "refinements").value_or(0);
  o.stabilization = number_of(options, "stabilization");
  o.energy_tolerance = number_of(options, "energy_tolerance");
  return o;
}

// (space, coefficients, report)
nb::tuple diffuse(const Space& given, double time, const Function& initial, const Function* source,
                  const Function* boundary_values, std::optional<double> accuracy,
                  const nb::dict& options, int threads, const nb::object& progress) {
  check_function(initial, given.surface(), "u0");
  if(source)
    check_function(*source, given.surface(), "source_term", initial.components());
  if(boundary_values)
    check_function(*boundary_values, given.surface(), "boundary_values", 1);
  RL::Diffusion_options o;
  o.tolerance = number_of(options, "tolerance");
  o.stabilization = number_of(options, "stabilization");
  if(const auto limit = whole_number_of(options, "maximum_iterations"))
    o.maximum_iterations = *limit;
  Space space = given;
  RL::Diffused_functions result = run(threads, progress, [&](const auto& callback) {
    RL::internal::Diffusion_problem problem{initial, time, {}, {}, o, callback};
    if(source)
      problem.source = *source;
    if(boundary_values)
      problem.boundary_values = *boundary_values;
    const auto integrated = [&](const Space& s) { return recorded(s, {&initial, source}); };
    return accuracy ? RL::internal::diffuse_to_accuracy(space, problem, *accuracy, integrated)
                    : RL::internal::diffuse_in_space(integrated(space), problem);
  });
  nb::dict report = report_of(result);
  return nb::make_tuple(space, array_of_matrix(std::move(result.coefficients)), report);
}

nb::tuple fit_function(const Space& given, const Function& f, std::optional<double> accuracy,
                       const nb::dict& options, int threads, const nb::object& progress) {
  check_function(f, given.surface(), "f");
  const RL::Function_fit_options o = fit_options(options, threads);
  Space space = given;
  const auto integrated = [&](const Space& s) { return recorded(s, {&f}); };
  RL::Function_fit fit = run(threads, progress, [&](const auto& callback) {
    return accuracy ? RL::internal::fit_function_to_accuracy(
                          space, f, o, *accuracy, RL::internal::Progress(callback), integrated)
                    : RL::Function_fitter(integrated(space), o).fit(f, callback);
  });
  const nb::dict report = fit_report_of(fit);
  return nb::make_tuple(space, array_of_matrix(std::move(fit.coefficients)), report);
}

nb::tuple curvature(const Space& given, const std::string& method, std::optional<double> accuracy,
                    const nb::dict& options, int threads, const nb::object& progress) {
  RL::Curvature_options o;
  o.method = method == "normals"        ? RL::Curvature_method::normals
             : method == "face_normals" ? RL::Curvature_method::face_normals
                                        : RL::Curvature_method::coordinates;
  o.solver = solver_options(options, threads);
  o.solver.energy_tolerance = 0;
  o.smoothing = number_of(options, "smoothing");
  o.refinements = whole_number_of(options, "refinements");
  o.stabilization = number_of(options, "stabilization");
  o.energy_tolerance = number_of(options, "energy_tolerance");
  RL::Fit_report report;
  // mean, Gaussian, two principal values, two directions, normal
  constexpr std::size_t width = 13;
  std::vector<double> rows = run(threads, progress, [&](const auto& callback) {
    o.progress = callback;
    Space space = given;
    const RL::Curvature_field field =
        accuracy ? RL::internal::estimate_curvature_to_accuracy(space, nullptr, o, *accuracy)
                 : RL::estimate_curvature(space, o);
    report = field.report();
    std::vector<double> result;
    for(const RL::Surface_curvature& c : field.at_vertices()) {
      for(const double x : {c.mean, c.gaussian, c.principal_values[0], c.principal_values[1]})
        result.push_back(x);
      for(const RL::Vector_3& v : {c.principal_directions[0], c.principal_directions[1], c.normal})
        for(int axis = 0; axis < 3; ++axis)
          result.push_back(v[axis]);
    }
    return result;
  });
  return nb::make_tuple(array_of_rows(std::move(rows), width), fit_report_of(report));
}

nb::tuple integrate_gradient(const Space& given, const Function& v, const Function* target,
                             std::optional<double> weight, const Function* weight_function,
                             const std::optional<Numbers>& mean, bool details,
                             std::optional<double> accuracy, const nb::dict& options, int threads,
                             const nb::object& progress) {
  const RL::Triangulated_surface_3& surface = given.surface();
  check_function(v, surface, "v");
  if(v.components() % 3 != 0)
    throw RL::Parameter_error("v", "has " + std::to_string(v.components()) +
                                       " components, but needs three for each channel");
  const int channels = v.components() / 3;
  if(target)
    check_function(*target, surface, "target", channels);
  if(weight_function)
    check_function(*weight_function, surface, "weight", 1);
  RL::Gradient_options o;
  if(target)
    o.screening.target = *target;
  o.screening.weight = weight;
  if(weight_function)
    o.screening.weight_function = *weight_function;
  if(mean)
    o.screening.mean =
        Eigen::Map<const Eigen::VectorXd>(mean->data(), static_cast<Eigen::Index>(mean->size()));
  o.stabilization = number_of(options, "stabilization");
  o.solver = solver_options(options, threads);
  Eigen::MatrixXd values;
  RL::internal::Gradient_solution solution = run(threads, progress, [&](const auto& callback) {
    Space space = given;
    const auto integrated = [&](const Space& s) {
      return recorded(s, {&v, target, weight_function});
    };
    const RL::Vector_field_view field(v);
    const RL::internal::Progress part = RL::internal::Progress(callback).part(0, details ? 0.8 : 1);
    RL::internal::Gradient_solution result =
        accuracy ? RL::internal::integrate_gradients_to_accuracy(space, field, o, *accuracy, part,
                                                                 integrated)
                 : RL::internal::integrate_gradients(integrated(space), field, o, part);
    values = RL::Spline_functions_3(space, result.fit.coefficients).values_at_vertices();
    if(details)
      RL::internal::add_details(integrated(space), field, o.screening,
                                RL::internal::tolerance_of(o.solver), o.solver.maximum_iterations,
                                result, values);
    return result;
  });
  nb::dict report = report_of(solution.fit);
  report["root_mean_square_residuals"] =
      array_of_rows(std::move(solution.fit.root_mean_square_residuals), 1);
  report["components_without_weight"] = solution.fit.components_without_weight;
  return nb::make_tuple(array_of_matrix(std::move(values)),
                        array_of_matrix(std::move(solution.fit.coefficients)), report);
}

RL::Poisson_solver make_solver(const Space& space, double alpha, const nb::dict& options,
                               int threads, const nb::object& progress) {
  const RL::Poisson_solver_options o = solver_options(options, threads);
  const double c = number_of(options, "stabilization").value_or(RL::default_stabilization(space));
  return run(threads, progress, [&](const auto& callback) {
    RL::internal::Elliptic_system system;
    system.elliptic.reaction = alpha;
    system.elliptic.stabilization = c;
    return RL::Poisson_solver(space, system, o, RL::internal::Progress(callback));
  });
}

// \param guess a first guess, or nothing
nb::tuple solve(const RL::Poisson_solver& solver, const Rows& b, const std::optional<Rows>& guess,
                std::optional<double> tolerance, int threads, const nb::object& progress) {
  const Eigen::MatrixXd loads = matrix_of(b);
  Eigen::MatrixXd x;
  RL::Solve_options o;
  o.tolerance = tolerance;
  if(guess) {
    x = matrix_of(*guess);
    o.has_first_guess = true;
    if(x.rows() != loads.rows() || x.cols() != loads.cols())
      throw RL::Parameter_error("guess", "has another shape than the right-hand side");
  }
  const RL::Solve_report report = run(threads, progress, [&](const auto& callback) {
    o.progress = callback;
    return solver.solve(loads, x, o);
  });
  return nb::make_tuple(array_of_matrix(std::move(x)), report_of(report));
}

} // namespace

void add_problems(nb::module_& m) {
  m.def("solve_poisson", &solve_poisson, "space"_a, "f"_a, "alpha"_a, "alpha_function"_a.none(),
        "boundary_values"_a.none(), "boundary_flux"_a.none(), "constrained"_a.none(),
        "constraint_weight"_a.none(), "accuracy"_a.none(), "options"_a, "threads"_a,
        "progress"_a.none());
  m.def("diffuse", &diffuse, "space"_a, "time"_a, "initial"_a, "source"_a.none(),
        "boundary_values"_a.none(), "accuracy"_a.none(), "options"_a, "threads"_a,
        "progress"_a.none());
  m.def("fit_function", &fit_function, "space"_a, "f"_a, "accuracy"_a.none(), "options"_a,
        "threads"_a, "progress"_a.none());
  m.def("curvature", &curvature, "space"_a, "method"_a, "accuracy"_a.none(), "options"_a,
        "threads"_a, "progress"_a.none());
  m.def("integrate_gradient", &integrate_gradient, "space"_a, "v"_a, "target"_a.none(),
        "weight"_a.none(), "weight_function"_a.none(), "mean"_a.none(), "details"_a,
        "accuracy"_a.none(), "options"_a, "threads"_a, "progress"_a.none());
  nb::class_<RL::Poisson_solver>(m, "PoissonSolver")
      .def_prop_ro("kernel_dimension", &RL::Poisson_solver::kernel_dimension)
      .def("solve", &solve, "b"_a, "guess"_a.none(), "tolerance"_a.none(), "threads"_a,
           "progress"_a.none());
  m.def("make_solver", &make_solver, "space"_a, "alpha"_a, "options"_a, "threads"_a,
        "progress"_a.none());
}

} // namespace python

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Eigenpairs, and what descriptors make of them.

#include "options.h"

#include <CGAL/Restricted_laplacian_3/problems/space_spectrum.h>
#include <CGAL/Restricted_laplacian_3/spectra/zero_eigenvalues.h>
#include <CGAL/Restricted_laplacian_3/spectral_descriptors.h>

#include <nanobind/eigen/dense.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include <string>

namespace python {
namespace {

using namespace nb::literals;
using Vector = Eigen::VectorXd;
// of NumPy, in either order
using Values = Eigen::Ref<const Eigen::MatrixXd>;

nb::tuple eigenpairs(const RL::Spline_space_3& given, int k, const std::string& eigensolver,
                     bool eigenvalues_only, std::optional<double> accuracy, const nb::dict& options,
                     int threads, const nb::object& progress) {
  RL::Laplace_spectrum_options o;
  o.eigensolver = eigensolver == "multigrid"      ? RL::Eigensolver::multigrid
                  : eigensolver == "shift-invert" ? RL::Eigensolver::shift_invert
                                                  : RL::Eigensolver::automatic;
  o.eigenvalues_only = eigenvalues_only;
  o.stabilization = number_of(options, "stabilization");
  if(const auto tolerance = number_of(options, "tolerance"))
    o.multigrid.tolerance = *tolerance;
  if(const auto limit = whole_number_of(options, "maximum_iterations"))
    o.multigrid.maximum_iterations = *limit;
  RL::Spline_space_3 space = given;
  RL::Laplace_spectrum s = run(threads, progress, [&](const auto& callback) {
    o.multigrid.progress = callback;
    if(accuracy)
      return RL::internal::laplace_spectrum_to_accuracy(space, k, o, *accuracy);
    return RL::laplace_spectrum(space, k, o);
  });
  nb::dict report = report_of(s.report);
  report["eigensolver"] =
      s.eigensolver == RL::Eigensolver::multigrid ? "multigrid" : "shift-invert";
  return nb::make_tuple(space, array_of_matrix(std::move(s.eigenvalues)),
                        array_of_matrix(std::move(s.vertex_values)),
                        array_of_matrix(std::move(s.pairs.vectors)), s.area,
                        array_of_matrix(std::move(s.estimated_errors)),
                        array_of_matrix(std::move(s.extrapolated_eigenvalues)), report);
}

Vector vector_of(const Numbers& a) {
  Vector result(static_cast<Eigen::Index>(a.size()));
  for(Eigen::Index i = 0; i < result.size(); ++i)
    result[i] = a.data()[i];
  return result;
}

template <class Work> nb::object matrix(Work&& work) {
  Eigen::MatrixXd result = [&] {
    const nb::gil_scoped_release release;
    return Eigen::MatrixXd(work());
  }();
  return array_of_matrix(std::move(result));
}
template <class Work> nb::object vector(Work&& work) { return array_of_matrix(Vector(work())); }

RL::Shape_dna_normalization normalization(const std::string& name) {
  using N = RL::Shape_dna_normalization;
  return name == "area"    ? N::area
         : name == "first" ? N::first_eigenvalue
         : name == "weyl"  ? N::weyl_slope
                           : N::none;
}

} // namespace

void add_spectra(nb::module_& m) {
  m.def("eigenpairs", &eigenpairs, "space"_a, "k"_a, "eigensolver"_a, "eigenvalues_only"_a,
        "accuracy"_a.none(), "options"_a, "threads"_a, "progress"_a.none());
  m.def("number_of_zeros",
        [](const Numbers& l) { return RL::number_of_zero_eigenvalues(vector_of(l)); });
  m.def("with_exact_zeros", [](const Numbers& l, double area) {
    return vector([&] { return RL::internal::with_exact_zeros(vector_of(l), area); });
  });
  m.def("heat_kernel_times", [](const Numbers& l, int number) {
    return vector([&] { return RL::heat_kernel_times(vector_of(l), number); });
  });
  m.def("heat_trace", [](const Numbers& l, const Numbers& times) {
    return vector([&] { return RL::heat_trace(vector_of(l), vector_of(times)); });
  });
  m.def("heat_kernel_signature",
        [](const Numbers& l, const Values& u, const Numbers& times, bool scaled) {
          return matrix([&] {
            return RL::heat_kernel_signature(vector_of(l), u, vector_of(times),
                                             scaled ? RL::Heat_kernel_scaling::heat_trace
                                                    : RL::Heat_kernel_scaling::none);
          });
        });
  m.def("wave_kernel_energies", [](const Numbers& l, int number) {
    RL::Wave_kernel_energies e = RL::wave_kernel_energies(vector_of(l), number);
    return nb::make_tuple(array_of_matrix(std::move(e.energies)), e.sigma);
  });
  m.def("wave_kernel_signature",
        [](const Numbers& l, const Values& u, const Numbers& energies, double sigma) {
          return matrix([&] {
            RL::Wave_kernel_energies e;
            e.energies = vector_of(energies);
            e.sigma = sigma;
            return RL::wave_kernel_signature(vector_of(l), u, e);
          });
        });
  m.def("global_point_signature", [](const Numbers& l, const Values& u) {
    return matrix([&] { return RL::global_point_signature(vector_of(l), u); });
  });
  m.def("biharmonic_embedding", [](const Numbers& l, const Values& u) {
    return matrix([&] { return RL::biharmonic_embedding(vector_of(l), u); });
  });
  m.def("diffusion_map", [](const Numbers& l, const Values& u, double time) {
    return matrix([&] { return RL::diffusion_map(vector_of(l), u, time); });
  });
  m.def("shape_dna", [](const Numbers& l, double area, const std::string& name) {
    return vector([&] { return RL::shape_dna(vector_of(l), area, normalization(name)); });
  });
}

} // namespace python

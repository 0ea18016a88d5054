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

nb::tuple eigenpairs(const RL::Spline_space_3& space, int k, const std::string& eigensolver,
                     bool with_values, const nb::dict& options, int threads,
                     const nb::object& progress) {
  RL::Laplace_spectrum_options o;
  o.eigensolver = eigensolver == "multigrid"      ? RL::Eigensolver::multigrid
                  : eigensolver == "shift-invert" ? RL::Eigensolver::shift_invert
                                                  : RL::Eigensolver::automatic;
  o.normal_stabilization = number_of(options, "stabilization");
  if(const auto tolerance = number_of(options, "tolerance"))
    o.multigrid.relative_tolerance = *tolerance;
  RL::Laplace_spectrum s = run(threads, progress, [&](const auto& callback) {
    o.multigrid.callback = callback;
    return with_values ? RL::laplace_spectrum(space, k, o) : RL::laplace_eigenpairs(space, k, o);
  });
  const nb::dict report = report_of(s.report);
  return nb::make_tuple(array_of_matrix(std::move(s.eigenvalues)),
                        array_of_matrix(std::move(s.vertex_values)),
                        array_of_matrix(std::move(s.pairs.vectors)), s.area, report);
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
  m.def("eigenpairs", &eigenpairs, "space"_a, "k"_a, "eigensolver"_a, "with_values"_a, "options"_a,
        "threads"_a, "progress"_a.none());
  m.def("number_of_zeros", [](const Vector& l) { return RL::number_of_zero_eigenvalues(l); });
  m.def("heat_kernel_times", [](const Vector& l, int number) {
    return vector([&] { return RL::heat_kernel_times(l, number); });
  });
  m.def("heat_trace", [](const Vector& l, const Vector& times) {
    return vector([&] { return RL::heat_trace(l, times); });
  });
  m.def("heat_kernel_signature",
        [](const Vector& l, const Values& u, const Vector& times, bool scaled) {
          return matrix([&] {
            return RL::heat_kernel_signature(l, u, times,
                                             scaled ? RL::Heat_kernel_scaling::heat_trace
                                                    : RL::Heat_kernel_scaling::none);
          });
        });
  m.def("wave_kernel_energies", [](const Vector& l, int number) {
    RL::Wave_kernel_energies e = RL::wave_kernel_energies(l, number);
    return nb::make_tuple(array_of_matrix(std::move(e.energies)), e.sigma);
  });
  m.def("wave_kernel_signature",
        [](const Vector& l, const Values& u, const Vector& energies, double sigma) {
          return matrix([&] {
            RL::Wave_kernel_energies e;
            e.energies = energies;
            e.sigma = sigma;
            return RL::wave_kernel_signature(l, u, e);
          });
        });
  m.def("global_point_signature", [](const Vector& l, const Values& u) {
    return matrix([&] { return RL::global_point_signature(l, u); });
  });
  m.def("biharmonic_embedding", [](const Vector& l, const Values& u) {
    return matrix([&] { return RL::biharmonic_embedding(l, u); });
  });
  m.def("diffusion_map", [](const Vector& l, const Values& u, double time) {
    return matrix([&] { return RL::diffusion_map(l, u, time); });
  });
  m.def("shape_dna", [](const Vector& l, double area, const std::string& name) {
    return vector([&] { return RL::shape_dna(l, area, normalization(name)); });
  });
}

} // namespace python

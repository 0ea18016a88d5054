// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "shapes.h"

#include <CGAL/Restricted_laplacian_3/laplace_spectrum.h>
#include <CGAL/Restricted_laplacian_3/spectra/smallest_eigenpairs.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_function_3.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

#if __has_include(<unistd.h>)
#include <unistd.h>
#define RESTRICTED_LAPLACIAN_3_TEST_HAS_DUP
#endif

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;
using shapes::Mesh;

/// largest relative error of the eigenvalues l (l + 1), l = 1 .. 6, of the unit sphere
double sphere_error(const Eigen::VectorXd& eigenvalues) {
  double error = 0;
  Eigen::Index i = 1;
  for(int l = 1; l <= 6; ++l)
    for(int multiplicity = 0; multiplicity < 2 * l + 1; ++multiplicity, ++i)
      error = (std::max)(error, std::abs(eigenvalues[i] / (l * (l + 1)) - 1));
  return error;
}
constexpr int sphere_count = 49;

double restricted_sphere_error(int subdivisions, int depth) {
  const RL::Laplace_spectrum spectrum = RL::laplace_spectrum(
      shapes::mesh(shapes::sphere(subdivisions)), sphere_count, params::depth(depth));
  CHECK(spectrum.report.converged);
  CHECK(std::abs(spectrum.eigenvalues[0]) <= 1e-10);
  CHECK(spectrum.report.relative_residual <= 1e-3);
  return sphere_error(spectrum.eigenvalues);
}

} // namespace

TEST_CASE("eigenvalues_of_the_sphere", "[spectrum]") {
  CHECK(restricted_sphere_error(5, 3) <= 4.1e-3);
  CHECK(restricted_sphere_error(6, 4) <= 3.6e-4);
}

TEST_CASE("options_of_spectra_say_what_named_parameters_say", "[spectrum]") {
  const RL::Spline_space_3 space(shapes::mesh(shapes::sphere(4)), params::depth(3));
  RL::Laplace_spectrum_options options;
  options.eigensolver = RL::Eigensolver::multigrid;
  options.stabilization = 1e-3;
  options.multigrid.tolerance = 1e-2;
  const RL::Laplace_spectrum spectrum = RL::laplace_spectrum(space, 9, options);
  CHECK(spectrum.eigenvalues ==
        RL::laplace_spectrum(
            space, 9,
            params::eigensolver(RL::Eigensolver::multigrid).stabilization(1e-3).tolerance(1e-2))
            .eigenvalues);
  CHECK(spectrum.eigenvalues != RL::laplace_spectrum(space, 9).eigenvalues);
  CHECK(spectrum.vertex_values.cols() == 9);

  const RL::Operators operators = RL::assemble_operators(space);
  RL::Eigenpairs_options of_factorization;
  of_factorization.tolerance = 1e-3;
  CHECK(RL::smallest_eigenpairs(operators.stiffness, operators.mass, 9, of_factorization).values ==
        RL::smallest_eigenpairs(operators.stiffness, operators.mass, 9, params::tolerance(1e-3))
            .values);
}

TEST_CASE("eigenvalues_alone_are_found_with_less_work", "[spectrum]") {
  shapes::Triangles ellipsoid = shapes::sphere(5);
  for(RL::Point_3& p : ellipsoid.points)
    p = RL::Point_3(p.x(), 0.8 * p.y(), 0.6 * p.z());
  const auto mesh = shapes::mesh(ellipsoid);
  const auto np = params::eigensolver(RL::Eigensolver::multigrid);
  const RL::Spline_space_3 space(mesh, params::depth(4));
  const RL::Laplace_spectrum exact = RL::laplace_spectrum(space, 30, np.tolerance(1e-6)),
                             fast = RL::laplace_spectrum(space, 30, np.eigenvalues_only(true));
  CHECK(fast.report.converged);
  CHECK(fast.report.relative_residual <= RL::Laplace_spectrum_options::tolerance_of_eigenvalues);
  CHECK(fast.report.relative_residual > 1e-3);
  CHECK(fast.vertex_values.size() == 0);
  REQUIRE(fast.eigenvalues.size() == 30);
  for(Eigen::Index i = 1; i < 30; ++i)
    CHECK(fast.eigenvalues[i] == Approx(exact.eigenvalues[i]).epsilon(2e-5));
  // on a mesh, with a tolerance that is given, and by default
  CHECK(RL::laplace_spectrum(mesh, 30, np.depth(4).eigenvalues_only(true)).eigenvalues ==
        fast.eigenvalues);
  const RL::Laplace_spectrum values =
      RL::laplace_spectrum(space, 30, np.eigenvalues_only(true).tolerance(1e-6));
  CHECK((values.eigenvalues - exact.eigenvalues).cwiseAbs().maxCoeff() <=
        1e-10 * exact.eigenvalues[29]);
  CHECK(values.report.iterations <= exact.report.iterations);
  CHECK(RL::laplace_spectrum(space, 30, np).report.relative_residual <= 1e-3);
}

TEST_CASE("eigenvalues_of_the_fine_sphere_converge_with_order_four", "[spectrum][slow]") {
  std::vector<double> errors;
  for(int depth = 2; depth <= 5; ++depth)
    errors.push_back(restricted_sphere_error(7, depth));
  INFO("errors " << errors[0] << " " << errors[1] << " " << errors[2] << " " << errors[3]);
  CHECK(std::log2(errors[0] / errors[1]) >= 3.5);
  CHECK(std::log2(errors[1] / errors[2]) >= 3.5);
  // here the error of the mesh itself, 5e-5, takes over
  CHECK(errors[3] <= 6.5e-5);
}

TEST_CASE("cotangent_eigenvalues_of_the_sphere", "[spectrum]") {
  // The consistent mass matrix overestimates eigenvalues, the lumped one underestimates them; both
  // converge with order 2.
  const Mesh coarse = shapes::mesh(shapes::sphere(4)), fine = shapes::mesh(shapes::sphere(5));
  for(bool lumped : {false, true}) {
    const double coarse_error = sphere_error(
        RL::cotangent_spectrum(coarse, sphere_count, params::lumped_mass(lumped)).eigenvalues);
    const double fine_error = sphere_error(
        RL::cotangent_spectrum(fine, sphere_count, params::lumped_mass(lumped)).eigenvalues);
    CHECK(fine_error < 1.5e-2);
    CHECK(std::log2(coarse_error / fine_error) == Approx(2).margin(0.3));
  }
}

TEST_CASE("neumann_eigenvalues_of_a_rectangle", "[spectrum]") {
  // An open flat surface, one of whose sides lies in the direction of no axis of the grid.
  shapes::Triangles t;
  const double a = 1, b = 0.6, angle = 0.4;
  const RL::Vector_3 u(std::cos(angle), std::sin(angle), 0.2),
      w(-std::sin(angle), std::cos(angle), 0);
  const RL::Vector_3 unit = u / std::sqrt(u.squared_length());
  t.points = {CGAL::ORIGIN + 0 * unit, CGAL::ORIGIN + a * unit, CGAL::ORIGIN + a * unit + b * w,
              CGAL::ORIGIN + b * w};
  t.faces = {{0, 1, 2}, {0, 2, 3}};
  const RL::Laplace_spectrum spectrum = RL::laplace_spectrum(shapes::mesh(t), 20, params::depth(4));
  REQUIRE(spectrum.report.converged);
  std::vector<double> expected;
  const double pi = 3.14159265358979323846;
  for(int i = 0; i < 20; ++i)
    for(int j = 0; j < 20; ++j)
      expected.push_back(pi * pi * (i * i / (a * a) + j * j / (b * b)));
  std::sort(expected.begin(), expected.end());
  CHECK(std::abs(spectrum.eigenvalues[0]) <= 1e-9);
  for(int i = 1; i < 20; ++i)
    CHECK(spectrum.eigenvalues[i] == Approx(expected[i]).epsilon(2e-3));
}

TEST_CASE("eigenfunctions_are_orthonormal_and_satisfy_the_equation", "[spectrum]") {
  const Mesh mesh = shapes::mesh(shapes::box(1, 0.8, 0.5, 4, 1));
  const RL::Spline_space_3 space(mesh, params::depth(4));
  const RL::Laplace_spectrum spectrum = RL::laplace_spectrum(space, 12);
  REQUIRE(spectrum.report.converged);
  const RL::Operators operators = RL::assemble_operators(
      space, 4, RL::default_spectrum_stabilization(space), RL::Stabilized::stiffness);
  const Eigen::MatrixXd& x = spectrum.pairs.vectors;
  CHECK((x.transpose() * operators.mass * x - Eigen::MatrixXd::Identity(12, 12))
            .cwiseAbs()
            .maxCoeff() <= 1e-8);
  CHECK(
      (x.transpose() * operators.stiffness * x - Eigen::MatrixXd(spectrum.eigenvalues.asDiagonal()))
          .cwiseAbs()
          .maxCoeff() <= 1e-7 * spectrum.eigenvalues[11]);
  CHECK(std::is_sorted(spectrum.eigenvalues.begin(), spectrum.eigenvalues.end()));
  CHECK(spectrum.pairs.shift == Approx(-4 * 3.14159265358979 / space.surface().area()));
  CHECK(spectrum.pairs.regularization <= 1e-10);
  // values at the vertices are those of the functions
  const RL::Spline_function_3 third(space, x.col(3));
  const std::vector<double> values = third.values_at_vertices();
  for(std::size_t v = 0; v < values.size(); ++v)
    REQUIRE(spectrum.vertex_values(v, 3) == values[v]);
}

TEST_CASE("dense_and_iterative_eigenpairs_agree", "[spectrum]") {
  const Mesh mesh = shapes::mesh(shapes::sphere(3));
  const RL::Spline_space_3 space(mesh, params::depth(2));
  const RL::Operators operators = RL::assemble_operators(space);
  const int few = 10, many = static_cast<int>(space.dimension()) / 3 + 1;
  const RL::Eigenpairs iterative =
      RL::smallest_eigenpairs(operators.stiffness, operators.mass, few);
  const RL::Eigenpairs dense = RL::smallest_eigenpairs(operators.stiffness, operators.mass, many);
  CHECK(iterative.iterations > 0);
  CHECK(dense.iterations == 0);
  CHECK((iterative.values - dense.values.head(few)).cwiseAbs().maxCoeff() <= 1e-7);
}

TEST_CASE("failed_factorization_is_thrown_and_not_printed", "[spectrum]") {
  // indefinite far beyond any regularization, and large enough for the sparse way
  RL::Sparse_matrix s(400, 400), m(400, 400);
  m.setIdentity();
  s.setIdentity();
  s.coeffRef(17, 18) = s.coeffRef(18, 17) = 1e6;
#ifdef RESTRICTED_LAPLACIAN_3_TEST_HAS_DUP
  std::fflush(stdout);
  const int saved = dup(1);
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::tmpfile(), &std::fclose);
  REQUIRE(file);
  dup2(fileno(file.get()), 1);
  CHECK_THROWS_AS(RL::smallest_eigenpairs(s, m, 3), RL::Numerical_error);
  std::fflush(stdout);
  const auto written = lseek(fileno(file.get()), 0, SEEK_END);
  dup2(saved, 1);
  close(saved);
  CHECK(written == 0);
#else
  CHECK_THROWS_AS(RL::smallest_eigenpairs(s, m, 3), RL::Numerical_error);
#endif
  s.coeffRef(17, 17) = -1e6;
  CHECK_THROWS_AS(RL::smallest_eigenpairs(s, m, 3), RL::Numerical_error);
}

TEST_CASE("no_copy_of_a_multiple_eigenvalue_is_missed", "[spectrum]") {
  // Surfaces with the full symmetry of the cube, whose eigenvalues come in twos and threes, and
  // cuts at all places of the sequence.
  const Mesh sphere = shapes::mesh(shapes::sphere(3));
  const Mesh box = shapes::mesh(shapes::box(1, 1, 1, 4, 1));
  for(const Mesh* mesh : {&sphere, &box}) {
    const RL::Spline_space_3 space(*mesh, params::depth(2));
    const RL::Operators operators = RL::assemble_operators(space);
    const int all = static_cast<int>(space.dimension()) / 3 + 1;
    const RL::Eigenpairs dense = RL::smallest_eigenpairs(operators.stiffness, operators.mass, all);
    REQUIRE(dense.iterations == 0);
    for(int k = 1; k <= 40; ++k) {
      const RL::Eigenpairs pairs = RL::smallest_eigenpairs(operators.stiffness, operators.mass, k);
      CHECK(pairs.converged);
      REQUIRE(pairs.values.size() == k);
      CHECK((pairs.values - dense.values.head(k)).cwiseAbs().maxCoeff() <= 1e-6);
    }
  }
}

TEST_CASE("spectrum_does_not_depend_on_the_tessellation", "[spectrum][slow]") {
  // The same scan in three tessellations: the restricted spectra agree where those of the cotangent
  // Laplacian differ.
  const Mesh fine = shapes::read(shared_mesh("bimba_46k.ply")),
             coarse = shapes::read(shared_mesh("bimba_5k.ply"));
  if(fine.is_empty() || coarse.is_empty())
    SKIP_TEST("no such file: bimba_46k.ply, bimba_5k.ply");
  const int count = 60;
  const auto change = [](const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    return ((a - b).tail(count - 1).array() / b.tail(count - 1).array()).abs().mean();
  };
  const double restricted =
      change(RL::laplace_spectrum(coarse, count, params::depth(5)).eigenvalues,
             RL::laplace_spectrum(fine, count, params::depth(5)).eigenvalues);
  const double cotangent = change(RL::cotangent_spectrum(coarse, count).eigenvalues,
                                  RL::cotangent_spectrum(fine, count).eigenvalues);
  INFO("mean change: restricted " << restricted << ", cotangent " << cotangent);
  CHECK(restricted < cotangent / 3);
}

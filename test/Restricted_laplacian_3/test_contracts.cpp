// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// What varies has one owner: second models of an integration, of a metric, of a destination of
// matrices, of a right-hand side of a linear problem, and of a factorization.

#include "catch.h"
#include "matrices.h"
#include "point_shapes.h"
#include "shapes.h"

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/estimate_curvature.h>
#include <CGAL/Restricted_laplacian_3/fit_function.h>
#include <CGAL/Restricted_laplacian_3/integration/Weighted_integration.h>
#include <CGAL/Restricted_laplacian_3/integration/cubature.h>
#include <CGAL/Restricted_laplacian_3/laplace_spectrum.h>
#include <CGAL/Restricted_laplacian_3/problems/Poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>
#include <CGAL/Restricted_laplacian_3/solvers/galerkin_product.h>
#include <CGAL/Restricted_laplacian_3/spectra/eigenpairs.h>
#include <CGAL/Restricted_laplacian_3/spectra/shift_invert_eigenpairs.h>
#include <CGAL/Restricted_laplacian_3/spectra/smallest_eigenpairs.h>
#include <CGAL/Restricted_laplacian_3/spectra/sparse_cholesky.h>
#include <CGAL/Restricted_laplacian_3/splines/prolongation.h>

#include <CGAL/property_map.h>

#include <Eigen/Dense>

#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <functional>
#include <mutex>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;
using shapes::Mesh;

RL::Spline_space_3 contract_space(const shapes::Triangles& t, int depth) {
  return RL::Spline_space_3(RL::soup(t.points, t.faces), params::depth(depth));
}

/// The nodes of a cubature, moved to the unit sphere along their radius: some leave their cell a
/// little. Weights are those of the triangles.
class Nodes_on_unit_sphere {
public:
  explicit Nodes_on_unit_sphere(const RL::Spline_space_3& space)
    : m_nodes(space.integration()), m_width(space.octree().cell_width(space.depth())) {}

  void add_nodes(std::size_t sheet, int degree, RL::Integration_nodes& nodes) const {
    m_nodes.visit_nodes(sheet, degree, [&](const RL::Integration_node_block& block) {
      for(std::size_t i = 0; i < block.size; ++i) {
        RL::Surface_point p = block.points[i];
        const RL::Vector_3 r = p.point - CGAL::ORIGIN;
        p.normal = r / std::sqrt(r.squared_length());
        p.point = CGAL::ORIGIN + p.normal;
        const RL::Vector_3 moved = (p.point - block.points[i].point) / m_width;
        std::array<double, 3> position = block.position(i);
        for(int axis = 0; axis < 3; ++axis)
          position[axis] += moved[axis];
        for(double t : position)
          if(t < 0 || t > 1)
            is_outside = true;
        nodes.add(p, position, block.weights[i]);
      }
    });
  }

  mutable std::atomic<bool> is_outside{false};

private:
  RL::Surface_integration m_nodes;
  double m_width;
};

/// keeps the entries of the upper halves as they come
class Triplet_sink : public RL::Operator_sink {
public:
  void add(const RL::Cell_elements& elements, const RL::Sheet_block& stiffness_block,
           const RL::Sheet_block& mass_block) override {
    RL::for_each_element(elements, [&](int i, std::uint32_t row) {
      RL::for_each_element(elements, [&](int j, std::uint32_t column) {
        stiffness.emplace_back(row, column, stiffness_block(i, j));
        mass.emplace_back(row, column, mass_block(i, j));
      });
    });
  }
  void finish() override { ++number_of_finishes; }

  std::vector<Eigen::Triplet<double>> stiffness, mass;
  int number_of_finishes = 0;
};

RL::Sparse_matrix matrix_of(const std::vector<Eigen::Triplet<double>>& entries, std::size_t n) {
  RL::Sparse_matrix result(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

RL::Symmetric_tensor_3 diagonal_tensor(double x, double y, double z) { return {x, y, z, 0, 0, 0}; }

/// A factorization as a user may write one: dense, and with another order of the unknowns.
class Dense_cholesky {
public:
  void compute(const RL::Sparse_matrix& k) {
    ++number_of_factorizations;
    m_factor.compute(Eigen::MatrixXd(k).reverse());
  }
  Eigen::ComputationInfo info() const { return m_factor.info(); }
  Eigen::VectorXd solve_lower(const Eigen::VectorXd& b) const {
    return m_factor.matrixL().solve(b.reverse());
  }
  Eigen::VectorXd solve_upper(const Eigen::VectorXd& b) const {
    return m_factor.matrixU().solve(b).reverse();
  }
  static inline int number_of_factorizations = 0;

private:
  Eigen::LLT<Eigen::MatrixXd> m_factor;
};

} // namespace

TEST_CASE("constant_tensor_multiplies_the_stiffness_and_nothing_else", "[contracts]") {
  const RL::Spline_space_3 space = contract_space(shapes::box(1, 0.7, 0.4, 3, 1), 4);
  const auto threefold = [](const RL::Surface_point&) { return diagonal_tensor(3, 3, 3); };
  const RL::Spline_space_3 with_tensor =
      space.integrated_by(RL::Diffusion_integration(space.integration(), threefold));
  const RL::Operators plain = RL::assemble_operators(space, 4),
                      tensor = RL::assemble_operators(with_tensor, 4);
  CHECK(relative_difference(tensor.stiffness, 3 * plain.stiffness) < 1e-14);
  CHECK(relative_difference(tensor.mass, plain.mass) < 1e-14);
  // The stabilization of the stiffness has the mean of the tensor as a factor, that of the mass has
  // not.
  constexpr double c = 0.1;
  const RL::Operators plain_c = RL::assemble_operators(space, 4, c),
                      tensor_c = RL::assemble_operators(with_tensor, 4, c);
  CHECK(relative_difference(tensor_c.stiffness, 3 * plain_c.stiffness) < 1e-12);
  CHECK(relative_difference(tensor_c.mass - tensor.mass, plain_c.mass - plain.mass) < 1e-12);
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(tensor_c.mass.cols());
  CHECK(ones.dot(tensor_c.mass * ones) == Approx(space.surface().area()).epsilon(1e-13));
}

TEST_CASE("rotated_tensor_on_a_rotated_surface_has_the_same_spectrum", "[contracts]") {
  // a quarter turn about the z axis takes the grid to itself
  const auto turned = [](const RL::Point_3& p) { return RL::Point_3(-p.y(), p.x(), p.z()); };
  shapes::Triangles t = shapes::box(1, 0.7, 0.4, 3, 1);
  const auto values_of = [](const shapes::Triangles& t, const RL::Symmetric_tensor_3& d) {
    const RL::Spline_space_3 space = contract_space(t, 3);
    const auto tensor = [&](const RL::Surface_point&) { return d; };
    const RL::Operators o = RL::assemble_operators(
        space.integrated_by(RL::Diffusion_integration(space.integration(), tensor)), 3, 1e-3,
        RL::Stabilized::stiffness);
    return RL::smallest_eigenpairs(o.stiffness, o.mass, 8).values;
  };
  // 4 along x and 1 along y and z, with a part that mixes x and z
  const Eigen::VectorXd expected = values_of(t, {4, 1, 1, 0, 0.5, 0});
  for(RL::Point_3& p : t.points)
    p = turned(p);
  const Eigen::VectorXd found = values_of(t, {1, 4, 1, 0, 0, 0.5}),
                        other = values_of(t, {4, 1, 1, 0, 0.5, 0});
  CHECK((found - expected).cwiseAbs().maxCoeff() < 1e-8 * expected.maxCoeff());
  CHECK((other - expected).cwiseAbs().maxCoeff() > 1e-2 * expected.maxCoeff());
}

TEST_CASE("all_that_is_computed_in_a_space_integrates_as_the_space_does", "[contracts]") {
  const RL::Spline_space_3 space = contract_space(shapes::box(1, 0.7, 0.4, 3, 1), 4);
  const auto three = [](const RL::Surface_point&) { return 3.; };
  const RL::Spline_space_3 weighted =
      space.integrated_by(RL::Weighted_integration(space.integration(), three));
  CHECK(&weighted.octree() == &space.octree());
  const auto triples = [&](const auto& compute) {
    const Eigen::MatrixXd once = compute(space), thrice = compute(weighted);
    CHECK((thrice - 3 * once).cwiseAbs().maxCoeff() < 1e-12 * thrice.cwiseAbs().maxCoeff());
  };
  const auto x = [](const RL::Surface_point& p) { return p.point.x(); };
  const auto axis = [](const RL::Surface_point&) { return RL::Vector_3(1, 2, 3); };
  triples([](const auto& s) { return Eigen::MatrixXd(RL::assemble_operators(s).mass.diagonal()); });
  triples([](const auto& s) {
    return Eigen::MatrixXd(RL::assemble_operators_of_levels(s, 2, 4)[0].stiffness.diagonal());
  });
  triples([](const auto& s) { return Eigen::MatrixXd(RL::assemble_mass_matrix(s, 3).diagonal()); });
  triples(
      [](const auto& s) { return Eigen::MatrixXd(RL::assemble_stiffness_matrix(s).diagonal()); });
  triples([&](const auto& s) { return RL::assemble_component_loads(s, x); });
  triples([&](const auto& s) { return RL::assemble_gradient_loads(s, axis, 2); });
  triples([](const auto& s) { return Eigen::MatrixXd(RL::assemble_element_integrals(s)); });
  // a weight that is the same everywhere changes no eigenvalue and no solution of a problem
  const Eigen::VectorXd values = RL::laplace_eigenpairs(space, 5).eigenvalues,
                        same = RL::laplace_eigenpairs(weighted, 5).eigenvalues;
  CHECK((values - same).cwiseAbs().maxCoeff() < 1e-5 * values.maxCoeff());
  CHECK(RL::fit_function(weighted, x).root_mean_square_errors[0] < 1e-6);
  // and one that leaves half of the surface out changes what is integrated
  const auto half = [](const RL::Surface_point& p) { return p.point.x() > 0.5 ? 1. : 0.; };
  CHECK(RL::assemble_mass_matrix(
            space.integrated_by(RL::Weighted_integration(space.integration(), half)))
            .sum() < 0.6 * space.surface().area());
}

TEST_CASE("models_of_integrations_refuse_surfaces_of_the_other_kind", "[contracts]") {
  const shapes::Triangles t = shapes::sphere(2);
  const RL::Spline_space_3 space = contract_space(t, 3);
  const RL::Sparse_matrix mass = RL::assemble_mass_matrix(space);
  CHECK(relative_difference(
            RL::assemble_mass_matrix(space.integrated_by(RL::Triangle_cubature(space.octree()))),
            mass) == 0);
  CHECK_THROWS_AS(RL::Point_cubature(space.octree()), RL::Input_error);
  using shapes::Oriented_point;
  const RL::Spline_space_3 points(
      shapes::sphere_points(500),
      params::depth(2)
          .point_map(CGAL::First_of_pair_property_map<Oriented_point>())
          .normal_map(CGAL::Second_of_pair_property_map<Oriented_point>()));
  CHECK(relative_difference(
            RL::assemble_mass_matrix(points.integrated_by(RL::Point_cubature(points.octree()))),
            RL::assemble_mass_matrix(points)) == 0);
  CHECK_THROWS_AS(RL::Triangle_cubature(points.octree()), RL::Input_error);
}

TEST_CASE("what_is_made_of_a_space_outlives_it", "[contracts]") {
  const shapes::Triangles t = shapes::box(1, 0.7, 0.4, 3, 1);
  const auto x = [](const RL::Surface_point& p) { return p.point.x(); };
  RL::Surface_location location;
  location.face = t.faces.size() - 1;
  location.barycentric = {0.2, 0.3, 0.5};
  const auto function = [&] {
    const RL::Spline_space_3 space = contract_space(t, 3);
    return RL::Spline_function_3(space, RL::fit_function(space, x).coefficients.col(0));
  }();
  auto fitter = [&] { return RL::Function_fitter(contract_space(t, 3)); }();
  const auto curvature = [&] { return RL::estimate_curvature(contract_space(t, 3)); }();
  const RL::Spline_functions_3 functions(function.space(), fitter.fit(x).coefficients);
  const double expected = function.space().surface().surface_point(location).point.x();
  REQUIRE(expected > 0.1);
  CHECK(function.value(location) == Approx(expected).epsilon(1e-6));
  CHECK(functions.values_at_locations(std::vector<RL::Surface_location>{location})(0, 0) ==
        Approx(expected).epsilon(1e-6));
  CHECK(std::isfinite(curvature(location).mean));
}

TEST_CASE("only_the_tangential_part_of_a_tensor_counts", "[contracts]") {
  const RL::Vector_3 n(0.48, 0.6, 0.64);
  const RL::Symmetric_tensor_3 p = RL::tangent_projector(n),
                               identity = RL::tangential_part(diagonal_tensor(1, 1, 1), n),
                               normal = RL::tangential_part({n.x() * n.x(), n.y() * n.y(),
                                                             n.z() * n.z(), n.x() * n.y(),
                                                             n.x() * n.z(), n.y() * n.z()},
                                                            n);
  for(int k = 0; k < 6; ++k) {
    CHECK(identity[k] == Approx(p[k]).margin(1e-15));
    CHECK(std::abs(normal[k]) < 1e-15);
  }
}

TEST_CASE("identities_hold_for_nodes_that_leave_their_cell", "[contracts]") {
  const RL::Spline_space_3 flat = contract_space(shapes::sphere(3), 4);
  const Nodes_on_unit_sphere nodes(flat);
  const RL::Spline_space_3 space = flat.integrated_by(std::cref(nodes));
  for(double c : {0., 0.1}) {
    const std::vector<RL::Operators> levels = RL::assemble_operators_of_levels(space, 2, 4, c);
    CHECK(nodes.is_outside);
    for(const RL::Operators& o : levels) {
      const Eigen::VectorXd ones = Eigen::VectorXd::Ones(o.mass.cols());
      CHECK((o.stiffness * ones).cwiseAbs().maxCoeff() < 1e-12 * o.stiffness.coeffs().maxCoeff());
      CHECK(ones.dot(o.mass * ones) == Approx(space.surface().area()).epsilon(1e-12));
    }
    for(int level = 2; level < 4; ++level) {
      const RL::Sparse_matrix p = RL::prolongation_matrix(space, level);
      CHECK(relative_difference(RL::galerkin_product(levels[level - 1].stiffness, p),
                                levels[level - 2].stiffness) < 1e-12);
      CHECK(relative_difference(RL::galerkin_product(levels[level - 1].mass, p),
                                levels[level - 2].mass) < 1e-12);
    }
  }
  // loads of levels are restricted, and those of x^2 + y^2 + z^2 are those of 1
  const auto square = [](const RL::Surface_point& p) {
    return (p.point - CGAL::ORIGIN).squared_length();
  };
  const auto one = [](const RL::Surface_point&) { return 1.; };
  const Eigen::VectorXd fine = RL::assemble_load(space, square, 4);
  CHECK((fine - RL::assemble_load(space, one, 4)).cwiseAbs().maxCoeff() < 1e-14 * fine.maxCoeff());
  CHECK((RL::prolongation_matrix(space, 3).transpose() * fine - RL::assemble_load(space, square, 3))
            .cwiseAbs()
            .maxCoeff() < 1e-13 * fine.maxCoeff());
}

TEST_CASE("sink_of_triplets_gets_the_matrices", "[contracts]") {
  const RL::Spline_space_3 space = contract_space(shapes::box(1, 0.7, 0.4, 3, 1), 4);
  const std::vector<RL::Operators> expected = RL::assemble_operators_of_levels(space, 3, 4, 0.1);
  Triplet_sink coarse, fine;
  RL::assemble_into(space, 3, {&coarse, &fine}, 0.1);
  CHECK(coarse.number_of_finishes == 1);
  for(int level = 3; level <= 4; ++level) {
    const Triplet_sink& sink = level == 3 ? coarse : fine;
    const std::size_t n = space.dimension(level);
    CHECK(relative_difference(matrix_of(sink.stiffness, n), expected[level - 3].stiffness) < 1e-14);
    CHECK(relative_difference(matrix_of(sink.mass, n), expected[level - 3].mass) < 1e-14);
  }
}

TEST_CASE("operators_of_other_patterns_are_added", "[contracts]") {
  const RL::Spline_space_3 space = contract_space(shapes::sphere(2), 3);
  RL::Operators lumped = RL::assemble_operators(space, 3, 1e-3);
  const Eigen::VectorXd sums = lumped.mass * Eigen::VectorXd::Ones(lumped.mass.cols());
  lumped.mass = sums.asDiagonal();
  Eigen::VectorXd x;
  const Eigen::VectorXd b = RL::assemble_load(
      space, [](const RL::Surface_point& p) { return p.point.x() + p.point.y() * p.point.z(); });
  const RL::Poisson_solver solver(space, lumped, 2, params::tolerance(1e-10));
  CHECK(solver.solve(b, x).converged);
  CHECK((lumped.stiffness * x + 2 * lumped.mass * x - b).norm() < 1e-8 * b.norm());
  // a matrix of another size
  lumped.mass = RL::Sparse_matrix(3, 3);
  CHECK_THROWS_AS(RL::Poisson_solver(space, lumped, 2), RL::Parameter_error);
}

TEST_CASE("screening_by_a_function_keeps_the_mean_as_a_number_does", "[contracts]") {
  const shapes::Triangles t = shapes::sphere(3);
  const Mesh mesh = shapes::mesh(t);
  // The mean of the solution is that of f over alpha, 1e9 times as large as what is left.
  constexpr double alpha = 1e-9;
  const auto f = [](const RL::Surface_point& p) { return 1 + p.point.x(); };
  std::vector<double> by_number(t.points.size()), by_function(t.points.size());
  const auto solve = [&](const auto& weight, std::vector<double>& u) {
    Mesh copy = mesh;
    auto map = copy.add_property_map<Mesh::Vertex_index, double>("u").first;
    const RL::Solve_report report =
        RL::solve_screened_poisson(copy, f, weight, map, params::depth(4).tolerance(1e-8));
    CHECK(report.converged);
    for(const auto v : vertices(copy))
      u[v.idx()] = map[v];
    return report.iterations;
  };
  const int iterations = solve(alpha, by_number);
  CHECK(solve(RL::function_of_degree([](const RL::Surface_point&) { return alpha; }, 0),
              by_function) == iterations);
  for(std::size_t v = 0; v < t.points.size(); ++v) {
    CHECK(std::abs(by_number[v] - by_function[v]) < 1e-5);
    // -Laplacian x = 2 x on the sphere
    CHECK(by_function[v] - 1 / alpha == Approx(t.points[v].x() / 2).margin(0.02));
  }
}

TEST_CASE("eigenpairs_do_not_depend_on_the_factorization", "[contracts]") {
  const RL::Spline_space_3 space(shapes::mesh(shapes::sphere(3)), params::depth(3));
  const RL::Operators o = RL::assemble_operators(space);
  // with CHOLMOD, where there is one
  const Eigen::VectorXd expected = RL::smallest_eigenpairs(o.stiffness, o.mass, 20).values;
  const RL::Eigenpairs found[] = {
      RL::shift_invert_eigenpairs<RL::Eigen_simplicial_cholesky>(o.stiffness, o.mass, 20),
      RL::shift_invert_eigenpairs<Dense_cholesky>(o.stiffness, o.mass, 20)};
  CHECK(Dense_cholesky::number_of_factorizations > 0);
  for(const RL::Eigenpairs& pairs : found) {
    CHECK(pairs.converged);
    CHECK(pairs.iterations > 0);
    CHECK((pairs.values - expected).cwiseAbs().maxCoeff() <= 1e-7 * expected[19]);
  }
}

TEST_CASE("options_of_eigenpairs_do_what_they_say", "[contracts]") {
  const RL::Spline_space_3 space(shapes::mesh(shapes::sphere(3)), RL::parameters::depth(3));
  const RL::Operators o = RL::assemble_operators(space);
  RL::Eigenpairs_options options;
  const RL::Eigenpairs expected = RL::smallest_eigenpairs(o.stiffness, o.mass, 10);
  REQUIRE(expected.converged);
  CHECK(expected.regularization >= options.regularization);
  CHECK(expected.iterations > 1);
#ifdef CGAL_RESTRICTED_LAPLACIAN_3_USE_CHOLMOD
  const RL::Eigenpairs by_cholmod =
      RL::shift_invert_eigenpairs<RL::Cholmod_cholesky>(o.stiffness, o.mass, 10);
  CHECK(by_cholmod.values == expected.values);
#endif
  const RL::Eigenpairs rough =
      RL::smallest_eigenpairs(o.stiffness, o.mass, 10, RL::parameters::tolerance(1e-2));
  CHECK(rough.converged);
  CHECK(rough.residuals.maxCoeff() > 1e2 * expected.residuals.maxCoeff());
  CHECK((rough.values - expected.values).cwiseAbs().maxCoeff() <= 1e-2 * expected.values[9]);
  CHECK_FALSE(
      RL::smallest_eigenpairs(o.stiffness, o.mass, 10, RL::parameters::maximum_iterations(1))
          .converged);
  options.regularization = 1e-9;
  const RL::Eigenpairs regularized = RL::smallest_eigenpairs(o.stiffness, o.mass, 10, options);
  CHECK(regularized.regularization == 1e-9);
  CHECK((regularized.values - expected.values).cwiseAbs().maxCoeff() <= 1e-6);
  int calls = 0;
  const auto callback = [&calls](double part) {
    CHECK(part >= 0);
    CHECK(part <= 1);
    return ++calls < 5;
  };
  CHECK_THROWS_AS(
      RL::smallest_eigenpairs(o.stiffness, o.mass, 10, RL::parameters::progress(callback)),
      RL::Canceled);
  CHECK(calls == 5);
}

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Diffusion and density: identities, analytic solutions, orders, and what is refused.

#include "catch.h"
#include "special_shapes.h"

#include <CGAL/Restricted_laplacian_3/assembly/Boundary_integration.h>
#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/estimate_curvature.h>
#include <CGAL/Restricted_laplacian_3/fit_function.h>
#include <CGAL/Restricted_laplacian_3/geodesic_distances.h>
#include <CGAL/Restricted_laplacian_3/integration/Monte_carlo.h>
#include <CGAL/Restricted_laplacian_3/laplace_spectrum.h>
#include <CGAL/Restricted_laplacian_3/problems/Geodesic_fitter.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>

#include <CGAL/Surface_mesh.h>

#include <boost/property_map/function_property_map.hpp>

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;
using shapes::Mesh;
using shapes::Triangles;

const double pi = std::acos(-1.);

double largest_relative(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return ((a - b).cwiseAbs().array() / b.cwiseAbs().maxCoeff()).maxCoeff();
}

/// the square [0, 1]^2 in a plane that is oblique to the grid of the octree, and its coordinates
Triangles square(int n) {
  return shapes::grid(n, [](double x, double y) { return RL::Point_3(x, y, 0.3 * x - 0.2 * y); });
}

/// a torus, whose triangles are of any shape
Triangles torus() {
  return shapes::grid(40, [](double x, double y) {
    const double u = 2 * pi * (x + 0.05 * std::sin(2 * pi * y)), v = 2 * pi * y;
    return RL::Point_3((1 + 0.4 * std::cos(v)) * std::cos(u), (1 + 0.4 * std::cos(v)) * std::sin(u),
                       0.4 * std::sin(v));
  });
}

} // namespace

TEST_CASE("constant_coefficients_scale_the_operator", "[material]") {
  const Mesh mesh = shapes::mesh(shapes::sphere(3));
  const auto of = params::depth(4).tolerance(1e-10);
  const RL::Laplace_spectrum plain = RL::laplace_spectrum(mesh, 12, of),
                             scaled =
                                 RL::laplace_spectrum(mesh, 12, of.diffusion(3.5).density(0.25));
  CHECK(largest_relative(scaled.eigenvalues, 14 * plain.eigenvalues) < 1e-9);
  // orthonormal in the density
  const RL::Spline_space_3 space(mesh, params::depth(4).density(0.25));
  const Eigen::MatrixXd gram =
      scaled.pairs.vectors.transpose() * (RL::assemble_mass_matrix(space) * scaled.pairs.vectors);
  CHECK((gram - Eigen::MatrixXd::Identity(12, 12)).cwiseAbs().maxCoeff() < 1e-8);
}
TEST_CASE("coefficients_are_the_same_however_they_are_given", "[material]") {
  const Mesh mesh = shapes::mesh(torus());
  const auto of = [](const RL::Point_3& p) { return 1.5 + p.x() + 0.2 * p.y(); };
  const auto f = [](const RL::Surface_point& p) { return p.point.z(); };
  const auto solution = [&](const auto& np) {
    const RL::Spline_space_3 space(mesh, np);
    return RL::solve_poisson(space, f, params::tolerance(1e-10)).coefficients.eval();
  };
  // linear in each triangle, all of them
  const auto at_points = [&](const RL::Surface_point& p) { return of(p.point); };
  const Eigen::VectorXd expected =
      solution(params::depth(4).diffusion(at_points).density(at_points));
  const auto at_vertices = boost::make_function_property_map<Mesh::Vertex_index>(
      [&](Mesh::Vertex_index v) { return of(mesh.point(v)); });
  CHECK(largest_relative(solution(params::depth(4).diffusion(at_vertices).density(at_vertices)),
                         expected) < 1e-7);
  const auto tensor = [&](const RL::Surface_point& p) -> RL::Symmetric_tensor_3 {
    return {of(p.point), of(p.point), of(p.point), 0, 0, 0};
  };
  CHECK(largest_relative(solution(params::depth(4).diffusion(tensor).density(at_points)),
                         expected) < 1e-7);
  // what the normal gains does not count
  const auto matrix = [&](const RL::Surface_point& p) {
    const Eigen::Vector3d n(p.normal.x(), p.normal.y(), p.normal.z());
    return Eigen::Matrix3d(of(p.point) * Eigen::Matrix3d::Identity() - 7 * n * n.transpose());
  };
  CHECK(largest_relative(solution(params::depth(4).diffusion(matrix).density(at_points)),
                         expected) < 1e-7);
  const RL::Spline_space_3 plain(mesh, params::depth(4));
  RL::Surface_material material;
  material.set_diffusion(matrix);
  material.set_density(at_points);
  const RL::Poisson_solution shared =
      RL::solve_poisson(plain.with_material(material), f, params::tolerance(1e-10));
  CHECK(largest_relative(shared.coefficients, expected) < 1e-7);
  CHECK(plain.material().is_trivial());
  // on faces, constant on each
  const auto on_faces = boost::make_function_property_map<Mesh::Face_index>(
      [](Mesh::Face_index face) { return 1. + face.idx() % 3; });
  const auto in_faces = [](const RL::Surface_point& p) { return 1. + p.face % 3; };
  CHECK(largest_relative(solution(params::depth(4).diffusion(on_faces).density(on_faces)),
                         solution(params::depth(4).diffusion(in_faces).density(in_faces))) < 1e-9);
}

TEST_CASE("tensor_of_two_directions", "[material]") {
  const RL::Symmetric_tensor_3 tensor = RL::directional_tensor(
      {RL::Vector_3(0, 3, 4), RL::Vector_3(-2, 0, 0)}, {5, 0.25}); // of any length
  const RL::Symmetric_tensor_3 expected = {0.25, 5 * 0.36, 5 * 0.64, 0, 0, 5 * 0.48};
  for(int k = 0; k < 6; ++k)
    CHECK(std::abs(tensor[k] - expected[k]) < 1e-15);
}

TEST_CASE("diffusion_that_follows_the_curvature", "[material]") {
  // a cylinder of radius 1 and height 2, open at both ends: 1 around it, e^-a along it
  const Triangles t = shapes::grid(48, [](double x, double y) {
    return RL::Point_3(std::cos(2 * pi * x), std::sin(2 * pi * x), 2 * y);
  });
  Triangles turned = t;
  for(auto& face : turned.faces)
    std::swap(face[0], face[1]);
  const double a = 1;
  const auto eigenvalue = [&](int around, int along) {
    return around * around + std::exp(-a) * std::pow(along * pi / 2, 2);
  };
  for(const Triangles& cylinder : {t, turned}) {
    const RL::Spline_space_3 space(RL::soup(cylinder.points, cylinder.faces),
                                   params::depth(4).joining_tolerance(1e-9));
    RL::Surface_material material;
    // the first number has no effect where one curvature is 0
    material.set_diffusion(RL::curvature_diffusion(RL::estimate_curvature(space), {7, a}));
    REQUIRE(material.is_constant_on_faces());
    REQUIRE(!material.has_density());
    const Eigen::VectorXd values =
        RL::laplace_spectrum(space.with_material(material), 8).eigenvalues;
    const std::array<double, 8> expected = {0,
                                            eigenvalue(0, 1),
                                            eigenvalue(1, 0),
                                            eigenvalue(1, 0),
                                            eigenvalue(1, 1),
                                            eigenvalue(1, 1),
                                            eigenvalue(0, 2),
                                            eigenvalue(2, 0)};
    for(int i = 1; i < 8; ++i) {
      INFO(i << ": " << values[i] << " and " << expected[i]);
      CHECK(std::abs(values[i] / expected[i] - 1) < 0.01);
    }
  }
  // on a sphere all directions are alike, and in a plane nothing changes
  const Triangles ball = shapes::sphere(4);
  for(const auto& [shape, factor] : {std::pair(ball, std::exp(-0.5)), std::pair(square(8), 1.)}) {
    const RL::Spline_space_3 space(RL::soup(shape.points, shape.faces), params::depth(4));
    RL::Surface_material material;
    material.set_diffusion(RL::curvature_diffusion(RL::estimate_curvature(space), {0.5, 0.5}));
    const Eigen::VectorXd plain = RL::laplace_spectrum(space, 5).eigenvalues,
                          values =
                              RL::laplace_spectrum(space.with_material(material), 5).eigenvalues;
    CHECK(largest_relative(values, factor * plain) < 2e-3);
  }
  const RL::Spline_space_3 space(RL::soup(ball.points, ball.faces), params::depth(3));
  const RL::Curvature_field curvature = RL::estimate_curvature(space);
  CHECK_THROWS_WITH(RL::curvature_diffusion(curvature, {-1, 0}), Catch::Contains("anisotropy"));
  CHECK_THROWS_WITH(
      RL::curvature_diffusion(curvature, {0, std::numeric_limits<double>::quiet_NaN()}),
      Catch::Contains("anisotropy"));
  CHECK_THROWS_AS(
      RL::curvature_diffusion(
          RL::estimate_curvature(space, params::method(RL::Curvature_method::coordinates)), {1, 1}),
      RL::Input_error);
  // factors have a lower bound
  const RL::Face_function<RL::Symmetric_tensor_3> smallest =
      RL::curvature_diffusion(curvature, {1e6, 1e6});
  for(const RL::Symmetric_tensor_3& d : smallest.values())
    REQUIRE(d[0] + d[1] + d[2] > 1.9e-4);
}

TEST_CASE("density_does_not_change_harmonic_functions", "[material]") {
  const Triangles t = square(20);
  const RL::Spline_space_3 space(RL::soup(t.points, t.faces), params::depth(5));
  const auto zero = [](const RL::Surface_point&) { return 0.; };
  // in the plane of the square: harmonic for D = 1 in its own coordinates
  const auto g = [](const RL::Surface_point& p) { return 1 + 2 * p.point.x() - p.point.y(); };
  for(const double scale : {1e-6, 1., 1e6}) {
    RL::Surface_material material;
    material.set_density([=](const RL::Surface_point& p) { return scale * (2 + p.point.x()); });
    material.set_diffusion(scale);
    const RL::Poisson_solution u = RL::solve_poisson(space.with_material(material), zero,
                                                     params::boundary_values(g).tolerance(1e-10));
    CHECK(u.converged);
    const std::vector<double> values =
        RL::Spline_function_3(space, u.coefficients).values_at_vertices();
    for(std::size_t v = 0; v < values.size(); ++v)
      REQUIRE(std::abs(values[v] - 1 - 2 * t.points[v].x() + t.points[v].y()) < 1e-6);
  }
}

TEST_CASE("values_at_points_are_met_whatever_the_diffusion", "[material]") {
  const Mesh mesh = shapes::mesh(shapes::sphere(3));
  std::vector<double> expected;
  for(const double scale : {1., 1e-6, 1e6}) {
    std::vector<double> u(num_vertices(mesh)),
        given(u.size(), std::numeric_limits<double>::quiet_NaN());
    given[0] = 1;
    given[50] = -1;
    const auto zero = [](const RL::Surface_point&) { return 0.; };
    const auto np = params::depth(4).diffusion(scale).constraints(CGAL::make_property_map(given));
    CHECK(RL::solve_poisson(RL::soup(shapes::triangles(mesh).points, shapes::triangles(mesh).faces),
                            zero, CGAL::make_property_map(u), np)
              .converged);
    CHECK(std::abs(u[0] - 1) < 1e-6);
    CHECK(std::abs(u[50] + 1) < 1e-6);
    if(expected.empty())
      expected = u;
    for(std::size_t v = 0; v < u.size(); ++v)
      REQUIRE(std::abs(u[v] - expected[v]) < 1e-5);
  }
}

TEST_CASE("pulled_back_metric_is_that_of_the_deformed_surface", "[material]") {
  // (x, y) -> (2 x + y / 2, y): D = sqrt(det g) g^-1 and rho = sqrt(det g)
  const auto flat = [](double x, double y) { return RL::Point_3(x, y, 0); };
  const auto sheared = [](double x, double y) { return RL::Point_3(2 * x + y / 2, y, 0); };
  const Triangles t = shapes::grid(16, flat), deformed = shapes::grid(16, sheared);
  const Eigen::Matrix2d jacobian = (Eigen::Matrix2d() << 2, 0.5, 0, 1).finished();
  const Eigen::Matrix2d metric = jacobian.transpose() * jacobian;
  const double root = std::sqrt(metric.determinant());
  Eigen::Matrix3d diffusion = Eigen::Matrix3d::Identity();
  diffusion.topLeftCorner<2, 2>() = root * metric.inverse();
  const auto spectrum_of = [](const Triangles& surface, const auto& np) {
    return RL::laplace_spectrum(RL::soup(surface.points, surface.faces), 15, np).eigenvalues.eval();
  };
  double before = 0;
  for(int depth = 3; depth <= 5; ++depth) {
    const Eigen::VectorXd expected = spectrum_of(deformed, params::depth(6)),
                          found = spectrum_of(
                              t, params::depth(depth)
                                     .diffusion([&](const RL::Surface_point&) { return diffusion; })
                                     .density(root));
    double error = 0;
    for(int i = 1; i < 15; ++i)
      error = (std::max)(error, std::abs(found[i] / expected[i] - 1));
    INFO("depth " << depth << ", error " << error);
    if(depth > 3)
      CHECK(before / error > 6); // eigenvalues of smooth functions: order 4
    before = error;
  }
  CHECK(before < 2e-4);
}

TEST_CASE("flux_through_the_boundary_is_that_of_the_diffusion", "[material]") {
  const Triangles t = shapes::grid(12, [](double x, double y) { return RL::Point_3(x, y, 0); });
  RL::Surface_material material;
  const RL::Symmetric_tensor_3 d = {3, 2, 1, 0.5, 0, 0};
  material.set_diffusion([=](const RL::Surface_point&) { return d; });
  const RL::Spline_space_3 space =
      RL::Spline_space_3(RL::soup(t.points, t.faces), params::depth(4)).with_material(material);
  // u = x + 2 y, and D grad u = (4, 4.5)
  const RL::Boundary_integration boundary(space);
  for(const RL::Boundary_integration::Node& node : boundary.nodes())
    REQUIRE(std::abs(node.flux_direction.x() + 2 * node.flux_direction.y() - 4 * node.conormal.x() -
                     4.5 * node.conormal.y()) < 1e-12);
  const auto zero = [](const RL::Surface_point&) { return 0.; };
  const auto flux = [](const RL::Surface_point& p) {
    const auto is_near = [](double a, double b) { return std::abs(a - b) < 1e-9; };
    const double x = p.point.x(), y = p.point.y();
    return is_near(x, 0) ? -4. : is_near(x, 1) ? 4. : is_near(y, 0) ? -4.5 : 4.5;
  };
  const auto is_left = [](const RL::Surface_point& p) { return p.point.x() < 1e-9; };
  const auto on_left = [](const RL::Surface_point& p) { return p.point.x() + 2 * p.point.y(); };
  const auto np = params::boundary_flux(flux).tolerance(1e-10);
  for(const bool has_values : {false, true}) {
    const RL::Poisson_solution u =
        has_values ? RL::solve_poisson(space, zero,
                                       np.boundary_values(on_left).has_boundary_value(is_left))
                   : RL::solve_poisson(space, zero, np);
    const std::vector<double> values =
        RL::Spline_function_3(space, u.coefficients).values_at_vertices();
    const double mean = has_values ? 0 : 1.5;
    for(std::size_t v = 0; v < values.size(); ++v)
      REQUIRE(std::abs(values[v] - t.points[v].x() - 2 * t.points[v].y() + mean) < 1e-5);
  }
}

TEST_CASE("strip_of_two_materials_has_its_spectrum", "[material]") {
  // [0, 1] x [0, 1 / 8], D = 4 where x < 1 / 2, and 1 beyond; eigenfunctions of x alone are
  // cos(k x / 2) and cos(k (1 - x)) with 2 tan(k / 4) = -tan(k / 2), that is, k / 2 = a + ...
  const auto strip = [](double x, double y) { return RL::Point_3(x, y / 8, 0); };
  const Triangles t = shapes::grid(16, strip);
  // flux D phi' is continuous: 2 sin(k / 4) cos(k / 2) + sin(k / 2) cos(k / 4) = 0
  const auto condition = [](double k) {
    return 2 * std::sin(k / 4) * std::cos(k / 2) + std::sin(k / 2) * std::cos(k / 4);
  };
  std::vector<double> expected;
  for(double k = 0.1; expected.size() < 3; k += 0.01)
    if(condition(k) * condition(k + 0.01) < 0) {
      double low = k, high = k + 0.01;
      for(int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (condition(low) * condition(middle) < 0 ? high : low) = middle;
      }
      expected.push_back(low * low);
    }
  double before = 0;
  for(int depth = 4; depth <= 6; ++depth) {
    const auto d = [](const RL::Surface_point& p) { return p.point.x() < 0.5 ? 4. : 1.; };
    const RL::Laplace_spectrum spectrum =
        RL::laplace_spectrum(RL::soup(t.points, t.faces), 4,
                             params::depth(depth).diffusion(RL::function_of_degree(d, 0)));
    double error = 0;
    for(std::size_t i = 0; i < 3; ++i)
      error = (std::max)(error, std::abs(spectrum.eigenvalues[i + 1] / expected[i] - 1));
    INFO("depth " << depth << ", error " << error);
    if(depth > 4)
      CHECK(before / error > 1.7); // the derivative jumps: order 1
    before = error;
  }
  CHECK(before < 0.02);
}

TEST_CASE("contrast_of_the_diffusion_costs_few_iterations", "[material]") {
  const Mesh mesh = shapes::mesh(torus());
  const RL::Spline_space_3 space(mesh, params::depth(5));
  const auto f = [](const RL::Surface_point& p) { return p.point.z() + p.point.x(); };
  for(const auto& [contrast, most] : {std::pair(1., 15), std::pair(1e2, 25), std::pair(1e4, 40)}) {
    RL::Surface_material material;
    const double high = contrast;
    material.set_diffusion(
        [=](const RL::Surface_point& p) { return p.point.y() > 0.1 ? high : 1.; });
    const RL::Poisson_solution u =
        RL::solve_poisson(space.with_material(material), f, params::tolerance(1e-8));
    INFO("contrast " << contrast << ": " << u.iterations);
    CHECK(u.converged);
    CHECK(u.iterations <= most);
  }
}

TEST_CASE("search_for_an_accuracy_keeps_the_material", "[material]") {
  const Mesh mesh = shapes::mesh(torus());
  const RL::Laplace_spectrum plain = RL::laplace_spectrum(mesh, 8, params::accuracy(1e-3)),
                             scaled = RL::laplace_spectrum(
                                 mesh, 8, params::accuracy(1e-3).diffusion(2).density(0.5));
  CHECK(plain.report.status == RL::Solve_status::converged);
  CHECK(largest_relative(scaled.eigenvalues, 4 * plain.eigenvalues) < 1e-5);
}

TEST_CASE("material_does_not_change_curvature_distances_and_errors", "[material]") {
  const Mesh mesh = shapes::mesh(torus());
  const RL::Spline_space_3 plain(mesh, params::depth(4));
  RL::Surface_material material;
  material.set_diffusion([](const RL::Surface_point& p) { return 3 + p.point.x(); });
  material.set_density([](const RL::Surface_point& p) { return 2 + p.point.y(); });
  const RL::Spline_space_3 space = plain.with_material(material);
  const auto curvatures_of = [&](const RL::Spline_space_3& s) {
    std::vector<RL::Surface_curvature> result(num_vertices(mesh));
    RL::estimate_curvature(s, CGAL::make_property_map(result),
                           params::method(RL::Curvature_method::coordinates));
    return result;
  };
  const std::vector<RL::Surface_curvature> a = curvatures_of(plain), b = curvatures_of(space);
  for(std::size_t v = 0; v < a.size(); ++v)
    REQUIRE(a[v].mean == b[v].mean);
  const RL::Geodesic_solver rays(plain.surface());
  const RL::Geodesic_function d(rays, rays.distances(RL::Geodesic_sources::vertex(0)));
  const RL::Geodesic_spline one = RL::Geodesic_fitter(plain).fit(d),
                            other = RL::Geodesic_fitter(space).fit(d);
  RL::Surface_location place;
  for(place.face = 0; place.face < plain.surface().number_of_faces(); place.face += 7) {
    const RL::Surface_point p = plain.surface().surface_point(place);
    REQUIRE(one(p) == other(p));
  }
  // a constant density leaves the root mean squares
  const auto f = [](const RL::Surface_point& p) { return std::sin(5 * p.point.x()); };
  material = {};
  material.set_density(0.25);
  const RL::Function_fit fit = RL::fit_function(plain, f),
                         same = RL::fit_function(plain.with_material(material), f);
  CHECK(std::abs(fit.root_mean_square_errors[0] / same.root_mean_square_errors[0] - 1) < 1e-3);
  CHECK(fit.root_mean_square_errors[0] > 1e-6);
}

TEST_CASE("bad_coefficients_are_refused", "[material]") {
  const Mesh mesh = shapes::mesh(shapes::sphere(2));
  const auto f = [](const RL::Surface_point& p) { return p.point.z(); };
  const auto message = [&](const auto& np) -> std::string {
    try {
      const RL::Spline_space_3 space(mesh, np);
      RL::solve_poisson(space, f);
    } catch(const RL::Parameter_error& e) {
      return e.what();
    }
    return "";
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for(const double bad : {0., -1., nan, std::numeric_limits<double>::infinity()}) {
    INFO(bad);
    const auto in_one_face = [=](const RL::Surface_point& p) { return p.face == 17 ? bad : 1.; };
    CHECK_THAT(message(params::depth(3).density(in_one_face)),
               Catch::Contains("density") && Catch::Contains("face 17"));
    CHECK_THAT(message(params::depth(3).diffusion(in_one_face)),
               Catch::Contains("diffusion") && Catch::Contains("face 17"));
    const auto along_x = [=](const RL::Surface_point& p) -> RL::Symmetric_tensor_3 {
      return {p.face == 17 ? bad : 1., 1, 1, 0, 0, 0};
    };
    const std::string of_tensor = message(params::depth(3).diffusion(along_x));
    // what is 0 along x may be positive on an oblique tangent plane
    if(!(bad == 0))
      CHECK_THAT(of_tensor, Catch::Contains("diffusion") && Catch::Contains("face 17"));
  }
  const auto skew = [](const RL::Surface_point&) {
    return Eigen::Matrix3d((Eigen::Matrix3d() << 1, 0.5, 0, 0, 1, 0, 0, 0, 1).finished());
  };
  CHECK_THAT(message(params::depth(3).diffusion(skew)), Catch::Contains("symmetric"));
  const auto pair = [](const RL::Surface_point&) { return std::array<double, 2>{1, 1}; };
  CHECK_THAT(message(params::depth(3).diffusion(pair)), Catch::Contains("2 components"));
  CHECK_THAT(message(params::depth(3).density(pair)), Catch::Contains("2 components"));
}

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Bad input ends in an exception that names the culprit, hard input in a right result.

#include "catch.h"
#include "special_shapes.h"

#include <CGAL/Restricted_laplacian_3/fit_function.h>
#include <CGAL/Restricted_laplacian_3/integrate_gradient_field.h>
#include <CGAL/Restricted_laplacian_3/integration/Monte_carlo.h>
#include <CGAL/Restricted_laplacian_3/laplace_spectrum.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_function_3.h>
#include <CGAL/Restricted_laplacian_3/splines/prolongation.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;
using shapes::Mesh;
using Vertex_map = Mesh::Property_map<Mesh::Vertex_index, double>;

const double not_a_number = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

double z(const RL::Surface_point& p) { return p.point.z(); }

RL::Spline_space_3 space_at_depth(const shapes::Triangles& t, int depth) {
  RL::Spline_space_options options;
  options.depth = depth;
  return RL::Spline_space_3(RL::Triangulated_surface_3(t.points, t.faces), options);
}

/// the name in a Parameter_error that `call` throws; empty if it throws none
template <class Call> std::string refused_parameter(Call&& call) {
  try {
    call();
  } catch(const RL::Parameter_error& error) {
    return error.parameter();
  }
  return {};
}

shapes::Triangles transformed(shapes::Triangles t, double scale, const RL::Vector_3& shift) {
  for(RL::Point_3& p : t.points)
    p = CGAL::ORIGIN + scale * (p - CGAL::ORIGIN) + shift;
  return t;
}

} // namespace

TEST_CASE("meshes_without_surface_are_refused", "[input]") {
  Mesh mesh;
  CHECK_THROWS_AS(RL::Spline_space_3(mesh), RL::Empty_surface_error);
  mesh.add_vertex(RL::Point_3(0, 0, 0));
  CHECK_THROWS_AS(RL::Spline_space_3(mesh), RL::Empty_surface_error);
  CHECK_THROWS_AS(RL::cotangent_spectrum(mesh, 3), RL::Empty_surface_error);

  const std::vector<std::array<std::uint32_t, 3>> one_face = {{0, 1, 2}};
  CHECK_THROWS_AS(RL::Triangulated_surface_3({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, one_face),
                  RL::Zero_area_error);
  CHECK_THROWS_AS(RL::Triangulated_surface_3({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}, one_face),
                  RL::Zero_area_error);
}

TEST_CASE("coordinates_that_are_not_finite_are_named", "[input]") {
  for(double bad : {not_a_number, infinity, -infinity})
    for(int axis = 0; axis < 3; ++axis) {
      shapes::Triangles t = shapes::sphere(1);
      std::array<double, 3> p = {0.1, 0.2, 0.3};
      p[axis] = bad;
      t.points[7] = RL::Point_3(p[0], p[1], p[2]);
      try {
        RL::Spline_space_3 space(shapes::mesh(t));
        FAIL("no exception");
      } catch(const RL::Invalid_vertex_error& error) {
        CHECK(error.vertex() == 7);
      }
    }
  // a vertex without a face is not part of the surface
  Mesh mesh = shapes::mesh(shapes::sphere(2));
  const Mesh::Vertex_index lonely = mesh.add_vertex(RL::Point_3(not_a_number, 1e9, 0));
  Vertex_map u = mesh.add_property_map<Mesh::Vertex_index, double>("v:u").first;
  CHECK(RL::solve_poisson(mesh, z, u, params::depth(3)).converged);
  CHECK(std::isnan(u[lonely]));
  CHECK(std::isfinite(u[Mesh::Vertex_index(0)]));
}

TEST_CASE("parameters_outside_their_domain_are_named", "[input]") {
  Mesh mesh = shapes::mesh(shapes::sphere(2));
  Vertex_map u = mesh.add_property_map<Mesh::Vertex_index, double>("v:u").first;
  for(int depth : {-1, 0, 21, 1000})
    CHECK(refused_parameter([&] { RL::Spline_space_3(mesh, params::depth(depth)); }) == "depth");
  for(double scale : {0., -1., 0.99, 1e7, not_a_number, infinity})
    CHECK(refused_parameter([&] { RL::Spline_space_3(mesh, params::cube_scale(scale)); }) ==
          "cube_scale");
  // far too many cells: refused at once, before memory is filled
  for(int depth : {16, 20})
    CHECK(refused_parameter([&] { RL::Spline_space_3(mesh, params::depth(depth)); }) == "depth");
  for(double tolerance : {0., -1., 1., not_a_number})
    CHECK(refused_parameter([&] {
            static_cast<void>(RL::solve_poisson(mesh, z, u, params::depth(2).tolerance(tolerance)));
          }) == "tolerance");
  CHECK(refused_parameter([&] {
          static_cast<void>(RL::solve_poisson(mesh, z, u, params::depth(2).smoothing_steps(0)));
        }) == "smoothing_steps");
  CHECK(refused_parameter([&] {
          static_cast<void>(RL::solve_poisson(mesh, z, u, params::depth(2).maximum_iterations(-1)));
        }) == "maximum_iterations");
  for(double alpha : {0., -1., not_a_number, infinity})
    CHECK(refused_parameter([&] {
            static_cast<void>(RL::solve_screened_poisson(mesh, z, alpha, u, params::depth(2)));
          }) == "alpha");
  for(int k : {-1, 0, 5000})
    CHECK(refused_parameter([&] { RL::laplace_spectrum(mesh, k, params::depth(2)); }) == "count");

  const RL::Spline_space_3 space(mesh, params::depth(3));
  for(int level : {-1, 4}) {
    CHECK(refused_parameter([&] { RL::assemble_mass_matrix(space, level); }) == "level");
    CHECK(refused_parameter([&] { RL::assemble_load(space, z, level); }) == "level");
    CHECK(refused_parameter([&] {
            RL::Spline_function_3(space, Eigen::VectorXd::Zero(space.dimension()), level);
          }) == "level");
  }
  CHECK(refused_parameter([&] { RL::prolongation_matrix(space, 3); }) == "level");
  CHECK(refused_parameter([&] { RL::Spline_function_3(space, Eigen::VectorXd::Zero(5)); }) ==
        "coefficients");
  CHECK(refused_parameter([&] { RL::Monte_carlo(space.octree(), 0, 1); }) == "samples");

  const RL::Spline_function_3 one(space, Eigen::VectorXd::Ones(space.dimension()));
  RL::Surface_location location;
  location.face = num_faces(mesh);
  CHECK_THROWS_AS(one.value(location), RL::Location_error);
  location.face = 0;
  location.barycentric = {20, -19, 0};
  CHECK_THROWS_AS(one.value(location), RL::Location_error);

  const RL::Poisson_solver solver(space, RL::assemble_operators(space));
  Eigen::VectorXd b = Eigen::VectorXd::Zero(space.dimension()), x;
  b[3] = not_a_number;
  CHECK(refused_parameter([&] { static_cast<void>(solver.solve(b, x)); }) == "b");
  CHECK(refused_parameter([&] { static_cast<void>(solver.solve(b.head(5), x)); }) == "b");
}

TEST_CASE("values_that_are_not_finite_are_named", "[input]") {
  Mesh mesh = shapes::mesh(shapes::split_in_four(shapes::rectangle(2, 1)));
  Vertex_map f = mesh.add_property_map<Mesh::Vertex_index, double>("v:f", 1).first,
             u = mesh.add_property_map<Mesh::Vertex_index, double>("v:u").first;
  const Mesh::Vertex_index culprit(2);
  const std::vector<RL::Point_3> points(mesh.points().begin(), mesh.points().end());
  const shapes::Triangles soup = shapes::triangles(mesh);
  std::vector<double> values(points.size());
  const auto index_map = [&](std::vector<double>& numbers) {
    return boost::make_iterator_property_map(numbers.begin(),
                                             boost::typed_identity_property_map<std::size_t>());
  };
  const auto depth = params::depth(2);
  // the parameter that the user gave, and a face at the culprit
  const auto check = [&](const char* name, const std::function<void()>& solve) {
    INFO(name);
    std::string message;
    try {
      solve();
    } catch(const RL::Parameter_error& error) {
      CHECK(error.parameter() == name);
      message = error.what();
    }
    bool is_found = false;
    for(Mesh::Face_index face : mesh.faces())
      for(Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(face)))
        is_found = is_found || (v == culprit && message.size() > 0 &&
                                message.substr(message.rfind(' ') + 1) ==
                                    std::to_string(static_cast<std::size_t>(face)));
    INFO(message);
    CHECK(is_found);
  };
  for(double bad : {not_a_number, infinity, -infinity}) {
    f[culprit] = bad;
    std::vector<double> f_of_soup(points.size(), 1.);
    f_of_soup[culprit] = bad;
    check("f", [&] { static_cast<void>(RL::solve_poisson(mesh, f, u, depth)); });
    check("f", [&] { static_cast<void>(RL::solve_poisson(mesh, f, u, depth.boundary_values(z))); });
    check("f", [&] {
      static_cast<void>(RL::solve_poisson(
          mesh, f, u, params::depth(2).concurrency_tag(CGAL::Parallel_if_available_tag())));
    });
    check("f", [&] { static_cast<void>(RL::solve_screened_poisson(mesh, f, 1., u, depth)); });
    check("f", [&] {
      static_cast<void>(RL::solve_poisson(RL::soup(soup.points, soup.faces), index_map(f_of_soup),
                                          index_map(values), depth));
    });
    check("f", [&] { RL::fit_function(mesh, f, u, depth); });
    check("alpha", [&] { static_cast<void>(RL::solve_screened_poisson(mesh, z, f, u, depth)); });
    check("boundary_values",
          [&] { static_cast<void>(RL::solve_poisson(mesh, z, u, depth.boundary_values(f))); });
    check("target", [&] {
      RL::integrate_gradient_field(
          mesh, [](const RL::Surface_point&) { return RL::Vector_3(1, 0, 0); }, u, depth.target(f));
    });
    check("v", [&] {
      RL::integrate_gradient_field(
          mesh,
          [&](const RL::Surface_point& p) {
            const auto& corners = soup.faces[p.face];
            const bool is_bad = std::count(corners.begin(), corners.end(), culprit) > 0;
            return RL::Vector_3(1, is_bad ? bad : 0, 0);
          },
          u, depth);
    });
  }
}

TEST_CASE("values_are_not_written_to_another_mesh", "[input]") {
  const RL::Spline_space_3 space(shapes::mesh(shapes::sphere(2)), params::depth(2));
  const RL::Spline_function_3 one(space, Eigen::VectorXd::Ones(space.dimension()));
  for(int n : {1, 3}) {
    Mesh other = shapes::mesh(shapes::sphere(n));
    Vertex_map u = other.add_property_map<Mesh::Vertex_index, double>("v:u").first;
    CHECK(refused_parameter([&] { RL::evaluate_at_vertices(one, other, u); }) == "surface");
  }
}

TEST_CASE("non_convergence_is_reported", "[input]") {
  Mesh mesh = shapes::mesh(shapes::sphere(3));
  Vertex_map u = mesh.add_property_map<Mesh::Vertex_index, double>("v:u").first;
  const RL::Solve_report report =
      RL::solve_poisson(mesh, z, u, params::depth(4).tolerance(1e-9).maximum_iterations(1));
  CHECK_FALSE(report.converged);
  CHECK(report.iterations == 1);
  CHECK(report.relative_residual > 1e-9);
}

TEST_CASE("trivial_right_hand_sides", "[input]") {
  Mesh mesh = shapes::mesh(shapes::sphere(3));
  Vertex_map u = mesh.add_property_map<Mesh::Vertex_index, double>("v:u").first;
  for(double constant : {0., 1., 0.1, -1e10}) {
    const RL::Solve_report report = RL::solve_poisson(
        mesh, [constant](const RL::Surface_point&) { return constant; }, u, params::depth(4));
    CHECK(report.converged);
    CHECK(report.iterations == 0);
    for(Mesh::Vertex_index v : mesh.vertices())
      REQUIRE(u[v] == 0);
  }
  struct Thrown {};
  CHECK_THROWS_AS(RL::solve_poisson(
                      mesh, [](const RL::Surface_point&) -> double { throw Thrown(); }, u),
                  Thrown);
  // the mean of a screened solution is exact, however small alpha is
  for(double alpha : {1e-12, 1e-6, 1., 1e6}) {
    static_cast<void>(RL::solve_screened_poisson(
        mesh, [](const RL::Surface_point&) { return 3.; }, alpha, u, params::depth(4)));
    for(Mesh::Vertex_index v : mesh.vertices())
      REQUIRE(u[v] * alpha == Approx(3).epsilon(1e-9));
  }
}

TEST_CASE("degenerate_faces_are_skipped_and_counted", "[input]") {
  const shapes::Triangles sphere = shapes::sphere(3);
  shapes::Triangles dirty = sphere;
  const auto n = static_cast<std::uint32_t>(dirty.points.size());
  dirty.points.push_back(CGAL::midpoint(sphere.points[0], sphere.points[2]));
  dirty.points.push_back(sphere.points[0]);
  dirty.faces.insert(dirty.faces.begin(), {0, 0, 4});     // a corner twice
  dirty.faces.insert(dirty.faces.begin() + 5, {0, n, 2}); // on a line
  dirty.faces.push_back({0, n + 1, 2});                   // two vertices at the same point
  const RL::Spline_space_3 space = space_at_depth(dirty, 4), clean = space_at_depth(sphere, 4);
  CHECK(space.surface().number_of_degenerate_faces() == 3);
  CHECK(space.surface().area() == Approx(clean.surface().area()).epsilon(1e-14));
  REQUIRE(space.dimension() == clean.dimension());
  const RL::Sparse_matrix difference =
      RL::assemble_stiffness_matrix(space) - RL::assemble_stiffness_matrix(clean);
  CHECK(difference.coeffs().abs().maxCoeff() <= 1e-14);
}

TEST_CASE("scale_and_place_do_not_matter", "[input]") {
  const shapes::Triangles sphere = shapes::sphere(3);
  const RL::Laplace_spectrum reference = RL::laplace_spectrum(space_at_depth(sphere, 3), 12);
  for(double scale : {1e-90, 1e-6, 0.37, 1e9, 1e90}) {
    INFO("scale " << scale);
    const shapes::Triangles t = transformed(sphere, scale, {3 * scale, -2 * scale, scale});
    const RL::Spline_space_3 space = space_at_depth(t, 3);
    REQUIRE(Eigen::Index(space.dimension()) == reference.pairs.vectors.rows());
    const RL::Laplace_spectrum spectrum = RL::laplace_spectrum(space, 12);
    CHECK(spectrum.report.converged);
    CHECK((spectrum.eigenvalues * scale * scale - reference.eigenvalues).cwiseAbs().maxCoeff() <=
          1e-7);
    Mesh mesh = shapes::mesh(t);
    Vertex_map u = mesh.add_property_map<Mesh::Vertex_index, double>("v:u").first;
    const RL::Solve_report report = RL::solve_poisson(mesh, z, u, params::depth(3).tolerance(1e-4));
    CHECK(report.converged);
    // Laplacian u = z on a sphere of radius r: u = -r^2 z / 2
    for(Mesh::Vertex_index v : mesh.vertices())
      REQUIRE(u[v] / scale / scale / scale ==
              Approx(-(mesh.point(v).z() / scale - 1) / 2).margin(0.02));
  }
  for(double offset : {1e3, 1e6, 1e9}) {
    INFO("offset " << offset);
    const shapes::Triangles t = transformed(sphere, 1, {offset, 0.7 * offset, -0.3 * offset});
    const RL::Spline_space_3 space = space_at_depth(t, 3);
    const RL::Laplace_spectrum spectrum = RL::laplace_spectrum(space, 12);
    // the coordinates themselves are rounded to offset times 1e-16
    CHECK((spectrum.eigenvalues - reference.eigenvalues).cwiseAbs().maxCoeff() <=
          1e-7 + 1e-13 * offset);
    for(double value :
        RL::Spline_function_3(space, Eigen::VectorXd::Ones(space.dimension())).values_at_vertices())
      REQUIRE(value == Approx(1));
  }
  CHECK(refused_parameter([&] {
          space_at_depth(transformed(sphere, 1e120, {0, 0, 0}), 3);
        }) == "extent");
  CHECK(refused_parameter([&] {
          space_at_depth(transformed(sphere, 1e-120, {0, 0, 0}), 3);
        }) == "extent");
}

TEST_CASE("small_and_flat_surfaces", "[input]") {
  shapes::Triangles triangle;
  triangle.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.faces = {{0, 1, 2}};
  shapes::Triangles needle = triangle;
  needle.points[2] = {0.5, 1e-9, 1e-10};
  for(const shapes::Triangles& t : {triangle, needle})
    for(int depth = 1; depth <= 6; ++depth) {
      Mesh mesh = shapes::mesh(t);
      Vertex_map u = mesh.add_property_map<Mesh::Vertex_index, double>("v:u").first;
      const RL::Spline_space_3 space(mesh, params::depth(depth));
      const RL::Operators operators = RL::assemble_operators(space);
      // corners near a wall are moved by up to 1.5e-14, which counts for the needle
      CHECK(std::abs(operators.mass.sum() - space.surface().area()) <= 1e-12);
      const auto x = [](const RL::Surface_point& p) { return p.point.x(); };
      const RL::Solve_report report = RL::solve_poisson(mesh, x, u, params::depth(depth));
      CHECK(report.converged);
      for(Mesh::Vertex_index v : mesh.vertices())
        REQUIRE(std::isfinite(u[v]));
    }
}

TEST_CASE("components_have_a_mean_of_their_own", "[input]") {
  const shapes::Triangles sphere = shapes::sphere(3);
  const shapes::Triangles two = shapes::joined(sphere, transformed(sphere, 1, {4, 0, 0}));
  Mesh mesh = shapes::mesh(two);
  const RL::Spline_space_3 space(mesh, params::depth(5));
  const RL::Poisson_solver solver(space, RL::assemble_operators(space), 0, params::tolerance(1e-4));
  CHECK(solver.kernel_dimension() == 2);
  // f = 1 on one sphere, -1 on the other: the mean is 0, but not that of each
  const auto f = [](const RL::Surface_point& p) {
    return (p.point.x() > 2 ? 1. : -1.) + p.point.z();
  };
  Eigen::VectorXd eta;
  CHECK(solver.solve(Eigen::VectorXd(-RL::assemble_load(space, f)), eta).converged);
  const std::vector<double> u = RL::Spline_function_3(space, eta).values_at_vertices();
  for(Mesh::Vertex_index v : mesh.vertices())
    REQUIRE(u[v] == Approx(-mesh.point(v).z() / 2).margin(0.02));
  const RL::Laplace_spectrum spectrum = RL::laplace_spectrum(space, 4);
  CHECK(std::abs(spectrum.eigenvalues[1]) <= 1e-9);
  CHECK(spectrum.eigenvalues[2] == Approx(2).epsilon(0.05));
}

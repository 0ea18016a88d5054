// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Spaces on smooth surfaces: identities hold as on flat ones, and results are those of the surface
// that the patches stand for.

#include "catch.h"
#include "matrices.h"
#include "shapes.h"

#include <CGAL/Restricted_laplacian_3/assembly/Dirichlet_boundary.h>
#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/integration/Monte_carlo.h>
#include <CGAL/Restricted_laplacian_3/integration/Weighted_integration.h>
#include <CGAL/Restricted_laplacian_3/integration/cubature.h>
#include <CGAL/Restricted_laplacian_3/laplace_spectrum.h>
#include <CGAL/Restricted_laplacian_3/patches/curved_surface.h>
#include <CGAL/Restricted_laplacian_3/problems/Curvature_field.h>
#include <CGAL/Restricted_laplacian_3/problems/Function_fitter.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_function_3.h>
#include <CGAL/Restricted_laplacian_3/splines/prolongation.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_patches.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/Divided_surface.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/Surface_edges.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <utility>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;

RL::Triangulated_surface_3 curved(const shapes::Triangles& t) {
  return RL::curved_surface(RL::Triangulated_surface_3(t.points, t.faces));
}

/// a cap of the unit sphere around the z axis, up to an angle, in rings of triangles
shapes::Triangles cap(int rings, double angle) {
  shapes::Triangles t;
  t.points.emplace_back(0, 0, 1);
  for(int i = 1; i <= rings; ++i)
    for(int j = 0; j < 6 * i; ++j) {
      const double a = angle * i / rings, b = 2 * CGAL_PI * j / (6 * i);
      t.points.emplace_back(std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a));
    }
  const auto number = [](int i, int j) {
    return static_cast<std::uint32_t>(i == 0 ? 0 : 1 + 3 * i * (i - 1) + j % (6 * i));
  };
  for(int i = 0; i < rings; ++i)
    for(int sixth = 0; sixth < 6; ++sixth)
      for(int j = 0; j <= i; ++j) {
        t.faces.push_back({number(i, i * sixth + j), number(i + 1, (i + 1) * sixth + j),
                           number(i + 1, (i + 1) * sixth + j + 1)});
        if(j < i)
          t.faces.push_back({number(i, i * sixth + j), number(i + 1, (i + 1) * sixth + j + 1),
                             number(i, i * sixth + j + 1)});
      }
  return t;
}

double largest_error_of_sphere(const Eigen::VectorXd& eigenvalues) {
  double largest = 0;
  for(int i = 1; i < eigenvalues.size(); ++i) {
    const int l = static_cast<int>(std::sqrt(i));
    largest = (std::max)(largest, std::abs(eigenvalues[i] / (l * (l + 1.)) - 1));
  }
  return largest;
}

} // namespace

TEST_CASE("patches_are_divided_until_they_are_flat") {
  const shapes::Triangles t = shapes::sphere(2);
  const RL::Triangulated_surface_3 s = curved(t);
  for(double tolerance : {1e-2, 1e-3, 1e-4}) {
    const RL::internal::Divided_surface divided(s, tolerance);
    const RL::Triangulated_surface_3& pieces = divided.pieces();
    CHECK(pieces.number_of_faces() > s.number_of_faces());
    // about one piece for an area of 8 x tolerance x radius; they meet side by side
    CHECK(static_cast<double>(pieces.number_of_faces()) < 8 * CGAL_PI / (8 * tolerance) * 4);
    const RL::internal::Surface_edges edges(pieces);
    for(std::size_t edge = 0; edge < edges.size(); ++edge)
      CHECK(edges.sides(edge).size() == 2);
    CHECK(edges.size() + 2 == pieces.number_of_vertices() + pieces.number_of_faces());
    std::vector<double> fractions(s.number_of_faces(), 0);
    double largest = 0;
    for(std::size_t p = 0; p < pieces.number_of_faces(); ++p) {
      fractions[divided.face(p)] += divided.fraction(p);
      CHECK(divided.fraction(p) > 0);
      CHECK(pieces.normal(p) * s.normal(divided.face(p)) > 0);
      for(const std::array<double, 3>& l :
          {std::array<double, 3>{0.2, 0.3, 0.5}, std::array<double, 3>{1. / 3, 1. / 3, 1. / 3},
           std::array<double, 3>{0.5, 0.5, 0}}) {
        const RL::Surface_location location = divided.location(p, l);
        largest = (std::max)(largest,
                             (s.surface_point(location).point - pieces.surface_point({p, l}).point)
                                 .squared_length());
        const RL::Surface_location back = divided.on_pieces(location);
        CHECK((pieces.surface_point(back).point - pieces.surface_point({p, l}).point)
                  .squared_length() < 1e-28);
      }
    }
    CHECK(std::sqrt(largest) < 1.1 * tolerance);
    CHECK(std::sqrt(largest) > 0.2 * tolerance);
    for(double fraction : fractions)
      CHECK(fraction == Approx(1).epsilon(1e-13));
  }
}

TEST_CASE("matrices_of_smooth_surfaces_keep_their_identities") {
  const auto check = [](const RL::Triangulated_surface_3& s, const auto& np) {
    const RL::Spline_space_3 space(s, np);
    const std::vector<RL::Operators> levels =
        RL::assemble_operators_of_levels(space, 0, space.depth());
    const RL::Sparse_matrix &stiffness = levels[space.depth()].stiffness,
                            &mass = levels[space.depth()].mass;
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(space.dimension());
    // constants have no energy, the mass of 1 is the area of the patches
    CHECK((stiffness * ones).lpNorm<Eigen::Infinity>() <
          1e-12 * Eigen::VectorXd(stiffness.diagonal()).maxCoeff());
    CHECK(ones.dot(mass * ones) == Approx(s.area()).epsilon(1e-7));
    // coarse matrices are Galerkin products
    for(int level = space.depth(); level > 1; --level) {
      const RL::Sparse_matrix p = RL::prolongation_matrix(space, level - 1);
      const RL::Sparse_matrix product = p.transpose() * levels[level].stiffness * p;
      const RL::Sparse_matrix difference = product - levels[level - 1].stiffness;
      CHECK(difference.norm() < 1e-11 * product.norm());
    }
  };
  const auto np = params::depth(4);
  check(curved(shapes::sphere(2)), np);
  check(curved(cap(4, 1)), np);
  check(curved(shapes::box(1, 2, 3, 2, 1)), np);
}

TEST_CASE("the_integration_of_smooth_surfaces_needs_patches") {
  const shapes::Triangles t = shapes::sphere(2);
  const RL::Spline_space_3 flat(RL::soup(t.points, t.faces), params::depth(3)),
      smooth(curved(t), params::depth(3));
  CHECK_THROWS_AS(RL::Patch_cubature(flat.octree()), RL::Input_error);
  CHECK_THROWS_AS(RL::Triangle_cubature(smooth.octree()), RL::Input_error);
  const RL::Spline_space_3 again = smooth.integrated_by(RL::Patch_cubature(smooth.octree()));
  CHECK((RL::assemble_operators(again).mass - RL::assemble_operators(smooth).mass).norm() == 0);
  // nodes say the same as moments
  const RL::Operators by_nodes =
                          RL::assemble_operators(smooth.integrated_by(RL::Weighted_integration(
                              smooth.integration(), [](const RL::Surface_point&) { return 1.; }))),
                      by_moments = RL::assemble_operators(smooth);
  CHECK((by_nodes.stiffness - by_moments.stiffness).norm() < 1e-13 * by_moments.stiffness.norm());
}

TEST_CASE("nodes_lie_on_the_patches") {
  const shapes::Triangles shape[] = {shapes::sphere(2), cap(3, 1), shapes::box(1, 2, 1, 3, 1)};
  for(const shapes::Triangles& t : shape)
    for(int depth : {2, 4}) {
      const RL::Spline_space_3 space(curved(t), params::depth(depth));
      const double h = space.octree().cell_width(depth);
      for(int degree : {2, 5, 12}) {
        double area = 0, largest = 0;
        for(std::size_t sheet = 0; sheet < space.number_of_sheets(depth); ++sheet) {
          const RL::Cell_3 cell = space.octree().cell(depth, sheet);
          space.integration().visit_nodes(sheet, degree, [&](RL::Integration_node_block& block) {
            for(std::size_t i = 0; i < block.size; ++i) {
              const RL::Surface_point &p = block.points[i], q = space.surface().surface_point(p);
              const auto grid = space.octree().grid_coordinates(depth, p.point);
              area += block.weights[i] * h * h;
              largest = (std::max)(largest, (p.point - q.point).squared_length());
              largest = (std::max)(largest, (p.normal - q.normal).squared_length());
              for(int axis = 0; axis < 3; ++axis)
                largest = (std::max)(
                    largest, std::pow(grid[axis] - cell.index[axis] - block.positions[axis][i], 2));
              CHECK(p.vertices == q.vertices);
              CHECK(block.metrics[i] == RL::tangent_projector(p.normal));
            }
          });
        }
        CHECK(largest < 1e-26);
        CHECK(std::abs(area / space.surface().area() - 1) < (degree == 2 ? 1e-4 : 1e-7));
      }
    }
}

TEST_CASE("eigenvalues_of_a_sphere_of_512_triangles") {
  const shapes::Triangles t = shapes::sphere(3);
  const RL::Triangulated_surface_3 flat(t.points, t.faces), smooth = RL::curved_surface(flat);
  const auto np = params::depth(4).stabilization(1e-5).tolerance(1e-5);
  const auto error = [&](const RL::Triangulated_surface_3& s) {
    return largest_error_of_sphere(
        RL::laplace_spectrum(RL::Spline_space_3(s, np), 25, np).eigenvalues);
  };
  const double of_flat = error(flat), of_smooth = error(smooth);
  CAPTURE(of_flat, of_smooth);
  CHECK(of_flat > 1e-2);
  CHECK(of_smooth < 2e-4);
}

TEST_CASE("functions_on_smooth_surfaces_are_those_of_the_patches") {
  const RL::Triangulated_surface_3 s = curved(shapes::sphere(2));
  const RL::Spline_space_3 space(s, params::depth(4));
  const auto f = [](const RL::Surface_point& p) { return p.point.x() * p.point.y(); };
  const RL::Function_fit fit =
      RL::Function_fitter(space, params::smoothing(0.).tolerance(1e-8)).fit(f);
  const RL::Spline_function_3 u(space, fit.coefficients.col(0));
  double of_values = 0, of_gradients = 0, of_vertices = 0;
  std::mt19937 generator(3);
  const auto random = [&] { return generator() * std::ldexp(1., -32); };
  for(int k = 0; k < 2000; ++k) {
    double x = random(), y = random();
    if(x + y > 1) {
      x = 1 - x;
      y = 1 - y;
    }
    const RL::Surface_location location{generator() % s.number_of_faces(), {x, y, 1 - x - y}};
    const RL::Surface_point p = s.surface_point(location);
    of_values = (std::max)(of_values, std::abs(u.value(location) - f(p)));
    const RL::Vector_3 g = u.gradient(location), full(p.point.y(), p.point.x(), 0);
    CHECK(std::abs(g * p.normal) < 1e-12);
    of_gradients = (std::max)(
        of_gradients, std::sqrt((g - full + (full * p.normal) * p.normal).squared_length()));
  }
  const std::vector<double> values = u.values_at_vertices();
  REQUIRE(values.size() == s.number_of_vertices());
  for(std::size_t v = 0; v < values.size(); ++v)
    of_vertices = (std::max)(of_vertices, std::abs(values[v] - s.point(v).x() * s.point(v).y()));
  CAPTURE(of_values, of_gradients, of_vertices);
  // products of coordinates are splines
  CHECK(of_values < 1e-6);
  CHECK(of_vertices < 1e-6);
  CHECK(of_gradients < 1e-4);
}

TEST_CASE("prescribed_values_on_the_curved_boundary_of_a_cap") {
  const double angle = 1;
  const shapes::Triangles t = cap(5, angle);
  const RL::Triangulated_surface_3 flat(t.points, t.faces), smooth = RL::curved_surface(flat);
  CHECK(smooth.area() == Approx(2 * CGAL_PI * (1 - std::cos(angle))).epsilon(1e-5));
  const auto np = params::depth(4).tolerance(1e-8);
  CHECK(RL::Dirichlet_boundary(RL::Spline_space_3(smooth, np)).length() ==
        Approx(2 * CGAL_PI * std::sin(angle)).epsilon(1e-6));
  // Laplacian of z on the sphere: -2 z
  const auto error = [&](const RL::Triangulated_surface_3& s) {
    const auto z = [](const RL::Surface_point& p) { return p.point.z(); };
    const RL::Spline_space_3 space(s, np);
    const RL::Poisson_solution u = RL::solve_poisson(
        space, [&](const RL::Surface_point& p) { return -2 * z(p); }, np.boundary_values(z));
    double largest = 0;
    const std::vector<double> values =
        RL::Spline_function_3(space, u.coefficients).values_at_vertices();
    for(std::size_t v = 0; v < values.size(); ++v)
      largest = (std::max)(largest, std::abs(values[v] - s.point(v).z()));
    return largest;
  };
  const double of_flat = error(flat), of_smooth = error(smooth);
  CAPTURE(of_flat, of_smooth);
  CHECK(of_smooth < of_flat / 30);
  CHECK(of_smooth < 1e-4);
}

TEST_CASE("curvature_of_a_coarse_sphere") {
  const shapes::Triangles t = shapes::sphere(3);
  const RL::Triangulated_surface_3 flat(t.points, t.faces), smooth = RL::curved_surface(flat);
  const auto np = params::depth(4).smoothing(0.);
  for(const RL::Curvature_method method :
      {RL::Curvature_method::normals, RL::Curvature_method::face_normals,
       RL::Curvature_method::coordinates}) {
    const auto error = [&](const RL::Triangulated_surface_3& s) {
      const RL::Spline_space_3 space(s, np);
      double largest = 0;
      for(const RL::Surface_curvature& c :
          RL::estimate_curvature(space, np.method(method)).at_vertices())
        largest = (std::max)(largest, std::abs(c.mean - 1));
      return largest;
    };
    const double of_flat = error(flat), of_smooth = error(smooth);
    CAPTURE(static_cast<int>(method), of_flat, of_smooth);
    // what remains is the error of the splines; interpolated normals of a sphere have no other
    CHECK(of_smooth < 8e-3);
    if(method != RL::Curvature_method::normals)
      CHECK(of_smooth < of_flat / 5);
  }
}

TEST_CASE("samples_of_a_smooth_surface_are_uniform_on_the_patches") {
  const RL::Triangulated_surface_3 s = curved(shapes::sphere(2));
  const auto np = params::depth(3);
  const RL::Spline_space_3 space(s, np);
  const RL::Spline_space_3 sampled =
      space.integrated_by(RL::Monte_carlo(space.octree(), 40000, 1, RL::Sampling::stratified));
  const auto square_of_z = [&](const RL::Spline_space_3& by) {
    return RL::assemble_load(by,
                             [](const RL::Surface_point& p) { return p.point.z() * p.point.z(); })
        .sum();
  };
  CHECK(square_of_z(space) == Approx(4 * CGAL_PI / 3).epsilon(1e-3));
  CHECK(square_of_z(sampled) == Approx(square_of_z(space)).epsilon(1e-3));
}

TEST_CASE("parameters_of_smooth_geometry") {
  const shapes::Triangles t = shapes::sphere(2);
  const shapes::Mesh mesh = shapes::mesh(t);
  const RL::Triangulated_surface_3 flat(t.points, t.faces);
  const auto np = params::depth(3);
  const auto smooth = np.geometry(RL::Surface_geometry::smooth);
  const double flat_area = flat.area(), smooth_area = RL::curved_surface(flat).area();

  CHECK(RL::Spline_space_3(mesh, np).surface().area() == flat_area);
  CHECK(RL::Spline_space_3(mesh, np.geometry(RL::Surface_geometry::flat)).surface().area() ==
        flat_area);
  CHECK(RL::Spline_space_3(mesh, smooth).surface().area() == smooth_area);
  CHECK(RL::Spline_space_3(RL::soup(t.points, t.faces), smooth).surface().area() == smooth_area);
  CHECK(RL::laplace_spectrum(mesh, 3, smooth).area == smooth_area);

  SECTION("creases") {
    // all edges
    CHECK(RL::Spline_space_3(mesh, smooth.crease_angle(1.)).surface().area() ==
          Approx(flat_area).epsilon(1e-12));
    CHECK_THROWS_AS(RL::Spline_space_3(mesh, smooth.crease_angle(200.)), RL::Parameter_error);
    // those of the upper half remain straight where many of them meet
    auto is_feature = get(CGAL::dynamic_edge_property_t<bool>(), mesh);
    for(auto e : edges(mesh)) {
      const auto h = halfedge(e, mesh);
      put(is_feature, e,
          mesh.point(source(h, mesh)).z() > 0.3 && mesh.point(target(h, mesh)).z() > 0.3);
    }
    const RL::Spline_space_3 space(mesh, smooth.edge_is_feature_map(is_feature));
    CHECK(space.surface().area() < smooth_area - 1e-3);
    CHECK(space.surface().area() > flat_area + 1e-3);
  }
  SECTION("normals") {
    auto normals = get(CGAL::dynamic_vertex_property_t<RL::Vector_3>(), mesh);
    std::vector<RL::Vector_3> of_points;
    for(auto v : vertices(mesh)) {
      const RL::Point_3& p = mesh.point(v);
      of_points.emplace_back(p.x(), p.y(), p.z() + 0.1);
      put(normals, v, of_points.back());
    }
    const double tilted =
        RL::Spline_space_3(mesh, smooth.vertex_normal_map(normals)).surface().area();
    CHECK(std::abs(tilted - smooth_area) > 1e-4);
    CHECK(RL::Spline_space_3(RL::soup(t.points, t.faces),
                             smooth.vertex_normal_map(CGAL::make_property_map(of_points)))
              .surface()
              .area() == Approx(tilted).epsilon(1e-12));
  }
  SECTION("projections") {
    const auto to_sphere = [](const RL::Point_3& p) {
      const RL::Vector_3 v = p - CGAL::ORIGIN;
      return CGAL::ORIGIN + 2 * v / std::sqrt(v.squared_length());
    };
    const auto with_normal = [&](const RL::Point_3& p) {
      return std::make_pair(to_sphere(p), p - CGAL::ORIGIN);
    };
    const double area = RL::Spline_space_3(mesh, np.geometry(to_sphere)).surface().area();
    CHECK(area == Approx(16 * CGAL_PI).epsilon(1e-3));
    CHECK(RL::Spline_space_3(mesh, np.geometry(with_normal)).surface().area() == area);

    // of another kernel's points, those of the mesh
    using Other = CGAL::Exact_predicates_inexact_constructions_kernel;
    CGAL::Surface_mesh<Other::Point_3> other;
    std::vector<Other::Point_3> points;
    for(const RL::Point_3& p : t.points) {
      points.emplace_back(p.x(), p.y(), p.z());
      other.add_vertex(points.back());
    }
    using Vertex = CGAL::SM_Vertex_index;
    for(const auto& f : t.faces)
      other.add_face(Vertex(f[0]), Vertex(f[1]), Vertex(f[2]));
    const std::function<Other::Point_3(const Other::Point_3&)> own = [](const Other::Point_3& p) {
      const Other::Vector_3 v = p - CGAL::ORIGIN;
      return CGAL::ORIGIN + 2 * v / std::sqrt(v.squared_length());
    };
    const auto to_own = np.geometry(own);
    CHECK(RL::Spline_space_3(other, to_own).surface().area() == area);
    CHECK(RL::Spline_space_3(RL::soup(points, t.faces), to_own).surface().area() == area);
  }
  SECTION("points have no geometry") {
    using Pair = std::pair<RL::Point_3, RL::Vector_3>;
    std::vector<Pair> distinct;
    for(const RL::Point_3& p : t.points)
      distinct.emplace_back(p, p - CGAL::ORIGIN);
    CHECK_THROWS_AS(
        RL::Spline_space_3(distinct, smooth.point_map(CGAL::First_of_pair_property_map<Pair>())
                                         .normal_map(CGAL::Second_of_pair_property_map<Pair>())),
        RL::Input_error);
  }
}

TEST_CASE("smooth_geometry_of_bad_meshes") {
  const auto np = params::depth(3).geometry(RL::Surface_geometry::smooth);
  const auto solve = [&](const shapes::Triangles& t, const auto& all) {
    const RL::Spline_space_3 space(RL::soup(t.points, t.faces), all);
    const RL::Poisson_solution u = RL::solve_poisson(
        space, [](const RL::Surface_point& p) { return p.point.x(); }, all);
    CHECK(u.converged);
    CHECK(u.coefficients.allFinite());
    const RL::Sparse_matrix stiffness = RL::assemble_operators(space).stiffness;
    CHECK((stiffness * Eigen::VectorXd::Ones(space.dimension())).lpNorm<Eigen::Infinity>() <
          1e-11 * Eigen::VectorXd(stiffness.diagonal()).maxCoeff());
  };
  SECTION("one triangle") {
    shapes::Triangles t;
    t.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    t.faces = {{0, 1, 2}};
    solve(t, np);
  }
  SECTION("degenerate, duplicate and turned faces, and a fan") {
    shapes::Triangles t = shapes::sphere(2);
    const std::size_t n = t.faces.size();
    for(std::size_t f = 0; f < n; f += 7)
      std::swap(t.faces[f][0], t.faces[f][1]);
    t.faces.push_back(t.faces[3]);
    t.faces.push_back({t.faces[5][0], t.faces[5][1], t.faces[5][1]});
    t.points.emplace_back(2, 2, 2);
    t.faces.push_back(
        {t.faces[8][0], t.faces[8][1], static_cast<std::uint32_t>(t.points.size() - 1)});
    solve(t, np);
  }
  SECTION("edges of more than 40 cells") {
    solve(shapes::sphere(1), np.depth(7).crease_angle(60.));
  }
  SECTION("facets in a wall between cells, and patches that leave it") {
    shapes::Triangles t;
    const std::uint32_t n = 6;
    std::vector<RL::Vector_3> normals;
    for(std::uint32_t j = 0; j <= n; ++j)
      for(std::uint32_t i = 0; i <= n; ++i) {
        t.points.emplace_back(i / 6., j / 6., 0);
        normals.emplace_back(0.05 * std::sin(2. * i), 0.05 * std::cos(3. * j), 1);
      }
    for(std::uint32_t j = 0; j < n; ++j)
      for(std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
        t.faces.push_back({a, b, c});
        t.faces.push_back({a, c, d});
      }
    // all pieces are the faces
    const auto all = np.vertex_normal_map(CGAL::make_property_map(normals)).depth(1);
    CHECK(
        RL::Spline_space_3(RL::soup(t.points, t.faces), all).octree().pieces().number_of_faces() ==
        t.faces.size());
    solve(t, all);
  }
  SECTION("a cone, and a cube scale of 1") {
    shapes::Triangles t;
    t.points.emplace_back(0, 0, 1);
    const std::uint32_t n = 24;
    for(std::uint32_t i = 0; i < n; ++i) {
      const double a = 2 * CGAL_PI * i / n;
      t.points.emplace_back(std::cos(a), std::sin(a), 0);
      t.faces.push_back({0, 1 + i, 1 + (i + 1) % n});
    }
    solve(t, np.cube_scale(1.));
  }
  SECTION("noise") {
    std::mt19937 generator(1);
    for(double noise : {0.01, 0.1}) {
      shapes::Triangles t = shapes::sphere(3);
      for(RL::Point_3& p : t.points)
        p = p + (p - CGAL::ORIGIN) * (noise * (generator() * std::ldexp(2., -32) - 1));
      solve(t, np.depth(4));
    }
  }
  SECTION("threads change nothing") {
    const shapes::Triangles t = cap(6, 2);
    const RL::Spline_space_3 one(RL::soup(t.points, t.faces), np),
        two(RL::soup(t.points, t.faces), np.concurrency_tag(CGAL::Parallel_if_available_tag()));
    const RL::Operators a = RL::assemble_operators(one), b = RL::assemble_operators(two);
    CHECK((a.stiffness - b.stiffness).norm() == 0);
    CHECK((a.mass - b.mass).norm() == 0);
  }
}

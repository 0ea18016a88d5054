// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Identities that the matrices and loads satisfy to rounding, whatever the surface.

#include "catch.h"
#include "matrices.h"
#include "shapes.h"
#include "special_shapes.h"

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/assembly/shared/assemble_system.h>
#include <CGAL/Restricted_laplacian_3/assembly/shared/fit_residual.h>
#include <CGAL/Restricted_laplacian_3/input/vertex_functions.h>
#include <CGAL/Restricted_laplacian_3/integration/Monte_carlo.h>
#include <CGAL/Restricted_laplacian_3/integration/Weighted_integration.h>
#include <CGAL/Restricted_laplacian_3/integration/triangle_quadrature.h>
#include <CGAL/Restricted_laplacian_3/solvers/galerkin_product.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_function_3.h>
#include <CGAL/Restricted_laplacian_3/splines/prolongation.h>
#include <CGAL/Restricted_laplacian_3/surface/sample_surface.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;
using shapes::Mesh;

struct Named_mesh {
  std::string name;
  Mesh mesh;
  int depth;
};

/// sphere, cow, bunny, fandisk and an open mesh
std::vector<Named_mesh> surfaces() {
  std::vector<Named_mesh> result;
  result.push_back({"sphere", shapes::mesh(shapes::sphere(4)), 4});
  result.push_back({"box", shapes::mesh(shapes::box(1, 1, 1, 3, 1)), 4});
  for(const auto& [file, depth] : std::vector<std::pair<std::string, int>>{
          {"cow.off", 5}, {"bunny00.off", 5}, {"fandisk.off", 5}, {"lion-head.off", 5}}) {
    Mesh mesh = shapes::read(cgal_mesh(file));
    if(mesh.is_empty())
      SKIP_PART("no such file: " << file);
    else
      result.push_back({file, std::move(mesh), depth});
  }
  return result;
}

/// largest |a_ij - b_ij| / sqrt(b_ii b_jj): also small entries have to agree
double scaled_difference(const RL::Sparse_matrix& a, const RL::Sparse_matrix& b) {
  const Eigen::VectorXd d = b.diagonal();
  const RL::Sparse_matrix c = a - b;
  double result = 0;
  for(int j = 0; j < c.cols(); ++j)
    for(RL::Sparse_matrix::InnerIterator i(c, j); i; ++i)
      result = (std::max)(result, std::abs(i.value()) / std::sqrt(d[i.row()] * d[j]));
  return result;
}

double integral(const RL::Triangulated_surface_3& surface,
                const std::function<double(const RL::Surface_point&)>& f) {
  double sum = 0;
  for(std::size_t face = 0; face < surface.number_of_faces(); ++face)
    for(const RL::Triangle_quadrature_node& node : RL::triangle_quadrature(12)) {
      RL::Surface_location location;
      location.face = face;
      location.barycentric = {node.b0, node.b1, node.b2};
      sum += surface.area(face) * node.weight * f(surface.surface_point(location));
    }
  return sum;
}

/// A triquadratic polynomial on the domain cube, p(x) = product over axes of x_a^2 + c_a x_a, in
/// units of the cube around its center, and its coefficients in the splines: those of 1D splines
/// are the values of the blossom at the two inner knots, at half a cell on both sides of the
/// center.
struct Triquadratic {
  const RL::Octree_3& octree;
  std::array<double, 3> c;

  std::array<double, 3> unit(const RL::Point_3& p) const {
    std::array<double, 3> x = octree.grid_coordinates(0, p);
    for(double& v : x)
      v -= 0.5;
    return x;
  }
  double operator()(const RL::Point_3& p) const {
    const auto x = unit(p);
    double result = 1;
    for(int a = 0; a < 3; ++a)
      result *= x[a] * x[a] + c[a] * x[a];
    return result;
  }
  RL::Vector_3 gradient(const RL::Point_3& p) const {
    const auto x = unit(p);
    std::array<double, 3> g;
    for(int a = 0; a < 3; ++a) {
      const int b = (a + 1) % 3, d = (a + 2) % 3;
      g[a] = (2 * x[a] + c[a]) * (x[b] * x[b] + c[b] * x[b]) * (x[d] * x[d] + c[d] * x[d]) /
             octree.side();
    }
    return {g[0], g[1], g[2]};
  }
  Eigen::VectorXd coefficients(const RL::Spline_space_3& space, int level) const {
    Eigen::VectorXd result(space.dimension(level));
    const double h = std::ldexp(1., -level);
    for(std::size_t i = 0; i < space.dimension(level); ++i) {
      result[i] = 1;
      for(int a = 0; a < 3; ++a) {
        const double x = (space.center(level, i).index[a] + 0.5) * h - 0.5;
        result[i] *= (x - h / 2) * (x + h / 2) + c[a] * x;
      }
    }
    return result;
  }
};

} // namespace

TEST_CASE("mass_sums_to_area", "[operators]") {
  for(const Named_mesh& s : surfaces()) {
    INFO(s.name);
    const RL::Spline_space_3 space(s.mesh, params::depth(s.depth));
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(space.dimension());
    const RL::Sparse_matrix mass = RL::assemble_mass_matrix(space);
    CHECK(ones.dot(mass * ones) == Approx(space.surface().area()).epsilon(1e-12));
    const Eigen::VectorXd integrals = RL::assemble_element_integrals(space);
    CHECK((mass * ones - integrals).cwiseAbs().maxCoeff() <= 1e-13 * integrals.maxCoeff());
    CHECK(integrals.minCoeff() > 0);
  }
}

TEST_CASE("stiffness_annihilates_constants", "[operators]") {
  for(const Named_mesh& s : surfaces()) {
    INFO(s.name);
    const RL::Spline_space_3 space(s.mesh, params::depth(s.depth));
    const RL::Sparse_matrix stiffness = RL::assemble_stiffness_matrix(space);
    const Eigen::VectorXd sums = stiffness * Eigen::VectorXd::Ones(space.dimension());
    CHECK(sums.cwiseAbs().maxCoeff() <= 1e-13 * stiffness.coeffs().maxCoeff());
  }
}

TEST_CASE("matrices_are_symmetric_and_positive_after_scaling", "[operators]") {
  std::mt19937 generator(5);
  std::normal_distribution<double> normal;
  for(const Named_mesh& s : surfaces()) {
    INFO(s.name);
    const RL::Spline_space_3 space(s.mesh, params::depth(s.depth));
    const RL::Operators operators = RL::assemble_operators(space);
    for(const RL::Sparse_matrix* a : {&operators.stiffness, &operators.mass}) {
      CHECK(RL::Sparse_matrix(*a - RL::Sparse_matrix(a->transpose())).coeffs().abs().maxCoeff() ==
            0);
      // Elements that hardly reach the surface have entries many orders below the others; scaling
      // brings out whether those are accurate.
      const Eigen::VectorXd diagonal = a->diagonal();
      REQUIRE(diagonal.minCoeff() > 0);
      const Eigen::VectorXd scale = diagonal.cwiseSqrt().cwiseInverse();
      for(int k = 0; k < 20; ++k) {
        Eigen::VectorXd x(a->cols());
        for(double& v : x)
          v = normal(generator);
        const Eigen::VectorXd y = scale.cwiseProduct(x);
        CHECK(y.dot(*a * y) > 0);
      }
      double largest_cosine = 0;
      for(int j = 0; j < a->cols(); ++j)
        for(RL::Sparse_matrix::InnerIterator i(*a, j); i; ++i)
          largest_cosine =
              (std::max)(largest_cosine, std::abs(i.value()) * scale[i.row()] * scale[j]);
      CHECK(largest_cosine <= 1 + 1e-9); // Cauchy-Schwarz
    }
  }
}

TEST_CASE("quadratic_forms_of_polynomials_are_exact", "[operators][slow]") {
  // An independent path to the same numbers: the polynomial itself, integrated over whole
  // triangles.
  for(const Named_mesh& s : surfaces()) {
    INFO(s.name);
    const RL::Spline_space_3 space(s.mesh, params::depth(s.depth));
    for(int level : {s.depth - 1, s.depth}) {
      INFO("level " << level);
      const Triquadratic p{space.octree(), {0.3, -0.2, 0.5}}, q{space.octree(), {-0.1, 0.4, 0.2}};
      const Eigen::VectorXd x = p.coefficients(space, level), y = q.coefficients(space, level);
      const RL::Operators operators = RL::assemble_operators(space, level);
      const auto& surface = space.surface();
      const auto scalar_product = [&](const RL::Surface_point& at) {
        return p(at.point) * q(at.point);
      };
      CHECK(x.dot(operators.mass * y) == Approx(integral(surface, scalar_product)).epsilon(1e-10));
      const auto dirichlet = [&](const RL::Surface_point& at) {
        const RL::Vector_3 a = p.gradient(at.point), b = q.gradient(at.point);
        return a * b - (a * at.normal) * (b * at.normal);
      };
      CHECK(x.dot(operators.stiffness * y) == Approx(integral(surface, dirichlet)).epsilon(1e-10));
      CHECK(RL::assemble_load(
                space, [&](const RL::Surface_point& at) { return q(at.point); }, level)
                .dot(x) == Approx(integral(surface, scalar_product)).epsilon(1e-10));
      CHECK(RL::assemble_gradient_load(
                space, [&](const RL::Surface_point& at) { return q.gradient(at.point); }, level)
                .dot(x) == Approx(integral(surface, dirichlet)).epsilon(1e-10));
    }
  }
}

TEST_CASE("functions_linear_on_faces_are_integrated_by_their_corners", "[operators]") {
  // the same function without a degree goes through 32 nodes of each piece of a triangle
  const auto by_nodes = [](const auto& f) {
    return [&f](const RL::Surface_point& p) { return f(p); };
  };
  for(const auto& [name, mesh, depth] : surfaces()) {
    CAPTURE(name);
    const RL::Spline_space_3 space(mesh, params::depth(depth - 1));
    const RL::Triangulated_surface_3& surface = space.surface();
    std::mt19937 generator(1);
    std::normal_distribution<double> normal;
    const auto vector = [&] { return RL::Vector_3(normal(generator), normal(generator), 1); };
    std::vector<double> values;
    std::vector<std::array<double, 2>> pairs;
    std::vector<RL::Vector_3> at_vertices, of_faces, at_corners;
    for(std::size_t v = 0; v < surface.number_of_vertices(); ++v) {
      values.push_back(normal(generator));
      at_vertices.push_back(vector());
    }
    for(std::size_t f = 0; f < surface.number_of_faces(); ++f) {
      of_faces.push_back(vector());
      for(int i = 0; i < 3; ++i)
        at_corners.push_back(vector());
    }
    const auto check = [](const Eigen::MatrixXd& fast, const Eigen::MatrixXd& exact) {
      CHECK((fast - exact).cwiseAbs().maxCoeff() / exact.cwiseAbs().maxCoeff() <= 1e-12);
    };
    const RL::Linear_surface_function<double> linear(values);
    const RL::Linear_surface_function<RL::Vector_3> linear_field(at_vertices);
    const RL::Face_function<RL::Vector_3> face_field(of_faces);
    const RL::Corner_vector_field<RL::Vector_3> corner_field(at_corners);
    check(RL::assemble_load(space, linear), RL::assemble_load(space, by_nodes(linear)));
    // on a coarser level all of them go through nodes
    check(RL::assemble_load(space, linear, 2), RL::assemble_load(space, by_nodes(linear), 2));
    check(RL::assemble_component_loads(space, corner_field),
          RL::assemble_component_loads(space, by_nodes(corner_field)));
    check(RL::assemble_gradient_load(space, linear_field),
          RL::assemble_gradient_load(space, by_nodes(linear_field)));
    check(RL::assemble_gradient_load(space, face_field),
          RL::assemble_gradient_load(space, by_nodes(face_field)));
    check(RL::assemble_gradient_load(space, corner_field),
          RL::assemble_gradient_load(space, by_nodes(corner_field)));
    const auto fast = RL::internal::fit_residual(space, corner_field),
               exact = RL::internal::fit_residual(space, by_nodes(corner_field));
    check(fast.loads, exact.loads);
    check(fast.squares, exact.squares);

    // with weights and tensors, nodes it is
    const auto weight = [](const RL::Surface_point& p) { return 2 + std::sin(p.point.x()); };
    const RL::Spline_space_3 weighted =
        space.integrated_by(RL::Weighted_integration(space.integration(), weight));
    const auto product = [&](const RL::Surface_point& p) { return weight(p) * linear(p); };
    CHECK(RL::assemble_load(weighted, linear).isApprox(RL::assemble_load(space, product), 1e-7));

    values[surface.triangle(3)[1]] = std::numeric_limits<double>::infinity();
    const RL::Linear_surface_function<double> infinite(values);
    CHECK_THROWS_AS(RL::assemble_load(space, infinite), RL::Parameter_error);
  }
}

TEST_CASE("load_sums_to_integral", "[operators]") {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(1, 2);
  for(Named_mesh& s : surfaces()) {
    INFO(s.name);
    const RL::Spline_space_3 space(s.mesh, params::depth(s.depth));
    auto values = s.mesh.add_property_map<Mesh::Vertex_index, double>("v:values").first;
    for(Mesh::Vertex_index v : s.mesh.vertices())
      values[v] = uniform(generator);
    // exact: a linear function times the area, at the centroid
    double expected = 0;
    for(std::size_t f = 0; f < space.surface().number_of_faces(); ++f)
      for(std::uint32_t v : space.surface().triangle(f))
        expected += space.surface().area(f) * values[Mesh::Vertex_index(v)] / 3;
    for(int level : {2, s.depth})
      CHECK(RL::assemble_load(space, RL::vertex_function(s.mesh, values), level).sum() ==
            Approx(expected).epsilon(1e-12));
    // A function that is known to be linear takes a rule with half the nodes, with the same result.
    const auto linear = RL::vertex_function(s.mesh, values);
    const Eigen::VectorXd load = RL::assemble_load(space, linear),
                          same = RL::assemble_load(
                              space, [&](const RL::Surface_point&p) { return linear(p); });
    CHECK((load - same).cwiseAbs().maxCoeff() <= 1e-14 * load.cwiseAbs().maxCoeff());
    // polynomials of degree 2 with 16 nodes in place of 32
    const auto square = [](const RL::Surface_point& p) { return p.point.x() * p.point.y(); };
    CHECK(RL::assemble_load(space, RL::function_of_degree(square, 2))
              .isApprox(RL::assemble_load(space, square), 1e-13));
    const auto evaluations = [&](int degree) {
      int number = 0;
      const auto count = [&](const RL::Surface_point&) { return static_cast<double>(++number); };
      RL::assemble_load(space, RL::function_of_degree(count, degree));
      return number;
    };
    CHECK(2 * evaluations(2) == evaluations(6));
    CHECK(evaluations(1) < evaluations(2) / 3);
    CHECK_THROWS_AS(RL::function_of_degree(square, 7), RL::Parameter_error);
    // the load of a gradient sums to 0, because the gradient of the sum of all elements is 0
    const RL::Vector_3 constant(1, 2, 3);
    const Eigen::VectorXd g =
        RL::assemble_gradient_load(space, [&](const RL::Surface_point&) { return constant; });
    CHECK(std::abs(g.sum()) <= 1e-12 * g.cwiseAbs().sum());
  }
}

TEST_CASE("galerkin_product_equals_direct_assembly", "[operators]") {
  for(const Named_mesh& s : surfaces()) {
    INFO(s.name);
    const RL::Spline_space_3 space(s.mesh, params::depth(s.depth));
    const std::vector<RL::Operators> all = RL::assemble_operators_of_levels(space, 0, s.depth);
    for(int level = 0; level < s.depth; ++level) {
      INFO("level " << level);
      const RL::Sparse_matrix p = RL::prolongation_matrix(space, level);
      // a space of its own: triangles are cut along the walls of the coarser grid
      const RL::Spline_space_3 coarse(s.mesh, params::depth((std::max)(level, 1)));
      REQUIRE(coarse.dimension(level) == space.dimension(level));
      const RL::Operators direct = RL::assemble_operators(coarse, level);
      for(const auto& [fine, traversed, expected] :
          {std::tie(all[level + 1].stiffness, all[level].stiffness, direct.stiffness),
           std::tie(all[level + 1].mass, all[level].mass, direct.mass)}) {
        CHECK(relative_difference(RL::galerkin_product(fine, p), expected) <= 1e-12);
        CHECK(relative_difference(traversed, expected) <= 1e-12);
        CHECK(relative_difference(RL::galerkin_product(fine, p),
                                  RL::Sparse_matrix(p.transpose() * fine * p)) <= 1e-14);
      }
    }
  }
}

TEST_CASE("prolongation_preserves_functions", "[operators]") {
  std::mt19937 generator(11);
  std::normal_distribution<double> normal;
  for(const Named_mesh& s : surfaces()) {
    INFO(s.name);
    const RL::Spline_space_3 space(s.mesh, params::depth(s.depth));
    const auto samples = RL::sample_surface(space.surface(), 200, 3);
    for(int level = 0; level < s.depth; ++level) {
      Eigen::VectorXd coarse(space.dimension(level));
      for(double& v : coarse)
        v = normal(generator);
      const RL::Sparse_matrix p = RL::prolongation_matrix(space, level);
      const RL::Spline_function_3 u(space, coarse, level), v(space, p * coarse, level + 1);
      double difference = 0, gradient_difference = 0, gradient = 0;
      for(const RL::Surface_location& location : samples) {
        difference = (std::max)(difference, std::abs(u.value(location) - v.value(location)));
        const RL::Vector_3 g = u.gradient(location);
        gradient = (std::max)(gradient, std::sqrt(g.squared_length()));
        gradient_difference =
            (std::max)(gradient_difference, std::sqrt((g - v.gradient(location)).squared_length()));
      }
      CHECK(difference <= 1e-12);
      CHECK(gradient_difference <= 1e-11 * gradient);
      // columns of the stencil 1/4 (1 3 3 1) sum to 8 where no fine element is missing, rows to 1
      CHECK((p * Eigen::VectorXd::Ones(p.cols()) - Eigen::VectorXd::Ones(p.rows()))
                .cwiseAbs()
                .maxCoeff() <= 1e-15);
    }
  }
}

TEST_CASE("matrices_do_not_depend_on_the_triangulation", "[operators][slow]") {
  const auto check = [](const shapes::Triangles& a, const shapes::Triangles& b, int depth) {
    RL::Spline_space_options options;
    options.depth = depth;
    const RL::Spline_space_3 first(RL::Triangulated_surface_3(a.points, a.faces), options);
    const RL::Spline_space_3 second(RL::Triangulated_surface_3(b.points, b.faces), options);
    REQUIRE(first.dimension() == second.dimension());
    const RL::Operators of_first = RL::assemble_operators(first),
                        of_second = RL::assemble_operators(second);
    CHECK(relative_difference(of_second.stiffness, of_first.stiffness) <= 1e-10);
    CHECK(relative_difference(of_second.mass, of_first.mass) <= 1e-10);
    CHECK(scaled_difference(of_second.mass, of_first.mass) <= 1e-5);
  };
  for(const Named_mesh& s : surfaces()) {
    const shapes::Triangles original = shapes::triangles(s.mesh);
    {
      INFO(s.name << ", every triangle split in four");
      check(original, shapes::split_in_four(original), s.depth);
    }
    {
      INFO(s.name << ", faces reordered, corners rotated, half of them flipped");
      shapes::Triangles reordered = original;
      std::mt19937 generator(13);
      std::shuffle(reordered.faces.begin(), reordered.faces.end(), generator);
      for(auto& f : reordered.faces) {
        std::rotate(f.begin(), f.begin() + generator() % 3, f.end());
        if(generator() & 1u)
          std::swap(f[0], f[1]);
      }
      check(original, reordered, s.depth);
    }
  }
  for(int depth = 1; depth <= 5; ++depth) {
    INFO("flat sides triangulated in another way, depth " << depth);
    check(shapes::box(1, 1, 1, 3, 1), shapes::box(1, 1, 1, 3, 2), depth);
    check(shapes::box(1, 0.7, 0.3, 4, 1), shapes::box(1, 0.7, 0.3, 7, 5), depth);
  }
}

TEST_CASE("number_of_elements", "[operators]") {
  // those of an independent prototype, and of Table 1 of the paper
  const Mesh sphere = shapes::mesh(shapes::sphere(5));
  const auto dimension = [&sphere](int depth) {
    return RL::Spline_space_3(sphere, params::depth(depth).split(false)).dimension();
  };
  CHECK(dimension(3) == 816);
  CHECK(dimension(4) == 3048);
  CHECK(dimension(5) == 12024);
  CHECK(RL::Spline_space_3(sphere, params::depth(3).paper(true)).dimension() == 504);
}

TEST_CASE("number_of_elements_of_the_paper_on_real_meshes", "[operators]") {
  // those of an independent prototype
  for(const auto& [file, depth, expected] :
      {std::tuple<std::string, int, std::size_t>{"cow_5k8.ply", 8, 188443},
       {"bimba_46k.ply", 5, 6302}}) {
    const Mesh mesh = shapes::read(shared_mesh(file));
    if(mesh.is_empty())
      SKIP_TEST("no such file: " << file);
    CHECK(RL::Spline_space_3(mesh, params::depth(depth).paper(true)).dimension() == expected);
  }
}

TEST_CASE("monte_carlo_converges_to_cubature", "[operators][slow]") {
  const Mesh mesh = shapes::mesh(shapes::sphere(4));
  const RL::Spline_space_3 space(mesh, params::depth(3));
  const RL::Operators exact = RL::assemble_operators(space);
  const double scale = exact.stiffness.norm();
  std::array<double, 2> errors;
  for(int i = 0; i < 2; ++i) {
    const RL::Spline_space_3 sampled =
        space.integrated_by(RL::Monte_carlo(space.octree(), i == 0 ? 20000 : 2000000, 1));
    const RL::Operators estimate = RL::assemble_operators(sampled);
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(space.dimension());
    CHECK(ones.dot(estimate.mass * ones) == Approx(space.surface().area()).epsilon(1e-12));
    CHECK((estimate.stiffness * ones).cwiseAbs().maxCoeff() <= 1e-13);
    errors[i] = (estimate.stiffness - exact.stiffness).norm() / scale;
    const auto z = [](const RL::Surface_point& p) { return p.point.z() * p.point.z(); };
    CHECK(RL::assemble_load(sampled, z).sum() ==
          Approx(RL::assemble_load(space, z).sum()).epsilon(0.02));
  }
  // a hundred times the samples: a tenth of the error
  CHECK(errors[0] < 0.2);
  CHECK(errors[1] < errors[0] / 6);
  CHECK(errors[1] > errors[0] / 16);
}

namespace {

/// N of `assemble_operators()`, and of how many sheets it is made that are tiny, or in a wall.
struct Penalty {
  Eigen::MatrixXd matrix;
  std::size_t tiny = 0, in_walls = 0, in_several = 0;
};

/// From the element functions themselves: the integrals over cells and over faces in walls by the
/// Gauss rule of three nodes per axis; areas, normals and walls from the fragments.
Penalty penalty(const RL::Spline_space_3& space) {
  const RL::Octree_3& octree = space.octree();
  const int depth = space.depth();
  const double h = octree.cell_width(depth);
  const double node = std::sqrt(0.6) / 2;
  Penalty result;
  result.matrix = Eigen::MatrixXd::Zero(space.dimension(), space.dimension());
  for(std::size_t sheet = 0; sheet < octree.number_of_sheets(depth); ++sheet) {
    Eigen::Matrix3d average = Eigen::Matrix3d::Zero();
    double area = 0;
    // at the lower and the upper end of each axis, whether a fragment lies in the wall, and whether
    // one does not lie in any
    std::array<std::array<bool, 2>, 3> walls = {};
    bool is_in_walls = true;
    for(std::uint32_t face : octree.faces(sheet)) {
      const RL::Cell_3 cell = octree.cell(depth, sheet);
      const auto fragment = octree.fragment(cell, face);
      const double a = fragment.double_area() / 2;
      const RL::Vector_3& v = octree.surface().normal(face);
      const Eigen::Vector3d n(v.x(), v.y(), v.z());
      average += a * n * n.transpose();
      area += a;
      bool is_in_wall = false;
      for(int axis = 0; axis < 3; ++axis)
        for(int side = 0; side < 2; ++side) {
          bool is_in_this = true;
          for(std::size_t corner = 0; corner < fragment.size; ++corner)
            is_in_this =
                is_in_this && fragment.corners[corner].position[axis] == cell.index[axis] + side;
          walls[axis][side] = walls[axis][side] || is_in_this;
          is_in_wall = is_in_wall || is_in_this;
        }
      is_in_walls = is_in_walls && is_in_wall;
    }
    average /= area;
    const double size = (std::min)(1., area / 0.03);
    result.tiny += size < 1;
    const Eigen::Matrix3d tensor =
        size * (average + 0.1 * (1 - size) * Eigen::Matrix3d::Identity());
    using Rule = std::vector<std::pair<double, double>>; // nodes and weights
    const Rule gauss = {{0.5 - node, 5. / 18}, {0.5, 4. / 9}, {0.5 + node, 5. / 18}};
    std::vector<std::array<Rule, 3>> rules;
    if(is_in_walls) {
      for(int axis = 0; axis < 3; ++axis)
        for(int side = 0; side < 2; ++side)
          if(walls[axis][side]) {
            rules.push_back({gauss, gauss, gauss});
            rules.back()[axis] = {{side, 1}};
          }
    } else
      rules.push_back({gauss, gauss, gauss});
    result.in_walls += is_in_walls;
    result.in_several += is_in_walls && rules.size() > 1;
    const auto& elements = space.elements(depth, sheet);
    for(const auto& rule : rules)
      for(const auto& x : rule[0])
        for(const auto& y : rule[1])
          for(const auto& z : rule[2]) {
            const std::array<double, 3> t = {x.first, y.first, z.first};
            std::array<std::array<double, 3>, 3> b, d;
            for(int axis = 0; axis < 3; ++axis) {
              b[axis] = RL::B_spline_1::values(t[axis]);
              d[axis] = RL::B_spline_1::derivatives(t[axis]);
            }
            Eigen::Matrix<double, 3, 27> gradients;
            for(int e = 0; e < 27; ++e) {
              const int i = e % 3, j = e / 3 % 3, k = e / 9;
              gradients.col(e) << d[0][i] * b[1][j] * b[2][k], b[0][i] * d[1][j] * b[2][k],
                  b[0][i] * b[1][j] * d[2][k];
            }
            const double weight = h * x.second * y.second * z.second / rules.size();
            for(int i = 0; i < 27; ++i)
              for(int j = 0; j < 27; ++j)
                if(elements[i] != RL::Spline_space_3::no_element &&
                   elements[j] != RL::Spline_space_3::no_element)
                  result.matrix(elements[i], elements[j]) +=
                      weight * gradients.col(i).dot(tensor * gradients.col(j));
          }
  }
  return result;
}

} // namespace

TEST_CASE("stabilization_is_the_penalty_of_the_manual", "[operators]") {
  std::size_t tiny = 0, in_walls = 0, in_several = 0, others = 0;
  for(const auto& soup :
      {shapes::sphere(3), shapes::box(1, 1, 1, 4, 1), shapes::ragged_square(12, 0, 1)})
    for(bool is_split : {true, false}) {
      const Mesh mesh = shapes::mesh(soup);
      const RL::Spline_space_3 space(mesh, params::depth(3).cube_scale(8. / 6).split(is_split));
      const double c = 0.7, h = space.octree().cell_width(space.depth());
      const RL::Operators plain = RL::assemble_operators(space),
                          zero = RL::assemble_operators(space, space.depth(), 0),
                          stabilized = RL::assemble_operators(space, space.depth(), c);
      CHECK(relative_difference(zero.stiffness, plain.stiffness) == 0);
      CHECK(relative_difference(zero.mass, plain.mass) == 0);
      const Penalty p = penalty(space);
      const Eigen::MatrixXd of_stiffness = (h / c) * (stabilized.stiffness - plain.stiffness),
                            of_mass = (1 / (c * h)) * (stabilized.mass - plain.mass);
      const double largest = p.matrix.cwiseAbs().maxCoeff();
      CHECK((of_stiffness - p.matrix).cwiseAbs().maxCoeff() <= 1e-13 * largest);
      CHECK((of_mass - p.matrix).cwiseAbs().maxCoeff() <= 1e-13 * largest);
      tiny += p.tiny;
      in_walls += p.in_walls;
      in_several += p.in_several;
      others += space.octree().number_of_sheets(space.depth()) - p.in_walls;
    }
  CHECK(tiny >= 10);
  CHECK(in_walls >= 10);
  CHECK(in_several >= 10);
  CHECK(others >= 10);
}

TEST_CASE("stabilized_operators_keep_the_identities", "[operators]") {
  const int depth = 4;
  for(const Named_mesh& s : surfaces())
    for(bool is_split : {true, false}) {
      INFO(s.name << (is_split ? ", split" : ", unsplit"));
      const RL::Spline_space_3 space(s.mesh, params::depth(depth).split(is_split));
      const double c = 0.3;
      const std::vector<RL::Operators> all = RL::assemble_operators_of_levels(space, 0, depth, c);
      for(int level = 0; level <= depth; ++level) {
        INFO("level " << level);
        const RL::Operators& of_level = all[level];
        const Eigen::VectorXd ones = Eigen::VectorXd::Ones(space.dimension(level));
        CHECK((of_level.stiffness * ones).cwiseAbs().maxCoeff() <=
              1e-13 * of_level.stiffness.coeffs().maxCoeff());
        CHECK(ones.dot(of_level.mass * ones) == Approx(space.surface().area()).epsilon(1e-12));
        CHECK(relative_difference(RL::assemble_stiffness_matrix(space, level, c),
                                  of_level.stiffness) <= 1e-14);
        RL::internal::Elliptic_operator elliptic;
        elliptic.stabilization = c;
        const Eigen::VectorXd integrals = RL::assemble_element_integrals(space);
        if(level == depth)
          CHECK((RL::internal::assemble_system(space, level, elliptic).integrals - integrals)
                    .cwiseAbs()
                    .maxCoeff() <= 1e-13 * integrals.maxCoeff());
        for(const RL::Sparse_matrix* a : {&of_level.stiffness, &of_level.mass})
          CHECK(RL::Sparse_matrix(*a - RL::Sparse_matrix(a->transpose())).coeffs().isZero(0));
        if(level == depth)
          continue;
        const RL::Sparse_matrix p = RL::prolongation_matrix(space, level);
        CHECK(relative_difference(RL::galerkin_product(all[level + 1].stiffness, p),
                                  of_level.stiffness) <= 1e-12);
        CHECK(relative_difference(RL::galerkin_product(all[level + 1].mass, p), of_level.mass) <=
              1e-12);
        const RL::Operators direct = RL::assemble_operators(space, level, c);
        CHECK(relative_difference(direct.stiffness, of_level.stiffness) <= 1e-14);
        CHECK(relative_difference(direct.mass, of_level.mass) <= 1e-14);
      }
    }
}

TEST_CASE("stabilization_does_not_depend_on_the_unit_of_length", "[operators]") {
  const shapes::Triangles original = shapes::sphere(3);
  RL::Spline_space_options options;
  options.depth = 4;
  const auto assemble = [&options](const shapes::Triangles& t) {
    const RL::Spline_space_3 space(RL::Triangulated_surface_3(t.points, t.faces), options);
    return RL::assemble_operators(space, 4, 0.1);
  };
  const RL::Operators expected = assemble(original);
  for(double scale : {1e-6, 3e5}) {
    shapes::Triangles scaled = original;
    for(auto& p : scaled.points)
      p = {scale * p.x(), scale * p.y(), scale * p.z()};
    const RL::Operators operators = assemble(scaled);
    CHECK(relative_difference(operators.stiffness, expected.stiffness) <= 1e-12);
    CHECK(relative_difference(operators.mass / (scale * scale), expected.mass) <= 1e-12);
  }
}

TEST_CASE("stabilization_must_be_a_non_negative_number", "[operators]") {
  const Mesh mesh = shapes::mesh(shapes::sphere(1));
  const RL::Spline_space_3 space(mesh, params::depth(2));
  for(double c : {-1e-300, -1., std::nan(""), std::numeric_limits<double>::infinity()}) {
    CHECK_THROWS_AS(RL::assemble_operators(space, 2, c), RL::Parameter_error);
    CHECK_THROWS_AS(RL::assemble_stiffness_matrix(space, 2, c), RL::Parameter_error);
  }
}

TEST_CASE("stabilization_keeps_constants_where_the_surface_lies_in_walls", "[operators]") {
  // a flat rectangle is in the middle of its domain cube, which is a wall; a cube of side 10 / 11
  // of the domain cube has sides in walls at cube_scale 8 / 6
  for(const auto& soup : {shapes::rectangle(1, 0.7), shapes::box(1, 1, 1, 4, 1)}) {
    const Mesh mesh = shapes::mesh(soup);
    const RL::Spline_space_3 space(mesh, params::depth(4).cube_scale(8. / 6));
    std::size_t incomplete = 0;
    for(std::size_t sheet = 0; sheet < space.number_of_sheets(4); ++sheet)
      incomplete += !space.octree().meets_element(4, sheet, 0, 0, 1) ||
                    !space.octree().meets_element(4, sheet, 0, 0, -1);
    CHECK(incomplete > 0);
    const double c = 0.1;
    for(int level : {4, 3, 2}) {
      const RL::Operators o = RL::assemble_operators(space, level, c);
      const Eigen::VectorXd ones = Eigen::VectorXd::Ones(o.stiffness.cols());
      CHECK((o.stiffness * ones).cwiseAbs().maxCoeff() <= 1e-13);
      CHECK(ones.dot(o.mass * ones) == Approx(space.surface().area()));
    }
  }
}

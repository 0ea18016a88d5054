// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "point_shapes.h"
#include "shapes.h"
#include "special_shapes.h"

#include <CGAL/Restricted_laplacian_3/assembly/cotangent_operators.h>
#include <CGAL/Restricted_laplacian_3/assembly/shared/assemble_system.h>
#include <CGAL/Restricted_laplacian_3/input/read_surface.h>
#include <CGAL/Restricted_laplacian_3/integrate_gradient_field.h>
#include <CGAL/Restricted_laplacian_3/integration/Monte_carlo.h>
#include <CGAL/Restricted_laplacian_3/integration/Weighted_integration.h>
#include <CGAL/Restricted_laplacian_3/problems/internal/vertex_details.h>
#include <CGAL/Restricted_laplacian_3/solvers/galerkin_product.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_function_3.h>
#include <CGAL/Restricted_laplacian_3/splines/prolongation.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;
using shapes::Mesh;
using Jacobian = Eigen::Matrix3d;
constexpr double field_nan = std::numeric_limits<double>::quiet_NaN();

RL::Spline_space_3 gradient_space(const shapes::Triangles& t, int depth) {
  return RL::Spline_space_3(RL::soup(t.points, t.faces), params::depth(depth));
}

// three quadrics, which are in the space, and the gradients in space, each a column
Eigen::Vector3d quadrics(const RL::Point_3& p) {
  return {p.x() * p.y() - 2 * p.z(), p.z() * p.z() + p.x(), p.x() * p.x() - p.y() * p.z() + 3};
}
Jacobian gradients_of_quadrics(const RL::Point_3& p) {
  Jacobian result;
  result.col(0) << p.y(), p.x(), -2;
  result.col(1) << 1, 0, 2 * p.z();
  result.col(2) << 2 * p.x(), -p.z(), -p.y();
  return result;
}
// One type for all fields, targets and weights each, so that few functions are compiled.
using Field = std::function<Jacobian(const RL::Surface_point&)>;
using Single_field = std::function<RL::Vector_3(const RL::Surface_point&)>;
using Target = std::function<Eigen::Vector3d(const RL::Surface_point&)>;
using Weight = std::function<double(const RL::Surface_point&)>;

const Field quadric_field = [](const RL::Surface_point& p) {
  return gradients_of_quadrics(p.point);
};
const Target quadric_target = [](const RL::Surface_point& p) { return quadrics(p.point); };

/// largest difference of the values of splines at the vertices and functions of the points
template <class Function>
double largest_difference(const RL::Spline_space_3& space, const Eigen::MatrixXd& coefficients,
                          Function&& f) {
  const Eigen::MatrixXd values = RL::Spline_functions_3(space, coefficients).values_at_vertices();
  double result = 0;
  for(Eigen::Index i = 0; i < values.rows(); ++i)
    result = std::max(
        result, (values.row(i).transpose() - f(space.surface().point(static_cast<std::size_t>(i))))
                    .cwiseAbs()
                    .maxCoeff());
  return result;
}

double largest_coefficient(const RL::Sparse_matrix& a) { return a.coeffs().cwiseAbs().maxCoeff(); }
double largest_coefficient(const Eigen::MatrixXd& a) { return a.cwiseAbs().maxCoeff(); }

/// largest difference of the entries of two matrices over the largest entry
template <class Matrix> double matrix_difference(const Matrix& a, const Matrix& b) {
  return largest_coefficient(Matrix(a - b)) / largest_coefficient(a);
}

/// the mean of each column of coefficients with a weight
Eigen::RowVector3d weighted_mean(const RL::Spline_space_3& space,
                                 const Eigen::MatrixXd& coefficients, const Weight& w) {
  const Eigen::VectorXd integrals = RL::assemble_load(space, w);
  return integrals.transpose() * coefficients / integrals.sum();
}

/// with little stabilization and a small tolerance
constexpr double small_stabilization = 1e-8;
template <class Parameters> auto exact(double tolerance, const Parameters& np) {
  return np.stabilization(small_stabilization).tolerance(tolerance);
}

} // namespace

TEST_CASE("gradients_of_functions_in_the_space_are_integrated", "[gradient]") {
  for(const shapes::Triangles& t : {shapes::sphere(3), shapes::rectangle(2, 1)}) {
    const RL::Spline_space_3 space = gradient_space(t, 3);
    const RL::Gradient_fit fit = RL::integrate_gradient_field(
        space, quadric_field, exact(1e-9, params::target(quadric_target)));
    CHECK(fit.converged);
    CHECK(fit.relative_residual <= 1e-9);
    REQUIRE(fit.root_mean_square_residuals.size() == 3);
    for(double residual : fit.root_mean_square_residuals)
      CHECK(residual < 1e-4);
    CHECK(largest_difference(space, fit.coefficients, quadrics) < 1e-4);
  }
}

TEST_CASE("load_of_a_splines_gradient_is_stiffness_times_coefficients", "[gradient]") {
  const auto tensor = [](const RL::Surface_point& p) {
    return RL::Symmetric_tensor_3{2 + p.point.z(), 1, 1, 0.3, 0, 0.2};
  };
  for(const shapes::Triangles& t : {shapes::sphere(3), shapes::box(1, 0.7, 0.4, 3, 1)}) {
    const RL::Spline_space_3 space = gradient_space(t, 4);
    std::mt19937 generator(5);
    std::uniform_real_distribution<double> uniform(-1, 1);
    Eigen::VectorXd coefficients(static_cast<Eigen::Index>(space.dimension(4)));
    for(double& c : coefficients)
      c = uniform(generator);
    const RL::Spline_function_3 u(space, coefficients);
    const Single_field gradient = [&](const RL::Surface_point& p) { return u.gradient(p); };
    for(const RL::Spline_space_3& s :
        {space, space.integrated_by(RL::Diffusion_integration(space.integration(), tensor))}) {
      const Eigen::VectorXd expected = RL::assemble_stiffness_matrix(s) * coefficients;
      CHECK((RL::assemble_gradient_load(s, gradient) - expected).cwiseAbs().maxCoeff() <
            1e-12 * expected.cwiseAbs().maxCoeff());
    }
  }
}

TEST_CASE("fields_are_fitted_in_the_metric_of_the_integration", "[gradient]") {
  const RL::Spline_space_3 space = gradient_space(shapes::sphere(3), 3);
  const auto stretch = [](const RL::Surface_point& p) {
    return RL::Symmetric_tensor_3{2 + p.point.z(), 1, 1, 0.3, 0, 0.2};
  };
  const auto nine = [](const RL::Surface_point&) {
    return RL::Symmetric_tensor_3{9, 9, 9, 0, 0, 0};
  };
  const RL::Spline_space_3 stretched = space.integrated_by(
                               RL::Diffusion_integration(space.integration(), stretch)),
                           scaled = space.integrated_by(
                               RL::Diffusion_integration(space.integration(), nine));
  // gradients remain gradients
  const RL::Gradient_fit exact_fit = RL::integrate_gradient_field(
      stretched, quadric_field, exact(1e-9, params::target(quadric_target)));
  CHECK(largest_difference(space, exact_fit.coefficients, quadrics) < 1e-4);
  // a constant factor of the metric changes the residual by its root, and nothing else
  const Single_field rough = [](const RL::Surface_point& p) {
    return RL::Vector_3(p.point.y(), -p.point.x(), p.point.z() * p.point.x());
  };
  const RL::Gradient_fit plain =
      RL::integrate_gradient_field(space, rough, exact(1e-9, params::mean(0.)));
  const RL::Gradient_fit by_nine =
      RL::integrate_gradient_field(scaled, rough, exact(1e-9, params::mean(0.)));
  const auto values = [&](const RL::Gradient_fit& fit) {
    return RL::Spline_functions_3(space, fit.coefficients).values_at_vertices();
  };
  CHECK((values(plain) - values(by_nine)).cwiseAbs().maxCoeff() < 1e-5);
  CHECK(by_nine.root_mean_square_residuals[0] ==
        Approx(3 * plain.root_mean_square_residuals[0]).epsilon(1e-6));
}

TEST_CASE("the_part_of_a_field_that_is_no_gradient_is_ignored", "[gradient]") {
  const RL::Spline_space_3 space = gradient_space(shapes::sphere(3), 3);
  // n x grad w is orthogonal to all gradients on a closed surface, also on a polyhedron
  const auto swirling = [](const RL::Surface_point& p) {
    const RL::Vector_3 w(2 * p.point.x() + p.point.y(), p.point.x(), 1);
    const RL::Vector_3 curl = CGAL::cross_product(p.normal, w);
    return Eigen::Vector3d(curl.x(), curl.y(), curl.z());
  };
  const Eigen::MatrixXd loads = RL::assemble_gradient_loads(space, quadric_field);
  CHECK(RL::assemble_gradient_loads(space, swirling).cwiseAbs().maxCoeff() <
        1e-13 * loads.cwiseAbs().maxCoeff());
  // nor is a part along the normal seen
  const RL::Gradient_fit fit = RL::integrate_gradient_field(
      space,
      [&](const RL::Surface_point& p) {
        const Eigen::Vector3d n(p.normal.x(), p.normal.y(), p.normal.z());
        return Eigen::Vector3d(quadric_field(p).col(0) + swirling(p) + 7 * n);
      },
      exact(1e-9, params::target([](const RL::Surface_point& p) { return quadrics(p.point)[0]; })));
  CHECK(largest_difference(space, fit.coefficients, [](const RL::Point_3& p) {
          return Eigen::Matrix<double, 1, 1>(quadrics(p)[0]);
        }) < 1e-4);
  // what is left is the swirling part
  double square = 0;
  const double h = space.octree().cell_width(3);
  for(std::size_t sheet = 0; sheet < space.number_of_sheets(3); ++sheet)
    space.integration().visit_nodes(sheet, 12, [&](const RL::Integration_node_block& block) {
      for(std::size_t i = 0; i < block.size; ++i)
        square += h * h * block.weights[i] * swirling(block.points[i]).squaredNorm();
    });
  CHECK(fit.root_mean_square_residuals[0] ==
        Approx(std::sqrt(square / space.surface().area())).epsilon(1e-5));
}

TEST_CASE("channels_are_integrated_as_one_by_one", "[gradient]") {
  const RL::Spline_space_3 space = gradient_space(shapes::sphere(2), 3);
  const Single_field rough = [](const RL::Surface_point& p) {
    return CGAL::cross_product(p.normal, RL::Vector_3(1, 2, 3)) + RL::Vector_3(p.point.x(), 0, 1);
  };
  const Single_field other = [](const RL::Surface_point& p) {
    return RL::Vector_3(0, p.point.z(), 2);
  };
  const auto np = params::tolerance(1e-10);
  const RL::Gradient_fit both = RL::integrate_gradient_field(
      space,
      [&](const RL::Surface_point& p) {
        return std::array<RL::Vector_3, 2>{rough(p), other(p)};
      },
      np);
  const RL::Gradient_fit first = RL::integrate_gradient_field(space, rough, np),
                         second = RL::integrate_gradient_field(space, other, np);
  REQUIRE(both.coefficients.cols() == 2);
  REQUIRE(both.root_mean_square_residuals.size() == 2);
  CHECK(both.root_mean_square_residuals[0] == Approx(first.root_mean_square_residuals[0]));
  CHECK(both.root_mean_square_residuals[1] == Approx(second.root_mean_square_residuals[0]));
  const RL::Spline_functions_3 u(space, both.coefficients), a(space, first.coefficients),
      b(space, second.coefficients);
  CHECK((u.values_at_vertices().col(0) - a.values_at_vertices()).cwiseAbs().maxCoeff() < 1e-8);
  CHECK((u.values_at_vertices().col(1) - b.values_at_vertices()).cwiseAbs().maxCoeff() < 1e-8);
  // loads of coarser levels are sums of those of finer ones
  const Eigen::MatrixXd fine = RL::assemble_gradient_loads(space, rough);
  CHECK(matrix_difference<Eigen::MatrixXd>(RL::prolongation_matrix(space, 2).transpose() * fine,
                                           RL::assemble_gradient_loads(space, rough, 2)) < 1e-12);
}

TEST_CASE("fields_by_vertices_corners_and_faces_agree_with_function_objects", "[gradient]") {
  const shapes::Triangles t = shapes::sphere(2);
  Mesh mesh = shapes::mesh(t);
  const RL::Spline_space_3 space(mesh, params::depth(3));
  const auto by_vertex =
      mesh.add_property_map<Mesh::Vertex_index, Jacobian>("v", Jacobian::Zero()).first;
  const auto by_halfedge =
      mesh.add_property_map<Mesh::Halfedge_index, std::array<RL::Vector_3, 1>>("h").first;
  const auto by_face = mesh.add_property_map<Mesh::Face_index, RL::Vector_3>("f").first;
  for(const auto v : vertices(mesh))
    by_vertex[v] = gradients_of_quadrics(mesh.point(v));
  // differs from corner to corner and from face to face
  const auto at_corner = [&](std::size_t f, std::size_t v) {
    return RL::Vector_3(0.1 * static_cast<double>(f % 7), 0.2 * static_cast<double>(v % 5), 1);
  };
  for(const auto f : faces(mesh)) {
    by_face[f] = at_corner(f, 0);
    for(const auto h : halfedges_around_face(halfedge(f, mesh), mesh))
      by_halfedge[h] = {at_corner(f, target(h, mesh))};
  }
  const RL::internal::Mesh_source<Mesh> source(mesh);
  const auto field = [&](const auto& map) {
    return RL::internal::vector_field_on_surface(
        source, map,
        RL::internal::vertex_interpolation(source, space.surface(), params::default_values()));
  };
  const auto same_loads = [&](const auto& a, const auto& b) {
    return matrix_difference<Eigen::MatrixXd>(RL::assemble_gradient_loads(space, a),
                                              RL::assemble_gradient_loads(space, b)) < 1e-13;
  };
  // quadrics have linear gradients
  CHECK(same_loads(quadric_field, field(by_vertex)));
  CHECK(same_loads(field(by_halfedge), [&](const RL::Surface_point& p) {
    RL::Vector_3 sum(0, 0, 0);
    for(int i = 0; i < 3; ++i)
      sum += p.barycentric[i] * at_corner(p.face, p.vertices[i]);
    return sum;
  }));
  CHECK(
      same_loads(field(by_face), [&](const RL::Surface_point& p) { return at_corner(p.face, 0); }));
  std::vector<RL::Vector_3> corners;
  for(std::size_t f = 0; f < t.faces.size(); ++f)
    for(int i = 0; i < 3; ++i)
      corners.push_back(at_corner(f, space.surface().triangle(f)[i]));
  CHECK(same_loads(RL::Corner_vector_field<RL::Vector_3>(corners), field(by_halfedge)));

  // to the end, with means
  const auto u = mesh.add_property_map<Mesh::Vertex_index, std::array<float, 3>>("u", {}).first;
  const auto np = exact(1e-9, params::mean(Eigen::Vector3d(1, 2, 3)));
  const RL::Gradient_fit expected = RL::integrate_gradient_field(space, quadric_field, np);
  CHECK(weighted_mean(space, expected.coefficients, [](const RL::Surface_point&) {
          return 1.;
        }).isApprox(Eigen::RowVector3d(1, 2, 3), 1e-10));
  CHECK(RL::integrate_gradient_field(mesh, by_vertex, u, np.depth(3)).converged);
  const Eigen::MatrixXd values =
      RL::Spline_functions_3(space, expected.coefficients).values_at_vertices();
  for(const auto v : vertices(mesh))
    for(std::size_t k = 0; k < 3; ++k)
      CHECK(u[v][k] == Approx(values(v.idx(), static_cast<Eigen::Index>(k))).margin(1e-5));
}

TEST_CASE("weighted_systems_are_those_of_weighted_integration", "[gradient]") {
  const RL::Spline_space_3 space = gradient_space(shapes::sphere(2), 4);
  const Weight by_face = [](const RL::Surface_point& p) { return p.face % 3 * 0.7; };
  const Weight smooth = [](const RL::Surface_point& p) {
    return std::max(0., p.point.x() + p.point.z() * p.point.y());
  };
  const auto systems = [&](const RL::Spline_space_3& space, const Weight& w, int degree, double c) {
    const auto weight = RL::function_of_degree(w, degree);
    RL::internal::Elliptic_operator elliptic;
    elliptic.reaction_function = weight;
    elliptic.stabilization = c;
    return RL::internal::assemble_system(space, 2, elliptic);
  };
  const auto expected = [](const RL::Spline_space_3& space, const Weight& w) {
    const RL::Spline_space_3 weighted =
        space.integrated_by(RL::Weighted_integration(space.integration(), w));
    return RL::Sparse_matrix(RL::assemble_stiffness_matrix(space) +
                             RL::assemble_mass_matrix(weighted));
  };
  // fast and general path
  const auto fast = systems(space, by_face, 0, 0.1), general = systems(space, by_face, 6, 0.1),
             of_smooth = systems(space, smooth, 6, 0.1);
  // the stabilization has the weight too
  const auto one = systems(
      space, [](const RL::Surface_point&) { return 2.; }, 0, 0.1);
  RL::internal::Elliptic_operator with_number;
  with_number.reaction = 2;
  with_number.stabilization = 0.1;
  const auto of_number = RL::internal::assemble_system(space, 2, with_number);
  CHECK(matrix_difference(one.matrices.back(), of_number.matrices.back()) < 1e-14);
  CHECK(matrix_difference<Eigen::VectorXd>(one.integrals, of_number.integrals) < 1e-14);
  CHECK(matrix_difference<Eigen::VectorXd>(one.constant_loads, of_number.constant_loads) < 1e-14);
  CHECK(matrix_difference(fast.matrices.back(), general.matrices.back()) < 1e-14);
  for(const auto* system : {&fast, &of_smooth}) {
    RL::Sparse_matrix finer = system->matrices.back();
    for(int level = 3; level >= 2; --level) {
      RL::Sparse_matrix coarse = RL::galerkin_product(finer, RL::prolongation_matrix(space, level));
      const RL::Sparse_matrix& assembled = system->matrices[level - 2];
      CHECK(RL::Sparse_matrix(assembled - coarse).norm() < 1e-13 * assembled.norm());
      finer = assembled;
    }
    // what the matrix maps constants to
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(system->constant_loads.size());
    CHECK((system->matrices.back() * ones - system->constant_loads).cwiseAbs().maxCoeff() <
          1e-14 * system->matrices.back().coeffs().maxCoeff());
  }
  CHECK(std::abs(fast.constant_loads.sum() - RL::assemble_load(space, by_face).sum()) < 1e-12);
  const RL::Spline_space_3 sampled = space.integrated_by(RL::Monte_carlo(space.octree(), 2000, 1));
  for(const Weight& w : {by_face, smooth}) {
    const auto a = systems(space, w, 6, 0).matrices.back(), b = expected(space, w);
    CHECK(RL::Sparse_matrix(a - b).norm() < 1e-13 * a.norm());
    const auto c = systems(sampled, w, 0, 0).matrices.back(), d = expected(sampled, w);
    CHECK(RL::Sparse_matrix(c - d).norm() < 1e-13 * c.norm());
  }
}

TEST_CASE("means_are_those_of_the_targets_however_small_the_weight_is", "[gradient]") {
  const shapes::Triangles two =
      shapes::joined(shapes::sphere(2), shapes::moved(shapes::sphere(2), {4, 0, 0}));
  const RL::Spline_space_3 space = gradient_space(two, 4);
  const std::size_t half = two.faces.size() / 2;
  const double area = space.surface().area() / 2;
  const Target far_target = [&](const RL::Surface_point& p) {
    return Eigen::Vector3d(1e3 * quadrics(p.point) + Eigen::Vector3d(1e4, p.face < half, 0));
  };
  const Weight part_of_first = [half](const RL::Surface_point& p) {
    return p.face < half && p.face % 3 == 0 ? 1. : 0.;
  };
  for(double alpha : {1e-12, 1e-6, 1.}) {
    // large on the first sphere, and smaller on the other
    const Weight w = [&](const RL::Surface_point& p) {
      return p.face % 2 * (p.face < half ? alpha : 1e-3 * alpha) / area;
    };
    const RL::Gradient_fit fit = RL::integrate_gradient_field(
        space, quadric_field, params::alpha(RL::function_of_degree(w, 0)).target(far_target));
    CHECK(fit.converged);
    CHECK(fit.components_without_weight == 0);
    const Eigen::MatrixXd targets = RL::assemble_component_loads(
        space, [&](const RL::Surface_point& p) { return Eigen::Vector3d(w(p) * far_target(p)); },
        4);
    for(bool is_first : {true, false}) {
      const Weight here = [&](const RL::Surface_point& p) {
        return (p.face < half) == is_first ? w(p) : 0;
      };
      Eigen::RowVector3d expected = Eigen::RowVector3d::Zero();
      const Eigen::VectorXd loads = RL::assemble_load(space, here);
      for(Eigen::Index i = 0; i < loads.size(); ++i)
        if(loads[i] > 0)
          expected += targets.row(i) / loads.sum();
      const Eigen::RowVector3d mean = weighted_mean(space, fit.coefficients, here);
      CHECK((mean - expected).cwiseAbs().maxCoeff() < 1e-9 * expected.cwiseAbs().maxCoeff());
    }

    // nothing is known on the second sphere, and not read there
    const Weight nowhere_else = [&](const RL::Surface_point& p) {
      return alpha / area * part_of_first(p);
    };
    const Target known = [&](const RL::Surface_point& p) {
      return p.face < half && p.face % 3 == 0 ? Eigen::Vector3d(quadrics(p.point))
                                              : Eigen::Vector3d::Constant(field_nan);
    };
    const auto np =
        exact(1e-9, params::alpha(RL::function_of_degree(nowhere_else, 0)).target(known));
    const RL::Gradient_fit filled = RL::integrate_gradient_field(space, quadric_field, np);
    CHECK(filled.converged);
    CHECK(filled.components_without_weight == 1);
    const Eigen::RowVector3d of_targets = weighted_mean(space, filled.coefficients, nowhere_else);
    const Weight second = [half](const RL::Surface_point& p) { return p.face < half ? 0. : 1.; };
    CHECK((weighted_mean(space, filled.coefficients, second) - of_targets).norm() < 1e-9);
    // the rest of the first sphere is found by its gradients
    const Eigen::MatrixXd values =
        RL::Spline_functions_3(space, filled.coefficients).values_at_vertices();
    for(std::size_t v = 0; v < two.points.size() / 2; ++v)
      CHECK(
          (values.row(static_cast<Eigen::Index>(v)).transpose() - quadrics(two.points[v])).norm() <
          1e-4);
    const RL::Gradient_fit given =
        RL::integrate_gradient_field(space, quadric_field, np.mean(Eigen::Vector3d(5, 6, 7)));
    CHECK((weighted_mean(space, given.coefficients, second) - Eigen::RowVector3d(5, 6, 7)).norm() <
          1e-9);
    CHECK((weighted_mean(space, given.coefficients, nowhere_else) - of_targets).norm() < 1e-6);
  }
}

TEST_CASE("large_weights_give_the_targets", "[gradient]") {
  const RL::Spline_space_3 space = gradient_space(shapes::sphere(3), 3);
  const Field nothing = [](const RL::Surface_point&) { return Jacobian(Jacobian::Zero()); };
  const auto np = params::target(quadric_target);
  for(double alpha : {1e4, 1e8}) {
    const RL::Gradient_fit number =
        RL::integrate_gradient_field(space, nothing, exact(1e-10, np.alpha(alpha)));
    const Weight w = [alpha](const RL::Surface_point&) { return alpha; };
    const RL::Gradient_fit function = RL::integrate_gradient_field(
        space, nothing, exact(1e-10, np.alpha(RL::function_of_degree(w, 0))));
    CHECK(number.converged);
    CHECK(function.converged);
    CHECK(largest_difference(space, number.coefficients, quadrics) < 100 / alpha + 1e-4);
    CHECK(largest_difference(space, function.coefficients - number.coefficients,
                             [](const RL::Point_3&) { return Eigen::Vector3d(0, 0, 0); }) < 1e-4);
  }
  // without a target, the mean pulls
  const RL::Gradient_fit flat = RL::integrate_gradient_field(
      space, quadric_field, params::alpha(1e8).mean(Eigen::Vector3d(1, 2, 3)));
  CHECK(largest_difference(space, flat.coefficients,
                           [](const RL::Point_3&) { return Eigen::Vector3d(1, 2, 3); }) < 1e-5);
}

TEST_CASE("vertex_details_make_functions_exact_that_are_linear_in_each_triangle", "[gradient]") {
  // needles, faces of area zero, a vertex that no face uses, two components
  shapes::Triangles t =
      shapes::joined(shapes::box(1, 0.8, 0.7, 5, 3), shapes::moved(shapes::sphere(2), {4, 0, 0}));
  const auto f = t.faces.front();
  const RL::Point_3 near_side =
      CGAL::midpoint(t.points[f[0]], t.points[f[1]]) + 1e-9 * (t.points[f[2]] - t.points[f[0]]);
  const auto tip = static_cast<std::uint32_t>(t.points.size());
  t.points.push_back(near_side);
  t.faces.push_back({f[0], f[1], tip});
  t.faces.push_back({f[0], f[0], f[1]});
  t.points.emplace_back(field_nan, 0, 0);
  std::vector<std::array<double, 2>> values, result(t.points.size(), {0, 0});
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> random(0, 1);
  for(std::size_t i = 0; i < t.points.size(); ++i)
    values.push_back({random(generator), 1e3 + random(generator)});
  values[tip] = {(values[f[0]][0] + values[f[1]][0]) / 2, (values[f[0]][1] + values[f[1]][1]) / 2};
  const auto g = CGAL::make_property_map(values);
  const auto u = CGAL::make_property_map(result);
  const auto largest_error = [&] {
    double error = 0;
    for(std::size_t i = 0; i + 1 < values.size(); ++i)
      for(int k = 0; k < 2; ++k)
        error = std::max(error, std::abs(result[i][k] - values[i][k]));
    return error;
  };
  const auto gradients = RL::vertex_gradients(RL::soup(t.points, t.faces), g);
  const auto np = params::depth(4).target(g).tolerance(1e-9);
  RL::integrate_gradient_field(RL::soup(t.points, t.faces), gradients, u, np);
  CHECK(largest_error() > 0.1);
  const auto check = [&](const auto& with_details) {
    const RL::Gradient_report report =
        RL::integrate_gradient_field(RL::soup(t.points, t.faces), gradients, u, with_details);
    CHECK(report.converged);
    CHECK(report.details_iterations > 0);
    CHECK(largest_error() < 1e-6);
    CHECK(std::isnan(result.back()[0]));
  };
  check(np.details(true));
  for(double alpha : {1e-12, 1., 1e6})
    check(np.alpha(alpha).details(true));
  std::vector<double> of_faces;
  for(std::size_t i = 0; i < t.faces.size(); ++i)
    of_faces.push_back(i % 3 == 0 ? 0 : 1e-9 * static_cast<double>(i));
  check(np.alpha(RL::Face_function<double>(of_faces)).details(true));
}

TEST_CASE("details_solve_the_cotangent_system", "[gradient]") {
  const shapes::Triangles t = shapes::sphere(2);
  const RL::Triangulated_surface_3 surface = RL::read_surface(RL::soup(t.points, t.faces));
  const auto field = [](const RL::Surface_point& p) { return RL::Vector_3(1 + p.point.y(), 1, 2); };
  std::vector<double> targets;
  const auto system = RL::internal::vertex_system(
      surface, field,
      [&](const RL::Surface_point* points, std::size_t number) {
        targets.clear();
        for(std::size_t i = 0; i < number; ++i)
          targets.push_back(points[i].point.x());
      },
      [](std::size_t) { return 0.7; }, [&](std::size_t i) { return targets.data() + i; }, 12);
  const RL::Operators o = RL::cotangent_operators(surface);
  CHECK(matrix_difference<RL::Sparse_matrix>(system.matrix, o.stiffness + 0.7 * o.mass) < 1e-13);
  Eigen::VectorXd x(surface.number_of_vertices());
  for(std::size_t i = 0; i < t.points.size(); ++i)
    x[static_cast<Eigen::Index>(i)] = t.points[i].x();
  // <v, grad phi> sums to 0, and v . grad x = v_x on a plane face up to the normal part
  CHECK(std::abs((system.loads - 0.7 * o.mass * x).sum()) < 1e-12);
  double expected = 0;
  for(std::size_t f = 0; f < t.faces.size(); ++f) {
    const RL::Vector_3 n = surface.normal(f);
    const RL::Point_3 c =
        CGAL::centroid(surface.point(f, 0), surface.point(f, 1), surface.point(f, 2));
    const RL::Vector_3 v(1 + c.y(), 1, 2);
    expected += surface.area(f) * (v.x() - (v * n) * n.x());
  }
  CHECK(x.dot(system.loads.col(0) - 0.7 * o.mass * x) == Approx(expected).epsilon(1e-12));
  // also from values that a spline does not have
  Eigen::MatrixXd u = Eigen::MatrixXd::Zero(x.size(), 1);
  u(3, 0) = field_nan;
  const auto report = RL::internal::add_vertex_details(system, 1e-10, 200, u);
  CHECK(report.status == RL::Solve_status::converged);
  CHECK((system.matrix * u - system.loads).norm() < 1e-9 * system.loads.norm());
}

TEST_CASE("gradients_on_point_sets_are_integrated", "[gradient]") {
  const auto range = shapes::sphere_points(2000);
  std::vector<double> u(range.size());
  const auto np =
      params::depth(3)
          .point_map(CGAL::First_of_pair_property_map<std::pair<RL::Point_3, RL::Vector_3>>())
          .normal_map(CGAL::Second_of_pair_property_map<std::pair<RL::Point_3, RL::Vector_3>>());
  const Single_field field = [](const RL::Surface_point&) { return RL::Vector_3(1, -2, 0); };
  const RL::Gradient_report report =
      RL::integrate_gradient_field(range, field, CGAL::make_property_map(u), np);
  CHECK(report.converged);
  for(std::size_t i = 0; i < u.size(); ++i)
    CHECK(u[i] == Approx(range[i].first.x() - 2 * range[i].first.y()).margin(0.02));
  CHECK_THROWS_AS(
      RL::integrate_gradient_field(range, field, CGAL::make_property_map(u), np.details(true)),
      RL::Input_error);
}

TEST_CASE("gradients_are_integrated_the_same_on_any_number_of_threads", "[gradient][threads]") {
  const shapes::Triangles t = shapes::sphere(4);
  const auto solve = [&](const auto& tag) {
    const RL::Spline_space_3 space(RL::soup(t.points, t.faces),
                                   params::depth(5).concurrency_tag(tag));
    const Weight w = [](const RL::Surface_point& p) { return p.face % 2; };
    return RL::integrate_gradient_field(
        space, quadric_field,
        params::alpha(RL::function_of_degree(w, 0)).target(quadric_target).concurrency_tag(tag));
  };
  const RL::Gradient_fit one = solve(CGAL::Sequential_tag()),
                         several = solve(CGAL::Parallel_if_available_tag());
  CHECK(one.coefficients == several.coefficients);
  CHECK(one.root_mean_square_residuals == several.root_mean_square_residuals);
}

TEST_CASE("gradients_are_integrated_at_any_scale", "[gradient]") {
  const shapes::Triangles sphere = shapes::sphere(1);
  const auto integrated = [&](double length, double value) {
    const shapes::Triangles t = shapes::scaled(sphere, length);
    std::vector<double> g, u(t.points.size());
    for(const RL::Point_3& p : sphere.points)
      g.push_back(value * std::exp(p.x() - 2 * p.y()));
    const auto map = CGAL::make_property_map(g);
    CHECK(RL::integrate_gradient_field(
              RL::soup(t.points, t.faces), RL::vertex_gradients(RL::soup(t.points, t.faces), map),
              CGAL::make_property_map(u),
              params::depth(2).details(true).target(map).tolerance(1e-8).alpha(1e-3 / length /
                                                                               length))
              .converged);
    double error = 0;
    for(std::size_t i = 0; i < u.size(); ++i)
      error = std::max(error, std::abs(u[i] - g[i]) / value);
    return error;
  };
  for(double length : {1e-60, 1., 1e60})
    for(double value : {1e-120, 1., 1e120})
      CHECK(integrated(length, value) < 1e-5);
}

TEST_CASE("bad_input_of_gradient_fields_is_refused", "[gradient]") {
  const shapes::Triangles t = shapes::sphere(1);
  const RL::Spline_space_3 space = gradient_space(t, 2);
  const Single_field bad_field = [](const RL::Surface_point& p) {
    return RL::Vector_3(p.face == 5 ? field_nan : 1, 0, 0);
  };
  CHECK_THROWS_WITH(RL::integrate_gradient_field(space, bad_field), Catch::Contains("face 5"));
  const auto refused = [&](const auto& np, const char* text) {
    CHECK_THROWS_AS(RL::integrate_gradient_field(space, quadric_field, np), RL::Parameter_error);
    CHECK_THROWS_WITH(RL::integrate_gradient_field(space, quadric_field, np),
                      Catch::Contains(text));
  };
  for(double bad : {-1., 0., field_nan, std::numeric_limits<double>::infinity()})
    refused(params::alpha(bad), "alpha");
  for(int degree : {0, 6})
    for(double bad : {-1., field_nan}) {
      const Weight w = [bad](const RL::Surface_point& p) { return p.face == 3 ? bad : 1.; };
      refused(params::alpha(RL::function_of_degree(w, degree)), "face 3");
    }
  refused(params::mean(Eigen::Vector3d(0, field_nan, 0)), "mean");
  const Target bad_target = [](const RL::Surface_point& p) {
    return Eigen::Vector3d(0, 0, p.face == 7 ? field_nan : 0.);
  };
  refused(params::target(bad_target), "face 7");
  refused(params::stabilization(-1.), "stabilization");
  refused(params::tolerance(0.), "tolerance");
  std::vector<double> u(3, -1.);
  const Single_field one = [](const RL::Surface_point&) { return RL::Vector_3(1, 0, 0); };
  const auto solve = [&](const std::vector<RL::Point_3>& points,
                         const std::vector<std::array<int, 3>>& faces) {
    return RL::integrate_gradient_field(RL::soup(points, faces), one, CGAL::make_property_map(u),
                                        params::depth(3).details(true));
  };
  CHECK_THROWS_AS(solve({}, {}), RL::Empty_surface_error);
  CHECK_THROWS_AS(solve({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}}), RL::Zero_area_error);
  CHECK_THROWS_AS(solve({{0, 0, 0}, {1, 1, field_nan}, {2, 0, 2}}, {{0, 1, 2}}),
                  RL::Invalid_vertex_error);
  // one triangle
  CHECK(solve({{0, 0, 0}, {1, 0, 0}, {0, 2, 0}}, {{0, 1, 2}}).converged);
  CHECK(u[1] - u[0] == Approx(1).epsilon(1e-3));
  CHECK(u[2] - u[0] == Approx(0).margin(1e-3));
  CHECK(u[0] + u[1] + u[2] == Approx(0).margin(1e-3));
}

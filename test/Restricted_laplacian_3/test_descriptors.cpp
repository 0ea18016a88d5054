// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Values of many functions at once, and what is computed from eigenvalues and eigenfunctions: heat
// and wave kernel signatures, ShapeDNA, embeddings.

#include "catch.h"
#include "special_shapes.h"

#include <CGAL/Restricted_laplacian_3/input/read_surface.h>
#include <CGAL/Restricted_laplacian_3/integration/cubature.h>
#include <CGAL/Restricted_laplacian_3/laplace_spectrum.h>
#include <CGAL/Restricted_laplacian_3/spectral_descriptors.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_function_3.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_functions_3.h>
#include <CGAL/Restricted_laplacian_3/surface/sample_surface.h>

#include <Eigen/Geometry>
#include <Eigen/QR>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;

constexpr double descriptor_pi = 3.14159265358979323846;

Eigen::MatrixXd random_matrix(std::size_t rows, Eigen::Index columns) {
  std::srand(7);
  return Eigen::MatrixXd::Random(static_cast<Eigen::Index>(rows), columns);
}

double largest_entry(const Eigen::MatrixXd& a) { return a.cwiseAbs().maxCoeff(); }

/// nodes and weights that integrate products of two functions of a space exactly
struct Surface_nodes {
  explicit Surface_nodes(const RL::Spline_space_3& space) {
    const double h = space.octree().cell_width(space.depth());
    for(std::size_t sheet = 0; sheet < space.number_of_sheets(space.depth()); ++sheet)
      space.integration().visit_nodes(sheet, 12, [&](const RL::Integration_node_block& block) {
        for(std::size_t i = 0; i < block.size; ++i) {
          locations.push_back(block.points[i]);
          weights.push_back(block.weights[i] * h * h);
        }
      });
  }
  /// the integrals of functions, given by their values at the nodes, one column for each
  Eigen::VectorXd integrals(const Eigen::MatrixXd& values) const {
    return values.transpose() * Eigen::Map<const Eigen::VectorXd>(
                                    weights.data(), static_cast<Eigen::Index>(weights.size()));
  }
  std::vector<RL::Surface_location> locations;
  std::vector<double> weights;
};

/// a surface without symmetry, its spectrum, and the eigenfunctions at its nodes
struct Example {
  Example()
    : space(shapes::mesh(shapes::box(1, 0.8, 0.5, 4, 1)), params::depth(3)),
      spectrum(RL::laplace_spectrum(space, 20)), nodes(space),
      values(RL::Spline_functions_3(space, spectrum.pairs.vectors)
                 .values_at_locations(nodes.locations)) {}
  RL::Spline_space_3 space;
  RL::Laplace_spectrum spectrum;
  Surface_nodes nodes;
  Eigen::MatrixXd values;
};

/// the unit sphere with all eigenfunctions of degree 0 .. 6
RL::Laplace_spectrum spectrum_of_sphere() {
  return RL::laplace_spectrum(shapes::mesh(shapes::sphere(5)), 49, params::depth(4));
}

/// squared distance of two rows
double squared_distance(const Eigen::MatrixXd& rows, Eigen::Index i, Eigen::Index j) {
  return (rows.row(i) - rows.row(j)).squaredNorm();
}

/// name of the parameter that the call refuses
template <class Call> std::string refused_by(Call&& call) {
  try {
    call();
  } catch(const RL::Parameter_error& e) {
    return e.parameter();
  }
  return "nothing";
}

} // namespace

TEST_CASE("many_functions_have_the_values_of_each_of_them", "[descriptors][threads]") {
  shapes::Triangles t = shapes::sphere(3);
  t.points.push_back({0.3, 0.2, 0.1}); // without a face
  t.points.push_back({1, 0, 0});
  const auto last = static_cast<std::uint32_t>(t.points.size()) - 1;
  t.faces.push_back({0, last, 0}); // the only face of that vertex has no area
  // a vertex whose first face has no area
  t.faces.insert(t.faces.begin(), {t.faces[0][0], t.faces[0][0], t.faces[0][1]});
  RL::Spline_space_options options;
  options.depth = 4;
  for(bool is_parallel : {false, true}) {
    options.is_parallel = is_parallel;
    const RL::Spline_space_3 space(RL::read_surface(RL::soup(t.points, t.faces)), options);
    const auto locations = RL::sample_surface(space.surface(), 1000, 3);
    for(int level : {2, 4}) {
      const Eigen::MatrixXd coefficients = random_matrix(space.dimension(level), 5);
      const RL::Spline_functions_3 functions(space, coefficients, level);
      CHECK(functions.number_of_functions() == 5);
      CHECK(functions.level() == level);
      const Eigen::MatrixXd at_vertices = functions.values_at_vertices(),
                            at_locations = functions.values_at_locations(locations);
      REQUIRE(at_vertices.rows() == last + 1);
      REQUIRE(at_locations.rows() == 1000);
      for(Eigen::Index k = 0; k < 5; ++k) {
        const RL::Spline_function_3 u(space, coefficients.col(k), level);
        const std::vector<double> values = u.values_at_vertices();
        CHECK(std::isnan(values[last]));
        CHECK(std::isnan(values[last - 1]));
        for(std::size_t v = 0; v < values.size(); ++v) {
          const double value = at_vertices(static_cast<Eigen::Index>(v), k);
          REQUIRE((v + 1 < last ? value == values[v] : std::isnan(value)));
        }
        for(std::size_t i = 0; i < locations.size(); ++i)
          REQUIRE(at_locations(static_cast<Eigen::Index>(i), k) == u.value(locations[i]));
      }
    }
  }
}

TEST_CASE("values_of_functions_at_vertices_are_those_at_their_locations", "[descriptors]") {
  const RL::Spline_space_3 space(shapes::mesh(shapes::sphere(3)), params::depth(4));
  const RL::Triangulated_surface_3& surface = space.surface();
  const RL::Spline_function_3 u(space, random_matrix(space.dimension(), 1));
  const std::vector<double> values = u.values_at_vertices();
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
    for(int corner = 0; corner < 3; ++corner) {
      RL::Surface_location location;
      location.face = f;
      location.barycentric = {0, 0, 0};
      location.barycentric[corner] = 1;
      REQUIRE(values[surface.triangle(f)[corner]] == Approx(u.value(location)).margin(1e-13));
    }
}

TEST_CASE("a_vertex_whose_first_face_is_lost_has_the_value_of_another", "[descriptors]") {
  // pairs of a needle and a triangle at its tip
  std::mt19937 generator(1);
  const auto random = [&generator] { return double(generator() % 100000) / 100000; };
  shapes::Triangles t;
  for(std::uint32_t i = 0; i < 2000; ++i) {
    const RL::Point_3 tip(random(), random(), random()), end(random(), random(), random());
    t.points.insert(t.points.end(), {tip, end, end + RL::Vector_3(0, 0, 3e-15 * (i % 50)),
                                     tip + RL::Vector_3(0.01, 0, 0.01 * random()),
                                     tip + RL::Vector_3(0, 0.01, 0.01 * random())});
    t.faces.push_back({5 * i, 5 * i + 1, 5 * i + 2});
    t.faces.push_back({5 * i, 5 * i + 3, 5 * i + 4});
  }
  const RL::Spline_space_3 space(RL::soup(t.points, t.faces), params::depth(4));
  const Eigen::MatrixXd coefficients = random_matrix(space.dimension(), 2);
  const Eigen::MatrixXd values = RL::Spline_functions_3(space, coefficients).values_at_vertices();
  const RL::Spline_function_3 u(space, coefficients.col(1));
  const std::size_t not_on_surface = space.number_of_sheets(4);
  int number_of_lost = 0;
  for(Eigen::Index i = 0; i < 2000; ++i) {
    RL::Surface_location location; // the tip
    location.face = static_cast<std::size_t>(2 * i);
    if(space.surface().is_degenerate(location.face) ||
       space.octree().locate(4, t.points[static_cast<std::size_t>(5 * i)], location.face).first !=
           not_on_surface)
      continue;
    ++number_of_lost;
    ++location.face;
    REQUIRE(values(5 * i, 1) == u.value(location));
  }
  CHECK(number_of_lost > 0);
}

TEST_CASE("a_vertex_whose_only_face_is_lost_has_the_value_of_a_neighbor", "[descriptors]") {
  // a needle along a side of a triangle, within the tolerance of the wall of the domain that both
  // touch, and one that leads away from there
  const RL::Point_3 a(1, 0, 0), b(1, 1, 0), near_b(1 + 8e-15, 1, 0), c(0, 0, 1), far(1, 0.5, 1);
  const std::vector<RL::Point_3> points = {a, b, near_b, c, far};
  const std::vector<std::array<std::uint32_t, 3>> faces = {{0, 1, 3}, {0, 2, 1}, {1, 2, 4}};
  const RL::Spline_space_3 space(RL::soup(points, faces), params::depth(3).cube_scale(1));
  for(std::size_t sheet = 0; sheet < space.number_of_sheets(3); ++sheet)
    for(std::uint32_t face : space.octree().faces(sheet))
      REQUIRE(face == 0);
  CHECK_FALSE(space.surface().is_degenerate(1));
  CHECK_FALSE(space.surface().is_degenerate(2));
  const Eigen::MatrixXd values =
      RL::Spline_functions_3(space, random_matrix(space.dimension(), 1)).values_at_vertices();
  CHECK(std::isfinite(values(1, 0)));
  CHECK(values(2, 0) == Approx(values(1, 0)));
  CHECK(std::isnan(values(4, 0))); // no surface near
}

TEST_CASE("bad_input_of_many_functions", "[descriptors][input]") {
  const RL::Spline_space_3 space(shapes::mesh(shapes::sphere(2)), params::depth(2));
  const Eigen::MatrixXd coefficients = random_matrix(space.dimension(), 2);
  CHECK(refused_by([&] { RL::Spline_functions_3(space, coefficients.topRows(5)); }) ==
        "coefficients");
  for(int level : {-1, 3})
    CHECK(refused_by([&] { RL::Spline_functions_3(space, coefficients, level); }) == "level");
  const RL::Spline_functions_3 functions(space, coefficients);
  std::vector<RL::Surface_location> locations(3);
  locations[1].face = space.surface().number_of_faces();
  CHECK_THROWS_AS(functions.values_at_locations(locations), RL::Location_error);
  locations[1].face = 0;
  locations[1].barycentric = {3, -2, 0};
  CHECK_THROWS_AS(functions.values_at_locations(locations), RL::Location_error);
  CHECK(functions.values_at_locations(std::vector<RL::Surface_location>()).rows() == 0);
  CHECK(RL::Spline_functions_3(space, Eigen::MatrixXd(coefficients.rows(), 0))
            .values_at_vertices()
            .cols() == 0);
}

TEST_CASE("heat_kernel_signature_of_the_sphere", "[descriptors]") {
  const RL::Laplace_spectrum spectrum = spectrum_of_sphere();
  const Eigen::Vector3d times(0.1, 0.3, 1);
  const Eigen::MatrixXd hks = RL::heat_kernel_signature(spectrum, times);
  REQUIRE(hks.rows() == spectrum.vertex_values.rows());
  REQUIRE(hks.cols() == 3);
  for(Eigen::Index j = 0; j < 3; ++j) {
    double exact = 0;
    for(int l = 0; l <= 6; ++l)
      exact += (2 * l + 1) / (4 * descriptor_pi) * std::exp(-l * (l + 1) * times[j]);
    CHECK(hks.col(j).maxCoeff() == Approx(exact).epsilon(4e-3));
    CHECK(hks.col(j).minCoeff() == Approx(exact).epsilon(4e-3));
    CHECK(RL::heat_trace(spectrum.eigenvalues, times)[j] ==
          Approx(4 * descriptor_pi * exact).epsilon(1e-3));
  }
  // the sum of complete multiplets is constant for any weights
  const Eigen::MatrixXd wks =
      RL::wave_kernel_signature(spectrum, RL::wave_kernel_energies(spectrum, 10));
  CHECK(wks.maxCoeff() == Approx(1 / (4 * descriptor_pi)).epsilon(8e-3));
  CHECK(wks.minCoeff() == Approx(1 / (4 * descriptor_pi)).epsilon(8e-3));
}

TEST_CASE("signatures_integrate_to_their_trace", "[descriptors]") {
  const Example e;
  const Eigen::VectorXd times = RL::heat_kernel_times(e.spectrum, 7);
  const Eigen::VectorXd trace = RL::heat_trace(e.spectrum.eigenvalues, times);
  for(Eigen::Index j = 0; j < 7; ++j) {
    double sum = 0;
    for(double lambda : e.spectrum.eigenvalues)
      sum += std::exp(-lambda * times[j]);
    CHECK(trace[j] == Approx(sum));
  }
  const Eigen::VectorXd& lambda = e.spectrum.eigenvalues;
  const Eigen::VectorXd hks = e.nodes.integrals(RL::heat_kernel_signature(lambda, e.values, times));
  CHECK(largest_entry(hks.cwiseQuotient(trace) - Eigen::VectorXd::Ones(7)) <= 1e-8);
  const Eigen::VectorXd scaled = e.nodes.integrals(
      RL::heat_kernel_signature(lambda, e.values, times, RL::Heat_kernel_scaling::heat_trace));
  CHECK(largest_entry(scaled - Eigen::VectorXd::Ones(7)) <= 1e-8);
  const Eigen::VectorXd wks = e.nodes.integrals(
      RL::wave_kernel_signature(lambda, e.values, RL::wave_kernel_energies(lambda, 7)));
  CHECK(largest_entry(wks - Eigen::VectorXd::Ones(7)) <= 1e-8);
}

TEST_CASE("heat_kernel_times_are_those_of_the_paper", "[descriptors]") {
  const Eigen::Vector4d lambda(0, 0.5, 3, 50);
  const Eigen::VectorXd times = RL::heat_kernel_times(lambda, 5);
  REQUIRE(times.size() == 5);
  CHECK(times[0] == Approx(4 * std::log(10.) / 50));
  CHECK(times[4] == Approx(4 * std::log(10.) / 0.5));
  for(int i = 0; i < 4; ++i)
    CHECK(times[i + 1] / times[i] == Approx(std::sqrt(10.)));
  CHECK(RL::heat_kernel_times(lambda).size() == 100);
}

TEST_CASE("wave_kernel_energies_are_those_of_the_paper", "[descriptors]") {
  const Eigen::Vector4d lambda(0, 0.5, 3, 50);
  for(int number : {2, 10, 100}) {
    const RL::Wave_kernel_energies e = RL::wave_kernel_energies(lambda, number);
    REQUIRE(e.energies.size() == number);
    CHECK(e.energies[0] == Approx(std::log(0.5) + 2 * e.sigma));
    CHECK(e.energies[number - 1] == Approx(std::log(50.) - 2 * e.sigma));
    for(int i = 1; i < number; ++i)
      CHECK(e.energies[i] - e.energies[i - 1] == Approx(e.sigma / 7));
  }
  const RL::Wave_kernel_energies one = RL::wave_kernel_energies(lambda, 1);
  CHECK(one.energies[0] == Approx(std::log(5.)));
}

TEST_CASE("wave_kernel_signature_by_hand", "[descriptors]") {
  const Eigen::Vector3d lambda(0, 2, 5);
  Eigen::MatrixXd values(2, 3);
  values << 7, 1, 2, 7, -3, 0.5;
  RL::Wave_kernel_energies e;
  e.sigma = 0.4;
  e.energies = Eigen::Vector3d(1, -1000, 1000);
  const Eigen::MatrixXd wks = RL::wave_kernel_signature(lambda, values, e);
  const double a = std::exp(-std::pow(1 - std::log(2.), 2) / 0.32),
               b = std::exp(-std::pow(1 - std::log(5.), 2) / 0.32);
  CHECK(wks(0, 0) == Approx((a * 1 + b * 4) / (a + b)));
  CHECK(wks(1, 0) == Approx((a * 9 + b * 0.25) / (a + b)));
  // far outside the nearest eigenvalue is left
  CHECK(wks(0, 1) == Approx(1));
  CHECK(wks(0, 2) == Approx(4));
}

TEST_CASE("signatures_do_not_depend_on_signs_and_bases", "[descriptors]") {
  // eigenvalues with the multiplicities 1, 3, 2, 1
  Eigen::VectorXd lambda(7);
  lambda << 0, 1, 1, 1, 2.5, 2.5, 4;
  const Eigen::MatrixXd values = random_matrix(30, 7);
  Eigen::MatrixXd other = values;
  Eigen::Index first = 0;
  for(Eigen::Index size : {1, 3, 2, 1}) {
    const Eigen::MatrixXd q =
        Eigen::HouseholderQR<Eigen::MatrixXd>(random_matrix(static_cast<std::size_t>(size), size))
            .householderQ();
    other.middleCols(first, size) = -values.middleCols(first, size) * q;
    first += size;
  }
  REQUIRE(largest_entry(other - values) > 0.1);
  const Eigen::VectorXd times = RL::heat_kernel_times(lambda, 5);
  CHECK(largest_entry(RL::heat_kernel_signature(lambda, values, times) -
                      RL::heat_kernel_signature(lambda, other, times)) <= 1e-13);
  const RL::Wave_kernel_energies energies = RL::wave_kernel_energies(lambda, 5);
  CHECK(largest_entry(RL::wave_kernel_signature(lambda, values, energies) -
                      RL::wave_kernel_signature(lambda, other, energies)) <= 1e-13);
  const auto check_distances = [&](auto&& embedding) {
    const Eigen::MatrixXd a = embedding(values), b = embedding(other);
    for(Eigen::Index i = 1; i < 30; ++i)
      CHECK(squared_distance(a, 0, i) == Approx(squared_distance(b, 0, i)));
  };
  check_distances([&](const auto& v) { return RL::global_point_signature(lambda, v); });
  check_distances([&](const auto& v) { return RL::biharmonic_embedding(lambda, v); });
  check_distances([&](const auto& v) { return RL::diffusion_map(lambda, v, 0.2); });
}

TEST_CASE("shape_dna_does_not_depend_on_size_and_position", "[descriptors]") {
  const shapes::Triangles shape = shapes::box(1, 0.7, 0.6, 4, 1);
  shapes::Triangles turned = shape;
  for(RL::Point_3& p :
      turned.points) { // about an axis in general position, and seven times as large
    const Eigen::Matrix3d m =
        7 * Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    const Eigen::Vector3d q = m * Eigen::Vector3d(p.x(), p.y(), p.z());
    p = RL::Point_3(q[0] + 20, q[1], q[2] - 5);
  }
  const auto spectrum_of = [](const shapes::Triangles& t) {
    return RL::laplace_spectrum(shapes::mesh(t), 12, params::depth(4));
  };
  using Normalization = RL::Shape_dna_normalization;
  const RL::Laplace_spectrum a = spectrum_of(shape), b = spectrum_of(shapes::scaled(shape, 7)),
                             c = spectrum_of(turned);
  CHECK(a.area == Approx(2 * (0.7 + 0.6 + 0.42)));
  CHECK(b.area == Approx(49 * a.area));
  for(Normalization n :
      {Normalization::area, Normalization::first_eigenvalue, Normalization::weyl_slope}) {
    const Eigen::VectorXd of_a = RL::shape_dna(a, n);
    CHECK(of_a[0] == 0);
    CHECK(RL::shape_dna_distance(of_a, RL::shape_dna(b, n)) <= 1e-7 * of_a.norm());
    CHECK(RL::shape_dna_distance(of_a, RL::shape_dna(c, n)) <= 2e-3 * of_a.norm());
    CHECK(RL::shape_dna_distance(of_a, of_a) == 0);
  }
  CHECK(RL::shape_dna_distance(RL::shape_dna(a), RL::shape_dna(a.eigenvalues, a.area)) <= 1e-9);
  CHECK(RL::shape_dna(a, Normalization::none)[5] ==
        Approx(49 * RL::shape_dna(b, Normalization::none)[5]));
}

TEST_CASE("shape_dna_by_hand", "[descriptors]") {
  using Normalization = RL::Shape_dna_normalization;
  const Eigen::Vector4d lambda(1e-12, 3, 6, 9); // on a line of slope 3
  CHECK(RL::shape_dna(lambda, 2) == Eigen::Vector4d(0, 6, 12, 18));
  CHECK(RL::shape_dna(lambda, 2, Normalization::none) == Eigen::Vector4d(0, 3, 6, 9));
  const Eigen::Vector4d expected(0, 1, 2, 3);
  CHECK(largest_entry(RL::shape_dna(lambda, 2, Normalization::weyl_slope) - expected) <= 1e-14);
  CHECK(largest_entry(RL::shape_dna(lambda, 2, Normalization::first_eigenvalue) - expected) <=
        1e-14);
  // least squares: the slope of (0, 0), (1, 0), (2, 3) is 3 / 2
  CHECK(RL::shape_dna(Eigen::Vector3d(0, 0, 3), 1, Normalization::weyl_slope)[2] == Approx(2));
  CHECK(RL::shape_dna_distance(Eigen::Vector2d(0, 1), Eigen::Vector2d(3, 5)) == 5);
}

TEST_CASE("embeddings_are_those_of_greens_function", "[descriptors]") {
  const Example e;
  const Eigen::VectorXd& lambda = e.spectrum.eigenvalues;
  const Eigen::MatrixXd gps = RL::global_point_signature(lambda, e.values),
                        biharmonic = RL::biharmonic_embedding(lambda, e.values);
  REQUIRE(gps.cols() == 19);
  REQUIRE(biharmonic.cols() == 19);
  // the integral of g(x, x) is the sum of 1 / lambda
  CHECK(e.nodes.integrals(gps.rowwise().squaredNorm())[0] ==
        Approx(lambda.tail(19).cwiseInverse().sum()));
  for(Eigen::Index x : {0, 1000, 5000}) {
    const Eigen::VectorXd green = gps * gps.row(x).transpose();
    // g(x, .) has the mean 0, and the square of its norm is that of the biharmonic coordinates
    CHECK(std::abs(e.nodes.integrals(green)[0]) <= 1e-8);
    CHECK(e.nodes.integrals(green.cwiseAbs2())[0] == Approx(biharmonic.row(x).squaredNorm()));
    // the difference of heat kernels has the norm that the diffusion map says
    const double t = 0.05;
    const Eigen::MatrixXd map = RL::diffusion_map(lambda, e.values, t);
    REQUIRE(map.cols() == 20);
    const Eigen::Index y = x + 4321;
    const Eigen::VectorXd decay = (-t * lambda).array().exp();
    const Eigen::VectorXd difference =
        e.values * decay.cwiseProduct((e.values.row(x) - e.values.row(y)).transpose());
    CHECK(e.nodes.integrals(difference.cwiseAbs2())[0] == Approx(squared_distance(map, x, y)));
  }
}

TEST_CASE("biharmonic_distances_on_the_sphere", "[descriptors]") {
  const RL::Laplace_spectrum spectrum = spectrum_of_sphere();
  const Eigen::MatrixXd embedding = RL::biharmonic_embedding(spectrum);
  const shapes::Triangles sphere = shapes::sphere(5);
  for(Eigen::Index v = 1; v < 200; ++v) {
    // by the addition theorem, with the Legendre polynomials of the cosine of the angle
    const double x = (sphere.points[0] - CGAL::ORIGIN) * (sphere.points[v] - CGAL::ORIGIN);
    double sum = 0, before = 1, p = x;
    for(int l = 1; l <= 6; ++l) {
      sum += (2 * l + 1) / (2 * descriptor_pi) * (1 - p) / std::pow(l * (l + 1), 2);
      const double next = ((2 * l + 1) * x * p - l * before) / (l + 1);
      before = p;
      p = next;
    }
    REQUIRE(std::sqrt(squared_distance(embedding, 0, v)) == Approx(std::sqrt(sum)).epsilon(1e-2));
  }
}

TEST_CASE("descriptors_of_several_components", "[descriptors]") {
  // spheres of radius 1 and 1/2: two zeros
  const shapes::Triangles sphere = shapes::sphere(4);
  const shapes::Triangles two =
      shapes::joined(sphere, shapes::moved(shapes::scaled(sphere, 0.5), {3, 0, 0}));
  const RL::Spline_space_3 space(shapes::mesh(two), params::depth(5));
  const RL::Laplace_spectrum spectrum = RL::laplace_spectrum(space, 9);
  CHECK(RL::number_of_zero_eigenvalues(spectrum.eigenvalues) == 2);
  CHECK(RL::number_of_zero_eigenvalues(spectrum) == 2);
  const auto first_of_second = static_cast<Eigen::Index>(sphere.points.size());
  // after a long time heat is constant on each component
  const Eigen::MatrixXd hks =
      RL::heat_kernel_signature(spectrum, Eigen::VectorXd::Constant(1, 100));
  const double area = space.surface().area() / 1.25;
  CHECK(hks(0, 0) == Approx(1 / area));
  CHECK(hks(first_of_second, 0) == Approx(4 / area));
  // and the squared distance of two of them is the sum of both
  const Eigen::MatrixXd map = RL::diffusion_map(spectrum, 100);
  CHECK(map.cols() == 9);
  CHECK(squared_distance(map, 0, first_of_second) == Approx(5 / area));
  CHECK(squared_distance(map, 0, 1) <= 1e-20);
  CHECK(RL::global_point_signature(spectrum).cols() == 7);
  CHECK(RL::biharmonic_embedding(spectrum).cols() == 7);
  const Eigen::VectorXd dna = RL::shape_dna(spectrum);
  CHECK(dna[0] == 0);
  CHECK(dna[1] == 0);
  CHECK(dna[2] == Approx(2 * spectrum.area).epsilon(1e-2));
  CHECK(RL::heat_kernel_times(spectrum, 2)[1] == Approx(2 * std::log(10.)).epsilon(1e-2));
  CHECK(RL::wave_kernel_energies(spectrum).energies[0] >= std::log(1.9));

  // a spectrum of zeros only is recognized, whatever rounding made of them
  RL::Laplace_spectrum zeros = RL::laplace_spectrum(space, 2);
  CHECK(RL::number_of_zero_eigenvalues(zeros) == 2);
  zeros.eigenvalues << -1e-13, 2e-13;
  CHECK(RL::number_of_zero_eigenvalues(zeros) == 2);
  CHECK(refused_by([&] { RL::global_point_signature(zeros); }) == "eigenvalues");
  CHECK(refused_by([&] { RL::heat_kernel_times(zeros); }) == "eigenvalues");
}

TEST_CASE("descriptors_of_points_off_the_surface_are_nan", "[descriptors]") {
  const Eigen::Vector4d lambda(0, 1, 2, 3);
  Eigen::MatrixXd values = random_matrix(2000, 4);
  values.row(5).setConstant(std::numeric_limits<double>::quiet_NaN());
  values.row(1999) = values.row(5);
  const auto check = [](const Eigen::MatrixXd& result) {
    REQUIRE(result.rows() == 2000);
    REQUIRE(result.cols() > 0);
    for(Eigen::Index i = 0; i < 2000; ++i)
      for(Eigen::Index j = 0; j < result.cols(); ++j)
        REQUIRE(std::isnan(result(i, j)) == (i == 5 || i == 1999));
  };
  check(RL::heat_kernel_signature(lambda, values, RL::heat_kernel_times(lambda)));
  check(RL::wave_kernel_signature(lambda, values, RL::wave_kernel_energies(lambda)));
  check(RL::global_point_signature(lambda, values));
  check(RL::biharmonic_embedding(lambda, values));
  check(RL::diffusion_map(lambda, values, 1));
}

TEST_CASE("scaled_signatures_do_not_underflow", "[descriptors]") {
  // without a zero, as with values prescribed on the boundary
  const Eigen::Vector3d lambda(10, 10.0001, 40);
  Eigen::MatrixXd values(1, 3);
  values << 1, 2, 3;
  const Eigen::MatrixXd hks = RL::heat_kernel_signature(
      lambda, values, Eigen::VectorXd::Constant(1, 1e4), RL::Heat_kernel_scaling::heat_trace);
  CHECK(hks(0, 0) == Approx((1 + 4 * std::exp(-1)) / (1 + std::exp(-1))));
  CHECK(RL::number_of_zero_eigenvalues(lambda) == 0);
}

TEST_CASE("bad_input_of_descriptors", "[descriptors][input]") {
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  const Eigen::Vector3d lambda(0, 1, 2);
  const Eigen::VectorXd times = Eigen::VectorXd::Constant(2, 0.5);
  const Eigen::MatrixXd values = random_matrix(4, 3);
  RL::Wave_kernel_energies energies = RL::wave_kernel_energies(lambda);

  const auto check_eigenvalues = [&](const Eigen::VectorXd& bad, bool is_of_zeros) {
    const Eigen::MatrixXd v = random_matrix(4, bad.size());
    const auto refused = [](auto&& call) { CHECK(refused_by(call) == "eigenvalues"); };
    refused([&] { RL::heat_kernel_times(bad); });
    refused([&] { RL::wave_kernel_energies(bad); });
    refused([&] { RL::wave_kernel_signature(bad, v, energies); });
    refused([&] { RL::global_point_signature(bad, v); });
    refused([&] { RL::biharmonic_embedding(bad, v); });
    for(auto n :
        {RL::Shape_dna_normalization::first_eigenvalue, RL::Shape_dna_normalization::weyl_slope})
      refused([&] { RL::shape_dna(bad, 1, n); });
    if(is_of_zeros) // which these take
      return;
    refused([&] { RL::heat_kernel_signature(bad, v, times); });
    refused([&] { RL::heat_trace(bad, times); });
    refused([&] { RL::diffusion_map(bad, v, 1); });
    refused([&] { RL::shape_dna(bad, 1); });
    refused([&] { RL::number_of_zero_eigenvalues(bad); });
  };
  check_eigenvalues(Eigen::VectorXd(), false);
  check_eigenvalues(Eigen::Vector3d(0, 2, 1), false);
  check_eigenvalues(Eigen::Vector3d(0, 1, nan), false);
  check_eigenvalues(Eigen::Vector3d(nan, 1, 2), false);
  check_eigenvalues(Eigen::Vector3d(0, 1, infinity), false);
  check_eigenvalues(Eigen::Vector3d(-1, 1, 2), false);
  check_eigenvalues(Eigen::Vector3d(0, 0, 0), true);
  CHECK(refused_by([&] { RL::wave_kernel_energies(Eigen::Vector3d(0, 2, 2)); }) == "eigenvalues");
  CHECK(refused_by([&] {
          RL::shape_dna(Eigen::Vector2d(2, 2), 1, RL::Shape_dna_normalization::weyl_slope);
        }) == "eigenvalues");
  CHECK(refused_by([&] {
          RL::shape_dna(Eigen::VectorXd::Ones(1), 1, RL::Shape_dna_normalization::weyl_slope);
        }) == "eigenvalues");

  const Eigen::MatrixXd narrow = values.leftCols(2);
  CHECK(refused_by([&] { RL::heat_kernel_signature(lambda, narrow, times); }) == "values");
  CHECK(refused_by([&] { RL::wave_kernel_signature(lambda, narrow, energies); }) == "values");
  CHECK(refused_by([&] { RL::global_point_signature(lambda, narrow); }) == "values");
  CHECK(refused_by([&] { RL::biharmonic_embedding(lambda, narrow); }) == "values");
  CHECK(refused_by([&] { RL::diffusion_map(lambda, narrow, 1); }) == "values");

  for(double bad : {0., -1., nan, infinity}) {
    CHECK(refused_by([&] { RL::heat_kernel_signature(lambda, values, Eigen::Vector2d(1, bad)); }) ==
          "times");
    CHECK(refused_by([&] { RL::heat_trace(lambda, Eigen::Vector2d(bad, 1)); }) == "times");
    CHECK(refused_by([&] { RL::diffusion_map(lambda, values, bad); }) == "time");
    CHECK(refused_by([&] { RL::shape_dna(lambda, bad); }) == "area");
    energies.sigma = bad;
    CHECK(refused_by([&] { RL::wave_kernel_signature(lambda, values, energies); }) == "sigma");
  }
  energies.sigma = 1;
  energies.energies[3] = nan;
  CHECK(refused_by([&] { RL::wave_kernel_signature(lambda, values, energies); }) == "energies");
  CHECK(refused_by([&] { RL::heat_kernel_times(lambda, 1); }) == "number");
  CHECK(refused_by([&] { RL::wave_kernel_energies(lambda, 0); }) == "number");
  CHECK(refused_by([&] { RL::shape_dna_distance(lambda, lambda.head(2)); }) == "b");
  CHECK(refused_by([&] { RL::shape_dna_distance(lambda, Eigen::Vector3d(0, 1, nan)); }) == "b");
  CHECK(refused_by([&] { RL::shape_dna_distance(Eigen::Vector3d(0, 1, nan), lambda); }) == "a");
  CHECK(refused_by([&] { RL::shape_dna_distance(Eigen::VectorXd(), Eigen::VectorXd()); }) == "b");
  // a spectrum that nothing has filled in
  CHECK(refused_by([&] { RL::shape_dna(RL::Laplace_spectrum()); }) == "area");
}

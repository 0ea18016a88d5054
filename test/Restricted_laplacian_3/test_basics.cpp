// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Lists by key, cells and their keys, the spline in one dimension and the basis made of it,
// cubature rules, edges and samples of a surface, and the version.

#include "catch.h"
#include "shapes.h"

#include <CGAL/Restricted_laplacian_3/basis/B_spline_1.h>
#include <CGAL/Restricted_laplacian_3/basis/Tensor_basis_3.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Number_lists.h>
#include <CGAL/Restricted_laplacian_3/integration/triangle_quadrature.h>
#include <CGAL/Restricted_laplacian_3/octree/Cell_3.h>
#include <CGAL/Restricted_laplacian_3/surface/sample_surface.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/Surface_edges.h>
#include <CGAL/Restricted_laplacian_3/version.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;

/// the Morton key, bit by bit, as its definition says
std::uint64_t interleaved_bits(const std::array<int, 3>& index) {
  std::uint64_t key = 0;
  for(int bit = 0; bit < 21; ++bit)
    for(int axis = 0; axis < 3; ++axis)
      key |= static_cast<std::uint64_t>(index[axis] >> bit & 1) << (3 * bit + axis);
  return key;
}

/// value at `x`, in units of the cell width, of the spline that is centered on cell `i`
double spline(int i, double x) {
  const int cell = static_cast<int>(std::floor(x));
  const int offset = i - cell;
  return std::abs(offset) > 1 ? 0 : RL::B_spline_1::values(x - cell)[offset + 1];
}

/// integral of b0^a b1^b over a triangle of area 1
double exact_integral(int a, int b) {
  return 2 * std::tgamma(a + 1.) * std::tgamma(b + 1.) / std::tgamma(a + b + 3.);
}

double cubature(const std::vector<RL::Triangle_quadrature_node>& rule, int a, int b) {
  double sum = 0;
  for(const RL::Triangle_quadrature_node& node : rule)
    sum += node.weight * std::pow(node.b0, a) * std::pow(node.b1, b);
  return sum;
}

/// largest error among the monomials of one total degree
double largest_error(const std::vector<RL::Triangle_quadrature_node>& rule, int degree) {
  double error = 0;
  for(int a = 0; a <= degree; ++a)
    error =
        (std::max)(error, std::abs(cubature(rule, a, degree - a) - exact_integral(a, degree - a)));
  return error;
}

/// sum of (observed - expected)^2 / expected
double chi_squared(const std::vector<double>& observed, const std::vector<double>& expected) {
  double sum = 0;
  for(std::size_t i = 0; i < observed.size(); ++i)
    sum += std::pow(observed[i] - expected[i], 2) / expected[i];
  return sum;
}

/// A bound that chi-squared with this many degrees of freedom exceeds with a probability below 1e-6
/// (its mean plus six standard deviations, plus what its skewness adds).
double chi_squared_bound(double degrees_of_freedom) {
  return degrees_of_freedom + 6 * std::sqrt(2 * degrees_of_freedom) + 18;
}

} // namespace

TEST_CASE("numbers_are_grouped_by_key", "[basics]") {
  namespace internal = RL::internal;
  std::mt19937 generator(4);
  for(std::size_t size : {0u, 1u, 7u, 100u}) {
    std::vector<std::size_t> keys(300);
    for(std::size_t& key : keys)
      key = generator() % (size + 1);
    std::vector<std::vector<std::uint32_t>> expected(size + 1);
    for(std::uint32_t i = 0; i < keys.size(); ++i)
      expected[keys[i]].push_back(i);
    const auto lists =
        internal::Number_lists::by_key(size, keys.size(), [&](std::size_t i) { return keys[i]; });
    REQUIRE(lists.size() == size);
    CHECK(lists.numbers().size() == keys.size() - expected[size].size());
    for(std::size_t i = 0; i < size; ++i) {
      CHECK(std::vector<std::uint32_t>(lists[i].begin(), lists[i].end()) == expected[i]);
      CHECK(lists.first(i + 1) - lists.first(i) == expected[i].size());
    }
  }
}

TEST_CASE("edges_are_those_of_a_plain_search", "[basics]") {
  using RL::internal::Surface_edges;
  shapes::Triangles open = shapes::sphere(2);
  open.faces.erase(open.faces.begin() + 20, open.faces.begin() + 50);
  open.faces.push_back(open.faces[0]); // a side of three faces
  open.faces.push_back({open.faces[5][0], open.faces[5][1], open.faces[5][0]}); // degenerate
  for(const shapes::Triangles& t : {shapes::sphere(2), open})
    for(const auto faces : {Surface_edges::Faces::all, Surface_edges::Faces::not_degenerate}) {
      const RL::Triangulated_surface_3 surface(t.points, t.faces);
      std::map<std::array<std::uint32_t, 2>, std::multiset<std::uint32_t>> expected;
      for(std::uint32_t f = 0; f < t.faces.size(); ++f)
        for(int i = 0; i < 3; ++i) {
          const std::uint32_t a = t.faces[f][i], b = t.faces[f][(i + 1) % 3];
          if(faces == Surface_edges::Faces::all || !surface.is_degenerate(f))
            expected[{(std::min)(a, b), (std::max)(a, b)}].insert(f);
        }
      const Surface_edges edges(surface, faces);
      REQUIRE(edges.size() == expected.size());
      std::vector<char> is_on_boundary(t.points.size(), 0);
      std::size_t edge = 0;
      for(const auto& [ends, with_edge] : expected) {
        CHECK(edges.ends(edge) == ends);
        std::multiset<std::uint32_t> found;
        for(const Surface_edges::Side& side : edges.sides(edge)) {
          found.insert(side.face);
          const std::uint32_t a = t.faces[side.face][side.number],
                              b = t.faces[side.face][(side.number + 1) % 3];
          CHECK(((std::min)(a, b) == ends[0] && (std::max)(a, b) == ends[1]));
        }
        CHECK(found == with_edge);
        if(with_edge.size() == 1)
          is_on_boundary[ends[0]] = is_on_boundary[ends[1]] = 1;
        ++edge;
      }
      CHECK(edges.boundary_vertices() == is_on_boundary);
    }
}

TEST_CASE("morton_key_interleaves_bits_and_has_an_inverse", "[basics]") {
  const int last = (1 << 21) - 1;
  for(const std::array<int, 3> index : {std::array<int, 3>{0, 0, 0},
                                        {last, last, last},
                                        {last, 0, 0},
                                        {0, last, 0},
                                        {0, 0, last},
                                        {1 << 20, 1, 0x155555}}) {
    CHECK(RL::morton_key(index) == interleaved_bits(index));
    CHECK(RL::morton_index(RL::morton_key(index)) == index);
  }
  std::mt19937 generator(1);
  for(int i = 0; i < 10000; ++i) {
    const std::array<int, 3> index = {static_cast<int>(generator() & last),
                                      static_cast<int>(generator() & last),
                                      static_cast<int>(generator() & last)};
    REQUIRE(RL::morton_key(index) == interleaved_bits(index));
    REQUIRE(RL::morton_index(RL::morton_key(index)) == index);
  }
}

TEST_CASE("children_of_a_cell_have_consecutive_keys", "[basics]") {
  std::mt19937 generator(2);
  for(int i = 0; i < 1000; ++i) {
    const int level = static_cast<int>(generator() % RL::maximum_octree_depth);
    const int mask = (1 << level) - 1;
    const RL::Cell_3 cell{level,
                          {static_cast<int>(generator()) & mask,
                           static_cast<int>(generator()) & mask,
                           static_cast<int>(generator()) & mask}};
    REQUIRE(cell.is_inside_grid());
    REQUIRE(RL::Cell_3::from_key(level, cell.key()) == cell);
    for(int octant = 0; octant < 8; ++octant) {
      const RL::Cell_3 child = cell.child(octant);
      REQUIRE(child.is_inside_grid());
      REQUIRE(child.key() == 8 * cell.key() + octant);
      REQUIRE(child.octant() == octant);
      REQUIRE(child.parent() == cell);
      REQUIRE(child != cell);
    }
  }
}

TEST_CASE("cells_outside_the_grid_have_parents_and_neighbors_too", "[basics]") {
  for(int x = -3; x <= 9; ++x)
    for(int y = -3; y <= 9; ++y) {
      const RL::Cell_3 cell{3, {x, y, 4}};
      REQUIRE(cell.is_inside_grid() == (x >= 0 && x < 8 && y >= 0 && y < 8));
      const RL::Cell_3 parent = cell.parent();
      REQUIRE(parent.level == 2);
      for(int axis = 0; axis < 3; ++axis) // rounded down, also where it is negative
        REQUIRE(parent.index[axis] == std::floor(cell.index[axis] / 2.));
      REQUIRE(parent.child(cell.octant()) == cell);
      for(int dx = -1; dx <= 1; ++dx) {
        REQUIRE(cell.neighbor(dx, -1, 2) == (RL::Cell_3{3, {x + dx, y - 1, 6}}));
        REQUIRE(cell.neighbor(dx, -1, 2).neighbor(-dx, 1, -2) == cell);
      }
    }
  CHECK((RL::Cell_3{0, {0, 0, 0}}).is_inside_grid());
  CHECK_FALSE((RL::Cell_3{0, {0, 0, 1}}).is_inside_grid());
  CHECK(RL::Cell_3{1, {0, 0, 0}} != RL::Cell_3{2, {0, 0, 0}});
}

TEST_CASE("splines_are_a_partition_of_unity", "[basics]") {
  for(double t = 0; t <= 1; t += 1. / 64) {
    const auto v = RL::B_spline_1::values(t), d = RL::B_spline_1::derivatives(t);
    REQUIRE(v[0] + v[1] + v[2] == 1);
    REQUIRE(d[0] + d[1] + d[2] == 0);
    REQUIRE(*std::min_element(v.begin(), v.end()) >= 0);
    REQUIRE(v[0] == (1 - t) * (1 - t) / 2);
    REQUIRE(v[1] == 0.5 + t - t * t);
    REQUIRE(v[2] == t * t / 2);
  }
  // what vanishes at a wall vanishes exactly
  CHECK(RL::B_spline_1::values(0)[2] == 0);
  CHECK(RL::B_spline_1::values(1)[0] == 0);
}

TEST_CASE("spline_derivatives_agree_with_differences", "[basics]") {
  const double step = 1. / 1024;
  for(double t = 0.01; t < 1; t += 0.0173) {
    const auto upper = RL::B_spline_1::values(t + step), lower = RL::B_spline_1::values(t - step),
               d = RL::B_spline_1::derivatives(t);
    for(int piece = 0; piece < 3; ++piece) // central differences of quadratics are exact
      REQUIRE(d[piece] == Approx((upper[piece] - lower[piece]) / (2 * step)).margin(1e-12));
  }
}

TEST_CASE("splines_are_c1_across_cells", "[basics]") {
  const auto v0 = RL::B_spline_1::values(0), v1 = RL::B_spline_1::values(1),
             d0 = RL::B_spline_1::derivatives(0), d1 = RL::B_spline_1::derivatives(1);
  // A spline has offset +1 in the cell below its center, then 0, then -1.
  for(const auto& [at_zero, at_one] : {std::make_pair(v0, v1), std::make_pair(d0, d1)}) {
    CHECK(at_zero[2] == 0);
    CHECK(at_one[2] == at_zero[1]);
    CHECK(at_one[1] == at_zero[0]);
    CHECK(at_one[0] == 0);
  }
}

TEST_CASE("bernstein_coefficients_give_the_spline_and_its_derivative", "[basics]") {
  const auto b = RL::B_spline_1::bernstein_coefficients(),
             d = RL::B_spline_1::derivative_bernstein_coefficients();
  for(double t = 0; t <= 1; t += 1. / 32) {
    const std::array<double, 3> bernstein = {(1 - t) * (1 - t), 2 * t * (1 - t), t * t};
    for(int piece = 0; piece < 3; ++piece) {
      double value = 0, derivative = 0;
      for(int k = 0; k < 3; ++k) {
        value += b[piece][k] * bernstein[k];
        derivative += d[piece][k] * bernstein[k];
      }
      REQUIRE(value == RL::B_spline_1::values(t)[piece]);
      REQUIRE(derivative == RL::B_spline_1::derivatives(t)[piece]);
    }
  }
}

TEST_CASE("spline_is_a_combination_of_splines_of_the_finer_grid", "[basics]") {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-3, 4);
  for(int i = 0; i < 1000; ++i) {
    const double x = uniform(generator);
    for(int coarse : {-1, 0, 2}) {
      double sum = 0;
      for(int fine = -16; fine <= 16; ++fine)
        sum += RL::B_spline_1::two_scale_coefficient(fine - 2 * coarse) * spline(fine, 2 * x);
      REQUIRE(sum == Approx(spline(coarse, x)).margin(1e-15));
    }
  }
}

TEST_CASE("products_of_splines_are_those_of_their_pieces", "[basics]") {
  using Basis = RL::Tensor_basis_3;
  const std::array<double, 3> t = {0.3, 0.85, 0.1};
  const Basis::Values values = Basis::values(t);
  const std::array<Basis::Values, 3> gradients = Basis::gradients(t);
  RL::Cell_elements elements;
  elements.fill(RL::no_element);
  std::vector<double> coefficients;
  double sum = 0;
  for(int i = 0; i < Basis::size; ++i) {
    const auto [x, y, z] = Basis::pieces_of(i);
    CHECK(Basis::number(x, y, z) == i);
    CHECK(Basis::offset(i) == std::array<int, 3>{x - 1, y - 1, z - 1});
    // the spline that is centered on the cell at the offset
    const std::array<double, 3> b = {spline(x - 1, t[0]), spline(y - 1, t[1]), spline(z - 1, t[2])};
    CHECK(values[i] == Approx(b[0] * b[1] * b[2]));
    for(int axis = 0; axis < 3; ++axis) {
      std::array<double, 3> factors = b;
      factors[axis] = RL::B_spline_1::derivatives(t[axis])[Basis::pieces_of(i)[axis]];
      CHECK(gradients[axis][i] == Approx(factors[0] * factors[1] * factors[2]));
    }
    if(i % 2 == 0) {
      elements[i] = static_cast<std::uint32_t>(coefficients.size());
      coefficients.push_back(i + 0.5);
      sum += (i + 0.5) * values[i];
    }
  }
  CHECK(RL::combination(elements, values, coefficients) == Approx(sum));
}

TEST_CASE("cubature_rules_are_exact_up_to_their_degree_and_no_further", "[basics]") {
  for(const auto& [degree, size, error_beyond] :
      {std::make_tuple(2, 3u, 1e-3), std::make_tuple(5, 7u, 1e-5), std::make_tuple(7, 12u, 1e-6),
       std::make_tuple(8, 16u, 1e-7), std::make_tuple(10, 24u, 1e-8),
       std::make_tuple(12, 32u, 1e-9)}) {
    INFO("degree " << degree);
    const auto& rule = RL::triangle_quadrature(degree);
    CHECK(rule.size() == size);
    for(const RL::Triangle_quadrature_node& node : rule) {
      CHECK(node.weight > 0);
      CHECK((std::min)({node.b0, node.b1, node.b2}) >= 0);
      CHECK(node.b0 + node.b1 + node.b2 == Approx(1).epsilon(1e-15));
    }
    for(int d = 0; d <= degree; ++d) {
      INFO("monomials of degree " << d);
      CHECK(largest_error(rule, d) <= 1e-15);
    }
    CHECK(largest_error(rule, degree + 1) >= error_beyond);
  }
}

TEST_CASE("cubature_rule_of_a_degree_reaches_it", "[basics]") {
  for(int degree = 0; degree <= 12; ++degree)
    CHECK(largest_error(RL::triangle_quadrature(degree), degree) <= 1e-15);
  for(int degree : {-1, 13})
    CHECK_THROWS_AS(RL::triangle_quadrature(degree), RL::Parameter_error);
}

TEST_CASE("samples_depend_on_the_seed_alone", "[basics]") {
  const shapes::Triangles sphere = shapes::sphere(2);
  const RL::Triangulated_surface_3 surface(sphere.points, sphere.faces);
  const auto a = RL::sample_surface(surface, 100, 7), b = RL::sample_surface(surface, 100, 7),
             c = RL::sample_surface(surface, 100, 8), longer = RL::sample_surface(surface, 200, 7);
  int equal = 0;
  for(std::size_t i = 0; i < a.size(); ++i) {
    CHECK(a[i].face == b[i].face);
    CHECK(a[i].barycentric == b[i].barycentric);
    CHECK(a[i].barycentric == longer[i].barycentric);
    equal += a[i].barycentric == c[i].barycentric;
  }
  CHECK(equal == 0);
  CHECK_THROWS_AS(RL::sample_surface(surface, 0, 7), RL::Parameter_error);
}

TEST_CASE("samples_are_uniform_by_area", "[basics]") {
  // areas that differ by a factor of 200, degenerate faces first, between the others and last
  std::vector<RL::Point_3> points;
  std::vector<RL::Triangulated_surface_3::Triangle> faces;
  const auto add_face = [&](double x, double width, double height) {
    const auto first = static_cast<std::uint32_t>(points.size());
    points.emplace_back(x, 0, 0);
    points.emplace_back(x + width, 0, 1);
    points.emplace_back(x, height, 0);
    faces.push_back({first, first + 1, first + 2});
  };
  for(int i = 0; i < 20; ++i) {
    add_face(2 * i, 1, 0);
    add_face(2 * i, 1, 0.01 * (i + 1) * (i + 1));
    faces.push_back({0, 1, 1});
  }
  const RL::Triangulated_surface_3 surface(points, faces);
  REQUIRE(surface.number_of_degenerate_faces() == 40);

  const std::size_t number = 200000;
  std::vector<double> in_face(faces.size(), 0.);
  std::array<double, 3> sums = {0, 0, 0};
  std::vector<double> in_quarter(4, 0.);
  for(const RL::Surface_location& sample : RL::sample_surface(surface, number, 1)) {
    const auto& l = sample.barycentric;
    REQUIRE(sample.face < faces.size());
    REQUIRE_FALSE(surface.is_degenerate(sample.face));
    REQUIRE((std::min)({l[0], l[1], l[2]}) >= 0);
    REQUIRE(l[0] + l[1] + l[2] == Approx(1).epsilon(1e-15));
    ++in_face[sample.face];
    // the four triangles between the midpoints of the sides
    const auto corner = std::find_if(l.begin(), l.end(), [](double x) { return x > 0.5; });
    ++in_quarter[corner - l.begin()];
    for(int k = 0; k < 3; ++k)
      sums[k] += l[k] * l[(k + 1) % 3];
  }
  std::vector<double> observed, expected;
  for(std::size_t f = 0; f < faces.size(); ++f)
    if(!surface.is_degenerate(f)) {
      observed.push_back(in_face[f]);
      expected.push_back(number * surface.area(f) / surface.area());
    }
  CHECK(chi_squared(observed, expected) <= chi_squared_bound(19));
  CHECK(chi_squared(in_quarter, std::vector<double>(4, number / 4.)) <= chi_squared_bound(3));
  for(double sum : sums) // the integral of b0 b1 is 1/12
    CHECK(sum / number == Approx(1. / 12).epsilon(0.01));
}

TEST_CASE("version_is_that_of_the_build_system", "[basics]") {
  CHECK(std::string(CGAL_RESTRICTED_LAPLACIAN_3_VERSION) == RESTRICTED_LAPLACIAN_3_VERSION);
  CHECK(CGAL_RESTRICTED_LAPLACIAN_3_VERSION_NUMBER(5, 5, 1) == 1050511000); // as of CGAL 5.5.1
#if CGAL_RESTRICTED_LAPLACIAN_3_VERSION_NR < CGAL_RESTRICTED_LAPLACIAN_3_VERSION_NUMBER(0, 2, 0)
  FAIL("the version is not at least 0.2.0");
#endif
}

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Results do not depend on the number of threads, nor on the instructions that the processor has.

#include "catch.h"
#include "shapes.h"

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/assembly/shared/assemble_system.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/stable_sort_by_key.h>
#include <CGAL/Restricted_laplacian_3/input/read_surface.h>
#include <CGAL/Restricted_laplacian_3/integration/internal/fragment_nodes.h>
#include <CGAL/Restricted_laplacian_3/integration/shared/Cell_load.h>
#include <CGAL/Restricted_laplacian_3/integration/shared/patch_kernels.h>
#include <CGAL/Restricted_laplacian_3/integration/shared/sheet_kernels.h>
#include <CGAL/Restricted_laplacian_3/splines/shared/Block_evaluation.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace internal = CGAL::Restricted_laplacian_3::internal;
using shapes::Mesh;

/// at most so many threads as long as it exists
struct Thread_limit {
#ifdef CGAL_LINKED_WITH_TBB
  explicit Thread_limit(int number)
    : control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(number)) {}
  tbb::global_control control;
#else
  explicit Thread_limit(int) {}
#endif
};

bool are_identical(const RL::Sparse_matrix& a, const RL::Sparse_matrix& b) {
  const auto size = static_cast<std::size_t>(a.nonZeros());
  return a.rows() == b.rows() && a.nonZeros() == b.nonZeros() &&
         std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.cols() + 1, b.outerIndexPtr()) &&
         std::equal(a.innerIndexPtr(), a.innerIndexPtr() + size, b.innerIndexPtr()) &&
         std::memcmp(a.valuePtr(), b.valuePtr(), size * sizeof(double)) == 0;
}

struct Assembled {
  Assembled(const Mesh& mesh, int depth, bool is_split, bool is_parallel) {
    RL::Spline_space_options options;
    options.depth = depth;
    options.split = is_split;
    options.is_parallel = is_parallel;
    space = std::make_unique<RL::Spline_space_3>(RL::read_surface(mesh), options);
    operators = RL::assemble_operators_of_levels(*space, 0, depth);
    stabilized = RL::assemble_operators_of_levels(*space, 0, depth, 0.1);
    internal::Elliptic_operator elliptic;
    elliptic.reaction = 2;
    elliptic.stabilization = 0.1;
    system = internal::assemble_system(*space, depth, elliptic);
    for(int level : {depth - 2, depth}) {
      loads.push_back(RL::assemble_load(
          *space, [](const RL::Surface_point& p) { return std::sin(p.point.x()); }, level));
      loads.push_back(RL::assemble_gradient_load(
          *space, [](const RL::Surface_point& p) { return p.point - CGAL::ORIGIN; }, level));
    }
  }

  std::unique_ptr<RL::Spline_space_3> space;
  std::vector<RL::Operators> operators, stabilized;
  internal::System_matrices system;
  std::vector<Eigen::VectorXd> loads;
};

void check_identical(const Assembled& a, const Assembled& b) {
  for(int level = 0; level <= a.space->depth(); ++level) {
    INFO("level " << level);
    const RL::Octree_3 &p = a.space->octree(), &q = b.space->octree();
    REQUIRE(p.number_of_sheets(level) == q.number_of_sheets(level));
    bool same_links = true, same_elements = true;
    for(std::size_t sheet = 0; sheet < p.number_of_sheets(level); ++sheet) {
      same_links = same_links && p.links(level, sheet) == q.links(level, sheet);
      same_elements =
          same_elements && a.space->elements(level, sheet) == b.space->elements(level, sheet);
    }
    CHECK(same_links);
    CHECK(same_elements);
    CHECK(are_identical(a.operators[level].stiffness, b.operators[level].stiffness));
    CHECK(are_identical(a.operators[level].mass, b.operators[level].mass));
    CHECK(are_identical(a.stabilized[level].stiffness, b.stabilized[level].stiffness));
    CHECK(are_identical(a.stabilized[level].mass, b.stabilized[level].mass));
  }
  CHECK(are_identical(a.system.matrices.front(), b.system.matrices.front()));
  CHECK(a.system.integrals == b.system.integrals);
  CHECK(a.loads == b.loads);
}

} // namespace

TEST_CASE("results_do_not_depend_on_the_number_of_threads", "[threads][slow]") {
  // more than one chunk of faces, cells and slots
  std::vector<std::pair<Mesh, int>> inputs;
  inputs.emplace_back(shapes::mesh(shapes::sphere(6)), 6);
  inputs.emplace_back(shapes::mesh(shapes::box(1, 0.7, 0.3, 40, 30)), 5);
  Mesh rotor = shapes::read(cgal_mesh("rotor_small.off"));
  if(rotor.is_empty())
    SKIP_PART("no such file: rotor_small.off");
  else
    inputs.emplace_back(std::move(rotor), 6);
  for(const auto& [mesh, depth] : inputs)
    for(bool is_split : {true, false}) {
      if(!is_split && depth > 5)
        continue; // what is not split differs in the numbers of elements only
      const Assembled sequential(mesh, depth, is_split, false);
      for(int threads : {1, 3}) {
        INFO(threads << " threads" << (is_split ? ", split" : ", unsplit"));
        const Thread_limit limit(threads);
        check_identical(Assembled(mesh, depth, is_split, true), sequential);
      }
    }
}

TEST_CASE("concurrency_tag_sets_the_option", "[threads]") {
  namespace params = RL::parameters;
  const Mesh mesh = shapes::mesh(shapes::sphere(1));
  CHECK(!RL::Spline_space_3(mesh, params::depth(2)).options().is_parallel);
  CHECK(!RL::Spline_space_3(mesh, params::concurrency_tag(CGAL::Sequential_tag()))
             .options()
             .is_parallel);
#ifdef CGAL_LINKED_WITH_TBB
  const bool with_tbb = true;
  CHECK(RL::Spline_space_3(mesh, params::concurrency_tag(CGAL::Parallel_tag()))
            .options()
            .is_parallel);
#else
  const bool with_tbb = false;
#endif
  CHECK(
      RL::Spline_space_3(mesh, params::depth(2).concurrency_tag(CGAL::Parallel_if_available_tag()))
          .options()
          .is_parallel == with_tbb);
}

TEST_CASE("parallel_for_covers_the_range_in_fixed_chunks", "[threads]") {
  for(bool is_parallel : {false, true})
    for(std::size_t size : {0u, 1u, 9u, 10u, 11u, 1000u}) {
      const std::size_t begin = 3, grain = 10;
      std::vector<int> counts(begin + size, 0);
      std::vector<char> is_chunk(size + grain, 0);
      internal::parallel_for(is_parallel, begin, begin + size, grain,
                             [&](std::size_t b, std::size_t e) {
                               is_chunk[b - begin] = (b - begin) % grain == 0 &&
                                                     e == (std::min)(b + grain, begin + size);
                               for(std::size_t i = b; i < e; ++i)
                                 ++counts[i];
                             });
      CHECK(std::count(counts.begin(), counts.end(), 1) == static_cast<std::ptrdiff_t>(size));
      CHECK(std::count(is_chunk.begin(), is_chunk.end(), 1) ==
            static_cast<std::ptrdiff_t>((size + grain - 1) / grain));
    }
}

TEST_CASE("parallel_for_throws_what_the_first_chunk_throws", "[threads]") {
  const Thread_limit limit(3);
  for(bool is_parallel : {false, true})
    for(int repetition = 0; repetition < 20; ++repetition) {
      std::string what;
      try {
        internal::parallel_for(is_parallel, 0, 500, 1, [](std::size_t b, std::size_t) {
          if(b % 100 == 37)
            throw std::runtime_error(std::to_string(b));
        });
      } catch(const std::runtime_error& e) {
        what = e.what();
      }
      CHECK(what == "37");
    }
}

TEST_CASE("stable_sort_by_key_sorts", "[threads]") {
  std::mt19937_64 generator(17);
  for(std::size_t size : {0u, 1u, 2u, 1000u, 100000u})
    for(int bits : {1, 11, 12, 33, 63})
      for(bool is_parallel : {false, true}) {
        std::vector<std::pair<std::uint64_t, std::size_t>> values(size);
        for(std::size_t i = 0; i < size; ++i)
          values[i] = {generator() >> (64 - bits), i};
        auto expected = values;
        std::sort(expected.begin(), expected.end());
        internal::stable_sort_by_key(values, bits, is_parallel,
                                     [](const auto& v) { return v.first; });
        CHECK(values == expected);
      }
}

#ifdef CGAL_RESTRICTED_LAPLACIAN_3_HAS_LANES
TEST_CASE("vectors_compute_what_plain_code_computes", "[threads]") {
  if(!internal::processor_has_lanes())
    SKIP_TEST("the processor has no vectors of four numbers");
  namespace lanes = internal::lanes;
  namespace plain = internal::plain;
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::array<internal::Sheet_moments, 4> a, b;
  std::array<const internal::Sheet_moments*, 4> sheets;
  // largest difference, in units of the largest number
  const auto difference = [](const auto& p, const auto& q) {
    double result = 0, scale = 0;
    // blocks end with padding
    const std::size_t width = (std::min)(p.values[0].size(), std::size_t(378));
    for(std::size_t i = 0; i < p.values.size(); ++i)
      for(std::size_t k = 0; k < width; ++k) {
        result = (std::max)(result, std::abs(p.values[i][k] - q.values[i][k]));
        scale = (std::max)(scale, std::abs(p.values[i][k]));
      }
    return result / scale;
  };
  for(std::size_t lane = 0; lane < 4; ++lane) {
    a[lane].clear();
    b[lane].clear();
    sheets[lane] = &a[lane];
    for(std::size_t size = 3; size < 9; ++size) {
      RL::Fragment fragment;
      for(std::size_t i = 0; i < size; ++i) {
        const double angle = 6.28 * (static_cast<double>(i) + uniform(generator) / 2) / size;
        fragment.push_back({{2.5 + 0.4 * std::cos(angle), 3.5 + 0.4 * std::sin(angle),
                             4.1 + uniform(generator) / 2},
                            {0, 0, 0}});
      }
      const auto metric = RL::tangent_projector(RL::Vector_3(0.48, 0.6, 0.64));
      const int degree = lane % 2 == 0 ? 12 : 10;
      plain::add_fragment(fragment, {2, 3, 4}, metric, a[lane], 0.7, 1.3, degree);
      lanes::add_fragment(fragment, {2, 3, 4}, metric, b[lane], 0.7, 1.3, degree);
    }
    CHECK(difference(a[lane], b[lane]) <= 1e-15);
  }
  for(int octant = 0; octant < 8; ++octant) {
    internal::Sheet_moments p = a[1], q = a[1];
    plain::add_child_moments(a[0], octant, p);
    lanes::add_child_moments(a[0], octant, q);
    CHECK(difference(p, q) <= 1e-15);
  }
  internal::Packed_blocks p, q;
  plain::stiffness_blocks(sheets, p);
  lanes::stiffness_blocks(sheets, q);
  CHECK(difference(p, q) <= 1e-14);
  plain::mass_blocks(sheets, p);
  lanes::mass_blocks(sheets, q);
  CHECK(difference(p, q) <= 1e-15);

  for(std::size_t size : {internal::Moment_nodes::capacity, std::size_t(13)}) {
    internal::Moment_nodes nodes;
    nodes.size = size;
    for(std::size_t i = 0; i < size; ++i) {
      for(auto& coordinates : nodes.positions)
        coordinates[i] = 1.2 * uniform(generator) - 0.1;
      for(double& factor : nodes.factors[i])
        factor = uniform(generator);
    }
    internal::Sheet_moments of_plain = a[0], of_lanes = a[0];
    plain::add_moments(nodes, of_plain);
    lanes::add_moments(nodes, of_lanes);
    CHECK(difference(of_plain, of_lanes) <= 1e-15);
    CHECK(of_plain.sum(internal::Sheet_moments::area) >
          a[0].sum(internal::Sheet_moments::area) + 1);
  }

  for(const int degree : {4, 6, 8, 12}) {
    internal::Cell_patch patch;
    for(auto& control : patch.controls)
      control = {0.1 * uniform(generator), 0.1 * uniform(generator), 0.1 * uniform(generator)};
    patch.origin = {0.1, 0.2, 0.3};
    patch.u = {0.9, 0.1 * uniform(generator), -0.1};
    patch.v = {0.1, 0.8, 0.2 * uniform(generator)};
    patch.area_factor = 1.3;
    const internal::Patch_triangle triangle = {{{{0.1, 0.2}, {0.7, 0.1}, {0.2, 0.6}}}, 0.4};
    const internal::Padded_rule& rule = internal::Padded_rule::of_degree(degree);
    internal::Patch_nodes p = {}, q = {};
    plain::set_patch_nodes(patch, triangle, rule, p);
    lanes::set_patch_nodes(patch, triangle, rule, q);
    p.size = rule.size;
    p.padded_size = rule.padded_size();
    double largest = 0, area = 0;
    for(std::size_t i = 0; i < p.padded_size; ++i) {
      for(int axis = 0; axis < 3; ++axis) {
        largest = (std::max)(largest, std::abs(p.positions[axis][i] - q.positions[axis][i]));
        largest = (std::max)(largest, std::abs(p.normals[axis][i] - q.normals[axis][i]));
      }
      largest = (std::max)(largest, std::abs(p.weights[i] - q.weights[i]));
      largest = (std::max)(largest, std::abs(p.places[0][i] - q.places[0][i]));
      largest = (std::max)(largest, std::abs(p.places[1][i] - q.places[1][i]));
      area += p.weights[i];
    }
    CHECK(largest <= 1e-15);
    CHECK(area > 0.1);
    internal::Moment_nodes of_plain, of_lanes;
    RL::Symmetric_tensor_3 n = {}, m = {};
    plain::append(p, 0.7, of_plain, n);
    lanes::append(p, 0.7, of_lanes, m);
    CHECK(of_plain.size == rule.size);
    CHECK(of_lanes.size == rule.size);
    for(std::size_t i = 0; i < rule.size; ++i)
      for(int k = 0; k < internal::Sheet_moments::components; ++k)
        largest = (std::max)(largest, std::abs(of_plain.factors[i][k] - of_lanes.factors[i][k]));
    for(int k = 0; k < 6; ++k)
      largest = (std::max)(largest, std::abs(n[k] - m[k]));
    CHECK(largest <= 1e-15);
    CHECK(std::abs(n[0] + n[1] + n[2] - area) <= 1e-15);
  }

  internal::Node_positions positions;
  internal::Node_values values;
  for(std::size_t i = 0; i < values.size(); ++i) {
    for(auto& coordinates : positions)
      coordinates[i] = uniform(generator);
    values[i] = uniform(generator) - 0.5;
  }
  internal::Cell_load_sums of_plain = {}, of_lanes = {};
  plain::add_load(positions, values, of_plain);
  lanes::add_load(positions, values, of_lanes);
  for(int i = 0; i < 27; ++i)
    for(int lane = 0; lane < 4; ++lane)
      CHECK(std::abs(of_plain[i][lane] - of_lanes[i][lane]) <= 1e-15);

  for(const int degree : {5, 6, 7}) {
    std::array<std::array<double, 3>, 3> corners;
    for(auto& corner : corners)
      corner = {uniform(generator), uniform(generator), uniform(generator)};
    const std::array<double, 3> at_corners = {uniform(generator), -1, uniform(generator)};
    internal::Linear_load_nodes nodes_of_plain = internal::linear_load_nodes(corners, 1, degree),
                                nodes_of_lanes = nodes_of_plain;
    plain::set_linear_nodes(corners, 0.7, nodes_of_plain);
    lanes::set_linear_nodes(corners, 0.7, nodes_of_lanes);
    of_plain = of_lanes = {};
    plain::add_linear_load(nodes_of_plain, at_corners, of_plain);
    lanes::add_linear_load(nodes_of_lanes, at_corners, of_lanes);
    double sum = 0;
    for(int i = 0; i < 27; ++i)
      for(int lane = 0; lane < 4; ++lane) {
        CHECK(std::abs(of_plain[i][lane] - of_lanes[i][lane]) <= 1e-15);
        sum += of_lanes[i][lane];
      }
    // Bernstein polynomials sum to 1
    CHECK(sum == Approx(0.7 * (at_corners[0] + at_corners[1] + at_corners[2]) / 3));
  }
}

TEST_CASE("vectors_place_nodes_and_evaluate_splines_as_plain_code_does", "[threads]") {
  if(!internal::processor_has_lanes())
    SKIP_TEST("the processor has no vectors of four numbers");
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto random_numbers = [&](auto& numbers) {
    for(double& number : numbers)
      number = uniform(generator);
  };

  std::array<internal::Linear_values, 3> corners;
  for(internal::Linear_values& corner : corners)
    random_numbers(corner);
  RL::Surface_point point;
  point.face = 7;
  point.vertices = {3, 1, 4};
  point.normal = RL::Vector_3(0.48, 0.6, 0.64);
  const internal::Fragment_triangle triangle{
      {&corners[0], &corners[1], &corners[2]}, 0.3, point, RL::tangent_projector(point.normal)};
  for(int degree : {2, 5, 8, 12}) {
    const internal::Padded_rule& rule = internal::Padded_rule::of_degree(degree);
    // more triangles than fit in a block
    std::vector<RL::Integration_node_block> plain, lanes;
    const auto nodes_of = [&](auto&& add, std::vector<RL::Integration_node_block>& blocks) {
      const auto consumer = [&](RL::Integration_node_block& block) { blocks.push_back(block); };
      const RL::Integration_nodes::Consumer view(consumer);
      RL::Integration_nodes nodes(view);
      for(int i = 0; i < 15; ++i)
        add(nodes);
      nodes.flush();
    };
    nodes_of(
        [&](RL::Integration_nodes& nodes) {
          internal::plain::add_triangle_nodes(triangle, rule, nodes);
        },
        plain);
    nodes_of(
        [&](RL::Integration_nodes& nodes) {
          internal::lanes::add_triangle_nodes(triangle, rule, nodes);
        },
        lanes);
    const std::vector<RL::Triangle_quadrature_node>& expected = RL::triangle_quadrature(degree);
    std::size_t number = 0;
    for(const auto* blocks : {&plain, &lanes}) {
      number = 0;
      for(const RL::Integration_node_block& block : *blocks)
        for(std::size_t i = 0; i < block.size; ++i) {
          const auto& node = expected[number++ % expected.size()];
          CHECK(std::abs(block.weights[i] - 0.3 * node.weight) <= 1e-16);
          CHECK(block.metrics[i] == triangle.metric);
          CHECK(block.points[i].face == 7);
          CHECK(block.points[i].vertices == point.vertices);
          CHECK(block.points[i].normal == point.normal);
          for(int k = 0; k < 3; ++k) {
            const auto value = [&](int first) {
              return node.b0 * corners[0][first + k] + node.b1 * corners[1][first + k] +
                     node.b2 * corners[2][first + k];
            };
            CHECK(std::abs(block.positions[k][i] - value(0)) <= 1e-15);
            CHECK(std::abs(block.points[i].barycentric[k] - value(3)) <= 1e-15);
            CHECK(std::abs(block.points[i].point[k] - value(6)) <= 1e-15);
          }
        }
      CHECK(number == 15 * expected.size());
    }
  }

  RL::Tensor_basis_3::Values coefficients;
  random_numbers(coefficients);
  std::array<internal::Block_pieces<8>, 3> pieces;
  for(auto& of_axis : pieces)
    for(auto& piece : of_axis)
      random_numbers(piece);
  internal::Block_values<8> of_plain, of_lanes;
  internal::plain::tensor_sums<8>(coefficients, pieces[0], pieces[1], pieces[2], of_plain);
  internal::lanes::tensor_sums<8>(coefficients, pieces[0], pieces[1], pieces[2], of_lanes);
  for(std::size_t j = 0; j < 8; ++j) {
    double sum = 0;
    for(int z = 0; z < 3; ++z)
      for(int y = 0; y < 3; ++y)
        for(int x = 0; x < 3; ++x)
          sum += coefficients[RL::Tensor_basis_3::number(x, y, z)] * pieces[0][x][j] *
                 pieces[1][y][j] * pieces[2][z][j];
    CHECK(std::abs(of_plain[j] - sum) <= 1e-14);
    CHECK(std::abs(of_lanes[j] - sum) <= 1e-14);
  }
}
#endif

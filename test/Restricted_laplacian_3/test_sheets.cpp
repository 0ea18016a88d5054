// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Sheets and split elements: against a search by brute force, on shapes whose edges and faces lie
// in walls, and through what they do to spectra.

#include "catch.h"
#include "matrices.h"
#include "special_shapes.h"

#include <CGAL/Restricted_laplacian_3/laplace_spectrum.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>
#include <CGAL/Restricted_laplacian_3/solvers/galerkin_product.h>
#include <CGAL/Restricted_laplacian_3/splines/prolongation.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;
using shapes::Triangles;

RL::Spline_space_3 space_of(const Triangles& t, int depth, bool is_split = true,
                            std::optional<double> cube_scale = std::nullopt,
                            std::optional<double> joining_tolerance = std::nullopt) {
  RL::Spline_space_options options;
  options.depth = depth;
  options.split = is_split;
  options.cube_scale = cube_scale;
  options.joining_tolerance = joining_tolerance;
  return RL::Spline_space_3(RL::Triangulated_surface_3(t.points, t.faces), options);
}

/// the number of connected components of the faces, which are joined along common edges
std::size_t number_of_face_components(const Triangles& t) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::size_t>> edges;
  for(std::size_t f = 0; f < t.faces.size(); ++f)
    for(int side = 0; side < 3; ++side)
      edges[std::minmax(t.faces[f][side], t.faces[f][(side + 1) % 3])].push_back(f);
  std::vector<std::size_t> number(t.faces.size());
  for(std::size_t f = 0; f < number.size(); ++f)
    number[f] = f;
  for(bool changed = true; changed;) {
    changed = false;
    for(const auto& [edge, faces] : edges)
      for(std::size_t f : faces)
        if(number[f] > number[faces[0]] || number[f] < number[faces[0]]) {
          number[f] = number[faces[0]] = (std::min)(number[f], number[faces[0]]);
          changed = true;
        }
  }
  return std::set<std::size_t>(number.begin(), number.end()).size();
}

/// The number of elements of the finest level by the definition: for each box of 3 x 3 x 3 cells,
/// clip every triangle to the box, and join those that share an edge of which the open box
/// contains more than a point. For surfaces in general position only.
std::size_t number_of_elements(const RL::Octree_3& octree, const Triangles& t) {
  const int n = 1 << octree.depth();
  std::vector<std::array<double, 3>> points;
  for(const RL::Point_3& p : t.points)
    points.push_back(octree.grid_coordinates(octree.depth(), p));
  const auto runs_in_box = [&](std::uint32_t a, std::uint32_t b, const std::array<int, 3>& center) {
    double t0 = 0, t1 = 1;
    for(int axis = 0; axis < 3; ++axis) {
      const double d = points[b][axis] - points[a][axis];
      const double u = (center[axis] - 1 - points[a][axis]) / d,
                   v = (center[axis] + 2 - points[a][axis]) / d;
      t0 = (std::max)(t0, (std::min)(u, v));
      t1 = (std::min)(t1, (std::max)(u, v));
    }
    return t0 + 1e-12 < t1;
  };
  std::size_t result = 0;
  std::array<int, 3> center;
  for(center[0] = -1; center[0] <= n; ++center[0])
    for(center[1] = -1; center[1] <= n; ++center[1])
      for(center[2] = -1; center[2] <= n; ++center[2]) {
        std::vector<std::array<std::uint32_t, 3>> in_box;
        for(const auto& f : t.faces) {
          // the part of the triangle in the box: clip to a grid whose cell is the box
          std::array<std::array<double, 3>, 3> corners;
          for(int i = 0; i < 3; ++i)
            for(int axis = 0; axis < 3; ++axis)
              corners[i][axis] = (points[f[i]][axis] - center[axis] + 1) / 3 + 1000;
          if(RL::Cell_clipper(2000, 0).fragment(corners, {1000, 1000, 1000}).double_area() < 1e-20)
            continue;
          in_box.push_back(f);
        }
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> first_face;
        std::vector<std::size_t> number(in_box.size());
        for(std::size_t f = 0; f < number.size(); ++f) {
          number[f] = f;
          for(int side = 0; side < 3; ++side) {
            const auto edge = std::minmax(in_box[f][side], in_box[f][(side + 1) % 3]);
            if(!runs_in_box(edge.first, edge.second, center))
              continue;
            const auto [it, is_new] = first_face.insert({edge, f});
            const std::size_t from = number[it->second], to = number[f];
            for(std::size_t g = 0; g <= f; ++g)
              if(number[g] == from)
                number[g] = to;
          }
        }
        result += std::set<std::size_t>(number.begin(), number.end()).size();
      }
  return result;
}

Triangles rotated(Triangles t) {
  // no edge stays parallel to an axis
  const RL::Vector_3 x(0.36, 0.48, -0.8), y(-0.8, 0.6, 0), z(0.48, 0.64, 0.6);
  for(RL::Point_3& p : t.points) {
    const RL::Vector_3 v(p.x() + 0.1234567, p.y() + 0.0345678, p.z() + 0.0567891);
    p = CGAL::ORIGIN + RL::Vector_3(x * v, y * v, z * v);
  }
  return t;
}

/// two parallel squares of side 1 at distance `gap`, joined along one side
Triangles folded_strip(double gap, int n) {
  Triangles t;
  const auto add_square = [&](double z) {
    const auto first = static_cast<std::uint32_t>(t.points.size());
    for(int j = 0; j <= n; ++j)
      for(int i = 0; i <= n; ++i)
        t.points.emplace_back(double(i) / n, double(j) / n, z);
    const std::uint32_t m = n + 1;
    for(int j = 0; j < n; ++j)
      for(int i = 0; i < n; ++i) {
        const std::uint32_t a = first + j * m + i;
        t.faces.push_back({a, a + 1, a + m + 1});
        t.faces.push_back({a, a + m + 1, a + m});
      }
    return first;
  };
  const std::uint32_t low = add_square(0), high = add_square(gap);
  for(int i = 0; i < n; ++i) {
    const std::uint32_t a = low + i, b = high + i;
    t.faces.push_back({a, b, a + 1});
    t.faces.push_back({a + 1, b, b + 1});
  }
  return t;
}

/// prism over a regular polygon, its axis along z
Triangles prism(int sides, double radius, double height) {
  Triangles t;
  const auto n = static_cast<std::uint32_t>(sides);
  for(std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * CGAL_PI * i / n;
    t.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), -height / 2);
    t.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height / 2);
  }
  t.points.emplace_back(0, 0, -height / 2);
  t.points.emplace_back(0, 0, height / 2);
  for(std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    t.faces.push_back({2 * i, 2 * j, 2 * j + 1});
    t.faces.push_back({2 * i, 2 * j + 1, 2 * i + 1});
    t.faces.push_back({2 * n, 2 * j, 2 * i});
    t.faces.push_back({2 * n + 1, 2 * i + 1, 2 * j + 1});
  }
  return t;
}

/// A rotor with `blades` thin blades around a hub, all edges of whose mid-plane z = 0 exist as
/// edges of the mesh: that plane is a wall at all depths.
Triangles rotor(int blades, double thickness) {
  // outline: hub corner, out along a blade, back, next hub corner
  std::vector<std::array<double, 2>> outline;
  for(int i = 0; i < blades; ++i) {
    const double angle = 2 * CGAL_PI * i / blades, c = std::cos(angle), s = std::sin(angle);
    const auto add = [&](double r, double w) { outline.push_back({r * c - w * s, r * s + w * c}); };
    const double w = thickness / 2;
    add(0.3, -w);
    add(1, -w);
    add(1, w);
    add(0.3, w);
  }
  Triangles t;
  const auto n = static_cast<std::uint32_t>(outline.size());
  for(double z : {-0.2, 0., 0.2})
    for(const auto& p : outline)
      t.points.emplace_back(p[0], p[1], z);
  for(std::uint32_t layer = 0; layer < 2; ++layer)
    for(std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = layer * n + i, b = layer * n + (i + 1) % n;
      t.faces.push_back({a, b, b + n});
      t.faces.push_back({a, b + n, a + n});
    }
  for(double z : {-0.2, 0.2}) {
    const auto center = static_cast<std::uint32_t>(t.points.size());
    t.points.emplace_back(0, 0, z);
    const std::uint32_t first = z < 0 ? 0 : 2 * n;
    for(std::uint32_t i = 0; i < n; i += 4) {
      t.faces.push_back({first + i, first + i + 1, first + i + 2});
      t.faces.push_back({first + i, first + i + 2, first + i + 3});
      t.faces.push_back({center, first + i, first + i + 3});
      t.faces.push_back({center, first + i + 3, first + (i + 4) % n});
    }
  }
  return t;
}

Eigen::VectorXd eigenvalues(const RL::Spline_space_3& space, int count) {
  const RL::Laplace_spectrum spectrum = RL::laplace_spectrum(space, count);
  CHECK(spectrum.report.converged);
  return spectrum.eigenvalues;
}

/// largest relative difference of all but the first eigenvalue
double largest_difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  REQUIRE(a.size() == b.size());
  return ((a - b).cwiseAbs().array() / b.cwiseAbs().array()).tail(a.size() - 1).maxCoeff();
}

/// identities that hold whatever the surface, on all levels of a split space
void check_identities(const RL::Spline_space_3& space) {
  std::vector<RL::Operators> operators = RL::assemble_operators_of_levels(space, 0, space.depth());
  for(int level = 0; level <= space.depth(); ++level) {
    const RL::Operators& o = operators[level];
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(space.dimension(level));
    CHECK(ones.dot(o.mass * ones) == Approx(space.surface().area()).epsilon(1e-12));
    CHECK((o.stiffness * ones).cwiseAbs().maxCoeff() <= 1e-13 * o.stiffness.diagonal().maxCoeff());
    if(level == space.depth())
      break;
    const RL::Sparse_matrix p = RL::prolongation_matrix(space, level);
    const RL::Operators& fine = operators[level + 1];
    CHECK(relative_difference(RL::galerkin_product(fine.stiffness, p), o.stiffness) <= 1e-12);
    CHECK(relative_difference(RL::galerkin_product(fine.mass, p), o.mass) <= 1e-12);
  }
}

} // namespace

TEST_CASE("split_elements_are_those_of_the_definition", "[sheets]") {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  Triangles soup;
  for(int i = 0; i < 40; ++i)
    soup.points.emplace_back(uniform(generator), uniform(generator), uniform(generator));
  for(int i = 0; i < 25; ++i) {
    std::array<std::uint32_t, 3> f;
    do
      for(std::uint32_t& v : f)
        v = generator() % 40;
    while(f[0] == f[1] || f[1] == f[2] || f[2] == f[0]);
    soup.faces.push_back(f);
  }
  const std::vector<std::pair<std::string, Triangles>> surfaces = {
      {"soup", soup},
      {"sphere", rotated(shapes::sphere(2))},
      {"folded strip", rotated(folded_strip(0.07, 4))},
      {"rotor", rotated(rotor(5, 0.06))},
      {"two boxes",
       shapes::joined(rotated(shapes::box(1, 1, 1, 2, 1)),
                      rotated(shapes::moved(shapes::box(1, 1, 1, 1, 2), {1.03, 0, 0})))}};
  for(const auto& [name, t] : surfaces)
    for(int depth = 1; depth <= 4; ++depth) {
      INFO(name << ", depth " << depth);
      const RL::Spline_space_3 space = space_of(t, depth);
      CHECK(space.dimension() == number_of_elements(space.octree(), t));
      CHECK(space.octree().number_of_sheets(0) == number_of_face_components(t));
    }
}

TEST_CASE("levels_of_a_split_space_equal_spaces_of_that_depth", "[sheets]") {
  const std::vector<std::pair<std::string, Triangles>> surfaces = {
      {"rotor", rotor(6, 0.05)},
      {"rotated rotor", rotated(rotor(6, 0.05))},
      {"folded strip", folded_strip(0.03, 5)},
      {"box", shapes::box(1, 1, 0.05, 3, 1)},
      {"stairs", shapes::stairs(8, 0.1)}};
  for(const auto& [name, t] : surfaces) {
    INFO(name);
    const RL::Spline_space_3 deep = space_of(t, 5);
    check_identities(deep);
    for(int depth = 1; depth < 5; ++depth) {
      const RL::Spline_space_3 shallow = space_of(t, depth);
      REQUIRE(shallow.octree().number_of_sheets(depth) == deep.octree().number_of_sheets(depth));
      REQUIRE(shallow.dimension() == deep.dimension(depth));
      for(std::size_t i = 0; i < shallow.dimension(); ++i)
        REQUIRE(shallow.slot(depth, i) == deep.slot(depth, i));
      CHECK(shallow.number_of_split_elements(depth) == deep.number_of_split_elements(depth));
    }
  }
}

TEST_CASE("elements_of_a_cell_of_any_level_have_consecutive_numbers", "[sheets]") {
  // The cube of scale 1 touches the surface, so there are elements outside the grid on all sides.
  const RL::Spline_space_3 space = space_of(rotor(5, 0.06), 5, true, 1);
  const auto nearest_cell = [&](int level, std::size_t element) {
    RL::Cell_3 cell = space.center(level, element);
    for(int& x : cell.index)
      x = (std::min)((std::max)(x, 0), (1 << level) - 1);
    return cell;
  };
  for(int level = 1; level <= 5; ++level) {
    INFO("level " << level);
    std::size_t number_outside = 0;
    for(std::size_t i = 0; i < space.dimension(level); ++i) {
      number_outside += !space.center(level, i).is_inside_grid();
      if(i > 0)
        REQUIRE(nearest_cell(level, i - 1).key() <= nearest_cell(level, i).key());
    }
    CHECK(number_outside > 0);
    CHECK(number_outside < space.dimension(level));
  }
}

TEST_CASE("splitting_does_not_depend_on_the_triangulation", "[sheets]") {
  const auto check_same = [](const Triangles& a, const Triangles& b, int depth) {
    for(double cube_scale : {1., 1.1, 2.}) {
      INFO("depth " << depth << ", cube scale " << cube_scale);
      const RL::Spline_space_3 x = space_of(a, depth, true, cube_scale),
                               y = space_of(b, depth, true, cube_scale);
      REQUIRE(x.octree().number_of_sheets(depth) == y.octree().number_of_sheets(depth));
      REQUIRE(x.dimension() == y.dimension());
      REQUIRE(x.number_of_split_elements(depth) == y.number_of_split_elements(depth));
      const RL::Operators s = RL::assemble_operators(x), t = RL::assemble_operators(y);
      CHECK(relative_difference(s.stiffness, t.stiffness) <= 1e-10);
      CHECK(relative_difference(s.mass, t.mass) <= 1e-10);
    }
  };
  for(int depth = 2; depth <= 4; ++depth) {
    for(const Triangles& t :
        {rotor(6, 0.05), rotated(rotor(6, 0.05)), folded_strip(0.03, 2), prism(6, 1, 0.1)})
      check_same(t, shapes::split_in_four(shapes::split_in_four(t)), depth);
    for(unsigned seed = 2; seed <= 4; ++seed)
      check_same(shapes::box(1, 1, 0.05, 4, 1), shapes::box(1, 1, 0.05, 4, seed), depth);
    check_same(shapes::box(1, 1, 0.05, 1, 1), shapes::box(1, 1, 0.05, 4, 5), depth);
  }
}

TEST_CASE("edges_and_faces_in_walls_tear_nothing", "[sheets][slow]") {
  // In these positions edges, vertices or whole faces lie in walls at all depths. The spectrum has
  // to be that of the same shape in a general position, up to the error of discretization.
  struct Case {
    std::string name;
    Triangles triangles;
    double tolerance;
  };
  const std::vector<Case> cases = {{"box", shapes::box(1, 1, 1, 2, 1), 0.02},
                                   {"flat box", shapes::box(1, 1, 0.25, 4, 1), 0.02},
                                   {"prism", prism(6, 1, 0.5), 0.02},
                                   {"rotor", rotor(4, 0.25), 0.04}};
  for(const auto& [name, t, tolerance] : cases) {
    // A tiny triangle besides the shape moves the center of the bounding box, and so the walls. It
    // adds one eigenvalue 0 and else only very large ones.
    double high[3] = {0, 0, 0};
    for(const RL::Point_3& p : t.points)
      for(int axis = 0; axis < 3; ++axis)
        high[axis] = (std::max)(high[axis], p[axis]);
    const RL::Point_3 beside(high[0] + 0.0377, high[1] + 0.0531, high[2] + 0.0711);
    const Triangles shifted = shapes::joined(
        t, {{beside, beside + RL::Vector_3(1e-3, 0, 0), beside + RL::Vector_3(0, 1e-3, 0)},
            {{0, 1, 2}}});
    for(double cube_scale : {1., 2.})
      for(int depth = 2; depth <= 5; ++depth) {
        INFO(name << ", depth " << depth << ", cube scale " << cube_scale);
        const RL::Spline_space_3 space = space_of(t, depth, true, cube_scale);
        check_identities(space);
        CHECK(space.octree().number_of_sheets(0) == 1);
        if(depth < 5 || cube_scale != 1)
          continue;
        const Eigen::VectorXd a = eigenvalues(space, 12),
                              b = eigenvalues(space_of(shifted, depth), 13).tail(12);
        INFO(a.transpose() << "\n" << b.transpose());
        CHECK(largest_difference(a, b) <= tolerance);
      }
  }
}

TEST_CASE("surface_along_diagonals_of_cells_is_not_torn", "[sheets]") {
  // In the plane x = y only cells that share an edge follow each other, none that share a wall.
  const Triangles t = {{{0, 0, 0}, {1, 1, 0}, {1, 1, 1}, {0, 0, 1}}, {{0, 1, 2}, {0, 2, 3}}};
  for(double cube_scale : {1., 2.})
    for(int depth = 1; depth <= 5; ++depth) {
      INFO("depth " << depth << ", cube scale " << cube_scale);
      const RL::Spline_space_3 space = space_of(t, depth, true, cube_scale);
      CHECK(space.octree().number_of_sheets(0) == 1);
      if(depth >= 3)
        CHECK(eigenvalues(space, 2)[1] == Approx(CGAL_PI * CGAL_PI / 2).epsilon(1e-3));
    }
}

namespace {

/// a polyline in the plane z = 0, swept along z from 0 to 1 and rotated
Triangles swept(const std::vector<std::array<double, 2>>& profile, bool is_closed, int n) {
  Triangles t;
  const auto m = static_cast<std::uint32_t>(profile.size());
  for(int j = 0; j <= n; ++j)
    for(const auto& p : profile)
      t.points.emplace_back(p[0], p[1], double(j) / n);
  for(std::uint32_t j = 0; j < static_cast<std::uint32_t>(n); ++j)
    for(std::uint32_t i = 0; i + (is_closed ? 0 : 1) < m; ++i) {
      const std::uint32_t a = j * m + i, b = j * m + (i + 1) % m;
      t.faces.push_back({a, b, b + m});
      t.faces.push_back({a, b + m, a + m});
    }
  return rotated(t);
}

double length(const std::vector<std::array<double, 2>>& profile, bool is_closed) {
  double sum = 0;
  for(std::size_t i = is_closed ? 0 : 1; i < profile.size(); ++i) {
    const auto &p = profile[i], &q = profile[i == 0 ? profile.size() - 1 : i - 1];
    sum += std::hypot(p[0] - q[0], p[1] - q[1]);
  }
  return sum;
}

/// Folding a rectangle of sides `length` and 1 does not change its spectrum, nor does rolling it up
/// to a tube, which identifies two sides; the ends have the natural condition.
Eigen::VectorXd exact_eigenvalues(double length, bool is_closed, int count) {
  std::vector<double> values;
  for(int m = 0; m < 40; ++m)
    for(int n = 0; n < 40; ++n) {
      const double wave = CGAL_PI * m / length * (is_closed ? 2 : 1);
      values.insert(values.end(), is_closed && m > 0 ? 2 : 1,
                    wave * wave + CGAL_PI * CGAL_PI * n * n);
    }
  std::sort(values.begin(), values.end());
  return Eigen::Map<const Eigen::VectorXd>(values.data(), count);
}

} // namespace

TEST_CASE("near_layers_have_the_spectrum_of_the_unfolded_surface", "[sheets][slow]") {
  const int depth = 5, count = 20;
  const double h = 1.1 / 32; // about
  for(double gap : {h, h / 4, h / 16}) {
    INFO("gap " << gap / h << " h");
    // a tube pressed flat, and a band rolled up twice
    const std::vector<std::array<double, 2>> flat = {{0, 0}, {1, 0}, {1, gap}, {0, gap}};
    std::vector<std::array<double, 2>> spiral;
    for(int i = 0; i <= 160; ++i) {
      const double angle = 4 * CGAL_PI * i / 160, r = 0.4 + gap * angle / (2 * CGAL_PI);
      spiral.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    for(bool is_closed : {true, false}) {
      const auto& profile = is_closed ? flat : spiral;
      const Triangles t = swept(profile, is_closed, 2);
      const Eigen::VectorXd exact = exact_eigenvalues(length(profile, is_closed), is_closed, count);
      const Eigen::VectorXd split = eigenvalues(space_of(t, depth), count);
      INFO(split.transpose() << "\n" << exact.transpose());
      CHECK(largest_difference(split, exact) <= (is_closed ? 0.006 : 1e-4));
      if(!is_closed) {
        // without splitting the turns of the spiral are one
        const Eigen::VectorXd unsplit = eigenvalues(space_of(t, depth, false), count);
        CHECK(largest_difference(unsplit, exact) >= 0.5);
      }
    }
  }
}

TEST_CASE("thin_blades_of_a_rotor", "[sheets][slow]") {
  const shapes::Mesh mesh = shapes::read(cgal_mesh("rotor_small.off"));
  if(mesh.is_empty())
    SKIP_TEST("no such file: rotor_small.off");
  const Triangles t = shapes::triangles(mesh),
                  fine = shapes::split_in_four(shapes::split_in_four(t));
  const int count = 41;
  const Eigen::VectorXd reference = RL::cotangent_spectrum(shapes::mesh(fine), count).eigenvalues;
  const Eigen::VectorXd split = eigenvalues(space_of(t, 4), count);
  CHECK(largest_difference(split, reference) <= 0.02);
  CHECK(largest_difference(eigenvalues(space_of(t, 4, false), count), reference) >= 0.5);
}

TEST_CASE("pulley_and_turbine", "[sheets][slow]") {
  struct Case {
    std::string file;
    int depth;
    std::size_t dimension;
    std::vector<double> eigenvalues; // times area, from an independent prototype
  };
  const std::vector<Case> cases = {
      {"pulley_28k.ply",
       5,
       22740,
       {22.33, 29.06, 29.06, 53.06, 53.09, 63.75, 75.67, 75.68, 97.86, 111.9}},
      {"turbine_18k.ply",
       6,
       24916,
       {19.096, 19.096, 63.93, 63.93, 78.29, 97.66, 106.43, 106.43, 122.71, 122.75}}};
  for(const Case& c : cases) {
    const shapes::Mesh mesh = shapes::read(shared_mesh(c.file));
    if(mesh.is_empty())
      SKIP_TEST("no such file: " << c.file);
    const RL::Spline_space_3 space(mesh, params::depth(c.depth));
    CHECK(space.dimension() == c.dimension);
    const Eigen::VectorXd values = eigenvalues(space, 11) * space.surface().area();
    for(std::size_t i = 0; i < c.eigenvalues.size(); ++i)
      CHECK(values[i + 1] == Approx(c.eigenvalues[i]).epsilon(1e-3));
  }
}

TEST_CASE("shapes_without_near_parts_keep_their_spectrum", "[sheets][slow]") {
  std::vector<std::pair<std::string, Triangles>> surfaces = {{"sphere", shapes::sphere(5)}};
  for(const char* file : {"bunny00.off", "fandisk.off"}) {
    const shapes::Mesh mesh = shapes::read(cgal_mesh(file));
    if(mesh.is_empty())
      SKIP_TEST("no such file: " << file);
    surfaces.emplace_back(file, shapes::triangles(mesh));
  }
  for(const auto& [name, t] : surfaces) {
    INFO(name);
    const RL::Spline_space_3 split = space_of(t, 5), unsplit = space_of(t, 5, false);
    CHECK(split.dimension() >= unsplit.dimension());
    CHECK(split.dimension() <= 1.15 * unsplit.dimension());
    CHECK(largest_difference(eigenvalues(split, 30), eigenvalues(unsplit, 30)) <= 1e-3);
  }
}

TEST_CASE("splitting_costs_no_iterations", "[sheets][slow]") {
  const shapes::Mesh mesh = shapes::read(cgal_mesh("bunny00.off"));
  if(mesh.is_empty())
    SKIP_TEST("no such file: bunny00.off");
  for(int axis = 0; axis < 3; ++axis) {
    int iterations[2];
    for(bool is_split : {false, true}) {
      const RL::Spline_space_3 space(mesh, params::depth(5).split(is_split));
      const RL::Poisson_solver solver(space, RL::assemble_operators(space), 0,
                                      params::tolerance(5e-3));
      Eigen::VectorXd eta;
      const RL::Solve_report report = solver.solve(
          RL::assemble_load(space, [axis](const RL::Surface_point& p) { return p.point[axis]; }),
          eta);
      CHECK(report.converged);
      iterations[is_split] = report.iterations;
    }
    CHECK(iterations[1] <= iterations[0] + 2);
  }
}

TEST_CASE("space_of_the_paper_is_not_split", "[sheets]") {
  const shapes::Mesh mesh = shapes::mesh(rotor(6, 0.05));
  const RL::Spline_space_3 space(mesh, params::depth(4).paper(true).split(true));
  CHECK_FALSE(space.is_split());
  CHECK(space.number_of_split_elements(4) == 0);
  CHECK(space.octree().number_of_sheets(4) == space.octree().number_of_cells(4));
}

TEST_CASE("results_follow_the_surface_when_it_is_moved", "[sheets][slow]") {
  const Triangles t = rotated(rotor(5, 0.08));
  const RL::Spline_space_3 space = space_of(t, 5);
  const RL::Operators operators = RL::assemble_operators(space);
  const Eigen::VectorXd values = eigenvalues(space, 15);
  // scaling: to rounding; the stiffness matrix has no unit, the mass matrix that of area
  for(double factor : {1e-6, 0.37, 3., 1e9}) {
    INFO("factor " << factor);
    const RL::Spline_space_3 scaled = space_of(shapes::scaled(t, factor), 5);
    REQUIRE(scaled.dimension() == space.dimension());
    CHECK(scaled.number_of_split_elements(5) == space.number_of_split_elements(5));
    const RL::Operators of_scaled = RL::assemble_operators(scaled);
    CHECK(relative_difference(of_scaled.stiffness, operators.stiffness) <= 1e-11);
    CHECK(relative_difference(of_scaled.mass / (factor * factor), operators.mass) <= 1e-11);
  }
  // translation: the domain cube moves along, so to the rounding of the coordinates
  for(double distance : {10., 1e6}) {
    INFO("distance " << distance);
    const RL::Spline_space_3 moved =
        space_of(shapes::moved(t, {distance, 0.7 * distance, -0.3 * distance}), 5);
    CHECK(moved.octree().number_of_sheets(0) == 1);
    CHECK(largest_difference(eigenvalues(moved, 15), values) <= 1e-12 * distance + 1e-8);
  }
  // rotation: to the error of discretization
  CHECK(largest_difference(eigenvalues(space_of(rotated(t), 5), 15), values) <= 0.02);
  CHECK(largest_difference(eigenvalues(space_of(rotor(5, 0.08), 5), 15), values) <= 0.02);
}

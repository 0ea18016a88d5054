// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The octree against plain searches, and its levels against each other.

#include "catch.h"
#include "special_shapes.h"
#include "test_meshes.h"

#include <CGAL/Restricted_laplacian_3/basis/B_spline_1.h>
#include <CGAL/Restricted_laplacian_3/input/vertex_functions.h>
#include <CGAL/Restricted_laplacian_3/octree/Octree_3.h>
#include <CGAL/Restricted_laplacian_3/octree/Surface_windows.h>
#include <CGAL/Restricted_laplacian_3/octree/internal/Grid_vertices.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_seams.h>
#include <CGAL/Restricted_laplacian_3/surface/sample_surface.h>

#include <CGAL/assertions.h>
#include <CGAL/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;

/// Calls `check(octree)` for surfaces in general position, and for some all of whose faces, edges
/// or vertices lie in walls.
template <class Check> void for_each_octree(Check&& check) {
  const auto run = [&check](const std::string& name, const shapes::Triangles& t, int depth,
                            double cube_scale) {
    INFO(name << ", depth " << depth << ", cube scale " << cube_scale);
    check(RL::Octree_3(RL::Triangulated_surface_3(t.points, t.faces), depth, cube_scale));
  };
  run("sphere", shapes::sphere(3), 5, 1.1);
  run("octahedron", shapes::sphere(0), 6, 1);
  for(double cube_scale : {1., 1.1, 2.}) {
    run("box", shapes::box(1, 1, 1, 3, 1), 4, cube_scale);
    run("flat box", shapes::box(1, 0.5, 0.25, 4, 1), 5, cube_scale);
    run("stairs", shapes::stairs(8, 0.1), 3, cube_scale);
    run("stairs", shapes::stairs(8, 0.1), 6, cube_scale);
    run("square", shapes::rectangle(1, 1), 5, cube_scale);
  }
  run("triangle", {{{0, 0, 0}, {1, 0.3, 0.2}, {0.1, 1, 0.4}}, {{0, 1, 2}}}, 6, 1.1);
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  shapes::Triangles soup, needles;
  for(std::uint32_t i = 0; i < 60; ++i) {
    for(int corner = 0; corner < 3; ++corner) {
      soup.points.emplace_back(uniform(generator), uniform(generator), uniform(generator));
      needles.points.push_back(corner < 2 ? soup.points.back()
                                          : needles.points.back() + RL::Vector_3(0, 0, 1e-7));
    }
    soup.faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  needles.faces = soup.faces;
  run("soup", soup, 5, 1.1);
  run("needles", needles, 6, 1.2);
}

std::array<std::array<double, 3>, 3> grid_triangle(const RL::Octree_3& octree, std::size_t face) {
  std::array<std::array<double, 3>, 3> corners;
  for(int i = 0; i < 3; ++i)
    corners[i] = octree.grid_coordinates(octree.depth(), octree.surface().point(face, i));
  return corners;
}

/// The mean of the corners of a fragment, in the local coordinate of the cell of `level` that
/// contains it. A convex polygon lies in a wall if and only if this point does.
std::array<double, 3> center(const RL::Fragment& fragment, const RL::Cell_3& cell, int depth) {
  std::array<double, 3> t = {0, 0, 0};
  for(std::size_t i = 0; i < fragment.size; ++i)
    for(int axis = 0; axis < 3; ++axis)
      t[axis] +=
          std::ldexp(fragment.corners[i].position[axis], cell.level - depth) - cell.index[axis];
  for(double& x : t)
    x /= fragment.size;
  return t;
}

/// every face has its own vertices, a little away from where they were
shapes::Triangles torn(const shapes::Triangles& t) {
  shapes::Triangles pieces;
  for(const auto& face : t.faces)
    for(const std::uint32_t v : face) {
      const double i = static_cast<double>(pieces.points.size());
      pieces.points.push_back(t.points[v] +
                              1e-6 * RL::Vector_3(std::sin(i), std::sin(2 * i), std::sin(3 * i)));
    }
  for(std::uint32_t i = 0; i < pieces.points.size(); i += 3)
    pieces.faces.push_back({i, i + 1, i + 2});
  return pieces;
}

/// the finest cells that a window is asked about
struct Grid {
  RL::internal::Grid_vertices vertices;
  RL::Cell_clipper clipper;
};

Grid grid_of(const RL::Octree_3& octree) {
  const int depth = octree.depth();
  const RL::Cell_clipper clipper(1 << depth, octree.wall_tolerance(depth));
  return {{octree.surface(), {octree.surface().center(), octree.side()}, depth, clipper}, clipper};
}

std::vector<std::uint32_t> faces_of(const RL::Surface_windows& windows, std::size_t window) {
  std::vector<std::uint32_t> faces;
  for(std::size_t i = 0; i < windows.faces(window).size(); ++i)
    faces.push_back(static_cast<std::uint32_t>(windows.faces(window)[i]));
  return faces;
}

void require_equal(const RL::Octree_3& a, const RL::Octree_3& b) {
  for(int level = a.depth(); level >= 0; --level) {
    REQUIRE(a.number_of_cells(level) == b.number_of_cells(level));
    REQUIRE(a.number_of_sheets(level) == b.number_of_sheets(level));
    const auto is_equal = [&](std::size_t sheet) {
      for(int k = 0; k < 27; ++k) {
        const std::array<int, 3> d = {k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1};
        if(a.meets_element(level, sheet, d[0], d[1], d[2]) !=
           b.meets_element(level, sheet, d[0], d[1], d[2]))
          return false;
      }
      return a.cell(level, sheet) == b.cell(level, sheet) &&
             a.links(level, sheet) == b.links(level, sheet) &&
             (level == 0 || a.parent(level, sheet) == b.parent(level, sheet)) &&
             (level == a.depth() ? a.faces(sheet) == b.faces(sheet)
                                 : a.children(level, sheet) == b.children(level, sheet));
    };
    std::size_t number_of_equal_sheets = 0;
    for(std::size_t sheet = 0; sheet < a.number_of_sheets(level); ++sheet)
      number_of_equal_sheets += is_equal(sheet);
    REQUIRE(number_of_equal_sheets == a.number_of_sheets(level));
  }
}

} // namespace

TEST_CASE("domain_cube_is_centered_on_the_bounding_box", "[octree]") {
  for_each_octree([](const RL::Octree_3& octree) {
    const RL::Triangulated_surface_3& surface = octree.surface();
    CHECK(octree.cell_width(0) == octree.side());
    for(int level = 0; level <= octree.depth(); ++level) {
      CHECK(octree.cell_width(level) == octree.side() / (1 << level));
      double least = 1 << level, largest = 0;
      for(int axis = 0; axis < 3; ++axis) {
        const double low = octree.grid_coordinates(level, surface.bounding_box_min())[axis],
                     high = octree.grid_coordinates(level, surface.bounding_box_max())[axis];
        CHECK(low + high == Approx(1 << level).epsilon(1e-15));
        least = (std::min)(least, low);
        largest = (std::max)(largest, high);
      }
      const double cube_scale = octree.side() / surface.extent();
      CHECK(largest - least == Approx((1 << level) / cube_scale).epsilon(1e-14));
    }
    // coordinates of a level are exactly twice those of the next coarser one
    for(std::size_t v = 0; v < surface.number_of_vertices(); ++v)
      for(int axis = 0; axis < 3; ++axis)
        REQUIRE(octree.grid_coordinates(octree.depth(), surface.point(v))[axis] ==
                std::ldexp(octree.grid_coordinates(0, surface.point(v))[axis], octree.depth()));
  });
}

TEST_CASE("cells_and_their_faces_are_those_of_the_fragments", "[octree]") {
  for_each_octree([](const RL::Octree_3& octree) {
    const int depth = octree.depth();
    const RL::Cell_clipper clipper(1 << depth, octree.wall_tolerance(depth));
    std::map<std::uint64_t, std::vector<std::uint32_t>> expected;
    for(std::size_t face = 0; face < octree.surface().number_of_faces(); ++face)
      if(!octree.surface().is_degenerate(face))
        clipper(grid_triangle(octree, face),
                [&](const std::array<int, 3>& cell, const RL::Fragment&) {
                  expected[RL::morton_key(cell)].push_back(static_cast<std::uint32_t>(face));
                });
    REQUIRE(octree.number_of_cells(depth) == expected.size());
    std::size_t i = 0, number_of_fragments = 0, next_sheet = 0;
    double area = 0;
    for(const auto& [key, faces] : expected) {
      const auto [first, last] = octree.sheets(depth, i);
      REQUIRE(first == next_sheet);
      REQUIRE(first < last);
      next_sheet = last;
      const RL::Cell_3 cell = octree.cell(depth, first);
      REQUIRE(cell.level == depth);
      REQUIRE(cell.key() == key);
      std::vector<std::uint32_t> found;
      for(std::size_t sheet = first; sheet < last; ++sheet) {
        REQUIRE(octree.cell(depth, sheet) == cell);
        REQUIRE(std::is_sorted(octree.faces(sheet).begin(), octree.faces(sheet).end()));
        for(std::uint32_t face : octree.faces(sheet)) {
          REQUIRE(octree.sheet_of_face(i, face) == sheet);
          found.push_back(face);
        }
      }
      std::sort(found.begin(), found.end());
      REQUIRE(found == faces);
      for(std::uint32_t face : faces)
        area += octree.fragment(cell, face).double_area() / 2;
      number_of_fragments += faces.size();
      ++i;
    }
    CHECK(octree.number_of_sheets(depth) == next_sheet);
    CHECK(octree.number_of_fragments() == number_of_fragments);
    const double h = octree.cell_width(depth);
    CHECK(area * h * h == Approx(octree.surface().area()).epsilon(1e-12).margin(1e-14));
  });
}

TEST_CASE("points_of_the_surface_lie_in_cells", "[octree]") {
  for_each_octree([](const RL::Octree_3& octree) {
    const int depth = octree.depth();
    for(const RL::Surface_location& location : RL::sample_surface(octree.surface(), 2000, 1)) {
      const auto x = octree.grid_coordinates(depth, octree.surface().surface_point(location).point);
      // of the cells that touch the point, one has a fragment of its face
      bool is_found = false;
      for(int i = 0; i < 8; ++i) {
        RL::Cell_3 cell{depth, {}};
        for(int axis = 0; axis < 3; ++axis)
          cell.index[axis] = static_cast<int>(std::floor(x[axis] + (i >> axis & 1 ? 1e-9 : -1e-9)));
        const std::size_t number = octree.find(cell);
        if(number == octree.number_of_cells(depth))
          continue;
        is_found = is_found ||
                   octree.sheet_of_face(number, location.face) != octree.number_of_sheets(depth);
      }
      REQUIRE(is_found);
    }
  });
}

TEST_CASE("find_agrees_with_a_linear_search", "[octree]") {
  for_each_octree([](const RL::Octree_3& octree) {
    for(int level = 0; level <= octree.depth(); ++level) {
      const std::size_t number = octree.number_of_cells(level);
      std::set<std::array<int, 3>> indices;
      for(std::size_t i = 0; i < number; ++i) {
        const RL::Cell_3 cell = octree.cell(level, octree.sheets(level, i)[0]);
        REQUIRE(octree.find(cell) == i);
        indices.insert(cell.index);
      }
      REQUIRE(indices.size() == number);
      if(level > 3)
        continue;
      RL::Cell_3 cell{level, {}};
      const int n = 1 << level;
      for(cell.index[0] = -2; cell.index[0] < n + 2; ++cell.index[0])
        for(cell.index[1] = -2; cell.index[1] < n + 2; ++cell.index[1])
          for(cell.index[2] = -2; cell.index[2] < n + 2; ++cell.index[2])
            REQUIRE((octree.find(cell) != number) == (indices.count(cell.index) == 1));
    }
  });
}

TEST_CASE("parents_and_children_are_inverse", "[octree]") {
  for_each_octree([](const RL::Octree_3& octree) {
    REQUIRE(octree.number_of_cells(0) == 1);
    for(int level = 0; level < octree.depth(); ++level) {
      std::size_t number_of_children = 0;
      for(std::size_t sheet = 0; sheet < octree.number_of_sheets(level); ++sheet) {
        REQUIRE(!octree.children(level, sheet).empty());
        for(std::uint32_t child : octree.children(level, sheet)) {
          REQUIRE(octree.parent(level + 1, child) == sheet);
          REQUIRE(octree.cell(level + 1, child).parent() == octree.cell(level, sheet));
          ++number_of_children;
        }
      }
      REQUIRE(number_of_children == octree.number_of_sheets(level + 1));
    }
  });
}

TEST_CASE("element_masks_agree_with_values_of_the_splines", "[octree]") {
  for_each_octree([](const RL::Octree_3& octree) {
    const int depth = octree.depth();
    std::vector<std::vector<std::array<bool, 27>>> meets(depth + 1);
    for(int level = 0; level <= depth; ++level)
      meets[level].resize(octree.number_of_sheets(level), std::array<bool, 27>());
    for(std::size_t fine = 0; fine < octree.number_of_sheets(depth); ++fine)
      for(std::uint32_t face : octree.faces(fine)) {
        const RL::Fragment fragment = octree.fragment(octree.cell(depth, fine), face);
        std::size_t i = fine;
        for(int level = depth; level >= 0; --level) {
          const auto t = center(fragment, octree.cell(level, i), depth);
          const auto x = RL::B_spline_1::values(t[0]), y = RL::B_spline_1::values(t[1]),
                     z = RL::B_spline_1::values(t[2]);
          for(int e = 0; e < 27; ++e)
            if(x[e % 3] > 0 && y[e / 3 % 3] > 0 && z[e / 9] > 0)
              meets[level][i][e] = true;
          if(level > 0)
            i = octree.parent(level, i);
        }
      }
    for(int level = 0; level <= depth; ++level)
      for(std::size_t i = 0; i < octree.number_of_sheets(level); ++i)
        for(int e = 0; e < 27; ++e)
          REQUIRE(octree.meets_element(level, i, e % 3 - 1, e / 3 % 3 - 1, e / 9 - 1) ==
                  meets[level][i][e]);
  });
}

TEST_CASE("coarse_levels_equal_octrees_of_that_depth", "[octree]") {
  for_each_octree([](const RL::Octree_3& deep) {
    for(int depth = 1; depth < deep.depth(); ++depth) {
      INFO("level " << depth);
      const RL::Octree_3 shallow(deep.surface(), depth, deep.side() / deep.surface().extent());
      for(int level = 0; level <= depth; ++level) {
        REQUIRE(shallow.number_of_cells(level) == deep.number_of_cells(level));
        REQUIRE(shallow.number_of_sheets(level) == deep.number_of_sheets(level));
        for(std::size_t i = 0; i < shallow.number_of_sheets(level); ++i) {
          REQUIRE(shallow.cell(level, i) == deep.cell(level, i));
          for(int e = 0; e < 27; ++e)
            REQUIRE(shallow.meets_element(level, i, e % 3 - 1, e / 3 % 3 - 1, e / 9 - 1) ==
                    deep.meets_element(level, i, e % 3 - 1, e / 3 % 3 - 1, e / 9 - 1));
        }
      }
    }
  });
}

TEST_CASE("surface_in_a_wall_is_stored_once", "[octree]") {
  // With an even number of cells a side the middle plane is a wall; the upper cells own it, and the
  // elements one cell above those vanish on it.
  const shapes::Triangles square = shapes::rectangle(1, 1);
  for(int depth = 1; depth <= 4; ++depth) {
    const RL::Octree_3 octree(RL::Triangulated_surface_3(square.points, square.faces), depth, 1);
    const int n = 1 << depth;
    REQUIRE(octree.number_of_cells(depth) == static_cast<std::size_t>(n) * n);
    REQUIRE(octree.number_of_sheets(depth) == static_cast<std::size_t>(n) * n);
    for(std::size_t i = 0; i < octree.number_of_sheets(depth); ++i) {
      REQUIRE(octree.cell(depth, i).index[2] == n / 2);
      REQUIRE(octree.meets_element(depth, i, 0, 0, -1));
      REQUIRE(octree.meets_element(depth, i, 0, 0, 0));
      REQUIRE_FALSE(octree.meets_element(depth, i, 0, 0, 1));
    }
  }
}

TEST_CASE("coordinates_without_digits_for_the_depth_are_refused", "[octree]") {
  const shapes::Triangles t = shapes::sphere(3);
  const auto octree = [&t](double offset, int depth) {
    const shapes::Triangles m = shapes::moved(t, RL::Vector_3(offset, 0, 0));
    return RL::Octree_3(RL::Triangulated_surface_3(m.points, m.faces), depth, 1.1);
  };
  // The sphere has diameter 2: at 2e12 its coordinates are multiples of 2^-12.
  CHECK(octree(2e12, 4).wall_tolerance(4) <= RL::Octree_3::largest_wall_tolerance);
  for(const auto& [offset, depth] : {std::make_pair(2e12, 5), {2e12, 12}, {1e14, 3}, {1e14, 1}}) {
    std::string parameter, what;
    try {
      octree(offset, depth);
    } catch(const RL::Parameter_error& error) {
      parameter = error.parameter();
      what = error.what();
    }
    INFO(what);
    CHECK(parameter == "depth");
    CHECK(what.find(offset == 2e12 ? "a depth of at most 4" : "no depth") != std::string::npos);
  }
}

TEST_CASE("windows_divide_the_cells_and_know_their_faces", "[octree]") {
  for_each_octree([](const RL::Octree_3& octree) {
    const Grid grid = grid_of(octree);
    const RL::Triangulated_surface_3& surface = octree.surface();
    std::map<std::uint64_t, std::set<std::uint32_t>> faces_of_cell;
    for(std::size_t face = 0; face < surface.number_of_faces(); ++face)
      if(!surface.is_degenerate(face))
        grid.clipper(grid_triangle(octree, face),
                     [&](const std::array<int, 3>& cell, const RL::Fragment&) {
                       faces_of_cell[RL::morton_key(cell)].insert(static_cast<std::uint32_t>(face));
                     });
    for(std::size_t number : {std::size_t(1), std::size_t(40), octree.number_of_fragments() / 2,
                              10 * octree.number_of_fragments()}) {
      INFO(number << " fragments wanted in a window");
      const RL::Surface_windows windows(surface, grid.vertices, number);
      CHECK((windows.size() == 1) ==
            (windows.estimated_number_of_fragments() <= static_cast<double>(number)));
      std::uint64_t next = 0;
      for(std::size_t window = 0; window < windows.size(); ++window) {
        const auto [first, last] = windows.cells(window);
        REQUIRE(first == next);
        REQUIRE(first < last);
        REQUIRE(first % (std::uint64_t(1) << 3 * (octree.depth() - windows.level())) == 0);
        next = last;
        const std::vector<std::uint32_t> faces = faces_of(windows, window);
        REQUIRE(std::adjacent_find(faces.begin(), faces.end(), std::greater_equal<>()) ==
                faces.end());
        for(auto it = faces_of_cell.lower_bound(first);
            it != faces_of_cell.end() && it->first < last; ++it)
          REQUIRE(std::includes(faces.begin(), faces.end(), it->second.begin(), it->second.end()));
      }
      CHECK(next == std::uint64_t(1) << 3 * octree.depth());
    }
  });
}

TEST_CASE("windows_hold_about_the_same_number_of_fragments", "[octree]") {
  const auto run = [](const shapes::Triangles& t, int depth, double tolerance) {
    const RL::Octree_3 octree(RL::Triangulated_surface_3(t.points, t.faces), depth, 1.1);
    const Grid grid = grid_of(octree);
    const auto fragments = static_cast<double>(octree.number_of_fragments());
    for(std::size_t wanted : {8000, 3000, 1000}) {
      const RL::Surface_windows windows(octree.surface(), grid.vertices, wanted);
      INFO(windows.size() << " windows, " << fragments << " fragments, estimated "
                          << windows.estimated_number_of_fragments());
      CHECK(windows.estimated_number_of_fragments() == Approx(fragments).epsilon(tolerance));
      REQUIRE(windows.size() ==
              std::ceil(windows.estimated_number_of_fragments() / static_cast<double>(wanted)));
      std::vector<std::size_t> numbers(windows.size(), 0);
      for(std::size_t i = 0; i < octree.number_of_cells(depth); ++i) {
        const auto [first, last] = octree.sheets(depth, i);
        const std::uint64_t key = octree.cell(depth, first).key();
        std::size_t window = 0;
        while(key >= windows.cells(window)[1])
          ++window;
        for(std::size_t sheet = first; sheet < last; ++sheet)
          numbers[window] += octree.faces(sheet).size();
      }
      const double largest = static_cast<double>(*std::max_element(numbers.begin(), numbers.end()));
      CHECK(largest <= 1.2 * fragments / static_cast<double>(windows.size()));
    }
  };
  run(shapes::sphere(6), 5, 0.05); // many triangles in a cell
  run(shapes::sphere(0), 7, 0.25); // many cells for a triangle
}

TEST_CASE("windows_hold_what_is_nearer_than_their_margin", "[octree]") {
  const shapes::Triangles t = shapes::joined(shapes::sphere(3), shapes::rectangle(2, 1));
  const RL::Octree_3 octree(RL::Triangulated_surface_3(t.points, t.faces), 5, 1.1);
  const Grid grid = grid_of(octree);
  for(double margin : {0.5, 1., 3.}) {
    const RL::Surface_windows windows(octree.surface(), grid.vertices, 300, margin);
    REQUIRE(windows.size() > 5);
    std::vector<std::vector<std::uint32_t>> faces;
    for(std::size_t window = 0; window < windows.size(); ++window)
      faces.push_back(faces_of(windows, window));
    const int reach = static_cast<int>(std::ceil(margin)), n = 1 << 5;
    for(std::uint32_t face = 0; face < t.faces.size(); ++face)
      for(const auto& corner : grid.vertices.corners(face)) {
        // all cells that come as near
        std::array<int, 3> c;
        const auto for_axis = [&](int axis, const auto& next) {
          for(int k = static_cast<int>(corner[axis]) - reach;
              k <= static_cast<int>(corner[axis]) + reach; ++k)
            if(k >= 0 && k < n && k <= corner[axis] + margin && k + 1 >= corner[axis] - margin) {
              c[axis] = k;
              next();
            }
        };
        for_axis(0, [&] {
          for_axis(1, [&] {
            for_axis(2, [&] {
              std::size_t window = 0;
              while(RL::morton_key(c) >= windows.cells(window)[1])
                ++window;
              REQUIRE(std::binary_search(faces[window].begin(), faces[window].end(), face));
            });
          });
        });
      }
  }
}

TEST_CASE("octrees_do_not_depend_on_windows", "[octree][threads]") {
  const auto run = [](const std::string& name, const shapes::Triangles& t, int depth, bool is_split,
                      double joining_tolerance = -1) {
    INFO(name);
    const auto octree = [&](bool is_parallel, std::size_t fragments_at_once) {
      return RL::Octree_3(RL::Triangulated_surface_3(t.points, t.faces), depth, 1.1, is_split,
                          joining_tolerance, is_parallel, fragments_at_once);
    };
    const RL::Octree_3 whole = octree(false, RL::Octree_3::default_fragments_at_once);
    for(std::size_t at_once : {1, 50, 1000})
      require_equal(whole, octree(at_once != 50, at_once));
  };
  const shapes::Triangles sphere = shapes::sphere(3);
  run("sphere", sphere, 5, true);
  run("unsplit", sphere, 5, false);
  run("near layers", shapes::joined(sphere, shapes::scaled(sphere, 0.99)), 5, true);
  run("soup", torn(sphere), 5, true, 1e-5);
  run("coarse soup", torn(shapes::sphere(1)), 4, true, 1e-5);
  run("all is near", torn(shapes::sphere(0)), 3, true, 1e300);
  run("octahedron", shapes::sphere(0), 6, true);
  run("in walls", shapes::stairs(8, 0.1), 6, true);
  run("flat box", shapes::box(1, 0.5, 0.25, 4, 1), 5, true);
}

TEST_CASE("windows_on_a_million_triangles", "[octree][slow]") {
  const std::string path = shared_mesh("armadillo_mc1m.ply");
  if(path.empty())
    SKIP_TEST("no armadillo_mc1m.ply");
  const shapes::Triangles t = shapes::triangles(shapes::read(path));
  for(int depth : {6, 9}) {
    const RL::Triangulated_surface_3 surface(t.points, t.faces);
    const auto most = (std::numeric_limits<std::size_t>::max)();
    require_equal(RL::Octree_3(surface, depth, 1.1, true, -1, true, most),
                  RL::Octree_3(surface, depth, 1.1, true, -1, true, 100000));
  }
}

TEST_CASE("lone_sides_do_not_depend_on_parts", "[octree]") {
  // open, with a hole, a face of area zero, and three faces at an edge
  shapes::Triangles t =
      shapes::grid(12, [](double x, double y) { return RL::Point_3(x, y, x * y); });
  t.faces.erase(t.faces.begin() + 100, t.faces.begin() + 107);
  t.faces.push_back({0, 1, 1});
  t.faces.push_back({40, 41, 3});
  const RL::Triangulated_surface_3 surface(t.points, t.faces);
  const double thinness = GENERATE(0., 0.01);
  const RL::Surface_seams seams(surface, thinness, -1);
  std::map<RL::Surface_seams::Key, int> sizes;
  for(std::size_t f = 0; f < t.faces.size(); ++f)
    for(int side = 0; side < 3; ++side)
      ++sizes[seams.seam(f, side)];
  const std::size_t sides_at_once = GENERATE(1, 7, 50, 100, 1000);
  std::vector<std::pair<std::size_t, int>> lone, expected;
  for(const auto& side : seams.lone_sides(sides_at_once))
    lone.emplace_back(side.face, side.number);
  for(std::size_t f = 0; f < t.faces.size(); ++f)
    for(int side = 0; side < 3; ++side)
      if(sizes[seams.seam(f, side)] == 1)
        expected.emplace_back(f, side);
  CHECK(expected.size() > 48);
  CHECK(lone == expected);
}

TEST_CASE("violated_preconditions_throw_in_debug_builds", "[octree]") {
#ifdef CGAL_NO_PRECONDITIONS
  SUCCEED("Preconditions are not checked in this build.");
#else
  using Exception = CGAL::Precondition_exception;
  const shapes::Triangles t = shapes::sphere(1);
  RL::Spline_space_options options;
  options.depth = 2;
  const RL::Spline_space_3 space(RL::Triangulated_surface_3(t.points, t.faces), options);
  const RL::Octree_3& octree = space.octree();
  const RL::Triangulated_surface_3& surface = space.surface();
  for(int level : {-1, 3}) {
    CHECK_THROWS_AS(octree.number_of_cells(level), Exception);
    CHECK_THROWS_AS(octree.number_of_sheets(level), Exception);
    CHECK_THROWS_AS(octree.find({level, {0, 0, 0}}), Exception);
    CHECK_THROWS_AS(space.dimension(level), Exception);
  }
  const std::size_t sheet = octree.number_of_sheets(2), cell = octree.number_of_cells(2);
  CHECK_THROWS_AS(octree.cell(2, sheet), Exception);
  CHECK_THROWS_AS(octree.links(2, sheet), Exception);
  CHECK_THROWS_AS(octree.sheets(2, cell), Exception);
  CHECK_THROWS_AS(octree.faces(sheet), Exception);
  CHECK_THROWS_AS(octree.sheet_of_face(cell, 0), Exception);
  CHECK_THROWS_AS(octree.parent(0, 0), Exception);
  CHECK_THROWS_AS(octree.children(2, 0), Exception);
  CHECK_THROWS_AS(octree.meets_element(2, sheet, 0, 0, 0), Exception);
  CHECK_THROWS_AS(octree.fragment(octree.cell(1, 0), 0), Exception);
  CHECK_THROWS_AS(space.elements(2, sheet), Exception);
  CHECK_THROWS_AS(space.slot(2, space.dimension(2)), Exception);
  CHECK_THROWS_AS(surface.point(t.points.size()), Exception);
  CHECK_THROWS_AS(surface.point(0, 3), Exception);
  CHECK_THROWS_AS(surface.triangle(t.faces.size()), Exception);
  CHECK_THROWS_AS(surface.normal(t.faces.size()), Exception);
  CHECK_THROWS_AS(surface.area(t.faces.size()), Exception);
  const RL::Surface_point p = surface.surface_point({t.faces.size() - 1, {1, 0, 0}});
  CHECK_THROWS_AS(RL::Linear_surface_function<double>({1., 2., 3.})(p), Exception);
  CHECK_THROWS_AS(RL::Face_function<double>({1., 2., 3.})(p), Exception);
  CHECK_THROWS_AS(RL::Corner_vector_field<double>({1., 2., 3.})(p), Exception);
  const RL::Surface_seams seams(surface, 0, -1);
  CHECK_THROWS_AS(seams.seam(0, 3), Exception);
#endif
}

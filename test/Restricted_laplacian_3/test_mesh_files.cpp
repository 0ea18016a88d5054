// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// What is read from binary files is what CGAL reads from them.

#include "catch.h"

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/parameters.h>
#include <CGAL/Restricted_laplacian_3/surface/read_triangle_soup.h>

#include <CGAL/IO/polygon_soup_io.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;
using Point = RL::Point_3;

struct Triangle_soup {
  std::vector<Point> points;
  std::vector<RL::Triangulated_surface_3::Triangle> triangles;
};

std::optional<Triangle_soup> read(const std::string& file) {
  Triangle_soup soup;
  if(RL::read_triangle_soup(file, soup.points, soup.triangles))
    return soup;
  CHECK(soup.points.empty());
  CHECK(soup.triangles.empty());
  return std::nullopt;
}

/// a file that is gone at the end
struct Scratch_file {
  std::string name;

  // tests run side by side
  Scratch_file(const std::string& extension, const std::string& bytes)
    : name((std::filesystem::temp_directory_path() /
            ("test_mesh_files_" + std::to_string(std::random_device()()) + extension))
               .string()) {
    std::ofstream(name, std::ios::binary) << bytes;
  }
  ~Scratch_file() { std::filesystem::remove(name); }
};

template <class Number> std::string bytes_of(Number x, bool is_big_endian = false) {
  std::string bytes(reinterpret_cast<const char*>(&x), sizeof(x));
  if(is_big_endian) // the tests run on a machine with the other order
    std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

/// a wavy sheet of triangles, where the vertices have one number more, and the faces another
std::string ply(bool is_big_endian, bool has_doubles, bool has_more, std::size_t faces = 18) {
  const int n = 4;
  std::string bytes = std::string("ply\nformat binary_") + (is_big_endian ? "big" : "little") +
                      "_endian 1.0\ncomment element face 7\nelement vertex " +
                      std::to_string(n * n) + '\n';
  const std::string type = has_doubles ? "double" : "float32";
  bytes += "property " + type + " x\nproperty " + type + " y\n";
  bytes += has_more ? "property uchar red\n" : "";
  bytes += "property " + type + " z\nelement face " + std::to_string(faces) + '\n';
  bytes += has_more ? "property list uchar float weights\n" : "";
  bytes += std::string("property list ") + (has_more ? "uint8 uint32" : "uchar int") +
           " vertex_ind" + (has_more ? "ex" : "ices") + '\n';
  bytes += has_more ? "property short quality\n" : "";
  bytes += "end_header\n";
  const auto add = [&](auto x) { bytes += bytes_of(x, is_big_endian); };
  const auto add_coordinate = [&](double x) { has_doubles ? add(x) : add(static_cast<float>(x)); };
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j) {
      add_coordinate(i / 3.);
      add_coordinate(j / 7.);
      if(has_more)
        add(std::uint8_t(200));
      add_coordinate(std::sin(i + 2. * j));
    }
  for(int i = 0; i + 1 < n; ++i)
    for(int j = 0; j + 1 < n; ++j)
      for(const bool is_second : {false, true}) {
        const std::uint32_t a = static_cast<std::uint32_t>(n * i + j);
        if(has_more) {
          add(static_cast<std::uint8_t>(j));
          for(int k = 0; k < j; ++k)
            add(1.f);
        }
        add(std::uint8_t(3));
        add(a);
        add(a + 1 + is_second * std::uint32_t(n));
        add(a + std::uint32_t(n) + (is_second ? 0 : 1));
        if(has_more)
          add(std::int16_t(-1));
      }
  return bytes;
}

std::string stl(const std::vector<float>& coordinates, std::uint32_t triangles) {
  std::string bytes(80, 'x');
  bytes += bytes_of(triangles);
  for(std::size_t i = 0; i + 9 <= coordinates.size(); i += 9) {
    bytes += bytes_of(0.f) + bytes_of(0.f) + bytes_of(1.f);
    for(std::size_t k = i; k < i + 9; ++k)
      bytes += bytes_of(coordinates[k]);
    bytes += bytes_of(std::uint16_t(0));
  }
  return bytes;
}

void check_equals_cgal(const std::string& extension, const std::string& bytes) {
  const Scratch_file file(extension, bytes);
  const std::optional<Triangle_soup> soup = read(file.name);
  REQUIRE(soup);
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> faces;
  REQUIRE(CGAL::IO::read_polygon_soup(file.name, points, faces));
  CHECK(soup->points == points);
  REQUIRE(soup->triangles.size() == faces.size());
  for(std::size_t i = 0; i < faces.size(); ++i)
    CHECK(std::equal(faces[i].begin(), faces[i].end(), soup->triangles[i].begin(),
                     soup->triangles[i].end()));
}

bool is_left_to_cgal(const std::string& extension, const std::string& bytes) {
  const Scratch_file file(extension, bytes);
  return !read(file.name);
}

} // namespace

TEST_CASE("binary_ply_files_are_read_as_cgal_reads_them", "[files]") {
  for(const bool is_big_endian : {false, true})
    for(const bool has_doubles : {false, true})
      for(const bool has_more : {false, true}) {
        CAPTURE(is_big_endian, has_doubles, has_more);
        check_equals_cgal(".ply", ply(is_big_endian, has_doubles, has_more));
      }
}

TEST_CASE("binary_stl_files_are_read_as_cgal_reads_them", "[files]") {
  // two triangles share an edge, once with a zero of the other sign
  check_equals_cgal(".stl", stl({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, -0.f, 0, 1, 1, 0, 0, 1, -0.f}, 2));
  check_equals_cgal(".stl", stl({}, 0));
}

TEST_CASE("files_with_anything_else_are_left_to_cgal", "[files]") {
  const std::string whole = ply(false, false, false);
  CHECK(!is_left_to_cgal(".ply", whole));
  CHECK(is_left_to_cgal(".off", whole));
  CHECK(is_left_to_cgal(".ply", ""));
  // cut anywhere
  for(std::size_t size = 1; size < whole.size(); size += 7)
    CHECK(is_left_to_cgal(".ply", whole.substr(0, size)));
  // more faces than there are
  CHECK(is_left_to_cgal(".ply", ply(false, false, false, 19)));
  CHECK(is_left_to_cgal(".ply", ply(false, false, false, std::size_t(1) << 60)));
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string result = whole;
    result.replace(result.find(from), from.size(), to);
    return result;
  };
  CHECK(is_left_to_cgal(".ply", changed("binary_little_endian", "ascii")));
  CHECK(is_left_to_cgal(".ply", changed("property float32 z", "property int32 z")));
  CHECK(is_left_to_cgal(".ply", changed("property float32 z", "property float32 w")));
  CHECK(is_left_to_cgal(".ply", changed("element vertex 16", "element vertex -1")));
  CHECK(is_left_to_cgal(".ply", changed("element vertex 16", "element edge 16")));
  CHECK(is_left_to_cgal(".ply", changed("list uchar", "list uint")));
  // a vertex that does not exist
  const std::size_t first_face = whole.find("end_header\n") + 11 + 16 * 12;
  std::string other = whole;
  other.replace(first_face + 1, 4, bytes_of(std::int32_t(-1)));
  CHECK(is_left_to_cgal(".ply", other));

  // one face, whose corners are all there: a triangle and a quadrangle
  for(const std::uint8_t corners : {std::uint8_t(3), std::uint8_t(4)}) {
    std::string face = ply(false, false, false, 1).substr(0, first_face - 1);
    face += bytes_of(corners);
    for(std::int32_t i = 0; i < corners; ++i)
      face += bytes_of(i);
    CHECK(is_left_to_cgal(".ply", face) == (corners == 4));
  }

  const std::string triangle = stl({0, 0, 0, 1, 0, 0, 0, 1, 0}, 1);
  CHECK(!is_left_to_cgal(".stl", triangle));
  CHECK(is_left_to_cgal(".stl", triangle.substr(0, 100)));
  // a file of text begins like that
  check_equals_cgal(".stl", "solid" + triangle.substr(5));
  CHECK(is_left_to_cgal(".stl", "solid" + triangle.substr(5) + '\n'));
  CHECK(is_left_to_cgal(".stl",
                        stl({0, 0, 0, 1, 0, 0, 0, std::numeric_limits<float>::quiet_NaN(), 0}, 1)));

  // no file, and a folder
  CHECK(!read("no_such_file.ply"));
  std::filesystem::create_directory("folder.ply");
  CHECK(!read("folder.ply"));
  std::filesystem::remove("folder.ply");
}

TEST_CASE("large_binary_files_are_read_in_pieces", "[files]") {
  // longer than the pieces, which end in the middle of numbers; in the STL file each vertex is met
  // up to six times
  const int n = 500;
  std::vector<float> coordinates;
  std::string vertices, faces;
  for(int i = 0; i <= n; ++i)
    for(int j = 0; j <= n; ++j)
      for(const float x : {float(i), float(j), float(i * j)})
        vertices += bytes_of(x);
  std::vector<RL::Triangulated_surface_3::Triangle> expected;
  for(std::uint32_t i = 0; i < n; ++i)
    for(std::uint32_t j = 0; j < n; ++j)
      for(const bool is_second : {false, true}) {
        const std::uint32_t a = (n + 1) * i + j;
        expected.push_back({a, is_second ? a + n + 2 : a + 1, is_second ? a + n + 1 : a + n + 2});
        faces += bytes_of(std::uint8_t(3));
        for(const std::uint32_t v : expected.back()) {
          faces += bytes_of(v);
          const std::uint32_t x = v / (n + 1), y = v % (n + 1);
          coordinates.insert(coordinates.end(), {float(x), float(y), float(x * y)});
        }
      }
  const Scratch_file ply_file(
      ".PLY", "ply\nformat binary_little_endian 1.0\nelement vertex 251001\nproperty float x\n"
              "property float y\nproperty float z\nelement face 500000\n"
              "property list uchar int vertex_indices\nend_header\n" +
                  vertices + faces);
  std::vector<double> parts;
  Triangle_soup soup;
  REQUIRE(RL::read_triangle_soup(ply_file.name, soup.points, soup.triangles,
                                 params::callback([&](double part) {
                                   parts.push_back(part);
                                   return true;
                                 })));
  CHECK(soup.points.size() == 251001);
  CHECK(soup.points.back() == Point(n, n, n * n));
  CHECK(soup.triangles == expected);
  CHECK(parts.size() >= 3);
  CHECK(std::is_sorted(parts.begin(), parts.end()));
  CHECK(parts.back() == 1);
  CHECK_THROWS_AS(RL::read_triangle_soup(ply_file.name, soup.points, soup.triangles,
                                         params::callback([](double part) { return part < 0.5; })),
                  RL::Canceled);

  const Scratch_file stl_file(".stl", stl(coordinates, 500000));
  const std::optional<Triangle_soup> joined = read(stl_file.name);
  REQUIRE(joined);
  CHECK(joined->points.size() == 251001);
  REQUIRE(joined->triangles.size() == expected.size());
  std::size_t number_of_equal_corners = 0;
  for(std::size_t i = 0; i < expected.size(); ++i)
    for(std::size_t k = 0; k < 3; ++k)
      number_of_equal_corners +=
          joined->points[joined->triangles[i][k]] == soup.points[expected[i][k]];
  CHECK(number_of_equal_corners == 3 * expected.size());
}

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Files of meshes are read as they are meant, or refused with the place that is wrong.

#include "catch.h"
#include "test_meshes.h"

#include <CGAL/Restricted_laplacian_3/files/read_mesh_file.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>

#include <CGAL/IO/polygon_soup_io.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;
using Point = RL::Point_3;

/// bytes, as if they were a file of a suffix
RL::Mesh_file read(const std::string& suffix, const std::string& bytes) {
  return RL::internal::read_mesh_file("test" + suffix, bytes);
}

/// why they are refused; empty if they are not
std::string refusal(const std::string& suffix, const std::string& bytes) {
  try {
    read(suffix, bytes);
  } catch(const RL::File_error& e) {
    CHECK(e.file() == "test" + suffix);
    return e.what();
  }
  return "";
}

/// names and types of the properties of vertices, and of each the last value
std::string properties_of(const std::string& suffix, const std::string& bytes) {
  std::ostringstream out;
  for(const RL::Vertex_property& p : RL::internal::read_vertex_properties("test" + suffix, bytes))
    out << p.name << ':' << p.type << '=' << p.values.back() << ' ';
  return out.str();
}

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
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
  const RL::Mesh_file mesh = RL::read_mesh_file(file.name);
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> faces;
  REQUIRE(CGAL::IO::read_polygon_soup(file.name, points, faces));
  CHECK(mesh.points == points);
  CHECK(mesh.warnings.empty());
  REQUIRE(mesh.triangles.size() == faces.size());
  for(std::size_t i = 0; i < faces.size(); ++i)
    CHECK(std::equal(faces[i].begin(), faces[i].end(), mesh.triangles[i].begin(),
                     mesh.triangles[i].end()));
}

/// text with other ends of lines
std::string with_ends(const std::string& text, const std::string& end) {
  std::string result;
  for(const char c : text)
    c == '\n' ? result += end : result += c;
  return result;
}

const char* const mark = "\xEF\xBB\xBF"; // of the order of bytes

// a square of two triangles in each format that is text
const std::string square_off = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";
const std::string square_obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n";
const std::string square_ply =
    "ply\nformat ascii 1.0\ncomment a square\nelement vertex 4\nproperty float x\n"
    "property float y\nproperty float z\nelement face 2\nproperty list uchar int vertex_indices\n"
    "end_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";
const std::string square_stl =
    "solid a name\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\n"
    "endloop\nendfacet\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 1 0\n"
    "vertex 0 1 0\nendloop\nendfacet\nendsolid a name\n";
const std::string square_vtk =
    "# vtk DataFile Version 3.0\na square\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n"
    "0 0 0 1 0 0\n1 1 0 0 1 0\nPOLYGONS 2 8\n3 0 1 2\n3 0 2 3\n";
const std::string square_ts = "GOCAD TSurf 1\nHEADER {\nname: a\n}\nTFACE\nVRTX 1 0 0 0\n"
                              "VRTX 2 1 0 0\nPVRTX 3 1 1 0 7.5\nVRTX 4 0 1 0\nTRGL 1 2 3\n"
                              "TRGL 1 3 4\nEND\n";

struct Text_file {
  const char* suffix;
  std::string text;
};

const std::vector<Text_file> squares = {{".off", square_off}, {".obj", square_obj},
                                        {".ply", square_ply}, {".stl", square_stl},
                                        {".vtk", square_vtk}, {".ts", square_ts}};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

void check_is_square(const std::string& suffix, const std::string& text) {
  CAPTURE(suffix, text);
  RL::Mesh_file mesh;
  CHECK_NOTHROW(mesh = read(suffix, text));
  CHECK(mesh.points == std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  CHECK(mesh.triangles == std::vector<RL::Triangulated_surface_3::Triangle>{{0, 1, 2}, {0, 2, 3}});
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
  // a file of text begins like that
  check_equals_cgal(".stl", "solid" + stl({0, 0, 0, 1, 0, 0, 0, 1, 0}, 1).substr(5));
}

TEST_CASE("text_is_read_whatever_its_lines_and_blanks_are", "[files]") {
  for(const Text_file& square : squares) {
    const std::string& text = square.text;
    check_is_square(square.suffix, text);
    for(const char* end : {"\r", "\r\n", " \n", "\t \n"})
      check_is_square(square.suffix, with_ends(text, end));
    check_is_square(square.suffix, mark + text);
    check_is_square(square.suffix, text.substr(0, text.size() - 1));
    check_is_square(square.suffix, text + "\n\n");
    const std::string suffix = square.suffix;
    if(suffix != ".vtk") {
      check_is_square(square.suffix, with_ends(text, "\n\n"));
      check_is_square(square.suffix, "\n \n" + text);
    }
    check_is_square(std::string(square.suffix) == ".off" ? ".OFF" : square.suffix, text);
  }
}

TEST_CASE("off_files_with_all_prefixes_are_read", "[files]") {
  const auto off = [](const std::string& head, const std::string& behind = "") {
    std::string text = head;
    for(const char* p : {"0 0 0", "1 0 0", "1 1 0", "0 1 0"})
      text += p + behind + '\n';
    return text + "3 0 1 2\n3 0 2 3\n";
  };
  for(const char* head : {"OFF\n4 2 0\n", "OFF\n4 2\n", "OFF 4 2 0\n", "4 2 0\n",
                          "OFF # a\n# b\n4 2 0 # c\n\n", "OFF\n4\n2 0\n"})
    check_is_square(".off", off(head));
  check_is_square(".off", off("NOFF\n4 2 0\n", " 0 0 1"));
  check_is_square(".off", off("COFF\n4 2 0\n", " 255 0 0 255"));
  check_is_square(".off", off("COFF\n4 2 0\n", " 1 0.5 0"));
  check_is_square(".off", off("STOFF\n4 2 0\n", " 0.5 0.5"));
  check_is_square(".off", off("STCNOFF\n4 2 0\n", " 0 0 1 255 0 0 0.5 0.5"));
  check_is_square(".off", off("CNOFF\n4 2 0\n", " 0 0 1 9 8 7"));
  check_is_square(".off", off("NCOFF\n4 2 0\n", " 0 0 1 9 8 7"));
  check_is_square(".off", off("4OFF\n4 2 0\n", " 1"));
  check_is_square(".off", off("nOFF\n3\n4 2 0\n"));
  check_is_square(".off", replaced(square_off, "3 0 1 2", "3 0 1 2 255 0 0"));
  CHECK(properties_of(".off", off("STCNOFF\n4 2 0\n", " 0 0 1 255 51 0 0.5 0.25")) ==
        "nx:float64=0 ny:float64=0 nz:float64=1 red:uint8=255 green:uint8=51 blue:uint8=0 "
        "s:float64=0.5 t:float64=0.25 ");
  CHECK(properties_of(".off", off("COFF\n4 2 0\n", " 1 0.5 0 1")) ==
        "red:float64=1 green:float64=0.5 blue:float64=0 ");
  CHECK(read(".off", "4OFF\n3 1 0\n2 2 2 2\n1 0 0 1\n0 1 0 1\n3 0 1 2\n").points[0] ==
        Point(1, 1, 1));
  CHECK(read(".off", square_off + "3 0 1 2\n").warnings.size() == 1);

  std::string binary = "OFF BINARY\n";
  for(const std::int32_t n : {4, 2, 0})
    binary += bytes_of(n, true);
  for(const float x : {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0})
    binary += bytes_of(x, true);
  for(const std::int32_t n : {3, 0, 1, 2, 0, 3, 0, 2, 3, 1, 7})
    binary += bytes_of(n, true);
  check_is_square(".off", binary);
  for(std::size_t size = 1; size < binary.size(); ++size)
    CHECK(!refusal(".off", binary.substr(0, size)).empty());
}

TEST_CASE("obj_files_with_all_kinds_of_indices_are_read", "[files]") {
  check_is_square(".obj", with_ends(square_obj, "\n# a comment\n"));
  check_is_square(".obj", replaced(square_obj, "f 1 2 3", "f 1/1 2/2/2 3//1"));
  check_is_square(".obj", replaced(square_obj, "f 1 2 3", "f -4 -3 -2"));
  check_is_square(".obj", replaced(square_obj, "f 1 2 3", "f -4/-1 2 -2//-1"));
  check_is_square(".obj", replaced(square_obj, "f 1 2 3", "f 1 \\\n 2 \\\n3"));
  check_is_square(".obj", replaced(square_obj, "f 1 2 3", "f\t1\t2\t3\t"));
  check_is_square(".obj", "f 1 2 3\n" + replaced(square_obj, "f 1 2 3\n", ""));
  check_is_square(".obj", "mtllib a \\\n b\no a\ng b c\nvn 0 0 1\nvt 0 0\ns off\nl 1 2\np 1\n" +
                              square_obj);
  check_is_square(".obj", replaced(square_obj, "v 1 1 0", "v 1e0 +1 0.0 1.0"));
  const std::string colored = "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0.5 1\nf 1 2 3\n";
  CHECK(read(".obj", colored).triangles.size() == 1);
  CHECK(properties_of(".obj", colored) == "red:float64=0 green:float64=0.5 blue:float64=1 ");
  CHECK(properties_of(".obj", square_obj).empty());
  const RL::Mesh_file polygons =
      read(".obj", "v 0 0 0\nv 2 0 0\nv 1 0.1 0\nv 1 2 0\nf 1 2 3 4\nf 1 2 3\nwhat 1\n");
  CHECK(polygons.triangles.size() == 3);
  CHECK(polygons.number_of_divided_faces == 1);
  REQUIRE(polygons.warnings.size() == 1);
  CHECK(says(polygons.warnings[0], "line 7 begins with 'what'"));
}

TEST_CASE("ply_files_of_all_types_are_read", "[files]") {
  // numbers of all types for coordinates, lengths and indices
  for(const char* type :
      {"char", "uchar", "int8", "uint8", "short", "ushort", "int16", "uint16", "int", "uint",
       "int32", "uint32", "float", "double", "float32", "float64"}) {
    check_is_square(".ply", replaced(square_ply, "float x", std::string(type) + " x"));
    if(!says(type, "float") && !says(type, "double")) {
      check_is_square(".ply", replaced(square_ply, "uchar int", std::string(type) + " int"));
      check_is_square(".ply", replaced(square_ply, "uchar int", "uchar " + std::string(type)));
    }
  }
  check_is_square(".ply", replaced(square_ply, "vertex_indices", "vertex_index"));
  // faces before vertices, other elements, and properties in any order
  check_is_square(
      ".ply", "ply\nformat ascii 1.0\nobj_info a\nelement face 2\nproperty float area\n"
              "property list uint uint vertex_indices\nelement edge 1\nproperty int a\n"
              "element vertex 4\nproperty list int float weights\nproperty double z\n"
              "property double y\nproperty uchar red\nproperty double x\nend_header\n"
              "0.5 3 0 1 2\n0.5 3 0 2 3\n7\n0 0 0 9 0\n1 5 0 0 9 1\n0 0 1 9 1\n2 5 5 0 1 9 0\n");
  CHECK(properties_of(".ply", square_ply) == "x:float32=0 y:float32=1 z:float32=0 ");
  // strips: the end of one is -1, and the second triangle of a strip is turned
  const RL::Mesh_file strips =
      read(".ply", "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
                   "property float z\nelement tristrips 1\nproperty list int int vertex_indices\n"
                   "end_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n2 2 0\n8 0 1 2 3 -1 1 3 4\n");
  CHECK(strips.triangles ==
        std::vector<RL::Triangulated_surface_3::Triangle>{{0, 1, 2}, {2, 1, 3}, {1, 3, 4}});
  // points alone
  const std::string points = square_ply.substr(0, square_ply.find("element face")) +
                             "end_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  CHECK(read(".ply", points).points.size() == 4);
  CHECK(read(".ply", points).triangles.empty());
  CHECK(read(".ply", square_ply + "1\n").warnings.size() == 1);
}

TEST_CASE("stl_files_of_text_are_read_whatever_stands_around", "[files]") {
  check_is_square(".stl", "# made by somebody\n\n; with another comment\n" + square_stl);
  check_is_square(".stl", replaced(square_stl, "endsolid a name\n", ""));
  check_is_square(".stl", replaced(square_stl, "solid a name", "solid"));
  check_is_square(".stl", replaced(square_stl, "facet normal 0 0 1\nouter", "facet outer"));
  check_is_square(".stl", replaced(square_stl, "normal 0 0 1", "normal nan -nan(ind) 1.#QNAN"));
  std::string upper = square_stl;
  for(char& c : upper)
    c = static_cast<char>(std::toupper(c));
  check_is_square(".stl", upper);
  const std::size_t second = square_stl.find("endfacet\n") + 9;
  check_is_square(".stl",
                  square_stl.substr(0, second) + "endsolid\nsolid b\n" + square_stl.substr(second));
  const std::string triangle = stl({0, 0, 0, 1, 0, 0, 0, 1, 0}, 1);
  CHECK(read(".stl", triangle + "more").warnings.size() == 1);
  CHECK(read(".stl", "solid" + triangle.substr(5) + '\n').triangles.size() == 1);
}

TEST_CASE("vtk_files_of_all_versions_are_read", "[files]") {
  const std::string head = "# vtk DataFile Version 5.1\na square\n";
  check_is_square(".vtk",
                  head + "ASCII\nDATASET POLYDATA\nPOINTS 4 double\n0 0 0 1 0 0 1 1 0 0 1 0\n"
                         "METADATA\nINFORMATION 0\n\nPOLYGONS 3 6\nOFFSETS vtktypeint64\n0 3 6\n"
                         "CONNECTIVITY vtktypeint64\n0 1 2 0 2 3\n");
  check_is_square(".vtk", replaced(square_vtk, "POLYGONS 2 8\n3 0 1 2\n3 0 2 3",
                                   "LINES 1 3\n2 0 1\nPOLYGONS 2 8\n3 0 1 2\n3 0 2 3"));
  CHECK(read(".vtk", replaced(square_vtk, "POLYGONS 2 8\n3 0 1 2\n3 0 2 3",
                              "TRIANGLE_STRIPS 1 5\n4 0 1 2 3"))
            .triangles == std::vector<RL::Triangulated_surface_3::Triangle>{{0, 1, 2}, {2, 1, 3}});
  std::string binary = head + "BINARY\nDATASET POLYDATA\nPOINTS 4 float\n";
  for(const float x : {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0})
    binary += bytes_of(x, true);
  binary += "\nPOLYGONS 3 6\nOFFSETS vtktypeint64\n";
  for(const std::int64_t n : {0, 3, 6})
    binary += bytes_of(n, true);
  binary += "\nCONNECTIVITY vtktypeint64\n";
  for(const std::int64_t n : {0, 1, 2, 0, 2, 3})
    binary += bytes_of(n, true);
  check_is_square(".vtk", binary);
  std::string old =
      replaced(binary.substr(0, binary.find("POLYGONS")), "5.1", "4.2") + "POLYGONS 2 8\n";
  for(const std::int32_t n : {3, 0, 1, 2, 3, 0, 2, 3})
    old += bytes_of(n, true);
  check_is_square(".vtk", old);
  // data at points, between others
  const std::string data = square_vtk +
                           "CELL_DATA 2\nSCALARS c int\nLOOKUP_TABLE default\n1 2\nPOINT_DATA 4\n"
                           "SCALARS a%20b float 1\nLOOKUP_TABLE default\n1 2 3 4\nNORMALS n "
                           "float\n0 0 1 0 0 1 0 0 1 0 0 1\n"
                           "COLOR_SCALARS rgb 3\n1 0 0 1 0 0 1 0 0 0 1 0\nFIELD FieldData "
                           "2\nthickness 1 4 double\n1 2 3 4.5\n"
                           "METADATA\nINFORMATION 0\n\nv 2 4 int\n1 2 3 4 5 6 7 8\n";
  check_is_square(".vtk", data);
  CHECK(properties_of(".vtk", data) ==
        "a b:float32=4 nx:float32=0 ny:float32=0 nz:float32=1 red:float32=0 green:float32=1 "
        "blue:float32=0 thickness:float64=4.5 v_0:int32=7 v_1:int32=8 ");
}

TEST_CASE("numbers_that_no_double_holds_are_0_or_infinite", "[files]") {
  const auto x = [](const std::string& word) {
    return read(".xyz", word + " 0 0\n").points[0].x();
  };
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(x("1e400") == infinity);
  CHECK(x("-1e+400") == -infinity);
  CHECK(x("1" + std::string(400, '0')) == infinity);
  CHECK(x("1e-400") == 0);
  CHECK(x("-0." + std::string(400, '0') + '1') == 0);
  CHECK(std::isnan(x("nan")));
  CHECK(x("+.5") == 0.5);
  for(const char* word : {"+-1", "1e", "0x10", "1.5.", "--1", "1f"})
    CHECK(says(refusal(".xyz", std::string(word) + " 0 0\n"), "is no number"));
}

TEST_CASE("points_are_read_from_lines_of_numbers", "[files]") {
  CHECK(read(".xyz", "# points\n0 0 0\n\n1 0 0\n").points.size() == 2);
  CHECK(properties_of(".xyz", "0 0 0 0 0 1\r\n1 0 0 0 0.6 0.8") ==
        "nx:float64=0 ny:float64=0.6 nz:float64=0.8 ");
}

TEST_CASE("what_is_wrong_with_a_file_is_told_with_its_place", "[files]") {
  struct Wrong {
    const char* suffix;
    std::string text;
    const char* message;
  };
  const std::string triangle = stl({0, 0, 0, 1, 0, 0, 0, 1, 0}, 1);
  const std::vector<Wrong> wrong = {
      {".off", "", "'test.off', line 1: is no OFF file: it has no words"},
      {".off", "\xFF\xFEO", "text in UTF-16"},
      {".off", "ply\n", "line 1: an OFF file begins with 'OFF', not with 'ply'"},
      {".off", "XOFF\n1 1 1\n", "'XOFF' is no keyword"},
      {".off", replaced(square_off, "0 0 0", "0 0"),
       "line 3, vertex 0: the line ends where a coordinate is expected"},
      {".off", replaced(square_off, "1 1 0", "1 12,5 0"),
       "line 5, vertex 2: '12,5' is no number, which a coordinate has to be (decimal commas are "
       "not"},
      {".off", replaced(square_off, "3 0 1 2", "3 0 1 4"), "line 7, face 0: names vertex 4, of 4"},
      {".off", replaced(square_off, "3 0 1 2", "3 0 1 -1"),
       "line 7, face 0: names vertex -1, of 4"},
      {".off", replaced(square_off, "3 0 1 2", "3 0 1"), "line 7, face 0: the line ends where"},
      {".off", replaced(square_off, "3 0 1 2", "2 0 1"), "line 7, face 0: has 2 corners"},
      {".off", replaced(square_off, "4 2 0", "4 3 0"), "face 2: the file ends too early"},
      {".off", replaced(square_off, "4 2 0", "-4 2 0"), "the number of vertices is -4"},
      {".off", replaced(square_off, "4 2 0", "4000000 2 0"), "the 4000000 vertices do not fit"},
      {".off", replaced(square_off, "3 0 1 2", "2000000000 0 1 2"), "corners do not fit"},
      {".off", "nOFF\n4\n1 1 1\n", "has points of dimension 4, not 3"},
      {".off", std::string("OFF\n1 1 0\n0 0 \0", 16), "is not text: byte 14 is 0"},
      {".obj", replaced(square_obj, "f 1 2 3", "f 1 2 5"), "line 5, face 0: names vertex 5, of 4"},
      {".obj", replaced(square_obj, "f 1 2 3", "f 1 2 0"), "line 5, face 0: names vertex 0"},
      {".obj", replaced(square_obj, "f 1 2 3", "f 1 2 -5"), "line 5, face 0: names vertex -5"},
      {".obj", replaced(square_obj, "f 1 2 3", "f 1 2 x"), "line 5, face 0: 'x' is no corner"},
      {".obj", replaced(square_obj, "f 1 2 3", "f 1 2"), "line 5, face 0: has 2 corners"},
      {".obj", replaced(square_obj, "v 1 1 0", "v 1 1"), "line 3, vertex 2: the line ends"},
      {".ply", "plY\n", "line 1: a PLY file begins with 'ply'"},
      {".ply", "ply\nformat ascii 1.0\n", "the header has no end"},
      {".ply", "ply\nelement vertex 1\nproperty float x\nend_header\n", "names no format"},
      {".ply", replaced(square_ply, "ascii", "middle_endian"), "'middle_endian' is no format"},
      {".ply", replaced(square_ply, "float z", "float w"),
       "there is no vertex property 'z'; there are: x, y, w"},
      {".ply", replaced(square_ply, "float z", "quad z"), "line 7: 'quad' is no type of PLY files"},
      {".ply", replaced(square_ply, "vertex_indices", "indices"),
       "have no list 'vertex_indices' or"},
      {".ply", replaced(square_ply, "vertex 4", "vertex -4"),
       "line 4: the number of elements is negative"},
      {".ply", replaced(square_ply, "vertex 4", "vertex 400000"),
       "the 400000 elements 'vertex' do not fit"},
      {".ply", replaced(square_ply, "3 0 1 2", "3 0 1 7"), "line 15, face 0: names vertex 7, of 4"},
      {".ply", replaced(square_ply, "3 0 1 2", "2147483647 0 1 2"),
       "face 0: the 2147483647 numbers"},
      {".ply", replaced(square_ply, "3 0 1 2", "-3 0 1 2"),
       "face 0: the length of 'vertex_indices' is neg"},
      {".ply", replaced(square_ply, "1 1 0", "1 1 0 5"),
       "line 13, vertex 2: the line has more numbers"},
      {".ply", replaced(square_ply, "1 1 0", "1 1"), "vertex 2: the line has more numbers"},
      {".stl", "hello\n", "no line of it begins with 'solid'"},
      {".stl", triangle.substr(0, 100), "its 1 triangles would take 134 bytes, and it has 100"},
      {".stl", triangle.substr(0, 50) + std::string(3, '\0'),
       "that has 84 bytes at least, this 53"},
      {".stl", stl({0, 0, 0, 1, 0, 0, 0, std::numeric_limits<float>::quiet_NaN(), 0}, 1),
       "face 0: has a coordinate that is not finite"},
      {".stl", replaced(square_stl, "vertex 1 1 0", "vertex 1 1"),
       "line 6, face 0: the line ends where"},
      {".stl", replaced(square_stl, "vertex 1 1 0\n", ""), "face 0: has 2 corners"},
      {".stl", replaced(square_stl, "endfacet\n", ""),
       "'facet' stands where 'endfacet' is expected"},
      {".stl", square_stl.substr(0, 70), "face 0:"},
      {".vtk", "# vtk\n", "line 1: a VTK file begins with '# vtk DataFile Version'"},
      {".vtk", replaced(square_vtk, "POLYDATA", "UNSTRUCTURED_GRID"),
       "holds a unstructured_grid; of VTK"},
      {".vtk", replaced(square_vtk, "ASCII", "TEXT"), "'text' is neither 'ASCII' nor 'BINARY'"},
      {".vtk", replaced(square_vtk, "POLYGONS 2 8", "POLYGONS 2 9"),
       "the file ends too early: it has 8 of 9"},
      {".vtk", replaced(square_vtk, "POLYGONS 2 8", "POLYGONS 3 8"), "do not have the size"},
      {".vtk", replaced(square_vtk, "3 0 1 2", "3 0 1 9"), "face 0: names vertex 9, of 4"},
      {".vtk", replaced(square_vtk, "POINTS 4 float", "POINTS 4 string"),
       "numbers of type 'string' are not"},
      {".vtk", square_vtk + "POINT_DATA 5\n", "there are 5 values at 4 points"},
      {".ts", "GOCAD VSet 1\n", "holds a VSet; of GOCAD files only TSurf is read"},
      {".ts", replaced(square_ts, "TRGL 1 2 3", "TRGL 1 2 9"),
       "names vertex 9, which is not there"},
      {".xyz", "0 0 0\n0 0\n", "line 2, vertex 1: a line has three or six numbers, this one 2"},
      {".xyz", "0 0 0\n0 0 0 1 1 1\n", "line 2, vertex 1: this line has 6 numbers, those above 3"},
      {".xyz", "0;0;0\n", "line 1, vertex 0: '0;0;0' is no number"},
      {".vtp", "<VTKFile>",
       "'test.vtp' has the suffix .vtp, which is not read; known are .off, .obj, "},
      {"", "OFF", "'test' has no suffix; known are .off"}};
  for(const Wrong& w : wrong) {
    CAPTURE(w.suffix, w.text, w.message);
    const std::string message = refusal(w.suffix, w.text);
    CAPTURE(message);
    CHECK(says(message, w.message));
  }
  // the place, for programs
  try {
    read(".off", replaced(square_off, "3 0 2 3", "3 0 2 4"));
    FAIL();
  } catch(const RL::File_error& e) {
    const RL::File_place place = e.place();
    CHECK(place.line == 8u);
    CHECK(place.face == 1u);
    CHECK(!place.vertex);
    CHECK(!place.byte);
  }
}

TEST_CASE("files_that_are_cut_are_refused_or_read", "[files]") {
  const std::string binary = ply(false, false, true);
  for(std::size_t size = 1; size < binary.size(); size += 3)
    CHECK(!refusal(".ply", binary.substr(0, size)).empty());
  // the end of a text may be that of another one; anything but a File_error is a failure
  for(const Text_file& square : squares)
    for(std::size_t size = 0; size < square.text.size(); ++size)
      refusal(square.suffix, square.text.substr(0, size));
}

TEST_CASE("small_files_of_all_formats_are_read", "[files]") {
  // fuzzers begin with them
  std::size_t number = 0;
  for(const auto& entry : std::filesystem::directory_iterator(folder_of_small_meshes)) {
    const std::string file = entry.path().string();
    CAPTURE(file);
    RL::Mesh_file mesh;
    CHECK_NOTHROW(mesh = RL::read_mesh_file(file));
    CHECK_FALSE(mesh.points.empty());
    const bool has_faces = !says(file, "points.") && !says(file, ".xyz");
    CHECK(mesh.triangles.empty() != has_faces);
    std::vector<RL::Vertex_property> properties;
    CHECK_NOTHROW(properties = RL::read_vertex_properties(file));
    for(const RL::Vertex_property& property : properties)
      CHECK(property.values.size() == mesh.points.size());
    ++number;
  }
  CHECK(number >= 28);
}

TEST_CASE("what_is_no_file_is_refused", "[files]") {
  const auto message = [](const std::string& file) {
    try {
      RL::read_mesh_file(file);
    } catch(const RL::File_error& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  CHECK(says(message("no_such_file.ply"), "'no_such_file.ply' cannot be opened: "));
  const Scratch_file empty(".off", "");
  CHECK(says(message(empty.name), "' has 0 bytes"));
  const std::string folder = empty.name + ".folder.ply";
  std::filesystem::create_directory(folder);
  CHECK(says(message(folder), "' is a directory"));
  std::filesystem::remove(folder);
  if(std::filesystem::exists("/dev/null")) {
    const std::string device = empty.name + ".device.ply";
    std::filesystem::create_symlink("/dev/null", device);
    CHECK(says(message(device), "' is a pipe or a device"));
    std::filesystem::remove(device);
  }
}

TEST_CASE("polygons_of_any_size_are_divided", "[files]") {
  for(const bool is_flat : {true, false})
    for(const int n : {4, 5, 50, 51, 500, 501, 3000}) {
      CAPTURE(n, is_flat);
      double area = 0; // of the shadow
      std::ostringstream text;
      text << "OFF\n" << n << " 1\n";
      for(int i = 0; i < n; ++i) { // a star
        const int r = 1 + i % 2, next_r = i + 1 == n ? 1 : 3 - r;
        text << r * std::cos(2 * 3.14159265 * i / n) << ' ' << r * std::sin(2 * 3.14159265 * i / n)
             << ' ' << (is_flat ? 0 : i % 3) << '\n';
        area += r * next_r * std::sin(2 * 3.14159265 / n) / 2;
      }
      text << n;
      for(int i = 0; i < n; ++i)
        text << ' ' << i;
      const RL::Mesh_file mesh = read(".off", text.str());
      CHECK(mesh.triangles.size() == static_cast<std::size_t>(n - 2));
      CHECK(mesh.number_of_divided_faces == 1);
      if(is_flat)
        CHECK(RL::Triangulated_surface_3(mesh.points, mesh.triangles).area() ==
              Approx(area).epsilon(1e-4)); // six digits in the file
    }
  // all corners on a line, at one place, or not finite
  for(const char* point : {"%d 0 0\n", "0 0 0\n", "nan 0 0\n"}) {
    std::string text = "OFF\n300 1\n";
    for(int i = 0; i < 300; ++i) {
      char line[40];
      std::snprintf(line, sizeof line, point, i);
      text += line;
    }
    text += "300";
    for(int i = 0; i < 300; ++i)
      text += ' ' + std::to_string(i);
    CHECK(read(".off", text).triangles.size() == 298);
  }
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
  const RL::Mesh_file soup = RL::read_mesh_file(ply_file.name, params::progress([&](double part) {
                                                  parts.push_back(part);
                                                  return true;
                                                }));
  CHECK(soup.points.size() == 251001);
  CHECK(soup.points.back() == Point(n, n, n * n));
  CHECK(soup.triangles == expected);
  CHECK(parts.size() >= 3);
  CHECK(std::is_sorted(parts.begin(), parts.end()));
  CHECK(parts.back() == 1);
  CHECK_THROWS_AS(
      RL::read_mesh_file(ply_file.name, params::progress([](double part) { return part < 0.5; })),
      RL::Canceled);

  const Scratch_file stl_file(".stl", stl(coordinates, 500000));
  const RL::Mesh_file joined = RL::read_mesh_file(stl_file.name);
  CHECK(joined.points.size() == 251001);
  REQUIRE(joined.triangles.size() == expected.size());
  std::size_t number_of_equal_corners = 0;
  for(std::size_t i = 0; i < expected.size(); ++i)
    for(std::size_t k = 0; k < 3; ++k)
      number_of_equal_corners +=
          joined.points[joined.triangles[i][k]] == soup.points[expected[i][k]];
  CHECK(number_of_equal_corners == 3 * expected.size());
}

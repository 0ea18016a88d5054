// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// What goes into the parts of a surface and comes out of them: slices of files, values at vertices.

#include "../catch.h"
#include "../special_shapes.h"
#include "slices.h"

#include <CGAL/Restricted_laplacian_3/distributed/surface_slices.h>
#include <CGAL/Restricted_laplacian_3/distributed/vertex_values.h>
#include <CGAL/Restricted_laplacian_3/distributed/write_in_order.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_function_3.h>

#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
using shapes::Triangles;

/// the same name on all ranks
std::string temporary_file() {
  const RL::Communicator communicator;
  const std::string name = (std::filesystem::temp_directory_path() /
                            ("restricted_laplacian_3_" + std::to_string(getpid()) + ".ply"))
                               .string();
  std::vector<char> letters(name.begin(), name.end());
  communicator.broadcast(letters, 0);
  return std::string(letters.begin(), letters.end());
}

enum class Kind { little, big, text, with_a_quadrangle, cut_off };

template <class T> void write(std::ostream& out, T value, bool is_reversed) {
  std::array<char, sizeof(T)> bytes;
  for(std::size_t i = 0; i < sizeof(T); ++i)
    bytes[i] = reinterpret_cast<const char*>(&value)[is_reversed ? sizeof(T) - 1 - i : i];
  out.write(bytes.data(), bytes.size());
}

/// with properties that are of no interest
void write_ply(const std::string& file, const Triangles& t, Kind kind) {
  std::ofstream out(file, std::ios::binary);
  const bool is_big = kind == Kind::big, has_quadrangle = kind == Kind::with_a_quadrangle;
  out << "ply\nformat "
      << (kind == Kind::text ? "ascii"
          : is_big           ? "binary_big_endian"
                             : "binary_little_endian")
      << " 1.0\ncomment element face 7\nelement camera 1\nproperty short exposure\nelement vertex "
      << t.points.size()
      << "\nproperty uchar red\nproperty double x\nproperty float y\nproperty double z\nelement "
         "face "
      << t.faces.size() + has_quadrangle
      << "\nproperty list uchar int vertex_indices\nproperty ushort group\nend_header\n";
  write(out, std::int16_t(1), is_big);
  for(const RL::Point_3& p : t.points) {
    write(out, std::uint8_t(255), is_big);
    write(out, p.x(), is_big);
    write(out, static_cast<float>(p.y()), is_big);
    write(out, p.z(), is_big);
  }
  if(has_quadrangle) {
    write(out, std::uint8_t(4), is_big);
    for(std::int32_t v = 0; v < 4; ++v)
      write(out, v, is_big);
    write(out, std::uint16_t(3), is_big);
  }
  const std::size_t left = kind == Kind::cut_off ? t.faces.size() / 2 : t.faces.size();
  for(std::size_t f = 0; f < left; ++f) {
    write(out, std::uint8_t(3), is_big);
    for(std::uint32_t v : t.faces[f])
      write(out, static_cast<std::int32_t>(v), is_big);
    write(out, std::uint16_t(3), is_big);
  }
}

void check_slices(const RL::Communicator& communicator, const RL::Surface_slice& slice,
                  const Triangles& t, double tolerance) {
  const auto points = communicator.concatenation(slice.points);
  const auto triangles = communicator.concatenation(slice.triangles);
  REQUIRE(points.size() == t.points.size());
  CHECK(triangles == t.faces);
  double largest = 0;
  for(std::size_t v = 0; v < points.size(); ++v)
    largest = (std::max)(largest, (points[v] - t.points[v]).squared_length());
  CHECK(std::sqrt(largest) <= tolerance);
  // no rank has much more than the others
  CHECK(slice.triangles.size() <= triangles.size() / communicator.size() + 1);
}

} // namespace

TEST_CASE("ranks_read_slices_of_a_file", "[shapes]") {
  const RL::Communicator communicator;
  const Triangles t = shapes::sphere(3);
  const std::string file = temporary_file();
  for(Kind kind : {Kind::little, Kind::big}) {
    if(communicator.rank() == 0)
      write_ply(file, t, kind);
    communicator.agree([] {});
    const auto slice = RL::read_binary_ply_slice(communicator, file);
    REQUIRE(slice);
    check_slices(communicator, *slice, t, 1e-7);
    CHECK(!slice->is_point_set);
    CHECK(RL::read_surface_slice(communicator, file).triangles == slice->triangles);
  }
  for(Kind kind : {Kind::text, Kind::with_a_quadrangle}) {
    if(communicator.rank() == 0)
      write_ply(file, t, kind);
    communicator.agree([] {});
    CHECK(!RL::read_binary_ply_slice(communicator, file));
  }
  // the quadrangle becomes two triangles
  const auto triangles = RL::read_surface_slice(communicator, file).triangles;
  CHECK(communicator.sum(static_cast<std::uint64_t>(triangles.size())) == t.faces.size() + 2);
  if(communicator.rank() == 0)
    write_ply(file, t, Kind::cut_off);
  communicator.agree([] {});
  CHECK_THROWS_AS(RL::read_binary_ply_slice(communicator, file), RL::Distributed_error);
  communicator.agree([] {});
  if(communicator.rank() == 0)
    std::remove(file.c_str());
  communicator.agree([] {});
  CHECK_THROWS_AS(RL::read_binary_ply_slice(communicator, file), RL::Distributed_error);
}

TEST_CASE("the_first_rank_gives_the_others_their_slices", "[shapes]") {
  const RL::Communicator communicator;
  const Triangles t = shapes::sphere(2);
  const RL::Triangulated_surface_3 surface(t.points, t.faces);
  const bool is_first = communicator.rank() == 0;
  const RL::Surface_slice slice =
      RL::slice_of_first_rank(communicator, is_first ? &surface : nullptr);
  check_slices(communicator, slice, t, 0);

  const RL::Triangulated_surface_3 points(
      t.points, std::vector<RL::Vector_3>(t.points.size(), RL::Vector_3(0, 0, 2)),
      std::vector<double>(t.points.size(), 3.));
  const RL::Surface_slice of_points =
      RL::slice_of_first_rank(communicator, is_first ? &points : nullptr);
  CHECK(of_points.is_point_set);
  CHECK(communicator.concatenation(of_points.points) == t.points);
  CHECK(of_points.normals ==
        std::vector<RL::Vector_3>(of_points.points.size(), RL::Vector_3(0, 0, 1)));
  CHECK(of_points.areas == std::vector<double>(of_points.points.size(), 3.));
}

TEST_CASE("values_at_vertices_come_in_the_order_of_the_file", "[shapes]") {
  const RL::Communicator communicator;
  Triangles t = shapes::joined(shapes::sphere(3), shapes::box(0.8, 0.7, 0.03, 3, 1));
  // vertices without a face, or with one that has no area
  t.points.insert(t.points.begin() + 5, RL::Point_3(0.3, 0.2, 0.1));
  for(auto& f : t.faces)
    for(std::uint32_t& v : f)
      v += v >= 5;
  t.points.emplace_back(2, 2, 2);
  t.faces.push_back({static_cast<std::uint32_t>(t.points.size() - 1), 1, 1});
  const RL::Triangulated_surface_3 surface(t.points, t.faces);
  RL::Spline_space_options options;
  options.depth = 5;
  const RL::Distributed_surface distributed(communicator, slice_of(surface, communicator));
  const RL::Distributed_space space(distributed, options);
  const RL::Spline_space_3 whole(surface, options);

  Eigen::VectorXd all(static_cast<Eigen::Index>(whole.dimension()));
  for(Eigen::Index i = 0; i < all.size(); ++i)
    all[i] = std::sin(0.37 * static_cast<double>(i));
  Eigen::VectorXd of_part(static_cast<Eigen::Index>(space.part().dimension()));
  for(Eigen::Index i = 0; i < of_part.size(); ++i)
    of_part[i] = all[static_cast<Eigen::Index>(space.level(5).elements[i])];
  const std::vector<double> values =
      communicator.concatenation(RL::values_at_vertices(distributed, space, of_part));
  const std::vector<double> expected = RL::Spline_function_3(whole, all).values_at_vertices();
  REQUIRE(values.size() == expected.size());
  double largest = 0;
  int number_of_nans = 0;
  for(std::size_t v = 0; v < values.size(); ++v) {
    REQUIRE(std::isnan(values[v]) == std::isnan(expected[v]));
    number_of_nans += std::isnan(values[v]);
    if(!std::isnan(values[v]))
      largest = (std::max)(largest, std::abs(values[v] - expected[v]));
  }
  CHECK(largest <= 1e-12);
  CHECK(number_of_nans == 2);

  // and the other way
  std::vector<double> numbers;
  const auto first = distributed.first_vertices()[communicator.rank()];
  for(auto v = first; v < distributed.first_vertices()[communicator.rank() + 1]; ++v)
    numbers.push_back(static_cast<double>(v));
  const std::vector<double> in_part = RL::vertex_values_of_part(distributed, space, numbers);
  REQUIRE(in_part.size() == space.surface_part().vertices.size());
  for(std::size_t i = 0; i < in_part.size(); ++i)
    CHECK(in_part[i] == space.surface_part().vertices[i]);
  // of the coordinate x, over a surface with this area
  std::vector<double> x;
  for(const RL::Point_3& p : distributed.points())
    x.push_back(p.x());
  double sum = 0;
  for(std::size_t i = 0; i < surface.number_of_faces(); ++i)
    for(std::uint32_t v : surface.triangle(i))
      sum += surface.area(i) * surface.point(v).x() / 3;
  CHECK(std::abs(RL::surface_mean(distributed, x) - sum / surface.area()) <= 1e-12);
  numbers.push_back(0);
  CHECK_THROWS_AS(RL::surface_mean(distributed, numbers), RL::Distributed_error);
  CHECK_THROWS_AS(RL::vertex_values_of_part(distributed, space, numbers), RL::Distributed_error);
}

TEST_CASE("ranks_write_a_file_in_their_order", "[shapes]") {
  const RL::Communicator communicator;
  const std::string file = temporary_file();
  const auto content = [&] {
    std::ifstream in(file, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  std::string expected = "first";
  for(int rank = 0; rank < communicator.size(); ++rank)
    expected += std::string(static_cast<std::size_t>(rank), static_cast<char>('a' + rank));
  const auto parts_of = [&](int rank) {
    return std::vector<std::string>{
        rank == 0 ? "first" : "",
        std::string(static_cast<std::size_t>(rank), static_cast<char>('a' + rank))};
  };
  for(int time = 0; time < 2; ++time) { // a new file, and one that is there
    RL::write_in_order(communicator, file, parts_of(communicator.rank()));
    CHECK(content() == expected);
    CHECK(!std::filesystem::exists(file + ".part"));
    communicator.agree([] {}); // before it is written again
  }
  // a disk that is full for the last rank: what was there remains, and nothing else
  const bool is_last = communicator.rank() == communicator.size() - 1;
  rlimit limit, small;
  REQUIRE(getrlimit(RLIMIT_FSIZE, &limit) == 0);
  small = limit;
  small.rlim_cur = 1 << 16;
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  REQUIRE(setrlimit(RLIMIT_FSIZE, is_last ? &small : &limit) == 0);
  CHECK_THROWS_AS(RL::write_in_order(communicator, file, {std::string(1 << 17, 'x')}),
                  RL::Distributed_error);
  REQUIRE(setrlimit(RLIMIT_FSIZE, &limit) == 0);
  std::signal(SIGXFSZ, handler);
  communicator.agree([] {});
  CHECK(content() == expected);
  CHECK(!std::filesystem::exists(file + ".part"));
  communicator.agree([] {});
  // the device is still one
  if(std::filesystem::exists("/dev/full")) {
    CHECK_THROWS_AS(RL::write_in_order(communicator, "/dev/full", parts_of(communicator.rank())),
                    RL::Distributed_error);
    CHECK(!std::filesystem::is_regular_file("/dev/full"));
  }
  CHECK_THROWS_AS(
      RL::write_in_order(communicator, "/no/such/folder/file", parts_of(communicator.rank())),
      RL::Distributed_error);
  communicator.agree([] {});
  if(communicator.rank() == 0)
    std::remove(file.c_str());
}

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces that are smoothed, sharpened and edited: what becomes of waves, planes and creases.

#include "catch.h"
#include "special_shapes.h"

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/edit_surface.h>
#include <CGAL/Restricted_laplacian_3/problems/Curvature_field.h>
#include <CGAL/Restricted_laplacian_3/smooth_surface.h>

#include <CGAL/Surface_mesh.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;
using shapes::Triangles;

const double full_turn = 2 * std::acos(-1.);

RL::Spline_space_3 editing_space(const Triangles& t, int depth) {
  return RL::Spline_space_3(RL::soup(t.points, t.faces), params::depth(depth));
}

Eigen::MatrixXd rows_of(const Triangles& t) {
  Eigen::MatrixXd result(static_cast<Eigen::Index>(t.points.size()), 3);
  for(std::size_t i = 0; i < t.points.size(); ++i)
    result.row(static_cast<Eigen::Index>(i)) << t.points[i].x(), t.points[i].y(), t.points[i].z();
  return result;
}

/// harmonics of the degrees 1 to 4 on the sphere: eigenvalues 2, 6, 12, 20
Eigen::MatrixXd harmonics(const Triangles& sphere) {
  Eigen::MatrixXd result(static_cast<Eigen::Index>(sphere.points.size()), 4);
  for(std::size_t i = 0; i < sphere.points.size(); ++i) {
    const RL::Point_3& p = sphere.points[i];
    const double x = p.x(), y = p.y(), z = p.z();
    result.row(static_cast<Eigen::Index>(i)) << z, x * y, z * (5 * z * z - 3) / 2,
        x * y * (7 * z * z - 1);
  }
  return result;
}

/// a sphere whose triangles are long near its poles, which are small holes
Triangles globe() {
  constexpr int n = 48;
  Triangles t = shapes::grid(n, [](double x, double y) {
    const double longitude = full_turn * x, latitude = full_turn / 2 * (0.001 + 0.998 * y);
    return RL::Point_3(std::sin(latitude) * std::cos(longitude),
                       std::sin(latitude) * std::sin(longitude), std::cos(latitude));
  });
  // the last point of each row is the first one
  for(auto& face : t.faces)
    for(auto& v : face)
      v = v / (n + 1) * n + v % (n + 1) % n;
  for(std::size_t row = 0; row <= n; ++row)
    for(std::size_t i = 0; i < n; ++i)
      t.points[row * n + i] = t.points[row * (n + 1) + i];
  t.points.resize(n * (n + 1));
  return t;
}

/// positions with noise along the normals of a shape around the origin
Triangles with_noise(Triangles t, double deviation) {
  std::mt19937 generator(5);
  std::normal_distribution<double> normal(0, deviation);
  for(RL::Point_3& p : t.points) {
    const RL::Vector_3 v = p - CGAL::ORIGIN;
    p = p + v * (normal(generator) / std::sqrt(v.squared_length()));
  }
  return t;
}

/// the part of a wave that the filter leaves
double passed(double eigenvalue, double length, double factor) {
  const double ratio = eigenvalue / std::pow(full_turn / length, 2);
  return factor + (1 - factor) / (1 + ratio * ratio);
}

} // namespace

TEST_CASE("filter_has_the_response_that_it_states", "[editing]") {
  for(const Triangles& t : {shapes::sphere(5), globe()}) {
    const RL::Spline_space_3 space = editing_space(t, 5);
    const Eigen::MatrixXd x = harmonics(t);
    for(const double length : {0.8, 2.5})
      for(const double factor : {0., 2.}) {
        const RL::Edited_signal result = RL::scale_details(space, length, factor, {}, x);
        CHECK(result.converged);
        for(int k = 0; k < 4; ++k) {
          const double expected = passed((k + 1) * (k + 2), length, factor),
                       error = (result.values.col(k) - expected * x.col(k)).cwiseAbs().maxCoeff() /
                               x.col(k).cwiseAbs().maxCoeff();
          INFO("length " << length << ", factor " << factor << ", degree " << k + 1 << ": "
                         << expected << ", error " << error);
          CHECK(error < 1e-2);
        }
      }
  }
}

TEST_CASE("editing_has_the_response_that_it_states", "[editing]") {
  const Triangles t = shapes::sphere(5);
  const RL::Spline_space_3 space = editing_space(t, 5);
  const Eigen::MatrixXd x = harmonics(t);
  for(const double alpha : {1., 10., 100.}) {
    const RL::Surface_editor editor(space, alpha, {}, x);
    CHECK((editor.edit(1).values - x).cwiseAbs().maxCoeff() < 1e-14);
    for(const double scale : {0., 0.5, 2.}) {
      const Eigen::MatrixXd found = editor.edit(scale).values,
                            by_function =
                                editor.edit([&](const RL::Surface_point&) { return scale; }).values;
      // what solvers leave
      CHECK((found - by_function).cwiseAbs().maxCoeff() < 2e-3);
      for(int k = 0; k < 4; ++k) {
        const double eigenvalue = (k + 1) * (k + 2),
                     expected = (alpha + scale * eigenvalue) / (alpha + eigenvalue);
        INFO("alpha " << alpha << ", scale " << scale << ", degree " << k + 1);
        CHECK((found.col(k) - expected * x.col(k)).cwiseAbs().maxCoeff() < 5e-3);
      }
    }
  }
  // a stroke changes what is near it
  const RL::Surface_editor editor(space, 400);
  const RL::Edited_signal stroke =
      editor.edit([](const RL::Surface_point& p) { return p.point.z() > 0.5 ? 0. : 1.; });
  const Eigen::VectorXd change = (stroke.values - rows_of(t)).rowwise().norm();
  for(std::size_t v = 0; v < t.points.size(); ++v)
    if(t.points[v].z() < 0)
      CHECK(change[static_cast<Eigen::Index>(v)] < 1e-4);
  CHECK(change.maxCoeff() > 3e-3);
}

TEST_CASE("planes_remain_what_they_are", "[editing]") {
  // the boundary does not move either, other than by a filter with a natural condition
  const Triangles t =
      shapes::grid(20, [](double x, double y) { return RL::Point_3(x, 0.7 * y, 0.2 * x - y); });
  const RL::Spline_space_3 space = editing_space(t, 5);
  const Eigen::MatrixXd x = rows_of(t);
  for(const double length : {0.1, 0.5, 3.})
    for(const double factor : {0., 3.}) {
      INFO(length << ", " << factor);
      CHECK((RL::scale_details(space, length, factor).values - x).cwiseAbs().maxCoeff() < 5e-5);
    }
  RL::Editing_options creases;
  creases.crease_angle = 30;
  CHECK((RL::smooth_between_creases(space, 0.3, creases).values - x).cwiseAbs().maxCoeff() < 1e-12);
  // nor does a fan, whose faces are all neighbors of each other
  Triangles fan;
  constexpr std::uint32_t size = 8000;
  fan.points.emplace_back(0, 0, 0);
  for(std::uint32_t i = 0; i < size; ++i) {
    fan.points.emplace_back(std::cos(full_turn * i / size), std::sin(full_turn * i / size), 0);
    fan.faces.push_back({0, i + 1, (i + 1) % size + 1});
  }
  const RL::Spline_space_3 disk = editing_space(fan, 4);
  CHECK(
      (RL::smooth_between_creases(disk, 0.3, creases).values - rows_of(fan)).cwiseAbs().maxCoeff() <
      1e-12);
}

TEST_CASE("smoothing_does_not_depend_on_the_unit_of_length_or_on_threads", "[editing]") {
  const Triangles t = with_noise(shapes::sphere(4), 0.01);
  const auto smoothed = [&](double unit, const RL::Spline_space_options& options,
                            bool has_creases) {
    const Triangles scaled = shapes::scaled(t, unit);
    const RL::Spline_space_3 space(RL::read_surface(RL::soup(scaled.points, scaled.faces)),
                                   options);
    RL::Editing_options editing;
    editing.tolerance = 1e-9;
    if(has_creases)
      editing.crease_angle = 60;
    return Eigen::MatrixXd((has_creases ? RL::smooth_between_creases(space, 0.6 * unit, editing)
                                        : RL::scale_details(space, 0.6 * unit, 0, editing))
                               .values /
                           unit);
  };
  RL::Spline_space_options options, parallel;
  options.depth = parallel.depth = 5;
  parallel.is_parallel = true;
  for(const bool has_creases : {false, true}) {
    const Eigen::MatrixXd expected = smoothed(1, options, has_creases);
    for(const double unit : {1e-6, 1e6})
      CHECK((smoothed(unit, options, has_creases) - expected).cwiseAbs().maxCoeff() < 1e-6);
    CHECK((smoothed(1, parallel, has_creases) - expected).cwiseAbs().maxCoeff() == 0);
    // and noise goes
    const Eigen::ArrayXd radius = expected.rowwise().norm().array();
    const double deviation = std::sqrt((radius - radius.mean()).square().mean());
    INFO("creases " << has_creases << ", deviation " << deviation);
    CHECK(deviation < 0.005);
  }
}

TEST_CASE("creases_are_kept", "[editing]") {
  // a box, whose edges are right angles
  Triangles clean = shapes::split_in_four(shapes::split_in_four(
      shapes::split_in_four(shapes::moved(shapes::box(1, 0.8, 0.6, 3, 1), {-0.5, -0.4, -0.3}))));
  const Triangles noisy = with_noise(clean, 0.002);
  const auto normals = [&](const Eigen::MatrixXd& x) {
    std::vector<Eigen::Vector3d> result;
    for(const auto& f : clean.faces) {
      const Eigen::Vector3d a = x.row(static_cast<Eigen::Index>(f[0])),
                            b = x.row(static_cast<Eigen::Index>(f[1])),
                            c = x.row(static_cast<Eigen::Index>(f[2]));
      result.push_back((b - a).cross(c - a).normalized());
    }
    return result;
  };
  const std::vector<Eigen::Vector3d> of_clean = normals(rows_of(clean));
  // the largest angle of nine tenths of the faces at a crease, and of all others
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> face_at;
  std::vector<bool> is_at_crease(clean.faces.size(), false);
  for(std::size_t f = 0; f < clean.faces.size(); ++f)
    for(int i = 0; i < 3; ++i) {
      const std::size_t a = clean.faces[f][i], b = clean.faces[f][(i + 1) % 3];
      const auto other = face_at.find({b, a});
      face_at[{a, b}] = f;
      if(other != face_at.end() && of_clean[f].dot(of_clean[other->second]) < 0.5)
        is_at_crease[f] = is_at_crease[other->second] = true;
    }
  const auto angles = [&](const Eigen::MatrixXd& x) {
    const std::vector<Eigen::Vector3d> found = normals(x);
    std::array<std::vector<double>, 2> result;
    for(std::size_t f = 0; f < found.size(); ++f)
      result[is_at_crease[f]].push_back(std::acos((std::min)(found[f].dot(of_clean[f]), 1.)) * 360 /
                                        full_turn);
    std::array<double, 2> of_most;
    for(int k = 0; k < 2; ++k) {
      std::sort(result[k].begin(), result[k].end());
      of_most[k] = result[k][result[k].size() * 9 / 10];
    }
    return of_most;
  };
  const RL::Spline_space_3 space = editing_space(noisy, 6);
  RL::Editing_options options;
  options.crease_angle = 40;
  const auto before = angles(rows_of(noisy)),
             after = angles(RL::smooth_between_creases(space, 0.25, options).values),
             without = angles(RL::scale_details(space, 0.25, 0).values);
  INFO("on faces " << before[0] << " -> " << after[0] << ", at creases " << before[1] << " -> "
                   << after[1] << ", without the angle " << without[1]);
  CHECK(before[0] > 6);
  CHECK(after[0] < before[0] / 3);
  CHECK(after[1] < 5);
  CHECK(without[1] > 20);
  // and curvature as a metric keeps more of them than none
  const double alpha = std::pow(full_turn / 0.25, 2);
  options.crease_angle.reset();
  options.anisotropic = 10;
  const auto anisotropic = angles(
                 RL::Surface_editor(RL::internal::space_to_edit(space, alpha, options), alpha)
                     .edit(0)
                     .values),
             isotropic = angles(RL::Surface_editor(space, alpha).edit(0).values);
  INFO("anisotropic " << anisotropic[1] << ", isotropic " << isotropic[1]);
  CHECK(anisotropic[1] < 0.7 * isotropic[1]);
}

TEST_CASE("metric_with_normals_is_that_of_a_larger_sphere", "[editing]") {
  // (x, w n) on the unit sphere is a sphere of the radius (1 + w^2)^(1/2)
  const RL::Spline_space_3 space = editing_space(shapes::sphere(4), 4);
  const RL::Curvature_field curvature = RL::estimate_curvature(space);
  const RL::Spline_space_3 larger = space.with_material(RL::normal_metric(curvature, 2));
  const RL::Operators before = RL::assemble_operators(space),
                      after = RL::assemble_operators(larger);
  CHECK(after.mass.sum() / before.mass.sum() == Approx(5).epsilon(0.02));
  CHECK((after.stiffness - before.stiffness).norm() < 0.03 * before.stiffness.norm());
  for(const double bad : {-1., std::numeric_limits<double>::quiet_NaN()})
    CHECK_THROWS_AS(RL::normal_metric(curvature, bad), RL::Parameter_error);
}

TEST_CASE("smoothing_functions_take_meshes", "[editing]") {
  const Triangles t = with_noise(shapes::sphere(4), 0.01);
  shapes::Mesh mesh = shapes::mesh(t);
  auto copy = mesh.add_property_map<shapes::Mesh::Vertex_index, RL::Point_3>("v:copy").first;
  const auto deviation = [](const auto& points) {
    std::vector<double> radii;
    double mean = 0, result = 0;
    for(const RL::Point_3& p : points) {
      radii.push_back(std::sqrt((p - CGAL::ORIGIN).squared_length()));
      mean += radii.back();
    }
    mean /= static_cast<double>(radii.size());
    for(const double r : radii)
      result += (r - mean) * (r - mean);
    return std::sqrt(result / static_cast<double>(radii.size()));
  };
  // the depth follows from the length
  CHECK(RL::smooth_surface(mesh, 0.6, copy).converged);
  const double smooth = deviation(copy);
  CHECK(smooth < 0.004);
  CHECK(RL::sharpen_surface(mesh, 0.6, 2, copy).converged);
  CHECK(deviation(copy) > 0.018);
  CHECK(RL::edit_surface(mesh, 0, 100, copy, params::depth(5)).converged);
  CHECK(deviation(copy) < 0.005);
  // a property map as scale, and the points of the mesh itself
  auto scale = mesh.add_property_map<shapes::Mesh::Vertex_index, double>("v:scale", 1).first;
  CHECK(RL::edit_surface(mesh, scale, 100, copy, params::depth(5)).converged);
  for(const auto v : mesh.vertices())
    CHECK(std::sqrt((copy[v] - mesh.point(v)).squared_length()) < 1e-12);
  CHECK(RL::smooth_surface(mesh, 0.6, mesh.points(), params::crease_angle(60)).converged);
  CHECK(deviation(mesh.points()) < 0.005);
}

TEST_CASE("vertices_without_a_face_keep_their_values", "[editing]") {
  Triangles t = shapes::sphere(3);
  t.points.emplace_back(0.1, 0.2, 0.3);
  t.faces.push_back({0, 0, 1}); // without an area
  const RL::Spline_space_3 space = editing_space(t, 4);
  RL::Editing_options creases;
  creases.crease_angle = 30;
  for(const RL::Edited_signal& result :
      {RL::scale_details(space, 0.5, 0), RL::smooth_between_creases(space, 0.5, creases),
       RL::Surface_editor(space, 10).edit(0),
       RL::Surface_editor(space, 10).edit([](const RL::Surface_point&) { return 0.; })}) {
    CHECK(result.values.allFinite());
    CHECK((result.values.bottomRows(1) - Eigen::RowVector3d(0.1, 0.2, 0.3)).norm() < 1e-15);
  }
}

TEST_CASE("bad_editing_is_refused", "[editing]") {
  const Triangles t = shapes::sphere(2);
  const RL::Spline_space_3 space = editing_space(t, 3);
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  for(const double bad : {0., -1., nan, infinity}) {
    CHECK_THROWS_AS(RL::scale_details(space, bad, 0), RL::Parameter_error);
    CHECK_THROWS_AS(RL::Surface_editor(space, bad), RL::Parameter_error);
  }
  CHECK_THROWS_AS(RL::scale_details(space, 1, nan), RL::Parameter_error);
  const RL::Surface_editor editor(space, 1);
  CHECK_THROWS_AS(editor.edit(nan), RL::Parameter_error);
  CHECK_THROWS_AS(editor.edit([&](const RL::Surface_point&) { return nan; }), RL::Parameter_error);
  CHECK_THROWS_AS(editor.edit([](const RL::Surface_point& p) { return p.point - CGAL::ORIGIN; }),
                  RL::Parameter_error);
  RL::Editing_options options;
  for(const double bad : {0., -1., 200., nan}) {
    options.crease_angle = bad;
    CHECK_THROWS_AS(RL::smooth_between_creases(space, 1, options), RL::Parameter_error);
  }
  options = {};
  for(const double bad : {-1., nan, infinity}) {
    options.anisotropic = bad;
    CHECK_THROWS_AS(RL::internal::space_to_edit(space, 1, options), RL::Parameter_error);
  }
  Eigen::MatrixXd signal = Eigen::MatrixXd::Zero(3, 1);
  CHECK_THROWS_AS(RL::scale_details(space, 1, 0, {}, signal), RL::Parameter_error);
  signal = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(t.points.size()), 1);
  signal(3, 0) = nan;
  CHECK_THROWS_WITH(RL::scale_details(space, 1, 0, {}, signal), Catch::Contains("vertex 3"));
  CHECK_THROWS_WITH(RL::Surface_editor(space, 1, {}, signal), Catch::Contains("vertex 3"));
}

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// What smooth geometry gains where vertices lie on a smooth surface, and loses where they do not.
//
//   smooth_geometry
//   smooth_geometry --simplified MESH...
//   smooth_geometry --held-out MESH...
//   smooth_geometry --curvature
//
// First eigenvalues of shapes with flat facets, with smooth patches by estimated normals, and with
// patches by a projection to the shape: the largest relative error of some eigenvalues, the seconds
// of the space with its matrices, and those of all. Exact eigenvalues are those of spheres; those
// of the other shapes are computed on a fine mesh with patches, at depth 7.
//
// With --simplified: meshes (files, or names in the folder of shared meshes) whose facets are
// fitted to the surface by QSlim. The mean change of 39 eigenvalues, times area, against the
// original mesh with its facets: by facets, and by patches. Last, distances as with --held-out.
//
// With --held-out: vertices inside smooth parts are taken away, no two neighbors, their places are
// triangulated, and their distances to the surface of the others are measured: to the facets and to
// the patches, in units of the extent, of those that are farther than 1e-6 from the facets: root
// mean square, 95th percentile, and the share of those that are nearer to the patches. And of the
// faces of the whole mesh whose neighbors lie in their plane (normals differ by less than 1e-4):
// how far do patches leave the plane?
//
// With --curvature: mean curvature of an irregular torus, the median and the 95th percentile of the
// relative error at its vertices, in percent.

#include "support/curved_shapes.h"
#include "support/driver.h"
#include "support/held_out.h"
#include "support/measure.h"
#include "support/meshes.h"
#include "support/simplify.h"
#include "support/sphere.h"

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/input/read_surface.h>
#include <CGAL/Restricted_laplacian_3/laplace_spectrum.h>
#include <CGAL/Restricted_laplacian_3/patches/Smooth_geometry.h>
#include <CGAL/Restricted_laplacian_3/patches/curved_surface.h>
#include <CGAL/Restricted_laplacian_3/problems/Curvature_field.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;
using namespace benchmarks;

namespace {

using Projection = std::function<RL::Point_3(const RL::Point_3&)>;

RL::Triangulated_surface_3 surface_of(const Curved_shape& shape) {
  return RL::Triangulated_surface_3(shape.points, shape.faces);
}

RL::Triangulated_surface_3 projected(const RL::Triangulated_surface_3& surface,
                                     const Projection& projection) {
  RL::Smooth_geometry geometry;
  geometry.set_projection(projection);
  return RL::curved_surface(surface, geometry);
}

RL::Point_3 on_sphere(const RL::Point_3& p) {
  const RL::Vector_3 v = p - CGAL::ORIGIN;
  return CGAL::ORIGIN + v / std::sqrt(v.squared_length());
}

RL::Point_3 on_torus(const RL::Point_3& p) {
  const double r = std::hypot(p.x(), p.y());
  const RL::Point_3 center(p.x() / r, p.y() / r, 0);
  const RL::Vector_3 v = p - center;
  return center + v * (0.4 / std::sqrt(v.squared_length()));
}

/// the ellipsoid with these axes, by steps along the gradient of its function
RL::Point_3 on_ellipsoid(RL::Point_3 p, const std::array<double, 3>& axes) {
  for(int step = 0; step < 8; ++step) {
    const RL::Vector_3 gradient(p.x() / (axes[0] * axes[0]), p.y() / (axes[1] * axes[1]),
                                p.z() / (axes[2] * axes[2]));
    const double value = ((p - CGAL::ORIGIN) * gradient - 1) / 2;
    p = p - gradient * (value / gradient.squared_length());
  }
  return p;
}

/// the first eigenvalues after 0, times area
Eigen::VectorXd eigenvalues(const RL::Spline_space_3& space, int count, double stabilization) {
  const RL::Laplace_spectrum spectrum = RL::laplace_spectrum(
      space, count + 1,
      params::stabilization(stabilization).tolerance(1e-5).eigenvalues_only(true));
  return spectrum.eigenvalues.tail(count) * spectrum.area;
}

void print_row(const std::string& shape, std::size_t triangles, const char* geometry,
               const RL::Triangulated_surface_3& surface, int depth,
               const Eigen::VectorXd& reference) {
  const double start = seconds_now();
  const RL::Spline_space_3 space(surface, params::depth(depth));
  const RL::Operators operators = RL::assemble_operators(space, {}, 1e-5);
  const double assembled = seconds_now();
  const Eigen::VectorXd values = eigenvalues(space, static_cast<int>(reference.size()), 1e-5);
  // reference: times the area of the exact surface; the eigenvalues themselves are compared
  const Eigen::ArrayXd errors =
      (values.array() / surface.area() - reference.array()).abs() / reference.array();
  std::printf("%-10s %9zu %-10s %5d %8zu %9zu %10.2e %10.3f %8.2f\n", shape.c_str(), triangles,
              geometry, depth, space.dimension(), space.octree().pieces().number_of_faces(),
              errors.maxCoeff(), assembled - start, seconds_now() - start);
  std::fflush(stdout);
}

void run_shape(const std::string& name, const std::vector<RL::Triangulated_surface_3>& meshes,
               const Projection& projection, const Eigen::VectorXd& reference) {
  for(const RL::Triangulated_surface_3& flat : meshes)
    for(int depth : {5, 6}) {
      const std::size_t n = flat.number_of_faces();
      print_row(name, n, "flat", flat, depth, reference);
      print_row(name, n, "smooth", RL::curved_surface(flat), depth, reference);
      print_row(name, n, "projected", projected(flat, projection), depth, reference);
    }
}

/// eigenvalues on a fine mesh
Eigen::VectorXd reference_of(const Curved_shape& fine, const Projection& projection, int count) {
  constexpr int depth = 7;
  const RL::Triangulated_surface_3 surface = projected(surface_of(fine), projection);
  const RL::Spline_space_3 space(surface, params::depth(depth));
  return eigenvalues(space, count, 0) / surface.area();
}

void run_shapes() {
  std::printf("# %-8s %9s %-10s %5s %8s %9s %10s %10s %8s\n", "shape", "triangles", "geometry",
              "depth", "unknowns", "pieces", "largest", "matrices_s", "all_s");
  Eigen::VectorXd of_sphere(48);
  for(int i = 0; i < of_sphere.size(); ++i) {
    const int l = static_cast<int>(std::sqrt(i + 1));
    of_sphere[i] = l * (l + 1);
  }
  run_shape("sphere", {sphere(3), sphere(4), sphere(5)}, on_sphere, of_sphere);

  run_shape("torus", {surface_of(torus_shape(2880, true)), surface_of(torus_shape(11520, true))},
            on_torus, reference_of(torus_shape(400000, false), on_torus, 30));

  const std::array<double, 3> axes = {1, 0.7, 0.5};
  const auto on_shape = [&](const RL::Point_3& p) { return on_ellipsoid(p, axes); };
  run_shape("ellipsoid", {surface_of(ellipsoid_shape("ellipsoid", axes, 5000, true))}, on_shape,
            reference_of(ellipsoid_shape("ellipsoid", axes, 400000, false), on_shape, 30));
}

double root_mean_square(const std::vector<double>& values) {
  double sum = 0;
  for(double x : values)
    sum += x * x;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

double percentile_95(std::vector<double> values) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(values.size() * 95 / 100);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// of the faces whose neighbors lie in their plane: how far the patches leave it
double largest_bend(const Mesh& mesh, const RL::Triangulated_surface_3& smooth) {
  const auto is_plane = [&](Mesh::Face_index f) {
    for(const auto h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      const auto g = mesh.face(mesh.opposite(h));
      if(g != Mesh::null_face() && !smooth.is_degenerate(g) &&
         !(smooth.normal(g) * smooth.normal(f) > 1 - 0.5e-8))
        return false;
    }
    return true;
  };
  double largest = 0;
  for(const auto f : mesh.faces())
    if(!smooth.is_degenerate(f) && is_plane(f))
      for(const RL::Vector_3& v : smooth.patches().controls(f))
        largest = std::max(largest, std::sqrt(v.squared_length()));
  return largest / smooth.extent();
}

/// distances of vertices that were taken away, in units of the extent
struct Held_out_distances {
  std::size_t number;                        // of vertices
  std::vector<double> to_facets, to_patches; // of those that are not on the facets
};

Held_out_distances held_out_distances(const Mesh& mesh) {
  constexpr double crease_angle = 40;
  const auto [coarse, points] = held_out(mesh, crease_angle);
  const RL::Triangulated_surface_3 flat = RL::read_surface(coarse);
  const std::vector<double> to_facets = distances(points, flat, 1),
                            to_patches = distances(points, RL::curved_surface(flat), 16);
  Held_out_distances result = {points.size(), {}, {}};
  for(std::size_t i = 0; i < points.size(); ++i)
    if(to_facets[i] > 1e-6 * flat.extent()) {
      result.to_facets.push_back(to_facets[i] / flat.extent());
      result.to_patches.push_back(to_patches[i] / flat.extent());
    }
  return result;
}

void run_held_out(const std::string& name, const Mesh& mesh) {
  const auto [number, to_facets, to_patches] = held_out_distances(mesh);
  if(to_facets.empty())
    return;
  double nearer = 0;
  for(std::size_t i = 0; i < to_facets.size(); ++i)
    nearer += to_patches[i] < to_facets[i];
  std::printf("%-18s %9zu %8zu %8zu %10.2e %10.2e %10.2e %10.2e %10.1f %10.2e\n", name.c_str(),
              std::size_t(mesh.number_of_faces()), number, to_facets.size(),
              root_mean_square(to_facets), root_mean_square(to_patches), percentile_95(to_facets),
              percentile_95(to_patches), 100 * nearer / static_cast<double>(to_facets.size()),
              largest_bend(mesh, RL::curved_surface(RL::read_surface(mesh))));
  std::fflush(stdout);
}

void run_simplified(const std::string& name, const Mesh& mesh) {
  constexpr int depth = 6, count = 39;
  const auto values = [&](const RL::Triangulated_surface_3& surface) {
    return eigenvalues(RL::Spline_space_3(surface, params::depth(depth)), count, 1e-5);
  };
  const Eigen::VectorXd original = values(RL::read_surface(mesh));
  const auto change = [&](const RL::Triangulated_surface_3& surface) {
    return ((values(surface) - original).array() / original.array()).abs().mean();
  };
  for(int percent : {100, 30, 10}) {
    const Mesh small =
        percent == 100 ? mesh : simplified(mesh, mesh.number_of_vertices() * percent / 100);
    const RL::Triangulated_surface_3 flat = RL::read_surface(small);
    const RL::Triangulated_surface_3 smooth = RL::curved_surface(flat);
    const Held_out_distances d = held_out_distances(small);
    std::printf("%-18s %7d %9zu %10.2e %10.2e %7zu %10.2e %10.2e\n", name.c_str(), percent,
                flat.number_of_faces(), change(flat), change(smooth),
                smooth.patches().number_of_folded_faces(), root_mean_square(d.to_facets),
                root_mean_square(d.to_patches));
    std::fflush(stdout);
  }
}

void run_curvature() {
  const Curved_shape shape = torus_shape(20480, true);
  const RL::Triangulated_surface_3 flat = surface_of(shape);
  for(int depth : {5, 6})
    for(bool is_smooth : {false, true}) {
      const RL::Spline_space_3 space(is_smooth ? RL::curved_surface(flat) : flat,
                                     params::depth(depth));
      const std::vector<RL::Surface_curvature> found = RL::estimate_curvature(space).at_vertices();
      std::vector<double> errors;
      for(std::size_t v = 0; v < found.size(); ++v)
        errors.push_back(100 * std::abs(found[v].mean / shape.curvatures[v].mean - 1));
      std::printf("%-10s %9zu %-10s %5d %9.3f %9.3f\n", "torus", flat.number_of_faces(),
                  is_smooth ? "smooth" : "flat", depth, median(errors), percentile_95(errors));
      std::fflush(stdout);
    }
}

} // namespace

int main(int argc, char* argv[]) {
  return run_benchmark("smooth_geometry", [&] {
    print_header(argc, argv);
    if(argc > 1 && std::string(argv[1]) == "--simplified") {
      std::printf("# %-16s %7s %9s %10s %10s %7s %10s %10s\n", "mesh", "percent", "triangles",
                  "flat", "smooth", "folded", "to_flat", "to_smooth");
      for(int i = 2; i < argc; ++i)
        if(const auto mesh = find_mesh_file(argv[i]))
          run_simplified(argv[i], *mesh);
      return;
    }
    if(argc > 1 && std::string(argv[1]) == "--held-out") {
      std::printf("# %-16s %9s %8s %8s %10s %10s %10s %10s %10s %10s\n", "mesh", "triangles",
                  "held_out", "curved", "flat_rms", "smooth_rms", "flat_95", "smooth_95",
                  "nearer_%", "bend");
      for(int i = 2; i < argc; ++i)
        if(const auto mesh = find_mesh_file(argv[i]))
          run_held_out(argv[i], *mesh);
      return;
    }
    if(argc > 1 && std::string(argv[1]) == "--curvature") {
      std::printf("# %-8s %9s %-10s %5s %9s %9s\n", "shape", "triangles", "geometry", "depth",
                  "median_%", "95th_%");
      run_curvature();
      return;
    }
    run_shapes();
  });
}

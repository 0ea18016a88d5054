// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// What smooth geometry gains where vertices lie on a smooth surface, and loses where they do not.
//
//   smooth_geometry
//   smooth_geometry --simplified MESH...
//
// First eigenvalues of shapes with flat facets, with smooth patches by estimated normals, and with
// patches by a projection to the shape: the largest relative error of some eigenvalues, the seconds
// of the space with its matrices, and those of all. Exact eigenvalues are those of spheres; those
// of the other shapes are computed on a fine mesh with patches, at depth 7.
//
// With --simplified: meshes (files, or names in the folder of shared meshes) whose facets are
// fitted to the surface by QSlim. The mean change of 39 eigenvalues, times area, against the
// original mesh with its facets: by facets, and by patches.

#include "sphere.h"
#include "support/curved_shapes.h"
#include "support/measure.h"
#include "support/meshes.h"
#include "support/simplify.h"

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/laplace_spectrum.h>
#include <CGAL/Restricted_laplacian_3/surface/Smooth_geometry.h>
#include <CGAL/Restricted_laplacian_3/surface/curved_surface.h>
#include <CGAL/Restricted_laplacian_3/surface/read_surface.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <exception>
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
  geometry.projection = projection;
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
      params::normal_stabilization(stabilization).relative_tolerance(1e-5).eigenvalues_only(true));
  return spectrum.eigenvalues.tail(count) * spectrum.area;
}

void print_row(const std::string& shape, std::size_t triangles, const char* geometry,
               const RL::Triangulated_surface_3& surface, int depth,
               const Eigen::VectorXd& reference) {
  const double start = seconds_now();
  const RL::Spline_space_3 space(surface, params::octree_depth(depth));
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
  const RL::Spline_space_3 space(surface, params::octree_depth(depth));
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

void run_simplified(const std::string& name, const Mesh& mesh) {
  constexpr int depth = 6, count = 39;
  const auto values = [&](const RL::Triangulated_surface_3& surface) {
    return eigenvalues(RL::Spline_space_3(surface, params::octree_depth(depth)), count, 1e-5);
  };
  const Eigen::VectorXd original = values(RL::read_surface(mesh));
  const auto change = [&](const RL::Triangulated_surface_3& surface) {
    return ((values(surface) - original).array() / original.array()).abs().mean();
  };
  for(int percent : {100, 30, 10}) {
    const RL::Triangulated_surface_3 flat = RL::read_surface(
        percent == 100 ? mesh : simplified(mesh, mesh.number_of_vertices() * percent / 100));
    const RL::Triangulated_surface_3 smooth = RL::curved_surface(flat);
    std::printf("%-18s %7d %9zu %10.2e %10.2e %7zu\n", name.c_str(), percent,
                flat.number_of_faces(), change(flat), change(smooth),
                smooth.patches().number_of_folded_faces());
    std::fflush(stdout);
  }
}

} // namespace

int main(int argc, char* argv[]) {
  try {
    print_header(argc, argv);
    if(argc > 1 && std::string(argv[1]) == "--simplified") {
      std::printf("# %-16s %7s %9s %10s %10s %7s\n", "mesh", "percent", "triangles", "flat",
                  "smooth", "folded");
      for(int i = 2; i < argc; ++i)
        if(const auto mesh = find_mesh_file(argv[i]))
          run_simplified(argv[i], *mesh);
      return 0;
    }
    run_shapes();
    return 0;
  } catch(const std::exception& e) {
    std::fprintf(stderr, "smooth_geometry: %s\n", e.what());
    return 1;
  }
}

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// How accurate are curvatures, and how much do they depend on the triangulation? Studies,
// the peers in the same run: mean curvature by the cotangent Laplacian, Gaussian curvature by angle
// defects, over mixed areas.
//
// accuracy: shapes whose curvature is known (support/curved_shapes.h), regular and irregular
// triangulations. Errors at all vertices (of the peers: at those inside), in percent of
// max(|exact|, 0.1 max |exact|), since curvatures may vanish: median, 95th percentile and largest.
// The last two columns: the median and the 95th percentile of the error of the mean curvature in
// percent of sqrt((k1^2 + k2^2) / 2), which does not vanish on these shapes.
//
// change: what curvatures of a mesh change by if a third of its edges is flipped (as far as no
// triangle is turned over by more than 60 degrees), and if QSlim leaves 30 % of its vertices: root
// of the mean square over the area, in units of 1 / (longest side of the bounding box), its square
// for Gaussian curvature. The curvatures of the simplified mesh are compared at its vertices with
// those of the original at the nearest point.
//
// normals: the fit of interpolated and renormalized vertex normals as in the paper's figure 5, and
// of the normals of the faces; root mean square error, iterations to 1e-8.
//
// edges: mean curvature from the Laplacian of the coordinates as in the paper's figure 6, on a mesh
// whose triangles are larger than the cells. It should vanish but near the edges: at points evenly
// spread over the faces, by their distance to the nearest edge of the face in units of the cell
// width h, the share of the area, the share of the integral of |H|, and the root mean square of
// h H. Last, the integral of H, and half the sum of edge length times dihedral angle, which it
// approximates.
//
// usage: curvature_study [OPTION]...

#include "support/aabb_tree.h"
#include "support/curved_shapes.h"
#include "support/driver.h"
#include "support/measure.h"
#include "support/mesh_curvature.h"
#include "support/meshes.h"
#include "support/package.h"
#include "support/simplify.h"

#include <CGAL/Restricted_laplacian_3/estimate_curvature.h>
#include <CGAL/Restricted_laplacian_3/fit_function.h>
#include <CGAL/Restricted_laplacian_3/input/read_surface.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Real_timer.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;
using namespace benchmarks;

namespace {

struct Options {
  std::string study = "accuracy";
  std::vector<std::string> shapes = {"sphere", "torus", "ellipsoid", "saddle"},
                           meshes = {"bimba_46k", "bunny_closed_70k"};
  std::vector<int> triangles = {20000, 80000, 320000}, depths = {4, 5, 6, 7};
  int threads = 1;
};

RL::Spline_space_3 space_of(const RL::Triangulated_surface_3& surface, int depth, int threads) {
  return RL::Spline_space_3(surface, space_options(depth, true, threads));
}

RL::Curvature_field curvature(const RL::Spline_space_3& space, RL::Curvature_method method) {
  return RL::estimate_curvature(space, params::method(method));
}

const std::array<std::pair<const char*, RL::Curvature_method>, 3> methods = {
    {{"normals", RL::Curvature_method::normals},
     {"face-normals", RL::Curvature_method::face_normals},
     {"coordinates", RL::Curvature_method::coordinates}}};

// median, 95th percentile and largest; NaN if there is none
std::array<double, 3> quantiles(std::vector<double> values) {
  values.erase(std::remove_if(values.begin(), values.end(), [](double x) { return std::isnan(x); }),
               values.end());
  if(values.empty())
    return {std::nan(""), std::nan(""), std::nan("")};
  std::sort(values.begin(), values.end());
  const auto at = [&](double part) {
    return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
  };
  return {at(0.5), at(0.95), at(1)};
}

void print_errors(const Curved_shape& shape, const std::vector<double>& mean,
                  const std::vector<double>& gaussian) {
  double largest_mean = 0, largest_gaussian = 0;
  for(const auto& [h, k] : shape.curvatures) {
    largest_mean = std::max(largest_mean, std::abs(h));
    largest_gaussian = std::max(largest_gaussian, std::abs(k));
  }
  std::vector<double> of_mean, of_gaussian, of_tensor;
  for(std::size_t v = 0; v < shape.curvatures.size(); ++v) {
    const auto& [h, k] = shape.curvatures[v];
    const double error = 100 * std::abs(mean[v] - h);
    of_mean.push_back(error / std::max(std::abs(h), 0.1 * largest_mean));
    of_gaussian.push_back(100 * std::abs(gaussian[v] - k) /
                          std::max(std::abs(k), 0.1 * largest_gaussian));
    of_tensor.push_back(error / std::sqrt(2 * h * h - k));
  }
  for(const auto& q : {quantiles(of_mean), quantiles(of_gaussian)})
    std::printf(" %8.3f %8.2f %8.1f", q[0], q[1], q[2]);
  const auto q = quantiles(of_tensor);
  std::printf(" %8.3f %8.2f\n", q[0], q[1]);
  std::fflush(stdout);
}

Curved_shape made_shape(const std::string& name, int triangles, bool is_irregular) {
  if(name == "torus")
    return torus_shape(triangles, is_irregular);
  if(name == "saddle")
    return saddle_shape(triangles, is_irregular);
  const std::array<double, 3> axes =
      name == "sphere" ? std::array<double, 3>{1, 1, 1} : std::array<double, 3>{1, 0.7, 0.5};
  return ellipsoid_shape(name, axes, triangles, is_irregular);
}

void study_accuracy(const Options& o) {
  std::printf("# %-8s %-9s %8s %-12s %5s %8s %7s %4s %8s %8s %8s %8s %8s %8s %8s %8s\n", "shape",
              "triangles", "number", "method", "depth", "unknowns", "seconds", "iter", "H_median",
              "H_95", "H_max", "K_median", "K_95", "K_max", "T_median", "T_95");
  for(const std::string& name : o.shapes)
    for(const bool is_irregular : {false, true})
      for(const int triangles : o.triangles) {
        const Curved_shape shape = made_shape(name, triangles, is_irregular);
        const RL::Triangulated_surface_3 surface(shape.points, shape.faces);
        const auto print_start = [&](const char* method) {
          std::printf("%-10s %-9s %8zu %-12s ", name.c_str(),
                      is_irregular ? "irregular" : "regular", shape.faces.size(), method);
        };
        CGAL::Real_timer timer;
        timer.start();
        const Mesh_curvature peer(surface);
        print_start("cotangent");
        std::printf("%5s %8zu %7.2f %4s", "-", shape.points.size(), timer.time(), "-");
        print_errors(shape, peer.mean, peer.gaussian);
        for(const auto& [label, method] : methods)
          for(const int depth : o.depths) {
            // the other methods are there to be compared at one size
            if(depth == 7 && (triangles < 320000 || method != RL::Curvature_method::normals))
              continue;
            if(triangles != 80000 && method != RL::Curvature_method::normals)
              continue;
            timer.reset();
            const RL::Spline_space_3 space = space_of(surface, depth, o.threads);
            const RL::Curvature_field field = curvature(space, method);
            std::vector<double> mean, gaussian;
            for(const RL::Surface_curvature& c : field.at_vertices()) {
              mean.push_back(c.mean);
              gaussian.push_back(c.gaussian);
            }
            print_start(label);
            std::printf("%5d %8zu %7.2f %4d", depth, space.dimension(), timer.time(),
                        field.report().iterations);
            print_errors(shape, mean, gaussian);
          }
      }
}

RL::Vector_3 triangle_normal(const RL::Point_3& a, const RL::Point_3& b, const RL::Point_3& c) {
  return RL::internal::unit_or_zero(CGAL::cross_product(b - a, c - a));
}

// flips a third of the edges, chosen at random
Mesh flipped(Mesh mesh) {
  std::mt19937 generator(1);
  const std::vector<Mesh::Edge_index> all(edges(mesh).begin(), edges(mesh).end());
  std::size_t number = 0;
  for(const Mesh::Edge_index e : all) {
    if(generator() % 3 != 0)
      continue;
    const auto h = halfedge(e, mesh), g = opposite(h, mesh);
    if(is_border(h, mesh) || is_border(g, mesh))
      continue;
    const auto a = source(h, mesh), b = target(h, mesh), c = target(next(h, mesh), mesh),
               d = target(next(g, mesh), mesh);
    if(CGAL::halfedge(c, d, mesh).second)
      continue;
    const RL::Point_3 &pa = mesh.point(a), &pb = mesh.point(b), &pc = mesh.point(c),
                      &pd = mesh.point(d);
    bool is_turned = false;
    for(const RL::Vector_3& before : {triangle_normal(pa, pb, pc), triangle_normal(pb, pa, pd)})
      for(const RL::Vector_3& after : {triangle_normal(pc, pa, pd), triangle_normal(pd, pb, pc)})
        is_turned = is_turned || before * after < 0.5;
    if(is_turned)
      continue;
    CGAL::Euler::flip_edge(h, mesh);
    ++number;
  }
  std::printf("# %zu of %zu edges are flipped\n", number, all.size());
  return mesh;
}

// the nearest locations of an original mesh to all vertices of another one
std::vector<RL::Surface_location> nearest_locations(const Mesh& original, const Mesh& mesh) {
  namespace PMP = CGAL::Polygon_mesh_processing;
  using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
  using Tree = Aabb_tree<CGAL::Simple_cartesian<double>, Primitive>;
  Tree tree;
  PMP::build_AABB_tree(original, tree);
  const RL::Surface_location_converter<Mesh> convert(original);
  std::vector<RL::Surface_location> result;
  for(const Mesh::Vertex_index v : vertices(mesh))
    result.push_back(convert(PMP::locate_with_AABB_tree(mesh.point(v), tree, original)));
  return result;
}

struct Curvatures {
  std::vector<double> mean, gaussian;
};

Curvatures separated(const std::vector<RL::Surface_curvature>& all) {
  Curvatures result;
  for(const RL::Surface_curvature& c : all) {
    result.mean.push_back(c.mean);
    result.gaussian.push_back(c.gaussian);
  }
  return result;
}

std::vector<double> interpolated(const RL::Triangulated_surface_3& surface,
                                 const std::vector<double>& values,
                                 const std::vector<RL::Surface_location>& locations) {
  std::vector<double> result;
  for(const RL::Surface_location& location : locations) {
    double sum = 0;
    for(int i = 0; i < 3; ++i)
      sum += location.barycentric[i] * values[surface.triangle(location.face)[i]];
    result.push_back(sum);
  }
  return result;
}

// root of the mean square of the difference at the vertices of a surface
double rms_difference(const RL::Triangulated_surface_3& surface, const std::vector<double>& a,
                      const std::vector<double>& b) {
  double sum = 0, area = 0;
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
    for(const std::uint32_t v : surface.triangle(f))
      if(!std::isnan(a[v] - b[v])) {
        sum += surface.area(f) * (a[v] - b[v]) * (a[v] - b[v]);
        area += surface.area(f);
      }
  return std::sqrt(sum / area);
}

void print_change(const std::string& name, const char* change, const std::string& method, int depth,
                  const RL::Triangulated_surface_3& surface, double extent,
                  const Curvatures& expected, const Curvatures& changed) {
  std::printf("%-18s %-6s %-12s %5d %12.3f %12.2f\n", name.c_str(), change, method.c_str(), depth,
              extent * rms_difference(surface, expected.mean, changed.mean),
              extent * extent * rms_difference(surface, expected.gaussian, changed.gaussian));
  std::fflush(stdout);
}

void study_change(const Options& o) {
  std::printf("# %-16s %-6s %-12s %5s %12s %12s\n", "mesh", "change", "method", "depth", "rms_of_H",
              "rms_of_K");
  for(const std::string& file : o.meshes) {
    const auto mesh = find_mesh_file(file);
    if(!mesh)
      continue;
    const std::string name = std::filesystem::path(file).stem();
    const RL::Triangulated_surface_3 original = RL::read_surface(*mesh);
    const Mesh flips = flipped(*mesh);
    const Mesh simple = simplified(*mesh, mesh->number_of_vertices() * 3 / 10);
    const std::vector<RL::Surface_location> nearest = nearest_locations(*mesh, simple);
    const RL::Triangulated_surface_3 of_flips = RL::read_surface(flips),
                                     of_simple = RL::read_surface(simple);
    const auto peer = [](const RL::Triangulated_surface_3& surface) {
      const Mesh_curvature c(surface);
      return Curvatures{c.mean, c.gaussian};
    };
    const Curvatures peer_of_original = peer(original);
    print_change(name, "flips", "cotangent", 0, original, original.extent(), peer_of_original,
                 peer(of_flips));
    print_change(name, "QSlim", "cotangent", 0, of_simple, original.extent(),
                 {interpolated(original, peer_of_original.mean, nearest),
                  interpolated(original, peer_of_original.gaussian, nearest)},
                 peer(of_simple));
    for(const auto& [label, method] : methods)
      for(const int depth : o.depths) {
        if(depth > 6)
          continue;
        const auto estimated = [&, m = method](const RL::Triangulated_surface_3& surface) {
          return separated(curvature(space_of(surface, depth, o.threads), m).at_vertices());
        };
        const RL::Spline_space_3 space = space_of(original, depth, o.threads);
        const RL::Curvature_field field = curvature(space, method);
        print_change(name, "flips", label, depth, original, original.extent(),
                     separated(field.at_vertices()), estimated(of_flips));
        print_change(name, "QSlim", label, depth, of_simple, original.extent(),
                     separated(field.at_locations(nearest)), estimated(of_simple));
      }
  }
}

void study_normals(const Options& o) {
  std::printf("# %-16s %-12s %5s %8s %8s %8s %8s %5s %9s\n", "mesh", "normals", "depth", "unknowns",
              "assem_s", "setup_s", "solve_s", "iter", "rms");
  for(const std::string& file : o.meshes) {
    const auto surface = find_mesh(file);
    if(!surface)
      continue;
    for(const int depth : o.depths)
      for(const bool of_vertices : {true, false}) {
        const RL::Spline_space_3 space = space_of(*surface, depth, o.threads);
        const auto print = [&](const RL::Function_fit& fit) {
          std::printf("%-18s %-12s %5d %8zu %8.2f %8.2f %8.2f %5d %9.5f%s\n",
                      std::filesystem::path(file).stem().c_str(),
                      of_vertices ? "of vertices" : "of faces", depth, space.dimension(),
                      fit.assembly_seconds, fit.setup_seconds, fit.solve_seconds, fit.iterations,
                      fit.root_mean_square_error(), fit.converged ? "" : " not converged");
          std::fflush(stdout);
        };
        if(of_vertices)
          print(RL::fit_function(space,
                                 RL::internal::Interpolated_normals(RL::vertex_normals(*surface))));
        else
          print(RL::fit_function(space, [](const RL::Surface_point& p) { return p.normal; }));
      }
  }
}

// a location, its part of the area, and its distance to the nearest edge of the face
struct Spread_point {
  RL::Surface_location location;
  double area, distance;
};

// The centers of the triangles into which a face is divided such that their sides are at most
// `length`.
std::vector<Spread_point> spread_points(const RL::Triangulated_surface_3& surface, double length) {
  std::vector<Spread_point> result;
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f) {
    std::array<double, 3> heights;
    double longest = 0;
    for(int i = 0; i < 3; ++i) {
      const double side = std::sqrt(
          CGAL::squared_distance(surface.point(f, (i + 1) % 3), surface.point(f, (i + 2) % 3)));
      heights[i] = side > 0 ? 2 * surface.area(f) / side : 0;
      longest = std::max(longest, side);
    }
    const int n = std::max(1, static_cast<int>(std::ceil(longest / length)));
    const auto add = [&](double a, double b) {
      const std::array<double, 3> barycentric = {a / n, b / n, 1 - (a + b) / n};
      double distance = longest;
      for(int i = 0; i < 3; ++i)
        distance = std::min(distance, barycentric[i] * heights[i]);
      result.push_back({{f, barycentric}, surface.area(f) / (n * n), distance});
    };
    for(int i = 0; i < n; ++i)
      for(int j = 0; i + j < n; ++j) {
        add(i + 1. / 3, j + 1. / 3);
        if(i + j + 1 < n)
          add(i + 2. / 3, j + 2. / 3);
      }
  }
  return result;
}

// half the sum of length times dihedral angle, positive where the surface is convex
double edge_mean_curvature(const Mesh& mesh) {
  double sum = 0;
  for(const Mesh::Edge_index e : mesh.edges()) {
    if(mesh.is_border(e))
      continue;
    const auto h = mesh.halfedge(e), g = mesh.opposite(h);
    const auto point = [&](Mesh::Halfedge_index i) { return mesh.point(mesh.target(i)); };
    const auto p = point(g), q = point(h), left = point(mesh.next(h)), right = point(mesh.next(g));
    const double angle = CGAL::approximate_dihedral_angle(p, q, left, right); // 180: flat
    sum += std::sqrt(CGAL::squared_distance(p, q)) * (angle < 0 ? -180 - angle : 180 - angle);
  }
  return sum * CGAL_PI / 360;
}

void study_edges(const Options& o) {
  constexpr double bin_width = 0.5; // in cells
  constexpr int bins = 8;           // the last one has no end
  std::printf("# %-16s %5s %8s %-11s %9s %9s %10s\n", "mesh", "depth", "unknowns", "distance/h",
              "area_%", "abs_H_%", "rms_of_hH");
  for(const std::string& file : o.meshes) {
    const auto mesh = find_mesh_file(file);
    if(!mesh)
      continue;
    const std::string name = std::filesystem::path(file).stem();
    const RL::Triangulated_surface_3 surface = RL::read_surface(*mesh);
    for(const int depth : o.depths) {
      const RL::Spline_space_3 space = space_of(surface, depth, o.threads);
      const double h = space.octree().cell_width(depth);
      const std::vector<Spread_point> points = spread_points(surface, h / 4);
      std::vector<RL::Surface_location> locations;
      for(const Spread_point& p : points)
        locations.push_back(p.location);
      const std::vector<double> mean_curvature =
          separated(curvature(space, RL::Curvature_method::coordinates).at_locations(locations))
              .mean;
      std::array<double, bins> areas = {}, integrals = {}, squares = {};
      double all = 0, integral = 0;
      for(std::size_t i = 0; i < points.size(); ++i) {
        const double curvature = mean_curvature[i];
        const int bin = std::min(bins - 1, static_cast<int>(points[i].distance / (bin_width * h)));
        areas[bin] += points[i].area;
        integrals[bin] += points[i].area * std::abs(curvature);
        squares[bin] += points[i].area * curvature * curvature;
        all += points[i].area * std::abs(curvature);
        integral += points[i].area * curvature;
      }
      for(int bin = 0; bin < bins && areas[bin] > 0; ++bin) {
        char distances[32];
        std::snprintf(distances, sizeof distances, "%.1f-%.1f", bin * bin_width,
                      bin + 1 < bins ? (bin + 1) * bin_width : HUGE_VAL);
        std::printf("%-18s %5d %8zu %-11s %9.2f %9.2f %10.4f\n", name.c_str(), depth,
                    space.dimension(), distances, 100 * areas[bin] / surface.area(),
                    100 * integrals[bin] / all, h * std::sqrt(squares[bin] / areas[bin]));
      }
      std::printf("# %s, depth %d: integral of H %.5g, of the edges %.5g\n", name.c_str(), depth,
                  integral, edge_mean_curvature(*mesh));
      std::fflush(stdout);
    }
  }
}

bool read_options(int argc, char* argv[], Options& o) {
  Command_line line("usage: curvature_study [OPTION]...");
  bool is_quick = false;
  line.add("study", o.study, "accuracy, change, normals or edges");
  line.add("shape", o.shapes, "sphere torus ellipsoid saddle");
  line.add("triangles", o.triangles, "20000 80000 320000");
  line.add("mesh", o.meshes, "files, or names in the folder of shared meshes");
  line.add("depth", o.depths, "4 5 6 7");
  line.add("threads", o.threads);
  line.add("quick", is_quick, "20000 triangles, depths 4 and 5");
  if(!line.read(argc, argv))
    return false;
  if(is_quick) {
    o.triangles = {20000};
    o.depths = {4, 5};
  }
  return true;
}

} // namespace

int main(int argc, char* argv[]) {
  return run_benchmark("curvature_study", [&] {
    Options o;
    if(!read_options(argc, argv, o))
      return 0;
    [[maybe_unused]] const auto limited = limit_threads(o.threads);
    print_header(argc, argv);
    if(o.study == "accuracy")
      study_accuracy(o);
    else if(o.study == "change")
      study_change(o);
    else if(o.study == "normals")
      study_normals(o);
    else if(o.study == "edges")
      study_edges(o);
    else {
      std::fprintf(stderr, "curvature_study: there is no study %s\n", o.study.c_str());
      return 1;
    }
    return 0;
  });
}

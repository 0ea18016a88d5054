// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Distances from a vertex along surfaces, one thread:
// - fast: Geodesic_solver, its default
// - exact: the same by windows alone, which is the reference of the errors
// - spline_6, spline_7: splines by Geodesic_fitter at these depths, evaluated at the vertices; the
//   setup is that of the rays, the space and the fitter, a query that of the distances and the fit
// - points (not by default): `fast` of the vertices with their normals, without the faces; vertices
//   without a normal are left out
// - heat, heat_idt: CGAL's heat method, direct and with its intrinsic Delaunay triangulation
// - cgal_exact: CGAL's Surface_mesh_shortest_path
//
// A line for each mesh, source and method: vertices; the mean and the worst relative error of the
// vertices farther than 2 % of the largest distance, in percent; how many of them are too short and
// too long by more than 1 %, or not reached, and then no part of the mean; seconds of the setup and
// of a query.
//
// With --paths instead: shortest paths from many vertices to one by Geodesic_function, with the
// distances of `fast` and of `exact`; by how much they are longer than the exact distance, in the
// mean and at worst, in percent; how many by more than 0.1 %; segments, and microseconds, of a
// path.
//
// usage: distance_study [OPTION]...

#include "support/driver.h"
#include "support/measure.h"
#include "support/meshes.h"
#include "support/package.h"

#include <CGAL/Restricted_laplacian_3/geodesics/Geodesic_function.h>
#include <CGAL/Restricted_laplacian_3/geodesics/Geodesic_solver.h>
#include <CGAL/Restricted_laplacian_3/problems/Geodesic_fitter.h>
#include <CGAL/Restricted_laplacian_3/surface/vertex_normals.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <limits>
#include <string>
#include <vector>

namespace {

using namespace benchmarks;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Cgal_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Cgal_mesh::Vertex_index;

struct Result {
  std::vector<double> distances;
  double setup_seconds = 0, seconds = 0;
};

Result by_rays(const RL::Triangulated_surface_3& surface, std::size_t source,
               RL::Geodesic_method method) {
  Result result;
  double begin = seconds_now();
  const RL::Geodesic_solver solver(surface);
  result.setup_seconds = seconds_now() - begin;
  begin = seconds_now();
  result.distances = solver.distances(RL::Geodesic_sources::vertex(source), method).distances;
  result.seconds = seconds_now() - begin;
  return result;
}

Result by_spline(const RL::Triangulated_surface_3& surface, std::size_t source, int depth) {
  Result result;
  double begin = seconds_now();
  const RL::Geodesic_solver rays(surface);
  const RL::Spline_space_3 space(surface, RL::parameters::depth(depth));
  const RL::Geodesic_fitter fitter(space);
  result.setup_seconds = seconds_now() - begin;
  begin = seconds_now();
  const RL::Geodesic_spline u =
      fitter.fit(RL::Geodesic_function(rays, rays.distances(RL::Geodesic_sources::vertex(source))));
  result.seconds = seconds_now() - begin;
  for(std::size_t v = 0; v < surface.number_of_vertices(); ++v)
    try {
      result.distances.push_back(u.value(rays.location(v)));
    } catch(const RL::Input_error&) { // not on the surface: no face, or degenerate ones only
      result.distances.push_back(u.function().distances().distances[v]);
    }
  return result;
}

Result by_points(const RL::Triangulated_surface_3& surface, std::size_t source) {
  std::vector<RL::Vector_3> normals = RL::vertex_normals(surface), kept_normals;
  std::vector<RL::Point_3> kept;
  std::vector<std::size_t> number(surface.number_of_vertices(), surface.number_of_vertices());
  for(std::size_t v = 0; v < number.size(); ++v)
    if(normals[v] != CGAL::NULL_VECTOR) {
      number[v] = kept.size();
      kept.push_back(surface.point(v));
      kept_normals.push_back(normals[v]);
    }
  std::vector<double> areas(kept.size(), surface.area() / static_cast<double>(kept.size()));
  Result result;
  double begin = seconds_now();
  const RL::Geodesic_solver solver(
      RL::Triangulated_surface_3(std::move(kept), std::move(kept_normals), std::move(areas)));
  result.setup_seconds = seconds_now() - begin;
  begin = seconds_now();
  const std::vector<double> found =
      solver.distances(RL::Geodesic_sources::vertex(number[source])).distances;
  result.seconds = seconds_now() - begin;
  for(const std::size_t i : number)
    result.distances.push_back(i < found.size() ? found[i] : std::nan(""));
  return result;
}

// as a mesh of CGAL, with the same vertices; empty if the surface is no oriented manifold
Cgal_mesh cgal_mesh(const RL::Triangulated_surface_3& surface) {
  Cgal_mesh mesh;
  for(std::size_t v = 0; v < surface.number_of_vertices(); ++v)
    mesh.add_vertex(
        Kernel::Point_3(surface.point(v).x(), surface.point(v).y(), surface.point(v).z()));
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f) {
    const auto& t = surface.triangle(f);
    if(mesh.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2])) == Cgal_mesh::null_face())
      return Cgal_mesh();
  }
  return mesh;
}

template <class Mode> Result by_heat(Cgal_mesh& mesh, std::size_t source) {
  Result result;
  double begin = seconds_now();
  CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<Cgal_mesh, Mode> heat(mesh); // factorizes
  result.setup_seconds = seconds_now() - begin;
  auto distances = mesh.add_property_map<Vertex, double>("v:distance").first;
  begin = seconds_now();
  heat.add_source(Vertex(static_cast<Cgal_mesh::size_type>(source)));
  heat.estimate_geodesic_distances(distances);
  result.seconds = seconds_now() - begin;
  for(const Vertex v : vertices(mesh))
    result.distances.push_back(distances[v]);
  mesh.remove_property_map(distances);
  return result;
}

Result by_cgal_exact(const Cgal_mesh& mesh, std::size_t source) {
  Result result;
  double begin = seconds_now();
  CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Cgal_mesh>>
      paths(mesh);
  result.setup_seconds = seconds_now() - begin;
  begin = seconds_now();
  paths.add_source_point(Vertex(static_cast<Cgal_mesh::size_type>(source)));
  for(const Vertex v : vertices(mesh))
    result.distances.push_back(paths.shortest_distance_to_source_points(v).first);
  result.seconds = seconds_now() - begin;
  return result;
}

void print(const std::string& mesh, std::size_t source, const char* method, const Result& result,
           const std::vector<double>& exact) {
  double largest = 0, sum = 0, worst = 0;
  for(const double d : exact)
    if(std::isfinite(d))
      largest = (std::max)(largest, d);
  std::size_t number = 0, too_short = 0, too_long = 0;
  for(std::size_t v = 0; v < exact.size(); ++v)
    if(std::isfinite(exact[v]) && exact[v] > 0.02 * largest && !std::isnan(result.distances[v])) {
      const double error = result.distances[v] / exact[v] - 1;
      too_long += error > 0.01;
      if(std::isinf(error))
        continue;
      sum += std::abs(error);
      worst = (std::max)(worst, std::abs(error));
      too_short += error < -0.01;
      ++number;
    }
  std::printf("%-20s %7zu %7zu %-10s %9.5f %9.4f %7zu %7zu %8.4f %8.4f\n", mesh.c_str(),
              exact.size(), source, method, 100 * sum / static_cast<double>(number), 100 * worst,
              too_short, too_long, result.setup_seconds, result.seconds);
  std::fflush(stdout);
}

void study_paths(const std::string& name, const RL::Triangulated_surface_3& surface,
                 std::size_t source) {
  const RL::Geodesic_solver rays(surface);
  const auto sources = RL::Geodesic_sources::vertex(source);
  const auto exact = rays.distances(sources, RL::Geodesic_method::exact);
  for(const bool is_exact : {false, true}) {
    const RL::Geodesic_function d(rays, is_exact ? exact : rays.distances(sources));
    const std::size_t n = surface.number_of_vertices(), step = (std::max)(n / 1000, std::size_t(1));
    double sum = 0, worst = 0, seconds = 0;
    std::size_t number = 0, segments = 0, too_long = 0;
    for(std::size_t v = 0; v < n; v += step) {
      if(!std::isfinite(exact.distances[v]) || !(exact.distances[v] > 0))
        continue;
      const RL::Surface_location from = rays.location(v);
      const double begin = seconds_now();
      const RL::Geodesic_path path = d.shortest_path(from);
      seconds += seconds_now() - begin;
      const double error = (std::max)(0., path.length / exact.distances[v] - 1);
      sum += error;
      worst = (std::max)(worst, error);
      too_long += error > 1e-3;
      segments += path.segments.size();
      ++number;
    }
    const double all = static_cast<double>(number);
    std::printf("%-20s %7zu %7zu %-10s %6zu %9.5f %9.4f %7zu %8.1f %8.1f\n", name.c_str(), n,
                source, is_exact ? "exact" : "fast", number, 100 * sum / all, 100 * worst, too_long,
                static_cast<double>(segments) / all, 1e6 * seconds / all);
    std::fflush(stdout);
  }
}

void study(const std::string& name, const RL::Triangulated_surface_3& surface, std::size_t source,
           const std::vector<std::string>& methods) {
  const Result exact = by_rays(surface, source, RL::Geodesic_method::exact);
  Cgal_mesh mesh = cgal_mesh(surface);
  for(const std::string& method : methods) {
    if(method == "exact")
      print(name, source, "exact", exact, exact.distances);
    else if(method == "fast")
      print(name, source, "fast", by_rays(surface, source, RL::Geodesic_method::fast),
            exact.distances);
    else if(method == "spline_6" || method == "spline_7")
      print(name, source, method.c_str(), by_spline(surface, source, method.back() - '0'),
            exact.distances);
    else if(method == "points")
      print(name, source, "points", by_points(surface, source), exact.distances);
    else if(is_empty(mesh))
      std::printf("# %s: CGAL's methods need a manifold\n", name.c_str());
    else if(method == "heat")
      print(name, source, "heat", by_heat<CGAL::Heat_method_3::Direct>(mesh, source),
            exact.distances);
    else if(method == "heat_idt")
      print(name, source, "heat_idt",
            by_heat<CGAL::Heat_method_3::Intrinsic_Delaunay>(mesh, source), exact.distances);
    else if(method == "cgal_exact")
      print(name, source, "cgal_exact", by_cgal_exact(mesh, source), exact.distances);
  }
}

} // namespace

int main(int argc, char* argv[]) {
  return run_benchmark("distance_study", [&] {
    std::vector<std::string> meshes,
        methods = {"fast", "exact", "spline_6", "spline_7", "heat", "heat_idt", "cgal_exact"};
    bool paths = false;
    std::vector<double> sources = {0};
    Command_line line("usage: distance_study [OPTION]...");
    line.add("mesh", meshes, "files or names of meshes");
    line.add("method", methods, "all but points by default");
    line.add("paths", paths, "shortest paths in place of distances");
    line.add("source", sources, "numbers of vertices, over that of all vertices; by default 0");
    if(!line.read(argc, argv))
      return 0;
    line.require("mesh");
    print_header(argc, argv);
    if(paths)
      std::printf("# %-18s %7s %7s %-10s %6s %9s %9s %7s %8s %8s\n", "mesh", "n", "source",
                  "method", "paths", "mean", "worst", "long", "segments", "us");
    else
      std::printf("# %-18s %7s %7s %-10s %9s %9s %7s %7s %8s %8s\n", "mesh", "n", "source",
                  "method", "mean", "worst", "short", "long", "setup_s", "query_s");
    const auto limit = limit_threads(1);
    int failures = 0;
    for(const std::string& name : meshes)
      try {
        if(const auto surface = find_mesh(name))
          for(const double part : sources) {
            const std::string file = name.substr(name.rfind('/') + 1);
            const auto source =
                static_cast<std::size_t>(part * static_cast<double>(surface->number_of_vertices()));
            if(paths)
              study_paths(file, *surface, source);
            else
              study(file, *surface, source, methods);
          }
      } catch(const std::exception& e) {
        std::printf("# %s: %s\n", name.c_str(), e.what());
        ++failures;
      }
    return failures > 0 ? 1 : 0;
  });
}

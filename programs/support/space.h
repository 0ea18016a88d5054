// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_PROGRAMS_SPACE_H
#define RESTRICTED_LAPLACIAN_3_PROGRAMS_SPACE_H

// What programs do with a spline space: make it, describe it, and integrate over its surface.

#include "command_line.h"
#include "program.h"
#include "table.h"
#include "vertex_data.h"

#include <CGAL/Restricted_laplacian_3/integration/Monte_carlo.h>
#include <CGAL/Restricted_laplacian_3/integration/Surface_material.h>
#include <CGAL/Restricted_laplacian_3/integration/cubature.h>
#include <CGAL/Restricted_laplacian_3/patches/Smooth_geometry.h>
#include <CGAL/Restricted_laplacian_3/patches/curved_surface.h>
#include <CGAL/Restricted_laplacian_3/patches/smooth_vertex_data.h>
#include <CGAL/Restricted_laplacian_3/problems/Curvature_field.h>
#include <CGAL/Restricted_laplacian_3/problems/shared/space_of.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_patches.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace programs {

// The surface that the options take a mesh for.
inline RL::Triangulated_surface_3 with_geometry(RL::Triangulated_surface_3 surface,
                                                const Space_options& o) {
  if(o.geometry == "flat")
    return surface;
  require(!surface.is_point_set(), "--geometry smooth needs a mesh with triangles, not points");
  RL::Smooth_geometry geometry;
  geometry.crease_angle = o.crease_angle;
  return RL::curved_surface(std::move(surface), geometry);
}

// The function with values at the vertices, between them as the options say.
template <class T>
RL::Cubic_surface_function<T> vertex_function(const RL::Triangulated_surface_3& surface,
                                              std::vector<T> values, const Common_options& o) {
  if(o.vertex_data == "linear" || surface.is_point_set())
    return RL::Cubic_surface_function<T>(std::move(values));
  RL::Smooth_geometry geometry;
  geometry.crease_angle = o.space.crease_angle;
  return RL::Cubic_surface_function<T>(surface, std::move(values), geometry);
}

// The values of a property at the vertices of the surface.
inline std::vector<double> surface_property(const RL::Triangulated_surface_3& surface,
                                            const Common_options& o, const std::string& name) {
  std::vector<double> values = read_vertex_property(o.mesh, name);
  require(values.size() == surface.number_of_vertices(), "not every vertex has a value");
  return values;
}

// Functions that are given at the vertices: a name and values of each.
struct Vertex_functions {
  std::vector<std::string> names;
  std::vector<std::vector<double>> values;
};

// Those of a list NAME,...: properties of the mesh; x, y and z stand for coordinates.
inline Vertex_functions vertex_functions(const RL::Triangulated_surface_3& surface,
                                         const Common_options& o, const std::string& names) {
  Vertex_functions result;
  std::istringstream list(names);
  for(std::string name; std::getline(list, name, ',');) {
    result.names.push_back(name);
    if(name != "x" && name != "y" && name != "z") {
      result.values.push_back(surface_property(surface, o, name));
      continue;
    }
    result.values.emplace_back();
    for(std::size_t v = 0; v < surface.number_of_vertices(); ++v)
      result.values.back().push_back(surface.point(v)[name[0] - 'x']);
  }
  require(!result.names.empty(), "--property names no property");
  return result;
}

// The diffusion and the density that the options name.
inline RL::Surface_material material(const RL::Triangulated_surface_3& surface,
                                     const Common_options& o) {
  RL::Surface_material result;
  if(const std::string& name = o.space.density_property; !name.empty())
    result.set_density(vertex_function(surface, surface_property(surface, o, name), o));
  const std::string& name = o.space.diffusion_property;
  if(name.empty())
    return result;
  if(has_vertex_property(o.mesh, name) || !has_vertex_property(o.mesh, name + "_xx")) {
    result.set_diffusion(vertex_function(surface, surface_property(surface, o, name), o));
    return result;
  }
  std::vector<Eigen::Matrix<double, 6, 1>> tensors(surface.number_of_vertices());
  Eigen::Index k = 0;
  for(const char* component : {"_xx", "_yy", "_zz", "_xy", "_xz", "_yz"}) {
    const std::vector<double> values = surface_property(surface, o, name + component);
    for(std::size_t v = 0; v < values.size(); ++v)
      tensors[v][k] = values[v];
    ++k;
  }
  result.set_diffusion(vertex_function(surface, std::move(tensors), o));
  return result;
}

// The space that the options ask for, with their way to integrate; the first one of a search.
inline RL::Spline_space_3 make_space(const RL::Triangulated_surface_3& surface,
                                     const Common_options& o) {
  std::optional<double> cube_scale, joining_tolerance, maximum_memory;
  if(o.space.cube_scale > 0)
    cube_scale = o.space.cube_scale;
  if(o.space.joining_tolerance >= 0)
    joining_tolerance = o.space.joining_tolerance;
  if(o.space.maximum_gigabytes > 0)
    maximum_memory = 1e9 * o.space.maximum_gigabytes;
  std::optional<int> depth = o.space.depth;
  if(o.space.accuracy)
    depth = RL::internal::first_depth_of_search(
        surface, RL::parameters::depth(depth).cube_scale(cube_scale));
  RL::Spline_space_options options =
      RL::parameters::depth(depth)
          .cube_scale(cube_scale)
          .joining_tolerance(joining_tolerance)
          .maximum_memory(maximum_memory)
          .paper(o.space.paper)
          .split(surface.is_point_set() ? o.space.split_point_set : o.space.split)
          .concurrency_tag(CGAL::Parallel_if_available_tag());
  options.material = material(surface, o);
  RL::Spline_space_3 space(surface, options);
  if(o.space.anisotropy >= 0) {
    options.material.set_diffusion(RL::curvature_diffusion(
        RL::estimate_curvature(space.with_material({})), {o.space.anisotropy, o.space.anisotropy}));
    space = space.with_material(options.material);
  }
  if(o.assembly != "monte-carlo")
    return space;
  return space.integrated_by(RL::Monte_carlo(
      space.octree(), static_cast<std::size_t>(o.samples), static_cast<std::uint64_t>(o.seed),
      o.sampling == "stratified" ? RL::Sampling::stratified : RL::Sampling::independent));
}

// `meaning` is what the number of connected components, if it is not 1, means for the result.
inline void add_space(Summary& summary, const RL::Spline_space_3& space,
                      const std::string& meaning) {
  const RL::Octree_3& octree = space.octree();
  summary.add("depth", space.depth());
  summary.add("dimension", space.dimension());
  if(space.surface().is_smooth())
    summary.add_explained("folded faces", space.surface().patches().number_of_folded_faces(),
                          ", they remain flat");
  summary.add_detail("cells", octree.number_of_cells(space.depth()));
  summary.add_detail("sheets", octree.number_of_sheets(space.depth()));
  summary.add_detail("split_elements", space.number_of_split_elements(space.depth()));
  // the whole surface is in the one cell of level 0
  if(!space.is_split())
    return;
  const std::size_t components = octree.number_of_sheets(0);
  summary.add_explained("components", components,
                        components == 1 ? "" : ", the surface is disconnected: " + meaning);
}

} // namespace programs

#endif // RESTRICTED_LAPLACIAN_3_PROGRAMS_SPACE_H

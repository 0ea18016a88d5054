// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_EXAMPLES_SPACE_H
#define RESTRICTED_LAPLACIAN_3_EXAMPLES_SPACE_H

// From the options of a program to a spline space, and to integrals over its surface.

#include "command_line.h"
#include "mesh_input.h"

#include <CGAL/Restricted_laplacian_3/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface_integration.h>

#include <cstddef>
#include <cstdint>

namespace examples {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = CGAL::parameters;

inline RL::Spline_space_3 make_space(const Mesh& mesh, const Common_options& o) {
  const double cube_scale =
      o.cube_scale > 0 ? o.cube_scale : RL::Spline_space_3::default_cube_scale(o.paper);
  return RL::Spline_space_3(
      mesh,
      params::octree_depth(o.depth, params::paper_space(o.paper, params::cube_scale(cube_scale))));
}

// Calls `assemble` with the way to integrate over the surface that the options ask for.
template <typename Assemble>
auto assemble_with(const RL::Spline_space_3& space, const Common_options& o, Assemble assemble) {
  if(o.assembly == "monte-carlo")
    return assemble(RL::Monte_carlo(space, static_cast<std::size_t>(o.samples),
                                    static_cast<std::uint64_t>(o.seed)));
  return assemble(RL::Cubature(space));
}

} // namespace examples

#endif // RESTRICTED_LAPLACIAN_3_EXAMPLES_SPACE_H

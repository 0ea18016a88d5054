// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_EXAMPLES_SPACE_H
#define RESTRICTED_LAPLACIAN_3_EXAMPLES_SPACE_H

// What both programs do with a spline space: describe it, and integrate over its surface.

#include "command_line.h"
#include "program.h"
#include "table.h"

#include <CGAL/Restricted_laplacian_3/integration/Cubature.h>
#include <CGAL/Restricted_laplacian_3/integration/Monte_carlo.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace examples {

// `meaning` is what the number of connected components, if it is not 1, means for the result.
inline void add_space(Summary& summary, const RL::Spline_space_3& space,
                      const std::string& meaning) {
  const RL::Octree_3& octree = space.octree();
  summary.add("depth", space.depth());
  summary.add("dimension", space.dimension());
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

// Calls `assemble` with the way to integrate over the surface that the options ask for.
template <typename Assemble>
auto assemble_with(const RL::Spline_space_3& space, const Common_options& o, Assemble assemble) {
  if(o.assembly == "monte-carlo")
    return assemble(RL::Monte_carlo(
        space, static_cast<std::size_t>(o.samples), static_cast<std::uint64_t>(o.seed),
        o.sampling == "stratified" ? RL::Sampling::stratified : RL::Sampling::independent));
  return assemble(RL::Default_integration(space));
}

} // namespace examples

#endif // RESTRICTED_LAPLACIAN_3_EXAMPLES_SPACE_H

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_SHARED_ASSEMBLE_SYSTEM_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_SHARED_ASSEMBLE_SYSTEM_IMPL_H

#include <CGAL/Restricted_laplacian_3/assembly/internal/Operator_assembly.h>
#include <CGAL/Restricted_laplacian_3/assembly/internal/Sparse_sink.h>
#include <CGAL/Restricted_laplacian_3/assembly/shared/assemble_system.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/explain_out_of_memory.h>

#include <cmath>
#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE double checked_normal_stabilization(double c) {
  if(!(c >= 0 && std::isfinite(c)))
    throw Parameter_error("stabilization",
                          "is " + std::to_string(c) +
                              ", but must be a finite number that is not negative");
  return c;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE System_matrices
assemble_system(const Spline_space_3& space, int coarsest, const Elliptic_operator& elliptic,
                Stored_entries stored, const Progress& progress, Sparse_matrix* mass) {
  checked_normal_stabilization(elliptic.stabilization);
  std::optional<Mass_weight> weight;
  if(elliptic.reaction_function)
    weight = Mass_weight{*elliptic.reaction_function, elliptic.name_of_reaction};
  return explain_out_of_memory("not enough memory for the matrices", [&] {
    const std::size_t number_of_levels = static_cast<std::size_t>(space.depth() - coarsest) + 1;
    System_matrices result;
    result.matrices.resize(number_of_levels);
    std::deque<Sparse_sink> sinks;
    std::vector<Assembly_targets> targets(space.depth() + 1);
    for(std::size_t i = 0; i < number_of_levels; ++i) {
      progress(0);
      const int level = coarsest + static_cast<int>(i);
      std::vector<Sparse_sink::Target> of_level = {
          {&result.matrices[i], elliptic.diffusion, weight ? 1 : elliptic.reaction}};
      if(mass && level == space.depth())
        of_level.push_back({mass, 0, 0, 1});
      sinks.emplace_back(space, level, std::move(of_level), stored);
      targets[level].sink = &sinks.back();
    }
    Assembly_targets& finest = targets[space.depth()];
    result.integrals = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(space.dimension()));
    finest.integrals = &result.integrals;
    if(weight) {
      result.constant_loads = result.integrals;
      finest.weighted_integrals = &result.constant_loads;
    }
    Operator_assembly(space, weight ? &*weight : nullptr, elliptic.stabilization, true)
        .run(targets, progress.part(part_of_pattern, 1));
    if(!weight)
      result.constant_loads = elliptic.reaction * result.integrals;
    return result;
  });
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_SHARED_ASSEMBLE_SYSTEM_IMPL_H

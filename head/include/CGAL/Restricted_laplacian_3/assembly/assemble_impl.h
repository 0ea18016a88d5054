// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_ASSEMBLE_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_ASSEMBLE_IMPL_H

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/assembly/internal/Operator_assembly.h>
#include <CGAL/Restricted_laplacian_3/assembly/internal/Sparse_sink.h>
#include <CGAL/Restricted_laplacian_3/assembly/shared/assemble_system.h>
#include <CGAL/Restricted_laplacian_3/assembly/shared/sheet_loads.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/explain_out_of_memory.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

// Matrices are exchanged in what follows, because a `SparseMatrix` of Eigen 3.4 is copied where
// another class would be moved.

namespace CGAL {
namespace Restricted_laplacian_3 {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void assemble_into(const Spline_space_3& space, int coarsest,
                                                      const std::vector<Operator_sink*>& sinks,
                                                      double stabilization, Stabilized stabilized,
                                                      const std::function<bool(double)>& callback) {
  space.checked_level(coarsest);
  internal::checked_normal_stabilization(stabilization);
  if(sinks.empty())
    return;
  space.checked_level(coarsest + static_cast<int>(sinks.size()) - 1);
  std::vector<internal::Assembly_targets> targets(space.depth() + 1);
  for(std::size_t i = 0; i < sinks.size(); ++i)
    targets[coarsest + i].sink = sinks[i];
  internal::Operator_assembly(space, nullptr, stabilization,
                              stabilized == Stabilized::stiffness_and_mass)
      .run(targets, internal::Progress(callback));
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<Operators>
assemble_operators_of_levels(const Spline_space_3& space, int coarsest, int finest,
                             double stabilization, Stabilized stabilized,
                             const std::function<bool(double)>& callback) {
  space.checked_level(coarsest);
  space.checked_level(finest);
  internal::checked_normal_stabilization(stabilization);
  std::vector<Operators> operators;
  if(coarsest > finest)
    return operators;
  internal::explain_out_of_memory("not enough memory for the matrices", [&] {
    operators.resize(static_cast<std::size_t>(finest - coarsest) + 1);
    std::deque<internal::Sparse_sink> sinks;
    std::vector<Operator_sink*> pointers;
    const internal::Progress progress(callback);
    progress(0);
    for(int level = coarsest; level <= finest; ++level) {
      Operators& o = operators[level - coarsest];
      sinks.emplace_back(
          space, level,
          std::vector<internal::Sparse_sink::Target>{{&o.stiffness, 1, 0}, {&o.mass, 0, 1}});
      pointers.push_back(&sinks.back());
    }
    assemble_into(space, coarsest, pointers, stabilization, stabilized,
                  progress.part(internal::part_of_pattern, 1).callback());
  });
  return operators;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Operators assemble_operators(const Spline_space_3& space,
                                                                std::optional<int> level,
                                                                double stabilization,
                                                                Stabilized stabilized) {
  const int l = space.checked_level(level);
  std::vector<Operators> of_level =
      assemble_operators_of_levels(space, l, l, stabilization, stabilized);
  Operators result;
  result.stiffness.swap(of_level.front().stiffness);
  result.mass.swap(of_level.front().mass);
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Sparse_matrix assemble_stiffness_matrix(
    const Spline_space_3& space, std::optional<int> level, double stabilization) {
  const int l = space.checked_level(level);
  Sparse_matrix stiffness;
  internal::Sparse_sink sink(space, l, {{&stiffness, 1, 0}});
  assemble_into(space, l, {&sink}, stabilization);
  return stiffness;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Sparse_matrix assemble_mass_matrix(const Spline_space_3& space,
                                                                      std::optional<int> level) {
  const int l = space.checked_level(level);
  Sparse_matrix mass;
  internal::Sparse_sink sink(space, l, {{&mass, 0, 1}});
  assemble_into(space, l, {&sink});
  return mass;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::MatrixXd
assemble_component_loads(const Spline_space_3& space, const Surface_function_view& f,
                         std::optional<int> of_level) {
  const int level = space.checked_level(of_level);
  const double h = space.octree().cell_width(space.depth());
  return internal::sum_loads(space, level, f.components(), h * h,
                             [&](std::size_t sheet, internal::Cell_load::Load* loads) {
                               internal::Function_moments moments(f, "f");
                               internal::add_function(space, level, sheet, moments);
                               for(std::size_t k = 0; k < moments.number_of_components(); ++k)
                                 moments[k].add_values_to(loads[k]);
                             });
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::VectorXd assemble_load(const Spline_space_3& space,
                                                                 const Surface_function_view& f,
                                                                 std::optional<int> level) {
  if(f.components() != 1)
    throw Parameter_error("f", "has " + std::to_string(f.components()) +
                                   " components; see assemble_component_loads()");
  return assemble_component_loads(space, f, level);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::MatrixXd
assemble_gradient_loads(const Spline_space_3& space, const Vector_field_view& v,
                        std::optional<int> of_level) {
  const int level = space.checked_level(of_level);
  const double h = space.octree().cell_width(space.depth());
  const double coarse_h = space.octree().cell_width(level);
  using Moments = internal::Function_moments;
  return internal::sum_loads(space, level, v.channels(), h * h / coarse_h,
                             [&](std::size_t sheet, internal::Cell_load::Load* loads) {
                               Moments moments(v, "v", Moments::Of::fluxes);
                               internal::add_function(space, level, sheet, moments);
                               for(std::size_t k = 0; k < moments.number_of_components(); ++k)
                                 moments[k].add_derivatives_to(static_cast<int>(k % 3),
                                                               loads[k / 3]);
                             });
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::VectorXd
assemble_gradient_load(const Spline_space_3& space, const Vector_field_view& v,
                       std::optional<int> level) {
  if(v.channels() != 1)
    throw Parameter_error("v", "has " + std::to_string(v.channels()) +
                                   " channels; see assemble_gradient_loads()");
  return assemble_gradient_loads(space, v, level);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::VectorXd
assemble_element_integrals(const Spline_space_3& space, std::optional<int> level) {
  return assemble_load(space, function_of_degree([](const Surface_point&) { return 1.; }, 0),
                       level);
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_ASSEMBLE_IMPL_H

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_SHARED_SHEET_LOADS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_SHARED_SHEET_LOADS_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Function_view.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/integration/Surface_integration.h>
#include <CGAL/Restricted_laplacian_3/integration/shared/Cell_load.h>
#include <CGAL/Restricted_laplacian_3/integration/shared/Function_moments.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Visits the nodes on a sheet of `level` in blocks, with local coordinates in its cell; weights
/// are in units of the squared width of the finest cells.
/// \param degree of what is integrated
inline void visit_nodes_of_level(const Spline_space_3& space,
                                 const Surface_integration& integration, int level,
                                 std::size_t sheet, int degree,
                                 const Integration_nodes::Consumer& visit) {
  const Octree_3& octree = space.octree();
  const int depth = octree.depth();
  if(level == depth)
    return integration.visit_nodes(sheet, degree, visit);
  std::vector<std::uint32_t> descendants(1, static_cast<std::uint32_t>(sheet)), next;
  for(int l = level; l < depth; ++l, descendants.swap(next)) {
    next.clear();
    for(std::uint32_t s : descendants)
      next.insert(next.end(), octree.children(l, s).begin(), octree.children(l, s).end());
  }
  const Cell_3 coarse = octree.cell(level, sheet);
  // local coordinate in the coarse cell: scale (t + offset)
  const double scale = std::ldexp(1., level - depth);
  for(std::uint32_t s : descendants) {
    const Cell_3 fine = octree.cell(depth, s);
    integration.visit_nodes(s, degree, [&](Integration_node_block& block) {
      for(int axis = 0; axis < 3; ++axis) {
        const double offset = fine.index[axis] - (coarse.index[axis] << (depth - level));
        for(std::size_t i = 0; i < block.size; ++i)
          block.positions[axis][i] = scale * (block.positions[axis][i] + offset);
      }
      visit(block);
    });
  }
}

/// adds a function on a sheet of `level`
inline void add_function(const Spline_space_3& space, int level, std::size_t sheet,
                         Function_moments& moments) {
  // loads have the density as weight, and nothing of the diffusion
  const Surface_integration& integration =
      space.material().has_density() ? space.integration_with_material() : space.integration();
  if(level == space.depth() && integration.adds_linear_functions() && moments.is_linear())
    return integration.add_linear_function(sheet, moments);
  visit_nodes_of_level(space, integration, level, sheet, moments.degree(),
                       [&](Integration_node_block& block) { moments.add(block); });
}

/// The vectors, columns of a matrix, that get from each sheet of `level` what
/// `loads_of_sheet(sheet, loads)` writes for its elements, times `factor`: one `Cell_load::Load`
/// for each column, 0 before. Sheets are computed on several threads, and added in their order.
inline Eigen::MatrixXd
sum_loads(const Spline_space_3& space, int level, int columns, double factor,
          Function_view<void(std::size_t, Cell_load::Load*)> loads_of_sheet) {
  constexpr std::size_t grain = 256, sheets_at_once = 64 * grain;
  const std::size_t number_of_sheets = space.octree().number_of_sheets(level);
  const std::size_t number = static_cast<std::size_t>(columns);
  Eigen::MatrixXd sums =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(space.dimension(level)), columns);
  std::vector<Cell_load::Load> loads(number * (std::min)(sheets_at_once, number_of_sheets));
  for(std::size_t first = 0; first < number_of_sheets; first += sheets_at_once) {
    const std::size_t last = (std::min)(first + sheets_at_once, number_of_sheets);
    parallel_for(space.options().is_parallel, first, last, grain,
                 [&](std::size_t begin, std::size_t end) {
                   for(std::size_t sheet = begin; sheet < end; ++sheet) {
                     Cell_load::Load* const of_sheet = loads.data() + number * (sheet - first);
                     std::fill(of_sheet, of_sheet + number, Cell_load::Load{});
                     loads_of_sheet(sheet, of_sheet);
                   }
                 });
    for(std::size_t sheet = first; sheet < last; ++sheet) {
      const Cell_elements& elements = space.elements(level, sheet);
      const Cell_load::Load* const of_sheet = loads.data() + number * (sheet - first);
      for(std::size_t k = 0; k < number; ++k)
        for_each_element(elements, [&](int i, std::uint32_t element) {
          sums(element, static_cast<Eigen::Index>(k)) += factor * of_sheet[k][i];
        });
    }
  }
  return sums;
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_SHARED_SHEET_LOADS_H

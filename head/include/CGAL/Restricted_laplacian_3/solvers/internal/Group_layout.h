// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_GROUP_LAYOUT_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_GROUP_LAYOUT_H

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Number_lists.h>
#include <CGAL/Restricted_laplacian_3/solvers/Multigrid_levels.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/Level_vectors.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/Symmetric_rows.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Where the unknowns of a level are, how they are scaled, and what is relaxed at the same time.
struct Group_layout {
  Group_layout(const Sparse_matrix& a, const Smoothing_patches& patches, bool parallel)
    : is_parallel(parallel), scale(balancing_scale(a)), colors(patches.colors) {
    CGAL_precondition(a.rows() == a.cols());
    CGAL_precondition(patches.groups.back() == patches.number_of_patches);
    CGAL_precondition(patches.colors.back() + 1 == patches.groups.size());
  }

  bool is_parallel;
  std::vector<double> scale;
  Level_positions positions;
  std::vector<std::uint32_t> colors; // first group of each, and one more
};

/// For each unknown the number of a neighborhood, such that what `Smoothing_patches` asks of
/// neighborhoods holds: unknowns of one are in, or coupled with, the same groups. For patches
/// whose neighborhoods are not known.
inline std::vector<std::uint64_t> independent_neighborhoods(const Sparse_matrix& a,
                                                            const Smoothing_patches& patches) {
  const std::size_t n = static_cast<std::size_t>(a.cols());
  std::vector<Number_lists::Pair> pairs;
  for(std::uint32_t group = 0; group + 1 < patches.groups.size(); ++group)
    for(std::uint32_t p = patches.groups[group]; p < patches.groups[group + 1]; ++p)
      for(std::uint32_t i : patches.unknowns[p])
        pairs.emplace_back(i, group);
  const Number_lists groups(n, pairs);
  const Symmetric_rows rows(a);
  // neighborhoods are numbered in the order in which their lists of groups come first
  std::map<std::vector<std::uint32_t>, std::uint64_t> numbers;
  std::vector<std::uint64_t> result(n);
  std::vector<std::uint32_t> nearby;
  for(std::size_t i = 0; i < n; ++i) {
    nearby.assign(groups[i].begin(), groups[i].end());
    rows.for_each_entry(static_cast<int>(i), [&](int j, double) {
      nearby.insert(nearby.end(), groups[j].begin(), groups[j].end());
    });
    std::sort(nearby.begin(), nearby.end());
    nearby.erase(std::unique(nearby.begin(), nearby.end()), nearby.end());
    result[i] = numbers.try_emplace(nearby, numbers.size()).first->second;
  }
  return result;
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_GROUP_LAYOUT_H

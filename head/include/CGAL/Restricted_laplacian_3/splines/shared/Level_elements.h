// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SHARED_LEVEL_ELEMENTS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SHARED_LEVEL_ELEMENTS_H

#include <CGAL/Restricted_laplacian_3/basis/Tensor_basis_3.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The elements of a level of a space.
struct Level_elements {
  /// of sheets; `no_element` where there is none
  std::vector<Cell_elements> elements;
  /// of each element: the first of the places in `elements` that have its number
  std::vector<std::uint32_t> first_slots;
  std::size_t number_of_split_elements = 0;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SHARED_LEVEL_ELEMENTS_H

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_STABILIZATION_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_STABILIZATION_IMPL_H

#include <CGAL/Restricted_laplacian_3/problems/stabilization.h>

namespace CGAL {
namespace Restricted_laplacian_3 {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE double
default_normal_stabilization(const Spline_space_3& space) {
  return space.is_paper_space() ? 0 : 1e-3;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE double
default_spectrum_stabilization(const Spline_space_3& space) {
  return space.is_paper_space() ? 0 : 1e-5;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_STABILIZATION_IMPL_H

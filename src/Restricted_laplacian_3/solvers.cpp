// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Restricted_laplacian_3/solvers/Multigrid_solver_impl.h>
#include <CGAL/Restricted_laplacian_3/solvers/galerkin_product_impl.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/Regularized_inverse_impl.h>
#include <CGAL/Restricted_laplacian_3/solvers/shared/Mean_projection_impl.h>
#include <CGAL/Restricted_laplacian_3/solvers/smoothers_impl.h>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

template class Group_smoother<Gauss_seidel_groups>;
template class Group_smoother<Patch_groups>;

// for one vector, and for eight
#define INSTANTIATE_FOR_BLOCK(K)                                                                   \
  template void Group_smoother<Gauss_seidel_groups>::pre_smooth<K>(                                \
      const Level_vectors<K>&, Level_vectors<K>&, Level_vectors<K>&, int) const;                   \
  template void Group_smoother<Gauss_seidel_groups>::post_smooth<K>(const Level_vectors<K>&,       \
                                                                    Level_vectors<K>&, int) const; \
  template void Group_smoother<Gauss_seidel_groups>::residual<K>(                                  \
      const Level_vectors<K>&, const Level_vectors<K>&, Level_vectors<K>&) const;                  \
  template void Group_smoother<Patch_groups>::pre_smooth<K>(                                       \
      const Level_vectors<K>&, Level_vectors<K>&, Level_vectors<K>&, int) const;                   \
  template void Group_smoother<Patch_groups>::post_smooth<K>(const Level_vectors<K>&,              \
                                                             Level_vectors<K>&, int) const;        \
  template void Group_smoother<Patch_groups>::residual<K>(                                         \
      const Level_vectors<K>&, const Level_vectors<K>&, Level_vectors<K>&) const;                  \
  template void Group_smoother<Patch_groups>::relax_color<K>(std::size_t, const Level_vectors<K>&, \
                                                             Level_vectors<K>&, bool) const;       \
  template void Regularized_inverse::apply<K>(const Block_vector<K>&, Block_vector<K>&) const;     \
  template void Mean_projection::project_load<K>(Block_vector<K>&) const;                          \
  template void Mean_projection::shift_solution<K>(const Block_vector<K>&, Block_vector<K>&) const;

INSTANTIATE_FOR_BLOCK(1)
INSTANTIATE_FOR_BLOCK(8)

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_MULTIGRID_OF(, Gauss_seidel_smoother)
CGAL_RESTRICTED_LAPLACIAN_3_MULTIGRID_OF(, Patch_smoother)

} // namespace Restricted_laplacian_3
} // namespace CGAL

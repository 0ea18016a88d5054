// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\headerfile smoothers.h <CGAL/Restricted_laplacian_3/smoothers.h>
\ingroup PkgRestrictedLaplacian3Concepts
\cgalConcept

What `CGAL::Restricted_laplacian_3::Multigrid` does on each level but the coarsest, before and after
the coarse correction: a linear iteration that reduces the part of the error that coarser levels
cannot represent. It knows matrices only, no surface.

Let \f$x \leftarrow x + B (b - A x)\f$ be what `pre_smooth()` does. Then `post_smooth()` has to do
\f$x \leftarrow x + B^T (b - A x)\f$, so that a cycle is a symmetric operator, and both have to
converge, in the norm of \f$A\f$, for each right-hand side in the range of \f$A\f$, so that it is
positive. Without that it cannot precondition conjugate gradients.

Vectors are passed as `internal::Block_vector<K>`: a dense matrix of Eigen with `K` columns, stored
row by row, so that one pass over the sparse matrix serves `K` right-hand sides.

\cgalRefines `MoveConstructible`

\cgalHasModel `CGAL::Restricted_laplacian_3::Gauss_seidel_smoother`
*/
class MultigridSmoother_3 {
public:
  /*!
  prepares the smoother for a matrix. It is symmetric and positive semi-definite, all of its entries
  are stored, and the rows of each column are sorted; rows may be empty. The matrix is passed again
  to the functions below; the smoother must not refer to it, because a hierarchy can be copied.
  */
  explicit MultigridSmoother_3(const Eigen::SparseMatrix<double>& a);

  /*!
  makes `steps` smoothing steps from \f$x = 0\f$ for the right-hand side `b`. The old content and
  size of `x` and `r` do not matter; on return, `r` is the residual \f$b - A x\f$. With no steps,
  `x` is 0 and `r` is `b`.
  */
  template <int K>
  void pre_smooth(const Eigen::SparseMatrix<double>& a, const internal::Block_vector<K>& b,
                  internal::Block_vector<K>& x, internal::Block_vector<K>& r, int steps) const;

  /*!
  makes `steps` smoothing steps from the given `x`, the transposes of those of `pre_smooth()`.
  */
  template <int K>
  void post_smooth(const Eigen::SparseMatrix<double>& a, const internal::Block_vector<K>& b,
                   internal::Block_vector<K>& x, int steps) const;
};

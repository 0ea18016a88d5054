// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\headerfile smoothers.h <CGAL/Restricted_laplacian_3/solvers/smoothers.h>
\ingroup PkgRestrictedLaplacian3Concepts
\cgalConcept

What `CGAL::Restricted_laplacian_3::Multigrid` does on each level but the coarsest, before and after
the coarse correction: a linear iteration that reduces the part of the error that coarser levels
cannot represent. It knows matrices only, no surface.

Let \f$x \leftarrow x + B (b - A x)\f$ be what `pre_smooth()` does. Then `post_smooth()` has to do
\f$x \leftarrow x + B^T (b - A x)\f$, so that a cycle is a symmetric operator, and both have to
converge, in the norm of \f$A\f$, for each right-hand side in the range of \f$A\f$, so that it is
positive. Without that it cannot precondition conjugate gradients.

A smoother stores the matrix in a form and order of its own, in single precision, scaled to
\f$D A D\f$ with a diagonal matrix \f$D\f$ that it chooses. Vectors are passed as
`Level_vectors<K>`, `K` of them, in the order of `positions()`, and belong to the scaled
matrix.

\cgalRefines `MoveConstructible`

\cgalHasModel `CGAL::Restricted_laplacian_3::Patch_smoother`
\cgalHasModel `CGAL::Restricted_laplacian_3::Gauss_seidel_smoother`
*/
class MultigridSmoother_3 {
public:
  /*!
  prepares the smoother for a matrix, to which it must not refer afterwards.
  \param a a symmetric and positive semi-definite matrix. All of its entries are stored, and the rows
  of each column are sorted; rows may be empty.
  \param patches sets of unknowns that may be relaxed together, groups of them that may be relaxed at
  the same time; there may be none
  \param is_parallel whether to use several threads. Results must not depend on their number.
  \param matrix_is_read if not empty, to be called when the smoother no longer reads `a`, which may be
  another matrix after that
  */
  MultigridSmoother_3(const Eigen::SparseMatrix<double>& a, const Smoothing_patches& patches,
                      bool is_parallel, const std::function<void()>& matrix_is_read = {});

  /*!
  where each unknown is in the vectors. Positions of no unknown hold 0 in the vectors that are
  passed, and must hold 0 in those that are returned.
  */
  const Level_positions& positions() const;

  /*!
  the diagonal of \f$D\f$, for each unknown
  */
  const std::vector<double>& scale() const;

  /*!
  makes `steps` smoothing steps from \f$x = 0\f$ for the right-hand side `b`. The old content and
  size of `x` and `r` do not matter; on return, `r` is the residual \f$b - A x\f$. With no steps,
  `x` is 0 and `r` is `b`.
  */
  template <int K>
  void pre_smooth(const Level_vectors<K>& b, Level_vectors<K>& x,
                  Level_vectors<K>& r, int steps) const;

  /*!
  makes `steps` smoothing steps from the given `x`, the transposes of those of `pre_smooth()`.
  */
  template <int K>
  void post_smooth(const Level_vectors<K>& b, Level_vectors<K>& x,
                   int steps) const;

  /*!
  \f$r = b - A x\f$
  */
  template <int K>
  void residual(const Level_vectors<K>& b, const Level_vectors<K>& x,
                Level_vectors<K>& r) const;
};

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\headerfile Multigrid.h <CGAL/Restricted_laplacian_3/solvers/Multigrid.h>
\ingroup PkgRestrictedLaplacian3Concepts
\cgalConcept

What `CGAL::Restricted_laplacian_3::Multigrid` does on each level but the coarsest, before and after
the coarse correction: a linear iteration that reduces the part of the error that coarser levels
cannot represent. It knows matrices only, no surface.

Let \f$x \leftarrow x + B (b - A x)\f$ be what `smooth()` does. Then `smooth_transposed()` has to do
\f$x \leftarrow x + B^T (b - A x)\f$, so that a cycle is a symmetric operator, and both have to
converge, in the norm of \f$A\f$, for each right-hand side in the range of \f$A\f$, so that it is
positive. Without that it cannot precondition conjugate gradients.

The smoothers of the package are models as well. They have more than this: vectors in single
precision, in an order that suits them, in which `Multigrid` then does a whole cycle.

\cgalRefines `MoveConstructible`

\cgalHasModel `CGAL::Restricted_laplacian_3::Patch_smoother`
\cgalHasModel `CGAL::Restricted_laplacian_3::Gauss_seidel_smoother`
*/
class MultigridSmoother_3 {
public:
  /*!
  prepares the smoother for a matrix, to which it may refer: the matrix lives as long.
  \param a a symmetric and positive semi-definite matrix. All of its entries are stored, and the rows
  of each column are sorted; rows may be empty.
  \param patches sets of unknowns that may be relaxed together, groups of them that may be relaxed at
  the same time; there may be none
  \param is_parallel whether to use several threads. Results must not depend on their number.
  */
  MultigridSmoother_3(const Eigen::SparseMatrix<double>& a, const Smoothing_patches& patches,
                      bool is_parallel);

  /*!
  makes one step, \f$x \leftarrow x + B (b - A x)\f$, for each column.
  \param b right-hand sides, in the numbering of the matrix
  \param x as many solutions
  */
  void smooth(const Eigen::MatrixXd& b, Eigen::MatrixXd& x) const;

  /*!
  makes the transposed step, \f$x \leftarrow x + B^T (b - A x)\f$. Of several steps after the coarse
  correction each is the transpose of one before it.
  */
  void smooth_transposed(const Eigen::MatrixXd& b, Eigen::MatrixXd& x) const;
};

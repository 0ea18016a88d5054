// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_STABILIZATION_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_STABILIZATION_H

#include <CGAL/Restricted_laplacian_3/foundation/compiled.h>
#include <CGAL/Restricted_laplacian_3/foundation/parameters.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \file
/// How strongly each problem is stabilized, unless told otherwise: the factor \f$c\f$ of
/// `assemble_operators()`. All of these decisions are here.

/// \ingroup PkgRestrictedLaplacian3Solvers
/// For Poisson problems and gradient fields: 1e-3, and 0 in the space of the paper. The number of
/// iterations does not depend on the depth of the octree then, while the error of the solution is
/// up to about twice that without stabilization.
double default_normal_stabilization(const Spline_space_3& space);

/// \ingroup PkgRestrictedLaplacian3Solvers
/// For `laplace_spectrum()`, of the stiffness matrix alone: 1e-5, and 0 in the space of the paper.
/// With it `multigrid_eigenpairs()` needs few iterations on any surface, while eigenvalues change
/// by no more than the discretization changes them.
double default_spectrum_stabilization(const Spline_space_3& space);

/// \ingroup PkgRestrictedLaplacian3Fits
/// Factor of the stabilization for `estimate_curvature()`: larger than for other fits, because it
/// is the derivatives that count.
constexpr double default_curvature_stabilization = 0.01;

namespace internal {

/// Fits choose among several factors, for each component of a function: with the first one the
/// number of iterations does not depend on the depth; the last one is as small as rounding permits.
/// A factor is good enough if the energy of the stabilization is at most a fraction of what is
/// minimized.
struct Fit_stabilization {
  static constexpr std::array<double, 3> factors = {1e-4, 1e-5, 1e-14};
  /// of one solve with the smallest factor; what does not converge then gets the factor before it
  static constexpr int maximum_iterations_of_smallest = 60;

  /// which factor comes after number `i`, or `i` itself if it is good enough
  /// \param energy of the stabilization, over what is minimized
  /// \param function_square,error_square integrals of the squares of a function and of its error
  static std::size_t next(std::size_t i, double energy, double function_square,
                          double error_square) {
    // Rough functions are those whose root mean square error is above 1 % of their own root mean
    // square: they are far from the space, and the stabilization adds little to their error.
    constexpr double squared_error_of_rough = 1e-4;
    constexpr double small_of_rough = 0.5, small_of_smooth = 0.1, large = 1;
    const double small =
        error_square > squared_error_of_rough * function_square ? small_of_rough : small_of_smooth;
    const std::size_t last = factors.size() - 1;
    if(i == last || energy <= small)
      return i;
    return energy > large ? last : i + 1;
  }
};

/// the value of `normal_stabilization`, by default that of the space
template <class NamedParameters>
double normal_stabilization(const Spline_space_3& space, const NamedParameters& np) {
  double result = default_normal_stabilization(space);
  read_parameter(np, internal_np::normal_stabilization, result);
  return result;
}

} // namespace internal

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/problems/stabilization_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_STABILIZATION_H

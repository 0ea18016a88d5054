// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MOVED_INTEGRATION_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MOVED_INTEGRATION_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/integration/Integration_nodes.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <Eigen/Core>

#include <cstddef>
#include <memory>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Problems
/// Which metric a `Moved_integration` gives a surface that moves.
enum class Moved_metric {
  /// that of the moved surface
  moved,
  /// with the areas of the moved surface, and the energy \f$\int \lvert \nabla u \rvert^2\f$ of the
  /// first one: as if angles had been kept
  conformal
};

/// \ingroup PkgRestrictedLaplacian3Problems
/// Integration over a surface that has moved, while the elements stay on the first one: the
/// position of a point is a spline \f$x\f$ of the space, three functions, and an element \f$b_i\f$
/// is carried along. With the tangential derivatives \f$a = \partial_1 x\f$, \f$b = \partial_2 x\f$
/// in an orthonormal frame and \f$g_{ij}\f$ their products, areas are multiplied by
/// \f$\sqrt{\det g} = \lvert a \times b \rvert\f$, and the metric is \f$g^{-1}\f$.
///
/// `space.integrated_by(Moved_integration(space, x))` is a space on the moved surface: its
/// spectrum, its Poisson problems and so on are those of that surface. Its matrices cost one pass
/// over the nodes; the octree, the elements and their numbers remain.
///
/// Where the moved surface degenerates, the determinant has the lower bound
/// \f$10^{-12}\, (\mathrm{tr}\, g / 2)^2\f$, so that matrices stay finite.
///
/// Fragments in a cell that has many of them take rules of lower degree than those of flat
/// surfaces, since the integrand is no polynomial.
///
/// \cgalModels `SurfaceIntegration_3`
class Moved_integration {
public:
  /// \param space whose integration, without a material, gives the nodes; its octree must outlive
  /// this object
  /// \param positions coefficients of \f$x\f$: a row for each element of the finest level, three
  /// columns
  /// \param metric which one
  /// \throws Parameter_error if the size of `positions` does not fit, or if a number is not finite
  Moved_integration(const Spline_space_3& space, const Eigen::MatrixXd& positions,
                    Moved_metric metric = Moved_metric::moved);

  /// the nodes on a sheet, with weights and metrics of the moved surface
  void add_nodes(std::size_t sheet, int degree, Integration_nodes& nodes) const;

private:
  Spline_space_3 m_space;
  std::shared_ptr<const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>> m_positions;
  Moved_metric m_metric;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/problems/Moved_integration_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MOVED_INTEGRATION_H

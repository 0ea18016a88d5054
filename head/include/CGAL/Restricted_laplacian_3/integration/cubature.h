// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_CUBATURE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_CUBATURE_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/integration/Integration_nodes.h>
#include <CGAL/Restricted_laplacian_3/integration/Surface_integration.h>
#include <CGAL/Restricted_laplacian_3/octree/Octree_3.h>

#include <cstddef>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Operators
/// Integration over a surface of triangles, exact for all that a matrix needs: triangles are cut
/// along the walls of the cells, and a rule of the wanted degree, Taylor's of degree 12 for
/// matrices, is applied to the fragments.
///
/// \cgalModels `SurfaceIntegration_3`
class Triangle_cubature {
public:
  /// \param octree that of a space; must outlive this object
  /// \throws Input_error the surface is a point set, or smooth: take `Point_cubature` or
  /// `Patch_cubature`
  explicit Triangle_cubature(const Octree_3& octree);

  /// the nodes of the smallest rule that is exact up to `degree`, at most 12
  void add_nodes(std::size_t sheet, int degree, Integration_nodes& nodes) const;

  /// \cond
  // Moments without nodes: the normal is constant on a fragment.
  void add_moments(std::size_t sheet, const internal::Factors_of_face* factors,
                   internal::Sheet_integrals& integrals) const;
  // A function that is linear on each face: its values at the corners of a fragment say all.
  void add_linear_function(std::size_t sheet, internal::Function_moments& moments) const;
  /// \endcond

private:
  const Octree_3* m_octree;
};

/// \ingroup PkgRestrictedLaplacian3Operators
/// Integration over a surface that is given by points: the sum over its points, each times the area
/// that it stands for (paper, section 4.3).
///
/// \cgalModels `SurfaceIntegration_3`
class Point_cubature {
public:
  /// \param octree that of a space; must outlive this object
  /// \throws Input_error the surface is no point set
  explicit Point_cubature(const Octree_3& octree);

  /// the points, whatever the degree
  void add_nodes(std::size_t sheet, int degree, Integration_nodes& nodes) const;

private:
  const Octree_3* m_octree;
};

/// \ingroup PkgRestrictedLaplacian3Operators
/// Integration over a smooth surface: the nodes of `Triangle_cubature` on the flat pieces of the
/// patches are moved to the patches, with the area and the normal there. Elements are evaluated by
/// the polynomial pieces of the cell that has the flat node, perhaps a little outside of it. Flat
/// patches are integrated as triangles are.
///
/// \cgalModels `SurfaceIntegration_3`
class Patch_cubature {
public:
  /// \param octree that of a space; must outlive this object
  /// \throws Input_error the surface is not smooth
  explicit Patch_cubature(const Octree_3& octree);

  /// The nodes of the smallest rule that is exact on flat patches up to `degree`, at most 12; on
  /// fragments of patches that are not flat, of one of degree 8 at most, 6 where they are smaller
  /// than 0.6 of the cell, and 4 below 0.3: on small parts of a cell elements are nearly of low
  /// degree.
  void add_nodes(std::size_t sheet, int degree, Integration_nodes& nodes) const;

  /// \cond
  void add_moments(std::size_t sheet, const internal::Factors_of_face* factors,
                   internal::Sheet_integrals& integrals) const;
  /// \endcond

private:
  const Octree_3* m_octree;
};

/// \cond SKIP_IN_MANUAL
/// \ingroup PkgRestrictedLaplacian3Operators
/// How spaces integrate that are given no other integration: by `Triangle_cubature`, by
/// `Patch_cubature` if the surface is smooth, or by `Point_cubature` if it is given by points.
/// \param octree must outlive what is returned
Surface_integration default_integration(const Octree_3& octree);
/// \endcond

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/integration/cubature_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_CUBATURE_H

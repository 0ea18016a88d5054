// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_SURFACE_INTEGRATION_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_SURFACE_INTEGRATION_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/integration/cell_integrals.h>
#include <CGAL/Restricted_laplacian_3/integration/internal/sheet_kernels.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/sample_surface.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Operators
/// Integration over the surface, exact for all that a matrix needs: triangles are cut along the
/// walls of the cells, and Taylor's rule of degree 12 is applied to the fragments.
///
/// A surface that is given by points is integrated by the sum over its points, each times the area
/// that it stands for (paper, section 4.3).
///
/// \cgalModels `SurfaceIntegration_3`
class Cubature {
public:
  /// The space must outlive this object.
  explicit Cubature(const Spline_space_3& space)
    : m_octree(&space.octree()), m_is_point_set(space.surface().is_point_set()) {}

  /// adds the moments of a sheet of the finest level
  void add_moments(std::size_t sheet, Cell_moments& moments) const {
    if(m_is_point_set)
      return add_moments_of_points(sheet, moments);
    const Cell_3 cell = m_octree->cell(m_octree->depth(), sheet);
    for(std::uint32_t face : m_octree->faces(sheet))
      add_fragment(m_octree->fragment(cell, face), cell.index, m_octree->surface().normal(face),
                   moments);
  }

  /// the same, as the assembly wants it
  void add_moments(std::size_t sheet, internal::Sheet_moments& moments) const {
    if(m_is_point_set) {
      Cell_moments sum = moments.cell_moments();
      add_moments_of_points(sheet, sum);
      moments = internal::Sheet_moments(sum);
      return;
    }
    const Cell_3 cell = m_octree->cell(m_octree->depth(), sheet);
    for(std::uint32_t face : m_octree->faces(sheet))
      internal::add_fragment(m_octree->fragment(cell, face), cell.index,
                             m_octree->surface().normal(face), moments);
  }

  /// Calls `visit(t, location, weight)` for the nodes on a sheet of the finest level: local
  /// coordinate in the cell, as `std::array<double, 3>`; `Surface_location`; weight in units of the
  /// squared cell width.
  template <class Visitor> void for_each_node(std::size_t sheet, Visitor&& visit) const {
    for_each_node(sheet, 12, visit);
  }

  /// The same with the nodes of a rule that is exact up to `degree`, at most 12.
  template <class Visitor>
  void for_each_node(std::size_t sheet, int degree, Visitor&& visit) const {
    if(m_is_point_set)
      return for_each_point(sheet, visit);
    const Cell_3 cell = m_octree->cell(m_octree->depth(), sheet);
    const std::vector<Triangle_quadrature_node>& rule = triangle_quadrature(degree);
    Surface_location location;
    for(std::uint32_t face : m_octree->faces(sheet)) {
      location.face = face;
      internal::for_each_node(m_octree->fragment(cell, face), cell.index, rule,
                              [&](const std::array<double, 3>& t,
                                  const std::array<double, 3>& barycentric, double weight) {
                                location.barycentric = barycentric;
                                visit(t, static_cast<const Surface_location&>(location), weight);
                              });
    }
  }

private:
  template <class Visitor> void for_each_point(std::size_t sheet, Visitor&& visit) const {
    const int depth = m_octree->depth();
    const double h = m_octree->cell_width(depth);
    const Triangulated_surface_3& surface = m_octree->surface();
    const Cell_3 cell = m_octree->cell(depth, sheet);
    Surface_location location;
    for(std::uint32_t point : m_octree->faces(sheet)) {
      location.face = point;
      std::array<double, 3> t = m_octree->grid_coordinates(depth, surface.point(point));
      for(int axis = 0; axis < 3; ++axis)
        t[axis] -= cell.index[axis];
      visit(t, static_cast<const Surface_location&>(location), surface.area(point) / h / h);
    }
  }

  void add_moments_of_points(std::size_t sheet, Cell_moments& moments) const {
    for_each_point(sheet, [&](const std::array<double, 3>& t, const Surface_location& location,
                              double weight) {
      add_sample(t, m_octree->surface().normal(location.face), weight, moments);
    });
  }

  const Octree_3* m_octree;
  bool m_is_point_set;
};

/// \ingroup PkgRestrictedLaplacian3Operators
/// Integration over the surface by samples that are uniformly distributed by area, each of weight
/// area / number of samples (paper, section 4.3). The error of an integral falls with the square
/// root of the number of samples, with `Sampling::stratified` nearly with the number itself.
/// Elements that no sample meets have zero rows.
///
/// \cgalModels `SurfaceIntegration_3`
class Monte_carlo {
public:
  /// The space must outlive this object.
  Monte_carlo(const Spline_space_3& space, std::size_t number_of_samples, std::uint64_t seed,
              Sampling sampling = Sampling::independent)
    : Monte_carlo(space, sample_surface(space.surface(), number_of_samples, seed, sampling)) {}

  /// The same with samples that the caller has drawn, uniformly by area.
  /// \param space must outlive this object
  /// \param samples at least one
  /// \throws Location_error a sample is not on the surface
  Monte_carlo(const Spline_space_3& space, const std::vector<Surface_location>& samples)
    : m_octree(&space.octree()) {
    const int depth = m_octree->depth();
    const double h = m_octree->cell_width(depth);
    m_weight = m_octree->surface().area() / static_cast<double>(samples.size()) / (h * h);
    const std::size_t number_of_sheets = m_octree->number_of_sheets(depth);

    std::vector<std::size_t> sheet_of_sample(samples.size());
    std::vector<std::array<double, 3>> positions(samples.size());
    internal::parallel_for(space.options().is_parallel, 0, samples.size(), 1 << 12,
                           [&](std::size_t begin, std::size_t end) {
                             for(std::size_t k = begin; k < end; ++k) {
                               std::tie(sheet_of_sample[k], positions[k]) = space.locate(
                                   depth, m_octree->surface().surface_point(samples[k]).point,
                                   samples[k].face);
                               if(sheet_of_sample[k] == number_of_sheets)
                                 throw Location_error("a sample is not on the surface");
                             }
                           });
    // counting sort by sheet
    m_first.assign(number_of_sheets + 1, 0);
    for(std::size_t sheet : sheet_of_sample)
      ++m_first[sheet + 1];
    for(std::size_t i = 0; i < number_of_sheets; ++i)
      m_first[i + 1] += m_first[i];
    m_samples.resize(samples.size());
    std::vector<std::size_t> next(m_first.begin(), m_first.end() - 1);
    for(std::size_t k = 0; k < samples.size(); ++k)
      m_samples[next[sheet_of_sample[k]]++] = {positions[k], samples[k]};
  }

  /// adds the moments of a sheet of the finest level
  void add_moments(std::size_t sheet, Cell_moments& moments) const {
    for(std::size_t k = m_first[sheet]; k < m_first[sheet + 1]; ++k)
      add_sample(m_samples[k].position, m_octree->surface().normal(m_samples[k].location.face),
                 m_weight, moments);
  }

  /// as in `Cubature`
  template <class Visitor> void for_each_node(std::size_t sheet, Visitor&& visit) const {
    for(std::size_t k = m_first[sheet]; k < m_first[sheet + 1]; ++k)
      visit(m_samples[k].position, m_samples[k].location, m_weight);
  }

private:
  struct Sample {
    std::array<double, 3> position;
    Surface_location location;
  };

  const Octree_3* m_octree;
  double m_weight;
  std::vector<std::size_t> m_first;
  std::vector<Sample> m_samples;
};

/// \ingroup PkgRestrictedLaplacian3Operators
/// Integration over the surface with a weight: \f$\int w f\f$ in place of \f$\int f\f$, by the
/// nodes of another integration. The mass matrix becomes \f$\int w\, b_i b_j\f$. With `Cubature`
/// it is exact up to rounding if \f$w\f$ is constant on each triangle; a linear \f$w\f$ makes the
/// integrand one degree higher than the rule.
///
/// \cgalModels `SurfaceIntegration_3`
template <class SurfaceIntegration, class Weight> class Weighted_integration {
public:
  /// \param weight a function object that takes a `const Surface_point&` and returns a number
  /// \param integration,space must outlive this object
  Weighted_integration(const Spline_space_3& space, const SurfaceIntegration& integration,
                       Weight weight)
    : m_surface(&space.surface()), m_integration(&integration), m_weight(std::move(weight)) {}

  /// \throws Parameter_error if a weight is negative or not finite
  void add_moments(std::size_t sheet, Cell_moments& moments) const {
    for_each_node(sheet, [&](const std::array<double, 3>& t, const Surface_location& location,
                             double weight) {
      add_sample(t, m_surface->normal(location.face), weight, moments);
    });
  }

  /// as in `Cubature`
  template <class Visitor> void for_each_node(std::size_t sheet, Visitor&& visit) const {
    m_integration->for_each_node(sheet, [&](const std::array<double, 3>& t,
                                            const Surface_location& location, double weight) {
      const double factor = static_cast<double>(m_weight(m_surface->surface_point(location)));
      if(!(factor >= 0 && std::isfinite(factor)))
        throw Parameter_error("alpha",
                              "is negative or not finite in face " + std::to_string(location.face));
      visit(t, location, weight * factor);
    });
  }

private:
  const Triangulated_surface_3* m_surface;
  const SurfaceIntegration* m_integration;
  Weight m_weight;
};

namespace internal {

/// adds the moments of a sheet of the finest level, by any model of `SurfaceIntegration_3`
template <class SurfaceIntegration>
void add_sheet_moments(const SurfaceIntegration& integration, std::size_t sheet,
                       Sheet_moments& moments) {
  Cell_moments sum = moments.cell_moments();
  integration.add_moments(sheet, sum);
  moments = Sheet_moments(sum);
}

inline void add_sheet_moments(const Cubature& cubature, std::size_t sheet, Sheet_moments& moments) {
  cubature.add_moments(sheet, moments);
}

/// Nodes for an integrand of the given degree on each triangle, by any model of
/// `SurfaceIntegration_3`. All but `Cubature` have the same for all degrees.
template <class SurfaceIntegration, class Visitor>
void for_each_sheet_node(const SurfaceIntegration& integration, std::size_t sheet, int /*degree*/,
                         Visitor&& visit) {
  integration.for_each_node(sheet, visit);
}

template <class Visitor>
void for_each_sheet_node(const Cubature& cubature, std::size_t sheet, int degree, Visitor&& visit) {
  cubature.for_each_node(sheet, degree, visit);
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_SURFACE_INTEGRATION_H

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PATCHES_SMOOTH_VERTEX_DATA_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PATCHES_SMOOTH_VERTEX_DATA_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/patches/Smooth_geometry.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>
#include <CGAL/Restricted_laplacian_3/surface/surface_functions.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Options
/// What values at vertices mean between them: the function that is linear in each triangle, or a
/// smooth one, see `Cubic_surface_function`.
enum class Vertex_data { linear, smooth };

namespace internal {

/// What the cubics of `Cubic_surface_function` have more than linear functions: seven Bezier
/// coefficients of each face in the order of `Surface_patches::Controls`, all components of one
/// before the next.
/// \param values of each vertex, all components of one before the next
std::vector<double> cubic_deviations(const Triangulated_surface_3& surface,
                                     const Smooth_geometry& geometry,
                                     const std::vector<double>& values, std::size_t components);

/// their weights at a point
inline std::array<double, 7> cubic_weights(const std::array<double, 3>& barycentric) {
  const double x = barycentric[0], y = barycentric[1], z = barycentric[2];
  return {3 * x * x * y, 3 * x * y * y, 3 * y * y * z, 3 * y * z * z,
          3 * z * z * x, 3 * z * x * x, 6 * x * y * z};
}

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Functions
/// A function object on `Surface_point` that interpolates values at the vertices smoothly: by a
/// cubic polynomial in the barycentric coordinates of each triangle, continuous over the edges. For
/// values of a smooth function its error is of third order in the length of the edges, that of
/// `Linear_surface_function` of second order; and the integrals are far closer, since linear
/// interpolation errs to the same side wherever the function is convex.
///
/// *Gradients.* Each vertex has one for each sector of faces between two creases, see
/// `curved_surface()`: that of the cubic in the coordinates of the tangent plane that fits the
/// differences to the values at the vertices of two rings around it best, within the sector, with
/// weights \f$1/d^2\f$ at distance \f$d\f$; of a quadratic or a linear function where the
/// neighbors determine no more. The coefficients of an edge are those of the Hermite cubic on it
/// (of the mean of two gradients along a crease), that in the middle is the one that reproduces
/// quadratics.
///
/// *What holds.* Values at vertices are interpolated. Constants are reproduced, and on a plane
/// surface linear functions. An error of at most \f$\varepsilon\f$ in the values changes the
/// function by at most \f$6.6\, \varepsilon\f$, since it is linear along an edge at its end where a
/// gradient would multiply errors too much, as at needles; where triangles are not that bad, by
/// less than \f$3\, \varepsilon\f$. Noise that is independent at each vertex becomes no larger, in
/// the root mean square over the surface.
///
/// Where a gradient takes a value that is NaN, the function is linear.
///
/// Takes \f$O(F \log F)\f$ time for \f$F\f$ faces.
///
/// \tparam T `double`, or a vector or matrix of Eigen of a fixed size
///
/// \cgalModels `SurfaceFunction_3`
template <class T> class Cubic_surface_function {
public:
  /// \param surface a surface of triangles, flat or smooth
  /// \param values for each vertex
  /// \param geometry creases and normals, as for `curved_surface()`; a projection has no effect
  /// \throws Input_error the surface is a point set
  /// \throws Parameter_error what `curved_surface()` refuses
  /// \pre there is a value for each vertex
  Cubic_surface_function(const Triangulated_surface_3& surface, std::vector<T> values,
                         const Smooth_geometry& geometry = Smooth_geometry())
    : Cubic_surface_function(std::move(values)) {
    CGAL_precondition(m_values.size() == surface.number_of_vertices());
    std::vector<double> numbers;
    for(const T& value : m_values)
      numbers.insert(numbers.end(), data(value), data(value) + size);
    const std::vector<double> deviations =
        internal::cubic_deviations(surface, geometry, numbers, size);
    m_deviations.resize(deviations.size() / size);
    for(std::size_t i = 0; i < m_deviations.size(); ++i)
      std::copy_n(deviations.begin() + static_cast<std::ptrdiff_t>(size * i), size,
                  data(m_deviations[i]));
  }

  /// The function that is linear in each triangle, of this type.
  /// \param values for each vertex
  explicit Cubic_surface_function(std::vector<T> values) : m_values(std::move(values)) {}

  /// the value at a location
  T operator()(const Surface_point& p) const {
    CGAL_precondition((std::max)({p.vertices[0], p.vertices[1], p.vertices[2]}) < m_values.size());
    T sum = internal::barycentric_mean(m_values[p.vertices[0]], m_values[p.vertices[1]],
                                       m_values[p.vertices[2]], p.barycentric);
    if(m_deviations.empty())
      return sum;
    CGAL_precondition(7 * p.face + 7 <= m_deviations.size());
    const T* const c = m_deviations.data() + 7 * p.face;
    const std::array<double, 7> weights = internal::cubic_weights(p.barycentric);
    for(int i = 0; i < 7; ++i)
      sum += c[i] * weights[i];
    return sum;
  }
  /// cubic in each triangle, or linear
  int degree() const { return m_deviations.empty() ? 1 : 3; }

private:
  static constexpr std::size_t number_of_components() {
    if constexpr(std::is_arithmetic_v<T>)
      return 1;
    else
      return static_cast<std::size_t>(T::SizeAtCompileTime);
  }
  static constexpr std::size_t size = number_of_components();

  template <class Value> static auto data(Value& value) {
    if constexpr(std::is_arithmetic_v<T>)
      return &value;
    else
      return value.data();
  }

  std::vector<T> m_values;
  std::vector<T> m_deviations; // seven of each face, or none
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/patches/smooth_vertex_data_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PATCHES_SMOOTH_VERTEX_DATA_H

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_SURFACE_MATERIAL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_SURFACE_MATERIAL_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/integration/Integration_nodes.h>
#include <CGAL/Restricted_laplacian_3/integration/Surface_integration.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_function_view.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>
#include <CGAL/Restricted_laplacian_3/surface/surface_functions.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Restricted_laplacian_3 {
/// \ingroup PkgRestrictedLaplacian3Operators
/// The tensor \f$\sum_k w_k\, d_k d_k^T / \lvert d_k \rvert^2\f$: a diffusion that has the factors
/// \f$w_k > 0\f$ along two directions, which are orthogonal to each other and tangential, as
/// principal directions are.
/// \param directions \f$d_1, d_2\f$, of any length but 0
/// \param weights \f$w_1, w_2\f$
Symmetric_tensor_3 directional_tensor(const std::array<Vector_3, 2>& directions,
                                      const std::array<double, 2>& weights);

namespace internal {

/// A function on a surface that is owned, and shared by copies.
class Owned_function {
public:
  template <class Function>
  explicit Owned_function(std::shared_ptr<const Function> f) : m_owner(f), m_view(*f) {}

  const Surface_function_view& view() const { return m_view; }

private:
  std::shared_ptr<const void> m_owner;
  Surface_function_view m_view;
};

/// the nine components of a 3 x 3 matrix
template <class Matrix> Eigen::Matrix<double, 9, 1> matrix_components(const Matrix& d) {
  Eigen::Matrix<double, 9, 1> result;
  for(int i = 0; i < 9; ++i)
    result[i] = static_cast<double>(d(i / 3, i % 3));
  return result;
}

/// a function whose values are 3 x 3 matrices of Eigen, as one whose values are vectors
template <class Function> struct Matrix_coefficient {
  Function function;

  Eigen::Matrix<double, 9, 1> operator()(const Surface_point& p) const {
    return matrix_components(function(p));
  }
  int degree() const { return degree_on_triangles(function); }
};

/// whether a type is a 3 x 3 matrix of Eigen
template <class T, class = void> struct Is_matrix : std::false_type {};
template <class T>
struct Is_matrix<T, std::enable_if_t<std::is_base_of_v<Eigen::MatrixBase<T>, T>>>
  : std::bool_constant<T::RowsAtCompileTime == 3 && T::ColsAtCompileTime == 3> {};

/// what a caller gives as a coefficient
template <class Function> Owned_function owned_coefficient(Function f) {
  if constexpr(std::is_arithmetic_v<Function>)
    return Owned_function(std::make_shared<const Constant_function>(function_or_number(f)));
  else if constexpr(is_block_function<Function>)
    return Owned_function(std::make_shared<const Function>(std::move(f)));
  else if constexpr(Is_matrix<std::decay_t<
                        std::invoke_result_t<const Function&, const Surface_point&>>>::value)
    return Owned_function(std::make_shared<const Matrix_coefficient<Function>>(
        Matrix_coefficient<Function>{std::move(f)}));
  else
    return Owned_function(std::make_shared<const Function>(std::move(f)));
}

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Operators
/// The coefficients of the operator \f$u \mapsto -\mathrm{div}(D\, \nabla u) / \rho\f$ on a
/// surface: a diffusion \f$D\f$, and a density \f$\rho\f$. Both are 1 unless they are set, and the
/// operator is minus the Laplace-Beltrami operator.
///
/// The stiffness matrix of a space with a material, see `Spline_space_3::with_material()`, is
/// \f$\int \nabla b_i^T D\, \nabla b_j\f$, its mass matrix \f$\int \rho\, b_i b_j\f$, and loads are
/// \f$\int \rho f b_i\f$. So a Poisson problem is \f$\mathrm{div}(D\, \nabla u) = \rho f\f$, a
/// screened one \f$\alpha \rho u - \mathrm{div}(D\, \nabla u) = \rho f\f$, and eigenfunctions,
/// \f$-\mathrm{div}(D\, \nabla \phi) = \lambda \rho \phi\f$, are orthonormal in the density.
///
/// Functions are copied, and shared by copies of this object.
class Surface_material {
public:
  /// \f$D = 1\f$, \f$\rho = 1\f$
  Surface_material() = default;

  /// sets the diffusion
  /// \param diffusion a positive number; or a function object that takes a `const Surface_point&`
  /// and returns a positive number, a `Symmetric_tensor_3`, or a symmetric `Eigen::Matrix3d`. Of a
  /// tensor the tangential part counts, \f$P D P\f$ with \f$P = I - n n^T\f$, which has to be
  /// positive definite on the tangent plane.
  /// \throws Parameter_error its values have another number of components
  template <class Diffusion> void set_diffusion(Diffusion diffusion) {
    m_diffusion = internal::owned_coefficient(std::move(diffusion));
    check_components();
  }
  /// sets the density
  /// \param density a positive number; or a function object that takes a `const Surface_point&` and
  /// returns one
  /// \throws Parameter_error its values are no numbers
  template <class Density> void set_density(Density density) {
    m_density = internal::owned_coefficient(std::move(density));
    check_components();
  }

  /// whether both are 1, because they were not set
  bool is_trivial() const { return !m_diffusion && !m_density; }
  /// whether the density was set
  bool has_density() const { return m_density.has_value(); }
  /// whether both are constant on each face, as numbers and a `Face_function` are
  bool is_constant_on_faces() const {
    return (!m_diffusion || m_diffusion->view().degree() == 0) &&
           (!m_density || m_density->view().degree() == 0);
  }

  /// \cond
  /// \f$P D P\f$ at points
  /// \throws Parameter_error if one is not positive definite on the tangent plane; names the face
  void diffusion_at(const Surface_point* points, std::size_t number,
                    Symmetric_tensor_3* tensors) const;
  /// \f$\rho\f$ at points
  /// \throws Parameter_error if one is not positive and finite; names the face
  void density_at(const Surface_point* points, std::size_t number, double* densities) const;
  /// \endcond

private:
  void check_components() const;

  std::optional<internal::Owned_function> m_diffusion, m_density;
};

namespace internal {

/// Integration over a surface of a material: areas are multiplied by the density, and metrics are
/// \f$P D P / \rho\f$.
class Material_integration {
public:
  Material_integration(const Surface_integration& integration, const Surface_material& material)
    : m_integration(integration), m_material(material) {}

  void add_nodes(std::size_t sheet, int degree, Integration_nodes& nodes) const;

protected:
  const Surface_integration& integration() const { return m_integration; }
  const Surface_material& material() const { return m_material; }

private:
  Surface_integration m_integration;
  Surface_material m_material;
};

/// The same of a material that is constant on the faces of a flat surface, by the moments of
/// another integration.
class Face_material_integration : public Material_integration {
public:
  /// \param surface must outlive this object
  Face_material_integration(const Surface_integration& integration,
                            const Surface_material& material, const Triangulated_surface_3& surface)
    : Material_integration(integration, material), m_surface(&surface) {}

  void add_moments(std::size_t sheet, const Factors_of_face* factors,
                   Sheet_integrals& integrals) const;

private:
  const Triangulated_surface_3* m_surface;
};

/// integration over the surface of an octree with a material
Surface_integration integration_with_material(const Surface_integration& integration,
                                              const Surface_material& material,
                                              const Triangulated_surface_3& surface);

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/integration/Surface_material_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_SURFACE_MATERIAL_H

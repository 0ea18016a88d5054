// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_CURVATURE_FIELD_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_CURVATURE_FIELD_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/integration/Integration_nodes.h>
#include <CGAL/Restricted_laplacian_3/problems/Function_fitter.h>
#include <CGAL/Restricted_laplacian_3/problems/stabilization.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_functions_3.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_function_view.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>
#include <CGAL/Restricted_laplacian_3/surface/surface_functions.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Fits
/// How `estimate_curvature()` works.
enum class Curvature_method {
  /// The derivative of a fit of normals that are given at the vertices and interpolated: the most
  /// accurate on smooth surfaces.
  normals,
  /// The same with the normals of the faces, which are constant on each face.
  face_normals,
  /// The Laplacian of the coordinates, in the weak form: the mean curvature only. Its integral over
  /// a region is that of the triangulation, whose curvature lives on the edges.
  coordinates
};

/// \ingroup PkgRestrictedLaplacian3Fits
/// The curvature of a surface at a point.
///
/// *Sign.* \f$\kappa\f$ is the derivative of the unit normal \f$n\f$ along a unit tangent vector
/// \f$t\f$, \f$\kappa = \langle \nabla_t n, t \rangle\f$: a sphere of radius \f$r\f$ has the
/// curvatures \f$+1 / r\f$ if its normals point outward, and \f$-1 / r\f$ if they point inward. The
/// Gaussian curvature does not depend on the orientation.
struct Surface_curvature {
  /// \f$H = (\kappa_1 + \kappa_2) / 2\f$, in units of 1 / length
  double mean = std::numeric_limits<double>::quiet_NaN();
  /// \f$K = \kappa_1 \kappa_2\f$, in units of 1 / area; NaN with `Curvature_method::coordinates`
  double gaussian = std::numeric_limits<double>::quiet_NaN();
  /// \f$\kappa_1 \ge \kappa_2\f$; NaN with `Curvature_method::coordinates`
  std::array<double, 2> principal_values = {std::numeric_limits<double>::quiet_NaN(),
                                            std::numeric_limits<double>::quiet_NaN()};
  /// unit tangent vectors, orthogonal to each other and to `normal`, each with either sign; the
  /// zero vectors with `Curvature_method::coordinates`
  std::array<Vector_3, 2> principal_directions = {Vector_3(0, 0, 0), Vector_3(0, 0, 0)};
  /// the fitted unit normal
  Vector_3 normal = Vector_3(0, 0, 0);
};

/// \ingroup PkgRestrictedLaplacian3Fits
/// The curvature of a surface as a function on it, see `estimate_curvature()`.
class Curvature_field {
public:
  /// \param space is copied, which costs nothing
  /// \param fit of normals, three components; or of normals and Laplacians of the coordinates, six
  Curvature_field(const Spline_space_3& space, const Function_fit& fit);

  /// the fitted functions: three components of the normal, not of unit length; with
  /// `Curvature_method::coordinates` followed by three of the Laplacian of the coordinates,
  /// \f$-2 H n\f$
  const Spline_functions_3& functions() const { return m_functions; }
  /// of the fit
  const Fit_report& report() const { return m_report; }

  /// the curvature at a location
  /// \throws Location_error if there is no such face, or if the location is not on the surface
  Surface_curvature operator()(const Surface_location& location) const {
    return at_locations(std::array<Surface_location, 1>{location}).front();
  }

  /// the curvatures at locations
  /// \param locations a range of `Surface_location`
  /// \throws Location_error if there is no such face, or if a location is not on the surface
  template <class LocationRange>
  std::vector<Surface_curvature> at_locations(const LocationRange& locations) const {
    return curvatures(m_functions.jets_at_locations(locations));
  }

  /// The curvatures at all vertices, in the order of `vertices(tm)`; NaN at vertices that have no
  /// face of positive area.
  std::vector<Surface_curvature> at_vertices() const;

private:
  std::vector<Surface_curvature> curvatures(const Spline_jets& jets) const;

  Spline_functions_3 m_functions;
  Fit_report m_report;
};

/// \ingroup PkgRestrictedLaplacian3Options
/// The named parameters of `estimate_curvature()`.
struct Curvature_options {
  /// what is fitted
  Curvature_method method = Curvature_method::normals;
  /// in units of length^2; without a value the squared width of the finest cells, by which waves
  /// about as long as cells are smoothed away, and with them most of the noise of a triangulation;
  /// 0 for points, for `Curvature_method::coordinates`, and where the surface has a boundary, where
  /// the natural condition would bend the normals
  std::optional<double> smoothing;
  /// without a value one with smoothing, and none without
  std::optional<int> refinements;
  /// factor \f$c\f$ of the stabilization; without a value `default_curvature_stabilization`
  std::optional<double> stabilization;
  /// see `Function_fit_options`; without a value 3e-4
  std::optional<double> energy_tolerance;
  /// of the linear systems, see `Function_fit_options`
  Poisson_solver_options solver;
  /// is told which part of the work is done, from 0 to 1; if it returns `false`, the computation
  /// ends with an exception
  std::function<bool(double)> progress;

  /// the defaults
  Curvature_options() = default;
  /// what is among named parameters, and the defaults else
  template <class NamedParameters, internal::Require_named_parameters<NamedParameters> = 0>
  Curvature_options(const NamedParameters& np) : solver(np) {
    internal::read_parameter(np, internal_np::method, method);
    internal::read_parameter(np, internal_np::smoothing, smoothing);
    internal::read_parameter(np, internal_np::refinements, refinements);
    internal::read_parameter(np, internal_np::stabilization, stabilization);
    internal::read_parameter(np, internal_np::energy_tolerance, energy_tolerance);
    internal::read_parameter(np, internal_np::progress, progress);
    solver.energy_tolerance = 0; // relative to the solution
  }
};

/// \ingroup PkgRestrictedLaplacian3Problems
/// Estimates the curvature of the surface of a space.
/// \param space the space in which normals or coordinates are fitted
/// \param options named parameters, or the options themselves:
/// \cgalNamedParamsBegin
///   \named_method
///   \named_of_curvature
///   \named_concurrency_tag
/// \cgalNamedParamsEnd
/// \throws Parameter_error if a parameter is outside its domain
/// \throws Canceled if `progress` returned `false`
///
/// On points, whose boundary is not known, `Curvature_method::coordinates` takes the surface as
/// closed.
Curvature_field estimate_curvature(const Spline_space_3& space,
                                   const Curvature_options& options = {});

/// \ingroup PkgRestrictedLaplacian3Problems
/// Estimates the curvature of a surface from a field of normals (paper, section 5.3): the field is
/// fitted by splines, see `Function_fitter`; the derivative of the fit \f$u\f$ is projected to the
/// plane that is orthogonal to \f$u\f$, divided by \f$\lvert u \rvert\f$, and symmetrized.
/// \param space the space in which the normals are fitted
/// \param normals a function object that takes a `const Surface_point&` and returns a `Vector_3` of
/// about unit length
/// \param options named parameters, or the options themselves:
/// \cgalNamedParamsBegin
///   \named_of_curvature
///   \named_concurrency_tag
/// \cgalNamedParamsEnd
/// \throws Parameter_error if a parameter is outside its domain, or if a normal is not finite
/// \throws Canceled if `progress` returned `false`
Curvature_field estimate_curvature(const Spline_space_3& space,
                                   const Surface_function_view& normals,
                                   const Curvature_options& options = {});

/// \ingroup PkgRestrictedLaplacian3Problems
/// A diffusion that follows the curvature, for anisotropic operators \cgalCite{ARAC14}: with
/// principal directions \f$t_1, t_2\f$ whose curvatures have
/// \f$\lvert \kappa_1 \rvert \ge \lvert \kappa_2 \rvert\f$
///
/// \f[ D = e^{-a_1 \lvert \kappa_2 \rvert}\, t_1 t_1^T
///        + e^{-a_2 \lvert \kappa_1 \rvert}\, t_2 t_2^T, \f]
/// but with factors not below \f$10^{-4}\f$. On a cylinder of radius \f$r\f$ it is 1 around the
/// axis and \f$e^{-a_2 / r}\f$ along it. It is constant on each face, with the curvature in its
/// middle, and the same whatever the orientation of the surface is.
/// \param curvature by one of the methods that fit normals
/// \param anisotropy \f$a_1, a_2\f$, not negative, in units of length; as a rule the same number
/// twice
/// \return for each face the tensor: what `Surface_material::set_diffusion()` and the named
/// parameter `diffusion` take
/// \throws Parameter_error if a number is negative or not finite
/// \throws Input_error the field is of `Curvature_method::coordinates`, which knows no directions
Face_function<Symmetric_tensor_3> curvature_diffusion(const Curvature_field& curvature,
                                                      const std::array<double, 2>& anisotropy);

/// \ingroup PkgRestrictedLaplacian3Problems
/// The metric of the surface \f$(x, w\, n)\f$ with its normals,
/// \f$g = I + w^2\, \mathrm{I\!I}^2\f$: along a principal direction lengths are
/// \f$\sqrt{1 + w^2 \kappa_i^2}\f$ times what they are on the surface \cgalCite{CK11}. So creases
/// and ridges are wide in it, and survive smoothing. It is constant on each face, with the
/// curvature in its middle.
/// \param curvature by one of the methods that fit normals
/// \param weight \f$w\f$, not negative, a length
/// \return \f$D = \sqrt{\det g}\, g^{-1}\f$ and \f$\rho = \sqrt{\det g}\f$, for
/// `Spline_space_3::with_material()`
/// \throws Parameter_error if the weight is negative or not finite
/// \throws Input_error the field is of `Curvature_method::coordinates`, which knows no directions
Surface_material normal_metric(const Curvature_field& curvature, double weight);

namespace internal {

/// Estimates the curvature in deeper and deeper spaces.
/// \param space the first one, and then that of the curvature
/// \param normals in place of those of the surface; may be null
/// \param accuracy the estimated error of the mean curvature that ends the search, or the memory of
/// the spaces does
Curvature_field estimate_curvature_to_accuracy(Spline_space_3& space,
                                               const Surface_function_view* normals,
                                               const Curvature_options& options, double accuracy);

/// Vertex normals interpolated linearly and renormalized: where they cancel, that of the face.
class Interpolated_normals {
public:
  explicit Interpolated_normals(std::vector<Vector_3> normals) : m_normals(std::move(normals)) {}

  Vector_3 operator()(const Surface_point& p) const {
    Vector_3 sum(0, 0, 0);
    for(int i = 0; i < 3; ++i)
      sum += p.barycentric[i] * m_normals[p.vertices[i]];
    const double length = std::sqrt(sum.squared_length());
    return length > smallest_length ? sum / length : p.normal;
  }
  /// where the surface is smooth
  int degree() const { return 2; }

private:
  /// below, the direction is that of rounding errors
  static constexpr double smallest_length = 1e-8;
  std::vector<Vector_3> m_normals;
};

} // namespace internal

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/problems/Curvature_field_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_CURVATURE_FIELD_H

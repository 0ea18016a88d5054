// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATE_GRADIENT_FIELD_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATE_GRADIENT_FIELD_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/input/shared/function_on_surface.h>
#include <CGAL/Restricted_laplacian_3/input/vertex_functions.h>
#include <CGAL/Restricted_laplacian_3/problems/integrate_gradients.h>
#include <CGAL/Restricted_laplacian_3/problems/shared/space_of.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_functions_3.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/function_components.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Core>

#include <boost/property_map/property_map.hpp>

#include <type_traits>

namespace CGAL {
namespace Restricted_laplacian_3 {

namespace internal {

/// what is not given, and numbers, remain as they are
template <class Function, class OnSurface>
auto optional_function(const Function& f, OnSurface&& on_surface) {
  if constexpr(std::is_same_v<Function, internal_np::Param_not_found> ||
               std::is_arithmetic_v<Function>)
    return f;
  else
    return on_surface(f);
}

/// \param target,weight function objects on `Surface_point`, a number, or `Param_not_found`; have
/// to outlive the result
template <class Target, class Weight, class NamedParameters>
Gradient_options gradient_options(const Target& target, const Weight& weight,
                                  const NamedParameters& np) {
  Gradient_options options;
  Gradient_screening& screening = options.screening;
  if constexpr(!std::is_same_v<Target, internal_np::Param_not_found>)
    screening.target = target;
  if constexpr(std::is_arithmetic_v<Weight>)
    screening.weight = static_cast<double>(weight);
  else if constexpr(!std::is_same_v<Weight, internal_np::Param_not_found>)
    screening.weight_function = weight;
  if constexpr(is_given_v<NamedParameters, internal_np::mean_t>) {
    const auto mean = parameters::get_parameter(np, internal_np::mean);
    screening.mean = Function_components<std::decay_t<decltype(mean)>>::read(mean);
  }
  read_parameter(np, internal_np::stabilization, options.stabilization);
  options.solver = Poisson_solver_options(np);
  read_parameter(np, internal_np::progress, options.progress);
  return options;
}

template <class Surface, class Field, class VertexMap, class NamedParameters>
Gradient_report integrate_gradients_on_surface(const Surface& surface, const Field& v, VertexMap u,
                                               const NamedParameters& np) {
  using Components = Function_components<typename boost::property_traits<VertexMap>::value_type>;
  CGAL::Real_timer timer;
  timer.start();
  const Progress progress = progress_of(np);
  progress(0);
  const auto source = surface_source(surface);
  Spline_space_3 space = first_space_of(surface, np);
  const double space_seconds = timer.time();
  const Vertex_interpolation interpolation = vertex_interpolation(source, space.surface(), np);
  const auto field = vector_field_on_surface(source, v, interpolation);
  static_assert(Components::number == Channels_of<std::decay_t<decltype(field)>>::number,
                "u needs as many components as v has channels");
  const auto target =
      optional_function(parameters::get_parameter(np, internal_np::target), [&](const auto& f) {
        return components_on_surface(source, f, interpolation);
      });
  const auto weight =
      optional_function(parameters::get_parameter(np, internal_np::alpha), [&](const auto& f) {
        return numbers_on_surface(source, f, interpolation);
      });
  const Gradient_options options = gradient_options(target, weight, np);
  bool with_details = false;
  read_parameter(np, internal_np::details, with_details);
  const double end_of_splines = with_details ? 0.8 : 1;
  const Progress of_splines = progress.part(space_share, end_of_splines);
  Gradient_solution solution;
  if constexpr(is_given_v<NamedParameters, internal_np::accuracy_t>)
    solution = integrate_gradients_to_accuracy(
        space, field, options, parameters::get_parameter(np, internal_np::accuracy), of_splines);
  else
    solution = integrate_gradients(space, field, options, of_splines);
  Eigen::MatrixXd values =
      Spline_functions_3(space, solution.fit.coefficients).values_at_vertices();
  if(with_details)
    add_details(space, field, options.screening, tolerance_of(options.solver),
                options.solver.maximum_iterations, solution, values);
  progress(1);
  put_rows(source, values, u);
  solution.fit.space_seconds += space_seconds;
  return static_cast<const Gradient_report&>(solution.fit);
}

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Problems
/// Integrates a vector field on a surface: finds the functions \f$u_k\f$ of a spline space whose
/// gradients are closest to the channels \f$v_k\f$ of a tangent vector field (paper, section 5.2,
/// equation 6).
/// \f[ \int_{\mathcal M} \lvert \nabla u_k - v_k \rvert^2
///     + \int_{\mathcal M} \alpha\, (u_k - g_k)^2 \to \min, \qquad
///     (S + M_\alpha)\, \eta_{\cdot k} = \gamma, \quad
///     \gamma_i = \int_{\mathcal M} \langle v_k, \nabla b_i \rangle
///              + \int_{\mathcal M} \alpha\, g_k\, b_i, \f]
/// where \f$(M_\alpha)_{ij} = \int \alpha\, b_i b_j\f$. All channels share the matrix, one pass
/// over the surface and each pass of the solver. On boundaries the natural condition holds: the
/// part of
/// \f$\nabla u - v\f$ along the conormal is 0.
///
/// *Means.* Gradients do not determine constants. Without a weight \f$\alpha\f$, the mean of
/// \f$u\f$ on each connected component of the surface is that of the target \f$g\f$, if there is
/// one, and `mean` else. With a weight, the weighted mean of \f$u\f$ on a component is that of
/// \f$g\f$, which is imposed separately from the solution of the system, however small the weight
/// is. On components where the weight vanishes everywhere, the mean is `mean`, if it is given, and
/// else the weighted mean of the targets of all other components. (Components are those of the
/// splines: not split, if `split` is `false`, where two come within three cells of each other.)
///
/// *Details.* Splines do not resolve what is smaller than a cell. With `details`, their values at
/// the vertices are the first guess for the same problem with the functions that are linear in each
/// triangle, whose matrix \f$S\f$ is that of cotangents. What they leave is of short waves, so a
/// few steps of conjugate gradients with an incomplete Cholesky factor suffice. The splines, with
/// their multigrid, are then the auxiliary space of a solver for the cotangent system. See J. Xu,
/// *The auxiliary space method and optimal multigrid preconditioning techniques for unstructured
/// grids*, Computing 56 (1996). The result depends on the triangulation, as that of the cotangent
/// Laplacian does.
///
/// \tparam Surface a model of `RestrictedSurface_3`
/// \param surface a mesh, a `soup()`, oriented points, or a `Spline_space_3`
/// \param v a function object that takes a `const Surface_point&` and returns a 3D vector of \cgal
/// (one channel), a `std::array` of such vectors, or an `Eigen::Matrix<double, 3, K>`, whose
/// columns are the channels; or a model of `ReadablePropertyMap` with such values. Its keys are
/// vertices: the field is linear in each triangle, or what `vertex_data` says, and continuous up to
/// the projection to the tangent planes; halfedges of a mesh: it is linear in each triangle, with
/// the value of a halfedge at its target, in its face; or faces of a mesh: it is constant in each.
/// \param u a model of `WritablePropertyMap` with vertices as keys, and values as `target` has,
/// receives the values; NaN at vertices without a face of positive area
/// \param np optional named parameters:
/// \cgalNamedParamsBegin
///   \named_of_space
///   \named_accuracy
///   \named_of_surface
///   \named_vertex_data
///   \named_of_gradients
///   \named_details{`false`}
/// \cgalNamedParamsEnd
/// \return whether the solver converged, iterations, residuals, times
/// \throws Input_error one of its derived classes names the face, vertex or parameter
/// \throws Canceled if `progress` returned `false`
template <class Surface, class VectorField, class VertexMap,
          class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0,
          internal::Require_property_map<VertexMap> = 0>
Gradient_report integrate_gradient_field(const Surface& surface, const VectorField& v, VertexMap u,
                                         const NamedParameters& np = parameters::default_values()) {
  return internal::integrate_gradients_on_surface(surface, v, u, np);
}

/// \ingroup PkgRestrictedLaplacian3Problems
/// Integrates a vector field in a space.
/// \param space the space that the solution is in
/// \param v a function object that takes a `const Surface_point&` and returns a 3D vector of \cgal
/// (one channel), a `std::array` of such vectors, or an `Eigen::Matrix<double, 3, K>`, whose
/// columns are the channels; for example a `Face_function`, a `Corner_vector_field`, or the result
/// of `vertex_gradients()`. Only the part tangential to the face counts. Integrated as in
/// `assemble_gradient_loads()`: where the metrics \f$A\f$ of the integration are others than that
/// of the surface, it is \f$\int (\nabla u - v)^T A\, (\nabla u - v)\f$ that becomes small.
/// \param np optional named parameters:
/// \cgalNamedParamsBegin
///   \named_of_gradients
///   \named_concurrency_tag
/// \cgalNamedParamsEnd
/// \return the coefficients, whether the solver converged, iterations, residuals, times
/// \throws Parameter_error if a parameter is outside its domain, or if a value of `v`, of the
/// target or of the weight cannot be used; names the face
/// \throws Canceled if `progress` returned `false`
///
/// In place of property maps, `target` and `alpha` are function objects here.
///
/// Takes time and memory proportional to the number of triangles (or samples) plus the number of
/// elements, times the number of iterations.
template <class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0>
Gradient_fit integrate_gradient_field(const Spline_space_3& space, const Vector_field_view& v,
                                      const NamedParameters& np = parameters::default_values()) {
  const auto target = parameters::get_parameter(np, internal_np::target);
  const auto weight = parameters::get_parameter(np, internal_np::alpha);
  return integrate_gradient_field(space, v, internal::gradient_options(target, weight, np));
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATE_GRADIENT_FIELD_H

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVE_POISSON_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVE_POISSON_H

#include <CGAL/Restricted_laplacian_3/assembly/Dirichlet_boundary.h>
#include <CGAL/Restricted_laplacian_3/assembly/Point_constraints.h>
#include <CGAL/Restricted_laplacian_3/foundation/parameters.h>
#include <CGAL/Restricted_laplacian_3/problems/Surface_source.h>
#include <CGAL/Restricted_laplacian_3/problems/make_poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/solvers/Poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_function_3.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Core>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

namespace internal {

/// the constraints at the vertices that `vertex_is_constrained_map` marks
template <class Source, class NamedParameters>
Point_constraints vertex_constraints(const Source& source, const Spline_space_3& space,
                                     const NamedParameters& np) {
  constexpr double default_weight = 1e4;
  const auto is_constrained = parameters::get_parameter(np, internal_np::vertex_is_constrained);
  const auto values = parameters::get_parameter(np, internal_np::constraint_values);
  const double weight = parameters::choose_parameter(
      parameters::get_parameter(np, internal_np::constraint_weight), default_weight);
  const Triangulated_surface_3& surface = space.surface();
  // a location of each vertex
  std::vector<Surface_location> locations(surface.number_of_vertices());
  std::vector<char> is_on_surface(surface.number_of_vertices(), 0);
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
    for(int corner = 0; corner < 3 && !surface.is_degenerate(f); ++corner) {
      const std::uint32_t v = surface.triangle(f)[corner];
      is_on_surface[v] = 1;
      locations[v].face = f;
      locations[v].barycentric.fill(0);
      locations[v].barycentric[corner] = 1;
    }
  Point_constraints constraints(space);
  source.for_each_vertex([&](std::size_t i, const auto& v) {
    if(!value_at(is_constrained, v))
      return;
    if(!is_on_surface[i])
      throw Invalid_vertex_error(i, "is constrained, but has no face of positive area");
    constraints.add(locations[i], static_cast<double>(value_at(values, v)), weight);
  });
  return constraints;
}

template <class Source, class Function, class Alpha, class VertexMap, class NamedParameters>
Solve_report solve_poisson(const Source& source, const Function& f, const Alpha& alpha, VertexMap u,
                           const NamedParameters& np);

/// Prescribed values enter the right-hand side with large factors, and its norm with them: the
/// same relative residual means less.
constexpr double tolerance_with_constraints = 1e-7;

/// refuses a screening weight that is a number and not positive
template <class Alpha> void check_screening_weight(const Alpha& alpha) {
  if constexpr(std::is_arithmetic_v<Alpha>)
    if(!(alpha > 0 && std::isfinite(static_cast<double>(alpha))))
      throw Parameter_error("alpha", "is " + std::to_string(alpha) +
                                         ", but must be a positive, finite number");
}

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Problems
/// Solves the Poisson problem \f$\Delta_{\mathcal M} u = f\f$ on a surface (paper, equation 1), in
/// the form \f$S \eta = -\phi\f$ (the stiffness matrix \f$S\f$ is minus the matrix \f$L\f$ of the
/// paper).
///
/// On a closed surface, and on an open one with the natural boundary condition
/// \f$\partial u / \partial \nu = 0\f$, which holds where no other is given, a solution exists only
/// if \f$f\f$ has mean 0: its mean is subtracted, and the solution has surface mean 0. Both hold on
/// each connected component of the surface (not split into components if `split_elements` is
/// `false`: then two that come within three cells of each other count as one). Components on which
/// values are prescribed are solved as they are.
///
/// \tparam FaceGraph a model of `FaceListGraph` and `VertexListGraph`, all of whose faces are
/// triangles
/// \param tm the surface, a mesh or a range of oriented points
/// \param f a model of `ReadablePropertyMap` with the vertex descriptor as key and a number as
/// value, interpolated linearly; or a function object that takes a `const Surface_point&` and
/// returns a number
/// \param u a model of `WritablePropertyMap` with the vertex descriptor as key and a floating-point
/// number as value, receives the solution; NaN at vertices without a face of positive area
/// \param np optional named parameters: those of `Spline_space_3` and `make_poisson_solver()`, and
/// - `normal_stabilization`: factor \f$c\f$ of `assemble_operators()`; default
///   `default_normal_stabilization()`
/// - `boundary_values`: values on the boundary of an open surface, given as `f` is, see
///   `Dirichlet_boundary`; by default the natural condition holds
/// - `vertex_is_constrained_map`: a model of `ReadablePropertyMap` that maps a vertex descriptor to
///   `true` if the value there is prescribed, see `Point_constraints`; by default none is
/// - `constraint_values`: a model of `ReadablePropertyMap` with these values; required with the
///   former
/// - `constraint_weight`: how strongly they are held; default 1e4
///
/// With prescribed values the default of `relative_tolerance` is 1e-7: they enter the right-hand
/// side with large factors.
/// \return whether the solver converged, iterations, residual, times
/// \throws Input_error one of its derived classes names the face, vertex or parameter
///
/// Takes time and memory proportional to the number of triangles plus the number of elements, times
/// the number of iterations.
template <class FaceGraph, class Function, class VertexMap,
          class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0>
Solve_report solve_poisson(const FaceGraph& tm, const Function& f, VertexMap u,
                           const NamedParameters& np = parameters::default_values()) {
  return internal::solve_poisson(internal::mesh_or_point_source(tm), f, 0, u, np);
}

/// \ingroup PkgRestrictedLaplacian3Problems
/// The same on a triangle soup, which need not be a manifold, nor orientable.
/// \param points a range of 3D points
/// \param triangles a range of ranges of three indices into `points`
/// \param f,u,np as above, where property maps have the index of a point as key, a `std::size_t`
template <class PointRange, class TriangleRange, class Function, class IndexMap,
          class NamedParameters = parameters::Default_named_parameters,
          internal::Require_no_named_parameters<IndexMap> = 0>
Solve_report solve_poisson(const PointRange& points, const TriangleRange& triangles,
                           const Function& f, IndexMap u,
                           const NamedParameters& np = parameters::default_values()) {
  return internal::solve_poisson(
      internal::Soup_source<PointRange, TriangleRange>(points, triangles), f, 0, u, np);
}

/// \ingroup PkgRestrictedLaplacian3Problems
/// Solves the screened Poisson problem \f$\alpha u - \Delta_{\mathcal M} u = f\f$, in the form
/// \f$(S + \alpha M)\, \eta = \phi\f$. Note the sign of \f$f\f$, which is not that of
/// `solve_poisson()`.
///
/// With \f$f = \alpha g\f$ the solution minimises
/// \f$ \int \lvert \nabla u \rvert^2 + \alpha (u - g)^2 \f$: it is pulled towards \f$g\f$ where
/// \f$\alpha\f$ is large, a soft constraint.
/// \param tm the surface, a mesh or a range of oriented points
/// \param f the right-hand side, as in `solve_poisson()`
/// \param alpha in units of 1 / area: a positive number (multiply by the area to compare surfaces
/// of different size); or weights that are not negative, given as `f` is
/// \param u the solution, as in `solve_poisson()`
/// \param np optional named parameters, as in `solve_poisson()`
///
/// All else is as in `solve_poisson()`.
template <class FaceGraph, class Function, class Alpha, class VertexMap,
          class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0>
Solve_report solve_screened_poisson(const FaceGraph& tm, const Function& f, const Alpha& alpha,
                                    VertexMap u,
                                    const NamedParameters& np = parameters::default_values()) {
  internal::check_screening_weight(alpha);
  return internal::solve_poisson(internal::mesh_or_point_source(tm), f, alpha, u, np);
}

/// \ingroup PkgRestrictedLaplacian3Problems
/// The same on a triangle soup.
template <class PointRange, class TriangleRange, class Function, class Alpha, class IndexMap,
          class NamedParameters = parameters::Default_named_parameters,
          internal::Require_no_named_parameters<IndexMap> = 0>
Solve_report solve_screened_poisson(const PointRange& points, const TriangleRange& triangles,
                                    const Function& f, const Alpha& alpha, IndexMap u,
                                    const NamedParameters& np = parameters::default_values()) {
  internal::check_screening_weight(alpha);
  return internal::solve_poisson(
      internal::Soup_source<PointRange, TriangleRange>(points, triangles), f, alpha, u, np);
}

namespace internal {

template <class Source, class Function, class Alpha, class VertexMap, class NamedParameters>
Solve_report solve_poisson(const Source& source, const Function& f, const Alpha& alpha, VertexMap u,
                           const NamedParameters& np) {
  using Value = typename boost::property_traits<VertexMap>::value_type;
  constexpr bool has_weight_function = !std::is_arithmetic_v<Alpha>;
  constexpr bool has_boundary_values = is_given_v<NamedParameters, internal_np::boundary_values_t>;
  constexpr bool has_constraints =
      is_given_v<NamedParameters, internal_np::vertex_is_constrained_t>;
  CGAL::Real_timer timer;
  timer.start();
  const Spline_space_3 space = source.space(np);
  const double space_seconds = timer.time();

  Poisson_solver_options options = poisson_solver_options(np);
  if((has_boundary_values || has_constraints) &&
     !is_given_v<NamedParameters, internal_np::relative_tolerance_t>)
    options.relative_tolerance = tolerance_with_constraints;
  const double stabilization = normal_stabilization(space, np);
  bool is_screened = has_weight_function;
  if constexpr(!has_weight_function)
    is_screened = alpha > 0;
  Eigen::VectorXd load = assemble_load(space, surface_function(source, f));
  if(!is_screened)
    load = -load;

  const auto assembled_solver = [&]() {
    if constexpr(!has_weight_function && !has_boundary_values && !has_constraints)
      return poisson_solver(space, Cubature(space), static_cast<double>(alpha), stabilization,
                            options);
    else {
      // What is added is known for the finest level only.
      double constant_alpha = 0;
      if constexpr(!has_weight_function)
        constant_alpha = static_cast<double>(alpha);
      System_matrices system =
          assemble_system(space, space.depth(), Cubature(space), constant_alpha, stabilization);
      Sparse_matrix& a = system.matrices.front();
      if constexpr(has_weight_function) {
        const Cubature cubature(space);
        const auto weight = surface_function(source, alpha);
        const Weighted_integration<Cubature, decltype(weight)> weighted(space, cubature, weight);
        a.coeffs() += assemble_operators(space, space.depth(), weighted).mass.coeffs();
      }
      if constexpr(has_boundary_values) {
        const Dirichlet_boundary boundary(space);
        boundary.add_to_matrix(a);
        load += boundary.load(
            surface_function(source, parameters::get_parameter(np, internal_np::boundary_values)));
      }
      if constexpr(has_constraints) {
        static_assert(is_given_v<NamedParameters, internal_np::constraint_values_t>,
                      "vertex_is_constrained_map needs constraint_values");
        const Point_constraints constraints = vertex_constraints(source, space, np);
        constraints.add_to_matrix(a);
        load += constraints.load();
      }
      return poisson_solver(space, std::move(a), {}, system.integrals, constant_alpha, options);
    }
  };
  const Poisson_solver solver = assembled_solver();
  const double assembly_seconds = timer.time() - space_seconds - solver.setup_seconds();

  Eigen::VectorXd coefficients;
  Solve_report report = solver.solve(load, coefficients);
  report.space_seconds = space_seconds;
  report.assembly_seconds = assembly_seconds;
  const std::vector<double> values =
      Spline_function_3(space, std::move(coefficients)).values_at_vertices();
  source.for_each_vertex(
      [&](std::size_t i, const auto& v) { put_value_at(u, v, static_cast<Value>(values[i])); });
  return report;
}

} // namespace internal

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVE_POISSON_H

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVE_POISSON_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVE_POISSON_H

#include <CGAL/Restricted_laplacian_3/Dirichlet_boundary.h>
#include <CGAL/Restricted_laplacian_3/Point_constraints.h>
#include <CGAL/Restricted_laplacian_3/Poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/Spline_function_3.h>
#include <CGAL/Restricted_laplacian_3/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/assemble.h>
#include <CGAL/Restricted_laplacian_3/parameters.h>
#include <CGAL/Restricted_laplacian_3/prolongation.h>
#include <CGAL/Restricted_laplacian_3/read_point_set.h>
#include <CGAL/Restricted_laplacian_3/smoothing_patches.h>

#include <CGAL/Real_timer.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Solvers
/// The factor \f$c\f$ of the stabilisation, see `assemble_operators()`, that the functions for
/// Poisson problems use unless told otherwise: 1e-3, and 0 in the space of the paper. The number of
/// iterations does not depend on the depth of the octree then, while the error of the solution is
/// up to about twice that without stabilisation.
inline double default_normal_stabilization(const Spline_space_3& space) {
  return space.is_paper_space() ? 0 : 1e-3;
}

namespace internal {

template <class NamedParameters>
Poisson_solver_options poisson_solver_options(const NamedParameters& np) {
  using parameters::choose_parameter;
  using parameters::get_parameter;
  Poisson_solver_options options;
  options.relative_tolerance = choose_parameter(get_parameter(np, internal_np::relative_tolerance),
                                                options.relative_tolerance);
  options.maximum_iterations = choose_parameter(
      get_parameter(np, internal_np::number_of_iterations), options.maximum_iterations);
  options.cycle = choose_parameter(get_parameter(np, internal_np::cycle), options.cycle);
  options.smoothing_steps =
      choose_parameter(get_parameter(np, internal_np::smoothing_steps), options.smoothing_steps);
  options.stand_alone_multigrid = choose_parameter(
      get_parameter(np, internal_np::stand_alone_multigrid), options.stand_alone_multigrid);
  options.smoother = choose_parameter(get_parameter(np, internal_np::smoother), options.smoother);
  options.is_parallel = is_parallel(np);
  return options;
}

/// the value of `normal_stabilization`, by default that of the space
template <class NamedParameters>
double normal_stabilization(const Spline_space_3& space, const NamedParameters& np) {
  return checked_normal_stabilization(
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::normal_stabilization),
                                   default_normal_stabilization(space)));
}

/// \f$\int b_i\f$
inline Eigen::VectorXd element_integrals(const Spline_space_3& space, const Operators& operators) {
  return space.is_paper_space()
             ? assemble_element_integrals(space)
             : Eigen::VectorXd(operators.mass * Eigen::VectorXd::Ones(operators.mass.cols()));
}

inline void check_alpha(double alpha) {
  if(!(alpha >= 0 && std::isfinite(alpha)))
    throw Parameter_error("alpha", "is " + std::to_string(alpha) +
                                       ", but must be a finite number that is not negative");
}

/// \param coarse_matrices of the levels above the coarsest one of the hierarchy; may be empty
/// \param screening the number \f$\alpha\f$, or the loads of constants
template <class Screening>
Poisson_solver poisson_solver(const Spline_space_3& space, Sparse_matrix&& a,
                              std::vector<Sparse_matrix> coarse_matrices,
                              const Eigen::VectorXd& integrals, const Screening& screening,
                              const Poisson_solver_options& options) {
  const int coarsest = coarsest_multigrid_level(space);
  return Poisson_solver(std::move(a), prolongation_matrices(space, coarsest), integrals, screening,
                        options, smoothing_patches_of_levels(space, coarsest),
                        std::move(coarse_matrices));
}

/// The coarsest level whose matrices are assembled for the solver. Those of the space of the paper
/// are not the Galerkin products, which are computed then.
inline int coarsest_assembled_level(const Spline_space_3& space) {
  return space.is_paper_space() ? space.depth() : coarsest_multigrid_level(space);
}

/// with the matrices of all levels from one pass over the surface
template <class SurfaceIntegration>
Poisson_solver poisson_solver(const Spline_space_3& space, const SurfaceIntegration& integration,
                              double alpha, double normal_stabilization,
                              const Poisson_solver_options& options) {
  System_matrices system = assemble_system(space, coarsest_assembled_level(space), integration,
                                           alpha, normal_stabilization);
  if(space.is_paper_space())
    system.integrals = assemble_element_integrals(space);
  Sparse_matrix finest;
  finest.swap(system.matrices.back());
  system.matrices.pop_back();
  return poisson_solver(space, std::move(finest), std::move(system.matrices), system.integrals,
                        alpha, options);
}

/// a mesh as the source of a surface
template <class FaceGraph> class Mesh_source {
public:
  using Vertex = typename boost::graph_traits<FaceGraph>::vertex_descriptor;
  using Halfedge = typename boost::graph_traits<FaceGraph>::halfedge_descriptor;
  using Face = typename boost::graph_traits<FaceGraph>::face_descriptor;

  explicit Mesh_source(const FaceGraph& tm) : m_mesh(tm) {}

  template <class NamedParameters> Spline_space_3 space(const NamedParameters& np) const {
    return Spline_space_3(m_mesh, np);
  }
  template <class VertexMap> Linear_surface_function<double> interpolated(VertexMap map) const {
    return vertex_function(m_mesh, map);
  }
  /// calls `visit(i, v)` for all vertices in the order in which they are numbered
  template <class Visitor> void for_each_vertex(Visitor&& visit) const {
    std::size_t i = 0;
    for(auto v : vertices(m_mesh))
      visit(i++, v);
  }
  /// the same for the faces
  template <class Visitor> void for_each_face(Visitor&& visit) const {
    std::size_t i = 0;
    for(auto f : faces(m_mesh))
      visit(i++, f);
  }
  /// calls `visit(i, h)` for the corners of the faces, each given by the halfedge of the face that
  /// points to it; corner `k` of face `f` has the number `3 * f + k`
  template <class Visitor> void for_each_corner(Visitor&& visit) const {
    for_each_face([&](std::size_t i, const auto& f) {
      auto h = prev(halfedge(f, m_mesh), m_mesh);
      for(std::size_t corner = 3 * i; corner < 3 * i + 3; ++corner, h = next(h, m_mesh))
        visit(corner, h);
    });
  }

private:
  const FaceGraph& m_mesh;
};

/// a triangle soup as the source of a surface: keys of property maps are the indices of points
template <class PointRange, class TriangleRange> class Soup_source {
public:
  Soup_source(const PointRange& points, const TriangleRange& triangles)
    : m_points(points), m_triangles(triangles) {}

  template <class NamedParameters> Spline_space_3 space(const NamedParameters& np) const {
    return Spline_space_3(m_points, m_triangles, np);
  }
  template <class IndexMap> Linear_surface_function<double> interpolated(IndexMap map) const {
    return index_function(size(), map);
  }
  template <class Visitor> void for_each_vertex(Visitor&& visit) const {
    for(std::size_t i = 0; i < size(); ++i)
      visit(i, i);
  }

private:
  std::size_t size() const {
    return static_cast<std::size_t>(std::distance(std::begin(m_points), std::end(m_points)));
  }

  const PointRange& m_points;
  const TriangleRange& m_triangles;
};

/// A range of oriented points as the source of a surface: keys of property maps are the elements of
/// the range or their positions, see `read_point_set()`.
template <class PointRange> class Point_source {
public:
  explicit Point_source(const PointRange& points) : m_points(points) {}

  template <class NamedParameters> Spline_space_3 space(const NamedParameters& np) const {
    return Spline_space_3(m_points, np);
  }
  template <class Map> Linear_surface_function<double> interpolated(Map map) const {
    std::vector<double> values;
    for_each_point_key(
        m_points, [&](const auto& key) { values.push_back(CGAL::to_double(value_at(map, key))); });
    return Linear_surface_function<double>(std::move(values));
  }
  template <class Visitor> void for_each_vertex(Visitor&& visit) const {
    for_each_point_key(m_points, [&](const auto& key) { visit(key.position, key); });
  }

private:
  const PointRange& m_points;
};

/// a mesh, or a range of oriented points, as the source of a surface
template <class Surface> auto mesh_or_point_source(const Surface& surface) {
  if constexpr(is_range_v<Surface>)
    return Point_source<Surface>(surface);
  else
    return Mesh_source<Surface>(surface);
}

/// a function object on `Surface_point` is taken as it is, a property map is interpolated
template <class Source, class Function>
auto surface_function(const Source& source, const Function& f) {
  if constexpr(std::is_invocable_v<const Function&, const Surface_point&>)
    return f;
  else
    return source.interpolated(f);
}

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

/// \ingroup PkgRestrictedLaplacian3Solvers
/// A solver for \f$A \eta = b\f$ on the finest level of a space, where \f$A\f$ is the stiffness
/// matrix with other matrices of its pattern added, such as those of `Dirichlet_boundary` and
/// `Point_constraints`. The matrix is empty afterwards.
/// \param space the space; its prolongations and patches make the hierarchy
/// \param a \f$A\f$; it is empty afterwards
/// \param element_integrals \f$\int b_i\f$
/// \param alpha number \f$\alpha\f$ for which \f$A\f$ contains \f$\alpha M\f$, in units of 1 / area
/// \param options tolerance, iterations, cycle, smoother
/// \throws Parameter_error if a parameter is outside its domain
inline Poisson_solver
make_poisson_solver(const Spline_space_3& space, Sparse_matrix&& a,
                    const Eigen::VectorXd& element_integrals, double alpha = 0,
                    const Poisson_solver_options& options = Poisson_solver_options()) {
  internal::check_alpha(alpha);
  return internal::poisson_solver(space, std::move(a), {}, element_integrals, alpha, options);
}

/// \ingroup PkgRestrictedLaplacian3Solvers
/// The same with a copy of the matrix.
inline Poisson_solver
make_poisson_solver(const Spline_space_3& space, const Sparse_matrix& a,
                    const Eigen::VectorXd& element_integrals, double alpha = 0,
                    const Poisson_solver_options& options = Poisson_solver_options()) {
  return make_poisson_solver(space, Sparse_matrix(a), element_integrals, alpha, options);
}

/// \ingroup PkgRestrictedLaplacian3Solvers
/// A solver for \f$(S + \alpha M)\, \eta = b\f$ on the finest level of a space, which assembles the
/// matrices of all levels in one pass over the surface.
/// \param space the space; its prolongations and patches make the hierarchy
/// \param alpha screening weight, at least 0, in units of 1 / area
/// \param np optional named parameters: those of the overload that takes `Operators`, and
/// - `normal_stabilization`: factor \f$c\f$ of `assemble_operators()`; default
///   `default_normal_stabilization()`
/// \throws Parameter_error if a parameter is outside its domain
template <class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0>
Poisson_solver make_poisson_solver(const Spline_space_3& space, double alpha = 0,
                                   const NamedParameters& np = parameters::default_values()) {
  return make_poisson_solver(space, alpha, Cubature(space), np);
}

/// \ingroup PkgRestrictedLaplacian3Solvers
/// The same with an integration that the caller chooses.
/// \tparam SurfaceIntegration a model of `SurfaceIntegration_3`
template <class SurfaceIntegration, class NamedParameters = parameters::Default_named_parameters,
          internal::Require_no_named_parameters<SurfaceIntegration> = 0>
Poisson_solver make_poisson_solver(const Spline_space_3& space, double alpha,
                                   const SurfaceIntegration& integration,
                                   const NamedParameters& np = parameters::default_values()) {
  internal::check_alpha(alpha);
  return internal::poisson_solver(space, integration, alpha,
                                  internal::normal_stabilization(space, np),
                                  internal::poisson_solver_options(np));
}

/// \ingroup PkgRestrictedLaplacian3Solvers
/// A solver for \f$(S + \alpha M)\, \eta = b\f$ on the finest level of a space.
/// \param space the space; its prolongations and patches make the hierarchy
/// \param alpha screening weight, at least 0, in units of 1 / area
/// \param operators the matrices of the finest level of `space`
/// \param np optional named parameters:
/// - `relative_tolerance`: of the residual; default 1e-3
/// - `number_of_iterations`: at most; default 1000
/// - `cycle`: `Cycle::V` (default) or `Cycle::W`
/// - `smoothing_steps`: before, and again after the coarse correction; default 1
/// - `smoother`: `Smoother::patch` (default) or `Smoother::point`
/// - `stand_alone_multigrid`: iterate cycles, instead of preconditioning conjugate gradients with
///   them; default `false`
/// - `concurrency_tag`: `CGAL::Parallel_tag()` to use several threads, with the same results;
///   default `CGAL::Sequential_tag()`
/// \throws Parameter_error if a parameter is outside its domain
template <class NamedParameters = parameters::Default_named_parameters>
Poisson_solver make_poisson_solver(const Spline_space_3& space, const Operators& operators,
                                   double alpha = 0,
                                   const NamedParameters& np = parameters::default_values()) {
  // The patterns are the same, so values can be added without a merge.
  Sparse_matrix a = operators.stiffness;
  if(alpha != 0)
    a.coeffs() += alpha * operators.mass.coeffs();
  return make_poisson_solver(space, std::move(a), internal::element_integrals(space, operators),
                             alpha, internal::poisson_solver_options(np));
}

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

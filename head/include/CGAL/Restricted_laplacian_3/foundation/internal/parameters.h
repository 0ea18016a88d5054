// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_PARAMETERS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_PARAMETERS_H

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>
#include <CGAL/version.h>

#include <iterator>
#include <optional>
#include <type_traits>
#include <utility>

/// \file
/// The named parameters that this package takes, its own and some of \cgal. They chain in any
/// order: `parameters::depth(7).vertex_point_map(map).cube_scale(1.2)`.
///
/// \cgal makes its own out of one list, which a package outside of its tree cannot extend, and
/// names like `cycle` may be on that list one day. So names and tags are in namespaces of this
/// package, and a chain is a class of its own. It is derived from that of \cgal, whose functions
/// read it; and what takes these chains takes those of \cgal.

// The list of this package's own. A new one is a line here, and its description in the manual.
#define CGAL_RESTRICTED_LAPLACIAN_3_OWN_PARAMETERS(PARAMETER)                                      \
  PARAMETER(depth)                                                                                 \
  PARAMETER(accuracy)                                                                              \
  PARAMETER(cube_scale)                                                                            \
  PARAMETER(paper)                                                                                 \
  PARAMETER(split)                                                                                 \
  PARAMETER(joining_tolerance)                                                                     \
  PARAMETER(diffusion)                                                                             \
  PARAMETER(density)                                                                               \
  PARAMETER(maximum_memory)                                                                        \
  PARAMETER(geometry)                                                                              \
  PARAMETER(crease_angle)                                                                          \
  PARAMETER(edge_is_feature_map)                                                                   \
  PARAMETER(vertex_data)                                                                           \
  PARAMETER(tolerance)                                                                             \
  PARAMETER(cycle)                                                                                 \
  PARAMETER(energy_tolerance)                                                                      \
  PARAMETER(smoothing_steps)                                                                       \
  PARAMETER(stand_alone_multigrid)                                                                 \
  PARAMETER(eigensolver)                                                                           \
  PARAMETER(eigenvalues_only)                                                                      \
  PARAMETER(lumped_mass)                                                                           \
  PARAMETER(boundary_values)                                                                       \
  PARAMETER(has_boundary_value)                                                                    \
  PARAMETER(boundary_flux)                                                                         \
  PARAMETER(source_term)                                                                           \
  PARAMETER(conformal)                                                                             \
  PARAMETER(rescaling)                                                                             \
  PARAMETER(anisotropic)                                                                           \
  PARAMETER(fixed_boundary)                                                                        \
  PARAMETER(constraints)                                                                           \
  PARAMETER(constraint_weight)                                                                     \
  PARAMETER(area_map)                                                                              \
  PARAMETER(neighbors)                                                                             \
  PARAMETER(samples)                                                                               \
  PARAMETER(seed)                                                                                  \
  PARAMETER(maximum_iterations)                                                                    \
  PARAMETER(progress)                                                                              \
  PARAMETER(smoothing)                                                                             \
  PARAMETER(refinements)                                                                           \
  PARAMETER(pose)                                                                                  \
  PARAMETER(viewpoint)                                                                             \
  PARAMETER(minimum_facing_cosine)                                                                 \
  PARAMETER(normal_angle)                                                                          \
  PARAMETER(boundary_width)                                                                        \
  PARAMETER(oriented)                                                                              \
  PARAMETER(gradients)                                                                             \
  PARAMETER(seam_weight)                                                                           \
  PARAMETER(quality_smoothing_steps)                                                               \
  PARAMETER(match_exposures)                                                                       \
  PARAMETER(linear_light)                                                                          \
  PARAMETER(method)                                                                                \
  PARAMETER(target)                                                                                \
  PARAMETER(alpha)                                                                                 \
  PARAMETER(mean)                                                                                  \
  PARAMETER(details)                                                                               \
  PARAMETER(stabilization)                                                                         \
  PARAMETER(smoother)                                                                              \
  PARAMETER(maximum_distance)                                                                      \
  PARAMETER(batches)                                                                               \
  PARAMETER(sampling)                                                                              \
  PARAMETER(color_gradients)                                                                       \
  PARAMETER(details_tolerance)                                                                     \
  CGAL_RESTRICTED_LAPLACIAN_3_PARAMETERS_OF_LATER_CGAL(PARAMETER)

// The list of those of CGAL that the package takes: type and value of the tag, name.
#define CGAL_RESTRICTED_LAPLACIAN_3_CGAL_PARAMETERS(PARAMETER)                                     \
  PARAMETER(vertex_point_t, vertex_point, vertex_point_map)                                        \
  PARAMETER(geom_traits_t, geom_traits, geom_traits)                                               \
  PARAMETER(vertex_normal_map_t, vertex_normal_map, vertex_normal_map)                             \
  PARAMETER(edge_is_constrained_t, edge_is_constrained, edge_is_constrained_map)                   \
  PARAMETER(point_t, point_map, point_map)                                                         \
  PARAMETER(normal_t, normal_map, normal_map)                                                      \
  CGAL_RESTRICTED_LAPLACIAN_3_PARAMETERS_OF_THIS_CGAL(PARAMETER)

#if CGAL_VERSION_NR < CGAL_VERSION_NUMBER(6, 0, 0)
#define CGAL_RESTRICTED_LAPLACIAN_3_PARAMETERS_OF_LATER_CGAL(PARAMETER) PARAMETER(concurrency_tag)
#define CGAL_RESTRICTED_LAPLACIAN_3_PARAMETERS_OF_THIS_CGAL(PARAMETER)
#else
#define CGAL_RESTRICTED_LAPLACIAN_3_PARAMETERS_OF_LATER_CGAL(PARAMETER)
#define CGAL_RESTRICTED_LAPLACIAN_3_PARAMETERS_OF_THIS_CGAL(PARAMETER)                             \
  PARAMETER(concurrency_tag_t, concurrency_tag, concurrency_tag)
#endif

namespace CGAL {
namespace Restricted_laplacian_3 {

/// tags of the parameters, by which `get_parameter()` finds them
namespace internal_np {

using CGAL::internal_np::all_default_t;
using CGAL::internal_np::Lookup_named_param_def;
using CGAL::internal_np::No_property;
using CGAL::internal_np::Param_not_found;

#define CGAL_RESTRICTED_LAPLACIAN_3_TAG(NAME) enum NAME##_t{NAME};
#define CGAL_RESTRICTED_LAPLACIAN_3_CGAL_TAG(TAG, VALUE, NAME)                                     \
  using CGAL::internal_np::TAG;                                                                    \
  using CGAL::internal_np::VALUE;
CGAL_RESTRICTED_LAPLACIAN_3_OWN_PARAMETERS(CGAL_RESTRICTED_LAPLACIAN_3_TAG)
CGAL_RESTRICTED_LAPLACIAN_3_CGAL_PARAMETERS(CGAL_RESTRICTED_LAPLACIAN_3_CGAL_TAG)
#undef CGAL_RESTRICTED_LAPLACIAN_3_TAG
#undef CGAL_RESTRICTED_LAPLACIAN_3_CGAL_TAG

} // namespace internal_np

namespace parameters {

using CGAL::parameters::choose_parameter;
using CGAL::parameters::get_parameter;

/// The last parameter of a chain, with those before it as its base. Values are copied; those that
/// cannot be are kept as references.
template <class T, class Tag, class Base = internal_np::No_property>
struct Named_parameters : Named_function_parameters<T, Tag, Base> {
  using Named_function_parameters<T, Tag, Base>::Named_function_parameters;

#define CGAL_RESTRICTED_LAPLACIAN_3_MEMBER(TAG, NAME)                                              \
  template <class Value>                                                                           \
  Named_parameters<Value, internal_np::TAG, Named_parameters> NAME(const Value& value) const {     \
    return {value, *this};                                                                         \
  }
#define CGAL_RESTRICTED_LAPLACIAN_3_OWN_MEMBER(NAME)                                               \
  CGAL_RESTRICTED_LAPLACIAN_3_MEMBER(NAME##_t, NAME)
#define CGAL_RESTRICTED_LAPLACIAN_3_CGAL_MEMBER(TAG, VALUE, NAME)                                  \
  CGAL_RESTRICTED_LAPLACIAN_3_MEMBER(TAG, NAME)
  CGAL_RESTRICTED_LAPLACIAN_3_OWN_PARAMETERS(CGAL_RESTRICTED_LAPLACIAN_3_OWN_MEMBER)
  CGAL_RESTRICTED_LAPLACIAN_3_CGAL_PARAMETERS(CGAL_RESTRICTED_LAPLACIAN_3_CGAL_MEMBER)
#undef CGAL_RESTRICTED_LAPLACIAN_3_MEMBER
#undef CGAL_RESTRICTED_LAPLACIAN_3_OWN_MEMBER
#undef CGAL_RESTRICTED_LAPLACIAN_3_CGAL_MEMBER
};

/// no parameters; chains may begin with it
using Default_named_parameters = Named_parameters<bool, internal_np::all_default_t>;
inline Default_named_parameters default_values() { return {}; }

// the functions that chains begin with
#define CGAL_RESTRICTED_LAPLACIAN_3_FUNCTION(TAG, NAME)                                            \
  template <class Value> Named_parameters<Value, internal_np::TAG> NAME(const Value& value) {      \
    return {value};                                                                                \
  }
#define CGAL_RESTRICTED_LAPLACIAN_3_OWN_FUNCTION(NAME)                                             \
  CGAL_RESTRICTED_LAPLACIAN_3_FUNCTION(NAME##_t, NAME)
#define CGAL_RESTRICTED_LAPLACIAN_3_CGAL_FUNCTION(TAG, VALUE, NAME)                                \
  CGAL_RESTRICTED_LAPLACIAN_3_FUNCTION(TAG, NAME)
CGAL_RESTRICTED_LAPLACIAN_3_OWN_PARAMETERS(CGAL_RESTRICTED_LAPLACIAN_3_OWN_FUNCTION)
CGAL_RESTRICTED_LAPLACIAN_3_CGAL_PARAMETERS(CGAL_RESTRICTED_LAPLACIAN_3_CGAL_FUNCTION)
#undef CGAL_RESTRICTED_LAPLACIAN_3_FUNCTION
#undef CGAL_RESTRICTED_LAPLACIAN_3_OWN_FUNCTION
#undef CGAL_RESTRICTED_LAPLACIAN_3_CGAL_FUNCTION

} // namespace parameters

#undef CGAL_RESTRICTED_LAPLACIAN_3_OWN_PARAMETERS
#undef CGAL_RESTRICTED_LAPLACIAN_3_CGAL_PARAMETERS
#undef CGAL_RESTRICTED_LAPLACIAN_3_PARAMETERS_OF_LATER_CGAL
#undef CGAL_RESTRICTED_LAPLACIAN_3_PARAMETERS_OF_THIS_CGAL

namespace internal {

/// tells overloads apart whose last argument may be named parameters
template <class T> struct Is_named_parameters : std::false_type {};
template <class T, class Tag, class Base>
struct Is_named_parameters<Named_function_parameters<T, Tag, Base>> : std::true_type {};
template <class T, class Tag, class Base>
struct Is_named_parameters<parameters::Named_parameters<T, Tag, Base>> : std::true_type {};

/// whether a parameter is among some named parameters
template <class NamedParameters, class Tag>
constexpr bool is_given_v =
    !std::is_same<std::decay_t<decltype(parameters::get_parameter(
                      std::declval<const NamedParameters&>(), std::declval<Tag>()))>,
                  internal_np::Param_not_found>::value;

template <class T, class Value> void assign_if_any(T& variable, const Value& value) {
  variable = value;
}
/// a `std::optional` without a value stands for the default
template <class T, class Value> void assign_if_any(T& variable, const std::optional<Value>& value) {
  if(value)
    variable = *value;
}

/// sets a variable to the value of a parameter if that is given
template <class NamedParameters, class Tag, class T>
void read_parameter([[maybe_unused]] const NamedParameters& np, [[maybe_unused]] Tag tag,
                    [[maybe_unused]] T& variable) {
  if constexpr(is_given_v<NamedParameters, Tag>)
    assign_if_any(variable, parameters::get_parameter(np, tag));
}

template <class T>
using Require_named_parameters = std::enable_if_t<Is_named_parameters<T>::value, int>;
template <class T>
using Require_no_named_parameters = std::enable_if_t<!Is_named_parameters<T>::value, int>;

/// tells ranges, of points for example, from meshes
template <class T, class = void> struct Is_range : std::false_type {};
template <class T>
struct Is_range<T, std::void_t<decltype(std::begin(std::declval<const T&>())),
                               decltype(std::end(std::declval<const T&>()))>> : std::true_type {};
template <class T> constexpr bool is_range_v = Is_range<T>::value;

/// whether several threads are asked for: the value of `concurrency_tag`, by default
/// `CGAL::Sequential_tag()`
template <class NamedParameters> constexpr bool is_parallel(const NamedParameters&) {
  using Tag = typename internal_np::Lookup_named_param_def<internal_np::concurrency_tag_t,
                                                           NamedParameters, Sequential_tag>::type;
  constexpr bool result = std::is_convertible<Tag, Parallel_tag>::value;
#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!result, "CGAL::Parallel_tag is given, but the program is not linked with TBB.");
#endif
  return result;
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_PARAMETERS_H

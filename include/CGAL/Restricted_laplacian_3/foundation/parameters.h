// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_PARAMETERS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_PARAMETERS_H

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>
#include <CGAL/version.h>

#include <iterator>
#include <type_traits>
#include <utility>

/// \file
/// The named parameters of this package, beside those of \cgal. They are created by free
/// functions and chained through their second argument:
/// `CGAL::parameters::octree_depth(7, CGAL::parameters::cube_scale(1.2))`.

// CGAL's own parameters come out of one list that a package outside of CGAL's tree cannot extend,
// hence a tag and two free functions for each parameter here.
#define CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(NAME)                                                \
  namespace CGAL {                                                                                 \
  namespace internal_np {                                                                          \
  enum NAME##_t{NAME};                                                                             \
  }                                                                                                \
  namespace parameters {                                                                           \
  template <typename T> Named_function_parameters<T, internal_np::NAME##_t> NAME(const T& value) { \
    return Named_function_parameters<T, internal_np::NAME##_t>(value);                             \
  }                                                                                                \
  }                                                                                                \
  }                                                                                                \
  CGAL_RESTRICTED_LAPLACIAN_3_CHAINED_PARAMETER(NAME)

// A parameter that CGAL has, with the function that chains it.
#define CGAL_RESTRICTED_LAPLACIAN_3_CHAINED_PARAMETER(NAME)                                        \
  namespace CGAL {                                                                                 \
  namespace parameters {                                                                           \
  template <typename T, typename NP_T, typename NP_Tag, typename NP_Base>                          \
  Named_function_parameters<T, internal_np::NAME##_t,                                              \
                            Named_function_parameters<NP_T, NP_Tag, NP_Base>>                      \
  NAME(const T& value, const Named_function_parameters<NP_T, NP_Tag, NP_Base>& np) {               \
    return Named_function_parameters<T, internal_np::NAME##_t,                                     \
                                     Named_function_parameters<NP_T, NP_Tag, NP_Base>>(value, np); \
  }                                                                                                \
  }                                                                                                \
  }

CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(octree_depth)
CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(cube_scale)
CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(paper_space)
CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(split_elements)
CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(joining_tolerance)
CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(relative_tolerance)
CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(cycle)
CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(smoothing_steps)
CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(stand_alone_multigrid)
CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(eigensolver)
CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(lumped_mass)
CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(boundary_values)
CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(constraint_values)
CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(constraint_weight)
CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(area_map)
CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(number_of_neighbors)
CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(smoothing_weight)
CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(refinement_steps)
CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(pose)
CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(viewpoint)
CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(minimum_facing_cosine)
CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(minimum_normal_cosine)
CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(boundary_width)
CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(oriented_surface)
CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(gradient_source)
CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(seam_weight)
CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(quality_smoothing_steps)
CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(match_exposures)
CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(linear_light)
CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(curvature_method)
CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(target_values)
CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(screening_weight)
CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(mean_value)
CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(vertex_details)

CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(normal_stabilization)
CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(smoother)

#if CGAL_VERSION_NR < CGAL_VERSION_NUMBER(5, 6, 0)
CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(maximum_distance)
#else
CGAL_RESTRICTED_LAPLACIAN_3_CHAINED_PARAMETER(maximum_distance)
#endif
#if CGAL_VERSION_NR < CGAL_VERSION_NUMBER(6, 0, 0)
CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER(concurrency_tag)
#else
CGAL_RESTRICTED_LAPLACIAN_3_CHAINED_PARAMETER(concurrency_tag)
#endif

#undef CGAL_RESTRICTED_LAPLACIAN_3_PARAMETER
#undef CGAL_RESTRICTED_LAPLACIAN_3_CHAINED_PARAMETER

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// tells overloads apart whose last argument may be named parameters
template <class T> struct Is_named_parameters : std::false_type {};
template <class T, class Tag, class Base>
struct Is_named_parameters<Named_function_parameters<T, Tag, Base>> : std::true_type {};

/// whether a parameter is among some named parameters
template <class NamedParameters, class Tag>
constexpr bool is_given_v =
    !std::is_same<std::decay_t<decltype(parameters::get_parameter(
                      std::declval<const NamedParameters&>(), std::declval<Tag>()))>,
                  internal_np::Param_not_found>::value;

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

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_PARAMETERS_H

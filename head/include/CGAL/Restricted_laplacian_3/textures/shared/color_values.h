// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_SHARED_COLOR_VALUES_H
#define CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_SHARED_COLOR_VALUES_H

#include <CGAL/Restricted_laplacian_3/surface/shared/function_components.h>
#include <CGAL/Restricted_laplacian_3/textures/srgb.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// `CGAL::IO::Color` and classes like it
template <class Value, class = void> struct Is_byte_color : std::false_type {};
template <class Value>
struct Is_byte_color<Value, std::void_t<decltype(std::declval<const Value&>().red()),
                                        decltype(std::declval<const Value&>().blue())>>
  : std::true_type {};

/// whether the components of a vector type are integers, which count from 0 to 255
template <class Value, class = void> struct Has_integers : std::false_type {};
template <class Value>
struct Has_integers<
    Value, std::enable_if_t<std::is_integral_v<std::decay_t<decltype(std::declval<Value>()[0])>>>>
  : std::true_type {};

/// The color that a value of a property map stands for: `CGAL::IO::Color`; or three components, see
/// `Function_components`, 0 .. 1, or 0 .. 255 if they are integers.
template <class Value> Rgb_color read_color(const Value& value) {
  if constexpr(Is_byte_color<Value>::value)
    return {value.red() / 255., value.green() / 255., value.blue() / 255.};
  else {
    static_assert(Function_components<Value>::number == 3, "colors have three components");
    if constexpr(Has_integers<Value>::value)
      return {value[0] / 255., value[1] / 255., value[2] / 255.};
    else {
      const Eigen::Vector3d c = Function_components<Value>::read(value);
      return {c[0], c[1], c[2]};
    }
  }
}

/// the inverse; bytes are rounded
template <class Value> Value make_color(const Rgb_color& color) {
  const auto byte = [](double x) { return std::round(255 * std::clamp(x, 0., 1.)); };
  if constexpr(Is_byte_color<Value>::value) {
    Value result;
    result.set_rgb(static_cast<unsigned char>(byte(color[0])),
                   static_cast<unsigned char>(byte(color[1])),
                   static_cast<unsigned char>(byte(color[2])));
    return result;
  } else {
    static_assert(Function_components<Value>::number == 3, "colors have three components");
    if constexpr(Has_integers<Value>::value)
      return Function_components<Value>::make({byte(color[0]), byte(color[1]), byte(color[2])});
    else
      return Function_components<Value>::make({color[0], color[1], color[2]});
  }
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_SHARED_COLOR_VALUES_H

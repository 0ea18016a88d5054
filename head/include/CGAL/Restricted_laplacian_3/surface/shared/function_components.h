// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_FUNCTION_COMPONENTS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_FUNCTION_COMPONENTS_H

#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/coordinates.h>

#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// A value of a function as a column vector of `N` numbers.
template <int N> struct Components {
  static constexpr int number = N, size = N;
  using Vector = Eigen::Matrix<double, N, 1>;
};

/// The components of a value of a function: how many there are, how to read them into a column
/// vector, and how to make a value of them. Values are numbers, `std::array`s of numbers, vectors
/// of Eigen of a fixed size, or 3D vectors and points of a kernel of \cgal.
template <class Value, class = void> struct Function_components : Components<1> {
  static Vector read(const Value& value) { return Vector(CGAL::to_double(value)); }
  static Value make(const Vector& components) { return static_cast<Value>(components[0]); }
};

template <class Number, std::size_t N>
struct Function_components<std::array<Number, N>> : Components<static_cast<int>(N)> {
  using Vector = typename Components<static_cast<int>(N)>::Vector;
  static Vector read(const std::array<Number, N>& value) {
    Vector result;
    for(std::size_t i = 0; i < N; ++i)
      result[static_cast<Eigen::Index>(i)] = CGAL::to_double(value[i]);
    return result;
  }
  static std::array<Number, N> make(const Vector& components) {
    std::array<Number, N> result;
    for(std::size_t i = 0; i < N; ++i)
      result[i] = static_cast<Number>(components[static_cast<Eigen::Index>(i)]);
    return result;
  }
};

/// expressions too: what a function object with the return type `auto` may return
template <class Value>
struct Function_components<Value,
                           std::enable_if_t<std::is_base_of_v<Eigen::MatrixBase<Value>, Value>>>
  : Components<Value::SizeAtCompileTime> {
  static_assert(Value::SizeAtCompileTime > 0 && Value::IsVectorAtCompileTime,
                "vectors of Eigen need a size that is known at compile time");
  using Vector = typename Components<Value::SizeAtCompileTime>::Vector;
  static Vector read(const Value& value) {
    Vector result;
    for(int i = 0; i < Vector::RowsAtCompileTime; ++i)
      result[i] = static_cast<double>(value[i]);
    return result;
  }
  static Value make(const Vector& components) {
    Value result;
    for(int i = 0; i < Vector::RowsAtCompileTime; ++i)
      result[i] = static_cast<typename Value::Scalar>(components[i]);
    return result;
  }
};

/// vectors and points of \cgal
template <class Value>
struct Function_components<Value, std::void_t<decltype(std::declval<const Value&>().cartesian(2))>>
  : Components<3> {
  static Vector read(const Value& value) { return with_coordinates_of<Vector>(value); }
  static Value make(const Vector& components) {
    return Value(components[0], components[1], components[2]);
  }
};

template <class Function>
using Components_of =
    Function_components<std::decay_t<std::invoke_result_t<const Function&, const Surface_point&>>>;

/// A value of a vector field as `K` vectors, the columns of a matrix.
template <int K> struct Channels {
  static constexpr int number = K, size = 3 * K;
  using Vector = Eigen::Matrix<double, 3, K>;
};

/// The channels of a value of a vector field: how many vectors it has, and how to read them into
/// the columns of a matrix. Values are 3D vectors of a kernel of \cgal, `std::array`s of them, or
/// matrices of Eigen of three rows and a fixed number of columns.
template <class Value, class = void> struct Vector_field_channels : Channels<1> {
  static Vector read(const Value& value) { return with_coordinates_of<Vector>(value); }
};

template <class Value, std::size_t K>
struct Vector_field_channels<std::array<Value, K>> : Channels<static_cast<int>(K)> {
  using Vector = typename Channels<static_cast<int>(K)>::Vector;
  static Vector read(const std::array<Value, K>& value) {
    Vector result;
    for(std::size_t k = 0; k < K; ++k)
      result.col(static_cast<Eigen::Index>(k)) = Vector_field_channels<Value>::read(value[k]);
    return result;
  }
};

template <class Value>
struct Vector_field_channels<Value,
                             std::enable_if_t<std::is_base_of_v<Eigen::MatrixBase<Value>, Value>>>
  : Channels<Value::ColsAtCompileTime> {
  static_assert(Value::RowsAtCompileTime == 3 && Value::ColsAtCompileTime > 0,
                "the values of a vector field need three rows and a fixed number of columns");
  using Vector = typename Channels<Value::ColsAtCompileTime>::Vector;
  static Vector read(const Value& value) { return value.template cast<double>(); }
};

template <class Field>
using Channels_of =
    Vector_field_channels<std::decay_t<std::invoke_result_t<const Field&, const Surface_point&>>>;

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_FUNCTION_COMPONENTS_H

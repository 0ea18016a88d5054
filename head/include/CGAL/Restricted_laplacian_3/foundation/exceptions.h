// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_EXCEPTIONS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_EXCEPTIONS_H

#include <cstddef>
#include <new>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Errors
/// Base class of all exceptions that are thrown because of bad input data or parameter values.
class Input_error : public std::invalid_argument {
public:
  using std::invalid_argument::invalid_argument;
};

/// \ingroup PkgRestrictedLaplacian3Errors
/// The surface has no face, or the point set no point.
class Empty_surface_error : public Input_error {
public:
  /// \param message what `what()` returns
  explicit Empty_surface_error(const std::string& message = "the surface has no face")
    : Input_error(message) {}
};

/// \ingroup PkgRestrictedLaplacian3Errors
/// The area is zero: all faces of the surface are degenerate, or thinner than rounding errors in
/// the octree, or all points of a point set are the same, or have weight zero.
class Zero_area_error : public Input_error {
public:
  /// \param message what `what()` returns
  explicit Zero_area_error(const std::string& message) : Input_error(message) {}
  /// \param number_of_faces of the surface, for the message
  explicit Zero_area_error(std::size_t number_of_faces)
    : Input_error("the surface has area zero: all of its " + std::to_string(number_of_faces) +
                  " faces are degenerate") {}
};

/// \ingroup PkgRestrictedLaplacian3Errors
/// A face cannot be used, for example because it is not a triangle.
class Invalid_face_error : public Input_error {
public:
  /// \param face its position
  /// \param reason the rest of a sentence that begins with the face, for the message
  Invalid_face_error(std::size_t face, const std::string& reason)
    : Input_error("face " + std::to_string(face) + " " + reason), m_face(face) {}

  /// position of the face in the iteration over `faces(tm)`, counted from 0
  std::size_t face() const noexcept { return m_face; }

private:
  std::size_t m_face;
};

/// \ingroup PkgRestrictedLaplacian3Errors
/// A vertex cannot be used, for example because a coordinate is not finite.
class Invalid_vertex_error : public Input_error {
public:
  /// \param vertex its position
  /// \param reason the rest of a sentence that begins with the vertex, for the message
  Invalid_vertex_error(std::size_t vertex, const std::string& reason)
    : Input_error("vertex " + std::to_string(vertex) + " " + reason), m_vertex(vertex) {}

  /// position of the vertex in the iteration over `vertices(tm)`, counted from 0
  std::size_t vertex() const noexcept { return m_vertex; }

private:
  std::size_t m_vertex;
};

/// \ingroup PkgRestrictedLaplacian3Errors
/// A point of a point set cannot be used: a coordinate is not finite, its normal is zero or not
/// finite, or its area negative or not finite.
class Invalid_point_error : public Input_error {
public:
  /// \param point its position
  /// \param reason the rest of a sentence that begins with the point, for the message
  Invalid_point_error(std::size_t point, const std::string& reason)
    : Input_error("point " + std::to_string(point) + " " + reason), m_point(point) {}

  /// position of the point in the range, counted from 0
  std::size_t point() const noexcept { return m_point; }

private:
  std::size_t m_point;
};

/// \ingroup PkgRestrictedLaplacian3Errors
/// A parameter is outside its domain.
class Parameter_error : public Input_error {
public:
  /// \param parameter its name
  /// \param reason the rest of a sentence that begins with the name, for the message
  Parameter_error(const std::string& parameter, const std::string& reason)
    : Input_error(parameter + " " + reason), m_parameter(parameter) {}

  /// name of the parameter
  const std::string& parameter() const noexcept { return m_parameter; }

private:
  std::string m_parameter;
};

/// \ingroup PkgRestrictedLaplacian3Errors
/// A point at which a function is to be evaluated is not on the surface.
class Location_error : public Input_error {
public:
  using Input_error::Input_error;
};

/// \ingroup PkgRestrictedLaplacian3Errors
/// A factorization or an eigenvalue iteration broke down.
class Numerical_error : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// \ingroup PkgRestrictedLaplacian3Errors
/// The system has not given the memory that a step of the work needs. What is known to be too much
/// for the machine is a `Parameter_error` before the work, see
/// `Spline_space_options::maximum_memory`.
class Out_of_memory : public std::bad_alloc {
public:
  /// \param message what `what()` returns; it must outlive this object
  explicit Out_of_memory(const char* message) noexcept : m_message(message) {}

  /// names the step
  const char* what() const noexcept override { return m_message; }

private:
  const char* m_message;
};

/// \ingroup PkgRestrictedLaplacian3Errors
/// `progress` returned `false`.
class Canceled : public std::runtime_error {
public:
  Canceled() : std::runtime_error("the computation was canceled by its callback") {}
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_EXCEPTIONS_H

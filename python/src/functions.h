// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_PYTHON_FUNCTIONS_H
#define RESTRICTED_LAPLACIAN_3_PYTHON_FUNCTIONS_H

// What callers give as functions on a surface: arrays of values, or callables.

#include "module.h"

#include <CGAL/Restricted_laplacian_3/patches/Smooth_geometry.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_function_view.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace python {

// Where the numbers of an array belong to: linear in each triangle between vertices or corners,
// constant on each face.
enum class At { vertices, corners, faces };

// A function on a surface. Copies share what is large.
class Function {
public:
  virtual ~Function() = default;
  virtual int components() const = 0;
  virtual int degree() const = 0;
  // of the points, one after the other
  virtual void operator()(const RL::Surface_point* points, std::size_t number,
                          double* values) const = 0;
  // whether it is called with many points at a time if a space is `recorded()`
  virtual bool is_callable() const { return false; }
};

// Values in an array, row by row.
class Array_function : public Function {
public:
  // \param values a row for each vertex or face, or three for each face
  Array_function(Rows values, At at) : m_values(std::move(values)), m_at(at) {}

  int components() const override { return static_cast<int>(m_values.shape(1)); }
  int degree() const override { return m_at == At::faces ? 0 : 1; }
  void operator()(const RL::Surface_point* points, std::size_t number,
                  double* values) const override;

  std::size_t size() const { return m_values.shape(0); }
  At at() const { return m_at; }

private:
  Rows m_values;
  At m_at;
};

// Values at vertices in an array, smooth between them.
class Smooth_array_function : public Function {
public:
  // \param values a row for each vertex
  Smooth_array_function(const RL::Triangulated_surface_3& surface,
                        const RL::Smooth_geometry& geometry, const Rows& values);

  int components() const override { return m_linear.components(); }
  int degree() const override { return 3; }
  void operator()(const RL::Surface_point* points, std::size_t number,
                  double* values) const override;

private:
  Array_function m_linear;
  std::vector<double> m_deviations;
};

// A callable of Python that takes an array of points, a row for each, and returns an array of
// values. In a space that is `recorded()` it is called for all nodes of the surface at once, in
// blocks that are large; elsewhere for as many points as the library asks for.
class Callable_function : public Function {
public:
  Callable_function(nb::object callable, int components, int degree)
    : m_callable(std::move(callable)), m_components(components), m_degree(degree) {}

  int components() const override { return m_components; }
  int degree() const override { return m_degree; }
  void operator()(const RL::Surface_point* points, std::size_t number,
                  double* values) const override;
  bool is_callable() const override { return true; }

private:
  // the values at points whose coordinates are given
  void call(const std::vector<double>& coordinates, double* values) const;

  nb::object m_callable;
  int m_components, m_degree;
  mutable std::mutex m_mutex;
  mutable std::map<std::pair<std::uint64_t, int>, std::vector<double>> m_tables;
};

// A function that a surface shares with Python.
struct Shared_function {
  std::shared_ptr<const Function> function;

  int components() const { return function->components(); }
  int degree() const { return function->degree(); }
  void operator()(const RL::Surface_point* points, std::size_t number, double* values) const {
    (*function)(points, number, values);
  }
};

// The space with an integration that numbers its nodes, if one of the functions is a callable.
RL::Spline_space_3 recorded(const RL::Spline_space_3& space,
                            std::initializer_list<const Function*> functions);

// throws unless the function has values for all of the surface
void check_function(const Function& f, const RL::Triangulated_surface_3& surface, const char* name,
                    int components = 0);

} // namespace python

#endif // RESTRICTED_LAPLACIAN_3_PYTHON_FUNCTIONS_H

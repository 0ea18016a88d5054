// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "functions.h"

#include <CGAL/Restricted_laplacian_3/integration/Integration_nodes.h>
#include <CGAL/Restricted_laplacian_3/integration/Surface_integration.h>
#include <CGAL/Restricted_laplacian_3/patches/smooth_vertex_data.h>
#include <CGAL/Restricted_laplacian_3/surface/surface_functions.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <string>
#include <utility>

namespace python {
namespace {

// The nodes of a surface for one degree: the number of the first one of each sheet.
using First_nodes = std::vector<std::size_t>;

// Numbers the nodes of an integration. While it hands on a block, it says on the thread that does
// so which nodes these are.
class Recording {
public:
  // the block that is handed on
  struct Current {
    const Recording* recording = nullptr;      // none: the points are others
    const RL::Surface_point* points = nullptr; // of the first node
    std::size_t first = 0, size = 0;
    int degree = 0;
  };
  static thread_local Current current;

  explicit Recording(const RL::Spline_space_3& space)
    : m_base(space.integration()), m_number_of_sheets(space.number_of_sheets(space.depth())) {}

  void add_nodes(std::size_t sheet, int degree, RL::Integration_nodes& nodes) const {
    std::size_t first = first_nodes(degree)[sheet];
    m_base.visit_nodes(sheet, degree, [&](const RL::Integration_node_block& block) {
      nodes.flush();
      const RL::Surface_point* const points = nodes.open_block().points.data();
      const Current before = current;
      current = {this, points, first, block.size, degree};
      for(std::size_t i = 0; i < block.size; ++i)
        nodes.add(block.points[i], block.position(i), block.weights[i], block.metrics[i],
                  block.areas[i]);
      nodes.flush();
      current = before;
      first += block.size;
    });
  }

  // calls `visit(points, number)` for all nodes of a degree in the order of their numbers
  template <class Visit> void visit_all(int degree, Visit&& visit) const {
    for(std::size_t sheet = 0; sheet < m_number_of_sheets; ++sheet)
      m_base.visit_nodes(sheet, degree, [&](const RL::Integration_node_block& block) {
        visit(block.points.data(), block.size);
      });
  }
  std::size_t number_of_nodes(int degree) const { return first_nodes(degree).back(); }
  // another one for each space, and the same for copies
  std::uint64_t number() const { return m_tables->number; }

protected:
  RL::Surface_integration m_base;

private:
  const First_nodes& first_nodes(int degree) const {
    const std::lock_guard<std::mutex> lock(m_tables->mutex);
    First_nodes& result = m_tables->of_degree[degree];
    if(result.empty()) {
      result.reserve(m_number_of_sheets + 1);
      std::size_t number = 0;
      for(std::size_t sheet = 0; sheet < m_number_of_sheets; ++sheet) {
        result.push_back(number);
        m_base.visit_nodes(sheet, degree,
                           [&](const RL::Integration_node_block& block) { number += block.size; });
      }
      result.push_back(number);
    }
    return result;
  }

  struct Tables {
    static inline std::atomic<std::uint64_t> next_number{0};
    std::uint64_t number = next_number++;
    std::mutex mutex;
    std::map<int, First_nodes> of_degree;
  };

  std::size_t m_number_of_sheets;
  std::shared_ptr<Tables> m_tables = std::make_shared<Tables>();
};

thread_local Recording::Current Recording::current;

// the same for an integration that has moments
class Recording_with_moments : public Recording {
public:
  using Recording::Recording;
  void add_moments(std::size_t sheet, const RL::internal::Factors_of_face* factors,
                   RL::internal::Sheet_integrals& integrals) const {
    m_base.add_moments(sheet, factors, integrals);
  }
};

void append_coordinates(const RL::Surface_point* points, std::size_t number,
                        std::vector<double>& coordinates) {
  for(std::size_t i = 0; i < number; ++i)
    for(int axis = 0; axis < 3; ++axis)
      coordinates.push_back(points[i].point[axis]);
}

} // namespace

void Array_function::operator()(const RL::Surface_point* points, std::size_t number,
                                double* values) const {
  const std::size_t n = m_values.shape(1);
  const double* const data = m_values.data();
  for(std::size_t i = 0; i < number; ++i) {
    const RL::Surface_point& p = points[i];
    if(m_at == At::faces) {
      values = std::copy_n(data + p.face * n, n, values);
      continue;
    }
    const auto corner = [&](std::size_t k) {
      return data + n * (m_at == At::vertices ? p.vertices[k] : 3 * p.face + k);
    };
    const double *const a = corner(0), *const b = corner(1), *const c = corner(2);
    for(std::size_t k = 0; k < n; ++k)
      *values++ = RL::internal::barycentric_mean(a[k], b[k], c[k], p.barycentric);
  }
}

Smooth_array_function::Smooth_array_function(const RL::Triangulated_surface_3& surface,
                                             const RL::Smooth_geometry& geometry,
                                             const Rows& values)
  : m_linear(values, At::vertices) {
  if(values.shape(0) != surface.number_of_vertices())
    throw RL::Parameter_error("values", "has " + std::to_string(values.shape(0)) +
                                            " rows, but must have " +
                                            std::to_string(surface.number_of_vertices()));
  m_deviations = RL::internal::cubic_deviations(
      surface, geometry, std::vector<double>(values.data(), values.data() + values.size()),
      values.shape(1));
}

void Smooth_array_function::operator()(const RL::Surface_point* points, std::size_t number,
                                       double* values) const {
  m_linear(points, number, values);
  const auto n = static_cast<std::size_t>(components());
  for(std::size_t i = 0; i < number; ++i, values += n) {
    const std::array<double, 7> weights = RL::internal::cubic_weights(points[i].barycentric);
    const double* coefficient = m_deviations.data() + 7 * n * points[i].face;
    for(const double weight : weights)
      for(std::size_t k = 0; k < n; ++k)
        values[k] += weight * *coefficient++;
  }
}

void Callable_function::operator()(const RL::Surface_point* points, std::size_t number,
                                   double* values) const {
  const Recording::Current& current = Recording::current;
  const auto n = static_cast<std::size_t>(m_components);
  if(!current.recording || points < current.points ||
     points + number > current.points + current.size) {
    std::vector<double> coordinates;
    append_coordinates(points, number, coordinates);
    call(coordinates, values);
    return;
  }
  const std::size_t first = current.first + static_cast<std::size_t>(points - current.points);
  std::unique_lock<std::mutex> lock(m_mutex);
  std::vector<double>& table = m_tables[{current.recording->number(), current.degree}];
  if(table.empty()) {
    constexpr std::size_t points_of_a_call = 1 << 18;
    std::vector<double> result(n * current.recording->number_of_nodes(current.degree)), coordinates;
    double* next = result.data();
    const auto call_collected = [&] {
      call(coordinates, next);
      next += n * (coordinates.size() / 3);
      coordinates.clear();
    };
    current.recording->visit_all(current.degree,
                                 [&](const RL::Surface_point* nodes, std::size_t size) {
                                   append_coordinates(nodes, size, coordinates);
                                   if(coordinates.size() >= 3 * points_of_a_call)
                                     call_collected();
                                 });
    call_collected();
    table = std::move(result);
  }
  lock.unlock(); // a table does not change, nor move
  std::copy_n(table.data() + n * first, n * number, values);
}

void Callable_function::call(const std::vector<double>& coordinates, double* values) const {
  const nb::gil_scoped_acquire lock;
  if(coordinates.empty())
    return;
  const std::size_t number = coordinates.size() / 3, n = static_cast<std::size_t>(m_components);
  nb::object points = array_of_rows(std::vector<double>(coordinates), 3);
  nb::module_ numpy = nb::module_::import_("numpy");
  const nb::object result =
      numpy.attr("ascontiguousarray")(m_callable(points), nb::arg("dtype") = numpy.attr("float64"));
  const auto array = nb::cast<nb::ndarray<const double, nb::c_contig, nb::device::cpu>>(result);
  if(array.ndim() == 0 || array.shape(0) != number || array.size() != n * number)
    throw RL::Parameter_error("callable", "returns an array of the wrong shape: for " +
                                              std::to_string(number) + " points it has to be (" +
                                              std::to_string(number) +
                                              (n == 1 ? ",)" : ", " + std::to_string(n) + ")"));
  std::copy_n(array.data(), n * number, values);
}

RL::Spline_space_3 recorded(const RL::Spline_space_3& space,
                            std::initializer_list<const Function*> functions) {
  if(std::none_of(functions.begin(), functions.end(),
                  [](const Function* f) { return f && f->is_callable(); }))
    return space;
  return space.integration().adds_moments() ? space.integrated_by(Recording_with_moments(space))
                                            : space.integrated_by(Recording(space));
}

void check_function(const Function& f, const RL::Triangulated_surface_3& surface, const char* name,
                    int components) {
  if(components > 0 && f.components() != components)
    throw RL::Parameter_error(name, "has " + std::to_string(f.components()) +
                                        " components, but must have " + std::to_string(components));
  const auto* const array = dynamic_cast<const Array_function*>(&f);
  if(!array)
    return;
  const std::size_t expected = array->at() == At::vertices ? surface.number_of_vertices()
                               : array->at() == At::faces  ? surface.number_of_faces()
                                                           : 3 * surface.number_of_faces();
  if(array->size() != expected)
    throw RL::Parameter_error(name, "has " + std::to_string(array->size()) +
                                        " rows, but must have " + std::to_string(expected));
}

} // namespace python

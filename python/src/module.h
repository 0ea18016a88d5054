// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_PYTHON_MODULE_H
#define RESTRICTED_LAPLACIAN_3_PYTHON_MODULE_H

// What all parts of the module share: arrays in, arrays out, and calls that let go of the
// interpreter.

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/solvers/Solve_report.h>

#include <Eigen/Core>

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/info.h>
#include <tbb/task_arena.h>
#endif

#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace python {

namespace nb = nanobind;
namespace RL = CGAL::Restricted_laplacian_3;

// an array of any numbers, of which nothing is copied and nothing changed
using Array = nb::ndarray<nb::ro, nb::device::cpu>;
// float64, row after row
using Rows = nb::ndarray<const double, nb::ndim<2>, nb::c_contig, nb::device::cpu>;
using Numbers = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

// Calls `visit(pointer)` with the first number of an array, whose type is one that NumPy and C++
// have.
template <class Visit> void visit_numbers(const Array& a, const char* name, Visit&& visit) {
  const nb::dlpack::dtype type = a.dtype();
  const auto is = [&](auto number) { return type == nb::dtype<decltype(number)>(); };
  const void* data = a.data();
#define RESTRICTED_LAPLACIAN_3_VISIT(T)                                                            \
  if(is(T()))                                                                                      \
    return visit(static_cast<const T*>(data));
  RESTRICTED_LAPLACIAN_3_VISIT(double)
  RESTRICTED_LAPLACIAN_3_VISIT(float)
  RESTRICTED_LAPLACIAN_3_VISIT(std::int64_t)
  RESTRICTED_LAPLACIAN_3_VISIT(std::int32_t)
  RESTRICTED_LAPLACIAN_3_VISIT(std::uint64_t)
  RESTRICTED_LAPLACIAN_3_VISIT(std::uint32_t)
  RESTRICTED_LAPLACIAN_3_VISIT(std::int16_t)
  RESTRICTED_LAPLACIAN_3_VISIT(std::uint16_t)
  RESTRICTED_LAPLACIAN_3_VISIT(std::int8_t)
  RESTRICTED_LAPLACIAN_3_VISIT(std::uint8_t)
#undef RESTRICTED_LAPLACIAN_3_VISIT
  throw RL::Parameter_error(name, "has numbers of a type that is not known");
}

// An array of NumPy that owns a matrix of Eigen, or another container of numbers.
template <class Matrix> nb::object array_of_matrix(Matrix&& m) {
  using Owner = std::decay_t<Matrix>;
  auto* const owner = new Owner(std::forward<Matrix>(m));
  const nb::capsule capsule(owner, [](void* p) noexcept { delete static_cast<Owner*>(p); });
  const auto rows = static_cast<std::size_t>(owner->rows()),
             columns = static_cast<std::size_t>(owner->cols());
  if constexpr(Owner::ColsAtCompileTime == 1)
    return nb::cast(nb::ndarray<nb::numpy, double>(owner->data(), {rows}, capsule));
  else
    return nb::cast(nb::ndarray<nb::numpy, double>(owner->data(), {rows, columns}, capsule,
                                                   {1, static_cast<std::int64_t>(rows)}));
}

// the same for `width` numbers of each of a list, row after row
template <class T> nb::object array_of_rows(std::vector<T>&& values, std::size_t width) {
  auto* const owner = new std::vector<T>(std::move(values));
  const nb::capsule capsule(owner,
                            [](void* p) noexcept { delete static_cast<std::vector<T>*>(p); });
  if(width == 1)
    return nb::cast(nb::ndarray<nb::numpy, T>(owner->data(), {owner->size()}, capsule));
  return nb::cast(
      nb::ndarray<nb::numpy, T>(owner->data(), {owner->size() / width, width}, capsule));
}

// a copy, column by column
inline Eigen::MatrixXd matrix_of(const Rows& a) {
  using Row_major = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  return Eigen::Map<const Row_major>(a.data(), static_cast<Eigen::Index>(a.shape(0)),
                                     static_cast<Eigen::Index>(a.shape(1)));
}

// (values, indices, starts, shape) of the columns of a sparse matrix, without a copy
nb::tuple sparse_arrays(RL::Sparse_matrix&& m);

// a report as a dictionary
nb::dict report_of(const RL::Solve_report& report);

// What Python hears while the library works, and says: Ctrl-C, and what a callback raises, end it.
class Listener {
public:
  // `progress` is None, or is called with the part that is done, from 0 to 1; ends the work if it
  // returns False
  explicit Listener(nb::object progress) : m_progress(std::move(progress)) {}

  std::function<bool(double)> callback() {
    return [this](double done) { return hear(done); };
  }
  // raises what was raised; returns if nothing was
  void rethrow() const {
    if(m_raised)
      std::rethrow_exception(m_raised);
  }

private:
  bool hear(double done) {
    const nb::gil_scoped_acquire lock;
    try {
      if(PyErr_CheckSignals() != 0)
        throw nb::python_error();
      return m_progress.is_none() || !m_progress(done).is(nb::bool_(false));
    } catch(...) {
      m_raised = std::current_exception();
      return false;
    }
  }

  nb::object m_progress;
  std::exception_ptr m_raised;
};

// Runs `work(callback)` without the lock of the interpreter on so many threads, 0 for all. It must
// not touch an object of Python, not even read a dictionary, nor return one.
template <class Work> auto run(int threads, const nb::object& progress, Work&& work) {
  Listener listener(progress);
  try {
    const nb::gil_scoped_release release;
#ifdef CGAL_LINKED_WITH_TBB
    tbb::task_arena arena(threads > 0 ? threads : tbb::info::default_concurrency());
    return arena.execute([&] { return work(listener.callback()); });
#else
    static_cast<void>(threads);
    return work(listener.callback());
#endif
  } catch(...) {
    listener.rethrow();
    throw;
  }
}

// parts of the module
void add_distances(nb::module_& m);
void add_flows(nb::module_& m);
void add_surfaces(nb::module_& m);
void add_problems(nb::module_& m);
void add_spectra(nb::module_& m);
void add_textures(nb::module_& m);
void add_views(nb::module_& m);

} // namespace python

#endif // RESTRICTED_LAPLACIAN_3_PYTHON_MODULE_H

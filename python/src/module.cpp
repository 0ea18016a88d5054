// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "module.h"

#include <CGAL/Restricted_laplacian_3/files/File_error.h>
#include <CGAL/Restricted_laplacian_3/version.h>

#include <CGAL/assertions.h>
#include <CGAL/assertions_behaviour.h>

#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

namespace python {
namespace {

// raises an exception of the package: its class, what it says, and what it names
void raise(const char* type, const std::exception& e, const char* name, const nb::object& value) {
  nb::module_ errors = nb::module_::import_("restricted_laplacian._errors");
  nb::object error = errors.attr("make_error")(type, e.what(), name, value);
  PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(error.ptr())), error.ptr());
}

void translate(const std::exception_ptr& p, void*) {
  try {
    std::rethrow_exception(p);
  } catch(const RL::Invalid_face_error& e) {
    raise("InputError", e, "face", nb::int_(e.face()));
  } catch(const RL::Invalid_vertex_error& e) {
    raise("InputError", e, "vertex", nb::int_(e.vertex()));
  } catch(const RL::Invalid_point_error& e) {
    raise("InputError", e, "vertex", nb::int_(e.point()));
  } catch(const RL::File_error& e) {
    const RL::File_place& place = e.place();
    if(place.vertex)
      raise("InputError", e, "vertex", nb::int_(*place.vertex));
    else if(place.face)
      raise("InputError", e, "face", nb::int_(*place.face));
    else
      raise("InputError", e, "", nb::none());
  } catch(const RL::Parameter_error& e) {
    raise("InputError", e, "argument", nb::str(e.parameter().c_str()));
  } catch(const RL::Input_error& e) {
    raise("InputError", e, "", nb::none());
  } catch(const RL::Canceled& e) {
    raise("Canceled", e, "", nb::none());
  }
}

} // namespace

nb::tuple sparse_arrays(RL::Sparse_matrix&& m) {
  m.makeCompressed();
  auto* const owner = new RL::Sparse_matrix(std::move(m));
  const nb::capsule capsule(owner,
                            [](void* p) noexcept { delete static_cast<RL::Sparse_matrix*>(p); });
  const auto size = static_cast<std::size_t>(owner->nonZeros()),
             outer = static_cast<std::size_t>(owner->outerSize());
  const auto numbers = [&](auto* data, std::size_t n) {
    using T = std::remove_pointer_t<decltype(data)>;
    return nb::cast(nb::ndarray<nb::numpy, T>(data, {n}, capsule));
  };
  return nb::make_tuple(numbers(owner->valuePtr(), size), numbers(owner->innerIndexPtr(), size),
                        numbers(owner->outerIndexPtr(), outer + 1), owner->rows(), owner->cols());
}

nb::dict report_of(const RL::Solve_report& r) {
  nb::dict result;
  result["converged"] = r.converged;
  result["status"] = to_string(r.status);
  result["iterations"] = r.iterations;
  result["relative_residual"] = r.relative_residual;
  result["relative_energy_error"] = r.relative_energy_error;
  result["constraint_error"] = r.constraint_error;
  result["estimated_error"] = r.estimated_error;
  result["is_estimate_trusted"] = r.is_estimate_trusted;
  result["assembly_seconds"] = r.assembly_seconds;
  result["setup_seconds"] = r.setup_seconds;
  result["solve_seconds"] = r.solve_seconds;
  return result;
}

} // namespace python

NB_MODULE(_core, m) {
  m.attr("__version__") = CGAL_RESTRICTED_LAPLACIAN_3_VERSION;
  // CGAL prints when a check fails, before it throws; the exception says it all
  CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {});
  CGAL::set_warning_handler([](const char*, const char*, const char*, int, const char*) {});
  nanobind::register_exception_translator(python::translate);
  python::add_surfaces(m);
  python::add_distances(m);
  python::add_problems(m);
  python::add_flows(m);
  python::add_spectra(m);
  python::add_textures(m);
  python::add_views(m);
}

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Whichever allocation fails, the caller gets std::bad_alloc, and no memory is lost. A program of
// its own, because it replaces the allocation functions: `operator new`, and by an option of the
// linker `malloc()` and its kin, which Eigen calls.

#include "catch.h"
#include "shapes.h"

#include <CGAL/Restricted_laplacian_3/fit_function.h>
#include <CGAL/Restricted_laplacian_3/laplace_spectrum.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>

#include <boost/property_map/property_map.hpp>

#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <new>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

/// allocations until one fails, if not negative; blocks in use
long countdown = -1, blocks = 0;

/// whether this is the allocation that has to fail
bool fails() { return countdown >= 0 && countdown-- == 0; }

} // namespace

extern "C" {
void* __real_malloc(std::size_t size);
void* __real_calloc(std::size_t number, std::size_t size);
void* __real_realloc(void* p, std::size_t size);
int __real_posix_memalign(void** p, std::size_t alignment, std::size_t size);
void __real_free(void* p);

void* __wrap_malloc(std::size_t size) {
  void* const result = fails() ? nullptr : __real_malloc(size);
  blocks += result != nullptr;
  return result;
}
void* __wrap_calloc(std::size_t number, std::size_t size) {
  void* const result = fails() ? nullptr : __real_calloc(number, size);
  blocks += result != nullptr;
  return result;
}
void* __wrap_realloc(void* p, std::size_t size) {
  void* const result = fails() ? nullptr : __real_realloc(p, size);
  blocks += p == nullptr && result != nullptr;
  return result;
}
int __wrap_posix_memalign(void** p, std::size_t alignment, std::size_t size) {
  const int error = fails() ? ENOMEM : __real_posix_memalign(p, alignment, size);
  blocks += error == 0;
  return error;
}
void __wrap_free(void* p) {
  blocks -= p != nullptr;
  __real_free(p);
}
}

// All other forms of the operators call these, but for those with an alignment.
void* operator new(std::size_t size) {
  if(void* const result = __wrap_malloc(size > 0 ? size : 1))
    return result;
  throw std::bad_alloc();
}
void operator delete(void* p) noexcept { __wrap_free(p); }
void operator delete(void* p, std::size_t) noexcept { __wrap_free(p); }

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;

double z(const RL::Surface_point& p) { return p.point.z(); }

} // namespace

TEST_CASE("any_allocation_may_fail", "[memory]") {
  using Solve = std::function<std::vector<double>()>;
  const shapes::Triangles t = shapes::box(1, 0.7, 0.4, 2, 1);
  const auto map = [](std::vector<double>& values) {
    return boost::make_iterator_property_map(values.begin(),
                                             boost::typed_identity_property_map<std::size_t>());
  };
  const auto depth = params::depth(3);
  const auto spectrum = [&](RL::Eigensolver solver) {
    const RL::Spline_space_3 space(RL::soup(t.points, t.faces), depth);
    const RL::Laplace_spectrum result = RL::laplace_spectrum(space, 4, params::eigensolver(solver));
    return std::vector<double>(result.eigenvalues.begin(), result.eigenvalues.end());
  };
  const std::vector<std::pair<std::string, Solve>> cases = {
      {"solve_poisson",
       [&] {
         std::vector<double> u(t.points.size());
         static_cast<void>(RL::solve_poisson(RL::soup(t.points, t.faces), z, map(u), depth));
         return u;
       }},
      {"fit_function",
       [&] {
         const RL::Spline_space_3 space(RL::soup(t.points, t.faces), depth);
         return RL::Function_fitter(space).fit(z).root_mean_square_errors;
       }},
      {"shift_invert", [&] { return spectrum(RL::Eigensolver::shift_invert); }},
      {"multigrid", [&] { return spectrum(RL::Eigensolver::multigrid); }}};
  // All of them, if the environment says so; else the first ones, and then ever larger steps.
  const char* const wants_all = std::getenv("RESTRICTED_LAPLACIAN_3_FAIL_ALL_ALLOCATIONS");
  std::set<std::string> steps;
  for(const auto& [name, solve] : cases) {
    const std::vector<double> expected = solve(); // and what is computed once for all times
    long failures = 0;
    bool has_failed = true;
    for(long number = 0; has_failed; number += wants_all ? 1 : 1 + number / 20) {
      std::vector<double> values;
      std::string error;
      const char* step = "";
      const long blocks_before = blocks;
      countdown = number;
      try {
        values = solve();
      } catch(const std::bad_alloc& e) {
        error = "bad_alloc";
        step = e.what();
      } catch(...) {
        error = "something else";
      }
      has_failed = countdown < 0;
      countdown = -1;
      const long blocks_left = blocks - blocks_before - (values.empty() ? 0 : 1);
      INFO(name << ", allocation " << number << " fails");
      failures += error == "bad_alloc";
      // Some algorithms of the standard library do without the memory that they do not get.
      REQUIRE((error == "bad_alloc" || (error.empty() && values == expected)));
      REQUIRE(blocks_left == 0);
      steps.insert(step);
    }
    INFO(name);
    CHECK(failures >= 50);
  }
  // steps of few allocations may have been passed over
  for(const char* step : {"the surface", "the octree", "the elements of the space", "the matrices",
                          "the multigrid solver", "the iteration", "the eigenvectors"}) {
    INFO(step);
    CHECK(steps.count(std::string("not enough memory for ") + step) == 1);
  }
}

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_FUNCTION_VIEW_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_FUNCTION_VIEW_H

#include <memory>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

template <class Signature> class Function_view;

/// Refers to a function object of any type, which must outlive it: the argument of functions that
/// are compiled once and call back. Costs a pointer and one indirect call, and allocates nothing.
template <class Result, class... Arguments> class Function_view<Result(Arguments...)> {
public:
  template <class Function,
            std::enable_if_t<!std::is_same_v<std::decay_t<Function>, Function_view>, int> = 0>
  Function_view(Function&& f)
    : m_function(const_cast<void*>(static_cast<const void*>(std::addressof(f)))),
      m_call([](void* function, Arguments... arguments) -> Result {
        return (*static_cast<std::remove_reference_t<Function>*>(function))(
            std::forward<Arguments>(arguments)...);
      }) {}

  Result operator()(Arguments... arguments) const {
    return m_call(m_function, std::forward<Arguments>(arguments)...);
  }

private:
  void* m_function;
  Result (*m_call)(void*, Arguments...);
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_FUNCTION_VIEW_H

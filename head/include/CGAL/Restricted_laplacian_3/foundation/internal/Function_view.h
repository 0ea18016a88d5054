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

/// The address of a function object, or of a function: compilers that have shared libraries convert
/// the address of a function to that of an object and back.
template <class Function> const void* address_of(const Function& f) {
  if constexpr(std::is_function_v<Function>)
    return reinterpret_cast<const void*>(std::addressof(f));
  else
    return std::addressof(f);
}

/// The function object of the address, see `address_of()`.
template <class Function> const Function& function_at(const void* address) {
  if constexpr(std::is_function_v<Function>)
    return *reinterpret_cast<Function*>(const_cast<void*>(address));
  else
    return *static_cast<const Function*>(address);
}

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

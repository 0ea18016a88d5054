// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_TEST_CATCH_H
#define RESTRICTED_LAPLACIAN_3_TEST_CATCH_H

/// \file
/// The one place that includes Catch2, of version 2 or 3. Tests marked `[slow]` do not run under
/// the sanitizers.

#if __has_include(<catch2/catch_test_macros.hpp>)
#include <catch2/catch_approx.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <string>

using Catch::Approx;

namespace Catch {

inline Matchers::StringContainsMatcher Contains(const std::string& text) {
  return Matchers::ContainsSubstring(text);
}

} // namespace Catch
#else
#include <catch2/catch.hpp>
#endif

/// whether the test that is running has left something out
inline bool& is_skipped() {
  static bool result = false;
  return result;
}

/// Says that a part of a test cannot run here. CTest then reports the test as skipped, unless one
/// of its other checks fails.
#define SKIP_PART(reason)                                                                          \
  do {                                                                                             \
    WARN("SKIPPED: " << reason);                                                                   \
    SUCCEED(); /* a test without any check fails */                                                \
    is_skipped() = true;                                                                           \
  } while(false)

/// Leaves a test that cannot run here.
#define SKIP_TEST(reason)                                                                          \
  do {                                                                                             \
    SKIP_PART(reason);                                                                             \
    return;                                                                                        \
  } while(false)

#endif // RESTRICTED_LAPLACIAN_3_TEST_CATCH_H

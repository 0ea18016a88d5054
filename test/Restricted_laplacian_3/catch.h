// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_TEST_CATCH_H
#define RESTRICTED_LAPLACIAN_3_TEST_CATCH_H

/// \file
/// The one place that includes Catch2. Tests marked `[slow]` do not run under the sanitizers.

#include <catch2/catch.hpp>

/// how often a test was left by `SKIP_TEST()`
inline int& number_of_skips() {
  static int number = 0;
  return number;
}

/// Leaves a test that cannot run here. `main()` tells CTest by its exit status.
#define SKIP_TEST(reason)                                                                          \
  do {                                                                                             \
    WARN("SKIPPED: " << reason);                                                                   \
    SUCCEED();                                                                                     \
    ++number_of_skips();                                                                           \
    return;                                                                                        \
  } while(false)

#endif // RESTRICTED_LAPLACIAN_3_TEST_CATCH_H

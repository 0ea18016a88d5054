// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_TEST_CATCH_H
#define RESTRICTED_LAPLACIAN_3_TEST_CATCH_H

/// \file
/// The one place that includes Catch2. Tests marked `[slow]` do not run under the sanitizers.

#include <catch2/catch.hpp>

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
    is_skipped() = true;                                                                           \
  } while(false)

/// Leaves a test that cannot run here.
#define SKIP_TEST(reason)                                                                          \
  do {                                                                                             \
    SKIP_PART(reason);                                                                             \
    SUCCEED();                                                                                     \
    return;                                                                                        \
  } while(false)

#endif // RESTRICTED_LAPLACIAN_3_TEST_CATCH_H

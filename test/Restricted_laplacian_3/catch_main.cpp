// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#define CATCH_CONFIG_RUNNER
#include "catch.h"

namespace {

int number_of_tests = 0;

struct Test_counter : Catch::TestEventListenerBase {
  using TestEventListenerBase::TestEventListenerBase;
  void testCaseStarting(const Catch::TestCaseInfo&) override { ++number_of_tests; }
};

} // namespace

CATCH_REGISTER_LISTENER(Test_counter)

/// Returns 0 if all went well, 4 if no test failed but all were skipped (the number that Catch2
/// version 3 returns then), else 1.
int main(int argc, char* argv[]) {
  const int result = Catch::Session().run(argc, argv);
  if(result != 0)
    return 1;
  return number_of_tests > 0 && number_of_skips() >= number_of_tests ? 4 : 0;
}

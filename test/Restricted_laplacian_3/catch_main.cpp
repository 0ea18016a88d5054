// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#define CATCH_CONFIG_RUNNER
#include "catch.h"

namespace {

int number_of_tests = 0, number_of_skipped_tests = 0;

struct Test_counter : Catch::TestEventListenerBase {
  using TestEventListenerBase::TestEventListenerBase;
  void testCaseStarting(const Catch::TestCaseInfo&) override {
    ++number_of_tests;
    is_skipped() = false;
  }
  void testCaseEnded(const Catch::TestCaseStats&) override {
    number_of_skipped_tests += is_skipped();
  }
};

} // namespace

CATCH_REGISTER_LISTENER(Test_counter)

/// Returns 0 if all went well, 4 if no test failed but all were skipped, or parts of them (the
/// number that Catch2 version 3 returns then), else 1. A test without an assertion fails, and so
/// does a run without a test; the command line takes only one of these two warnings.
int main(int argc, char* argv[]) {
  Catch::Session session;
  session.configData().warnings = static_cast<Catch::WarnAbout::What>(
      Catch::WarnAbout::NoAssertions | Catch::WarnAbout::NoTests);
  if(session.run(argc, argv) != 0)
    return 1;
  return number_of_tests > 0 && number_of_skipped_tests == number_of_tests ? 4 : 0;
}

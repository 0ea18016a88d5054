// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_TEST_CATCH_COUNTER_H
#define RESTRICTED_LAPLACIAN_3_TEST_CATCH_COUNTER_H

// For the source of a test program that has its main(): counts tests, and those that are skipped.

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

/// Runs the tests of the command line; returns whether all went well. A test without an assertion
/// fails, and so does a run without a test; the command line takes only one of these two warnings.
inline bool run_tests(int argc, char* argv[]) {
  Catch::Session session;
  session.configData().warnings = static_cast<Catch::WarnAbout::What>(
      Catch::WarnAbout::NoAssertions | Catch::WarnAbout::NoTests);
  return session.run(argc, argv) == 0;
}

/// The exit status of a run: 4 if all tests were skipped, or parts of them (the number that Catch2
/// version 3 returns then).
inline int exit_status(bool is_right) {
  if(!is_right)
    return 1;
  return number_of_tests > 0 && number_of_skipped_tests == number_of_tests ? 4 : 0;
}

#endif // RESTRICTED_LAPLACIAN_3_TEST_CATCH_COUNTER_H

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_TEST_CATCH_COUNTER_H
#define RESTRICTED_LAPLACIAN_3_TEST_CATCH_COUNTER_H

// For the source of a test program that has its main(): counts tests, and those that are skipped.

#define CATCH_CONFIG_RUNNER
#include "catch.h"

#if __has_include(<catch2/catch_session.hpp>)
#include <catch2/catch_session.hpp>
#include <catch2/reporters/catch_reporter_event_listener.hpp>
#include <catch2/reporters/catch_reporter_registrars.hpp>

namespace {
using Test_listener = Catch::EventListenerBase;
constexpr int test_warnings = Catch::WarnAbout::NoAssertions; // a run without a test fails anyway
} // namespace
#else
namespace {
using Test_listener = Catch::TestEventListenerBase;
constexpr int test_warnings = Catch::WarnAbout::NoAssertions | Catch::WarnAbout::NoTests;
} // namespace
#endif

namespace {

int number_of_tests = 0, number_of_skipped_tests = 0;

struct Test_counter : Test_listener {
  using Test_listener::Test_listener;
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
  session.configData().warnings = static_cast<Catch::WarnAbout::What>(test_warnings);
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

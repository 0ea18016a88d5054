// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The main program of tests that run on several processes: each runs all of them, and prints what
// fails. Returns 0 if all went well on all, 4 if all tests were skipped, or parts of them, else 1.

#define CATCH_CONFIG_RUNNER
#include "../catch.h"

#include <CGAL/Restricted_laplacian_3/distributed/Communicator.h>

#include <petscsys.h>

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

int main(int argc, char* argv[]) {
  MPI_Init(&argc, &argv);
  if(PetscInitialize(&argc, &argv, nullptr, nullptr) != 0)
    return 1;
  int result = 1;
  {
    Catch::Session session;
    session.configData().warnings = static_cast<Catch::WarnAbout::What>(
        Catch::WarnAbout::NoAssertions | Catch::WarnAbout::NoTests);
    const CGAL::Restricted_laplacian_3::Communicator communicator;
    const bool is_right = communicator.minimum(session.run(argc, argv) == 0 ? 1 : 0) == 1;
    if(is_right)
      result = number_of_tests > 0 && number_of_skipped_tests == number_of_tests ? 4 : 0;
  }
  PetscFinalize();
  MPI_Finalize();
  return result;
}

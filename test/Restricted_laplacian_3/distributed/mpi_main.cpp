// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The main program of tests that run on several processes: each runs all of them, and prints what
// fails. They have gone well if they have on all processes.

#include "../catch_counter.h"

#include <CGAL/Restricted_laplacian_3/distributed/Communicator.h>

#include <slepcsys.h>

int main(int argc, char* argv[]) {
  MPI_Init(&argc, &argv);
  if(SlepcInitialize(&argc, &argv, nullptr, nullptr) != 0)
    return 1;
  const CGAL::Restricted_laplacian_3::Communicator communicator;
  const int status = exit_status(communicator.minimum(run_tests(argc, argv) ? 1 : 0) == 1);
  SlepcFinalize();
  MPI_Finalize();
  return status;
}

// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch_counter.h"

int main(int argc, char* argv[]) { return exit_status(run_tests(argc, argv)); }

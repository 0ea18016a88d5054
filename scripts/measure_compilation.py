#!/usr/bin/env python3
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Calls a compiler, and adds a line to a file: seconds of the processor, largest memory in MiB, what
was compiled.

usage: measure_compilation.py FILE COMPILER ARGUMENT...

As CMAKE_CXX_COMPILER_LAUNCHER it measures a whole build."""

import os
import resource
import sys

log, *command = sys.argv[1:]
child = os.posix_spawnp(command[0], command, os.environ)
status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
used = resource.getrusage(resource.RUSAGE_CHILDREN)
if "-o" in command:
    what = os.path.abspath(command[command.index("-o") + 1])
else:
    what = " ".join(command)
with open(log, "a", encoding="utf-8") as file:
    seconds = used.ru_utime + used.ru_stime
    file.write("%.1f %.0f %s\n" % (seconds, used.ru_maxrss / 1024, what))
sys.exit(status if status >= 0 else 128 - status)

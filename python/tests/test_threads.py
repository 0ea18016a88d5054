# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Threads, interruptions, progress."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import restricted_laplacian as rl


def test_results_do_not_depend_on_threads(sphere):
    V, F = sphere
    one = rl.eigs(V, F, 6, threads=1)
    two = rl.eigs(V, F, 6, threads=2)
    assert np.array_equal(one[0], two[0]) and np.array_equal(one[1], two[1])

    def f(p):
        return np.exp(p[:, 0])

    assert np.array_equal(rl.solve_poisson(V, F, f, threads=1), rl.solve_poisson(V, F, f))


def test_two_threads_solve_at_once(sphere):
    V, F = sphere
    functions = [lambda p: p[:, 0] ** 2, lambda p: np.sin(p[:, 1])]
    expected = [rl.solve_poisson(V, F, f) for f in functions]
    found = [None, None]

    def work(i):
        for _ in range(4):
            found[i] = rl.solve_poisson(V, F, functions[i])

    threads = [threading.Thread(target=work, args=(i,)) for i in range(2)]
    for t in threads:
        t.start()
    for t in threads:
        t.join()
    assert all(np.array_equal(a, b) for a, b in zip(found, expected))


def test_the_interpreter_goes_on():
    V, F = rl.icosphere(6)
    counts = []
    done = threading.Event()

    def count():
        n = 0
        while not done.is_set():
            n += 1
            time.sleep(0.001)
        counts.append(n)

    thread = threading.Thread(target=count)
    thread.start()
    start = time.monotonic()
    rl.eigs(V, F, 20, depth=5, threads=1)
    seconds = time.monotonic() - start
    done.set()
    thread.join()
    assert counts[0] > 100 * seconds


def test_progress(sphere, capfd):
    V, F = sphere
    parts = []
    rl.solve_poisson(V, F, V[:, 2], tolerance=1e-8, progress=parts.append)
    assert len(parts) > 3 and parts == sorted(parts) and 0 <= parts[0] and parts[-1] <= 1
    rl.eigs(V, F, 5, progress=True)
    assert "%" in capfd.readouterr().err
    rl.eigs(V, F, 5)
    out = capfd.readouterr()
    assert out.out == "" and out.err == ""
    with pytest.raises(rl.Canceled):
        rl.solve_poisson(V, F, V[:, 2], progress=lambda part: part < 0.5)
    with pytest.raises(ZeroDivisionError):
        rl.solve_poisson(V, F, V[:, 2], progress=lambda part: 1 / 0)


@pytest.mark.skipif(os.name != "posix", reason="signals of POSIX")
@pytest.mark.parametrize("threads", [1, 2])
def test_interrupts_end_a_solve(threads):
    program = f"""
import signal, restricted_laplacian as rl
# a shell that starts commands in the background lets them ignore interrupts
signal.signal(signal.SIGINT, signal.default_int_handler)
V, F = rl.icosphere(6)
space = rl.Space(V, F, depth=6, threads={threads})
print("begin", flush=True)
try:
    while True:
        rl.eigs(space, None, 200, tolerance=1e-9)
except KeyboardInterrupt:
    print("interrupted", flush=True)
"""
    process = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True)
    assert process.stdout.readline() == "begin\n"
    time.sleep(1)
    start = time.monotonic()
    process.send_signal(signal.SIGINT)
    out, _ = process.communicate(timeout=30)
    seconds = time.monotonic() - start
    assert out == "interrupted\n" and process.returncode == 0
    assert seconds < 3  # one on a machine that does nothing else

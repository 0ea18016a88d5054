#!/usr/bin/env python3
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What functions take beside other work: busy_machine.py FOLDER [MESH]

FOLDER holds the meshes, MESH is the name of one without .ply. Needs the package itself only.

A line for each function of the package: seconds in a process that has the machine to itself; beside
processes that do nothing but use a processor, three for two processors, as a ratio to that; and of two
processes at once that do the same, as a ratio to one after the other. Each number is the median over
processes, in which the function runs once before; all at default settings, that is with all threads.
"""

import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import restricted_laplacian as rl
from restricted_laplacian import learning
from support.peers import arguments, print_header

PROCESSES = 3
SECONDS = 1.0  # for which a function is repeated, at least


def functions(folder, name):
    """Functions of the package by their names, for a mesh; none of them keeps anything."""
    V, F = rl.read_mesh(folder / f"{name}.ply")
    x = V[:, 0]
    scans = [rl.Scan(V, F, colors=abs(V) / abs(V).max(), viewpoint=5 * v)
             for v in (V.max(axis=0), V.min(axis=0))]

    def precompute_folder():
        with tempfile.TemporaryDirectory() as cache:
            with tempfile.TemporaryDirectory() as meshes:
                for i in range(4):
                    (pathlib.Path(meshes) / f"{i}.ply").write_bytes(
                        (folder / f"{name}.ply").read_bytes() + b"\n" * i)
                assert len(learning.precompute_folder(meshes, cache, 64)) == 4

    return {
        "solve_poisson": lambda: rl.solve_poisson(V, F, x),
        "solve_screened_poisson": lambda: rl.solve_screened_poisson(V, F, x, 1),
        "fit_function": lambda: rl.fit_function(V, F, x),
        "curvature": lambda: rl.curvature(V, F),
        "integrate_gradient": lambda: rl.integrate_gradient(V, F, lambda p: p),
        "stitch_colors": lambda: rl.stitch_colors(V, F, scans),
        "laplace_spectrum(k=20)": lambda: rl.laplace_spectrum(V, F, 20),
        "laplace_spectrum(k=64,depth=4)": lambda: rl.laplace_spectrum(V, F, 64, depth=4),
        "laplace_spectrum(eigensolver=shift-invert)":
            lambda: rl.laplace_spectrum(V, F, 20, depth=5, eigensolver="shift-invert"),
        "geodesic_distance": lambda: rl.geodesic_distance(V, F, 0),
        "geodesic_distance(exact=True)": lambda: rl.geodesic_distance(V, F, 0, exact=True),
        "precompute": lambda: learning.precompute(V, F, 64),
        "precompute_folder": precompute_folder,
    }


def measure(folder, mesh, name):
    """Seconds, in this process."""
    function = functions(folder, mesh)[name]
    function()
    begin, number = time.perf_counter(), 0
    while number == 0 or time.perf_counter() - begin < SECONDS:
        function()
        number += 1
    return (time.perf_counter() - begin) / number


def start(*command):
    # as users have it: nothing but the package itself bounds the threads of BLAS libraries
    environment = {k: v for k, v in os.environ.items() if not k.endswith("_NUM_THREADS")}
    return subprocess.Popen([sys.executable, *command], stdout=subprocess.PIPE, text=True,
                            env=environment)


def seconds(folder, mesh, name, at_once=1):
    """Seconds of processes of their own, the longest of those that run at once."""
    processes = [start(__file__, str(folder), mesh, "--function", name) for _ in range(at_once)]
    results = [(p.communicate()[0], p.returncode) for p in processes]
    if any(code for _, code in results):
        raise RuntimeError(f"{name} failed")
    return max(float(text) for text, _ in results)


def main():
    if "--function" in sys.argv:
        folder, mesh, _, name = sys.argv[1:]
        print(measure(pathlib.Path(folder), mesh, name))
        return
    o = arguments(__doc__, ["anchor_8k"])
    print_header("busy_machine", o.mesh, ["numpy"])
    print(f"# {'function':42} {'alone_s':>8} {'busy':>6} {'two':>6}", flush=True)
    for mesh in o.mesh:
        for name in functions(o.folder, mesh):
            def median(**options):
                return statistics.median(seconds(o.folder, mesh, name, **options)
                                         for _ in range(PROCESSES))
            alone = median()
            two = median(at_once=2)
            others = [start("-c", "while True: pass") for _ in range((os.cpu_count() or 1) * 3 // 2)]
            try:
                busy = median()
            finally:
                for process in others:
                    process.kill()
                    process.wait()
            print(f"{name:44} {alone:8.3f} {busy / alone:6.2f} "
                  f"{two / (2 * alone):6.2f}", flush=True)


if __name__ == "__main__":
    main()

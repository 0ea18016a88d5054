#!/usr/bin/env python3
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Ordinary shapes in all sizes, through all applications, idle and beside other work.

usage: shape_study.py shapes [FAMILY]... | shape_study.py meshes FOLDER...

shapes: all of ordinary_shapes.py among the tests of the Python package, or families whose names begin so,
at default settings. A line for each family, its placements together, and application: trials, how many are
wrong, the largest error over what is allowed, the longest time and the most memory, how much the worst
size is above the line through the others, and the largest ratio of the time beside processes that do
nothing but use a processor, three for two processors, to that without. Times below 0.05 s and memory below
20 MiB count as that much in ratios.

meshes: the spectra of all meshes in folders, at depths 4 to 7, of 7 to 128 pairs.

The exit status is 0 if nothing is wrong, no ratio to a line is above 10 and none to idle times above 6.
"""

import functools
import os
import pathlib
import pickle
import subprocess
import sys

import numpy as np

import restricted_laplacian as rl
from support.peers import print_header

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "python" / "tests"))
import ordinary_shapes as ordinary  # noqa: E402

LARGEST_TO_LINE, LARGEST_BUSY = 10, 6
LEAST_SECONDS, LEAST_MEBIBYTES = 0.05, 20
DEPTHS, PAIRS = (4, 5, 6, 7), (7, 20, 31, 64, 128)


def to_line(sizes, values, least):
    """The largest ratio of a value to the line through the others, which neither falls nor begins
    below 0."""
    worst = 0.0
    values = np.maximum(values, least)
    for i in range(len(sizes)):
        others = np.arange(len(sizes)) != i
        if others.sum() < 3:
            return float("nan")
        x, y = np.asarray(sizes, float)[others], values[others]
        A = np.stack([np.ones(len(x)), x], 1) / y[:, None]
        a, b = np.linalg.lstsq(A, np.ones(len(x)), rcond=None)[0]
        if b < 0:
            a, b = y.mean(), 0.0
        elif a < 0:
            a, b = 0.0, (x / y).sum() / (x / y * x / y).sum()
        worst = max(worst, values[i] / max(a + b * sizes[i], least))
    return worst


def unknowns(shape):
    return rl.Space(shape.V, shape.F).dimension


def busy_processes():
    return [subprocess.Popen([sys.executable, "-c", "while True: pass"])
            for _ in range((os.cpu_count() or 1) * 3 // 2)]


def study_shapes(families):
    makers = ordinary.all_shapes()
    shapes = [make() for make in makers]
    shapes = [s for s in shapes if not families or s.family.startswith(tuple(families))]
    applications = list(ordinary.APPLICATIONS)
    ordinary.APPLICATIONS["unknowns"] = unknowns
    sizes_of = {id(s): ordinary.run(s, "unknowns").error for s in shapes}
    trials = {}
    for is_busy in (False, True):
        others = busy_processes() if is_busy else []
        try:
            for shape in shapes:
                for application in applications:
                    if ordinary.applies(application, shape):
                        trial = ordinary.run(shape, application)
                        trials[shape.family, application, shape.placement, shape.size, is_busy] = shape, trial
                        if not trial.is_right:
                            print(f"# {shape.name} {application}{' busy' * is_busy}: {trial}", flush=True)
        finally:
            for process in others:
                process.kill()
                process.wait()
    print(f"# {'family':20} {'application':16} {'trials':>6} {'wrong':>5} {'error':>8} {'seconds':>8} "
          f"{'MiB':>6} {'time/line':>9} {'MiB/line':>8} {'busy':>6}")
    is_fine = True
    for family in dict.fromkeys(s.family for s in shapes):
        for application in applications:
            of = {key: value for key, value in trials.items() if key[:2] == (family, application)}
            if not of:
                continue
            idle = {key: value for key, value in of.items() if not key[4]}
            time_ratio = memory_ratio = busy = 0.0
            for placement in dict.fromkeys(key[2] for key in idle):
                row = [value for key, value in idle.items() if key[2] == placement]
                sizes = [len(s.V) if "distance" in application else sizes_of[id(s)] for s, _ in row]
                time_ratio = max(time_ratio, to_line(sizes, [t.seconds for _, t in row], LEAST_SECONDS))
                memory_ratio = max(memory_ratio, to_line(sizes, [t.mebibytes for _, t in row],
                                                         LEAST_MEBIBYTES))
            for key, (_, trial) in idle.items():
                busy = max(busy, max(of[(*key[:4], True)][1].seconds, LEAST_SECONDS)
                           / max(trial.seconds, LEAST_SECONDS))
            wrong = sum(not t.is_right for _, t in of.values())
            is_fine &= not wrong and not max(time_ratio, memory_ratio) > LARGEST_TO_LINE and busy <= LARGEST_BUSY
            print(f"{family:22} {application:16} {len(of):6d} {wrong:5d} "
                  f"{max(t.error for _, t in of.values()):8.2g} "
                  f"{max(t.seconds for _, t in idle.values()):8.3f} "
                  f"{max(t.mebibytes for _, t in idle.values()):6.0f} {time_ratio:9.2f} {memory_ratio:8.2f} "
                  f"{busy:6.2f}", flush=True)
    return is_fine


def spectrum_of(depth, k, shape):
    values = rl.eigs(shape.V, shape.F, k, depth=depth)[0]
    return 0.0 if len(values) == k and np.isfinite(values).all() else float("nan")


def study_meshes(folders):
    files = sorted((f for folder in folders for f in pathlib.Path(folder).iterdir()
                    if f.suffix in (".ply", ".off", ".obj")), key=lambda f: (f.stat().st_size, f.name))
    number = wrong = 0
    longest = 0.0
    print(f"# {'spectra':24} {'runs':>5} {'wrong':>5} {'longest_s':>9}")
    for file in files:
        reading = subprocess.run(
            [sys.executable, "-c", "import pickle, sys, restricted_laplacian as rl\n"
             "pickle.dump(rl.read_mesh(sys.argv[1]), sys.stdout.buffer)", str(file)], capture_output=True)
        if reading.returncode:
            print(f"# {file.name} cannot be read")
            continue
        shape = ordinary.Shape(file.name, 0, *pickle.loads(reading.stdout))
        of_mesh = wrong_of_mesh = 0
        for depth in DEPTHS:
            for k in PAIRS:
                name = f"eigs, depth {depth}, {k} pairs"
                ordinary.APPLICATIONS[name] = functools.partial(spectrum_of, depth, k)
                trial = ordinary.run(shape, name, seconds=3600, gibibytes=16)
                of_mesh += 1
                longest = max(longest, trial.seconds)
                if not trial.is_right:
                    wrong_of_mesh += 1
                    print(f"# {file.name}, {name}: {trial}", flush=True)
        number, wrong = number + of_mesh, wrong + wrong_of_mesh
        print(f"{file.name:26} {of_mesh:5d} {wrong_of_mesh:5d} {longest:9.1f}", flush=True)
    print(f"{'all':26} {number:5d} {wrong:5d} {longest:9.1f}")
    return number > 0 and wrong == 0


def main():
    if len(sys.argv) < 2 or sys.argv[1] not in ("shapes", "meshes"):
        print(__doc__)
        return 2
    print_header("shape_study", sys.argv[1:2], ["numpy"])
    study = study_shapes if sys.argv[1] == "shapes" else study_meshes
    return 0 if study(sys.argv[2:]) else 1


if __name__ == "__main__":
    sys.exit(main())

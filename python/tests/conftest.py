# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Meshes and programs that tests use. What is missing makes tests skip, and say so."""

from __future__ import annotations

import os
import pathlib

import numpy as np
import pytest

import restricted_laplacian as rl


def read_off(path: pathlib.Path) -> tuple[np.ndarray, np.ndarray]:
    """Points and triangles of a file, the faces as they are."""
    tokens = path.read_text().split()
    assert tokens[0].endswith("OFF")
    n, m = int(tokens[1]), int(tokens[2])
    V = np.array(tokens[4:4 + 3 * n], dtype=float).reshape(n, 3)
    F = np.array(tokens[4 + 3 * n:4 + 3 * n + 4 * m], dtype=int).reshape(m, 4)
    assert (F[:, 0] == 3).all()
    return V, F[:, 1:]


def data_file(name: str) -> pathlib.Path:
    """One of CGAL's meshes."""
    folder = os.environ.get("RESTRICTED_LAPLACIAN_3_DATA_DIR")
    if not folder:
        pytest.skip("SKIPPED: CGAL's data was not found")
    path = pathlib.Path(folder) / name
    assert path.exists(), f"{name} is not in {folder}"
    return path


@pytest.fixture(scope="session")
def sphere() -> tuple[np.ndarray, np.ndarray]:
    return rl.icosphere(4)


@pytest.fixture(scope="session")
def programs() -> pathlib.Path:
    """The folder of the programs."""
    return built("PROGRAMS", "solve_poisson")


@pytest.fixture(scope="session")
def examples() -> pathlib.Path:
    """The folder of the examples in C++."""
    return built("EXAMPLES", "first_steps")


def built(kind: str, program: str) -> pathlib.Path:
    folder = os.environ.get("RESTRICTED_LAPLACIAN_3_" + kind)
    if not folder or not (pathlib.Path(folder) / program).exists():
        pytest.skip(f"SKIPPED: {program} was not found")
    return pathlib.Path(folder)

# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Surfaces and signals that are smoothed, sharpened and edited."""

import numpy as np
import pytest
import restricted_laplacian as rl


@pytest.fixture(scope="module")
def noisy():
    V, F = rl.icosphere(4)
    return V * (1 + 0.01 * np.random.default_rng(2).standard_normal((len(V), 1))), F


def deviation(X):
    return np.std(np.linalg.norm(X, axis=1))


def test_smoothing(noisy):
    V, F = noisy
    told = []
    X, report = rl.smooth_surface(V, F, 0.6, progress=told.append, return_report=True)
    assert deviation(X) < 0.35 * deviation(V) and report.converged and told
    assert np.array_equal(X, rl.smooth_surface(V, F, 0.6, threads=1))
    assert deviation(rl.smooth_surface(V, F, 0.6, crease_angle=60)) < 0.5 * deviation(V)
    twice = rl.sharpen_surface(V, F, 0.6)
    assert twice == pytest.approx(2 * V - X, abs=1e-9)
    # a space is taken as it is
    space = rl.Space(V, F, depth=5)
    assert np.array_equal(rl.smooth_surface(space, length=0.6), rl.smooth_surface(V, F, 0.6, depth=5))


def test_signals(noisy):
    V, F = noisy
    z = V[:, 2]
    ratio = 2 / (2 * np.pi / 3) ** 2  # of eigenvalue and weight
    one = rl.smooth_surface(V, F, 3, signal=z, depth=4)
    assert one.shape == z.shape and one == pytest.approx(z / (1 + ratio ** 2), abs=0.03)
    two = rl.smooth_surface(V, F, 3, signal=np.column_stack([z, 2 * z]), depth=4)
    assert two == pytest.approx(np.column_stack([one, 2 * one]), abs=1e-3)
    assert rl.edit_surface(V, F, 0, 10, signal=z, depth=4) == pytest.approx(10 / 12 * z, abs=0.03)


def test_editing(noisy):
    V, F = noisy
    editor = rl.SurfaceEditor(V, F, 100)
    assert editor.edit(1) == pytest.approx(V, abs=1e-14)
    half, report = editor.edit(0.5, return_report=True)
    assert half == pytest.approx((editor.edit(0) + V) / 2) and report.converged
    for scale in (np.full(len(V), 0.5), np.full(len(F), 0.5), lambda p: np.full(len(p), 0.5)):
        assert editor.edit(scale) == pytest.approx(half, abs=2e-3)
    assert np.array_equal(rl.edit_surface(V, F, 0.5, 100), half)
    flat = np.abs(np.linalg.norm(rl.edit_surface(V, F, 0, 10), axis=1)).mean()
    assert np.abs(np.linalg.norm(rl.edit_surface(V, F, 0, 10, anisotropic=5), axis=1)).mean() > flat + 0.03


def test_bad_input(noisy):
    V, F = noisy
    for call in (lambda: rl.smooth_surface(V, F), lambda: rl.smooth_surface(V, F, -1),
                 lambda: rl.smooth_surface(V, F, 1, crease_angle=0),
                 lambda: rl.smooth_surface(V, F, 1, crease_angle=30, signal=V),
                 lambda: rl.smooth_surface(V, F, 1, signal=V[:5]),
                 lambda: rl.smooth_surface(V, F, 1, signal=np.full(len(V), np.nan)),
                 lambda: rl.sharpen_surface(V, F, 1, np.inf), lambda: rl.edit_surface(V, F, None, 1),
                 lambda: rl.edit_surface(V, F, 1), lambda: rl.edit_surface(V, F, 1, 0),
                 lambda: rl.edit_surface(V, F, np.nan, 1),
                 lambda: rl.edit_surface(V, F, V, 1), lambda: rl.edit_surface(V, F, 1, 1, anisotropic=-1)):
        with pytest.raises(rl.InputError):
            call()
    with pytest.raises(rl.Canceled):
        rl.smooth_surface(V, F, 0.5, progress=lambda _: False)

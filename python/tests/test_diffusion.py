# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Diffusion, and data smoothed by a width."""

import numpy as np
import pytest
import restricted_laplacian as rl

DEPTH = 4


@pytest.fixture(scope="module")
def mesh():
    return rl.icosphere(4)


def test_decay(mesh):
    V, F = mesh
    u0 = np.stack([V[:, 2], V[:, 0] * V[:, 1]], axis=1)
    for time in (0.01, 0.3):
        u = rl.diffuse(V, F, u0, time, depth=DEPTH)
        assert np.abs(u - u0 * np.exp([-2 * time, -6 * time])).max() < 6e-3
        again = rl.diffuse(V, F, lambda p: p[:, 2], time, depth=DEPTH)
        assert np.abs(again - u[:, 0]).max() < 3e-3
    # with twice the diffusion in half of the time
    u = rl.diffuse(V, F, u0, 0.2, depth=DEPTH, tolerance=1e-8)
    assert np.allclose(rl.diffuse(V, F, u0, 0.1, diffusion=2.0, depth=DEPTH, tolerance=1e-8), u, atol=1e-6)
    assert np.allclose(rl.diffuse(V, F, u0, 0.1, density=0.5, depth=DEPTH, tolerance=1e-8), u, atol=1e-6)
    u, report = rl.diffuse(V, F, V[:, 2], 0.1, accuracy=1e-2, return_report=True)
    assert report.converged and report.estimated_error <= 1e-2
    spline = rl.diffuse(V, F, V[:, 2], 0.1, depth=DEPTH, as_spline=True)
    assert np.allclose(spline.at_vertices(), rl.diffuse(V, F, V[:, 2], 0.1, depth=DEPTH))


def test_source_and_boundary():
    n = 12
    x, y = np.meshgrid(np.linspace(0, 1, n + 1), np.linspace(0, 1, n + 1))
    V = np.stack([x.ravel(), y.ravel(), 0 * x.ravel()], axis=1)
    i = np.arange((n + 1) ** 2).reshape(n + 1, n + 1)
    a, b, c, d = i[:-1, :-1].ravel(), i[:-1, 1:].ravel(), i[1:, 1:].ravel(), i[1:, :-1].ravel()
    F = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    u = rl.diffuse(V, F, np.zeros(len(V)), 0.5, source_term=2.0, depth=DEPTH)
    assert np.abs(u - 1).max() < 1e-9
    u = rl.diffuse(V, F, np.zeros(len(V)), 9, boundary_values=V[:, 0], depth=DEPTH)
    assert np.abs(u - V[:, 0]).max() < 1e-3


def test_smooth(mesh):
    V, F = mesh
    rng = np.random.default_rng(1)
    noise = rng.standard_normal((len(V), 3))
    u = rl.smooth(V, F, noise, fwhm=0.5, depth=DEPTH)
    assert u.shape == noise.shape and u.std() < 0.15
    assert np.allclose(rl.smooth(V, F, noise[:, 0], fwhm=0.5, depth=DEPTH), u[:, 0], atol=1e-3)
    constant = np.full(len(V), 3.0)
    constant[V[:, 2] > 0.5] = np.nan
    u = rl.smooth(V, F, constant, fwhm=0.4, depth=DEPTH)
    assert np.array_equal(np.isnan(u), np.isnan(constant))
    assert np.nanmax(np.abs(u - 3)) < 1e-6
    # what is outside of the mask does not matter
    inside = V[:, 2] <= 0.5
    other = np.where(inside, V[:, 0], 1e6)
    u = rl.smooth(V, F, other, fwhm=0.2, mask=inside, depth=DEPTH)
    assert np.isnan(u[~inside]).all() and np.abs(u[inside] - V[inside, 0]).max() < 0.1
    columns = np.stack([V[:, 0], np.where(inside, V[:, 0], np.nan)], axis=1)
    u = rl.smooth(V, F, columns, fwhm=0.2, depth=DEPTH)
    assert not np.isnan(u[:, 0]).any() and np.isnan(u[:, 1]).sum() == (~inside).sum()


def test_what_is_refused(mesh):
    V, F = mesh
    for bad in (0, -1, np.nan, np.inf):
        with pytest.raises(rl.InputError, match="time"):
            rl.diffuse(V, F, V[:, 2], bad, depth=3)
        with pytest.raises(rl.InputError, match="fwhm|time"):
            rl.smooth(V, F, V[:, 2], fwhm=bad, depth=3)
    with pytest.raises(rl.InputError, match="time"):
        rl.diffuse(V, F, V[:, 2], depth=3)
    with pytest.raises(rl.InputError, match="time"):
        rl.diffuse(V, F, V[:, 2], 1, fwhm=1, depth=3)
    with pytest.raises(rl.InputError, match="vertex 4"):
        rl.diffuse(V, F, np.where(np.arange(len(V)) == 4, np.nan, 1.0), 1, depth=3)
    with pytest.raises(rl.InputError, match="source"):
        rl.diffuse(V, F, V, 1, source_term=1.0, depth=3)
    with pytest.raises(rl.InputError, match="boundary"):
        rl.diffuse(V, F, V[:, 2], 1, boundary_values=0.0, depth=3)
    square = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]), [[0, 1, 2, 3]]
    for solve in (lambda b: rl.diffuse(*square, np.ones(4), 1, boundary_values=b, depth=3),
                  lambda b: rl.solve_poisson(*square, np.ones(4), boundary_values=b, depth=3)):
        with pytest.raises(rl.InputError, match="boundary_values.*components"):
            solve(np.ones((4, 2)))
    with pytest.raises(rl.InputError, match="mask"):
        rl.smooth(V, F, V[:, 2], fwhm=1, mask=np.ones(3, bool), depth=3)
    with pytest.raises(rl.InputError, match="data"):
        rl.smooth(V, F, V[:, :, None], fwhm=1, depth=3)

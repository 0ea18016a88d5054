# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Surfaces that move."""

import numpy as np
import pytest
import restricted_laplacian as rl

DEPTH = 4


@pytest.fixture(scope="module")
def mesh():
    return rl.icosphere(4)


def test_sphere_shrinks(mesh):
    V, F = mesh
    told = []
    X, report = rl.mean_curvature_flow(V, F, 0.005, steps=10, depth=DEPTH, progress=told.append, return_report=True)
    assert np.abs(np.linalg.norm(X, axis=1) - np.sqrt(0.8)).max() < 6e-3 and report.time == pytest.approx(0.05)
    assert told[-1] == 1 and len(told) == 10 and report.collapse == "" and report.converged
    flow = rl.MeanCurvatureFlow(V, F, depth=DEPTH)
    for _ in range(10):
        flow.step(0.005)
    assert np.array_equal(flow.positions, X) and flow.time == report.time
    assert flow.function().at_vertices() == pytest.approx(X)
    assert "time" in repr(flow)
    one = rl.mean_curvature_flow(V, F, 0.005, steps=10, depth=DEPTH, threads=1)
    assert np.array_equal(one, X)


def test_conformal(mesh):
    V, F = mesh
    V = V * [1.5, 1, 0.7]
    area = rl.Space(V, F).area
    X, report = rl.mean_curvature_flow(V, F, 0.02 * area, steps=40, conformal=True, depth=DEPTH, return_report=True)
    assert report.sphere_deviation < 2e-3 and report.mean_distortion < 1.01
    assert report.area == pytest.approx(area) and report.volume == pytest.approx(area ** 1.5 / 6 / np.sqrt(np.pi), rel=0.01)
    assert 1 < report.largest_distortion < 1.2 and 5 < report.smallest_angle < 60
    X, report = rl.mean_curvature_flow(V, F, 0.01, rescaling="volume", depth=DEPTH, return_report=True)
    first = np.einsum("ij,ij->i", V[F[:, 0]], np.cross(V[F[:, 1]], V[F[:, 2]])).sum() / 6
    assert report.volume == pytest.approx(first)


def test_what_is_refused(mesh):
    V, F = mesh
    for bad in (0, -1.0, np.nan, np.inf, None):
        with pytest.raises(rl.InputError, match="time_step"):
            rl.mean_curvature_flow(V, F, bad, depth=DEPTH)
    with pytest.raises(rl.InputError, match="rescaling"):
        rl.mean_curvature_flow(V, F, 1, rescaling="length", depth=DEPTH)
    with pytest.raises(rl.InputError, match="steps"):
        rl.mean_curvature_flow(V, F, 1, steps=0, depth=DEPTH)
    with pytest.raises(rl.InputError, match="tolerance"):
        rl.mean_curvature_flow(V, F, 1, tolerance=2, depth=DEPTH)
    with pytest.raises(rl.InputError):
        rl.mean_curvature_flow(V[:1], F, 1, depth=DEPTH)
    with pytest.raises(rl.Canceled):
        rl.mean_curvature_flow(V, F, 0.01, steps=3, depth=DEPTH, progress=lambda part: False)
    X, report = rl.mean_curvature_flow(V, F, 1e9, depth=DEPTH, return_report=True)
    assert "collapses" in report.collapse and np.abs(X - V).max() < 1e-3, "the last good state"
    V2 = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0]])
    with pytest.raises(rl.InputError, match="boundary"):
        rl.mean_curvature_flow(V2, [[0, 1, 2]], 0.1, rescaling="volume", depth=DEPTH)


def test_spherical_parameterization(mesh):
    V, F = mesh
    W = V * [2, 1, 0.6] + 9
    X, report = rl.spherical_parameterization(W, F, depth=DEPTH, return_report=True)
    assert np.allclose(np.linalg.norm(X, axis=1), 1) and report.folded_faces == 0 and report.mean_distortion < 1.02
    weights = np.bincount(F.ravel(), np.repeat(np.linalg.norm(np.cross(W[F[:, 1]] - W[F[:, 0]], W[F[:, 2]] - W[F[:, 0]]),
                                                              axis=1), 3))
    assert np.abs(weights @ X).max() < 1e-8 * weights.sum()
    # angles of triangles are kept: those of the mesh and of the sphere
    def angles(P):
        p = P[F]
        u, v = p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]
        return np.arctan2(np.linalg.norm(np.cross(u, v), axis=1), (u * v).sum(1))
    assert np.abs(angles(X) - angles(W)).mean() < 0.03 < np.abs(angles(V) - angles(W)).mean()
    with pytest.raises(rl.ConvergenceError):
        rl.spherical_parameterization(W, F, depth=DEPTH, maximum_iterations=1)
    with pytest.raises(rl.InputError, match="Euler"):
        rl.spherical_parameterization(V, F[5:], depth=DEPTH)
    with pytest.raises(rl.InputError, match="tolerance"):
        rl.spherical_parameterization(V, F, depth=DEPTH, tolerance=-1)

# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Distances along surfaces."""

from __future__ import annotations

import subprocess
import threading

import numpy as np
import pytest

import restricted_laplacian as rl
from conftest import data_file, read_off


def grid(n):
    x, y = np.meshgrid(np.arange(n + 1) / n, np.arange(n + 1) / n)
    V = np.stack([x.ravel(), y.ravel(), 0 * x.ravel()], axis=1)
    a = (np.arange(n)[:, None] * (n + 1) + np.arange(n)).ravel()
    F = np.concatenate([np.stack([a, a + 1, a + n + 2], axis=1),
                        np.stack([a, a + n + 2, a + n + 1], axis=1)])
    return V, F


def test_sphere(sphere):
    V, F = sphere
    expected = np.arccos(np.clip(V @ V[5], -1, 1))
    geodesics = rl.Geodesics(V, F)
    d, directions, labels = geodesics.distances(5)
    far = expected > 0.06
    assert abs(d[far] / expected[far] - 1).max() < 2e-3
    assert (labels == 0).all() and directions.shape == V.shape
    toward = V[5] - (V @ V[5])[:, None] * V
    inner = (expected > 0.2) & (expected < 3) & (directions != 0).any(axis=1)
    assert inner.sum() > 0.9 * len(V)
    toward = toward[inner] / np.linalg.norm(toward[inner], axis=1)[:, None]
    assert (np.einsum("ij,ij->i", toward, directions[inner]) > 0.99).all()
    exact = geodesics.distances(5, exact=True).distances
    assert 0 < abs(d - exact).max() < 2e-3 * exact.max()
    assert exact[77] == pytest.approx(geodesics.distances(77, exact=True).distances[5], rel=1e-12)
    assert np.array_equal(rl.geodesic_distance(V, F, [5]), d)


def test_sources(sphere):
    V, F = grid(10)
    geodesics = rl.Geodesics(V, F)
    b = np.array([0.2, 0.3, 0.5])
    p = b @ V[F[40]]
    for points in ((40, b), ([40], [b]), (np.array([40]), b[None])):
        d = geodesics.distances(points=points).distances
        assert np.allclose(d, np.linalg.norm(V - p, axis=1), rtol=1e-9, atol=1e-12)
    # the edge from the second to the third vertex of a face
    p, q = V[F[40, 1]], V[F[40, 2]]
    t = np.clip((V - p) @ (q - p) / ((q - p) @ (q - p)), 0, 1)
    d = geodesics.distances(segments=(40, [0, 1, 0], [0, 0, 1])).distances
    assert np.allclose(d, np.linalg.norm(V - p - t[:, None] * (q - p), axis=1), rtol=2e-3, atol=1e-9)
    d = geodesics.distances(boundary=True).distances
    expected = np.minimum(np.minimum(V[:, 0], 1 - V[:, 0]), np.minimum(V[:, 1], 1 - V[:, 1]))
    assert np.allclose(d, expected, rtol=2e-3, atol=1e-9)
    corners = [0, 10, 110, 120]
    labels = geodesics.distances(corners).labels
    inner = abs(V[:, :2] - 0.5).min(axis=1) > 0.01
    assert np.array_equal(labels[inner], ((V[:, 0] > 0.5) + 2 * (V[:, 1] > 0.5))[inner])
    labels = geodesics.distances(corners, points=(40, b), labels=[1, 1, 1, 1, 7]).labels
    assert set(labels) == {1, 7}
    two, faces = np.concatenate([V, V + 5]), np.concatenate([F, F + len(V)])
    d, directions, labels = rl.Geodesics(two, faces).distances(0)
    assert np.isinf(d[len(V):]).all() and (labels[len(V):] == -1).all()
    assert (directions[len(V):] == 0).all()


def test_farthest_points(sphere):
    V, F = sphere
    far = rl.farthest_points(V, F, 2)
    assert np.linalg.norm(V[far[0]] - V[far[1]]) > 1.99
    assert len(set(rl.Geodesics(V, F).farthest_points(20, [1, 2]))) == 20
    assert len(rl.farthest_points(V[:3], [[0, 1, 2]], 99)) == 3


def test_program(programs, tmp_path):
    path = data_file("elephant.off")
    V, F = read_off(path)
    printed = subprocess.run([programs / "minimal_distances", path], capture_output=True, check=True,
                             text=True).stdout.splitlines()
    geodesics = rl.Geodesics(V, F)
    assert printed[0].endswith(f" {geodesics.distances(0).distances.max():.6g}")
    far = geodesics.farthest_points(4)
    counts = np.bincount(geodesics.distances(far).labels)
    assert [line.split()[1] for line in printed[1:]] == [str(v) for v in far]
    assert [line.split()[-2] for line in printed[1:]] == [str(n) for n in counts]


def test_threads(sphere):
    V, F = sphere
    geodesics = rl.Geodesics(V, F)
    expected = [geodesics.distances(i).distances for i in range(4)]
    found = [None] * 4

    def query(i):
        found[i] = geodesics.distances(i).distances

    threads = [threading.Thread(target=query, args=(i,)) for i in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(np.array_equal(a, b) for a, b in zip(found, expected))


V, F = rl.icosphere(2)
geodesics = rl.Geodesics(V, F)


@pytest.mark.parametrize("call", [
    lambda: geodesics.distances(),
    lambda: geodesics.distances([]),
    lambda: geodesics.distances(-1),
    lambda: geodesics.distances(len(V)),
    lambda: geodesics.distances(2 ** 62),
    lambda: geodesics.distances(0.5),
    lambda: geodesics.distances(np.nan),
    lambda: geodesics.distances("a"),
    lambda: geodesics.distances([None]),
    lambda: geodesics.distances(boundary=True),
    lambda: geodesics.distances(points=(0, [0.5, 0.6, 0.7])),
    lambda: geodesics.distances(points=(0, [np.nan, 0, 1])),
    lambda: geodesics.distances(points=(len(F), [1, 0, 0])),
    lambda: geodesics.distances(points=(0, [1, 0])),
    lambda: geodesics.distances(points=([0, 1], [1, 0, 0])),
    lambda: geodesics.distances(points=[0]),
    lambda: geodesics.distances(segments=(0, [1, 0, 0])),
    lambda: geodesics.distances([0, 1], labels=[0]),
    lambda: geodesics.distances(0, labels=[-1]),
    lambda: geodesics.distances(0, labels=[2 ** 40]),
    lambda: geodesics.farthest_points(-1),
    lambda: geodesics.farthest_points(1.5),
    lambda: geodesics.farthest_points(2, [len(V)]),
    lambda: rl.geodesic_distance(V, F + len(V), 0),
    lambda: rl.Geodesics(V),
])
def test_abuse_of_distances(call):
    with pytest.raises(rl.InputError):
        call()


def test_vertex_that_does_not_exist_is_named():
    with pytest.raises(rl.InputError) as e:
        geodesics.distances([0, len(V) + 5])
    assert e.value.vertex == len(V) + 5
    with pytest.raises(rl.InputError) as e:
        geodesics.distances(-1)
    assert e.value.argument == "sources"

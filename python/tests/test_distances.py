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


def test_signed_distances(sphere):
    V, F = sphere
    geodesics = rl.Geodesics(V, F)
    found = geodesics.signed_distances(V[:, 2] - 0.5)
    assert abs(found - (np.arcsin(V[:, 2]) - np.pi / 6)).max() < 5e-3
    near = geodesics.signed_distances(V[:, 2] - 0.5, maximum_distance=0.3, exact=True)
    assert np.array_equal(np.isinf(near), abs(near) > 0.3) and (np.sign(near) == np.sign(found)).all()
    mask = V[:, 2] < 0.5
    assert ((geodesics.signed_distances(mask) < 0) == mask).all()
    assert abs(geodesics.signed_distances(mask) - found).max() < 0.1
    of_points = rl.Geodesics(V, normals=V).signed_distances(V[:, 2] - 0.5)
    assert abs(of_points - found).max() < 0.02
    for bad, pattern in ((np.ones(len(V)), "nowhere"), (np.ones(3), "shape"), (np.full(len(V), np.nan), "vertex 0")):
        with pytest.raises(rl.InputError, match=pattern):
            geodesics.signed_distances(bad)


def test_faces_twice(sphere):
    V, F = sphere
    once = rl.Geodesics(V, F).distances([5]).distances
    for other in (F[:, [1, 2, 0]], F[:, ::-1]):
        twice = rl.Geodesics(V, np.concatenate([F, other]), maximum_memory=1e9)
        np.testing.assert_allclose(twice.distances([5]).distances, once, rtol=1e-9)


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


def test_example(examples, tmp_path):
    path = data_file("elephant.off")
    V, F = read_off(path)
    printed = subprocess.run([examples / "minimal_distances", path], capture_output=True, check=True,
                             text=True).stdout.splitlines()
    geodesics = rl.Geodesics(V, F)
    assert printed[0].endswith(f" {geodesics.distances(0).distances.max():.6g}")
    far = geodesics.farthest_points(4)
    counts = np.bincount(geodesics.distances(far).labels)
    assert [line.split()[1] for line in printed[1:5]] == [str(v) for v in far]
    assert [line.split()[-2] for line in printed[1:5]] == [str(n) for n in counts]
    spline = geodesics.spline(0)
    face, center = len(F) // 2, np.full((1, 3), 1 / 3)
    numbers = [float(x) for x in printed[5].replace(",", " ").split() if x[-1].isdigit()]
    # triangles begin at other corners there, so the nodes of the integrals are others, too
    assert np.allclose(numbers, [*spline([face], center), *spline.gradients([face], center)[0]],
                       rtol=1e-3, atol=1e-2)


def test_distance_matrix(sphere):
    V, F = sphere
    sources = [3, 0, 77]
    parts = []
    found = rl.Geodesics(V, F, threads=2).distance_matrix(sources, progress=parts.append)
    assert found.shape == (3, len(V))
    assert parts[-1] == 1 and parts == sorted(parts)
    for row, source in zip(found, sources):
        assert (row == rl.geodesic_distance(V, F, source)).all()
    assert (rl.Geodesics(V, F, threads=1).distance_matrix(sources) == found).all()
    exact = rl.Geodesics(V, F).distance_matrix(sources, exact=True)
    assert (exact[1] == rl.geodesic_distance(V, F, 0, exact=True)).all()
    assert rl.Geodesics(V, F).distance_matrix([]).shape == (0, len(V))


def test_distances_between_many(sphere, tmp_path):
    V, F = sphere
    geodesics = rl.Geodesics(V, F)
    some = [3, 0, 77, 200]
    rows = geodesics.distance_matrix(some)
    assert np.allclose(geodesics.distance_matrix(some, [5, 9]), rows[:, [5, 9]], rtol=1e-3)
    square = geodesics.distance_matrix(some, some)
    assert np.array_equal(square, square.T) and np.allclose(square, rows[:, some], rtol=2e-3)
    near = geodesics.distance_matrix(some, maximum_distance=0.5)
    assert near.shape == rows.shape and near.nnz == (rows <= 0.5).sum()
    assert np.allclose(near.toarray(), np.where(rows <= 0.5, rows, 0), rtol=1e-3)
    assert geodesics.distance_matrix(some, some, maximum_distance=0.5).shape == (4, 4)
    limited = geodesics.distances(3, maximum_distance=0.5).distances
    assert np.allclose(limited, np.where(rows[0] <= 0.5, rows[0], np.inf), rtol=1e-3)
    # all pairs, to a file
    out = np.memmap(tmp_path / "all.bin", dtype=np.float32, mode="w+", shape=(len(V), len(V)))
    told = []
    assert geodesics.distance_matrix(out=out, progress=told.append) is out and told[-1] == 1
    assert np.array_equal(out, out.T) and np.allclose(out[some], rows, rtol=2e-3, atol=1e-6)
    for call in (lambda: geodesics.distance_matrix(some, out=out), lambda: geodesics.distance_matrix(some, [len(V)]),
                 lambda: geodesics.distance_matrix(some, maximum_distance=-1),
                 lambda: geodesics.distance_matrix(maximum_distance=1, out=out)):
        with pytest.raises(rl.InputError):
            call()
    with pytest.raises(rl.Canceled):
        geodesics.distance_matrix(out=out, progress=lambda _: False)


def test_distances_between_points(sphere):
    V, F = sphere
    geodesics = rl.Geodesics(V, F)
    faces, barycentric = [5, 300, 77], [[0.2, 0.3, 0.5], [0, 0, 1], [1 / 3] * 3]
    points = faces, barycentric
    # points in faces are rows and columns after the vertices
    mixed = geodesics.distance_matrix([0, 9], [4], points=points, target_points=points)
    assert mixed.shape == (5, 4)
    for row, d in zip(mixed, [geodesics.function(0), geodesics.function(9)]
                      + [geodesics.function(points=([f], [b])) for f, b in zip(*points)]):
        expected = [d([f], [np.eye(3)[k]])[0] for f, k in [np.argwhere(np.asarray(F) == 4)[0]]] + list(d(*points))
        assert np.allclose(row, expected, rtol=1e-3, atol=1e-9)
    assert np.allclose(geodesics.distance_matrix(points=points), np.stack(
        [geodesics.distances(points=([f], [b])).distances for f, b in zip(*points)]))
    # over several blocks of rows
    vertices, corners = np.arange(100), (np.arange(440), np.tile([0.0, 1.0, 0.0], (440, 1)))
    column = geodesics.distance_matrix(vertices, [400], points=corners)[:, 0]
    from_there = geodesics.distances(400).distances
    assert np.allclose(column, from_there[[*vertices, *np.asarray(F)[:440, 1]]], rtol=5e-3, atol=1e-9)
    # one that is a vertex
    assert np.allclose(geodesics.distance_matrix([0], target_points=points)[0, 1],
                       geodesics.distances(0).distances[F[300][2]], rtol=1e-3)
    square = geodesics.distance_matrix(points=points, target_points=points)
    assert square.shape == (3, 3) and np.array_equal(square, square.T) and (abs(square.diagonal()) < 1e-9).all()
    places = np.einsum("nk,nkc->nc", barycentric, V[np.asarray(F)[faces]])
    places /= np.linalg.norm(places, axis=1)[:, None]
    angles = np.arccos(np.clip(places @ places.T, -1, 1))
    assert np.allclose(square, angles, rtol=1e-2, atol=1e-7)
    # near ones only, with the zeros, symmetric as well
    limit = (square[0, 1] + square[0, 2]) / 2
    near = geodesics.distance_matrix(points=points, target_points=points, maximum_distance=limit)
    assert near.nnz == (square <= limit).sum() >= 5
    assert np.allclose(near.toarray(), np.where(square <= limit, square, 0), rtol=1e-3, atol=1e-9)
    some = [3, 0, 77, 200]
    all_of_some = geodesics.distance_matrix(some, some)
    near = geodesics.distance_matrix(some, some, maximum_distance=1.5)
    assert (near != near.T).nnz == 0 and near.nnz == (all_of_some <= 1.5).sum()
    assert np.allclose(near.toarray(), np.where(all_of_some <= 1.5, all_of_some, 0), rtol=2e-3)
    # one direction is within the maximum, the other one is not
    rows = geodesics.distance_matrix(some)[:, some]
    i, j = np.unravel_index(np.argmax(abs(rows - rows.T)), rows.shape)
    near = geodesics.distance_matrix(some, some, maximum_distance=(rows[i, j] + rows[j, i]) / 2)
    assert near[i, j] == near[j, i] and near[i, j] == pytest.approx(rows[i, j], rel=1e-3)
    none = [], np.zeros((0, 3))
    assert geodesics.distance_matrix(points=none, target_points=points).shape == (0, 3)
    assert geodesics.distance_matrix(points=points, target_points=none).shape == (3, 0)
    for bad in (([len(F)], [[1, 0, 0]]), ([0], [[0.7, 0.7, 0]]), ([0], [[1, 0]]), ([0, 1], [[1, 0, 0]]), ([0],)):
        with pytest.raises(rl.InputError):
            geodesics.distance_matrix(points=bad)
        with pytest.raises(rl.InputError):
            geodesics.distance_matrix([0], target_points=bad)
    told = []
    with pytest.raises(rl.Canceled):
        geodesics.distance_matrix(progress=lambda part: told.append(part) or part < 0.1)
    assert max(told) < 0.5


def test_parcels(sphere):
    V, F = sphere
    parcels = np.where(abs(V[:, 2]) > 0.2, (V[:, 2] > 0).astype(int) + 3, -1)
    labels, centers, means = rl.Geodesics(V, F).parcel_distances(parcels)
    assert list(labels) == [3, 4] and V[centers[0], 2] < -0.95 and V[centers[1], 2] > 0.95
    assert np.array_equal(means, means.T) and means[0, 1] > 1.8 > 1.2 > means[0, 0] > 0.6
    for bad in (parcels[:5], parcels * 0.5):
        with pytest.raises(rl.InputError, match="parcels"):
            rl.Geodesics(V, F).parcel_distances(bad)
    # one without a face, a point without a triangle
    V, parcels, normals = np.vstack([V, [[0, 0, -0.9]]]), np.append(parcels, 3), np.vstack([V, [[0, 0, 1]]])
    assert np.array_equal(rl.Geodesics(V, F).parcel_distances(parcels)[2], means)
    of_points = rl.Geodesics(V, normals=normals).parcel_distances(parcels)[2]
    assert np.allclose(of_points, means, rtol=0.02)


def test_memory_and_progress(sphere):
    V, F = sphere
    with pytest.raises(rl.InputError, match="maximum_memory is 0.1 MB: the windows"):
        rl.geodesic_distance(V, F, 0, maximum_memory=1e5)
    with pytest.raises(rl.InputError, match="maximum_memory"):
        rl.geodesic_distance(V, F, 0, maximum_memory=0)
    with pytest.raises(rl.Canceled):
        rl.geodesic_distance(V, F, 0, progress=lambda done: False)
    with pytest.raises(ZeroDivisionError):
        rl.Geodesics(V, F).farthest_points(5, progress=lambda done: 1 / 0)


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


def test_functions(sphere):
    V, F = sphere
    geodesics = rl.Geodesics(V, F)
    for d in (geodesics.function(5), geodesics.function(5, exact=True), geodesics.spline(5),
              rl.Geodesics(rl.Space(V, F, depth=5)).spline(5)):
        faces = np.arange(len(F))
        places = np.tile([0.2, 0.3, 0.5], (len(F), 1))
        p = np.einsum("k,nkd->nd", places[0], V[F])
        expected = np.arccos(np.clip(p @ V[5] / np.linalg.norm(p, axis=1), -1, 1))
        far = (expected > 0.2) & (expected < 3)
        assert abs(d(faces, places)[far] / expected[far] - 1).max() < 1e-2
        g = d.gradients(faces, places)
        away = V[5] - (p @ V[5])[:, None] * p / (p * p).sum(axis=1)[:, None]
        away = -away[far] / np.linalg.norm(away[far], axis=1)[:, None]
        assert g.shape == (len(F), 3) and abs(g[far] - away).max() < 0.3
        # the spline is another function
        assert d([7], [[0.2, 0.3, 0.5]]).shape == (1,)
    triangles, spline = geodesics.function(5)(faces, places), geodesics.spline(5)(faces, places)
    assert 0 < abs(triangles - spline).max() < 0.02
    exact = geodesics.function(5, exact=True)(faces, places)
    assert 0 < abs(triangles - exact).max() < 0.01
    # a space of its own counts
    coarse = rl.Geodesics(rl.Space(V, F, depth=3)).spline(5)(faces, places)
    assert abs(coarse - spline).max() > 0


def test_paths_and_isolines(sphere):
    V, F = sphere
    geodesics = rl.Geodesics(V, F)
    d = geodesics.distances(5).distances
    function = geodesics.function(5)
    for v in (0, 77, np.int64(200)):
        path = function.shortest_path(v)
        assert path.length == pytest.approx(d[v], rel=1e-3)
        assert np.array_equal(path.points[[0, -1]], V[[v, 5]])
        faces, start, end = path.segments
        assert len(path.points) == len(faces) + 1
        assert np.allclose(np.einsum("nk,nkd->nd", end, V[F[faces]]), path.points[1:])
        assert np.allclose(np.einsum("nk,nkd->nd", start, V[F[faces]]), path.points[:-1])
        steps = np.linalg.norm(np.diff(path.points, axis=0), axis=1)
        assert path.length == pytest.approx(steps.sum(), rel=1e-12)
        assert np.array_equal(rl.shortest_path(V, F, v, 5).points, path.points)
        # a path is a source
        from_path = geodesics.distances(segments=path.segments).distances
        assert from_path[v] < 1e-9 and from_path[5] < 1e-9
    inside = function.shortest_path((40, [0.2, 0.3, 0.5]))
    assert np.allclose(inside.points[0], np.array([0.2, 0.3, 0.5]) @ V[F[40]])
    assert function.shortest_path(5).length == 0
    exact = geodesics.function(5, exact=True).shortest_path(77).length
    assert exact == pytest.approx(geodesics.distances(5, exact=True).distances[77], rel=1e-6)
    circle, = function.isolines(1.0)
    assert np.allclose(circle.points[0], circle.points[-1])
    assert circle.length == pytest.approx(2 * np.pi * np.sin(1.0), rel=0.02)
    assert function.isolines(4.0) == []
    W, G = grid(8)
    to_boundary = rl.Geodesics(W, G).function(boundary=True)
    assert to_boundary.shortest_path(40).length == pytest.approx(0.5)
    assert rl.shortest_path(W, G, 40, boundary=True).length == pytest.approx(0.5)


def test_bad_functions(sphere):
    V, F = sphere
    d = rl.Geodesics(V, F).function(0)
    for start in (-1, len(V), 0.5, np.nan, [1, 2, 3], (0, [2.0, -1, 0]), (len(F), [1, 0, 0]),
                  ([0, 1], [[1, 0, 0], [1, 0, 0]]), np.array([1, 2])):
        with pytest.raises(rl.InputError, match="start|vertex|face"):
            d.shortest_path(start)
    for value in (0, -1, np.nan, np.inf):
        with pytest.raises(rl.InputError):
            d.isolines(value)
    for faces, places in (([0], [[1, 0]]), ([0, 1], [[1, 0, 0]]), ([len(F)], [[1, 0, 0]]),
                          ([-1], [[1, 0, 0]]), ([0], [[np.nan, 0, 0]])):
        with pytest.raises(rl.InputError):
            d(faces, places)
        with pytest.raises(rl.InputError):
            d.gradients(faces, places)
    both = np.concatenate([V, V + 5])
    two = rl.Geodesics(both, np.concatenate([F, F + len(V)]))
    for function in (two.function(0), two.spline(0)):
        assert np.isinf(function([len(F)], [[1, 0, 0]])).all()
        assert (function.gradients([len(F)], [[0.2, 0.3, 0.5]]) == 0).all()
        with pytest.raises(rl.InputError, match="no source"):
            function.shortest_path(len(V))


def test_joining(sphere):
    V, F = sphere
    soup, faces = V[F].reshape(-1, 3), np.arange(F.size).reshape(-1, 3)
    d = rl.Geodesics(V, F).distances(F[0, 0]).distances
    joined = rl.Geodesics(soup, faces, joining_tolerance=1e-9).distances(0).distances
    assert np.allclose(joined, d[F.ravel()], rtol=1e-6)
    assert np.isinf(rl.Geodesics(soup, faces).distances(0).distances).sum() == len(soup) - 3
    for bad in (-1, np.nan, np.inf):
        with pytest.raises(rl.InputError, match="joining_tolerance"):
            rl.Geodesics(soup, faces, joining_tolerance=bad)


def test_points(sphere):
    V, F = sphere
    expected = np.arccos(np.clip(V @ V[5], -1, 1))
    for geodesics in (rl.Geodesics(V, normals=V), rl.Geodesics(rl.Space(V, normals=V, depth=4))):
        d = geodesics.distances(5).distances
        assert np.allclose(d, expected, rtol=4e-3, atol=1e-9)
        points = np.tile([1.0, 0, 0], (len(V), 1))
        assert np.array_equal(geodesics.function(5)(np.arange(len(V)), points), d)
        differences = abs(geodesics.spline(5)(np.arange(len(V)), points) - expected)
        assert differences.mean() < 0.01 and differences.max() < 0.1
        path = geodesics.function(5).shortest_path(77)
        assert len(path.segments[0]) == 0 and path.length == pytest.approx(d[77], rel=1e-3)
    with pytest.raises(rl.InputError, match="no triangle"):
        rl.Geodesics(V[:2], normals=V[:2])

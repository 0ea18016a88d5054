# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Functional maps: between a sheet and the same sheet rolled onto a cylinder, with other triangles."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

import restricted_laplacian as rl
from restricted_laplacian._maps import _Samples

from rolled_sheet import rolled_sheet


def vertex_near(plane, *places):
    return [int(np.argmin(((plane - p) ** 2).sum(axis=1))) for p in places]


@pytest.fixture(scope="module")
def pair():
    """Source, coarse and nearly flat, and target, fine and rolled: places, triangles, spectra."""
    coarse, fine = (np.arange(n + 1) / n for n in (20, 50))
    sheets = rolled_sheet(coarse, coarse, 1e-3), rolled_sheet(fine, fine, 2.5)
    spectra = [rl.laplace_spectrum(points, faces, 60, depth=5) for _, points, faces in sheets]
    return [s[0] for s in sheets], [s[2] for s in sheets], spectra


def errors(found, planes, faces):
    """How far the found points are from the true ones, in the plane."""
    assert found.faces.min() >= 0 and found.barycentric.min() >= 0
    assert abs(found.barycentric.sum(axis=1) - 1).max() < 1e-12
    return np.linalg.norm(np.einsum("nk,nkc->nc", found.barycentric, planes[0][faces[0][found.faces]]) - planes[1], axis=1)


def test_a_rolled_sheet(pair):
    planes, faces, (source, target) = pair
    places = (0.1, 0.1), (0.9, 0.2), (0.2, 0.9)
    landmarks = tuple(vertex_near(plane, *places) for plane in planes)
    by_landmarks = rl.functional_map(source, target, landmarks=landmarks, count=20)
    by_signatures = rl.functional_map(source, target, count=20)
    x = [plane[:, :1] - 0.4 for plane in planes], [np.sin(5 * plane[:, 1:]) for plane in planes]
    by_descriptors = rl.functional_map(source, target, [np.hstack(c) for c in zip(*x)], landmarks=landmarks, count=20)
    for found in (by_landmarks, by_signatures, by_descriptors):
        assert found.matrix.shape == (20, 20)
        # a map of isometric surfaces is orthogonal and commutes with the Laplacians
        assert abs(found.matrix[:12, :12].T @ found.matrix[:12, :12] - np.eye(12)).max() < 0.1
        assert errors(found.point_map(), planes, faces).mean() < 0.02
    # far better than the distance of vertices of the source, 0.05
    assert errors(by_landmarks.point_map(), planes, faces).mean() < 4e-3
    larger = rl.zoomout(by_landmarks, 50, step=3)
    assert larger.matrix.shape == (50, 50)
    e = errors(larger.point_map(), planes, faces)
    assert e.mean() < 6e-3 and e.max() < 0.05
    # functions go along
    f = [np.cos(4 * plane[:, 0]) * plane[:, 1] for plane in planes]
    moved = target.vertex_values[:, :50] @ larger.coefficients(f[0])
    assert np.sqrt(np.mean((moved - f[1]) ** 2)) < 0.02
    both = larger.coefficients(np.stack([f[0], 2 * f[0]], axis=1))
    assert both.shape == (50, 2) and np.allclose(both[:, 1], 2 * both[:, 0])


def test_zoomout_mends_a_bad_map(pair):
    planes, faces, spectra = pair
    places = (0.1, 0.1), (0.9, 0.2), (0.2, 0.9)
    good = rl.functional_map(*spectra, landmarks=tuple(vertex_near(plane, *places) for plane in planes), count=12)
    before, after = 0.0, 0.0
    for seed in range(3):
        noise = 0.1 * np.random.default_rng(seed).standard_normal((12, 12))
        bad = rl.FunctionalMap(good.matrix + noise, *spectra)
        before += errors(bad.point_map(), planes, faces).mean() / 3
        after += errors(rl.zoomout(bad, 50, step=2).point_map(), planes, faces).mean() / 3
    assert before > 0.025 and after < before / 2.5, (before, after)


def test_maps_between_other_bases(pair):
    """Eigenfunctions of the target mixed among each other: a matrix that is not symmetric, and the same points."""
    planes, faces, (source, target) = pair
    places = (0.1, 0.1), (0.9, 0.2), (0.2, 0.9)
    plain = rl.functional_map(source, target, landmarks=tuple(vertex_near(plane, *places) for plane in planes), count=12)
    mix = np.eye(60)
    mix[:12, :12] = np.linalg.qr(np.random.default_rng(4).standard_normal((12, 12)))[0]
    mixed = dataclasses.replace(target, vertex_values=target.vertex_values @ mix, coefficients=target.coefficients @ mix)
    turned = rl.FunctionalMap(mix[:12, :12].T @ plain.matrix, source, mixed)
    assert np.allclose(turned.point_map().points, plain.point_map().points, atol=1e-6)
    for step in (1, 4):
        found, expected = (rl.zoomout(m, 20, step=step).point_map().points for m in (turned, plain))
        assert np.linalg.norm(found - expected, axis=1).mean() < 1e-3


def test_points_without_faces():
    V, _ = rl.icosphere(3)
    X = V * [1, 0.8, 0.6] + 0.1 * V ** 2
    order = np.random.default_rng(1).permutation(len(V))
    # normals of the sphere are near enough
    source, target = (rl.laplace_spectrum(p, normals=n, count=20, depth=3) for p, n in ((X, V), (X[order], V[order])))
    landmarks = [0, 50, 100], [int(np.flatnonzero(order == v)[0]) for v in (0, 50, 100)]
    found = rl.zoomout(rl.functional_map(source, target, landmarks=landmarks, count=15)).point_map()
    assert (found.faces == order).mean() > 0.95 and np.array_equal(found.points, X[found.faces])


def test_vertices_without_faces(pair):
    _, _, (source, target) = pair
    V, F = target.space._surface.points(), target.space._surface.faces()
    other = rl.laplace_spectrum(np.vstack([V, [[3, 3, 3]]]), F, 60, depth=5)
    for a, b in ((source, other), (other, source)):
        found = rl.zoomout(rl.functional_map(a, b, count=20), 24).point_map()
        is_lost = found.faces < 0
        assert is_lost.sum() == (b is other) and np.isnan(found.points[is_lost]).all() and np.isfinite(found.points[~is_lost]).all()


@pytest.mark.parametrize("unit", [1e-80, 1e80])
def test_units_of_length(unit):
    V, F = rl.icosphere(2)
    X = V * [1, 0.8, 0.6] + 0.1 * V ** 2
    spectra = [rl.laplace_spectrum(points, F, 20, depth=3) for points in (unit * X, unit * X[:, [1, 2, 0]])]
    found = rl.zoomout(rl.functional_map(*spectra, landmarks=([0, 30, 60], [0, 30, 60]), count=12)).point_map()
    assert np.linalg.norm(found.points / unit - X, axis=1).max() < 0.02


def test_narrow_strips_are_not_divided_without_end():
    x, y = np.mgrid[:9, :9].reshape(2, -1) / 8
    points = np.stack([x, 1e-4 * y, 0 * x], axis=1)
    i = np.arange(81).reshape(9, 9)
    a, b, c, d = (x.ravel() for x in (i[:-1, :-1], i[1:, :-1], i[1:, 1:], i[:-1, 1:]))
    faces = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    strip = rl.laplace_spectrum(points, faces, 10)
    samples = _Samples(strip, 3000)
    assert 1000 < len(samples.points) < 12000
    found = rl.FunctionalMap(np.eye(10), strip, strip).point_map()
    assert abs(found.points - points)[:, 0].max() < 1e-3


def test_what_maps_refuse(pair):
    planes, _, (source, target) = pair
    bad = np.full(len(planes[0]), np.nan)
    for pattern, call in {
            "source": lambda: rl.functional_map(1, target), "target": lambda: rl.functional_map(source, None),
            "count": lambda: rl.functional_map(source, target, count=61),
            "laplacian_weight": lambda: rl.functional_map(source, target, laplacian_weight=-1),
            "descriptors must be a pair": lambda: rl.functional_map(source, target, 3),
            "descriptors has the shape": lambda: rl.functional_map(source, target, (planes[1], planes[1])),
            "1 functions on the source, but 2": lambda: rl.functional_map(source, target, (planes[0][:, :1], planes[1])),
            "descriptors must be finite": lambda: rl.functional_map(source, target, (bad, planes[1][:, 0])),
            "landmarks must be a pair": lambda: rl.functional_map(source, target, landmarks=5),
            "landmarks names 1": lambda: rl.functional_map(source, target, landmarks=([1], [1, 2])),
            "landmarks must be vertices": lambda: rl.functional_map(source, target, landmarks=([10 ** 6], [1])),
            "initial": lambda: rl.zoomout(np.eye(3)), "step": lambda: rl.zoomout(rl.functional_map(source, target, count=5), step=0),
            "number": lambda: rl.zoomout(rl.functional_map(source, target, count=5), number=0),
            "values has the shape": lambda: rl.functional_map(source, target, count=5).coefficients(bad[:3])}.items():
        with pytest.raises(rl.InputError, match=pattern):
            call()
    with pytest.raises(rl.Canceled):
        rl.zoomout(rl.functional_map(source, target, count=5), 20, progress=lambda _: False)

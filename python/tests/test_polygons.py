# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Faces with more than three corners, as arrays, as lists and in meshes of other libraries."""

import pickle

import numpy as np
import pytest
import restricted_laplacian as rl

DEPTH = 3


def square(n, height=0.0):
    """Quads of a square, by rows."""
    x, y = np.meshgrid(np.linspace(0, 1, n + 1), np.linspace(0, 1, n + 1))
    V = np.stack([x, y, height * np.sin(7 * x) * np.cos(5 * y)], axis=-1).reshape(-1, 3)
    i = (np.arange(n)[:, None] * (n + 1) + np.arange(n)).ravel()
    return V, np.stack([i, i + 1, i + n + 2, i + n + 1], axis=1)


def mixed(n, height=0.0):
    """The same, but for two triangles in place of the last quad, and a hexagon of the first two."""
    V, quads = square(n, height)
    a, b, c, d = quads[-1]
    return V, [[0, 1, 2, n + 3, n + 2, n + 1], *quads[2:-1].tolist(), [a, b, c], [a, c, d]]


@pytest.mark.parametrize("make", [square, mixed])
def test_flat_polygons_give_what_their_triangles_give(make):
    V, F = make(8)
    space = rl.Space(V, F, depth=DEPTH)
    assert space.number_of_faces == len(F)
    assert space.area == pytest.approx(1)
    expected = rl.eigs(V, space.triangles, 6, depth=DEPTH)
    for surface in (space, (V, F), (V.tolist(), F if isinstance(F, list) else F.tolist())):
        values, phi = rl.eigs(surface, 6, **({} if surface is space else {"depth": DEPTH}))
        assert np.array_equal(values, expected[0])
        assert np.array_equal(phi, expected[1])
    assert rl.geodesic_distance(V, F, 0, exact=True)[-1] == pytest.approx(np.sqrt(2))
    assert "points" in rl.View(V, F, V[:, 0]).html()


def test_values_on_polygons():
    V, F = mixed(7, 0.1)
    space = rl.Space(V, F, depth=DEPTH)
    triangles = space.triangles
    polygons = space._surface.polygons_of_faces()
    assert len(triangles) == sum(len(f) - 2 for f in F)
    for k, t in enumerate(triangles):
        assert set(t) <= set(F[polygons[k]])
    of_faces = np.sin(17.0 * np.arange(len(F)))
    found = rl.solve_screened_poisson(V, F, of_faces, 10, depth=DEPTH)
    expected = rl.solve_screened_poisson(V, triangles, of_faces[polygons], 10, depth=DEPTH)
    assert np.array_equal(found, expected)
    assert np.ptp(found) > 1e-3
    corners = [np.sin(17.0 * i + 5.0 * np.asarray(f)) for i, f in enumerate(F)]
    of_triangles = [[np.sin(17.0 * polygons[k] + 5.0 * v) for v in t] for k, t in enumerate(triangles)]
    found = rl.fit_function(V, F, rl.Corners(corners), depth=DEPTH)
    assert np.allclose(found, rl.fit_function(V, triangles, rl.Corners(of_triangles), depth=DEPTH), atol=1e-12)
    with pytest.raises(rl.InputError, match="values at"):
        rl.fit_function(V, F, rl.Corners(corners[:-1]), depth=DEPTH)
    vectors = [np.stack([c, 2 * c, 3 * c], axis=1) for c in corners]
    found = rl.integrate_gradient(V, F, rl.Corners(vectors), depth=DEPTH)
    again = rl.integrate_gradient(V, triangles, rl.Corners([[[x, 2 * x, 3 * x] for x in t] for t in of_triangles]),
                                  depth=DEPTH)
    assert np.allclose(found, again, atol=1e-12)
    of_quads = rl.Corners(np.ones((49, 4)))
    assert np.allclose(rl.fit_function(*square(7), of_quads, depth=DEPTH), 1)


def test_errors_name_the_polygon():
    V, F = mixed(5)
    values = np.ones(len(F))
    values[20] = np.nan
    with pytest.raises(rl.InputError, match="face 20") as e:
        rl.solve_poisson(V, F, values)
    assert e.value.face == 20
    for bad, what in (([0, 1], "fewer than three"), ([0, 1, 2, 36], "does not exist"), ([0, 1, 2, -1], "does not exist"),
                      ([0, 1, 2, 0.5], "not whole"), ([], "fewer than three")):
        with pytest.raises(rl.InputError, match=f"face 20 .*{what}") as e:
            rl.Space(V, [*F[:20], bad, *F[21:]])
        assert e.value.face == 20
    with pytest.raises(rl.InputError, match="F "):
        rl.Space(V, [["a", "b", "c"], [0, 1, 2, 3]])


@pytest.mark.parametrize("geometry", ["flat", "smooth"])
def test_pickles_keep_polygons(geometry):
    V, F = mixed(5, 0.1)
    F[3] = [*F[3], F[3][-1]]  # a corner twice
    space = rl.Space(V, F, depth=DEPTH, geometry=geometry)
    again = pickle.loads(pickle.dumps(space))
    assert again.number_of_faces == len(F)
    assert np.array_equal(again.triangles, space.triangles)
    assert np.array_equal(again._surface.corners_of_polygons(), space._surface.corners_of_polygons())
    values = np.arange(float(len(F)))
    assert np.array_equal(rl.fit_function(again, values), rl.fit_function(space, values))


def test_distances_know_polygons():
    V, F = mixed(6)
    geodesics = rl.Geodesics(V, F)
    assert geodesics.number_of_faces == len(F)
    assert np.allclose(geodesics.distances(0, exact=True).distances, np.hypot(V[:, 0], V[:, 1]))

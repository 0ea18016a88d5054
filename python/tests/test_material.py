# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Diffusion and density, in each way that they can be given."""

import pickle

import numpy as np
import pytest
import restricted_laplacian as rl

DEPTH = 4


@pytest.fixture(scope="module")
def mesh():
    return rl.icosphere(3)


def coefficient(p):
    return 2 + p[:, 0] + 0.5 * p[:, 2]


def matrices(p):
    return coefficient(p)[:, None, None] * np.eye(3)


def test_ways_to_give_them(mesh):
    V, F = mesh

    def solution(diffusion, density):
        return rl.solve_poisson(V, F, V[:, 2], depth=DEPTH, tolerance=1e-10, diffusion=diffusion, density=density)
    expected = solution(coefficient(V), coefficient(V))
    largest = np.abs(expected).max()
    # linear functions of space are linear in each triangle
    for diffusion in (matrices(V), coefficient, matrices):
        assert np.abs(solution(diffusion, coefficient) - expected).max() < 1e-7 * largest
    on_faces = coefficient(V[F].mean(axis=1))
    assert 1e-6 < np.abs(solution(on_faces, on_faces) - expected).max() / largest < 0.02


def test_everything_takes_them(mesh):
    V, F = mesh
    options = dict(depth=DEPTH, diffusion=4.0, density=0.5)
    plain, scaled = (rl.laplace_spectrum(V, F, 9, tolerance=1e-8, **o) for o in (dict(depth=DEPTH), options))
    assert np.allclose(scaled.eigenvalues[1:], 8 * plain.eigenvalues[1:], rtol=1e-8)
    assert np.allclose(rl.eigs(V, F, 9, **options)[0][1:], 8 * plain.eigenvalues[1:], rtol=1e-4)
    f = V[:, 2]
    u = rl.solve_poisson(V, F, f, depth=DEPTH, tolerance=1e-8)
    assert np.allclose(rl.solve_poisson(V, F, f, tolerance=1e-8, **options), u / 8, atol=1e-7)
    # alpha rho u - D Laplacian u = rho f
    u = rl.solve_screened_poisson(V, F, f, 3, depth=DEPTH, tolerance=1e-8)
    assert np.allclose(rl.solve_screened_poisson(V, F, f, 24, tolerance=1e-8, **options), u / 8, atol=1e-7)
    u = rl.fit_function(V, F, f, smoothing=0.08, depth=DEPTH, tolerance=1e-8)
    assert np.allclose(rl.fit_function(V, F, f, smoothing=0.01, tolerance=1e-8, **options), u, atol=1e-6)
    v = np.tile([0.0, 0.0, 1.0], (len(F), 1))
    u = rl.integrate_gradient(V, F, v, depth=DEPTH)
    assert np.allclose(rl.integrate_gradient(V, F, v, **options), u, atol=1e-4)
    searched = rl.laplace_spectrum(V, F, 9, accuracy=1e-3, diffusion=4.0, density=0.5)
    assert searched.eigenvalues[1] == pytest.approx(8 * plain.eigenvalues[1], rel=2e-3)


def test_spaces_share_what_does_not_change(mesh):
    V, F = mesh
    space = rl.Space(V, F, depth=DEPTH)
    heavy = space.with_material(density=coefficient(V))
    S, M = heavy.operators()
    assert abs(S - space.stiffness()).max() < 1e-12
    assert M.sum() == pytest.approx(heavy.integrals().sum()) and M.sum() != pytest.approx(space.area, rel=0.1)
    assert heavy.depth == space.depth and abs(space.mass().sum() - space.area) < 1e-9
    assert abs(heavy.with_material().mass() - space.mass()).max() == 0
    again = pickle.loads(pickle.dumps(heavy))
    assert abs(again.mass() - M).max() == 0
    # eigenfunctions are orthonormal in the density
    spectrum = rl.laplace_spectrum(heavy, count=6, tolerance=1e-8)
    x = spectrum.functions().coefficients
    assert np.allclose(x.T @ (M @ x), np.eye(6), atol=1e-8)


def test_two_directions(mesh):
    V, F = mesh
    n = V / np.linalg.norm(V, axis=1, keepdims=True)
    first = np.cross(n, [0.3, 0.4, 0.5])
    directions = np.stack([3 * first, np.cross(n, first)], axis=1)
    factors = np.tile([4.0, 4.0], (len(V), 1))
    values = rl.eigs(V, F, 6, depth=DEPTH, diffusion=(directions, factors))[0]
    assert np.allclose(values[1:], 4 * rl.eigs(V, F, 6, depth=DEPTH)[0][1:], rtol=0.02)
    factors[:, 1] = 1
    assert rl.eigs(V, F, 2, depth=DEPTH, diffusion=(directions, factors))[0][1] < 0.9 * values[1]
    for bad in ((directions[:, 0], factors), (directions, factors[1:]), (directions[1:], factors[1:])):
        with pytest.raises(rl.InputError, match="diffusion"):
            rl.Space(V, F, depth=DEPTH, diffusion=bad)


def test_anisotropy(mesh):
    V, F = mesh
    space = rl.Space(V, F, depth=DEPTH)
    plain = rl.eigs(space, count=5)[0]
    for a in (0.0, 0.7, (0.7, 0.7)):  # the curvature of the unit sphere is 1
        values = rl.eigs(V, F, 5, depth=DEPTH, anisotropy=a)[0]
        assert np.allclose(values[1:], np.exp(-np.max(a)) * plain[1:], rtol=0.01)
        again = space.with_material(anisotropy=a)
        assert np.array_equal(rl.eigs(again, count=5)[0], values)
        assert np.array_equal(rl.eigs(pickle.loads(pickle.dumps(again)), count=5)[0], values)
    u = rl.solve_poisson(V, F, V[:, 2], depth=DEPTH)
    assert np.allclose(rl.solve_poisson(V, F, V[:, 2], depth=DEPTH, anisotropy=0.7), np.exp(0.7) * u, atol=0.02)
    both = rl.Space(V, F, depth=DEPTH, anisotropy=0.7, density=2)
    assert np.allclose(rl.eigs(both, count=5)[0][1:], values[1:] / 2, rtol=1e-3)
    points = rl.icosphere(4)[0]
    of_points = [rl.eigs(points, normals=points, count=5, depth=3, anisotropy=a)[0] for a in (0, 0.7)]
    assert np.allclose(of_points[1][1:], np.exp(-0.7) * of_points[0][1:], rtol=0.03)
    for bad in (-1.0, np.nan, (1.0, np.inf), (1, 2, 3)):
        with pytest.raises(rl.InputError, match="anisotropy"):
            rl.Space(V, F, depth=DEPTH, anisotropy=bad)
    with pytest.raises(rl.InputError, match="anisotropy"):
        rl.Space(V, F, depth=DEPTH, anisotropy=1.0, diffusion=1.0)
    with pytest.raises(rl.InputError, match="anisotropy.*depth"):
        rl.eigs(V, F, 4, accuracy=0.01, anisotropy=1.0)


def test_threads_do_not_matter(mesh):
    V, F = mesh
    one, two = (rl.solve_poisson(V, F, V[:, 0], depth=DEPTH, diffusion=coefficient, density=matrices(V)[:, 0, 0],
                                 threads=t) for t in (1, 2))
    assert np.array_equal(one, two)


def test_what_is_refused(mesh):
    V, F = mesh
    for bad in (0.0, -1.0, np.inf, np.nan):
        for name in ("diffusion", "density"):
            with pytest.raises(rl.InputError, match=name):
                rl.eigs(V, F, 4, depth=DEPTH, **{name: bad})
            values = np.ones(len(F))
            values[7] = bad
            with pytest.raises(rl.InputError, match="face 7"):
                rl.eigs(V, F, 4, depth=DEPTH, **{name: values})
    for shape in ((len(V), 2), (len(V), 2, 2), (len(V), 3), (5,)):
        with pytest.raises(rl.InputError, match="diffusion"):
            rl.eigs(V, F, 4, depth=DEPTH, diffusion=np.ones(shape))
    with pytest.raises(rl.InputError, match="density"):
        rl.eigs(V, F, 4, depth=DEPTH, density=np.ones((len(V), 3)))
    negative = np.tile(np.diag([1.0, 1.0, -1.0]), (len(V), 1, 1))
    with pytest.raises(rl.InputError, match="diffusion.*positive definite.*face"):
        rl.solve_poisson(V, F, V[:, 2], depth=DEPTH, diffusion=negative)
    with pytest.raises(rl.InputError, match="orthonormal"):
        rl.eigs(V, F, 4, depth=DEPTH, density=2, orthonormal="vertices")
    with pytest.raises(rl.InputError, match="orthonormal"):
        rl.eigs(rl.Space(V, F, depth=DEPTH).with_material(density=2), count=4, orthonormal="vertices")

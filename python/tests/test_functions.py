# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""What functions compute, against what is known."""

from __future__ import annotations

import numpy as np
import pytest
import scipy.sparse.linalg

import restricted_laplacian as rl
from conftest import data_file, read_off


def test_matrices_are_those_of_the_operator(sphere):
    V, F = sphere
    space = rl.Space(V, F, depth=4)
    S, M = space.operators()
    ones = np.ones(space.dimension)
    assert abs(S @ ones).max() < 1e-12 * abs(S).max()
    assert M.sum() == pytest.approx(space.area, rel=1e-12)
    assert abs(S - S.T).max() == 0
    assert S.has_sorted_indices and S.indices.dtype == np.int32
    assert np.allclose(space.integrals(), M @ ones, rtol=0, atol=1e-13)
    # Galerkin products
    P = space.prolongation(3)
    coarse = space.operators(level=3)
    assert abs(P.T @ S @ P - coarse.stiffness).max() < 1e-12 * abs(S).max()
    assert abs(P.T @ M @ P - coarse.mass).max() < 1e-12 * abs(M).max()


def test_matrices_outlive_the_space(sphere):
    V, F = sphere
    S = rl.Space(V, F, depth=4).stiffness()
    copy = S.copy()
    junk = [np.ones(10 ** 6) for _ in range(8)]
    assert (S != copy).nnz == 0
    del junk


def test_evaluation_matrices_give_values(sphere):
    V, F = sphere
    space = rl.Space(V, F, depth=4)
    u = rl.fit_function(space, None, np.stack([V[:, 0] * V[:, 1], V[:, 2]], axis=1), as_spline=True)
    E = space.evaluation_matrix()
    assert np.allclose(E @ u.coefficients, u.at_vertices(), rtol=0, atol=1e-14)
    faces = np.arange(0, len(F), 7)
    b = np.random.default_rng(1).dirichlet([1, 1, 1], len(faces))
    E = space.evaluation_matrix(faces, b)
    assert np.allclose(E @ u.coefficients, u(faces, b), rtol=0, atol=1e-14)
    D = np.stack([d @ u.coefficients for d in space.derivative_matrices(faces, b)], axis=1)
    n = space._surface.face_normals()[faces]
    tangential = D - n[:, :, None] * np.einsum("ni,nik->nk", n, D)[:, None, :]
    assert np.allclose(tangential, u.gradients(faces, b), rtol=0, atol=1e-12)
    # the gradient of z is the tangential part of the axis
    p = np.einsum("nij,ni->nj", V[F[faces]], b)
    axis = np.array([0, 0, 1]) - n * n[:, 2:]
    assert abs(u.gradients(faces, b)[:, :, 1] - axis).max() < 0.1
    assert abs(u(faces, b)[:, 1] - p[:, 2]).max() < 5e-3
    assert u.gradients_at_vertices().shape == (len(V), 3, 2)


def test_users_can_go_on_with_scipy(sphere):
    V, F = sphere
    space = rl.Space(V, F, depth=4)
    S, M = space.operators(stabilization=1e-3)
    x = scipy.sparse.linalg.spsolve((S + 2 * M).tocsc(), space.loads(V[:, 2]))
    by_solver = rl.PoissonSolver(space, 2, tolerance=1e-10).solve(space.loads(V[:, 2]))
    u, v = space.function(x).at_vertices(), space.function(by_solver).at_vertices()
    assert abs(u - v).max() < 1e-8
    assert abs(u - V[:, 2] / 4).max() < 2e-3


def test_arrays_faces_corners_and_callables_agree(sphere):
    V, F = sphere
    space = rl.Space(V, F, depth=4)
    at_vertices = V[:, 0] + 2 * V[:, 2]
    expected = space.loads(at_vertices)
    assert np.allclose(space.loads(rl.Corners(at_vertices[F])), expected, rtol=0, atol=1e-15)

    calls = []

    def f(points):
        calls.append(len(points))
        return points[:, 0] + 2 * points[:, 2]

    assert np.allclose(space.loads(f), expected, rtol=0, atol=1e-14)
    # once to see its shape, and then for many nodes at a time
    assert calls[0] <= 3 and min(calls[1:-1]) >= 2 ** 18 and sum(calls) > 10 * len(F)
    constant = np.arange(len(F)) % 5
    assert np.allclose(space.loads(constant),
                       space.loads(rl.Corners(np.repeat(constant[:, None], 3, axis=1))), rtol=0,
                       atol=1e-15)
    assert np.allclose(space.loads(3.0), 3 * space.integrals(), rtol=0, atol=1e-14)
    # of several components
    both = space.loads(lambda p: p[:, :2] ** 2)
    assert both.shape == (space.dimension, 2)
    assert np.allclose(both[:, 1], space.loads(lambda p: p[:, 1] ** 2), rtol=0, atol=1e-15)


def test_vector_fields(sphere):
    V, F = sphere
    space = rl.Space(V, F, depth=4)
    axis = np.tile([0.0, 0.0, 1.0], (len(F), 1))
    expected = space.gradient_loads(axis)
    corners = rl.Corners(np.tile([0.0, 0.0, 1.0], (len(F), 3, 1)))
    vertices = np.tile([0.0, 0.0, 1.0], (len(V), 1))

    def field(points):
        return np.tile([0.0, 0.0, 1.0], (len(points), 1))

    for other in (corners, vertices, field):
        assert np.allclose(space.gradient_loads(other), expected, rtol=0, atol=1e-13)
    # channels are the last dimension
    two = np.stack([axis, 2 * axis[:, [2, 0, 1]]], axis=2)
    loads = space.gradient_loads(two)
    assert loads.shape == (space.dimension, 2)
    assert np.allclose(loads[:, 0], expected, rtol=0, atol=1e-13)
    u = rl.integrate_gradient(space, None, two, mean=[1, 2])
    assert abs(u - np.stack([V[:, 2] + 1, 2 * V[:, 0] + 2], axis=1)).max() < 5e-3

    def fields(points):
        return np.tile(two[0], (len(points), 1, 1))

    assert np.allclose(space.gradient_loads(fields), loads, rtol=0, atol=1e-13)


def test_solutions_of_several_columns(sphere):
    V, F = sphere
    u = rl.solve_poisson(V, F, V, tolerance=1e-8)
    assert u.shape == V.shape and abs(u + V / 2).max() < 3e-3
    one = rl.solve_poisson(V, F, V[:, 1], tolerance=1e-8)
    assert abs(u[:, 1] - one).max() < 1e-7
    column = rl.solve_poisson(V, F, V[:, 1:2], tolerance=1e-8)
    assert column.shape == (len(V), 1) and np.array_equal(column[:, 0], one)


def test_prescribed_values(sphere):
    V, F = sphere
    half = F[(V[F][:, :, 2] > -1e-9).all(axis=1)]
    used = np.unique(half)
    # z is an eigenfunction, and nearly 0 on the boundary, which is a zigzag along the equator
    u = rl.solve_poisson(V, half, -2 * V[:, 2], boundary_values=0.0)
    assert abs(u[used] - V[used, 2]).max() < 0.05
    assert np.isnan(u[np.setdiff1d(np.arange(len(V)), used)]).all()
    u = rl.solve_poisson(V, half, -2 * V[:, 2], boundary_values=lambda p: 1 + p[:, 2])
    assert abs(u[used] - 1 - V[used, 2]).max() < 0.01
    u = rl.solve_poisson(V, F, 0.0, constraints=([0, 3], [1.0, -1.0]))
    assert u[0] == pytest.approx(1, abs=1e-3) and u[3] == pytest.approx(-1, abs=1e-3)
    assert abs(u).max() < 1.001


def test_conditions_on_parts_of_a_boundary():
    n = 8
    x, y = np.meshgrid(np.arange(n + 1) / n, np.arange(n + 1) / n)
    V = np.stack([x.ravel(), y.ravel(), np.zeros(x.size)], axis=1)
    i = np.arange((n + 1) * n).reshape(n, n + 1)[:, :-1].ravel()
    F = np.concatenate([np.stack([i, i + 1, i + n + 2], 1), np.stack([i, i + n + 2, i + n + 1], 1)])
    x = V[:, 0]

    def error(**conditions):
        return abs(rl.solve_poisson(V, F, 0.0, depth=4, **conditions) - 1000 * x).max()

    left, sides = np.where(x == 0, 0, np.nan), np.where((x == 0) | (x == 1), 1000 * x, np.nan)
    assert error(boundary_values=sides) < 1e-3
    assert error(boundary_values=sides, vertex_data="smooth") < 1e-3
    assert error(boundary_values=rl.Corners(sides[F])) < 1e-3
    assert error(boundary_values=lambda p: np.select([p[:, 0] == 0, p[:, 0] == 1], [0, 1000],
                                                     np.nan)) < 1e-3
    assert error(boundary_values=left,
                 boundary_flux=lambda p: np.where(p[:, 0] > 1 - 1e-9, 1000.0, 0.0)) < 1e-3
    # as much flux as comes from f
    u = rl.solve_poisson(V, F, 4.0, boundary_flux=1.0, depth=4)
    expected = ((V[:, :2] - 0.5) ** 2).sum(axis=1) - 1 / 6
    assert abs(u - expected).max() < 1e-3
    with pytest.raises(rl.InputError, match="no part of a boundary"):
        rl.solve_poisson(V, F, 0.0, boundary_values=np.full(len(V), np.nan))
    with pytest.raises(rl.InputError, match="boundary_flux"):
        rl.solve_poisson(V, F, 0.0, boundary_values=0.0, boundary_flux=1.0)
    with pytest.raises(rl.InputError, match="boundary_flux"):
        rl.solve_poisson(V, F, 0.0, boundary_flux=np.full(len(V), np.nan))
    with pytest.raises(rl.InputError, match="several columns"):
        rl.solve_poisson(V, F, np.zeros((len(V), 2)), boundary_values=1.0)
    both = rl.solve_poisson(V, F, np.stack([0 * x + 4, x], axis=1), boundary_flux=1.0, depth=4)
    assert np.allclose(both[:, 0], u, atol=1e-6)
    assert np.allclose(both[:, 1], rl.solve_poisson(V, F, x, boundary_flux=1.0, depth=4), atol=1e-6)


def test_values_at_vertices_are_met():
    V, F = rl.icosphere(3)
    free, report = rl.solve_poisson(V, F, V[:, 2], constraints=([7], [0]), return_report=True)
    assert report["constraint_error"] <= 1e-8
    for value in (1, 100, 1e4):
        u, report = rl.solve_poisson(V, F, V[:, 2], constraints=([7], [value]), return_report=True)
        assert report.converged and abs(u[7] - value) <= 1e-6
        assert abs(u - value - free).max() <= 1e-4
    # with a weight they pull
    u = rl.solve_poisson(V, F, 0.0, constraints=([0, 3], [1, -1]), constraint_weight=10)
    assert 0.5 < u[0] < 0.99
    with pytest.raises(rl.InputError, match="constraints"):
        rl.solve_poisson(V, F, 0.0, constraints=([7, 8], [0, np.nan]))
    with pytest.raises(rl.InputError, match="two values for vertex 7"):
        rl.solve_poisson(V, F, 0.0, constraints=([7, 7], [0, 1]))


def test_values_at_vertices_hold_along_the_boundary():
    n = 16
    x, y = np.meshgrid(np.arange(n + 1) / n, np.arange(n + 1) / n)
    V = np.stack([x.ravel(), y.ravel(), np.zeros(x.size)], axis=1)
    a = (np.arange(n)[:, None] * (n + 1) + np.arange(n)).ravel()
    F = np.concatenate([np.stack([a, a + 1, a + n + 2], axis=1),
                        np.stack([a, a + n + 2, a + n + 1], axis=1)])
    sides = np.flatnonzero((V[:, 0] == 0) | (V[:, 0] == 1))
    for depth in (5, 6):
        u = rl.solve_poisson(V, F, 0.0, depth=depth, constraints=(sides, 1000 * V[sides, 0]))
        assert abs(u - 1000 * V[:, 0]).max() <= 1e-3


def test_screening_by_functions(sphere):
    V, F = sphere
    f = V[:, 2]
    number = rl.solve_screened_poisson(V, F, f, 3.0, tolerance=1e-9)
    for alpha in (np.full(len(V), 3.0), np.full(len(F), 3.0), lambda p: np.full(len(p), 3.0)):
        assert abs(rl.solve_screened_poisson(V, F, f, alpha, tolerance=1e-9) - number).max() < 1e-7


def test_memory_is_estimated(sphere):
    V, F = sphere
    estimates = [rl.estimate_memory(V, F, depth=depth) for depth in (5, 6)]
    for depth, estimate in zip((5, 6), estimates):
        space = rl.Space(V, F, depth=depth)
        assert abs(estimate.dimension / space.dimension - 1) < 0.05
        assert estimate.total == estimate.surface + estimate.solver
    assert estimates[0].surface == estimates[1].surface == 24 * len(V) + 20 * len(F)
    rl.Space(V, F, depth=6, maximum_memory=estimates[1].total)
    with pytest.raises(rl.InputError, match="a depth of 5 would take"):
        rl.Space(V, F, depth=6, maximum_memory=0.99 * estimates[1].total)


def test_binary_files_are_read_with_progress(sphere, tmp_path):
    V, F = sphere
    faces = np.zeros(len(F), np.dtype([("count", "u1"), ("corners", "<i4", 3)]))
    faces["count"], faces["corners"] = 3, F
    header = (f"ply\nformat binary_little_endian 1.0\nelement vertex {len(V)}\n"
              "property double x\nproperty double y\nproperty double z\n"
              f"element face {len(F)}\nproperty list uchar int vertex_indices\nend_header\n")
    file = tmp_path / "sphere.ply"
    file.write_bytes(header.encode() + V.astype("<f8").tobytes() + faces.tobytes())
    parts = []
    points, triangles = rl.read_mesh(file, progress=parts.append)
    assert np.array_equal(points, V) and np.array_equal(triangles, F)
    assert parts[-1] == 1 and parts == sorted(parts)
    with pytest.raises(rl.Canceled):
        rl.read_mesh(file, progress=lambda part: False)


def test_points_without_faces():
    V, _ = rl.icosphere(5)
    u = rl.solve_poisson(V, None, V[:, 2], normals=V, depth=4)
    assert abs(u + V[:, 2] / 2).max() < 0.02
    areas = np.full(len(V), 4 * np.pi / len(V))
    space = rl.Space(V, normals=V, areas=areas)
    assert space.area == pytest.approx(4 * np.pi)
    l, _ = rl.eigs(space, None, 4)
    assert l[1:] == pytest.approx([2, 2, 2], rel=0.02)
    assert abs(rl.curvature(2 * V, normals=V, depth=4).mean - 0.5).max() < 0.02


def test_reports_and_convergence(sphere):
    V, F = sphere
    u, report = rl.solve_poisson(V, F, V[:, 2], return_report=True)
    assert report.converged and report.iterations >= 1 and report["status"] == "converged"
    with pytest.raises(rl.ConvergenceError) as e:
        rl.solve_poisson(V, F, V[:, 2] ** 3, tolerance=1e-13, maximum_iterations=1)
    assert isinstance(e.value, RuntimeError)
    assert e.value.report.iterations == 1 and e.value.result.shape == (len(V),)
    u = rl.solve_poisson(V, F, V[:, 2] ** 3, tolerance=1e-13, maximum_iterations=1, check=False)
    assert np.array_equal(u, e.value.result)


def test_first_guess_ends_soon(sphere):
    V, F = sphere
    space = rl.Space(V, F, depth=4)
    solver = rl.PoissonSolver(space, 1, tolerance=1e-8)
    b = space.loads(V)
    x, far = solver.solve(b, return_report=True)
    y, near = solver.solve(b, x, return_report=True)
    assert near.iterations == 0 < far.iterations
    assert abs(x - y).max() < 1e-6


def test_components_have_zero_eigenvalues():
    V, F = rl.icosphere(2)
    many = np.concatenate([V + [3 * i, 0, 0] for i in range(5)])
    faces = np.concatenate([F + len(V) * i for i in range(5)])
    spectrum = rl.laplace_spectrum(many, faces, 4, depth=5)
    assert rl.number_of_zero_eigenvalues(spectrum) == 4  # all that were asked for
    assert rl.heat_kernel_signature(spectrum, [1.0]).shape == (len(many), 1)
    assert rl.number_of_zero_eigenvalues(rl.eigs(many, faces, 8, depth=5)[0]) == 5


def test_stitching():
    V, F = rl.icosphere(4)
    colors = 0.5 + 0.4 * V
    scans = []
    for eye, factor in (((0, 0, 5), 1.0), ((0, 0, -5), 0.8), ((5, 0, 0), 0.9), ((-5, 0, 0), 1.0),
                        ((0, 5, 0), 0.9), ((0, -5, 0), 1.0)):
        sees = (V[F] @ np.array(eye) > 1).all(axis=1)
        scans.append(rl.Scan(V, F[sees], factor * colors, viewpoint=eye))
    u, report = rl.stitch_colors(V, F, scans, depth=5, return_report=True)
    assert u.shape == V.shape and set(report.scans) == set(range(6))
    gain = (u * colors).sum() / (u * u).sum()
    assert abs(gain * u - colors).max() < 0.1
    assert report.jump_after < report.jump_before
    as_bytes = np.round(255 * colors).astype(np.uint8)
    assert rl.stitch_colors(V, F, [rl.Scan(V, F, as_bytes, viewpoint=(0, 0, 5))], oriented=True,
                            depth=4).max() <= 1


def test_nodes_of_callables_are_as_many_as_the_manual_says():
    V, F = read_off(data_file("elephant.off"))
    number = 0

    def f(points):
        nonlocal number
        number += len(points)
        return points[:, 2]

    rl.solve_poisson(V, F, f)
    assert 100 < number / len(F) < 200


def test_smooth_geometry():
    points, faces = rl.icosphere(3)
    sphere = 4 * np.pi
    flat = rl.Space(points, faces, depth=4)
    smooth = rl.Space(points, faces, depth=4, geometry="smooth")
    assert flat.area < 0.996 * sphere and abs(smooth.area / sphere - 1) < 1e-6
    assert flat.folded_faces == smooth.folded_faces == 0
    exact = np.array([0, 2, 2, 2, 6, 6, 6, 6, 6])
    errors = [np.abs(rl.eigs(space, None, 9, tolerance=1e-5)[0] - exact).max()
              for space in (flat, smooth)]
    assert errors[0] > 2e-2 and errors[1] < 2e-4
    # all edges are creases
    creased = rl.Space(points, faces, depth=4, geometry="smooth", crease_angle=0)
    assert abs(creased.area - flat.area) < 1e-9
    given = rl.Space(points, faces, depth=4, geometry="smooth", vertex_normals=-2 * points)
    assert abs(given.area - smooth.area) < 1e-6
    for argument, value in [("geometry", "round"), ("crease_angle", 181.0),
                            ("vertex_normals", points[1:]), ("vertex_data", "rough")]:
        with pytest.raises(rl.InputError) as e:
            rl.Space(points, faces, **{"geometry": "smooth", argument: value})
        assert e.value.argument == argument
    with pytest.raises(rl.InputError):
        rl.Space(points, normals=points, geometry="smooth")


def test_smooth_data():
    points, faces = rl.icosphere(4)
    x, y, z = points.T
    f, options = x * y * z, dict(depth=5, geometry="smooth", tolerance=1e-8)  # degree 3: -f / 12
    errors = {data: np.abs(rl.solve_poisson(points, faces, f, vertex_data=data, **options)
                           + f / 12).max() for data in (None, "linear", "smooth")}
    assert errors[None] == errors["linear"] > 10 * errors["smooth"] > 0

    # the same in a space, with several columns, and as fits and fields
    space = rl.Space(points, faces, depth=5, geometry="smooth", vertex_data="smooth")
    one = rl.solve_poisson(space, None, f, tolerance=1e-8)
    assert np.abs(one + f / 12).max() == errors["smooth"]
    both = rl.solve_poisson(space, None, np.stack([f, 2 * f], axis=1), tolerance=1e-8)
    assert np.allclose(both[:, 0], one, atol=1e-9) and np.allclose(both[:, 1], 2 * one, atol=1e-9)
    linear = rl.Space(points, faces, depth=5, geometry="smooth")
    values = np.stack([f, x], axis=1)
    fits = [np.abs(rl.fit_function(s, None, values) - values).max() for s in (linear, space)]
    assert fits[1] < 0.3 * fits[0]
    field = np.stack([y * z, x * z, x * y], axis=1)
    found = [np.abs(rl.integrate_gradient(s, None, field) - f).max() for s in (linear, space)]
    assert found[1] < 0.3 * found[0]
    # values on faces, and on points, remain what they are
    on_faces = np.arange(len(faces)) % 2 * 1.0
    assert np.array_equal(space.loads(on_faces), linear.loads(on_faces))
    cloud = dict(normals=points, depth=4)
    assert np.array_equal(rl.solve_poisson(points, None, f, vertex_data="smooth", **cloud),
                          rl.solve_poisson(points, None, f, **cloud))
    with pytest.raises(rl.InputError) as e:
        rl.solve_poisson(space, None, f, vertex_data="linear")
    assert "space" in str(e.value)


def test_projections():
    calls = []

    def sphere(p):
        calls.append(len(p))
        return p / np.linalg.norm(p, axis=1, keepdims=True)

    points, faces = rl.icosphere(2)
    moved = points * np.linspace(0.9, 1.1, len(points))[:, np.newaxis]
    space = rl.Space(moved, faces, depth=4, geometry=sphere)
    assert abs(space.area / (4 * np.pi) - 1) < 1e-4
    # vertices; two points of each edge, and the centers
    assert calls == [len(points), 3 * len(faces) + len(faces)]
    exact = np.array([0, 2, 2, 2, 6, 6, 6, 6, 6])
    assert np.abs(rl.eigs(moved, faces, 9, depth=4, geometry=sphere, tolerance=1e-5)[0]
                  - exact).max() < 1e-3
    mean = rl.curvature(points, faces, depth=4, geometry=sphere).mean
    assert np.abs(mean - 1).max() < 1e-2
    with pytest.raises(rl.InputError):
        rl.Space(points, faces, geometry=lambda p: p[:, :2])
    with pytest.raises(rl.InputError):
        rl.Space(points, faces, geometry=lambda p: np.nan * p)
    with pytest.raises(ZeroDivisionError):
        rl.Space(points, faces, geometry=lambda p: p / (1 // 0))


def test_spectra_say_how_they_were_computed():
    V, F = rl.icosphere(5)
    space = rl.Space(V, F, depth=5)
    assert rl.laplace_spectrum(space, count=9).report.eigensolver == "multigrid"
    assert rl.laplace_spectrum(rl.Space(V, F, depth=3), count=9).report.eigensolver == "shift-invert"
    with pytest.raises(rl.ConvergenceError, match='largest number.*eigensolver="shift-invert"'):
        rl.eigs(space, count=9, maximum_iterations=1, tolerance=1e-6)

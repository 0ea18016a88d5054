# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Whatever is given: a result, or an exception that says what is wrong."""

from __future__ import annotations

import gc
import subprocess
import sys

import numpy as np
import pytest

import restricted_laplacian as rl
import restricted_laplacian.learning

V, F = rl.icosphere(2)
f = V[:, 2]


def with_entry(array, index, value, dtype=None):
    result = np.array(array, dtype=dtype or array.dtype)
    result[index] = value
    return result


@pytest.mark.parametrize("points, faces, attribute, value", [
    (with_entry(V, (7, 1), np.nan), F, "vertex", 7),
    (with_entry(V, (9, 0), np.inf), F, "vertex", 9),
    (V, with_entry(F, (5, 2), -1), "face", 5),
    (V, with_entry(F, (6, 0), len(V)), "face", 6),
    (V, with_entry(F, (6, 0), 2 ** 40), "face", 6),
    (V, with_entry(F, (3, 1), 2 ** 63, np.uint64), "face", 3),
    (V, with_entry(F, (4, 1), 0.5, np.float64), "face", 4),
    (V, with_entry(F, (4, 1), np.nan, np.float64), "face", 4),
    (V[:, :2], F, "argument", "V"),
    (V, F[:, :2], "argument", "F"),
    (V.ravel(), F, "argument", "V"),
    (V, F[np.newaxis], "argument", "F"),
    ("points", F, "argument", "V"),
    (V.astype(object), F, "argument", "V"),
    (V.astype(complex), F, "argument", "V"),
    (V, F.astype(str), "argument", "F"),
    (V, F.astype(bool), "argument", "F"),
    ([[0, 0, 0], [1, 0]], F, "argument", "V"),
    (None, F, "argument", "V"),
    ({}, F, "argument", "V"),
])
def test_surfaces_that_cannot_be(points, faces, attribute, value):
    with pytest.raises(rl.InputError) as e:
        rl.eigs(points, faces, 3)
    assert isinstance(e.value, ValueError)
    assert getattr(e.value, attribute) == value
    assert (str(value) if attribute != "argument" else value) in str(e.value)


@pytest.mark.parametrize("points, faces", [
    (np.zeros((0, 3)), np.zeros((0, 3), int)),
    (V, np.zeros((0, 3), int)),
    (np.zeros((0, 3)), F),
    (np.zeros_like(V), F),
    (V, np.zeros_like(F)),
    (1e200 * V, F),
    (1e-200 * V, F),
])
def test_surfaces_without_area(points, faces):
    with pytest.raises(rl.InputError):
        rl.solve_poisson(points, faces, points[:, 2])


def field_of_record(values):
    """The same values, after a byte each, so that they are not aligned."""
    records = np.zeros(len(values), [("byte", "u1"), ("values", values.dtype, values.shape[1:])])
    records["values"] = values
    return records["values"]


@pytest.mark.parametrize("dtype", ["f2", "f4", "f8", ">f4", ">f8", np.longdouble])
@pytest.mark.parametrize("itype", ["i2", "i4", "i8", "u2", "u4", "u8", ">i4", "f4", "f8"])
def test_types_and_layouts(dtype, itype):
    points = V.astype(dtype)
    expected = rl.solve_poisson(points.astype(float), F, f, depth=3)
    for array in (points, np.asfortranarray(points), np.repeat(points, 2, axis=0)[::2],
                  np.pad(points, ((0, 0), (1, 2)))[:, 1:4], field_of_record(points)):
        array.setflags(write=False)
        faces = np.asfortranarray(F.astype(itype))
        faces.setflags(write=False)
        assert np.array_equal(rl.solve_poisson(array, faces, f, depth=3), expected)
    assert np.array_equal(
        rl.solve_poisson(points, field_of_record(F.astype(itype)), field_of_record(f), depth=3),
        expected)
    reverse = points[::-1]
    assert np.array_equal(rl.solve_poisson(reverse, len(V) - 1 - F, f[::-1], depth=3)[::-1],
                          expected)
    assert np.array_equal(rl.solve_poisson(points.tolist(), F.tolist(), f.tolist(), depth=3)
                          if points.dtype == np.float64 else expected, expected)


@pytest.mark.parametrize("call, argument", [
    (lambda: rl.solve_poisson(V, F, f[:-1]), "f"),
    (lambda: rl.solve_poisson(V, F, f.astype(object)), "f"),
    (lambda: rl.solve_poisson(V, F, np.zeros((len(V), 2, 2))), "f"),
    (lambda: rl.solve_poisson(V, F, f, depth=0.5), "depth"),
    (lambda: rl.solve_poisson(V, F, f, depth=-1), "depth"),
    (lambda: rl.solve_poisson(V, F, f, depth=40), "depth"),
    (lambda: rl.solve_poisson(V, F, f, depth=10 ** 30), "depth"),
    (lambda: rl.solve_poisson(V, F, f, tolerance=0), "tolerance"),
    (lambda: rl.solve_poisson(V, F, f, tolerance="small"), "tolerance"),
    (lambda: rl.Space(V, F, maximum_memory=0), "maximum_memory"),
    (lambda: rl.Space(V, F, maximum_memory=np.nan), "maximum_memory"),
    (lambda: rl.Space(V, F, depth=6, maximum_memory=1e6), "depth"),
    (lambda: rl.estimate_memory(V, F, depth=6, cube_scale=0), "cube_scale"),
    (lambda: rl.laplace_spectrum(rl.Space(V, F, depth=3, maximum_memory=rl.estimate_memory(
        V, F, depth=3).total), count=5), "count"),
    (lambda: rl.solve_poisson(V, F, f, stabilization=-1), "stabilization"),
    (lambda: rl.solve_poisson(V, F, f, cycle="x"), "cycle"),
    (lambda: rl.solve_poisson(V, F, f, maximum_iterations=-1), "maximum_iterations"),
    (lambda: rl.solve_poisson(V, F, f, maximum_iterations=1e30), "maximum_iterations"),
    (lambda: rl.solve_poisson(V, F, f, maximum_iterations=np.nan), "maximum_iterations"),
    (lambda: rl.fit_function(V, F, f, refinements=1.5), "refinements"),
    (lambda: rl.solve_poisson(V, F, f, constraints=([1e30], [0])), "constraints"),
    (lambda: rl.solve_poisson(V, F, f, constraints=([np.nan], [0])), "constraints"),
    (lambda: rl.solve_poisson(V, F, f, constraints=([0.5], [0])), "constraints"),
    (lambda: rl.solve_poisson(V, F, f, threads=0), "threads"),
    (lambda: rl.solve_poisson(V, F, f, threads=1.5), "threads"),
    (lambda: rl.solve_poisson(V, F, f, progress=3), "progress"),
    (lambda: rl.solve_poisson(V, F, f, boundary_values=0), "boundary_values"),
    (lambda: rl.solve_poisson(V, F, f, constraints=([-1], [0])), "constraints"),
    (lambda: rl.solve_poisson(V, F, f, constraints=([10 ** 9], [0])), "constraints"),
    (lambda: rl.solve_poisson(V, F, f, constraints=3), "constraints"),
    (lambda: rl.solve_poisson(V, F, f, joining_tolerance=-1), "joining_tolerance"),
    (lambda: rl.solve_poisson(V, F, lambda p: p[:, 0][:1]), "f"),
    (lambda: rl.solve_poisson(V, F, lambda p: 1.0), "f"),
    (lambda: rl.solve_screened_poisson(V, F, f, 0), "alpha"),
    (lambda: rl.solve_screened_poisson(V, F, f, -1), "alpha"),
    (lambda: rl.solve_screened_poisson(V, F, f, f[1:]), "alpha"),
    (lambda: rl.eigs(V, F, 0), "count"),
    (lambda: rl.eigs(V, F, 2.5), "count"),
    (lambda: rl.eigs(V, F, 10 ** 6), "count"),
    (lambda: rl.eigs(V, F, 3, eigensolver="best"), "eigensolver"),
    (lambda: rl.fit_function(V, F, f, smoothing=-1), "smoothing"),
    (lambda: rl.fit_function(V, F, f, refinements=-1), "refinements"),
    (lambda: rl.curvature(V, F, method="guess"), "method"),
    (lambda: rl.integrate_gradient(V, F, f), "v"),
    (lambda: rl.integrate_gradient(V, F, V[:, :2]), "v"),
    (lambda: rl.integrate_gradient(V, F, V, target=V, alpha=1), "target"),
    (lambda: rl.integrate_gradient(V, F, V, alpha=-1), "alpha"),
    (lambda: rl.Space(V), "F"),
    (lambda: rl.Space(V, normals=V[1:]), "normals"),
    (lambda: rl.Space(V, F, cube_scale=0.5), "cube_scale"),
    (lambda: rl.Space(V, normals=V, neighbors=0), "neighbors"),
    (lambda: rl.Space(V, normals=V, neighbors=2.5), "neighbors"),
    (lambda: rl.Space(V, F).function(f), "coefficients"),
    (lambda: rl.Space(V, F).evaluation_matrix([0]), "barycentric"),
    (lambda: rl.Scan(V, F, V[:, :2]), "colors"),
    (lambda: rl.Scan(V, F, 0 * V, pose=np.eye(3)), "pose"),
    (lambda: rl.Scan(V, F, 0 * V, viewpoint=(0, 0)), "viewpoint"),
    (lambda: rl.heat_kernel_signature(3), "spectrum"),
    (lambda: rl.heat_kernel_signature((f, f)), "spectrum"),
])
def test_arguments_that_cannot_be(call, argument):
    with pytest.raises(rl.InputError) as e:
        call()
    assert e.value.argument == argument, str(e.value)


def test_values_that_are_not_finite():
    for value in (np.nan, np.inf):
        with pytest.raises(rl.InputError):
            rl.solve_poisson(V, F, with_entry(f, 3, value))
        with pytest.raises(rl.InputError):
            rl.solve_poisson(V, F, lambda p: np.full(len(p), value))


@pytest.mark.parametrize("unit, size", [(1e-80, 1), (1e80, 1), (1, 1e-200), (1, 1e150), (1e80, 1e80)])
def test_units_of_length_and_of_values(unit, size):
    """Results have the units that they ought to have, for tiny and huge ones, too."""
    def results(unit, size):
        X, u, o = unit * V, size * f, dict(depth=3)
        yield rl.solve_poisson(X, F, u, **o) / size / unit ** 2
        yield rl.solve_screened_poisson(X, F, u, 2 / unit / unit, **o) / size / unit ** 2
        yield rl.fit_function(X, F, u, **o) / size
        yield rl.integrate_gradient(X, F, size * (V + [0, 0, 1]), **o) / size / unit
        yield rl.diffuse(X, F, u, 0.01 * unit ** 2, **o) / size
        yield rl.smooth(X, F, u, 0.3 * unit, **o) / size
        yield rl.smooth_surface(X, F, 0.3 * unit, signal=u, **o) / size
        yield rl.sharpen_surface(X, F, 0.3 * unit, signal=u, **o) / size
        yield rl.mean_curvature_flow(X, F, 0.01 * unit ** 2, **o) / unit
        yield rl.curvature(X, F, **o).mean * unit
        yield rl.geodesic_distance(X, F, 0, exact=True) / unit
        for eigensolver in ("multigrid", "shift-invert"):
            spectrum = rl.laplace_spectrum(X, F, 12, eigensolver=eigensolver, depth=4)
            yield spectrum.eigenvalues[1:] * unit ** 2
            yield rl.wave_kernel_signature(spectrum, number=5) * unit ** 2
        yield rl.learning.precompute(X, F, 8).eigenvalues[1:] * unit ** 2

    for i, (found, expected) in enumerate(zip(results(unit, size), results(1, 1))):
        assert np.allclose(found, expected, rtol=1e-4, atol=1e-4), i


def test_locations_that_are_not_on_the_surface():
    u = rl.fit_function(V, F, f, as_spline=True)
    for faces in ([-1], [len(F)], [2 ** 40]):
        with pytest.raises(ValueError):
            u(faces, [[1, 0, 0]])
    with pytest.raises(ValueError):
        u([0], [[np.nan, 0, 0]])
    with pytest.raises(ValueError):
        u([0, 1], [[1, 0, 0]])


def test_exceptions_of_callables_come_back():
    def fails(points):
        if len(points) > 3:
            raise KeyError("of the caller")
        return points[:, 0]

    for threads in (1, None):
        with pytest.raises(KeyError, match="of the caller"):
            rl.solve_poisson(V, F, fails, threads=threads)
    with pytest.raises(rl.InputError):
        rl.solve_poisson(V, F, lambda p: p[:, 0] if len(p) <= 3 else p)
    with pytest.raises(rl.InputError):
        rl.solve_poisson(V, F, lambda p: p[:, 0] if len(p) <= 3 else p[:5, 0])


def random_array(random: np.random.Generator):
    """Something like an array that one may have by accident."""
    shape = tuple(random.integers(0, 6, random.integers(0, 4)))
    if random.random() < 0.5:
        shape = (int(random.integers(0, 40)), 3)
    kind = random.integers(0, 7)
    if kind == 0:
        array = random.normal(size=shape) * 10.0 ** random.integers(-300, 300)
    elif kind == 1:
        array = random.integers(-5, 50, shape)
    elif kind == 2:
        array = random.choice([0.0, 1.0, np.nan, np.inf, -np.inf, 1e308], shape)
    elif kind == 3:
        array = random.integers(0, 255, shape).astype(random.choice(["u1", "i1", "u2", "S3", "O"]))
    elif kind == 4:
        array = random.normal(size=shape) + 1j
    elif kind == 5:
        array = np.asfortranarray(random.normal(size=shape).astype("f4"))
    else:
        array = random.normal(size=shape)
    if array.ndim and random.random() < 0.3:
        array = array[::-1]
    return array


@pytest.mark.parametrize("seed", range(200))
def test_random_arrays(seed):
    random = np.random.default_rng(seed)
    functions = [
        lambda a, b, c: rl.solve_poisson(a, b, c, depth=3),
        lambda a, b, c: rl.eigs(a, b, 3, depth=3),
        lambda a, b, c: rl.fit_function(a, b, c, depth=3),
        lambda a, b, c: rl.integrate_gradient(a, b, c, depth=3),
        lambda a, b, c: rl.curvature(a, b, depth=3),
        lambda a, b, c: rl.Space(a, normals=b, areas=c, depth=3).operators(),
        lambda a, b, c: rl.heat_kernel_signature((a, b), c),
        lambda a, b, c: rl.Scan(a, b, c),
    ]
    for function in functions:
        a, b, c = (random_array(random) for _ in range(3))
        if random.random() < 0.5:
            a, b = V, F
        try:
            function(a, b, c)
        except (ValueError, RuntimeError):  # of this package, and of NumPy
            pass


@pytest.mark.parametrize("points, faces", [
    (V, with_entry(F, (5, 2), -1)), (V, with_entry(F, (6, 0), len(V))), (V, with_entry(F, (6, 0), 2 ** 40)),
    (V, with_entry(F, (3, 1), 2 ** 63, np.uint64)), (V, with_entry(F, (4, 1), 0.5, np.float64)),
    (V, with_entry(F, (4, 1), np.nan, np.float64)), (V[:, :2], F), (V, F[:, :2]), (V.ravel(), F),
    (V.astype(object), F), (V, F.astype(str)), (None, F), ({}, None),
])
def test_views_that_cannot_be(points, faces):
    with pytest.raises(rl.InputError):
        rl.View(points, faces)


@pytest.mark.parametrize("seed", range(8))
def test_views_of_random_arrays(seed, tmp_path, monkeypatch):
    from restricted_laplacian import _view
    template = tmp_path / "viewer.html"
    template.write_text("<!-- scene -->")  # the viewer itself plays no part here
    monkeypatch.setattr(_view, "_VIEWER", template)
    r = np.random.default_rng(seed)

    def numbers(*shape):
        values = r.normal(size=shape) * 10.0 ** r.integers(-308, 308)
        bad = r.random(shape) < 0.1
        return np.where(bad, r.choice([np.nan, np.inf, -np.inf, 0, 1.7e308, 5e-324], shape), values)

    n = int(r.integers(0, 50))
    faces = r.integers(0, n, (int(r.integers(0, 80)), 3)) if n else []
    view = rl.View(numbers(n, 3), faces, {"a": numbers(n), "b": numbers(n, 2)}, colors=numbers(n, 3),
                   normals=numbers(n, 3) if seed % 2 else None, lines=[numbers(4, 3), numbers(0, 3)],
                   title="\0\ud800"[:seed % 2])
    page = view.beside(view).html()
    assert page.count("<script") == 2 and "nan" not in page.split("</script>")[0].lower()


def test_too_little_memory_is_a_memory_error():
    pytest.importorskip("resource")
    program = """
import resource
import restricted_laplacian as rl
V, F = rl.icosphere(6)
rl.eigs(*rl.icosphere(2), 3, threads=1)
used = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (used + 300 * 2 ** 20, -1))
try:  # known before any work
    rl.solve_poisson(V, F, V[:, 2], depth=9, threads=1)
except rl.InputError as e:
    print(e.argument)
try:
    rl.Space(V, F, depth=9, maximum_memory=float("inf"), threads=1).operators()
except MemoryError as e:
    print("MemoryError", e)
rl.eigs(*rl.icosphere(2), 3, threads=1)
"""
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    refusal, error = done.stdout.splitlines()
    assert refusal == "depth"
    assert error.startswith("MemoryError not enough memory for the ")


def test_nothing_is_leaked():
    resource = pytest.importorskip("resource")
    big, faces = rl.icosphere(5)
    values = big[:, 2]

    def work():
        space = rl.Space(big, faces, depth=5)
        space.operators()
        rl.solve_poisson(space, None, values)
        rl.solve_poisson(space, None, lambda p: p[:, 2])
        try:
            rl.solve_poisson(space, None, lambda p: p[:2, 2] if len(p) > 3 else p[:, 2])
        except ValueError:
            pass
        gc.collect()

    for _ in range(3):
        work()
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    for _ in range(6):
        work()
    growth = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before
    assert growth < 60 * 1024  # kB; one space with its matrices has more

# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Each function gives what the C++ program gives, to the last bit."""

from __future__ import annotations

import subprocess

import numpy as np
import pytest

import restricted_laplacian as rl
from conftest import data_file, read_off

# closed, open, CAD
MESHES = ["elephant.off", "elephant-with-holes.off", "rotor_small.off"]


def run(programs, tmp_path, program, mesh, *options):
    """The columns of the table that a program writes."""
    table = tmp_path / "table.csv"
    command = [programs / program, mesh, "--csv", table, "--quiet", "--depth", "5", *options]
    subprocess.run([str(c) for c in command], check=True)
    lines = [line for line in table.read_text().splitlines() if not line.startswith("#")]
    return np.array([[float(x) for x in line.split(",")[1:]] for line in lines[1:]])


def same(a, b):
    return np.array_equal(np.asarray(a).reshape(b.shape), b, equal_nan=True)


@pytest.fixture(params=MESHES)
def mesh(request):
    path = data_file(request.param)
    return path, *read_off(path)


def test_poisson(programs, tmp_path, mesh):
    path, V, F = mesh
    expected = run(programs, tmp_path, "solve_poisson", path, "--rhs", "x", "--tolerance", "1e-6")
    assert same(rl.solve_poisson(V, F, V[:, 0], depth=5, tolerance=1e-6), expected)
    # the program subtracts the mean of the right-hand side, which it sums face by face
    space = rl.Space(V, F, depth=5)
    areas = space._surface.face_areas()
    mean = np.cumsum((areas[:, np.newaxis] * V[F, 2] / 3).ravel())[-1] / space.area
    expected = run(programs, tmp_path, "solve_poisson", path, "--alpha", "100")
    assert same(rl.solve_screened_poisson(space, None, V[:, 2] - mean, 100 / space.area), expected)


def test_points(programs, tmp_path):
    path = data_file("../points_3/kitten.xyz")
    table = np.loadtxt(path)
    expected = run(programs, tmp_path, "solve_poisson", path, "--rhs", "x")
    assert same(rl.solve_poisson(table[:, :3], None, table[:, 0], normals=table[:, 3:], depth=5),
                expected)


def test_fit(programs, tmp_path, mesh):
    path, V, F = mesh
    expected = run(programs, tmp_path, "fit_function", path, "--property", "x,y,z")
    assert same(rl.fit_function(V, F, V, depth=5), expected)


def test_curvature(programs, tmp_path, mesh):
    path, V, F = mesh
    expected = run(programs, tmp_path, "estimate_curvature", path)
    found = rl.curvature(V, F, depth=5)
    assert same(np.stack(found[:2], axis=1), expected)


def test_spectra(programs, tmp_path, mesh):
    path, V, F = mesh
    expected = run(programs, tmp_path, "laplace_spectrum", path, "--count", "12")
    values = rl.laplace_spectrum(V, F, 12, depth=5, eigenvalues_only=True)
    assert same(values.eigenvalues, expected[:, 0])
    assert same(values.estimated_errors, expected[:, 1]) and same(values.extrapolated_eigenvalues, expected[:, 2])
    assert values.vertex_values.size == 0
    spectrum = rl.laplace_spectrum(V, F, 12, depth=5)
    for name, found in (("hks", rl.heat_kernel_signature(spectrum, number=7)),
                        ("wks", rl.wave_kernel_signature(spectrum, number=7)),
                        ("gps", rl.global_point_signature(spectrum)),
                        ("biharmonic", rl.biharmonic_embedding(spectrum)),
                        ("diffusion", rl.diffusion_map(spectrum, 0.05 * spectrum.area)),
                        ("shape-dna", rl.shape_dna(values))):
        options = ["--columns", "7"] if name in ("hks", "wks") else []
        expected = run(programs, tmp_path, "spectral_descriptors", path, "--count", "12",
                       "--descriptor", name, *options)
        assert same(found, expected), name


def test_accuracies(programs, tmp_path, mesh):
    path, V, F = mesh
    expected = run(programs, tmp_path, "solve_poisson", path, "--rhs", "x", "--accuracy", "0.1")
    assert same(rl.solve_poisson(V, F, V[:, 0], accuracy=0.1, depth=5), expected)
    expected = run(programs, tmp_path, "laplace_spectrum", path, "--count", "12", "--accuracy", "0.1")
    values = rl.laplace_spectrum(V, F, 12, accuracy=0.1, depth=5, eigenvalues_only=True, check=False)
    assert same(values.eigenvalues, expected[:, 0])


def read_scan(path):
    """Points, triangles and colors of a file that `bake_scans` writes."""
    content = path.read_bytes()
    header, body = content.split(b"end_header\n", 1)
    n, m = (int(line.split()[2]) for line in header.decode().splitlines()
            if line.startswith("element"))
    vertex = np.dtype([("point", "<f8", 3), ("color", "u1", 3)])
    vertices = np.frombuffer(body, vertex, n)
    faces = np.frombuffer(body, [("size", "u1"), ("corners", "<i4", 3)], m, n * vertex.itemsize)
    return vertices["point"], faces["corners"], vertices["color"]


def test_stitching(programs, tmp_path, mesh):
    path, V, F = mesh
    folder = tmp_path / "scans"
    bake = [programs / "bake_scans", path, folder, "--views", "6", "--resolution", "64", "--quiet"]
    subprocess.run([str(c) for c in bake], check=True)
    poses = {line.split()[0]: np.array(line.split()[1:], dtype=float).reshape(4, 4)
             for line in (folder / "poses.conf").read_text().splitlines() if line[0] != "#"}
    files = sorted(poses)
    expected = run(programs, tmp_path, "stitch_colors", path, *(folder / f for f in files),
                   "--poses", folder / "poses.conf")
    scans = []
    for file in files:
        points, triangles, colors = read_scan(folder / file)
        scans.append(rl.Scan(points, triangles, colors, pose=poses[file]))
    assert same(rl.stitch_colors(V, F, scans, depth=5), expected)

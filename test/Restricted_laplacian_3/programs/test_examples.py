# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""That the examples run, and print what they should."""

import pathlib
import re

import numpy as np
import pytest
from conftest import SPHERE, fails, read_points, run, succeeds, write_off, write_xyz


def test_short_programs():
    # u = -z / 2
    low, high = map(float, re.findall(r"-?\d+\.\d+", succeeds("minimal_poisson sphere.off").out))
    assert -0.51 < low < -0.49 and 0.49 < high < 0.51
    out = succeeds("minimal_descriptors sphere.off").out
    assert len(re.findall("^heat kernel signature at time ", out, re.M)) == 5
    assert re.search(r"^biharmonic distance.* 0\.", out, re.M) and re.search(r"^ShapeDNA: *0 *25\.", out, re.M)
    out = succeeds("minimal_curvature sphere.off").out
    low, high = map(float, re.search("^mean curvature is between (.*) and (.*)", out, re.M).groups())
    assert 0.95 <= low <= high <= 1.05 and "error of 0.0" in out
    result = succeeds("minimal_gradient_field sphere.off")
    assert 0 <= float(re.search("^splines: largest error ([^ ]*) ", result.out, re.M)[1]) <= 0.02
    assert 0 <= float(re.search("^with details: largest error ([^ ]*) ", result.out, re.M)[1]) <= 0.001
    out = succeeds("minimal_stitching sphere.off").out
    before, after = (float(re.search(rf"(\S+) {word}", out)[1]) for word in ("before", "after"))
    assert 0 < after < before / 2, "seams vanish"
    result = succeeds("minimal_distances sphere.off")
    assert float(re.search("^the vertex that is farthest.*: (.*)", result.out, re.M)[1]) == pytest.approx(np.pi, abs=0.01)
    write_off("elephant.off", *SPHERE)
    assert float(succeeds("first_steps").out.split()[-1]) == pytest.approx(2, abs=0.02)
    out = succeeds("eigen_matrices").out
    assert float(re.search("error of u.* (.*)", out)[1]) < 1e-4


def test_usage_and_errors_of_examples():
    for program in ("poisson", "descriptors", "curvature", "gradient_field", "stitching", "distances", "points"):
        fails("usage", f"minimal_{program}")
    for program in ("generic_meshes", "laplacian_steps", "implicit_surface 2",
                    "implicit_fairing sphere.off", "custom_smoother", "solver_backends"):
        fails("usage", program)
    # CGAL adds a line of its own
    result = run("minimal_poisson missing.off")
    assert result.status == 1 and re.search("^usage: minimal_poisson", result.err, re.M)
    # the first three vertices have one face, without an area
    points, faces = SPHERE
    write_off("needle.off", np.concatenate([[[7, 7, 7], [8, 8, 8], [9, 9, 9]], points]),
              [*(faces + 3).tolist(), [0, 1, 2]])
    for program in ("minimal_poisson", "minimal_curvature", "minimal_descriptors"):
        out = succeeds(f"{program} needle.off").out
        assert not re.search("(between|from|to|and) -?nan", out), program
    # a mesh that the library refuses
    write_off("line.off", [[0, 0, 0], [1, 0, 0], [2, 0, 0]], [[0, 1, 2]])
    for program in ("poisson", "spectrum", "descriptors", "curvature", "gradient_field", "stitching"):
        fails(f"^minimal_{program}: .*area", f"minimal_{program} line.off")


def test_examples_of_surfaces():
    out = succeeds("generic_meshes sphere.off").out
    lines = re.findall("^[^:]*: u is at most (.{6}).*", out, re.M)
    assert len(lines) >= 2 and len(set(lines)) == 1, "the same solution with all types"
    write_xyz("minimal.xyz", SPHERE[0], SPHERE[0])
    lines = succeeds("minimal_points minimal.xyz").out.splitlines()
    assert len(lines) == 2 and float(lines[0].split(": ")[1].split()[1]) == pytest.approx(2, abs=0.05)
    rows = pathlib.Path("minimal.xyz").read_text().splitlines(True)
    pathlib.Path("no_normal.xyz").write_text("".join([*rows[:4], "0 0 1 0 0 0\n", *rows[5:]]))
    fails("^minimal_points: point 4 .*normal", "minimal_points no_normal.xyz")
    # flat, smooth, projection
    areas, values = np.array(re.findall("area (.*), eigenvalue (.*)", succeeds("implicit_surface 12").out), float).T
    assert len(areas) == 3
    assert 15.3 <= areas[0] <= 15.6, "faces have less area than the torus, 15.7914"
    assert np.abs(areas[1:] - 15.7914).max() < 6e-3 and np.abs(values[1:] - 1.02895).max() < 6e-4
    assert abs(values[0] - 1.02895) > 5e-3


def test_laplacian_steps():
    out = succeeds("laplacian_steps sphere.off").out
    area = re.search(" functions on a surface of area (.*)", out)[1]
    assert area == re.search("^entries of the mass matrix sum to (.*)", out, re.M)[1]
    # u = -x / 2, the first face is at (0, 0, -1), and the mean of the squared gradient is 1 / 6
    u = {name: float(value) for name, value in re.findall("^u([012]) = ([^,]*),", out, re.M)}
    assert 0.49 <= u["2"] <= 0.505 and all(0.005 <= u[name] <= 0.02 for name in "01")
    energies = [float(x) for x in re.findall("Dirichlet energy (.*)", out)]
    assert len(energies) == 3 and all(2.05 <= x <= 2.12 for x in energies)


def test_extensions():
    """The programs that show how to extend the package."""
    succeeds("implicit_fairing sphere.off smooth.off")
    # Coordinates are eigenfunctions for 2: a factor of 1 / (1 + 2 t), 0.9975 with t = area / 10000; and the faces
    # lie up to 0.4 % inside the sphere.
    radii = np.linalg.norm(read_points("smooth.off"), axis=1)
    assert len(radii) == 1026 and 0.9950 <= radii.min() and radii.max() <= 0.9975
    iterations = [int(x) for x in re.findall(r": (\d+) iterations", succeeds("custom_smoother sphere.off").out)]
    assert len(iterations) == 3 and 3 * iterations[2] < min(iterations[:2]), "patches are better than points and Jacobi"
    differences = [float(x) for x in re.findall("differs by ([^ ]*) in L2", succeeds("solver_backends sphere.off").out)]
    assert differences and all(0 <= x <= 1e-8 for x in differences)

# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""How programs are called and what they write is read. BUILD_DIR in the environment holds them, DATA_DIR
meshes of CGAL's data; what needs one is skipped, and said so, if it is not there."""

import os
import pathlib
import re
import shlex
import subprocess

import numpy as np
import pytest

BUILD = pathlib.Path(os.environ["BUILD_DIR"]).resolve()
DATA = pathlib.Path(os.environ.get("DATA_DIR", "data")).resolve()
ENVIRONMENT = dict(os.environ, LC_ALL="C", PATH=os.pathsep.join(
    [str(BUILD / "bin"), str(BUILD / "examples" / "Restricted_laplacian_3"), os.environ["PATH"]]))

# pages need what is bundled by Node.js, and the program that draws pictures a library
HAS_VIEWER = (BUILD / "viewer" / "viewer.html").exists()
HAS_DRAW_MESH = (BUILD / "bin" / "draw_mesh").exists()


class Result:
    """What a program printed, and its exit status."""

    def __init__(self, command, process):
        self.command, self.status = command, process.returncode
        self.bytes = process.stdout or b""
        self.out = self.bytes.decode("utf-8", "replace")
        self.err = (process.stderr or b"").decode("utf-8", "replace")

    def entry(self, name):
        """A word of the summary, a number if it is one."""
        words = [line.split()[1] for line in self.out.splitlines() if line.split()[:1] == [name]]
        assert words, f"{self.command} prints no {name}"
        try:
            return float(words[0])
        except ValueError:
            return words[0]

    def after(self, pattern):
        """The numbers after a pattern, one for each line that has it."""
        return [float(m[1]) for m in re.finditer(pattern + r"\s*(-?[\d.]+(?:e[-+]\d+)?)", self.out)]


def arguments(command):
    return shlex.split(command) if isinstance(command, str) else [str(word) for word in command]


def run(command, **options):
    process = subprocess.run(arguments(command), stdin=subprocess.DEVNULL, env=ENVIRONMENT,
                             **{"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **options})
    return Result(command, process)


def succeeds(command):
    """Exit status 0, and no word on the error stream."""
    result = run(command)
    assert result.status == 0, f"{command}: exit status {result.status}: {result.err}"
    assert result.err == "", command
    return result


def fails(pattern, command):
    """An exit status other than 0 that is not a crash, and one line that says what is wrong."""
    result = run(command)
    assert 0 < result.status < 126, f"{command}: exit status {result.status}"
    assert result.err.count("\n") == 1, f"{command}: not one line of error: {result.err}"
    assert re.search(pattern, result.err, re.I), f"{command}: the error names no {pattern}: {result.err}"
    return result


class Table:
    """A file that --csv writes: comments, names of columns, rows."""

    def __init__(self, file):
        self.text = pathlib.Path(file).read_text()
        lines = self.text.splitlines()
        self.comments = dict(line[2:].split(": ", 1) for line in lines if line.startswith("#"))
        self.rows = [line for line in lines if not line.startswith("#")]
        self.columns = self.rows.pop(0).split(",")
        self.values = np.array([[float(x) for x in row.split(",")] for row in self.rows])

    def __getitem__(self, column):
        return self.values[:, self.columns.index(column) if isinstance(column, str) else column]

    def comment(self, name):
        return float(self.comments[name])

    def check(self, columns):
        """Comments of a form, and rows that are numbered from 0."""
        assert ",".join(self.columns) == columns
        assert len(self.rows) > 0
        for line in self.text.splitlines():
            if not line.startswith("#"):
                break
            assert re.match(r"# [a-z_]+: .", line), line
        for i, row in enumerate(self.rows):
            assert re.fullmatch(rf"{i}(,-?\d+(\.\d*)?(e[-+]\d+)?){{{len(self.columns) - 1}}}", row), row

    def check_numbers(self, names):
        for name in names.split():
            assert abs(self.comment(name)) <= 1e6, name


# Shapes, and what their solutions are compared with.


def sphere(n):
    """An octahedron with n^2 triangles in place of each of its faces, on the unit sphere."""
    number, points, faces = {}, [], []

    def vertex(*p):
        if p not in number:
            number[p] = len(points)
            points.append(np.array(p) / np.linalg.norm(p))
        return number[p]
    signs = (-1, 1)
    for a, b, c in ((a, b, c) for a in signs for b in signs for c in signs):
        def add(*corners):
            p, q, r = (vertex(a * i, b * j, c * (n - i - j)) for i, j in corners)
            faces.append([p, q, r] if a * b * c > 0 else [p, r, q])
        for i in range(n):
            for j in range(n - i):
                add((i, j), (i + 1, j), (i, j + 1))
                if i + j + 1 < n:
                    add((i + 1, j), (i + 1, j + 1), (i, j + 1))
    return np.array(points), np.array(faces)


def moebius_strip(n):
    """3 n vertices on a circle of radius 1, with half a turn."""
    i, j = np.repeat(np.arange(n), 3), np.tile(np.arange(3), n)
    t = 2 * np.pi * i / n
    r = 1 + 0.1 * (j - 1) * np.cos(t / 2)
    points = np.stack([r * np.cos(t), r * np.sin(t), 0.1 * (j - 1) * np.sin(t / 2)], 1)

    def vertex(i, j):
        return 3 * i + j if i < n else 2 - j
    faces = [f for i in range(n) for j in range(2) for f in (
        [vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)],
        [vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)])]
    return points, np.array(faces)


def write_off(file, points, faces):
    lines = ["OFF", f"{len(points)} {len(faces)} 0"]
    lines += [" ".join(f"{x:.17g}" for x in p) for p in points]
    lines += [" ".join(map(str, [len(f), *f])) for f in faces]
    pathlib.Path(file).write_text("\n".join(lines) + "\n")


def read_points(file):
    """Of an OFF file."""
    lines = [line for line in pathlib.Path(file).read_text().split("\n") if line.strip()]
    return np.array([line.split() for line in lines[2:2 + int(lines[1].split()[0])]], float)


def write_xyz(file, points, normals):
    rows = np.hstack([points, normals])
    pathlib.Path(file).write_text("".join(" ".join(f"{x:.17g}" for x in row) + "\n" for row in rows))


def surface_mean(points, faces, values):
    """Of the function that is linear in each triangle."""
    p = points[faces]
    areas = np.linalg.norm(np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), axis=1) / 2
    return (areas * values[faces].mean(1)).sum() / areas.sum()


SPHERE, SMALL = sphere(16), sphere(4)  # 1026 vertices and 2048 faces, 66 and 128


def largest_difference(table, axis, factor):
    """Of the first values of a table from a factor times a coordinate of sphere.off."""
    return np.abs(Table(table)[1] - factor * SPHERE[0][:, "xyz".index(axis)]).max()


@pytest.fixture(autouse=True)
def meshes(tmp_path, monkeypatch):
    """The files that most tests use, in a folder of their own."""
    monkeypatch.chdir(tmp_path)
    write_off("sphere.off", *SPHERE)
    write_off("small.off", *SMALL)
    write_off("large_sphere.off", 9 * SPHERE[0], SPHERE[1])


@pytest.fixture
def elephant():
    if not (DATA / "elephant.off").exists():
        pytest.skip(f"SKIPPED: there is no {DATA}/elephant.off")
    return DATA / "elephant.off"


@pytest.fixture
def draw_mesh():
    if not HAS_DRAW_MESH:
        pytest.skip("SKIPPED: there is no draw_mesh")

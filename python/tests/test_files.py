# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Files of meshes: what is read, and what a refusal says."""

import numpy as np
import pytest
import restricted_laplacian as rl

SQUARE = "OFF\n4 2\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n"
FACES = [[0, 1, 2], [0, 2, 3]]


def written(folder, name, text):
    file = folder / name
    file.write_bytes(text.encode())
    return file


@pytest.mark.parametrize("name, text", [
    ("a.off", SQUARE.replace("\n", "\r")),
    ("a.OFF", "\ufeff" + SQUARE),
    ("a.obj", "v 0 0 0\nv 1 0 0 \\\n 1\nv 1 1 0\nv 0 1 0\nl 1 2\nf -4/1 -3 -2//3\nf 1 3 4\n"),
    ("a.vtk", "# vtk DataFile Version 4.2\n\nASCII\nDATASET POLYDATA\nPOINTS 4 int\n0 0 0 1 0 0 1 1 0 0 1 0\n"
              "POLYGONS 2 8\n3 0 1 2 3 0 2 3\n"),
    ("a.stl", "a comment\nSOLID\n" + "".join(
        f"FACET NORMAL 0 0 0 OUTER LOOP VERTEX {a} VERTEX {b} VERTEX {c} ENDLOOP ENDFACET\n"
        for a, b, c in (("0 0 0", "1 0 0", "1 1 0"), ("0 0 0", "1 1 0", "0 1 0")))),
])
def test_files_are_read_as_they_are_meant(tmp_path, name, text):
    V, F = rl.read_mesh(written(tmp_path, name, text))
    assert V.tolist() == [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
    assert F.tolist() == FACES


def test_a_refusal_names_the_place(tmp_path):
    with pytest.raises(rl.InputError, match=r"comma.off', line 5, vertex 2: '1,5' .*decimal commas") as e:
        rl.read_mesh(written(tmp_path, "comma.off", SQUARE.replace("1 1 0", "1,5 1 0")))
    assert (e.value.vertex, e.value.face) == (2, None)
    with pytest.raises(rl.InputError, match=r"line 8, face 1: names vertex 9, of 4") as e:
        rl.read_mesh(written(tmp_path, "index.off", SQUARE.replace("3 0 2 3", "3 0 2 9")))
    assert (e.value.vertex, e.value.face) == (None, 1)
    for name, text, reason in (("a.vtp", "<VTKFile/>", "suffix .vtp, which is not read; known are .off"),
                               ("a.off", "", "has 0 bytes"), ("b.off", "OFF\n1 0\n0 0 0\n", "holds no face")):
        with pytest.raises(rl.InputError, match=reason):
            rl.read_mesh(written(tmp_path, name, text))
    with pytest.raises(rl.InputError, match="is a directory"):
        (tmp_path / "folder.ply").mkdir()
        rl.read_mesh(tmp_path / "folder.ply")
    with pytest.raises(rl.InputError, match="cannot be opened"):
        rl.read_mesh(tmp_path / "nothing.ply")


def test_what_is_passed_over_is_a_warning(tmp_path):
    triangle = np.zeros(1, dtype=[("normal", "<f4", 3), ("points", "<f4", (3, 3)), ("more", "<u2")])
    triangle["points"] = [[[0, 0, 0], [1, 0, 0], [0, 1, 0]]]
    file = tmp_path / "a.stl"
    file.write_bytes(b"solid".ljust(80) + np.uint32(1).tobytes() + triangle.tobytes() + b"more")
    with pytest.warns(UserWarning, match="there are 4 bytes more"):
        V, F = rl.read_mesh(file)
    assert F.tolist() == [[0, 1, 2]]

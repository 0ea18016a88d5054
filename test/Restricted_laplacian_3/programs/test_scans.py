# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Colored scans: how they are made, and stitched."""

import os
import pathlib
import re

import numpy as np
import pytest
from conftest import Table, fails, sphere, succeeds, write_off

BALL = sphere(32)  # 4098 vertices, 8192 faces


@pytest.fixture(autouse=True)
def ball(meshes):
    write_off("ball.off", *BALL)


def bake(folder, options=""):
    """Scans of a sphere that is finer, with a pattern."""
    succeeds(f"bake_scans ball.off {folder} --quiet --views 6 --resolution 256 {options}")


def stitch(options, folder="scans", mesh="ball.off", poses=None, scans=None):
    files = scans or " ".join(map(str, sorted(pathlib.Path(folder).glob("scan_*.ply"))))
    return succeeds(f"stitch_colors {mesh} {files} --poses {poses or folder + '/poses.conf'} {options}")


def text(file):
    return pathlib.Path(file).read_bytes().decode("latin-1")


def test_scans():
    bake("scans")
    assert len(list(pathlib.Path("scans").glob("scan_*.ply"))) == 6
    assert len([line for line in text("scans/poses.conf").splitlines() if not line.startswith("#")]) == 6
    assert "element vertex 4098" in text("scans/truth.ply") and "property uchar red" in text("scans/truth.ply")
    # exposures from 1 / 1.3 to 1
    result = succeeds("bake_scans ball.off printed --views 6 --resolution 32 --exposure-range 0.3")
    rows = [line.split() for line in result.out.splitlines()[1:]]
    exposures = [float(row[3]) for row in rows]
    assert max(exposures) == 1 and min(exposures) == pytest.approx(0.769, abs=0.0005)
    assert sum(float(row[6]) for row in rows) == 0, "no color is clamped"
    result = succeeds("bake_scans ball.off printed --views 2 --resolution 32 --exposures 3,1")
    assert float(result.out.splitlines()[1].split()[6]) > 0, "clamped colors are counted"
    bake("again")
    assert text("scans/scan_03.ply") == text("again/scan_03.ply")
    bake("other", "--seed 1")
    assert text("scans/scan_03.ply") != text("other/scan_03.ply")
    bake("points", "--points")
    assert "property double nx" in text("points/scan_00.ply") and "element face" not in text("points/scan_00.ply")
    succeeds("bake_scans scans/truth.ply from_colors --views 2 --resolution 32 --quiet")
    assert text("scans/truth.ply") == text("from_colors/truth.ply"), "colors of a file are kept"
    pathlib.Path("occupied").touch()
    for words, pattern in {
            "": "no mesh", "ball.off": "no folder", "missing.off x": "missing.off", "ball.off x --views 0": "views",
            "ball.off x --resolution 1": "resolution", "ball.off x --light 2": "light",
            "ball.off x --exposures 1,1 --exposure-range 0.1": "not both",
            "ball.off x --views 6 --exposures 1,1": "2 numbers for 6 views",
            "ball.off x --views 2 --exposures 1,zero": "positive number",
            "ball.off occupied/x --views 2 --resolution 16": "cannot make the folder"}.items():
        fails(pattern, f"bake_scans {words}")
    assert not os.path.exists("x"), "nothing is written on an error"


def test_stitching():
    bake("scans")
    result = stitch("--depth 5 --truth scans/truth.ply --csv stitched.csv --output stitched.ply")
    assert result.entry("uncovered_area") <= 0.001 and result.entry("rms_error") < 0.01
    # edges are ten pixels long, which softens the steps of the pattern between them
    assert result.entry("jump") == pytest.approx(result.entry("true_jump"), abs=0.008)
    assert Table("stitched.csv").columns == ["vertex", "red", "green", "blue"]
    assert len(Table("stitched.csv").rows) == 4098
    assert "property uchar red" in text("stitched.ply") and "property double scan" in text("stitched.ply")
    nearest = stitch("--depth 5 --truth scans/truth.ply --method nearest")
    assert nearest.entry("jump") - nearest.entry("true_jump") > 0.02, "the nearest scans have seams"
    assert nearest.entry("rms_error") > 3 * result.entry("rms_error")
    bake("points", "--points")
    assert stitch("--depth 5 --truth points/truth.ply", "points").entry("rms_error") < 0.01


def test_stitching_options():
    bake("scans")
    stitch("--depth 4 --quiet --threads 1 --csv one.csv")
    stitch("--depth 4 --quiet --gradients scans --no-match-exposures --linear-light --no-details --csv other.csv")
    stitch("--depth 4 --quiet --threads 2 --csv two.csv")
    assert Table("one.csv").rows == Table("two.csv").rows != Table("other.csv").rows
    assert len(Table("one.csv").rows) == 4098
    # a scan in its own coordinates is a mesh as well
    result = stitch("--frame scan_02.ply --depth 4", mesh="scans/scan_02.ply", scans="scans/scan_02.ply")
    assert result.entry("uncovered_area") < 0.05
    # turned inside out, the sphere shows its back to all scans
    write_off("inside_out.off", BALL[0], BALL[1][:, [0, 2, 1]])
    scans = " ".join(map(str, sorted(pathlib.Path("scans").glob("scan_*.ply"))))
    fails("shows its back", f"stitch_colors inside_out.off {scans} --poses scans/poses.conf")
    result = stitch("--depth 4 --no-oriented --truth scans/truth.ply", mesh="inside_out.off")
    assert result.entry("rms_error") < 0.02
    far = "scan_05.ply 1 0 0 100 0 1 0 0 0 0 1 0 0 0 0 1\n"
    others = [line for line in text("scans/poses.conf").splitlines(True) if "scan_05.ply" not in line]
    pathlib.Path("far.conf").write_text(far + "".join(others))
    result = stitch("--depth 4 --leave-out", poses="far.conf")
    assert re.search(r"^5 .* 0.0 %.* 0.0 %.*scan_05.ply", result.out, re.M), "a scan that is far away is left out"
    # one scan sees half of the sphere
    assert stitch("--depth 4", scans="scans/scan_02.ply").entry("uncovered_area") > 0.4


def test_scans_of_points():
    """A square at z = 5 that faces the origin, and points on it without normals, red = 0.5 + x / 4."""
    x, y = (a.ravel() for a in np.meshgrid(*2 * [np.linspace(-1, 1, 9)], indexing="ij"))
    a = (np.arange(8)[:, None] * 9 + np.arange(8)).ravel()
    write_off("square.off", np.stack([x, y, 0 * x + 5], 1),
              np.stack([np.stack([a, a + 1, a + 10], 1), np.stack([a, a + 10, a + 9], 1)], 1).reshape(-1, 3))
    u, v = (a.ravel() for a in np.meshgrid(*2 * [np.linspace(-1.1, 1.1, 41)], indexing="ij"))
    header = ["ply", "format ascii 1.0", f"element vertex {len(u)}", *(f"property float {name}" for name in "xyz"),
              *(f"property uchar {name}" for name in ("red", "green", "blue")), "end_header"]
    rows = [f"{p:.6g} {q:.6g} 5 {int(255 * (0.5 + p / 4) + 0.5)} 100 50" for p, q in zip(u, v)]
    cloud = "\n".join(header + rows) + "\n"
    pathlib.Path("cloud.ply").write_text(cloud)
    pose = " 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\n"
    pathlib.Path("cloud.conf").write_text("cloud.ply" + pose)
    result = succeeds("stitch_colors square.off cloud.ply --poses cloud.conf --depth 4 --csv cloud.csv")
    assert result.entry("uncovered_area") == 0
    table = Table("cloud.csv")
    assert np.abs(table["red"] - 0.5 - x / 4).max() < 1e-2 and np.abs(table["green"] - 100 / 255).max() < 1e-2
    pathlib.Path("gray.ply").write_text(cloud.replace("property uchar green\n", "property uchar gray\n"))
    pathlib.Path("gray.conf").write_text("gray.ply" + pose)
    fails("gray.ply' has no colors", "stitch_colors square.off gray.ply --poses gray.conf")


IDENTITY = "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"
BAD_POSES = {
    "# nothing": "holds no pose",
    "scan_00.ply 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0": "line 1.*number 16 is missing",
    f"scan_00.ply {IDENTITY} 5": "more than a name and 16",
    "scan_00.ply 1 0 0 0 0 1 0 0 0 0 1 0 7 8 9 1": "last row",
    "scan_00.ply 1 0 0 0 0 1 0 0 0 0 -1 0 0 0 0 1": "mirror",
    "scan_00.ply 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 1": "singular",
    "scan_00.ply 1 1 0 0 0 1 0 0 0 0 1 0 0 0 0 1": "not a rotation",
    "scan_00.ply 1 0 0 nan 0 1 0 0 0 0 1 0 0 0 0 1": "number 4",
    "scan_00.ply 1 0 0 100 0 1 0 0 0 0 1 0 0 0 0 1": "scan_00.ply' misses the mesh",
}


def test_stitching_errors():
    bake("scans")
    scan, poses = "scans/scan_00.ply", "--poses scans/poses.conf"

    def fails_to_stitch(pattern, words):
        fails(pattern, f"stitch_colors ball.off {words} --depth 3 --csv x.csv")
    fails("no mesh", "stitch_colors")
    fails("no scan", f"stitch_colors ball.off {poses}")
    pathlib.Path("unknown.ply").write_bytes(pathlib.Path(scan).read_bytes())
    for words, pattern in {
            scan: "no poses", f"{scan} --poses missing.conf": "missing.conf", f"missing.ply {poses}": "missing.ply",
            f"unknown.ply {poses}": "no pose for 'unknown.ply'", f"{scan} {poses} --frame other": "no pose for 'other'",
            f"{scan} {poses} --alpha 0": "alpha", f"{scan} {poses} --normal-angle 0": "normal-angle",
            f"{scan} {poses} --method best": "method",
            f"{scan} {poses} --truth {scan}": "another number of vertices"}.items():
        fails_to_stitch(pattern, words)
    lines = text("scans/poses.conf")
    for bad, pattern in {**BAD_POSES, lines + lines.splitlines()[-1]: "has a pose already"}.items():
        pathlib.Path("bad.conf").write_text(bad + "\n")
        fails_to_stitch(pattern, f"{scan} --poses bad.conf")
    write_off("colorless.off", *BALL)
    pathlib.Path("bad.conf").write_text(f"colorless.off {IDENTITY}\n")
    fails_to_stitch("colorless.off' has no colors", "colorless.off --poses bad.conf")
    assert not os.path.exists("x.csv"), "nothing is written on an error"

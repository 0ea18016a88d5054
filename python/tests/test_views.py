# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Pages: what they hold is decoded here once more. What they look like, viewer/tests tests in a browser."""

from __future__ import annotations

import base64
import html
import json
import pathlib
import re
import shutil
import subprocess
import sys
import types
import zlib

import numpy as np
import pytest

import restricted_laplacian as rl

VIEWER = pathlib.Path(rl.__file__).with_name("viewer.html")


@pytest.fixture(autouse=True)
def viewer(request):
    if not VIEWER.exists() and "needs_no_viewer" not in request.keywords:
        pytest.skip("SKIPPED: this build has no viewer: it needs Node.js")


def decoded(page: str) -> dict:
    """The scene of a page: points, faces and fields of each surface."""
    text = re.search('<script id="scene" type="application/json">(.*?)</script>', page, re.S)[1]
    data = re.search('<script id="data" type="text/plain">(.*?)</script>', page, re.S)[1]
    rest = zlib.decompress(base64.b64decode(data))
    scene = json.loads(text)

    def take(size: int, stride: int, planes: int) -> np.ndarray:
        nonlocal rest
        codes = np.zeros(size, np.int64)
        for k in range(planes):
            codes |= np.frombuffer(rest[k * size:(k + 1) * size], np.uint8).astype(np.int64) << 8 * k
        rest = rest[planes * size:]
        return np.cumsum((codes >> 1 ^ -(codes & 1)).reshape(-1, stride), axis=0)

    def add_points(f: dict, n: int, p: dict) -> None:
        if "positions" in f:
            f["points"] = np.array(p["low"]) + p["step"] * take(3 * n, 3, f["positions"]["planes"])

    for s in scene["surfaces"]:
        n, p = s["vertices"], s["positions"]
        s["points"] = np.array(p["low"]) + p["step"] * take(3 * n, 3, p["planes"])
        s["triangles"] = take(3 * s["faces"], 3, s["triangles"]["planes"])
        if "normals" in s:
            s["normals"] = take(3 * n, 3, s["normals"]["planes"]) / 127
        for f in s["fields"]:
            if f["kind"] == "colors":
                f["values"] = take(3 * n, 3, f["planes"])
                add_points(f, n, p)
                continue
            codes = take(n, 1, f["planes"])[:, 0]
            t = (codes - 3) / (2 ** 24 - 4)
            f["values"] = np.where(codes >= 3, f["low"] * (1 - t) + f["high"] * t,
                                   np.array([np.nan, np.inf, -np.inf])[np.minimum(codes, 2)])
            add_points(f, n, p)
        if "lines" in s:
            sizes = take(s["lines"]["number"], 1, s["lines"]["sizes"]["planes"])[:, 0]
            points = s["lines"]["points"]
            codes = take(3 * points["number"], 3, points["planes"])
            s["lines"] = np.split(np.array(p["low"]) + p["step"] * codes, np.cumsum(sizes)[:-1])
    assert rest == b""
    return scene


def test_what_a_page_holds(sphere):
    V, F = sphere
    u = V[:, 2].copy()
    u[:3] = np.nan, np.inf, -np.inf
    page = rl.View(V, F, {"z": u, "xy": V[:, :2]}, colors=(255 * abs(V)).astype(np.uint8),
                   title='a "<script>" &', isolines=7, up="z", range={"z": (-2, 2)}).html()
    scene = decoded(page)
    assert scene["title"] == 'a "<script>" &' and scene["isolines"] == 7 and scene["up"] == "z"
    assert page.count("<script") == 3
    s, = scene["surfaces"]
    assert abs(s["points"] - V).max() < 2e-6
    assert (s["triangles"] == F).all()
    z, x, y, color = s["fields"]
    assert [f["name"] for f in s["fields"]] == ["z", "xy 0", "xy 1", "color"]
    assert z["range"] == [-2, 2] and np.allclose(x["range"], [V[:, 0].min(), V[:, 0].max()])
    assert np.isnan(z["values"][0]) and list(z["values"][1:3]) == [np.inf, -np.inf]
    assert abs(z["values"][3:] - u[3:]).max() < 2 * 6e-8
    assert abs(x["values"] - V[:, 0]).max() < 2 * 6e-8
    assert (color["values"] == (255 * abs(V)).astype(int)).all()


def test_a_surface_that_moves(sphere):
    V, F = sphere
    steps = {"first": V, "second": 2 * V + [3, 0, 0]}
    view = rl.View(V, F, {"first": V[:, 0], "second": V[:, 1], "back": V[:, 2]}, positions=steps, colors=abs(V))
    s, = decoded(view.html())["surfaces"]
    first, second, *others = s["fields"]
    assert abs(s["points"] - V).max() < 1e-5 and abs(first["points"] - V).max() < 1e-5
    assert abs(second["points"] - steps["second"]).max() < 1e-5, "beyond the box of the surface"
    assert not any("points" in field for field in others)
    painted, = decoded(rl.View(V, F, colors=abs(V), positions={"color": 3 * V}).html())["surfaces"]
    assert abs(painted["fields"][0]["points"] - 3 * V).max() < 1e-5


@pytest.mark.parametrize("colors, scale", [(np.int64, 255), (np.uint16, 65535), (np.float32, 1)])
def test_types_of_colors(sphere, colors, scale):
    V, F = sphere
    s, = decoded(rl.View(V, F, colors=(scale * abs(V)).astype(colors)).html())["surfaces"]
    assert abs(s["fields"][0]["values"] - 255 * abs(V)).max() <= 1.5


@pytest.mark.parametrize("scale", [1e-90, 1e-3, 1.0, 1e90])
def test_scales(sphere, scale):
    V, F = sphere
    s, = decoded(rl.View(scale * V + 3 * scale, F, 1e200 * scale * V[:, 0]).html())["surfaces"]
    assert abs(s["points"] / scale - V - 3).max() < 2e-6
    assert abs(s["fields"][0]["values"] / scale / 1e200 - V[:, 0]).max() < 2 * 6e-8


def test_largest_numbers(sphere):
    V, F = sphere
    u = np.where(V[:, 2] > 0, 1.7e308, -1.7e308)
    s, = decoded(rl.View(V, F, u).html())["surfaces"]
    assert np.allclose(s["fields"][0]["values"] / 1e308, u / 1e308, atol=1e-6)
    s, = decoded(rl.View(V, F, np.full(len(V), 5e-324)).html())["surfaces"]
    assert (s["fields"][0]["values"] <= 5e-324).all()


def test_hostile_surfaces(sphere):
    V, F = sphere
    # a vertex that is not finite takes its faces with it, and no other one
    W = V.copy()
    W[5] = np.nan
    s, = decoded(rl.View(W, F).html())["surfaces"]
    faces = F[(F != 5).all(axis=1)]
    assert s["leftOut"] == len(F) - len(faces) and (s["triangles"] == faces).all()
    assert abs(np.delete(s["points"] - V, 5, axis=0)).max() < 2e-6
    # a vertex far away that no face has does not count
    s, = decoded(rl.View(np.vstack([V, [[1e9, 0, 0]]]), F).html())["surfaces"]
    assert abs(s["points"][:-1] - V).max() < 2e-6
    # no triangle, no vertex, one point
    for faces in (np.empty((0, 3), int), [], None):
        s, = decoded(rl.View(V, faces, V[:, 0]).html())["surfaces"]
        assert s["faces"] == 0 and len(s["points"]) == len(V)
    s, = decoded(rl.View(np.empty((0, 3)), []).html())["surfaces"]
    assert s["vertices"] == 0
    s, = decoded(rl.View([[1, 2, 3]], None, [4]).html())["surfaces"]
    assert (s["points"] == [[1, 2, 3]]).all() and s["fields"][0]["values"] == 4
    # points with normals of any length
    s, = decoded(rl.View(V, normals=5 * V).html())["surfaces"]
    assert abs(s["normals"] - V).max() < 1 / 127


@pytest.mark.needs_no_viewer
@pytest.mark.parametrize("arguments, named, options", [
    (((3, 2), None), "V", {}), (((3, 3), [[0, 1, 5]]), "face 0", {}), (((3, 3), [[0, 1]]), "F", {}),
    (((3, 3), None, [1, 2]), "values", {}), (((3, 3), None), "normals", {"normals": np.ones((2, 3))}),
    (((3, 3), None), "colors", {"colors": np.ones((3, 2))}), (((3, 3), None), "up", {"up": "x"}),
    (((3, 3), None, [1, 2, 3]), "range", {"range": (1, 0)}),
    (((3, 3), None, [1, 2, 3]), "positions", {"positions": {"value": np.ones((2, 3))}}),
    (((3, 3), None, [1, 2, 3]), "positions", {"positions": {"other": np.ones((3, 3))}}),
])
def test_errors(arguments, named, options):
    shape, *others = arguments
    with pytest.raises(rl.InputError, match=named):
        rl.View(np.zeros(shape), *others, **options)


@pytest.mark.needs_no_viewer
def test_without_viewer(sphere, monkeypatch, tmp_path):
    from restricted_laplacian import _view
    monkeypatch.setattr(_view, "_VIEWER", tmp_path / "missing.html")
    with pytest.raises(rl.InputError, match="Node.js"):
        rl.View(*sphere).save_html(tmp_path / "x.html")
    assert not (tmp_path / "x.html").exists()


def test_results(sphere, tmp_path):
    V, F = sphere
    spectrum = rl.laplace_spectrum(V, F, 4, depth=4)
    spectrum.save_html(tmp_path / "s.html")
    scene = decoded((tmp_path / "s.html").read_text())
    s, = scene["surfaces"]
    assert len(s["fields"]) == 4 and scene["first"] == 1
    assert s["fields"][1]["name"].startswith("eigenfunction 1, eigenvalue 2.0")
    assert abs(s["fields"][1]["values"] - spectrum.vertex_values[:, 1]).max() < 1e-6
    # between the vertices: values of the spline
    u = rl.fit_function(V, F, V[:, 2], depth=4, as_spline=True)
    s, = decoded(u.view(refine=2).html())["surfaces"]
    assert s["vertices"] > 2 * len(V)
    assert abs(s["points"][:len(V)] - V).max() < 2e-6
    fine = s["fields"][0]["values"]
    assert abs(fine - s["points"][:, 2]).max() < 5e-3
    assert abs(fine[:len(V)] - u.at_vertices()).max() < 1e-6
    # distances, also between the vertices
    d = rl.Geodesics(V, F).function(0)
    s, = decoded(d.view(longest_side=0.05).html())["surfaces"]
    sides = s["points"][s["triangles"]] - s["points"][np.roll(s["triangles"], 1, axis=1)]
    assert np.linalg.norm(sides, axis=2).max() <= 0.05 + 1e-5
    unit = s["points"] / np.linalg.norm(s["points"], axis=1)[:, np.newaxis]
    exact = np.arccos(np.clip(unit @ V[0], -1, 1))
    assert abs(s["fields"][0]["values"] - exact).max() < 5e-3


def test_points(sphere):
    V, _ = sphere
    spectrum = rl.laplace_spectrum(V, normals=V, count=3, depth=4)
    s, = decoded(spectrum.view().html())["surfaces"]
    assert s["faces"] == 0 and abs(s["normals"] - V).max() < 1 / 127
    d = rl.Geodesics(V, normals=V).function(0)
    s, = decoded(d.view().html())["surfaces"]
    assert abs(s["fields"][0]["values"].max() - np.pi) < 0.05
    with pytest.raises(rl.InputError):
        d.view(longest_side=0.1)


def test_lines(sphere):
    V, F = sphere
    d = rl.Geodesics(V, F).function(0)
    path, circles = d.shortest_path(100), d.isolines(1.0)
    s, = decoded(d.view(lines=[path, *circles]).html())["surfaces"]
    assert len(s["lines"]) == 1 + len(circles)
    for found, line in zip(s["lines"], [path, *circles]):
        assert abs(found - line.points).max() < 2e-6


def test_side_by_side(sphere):
    V, F = sphere
    both = rl.View(V, F, V[:, 0], name="left").beside(rl.View(2 * V, F, V[:, 1], name="right"))
    assert [s["name"] for s in decoded(both.html())["surfaces"]] == ["left", "right"]


def test_cell_of_a_notebook(sphere):
    cell = rl.View(*sphere, sphere[0][:, 0])._repr_html_()
    assert cell.startswith("<iframe srcdoc=") and cell.count("<") == 2 and cell.count('"') % 2 == 0


def test_cells_of_a_notebook_share_a_viewer(sphere, monkeypatch, tmp_path):
    import builtins
    from restricted_laplacian import _view
    shell = types.SimpleNamespace(kernel=object(), parent_header={}, execution_count=4)
    monkeypatch.setattr(builtins, "get_ipython", lambda: shell, raising=False)
    monkeypatch.setattr(_view, "_cell_with_viewer", None)
    V, F = sphere
    views = [rl.View(V, F, V[:, axis], title=f"axis {axis}") for axis in range(3)]

    def run(view, **request):
        shell.execution_count += 1
        shell.parent_header = {"metadata": request}
        return view._repr_html_()
    cells = [run(views[0], cellId="a"), run(views[1], cellId="b"), run(views[2])]
    assert len(run(views[0], cellId="a")) == len(cells[0])  # once more
    size = len(cells[0])
    assert abs(size / 0.6e6 - 1) < 0.1  # as the manual says
    for cell, view in zip(cells[1:], views[1:]):
        assert cell.startswith("<iframe srcdoc=") and cell.count("<") == 2 and cell.count('"') % 2 == 0
        assert len(cell) < size / 5
        page = html.unescape(cell)
        assert decoded(page)["title"] == view._title
    chromium = shutil.which("chromium")
    if not chromium:
        pytest.skip("SKIPPED: Chromium was not found")
    # the cell without a viewer comes first, and has to wait
    probe = ("<script>setInterval(() => { const all = [...document.querySelectorAll('iframe')].map((f) => "
             "f.contentDocument); if (all.every((d) => d.defaultView.viewer)) document.title = all.map((d) => "
             "d.querySelector('h1').textContent + (d.getElementById('status')?.textContent ?? '')).join(); }, "
             "50);</script>")
    (tmp_path / "cells.html").write_text("<!doctype html><title>waiting</title>" + cells[1] + cells[0] + cells[2]
                                         + probe)
    shown = subprocess.run(
        [chromium, "--headless", "--no-sandbox", "--disable-gpu", "--enable-unsafe-swiftshader",
         "--virtual-time-budget=20000", "--dump-dom", (tmp_path / "cells.html").as_uri()],
        capture_output=True, text=True, timeout=100).stdout
    assert "<title>axis 1,axis 0,axis 2</title>" in shown, shown[:200]


def test_show_opens_a_browser(sphere, monkeypatch):
    import webbrowser
    opened = []
    monkeypatch.setattr(webbrowser, "open", opened.append)
    rl.View(*sphere).show()
    path = pathlib.Path(opened[0].removeprefix("file://"))
    assert decoded(path.read_text())["surfaces"][0]["vertices"] == len(sphere[0])
    path.unlink()


@pytest.mark.needs_no_viewer
def test_polyscope(sphere, monkeypatch):
    """Against a stand-in: Polyscope needs a window."""
    calls = []

    class Structure:
        def __getattr__(self, name):
            return lambda *arguments, **options: calls.append((name, arguments, options))

    module = types.ModuleType("polyscope")
    module.is_initialized = lambda: False
    module.init = lambda: calls.append(("init",))
    module.register_surface_mesh = lambda *a: calls.append(("mesh", a)) or Structure()
    module.register_point_cloud = lambda *a: calls.append(("points", a)) or Structure()
    monkeypatch.setitem(sys.modules, "polyscope", module)
    V, F = sphere
    rl.to_polyscope(V, F, {"x": V[:, 0], "square": V[:, 0] ** 2}, name="ball")
    assert [c[0] for c in calls] == ["init", "mesh", "add_scalar_quantity", "add_scalar_quantity"]
    assert calls[1][1][0] == "ball"
    assert calls[2][2] == {"enabled": True, "datatype": "symmetric"}
    assert calls[3][2] == {"enabled": False, "datatype": "standard"}
    calls.clear()
    rl.to_polyscope(rl.View(V, normals=V, colors=abs(V)))
    assert [c[0] for c in calls] == ["init", "points", "add_vector_quantity", "add_color_quantity"]

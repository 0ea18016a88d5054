# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Surfaces to turn around, in a browser or in a cell of a notebook."""

from __future__ import annotations

import html
import os
import pathlib
import tempfile
import webbrowser
from typing import Any, Callable, NamedTuple, Optional, Union

import numpy as np

from . import _core
from ._errors import InputError, argument_error
from ._input import make_surface, mesh_arrays, numbers, polygons_of, takes_surface

_VIEWER = pathlib.Path(__file__).with_name("viewer.html")

# values at the vertices: of one function, of several, or by name
Fields = Any


class _Field(NamedTuple):
    name: str
    values: np.ndarray  # (n,), or (n, 3) of a color
    is_color: bool
    range: Optional[tuple[float, float]]
    positions: Optional[np.ndarray]


class _Shown(NamedTuple):
    name: str
    points: np.ndarray
    faces: Optional[np.ndarray]
    normals: Optional[np.ndarray]
    fields: list[_Field]
    lines: list[np.ndarray]


def _three_columns(values: Any, name: str) -> np.ndarray:
    array = numbers(values, name, np.float64)
    if array.ndim != 2 or array.shape[1] != 3:
        raise argument_error(name, f"has the shape {array.shape}, but must have (n, 3)")
    return array


def _faces(values: Any, number: int) -> np.ndarray:
    array = numbers(values, "F")
    if array.size == 0:
        return np.empty((0, 3), np.uint32)
    if array.ndim != 2 or array.shape[1] != 3:
        raise argument_error("F", f"has the shape {array.shape}, but must have (m, 3)")
    is_vertex = (array >= 0) & (array < number) & (array == np.floor(array))  # and no NaN
    if not is_vertex.all():
        face = int(np.argwhere(~is_vertex)[0, 0])
        error = InputError(f"face {face} names a vertex that does not exist")
        error.face = face
        raise error
    return np.ascontiguousarray(array, np.uint32)


def _named(values: Fields) -> list[tuple[str, np.ndarray]]:
    """Names and values of the columns."""
    if values is None:
        return []
    if isinstance(values, dict):
        return [(f"{name} {k}" if array.shape[1] > 1 else str(name), array[:, k])
                for name, v in values.items() for array in [_columns(v, str(name))]
                for k in range(array.shape[1])]
    array = _columns(values, "values")
    return [("value" if array.shape[1] == 1 else f"value {k}", array[:, k])
            for k in range(array.shape[1])]


def _columns(values: Any, name: str) -> np.ndarray:
    array = numbers(values, name, np.float64)
    if array.ndim == 1:
        return array[:, np.newaxis]
    if array.ndim != 2:
        raise argument_error(name, f"has {array.ndim} dimensions, but must have one or two")
    return array


def _color_array(colors: Any, number: int) -> np.ndarray:
    array = numbers(colors, "colors")
    scale = float(np.iinfo(array.dtype).max) if array.dtype.kind in "iu" else 1.0
    if array.dtype.kind == "i":  # a type that has no sign is what such numbers come from
        scale = 255.0
    if array.shape not in ((number, 3), (number, 4)):
        raise argument_error("colors", f"has the shape {array.shape}, but must have ({number}, 3)")
    return np.ascontiguousarray(array[:, :3] / scale, np.float64)


class View:
    """A surface with values at its vertices, to be turned around.

    The last line of a cell of a notebook shows it. There and in files it needs no network.

    Parameters
    ----------
    V, F : array_like
        Points (n, 3) and triangles (m, 3); None for `F` shows points. Or a mesh object as `V`.
    values : array_like or dict, optional
        (n,) at the vertices; (n, K) for K functions, which a slider shows one by one; or such arrays
        by their names. NaN is no value.
    colors : array_like, optional
        (n, 3): red, green and blue, whole numbers up to 255 or others up to 1.
    normals : array_like, optional
        (n, 3), of points without faces.
    range : (float, float) or dict, optional
        Which values have the first and the last color; for each name if it is a dict. By default the
        smallest and the largest value.
    positions : dict, optional
        (n, 3) by names of `values`: where the vertices are while this function is shown, for instance after the
        steps of a flow.
    lines : list of Path or array_like, optional
        Lines on the surface: what `shortest_path` and `isolines` return, or points (k, 3) of each.
    name : str, default ""
        Of the surface, where several are shown.
    title : str, default "Surface"
        Of the page.
    isolines : int, default 0
        About so many at first.
    up : {"y", "z"}
        The axis that points up.
    first : int, default 0
        Number of the function that is shown first.

    Examples
    --------
    >>> import restricted_laplacian as rl
    >>> V, F = rl.icosphere(4)
    >>> view = rl.View(V, F, {"z": V[:, 2]}, title="a sphere", isolines=10)
    >>> both = view.beside(rl.View(V, F, {"x": V[:, 0]}))

    A sphere that shrinks, with a slider over the steps:

    >>> steps = {f"step {i}": (1 - 0.1 * i) * V for i in range(5)}
    >>> moving = rl.View(V, F, {name: X[:, 2] for name, X in steps.items()}, positions=steps)
    """

    @takes_surface
    def __init__(self, V: Any, F: Any = None, values: Fields = None, *, colors: Any = None,
                 normals: Any = None, range: Any = None, positions: Optional[dict[str, Any]] = None,
                 lines: Any = (), name: str = "", title: str = "Surface", isolines: int = 0, up: str = "y",
                 first: int = 0) -> None:
        if F is None and normals is None:
            V, F = mesh_arrays(V) or (V, None)
        if F is not None and polygons_of(F) is not None:
            F = make_surface(V, F).faces()
        points = _three_columns(V, "V")
        n = len(points)
        faces = None if F is None else _faces(F, n)
        if normals is not None:
            normals = _three_columns(normals, "normals")
            if len(normals) != n:
                raise argument_error("normals", f"has {len(normals)} rows, but must have {n}")
        if up not in ("y", "z"):
            raise argument_error("up", f"must be y or z, and is {up!r}")
        places = {}
        for key, rows in (positions or {}).items():
            places[key] = _three_columns(rows, f"positions[{key!r}]")
            if len(places[key]) != n:
                raise argument_error("positions", f"has {len(places[key])} rows for {key!r}, but there are {n} vertices")
        fields = []
        for key, array in _named(values):
            if len(array) != n:
                raise argument_error("values", f"has {len(array)} rows, but there are {n} vertices")
            own = range.get(key) if isinstance(range, dict) else range
            if own is not None:
                own = float(own[0]), float(own[1])
                if not own[0] < own[1]:
                    raise argument_error("range", "must be two numbers, the smaller one first")
            fields.append(_Field(key, np.ascontiguousarray(array), False, own, places.pop(key, None)))
        if colors is not None:
            fields.append(_Field("color", _color_array(colors, n), True, None, places.pop("color", None)))
        if places:
            raise argument_error("positions", f"names {next(iter(places))!r}, which values do not")
        drawn = [_three_columns(getattr(line, "points", line), "lines") for line in lines]
        self._shown = [_Shown(name, points, faces, normals, fields, drawn)]
        self._title, self._isolines, self._up, self._first = title, int(isolines), up, int(first)

    def beside(self, other: "View") -> "View":
        """Both, side by side under one camera; a slider takes them to the same number of function.

        Parameters
        ----------
        other : View
            What is shown to the right.

        Returns
        -------
        View
            Of all surfaces.
        """
        result = View.__new__(View)
        result.__dict__.update(self.__dict__)
        result._shown = self._shown + other._shown
        return result

    def html(self) -> str:
        """The page.

        Returns
        -------
        str
            HTML that needs no network.

        Raises
        ------
        InputError
            The package was built without Node.js, and has no viewer.
        """
        page = _core.Page(self._title, self._isolines, self._up, max(0, self._first))
        for s in self._shown:
            page.add_surface(s.name, s.points, s.faces, s.normals)
            for f in s.fields:
                page.add_field(f.name, f.values.ravel(), f.is_color, f.range, f.positions)
            for line in s.lines:
                page.add_line(line)
        return page.html(os.fspath(_VIEWER))

    def save_html(self, file: Union[str, "os.PathLike[str]"]) -> None:
        """Write the page: one file, which opens by double click.

        Parameters
        ----------
        file : str or os.PathLike
            Its name.
        """
        text = self.html()
        pathlib.Path(file).write_text(text, encoding="utf-8")

    def show(self, height: int = 520) -> None:
        """Show it in the cell of a notebook; elsewhere in the browser, by a file that stays.

        Parameters
        ----------
        height : int, default 520
            Of the cell, in pixels.
        """
        if _is_notebook():
            from IPython.display import HTML, display  # type: ignore[import-not-found,unused-ignore]
            display(HTML(self._frame(height)))
            return
        text = self.html()
        with tempfile.NamedTemporaryFile("w", suffix=".html", delete=False, encoding="utf-8") as f:
            f.write(text)
        webbrowser.open(pathlib.Path(f.name).as_uri())

    def _frame(self, height: int) -> str:
        page = self.html()
        if _is_notebook() and not _brings_viewer():
            page = _LOADER.replace("<!-- scene -->", page[slice(*_scene_of(page))])
        elif _is_notebook():
            page += _KEEPER
        return (f'<iframe srcdoc="{html.escape(page)}" width="100%" height="{int(height)}" '
                'style="border: 0"></iframe>')

    def _repr_html_(self) -> str:
        return self._frame(520)


# What a cell shows is a frame. The first one has the viewer, and leaves it in the page around it; the
# others take it from there, or from the frame of the first one.
_KEEPER = """<script>
try { parent.restrictedLaplacianViewer = frameElement.srcdoc; } catch (e) { /* another origin */ }
</script>
"""
_LOADER = """<!doctype html>
<meta charset="utf-8">
<p id="status" style="font: 14px sans-serif">Waiting for the viewer ...</p>
<!-- scene -->
<script>
function load(trials) {
  const begin = '<script id="scene"', data = '<script id="data"', end = '<' + '/script>';
  const isPage = (text) => text && text.startsWith('<!doctype html>\\n<html') && text.includes(begin);
  let page = null;
  try {
    const frames = [...parent.document.querySelectorAll('iframe')].map((f) => f.srcdoc);
    page = [parent.restrictedLaplacianViewer, ...frames].find(isPage);
  } catch (e) { /* another origin */ }
  if (!page && trials > 0) return setTimeout(load, 200, trials - 1);
  const status = document.getElementById('status');
  if (!page) {
    status.textContent = 'The viewer came with another cell, which is not here any more: restart the kernel '
      + 'and run all cells.';
    return;
  }
  const scene = document.getElementById('scene').outerHTML + document.getElementById('data').outerHTML;
  const last = page.indexOf(end, page.indexOf(data)) + end.length;
  document.open();
  document.write(page.slice(0, page.indexOf(begin)) + scene + page.slice(last));
  document.close();
}
addEventListener('load', () => load(50));  // a page that is still being read cannot be replaced
</script>
"""


def _scene_of(page: str) -> tuple[int, int]:
    """Where the scene of a page begins and ends."""
    end = "</script>"
    return page.index('<script id="scene"'), page.index(end, page.index('<script id="data"')) + len(end)


_cell_with_viewer: Any = None


def _brings_viewer() -> bool:
    """Whether the cell that runs is the first that shows something, or that one once more."""
    global _cell_with_viewer
    shell = get_ipython()  # type: ignore[name-defined]
    request = getattr(shell, "parent_header", None) or {}
    cell = (request.get("metadata") or {}).get("cellId") or f"execution {shell.execution_count}"
    if _cell_with_viewer is None:
        _cell_with_viewer = cell
    return bool(_cell_with_viewer == cell)


def _is_notebook() -> bool:
    try:
        shell = get_ipython()  # type: ignore[name-defined]
    except NameError:
        return False
    return hasattr(shell, "kernel")  # and not a terminal


class Viewable:
    """What can be seen: its `view`, saved or shown."""

    def view(self, **options: Any) -> View:
        """A `View`, which takes the options."""
        raise NotImplementedError

    def save_html(self, file: Union[str, "os.PathLike[str]"], **options: Any) -> None:
        """Write a page that shows it in a browser; with the options of `view`."""
        self.view(**options).save_html(file)

    def show(self, **options: Any) -> None:
        """Show it in the cell of a notebook, or in the browser; with the options of `view`."""
        self.view(**options).show()


def view_of_surface(surface: Any, names: list[str], values: np.ndarray,
                    at: Callable[[np.ndarray, np.ndarray], np.ndarray], longest_side: float,
                    options: dict[str, Any]) -> View:
    """A view of functions: at the vertices, or at those of the surface with its faces divided.

    `values` has a column for each name, and `at(faces, barycentric)` returns such rows anywhere. The
    faces stay if `longest_side` is 0.
    """
    normals = surface.face_normals() if surface.is_point_set else None
    points, faces = surface.points(), None if surface.is_point_set else surface.faces()
    if longest_side > 0:
        points, faces, face, barycentric, _ = _core.refined(surface, float(longest_side))
        values = np.full((len(points), len(names)), np.nan)
        is_located = face >= 0
        found = at(face[is_located], barycentric[is_located])
        values[is_located] = found.reshape(len(found), -1)
    fields = {name: values[:, k] for k, name in enumerate(names)}
    return View(points, faces, fields, normals=normals, **options)


@takes_surface
def to_polyscope(V: Any, F: Any = None, values: Fields = None, *, colors: Any = None,
                 normals: Any = None, name: str = "surface") -> Any:
    """Register a surface and its values in Polyscope, which is imported here.

    Parameters
    ----------
    V, F, values, colors, normals : as for View
        What is shown; or a `View` as `V`.
    name : str, default "surface"
        In Polyscope's lists.

    Returns
    -------
    polyscope.SurfaceMesh or polyscope.PointCloud
        A list of them for a `View` of several surfaces.

    Raises
    ------
    ImportError
        Polyscope is not installed.

    Examples
    --------
    >>> import restricted_laplacian as rl
    >>> V, F = rl.icosphere(4)
    >>> mesh = rl.to_polyscope(V, F, {"z": V[:, 2]})  # doctest: +SKIP
    """
    import polyscope  # type: ignore[import-not-found,unused-ignore]
    view = V if isinstance(V, View) else View(V, F, values, colors=colors, normals=normals)
    if not polyscope.is_initialized():
        polyscope.init()
    registered = []
    for i, s in enumerate(view._shown):
        label = s.name or (name if len(view._shown) == 1 else f"{name} {i}")
        if s.faces is not None and len(s.faces) > 0:
            structure = polyscope.register_surface_mesh(label, s.points, s.faces)
        else:
            structure = polyscope.register_point_cloud(label, s.points)
            if s.normals is not None:
                structure.add_vector_quantity("normal", s.normals)
        for k, f in enumerate(s.fields):
            if f.is_color:
                structure.add_color_quantity(f.name, f.values, enabled=len(s.fields) == 1)
                continue
            finite = f.values[np.isfinite(f.values)]
            is_symmetric = len(finite) > 0 and finite.min() < 0 < finite.max()
            structure.add_scalar_quantity(f.name, f.values, enabled=k == view._first,
                                          datatype="symmetric" if is_symmetric else "standard",
                                          **({"vminmax": f.range} if f.range else {}))
        registered.append(structure)
    return registered[0] if len(registered) == 1 else registered

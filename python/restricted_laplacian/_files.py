# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Meshes in files: our own readers, and those of nibabel, meshio and VTK where they are installed."""

from __future__ import annotations

import contextlib
import gzip
import importlib
import io
import os
from typing import Any, Callable, Iterator, Union

import numpy as np

from . import _core
from ._errors import InputError
from ._input import Progress, listener, make_surface, mesh_arrays

Name = Union[str, "os.PathLike[str]"]

_OTHERS = ".gii, .gii.gz, .vtp, the files of FreeSurfer, and what meshio reads"
_INSTALL = "pip install restricted-laplacian[files]"


def _refusal(file: str, reason: Any) -> InputError:
    return InputError(f"'{file}': {reason}")


def _import(name: str, file: str) -> Any:
    """An optional package."""
    try:
        return importlib.import_module(name)
    except ImportError:
        raise _refusal(file, f"needs the package {name.split('.')[0].replace('vtkmodules', 'vtk')}, which "
                       f"is not installed: {_INSTALL}") from None


def _first_bytes(file: str, number: int) -> bytes:
    try:
        with open(file, "rb") as f:
            return f.read(number)
    except OSError:
        return b""


def _reader_of(file: str) -> str:
    """Who reads a file: gifti, freesurfer, vtp, meshio, or own."""
    name = os.path.basename(file).lower()
    suffix = os.path.splitext(name)[1]
    if name.endswith((".gii", ".gii.gz")):
        return "gifti"
    if suffix == ".vtp":
        return "vtp"
    if suffix in (".annot", ".mgh", ".mgz"):
        return "freesurfer"
    if suffix in _core.mesh_suffixes:
        is_grid = suffix == ".vtk" and b"DATASET UNSTRUCTURED_GRID" in _first_bytes(file, 1000).upper()
        return "meshio" if is_grid else "own"
    # triangles; quadrangles; quadrangles of another kind, or numbers at vertices
    if _first_bytes(file, 3) in (b"\xff\xff\xfe", b"\xff\xff\xfd", b"\xff\xff\xff"):
        return "freesurfer"
    with contextlib.suppress(ImportError):
        import meshio  # type: ignore[import-not-found,import-untyped,unused-ignore]
        if suffix in meshio.extension_to_filetypes:
            return "meshio"
    return "own"


def _check(file: str) -> None:
    try:
        if os.path.isdir(file):
            raise _refusal(file, "is a directory")
        with open(file, "rb") as f:
            if not f.read(1):
                raise _refusal(file, "has 0 bytes")
    except OSError as e:
        raise _refusal(file, f"cannot be opened: {e.strerror}") from None


@contextlib.contextmanager
def _refused(file: str) -> Iterator[None]:
    """What another library raises, prints, or ends the process with, is an InputError."""
    said = io.StringIO()
    try:
        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
            yield
    except (InputError, MemoryError):
        raise
    except (Exception, SystemExit) as e:
        reason = said.getvalue() if isinstance(e, SystemExit) else f"{type(e).__name__}: {e}"
        raise _refusal(file, "cannot be read: " + " ".join(reason.split())) from None


def _gifti(file: str) -> Any:
    nibabel = _import("nibabel", file)
    with _refused(file):
        with (gzip.open if file.lower().endswith(".gz") else open)(file, "rb") as f:
            return nibabel.gifti.GiftiImage.from_bytes(f.read())


def _vtp(file: str) -> Any:
    reader = _import("vtkmodules.vtkIOXML", file).vtkXMLPolyDataReader()
    said: list[str] = []

    def hear(_reader: Any, _event: str, text: str) -> None:
        said.append(text.split("): ", 1)[-1].strip())
    hear.CallDataType = "string0"  # type: ignore[attr-defined]
    logger = _import("vtkmodules.vtkCommonCore", file).vtkLogger
    verbosity = logger.GetCurrentVerbosityCutoff()
    with _refused(file):
        for source in (reader, reader.GetExecutive()):
            source.AddObserver("ErrorEvent", hear)
        reader.SetFileName(file)
        logger.SetStderrVerbosity(logger.VERBOSITY_OFF)  # its parser cannot be listened to
        try:
            reader.Update()
        finally:
            logger.SetStderrVerbosity(verbosity)
        if said or reader.GetErrorCode():
            raise _refusal(file, "cannot be read" + "".join(f": {line}" for line in said[:1]))
        return reader.GetOutput()


def _meshio(file: str) -> Any:
    meshio = _import("meshio", file)
    with _refused(file):
        return meshio.read(file)


def _freesurfer_mesh(file: str) -> Any:
    freesurfer = _import("nibabel.freesurfer", file)
    with _refused(file):
        return freesurfer.read_geometry(file)[:2]


def _surface(file: str, progress: Progress) -> _core.Surface:
    reader = _reader_of(file)
    if reader == "own":
        try:
            return _core.Surface.of_file(file, listener(progress))
        except InputError as e:
            if "which is not read; known are" not in str(e):
                raise
            raise InputError(f"{e}; and {_OTHERS}, if it is installed: {_INSTALL}") from None
    _check(file)
    readers: dict[str, Callable[[str], Any]] = {
        "gifti": _gifti, "vtp": _vtp, "meshio": _meshio, "freesurfer": _freesurfer_mesh}
    mesh = readers[reader](file)
    try:
        arrays = mesh_arrays(mesh)
        if arrays is None:
            raise InputError("holds no points and faces")
        return make_surface(*arrays)
    except InputError as e:
        error = _refusal(file, e)
        error.face, error.vertex = e.face, e.vertex
        raise error from None


def read_mesh(file: Name, *, progress: Progress = None) -> tuple[np.ndarray, np.ndarray]:
    """Points and triangles of a file.

    Nothing is merged (but in stl files, which have no indices), cut or turned. Faces that are not
    triangles are divided. What is passed over, as bytes behind the end, is a warning.

    Parameters
    ----------
    file : str or os.PathLike
        Its name. Read are off, obj, ply, stl, vtk (legacy PolyData) and ts; with nibabel, GIFTI (gii,
        gii.gz) and the surfaces of FreeSurfer (``lh.pial``); with VTK, vtp; with meshio, its formats.
        ``pip install restricted-laplacian[files]`` installs all three.
    progress : bool or callable, optional
        A bar, or what is called with the part of the file that is read; of our own formats.

    Returns
    -------
    V : numpy.ndarray, (n, 3)
        Points.
    F : numpy.ndarray, (m, 3)
        Triangles: rows of V.

    Raises
    ------
    InputError
        The file cannot be read, or names no surface: with the line or byte and what is wrong there,
        and the vertex or face as attributes; or a package is needed that is not installed.

    See Also
    --------
    read_vertex_properties : What a file holds at the vertices.

    Examples
    --------
    >>> import pathlib, tempfile, restricted_laplacian as rl
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = pathlib.Path(folder) / "triangle.obj"
    ...     _ = file.write_text("v 0 0 0\\nv 1 0 0\\nv 0 1 0\\nf 1 2 3\\n")
    ...     V, F = rl.read_mesh(file)
    >>> F.tolist()
    [[0, 1, 2]]
    """
    surface = _surface(os.fspath(file), progress)
    return surface.points(), surface.faces()


def _unique(pairs: Any) -> dict[str, np.ndarray]:
    """Columns of one array, if there are several of a name."""
    columns: dict[str, list[np.ndarray]] = {}
    for name, values in pairs:
        columns.setdefault(name, []).append(np.asarray(values))
    return {name: arrays[0] if len(arrays) == 1 else np.stack(arrays, axis=-1)
            for name, arrays in columns.items()}


def _gifti_properties(file: str) -> dict[str, np.ndarray]:
    image = _gifti(file)
    labels = _import("nibabel.nifti1", file).intent_codes.label
    with _refused(file):
        return _unique(
            (array.meta.get("Name") or labels[array.intent].lower(), array.data) for array in image.darrays
            if labels[array.intent].lower() not in ("pointset", "triangle"))


def _freesurfer_properties(file: str) -> dict[str, np.ndarray]:
    freesurfer = _import("nibabel.freesurfer", file)
    suffix = os.path.splitext(file)[1].lower().lstrip(".")
    with _refused(file):
        if suffix == "annot":
            return {suffix: freesurfer.read_annot(file)[0]}
        if suffix in ("mgh", "mgz"):
            return {suffix: np.squeeze(np.asarray(freesurfer.load(file).dataobj))}
        if _first_bytes(file, 3) != b"\xff\xff\xff":
            return {}
        return {suffix or os.path.basename(file): freesurfer.read_morph_data(file)}


def _vtp_properties(file: str) -> dict[str, np.ndarray]:
    data = _vtp(file).GetPointData()
    vtk_to_numpy = _import("vtkmodules.util.numpy_support", file).vtk_to_numpy
    arrays = (data.GetArray(i) for i in range(data.GetNumberOfArrays()))
    return {array.GetName() or f"array {i}": vtk_to_numpy(array)
            for i, array in enumerate(arrays) if array is not None}  # texts are none


def read_vertex_properties(file: Name, *, progress: Progress = None) -> dict[str, np.ndarray]:
    """What a file holds at the vertices, by its names.

    Parameters
    ----------
    file : str or os.PathLike
        As for `read_mesh`; and data of GIFTI (``.shape.gii``, ``.func.gii``, ``.label.gii``) and of
        FreeSurfer (``lh.thickness``, ``.annot``, ``.mgh``).
    progress : bool or callable, optional
        As for `read_mesh`.

    Returns
    -------
    dict of numpy.ndarray
        (n,), or (n, K) of what has several components. Components have names of their own in ply,
        off and obj files: ``nx``, ``red``; there colors that are integers reach up to the largest of
        their type.

    Raises
    ------
    InputError
        As of `read_mesh`.

    See Also
    --------
    read_mesh : The points and triangles of a file.

    Examples
    --------
    >>> import pathlib, tempfile, restricted_laplacian as rl
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = pathlib.Path(folder) / "points.off"
    ...     _ = file.write_text("NOFF\\n1 0 0\\n0 0 0  0 0 1\\n")
    ...     rl.read_vertex_properties(file)["nz"].tolist()
    [1.0]
    """
    name = os.fspath(file)
    reader = _reader_of(name)
    if reader == "own":
        return {key: values.astype(type_) for key, type_, values in
                _core.read_vertex_properties(name, listener(progress))}
    _check(name)
    if reader == "meshio":
        return {key: np.asarray(values) for key, values in _meshio(name).point_data.items()}
    readers: dict[str, Callable[[str], dict[str, np.ndarray]]] = {
        "gifti": _gifti_properties, "vtp": _vtp_properties, "freesurfer": _freesurfer_properties}
    return readers[reader](name)

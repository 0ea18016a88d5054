# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""What networks on surfaces precompute, for a mesh or for a folder of them.

DiffusionNet and its kin need, of each shape, eigenpairs at the vertices, the areas of the vertices,
and gradient operators in tangent frames.

>>> import restricted_laplacian as rl
>>> from restricted_laplacian import learning
>>> V, F = rl.icosphere(3)
>>> o = learning.precompute(V, F, count=16, depth=4)
>>> o.eigenvectors.shape, o.gradient_x.shape
((642, 16), (642, 642))

Code that was written for DiffusionNet finds its functions here, too: `get_operators` and `get_all_operators`.
"""

from __future__ import annotations

import concurrent.futures
import contextlib
import hashlib
import json
import multiprocessing
import os
import pathlib
from concurrent.futures.process import BrokenProcessPool
from dataclasses import dataclass
from typing import Any, Callable, Iterator, Optional, Sequence, Union

import numpy as np
import scipy.sparse
import scipy.spatial

try:
    import fcntl
except ImportError:  # not on Windows
    fcntl = None  # type: ignore[assignment]

from ._core import __version__
from ._errors import argument_error
from ._files import read_mesh
from ._input import Progress, takes_surface
from ._show import shown
from ._space import Space, cotangent_operators
from ._spectra import laplace_spectrum


@shown()
@dataclass(frozen=True, repr=False)
class SurfaceOperators:
    """Operators of a surface at its n vertices.

    Attributes
    ----------
    eigenvalues : numpy.ndarray, (k,)
        Ascending, in units of 1 / area.
    eigenvectors : numpy.ndarray, (n, k)
        Orthonormal in the integral over the surface; 0 at vertices without a face.
    vertex_areas : numpy.ndarray, (n,)
        They sum to the area: a lumped mass matrix.
    frames : numpy.ndarray, (n, 3, 3)
        Of each vertex the rows are two tangents and the normal.
    gradient_x, gradient_y : scipy.sparse.csr_matrix, (n, n)
        From values at vertices to derivatives along the two tangents: least squares over neighbors.
    description : str
        JSON: the version of the package and the options that this was computed with.

    Arrays go to PyTorch without a copy: ``torch.from_dlpack(operators.eigenvectors)``.
    """

    eigenvalues: np.ndarray
    eigenvectors: np.ndarray
    vertex_areas: np.ndarray
    frames: np.ndarray
    gradient_x: scipy.sparse.csr_matrix
    gradient_y: scipy.sparse.csr_matrix
    description: str = "{}"

    def save(self, file: Union[str, "os.PathLike[str]"]) -> None:
        """Writes all to a file of NumPy (npz).

        Parameters
        ----------
        file : str or os.PathLike
            Its name.
        """
        x, y = self.gradient_x, self.gradient_y
        np.savez(file, eigenvalues=self.eigenvalues, eigenvectors=self.eigenvectors,
                 vertex_areas=self.vertex_areas, frames=self.frames, x=x.data, y=y.data,
                 indices=x.indices, indptr=x.indptr, description=self.description)

    @staticmethod
    def load(file: Union[str, "os.PathLike[str]"]) -> "SurfaceOperators":
        """Reads what `save` wrote.

        Parameters
        ----------
        file : str or os.PathLike
            Its name.

        Returns
        -------
        SurfaceOperators
            The same, to the last bit.
        """
        with np.load(file) as a:
            n = len(a["vertex_areas"])
            x, y = (scipy.sparse.csr_matrix((a[name], a["indices"], a["indptr"]), shape=(n, n))
                    for name in "xy")
            return SurfaceOperators(a["eigenvalues"], a["eigenvectors"], a["vertex_areas"],
                                    a["frames"], x, y, str(a["description"]))


def tangent_frames(normals: np.ndarray) -> np.ndarray:
    """Of each unit normal a matrix whose rows are two tangents and the normal; 0 where that is 0.

    Parameters
    ----------
    normals : numpy.ndarray, (n, 3)
        Of length 1 or 0.

    Returns
    -------
    numpy.ndarray, (n, 3, 3)
        The matrices.

    Raises
    ------
    ValueError
        The array has another shape.

    Examples
    --------
    >>> import numpy as np
    >>> tangent_frames(np.array([[0., 0., 1.]]))[0].round(6) + 0.
    array([[1., 0., 0.],
           [0., 1., 0.],
           [0., 0., 1.]])
    """
    # T. Duff and others, Building an orthonormal basis, revisited (2017)
    x, y, z = normals.T
    sign = np.where(z < 0, -1.0, 1.0)
    a = -1 / (sign + z)
    b = x * y * a
    frames = np.stack([
        np.stack([1 + sign * x * x * a, sign * b, -sign * x], axis=1),
        np.stack([b, sign + y * y * a, -y], axis=1), normals], axis=1)
    frames[~np.any(normals, axis=1)] = 0
    return frames


def gradient_operators(points: np.ndarray, frames: np.ndarray, pairs: np.ndarray
                       ) -> tuple[scipy.sparse.csr_matrix, scipy.sparse.csr_matrix]:
    """Derivatives along the tangents of frames, by least squares over neighbors.

    Parameters
    ----------
    points : numpy.ndarray, (n, 3)
        Where there are values.
    frames : numpy.ndarray, (n, 3, 3)
        Of each point, see `tangent_frames`.
    pairs : numpy.ndarray, (N, 2)
        Each point with each of its neighbors.

    Returns
    -------
    gradient_x, gradient_y : scipy.sparse.csr_matrix, (n, n)
        From values to derivatives along the first and the second tangent, in units of 1 / length.

    Raises
    ------
    IndexError
        A pair names no point.

    Examples
    --------
    >>> import numpy as np
    >>> points = np.array([[0., 0., 0.], [1., 0., 0.], [0., 1., 0.]])
    >>> frames = tangent_frames(np.array(3 * [[0., 0., 1.]]))
    >>> x, y = gradient_operators(points, frames, np.array([[i, j] for i in range(3) for j in range(3)]))
    >>> bool(abs(x @ points[:, 0] - 1).max() < 1e-6 and abs(y @ points[:, 0]).max() < 1e-6)
    True
    """
    n = len(points)
    i, j = pairs.T
    d = np.einsum("nab,nb->na", frames[i, :2], points[j] - points[i])
    normal_equations = np.zeros((n, 2, 2))
    np.add.at(normal_equations, i, d[:, :, None] * d[:, None, :])
    trace = np.trace(normal_equations, axis1=1, axis2=2)
    # a tiny part of the identity for vertices whose neighbors lie on a line
    normal_equations += (1e-10 * trace + (trace == 0))[:, None, None] * np.eye(2)
    weights = np.einsum("nab,nb->na", np.linalg.inv(normal_equations)[i], d)
    rows = np.concatenate([i, np.arange(n)])
    columns = np.concatenate([j, np.arange(n)])
    result = []
    for axis in range(2):
        center = -np.bincount(i, weights[:, axis], n)
        result.append(scipy.sparse.csr_matrix((np.concatenate([weights[:, axis], center]),
                                               (rows, columns)), shape=(n, n)))
    return result[0], result[1]


def _neighbors(space: Space, points: np.ndarray) -> np.ndarray:
    if space._surface.is_point_set:
        number = min(len(points), 30)
        near = scipy.spatial.cKDTree(points).query(points, number)[1].reshape(len(points), -1)
        pairs = np.stack([np.repeat(np.arange(len(points)), near.shape[1]), near.ravel()], axis=1)
        return pairs[pairs[:, 0] != pairs[:, 1]]
    faces = space._surface.faces()[space._surface.face_areas() > 0]
    edges = faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
    both = np.concatenate([edges, edges[:, ::-1]])
    both = both[both[:, 0] != both[:, 1]]
    return np.unique(both, axis=0)


# Of small meshes: at it a hundred eigenvalues have smaller errors than those of a cotangent Laplacian on the
# triangles, and take about as long.
_SMALL_DEPTH, _SMALL_NUMBER_OF_FACES = 4, 20000


def _depth_of(surface: Any) -> Optional[int]:
    """The depth for a surface, if none is given; None is that of `Space`."""
    is_small = not surface.is_point_set and surface.number_of_faces <= _SMALL_NUMBER_OF_FACES
    return _SMALL_DEPTH if is_small else None


@takes_surface
def precompute(V: Any, F: Any = None, count: int = 128, *, accuracy: Optional[float] = None,
               normals: Any = None, depth: Optional[int] = None, joining_tolerance: Optional[float] = None,
               threads: Optional[int] = None, progress: Progress = None, check: bool = True,
               cache: Union[None, str, "os.PathLike[str]"] = None) -> SurfaceOperators:
    """Eigenpairs, areas and gradient operators at the vertices of a surface.

    Parameters
    ----------
    V, F, normals, joining_tolerance : as for Space
        The surface: points (n, 3) and triangles (m, 3); or a pair of them, a mesh of another library, or a
        `Space` as `V` alone.
    depth : int, optional
        Of the octree. If it is not given it is 4 on meshes of up to 20,000 triangles, and as for `Space` on others.
    count : int, default 128
        Number of eigenpairs.
    accuracy : as for laplace_spectrum
        The estimated error to be reached.
    threads : int, optional
        By default all processors; one in a process that another one started, as the workers of a loader of data are,
        which share the processors.
    progress, check : as for solve_poisson
        How the work is done.
    cache : str or os.PathLike, optional
        A folder where the result is kept, and taken from if the same was computed before: same points and faces, same
        options, same version. Several processes may use it at once; what one is at work on, others wait for.

    Returns
    -------
    SurfaceOperators
        Arrays and matrices for the n vertices.

    Raises
    ------
    InputError
        A `ValueError` that names the face, the vertex or the argument.
    ConvergenceError
        A `RuntimeError`, with what was found.
    Canceled
        A callback of `progress` returned False.

    Examples
    --------
    >>> import restricted_laplacian as rl
    >>> from restricted_laplacian import learning
    >>> learning.precompute(rl.icosphere(3), count=16, depth=4).vertex_areas.shape
    (642,)
    """
    options: dict[str, Any] = {"count": count, "accuracy": accuracy, "depth": depth,
                               "joining_tolerance": joining_tolerance}
    if cache is not None:
        if isinstance(V, Space):
            raise argument_error("cache", "is for points and faces, not for a Space")
        cached = _cached_file(pathlib.Path(cache), V, F, normals, options)
        with _alone(cached):
            if not cached.exists():
                _save(precompute(V, F, normals=normals, threads=threads, progress=progress, check=check, **options),
                      cached)
            return SurfaceOperators.load(cached)
    own_depth: Any = depth
    if depth is None and accuracy is None and not isinstance(V, Space):
        own_depth = _depth_of
    if threads is None and multiprocessing.parent_process() is not None:
        threads = 1
    spectrum = laplace_spectrum(V, F, count, accuracy=accuracy, normals=normals, depth=own_depth,
                                joining_tolerance=joining_tolerance, threads=threads, progress=progress,
                                check=check)
    space = spectrum.space
    surface = space._surface
    points = surface.points()
    frames = tangent_frames(surface.vertex_normals())
    x, y = gradient_operators(points, frames, _neighbors(space, points))
    return SurfaceOperators(spectrum.eigenvalues, np.nan_to_num(spectrum.vertex_values),
                            surface.vertex_areas(), frames, x, y, _description(options))


def _description(options: dict) -> str:
    return json.dumps({"restricted_laplacian": __version__, **options})


def _key(content: bytes, options: dict) -> str:
    h = hashlib.sha256(content)
    h.update(repr((_description(options), _SMALL_DEPTH, _SMALL_NUMBER_OF_FACES)).encode())
    return h.hexdigest()[:32]


def _cached_file(cache: pathlib.Path, V: Any, F: Any, normals: Any, options: dict) -> pathlib.Path:
    parts = [np.empty(0) if a is None else np.ascontiguousarray(a) for a in (V, F, normals)]
    text = repr([(a.shape, a.dtype.str) for a in parts]).encode()
    return cache / (_key(b"".join([text, *(a.tobytes() for a in parts)]), options) + ".npz")


@contextlib.contextmanager
def _alone(file: pathlib.Path) -> Iterator[None]:
    """While no other process is at work on a file. Where a system has no such locks, work may be done twice."""
    folder = file.parent / ".locks"
    folder.mkdir(parents=True, exist_ok=True)
    if fcntl is None:
        yield
        return
    # a file of its own for each would stay behind; the lock goes when the process does
    with open(folder / file.name[:2], "ab") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        yield


def _save(result: SurfaceOperators, file: pathlib.Path) -> None:
    # first under another name, so that a file is whole if it is there
    temporary = file.with_name(f"{file.stem}.{os.getpid()}.npz")
    result.save(temporary)
    os.replace(temporary, file)


def _precompute_file(file: pathlib.Path, cached: pathlib.Path, options: dict) -> Optional[str]:
    """What went wrong, if something did."""
    try:
        with _alone(cached):
            if not cached.exists():
                _save(precompute(*read_mesh(file), threads=1, **options), cached)
    except Exception as e:  # all that one mesh can do must not end the others
        return f"{type(e).__name__}: {e}"
    return None


_Job = tuple[pathlib.Path, pathlib.Path]


def _nothing() -> None:
    """A job that cannot fail."""


def _run(jobs: Sequence[_Job], options: dict, processes: Optional[int],
         take: Callable[[_Job, Optional[str]], None]) -> list[_Job]:
    """Gives each job to a process; returns those that were lost because a process died."""
    lost = []
    # not forked: the threads of this process would be missing
    context = multiprocessing.get_context("spawn")
    with concurrent.futures.ProcessPoolExecutor(processes, mp_context=context) as pool:
        try:
            pool.submit(_nothing).result()
        except BrokenProcessPool:
            raise RuntimeError(
                "processes cannot start: each begins with the script that called precompute_folder; call it "
                'from under `if __name__ == "__main__":`') from None
        futures = {}
        for job in jobs:
            try:
                futures[pool.submit(_precompute_file, *job, options)] = job
            except BrokenProcessPool:
                lost.append(job)
        for future in concurrent.futures.as_completed(futures):
            try:
                take(futures[future], future.result())
            except BrokenProcessPool:
                lost.append(futures[future])
    return lost


@shown()
@dataclass(repr=False)
class Precomputed:
    """The operators of the meshes of a folder.

    Attributes
    ----------
    files : dict
        Of each mesh its file in the cache.
    failures : dict
        Of each mesh that was left out, what went wrong.
    """

    files: dict
    failures: dict

    def __len__(self) -> int:
        return len(self.files)

    def __iter__(self) -> Iterator[pathlib.Path]:
        return iter(self.files)

    def __getitem__(self, mesh: Union[str, "os.PathLike[str]"]) -> SurfaceOperators:
        return SurfaceOperators.load(self.files[pathlib.Path(mesh)])


def precompute_folder(folder: Union[str, "os.PathLike[str]"],
                      cache: Union[str, "os.PathLike[str]"], count: int = 128, *,
                      patterns: Sequence[str] = ("*.off", "*.obj", "*.ply", "*.stl"),
                      accuracy: Optional[float] = None, depth: Optional[int] = None,
                      joining_tolerance: Optional[float] = None,
                      processes: Optional[int] = None,
                      report: Optional[Callable[[pathlib.Path, Optional[str]], Any]] = None
                      ) -> Precomputed:
    """`precompute` for all meshes of a folder, by several processes, with a cache on the disk.

    A mesh that fails is left out and named. What is in the cache, for the same content of the file
    and the same arguments, is not computed again.

    Parameters
    ----------
    folder : str or os.PathLike
        Of the meshes, and folders in it.
    cache : str or os.PathLike
        Folder for the results; made if it is not there.
    count, accuracy, depth, joining_tolerance : as for precompute
        Of all meshes.
    patterns : sequence of str
        Names of files; off, obj, ply and stl by default.
    processes : int, optional
        One for each processor by default, each with one thread. In a script, call from under
        ``if __name__ == "__main__"``.
    report : callable, optional
        Called with each mesh that is done, and None or what went wrong.

    Returns
    -------
    Precomputed
        What is in the cache, by mesh; and what failed.

    Raises
    ------
    InputError
        There is no such folder.
    RuntimeError
        The processes cannot start, because the script that they begin with has no guard.

    Examples
    --------
    >>> from restricted_laplacian import learning
    >>> if __name__ == "__main__":
    ...     shapes = learning.precompute_folder("meshes", "cache", count=128)  # doctest: +SKIP
    """
    if getattr(multiprocessing.current_process(), "_inheriting", False):
        # a process of an earlier call, which reads the script; that call says what is wrong
        raise SystemExit(1)
    root, own_cache = pathlib.Path(folder), pathlib.Path(cache)
    if not root.is_dir():
        raise argument_error("folder", f"is not a folder: {root}")
    own_cache.mkdir(parents=True, exist_ok=True)
    meshes = sorted({file for pattern in patterns for file in root.rglob(pattern)
                     if file.is_file()})
    result = Precomputed({}, {})
    jobs: list[_Job] = []
    options: dict[str, Any] = {"count": count, "accuracy": accuracy, "depth": depth,
                               "joining_tolerance": joining_tolerance}
    for mesh in meshes:
        cached = own_cache / (_key(mesh.read_bytes(), options) + ".npz")
        if cached.exists():
            result.files[mesh] = cached
        else:
            jobs.append((mesh, cached))

    def take(job: _Job, failure: Optional[str]) -> None:
        if failure is None:
            result.files[job[0]] = job[1]
        else:
            result.failures[job[0]] = failure
        if report:
            report(job[0], failure)

    # A process that dies takes the others with it. Then each mesh gets a process of its own.
    for job in _run(jobs, options, processes, take):
        for lost in _run([job], options, 1, take):
            take(lost, "its process died: is the memory too small?")
    result.files = dict(sorted(result.files.items()))
    result.failures = dict(sorted(result.failures.items()))
    return result


def _torch(array: Any, like: Any) -> Any:
    """A tensor of the type and on the device of another one; without a copy where these are those of the array."""
    import torch
    if scipy.sparse.issparse(array):
        a = array.tocoo()
        result = torch.sparse_coo_tensor(np.stack([a.row, a.col]), torch.from_dlpack(a.data), a.shape).coalesce()
    else:
        result = torch.from_dlpack(np.ascontiguousarray(array))
    return result.to(device=like.device, dtype=like.dtype)


def get_operators(verts: Any, faces: Any, k_eig: int = 128, op_cache_dir: Union[None, str, "os.PathLike[str]"] = None,
                  normals: Any = None, overwrite_cache: bool = False) -> tuple:
    """What DiffusionNet's function of this name returns: the same tuple, in the same shapes, of PyTorch tensors.

    They have the type and the device of `verts`. Needs PyTorch.

    Parameters
    ----------
    verts : torch.Tensor, (n, 3)
        Points.
    faces : torch.Tensor, (m, 3)
        Triangles; (0, 3) for points, which need `normals`.
    k_eig : int, default 128
        Number of eigenpairs.
    op_cache_dir : str or os.PathLike, optional
        The `cache` of `precompute`.
    normals : torch.Tensor, (n, 3), optional
        For points without faces, oriented alike.
    overwrite_cache : bool, default False
        Whether what is in the cache is computed again.

    Returns
    -------
    frames : (n, 3, 3)
        Of each vertex the rows are two tangents and the normal: `gradX` and `gradY` are derivatives along the tangents.
    mass : (n,)
        Areas of the vertices.
    L : (n, n), sparse
        The stiffness matrix of linear elements, not negative; with ``mass`` it is the Laplacian of steps in time.
        For points it is ``gradX.T mass gradX + gradY.T mass gradY``.
    evals : (k,)
        Ascending, in units of 1 / area.
    evecs : (n, k)
        Orthonormal in the integral over the surface, so up to the quadrature by `mass`.
    gradX, gradY : (n, n), sparse
        Derivatives along the tangents.

    Raises
    ------
    InputError
        A `ValueError` that names the face, the vertex or the argument.

    Examples
    --------
    >>> import torch  # doctest: +SKIP
    >>> frames, mass, L, evals, evecs, gradX, gradY = get_operators(verts, faces, 64, "cache")  # doctest: +SKIP
    """
    import torch  # type: ignore[import-not-found,unused-ignore]
    like = torch.as_tensor(verts)
    V = like.detach().cpu().numpy().astype(np.float64)
    F: Any = torch.as_tensor(faces).detach().cpu().numpy()
    own_normals: Any = None
    if F.size == 0:
        if normals is None:
            raise argument_error("normals", "must be given for points without faces")
        F, own_normals = None, torch.as_tensor(normals).detach().cpu().numpy().astype(np.float64)
    if op_cache_dir is not None and overwrite_cache:
        options = {"count": int(k_eig), "accuracy": None, "depth": None, "joining_tolerance": None}
        _cached_file(pathlib.Path(op_cache_dir), V, F, own_normals, options).unlink(missing_ok=True)
    o = precompute(V, F, int(k_eig), normals=own_normals, cache=op_cache_dir)
    if F is None:
        areas = scipy.sparse.diags(o.vertex_areas)
        stiffness = sum(g.T @ areas @ g for g in (o.gradient_x, o.gradient_y))
    else:
        stiffness = cotangent_operators(V, F).stiffness
    return tuple(_torch(a, like) for a in (o.frames, o.vertex_areas, stiffness, o.eigenvalues, o.eigenvectors,
                                           o.gradient_x, o.gradient_y))


def get_all_operators(verts_list: Sequence[Any], faces_list: Sequence[Any], k_eig: int = 128,
                      op_cache_dir: Union[None, str, "os.PathLike[str]"] = None,
                      normals: Optional[Sequence[Any]] = None) -> tuple:
    """`get_operators` of several surfaces, as DiffusionNet has it.

    Parameters
    ----------
    verts_list, faces_list : sequence of torch.Tensor
        Points and triangles of each.
    k_eig, op_cache_dir : as for get_operators
        Of all of them.
    normals : sequence of torch.Tensor, optional
        Of each.

    Returns
    -------
    tuple of list
        Seven lists, of what `get_operators` returns.

    Raises
    ------
    InputError
        A `ValueError` that names the face, the vertex or the argument.

    Examples
    --------
    >>> frames, mass, L, evals, evecs, gradX, gradY = get_all_operators(verts_list, faces_list)  # doctest: +SKIP
    """
    own_normals = [None] * len(verts_list) if normals is None else normals
    found = [get_operators(v, f, k_eig, op_cache_dir, n) for v, f, n in zip(verts_list, faces_list, own_normals)]
    return tuple(list(part) for part in zip(*found))

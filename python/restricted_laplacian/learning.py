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
"""

from __future__ import annotations

import concurrent.futures
import hashlib
import multiprocessing
import os
import pathlib
from concurrent.futures.process import BrokenProcessPool
from dataclasses import dataclass
from typing import Any, Callable, Iterator, Optional, Sequence, Union

import numpy as np
import scipy.sparse
import scipy.spatial

from ._core import __version__
from ._errors import argument_error
from ._files import read_mesh
from ._input import Progress, takes_surface
from ._show import shown
from ._space import Space
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
    """

    eigenvalues: np.ndarray
    eigenvectors: np.ndarray
    vertex_areas: np.ndarray
    frames: np.ndarray
    gradient_x: scipy.sparse.csr_matrix
    gradient_y: scipy.sparse.csr_matrix

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
                 indices=x.indices, indptr=x.indptr)

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
                                    a["frames"], x, y)


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
               threads: Optional[int] = None, progress: Progress = None, check: bool = True
               ) -> SurfaceOperators:
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
    threads, progress, check : as for solve_poisson
        How the work is done.

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
    own_depth: Any = depth
    if depth is None and accuracy is None and not isinstance(V, Space):
        own_depth = _depth_of
    spectrum = laplace_spectrum(V, F, count, accuracy=accuracy, normals=normals, depth=own_depth,
                                joining_tolerance=joining_tolerance, threads=threads, progress=progress,
                                check=check)
    space = spectrum.space
    surface = space._surface
    points = surface.points()
    frames = tangent_frames(surface.vertex_normals())
    x, y = gradient_operators(points, frames, _neighbors(space, points))
    return SurfaceOperators(spectrum.eigenvalues, np.nan_to_num(spectrum.vertex_values),
                            surface.vertex_areas(), frames, x, y)


def _key(file: pathlib.Path, options: tuple) -> str:
    h = hashlib.sha256(file.read_bytes())
    h.update(repr((options, __version__, _SMALL_DEPTH, _SMALL_NUMBER_OF_FACES)).encode())
    return h.hexdigest()[:32]


def _precompute_file(file: pathlib.Path, cached: pathlib.Path, count: int, accuracy: Optional[float],
                     depth: Optional[int], joining_tolerance: Optional[float]) -> Optional[str]:
    """What went wrong, if something did."""
    try:
        result = precompute(*read_mesh(file), count, accuracy=accuracy, depth=depth,
                            joining_tolerance=joining_tolerance, threads=1)
    except Exception as e:  # all that one mesh can do must not end the others
        return f"{type(e).__name__}: {e}"
    # first under another name, so that a file is whole if it is there
    temporary = cached.with_name(f"{cached.stem}.{os.getpid()}.npz")
    result.save(temporary)
    os.replace(temporary, cached)
    return None


_Job = tuple[pathlib.Path, pathlib.Path]


def _nothing() -> None:
    """A job that cannot fail."""


def _run(jobs: Sequence[_Job], options: tuple, processes: Optional[int],
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
                futures[pool.submit(_precompute_file, *job, *options)] = job
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
    options = (count, accuracy, depth, joining_tolerance)
    for mesh in meshes:
        cached = own_cache / (_key(mesh, options) + ".npz")
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

# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Ordinary shapes in all sizes, and what functions of the package have to find on them.

Everything here is regular: equal coordinates, straight rows of vertices, symmetry. That is what people
have, and where ties are. A shape knows what is known of it; a trial applies one function to a shape, at
default settings, in a process of its own, and tells how long it took, how much memory, and how wrong it
was, in units of what is allowed.

As a program: a selection of trials, in half a minute. The exit status is 0 if all are right.
"""

import os
import pickle
import resource
import signal
import sys
import time
from dataclasses import dataclass, field
from typing import Callable, Dict, List, Optional, Tuple

import numpy as np

import restricted_laplacian as rl

SECONDS, GIBIBYTES = 120, 4  # limits of a trial


@dataclass
class Shape:
    family: str
    size: int
    V: np.ndarray
    F: np.ndarray
    placement: str = "as_is"
    components: int = 1
    # What is known. Coordinates along the surface of what can be unrolled: (n, 2); if `around`, the
    # first one is periodic.
    unrolled: Optional[np.ndarray] = None
    around: float = 0
    # of a point to the unrolled coordinates, if that is an affine map
    to_plane: Optional[Callable[[np.ndarray], np.ndarray]] = None
    rectangle: Optional[Tuple[float, float]] = None  # sides, of a flat one
    radius: float = 0  # of a sphere
    mirror_axes: Tuple[int, ...] = ()  # the shape is symmetric along these axes
    sources: List[int] = field(default_factory=lambda: [0])

    @property
    def extent(self) -> float:
        return float((self.V.max(axis=0) - self.V.min(axis=0)).max())

    @property
    def name(self) -> str:
        return f"{self.family}/{self.placement}/{self.size}"


# ---- shapes


def squares(n: int, m: int, diagonals: str) -> np.ndarray:
    """Triangles of n x m squares whose corners are numbered row by row, n + 1 in a row."""
    j, i = np.meshgrid(np.arange(m), np.arange(n), indexing="ij")
    a = (i + (n + 1) * j).ravel()
    b, c, d = a + 1, a + n + 2, a + n + 1
    rising = {"rising": a >= 0, "falling": a < 0, "alternating": ((i + j) % 2 == 0).ravel()}[diagonals]
    first = np.where(rising[:, None], np.stack([a, b, c], 1), np.stack([a, b, d], 1))
    second = np.where(rising[:, None], np.stack([a, c, d], 1), np.stack([b, c, d], 1))
    return np.stack([first, second], 1).reshape(-1, 3)


def lattice(n: int, m: int) -> np.ndarray:
    x, y = np.meshgrid(np.arange(n + 1.0), np.arange(m + 1.0))
    return np.stack([x.ravel(), y.ravel()], 1)


def grid(n: int, diagonals: str = "rising", placement: str = "unit") -> Shape:
    P = lattice(n, n)
    if placement == "tenths":
        P = np.round(P * 0.1, 12)
    elif placement == "large":
        P = P * (1e6 / n)
    elif placement == "small":
        P = P * (1e-6 / n)
    elif placement not in ("integers", "far"):
        P = P / n
    ex, ey, origin = np.array([1.0, 0, 0]), np.array([0, 1.0, 0]), np.zeros(3)
    if placement == "tilted":
        ex, ey = np.array([0.36, -0.8, 0.48]), np.array([0.48, 0.6, 0.64])
    elif placement == "far":
        origin = np.array([1e6, -1e6, 1e6])
    V = origin + P[:, :1] * ex + P[:, 1:] * ey
    side = P.max()
    return Shape(f"grid_{diagonals}", n, V, squares(n, n, diagonals), placement, unrolled=P,
                 to_plane=lambda p: np.stack([(p - origin) @ ex, (p - origin) @ ey], 1),
                 rectangle=(side, side), sources=[0, (n + 1) * (n + 1) // 2, n])


def terraces(n: int) -> Shape:
    """Steps of a height, with walls between them: x and z along the steps, y across."""
    steps = 4
    per_step = max(1, n // steps)
    x, z, at = [], [], 0.0
    for step in range(steps):
        for i in range(per_step + 1):
            x.append(at + i / per_step)
            z.append(0.5 * step)
        at += 1
    profile = np.stack([x, z], 1)
    return swept(profile, n, "terraces")


def swept(profile: np.ndarray, m: int, family: str) -> Shape:
    """A profile in the plane of x and z, swept along y."""
    k = len(profile) - 1
    length = np.concatenate([[0], np.cumsum(np.hypot(*np.diff(profile, axis=0).T))])
    y = np.arange(m + 1.0) / m * length[-1]
    V = np.stack([np.tile(profile[:, 0], m + 1), np.repeat(y, k + 1), np.tile(profile[:, 1], m + 1)], 1)
    P = np.stack([np.tile(length, m + 1), V[:, 1]], 1)
    return Shape(family, m, V, squares(k, m, "rising"), unrolled=P, mirror_axes=(1,),
                 sources=[0, len(V) // 2])


def raster(n: int) -> Shape:
    """Heights in tenths over integer places."""
    P = lattice(n, n)
    x, y = 2 * np.pi * P.T / n
    z = np.round(0.08 * n * (np.sin(x) * np.cos(y) + 0.3 * np.cos(3 * x)), 1)
    return Shape("raster", n, np.column_stack([P, z]), squares(n, n, "rising"), sources=[0, len(P) // 2])


def cylinder(n: int) -> Shape:
    """Open, of n sides."""
    m, height = max(1, n // 3), 2.0
    phi = 2 * np.pi * np.arange(n) / n
    V = np.array([[np.cos(a), np.sin(a), height * j / m] for j in range(m + 1) for a in phi])
    a = np.array([[i + n * j, (i + 1) % n + n * j, (i + 1) % n + n * (j + 1), i + n * (j + 1)]
                  for j in range(m) for i in range(n)])
    F = np.concatenate([a[:, [0, 1, 2]], a[:, [0, 2, 3]]])
    side = 2 * np.sin(np.pi / n)
    P = np.array([[i * side, height * j / m] for j in range(m + 1) for i in range(n)])
    return Shape("cylinder", n, V, F, unrolled=P, around=n * side, mirror_axes=(2,), sources=[0, len(V) // 2])


def welded(V: np.ndarray, F: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """Equal points become one, triangles with two equal corners vanish."""
    keys, inverse = np.unique(np.round(V, 9), axis=0, return_inverse=True)
    F = inverse.ravel()[F]
    F = F[(F[:, 0] != F[:, 1]) & (F[:, 1] != F[:, 2]) & (F[:, 2] != F[:, 0])]
    return keys, F


def box(n: int, sides: Tuple[float, float, float] = (1, 1, 1), family: str = "cube") -> Shape:
    counts = [max(1, round(n * s / max(sides))) for s in sides]
    parts, faces, first = [], [], 0
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        P = lattice(counts[u], counts[v]) / [counts[u], counts[v]]
        F = squares(counts[u], counts[v], "rising")
        for end in (0, 1):
            V = np.zeros((len(P), 3))
            V[:, u], V[:, v], V[:, axis] = P[:, 0] * sides[u], P[:, 1] * sides[v], end * sides[axis]
            parts.append(V)
            faces.append((F if end else F[:, ::-1]) + first)
            first += len(P)
    V, F = welded(np.concatenate(parts), np.concatenate(faces))
    return Shape(family, n, V, F, mirror_axes=(0, 1, 2), sources=[0, len(V) // 2])


def revolved(radius: np.ndarray, z: np.ndarray, n: int, family: str, size: int) -> Shape:
    """A profile, turned around the z axis; where its radius is 0 it closes."""
    phi = 2 * np.pi * np.arange(n) / n
    V = np.array([[r * np.cos(a), r * np.sin(a), h] for r, h in zip(radius, z) for a in phi])
    a = np.array([[i + n * j, (i + 1) % n + n * j, (i + 1) % n + n * (j + 1), i + n * (j + 1)]
                  for j in range(len(z) - 1) for i in range(n)])
    V, F = welded(V, np.concatenate([a[:, [0, 1, 2]], a[:, [0, 2, 3]]]))
    return Shape(family, size, V, F, mirror_axes=(0, 1) if n % 4 == 0 else (),
                 sources=[0, int(np.argmax(V[:, 2]))])


def prism(n: int) -> Shape:
    """Closed, over a polygon of n sides, with caps of one fan each."""
    return revolved(np.array([0, 1, 1, 0.0]), np.array([0, 0, 1.5, 1.5]), n, "prism", n)


def cone(n: int) -> Shape:
    t = np.arange(n // 2 + 1) / (n // 2)
    return revolved(np.concatenate([[0], t[::-1]]), np.concatenate([[0], 2 - 2 * t[::-1]]), n, "cone", n)


def vase(n: int) -> Shape:
    t = np.arange(n + 1) / n
    return revolved(0.6 + 0.3 * np.sin(4 * t) + 0.1 * np.cos(9 * t), 2 * t, n, "vase", n)


def disc(n: int) -> Shape:
    t = np.arange(n + 1) / n
    return revolved(t, 0 * t, 4 * n, "disc", n)


def torus(n: int) -> Shape:
    phi = 2 * np.pi * np.arange(n + 1) / n
    shape = revolved(1 + 0.4 * np.cos(phi), 0.4 * np.sin(phi), 2 * n, "torus", n)
    shape.mirror_axes = (2,)
    return shape


def icosphere(n: int, family: str = "icosphere") -> Shape:
    V, F = rl.icosphere(n)
    return Shape(family, n, V, F, radius=1, mirror_axes=(0, 1, 2), sources=[0, len(V) // 2])


def spiked_sphere(n: int) -> Shape:
    """One vertex is pulled out."""
    shape = icosphere(n, "spiked_sphere")
    shape.V[4] *= 3
    shape.radius, shape.mirror_axes = 0, (0,)
    shape.sources = [4, 0]
    return shape


def solid(cells: np.ndarray, n: int, height: float, family: str) -> Shape:
    """A plane figure of square cells, with n x n squares in each, made solid."""
    mask = np.kron(cells, np.ones((n, n), dtype=int)).astype(bool)
    rows, columns = mask.shape
    layers = max(1, round(height * n))
    V, F = [], []

    def add(corners):
        V.extend(corners)
        a = len(V) - 4
        F.extend([[a, a + 1, a + 2], [a, a + 2, a + 3]])

    for j, i in np.argwhere(mask):
        add([(i, j, layers), (i + 1, j, layers), (i + 1, j + 1, layers), (i, j + 1, layers)])
        add([(i, j, 0), (i, j + 1, 0), (i + 1, j + 1, 0), (i + 1, j, 0)])
        for di, dj, a, b in ((-1, 0, (0, 1), (0, 0)), (1, 0, (1, 0), (1, 1)), (0, -1, (0, 0), (1, 0)),
                             (0, 1, (1, 1), (0, 1))):
            if not (0 <= i + di < columns and 0 <= j + dj < rows and mask[j + dj, i + di]):
                for k in range(layers):
                    add([(i + a[0], j + a[1], k), (i + b[0], j + b[1], k), (i + b[0], j + b[1], k + 1),
                         (i + a[0], j + a[1], k + 1)])
    V, F = welded(np.array(V, dtype=float), np.array(F))
    return Shape(family, n, V / n, F, mirror_axes=(2,), sources=[0, len(V) // 2])


LETTERS = {"L": ["100", "100", "111"], "T": ["111", "010", "010"], "E": ["111", "100", "110", "100", "111"],
           "O": ["111", "101", "111"]}


def letter(n: int, name: str) -> Shape:
    cells = np.array([[int(c) for c in row] for row in LETTERS[name][::-1]])
    return solid(cells, n, 0.5, f"letter_{name}")


def plate(n: int) -> Shape:
    """With nine square holes."""
    cells = np.ones((7, 7), dtype=int)
    cells[1::2, 1::2] = 0
    shape = solid(cells, n, 0.5, "plate")
    shape.mirror_axes = (0, 1, 2)
    return shape


def row_of(shapes: List[Shape], family: str, size: int) -> Shape:
    """Shapes in a row, none of which touches another one."""
    V, F, at, first = [], [], 0.0, 0
    for shape in shapes:
        V.append(shape.V - shape.V.min(axis=0) + [at, 0, 0])
        F.append(shape.F + first)
        at += 1.5 * shape.extent
        first += len(shape.V)
    return Shape(family, size, np.concatenate(V), np.concatenate(F), components=len(shapes),
                 mirror_axes=(), sources=[0, first - 1])


def many(n: int) -> Shape:
    return row_of([icosphere(1) if i % 2 else box(3) for i in range(n)], "components", n)


GRID_SIZES = (2, 3, 5, 8, 13, 20, 31, 39, 40, 50, 61, 73, 94, 120)
PLACEMENTS = ("unit", "tilted", "integers", "tenths", "far", "large", "small")


def all_shapes() -> List[Callable[[], Shape]]:
    """Makers of shapes, families in the order of sizes."""
    makers: List[Callable[[], Shape]] = []

    def add(maker, sizes, *more):
        makers.extend(lambda n=n: maker(n, *more) for n in sizes)

    for diagonals in ("rising", "falling", "alternating"):
        for placement in PLACEMENTS:
            add(grid, GRID_SIZES, diagonals, placement)
    add(terraces, (4, 8, 16, 32, 48, 64, 96))
    add(raster, (4, 8, 16, 32, 48, 64, 96, 120))
    add(cylinder, (3, 4, 6, 12, 24, 40, 64, 100, 150))
    add(box, (1, 2, 3, 5, 8, 13, 20, 30, 40))
    add(box, (1, 2, 4, 8, 16, 32, 48), (3, 2, 1), "box")
    add(prism, (3, 4, 6, 12, 40, 100, 300))
    add(cone, (4, 8, 16, 32, 64, 100))
    add(vase, (4, 8, 16, 32, 64, 100))
    add(disc, (1, 2, 4, 8, 16, 32, 48))
    add(torus, (4, 8, 16, 32, 64))
    add(icosphere, (0, 1, 2, 3, 4, 5))
    add(spiked_sphere, (0, 1, 2, 3, 4, 5))
    for name in LETTERS:
        add(letter, (1, 2, 4, 8, 16), name)
    add(plate, (1, 2, 4, 8))
    add(many, (1, 2, 5, 10, 30, 100))
    return makers


# ---- what functions have to find: errors over what is allowed


class Wrong(Exception):
    """What a function returned is not what is known."""


def finite(name: str, values: np.ndarray) -> None:
    if not np.isfinite(values).all():
        raise Wrong(f"{name} has {np.count_nonzero(~np.isfinite(values))} values that are not finite")


def mirrored(shape: Shape, axis: int) -> Optional[np.ndarray]:
    """The vertex that each one goes to, if there is one."""
    image = shape.V.copy()
    image[:, axis] = shape.V[:, axis].max() + shape.V[:, axis].min() - image[:, axis]
    scale = shape.extent
    key = lambda A: np.lexsort(np.round(A / scale, 6).T)  # noqa: E731
    a, b = key(shape.V), key(image)
    if np.abs(shape.V[a] - image[b]).max() > 1e-5 * scale:
        return None
    result = np.empty(len(a), dtype=int)
    result[b] = a
    return result


def means_of_components(shape: Shape, u: np.ndarray, x: np.ndarray) -> np.ndarray:
    """x with the mean over vertices of u in each component."""
    label = np.arange(len(shape.V))
    while True:  # the smallest number of a vertex of the component
        least = label[shape.F].min(axis=1)
        new = label.copy()
        for k in range(3):
            np.minimum.at(new, shape.F[:, k], least)
        if (new == label).all():
            break
        label = new
    _, label = np.unique(label, return_inverse=True)
    label = label.ravel()
    count = np.bincount(label)
    return x + (np.bincount(label, u - x) / count)[label]


def symmetry(shape: Shape, u: np.ndarray, axis: int, sign: int) -> float:
    """The largest difference to the mirror image, relative."""
    image = mirrored(shape, axis)
    if image is None:
        raise Wrong(f"the shape is not symmetric along axis {axis}")
    size = np.abs(u).max()
    return float(np.abs(u - sign * u[image]).max() / size) if size > 0 else 0.0


def poisson(shape: Shape) -> float:
    if shape.rectangle and shape.to_plane:
        side = shape.rectangle[0]
        exact = lambda p: np.cos(np.pi * shape.to_plane(p)[:, 0] / side)  # noqa: E731
        u = rl.solve_poisson(shape.V, shape.F, exact)
        finite("u", u)
        return float(np.abs(u * (np.pi / side) ** 2 + exact(shape.V)).max() / 5e-3)
    if shape.radius and shape.size >= 3:
        u = rl.solve_poisson(shape.V, shape.F, lambda p: p[:, 2])
        return float(np.abs(u + shape.V[:, 2] / 2).max() / 0.02)
    if shape.family == "cylinder":
        height = shape.V[:, 2].max()
        exact = lambda p: np.cos(np.pi * p[:, 2] / height)  # noqa: E731
        u = rl.solve_poisson(shape.V, shape.F, exact)
        return float(np.abs(u * (np.pi / height) ** 2 + exact(shape.V)).max() / 0.01)
    axis = shape.mirror_axes[-1] if shape.mirror_axes else 2
    middle = (shape.V[:, axis].max() + shape.V[:, axis].min()) / 2
    u = rl.solve_poisson(shape.V, shape.F, lambda p: p[:, axis] - middle)
    finite("u", u)
    return symmetry(shape, u, axis, -1) / 0.05 if shape.mirror_axes else 0.0


def screened(shape: Shape) -> float:
    alpha = 10 / shape.extent ** 2
    u = rl.solve_screened_poisson(shape.V, shape.F, alpha, alpha)
    finite("u", u)
    return float(np.abs(u - 1).max() / 5e-3)


def diffusion(shape: Shape) -> float:
    """Until about a third is left of what decays most slowly."""
    if shape.rectangle and shape.to_plane:
        decay = (np.pi / shape.rectangle[0]) ** 2
        u0 = lambda p: np.cos(np.pi * shape.to_plane(p)[:, 0] / shape.rectangle[0])  # noqa: E731
    elif shape.radius and shape.size >= 3:
        decay, u0 = 2, lambda p: p[:, 2]
    elif shape.family == "cylinder":
        height = shape.V[:, 2].max()
        decay, u0 = (np.pi / height) ** 2, lambda p: np.cos(np.pi * p[:, 2] / height)
    else:  # odd functions remain odd, and constants what they are
        axis = shape.mirror_axes[-1] if shape.mirror_axes else 2
        middle = (shape.V[:, axis].max() + shape.V[:, axis].min()) / 2
        u0 = lambda p: np.stack([p[:, axis] - middle, 1 + 0 * p[:, 0]], 1)  # noqa: E731
        u = rl.diffuse(shape.V, shape.F, u0, 0.05 * shape.extent ** 2)
        finite("u", u)
        odd = symmetry(shape, u[:, 0], axis, -1) / 0.05 if shape.mirror_axes else 0.0
        return max(odd, float(np.abs(u[:, 1] - 1).max() / 1e-9))
    u = rl.diffuse(shape.V, shape.F, u0, 1 / decay)
    finite("u", u)
    return float(np.abs(u - np.exp(-1) * u0(shape.V)).max() / 0.02)


def flow(shape: Shape) -> float:
    """What is flat stays, and spheres shrink; the rest is finite."""
    step = 1e-3 * shape.extent ** 2
    X = rl.mean_curvature_flow(shape.V, shape.F, step, steps=2)
    finite("positions", X)
    if shape.rectangle and shape.to_plane:
        return float(np.abs(X - shape.V).max() / (1e-3 * shape.extent))
    if shape.radius and shape.size >= 3:
        r = np.linalg.norm(X, axis=1) / np.linalg.norm(shape.V, axis=1)
        return float(np.abs(r - np.sqrt(1 - 8 * step)).max() / 0.02)
    return 0.0


def anisotropic(shape: Shape) -> float:
    a = shape.extent / 10
    values = rl.eigs(shape.V, shape.F, 7, anisotropy=a)[0]
    finite("eigenvalues", values)
    if shape.rectangle or shape.radius and shape.size >= 3:
        factor = np.exp(-a * shape.radius)
        plain = rl.eigs(shape.V, shape.F, 7)[0]
        return float(np.abs(values - factor * plain).max() / (0.03 * factor * plain.max()))
    return 0.0


def spectrum(shape: Shape, k: int = 7) -> float:
    values = rl.eigs(shape.V, shape.F, k)[0]
    finite("eigenvalues", values)
    unit = 1 / shape.extent ** 2
    zeros = int((values < 1e-3 * unit).sum())
    if zeros != min(shape.components, k):
        raise Wrong(f"{zeros} eigenvalues are 0, of {shape.components} components: {values[:4]}")
    worst = max(0.0, float(-values.min() / (1e-6 * unit)), float(-np.diff(values).min() / (1e-9 * unit)))
    if shape.rectangle:
        i = np.arange(2 * k)
        exact = np.sort((np.pi / shape.rectangle[0]) ** 2 * (i[:, None] ** 2 + i ** 2).ravel())[:k]
        worst = max(worst, float(np.abs(values / np.maximum(exact, unit) - exact / np.maximum(exact, unit))[:7]
                                 .max() / 0.01))
    if shape.radius and shape.size >= 3:
        exact = np.repeat([l * (l + 1) for l in range(4)], [1, 3, 5, 7])[:7]
        worst = max(worst, float(np.abs(values[:7] - exact).max() / 0.2))
    return worst


def fit(shape: Shape) -> float:
    x = rl.fit_function(shape.V, shape.F, shape.V - shape.V.mean(axis=0))
    finite("the fit", x)
    return float(np.abs(x + shape.V.mean(axis=0) - shape.V).max() / (2e-3 * shape.extent))


def curvature(shape: Shape) -> float:
    c = rl.curvature(shape.V, shape.F)
    finite("mean curvature", c.mean)
    finite("Gaussian curvature", c.gaussian)
    if shape.rectangle:
        return float(np.abs(c.mean).max() * shape.extent / 1e-3)
    if shape.radius and shape.size >= 3:
        return float(np.abs(np.median(c.mean) - 1) / 0.02)
    if shape.family == "cylinder" and shape.size >= 40:
        return float(np.abs(np.median(c.mean) - 0.5) / 0.02)
    return 0.0


def gradient(shape: Shape) -> float:
    direction = np.array([1.0, 2.0, 3.0])
    u = rl.integrate_gradient(shape.V, shape.F, np.tile(direction, (len(shape.F), 1)))
    finite("u", u)
    u = u.reshape(len(shape.V))
    x = shape.V @ direction
    return float(np.abs(u - means_of_components(shape, u, x)).max() / (1e-2 * shape.extent))


def distance(shape: Shape, exact: bool = False) -> float:
    worst = 0.0
    for source in shape.sources[:2]:
        d = rl.geodesic_distance(shape.V, shape.F, source, exact=exact)
        reached = np.isfinite(d)
        if shape.components == 1 and not reached.all():
            raise Wrong(f"{np.count_nonzero(~reached)} distances are not finite")
        straight = np.linalg.norm(shape.V - shape.V[source], axis=1)
        allowed = (1e-9 if exact else 1e-3) * shape.extent + 4e-16 * np.abs(shape.V).max()
        worst = max(worst, float(((straight - d)[reached] / allowed).max()))
        if shape.unrolled is not None:
            to = np.abs(shape.unrolled - shape.unrolled[source])
            if shape.around:
                to[:, 0] = np.minimum(to[:, 0], shape.around - to[:, 0])
            known = np.hypot(*to.T)
            # rounding of coordinates counts, too
            allowed = 1e-9 * shape.extent + 4e-16 * np.abs(shape.V).max()
            worst = max(worst, float(np.abs(d - known).max() / allowed))
        elif not exact:
            other = rl.geodesic_distance(shape.V, shape.F, source, exact=True)
            worst = max(worst, float(np.abs(d[reached] - other[reached]).max() / (3e-3 * shape.extent)))
    return worst


def exact_distance(shape: Shape) -> float:
    return distance(shape, True)


APPLICATIONS: Dict[str, Callable] = {
    "poisson": poisson, "screened": screened, "fit": fit, "curvature": curvature, "gradient": gradient,
    "diffusion": diffusion, "anisotropic": anisotropic, "flow": flow,
    "distance": distance, "exact_distance": exact_distance,
    **{f"spectrum_{k}": lambda shape, k=k: spectrum(shape, k) for k in (7, 20, 31, 64, 128)}}


def applies(application: str, shape: Shape) -> bool:
    """More pairs than four for each triangle ask nothing of a surface."""
    return not application.startswith("spectrum_") or int(application[9:]) <= max(7, 4 * len(shape.F))


# ---- trials


@dataclass
class Trial:
    seconds: float
    mebibytes: float
    error: float  # over what is allowed
    failure: str = ""

    @property
    def is_right(self) -> bool:
        return not self.failure and self.error <= 1


def run(shape: Shape, application: str, seconds: int = SECONDS, gibibytes: int = GIBIBYTES) -> Trial:
    """In a process of its own. This one must not have used threads before."""
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(reading)
        before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        limit = gibibytes << 30
        resource.setrlimit(resource.RLIMIT_DATA, (limit, limit))
        signal.alarm(seconds)
        start = time.perf_counter()
        error, failure = float("nan"), ""
        try:
            error = APPLICATIONS[application](shape)
            if not error == error:
                failure = "NaN"
        except BaseException as e:  # noqa: B036
            failure = f"{type(e).__name__}: {e}"
        elapsed = time.perf_counter() - start
        memory = (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) / 1024
        with os.fdopen(writing, "wb") as pipe:
            pickle.dump(Trial(elapsed, memory, error, failure), pipe)
        os._exit(0)
    os.close(writing)
    with os.fdopen(reading, "rb") as pipe:
        data = pipe.read()
    _, status = os.waitpid(child, 0)
    if data:
        return pickle.loads(data)
    what = "ran out of time" if os.WIFSIGNALED(status) and os.WTERMSIG(status) == signal.SIGALRM else "crashed"
    return Trial(seconds, 0, float("nan"), what)


def selection() -> List[Shape]:
    """One or two of each family."""
    return [grid(2), grid(39, "rising", "tenths"), grid(50, "falling", "integers"),
            grid(61, "alternating", "far"), grid(20, "rising", "large"), grid(31, "falling", "small"),
            grid(40, "rising", "tilted"), terraces(32), raster(48), cylinder(3), cylinder(64), box(1), box(13),
            box(16, (3, 2, 1), "box"), prism(40), cone(32), vase(32), disc(16), torus(16), icosphere(0),
            icosphere(3), spiked_sphere(3), letter(4, "L"), letter(8, "E"), plate(8), many(10)]


def main() -> int:
    applications = [a for a in APPLICATIONS if a not in ("spectrum_20", "spectrum_64", "spectrum_128")]
    number = wrong = 0
    for shape in selection():
        for application in applications:
            if not applies(application, shape):
                continue
            trial = run(shape, application)
            number += 1
            if not trial.is_right or trial.seconds > 60 or trial.mebibytes > 1000:
                wrong += 1
                print(f"{shape.name}, {application}: {trial}", flush=True)
    print(f"{number} trials, {wrong} of them wrong")
    return 1 if wrong or number < 200 else 0


if __name__ == "__main__":
    sys.exit(main())

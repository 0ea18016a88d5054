#!/usr/bin/env python3
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Finite elements of high order beside the package: ngsolve_peers.py [--quick]

Needs the package itself, and

    pip install numpy==2.4.6 scipy==1.17.1 ngsolve==6.2.2608 xfem==2.1.2608

The Poisson problems and spectra of accuracy_per_second.cpp, on the unit sphere and on the torus with radii 1
and 0.4, whose solutions are known. One thread. Methods:

- smooth: the package on the smooth surface through the vertices, with normals that it estimates
- projected: the same with the projection to the surface, called in Python
- curved_K: NGSolve's H1 elements of order K on triangles of order K, whose nodes are projected to the surface,
  inner unknowns condensed, sparse Cholesky
- trace_K: trace elements of order K of ngsxfem, on tetrahedra that are refined where the level set function
  is 0, on the deformed mesh of that order, with diffusion along normals; sparse Cholesky

All but the last take the same triangles. All get the right-hand side as a function. Eigenpairs of NGSolve's
matrices come from scipy's eigsh, with the inverse of NGSolve.

Seconds: the least of three runs, or one where it takes more than 5, from a mesh in NGSolve or arrays to values at
vertices; the tetrahedra are there before. Errors: of Poisson problems the root mean square at vertices, for trace
elements over the surface, relative to that of the solution; of spectra the largest relative one of the
first 30 eigenvalues that are not 0. Last, for each problem, the least seconds for an error, whatever mesh.
"""

import argparse
import math
import os
import time

for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ[name] = "1"

import netgen.meshing  # noqa: E402
import ngsolve as ng  # noqa: E402
import numpy as np  # noqa: E402
import scipy.linalg  # noqa: E402
import scipy.sparse  # noqa: E402
import scipy.sparse.linalg  # noqa: E402
import xfem  # noqa: E402
from ngsolve.meshes import MakeStructured3DMesh  # noqa: E402
from xfem.lsetcurv import LevelSetMeshAdaptation  # noqa: E402

import restricted_laplacian as rl  # noqa: E402
from support.peers import print_header, refined  # noqa: E402

PAIRS = 31  # the first is 0
R, r = 1, 0.4
ERRORS = [1e-1, 3e-2, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5, 3e-6, 1e-6]


# Expressions below are for arrays and for NGSolve's functions: only arithmetic, and what is in `m`.
class Arrays:
    sqrt, sin, cos, atan2 = np.sqrt, np.sin, np.cos, np.arctan2


class Sphere:
    name = "sphere"
    # of four frames, and degrees of harmonics
    frames = [(1, 0, 0, 0, 1, 0), (2 / 3, 2 / 3, 1 / 3, -2 / 3, 1 / 3, 2 / 3), (0.6, 0, 0.8, 0, 1, 0),
              (0, 0.28, 0.96, 1, 0, 0)]
    degrees = [2, 5, 9, 14]

    @staticmethod
    def level_set(x, y, z, m):
        return m.sqrt(x * x + y * y + z * z) - 1

    @staticmethod
    def projection(x, y, z, m):
        d = m.sqrt(x * x + y * y + z * z)
        return x / d, y / d, z / d

    @classmethod
    def solution(cls, x, y, z, m):
        """u, and its Laplacian."""
        x, y, z = cls.projection(x, y, z, m)
        u = laplacian = 0
        for a, degree in zip(cls.frames, cls.degrees):
            h = power((a[0] * x + a[1] * y + a[2] * z, a[3] * x + a[4] * y + a[5] * z), degree)[0]
            u, laplacian = u + h, laplacian - degree * (degree + 1) * h
        return u, laplacian

    @staticmethod
    def eigenvalues():
        return np.array([l * (l + 1) for l in range(1, 9) for _ in range(2 * l + 1)], float)[:PAIRS - 1]

    @staticmethod
    def mesh(n):
        """An octahedron, its triangles divided in four n + 4 times."""
        V = np.concatenate([np.eye(3), -np.eye(3)])[[0, 3, 1, 4, 2, 5]]
        F = np.array([[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5],
                      [0, 3, 5]])
        for _ in range(n + 4):
            V, F = refined(V, F)
            V /= np.linalg.norm(V, axis=1)[:, None]
        return V, F


class Torus:
    name = "torus"

    @staticmethod
    def level_set(x, y, z, m):
        d = m.sqrt(x * x + y * y) - R
        return m.sqrt(d * d + z * z) - r

    @staticmethod
    def projection(x, y, z, m):
        s = m.sqrt(x * x + y * y)
        t = r / m.sqrt((s - R) * (s - R) + z * z)
        scale = (R + t * (s - R)) / s
        return scale * x, scale * y, t * z

    @staticmethod
    def solution(x, y, z, m):
        """u, and its Laplacian."""
        phi, theta = m.atan2(y, x), m.atan2(z, m.sqrt(x * x + y * y) - R)
        u1, u2 = m.sin(3 * phi) * m.cos(2 * theta), m.cos(2 * phi + theta)
        w = R + r * m.cos(theta)
        by_theta = -2 * m.sin(3 * phi) * m.sin(2 * theta) - m.sin(2 * phi + theta)
        return u1 + u2, ((-4 * u1 - u2) / r**2 - m.sin(theta) / (r * w) * by_theta +
                         (-9 * u1 - 4 * u2) / (w * w))

    @staticmethod
    def eigenvalues():
        """Of v(theta) times sines and cosines of k phi, by a Fourier method in theta."""
        modes, nodes = 24, 256
        theta = 2 * np.pi * np.arange(nodes) / nodes
        n = np.arange(1, modes + 1)
        angles = np.outer(n, theta)
        v = np.concatenate([np.ones((1, nodes)), np.cos(angles), np.sin(angles)])
        d = np.concatenate([np.zeros((1, nodes)), -n[:, None] * np.sin(angles),
                            n[:, None] * np.cos(angles)])
        w = R + r * np.cos(theta)
        values = []
        for k in range(PAIRS):
            found = scipy.linalg.eigh((d * w / r**2) @ d.T + (v * k**2 / w) @ v.T, (v * w) @ v.T,
                                      eigvals_only=True)
            values.extend(np.repeat(found, 1 if k == 0 else 2))
        return np.sort(values)[1:PAIRS]

    @staticmethod
    def mesh(n):
        """40 x 16 quadrilaterals for n = 0, each cut in two."""
        columns, rows = 40 << n, 16 << n
        i, j = (a.ravel() for a in np.meshgrid(np.arange(columns), np.arange(rows), indexing="ij"))
        phi, theta = 2 * np.pi * i / columns, 2 * np.pi * j / rows
        w = R + r * np.cos(theta)
        V = np.stack([w * np.cos(phi), w * np.sin(phi), r * np.sin(theta)], axis=1)
        i_next, j_next = (i + 1) % columns, (j + 1) % rows
        a, b, c, d = (i * rows + j, i_next * rows + j, i_next * rows + j_next, i * rows + j_next)
        return V, np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])


def power(z, exponent):
    """Of a complex number, as (real, imaginary) part."""
    result = None
    while exponent > 0:
        if exponent % 2:
            result = z if result is None else (result[0] * z[0] - result[1] * z[1],
                                               result[0] * z[1] + result[1] * z[0])
        exponent //= 2
        z = z[0] * z[0] - z[1] * z[1], 2 * z[0] * z[1]
    return result


def relative_error(V, F, u, exact):
    """The root mean square at vertices, after means are made equal."""
    areas = np.linalg.norm(np.cross(V[F[:, 1]] - V[F[:, 0]], V[F[:, 2]] - V[F[:, 0]]), axis=1)
    weights = np.bincount(F.ravel(), np.repeat(areas, 3))
    d = u - exact
    d = d - np.average(d, weights=weights)
    return math.sqrt((weights @ d**2) / (weights @ exact**2))


def spectrum_error(values, shape):
    exact = shape.eigenvalues()
    return float(np.max(abs(np.sort(values)[1:PAIRS] - exact) / exact))


class Package:
    """The package on one mesh, at one depth."""

    def __init__(self, shape, V, F, depth, geometry):
        self.shape, self.V, self.F, self.depth, self.geometry = shape, V, F, depth, geometry

    def space(self):
        space = rl.Space(self.V, self.F, depth=self.depth, geometry=self.geometry, threads=1)
        self.unknowns = space.dimension
        return space

    def poisson(self):
        return rl.solve_poisson(self.space(), None, lambda p: self.shape.solution(*p.T, Arrays)[1],
                                threads=1)

    def poisson_error(self, u):
        return relative_error(self.V, self.F, u, self.shape.solution(*self.V.T, Arrays)[0])

    def spectrum(self):
        return rl.eigs(self.space(), None, PAIRS, threads=1)[0]


class Elements:
    """What surface elements and trace elements share. `forms(u, v)` are integrands of stiffness, mass and
    load, each with its measure; the space is self.fes."""

    def eigenvalues(self, stiffness, mass):
        u, v = self.fes.TnT()
        a, b = ng.BilinearForm(self.fes), ng.BilinearForm(self.fes)
        a += stiffness(u, v)
        b += mass(u, v)
        a.Assemble()
        b.Assemble()
        # a definite matrix: shifted by less than any eigenvalue that is not 0
        shift = -0.1
        shifted = a.mat.CreateMatrix()
        shifted.AsVector().data = a.mat.AsVector() - shift * b.mat.AsVector()
        inverse = shifted.Inverse(self.fes.FreeDofs(), "sparsecholesky")
        given, found = shifted.CreateColVector(), shifted.CreateColVector()

        def apply(x):
            given.FV().NumPy()[:] = x
            found.data = inverse * given
            return np.array(found.FV().NumPy())

        def matrix(m):
            rows, columns, values = m.COO()
            return scipy.sparse.csr_matrix((values, (rows, columns)), (m.height, m.width))

        operator = scipy.sparse.linalg.LinearOperator((self.fes.ndof,) * 2, matvec=apply)
        return scipy.sparse.linalg.eigsh(matrix(a.mat), PAIRS, matrix(b.mat), sigma=shift,
                                         OPinv=operator, return_eigenvectors=False)

    def solution(self, stiffness, load, is_condensed):
        u, v = self.fes.TnT()
        a = ng.BilinearForm(self.fes, symmetric=True, condense=is_condensed)
        f = ng.LinearForm(self.fes)
        a += stiffness(u, v)
        f += load(v)
        a.Assemble()
        f.Assemble()
        # one value is held: the matrix is singular by constants
        free = self.fes.FreeDofs(is_condensed)
        free[next(i for i, is_free in enumerate(free) if is_free)] = False
        inverse = a.mat.Inverse(free, "sparsecholesky")
        result = ng.GridFunction(self.fes)
        if is_condensed:
            f.vec.data += a.harmonic_extension_trans * f.vec
        result.vec.data = inverse * f.vec
        if is_condensed:
            result.vec.data += a.inner_solve * f.vec
            result.vec.data += a.harmonic_extension * result.vec
        return result


class Curved(Elements):
    def __init__(self, shape, V, F, order):
        self.shape, self.V, self.F, self.order = shape, V, F, order
        mesh = netgen.meshing.Mesh(dim=3)
        mesh.AddPoints(V)
        mesh.Add(netgen.meshing.FaceDescriptor(surfnr=1, domin=1, domout=0, bc=1))
        mesh.AddElements(dim=2, index=1, data=F.astype(np.int32), base=0)
        self.mesh = ng.Mesh(mesh)

    def prepare(self):
        self.mesh.UnsetDeformation()
        place = ng.CF(self.shape.projection(ng.x, ng.y, ng.z, ng)) - ng.CF((ng.x, ng.y, ng.z))
        self.deformation = ng.GridFunction(ng.VectorH1(self.mesh, order=self.order))
        self.deformation.Set(place, definedon=self.mesh.Boundaries(".*"))
        self.mesh.SetDeformation(self.deformation)
        self.fes = ng.H1(self.mesh, order=self.order)
        self.unknowns = self.fes.ndof

    @staticmethod
    def stiffness(u, v):
        return ng.grad(u).Trace() * ng.grad(v).Trace() * ng.ds

    def poisson(self):
        self.prepare()
        f = self.shape.solution(ng.x, ng.y, ng.z, ng)[1]
        u = self.solution(self.stiffness, lambda v: -f * v * ng.ds(bonus_intorder=2), self.order > 2)
        return np.array(u.vec.FV().NumPy()[:len(self.V)])  # the first unknowns are values at vertices

    def poisson_error(self, u):
        return relative_error(self.V, self.F, u, self.shape.solution(*self.V.T, Arrays)[0])

    def spectrum(self):
        self.prepare()
        return self.eigenvalues(self.stiffness, lambda u, v: u * v * ng.ds)


class Trace(Elements):
    def __init__(self, shape, refinements, order):
        self.shape, self.order = shape, order
        # a cube that the surface is inside, its walls nowhere special
        self.mesh = MakeStructured3DMesh(hexes=False, nx=8, ny=8, nz=8, mapping=lambda x, y, z: (
            3 * x - 1.51, 3 * y - 1.52, 3 * z - 1.49))
        self.level_set = shape.level_set(ng.x, ng.y, ng.z, ng)
        for _ in range(refinements):
            linear = ng.GridFunction(ng.H1(self.mesh, order=1))
            xfem.InterpolateToP1(self.level_set, linear)
            xfem.RefineAtLevelSet(linear)
            self.mesh.Refine()

    def prepare(self):
        adaptation = LevelSetMeshAdaptation(self.mesh, order=self.order, threshold=0.5,
                                            discontinuous_qn=True)
        deformation = adaptation.CalcDeformation(self.level_set)
        linear = adaptation.lset_p1
        cut = xfem.CutInfo(self.mesh, linear).GetElementsOfType(xfem.IF)
        whole = ng.H1(self.mesh, order=self.order)
        self.fes = ng.Compress(whole, xfem.GetDofsOfElements(whole, cut))
        self.unknowns = self.fes.ndof
        self.keep = adaptation, deformation
        n = ng.Normalize(ng.grad(linear))
        self.surface = xfem.dCut(levelset=linear, domain_type=xfem.IF, definedonelements=cut,
                                 deformation=deformation)
        self.surface_fine = xfem.dCut(levelset=linear, domain_type=xfem.IF, definedonelements=cut,
                                      deformation=deformation, order=2 * self.order + 2)
        volume = ng.dx(definedonelements=cut, deformation=deformation)

        def stiffness(u, v):
            du, dv = ng.grad(u), ng.grad(v)
            return ((du - (du * n) * n) * (dv - (dv * n) * n) * self.surface +
                    1 / ng.specialcf.mesh_size * (du * n) * (dv * n) * volume)

        self.stiffness = stiffness

    def poisson(self):
        self.prepare()
        f = self.shape.solution(ng.x, ng.y, ng.z, ng)[1]
        return self.solution(self.stiffness, lambda v: -f * v * self.surface, False)

    def poisson_error(self, u):
        def integral(f):
            return ng.Integrate(f * self.surface_fine, self.mesh)

        exact = self.shape.solution(ng.x, ng.y, ng.z, ng)[0]
        mean = integral(u - exact) / integral(ng.CF(1))
        return math.sqrt(integral((u - exact - mean)**2) / integral(exact**2))

    def spectrum(self):
        self.prepare()
        return self.eigenvalues(self.stiffness, lambda u, v: u * v * self.surface)


def measure(work):
    best = math.inf
    for _ in range(3):
        start = time.perf_counter()
        result = work()
        best = min(best, time.perf_counter() - start)
        if best > 5:
            break
    return result, best


def methods(shape, problem, is_quick):
    """Name, faces or tetrahedra, parameter, and what solves."""
    meshes = range(1) if is_quick else range(3)
    for n in meshes:
        V, F = shape.mesh(n)
        for geometry in ("smooth", "projected"):
            given = "smooth" if geometry == "smooth" else (
                lambda p: np.stack(shape.projection(*p.T, Arrays), axis=1))
            for depth in ([n + 4] if is_quick else [n + 3, n + 4, n + 5]):
                yield geometry, len(F), f"d{depth}", Package(shape, V, F, depth, given)
        for order in (2, 3, 4):
            yield f"curved_{order}", len(F), f"o{order}", Curved(shape, V, F, order)
    for order, levels in ((2, range(1 if is_quick else 4)), (3, range(0 if is_quick else 3))):
        for level in levels:
            solver = Trace(shape, level, order)
            yield f"trace_{order}", solver.mesh.ne, f"h{level}", solver


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true", help="the coarsest mesh")
    o = parser.parse_args()
    ng.SetNumThreads(1)
    print_header("ngsolve_peers" + (" --quick" if o.quick else ""), [],
                 ["numpy", "scipy", "ngsolve", "xfem"])
    for problem in ("poisson", "spectrum"):
        for shape in (Sphere, Torus):
            print(f"# {shape.name}, {problem}, all\n# {'shape':7} {'elements':>9} {'method':10} "
                  f"{'param':5} {'unknowns':>9} {'seconds':>9} {'error':>9}")
            results = {}
            for name, elements, parameter, solver in methods(shape, problem, o.quick):
                if problem == "poisson":
                    found, seconds = measure(solver.poisson)
                    error = solver.poisson_error(found)
                else:
                    found, seconds = measure(solver.spectrum)
                    error = spectrum_error(found, shape)
                print(f"{shape.name:9} {elements:9} {name:10} {parameter:5} {solver.unknowns:9} "
                      f"{seconds:9.3f} {error:9.2e}", flush=True)
                results.setdefault(name, []).append((seconds, error))
            print(f"\n\n# {shape.name}, {problem}, least seconds\n# {'error':7}",
                  *(f"{name:>10}" for name in results))
            for bound in ERRORS:
                least = [min((s for s, e in runs if e <= bound), default=math.nan)
                         for runs in results.values()]
                if all(map(math.isnan, least)):
                    break
                print(f"{bound:9.1e}", *(f"{seconds:10.3f}" for seconds in least))
            print("\n")


if __name__ == "__main__":
    main()

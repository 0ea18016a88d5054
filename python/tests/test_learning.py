# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""What networks precompute, files, and the command line."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys

import numpy as np
import pytest

import restricted_laplacian as rl
from restricted_laplacian import learning


def write_off(path, V, F):
    lines = ["OFF", f"{len(V)} {len(F)} 0"]
    lines += [" ".join(repr(float(x)) for x in v) for v in V]
    lines += ["3 " + " ".join(str(i) for i in f) for f in F]
    path.write_text("\n".join(lines) + "\n")


def test_operators_at_vertices(sphere):
    V, F = sphere
    o = learning.precompute(V, F, count=9)
    assert o.eigenvalues[1:4] == pytest.approx([2, 2, 2], rel=2e-3)
    assert o.vertex_areas.sum() == pytest.approx(rl.Space(V, F).area, rel=1e-12)
    gram = o.eigenvectors.T @ (o.vertex_areas[:, None] * o.eigenvectors)
    assert abs(gram - np.eye(9)).max() < 0.02
    # frames are rotations whose last row is the normal
    assert np.allclose(o.frames @ np.swapaxes(o.frames, 1, 2), np.eye(3), atol=1e-12)
    assert np.allclose(np.linalg.det(o.frames), 1) and np.allclose(o.frames[:, 2], V, atol=1e-2)
    # linear functions have their tangential gradients
    for axis in range(3):
        expected = o.frames[:, :2, axis]
        found = np.stack([o.gradient_x @ V[:, axis], o.gradient_y @ V[:, axis]], axis=1)
        assert abs(found - expected).max() < 0.02
    assert abs(o.gradient_x @ np.ones(len(V))).max() < 1e-10


def test_operators_at_points():
    V, _ = rl.icosphere(4)
    o = learning.precompute(V, normals=V, count=4, depth=3)
    found = np.stack([o.gradient_x @ V[:, 2], o.gradient_y @ V[:, 2]], axis=1)
    assert abs(found - o.frames[:, :2, 2]).max() < 0.05


def test_vertices_without_faces(sphere):
    V, F = sphere
    o = learning.precompute(np.vstack([V, [[5, 5, 5]]]), F, count=3)
    assert not o.eigenvectors[-1].any() and not o.frames[-1].any() and o.vertex_areas[-1] == 0
    assert np.isfinite(o.gradient_x.data).all() and not o.gradient_x[[-1]].count_nonzero()


def test_folders(tmp_path):
    folder, cache = tmp_path / "meshes", tmp_path / "cache"
    (folder / "more").mkdir(parents=True)
    V, F = rl.icosphere(2)
    write_off(folder / "good.off", V, F)
    write_off(folder / "more" / "longer.off", V * [1, 1, 2], F)
    write_off(folder / "flat.off", 0 * V, F)
    (folder / "no_mesh.off").write_text("OFF\n3 1 0\n")
    seen = []
    result = learning.precompute_folder(folder, cache, 5, depth=3, processes=2,
                                        report=lambda mesh, failure: seen.append(mesh.name))
    assert [mesh.name for mesh in result] == ["good.off", "longer.off"]
    assert {mesh.name for mesh in result.failures} == {"flat.off", "no_mesh.off"}
    assert "area" in result.failures[folder / "flat.off"]
    assert sorted(seen) == ["flat.off", "good.off", "longer.off", "no_mesh.off"]
    o = result[folder / "good.off"]
    direct = learning.precompute(V, F, 5, depth=3)
    assert np.array_equal(o.eigenvectors, direct.eigenvectors)
    assert (o.gradient_y != direct.gradient_y).nnz == 0
    # again: from the cache, and only what is new or has changed
    seen.clear()
    write_off(folder / "flat.off", V, F[:100])
    result = learning.precompute_folder(folder, cache, 5, depth=3, processes=1,
                                        report=lambda mesh, failure: seen.append(mesh.name))
    assert len(result) == 3 and sorted(seen) == ["flat.off", "no_mesh.off"]
    assert len(list(cache.iterdir())) == 4, "three files, and those of the locks"
    with pytest.raises(rl.InputError):
        learning.precompute_folder(folder / "none", cache)


def kill_own_process(file, cached, options):
    if "kill" in file.name:
        os.kill(os.getpid(), signal.SIGKILL)
    return learning._precompute_file(file, cached, options)


@pytest.mark.skipif(os.name != "posix", reason="signals of POSIX")
def test_a_process_that_dies_takes_one_mesh_with_it(tmp_path, monkeypatch):
    V, F = rl.icosphere(1)
    for name in ("a", "kill", "z"):
        write_off(tmp_path / f"{name}.off", V, F)
    program = f"""
import sys
sys.path.insert(0, {os.path.dirname(__file__)!r})
import test_learning
from restricted_laplacian import learning
if __name__ == "__main__":
    learning._precompute_file = test_learning.kill_own_process
    r = learning.precompute_folder({str(tmp_path)!r}, {str(tmp_path / "cache")!r}, 3, depth=2)
    print(sorted(m.name for m in r), sorted(m.name for m in r.failures))
"""
    script = tmp_path / "run.py"
    script.write_text(program)
    done = subprocess.run([sys.executable, str(script)], capture_output=True, text=True,
                          timeout=120)
    assert done.stdout.strip() == "['a.off', 'z.off'] ['kill.off']", done.stderr


def test_files(tmp_path, sphere):
    V, F = sphere
    write_off(tmp_path / "sphere.off", V, F)
    points, faces = rl.read_mesh(tmp_path / "sphere.off")
    assert np.array_equal(points, V) and np.array_equal(faces, F)
    (tmp_path / "quad.obj").write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")
    points, faces = rl.read_mesh(str(tmp_path / "quad.obj"))
    assert points.shape == (4, 3) and faces.shape == (2, 3)
    for name in ("none.off", "run.txt"):
        with pytest.raises(rl.InputError):
            rl.read_mesh(tmp_path / name)


def test_command_line(tmp_path, sphere):
    V, F = sphere
    write_off(tmp_path / "sphere.off", V, F)

    def run(*arguments):
        return subprocess.run([sys.executable, "-m", "restricted_laplacian", *map(str, arguments)],
                              capture_output=True, text=True)

    done = run(tmp_path / "sphere.off", "--count", "4")
    assert done.returncode == 0 and done.stderr == ""
    assert "vertices     2562" in done.stdout and "eigenvalues  0 2.00" in done.stdout
    done = run(tmp_path / "none.off")
    assert done.returncode == 1 and done.stdout == "" and "none.off" in done.stderr
    assert run("--version").stdout.strip() == rl.__version__


def test_an_accuracy_of_operators(sphere, monkeypatch):
    # small meshes have a depth of their own
    of_default = learning.precompute(*sphere, count=5).eigenvalues
    assert np.array_equal(of_default, learning.precompute(*sphere, count=5, depth=4).eigenvalues)
    monkeypatch.setattr(learning, "_SMALL_NUMBER_OF_FACES", 10)
    assert np.array_equal(learning.precompute(*sphere, count=5).eigenvalues, rl.laplace_spectrum(*sphere, 5).eigenvalues)
    assert rl.Space(*sphere).depth != 4
    found = learning.precompute(*sphere, count=25, accuracy=1e-5, depth=2, check=False).eigenvalues
    expected = rl.laplace_spectrum(*sphere, 25, accuracy=1e-5, depth=2, check=False)
    assert np.array_equal(found, expected.eigenvalues) and expected.space.depth > 4


def test_a_cache(tmp_path, sphere, monkeypatch):
    V, F = sphere
    first = learning.precompute(V, F, 5, cache=tmp_path / "cache")
    assert json.loads(first.description) == {"restricted_laplacian": rl.__version__, "count": 5, "accuracy": None,
                                             "depth": None, "joining_tolerance": None}

    def not_again(*args, **options):
        raise AssertionError("is in the cache")
    monkeypatch.setattr(learning, "laplace_spectrum", not_again)
    again = learning.precompute(V, F, 5, cache=tmp_path / "cache")
    assert np.array_equal(first.eigenvectors, again.eigenvectors) and again.description == first.description
    for other in (lambda: learning.precompute(V, F, 6, cache=tmp_path / "cache"),
                  lambda: learning.precompute(2 * V, F, 5, cache=tmp_path / "cache"),
                  lambda: learning.precompute(V, F[1:], 5, cache=tmp_path / "cache"),
                  lambda: learning.precompute(V, F, 5, depth=3, cache=tmp_path / "cache")):
        with pytest.raises(AssertionError):
            other()
    with pytest.raises(rl.InputError, match="cache"):
        learning.precompute(rl.Space(V, F), cache=tmp_path)


def test_processes_share_a_cache(tmp_path):
    """Each mesh is computed once, whichever of the processes comes first; and each process takes one thread."""
    script = tmp_path / "run.py"
    script.write_text(f"""
import multiprocessing, os
import restricted_laplacian as rl
from restricted_laplacian import learning

def work(number):
    seen = []
    own = learning.laplace_spectrum
    def counted(*args, **options):
        seen.append(options["threads"])
        return own(*args, **options)
    learning.laplace_spectrum = counted
    V, F = rl.icosphere(3)
    for scale in (1, 2, 3):
        learning.precompute(scale * V, F, 5, cache={str(tmp_path / "cache")!r})
    learning.laplace_spectrum = own
    return seen

if __name__ == "__main__":
    with multiprocessing.get_context("spawn").Pool(3) as pool:
        print(sorted(sum(pool.map(work, range(3), 1), [])))
""")
    done = subprocess.run([sys.executable, str(script)], capture_output=True, text=True, timeout=120)
    assert done.stdout.strip() == "[1, 1, 1]", done.stdout + done.stderr


def test_operators_of_diffusion_net(tmp_path, sphere):
    torch = pytest.importorskip("torch", reason="SKIPPED: PyTorch is not installed")
    V, F = sphere
    verts, faces = torch.tensor(V, dtype=torch.float32), torch.tensor(F)
    frames, mass, L, evals, evecs, grad_x, grad_y = found = learning.get_operators(verts, faces, 9, tmp_path)
    n = len(V)
    assert [tuple(t.shape) for t in found] == [(n, 3, 3), (n,), (n, n), (9,), (n, 9), (n, n), (n, n)]
    assert all(t.dtype == torch.float32 for t in found) and L.is_sparse and grad_x.is_sparse
    o = learning.precompute(np.asarray(verts, np.float64), F, 9)
    assert np.allclose(evecs, o.eigenvectors, atol=1e-5) and np.allclose(frames, o.frames, atol=1e-6)
    # the energy of a coordinate by L, by gradients, and that of the sphere
    z = verts[:, 2:]
    by_gradients = sum(float((mass[:, None] * torch.sparse.mm(g, z) ** 2).sum()) for g in (grad_x, grad_y))
    assert float(z.T @ torch.sparse.mm(L, z)) == pytest.approx(8 * np.pi / 3, rel=0.01)
    assert by_gradients == pytest.approx(8 * np.pi / 3, rel=0.05) and float(mass.sum()) == pytest.approx(4 * np.pi, rel=0.01)
    again = learning.get_operators(verts, faces, 9, tmp_path, overwrite_cache=True)
    assert torch.equal(again[4], evecs)
    # without a copy where types agree
    values = torch.from_dlpack(o.eigenvalues)
    values[0] = 7
    assert o.eigenvalues[0] == 7
    points = learning.get_operators(verts.double(), torch.empty((0, 3)), 4, normals=verts)
    assert points[0].dtype == torch.float64 and points[2].shape == (n, n)
    all_of_two = learning.get_all_operators([verts, 2 * verts], [faces, faces], 4)
    assert len(all_of_two) == 7 and all(len(part) == 2 for part in all_of_two)
    with pytest.raises(rl.InputError, match="normals"):
        learning.get_operators(verts, torch.empty((0, 3)))

# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""How people call: meshes of other libraries, mappings, masks, pickles, results in a notebook."""

import copy
import importlib.resources
import pathlib
import pickle
import subprocess
import sys
import types

import numpy as np
import pytest
import restricted_laplacian as rl
from conftest import data_file
from restricted_laplacian import learning

DEPTH = 3


@pytest.fixture(scope="module")
def mesh():
    return rl.icosphere(2)


def of_open3d_tensors(V, F):
    def tensor(a):
        return types.SimpleNamespace(numpy=lambda: a)
    return types.SimpleNamespace(vertex=types.SimpleNamespace(positions=tensor(V)),
                                 triangle=types.SimpleNamespace(indices=tensor(F)))


def of_meshio(V, F):
    meshio = pytest.importorskip("meshio")
    return meshio.Mesh(V, [("line", [[0, 1]]), ("triangle", F[:9]), ("triangle", F[9:])])


def of_nibabel(V, F):
    gifti = pytest.importorskip("nibabel").gifti
    return gifti.GiftiImage(darrays=[
        gifti.GiftiDataArray(V, intent="NIFTI_INTENT_POINTSET", datatype="NIFTI_TYPE_FLOAT64"),
        gifti.GiftiDataArray(F.astype(np.int32), intent="NIFTI_INTENT_TRIANGLE")])


def of_vtk(V, F):
    pytest.importorskip("vtkmodules", reason="SKIPPED: VTK is not installed")
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
    result, points, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    points.SetData(numpy_to_vtk(V, deep=True))
    cells.SetData(3, numpy_to_vtkIdTypeArray(F.ravel().astype(np.int64), deep=True))
    result.SetPoints(points)
    result.SetPolys(cells)
    return result


class Hidden:
    """Names that dir() does not list, as PyVista hides those of VTK."""

    def __init__(self, V, F):
        self.vertices, self.faces = V, F

    def __dir__(self):
        return []


MESHES = {
    "a tuple": lambda V, F: (V, F),
    "a list": lambda V, F: [V.tolist(), F.tolist()],
    "trimesh": lambda V, F: types.SimpleNamespace(vertices=V, faces=F),
    "Open3D": lambda V, F: types.SimpleNamespace(vertices=V, triangles=F.astype(np.int32)),
    "Open3D, tensors": of_open3d_tensors,
    "hidden names": Hidden,
    "LaPy": lambda V, F: types.SimpleNamespace(v=V, t=F),
    "meshio": of_meshio,
    "nibabel": of_nibabel,
    "VTK, PyVista": of_vtk,
    "a space": lambda V, F: rl.Space(V, F, depth=DEPTH),
}


@pytest.mark.parametrize("kind", MESHES)
def test_meshes_of_other_libraries(mesh, kind):
    V, F = mesh
    other = MESHES[kind](V, F)
    options = {} if kind == "a space" else {"depth": DEPTH}
    expected = rl.eigs(V, F, 5, depth=DEPTH)
    for found in (rl.eigs(other, 5, **options), rl.eigs(other, count=5, **options),
                  rl.eigs(other, None, 5, **options), rl.eigs(V=other, count=5, **options)):
        assert all(np.array_equal(a, b) for a, b in zip(found, expected))
    u = rl.solve_poisson(V, F, V[:, 2], depth=DEPTH)
    assert np.array_equal(rl.solve_poisson(other, V[:, 2], **options), u)
    assert np.array_equal(rl.solve_poisson(other, f=V[:, 2], **options), u)
    assert np.array_equal(rl.solve_screened_poisson(other, V[:, 2], 2.0, **options),
                          rl.solve_screened_poisson(V, F, V[:, 2], 2.0, depth=DEPTH))
    assert np.array_equal(rl.geodesic_distance(other, [0, 5]), rl.geodesic_distance(V, F, [0, 5]))
    assert np.array_equal(rl.farthest_points(other, 3), rl.farthest_points(V, F, 3))
    assert rl.shortest_path(other, 7, 0).length == rl.shortest_path(V, F, 7, 0).length
    assert np.array_equal(rl.cotangent_operators(other).stiffness.data,
                          rl.cotangent_operators(V, F).stiffness.data)


def test_polygons_of_other_libraries_are_divided():
    meshio = pytest.importorskip("meshio")
    V = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 0, 0], [2, 1, 0]], float)
    quads = meshio.Mesh(V, [("quad", [[0, 1, 2, 3]]), ("triangle", [[1, 4, 2]]), ("triangle", [[4, 5, 2]])])
    assert rl.Space(quads, depth=DEPTH).number_of_faces == 3
    assert len(rl.Space(quads, depth=DEPTH).triangles) == 4
    assert abs(rl.Space(quads, depth=DEPTH).area - 2) < 1e-12
    flat = meshio.Mesh(V[:, :2], [("quad", [[0, 1, 2, 3], [1, 4, 5, 2]])])
    assert rl.Space(flat, depth=DEPTH).number_of_faces == 2
    with pytest.raises(rl.InputError, match="without triangles; it has line"):
        rl.Space(meshio.Mesh(V, [("line", [[0, 1]])]))


def test_a_function_that_is_missing_is_named(mesh):
    for call in (rl.solve_poisson, rl.fit_function):
        with pytest.raises(rl.InputError, match="f is missing") as e:
            call(mesh)
        assert e.value.argument == "f"
    with pytest.raises(rl.InputError, match="alpha is missing"):
        rl.solve_screened_poisson(mesh, mesh[0][:, 2])
    for wrong in (mesh[0], [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]], ([[1.0], [2.0, 3.0]], mesh[1]), None, object()):
        with pytest.raises(rl.InputError, match="F is missing"):
            rl.eigs(wrong)


def test_constraints_are_mappings_or_pairs(mesh):
    V, F = mesh
    space = rl.Space(V, F, depth=DEPTH)

    def solve(constraints):
        return rl.solve_poisson(space, 0.0, constraints=constraints)
    expected = solve(([0, 10], [1.0, -1.0]))
    assert abs(expected[[0, 10]] - [1, -1]).max() < 1e-6
    is_first = np.zeros(len(V), bool)
    is_first[[0, 10]] = True
    series = types.SimpleNamespace(items=lambda: [(0, 1.0), (10, -1.0)])  # as of pandas
    for constraints in ({0: 1.0, 10: -1.0}, {np.int64(10): -1, np.int64(0): 1}, series,
                        (np.array([0, 10]), np.array([1.0, -1.0])), (is_first, [1.0, -1.0])):
        assert abs(solve(constraints) - expected).max() < 1e-9
    assert abs(solve(([0, 7, 9], 2.0)) - 2).max() < 1e-6
    for ambiguous in ([[0, 10], [1.0, -1.0]], [(0, 1.0), (10, -1.0)], ((0, 1.0), (10, -1.0)),
                      np.array([[0, 1.0], [10, -1.0]])):
        with pytest.raises(rl.InputError, match="give a mapping {vertex: value}") as e:
            solve(ambiguous)
        assert e.value.argument == "constraints"
    for wrong in ([(0, 1.0), (10, -1.0), (5, 0.0)], 5, ([0, 10], [1.0, 2.0, 3.0]), (is_first[1:], 0.0),
                  {0.5: 1.0}, {-1: 0.0}, {len(V): 0.0}, ([0, 1], [[1.0], [2.0]])):
        with pytest.raises(rl.InputError):
            solve(wrong)


def test_masks_are_vertices(mesh):
    V, F = mesh
    north = V[:, 2] > 0.9
    geodesics = rl.Geodesics(V, F)
    expected = rl.geodesic_distance(V, F, np.flatnonzero(north))
    assert np.array_equal(rl.geodesic_distance(V, F, north), expected)
    assert np.array_equal(rl.geodesic_distance(V, F, north.tolist()), expected)
    assert np.array_equal(geodesics.distances(north).distances, expected)
    assert geodesics.distance_matrix(north).shape == (north.sum(), len(V))
    assert not north[geodesics.farthest_points(3, north)].any()
    for wrong in (north[1:], True, np.ones((len(V), 1), bool)):
        with pytest.raises(rl.InputError, match="mask") as e:
            geodesics.distances(wrong)
        assert e.value.argument == "sources"


@pytest.mark.parametrize("name", ["f", "target", "alpha", "v"])
def test_what_is_no_number_is_named_as_the_user_counts(mesh, name):
    V, F = mesh
    space = rl.Space(V, F, depth=DEPTH)

    def call(values):
        if name == "f":
            return rl.solve_poisson(space, values)
        if name == "v":
            return rl.integrate_gradient(space, np.stack([values] * 3, axis=1))
        return rl.integrate_gradient(space, V[F].mean(axis=1), **{"alpha": 1.0, name: abs(values)})
    at_vertices = V[:, 2] + 2
    at_vertices[5] = np.nan
    with pytest.raises(rl.InputError, match=f"{name} is nan at vertex 5") as e:
        call(at_vertices)
    assert (e.value.vertex, e.value.face, e.value.argument) == (5, None, name)
    at_faces = np.ones(len(F))
    at_faces[17] = np.inf
    with pytest.raises(rl.InputError, match=f"{name} is inf at face 17") as e:
        call(at_faces)
    assert (e.value.vertex, e.value.face) == (None, 17)


def test_no_number_is_needed_where_no_face_is(mesh):
    V, F = mesh
    more = np.concatenate([V, [[9.0, 9.0, 9.0]]])
    values = np.append(V[:, 2], np.nan)
    found = rl.solve_poisson(more, F, values, depth=DEPTH, joining_tolerance=0)
    assert np.isnan(found[-1]) and np.isfinite(found[:-1]).all()
    corners = np.ones((len(F), 3))
    corners[4, 2] = np.nan
    with pytest.raises(rl.InputError, match="at face 4") as e:
        rl.fit_function(V, F, rl.Corners(corners), depth=DEPTH)
    assert e.value.face == 4
    points = V.copy()
    with pytest.raises(rl.InputError, match="at vertex 3") as e:
        rl.fit_function(points, None, np.where(np.arange(len(V)) == 3, np.nan, 0.0), normals=V, depth=DEPTH)
    assert e.value.vertex == 3


def same(a, b):
    return np.array_equal(np.asarray(a), np.asarray(b), equal_nan=True)


def project(points):
    return points / np.linalg.norm(points, axis=1, keepdims=True)


@pytest.mark.parametrize("options", [
    {}, {"geometry": "smooth", "vertex_data": "smooth"}, {"geometry": project}, {"joining_tolerance": 1e-3},
    {"split": False, "cube_scale": 1.3, "threads": 1}, {"paper": True}])
def test_spaces_and_what_is_made_of_them_can_be_pickled(mesh, options):
    V, F = mesh
    space = rl.Space(V, F, depth=DEPTH, **options)
    f = V[:, 2]
    again = pickle.loads(pickle.dumps(space))
    assert repr(again) == repr(space)
    assert same(again.loads(f), space.loads(f))
    u = rl.fit_function(space, f, as_spline=True)
    assert same(pickle.loads(pickle.dumps(u)).at_vertices(), u.at_vertices())
    solver = rl.PoissonSolver(space, 2.0, tolerance=1e-8, cycle="w")
    b = space.loads(f)
    assert same(pickle.loads(pickle.dumps(solver)).solve(b), solver.solve(b))


def test_points_spectra_and_distances_can_be_pickled(mesh):
    V, F = mesh
    points = rl.Space(V, normals=V, depth=DEPTH)
    again = pickle.loads(pickle.dumps(points))
    assert abs(again.loads(V[:, 0]) - points.loads(V[:, 0])).max() < 1e-14
    s = rl.laplace_spectrum(V, F, 5, depth=DEPTH)
    t = copy.deepcopy(s)
    assert same(t.eigenvalues, s.eigenvalues) and same(t.functions().at_vertices(), s.vertex_values)
    assert dict(t.report) == dict(s.report) and t.report.eigensolver == s.report.eigensolver
    d = rl.Geodesics(V, F, joining_tolerance=1e-6).function([0, 3], exact=True)
    where = [0, 5], [[1, 0, 0], [0.2, 0.3, 0.5]]
    assert same(pickle.loads(pickle.dumps(d))(*where), d(*where))
    spline = rl.Geodesics(rl.Space(V, F, depth=DEPTH)).spline(0)
    assert same(pickle.loads(pickle.dumps(spline))(*where), spline(*where))
    for result in (rl.curvature(V, F, depth=DEPTH), rl.geodesic_distance(V, F, 0), rl.View(V, F),
                   rl.Corners(np.zeros((len(F), 3))), learning.precompute(V, F, 4, depth=DEPTH)):
        pickle.loads(pickle.dumps(result))


def test_results_print_shortly(mesh):
    V, F = mesh
    space = rl.Space(V, F, depth=DEPTH)
    s = rl.laplace_spectrum(space, 5)
    u, report = rl.fit_function(space, V[:, 0], as_spline=True, return_report=True)
    results = [space, s, u, report, rl.curvature(space), space.operators(), rl.PoissonSolver(space),
               rl.Geodesics(V, F), rl.Geodesics(V, F).function(0), rl.Geodesics(V, F).distances(0),
               rl.shortest_path(V, F, 1, 2), rl.estimate_memory(V, F, depth=4),
               learning.precompute(V, F, 4, depth=DEPTH)]
    for result in results:
        text = result._repr_html_()
        assert text.startswith("<table>") and text.endswith("</table>") and len(text) < 2500, text
        if result is not report:
            assert repr(result).startswith(type(result).__name__ + "(") and len(repr(result)) < 500
    assert f"dimension={space.dimension}" in repr(s)
    assert "array of 162 x 5" in repr(s)


def test_all_that_solves_can_report(mesh):
    V, F = mesh
    space = rl.Space(V, F, depth=DEPTH)
    calls = {
        "eigs": lambda **o: rl.eigs(space, 5, **o),
        "laplace_spectrum": lambda **o: rl.laplace_spectrum(space, 5, **o),
        "solve_poisson": lambda **o: rl.solve_poisson(space, V[:, 0], **o),
        "solve_screened_poisson": lambda **o: rl.solve_screened_poisson(space, V[:, 0], 1.0, **o),
        "fit_function": lambda **o: rl.fit_function(space, V[:, 0], **o),
        "curvature": lambda **o: rl.curvature(space, **o),
        "integrate_gradient": lambda **o: rl.integrate_gradient(space, V[F].mean(axis=1), **o),
        "stitch_colors": lambda **o: rl.stitch_colors(
            space, [rl.Scan(V, F, abs(V), viewpoint=(0, 0, 9))], **o)}
    for name, call in calls.items():
        heard = []
        result, report = call(threads=1, progress=heard.append, check=True, return_report=True)
        assert report.converged, name
        assert heard and heard[-1] == 1, name
        with pytest.raises(rl.Canceled):
            call(progress=lambda done: False)
    heard = []
    rl.geodesic_distance(V, F, 0, threads=1, progress=heard.append)
    rl.farthest_points(V, F, 3, threads=1, progress=heard.append)
    rl.shortest_path(V, F, 1, 0, threads=1, progress=heard.append)
    assert heard


def test_cotangent_operators(mesh):
    V, F = mesh
    S, M = rl.cotangent_operators(V, F)
    lumped = rl.cotangent_operators(V, F, lumped_mass=True).mass
    area = rl.Space(V, F, depth=DEPTH).area
    x = V[:, 0]
    assert abs(M.sum() - area) < 1e-12 and abs(lumped.sum() - area) < 1e-12
    assert abs(lumped - M.multiply(np.eye(len(V)))).max() > 0 and (lumped != lumped.T).nnz == 0
    # of each triangle: the squared gradient of a linear function, times the area
    a, b, c = V[F].swapaxes(0, 1)
    n = np.cross(b - a, c - a)
    g = (x[F][:, 0, None] * np.cross(n, c - b) + x[F][:, 1, None] * np.cross(n, a - c)
         + x[F][:, 2, None] * np.cross(n, b - a)) / (n ** 2).sum(axis=1)[:, None]
    assert abs(x @ S @ x - ((g ** 2).sum(axis=1) * np.linalg.norm(n, axis=1) / 2).sum()) < 1e-12
    # three triangles at an edge, one without area, a vertex without a face
    W = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [5, 5, 5]], float)
    G = np.array([[0, 1, 2], [0, 1, 3], [0, 1, 4], [0, 1, 1]])
    S, M = rl.cotangent_operators(W, G)
    assert np.isfinite(S.data).all() and abs(S.sum(axis=1)).max() < 1e-15 and abs(M.sum() - 1.5) < 1e-15
    assert S.getrow(5).nnz == 0
    with pytest.raises(rl.InputError):
        rl.cotangent_operators(rl.Space(V, normals=V, depth=DEPTH))


@pytest.mark.parametrize("of_points", [False, True])
def test_eigenfunctions_that_are_orthonormal_at_vertices(mesh, of_points):
    V, F = rl.icosphere(4)
    surface = dict(V=V, normals=V) if of_points else dict(V=V, F=F)
    k = 60
    M = rl.cotangent_operators(V, F).mass
    if of_points:
        space = rl.Space(V, normals=V, depth=4)
        M = np.diag(space._surface.vertex_areas())

    def error(u):
        return abs(u.T @ (M @ u) - np.eye(k)).max()
    plain = rl.laplace_spectrum(**surface, count=k, depth=4)
    s = rl.laplace_spectrum(**surface, count=k, depth=4, orthonormal="vertices")
    assert of_points or error(plain.vertex_values) > 1e-3
    assert error(s.vertex_values) < 1e-12
    assert np.array_equal(s.eigenvalues, plain.eigenvalues)
    assert abs(s.functions().at_vertices() - s.vertex_values).max() < 1e-10
    assert abs(s.vertex_values[:, :9] - plain.vertex_values[:, :9]).max() < 0.05
    assert same(rl.eigs(**surface, count=k, depth=4, orthonormal="vertices")[1], s.vertex_values)
    with pytest.raises(rl.InputError, match="must be surface or vertices"):
        rl.eigs(V, F, 5, orthonormal="mass")
    with pytest.raises(rl.InputError, match="do not tell"):
        rl.eigs(*rl.icosphere(0), 20, depth=4, orthonormal="vertices")


@pytest.mark.parametrize("mesh, said", [("elephant.off", 13), ("neuromodes", 0.8)])
def test_the_manual_says_how_orthonormal_values_at_vertices_are(mesh, said):
    if mesh == "neuromodes":
        data = importlib.resources.files(pytest.importorskip(
            "neuromodes", reason="SKIPPED: neuromodes is not installed")) / "data"
        surface = rl.read_mesh(data / "sp-human_tpl-fsLR_den-32k_hemi-L_midthickness.surf.gii")
    else:
        surface = rl.read_mesh(data_file(mesh))
    u = rl.eigs(surface, 100)[1]
    error = 100 * abs(u.T @ (rl.cotangent_operators(surface).mass @ u) - np.eye(100)).max()
    assert abs(error / said - 1) < 0.05
    page = pathlib.Path(__file__).parents[2] / "doc/Restricted_laplacian_3/Python.txt"
    assert f"up to {said} %" in " ".join(page.read_text().split())


def test_a_script_without_a_guard_is_told(tmp_path):
    (tmp_path / "meshes").mkdir()
    (tmp_path / "meshes/a.off").write_text("OFF 3 1 0 0 0 0 1 0 0 0 1 0 3 0 1 2")
    script = tmp_path / "script.py"
    script.write_text("from restricted_laplacian import learning\n"
                      "learning.precompute_folder('meshes', 'cache', 4, processes=1)\n")
    run = subprocess.run([sys.executable, script], cwd=tmp_path, capture_output=True, text=True, timeout=60)
    assert run.returncode != 0
    assert 'call it from under `if __name__ == "__main__":`' in run.stderr
    assert "memory" not in run.stderr


def test_an_accuracy_chooses_the_depth():
    V, F = rl.icosphere(5)
    x, _, z = V.T
    zonal = (63 * z**5 - 70 * z**3 + 15 * z) / 8  # a harmonic of degree 5
    exact = -zonal / 30
    depths = []
    for accuracy in (0.05, 1e-3):
        u, report = rl.solve_poisson(V, F, zonal, accuracy=accuracy, return_report=True, as_spline=True)
        assert report.estimated_error <= accuracy and report.is_estimate_trusted
        error = np.linalg.norm(u.at_vertices() - exact) / np.linalg.norm(exact)
        assert error <= max(accuracy, 5e-3)  # which is that of the facets
        depths.append(u.space.depth)
        assert pickle.loads(pickle.dumps(u)).space.depth == u.space.depth
    assert depths[0] < depths[1]
    # several columns have the depth that the worst of them needs; a callable is called in each space
    assert rl.solve_poisson(V, F, z, accuracy=1e-3, as_spline=True).space.depth == depths[0]
    both, report = rl.solve_poisson(V, F, np.stack([z, zonal], axis=1), accuracy=1e-3, return_report=True,
                                    as_spline=True)
    assert both.space.depth == depths[1] and report.estimated_error <= 1e-3
    assert np.abs(both.at_vertices()[:, 0] + z / 2).max() < 1e-2
    called = rl.solve_poisson(V, F, lambda p: (63 * p[:, 2]**5 - 70 * p[:, 2]**3 + 15 * p[:, 2]) / 8, accuracy=1e-3,
                              as_spline=True)
    assert called.space.depth == depths[1]
    values, report = rl.laplace_spectrum(V, F, 49, accuracy=1e-3, eigenvalues_only=True, return_report=True)
    assert report.estimated_error <= 1e-3 and np.abs(values.eigenvalues[1:4] - 2).max() < 4e-3
    assert values.space.depth > rl.laplace_spectrum(V, F, 49, accuracy=0.5, eigenvalues_only=True).space.depth
    assert rl.eigs(V, F, 16, accuracy=1e-3, return_report=True)[1].estimated_error <= 1e-3


def test_an_accuracy_that_cannot_be_reached_is_told():
    V, F = rl.icosphere(3)
    with pytest.raises(rl.ConvergenceError, match="accura"):
        rl.solve_poisson(V, F, V[:, 2], constraints={0: 1.0, 9: 2.0}, accuracy=1e-5)
    space = rl.Space(V, F, depth=3)
    for call in (lambda: rl.solve_poisson(space, None, V[:, 2], accuracy=0.1),
                 lambda: rl.eigs(space, None, 5, accuracy=0.1)):
        with pytest.raises(rl.InputError, match="accuracy.*surface"):
            call()
    for wrong in (0, -1, 1, float("nan")):
        with pytest.raises(rl.InputError, match="accuracy"):
            rl.solve_poisson(V, F, V[:, 2], accuracy=wrong)
    rng = np.random.default_rng(0)
    points = rng.normal(size=(400, 3))
    points /= np.linalg.norm(points, axis=1, keepdims=True)
    # as deep as the points allow, and not deeper
    u, report = rl.solve_poisson(points, None, np.sin(9 * points[:, 2]), normals=points, accuracy=1e-4, check=False,
                                 return_report=True, as_spline=True)
    assert not report.converged and u.space.depth == rl.Space(points, None, normals=points).depth

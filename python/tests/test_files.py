# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Files of meshes: what is read, and what a refusal says."""

import gzip
import sys

import numpy as np
import pytest
import restricted_laplacian as rl

SQUARE = "OFF\n4 2\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n"
FACES = [[0, 1, 2], [0, 2, 3]]


def written(folder, name, text):
    file = folder / name
    file.write_bytes(text.encode())
    return file


@pytest.mark.parametrize("name, text", [
    ("a.off", SQUARE.replace("\n", "\r")),
    ("a.OFF", "\ufeff" + SQUARE),
    ("a.obj", "v 0 0 0\nv 1 0 0 \\\n 1\nv 1 1 0\nv 0 1 0\nl 1 2\nf -4/1 -3 -2//3\nf 1 3 4\n"),
    ("a.vtk", "# vtk DataFile Version 4.2\n\nASCII\nDATASET POLYDATA\nPOINTS 4 int\n0 0 0 1 0 0 1 1 0 0 1 0\n"
              "POLYGONS 2 8\n3 0 1 2 3 0 2 3\n"),
    ("a.stl", "a comment\nSOLID\n" + "".join(
        f"FACET NORMAL 0 0 0 OUTER LOOP VERTEX {a} VERTEX {b} VERTEX {c} ENDLOOP ENDFACET\n"
        for a, b, c in (("0 0 0", "1 0 0", "1 1 0"), ("0 0 0", "1 1 0", "0 1 0")))),
])
def test_files_are_read_as_they_are_meant(tmp_path, name, text):
    V, F = rl.read_mesh(written(tmp_path, name, text))
    assert V.tolist() == [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
    assert F.tolist() == FACES


def test_a_refusal_names_the_place(tmp_path):
    with pytest.raises(rl.InputError, match=r"comma.off', line 5, vertex 2: '1,5' .*decimal commas") as e:
        rl.read_mesh(written(tmp_path, "comma.off", SQUARE.replace("1 1 0", "1,5 1 0")))
    assert (e.value.vertex, e.value.face) == (2, None)
    with pytest.raises(rl.InputError, match=r"line 8, face 1: names vertex 9, of 4") as e:
        rl.read_mesh(written(tmp_path, "index.off", SQUARE.replace("3 0 2 3", "3 0 2 9")))
    assert (e.value.vertex, e.value.face) == (None, 1)
    for name, text, reason in (("a.foo", "1", "suffix .foo, which is not read; known are .off.*and .gii"),
                               ("a.off", "", "has 0 bytes"), ("b.off", "OFF\n1 0\n0 0 0\n", "holds no face")):
        with pytest.raises(rl.InputError, match=reason):
            rl.read_mesh(written(tmp_path, name, text))
    with pytest.raises(rl.InputError, match="is a directory"):
        (tmp_path / "folder.ply").mkdir()
        rl.read_mesh(tmp_path / "folder.ply")
    with pytest.raises(rl.InputError, match="cannot be opened"):
        rl.read_mesh(tmp_path / "nothing.ply")


def test_what_is_passed_over_is_a_warning(tmp_path):
    triangle = np.zeros(1, dtype=[("normal", "<f4", 3), ("points", "<f4", (3, 3)), ("more", "<u2")])
    triangle["points"] = [[[0, 0, 0], [1, 0, 0], [0, 1, 0]]]
    file = tmp_path / "a.stl"
    file.write_bytes(b"solid".ljust(80) + np.uint32(1).tobytes() + triangle.tobytes() + b"more")
    with pytest.warns(UserWarning, match="there are 4 bytes more"):
        V, F = rl.read_mesh(file)
    assert F.tolist() == [[0, 1, 2]]


@pytest.fixture(scope="module")
def cortex():
    """A sphere with numbers at its vertices, as FreeSurfer has them: of four bytes."""
    V, F = rl.icosphere(2)
    return V.astype(np.float32).astype(np.float64), F, V[:, 0].astype(np.float32)


def test_gifti(tmp_path, cortex):
    nibabel = pytest.importorskip("nibabel", reason="SKIPPED: nibabel is not installed")
    V, F, x = cortex
    labels = np.arange(len(V), dtype=np.int32) % 3

    def array(values, intent, **options):
        return nibabel.gifti.GiftiDataArray(values, intent=f"NIFTI_INTENT_{intent}", **options)
    surface = [array(V.astype(np.float32), "POINTSET"), array(F.astype(np.int32), "TRIANGLE")]
    data = [array(x, "SHAPE"), array(labels, "LABEL"), array(x, "TIME_SERIES"), array(2 * x, "TIME_SERIES"),
            array(x, "SHAPE", meta=nibabel.gifti.GiftiMetaData(Name="sulc"))]
    for name, arrays in (("lh.surf.gii", surface), ("all.gii", surface + data), ("lh.shape.gii", data)):
        nibabel.save(nibabel.gifti.GiftiImage(darrays=arrays), tmp_path / name)
    packed = tmp_path / "packed.GII.GZ"
    packed.write_bytes(gzip.compress((tmp_path / "lh.surf.gii").read_bytes()))
    for name in ("lh.surf.gii", "all.gii", packed.name):
        found = rl.read_mesh(tmp_path / name)
        assert np.array_equal(found[0], V) and np.array_equal(found[1], F)
    assert rl.read_vertex_properties(packed) == {}
    for name in ("all.gii", "lh.shape.gii"):
        found = rl.read_vertex_properties(tmp_path / name)
        assert list(found) == ["shape", "label", "time series", "sulc"]
        assert np.array_equal(found["shape"], x) and np.array_equal(found["label"], labels)
        assert np.array_equal(found["time series"], np.stack([x, 2 * x], axis=1))
    with pytest.raises(rl.InputError, match="lh.shape.gii.*without points and triangles"):
        rl.read_mesh(tmp_path / "lh.shape.gii")
    (tmp_path / "folder.gii").mkdir()
    for name, reason in (("folder.gii", "is a directory"), ("nothing.gii", "cannot be opened: No such")):
        with pytest.raises(rl.InputError, match=f"{name}' *:? *{reason}"):
            rl.read_mesh(tmp_path / name)
    text = (tmp_path / "lh.surf.gii").read_bytes()
    for name, wrong in (("cut.gii", text[:700]), ("text.gii", b"hello"), ("empty.gii", b""),
                        ("cut.gii.gz", packed.read_bytes()[:50]), ("plain.gii.gz", text)):
        (tmp_path / name).write_bytes(wrong)
        with pytest.raises(rl.InputError, match=f"{name}'"):
            rl.read_mesh(tmp_path / name)
    surface[1] = array(F.astype(np.int32) + 5, "TRIANGLE")
    nibabel.save(nibabel.gifti.GiftiImage(darrays=surface), tmp_path / "wrong.gii")
    with pytest.raises(rl.InputError, match="wrong.gii.*names a vertex that does not exist") as e:
        rl.read_mesh(tmp_path / "wrong.gii")
    assert e.value.face is not None


def test_freesurfer(tmp_path, cortex):
    freesurfer = pytest.importorskip("nibabel.freesurfer", reason="SKIPPED: nibabel is not installed")
    V, F, x = cortex
    freesurfer.write_geometry(tmp_path / "lh.white", V, F)
    freesurfer.write_morph_data(tmp_path / "lh.thickness", x)
    freesurfer.write_annot(tmp_path / "lh.aparc.annot", np.arange(len(V)) % 2,
                           np.array([[1, 2, 3, 0, 0], [4, 5, 6, 0, 1]]), ["a", "b"], fill_ctab=True)
    freesurfer.save(freesurfer.MGHImage(x[:, None, None], np.eye(4)), tmp_path / "lh.area.mgh")
    found = rl.read_mesh(tmp_path / "lh.white")
    assert np.array_equal(found[0], V) and np.array_equal(found[1], F)
    assert rl.read_vertex_properties(tmp_path / "lh.white") == {}
    for name, key, values in (("lh.thickness", "thickness", x), ("lh.area.mgh", "mgh", x),
                              ("lh.aparc.annot", "annot", np.arange(len(V)) % 2)):
        found, = rl.read_vertex_properties(tmp_path / name).items()
        assert found[0] == key and np.array_equal(found[1], values), name
    for name, wrong in (("lh.pial", b"\xff\xff\xfe"), ("rh.white", (tmp_path / "lh.white").read_bytes()[:900]),
                        ("lh.sulc", b"\xff\xff\xff\x00")):
        (tmp_path / name).write_bytes(wrong)
        with pytest.raises(rl.InputError, match=name):
            rl.read_mesh(tmp_path / name)
    with pytest.raises(rl.InputError, match="lh.sulc"):
        rl.read_vertex_properties(tmp_path / "lh.sulc")


def test_what_meshio_reads(tmp_path, cortex, capfd):
    meshio = pytest.importorskip("meshio", reason="SKIPPED: meshio is not installed")
    V, F, x = cortex
    meshio.Mesh(V, [("line", [[0, 1]]), ("triangle", F)], point_data={"x": x, "v": V}).write(
        tmp_path / "a.vtk")
    meshio.Mesh(V, [("triangle", F)], point_data={"x": x}).write(tmp_path / "a.vtu")
    for name in ("a.vtk", "a.vtu"):  # a grid in the form of VTK, which is no polydata
        found = rl.read_mesh(tmp_path / name)
        assert np.array_equal(found[0], V) and np.array_equal(found[1], F)
        assert np.array_equal(rl.read_vertex_properties(tmp_path / name)["x"], x)
    meshio.Mesh(V, [("vertex", [[0]])]).write(tmp_path / "points.vtu")
    with pytest.raises(rl.InputError, match="points.vtu.*without triangles; it has vertex"):
        rl.read_mesh(tmp_path / "points.vtu")
    capfd.readouterr()
    for name, text in (("a.msh", "hello"), ("b.vtu", "<VTKFile>"), ("c.mesh", ""), ("d.inp", "\0\1")):
        with pytest.raises(rl.InputError, match=name):  # meshio prints, and ends the process
            rl.read_mesh(written(tmp_path, name, text))
    assert capfd.readouterr() == ("", "")


def test_vtp(tmp_path, cortex, capfd):
    xml = pytest.importorskip("vtkmodules.vtkIOXML", reason="SKIPPED: VTK is not installed")
    from test_calls import of_vtk
    from vtkmodules.util.numpy_support import numpy_to_vtk
    V, F, x = cortex
    polygons, column = of_vtk(V, F), numpy_to_vtk(x, deep=True)
    column.SetName("x")
    polygons.GetPointData().AddArray(column)
    writer = xml.vtkXMLPolyDataWriter()
    writer.SetFileName(str(tmp_path / "a.vtp"))
    writer.SetInputData(polygons)
    writer.Write()
    found = rl.read_mesh(tmp_path / "a.vtp")
    assert np.array_equal(found[0], V) and np.array_equal(found[1], F)
    assert np.array_equal(rl.read_vertex_properties(tmp_path / "a.vtp")["x"], x)
    text = (tmp_path / "a.vtp").read_bytes()
    for name, wrong in (("cut.vtp", text[:len(text) // 2]), ("other.vtp", b"<VTKFile/>"), ("text.vtp", b"hi"),
                        ("empty.vtp", b"")):
        (tmp_path / name).write_bytes(wrong)
        with pytest.raises(rl.InputError, match=name):
            rl.read_mesh(tmp_path / name)
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize("name, text, package", [
    ("a.gii", "<GIFTI/>", "nibabel"), ("lh.white", "", "nibabel"), ("a.vtp", "<VTKFile/>", "vtk"),
    ("a.vtk", "# vtk\n\nASCII\nDATASET UNSTRUCTURED_GRID\n", "meshio")])
def test_a_package_that_is_missing_is_named(tmp_path, monkeypatch, name, text, package):
    for module in [m for m in sys.modules if m.split(".")[0] in ("nibabel", "vtkmodules", "meshio")]:
        monkeypatch.delitem(sys.modules, module)
    for module in ("nibabel", "nibabel.freesurfer", "vtkmodules", "vtkmodules.vtkIOXML", "meshio"):
        monkeypatch.setitem(sys.modules, module, None)
    file = written(tmp_path, name, text)
    if name == "lh.white":
        file.write_bytes(b"\xff\xff\xfe\n")
    with pytest.raises(rl.InputError, match=f"needs the package {package}, which is not installed: "
                       r"pip install restricted-laplacian\[files\]"):
        rl.read_mesh(file)
    with pytest.raises(rl.InputError, match="suffix .vtu, which is not read.*if it is installed"):
        rl.read_mesh(written(tmp_path, "a.vtu", "<VTKFile/>"))


def test_properties_of_our_own_formats(tmp_path):
    text = ("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
            "property uchar red\nproperty double u\nelement face 1\nproperty list uchar int vertex_indices\n"
            "end_header\n0 0 0 255 0.5\n1 0 0 0 1.5\n0 1 0 7 -2\n3 0 1 2\n")
    found = rl.read_vertex_properties(written(tmp_path, "a.ply", text))
    assert found["red"].dtype == np.uint8 and found["red"].tolist() == [255, 0, 7]
    assert found["u"].dtype == np.float64 and found["u"].tolist() == [0.5, 1.5, -2]
    with pytest.raises(rl.InputError, match="line 12, vertex 0"):
        rl.read_vertex_properties(written(tmp_path, "b.ply", text.replace("255 0.5", "a 0.5")))

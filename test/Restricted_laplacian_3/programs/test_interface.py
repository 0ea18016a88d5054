# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""What all programs promise: help, errors of one line, files that are whole or not there."""

import os
import pathlib
import re
import resource
import signal
import struct
import subprocess

import numpy as np
import pytest
from conftest import (DATA, ENVIRONMENT, HAS_DRAW_MESH, HAS_VIEWER, SPHERE, Table, arguments, fails, run, sphere,
                      succeeds, write_off)

COMMON = ("depth cube-scale no-split joining-tolerance paper csv output html threads quiet verbose progress help "
          "version ")
INTEGRATION = "assembly samples sampling seed "
POINTS = "neighbors split "
EXPLAINED = {
    "solve_poisson": COMMON + INTEGRATION + POINTS + "refine rhs rhs-property boundary-property flux-property alpha "
    "tolerance stabilization cycle smoother",
    "laplace_spectrum": COMMON + INTEGRATION + POINTS + "refine count operator lumped-mass eigenfunction eigensolver "
    "tolerance stabilization",
    "spectral_descriptors": COMMON + INTEGRATION + "refine descriptor count columns time energy scaled normalization "
    "compare column eigensolver tolerance",
    "diffuse": COMMON + INTEGRATION + POINTS + "refine property time fwhm source-property boundary-property "
    "diffusion-property density-property tolerance stabilization",
    "edit_surface": COMMON + "gradient-scale gradient-scale-property alpha anisotropic length factor tolerance stabilization",
    "flow_surface": COMMON + "steps time-step conformal rescaling no-fixed-boundary pictures tolerance stabilization",
    "fit_function": COMMON + INTEGRATION + POINTS + "refine property normals smoothing refinements tolerance "
    "stabilization",
    "estimate_curvature": COMMON + INTEGRATION + POINTS + "refine method smoothing tolerance stabilization show clip",
    "bake_scans": "views resolution field-of-view points noise exposure-range exposures tint light linear-light "
    "pattern seed quiet version",
    "stitch_colors": COMMON + "poses frame method gradients alpha maximum-distance normal-angle no-oriented leave-out "
    "no-match-exposures linear-light no-details truth tolerance stabilization",
    "geodesic_distance": "source boundary farthest zero-property maximum-distance joining-tolerance exact maximum-memory neighbors split path "
    "isolines lines show csv output refine depth threads quiet verbose progress version",
    "draw_mesh": "property range no-legend isolines view up beside size version",
}


def sections_of_help(program):
    """The text of --help; its examples, as calls and lines on them; and the exit status."""
    text = succeeds([program, "--help"]).out
    examples, end = re.split(r"^Exit status:$", re.split(r"^Examples:$", text, flags=re.M)[1], flags=re.M)
    examples = re.sub(r"\\\n *", "", examples)
    calls = re.findall(rf"^  ({program} .*)", examples, re.M)
    return text, calls, re.findall(r"^      [a-z].*", examples, re.M), end


def test_help():
    for program, options in EXPLAINED.items():
        if program in ("draw_mesh", "flow_surface") and not HAS_DRAW_MESH:
            continue
        text, calls, lines, end = sections_of_help(program)
        assert text.startswith(f"usage: {program} MESH "), program
        assert len(calls) >= 2 and len(lines) == len(calls), program
        assert len(re.findall("^  [0-2]  ", end, re.M)) in (2, 3), program
        assert all(len(line) <= 92 for line in text.splitlines()), program
        for option in options.split() + re.findall(" --([a-z-]*)", " ".join(calls)):
            assert re.search(f"^  --{option} ", text, re.M), f"{program} does not explain --{option}"
        if program == "bake_scans":
            assert not re.search("[09]{6}", text), "defaults are rounded"
    for program in ("solve_poisson", "bake_scans"):
        assert re.fullmatch(program + r" \(Restricted_laplacian_3 \d+\.\d+\.\d+, CGAL [\d.]+.*\)\n",
                            succeeds([program, "--version"]).out)


def test_help_examples(elephant):
    """On the meshes that they name. Those of stitch_colors and draw_mesh read what those of others write."""
    os.mkdir("meshes")
    for file in DATA.glob("*.off"):
        os.symlink(file, f"meshes/{file.name}")
    os.symlink(DATA.parent / "points_3", "points_3")
    os.chdir("meshes")
    for program in EXPLAINED:
        if program in ("draw_mesh", "flow_surface") and not HAS_DRAW_MESH:
            continue
        for example in sections_of_help(program)[1]:
            files = re.findall(r"--(?:csv|output) ([^ ]*)", example) + re.findall(r"[^ ]*\.(?:png|html)", example)
            if not HAS_VIEWER and any(file.endswith(".html") for file in files):
                continue
            for file in files:
                pathlib.Path(file).unlink(missing_ok=True)
            subprocess.run(["bash", "-c", example], env=ENVIRONMENT, stdin=subprocess.DEVNULL, check=True)
            for file in files:
                assert os.path.getsize(file) > 0, example


def write_binary_ply(file, points, faces, properties=()):
    """Coordinates and properties as float, a row for each vertex."""
    points = np.asarray(points, np.float32)
    header = ["ply", "format binary_little_endian 1.0", f"element vertex {len(points)}"]
    header += [f"property float {name}" for name in ("x", "y", "z", *properties)]
    header += [f"element face {len(faces)}", "property list uchar int vertex_indices", "end_header", ""]
    data = "\n".join(header).encode() + points.astype("<f4").tobytes()
    pathlib.Path(file).write_bytes(data + b"".join(struct.pack("<B3i", 3, *f) for f in faces))


TRIANGLE = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"
BAD_FILES = {
    "nothing.off": "",
    "text.off": "this is not a mesh\n",
    "empty.off": "OFF\n0 0 0\n",
    "points_only.off": "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n",
    "nan.off": TRIANGLE.replace("0 1 0\n3", "nan 1 0\n3"),
    "line.off": TRIANGLE.replace("0 1 0\n3", "2 0 0\n3"),
    "bad_index.off": TRIANGLE.replace("3 0 1 2", "3 0 1 7"),
    "negative_index.off": TRIANGLE.replace("3 0 1 2", "3 0 1 -1"),
    "two_corners.off": TRIANGLE.replace("3 1 0", "3 2 0") + "2 0 1\n",
    "decimal_comma.off": TRIANGLE.replace("0 0 0", "0,5 0 0"),
    "mesh.vtp": "<VTKFile>\n",
    "no_x.ply": "ply\nformat ascii 1.0\nelement vertex 3\nproperty float a\nproperty float y\nproperty float z\n"
                "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
}

# arguments of a program after its name, and a part of the error
WRONG_CALLS = {
    "": "no mesh", "missing.off": "missing.off", "text.off": "text.off", "nothing.off": "nothing.off",
    "unknown_format.xyz123": "unknown_format", "empty.off": "empty.off", "points_only.off": "points_only.off",
    "nan.off": "nan.off", "nan.ply": "nan.ply.*vertex 2", "decimal_comma.off": "decimal_comma.off.*line 3.*vertex 0.*0,5",
    "mesh.vtp": "mesh.vtp.*suffix .vtp", "no_x.ply": "no_x.ply.*no vertex property 'x'; there are: a, y, z",
    "line.off": "area|degenerate", "bad_index.off": "bad_index.off", "negative_index.off": "negative_index.off",
    "two_corners.off": "two_corners.off.*face 1.*corner", "truncated.off": "truncated.off", "folder.off": "folder.off",
    "small.off small.off": "positional", "small.off --frobnicate": "unrecognised.*frobnicate",
    "small.off --dep 3": "unrecognised.*dep", "small.off --depth": "depth.*missing|missing.*depth",
    "small.off --depth 7x": "7x", "small.off --depth 7.5": "7.5", "small.off --depth 99": " --depth is 99",
    "small.off --depth 0": " --depth is 0", "small.off --depth -3": " --depth is -3",
    "small.off --cube-scale 0.5": " --cube-scale is 0.5", "small.off --cube-scale nan": "cube",
    "small.off --cube-scale inf": "cube", "small.off --assembly magic": "assembly",
    "small.off --assembly monte-carlo --samples 0": "samples", "small.off --samples 1000": "samples",
    "small.off --seed -1": "seed", "small.off --threads 0": "threads",
    # outputs are tried before the input is read
    "missing.off --csv nowhere/table.csv": "nowhere/table.csv.* of --csv",
    "missing.off --output nowhere/mesh.ply": "nowhere/mesh.ply.* of --output",
    "missing.off --csv folder.off": "folder.off' of --csv",
    "missing.off --output mesh.jpg": "mesh.jpg' of --output.*.ply or .obj",
    "missing.off --csv same.ply --output same.ply": "the same file",
    "missing.off --csv new.csv --output new.ply": "missing.off", "missing.off --csv old.csv": "missing.off",
    "small.off --refine 2": "refine needs --output", "small.off --output new.ply --refine 0": "refine",
}
WRONG_CALLS_OF = {
    "solve_poisson small.off": {
        "--rhs w": "rhs", "--rhs x --rhs-property value": "rhs", "--rhs-property height": "small.off.*height",
        "--alpha -1": "alpha", "--alpha nan": "alpha", "--tolerance 0": "tolerance", "--tolerance 1e-": "1e-",
        "--cycle x": "cycle", "--smoother magic": "smoother"},
    "laplace_spectrum small.off": {
        "--count 0": "count", "--count ten": "ten", "--operator magic": "operator",
        "--lumped-mass": "lumped-mass has no effect", "--count 3 --eigenfunction 3": "eigenfunction",
        "--count 3 --eigenfunction -1": "eigenfunction", "--eigensolver magic": "eigensolver",
        "--eigensolver multigrid --paper": "eigensolver", "--tolerance 0": "tolerance",
        "--stabilization -1": "stabilization"},
    "spectral_descriptors small.off": {
        "--descriptor magic": "descriptor", "--count 0": "count", "--depth 2 --count 5000": " --count is",
        "--depth 2 --count 1": "eigenvalues", "--columns 1": "columns", "--descriptor gps --columns 5": "columns",
        "--time 0": "time", "--time nan": "time", "--descriptor wks --time 1": "time", "--energy 1": "energy",
        "--descriptor wks --energy inf": "energy", "--descriptor wks --scaled": "scaled",
        "--normalization weyl": "normalization", "--descriptor shape-dna --normalization magic": "normalization",
        "--compare small.off": "compare",
        "--depth 2 --count 5 --descriptor shape-dna --compare missing.off": "missing.off", "--column -1": "column",
        "--depth 3 --descriptor gps --column 99": "column.*99", "--descriptor shape-dna --column 0": "column",
        "--descriptor shape-dna --output dna.ply": "output"},
}


@pytest.mark.parametrize("program", ["solve_poisson", "laplace_spectrum", "spectral_descriptors"])
def test_bad_input(program):
    for name, text in BAD_FILES.items():
        pathlib.Path(name).write_text(text)
    mesh = pathlib.Path("sphere.off").read_text()
    pathlib.Path("unknown_format.xyz123").write_text(mesh)
    pathlib.Path("truncated.off").write_text("".join(mesh.splitlines(True)[:500]))
    write_binary_ply("nan.ply", [[0, 0, 0], [1, 0, 0], [0, float("nan"), 0]], [[0, 1, 2]])
    os.mkdir("folder.off")
    pathlib.Path("old.csv").write_text("old")
    for words, pattern in WRONG_CALLS.items():
        fails(pattern, f"{program} {words}")
    assert not os.path.exists("new.csv") and not os.path.exists("new.ply"), "an empty file is left"
    assert pathlib.Path("old.csv").read_text() == "old"
    if pathlib.Path("/dev/full").is_char_device():
        fails("/dev/full", f"{program} small.off --depth 3 --csv /dev/full")
        fails("/dev/full", f"{program} small.off --depth 3 --output /dev/full")
    call = f"{program} small.off"
    for words, pattern in WRONG_CALLS_OF[call].items():
        fails(pattern, f"{call} {words}")


def limit_length_of_files():
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))


def limit_and_go_on():
    limit_length_of_files()
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)


def test_whole_files():
    """Of a program that is killed while it writes, and on a disk that is full: a limit of the length of files
    does both."""
    write_off("ball.off", *sphere(12))  # with tables of more than 20 kB
    for file in ("whole.csv", "whole.ply", "whole.obj"):
        option = "--csv" if file == "whole.csv" else "--output"
        solve = f"solve_poisson ball.off --depth 3 --quiet {option} "
        killed = subprocess.run(arguments(solve + f"killed_{file}"), env=ENVIRONMENT, stdin=subprocess.DEVNULL,
                                capture_output=True, preexec_fn=limit_length_of_files, restore_signals=True)
        assert killed.returncode < 0, file
        assert not os.path.exists(f"killed_{file}"), "a part is taken for the whole"
        pathlib.Path(file).write_text("old")
        full = run(solve + file, preexec_fn=limit_and_go_on, restore_signals=False)
        assert f"cannot write '{file}'" in full.err
        assert pathlib.Path(file).read_text() == "old"
        assert not os.path.exists(f"{file}.part")
        succeeds(solve + file)
        assert os.path.getsize(file) > 4096 and not os.path.exists(f"{file}.part")
    # a link remains one, and so do permissions
    os.mkdir("elsewhere")
    table = pathlib.Path("elsewhere/table.csv")
    table.write_text("old")
    table.chmod(0o640)
    os.symlink(table, "link.csv")
    succeeds("solve_poisson ball.off --depth 3 --csv link.csv")
    assert os.path.islink("link.csv") and table.read_text() != "old"
    assert table.stat().st_mode & 0o777 == 0o640


WITHOUT_EFFECT = {
    "geodesic_distance sphere.off --source 0 --isolines 5": "isolines has no effect without --lines or --html",
    "geodesic_distance sphere.off --source 0 --show nearest": "show has no effect without --output",
    "estimate_curvature sphere.off --show gaussian": "show has no effect without --output",
    "estimate_curvature sphere.off --clip 90": "clip has no effect without --output",
    "laplace_spectrum sphere.off --eigenfunction 2": "eigenfunction has no effect without --output",
    "laplace_spectrum sphere.off --operator cotangent --depth 4": "depth has no effect without --operator restricted",
    "laplace_spectrum sphere.off --eigensolver shift-invert --tolerance 0.1":
        "tolerance has no effect without --eigensolver",
    "solve_poisson sphere.off --crease-angle 20": "crease-angle has no effect without --geometry smooth",
    "solve_poisson sphere.off --join 0.1 --no-split": "joining-tolerance has no effect without split",
    "spectral_descriptors sphere.off --columns 5 --time 0.1": "columns has no effect without all times",
    "stitch_colors mesh.ply mesh.ply --poses p --method chosen --alpha 2":
        "alpha has no effect without --method gradients",
    "solve_poisson sphere.off --quiet --verbose": "quiet excludes",
    "geodesic_distance sphere.off --source -1": "argument -1 of --source",
    "geodesic_distance sphere.off --source 0 --path -7": "argument -7 of --path",
    "geodesic_distance sphere.off --farthest -2": "argument -2 of --farthest",
}


def test_files_and_options():
    """Files that are read stay, options that have no effect are refused, and outputs may go to the standard
    output, where then nothing else is."""
    write_off("sphere.off", *sphere(12))
    succeeds("solve_poisson sphere.off --depth 4 --output mesh.ply")
    before = pathlib.Path("mesh.ply").read_bytes()
    pathlib.Path("before.ply").write_bytes(before)
    os.mkdir("folder")
    os.symlink("../mesh.ply", "folder/link.ply")
    for name in ("mesh.ply", "./folder/../mesh.ply", "folder/link.ply", os.path.abspath("mesh.ply")):
        fails("is read, and --output would replace it.*--overwrite", f"solve_poisson mesh.ply --depth 4 --output {name}")
    fails("is read, and --csv would", "estimate_curvature mesh.ply --depth 4 --csv mesh.ply")
    pathlib.Path("lines.obj").write_bytes(pathlib.Path("sphere.off").read_bytes())
    fails("is read, and --lines would", "geodesic_distance lines.obj --source 0 --path 3 --lines lines.obj")
    assert pathlib.Path("mesh.ply").read_bytes() == before
    succeeds("solve_poisson mesh.ply --depth 4 --output folder/link.ply --overwrite --rhs x")
    assert pathlib.Path("mesh.ply").read_bytes() != before and os.path.islink("folder/link.ply")
    succeeds("bake_scans before.ply scans --views 2 --resolution 32")
    fails("truth.ply' is read, and FOLDER would replace it", "bake_scans scans/truth.ply scans --views 2")

    solve = "solve_poisson sphere.off --depth 4"
    succeeds(f"{solve} --csv table.csv")
    rows = Table("table.csv").rows

    def has_rows(text):
        pathlib.Path("out.csv").write_text(text)
        return Table("out.csv").rows == rows
    with open("redirected", "wb") as out:
        assert run(f"{solve} --csv /dev/stdout", stdout=out).err == ""
    assert has_rows(pathlib.Path("redirected").read_text()), "a table, and nothing else"
    assert has_rows(succeeds(f"{solve} --csv /dev/stdout").out), "through a pipe, too"
    result = run(f"{solve} --csv /dev/stderr")
    assert has_rows(result.err), "on the error stream"
    assert re.search("^maximum", result.out, re.M), "beside what is printed"
    assert succeeds(f"{solve} --output /dev/stdout").bytes == before
    lines = succeeds("geodesic_distance sphere.off --source 0 --path 5 --lines /dev/stdout").out.splitlines()
    assert any(line.startswith("v ") for line in lines) and all(line[:2] in ("v ", "l ") for line in lines)
    fails("name the same file", f"{solve} --csv /dev/stdout --output /dev/stdout")
    for call, pattern in WITHOUT_EFFECT.items():
        fails(pattern, call)


def test_memory():
    write_off("ball.off", *sphere(12))
    fails("--depth is 16, which would take about .* GB of memory, and .* GB are there; a depth of",
          "solve_poisson ball.off --depth 16")
    fails("--depth is 7, which would take about 4.. MB of memory, and 100 MB are there; a depth of 5",
          "laplace_spectrum ball.off --depth 7 --maximum-memory 0.1")
    succeeds("solve_poisson ball.off --depth 6 --maximum-memory 0.2")
    fails("memory must be a positive number", "solve_poisson ball.off --maximum-memory 0")


def is_picture(file):
    data = pathlib.Path(file).read_bytes()
    return data[:8] == b"\x89PNG\r\n\x1a\n" and len(data) > 10000


def width(file):
    return int.from_bytes(pathlib.Path(file).read_bytes()[16:20], "big")


def test_pictures(draw_mesh):
    succeeds("solve_poisson sphere.off --depth 3 --output u.ply")
    succeeds("draw_mesh u.ply u.png")
    assert is_picture("u.png")
    for option in ("--isolines 10", "--up z", "--size 500", "--property red", "--view 1,0,0", "--property value",
                   "--property value --no-legend", "--property value --range -1,1"):
        succeeds(f"draw_mesh u.ply other.png {option}")
        assert is_picture("other.png"), option
        assert pathlib.Path("other.png").read_bytes() != pathlib.Path("u.png").read_bytes(), option
    succeeds("draw_mesh u.ply with.png --property value")
    succeeds("draw_mesh u.ply without.png --property value --no-legend")
    assert width("without.png") < width("with.png"), "the legend is beside the mesh"
    for view in ("0,0,1", "0,1,0", "0,-3,0", "1e-9,1,0"):
        succeeds(f"draw_mesh u.ply other.png --view {view}")
        assert is_picture("other.png"), view
    succeeds("draw_mesh sphere.off gray.png")
    assert is_picture("gray.png")
    from conftest import moebius_strip, write_xyz
    write_xyz("points.xyz", SPHERE[0], SPHERE[0])
    succeeds("solve_poisson points.xyz --depth 2 --output points.ply")
    succeeds("draw_mesh points.ply points.png --isolines 5")
    assert is_picture("points.png")
    write_off("moebius.off", *moebius_strip(60))
    succeeds("estimate_curvature moebius.off --depth 4 --output moebius.ply")
    succeeds("draw_mesh moebius.ply moebius.png --property gaussian --isolines 3")
    assert is_picture("moebius.png")
    for words, pattern in {
            "": "no mesh", "u.ply": "no picture", "missing.ply x.png": "missing.ply",
            "sphere.off x.png --isolines 3": "value", "u.ply x.png --property height": "height",
            "u.ply x.png --isolines -1": "isolines", "u.ply x.png --up x": "up", "u.ply x.png --size 1": "size",
            "missing.ply nowhere/x.png": "nowhere/x.png' of PICTURE", "missing.ply x.jpg": "x.jpg' of PICTURE.*: .png",
            "u.ply x.png --view 1,0": "view", "u.ply x.png --view 1,y,0": "'y' in the argument of --view",
            "u.ply x.png --view 0,0,0": "view", "u.ply x.png --range 0,1": "range needs --property",
            "u.ply x.png --property value --range 1,0": "range"}.items():
        fails(pattern, f"draw_mesh {words}")


def number_of_fields(page):
    return len(re.findall(r'"kind":"[a-z]*"', pathlib.Path(page).read_text()))


def test_pages():
    """What pages look like is tested in a browser, see viewer/tests."""
    if not HAS_VIEWER:
        fails("Node.js", "solve_poisson small.off --depth 3 --html page.html")
        pytest.skip("SKIPPED: this build has no viewer")
    succeeds("solve_poisson small.off --depth 3 --html page.html")
    page = pathlib.Path("page.html").read_text()
    assert " src=" not in page and "@import" not in page, "it is one file without a network"
    assert '"title":"solve_poisson small.off"' in page
    assert number_of_fields("page.html") == 1
    succeeds("solve_poisson small.off --depth 3 --html again.html --threads 1")
    assert pathlib.Path("again.html").read_text() == page
    succeeds("solve_poisson small.off --depth 3 --refine 2 --html fine.html")
    assert re.search(r'"faces":\d{4}', pathlib.Path("fine.html").read_text())
    for call, fields in {
            "laplace_spectrum small.off --depth 3 --count 7": 7,
            "laplace_spectrum small.off --operator cotangent --count 7": 7,
            "spectral_descriptors small.off --depth 3 --count 9 --columns 5 --refine 1": 5,
            "estimate_curvature small.off --depth 3": 2, "geodesic_distance small.off --source 0": 2,
            "fit_function small.off --property x,y --depth 3 --output xy.ply": 2}.items():
        succeeds(f"{call} --html page.html")
        assert number_of_fields("page.html") == fields, call
    name = '<b>&"small".off'
    pathlib.Path(name).write_bytes(pathlib.Path("small.off").read_bytes())
    succeeds(["solve_poisson", name, "--depth", "3", "--html", "page.html"])
    assert "<b>" not in pathlib.Path("page.html").read_text(), "a name is no markup"
    if HAS_DRAW_MESH:
        succeeds("draw_mesh xy.ply page.html")
        assert number_of_fields("page.html") == 3
        succeeds("draw_mesh xy.ply pair.html --property fit_y --range -1,1 --beside xy.ply")
        assert number_of_fields("pair.html") == 6
        fails("fit_y", "draw_mesh xy.ply pair.html --property fit_y --beside small.off")
        fails("beside needs a page", "draw_mesh xy.ply x.png --beside small.off")
        fails("size needs a PNG", "draw_mesh xy.ply x.html --size 200")
    fails("html.*no format", "solve_poisson small.off --depth 3 --html page.png")
    fails("nowhere/x.html", "solve_poisson small.off --depth 3 --html nowhere/x.html")
    assert not os.path.exists("nowhere")
    fails("html need a descriptor", "spectral_descriptors small.off --descriptor shape-dna --html x.html")

# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""What the programs compute: solutions that are known, on spheres and small surfaces."""

import os
import pathlib
import re

import numpy as np
import pytest
from conftest import (SMALL, SPHERE, Table, fails, largest_difference, moebius_strip, read_points, run, sphere,
                      succeeds, surface_mean, write_off, write_xyz)
from test_interface import write_binary_ply


def is_within(values, low, high):
    return len(values) > 0 and (np.asarray(values) >= low).all() and (np.asarray(values) <= high).all()


def header_of(file):
    return pathlib.Path(file).read_bytes().split(b"end_header")[0].decode().splitlines()


def header_of_png(file):
    return pathlib.Path(file).read_bytes()[:24]


def test_poisson_table():
    result = succeeds("solve_poisson sphere.off --depth 4 --csv table.csv")
    for name in ("vertices", "faces", "depth", "dimension", "area", "components", "seconds"):
        result.entry(name)
    assert not re.search("sheets|iterations|residual|threads", result.out), "prints no details"
    for name, value in (("minimum", -0.5), ("maximum", 0.5), ("mean", 0)):
        assert result.entry(name) == pytest.approx(value, abs=0.01)
    table = Table("table.csv")
    table.check("vertex,value")
    table.check_numbers("vertices faces depth dimension cells sheets split_elements components kernel_dimension area "
                        "setup_seconds assembly_seconds solve_seconds iterations relative_residual")
    assert (table.comment("vertices"), table.comment("faces"), table.comment("depth")) == (1026, 2048, 4)
    assert table.comment("area") == pytest.approx(12.53, abs=0.03), "of the polyhedron"
    assert len(table.rows) == 1026
    assert sum(len(re.sub("[-.]", "", row.split(",")[1])) for row in table.rows) > 15390, "16 or more digits"
    assert succeeds("solve_poisson sphere.off --depth 4 --quiet").out == ""
    result = run("solve_poisson sphere.off --depth 4 --verbose")
    for name in ("sheets", "iterations", "residual", "threads", "assembly_seconds"):
        assert name in result.out
    progress = run("solve_poisson sphere.off --depth 4 --progress").err
    assert re.search(r"^solving for \d+ unknowns: \d+ %, \d+ s left$", progress, re.M)
    assert re.search(r"^solving for \d+ unknowns: 100 %, 0 s left$", progress, re.M)


def test_poisson_solution():
    """The coordinates are eigenfunctions of the sphere: Laplacian x = -2 x."""
    solve = "solve_poisson {} --depth 4 --rhs {} --tolerance 1e-6 --csv u.csv"
    for axis in "xyz":
        succeeds(solve.format("sphere.off", axis))
        assert largest_difference("u.csv", axis, -0.5) < 5e-3
    # 4 pi / area u - Laplacian u = z has the solution z / 3, up to the area of the polyhedron
    screened = solve + " --alpha 12.566"
    succeeds(screened.format("sphere.off", "z"))
    assert largest_difference("u.csv", "z", 0.3333333) < 5e-3
    # alpha has the unit 1 / area, so u scales with the square of the length and with f
    write_off("large.off", 100 * SPHERE[0], SPHERE[1])
    succeeds(screened.format("large.off", "z"))
    assert largest_difference("u.csv", "z", 333333.3) < 5e3
    # the mean of f does not matter
    write_off("shifted.off", SPHERE[0] + [0, 0, 5], SPHERE[1])
    succeeds(solve.format("shifted.off", "z"))
    assert largest_difference("u.csv", "z", -0.5) < 5e-3
    succeeds(screened.format("shifted.off", "z"))
    assert largest_difference("u.csv", "z", 0.3333333) < 5e-3

    def of_seed(seed):
        succeeds(f"solve_poisson small.off --depth 3 --rhs random --seed {seed} --tolerance 1e-6 --csv r.csv")
        return Table("r.csv")[1]
    five = of_seed(5)
    assert surface_mean(*SMALL, five) == pytest.approx(0, abs=1e-3)
    assert (of_seed(5) == five).all() and not (of_seed(6) == five).all()
    assert len(set(five)) > 50, "a random right-hand side is not zero"


def test_poisson_options():
    def solve(options, bound=5e-3, depth=4):
        succeeds(f"solve_poisson sphere.off --depth {depth} {options} --csv u.csv")
        if bound:
            assert largest_difference("u.csv", "z", -0.5) < bound, options
        return Table("u.csv")
    reference = solve("--tolerance 1e-6", None)
    solve("--tolerance 1e-6 --cycle w")
    assert solve("--tolerance 1e-6 --cube-scale 1.3").comment("dimension") != reference.comment("dimension")
    assert solve("--smoother point --tolerance 1e-6").comment("iterations") > reference.comment("iterations")
    solve("--stabilization 0 --tolerance 1e-4")
    fails("stabilization", "solve_poisson sphere.off --stabilization -1")
    one, two = solve("--threads 1", None), solve("--threads 2", None)
    assert one.rows == two.rows and len(one.rows) == 1026
    # 504 elements at depth 3: Table 1 of the paper
    assert solve("--paper", None, 3).comment("dimension") == 504
    assert solve("--no-split", None, 3).comment("dimension") == 816
    # The support of an element may contain several pieces of the sphere, at its corners. The number is our own
    # output.
    default = solve("", None, 3)
    assert default.comment("dimension") == 864
    assert solve("--assembly monte-carlo --samples 200000", 5e-2, 3).rows != default.rows
    loose = solve("--tolerance 1e-2", None)
    assert loose.comment("iterations") < reference.comment("iterations")
    assert reference.comment("relative_residual") < loose.comment("relative_residual")
    assert reference.comment("relative_residual") < 1.0001e-6
    # the residual cannot become as small as that in double precision
    result = fails("converge: the iteration stalled",
                   "solve_poisson small.off --depth 3 --tolerance 1e-60 --csv s.csv --output s.ply")
    assert result.status == 2
    assert pathlib.Path("s.csv").stat().st_size > 0 and pathlib.Path("s.ply").stat().st_size > 0


def test_mesh_output():
    succeeds("solve_poisson sphere.off --depth 3 --tolerance 1e-6 --output u.ply --csv u.csv")
    header = header_of("u.ply")
    for line in ("format binary_little_endian 1.0", "element vertex 1026", "element face 2048", "property uchar red",
                 "property uchar green", "property uchar blue", "property double value"):
        assert line in header
    # the mesh and its property can be read again, in the same order
    succeeds("solve_poisson u.ply --depth 3 --rhs z --tolerance 1e-6 --csv again.csv")
    assert np.abs(Table("u.csv")[1] - Table("again.csv")[1]).max() < 1e-6
    succeeds("solve_poisson u.ply --depth 3 --rhs-property value --tolerance 1e-6 --csv twice.csv")
    assert largest_difference("twice.csv", "z", 0.25) < 5e-3
    succeeds("solve_poisson u.ply --depth 3 --rhs-property red --csv red.csv")
    assert len(set(Table("red.csv")[1])) > 50, "a property of type uchar"
    fails("height", "solve_poisson u.ply --depth 3 --rhs-property height")
    fails("height", "solve_poisson u.ply --depth 3 --boundary-property height")
    fails("no part of a boundary", "solve_poisson u.ply --depth 3 --boundary-property value")
    succeeds("solve_poisson sphere.off --depth 3 --output u.obj")
    obj = pathlib.Path("u.obj").read_text()
    assert len(re.findall(r"^v( [^ \n]+){6}$", obj, re.M)) == 1026, "an obj file has colors"
    assert len(re.findall(r"^f( \d+){3}$", obj, re.M)) == 2048
    succeeds("solve_poisson u.obj --depth 3 --csv again.csv")
    assert Table("again.csv").comment("vertices") == 1026


def test_boundary_conditions():
    """A square with values of 0 and 2 on the sides x = 0 and x = 1, free between them, and with a flux of 2
    through the second one."""
    nan = float("nan")
    rows = [row for y in (0, 1) for row in ([0, y, 0, 0, 0], [0.5, y, 0, nan, 0], [1, y, 0, 2, 2])]
    write_binary_ply("square.ply", rows, [[0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 5, 4]], ("value", "flux"))

    def solve(options):
        succeeds(f"solve_poisson square.ply --depth 4 --rhs z {options} --csv u.csv")
        return Table("u.csv")[1]
    for data in ("linear", "smooth"):
        u = solve(f"--boundary-property value --vertex-data {data}")
        assert np.abs(u - [0, 1, 2, 0, 1, 2]).max() < 1e-5, data
    # what is prescribed is of the order of 1, and with a screening weight it decays inward
    u = solve("--boundary-property value --alpha 3")
    assert u[1] < 0.75 and (u[2] - 2) ** 2 < 1e-3
    assert solve("--flux-property flux")[2] > 0.3
    fails("flux", "solve_poisson small.off --flux-property flux")


def test_material():
    """A sphere whose material is constant, as numbers and as matrices."""
    points, faces = sphere(8)
    names = ("half", "four", "d_xx", "d_yy", "d_zz", "d_xy", "d_xz", "d_yz", "bad")
    rows = [[*p, 0.5, 4, 4, 4, 4, 0, 0, 0, 1 if i != 5 else -1] for i, p in enumerate(points)]
    write_binary_ply("material.ply", rows, faces, names)
    plain = "laplace_spectrum material.ply --depth 3 --count 5 --csv s.csv"
    succeeds(plain)
    expected = np.array(Table("s.csv")[1])[1:]
    for diffusion in ("four", "d"):
        succeeds(f"{plain} --diffusion-property {diffusion} --density-property half --overwrite")
        assert np.array(Table("s.csv")[1])[1:] == pytest.approx(8 * expected, rel=1e-5)
    succeeds("solve_poisson material.ply --depth 3 --rhs z --csv u.csv")
    u = np.array(Table("u.csv")[1])
    succeeds("solve_poisson material.ply --depth 3 --rhs z --csv u.csv --diffusion-property d")
    assert np.array(Table("u.csv")[1]) == pytest.approx(u / 4, abs=1e-4)
    fails("density.*not positive.*face", "solve_poisson material.ply --depth 3 --rhs z --density-property bad")
    fails("no vertex property 'e'", f"{plain} --diffusion-property e --overwrite")
    fails("restricted", f"{plain} --operator cotangent --density-property half --overwrite")
    # the curvature of the unit sphere is 1
    succeeds(f"{plain} --anisotropy 0.7 --overwrite")
    assert np.array(Table("s.csv")[1])[1:] == pytest.approx(np.exp(-0.7) * expected, rel=0.05)
    fails("anisotropy", f"{plain} --anisotropy -1 --overwrite")
    fails("anisotropy.*not both", f"{plain} --anisotropy 1 --diffusion-property four --overwrite")
    fails("anisotropy.*depth", "solve_poisson material.ply --accuracy 0.1 --anisotropy 1")


def test_diffusion():
    """Harmonics of a sphere decay by exp(-l (l + 1) t); holes, materials, sources, boundaries."""
    def values(options, mesh="sphere.off"):
        succeeds(f"diffuse {mesh} --depth 4 {options} --csv u.csv")
        return Table("u.csv")
    table = values("--property z --time 0.5 --tolerance 1e-6 --output u.ply")
    table.check("vertex,value")
    table.check_numbers("setup_seconds assembly_seconds solve_seconds iterations relative_residual time")
    assert largest_difference("u.csv", "z", np.exp(-1)) < 2e-3 and "property double value" in header_of("u.ply")
    width = np.sqrt(8 * np.log(2))  # of a time of a half
    assert values(f"--property z --fwhm {width} --tolerance 1e-6")[1] == pytest.approx(table[1], abs=1e-9)
    both = values("--property x,z --time 0.5 --tolerance 1e-6")
    assert both.columns == ["vertex", "value_x", "value_z"] and both[2] == pytest.approx(table[1], abs=1e-5)

    points, faces = SPHERE
    hole = [np.nan if p[2] > 0.8 else 3 for p in points]
    rows = [[*p, 2, one, 1] for p, one in zip(points, hole)]
    write_binary_ply("data.ply", rows, faces, ("two", "hole", "one"))
    u = values("--property hole --fwhm 0.3", "data.ply")[1]
    assert (np.isnan(u) == np.isnan(hole)).all() and np.nanmax(abs(u - 3)) < 1e-3, "a constant remains"
    assert values("--property z --time 0.5 --density-property two --tolerance 1e-6", "data.ply")[1] == pytest.approx(
        np.exp(-0.5) * points[:, 2], abs=3e-3)
    assert values("--property one --time 0.5 --source-property two", "data.ply")[1] == pytest.approx(2, abs=1e-6)
    write_binary_ply("square.ply", [[x, y, 0, x, 0] for x in (0, 1) for y in (0, 1)], [[0, 1, 3], [0, 3, 2]],
                     ("v", "zero"))
    u = values("--property zero --time 10 --boundary-property v", "square.ply")[1]
    assert u == pytest.approx([0, 0, 1, 1], abs=1e-3), "to the harmonic function"
    for words, pattern in {
            "--time 1": "--property", "--property x": "--time or --fwhm", "--property x --time 1 --fwhm 1": "not both",
            "--property x --time 0": "time.*positive", "--property x --fwhm nan": "fwhm.*positive",
            "--property x --time 1 --tolerance 1": "tolerance", "--property height --time 1": "height",
            "--property hole --time 1 --source-property two": "NaN.*source",
            "--property x --time 1 --stabilization -1": "stabilization"}.items():
        fails(pattern, f"diffuse data.ply {words}")
    fails("boundary", "diffuse data.ply --property x --time 1 --boundary-property two")


def test_flow():
    """Spheres shrink as sqrt(1 - 4 t), or remain if their area is kept."""
    def radii(options, mesh="sphere.off"):
        result = succeeds(f"flow_surface {mesh} --depth 3 {options} --csv p.csv --output p.ply")
        table = Table("p.csv")
        table.check("vertex,x,y,z")
        assert table.comment("steps") == result.entry("steps")
        assert table.comment("time") == pytest.approx(result.entry("time"))
        return np.linalg.norm(table.values[:, 1:], axis=1)
    first = np.linalg.norm(SPHERE[0], axis=1)
    assert radii("--steps 20 --time-step 0.005") == pytest.approx(np.sqrt(1 - 0.4) * first, abs=0.01)
    assert "property double displacement" in header_of("p.ply")
    os.rename("p.ply", "moved.ply")
    assert radii("--steps 1 --time-step 0.01", "moved.ply").mean() < 0.78, "the moved mesh is written"
    assert radii("--steps 3 --time-step 0.1 --conformal") == pytest.approx(first, abs=5e-3)
    assert radii("--steps 3 --time-step 0.01 --rescaling volume") == pytest.approx(first, abs=5e-3)
    write_off("egg.off", SPHERE[0] * [1.5, 1, 0.8], SPHERE[1])
    result = succeeds("flow_surface egg.off --depth 3 --steps 30 --time-step 0.2 --conformal")
    assert result.entry("sphere_deviation") < 3e-3 and result.entry("mean_distortion") < 1.01
    result = run("flow_surface sphere.off --depth 3 --steps 100 --time-step 0.01 --csv p.csv")
    assert result.status == 2 and re.search("after [0-9]+ steps.*collapses near face", result.err), result
    assert Table("p.csv").comment("time") < 0.35 and np.isfinite(Table("p.csv").values).all()
    succeeds("flow_surface sphere.off --depth 3 --steps 50 --time-step 0.001 --pictures sphere_ --html p.html")
    pictures = sorted(str(p) for p in pathlib.Path().glob("sphere_*.png"))
    assert len(pictures) == 18 and pictures[0] == "sphere_00.png" and pictures[-1] == "sphere_50.png", pictures
    assert len({header_of_png(p) for p in pictures}) == 1, "all of one size"
    scene = pathlib.Path("p.html").read_text(encoding="utf-8")
    assert len(re.findall(r'"displacement, step \d+, time [0-9.e-]+"', scene)) == 18
    for words, pattern in {
            "": "time-step", "--time-step 0": "time-step.*positive", "--time-step nan": "time-step.*positive",
            "--time-step 1 --steps 0": "steps.*positive", "--time-step 1 --rescaling x": "rescaling",
            "--time-step 1 --tolerance 2": "tolerance"}.items():
        fails(pattern, f"flow_surface sphere.off {words}")


def test_editing():
    """A sphere shrinks by its eigenvalue, noise goes, and creases stay."""
    def edited(options, mesh="sphere.off"):
        succeeds(f"edit_surface {mesh} {options} --csv e.csv --output e.ply")
        table = Table("e.csv")
        table.check("vertex,x,y,z")
        return table.values[:, 1:]
    points, faces = SPHERE
    first = np.linalg.norm(points, axis=1)
    for scale in (0, 1, 3):
        found = np.linalg.norm(edited(f"--depth 4 --gradient-scale {scale} --alpha 10"), axis=1)
        assert found == pytest.approx((10 + 2 * scale) / 12 * first, abs=0.01)
    assert "property double displacement" in header_of("e.ply")
    write_binary_ply("strokes.ply", np.column_stack([points, 1 + 2 * (points[:, 2] > 0)]), faces, ("strokes",))
    moved = np.linalg.norm(edited("--depth 4 --gradient-scale-property strokes --alpha 100", "strokes.ply"), axis=1)
    assert moved[points[:, 2] > 0.6] == pytest.approx(106 / 102, abs=0.01), "the larger factor there"
    assert moved[points[:, 2] < -0.6] == pytest.approx(1, abs=0.01), "and nothing here"
    noise = 1 + 0.02 * np.random.default_rng(3).standard_normal((len(points), 1))
    write_off("noisy.off", points * noise, faces)

    def roughness(x):
        return np.std(np.linalg.norm(x, axis=1))
    rough = roughness(points * noise)
    assert roughness(edited("--length 1", "noisy.off")) < 0.4 * rough
    assert roughness(edited("--length 1 --crease-angle 90", "noisy.off")) < 0.6 * rough
    assert roughness(edited("--length 1 --factor 2", "noisy.off")) > 1.6 * rough
    isotropic, anisotropic = (edited(f"--depth 4 --gradient-scale 0 --alpha 10 --anisotropic {f}") for f in (0, 5))
    assert np.linalg.norm(anisotropic, axis=1).mean() > np.linalg.norm(isotropic, axis=1).mean() + 0.05
    for words, pattern in {
            "": "gradient-scale", "--gradient-scale 1": "alpha",
            "--gradient-scale 1 --alpha 1 --gradient-scale-property x": "not both",
            "--gradient-scale-property nothing --alpha 1": "nothing",
            "--gradient-scale-property x --length 1": "either", "--gradient-scale 1 --alpha 0": "alpha.*positive",
            "--gradient-scale nan --alpha 1": "gradient-scale", "--length 0": "length.*positive",
            "--length 1 --alpha 1": "alpha", "--length 1 --factor inf": "factor",
            "--length 1 --factor 2 --crease-angle 30": "exclude", "--gradient-scale 1 --alpha 1 --anisotropic -1":
            "anisotropic", "--length 1 --tolerance 2": "tolerance",
            "--gradient-scale 1 --alpha 1 --crease-angle 30": "crease-angle"}.items():
        fails(pattern, f"edit_surface sphere.off {words}")


def test_refinement():
    succeeds("fit_function small.off --property z --depth 3 --refine 4 --output fine.ply")
    succeeds("fit_function fine.ply --property z,fit_z --depth 3 --csv fine.csv")
    succeeds("fit_function small.off --property z --depth 3 --csv z.csv")
    fine = Table("fine.csv")
    assert fine.comment("faces") > 5000 and fine.comment("components") == 1
    assert fine.comment("area") == pytest.approx(Table("z.csv").comment("area"), abs=1e-9)
    assert np.abs(fine[1] - fine[2]).max() < 1e-5, "the fit of z is z, everywhere"
    # an eigenfunction of degree 2 has a larger range than its values at a few vertices
    write_off("octahedron.off", *sphere(1))
    succeeds("laplace_spectrum octahedron.off --depth 4 --count 6 --eigenfunction 5 --output five.ply --refine 2")
    succeeds("fit_function five.ply --property value --depth 4 --csv five.csv")
    assert len({str(x)[:5] for x in Table("five.csv")[1]}) > 50
    for program in ("estimate_curvature", "spectral_descriptors"):
        succeeds(f"{program} small.off --depth 3 --refine 1 --output fine.ply")
        assert succeeds("solve_poisson fine.ply --depth 3 --rhs x").entry("faces") > 200, program
    fails("refine.*restricted", "laplace_spectrum small.off --operator cotangent --refine 2 --output fine.ply")


def test_accuracy():
    spectrum = "laplace_spectrum sphere.off --count 36 --accuracy"
    depths, errors = [], []
    for accuracy in ("0.1", "0.0003"):
        result = succeeds(f"{spectrum} {accuracy} --csv s.csv")
        table = Table("s.csv")
        assert table.comment("estimated_relative_error") <= float(accuracy)
        depths.append(table.comment("depth"))
        errors.append(table[1][35])  # of degree 5, and not below 30 but for the facets
        assert result.entry("depth") == depths[-1] and result.entry("dimension") == table.comment("dimension")
    assert depths[0] < depths[1] and errors[0] > errors[1]
    succeeds("solve_poisson sphere.off --accuracy 0.01 --csv u.csv --output u.ply --refine 2")
    assert Table("u.csv").comment("estimated_relative_error") <= 0.01 and Table("u.csv").comment("depth") > 2
    succeeds("spectral_descriptors sphere.off --count 36 --descriptor shape-dna --accuracy 0.0003 --csv d.csv")
    assert Table("d.csv").comment("depth") == depths[1]
    result = run("solve_poisson sphere.off --accuracy 1e-9 --maximum-memory 0.05 --csv u.csv")
    assert result.status == 2 and re.search("accura", result.err), result
    result = run(f"{spectrum} 1e-9 --maximum-memory 0.05")
    assert result.status == 2 and re.search("estimated error of", result.err), result
    for number, command in enumerate(("fit_function sphere.off --property x,y,z --accuracy 1e-3",
                                      "fit_function sphere.off --property x --smoothing 1 --accuracy 1e-2",
                                      "estimate_curvature sphere.off --accuracy 0.3 --method face-normals")):
        found = run(f"{command} --csv f.csv")
        assert Table("f.csv").comment("depth") >= 4, command
        assert (found.status == 0) == (number < 2), command  # the sphere's curvature is that of its edges
        assert found.status == 2 or Table("f.csv").comment("estimated_relative_error") <= 1e-2, command
    fails("smoothing", "estimate_curvature sphere.off --accuracy 0.1 --smoothing 1")
    for options in ("0.1 --paper", "0.1 --assembly monte-carlo", "0", "2"):
        fails("accuracy", f"solve_poisson sphere.off --accuracy {options}")
    fails("accuracy.*restricted", f"{spectrum} 0.1 --operator cotangent")


def has_sphere_spectrum(values, tolerance):
    """l (l + 1), 2 l + 1 times, up to a relative error."""
    degrees = np.floor(np.sqrt(np.arange(len(values))))
    exact = degrees * (degrees + 1)
    return (np.abs(values - exact) <= tolerance * np.maximum(exact, 1e-3)).all() and (np.diff(values) >= 0).all()


def test_spectrum():
    spectrum = "laplace_spectrum sphere.off --depth 4 --count 16"
    result = succeeds(f"{spectrum} --csv s.csv --output s.ply")
    table = Table("s.csv")
    table.check("index,eigenvalue,estimated_relative_error,extrapolated")
    assert len(table.rows) == 16 and has_sphere_spectrum(table[1], 1e-2)
    assert table.comment("estimated_relative_error") == pytest.approx(table[2].max()) and table[2].min() == 0
    assert 0 < table[2].max() < 1e-2 and re.search(r"estimated_relative_error *\d", result.out)
    assert has_sphere_spectrum(np.sort(table[3]), 1e-2) and (table[3][1:] != table[1][1:]).any()
    table.check_numbers("vertices faces depth dimension cells sheets split_elements components area assembly_seconds "
                        "solve_seconds")
    assert re.search(r"[^0-9]2\.0", result.out), "prints the eigenvalues"
    assert "property double value" in header_of("s.ply")

    # both eigensolvers find the same, and the parameters of multigrid matter
    values = {}
    for solver, options in (("multigrid", "--tolerance 1e-6"), ("shift-invert", "")):
        succeeds(f"{spectrum} --eigensolver {solver} {options} --csv {solver}.csv")
        values[solver] = Table(f"{solver}.csv")[1]
        assert has_sphere_spectrum(values[solver], 1e-2), solver
    assert np.abs(values["multigrid"] - values["shift-invert"]).max() < 1e-7
    assert Table("multigrid.csv").comment("relative_residual") <= 1e-6
    succeeds(f"{spectrum} --stabilization 0.1 --csv strong.csv")
    assert (Table("strong.csv")[1] != values["shift-invert"]).any()

    for mass in ("--lumped-mass", ""):
        succeeds(f"laplace_spectrum sphere.off --operator cotangent {mass} --count 16 --csv c{mass}.csv")
        assert has_sphere_spectrum(Table(f"c{mass}.csv")[1], 3e-2), mass
        assert Table(f"c{mass}.csv").comment("dimension") == 1026
        assert Table(f"c{mass}.csv").columns == ["index", "eigenvalue"]
    assert (Table("c.csv")[1] != Table("c--lumped-mass.csv")[1]).any()

    # Eigenfunction 0 is constant. Eigenfunction 1 has mean square 1 / area, and the inverse Laplacian divides it by
    # 2, up to the sign: the squares at 1026 vertices sum to about 1026 / (4 area).
    succeeds("laplace_spectrum sphere.off --depth 3 --count 4 --eigenfunction 0 --output e0.ply")
    succeeds("laplace_spectrum sphere.off --depth 3 --count 4 --output e1.ply")
    for number, expected, tolerance in ((0, 0, 1e-10), (1, 20.5, 3)):
        succeeds(f"solve_poisson e{number}.ply --depth 3 --rhs-property value --tolerance 1e-6 --csv u.csv")
        assert (Table("u.csv")[1] ** 2).sum() == pytest.approx(expected, abs=tolerance), number


def test_descriptors():
    # All eigenfunctions of degree 0 .. 3 of the unit sphere, whose squares sum to (2 l + 1) / (4 pi).
    program = "spectral_descriptors sphere.off --depth 4 --count 16"
    succeeds(f"{program} --columns 5 --csv hks.csv --output hks.ply")
    table = Table("hks.csv")
    table.check_numbers("vertices faces depth dimension components area setup_seconds assembly_seconds solve_seconds "
                        "iterations relative_residual zero_eigenvalues columns smallest_value largest_value")
    assert table.comment("zero_eigenvalues") == 1
    assert re.fullmatch(r"vertex(,t=[\d.e-]+){5}", ",".join(table.columns))
    assert table.values.shape == (1026, 6)
    assert table.comments["column"] == table.columns[3], "the middle column is shown"
    assert table.comment("largest_value") == pytest.approx(table[3].max(), abs=1e-9)
    assert "property double value" in header_of("hks.ply")

    def rows(options):
        succeeds(f"{program} {options} --csv one.csv")
        return Table("one.csv")
    # exp(-l (l + 1) t) at t = 1, that is 1 / area = 0.0798 in units of the area of the polyhedron
    assert rows("--time 0.0798")[1] == pytest.approx(0.1131, abs=1e-3)
    assert rows("--time 0.0798 --scaled")[1] == pytest.approx(0.0798, abs=4e-4), "its integral is 1"
    wks = rows("--descriptor wks --columns 5")
    energies = [float(name[2:]) for name in wks.columns if name.startswith("e=")]
    assert len(energies) == 5 and is_within(energies, 3.2, 5.0), "logarithms of eigenvalues times area"
    assert wks[3] == pytest.approx(0.0798, abs=4e-4)
    assert rows("--descriptor wks --energy 4").columns == ["vertex", "e=4"]
    # the coordinates of a vertex have the square sum of (2 l + 1) / (4 pi) (l (l + 1))^-p
    gps, biharmonic = rows("--descriptor gps --column 3"), rows("--descriptor biharmonic")
    assert (gps.values[:, 1:] ** 2).sum(1) == pytest.approx(0.2321, abs=2e-3)
    assert (biharmonic.values[:, 1:] ** 2).sum(1) == pytest.approx(0.0746, abs=1e-3)
    assert gps.columns[:3] == ["vertex", "gps_1", "gps_2"], "zeros are left out"
    assert gps.comments["column"] == "gps_4"
    diffusion = rows("--descriptor diffusion")
    assert diffusion.columns[:2] == ["vertex", "diffusion_0"], "zeros are not left out"
    assert rows("--descriptor diffusion --time 0.1").rows != diffusion.rows

    # the spectrum of a sphere of the unit area
    dna = rows("--descriptor shape-dna --compare large_sphere.off")
    dna.check("index,shape_dna")
    assert dna[1][0] == 0 and dna[1][1:4] == pytest.approx(25.13, abs=0.1)
    assert dna.comment("distance") <= 1e-5, "it does not depend on size"
    for normalization, part, expected, tolerance in (("first", slice(1, 4), 1, 1e-2), ("none", slice(1, 4), 2, 1e-2),
                                                     ("weyl", slice(15, 16), 13.4, 1.5)):
        values = rows(f"--descriptor shape-dna --normalization {normalization}")[1]
        assert values[part] == pytest.approx(expected, abs=tolerance), normalization
    assert succeeds(f"{program} --quiet").out == ""


def test_fits():
    succeeds("fit_function sphere.off --property x,z --depth 3 --csv f.csv --output f.ply")
    table = Table("f.csv")
    assert table.columns == ["vertex", "fit_x", "fit_z"] and len(table.rows) == 1026
    table.check_numbers("vertices faces depth dimension area setup_seconds assembly_seconds solve_seconds iterations "
                        "relative_residual rms_error")
    assert largest_difference("f.csv", "x", 1) < 3e-6 and table.comment("rms_error") < 1e-6
    assert table.comment("relative_residual") < 1.0001e-8
    properties = [line for line in header_of("f.ply") if line.startswith("property double")]
    assert "property double fit_z" in properties and len(set(properties)) == len(properties)

    def fit(options, mesh="sphere.off"):
        succeeds(f"fit_function {mesh} {options} --depth 3 --csv g.csv")
        return Table("g.csv")
    assert fit("--property fit_z", "f.ply").columns == ["vertex", "fit_fit_z"]
    assert largest_difference("g.csv", "z", 1) < 1e-5
    assert fit("--normals").columns == ["vertex", "fit_nx", "fit_ny", "fit_nz"]
    assert largest_difference("g.csv", "x", 1) < 1e-2
    by_error = fit("--normals --tolerance 1e-13 --energy-tolerance 0.5")
    assert by_error.comment("relative_residual") > 1e-12, "fits end by their own error"
    by_residual = fit("--normals --tolerance 1e-12 --energy-tolerance 0 --stabilization 1e-4")
    assert by_residual.comment("relative_residual") < 1.0001e-12
    assert is_within(fit("--property z --smoothing 1e9")[1], -1e-4, 1e-4), "to the mean"
    fit("--property z --assembly monte-carlo")
    assert largest_difference("g.csv", "z", 1) < 1e-2
    for words, pattern in {
            "": "property", "--property x --normals": "both", "--property height": "height",
            "--property x --smoothing -1": "smoothing", "--property x --refinements -1": "refinements",
            "--property x --tolerance 0": "tolerance", "--property x --energy-tolerance -1": "energy-tolerance",
            "--property x --energy-tolerance 1": "energy-tolerance",
            "--property x --stabilization nan": "stabilization"}.items():
        fails(pattern, f"fit_function sphere.off {words}")
    fails("open", "fit_function missing.off --normals")


def test_geometry():
    """What the mesh and its values stand for: a sphere, and functions on it."""
    errors = {}
    for geometry in ("flat", "smooth"):
        for data in ("linear", "smooth"):
            succeeds(f"solve_poisson sphere.off --depth 5 --rhs z --tolerance 1e-8 --geometry {geometry} "
                     f"--vertex-data {data} --csv u.csv")
            errors[geometry, data] = largest_difference("u.csv", "z", -0.5)
    best = errors["smooth", "smooth"]
    assert best < 2e-5 and best < 0.03 * errors["flat", "linear"], errors
    assert best < 0.1 * errors["flat", "smooth"] and best < 0.03 * errors["smooth", "linear"], errors
    result = succeeds("solve_poisson sphere.off --depth 4 --geometry smooth --csv u.csv")
    assert Table("u.csv").comment("area") == pytest.approx(12.5663706, abs=1e-5)
    assert result.entry("folded") == "faces", "folded faces are counted"
    succeeds("solve_poisson sphere.off --depth 4 --geometry smooth --crease-angle 0 --csv u.csv")
    assert Table("u.csv").comment("area") < 12.56, "between creases faces are flat"
    for data in ("linear", "smooth"):
        succeeds(f"fit_function sphere.off --normals --depth 5 --geometry smooth --vertex-data {data} --csv {data}.csv")
    assert largest_difference("smooth.csv", "x", 1) < largest_difference("linear.csv", "x", 0.98)
    succeeds("fit_function sphere.off --property z --depth 5 --geometry smooth --vertex-data smooth --csv z.csv")
    assert largest_difference("z.csv", "z", 1) < 1e-4
    succeeds("laplace_spectrum sphere.off --depth 4 --count 4 --geometry smooth --tolerance 1e-5 --csv l.csv")
    assert is_within(Table("l.csv")[1][1:], 1.9998, 2.0002)
    fails("vertex-data", "solve_poisson sphere.off --vertex-data round")
    fails("geometry", "laplace_spectrum sphere.off --geometry round")
    fails("crease-angle", "solve_poisson sphere.off --geometry smooth --crease-angle 181")
    fails("unrecognised", "laplace_spectrum sphere.off --vertex-data smooth")


def test_curvature():
    def curvature(options, mesh="sphere.off"):
        result = succeeds(f"estimate_curvature {mesh} --depth 3 {options} --csv c.csv")
        return result, Table("c.csv")
    for method in ("normals", "face-normals", "coordinates"):
        result, table = curvature(f"--method {method} --output c.ply")
        assert table.columns == ["vertex", "mean", "gaussian"]
        assert is_within(table[1], 0.95, 1.05), method
        for line in ("property uchar red", "property double mean", "property double gaussian"):
            assert line in header_of("c.ply"), method
        assert is_within([result.entry("mean_minimum"), result.entry("mean_maximum")], 0.95, 1.05), method
        assert table.comment("iterations") < 15.5, method
        if method == "coordinates":
            assert np.isnan(table[2]).all(), "coordinates give no Gaussian curvature"
        else:
            assert is_within(table[2], 0.9, 1.1), method
            assert is_within([result.entry("gaussian_minimum"), result.entry("gaussian_maximum")], 0.9, 1.1), method
    write_off("inward.off", SPHERE[0], SPHERE[1][:, [0, 2, 1]])
    table = curvature("", "inward.off")[1]
    assert is_within(table[1], -1.05, -0.95) and is_within(table[2], 0.9, 1.1)
    assert is_within(curvature("--smoothing 0", "large_sphere.off")[1][1], 0.1, 0.122), "radius 9"
    succeeds("estimate_curvature small.off --depth 3 --assembly monte-carlo --show gaussian --output gaussian.ply")
    for words, pattern in {
            "--method best": "method", "--show both": "show", "--show gaussian --method coordinates": "gaussian",
            "--clip 0": "clip", "--smoothing -1": "smoothing", "--stabilization x": "stabilization",
            "--tolerance 1": "tolerance"}.items():
        fails(pattern, f"estimate_curvature sphere.off {words}")
    fails("open", "estimate_curvature missing.off")


CUBE = """OFF
8 6 0
0 0 0
1 0 0
1 1 0
0 1 0
0 0 1
1 0 1
1 1 1
0 1 1
4 3 2 1 0
4 4 5 6 7
4 0 1 5 4
4 1 2 6 5
4 2 3 7 6
4 3 0 4 7
"""
# a hexagon that is not convex, a pentagon that crosses itself, and a square and a triangle that name a vertex twice
POLYGONS = """OFF
10 4 0
0 0 0
1 0.8 0
2 0 0
2 2 0
1 1.2 0
0 2 0
0 0 1
1 0 1
1 1 1
0 1 1
6 0 1 2 3 4 5
5 6 8 1 7 9
4 6 6 7 8
3 6 6 7
"""


def test_unusual_meshes():
    pathlib.Path("cube.off").write_text(CUBE)
    result = succeeds("solve_poisson cube.off --depth 3 --csv cube.csv")
    table = Table("cube.csv")
    assert table.comment("faces") == 12 and "triangulat" in result.out.lower()
    assert (table[1][:4] > 0).all() and (table[1][4:] < 0).all(), "vertices keep their order: z = 0 first"
    pathlib.Path("polygons.off").write_text(POLYGONS)
    succeeds("solve_poisson polygons.off --depth 3 --csv polygons.csv")
    assert Table("polygons.csv").comment("faces") == 9, "every polygon is triangulated on its own"
    assert Table("polygons.csv").comment("degenerate_faces") == 1, "a triangle that names a vertex twice"
    # coordinates of a vertex that no face uses
    write_binary_ply("unused.ply", [[0, float("nan"), 0], [0, 0, 0], [1, 0, 0], [0, 1, 0]], [[1, 2, 3]])
    succeeds("solve_poisson unused.ply --depth 3 --rhs y --csv unused.csv --output again.ply")
    assert np.isnan(Table("unused.csv")[1]).tolist() == [True, False, False, False]
    succeeds("solve_poisson again.ply --depth 3 --rhs-property value")
    # other formats
    points, faces = SPHERE
    pathlib.Path("sphere.obj").write_text("o sphere\n" + "".join("v {:.17g} {:.17g} {:.17g}\n".format(*p) for p in points)
                                          + "".join("f {} {} {}\n".format(*(f + 1)) for f in faces))
    succeeds("solve_poisson sphere.obj --depth 3 --tolerance 1e-6 --csv obj.csv")
    assert largest_difference("obj.csv", "z", -0.5) < 5e-3
    pathlib.Path("sphere.stl").write_text("solid sphere\n" + "".join(
        "facet normal 0 0 0\nouter loop\n" + "".join("vertex {:.17g} {:.17g} {:.17g}\n".format(*points[v]) for v in f)
        + "endloop\nendfacet\n" for f in faces) + "endsolid sphere\n")
    succeeds("solve_poisson sphere.stl --depth 3 --csv stl.csv")
    assert Table("stl.csv").comment("vertices") == 1026, "the points of an stl file are merged"


# three triangles on one edge, one vertex that no face uses, and a fourth triangle with a vertex of its own at the
# place of another one
SOUP = ([[0, 0, 0], [1, 0, 0], [9, 9, 9], [0, 1, 0], [0, -1, 0.5], [0, 0, 1], [0, 1, 0], [1, 1, 1]],
        [[0, 1, 3], [0, 1, 4], [0, 1, 5], [1, 6, 7]])


def test_soups():
    write_off("soup.off", *SOUP)
    result = succeeds("solve_poisson soup.off --depth 3 --csv soup.csv")
    table = Table("soup.csv")
    assert table.comment("components") == 2 and table.comment("kernel_dimension") == 2
    assert re.search("^components *2, the surface is disconnected: .* mean 0$", result.out, re.M)
    assert np.flatnonzero(np.isnan(table[1])).tolist() == [2], "a row for each, NaN if no face uses them"
    assert table[1][3] != table[1][6], "vertices at the same place are different"
    succeeds("solve_poisson soup.off --depth 3 --join 0 --csv soup.csv")
    table = Table("soup.csv")
    assert table.comment("components") == 1 and table[1][3] == pytest.approx(table[1][6], abs=1e-9)

    # no two faces have a vertex in common
    write_off("exploded.off", SMALL[0][SMALL[1].ravel()], np.arange(SMALL[1].size).reshape(-1, 3))
    for program in ("solve_poisson", "laplace_spectrum"):
        result = succeeds(f"{program} exploded.off --depth 3 --csv apart.csv")
        assert re.search("^components *128, the surface is disconnected", result.out, re.M)
        if program == "laplace_spectrum":
            assert re.search("disconnected: each has the eigenvalue 0$", result.out, re.M)
        assert Table("apart.csv").comment("components") == 128
        succeeds(f"{program} exploded.off --depth 3 --join 0 --csv joined.csv")
        succeeds(f"{program} small.off --depth 3 --csv small.csv")
        assert Table("joined.csv").comment("components") == 1
        assert Table("joined.csv").comment("dimension") == Table("small.csv").comment("dimension")
        for bad in ("-1", "x", "nan", ""):
            fails("join", f"{program} small.off --join {bad}")

    # Along the strip u is about -y: it would jump if the strip were cut where its orientation changes, at y = 0.
    points, faces = moebius_strip(60)
    write_off("moebius.off", points, faces)
    succeeds("solve_poisson moebius.off --depth 5 --rhs y --csv moebius.csv --output moebius.ply")
    assert Table("moebius.csv").comment("components") == 1
    u = Table("moebius.csv")[1][faces]
    assert np.abs(u - np.roll(u, 1, axis=1)).max() < 0.2
    succeeds("solve_poisson moebius.ply --depth 5 --rhs-property value")

    # two squares that are much nearer to each other than the width of the cells, and a third one
    square = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
    write_off("plates.off", np.concatenate([square + [0, 0, z] for z in (0, 0.01, 0.5)]),
              np.arange(12).reshape(3, 4))
    succeeds("solve_poisson plates.off --depth 4 --rhs x --csv split.csv")
    succeeds("solve_poisson plates.off --depth 4 --rhs x --no-split --csv unsplit.csv")
    split, unsplit = Table("split.csv"), Table("unsplit.csv")
    assert 2 * split.comment("sheets") == 3 * split.comment("cells"), "a sheet each in a cell"
    assert 3 * split.comment("split_elements") == 2 * split.comment("dimension"), "they share no element"
    assert split.comment("kernel_dimension") == 3, "each has its constants"
    assert 3 * unsplit.comment("dimension") == 2 * split.comment("dimension"), "they are one"
    assert unsplit.comment("kernel_dimension") == 2
    for options in ("--no-split", "--paper"):
        succeeds(f"laplace_spectrum plates.off --depth 4 {options} --csv unsplit.csv")
        assert Table("unsplit.csv").comment("split_elements") == 0, options


def test_points():
    """Points in place of a mesh: the vertices of sphere.off, whose normals are their coordinates."""
    points = SPHERE[0]
    write_xyz("points.xyz", points, points)
    lines = pathlib.Path("points.xyz").read_text().splitlines(True)
    pathlib.Path("bare.xyz").write_text("".join(" ".join(line.split()[:3]) + "\n" for line in lines))
    ply = (f"ply\nformat ascii 1.0\nelement vertex {len(points)}\n" + "".join(
        f"property double {name}\n" for name in ("x", "y", "z", "nx", "ny", "nz")) + "end_header\n" + "".join(lines))
    pathlib.Path("points.ply").write_text(ply)
    pathlib.Path("bare.ply").write_text(ply.replace("property double n", "property double m"))
    for file in ("points.xyz", "points.ply"):
        succeeds(f"solve_poisson {file} --depth 2 --csv u.csv --output u.ply")
        assert largest_difference("u.csv", "z", -0.5) < 0.01, file
        assert Table("u.csv").comment("points") == 1026
        assert Table("u.csv").comment("area") == pytest.approx(12.566, abs=0.1)
        # what is written can be read again
        succeeds("laplace_spectrum u.ply --depth 2 --count 4 --split --neighbors 12 --csv e.csv")
        assert Table("e.csv")[1][1:] == pytest.approx(2, abs=0.02)
        assert Table("e.csv").comment("components") == 1
    fails("normal", "laplace_spectrum bare.xyz")
    fails("normal", "laplace_spectrum bare.ply")
    for name, line in (("bad", "0 0 1 0 0 0\n"), ("short", "0 0 1 0\n")):
        pathlib.Path(f"{name}.xyz").write_text("".join([*lines[:4], line, *lines[5:]]))
    fails("point 4 has a normal of length zero", "solve_poisson bad.xyz")
    fails("short.xyz.*line 5", "solve_poisson short.xyz")
    pathlib.Path("types.ply").write_text(re.sub("property double ([xyz])\n", r"property float \1\n", ply))
    succeeds("solve_poisson types.ply --depth 2 --csv types.csv")
    assert Table("types.csv").rows == Table("u.csv").rows, "numbers of all types are the same"
    pathlib.Path("flat.ply").write_text(ply.replace("property double y\n", ""))
    fails("'y'", "solve_poisson flat.ply")
    pathlib.Path("empty.xyz").write_text("# none\n")
    fails("no point", "solve_poisson empty.xyz")
    for words, pattern in {
            "points.xyz --operator cotangent": " --operator cotangent needs .*triangles",
            "points.xyz --assembly monte-carlo": " --assembly monte-carlo needs .*triangles",
            "points.xyz --neighbors 2": " --neighbors is 2",
            "points.xyz --refine 2 --output points_2.ply": " --refine needs a mesh",
            "sphere.off --split": "set of points",
            "sphere.off --assembly monte-carlo --sampling regular": "sampling"}.items():
        fails(pattern, f"laplace_spectrum {words}")
    succeeds("laplace_spectrum sphere.off --depth 3 --count 2 --csv stratified.csv --assembly monte-carlo "
             "--samples 50000 --sampling stratified")
    assert Table("stratified.csv")[1][1] == pytest.approx(2, abs=0.01)


def test_distances():
    # the first vertices are on the axes
    result = succeeds("geodesic_distance sphere.off --source 0 --csv d.csv --output d.ply")
    assert result.entry("largest_distance") == pytest.approx(np.pi, abs=0.01)
    table = Table("d.csv")
    assert table.columns == ["vertex", "distance", "nearest"] and table.rows[0] == "0,0,0"
    assert "property double distance" in header_of("d.ply")
    succeeds("geodesic_distance sphere.off --source 0 1 --exact --show nearest --output d.ply --csv d.csv")
    assert set(Table("d.csv")[2]) == {0, 1}, "two regions"
    succeeds("geodesic_distance sphere.off --source 0 --csv all.csv")
    succeeds("geodesic_distance sphere.off --source 0 --maximum-distance 1 --csv near.csv")
    found, limited = Table("all.csv")[1], Table("near.csv")[1]
    assert limited[found < 1] == pytest.approx(found[found < 1]) and np.isinf(limited[found > 1]).all()
    height = SPHERE[0][:, 2] - 0.5
    write_binary_ply("height.ply", np.column_stack([SPHERE[0], height]), SPHERE[1], ("height",))
    succeeds("geodesic_distance height.ply --zero-property height --csv signed.csv")
    latitude = np.arcsin(np.clip(SPHERE[0][:, 2], -1, 1)) - np.pi / 6
    assert Table("signed.csv")[1] == pytest.approx(latitude, abs=0.02)
    for words, pattern in {"--zero-property none": "none", "--zero-property height --source 0": "no other source",
                           "--source 0 --maximum-distance -1": "maximum-distance.*negative",
                           "--source 0 --maximum-distance 1 --path 3": "without --path"}.items():
        fails(pattern, f"geodesic_distance height.ply {words}")
    result = succeeds("geodesic_distance sphere.off --farthest 3")
    assert len(result.out[re.search("^sources", result.out, re.M).start():].splitlines()) == 4
    write_off("square.off", [[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0], [2, 2, 0]],
              [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]])
    fails("--maximum-memory is 0.1 MB: the windows of rays would take more",
          "geodesic_distance sphere.off --source 0 --maximum-memory 1e-4")
    result = succeeds("geodesic_distance square.off --boundary")
    assert result.entry("largest_distance") == pytest.approx(2, abs=1e-5)
    result = succeeds("geodesic_distance sphere.off --source 0 --path 1 1 --isolines 3 --lines lines.obj --refine 2 "
                      "--depth 4 --output d.ply --csv d.csv")
    assert result.entry("path_length") == pytest.approx(Table("d.csv")[1][1], abs=0.001)
    assert len(re.findall("^l ", pathlib.Path("lines.obj").read_text(), re.M)) == 5
    assert int(next(line.split()[2] for line in header_of("d.ply") if line.startswith("element vertex"))) > 3000
    write_off("cracked.off", [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 0, 0], [2, 2, 0], [0, 2, 0]], [[0, 1, 2], [3, 4, 5]])
    result = succeeds("geodesic_distance cracked.off --source 1 --join 1e-9")
    assert result.entry("largest_distance") == pytest.approx(2.828427, abs=1e-5)
    assert succeeds("geodesic_distance cracked.off --source 1").entry("unreached_vertices") == 3
    fails("join", "geodesic_distance cracked.off --source 1 --join -1")
    write_xyz("sphere.xyz", SPHERE[0], SPHERE[0])
    result = succeeds("geodesic_distance sphere.xyz --source 0 --output d.ply")
    assert result.entry("largest_distance") == pytest.approx(np.pi, abs=0.03)
    for words, pattern in {
            "sphere.off --source 0 --lines lines.obj": "needs --path", "sphere.off --source 0 --depth 4": "depth",
            "sphere.off --source 0 --path 1 --lines lines.txt": "lines",
            "sphere.off --source 0 --path 100000": "vertex 100000", "sphere.off": "no source",
            "sphere.off --boundary": "boundary, but the surface has none", "sphere.off --source 100000": "vertex 100000",
            "sphere.off --source -1": "source", "square.off --boundary --farthest 2": "farthest",
            "sphere.off --source 0 --show both": "show", "missing.off --source 0": "open"}.items():
        fails(pattern, f"geodesic_distance {words}")


def test_data(elephant):
    """A mesh of CGAL's data, for what small shapes do not have."""
    succeeds(f"solve_poisson {elephant} --depth 5 --tolerance 1e-6 --csv e.csv")
    assert len(Table("e.csv").rows) == len(read_points(elephant))
    assert Table("e.csv").comment("relative_residual") < 1.0001e-6

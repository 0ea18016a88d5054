# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Documentation: examples are run, all that is public is documented, types are as they say."""

from __future__ import annotations

import doctest
import importlib
import inspect
import json
import pathlib
import pkgutil
import subprocess
import sys

import pytest

import restricted_laplacian as rl
from conftest import data_file

MODULES = [name for _, name, _ in pkgutil.iter_modules(rl.__path__) if name not in ("_core",
                                                                                  "__main__")]


@pytest.mark.parametrize("name", ["", *MODULES])
def test_examples(name):
    module = importlib.import_module("restricted_laplacian" + ("." + name if name else ""))
    result = doctest.testmod(module, optionflags=doctest.NORMALIZE_WHITESPACE)
    assert result.failed == 0


def test_all_that_is_public_is_documented():
    for name in rl.__all__:
        if name == "__version__":
            continue
        item = getattr(rl, name)
        assert inspect.getdoc(item), name
        if inspect.isfunction(item):
            doc = inspect.getdoc(item)
            for parameter in inspect.signature(item).parameters:
                assert parameter in doc or len(inspect.signature(item).parameters) < 4, (
                    name, parameter)
        elif inspect.isclass(item):
            for member, value in vars(item).items():
                if not member.startswith("_") and callable(value):
                    assert inspect.getdoc(value), f"{name}.{member}"


def test_version():
    header = pathlib.Path(__file__).parents[2] / "include/CGAL/Restricted_laplacian_3/version.h"
    text = header.read_text()
    numbers = [text.split(f"_{part} ", 1)[1].split()[0] for part in ("MAJOR", "MINOR", "PATCH")]
    assert rl.__version__ == ".".join(numbers)


def test_code_of_the_manual(tmp_path, monkeypatch):
    page = (pathlib.Path(__file__).parents[2] / "doc/Restricted_laplacian_3/Python.txt").read_text()
    blocks = [part.split("\\endcode")[0] for part in page.split("\\code{.py}\n")[1:]]
    assert len(blocks) > 5
    (tmp_path / "elephant.off").write_bytes(data_file("elephant.off").read_bytes())
    monkeypatch.chdir(tmp_path)
    names: dict = {}
    if not pathlib.Path(rl.__file__).with_name("viewer.html").exists():
        blocks = [block for block in blocks if "save_html" not in block]
    for block in blocks:
        exec(compile(block, "Python.txt", "exec"), names)
    assert names["values"].shape == names["V"].shape


def test_first_steps(programs, tmp_path):
    if not pathlib.Path(rl.__file__).with_name("viewer.html").exists():
        pytest.skip("SKIPPED: this build has no viewer: it needs Node.js")
    (tmp_path / "elephant.off").write_bytes(data_file("elephant.off").read_bytes())
    commands = [[sys.executable, pathlib.Path(__file__).parents[1] / "examples/first_steps.py"],
                [programs / "first_steps"]]
    printed = [subprocess.run(command, cwd=tmp_path, capture_output=True, check=True).stdout
               for command in commands]
    assert abs(float(printed[0]) / float(printed[1]) - 1) < 1e-5
    assert (tmp_path / "phi.html").stat().st_size > 1e6


def test_notebooks_of_the_manual():
    root = pathlib.Path(__file__).parents[2]
    page = (root / "doc/Restricted_laplacian_3/Notebooks.txt").read_text()
    notebooks = list((root / "python/notebooks").glob("*.ipynb"))
    assert len(notebooks) >= 3
    for notebook in notebooks:
        for cell in json.loads(notebook.read_text())["cells"]:
            if cell["cell_type"] == "code":
                assert "".join(cell["source"]) in page, "scripts/run_notebooks.sh makes the page"


def test_types():
    pytest.importorskip("mypy", reason="SKIPPED: mypy was not found")
    folder = pathlib.Path(rl.__file__).parent
    result = subprocess.run([sys.executable, "-m", "mypy", "--strict-optional",
                             "--disallow-untyped-defs", "--ignore-missing-imports", str(folder)],
                            capture_output=True, text=True, cwd=folder.parent)
    assert result.returncode == 0, result.stdout

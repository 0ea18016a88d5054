# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Documentation: examples are run, all that is public is documented, types are as they say."""

from __future__ import annotations

import doctest
import importlib.util
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


# of numpydoc's validation: a text, all parameters and no others, their types and meanings, what is returned
CHECKS = {"GL08", "PR01", "PR02", "PR04", "PR07", "RT01", "RT03", "SS03"}


def public_items():
    """Names of all that is public: functions, classes and their methods."""
    from restricted_laplacian import learning
    for module, names in ((rl, rl.__all__), (learning, [
            name for name, item in vars(learning).items()
            if not name.startswith("_") and getattr(item, "__module__", "") == learning.__name__])):
        for name in names:
            item = getattr(module, name)
            if not callable(item):
                continue
            yield f"{module.__name__}.{name}", item
            for member, value in vars(item).items() if inspect.isclass(item) else ():
                if not member.startswith("_") and callable(value):
                    yield f"{module.__name__}.{name}.{member}", value


@pytest.mark.parametrize("name, item", list(public_items()), ids=lambda x: x if isinstance(x, str) else "")
def test_all_that_is_public_is_documented(name, item):
    validate = pytest.importorskip("numpydoc.validate", reason="SKIPPED: numpydoc is not installed").validate
    doc = inspect.getdoc(item) or ""
    checks = CHECKS - ({"PR01"} if inspect.isclass(item) and "Attributes\n---" in doc else set())
    errors = [error for error in validate(name)["errors"] if error[0] in checks]
    assert not errors
    if inspect.isfunction(item) and "." not in item.__qualname__:  # and no method
        assert "Raises\n---" in doc and "Examples\n---" in doc


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
    if importlib.util.find_spec("neuromodes") is None:
        blocks = [block for block in blocks if "neuromodes" not in block]
    for block in blocks:
        exec(compile(block, "Python.txt", "exec"), names)
    assert names["values"].shape == names["V"].shape


def test_first_steps(examples, tmp_path):
    if not pathlib.Path(rl.__file__).with_name("viewer.html").exists():
        pytest.skip("SKIPPED: this build has no viewer: it needs Node.js")
    printed = subprocess.run([sys.executable, pathlib.Path(__file__).parents[1] / "examples/first_steps.py"],
                             cwd=tmp_path, capture_output=True, check=True).stdout
    assert abs(float(printed) / 2 - 1) < 0.01
    # and that of C++
    (tmp_path / "elephant.off").write_bytes(data_file("elephant.off").read_bytes())
    printed = subprocess.run([examples / "first_steps"], cwd=tmp_path, capture_output=True, check=True).stdout
    expected = rl.eigs(rl.read_mesh(tmp_path / "elephant.off"), 50)[0][1]
    assert abs(float(printed) / expected - 1) < 1e-5
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

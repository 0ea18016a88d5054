# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Ordinary shapes: what functions find on them is right, at default settings, in time and memory."""

import os
import pathlib
import subprocess
import sys

import pytest

import restricted_laplacian as rl


@pytest.mark.skipif(not hasattr(os, "fork"), reason="trials are processes that are forked")
def test_functions_are_right_on_ordinary_shapes():
    package = pathlib.Path(rl.__file__).parent.parent
    environment = {**os.environ, "PYTHONPATH": str(package)}
    result = subprocess.run([sys.executable, str(pathlib.Path(__file__).parent / "ordinary_shapes.py")],
                            capture_output=True, text=True, env=environment, timeout=600)
    assert result.returncode == 0, result.stdout + result.stderr
    assert "0 of them wrong" in result.stdout

# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Exceptions. All that is wrong with an input is an InputError, which names it."""

from __future__ import annotations

from typing import Any, Optional


class InputError(ValueError):
    """An argument cannot be used.

    Attributes
    ----------
    face, vertex : int or None
        Row of ``F`` or ``V`` at which something is wrong, if it is one.
    argument : str or None
        Name of the argument, if it is one number.
    """

    face: Optional[int] = None
    vertex: Optional[int] = None
    argument: Optional[str] = None


class ConvergenceError(RuntimeError):
    """A solver did not reach its tolerance.

    Attributes
    ----------
    result
        What it found, as it is returned with ``check=False``.
    report : Report
        Iterations, residual, and how the iteration ended.
    """

    result: Any = None
    report: Any = None


class Canceled(RuntimeError):
    """A callback of ``progress=`` returned False."""


def make_error(kind: str, message: str, name: str, value: Any) -> Exception:
    """An exception for one of the C++ library: its class, message, and what it names."""
    if kind == "Canceled":
        return Canceled(message)
    if value == "vertex_normal_map":
        value = "vertex_normals"
        message = message.replace("vertex_normal_map", value, 1)
    error = InputError(message)
    if name:
        setattr(error, name, value)
    return error


def argument_error(argument: str, message: str) -> InputError:
    """An error in an argument; the message goes on after its name."""
    error = InputError(f"{argument} {message}")
    error.argument = argument
    return error

# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""How results print: in a line, and as a small table in a notebook."""

from __future__ import annotations

import dataclasses
import html
from typing import Any, Callable, TypeVar

import numpy as np
import scipy.sparse

_Class = TypeVar("_Class", bound=type)


def _short(value: Any) -> str:
    if isinstance(value, np.ndarray):
        text = f"array of {' x '.join(map(str, value.shape))}"
        numbers = value[np.isfinite(value)] if value.dtype.kind in "fiu" else value[:0]
        return text + (f", {numbers.min():.4g} to {numbers.max():.4g}" if numbers.size else "")
    if scipy.sparse.issparse(value):
        return f"{value.shape[0]} x {value.shape[1]} sparse, {value.nnz} entries"
    if isinstance(value, (float, np.floating)):
        return f"{value:.6g}"
    if isinstance(value, (tuple, list)) and len(value) > 3:
        return f"{type(value).__name__} of {len(value)}"
    if isinstance(value, (tuple, list)):
        return "(" + ", ".join(map(_short, value)) + ")"
    return repr(value)


def table(title: str, entries: Any) -> str:
    """HTML of names and values."""
    rows = "".join(f"<tr><th style='text-align: left'>{html.escape(str(name))}</th>"
                   f"<td style='text-align: left'>{html.escape(_short(value))}</td></tr>"
                   for name, value in entries)
    return f"<table><caption>{html.escape(title)}</caption>{rows}</table>"


def shown(*names: str) -> Callable[[_Class], _Class]:
    """Give a class a short `__repr__`, and `_repr_html_`, of these attributes; by default its fields."""
    def change(cls: _Class) -> _Class:
        own = names or getattr(cls, "_fields", None) or [f.name for f in dataclasses.fields(cls)]

        def __repr__(self: Any) -> str:
            return f"{cls.__name__}({', '.join(f'{n}={_short(getattr(self, n))}' for n in own)})"

        def _repr_html_(self: Any) -> str:
            return table(cls.__name__, [(n, getattr(self, n)) for n in own])
        cls.__repr__ = __repr__  # type: ignore[assignment]
        cls._repr_html_ = _repr_html_  # type: ignore[attr-defined]
        return cls
    return change

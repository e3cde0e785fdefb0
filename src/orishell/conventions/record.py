"""Records: what functions return and take, unchangeable, and shown in one line at a prompt."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass, field, fields, is_dataclass
from functools import cached_property
from pathlib import Path
from typing import TypeVar, dataclass_transform

import numpy as np

SHOWN = 60
"""Characters that a part may take in the line of the whole; else its type is shown."""

T = TypeVar("T")


@dataclass_transform(frozen_default=True, eq_default=False, field_specifiers=(field,))
def record(cls: type[T]) -> type[T]:
    """Make a frozen dataclass of a class, with slots unless it has a ``cached_property``.

    Records may hold arrays, so two of them are equal if they are the same one. A ``__repr__`` of
    the class's own stays.
    """
    slots = not any(isinstance(each, cached_property) for each in vars(cls).values())
    made = dataclass(frozen=True, slots=slots, eq=False, repr=False)(cls)
    if "__repr__" not in cls.__dict__:
        made.__repr__ = _in_one_line  # type: ignore[method-assign]
    return made


def _in_one_line(thing: object) -> str:
    """Numbers to six digits, arrays by their shape; functions and what is private are left out."""
    assert is_dataclass(thing)
    parts = {each.name: getattr(thing, each.name) for each in fields(thing) if each.repr}
    shown = (
        f"{name}={_short(part)}"
        for name, part in parts.items()
        if not name.startswith("_") and not callable(part)
    )
    return f"{type(thing).__name__}({', '.join(shown)})"


def _short(part: object) -> str:
    match part:
        case np.ndarray():
            text = f"array{part.shape}"
        case str():
            text = repr(part if len(part) < SHOWN - 1 else part[: SHOWN - 5] + "...")
        case float():
            text = f"{part:.6g}"
        case Path():
            text = repr(str(part))
        case tuple():
            text = f"({', '.join(map(_short, part))})"
        case _:
            text = repr(part)
    if len(text) <= SHOWN:
        return text
    size = len(part) if isinstance(part, Collection) and not isinstance(part, str) else "..."
    return f"{type(part).__name__}({size})"

"""Patterns whose states or files would be too large are refused before any is made."""

from __future__ import annotations

import math
from pathlib import Path

from orishell.conventions.errors import InputError
from orishell.families.pattern import Pattern

MAX_VERTICES = 4_000_000
MAX_FOLD = 5_000_000_000
"""Largest shell.fold that is written, in bytes, and what a vertex takes in each frame of it."""
FOLD_BYTES = 170


def require_memory(path: Path, pattern: Pattern, frames: int) -> None:
    """Refuse a pattern whose states or whose file would be too large.

    Parameters
    ----------
    frames
        Number of states.

    Raises
    ------
    InputError
        Naming the key to change.
    """
    vertices = (pattern.rows + 2) * (pattern.columns + 2)
    if vertices > MAX_VERTICES:
        raise InputError(
            "the pattern is too large",
            file=path,
            keys=("pattern.rows", "pattern.columns"),
            got=f"{pattern.rows} x {pattern.columns}, which need {_bytes(24 * vertices)} of memory "
            "for the coordinates of every state",
            expected=f"at most {MAX_VERTICES} vertices ({_bytes(24 * MAX_VERTICES)})",
        )
    size = FOLD_BYTES * vertices * frames
    if size > MAX_FOLD:
        raise InputError(
            "shell.fold would be too large",
            file=path,
            keys=("motion.frames",),
            got=f"{frames} frames of {vertices} vertices, about {_bytes(size)}",
            expected=f"at most {_bytes(MAX_FOLD)}",
            remedy=f"set frames to at most {MAX_FOLD // (FOLD_BYTES * vertices)}",
        )


def _bytes(number: float) -> str:
    units = ("B", "kB", "MB", "GB", "TB", "PB")
    power = min(len(units) - 1, int(math.log10(number)) // 3)
    return f"{number / 1000**power:.3g} {units[power]}"

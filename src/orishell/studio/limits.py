"""How large a design the studio takes."""

from __future__ import annotations

from orishell.conventions.errors import InputError
from orishell.design_file import DesignFile

MAX_VERTICES = 60_000
"""Vertices of a sheet in the studio, at most; the command line takes more."""


def require_small(file: DesignFile) -> None:
    """Refuse a sheet that is too large for the studio.

    Raises
    ------
    InputError
        If it has more vertices than :data:`MAX_VERTICES`.
    """
    vertices = (file.pattern.rows + 2) * (file.pattern.columns + 2)
    if vertices > MAX_VERTICES:
        raise InputError(
            "the sheet is too large for the studio",
            where="[pattern] rows, columns",
            got=f"{vertices} vertices",
            expected=f"at most {MAX_VERTICES}",
            remedy="use orishell design",
        )

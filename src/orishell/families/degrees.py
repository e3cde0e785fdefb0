"""Angles in degrees, where radians seem to be meant: said beside a shell or a refusal.

Angles of a pattern are tens of degrees, so one below half a turn in radians is legal in degrees
and of hardly any use.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from itertools import chain
from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.formatting import rounded
from orishell.design import Design
from orishell.errors import DesignError, Remedy, Value

if TYPE_CHECKING:
    from orishell.families.pattern import Pattern

LARGE: tuple[str, ...] = ("xi_deg", "row_angle_deg", "plane_deg", "sector_deg")
"""Keys of angles that are never so small in degrees that they might be radians."""
EITHER: tuple[str, ...] = ("heading_deg",)
"""Keys of angles that are so where g runs along y; where the shell is refused they are tried."""
DIGITS = 4


def made_in_degrees(pattern: Pattern, make: Callable[[], Design]) -> Design:
    """Design a pattern, and say of angles that look like radians what they are in degrees.

    Parameters
    ----------
    pattern
        The table, whose angles are in degrees.
    make
        Designs it.

    Raises
    ------
    DesignError
        As the family does; degrees in place of what looks like radians are its first candidates.
    """
    try:
        design = make()
    except DesignError as error:
        changes = _in_degrees(pattern, (*LARGE, *EITHER))
        if changes:
            said = "; ".join(each for each in (error.size, _words(pattern, changes)) if each)
            meant = Remedy({f"pattern.{key}": value for key, value in changes.items()})
            error.size, error.candidates = said, chain([meant], error.candidates)
        raise
    changes = _in_degrees(pattern, LARGE)
    return (
        replace(design, warnings=(_warning(pattern, changes), *design.warnings))
        if changes
        else design
    )


def _in_degrees(pattern: Pattern, keys: tuple[str, ...]) -> dict[str, Value]:
    """What keys that are given would say, had their values been radians; only where they may be."""
    found: dict[str, Value] = {}
    for key in keys:
        value = getattr(pattern, key, "auto")
        angles = value if isinstance(value, list) else [value]
        if key not in pattern.model_fields_set or "auto" in angles:
            continue
        if all(0 < angle < np.pi for angle in angles):
            degrees = [rounded(float(np.rad2deg(angle)), DIGITS) for angle in angles]
            found[key] = degrees if isinstance(value, list) else degrees[0]
    return found


def _words(pattern: Pattern, changes: dict[str, Value]) -> str:
    return " and ".join(
        f"{key} is in degrees ({getattr(pattern, key)} radians are {_shown(value)} degrees)"
        for key, value in changes.items()
    )


def _warning(pattern: Pattern, changes: dict[str, Value]) -> str:
    written = " and ".join(f"{key} = {_shown(value)}" for key, value in changes.items())
    return f"{_words(pattern, changes)}: if radians were meant, write {written}"


def _shown(value: Value) -> str:
    values = value if isinstance(value, list) else [value]
    shown = ", ".join(f"{each:g}" for each in values if not isinstance(each, str))
    return f"[{shown}]" if isinstance(value, list) else shown

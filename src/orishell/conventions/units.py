"""Units of length that files state, and what weighs."""

from __future__ import annotations

from typing import Final, Literal

Unit = Literal["mm", "cm", "m", "in", "ft"]

MILLIMETRES: Final[dict[str, float]] = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "in": 25.4, "ft": 304.8}
"""Length of each unit in millimetres."""
GRAVITY: Final = 9.81
"""Metres per second squared."""


def conversion(source: str, target: str) -> float:
    """The factor that converts lengths from one unit to another: 1 for the same unit.

    Parameters
    ----------
    source, target
        The units: mm, cm, m, in, ft.
    """
    return 1.0 if source == target else MILLIMETRES[source] / MILLIMETRES[target]

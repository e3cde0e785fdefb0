"""Numbers as messages quote them."""

from __future__ import annotations

import numpy as np

ROUNDING = 1e-3
"""Nearest values that work are quoted this share inside the limit."""


def in_degrees(angle: float) -> str:
    """Degrees to four decimals, as text.

    Parameters
    ----------
    angle
        The angle (radians).
    """
    return f"{np.rad2deg(angle):.4f}".rstrip("0").rstrip(".")


def tidy_degrees(angle: float) -> float:
    """Degrees without the last digits that the conversion leaves.

    Parameters
    ----------
    angle
        The angle (radians).
    """
    return float(f"{np.rad2deg(angle):.13g}")


def inside(limit: float, start: float) -> float:
    """A little nearer to ``start`` than the limit, so that the quoted value works.

    Parameters
    ----------
    limit
        What may not be reached.
    start
        A value that works.
    """
    return float(start + (limit - start) * (1 - ROUNDING))

"""Curves evaluated where they must be finite."""

from __future__ import annotations

import numpy as np

from orishell.curves.curve import Curve
from orishell.curves.jets import Array
from orishell.errors import CurveError

LARGEST = 1e100
"""Coordinates and derivatives beyond this count as not finite."""


def checked_jet(curve: Curve, t: Array) -> tuple[Array, Array, Array]:
    """Position, first and second derivative, (N, 2) each, at parameters (N,).

    Parameters
    ----------
    curve
        The curve.
    t
        Parameters (N,).

    Raises
    ------
    CurveError
        If the position or the first derivative is not finite.
    """
    position, first, second = curve.jet(t)
    for what, array in (
        ("the curve is not finite", position),
        ("the tangent is not finite", first),
    ):
        good = (np.abs(array) < LARGEST).all(axis=-1)  # false for nan, too
        if not good.all():
            k = int(np.argmin(good))
            raise CurveError(
                what,
                where=f"at parameter {curve.as_drawn(t[k]):.10g}",
                got=f"({array[k, 0]:g}, {array[k, 1]:g})",
                remedy="choose a range without this point"
                + (", or give x(t) and y(t)" if what.startswith("the tangent") else ""),
            )
    return position, first, second

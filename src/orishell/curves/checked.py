"""What a curve must be: finite, of some length, and nowhere standing still."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from orishell.conventions.errors import CurveError
from orishell.curves.curve import Curve
from orishell.numerics.arrays import Array
from orishell.numerics.equals import first_smallest

LARGEST_COORDINATE = 1e100
"""Coordinates and derivatives beyond this count as not finite."""
MIN_SPEED = 1e-7
"""A tangent shorter than this, relative to the mean, counts as zero."""
SHORTEST = 1e-9
"""A curve shorter than this, relative to its largest coordinate, is lost in rounding."""

PROBES, ROUNDS = 31, 13
"""Samples in an interval, and how often it is narrowed to a sixteenth: down to rounding."""


def checked_jet(curve: Curve, t: Array) -> tuple[Array, Array, Array]:
    """Position, first and second derivative, (N, 2) each, at t (N,); CurveError if not finite."""
    position, first, second = curve.jet(t)
    for what, array in (
        ("the curve is not finite", position),
        ("the tangent is not finite", first),
    ):
        good = (np.abs(array) < LARGEST_COORDINATE).all(axis=-1)  # false for nan, too
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


def require_length(position: Array, arc: Array) -> None:
    """Refuse a curve that is lost in the rounding of its coordinates."""
    length, largest = float(arc[-1]), float(np.abs(position).max())
    least = max(SHORTEST * largest, 1 / LARGEST_COORDINATE)
    if length == 0.0:
        raise CurveError(
            "the curve is a single point", got=f"({position[0, 0]:g}, {position[0, 1]:g})"
        )
    if not length > least:
        raise CurveError(
            "the curve is too short",
            got=f"{length:g} long with coordinates up to {largest:g}",
            expected=f"at least {least:g}",
        )


def require_speed(curve: Curve, t: Array, first: Array, length: float) -> None:
    """Refuse a zero tangent, also between the samples, with first derivatives (N, 2) at t (N,)."""
    speed = np.hypot(*first.T)
    padded = np.concatenate([[np.inf], speed, [np.inf]])
    mean = length / (curve.stop - curve.start)
    low = np.flatnonzero(
        (padded[1:-1] <= padded[:-2]) & (padded[1:-1] <= padded[2:]) & (speed < 0.1 * mean)
    )
    if len(low) == 0:
        return
    lo, hi = t[np.maximum(low - 1, 0)], t[np.minimum(low + 1, len(t) - 1)]
    where, least = least_within(lambda u: np.hypot(*np.moveaxis(curve.jet(u)[1], -1, 0)), lo, hi)
    where, least = np.concatenate([where, t[low]]), np.concatenate([least, speed[low]])
    places = np.argsort(where, kind="stable")
    k = int(places[first_smallest(least[places], MIN_SPEED, mean)])
    if least[k] < MIN_SPEED * mean:
        raise CurveError(
            "the curve is not regular: its tangent is zero",
            where=f"at parameter {curve.as_drawn(where[k]):.10g}",
            remedy="use a parametrisation that does not stand still",
        )


def least_within(function: Callable[[Array], Array], lo: Array, hi: Array) -> tuple[Array, Array]:
    """Place and value (K,) of the minimum in each interval, narrowed around the least sample.

    The function takes places (..., K); it is nan where it has no value.
    """
    share = np.arange(1, PROBES + 1)[:, None] / (PROBES + 1)
    each = np.arange(len(lo))
    where, least = lo, np.full(len(lo), np.inf)
    for _ in range(ROUNDS):
        width = hi - lo
        places = lo + share * width
        values = function(places)
        values = np.where(np.isnan(values), np.inf, values)
        best = values.argmin(axis=0)
        place, value = places[best, each], values[best, each]
        where, least = np.where(value < least, place, where), np.minimum(value, least)
        step = width / (PROBES + 1)
        lo, hi = np.maximum(lo, place - step), np.minimum(hi, place + step)
    return where, least

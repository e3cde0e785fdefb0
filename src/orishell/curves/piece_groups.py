"""Pieces of one kind, evaluated together."""

from __future__ import annotations

from collections.abc import Sequence
from math import comb

import numpy as np

from orishell.conventions.record import record
from orishell.curves.pieces import Arc
from orishell.numerics import FUNCTIONS, Enclosure, Interval, power
from orishell.numerics.arrays import Array, Booleans, Integers

RETRACTED = 1e-6
"""A control point this near to the end, relative to the control polygon, is put on it."""
SLOWEST = (1e-8, 1e-5)
"""Nearest to the end with a retracted control point that first and second derivatives are taken:
there the second derivative is infinite in the end itself."""


@record
class Rationals:
    """Rational Bezier curves of one degree, as powers of s."""

    powers: Array  # coefficients (N, degree + 1, 3) of weight times x, weight times y, and weight
    # -1 or 1 (N,) where the control point next to the beginning or the end is retracted into it
    slow: Integers

    def jet(self, row: Integers, s: Array) -> tuple[Array, Array, Array]:
        """Position and two derivatives by s, (P, 2) each, at shares s (P,) of curves (P,)."""
        if not self.slow.any():
            return self._jet(row, s)
        # There the curve goes like the square of its parameter: take the square as parameter.
        side = self.slow[row]
        root = np.where(side < 0, np.sqrt(s), np.sqrt(np.maximum(1 - s, 0.0)))
        inner = [
            np.where(side == 0, s, np.where(side < 0, clipped, 1 - clipped))
            for clipped in (root, *(np.maximum(root, least) for least in SLOWEST))
        ]
        pace = np.where(side == 0, 1.0, 0.5 / np.maximum(root, SLOWEST[0]))
        even = np.where(side == 0, 1.0, 0.5 / np.maximum(root, SLOWEST[1]))
        bend = np.where(side == 0, 0.0, side * 2 * even**3)
        position = self._jet(row, inner[0])[0]
        first = self._jet(row, inner[1])[1] * pace[:, None]
        _, by_s, twice = self._jet(row, inner[2])
        return position, first, twice * (even**2)[:, None] + by_s * bend[:, None]

    def enclosure(self, row: Integers, low: Array, high: Array) -> tuple[Enclosure, Enclosure]:
        """Bounds of x and y between shares ``low`` and ``high`` (P,) of curves (P,)."""
        powers, side = self.powers[row], self.slow[row]
        if not side.any():
            return _quotients(powers, low, high)
        # From the end where the curve stands still, as a polynomial of the root of the share.
        powers = np.where((side > 0)[:, None, None], _from_the_end(powers), powers)
        low, high = np.where(side > 0, 1 - high, low), np.where(side > 0, 1 - low, high)
        begin, end = (np.where(side == 0, s, np.sqrt(s)) for s in (low, high))
        by_root = _quotients(powers, begin, end)
        x, y = (_by_share(by_root[k], powers[..., [k, 2]], side, begin, end) for k in (0, 1))
        return x, y

    def _jet(self, row: Integers, s: Array) -> tuple[Array, Array, Array]:
        powers = self.powers[row]
        s = s[:, None]
        value = powers[:, -1]
        first = second = np.zeros_like(value)
        for k in range(powers.shape[1] - 2, -1, -1):
            second = second * s + 2 * first
            first = first * s + value
            value = value * s + powers[:, k]
        weight = value[:, 2:]
        position = value[:, :2] / weight
        speed = (first[:, :2] - position * first[:, 2:]) / weight
        bend = (second[:, :2] - 2 * speed * first[:, 2:] - position * second[:, 2:]) / weight
        return position, speed, bend


@record
class Arcs:
    """Elliptical arcs: centres (N, 2), axes (N, 2, 2), first angles and sweeps (N,)."""

    centre: Array
    axes: Array
    start: Array
    sweep: Array

    @classmethod
    def of(cls, arcs: Sequence[Arc]) -> Arcs:
        """Gather the numbers of several arcs in arrays."""
        numbers = [(arc.centre, arc.axes, arc.start, arc.sweep) for arc in arcs]
        return cls(*map(np.array, zip(*numbers, strict=True)))

    def jet(self, row: Integers, s: Array) -> tuple[Array, Array, Array]:
        """Position and two derivatives by s, (P, 2) each, at shares s (P,) of arcs (P,)."""
        sweep = self.sweep[row][:, None]
        angle = self.start[row][:, None] + s[:, None] * sweep
        cos, sin = np.cos(angle), np.sin(angle)
        u, v = self.axes[row, 0], self.axes[row, 1]
        out = cos * u + sin * v
        return self.centre[row] + out, sweep * (cos * v - sin * u), -sweep * sweep * out

    def enclosure(self, row: Integers, low: Array, high: Array) -> tuple[Enclosure, Enclosure]:
        """Bounds of x and y between shares ``low`` and ``high`` (P,) of arcs (P,)."""
        start, sweep = self.start[row], self.sweep[row]
        flat = Interval(np.zeros_like(sweep), np.zeros_like(sweep))
        turned = Interval.between(start + low * sweep, start + high * sweep)
        angle = Enclosure(turned, Interval(sweep, sweep), flat)
        cos, sin = (FUNCTIONS[name].of(angle) for name in ("cos", "sin"))
        x, y = (
            cos.times(self.axes[row, 0, axis]) + sin.times(self.axes[row, 1, axis])
            for axis in (0, 1)
        )
        centre = self.centre[row]
        return x.plus(centre[:, 0]), y.plus(centre[:, 1])


def powers_of(control: Array) -> Array:
    """Coefficients (N, d+1, 3) of powers, from those of Bernstein's polynomials."""
    degree = control.shape[1] - 1
    powers, differences = [], control
    for k in range(degree + 1):
        powers.append(comb(degree, k) * differences[:, 0])
        differences = np.diff(differences, axis=1)
    return np.stack(powers, axis=1)


def even_out(control: Array) -> tuple[Array, Booleans, Integers]:
    """Put control points (N, d+1, 3) near an end into it.

    Returned are also whether a curve is a straight line because all lie in its ends, and -1 or 1
    where one lies in its beginning or end.
    """
    points = control[:, :, :2] / control[:, :, 2:]
    steps = np.diff(points, axis=1)
    near = RETRACTED * np.hypot(steps[..., 0], steps[..., 1]).sum(axis=1)
    control = control.copy()
    counts = []
    for end, order in ((0, slice(None)), (-1, slice(None, None, -1))):
        away = points - points[:, end, None]
        close = np.hypot(away[..., 0], away[..., 1]) <= near[:, None]
        run = np.logical_and.accumulate(close[:, order], axis=1)
        there = run[:, order]
        snapped = points[:, end, None] * control[:, :, 2:]
        control[:, :, :2] = np.where(there[..., None], snapped, control[:, :, :2])
        counts.append(run.sum(axis=1))
    line = counts[0] + counts[1] >= control.shape[1]
    slow = np.where(counts[0] == 2, -1, 0) + np.where(counts[1] == 2, 1, 0)
    return control, line, np.where(line, 0, slow)


def _shifted(powers: Array, origin: Array) -> Array:
    """Coefficients (P, d+1, ...) of powers of s - origin, from those of powers of s."""
    shifted = powers.copy()
    step = origin.reshape(-1, *[1] * (powers.ndim - 2))
    degree = powers.shape[1] - 1
    for lowest in range(degree):
        for k in range(degree - 1, lowest - 1, -1):
            shifted[:, k] += step * shifted[:, k + 1]
    return shifted


def _from_the_end(powers: Array) -> Array:
    """Coefficients (P, d+1, 3) of powers of 1 - s, from those of powers of s."""
    signs = (-1.0) ** np.arange(powers.shape[1])
    return _shifted(powers, np.ones(len(powers))) * signs[:, None]


def _polynomial(powers: Array, low: Array, high: Array) -> Enclosure:
    """Bounds of a polynomial with coefficients (P, d+1) between ``low`` and ``high`` (P,).

    It is expanded about the middle, where all terms but the first few are small.
    """
    radius = 0.5 * (high - low)
    terms = _shifted(powers, 0.5 * (low + high))
    found = []
    for _ in range(3):
        middle = terms[:, 0] if terms.shape[1] else np.zeros_like(radius)
        ranks = np.arange(1, terms.shape[1])
        spread = (np.abs(terms[:, 1:]) * radius[:, None] ** ranks).sum(axis=1)
        found.append(Interval(middle - spread, middle + spread))
        terms = terms[:, 1:] * ranks
    return Enclosure(*found)


def _quotients(powers: Array, low: Array, high: Array) -> tuple[Enclosure, Enclosure]:
    """The first two of three polynomials over the third, the weight."""
    x, y, weight = (_polynomial(powers[..., k], low, high) for k in range(3))
    if (weight.value.low == 1).all() and (weight.value.high == 1).all():
        return x, y
    inverse = power(-1.0).of(weight)
    return x * inverse, y * inverse


def _either(where: Booleans, first: Interval, second: Interval) -> Interval:
    return Interval(
        np.where(where, first.low, second.low), np.where(where, first.high, second.high)
    )


def _by_share(
    by_root: Enclosure, powers: Array, side: Integers, begin: Array, end: Array
) -> Enclosure:
    """A coordinate by the share of its piece, from what it is by the root of the share.

    Where ``side`` (P,), as in :class:`Rationals`, is 0, it is given by the share. ``powers``
    (P, d+1, 2) are coefficients of the coordinate and of the weight.
    """
    with np.errstate(all="ignore"):
        pace = Interval(0.5 / end, 0.5 / begin)
        if (powers[:, 1:, 1] == 0).all():
            # There is no term of the root itself: the slope over it is a polynomial again.
            ranks = np.arange(2, powers.shape[1])
            slope = _polynomial(0.5 * ranks * powers[:, 2:, 0], begin, end)
            first, second = slope.value, slope.first * pace
        else:
            unknown = np.full_like(begin, np.nan)
            first, second = by_root.first * pace, Interval(unknown, unknown)
    return Enclosure(
        by_root.value,
        _either(side == 0, by_root.first, first.times(np.where(side > 0, -1.0, 1.0))),
        _either(side == 0, by_root.second, second),
    )

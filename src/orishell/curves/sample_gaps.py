"""Bounds of a curve between the samples of its trace, so that nothing is missed.

From one sample to the next the tangent is proved to stay within twice the trace's MAX_TURN of where
it starts, so the curve leaves the chord by at most MAX_TURN times the chord's length. In the
narrowest cells, which hold corners, the curve itself is proved to stay within NEAR times its whole
length of the chord. What cannot be bounded is refused.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.errors import CurveError
from orishell.conventions.record import record
from orishell.curves.checked import checked_jet
from orishell.curves.curve import Curve
from orishell.numerics import Enclosure, Interval
from orishell.numerics.arrays import Array, Booleans, Integers

BLOCK = 16
"""Number of cells that are bounded together at first."""
NEAR = 1e-6
"""A curve this near to a chord, relative to its length, is followed by it."""
SHORTEST_CHORD = 1e-9
"""Chords shorter than this, relative to the largest coordinate, have a direction that rounding of
their ends may turn by more than a millionth."""
FINEST = 2.0**-44
"""Narrowest parts of cells that are bounded, relative to the range."""
PARTS_AT_ONCE = 100_000
"""Most parts of cells that are bounded at a time."""

Boxes = tuple[Enclosure, Enclosure]


@record
class Samples:
    """Samples of a curve and the cells between them."""

    t: Array  # parameters (N,), increasing
    points: Array  # points (N, 2)
    # tangents at the beginning and the end of each cell, (N-1, 2) each
    leaving: Array
    arriving: Array

    def distinct(self) -> Booleans:
        """Whether a cell's chord (N-1,) is more than the rounding of its coordinates."""
        lengths = np.hypot(*np.diff(self.points, axis=0).T)
        return np.asarray(lengths > SHORTEST_CHORD * np.abs(self.points).max())

    def near_chords(self, boxes: Boxes, cell: Integers, reach: float) -> Booleans:
        """Whether all points in boxes (S,) are within a reach of the chords of cells (S,)."""
        start = self.points[cell]
        chord = self.points[cell + 1] - start
        length = np.hypot(chord[:, 0], chord[:, 1])
        u = np.where(length > 0, chord[:, 0] / length, 1.0)
        v = np.where(length > 0, chord[:, 1] / length, 0.0)
        x, y = boxes[0].value.plus(-start[:, 0]), boxes[1].value.plus(-start[:, 1])
        along, across = x.times(u) + y.times(v), y.times(u) - x.times(v)
        beyond = np.maximum(np.maximum(-along.low, along.high - length), 0.0)
        return np.asarray(np.hypot(beyond, across.magnitude()) <= reach)


@record
class _Parts:
    """Parts of cells, each from ``low`` to ``high`` (S,), with the tangents there (S, 2)."""

    low: Array
    high: Array
    leaving: Array
    arriving: Array
    cell: Integers

    def take(self, which: Booleans) -> _Parts:
        return _Parts(
            self.low[which],
            self.high[which],
            self.leaving[which],
            self.arriving[which],
            self.cell[which],
        )

    def halved(self, middle: Array, tangent: Array) -> _Parts:
        return _Parts(
            np.concatenate([self.low, middle]),
            np.concatenate([middle, self.high]),
            np.concatenate([self.leaving, tangent]),
            np.concatenate([tangent, self.arriving]),
            np.concatenate([self.cell, self.cell]),
        )

    def tame(self, boxes: Boxes, turn: float) -> Booleans:
        """In which parts the tangent provably stays within a turn of that at either end."""
        half = 0.5 * (self.high - self.low)
        x, y = boxes
        proved = np.ones(len(self.low), dtype=np.bool_)
        for tangent in (self.leaving, self.arriving):
            speed = np.hypot(tangent[:, 0], tangent[:, 1])
            u, v = tangent[:, 0] / speed, tangent[:, 1] / speed
            # From the bounds of the tangent itself, or in the half next to an end from those of
            # the second derivative.
            slope, sway = x.first.times(u) + y.first.times(v), y.first.times(u) - x.first.times(v)
            gain, bend = (
                x.second.times(u) + y.second.times(v),
                y.second.times(u) - x.second.times(v),
            )
            along = np.fmax(slope.low, speed - half * gain.magnitude())
            across = np.fmin(sway.magnitude(), half * bend.magnitude())
            proved &= across <= np.tan(turn) * along
        return proved

    def bend_little(self, x: Array, y: Array, turn: float) -> Booleans:
        """Which parts are tame by bounds (S,) of second derivatives alone: quick, often enough."""
        half = 0.5 * (self.high - self.low)
        proved = np.ones(len(self.low), dtype=np.bool_)
        for tangent in (self.leaving, self.arriving):
            u, v = np.abs(tangent[:, 0]), np.abs(tangent[:, 1])
            along = u * u + v * v - half * (x * u + y * v)
            proved &= (half * (x * v + y * u) <= np.tan(turn) * along) & (along > 0)
        return proved


def missing_samples(curve: Curve, samples: Samples, turn: float, smallest: float) -> Array:
    """Parameters (K,) at which samples are missing, because the curve leaves the chords there.

    ``turn`` is the largest turn of the tangent from sample to sample (radians); cells up to twice
    as wide as ``smallest`` may turn by more. CurveError if the curve cannot be bounded somewhere.
    """
    t = samples.t
    reach = NEAR * float(np.hypot(*np.diff(samples.points, axis=0).T).sum())
    widths = np.diff(t)
    smooth = samples.distinct() & (widths > 2 * smallest)
    missing, lacking = [t[:0]], np.zeros(len(widths), dtype=np.bool_)
    parts = _Parts(t[:-1], t[1:], samples.leaving, samples.arriving, np.arange(len(widths)))
    with np.errstate(all="ignore"):
        parts = parts.take(~parts.bend_little(*_largest_bends(curve, t), turn))
        while len(parts.low):
            boxes = curve.enclosure(parts.low, parts.high)
            width, whole = parts.high - parts.low, widths[parts.cell]
            near = samples.near_chords(boxes, parts.cell, reach)
            narrow, known = width <= 2 * smallest, smooth[parts.cell]
            tame = parts.tame(boxes, turn) & (known | (width == whole))
            rough = ~(tame | (near & (narrow | ~known)))
            # A part that is this narrow and away from the chord gets a chord of its own.
            away = rough & narrow & (whole > 2 * smallest)
            missing += [parts.low[away], parts.high[away]]
            lacking[parts.cell[away]] = True
            rough &= ~lacking[parts.cell]
            parts = parts.take(rough)
            middle = 0.5 * (parts.low + parts.high)
            _require_divisible(curve, parts, middle, _bounded(boxes)[rough])
            point, tangent, _ = checked_jet(curve, middle)
            off = np.where(
                smooth[parts.cell],
                _angles(samples.leaving[parts.cell], tangent) > turn,
                ~samples.near_chords(_as_boxes(point), parts.cell, reach),
            )
            missing.append(middle[off])
            lacking[parts.cell[off]] = True
            parts = parts.halved(middle, tangent)
            parts = parts.take(~lacking[parts.cell])
    return np.setdiff1d(np.concatenate(missing), t)


def _largest_bends(curve: Curve, t: Array) -> tuple[Array, Array]:
    """Bounds of second derivatives in all cells, in blocks of cells if the curve has no breaks."""
    if curve.breaks:
        x, y = curve.enclosure(t[:-1], t[1:])
        return x.second.magnitude(), y.second.magnitude()
    last = len(t) - 1
    first = np.arange(0, last, BLOCK)
    block = np.arange(last) // BLOCK
    x, y = curve.enclosure(t[first], t[np.minimum(first + BLOCK, last)])
    return x.second.magnitude()[block], y.second.magnitude()[block]


def _bounded(boxes: Boxes) -> Booleans:
    reach = boxes[0].value.magnitude() + boxes[1].value.magnitude()
    return np.asarray(np.isfinite(reach))


def _as_boxes(points: Array) -> Boxes:
    x, y = (Enclosure(*[Interval(each, each)] * 3) for each in points.T)
    return x, y


def _angles(a: Array, b: Array) -> Array:
    """Angles between vectors (S, 2), not negative."""
    cross = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    return np.asarray(np.abs(np.arctan2(cross, (a * b).sum(axis=1))))


def _require_divisible(curve: Curve, parts: _Parts, middle: Array, known: Booleans) -> None:
    """Refuse parts too narrow to be halved, or too many; ``known`` are those that are bounded."""
    stuck = parts.high - parts.low <= FINEST * (curve.stop - curve.start)
    stuck |= ~((parts.low < middle) & (middle < parts.high))
    many = len(middle) > PARTS_AT_ONCE
    if not (many or stuck.any()):
        return
    k = int(np.argmax(~known if many else stuck))
    raise CurveError(
        "the curve is not bounded, or not defined"
        if not known[k]
        else "the curve turns too often to be followed, or large terms of its formula cancel"
        if many
        else "the curve jumps, or swings faster than it can be followed",
        where=f"at parameter {curve.as_drawn(middle[k]):.10g}",
        remedy="choose a range without this point",
    )

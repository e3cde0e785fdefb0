"""A curve followed closely enough that everything else can work on its samples.

The samples sit where the curve turns: between neighbours the tangent turns by at most
:data:`MAX_TURN`, except at corners, which are found and kept apart.
"""

from __future__ import annotations

from dataclasses import field, replace

import numpy as np

from orishell.conventions.errors import CurveError
from orishell.conventions.record import record
from orishell.curves.checked import checked_jet, least_within, require_length, require_speed
from orishell.curves.curve import Curve
from orishell.curves.memo import remembered
from orishell.curves.sample_gaps import Samples, missing_samples
from orishell.numerics.arrays import Array, Booleans, Integers, nearby_origin

MAX_TURN = 0.004
"""Largest turn of the tangent from sample to sample (radians)."""
CORNER = 0.05
"""A turn larger than this within the smallest cell is a corner of the curve (radians)."""
KINK = 1e-6
"""A jump of the tangent up to this is no corner (radians): drawn joints are no more exact."""
FIRST_CELLS = 1024
SMALLEST_CELL = 2.0**-24
"""Smallest distance of samples in the parameter, relative to the range."""
MAX_SAMPLES = 400_000
QUADRATURE = 1e-6
"""A chord longer than a cell's quadrature by more than this share shows a corner in the cell."""


@record
class Trace:
    """Dense samples of a curve."""

    curve: Curve  # the curve itself
    t: Array  # parameters (N,), increasing
    points: Array  # points (N, 2)
    arc: Array  # arc length from the start (N,)
    # direction of the tangent leaving each sample (N,), radians, continuous but for corners, where
    # it jumps by the corner's turn
    heading: Array
    # direction of the tangent arriving at each sample (N,); equal to ``heading`` but at corners
    arriving: Array
    # where the origin of the points' frame lies on the drawing (2,), turned as the curve is
    origin: Array = field(default_factory=lambda: np.zeros(2))

    @property
    def length(self) -> float:
        """Arc length of the curve."""
        return float(self.arc[-1])

    @property
    def turns(self) -> Array:
        """How the curve turns from sample to sample (N-1,), but for corners (radians)."""
        return np.asarray(self.arriving[1:] - self.heading[:-1])

    @property
    def corners(self) -> Integers:
        """Indices (K,) of the inner samples at which the tangent jumps."""
        return np.flatnonzero(np.abs(self.heading - self.arriving) > KINK)

    def reversed(self) -> Trace:
        """The trace, run through from the last sample to the first."""
        start, stop = self.curve.start, self.curve.stop
        inner = (start + stop) - self.t[-2:0:-1]
        return Trace(
            self.curve.reversed(),
            np.concatenate([[start], inner, [stop]]),  # the ends without rounding
            self.points[::-1],
            self.arc[-1] - self.arc[::-1],
            self.arriving[::-1] + np.pi,
            self.heading[::-1] + np.pi,
            self.origin,
        )

    def rotated(self, angle: float) -> Trace:
        """The curve's trace, turned counter-clockwise about the origin by ``angle`` (radians)."""
        cos, sin = np.cos(angle), np.sin(angle)
        turn = np.array([[cos, sin], [-sin, cos]])
        return Trace(
            self.curve.rotated(angle),
            self.t,
            self.points @ turn,
            self.arc,
            self.heading + angle,
            self.arriving + angle,
            self.origin @ turn,
        )

    def in_own_frame(self) -> Trace:
        """The trace in a frame near it, see ``nearby_origin``; itself if it is near already."""
        return _in_own_frame(self)

    def bounding_box(self) -> tuple[Array, Array]:
        """Lower left and upper right corner, (2,) each."""
        return self.points.min(axis=0), self.points.max(axis=0)

    def parameter_at(self, arc: Array) -> Array:
        """Parameters (...) at arc lengths (...), by interpolation between samples."""
        return np.interp(arc, self.arc, self.t)

    def heading_at(self, t: Array) -> Array:
        """Direction of the tangent (...) at t (...), radians; at corners the mean of both sides."""
        first = self.curve.jet(t)[1]
        direction = np.arctan2(first[..., 1], first[..., 0])
        at = np.clip(np.searchsorted(self.t, t), 0, len(self.t) - 1)
        at_sample = self.t[at] == t
        middle = 0.5 * (self.heading[at] + self.arriving[at])
        return np.where(at_sample, middle, direction)

    def heading_range(self) -> tuple[float, float]:
        """Smallest and largest direction of the tangent, radians, on the branch of ``heading``."""
        extremes = []
        for sign in (1.0, -1.0):
            both = np.maximum(sign * self.heading, sign * self.arriving)
            k = int(np.argmax(both))
            best = float(both[k])
            lo, hi = self.t[max(k - 1, 0)], self.t[min(k + 1, len(self.t) - 1)]
            corner = np.isin([k - 1, k, k + 1], self.corners).any()
            if not corner and 0 < k < len(self.t) - 1:
                base = self.heading[k]

                def climb(t: Array, sign: float = sign, base: float = base) -> Array:
                    first = self.curve.jet(t)[1]
                    turn = np.arctan2(first[..., 1], first[..., 0]) - base
                    wrapped = np.mod(turn + np.pi, 2 * np.pi) - np.pi
                    return np.asarray(-sign * (base + wrapped))

                _, lowest = least_within(climb, np.array([lo]), np.array([hi]))
                best = max(best, -float(lowest[0]))
            extremes.append(sign * best)
        return extremes[1], extremes[0]


def trace_curve(curve: Curve, name: str = "") -> Trace:
    """Sample a curve adaptively; refuse one that breaks off, stands still or turns too often.

    Parameters
    ----------
    name
        What errors call it, for example "f".

    Raises
    ------
    CurveError
        If the curve is not finite, jumps, stands still (zero tangent), turns back on itself
        (a cusp), turns too often to be followed, or is too short.
    """
    try:
        return _trace(curve)
    except CurveError as error:
        raise error.located(name) from None


@remembered
def _in_own_frame(trace: Trace) -> Trace:
    shift = nearby_origin(trace.points)
    if not shift.any():
        return trace
    return replace(
        trace,
        curve=trace.curve.shifted(-shift),
        points=trace.points - shift,
        origin=trace.origin + shift,
    )


@remembered
def _trace(curve: Curve) -> Trace:
    t = np.union1d(np.linspace(curve.start, curve.stop, FIRST_CELLS + 1), curve.breaks)
    position, first, _ = checked_jet(curve, t)
    smallest = SMALLEST_CELL * (curve.stop - curve.start)
    while True:
        samples = Samples(t, position, *_ends(curve, t, first))
        bad = _turning_cells(samples) & (np.diff(t) > 2 * smallest)
        missing = (0.5 * (t[:-1] + t[1:]))[bad]
        if not len(missing):
            _check_leaps(curve, samples)
            missing = missing_samples(curve, samples, MAX_TURN, smallest)
        if not len(missing):
            break
        if len(t) + len(missing) > MAX_SAMPLES:
            raise CurveError(
                "the curve turns too often to be followed",
                where=f"at parameter {curve.as_drawn(missing[0]):.10g}",
                expected=f"at most {MAX_SAMPLES * MAX_TURN:g} radians of turning in all",
                remedy="smooth it, give fewer points, or set smooth = false",
            )
        new_position, new_first, _ = checked_jet(curve, missing)
        at = np.searchsorted(t, missing)
        t = np.insert(t, at, missing)
        position = np.insert(position, at, new_position, axis=0)
        first = np.insert(first, at, new_first, axis=0)

    arc = _arc_length(curve, t, position)
    require_length(position, arc)
    require_speed(curve, t, first, arc[-1])
    heading, arriving = _headings(curve, t, position, first)
    return Trace(curve, t, position, arc, heading, arriving)


def _angle(u: Array, v: Array) -> Array:
    """Signed angle from vectors u (..., 2) to v (..., 2)."""
    cross = u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0]
    return np.asarray(np.arctan2(cross, (u * v).sum(axis=-1)))


def _ends(curve: Curve, t: Array, first: Array) -> tuple[Array, Array]:
    """Tangents leaving each cell's first sample and arriving at its last, (N-1, 2) each."""
    leaving, arriving = first[:-1], first[1:]
    if curve.breaks:
        at = np.searchsorted(t, curve.breaks)
        arriving = arriving.copy()
        arriving[at - 1] = curve.jet(np.nextafter(t[at], -np.inf))[1]
    return leaving, arriving


def _turning_cells(samples: Samples) -> Booleans:
    """Cells in which the tangent, or the chord against it, turns by more than MAX_TURN."""
    leaving, arriving = samples.leaving, samples.arriving
    chord = np.diff(samples.points, axis=0)
    turn = np.maximum(np.abs(_angle(leaving, chord)), np.abs(_angle(chord, arriving)))
    turning = np.maximum(np.abs(_angle(leaving, arriving)), turn) > MAX_TURN
    # Cells lost in the rounding of the coordinates cannot be refined.
    return np.asarray(turning & samples.distinct())


def _headings(curve: Curve, t: Array, position: Array, first: Array) -> tuple[Array, Array]:
    leaving, arriving = _ends(curve, t, first)
    turn = _angle(leaving, arriving)
    inside = np.abs(turn) > CORNER  # a corner inside the smallest cell: put it at the cell's end
    jump = np.zeros(len(t))
    jump[1:] = np.where(inside, turn, 0.0)
    jump[1:-1] += _angle(arriving[:-1], leaving[1:])
    sharp = np.abs(jump) > np.pi - 1e-3
    if sharp.any():
        at = t[np.argmax(sharp)]
        raise CurveError(
            "the curve turns back on itself",
            where=f"at parameter {curve.as_drawn(at):.10g}",
            remedy="split it there",
        )
    smooth_turn = np.where(inside, 0.0, turn)
    start = np.arctan2(first[0, 1], first[0, 0])
    heading = start + np.concatenate([[0.0], np.cumsum(smooth_turn)]) + np.cumsum(jump)
    return heading, heading - jump


def _check_leaps(curve: Curve, samples: Samples) -> None:
    """Refuse jumps (a chord longer than the tangents allow) and poles (a chord against them)."""
    t, leaving, arriving = samples.t, samples.leaving, samples.arriving
    chord = np.diff(samples.points, axis=0)
    speed = np.maximum(np.hypot(*leaving.T), np.hypot(*arriving.T))
    against = ((chord * leaving).sum(axis=1) < 0) & ((chord * arriving).sum(axis=1) < 0)
    leap = against | (np.hypot(*chord.T) > 10 * speed * np.diff(t))
    if leap.any():
        raise CurveError(
            "the curve jumps, or swings faster than it can be followed",
            where=f"at parameter {curve.as_drawn(t[np.argmax(leap)]):.10g}",
            remedy="choose a range without this point",
        )


def _arc_length(curve: Curve, t: Array, position: Array) -> Array:
    """Arc length at the samples (N,), by three-point Gauss quadrature in every cell.

    At least the chord, which is closer in a cell at a corner.
    """
    node = np.sqrt(0.6)
    half = 0.5 * np.diff(t)
    middle = t[:-1] + half
    nodes = middle[:, None] + half[:, None] * np.array([-node, 0.0, node])
    first = curve.jet(nodes)[1]
    cells = half * (np.hypot(first[..., 0], first[..., 1]) @ np.array([5.0, 8.0, 5.0])) / 9
    chords = np.hypot(*np.diff(position, axis=0).T)
    rounding = 4 * np.spacing(np.abs(position).max())
    cells = np.where(chords > (1 + QUADRATURE) * cells + rounding, chords, cells)
    return np.concatenate([[0.0], np.cumsum(cells)])

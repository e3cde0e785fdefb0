"""The admissible headings: exactly, from one trigonometric inequality for each column.

With the heading theta (the angle from f's plane to g's x axis), vertex j of g's polyline lies
along t by Re((g_j - g_1) exp(i theta)), its segment k makes with t the angle eps_k = theta + its
direction. A heading is admissible where all eps lie in (0, pi), so that every segment goes from
plane to plane, and all columns, flaps too, are shifted so little that every column edge keeps a
positive length. The paper's condition pi/2 < alpha_0 < (pi + beta_mid)/2 is neither.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from orishell.conventions.formatting import tidy_degrees
from orishell.conventions.record import record
from orishell.design import FlapSide, Parameter
from orishell.numerics.arrays import Array, Complex
from orishell.numerics.equals import first_largest, first_smallest
from orishell.polylines import Zigzag

SMALLEST_EPS = 1e-6
"""Segments of g keep this angle from f's plane (radians)."""
NARROWEST = 1e-6
"""Narrower intervals of headings hold none that can be typed (radians)."""

SideChoice = FlapSide | None


@record
class HeadingConditions:
    """The conditions that a heading must satisfy."""

    points: Complex  # vertices (n,) of g's polyline, in g's own axes
    gain: float  # cos(beta_mid/2): K of a column by how far it lies along t
    limits: tuple[float, float]  # open interval in which K of every column must lie; it holds 0
    flap: float | None  # width of the flaps, 0 if there are none; None: as wide as there is room
    # to which end of f the left and the right flap fold, or None: where there is more room
    sides: tuple[SideChoice, SideChoice]

    def of(self, zigzag: Zigzag) -> HeadingConditions:
        """The conditions with another zigzag."""
        gain = float(np.cos(zigzag.angles[len(zigzag.angles) // 2] / 2))
        return replace(self, gain=gain, limits=zigzag.shift_limits())

    def scaled(self, factor: float) -> HeadingConditions:
        """The conditions with g enlarged."""
        return replace(self, points=self.points * factor)

    def eps(self, heading: float) -> Array:
        """Angles (n-1,) of g's segments from t, in [-pi/2, 3 pi/2) (radians)."""
        turned = heading + np.angle(np.diff(self.points))
        return np.asarray(np.mod(turned + np.pi / 2, 2 * np.pi) - np.pi / 2)

    def shifts(self, heading: float) -> Array:
        """Shifts K (n,) of columns 1 ... n."""
        along = ((self.points - self.points[0]) * np.exp(1j * heading)).real
        return np.asarray(self.gain * along)

    def rooms(self, heading: float) -> tuple[tuple[float, float], tuple[float, float]]:
        """Widest left and right flap that can fold to the start and to the end of f."""
        low, high = self.limits
        last = float(self.shifts(heading)[-1])
        return (-low, high), (last - low, high - last)

    def flap_sides(self, heading: float) -> tuple[FlapSide, FlapSide]:
        """The end of f to which each flap folds: as asked for, or where there is more room."""

        def choose(side: SideChoice, room: tuple[float, float]) -> FlapSide:
            if side is not None:
                return side
            return "start" if room[0] > room[1] * (1 + 1e-9) else "end"

        left, right = self.rooms(heading)
        return choose(self.sides[0], left), choose(self.sides[1], right)

    def side_choices(self, heading: float) -> list[tuple[FlapSide, FlapSide]]:
        """The sides of :meth:`flap_sides` first, then all others that the request leaves open."""
        chosen = self.flap_sides(heading)
        others: dict[FlapSide, FlapSide] = {"start": "end", "end": "start"}
        left, right = (
            (side,) if asked else (side, others[side])
            for side, asked in zip(chosen, self.sides, strict=True)
        )
        return [(first, second) for first in left for second in right]

    def room(self, heading: float) -> float:
        """The widest flap that both sides have room for."""
        sides = self.flap_sides(heading)
        rooms = self.rooms(heading)
        return min(room[side == "end"] for room, side in zip(rooms, sides, strict=True))

    def crossing_intervals(self) -> Array:
        """Headings (k, 2) in [0, pi] at which every segment goes from plane to plane."""
        return _complement(self._crossing())

    def intervals(self) -> Array:
        """Admissible headings (k, 2) in [0, pi], open intervals (radians)."""
        return _complement(np.concatenate([self._crossing(), self._edges(), self._flaps()]))

    def interval(self, heading: float) -> tuple[float, float]:
        """The admissible interval nearest to a heading; empty at the heading if there is none."""
        return nearest_interval(self.intervals(), heading) or (heading, heading)

    def admit(self, heading: float) -> bool:
        """Whether a heading is admissible."""
        return holds(nearest_interval(self.intervals(), heading), heading)

    def _crossing(self) -> Array:
        # sin(eps) <= 0, widened by SMALLEST_EPS
        direction = np.angle(np.diff(self.points)) - np.pi / 2
        return _arcs(direction, -np.inf, np.sin(SMALLEST_EPS))

    def _edges(self) -> Array:
        phase, radius = self._polar()
        low, high = self.limits
        below = _arcs(phase, -np.inf, _share(low, radius))
        return np.concatenate([below, _arcs(phase, _share(high, radius), np.inf)])

    def _flaps(self) -> Array:
        everything, nothing = np.array([[0.0, np.pi]]), np.empty((0, 2))
        if not self.flap:
            return nothing
        (low, high), width = self.limits, self.flap
        left = {"start": width < -low, "end": width < high}
        if not (left[self.sides[0]] if self.sides[0] else any(left.values())):
            return everything
        phase, radius = (values[-1:] for values in self._polar())
        begin, end = _share(high - width, radius), _share(low + width, radius)
        if self.sides[1] == "end":
            return _arcs(phase, begin, np.inf)
        return _arcs(phase, -np.inf if self.sides[1] == "start" else begin, end)

    def _polar(self) -> tuple[Array, Array]:
        """Phase and radius of columns 2 ... n: K of a column is radius cos(heading + phase)."""
        from_first = self.gain * (self.points[1:] - self.points[0])
        return np.angle(from_first), np.abs(from_first)


def describe_heading(
    heading: float,
    zigzag: Zigzag,
    headings: HeadingConditions,
    demands: Sequence[HeadingConditions],
    *,
    refitted: bool,
) -> dict[str, Parameter]:
    """What the report says of a heading, and of the paper's alpha_0 (step 3).

    demands: Conditions of all zigzags: a heading is admissible where one of them admits it.
    refitted: Whether g's polyline is another one at another heading, so that there is no interval.
    """

    def alpha_0(heading: float) -> float:
        """cos alpha_0 = sin(beta_mid/2) cos eps_1."""
        sine = np.sin(zigzag.angles[len(zigzag.angles) // 2] / 2)
        return tidy_degrees(float(np.arccos(sine * np.cos(headings.eps(heading)[0]))))

    found: dict[str, Parameter] = {"heading_deg": tidy_degrees(heading)}
    if refitted:
        return {**found, "alpha_0_deg": alpha_0(heading)}
    admissible = union(np.concatenate([each.intervals() for each in demands]))
    interval = nearest_interval(admissible, heading) or (heading, heading)
    return {
        **found,
        "heading_interval_deg": [tidy_degrees(angle) for angle in interval],
        "alpha_0_deg": alpha_0(heading),
        "alpha_0_interval_deg": [alpha_0(angle) for angle in headings.interval(heading)],
    }


def union(intervals: Array) -> Array:
    """Open intervals (k, 2) with those that overlap joined."""
    joined: list[list[float]] = []
    for low, high in sorted(intervals.tolist()):
        if joined and low < joined[-1][1]:
            joined[-1][1] = max(joined[-1][1], high)
        else:
            joined.append([low, high])
    return np.array(joined).reshape(-1, 2)


def nearest_interval(intervals: Array, heading: float) -> tuple[float, float] | None:
    """The interval (of k, 2) that holds a heading or is nearest to it; None if there is none.

    Intervals in which nobody can type a heading do not count, unless they hold this one.
    """
    away = np.maximum(intervals[:, 0] - heading, heading - intervals[:, 1])
    usable = intervals[(away <= 0) | (np.diff(intervals)[:, 0] > NARROWEST)]
    if not len(usable):
        return None
    away = np.maximum(usable[:, 0] - heading, heading - usable[:, 1])
    low, high = usable[first_smallest(away, size=np.pi)]
    return float(low), float(high)


def holds(interval: tuple[float, float] | None, heading: float) -> bool:
    """Whether a heading lies in an open interval; 0 and pi count as inside if they bound it."""
    if interval is None:
        return False
    low, high = interval
    return (low < heading or heading == low == 0) and (heading < high or heading == high == np.pi)


def _share(limit: float, radius: Array) -> Array:
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray(limit / radius)


def _arcs(phase: Array, low: Array | float, high: Array | float) -> Array:
    """Headings in [0, pi] (k, 2) at which low <= cos(heading + phase) <= high."""
    phase, low, high = np.broadcast_arrays(phase, low, high)
    some = (low <= 1) & (high >= -1) & (low <= high)
    phase, low, high = phase[some], low[some], high[some]
    begin, end = np.arccos(np.minimum(high, 1.0)), np.arccos(np.maximum(low, -1.0))
    arcs = np.concatenate(
        [np.stack([begin - phase, end - phase], -1), np.stack([-end - phase, -begin - phase], -1)]
    )
    turns = 2 * np.pi * np.array([-1.0, 0.0, 1.0])[:, None, None]
    everywhere = (arcs + turns).reshape(-1, 2)
    clipped = np.clip(everywhere, 0.0, np.pi)
    return np.asarray(clipped[(everywhere[:, 1] >= 0) & (everywhere[:, 0] <= np.pi)])


def _complement(excluded: Array) -> Array:
    """The open intervals (k', 2) of [0, pi] outside closed intervals (k, 2)."""
    order = excluded[np.argsort(excluded[:, 0])]
    reached = np.maximum.accumulate(np.concatenate([[0.0], order[:, 1]]))
    begin, end = reached, np.concatenate([order[:, 0], [np.pi]])
    free = end > begin
    return np.stack([begin[free], end[free]], axis=-1)


def headings_of(
    zigzag: Zigzag,
    vertices: Array,
    flap: float | None = None,
    sides: tuple[SideChoice, SideChoice] = (None, None),
) -> HeadingConditions:
    """The conditions on the heading that a zigzag and g's polyline (n, 2) set."""
    points = vertices @ np.array([1, 1j])
    return HeadingConditions(points, 1.0, (-np.inf, np.inf), flap, sides).of(zigzag)


def choose_heading(demands: Sequence[HeadingConditions]) -> float:
    """A right angle if it is admissible, else the middle of the widest admissible interval."""
    right = float(np.pi / 2)
    intervals = np.concatenate([headings.intervals() for headings in demands])
    if not len(intervals) or any(headings.admit(right) for headings in demands):
        return right
    return float(intervals[first_largest(np.diff(intervals)[:, 0])].mean())

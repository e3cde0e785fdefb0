"""The target: a convex curve f swept along a straight line g."""

from __future__ import annotations

import numpy as np

from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.formatting import in_degrees, inside, rounded
from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.curves import Trace, run_along_axis
from orishell.curves.plane import extent_across
from orishell.families.shared.candidates import part
from orishell.numerics.arrays import Array
from orishell.numerics.equals import first_largest

STRAIGHT = 1e-6
"""A g that leaves a line by no more than this share of its length is straight."""
TURNING_BACK = 1e-6
"""f's tangent may turn back by this much (radians)."""


@record
class Line:
    """The straight line g."""

    trace: Trace
    start: Array  # (2,)
    direction: Array  # unit vector (2,)
    length: float

    @classmethod
    def along(cls, trace: Trace) -> Line:
        """The line of a trace; refuse one that is not straight."""
        chord = trace.points[-1] - trace.points[0]
        length = float(np.hypot(*chord))
        leaves = extent_across(trace.points)
        if leaves > STRAIGHT * trace.length or length < (1 - STRAIGHT) * trace.length:
            normal = np.array([-chord[1], chord[0]])
            worst = first_largest(np.abs((trace.points - trace.points[0]) @ normal))
            along = rounded(trace.length / trace.curve.scale[0], 6)
            raise DesignError(
                "g is not straight, and this family sweeps along a straight line only",
                place=f"at parameter {trace.curve.as_drawn(trace.t[worst]):.6g} of g",
                size=f"g leaves a straight line by {plain(leaves)}; it is "
                f"{plain(trace.length)} long",
                candidates=[Remedy({"target.g.formula": "0*x", "target.g.range": [0.0, along]})],
                excess=max(leaves / trace.length, 1 - length / trace.length) - STRAIGHT,
            )
        return cls(trace, trace.points[0], chord / length, length)


@record
class Profile:
    """The convex curve f, run through in the direction of its x axis."""

    trace: Trace  # The curve
    side: int  # +1 if it turns to the right (an arch), -1 if to the left (a trough)

    @classmethod
    def of(cls, trace: Trace) -> Profile:
        """The profile of a trace; refuse one that is not convex, or does not turn at all."""
        trace = run_along_axis(trace)
        turned = float(trace.heading[-1] - trace.heading[0])
        spread = float(np.ptp([trace.heading, trace.arriving]))
        if spread < TURNING_BACK:
            raise DesignError(
                "f is straight, but the rows of this family all turn the same way",
                excess=1 - spread / TURNING_BACK,
            )
        side = -1 if turned > 0 else 1
        back = -side * np.stack([trace.arriving, trace.heading]).T.ravel()
        fall = np.maximum.accumulate(back) - back
        if fall.max() > TURNING_BACK:
            raise _not_convex(trace, fall.max())
        return cls(trace, side)

    @property
    def turning(self) -> float:
        """How much f turns in all (radians, positive)."""
        return float(abs(self.trace.heading[-1] - self.trace.heading[0]))

    def polygon(self, shares: Array) -> Array:
        """The polygon (m+2, 2) closest to f whose edges turn by given shares of f's turning.

        Its edges are parallel to tangents of f, moved inwards so that f passes midway between
        edges and vertices; it begins and ends square to f's ends. Of the shares (m+2,) half the
        first and the last are spent beyond the ends.
        """
        trace = self.trace
        before = np.cumsum(np.concatenate([[0.5 * shares[0]], shares[1:-1]]))
        directions = trace.heading[0] - self.side * self.turning * before
        points = self._touching(directions)
        unit = np.stack([np.cos(directions), np.sin(directions)], axis=-1)
        inwards = self.side * np.stack([unit[:, 1], -unit[:, 0]], axis=-1)
        corners = _intersections(points, unit)
        overshoot = np.zeros(len(points) + 1)
        overshoot[1:-1] = 0.5 * _distances(corners, points[:-1], points[1:])
        share = np.full(len(points), 0.25)
        share[[0, -1]] = 0.5
        moved = points + (share * (overshoot[:-1] + overshoot[1:]))[:, None] * inwards
        corners = _intersections(moved, unit)
        ends = [moved[k] + ((trace.points[k] - moved[k]) @ unit[k]) * unit[k] for k in (0, -1)]
        return np.concatenate([ends[:1], corners, ends[1:]])

    def _touching(self, directions: Array) -> Array:
        """Points of f (K, 2) at which its tangent has given directions; on corners, the corner."""
        trace = self.trace
        turned = -self.side * np.stack([trace.arriving, trace.heading]).T.ravel()
        t = np.interp(-self.side * directions, np.maximum.accumulate(turned), np.repeat(trace.t, 2))
        return trace.curve.position(t)


def _not_convex(trace: Trace, back: float) -> DesignError:
    """The error for an f that is not convex: its first inflection, its longest convex part."""
    steps = np.sign(np.where(np.abs(np.diff(trace.heading)) > 1e-9, np.diff(trace.heading), 0.0))
    turning = np.flatnonzero(steps)
    change = turning[np.flatnonzero(np.diff(steps[turning]))]
    places = trace.t[np.concatenate([[0], change + 1, [len(trace.t) - 1]])]
    longest = first_largest(np.diff(places))
    low, high = places[longest], places[longest + 1]
    middle = float(0.5 * (low + high))
    low, high = (inside(float(end), middle) for end in (low, high))
    spread = trace.heading.max() - trace.heading.min()
    return DesignError(
        "f is not convex, but the rows of this family all turn the same way",
        place=f"at parameter {trace.curve.as_drawn(places[1]):.6g} of f",
        size=f"f turns the other way from there, its tangents spreading over {in_degrees(spread)} "
        "degrees",
        candidates=[part("f", trace.curve, low, high)],
        excess=back / np.pi,
    )


def _intersections(points: Array, unit: Array) -> Array:
    """Where each line (a point and a direction) meets the next, (K-1, 2)."""
    p, q, u, v = points[:-1], points[1:], unit[:-1], unit[1:]
    cross = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
    gap = q - p
    along = (gap[:, 0] * v[:, 1] - gap[:, 1] * v[:, 0]) / cross
    return np.asarray(p + along[:, None] * u)


def _distances(points: Array, start: Array, end: Array) -> Array:
    """Distances of points from the lines through start and end, all (K, 2)."""
    chord = end - start
    gap = points - start
    size = np.hypot(chord[:, 0], chord[:, 1])
    cross = chord[:, 0] * gap[:, 1] - chord[:, 1] * gap[:, 0]
    return np.asarray(np.abs(cross) / np.where(size > 0, size, 1.0))

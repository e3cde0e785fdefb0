"""Staircases that take a curve's place: which exist, and what would work where none does.

f has one in the parallel repeating family, g in the orthodiagonal one.
"""

from __future__ import annotations

from itertools import chain

import numpy as np

from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.formatting import in_degrees
from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.curves import Trace
from orishell.families.shared.candidates import angles, part, turned_to
from orishell.numerics.equals import first_largest
from orishell.polylines import (
    Staircase,
    choose_xi,
    fit_staircase,
    theta_interval,
    xi_limit,
)

NARROWEST_XI = np.deg2rad(0.1)
"""Angles below this are not offered: the corrugation would be deeper than the shell is wide."""
ROOM = (0.95, 0.8, 0.6)
"""Shares of the admissible turning that parts of a curve use: some must be left for xi."""


@record
class Followed:
    """How a family speaks of a curve that a staircase follows."""

    name: str  # "f" or "g"
    # keys of the angle between the staircase's edges and of the curve's rotation
    xi: str
    theta: str
    # what the key of the rotation says where there is none, and how far it reaches from that to
    # either side (radians)
    unturned: float
    farthest: float
    axis: str  # what the staircase's axis is
    instead: Remedy  # what else takes a curve that turns too much for it

    def interval(self, low: float, high: float, xi: float | None) -> tuple[float, float]:
        """The rotations that its key can say at which a curve has a staircase (radians).

        low, high: Range of the curve's tangent directions, not turned. Without xi: of any angle.
        """
        begin, end = theta_interval(low, high, xi or 0.0)
        return max(begin, -self.farthest), min(end, self.farthest)

    def turns(self, trace: Trace, xi: float | None) -> tuple[float, float]:
        """Rotations at which a curve, not turned, has a staircase (radians); refuse one without."""
        low, high = trace.heading_range()
        begin, end = self.interval(low, high, xi)
        if end - begin <= NARROWEST_XI:
            raise self._too_much_turning(trace, high - low, xi)
        return begin, end

    def fit(self, trace: Trace, theta: float, xi: float | None, edges: int) -> Staircase:
        """The staircase of a curve that is turned by theta; without xi, the best of any angle.

        There is one if every tangent lies within (pi - xi)/2 of the axis, which is the paper's
        condition under equation (1).
        """
        self._require(trace, xi, theta)
        return fit_staircase(trace, choose_xi(trace, edges) if xi is None else xi, edges)

    def warn_of_imbalance(self, staircase: Staircase) -> tuple[str, ...]:
        """Warn of a staircase that is not proved to be the closest."""
        if staircase.balanced:
            return ()
        return (
            f"a staircase closer to {self.name} than {plain(staircase.distance)} may exist, but "
            "was not found",
        )

    def _require(self, trace: Trace, xi: float | None, theta: float) -> None:
        low, high = trace.heading_range()
        limit = xi_limit(low, high)
        if (NARROWEST_XI if xi is None else xi) < limit:
            return
        reached = f"its tangents reach {in_degrees(max(-low, high))} degrees from {self.axis}"
        begin, end = self.interval(low - theta, high - theta, xi)
        shift = self.unturned
        turns = angles(self.theta, begin + shift, end + shift, theta + shift)
        place = self._steepest_place(trace, theta)
        excess = ((NARROWEST_XI if xi is None else xi) - limit) / np.pi
        if limit > NARROWEST_XI and xi is not None:
            raise DesignError(
                f"{self.xi} = {in_degrees(xi)} is too large for {self.name}",
                keys=(f"pattern.{self.xi}",),
                place=place,
                size=f"{reached} and may reach only {in_degrees((np.pi - xi) / 2)}; {self.xi} must "
                f"stay below {in_degrees(limit)}",
                candidates=chain(angles(self.xi, 0.0, limit, xi), turns),
                excess=excess,
            )
        if end - begin <= NARROWEST_XI:
            raise self._too_much_turning(trace, high - low, xi)
        raise DesignError(
            f"{self.name} has no staircase for {self.theta} = {in_degrees(theta + shift)}, "
            f"whatever {self.xi} is",
            keys=(f"pattern.{self.theta}",),
            place=place,
            size=f"{reached} and must stay below 90; {self.theta} must lie between "
            f"{in_degrees(begin + shift)} and {in_degrees(end + shift)}",
            candidates=turns,
            excess=excess,
        )

    def _too_much_turning(self, trace: Trace, spread: float, xi: float | None) -> DesignError:
        allowed = np.pi - (xi or 0.0)
        rotated = Remedy({f"pattern.{self.theta}": "auto"})
        candidates = []
        if xi is not None and np.pi - spread > NARROWEST_XI:
            candidates += [each | rotated for each in angles(self.xi, 0.0, np.pi - spread, xi)]
        for room in ROOM:
            end = turned_to(trace, room * allowed)
            candidates.append(part(self.name, trace.curve, trace.t[0], end) | rotated)
        walls = spread >= np.pi
        candidates.insert(0 if walls else len(candidates), self.instead)
        return DesignError(
            f"{self.name} turns too much for a staircase, whatever its rotation",
            size=f"its tangents spread over {in_degrees(spread)} degrees and may spread over less "
            f"than {in_degrees(allowed)}",
            candidates=candidates,
            excess=(spread - allowed) / np.pi,
        )

    def _steepest_place(self, trace: Trace, theta: float) -> str:
        """Where on the curve, as it was drawn, the tangent is farthest from the axis."""
        k = first_largest(np.maximum(np.abs(trace.heading), np.abs(trace.arriving)))
        drawn = trace.rotated(-theta)
        x, y = drawn.points[k] + drawn.origin
        return f"at the point ({x:.6g}, {y:.6g}) of {self.name}"

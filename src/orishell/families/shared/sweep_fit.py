"""The sweep that comes nearest to a surface: a moulding surface, or a cylinder (not in the paper).

What finer and finer shells of the parallel repeating family approach is a *moulding surface*: a
profile f whose plane stays square to a plane curve g, so that all its points move on curves that
are parallel to g. In the frame of the sweep, z up and g the graph y = v(x), its points satisfy

    z = h(d),   d the signed distance of (x, y) from g, to the left of it,

and h is the profile. With a straight g it is a cylinder, which the two other families approach.
They are found by least squares over points of the surface, from several frames
(:mod:`~orishell.families.shared.sweep_state`).
"""

from __future__ import annotations

from dataclasses import replace
from typing import Literal

import numpy as np

from orishell.conventions.record import record
from orishell.families.shared.sweep_state import (
    G_POWERS,
    H_POWERS,
    Problem,
    State,
    powers_of,
    solved,
)
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.numerics.equals import first_largest, smallest_of

Kind = Literal["moulding", "cylinder"]

TILTS: dict[Kind, tuple[tuple[float, float], ...]] = {
    "moulding": (
        *((0.0, turn * np.pi / 4) for turn in (0, 2, 1)),
        *((0.5, turn * np.pi / 4) for turn in (0, 1, 2, 3)),
    ),
    "cylinder": tuple((0.0, turn * np.pi / 4) for turn in (0, 2, 1, 3)),
}
"""Frames to begin with: how far they are tilted, about an axis turned by so much (radians)."""
SQUARE = ((0.0, 0.0), (0.0, np.pi / 2))
"""Frames that are held."""
SAMPLES = 400
"""Points of the surface that a sweep is fitted to, at most."""
LATTICE = 25
"""Places along g, and on f, at which it is looked how far a sweep leaves the surface."""
LEAST_WEIGHT = 0.1
ROUNDS = 8
"""How often points that are far from it are given more weight."""


@record
class SweepLimits:
    """What a family can sweep."""

    kind: Kind  # whether g may bend
    # a profile's slope, at most; 1.9 is 62 degrees, whose staircases have angles of 56 degrees
    steepest: float = 1.9
    convex: bool = False  # whether the profile must bend one way

    @property
    def sides(self) -> tuple[int, ...]:
        """Ways for the profile to bend: up, down, or either (0)."""
        return (-1, 1) if self.convex else (0,)


@record
class Sweep:
    """A moulding surface or a cylinder in its frame, and how near it comes to a surface.

    ``frame`` has the axes of the sweep as columns: x along g, y to the left of it, z up.
    """

    kind: Kind
    frame: Array  # (3, 3), a rotation
    centre: Array  # the point (3,) of the surface's frame where the sweep's frame has its origin
    size: float  # length that the polynomials take as 1
    g: Array  # coefficients of v, at G_POWERS; zeros if g is straight
    h: Array  # coefficients of h, at H_POWERS
    along: tuple[float, float]  # the range of x on g that covers the surface (length)
    across: tuple[float, float]  # the range of d on f that covers it (length)
    max: float  # largest distance of the surface's points from it, to first order (length)
    rms: float  # root mean square of these (length)
    # how far it leaves the surface, where it reaches beyond the rim, about (length)
    beyond: float

    @property
    def reach(self) -> float:
        """The larger of both distances, from the surface to the sweep and back, about (length)."""
        return max(self.max, self.beyond)

    @property
    def lean(self) -> float:
        """Angle between the sweep's vertical and the surface's (radians)."""
        return float(np.arctan2(np.hypot(*self.frame[2, :2]), self.frame[2, 2]))

    def bends(self, side: int) -> bool:
        """Whether the profile bends to one side all along: 1 up, -1 down, 0 either."""
        d = np.linspace(*self.across, LATTICE) / self.size
        return bool((side * (powers_of(d, H_POWERS)[2] @ self.h) >= 0).all())

    def profile(self, d: Array) -> Array:
        """Heights (...) of the profile at distances d (...) to the left of g (length)."""
        return np.asarray(self.size * (powers_of(d / self.size, H_POWERS)[0] @ self.h))

    def path(self, x: Array, d: Array | float = 0.0) -> Array:
        """Points (..., 2) beside g at its places x (...), at a distance d to the left (length)."""
        u = x / self.size
        value, slope, _ = (each @ self.g for each in powers_of(u, G_POWERS))
        normal = np.stack([-slope, np.ones_like(slope)], axis=-1)
        normal /= np.hypot(1.0, slope)[..., None]
        return np.asarray(
            self.size * np.stack([u, value], axis=-1) + np.asarray(d)[..., None] * normal
        )

    def points(self, x: Array, d: Array) -> Array:
        """Points (..., 3) of the sweep in the surface's frame, at x (...) on g and d (...)."""
        x, d = np.broadcast_arrays(x, d)
        plan = self.path(x, d)
        local = np.concatenate([plan, self.profile(d)[..., None]], axis=-1)
        return np.asarray(self.centre + local @ self.frame.T)


def fit_upright(points: Array, normals: Array, limits: SweepLimits, turn: float = 0.0) -> Sweep:
    """The upright sweep that comes nearest to a surface, both ways, of those that starts find.

    Parameters
    ----------
    points
        Points (N, 3) of the surface, its rim among them, z up; they may be unevenly spread.
    normals
        Unit normals (N, 3) there.
    limits
        What the family can sweep.
    turn
        Direction of a side of the surface in plan (radians). Sweeps along it and square to it are
        tried as well, beside those that turn freely.
    """
    cloud = _Cloud.of(points)
    even = cloud.problem(_free(limits.kind, upright=True), limits)
    even = replace(even, upright=np.abs(normals[cloud.chosen, 2]))
    held = replace(even, free=even.free & (np.arange(len(even.free)) > 2))
    tried = [(held, start) for start in SQUARE]
    tried += [(even, start) for start in TILTS[limits.kind] if not start[0]]
    found = [
        (
            cloud.sweep(
                solved(State.tilted(tilt, turn + around), replace(each, side=side)), limits
            ),
            side,
        )
        for side in limits.sides
        for each, (tilt, around) in tried
    ]
    sound = [sweep for sweep, side in found if sweep.bends(side)]
    return smallest_of(sound or [sweep for sweep, _ in found], lambda each: each.reach)


def fit_leaning(points: Array, limits: SweepLimits) -> Sweep:
    """The sweep, leaning as it likes, that comes nearest to a surface within its rim.

    What it is beyond the rim does not count. The best of several starts is moved towards the least
    largest distance, as points that are far from it weigh more and more.

    Parameters
    ----------
    points
        Points (N, 3) of the surface, its rim among them, z up; they may be unevenly spread.
    limits
        What the family can sweep.
    """
    cloud = _Cloud.of(points)
    problem = cloud.problem(_free(limits.kind, upright=False), limits)
    found = [
        cloud.sweep(solved(State.tilted(*start), replace(problem, side=side)), limits)
        for side in limits.sides
        for start in TILTS[limits.kind]
    ]
    best = smallest_of(found, lambda each: each.max)
    state = State(best.frame, best.g, best.h)
    for _ in range(ROUNDS):
        off = np.abs(state.meet(problem.points).distance)
        if not off.max() > 0:
            break
        weight = problem.weight * np.sqrt(LEAST_WEIGHT + off / off.max())
        problem = replace(problem, weight=weight / np.sqrt((weight**2).mean()))
        state = solved(state, problem)
        best = min(best, cloud.sweep(state, limits), key=lambda each: each.max)
    return best


@record
class _Cloud:
    """Points of a surface, relative to its size, and those of them that are fitted."""

    place: Array  # (N, 3)
    chosen: Integers  # numbers (S,) of these
    centre: Array
    size: float

    @classmethod
    def of(cls, points: Array) -> _Cloud:
        centre = 0.5 * (points.min(axis=0) + points.max(axis=0))
        size = float(np.abs(points - centre).max())
        place = (points - centre) / size
        return cls(place, _spread(place, SAMPLES), centre, size)

    def problem(self, free: Booleans, limits: SweepLimits) -> Problem:
        """All points weigh alike."""
        return Problem(self.place[self.chosen], np.ones(len(self.chosen)), free, limits.steepest)

    def sweep(self, state: State, limits: SweepLimits) -> Sweep:
        """A state in the surface's own size, long enough to cover all points."""
        met, size = state.meet(self.place), self.size
        sweep = Sweep(
            kind=limits.kind,
            frame=state.frame,
            centre=self.centre,
            size=size,
            g=state.g,
            h=state.h,
            along=(size * float(met.x.min()), size * float(met.x.max())),
            across=(size * float(met.d.min()), size * float(met.d.max())),
            max=size * float(np.abs(met.distance).max()),
            rms=size * float(np.sqrt((met.distance**2).mean())),
            beyond=0.0,
        )
        return replace(sweep, beyond=_beyond(sweep, self.centre + size * self.place))


def _free(kind: Kind, *, upright: bool) -> Booleans:
    """Which unknowns may change: turns of the frame, coefficients of g, of h."""
    turns = [not upright, not upright, True]
    bends = np.full(len(G_POWERS), kind == "moulding")
    return np.concatenate([turns, bends, np.full(len(H_POWERS), True)])


def _beyond(sweep: Sweep, points: Array) -> float:
    """How far a sweep leaves points (N, 3) of the surface, about (length)."""
    from scipy.spatial import cKDTree

    x, d = (np.linspace(*reach, LATTICE) for reach in (sweep.along, sweep.across))
    gap = cKDTree(points).query(sweep.points(x[:, None], d[None, :]))[0]
    return float(np.max(gap))


def _spread(points: Array, count: int) -> Integers:
    """Numbers of so many of the points (N, 3), as even as can be: each far from those before it."""
    nearest = ((points - points.mean(axis=0)) ** 2).sum(axis=-1)
    chosen = np.empty(min(count, len(points)), dtype=np.intp)
    for k in range(len(chosen)):
        chosen[k] = first_largest(nearest)
        gap = points - points[chosen[k]]
        np.minimum(nearest, np.einsum("ni,ni->n", gap, gap), out=nearest)
    return chosen

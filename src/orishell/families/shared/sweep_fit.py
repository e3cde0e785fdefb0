"""The sweep that comes nearest to a surface: a moulding surface, or a cylinder (not in the paper).

What finer and finer shells of the parallel repeating family approach is a *moulding surface*: a
profile f whose plane stays square to a plane curve g, so that all its points move on curves that
are parallel to g. In the frame of the sweep, z up and g the graph y = v(x), its points satisfy

    z = h(d),   d the signed distance of (x, y) from g, to the left of it,

and h is the profile. With a straight g it is a cylinder, which the two other families approach.
The distance of a point from it is to first order

    F = (z - h(d)) / sqrt(1 + h'(d)^2).

h and v are polynomials. They and the frame are found by least squares over points of the surface
(Levenberg-Marquardt: K. Madsen, H. B. Nielsen, O. Tingleff, Methods for Non-Linear Least Squares
Problems, 2nd ed., 2004) from several frames. Derivatives are exact: d changes as the point and the
foot's normal do, because the foot moves along g only.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Literal

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Booleans, Integers

Kind = Literal["moulding", "cylinder"]

G_POWERS = np.array([0, 2, 3, 4, 5, 6])
"""Powers of x in v: the frame turns instead of a linear term."""
H_POWERS = np.arange(9)
"""Powers of d in h."""
LEAST_BEND = 0.05
"""A profile that must be convex bends by at least this, relative to the surface's extent."""
LEAST_TURN = 0.15
"""Curves beside g stay regular: 1 - curvature of g times d is at least this."""
PENALTY, STRICT = 0.3, 3.0
"""Weights of what exceeds these, beside a distance: slopes and regularity, convexity."""
CALM = 1e-5
"""Weight of coefficients that nothing else determines."""
NEWTON_STEPS = 7
LONGEST_STEP = 0.3
"""Steps to the foot on g; lengths are relative to the surface's extent."""
ITERATIONS = 60
FIRST_DAMPING, LEAST_DAMPING, MOST_DAMPING = 1e-3, 1e-12, 1e8
STILL = 1e-8
"""A start ends where a step gains less than this share of the sum of squares."""
TILTS: dict[Kind, tuple[tuple[float, float], ...]] = {
    "moulding": (
        *((0.0, turn * np.pi / 4) for turn in (0, 2, 1)),
        *((0.5, turn * np.pi / 4) for turn in (0, 1, 2, 3)),
    ),
    "cylinder": tuple((0.0, turn * np.pi / 4) for turn in (0, 2, 1, 3)),
}
"""Frames to begin with: how far they are tilted, about an axis turned by so much (radians)."""
SQUARE = (0.0, np.pi / 2)
"""Turns of frames that are held."""
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

    def profile(self, d: Array) -> Array:
        """Heights (...) of the profile at distances d (...) to the left of g (length)."""
        return np.asarray(self.size * (_powers(d / self.size, H_POWERS)[0] @ self.h))

    def path(self, x: Array, d: Array | float = 0.0) -> Array:
        """Points (..., 2) beside g at its places x (...), at a distance d to the left (length)."""
        u = x / self.size
        value, slope, _ = (each @ self.g for each in _powers(u, G_POWERS))
        normal = np.stack([-slope, np.ones_like(slope)], axis=-1)
        normal /= np.hypot(1.0, slope)[..., None]
        return np.asarray(self.size * np.stack([u, value], axis=-1) + np.asarray(d)[..., None] * normal)

    def points(self, x: Array, d: Array) -> Array:
        """Points (..., 3) of the sweep in the surface's frame, at x (...) on g and d (...)."""
        x, d = np.broadcast_arrays(x, d)
        plan = self.path(x, d)
        local = np.concatenate([plan, self.profile(d)[..., None]], axis=-1)
        return np.asarray(self.centre + local @ self.frame.T)

    def local(self, points: Array) -> Array:
        """Points (..., 3) of the surface's frame in the sweep's."""
        return np.asarray((points - self.centre) @ self.frame)

    def distances(self, points: Array) -> Array:
        """Distances (...) of points (..., 3) of the surface from it, signed, to first order."""
        found = _State(self.frame, self.g, self.h).meet((points - self.centre) / self.size)
        return np.asarray(self.size * found.distance)


def fit_sweep(
    points: Array, limits: SweepLimits, *, rim: bool = True, upright: bool = True, turn: float = 0.0
) -> Sweep:
    """The best of the sweeps that a few starts find for points of a surface.

    Each start is solved by least squares; the best is then moved towards the least largest
    distance, as points that are far from it weigh more and more.

    Parameters
    ----------
    points
        Points (N, 3) of the surface, its rim among them, z up; they may be unevenly spread.
    limits
        What the family can sweep.
    rim
        Whether how far the sweep reaches beyond the rim counts as well.
    upright
        Whether the frame may turn about the vertical only.
    turn
        Direction of a side of the surface in plan (radians). Upright sweeps along it and square to
        it are tried as well, beside those that turn freely.
    """
    centre = 0.5 * (points.min(axis=0) + points.max(axis=0))
    size = float(np.abs(points - centre).max())
    place = (points - centre) / size
    chosen = _spread(place, SAMPLES)
    free = _free(limits.kind, upright)
    starts = [each for each in TILTS[limits.kind] if not (upright and each[0])]
    even = _Problem(chosen, np.ones(len(chosen)), free, limits.steepest)
    problems = [(replace(even, side=side), start) for side in limits.sides for start in starts]
    if upright:
        held = replace(even, free=free & (np.arange(len(free)) > 2))
        problems += [
            (replace(held, side=side), (0.0, around)) for side in limits.sides for around in SQUARE
        ]
    found = []
    for problem, (tilt, around) in problems:
        state = _solved(_State.tilted(tilt, turn + around), problem)
        found.append((_as_sweep(state, place, centre, size, limits), problem))
    best, problem = min(found, key=lambda each: each[0].reach if rim else each[0].max)
    state = _State(best.frame, best.g, best.h)
    for _ in range(ROUNDS):
        off = np.abs(state.meet(chosen).distance)
        if not off.max() > 0:
            break
        weight = problem.weight * np.sqrt(LEAST_WEIGHT + off / off.max())
        problem = replace(problem, weight=weight / np.sqrt((weight**2).mean()))
        state = _solved(state, problem)
        there = _as_sweep(state, place, centre, size, limits)
        if there.max < best.max and (there.reach <= best.reach or not rim):
            best = there
    return best


def _free(kind: Kind, upright: bool) -> Booleans:
    """Which unknowns may change: turns of the frame, coefficients of g, of h."""
    turns = [not upright, not upright, True]
    bends = np.full(len(G_POWERS), kind == "moulding")
    return np.concatenate([turns, bends, np.full(len(H_POWERS), True)])


def _as_sweep(
    state: _State, place: Array, centre: Array, size: float, limits: SweepLimits
) -> Sweep:
    met = state.meet(place)
    sweep = Sweep(
        kind=limits.kind,
        frame=state.frame,
        centre=centre,
        size=size,
        g=state.g,
        h=state.h,
        along=(size * float(met.x.min()), size * float(met.x.max())),
        across=(size * float(met.d.min()), size * float(met.d.max())),
        max=size * float(np.abs(met.distance).max()),
        rms=size * float(np.sqrt((met.distance**2).mean())),
        beyond=0.0,
    )
    return replace(sweep, beyond=_beyond(sweep, centre + size * place))


def _beyond(sweep: Sweep, points: Array) -> float:
    """How far a sweep leaves points (N, 3) of the surface, about (length)."""
    from scipy.spatial import cKDTree

    x, d = (np.linspace(*reach, LATTICE) for reach in (sweep.along, sweep.across))
    gap = cKDTree(points).query(sweep.points(x[:, None], d[None, :]))[0]
    return float(gap.max())


def _spread(points: Array, count: int) -> Array:
    """So many of the points (N, 3), each the farthest from those before it: as even as can be."""
    nearest = ((points - points.mean(axis=0)) ** 2).sum(axis=-1)
    chosen = np.empty(min(count, len(points)), dtype=np.intp)
    for k in range(len(chosen)):
        chosen[k] = nearest.argmax()
        gap = points - points[chosen[k]]
        np.minimum(nearest, np.einsum("ni,ni->n", gap, gap), out=nearest)
    return points[chosen]


def _powers(x: Array, powers: Integers) -> tuple[Array, Array, Array]:
    """Powers (..., K) of x (...), and their first and second derivatives."""
    every = np.ones((*x.shape, 1 + int(powers[-1])))
    every[..., 1:] = x[..., None]
    np.cumprod(every, axis=-1, out=every)
    first, second = (every[..., np.maximum(powers - k, 0)] for k in (1, 2))
    return every[..., powers], powers * first, powers * (powers - 1) * second


@record
class _Problem:
    """What least squares solve."""

    points: Array  # points (N, 3) of the surface, relative to its size
    weight: Array  # their weights (N,)
    free: Booleans  # which unknowns (3 + K + L,) may change
    steepest: float  # the profile's slope, at most
    side: int = 0  # the way that the profile must bend: 1 up, -1 down, 0 either


@record
class _Met:
    """Where points meet a sweep: their feet on g, and how far they are from it."""

    x: Array  # places (N,) of their feet on g
    d: Array  # distances (N,) from g
    distance: Array  # signed distances (N,) from the sweep, to first order
    local: Array  # the points (N, 3) in the frame of the sweep


@record
class _State:
    """What is sought, lengths relative to the surface's size."""

    frame: Array
    g: Array
    h: Array

    @classmethod
    def tilted(cls, tilt: float, turn: float) -> _State:
        """A start: a slope that is level in the surface's frame, nearly straight."""
        (c, s), (k, t) = ((np.cos(each), np.sin(each)) for each in (turn, tilt))
        frame = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
        frame = frame @ np.array([[1, 0, 0], [0, k, -t], [0, t, k]])
        h = np.zeros(len(H_POWERS))
        h[1] = -np.tan(tilt)
        return cls(frame, np.zeros(len(G_POWERS)), h)

    def meet(self, points: Array) -> _Met:
        """Where points (N, 3) meet the sweep."""
        local = points @ self.frame
        x, y, z = local.T
        u = x
        for _ in range(NEWTON_STEPS if self.g.any() else 0):
            v, slope, bend = (each @ self.g for each in _powers(u, G_POWERS))
            excess = (u - x) + (v - y) * slope
            growth = 1 + slope**2 + (v - y) * bend
            step = excess / np.maximum(growth, 0.2)
            u = u - np.clip(step, -LONGEST_STEP, LONGEST_STEP)
        v, slope, _ = (each @ self.g for each in _powers(u, G_POWERS))
        d = ((y - v) - (x - u) * slope) / np.hypot(1, slope)
        height, rise, _ = (each @ self.h for each in _powers(d, H_POWERS))
        return _Met(u, d, (z - height) / np.hypot(1, rise), local)

    def moved(self, step: Array) -> _State:
        """The state after a step: the frame turned about its own axes, coefficients added to."""
        count = len(G_POWERS)
        return _State(
            self.frame @ _rotation(step[:3]), self.g + step[3 : 3 + count], self.h + step[3 + count :]
        )

    def residuals(self, problem: _Problem) -> tuple[Array, Array]:
        """Residuals (R,) and their derivatives (R, 3 + K + L) by frame, g and h."""
        met, weight = self.meet(problem.points), problem.weight
        x, y, z = met.local.T
        on_g, on_g1, on_g2 = _powers(met.x, G_POWERS)
        v, slope, bend = on_g @ self.g, on_g1 @ self.g, on_g2 @ self.g
        long = np.hypot(1, slope)
        normal = np.stack([-slope, np.ones_like(slope), np.zeros_like(slope)], axis=-1)
        normal /= long[:, None]
        # How the points move when the frame turns about its own axes: local x axis.
        turned = np.cross(met.local[:, None, :], np.eye(3))
        zero = np.zeros((len(x), len(H_POWERS)))
        d_by = np.concatenate(
            [np.einsum("nji,ni->nj", turned, normal), -normal[:, 1:2] * on_g, zero], axis=-1
        )
        on_h, on_h1, on_h2 = _powers(met.d, H_POWERS)
        height, rise, curl = on_h @ self.h, on_h1 @ self.h, on_h2 @ self.h
        steep = np.hypot(1, rise)
        rise_by = curl[:, None] * d_by
        rise_by[:, -len(H_POWERS) :] += on_h1
        off_by = -rise[:, None] * d_by
        off_by[:, :3] += turned[:, :, 2]
        off_by[:, -len(H_POWERS) :] -= on_h
        off = z - height
        distance_by = off_by / steep[:, None] - (off * rise / steep**3)[:, None] * rise_by
        over = np.abs(rise) > problem.steepest
        steeper = np.where(over, np.abs(rise) - problem.steepest, 0.0)
        steeper_by = (over * np.sign(rise))[:, None] * rise_by
        # 1 - curvature times d, its foot held
        room = 1 + slope**2 + (v - y) * bend
        near = room < LEAST_TURN
        tight = np.where(near, LEAST_TURN - room, 0.0)
        tight_by = np.zeros_like(d_by)
        within = 3 + np.arange(len(G_POWERS))
        tight_by[:, within] = -(
            2 * slope[:, None] * on_g1 + bend[:, None] * on_g + (v - y)[:, None] * on_g2
        )
        tight_by[:, :3] = bend[:, None] * turned[:, :, 1]
        tight_by *= near[:, None]
        straight = np.maximum(LEAST_BEND - problem.side * curl, 0.0) * abs(problem.side)
        straight_by = np.zeros_like(d_by)
        straight_by[:, -len(H_POWERS) :] = -problem.side * on_h2
        straight_by *= (straight > 0)[:, None]
        calm = CALM * np.eye(d_by.shape[1])
        return np.concatenate(
            [
                weight * met.distance,
                PENALTY * steeper,
                PENALTY * tight,
                STRICT * straight,
                CALM * np.concatenate([np.zeros(3), self.g, self.h]),
            ]
        ), np.concatenate(
            [
                weight[:, None] * distance_by,
                PENALTY * steeper_by,
                PENALTY * tight_by,
                STRICT * straight_by,
                calm,
            ]
        )


def _rotation(turn: Array) -> Array:
    """The rotation (3, 3) by a vector (3,): Rodrigues' formula."""
    angle = float(np.linalg.norm(turn))
    if angle == 0.0:
        return np.eye(3)
    k = np.cross(np.eye(3), turn / angle)
    return np.asarray(np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * k @ k)


def _solved(state: _State, problem: _Problem) -> _State:
    """The state that least squares reach from one by the unknowns that are free."""
    free = problem.free
    with np.errstate(over="ignore", invalid="ignore"):
        residual, slopes = state.residuals(problem)
        cost, damping = float(residual @ residual), FIRST_DAMPING
        for _ in range(ITERATIONS):
            jacobian = slopes[:, free]
            normal = jacobian.T @ jacobian
            normal += damping * np.diag(np.diag(normal) + CALM**2)
            step = np.zeros(len(free))
            step[free] = -np.linalg.solve(normal, jacobian.T @ residual)
            trial = state.moved(step)
            found = trial.residuals(problem)
            there = float(found[0] @ found[0])
            if there < cost:
                gained, damping = cost - there, max(damping / 5, LEAST_DAMPING)
                state, cost, (residual, slopes) = trial, there, found
                if gained < STILL * cost:
                    break
            else:
                damping *= 4
                if damping > MOST_DAMPING:
                    break
    return state

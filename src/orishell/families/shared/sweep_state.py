"""A moulding surface or a cylinder with few numbers, and the least squares that choose them.

In the frame of the sweep, z up and g the graph y = v(x), its points satisfy z = h(d), d the signed
distance of (x, y) from g, to the left of it. The distance of a point is to first order

    F = (z - h(d)) / sqrt(1 + h'(d)^2).

h and v are polynomials. Levenberg-Marquardt finds them and the frame (K. Madsen, H. B. Nielsen,
O. Tingleff, Methods for Non-Linear Least Squares Problems, 2nd ed., 2004). Derivatives are exact: d
changes as the point does along the normal of g at its foot, because the foot moves along g only.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Booleans, Integers

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
PLACES = 41
"""Places on the profile at which its shape counts."""
SMOOTH = 1e-3
"""Weight of changes of h'' from place to place."""
CALM = 1e-5
"""Weight of coefficients that nothing else determines."""
NEWTON_STEPS = 7
LONGEST_STEP = 0.3
"""Steps to the foot on g; lengths are relative to the surface's extent."""
ITERATIONS = 60
FIRST_DAMPING, LEAST_DAMPING, MOST_DAMPING = 1e-3, 1e-12, 1e8
STILL = 1e-8
"""A start ends where a step gains less than this share of the sum of squares."""


def powers_of(x: Array, powers: Integers) -> tuple[Array, Array, Array]:
    """Powers (..., K) of x (...), and their first and second derivatives."""
    every = np.ones((*x.shape, 1 + int(powers[-1])))
    every[..., 1:] = x[..., None]
    np.cumprod(every, axis=-1, out=every)
    first, second = (every[..., np.maximum(powers - k, 0)] for k in (1, 2))
    return (
        every[..., powers],
        np.asarray(powers * first),
        np.asarray(powers * (powers - 1) * second),
    )


@record
class Problem:
    """What least squares solve."""

    points: Array  # points (N, 3) of the surface, relative to its size
    weight: Array  # their weights (N,)
    free: Booleans  # which unknowns (3 + K + L,) may change
    steepest: float  # the profile's slope, at most
    # vertical parts (N,) of the surface's unit normals: z - h is multiplied by them instead of the
    # sweep's own, so that nothing is gained by walls at the rim; None for the sweep's own
    upright: Array | None = None
    side: int = 0  # the way that the profile must bend: 1 up, -1 down, 0 either


@record
class Met:
    """Where points meet a sweep: their feet on g, and how far they are from it."""

    x: Array  # places (N,) of their feet on g
    d: Array  # distances (N,) from g
    distance: Array  # signed distances (N,) from the sweep, to first order
    local: Array  # the points (N, 3) in the frame of the sweep


@record
class State:
    """What is sought, lengths relative to the surface's size."""

    frame: Array
    g: Array
    h: Array

    @classmethod
    def tilted(cls, tilt: float, turn: float) -> State:
        """A start: a slope that is level in the surface's frame, nearly straight."""
        (c, s), (k, t) = ((np.cos(each), np.sin(each)) for each in (turn, tilt))
        frame = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
        frame = frame @ np.array([[1, 0, 0], [0, k, -t], [0, t, k]])
        h = np.zeros(len(H_POWERS))
        h[1] = -np.tan(tilt)
        return cls(frame, np.zeros(len(G_POWERS)), h)

    def meet(self, points: Array) -> Met:
        """Where points (N, 3) meet the sweep."""
        local = points @ self.frame
        x, y, z = local.T
        u = x
        for _ in range(NEWTON_STEPS if self.g.any() else 0):
            v, slope, bend = (each @ self.g for each in powers_of(u, G_POWERS))
            excess = (u - x) + (v - y) * slope
            growth = 1 + slope**2 + (v - y) * bend
            step = excess / np.maximum(growth, 0.2)
            u = u - np.clip(step, -LONGEST_STEP, LONGEST_STEP)
        v, slope, _ = (each @ self.g for each in powers_of(u, G_POWERS))
        d = ((y - v) - (x - u) * slope) / np.hypot(1, slope)
        height, rise, _ = (each @ self.h for each in powers_of(d, H_POWERS))
        return Met(u, d, (z - height) / np.hypot(1, rise), local)

    def moved(self, step: Array) -> State:
        """The state after a step: the frame turned about its own axes, coefficients added to."""
        count = len(G_POWERS)
        return State(
            self.frame @ _rotation(step[:3]),
            self.g + step[3 : 3 + count],
            self.h + step[3 + count :],
        )

    def shape(self, problem: Problem, d: Array) -> tuple[Array, Array]:
        """Residuals of the profile's shape at places d (P,), and their derivatives by h."""
        _, on_h1, on_h2 = powers_of(d, H_POWERS)
        rise, curl = on_h1 @ self.h, on_h2 @ self.h
        side = problem.side
        steep, straight = np.abs(rise) - problem.steepest, abs(side) * LEAST_BEND - side * curl
        change = SMOOTH * np.diff(on_h2, axis=0)
        rows = (
            (
                PENALTY * np.maximum(steep, 0),
                PENALTY * ((steep > 0) * np.sign(rise))[:, None] * on_h1,
            ),
            (STRICT * np.maximum(straight, 0), -STRICT * side * (straight > 0)[:, None] * on_h2),
            (change @ self.h, change),
        )
        found, by_h = zip(*rows, strict=True)
        return np.concatenate(found), np.concatenate(by_h)

    def residuals(self, problem: Problem) -> tuple[Array, Array]:
        """Residuals (R,) and their derivatives (R, 3 + K + L) by frame, g and h."""
        met, weight = self.meet(problem.points), problem.weight
        x, y, z = met.local.T
        on_g, on_g1, on_g2 = powers_of(met.x, G_POWERS)
        v, slope, bend = on_g @ self.g, on_g1 @ self.g, on_g2 @ self.g
        long = np.hypot(1, slope)
        normal = np.stack([-slope, np.ones_like(slope), np.zeros_like(slope)], axis=-1)
        normal /= long[:, None]
        # How local points move when the frame turns about its own axes.
        turned = np.cross(met.local[:, None, :], np.eye(3))
        zero = np.zeros((len(x), len(H_POWERS)))
        d_by = np.concatenate(
            [np.einsum("nji,ni->nj", turned, normal), -normal[:, 1:2] * on_g, zero], axis=-1
        )
        on_h, on_h1, on_h2 = powers_of(met.d, H_POWERS)
        height, rise, curl = on_h @ self.h, on_h1 @ self.h, on_h2 @ self.h
        steep = np.hypot(1, rise)
        rise_by = curl[:, None] * d_by
        rise_by[:, -len(H_POWERS) :] += on_h1
        off_by = -rise[:, None] * d_by
        off_by[:, :3] += turned[:, :, 2]
        off_by[:, -len(H_POWERS) :] -= on_h
        off = z - height
        distance, distance_by = met.distance, off_by / steep[:, None]
        distance_by -= (off * rise / steep**3)[:, None] * rise_by
        if problem.upright is not None:
            distance, distance_by = problem.upright * off, problem.upright[:, None] * off_by
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
        shape, shape_by = self.shape(problem, np.linspace(met.d.min(), met.d.max(), PLACES))
        calm = CALM * np.eye(d_by.shape[1])
        return np.concatenate(
            [
                weight * distance,
                PENALTY * tight,
                shape,
                CALM * np.concatenate([np.zeros(3), self.g, self.h]),
            ]
        ), np.concatenate(
            [
                weight[:, None] * distance_by,
                PENALTY * tight_by,
                np.pad(shape_by, ((0, 0), (3 + len(G_POWERS), 0))),
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


def solved(state: State, problem: Problem) -> State:
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

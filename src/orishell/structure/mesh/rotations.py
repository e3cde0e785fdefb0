"""Finite rotations: matrices from rotation vectors and back, and what small turns do to vectors.

Where a rotation of the vector t is turned further by a small w, exp([w]) exp([t]), its vector
changes by H(t) w with

    H = 1 - [t]/2 + e [t]^2,        e = (1 - s/2 cot(s/2)) / s^2,  s = abs(t)

(the inverse of the left Jacobian of SO(3); C. A. Felippa and B. Haugen, "A unified formulation of
small-strain corotational finite elements", Computer Methods in Applied Mechanics and Engineering
194 (2005), where it is H, and its derivative L).
"""

from __future__ import annotations

import numpy as np

from orishell.numerics.arrays import Array

SERIES_BELOW = 1e-2
"""Below this angle series are used (radians); what they leave out is below 1e-13."""


def cross_matrices(vectors: Array) -> Array:
    """The matrices [v] (..., 3, 3) of vectors v (..., 3), [v] w being v x w."""
    x, y, z = np.moveaxis(vectors, -1, 0)
    none = np.zeros_like(x)
    rows = [[none, -z, y], [z, none, -x], [-y, x, none]]
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


def exponentials(vectors: Array) -> Array:
    """Rotations (..., 3, 3) about vectors (..., 3) by their lengths (radians)."""
    angle = np.linalg.norm(vectors, axis=-1)[..., None, None]
    turn = cross_matrices(vectors)
    half = np.sinc(angle / (2 * np.pi))
    return np.asarray(np.eye(3) + np.sinc(angle / np.pi) * turn + 0.5 * half**2 * (turn @ turn))


def logarithms(rotations: Array) -> Array:
    """Vectors (..., 3) of rotations (..., 3, 3) by less than half a turn (radians)."""
    twice = np.stack(
        [
            rotations[..., 2, 1] - rotations[..., 1, 2],
            rotations[..., 0, 2] - rotations[..., 2, 0],
            rotations[..., 1, 0] - rotations[..., 0, 1],
        ],
        axis=-1,
    )
    sine = 0.5 * np.linalg.norm(twice, axis=-1)
    cosine = 0.5 * (np.trace(rotations, axis1=-2, axis2=-1) - 1)
    angle = np.arctan2(sine, cosine)
    return np.asarray(0.5 * twice / np.sinc(angle / np.pi)[..., None])


def change_matrices(vectors: Array) -> Array:
    """H (..., 3, 3) of rotation vectors (..., 3)."""
    turn = cross_matrices(vectors)
    factor, _ = _factors(vectors)
    return np.asarray(np.eye(3) - 0.5 * turn + factor[..., None, None] * (turn @ turn))


def change_derivatives(vectors: Array, moments: Array) -> Array:
    """How H^T m changes with the rotation vectors: (..., 3, 3), for fixed m.

    vectors: Rotation vectors t (..., 3).
    moments: Vectors m (..., 3).
    """
    factor, slope = (each[..., None, None] for each in _factors(vectors))
    along = np.sum(vectors * moments, axis=-1)[..., None, None]
    outer = moments[..., :, None] * vectors[..., None, :]
    turned = np.cross(vectors, np.cross(vectors, moments))
    return np.asarray(
        -0.5 * cross_matrices(moments)
        + factor * (along * np.eye(3) + outer.swapaxes(-1, -2) - 2 * outer)
        + slope * turned[..., :, None] * vectors[..., None, :]
    )


def _factors(vectors: Array) -> tuple[Array, Array]:
    """The factor e (...) of H, and its derivative by the angle over the angle."""
    square = np.sum(vectors**2, axis=-1)
    near = square < SERIES_BELOW**2
    t2 = np.where(near, 1.0, square)
    t = np.sqrt(t2)
    cot = 0.5 * t / np.tan(0.5 * t)
    far = (1 - cot) / t2
    # d(t/2 cot(t/2))/dt = cot(t/2)/2 - t/4/sin^2(t/2).
    falls = cot / t - 0.25 * t / np.sin(0.5 * t) ** 2
    far_slope = -falls / (t2 * t) - 2 * far / t2
    factor = np.where(near, 1 / 12 + square / 720 + square**2 / 30240, far)
    slope = np.where(near, 1 / 360 + square / 7560 + square**2 / 201600, far_slope)
    return factor, slope

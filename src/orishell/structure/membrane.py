"""Membrane triangles with drilling freedoms: Felippa's optimal template OPT.

C. A. Felippa, "A study of optimal membrane triangles with drilling freedoms", Computer Methods in
Applied Mechanics and Engineering 192 (2003). With x_ij = x_i - x_j and side lengths l_ij the
stiffness is a basic part, which alone passes the patch test, and a part of higher order from
deviatoric corner rotations,

    K = L E L^T / A + 3/4 beta_0 T^T K_theta T,

the last from strains along the three sides at their middles.
"""

from __future__ import annotations

import numpy as np

from orishell.numerics.arrays import Array

LUMPING = 1.5
"""The template's alpha_b."""
BETAS = np.array([[1.0, 2.0, 1.0], [0.0, 1.0, -1.0], [-1.0, -1.0, -2.0]])
"""The template's beta_1 ... beta_9, row by row."""
LEAST = 0.01
"""Smallest beta_0: it would be 0 for a Poisson's ratio of 1/2."""


def membrane_stiffness(corners: Array, elasticity: Array, poisson: float) -> Array:
    """Stiffness (T, 9, 9) of triangles for u, v and the rotation about z at every corner.

    Parameters
    ----------
    corners
        Corners (T, 3, 2), counter-clockwise (length).
    elasticity
        Forces per length by strains xx, yy, xy (T, 3, 3), or one for all (3, 3).
    poisson
        Poisson's ratio, which the template's beta_0 depends on.
    """
    x, y = corners[..., 0], corners[..., 1]
    x21, x32, x13 = x[:, 1] - x[:, 0], x[:, 2] - x[:, 1], x[:, 0] - x[:, 2]
    y21, y32, y13 = y[:, 1] - y[:, 0], y[:, 2] - y[:, 1], y[:, 0] - y[:, 2]
    x12, x23, x31, y12, y23, y31 = -x21, -x32, -x13, -y21, -y32, -y13
    zero = np.zeros_like(x21)
    area = 0.5 * (x21 * -y13 - -x13 * y21)
    mean = strains(corners)
    basic = mean.swapaxes(1, 2) @ elasticity @ mean * area[:, None, None]

    # Corner rotations less that of the triangle as a whole.
    whole = np.stack([x32, y32, zero, x13, y13, zero, x21, y21, zero], axis=-1)
    rotations = np.repeat(whole[:, None], 3, axis=1) / (4 * area[:, None, None])
    rotations[:, [0, 1, 2], [2, 5, 8]] += 1.0

    side = np.stack([x21**2 + y21**2, x32**2 + y32**2, x13**2 + y13**2], axis=-1)
    sides = np.stack(
        [
            _rows(y23 * y13, y31 * y21, y12 * y32),
            _rows(x23 * x13, x31 * x21, x12 * x32),
            _rows(y23 * x31 + x32 * y13, y31 * x12 + x13 * y21, y12 * x23 + x21 * y32),
        ],
        axis=1,
    ) * (side[:, None] / (4 * area[:, None, None] ** 2))
    natural = sides.swapaxes(1, 2) @ elasticity @ sides
    scale = (2 * area / 3)[:, None, None] / side[..., None]
    turned = [np.roll(np.roll(BETAS, k, axis=0), k, axis=1) for k in range(3)]
    corner = [scale * each for each in turned]
    higher = np.zeros_like(natural)
    for first, second in ((0, 1), (1, 2), (2, 0)):
        middle = 0.5 * (corner[first] + corner[second])
        higher += middle.swapaxes(1, 2) @ natural @ middle
    beta = max(0.5 * (1 - 4 * poisson**2), LEAST)
    higher *= 0.75 * beta * area[:, None, None]
    return np.asarray(basic + rotations.swapaxes(1, 2) @ higher @ rotations)


def strains(corners: Array) -> Array:
    """Mean strains (T, 3, 9) xx, yy, xy by u, v and the rotation about z at every corner.

    Parameters
    ----------
    corners
        Corners (T, 3, 2), counter-clockwise (length).
    """
    x, y = corners[..., 0], corners[..., 1]
    x21, x32, x13 = x[:, 1] - x[:, 0], x[:, 2] - x[:, 1], x[:, 0] - x[:, 2]
    y21, y32, y13 = y[:, 1] - y[:, 0], y[:, 2] - y[:, 1], y[:, 0] - y[:, 2]
    x12, x23, x31, y12, y23, y31 = -x21, -x32, -x13, -y21, -y32, -y13
    area = 0.5 * (x21 * -y13 - -x13 * y21)
    zero, a = np.zeros_like(area), LUMPING
    lumping = 0.5 * np.stack(
        [
            _rows(y23, zero, x32),
            _rows(zero, x32, y23),
            a * _rows(y23 * (y13 - y21) / 6, x32 * (x31 - x12) / 6, (x31 * y13 - x12 * y21) / 3),
            _rows(y31, zero, x13),
            _rows(zero, x13, y31),
            a * _rows(y31 * (y21 - y32) / 6, x13 * (x12 - x23) / 6, (x12 * y21 - x23 * y32) / 3),
            _rows(y12, zero, x21),
            _rows(zero, x21, y12),
            a * _rows(y12 * (y32 - y13) / 6, x21 * (x23 - x31) / 6, (x23 * y32 - x31 * y13) / 3),
        ],
        axis=1,
    )
    return np.asarray(lumping.swapaxes(1, 2) / area[:, None, None])


def _rows(*parts: Array) -> Array:
    return np.stack(parts, axis=-1)

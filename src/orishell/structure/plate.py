"""Plates in bending: the discrete Kirchhoff triangle DKT.

J.-L. Batoz, K.-J. Bathe and L.-W. Ho, "A study of three-node triangular plate bending elements",
International Journal for Numerical Methods in Engineering 15 (1980). Rotations are quadratic, and
free of shear at corners and middles of sides; curvatures are linear in area coordinates, so that
the three middles of the sides integrate their products exactly.
"""

from __future__ import annotations

import numpy as np

from orishell.numerics.arrays import Array

MIDDLES = ((0.5, 0.0), (0.5, 0.5), (0.0, 0.5))
"""Middles of the sides in the coordinates xi, eta."""


def plate_stiffness(corners: Array, rigidity: Array) -> Array:
    """Stiffness (T, 9, 9) of triangles for w and the rotations about x and y at every corner.

    Parameters
    ----------
    corners
        Corners (T, 3, 2), counter-clockwise (length).
    rigidity
        Moments per length by curvatures xx, yy, xy (T, 3, 3), or one for all (3, 3).
    """
    area = _area(corners)
    total = np.zeros((len(corners), 9, 9))
    for middle in MIDDLES:
        curvature = curvatures(corners, middle)
        total += curvature.swapaxes(1, 2) @ rigidity @ curvature
    return np.asarray(total * (area / 3)[:, None, None])


def curvatures(corners: Array, at: tuple[float, float]) -> Array:
    """Curvatures (T, 3, 9) xx, yy and twice xy at a place of every triangle.

    Parameters
    ----------
    corners
        Corners (T, 3, 2), counter-clockwise (length).
    at
        Area coordinates of the second and the third corner.
    """
    xi, eta = at
    x, y = corners[..., 0], corners[..., 1]
    # Sides 4, 5, 6 of the paper: from corner 2 to 3, 3 to 1, 1 to 2.
    dx = np.stack([x[:, 1] - x[:, 2], x[:, 2] - x[:, 0], x[:, 0] - x[:, 1]])
    dy = np.stack([y[:, 1] - y[:, 2], y[:, 2] - y[:, 0], y[:, 0] - y[:, 1]])
    square = dx**2 + dy**2
    p4, p5, p6 = -6 * dx / square
    t4, t5, t6 = -6 * dy / square
    q4, q5, q6 = 3 * dx * dy / square
    r4, r5, r6 = 3 * dy**2 / square
    a, b = 1 - 2 * xi, 1 - 2 * eta
    x_xi = [
        p6 * a + (p5 - p6) * eta,
        q6 * a - (q5 + q6) * eta,
        -4 + 6 * (xi + eta) + r6 * a - eta * (r5 + r6),
        -p6 * a + eta * (p4 + p6),
        q6 * a - eta * (q6 - q4),
        -2 + 6 * xi + r6 * a + eta * (r4 - r6),
        -eta * (p5 + p4),
        eta * (q4 - q5),
        -eta * (r5 - r4),
    ]
    y_xi = [
        t6 * a + eta * (t5 - t6),
        1 + r6 * a - eta * (r5 + r6),
        -q6 * a + eta * (q5 + q6),
        -t6 * a + eta * (t4 + t6),
        -1 + r6 * a + eta * (r4 - r6),
        -q6 * a - eta * (q4 - q6),
        -eta * (t4 + t5),
        eta * (r4 - r5),
        -eta * (q4 - q5),
    ]
    x_eta = [
        -p5 * b - xi * (p6 - p5),
        q5 * b - xi * (q5 + q6),
        -4 + 6 * (xi + eta) + r5 * b - xi * (r5 + r6),
        xi * (p4 + p6),
        xi * (q4 - q6),
        -xi * (r6 - r4),
        p5 * b - xi * (p4 + p5),
        q5 * b + xi * (q4 - q5),
        -2 + 6 * eta + r5 * b + xi * (r4 - r5),
    ]
    y_eta = [
        -t5 * b - xi * (t6 - t5),
        1 + r5 * b - xi * (r5 + r6),
        -q5 * b + xi * (q5 + q6),
        xi * (t4 + t6),
        xi * (r4 - r6),
        -xi * (q4 - q6),
        t5 * b - xi * (t4 + t5),
        -1 + r5 * b + xi * (r4 - r5),
        -q5 * b - xi * (q4 - q5),
    ]
    hx_xi, hy_xi, hx_eta, hy_eta = (
        np.stack([np.broadcast_to(part, len(corners)) for part in parts], axis=-1)
        for parts in (x_xi, y_xi, x_eta, y_eta)
    )
    x31, y31 = (x[:, 2] - x[:, 0])[:, None], (y[:, 2] - y[:, 0])[:, None]
    x12, y12 = (x[:, 0] - x[:, 1])[:, None], (y[:, 0] - y[:, 1])[:, None]
    rows = [
        y31 * hx_xi + y12 * hx_eta,
        -x31 * hy_xi - x12 * hy_eta,
        -x31 * hx_xi - x12 * hx_eta + y31 * hy_xi + y12 * hy_eta,
    ]
    return np.stack(rows, axis=1) / (2 * _area(corners))[:, None, None]


def _area(corners: Array) -> Array:
    u, v = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    return np.asarray(0.5 * (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]))

"""Which way the rows and columns of a shell run."""

from __future__ import annotations

import numpy as np

from orishell.numerics.arrays import Array

CLOSED = 0.05
"""Ends that are nearer to each other than this share of the sheet's size show no direction."""


def axes_of(shell: Array) -> Array:
    """Unit vectors (3, 3): along its rows, up its columns, and square to both.

    Lengths at the border do not change them.
    """
    size = float(np.linalg.norm(np.ptp(shell.reshape(-1, 3), axis=0)))
    along, down = (_way(each) for each in (shell[1:-1].mean(axis=0), shell[:, 1:-1].mean(axis=1)))
    x = _direction(along, np.array([1.0, 0.0, 0.0]), size)
    level = np.array([0.0, 1.0, 0.0]) - x[1] * x
    y = _direction(-down + (down @ x) * x, level, size)
    return np.stack([x, y, np.cross(x, y)])


def _way(line: Array) -> Array:
    """From one end of a line (K, 3) to the other: of zigzags that of their middle lines."""
    inner = line[1:-1]
    if len(inner) < 2:
        return np.asarray(line[-1] - line[0])
    some = 2 if len(inner) >= 4 else 1
    return np.asarray(inner[-some:].mean(axis=0) - inner[:some].mean(axis=0))


def _direction(vector: Array, otherwise: Array, size: float) -> Array:
    chosen = vector if np.linalg.norm(vector) > CLOSED * size else otherwise
    return np.asarray(chosen / np.linalg.norm(chosen))

"""Tensors and vectors in a plane, seen in axes that are turned in it."""

from __future__ import annotations

import numpy as np

from orishell.numerics.arrays import Array


def tensors_along(tensors: Array, c: Array, s: Array) -> Array:
    """Symmetric tensors xx, yy, xy (..., 3) in axes turned by angles of cosine c and sine s."""
    x, y, xy = np.moveaxis(tensors, -1, 0)
    turned = [c * c * x + s * s * y + 2 * s * c * xy, s * s * x + c * c * y - 2 * s * c * xy]
    return np.stack([*turned, s * c * (y - x) + (c * c - s * s) * xy], axis=-1)


def strains_along(c: Array, s: Array) -> Array:
    """What makes strains xx, yy and twice xy (..., 3, 3) those in turned axes."""
    rows = [[c * c, s * s, s * c], [s * s, c * c, -s * c], [-2 * s * c, 2 * s * c, c * c - s * s]]
    return np.moveaxis(np.array(rows), (0, 1), (-2, -1))


def vectors_along(vectors: Array, c: Array, s: Array) -> Array:
    """Vectors x, y (..., 2) in axes turned by angles of cosine c and sine s."""
    x, y = np.moveaxis(vectors, -1, 0)
    return np.stack([c * x + s * y, c * y - s * x], axis=-1)

"""The locked shell as it is compared with its surface: its panels, or whole boards beside them."""

from __future__ import annotations

import numpy as np

from orishell.design import Design
from orishell.numerics.arrays import Array, Integers

Mesh = tuple[Array, Integers]
"""Vertices (V, 3), and triangles (T, 3) of them."""


def locked_shell(design: Design) -> Array:
    """Vertices (rows, n, 3) of the shell that meets the surface: columns 1 ... n.

    Flaps and border strips are not part of it: they stand beyond the ends of g.
    """
    mechanism = design.mechanism
    return mechanism.positions(mechanism.target_drive)[:, mechanism.inner_columns]


def drawn_shell(design: Design) -> Array:
    """Vertices (rows, n, 3) of the shell in pictures: of whole boards those between them."""
    hinges, mechanism = design.hinges, design.mechanism
    if hinges is None:
        return locked_shell(design)
    return hinges.vertices(mechanism.positions(mechanism.target_drive))


def locked_boards(design: Design) -> Mesh | None:
    """Whole boards of the locked shell, half way up, where they lie beside its panels; or None."""
    if design.hinges is None:
        return None
    mechanism = design.mechanism
    inner = mechanism.inner_columns
    boards = design.hinges.boards(mechanism.positions(mechanism.target_drive))
    corners = boards[:, inner.start : inner.stop - 1].reshape(-1, 3)
    first = 4 * np.arange(len(corners) // 4)[:, None]
    return corners, (first + np.array([0, 1, 2, 0, 2, 3])).reshape(-1, 3)

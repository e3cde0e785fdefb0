"""A drawn sheet from its flat vertices and the signs of its creases, or why it is none.

Not in the paper: docs/theory/vertex.md.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from orishell.conventions.errors import DesignError
from orishell.families.drawn.cross import Cross, proportions
from orishell.families.drawn.drive import find_drive
from orishell.families.drawn.mechanism import DrawnSheet
from orishell.families.drawn.vertex import Vertices
from orishell.motion.grid import CreaseValues
from orishell.numerics.arrays import Array, Booleans

ONE_OF_FOUR = "three creases of a vertex must have one sign and the fourth the other"
TOGETHER = "mountains and valleys at a vertex cannot fold together"
SURE = 1e-6
"""A sine of a sector or an angle is not 0 if it is larger: then it says which way creases fold."""


def drawn_sheet(flat: Array, signs: CreaseValues, target: float) -> DrawnSheet:
    """The mechanism of a flat sheet.

    Whether it folds says :meth:`~.Drive.disagreement` of its drive.

    Parameters
    ----------
    flat
        Vertices (rows, columns, 2) as in :class:`~orishell.motion.grid.Grid`, with at least one
        inner vertex.
    signs
        Of the creases: 1 valley, -1 mountain, 0 never folded.
    target
        Fold angle of the crease that closes first at the target, in (0, pi] (radians).

    Raises
    ------
    DesignError
        If mountains and valleys at a vertex cannot fold, or parts of the sheet fold by themselves.
    """
    places = np.moveaxis(flat, -1, 0)[..., None]
    middle = (flat.shape[0] - 3) // 2 + 1, (flat.shape[1] - 3) // 2 + 1
    places = places - places[:, middle[0], middle[1], None, None]
    cross = find_cross(places, signs)
    drive = find_drive(cross)
    if drive is None:
        raise DesignError(
            "parts of the sheet fold independently of each other",
            size="it has more than one degree of freedom",
        )
    return DrawnSheet(places, drive, target, np.zeros(3), np.zeros(3))


def find_cross(flat: Array, signs: CreaseValues) -> Cross:
    """The proportions of a flat sheet (2, rows, columns, 1) whose creases have signs.

    Raises DesignError if they cannot fold.
    """
    row, column = _whole_lines(signs.row, "row"), _whole_lines(signs.column.T, "column")
    mode, amiss = _modes(row, column)
    _require(~amiss, ONE_OF_FOUR)
    vertices = Vertices.of(flat, mode[..., None])
    _require(~_opposed(vertices, mode, row, column), TOGETHER)
    return Cross(
        vertices,
        proportions(vertices.beyond_row, row[..., None]),
        proportions(vertices.beyond_column.swapaxes(0, 1), column[..., None]),
    )


def _whole_lines(signs: Array, name: str) -> Array:
    """Signs (lines, creases); refused if some creases of a line fold and others do not."""
    mixed = (signs == 0).any(axis=1) & (signs != 0).any(axis=1)
    if mixed.any():
        raise DesignError(
            f"some creases of a {name} fold and others stay flat",
            place=f"{name} {int(np.flatnonzero(mixed)[0]) + 1}",
            size="opposite creases of a vertex fold both or neither",
        )
    return signs


def vertices_amiss(flat: Array, signs: CreaseValues) -> Iterator[tuple[str, Booleans]]:
    """At which vertices (R, C) mountains and valleys cannot be as they are, by what is wrong.

    Parameters
    ----------
    flat
        The flat sheet (2, rows, columns, 1).
    signs
        Of its creases, NaN where nothing is said: such vertices are in no list.
    """
    row, column = signs.row, signs.column.T
    mode, amiss = _modes(row, column)
    yield ONE_OF_FOUR, amiss
    yield TOGETHER, ~amiss & _opposed(Vertices.of(flat, mode[..., None]), mode, row, column)


def _modes(row: Array, column: Array) -> tuple[Array, Booleans]:
    """Modes (R, C) of vertices: 1 where row creases have one sign, -1 where column creases have.

    And where both pairs have, or neither: none of these is right there.
    """
    alike, across = row[:, :-1] * row[:, 1:], (column[:, :-1] * column[:, 1:]).T
    flat = (alike == 0) & (across == 0)
    known = ~(np.isnan(alike) | np.isnan(across))
    return np.where(across > 0, -1.0, 1.0), known & ~flat & ((alike > 0) == (across > 0))


def _opposed(vertices: Vertices, mode: Array, row: Array, column: Array) -> Booleans:
    """Where creases (R, C) that have one sign, and what they take with them, have the wrong one."""
    first = mode > 0
    own = np.where(first, column[:, :-1].T, row[:, :-1])
    seen = np.where(first, row[:, :-1], column[:, :-1].T)
    factor = np.where(first, vertices.A[..., 0], vertices.C[..., 0])
    return np.asarray((own * seen * factor > 0) & (np.abs(factor) > SURE))


def _require(holds: Booleans, condition: str) -> None:
    if not holds.all():
        i, j = np.argwhere(~holds)[0]
        raise DesignError(
            condition,
            place=f"vertex {i + 1}, {j + 1}",
            size=f"at {int((~holds).sum())} of {holds.size} inner vertices",
        )

"""The cross-section of a folded sheet: the plane across the line that it rolls about.

From a row to the next but one, all panels turn by the same rotation of space, because the sectors
repeat every two rows. Its axis is the line; every column crease of one kind of row makes the same
angle with it, and so does every row crease of one kind and column. Seen along the line, column 1
is a polygon whose turns alternate between two values, whatever the lengths are.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.families.longitudinal_linear_repeating.motion.mechanism import (
    LongitudinalLinearRepeating,
)
from orishell.families.longitudinal_linear_repeating.motion.rotations import Rotations
from orishell.families.longitudinal_linear_repeating.tessellation.columns import (
    Columns,
    Directions,
    RowKind,
)
from orishell.families.longitudinal_linear_repeating.tessellation.lengths import EdgeLengths
from orishell.motion.quads import dots, lengths
from orishell.numerics.arrays import Array


@record
class Section:
    """How a sheet of m rows, of a solution in the cosine version, rolls up at one drive."""

    axis: Array  # unit direction of the line (3,), to the right; the middle panel is not turned
    heading: Array  # unit direction across the axis (3,) of column 1's first crease
    # of column 1 at every row and one more at either end (m+2,), seen along the line, positive to
    # the left
    turns: Array
    across: Array  # share of its length (m+1,) that every crease of column 1 has across the line
    advance: Array  # share (n-1,) that every crease of the middle row advances along the line

    @property
    def turning(self) -> float:
        """How much column 1 turns, half a row beyond either end included (radians)."""
        return float(self.turns[1:-1].sum() + 0.5 * (self.turns[0] + self.turns[-1]))

    @classmethod
    def of(
        cls, columns: Columns, rows: int, first_row: RowKind, drive: float, side: int
    ) -> Section:
        """The section at a drive > 0 (radians)."""
        # Lengths do not matter. Two rows more, so that even one row shows the repetition.
        total = rows + 2
        n = len(columns)
        other: RowKind = "S" if first_row == "F" else "F"
        lengths = EdgeLengths(np.ones((total, n + 1)), np.ones((total + 1, n)))
        sheet = LongitudinalLinearRepeating(columns, other, lengths, -side)
        panels = sheet.panels(np.asarray(drive))
        directions = Directions.of(columns, total, other)
        down = panels[..., :, 1].turned(-1j * np.exp(1j * directions.column[:, 0]))
        middle = 1 + rows // 2
        right = panels[..., middle + 1, 1:-1].turned(np.exp(1j * directions.row[middle, 1:-1]))

        axis = _axis(panels, directions).ravel()
        axis = axis / np.linalg.norm(axis)
        advance = right @ axis
        if advance.sum() < 0:
            axis, advance = -axis, -advance
        across = down - (down @ axis)[:, None] * axis
        lengths = np.linalg.norm(across, axis=-1)
        across = across / lengths[:, None]
        # Seen along the axis, so turns to the left are turns about its opposite.
        sine = -np.cross(across[:-1], across[1:]) @ axis
        return cls(
            axis=axis,
            heading=across[1],
            turns=np.arctan2(sine, (across[:-1] * across[1:]).sum(axis=-1)),
            across=lengths[1:-1],
            advance=advance,
        )


def turnings(columns: Columns, rows: int, first_row: RowKind, drives: Array, side: int) -> Array:
    """The absolute :attr:`Section.turning` (D,) of m rows at drives (D,).

    The turns of three rows are enough, because all others repeat them: this is for many drives.
    """
    other: RowKind = "S" if first_row == "F" else "F"
    one = columns.first(1)
    edges = EdgeLengths(np.ones((3, 2)), np.ones((4, 1)))
    panels = LongitudinalLinearRepeating(one, other, edges, -side).panels(drives)
    directions = Directions.of(one, 3, other)
    down = panels[..., :, 1].turned(-1j * np.exp(1j * directions.column[:, 0]))
    axis = _axis(panels, directions)
    axis = (axis / lengths(axis)[:, None])[:, None]
    across = down - dots(down, axis)[..., None] * axis
    before, after = across[:, :-1], across[:, 1:]
    turns = np.arctan2(dots(np.cross(before, after), axis), dots(before, after))
    beyond, first = turns[:, 0], turns[:, 1]
    last = beyond if rows % 2 else first
    inner = (rows + 1) // 2 * first + rows // 2 * beyond
    return np.asarray(np.abs(inner + 0.5 * (beyond + last)))


def _axis(panels: Rotations, directions: Directions) -> Array:
    """Vectors (..., 3), of any length, along the line that panels (..., m+1, n+1) roll about."""
    # Frames that lie alike on their row: the rows' own turn in the flat sheet goes with them.
    fan = Rotations.of_vector(np.array([0.0, 0.0, directions.row[2, 1] - directions.row[0, 1]]))
    turn = panels[..., 2, 1] @ fan @ panels[..., 0, 1].inverse()
    return np.stack([turn.b.real, turn.b.imag, turn.a.imag], axis=-1)

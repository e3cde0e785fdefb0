"""What chamfers take off solid boards, which the analysis leaves out: the most of a board."""

from __future__ import annotations

from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.motion.boards import Boards
from orishell.motion.grid import Panel
from orishell.numerics.arrays import Array
from orishell.structure.mesh.strips import bending_left

MOST_THINNED = 0.1
"""Up to this share of the bending stiffness of a board chamfers may be left out: displacements and
stresses are settled to as much."""

EQUAL = 1e-6
"""Shares that differ by less are equal: of boards that are alike the first is named."""


@record
class Thinned:
    """The board of which chamfers take most."""

    share: float  # of its bending stiffness
    panel: Panel  # the panel that has it


def most_thinned(boards: Boards, flat: Array) -> tuple[float, int]:
    """The largest share that chamfers take of a board, and its number.

    flat: The corners of panels in the flat sheet (F, 4, 2).
    """
    gone = 1.0 - bending_left(boards, flat)
    return float(gone.max()), int((gone >= gone.max() - EQUAL).argmax())


def thinned_boards(thinned: Thinned) -> str:
    """By how much boards are thinner, what follows on "has"."""
    row, column = thinned.panel
    return (
        f"boards whose chamfers are left out, and take up to {plain(100 * thinned.share, 2)} % of "
        f"the bending stiffness of one (panel {row}, {column})"
    )


def thinned_in_words(thinned: Thinned | None) -> str:
    """What the analysis leaves out; empty if there are no chamfers."""
    if thinned is None:
        return ""
    share = plain(100 * thinned.share, 2)
    return f"chamfers of boards: they take up to {share} % of the bending stiffness of one"

"""What chamfers take off solid boards, which the analysis leaves out: the most of a board."""

from __future__ import annotations

from typing import TYPE_CHECKING

from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.motion.grid import Panel
from orishell.structure.mesh.strips import bending_left

if TYPE_CHECKING:
    from orishell.structure.model import Model

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


def most_thinned(model: Model) -> Thinned | None:
    """The board of which chamfers take most; None if none is chamfered."""
    build, boards = model.design.panel, model.boards
    if build is None or boards is None or build.construction != "bevel":
        return None
    flat = model.sheet.positions(0.0).reshape(-1, 3)[model.grid.faces_vertices(), :2]
    gone = 1.0 - bending_left(boards, flat)
    first = int((gone >= gone.max() - EQUAL).argmax())
    return Thinned(float(gone.max()), model.panel_at(first))


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

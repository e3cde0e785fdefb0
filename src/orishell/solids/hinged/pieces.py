"""Pieces of whole boards, each a sheet of its own until all are joined at the target."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.conventions.record import record
from orishell.motion import Mechanism
from orishell.motion.boards import Boards
from orishell.motion.hinges import Hinges
from orishell.motion.piece import SheetPiece
from orishell.numerics.arrays import Integers


@record
class BuiltPiece:
    """A piece that folds by itself, with numbers of its own for panels and boards."""

    sheet: Mechanism
    boards: Boards
    panels: Integers  # numbers (F,) of its panels in the whole sheet
    numbers: Integers  # numbers (B,) of its boards among all


def pieces_of(mechanism: Mechanism, boards: Boards) -> list[BuiltPiece]:
    """The pieces of a sheet of whole boards, from its first row on; the sheet itself if whole."""
    hinges = boards.hinges
    assert isinstance(hinges, Hinges)
    across = hinges.levels.shape[1]
    found = []
    for rows in hinges.pieces:
        panels = np.arange(rows.start * across, rows.stop * across)
        own = np.isin(boards.panels, panels)
        part = replace(boards.chosen(own), hinges=hinges.of_piece(rows))
        part = replace(part, panels=part.panels - panels[0])
        sheet = mechanism if hinges.joints is None else SheetPiece(mechanism, rows)
        found.append(BuiltPiece(sheet, part, panels, np.flatnonzero(own)))
    return found

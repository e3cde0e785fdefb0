"""The panels of a design as they are built: boards of the sheet and of its clipped flaps."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.conventions.record import record
from orishell.design import Design, PanelSpec
from orishell.motion import Mechanism
from orishell.motion.boards import Boards
from orishell.motion.grid import UNFOLDED, CreaseValues
from orishell.numerics.arrays import Array, Booleans
from orishell.solids.boards import build_boards
from orishell.solids.setbacks import largest_folds


@record
class BuiltPanels:
    """The panels of a design as they are built.

    Parameters
    ----------
    build
        What they are made of.
    limit
        The drive up to which boards are set back (radians).
    folds
        The largest fold angles of the sheet's creases up to there (radians).
    reliefs
        How far corners of boards are cut off at the sheet's vertices (rows, columns) (length).
    boards
        The boards of the sheet.
    flaps
        Those of the sheet with flaps that are clipped on at its target; None if there are none.
    """

    build: PanelSpec
    limit: float
    folds: CreaseValues
    reliefs: Array
    boards: Boards
    flaps: Boards | None

    def settled(self) -> Booleans:
        """Inner vertices (rows-2, columns-2) about which opposite boards are apart all the way."""
        return settled_vertices(self.folds)

    def with_flaps(self, clipped: Mechanism) -> Boards:
        """All boards, numbered as panels of the sheet with its clipped flaps.

        Parameters
        ----------
        clipped
            The sheet with its flaps.
        """
        assert self.flaps is not None
        inner, across = clipped.inner_columns, clipped.grid.columns - 1
        row, column = np.divmod(self.boards.panels, inner.stop - inner.start - 1)
        own = row * across + column + inner.start
        panels = np.concatenate([own, self.flaps.panels])
        order = np.argsort(panels, kind="stable")
        both = self.boards, self.flaps
        return Boards(
            panels[order],
            np.concatenate([each.sides for each in both])[order],
            np.concatenate([each.outlines for each in both])[order],
        )


def settled_vertices(folds: CreaseValues) -> Booleans:
    """Inner vertices (rows-2, columns-2) about which opposite boards cannot meet.

    Where the two creases of a row, or of a column, do not fold, the others are one straight
    line, and its bisecting plane keeps all boards on one side of it from those on the other.

    Parameters
    ----------
    folds
        Fold angles for which boards are set back (radians).
    """
    row, column = (np.abs(each) < UNFOLDED for each in (folds.row, folds.column))
    return np.asarray((row[:, :-1] & row[:, 1:]) | (column[:-1] & column[1:]))


def build_panels(design: Design, limit: float, reliefs: Array | None = None) -> BuiltPanels:
    """Build the panels of a design.

    Parameters
    ----------
    limit
        The drive up to which boards are set back (radians).
    reliefs
        How far corners are cut off at the sheet's vertices (rows, columns) (length); None if none
        is.

    Raises
    ------
    DesignError
        If nothing is left of a panel.
    """
    build, mechanism = design.panel, design.mechanism
    if build is None:
        raise AssertionError("panels without a thickness are not built")
    grid, folds = mechanism.grid, largest_folds(mechanism, limit)
    none = np.zeros((grid.rows, grid.columns))
    if design.clipped is None:
        boards = build_boards(mechanism.positions(0.0), grid, build, folds, reliefs)
        return BuiltPanels(build, limit, folds, none if reliefs is None else reliefs, boards, None)
    everything = _with_flaps(design.clipped, build, folds, reliefs)
    inner = design.clipped.inner_columns
    row, column = np.divmod(everything.panels, design.clipped.grid.columns - 1)
    mine = (column >= inner.start) & (column < inner.stop - 1)
    number = row * (grid.columns - 1) + column - inner.start
    boards = replace(everything.chosen(mine), panels=number[mine])
    flaps = everything.chosen(~mine)
    return BuiltPanels(build, limit, folds, none if reliefs is None else reliefs, boards, flaps)


def _with_flaps(
    clipped: Mechanism, build: PanelSpec, folds: CreaseValues, reliefs: Array | None
) -> Boards:
    """The boards of the sheet and its flaps, which fold as at the target and no further."""
    at_target = clipped.fold_angles(clipped.target_drive)
    inner = clipped.inner_columns
    row, column = at_target.row.copy(), at_target.column.copy()
    row[:, inner.start : inner.stop - 1] = folds.row
    column[:, inner.start : inner.stop - 2] = folds.column
    if reliefs is not None:
        reliefs = np.pad(reliefs, ((0, 0), (inner.start, clipped.grid.columns - inner.stop)))
    flat = clipped.positions(0.0)
    return build_boards(flat, clipped.grid, build, CreaseValues(row, column), reliefs)

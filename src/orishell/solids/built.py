"""The panels of a design as they are built, and where boards of flaps meet at the target.

Two boards about a crease that folds by phi are at angles w = (pi - phi)/2 to the plane that bisects
it. Their meeting edges, s from the crease and b over the hinge plane, are

    s sin w - b cos w

from that plane: not at all where s = b tan(phi/2). Where a gap sets boards farther back they have
play, and the flap can turn until phi = 2 arctan(s/b).
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.conventions.record import record
from orishell.design import Design, PanelSpec
from orishell.motion import Mechanism
from orishell.motion.boards import SIDES, Boards
from orishell.motion.grid import UNFOLDED, CreaseValues
from orishell.motion.layout import require_grid
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.solids.boards import build_boards
from orishell.solids.hinged import find_hinges
from orishell.solids.setbacks import find_set_backs, largest_folds


@record
class BuiltPanels:
    """The panels of a design as they are built, for the largest folds of its creases on the way."""

    build: PanelSpec
    limit: float  # the drive up to which boards are set back (radians)
    folds: CreaseValues
    # how far corners of boards are cut off at the sheet's vertices (rows, columns) (length)
    reliefs: Array
    boards: Boards
    # boards of flaps that are clipped on at its target; None if there are none
    flaps: Boards | None

    def settled(self) -> Booleans:
        """Inner vertices (rows-2, columns-2) about which opposite boards are apart all the way."""
        return settled_vertices(self.folds)

    def with_flaps(self, clipped: Mechanism) -> Boards:
        """All boards, as panels of the sheet with its flaps: ``clipped``."""
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
    assert build is not None, "panels without a thickness are not built"
    require_grid(mechanism, "made of boards")
    grid, folds = mechanism.grid, largest_folds(mechanism, limit)
    cut = np.zeros((grid.rows, grid.columns)) if reliefs is None else reliefs
    if design.clipped is None:
        hinges = design.hinges
        if build.construction == "hinged" and hinges is None:
            hinges = find_hinges(mechanism, build)
        boards = build_boards(mechanism.positions(0.0), grid, build, folds, reliefs, hinges=hinges)
        return BuiltPanels(build, limit, folds, cut, boards, None)
    everything = _with_flaps(design.clipped, build, folds, reliefs)
    inner = design.clipped.inner_columns
    row, column = np.divmod(everything.panels, design.clipped.grid.columns - 1)
    mine = (column >= inner.start) & (column < inner.stop - 1)
    number = row * (grid.columns - 1) + column - inner.start
    boards = replace(everything.chosen(mine), panels=number[mine])
    flaps = everything.chosen(~mine)
    return BuiltPanels(build, limit, folds, cut, boards, flaps)


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


@record
class Meetings:
    """The row creases of flaps about which two boards meet at the target."""

    # row and column (M,) of the panel above each crease; the other panel is in the next row
    rows: Integers
    columns: Integers
    boards: Integers  # the two boards (M, 2), the one above the crease first
    set_backs: Array  # how far the edges along which they meet are from the crease (M,) (length)
    # from where to where (M, 2) both have such an edge, along the crease from its left end in the
    # flat sheet; alike where the two have none in common (length)
    spans: Array
    plays: Array  # how far apart these edges are (M,) (length)
    angles: Array  # by how much the crease could fold further until they meet (M,) (radians)

    @property
    def lengths(self) -> Array:
        """Along how much of each crease boards meet (M,) (length)."""
        return np.asarray(self.spans[:, 1] - self.spans[:, 0])


def find_meetings(
    mechanism: Mechanism, build: PanelSpec, folds: CreaseValues, boards: Boards
) -> Meetings:
    """Where boards of flaps, folded or clipped on, meet at the target, if a crease has both.

    The fold angles are the largest, those that the boards were set back for.
    """
    grid, flat = mechanism.grid, mechanism.positions(0.0)
    across = grid.columns - 1
    at_target = mechanism.fold_angles(mechanism.target_drive).row
    flaps = np.array(mechanism.flap_columns, dtype=np.int64)
    rows, columns = (
        each.ravel() for each in np.meshgrid(np.arange(grid.rows - 2), flaps, indexing="ij")
    )
    closing = np.sign(at_target[rows, columns]).astype(np.int64)

    # Boards by panel and side.
    number = np.full((grid.panel_count, len(SIDES)), -1)
    number[boards.panels, boards.sides + 1] = np.arange(len(boards))
    side = 0 * closing if build.is_solid else closing
    panel = rows * across + columns
    pair = np.stack([number[panel, side + 1], number[panel + across, side + 1]], axis=-1)
    there = (pair >= 0).all(axis=1)
    rows, columns, closing, pair = rows[there], columns[there], closing[there], pair[there]

    left, right = (flat[rows + 1, columns + k, :2] for k in (0, 1))
    level = np.where(closing > 0, -1, 0)
    # The bottom edge of the board above, the top edge of the one below.
    ends = [
        _along(_side(boards.outlines[pair[:, k], level, :, :2], edge), left, right)
        for k, edge in enumerate((1, 3))
    ]
    start, stop = np.maximum(*ends)[:, 0], np.minimum(*ends)[:, 1]

    found = find_set_backs(folds, build.height, build.gap)
    edge = (rows + 1) * across + columns
    back = np.where(closing > 0, found.top[edge], found.bottom[edge])
    fold = np.abs(at_target[rows, columns])
    half = 0.5 * (np.pi - fold)
    return Meetings(
        rows,
        columns,
        pair,
        back,
        np.stack([start, np.maximum(start, stop)], axis=-1),
        2 * (back * np.sin(half) - build.height * np.cos(half)),
        2 * np.arctan2(back, build.height) - fold,
    )


def _side(outlines: Array, edge: int) -> Array:
    """Ends (M, 2, 2) of the sides of outlines (M, K, 2) that follow an edge of their panels."""
    corners = outlines.shape[1]
    first = edge if corners == 4 else 2 * edge + 1
    return outlines[:, [first, (first + 1) % corners]]


def _along(points: Array, left: Array, right: Array) -> Array:
    """How far points (M, 2, 2) are along lines from left to right (M, 2), nearest first."""
    way = right - left
    way /= np.hypot(way[:, 0], way[:, 1])[:, None]
    return np.sort(np.einsum("mkx,mx->mk", points - left[:, None], way), axis=1)

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
from orishell.motion.as_made import panels_laid_flat
from orishell.motion.boards import BARE, SIDES, Boards, join_boards
from orishell.motion.grid import UNFOLDED, CreaseValues
from orishell.motion.layout import Layout, SlitFlaps
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.solids.boards import boards_on
from orishell.solids.hinged import find_hinges
from orishell.solids.setbacks import largest_flap_folds, largest_folds, set_backs_of
from orishell.solids.sides import FlapFolds, SideFolds


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
    # the membranes of both where they have boards on one face; none of others
    bare: Boards | None = None
    bare_flaps: Boards | None = None
    # the largest folds of flaps that fold with the sheet but are no columns of it, if there are any
    beside: FlapFolds | None = None

    def settled(self) -> Booleans:
        """Inner vertices (rows-2, columns-2) about which opposite boards are apart all the way."""
        return settled_vertices(self.folds)

    @property
    def bodies(self) -> Boards:
        """All that must not meet on the way: boards, and membranes with boards on one face."""
        return (
            self.boards if self.bare is None else join_boards([self.boards, self.bare]).in_order()
        )

    def with_flaps(self, clipped: Mechanism) -> Boards:
        """All that must not meet, as panels of the sheet with its flaps: ``clipped``."""
        assert self.flaps is not None
        bodies, beside = self.bodies, [self.flaps]
        if self.bare_flaps is not None:
            beside.append(self.bare_flaps)
        own = _with_flaps_columns(bodies.panels, clipped)
        return join_boards([replace(bodies, panels=own), *beside]).in_order()


def _with_flaps_columns(panels: Integers, clipped: Mechanism) -> Integers:
    """Numbers (B,) of panels of a sheet, as panels of it with its flaps: ``clipped``."""
    inner, across = clipped.inner_columns, clipped.grid.columns - 1
    row, column = np.divmod(panels, inner.stop - inner.start - 1)
    return np.asarray(row * across + column + inner.start)


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
    grid, folds = mechanism.grid, largest_folds(mechanism, limit)
    cut = np.zeros((grid.rows, grid.columns)) if reliefs is None else reliefs
    if design.clipped is None:
        hinges = design.hinges
        if build.construction == "hinged" and not hinges.beside:
            hinges = find_hinges(mechanism, build)
        beside = largest_flap_folds(mechanism, limit)
        boards = boards_on(
            panels_laid_flat(mechanism),
            Layout.of(mechanism),
            build,
            folds,
            reliefs=reliefs,
            beside=beside,
            hinges=hinges,
            least=0.0 if design.stand_off is None else design.stand_off,
        )
        boards, bare = _parted(boards)
        return BuiltPanels(build, limit, folds, cut, boards, None, bare, beside=beside)
    everything = _with_flaps(design.clipped, build, folds, reliefs)
    own = _with_flaps_columns(np.arange(grid.panel_count), design.clipped)
    mine = np.isin(everything.panels, own)
    boards = everything.chosen(mine)
    boards, bare = _parted(replace(boards, panels=np.searchsorted(own, boards.panels)))
    flaps, bare_flaps = _parted(everything.chosen(~mine))
    return BuiltPanels(build, limit, folds, cut, boards, flaps, bare, bare_flaps)


def _parted(boards: Boards) -> tuple[Boards, Boards | None]:
    """Boards, and membranes with boards on one face; None if there are none."""
    bare = boards.sides == BARE
    return (boards.chosen(~bare), boards.chosen(bare)) if bare.any() else (boards, None)


def _with_flaps(
    clipped: Mechanism, build: PanelSpec, folds: CreaseValues, reliefs: Array | None
) -> Boards:
    """The boards of the sheet and its flaps, which fold as at the target and no further."""
    target = clipped.target_drive
    at_target = clipped.fold_angles(target)
    inner = clipped.inner_columns
    row, column = at_target.row.copy(), at_target.column.copy()
    row[:, inner.start : inner.stop - 1] = folds.row
    column[:, inner.start : inner.stop - 2] = folds.column
    if reliefs is not None:
        reliefs = np.pad(reliefs, ((0, 0), (inner.start, clipped.grid.columns - inner.stop)))
    panels, beside = panels_laid_flat(clipped), FlapFolds.at(clipped, target)
    all_folds = CreaseValues(row, column)
    return boards_on(panels, Layout.of(clipped), build, all_folds, reliefs=reliefs, beside=beside)


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


@record
class _RowCreases:
    """Row creases (M,) of flaps."""

    panels: Integers  # (M, 2), the one above each and the one below
    sides: Integers  # (M, 2) of these panels at the crease
    names: Integers  # (M, 2), row and column of the panel above
    folds: Array  # fold angles (M,) at the target (radians)

    @classmethod
    def of(cls, mechanism: Mechanism) -> _RowCreases:
        """Those of columns that are flaps, or of flaps beside the grid."""
        layout, target = Layout.of(mechanism), mechanism.target_drive
        if isinstance(mechanism, SlitFlaps):
            pairs, (_, sides) = layout.pairs, layout.folding_sides
            names = layout.names[pairs[:, 0]]
            return cls(pairs, sides, names, mechanism.flap_folds(target))
        rows, columns = (
            each.ravel()
            for each in np.meshgrid(
                np.arange(mechanism.grid.rows - 2),
                np.array(mechanism.flap_columns, dtype=np.int64),
                indexing="ij",
            )
        )
        across = mechanism.grid.columns - 1
        panel = rows * across + columns
        return cls(
            np.stack([panel, panel + across], axis=-1),
            np.broadcast_to([1, 3], (len(rows), 2)),
            np.stack([rows, columns], axis=-1),
            mechanism.fold_angles(target).row[rows, columns],
        )

    def chosen(self, which: Booleans) -> _RowCreases:
        """Those at which ``which`` (M,) is true."""
        return _RowCreases(
            self.panels[which],
            self.sides[which],
            self.names[which],
            self.folds[which],
        )


def find_meetings(
    mechanism: Mechanism,
    build: PanelSpec,
    folds: CreaseValues,
    boards: Boards,
    beside: FlapFolds | None = None,
) -> Meetings:
    """Where boards of flaps, folded or clipped on, meet at the target, if a crease has both.

    The fold angles are the largest, those that the boards were set back for.

    Parameters
    ----------
    beside
        Those of flaps that are no columns of the grid, if there are such flaps.
    """
    layout, lying = Layout.of(mechanism), panels_laid_flat(mechanism)
    creases = _RowCreases.of(mechanism)

    # Boards by panel and side.
    number = np.full((len(layout.faces), len(SIDES)), -1)
    number[boards.panels, boards.sides + 1] = np.arange(len(boards))
    closing = np.sign(creases.folds).astype(np.int64)
    side = 0 * closing if build.is_solid else closing
    pair = number[creases.panels, side[:, None] + 1]
    there: Booleans = np.asarray((pair >= 0).all(axis=1))
    creases, closing, pair = creases.chosen(there), closing[there], pair[there]

    # Seen from the upper panel, the crease goes from left to right along its side.
    upper, first = creases.panels[:, 0], creases.sides[:, 0]
    left, right = (lying[upper, (first + k) % 4] for k in (0, 1))
    level = np.where(closing > 0, -1, 0)
    ends = [
        _along(_side(boards.outlines[pair[:, k], level, :, :2], creases.sides[:, k]), left, right)
        for k in (0, 1)
    ]
    start, stop = np.maximum(*ends)[:, 0], np.minimum(*ends)[:, 1]

    found = set_backs_of(SideFolds.of(layout, folds, beside), build.heights, build.gap)
    back = np.where(closing > 0, found.top[upper, first], found.bottom[upper, first])
    fold = np.abs(creases.folds)
    half = 0.5 * (np.pi - fold)
    return Meetings(
        creases.names[:, 0],
        creases.names[:, 1],
        pair,
        back,
        np.stack([start, np.maximum(start, stop)], axis=-1),
        2 * (back * np.sin(half) - build.height * np.cos(half)),
        2 * np.arctan2(back, build.height) - fold,
    )


def _side(outlines: Array, sides: Integers) -> Array:
    """Ends (M, 2, 2) of the edges of outlines (M, K, 2) that follow sides (M,) of their panels."""
    corners = outlines.shape[1]
    first = sides if corners == 4 else 2 * sides + 1
    rows = np.arange(len(outlines))[:, None]
    return np.asarray(outlines[rows, (first[:, None] + [0, 1]) % corners])


def _along(points: Array, left: Array, right: Array) -> Array:
    """How far points (M, 2, 2) are along lines from left to right (M, 2), nearest first."""
    way = right - left
    way /= np.hypot(way[:, 0], way[:, 1])[:, None]
    return np.sort(np.einsum("mkx,mx->mk", points - left[:, None], way), axis=1)

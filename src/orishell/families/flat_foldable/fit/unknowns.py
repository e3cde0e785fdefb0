"""The unknowns of a fit: what makes a sheet, where it is, and how far it stands on both sides."""

from __future__ import annotations

from functools import cached_property

import numpy as np

from orishell.conventions.record import record
from orishell.design.piece import Piece
from orishell.families.flat_foldable.locks.straight import straight_bordered
from orishell.families.flat_foldable.named import graded_net
from orishell.families.flat_foldable.net import CORNERS, Net, Sheet
from orishell.families.shared.folding import HalfFolds, Numbers, fold, turned
from orishell.motion.quads import lengths
from orishell.numerics.arrays import Array

STEP = 1e-25
"""Of complex steps: derivatives are then exact to rounding."""
PERIOD = 3
"""Rows or columns that show how a Miura-ori goes on."""
ROTATION, SHIFT, OFFSET = slice(-7, -4), slice(-4, -1), -1
"""The last unknowns."""


@record
class Placed:
    """A sheet where it is at the target."""

    sheet: Sheet
    flat: Array  # (2, R+2, C+2), vertices in the flat sheet
    folded: Array  # (3, R+2, C+2), vertices about the middle one, before it is placed
    vertices: Array  # (R+2, C+2, 3)


@record
class Unknowns:
    """A Miura-ori sheet that covers the mean plane of a piece, and sheets about it.

    Unknowns (P,) are logarithms of tangents of half fold angles, row and column angles of the net,
    logarithms of lengths, corners, a rotation vector, a shift and the offset. Lengths of the shift
    and the offset are in the unit ``size``.
    """

    start: Net
    size: float  # mean size of the piece (length)
    frame: Array  # (3, 3): from the folded sheet's axes to those of the world
    place: Array  # (3,), of its middle vertex at the start
    lift: float  # 1 if even rows are above the surface, -1 if they are below
    first: Array  # the unknowns (P,) at the start
    # whether the right border is straight: it is then the last column of the nets, and what they
    # have beyond it changes nothing
    straight: bool = False

    @classmethod
    def covering(
        cls,
        piece: Piece,
        rows: int,
        columns: int,
        sector: float,
        folded: float,
        *,
        straight: bool = False,
    ) -> Unknowns:
        """The Miura-ori with a sector angle and a fold angle of its row creases (radians).

        If the fold angle is negative, rows that are crests otherwise are valleys.
        """
        across, along = _plan(piece)
        # Of four more there is the same at the middle, and a period, which it takes three for.
        wider = [each + 4 if each < PERIOD else each for each in (rows, columns)]
        frame, period = _frame(graded_net(*wider, folds=[folded], sectors=[sector]))
        start = graded_net(
            rows,
            columns + straight,
            folds=[folded],
            sectors=[sector],
            row_lengths=[across / (columns + 1) / period[0]],
            column_lengths=[along / (rows + 1) / period[1]],
        )
        frame = piece.axes.T @ frame
        laid = np.einsum("ab,bij->aij", frame, _folded(start, straight=straight))
        middle = laid.reshape(3, -1).mean(axis=1)
        heights = np.einsum("a,aij->ij", piece.axes[2], laid - middle[:, None, None])
        offset = 0.5 * float(heights[::2].mean() - heights[1::2].mean())
        size = float(np.sqrt(across * along))
        edges = start.row_lengths, start.column_lengths
        border = start.top, start.bottom, start.left, start.right
        first = np.concatenate(
            [
                np.log(np.abs(start.x)).ravel(),
                np.log(np.abs(start.y)).ravel(),
                start.row_angles.ravel(),
                np.delete(start.column_angles, rows // 2, axis=0).ravel(),
                *(np.log(each).ravel() for each in (*edges, *border)),
                start.corners.ravel(),
                np.zeros(6),
                [abs(offset) / size],
            ]
        )
        lift = float(np.sign(offset))
        return cls(start, size, frame, piece.centre - middle, lift, first, straight)

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns of vertices."""
        return len(self.start.x) + 2, len(self.start.y) + 2 - self.straight

    @cached_property
    def parts(self) -> list[slice]:
        """Of x, y, row and column angles, lengths of rows and columns, borders, and corners."""
        rows, columns = len(self.start.x), len(self.start.y)
        inner = [rows, columns, columns, rows - 1, columns - 1, rows - 1]
        sizes = [*inner, columns, columns, rows, rows, 8]
        ends = np.cumsum(sizes).tolist()
        return [slice(end - size, end) for end, size in zip(ends, sizes, strict=True)]

    def net(self, unknowns: Numbers) -> Net:
        """The nets of unknowns (P, B)."""
        start = self.start
        x, y, row, column, *edges, corners = (unknowns[part] for part in self.parts)
        row_lengths, column_lengths, top, bottom, left, right = (np.exp(each) for each in edges)
        i, j = start.middle
        return Net(
            np.sign(start.x) * np.exp(x),
            np.sign(start.y) * np.exp(y),
            row,
            np.concatenate([column[:i], row[j : j + 1], column[i:]]),
            row_lengths,
            column_lengths,
            top,
            bottom,
            left,
            right,
            corners.reshape(4, 2, -1),
        )

    def _sheet(self, unknowns: Numbers) -> Sheet:
        net = self.net(unknowns)
        return straight_bordered(net) if self.straight else net.march()

    def placed(self, unknowns: Array) -> Placed:
        """The sheet of unknowns (P,); not numbers where there is none."""
        with np.errstate(all="ignore"):
            sheet = self._sheet(unknowns[:, None])
            flat = sheet.flat()
            folded = _fold(sheet, flat)
        moved = turned(folded, unknowns[ROTATION, None])[..., 0]
        vertices = np.einsum("ab,bij->ija", self.frame, moved)
        vertices += self.place + self.size * self.frame @ unknowns[SHIFT]
        return Placed(sheet, flat[..., 0], folded[..., 0], vertices)

    @cached_property
    def at_first(self) -> Placed:
        """The sheet at the start."""
        return self.placed(self.first)

    def slopes(self, unknowns: Array, placed: Placed) -> Array:
        """Derivatives (R+2, C+2, 3, P) of vertices by the unknowns.

        By complex steps those of what makes the inner sheet, all in one march. The border follows
        from them: a border length moves its vertex along its crease, and the corners beside it.
        """
        count = len(unknowns)
        inner = self.parts[-1 if self.straight else 5].stop
        steps = np.eye(count, inner)
        sheet = self._sheet(unknowns[:, None] + 1j * STEP * steps)
        found = np.zeros((*placed.folded.shape, count))
        found[..., :inner] = _fold(sheet, sheet.flat()).imag / STEP
        if not self.straight:
            self._add_border(found, unknowns, placed.folded)
        rotation = unknowns[ROTATION]
        moved = turned(found, np.broadcast_to(rotation[:, None], (3, count)))
        spun = np.broadcast_to(placed.folded[..., None], (*placed.folded.shape, 3))
        moved[..., ROTATION] = (
            turned(spun.astype(np.complex128), rotation[:, None] + 1j * STEP * np.eye(3)).imag
            / STEP
        )
        moved[..., SHIFT] = self.size * np.eye(3)[:, None, None]
        return np.asarray(np.einsum("ab,bijp->ijap", self.frame, moved, optimize=True))

    def _add_border(self, found: Array, unknowns: Array, folded: Array) -> None:
        top, bottom, left, right = (np.arange(part.start, part.stop) for part in self.parts[6:10])
        across, down = 1 + np.arange(len(top)), 1 + np.arange(len(left))
        for row, beside, part in ((0, 1, top), (-1, -2, bottom)):
            found[:, row, across, part] = folded[:, row, across] - folded[:, beside, across]
        for column, beside, part in ((0, 1, left), (-1, -2, right)):
            found[:, down, column, part] = folded[:, down, column] - folded[:, down, beside]
        shares = unknowns[self.parts[10]].reshape(4, 2)
        places = np.arange(self.parts[10].start, self.parts[10].stop).reshape(4, 2)
        ends = ((top, left), (top, right), (bottom, left), (bottom, right))
        for (row, column), share, place, (level, upright) in zip(
            CORNERS, shares, places, ends, strict=True
        ):
            near = 1 if row == 0 else -2, 1 if column == 0 else -2
            # Along the row by the first share, to the end of the left or right border's crease.
            along = upright[0 if row == 0 else -1], (near[0], column)
            up = level[0 if column == 0 else -1], (row, near[1])
            for number, (part, (i, j)) in enumerate((along, up)):
                step = folded[:, i, j] - folded[:, near[0], near[1]]
                found[:, row, column, part] = share[number] * step
                found[:, row, column, place[number]] = step

    @cached_property
    def sides(self) -> Array:
        """On which side (R+2, 1) of the surface each row is."""
        rows = np.arange(len(self.start.x) + 2)
        return self.lift * np.where(rows % 2 == 0, 1.0, -1.0)[:, None]


def _fold(sheet: Sheet, flat: Numbers) -> Numbers:
    """Vertices (3, R+2, C+2, B) at the target."""
    return fold(flat, HalfFolds.of(sheet.tangents(), 1.0, 1.0), sheet.net.middle)


def _folded(net: Net, *, straight: bool = False) -> Array:
    sheet = straight_bordered(net) if straight else net.march()
    return np.asarray(_fold(sheet, sheet.flat())[..., 0])


def _frame(net: Net) -> tuple[Array, tuple[float, float]]:
    """Axes (3, 3) of a folded Miura-ori, and how far it goes on with a panel across and along."""
    places = _folded(net)
    # One period has two rows and two columns.
    across, up = places[:, 1, 3] - places[:, 1, 1], places[:, 1, 1] - places[:, 3, 1]
    period = 0.5 * float(lengths(across)), 0.5 * float(lengths(up))
    across /= lengths(across)
    up -= (up @ across) * across
    up /= lengths(up)
    return np.stack([across, up, np.cross(across, up)]), period


def _plan(piece: Piece) -> tuple[float, float]:
    """Mean extents of a piece along its mean plane (lengths)."""
    corners = np.stack([piece.vertices[side[0]] for side in piece.sides]) @ piece.axes.T
    a, b, c, d = corners
    across = 0.5 * (b - a + c - d)[0]
    along = 0.5 * (a - d + b - c)[1]
    return float(across), float(along)

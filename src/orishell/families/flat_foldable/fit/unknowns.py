"""The unknowns of a fit: what makes a sheet, where it is, and how far it stands on both sides."""

from __future__ import annotations

from functools import cached_property

import numpy as np

from orishell.conventions.record import record
from orishell.design.piece import Piece
from orishell.families.flat_foldable.folding import HalfFolds, Numbers, fold
from orishell.families.flat_foldable.mechanism import turned
from orishell.families.flat_foldable.named import graded_net
from orishell.families.flat_foldable.net import Net, Sheet
from orishell.numerics.arrays import Array

POSE = 7
"""Rotation vector, shift, and offset: the last unknowns."""


@record
class Unknowns:
    """A Miura sheet that covers the mean plane of a piece, and sheets about it.

    Unknowns (P,) are logarithms of lengths and of tangents of half fold angles, row and column
    angles of the net, corners, a rotation vector, a shift and the offset of crests and valleys.
    """

    start: Net
    frame: Array  # (3, 3): from the folded sheet's axes to those of the world
    shift: Array  # (3,), of its middle vertex at the start
    lift: float  # 1 if even rows are above, -1 if they are below
    first: Array  # the unknowns (P,) at the start

    @classmethod
    def covering(
        cls, piece: Piece, rows: int, columns: int, sector: float, folded: float
    ) -> Unknowns:
        """The Miura sheet with a sector angle and a fold angle of its row creases (radians)."""
        unit = graded_net(rows, columns, folds=[folded], sectors=[sector])
        places = _folded(unit)
        # One period has two rows and two columns.
        along, up = places[:, 1, 3] - places[:, 1, 1], places[:, 1, 1] - places[:, 3, 1]
        across, high = piece.extents
        wide = 2 * across / (columns + 1) / np.linalg.norm(along)
        tall = 2 * high / (rows + 1) / np.linalg.norm(up)
        start = graded_net(
            rows,
            columns,
            folds=[folded],
            sectors=[sector],
            row_lengths=[wide],
            column_lengths=[tall],
        )
        places = _folded(start)
        along, up = places[:, 1, 3] - places[:, 1, 1], places[:, 1, 1] - places[:, 3, 1]
        along /= np.linalg.norm(along)
        up -= (up @ along) * along
        up /= np.linalg.norm(up)
        frame = piece.axes.T @ np.stack([along, up, np.cross(along, up)])
        laid = np.einsum("ab,bij->aij", frame, places)
        middle = laid.reshape(3, -1).mean(axis=1)
        heights = np.einsum("a,aij->ij", piece.axes[2], laid - middle[:, None, None])
        offset = 0.5 * float(heights[::2].mean() - heights[1::2].mean())
        lengths = (
            start.row_lengths,
            start.column_lengths,
            start.top,
            start.bottom,
            start.left,
            start.right,
        )
        first = np.concatenate(
            [
                np.log(np.abs(start.x)).ravel(),
                np.log(np.abs(start.y)).ravel(),
                start.row_angles.ravel(),
                np.delete(start.column_angles, rows // 2, axis=0).ravel(),
                *(np.log(each).ravel() for each in lengths),
                start.corners.ravel(),
                np.zeros(6),
                [abs(offset)],
            ]
        )
        return cls(start, frame, piece.centre - middle, float(np.sign(offset)), first)

    @cached_property
    def parts(self) -> list[slice]:
        """Where what stands: as in ``first``."""
        net = self.start
        rows, columns = len(net.x), len(net.y)
        sizes = [
            rows,
            columns,
            columns,
            rows - 1,
            columns - 1,
            rows - 1,
            columns,
            columns,
            rows,
            rows,
            8,
        ]
        ends = np.cumsum(sizes).tolist()
        return [slice(end - size, end) for end, size in zip(ends, sizes, strict=True)]

    def sheet(self, unknowns: Numbers) -> Sheet:
        """The sheets of unknowns (P, B)."""
        net = self.start
        x, y, row, column, *lengths, corners = (unknowns[part] for part in self.parts)
        i, j = net.middle
        return Net(
            np.sign(net.x) * np.exp(x),
            np.sign(net.y) * np.exp(y),
            row,
            np.concatenate([column[:i], row[j : j + 1], column[i:]]),
            *(np.exp(each) for each in lengths),
            corners.reshape(4, 2, -1),
        ).march()

    def places(self, sheet: Sheet, flat: Numbers, unknowns: Numbers) -> Numbers:
        """Vertices (3, R+2, C+2, B) at the target."""
        folded = fold(flat, HalfFolds.of(sheet.tangents(), 1.0, 1.0), sheet.net.middle)
        rotation, shift = unknowns[-POSE:-4], unknowns[-4:-1]
        moved = turned(folded, rotation) + shift[:, None, None]
        return np.einsum("ab,bijk->aijk", self.frame, moved) + self.shift[:, None, None, None]

    @cached_property
    def places_at_start(self) -> Array:
        """Vertices (R+2, C+2, 3) at the start."""
        sheet = self.sheet(self.first[:, None])
        places = self.places(sheet, sheet.flat(), self.first[:, None])
        return np.moveaxis(places[..., 0], 0, -1)

    @cached_property
    def smoothing(self) -> Array:
        """Rows (K, P): second differences of lists, and how far they are from the start."""
        whole = np.eye(len(self.first))
        x, y, row, column, along, down, *borders = self.parts
        bends = [np.diff(whole[part], 2, axis=0) for part in (x, y, row, column, along, down)]
        kept = [0.3 * whole[part] for part in borders] + [0.1 * whole[part] for part in (x, y)]
        return np.concatenate([*bends, *kept])

    @cached_property
    def sides(self) -> Array:
        """On which side (R+2, 1) of the surface each row is."""
        return self.lift * np.where(np.arange(len(self.start.x) + 2) % 2 == 0, 1.0, -1.0)[:, None]


def _folded(net: Net) -> Array:
    """Vertices (3, R+2, C+2) of a sheet at the target."""
    sheet = net.march()
    folds = HalfFolds.of(sheet.tangents(), 1.0, 1.0)
    return np.asarray(fold(sheet.flat(), folds, net.middle)[..., 0])

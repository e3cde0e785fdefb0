"""Conditions for a flat sheet to fold, each of a few creases, and their derivatives.

Four vertices round a panel fold together: from its upper row crease over the vertices at its left
to its lower one, and over those at its right, at some heights of the upper row. Single vertices may
be asked to be flat-foldable, or to have opposite creases in one line. Everything depends on the
directions in which creases leave vertices, and not on how a vertex is turned as a whole.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.record import record
from orishell.families.drawn.cross import Cross, proportions
from orishell.families.drawn.drive import Drive
from orishell.families.drawn.vertex import Numbers, Vertices, ways
from orishell.numerics.arrays import Array, Booleans, Integers

if TYPE_CHECKING:
    from scipy.sparse import csr_array

SHARES = np.cos(np.pi * np.array([7, 5, 3, 1]) / 16)
"""Heights of the upper row at which the vertices round a panel are to agree, by the largest."""
OPEN = 0.05
"""Cosines of half the fold angles stay above it: next to closing errors have no bounds."""
SCANNED = np.pi * np.linspace(0.0, 1.0, 65)[1:-1] ** 3
"""Fold angles that are tried in search of the largest height, which may be small (radians)."""
BLOCK = 64
"""Panels that are seen together: what is found of them fits a processor's cache."""
STEP, DIFFERENCE = 1e-30, 1e-6
"""Of derivatives by complex steps, which lose nothing, and of differences of these (radians)."""
KINDS = np.array([[-1, 1, -1, 1], [-1, 0, 1, 0], [0, -1, 0, 1]])
"""Sums of the directions right, up, left and down that are multiples of 180 degrees at vertices
that are flat-foldable, whose row creases are in one line, and whose column creases are."""
AS_NEARLY = 3.0
"""Conditions of single vertices nearly hold up to so many times what the worst panel misses."""
LAST = slice(1, None)
FREE = np.array([[1, 0, 0], [0, 1, 0], [0, 0, 1], [-1, -1, -1]])
"""Derivatives by four directions of a vertex from those by three: they add up to nothing."""


@record
class Conditions:
    """Those of sheets of one size, P of their panels, N conditions in all."""

    corners: tuple[Integers, Integers]  # rows and columns (2, 2, P) of the vertices round panels
    mode: Array  # their modes (2, 2, P)
    rows: Array  # signs (2, 3, P) of the row creases at these vertices
    columns: Array  # and (2, 3, P) of the column creases
    heights: Array  # sines (P, K) of half the angle of the crease that folds most in the upper row
    kinds: Booleans  # which inner vertices (3, R, C) are to be of which of KINDS

    @classmethod
    def of(cls, flat: Array, drive: Drive) -> Conditions:
        """Those of a flat sheet (2, rows, columns), with the rows and columns of its drive.

        Lines that stay unfolded are left out, and what crosses them is to go straight on.
        """
        mode = drive.cross.vertices.mode[..., 0]
        signs, across = (np.sign(each[..., 0]) for each in (drive.cross.rows, drive.cross.columns))
        row, column = (np.flatnonzero(each[:, 0]) for each in (signs, across))
        above, left = (each.ravel() for each in np.meshgrid(row[:-1], column[:-1], indexing="ij"))
        below, right = (each.ravel() for each in np.meshgrid(row[1:], column[1:], indexing="ij"))
        at = np.array([[above, above], [below, below]]), np.array([[left, right], [left, right]])
        found = cls(
            at,
            mode[at],
            rows=_beside(signs, at[0][:, 0], left, right),
            columns=_beside(across, at[1][0], above, below),
            heights=np.zeros((len(above), len(SHARES))),
            kinds=np.stack(
                [
                    np.zeros(mode.shape, dtype=np.bool_),
                    (signs[:, :1] != 0) & (across[:, 0] == 0),
                    (signs[:, :1] == 0) & (across[:, 0] != 0),
                ]
            ),
        )
        largest = [found._largest(seen, part) for seen, part in found._blocks(flat)]
        return replace(found, heights=np.concatenate([*largest, np.zeros(0)])[:, None] * SHARES)

    def misses(self, flat: Array) -> Array:
        """By how much they fail (N,) on a flat sheet (2, rows, columns) (radians)."""
        angles = np.arctan2(*ways(flat).swapaxes(0, 1)[::-1])
        sums = np.tensordot(KINDS, angles, 1)
        apart = [self._apart(seen[..., None], part).ravel() for seen, part in self._blocks(flat)]
        return np.concatenate([*apart, (sums - np.pi * np.round(sums / np.pi))[self.kinds]])

    def derivatives(self, flat: Array) -> csr_array:
        """Their derivatives (N, 2 V) by all coordinates, x first."""
        from scipy.sparse import csr_array, vstack

        slopes = [self._slopes(seen, part) for seen, part in self._blocks(flat)]
        count, size = self.heights.shape[1], 4 * self.kinds[0].size
        numbers = np.repeat(self._numbers(), count, axis=0)
        values = np.concatenate([*slopes, np.zeros((0, 16, count))]).swapaxes(1, 2)
        of_panels = _by_directions(values, numbers, size)
        return csr_array(vstack([of_panels, self._of_kinds()]) @ _turns(flat))

    def bends(self, flat: Array, forces: Array) -> csr_array:
        """Second derivatives (2 V, 2 V), by all coordinates, of their sum times forces (N,)."""
        from scipy.sparse import coo_array, csr_array

        count, turns = self.heights.size, _turns(flat)
        pull = self._of_kinds().T @ forces[count:]
        of_panels, numbers = forces[:count].reshape(self.heights.shape), self._numbers()
        bent = np.zeros((len(numbers), 16, 16))
        for seen, part in self._blocks(flat):
            slopes = self._slopes(seen, part)
            np.add.at(pull, numbers[part], np.einsum("pdk,pk->pd", slopes, of_panels[part]))
            moved = [
                np.einsum("pdk,pk->pd", self._slopes(each, part) - slopes, of_panels[part])
                for each in seen + DIFFERENCE * _turning(seen)
            ]
            by_three = np.stack(moved, axis=1).reshape(-1, 3, 4 * 16) / DIFFERENCE
            bent[part] = (FREE @ by_three).reshape(-1, 16, 16)
        pairs = np.repeat(numbers, 16, axis=1).ravel(), np.tile(numbers, 16).ravel()
        of_turns = coo_array((bent.ravel(), pairs), shape=2 * pull.shape)
        return csr_array(turns.T @ of_turns @ turns + _turns_of_turns(flat, pull))

    def nearly(self, flat: Array) -> Booleans:
        """Which vertices (3, R, C) are of which of KINDS, as nearly as panels nearly fold.

        Measured by how far vertices are to be moved for each condition alone.
        """
        every = replace(self, kinds=np.ones_like(self.kinds))
        slopes = every.derivatives(flat)
        least = np.abs(every.misses(flat)) / np.sqrt((slopes * slopes).sum(axis=1))
        of_panels, of_kinds = np.split(least, [self.heights.size])
        return np.asarray(
            of_kinds.reshape(self.kinds.shape) <= AS_NEARLY * of_panels.max(initial=0.0)
        )

    def _blocks(self, flat: Array) -> Iterator[tuple[Array, slice]]:
        """Ways (4, 2, 2, 2, p) from the vertices round some panels, and which panels."""
        there = ways(flat)
        for start in range(0, len(self.heights), BLOCK):
            part = slice(start, start + BLOCK)
            yield there[:, :, self.corners[0][..., part], self.corners[1][..., part]], part

    def _cross(self, seen: Numbers, part: slice) -> Cross:
        """The first row and column (P, S, 1) of vertices round panels, of ways (..., P, S)."""
        mode, rows, columns = (
            each[..., part, None, None] for each in (self.mode, self.rows, self.columns)
        )
        vertices = Vertices.of_ways(seen[..., None], mode)
        down = vertices.beyond_column.swapaxes(0, 1)
        return Cross(vertices, proportions(vertices.beyond_row, rows), proportions(down, columns))

    def _largest(self, seen: Array, part: slice) -> Array:
        """The largest height (P,) of the upper row at which no crease is near closing."""
        cross = self._cross(seen[..., None], part)
        height = np.sin(0.5 * SCANNED), np.cos(0.5 * SCANNED)
        folds = cross.folds(*cross.from_row(height))
        open_yet = np.ones(folds.row[0].shape[2:], dtype=np.bool_)
        for cosine, _ in (folds.row, folds.column):
            open_yet &= (cosine > OPEN).all(axis=(0, 1))
        count = np.cumprod(open_yet[:, 0], axis=1).sum(axis=1)
        return np.where(count > 0, height[0][count - 1], np.nan)

    def _apart(self, seen: Numbers, part: slice) -> Numbers:
        """By how much the last vertices round panels (P, S, K) disagree, of ways (..., P, S)."""
        cross, heights = self._cross(seen, part), self.heights[part, None]
        rows, columns = cross.from_row((heights, np.sqrt(1 - heights * heights)))
        last = Cross(cross.vertices.at(LAST, LAST), cross.rows[1:, 1:], cross.columns[1:, 1:])
        folds = last.folds((rows[0][1:], rows[1][1:]), (columns[0][1:], columns[1][1:]))
        return np.asarray(last.disagreement(folds)[0, 0])

    def _slopes(self, seen: Array, part: slice) -> Array:
        """Derivatives (P, 16, K) of that by directions: by ways, then by corners."""
        steps = 1j * STEP * np.moveaxis(_turning(seen), 0, -1)
        found = self._apart(seen[..., None] + steps, part).imag / STEP
        by_three = found.reshape(len(found), 3, -1)
        return np.asarray((FREE @ by_three).reshape(len(found), 16, -1))

    def _of_kinds(self) -> csr_array:
        """Derivatives of the conditions of single vertices by directions."""
        kind, i, j = np.nonzero(self.kinds)
        size = 4 * self.kinds[0].size
        numbers = np.arange(size).reshape(4, *self.kinds.shape[1:])[:, i, j].T
        return _by_directions(KINDS[kind], numbers, size)

    def _numbers(self) -> Integers:
        """Numbers (P, 16) of the directions round panels: by ways, then by corners."""
        shape = self.kinds.shape[1:]
        return (
            np.arange(4 * shape[0] * shape[1])
            .reshape(4, *shape)[:, *self.corners]
            .reshape(16, -1)
            .T
        )


def _beside(signs: Array, lines: Integers, first: Integers, second: Integers) -> Array:
    """Signs (2, 3, P) of creases of lines (2, P) before, between and beyond two vertices (P,)."""
    return np.stack([signs[lines, each] for each in (first, first + 1, second + 1)], axis=1)


def _turning(seen: Array) -> Array:
    """How ways (4, 2, 2, 2, P) change as one of them turns (12, ...): the first three ways."""
    turned = np.zeros((3, 2, 2, *seen.shape))
    for way, i, j in np.ndindex(3, 2, 2):
        x, y = seen[way, :, i, j]
        turned[way, i, j, way, :, i, j] = -y, x
    return turned.reshape(12, *seen.shape)


def _by_directions(values: Array, numbers: Integers, size: int) -> csr_array:
    """Rows (N, size) with values (N, k) in columns with numbers (N, k)."""
    from scipy.sparse import csr_array

    start = np.arange(0, numbers.size + 1, numbers.shape[1])
    return csr_array((values.ravel(), numbers.ravel(), start), shape=(len(numbers), size))


def _differences(shape: tuple[int, ...]) -> csr_array:
    """From coordinates (V,) of a grid of vertices to those of ways from its inner ones."""
    from scipy.sparse import csr_array, eye_array

    number = np.arange(shape[0] * shape[1]).reshape(shape)
    there = np.stack([number[1:-1, 2:], number[:-2, 1:-1], number[1:-1, :-2], number[2:, 1:-1]])
    here = np.broadcast_to(number[1:-1, 1:-1], there.shape)
    each = eye_array(number.size, format="csr")
    return csr_array(each[there.ravel()] - each[here.ravel()])


def _turns(flat: Array) -> csr_array:
    """Derivatives of directions by coordinates."""
    from scipy.sparse import csr_array, diags_array, hstack

    along = _differences(flat.shape[1:])
    x, y = along @ flat[0].ravel(), along @ flat[1].ravel()
    square = x * x + y * y
    return csr_array(hstack([diags_array(-y / square) @ along, diags_array(x / square) @ along]))


def _turns_of_turns(flat: Array, pull: Array) -> csr_array:
    """Second derivatives by coordinates of the sum of directions times numbers."""
    from scipy.sparse import block_array, csr_array, diags_array

    along = _differences(flat.shape[1:])
    x, y = along @ flat[0].ravel(), along @ flat[1].ravel()
    weight = pull / (x * x + y * y) ** 2
    both = along.T @ diags_array(2 * x * y * weight) @ along
    mixed = along.T @ diags_array((y * y - x * x) * weight) @ along
    return csr_array(block_array([[both, mixed], [mixed, -both]]))

"""A flat-foldable sheet locked by flaps on any border, slit from row to row.

Two flaps stand at every border vertex where a row crease of the sheet ends, hinged to the border
above and below it and to each other. A slit parts them from those of the next row: so every such
vertex folds by itself (:mod:`~.locks.vertices`).
"""

from __future__ import annotations

from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from orishell.conventions.record import record
from orishell.families.flat_foldable.locks.locked import Locked, sine_rates
from orishell.families.flat_foldable.locks.vertices import FlapVertices
from orishell.families.flat_foldable.mechanism import FlatFoldable
from orishell.families.shared.chains import Chains
from orishell.families.shared.folding import HalfFolds, fold
from orishell.motion.grid import CreaseValues, Grid
from orishell.motion.layout import Layout
from orishell.motion.mechanism import mechanism_in_one_line
from orishell.numerics.arrays import Array, Integers

OWN = 5
"""Vertices of two flaps: where their hinges end, their outer corners, and the end of the crease
between them."""


@record
class SlitFlaps(Locked):
    """A flat-foldable sheet with flaps along its left border, its right border or both.

    Its grid and its positions are those of the sheet. :attr:`layout` and :meth:`points` have the
    flaps as well.
    """

    bare: FlatFoldable
    widths: tuple[float, float]  # largest widths of the left and the right flaps; 0 for none
    stop: float = 0.0  # by how much flaps stop short of folding flat at the target (radians)

    __repr__ = mechanism_in_one_line

    def __post_init__(self) -> None:
        assert self._sides

    @property
    def grid(self) -> Grid:
        """The grid of vertices, without flaps."""
        return self.bare.grid

    @property
    def inner_columns(self) -> slice:
        """All columns."""
        return self.bare.inner_columns

    @property
    def flap_columns(self) -> tuple[int, ...]:
        """None: flaps are beside the grid."""
        return ()

    @property
    def widest(self) -> float:
        """The width of the widest flap, square to its hinge."""
        return max(float(vertices.widths.max()) for _, vertices in self._sides)

    @cached_property
    def _sides(self) -> list[tuple[bool, FlapVertices]]:
        """Whether flaps are on the left, and their vertices."""
        row, _ = self._tangents
        return [
            (left, FlapVertices.of(self.bare.flat[..., 0], row[:, column, 0], width, left=left))
            for left, column, width in zip((True, False), (0, -1), self.widths, strict=True)
            if width
        ]

    @cached_property
    def layout(self) -> Layout:
        """Panels of the grid, then two flaps to each row, upper ones first, left ones first.

        Flaps are called by rows from 0, two to each row of vertices, in columns beside the sheet.
        """
        own = Layout.of_grid(self.grid)
        rows, columns = self.grid.rows, self.grid.columns
        # Flaps reach over two more columns of vertices: one for either of two flaps.
        shift = np.array([0, 2 if self.widths[0] else 0])
        faces, first, last, names = (
            [own.faces], [own.first + shift], [own.last + shift], [own.names]
        )  # fmt: skip
        loops = np.pad(own.faces, ((0, 0), (0, 2)), constant_values=-1)
        hinges = []
        here, start = np.arange(1, rows - 1), self.grid.vertex_count
        for left, _ in self._sides:
            column = 0 if left else columns - 1
            vertex = self.grid.vertices()[1:-1, column]
            new = start + OWN * np.arange(rows - 2)[:, None] + np.arange(OWN)
            start += new.size
            begin = 0 if left else column + shift[1]
            border = np.arange(rows - 1) * (columns - 1) + (0 if left else columns - 2)
            loops[border] = _with_hinges(own.faces[border], new, left=left)
            hinges.append(border[np.stack([here - 1, here])])
            for half in (0, 1):
                hinge, corner, tip = new[:, half], new[:, 2 + half], new[:, 4]
                panel = np.stack([vertex, hinge, corner, tip], axis=-1)
                # Upper flaps on the left, and lower ones on the right, go counter-clockwise so.
                # As in the grid, the first side and the third are beside columns.
                faces.append(panel if left is (half == 0) else panel[:, [1, 0, 3, 2]])
                above = here - 1 + half
                first.append(np.stack([above, np.full_like(here, begin)], axis=-1))
                last.append(first[-1] + [1, 2])
                name = -1 if left else columns - 1
                names.append(np.stack([2 * here - 2 + half, np.full_like(here, name)], axis=-1))
        count, rows = len(own.faces), rows - 2
        number = np.arange(sum(map(len, faces)))
        upper = [count + 2 * rows * side + np.arange(rows) for side in range(len(self._sides))]
        pairs = np.concatenate([np.stack([each, each + rows], axis=-1) for each in upper])
        everything = np.concatenate(faces)
        flaps = np.pad(everything[count:], ((0, 0), (0, 2)), constant_values=-1)
        return Layout(
            grid=self.grid,
            faces=everything,
            loops=np.concatenate([loops, flaps]),
            first=np.concatenate(first),
            last=np.concatenate(last),
            names=np.concatenate(names),
            flaps=number >= count,
            pairs=pairs,
            hinges=np.stack([number[count:], np.concatenate(hinges).ravel()], axis=-1),
        )

    def positions(self, drive: ArrayLike) -> Array:
        """Positions (..., rows, columns, 3) of the sheet's vertices at drive angles (...)."""
        drives = np.asarray(drive, dtype=np.float64)
        rho = drives.ravel()
        folds = HalfFolds.of(self._tangents, 1.0, np.sin(0.5 * rho))
        places = fold(self.bare.flat, folds, self.bare.sheet.net.middle)
        return self.bare.placed(places, rho / self.target_drive, drives.shape)

    def points(self, drive: ArrayLike) -> Array:
        """Positions (..., V, 3) of all vertices, those of flaps last, row by row."""
        drives = np.asarray(drive, dtype=np.float64)
        sheet = self.positions(drives.ravel())
        found = [sheet.reshape(len(sheet), -1, 3)]
        for left, vertices in self._sides:
            new = _flaps(sheet, vertices, 0.5 * drives.ravel(), left=left)
            found.append(new.reshape(len(sheet), -1, 3))
        return np.concatenate(found, axis=1).reshape(*drives.shape, -1, 3)

    def fold_angles(self, drive: ArrayLike) -> CreaseValues:
        """Fold angles of the sheet's creases at drive angles (...), in closed form (radians)."""
        sine = np.sin(0.5 * np.asarray(drive, dtype=np.float64))[..., None, None]
        row, column = (2 * np.arctan(each[..., 0] * sine) for each in self._tangents)
        return CreaseValues(row=row, column=column)

    def flap_folds(self, drive: ArrayLike) -> Array:
        """Fold angles (..., K) of the row creases of flaps, row by row, left ones first."""
        phi = 0.5 * np.asarray(drive, dtype=np.float64)
        return np.concatenate([each.crease_folds(phi) for _, each in self._sides], axis=-1)

    def hinge_folds(self, drive: ArrayLike) -> Array:
        """Fold angles (..., H) of the hinges of flaps, in the order of these."""
        phi = 0.5 * np.asarray(drive, dtype=np.float64)
        folds = []
        for _, vertices in self._sides:
            cosine, sine = vertices.hinge_folds(phi.ravel())
            folds.append(np.arctan2(sine, cosine).reshape(-1, phi.size))
        return np.concatenate(folds).T.reshape(*phi.shape, -1)

    def edge_accelerations(self, start: Array, stop: Array) -> tuple[Array, Array]:
        """Bounds of the accelerations of edges: see :class:`~.chains.Chains`.

        Two more columns of flaps have the bound of any vector from a border vertex to its flaps,
        which turn with the border's panel and about their hinge.
        """
        row, column = (np.abs(each[..., 0]) for each in self._tangents)
        turns = self._chains.turns(
            sine_rates(row[:, 0], start, stop), sine_rates(column[0], start, stop)
        )
        along, down = self._chains.of_edges(turns, self._spin)
        for left, vertices in self._sides:
            w, bent = (each[:, 0 if left else -1] for each in turns)
            # Panels above and below every border vertex.
            w, bent = (np.stack([each[:-1], each[1:]]) for each in (w, bent))
            hinge = vertices.rates(start, stop)
            high, second = (each.reshape(w.shape) for each in (hinge.high, hinge.second))
            size = (w + high + self._spin) ** 2 + bent + second + w * high
            bound = (vertices.radii[:, None] * size).max(axis=(0, 1))[:, None]
            along = np.hstack([bound, bound, along] if left else [along, bound, bound])
        return along, down

    @cached_property
    def _chains(self) -> Chains:
        row, column = (each[..., 0] for each in self._tangents)
        return Chains.of(self.bare.flat[..., 0], row, column, self.bare.sheet.net.middle)


def _with_hinges(faces: Integers, new: Integers, *, left: bool) -> Integers:
    """Vertices (R+1, 6) around panels (R+1, 4) of a border, ends of hinges on it included.

    new: Vertices (R, 5) of flaps.
    """
    # From the vertex above a panel down to that below it: its lower flap, then the upper one.
    ends = np.full((len(faces), 2), -1)
    ends[1:, 0], ends[:-1, 1] = new[:, 1], new[:, 0]
    if left:
        loops = np.concatenate([faces[:, :1], ends, faces[:, 1:]], axis=1)
    else:
        loops = np.concatenate([faces[:, :3], ends[:, ::-1], faces[:, 3:]], axis=1)
    # The first and the last panel have one hinge each.
    order = np.argsort(loops < 0, axis=1, kind="stable")
    return np.take_along_axis(loops, order, axis=1)


def _flaps(sheet: Array, vertices: FlapVertices, phi: Array, *, left: bool) -> Array:
    """Vertices (B, R, 5, 3) of flaps beside a sheet (B, rows, columns, 3)."""
    column, beside = (0, 1) if left else (-1, -2)
    border, here = sheet[:, :, column], sheet[:, 1:-1, column]
    inward = sheet[:, 1:-1, beside] - here
    cosines, sines = (np.moveaxis(each, -1, 0) for each in vertices.hinge_folds(phi))
    hinges, corners, tips = [], [], []  # that of the upper flap is taken: both have it
    for half, edge in enumerate((border[:, :-2] - here, border[:, 2:] - here)):
        along = _unit(edge)
        outward = -_unit(inward - (inward * along).sum(axis=-1, keepdims=True) * along)
        # The normal points up in the flat sheet.
        normal = np.cross(along, outward) * (1 if left is (half == 0) else -1)
        leaving = cosines[:, half, :, None] * outward + sines[:, half, :, None] * normal
        end = here + vertices.hinges[half, :, None] * along
        hinges.append(end)
        corners.append(end + vertices.widths[half, :, None] * leaving)
        angle = vertices.outer[half, :, None]
        tips.append(
            here + vertices.crease[:, None] * (np.cos(angle) * along + np.sin(angle) * leaving)
        )
    return np.stack([*hinges, *corners, tips[0]], axis=2)


def _unit(vectors: Array) -> Array:
    return np.asarray(vectors / np.linalg.norm(vectors, axis=-1, keepdims=True))

"""What holds a shell: which of its vertices, and how."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.record import record
from orishell.motion.grid import Grid
from orishell.numerics.arrays import Array, Integers
from orishell.structure.mesh.sheet import SheetMesh
from orishell.structure.settings import Support, SupportKind

HELD: dict[SupportKind, range] = {
    "pinned": range(3),
    "fixed": range(6),
    "sliding": range(2, 3),
    "friction": range(0),
}
"""Displacements 0 to 2 and rotations 3 to 5 that a support takes, whatever loads do."""


@record
class Supports:
    """What holds a shell."""

    held: Integers  # vertices (H, 2) that are held, and in which of 6 directions
    ground: Integers  # vertices (G,) that stand on the ground
    friction: Array  # its coefficient of friction (G,)

    def vertices(self) -> Integers:
        """All supported vertices (S,), ascending."""
        return np.unique(np.concatenate([self.held[:, 0], self.ground]))

    def as_if_pinned(self) -> Integers:
        """Vertices (H, 2) and directions that are held, those on the ground in all three."""
        ground = np.stack([np.repeat(self.ground, 3), np.tile(range(3), len(self.ground))], axis=1)
        return np.unique(np.concatenate([self.held, ground]), axis=0)

    def dofs(self, mesh: SheetMesh) -> Integers:
        """Dofs (H,) of a mesh that are held: a rotation is held of all panels at a vertex."""
        node, axis = self.held.T
        straight = axis < 3
        moved = mesh.translations()[node[straight], axis[straight]]
        turned = [
            mesh.rotations()[mesh.nodes == each][:, which - 3]
            for each, which in self.held[~straight].tolist()
        ]
        return np.unique(np.concatenate([moved, *turned]))


def find_supports(
    asked: Sequence[Support],
    grid: Grid,
    inner: slice,
    feet: tuple[int, int] | None,
    before: int,
) -> Supports:
    """What holds a shell.

    asked: What is to hold it.
    grid: The grid of the sheet between its flaps.
    inner: Its columns that meet the target.
    feet: Rows that are its feet; None if it does not stand.
    before: Number of columns of folded flaps before the first column of the grid.
    Raises InputError: If vertices that are to be held are not there.
    """
    held: list[Integers] = [np.zeros((0, 2), np.int64)]
    ground: list[Integers] = [np.zeros(0, np.int64)]
    friction: list[Array] = [np.zeros(0)]
    for number, support in enumerate(asked):
        where = f"[structure] supports[{number}] at"
        if support.at == "feet":
            vertices = _feet(grid, inner, feet, where)
        elif support.at == "ends":
            vertices = grid.vertices()[:, [inner.start, inner.stop - 1]].ravel()
        else:
            vertices = np.array(
                [_vertex(grid, before, row, column, where) for row, column in support.at]
            )
        if support.kind == "friction":
            ground.append(vertices)
            friction.append(np.full(len(vertices), support.friction))
        axes = np.array(HELD[support.kind], np.int64)
        held.append(np.stack(np.meshgrid(vertices, axes, indexing="ij"), axis=-1).reshape(-1, 2))
    standing, first = np.unique(np.concatenate(ground), return_index=True)
    return Supports(
        np.unique(np.concatenate(held), axis=0), standing, np.concatenate(friction)[first]
    )


def _feet(grid: Grid, inner: slice, feet: tuple[int, int] | None, where: str) -> Integers:
    if feet is None:
        raise InputError(
            "there are no feet to support",
            where=where,
            got='"feet"',
            expected="a shell that stands on the two ends of f",
            remedy='at = "ends", or name vertices, [[row, column], ...]',
        )
    return grid.vertices()[list(feet), inner].ravel()


def _vertex(grid: Grid, before: int, row: int, column: int, where: str) -> int:
    last = before + grid.columns - 1
    if not (row < grid.rows and before <= column <= last):
        raise InputError(
            "there is no such vertex to support",
            where=where,
            got=f"[{row}, {column}]",
            expected=f"a row from 0 to {grid.rows - 1}, a column from {before} to {last}",
        )
    return int(grid.vertices()[row, column - before])

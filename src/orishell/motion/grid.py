"""The quadrilateral grid: numbering, adjacency and crease assignments.

Vertices are numbered row by row, row 0 at the top and column 0 at the left of the flat sheet
seen from +z. Edges are numbered rows first (each from left to right), then columns (each from
top to bottom, row of panels by row of panels).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Integers

UNFOLDED = 1e-9
"""A crease whose fold angle at lock is below this counts as unfolded (radians)."""

BORDER, MOUNTAIN, FLAT, VALLEY = "B", "M", "F", "V"

Positions = Array
"""Vertices (..., rows, columns, 3) of a sheet in one or many states."""
Vertex = tuple[int, int]
"""Row and column of a vertex."""
VertexPair = tuple[Vertex, Vertex]
Panel = tuple[int, int]
"""Row and column of a panel."""


@dataclass(frozen=True, slots=True)
class Grid:
    """A grid of rows x columns vertices."""

    # numbers of vertices, border included, at least 2 each
    rows: int
    columns: int

    @property
    def vertex_count(self) -> int:
        """Number of vertices."""
        return self.rows * self.columns

    @property
    def panel_count(self) -> int:
        """Number of panels."""
        return (self.rows - 1) * (self.columns - 1)

    def vertices(self) -> Integers:
        """Vertex numbers (rows, columns)."""
        return np.arange(self.vertex_count).reshape(self.rows, self.columns)

    def edges_vertices(self) -> Integers:
        """Vertices (E, 2) of every edge."""
        v = self.vertices()
        row = np.stack([v[:, :-1], v[:, 1:]], axis=-1).reshape(-1, 2)
        column = np.stack([v[:-1], v[1:]], axis=-1).reshape(-1, 2)
        return np.concatenate([row, column])

    def faces_vertices(self) -> Integers:
        """Vertices (F, 4) of every panel, counter-clockwise seen from +z, top left one first."""
        v = self.vertices()
        return np.stack([v[:-1, :-1], v[1:, :-1], v[1:, 1:], v[:-1, 1:]], axis=-1).reshape(-1, 4)

    def faces_edges(self) -> Integers:
        """Edges (F, 4) of every panel: left, bottom, right, top."""
        row = np.arange(self.rows * (self.columns - 1)).reshape(self.rows, self.columns - 1)
        column = row.size + np.arange((self.rows - 1) * self.columns).reshape(
            self.rows - 1, self.columns
        )
        return np.stack([column[:, :-1], row[1:], column[:, 1:], row[:-1]], axis=-1).reshape(-1, 4)


@record
class CreaseValues:
    """One number for every inner edge of a grid (fold angles, signs), possibly for many states."""

    row: Array  # for the row creases (..., rows-2, columns-1): creases of inner rows, left to right
    # for the column creases (..., rows-1, columns-2): creases of inner columns, top to bottom
    column: Array

    def on_edges(self, border: float = 0.0) -> Array:
        """Values (..., E) of all edges, border included, in :meth:`Grid.edges_vertices`' order."""
        leading = self.row.shape[:-2]
        rows, columns = self.column.shape[-2] + 1, self.row.shape[-1] + 1
        row = np.full((*leading, rows, columns - 1), border)
        column = np.full((*leading, rows - 1, columns), border)
        row[..., 1:-1, :] = self.row
        column[..., 1:-1] = self.column
        return np.concatenate([row.reshape(*leading, -1), column.reshape(*leading, -1)], axis=-1)


def crease_signs(fold_angles: CreaseValues) -> CreaseValues:
    """Signs of fold angles: +1 valley, -1 mountain, 0 unfolded (below :data:`UNFOLDED`)."""

    def sign(angle: Array) -> Array:
        return np.where(np.abs(angle) > UNFOLDED, np.sign(angle), 0.0)

    return CreaseValues(sign(fold_angles.row), sign(fold_angles.column))


def edges_assignment(signs: CreaseValues) -> list[str]:
    """Assignment letters B, M, V, F of all edges, from the signs of the creases."""
    letters = np.array([MOUNTAIN, FLAT, VALLEY, BORDER])
    index = signs.on_edges(border=2.0).astype(np.int64) + 1
    assignment: list[str] = letters[index].tolist()
    return assignment

"""Panels of a sheet as the proof of contact sees them: those of its grid, and flaps beside it.

Flaps that are slit from each other are no columns of the grid. Their panels follow those of the
grid, their vertices too, and they have places beside it, over which accelerations are summed up.
"""

from __future__ import annotations

from functools import cached_property, lru_cache
from typing import Protocol, runtime_checkable

import numpy as np
from numpy.typing import ArrayLike

from orishell.conventions.record import record
from orishell.motion.grid import UNFOLDED, Grid
from orishell.motion.mechanism import Mechanism
from orishell.motion.mesh import QuadMesh, build_mesh
from orishell.numerics.arrays import Array, Booleans, Integers

KEPT = 4
"""Layouts and points that are kept: several ask for those of the last sheets."""


@record
class Layout:
    """All panels of a sheet (F,)."""

    grid: Grid
    faces: Integers  # (F, 4), vertices, counter-clockwise seen from +z in the flat sheet
    # (F, K), the same with the vertices that lie on sides of panels, -1 behind the last
    loops: Integers
    # Rows and columns (F, 2) of vertices from which and up to which a panel reaches. A vector
    # between vertices of two panels is a sum of edges over all rows and columns from the first to
    # the last of both.
    first: Integers
    last: Integers
    # (F, 2), row and column that a panel is called by: -1 is the column left of the sheet
    names: Integers
    flaps: Booleans  # (F,), which are flaps
    # numbers (K, 2) of panels about the row creases of flaps that are no columns of the grid, the
    # upper ones first
    pairs: Integers
    # numbers (H, 2) of such flaps, in ascending order, and of the panels that they are hinged to
    hinges: Integers
    # the panel (F,) that each stays parallel to in all states; None: no others are
    parallel: Integers | None = None

    @classmethod
    def of(cls, mechanism: Mechanism) -> Layout:
        """That of a mechanism: its own, or that of its grid."""
        if isinstance(mechanism, LaidOut):
            return mechanism.layout
        return cls.of_grid(mechanism.grid, mechanism.flap_columns)

    @classmethod
    @lru_cache(KEPT)
    def of_grid(cls, grid: Grid, flap_columns: tuple[int, ...] = ()) -> Layout:
        """That of a grid whose columns of panels with these numbers are flaps."""
        names = np.indices((grid.rows - 1, grid.columns - 1)).reshape(2, -1).T
        flaps = np.isin(names[:, 1], flap_columns)
        none, faces = np.zeros((0, 2), np.int64), grid.faces_vertices()
        return cls(grid, faces, faces, names, names + 1, names, flaps, none, none)

    @property
    def beside(self) -> Booleans:
        """Which panels (F,) are beside the grid."""
        return np.arange(len(self.faces)) >= self.grid.panel_count

    @cached_property
    def edges(self) -> tuple[Integers, Booleans]:
        """Vertices (E, 2) of all edges, and which edges of the grid are among them.

        These come first, in the grid's order; then those about hinges, about pairs, and on borders.
        """
        whole = self.grid.edges_vertices()
        if not len(self.pairs):
            return whole, np.ones(len(whole), np.bool_)
        after = np.roll(np.where(self.loops < 0, self.loops[:, :1], self.loops), -1, axis=1)
        sides = np.stack([self.loops, after], axis=-1)[self.loops >= 0]
        count = int(self.loops.max()) + 1
        keys, listed = (np.sort(each, axis=1) @ [count, 1] for each in (sides, whole))
        kept = np.isin(listed, keys)
        folding = np.stack([self.between(*pair) for pair in (*self.hinges, *self.pairs)])
        known = np.concatenate([listed, np.sort(folding, axis=1) @ [count, 1]])
        rest = np.stack(np.divmod(np.setdiff1d(keys, known), count), axis=-1)
        return np.concatenate([whole[kept], folding, rest]), kept

    @cached_property
    def mesh(self) -> QuadMesh:
        """All its panels and edges."""
        return build_mesh(self.faces, int(self.faces.max()) + 1, self.edges[0], loops=self.loops)

    @cached_property
    def folding_sides(self) -> tuple[Integers, Integers]:
        """Sides of panels at the hinges (H, 2) and the row creases (K, 2) of flaps beside it.

        Side k goes from a panel's corner k to the next. A flap begins with its hinge.
        """
        on_border = np.where(self.names[self.hinges[:, 0], 1] < 0, 0, 2)
        from_vertex = self.faces[self.pairs, 0] < self.grid.vertex_count
        hinges = np.stack([np.zeros_like(on_border), on_border], axis=-1)
        return hinges, np.where(from_vertex, 3, 1)

    def between(self, one: int, other: int) -> Integers:
        """Vertices (2,) that two panels share."""
        mine = self.loops[one]
        return np.asarray(mine[(mine >= 0) & np.isin(mine, self.loops[other])])

    def name(self, row: int, column: int) -> int:
        """The number of the panel that is called so."""
        return int((self.names == (row, column)).all(axis=1).argmax())


@runtime_checkable
class LaidOut(Protocol):
    """A mechanism with panels beside its grid: its positions are those of its grid."""

    @property
    def layout(self) -> Layout:
        """All its panels."""

    def points(self, drive: ArrayLike) -> Array:
        """Positions (..., V, 3) of all vertices, those of the grid first."""


@runtime_checkable
class SlitFlaps(LaidOut, Protocol):
    """A mechanism whose flaps are slit from each other, and no columns of its grid.

    Its bounds of accelerations have further columns for them (see
    :meth:`~orishell.motion.Mechanism.edge_accelerations`).
    """

    def flap_folds(self, drive: ArrayLike) -> Array:
        """Fold angles (..., K) between the pairs of panels of its layout (radians)."""

    def hinge_folds(self, drive: ArrayLike) -> Array:
        """Fold angles (..., H) of the hinges of its layout (radians)."""


def points_of(mechanism: Mechanism, drive: ArrayLike) -> Array:
    """Positions (..., V, 3) of all vertices of a mechanism at drives (...).

    Those of the flat sheet and of the target, which many ask for, are shared and read-only.
    """
    if isinstance(drive, float) and drive in {0.0, mechanism.target_drive}:
        return _kept_points(mechanism, drive)
    return _points(mechanism, drive)


@lru_cache(KEPT)
def _kept_points(mechanism: Mechanism, drive: float) -> Array:
    points = _points(mechanism, drive)
    points.flags.writeable = False
    return points


def _points(mechanism: Mechanism, drive: ArrayLike) -> Array:
    if isinstance(mechanism, LaidOut):
        return mechanism.points(drive)
    positions = mechanism.positions(drive)
    return positions.reshape(*positions.shape[:-3], -1, 3)


def mesh_of(mechanism: Mechanism) -> QuadMesh:
    """All panels and edges of a mechanism."""
    return Layout.of(mechanism).mesh


def edge_folds(mechanism: Mechanism, drive: float) -> Array:
    """Fold angles (E,) of all edges of a mechanism in one state, 0 at borders (radians)."""
    folds = mechanism.fold_angles(drive).on_edges()
    if not isinstance(mechanism, SlitFlaps):
        return folds
    edges, kept = mechanism.layout.edges
    own = [folds[kept], mechanism.hinge_folds(drive), mechanism.flap_folds(drive)]
    found = np.zeros(len(edges))
    known = np.concatenate(own)
    found[: len(known)] = known
    return found


def edge_signs(mechanism: Mechanism) -> Integers:
    """Signs (E,) of all edges at the target: +1 valley, -1 mountain, 0 unfolded."""
    folds = edge_folds(mechanism, mechanism.target_drive)
    return np.where(np.abs(folds) > UNFOLDED, np.sign(folds), 0).astype(np.int64)


def has_flaps(mechanism: Mechanism) -> bool:
    """Whether flaps are part of a mechanism, as columns of its grid or beside it."""
    return bool(mechanism.flap_columns) or isinstance(mechanism, SlitFlaps)

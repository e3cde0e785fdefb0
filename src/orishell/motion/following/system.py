"""Closure of a folded sheet: round every inner vertex the panels come back to where they began.

Round a vertex the sheet turns by the fold angle of a crease about it, then by the sector to the
next crease about the normal, and so on: the product of all these rotations is the identity
(Belcastro and Hull, *Modelling the folding of paper into three dimensions using affine
transformations*, 2002). Its derivative by a fold angle is the unit vector along that crease, where
it lies in the folded state (Tachi, *Simulation of rigid origami*, 2009).
"""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.record import record
from orishell.motion.crease_pattern import CreasePattern
from orishell.motion.following.holes import Holes
from orishell.numerics.arrays import Array, Booleans, Integers

if TYPE_CHECKING:
    from scipy.sparse import csr_array


@record
class Closure:
    """The equations of a sheet: three for each inner vertex, in one unknown for each crease.

    For each hole H there are six more (:mod:`.holes`): J = I + 2 H lots of three in all. Creases
    that are flat (F) or joined (J) do not fold, and are no unknowns.
    """

    edges: Integers  # numbers (N,) of the edges that fold: the unknowns
    edge_count: int  # how many edges the pattern has
    vertices: Integers  # numbers (I,) of the inner vertices in the order of the equations
    # for every degree of vertices: unknowns (I', D) round each, -1 for what does not fold, and
    # sectors (I', D) from each crease to the next (radians)
    fans: tuple[tuple[Integers, Array], ...]
    rows: Integers  # where the equations' entries begin, as in scipy's CSR
    columns: Integers  # the unknown of every entry
    kept: Booleans  # which derivatives are entries
    holes: Holes  # ways round holes

    @classmethod
    def of(cls, pattern: CreasePattern) -> Closure:
        """That of a crease pattern."""
        edges = np.flatnonzero(pattern.crease & (pattern.signs != 0))
        unknown = np.full(len(pattern.edges) + 1, -1)
        unknown[edges] = np.arange(len(edges))
        creases, _ = pattern.fans
        degrees = (creases >= 0).sum(axis=1)
        fans, order = [], []
        for degree in np.unique(degrees).tolist():
            here = np.flatnonzero(degrees == degree)
            order.append(pattern.inner[here])
            fans.append((unknown[creases[here, :degree]], pattern.sectors[here, :degree]))
        holes = Holes.of(pattern, unknown)
        entries = [
            np.repeat(each, rows, axis=0)
            for each, rows in (*((each, 3) for each, _ in fans), (holes.unknowns, 6))
        ]
        counts = np.concatenate([[0], *((each >= 0).sum(axis=1) for each in entries)])
        columns = np.concatenate([np.zeros(0, np.int64), *(each.ravel() for each in entries)])
        kept = columns >= 0
        vertices = np.concatenate([np.zeros(0, np.int64), *order])
        rows = np.cumsum(counts)
        return cls(
            edges, len(pattern.edges), vertices, tuple(fans), rows, columns[kept], kept, holes
        )

    def on_edges(self, folds: Array) -> Array:
        """Fold angles (..., E) of all edges from those of the unknowns (..., N)."""
        found = np.zeros((*folds.shape[:-1], self.edge_count))
        found[..., self.edges] = folds
        return found

    def residuals(self, folds: Array) -> tuple[Array, Array]:
        """By how much every vertex and hole does not close (J, 3), and the derivatives of that.

        Vectors along the axis by which what is left turns, as long as its sine (radians); in the
        flat state x and y are linear in the fold angles, z is quadratic. After those of vertices
        come for each hole such a vector, and one by which its middle is off, in its sizes.

        Parameters
        ----------
        folds
            Fold angles (N,) of the unknowns, valley positive (radians).
        """
        left, along = self.turns(folds)
        round_holes, derivatives = self.holes.turns(*_sines(folds))
        entries = np.concatenate([each.ravel() for each in (*along, derivatives)])
        return np.concatenate([left, round_holes]), entries[self.kept]

    def turns(self, folds: Array) -> tuple[Array, list[Array]]:
        """By how much every vertex does not close (I, 3), and for every fan along what (I', 3, D).

        The latter are unit vectors along the creases around each vertex, in a frame of its own; see
        :meth:`residuals`.
        """
        left, found = [np.zeros((0, 3))], []
        sines, cosines = _sines(folds)
        for unknowns, sectors in self.fans:
            # Axes (I', 3) of the running frame: x along the crease, z the panel's normal.
            x, y, z = (np.broadcast_to(axis, (len(unknowns), 3)) for axis in np.eye(3))
            along = np.empty((len(unknowns), 3, unknowns.shape[1]))
            for k in range(unknowns.shape[1]):
                along[:, :, k] = x
                s, c = sines[unknowns[:, k], None], cosines[unknowns[:, k], None]
                y, z = c * y + s * z, c * z - s * y
                s, c = np.sin(sectors[:, k, None]), np.cos(sectors[:, k, None])
                x, y = c * x + s * y, c * y - s * x
            turn = np.stack([y[:, 2] - z[:, 1], z[:, 0] - x[:, 2], x[:, 1] - y[:, 0]], axis=-1)
            left.append(turn / 2)
            found.append(along)
        return np.concatenate(left), found

    def matrix(self, entries: Array) -> csr_array:
        """The derivatives as a matrix (3 J, N)."""
        from scipy.sparse import csr_array

        return csr_array(
            (entries, self.columns, self.rows), shape=(len(self.rows) - 1, len(self.edges))
        )

    @cached_property
    def quadratic(self) -> Booleans:
        """Which equations (3 J,) are quadratic in small fold angles: turns about z, places in x, y.

        The others are linear.
        """
        of_turns, of_places = [False, False, True], [True, True, False]
        of_holes = np.tile([of_turns, of_places], (len(self.holes), 1))
        of_vertices = np.tile(of_turns, (len(self.vertices), 1))
        return np.concatenate([of_vertices, of_holes]).ravel()


def _sines(folds: Array) -> tuple[Array, Array]:
    """Sines and cosines (N+1,) of fold angles (N,), at the end those of what does not fold."""
    return np.append(np.sin(folds), 0.0), np.append(np.cos(folds), 1.0)

"""The largest fold angles at the sides of panels, for which boards are set back.

A side of a border panel may carry the hinges of two flaps. Its board stands back along the whole
side, by what the hinge that folds more asks for on each face: so it stays a convex plate with a
corner for each of the panel's.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.motion import Mechanism
from orishell.motion.grid import CreaseValues
from orishell.motion.layout import Layout, SlitFlaps
from orishell.numerics.arrays import Array, Booleans

SHUT = 1e-9
"""A crease whose fold angle is this near to pi folds flat (radians)."""


@record
class FlapFolds:
    """Fold angles of the creases of flaps that are no columns of the grid (radians)."""

    hinges: Array  # (H,)
    pairs: Array  # (K,), between two flaps

    @classmethod
    def at(cls, mechanism: Mechanism, drive: float) -> FlapFolds | None:
        """Those at a drive (radians); None for a sheet without such flaps."""
        if not isinstance(mechanism, SlitFlaps):
            return None
        return cls(mechanism.hinge_folds(drive), mechanism.flap_folds(drive))


@record
class SideFolds:
    """Fold angles at the sides of panels (F, 4), from a corner to the next, without signs."""

    valley: Array  # (F, 4), of valleys, 0 elsewhere (radians)
    mountain: Array  # (F, 4), of mountains, 0 elsewhere (radians)
    crease: Booleans  # (F, 4), whether there is a crease

    @classmethod
    def of(cls, layout: Layout, folds: CreaseValues, beside: FlapFolds | None = None) -> SideFolds:
        """Those of a sheet, of the fold angles of its grid and of its flaps beside it.

        Parameters
        ----------
        layout
            All its panels.
        beside
            Fold angles of flaps that are no columns of the grid, if there are such flaps.
        """
        edges, more = layout.grid.faces_edges(), len(layout.faces) - layout.grid.panel_count
        angle = np.pad(folds.on_edges()[edges], ((0, more), (0, 0)))
        crease = np.pad(folds.on_edges(border=np.inf)[edges] < np.inf, ((0, more), (0, 0)))
        faces = np.maximum(angle, 0.0), np.maximum(-angle, 0.0)
        if beside is not None:
            hinges, pairs = layout.folding_sides
            for panels, sides, angles in (
                (layout.hinges, hinges, beside.hinges),
                (layout.pairs, pairs, beside.pairs),
            ):
                at = panels, sides
                crease[at] = True
                for sign, found in zip((1, -1), faces, strict=True):
                    np.maximum.at(found, at, np.maximum(sign * angles, 0.0)[:, None])
        return cls(*faces, crease)

    @classmethod
    def at(cls, mechanism: Mechanism, drive: float) -> SideFolds:
        """Those of a mechanism at a drive (radians)."""
        layout, folds = Layout.of(mechanism), mechanism.fold_angles(drive)
        return cls.of(layout, folds, FlapFolds.at(mechanism, drive))

    def or_larger(self, other: SideFolds) -> SideFolds:
        """The larger ones of these and those of the same sheet in an ``other`` state."""
        valley = np.maximum(self.valley, other.valley)
        return SideFolds(valley, np.maximum(self.mountain, other.mountain), self.crease)

    @property
    def largest(self) -> Array:
        """The larger of both (F, 4)."""
        return np.maximum(self.valley, self.mountain)

    def shut(self) -> Booleans:
        """Faces of panels (2, F), the upper one first, on which a crease folds flat."""
        both = np.stack([self.valley, self.mountain])
        return np.asarray((both >= np.pi - SHUT).any(axis=-1))

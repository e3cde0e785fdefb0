"""Convex parts of panels: two triangles of one with a reflex corner.

A panel that is convex lies in its sector at each of its corners, and on one side of each of its
edges' lines. One with a reflex corner r does neither at the two corners beside r. Parted along the
diagonal from r it does again: at a corner beside r the triangle that has this corner lies in the
panel's sector, and the other triangle does not have the corner. What is skipped because it has a
corner in common may be skipped part by part: docs/theory/locking-and-clash.md.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.errors import DesignError
from orishell.conventions.record import record
from orishell.motion.layout import Layout, points_of
from orishell.motion.mechanism import Mechanism
from orishell.motion.quads import dots, is_level, lengths, sector_angles
from orishell.numerics.arrays import Array, Booleans, Integers

LEAVES = 1e-12
"""A panel is convex if it leaves its sectors by no more than this share of the sheet's diagonal, a
thousandth of that at which panels touch."""
ROUND = 1e-9
"""Sectors about a vertex add up to 360 degrees at most, but for so much (radians)."""


@record
class ConvexParts:
    """Convex quadrilaterals, or triangles, that make up the panels of a sheet (N,)."""

    # corners (N, 4), in order around each; a triangle has its last corner twice. Those of panels
    # come first, a second half of a panel behind all of them
    faces: Integers
    panels: Integers  # the panel (N,) that each is a part of
    concave: Integers  # panels (K,) that have a reflex corner, ascending
    corners: Integers  # the number (K,) of that corner
    whole: Integers  # corners (F, 4) of the panels
    around: Integers  # corners (N, K) of parts, with vertices that lie on sides of whole panels

    @classmethod
    def of(cls, mechanism: Mechanism) -> ConvexParts:
        """Those of the panels of a sheet.

        Raises
        ------
        DesignError
            If sectors about a reflex corner add up to more than 360 degrees.
        """
        layout, flat = Layout.of(mechanism), points_of(mechanism, 0.0)
        faces, loops = layout.faces, layout.loops
        reflex = reflex_in(flat[faces], LEAVES * float(np.linalg.norm(np.ptp(flat, axis=0))))
        concave = np.flatnonzero(reflex.any(axis=1))
        corners = reflex[concave].argmax(axis=1)
        number = np.arange(len(faces))
        if not len(concave):
            return cls(
                faces, number, concave, corners, faces, np.where(loops < 0, faces[:, :1], loops)
            )
        _require_room(flat, faces, reflex)
        around = (corners[:, None] + [0, 1, 2, 3]) % 4
        turned = np.take_along_axis(faces[concave], around, axis=1)
        halves = faces.copy()
        halves[concave] = turned[:, [0, 1, 2, 2]]
        parts = np.concatenate([halves, turned[:, [0, 2, 3, 3]]])
        return cls(parts, np.concatenate([number, concave]), concave, corners, faces, parts)

    def compared(self, first: Integers, second: Integers) -> Booleans:
        """Which pairs of parts (P,) have neither a vertex nor a crease of their panels in common.

        All others are apart by what their fold angles say, or are parts of one panel.
        """
        chosen = ~_common(self.around, first, second).any(axis=(1, 2))
        if len(self.concave):
            one, other = self.panels[first], self.panels[second]
            crease = _common(self.whole, one, other).sum(axis=(1, 2)) > 1
            chosen &= ~crease & (one != other)
        return np.asarray(chosen)


def _common(faces: Integers, first: Integers, second: Integers) -> Booleans:
    return np.asarray(faces[first][:, :, None] == faces[second][:, None, :])


def reflex_in(corners: Array, least: float) -> Booleans:
    """Which corners (F, 4) of panels (F, 4, 3) of the flat sheet have a sector above 180 degrees.

    A corner counts that has its panel leave the sector of a corner beside it by more than ``least``
    (length). It is one at most, if panels do not cross themselves: the most reflex one.
    """
    after = np.roll(corners, -1, axis=-2) - corners
    before = np.roll(after, 1, axis=-2)
    turn = np.cross(before, after)
    way = turn.sum(axis=-2, keepdims=True)  # counter-clockwise as a whole, whichever side is seen
    shorter = np.minimum(lengths(before), lengths(after)) * lengths(way)
    leaves = -dots(turn, way) / np.where(shorter > 0, shorter, np.inf)
    most = np.arange(4) == leaves.argmax(axis=-1)[..., None]
    return np.asarray(most & (leaves > least))


def require_convex(mechanism: Mechanism, what: str = "panels with a thickness") -> None:
    """Refuse a sheet with a panel that has a reflex corner where a proof takes panels as convex.

    Parameters
    ----------
    what
        What asks for convex panels.

    Raises
    ------
    DesignError
        Naming the panel with the widest corner, and where that is.
    """
    parts = ConvexParts.of(mechanism)
    if not len(parts.concave):
        return
    layout = Layout.of(mechanism)
    found = points_of(mechanism, 0.0)[layout.faces[parts.concave]]
    rows = np.arange(len(found))
    widest = 2 * np.pi - sector_angles(found)[rows, parts.corners]
    # The first of those that are as wide but for rounding.
    worst = int(np.argmax(widest >= widest.max() - ROUND))
    panel = parts.concave[worst]
    vertex = int(layout.faces[panel, parts.corners[worst]])
    row, column = divmod(vertex, layout.grid.columns)
    raise DesignError(
        f"{what} need a sheet of convex panels: contact is proved of convex ones",
        place=f"panel {layout.names[panel].tolist()} is concave",
        size=f"its corner at vertex {row}, {column} has {np.rad2deg(widest[worst]):.4g} degrees"
        + ("" if len(found) == 1 else f"; {len(found)} panels are concave"),
    )


def _require_room(flat: Array, faces: Integers, reflex: Booleans) -> None:
    """Refuse panels that have more than 360 degrees about a reflex corner (F, 4).

    In a flat sheet they lie on each other there; elsewhere nothing is proved of such corners.
    """
    sums = np.zeros(len(flat))
    angles = sector_angles(flat[faces])
    np.add.at(sums, faces, np.where(reflex, 2 * np.pi - angles, angles))
    vertices = faces[reflex]
    over = sums[vertices] > 2 * np.pi + ROUND
    if over.any():
        vertex = int(vertices[over.argmax()])
        raise DesignError(
            "panels of the flat sheet lie on each other"
            if is_level(flat)
            else "a panel has a reflex corner where nothing can be proved of contact",
            place=f"about vertex {vertex}",
            size=f"corners of panels there add up to {np.rad2deg(sums[vertex]):.5g} degrees",
        )

"""The space that panels take up while a shell moves: their corners, as thick as boards.

Between two states at drives a and b a vector e between two of these corners stays near the straight
line between its values there, by

    (b - a)^2 / 8 * max abs(e''),

as in the proof of contact. A vector between vertices is a sum of edges: it accelerates by no more
than all edges of a row and of a column together.
"""

from __future__ import annotations

import numpy as np

from orishell.clash.acceleration_bounds import ROUNDED_UP, NormalBounds
from orishell.conventions.record import record
from orishell.motion import Mechanism
from orishell.motion.as_made import panels_laid_flat
from orishell.motion.boards import Boards
from orishell.motion.hinge_lines import IN_CREASES, HingeLines
from orishell.motion.layout import Layout, points_of
from orishell.motion.quads import unit_normals
from orishell.numerics.arrays import Array


@record
class Occupied:
    """What panels, or the boards on them, take up."""

    mechanism: Mechanism
    # heights (F,) over each panel between which its boards are (length); None without boards
    low: Array | None = None
    high: Array | None = None
    hinges: HingeLines = IN_CREASES  # about which boards turn
    beyond: float = 0.0  # how far boards, or arms on them, reach over the sides of panels (length)

    @classmethod
    def by(cls, mechanism: Mechanism, boards: Boards | None) -> Occupied:
        """By the boards of a sheet; by its panels, which have no thickness, where it has none."""
        if boards is None:
            return cls(mechanism)
        count = len(Layout.of(mechanism).faces)
        low, high = np.full(count, np.inf), np.full(count, -np.inf)
        heights = boards.outlines[..., 2].reshape(len(boards), -1)
        np.minimum.at(low, boards.panels, heights.min(axis=1))
        np.maximum.at(high, boards.panels, heights.max(axis=1))
        bare = low > high
        low, high = np.where(bare, 0.0, low), np.where(bare, 0.0, high)
        return cls(mechanism, low, high, boards.hinges, _beyond(mechanism, boards))

    @property
    def count(self) -> int:
        """How many corners there are."""
        layout = Layout.of(self.mechanism)
        return int(layout.faces.max()) + 1 if self.low is None else 8 * len(layout.faces)

    def at(self, drives: Array) -> Array:
        """Corners (S, N, 3) at drives (S,): no panel or board reaches out of their convex hull.

        But for ``beyond``, by which some may.
        """
        points = points_of(self.mechanism, drives)
        if self.low is None or self.high is None:
            return points
        corners = points[:, Layout.of(self.mechanism).faces]
        normals = unit_normals(corners)
        corners = corners + self.hinges.shifts(normals)[..., None, :]
        sides = [corners + (h[:, None] * normals)[:, :, None] for h in (self.low, self.high)]
        return np.stack(sides, axis=1).reshape(len(points), -1, 3)

    def accelerations(self, start: Array, stop: Array) -> Array:
        """Bounds (S,) for vectors from the middle of the feet to all corners, in ranges (S,)."""
        along, down = self.mechanism.edge_accelerations(start, stop)
        found = along.sum(axis=1) + down.sum(axis=1)
        if self.low is None or self.high is None:
            return np.asarray(ROUNDED_UP * found)
        layout = Layout.of(self.mechanism)
        normals = NormalBounds(layout, points_of(self.mechanism, 0.0)).within(along, down)
        over = np.maximum(np.abs(self.low), np.abs(self.high))
        swings = (over * normals).max(axis=1)
        return np.asarray(
            ROUNDED_UP * (found + swings + self.hinges.accelerations(normals, swings))
        )


def _beyond(mechanism: Mechanism, boards: Boards) -> float:
    """How far outlines of boards reach over the sides of their panels as they lie flat."""
    import shapely

    panels = np.asarray(shapely.polygons(panels_laid_flat(mechanism)))
    shapely.prepare(panels)
    corners = boards.outlines[..., :2].reshape(len(boards), -1, 2)
    apart = shapely.distance(panels[boards.panels][:, None], shapely.points(corners))
    return float(apart.max(initial=0.0))

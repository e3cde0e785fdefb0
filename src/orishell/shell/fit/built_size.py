"""How large a shell is that stands: outside, and the room within.

All that is built counts, as files of the target have it: panels or, where these have a thickness,
boards with their arms and knuckles; and what is clipped on. A membrane between boards does not, nor
do ties, nor walls that stand on the ground by themselves. Heights are above the lowest point of
all, on which it stands.

- *Outside* are the sizes of the box around it, along x, y and z.
- *Clear width* (along x) is that of the room through which one can look along y. The shell, up to
  head height, is projected along y; what is left free on the x axis about the middle of the box is
  the clear width: so wide, and as high as the head height, is a door that could be pushed through
  the whole shell. *Clear depth* (along y) is the same seen along x. It is 0 where the middle is
  not free, but for slits between boards.
- *Headroom* is the height of the lowest point above the line through the middle of the box that
  runs along x, or along y: the higher of both.

Panels and boards are polygons, so all of these are exact but for rounding.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.conventions.record import record
from orishell.design import Design
from orishell.document import SHELL, Document
from orishell.document.from_design import document_of_motion
from orishell.io.solids import mesh_of, solids_in, split_panels
from orishell.locking import Lock
from orishell.motion import FoldingMotion
from orishell.numerics.arrays import Array

STATES = 2
"""The flat sheet and the target: no others are looked at."""
SLIT = 0.02
"""What is less wide or high than this share of the box is a slit between boards, and no room."""


@record
class BuiltShell:
    """A shell that stands, as triangles."""

    triangles: Array  # their corners (T, 3, 3), z up, the lowest at 0; in the design's unit

    @classmethod
    def of(cls, design: Design, lock: Lock) -> BuiltShell:
        """The shell of a design whose motion ends as ``lock`` says."""
        borne = tuple(part for part in design.attached if part.borne_at is not None)
        triangles = standing_triangles(replace(design, attached=borne), lock)
        return cls(triangles - [0.0, 0.0, triangles[..., 2].min()])

    def outside(self) -> Array:
        """Sizes (3,) of its box along x, y and z."""
        return np.asarray(np.ptp(self.triangles.reshape(-1, 3), axis=0))

    def inside(self, head: float) -> Array:
        """Clear width and clear depth up to the height ``head``, and headroom (3,)."""
        width, depth = (self.clear(axis, head) for axis in (0, 1))
        return np.array([width, depth, max(self.headroom(axis) for axis in (0, 1))])

    def clear(self, axis: int, head: float) -> float:
        """What is free along x (0) or y (1) about the middle, up to the height ``head``."""
        first, last = _spans(self.triangles, axis, head)
        middle = self._middle(axis)
        before, after = last[last < middle], first[first > middle]
        if len(before) + len(after) < len(first) or not (len(before) and len(after)):
            return 0.0
        free = float(after.min() - before.max())
        return free if free > SLIT * self.outside()[axis] else 0.0

    def headroom(self, axis: int) -> float:
        """The lowest height above the middle line along x (0) or y (1); 0 if nothing is there."""
        across = 1 - axis
        ends = np.stack([self.triangles, np.roll(self.triangles, -1, axis=1)])
        away = ends[..., across] - self._middle(across)
        share, there = _crossing(away)
        heights = ends[0, ..., 2] + share * (ends[1, ..., 2] - ends[0, ..., 2])
        lowest = float(heights[there].min()) if there.any() else 0.0
        return lowest if lowest > SLIT * self.outside()[2] else 0.0

    def _middle(self, axis: int) -> float:
        """The middle of its box along an axis."""
        along = self.triangles[..., axis]
        return float(0.5 * (along.min() + along.max()))


def standing_triangles(design: Design, lock: Lock) -> Array:
    """All that is built of a design at its target, as triangles (T, 3, 3) in the design's frame.

    Its motion ends as ``lock`` says, with its boards.
    """
    built = lock.built
    return triangles_of(
        document_of_motion(
            FoldingMotion(design.mechanism, STATES),
            "unit",
            clipped=design.clipped,
            carried=design.carried,
            attached=design.attached,
            panel=design.panel,
            boards=None if built is None else built.boards,
            flaps=None if built is None else built.flaps,
        )
    )


def triangles_of(document: Document) -> Array:
    """Panels, or the surfaces of boards, of all parts of a document at its target (T, 3, 3).

    In the document's frame.
    """
    if document.boards is not None:
        mesh = mesh_of(solids_in(document, SHELL))
        return np.asarray(mesh.vertices[mesh.triangles])
    panels = [state.positions[part.mesh.faces] for part, state in document.parts_in(SHELL)]
    return split_panels(np.concatenate(panels))


def _spans(triangles: Array, axis: int, head: float) -> tuple[Array, Array]:
    """Where the parts of triangles (T, 3, 3) up to a height begin and end along an axis (N,)."""
    ends = np.stack([triangles, np.roll(triangles, -1, axis=1)])
    along, above = ends[..., axis], ends[..., 2] - head
    share, cut = _crossing(above)
    crossing = along[0] + share * (along[1] - along[0])
    places = np.concatenate([along[0], crossing], axis=1)
    there = np.concatenate([above[0] <= 0, cut], axis=1)
    first = np.where(there, places, np.inf).min(axis=1)
    last = np.where(there, places, -np.inf).max(axis=1)
    low = there.any(axis=1)
    return first[low], last[low]


def _crossing(values: Array) -> tuple[Array, Array]:
    """Where values at both ends of edges (2, ...) pass through 0 (shares), and whether they do."""
    start, stop = values
    share = np.divide(start, start - stop, out=np.zeros_like(start), where=start != stop)
    return share, np.asarray(np.minimum(start, stop) <= 0) & np.asarray(
        np.maximum(start, stop) >= 0
    )

"""Boards: convex plates fixed on panels, described in the flat sheet and carried along by them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from orishell.conventions.record import record
from orishell.motion.hinge_lines import IN_CREASES, HingeLines
from orishell.motion.quads import longer_diagonals, signed_areas, unit_normals
from orishell.numerics.arrays import Array, Booleans, Integers

COINCIDING = 1e-6
"""Corners of an outline that are nearer to each other than this share of the board are one."""

ARM, KNUCKLE, BARE = 2, 3, 4
"""Sides of what is no board: arms, which stand on one and carry a hinge, knuckles of hinges, and a
face of the membrane that has no boards."""
SIDES = {1: "top", -1: "bottom", 0: "panel", ARM: "arm", KNUCKLE: "knuckle", BARE: "membrane"}
"""What a board is called after its side."""
EDGES = ("left", "bottom", "right", "top")
"""Edges of a panel, as :meth:`~orishell.motion.grid.Grid.faces_edges` has them."""


@record
class Boards:
    """Convex plates, each fixed on one panel."""

    panels: Integers  # number (B,) of the panel that carries each, ascending
    # the face (B,) of the flat sheet that it lies on: 1 on top, -1 at the bottom, 0 for a panel
    # that is one solid on both sides of the hinge plane; ARM for arms, which carry hinges, KNUCKLE
    # for what holds the knuckle of a hinge, on one of its boards
    sides: Integers
    # Corners (B, H, K, 3) of every board's outlines at H heights, lowest first, counter-clockwise
    # seen from +z: x and y in the flat sheet, z the height over it (length). Corners with the same
    # number lie above each other, joined by an edge; neighbours may coincide. The board is what
    # lies between its outlines: their convex hull.
    outlines: Array
    # where the hinges are, if they are not in the creases: boards are shifted in folded states
    hinges: HingeLines = IN_CREASES
    # numbers (B,) in EDGES of the edges that arms and knuckles are at, -1 for boards; None without
    edges: Integers | None = None

    def __len__(self) -> int:
        return len(self.panels)

    def chosen(self, which: Booleans | Integers) -> Boards:
        """Those of the boards at which ``which`` (B,) is true, or those with these numbers."""
        edges = None if self.edges is None else self.edges[which]
        return Boards(
            self.panels[which], self.sides[which], self.outlines[which], self.hinges, edges
        )

    def in_order(self) -> Boards:
        """The same by ascending numbers of their panels."""
        return self.chosen(np.argsort(self.panels, kind="stable"))

    def carried(self, faces: Integers, flat: Array, positions: Array) -> Array:
        """Corners (B, H, K, 3) of all outlines in a folded state.

        The panels have the corners ``faces`` (F, 4); the vertices are ``flat`` (V, 2) in the flat
        sheet and ``positions`` (V, 3) in the state.
        """
        lying = np.concatenate([flat, np.zeros((len(flat), 1))], axis=1)
        start, axes = panel_axes(lying[faces], lying[faces])
        origin, moved = panel_axes(positions[faces], lying[faces])
        origin = origin + self.hinges.drawn(positions[faces], moved[..., 2])
        turn = (moved @ np.swapaxes(axes, 1, 2))[self.panels]
        away = self.outlines - start[self.panels, None, None]
        return np.asarray(np.einsum("bij,bhkj->bhki", turn, away) + origin[self.panels, None, None])

    @property
    def arms(self) -> Booleans:
        """Which (B,) are no boards: arms, and knuckles."""
        return np.asarray(self.sides >= ARM)

    def called(self, board: int) -> str:
        """What a board is called beside its panel: "top", "bottom", "arm left", or nothing."""
        side = int(self.sides[board])
        if self.edges is not None and side >= ARM:
            return f"{SIDES[side]} {EDGES[int(self.edges[board])]}"
        return SIDES[side] if side else ""

    def areas(self) -> Array:
        """Area (B,) of every board's largest outline."""
        return np.asarray(signed_areas(self.outlines[..., :2]).max(axis=1))

    def volumes(self) -> Array:
        """Volume (B,) of every board; between two outlines sections are quadratic in the height."""
        outlines, height = self.outlines[..., :2], np.diff(self.outlines[:, :, 0, 2], axis=1)
        ends, between = map(signed_areas, (outlines, 0.5 * (outlines[:, 1:] + outlines[:, :-1])))
        return np.asarray(((ends[:, 1:] + ends[:, :-1] + 4 * between) * height).sum(axis=1) / 6)

    def triangles(self) -> tuple[Integers, Booleans]:
        """Closed surfaces of all boards, seen counter-clockwise from outside.

        Corners (B, T, 3), as places among the H K corners of the board's own outlines, where those
        that coincide have one place; and which triangles (B, T) are there: the others have lost a
        side to corners that coincide.
        """
        heights, corners = self.outlines.shape[1:3]
        number = np.arange(heights * corners).reshape(heights, corners)
        fan = number[0, 0] + np.stack(
            [np.zeros(corners - 2, int), np.arange(1, corners - 1), np.arange(2, corners)], axis=-1
        )
        low, high = number[:-1].ravel(), number[1:].ravel()
        next_low, next_high = (
            np.roll(each, -1, axis=1).ravel() for each in (number[:-1], number[1:])
        )
        pattern = np.concatenate(
            [
                fan[:, ::-1],
                np.stack([low, next_low, next_high], axis=-1),
                np.stack([low, next_high, high], axis=-1),
                fan + (heights - 1) * corners,
            ]
        )
        found = self.places()[:, pattern]
        a, b, c = np.moveaxis(found, -1, 0)
        return found, (a != b) & (b != c) & (c != a)

    def places(self) -> Integers:
        """The first corner (B, H K) of its own outline that each corner coincides with."""
        count, heights, corners = self.outlines.shape[:3]
        size = np.ptp(self.outlines, axis=(1, 2)).max(axis=-1)
        away = np.abs(self.outlines[:, :, :, None] - self.outlines[:, :, None]).max(axis=-1)
        same = away <= COINCIDING * size[:, None, None, None]
        first = same.argmax(axis=-1) + corners * np.arange(heights)[:, None]
        return np.asarray(first.reshape(count, -1))

    def surfaces(self, corners: Array) -> Surfaces:
        """Closed surfaces of all boards in a state, as one mesh.

        Its ``corners`` (B, H, K, 3) are those of all outlines, as :meth:`carried` has them.
        """
        found, present = self.triangles()
        count, size = len(self), self.outlines.shape[1] * self.outlines.shape[2]
        own = (found + size * np.arange(count)[:, None, None])[present]
        used, triangles = np.unique(own, return_inverse=True)
        return Surfaces(
            vertices=corners.reshape(-1, 3)[used],
            triangles=triangles.reshape(-1, 3),
            boards=np.repeat(np.arange(count), present.sum(axis=1)),
        )


def join_boards(several: Sequence[Boards]) -> Boards:
    """The boards of several parts as one, hinges being those of the first.

    Parameters
    ----------
    several
        The boards of each, all with outlines at as many heights.
    """
    corners = max(each.outlines.shape[2] for each in several)
    outlines = [  # with corners that coincide with the last
        np.pad(each, ((0, 0), (0, 0), (0, corners - each.shape[2]), (0, 0)), mode="edge")
        for each in (boards.outlines for boards in several)
    ]
    edges = None
    if any(each.edges is not None for each in several):
        none = [np.full(len(each), -1) for each in several]
        kept = zip(several, none, strict=True)
        edges = np.concatenate([no if each.edges is None else each.edges for each, no in kept])
    return Boards(
        np.concatenate([each.panels for each in several]),
        np.concatenate([each.sides for each in several]),
        np.concatenate(outlines),
        several[0].hinges,
        edges,
    )


@record
class Surfaces:
    """Closed surfaces of boards as one mesh of triangles: no two boards share a vertex."""

    vertices: Array  # vertices (N, 3), those of a board one after the other
    triangles: Integers  # numbers (T, 3) of their corners, counter-clockwise seen from outside
    boards: Integers  # the board (T,) that each triangle belongs to, ascending


def panel_axes(corners: Array, flat: Array) -> tuple[Array, Array]:
    """Origin (F, 3) and axes (F, 3, 3), as columns, of a frame fixed in every panel.

    The x axis follows the panel's longer diagonal in the flat sheet, z is its normal.

    Parameters
    ----------
    corners
        Corners (F, 4, 3) of the panels.
    flat
        The same (F, 4, 3) in the flat sheet.
    """
    first = longer_diagonals(flat)
    panel = np.arange(len(corners))
    x = corners[panel, first + 2] - corners[panel, first]
    z = unit_normals(corners)
    x -= (x * z).sum(axis=-1, keepdims=True) * z
    x /= np.sqrt((x * x).sum(axis=-1, keepdims=True))
    return corners.mean(axis=1), np.stack([x, np.cross(z, x), z], axis=-1)

"""Convex bodies fixed on panels: their corners and the directions that may keep two of them apart.

Two convex polyhedra are apart if and only if they are apart along the normal of a face of one of
them or square to an edge of each. Bodies are rigid: in another state the same direction is the one
of the same faces and edges.

Bodies whose panels have a vertex in common are near each other all the way.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from orishell.clash.broad_phase import Pairs, selected
from orishell.clash.separation import common_gap, cross, views_along
from orishell.conventions.record import record
from orishell.motion.boards import Boards, panel_axes
from orishell.motion.layout import Layout
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.numerics.equals import first_smallest

ALIKE = 1e-3
"""Gaps that differ by this share of the tolerance, which is a few roundings, are equal."""

CHUNK = 1 << 8
"""Pairs looked at along all directions in one go, so that they stay near the processor."""
ROW_EDGE, COLUMN_EDGE = np.array([3, 2, 1, 0]), np.array([1, 0, 3, 2])
"""The corner of a panel at the other end of its edge along a row, and down a column."""


@record
class BodyState:
    """All bodies in one state, coordinates first and bodies last.

    Normals of faces and vectors along edges are zero where a body has lost the face or edge.
    """

    corners: Array  # (3, C, B)
    normals: Array  # (A, 3, B), unit vectors
    edges: Array  # (E, 3, B), unit vectors


class Bodies:
    """Boards as bodies on panels (F, 4), whose corners (F, 4, 2) are known as they lie flat."""

    def __init__(self, boards: Boards, faces: Integers, lying: Array) -> None:
        self.faces, self.panels = faces, boards.panels
        self.lying: Array = np.pad(lying, ((0, 0), (0, 0), (0, 1)))
        self.start, self.axes = panel_axes(self.lying, self.lying)
        self.height = float(np.abs(boards.outlines[..., 2]).max(initial=0.0))
        self.hinges, outlines = boards.hinges, boards.outlines
        if not np.ptp(outlines[..., :2], axis=1).any():
            outlines = outlines[:, [0, -1]]  # all are upright
        self.low, self.high = outlines[:, 0, 0, 2], outlines[:, -1, 0, 2]
        self.sides, self.edges_of = boards.sides, boards.edges
        self.corners = outlines.reshape(len(boards), -1, 3)
        self.normals, self.edges = _directions(outlines)
        order = np.arange(len(boards)) - np.searchsorted(boards.panels, boards.panels)
        # the first body of every panel, where each has one
        self.first = np.searchsorted(boards.panels, np.arange(len(faces)))
        self.of_panel = np.full((len(faces), int(order.max(initial=0)) + 1), -1)
        self.of_panel[boards.panels, order] = np.arange(len(boards))

    def carried(self, points: Array) -> BodyState:
        """The bodies in a state (V, 3)."""
        origin, moved = panel_axes(points[self.faces], self.lying)
        origin = origin + self.hinges.shifts(moved[..., 2])
        turn = (moved @ np.swapaxes(self.axes, 1, 2))[self.panels]
        back = np.swapaxes(turn, 1, 2)
        away = self.corners - self.start[self.panels, None]
        corners = away @ back + origin[self.panels, None]
        return BodyState(
            np.ascontiguousarray(np.moveaxis(corners, 0, -1).swapaxes(0, 1)),
            np.ascontiguousarray(np.moveaxis(self.normals @ back, 0, -1)),
            np.ascontiguousarray(np.moveaxis(self.edges @ back, 0, -1)),
        )

    def carriers(self, pair: tuple[int, int]) -> tuple[int, int]:
        """The panels of two bodies."""
        first, second = self.panels[list(pair)].tolist()
        return first, second

    def pairs_of(self, panels: Pairs) -> tuple[Pairs, Integers]:
        """The pairs of bodies (Q,) on pairs of panels (P,), and the number of each one's pair."""
        first, second = (self.of_panel[each] for each in panels)
        count = self.of_panel.shape[1]
        a, b = np.repeat(first, count, axis=1).ravel(), np.tile(second, (1, count)).ravel()
        there = (a >= 0) & (b >= 0)
        return (a[there], b[there]), np.flatnonzero(there) // count**2

    def components(self, numbers: Integers, vertices: Integers, base: Array | float = 0.0) -> Array:
        """Shares (3, C, P) of corners of bodies (P,) along a row, down a column and over the panel.

        Absolute values, seen from a vertex (P,) of each body's panel: the first two in edges of the
        panel from there, the third as a length from a height (P,) over the panel, the ``base``.
        """
        panel = self.panels[numbers]
        corner = (self.faces[panel] == vertices[:, None]).argmax(axis=1)
        lying = self.lying[panel][..., :2]
        rows = np.arange(len(panel))
        origin = lying[rows, corner]
        u, w = (lying[rows, other[corner]] - origin for other in (ROW_EDGE, COLUMN_EDGE))
        away = self.corners[numbers][..., :2] - origin[:, None]
        area = _turned(u, w)[:, None]
        along, down = _turned(away, w[:, None]) / area, _turned(u[:, None], away) / area
        over = self.corners[numbers][..., 2] - np.reshape(base, (-1, 1))
        return np.asarray(np.abs(np.stack([along, down, over])).swapaxes(1, 2))


def directions(state: BodyState, pairs: Pairs, *, of_faces: bool = False) -> Array:
    """Unit vectors (3, X, P) that may keep pairs of bodies (P,) apart, zero where there are none.

    First the normals of faces of both, then what is square to an edge of each, if not left out.
    """
    normals = np.concatenate([state.normals[..., bodies] for bodies in pairs]).swapaxes(0, 1)
    if of_faces:
        return normals
    first, second = (state.edges[..., bodies].swapaxes(0, 1) for bodies in pairs)
    across = _square_to(first[:, :, None], second[:, None])
    return np.concatenate([normals, across.reshape(3, len(state.edges) ** 2, -1)], axis=1)


def one_direction(state: BodyState, pairs: Pairs, number: Integers) -> Array:
    """The direction of each pair (3, P) with its number (P,) in :func:`directions`."""
    faces, edges = len(state.normals), len(state.edges)
    body = np.where(number < faces, *pairs)
    normal = state.normals[np.minimum(number, 2 * faces - 1) % faces, :, body].T
    of_first, of_second = np.divmod(np.maximum(number - 2 * faces, 0), edges)
    u, v = state.edges[of_first, :, pairs[0]].T, state.edges[of_second, :, pairs[1]].T
    return np.where(number < 2 * faces, normal, _square_to(u, v))


@record
class Apartness:
    """How far pairs of bodies are apart in two states."""

    gaps: Array  # (2, P), the widest in either state, negative where they meet
    number: Integers  # (P,), the direction that parts them most in both

    @classmethod
    def of(cls, states: Sequence[BodyState], pairs: Pairs, *, of_faces: bool = False) -> Apartness:
        """The apartness of pairs of bodies (P,) in two states, or as far as normals show it."""
        gaps, number = np.empty((2, len(pairs[0]))), np.empty(len(pairs[0]), np.int64)
        for k in range(0, len(number), CHUNK):
            part = slice(k, k + CHUNK)
            chunk = pairs[0][part], pairs[1][part]
            both = np.stack([_plain_gaps(state, chunk, of_faces) for state in states])
            gaps[:, part] = both.max(axis=1)
            number[part] = both.min(axis=0).argmax(axis=0)
        return cls(gaps, number)

    def touching(self, state: int, pairs: Pairs, tolerance: float) -> tuple[int, int] | None:
        """The nearest pair within a tolerance in the first or in the second state."""
        if not len(pairs[0]):
            return None
        nearest = first_smallest(self.gaps[state], ALIKE, tolerance)
        if self.gaps[state, nearest] > tolerance:
            return None
        return int(pairs[0][nearest]), int(pairs[1][nearest])

    def chosen(self, which: Booleans) -> Apartness:
        """The apartness of the pairs at which ``which`` (P,) is true."""
        return Apartness(self.gaps[:, which], self.number[which])


def _plain_gaps(state: BodyState, pairs: Pairs, of_faces: bool) -> Array:
    """Gaps (X, P) of pairs of bodies along all directions; there is none along a lost one."""
    lines = directions(state, pairs, of_faces=of_faces)
    corners = state.corners[:, :, pairs[0]], state.corners[:, :, pairs[1]]
    gap = common_gap(views_along(lines, [corners]))
    return np.where(lines.any(axis=0), gap, -np.inf)


def _square_to(u: Array, v: Array) -> Array:
    """Unit vectors (3, ...) square to vectors (3, ...), zero where these are parallel."""
    return _unit(cross(u, v), 0)


def _directions(outlines: Array) -> tuple[Array, Array]:
    """Normals (B, A, 3) of faces and directions (B, E, 3) of edges of boards (B, H, K, 3).

    Upright sides have one direction of their edges that is not along an outline.
    """
    sides = np.roll(outlines, -1, axis=2) - outlines
    longest = (sides**2).sum(axis=-1).argmax(axis=1)
    along = _unit(np.take_along_axis(sides, longest[:, None, :, None], axis=1)[:, 0], -1)
    rising = np.diff(outlines, axis=1)
    upright = np.zeros((len(outlines), 1, 3))
    upright[..., 2] = 1.0
    if not rising[..., :2].any():
        return (
            np.concatenate([upright, np.cross(along, upright)], axis=1),
            np.concatenate([along, upright], axis=1),
        )
    walls = _unit(np.cross(along[:, None], rising), -1).reshape(len(outlines), -1, 3)
    return (
        np.concatenate([upright, walls], axis=1),
        np.concatenate([along, _unit(rising, -1).reshape(len(outlines), -1, 3)], axis=1),
    )


def _unit(vectors: Array, axis: int) -> Array:
    size = np.sqrt((vectors * vectors).sum(axis=axis, keepdims=True))
    return np.asarray(vectors / np.where(size > 0, size, 1.0))


def _turned(u: Array, v: Array) -> Array:
    """Area (...) that plane vectors (..., 2) span."""
    return np.asarray(u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0])


@record
class NearPairs:
    """Pairs of bodies (P,) whose panels have a vertex in common."""

    bodies: Pairs
    vertices: Integers  # (P,), that their panels share
    # Heights (2, P) over each panel from which its corners are seen: those of hinges beside it.
    bases: Array
    # the panel (P,) between the two, and how far the hinges at its sides are apart in height (P,)
    between: Integers
    steps: Array

    @classmethod
    def opposite(
        cls, bodies: Bodies, layout: Layout, settled: Booleans, only: Booleans | None
    ) -> NearPairs:
        """Those that are opposite each other at a vertex, with hinges in the creases.

        Inner vertices (rows-2, columns-2) about which they are known to be apart are settled.
        Pairs with no panel of ``only`` (F,) are left out.
        """
        panels, vertex = opposite_panels(layout, settled)
        if only is not None:
            wanted = only[panels[0]] | only[panels[1]]
            panels, vertex = selected(panels, wanted), vertex[wanted]
        pairs, which = bodies.pairs_of(panels)
        none = np.zeros(len(which))
        return cls(pairs, vertex[which], np.stack([none, none]), bodies.panels[pairs[0]], none)


def opposite_panels(layout: Layout, settled: Booleans) -> tuple[Pairs, Integers]:
    """Panels opposite each other at the inner vertices that are not settled, and these (P,).

    Flaps beside the grid make inner vertices of the border's, which are never settled.
    """
    grid = layout.grid
    panel = np.arange(grid.panel_count).reshape(grid.rows - 1, grid.columns - 1)
    there = ~settled
    vertex = grid.vertices()[1:-1, 1:-1][there]
    upper, lower = layout.pairs.T
    # Hinges are listed by flaps.
    above, below = (layout.hinges[each - grid.panel_count, 1] for each in (upper, lower))
    faces = layout.faces[upper]
    on_border = faces[faces < grid.vertex_count]
    first = np.concatenate([panel[:-1, :-1][there], panel[:-1, 1:][there], upper, lower])
    second = np.concatenate([panel[1:, 1:][there], panel[1:, :-1][there], below, above])
    return (first, second), np.concatenate([vertex, vertex, on_border, on_border])

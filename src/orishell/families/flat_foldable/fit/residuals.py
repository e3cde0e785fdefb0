"""What a fit keeps small, and its derivatives.

Distances and their derivatives by points are those of the piece, in the unit of its size.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from orishell.conventions.record import record
from orishell.design.piece import Piece
from orishell.families.flat_foldable.fit.conditions import Conditions, corner_numbers, edge_numbers
from orishell.families.flat_foldable.fit.unknowns import OFFSET, Placed, Unknowns
from orishell.motion.quads import dots, lengths, units
from orishell.numerics.arrays import Array, Integers


def homes(rim: Sequence[Array], shape: tuple[int, int]) -> Array:
    """Points (R+2, C+2, 3) for a shape R+2, C+2: Coons' patch of four sides, evenly divided.

    S. A. Coons, Surfaces for computer-aided design of space forms, MIT MAC-TR-41 (1967).

    rim: Polylines (K, 3): the top from left to right, and so on around.
    """
    rows, columns = shape
    top, right, bottom, left = (
        _evenly(line, count)
        for line, count in zip(rim, (columns, rows, columns, rows), strict=True)
    )
    bottom, left = bottom[::-1], left[::-1]
    u, v = np.linspace(0, 1, columns)[:, None], np.linspace(0, 1, rows)[:, None, None]
    between = (1 - v) * top + v * bottom + (1 - u) * left[:, None] + u * right[:, None]
    above = (1 - u) * top[0] + u * top[-1]
    below = (1 - u) * bottom[0] + u * bottom[-1]
    return np.asarray(between - (1 - v) * above - v * below)


def _evenly(line: Array, count: int) -> Array:
    """Points (count, 3) that divide a polyline (K, 3) into equal lengths."""
    arc = np.concatenate([[0.0], np.cumsum(lengths(np.diff(line, axis=0)))])
    wanted = np.linspace(0.0, arc[-1], count)
    return np.stack([np.interp(wanted, arc, line[:, axis]) for axis in range(3)], axis=-1)


FLAT = 1e-3
"""A share of the departure from the mean plane that stands for none."""


@record
class Weights:
    """Of residuals, beside 1 for the distance of vertices from the offset surfaces."""

    rim: float = 0.3  # of the border from the rim
    centre: float = 0.2  # of panels' centres from the surface
    near: float = 0.05  # of vertices from where an even sheet would have them, along the surface
    even: float = 5e-3  # of logarithms of edges from their mean
    smooth: float = 3e-3  # of second differences of what makes the sheet
    ratio: float = 0.05  # of logarithms of edges that are too short or too long
    convex: float = 0.02  # of panel corners that are too sharp or too blunt
    fold: float = 0.02  # of logarithms of fold angles that are too large


@record
class Fitted:
    """A sheet on the way."""

    unknowns: Array  # (P,)
    placed: Placed
    heights: Array  # (R+2, C+2), of vertices over the offset surfaces, in the unit
    by_vertices: Array  # (R+2, C+2, 3), derivatives of their distances from the surface
    by_centres: Array  # (R+1, C+1, 3), of those of panels' centres
    by_border: list[Array]  # (K, 3) each, of those from the four sides of the rim
    beyond: Integers  # edges that are too long or too short
    sharp: Integers  # corners that are too sharp or too blunt
    folded: Integers  # numbers of unknowns: fold angles that are too large
    residuals: list[Array]

    @property
    def error(self) -> float:
        """Sum of squares."""
        return float(sum(each @ each for each in self.residuals))


class Problem:
    """A sheet that is to cover a piece of surface."""

    def __init__(
        self, piece: Piece, of: Unknowns, weights: Weights, conditions: Conditions
    ) -> None:
        self.piece, self.of, self.weights, self.conditions = piece, of, weights, conditions
        shape = of.shape
        self.edges = edge_numbers(*shape)
        self.corners = corner_numbers(*shape)
        # A Miura-ori's rows zigzag about those of an even sheet.
        flat = [piece.pressed(line, FLAT) for line in piece.rim]
        zigzag = of.at_first.vertices - homes(flat, shape)
        zigzag -= (zigzag @ piece.axes[2])[..., None] * piece.axes[2]
        even = homes(piece.rim, shape)
        self.homes = even + zigzag
        self.upright = piece.nearest(even.reshape(-1, 3))[1].reshape(even.shape)
        self.linear = np.concatenate(list(self._linear()))

    def at(self, unknowns: Array) -> Fitted | None:
        """The sheet of unknowns (P,); None where there is none that keeps the conditions."""
        placed = self.of.placed(unknowns)
        tangents = unknowns[: self.of.parts[1].stop]
        if not self.conditions.hold(placed.flat, tangents):
            return None
        weights, size, vertices = self.weights, self.of.size, placed.vertices
        centres = middles(vertices)
        heights, by_vertices = self.piece.over(vertices.reshape(-1, 3))
        off, by_centres = self.piece.over(centres.reshape(-1, 3))
        heights = heights.reshape(vertices.shape[:2]) / size - unknowns[OFFSET] * self.of.sides
        rims = [self.piece.beside(side, at) for side, at in enumerate(border(vertices))]
        away = vertices - self.homes
        away -= dots(away, self.upright)[..., None] * self.upright
        logs = np.log(lengths(self._spans(vertices)))
        long = self.conditions.beyond(logs)
        beyond = np.flatnonzero(long)
        blunt = self.conditions.early_sine / self._sines(vertices) - 1
        sharp = np.flatnonzero(blunt > 0)
        over = tangents - self.conditions.early_tangent
        folded = np.flatnonzero(over > 0)
        residuals = [
            heights.ravel(),
            weights.centre / size * off,
            *(weights.rim / size * each for each, _ in rims),
            weights.near / size * away.ravel(),
            weights.even * self._uneven(logs),
            weights.ratio * long[beyond],
            weights.convex * blunt[sharp],
            weights.fold * over[folded],
            self.linear @ (unknowns - self.of.first),
        ]
        return Fitted(
            unknowns, placed, heights, by_vertices.reshape(vertices.shape),
            by_centres.reshape(centres.shape), [each for _, each in rims],
            beyond, sharp, folded, residuals,
        )  # fmt: skip

    def derivatives(self, at: Fitted) -> list[Array]:
        """Derivatives (N, P) of the residuals."""
        weights, size, count = self.weights, self.of.size, len(at.unknowns)
        slopes = self.of.slopes(at.unknowns, at.placed)
        vertices = at.placed.vertices
        upwards = _along(slopes, self.upright)[:, :, None]
        sideways = slopes - upwards * self.upright[..., None]
        heights = _along(slopes, at.by_vertices) / size
        heights[..., OFFSET] -= self.of.sides
        off = _along(middles(slopes), at.by_centres)
        rims = [_along(*each) for each in zip(border(slopes), at.by_border, strict=True)]
        spans = self._spans(vertices)
        stretch = _along(self._spans(slopes), spans) / dots(spans, spans)[:, None]
        unit = np.eye(count)
        return [
            heights.reshape(-1, count),
            weights.centre / size * off.reshape(-1, count),
            *(weights.rim / size * each for each in rims),
            weights.near / size * sideways.reshape(-1, count),
            weights.even * self._uneven(stretch),
            weights.ratio * stretch[at.beyond],
            weights.convex * self._blunter(vertices, slopes, at.sharp),
            weights.fold * unit[at.folded],
            self.linear,
        ]

    def _spans(self, points: Array) -> Array:
        """Edges (E, 3, ...) as vectors."""
        flat = points.reshape(-1, *points.shape[2:])
        start, stop = self.edges
        return np.asarray(flat[stop] - flat[start])

    def _uneven(self, logs: Array) -> Array:
        """Logarithms of edges (E, ...) less the mean of those along rows, or of the others."""
        rows, columns = self.of.shape
        parts = logs[: rows * (columns - 1)], logs[rows * (columns - 1) :]
        return np.concatenate([each - each.mean(axis=0) for each in parts])

    def _sines(self, vertices: Array) -> Array:
        """Sines (N,) of all corners of panels."""
        _, _, crossed, spans = self._at_corners(vertices, slice(None))
        return np.asarray(crossed / spans)

    def _at_corners(
        self, vertices: Array, chosen: slice | Integers
    ) -> tuple[Array, Array, Array, Array]:
        """Edges (N, 3) at corners, square in their panels, their cross products, their lengths."""
        points = vertices.reshape(-1, 3)
        at, after, before = (each[chosen] for each in self.corners)
        p, q = points[after] - points[at], points[before] - points[at]
        normal = units(
            np.cross(vertices[1:, 1:] - vertices[:-1, :-1], vertices[:-1, 1:] - vertices[1:, :-1])
        )
        n = np.repeat(normal.reshape(-1, 3), 4, axis=0)[chosen]
        return np.cross(q, n), np.cross(n, p), dots(np.cross(p, q), n), lengths(p) * lengths(q)

    def _blunter(self, vertices: Array, slopes: Array, sharp: Integers) -> Array:
        """Derivatives (S, P) of what sharp corners lack."""
        points, moves = vertices.reshape(-1, 3), slopes.reshape(-1, *slopes.shape[2:])
        by_p, by_q, crossed, spans = self._at_corners(vertices, sharp)
        at, after, before = (each[sharp] for each in self.corners)
        found = np.zeros((len(sharp), slopes.shape[-1]))
        for to, by in ((after, by_p), (before, by_q)):
            step = points[to] - points[at]
            # d(sine)/sine: of the cross product, less that of the edge's length.
            gradient = by / crossed[:, None] - step / dots(step, step)[:, None]
            found += _along(moves[to] - moves[at], gradient)
        sine = crossed / spans
        return np.asarray(-(self.conditions.early_sine / sine)[:, None] * found)

    def _linear(self) -> Iterator[Array]:
        """Rows (N, P) times the unknowns from the start: second differences, and shares of them."""
        smooth, count = self.weights.smooth, len(self.of.first)
        unit = np.eye(count)
        x, y, row, column, *edges, corners = (unit[part] for part in self.of.parts)
        for each in (x, y, row, column, *edges[:2]):
            yield smooth * np.diff(each, n=2, axis=0)
        for each in (*edges, corners):
            yield 0.3 * smooth * each
        for each in (x, y):
            yield 0.1 * smooth * each


def middles(points: Array) -> Array:
    """Means (R+1, C+1, ...) of the four corners of all panels."""
    return np.asarray(
        0.25 * (points[:-1, :-1] + points[1:, :-1] + points[1:, 1:] + points[:-1, 1:])
    )


def border(points: Array) -> tuple[Array, Array, Array, Array]:
    """Those at the top, at the right, at the bottom and at the left."""
    return points[0], points[:, -1], points[-1], points[:, 0]


def _along(slopes: Array, directions: Array) -> Array:
    """Parts (..., P) of derivatives (..., 3, P) along directions (..., 3)."""
    return np.asarray(np.einsum("...ap,...a->...p", slopes, directions))

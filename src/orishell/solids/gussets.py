"""Gussets: plane triangles in the folds of a shell that stands, and holes of their bolts.

At its vertex x a gusset goes along the edges u and v of the column, above and below, by a share a
of each: its corners are x, x + a u and x + a v. It is in the plane of u and v, so it lies in one of
the two angles between a panel beside u and the plane through u that it is in itself
(:mod:`~orishell.solids.plates`).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from orishell.conventions.record import record
from orishell.design import Design, PanelSpec
from orishell.design.holes import Holes
from orishell.design.part import Part
from orishell.design.stiffeners import Bolts, Plate
from orishell.motion.boards import Boards
from orishell.numerics.arrays import Array, Integers
from orishell.solids.plates import angle_about, lying, plate_parts, stand_off, upright_boards


@record
class Gussets:
    """Gussets at the target, in the frame of the sheet."""

    at: Integers  # rows and columns (G, 2) of their vertices
    share: float  # how far they go along edges
    corners: Array  # x, x + a u, the middle of the outer side, and x + a v (G, 4, 3)
    # how far they stand off the edges u and v (G, 2), infinite where there is no room
    off: Array
    build: PanelSpec | None = None  # what they are made of; None if they have no thickness

    @classmethod
    def of(
        cls, design: Design, at: Integers, share: float, build: PanelSpec | None = None
    ) -> Gussets:
        """Gussets at vertices.

        at: Rows and columns (G, 2) of the sheet's vertices.
        share: How far they go along edges.
        build: What they are made of; None if that is what panels are made of.
        """
        build = build or design.panel
        points = design.mechanism.positions(design.mechanism.target_drive)
        row, column = at.T
        x = points[row, column]
        up, down = points[row - 1, column] - x, points[row + 1, column] - x
        ends = x + share * up, x + share * down
        corners = np.stack([x, ends[0], 0.5 * (ends[0] + ends[1]), ends[1]], axis=1)
        last = points.shape[1] - 1
        halves = [0.0 if each is None else each.height for each in (build, design.panel)]
        off = np.zeros((len(at), 2))
        for side in (-1, 1):
            there = np.flatnonzero((column + side >= 0) & (column + side <= last))
            across = points[row[there], column[there] + side] - x[there]
            for number, (along, inwards) in enumerate(((up, down), (down, up))):
                angle = angle_about(along[there], inwards[there], across)
                needed = stand_off(angle, *halves)
                off[there, number] = np.maximum(off[there, number], needed)
        return cls(at, share, corners, off, build)

    def __len__(self) -> int:
        return len(self.at)

    @property
    def names(self) -> tuple[str, ...]:
        """What each is called."""
        return tuple(f"gusset {row},{column}" for row, column in self.at.tolist())

    def lying(self) -> Array:
        """Corners (G, 4, 2) of each in its own plane, its vertex in the origin."""
        return lying(self.corners)

    def cut(self) -> Array:
        """Corners (G, 3, 2) of plates in their own planes, off the edges that they stand beside.

        With shares s of the first side and t of the second a point is s q + t r. It is as far off
        the first side as t times the height of the triangle over that side.
        """
        _, q, _, r = np.moveaxis(self.lying(), 1, 0)
        twice = q[:, 0] * r[:, 1] - q[:, 1] * r[:, 0]
        lengths = np.linalg.norm(np.stack([q, r], axis=1), axis=-1)
        t, s = (self.off * lengths / twice[:, None]).T
        shares = np.stack(
            [np.stack([s, t], -1), np.stack([1 - t, t], -1), np.stack([s, 1 - s], -1)], axis=1
        )
        return np.asarray(shares @ np.stack([q, r], axis=1))

    def left(self) -> Array:
        """The share (G,) of their length that plates have along their edges, after standing off."""
        _, q, _, r = np.moveaxis(self.lying(), 1, 0)
        twice = q[:, 0] * r[:, 1] - q[:, 1] * r[:, 0]
        lengths = np.linalg.norm(np.stack([q, r], axis=1), axis=-1)
        return np.asarray(1 - (self.off * lengths).sum(axis=1) / twice)

    def rows(self, off: float) -> tuple[Array, Array]:
        """Where rows of holes along both edges begin and end (G, 2, 2, 2); their lengths (G, 2).

        They are so far ``off`` edges and the outer side, each as far off the other row, too;
        lengths are below 0 where there is no room. A point that is a, b and c off sides of lengths
        A, B and C has the weights a A, b B and c C at the corners opposite, whose sum is twice the
        area.
        """
        corners = self.cut()
        side = np.roll(corners, -1, axis=1) - corners  # from 0 to 1, from 1 to 2, from 2 to 0
        size = np.linalg.norm(side, axis=-1)
        twice = side[:, 0, 0] * side[:, 1, 1] - side[:, 0, 1] * side[:, 1, 0]
        first, outer, second = (off * size / twice[:, None]).T

        def at(one: Array, two: Array) -> Array:
            """Points (G, 2) by their weights at corners 1 and 2."""
            weights = np.stack([1 - one - two, one, two], axis=-1)
            return np.asarray(np.einsum("gc,gcx->gx", weights, corners))

        ends = np.stack(
            [
                np.stack([at(2 * second, first), at(1 - outer - first, first)], axis=1),
                np.stack([at(second, 2 * first), at(second, 1 - outer - second)], axis=1),
            ],
            axis=1,
        )
        along = np.stack([side[:, 0], -side[:, 2]], axis=1) / size[:, [0, 2], None]
        return ends, np.einsum("gex,gex->ge", ends[:, :, 1] - ends[:, :, 0], along)

    def holes(self, bolts: Bolts) -> list[Holes]:
        """Holes of each, where its vertex is the origin: as many in a row as there is room for."""
        ends, rooms = self.rows(bolts.off)
        sides = np.linalg.norm(self.cut()[:, 1:] - self.cut()[:, :1], axis=-1)
        counts = 1 + np.floor(rooms / bolts.spacing * (1 + 1e-9)).astype(np.int64)
        found = []
        for gusset in range(len(self)):
            rows = []
            for (begin, end), count, room, side in zip(
                ends[gusset], counts[gusset].tolist(), rooms[gusset], sides[gusset], strict=True
            ):
                away = 0.5 * room + bolts.spacing * (np.arange(count) - 0.5 * (count - 1))
                middles = begin + away[:, None] / room * (end - begin)
                panels, hole = np.zeros(count, np.int64), np.full(count, bolts.hole)
                rows.append(Holes(panels, middles, hole, np.full(count, side / count)))
            joined = Holes.joined(rows)
            assert joined is not None
            found.append(joined)
        return found

    def boards(self, flat: Array, levels: int) -> Boards:
        """Their boards, as panels of their own whose first corners lie at places (G, 2).

        Each has one, or two on a membrane.

        levels: At how many heights boards have outlines.
        """
        assert self.build is not None
        return upright_boards(self.cut() + flat[:, None], self.build, levels)


def gusset_parts(
    design: Design,
    gussets: Gussets,
    levels: int,
    material: str = "",
    bolts: Bolts | None = None,
) -> Iterator[Part]:
    """Gussets as parts, each beside the vertex of the flat sheet that it goes to.

    levels: At how many heights boards have outlines.
    material: Of their boards, if that is not what panels are made of.
    bolts: What holds them; None if they are clipped in.
    """
    shares = np.tile(_borne(gussets.share), (len(gussets), 1))
    holes = [None] * len(gussets) if bolts is None else gussets.holes(bolts)
    parts = plate_parts(design, gussets, gussets.at, shares, levels)
    for part, drilled, (row, column) in zip(parts, holes, gussets.at.tolist(), strict=True):
        assert part.flat is not None
        yield replace(
            part,
            material=material,
            holes=None if drilled is None else drilled.moved(0, part.flat[0]),
            plate=Plate((row, column), gussets.share),
        )


def _borne(share: float) -> Array:
    """What the vertex of a gusset and those above and below bear of it (3,), each corner a third.

    A corner at a share of an edge is borne by both of its ends.
    """
    return np.array([3 - 2 * share, share, share]) / 3

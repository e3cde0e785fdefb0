"""Parts laid on sheets of stock, side by side, turned but never turned over."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.errors import InputError
from orishell.numerics.arrays import Array
from orishell.workshop.fitting import find_turns
from orishell.workshop.placing import Placement, turned

if TYPE_CHECKING:
    from shapely import Polygon


CLEARANCE = 1e-9
"""Rounding, relative to the stock: four times as much is added to the spacing."""
MOST_NESTED = 120
"""So many parts, the largest, are laid where there is room for them; others are laid in rows."""
SLIDES = 16
"""Steps in which a part is moved on into the hollows of others."""


def nest_parts(
    outlines: Sequence[Array], width: float, height: float, spacing: float
) -> tuple[Placement, ...]:
    """Lay parts on as few sheets as it takes, the largest first.

    Every part goes to the first sheet that has room for it, as far as possible towards the
    left of a landscape sheet or the foot of a portrait one, so that what is left of the last
    one is in one piece. Parts keep clear of each other's convex hulls, found exactly (the
    places where two hulls meet are the hull of the differences of their corners), then slide
    on into hollows. Of more than :data:`MOST_NESTED` parts the smaller ones are laid side by side
    in rows, on sheets of their own.

    Raises InputError if a part does not fit the stock.
    """
    import shapely

    shapes = [shapely.Polygon(outline) for outline in outlines]
    order = sorted(range(len(shapes)), key=lambda k: (-round(shapes[k].area, 12), k))
    sheets: list[_Stock] = []
    placements: list[Placement | None] = [None] * len(shapes)
    clear = spacing + 4 * CLEARANCE * max(width, height)
    for k in order[:MOST_NESTED]:
        turns = _choose_turns(outlines[k], width, height)
        tried = (sheet.place(outlines[k], turns) for sheet in sheets)
        number, placed = next(
            ((n, found) for n, found in enumerate(tried) if found is not None), (len(sheets), None)
        )
        if placed is None:
            sheets.append(_Stock(width, height, clear))
            placed = sheets[-1].place(outlines[k], turns)
        if placed is None:
            raise AssertionError("a part that fits the stock has its place on an empty sheet")
        placements[k] = Placement(number, *placed)
    for k, row in _lay_rows(outlines, order[MOST_NESTED:], width, height, clear).items():
        placements[k] = replace(row, sheet=len(sheets) + row.sheet)
    return tuple(placement for placement in placements if placement is not None)


def _lay_rows(
    outlines: Sequence[Array], order: Sequence[int], width: float, height: float, clear: float
) -> dict[int, Placement]:
    """Lay parts, each turned to be lowest, in rows from left to right, the highest first."""
    lying = {}
    for k in order:
        turns = _choose_turns(outlines[k], width, height)
        sizes = np.array([np.ptp(turned(outlines[k], angle), axis=0) for angle in turns])
        best = int(np.argmin(np.round(sizes[:, 1] / height, 9)))
        lying[k] = (float(turns[best]), sizes[best])
    placements = {}
    place, row, sheet = np.zeros(2), 0.0, 0
    for k in sorted(order, key=lambda k: (-round(float(lying[k][1][1]), 12), k)):
        angle, size = lying[k]
        if place[0] + size[0] > width * (1 + CLEARANCE):
            place, row = np.array([0.0, place[1] + row + clear]), 0.0
        if place[1] + size[1] > height * (1 + CLEARANCE):
            place, row, sheet = np.zeros(2), 0.0, sheet + 1
        corner = turned(outlines[k], angle).min(axis=0)
        placements[k] = Placement(sheet, angle, place - corner)
        place, row = place + np.array([size[0] + clear, 0.0]), max(row, float(size[1]))
    return placements


def _choose_turns(outline: Array, width: float, height: float) -> Array:
    """Angles to try: 0 if that fits, and up to four with the smallest bounding boxes."""
    turns = find_turns(outline, width, height)
    if not len(turns):
        raise InputError(
            "a part does not fit the stock",
            keys=("workshop.stock",),
            got=f"{width:.6g} x {height:.6g} without its margins",
            expected="room for every part and strip",
        )
    upright = turns[:1] if turns[0] == 0 else turns[:0]
    return np.concatenate([upright, turns[len(upright) : len(upright) + 4]])


class _Stock:
    """A sheet of stock that fills up."""

    def __init__(self, width: float, height: float, clear: float) -> None:
        self.size = np.array([width, height])
        self.clear = clear
        self.left = width * height
        self.hulls: list[Array] = []
        self.shapes: list[Polygon] = []

    def place(self, outline: Array, turns: Array) -> tuple[float, Array] | None:
        """Turn and shift of a part, which is laid there; None if there is no room for it."""
        import shapely

        area = shapely.Polygon(outline).area
        if area > self.left * (1 + CLEARANCE):
            return None
        along = int(np.argmax(self.size))
        best: tuple[tuple[float, float], float, Array] | None = None
        for angle in turns.tolist():
            lying = turned(outline, angle)
            corner = lying.min(axis=0)
            places = self._free_places(lying - corner)
            if not len(places):
                continue
            ends = np.round((places + np.ptp(lying, axis=0)) / self.size, 9)
            first = int(np.lexsort((ends[:, 1 - along], ends[:, along]))[0])
            key = (float(ends[first, along]), float(ends[first, 1 - along]))
            if best is None or key < best[0]:
                best = (key, angle, places[first] - corner)
        if best is None:
            return None
        _, angle, shift = best
        shape = self._slid(shapely.Polygon(turned(outline, angle) + shift), along)
        shift = shapely.get_coordinates(shape)[0] - turned(outline, angle)[0]
        self.left -= area
        self.shapes.append(shape)
        self.hulls.append(_hull(shapely.get_coordinates(shape)))
        return angle, shift

    def _free_places(self, outline: Array) -> Array:
        """Places (k, 2) of the lower left corner of an outline's box where its hull is free."""
        import shapely

        room = np.maximum(self.size - outline.max(axis=0), 0.0)
        tiny = CLEARANCE * self.size.max()
        free = shapely.box(-tiny, -tiny, *(room + tiny))
        if self.hulls:
            hull = _hull(outline)
            taken = np.concatenate(self.hulls)
            owner = np.repeat(np.arange(len(self.hulls)), [len(each) for each in self.hulls])
            met = shapely.linestrings(
                (taken[:, None] - hull).reshape(-1, 2), indices=np.repeat(owner, len(hull))
            )
            near = shapely.buffer(
                shapely.convex_hull(met), self.clear, join_style="mitre", mitre_limit=20.0
            )
            free = shapely.difference(free, shapely.union_all(near))
        return np.clip(shapely.get_coordinates(free), 0.0, room)

    def _slid(self, shape: Polygon, along: int) -> Polygon:
        """The shape moved on along the sheet and across it, as far as others leave it room."""
        import shapely

        if not self.shapes:
            return shape
        others = shapely.GeometryCollection(self.shapes)
        for axis in (along, 1 - along, along):
            room = shape.bounds[axis]
            for step in np.arange(SLIDES, 0, -1) / SLIDES:
                way = np.zeros(2)
                way[axis] = -room * step
                moved = shapely.Polygon(shapely.get_coordinates(shape) + way)
                if shapely.distance(moved, others) >= self.clear:
                    shape = moved
                    break
        return shape


def _hull(points: Array) -> Array:
    import shapely

    return shapely.get_coordinates(shapely.convex_hull(shapely.multipoints(points)))

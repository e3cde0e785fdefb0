"""Parts laid on sheets of stock, side by side, turned but never turned over."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Literal

import numpy as np

from orishell.conventions.errors import InputError
from orishell.numerics.arrays import Array
from orishell.workshop.bars import fewest_bars
from orishell.workshop.fitting import find_turns
from orishell.workshop.placing import Placement, turned

if TYPE_CHECKING:
    from shapely import Polygon


CLEARANCE = 1e-9
"""Rounding, relative to the stock: four times as much is added to the spacing."""
MOST_NESTED = 800
"""So many parts, the largest, are laid where there is room for them; others are laid in rows."""
REFUSED = 0.9
"""A sheet that had no room for a part is tried again with parts smaller than this share of it."""
SLIDES = 16
"""Steps in which a part is moved on into the hollows of others."""


@dataclass(frozen=True)
class _Rule:
    """How far along a sheet a part lies: what of it counts, and along which side of the stock."""

    part: Literal["end", "middle"]
    side: Literal["long", "short"]


RULES = (_Rule("middle", "long"), _Rule("middle", "short"), _Rule("end", "long"))
"""In the order in which they are tried: as many as lay MOST_NESTED parts between them."""


def fewest_sheets(areas: Array, sheet: float) -> int:
    """How few sheets parts of areas (P,) take at least, whichever way they are laid.

    Two parts that are larger than a sheet between them are not on the same one: that is the bound
    of pieces cut from bars, of areas in place of lengths.

    Parameters
    ----------
    sheet
        Area of one, within its margins.
    """
    return fewest_bars(areas, sheet * (1 + CLEARANCE))


def nest_parts(
    outlines: Sequence[Array], width: float, height: float, spacing: float
) -> tuple[Placement, ...]:
    """Lay parts on as few sheets as it takes, the largest first.

    Every part goes to the first sheet that has room for it, as far as possible towards one side,
    so that what is left of the last one is in one piece. Parts keep clear of each other's convex
    hulls, found exactly (the places where two hulls meet are the hull of the differences of their
    corners), then slide on into hollows. Towards which side, and by which point of a part, is
    tried, and the fewest sheets are kept. Of more than :data:`MOST_NESTED` parts the smaller ones
    are laid side by side in rows, on sheets of their own.

    Raises InputError if a part does not fit the stock.
    """
    import shapely

    areas = [shapely.Polygon(outline).area for outline in outlines]
    order = sorted(range(len(areas)), key=lambda k: (-round(areas[k], 12), k))
    closely, others = order[:MOST_NESTED], order[MOST_NESTED:]
    clear = spacing + 4 * CLEARANCE * max(width, height)
    parts = [
        _Part(k, outlines[k], areas[k], _choose_turns(outlines[k], width, height)) for k in closely
    ]
    fewest = fewest_sheets(np.array([part.area for part in parts]), width * height)
    best: dict[int, Placement] | None = None
    least = 0
    for rule in RULES[: max(1, MOST_NESTED // max(1, len(parts)))]:
        found, sheets = _nest(parts, (width, height), clear, rule)
        if best is None or sheets < least:
            best, least = found, sheets
        if least <= fewest:
            break
    assert best is not None
    for k, row in _lay_rows(outlines, others, width, height, clear).items():
        best[k] = replace(row, sheet=least + row.sheet)
    return tuple(best[k] for k in range(len(outlines)))


@dataclass(frozen=True)
class _Part:
    """A part that is laid, and the angles that are tried."""

    number: int
    outline: Array
    area: float
    turns: Array


def _nest(
    parts: Sequence[_Part], size: tuple[float, float], clear: float, rule: _Rule
) -> tuple[dict[int, Placement], int]:
    """Where parts lie by a rule, and on how many sheets."""
    sheets: list[_Stock] = []
    placements: dict[int, Placement] = {}
    for part in parts:
        tried = ((n, sheet.place(part)) for n, sheet in enumerate(sheets))
        number, placed = next(((n, found) for n, found in tried if found is not None), (-1, None))
        if placed is None:
            number = len(sheets)
            sheets.append(_Stock(*size, clear, rule))
            placed = sheets[-1].place(part)
        if placed is None:
            raise AssertionError("a part that fits the stock has its place on an empty sheet")
        placements[part.number] = Placement(number, *placed)
    return placements, len(sheets)


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

    def __init__(self, width: float, height: float, clear: float, rule: _Rule) -> None:
        self.size = np.array([width, height])
        self.clear = clear
        self.left = width * height
        self.refused = np.inf  # area of the smallest part that there was no room for
        self.hulls: list[Array] = []
        self.shapes: list[Polygon] = []
        self._by_end = rule.part == "end"
        side = np.argmax if rule.side == "long" else np.argmin
        self._along = int(side(self.size))

    def place(self, part: _Part) -> tuple[float, Array] | None:
        """Turn and shift of a part, which is laid there; None if no room was found for it."""
        import shapely

        if part.area > min(self.left * (1 + CLEARANCE), REFUSED * self.refused):
            return None
        along = self._along
        best: tuple[tuple[float, float], float, Array] | None = None
        for angle in part.turns.tolist():
            lying = turned(part.outline, angle)
            corner = lying.min(axis=0)
            places = self._free_places(lying - corner)
            if not len(places):
                continue
            counts = lying.max(axis=0) if self._by_end else lying.mean(axis=0)
            far = np.round((places + counts - corner) / self.size, 9)
            first = int(np.lexsort((far[:, 1 - along], far[:, along]))[0])
            key = (float(far[first, along]), float(far[first, 1 - along]))
            if best is None or key < best[0]:
                best = (key, angle, places[first] - corner)
        if best is None:
            self.refused = min(self.refused, part.area)
            return None
        _, angle, shift = best
        shape = self._slid(shapely.Polygon(turned(part.outline, angle) + shift), along)
        shift = shapely.get_coordinates(shape)[0] - turned(part.outline, angle)[0]
        self.left -= part.area
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

"""Whether pieces of the flat sheet fit the stock, and how they are turned for it."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.quantities import ABOVE_MEANT, plain
from orishell.conventions.record import record
from orishell.document import Part
from orishell.motion.quads import signed_areas
from orishell.numerics.arrays import Array, Integers
from orishell.numerics.equals import first_largest
from orishell.workshop.tabs import find_owners, tab_shapes

SLACK = 1e-9
"""A part fits if it is no larger than the stock by more than this share of it."""


def find_turns(points: Array, width: float, height: float) -> Array:
    """Turns (t,) that fit points (k, 2) into a rectangle, in [0, 2 pi) (radians).

    Those that lay an edge of their hull level; if none of them fits, those that touch two
    opposite sides of the rectangle. If there is a way to fit the points at all, one of these does.
    0, no turn, is first if it fits, otherwise the smallest bounding box.
    """
    import shapely

    hull = shapely.get_coordinates(shapely.convex_hull(shapely.linestrings(points)))
    sides = np.diff(hull, axis=0)
    level = -np.arctan2(sides[:, 1], sides[:, 0])
    angles = np.concatenate([[0.0], np.add.outer(np.arange(4) * np.pi / 2, level).ravel()])
    fitting = _fitting(hull, angles, width, height)
    if len(fitting):
        return fitting
    across = (hull[:, None] - hull).reshape(-1, 2)
    distance = np.hypot(*across.T)
    direction = np.arctan2(across[:, 1], across[:, 0])
    tight = []
    for size, upright in ((width, 0.0), (height, np.pi / 2)):
        long = distance >= size
        swing = np.arccos(size / distance[long])
        tight += [upright + swing - direction[long], upright - swing - direction[long]]
    return _fitting(hull, np.concatenate(tight), width, height)


def _fitting(hull: Array, angles: Array, width: float, height: float) -> Array:
    angles = np.unique(np.round(angles % (2 * np.pi), 15))
    x = np.cos(angles)[:, None] * hull[:, 0] - np.sin(angles)[:, None] * hull[:, 1]
    y = np.sin(angles)[:, None] * hull[:, 0] + np.cos(angles)[:, None] * hull[:, 1]
    wide, high = np.ptp(x, axis=1), np.ptp(y, axis=1)
    slack = SLACK * max(width, height)
    fits = (wide <= width + slack) & (high <= height + slack)
    box = np.round(wide * high / (width * height), 9)
    order = np.lexsort((angles, box, angles > 0))
    return np.asarray(angles[order][fits[order]])


@record
class CutSheet:
    """The panels, the tabs that they get where they are cut apart, and the size of the stock."""

    corners: Array  # corners (F, K, 2) of the panels
    areas: Array  # their areas (F,)
    neighbours: Integers  # panels (F, S) beyond each panel's creases, -1 for none
    # far corners (F, S, 2, 2) of the tabs that it has where it is cut off from them, NaN for none
    tabs: Array
    # what can be used of the stock
    width: float
    height: float

    @classmethod
    def of(cls, document: Part, width: float, height: float, allowance: float) -> CutSheet:
        """A document's sheet with tabs of a width (``allowance``), 0 for none."""
        flat, mesh = document.require_flat(), document.mesh
        owner, _ = find_owners(document)
        shapes = tab_shapes(document, allowance)[..., 2:, :]
        creases = np.flatnonzero(mesh.crease)
        sides = mesh.loops_edges()
        neighbours = np.full(sides.shape, -1)
        tabs = np.full((*sides.shape, 2, 2), np.nan)
        for side in (0, 1):
            here, there = mesh.edge_faces[creases, side], mesh.edge_faces[creases, 1 - side]
            slot = np.argmax(sides[here] == creases[:, None], axis=1)
            neighbours[here, slot] = there
            owned = owner[creases] == here
            tabs[here[owned], slot[owned]] = shapes[creases[owned], 1 - side]
        return cls(
            flat[mesh.faces], document.areas(), neighbours, tabs, float(width), float(height)
        )

    @classmethod
    def apart(cls, outlines: Array, width: float, height: float) -> CutSheet:
        """Panels with outlines (F, K, 2) of their own, cut one by one."""
        count = len(outlines)
        areas, alone = signed_areas(outlines), np.full((count, 4), -1)
        none = np.full((count, 4, 2, 2), np.nan)
        return cls(outlines, areas, alone, none, float(width), float(height))

    def points(self, panels: Integers, rim: Integers | None = None) -> Array:
        """Corners (k, 2) of panels (P,) that hang together, and of the tabs around them.

        If those on their ``rim`` (R,) are known no others are looked at.
        """
        rim = panels if rim is None else rim
        inside = np.zeros(len(self.corners) + 1, dtype=np.bool_)
        inside[panels] = True
        tabs = self.tabs[rim][~inside[self.neighbours[rim]]].reshape(-1, 2)
        tabs = tabs[~np.isnan(tabs[:, 0])]
        return np.concatenate([self.corners[rim].reshape(-1, 2), tabs])

    def fits(self, panels: Integers, rim: Integers | None = None) -> bool:
        """Whether panels fit the stock in one piece; ``rim`` as in :meth:`points`."""
        if self.areas[panels].sum() > (1 + SLACK) * self.width * self.height:
            return False
        points = self.points(panels, rim)
        size = np.ptp(points, axis=0)
        if (size <= (self.width, self.height)).all():
            return True
        if size.max() > math.hypot(self.width, self.height) * (1 + SLACK):
            return False
        return len(find_turns(points, self.width, self.height)) > 0


class OversizeError(InputError):
    """Panels that the stock, or a roll, is too small for.

    Parameters
    ----------
    factor
        By how much the largest of them is larger (more than 1).
    needed
        Sides that all panels fit, margins included, by the key of what is too small:
        "workshop.stock", whose longer one is first, or "workshop.roll" (length).
    """

    def __init__(
        self, what: str, factor: float, needed: Mapping[str, tuple[float, float]], **facts: Any
    ) -> None:
        super().__init__(what, keys=tuple(needed), **facts)
        self.factor, self.needed = factor, dict(needed)
        self.remedy = f"{self.larger}, or more rows or columns"

    @property
    def larger(self) -> str:
        """What would do as the sheet is: larger stock, larger rolls, or both."""
        names = ("rolls" if each == "roll" else each for each in map(_sold, self.needed))
        return f"larger {' and '.join(names)}"

    @classmethod
    def joined(cls, found: Sequence[OversizeError]) -> OversizeError:
        """One refusal for all that is too small: who mends one does not meet the next.

        Parameters
        ----------
        found
            Those of each of them, one or more.
        """
        if len(found) == 1:
            return found[0]
        named = [(_sold(key), each) for each in found for key in each.needed]
        return cls(
            "; ".join(each.what for each in found),
            max(each.factor for each in found),
            {key: sides for each in found for key, sides in each.needed.items()},
            got=" and ".join(f"{sold} of {each.got}" for sold, each in named),
            expected="; ".join(f"{sold} of {each.expected}" for sold, each in named),
        )


def _sold(key: str) -> str:
    """What a key of the design file has the size of."""
    return key.removeprefix("workshop.")


def require_panels_fit(document: Part, sheet: CutSheet) -> None:
    """Refuse a sheet with a panel that is larger than the stock.

    Raises
    ------
    OversizeError
        With a size that every panel fits.
    """
    found = find_too_large(document, sheet)
    if found is not None:
        raise found


def find_too_large(
    document: Part, sheet: CutSheet, margin: float = 0.0, key: str = "workshop.stock"
) -> OversizeError | None:
    """The refusal of panels that are larger than the stock; None if all fit.

    Where panels are cut from it more than once, as boards of two faces are, all follow each other.

    Parameters
    ----------
    margin
        Rim of the stock beside what can be used of it (length).
    key
        Where the design file has the stock.
    """
    import shapely

    tabs = sheet.tabs.reshape(len(sheet.tabs), -1, 2)
    corners = np.concatenate([sheet.corners, tabs], axis=1)
    corners = np.where(np.isnan(corners), corners[:, :1], corners)
    size = np.ptp(corners, axis=1)
    large = np.flatnonzero((size > (sheet.width, sheet.height)).any(axis=1))
    wrong = [int(k) for k in large if not sheet.fits(np.array([k]))]
    if not wrong:
        return None
    boxes = np.asarray(shapely.minimum_rotated_rectangle(shapely.multipoints(corners)))
    sides = np.zeros((len(corners), 2))
    flat = shapely.get_type_id(boxes) == POLYGON  # others are panels without a board
    rings = shapely.get_coordinates(boxes[flat]).reshape(-1, 5, 2)
    sides[flat] = np.sort(np.hypot(*np.diff(rings[:, :3], axis=1).T).T, axis=1)
    short, long = sides[wrong].max(axis=0).tolist()
    count = len(document.mesh.faces)
    largest = document.panel_name(wrong[first_largest(sides[wrong, 1])] % count)
    names = [document.panel_name(k) for k in sorted({k % count for k in wrong})]
    stock = sorted((sheet.width, sheet.height))
    # Those that fit the stock as it is must fit what is offered, too.
    low, high = (above(side + 2 * margin) for side in sides.max(axis=0).tolist())
    needed = high, low
    if key.endswith("roll"):  # it stays as long as it is, if that is enough
        least = (low, high) if sheet.width <= sheet.height else (high, low)
        given = (above(side + 2 * margin) for side in (sheet.width, sheet.height))
        needed = max(next(given), least[0]), max(next(given), least[1])
    rim = f", with its margins of {plain(margin)}" if margin else ""
    return OversizeError(
        f"{len(names)} of {count} panels do not fit the {_sold(key)}: {_listed(names)}",
        max(short / stock[0], long / stock[1], 1 + SLACK),
        {key: needed},
        got=f"{sheet.width + 2 * margin:.6g} x {sheet.height + 2 * margin:.6g}{rim}",
        expected=f"at least {' x '.join(map(plain, needed))}{rim}, in which each of them fits; "
        f"the longest is panel {largest}, with its tabs if it has any",
    )


def _listed(names: list[str]) -> str:
    """Names of panels, the first few of many."""
    more = len(names) - NAMED
    return "; ".join(names[:NAMED]) + (f" and {more} more" if more > 0 else "")


NAMED = 4
"""Panels that a message names at most."""
POLYGON = 3
"""The type of a polygon, as shapely numbers them."""


def above(length: float) -> float:
    """A length in four digits, rounded up."""
    unit = 10.0 ** (math.floor(math.log10(length)) - 3)
    return float(plain(math.ceil(length / unit * (1 - ABOVE_MEANT)) * unit))

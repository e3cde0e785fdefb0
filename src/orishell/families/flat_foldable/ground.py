"""A shell that stands level: border vertices moved along their creases to the ground.

A vertex of the border ends one crease, and lengthening or shortening that crease keeps all panels
planar and changes nothing of how the sheet folds. So a border vertex z above the ground, whose
crease begins at an inner vertex z_0 above it, reaches the ground with z_0/(z_0 - z) of its length.
A corner of the sheet is free in the plane of its panel.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Literal

import numpy as np

from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.families.flat_foldable.mechanism import FlatFoldable
from orishell.families.flat_foldable.net import CORNERS, Net
from orishell.families.flat_foldable.refusal import find_fault
from orishell.numerics.arrays import Array, Booleans
from orishell.numerics.equals import first_smallest

Ground = Literal["free", "corners", "level"]
"""How a shell meets the ground: as it was fitted; on one vertex of each corner panel or more; with
two opposite sides of its rim."""
SHORTEST, LONGEST = 0.3, 2.5
"""Creases become by these factors shorter or longer, at most, to end on the ground."""
KEY = "pattern.ground"


@record
class _Side:
    """A side of the border: the creases that end there, seen at the target."""

    name: str  # of its lengths in the net
    border: tuple[int | slice, int | slice]  # its vertices without corners
    beside: tuple[int | slice, int | slice]  # those where their creases begin

    def shares(self, heights: Array, ground: Array | float) -> Array:
        """Of their lengths (K,) at which creases end on the ground; infinite for level ones."""
        drop = heights[self.beside] - heights[self.border]
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.asarray(np.where(drop == 0, np.inf, (heights[self.beside] - ground) / drop))


MIDDLE = slice(1, -1)
SIDES = (
    _Side("top", (0, MIDDLE), (1, MIDDLE)),
    _Side("right", (MIDDLE, -1), (MIDDLE, -2)),
    _Side("bottom", (-1, MIDDLE), (-2, MIDDLE)),
    _Side("left", (MIDDLE, 0), (MIDDLE, 1)),
)


def grounded(shell: FlatFoldable, how: Ground) -> FlatFoldable:
    """The shell with border vertices moved to one height, none lower.

    Raises
    ------
    DesignError
        If a crease does not lead there, or a panel would turn over.
    """
    if how == "free":
        return shell
    places = shell.positions(shell.target_drive)
    heights = places[..., 2]
    on = _on_corners(heights) if how == "corners" else _on_sides(heights)
    ground = _height(heights, on)
    net = _ended(shell.sheet.net, places, on, ground)
    fault = find_fault(net)
    if fault is not None:
        raise _refused(f"cut at the ground, {fault.condition}", fault.place, fault.size)
    return replace(shell, sheet=net.march())


def _on_corners(heights: Array) -> Booleans:
    """Which vertices (R, C) are feet: the lowest on the border of each corner panel."""
    on, size = np.zeros(heights.shape, np.bool_), float(np.ptp(heights))
    for row, column in CORNERS:
        near = 1 if row == 0 else -2, 1 if column == 0 else -2
        around = (row, column), (near[0], column), (row, near[1])
        on[around[first_smallest([heights[at] for at in around], size=size)]] = True
    return on


def _on_sides(heights: Array) -> Booleans:
    """Which vertices (R, C) are feet: those of the two opposite sides that are lower."""
    low = [float(heights[side.border].mean()) for side in SIDES]
    first = int(low[0] + low[2] > low[1] + low[3])
    on = np.zeros(heights.shape, np.bool_)
    for side in SIDES[first::2]:
        row, column = side.border
        on[(row, slice(None)) if first == 0 else (slice(None), column)] = True
    return on


def _height(heights: Array, on: Booleans) -> float:
    """The mean height of feet, or as near to it as their creases allow."""
    low, high = -np.inf, float(heights[1:-1, 1:-1].min())
    for side in SIDES:
        beside, drop = heights[side.beside], heights[side.beside] - heights[side.border]
        feet = on[side.border]
        level = feet & ~(drop > 0)
        if level.any():
            raise _refused(
                "a crease does not lead to the ground",
                _place(side, int(level.argmax()), heights.shape),
                "it rises towards the border",
            )
        if feet.any():
            low = max(low, float((beside - LONGEST * drop)[feet].max()))
        # Those below the ground are to end there, too.
        falling = drop > 0
        if falling.any():
            high = min(high, float((beside - SHORTEST * drop)[falling].min()))
    wanted = float(heights[on].mean())
    if low > high:
        raise _refused(
            "creases do not meet one level",
            "along the border",
            f"some end {plain(low - high)} above others even with {LONGEST:g} times their "
            f"length, or {SHORTEST:g} times",
        )
    return float(np.clip(wanted, low, high))


def _ended(net: Net, places: Array, on: Booleans, ground: float) -> Net:
    """The net whose feet, and what would be lower, are on the ground."""
    heights = places[..., 2]
    on = on | (heights < ground)
    changes: dict[str, Array] = {}
    moved = places.copy()
    for side in SIDES:
        share = np.where(on[side.border], side.shares(heights, ground), 1.0)
        changes[side.name] = getattr(net, side.name) * share[:, None]
        start = places[side.beside]
        moved[side.border] = start + share[:, None] * (places[side.border] - start)
    corners = net.corners.copy()
    for number, (row, column) in enumerate(CORNERS):
        near = 1 if row == 0 else -2, 1 if column == 0 else -2
        start = places[near]
        edges = np.stack([moved[near[0], column] - start, moved[row, near[1]] - start], axis=-1)
        place = places[row, column]
        if on[row, column]:
            beside = on[near[0], column], on[row, near[1]]
            place = _lowered(place, start + edges.T, beside, edges, ground)
        corners[number, :, 0] = np.linalg.lstsq(edges, place - start, rcond=None)[0]
    return replace(net, **changes, corners=corners)


def _lowered(
    corner: Array, ends: Array, grounded: tuple[bool, bool], edges: Array, ground: float
) -> Array:
    """The corner (3,) of the sheet on the ground, in the plane of its panel.

    Along its edge to the one neighbour of ``ends`` (2, 3) that is not on the ground, else straight
    down its panel.
    """
    up = edges @ np.linalg.lstsq(edges, np.array([0.0, 0.0, 1.0]), rcond=None)[0]
    way = up
    if grounded[0] is not grounded[1]:
        edge = corner - ends[int(grounded[0])]
        if abs(edge[2]) > 0.1 * np.linalg.norm(edge):
            way = edge
    if abs(way[2]) < 1e-6 * np.linalg.norm(way):
        raise _refused("a corner panel is level", "at a corner of the sheet", "it meets no ground")
    return np.asarray(corner + (ground - corner[2]) / way[2] * way)


def _place(side: _Side, number: int, shape: tuple[int, ...]) -> str:
    rows, columns = shape
    at = {
        "top": (0, number + 1),
        "bottom": (rows - 1, number + 1),
        "left": (number + 1, 0),
        "right": (number + 1, columns - 1),
    }[side.name]
    return f"at vertex {at[0]}, {at[1]}"


def _refused(what: str, place: str, size: str) -> DesignError:
    return DesignError(
        what,
        keys=(KEY,),
        place=place,
        size=size,
        candidates=[Remedy({KEY: "free"})],
    )

"""Upright strips that close the end of a shell: what lies between its border and the ground.

In the plane of the wall x runs along the ground, to the right as seen from outside, and y up from
the ground. The border is a polyline there. Over every x the wall goes up to the border's highest
point, so that it closes what overhangs, too. Its strips end where the border has its vertices.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from math import ceil

import numpy as np

from orishell.conventions.record import record
from orishell.design import PanelSpec
from orishell.design.end_walls import Door
from orishell.motion.boards import Boards
from orishell.motion.quads import signed_areas
from orishell.numerics.arrays import Array
from orishell.solids.plates import upright_boards

NARROW = 0.15
"""Strips narrower than this share of the mean one are joined with their neighbours."""
TRACE = 1e-6
"""What is less high or wide than this share of the wall is nothing."""
ROUNDING = 1e-10
"""What is larger than what it has to fit by this share is as large as it."""


@record
class Strips:
    """Upright strips (P,) of a wall, in its plane, from left to right."""

    # corners (P, 4, 2) from the top left one, counter-clockwise; where a strip ends in a point
    # one of them is in the middle of its top
    corners: Array
    top: Array  # corners (K, 2) of the top of the whole wall, from left to right

    def __len__(self) -> int:
        return len(self.corners)

    def areas(self) -> Array:
        """Area (P,) of each."""
        return signed_areas(self.corners)

    def boards(self, build: PanelSpec, places: Array, levels: int) -> Boards:
        """Their boards, as panels of their own whose wall's origin lies at places (P, 2).

        levels: At how many heights boards have outlines.
        """
        return upright_boards(self.corners + places[:, None], build, levels)


Strip = tuple[float, float, float, float, float]
"""Left, right, bottom, and the heights of its top on the left and on the right."""


def strips_below(
    border: Array, door: Door | None = None, largest: tuple[float, float] | None = None
) -> Strips:
    """The strips between a border (N, 2) and the ground, beside a door and over it.

    The door is inside the wall and lower than it: see :func:`room_for_door`. Strips that do not fit
    into a rectangle of the sizes ``largest`` are cut.
    """
    top = _covering(border, () if door is None else _jambs(border, door))
    nothing = TRACE * float(top[:, 1].max())
    found: list[Strip] = []
    for (left, low), (right, high) in pairwise(top.tolist()):
        bottom = 0.0
        if door is not None:
            first, last = _jambs(border, door)
            bottom = door.height if first < 0.5 * (left + right) < last else 0.0
        if max(low, high) - bottom > nothing:
            found += _cut((left, right, bottom, low, high), largest)
    return Strips(np.array([_corners(each, nothing) for each in found]), top)


def _cut(strip: Strip, largest: tuple[float, float] | None) -> Iterator[Strip]:
    """A strip, or parts of it that fit into a rectangle: from left to right, the lower first."""
    left, right, bottom, first, last = strip
    low, high = min(first, last) - bottom, max(first, last) - bottom
    if largest is None:
        yield strip
        return
    long, short = max(largest), min(largest)
    wide, meant = right - left, 1 + ROUNDING
    if wide > meant * (long if high <= meant * short else short):
        yield from _halves(strip, largest)
    elif max(high, wide) <= meant * long:
        yield strip
    else:
        # Pieces are as high as each other, or the lowest is as low as its lower side asks.
        count = ceil(high / (meant * long))
        above = high - (count - 1) * long
        if low <= above:
            yield from _halves(strip, largest)
            return
        level = bottom + (high / count if low > high / count else 0.5 * (low + above))
        yield from _cut((left, right, bottom, level, level), largest)
        yield from _cut((left, right, level, first, last), largest)


def _halves(strip: Strip, largest: tuple[float, float]) -> Iterator[Strip]:
    left, right, bottom, low, high = strip
    middle, between = 0.5 * (left + right), 0.5 * (low + high)
    yield from _cut((left, middle, bottom, low, between), largest)
    yield from _cut((middle, right, bottom, between, high), largest)


def _corners(strip: Strip, nothing: float) -> Array:
    """Corners (4, 2) of a strip; what is less high than ``nothing`` is a point."""
    left, right, bottom, low, high = strip
    first, last = (left, low), (right, high)
    middle = (0.5 * (left + right), 0.5 * (low + high))
    if low - bottom <= nothing:
        first = middle
    elif high - bottom <= nothing:
        last = middle
    return np.array([first, (left, bottom), (right, bottom), last])


def room_for_door(border: Array, door: Door) -> float:
    """How high the wall below a border (N, 2) is where it is lowest over a door; 0 beside it."""
    first, last = _jambs(border, door)
    span = TRACE * float(np.ptp(border[:, 0]))
    if first <= border[:, 0].min() + span or last >= border[:, 0].max() - span:
        return 0.0
    top = _covering(border, (first, last))
    within = (top[:, 0] >= first - span) & (top[:, 0] <= last + span)
    return float(top[within, 1].min())


def _jambs(border: Array, door: Door) -> tuple[float, float]:
    """Where a door begins and ends."""
    middle = 0.5 * float(border[:, 0].min() + border[:, 0].max()) + door.offset
    return middle - 0.5 * door.width, middle + 0.5 * door.width


def _covering(border: Array, kept: tuple[float, ...] = ()) -> Array:
    """The least steps (K, 2) over a border (N, 2): nowhere below it, from its left to its right.

    kept: Where steps end anyhow.
    """
    cuts, heights = _highest(border, kept)
    least = NARROW * float(np.ptp(cuts)) / (len(border) - 1)
    x, y = cuts.tolist(), heights.tolist()
    fixed = {0, len(x) - 1, *np.searchsorted(cuts, kept).tolist()}
    held = [number in fixed for number in range(len(x))]
    while True:
        narrow = [
            (x[k + 1] - x[k], k)
            for k in range(len(x) - 1)
            if x[k + 1] - x[k] < least and not (held[k] and held[k + 1])
        ]
        if not narrow:
            return np.stack([x, y], axis=1)
        k = min(narrow)[1]
        # The end that goes, the one that stays, and the next beyond: what is raised least.
        ways = []
        for gone, stays, beyond in ((k, k + 1, k - 1), (k + 1, k, k + 2)):
            if not held[gone]:
                share = (x[gone] - x[stays]) / (x[beyond] - x[stays])
                ways.append(((y[gone] - share * y[beyond]) / (1 - share), gone, stays))
        raised, gone, stays = min(ways)
        y[stays] = max(y[stays], raised)
        del x[gone], y[gone], held[gone]


def _highest(border: Array, kept: tuple[float, ...]) -> tuple[Array, Array]:
    """Where (K,) the highest edge of a border (N, 2) may change, and how high (K,) it is there."""
    a, b = border[:-1], border[1:]
    run = b[:, 0] - a[:, 0]
    span = float(np.ptp(border[:, 0]))
    level = np.abs(run) > TRACE * span
    a, b, run = a[level], b[level], run[level]
    slope = (b[:, 1] - a[:, 1]) / run
    at_zero = a[:, 1] - slope * a[:, 0]
    with np.errstate(divide="ignore", invalid="ignore"):
        crossing = (at_zero[None] - at_zero[:, None]) / (slope[:, None] - slope[None])
    low, high = np.minimum(a[:, 0], b[:, 0]), np.maximum(a[:, 0], b[:, 0])
    both = np.maximum(low[:, None], low[None]), np.minimum(high[:, None], high[None])
    crossing = crossing[(crossing > both[0]) & (crossing < both[1])]
    cuts = np.sort(np.concatenate([border[:, 0], crossing]))
    # A jamb takes the place of what is too near to it.
    far = [np.abs(cuts - each) > TRACE * span for each in kept]
    cuts = np.sort(np.concatenate([cuts[np.all(far, axis=0)] if far else cuts, kept]))
    cuts = cuts[np.concatenate([[True], np.diff(cuts) > TRACE * span])]
    middles = 0.5 * (cuts[1:] + cuts[:-1])
    there = (low <= middles[:, None]) & (middles[:, None] <= high)
    highest = np.argmax(np.where(there, at_zero + slope * middles[:, None], -np.inf), axis=1)
    ends = at_zero[highest] + slope[highest] * np.stack([cuts[:-1], cuts[1:]])
    heights = np.full(len(cuts), -np.inf)
    heights[:-1] = ends[0]
    heights[1:] = np.maximum(heights[1:], ends[1])
    # Upright edges of the border, which no stretch between has.
    near = np.abs(border[:, :1] - cuts) <= TRACE * span
    heights = np.maximum(heights, np.where(near, border[:, 1:], -np.inf).max(axis=0))
    return cuts, np.maximum(heights, 0.0)

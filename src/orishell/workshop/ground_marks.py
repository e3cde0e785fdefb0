"""Marks of a plan of the ground: outlines, crosses at feet, and their numbers."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from orishell.document.ground import GroundPlan
from orishell.numerics.arrays import Array
from orishell.workshop.palettes import Circle, Line, Text
from orishell.workshop.placing import Content

WIDE = 0.9
"""Width of a character at most, in letters."""
CROSS, CORNER = 0.7, 0.45
"""Arms of the crosses at feet, and radius of the circle at the corner, in letters."""
DASH, GAP = 1.6, 1.0
"""Of the outline of the ground that is needed on the way, in letters."""
AWAY = (1.5, 2.0, 2.6, 3.3)
"""Distances of a foot's number from it that are tried, in letters."""
WAYS = 16
"""Directions of it that are tried."""


def ground_marks(plan: GroundPlan, letter: float, shares: Sequence[float] = (1.0,)) -> Content:
    """What is drawn of a plan in its coordinates, with letters of a height.

    shares: Sizes of a number that are tried, in letters; a foot whose number has no room has none.
    """
    lines = [Line("ENGRAVE", plan.hull, closed=True)]
    if plan.swept is not None:
        lines += _dashed(plan.swept.hull, letter * DASH, letter * GAP)
    lines += [Line("CUT", wall) for wall in plan.walls]
    arm = CROSS * letter * np.array([[-1.0, 0.0], [1.0, 0.0]])
    for foot in plan.feet:
        place = np.array([foot.x, foot.y])
        lines += [Line("CUT", place + arm), Line("CUT", place + arm[:, ::-1])]
    circle = Circle("CUT", 0.0, 0.0, CORNER * letter)
    numbers = _numbers(plan, lines, letter, shares)
    return tuple(lines), (circle,), tuple(numbers)


def _numbers(
    plan: GroundPlan, lines: Sequence[Line], letter: float, shares: Sequence[float]
) -> Iterator[Text]:
    """Numbers beside feet, clear of all lines and of each other, where there is room."""
    import shapely

    drawn = [
        shapely.LinearRing(line.points) if line.closed else shapely.LineString(line.points)
        for line in lines
    ]
    ring = shapely.Point(0.0, 0.0).buffer(CORNER * letter)
    tree = shapely.STRtree([*drawn, ring])
    taken = np.zeros((0, 4))
    turns = 2 * np.pi * np.arange(WAYS) / WAYS
    ways = np.stack([np.cos(turns), np.sin(turns)], axis=-1)
    for foot in plan.feet:
        words, place = str(foot.number), np.array([foot.x, foot.y])
        for share in shares:
            height = share * letter
            half = 0.5 * height * np.array([WIDE * len(words) + 0.4, 1.4])
            away = height * np.array(AWAY)[:, None, None] + half.max() - half.min()
            middles = (place + away * ways).reshape(-1, 2)
            boxes = np.concatenate([middles - half, middles + half], axis=1)
            free = np.ones(len(boxes), np.bool_)
            free[tree.query(shapely.box(*boxes.T), predicate="intersects")[0]] = False
            free &= ~_overlap(boxes, taken).any(axis=1)
            if free.any():
                chosen = int(free.argmax())
                taken = np.concatenate([taken, boxes[chosen : chosen + 1]])
                x, y = middles[chosen].tolist()
                yield Text("CUT", x, y, height, words)
                break


def _dashed(corners: Array, dash: float, gap: float) -> Iterator[Line]:
    """The dashes of a closed outline; they go around corners."""
    closed = np.concatenate([corners, corners[:1]])
    along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(closed, axis=0).T))])
    count = max(round(float(along[-1]) / (dash + gap)), 3)
    step = along[-1] / count
    for begin in (step * np.arange(count)).tolist():
        end = begin + step * dash / (dash + gap)
        between = along[(along > begin) & (along < end)]
        at = np.concatenate([[begin], between, [end]])
        yield Line(
            "ENGRAVE", np.stack([np.interp(at, along, closed[:, axis]) for axis in (0, 1)], axis=1)
        )


def _overlap(boxes: Array, others: Array) -> Array:
    """Which boxes (N, 4) overlap which others (M, 4): (N, M)."""
    mine, theirs = boxes[:, None], others[None]
    return np.asarray(
        (mine[..., :2] < theirs[..., 2:]).all(axis=-1)
        & (theirs[..., :2] < mine[..., 2:]).all(axis=-1)
    )

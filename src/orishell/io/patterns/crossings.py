"""Where lines of a drawing cross, touch and lie on each other: they are split there."""

from __future__ import annotations

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.record import record
from orishell.io.patterns.lines import Lines, most_pairs, weld_points
from orishell.numerics.arrays import Array, Integers

BLOCK = 4096
"""Lines that are compared with all at a time; fewer if they could make too many pairs."""


@record
class Split:
    """A drawing whose lines meet only at their ends."""

    points: Array  # (P, 2)
    pairs: Integers  # ends (N, 2) of all parts of lines; some lie on each other
    lines: Integers  # which line (N,) each is a part of
    bridged: float  # how far an end was moved, or is from the line that it ends on, at most


def split_lines(lines: Lines, weld: float) -> Split:
    """Split lines where they cross or an end of one is nearer to another than ``weld``.

    Raises InputError: If too many lines are near each other.
    """
    points = lines.ends.reshape(-1, 2)
    ends = weld_points(points, weld).reshape(-1, 2)
    start, way = points[ends[:, 0]], points[ends[:, 1]] - points[ends[:, 0]]
    length = np.hypot(*way.T)
    whole = np.arange(len(ends))
    # A point on a line: the line, the point, and the share of the way along the line.
    found = [(whole, ends[:, 0], np.zeros(len(ends))), (whole, ends[:, 1], np.ones(len(ends)))]
    bridged = float(np.hypot(*(points[ends] - lines.ends).reshape(-1, 2).T).max())
    crossings: list[tuple[Integers, Integers, Array]] = []
    for one, two in near_pairs(points[ends], weld):
        touch = np.zeros(len(one), dtype=np.bool_)
        for line, other in ((one, two), (two, one)):
            for point in ends[other].T:
                apart = points[point] - start[line]
                share = (apart * way[line]).sum(axis=1) / length[line] ** 2
                off = np.abs(apart[:, 0] * way[line, 1] - apart[:, 1] * way[line, 0])
                own = (ends[line] == point[:, None]).any(axis=1)
                on = (off <= weld * length[line]) & (share > 0) & (share < 1) & ~own
                found.append((line[on], point[on], share[on]))
                bridged = max(bridged, float((off[on] / length[line[on]]).max(initial=0.0)))
                touch |= on | own
        turn = cross(way[one], way[two])
        between = start[two] - start[one]
        with np.errstate(divide="ignore", invalid="ignore"):
            first = cross(between, way[two]) / turn
            second = cross(between, way[one]) / turn
        crossed = (first > 0) & (first < 1) & (second > 0) & (second < 1) & ~touch
        crossings.append((one[crossed], two[crossed], first[crossed]))
    one, two = (np.concatenate([each[k] for each in crossings]) for k in (0, 1))
    share = np.concatenate([each[2] for each in crossings])
    new = start[one] + share[:, None] * way[one]
    together = np.concatenate([points, new])
    leader = weld_points(together, weld) if len(new) else np.arange(len(points))
    for line in (one, two):
        apart = (new - start[line]) * way[line]
        found.append(
            (line, len(points) + np.arange(len(new)), apart.sum(axis=1) / length[line] ** 2)
        )
    line, point = (np.concatenate([each[k] for each in found]) for k in (0, 1))
    along = np.concatenate([each[2] for each in found])
    order = np.lexsort((along, line))
    line, point = line[order], leader[point[order]]
    part = (line[1:] == line[:-1]) & (point[1:] != point[:-1])
    pairs = np.stack([point[:-1], point[1:]], axis=-1)[part]
    used, numbers = np.unique(pairs, return_inverse=True)
    return Split(together[used], numbers.reshape(-1, 2), line[1:][part], bridged)


def near_pairs(ends: Array, weld: float) -> list[tuple[Integers, Integers]]:
    """Pairs of lines (S, 2, 2) whose boxes are near each other, the smaller number first.

    Raises InputError: If there are too many.
    """
    import shapely

    low, high = ends.min(axis=1) - weld, ends.max(axis=1) + weld
    boxes = shapely.box(*low.T, *high.T)
    tree = shapely.STRtree(boxes)
    total, most = 0, most_pairs(len(ends))
    block = max(min(BLOCK, most // max(len(ends), 1)), 1)
    found = []
    for begin in range(0, len(ends), block):
        one, two = tree.query(boxes[begin : begin + block])
        first = one + begin < two
        found.append((one[first] + begin, two[first]))
        total += int(first.sum())
        if total > most:  # before any are compared, which takes longer
            raise InputError(
                "too many lines lie across each other",
                got=f"{len(ends)} lines",
                expected=f"at most {most} pairs of lines whose boxes meet",
                remedy="draw every crease once, and remove what is none",
            )
    return found


def cross(a: Array, b: Array) -> Array:
    """Cross products (N,) of vectors (N, 2)."""
    return np.asarray(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0])

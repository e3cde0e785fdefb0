"""Where lines across a panel cross, and the parts of a panel between lines.

Panels are rigid, so that a crossing is the same share of each line in all states.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence
from itertools import combinations, pairwise

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Integers

Side = tuple[int, int]
"""Two vertices, the lower number first."""
Lines = Sequence[tuple[int, Side]]
"""Lines across panels: the panel of each, and its ends."""
INSIDE = 1e-9
"""A crossing is farther from the ends of both lines than this share of them."""


@record
class Crossings:
    """Where lines cross, as vertices behind all others."""

    ends: Integers  # the ends (X, 2) of a line that each is on
    shares: Array  # how far it is (X,) from the first to the second
    # of lines that cross others, by their number: what is crossed, and at which vertex, in order
    on: Mapping[int, tuple[tuple[int, int], ...]]

    @classmethod
    def of(cls, lines: Lines, flat: Array) -> Crossings:
        """Those of lines in the flat sheet.

        flat: All vertices (N, 2).
        """
        by_panel: dict[int, list[int]] = defaultdict(list)
        for number, (panel, _) in enumerate(lines):
            by_panel[panel].append(number)
        ends: list[Side] = []
        shares: list[float] = []
        on: dict[int, list[tuple[float, int, int]]] = defaultdict(list)
        for mine in by_panel.values():
            for one, other in combinations(mine, 2):
                first, second = (flat[list(lines[k][1])] for k in (one, other))
                found = _shares(first, second)
                if found is None:
                    continue
                vertex = len(flat) + len(ends)
                ends.append(lines[one][1])
                shares.append(found[0])
                on[one].append((found[0], other, vertex))
                on[other].append((found[1], one, vertex))
        return cls(
            np.array(ends, np.int64).reshape(-1, 2),
            np.array(shares),
            {k: tuple((line, at) for _, line, at in sorted(each)) for k, each in on.items()},
        )

    def places(self, points: Array) -> Array:
        """Where they are (X, ...), by the places (N, ...) of all other vertices."""
        first, second = points[self.ends[:, 0]], points[self.ends[:, 1]]
        return np.asarray(first + self.shares[:, None] * (second - first))

    def along(self, line: int) -> list[int]:
        """The vertices at which a line crosses others, from its first end on."""
        return [vertex for _, vertex in self.on.get(line, ())]

    def chains(self, line: int, ends: Side) -> list[list[int]]:
        """A line from end to end, in parts between those that it crosses and that are before it."""
        found = [[ends[0]]]
        for other, vertex in self.on.get(line, ()):
            found[-1].append(vertex)
            if other < line:
                found.append([vertex])
        found[-1].append(ends[1])
        return found


def _shares(first: Array, second: Array) -> tuple[float, float] | None:
    """How far along two lines (2, 2) they cross; None if they do not."""
    run, other = first[1] - first[0], second[1] - second[0]
    area = run[0] * other[1] - run[1] * other[0]
    if abs(area) <= INSIDE * np.linalg.norm(run) * np.linalg.norm(other):
        return None
    away = second[0] - first[0]
    s = float((away[0] * other[1] - away[1] * other[0]) / area)
    t = float((away[0] * run[1] - away[1] * run[0]) / area)
    inside = INSIDE < s < 1 - INSIDE and INSIDE < t < 1 - INSIDE
    return (s, t) if inside else None


def parted(loop: list[int], cuts: Sequence[list[int]]) -> list[list[int]]:
    """The parts of a panel between lines, each from a vertex around a part to another one."""
    pieces = [loop]
    for one, *within, other in cuts:
        mine = next((each for each in pieces if one in each and other in each), None)
        if mine is None or (not within and side_of(one, other) in sides_of(mine)):
            continue
        begin, end = mine.index(one), mine.index(other)
        there, back = within, within[::-1]
        if begin > end:
            begin, end, there, back = end, begin, back, there
        parts = mine[begin : end + 1] + back, mine[end:] + mine[: begin + 1] + there
        at = pieces.index(mine)
        pieces[at : at + 1] = parts
    return pieces


def sides_of(loop: list[int]) -> list[Side]:
    """The sides of what a loop of vertices goes around."""
    return [side_of(*each) for each in pairwise([*loop, loop[0]])]


def side_of(one: int, other: int) -> Side:
    """The side between two vertices."""
    return (one, other) if one < other else (other, one)

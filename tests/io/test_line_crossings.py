"""Lines across a panel that cross: the vertices there, and the parts of the panel."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from orishell.io.line_crossings import Crossings, parted, side_of, sides_of

SQUARE = np.array([[0, 0], [0, 1], [1, 1], [1, 0]], np.float64)


def area(loop: list[int], points: np.ndarray) -> float:
    x, y = points[loop].T
    return 0.5 * abs(float(x @ np.roll(y, -1) - y @ np.roll(x, -1)))


@pytest.mark.parametrize(
    ("right", "crossings"),
    [
        ([0.2, 0.5, 0.8], 0),
        ([0.6, 0.3, 0.8], 1),  # the first crosses the second
        ([0.8, 0.2, 0.5], 2),  # the first crosses both others
        ([0.9, 0.55, 0.1], 3),  # each crosses each
    ],
)
def test_a_panel_is_parted_along_lines_that_cross(right: list[float], crossings: int) -> None:
    """Into one part more than there are lines and crossings; all areas add up to the panel's."""
    left = [0.2, 0.5, 0.8]
    sides = [[[0, a], [1, b]] for a, b in zip(left, right, strict=True)]
    flat = np.concatenate([SQUARE, np.array(sides, np.float64).reshape(-1, 2)])
    order = [0, 4, 6, 8, 1, 2, *(5 + 2 * k for k in np.argsort(right)[::-1]), 3]
    lines = [(0, (4 + 2 * k, 5 + 2 * k)) for k in range(3)]
    found = Crossings.of(lines, flat)
    assert len(found.ends) == crossings
    points = np.concatenate([flat, found.places(flat)])
    cuts = [chain for k, (_, ends) in enumerate(lines) for chain in found.chains(k, ends)]
    pieces = parted(order, cuts)
    assert len(pieces) == 1 + len(lines) + crossings
    assert sum(area(each, points) for each in pieces) == pytest.approx(1.0, rel=1e-12)
    assert min(area(each, points) for each in pieces) > 1e-4
    # All of every line is between two parts.
    shared = [each for piece in pieces for each in sides_of(piece)]
    for k, (_, (one, other)) in enumerate(lines):
        for pair in pairwise([one, *found.along(k), other]):
            assert shared.count(side_of(*pair)) == 2
    # Crossings are on both of their lines.
    for k, (_, (one, other)) in enumerate(lines):
        run = flat[other] - flat[one]
        for vertex in found.along(k):
            away = points[vertex] - flat[one]
            assert abs(run[0] * away[1] - run[1] * away[0]) < 1e-12

"""Strips of end walls against shapely: what they cover, and that each is a board."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
import pytest
import shapely

from orishell.design.end_walls import Door
from orishell.numerics.arrays import Array
from orishell.solids.end_walls import Strips, room_for_door, strips_below
from samples import THOROUGH

NUMBERS = range(300 if THOROUGH else 60)
NEAR = 1e-9
"""Areas differ by less than this share: shapely's rounding is a millionth of it."""


def random_border(number: int) -> Array:
    """An arch of random folds over the ground: every third overhangs, some have no feet."""
    draw = np.random.default_rng(number)
    count = int(draw.integers(3, 16))
    turn = np.linspace(np.pi, 0.0, count)
    fold = draw.uniform(0.0, 0.3) * np.resize([1.0, -1.0], count)
    wide = draw.uniform(0.6, 2.5)
    line = np.stack([wide * (1 + fold) * np.cos(turn), (1 + fold) * np.sin(turn)], axis=1)
    if number % 3 == 0:
        line[:, 1] += 0.6 * draw.uniform() * (np.sin(turn) > 0.3)
    if number % 2:
        line += draw.normal(0, 0.02, line.shape)
    line[:, 1] -= line[:, 1].min() - [0.0, 0.4][number % 5 == 4]
    return line if number % 7 else line[::-1]


def below(border: Array) -> Any:
    """What lies between a border and the ground, edge by edge."""
    quads = []
    for (left, low), (right, high) in pairwise(border):
        quad = shapely.Polygon([(left, 0), (right, 0), (right, high), (left, low)])
        quads.append(shapely.make_valid(quad))
    return shapely.union_all(quads)


def covered(strips: Strips) -> Any:
    return shapely.union_all(shapely.polygons(strips.corners))


def random_door(number: int, border: Array) -> Door:
    draw = np.random.default_rng([number, 1])
    wide, high = float(np.ptp(border[:, 0])), float(border[:, 1].max())
    offset = float(draw.uniform(-0.2, 0.2)) * wide
    return Door(width=0.3 * wide, height=float(draw.uniform(0.1, 0.6)) * high, offset=offset)


@pytest.mark.parametrize("number", NUMBERS)
def test_strips_cover_all_below_the_border_and_no_more_beside_it(number: int) -> None:
    border = random_border(number)
    strips = strips_below(border)
    found, asked = covered(strips), below(border)
    assert asked.difference(found).area < NEAR * asked.area
    low, high = border.min(axis=0), border.max(axis=0)
    assert found.bounds == pytest.approx([low[0], 0.0, high[0], found.bounds[3]], abs=NEAR)
    # What is added closes overhangs and joins slivers: the hull has both.
    hull = shapely.union(shapely.convex_hull(asked), asked)
    assert found.bounds[3] <= high[1] * 1.5
    assert found.difference(hull).area < 0.1 * asked.area


@pytest.mark.parametrize("number", NUMBERS)
def test_strips_are_convex_apart_and_as_large_as_they_say(number: int) -> None:
    border = random_border(number)
    door = random_door(number, border)
    within = room_for_door(border, door) > door.height
    strips = strips_below(border, door if within else None)
    own = shapely.polygons(strips.corners)
    assert shapely.is_ccw(shapely.get_exterior_ring(own)).all()
    np.testing.assert_allclose(shapely.area(shapely.convex_hull(own)), strips.areas(), rtol=1e-9)
    total = float(strips.areas().sum())
    assert covered(strips).area == pytest.approx(total, rel=NEAR)


@pytest.mark.parametrize("number", NUMBERS)
def test_a_door_is_left_open_and_all_else_is_closed(number: int) -> None:
    border = random_border(number)
    door = random_door(number, border)
    room = room_for_door(border, door)
    middle = 0.5 * (border[:, 0].min() + border[:, 0].max()) + door.offset
    first, last = middle - 0.5 * door.width, middle + 0.5 * door.width
    # Nowhere over the door is less of the wall than there is room.
    folds = border[(border[:, 0] > first) & (border[:, 0] < last), 0]
    stations = np.concatenate([np.linspace(first, last, 101), folds])
    lines = [shapely.LineString([(x, 0.0), (x, 99.0)]) for x in stations]
    heights = [line.intersection(below(border)).bounds[3] for line in lines]
    assert room >= min(heights) - NEAR
    if room <= door.height:
        return
    opening = shapely.box(first, 0.0, last, door.height)
    found = covered(strips_below(border, door))
    assert found.intersection(opening).area < NEAR
    missing = below(border).difference(found).difference(opening)
    assert missing.area < NEAR


@pytest.mark.parametrize("number", NUMBERS)
def test_strips_fit_what_they_are_cut_from_and_cover_the_same(number: int) -> None:
    border = random_border(number)
    draw = np.random.default_rng([number, 2])
    long = float(draw.uniform(0.2, 0.8)) * float(border[:, 1].max())
    largest = long, long * float(draw.uniform(0.2, 1.0))
    whole, cut = strips_below(border), strips_below(border, None, largest)
    sizes = np.sort(np.ptp(cut.corners, axis=1), axis=1)
    assert (sizes <= np.sort(largest) * (1 + NEAR)).all()
    assert len(cut) >= len(whole)
    both = covered(cut).symmetric_difference(covered(whole))
    assert both.area < NEAR * float(whole.areas().sum())
    assert cut.areas().sum() == pytest.approx(whole.areas().sum(), rel=NEAR)


def test_a_door_beside_the_wall_has_no_room() -> None:
    border = random_border(1)
    edge = float(border[:, 0].max() - border[:, 0].min()) / 2
    assert room_for_door(border, Door(width=0.4, height=0.1, offset=edge)) == 0.0
    assert room_for_door(border, Door(width=3 * edge, height=0.1)) == 0.0

"""Panels with a reflex corner: nothing is proved that meets, and what is not known says so."""

from __future__ import annotations

from collections import Counter
from typing import Any

import numpy as np
import pytest

from concave_sheets import panels_through, random_sheet
from orishell.clash import find_first_contact
from orishell.conventions.errors import DesignError
from orishell.motion import diagonal
from orishell.motion.convex import ConvexParts, require_convex
from orishell.motion.grid import Grid
from orishell.motion.layout import Layout
from orishell.motion.quads import signed_areas
from samples import THOROUGH, thorough

Array = np.ndarray
STATES = 60 if THOROUGH else 20
END = np.pi * 0.99
"""Creases close at pi, where panels lie on each other."""


def look(seed: int) -> Counter[str]:
    """A random sheet, proved; the tests' own intersection in states of what is proved clear."""
    sheet, concave = random_sheet(seed)
    flat = sheet.positions(0.0).reshape(-1, 3)
    faces = Layout.of(sheet).faces
    found = find_first_contact(sheet.least_turning, END, 1e-9 * diagonal(sheet.positions(0.0)))
    met = found.contact
    clear = END if met is None else met.clear_until
    drives = np.linspace(0.0, clear, STATES + 1)[1:]
    for drive, points in zip(drives, sheet.least_turning.positions(drives), strict=True):
        pairs = panels_through(points.reshape(-1, 3), flat, faces)
        assert not len(pairs), f"proved at {np.rad2deg(drive)} degrees, and meet: {pairs}"
    told = Counter({"sheets": 1, "concave": concave > 0, "meet": met is not None})
    if met is not None:
        # They do meet: within the tolerance there, which a contact at a vertex keeps for long.
        assert met.apart is None
        shared = np.isin(faces[met.panels[0]], faces[met.panels[1]]).sum()
        assert shared < 2
        told["at a vertex"] += int(shared == 1)
    return told


def test_nothing_is_proved_that_meets() -> None:
    """Three of these sheets meet beside a common vertex, where opposite panels leave sectors."""
    told = sum((look(seed) for seed in (0, 1, 3, 5, 9, 14)), Counter[str]())
    assert told["concave"] == 5
    assert told["at a vertex"] == 3


@thorough
@pytest.mark.parametrize("part", range(8))
def test_nothing_is_proved_that_meets_in_two_hundred_sheets(part: int) -> None:
    told = sum((look(seed) for seed in range(25 * part, 25 * part + 25)), Counter[str]())
    assert told["sheets"] == 25
    assert told["concave"] > 15
    assert told["at a vertex"] > 0


def reflex_sheet() -> tuple[Array, Array]:
    """Two by two panels of unit squares, the first of which has its first corner pulled in."""
    grid = Grid(3, 3)
    flat = np.stack([*np.indices((3, 3))[::-1], np.zeros((3, 3))], axis=-1).astype(float)
    flat[..., 1] *= -1
    return flat.reshape(-1, 3), grid.faces_vertices()


class Lying:
    """A sheet that lies flat, of two by two panels, with one vertex elsewhere."""

    grid, flap_columns, target_drive = Grid(3, 3), (), 1.0

    def __init__(self, vertex: int, place: tuple[float, float]) -> None:
        self.flat = reflex_sheet()[0]
        self.flat[vertex, :2] = place

    def positions(self, drive: object) -> Array:
        return self.flat.reshape(3, 3, 3)


def lying(*arguments: Any) -> Any:
    """A mechanism of which these tests need the flat sheet only."""
    return Lying(*arguments)


def test_concave_panels_are_parted_and_their_halves_make_them_up() -> None:
    sheet = lying(1, (0.7, -0.8))
    parts = ConvexParts.of(sheet)
    # Corner 1 of the first panel's loop is vertex 3; that of the border vertex 1 is the last.
    assert parts.concave.tolist() == [0]
    whole = signed_areas(sheet.flat[Layout.of(sheet).faces][..., :2])
    halves = np.zeros(4)
    np.add.at(halves, parts.panels, signed_areas(sheet.flat[parts.faces][..., :2]))
    np.testing.assert_allclose(halves, whole, atol=1e-15)
    assert (signed_areas(sheet.flat[parts.faces][..., :2]) > 0).all()
    # The half away from the middle vertex is compared with the panel opposite; the other is not.
    pairs = np.array([0, 4]), np.array([3, 3])
    away = [4 not in parts.faces[number] for number in (0, 4)]
    assert parts.compared(*pairs).tolist() == away
    assert sorted(away) == [False, True]
    assert not parts.compared(np.array([0, 0, 4, 4, 0]), np.array([1, 2, 1, 2, 4])).any()


def test_straight_corners_are_convex_and_boards_name_concave_ones() -> None:
    assert not len(ConvexParts.of(lying(1, (1.0, 0.0))).concave)
    almost = lying(1, (1.0, -1e-14))
    assert not len(ConvexParts.of(almost).concave)
    with pytest.raises(DesignError, match="need a sheet of convex panels") as refused:
        require_convex(lying(1, (0.7, -0.8)))
    assert refused.value.place == "panel [0, 0] is concave"
    # By hand: vertex 1 between (0, 0) and (1, -1), seen from (0.7, -0.8).
    angle = 360 - np.rad2deg(np.arctan2(0.8, -0.7) - np.arctan2(-0.2, 0.3))
    assert f"vertex 0, 1 has {angle:.4g} degrees" in refused.value.size


def test_panels_that_lie_on_each_other_about_a_reflex_corner_are_refused() -> None:
    """By hand: 195 degrees of the first, and 174 of the next."""
    sheet = lying(1, (0.7, -0.8))
    sheet.flat[2, :2] = (-0.07, -0.16)
    with pytest.raises(DesignError, match="lie on each other"):
        ConvexParts.of(sheet)

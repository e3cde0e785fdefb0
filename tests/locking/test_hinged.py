"""Contact of whole boards and arms: what is proved clear, and what meets, against manifold3d."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from flat_foldables import boarded, random_sheet
from mechanisms import flat_foldable, miura_net, parallel
from orishell.clash import find_first_contact
from orishell.clash.bodies import Bodies
from orishell.clash.hinged_pairs import near_bodies
from orishell.clash.hinged_path import find_first_hinged_contact
from orishell.design import Design, HingeSpec, PanelSpec
from orishell.locking import find_lock
from orishell.motion import Mechanism, diagonal, find_assignment
from orishell.motion.as_made import panels_laid_flat
from orishell.motion.boards import ARM, KNUCKLE, Boards
from orishell.motion.hinges import Hinges
from orishell.solids import build_panels
from overlaps import NOTHING, overlap
from samples import THOROUGH, led_by

STATES = 40 if THOROUGH else 16
QUICK = (16, 2, 17, 15)
"""One of each kind of sheet: boards of the first meet, those of the others fold to the end."""
TOLERANCE = 1e-9


def design_of(mechanism: Mechanism, thickness: float, gap: float, knuckle: float = 0.0) -> Design:
    hinge = HingeSpec(knuckle=knuckle)
    build = PanelSpec(thickness=thickness, construction="hinged", gap=gap, hinge=hinge)
    return boarded(mechanism, build)


def small_sheet(seed: int) -> Mechanism:
    """A sheet of up to 36 panels by its number."""
    while (sheet := random_sheet(seed)).grid.panel_count > 36:
        seed += 1000
    return sheet


def quick_first(count: int) -> list[Any]:
    """So many sheets, of which a quick one of each kind runs always."""
    return led_by([*QUICK, *(seed for seed in range(count) if seed not in QUICK)], len(QUICK))


def shortest(mechanism: Mechanism) -> float:
    flat = mechanism.positions(0.0)
    return min(float(np.linalg.norm(np.diff(flat, axis=axis), axis=-1).min()) for axis in (0, 1))


@pytest.mark.parametrize("seed", quick_first(36))
def test_what_is_proved_is_what_solids_do(seed: int) -> None:
    sheet = small_sheet(seed)
    share = (0.004, 0.01, 0.03)[seed % 3]
    thickness = share * shortest(sheet)
    gap = 0.0 if seed % 2 else 0.1 * thickness
    lock = find_lock(design_of(sheet, thickness, gap))
    assert lock.built is not None
    boards = lock.built.boards
    for drive in np.linspace(0.0, lock.closes_to, STATES):
        assert overlap(sheet, boards, drive) < NOTHING, drive
    contact = lock.first_contact
    if contact is not None and contact.kind == "boards":
        beyond = contact.drive + np.geomspace(1e-4, 0.05, 8) * sheet.end_drive
        beyond = beyond[beyond < sheet.end_drive]
        assert max(overlap(sheet, boards, drive) for drive in beyond) > NOTHING


def rounded(boards: Boards) -> Boards:
    """The boards with cylinders, of eight chords to half a turn, in place of boxes of knuckles."""
    low, high = (boards.outlines[:, end] for end in (0, -1))
    share = 0.5 - 0.5 * np.cos(np.linspace(0.0, np.pi, 9))[:, None, None]
    outlines = (1 - share) * low[:, None] + share * high[:, None]
    knuckles = boards.sides == KNUCKLE
    across = outlines[knuckles]
    middle = 0.5 * (across[:, :, :4] + across[:, :, [3, 2, 1, 0]])
    narrow = 2 * np.sqrt(share * (1 - share))
    shape = [0, 1, 2, 3, *[3] * (outlines.shape[2] - 4)]
    outlines[knuckles] = (middle + narrow * (across[:, :, :4] - middle))[:, :, shape]
    return replace(boards, outlines=outlines)


@pytest.mark.parametrize("seed", quick_first(24))
def test_knuckles_turn_between_their_boards_and_meet_nothing(seed: int) -> None:
    """Cylinders about the axes: their own boards and arms are at their radius all the way."""
    sheet = small_sheet(seed)
    thickness = (0.004, 0.01, 0.02)[seed % 3] * shortest(sheet)
    knuckle = (0.2, 0.5)[seed % 2] * thickness
    lock = find_lock(design_of(sheet, thickness, 0.1 * thickness, knuckle))
    assert lock.built is not None
    boards = lock.built.boards
    folding = find_assignment(sheet)
    hinges = int((folding.row != 0).sum() + (folding.column != 0).sum())
    assert int((boards.sides == KNUCKLE).sum()) == hinges
    for drive in np.linspace(0.0, lock.closes_to, 24 if THOROUGH else 10):
        assert overlap(sheet, rounded(boards), drive) < NOTHING, drive


def test_a_knuckle_is_settled_with_what_turns_about_it_alone() -> None:
    """Its other board and the arm there, not other arms of that board."""
    sheet = flat_foldable(miura_net(3, 3))
    built = build_panels(design_of(sheet, 0.01, 0.001, 0.004), sheet.end_drive)
    bodies = Bodies(built.boards, sheet.grid.faces_vertices(), panels_laid_flat(sheet))
    assert isinstance(bodies.hinges, Hinges)
    sides, edges, panels = built.boards.sides, built.boards.edges, built.boards.panels
    assert edges is not None
    pairs = near_bodies(bodies, bodies.hinges).bodies
    near = set(zip(*(each.tolist() for each in pairs), strict=True))
    below = sheet.grid.columns - 1
    looked = 0
    for knuckle in np.flatnonzero((sides == KNUCKLE) & (edges == 1)).tolist():
        own = int(panels[knuckle])
        for other in np.flatnonzero(panels == own + below).tolist():
            turns = edges[other] < 0 or (sides[other] == ARM and edges[other] == 3)
            assert ((knuckle, other) in near) == (not turns)
            looked += not turns
    assert looked


def test_an_arm_that_meets_a_board_is_named_and_overlaps_just_beyond() -> None:
    """Arms of 0.52 are longer than the shortest edges, 0.19, of this sheet."""
    sheet = parallel(13, 15, plane="bisector", flap=0.0)
    lock = find_lock(design_of(sheet, 0.04, 0.004))
    contact = lock.first_contact
    assert lock.cause == "boards"
    assert contact is not None
    assert lock.early
    assert any(name.startswith("the ") and " arm of panel" in name for name in contact.names)
    assert lock.built is not None
    boards = lock.built.boards
    assert overlap(sheet, boards, contact.clear_until) < NOTHING
    beyond = contact.drive + np.geomspace(1e-4, 0.05, 8) * sheet.end_drive
    assert max(overlap(sheet, boards, drive) for drive in beyond) > NOTHING


def test_a_board_and_its_neighbours_are_settled_but_for_arms_that_reach_beyond() -> None:
    """Of a pair beside a hinge only those are searched that reach beyond it."""
    sheet = flat_foldable(miura_net(3, 3))
    built = build_panels(design_of(sheet, 0.01, 0.001), sheet.end_drive)
    bodies = Bodies(built.boards, sheet.grid.faces_vertices(), panels_laid_flat(sheet))
    assert isinstance(bodies.hinges, Hinges)
    near = near_bodies(bodies, bodies.hinges)
    first, second = (bodies.panels[each] for each in near.bodies)
    across = sheet.grid.columns - 1
    beside = np.abs(first - second) == across
    beside |= (np.abs(first - second) == 1) & (first // across == second // across)
    arms = built.boards.arms
    assert beside.any()
    assert (arms[near.bodies[0]] | arms[near.bodies[1]])[beside].all()
    # Opposite each other all boards are looked at: two pairs about every vertex.
    boards = ~arms[near.bodies[0]] & ~arms[near.bodies[1]]
    assert boards.sum() == 2 * (sheet.grid.rows - 2) * (sheet.grid.columns - 2)


@pytest.mark.parametrize("size", led_by([6, 8, 12, 30]))
def test_the_proof_takes_few_more_looks_than_that_of_panels(size: int) -> None:
    """Pairs looked at, which no other work on the machine changes: 1.6 times as many at 30 x 30,
    in 2.6 times as long.
    """
    sheet = flat_foldable(miura_net(size, size))
    tolerance, end = TOLERANCE * diagonal(sheet.positions(0.0)), sheet.end_drive * (1 - 1e-6)
    built = build_panels(design_of(sheet, 0.004, 4e-4), end)
    bodies = Bodies(built.boards, sheet.grid.faces_vertices(), panels_laid_flat(sheet))
    found = find_first_hinged_contact(sheet.least_turning, end, tolerance, bodies)
    panels = find_first_contact(sheet.least_turning, end, tolerance)
    assert found.contact is None
    assert panels.contact is None
    assert found.proof.tests < 4 * panels.proof.tests

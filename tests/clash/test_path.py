"""First contact along the path, against brute force over all pairs in exact arithmetic."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings

from brute_force import crosses, exact_contacts, first_crossing, not_designed
from orishell.clash import find_contacts, find_first_contact
from orishell.clash.acceleration_bounds import EdgeBounds
from orishell.clash.broad_phase import PanelTree
from orishell.clash.ranges import BASE
from orishell.conventions.errors import DesignError
from orishell.families.flat_foldable.pattern import FlatFoldablePattern, design_flat_foldable
from orishell.locking import find_lock
from orishell.motion import diagonal
from planted import PLANTED, clear
from samples import examples, led_by, thorough
from strategies import Request, orthodiagonal_requests, requests

STEPS = 200
"""Steps of the brute force along a path."""
SHORT = 1 - 1e-4
"""Brute force looks at the path this far: at lock flaps touch by design."""


@pytest.mark.parametrize("name", led_by(PLANTED, 2))
def test_a_planted_clash_is_found_where_brute_force_finds_it(name: str) -> None:
    design = PLANTED[name]()
    lock = find_lock(design)
    assert lock.cause == "clash"
    assert lock.first_contact is not None
    assert lock.path is not None
    expected = first_crossing(design.mechanism, np.pi * SHORT, STEPS)
    assert expected is not None
    # They differ by the time that panels take through the tolerance, 1e-9 of the diagonal.
    assert abs(lock.first_contact.drive - expected) < 1e-6 * np.pi
    # The panels named are among those that cross just after.
    faces = design.mechanism.grid.faces_vertices()
    pairs = exact_contacts(design.mechanism.positions(expected + 1e-9), faces)
    columns = design.mechanism.grid.columns - 1
    named = sorted(i * columns + j for i, j in lock.first_contact.panels)
    assert named in np.sort(pairs, axis=1).tolist()
    # It is bracketed to a part of the path that no one can measure.
    assert 0 <= lock.first_contact.drive - lock.first_contact.clear_until < 1e-9


def test_a_sheet_that_meets_nothing_is_proved_clear() -> None:
    lock = find_lock(clear())
    assert (lock.cause, lock.touching_at_end) == ("flaps", ())
    assert first_crossing(clear().mechanism, np.pi * SHORT, 100) is None


@settings(max_examples=examples(40), deadline=None)
@given(requests())
def test_parallel_repeating_against_brute_force(request: Request) -> None:
    compare(request)


@settings(max_examples=examples(40), deadline=None)
@given(orthodiagonal_requests())
def test_orthodiagonal_against_brute_force(request: Request) -> None:
    compare(request)


def compare(request: Request | Request, steps: int = 60) -> None:
    """Whatever brute force sees is found, and whatever is found can be seen."""
    try:
        design = request.design()
    except DesignError:
        return
    mechanism = design.mechanism
    lock = find_lock(design)
    counts = not_designed(mechanism.grid)
    if lock.cause != "clash":
        for drive in np.linspace(0, np.pi * SHORT, steps):
            assert not crosses(mechanism, float(drive), counts), f"missed at {drive}"
        return
    contact = lock.first_contact
    assert contact is not None
    for drive in np.linspace(0, contact.drive * (1 - 1e-6), steps):
        assert not crosses(mechanism, float(drive), counts), f"seen late: before {contact.drive}"
    # At the contact panels are within the tolerance, and they were not a little earlier.
    tolerance = 1e-9 * diagonal(mechanism.positions(0.0))
    columns = mechanism.grid.columns - 1
    named = sorted(i * columns + j for i, j in contact.panels)
    faces = mechanism.grid.faces_vertices()
    # The smallest step of the path is still a distance: a few times the tolerance.
    at = find_contacts(mechanism.positions(contact.drive).reshape(-1, 3), faces, 5 * tolerance)
    assert named in at.tolist()


def test_the_share_done_only_grows_and_ends_at_one() -> None:
    shares: list[float] = []
    mechanism = clear().mechanism
    find_first_contact(mechanism, 3.0, 1e-9, progress=lambda share, _: shares.append(share))
    assert shares == sorted(shares)
    assert shares[-1] == 1.0
    assert len(shares) >= BASE


def test_only_pairs_with_a_chosen_panel_are_looked_at() -> None:
    design = PLANTED["waist"]()
    grid = design.mechanism.grid
    chosen = np.zeros((grid.rows - 1, grid.columns - 1), np.bool_)
    chosen[:, :2] = True
    found = find_first_contact(design.mechanism, 3.0, 1e-9, only=chosen.ravel())
    assert found.contact is None
    chosen[:, 13] = True
    found = find_first_contact(design.mechanism, 3.0, 1e-9, only=chosen.ravel())
    assert found.contact is not None
    assert any(number % (grid.columns - 1) == 13 for number in found.contact.panels)


def test_panels_stay_within_the_bound_of_the_straight_line() -> None:
    # The certificate's premise, on vectors between any two vertices of a spiral.
    mechanism = PLANTED["spiral"]().mechanism
    grid = mechanism.grid
    tree = PanelTree.over(
        grid.faces_vertices(),
        np.indices((grid.rows - 1, grid.columns - 1)).reshape(2, -1).T.astype(float),
    )
    bounds = EdgeBounds(mechanism, (0.0, np.pi), tree)
    rng = np.random.default_rng(0)
    tightest = 0.0
    for start, stop in (
        (0.0, 0.125),
        (0.3125, 0.328125),
        (0.5, 0.75),
        (0.875, 1.0),
        (0.9921875, 1.0),
    ):
        bound = bounds.within(start, stop)
        at = np.linspace(start, stop, 21)
        points = mechanism.positions(at * np.pi)
        i, j, k, m = (rng.integers(0, size, 500) for size in (grid.rows, grid.columns) * 2)
        vector = points[:, i, j] - points[:, k, m]
        share = ((at - start) / (stop - start))[:, None, None]
        line = (1 - share) * vector[0] + share * vector[-1]
        chord_error = np.linalg.norm(vector - line, axis=-1).max(axis=0)
        allowed = (
            ((stop - start) * np.pi) ** 2
            / 8
            * (
                bound.down.between(np.minimum(i, k), np.maximum(i, k))
                + bound.along.between(np.minimum(j, m), np.maximum(j, m))
            )
        )
        assert (chord_error <= allowed + 1e-12).all()
        tightest = max(tightest, float((chord_error[allowed > 0] / allowed[allowed > 0]).max()))
    assert tightest > 0.5  # it is a bound, but no wasteful one


@pytest.mark.slow
def test_a_finer_base_finds_the_same_contact(monkeypatch: pytest.MonkeyPatch) -> None:
    design = PLANTED["wide flaps"]()
    coarse = find_lock(design).drive
    monkeypatch.setattr("orishell.clash.ranges.BASE", 128)
    assert find_lock(design).drive == pytest.approx(coarse, abs=1e-9)


def test_a_crowd_that_is_apart_is_looked_at(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where few pairs are called a crowd, a stack takes as many ranges as otherwise, 87 here."""
    sheet = design_flat_foldable(FlatFoldablePattern(rows=8, columns=8)).mechanism
    usual = find_first_contact(sheet, np.pi, 1e-6).proof.ranges
    monkeypatch.setattr("orishell.clash.path.CROWD", 4)
    assert find_first_contact(sheet, np.pi, 1e-6).proof.ranges < 2 * usual


@pytest.mark.slow
@thorough
def test_a_stack_asks_for_no_more_ranges_where_the_sheet_is_larger() -> None:
    """The panels of a Miura-ori lie on each other at the end, so that most are near many.

    14 x 14, 40 x 40 and 98 x 98 inner vertices took 83, 103 and 137 ranges; looked at only where
    ranges were as short as they may be, 40 x 40 took thousands.
    """
    ranges = [
        find_first_contact(
            design_flat_foldable(FlatFoldablePattern(rows=count, columns=count)).mechanism,
            np.pi,
            1e-6,
        ).proof.ranges
        for count in (14, 40)
    ]
    assert ranges[1] < 2 * ranges[0]

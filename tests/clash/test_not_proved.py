"""Where the proof ends without a contact: it says so, by all doors; bounds swallow no others."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from brute_force import distance_of_panels
from orishell.clash import find_first_contact
from orishell.clash.acceleration_bounds import Running
from orishell.clash.ranges import TICKS, Outcome, search_ranges
from orishell.conventions.errors import ClashError
from orishell.conventions.progress import no_progress
from orishell.design import Design
from orishell.families.parallel_repeating import ParallelRepeatingPattern, design_parallel_repeating
from orishell.locking import end_motion, find_lock
from orishell.motion import diagonal
from orishell.motion.layout import Layout, points_of
from strategies import graph

Array = np.ndarray
LOST = 1.0
"""At this drive no acceleration is bounded."""


class Unbounded:
    """A sheet that is as it was, but for a drive at which nobody knows a bound."""

    def __init__(self, sheet: Any, value: float = np.inf) -> None:
        self.sheet, self.value = sheet, value

    def __getattr__(self, name: str) -> Any:
        return getattr(self.sheet, name)

    @property
    def least_turning(self) -> Unbounded:
        return Unbounded(self.sheet.least_turning, self.value)

    def edge_accelerations(self, start: Array, stop: Array) -> tuple[Array, Array]:
        along, down = (each.copy() for each in self.sheet.edge_accelerations(start, stop))
        there = (start <= LOST) & (stop >= LOST)
        along[there], down[there] = self.value, self.value
        return along, down


def small() -> Design:
    """A few panels, free of contact."""
    f, g = graph("-x**2", -1, 1), graph("0.1*cos(pi*x/2)", 0, 4)
    return design_parallel_repeating(
        f, g, ParallelRepeatingPattern(rows=3, columns=3, xi_deg=50, flap=0.2)
    )


@pytest.fixture(scope="module")
def unbounded() -> Design:
    design = small()
    return replace(design, mechanism=Unbounded(design.mechanism))


@pytest.mark.parametrize("value", [np.inf, np.nan])
def test_what_has_no_bound_is_not_proved_and_does_not_meet(value: float) -> None:
    sheet = small().mechanism
    size = 1e-9 * diagonal(sheet.positions(0.0))
    found = find_first_contact(Unbounded(sheet, value), 2.0, size).contact
    assert found is not None
    assert found.clear_until <= LOST <= found.drive
    assert found.drive - found.clear_until <= 2.0 / TICKS * (1 + 1e-3)
    assert found.apart is not None
    # The distance there, as minimisation over all points of the two finds it.
    points, faces = points_of(sheet, found.drive), Layout.of(sheet).faces
    expected = distance_of_panels(*(points[faces[number]] for number in found.panels))
    assert found.apart == pytest.approx(expected, abs=1e-6 * size * 1e9)
    assert found.apart > size


def test_a_contact_is_a_contact_in_the_smallest_step_too() -> None:
    """Two touch at the end of a range in which another pair stays open to the last."""
    end = TICKS // 8

    def examine(start: int, stop: int, left: int) -> Outcome[int]:
        inside = start < end <= stop
        return Outcome(left if inside else None, (5, 6), None, (1, 2) if inside else None)

    found, clear = search_ranges(examine, 0, no_progress)
    assert found is not None
    assert (found.tick, found.pair, found.touches, clear) == (end, (1, 2), True, end - 1)


def test_a_lock_says_not_proved(unbounded: Design) -> None:
    lock = find_lock(unbounded)
    assert (lock.cause, lock.early, lock.reaches_target) == ("unproved", True, None)
    assert lock.first_contact is not None
    assert lock.first_contact.apart is not None
    assert lock.closes_to == lock.first_contact.clear_until
    assert "is not proved beyond drive 57.29" in lock.warnings[0]
    assert "meet at" not in lock.warnings[0]


def test_a_design_is_refused_as_not_proved(unbounded: Design) -> None:
    with pytest.raises(ClashError) as refused:
        end_motion(unbounded)
    said = str(refused.value)
    assert said.startswith("it is not proved that the shell reaches its target without contact")
    assert "beyond drive 57.29" in said
    assert "apart there" in said
    assert "meet before" not in said
    assert refused.value.exit_status == 1


def test_a_small_bound_is_not_lost_beside_a_large_one() -> None:
    """In running sums of doubles 1e20 swallows 1, and infinite less infinite is no number."""
    for large in (1e20, np.inf):
        sums = Running.of(np.array([2.0, large, 1.0, 3.0]))
        begin, end = np.array([2, 2, 0, 1, 3, 0]), np.array([3, 4, 1, 3, 3, 4])
        found = sums.between(begin, end)
        assert (found >= np.array([1, 4, 2, large, 0, large])).all()
        assert found[4] == 0

"""Random feasible designs: what the proof says, exact arithmetic says too.

Some of 200 in `make test`, all in `make thorough`.

libigl decides on all pairs of panels in exact arithmetic. Where the path is said to be clear it
must see nothing in any of the states tried; where panels are said to touch it must see them cross
within a millionth of the path, or they must be nearer than the tolerance that means touching.
"""

from __future__ import annotations

from collections import Counter
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as st

from brute_force import crosses, distance_of_panels, not_designed
from orishell.conventions.errors import DesignError
from orishell.design import Design
from orishell.families.longitudinal_linear_repeating import (
    LongitudinalPattern,
    design_longitudinal_linear_repeating,
)
from orishell.locking import Lock, find_lock
from orishell.motion import Mechanism
from samples import THOROUGH, examples, thorough
from strategies import (
    Request,
    graph,
    numbers,
    orthodiagonal_requests,
    pair,
    requests,
)

STATES = 25
once = settings(
    deadline=None,
    phases=[Phase.generate],
    suppress_health_check=[HealthCheck.filter_too_much, HealthCheck.too_slow],
)


def near(mechanism: Mechanism, lock: Lock) -> bool:
    """Whether the panels are as near as touching means, however slowly they approach."""
    assert lock.first_contact is not None
    assert lock.path is not None
    positions = mechanism.positions(lock.first_contact.drive)
    one, other = (
        positions[[i, i + 1, i + 1, i], [j, j, j + 1, j + 1]] for i, j in lock.first_contact.panels
    )
    return distance_of_panels(one, other) <= 1.01 * lock.path.contact_tolerance


def require_agreement(design: Design, seen: Counter[str | None]) -> None:
    mechanism, lock = design.mechanism, find_lock(design)
    seen[lock.cause] += 1
    counts = not_designed(mechanism.grid)
    clear = (
        lock.target_drive
        if lock.first_contact is None
        else min(lock.first_contact.drive, lock.target_drive)
    )
    for drive in np.linspace(0, (1 - 1e-4) * clear, STATES):
        assert not crosses(mechanism, float(drive), counts), f"missed at {drive}: {lock}"
    if lock.cause == "clash" and lock.drive is not None:
        end = mechanism.end_drive
        later = [min(lock.drive + end * share, end) for share in (1e-9, 1e-8, 1e-7, 1e-6)]
        anything = [crosses(mechanism, drive, lambda p: np.ones(len(p), bool)) for drive in later]
        assert any(anything) or near(mechanism, lock), f"a false alarm: {lock}"


@pytest.mark.slow
def test_parallel_repeating_designs() -> None:
    seen: Counter[str | None] = Counter()
    wanted = 150 if THOROUGH else 10

    @settings(once, max_examples=wanted)
    @given(requests())
    def every(request: Request) -> None:
        require_agreement(request.feasible(), seen)

    every()
    assert seen["flaps"] > 0.4 * wanted
    assert seen["clash"] > 0 or not THOROUGH  # one in some dozens


@thorough
@pytest.mark.slow
def test_orthodiagonal_designs() -> None:
    seen: Counter[str | None] = Counter()

    @settings(once, max_examples=examples(150))
    @given(orthodiagonal_requests())
    def every(request: Request) -> None:
        require_agreement(request.feasible(), seen)

    every()
    assert seen["flaps"] > 0.4 * examples(150)


@st.composite
def longitudinal_requests(draw: st.DrawFn) -> dict[str, Any]:
    """Arcs and parabolas along a line, sectors of the program's choice or near 90 degrees."""
    span = draw(numbers(0.3, 1.4))
    arc = pair("cos(t)", "sin(t)", 1.57 - span, 1.57 + span)
    near = draw(st.tuples(*[numbers(-4, 4) for _ in range(4)]))
    sectors = [90 + each for each in near]
    return {
        "f": draw(st.sampled_from([arc, graph("-x**2/2", -span, span)])),
        "g": graph("0*x", 0, draw(numbers(0.5, 4))),
        "rows": draw(st.integers(2, 9)),
        "columns": draw(st.integers(2, 9)),
        "first_row": draw(st.sampled_from(["F", "S"])),
        "sector_deg": draw(st.sampled_from(["auto", "auto", "auto", sectors])),
    }


@pytest.mark.slow
def test_longitudinal_designs() -> None:
    seen: Counter[str | None] = Counter()
    wanted = 100 if THOROUGH else 6

    @settings(once, max_examples=8 * wanted)
    @given(longitudinal_requests())
    def every(request: dict[str, Any]) -> None:
        if seen.total() == wanted:
            return
        try:
            design = design_longitudinal_linear_repeating(
                request.pop("f"), request.pop("g"), LongitudinalPattern(**request)
            )
        except DesignError:
            return
        require_agreement(design, seen)

    every()
    assert seen.total() == wanted

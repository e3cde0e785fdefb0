"""Flaps as wide as meet nothing, and refusals whose advice works."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from brute_force import crosses, not_designed
from orishell.curves import Curve
from orishell.design import Design
from orishell.errors import DesignError
from orishell.families.parallel_repeating import design_parallel_repeating
from orishell.locking import Request, find_lock, settle
from strategies import graph, pair


def request(f: Curve, g: Curve, flap: Any, **options: Any) -> Request:
    def design(f: Curve, g: Curve, flap: Any) -> Design:
        return design_parallel_repeating(f, g, flap=flap, **options)

    return Request(design, f, g, flap)


def bend(flap: Any) -> Request:
    """Flaps across an almost closed bend."""
    return request(
        graph("-x**2", -1, 1),
        pair("2.2*cos(t)", "2.2*sin(t)", 0, 5.5),
        flap,
        rows=9,
        columns=24,
        xi=np.deg2rad(50),
        flap_sides=("start", "start"),
    )


def refusal(asked: Request) -> DesignError:
    with pytest.raises(DesignError) as caught:
        settle(asked, asked.made())
    return caught.value


def test_too_wide_a_flap_is_told_the_widest_that_works() -> None:
    error = refusal(bend(4.0))
    assert "opposite flaps" in str(error)
    match = re.match(r"flap = (\S+); --allow-clash", error.nearest)
    assert match
    widest = float(match[1])
    asked = bend(widest)
    _, lock = settle(asked, asked.made())
    assert lock.cause == "flaps"
    assert not bend(1.01 * widest).locks()


def test_brute_force_agrees_that_the_widest_flaps_meet_nothing() -> None:
    match = re.match(r"flap = (\S+);", refusal(bend(4.0)).nearest)
    assert match
    narrow, wide = (bend(share * float(match[1])).made().mechanism for share in (1, 1.02))
    counts = not_designed(narrow.grid)
    drives = np.linspace(0, 0.9999 * np.pi, 300)
    assert not any(crosses(narrow, float(drive), counts) for drive in drives)
    assert any(crosses(wide, float(drive), counts) for drive in drives)


def test_flaps_of_no_given_width_are_as_wide_as_is_useful() -> None:
    # The mean crease of column 1, unless it meets something.
    asked = bend("auto")
    design, lock = settle(asked, asked.made())
    assert lock.cause == "flaps"
    assert design.parameters["flap"] == asked.made().parameters["flap"]


def test_flaps_of_no_given_width_are_narrowed_until_they_meet_nothing() -> None:
    # Ends of a bend so near that flaps of useful width would meet.
    asked = request(
        graph("-0.3*x**2", -0.7, 0.7),
        pair("1.6*cos(t)", "1.6*sin(t)", 0, 5.5),
        "auto",
        rows=3,
        columns=24,
        xi=np.deg2rad(100),
        flap_sides=("start", "start"),
    )
    useful = asked.made()
    assert find_lock(useful).early
    design, lock = settle(asked, useful)
    assert lock.cause == "flaps"
    width, most = design.parameters["flap"], useful.parameters["flap"]
    assert isinstance(width, float)
    assert isinstance(most, float)
    assert 0 < width < most
    assert not replace(asked, flap=1.01 * width).locks()


@pytest.mark.parametrize(
    ("g", "says"),
    [
        (
            pair("(2+0.25*t)*cos(t)", "(2+0.25*t)*sin(t)", 0, 9),
            r"scale in \[target.f\] times (\S+)",
        ),
        (pair("4*cos(t)", "4*sin(t)", 0, 2 * np.pi), r"parameter 0 to (\S+);"),
    ],
)
def test_other_advice_works_too(g: Curve, says: str) -> None:
    f = graph("-0.9*x**2", -1, 1)
    asked = request(f, g, 0.3, rows=9, columns=40, xi=np.deg2rad(50))
    error = refusal(asked)
    assert "degrees" in error.place
    match = re.search(says, error.nearest)
    assert match
    value = float(match[1])
    if "times" in says:
        mended = replace(asked, f=asked.f.scaled(value))
        beyond = replace(asked, f=asked.f.scaled(1.05 * value))
    else:
        mended = replace(asked, g=replace(g, stop=value))
        beyond = replace(asked, g=replace(g, stop=1.05 * value))
    _, lock = settle(mended, mended.made())
    assert lock.cause == "flaps"
    assert not beyond.locks()


def test_a_clash_can_be_allowed() -> None:
    asked = bend(4.0)
    design, lock = settle(asked, asked.made(), allow_clash=True)
    assert lock.early
    assert design.parameters["flap"] == 4.0

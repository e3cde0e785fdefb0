"""Degrees where formulas take radians: named at the door, and what is meant in radians is left."""

from __future__ import annotations

import re

import numpy as np
import pytest

from orishell.conventions.errors import CurveError
from orishell.curves import trace_curve
from strategies import graph, pair


@pytest.mark.parametrize("ends", [(10, 170), (0, 180), (-75, 75), (180, 360), (0, 360), (0, 45)])
def test_a_range_in_degrees(ends: tuple[int, int]) -> None:
    with pytest.raises(CurveError, match="formulas take radians") as caught:
        pair("1.5*cos(t)", "0.6*sin(t)", *ends)
    error = caught.value
    assert (error.where, error.expected) == ("range", "radians")
    assert error.got.startswith(f"[{ends[0]}, {ends[1]}]")
    # What it tells to write is the ends in radians.
    written = re.findall(r'"(-?\d+)\*pi/180"', error.remedy)
    assert tuple(map(int, written)) == ends


@pytest.mark.parametrize(
    ("x", "y", "ends"),
    [
        ("cos(t)", "sin(t)", np.deg2rad([10, 170])),
        ("cos(t)", "sin(t)", (0, 6)),
        ("cos(pi*t/180)", "sin(pi*t/180)", (10, 170)),  # says itself that they are degrees
        ("exp(t/9)*cos(t)", "exp(t/9)*sin(t)", (0, 20)),  # a spiral
        ("0.05*t*cos(t)", "0.05*t*sin(t)", (60, 90)),  # one between whole numbers far apart
        ("t", "3*sin(t/20)", (0, 180)),
        ("t", "3*sin(t)", (0, 180)),  # 28 waves, and no turn in all
        ("10*cos(t/30)", "10*sin(t/30)", (0, 90)),
        ("1/t", "t", (-30, 30)),  # refused elsewhere, where it is followed
    ],
)
def test_what_is_no_range_in_degrees(x: str, y: str, ends: tuple[float, float]) -> None:
    assert pair(x, y, *ends).start == ends[0]


@pytest.mark.parametrize(
    ("text", "ends", "asked"),
    [
        ("5*sin(18*x)", (0, 10), "write sin(18*x*pi/180)"),
        ("5*cos(x*9) + x", (-10, 10), "write cos(x*9*pi/180)"),
        ("0.1*sin(x)", (0, 180), "write sin(x*pi/180)"),
        ("5*sin(18.0*x)", (0, 10), ""),
        ("5*sin(18*pi*x)", (0, 10), ""),
        ("sin(18*x)", (0, 4), ""),  # 11 waves in radians, 72 degrees
        ("sin(7*x)", (0, 20), ""),  # 140 degrees, no eighth of a turn
    ],
)
def test_waves_that_look_like_degrees_are_asked_about(
    text: str, ends: tuple[float, float], asked: str
) -> None:
    notes = graph(text, *ends).notes
    assert len(notes) == bool(asked)
    assert all(note.startswith("formulas take radians") and asked in note for note in notes)


def test_it_does_not_wait_for_the_curve_to_be_followed() -> None:
    # A graph of the same range has no tangent that turns round; it is followed as ever.
    assert trace_curve(graph("0.1*sin(x)", 0, 180)).length > 180

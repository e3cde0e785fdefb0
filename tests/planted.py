"""Shells that clash before they lock, planted: parallel repeating, nine rows unless said."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from orishell.design import Design
from orishell.families.orthodiagonal import OrthodiagonalPattern, design_orthodiagonal
from orishell.families.parallel_repeating import ParallelRepeatingPattern, design_parallel_repeating
from strategies import graph, pair


def spiral() -> Design:
    """Turns of g nearer than f is wide, so that they meet."""
    return design_parallel_repeating(
        graph("-x**2", -1, 1),
        pair("(2+0.25*t)*cos(t)", "(2+0.25*t)*sin(t)", 0, 9),
        ParallelRepeatingPattern(rows=9, columns=40, flap=0.3, xi_deg=50),
    )


def ring(flap: float = 0.3) -> Design:
    """A closed circle: the last column comes to lie on the first."""
    return design_parallel_repeating(
        graph("-0.3*x**2", -1, 1),
        pair("4*cos(t)", "4*sin(t)", 0, 2 * np.pi),
        ParallelRepeatingPattern(rows=9, columns=30, flap=flap, xi_deg=90),
    )


def wide_flaps() -> Design:
    """Flaps across an almost closed bend, wide enough to meet in its middle."""
    return design_parallel_repeating(
        graph("-x**2", -1, 1),
        pair("2.2*cos(t)", "2.2*sin(t)", 0, 5.5),
        ParallelRepeatingPattern(
            rows=9, columns=24, flap=4.0, flap_side=["start", "start"], xi_deg=50
        ),
    )


def waist() -> Design:
    """A bone-shaped g, not quite symmetric: f reaches over the other side of its waist."""
    return design_parallel_repeating(
        graph("-0.5*x**2", -1, 1),
        pair("5*cos(t)", "sin(t)*(0.8+1.9*cos(t)**2)", -2.9, 2.83),
        ParallelRepeatingPattern(rows=9, columns=50, flap=0.2, xi_deg=60),
    )


def deep() -> Design:
    """A deep f along more than a turn, over itself at different heights."""
    return design_parallel_repeating(
        pair("0.6*t", "1.5*cos(t)", -1.4, 1.4),
        pair("(1.2+0.2*t)*cos(t)", "(1.2+0.2*t)*sin(t)", 0, 7),
        ParallelRepeatingPattern(rows=9, columns=24, flap=0.3, xi_deg=40),
    )


PLANTED: dict[str, Callable[[], Design]] = {
    "spiral": spiral,
    "ring": ring,
    "wide flaps": wide_flaps,
    "waist": waist,
    "deep": deep,
}


def clear() -> Design:
    """An orthodiagonal arch of almost a full turn whose ends do not meet."""
    return design_orthodiagonal(
        pair("1.5*sin(t)", "1.5*cos(t)", -2.6, 2.6),
        graph("0.25*sin(pi*x/2)", 0, 4),
        OrthodiagonalPattern(rows=21, columns=13, flap=0.15, depth=0.12),
    )

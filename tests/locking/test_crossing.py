"""A curve that crosses itself is refused at once, unless panels may clash."""

import time

import pytest

from orishell.conventions.errors import DesignError
from orishell.curves import curve_from_formulas, parse_formula
from orishell.design import Design
from orishell.families.orthodiagonal import OrthodiagonalPattern, design_orthodiagonal
from orishell.locking import end_motion
from orishell.locking.clipped import require_uncrossed
from strategies import graph
from timing import HANGS


def looped(first: float, last: float, rows: int = 25) -> Design:
    """(t^3 - t, t^2), which crosses itself at t = -1 and 1."""
    f = curve_from_formulas(parse_formula("t**3 - t"), parse_formula("t**2"), first, last)
    g = graph("0.1*sin(pi*x/2)", 0, 6)
    return design_orthodiagonal(f, g, OrthodiagonalPattern(rows=rows, columns=5, flap=0.0))


def test_a_loop_is_refused_at_once() -> None:
    design = looped(-1.4, 1.4)
    begin = time.process_time()
    with pytest.raises(DesignError, match="f crosses itself"):
        end_motion(design)
    assert time.process_time() - begin < HANGS
    assert end_motion(design, allow_clash=True)[1].early


def test_a_loop_that_stays_open_is_not() -> None:
    require_uncrossed(looped(-0.9, 0.9))

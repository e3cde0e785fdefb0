"""Why border panels of fitted sheets are left uneven: even ones leave the rim.

A border vertex ends one crease, whose length is free. Crests and valleys of a row begin at other
distances from the rim, so creases that all end on it are long and short by turns.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from fitted_shells import fitted
from orishell.design import Design
from orishell.deviation.report import describe_deviation
from orishell.families.flat_foldable.mechanism import FlatFoldable
from orishell.families.flat_foldable.refusal import find_fault
from orishell.motion.quads import lengths
from orishell.numerics.arrays import Array

SIDES = {"top": (0, 1), "bottom": (-1, -2), "left": (0, 1), "right": (-1, -2)}


def border_creases(sheet: FlatFoldable) -> dict[str, Array]:
    """Lengths of the creases that end on each side of the border."""
    flat, found = sheet.positions(0.0), {}
    for name, (border, beside) in SIDES.items():
        points = flat if name in ("top", "bottom") else flat.swapaxes(0, 1)
        found[name] = lengths(points[border, 1:-1] - points[beside, 1:-1])
    return found


def evened(design: Design) -> Design:
    """The design with creases along each side as long as a parabola through their lengths says."""
    sheet = design.mechanism
    assert isinstance(sheet, FlatFoldable)
    net = sheet.sheet.net
    changes = {}
    for name, long in border_creases(sheet).items():
        place = np.arange(len(long))
        even = np.polyval(np.polyfit(place, long, 2), place)
        changes[name] = getattr(net, name) * (even / long)[:, None]
    net = replace(net, **changes)
    assert find_fault(net) is None
    return replace(design, mechanism=replace(sheet, sheet=net.march()))


def _distance(design: Design) -> float:
    found = describe_deviation(design, measured=True)
    assert found is not None
    assert found.surface is not None
    return found.surface.max


@pytest.mark.parametrize("surface", ["cap", "roof"])
def test_even_borders_leave_the_rim(surface: str) -> None:
    """They are even, and farther from the surface than as they were fitted."""
    uneven = fitted(surface)
    even = evened(uneven)
    assert isinstance(uneven.mechanism, FlatFoldable)
    assert isinstance(even.mechanism, FlatFoldable)
    before, after = _steps(uneven.mechanism), _steps(even.mechanism)
    assert before > 1.5
    assert after < before
    assert _distance(even) > 1.2 * _distance(uneven)


def _steps(sheet: FlatFoldable) -> float:
    """By which factor neighbours on the border differ, at most."""
    return max(
        float(np.exp(np.abs(np.diff(np.log(long))).max()))
        for long in border_creases(sheet).values()
    )

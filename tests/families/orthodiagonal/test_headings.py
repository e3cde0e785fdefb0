"""The admissible interval: exact, and the known one of Figure 2."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from orishell.families.orthodiagonal import Orthodiagonal
from orishell.families.orthodiagonal.headings import (
    HeadingConditions,
    SideChoice,
    headings_of,
    holds,
)
from orishell.polylines import Zigzag
from samples import examples
from strategies import numbers


def figure_2() -> tuple[Zigzag, np.ndarray]:
    """Vertices of f = -x**2 at equal steps of x, all of them on the offsets; g likewise."""
    x = np.linspace(-1, 1, 11)
    feet = np.stack([x, -(x**2)], axis=-1)
    normal = np.stack([2 * x, np.ones_like(x)], axis=-1) / np.hypot(2 * x, 1)[:, None]
    vertices = feet + 0.12 * normal * (-1.0) ** np.arange(11)[:, None]
    across = np.linspace(0, 4, 13)
    g = np.stack([across, 0.25 * np.sin(np.pi * across / 2)], axis=-1)
    return Zigzag(vertices, feet, -1, 0.12), g


def folded(zigzag: Zigzag, headings: HeadingConditions, heading: float) -> Orthodiagonal:
    return Orthodiagonal(
        zigzag.lengths, zigzag.angles, -1, 0.0, headings.points, heading, (0.01, 0.01)
    )


def test_known_interval_of_alpha_0() -> None:
    # geometry.md section 4: between about 99 and 114 degrees; the paper would allow 90 to 142.
    zigzag, g = figure_2()
    headings = headings_of(zigzag, g)
    ((low, high),) = headings.intervals()
    middle = zigzag.angles[4]
    assert np.rad2deg((np.pi + middle) / 2) == pytest.approx(142, abs=0.5)

    def alpha_0(heading: float) -> float:
        return float(np.rad2deg(np.arccos(np.sin(middle / 2) * np.cos(headings.eps(heading)[0]))))

    assert alpha_0(low) == pytest.approx(99.1, abs=0.05)
    assert alpha_0(high) == pytest.approx(114.0, abs=0.05)
    # Inside all inner edges are positive; 0.01 degrees outside one is not.
    step = np.deg2rad(0.01)
    for heading, positive in (
        (low + step, True),
        (high - step, True),
        (low - step, False),
        (high + step, False),
    ):
        flat = folded(zigzag, headings, heading).positions(0.0)
        t = np.array([np.cos(heading), -np.sin(heading), 0.0])
        edges = np.diff(flat[1:-1, 1:-1], axis=0) @ t
        assert bool((edges > 0).all()) == positive


points = st.lists(st.tuples(numbers(0.05, 1), numbers(-0.5, 0.5)), min_size=1, max_size=8).map(
    lambda steps: np.concatenate([[0], np.cumsum([x + 1j * y for x, y in steps])])
)


@settings(max_examples=examples(150))
@given(
    points,
    numbers(-3, 3),
    st.tuples(numbers(-2, -0.05), numbers(0.05, 2)),
    st.sampled_from([None, 0.0, 0.02, 0.3, 1.0]),
    st.tuples(*[st.sampled_from(["start", "end", None])] * 2),
)
def test_intervals_are_where_all_conditions_hold(
    g: np.ndarray,
    turn: float,
    limits: tuple[float, float],
    flap: float | None,
    sides: tuple[SideChoice, SideChoice],
) -> None:
    headings = HeadingConditions(g * np.exp(1j * turn), 0.7, limits, flap, sides)
    intervals = headings.intervals()
    low, high = limits
    for heading in np.linspace(0.0005, np.pi - 0.0005, 400):
        shifts, eps = headings.shifts(heading), headings.eps(heading)
        good = low < shifts.min() and shifts.max() < high and eps.min() > 0 and eps.max() < np.pi
        if flap is not None:
            for side, at in zip(sides, (0.0, shifts[-1]), strict=True):
                ends = [at - flap] if side == "start" else [at + flap]
                ends = [at - flap, at + flap] if side is None else ends
                good = good and any(low < end < high for end in ends)
        gaps = np.abs(intervals - heading)
        if not gaps.size or gaps.min() > 1e-5:
            assert any(a < heading < b for a, b in intervals) == good


def test_open_intervals() -> None:
    assert holds((0.0, 1.0), 0.0)  # 0 and 180 degrees are where headings end, not where they fail
    assert holds((1.0, np.pi), np.pi)
    assert not holds((0.5, 1.0), 0.5)
    assert not holds(None, 0.5)

"""Enclosures hold what they enclose, and close in on it as the range shrinks."""

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from orishell.curves import parse_formula
from orishell.numerics import (
    Enclosure,
    Interval,
    spinning_acceleration,
    turning_acceleration,
)

Array = np.ndarray
SHARES = np.linspace(0.0, 1.0, 9)
ROUNDING = 1e-13

NUMBERS = st.floats(-5, 5, allow_nan=False).map(lambda x: round(x, 3))
POSITIVE = st.floats(0.05, 5).map(lambda x: round(x, 3))


@st.composite
def intervals(draw: st.DrawFn, numbers: st.SearchStrategy[float] = NUMBERS) -> Interval:
    return Interval.between(draw(numbers), draw(numbers))


@st.composite
def drives(draw: st.DrawFn) -> tuple[float, float]:
    """Ranges in [0, pi], ends included, long and short."""
    start = draw(st.one_of(st.just(0.0), st.floats(0, 3.1)))
    width = draw(st.sampled_from([1e-3, 0.02, 0.3, 4.0]))
    return start, min(start + width, np.pi)


def inside(interval: Interval) -> Array:
    return np.asarray(interval.low + (interval.high - interval.low) * SHARES)


def require_within(values: Array, interval: Interval) -> None:
    allowed = ROUNDING * (1 + np.abs(values).max())
    assert (values >= interval.low - allowed).all()
    assert (values <= interval.high + allowed).all()


@given(intervals(), intervals(), intervals(POSITIVE), NUMBERS)
def test_interval_operations_hold_all_values(
    a: Interval, b: Interval, positive: Interval, number: float
) -> None:
    x, y, z = inside(a), inside(b)[:, None], inside(positive)[:, None]
    require_within(x + y, a + b)
    require_within(x - y, a - b)
    require_within(x * y, a * b)
    require_within(x / z, a.over(positive))
    require_within(number * x, a.times(number))
    require_within(x + number, a.plus(number))
    require_within(x**2, a.squared())
    assert a.magnitude() == pytest.approx(np.abs(x).max(), rel=1e-15)
    # Each bound is met, so that nothing is given away.
    for result, values in ((a * b, x * y), (a.squared(), x**2), (a.over(positive), x / z)):
        assert result.high == pytest.approx(values.max(), abs=1e-12)
        assert result.low <= values.min() + 1e-12


def half_cosine(start: Array, stop: Array) -> Enclosure:
    return Enclosure.half_cosine(start, stop)


# An enclosure, and the formula of what it encloses, a and b being numbers.
Pair = tuple[Callable[[Array, Array, float, float], Enclosure], str]
FUNCTIONS: dict[str, Pair] = {
    "half cosine": (lambda u, v, a, b: half_cosine(u, v), "cos(t/2)"),
    "half sine": (lambda u, v, a, b: Enclosure.half_sine(u, v), "sin(t/2)"),
    "sum": (
        lambda u, v, a, b: half_cosine(u, v).times(a) + Enclosure.half_sine(u, v).times(-b),
        "{a}*cos(t/2) - {b}*sin(t/2)",
    ),
    "difference": (
        lambda u, v, a, b: half_cosine(u, v).times(a) - Enclosure.half_sine(u, v).times(-b),
        "{a}*cos(t/2) + {b}*sin(t/2)",
    ),
    "hypot": (
        lambda u, v, a, b: half_cosine(u, v).times(a).hypot(np.array(b)),
        "sqrt({b}**2 + ({a}*cos(t/2))**2)",
    ),
    "angle": (
        lambda u, v, a, b: Enclosure.half_sine(u, v).times(a).arctan2(np.array(b)),
        "atan({a}*sin(t/2)/{b})",
    ),
    "angle behind": (
        lambda u, v, a, b: half_cosine(u, v).arctan2(np.array(-b)),
        "pi - atan(cos(t/2)/{b})",
    ),
    "angle of hypot": (
        lambda u, v, a, b: half_cosine(u, v).hypot(np.array(b)).arctan2(np.array(a)),
        "atan(sqrt({b}**2 + cos(t/2)**2)/{a})",
    ),
}


@pytest.mark.parametrize("name", FUNCTIONS)
@given(drives(), POSITIVE, POSITIVE)
def test_enclosures_hold_value_and_derivatives(
    name: str, drive: tuple[float, float], a: float, b: float
) -> None:
    enclose, text = FUNCTIONS[name]
    enclosure = enclose(np.array(drive[:1]), np.array(drive[1:]), a, b)
    t = drive[0] + (drive[1] - drive[0]) * SHARES
    jet = parse_formula(text.format(a=a, b=b)).jet(t)
    for values, interval in zip(
        jet, (enclosure.value, enclosure.first, enclosure.second), strict=True
    ):
        allowed = 1e-11 * (1 + np.abs(values).max())
        assert (values >= interval.low - allowed).all()
        assert (values <= interval.high + allowed).all()


@pytest.mark.parametrize("name", FUNCTIONS)
@given(st.floats(0, 3), POSITIVE, POSITIVE)
def test_second_derivatives_close_in_with_the_range(
    name: str, start: float, a: float, b: float
) -> None:
    # To first order in the range: a 64th of the range has less than a 16th of the width.
    enclose, _ = FUNCTIONS[name]

    longest = 0.1 * min(b / a, a, b, 1.0)

    def width(length: float) -> float:
        second = enclose(np.array([start]), np.array([start + length]), a, b).second
        return float((second.high - second.low)[0])

    assert width(longest / 64) <= width(longest) / 16 + 1e-11 * (1 + a / b) ** 2


@given(drives(), st.lists(st.tuples(POSITIVE, NUMBERS), min_size=1, max_size=5))
def test_sums_over_columns(drive: tuple[float, float], angles: list[tuple[float, float]]) -> None:
    start, stop = (np.full((1, 1), end) for end in drive)
    sides, factors = np.array(angles).T
    steps = Enclosure.half_sine(start, stop).arctan2(sides).times(factors)
    t = np.linspace(*drive, 9)
    terms = [parse_formula(f"{factor}*atan(sin(t/2)/{side})").jet(t) for side, factor in angles]
    sums = np.cumsum([np.zeros_like(terms[0]), *terms], axis=0)
    running = steps.running()
    for k in range(len(angles) + 1):
        part = running.part(slice(k, k + 1))
        for values, interval in zip(sums[k], (part.value, part.first, part.second), strict=True):
            require_within(values, interval)
    weights = sides / sides.sum()
    mean = steps.mean(weights)
    for values, interval in zip(
        np.tensordot(weights, terms, 1), (mean.value, mean.first, mean.second), strict=True
    ):
        require_within(values, interval)


@given(drives(), POSITIVE, POSITIVE, NUMBERS)
def test_vectors_in_a_plane(
    drive: tuple[float, float], side: float, along: float, factor: float
) -> None:
    start, stop = np.array(drive[:1]), np.array(drive[1:])
    length = Enclosure.half_cosine(start, stop).hypot(np.array(side))
    angle = Enclosure.half_sine(start, stop).arctan2(np.array(along)).times(factor)
    t = np.linspace(*drive, 9)
    size = f"sqrt({side}**2 + cos(t/2)**2)"
    turned = f"({factor}*atan(sin(t/2)/{along}))"

    def acceleration(length: str) -> float:
        parts = [parse_formula(f"{length}*{way}{turned}").jet(t)[2] for way in ("cos", "sin")]
        return float(np.hypot(*parts).max())

    assert acceleration(size) <= turning_acceleration(length, angle)[0] * (1 + 1e-10) + 1e-12
    assert acceleration("1") <= spinning_acceleration(angle)[0] * (1 + 1e-10) + 1e-12
    if drive[1] - drive[0] < 0.01:
        assert acceleration(size) >= 0.8 * turning_acceleration(length, angle)[0] - 0.1

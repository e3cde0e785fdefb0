"""No edge swings faster than its bound says, anywhere on any path, and bounds are not far off."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from accelerations import RANGES, shares_of_bounds
from orishell.design_file import read_design_file
from orishell.families.longitudinal_linear_repeating import (
    LongitudinalLinearRepeating,
    RowKind,
    Sectors,
    find_solutions,
)
from orishell.families.longitudinal_linear_repeating.motion import rates
from orishell.families.longitudinal_linear_repeating.motion.mechanism import Pose
from orishell.families.longitudinal_linear_repeating.motion.rates import fold_rates
from orishell.families.longitudinal_linear_repeating.sheet import with_fitting_border
from orishell.families.longitudinal_linear_repeating.tessellation.columns import (
    Directions,
    flat_foldable_rows,
    repeat_columns,
)
from orishell.families.longitudinal_linear_repeating.tessellation.even_lengths import (
    Wanted,
    find_even_lengths,
)
from orishell.families.orthodiagonal import (
    Orthodiagonal,
    OrthodiagonalPattern,
    design_orthodiagonal,
)
from orishell.families.parallel_repeating import ParallelRepeating
from orishell.motion import Mechanism
from samples import examples
from strategies import (
    Request,
    graph,
    orthodiagonal_requests,
    pair,
    requests,
)

EXAMPLES = Path(__file__).parents[2] / "examples"
PAPER = (85.0, 80.0, 95.0, 100.0)
STILL, TURNING = Pose(), Pose((1.0, 0.0, 0.0), (0.3, -1.0, 0.5))
Array = np.ndarray


def example(number: int) -> Mechanism:
    file = read_design_file(EXAMPLES / f"figure{number}.toml")
    return file.pattern.design(file.f, file.g).mechanism


def sheet(
    degrees: tuple[float, ...] = PAPER,
    size: tuple[int, int] = (5, 6),
    first_row: RowKind = "F",
    solution: int = 0,
    pose: Pose = STILL,
) -> LongitudinalLinearRepeating | None:
    """A sheet with the most even lengths, if there is one."""
    rows, columns = size
    made = repeat_columns(find_solutions(Sectors.from_degrees(degrees))[solution], columns)
    inner = find_even_lengths(Directions.of(made, rows, first_row), Wanted())
    if inner is None or inner.ratio > 500:
        return None
    bordered = with_fitting_border(made, first_row, inner, (0.02, 0.02), "auto")
    return LongitudinalLinearRepeating(
        bordered.columns, bordered.first_row, bordered.lengths, bordered.side, None, pose
    )


def test_cut_flaps_stay_within_the_bounds() -> None:
    """Their outlines are no edges of columns: they slant where the flap is cut."""
    f = pair("1.55*cos(t)", "2.3*sin(t)", 0, np.pi)
    design = design_orthodiagonal(
        f, graph("0.1*cos(2*pi*x)", 0, 6), OrthodiagonalPattern(rows=11, columns=13)
    )
    assert isinstance(design.mechanism, Orthodiagonal)
    assert (design.mechanism.kept < 1).any()
    rows, columns = shares_of_bounds(design.mechanism, count=60)
    assert rows.mean() > 0.5
    assert columns.mean() > 0.3


@pytest.mark.parametrize("number", [1, 2, 3])
def test_examples_stay_within_the_bounds_and_near_them(number: int) -> None:
    rows, columns = shares_of_bounds(example(number), count=60)
    # Nothing is given away: sums of true accelerations are most of the sums of bounds.
    assert rows.min() > 0.5
    assert columns.min() > 0.5
    assert max(rows.max(), columns.max()) > 0.95


@pytest.mark.parametrize("number", [1, 2, 3])
def test_long_ranges_are_bounded_too(number: int) -> None:
    for ranges in (1, 3, 20):
        shares_of_bounds(example(number), count=7, ranges=ranges)


@settings(max_examples=examples(60))
@given(requests(), st.sampled_from([20, RANGES]))
def test_any_parallel_repeating_design(request: Request, ranges: int) -> None:
    shares_of_bounds(request.feasible().mechanism, 9, ranges)


@settings(max_examples=examples(60))
@given(orthodiagonal_requests(), st.sampled_from([20, RANGES]))
def test_any_orthodiagonal_design(request: Request, ranges: int) -> None:
    shares_of_bounds(request.feasible().mechanism, 9, ranges)


def shares_up_to_the_pack(
    mechanism: Mechanism, count: int = 24, ranges: int = RANGES
) -> tuple[Array, Array]:
    """The same for the sheet without its flaps, up to a thousandth before its end."""
    assert isinstance(mechanism, ParallelRepeating | Orthodiagonal)
    bare = replace(mechanism, flaps=(0.0, 0.0))
    assert bare.end_drive == np.pi
    return shares_of_bounds(bare, count, ranges, bare.end_drive * (1 - 1e-3))


@settings(max_examples=examples(60))
@given(requests(), st.sampled_from([20, RANGES]))
def test_any_parallel_repeating_design_up_to_its_pack(request: Request, ranges: int) -> None:
    shares_up_to_the_pack(request.feasible().mechanism, 12, ranges)


@settings(max_examples=examples(60))
@given(orthodiagonal_requests(), st.sampled_from([20, RANGES]))
def test_any_orthodiagonal_design_up_to_its_pack(request: Request, ranges: int) -> None:
    shares_up_to_the_pack(request.feasible().mechanism, 12, ranges)


@settings(max_examples=examples(60))
@given(
    st.one_of(requests(), orthodiagonal_requests()),
    st.floats(1e-3, 0.95),
    st.sampled_from([20, RANGES]),
)
def test_any_design_whose_flaps_have_a_stop(request: Request, share: float, ranges: int) -> None:
    """Up to the target, and beyond it up to a thousandth before the end of the motion."""
    sheet = request.feasible().mechanism
    assert isinstance(sheet, ParallelRepeating | Orthodiagonal)
    stopped = sheet.with_stop(share * sheet._sharpest_angle() / 2)
    for end in (stopped.target_drive, stopped.end_drive * (1 - 1e-3)):
        shares_of_bounds(stopped, 12, ranges, end)


@pytest.mark.parametrize("heading", [90, 75])
def test_a_straight_g_up_to_its_pack(heading: float) -> None:
    # Square to f's plane rows stay straight and kappa = tan(drive/2): its target is at 90 degrees.
    design = design_orthodiagonal(
        graph("-x**2", -1, 1),
        graph("0*x", 0, 1),
        OrthodiagonalPattern(rows=9, columns=5, depth=0.12, heading_deg=heading, flap=0),
    )
    assert isinstance(design.mechanism, Orthodiagonal)
    straight = np.abs(design.mechanism.target_drive - np.pi / 2) < 1e-14
    assert straight == (heading == 90)
    for ranges in (1, 3, 20, RANGES):
        _, columns = shares_up_to_the_pack(design.mechanism, 60, ranges)
    # Nothing is given away before the last ranges, over which kappa grows without end.
    assert np.median(columns) > 0.5


@pytest.mark.parametrize("number", [1, 2])
def test_examples_up_to_their_packs(number: int) -> None:
    for ranges in (1, 3, 20, RANGES):
        rows, columns = shares_up_to_the_pack(example(number), 60, ranges)
    assert rows.min() > 0.5
    assert columns.min() > 0.5


@settings(max_examples=examples(40))
@given(
    st.lists(st.floats(70, 110).map(lambda x: round(x, 3)), min_size=4, max_size=4),
    st.sampled_from(["F", "S"]),
    st.sampled_from([(1, 2), (2, 3), (3, 4), (4, 5)]),
    st.sampled_from([1, 20, RANGES]),
)
def test_any_longitudinal_linear_repeating_sheet(
    degrees: list[float], first_row: RowKind, size: tuple[int, int], ranges: int
) -> None:
    for number in range(len(find_solutions(Sectors.from_degrees(degrees)))):
        mechanism = sheet(tuple(degrees), size, first_row, number, TURNING)
        if mechanism is not None:
            shares_of_bounds(mechanism, 9, ranges)


def test_large_longitudinal_linear_repeating_sheets() -> None:
    for size in (9, 35):
        mechanism = sheet(size=(size, size))
        assert mechanism is not None
        rows, columns = shares_of_bounds(mechanism)
        assert np.median(rows) > 0.3
        assert np.median(columns) > 0.4


def test_ranges_are_bounded_alike_alone_and_together(monkeypatch: pytest.MonkeyPatch) -> None:
    mechanism = sheet()
    assert mechanism is not None
    ends = np.linspace(0.0, mechanism.target_drive, 8)
    together = mechanism.edge_accelerations(ends[:-1], ends[1:])
    monkeypatch.setattr(rates, "AT_ONCE", 1)
    alone = mechanism.edge_accelerations(ends[:-1], ends[1:])
    for one, other in zip(alone, together, strict=True):
        np.testing.assert_allclose(one, other, rtol=1e-12)


@pytest.mark.parametrize("first_row", ["F", "S"])
@pytest.mark.parametrize(
    ("degrees", "solution"),
    [(PAPER, 0), ((85, 80, 85, 100), 1), ((89.9995, 89.999, 90.0005, 90.001), 0)],
)
@pytest.mark.parametrize("ranges", [1, 7, 300, 4000])
def test_fold_rates(
    first_row: RowKind, degrees: tuple[float, ...], solution: int, ranges: int
) -> None:
    # Differences over a range are means of the derivatives in it.
    mechanism = sheet(degrees, (4, 5), first_row, solution)
    assert mechanism is not None
    h = 0.5 * mechanism.target_drive / ranges
    drives = np.linspace(h, mechanism.target_drive - h, 40)
    kinds = flat_foldable_rows(4, first_row)
    rates = fold_rates(mechanism.columns, kinds, drives - h, drives + h)
    angles = [mechanism.fold_angles(drives + step) for step in (-h, 0.0, h)]
    sign = np.sign(angles[1].column[:, :, :1]) * np.sign(mechanism.columns.multipliers[0])
    for rate, (before, now, after), signs in (
        (rates[0], [each.column for each in angles], sign),
        (rates[1], [each.row for each in angles], sign[:, 1:]),
    ):
        values = signs * (after - before) / (2 * h), signs * (before - 2 * now + after) / h**2
        for value, interval, order in zip(values, (rate.first, rate.second), (1, 2), strict=True):
            allowed = 1e-14 / h**order + 1e-9 * np.abs(value).max()
            assert (value >= interval.low - allowed).all()
            assert (value <= interval.high + allowed).all()

"""Ties: what is proved of them holds wherever one looks."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from orishell.conventions.errors import InputError
from orishell.deployment import ColumnDistances, Tie, feet_ties, find_ties
from orishell.deployment.short_ties import _others
from orishell.deployment.ties import fold_ties
from orishell.design import Design
from orishell.design_file import read_design_file
from orishell.families.orthodiagonal import Orthodiagonal
from orishell.families.parallel_repeating import ParallelRepeating
from orishell.motion import diagonal
from orishell.motion.hinge_lines import IN_CREASES
from samples import examples
from strategies import Request, graph, orthodiagonal, orthodiagonal_requests, pair, requests

EXAMPLES = Path(__file__).parents[2] / "examples"
ROUNDING = 1e-12
Sheet = ParallelRepeating | Orthodiagonal
Array = np.ndarray


def bare(design: Design) -> Sheet:
    """The sheet without flaps, so that there is motion beyond the target."""
    mechanism = design.mechanism
    assert isinstance(mechanism, ParallelRepeating | Orthodiagonal)
    return replace(mechanism, flaps=(0.0, 0.0))


def example(name: str) -> Design:
    file = read_design_file(EXAMPLES / f"{name}.toml")
    return file.pattern.design(file.f, file.g)


def horseshoe() -> Sheet:
    """An arch that turns by 283 degrees: its feet point at each other."""
    f, g = pair("cos(t)", "sin(t)", -0.9, 0.9 + np.pi), graph("0*x", 0, 2)
    return bare(orthodiagonal(f, g, rows=9, columns=4, depth=0.1, flap=0.0).feasible())


def squares(mechanism: Sheet, pairs: Array, drives: Array) -> Array:
    """Squared distances (S, P) from positions; pairs (P, 3) of two rows and a column."""
    first, second, column = pairs.T
    positions = mechanism.positions(drives)
    vector = positions[:, second, column] - positions[:, first, column]
    return np.asarray((vector**2).sum(axis=-1))


def some_pairs(mechanism: Sheet, shares: list[float]) -> Array:
    """The feet of the first and the last column, and others that the shares choose."""
    rows, columns = mechanism.grid.rows, mechanism.grid.columns
    feet = [(0, rows - 1, 0), (0, rows - 1, columns - 1)]
    chosen = []
    for a, b, c in np.reshape(shares, (-1, 3)):
        first = int(a * (rows - 1))
        second = first + 1 + int(b * (rows - 1 - first))
        chosen.append((first, second, int(c * columns)))
    return np.array(feet + chosen)


def ties_of(mechanism: Sheet, pairs: Array) -> tuple[Tie, ...]:
    return find_ties(
        mechanism, [((a, column), (b, column)) for a, b, column in pairs.tolist()], np.pi
    )


def require_truth(mechanism: Sheet, shares: list[float]) -> None:
    """What ties say is what 2000 drives show."""
    pairs = some_pairs(mechanism, shares)
    drives = np.linspace(0.0, np.pi, 2000)
    square = squares(mechanism, pairs, drives)
    rounding = ROUNDING * diagonal(mechanism.positions(0.0)) ** 2
    for number, tie in enumerate(ties_of(mechanism, pairs)):
        steps = np.diff(square[:, number])
        if tie.grows:
            assert (steps < rounding).all()
            continue
        assert tie.shrinks is not None, f"undecided: {tie}"
        assert tie.fails_at is not None
        more, less = squares(mechanism, pairs[number : number + 1], np.array(tie.shrinks))[:, 0]
        assert less >= more - rounding
        between = np.sort([mechanism.target_drive, tie.fails_at])
        clear = (drives[:-1] >= between[0]) & (drives[1:] <= between[1])
        assert (steps[clear] < rounding).all()


SHARES = st.lists(st.floats(0, 0.999), min_size=12, max_size=12)


@settings(max_examples=examples(100))
@given(requests(), SHARES)
def test_any_parallel_repeating_design(request: Request, shares: list[float]) -> None:
    mechanism = bare(request.feasible())
    require_truth(mechanism, shares)
    # Only edges of panels do not grow: all else has an edge that rises and one that falls.
    pairs = some_pairs(mechanism, shares)
    for (first, second, _), tie in zip(pairs.tolist(), ties_of(mechanism, pairs), strict=True):
        assert tie.grows == (second - first > 1)


@settings(max_examples=examples(100))
@given(orthodiagonal_requests(), SHARES)
def test_any_orthodiagonal_design(request: Request, shares: list[float]) -> None:
    require_truth(bare(request.feasible()), shares)


@settings(max_examples=examples(60))
@given(
    st.one_of(requests(), orthodiagonal_requests()),
    SHARES,
    st.sampled_from([0.9, 0.05, 1e-3]),
    st.floats(0, 1),
)
def test_enclosures_hold_squares_and_their_derivatives(
    request: Request, shares: list[float], width: float, place: float
) -> None:
    mechanism = bare(request.feasible())
    pairs = some_pairs(mechanism, shares)
    start = place * (1 - width) * np.pi
    stop = start + width * np.pi
    assert isinstance(mechanism, ColumnDistances)
    square = mechanism.column_distances(
        pairs[:, :2], pairs[:, 2], np.array([start]), np.array([stop])
    )
    # Differences are means of derivatives over what they span: all of it lies in the range.
    drives = np.linspace(start, stop, 41)
    h = drives[1] - drives[0]
    values = squares(mechanism, pairs, drives)
    size = 1e-13 * diagonal(mechanism.positions(0.0)) ** 2
    for interval, true, order in (
        (square.value, values, 0),
        (square.first, np.diff(values, axis=0) / h, 1),
        (square.second, np.diff(values, 2, axis=0) / h**2, 2),
    ):
        allowed = 10 * size / h**order + 1e-9 * np.abs(true).max(axis=0)
        assert (true >= interval.low - allowed).all()
        assert (true <= interval.high + allowed).all()


@pytest.mark.parametrize("name", ["figure1", "figure2"])
def test_enclosures_close_in_with_the_range(name: str) -> None:
    mechanism = bare(example(name))
    pairs = some_pairs(mechanism, [0.0, 0.5, 0.5])

    def widths(width: float) -> Array:
        square = mechanism.column_distances(
            pairs[:, :2], pairs[:, 2], np.array([1.0]), np.array([1.0 + width])
        )
        intervals = (square.value, square.first, square.second)
        return np.array([each.high - each.low for each in intervals])

    assert (widths(1e-5) < 0.02 * widths(1e-3)).all()


def test_the_feet_of_the_shelter() -> None:
    mechanism = bare(example("shelter"))
    for tie in find_ties(mechanism, feet_ties(mechanism, (0, 12)), mechanism.end_drive):
        assert tie.grows
        assert (tie.fails_at, tie.shrinks) == (None, None)
        # Level ends: all columns stand at the ends of f, which are 2 x 1.55 m apart.
        assert tie.length == pytest.approx(3.1, rel=1e-12)
        assert tie.flat == pytest.approx(7.148, abs=1e-3)
        assert 1.197 < tie.packed < 1.228


def test_feet_of_a_horseshoe_come_nearer_before_they_part() -> None:
    mechanism = horseshoe()
    (tie, *_) = find_ties(mechanism, feet_ties(mechanism, (0, 10)), mechanism.end_drive)
    assert tie.grows is False
    assert tie.shrinks is not None
    assert tie.shrinks == pytest.approx((1.92386, 2.52737), abs=1e-5)
    assert tie.fails_at == pytest.approx(tie.shrinks[0], abs=1e-9)
    # Up to there it is proved: the shell is opened from a pack that ends before.
    (shorter, *_) = find_ties(mechanism, feet_ties(mechanism, (0, 10)), 1.92)
    assert shorter.grows


def test_flaps_do_not_matter() -> None:
    f, g = pair("1.55*cos(t)", "2.3*sin(t)", 0, np.pi), graph("0.1*cos(2*pi*x)", 0, 6)
    design = orthodiagonal(f, g, rows=11, columns=13).design()
    mechanism = design.mechanism
    assert isinstance(mechanism, Orthodiagonal)
    assert (mechanism.kept < 1).any()
    ties = find_ties(mechanism, feet_ties(mechanism, (0, 12)), mechanism.end_drive)
    others = find_ties(bare(design), feet_ties(bare(design), (0, 12)), 1.7)
    for tie, other in zip(ties, others, strict=True):
        assert tie.grows
        assert tie.ends[0][1] == other.ends[0][1] + 1
        assert (tie.length, tie.flat) == pytest.approx((other.length, other.flat))
        assert tie.packed == tie.length


def test_straight_rows_are_proved_to_the_very_end() -> None:
    f, g = graph("-x**2", -1, 1), graph("0*x", 0, 2)
    design = orthodiagonal(f, g, rows=9, columns=4, depth=0.05, flap=0.0).feasible()
    mechanism = design.mechanism
    assert mechanism.target_drive == pytest.approx(np.pi / 2)
    assert all(tie.grows for tie in find_ties(mechanism, feet_ties(mechanism, (1, 9)), np.pi))


def test_a_family_that_does_not_enclose_distances_does_not_say_whether_they_grow() -> None:
    mechanism = example("figure3").mechanism
    assert not isinstance(mechanism, ColumnDistances)
    ties = find_ties(mechanism, feet_ties(mechanism, (1, 4)), mechanism.target_drive)
    assert {tie.grows for tie in ties} == {None}
    assert {tie.slack for tie in ties} == {True}  # there is nothing beyond the target
    assert all(tie.length == tie.packed > 0 for tie in ties)
    assert find_ties(mechanism, [], mechanism.target_drive) == ()


@pytest.mark.parametrize(
    ("ends", "what"),
    [
        (((0, 1), (13, 1)), "a tie ends beyond the rows of the grid"),
        (((-1, 1), (12, 1)), "a tie ends beyond the rows of the grid"),
        (((0, 1), (12, 2)), "a tie joins vertices of two columns"),
        (((0, 0), (12, 0)), "a tie is not at an inner column"),
        (((0, 15), (12, 15)), "a tie is not at an inner column"),
        (((4, 3), (4, 3)), "a tie joins a vertex to itself"),
    ],
)
def test_pairs_that_are_no_ties(ends: tuple[tuple[int, int], tuple[int, int]], what: str) -> None:
    with pytest.raises(InputError) as caught:
        find_ties(example("shelter").mechanism, [ends], np.pi)
    first, second = (list(each) for each in ends)
    assert str(caught.value) == (
        f"[deployment] ties: {what}; got rows and columns {first}, {second}, expected two rows of "
        "0 to 12 in one column of 1 to 13. Remedy: take two vertices of one column between the "
        "flaps, such as its feet."
    )


def test_ties_across_folds_by_rows_are_some_of_all() -> None:
    """Those of rows 2 and 4 join rows 1 and 3, and 3 and 5."""
    sheet = bare(example("shelter"))
    every = fold_ties(sheet)
    rows, columns = sheet.grid.rows - 2, sheet.grid.columns
    assert len(every) == rows * columns
    some = fold_ties(sheet, [4, 2, 2])
    assert some == [pair for pair in every if pair[0][0] in (1, 3)]
    assert len(some) == 2 * columns
    with pytest.raises(InputError, match="no fold lies at the border"):
        fold_ties(sheet, [rows + 1])


def test_rows_of_folds_that_are_slack_are_offered_for_those_that_are_not() -> None:
    """Own states say which: ties of the rows that are left are never longer than at the target."""
    sheet, limit = horseshoe(), np.pi
    asked = [*feet_ties(sheet, (0, 10)), *fold_ties(sheet)]
    first = next(iter(_others(sheet, asked, limit, IN_CREASES))).changes["deployment.ties"]
    rows = first["folds"] if isinstance(first, dict) else []
    seen = np.sqrt(
        squares(
            sheet,
            np.array([(one[0], other[0], one[1]) for one, other in fold_ties(sheet)]),
            np.linspace(sheet.target_drive, limit, 65),
        )
    )
    slack = (seen <= seen[0] * (1 + ROUNDING)).all(axis=0).reshape(9, -1).all(axis=1)
    assert rows == (np.flatnonzero(slack) + 1).tolist()

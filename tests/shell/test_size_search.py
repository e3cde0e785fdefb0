"""The search for the fewest panels, on errors given by a formula: all sheets can be tried there."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from orishell.conventions.errors import DesignError
from orishell.families.tolerance import Tolerance, Variants
from orishell.shell.board_limits import BoardFit
from orishell.shell.size_search import choose
from orishell.shell.size_trials import MOST_ROWS, Sizes, Trial

Error = Callable[[int, int], float]


def sizes(
    error: Error,
    quick: float = 1.0,
    refuses: Callable[[int, int], bool] = lambda _rows, _columns: False,
    asked: list[tuple[int, int]] | None = None,
    **others: Any,
) -> Sizes[int]:
    """Errors by a formula, a share of them if quick; edges 10/(rows + 1) and 20/columns long.

    A variant is its number of rows: there is one for each.
    """

    def measure(rows: int, columns: int, careful: bool) -> Trial:
        if asked is not None:
            asked.append((rows, columns))
        if refuses(rows, columns):
            raise DesignError("f's plane does not cross the chord of g")
        edges = sorted((10 / (rows + 1), 20 / columns))
        return Trial.of(rows, columns, error(rows, columns) * (1 if careful else quick), *edges)

    found: dict[str, Any] = {
        "variants": lambda rows: Variants([rows]),
        "distance_from_f": lambda rows: error(rows, 10**6),
        "distance_from_g": lambda columns: error(10**6, columns),
        "measure": measure,
        **others,
    }
    return Sizes(**found)


def fewest(error: Error, tolerance: Tolerance) -> int:
    """Brute force: the fewest panels of all sheets that do."""
    measure = sizes(error).measure
    panels = []
    for rows in range(1, MOST_ROWS + 1, 2):
        for columns in range(2, MOST_ROWS + 1):
            got = measure(rows, columns, True)
            if (
                got.error <= tolerance.surface
                and got.shortest >= tolerance.panel_min
                and got.longest <= tolerance.panel_max
            ):
                panels.append((rows + 1) * (columns - 1))
    return min(panels)


ERRORS: dict[str, Error] = {
    "sum": lambda m, n: 1.2 / m + 16 / n**2,
    "rows": lambda m, n: 3 / m + 0.1 / n**2,
    "columns": lambda m, n: 0.05 / m + 300 / n**2,
    "larger": lambda m, n: max(1.2 / m, 16 / n**2),
    "slow": lambda m, n: 1.2 / m + 2 / n,
}


@pytest.mark.parametrize("name", ERRORS)
@pytest.mark.parametrize("surface", [0.3, 0.05])
def test_no_sheet_with_fewer_panels_does(name: str, surface: float) -> None:
    tolerance = Tolerance(surface=surface)
    _, choice = choose(sizes(ERRORS[name]), tolerance)
    assert choice.trial.error <= surface
    assert choice.trial.panels == fewest(ERRORS[name], tolerance)
    assert choice.designs_tried < 300


def rippled(rows: int, columns: int) -> float:
    """Errors that rise and fall with the number of columns, and are least with few rows."""
    return (0.1 + 0.02 * rows + 0.6 / columns**2) * (1 + 0.2 * math.cos(2.1 * columns + rows))


@pytest.mark.parametrize("surface", [0.13, 0.16, 0.2, 0.3])
def test_errors_that_do_not_fall_with_rows_or_columns(surface: float) -> None:
    # Ripples of 20 % to either side are a factor of 1.5 at most.
    asked = sizes(
        rippled,
        distance_from_f=lambda _: 0.0,
        distance_from_g=lambda _: 0.0,
        ripple=1.5,
        orderly=False,
    )
    tolerance = Tolerance(surface=surface)
    assert choose(asked, tolerance)[1].trial.panels == fewest(rippled, tolerance)


@settings(max_examples=10)
@given(st.floats(0.8, 1.0))
def test_a_quick_measure_that_is_too_kind_is_made_up_for(quick: float) -> None:
    tolerance = Tolerance(surface=0.05)
    _, choice = choose(sizes(ERRORS["sum"], quick), tolerance)
    assert choice.trial.error <= 0.05
    assert choice.trial.panels == fewest(ERRORS["sum"], tolerance)


def test_other_variants_are_tried_where_the_telling_ones_nearly_do() -> None:
    shares = {"telling": 1.0, "other": 0.9}

    def measure(variant: tuple[int, str], columns: int, careful: bool) -> Trial:
        rows, name = variant
        return Trial.of(rows, columns, shares[name] * ERRORS["sum"](rows, columns), 1.0, 1.0)

    tolerance = Tolerance(surface=0.3)
    (_, name), choice = choose(
        Sizes(
            variants=lambda rows: Variants([(rows, "telling")], [(rows, "other")]),
            distance_from_f=lambda variant: shares[variant[1]] * ERRORS["sum"](variant[0], 10**6),
            distance_from_g=lambda columns: 0.9 * ERRORS["sum"](10**6, columns),
            measure=measure,
        ),
        tolerance,
    )
    assert name == "other"
    assert choice.trial.panels == fewest(lambda *size: 0.9 * ERRORS["sum"](*size), tolerance)


def test_no_trial_of_the_tradeoff_is_beaten() -> None:
    _, choice = choose(sizes(ERRORS["sum"]), Tolerance(surface=0.05))
    panels = [trial.panels for trial in choice.tradeoff]
    errors = [trial.error for trial in choice.tradeoff]
    assert panels == sorted(set(panels))
    assert errors == sorted(errors, reverse=True)
    assert choice.trial in choice.tradeoff


@pytest.mark.parametrize(("least", "most"), [(0.3, 3), (0.0, 0.7), (0.35, 1.2)])
def test_panels_have_the_sizes_asked_for(least: float, most: float) -> None:
    tolerance = Tolerance(surface=0.2, panel_min=least, panel_max=most)
    trial = choose(sizes(ERRORS["sum"]), tolerance)[1].trial
    assert trial.shortest >= least
    assert trial.longest <= most
    assert trial.panels == fewest(ERRORS["sum"], tolerance)


def test_panels_fit_the_boards() -> None:
    def boards(rows: int, columns: int) -> BoardFit:
        return BoardFit(20 / columns / 1.5)

    asked = sizes(ERRORS["rows"], boards=boards)
    trial = choose(asked, Tolerance(surface=0.3))[1].trial
    # Columns are of no use to the distance, but these make panels as long as the boards.
    assert trial.columns == 14
    with pytest.raises(DesignError, match="no shell of this family") as caught:
        choose(replace(asked, boards=lambda *_: BoardFit(2.0)), Tolerance(surface=0.3))
    assert not list(caught.value.candidates)


@pytest.mark.parametrize("share", [0.5, 0.7, 0.78])
def test_boards_cover_as_much_as_is_asked(share: float) -> None:
    """Set-backs take the more of a panel the more of them there are; all sheets are tried."""

    def boards(rows: int, columns: int) -> BoardFit:
        return BoardFit(least_share=1 - 0.01 * rows - 0.004 * columns)

    tolerance = Tolerance(surface=0.3, least_share=share)
    trial = choose(sizes(ERRORS["sum"], boards=boards), tolerance)[1].trial
    does = [
        (m + 1) * (n - 1)
        for m in range(1, MOST_ROWS + 1, 2)
        for n in range(2, MOST_ROWS + 1)
        if ERRORS["sum"](m, n) <= 0.3 and boards(m, n).bare(tolerance) <= 1
    ]
    assert trial.panels == min(does)
    with pytest.raises(DesignError, match=r"cover at least 0\.95") as caught:
        choose(sizes(ERRORS["sum"], boards=boards), Tolerance(surface=0.3, least_share=0.95))
    offered = float(str(next(iter(caught.value.candidates)).changes["tolerance.least_share"]))
    assert offered == pytest.approx(max(1 - 0.01 * m - 0.004 * n for m, n in WITHIN), abs=0.02)
    nearest = Tolerance(surface=0.3, least_share=offered)
    assert choose(sizes(ERRORS["sum"], boards=boards), nearest)[1].trial.error <= 0.3


WITHIN = [
    (m, n)
    for m in range(1, MOST_ROWS + 1, 2)
    for n in range(2, MOST_ROWS + 1)
    if ERRORS["sum"](m, n) <= 0.3
]


def test_long_panels_do_where_square_ones_are_too_small() -> None:
    # Rows do not matter here: with few of them the panels are long enough.
    def error(rows: int, columns: int) -> float:
        return 10 / columns**2 + 1e-6 / rows

    _, choice = choose(sizes(error), Tolerance(surface=0.01, panel_min=0.5))
    assert choice.trial.panels == fewest(error, Tolerance(surface=0.01, panel_min=0.5))


def test_what_cannot_be_met_says_what_can() -> None:
    def error(rows: int, columns: int) -> float:
        return 0.1 + 1 / rows + 1 / columns

    with pytest.raises(DesignError) as caught:
        choose(sizes(error), Tolerance(surface=0.05))
    nearest = float(str(next(iter(caught.value.candidates)).changes["tolerance.surface"]))
    # With 201 rows and columns, the most that are tried.
    assert caught.value.excess == pytest.approx((0.1 + 2 / 201) / 0.05 - 1)
    assert choose(sizes(error), Tolerance(surface=nearest))
    with pytest.raises(DesignError, match="panel edges from 1 to"):
        choose(sizes(ERRORS["sum"]), Tolerance(surface=0.05, panel_min=1))


def test_a_target_out_of_reach_is_refused_for_its_own_reason() -> None:
    with pytest.raises(DesignError, match="does not cross"):
        choose(sizes(ERRORS["sum"], refuses=lambda *_: True), Tolerance(surface=0.05))


def test_sheets_that_cannot_be_made_are_passed_over() -> None:
    asked = sizes(ERRORS["sum"], refuses=lambda _, columns: columns < 12)
    assert choose(asked, Tolerance(surface=0.3))[1].trial.columns == 12


def test_few_are_tried_where_only_small_sheets_can_be_made() -> None:
    asked: list[tuple[int, int]] = []
    only_small = sizes(ERRORS["sum"], refuses=lambda m, n: m > 3 or n > 3, asked=asked)
    with pytest.raises(DesignError, match="comes within"):
        choose(only_small, Tolerance(surface=0.01, panel_min=1e-3))
    assert len(asked) < 40

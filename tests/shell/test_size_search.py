"""The search for the fewest panels, on errors given by a formula: all sheets can be tried there."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from orishell.errors import DesignError
from orishell.families.pattern import Tolerance
from orishell.shell.choice import Measured
from orishell.shell.size_search import MOST, choose

Error = Callable[[int, int], float]


def made(rows: int, columns: int) -> Any:
    """Stands for a design: the search only hands it on to the measure."""
    return rows, columns


def measuring(error: Error, quick: float = 1.0) -> Callable[[Any, bool], Measured]:
    """Errors by a formula, a share of them if quick; edges 10/(rows + 1) and 20/columns long."""

    def measure(design: Any, careful: bool) -> Measured:
        rows, columns = design
        edges = sorted((10 / (rows + 1), 20 / columns))
        return Measured(error(rows, columns) * (1 if careful else quick), *edges)

    return measure


def fewest(error: Error, tolerance: Tolerance) -> int:
    """Brute force: the fewest panels of all sheets that do."""
    measure = measuring(error)
    sizes = []
    for rows in range(1, MOST + 1, 2):
        for columns in range(2, MOST + 1):
            got = measure((rows, columns), True)
            if (
                got.error <= tolerance.surface
                and got.shortest >= tolerance.panel_min
                and got.longest <= tolerance.panel_max
            ):
                sizes.append((rows + 1) * (columns - 1))
    return min(sizes)


ERRORS: dict[str, Error] = {
    "sum": lambda m, n: 1.2 / m + 16 / n**2,
    "rows": lambda m, n: 3 / m + 0.1 / n**2,
    "columns": lambda m, n: 0.05 / m + 300 / n**2,
    "larger": lambda m, n: max(1.2 / m, 16 / n**2),
    "slow": lambda m, n: 1.2 / m + 2 / n,
}


@pytest.mark.parametrize("name", ERRORS)
@pytest.mark.parametrize("surface", [0.3, 0.05])
def test_the_choice_is_hardly_more_than_the_fewest_of_all(name: str, surface: float) -> None:
    tolerance = Tolerance(surface)
    choice = choose(made, measuring(ERRORS[name]), tolerance)
    assert choice.trial.error <= surface
    assert choice.trial.panels <= 1.08 * fewest(ERRORS[name], tolerance)
    assert choice.tried < 120


@given(st.floats(0.5, 1.0))
def test_a_quick_measure_that_is_too_kind_is_made_up_for(quick: float) -> None:
    tolerance = Tolerance(0.05)
    choice = choose(made, measuring(ERRORS["sum"], quick), tolerance)
    assert choice.trial.error <= 0.05
    assert choice.trial.panels <= 1.3 * fewest(ERRORS["sum"], tolerance)


def test_no_trial_of_the_tradeoff_is_beaten() -> None:
    choice = choose(made, measuring(ERRORS["sum"]), Tolerance(0.05))
    panels = [trial.panels for trial in choice.tradeoff]
    errors = [trial.error for trial in choice.tradeoff]
    assert panels == sorted(set(panels))
    assert errors == sorted(errors, reverse=True)
    assert (choice.trial.rows, choice.trial.columns) in {
        (trial.rows, trial.columns) for trial in choice.tradeoff
    }


@pytest.mark.parametrize(("least", "most"), [(0.3, 3), (0.0, 0.7), (0.35, 1.2)])
def test_panels_have_the_sizes_asked_for(least: float, most: float) -> None:
    tolerance = Tolerance(0.2, least, most)
    trial = choose(made, measuring(ERRORS["sum"]), tolerance).trial
    assert trial.shortest >= least
    assert trial.longest <= most
    assert trial.panels <= 1.15 * fewest(ERRORS["sum"], tolerance)


def test_long_panels_do_where_square_ones_are_too_small() -> None:
    # Rows do not matter here: with few of them the panels are long enough.
    def error(rows: int, columns: int) -> float:
        return 10 / columns**2 + 1e-6 / rows

    choice = choose(made, measuring(error), Tolerance(0.01, panel_min=0.5))
    assert choice.trial.error <= 0.01
    assert choice.trial.shortest >= 0.5


def test_what_cannot_be_met_says_what_can() -> None:
    with pytest.raises(DesignError) as caught:
        choose(made, measuring(lambda m, n: 0.1 + 1 / m + 1 / n), Tolerance(0.05))
    nearest = float(str(next(iter(caught.value.candidates)).changes["tolerance.surface"]))
    # With 201 rows and columns, the most that are tried.
    assert caught.value.excess == pytest.approx((0.1 + 2 / 201) / 0.05 - 1)
    assert choose(made, measuring(lambda m, n: 0.1 + 1 / m + 1 / n), Tolerance(nearest))
    with pytest.raises(DesignError, match="panel edges from 1 to"):
        choose(made, measuring(ERRORS["sum"]), Tolerance(0.05, panel_min=1))


def test_a_target_out_of_reach_is_refused_for_its_own_reason() -> None:
    def refused(rows: int, columns: int) -> Any:
        raise DesignError("f turns too far")

    with pytest.raises(DesignError, match="f turns too far"):
        choose(refused, measuring(ERRORS["sum"]), Tolerance(0.05))


def test_sheets_that_cannot_be_made_are_passed_over() -> None:
    def sometimes(rows: int, columns: int) -> Any:
        if columns < 12:
            raise DesignError("f's plane does not cross the chord of g")
        return rows, columns

    choice = choose(sometimes, measuring(ERRORS["sum"]), Tolerance(0.3))
    assert choice.trial.columns >= 12


def test_long_panels_are_given_up_after_a_dozen_refusals() -> None:
    asked: list[tuple[int, int]] = []

    def only_small(rows: int, columns: int) -> Any:
        asked.append((rows, columns))
        if rows > 3 or columns > 3:
            raise DesignError("neighbouring rows meet inside the sheet")
        return rows, columns

    with pytest.raises(DesignError, match="comes within"):
        choose(only_small, measuring(ERRORS["sum"]), Tolerance(0.01, panel_min=1e-3))
    # Two ladders of ten, of which the first stands still, and what follows the crossings' start.
    assert len(asked) < 40

"""What fewer panels cost: sizes tried, the best of them, and tolerances that they can meet."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from orishell.conventions.errors import DesignError
from orishell.conventions.toml_file import parse_toml
from orishell.design_file import DesignFile, check_design, starter_file
from orishell.shell import tradeoff
from orishell.shell.size_trials import measure, unbeaten
from orishell.shell.tolerance import meet_tolerance
from orishell.shell.tradeoff import Tradeoff, find_tradeoff

FAMILY = "orthodiagonal"


def design_of(**tables: Any) -> DesignFile:
    design = {**parse_toml(starter_file(FAMILY)), **tables}
    return check_design(design, Path("shell.toml"), files=False)


@pytest.fixture(scope="module", autouse=True)
def _few() -> Iterator[None]:
    """Small sheets will do: larger ones only take longer."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(tradeoff, "MOST_PANELS", 60)
        yield


@pytest.fixture(scope="module")
def found() -> Tradeoff:
    return find_tradeoff(design_of())


def test_the_best_are_measured_as_the_report_does(found: Tradeoff) -> None:
    file = design_of()
    assert found.best == unbeaten(found.best)
    for trial in found.best[:2]:
        design = file.pattern.sized(trial.rows, trial.columns).design(file.f, file.g)
        assert measure(design, careful=True).error == trial.error
    sizes = {(trial.rows, trial.columns) for trial in found.tried}
    assert (file.pattern.rows, file.pattern.columns) in sizes
    assert {(trial.rows, trial.columns) for trial in found.best} <= sizes


def test_a_tolerance_of_the_best_is_met_with_no_more_panels(found: Tradeoff) -> None:
    pattern = {
        key: value
        for key, value in parse_toml(starter_file(FAMILY))["pattern"].items()
        if key not in {"rows", "columns"}
    }
    for trial in (found.best[0], found.best[-1]):
        file = design_of(pattern=pattern, tolerance={"surface": 1.001 * trial.error})
        assert file.tolerance is not None
        _, choice = meet_tolerance(file, file.tolerance)
        assert choice.trial.panels <= trial.panels


def test_progress_is_told_to_its_end() -> None:
    told: list[tuple[float, str]] = []
    pattern = {"depth": 0.12, "placement": "balanced"}
    limits = {"surface": 1.0, "panel_max": 1.2}
    file = design_of(pattern=pattern, tolerance=limits)
    found = find_tradeoff(file, lambda share, what: told.append((share, what)))
    shares = [share for share, _ in told]
    assert shares == sorted(shares)
    assert shares[-1] == 1.0
    assert len({what for _, what in told}) == 2
    # Edges of the best are as long as they may be; those of others may be longer.
    assert max(trial.longest for trial in found.best) <= 1.2
    assert max(trial.longest for trial in found.tried) > 1.2


def test_edges_that_no_sheet_has_are_refused() -> None:
    pattern = {"depth": 0.12}
    file = design_of(pattern=pattern, tolerance={"surface": 1.0, "panel_min": 50.0})
    with pytest.raises(DesignError, match="no sheet has panel edges from 50") as caught:
        find_tradeoff(file)
    assert "tolerance.panel_min" in caught.value.keys


def test_what_the_family_refuses_at_every_size_is_refused_for_its_own_reason() -> None:
    pattern = {"depth": 3.0, "rows": 9, "columns": 13}
    with pytest.raises(DesignError, match="depth"):
        find_tradeoff(design_of(pattern=pattern))

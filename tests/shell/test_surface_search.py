"""The fewest panels for a surface: few sizes are tried, from coarse to fine."""

from __future__ import annotations

import math

import pytest

from orishell.conventions.errors import DesignError
from orishell.conventions.progress import Progress, no_progress
from orishell.families.tolerance import Tolerance
from orishell.shell.size_trials import Trial
from orishell.shell.surface_search import FITS, MOST, SurfaceSearch


def searched(surface: float, *, refused: int = 0, panel_max: float = math.inf) -> SurfaceSearch:
    """A search among sheets whose error falls with their panels: 1 over their number."""

    def measure(rows: int, columns: int, _: Progress) -> tuple[Trial, float]:
        if columns < refused:
            raise DesignError("too coarse")
        count = columns + 1
        error, edge = 1 / count, 2 / count
        return Trial(rows, columns, (rows + 1) * count, error, 0.5 * edge, edge), 0.0

    limits = Tolerance(surface=surface, panel_max=panel_max)
    return SurfaceSearch(measure, (2.0, 1.0), limits, no_progress)


@pytest.mark.parametrize("count", [4, 5, 8, 13, 20, 31])
def test_fewest_panels_are_found(count: int) -> None:
    choice = searched(1.001 / count).run()
    assert choice.trial.columns == count - 1
    assert choice.trial.rows == max(4, round(count / 2)) - 1
    assert choice.designs_tried <= FITS


def test_sizes_that_are_refused_are_passed_over() -> None:
    choice = searched(0.1, refused=12).run()
    assert choice.trial.columns == 12


def test_long_panels_ask_for_more_of_them() -> None:
    assert searched(0.2, panel_max=0.1001).run().trial.columns == 19


def test_what_cannot_be_met_is_refused_with_what_can() -> None:
    with pytest.raises(DesignError) as refused:
        searched(0.5 / MOST).run()
    remedy = next(iter(refused.value.candidates))
    assert remedy.changes == {"tolerance.surface": pytest.approx(1.05 / MOST, rel=1e-3)}

"""The fewest panels for a surface: few sizes are tried, from coarse to fine."""

from __future__ import annotations

import pytest

from orishell.conventions.errors import DesignError
from orishell.conventions.progress import Progress, no_progress
from orishell.families.tolerance import Tolerance
from orishell.shell.board_limits import BoardFit
from orishell.shell.size_trials import Trial
from orishell.shell.surface_search import FITS, MOST_PANELS, SurfaceSearch


def searched(surface: float, *, refused: int = 0, **edges: float) -> SurfaceSearch:
    """A search among sheets whose error falls with their panels: 1 over their number.

    Boards cover a hundredth less of each for each of them along the surface.
    """

    def measure(rows: int, columns: int, _: Progress) -> tuple[Trial, BoardFit]:
        if columns < refused:
            raise DesignError("too coarse")
        count = columns + 1
        error, edge = 1 / count, 2 / count
        return Trial(rows, columns, (rows + 1) * count, error, 0.5 * edge, edge), BoardFit(
            least_share=1 - 0.01 * count
        )

    limits = Tolerance(surface=surface, **edges)
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


def test_panels_that_are_too_small_ask_for_fewer() -> None:
    """5 panels along the surface have edges of 0.2 and boards of 0.95 at least; 4 come too far."""
    assert searched(0.201, panel_min=0.2).run().trial.columns == 4
    assert searched(0.201, least_share=0.95).run().trial.columns == 4


def test_boards_that_cover_too_little_are_refused_with_what_they_do() -> None:
    with pytest.raises(DesignError, match=r"cover at least 0\.96") as refused:
        searched(0.201, least_share=0.96).run()
    (remedy,) = refused.value.candidates
    assert remedy.changes == {"tolerance.least_share": 0.95}
    assert searched(0.201, least_share=0.95).run().trial.columns == 4


def test_what_cannot_be_met_is_refused_with_what_can() -> None:
    with pytest.raises(DesignError) as refused:
        searched(0.5 / MOST_PANELS).run()
    remedy = next(iter(refused.value.candidates))
    assert remedy.changes == {"tolerance.surface": pytest.approx(1.05 / MOST_PANELS, rel=1e-3)}

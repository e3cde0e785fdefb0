"""What is too large is said before a sheet is fitted, and nothing is refused that would do.

The bound is the mean of panels that cover a share of the surface: exact arithmetic on its area,
which is that of a plane rectangle here.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import orishell.families.flat_foldable.fit.design as fits
import orishell.families.flat_foldable.pattern as flat_foldable
from orishell.conventions.errors import DesignError, InputError
from orishell.conventions.quantities import MILLIMETRES
from orishell.design_file.file import check_design
from orishell.design_file.tables import with_values
from orishell.families.flat_foldable.fit.design import COVERED
from orishell.shell.board_limits import as_cut
from orishell.shell.designed import designed
from orishell.shell.make import make_shell
from orishell.shell.steps import STEPS
from orishell.workshop.fitting import OversizeError
from orishell.workshop.layout import require_stock

ROWS, COLUMNS = 3, 4
PANELS = (ROWS + 1) * (COLUMNS + 1)
WIDE, HIGH = 6.0, 4.0
LEAST = COVERED * WIDE * HIGH / PANELS
"""The area that the largest panel has at least."""
BOARDS = {"thickness": 0.003, "membrane": 0.0005}


def _tables(**changes: Any) -> dict[str, Any]:
    surface = {
        "vertices": [[x, y, z] for x, y, z in _corners()],
        "triangles": [[0, 1, 2], [0, 2, 3]],
    }
    tables: dict[str, Any] = {
        "shell": {"family": "flat-foldable", "unit": "m"},
        "target": {"surface": surface},
        "pattern": {"rows": ROWS, "columns": COLUMNS, "direction_deg": 0, "fold_deg": 92},
        "workshop": {},
    }
    changed: dict[str, Any] = with_values(
        tables, {key.replace("__", "."): each for key, each in changes.items()}
    )
    return changed


def _corners(scale: float = 1.0) -> Iterator[tuple[float, float, float]]:
    for x, y in ((0, 0), (1, 0), (1, 1), (0, 1)):
        yield scale * WIDE * x, scale * HIGH * y, 0.0


def _file(tables: dict[str, Any]) -> Any:
    return check_design(tables, Path("x.toml"))


class FitError(Exception):
    """A fit was begun."""


@pytest.fixture
def unfitted(monkeypatch: pytest.MonkeyPatch) -> None:
    def begun(*_: Any, **__: Any) -> None:
        raise FitError

    monkeypatch.setattr(flat_foldable, "design_fitted", begun)


@pytest.mark.parametrize("sold", ["stock", "roll", "margin"])
def test_what_no_panel_can_fit_is_refused_before_the_fit(unfitted: None, sold: str) -> None:
    """Just below the bound it is refused, just above it the fit begins."""
    key = "workshop.roll" if sold == "roll" else "workshop.stock"
    rim = 0.01 if sold == "margin" else 0.0
    panel = {"panel": BOARDS} if sold == "roll" else {}
    for factor in (0.999, 1.001):
        sides = [0.5 + 2 * rim, factor * LEAST / 0.5 + 2 * rim]
        given = {key.replace(".", "__"): sides, "workshop__margin": rim, **panel}
        file = _file(_tables(**given))
        if factor > 1:
            with pytest.raises(FitError):
                make_shell(file)
            continue
        with pytest.raises(InputError, match=f"the {sold if rim == 0 else 'stock'} is too") as said:
            make_shell(file)
        assert said.value.keys == (key,)
        assert "6 x 4 m" in said.value.what
        # So many panels are needed at least: with one less each would still be too large.
        assert f"{PANELS + 1} panels or more" in said.value.remedy
        # The first rows and columns, as many times each, that come to so many.
        rows, columns = map(int, re.findall(r"= (\d+)", said.value.remedy))
        assert (rows + 1) * (columns + 1) > PANELS
        assert (rows, columns) == (ROWS + 1, COLUMNS + 1)


def test_what_is_refused_before_is_refused_after_the_fit() -> None:
    """By the layout itself, where nobody asks before: at the bound, and far beyond it."""
    stock = [0.5, 0.999 * LEAST / 0.5]
    file = _file(_tables(workshop__stock=stock))
    with pytest.raises(InputError, match="too small for panels"):
        make_shell(file)
    with pytest.raises(OversizeError):
        require_stock(as_cut(file, designed(file)), file.workshop)


@pytest.mark.parametrize(
    "changes",
    [
        {"target__fit": {"width": 1.0}},  # the target is scaled
        {"panel": {"thickness": 0.01, "construction": "bevel", "gap": 0.01}},  # no sheet is cut
        {"tolerance": {"surface": 0.5}, "pattern__rows": None, "pattern__columns": None},
    ],
)
def test_nothing_is_refused_of_which_nothing_is_known(
    unfitted: None, changes: dict[str, Any]
) -> None:
    with pytest.raises((FitError, DesignError)):
        make_shell(_file(_tables(workshop__stock=[0.1, 0.1], **changes)))


def test_without_the_layout_no_stock_is_asked_for(unfitted: None) -> None:
    with pytest.raises(FitError):
        make_shell(_file(_tables(workshop__stock=[0.1, 0.1])), skip=STEPS)


def test_a_sheet_that_does_not_cover_its_surface_is_refused(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The bound rests on it. A corrugated sheet has more area than its surface, not 10 times."""
    monkeypatch.setattr(fits, "COVERED", 10.0)
    with pytest.raises(DesignError, match="covers the surface") as refused:
        make_shell(_file(_tables()), skip=["remedies"])
    assert refused.value.excess is not None
    assert 2 < refused.value.excess < 9


DRAWN = [("m", 1000.0, "mm"), ("mm", 1.0, "m"), ("m", 100.0, "mm"), ("cm", 1e5, None)]


@pytest.mark.parametrize(("unit", "factor", "meant"), DRAWN)
def test_the_unit_of_a_mesh_is_asked_where_nobody_builds_its_size(
    unit: str, factor: float, meant: str | None
) -> None:
    """Of 6 x 4 in the design's unit, enlarged: with the unit that is asked about it is likely."""
    tables = _tables(shell__unit=unit)
    tables["target"]["surface"]["vertices"] = [list(each) for each in _corners(factor)]
    notes = _file(tables).notes
    if meant is None:
        assert notes == ()
        return
    (note,) = notes
    assert f"was it drawn in {meant}?" in note
    said = _file(with_values(tables, {"target.surface.unit": meant}))
    assert said.notes == ()
    assert said.surface is not None
    assert 0.5 <= said.surface.size() * MILLIMETRES[unit] / 1000 <= 200
    # Nor is anything asked where somebody says so, or sizes are asked for.
    assert _file(with_values(tables, {"target.surface.unit": unit})).notes == ()
    assert _file(with_values(tables, {"target.fit": {"width": 6.0}})).notes == ()


@pytest.mark.parametrize("factor", [0.1, 1.0, 50.0])
def test_no_unit_is_asked_of_what_is_built(factor: float) -> None:
    """A model of 0.6 m, a canopy of 6 m, a hall of 300 m."""
    tables = _tables()
    tables["target"]["surface"]["vertices"] = [list(each) for each in _corners(factor)]
    assert _file(tables).notes == ()


def test_the_unit_is_the_remedy_where_it_mends_the_stock(unfitted: None) -> None:
    tables = _tables(workshop__stock=[3.0, 1.5])
    tables["target"]["surface"]["vertices"] = [list(each) for each in _corners(1000.0)]
    with pytest.raises(InputError) as refused:
        make_shell(_file(tables))
    assert refused.value.changes == {"target.surface.unit": "mm"}
    assert refused.value.remedy.endswith("then it is 6 x 4 m")
    with pytest.raises(FitError):
        make_shell(_file(with_values(tables, refused.value.changes)))

"""Rows and columns that are offered where panels are too large for their stock fit it, typed in."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from design_tables import Tables, formula, tables
from orishell.design_file import DesignFile, check_design
from orishell.document.from_design import document_of_design
from orishell.shell import candidate, more_panels
from orishell.shell.board_limits import as_cut
from orishell.shell.designed import designed
from orishell.shell.make import make_shell
from orishell.shell.steps import MEASURES
from orishell.workshop.fitting import OversizeError, find_turns
from orishell.workshop.layout import require_stock
from samples import THOROUGH

RECTANGLE = [[x, y, 0.0] for x, y in ((0, 0), (6, 0), (6, 4), (0, 4))]
ROOF: Tables = {
    "shell": {"family": "flat-foldable", "unit": "m"},
    "target": {"surface": {"vertices": RECTANGLE, "triangles": [[0, 1, 2], [0, 2, 3]]}},
    "pattern": {"rows": 3, "columns": 4, "direction_deg": 0, "fold_deg": 92},
    "motion": {"frames": 3},
}
BOARDS = {"panel": {"thickness": 0.003, "membrane": 0.0005}}


def refusal(file: DesignFile) -> OversizeError:
    with pytest.raises(OversizeError) as refused:
        make_shell(file, skip=MEASURES)
    return refused.value


def all_fit(file: DesignFile) -> bool:
    """Whether every panel fits the stock, turned somehow."""
    document = document_of_design(designed(file), file.unit)
    panels = document.require_flat()[document.mesh.faces]
    return all(len(find_turns(each, *file.workshop.usable_stock)) for each in panels)


def swept(number: int) -> DesignFile:
    """An arch of 2 to 4 m of few panels, on stock that holds few of them."""
    random = np.random.default_rng(number)
    low, high = random.uniform(0.3, 0.9, 2)
    f = formula(f"-{random.uniform(0.5, 1):.3g}*x**2", -1, 1)
    g = formula(f"{random.uniform(0.2, 0.5):.3g}*sin(pi*x/2)", 0, 4)
    rows, columns = random.choice([3, 5, 7]), random.choice([4, 6, 9])
    design = tables("parallel-repeating", f, g, rows=int(rows), columns=int(columns), flap=0)
    design["workshop"] = {"stock": [float(low), float(high)]}
    return check_design(design, Path("arch.toml"))


def test_what_is_offered_fits() -> None:
    """Where no sheet of more panels can be made nothing is offered: of one in ten."""
    offered, numbers = 0, range(1, 60 if THOROUGH else 6)
    for number in numbers:
        file = swept(number)
        assert not all_fit(file)
        error = refusal(file)
        if not error.changes:
            continue
        offered += 1
        rows, columns = (error.changes[f"pattern.{key}"] for key in ("rows", "columns"))
        assert f"rows = {rows} with columns = {columns}" in error.remedy
        assert "not examined" in error.remedy
        assert all_fit(file.changed(error.changes))
    assert offered >= 0.8 * len(numbers)


def test_a_fitted_sheet_is_refused_before_its_proof_by_all_that_is_too_small_for_it(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Roll and stock at once: with larger ones of both it is made. Or with more panels."""
    design = {**ROOF, **BOARDS, "workshop": {"roll": [1.1, 20], "stock": [1.3, 0.9]}}
    file = check_design(design, Path("roof.toml"))

    def begun(*_: Any, **__: Any) -> None:
        raise AssertionError("a proof was begun")

    with monkeypatch.context() as patched:
        patched.setattr(candidate, "ended", begun)
        error = refusal(file)
    assert error.keys == ("workshop.roll", "workshop.stock")
    assert "do not fit the roll" in error.what
    assert "do not fit the stock" in error.what
    assert error.remedy.startswith("larger rolls and stock, or rows = ")
    larger = file.changed({key: list(sides) for key, sides in error.needed.items()})
    require_stock(as_cut(larger, designed(larger)), larger.workshop)
    finer = file.changed(error.changes)
    assert finer.pattern.rows > file.pattern.rows
    require_stock(as_cut(finer, designed(finer)), finer.workshop)


def test_nothing_is_offered_once_time_is_over(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(more_panels, "SECONDS", -1.0)
    error = refusal(check_design({**ROOF, "workshop": {"stock": [1.3, 0.9]}}, Path("roof.toml")))
    assert not error.changes
    assert error.remedy == "larger stock, or more rows or columns"


def test_flaps_of_no_given_width_are_refused_by_what_the_proof_leaves_of_them() -> None:
    """Their panels become narrower in it, so that nothing is said before."""
    file = swept(0).changed({"pattern.flap": "auto"})
    called = []

    def counted(*arguments: Any, **more: Any) -> Any:
        called.append(1)
        return ended(*arguments, **more)

    ended = candidate.ended
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(candidate, "ended", counted)
        refusal(file)
    assert called

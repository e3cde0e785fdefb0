"""The example that carries with gussets: what it says of itself."""

from __future__ import annotations

import pytest

from documents import EXAMPLES
from orishell.design_file import read_design_file
from orishell.shell.instead import shell_of
from orishell.shell.steps import MEASURES, Work
from orishell.structure.results import Analysis
from samples import thorough

FILE = EXAMPLES / "shelter_gussets.toml"


def analysed(**keys: object) -> Analysis:
    """Its analysis, with keys that differ."""
    work = Work(clash="unexamined", skip=(*MEASURES, "stock", "verification"))
    changed = {key.replace("__", "."): value for key, value in keys.items()}
    analysis = shell_of(read_design_file(FILE).changed(changed), work).analysis
    assert analysis is not None
    return analysis


def test_loads_are_those_of_the_shelter_that_fails() -> None:
    mine, other = (
        read_design_file(EXAMPLES / f"{name}.toml").tables["load_case"]
        for name in (FILE.stem, "shelter_structure")
    )
    assert mine == other


@thorough
@pytest.mark.slow
def test_it_carries_with_gussets_and_not_without() -> None:
    """481.2 kg, 143 gussets in them; crease lines use 37.4 %, edges of gussets 85.7 %.

    Where nobody says what holds these, it is not known whether it carries.
    """
    with_them = analysed()
    assert len(with_them.model.design.plates) == 143
    assert with_them.model.mass == pytest.approx(481.2, abs=0.05)
    assert with_them.carries is True
    assert with_them.governs is not None
    assert with_them.governs.part == "plate_edges"
    assert with_them.governs.utilisation == pytest.approx(0.857, abs=0.005)
    lines = [found.utilisation.lines for found, _ in with_them.balanced]
    assert max(each or 0.0 for each in lines) == pytest.approx(0.374, abs=0.005)
    unfixed = analysed(structure__edge_strength=None)
    assert unfixed.carries is None
    assert {found.unknown for found, _ in unfixed.balanced} == {("plate_edges",)}
    without = analysed(stiffeners=None)
    assert [case.carries for case in without.cases] == [False] * 5

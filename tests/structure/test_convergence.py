"""How the analysis comes nearer as cells shrink."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from orishell.conventions.progress import Progress
from orishell.deployment import Site
from orishell.deployment.feet import find_feet
from orishell.design_file import read_design_file
from orishell.structure import refine
from orishell.structure.analyse import analyse
from orishell.structure.changes import ENOUGH, Figures
from orishell.structure.load_settings import LoadCase, Snow
from orishell.structure.results import Analysis
from orishell.structure.settings import Structure, Support
from samples import thorough

CASES = (LoadCase(name="own weight", self_weight=True),)
RIGID = (np.inf, np.inf)
PINNED = (Support(at="feet", kind="pinned"),)
STRUCTURE = Structure(
    modulus=8e9, poisson=0.3, supports=PINNED, cases=CASES, thickness=0.01
).replace_unchecked(crease_stiffness=RIGID)
EXAMPLES = Path(__file__).parents[2] / "examples"


def analysed(cells: int, share: float = 0.0) -> Analysis:
    """Figure 2's shell with rigid creases under its own weight."""
    file = read_design_file(EXAMPLES / "figure2.toml")
    design = file.pattern.sized(7, 9).model_copy(update={"flap": 0}).design(file.f, file.g)
    feet = find_feet(design)
    assert feet is not None
    asked = STRUCTURE.replace_unchecked(cells=cells, refine=share)
    return analyse(design, asked, Site("m", feet, (), 6.0))


def largest(cells: int) -> float:
    """Largest displacement."""
    (case,) = analysed(cells).cases
    assert case.equilibrium is not None
    return case.equilibrium.displacement.size


@thorough
def test_order_of_convergence(record_property: Callable[[str, object], None]) -> None:
    """Differences fall by 4 at least, which is order 2, as for linear strains in a smooth field.

    Faster from coarse meshes, whose cells are not yet as narrow at creases as those of fine ones:
    orders 4.3 and 2.7 were found.
    """
    sizes = np.array([largest(cells) for cells in (2, 4, 8, 16)])
    steps = np.abs(np.diff(sizes))
    orders = np.log2(steps[:-1] / steps[1:])
    record_property("orders", orders.tolist())
    assert orders.min() > 1.9, orders


def settling(cells: int) -> Figures:
    """Figures that are off by as much as the square of a cell."""
    off = 1 + cells**-2.0
    return Figures(off, off, off)


def test_cells_become_finer_until_figures_change_little() -> None:
    """With errors of 1/n^2 the change from 4 to 6 is 3.4 %, from 6 to 8 it is 1.2 %."""
    model = analysed(1).model
    runs: list[tuple[int, bool]] = []
    said: list[str] = []

    def run(cells: int, told: Progress, *, last: bool) -> Any:
        runs.append((cells, last))
        told(0.5, "")
        return replace(model, cells=cells), ["case"], [settling(cells)]

    def watch(share: float, what: str) -> None:
        assert 0 <= share <= 1
        said.append(what)

    asked = replace(model, structure=STRUCTURE.replace_unchecked(cells=3, refine=0.02))
    found, cases, change, stopped = refine.refined(asked, run, watch)
    assert found.cells == 8
    assert (len(cases), stopped) == (1, None)
    assert change.largest == pytest.approx((1 / 36 - 1 / 64) / (1 + 1 / 64))
    fine = [cells for cells, last in runs if last]
    assert fine == [3, 4, 6, 8]
    assert [cells for cells, last in runs if not last] == [2]
    assert said[-1] == "with 8 x 8 cells to a panel"


def test_refinement_ends_before_it_takes_too_long(monkeypatch: pytest.MonkeyPatch) -> None:
    """What a mesh would take is predicted, by its size alone; the best so far is kept."""
    monkeypatch.setattr(refine, "SECONDS", 0.5)
    found = analysed(2, 1e-6)
    assert found.model.stopped == "work"
    assert found.model.cells in {2, 3, 4, 6}
    assert 0 < found.model.change.largest < 1
    (said,) = [text for text in found.warnings if "refinement" in text]
    assert "finer cells would take too long" in said
    monkeypatch.setattr(refine, "MEMORY", 0)
    assert analysed(2, 1e-6).model.stopped == "memory"
    assert analysed(2).model.stopped is None


def stresses(path: Path, cells: int, structure: Structure, **pattern: object) -> list[float]:
    """The largest stress of every case and stiffness."""
    file = read_design_file(path)
    design = file.pattern.model_copy(update={"flap": 0, **pattern}).design(file.f, file.g)
    feet = find_feet(design)
    assert feet is not None
    found = analyse(design, structure.replace_unchecked(cells=cells), Site("m", feet, (), 6.0))
    return [balanced.stress.size for balanced, _ in found.balanced]


@thorough
def test_stress_does_not_grow_with_finer_cells() -> None:
    """Figure 2's shell, pinned at points, under snow: within 10 %, 0.2 % seen."""
    snow = (LoadCase(name="snow", snow=Snow(ground=850, arrangement="undrifted")),)
    asked = STRUCTURE.replace_unchecked(cases=snow)
    figure = EXAMPLES / "figure2.toml"
    (coarse,), (fine,) = (stresses(figure, cells, asked, rows=7, columns=9) for cells in (4, 8))
    assert fine == pytest.approx(coarse, rel=0.1)


BUS_SHELTER = """
[shell]
family = "orthodiagonal"
unit = "m"
[target.f]
formula = ["1.05*cos(t)", "2.25*sin(t)"]
range = [0, 3.141592653589793]
[target.g]
formula = "0.1*cos(2*pi*x)"
range = [0, 4]
[pattern]
rows = 11
columns = 9
flap = 0
depth = 0.16
heading_deg = 90
spacing = "equal"
"""


@thorough
def test_stress_of_a_bus_shelter_settles(
    tmp_path: Path, record_property: Callable[[str, object], None]
) -> None:
    """Solid panels of 12 mm under snow, free and rigid creases: 4, 8 and 16 cells.

    4 cells are within 15 % of finer ones, 14 % seen where creases are rigid. What governs is within
    1 %, and so are 8 and 16 cells but for 3 % where creases are rigid.
    """
    (tmp_path / "bus.toml").write_text(BUS_SHELTER)
    cases = (LoadCase(name="snow", snow=Snow(ground=850, arrangement="undrifted")),)
    asked = STRUCTURE.replace_unchecked(
        cases=cases, thickness=0.012, crease_stiffness=(0.0, np.inf)
    )
    found = np.array([stresses(tmp_path / "bus.toml", cells, asked) for cells in (4, 8, 16)])
    record_property("stresses", found.tolist())
    assert (found.max(axis=0) < 1.15 * found.min(axis=0)).all(), found
    np.testing.assert_allclose(found[1], found[2], rtol=0.05)
    largest = found.max(axis=1)
    assert largest.max() < 1.1 * largest.min()


@thorough
def test_more_is_missing_than_few_cells_change(
    tmp_path: Path, record_property: Callable[[str, object], None]
) -> None:
    """The bus shelter of solid panels with free creases, from so many cells to 12.

    With 3 cells more of its displacement is missing than three quarters of three times the change
    (3.2 times seen, against 16 cells), with 6 no more than 1.5 times (1.3 seen).
    """
    (tmp_path / "bus.toml").write_text(BUS_SHELTER)
    file = read_design_file(tmp_path / "bus.toml")
    design = file.pattern.design(file.f, file.g)
    feet = find_feet(design)
    assert feet is not None
    snow = (
        LoadCase(name="snow", snow=Snow(ground=850, arrangement="undrifted"), self_weight=True),
    )
    asked = STRUCTURE.replace_unchecked(cases=snow, thickness=0.012, crease_stiffness=(0.0, 0.0))
    sizes = {}
    for cells in (2, 3, 4, 6, 12):
        found = analyse(design, asked.replace_unchecked(cells=cells), Site("m", feet, (), 6.0))
        ((balanced, _),) = found.balanced
        sizes[cells] = balanced.displacement.size
    record_property("displacements", list(sizes.values()))

    def missing(cells: int) -> float:
        change = abs(sizes[cells] - sizes[refine.coarser(cells)])
        return float(abs(sizes[12] - sizes[cells]) / change)

    assert 9 / 4 < missing(3) < 3.5
    assert missing(ENOUGH) < 1.5

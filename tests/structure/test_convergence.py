"""How the analysis comes nearer as cells shrink."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from orishell.deployment import Site
from orishell.deployment.feet import find_feet
from orishell.design_file import read_design_file
from orishell.structure.analyse import analyse
from orishell.structure.load_settings import LoadCase, Snow
from orishell.structure.settings import Structure, Support
from samples import thorough

CASES = (LoadCase(name="own weight", self_weight=True),)
RIGID = (np.inf, np.inf)
PINNED = (Support(at="feet", kind="pinned"),)
STRUCTURE = Structure(
    modulus=8e9, poisson=0.3, supports=PINNED, cases=CASES, thickness=0.01
).having(crease_stiffness=RIGID)
EXAMPLES = Path(__file__).parents[2] / "examples"


def largest(cells: int, refine: float = 0.0) -> tuple[float, float, int]:
    """Largest displacement with rigid creases, what changed, and the number of triangles."""
    file = read_design_file(EXAMPLES / "figure2.toml")
    design = file.pattern.sized(7, 9).model_copy(update={"flap": 0}).design(file.f, file.g)
    feet = find_feet(design)
    assert feet is not None
    asked = STRUCTURE.having(cells=cells, refine=refine)
    found = analyse(design, asked, Site("m", feet, (), 6.0))
    (case,) = found.cases
    assert case.equilibrium is not None
    size = float(np.linalg.norm(case.equilibrium.displacements, axis=1).max())
    return size, found.model.change, found.model.triangles


@thorough
def test_order_of_convergence(record_property: Callable[[str, object], None]) -> None:
    """Differences fall by 4 where the order is 2, as for linear strains in a smooth field."""
    sizes = np.array([largest(cells)[0] for cells in (2, 4, 8, 16)])
    steps = np.abs(np.diff(sizes))
    orders = np.log2(steps[:-1] / steps[1:])
    record_property("orders", orders.tolist())
    assert 1.5 < orders[-1] < 2.5, orders


def test_cells_are_halved_until_displacements_change_little() -> None:
    coarse, change, count = largest(2)
    fine, after, more = largest(2, 0.03)
    assert change > 0.03 > after
    assert more in {4 * count, 16 * count, 64 * count}
    assert abs(fine - coarse) <= 1.5 * change * fine


def stresses(path: Path, cells: int, structure: Structure, **pattern: object) -> list[float]:
    """The largest stress of every case and stiffness."""
    file = read_design_file(path)
    design = file.pattern.model_copy(update={"flap": 0, **pattern}).design(file.f, file.g)
    feet = find_feet(design)
    assert feet is not None
    found = analyse(design, structure.having(cells=cells), Site("m", feet, (), 6.0))
    return [balanced.stress.size for balanced, _ in found.balanced]


def test_stress_does_not_grow_with_finer_cells() -> None:
    """Figure 2's shell, pinned at points, under snow: within 10 %, 0.2 % seen."""
    snow = (LoadCase(name="snow", snow=Snow(ground=850)),)
    asked = STRUCTURE.having(cases=snow)
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
    cases = (LoadCase(name="snow", snow=Snow(ground=850)),)
    asked = STRUCTURE.having(cases=cases, thickness=0.012, crease_stiffness=(0.0, np.inf))
    found = np.array([stresses(tmp_path / "bus.toml", cells, asked) for cells in (4, 8, 16)])
    record_property("stresses", found.tolist())
    assert (found.max(axis=0) < 1.15 * found.min(axis=0)).all(), found
    np.testing.assert_allclose(found[1], found[2], rtol=0.05)
    largest = found.max(axis=1)
    assert largest.max() < 1.1 * largest.min()

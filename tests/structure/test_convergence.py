"""How the analysis comes nearer as cells shrink."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np

from orishell.deployment import Site
from orishell.deployment.feet import find_feet
from orishell.design_file import read_design_file
from orishell.structure.analyse import analyse
from orishell.structure.load_settings import LoadCase
from orishell.structure.settings import Structure, Support
from samples import thorough

CASES = (LoadCase(name="own weight", self_weight=True),)
RIGID = (np.inf, np.inf)
PINNED = (Support(at="feet", kind="pinned"),)
STRUCTURE = Structure(
    modulus=8e9, poisson=0.3, supports=PINNED, cases=CASES, thickness=0.01
).having(crease_stiffness=RIGID)
FIGURE_2 = Path(__file__).parents[2] / "examples" / "figure2.toml"


def largest(cells: int, refine: float = 0.0) -> tuple[float, float, int]:
    """Largest displacement with rigid creases, what changed, and the number of triangles."""
    file = read_design_file(FIGURE_2)
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

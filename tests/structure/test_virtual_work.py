"""Forces of ties and flaps against the closed form of the motion, by virtual work.

With free hinges and stiff panels a shell on smooth feet is a mechanism of one degree of freedom.
Along it the work of its own weight is what ties take, less what flaps give: their forces times the
rates of their lengths, which the closed form has (deployment.md: the sum of ties is -dV/dL).
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from orishell.conventions.quantities import GRAVITY
from orishell.deployment import Site, feet_ties, measure_weight
from orishell.deployment.feet import find_feet
from orishell.design_file import check_design
from orishell.numerics.arrays import Array
from orishell.structure.load_settings import LoadCase
from orishell.structure.loads import case_loads, sum_forces
from orishell.structure.mesh.sheet import mesh_sheet
from orishell.structure.model import Model
from orishell.structure.settings import Structure, Support
from orishell.structure.solve.active_set import respond

MASS = 2.0
PARABOLA = {"formula": "-x**2", "range": [-1, 1]}
ELLIPSE = {"formula": ["1.55*cos(t)", "2.3*sin(t)"], "range": [0, np.pi]}
ZIGZAG = {"formula": "0.1*cos(2*pi*x)", "range": [0, 2]}
ORTHODIAGONAL = {"family": "orthodiagonal", "heading_deg": 90, "spacing": "equal"}
PARALLEL = {"family": "parallel-repeating", "xi_deg": 40}


@dataclass(frozen=True)
class Carried:
    """Forces of ties and flaps, what they and weight work, and thrust by the formula."""

    ties: Array
    flaps: Array
    weight_work: float
    ties_work: float
    flaps_work: float
    thrust: float
    size: float


PINNED = Support(at="feet", kind="pinned")


def carry(f: dict[str, Any], pattern: dict[str, Any], *, tied: bool = True) -> Carried:
    family = pattern["family"]
    tables = {
        "shell": {"family": family, "unit": "m"},
        "target": {"f": f, "g": ZIGZAG},
        "pattern": {key: each for key, each in pattern.items() if key != "family"},
    }
    file = check_design(tables, Path("x.toml"))
    design = file.pattern.design(file.f, file.g).with_clipped_flaps()
    sheet, feet = design.mechanism, find_feet(design)
    assert feet is not None
    structure = Structure(
        modulus=1e11,
        poisson=0.3,
        supports=(PINNED,),
        cases=(LoadCase(name="own weight", self_weight=True),),
        thickness=0.05,
        crease_stiffness=(0.0, 0.0),
    ).replace_unchecked(supports=(PINNED.replace_unchecked(kind="friction"),))
    ties = tuple(feet_ties(sheet, feet.rows)) if tied else ()
    model = Model(design, structure, Site("m", feet, ties, MASS), 2)
    sprung = model.factorised(0.0)
    loads = case_loads(model.exposure, structure.cases[0], structure.cases)
    forces = sum_forces(model.exposure, loads)
    response = respond(sprung, sprung.free_loads(forces))
    assert response.moves is None
    pulls, presses, bears = np.split(
        response.forces[: len(sprung.conditions)],
        [len(ties), len(ties) + len(model.flaps)],
    )

    # The closed form's velocity, turned so that the feet that bear stay on the ground.
    step, drive = 1e-5, sheet.target_drive
    near = sheet.positions(np.array([drive - step, drive + step]))
    places, moved = model.positions.reshape(-1, 3), (near[1] - near[0]).reshape(-1, 3) / (2 * step)
    on = model.supports.ground[bears > 0]
    plane = np.column_stack([np.ones(len(on)), places[on, :2]])
    lift, by_x, by_y = np.linalg.lstsq(plane, moved[on, 2], rcond=None)[0]
    np.testing.assert_allclose(plane @ [lift, by_x, by_y], moved[on, 2], atol=1e-9)
    moved = moved - [0, 0, lift] - np.cross([by_y, -by_x, 0.0], places)

    def rates(pairs: tuple[Any, ...]) -> Array:
        first, last = model.nodes_of(pairs).T
        along = places[last] - places[first]
        along /= np.linalg.norm(along, axis=1, keepdims=True)
        return np.asarray(((moved[last] - moved[first]) * along).sum(axis=1))

    everywhere = mesh_sheet(moved.reshape(model.positions.shape), model.grid, model.cells)
    return Carried(
        pulls,
        presses,
        float((forces * everywhere.facets.points).sum()),
        float(pulls @ rates(model.site.ties)),
        float(presses @ rates(model.flaps)),
        measure_weight(sheet, feet.rows, MASS * GRAVITY).at_feet,
        float(np.abs(forces).sum()),
    )


def test_ties_carry_the_thrust_of_the_formula() -> None:
    """Where all feet move alike the sum of ties is -dV/dL."""
    found = carry(PARABOLA, {**PARALLEL, "rows": 7, "columns": 5, "flap": 0})
    assert found.thrust > 0
    assert found.ties.sum() == pytest.approx(found.thrust, rel=1e-6)


@pytest.mark.parametrize(
    ("f", "pattern"),
    [
        (PARABOLA, {**ORTHODIAGONAL, "rows": 7, "columns": 5, "depth": 0.05}),
        (PARABOLA, {**PARALLEL, "rows": 7, "columns": 5}),
        (ELLIPSE, {**ORTHODIAGONAL, "rows": 9, "columns": 5, "depth": 0.16}),
    ],
)
def test_work_of_ties_is_that_of_weight(f: dict[str, Any], pattern: dict[str, Any]) -> None:
    """Feet that lift as the shell opens bear nothing, so that energy is over the others."""
    found = carry(f, {**pattern, "flap": 0})
    assert found.weight_work == pytest.approx(found.ties_work, rel=1e-6)


def test_work_of_flaps_is_that_of_weight_where_it_closes_the_shell() -> None:
    pattern = {**ORTHODIAGONAL, "rows": 11, "columns": 5, "depth": 0.16, "flap": 0.25}
    found = carry(ELLIPSE, pattern, tied=False)
    assert found.thrust < 0
    assert found.flaps.sum() > 0
    assert found.weight_work == pytest.approx(-found.flaps_work, rel=1e-6)

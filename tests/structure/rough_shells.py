"""Random small shells on rough ground, with ties and flaps, as users ask for them."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import NamedTuple

import numpy as np

from orishell.deployment import Site, feet_ties
from orishell.deployment.feet import find_feet
from orishell.design_file import check_design
from orishell.numerics.arrays import Array
from orishell.structure.loads import case_loads, sum_forces
from orishell.structure.model import Model
from orishell.structure.settings import LoadCase, Snow, Structure, Support, Wind
from orishell.structure.solve.factorised import Factorised

SNOW = LoadCase(name="snow", self_weight=True, snow=Snow(ground=500.0))
DEAD = LoadCase(name="dead", self_weight=True)
GALE = LoadCase(
    name="gale", self_weight=True, wind=Wind(speed=12.0, terrain="II", direction_deg=70.0)
)


class Rough(NamedTuple):
    """A shell on rough ground, and what loads it."""

    text: str  # its design file
    tied: bool
    friction: float
    case: LoadCase
    stiffness: float
    tie_stiffness: float

    def model(self) -> Model:
        """The shell as a structure."""
        file = check_design(tomllib.loads(self.text), Path("rough.toml"))
        design = file.pattern.design(file.f, file.g)
        feet = find_feet(design)
        assert feet is not None
        ties = tuple(feet_ties(design.mechanism, feet.rows)) if self.tied else ()
        structure = Structure(
            modulus=8e9,
            supports=(Support(at="feet", kind="friction", friction=self.friction),),
            thickness=0.02,
            cells=2,
            cases=(self.case,),
        ).having(
            tie_stiffness=self.tie_stiffness,
            crease_stiffness=(self.stiffness, self.stiffness),
        )
        return Model(design, structure, Site("m", feet, ties, 6.0), 2)

    def loaded(self) -> tuple[Factorised, Array]:
        """The structure factorised, and loads on its free dofs."""
        model = self.model()
        held = model.factorised(self.stiffness)
        loads = case_loads(model.exposure, self.case, (self.case,))
        return held, held.free_loads(sum_forces(model.exposure, loads))


def rough_shell(seed: int) -> Rough:
    """One of the random shells: as the eight of `cases`, wider."""
    random = np.random.default_rng(seed)
    if random.random() < 0.4:
        f = f'formula = "{-random.uniform(0.4, 0.8):.3f}*x**2"\nrange = [-1, 1]'
    else:
        a, b = random.uniform(1.0, 1.5), random.uniform(1.2, 2.0)
        f = f'formula = ["{a:.3f}*cos(t)", "{b:.3f}*sin(t)"]\nrange = [0, 3.14159265]'
    tied = bool(random.random() < 0.5)
    flap = 0.05 if random.random() < 0.7 else 0.0
    text = f"""
[shell]
family = "orthodiagonal"
unit = "m"
[target.f]
{f}
[target.g]
formula = "{random.uniform(0.03, 0.12):.3f}*sin(pi*x/2)"
range = [0, 3]
[pattern]
rows = {random.choice([3, 5])}
columns = {random.choice([3, 4, 5, 6])}
flap = {flap}
depth = {random.uniform(0.14, 0.26):.3f}
heading_deg = 90
"""
    return Rough(
        text,
        tied,
        float(random.choice([0.05, 0.1, 0.2, 0.35, 0.5, 0.8, 1.5])),
        (DEAD, SNOW, GALE)[random.integers(3)],
        float(random.choice([0.0, 0.0, 50.0, np.inf])),
        float(random.choice([2e5, 2e5, np.inf])),
    )

"""Random small shells on rough ground, with ties and flaps; and statics of them by another way."""

from __future__ import annotations

import tomllib
from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

import numpy as np
from scipy.optimize import linprog

from orishell.conventions.errors import DesignError
from orishell.deployment import Site, feet_ties
from orishell.deployment.feet import find_feet
from orishell.design_file import check_design
from orishell.numerics.arrays import Array
from orishell.structure.loads import case_loads, sum_forces
from orishell.structure.model import Model
from orishell.structure.settings import LoadCase, Snow, Structure, Support, Wind
from orishell.structure.solve.factorised import Factorised

GALE = Wind(speed=12.0, terrain="II", direction_deg=70.0)
CASES = (
    LoadCase(name="dead", self_weight=True),
    LoadCase(name="snow", self_weight=True, snow=Snow(ground=500.0, arrangement="undrifted")),
    LoadCase(name="gale", self_weight=True, wind=GALE),
)
LIMIT = 1e4
"""Forces that nothing can bear, by the loads."""
DESIGN = """
[shell]
family = "orthodiagonal"
unit = "m"
[target.f]
{f}
[target.g]
formula = "{wave:.3f}*sin(pi*x/2)"
range = [0, 3]
[pattern]
rows = {rows}
columns = {columns}
flap = {flap}
depth = {depth:.3f}
heading_deg = 90
"""


class Rough(NamedTuple):
    """A shell on rough ground, and what loads it."""

    text: str  # its design file
    tied: bool
    friction: float
    case: LoadCase
    stiffness: float
    tie_stiffness: float

    def model(self) -> Model:
        """The shell as a structure.

        Raises DesignError: If there is no such design.
        """
        file = check_design(tomllib.loads(self.text), Path("rough.toml"))
        design = file.pattern.design(*file.require_target())
        feet = find_feet(design)
        assert feet is not None
        structure = Structure(
            modulus=8e9,
            supports=(Support(at="feet", kind="friction", friction=self.friction),),
            thickness=0.02,
            cells=2,
            cases=(self.case,),
        )
        ties = tuple(feet_ties(design.mechanism, feet.rows)) if self.tied else ()
        asked = structure.replace_unchecked(
            tie_stiffness=self.tie_stiffness,
            crease_stiffness=(self.stiffness, self.stiffness),
        )
        return Model(design, asked, Site("m", feet, ties, 6.0), 2)

    def loaded(self) -> tuple[Model, Factorised, Array]:
        """The structure, also factorised, and loads on its free dofs."""
        model = self.model()
        held = model.factorised(self.stiffness)
        forces = sum_forces(model.exposure, case_loads(model.exposure, self.case, (self.case,)))
        return model, held, held.free_loads(forces)


def rough_shell(seed: int) -> Rough:
    """One of the random shells."""
    random = np.random.default_rng(seed)
    f = f'formula = "{-random.uniform(0.4, 0.8):.3f}*x**2"\nrange = [-1, 1]'
    if random.random() < 0.6:
        a, b = random.uniform(1.0, 1.5), random.uniform(1.2, 2.0)
        f = f'formula = ["{a:.3f}*cos(t)", "{b:.3f}*sin(t)"]\nrange = [0, 3.14159265]'
    text = DESIGN.format(
        f=f,
        wave=random.uniform(0.03, 0.12),
        rows=random.choice([3, 5]),
        columns=random.choice([3, 4, 5, 6]),
        flap=0.05 if random.random() < 0.7 else 0.0,
        depth=random.uniform(0.14, 0.26),
    )
    return Rough(
        text,
        bool(random.random() < 0.5),
        float(random.choice([0.05, 0.1, 0.2, 0.35, 0.5, 0.8, 1.5])),
        CASES[random.integers(3)],
        float(random.choice([0.0, 0.0, 50.0, np.inf])),
        float(random.choice([2e5, 2e5, np.inf])),
    )


def loaded_shells(seeds: Iterable[int]) -> list[tuple[int, Model, Factorised, Array]]:
    """Those of the random shells that can be made, with their seeds, and loads on them."""
    found = []
    for seed in seeds:
        try:
            found.append((seed, *rough_shell(seed).loaded()))
        except DesignError:
            continue
    return found


def missing(held: Factorised, loads: Array, more: float = 1.0, sides: int = 96) -> float:
    """The least share of loads that rigid statics misses, by a linear program.

    Forces add up to LIMIT times the loads at most: by no bound they bear anything, as motions are
    rounded, and of ties and flaps parallel to 1e-10 rounding leaves a force across both.

    more: Coefficients of friction are so many times what they are.
    sides: Of a polygon instead of the circle of friction, with its corners on it.
    """
    motions = held.motions(np.zeros(len(held.springs), dtype=bool))
    if not motions.shape[1]:
        return 0.0
    by_row, count = held.rows @ motions, len(held.conditions)
    turn = 2 * np.pi * (np.arange(sides) + 0.5) / sides
    rays = [by_row[k] for k in range(count) if not held.conditions.friction[k]]
    for number, row in enumerate(held.conditions.rough.tolist()):
        along, across = by_row[count + 2 * number : count + 2 * number + 2]
        limit = more * held.conditions.friction[row]
        for angle in turn:
            rays.append(by_row[row] + limit * (np.cos(angle) * along + np.sin(angle) * across))
    bears, drive = np.array(rays).T, motions.T @ loads / np.linalg.norm(loads)
    size, one = bears.shape[1], np.eye(len(drive))
    bears /= np.abs(motions).max()
    least = None
    for accuracy in (1e-10, 1e-8, 1e-7):
        found = linprog(
            np.append(np.zeros(size), np.ones(2 * len(drive))),
            A_ub=np.append(np.full(size, 1 / LIMIT), np.zeros(2 * len(drive)))[None],
            b_ub=[1.0],
            A_eq=np.concatenate([bears, one, -one], axis=1),
            b_eq=drive,
            bounds=(0, None),
            method="highs",
            options={
                "primal_feasibility_tolerance": accuracy,
                "dual_feasibility_tolerance": accuracy,
            },
        )
        least = found.fun
        if least is not None:
            break
    assert least is not None
    return float(least)

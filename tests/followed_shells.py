"""Small shells under their own weight, followed to large displacements or not."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any
from unittest.mock import patch

from orishell.deployment import Site, feet_ties
from orishell.deployment.feet import find_feet
from orishell.design_file import check_design
from orishell.structure import soft_cases
from orishell.structure.analyse import analyse
from orishell.structure.equilibrium import Equilibrium
from orishell.structure.results import Analysis
from orishell.structure.settings import LoadCase, Structure, Support, SupportKind

PARABOLA = {"formula": "-x**2", "range": [-1, 1]}
ZIGZAG = {"formula": "0.1*cos(2*pi*x)", "range": [0, 2]}
PATTERN = {"rows": 7, "columns": 5, "heading_deg": 90, "spacing": "equal", "depth": 0.05}


@cache
def asked(
    kind: SupportKind, mass: float, *, flap: float = 0.0, crease: Any = "rigid", **keys: Any
) -> Analysis:
    """An orthodiagonal shell of 2 x 2 m and 30 panels under its own weight, followed.

    As designed, unless keys say by how much it is off.
    """
    tables = {
        "shell": {"family": "orthodiagonal", "unit": "m"},
        "target": {"f": PARABOLA, "g": ZIGZAG},
        "pattern": {**PATTERN, "flap": flap},
    }
    file = check_design(tables, Path("x.toml"))
    design = file.pattern.design(file.f, file.g).with_clipped_flaps()
    feet = find_feet(design)
    assert feet is not None
    tied = keys.pop("tied", False)
    ties = tuple(feet_ties(design.mechanism, feet.rows)) if tied else ()
    friction = keys.pop("friction", 0.0)
    structure = Structure(
        **{
            **{"modulus": 8e9, "thickness": 0.01, "cells": 2, "nonlinear": True},
            **{"imperfection": 0.0, **keys},
        },
        supports=(Support(at="feet", kind=kind, friction=friction),),
        cases=(LoadCase(name="own weight", self_weight=True),),
        crease_stiffness=crease,
    )
    return analyse(design, structure, Site("m", feet, ties, mass))


def held(analysis: Analysis) -> Equilibrium:
    (case,) = analysis.cases
    assert case.equilibrium is not None
    return case.equilibrium


def linear(followed: Analysis) -> Equilibrium:
    """The same by linear theory, also where it buckles soon."""
    model = followed.model
    structure = model.structure.replace_unchecked(nonlinear=False)
    with patch.object(soft_cases, "SECONDS", 0.0):
        return held(analyse(model.design, structure, model.site, built=model.built))

"""Gussets of a thickness and a material of their own, in the structure: stiffness, strength, mass.

The arch of the guide on pinned feet under its weight, boards of 10 mm, creases free.
"""

from __future__ import annotations

import json
from functools import cache
from typing import Any

import numpy as np
import pytest

from design_tables import Tables, formula
from orishell.shell.make import Shell
from orishell.structure.equilibrium import Equilibrium
from orishell.structure.materials import materials
from stiffened import shell_of

STEEL = materials()["steel"]
BEVEL = {"construction": "bevel", "thickness": 0.01, "gap": 0.004, "density": 500}
SANDWICH = {
    **{"construction": "sandwich", "thickness": 0.01, "membrane": 0.002},
    **{"density": 500, "membrane_density": 900},
}


def arch(panel: Tables = BEVEL, structure: Tables | None = None, **gussets: Any) -> Shell:
    return _arch(json.dumps([panel, structure, gussets]))


@cache
def _arch(asked: str) -> Shell:
    panel, structure, gussets = json.loads(asked)
    design: Tables = {
        "shell": {"family": "orthodiagonal", "unit": "m"},
        "target": {"f": formula("-x**2", -1, 1), "g": formula("0.1*cos(2*pi*x)", 0, 1)},
        "pattern": {"rows": 3, "columns": 3, "flap": 0, "heading_deg": 90, "spacing": "equal"},
        "panel": panel,
        "stiffeners": {"kind": "gussets", **gussets},
        "structure": {
            "supports": [{"at": "feet", "kind": "pinned"}],
            "crease_stiffness": "free",
            "cells": 3,
            "nonlinear": False,
            **(structure or {"modulus": 8e9, "strength": 20e6}),
        },
    }
    return shell_of(design)


def balanced(shell: Shell) -> Equilibrium:
    assert shell.analysis is not None
    (case,) = shell.analysis.cases
    assert case.equilibrium is not None
    return case.equilibrium


def test_as_thick_as_panels_they_are_as_panels_are() -> None:
    """Of solid panels: the same displacements, stress and mass, digit by digit."""
    usual, own = balanced(arch()), balanced(arch(thickness=0.01))
    np.testing.assert_array_equal(usual.displacements, own.displacements)
    assert usual.gussets is not None
    assert own.gussets is not None
    assert (usual.gussets.size, usual.gussets.at) == (own.gussets.size, own.gussets.at)
    assert usual.model.mass == own.model.mass


@pytest.mark.parametrize("panel", [BEVEL, SANDWICH], ids=["bevel", "sandwich"])
def test_they_are_solid_plates_of_their_thickness(panel: Tables) -> None:
    """E t/(1 - nu^2) and E t^3/12/(1 - nu^2), of the panels' modulus and of steel's."""
    for keys, modulus, thickness in (
        ({"thickness": 0.02}, 8e9, 0.02),
        ({"thickness": 0.004, "material": "steel"}, 210e9, 0.004),
        ({"material": "steel"}, 210e9, 0.01),
    ):
        section = balanced(arch(panel, **keys)).model.stiffened.sections[0]
        plane = modulus / (1 - 0.3**2)
        assert section.membrane == pytest.approx(plane * thickness, rel=1e-12)
        assert section.bending == pytest.approx(plane * thickness**3 / 12, rel=1e-12)
        assert section.reach == thickness / 2


@pytest.mark.parametrize("panel", [BEVEL, SANDWICH], ids=["bevel", "sandwich"])
def test_they_weigh_what_their_boards_do(panel: Tables) -> None:
    """Kilograms of their own volumes hang on the shell; its panels weigh what they did."""
    light = arch(panel, thickness=0.004)
    heavy = arch(panel, thickness=0.004, material="steel")
    volumes = [
        sum(float(part.boards.volumes().sum()) for part in shell.design.plates if part.boards)
        for shell in (light, heavy)
    ]
    assert volumes[0] == volumes[1] > 0
    more = balanced(heavy).model.mass - balanced(light).model.mass
    assert more == pytest.approx((STEEL.density - 500) * volumes[0], rel=1e-9)
    for shell in (light, heavy):
        built = shell.report.quantities.built
        assert built is not None
        assert built.mass_kg.total == pytest.approx(balanced(shell).model.mass, rel=1e-9)


def test_they_are_off_their_shape_as_plates_may_bow() -> None:
    """Where they buckle first panels hardly move: a gusset bows by 0.005 of its shorter side."""
    shell = arch(BEVEL, thickness=0.004)
    sides = [
        np.linalg.norm(np.diff(part.shell.positions[[0, 1, 3, 0]], axis=0), axis=1).max()
        for part in shell.design.plates
    ]
    path = balanced(shell).path
    assert path is not None
    assert 0 < path.imperfection < 0.005 * max(sides)


def test_stiffer_ones_sink_less_and_bear_more() -> None:
    """The shell sinks less the stiffer they are, by no more than its panels leave; what they use is
    their stress by what steel bears, 235 N/mm2."""
    usual, twice, steel = (
        balanced(arch(**each))
        for each in ({}, {"thickness": 0.02}, {"thickness": 0.01, "material": "steel"})
    )
    weight = [each.displacement.size / each.model.mass for each in (usual, twice, steel)]
    assert weight[0] > weight[1] > weight[2]
    assert steel.gussets is not None
    assert usual.utilisation.gussets is not None
    used = steel.utilisation.gussets
    assert used is not None
    assert used >= steel.gussets.size / 235e6
    assert used == pytest.approx(steel.gussets.size / 235e6, rel=0.5)


def test_those_of_the_panels_material_are_made_as_panels_are() -> None:
    named = arch(structure={"material": "birch plywood"}, material="birch plywood")
    usual = arch(structure={"material": "birch plywood"})
    assert named.design.plates[0].panel == usual.design.plates[0].panel == usual.design.panel
    assert not named.design.plates[0].material
    np.testing.assert_array_equal(balanced(named).displacements, balanced(usual).displacements)


def test_a_shell_creeps_as_the_part_that_creeps_most() -> None:
    """Plywood outdoors by 2.5 times (EN 1995-1-1, table 3.2), what has no name by nothing."""
    usual, own = balanced(arch()), balanced(arch(thickness=0.01, material="birch plywood"))
    assert usual.crept == usual.displacement.size
    assert own.crept == pytest.approx(3.5 * own.displacement.size, rel=1e-12)

"""Random shells of three constructions: every panel and every crease in balance, by own statics.

What is written of edges and corners (``EdgeForces``) is balanced here with weight and pressure by
areas and centroids of panels, which the analysis does not know: it has forces on nodes.
"""

from __future__ import annotations

import itertools
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from orishell.conventions.errors import DesignError
from orishell.design_file import check_design
from orishell.numerics.arrays import Array
from orishell.shell.make import make_shell
from orishell.shell.steps import MEASURES
from orishell.structure.equilibrium import Equilibrium
from orishell.structure.mesh.edge_forces import crease_sides
from orishell.structure.results import Analysis
from samples import led_by

SKIP = (*MEASURES, "stock", "verification", "remedies")
GRAVITY = 9.81


def drawn(seed: int) -> tuple[Analysis, float, float]:
    """A shell, its areal mass (kg/m2) and its pressure (N/m2): the first that can be made."""
    every = (_drawn(seed, attempt) for attempt in itertools.count())
    return next(each for each in every if each is not None)


def _drawn(seed: int, attempt: int) -> tuple[Analysis, float, float] | None:
    rng = np.random.default_rng([seed, attempt])
    thickness, mass = rng.uniform(0.01, 0.03), rng.uniform(2, 12)
    pressure = float(rng.uniform(-300, 300)) * (seed % 3 == 0)
    span, height = rng.uniform(1.0, 1.8, 2)
    tables: dict[str, Any] = {
        "shell": {"family": "orthodiagonal", "unit": "m"},
        "target": {
            "f": {"formula": [f"{span}*cos(t)", f"{height}*sin(t)"], "range": [0, np.pi]},
            "g": {"formula": f"{rng.uniform(0.03, 0.1)}*cos(2*pi*x)", "range": [0, 2]},
        },
        "pattern": {
            **{"rows": int(rng.choice([5, 7])), "columns": int(rng.choice([3, 5])), "flap": 0},
            **{"depth": rng.uniform(0.08, 0.16), "heading_deg": 90, "spacing": "equal"},
        },
        "workshop": {"areal_density": mass},
        "structure": {
            **{"modulus": 8e9, "strength": 16e6, "cells": int(rng.choice([2, 3]))},
            "supports": [{"at": "feet", "kind": str(rng.choice(["pinned", "fixed"]))}],
            "crease_stiffness": ["rigid", 500.0, "free"][int(rng.integers(3))],
        },
        "load_case": [{"name": "load", "self_weight": True, "pressure": pressure}],
    }
    kind = ("solid", "bevel", "sandwich")[seed % 3 - 1]
    if kind == "solid":
        tables["structure"]["thickness"] = thickness
    else:
        tables["panel"] = {"construction": kind, "thickness": thickness}
        tables["panel"] |= {"gap": 0.002} if kind == "bevel" else {"membrane": 0.001}
        if kind == "sandwich":
            tables["structure"]["membrane_modulus"] = 1e9
    try:
        shell = make_shell(check_design(tables, Path("x.toml")), clash="unexamined", skip=SKIP)
    except DesignError:
        return None
    assert shell.analysis is not None
    return shell.analysis, mass, pressure


def misses(found: Analysis, stands: Equilibrium, mass: float, pressure: float) -> Array:
    """What force and moment over a metre (F, 6) each panel misses, as a share of its own load."""
    model = found.model
    corners = model.positions.reshape(-1, 3)[model.grid.faces_vertices()]
    after = np.roll(corners, -1, axis=1)
    first = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    other = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 0])
    one, two = (0.5 * np.linalg.norm(each, axis=1)[:, None] for each in (first, other))
    centre = one * corners[:, [0, 1, 2]].mean(axis=1) + two * corners[:, [0, 2, 3]].mean(axis=1)
    centre /= one + two
    normal = (first + other) / np.linalg.norm(first + other, axis=1)[:, None]
    outer = normal * np.sign(normal[:, 2].sum())
    load = (one + two) * (-GRAVITY * mass * np.array([0.0, 0.0, 1.0]) - pressure * outer)
    total = np.concatenate([load, np.zeros_like(load)], axis=1)
    edges = stands.edges
    for at, acts in ((0.5 * (corners + after), edges.resultants), (corners, edges.corners)):
        force, moment = acts[..., :3], acts[..., 3:]
        arms = np.cross(at - centre[:, None], force)
        total += np.concatenate([force, moment + arms], axis=-1).sum(axis=1)
    return np.asarray(total / np.linalg.norm(load, axis=1).mean())


@pytest.mark.parametrize("seed", led_by(range(100), 10))
def test_panels_and_creases_balance(seed: int) -> None:
    """To 1e-6 of a panel's mean load, where forces along edges are up to a hundred times it."""
    found, mass, pressure = drawn(seed)
    for stands, _ in found.balanced:
        if stands.path is not None:  # it is in balance as it is moved, not as designed
            continue
        missing = misses(found, stands, mass, pressure)
        assert np.abs(missing).max() < 1e-6
        sides = crease_sides(found.model.grid)[1]
        acts = stands.edges.resultants[sides[..., 0], sides[..., 1]]
        scale = np.abs(acts[..., :3]).max()
        np.testing.assert_allclose(acts[:, 0], -acts[:, 1], atol=1e-6 * scale)


def test_most_of_them_stand() -> None:
    """So that what is in balance is not nothing; 0.1 % of weight is seen."""
    made = [drawn(seed) for seed in range(6)]
    stand = [each for each in made if each[0].balanced and each[0].balanced[0][0].path is None]
    assert len(stand) >= 4
    for found, mass, pressure in stand:
        stands = found.balanced[0][0]
        assert np.abs(misses(found, stands, 1.001 * mass, pressure)).max() > 1e-5

"""Random shells of three constructions: every panel and every crease in balance, by own statics.

What ``forces.csv`` has of creases and supports is balanced here with weight and pressure by areas
and centroids of panels, which the analysis does not know: it has forces on nodes.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from orishell.conventions.errors import DesignError
from orishell.design_file import check_design
from orishell.document import Document
from orishell.numerics.arrays import Array
from orishell.shell.make import make_shell
from orishell.shell.steps import MEASURES
from orishell.structure.model import Model
from orishell.structure.results import Analysis
from samples import led_by
from written_forces import Acts, both_sides, by_panel, size, summed, written_forces

SKIP = (*MEASURES, "stock", "verification", "remedies")
GRAVITY = 9.81


Drawn = tuple[Analysis, Document, float, float]


def drawn(seed: int) -> Drawn:
    """A shell, its areal mass (kg/m2) and its pressure (N/m2): the first that can be made."""
    every = (_drawn(seed, attempt) for attempt in itertools.count())
    return next(each for each in every if each is not None)


def _drawn(seed: int, attempt: int) -> Drawn | None:
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
    return shell.analysis, shell.document, mass, pressure


def own_loads(model: Model, mass: float, pressure: float) -> tuple[Array, Array]:
    """Weight and pressure (F, 3) on panels, and their centroids (F, 3)."""
    corners = model.positions.reshape(-1, 3)[model.grid.faces_vertices()]
    first = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    other = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 0])
    one, two = (0.5 * np.linalg.norm(each, axis=1)[:, None] for each in (first, other))
    centre = one * corners[:, [0, 1, 2]].mean(axis=1) + two * corners[:, [0, 2, 3]].mean(axis=1)
    centre /= one + two
    normal = (first + other) / np.linalg.norm(first + other, axis=1)[:, None]
    outer = normal * np.sign(normal[:, 2].sum())
    loads = (one + two) * (-GRAVITY * mass * np.array([0.0, 0.0, 1.0]) - pressure * outer)
    return loads, centre


def misses(rows: Sequence[Acts], shell: Drawn) -> Array:
    """What force and moment over a metre (F, 6) each panel misses, as a share of the mean load.

    rows: All that acts on panels in a case; what loads them is not read.
    """
    analysis, document, mass, pressure = shell
    model = analysis.model
    loads, centres = own_loads(model, mass, pressure)
    centres = document.in_world(centres)
    held = by_panel([each for each in rows if each.acts != "load"])
    total = np.array(
        [
            summed(held[model.panel_at(number)], centre) + np.concatenate([load, np.zeros(3)])
            for number, (load, centre) in enumerate(zip(loads, centres, strict=True))
        ]
    )
    return np.asarray(total / np.linalg.norm(loads, axis=1).mean())


@pytest.mark.parametrize("seed", led_by(range(100), 10))
def test_panels_and_creases_balance(tmp_path: Path, seed: int) -> None:
    """To 1e-6 of a panel's mean load, where forces along edges are up to a hundred times it."""
    shell = drawn(seed)
    found, document, *_ = shell
    written = written_forces(found, document, tmp_path / "forces.csv")
    assert len(written) == len(found.balanced)
    for (stands, _), rows in zip(found.balanced, written.values(), strict=True):
        if stands.path is None:  # else it is in balance as it is moved, not as designed
            assert np.abs(misses(rows, shell)).max() < 1e-6
        middle = np.mean([each.at for each in rows], axis=0)
        loads = size([each for each in rows if each.acts == "load"])
        for own in by_panel(rows).values():
            assert np.abs(summed(own, own[0].at)).max() < 1e-6 * loads
        sides = both_sides(rows, middle)
        rows_of, columns = found.model.grid.rows - 1, found.model.grid.columns - 1
        assert len(sides) == (rows_of - 1) * columns + rows_of * (columns - 1)
        assert np.abs(sides.sum(axis=1)).max() < 1e-6 * loads


def test_most_of_them_stand(tmp_path: Path) -> None:
    """So that what is in balance is not nothing; 0.1 % of weight is seen."""
    stand = 0
    for seed in range(6):
        found, document, mass, pressure = drawn(seed)
        if found.balanced and found.balanced[0][0].path is None:
            stand += 1
            rows, *_ = written_forces(found, document, tmp_path / "forces.csv").values()
            assert np.abs(misses(rows, (found, document, 1.001 * mass, pressure))).max() > 1e-5
    assert stand >= 4

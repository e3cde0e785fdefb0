"""Conditions of a few creases: their derivatives against differences, and sheets that fold."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from mechanisms import SAMPLES as SHEETS
from orishell.families.drawn.conditions import Conditions
from orishell.families.drawn.sheet import drawn_sheet
from orishell.motion import find_assignment

NAMES = ["longitudinal, 4 x 3 from S", "orthodiagonal, g straight", "flat-foldable, mixed"]
Array = np.ndarray


def conditions_of(name: str, jitter: float) -> tuple[Conditions, Array]:
    sheet = SHEETS[name].make()
    flat = sheet.positions(0.0)[..., :2]
    flat = flat + jitter * np.random.default_rng(1).uniform(-1, 1, flat.shape)
    drive = drawn_sheet(flat, find_assignment(sheet), 2.0).drive
    own = np.moveaxis(flat, -1, 0)
    own = own.swapaxes(1, 2)[::-1] if drive.across else own
    return Conditions.of(own, drive), own


@pytest.mark.parametrize("name", NAMES)
def test_sheets_that_fold_keep_them(name: str) -> None:
    conditions, flat = conditions_of(name, 0.0)
    assert np.abs(conditions.misses(flat)).max() < 1e-11


@pytest.mark.parametrize("name", NAMES)
def test_derivatives_are_those_of_differences(name: str) -> None:
    # Central differences of 1e-6 leave 1e-6 of the steepest; second derivatives are differences
    # themselves, which near closing leave up to half a percent.
    conditions, flat = conditions_of(name, 1e-4)
    conditions = replace(conditions, kinds=conditions.kinds | conditions.nearly(flat))
    rng = np.random.default_rng(2)
    way = rng.normal(size=flat.shape)
    more, less = flat + 1e-6 * way, flat - 1e-6 * way
    slopes = conditions.derivatives(flat)
    expected = (conditions.misses(more) - conditions.misses(less)) / 2e-6
    assert np.abs(slopes @ way.ravel() - expected).max() < 1e-5 * np.abs(expected).max()
    forces = rng.normal(size=len(expected))
    bent = (conditions.derivatives(more) - conditions.derivatives(less)).T @ forces / 2e-6
    found = conditions.bends(flat, forces) @ way.ravel()
    assert np.abs(found - bent).max() < 2e-2 * np.abs(bent).max()

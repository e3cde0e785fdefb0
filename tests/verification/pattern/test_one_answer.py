"""Whether and how a sheet folds is one answer, whichever of check, fold and design is asked."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np
import pytest

from orishell.conventions.errors import DesignError
from orishell.conventions.record import as_table
from orishell.families.drawn.design import design_drawn
from orishell.io import read_pattern
from orishell.motion.crease_pattern import CreasePattern, pattern_of_panels
from orishell.motion.drawing import drawing_of
from orishell.motion.grid import Grid
from orishell.shell.folded import fold_pattern
from orishell.verification.pattern import FoldingMotion, judge_pattern
from patterns import SAMPLES, jittered, miura, square_twist, write
from samples import led_by

ROUNDING = 1e-9
"""Vertices that miss closing by less close but for rounding (radians)."""


def bare(pattern: CreasePattern) -> CreasePattern:
    """The same without letters."""
    return replace(pattern, letters=np.where(pattern.crease, "U", pattern.letters))


def made_bare(name: str) -> CreasePattern:
    return bare(SAMPLES[name].make())


def all_valleys(pattern: CreasePattern) -> CreasePattern:
    return replace(pattern, letters=np.where(pattern.crease, "V", pattern.letters))


def scattered(rows: int, columns: int, seed: int) -> CreasePattern:
    """A grid of inner vertices whose vertices are moved at random, without letters.

    Such a strip folds, whatever its sectors are: from one vertex of degree four to the next,
    each of which has one degree of freedom. Such a sheet of more rows and columns does not.
    """
    rng = np.random.default_rng(seed)
    grid = Grid(rows + 2, columns + 2)
    down, along = np.mgrid[: grid.rows, : grid.columns].astype(float)
    places = np.stack([along, -down], axis=-1) + rng.uniform(-0.25, 0.25, (*along.shape, 2))
    pattern = pattern_of_panels(places.reshape(-1, 2), grid.faces_vertices(), grid.edges_vertices())
    return bare(pattern)


GRIDS = [name for name, sample in SAMPLES.items() if sample.grid]
SHEETS: dict[str, Callable[[], CreasePattern]] = {
    **{name: SAMPLES[name].make for name in GRIDS},
    **{f"{name}, bare": partial(made_bare, name) for name in GRIDS},
    **{f"strip {k}": partial(scattered, 1, 2 + k % 5, k) for k in range(12)},
    **{f"scattered {k}": partial(scattered, 2, 2 + k % 2, k) for k in range(4)},
    "square twist": square_twist,
    "all valleys": lambda: all_valleys(miura(2, 2)),
    "nearly": lambda: jittered(miura(3, 3), 1e-4),
}
FEW = ["longitudinal, bare", "strip 0", "strip 1", "strip 3", "all valleys"]


@pytest.mark.parametrize(
    "name", led_by([*FEW, *(each for each in SHEETS if each not in FEW)], len(FEW))
)
def test_check_fold_and_design_agree(name: str, tmp_path: Path) -> None:
    """All say that it folds exactly, or none does; and fold angles are the same to the last bit."""
    path = write(tmp_path / "sheet.fold", SHEETS[name]())
    read = read_pattern(path)
    assert read.flat is not None
    verdict = judge_pattern(read)
    assert verdict.findings is not None
    motion = verdict.findings.motion
    exact = {"check": isinstance(motion, FoldingMotion) and motion.exact}
    try:
        folded = fold_pattern(path)
    except DesignError:
        exact["fold"] = False
    else:
        exact["fold"] = folded.states.residual <= ROUNDING
        assert exact["fold"] == folded.motion.exact
        assert as_table(folded.found) == as_table(verdict.rows)
    try:
        design = design_drawn(drawing_of(read.flat), fold=None, move=0.0)
    except DesignError as error:
        several = "parts of the sheet fold independently" in str(error)
        exact["design"] = several and exact["check"]  # it makes none of several motions
        one = verdict.degrees_of_freedom == 1
        assert not (several and one)
    else:
        exact["design"] = True
        assert isinstance(motion, FoldingMotion)
        angles = design.mechanism.fold_angles(motion.drives)
        lines = [each.reshape(25, -1) for each in (angles.row, angles.column)]
        drawn = np.abs(np.concatenate(lines, axis=1))
        np.testing.assert_array_equal(
            np.sort(drawn), np.sort(np.abs(folded.states.folds[:, read.flat.crease]))
        )
        np.testing.assert_array_equal(folded.states.folds, motion.folds)
    assert len(set(exact.values())) == 1, exact
    if name.startswith("strip"):
        assert exact["check"]
    if name.startswith("scattered"):
        assert not exact["check"]

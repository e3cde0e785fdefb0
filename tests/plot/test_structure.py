"""The picture of the loaded shell, by its pixels."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from loaded_shells import loaded_document
from orishell.document.loaded import LoadedShell
from orishell.plot import DrawnCase, plot_structure
from orishell.plot.structure import DRAWN, exaggeration
from samples import thorough

TAUT = (20, 134, 143)
DEEP = (69, 40, 90)
"""The end of the colours."""


def shell() -> LoadedShell:
    loaded = loaded_document().loaded
    assert loaded is not None
    return loaded


def picture(path: Path, *, taut: bool = True, cases: int = 3, still: bool = False) -> np.ndarray:
    loaded = shell()
    drawn = [DrawnCase(each, np.array([taut]), "note") for each in 5 * loaded.cases][:cases]
    if still:
        rest = replace(loaded.cases[0], displacements=0 * loaded.points)
        drawn = [DrawnCase(rest, np.array([taut]), "")]
    plot_structure(path, loaded, drawn, title="Title", sign="fails", unit="m")
    return np.asarray(Image.open(path).convert("RGB")).astype(int)


def near(pixels: np.ndarray, colour: tuple[int, int, int]) -> int:
    return int((np.abs(pixels - colour).max(axis=-1) < 12).sum())


def test_ties_that_pull_are_told_from_those_that_do_not(tmp_path: Path) -> None:
    pulling, slack = (picture(tmp_path / "one.png", taut=taut) for taut in (True, False))
    assert near(pulling, TAUT) > 1000
    assert near(slack, TAUT) == 0


def test_what_is_displaced_most_is_the_deepest(tmp_path: Path) -> None:
    """Without displacements only the end of the bar of colours is that deep."""
    moved, still = (picture(tmp_path / "one.png", cases=1, still=still) for still in (False, True))
    assert near(moved, DEEP) > 10 * near(still, DEEP) > 0


@thorough
def test_every_case_has_its_part_until_there_are_too_many(tmp_path: Path) -> None:
    one, four, twelve, more = (
        picture(tmp_path / "one.png", cases=cases) for cases in (1, 4, 12, 15)
    )
    assert one.shape[1] == four.shape[1] == twelve.shape[1] == 2600
    assert four.shape[0] > one.shape[0]
    assert twelve.shape == more.shape
    assert (twelve != more).any()  # how many are not drawn is said


@pytest.mark.parametrize("largest", [1e-7, 3e-4, 0.02, 1.0, 30.0])
def test_displacements_are_drawn_by_a_round_number(largest: float) -> None:
    """Steps of 1, 2, 5 are apart by 2.5 at most."""
    points = shell().points
    by = exaggeration(points, largest * np.array([[0, 0, 1.0], [0.3, 0, 0]]))
    drawn = by * largest / np.linalg.norm(np.ptp(points, axis=0))
    assert DRAWN / 2.5 <= drawn <= DRAWN
    assert f"{by:.0e}"[0] in "125"
    assert by == pytest.approx(float(f"{by:.0e}"), rel=1e-12)


def test_the_same_bytes_each_time(tmp_path: Path) -> None:
    for name in ("one.png", "two.png"):
        picture(tmp_path / name)
    assert (tmp_path / "one.png").read_bytes() == (tmp_path / "two.png").read_bytes()

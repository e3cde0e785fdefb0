"""The picture of the loaded shell, by its pixels."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from matplotlib.font_manager import FontProperties
from matplotlib.textpath import TextPath
from PIL import Image

from loaded_shells import loaded_document
from orishell.document.loaded import LoadedShell
from orishell.plot import DrawnCase, plot_structure
from orishell.plot.scene import WIDTH, choose_camera
from orishell.plot.structure import DRAWN, LINES, SIZES, exaggeration, lines_above
from samples import thorough

TAUT = (20, 134, 143)
DEEP = (69, 40, 90)
"""The end of the colours."""
WALL_COLOUR = (230, 227, 220)


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


@pytest.mark.parametrize("columns", [2, 3])
@pytest.mark.parametrize(
    "name",
    [
        "winter, drifted right, free creases",
        "ULS 1.35 own weight + 0.75 snow, drifted right + 1.5 wind across, rigid creases",
        "A NAME OF A LOAD CASE THAT SOMEBODY WROTE IN CAPITALS AND WITH MANY MORE WORDS",
    ],
)
def test_names_of_load_cases_stay_above_their_own_parts(name: str, columns: int) -> None:
    """Measured with the font that they are drawn in; all of a usual name is there."""
    width = WIDTH / columns
    lines = lines_above(name, width, SIZES[0], LINES).split("\n")
    font = FontProperties(weight="bold")
    wide = [TextPath((0, 0), line, size=SIZES[0], prop=font).get_extents().width for line in lines]
    assert max(wide) < 72 * width
    assert " ".join(lines) == name


def test_walls_at_the_ends_are_drawn_behind_the_shell(tmp_path: Path) -> None:
    """A wall beyond the shell, seen from the camera, as high as it is."""
    loaded = shell()
    low, high = loaded.points.min(axis=0), loaded.points.max(axis=0)
    towards = choose_camera(loaded.points).axes()[2][:2]
    away = 0.5 * (low + high)[:2] - np.linalg.norm((high - low)[:2]) * towards
    side = np.array([-towards[1], towards[0]])
    ends = [away - side, away + side]
    base, top = ([[*end, z] for end in ends] for z in (low[2], high[2]))
    wall = np.array([[*base, *top[::-1]]])
    drawn = [DrawnCase(loaded.cases[0], np.array([True]), "note")]
    pixels = []
    for walls in ((), (wall,)):
        path = tmp_path / "one.png"
        plot_structure(path, loaded, drawn, title="", sign="holds", unit="m", walls=walls)
        pixels.append(near(np.asarray(Image.open(path).convert("RGB")).astype(int), WALL_COLOUR))
    assert pixels[1] > pixels[0] + 10_000

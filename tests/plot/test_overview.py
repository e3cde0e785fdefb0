"""The overview picture, by its pixels."""

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from orishell.families.parallel_repeating import ParallelRepeatingPattern, design_parallel_repeating
from orishell.motion import FoldingMotion, Mechanism, find_assignment
from orishell.motion.grid import CreaseValues
from orishell.motion.hinge_lines import IN_CREASES
from orishell.motion.hinges import Hinges
from orishell.plot import plot_overview
from samples import led_by
from strategies import graph


def picture(
    path: Path,
    rows: int,
    columns: int,
    g: str,
    *,
    flap: float = 0.3,
    hinged: float | None = None,
    gussets: bool = False,
) -> np.ndarray:
    design = design_parallel_repeating(
        graph("-x**2", -1, 1),
        graph(g, 0, 20),
        ParallelRepeatingPattern(rows=rows, columns=columns, xi_deg=np.rad2deg(0.8), flap=flap),
    )
    plot_overview(
        path,
        FoldingMotion(design.mechanism, 2),
        design.targets,
        title="Title",
        last="Locked",
        unit="m",
        hinges=IN_CREASES if hinged is None else at_height(design.mechanism, hinged),
        others=lambda drive: in_a_fold(design.mechanism, drive) if gussets else [],
    )
    return np.asarray(Image.open(path).convert("RGB")).astype(int)


def in_a_fold(mechanism: Mechanism, drive: float) -> list[np.ndarray]:
    """Corners (1, 4, 3) of a gusset at a vertex, along all of the edges of its column."""
    if drive != mechanism.target_drive:
        return []
    above, vertex, below = mechanism.positions(drive)[1:4, 1]
    return [np.array([[vertex, above, 0.5 * (above + below), below]])]


def at_height(mechanism: Mechanism, height: float) -> Hinges:
    """Hinges of all creases at one height, and boards half as thick below them."""
    signs = find_assignment(mechanism)
    row, column = signs.row.shape, signs.column.shape
    heights = CreaseValues(np.full(row, height), np.full(column, height))
    levels, arms = (
        np.full((column[0], row[1]), -height),
        (np.zeros((2, *row)), np.zeros((2, *column))),
    )
    return Hinges(signs, heights, levels, 2 * height, arms)


def share_of(pixels: np.ndarray, colour: tuple[int, int, int]) -> float:
    return float((np.abs(pixels - colour).max(axis=-1) < 25).mean())


@pytest.mark.parametrize(("rows", "columns"), led_by([(1, 2), (201, 301), (9, 11)], 2))
def test_colours_are_there(tmp_path: Path, rows: int, columns: int) -> None:
    pixels = picture(tmp_path / "overview.png", rows, columns, "x**2/60")
    assert pixels.shape[1] == 2600
    assert 800 < pixels.shape[0] < 3400
    for name, colour in {
        "mountain": (214, 39, 40),
        "valley": (31, 95, 191),
        "f": (10, 143, 60),
        "g": (181, 23, 158),
        "border": (0, 0, 0),
    }.items():
        assert share_of(pixels, colour) > 1e-4, name
    assert 0.3 < share_of(pixels, (255, 255, 255)) < 0.97


def test_gussets_are_drawn_at_the_target_only(tmp_path: Path) -> None:
    """One in a fold: of four quarters and the states below them it is in the upper right one."""
    path = tmp_path / "overview.png"
    bare, held = (picture(path, 3, 3, "x**2/60", flap=0, gussets=each) for each in (False, True))
    rows, columns = np.nonzero((bare != held).any(axis=-1))
    assert len(rows) > 100
    assert columns.min() > 1300
    assert rows.max() < 0.7 * len(bare)


def test_whole_boards_are_drawn_where_they_are(tmp_path: Path) -> None:
    path = tmp_path / "overview.png"
    plain, thin, thick = (
        picture(path, 3, 3, "x**2/60", flap=0, hinged=height) for height in (None, 0.0, 0.1)
    )
    assert np.array_equal(plain, thin)
    assert plain.shape != thick.shape or not np.array_equal(plain, thick)


@pytest.mark.parametrize(("rows", "columns"), led_by([(1, 2), (3, 3), (201, 2)]))
def test_sheets_without_flaps(tmp_path: Path, rows: int, columns: int) -> None:
    pixels = picture(tmp_path / "overview.png", rows, columns, "x**2/60", flap=0)
    for colour in ((10, 143, 60), (181, 23, 158), (0, 0, 0)):
        assert share_of(pixels, colour) > 1e-4
    assert 0.3 < share_of(pixels, (255, 255, 255)) < 0.97

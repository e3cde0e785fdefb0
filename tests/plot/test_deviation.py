"""The deviation picture, by its pixels."""

from pathlib import Path

import numpy as np
from PIL import Image

from orishell.deviation import locked_shell, measure_signed
from orishell.families.parallel_repeating import ParallelRepeatingPattern, design_parallel_repeating
from orishell.plot import plot_deviation
from samples import thorough
from strategies import graph


def picture(path: Path, rows: int = 5, columns: int = 6, sign: float = 0.0) -> np.ndarray:
    """A shell in its colours, or all in one: ``sign`` times the largest distance."""
    design = design_parallel_repeating(
        graph("-x**2", -1, 1),
        graph("x**2/60", 0, 20),
        ParallelRepeatingPattern(rows=rows, columns=columns, xi_deg=np.rad2deg(0.8)),
    )
    signed = measure_signed(locked_shell(design), design.surface, 2_000, 30)
    distances = signed.distances
    if sign:
        distances = np.full_like(distances, sign)
    plot_deviation(
        path,
        signed.points,
        distances,
        signed.creases,
        design.targets,
        title="Title",
        note="Note",
        unit="m",
    )
    return np.asarray(Image.open(path).convert("RGB")).astype(int)


def share(pixels: np.ndarray, hue: str) -> float:
    red, green, blue = np.moveaxis(pixels, -1, 0)
    hues = {"brown": red > blue + 40, "teal": (blue > red + 40) & (blue > green)}
    # Without the colour bar.
    part = hues[hue][:, : int(0.8 * red.shape[1])]
    return float(part.mean())


@thorough
def test_both_signs_and_both_curves_are_there(tmp_path: Path) -> None:
    for rows, columns in ((5, 6), (1, 2), (101, 61)):
        pixels = picture(tmp_path / "deviation.png", rows, columns)
        assert pixels.shape[1] == 2600
        assert share(pixels, "brown") > 0.001
        assert share(pixels, "teal") > 0.001
        for curve in ((10, 143, 60), (181, 23, 158)):
            assert (np.abs(pixels - curve).max(axis=-1) < 25).mean() > 1e-4


def test_brown_is_above_and_teal_below(tmp_path: Path) -> None:
    above, below = (picture(tmp_path / "deviation.png", sign=sign) for sign in (0.1, -0.1))
    assert share(above, "brown") > 0.1
    assert share(above, "teal") < 0.02
    assert share(below, "teal") > 0.1
    assert share(below, "brown") < 0.02


def test_the_same_bytes_each_time(tmp_path: Path) -> None:
    for name in ("one.png", "two.png"):
        picture(tmp_path / name)
    assert (tmp_path / "one.png").read_bytes() == (tmp_path / "two.png").read_bytes()

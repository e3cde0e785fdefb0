"""The picture of own weight, by its pixels."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from orishell.conventions.colours import rgb
from orishell.plot import plot_weight

OPENS, CLOSES = (210, 223, 242), (247, 212, 213)
"""A fifth of blue and of red, on white."""


def picture(path: Path, forces: Sequence[float | None], pack: bool = True) -> np.ndarray:
    drives = np.linspace(0, 180, len(forces)).tolist()
    plot_weight(
        path,
        drives,
        forces,
        unit="N",
        largest=10,
        marked_deg={"target": 90, "pack": 180} if pack else {"target": 90},
        tipping_deg=[60] if pack else [],
    )
    return np.asarray(Image.open(path).convert("RGB")).astype(int)


def share_of(pixels: np.ndarray, colour: tuple[int, ...]) -> float:
    return float((np.abs(pixels - colour).max(axis=-1) < 6).mean())


def share_named(pixels: np.ndarray, meaning: str) -> float:
    return share_of(pixels, tuple(round(255 * each) for each in rgb(meaning)))


@pytest.mark.parametrize(
    ("forces", "opens", "closes"),
    [
        ((None, 20, 5, -5, -8, -3), True, True),
        ((None, 20, 5, 4, 3), True, False),
        ((-3, -4, None, -4), False, True),
        ((0, 0, 0), False, False),
    ],
)
def test_sides_are_shaded(
    tmp_path: Path, forces: Sequence[float | None], opens: bool, closes: bool
) -> None:
    pixels = picture(tmp_path / "weight.png", forces)
    assert pixels.shape == (1040, 1600, 3)
    assert (share_of(pixels, OPENS) > 0.01) == opens
    assert (share_of(pixels, CLOSES) > 0.01) == closes


def test_marks(tmp_path: Path) -> None:
    forces = (None, 20, 5, -5, -8, -3)
    pixels = picture(tmp_path / "weight.png", forces)
    alone = picture(tmp_path / "alone.png", forces, pack=False)
    for meaning in ("unfolded", "contact"):
        assert share_named(pixels, meaning) > 1e-4 > share_named(alone, meaning)
    assert share_named(alone, "target") > 1e-4

"""The picture of a search's front, for any number of figures that it is searched for."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from orishell.plot.graphs import plot_front


@pytest.mark.parametrize("figures", [1, 2, 3, 4])
def test_nothing_is_cut_off_at_the_border(figures: int, tmp_path: Path) -> None:
    designs = np.random.default_rng(0).random((6, figures))
    labels = [f"deviation {k} (m)" for k in range(figures)]
    plot_front(
        tmp_path / "front.png", designs[:4], designs[4:5], designs[5:], knee=1, labels=labels
    )
    with Image.open(tmp_path / "front.png") as picture:
        shown = np.asarray(picture.convert("RGB"))
    for border in (shown[:2], shown[-2:], shown[:, :2], shown[:, -2:]):
        assert (border == 255).all()

"""Pictures of the site lose bytes, and nothing that one sees."""

from __future__ import annotations

from importlib import import_module
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

ROOT = Path(__file__).parents[2]
WIDE, HIGH = 320, 240


@pytest.fixture
def drawing() -> Image.Image:
    """Panels in 60 shades, with thin lines."""
    y, x = np.indices((HIGH, WIDE))
    shades = 2 * ((x // 5) ** 2 * (y // 3) % 61) + 110
    pixels = np.stack([shades, shades - 10, shades - 30], axis=-1).astype(np.uint8)
    pixels[::16] = (201, 48, 44)
    return Image.fromarray(pixels).convert("RGBA")


@pytest.fixture
def shading() -> Image.Image:
    """More shades of two colours than a palette has."""
    x, y = np.meshgrid(np.linspace(0, 255, WIDE), np.linspace(0, 255, HIGH))
    return Image.fromarray(np.stack([x, y, 255 - x], axis=-1).astype(np.uint8))


def shrunk(picture: Image.Image, path: Path, monkeypatch: pytest.MonkeyPatch) -> bool:
    """Whether a picture's file is smaller than it was."""
    pytest.importorskip("sphinx")
    monkeypatch.syspath_prepend(str(ROOT / "docs" / "_ext"))
    picture.save(path)
    before = path.stat().st_size
    import_module("lean_pictures").shrink(path)
    return path.stat().st_size < before


def test_a_drawing_shrinks_and_looks_as_before(
    drawing: Image.Image, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert shrunk(drawing, tmp_path / "a.png", monkeypatch)
    with Image.open(tmp_path / "a.png") as now:
        change = np.asarray(now.convert("RGB"), dtype=int) - np.asarray(drawing.convert("RGB"))
    assert np.abs(change).max() <= 8


def test_smooth_shading_and_transparency_stay(
    drawing: Image.Image, shading: Image.Image, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert not shrunk(shading, tmp_path / "a.png", monkeypatch)
    drawing.putalpha(128)
    assert not shrunk(drawing, tmp_path / "b.png", monkeypatch)

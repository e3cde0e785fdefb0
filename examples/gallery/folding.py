"""The README's pictures of shells that fold: a film strip and an animation.

Run it with ``python examples/gallery/folding.py [DIRECTORY]``; it draws docs/images/folding.png and
docs/images/folding.gif.
"""

from __future__ import annotations

import sys
from io import BytesIO
from pathlib import Path

import numpy as np
from drawing import EXAMPLES, LOCKED, camera, draw_shell, same_scale
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from PIL import Image

from orishell.design_file import read_design_file
from orishell.motion import Mechanism

DIRECTORY = EXAMPLES.parent / "docs" / "images"
STRIP = (0.0, 0.32, 0.56, 0.78, LOCKED)
"""Shares of the drive at lock."""
STEPS, HELD = 24, 12
"""States of the animation from flat to locked, and how many frames it rests at either end."""
COLOURS = 32


def mechanism(name: str) -> Mechanism:
    """The sheet of an example's design file."""
    file = read_design_file(EXAMPLES / f"{name}.toml")
    return file.pattern.design(file.f, file.g).mechanism


def draw_strip(path: Path) -> None:
    """The ring canopy in five states side by side."""
    sheet = mechanism("canopy")
    figure = Figure(figsize=(16, 2.25), facecolor="white")
    FigureCanvasAgg(figure)
    frames = list(figure.subplots(1, len(STRIP)))
    figure.subplots_adjust(0.005, 0.0, 0.995, 1.0, wspace=0.03)
    for axes, share in zip(frames, STRIP, strict=True):
        draw_shell(axes, sheet.positions(share * sheet.target_drive), camera(-20, 34), line=0.45)
    same_scale(frames)
    figure.savefig(path, dpi=140, metadata={"Software": None})


def draw_animation(path: Path) -> None:
    """The shelter that folds up, rests, and unfolds."""
    sheet = mechanism("shelter")
    shares = 0.5 * LOCKED * (1 - np.cos(np.linspace(0, np.pi, STEPS)))
    pictures = [draw_frame(sheet, float(share)) for share in shares]
    # One palette for all frames, from the two ends: no flicker, and no rounding of our own.
    both = Image.new("RGB", (pictures[0].width, 2 * pictures[0].height))
    both.paste(pictures[0], (0, 0))
    both.paste(pictures[-1], (0, pictures[0].height))
    palette = both.quantize(COLOURS, method=Image.Quantize.MEDIANCUT)
    mapped = [each.quantize(palette=palette, dither=Image.Dither.NONE) for each in pictures]
    durations = [60] * STEPS
    durations[0] = durations[-1] = 60 * HELD
    order = [*range(STEPS), *range(STEPS - 2, 0, -1)]
    mapped[0].save(
        path,
        save_all=True,
        append_images=[mapped[k] for k in order[1:]],
        duration=[durations[k] for k in order],
        loop=0,
        optimize=False,
    )


def draw_frame(sheet: Mechanism, share: float) -> Image.Image:
    """One state of the shelter, standing on the ground, in a window that is always the same."""
    positions = sheet.positions(share * sheet.target_drive)
    positions = positions - [*positions[..., :2].mean(axis=(0, 1)), positions[..., 2].min()]
    figure = Figure(figsize=(6.8, 3.683), facecolor="white")
    FigureCanvasAgg(figure)
    axes = figure.add_axes((0, 0, 1, 1))
    draw_shell(axes, positions, camera(-52, 24), ground=0.0, line=0.7)
    axes.set_xlim(-5.1, 5.1)
    axes.set_ylim(-2.2, 3.325)
    buffer = BytesIO()
    figure.savefig(buffer, dpi=100)
    return Image.open(buffer).convert("RGB")


def main() -> None:
    """Draw both."""
    directory = Path(sys.argv[1]) if len(sys.argv) > 1 else DIRECTORY
    directory.mkdir(parents=True, exist_ok=True)
    draw_strip(directory / "folding.png")
    draw_animation(directory / "folding.gif")


if __name__ == "__main__":
    main()

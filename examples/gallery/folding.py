"""The README's pictures of shells that fold: a film strip and an animation.

Run it with ``python examples/gallery/folding.py [DIRECTORY]``; it draws docs/images/folding.png and
docs/images/folding.gif.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from io import BytesIO
from pathlib import Path

import numpy as np
from drawing import EXAMPLES, LOCKED, Array, camera, draw_shell, draw_ties, same_scale
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from PIL import Image

from orishell import Design
from orishell.deployment import Tie
from orishell.design_file import read_design_file
from orishell.shell.designed import designed
from orishell.shell.make import make_shell
from orishell.shell.steps import MEASURES

DIRECTORY = EXAMPLES.parent / "docs" / "images"
STRIP = (0.0, 0.32, 0.56, 0.78, LOCKED)
"""Shares of the drive at lock."""
STEPS, HELD = 24, 16
"""States of the animation from bundle to target, and how many frames it rests at either end."""
COLOURS = 96
FINE = 24
"""Cells along a panel's side where panels lie as close as in the pack."""


def design(name: str) -> Design:
    """The design of an example's design file."""
    return designed(read_design_file(EXAMPLES / f"{name}.toml"))


def draw_strip(path: Path) -> None:
    """The ring canopy in five states side by side."""
    sheet = design("canopy").mechanism
    figure = Figure(figsize=(16, 2.25), facecolor="white")
    FigureCanvasAgg(figure)
    frames = list(figure.subplots(1, len(STRIP)))
    figure.subplots_adjust(0.005, 0.0, 0.995, 1.0, wspace=0.03)
    for axes, share in zip(frames, STRIP, strict=True):
        draw_shell(axes, sheet.positions(share * sheet.target_drive), camera(-20, 34), line=0.45)
    same_scale(frames)
    figure.savefig(path, dpi=140, metadata={"Software": None})


def draw_animation(path: Path) -> None:
    """The shelter is opened from its pack until its ties are taut, and closed again."""
    file = read_design_file(EXAMPLES / "shelter_snow.toml")
    shell = make_shell(file, clash="unexamined", skip=(*MEASURES, "stock", "structure", "remedies"))
    sheet, deployment = shell.design.mechanism, shell.report.deployment
    assert deployment is not None
    assert shell.lock is not None
    # Its length goes with the cosine: steps of the drive would throw it open.
    eased = 0.5 * (1 - np.cos(np.linspace(0, np.pi, STEPS)))
    ends = np.cos(0.5 * np.array([shell.lock.closes_to, sheet.target_drive]))
    drives = 2 * np.arccos(ends[0] + eased * (ends[1] - ends[0]))
    pictures = [draw_frame(sheet.positions(drive), deployment.ties) for drive in drives]
    # One palette for all frames, from some of them: no flicker, and no rounding of our own.
    some = pictures[::3]
    height = pictures[0].height
    stack = Image.new("RGB", (pictures[0].width, len(some) * height))
    for k, picture in enumerate(some):
        stack.paste(picture, (0, k * height))
    palette = stack.quantize(COLOURS, method=Image.Quantize.MEDIANCUT)
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


def draw_frame(positions: Array, ties: Sequence[Tie]) -> Image.Image:
    """One state of the shelter, standing on the ground, in a window that is always the same."""
    positions = positions - [*positions[..., :2].mean(axis=(0, 1)), positions[..., 2].min()]
    figure = Figure(figsize=(6.8, 3.86), facecolor="white")
    FigureCanvasAgg(figure)
    axes = figure.add_axes((0, 0, 1, 1))
    view = camera(-40, 24)
    draw_shell(axes, positions, view, ground=0.0, line=0.7, cells=FINE)
    draw_ties(axes, positions, ties, view)
    axes.set_xlim(-3.6, 3.8)
    axes.set_ylim(-1.5, 2.7)
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

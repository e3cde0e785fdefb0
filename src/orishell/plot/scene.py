"""What the pictures share: the camera, the curves f and g, frames and line widths."""

from __future__ import annotations

import struct
import zlib
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from orishell.conventions.colours import LIGHT
from orishell.conventions.record import record
from orishell.numerics.arrays import Array

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.cm import ScalarMappable
    from matplotlib.figure import Figure

LAMP = (-0.45, 0.75, 0.70)
"""Where light comes from: to the right, towards the viewer, up."""
SHADE = 0.12
"""Panels that turn away from the light are darker by this share."""
DPI = 200
GRID: dict[str, Any] = {"visible": True, "color": "#e4e4e4", "linewidth": 0.6}
WIDTH = 13.0
"""Of every picture, in inches."""
HEADING, TITLE, LEGEND, BORDER = 0.45, 0.4, 0.45, 0.12
"""Heights of a picture's heading, of the title above each of its parts and of the legend below it,
and what stays free around a part (inches)."""


@record
class Camera:
    """Parallel projection from a direction given by azimuth and elevation (radians)."""

    azimuth: float
    elevation: float

    def axes(self) -> tuple[Array, Array, Array]:
        """Unit vectors to the right, up, and towards the viewer."""
        ca, sa = np.cos(self.azimuth), np.sin(self.azimuth)
        ce, se = np.cos(self.elevation), np.sin(self.elevation)
        towards = np.array([ca * ce, sa * ce, se])
        right = np.array([-sa, ca, 0.0])
        return right, np.cross(towards, right), towards

    def project(self, points: Array) -> tuple[Array, Array]:
        """Picture coordinates (..., 2) and depth towards the viewer (...)."""
        right, up, towards = self.axes()
        return points @ np.stack([right, up], axis=-1), points @ towards


def choose_camera(positions: Array) -> Camera:
    """From above, looking across the longer side of the shell's plan."""
    plan = positions[..., :2].reshape(-1, 2)
    centred = plan - plan.mean(axis=0)
    along = np.linalg.svd(centred, full_matrices=False)[2][0]
    along = along if along[0] >= 0 else -along
    azimuth = np.arctan2(along[1], along[0]) - np.deg2rad(58)
    return Camera(float(azimuth), float(np.deg2rad(40)))


def brightness(normals: Array, camera: Camera) -> Array:
    """Brightness (...) of faces with unit normals (..., 3), lit from the upper left."""
    right, up, towards = camera.axes()
    lamp = LAMP[0] * right + LAMP[1] * towards + LAMP[2] * up
    facing = np.abs(normals @ (lamp / np.linalg.norm(lamp)))
    return np.asarray(1 - SHADE + SHADE * facing)


def row_height(width: float, pictures: list[Array]) -> float:
    """Height (inches) that shows pictures (..., 2) as wide as they may be, within reason."""
    spans = [np.ptp(picture.reshape(-1, 2), axis=0) for picture in pictures]
    return float(np.clip(width * max(span[1] / span[0] for span in spans), 1.6, 7.0))


def new_figure(height: float, heading: str, colour: str = "black") -> Figure:
    """An empty picture of a height (inches) with a heading."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(WIDTH, height), dpi=DPI, facecolor="white")
    middle = 1 - 0.5 * HEADING / height
    figure.text(
        0.5, middle, heading, fontsize=15, fontweight="bold", ha="center", va="center", color=colour
    )
    return figure


def new_chart(size: tuple[float, float] = (8.0, 5.2)) -> Figure:
    """An empty picture of a size (inches) for charts, which find their places themselves."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure
    from matplotlib.layout_engine import ConstrainedLayoutEngine

    layout = ConstrainedLayoutEngine(h_pad=0.1, w_pad=0.1)
    figure = Figure(figsize=size, facecolor="white", layout=layout)
    FigureCanvasAgg(figure)
    return figure


def save_chart(figure: Figure, path: Path) -> None:
    """Write a chart as PNG, without the name of the program that drew it."""
    figure.savefig(path, dpi=DPI, metadata={"Software": None})


def colour_scale(low: float, high: float, colours: Sequence[str]) -> ScalarMappable:
    """Colours for numbers from ``low`` to ``high``."""
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import LinearSegmentedColormap, Normalize

    return ScalarMappable(Normalize(low, high), LinearSegmentedColormap.from_list("scale", colours))


def add_part(figure: Figure, left: float, bottom: float, width: float, height: float) -> Axes:
    """A part of a picture (inches), which has a title above it and may have a legend below."""
    across, up = figure.get_size_inches()
    inner = width - 2 * BORDER
    return figure.add_axes(((left + BORDER) / across, bottom / up, inner / across, height / up))


def set_title(axes: Axes, title: str) -> None:
    """A title at a fixed place, for which matplotlib need not measure what else is there."""
    axes.set_title(title, y=1.0)


def save(figure: Figure, path: Path) -> None:
    """Draw a picture and write it as PNG."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    canvas: Any = FigureCanvasAgg(figure)
    canvas.draw()
    path.write_bytes(_png(np.asarray(canvas.buffer_rgba())[..., :3]))


def _png(pixels: Array) -> bytes:
    """A PNG file of pixels (H, W, 3), bytes.

    All rows are written as differences from the pixel to the left: as small as with a filter chosen
    for each, in a third of the time.
    """
    height, width, _ = pixels.shape
    rows = np.empty((height, 1 + 3 * width), np.uint8)
    rows[:, 0] = 1
    rows[:, 1:4] = pixels[:, 0]
    np.subtract(pixels[:, 1:], pixels[:, :-1], out=rows[:, 4:].reshape(height, width - 1, 3))
    size = struct.pack(">2I5B", width, height, 8, 2, 0, 0, 0)
    to_metre = round(DPI / 0.0254)
    chunks = {
        b"IHDR": size,
        b"pHYs": struct.pack(">2IB", to_metre, to_metre, 1),
        b"IDAT": zlib.compress(rows.tobytes(), 3),
        b"IEND": b"",
    }
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))
        for name, body in chunks.items()
    )


def line_width(picture: Array, inches: float, widest: float, share: float) -> float:
    """Line width (points) of a grid (rows, columns, 2) drawn ``inches`` wide."""
    points = 72 * inches / float(np.ptp(picture[..., 0]))
    steps = [np.linalg.norm(np.diff(picture, axis=axis), axis=-1) for axis in (0, 1)]
    return float(np.clip(share * points * min(np.median(step) for step in steps), 0.1, widest))


def draw_targets(axes: Axes, targets: Mapping[str, Array], camera: Camera) -> None:
    """Target curves on top of the shell, with a pale outline."""
    from matplotlib.patheffects import Normal, Stroke

    for name, label in (("f", "f, the swept curve"), ("g", "g, swept along")):
        if name in targets:
            curve = camera.project(targets[name])[0]
            outline = [Stroke(linewidth=4.5, foreground="white", alpha=0.8), Normal()]
            colour = LIGHT[f"curve-{name}"]
            axes.plot(*curve.T, color=colour, linewidth=2.2, label=label, path_effects=outline)
    if targets:
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.01), ncols=2, frameon=False)


def draw_lines(axes: Axes, lines: Array, colour: str, width: float, style: Any = "-") -> None:
    """Draw lines (L, 2, 2) of one look."""
    from matplotlib.collections import LineCollection

    axes.add_collection(
        LineCollection(list(lines), colors=colour, linewidths=width, linestyles=[style])
    )


def frame(axes: Axes, picture: Array) -> None:
    """Show all of a picture (P, 2), to scale and without axes."""
    low, high = picture.min(axis=0), picture.max(axis=0)
    margin = 0.03 * (high - low).max()
    axes.set_xlim(low[0] - margin, high[0] + margin)
    axes.set_ylim(low[1] - margin, high[1] + margin)
    axes.set_aspect("equal")
    axes.axis("off")

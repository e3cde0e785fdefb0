"""The deviation picture: the locked shell coloured by its signed distance to the surface."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from orishell.colours import DISTANCE_MAP
from orishell.motion import panel_normals
from orishell.plot.scene import (
    DPI,
    WIDTH,
    Camera,
    choose_camera,
    draw_targets,
    frame,
    line_width,
    row_height,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.cm import ScalarMappable

Array = NDArray[np.float64]
Booleans = NDArray[np.bool_]

CREASE = (0.15, 0.15, 0.18)
LIGHT = np.array([-0.45, -0.55, 0.70])
SHADE = 0.12
"""Panels that turn away from the light are darker by this share."""


def plot_deviation(
    path: Path,
    points: Array,
    distances: Array,
    creases: tuple[Booleans, Booleans],
    targets: Mapping[str, Array],
    *,
    title: str,
    note: str,
    unit: str,
) -> None:
    """Write the deviation picture as PNG.

    Parameters
    ----------
    path
        The file.
    points
        Points of the locked shell (A, B, 3), by rows and columns.
    distances
        Their signed distances from the surface (A, B), in the unit.
    creases
        Which rows (A,) and which columns (B,) of the points lie along rows and columns of creases,
        the first and the last included.
    targets
        Target curves "f" and "g" (N, 3).
    title, note
        Heading, and a line below it.
    unit
        Unit of length.
    """
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure
    from matplotlib.layout_engine import ConstrainedLayoutEngine

    camera = choose_camera(points)
    picture = camera.project(points)[0]
    layout = ConstrainedLayoutEngine(h_pad=0.12, w_pad=0.12)
    height = row_height(0.9 * WIDTH, [picture]) + 0.6
    figure = Figure(figsize=(WIDTH, height), facecolor="white", layout=layout)
    FigureCanvasAgg(figure)
    figure.suptitle(title, fontsize=15, fontweight="bold")
    axes = figure.add_subplot()
    axes.set_title(note)
    scale = _draw_cells(axes, points, distances, creases, camera)
    draw_targets(axes, targets, camera)
    shown = [picture.reshape(-1, 2), *(camera.project(curve)[0] for curve in targets.values())]
    frame(axes, np.concatenate(shown))
    bar = figure.colorbar(scale, ax=axes, shrink=0.8, aspect=30, pad=0.02)
    bar.set_label(f"distance from the surface ({unit}), positive above it")
    figure.savefig(path, dpi=DPI, metadata={"Software": None})


def _draw_cells(
    axes: Axes,
    points: Array,
    distances: Array,
    creases: tuple[Booleans, Booleans],
    camera: Camera,
) -> ScalarMappable:
    """Panels from the farthest to the nearest: each its cells, then its outline."""
    from matplotlib.cm import ScalarMappable
    from matplotlib.collections import PolyCollection
    from matplotlib.colors import LinearSegmentedColormap, Normalize

    limit = float(np.abs(distances).max()) or 1.0
    scale = ScalarMappable(
        Normalize(-limit, limit), LinearSegmentedColormap.from_list("distance", DISTANCE_MAP)
    )
    rows, columns = (np.flatnonzero(each) for each in creases)
    panels = points[np.ix_(rows, columns)]
    depth = camera.project(_corners(panels))[1].mean(axis=-1)
    light = _brightness(panels, camera)

    of_row = np.searchsorted(rows, np.arange(points.shape[0] - 1), side="right") - 1
    of_column = np.searchsorted(columns, np.arange(points.shape[1] - 1), side="right") - 1
    panel = np.ix_(of_row, of_column)
    corners = [distances[:-1, :-1], distances[1:, :-1], distances[1:, 1:], distances[:-1, 1:]]
    colours = np.asarray(scale.to_rgba(np.mean(corners, axis=0)))
    colours[..., :3] *= light[panel][..., None]

    cells = camera.project(_corners(points))[0].reshape(-1, 4, 2)
    outlines = camera.project(_corners(panels))[0].reshape(-1, 4, 2)
    faces = np.concatenate([colours.reshape(-1, 4), np.zeros((len(outlines), 4))])
    edges = np.concatenate([colours.reshape(-1, 4), np.tile([*CREASE, 0.8], (len(outlines), 1))])
    order = np.lexsort(
        (
            np.repeat([0, 1], [len(cells), len(outlines)]),
            np.concatenate([depth[panel].ravel(), depth.ravel()]),
        )
    )
    crease = line_width(camera.project(panels)[0], 0.9 * WIDTH, 0.6, 0.12)
    widths = np.repeat([0.3, crease], [len(cells), len(outlines)])
    axes.add_collection(
        PolyCollection(
            list(np.concatenate([cells, outlines])[order]),
            facecolors=faces[order],
            edgecolors=edges[order],
            linewidths=widths[order],
        )
    )
    return scale


def _corners(points: Array) -> Array:
    return np.stack([points[:-1, :-1], points[1:, :-1], points[1:, 1:], points[:-1, 1:]], axis=-2)


def _brightness(positions: Array, camera: Camera) -> Array:
    """Brightness of every panel, lit from the upper left."""
    right, up, towards = camera.axes()
    lamp = LIGHT[0] * right + LIGHT[2] * up + 0.75 * towards
    facing = np.abs(panel_normals(positions) @ (lamp / np.linalg.norm(lamp)))
    return np.asarray(1 - SHADE + SHADE * facing)

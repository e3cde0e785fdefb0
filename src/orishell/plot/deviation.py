"""The deviation picture: the locked shell coloured by its signed distance to the surface."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.colours import DISTANCE_MAP
from orishell.motion import panel_normals
from orishell.motion.quads import grid_corners
from orishell.numerics.arrays import Array, Booleans
from orishell.plot.scene import (
    BORDER,
    HEADING,
    LEGEND,
    TITLE,
    WIDTH,
    Camera,
    add_part,
    brightness,
    choose_camera,
    colour_scale,
    draw_targets,
    frame,
    line_width,
    new_figure,
    row_height,
    save,
    set_title,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.cm import ScalarMappable

SHARE = 0.9
"""The part of the picture's width that the shell is drawn in, beside the bar of colours."""


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
    camera = choose_camera(points)
    picture = camera.project(points)[0]
    height = row_height(SHARE * WIDTH, [picture])
    figure = new_figure(LEGEND + height + TITLE + HEADING, title)
    axes = add_part(figure, 0, LEGEND, SHARE * WIDTH, height)
    set_title(axes, note)
    scale = _draw_cells(axes, points, distances, creases, camera)
    draw_targets(axes, targets, camera)
    shown = [picture.reshape(-1, 2), *(camera.project(curve)[0] for curve in targets.values())]
    frame(axes, np.concatenate(shown))
    bottom, tall = LEGEND + 0.1 * height, 0.8 * height
    beside = add_part(figure, SHARE * WIDTH, bottom, 2 * BORDER + 0.15, tall)
    bar = figure.colorbar(scale, cax=beside)
    bar.set_label(f"distance from the surface ({unit}), positive above it")
    save(figure, path)


def _draw_cells(
    axes: Axes,
    points: Array,
    distances: Array,
    creases: tuple[Booleans, Booleans],
    camera: Camera,
) -> ScalarMappable:
    """Panels from the farthest to the nearest, coloured smoothly within each."""
    from matplotlib.path import Path as Outline

    from orishell.plot.shading import draw_panels, quad_triangles

    limit = float(np.abs(distances).max()) or 1.0
    scale = colour_scale(-limit, limit, DISTANCE_MAP)
    rows, columns = (np.flatnonzero(each) for each in creases)
    panels = points[np.ix_(rows, columns)]
    picture, depth = camera.project(grid_corners(panels))
    order = np.argsort(depth.mean(axis=-1).ravel(), kind="stable")

    of_row = np.searchsorted(rows, np.arange(points.shape[0] - 1), side="right") - 1
    of_column = np.searchsorted(columns, np.arange(points.shape[1] - 1), side="right") - 1
    panel = np.add.outer(of_row * (len(columns) - 1), of_column).ravel()
    colours = grid_corners(np.asarray(scale.to_rgba(distances))).reshape(-1, 4, 4)
    colours[..., :3] *= brightness(panel_normals(panels), camera).ravel()[panel, None, None]

    corners = camera.project(grid_corners(points))[0].reshape(-1, 4, 2)
    outlines = np.take(picture, [0, 1, 2, 3, 0], axis=-2).reshape(-1, 5, 2)
    draw_panels(
        axes,
        (quad_triangles(corners), quad_triangles(colours), np.repeat(panel, 2)),
        order,
        [*map(Outline, outlines)],
        edge=(0.15, 0.15, 0.18, 0.8),
        width=line_width(camera.project(panels)[0], SHARE * WIDTH, 0.6, 0.12),
    )
    return scale

"""Drawings of states: what is drawn last at a place is what is nearest there."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

from documents import demo_document, slit_document
from orishell.document import SHELL, Document
from orishell.motion.quads import unit_normals
from orishell.workshop.kit import line_drawing
from orishell.workshop.kit.line_drawing import (
    MOST_PANELS,
    RISE_DEG,
    TURN_DEG,
    draw_lines,
    view_axes,
)

CLEAR = 1e-4
"""Depths nearer than this share of the shell are one: panels that lie on each other."""
SAMPLES = 400


@pytest.mark.parametrize(
    "document",
    [demo_document(), demo_document("orthodiagonal"), slit_document()],
    ids=["parallel-repeating", "orthodiagonal", "slit"],
)
@pytest.mark.parametrize("which", [SHELL, 1])
def test_the_panel_drawn_last_is_the_nearest(document: Document, which: int | str) -> None:
    # Rays through random points of the drawing meet the planes of panels: no sorting is asked.
    drawing = draw_lines(document, which)
    seen = document.panel_corners(document.state(which)) @ view_axes(TURN_DEG, RISE_DEG).T
    normals, middles = unit_normals(seen), seen.mean(axis=1)
    low, high = drawing.box
    points = np.random.default_rng(3).uniform(low, high, (SAMPLES, 2))
    panels = shapely.polygons(seen[..., :2])
    drawn = shapely.polygons(drawing.outlines)
    size, compared = float(np.ptp(seen)), 0
    for point in points:
        spot = shapely.Point(point)
        under = np.flatnonzero(shapely.contains(panels, spot))
        under = under[np.abs(normals[under, 2]) > 1e-3]
        if not len(under):
            continue
        away = point - middles[under, :2]
        depth = middles[under, 2] - (normals[under, :2] * away).sum(axis=1) / normals[under, 2]
        last = drawing.outlines[np.flatnonzero(shapely.contains(drawn, spot))[-1]]
        (which_panel,) = np.flatnonzero(
            np.abs(seen[under][..., :2] - last).max(axis=(1, 2)) < 1e-12 * size
        )[:1]
        assert depth[which_panel] > depth.max() - CLEAR * size
        compared += 1
    assert compared > 0.2 * SAMPLES


def test_of_many_panels_some_rows_and_columns_are_drawn(monkeypatch: pytest.MonkeyPatch) -> None:
    document = demo_document()
    panels = len(document.mesh.faces)
    whole = draw_lines(document, SHELL)
    assert panels < MOST_PANELS
    assert (whole.every, len(whole.outlines)) == (1, panels)
    monkeypatch.setattr(line_drawing, "MOST_PANELS", panels // 4 - 1)
    coarse = draw_lines(document, SHELL)
    assert (
        coarse.every == 3
    )  # the least whose square is at least panels / MOST_PANELS, which is over 4
    assert len(coarse.outlines) < panels / 4
    # All four corners of the sheet are drawn.
    assert document.grid_shape is not None
    rows, columns = document.grid_shape
    corners = [0, columns - 1, (rows - 1) * columns, rows * columns - 1]
    placed = (document.shell.positions[corners] @ view_axes(TURN_DEG, RISE_DEG).T)[:, :2]
    gap = np.abs(placed[:, None] - coarse.outlines.reshape(-1, 2)[None]).max(axis=-1).min(axis=1)
    assert gap.max() < 1e-12 * np.ptp(whole.outlines)

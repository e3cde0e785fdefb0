"""Panels coloured smoothly between the corners of their triangles, drawn one behind the other."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.path import Path as Outline

from orishell.numerics.arrays import Array, Integers

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.backend_bases import RendererBase


def draw_panels(
    axes: Axes,
    cells: tuple[Array, Array, Integers],
    order: Integers,
    outlines: Sequence[Outline],
    *,
    edge: tuple[float, ...],
    width: float,
) -> None:
    """Draw panels, each coloured smoothly within its outline, so that nearer ones are on top.

    cells: Corners (T, 3, 2) of triangles, colours (T, 3, 4) at these, and their panels (T,).
    order: The panels (P,) from the farthest to the nearest.
    edge, width: Colour and width (points) of the outlines.
    """
    triangles, colours, panel = cells
    behind = np.argsort(np.argsort(order)[panel], kind="stable")
    ends = np.cumsum(np.bincount(panel, minlength=len(order))[order])
    lines = [outlines[each] for each in order]
    shaded = _ShadedPanels(triangles[behind], colours[behind], ends, lines)
    shaded.edge, shaded.width = edge, width
    axes.add_artist(shaded)


def quad_triangles(values: Array) -> Array:
    """Values (2 C, 3, ...) at the corners of the two triangles of quads (C, 4, ...)."""
    return values[:, [0, 1, 2, 0, 2, 3]].reshape(-1, 3, *values.shape[2:])


class _ShadedPanels(Artist):
    """Panels, each its triangles, which end with ``ends`` (P,), and then its outline."""

    edge: tuple[float, ...]
    width: float

    def __init__(
        self, triangles: Array, colours: Array, ends: Integers, outlines: Sequence[Outline]
    ) -> None:
        super().__init__()
        self.triangles, self.colours = triangles, colours
        self.ends, self.outlines = ends, outlines

    def draw(self, renderer: RendererBase) -> None:
        """Draw all panels."""
        agg: Any = renderer
        assert self.axes is not None  # a renderer draws what has been added to axes
        transform = self.axes.transData
        pen = agg.new_gc()
        pen.set_foreground(self.edge, isRGBA=True)
        pen.set_linewidth(self.width)
        pen.set_joinstyle("miter")
        begin = 0
        for end, outline in zip(self.ends, self.outlines, strict=True):
            agg.draw_gouraud_triangles(
                pen, self.triangles[begin:end], self.colours[begin:end], transform
            )
            agg.draw_path(pen, outline, transform)
            begin = end
        pen.restore()

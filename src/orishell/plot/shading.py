"""Panels coloured smoothly between the corners of their triangles, drawn one behind the other."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from matplotlib.artist import Artist
from matplotlib.path import Path as Outline

from orishell.numerics.arrays import Array, Integers

if TYPE_CHECKING:
    from matplotlib.backend_bases import RendererBase


def quad_triangles(values: Array) -> Array:
    """Values (2 C, 3, ...) at the corners of the two triangles of quads (C, 4, ...)."""
    return values[:, [0, 1, 2, 0, 2, 3]].reshape(-1, 3, *values.shape[2:])


class ShadedPanels(Artist):
    """Panels, each its triangles and then its outline, so that a nearer one covers a farther one.

    triangles: Corners (T, 3, 2) of the triangles of all panels.
    colours: Colours (T, 3, 4) at these corners.
    ends: Where the triangles of each panel (P,) end.
    outlines: Outlines of the panels, from the farthest to the nearest.
    edge: Colour of the outlines.
    width: Their width (points).
    """

    def __init__(
        self,
        triangles: Array,
        colours: Array,
        ends: Integers,
        outlines: Sequence[Outline],
        *,
        edge: tuple[float, ...],
        width: float,
    ) -> None:
        super().__init__()
        self.triangles, self.colours = triangles, colours
        self.ends, self.outlines, self.edge, self.width = ends, outlines, edge, width

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

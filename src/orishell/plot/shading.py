"""Quads coloured smoothly between their corners, drawn one behind the other."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from matplotlib.artist import Artist
from matplotlib.path import Path

from orishell.numerics.arrays import Array, Integers

if TYPE_CHECKING:
    from matplotlib.backend_bases import RendererBase


TRIANGLES = [0, 1, 2, 0, 2, 3]
"""Corners of the two triangles of a quad."""


class ShadedPanels(Artist):
    """Panels, each its cells and then its outline, so that a nearer one covers a farther one.

    Parameters
    ----------
    cells
        Corners (C, 4, 2) of the cells of all panels.
    colours
        Colours (C, 4, 4) at these corners.
    ends
        Where the cells of each panel (P,) end.
    outlines
        Closed outlines (P, 5, 2) of the panels, from the farthest to the nearest.
    edge
        Colour of the outlines.
    width
        Their width (points).
    """

    def __init__(
        self,
        cells: Array,
        colours: Array,
        ends: Integers,
        outlines: Array,
        *,
        edge: tuple[float, ...],
        width: float,
    ) -> None:
        super().__init__()
        self.triangles = cells[:, TRIANGLES].reshape(-1, 3, 2)
        self.colours = colours[:, TRIANGLES].reshape(-1, 3, 4)
        self.ends, self.outlines, self.edge, self.width = 2 * ends, outlines, edge, width

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
            agg.draw_path(pen, Path(outline), transform)
            begin = end
        pen.restore()

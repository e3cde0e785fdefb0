"""The boards of a sheet: what is built of its panels, set back from creases."""

from __future__ import annotations

import numpy as np

from orishell.design import PanelSpec
from orishell.motion.boards import Boards
from orishell.motion.grid import CreaseValues, Grid
from orishell.numerics.arrays import Array, Booleans
from orishell.solids.outlines import inset_panels
from orishell.solids.setbacks import find_set_backs


def build_boards(
    flat: Array,
    grid: Grid,
    build: PanelSpec,
    folds: CreaseValues,
    reliefs: Array | None = None,
) -> Boards:
    """The boards of all panels.

    A sandwich has two on each panel, square cut, the upper one first; where a crease folds flat the
    panels beside it have none on its closing side. A bevelled panel is one solid: on the hinge
    plane it stands back by half the gap, on its faces as far as boards do, and it is straight in
    between.

    Parameters
    ----------
    flat
        Vertices (rows, columns, 3) of the flat sheet.
    grid
        Its grid.
    build
        What panels are made of.
    folds
        The largest fold angles, in [-pi, pi], valley positive (radians).
    reliefs
        How far corners are cut off at every vertex (rows, columns) (length); None if none is.

    Raises
    ------
    DesignError
        If nothing is left of a panel.
    """
    faces = grid.faces_vertices()
    panels = flat.reshape(-1, 3)[faces, :2]
    back = find_set_backs(folds, build.height, build.gap)
    edges = grid.faces_edges()
    cut = None if reliefs is None else reliefs.ravel()[faces]
    there: list[Booleans] = [
        np.asarray(np.isfinite(each[edges]).all(axis=1)) for each in (back.top, back.bottom)
    ]

    def outline(distance: Array, present: Booleans) -> Array:
        kept = None if cut is None else cut[present]
        return inset_panels(panels[present], distance[edges][present], grid, kept)

    if build.construction == "bevel":
        middle = find_set_backs(folds, 0.0, build.gap).top
        solid = there[0] & there[1]
        levels = [(back.bottom, -build.height), (middle, 0.0), (back.top, build.height)]
        outlines = np.stack([_at(outline(d, solid), z) for d, z in levels], axis=1)
        return Boards(np.flatnonzero(solid), np.zeros(int(solid.sum()), np.int64), outlines)

    low, high = 0.5 * build.membrane, build.height
    made = []
    for side, distance, present in ((1, back.top, there[0]), (-1, back.bottom, there[1])):
        flat_outline = outline(distance, present)
        ends = (low, high) if side > 0 else (-high, -low)
        number = np.flatnonzero(present)
        made.append(
            (number, np.full(len(number), side), np.stack([_at(flat_outline, z) for z in ends], 1))
        )
    panels_of, sides, outlines = (np.concatenate(each) for each in zip(*made, strict=True))
    order = np.lexsort([-sides, panels_of])
    return Boards(panels_of[order], sides[order], outlines[order])


def _at(outline: Array, height: float) -> Array:
    """Corners (F, K, 3) of outlines (F, K, 2) at a height over the hinge plane."""
    return np.concatenate([outline, np.full((*outline.shape[:2], 1), height)], axis=-1)

"""A state of a shell as panels to be drawn one over the other, farthest first.

Panels are drawn without their thickness. The side that is up in the flat sheet is white, the other
grey, and parts that go with the sheet are dark.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from orishell.conventions.record import record
from orishell.document import FLAT, OPEN, Document, DocumentState
from orishell.motion.quads import area_vectors, unit_normals
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.workshop.kit.folding import CreaseLines

MOST_PANELS: Final = 1500
"""Panels that are drawn, about, at most: of more rows and columns of a grid every k-th is."""
TURN_DEG, RISE_DEG = -55.0, 24.0
"""From where shells are seen: about z, and above the ground (degrees)."""
OVERLAP: Final = 1e-6
"""Panels that share less than this share of a panel's area in the drawing hide nothing."""
APART: Final = 1e-7
"""Panels nearer to each other than this share of the drawing lie on each other."""
ABOVE: Final = 90.0
"""The rise from which a sheet is seen as a plan (degrees)."""


@record
class LineDrawing:
    """Panels as they are seen, in the document's unit, farthest first."""

    outlines: Array  # corners (F, 4, 2)
    fronts: Booleans  # whether each (F,) shows the side that is up in the flat sheet
    beside: Booleans  # whether each (F,) is of another part than the sheet
    lines: Array  # over them (K, 2, 2): ties
    points: Array  # over them (M, 2): feet
    mountains: Array  # creases over them (K, 2, 2), that are about to be folded
    valleys: Array  # the same of valleys
    every: int  # of so many rows and columns of the sheet one is drawn; 1 for all

    @property
    def box(self) -> tuple[Array, Array]:
        """Its lower left and upper right corners (2,)."""
        points = self.outlines.reshape(-1, 2)
        return points.min(axis=0), points.max(axis=0)


def draw_lines(
    document: Document,
    which: int | str,
    panels: Booleans | None = None,
    joined: Integers | None = None,
    marked: Integers | None = None,
    *,
    thick: CreaseLines | None = None,
    plan: bool = False,
) -> LineDrawing:
    """A state with all parts that are there, by number or name, as ``which`` says.

    panels: Which (F,) are drawn; all if None.
    joined: Vertices (K, 2) between which lines are drawn over all; none if None.
    marked: Vertices (M,) that are marked; none if None.
    thick: Creases that are drawn over all; none if None.
    plan: Whether it is seen from above, x to the right.

    Raises InputError if there is no such state.
    """
    corners, beside, every = _drawn_corners(document, which, panels)
    axes = view_axes(0.0, ABOVE) if plan else view_axes(TURN_DEG, RISE_DEG)
    seen = corners @ axes.T
    order = _farthest_first(seen)
    positions = drawn_state(document, which).positions
    ends, spots = (np.zeros(0, np.int64) if each is None else each for each in (joined, marked))
    lines = (positions[ends.reshape(-1, 2)] @ axes.T)[..., :2]
    points = (positions[spots] @ axes.T)[..., :2]
    creases = (np.zeros((0, 2), np.int64),) * 2
    if thick is not None:
        creases = thick.mountains, thick.valleys
    mountains, valleys = ((positions[each] @ axes.T)[..., :2] for each in creases)
    fronts = area_vectors(seen)[order, 2] > 0
    besides = order >= len(seen) - beside
    outlines = seen[order, :, :2]
    return LineDrawing(outlines, fronts, besides, lines, points, mountains, valleys, every)


def drawn_state(document: Document, which: int | str) -> DocumentState:
    """A state; where strips are flat in none, and are asked for so, as they lie to be cut."""
    if which != FLAT or OPEN not in document.named:
        return document.state(which)
    flat = document.require_flat()
    return DocumentState(np.column_stack([flat, np.zeros(len(flat))]))


def view_axes(turn_deg: float, rise_deg: float) -> Array:
    """To the right, upwards and towards who looks (3, 3), in the document's frame."""
    turn, rise = np.deg2rad([turn_deg, rise_deg])
    right = np.array([np.cos(turn), np.sin(turn), 0.0])
    behind = np.array([-np.sin(turn), np.cos(turn), 0.0])
    up = np.sin(rise) * behind + np.array([0.0, 0.0, np.cos(rise)])
    return np.stack([right, up, np.cross(right, up)])


def _drawn_corners(
    document: Document, which: int | str, panels: Booleans | None
) -> tuple[Array, int, int]:
    """Corners (F, 4, 3) of what is drawn, panels of the sheet first, how many others there are.

    And of how many rows and columns one is drawn.
    """
    state = drawn_state(document, which)
    chosen = np.ones(len(document.mesh.faces), np.bool_) if panels is None else panels
    shape = document.grid_shape
    if which == FLAT and OPEN in document.named:
        return state.positions[document.mesh.faces[chosen]], 0, 1
    if shape is not None and chosen.sum() > MOST_PANELS:
        every = int(np.ceil(np.sqrt(chosen.sum() / MOST_PANELS)))
        grid = state.positions[: shape[0] * shape[1]].reshape(*shape, 3)
        rows, columns = (_thinned(count, every) for count in shape)
        grid = grid[rows][:, columns]
        around = [grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]]
        return np.stack(around, axis=2).reshape(-1, 4, 3), 0, every
    sheet, *others = (part.panel_corners(own) for part, own in document.parts_in(which))
    if panels is not None:
        sheet, others = sheet[chosen], []
    return np.concatenate([sheet, *others]), sum(map(len, others)), 1


def _thinned(count: int, every: int) -> Integers:
    """Numbers of the lines that are drawn of so many, both borders included."""
    return np.unique(np.append(np.arange(0, count, every), count - 1))


def _farthest_first(seen: Array) -> Integers:
    """The order (F,) in which panels (F, 4, 3) are drawn so that none hides one before it.

    Which of two comes first is asked where they overlap; where that goes in circles, as among
    panels that pass through each other, their middles say it.
    """
    from graphlib import TopologicalSorter

    # Rounded: which of two equals is first must not depend on the last bit.
    depth = np.round(seen[..., 2].mean(axis=1) / (APART * float(np.ptp(seen)) or 1.0))
    before, after = _hiding(seen)
    behind: dict[int, list[int]] = {number: [] for number in np.argsort(depth, kind="stable")}
    for first, second in zip(before.tolist(), after.tolist(), strict=True):
        behind[second].append(first)
    sorter = TopologicalSorter(behind)
    try:
        return np.array([*sorter.static_order()])
    except ValueError:  # a circle
        return np.argsort(depth, kind="stable")


def _hiding(seen: Array) -> tuple[Integers, Integers]:
    """Pairs of panels (K,), (K,) that overlap in the drawing, the farther one first."""
    import shapely

    flat = seen[..., :2]
    shapes = np.asarray(shapely.convex_hull(shapely.multipoints(flat)))
    first, second = shapely.STRtree(shapes).query(shapes, predicate="intersects")
    once = first < second
    first, second = first[once], second[once]
    shared = np.asarray(shapely.intersection(shapes[first], shapes[second]))
    least = OVERLAP * float(np.median(shapely.area(shapes)) or 1.0)
    large = shapely.area(shared) > least
    first, second = first[large], second[large]
    points = shapely.get_coordinates(shapely.centroid(shared[large]))
    normals, middles = unit_normals(seen), seen.mean(axis=1)

    def depth_at(panel: Integers) -> Array:
        normal, away = normals[panel], points - middles[panel, :2]
        slope = np.where(np.abs(normal[:, 2]) > 1e-9, normal[:, 2], np.inf)
        return np.asarray(middles[panel, 2] - (normal[:, :2] * away).sum(axis=1) / slope)

    nearer = depth_at(first) - depth_at(second)
    apart = np.abs(nearer) > APART * float(np.ptp(flat))
    pairs = np.stack([first, second])[:, apart]
    turned = nearer[apart] > 0
    return np.where(turned, pairs[1], pairs[0]), np.where(turned, pairs[0], pairs[1])

"""The boards of a sheet: panels set back from their creases, corners cut where need be."""

from __future__ import annotations

from itertools import combinations

import numpy as np

from orishell.conventions.errors import DesignError
from orishell.design import PanelSpec
from orishell.motion.boards import BARE, Boards
from orishell.motion.grid import CreaseValues, Grid
from orishell.motion.hinge_lines import IN_CREASES, HingeLines
from orishell.motion.hinges import Hinges
from orishell.motion.layout import Layout
from orishell.motion.quads import grid_corners
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.solids.hinged.arms import build_whole_boards
from orishell.solids.setbacks import set_backs_of
from orishell.solids.sides import FlapFolds, SideFolds

INSIDE = 1e-12
"""A corner counts as inside an edge up to this share of the panel's size."""


def inset_panels(panels: Array, distance: Array, grid: Grid, cut: Array | None = None) -> Array:
    """Return what is left of convex panels whose edges move inwards and whose corners are cut off.

    Panels are counter-clockwise (F, 4, 2). Edges move by distances (F, 4), from a corner to the
    next. Corners are cut off at distances (F, 4) along the line that halves their angle, square to
    it; not where these are 0. The outlines (F, K, 2) have K = 4 corners, or 8 if corners are cut.
    Corner k is where side k begins; where a side is gone its two corners coincide. Sides are the
    edges, or each corner's cut followed by the edge that begins there.
    """
    along = np.roll(panels, -1, axis=1) - panels
    size = np.abs(along).max(axis=(1, 2))
    inward = _unit(np.stack([-along[..., 1], along[..., 0]], axis=-1))
    level = (inward * panels).sum(axis=-1) + distance
    if cut is not None:
        halving = _unit(inward + np.roll(inward, 1, axis=1))
        far = np.where(cut > 0, cut, -np.inf)
        cut_level = (halving * panels).sum(axis=-1) + far
        inward = np.stack([halving, inward], axis=2).reshape(len(panels), 8, 2)
        level = np.stack([cut_level, level], axis=2).reshape(len(panels), 8)

    points, kept = _crossings(inward, level, size)
    if (few := kept.sum(axis=1) < 3).any():
        panel = int(few.argmax())
        row, column = divmod(panel, grid.columns - 1)
        raise DesignError(
            "boards of this thickness leave nothing of a panel",
            place=f"of panel [{row}, {column}]" if panel < grid.panel_count else "of a flap",
        )
    # Between two sides lies the corner that is farthest out between their directions.
    outward = -_unit(_unit(inward) + np.roll(inward, 1, axis=1))
    reach = np.einsum("fpx,fkx->fkp", points, outward)
    place = np.where(kept[:, None], reach, -np.inf).argmax(axis=-1)
    return np.asarray(np.take_along_axis(points, place[..., None], axis=1))


def _crossings(inward: Array, level: Array, size: Array) -> tuple[Array, Array]:
    """Crossings (F, P, 2) of all pairs of sides, and which of them (F, P) no side cuts off."""
    pairs = np.array(list(combinations(range(inward.shape[1]), 2)))
    (a, b), (p, q) = ((each[:, pairs[:, 0]], each[:, pairs[:, 1]]) for each in (inward, level))
    with np.errstate(invalid="ignore", divide="ignore"):
        area = a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]
        area = np.where(np.abs(area) > INSIDE, area, np.nan)
        points = (
            np.stack([p * b[..., 1] - q * a[..., 1], q * a[..., 0] - p * b[..., 0]], axis=-1)
            / area[..., None]
        )
        over = np.einsum("fpx,fkx->fpk", points, inward) - level[:, None]
        kept = (over > -INSIDE * size[:, None, None]).all(axis=-1)
    return np.where(kept[..., None], points, 0.0), kept


def _unit(vectors: Array) -> Array:
    return np.asarray(vectors / np.hypot(vectors[..., 0], vectors[..., 1])[..., None])


def build_boards(
    flat: Array,
    grid: Grid,
    build: PanelSpec,
    folds: CreaseValues,
    reliefs: Array | None = None,
    *,
    hinges: HingeLines = IN_CREASES,
) -> Boards:
    """The boards of all panels of a grid, set back for the largest fold angles, in [-pi, pi].

    Parameters
    ----------
    flat
        Vertices (rows, columns, 3) of the flat sheet.
    reliefs
        How far corners are cut off at every vertex (rows, columns) (length); None if none is.
    hinges
        Where the hinges are: beside the creases those of whole boards.

    Raises
    ------
    DesignError
        If nothing is left of a panel.
    """
    panels = grid_corners(flat)[..., :2].reshape(-1, 4, 2)
    return boards_on(panels, Layout.of_grid(grid), build, folds, reliefs=reliefs, hinges=hinges)


def boards_on(
    panels: Array,
    layout: Layout,
    build: PanelSpec,
    folds: CreaseValues,
    *,
    reliefs: Array | None = None,
    beside: FlapFolds | None = None,
    hinges: HingeLines = IN_CREASES,
    least: Array | float = 0.0,
) -> Boards:
    """The boards of all panels, set back for the largest fold angles, in [-pi, pi].

    A sandwich has two on each panel, square cut, the upper one first; where a crease folds flat the
    panels beside it have none on its closing side. On a face without boards half the membrane takes
    their place (:data:`~orishell.motion.boards.BARE`), from which no gap is cut. A bevelled panel
    is one solid: on the hinge plane it stands back by half the gap, on its faces as far as boards
    do, and it is straight in between. Whole boards on hinges, square cut, stand back by half the
    gap; arms follow on each.

    Parameters
    ----------
    panels
        Their corners (F, 4, 2) as they lie flat, counter-clockwise.
    reliefs
        How far corners are cut off at every vertex (rows, columns) (length); None if none is.
    beside
        The largest fold angles of flaps that are no columns of the grid, if there are such flaps.
    hinges
        Where the hinges are: beside the creases those of whole boards.
    least
        How far boards stand off sides of panels (F, 4) at least (length).

    Raises
    ------
    DesignError
        If nothing is left of a panel.
    """
    faces, grid, at_sides = layout.faces, layout.grid, SideFolds.of(layout, folds, beside)
    back = set_backs_of(at_sides, build.heights, build.gap)
    cut = None if reliefs is None else _at_corners(reliefs, faces)
    there: list[Booleans] = [
        np.asarray(np.isfinite(each).all(axis=1)) for each in (back.top, back.bottom)
    ]

    def outline(distance: Array, present: Booleans) -> Array:
        kept = None if cut is None else cut[present]
        apart = np.maximum(distance, least)[present]
        return inset_panels(panels[present], apart, grid, kept)

    if isinstance(hinges, Hinges):
        middle = set_backs_of(at_sides, 0.0, build.gap).top + hinges.cut_back
        inset = inset_panels(panels, middle, grid, cut)
        return build_whole_boards(panels, inset, hinges, build)
    if build.construction == "bevel":
        middle = set_backs_of(at_sides, 0.0, build.gap).top
        solid = there[0] & there[1]
        levels = [(back.bottom, -build.height), (middle, 0.0), (back.top, build.height)]
        outlines = np.stack([_at(outline(d, solid), z) for d, z in levels], axis=1)
        return Boards(np.flatnonzero(solid), np.zeros(int(solid.sum()), np.int64), outlines)

    whole = set_backs_of(at_sides, build.heights)  # what no gap is cut from
    made = []
    for side, high, distance, uncut, present in zip(
        (1, -1),
        build.heights,
        (back.top, back.bottom),
        (whole.top, whole.bottom),
        there,
        strict=True,
    ):
        boards, number = build.has_boards(side), np.flatnonzero(present)
        kept = outline(distance if boards else uncut, present)
        ends = (0.5 * build.membrane if boards else 0.0, high)
        outlines = np.stack([_at(kept, z) for z in sorted(side * each for each in ends)], axis=1)
        made.append((number, np.full(len(number), side if boards else BARE), outlines))
    panels_of, sides, outlines = (np.concatenate(each) for each in zip(*made, strict=True))
    order = np.lexsort([-sides, panels_of])
    return Boards(panels_of[order], sides[order], outlines[order])


def _at_corners(reliefs: Array, faces: Integers) -> Array:
    """Of reliefs (rows, columns) those at corners (F, 4); none at those that are not the grid's."""
    more = int(faces.max()) + 1 - reliefs.size
    return np.asarray(np.pad(reliefs.ravel(), (0, more))[faces])


def _at(outline: Array, height: float) -> Array:
    """Corners (F, K, 3) of outlines (F, K, 2) at a height over the hinge plane."""
    return np.concatenate([outline, np.full((*outline.shape[:2], 1), height)], axis=-1)

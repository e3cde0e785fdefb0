"""Whole boards and their arms: fins that stand on a board and carry a hinge off its faces.

A fin stands upright over its crease, on its board's side of it, from the face of the board to the
hinge, or to its knuckle. So board and fins lie within the quarter of space that is below a valley's
hinge, or above a mountain's, on their side of the crease.

The knuckle of a hinge is a cylinder about its axis. A box about it, as wide and high as it is
thick, is a body of the board above or to the left.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.formatting import rounded_down
from orishell.design import PanelSpec
from orishell.design.fittings import SHORT, TRIMMED, Fittings, fit_hinges
from orishell.motion.boards import ARM, EDGES, KNUCKLE, Boards
from orishell.motion.hinges import Hinges
from orishell.numerics.arrays import Array, Integers
from orishell.numerics.equals import first_smallest


def build_whole_boards(panels: Array, inset: Array, hinges: Hinges, build: PanelSpec) -> Boards:
    """Boards with arms and knuckles, each board followed by its own.

    Parameters
    ----------
    panels
        Corners (F, 4, 2) of the panels in the flat sheet, counter-clockwise, top left first.
    inset
        Corners (F, K, 2) of what the boards are.

    Raises
    ------
    DesignError
        If a fin is thicker than a panel has room for, or the parts of a hinge do not fit.
    """
    fittings = fit_hinges(panels, hinges, build)
    low, number = hinges.levels.ravel(), np.arange(len(panels))
    boards = _upright(inset, low, low + hinges.thickness)
    parts = [_arms(panels, hinges, build)]
    kinds = [(0 * number, number, 0 * number - 1), (0 * parts[0][0] + ARM, *parts[0][:2])]
    if hinges.knuckle:
        parts.append(_knuckles(fittings, hinges))
        kinds.append((0 * parts[1][0] + KNUCKLE, *parts[1][:2]))
    sides, carriers, edges = (np.concatenate(each) for each in zip(*kinds, strict=True))
    spare = ((0, 0), (0, 0), (0, boards.shape[2] - 4), (0, 0))
    outlines = np.concatenate([boards, *(np.pad(each, spare, mode="edge") for *_, each in parts)])
    order = np.lexsort([sides, edges, carriers])
    return Boards(carriers[order], sides[order], outlines[order], hinges, edges[order])


def _knuckles(fittings: Fittings, hinges: Hinges) -> tuple[Integers, Integers, Array]:
    """Carriers (H,), edges (H,) and boxes (H, 3, 4, 3) about all knuckles."""
    start, end = fittings.ends[:, 0], fittings.ends[:, 1]
    along = (end - start) / fittings.lengths[:, None]
    aside = hinges.knuckle * np.stack([-along[:, 1], along[:, 0]], axis=-1)
    outline = np.stack([start - aside, end - aside, end + aside, start + aside], axis=1)
    height = hinges.heights.on_edges()[fittings.edges]
    boxes = _upright(outline, height - hinges.knuckle, height + hinges.knuckle)
    return fittings.panels[:, 0], fittings.at[:, 0], boxes


def _upright(outline: Array, low: Array, high: Array) -> Array:
    """Upright prisms (B, 3, K, 3) over outlines (B, K, 2) between two heights (B,)."""
    levels = np.stack([low, 0.5 * (low + high), high], axis=1)
    prisms = np.empty((*levels.shape, outline.shape[1], 3))
    prisms[..., :2], prisms[..., 2] = outline[:, None], levels[..., None]
    return prisms


def _arms(panels: Array, hinges: Hinges, build: PanelSpec) -> tuple[Integers, Integers, Array]:
    """Carriers (A,), edges (A,) and prisms (A, 3, 4, 3) of all fins."""
    number = np.arange(hinges.levels.size).reshape(hinges.levels.shape)
    heights, low, t = hinges.heights, hinges.levels.ravel(), hinges.thickness
    row, column = hinges.arms
    found = []
    for edge, carrier, arm, height, sign in (
        (1, number[:-1], row[0], heights.row, hinges.signs.row),
        (3, number[1:], row[1], heights.row, hinges.signs.row),
        (2, number[:, :-1], column[0], heights.column, hinges.signs.column),
        (0, number[:, 1:], column[1], heights.column, hinges.signs.column),
    ):
        there = arm - hinges.knuckle > SHORT * t
        own, up = carrier[there], sign[there] > 0
        end = (height - sign * hinges.knuckle)[there]
        outline = _fins(panels[own], edge, 0.5 * build.gap, build.fin)
        room = _room(panels[own], outline)
        if room.min(initial=0.0) < -SHORT * t:
            panel = list(divmod(int(own[first_smallest(room)]), hinges.levels.shape[1]))
            raise _too_thick(f"at the {EDGES[edge]} edge of panel {panel}", build)
        ends = np.where(up, low[own] + t, end), np.where(up, end, low[own])
        found.append((own, np.full(len(own), edge), _upright(outline, *ends)))
    carriers, edges, prisms = (np.concatenate(each) for each in zip(*found, strict=True))
    return carriers, edges, prisms


def _fins(panels: Array, edge: int, away: float, thick: float) -> Array:
    """Outlines (A, 4, 2) of fins beside an edge of panels (A, 4, 2), so far away from it."""
    start, end = panels[:, edge], panels[:, (edge + 1) % 4]
    run = end - start
    along = run / np.hypot(*run.T)[:, None]
    inward = np.stack([-along[:, 1], along[:, 0]], axis=-1)
    start, end = start + TRIMMED * run, end - TRIMMED * run
    near, far = away * inward, (away + thick) * inward
    return np.stack([start + near, end + near, end + far, start + far], axis=1)


def _room(panels: Array, outline: Array) -> Array:
    """How far inside their panels (A, 4, 2) fins (A, 4, 2) keep; negative beyond them (length)."""
    run = np.roll(panels, -1, axis=1) - panels
    inward = np.stack([-run[..., 1], run[..., 0]], axis=-1)
    inward /= np.hypot(*np.moveaxis(run, -1, 0))[..., None]
    inside = ((outline[:, :, None] - panels[:, None]) * inward[:, None]).sum(axis=-1)
    return np.asarray(inside.min(axis=(1, 2)))


THINNER = (0.5, 0.1, 0.02)
"""Shares of the thickness of a fin that are offered."""


def _too_thick(place: str, build: PanelSpec) -> DesignError:
    return DesignError(
        "the fin that carries a hinge is thicker than its panel has room for",
        place=place,
        keys=("panel.arm_width",),
        size=f"it is {build.fin:.4g} thick",
        candidates=[
            Remedy({"panel.arm_width": rounded_down(share * build.fin)}) for share in THINNER
        ],
    )

"""A shell on the ground: where its feet are, and the ground that it needs on its way."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

import numpy as np

from orishell.deployment.feet import Feet
from orishell.deployment.fixings import Fixings
from orishell.deployment.occupied import Occupied
from orishell.deployment.plans import polygon
from orishell.deployment.standing import Standing
from orishell.deployment.swept import Sweep, at_target, find_sweep
from orishell.design import Design
from orishell.document import SHELL, Document
from orishell.document.ground import GroundFoot, GroundPlan, SweptGround
from orishell.motion.boards import Boards
from orishell.motion.complex import Complex
from orishell.numerics.arrays import Array
from orishell.solids.carried import moving_boards

END_WALL: Final = "end_wall"
"""The kind of parts that are walls at its ends."""
AT_ONE = 1e-9
"""Heights and ends that differ by less, as a share of a wall, are one."""


def plan_ground(
    design: Design, feet: Feet | None, boards: Boards | None, end: float, document: Document
) -> GroundPlan | None:
    """The plan of the feet, and of the ground that is needed; None for a shell that cannot stand.

    Parameters
    ----------
    boards
        Those of the sheet, where panels have a thickness.
    end
        The drive that it is opened or folded up from (radians).
    document
        The shell as files have it, with what is clipped on at the target.
    """
    if feet is None:
        return None
    mechanism, hinges = design.mechanism, design.hinges
    standing = Standing.of(mechanism, feet.rows, feet.columns(mechanism), hinges)
    whole = design.moving
    if boards is not None and isinstance(whole, Complex):
        boards = moving_boards(boards, whole, design.carried)
    occupied, beside = Occupied.by(whole, boards), _beside(document)
    sweep = None
    if not design.in_pieces:
        sweep = find_sweep(standing, occupied, end, beside)
    places = feet_places(design, feet)
    corner = places.min(axis=0)
    place = standing.place(mechanism.target_drive)

    def from_corner(plan: Array) -> Array:
        return np.asarray(place.middle[:2] + plan @ place.axes[:2, :2] - corner[:2])

    at = feet.vertices(mechanism).tolist()
    numbered = enumerate(zip(at, (places - corner).tolist(), strict=True), 1)
    x, y, _ = (corner + design.origin).tolist()
    return GroundPlan(
        corner=(x, y),
        feet=tuple(
            GroundFoot(number, (row, column), *away) for number, ((row, column), away) in numbered
        ),
        hull=from_corner(at_target(standing, occupied, beside)[0]),
        swept=None if sweep is None else _swept(sweep, from_corner(sweep.outline)),
        walls=tuple(each - corner[:2] for each in _walls(document)),
    )


def feet_places(design: Design, feet: Feet) -> Array:
    """Where the feet (K, 3) of a shell are at its target, in its frame.

    Of whole boards they are the corners, half way up, that ties are fixed to.
    """
    mechanism = design.mechanism
    rows, columns = feet.vertices(mechanism).T
    others = np.where(rows == feet.rows[0], feet.rows[1], feet.rows[0])
    pairs = Fixings(mechanism, np.stack([rows, others], axis=1), columns, design.hinges)
    return np.asarray(pairs.at(mechanism.target_drive)[:, 0])


def _beside(document: Document) -> Array | None:
    """Corners (K, 3) of parts that go with the sheet, at the target; None if none do."""
    points = [part.corners(state) for part, state in document.parts_in(SHELL)[1:]]
    return np.concatenate(points) if points else None


def _walls(document: Document) -> Iterator[Array]:
    """Stretches of end walls (2, 2) on the ground, in plan: of each wall its strips that stand."""
    walls: dict[str, list[Array]] = {}
    for part, state in document.parts_in(SHELL):
        if part.kind == END_WALL:
            walls.setdefault(part.title, []).extend(state.positions[part.mesh.faces])
    for strips in map(np.array, walls.values()):  # (P, 4, 3)
        points = strips.reshape(-1, 3)
        away = points[:, :2] - points[0, :2]
        along = away[np.hypot(*away.T).argmax()]
        along = along / np.hypot(*along)
        low, near = points[:, 2].min(), AT_ONE * float(np.ptp(points, axis=0).max())
        standing = sorted(
            (float(places.min()), float(places.max()))
            for strip in strips
            if len(places := strip[strip[:, 2] <= low + near, :2] @ along) > 1
        )
        across = points[0, :2] - (points[0, :2] @ along) * along
        begin, end = standing[0]
        for start, stop in [*standing[1:], (np.inf, np.inf)]:
            if start > end + near:
                yield across + np.outer([begin, end], along)
                begin, end = start, stop
            end = max(end, stop)


def _swept(sweep: Sweep, outline: Array) -> SweptGround:
    width, depth = np.ptp(outline, axis=0).tolist()
    return SweptGround(
        hull=outline,
        width=width,
        depth=depth,
        area=float(polygon(outline).area),
        height=sweep.height,
        highest_at=sweep.highest_at,
        below=sweep.below,
        lowest_at=sweep.lowest_at,
        margin=sweep.margin,
        states=sweep.states,
    )

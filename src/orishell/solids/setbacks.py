"""How far boards stand back from creases, how thick they may be, how far they let a motion go.

The hinges stay in the creases, in the middle of the panels: a membrane between boards of the
thickness b on both its faces. A crease keeps its sign, so it has a closing side: the top of a
valley, the bottom of a mountain. Boards beside a crease that folds by phi are on either side of the
plane that bisects it; at a height b over the membrane they are clear of it if they stand back by

    s = b tan(phi/2)

on the closing side. On the opening side they move apart, and need no more than half the gap that
the tool cuts. On a face without boards b is half the thickness of the membrane. Between opposite
edges of a panel its boards stand back by s from one and by s' from the other. Both together may
take a share of the panel's shortest width between these, and neither may be longer than is allowed:
so this limits the height b of boards for given fold angles, and fold angles for given boards.

Limit: hinges of a membrane are ideal, and glue has no thickness. Boards touch where the motion
ends. Without a table ``[panel]`` panels have no thickness.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from orishell.conventions.record import record
from orishell.design import PanelSpec
from orishell.motion import Mechanism
from orishell.motion.as_made import panels_laid_flat
from orishell.motion.grid import CreaseValues, Grid
from orishell.motion.layout import Layout, SlitFlaps
from orishell.motion.quads import grid_corners
from orishell.numerics.arrays import Array, Booleans
from orishell.numerics.bisection import bisect
from orishell.solids.sides import SHUT, FlapFolds, SideFolds

STATES = 257
"""States among which the largest fold angles of creases are looked for."""
AT_ONCE = 2**23
"""Fold angles that are looked at together: memory grows with it."""


@record
class SetBacks:
    """How far boards stand back from every edge of the sheet, or every side of its panels."""

    # for the boards on the upper and the lower face of the flat sheet, 0 at the border: (E,) in the
    # order of the grid's edges, or (F, 4) (length)
    top: Array
    bottom: Array


def largest_folds(mechanism: Mechanism, limit: float) -> CreaseValues:
    """The largest fold angles of all creases on the way from drive 0, with their signs.

    Most grow all the way. For the others it is the largest of a parabola through the three states
    about it, or of these states if that is larger.

    Parameters
    ----------
    limit
        The drive up to which the motion is used (radians).
    """

    def angles(drives: Array) -> tuple[Array, Array]:
        found = mechanism.fold_angles(drives)
        return found.row, found.column

    return CreaseValues(*_largest_of(angles, limit, 2 * mechanism.grid.panel_count))


def largest_flap_folds(mechanism: Mechanism, limit: float) -> FlapFolds | None:
    """Likewise of flaps that are no columns of the grid; None if there are none."""
    if not isinstance(mechanism, SlitFlaps):
        return None
    sheet, count = mechanism, len(mechanism.layout.hinges) + len(mechanism.layout.pairs)

    def angles(drives: Array) -> tuple[Array, Array]:
        return sheet.hinge_folds(drives), sheet.flap_folds(drives)

    return FlapFolds(*_largest_of(angles, limit, count))


def _largest_of(
    angles: Callable[[Array], tuple[Array, Array]], limit: float, count: int
) -> tuple[Array, Array]:
    """The largest of both fold angles (S, ...) at drives (S,), ``count`` to each."""
    drives = np.linspace(0.0, limit, STATES)
    together = max(AT_ONCE // count, 1)
    first = second = np.array(0.0)
    for start in range(0, STATES, together):
        # With the state before and the one after: parabolas go through both.
        around = slice(max(start - 1, 0), start + together + 1)
        own = slice(start - around.start, start - around.start + together)
        found = angles(drives[around])
        first = _larger(first, _largest(found[0], own))
        second = _larger(second, _largest(found[1], own))
    return first, second


Heights = float | tuple[float, float]
"""How high boards stand on either face, or on the upper and the lower one (length)."""


def find_set_backs(folds: CreaseValues, height: Heights, gap: float = 0.0) -> SetBacks:
    """Set-backs of boards from all edges, for the largest fold angles, in [-pi, pi].

    Beside a crease that folds flat there is no room for a board: its set-back is infinite.

    Parameters
    ----------
    height
        How high boards stand over the membrane on one face (length).
    gap
        What the tool cuts away between two boards, half of it from each (length).
    """
    angle = folds.on_edges()
    crease = folds.on_edges(border=np.inf) < np.inf
    return _set_backs(np.maximum(angle, 0.0), np.maximum(-angle, 0.0), crease, height, gap)


def set_backs_of(sides: SideFolds, height: Heights, gap: float = 0.0) -> SetBacks:
    """Set-backs of boards from the sides of panels (F, 4): see :func:`find_set_backs`.

    Parameters
    ----------
    height
        How high boards stand over the membrane on one face (length).
    gap
        What the tool cuts away between two boards, half of it from each (length).
    """
    return _set_backs(sides.valley, sides.mountain, sides.crease, height, gap)


def _set_backs(
    valley: Array, mountain: Array, crease: Booleans, height: Heights, gap: float
) -> SetBacks:
    least = np.where(crease, gap / 2, 0.0)
    top, bottom = np.broadcast_to(height, 2).tolist()

    def of(angle: Array, height: float) -> Array:
        shut = angle >= np.pi - SHUT
        closing = height * np.tan(np.where(shut, 0.0, angle) / 2)
        return np.asarray(np.maximum(np.where(shut & (height > 0), np.inf, closing), least))

    return SetBacks(top=of(valley, top), bottom=of(mountain, bottom))


def _larger(first: Array, second: Array) -> Array:
    """The values (...) that are larger in size, the first of equals."""
    return np.where(np.abs(second) > np.abs(first), second, first)


def _largest(angles: Array, among: slice) -> Array:
    """The values (...) of the largest size among some of the states (S, ...)."""
    size = np.abs(angles)
    at = among.start + size[among].argmax(axis=0)[None]
    near = [
        np.take_along_axis(size, np.clip(at + step, 0, len(size) - 1), axis=0)[0]
        for step in (-1, 0, 1)
    ]
    bend = near[0] - 2 * near[1] + near[2]
    inside = (at[0] > 0) & (at[0] < len(size) - 1) & (bend < 0)
    inside &= (near[0] <= near[1]) & (near[2] <= near[1])
    rise = np.where(inside, (near[2] - near[0]) ** 2 / (8 * np.where(inside, -bend, 1.0)), 0.0)
    sign = np.sign(np.take_along_axis(angles, at, axis=0)[0])
    return np.asarray(sign * np.minimum(near[1] + rise, np.pi))


SOUGHT_AMONG = 65
"""States among which the first one that leaves too little is looked for."""
FINE = 1e-12
"""Accuracy of the drive at which boards stop the motion (relative)."""


ANY = PanelSpec()
"""Panels of which only the share of set-backs is said."""


def thickness_between(
    flat: Array, grid: Grid, folds: CreaseValues, build: PanelSpec = ANY
) -> float:
    """How thick panels of a grid may be (length); infinite where no crease folds.

    Parameters
    ----------
    flat
        Vertices (rows, columns, 3) of the flat sheet.
    """
    layout = Layout.of_grid(grid)
    sides = SideFolds.of(layout, folds)
    panels = grid_corners(flat)[..., :2].reshape(-1, 4, 2)
    heights = allowed_heights(panels, layout, sides, build)
    return float(build.thickness_for(heights).min())


def drive_for_height(mechanism: Mechanism, build: PanelSpec, end: float | None = None) -> float:
    """The drive up to which boards leave enough of every panel (radians).

    They stand back for the largest fold angles on the way there.

    Parameters
    ----------
    end
        The drive up to which the motion is known to be free; None for its end (radians).
    """
    layout = Layout.of(mechanism)
    across = _ways_across(panels_laid_flat(mechanism), layout)
    end = mechanism.end_drive if end is None else end
    bare = bare_faces(SideFolds.at(mechanism, mechanism.target_drive), layout.flaps)
    asked = np.reshape(build.heights, (2, 1, 1))

    def leaves_room(folds: SideFolds) -> bool:
        return bool((_heights(across, folds, build) >= asked)[~bare].all())

    good, before = 0.0, SideFolds.at(mechanism, 0.0)

    def reached(drive: float) -> SideFolds:
        return before.or_larger(SideFolds.at(mechanism, drive))

    for drive in np.linspace(0.0, end, SOUGHT_AMONG)[1:].tolist():
        folds = reached(drive)
        if not leaves_room(folds):
            return bisect(lambda at: leaves_room(reached(at)), good, drive, relative=FINE)
        good, before = drive, folds
    return end


def allowed_heights(panels: Array, layout: Layout, sides: SideFolds, build: PanelSpec) -> Array:
    """How high boards may stand (2, F, 2): faces, upper one first; panels; ways across.

    The ``panels`` have these corners (F, 4, 2) as they lie flat. The first way is from left to
    right, the second from bottom to top. 0 where even the gap takes too much.
    """
    return _heights(_ways_across(panels, layout), sides, build)


def bare_faces(sides: SideFolds, flaps: Booleans) -> Booleans:
    """Faces of panels (2, F) that carry no board: a crease folds flat on them.

    Only flaps (F,) may go without.
    """
    return np.asarray(sides.shut() & flaps)


def _heights(across: Array, sides: SideFolds, build: PanelSpec) -> Array:
    """The heights (2, F, 2), from widths (F, 2) of panels."""
    room, setback = build.share * across, build.setback
    unit, open_ = set_backs_of(sides, 1.0), set_backs_of(sides, 0.0, build.gap)
    # Both of them, from opposite edges: what a height of 1 takes, and half the gap.
    near, far = np.split(np.stack([unit.top, unit.bottom]), 2, axis=-1)
    near_gap, far_gap = np.split(open_.top, 2, axis=-1)
    heights = np.minimum.reduce(
        [
            _over(room, near + far),
            _over(room - far_gap, near),
            _over(room - near_gap, far),
            _over(setback, np.maximum(near, far)),
        ]
    )
    fits = (near_gap + far_gap <= room) & (np.maximum(near_gap, far_gap) <= setback)
    return np.where(fits, heights, 0.0)


def _over(length: Array | float, share: Array) -> Array:
    """Lengths over the share that a height of 1 takes; infinite where it takes nothing."""
    taken = np.broadcast_to(length, share.shape)
    some = (share > 0) & (share < np.inf)
    bound = np.where(share > 0, 0.0, np.inf)
    with np.errstate(over="ignore"):  # a crease that hardly folds leaves room for any height
        return np.asarray(np.divide(taken, share, out=bound, where=some))


def _ways_across(corners: Array, layout: Layout) -> Array:
    """Shortest width (F, 2) of panels from left to right and from top to bottom.

    Of flaps beside the grid, whose other two sides are free, it is measured to the middle of the
    opposite side: they may end in a point.
    """
    along = np.roll(corners, -1, axis=1) - corners
    inward = np.stack([-along[..., 1], along[..., 0]], axis=-1)
    inward /= np.hypot(inward[..., 0], inward[..., 1])[..., None]
    # Distances (F, 4 edges, 2 ends) of the ends of the opposite edge from every edge's line.
    opposite = np.stack([np.roll(corners, -2, axis=1), np.roll(corners, -3, axis=1)], axis=2)
    away = ((opposite - corners[:, :, None]) * inward[:, :, None]).sum(axis=-1)
    width = np.where(layout.beside[:, None], away.mean(axis=-1), away.min(axis=-1))
    return np.asarray(np.minimum(width[:, :2], width[:, 2:]))

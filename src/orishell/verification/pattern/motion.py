"""How a crease pattern folds: in closed form where it can be, else followed numerically."""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import NDArray

from orishell.clash import PathContact, find_first_contact
from orishell.conventions.errors import DesignError, OrishellError
from orishell.conventions.progress import Progress, no_progress
from orishell.conventions.record import Angle, record
from orishell.families.drawn import DrawnSheet, drawn_sheet
from orishell.motion.crease_pattern import CreasePattern
from orishell.motion.following import follow
from orishell.motion.following.dofs import Freedom, find_freedom
from orishell.motion.following.placing import Placing
from orishell.motion.following.rigid import find_rigid
from orishell.motion.following.system import Closure
from orishell.motion.sizes import diagonal
from orishell.numerics.arrays import Array
from orishell.verification.pattern.on_grid import OnGrid

STATES = 25
"""States that are looked at, the flat one and the last included."""
FREEDOM_AT = (0.25, 0.5, 0.75)
"""Shares of the way at which degrees of freedom are counted."""
SHORT_OF_END = 1e-6
"""Creases are folded flat at the end: the path is proved clear up to this share before it."""
TOUCHING = 1e-9
"""Panels touch that are nearer than this share of the sheet's diagonal."""

Way = Literal["closed form", "followed"]


@record
class FoldingMotion:
    """States of a motion from flat, and by how much they miss closing."""

    way: Way  # how fold angles were found
    letters: NDArray[np.str_]  # letter (E,) of every edge: M and V where there was none
    drives: Array  # the driving fold angle (S,) of every state, 0 at the first (radians)
    folds: Array  # fold angles (S, E) of all edges, valley positive (radians)
    # by how much vertices miss closing (S, I): the sine of half the angle by which they are off
    # at most; infinite where there are no fold angles
    misses: Array
    vertices: NDArray[np.int64]  # numbers (I,) of these vertices
    reached: Angle  # the driving fold angle at the end
    ends: str  # why it ends there
    freedom: tuple[Freedom, ...]  # degrees of freedom in states on the way
    plays: Array  # how far rigid panels part at creases in each state (S,), at most (length)
    # the first contact of panels, if it was looked for and there is one
    contact: PathContact | None
    clear_until: Angle | None  # up to here no panels touch, proved; None if not looked at

    @property
    def play(self) -> float:
        """How far panels part in any state: the play that hinges need (length)."""
        return float(self.plays.max(initial=0.0))

    @property
    def miss(self) -> float:
        """That of the worst vertex in the worst state."""
        return float(self.misses.max(initial=0.0))

    def closed_states(self, limits: Array, play: float) -> int:
        """How many states, from flat on, close: vertices, and creases round holes.

        Parameters
        ----------
        limits
            Allowed misses (I,) in the order of ``vertices`` (radians).
        play
            How far panels may part (length).
        """
        open_states = (self.misses > limits).any(axis=1) | ~(self.plays <= play)
        return int(np.append(open_states, True).argmax())

    @property
    def degrees_of_freedom(self) -> int | None:
        """That of all states looked at; None if they differ, or no gap tells, or there are none."""
        counts = {each.count for each in self.freedom}
        return counts.pop() if len(counts) == 1 else None

    @property
    def worst_vertex(self) -> int:
        """The number of the vertex that misses most."""
        return int(self.vertices[self.misses.max(axis=0).argmax()])


@record
class Still:
    """That no motion was found, and whether there is none."""

    reason: str  # what was found instead
    proved: bool  # whether it is proved that the sheet does not fold as its letters ask


def find_motion(
    pattern: CreasePattern, grid: OnGrid | None, exact: float, progress: Progress = no_progress
) -> FoldingMotion | Still:
    """Find how a flat sheet folds as its letters ask.

    Parameters
    ----------
    grid
        Its rows and columns, if it has them.
    exact
        Sectors that differ by less prove nothing (radians).
    """
    proved = _proved_still(pattern, exact)
    if proved:
        return Still(proved, proved=True)
    try:
        if grid is not None and not np.isnan(pattern.signs[pattern.crease]).any():
            try:
                sheet = drawn_sheet(grid.flat, grid.signs, np.pi)
            except DesignError as error:
                if error.place:  # else parts of it fold by themselves
                    return Still(_said(error), proved=True)
            else:
                return _in_closed_form(pattern, grid, sheet, progress)
        return _followed(pattern, progress)
    except OrishellError as error:
        return Still(_said(error), proved=False)


def _said(error: OrishellError) -> str:
    return str(error).removesuffix(".")


def _proved_still(pattern: CreasePattern, exact: float) -> str:
    """Why single vertices do not let a sheet fold as its letters ask; empty if they may."""
    if not (pattern.crease & (pattern.signs != 0)).any():
        return "no crease is to fold"
    rigid = find_rigid(pattern, exact)
    flat = np.flatnonzero(rigid.flat & (np.abs(pattern.signs) == 1))
    if len(flat):
        first, second = pattern.edges[flat[0]].tolist()
        return (
            f"sectors beside crease {first}-{second} do not let it fold; so with {len(flat)} "
            "creases that have a letter"
        )
    if len(rigid.one_sided):
        return (
            f"all creases at vertex {rigid.one_sided[0]} have one letter, and one at least must "
            f"have another; so at {len(rigid.one_sided)} vertices"
        )
    return ""


def _in_closed_form(
    pattern: CreasePattern, grid: OnGrid, sheet: DrawnSheet, progress: Progress
) -> FoldingMotion:
    drives = np.linspace(0.0, np.pi, STATES)
    with np.errstate(all="ignore"):
        folds = grid.on_edges(sheet.fold_angles(drives))
    closure = Closure.of(pattern)
    misses = _misses(closure, folds)
    closes = bool(misses.max() < TOUCHING)
    found, clear_until = None, None
    if closes:
        end = np.pi * (1 - SHORT_OF_END)
        size = TOUCHING * diagonal(sheet.positions(0.0))
        found = find_first_contact(sheet.still, end, size, progress=progress).contact
        clear_until = end if found is None else found.clear_until
    return FoldingMotion(
        way="closed form",
        letters=pattern.letters,
        drives=drives,
        folds=folds,
        misses=misses,
        vertices=closure.vertices,
        reached=float(np.pi),
        ends="a crease is folded flat",
        freedom=_freedom(closure, grid.on_edges(sheet.fold_angles(np.pi * np.array(FREEDOM_AT))))
        if closes
        else (),
        plays=_plays(pattern, folds),
        contact=found,
        clear_until=clear_until,
    )


ENDS = {
    "asked": "it was asked for",
    "closed": "a crease is folded flat",
    "turns back": "the largest fold angle grows no further",
    "lost": "no closed state is found beyond",
}


def _followed(pattern: CreasePattern, progress: Progress) -> FoldingMotion:
    found = follow(pattern, states=STATES, progress=progress)
    closure = Closure.of(pattern)
    return FoldingMotion(
        way="followed",
        letters=found.letters,
        drives=np.minimum(found.drives, np.pi),
        folds=found.folds,
        misses=_misses(closure, found.folds),
        vertices=closure.vertices,
        reached=min(found.reached, float(np.pi)),
        ends=ENDS[found.end],
        freedom=found.freedom,
        plays=_plays(pattern, found.folds),
        contact=None,
        clear_until=None,
    )


def _misses(closure: Closure, folds: Array) -> Array:
    """By how much vertices miss closing (S, I)."""
    left = np.array([closure.residuals(each[closure.edges])[0] for each in folds])
    return np.asarray(np.nan_to_num(np.abs(left).max(axis=2), nan=np.inf))


def _freedom(closure: Closure, folds: Array) -> tuple[Freedom, ...]:
    return tuple(find_freedom(closure, each[closure.edges]) for each in folds)


def _plays(pattern: CreasePattern, folds: Array) -> Array:
    """How far panels part in states (S, E), at most; infinite where there is no state."""
    placing = Placing(pattern)
    return np.array(
        [placing.placed(each)[1] if np.isfinite(each).all() else np.inf for each in folds]
    )

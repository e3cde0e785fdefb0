"""How a crease pattern folds: in closed form where it can be, else followed numerically."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from orishell.clash import PathResult, find_first_contact
from orishell.clash.sampled import SampledContact, look_for_contact
from orishell.conventions.errors import DesignError, InputError, OrishellError
from orishell.conventions.progress import Progress, no_progress, stretch
from orishell.conventions.record import Angle, record
from orishell.families.drawn import Decided, decide
from orishell.families.drawn.decided import nearby_as_drawn
from orishell.families.drawn.nearest import Nearby
from orishell.motion.crease_pattern import CreasePattern
from orishell.motion.following import CLOSURE_TOLERANCE, follow
from orishell.motion.following.dofs import Freedom, find_freedom, least_count
from orishell.motion.following.followed import FREEDOM_AT
from orishell.motion.following.placing import Placing
from orishell.motion.following.rigid import why_still
from orishell.motion.following.system import Closure
from orishell.motion.sizes import diagonal, drive_at_fold
from orishell.numerics.arrays import Array
from orishell.numerics.equals import first_largest, first_smallest
from orishell.verification.pattern.loose import LooseMotion, find_loose
from orishell.verification.pattern.on_grid import OnGrid

STATES = 25
"""States that are looked at, the flat one and the last included."""
SHORT_OF_END = 0.01
"""Creases are folded flat at the end, where panels may lie on each other all over: a proof up to
there takes long for large sheets, so that the path is proved clear up to this share before it."""
CLEAR_UNTIL = np.pi * (1 - SHORT_OF_END)
"""The drive up to which it is (radians)."""
TOUCHING = 1e-9
"""Panels touch that are nearer than this share of the sheet's diagonal."""
UNFOLDED = 1e-6
"""A crease that folds by less in all states stays flat (radians)."""
LOOSEST = 1e-2
"""By how much vertices of a sheet that nearly folds may miss closing where it is followed."""

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
    reached: Angle  # the largest fold angle at the end
    ends: str  # why it ends there
    freedom: tuple[Freedom, ...]  # degrees of freedom in states on the way
    plays: Array  # how far rigid panels part at creases in each state (S,), at most (length)
    # fold angles (S, E) of all edges at driving fold angles (S,), up to the last of the drives
    folds_at: Callable[[Array], Array]
    exact: bool  # whether it closes but for rounding, as far as numbers tell
    holes: int = 0  # round how many holes panels must come back to where they began, as well
    # what is proved of contact on the way up to a drive; None if nothing is
    proof: PathResult | None = None
    proved_to: Angle = 0.0
    seen: SampledContact | None = None  # what was seen of contact in states; None if not looked at
    # with rigid panels and hinges that give way; None if it closes, or does not even nearly
    loose: LooseMotion | None = None
    # letters of all edges, one word for each choice of mountains and valleys that folds it where
    # letters are missing, the best first; empty if none is missing, or if that is not known
    choices: tuple[str, ...] = ()
    # a sheet nearby that folds, vertices (V, 2); None if there is no need, or none was found
    nearby: Nearby | None = None

    @property
    def play(self) -> float:
        """How far panels part in any state: the play that hinges need (length)."""
        return float(self.plays.max(initial=0.0))

    @property
    def miss(self) -> float:
        """That of the worst vertex in the worst state."""
        return float(self.misses.max(initial=0.0))

    @property
    def folding(self) -> NDArray[np.bool_]:
        """Which edges (E,) fold in any state."""
        return np.asarray(np.abs(self.folds).max(axis=0) > UNFOLDED)

    @property
    def half_way(self) -> int:
        """The number of the state whose drive is nearest to 90 degrees."""
        return first_smallest(np.abs(self.drives - np.pi / 2), size=np.pi)

    def closes(self, limits: Array, play: float) -> bool:
        """Whether all states close: vertices, and creases round holes.

        Parameters
        ----------
        limits
            Allowed misses (I,) in the order of ``vertices`` (radians).
        play
            How far panels may part (length).
        """
        return bool((self.misses <= limits).all() and (self.plays <= play).all())

    @property
    def degrees_of_freedom(self) -> int | None:
        """The least of all states looked at; None if no gap tells it, or there are none."""
        return least_count(self.freedom)

    @property
    def proved_clear(self) -> float:
        """The drive up to which it is proved that no panels meet; 0 if nothing is (radians)."""
        contact = None if self.proof is None else self.proof.contact
        return self.proved_to if contact is None else contact.clear_until

    @property
    def worst_vertex(self) -> int | None:
        """The number of the vertex that misses most; None if there are none."""
        if not len(self.vertices):
            return None
        return int(self.vertices[first_largest(self.misses.max(axis=0))])


@record
class Still:
    """That no motion was found, and whether there is none."""

    reason: str  # what was found instead
    proved: bool  # whether it is proved that the sheet does not fold as its letters ask


@record
class Asked:
    """Which motion of a sheet is asked for."""

    largest: Angle = float(np.pi)  # the largest fold angle at which to stop
    # which choice of mountains and valleys is taken where letters of a grid are missing, from 1
    choice: int = 1
    tolerance: Angle = (
        CLOSURE_TOLERANCE  # by how much vertices may miss closing where it is followed
    )


ALL = Asked()
"""The whole motion, as letters ask."""


def find_motion(
    pattern: CreasePattern,
    grid: OnGrid | None,
    exact: float,
    asked: Asked = ALL,
    progress: Progress = no_progress,
) -> FoldingMotion | Still:
    """Find how a flat sheet folds as its letters ask: for all that ask, in one way.

    In closed form where that is decided, else followed.

    Parameters
    ----------
    grid
        Its rows and columns, if it has them.
    exact
        Sectors that differ by less prove nothing (radians).
    asked
        Which motion.

    Raises
    ------
    InputError
        If there is no such choice of mountains and valleys.
    """
    proved = why_still(pattern, exact)
    if proved:
        return Still(proved, proved=True)
    missing = bool(np.isnan(pattern.signs[pattern.crease]).any())
    decided = None
    if grid is not None:
        try:
            decided = decide(grid.flat, grid.signs, asked.choice)
        except DesignError as error:
            if error.place:  # else parts of it fold by themselves
                return Still(_said(error), proved=not missing)
    ways = 0 if decided is None else len(decided.ways)
    if not 1 <= asked.choice <= max(ways, 1):
        raise InputError(
            "there is no such choice of mountains and valleys",
            keys=("choice",),
            got=str(asked.choice),
            expected=f"1 to {ways}" if ways > 1 else "1: there are no others",
        )
    if grid is None or decided is None:
        return _if_followed(pattern, asked, progress)
    lettered = [grid.with_signs(each) for each in decided.ways]
    found = _in_closed_form(lettered[asked.choice - 1], decided, exact, asked.largest, progress)
    if isinstance(found, Still):
        return found
    letters = tuple("".join(each.pattern.letters) for each in lettered)
    return replace(found, choices=letters if missing else ())


def _said(error: OrishellError) -> str:
    return str(error).removesuffix(".")


def _in_closed_form(
    grid: OnGrid, decided: Decided, exact: float, largest: float, progress: Progress
) -> FoldingMotion | Still:
    pattern, sheet = grid.pattern, decided.sheet
    closure = Closure.of(pattern)

    def folds_at(drives: Array) -> Array:
        with np.errstate(all="ignore"):
            return grid.on_edges(sheet.fold_angles(drives))

    end, ends = drive_at_fold(sheet, largest), ENDS["closed" if largest >= np.pi else "asked"]
    if end > decided.end:
        end = largest = decided.end
        ends = "beyond, coordinates leave no digits of it"
    drives = np.linspace(0.0, end, STATES)
    folds = folds_at(drives)
    found = FoldingMotion(
        way="closed form",
        letters=pattern.letters,
        drives=drives,
        folds=folds,
        misses=_misses(closure, folds),
        vertices=closure.vertices,
        reached=largest,
        ends=ends,
        freedom=(),
        plays=_plays(pattern, folds),
        folds_at=folds_at,
        exact=decided.exact,
        holes=len(closure.holes),
    )
    idle = pattern.crease & (np.abs(pattern.signs) == 1) & ~found.folding
    if decided.exact and idle.any():
        first, second = pattern.edges[int(idle.argmax())].tolist()
        return Still(
            f"{int(idle.sum())} creases that have a letter stay flat in its motion, edge "
            f"{first}-{second} for one",
            proved=False,
        )
    if not decided.exact:
        found = _loosely(found, pattern, progress)
        moved = nearby_as_drawn(grid.flat, grid.signs, sheet) if found.miss > exact else None
        if moved is None:
            return found
        nearby = pattern.vertices.copy()
        nearby[grid.numbers] = moved.vertices
        return replace(found, nearby=replace(moved, vertices=nearby))
    size = TOUCHING * diagonal(sheet.positions(0.0))
    until = min(CLEAR_UNTIL, end)
    proof = find_first_contact(sheet.least_turning, until, size, progress=progress)
    return replace(
        found,
        proof=_by_number(proof, grid),
        proved_to=until,
        freedom=tuple(
            find_freedom(closure, each[closure.edges])
            for each in folds_at(end * np.array(FREEDOM_AT))
        ),
    )


def _by_number(proof: PathResult, grid: OnGrid) -> PathResult:
    """The proof with panels by their numbers in the pattern."""
    if proof.contact is None:
        return proof
    first, second = grid.panels[list(proof.contact.panels)].tolist()
    return replace(proof, contact=replace(proof.contact, panels=(first, second)))


ENDS = {
    "asked": "it was asked for",
    "closed": "a crease is folded flat",
    "turns back": "the largest fold angle grows no further",
    "lost": "no closed state is found beyond",
}


def _if_followed(pattern: CreasePattern, asked: Asked, progress: Progress) -> FoldingMotion | Still:
    """The motion followed, to closed states or, of a sheet with all letters, to nearly closed."""
    try:
        return _followed(pattern, asked, progress)
    except OrishellError as error:
        still = Still(_said(error), proved=False)
    if np.isnan(pattern.signs[pattern.crease]).any():
        return still
    try:
        found = _followed(pattern, replace(asked, tolerance=LOOSEST), progress)
    except OrishellError:
        return still
    return still if found.loose is None else found


def _followed(pattern: CreasePattern, asked: Asked, progress: Progress) -> FoldingMotion:
    found = follow(
        pattern,
        largest=asked.largest,
        states=STATES,
        tolerance=asked.tolerance,
        progress=stretch(progress, 0.0, 0.7),
    )
    closure = Closure.of(pattern)
    misses, plays = _misses(closure, found.folds), _plays(pattern, found.folds)
    motion = FoldingMotion(
        way="followed",
        letters=found.letters,
        drives=np.minimum(found.drives, np.pi),
        folds=found.folds,
        misses=misses,
        vertices=closure.vertices,
        reached=min(found.reached, float(np.pi)),
        ends=ENDS[found.end],
        freedom=found.freedom,
        plays=plays,
        folds_at=found.at_all,
        exact=misses.max(initial=0.0) <= TOUCHING and plays.max() <= TOUCHING * pattern.diagonal,
        holes=len(closure.holes),
    )
    rest = stretch(progress, 0.7, 1.0)
    if not motion.exact:
        return _loosely(motion, pattern, rest)
    return replace(motion, seen=look_for_contact(found, rest))


def _loosely(found: FoldingMotion, pattern: CreasePattern, progress: Progress) -> FoldingMotion:
    """The motion of a sheet that closes nearly only, with hinges that give way."""
    loose = find_loose(pattern, found.drives, found.folds, progress)
    return replace(found, loose=loose, freedom=() if loose is None else loose.freedom)


def _misses(closure: Closure, folds: Array) -> Array:
    """By how much vertices miss closing (S, I)."""
    left = np.array([closure.turns(each[closure.edges])[0] for each in folds])
    return np.asarray(np.nan_to_num(np.abs(left).max(axis=2), nan=np.inf))


def _plays(pattern: CreasePattern, folds: Array) -> Array:
    """How far panels part in states (S, E), at most; infinite where there is no state."""
    placing = Placing(pattern)
    return np.array(
        [placing.placed(each)[1] if np.isfinite(each).all() else np.inf for each in folds]
    )

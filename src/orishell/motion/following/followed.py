"""The motion of a crease pattern from flat, followed numerically: states, freedom, why it ends."""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from orishell.conventions.errors import DesignError, InputError
from orishell.conventions.progress import Progress, no_progress, stretch
from orishell.conventions.record import Angle, record
from orishell.motion.crease_pattern import CreasePattern
from orishell.motion.following.dofs import Freedom, find_freedom, least_count
from orishell.motion.following.path import FOLLOWING, End, Path, follow_path, states_at
from orishell.motion.following.placing import Placing
from orishell.motion.following.rigid import Rigid, find_rigid, why_still
from orishell.motion.following.start import SIZE, Start, find_start
from orishell.motion.following.system import Closure
from orishell.numerics.arrays import Array

CLOSURE_TOLERANCE = 1e-5
"""By how much vertices may miss closing where nothing else is said (radians)."""
FREEDOM_AT = (0.25, 0.5, 0.75)
"""Shares of the way at which degrees of freedom are counted."""


@record
class Followed:
    """States of a motion, from the flat sheet on, each closed to within its residual."""

    pattern: CreasePattern
    letters: NDArray[np.str_]  # letter (E,) of every edge: M and V where there was none
    drives: Array  # the largest fold angle (S,) of every state, the flat one first (radians)
    folds: Array  # fold angles (S, E) of all edges, valley positive (radians)
    residuals: Array  # by how much each state misses closure (S,), at its worst vertex (radians)
    end: End  # why the motion ends
    reached: Angle  # the largest fold angle up to which it was followed
    freedom: tuple[Freedom, ...]  # degrees of freedom in some states on the way
    tries: int  # starts that were tried before a folded state was found
    _closure: Closure
    _path: Path

    @property
    def found(self) -> int:
        """How many creases fold as mountain or valley that had no letter."""
        return int((self.letters != self.pattern.letters).sum())

    @property
    def degrees_of_freedom(self) -> int | None:
        """The least of all states looked at; None where no gap tells it."""
        return least_count(self.freedom)

    @cached_property
    def placing(self) -> Placing:
        """How its states lie in space."""
        return Placing(self.pattern)

    def at(self, drive: float) -> Array:
        """Fold angles (E,) of the state with this largest fold angle, up to the one reached."""
        return np.asarray(self.at_all(np.array([drive]))[0])

    def at_all(self, drives: Array) -> Array:
        """Fold angles (S, E) of the states with these largest ones (S,), up to the one reached."""
        drives = np.minimum(drives, self.reached)
        return self._closure.on_edges(states_at(self._closure, self._path, drives)[0])

    def placed(self, state: int) -> tuple[Array, float]:
        """Vertices (V, 3) of a state, and the play that its hinges need (length)."""
        return self.placing.placed(self.folds[state])


def follow(
    pattern: CreasePattern,
    *,
    largest: float = np.pi,
    states: int = 25,
    tolerance: float = CLOSURE_TOLERANCE,
    progress: Progress = no_progress,
) -> Followed:
    """Follow the motion of a flat sheet as its letters ask.

    Where it has several degrees of freedom this is one of many motions: all creases begin to fold
    by angles as alike as closure lets them be, and go on as straight as they can.

    Parameters
    ----------
    pattern
        The sheet. Creases without mountain or valley fold as one of the starts that are tried has
        them fold.
    largest
        The largest fold angle at which to stop, up to pi: folded flat (radians).
    states
        How many states to give, the flat one and the last included, at equal steps of the largest
        fold angle.
    tolerance
        By how much vertices may miss closing in a folded state (radians). Coordinates that were
        rounded close to within that.

    Raises
    ------
    InputError
        If no crease can fold, or panels surround a hole.
    DesignError
        If no folded state was found: none near the flat one, or none that folds as the letters ask.
    """
    if not (pattern.crease & (pattern.signs != 0)).any():
        raise InputError(
            "there is nothing to fold",
            got="no crease but flat ones",
            expected="edges between two panels that are mountain, valley or unassigned",
        )
    rigid = find_rigid(pattern, tolerance)
    _require_foldable(pattern, rigid, tolerance)
    closure = Closure.of(replace(pattern, letters=np.where(rigid.flat, "F", pattern.letters)))
    signs = pattern.signs[closure.edges]
    start = find_start(closure, signs, tolerance)
    _require_found(start, closure, pattern)
    if largest <= SIZE:
        path = Path(np.stack([0 * start.folds, start.folds]), np.zeros(2), "asked", largest)
    else:
        path = follow_path(closure, start.folds, largest, tolerance, stretch(progress, 0.0, 0.7))
    drives = np.linspace(0.0, path.reached, states)
    folds, residuals = states_at(closure, path, drives, stretch(progress, 0.7, 0.9))
    some, _ = states_at(closure, path, path.reached * np.array(FREEDOM_AT))
    letters = pattern.letters.copy()
    missing = closure.edges[np.isnan(signs)]
    letters[missing] = np.where(start.folds[np.isnan(signs)] > 0, "V", "M")
    letters[closure.edges[start.unfolded]] = letters[rigid.flat] = "F"
    freedom = tuple(find_freedom(closure, each) for each in some)
    progress(1.0, FOLLOWING)
    return Followed(
        pattern=pattern,
        letters=letters,
        drives=drives,
        folds=closure.on_edges(folds),
        residuals=residuals,
        end=path.end,
        reached=path.reached,
        freedom=freedom,
        tries=start.tries,
        _closure=closure,
        _path=path,
    )


def _require_foldable(pattern: CreasePattern, rigid: Rigid, tolerance: float) -> None:
    """Refuse what is proved not to fold, or not as its letters ask."""
    if not (pattern.crease & (pattern.signs != 0) & ~rigid.flat).any():
        raise DesignError("the sheet does not fold at all", size="proved vertex by vertex")
    proved = why_still(pattern, tolerance)
    if proved:
        raise DesignError("the sheet does not fold as its letters ask", size=f"proved: {proved}")


def _require_found(start: Start, closure: Closure, pattern: CreasePattern) -> None:
    """Refuse where no folded state was found, or none as the letters ask."""
    tried = "1 start" if start.tries == 1 else f"{start.tries} starts"
    if not start.closed:
        raise DesignError(
            "no folded state was found near the flat sheet",
            size=f"the nearest of {tried} misses closing by {start.residual:.1g} rad at a largest "
            f"fold angle of {np.rad2deg(SIZE):.1f} degrees; that there is none is not proved",
        )
    if not start.found:
        edge = pattern.edges[closure.edges[start.against.argmax()]].tolist()
        raise DesignError(
            "no folded state was found in which all creases fold as their letters ask",
            place=f"edge {edge[0]}-{edge[1]} for one",
            size=f"in the nearest of {tried} {int(start.against.sum())} of {len(closure.edges)} "
            "creases fold the other way or not at all; that there is none is not proved",
        )

"""By how much flaps with boards must stop short of folding flat."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from orishell.conventions.errors import DesignError, Remedy
from orishell.design import PanelSpec
from orishell.motion import Mechanism
from orishell.motion.grid import CreaseValues, Grid
from orishell.numerics.bisection import bisect_integers
from orishell.solids.limits import largest_height
from orishell.solids.thickness_limit import find_thickness_limit, limit_in_words, thinner, wide_gap

STEPS = 100
"""Steps in a degree: a stop that is found is a whole number of them."""
MOST = 45 * STEPS
"""The largest stop that is looked for (steps)."""


def find_stop(mechanism: Mechanism, build: PanelSpec) -> float:
    """The least by which flaps must stop short of folding flat, so that they can carry boards.

    Rounded up to a hundredth of a degree; 0 if there are no flaps (radians).

    Parameters
    ----------
    mechanism
        The sheet, whose flaps may have any stop.
    build
        What its panels are made of.

    Raises
    ------
    DesignError
        If boards on flaps have no room, however early these stop.
    """
    if not mechanism.flap_columns:
        return 0.0

    def works(steps: int) -> bool:
        return _most(mechanism, steps, build) >= build.height

    good = 1
    while good < MOST and not works(good):
        good *= 2
    if good >= MOST:
        # What is doubled may jump over what works.
        good = _last(mechanism)
        if not works(good):
            raise _no_room(mechanism, build)
    return _angle(bisect_integers(works, good, 0))


def _no_room(mechanism: Mechanism, build: PanelSpec) -> DesignError:
    """The refusal of boards on flaps that have no room for them, whatever their stop is."""

    def room(other: PanelSpec) -> float:
        return largest_thickness(mechanism, other)

    most = room(build)
    if not most and room(build.having(gap=0.0)):
        return wide_gap(build, "at a flap", room)
    return DesignError(
        "boards on flaps would stand back too far from their creases, however early flaps stop",
        place="at the target",
        keys=("panel.thickness",),
        size=limit_in_words(build, most) if most else "no thickness is small enough",
        candidates=_candidates(build, most),
        excess=build.thickness / most - 1 if most else None,
    )


def largest_thickness(mechanism: Mechanism, build: PanelSpec) -> float:
    """The largest thickness of panels, with whatever stop leaves their flaps most room (length).

    Infinite where no crease folds.

    Parameters
    ----------
    mechanism
        The sheet with its flaps, if it has any.
    build
        What its panels are made of; with a stop of 0 flaps carry no boards.
    """
    most = find_thickness_limit(mechanism.with_stop(0.0), build).thickness
    if not mechanism.flap_columns or build.stop == 0:
        return most
    return min(most, 2 * _most(mechanism, _last(mechanism), build))


def _candidates(build: PanelSpec, most: float) -> Iterator[Remedy]:
    """Thinner panels, flaps of membrane only, no flaps."""
    yield from thinner(build, most)
    if build.construction == "sandwich":
        yield Remedy({"panel.stop_deg": 0.0})
    yield Remedy({"pattern.flap": 0.0})


def _angle(steps: int) -> float:
    return float(np.deg2rad(steps / STEPS))


def _last(mechanism: Mechanism) -> int:
    """The largest stop that flaps can have (steps)."""
    return bisect_integers(lambda steps: _allowed(mechanism, steps), 0, MOST + 1)


def _allowed(mechanism: Mechanism, steps: int) -> bool:
    """Whether flaps can have this stop."""
    try:
        mechanism.with_stop(_angle(steps))
    except DesignError:
        return False
    return True


def _most(mechanism: Mechanism, steps: int, build: PanelSpec) -> float:
    """How high boards may stand between the row creases of flaps with this stop (length)."""
    if not _allowed(mechanism, steps):
        return -np.inf
    stopped = mechanism.with_stop(_angle(steps))
    flat, folds = stopped.positions(0.0), stopped.fold_angles(stopped.target_drive).row
    strip, no_columns = Grid(stopped.grid.rows, 2), np.zeros((stopped.grid.rows - 1, 0))
    return min(
        largest_height(
            flat[:, flap : flap + 2],
            strip,
            CreaseValues(folds[:, flap : flap + 1], no_columns),
            build.share,
            build.setback,
            gap=build.gap,
        )
        for flap in stopped.flap_columns
    )

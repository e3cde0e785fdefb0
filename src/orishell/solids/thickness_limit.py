"""How thick panels may be, which crease asks for most, and how far flaps with boards stop short."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np

from orishell.conventions.errors import DesignError, Remedy, Value
from orishell.conventions.formatting import rounded, rounded_down
from orishell.design import PanelSpec
from orishell.motion import Mechanism
from orishell.motion.as_made import panels_laid_flat
from orishell.motion.grid import CreaseValues, Grid
from orishell.motion.layout import Layout, SlitFlaps, has_flaps
from orishell.numerics.bisection import bisect_integers, largest_below
from orishell.numerics.equals import first_largest, first_smallest
from orishell.solids.setbacks import (
    allowed_heights,
    bare_faces,
    largest_flap_folds,
    largest_folds,
)
from orishell.solids.sides import FlapFolds, SideFolds


@dataclass(frozen=True, slots=True)
class ThicknessLimit:
    """How thick panels may be."""

    thickness: float  # the largest with which set-backs take no more than they may (length)
    crease: str  # the crease that asks for most, by row and column; empty where none does
    on_flap: bool  # whether it is a row crease of a flap


THINNER = (0.99, 0.5, 0.1)
"""Shares of the largest thickness that are offered."""
NARROWEST = 1e-4
"""A gap is offered no narrower than this share of it."""
COARSE, SURELY = 1e-3, 0.99
"""Accuracy of the widest gap, and the share of it that is offered."""


def find_thickness_limit(mechanism: Mechanism, build: PanelSpec) -> ThicknessLimit:
    """How thick the panels of a sheet with its flaps, folded or clipped on, may be at its target.

    Flaps whose creases fold flat carry no boards there, and are left out.
    """
    layout, target = Layout.of(mechanism), mechanism.target_drive
    folds, beside = largest_folds(mechanism, target), largest_flap_folds(mechanism, target)
    sides = SideFolds.of(layout, folds, beside)
    heights = allowed_heights(panels_laid_flat(mechanism), layout, sides, build)
    heights[bare_faces(sides, layout.flaps)] = np.inf
    thick = build.thickness_for(heights)
    _, panel, way = (int(k) for k in np.unravel_index(first_smallest(thick), thick.shape))
    most = float(thick.min())
    if not np.isfinite(most):
        return ThicknessLimit(most, "", on_flap=False)
    crease = _crease(layout, panel, way + 2 * first_largest(sides.largest[panel, way::2]))
    return ThicknessLimit(most, crease, bool(layout.flaps[panel]))


def limit_in_words(build: PanelSpec, most: float) -> str:
    """How thick panels may be at most, rounded down, and how thick they are, in words.

    Parameters
    ----------
    most
        The largest thickness with which set-backs take no more than they may (length).
    """
    limit = rounded_down(most) if most else 0.0
    return f"set-backs leave room for {limit:g} at most, and panels are {build.thickness:.4g} thick"


def thinner(build: PanelSpec, most: float) -> list[Remedy]:
    """Changes to panels that are thinner than a largest thickness; a membrane fits into them.

    Parameters
    ----------
    most
        The largest thickness (length).
    """
    offered = []
    for thickness in (rounded(share * most) for share in THINNER if most > 0):
        changes: dict[str, Value | None] = {"panel.thickness": thickness}
        if thickness <= build.membrane:
            changes["panel.membrane"] = rounded(build.membrane / build.thickness * thickness)
        offered.append(Remedy(changes))
    return offered


def wide_gap(build: PanelSpec, place: str, limit: Callable[[PanelSpec], float]) -> DesignError:
    """The refusal of a gap that takes more of a panel by itself than set-backs may.

    Parameters
    ----------
    place
        Where in the sheet.
    limit
        The largest thickness of panels of some make (length).
    """

    def widest_with(least: float) -> float | None:
        def works(gap: float) -> bool:
            return limit(build.replace_unchecked(gap=gap)) > least

        return largest_below(works, build.gap, smallest=NARROWEST, relative=COARSE)

    # With room for panels as thick as they are, or else for any.
    widest = widest_with(build.thickness) or widest_with(0.0)
    offered = [] if widest is None else [rounded(SURELY * widest)]
    if build.construction == "sandwich":
        offered.append(0.0)
    return DesignError(
        "the gap between panels takes more of one than set-backs may",
        place=place,
        keys=("panel.gap",),
        size=f"it is {build.gap:.4g} wide",
        candidates=[Remedy({"panel.gap": gap}) for gap in offered],
        excess=None if widest is None else build.gap / widest - 1,
    )


def _crease(layout: Layout, panel: int, side: int) -> str:
    """The crease at a side of a panel."""
    grid, (hinges, pairs) = layout.grid, layout.folding_sides
    for panels, sides, what in (
        (layout.hinges, hinges, "at the hinge between {} and {}"),
        (layout.pairs, pairs, "at the crease between flaps {} and {}"),
    ):
        there = np.flatnonzero(((panels == panel) & (sides == side)).any(axis=1))
        if len(there):
            return what.format(*layout.names[panels[there[0]]].tolist())
    first = int(grid.edges_vertices()[grid.faces_edges()[panel, side], 0])
    row, column = divmod(first, grid.columns)
    if side % 2 == 0:
        return f"at the crease of column {column} between rows {row} and {row + 1}"
    return f"at the crease of row {row} between columns {column} and {column + 1}"


STEPS = 100
"""Steps in a degree: a stop that is found is a whole number of them."""
LARGEST_STOP = 45 * STEPS
"""The largest stop that is looked for (steps)."""


def find_stop(mechanism: Mechanism, build: PanelSpec) -> float:
    """The least by which flaps must stop short of folding flat, so that they can carry boards.

    Rounded up to a hundredth of a degree; 0 if there are no flaps (radians).

    Raises
    ------
    DesignError
        If boards on flaps have no room, however early these stop.
    """
    if not has_flaps(mechanism):
        return 0.0

    def works(steps: int) -> bool:
        return _most(mechanism, steps, build) >= build.thickness

    good = 1
    while good < LARGEST_STOP and not works(good):
        good *= 2
    if good >= LARGEST_STOP:
        # What is doubled may jump over what works.
        good = _last(mechanism)
        if not works(good):
            raise _no_room(mechanism, build)
    return _angle(bisect_integers(works, good, 0))


def _no_room(mechanism: Mechanism, build: PanelSpec) -> DesignError:
    """The refusal of boards on flaps that have no room for them, whatever their stop is."""
    most = largest_thickness(mechanism, build)
    if not most and largest_thickness(mechanism, build.replace_unchecked(gap=0.0)):
        return wide_gap(build, "at a flap", partial(largest_thickness, mechanism))
    bare = [Remedy({"panel.stop_deg": 0.0})] if build.construction == "sandwich" else []
    return DesignError(
        "boards on flaps would stand back too far from their creases, however early flaps stop",
        place="at the target",
        keys=("panel.thickness",),
        size=limit_in_words(build, most) if most else "no thickness is small enough",
        candidates=[*thinner(build, most), *bare, Remedy({"pattern.flap": 0.0})],
        excess=build.thickness / most - 1 if most else None,
    )


def largest_thickness(mechanism: Mechanism, build: PanelSpec) -> float:
    """The largest thickness of panels, with whatever stop leaves their flaps most room (length).

    Infinite where no crease folds. With a stop of 0 flaps carry no boards.
    """
    most = find_thickness_limit(mechanism.with_stop(0.0), build).thickness
    if not has_flaps(mechanism) or build.stop == 0:
        return most
    return min(most, _most(mechanism, _last(mechanism), build))


def _angle(steps: int) -> float:
    return float(np.deg2rad(steps / STEPS))


def _last(mechanism: Mechanism) -> int:
    """The largest stop that flaps can have (steps)."""
    return bisect_integers(lambda steps: _allowed(mechanism, steps), 0, LARGEST_STOP + 1)


def _allowed(mechanism: Mechanism, steps: int) -> bool:
    """Whether flaps can have this stop."""
    try:
        mechanism.with_stop(_angle(steps))
    except DesignError:
        return False
    return True


def _most(mechanism: Mechanism, steps: int, build: PanelSpec) -> float:
    """How thick panels may be between the row creases of flaps with this stop (length)."""
    if not _allowed(mechanism, steps):
        return -np.inf
    stopped = mechanism.with_stop(_angle(steps))
    if isinstance(stopped, SlitFlaps):
        return _most_beside(stopped, stopped.layout, build)
    rows, columns = stopped.grid.rows, stopped.grid.columns
    panels = panels_laid_flat(stopped).reshape(rows - 1, columns - 1, 4, 2)
    folds = largest_folds(stopped, stopped.target_drive).row
    strip = Layout.of_grid(Grid(rows, 2))

    def most(flap: int) -> float:
        alone = CreaseValues(folds[:, flap : flap + 1], np.zeros((rows - 1, 0)))
        heights = allowed_heights(panels[:, flap], strip, SideFolds.of(strip, alone), build)
        return float(build.thickness_for(heights).min())

    return min(most(flap) for flap in stopped.flap_columns)


def _most_beside(stopped: Mechanism, layout: Layout, build: PanelSpec) -> float:
    """Likewise between the row creases of flaps that are no columns of the grid."""
    beside = FlapFolds.at(stopped, stopped.target_drive)
    assert beside is not None
    grid = layout.grid
    still = CreaseValues(
        np.zeros((grid.rows - 2, grid.columns - 1)), np.zeros((grid.rows - 1, grid.columns - 2))
    )
    sides = SideFolds.of(layout, still, FlapFolds(0 * beside.hinges, beside.pairs))
    heights = allowed_heights(panels_laid_flat(stopped), layout, sides, build)
    return float(build.thickness_for(heights[:, layout.flaps]).min())

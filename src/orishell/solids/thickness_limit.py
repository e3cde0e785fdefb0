"""How thick the panels of a mechanism may be, and which crease asks for most."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from orishell.conventions.errors import DesignError, Remedy, Value
from orishell.conventions.formatting import rounded, rounded_down
from orishell.design import PanelSpec
from orishell.motion import Mechanism
from orishell.motion.grid import Grid
from orishell.numerics.arrays import Array
from orishell.numerics.bisection import largest_below
from orishell.solids.limits import allowed_heights, bare_faces
from orishell.solids.setbacks import largest_folds


@dataclass(frozen=True, slots=True)
class ThicknessLimit:
    """How thick panels may be.

    Parameters
    ----------
    thickness
        The largest thickness with which set-backs take no more than they may (length).
    crease
        The crease that asks for most, by row and column; empty where none does.
    on_flap
        Whether it is a row crease of a flap.
    """

    thickness: float
    crease: str
    on_flap: bool


THINNER = (0.99, 0.5, 0.1)
"""Shares of the largest thickness that are offered."""
NARROWEST = 1e-4
"""A gap is offered no narrower than this share of it."""
COARSE, SURELY = 1e-3, 0.99
"""Accuracy of the widest gap, and the share of it that is offered."""


def find_thickness_limit(mechanism: Mechanism, build: PanelSpec) -> ThicknessLimit:
    """How thick the panels of a sheet with its flaps, folded or clipped on, may be at its target.

    Flaps whose creases fold flat carry no boards there, and are left out.

    Parameters
    ----------
    build
        What they are made of: how much set-backs may take, and the gap.
    """
    grid, flat = mechanism.grid, mechanism.positions(0.0)
    folds = largest_folds(mechanism, mechanism.target_drive)
    heights = allowed_heights(
        flat, grid, folds, share=build.share, setback=build.setback, gap=build.gap
    )
    heights[bare_faces(folds, grid, mechanism.flap_columns)] = np.inf
    of_flaps = np.isin(np.arange(grid.panel_count) % (grid.columns - 1), mechanism.flap_columns)
    _, panel, way = (int(k) for k in np.unravel_index(int(heights.argmin()), heights.shape))
    most = 2 * float(heights.min())
    if not np.isfinite(most):
        return ThicknessLimit(most, "", on_flap=False)
    return ThicknessLimit(
        most, _crease(panel, way, np.abs(folds.on_edges()), grid), bool(of_flaps[panel])
    )


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
    """The refusal of a gap that alone takes more of a panel than set-backs may.

    Parameters
    ----------
    place
        Where in the sheet.
    limit
        The largest thickness of panels of some make (length).
    """
    widest = _widest_gap(build, limit)
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


def _widest_gap(build: PanelSpec, limit: Callable[[PanelSpec], float]) -> float | None:
    """The widest gap with room for panels as thick as they are, or else for any; None if none."""

    def widest(least: float) -> float | None:
        def works(gap: float) -> bool:
            return limit(build.having(gap=gap)) > least

        return largest_below(works, build.gap, smallest=NARROWEST, relative=COARSE)

    return widest(build.thickness) or widest(0.0)


def _crease(panel: int, way: int, sizes: Array, grid: Grid) -> str:
    """The crease of two opposite edges of a panel that folds more."""
    pair = grid.faces_edges()[panel, way::2]
    first = int(grid.edges_vertices()[pair[int(sizes[pair].argmax())], 0])
    row, column = divmod(first, grid.columns)
    if way == 0:
        return f"at the crease of column {column} between rows {row} and {row + 1}"
    return f"at the crease of row {row} between columns {column} and {column + 1}"

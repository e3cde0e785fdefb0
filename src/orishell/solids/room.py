"""How thick the panels of a mechanism may be, and which crease asks for most."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from orishell.conventions.formatting import rounded
from orishell.design import PanelBuild
from orishell.errors import DesignError, Remedy
from orishell.motion import Mechanism
from orishell.numerics.arrays import Array
from orishell.sheet.grid import Grid
from orishell.solids.limits import allowed_heights, bare_faces
from orishell.solids.setbacks import largest_folds


@dataclass(frozen=True, slots=True)
class Room:
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
NARROWER = (0.5, 0.1)
"""Shares of a gap that are offered."""


def find_room(mechanism: Mechanism, build: PanelBuild) -> Room:
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
        return Room(most, "", on_flap=False)
    return Room(most, _crease(panel, way, np.abs(folds.on_edges()), grid), bool(of_flaps[panel]))


def thinner(build: PanelBuild, most: float) -> list[Remedy]:
    """Changes to panels that are thinner than a largest thickness.

    A membrane that they would not be thicker than becomes thinner by the same share.

    Parameters
    ----------
    most
        The largest thickness (length).
    """
    remedies = []
    for thickness in (rounded(share * most) for share in THINNER):
        remedy = Remedy({"panel.thickness": thickness})
        if build.membrane >= thickness:
            membrane = rounded(build.membrane / build.thickness * thickness)
            remedy |= Remedy({"panel.membrane": membrane})
        remedies.append(remedy)
    return remedies


def wide_gap(build: PanelBuild, place: str) -> DesignError:
    """The refusal of a gap that alone takes more of a panel than set-backs may.

    Parameters
    ----------
    place
        Where in the sheet.
    """
    return DesignError(
        "the gap between panels takes more of one than set-backs may",
        place=place,
        keys=("panel.gap",),
        size=f"it is {build.gap:.4g} wide",
        candidates=[Remedy({"panel.gap": rounded(share * build.gap)}) for share in NARROWER],
    )


def _crease(panel: int, way: int, sizes: Array, grid: Grid) -> str:
    """The crease of two opposite edges of a panel that folds more."""
    pair = grid.faces_edges()[panel, way::2]
    first = int(grid.edges_vertices()[pair[int(sizes[pair].argmax())], 0])
    row, column = divmod(first, grid.columns)
    if way == 0:
        return f"at the crease of column {column} between rows {row} and {row + 1}"
    return f"at the crease of row {row} between columns {column} and {column + 1}"

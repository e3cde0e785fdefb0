"""Gussets in the folds of a shell: where they are, and that they meet nothing at the target.

Limit: gussets are examined at the target only, as clipped flaps are. How they are brought to their
place is not.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from orishell.clash.bodies import Bodies
from orishell.clash.separation import corners_of, overlaps
from orishell.clash.state import deepest_between, near_panels
from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.formatting import rounded, rounded_down
from orishell.conventions.record import record
from orishell.design import Design, PanelSpec
from orishell.design.stiffeners import Bolts, Stiffeners
from orishell.locking.fold_rows import between_flaps, fold_columns, fold_rows
from orishell.locking.plates import require_creases, require_folds, with_plates
from orishell.locking.result import Lock
from orishell.locking.sheet import Sheet
from orishell.motion import diagonal
from orishell.motion.as_made import panels_laid_flat
from orishell.motion.boards import join_boards
from orishell.motion.convex import require_convex
from orishell.motion.layout import Layout, points_of
from orishell.numerics.arrays import Array, Integers
from orishell.numerics.equals import first_largest
from orishell.solids import build_panels
from orishell.solids.gussets import Gussets, gusset_parts

LEAST_LEFT = 0.5
"""A gusset keeps at least this share of its way along edges when it stands off boards."""
SMALLER = 0.9
"""What is offered is smaller by this factor, or by a power of it."""
ROUNDED = 1e-3
"""What is offered is smaller by this share at most for being rounded."""
USUAL = 0.9
"""The share that \"auto\" begins from."""
TRIED, LARGEST = 24, 0.98
"""So many smaller sizes are tried, and one that goes nearly to the end of edges."""


def with_gussets(
    design: Design, lock: Lock, asked: Stiffeners | None, tolerance: float, density: float = 0.0
) -> Design:
    """The design with the gussets that are asked for, proved to meet nothing at the target.

    lock: How its motion ends, with its boards.
    tolerance: By how much they may reach into others, relative to the flat sheet's diagonal.
    density: Mass by volume of boards of their own (kg/m^3), 0 if unknown.
    Raises InputError: If there are no such rows or columns, or panels are whole boards.
    Raises DesignError: If there is no room for them.
    """
    if asked is None or asked.kind != "gussets":
        return design
    require_creases(design, "gussets")
    at = _places(design, asked)
    require_folds(design, at, "gusset")
    place = Place(design, lock, at, tolerance * diagonal(design.mechanism.positions(0.0)))
    build = None if design.panel is None else asked.made_of(design.panel, density)
    share = _largest(place, build) if asked.share == "auto" else asked.share
    found = Gussets.of(design, at, share, build)
    fault = place.fault(found)
    if fault is not None:
        raise DesignError(
            fault.what,
            place="at the target",
            keys=(
                "stiffeners.share",
                *([] if asked.thickness is None else ["stiffeners.thickness"]),
            ),
            size=fault.size,
            candidates=list(_others(place, found, asked)),
            excess=fault.excess,
        )
    _require_bolts(found, asked.bolts)
    parts = gusset_parts(design, found, place.levels, asked.material or "", asked.bolts)
    return with_plates(design, at, parts)


def _require_bolts(found: Gussets, bolts: Bolts | None) -> None:
    """Refuse bolts of which there are no two along an edge."""
    if bolts is None:
        return
    rooms = found.rows(bolts.off)[1].min(axis=1)
    least = int(np.argmin(rooms))
    room = float(rooms[least])
    if room < bolts.spacing:
        raise DesignError(
            f"{found.names[least]} has no two bolts along an edge",
            keys=("stiffeners.bolts.spacing", "stiffeners.bolts.edge"),
            size=f"there is room for {max(room, 0.0):.4g} between holes that are "
            f"{bolts.off:.4g} off its sides",
            candidates=[Remedy({"stiffeners.bolts.spacing": rounded_down(room)})]
            if room >= 2 * bolts.hole * (1 + ROUNDED)
            else [],
            excess=bolts.spacing / room - 1 if room > 0 else None,
        )


def _places(design: Design, asked: Stiffeners) -> Integers:
    """Rows and columns (G, 2) of the vertices that gussets go from."""
    mechanism = design.mechanism
    inner = mechanism.inner_columns
    columns = between_flaps(design, inner, 1, "gussets")
    rows = fold_rows(mechanism, asked.rows, inner, "gusset")
    chosen = fold_columns(asked.columns, columns, "gusset")
    return np.array([(row, column) for row in rows for column in chosen], np.int64).reshape(-1, 2)


@record
class _Fault:
    """Why gussets do not fit."""

    what: str
    size: str
    excess: float | None


class Place:
    """A shell at its target, into which gussets are put."""

    def __init__(self, design: Design, lock: Lock, at: Integers, tolerance: float) -> None:
        self.design, self.at, self.tolerance = design, at, tolerance
        require_convex(design.flapped, "gussets")
        sheet = Sheet.of(design)
        self.sheet = sheet if design.clipped is None else sheet.with_flaps(design.clipped)
        whole = design.flapped
        self.faces = Layout.of(whole).faces
        self.points = points_of(whole, whole.target_drive)
        self.lying = panels_laid_flat(whole)
        built = lock.built
        if built is None and design.panel is not None:
            built = build_panels(design, design.mechanism.target_drive)
        self.boards = None
        if built is not None:
            self.boards = built.boards if design.clipped is None else built.with_flaps(whole)

    @property
    def levels(self) -> int:
        """At how many heights boards have outlines."""
        return 0 if self.boards is None else self.boards.outlines.shape[1]

    def fault(self, found: Gussets) -> _Fault | None:
        """Why gussets do not fit; None if they do."""
        left = found.left()
        least = int(np.argmin(left))
        if left[least] < LEAST_LEFT:
            kept = max(0.0, float(left[least]))
            return _Fault(
                f"{found.names[least]} has to stand too far off the panels beside it",
                f"{100 * kept:.0f} % of its way along edges is left, and {100 * LEAST_LEFT:.0f} % "
                "is the least",
                LEAST_LEFT - kept,
            )
        met = self.met(found)
        if met is None:
            return None
        first, second, depth = met
        return _Fault(
            f"{self.name(found, first)} and {self.name(found, second)} meet",
            f"one reaches {depth:.4g} into the other",
            depth / float(np.linalg.norm(np.ptp(found.corners, axis=1), axis=1).min()),
        )

    def met(self, found: Gussets) -> tuple[int, int, float] | None:
        """The two panels that reach farthest into each other, one a gusset, and how far."""
        return self._met(found) if self.boards is None else self._met_by_boards(found)

    def name(self, found: Gussets, panel: int) -> str:
        """What a panel is called; gussets come after those of the sheet."""
        if panel >= len(self.faces):
            return found.names[panel - len(self.faces)]
        row, column = self.sheet.panel(panel)
        return f"panel {row},{column}"

    def _with(self, found: Gussets) -> tuple[Integers, Array]:
        """Faces, and vertices at the target, those of gussets behind others."""
        count = len(self.points)
        more = count + np.arange(4 * len(found)).reshape(-1, 4)
        return (
            np.concatenate([self.faces, more]),
            np.concatenate([self.points, found.corners.reshape(-1, 3)]),
        )

    def _met_by_boards(self, found: Gussets) -> tuple[int, int, float] | None:
        """The two panels whose boards reach farthest into each other, one a gusset's."""
        assert self.boards is not None
        faces, points = self._with(found)
        own = found.boards(np.zeros((len(found), 2)), self.levels)
        own = replace(own, panels=own.panels + len(self.faces))
        boards = join_boards([self.boards, own])
        bodies = Bodies(boards, faces, np.concatenate([self.lying, found.lying()]))
        groups = np.maximum(boards.panels - len(self.faces) + 1, 0)
        deepest = deepest_between(bodies, points, self.tolerance, groups)
        if deepest is None or deepest[1] <= self.tolerance:
            return None
        first, second = sorted(boards.panels[list(deepest[0])].tolist(), reverse=True)
        return first, second, deepest[1]

    def _met(self, found: Gussets) -> tuple[int, int, float] | None:
        """The two panels without a thickness that pass farthest through each other, one a gusset.

        They may touch: a gusset has edges in common with the panels about its vertex, between which
        it lies, and with a gusset of the next row, which is on the other side of the sheet.
        """
        faces, points = self._with(found)
        own, grid = len(self.faces), self.design.flapped.grid
        first, second = near_panels(points, faces, self.tolerance)
        with_gusset = second >= own
        first, second = first[with_gusset], second[with_gusset]
        column = found.at[:, 1] + self.sheet.left
        vertex = (found.at[:, 0] * grid.columns + column)[second - own]
        around = (first < own) & (faces[first] == vertex[:, None]).any(axis=1)
        first, second = first[~around], second[~around]
        if not len(first):
            return None
        corners = corners_of(points, faces[first]), corners_of(points, faces[second])
        depths = overlaps(*corners)
        worst = first_largest(depths)
        if depths[worst] <= self.tolerance:
            return None
        return int(second[worst]), int(first[worst]), float(depths[worst])


def _largest(place: Place, build: PanelSpec | None) -> float:
    """The largest share that fits, of those that are tried; the first of them if none does."""
    shares = [rounded(USUAL * SMALLER**power, 3) for power in range(TRIED)]
    made = ((each, Gussets.of(place.design, place.at, each, build)) for each in shares)
    return next((each for each, found in made if place.fault(found) is None), shares[0])


def _others(place: Place, found: Gussets, asked: Stiffeners) -> Iterator[Remedy]:
    """Gussets that fit: that go less or more far along edges, are thinner, or in fewer columns."""
    design, build, share = place.design, found.build, found.share
    powers = [SMALLER**power for power in range(1, TRIED)]
    for each in (*(rounded(share * less, 3) for less in powers), LARGEST):
        if place.fault(Gussets.of(design, place.at, each, build)) is None:
            yield Remedy({"stiffeners.share": each})
            break
    if asked.thickness is not None and build is not None:
        for thickness in (rounded(asked.thickness * less, 3) for less in powers):
            thinner = build.replace_unchecked(thickness=thickness)
            if place.fault(Gussets.of(design, place.at, share, thinner)) is None:
                yield Remedy({"stiffeners.thickness": thickness})
                break
    left, columns = found.left(), place.at[:, 1]
    able = np.setdiff1d(columns, columns[left < LEAST_LEFT])
    some = place.at[np.isin(columns, able)]
    if not 0 < len(some) < len(place.at):
        return
    if place.fault(Gussets.of(design, some, share, build)) is None:
        yield Remedy({"stiffeners.columns": able.tolist()})

"""Whether panels are convex, flat where they should be, developable, and rigid."""

from __future__ import annotations

import numpy as np

from orishell.motion.mesh import measure_sector_sums
from orishell.motion.quads import corner_distances, diagonal_gaps, sector_angles
from orishell.verification.findings import Check, Names, Worst
from orishell.verification.sheet import Sheet, State


class ConvexTest:
    """Tests that no corner of a panel exceeds 180 degrees in the reference frame."""

    def __init__(self, sheet: Sheet, names: Names) -> None:
        angles = sector_angles(sheet.frame.positions[sheet.mesh.faces])
        widest = np.where(sheet.reflex, 2 * np.pi - angles, angles).max(axis=1)
        beyond = widest > np.pi + sheet.panel_limits
        panel = int(np.argmax(np.where(beyond, 10, widest)))
        self.passed = not beyond.any()
        degrees = float(np.rad2deg(widest[panel]))
        self.check = Check(
            "convex",
            self.passed,
            f"widest corner {degrees:.4g} deg (limit 180), {names.panel(panel)} in frame "
            f"{sheet.frame.number}",
            {
                "worst_deg": degrees,
                "limit_deg": 180.0,
                "frame": sheet.frame.number,
                **names.panel_place(panel),
            },
        )


class FlatTest:
    """Tests that no crease of the flat sheet is folded."""

    def __init__(self, sheet: Sheet, names: Names) -> None:
        self._worst = Worst(names.edge, names.edge_place)
        numbers = np.flatnonzero(sheet.mesh.crease)
        folds = np.abs(sheet.state(sheet.frame).folds)[numbers]
        self._worst.see(folds, sheet.edge_limits[numbers], sheet.frame.number, numbers)

    def checks(self) -> list[Check]:
        """The outcome of the test, if the sheet has creases."""
        return self._worst.checks("flat", "the flat sheet is folded by {} rad", "creases")


class DevelopableTest:
    """Tests that the sector angles at every inner vertex add up to 360 degrees in every frame."""

    def __init__(self, sheet: Sheet, names: Names) -> None:
        self._sheet, self._worst = sheet, Worst(names.vertex, names.vertex_place)

    def see(self, state: State) -> None:
        """Measure one frame."""
        sheet, inner = self._sheet, self._sheet.inner
        sums = measure_sector_sums(sheet.mesh, state.frame.positions, sheet.reflex)[inner]
        limits = sheet.vertex_limits[inner]
        self._worst.see(np.abs(sums - 2 * np.pi), limits, state.frame.number, inner)

    def checks(self) -> list[Check]:
        """The outcome of the test, if there are inner vertices."""
        return self._worst.checks("developable", "sector angles miss 360 deg by {} rad", "vertices")


class RigidTest:
    """Tests that the six distances of every panel's corners stay, and that panels stay plane."""

    def __init__(self, sheet: Sheet, names: Names) -> None:
        self._sheet = sheet
        self._lengths = Worst(names.panel, names.panel_place)
        self._planarity = Worst(names.panel, names.panel_place)

    def see(self, state: State) -> None:
        """Measure one frame."""
        sheet, frame = self._sheet, state.frame
        corners = frame.positions[sheet.mesh.faces]
        numbers = np.arange(len(corners))
        limits = np.full(len(corners), sheet.tolerance / sheet.diagonal)
        gaps = diagonal_gaps(corners) / sheet.diagonal
        self._planarity.see(gaps, limits, frame.number, numbers)
        if frame is not sheet.frame:
            change = np.abs(corner_distances(corners) - sheet.distances).max(axis=1)
            self._lengths.see(change / sheet.diagonal, limits, frame.number, numbers)

    def checks(self) -> list[Check]:
        """The outcome of the test."""
        changed, apart = "distances of corners change", "diagonals of panels are apart"
        return [
            *self._lengths.checks(
                "panel_length", changed + " by {} of the sheet's diagonal", "panels"
            ),
            *self._planarity.checks(
                "planarity", apart + " by {} of the sheet's diagonal", "panels"
            ),
        ]

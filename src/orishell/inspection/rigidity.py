"""Whether panels are convex, flat where they should be, developable, and rigid."""

from __future__ import annotations

import numpy as np

from orishell.inspection.findings import Check, Names, Worst
from orishell.inspection.sheet import Sheet, State
from orishell.mesh import measure_sector_sums
from orishell.panels import corner_distances, diagonal_gaps, sector_angles


class ConvexTest:
    """No corner of a panel is above 180 degrees in the reference frame."""

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
    """No crease of the flat sheet is folded."""

    def __init__(self, sheet: Sheet, names: Names) -> None:
        self._worst = Worst()
        self._names = names
        state = sheet.state(sheet.frame)
        numbers = np.flatnonzero(sheet.mesh.crease)
        folds = np.abs(state.folds)[numbers]
        self._worst.see(folds, sheet.edge_limits[numbers], sheet.frame.number, numbers)

    def checks(self) -> list[Check]:
        """What was found, if the sheet has creases."""
        if not self._worst.seen:
            return []
        worst, names = self._worst, self._names
        return [
            Check(
                "flat",
                worst.passed,
                f"the flat sheet is folded by {worst.figure:.1e} rad (limit {worst.limit:.1e}), "
                f"{names.edge(worst.number)} in frame {worst.frame}{worst.others('creases')}",
                {**facts_of(worst), **names.edge_place(worst.number)},
            )
        ]


class DevelopableTest:
    """The sector angles around every inner vertex add up to 360 degrees, in every frame."""

    def __init__(self, sheet: Sheet, names: Names) -> None:
        self._sheet, self._names, self._worst = sheet, names, Worst()

    def see(self, state: State) -> None:
        """Measure one frame."""
        sheet, inner = self._sheet, self._sheet.inner
        sums = measure_sector_sums(sheet.mesh, state.frame.positions, sheet.reflex)[inner]
        limits = sheet.vertex_limits[inner]
        self._worst.see(np.abs(sums - 2 * np.pi), limits, state.frame.number, inner)

    def checks(self) -> list[Check]:
        """What was found, if there are inner vertices."""
        if not self._worst.seen:
            return []
        worst, names = self._worst, self._names
        return [
            Check(
                "developable",
                worst.passed,
                f"sector angles miss 360 deg by {worst.figure:.1e} rad (limit {worst.limit:.1e}), "
                f"{names.vertex(worst.number)} in frame {worst.frame}{worst.others('vertices')}",
                {**facts_of(worst), **names.vertex_place(worst.number)},
            )
        ]


class RigidTest:
    """The panels keep their six distances and stay plane, in every frame."""

    def __init__(self, sheet: Sheet, names: Names) -> None:
        self._sheet, self._names = sheet, names
        self._lengths, self._planarity = Worst(), Worst()

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
        """What was found."""
        found = []
        for name, says, worst in (
            ("panel_length", "distances of corners change", self._lengths),
            ("planarity", "diagonals of panels are apart", self._planarity),
        ):
            if worst.seen:
                text = (
                    f"{says} by {worst.figure:.1e} of the diagonal (limit {worst.limit:.1e}), "
                    f"{self._names.panel(worst.number)} in frame {worst.frame}"
                    f"{worst.others('panels')}"
                )
                facts = {**facts_of(worst), **self._names.panel_place(worst.number)}
                found.append(Check(name, worst.passed, text, facts))
        return found


def facts_of(worst: Worst) -> dict[str, float | int]:
    """The report's fields for the worst figure."""
    return {
        "worst": worst.figure,
        "limit": worst.limit,
        "beyond": len(worst.beyond),
        "frame": worst.frame,
    }

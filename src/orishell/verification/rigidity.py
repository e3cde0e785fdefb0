"""Whether panels are convex, flat where they should be, developable and rigid, and which touch."""

from __future__ import annotations

from typing import Any

import numpy as np

from orishell.clash import find_contacts, overlap_depths
from orishell.motion.mesh import measure_sector_sums
from orishell.motion.quads import corner_distances, diagonal_gaps, sector_angles
from orishell.numerics.equals import descending, first_largest
from orishell.verification.findings import Check, Contacts, Names, Worst
from orishell.verification.residuals import turn_between
from orishell.verification.sheet import Sheet, State


class ConvexTest:
    """Tests that no corner of a panel exceeds 180 degrees in the reference frame."""

    def __init__(self, sheet: Sheet, names: Names) -> None:
        angles = sector_angles(sheet.frame.positions[sheet.mesh.faces])
        widest = np.where(sheet.reflex, 2 * np.pi - angles, angles).max(axis=1)
        beyond = widest > np.pi + sheet.panel_limits
        panel = first_largest(np.where(beyond, 10, widest))
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
                **names.panel(panel).facts,
            },
        )


class FlatTest:
    """Tests that no crease of the flat sheet is folded."""

    def __init__(self, sheet: Sheet, names: Names) -> None:
        self._worst = Worst(names.edge)
        numbers = np.flatnonzero(sheet.mesh.crease)
        folds = np.abs(sheet.state(sheet.frame).folds)[numbers]
        self._worst.see(folds, sheet.edge_limits[numbers], sheet.frame.number, numbers)

    def checks(self) -> list[Check]:
        """The outcome of the test, if the sheet has creases."""
        return self._worst.checks("flat", "the flat sheet is folded by {} rad", "creases")


class DevelopableTest:
    """Tests that the sector angles at every inner vertex add up to 360 degrees in every frame."""

    def __init__(self, sheet: Sheet, names: Names) -> None:
        self._sheet, self._worst = sheet, Worst(names.vertex)

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
        self._lengths = Worst(names.panel)
        self._planarity = Worst(names.panel)

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


LISTED = 100
"""Pairs of panels that a report lists for each frame."""


class ClashTest:
    """Tests that no panels touch in any frame before the last, nor pass through each other there.

    The end is the last folded frame, or the first one if the file's last frame is not folded. Where
    there is no flat sheet, the motion may end with either.
    A frame with the same fold angles is the end too. Panels there may reach into each other by as
    much as a length may be wrong, which is also the distance below which they touch.
    """

    def __init__(self, sheet: Sheet, names: Names) -> None:
        self._sheet, self._names = sheet, names
        self._touching: list[tuple[State, Contacts]] = []
        self._first: State | None = None
        self._last: State | None = None
        self._last_is_folded = False
        self._frames = 0

    def see(self, state: State) -> None:
        """Look for contacts in one frame."""
        sheet, frame = self._sheet, state.frame
        self._frames += 1
        if state.folded:
            self._first, self._last = self._first or state, state
        if frame is not sheet.frame or not sheet.flat:
            self._last_is_folded = state.folded
        pairs = find_contacts(frame.positions, sheet.mesh.faces, sheet.tolerance)
        if len(pairs):
            self._touching.append((state, Contacts(frame.number, pairs)))

    @property
    def touching_at_end(self) -> bool:
        """Whether panels touch in a frame in which the motion may end."""
        return any(self._ends(state) for state, _ in self._touching)

    def checks(self) -> list[Check]:
        """The outcome of the test."""
        early = [contacts for state, contacts in self._touching if not self._ends(state)]
        at_end = [(state, contacts) for state, contacts in self._touching if self._ends(state)]
        end, names = [contacts for _, contacts in at_end], self._names
        crossing, depth = self._crossing(at_end)
        if early:
            first = early[0]
            text = (
                f"{names.pair(first.pairs[0])} touch in frame {first.frame}, "
                f"{_pairs(len(first.pairs))} there; touching frames: "
                + ", ".join(str(contacts.frame) for contacts in early[:10])
                + (", ..." if len(early) > 10 else "")
            )
        else:
            count = self._frames - len(end)
            text = f"no panels touch in {count} frames" if count else "only the end was tested"
        if crossing:
            worst = crossing[-1]
            text += (
                f"; {names.pair(worst.pairs[0])} pass through each other at the end of the motion, "
                f"by {depth:.1e} (limit {self._sheet.tolerance:.1e}): {_pairs(len(worst.pairs))} "
                f"in frame {worst.frame}"
            )
        elif end:
            text += (
                f"; contact at the end of the motion: {_pairs(len(end[-1].pairs))} in frame "
                f"{end[-1].frame}, {names.pair(end[-1].pairs[0])}"
            )
        facts = {
            "contacts": self._listed(early),
            "contacts_at_end": self._listed(end),
            "crossing_at_end": self._listed(crossing),
        }
        return [Check("clash", not (early or crossing), text, facts)]

    def _crossing(self, touching: list[tuple[State, Contacts]]) -> tuple[list[Contacts], float]:
        """The contacts that are more than that, deepest first, and how deep the last's first is."""
        found, depth = [], 0.0
        for state, contacts in touching:
            depths = overlap_depths(state.frame.positions, self._sheet.mesh.faces, contacts.pairs)
            deepest = descending(depths)
            crossing = deepest[depths[deepest] > self._sheet.tolerance]
            if len(crossing):
                depth = float(depths[crossing[0]])
                found.append(Contacts(contacts.frame, contacts.pairs[crossing]))
        return found, depth

    def _ends(self, state: State) -> bool:
        ends = [self._last if self._last_is_folded else self._first]
        if not self._sheet.flat:
            ends = [self._first, self._last]
        return state.folded and any(
            bool((turn_between(state.folds, end.folds) <= self._sheet.edge_limits).all())
            for end in ends
            if end is not None
        )

    def _listed(self, touching: list[Contacts]) -> list[dict[str, Any]]:
        return [
            {
                "frame": contacts.frame,
                "count": len(contacts.pairs),
                "pairs": [self._names.pair(pair).facts for pair in contacts.pairs[:LISTED]],
            }
            for contacts in touching
        ]


def _pairs(count: int) -> str:
    return "1 pair" if count == 1 else f"{np.int64(count)} pairs"

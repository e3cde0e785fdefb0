"""Which panels touch, whether that is the end of the motion, and which pass through each other."""

from __future__ import annotations

from typing import Any

import numpy as np

from orishell.clash import find_contacts, overlap_depths
from orishell.verification.findings import Check, Contacts, Names
from orishell.verification.sheet import Sheet, State
from orishell.verification.signs import turn_between

LISTED = 100
"""Pairs of panels that a report lists for each frame."""


class ClashTest:
    """Tests that no panels touch in any frame before the last, nor pass through each other there.

    The end is the last folded frame, or the first one if the file's last frame is not folded.
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
            deepest = np.argsort(-depths, kind="stable")
            crossing = deepest[depths[deepest] > self._sheet.tolerance]
            if len(crossing):
                depth = float(depths[crossing[0]])
                found.append(Contacts(contacts.frame, contacts.pairs[crossing]))
        return found, depth

    def _ends(self, state: State) -> bool:
        end = self._last if self._last_is_folded else self._first
        if end is None or not state.folded:
            return False
        return bool((turn_between(state.folds, end.folds) <= self._sheet.edge_limits).all())

    def _listed(self, touching: list[Contacts]) -> list[dict[str, Any]]:
        return [
            {
                "frame": contacts.frame,
                "count": len(contacts.pairs),
                "pairs": [self._names.pair_place(pair) for pair in contacts.pairs[:LISTED]],
            }
            for contacts in touching
        ]


def _pairs(count: int) -> str:
    return "1 pair" if count == 1 else f"{np.int64(count)} pairs"

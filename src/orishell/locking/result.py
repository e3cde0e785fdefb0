"""What is found of a motion: how it ends, and what touches first."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from orishell.clash import ProofRecord
from orishell.conventions.formatting import in_degrees
from orishell.solids import BuiltPanels

Panel = tuple[int, int]
"""Row and column of a panel."""

Kind = Literal[
    "flap on flap",
    "opposite flaps",
    "flap on panel",
    "neighbours",
    "at the sheet's edge",
    "distant panels",
    "boards",
]
Cause = Literal["flaps", "clash", "crease", "hinges", "boards"]


@dataclass(frozen=True, slots=True)
class Contact:
    """Two panels that touch."""

    drive: float  # where they touch (radians)
    # up to here no panels touch, proved: 0 if the path was not examined (radians)
    clear_until: float
    # the two panels; those of flaps that are clipped on are in the columns beside the sheet's, -1
    # the one on the left
    panels: tuple[Panel, Panel]
    # two flaps of one column (neighbours of these at the end of the motion are what the design
    # means), or of both; a flap on another panel; neighbours about a crease that is folded flat; a
    # panel of the sheet's border on another; panels inside it; boards on panels
    kind: Kind
    depth: float  # depth of the corrugation there (length)
    # which boards of the panels touch, "top", "bottom" or "panel"; None if panels do
    sides: tuple[str, str] | None = None
    # how far one reaches into the other at least, where they were looked at in one state only; None
    # along a path, on which they only touch (length)
    overlap: float | None = None

    @property
    def names(self) -> tuple[str, str]:
        """What the two are called: "panel [0, 1]", or "the top board of panel [0, 1]"."""
        first, second = (
            f"the {side} board of panel {list(panel)}"
            if side in {"top", "bottom"}
            else f"panel {list(panel)}"
            for panel, side in zip(self.panels, self.sides or ("", ""), strict=True)
        )
        return first, second


@dataclass(frozen=True, slots=True)
class Lock:
    """How a motion ends."""

    drive: float | None  # where it ends, or None if nothing ends it (radians)
    # flaps folded onto each other as designed, panels that clash, another crease that is folded
    # flat, hinges that close no further, or boards: they meet there, or leave too little of a panel
    # beyond
    cause: Cause | None
    first_contact: Contact | None  # the first contact, if there is one
    target: float  # drive of the target state (radians)
    depth: float  # depth of the corrugation in that state (length)
    # pairs of panels, flaps and neighbours left out, that touch at the target and not before
    touching: tuple[tuple[Panel, Panel], ...]
    proof: ProofRecord | None  # how the path was examined, or None if it was not
    # the boards of panels that have a thickness; None if they have none
    built: BuiltPanels | None = None
    # how the path was examined for contact of boards, or None if it was not
    boards_proof: ProofRecord | None = None
    # what flaps that are clipped on at the target reach into there, or boards of theirs touch; None
    # if nothing
    clipped_contact: Contact | None = None

    def __repr__(self) -> str:
        target = f"target at {in_degrees(self.target)} degrees"
        end = "no end" if self.drive is None else f"{self.cause} at {in_degrees(self.drive)}"
        path = "path not examined" if self.proof is None else "path examined"
        return f"{type(self).__name__}({end}, {target}, {path})"

    @property
    def closes_to(self) -> float:
        """As far as the motion goes, proved free of contact if its path was examined (radians)."""
        if self.cause in {"clash", "boards"} and self.first_contact is not None:
            return self.first_contact.clear_until
        return self.target if self.drive is None else self.drive

    @property
    def early(self) -> bool:
        """Whether panels clash before the shell stands at its target with its flaps."""
        return self.obstacle is not None

    @property
    def obstacle(self) -> Contact | None:
        """What keeps the shell from its target, or its clipped flaps from their place there."""
        first = self.first_contact
        met = self.cause in {"clash", "boards"} and first is not None and first.drive < self.target
        return first if met else self.clipped_contact

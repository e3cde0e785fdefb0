"""What is found of a motion: how it ends, and what touches first."""

from __future__ import annotations

from typing import Literal

from orishell.clash import ProofRecord
from orishell.conventions.formatting import in_degrees
from orishell.conventions.record import Angle, record
from orishell.motion.boards import BARE, SIDES
from orishell.motion.grid import Panel
from orishell.solids import BuiltPanels

Kind = Literal[
    "flap on flap",
    "opposite flaps",
    "flap on panel",
    "neighbours",
    "at the sheet's edge",
    "distant panels",
    "boards",
]
Cause = Literal["flaps", "clash", "crease", "hinges", "boards", "unproved"]
"""What ends a motion."""
MET = ("clash", "boards", "unproved")
"""Causes up to which a motion is proved, and which are not where it could end by itself."""


@record
class Contact:
    """Two panels that touch, or that are not proved apart."""

    drive: Angle  # the drive angle at which they do
    clear_until: Angle  # up to here no panels touch, proved; 0 if the path was not examined
    # the two panels; those of flaps that are clipped on are in the columns beside the sheet's, -1
    # the one on the left
    panels: tuple[Panel, Panel]
    # which parts of the sheet they belong to: two flaps of one column (neighbours of these at the
    # end of the motion are what the design means), or of both; a flap on another panel; neighbours
    # about a crease that is folded flat; a panel of the sheet's border on another; panels inside
    # it; boards on panels
    kind: Kind
    corrugation_depth: float  # depth of the corrugation there (length)
    # which boards of the panels touch, "top", "bottom" or, where panels are solid, "panel"; arms of
    # whole boards by their edge, "arm left"; "membrane" on a face without boards; None if panels
    # without a thickness do
    sides: tuple[str, str] | None = None
    # how far one reaches into the other, if they were looked at in one state only; None if they
    # touch on the way (length)
    overlap: float | None = None
    # how far they are apart, at least, if they are not seen to touch and are merely not proved
    # apart; None if they touch (length)
    apart: float | None = None
    # what the two are called, if one is no panel of the sheet
    called: tuple[str, str] | None = None

    @property
    def names(self) -> tuple[str, str]:
        """What the two are called: "panel [0, 1]", "the top board of panel [0, 1]"."""
        if self.called is not None:
            return self.called
        sides = self.sides or ("", "")
        first, second = (_called(*each) for each in zip(self.panels, sides, strict=True))
        return first, second


def _called(panel: Panel, side: str) -> str:
    """A panel, a board of it, or an arm: these are called after an edge, "arm left"."""
    kind, _, edge = side.partition(" ")
    if kind == "arm":
        return f"the {edge} arm of panel {list(panel)}"
    whole = f"panel {list(panel)}"
    if side == SIDES[BARE]:
        return f"the {side} of {whole}"
    return f"the {side} board of {whole}" if side in {"top", "bottom"} else whole


@record
class CarriedMotion:
    """How far a shell moves with strips that its sheet carries."""

    joined_from: Angle  # nearer to the flat sheet than this drive nothing is proved
    closes_to: Angle  # as far as their boards have room, and are apart in each
    # what meets there; None if it was not asked further
    opening: Contact | None
    # what meets on the way to the pack; None if the sheet ends it
    closing: Contact | None
    # how contact was looked for, to either side of the target; empty if it was not
    proofs: tuple[ProofRecord, ...]


@record
class BoxMotion(CarriedMotion):
    """How far a shell moves with its box girders."""

    REPORTED = ("rows", "shares", "joined_from", "closes_to", "opening", "closing", "proofs")

    rows: tuple[int, ...]  # of vertices that sleeves are over
    shares: tuple[float, ...]  # of each row, how far out it hangs on edges of columns at the most


@record
class SkinMotion(CarriedMotion):
    """A second skin, its walls, and how far a shell moves with them."""

    REPORTED = (
        *("gap", "largest_gap", "off", "walls", "cells", "volume"),
        *("joined_from", "closes_to", "opening", "closing", "proofs"),
    )

    gap: float  # smallest distance of panels of both skins at the target (length)
    largest_gap: float  # largest distance of panels that walls may be between there (length)
    # distance of its staircase from the curve that it follows; None if it follows none (length)
    off: float | None
    walls: tuple[int, ...]  # rows of panels of the sheet that walls hang on
    cells: int  # cavities between two walls, open at both ends
    volume: float  # what cavities hold at the target (length cubed)


@record
class Lock:
    """How a motion ends."""

    REPORTED = (
        "drive",
        "cause",
        "target_drive",
        "corrugation_depth",
        "first_contact",
        "touching_at_end",
        "clipped_contact",
        "path",
    )

    drive: Angle | None  # where it ends; None if nothing ends it
    # what ends it: flaps folded onto each other as designed, panels that clash, another crease that
    # is folded flat, hinges that close no further, or boards, which meet there or would leave too
    # little of a panel; or the proof, beyond which it is not known whether two panels meet
    cause: Cause | None
    first_contact: Contact | None  # the panels that touch first, if any do
    target_drive: Angle  # where the shell meets its target
    # at the target, the mean distance (length) of inner vertices from the line between those above
    # and below
    corrugation_depth: float
    # pairs of panels that touch at the end of the motion and are not meant to
    touching_at_end: tuple[tuple[Panel, Panel], ...]
    path: ProofRecord | None  # how contact was looked for; None if it was not
    # the boards of panels that have a thickness; None if they have none
    built: BuiltPanels | None = None
    boards_proof: ProofRecord | None = None  # how contact of boards was; None if it was not
    # what flaps that are clipped on at the target meet there; None if nothing, or if there are none
    clipped_contact: Contact | None = None
    boxes: BoxMotion | None = None  # how far it goes with box girders; None if there are none
    skin: SkinMotion | None = None  # how far it goes with a second skin; None if there is none

    def __repr__(self) -> str:
        target = f"target at {in_degrees(self.target_drive)} degrees"
        end = "no end" if self.drive is None else f"{self.cause} at {in_degrees(self.drive)}"
        path = "path not examined" if self.path is None else "path examined"
        return f"{type(self).__name__}({end}, {target}, {path})"

    @property
    def carried(self) -> CarriedMotion | None:
        """How far it goes with what the sheet carries; None if that is nothing."""
        return self.boxes or self.skin

    @property
    def closes_to(self) -> float:
        """As far as the motion goes, proved free of contact if its path was examined (radians)."""
        if self.cause in MET and self.first_contact is not None:
            return self.first_contact.clear_until
        return self.target_drive if self.drive is None else self.drive

    @property
    def early(self) -> bool:
        """Whether it is not proved that the shell stands at its target with its flaps."""
        return self.obstacle is not None

    @property
    def reaches_target(self) -> bool | None:
        """Whether nothing meets before the target; None if that is not proved, and nothing seen."""
        found = self.obstacle
        return None if found is not None and found.apart is not None else found is None

    @property
    def obstacle(self) -> Contact | None:
        """What keeps the shell from its target, or its clipped flaps from their place there."""
        first = self.first_contact
        met = self.cause in MET and first is not None and first.drive < self.target_drive
        return first if met else self.clipped_contact

    @property
    def warnings(self) -> tuple[str, ...]:
        """Panels that meet before the target, or touch there and should not; what is not proved."""
        contact = self.obstacle
        if contact is not None and contact is self.clipped_contact:
            first, second = contact.names
            return (
                f"{first} and {second} meet when flaps are clipped on at the target: these have no "
                "room there",
            )
        if contact is not None and contact.apart is not None:
            first, second = contact.names
            return (
                f"that {first} and {second} do not meet is not proved beyond drive "
                f"{in_degrees(contact.clear_until)} of {in_degrees(self.target_drive)} degrees: "
                "nothing is known of the way from there to the target",
            )
        if contact is not None:
            one, other = (list(panel) for panel in contact.panels)
            return (
                f"panels {one} and {other} meet at drive {in_degrees(contact.drive)} of "
                f"{in_degrees(self.target_drive)} degrees: the shell stops there, short of its "
                "target",
            )
        if self.touching_at_end:
            one, other = (list(panel) for panel in self.touching_at_end[0])
            return (
                f"{len(self.touching_at_end)} pairs of panels touch at the target without being "
                f"meant to, for example {one} and {other}",
            )
        return ()

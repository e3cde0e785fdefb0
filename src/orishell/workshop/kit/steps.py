"""The steps in which a shell is made, carried and put up: those that it has, in their order."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import ceil

from orishell.conventions.quantities import PERSON_KG, box, plain, size
from orishell.conventions.record import record
from orishell.document import FLAT, SHELL, Document
from orishell.numerics.arrays import Booleans, Integers
from orishell.workshop.kit.facts import KitFacts, middle_state

SLIM = 0.03
"""A pack less high than this share of its length is flat."""


@record
class Step:
    """A step: what is done, what is checked, and the state that a picture shows."""

    name: str  # its key in the words of the booklet
    values: Mapping[str, str]  # what its words say
    state: int | str | None = None  # None where there is no picture
    panels: Booleans | None = None  # the panels that are drawn; all if None
    plan: bool = False  # whether it is seen from above
    joined: Integers | None = None  # vertices (K, 2) between which lines are drawn
    check: str = ""  # the key of the words that say what is checked; its own name where empty


def kit_steps(document: Document, facts: KitFacts) -> tuple[Step, ...]:
    """The steps of a shell, those of a model without loads and anchors."""
    return (*_making(document, facts), *_putting_up(document, facts))


def _making(document: Document, facts: KitFacts) -> Iterator[Step]:
    piece = facts.pieces[0] if len(facts.pieces) > 1 else None
    said = {"sheet": box(facts.sheet, document.unit), "pieces": plain(len(facts.pieces))}
    if facts.diagonals:
        measured = "; ".join(
            " / ".join(size(each, document.unit, digits=DIGITS) for each in pair)
            for pair in facts.diagonals
        )
        said["diagonals"] = measured
    joins = {"": "crease", "sandwich": "glue", "bevel": "hinge", "hinged": "screw"}
    check = "diagonals" if facts.diagonals else "none"
    yield Step("lay_out", said, FLAT, piece, plan=True, check="none")
    yield Step(joins[facts.construction], said, FLAT, piece, plan=True, check=check)


def _putting_up(document: Document, facts: KitFacts) -> Iterator[Step]:
    unit, piece = document.unit, facts.pieces[0] if len(facts.pieces) > 1 else None
    opened = {"opened": box(facts.opened, unit), "pieces": plain(len(facts.pieces))}
    standing = "shut" if facts.shuts else "none"
    if facts.apart is not None:
        opened["apart"] = _between(*facts.apart, unit)
        standing = "apart_shut" if facts.shuts else "apart"
    elif facts.ties and facts.ties_early and not facts.shuts:
        standing = "taut"  # they are fixed before
    tie = [] if not facts.ties else [_tie(document, facts)]
    if facts.starts_packed:
        yield Step("fold_pack", opened, "pack", piece, check="none")
        if facts.ties_early:
            yield from tie
        if not facts.model:
            yield from _carrying(facts, piece, unit)
        half = middle_state(document, "pack")
        yield Step(
            "open", opened, half, piece, check="open_piece" if piece is not None else standing
        )
        if piece is not None:
            yield Step("join", opened, SHELL, check=standing)
    else:
        yield Step("fold", opened, middle_state(document, FLAT), check=standing)
    if not facts.ties_early:
        yield from tie
    if facts.flaps:
        values = {"flaps": plain(facts.flaps), "panels": plain(facts.clipped_panels)}
        yield Step("clip", values, SHELL)
    if facts.feet and not facts.model:
        check = "apart" if facts.apart is not None else "none"
        yield Step("anchor", {**opened, "feet": plain(facts.feet)}, SHELL, check=check)


def _tie(document: Document, facts: KitFacts) -> Step:
    values = {
        "ties": plain(len(facts.ties)),
        "length": _between(min(facts.ties), max(facts.ties), document.unit),
    }
    name = "tie" if facts.ties_early else "tie_open"
    return Step(name, values, SHELL, joined=facts.tied, check="tie")


def _carrying(facts: KitFacts, piece: Booleans | None, unit: str) -> Iterator[Step]:
    if not facts.packs:
        return
    values = {"packs": pack_words(facts, unit), "layers": plain(facts.layers)}
    name = "load" if facts.construction else "load_bare"
    yield Step(name, values, "pack", piece)
    if facts.mass is not None:
        values["mass"] = f"{plain(facts.mass, 3)} kg"
        values["people"] = str(ceil(facts.mass / PERSON_KG))
        values["each"] = f"{plain(PERSON_KG)} kg"
        yield Step("carry", values, "pack", piece, check="none")


def pack_words(facts: KitFacts, unit: str) -> str:
    """The sides of all packs."""
    return "; ".join(pack_boxes(facts, unit))


def pack_boxes(facts: KitFacts, unit: str) -> tuple[str, ...]:
    """The sides of each pack; of panels without a thickness a flat one has no height."""
    return tuple(
        box(pack[:2] if not facts.construction and pack[2] < SLIM * pack[0] else pack, unit)
        for pack in facts.packs
    )


DIGITS = 4
"""Of what is measured with a tape: millimetres of metres."""


def _between(low: float, high: float, unit: str) -> str:
    """A length, or the least and the largest."""
    least, most = (size(each, unit, digits=DIGITS) for each in (low, high))
    return least if least == most else f"{least} - {most}"

"""The steps in which a shell is made, carried and put up: those that it has, in their order."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from math import ceil
from typing import Final

from orishell.conventions.quantities import PERSON_KG, box, plain, size
from orishell.document import FLAT, OPEN, SHELL, Document
from orishell.document.ground import GroundPlan
from orishell.numerics.arrays import Booleans
from orishell.workshop.kit.card_steps import card_steps
from orishell.workshop.kit.facts import KitFacts
from orishell.workshop.kit.folding import state_between
from orishell.workshop.kit.parts import KitPart
from orishell.workshop.kit.step import (
    DIGITS,
    LAST,
    Step,
    between,
    closing_steps,
    diagonals_of,
    fitted_steps,
    tie_step,
)
from orishell.workshop.kit.words import Words
from orishell.workshop.seams import Seams
from orishell.workshop.settings import Workshop

SLIM = 0.03
"""A pack less high than this share of its length is flat."""


CUT: Final = {"screw": "drill", "bracket": "drill", "arm": "bend", "block": "blocks"}
FIXED: Final = {"arm": "arms_first", "block": "arms_first", "screw": "loose"}
"""What is said of parts where boards are cut, and where they are joined: keys of words."""


def kit_steps(
    document: Document, workshop: Workshop, facts: KitFacts, parts: Sequence[KitPart]
) -> tuple[Step, ...]:
    """The steps of a shell, or of a model of card."""
    if facts.model:
        return (*card_steps(document, workshop, facts, {part.name for part in parts}),)
    making = _making(document, workshop, facts, {part.name for part in parts})
    return (*making, *_strips_joined(document, facts), *_putting_up(document, facts))


def _making(
    document: Document, workshop: Workshop, facts: KitFacts, parts: set[str]
) -> Iterator[Step]:
    said = {"pieces": plain(len(facts.pieces)), **diagonals_of(facts, document.unit)}
    check = f"diagonals_{facts.construction or 'sheet'}" if facts.diagonals else ""
    split = bool(parts & {"sheet_parts", "membrane_parts"})
    joined = ("strips" if "strip" in parts else "tabs",)
    if not facts.construction:
        name = "crease" if workshop.creases == "score" else "crease_cut"
        yield Step(name, said, FLAT, plan=True, check="all_parts" if split else check)
        if split:
            yield Step("join_parts", said, FLAT, plan=True, check=check, more=joined)
        return
    planed = ("chamfers",) if facts.construction == "bevel" else ()
    cut = (*planed, *_also(parts, CUT))
    one_side = f"_{facts.one_side}" if facts.one_side else ""
    yield Step(f"cut_{facts.construction}{one_side}", said, check="all_parts", more=cut)
    if split:
        yield Step("join_parts", said, FLAT, plan=True, check=check, more=joined)
    if facts.construction == "sandwich":
        yield Step(f"glue{one_side}", said, FLAT, plan=True, check="" if split else check)
        return
    yield Step("lay_out", said, FLAT, plan=True)
    joins = "hinge" if facts.construction == "bevel" else "screw"
    piece = facts.pieces[0] if len(facts.pieces) > 1 else None
    yield Step(joins, said, FLAT, piece, plan=True, check=check, more=_also(parts, FIXED))


def _strips_joined(document: Document, facts: KitFacts) -> Iterator[Step]:
    """Where the shell is no one flat sheet: its strips become one."""
    if facts.strips == 1:
        return
    seams = document.mesh.edges[Seams.of(document).edges[:, 0]]
    said, boards = {"strips": plain(facts.strips)}, ("strips_boards",) * bool(facts.construction)
    yield Step("join_strips", said, OPEN, joined=seams, more=boards)


def _also(parts: set[str], words: Mapping[str, str]) -> tuple[str, ...]:
    """Keys of words about parts that there are."""
    return tuple(key for part, key in words.items() if part in parts)


def _putting_up(document: Document, facts: KitFacts) -> Iterator[Step]:
    unit, piece = document.unit, facts.pieces[0] if len(facts.pieces) > 1 else None
    said = {"opened": box(facts.opened, unit), "pieces": plain(len(facts.pieces))}
    several: tuple[str, ...] = ()
    if facts.freedoms is not None:
        several, said["freedoms"] = (f"several_{facts.freedoms[0]}",), facts.freedoms[1]
    standing = "shut" if facts.shuts else ""
    if facts.apart is not None:
        said["apart"] = between(*facts.apart, unit)
        standing = "apart_shut" if facts.shuts else "apart"
    elif facts.ties and facts.ties_early and not facts.shuts:
        standing = "taut"  # they are fixed before
    tie = [] if not facts.ties else [tie_step(document, facts)]
    mark = [] if document.ground is None else [_mark_out(document, document.ground)]
    moving = {part.kind for part in document.attached if document.moves(part)}
    yield from fitted_steps(document, moving, state_between(document, FLAT, 0.5))
    if facts.starts_packed:
        yield Step("fold_pack" if piece is None else "fold_pieces", said, "pack", piece)
        if facts.ties_early:
            yield from tie
        loaded = bool(facts.packs)
        if loaded:
            yield from _carrying(facts, piece, unit)
        yield from mark
        half = state_between(document, "pack", 0.5)
        if piece is None:
            name = "open" if loaded else "open_bare"
            yield Step(name, said, half, check=standing, more=several)
        else:
            name = "open_pieces" if loaded else "open_pieces_bare"
            yield Step(name, said, half, piece, check="open_piece", more=several)
            yield Step("join", said, SHELL, check=standing)
    else:
        yield from mark
        yield Step("fold", said, state_between(document, FLAT, 0.5), check=standing, more=several)
    if not facts.ties_early:
        yield from tie
    others = {part.kind for part in document.attached} - moving
    yield from fitted_steps(document, others - LAST, SHELL)
    if facts.anchored:
        check = "apart" if facts.apart is not None else ""
        values = {**said, "feet": plain(facts.feet)}
        yield Step("anchor", values, SHELL, marked=facts.footing, check=check)
    yield from closing_steps(document, facts, others & LAST)


def _mark_out(document: Document, plan: GroundPlan) -> Step:
    """Feet on the ground, and the ground that is needed, as far as it is known."""
    unit, swept, feet = document.unit, plan.swept, plan.feet
    values, check = {"feet": plain(len(feet))}, ""
    if swept is not None:
        values["ground"] = " x ".join(
            size(each, unit, bound=True) for each in (swept.width, swept.depth)
        )
        values["height"] = size(swept.height, unit, bound=True)
    if plan.crossed:
        values["crossed"] = "; ".join(
            f"{a.number} - {b.number}: {size(a.apart(b), unit, digits=DIGITS)}"
            for a, b in plan.crossed
        )
        check = "crossed"
    return Step("mark_out", values, more=("ground",) * (swept is not None), check=check)


def _carrying(facts: KitFacts, piece: Booleans | None, unit: str) -> Iterator[Step]:
    values = {"packs": pack_words(facts, unit), "layers": plain(facts.layers)}
    values["pieces"] = plain(len(facts.pieces))
    name = "load" if facts.construction else "load_bare"
    yield Step(name, values, "pack", piece, check="straps")
    if facts.mass is not None:
        values["mass"] = f"{plain(facts.mass, 3)} kg"
        values["people"] = str(ceil(facts.mass / PERSON_KG))
        values["each"] = f"{plain(PERSON_KG)} kg"
        yield Step("carry", values)


def pack_words(facts: KitFacts, unit: str) -> str:
    """The sides of all packs."""
    return "; ".join(pack_boxes(facts, unit))


def carried(facts: KitFacts, unit: str, words: Words) -> Iterator[str]:
    """What is carried, a line each: its sizes in the pack and flat, and its mass if it is known."""
    if facts.packs and facts.starts_packed:
        key = "cover.packed" if facts.construction else "cover.packed_bare"
        yield words.say(key, size=pack_words(facts, unit), layers=facts.layers)
    key = "cover.sheet" if facts.strips == 1 else "cover.strips"
    yield words.say(key, size=box(facts.sheet, unit), strips=facts.strips)
    if facts.mass is not None:
        yield words.say("cover.mass", mass=f"{plain(facts.mass, 3)} kg")


def pack_boxes(facts: KitFacts, unit: str) -> tuple[str, ...]:
    """The sides of each pack; of panels without a thickness a flat one has no height."""
    return tuple(
        box(pack[:2] if not facts.construction and pack[2] < SLIM * pack[0] else pack, unit)
        for pack in facts.packs
    )

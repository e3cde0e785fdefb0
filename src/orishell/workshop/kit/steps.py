"""The steps in which a shell is made, carried and put up: those that it has, in their order."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from math import ceil
from typing import Final

import numpy as np

from orishell.conventions.quantities import PERSON_KG, box, plain, size
from orishell.conventions.record import record
from orishell.document import FLAT, SHELL, Document
from orishell.document.ground import GroundPlan
from orishell.numerics.arrays import Booleans, Integers
from orishell.workshop.kit.facts import KitFacts, middle_state
from orishell.workshop.kit.parts import KitPart
from orishell.workshop.kit.words import Words
from orishell.workshop.settings import Workshop

SLIM = 0.03
"""A pack less high than this share of its length is flat."""


CUT: Final = {"screw": "drill", "bracket": "drill", "arm": "bend", "block": "blocks"}
FIXED: Final = {"arm": "arms_first", "block": "arms_first", "screw": "loose"}
"""What is said of parts where boards are cut, and where they are joined: keys of words."""


@record
class Step:
    """A step: what is done, what is checked, and the state that a picture shows."""

    name: str  # its key in the words of the booklet
    values: Mapping[str, str]  # what its words say
    state: int | str | None = None  # None where there is no picture
    panels: Booleans | None = None  # the panels that are drawn; all if None
    plan: bool = False  # whether it is seen from above
    joined: Integers | None = None  # vertices (K, 2) between which lines are drawn
    marked: Integers | None = None  # vertices (M,) that are marked
    check: str = ""  # the key of the words that say what is checked; empty where nothing is
    more: tuple[str, ...] = ()  # keys of words that follow those of the step


def kit_steps(
    document: Document, workshop: Workshop, facts: KitFacts, parts: Sequence[KitPart]
) -> tuple[Step, ...]:
    """The steps of a shell, those of a model without loads and anchors."""
    making = _making(document, workshop, facts, {part.name for part in parts})
    return (*making, *_putting_up(document, facts))


def _making(
    document: Document, workshop: Workshop, facts: KitFacts, parts: set[str]
) -> Iterator[Step]:
    said = {"pieces": plain(len(facts.pieces))}
    if facts.diagonals:
        said["diagonals"] = "; ".join(
            " / ".join(size(each, document.unit, digits=DIGITS) for each in pair)
            for pair in facts.diagonals
        )
    check = f"diagonals_{facts.construction or 'sheet'}" if facts.diagonals else ""
    split = bool(parts & {"sheet_parts", "membrane_parts"})
    joined = ("strips" if "strip" in parts else "tabs",)
    if not facts.construction:
        scored = workshop.creases == "score"
        name = "crease" if scored else "crease_cut"
        printed = () if scored or not facts.model else ("printed",)
        first = Step(name, said, FLAT, plan=True, more=printed)
        yield replace(first, check="all_parts" if split else check)
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
        said["apart"] = _between(*facts.apart, unit)
        standing = "apart_shut" if facts.shuts else "apart"
    elif facts.ties and facts.ties_early and not facts.shuts:
        standing = "taut"  # they are fixed before
    tie = [] if not facts.ties else [_tie(document, facts)]
    mark = [] if document.ground is None else [_mark_out(document, document.ground)]
    moving = {part.kind for part in document.attached if document.moves(part)}
    yield from _fitted(document, moving, middle_state(document, FLAT))
    if facts.starts_packed:
        yield Step("fold_pack" if piece is None else "fold_pieces", said, "pack", piece)
        if facts.ties_early:
            yield from tie
        loaded = bool(facts.packs) and not facts.model
        if loaded:
            yield from _carrying(facts, piece, unit)
        yield from mark
        half = middle_state(document, "pack")
        if piece is None:
            name = "open" if loaded else "open_bare"
            yield Step(name, said, half, check=standing, more=several)
        else:
            name = "open_pieces" if loaded else "open_pieces_bare"
            yield Step(name, said, half, piece, check="open_piece", more=several)
            yield Step("join", said, SHELL, check=standing)
    else:
        yield from mark
        yield Step("fold", said, middle_state(document, FLAT), check=standing, more=several)
    if not facts.ties_early:
        yield from tie
    others = {part.kind for part in document.attached} - moving
    yield from _fitted(document, others - LAST, SHELL)
    if facts.feet and not facts.model:
        check = "apart" if facts.apart is not None else ""
        values = {**said, "feet": plain(facts.feet)}
        yield Step("anchor", values, SHELL, marked=facts.footing, check=check)
    for step in _fitted(document, others & LAST, SHELL):
        said = {**step.values, "strings": plain(len(facts.strings))}
        name = f"{step.name}{'' if facts.strings else '_model'}"
        high = ("high",) if _off_the_ground(document) else ()
        yield replace(step, name=name, values=said, more=(*high, *step.more))


def _fitted(document: Document, kinds: set[str], state: int | str) -> Iterator[Step]:
    """Steps that fit parts of some kinds, in the order in which they come."""
    for kind in dict.fromkeys(part.kind for part in document.attached):
        if kind not in kinds:
            continue
        mine = [part for part in document.attached if part.kind == kind]
        panels = sum(len(part.mesh.faces) for part in mine)
        values = {f"{kind}s": plain(len(mine)), "panels": plain(panels)}
        drilled = [len(part.holes) for part in mine if part.holes is not None]
        values["brackets"] = plain(sum(drilled))
        name, check = CLIPPED.get(kind, (f"{'bolt' if drilled else 'fit'}_{kind}", ""))
        yield Step(name, values, state, check=check, more=("placed",) * (kind in PLACED))


PLACED = ("flap", "gusset", "plate", "end_wall")
"""Kinds of parts whose way to their place nobody has looked at."""
LAST = {"end_wall"}
"""Kinds of parts that are put up beside a shell that is anchored."""
CLIPPED = {"flap": ("clip", "all_shut")}
"""Step and check of parts that are clipped on; of others the step is that to fit them."""


def _off_the_ground(document: Document) -> bool:
    """Whether strips of end walls stand on others, or are over a door."""
    walls = [part.shell.positions[:, 2] for part in document.attached if part.kind in LAST]
    low = [float(each.min()) for each in walls]
    return max(low) - min(low) > HIGH * max(float(np.ptp(each)) for each in walls)


HIGH = 1e-6
"""What is higher than this share of a wall is not on the ground."""


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


def _tie(document: Document, facts: KitFacts) -> Step:
    values = {
        "ties": plain(len(facts.ties)),
        "length": _between(min(facts.ties), max(facts.ties), document.unit),
    }
    name = "tie" if facts.ties_early else "tie_open"
    return Step(name, values, SHELL, joined=facts.tied, check="tie")


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
    yield words.say("cover.sheet", size=box(facts.sheet, unit))
    if facts.mass is not None:
        yield words.say("cover.mass", mass=f"{plain(facts.mass, 3)} kg")


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

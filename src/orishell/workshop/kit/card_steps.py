"""The steps in which a model of card is cut, creased and folded: each has a picture."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from orishell.conventions.quantities import box, plain
from orishell.document import FLAT, SHELL, Document
from orishell.workshop.kit.facts import KitFacts
from orishell.workshop.kit.folding import hand_folding, measured, state_between
from orishell.workshop.kit.step import (
    LAST,
    Step,
    closing_steps,
    diagonals_of,
    fitted_steps,
    tie_step,
)
from orishell.workshop.settings import Workshop


def card_steps(
    document: Document, workshop: Workshop, facts: KitFacts, parts: set[str]
) -> Iterator[Step]:
    """The steps of a model, from the printed page to the shell as it stands."""
    hands, split = hand_folding(document), "sheet_parts" in parts
    said = {"pieces": plain(len(facts.pieces)), **diagonals_of(facts, document.unit)}
    check = "diagonals_sheet" if facts.diagonals else ""
    cut = Step("cut_card", said, FLAT, plan=True, check="all_parts" if split else check)
    if workshop.creases == "score":
        holes = ("holes",) if workshop.relief_hole else ()
        yield replace(cut, more=holes)
        yield Step("score_card", said, FLAT, plan=True, thick=hands.every)
    else:
        yield replace(cut, name="crease_cut_card", thick=hands.every)
    if split:
        yield Step("join_parts", said, FLAT, plan=True, check=check, more=("tabs",))
    for number, lines in enumerate(hands.sets):
        name = "crease_first" if number == 0 else "crease_others"
        counts = {
            "mountains": plain(len(lines.mountains)),
            "valleys": plain(len(lines.valleys)),
        }
        yield Step(name, counts, FLAT, plan=True, thick=lines)
    yield from _folding(document, facts)


def _folding(document: Document, facts: KitFacts) -> Iterator[Step]:
    """From the creased sheet to the shell: how it is collapsed, and what it looks like."""
    hands, unit = hand_folding(document), document.unit
    several: tuple[str, ...] = ()
    said = {"opened": box(facts.opened, unit)}
    if facts.freedoms is not None:
        several, said["freedoms"] = (f"several_{facts.freedoms[0]}",), facts.freedoms[1]
    push = "push_sides" if hands.sideways else "push_ends"
    first, *others = hands.states
    sized = {**said, "size": measured(document, first)}
    yield Step("collapse", sized, first, more=(push, *several))
    for state in others:
        yield Step("collapse_on", {"size": measured(document, state)}, state)
    moving = {part.kind for part in document.attached if document.moves(part)}
    yield from fitted_steps(document, moving, state_between(document, FLAT, 0.5))
    yield Step("collapsed", said, SHELL, check="shut" if facts.shuts else "")
    tie = [] if not facts.ties else [tie_step(document, facts)]
    if facts.starts_packed:
        yield Step("pack_card", said, "pack")
        if facts.ties_early:
            yield from tie
        yield Step("open_card", said, state_between(document, "pack", 0.5))
    if not (facts.starts_packed and facts.ties_early):
        yield from tie
    others_there = {part.kind for part in document.attached} - moving
    yield from fitted_steps(document, others_there - LAST, SHELL)
    yield from closing_steps(document, facts, others_there & LAST)

"""A step of the booklet, and those that shells and models of card have in common."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

import numpy as np

from orishell.conventions.quantities import plain, size
from orishell.conventions.record import record
from orishell.document import SHELL, Document
from orishell.numerics.arrays import Booleans, Integers
from orishell.workshop.kit.facts import KitFacts
from orishell.workshop.kit.folding import CreaseLines


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
    thick: CreaseLines | None = None  # creases that are drawn over all
    check: str = ""  # the key of the words that say what is checked; empty where nothing is
    more: tuple[str, ...] = ()  # keys of words that follow those of the step


def fitted_steps(document: Document, kinds: set[str], state: int | str) -> Iterator[Step]:
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


def closing_steps(document: Document, facts: KitFacts, kinds: set[str]) -> Iterator[Step]:
    """Steps that put up parts beside a shell that is anchored."""
    for step in fitted_steps(document, kinds, SHELL):
        said = {**step.values, "strings": plain(len(facts.strings))}
        name = f"{step.name}{'' if facts.strings else '_model'}"
        high = ("high",) if _off_the_ground(document) else ()
        yield replace(step, name=name, values=said, more=(*high, *step.more))


def _off_the_ground(document: Document) -> bool:
    """Whether strips of end walls stand on others, or are over a door."""
    walls = [part.shell.positions[:, 2] for part in document.attached if part.kind in LAST]
    low = [float(each.min()) for each in walls]
    return max(low) - min(low) > HIGH * max(float(np.ptp(each)) for each in walls)


HIGH = 1e-6
"""What is higher than this share of a wall is not on the ground."""


def tie_step(document: Document, facts: KitFacts) -> Step:
    """The step in which ties, or threads of a model, are fixed."""
    values = {
        "ties": plain(len(facts.ties)),
        "length": between(min(facts.ties), max(facts.ties), document.unit),
    }
    name = "tie" if facts.ties_early else "tie_open"
    name = f"{name}_card" if facts.model else name
    return Step(name, values, SHELL, joined=facts.tied, check="thread" if facts.model else "tie")


DIGITS = 4
"""Of what is measured with a tape: millimetres of metres."""


def between(low: float, high: float, unit: str) -> str:
    """A length, or the least and the largest."""
    least, most = (size(each, unit, digits=DIGITS) for each in (low, high))
    return least if least == most else f"{least} - {most}"


def diagonals_of(facts: KitFacts, unit: str) -> dict[str, str]:
    """What is said of the diagonals of pieces as they lie flat; nothing where there are none."""
    if not facts.diagonals:
        return {}
    pairs = (
        " / ".join(size(each, unit, digits=DIGITS) for each in pair) for pair in facts.diagonals
    )
    return {"diagonals": "; ".join(pairs)}

"""Whether a case carries its loads, and what speaks against it: the words of all pages.

A case carries if the shell is in equilibrium, stays within its strengths, is far from buckling,
and is not displaced so far that it is another shell. It fails if one of that is known not to be so.
Otherwise nobody knows: then sign, field, words and exit status say that and no more.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Literal

import numpy as np

from orishell.conventions.quantities import Quantities, plain
from orishell.conventions.record import record
from orishell.conventions.row import ORDER, Sign
from orishell.numerics.equals import SOLVED, classes
from orishell.structure.crease_forces import AtCrease
from orishell.structure.equilibrium import COLLAPSED, Equilibrium
from orishell.structure.free_motion import FreeMotion
from orishell.structure.load_path import UNFOLLOWED
from orishell.structure.plate_edges import JudgedEdges
from orishell.structure.utilisation import Limiting, named

Kind = Literal[
    "moves",
    "slips",
    "lifts off",
    "gives way",
    "exceeds strength",
    "buckles",
    "displaced",
    "unknown",
]
"""How a case fails, or may."""
CARRIES: Mapping[Sign, bool | None] = {"fails": False, "warns": None, "holds": True}
"""Whether a shell carries its loads, by the sign of what was found; None if that is not known."""
LARGE_DISPLACEMENT = 0.05
"""Displacements above this share of the shell's height are too large for linear theory: the thrust
of an arch is a moment of its loads over its height, so it is wrong by about as much."""
LEAST_BUCKLING = 3.0
"""Below this factor a shell may well buckle: imperfect ones do before linear theory says so. It is
not known to carry its loads then, unless large displacements are followed (EN 1993-1-1, 5.2.2)."""


@record
class Finding:
    """What speaks against a case, or is in doubt."""

    sign: Sign  # whether it fails, or wants attention
    kind: Kind  # how
    text: str  # by how much: what follows on "the shell"
    # how many times too much it is, for what is known; None where nothing resists, or no measure is
    excess: float | None


def against_motion(motion: FreeMotion) -> Iterator[Finding]:
    """What speaks against a shell that nothing holds, or next to nothing."""
    by_ground: dict[str | None, Kind] = {
        "slips": "slips",
        "lifts": "lifts off",
        "unknown": "unknown",
        None: "moves",
    }
    kind = "gives way" if motion.soft else by_ground[motion.ground]
    yield Finding("fails", kind, motion.in_words(), None)


def against_equilibrium(
    found: Equilibrium, *, strength: bool = True, limited: bool = True
) -> Iterator[Finding]:
    """What speaks against a shell in equilibrium.

    strength: Whether strength and buckling are judged.
    limited: Whether it may not be displaced further than is asked.
    """
    if strength:
        yield from _against_strength(found)
    if limited:
        yield from _against_limit(found)
    path = found.path
    if path is not None and not path.carries:
        excess = 1 / path.reached if path.reached else None
        lost = path.ending == "lost"
        kind: Kind = "unknown" if lost else "buckles"
        yield Finding("warns" if lost else "fails", kind, path.in_words(), excess)
    unit, most = found.model.site.unit, found.displacement
    if most.share > LARGE_DISPLACEMENT:
        row, column = most.panel
        sign: Sign = "fails" if most.share > COLLAPSED else "warns"
        text = (
            f"is displaced by {plain(most.size, 2)} {unit} ({plain(100 * most.share, 2)} % of its "
            f"height) near panel {row}, {column}"
        )
        if sign == "warns" and path is None:
            text += ", too far for linear theory"
        if sign == "fails" or path is None:
            most_share = COLLAPSED if sign == "fails" else LARGE_DISPLACEMENT
            yield Finding(sign, "displaced", text, most.share / most_share)


def against_wind_on_walls(blows: bool) -> Iterator[Finding]:
    """That wind on end walls is not known to be borne, where it ``blows`` on some."""
    if blows:
        text = (
            "is loaded by wind on its end walls, too, through their strings, which is not counted"
        )
        yield Finding("warns", "unknown", text, None)


def _against_limit(found: Equilibrium) -> Iterator[Finding]:
    """What speaks against a shell that is displaced further than it may be."""
    limit, moved = found.model.displacement_limit, found.crept
    if limit is None or moved <= limit:
        return
    said = Quantities(found.model.site.unit)
    crept = " once it has crept" if moved > found.displacement.size else ""
    most = said.displacement(limit)
    text = f"is displaced by {said.displacement(moved)}{crept}, and may be by {most}"
    yield Finding("fails", "displaced", text, moved / limit)


def _against_strength(found: Equilibrium) -> Iterator[Finding]:
    used = found.utilisation
    for name, part in used.shares.items():
        if name != "buckling" and part is not None and part > 1:
            of = f"strength of its {named(name, skin=found.model.has_skin)}"
            place = {"lines": found.used_line, "panels": found.worst_crease}.get(name)
            at = "" if place is None else f" at the crease between {_beside(place)}"
            edges = _edges(found).get(name)
            if edges is not None and edges.used is not None:
                at = f", {edges.used.in_words()}"
            if name == "boxes" and found.boxes is not None:
                at = f" in {found.boxes.part}"
            text = f"uses {plain(100 * part, 3)} % of the {of}{at}"
            yield Finding("fails", "exceeds strength", text, part)
    factor = found.buckling
    if found.path is None and factor is not None and factor < LEAST_BUCKLING:
        text = f"buckles under {plain(factor, 3)} times its loads"
        if factor >= 1:
            text += f" by linear theory ({LEAST_BUCKLING:g} is asked for)"
            if found.unfollowed is not None:
                text += f"; {UNFOLLOWED[found.unfollowed]}"
        excess = (1 if factor < 1 else LEAST_BUCKLING) / factor
        yield Finding("fails" if factor < 1 else "warns", "buckles", text, excess)
    yield from _not_known(found)


def _not_known(found: Equilibrium) -> Iterator[Finding]:
    """What is loaded, and it is not known whether it bears that."""
    model = found.model
    said = Quantities(model.site.unit)
    unknown = found.unknown
    if unknown:
        names = [named(part, skin=model.has_skin) for part in unknown]
        text = f"is loaded in {' and '.join(names)}, whose strength is not given"
        places = [
            f"{said.per_length(each.unknown.size)} {each.unknown.in_words()}"
            for name, each in _edges(found).items()
            if name in unknown and each is not None
        ]
        if "lines" in unknown:
            line = found.unknown_line
            places.insert(0, f"{said.per_length(line.size)} between {_beside(line)}")
        text += f" ({'; '.join(places)})" if places else ""
        yield Finding("warns", "unknown", text, None)
    beside, strength = found.beside, found.strength
    if model.bevelled and beside is not None and strength and beside.size > strength:
        text = (
            f"may bear {said.stress(beside.size)} in its panels at the crease between "
            f"{_beside(beside)}, {plain(100 * beside.size / strength, 3)} % of their strength, if "
            "hinges hold them at the face that chamfers leave: on average over patches there are "
            f"{said.stress(found.stress.size)} at most"
        )
        yield Finding("warns", "unknown", text, beside.size / strength)


def _edges(found: Equilibrium) -> dict[Limiting, JudgedEdges | None]:
    """Forces along edges of what stiffens the sheet, by what bears them."""
    return {"box_lines": found.box_lines, "plate_edges": found.plate_edges}


def _beside(found: AtCrease) -> str:
    """The two panels beside a crease."""
    (row, column), (other, last) = found.panels
    return f"panels {row}, {column} and {other}, {last}"


def misleads(found: Equilibrium) -> bool:
    """Whether linear theory, by which it was found, may mislead."""
    soft = found.buckling is not None and found.buckling < LEAST_BUCKLING
    return found.path is None and (soft or found.displacement.share > LARGE_DISPLACEMENT)


def ranked(findings: Iterator[Finding]) -> tuple[Finding, ...]:
    """Findings, the worst first."""
    found = list(findings)
    beyond = classes([-(each.excess or 0) for each in found], SOLVED)
    order = np.lexsort((beyond, np.array([ORDER.index(each.sign) for each in found])))
    return tuple(found[k] for k in order.tolist())

"""The parts of a shell, each kind with how many there are, a note and a small picture."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from itertools import compress

import numpy as np

from orishell.conventions.quantities import area, box, plain, size
from orishell.conventions.record import record
from orishell.design.fittings import Fittings
from orishell.document import Document
from orishell.motion.boards import Boards
from orishell.motion.quads import signed_areas
from orishell.numerics.arrays import Array
from orishell.numerics.equals import first_largest, largest_of
from orishell.workshop.assembly import laid_flat
from orishell.workshop.board_stock import BoardStock, stock_of_part, stocks_of_boards
from orishell.workshop.boards import (
    SIDES,
    cut_of_sheet,
    distinct_corners,
    has_sheet,
    seen_from_outside,
)
from orishell.workshop.cut_parts import whole_sheet
from orishell.workshop.hinge_parts import fittings_of
from orishell.workshop.kit.facts import KitFacts
from orishell.workshop.layout import lay_out
from orishell.workshop.settings import Workshop

LAYERS = {1: "top", -1: "bottom", 0: "solid"}


@record
class KitPart:
    """A kind of parts."""

    name: str  # its key in the words of the booklet
    count: int
    values: Mapping[str, str]  # what its note says
    picture: tuple[Array, ...] = ()  # polylines (k, 2), closed where first and last coincide
    note: str = ""  # the key of its note; its own name with "_note" where empty


def kit_parts(document: Document, workshop: Workshop, facts: KitFacts) -> tuple[KitPart, ...]:
    """All kinds of parts, in the order in which they are used; counts are those of the drawings."""
    unit = document.unit
    parts: list[KitPart] = []
    cut = CutCounts.of(document, workshop)
    if facts.construction in ("", "sandwich"):
        name, count = "membrane" if facts.construction else "sheet", cut.sheet
        note = "membrane_plain_note" if name == "membrane" and not facts.attached else ""
        if cut.sheet > facts.strips:
            name, note = f"{name}_parts", "strip_parts_note" if facts.strips > 1 else ""
        elif facts.strips > 1:
            name, count, note = f"{name}_strips", facts.strips, "strips_note"
        values = {
            "last": str(cut.sheet),
            "size": box(facts.sheet, unit),
            "strips": str(facts.strips),
            "area": area(float(document.areas().sum()), unit),
            "panels": str(len(document.mesh.faces)),
        }
        rims = tuple(map(_closed, whole_sheet(document).outlines))
        parts.append(KitPart(name, count, values, rims, note))
    if cut.strips:
        parts.append(KitPart("strip", cut.strips, {}, (_rectangle(-1.0, -0.2, 1.0, 0.2),)))
    if facts.construction:
        parts += _boards(document)
    fittings = fittings_of(document)
    if fittings is not None:
        parts += _hinges(fittings, unit)
    if facts.ties:
        low, high = (size(each, unit) for each in (min(facts.ties), max(facts.ties)))
        values = {"length": low if low == high else f"{low} - {high}"}
        line = np.array([[0.0, 0.0], [1.0, 0.0]])
        parts.append(
            KitPart(
                "thread" if facts.model else "tie",
                len(facts.ties),
                values,
                (line, *map(_ring, line)),
            )
        )
    parts += _beside(document, cut)
    if facts.strings:
        low, high = (size(each, unit) for each in (min(facts.strings), max(facts.strings)))
        values = {"length": low if low == high else f"{low} - {high}"}
        parts.append(KitPart("string", len(facts.strings), values, (_ring(np.zeros(2)),)))
    holes = laid_flat(document).holes
    if holes is not None:
        hole = size(float(holes.diameters.max()), unit)
        values = {"hole": hole, "bolts": str(2 * len(holes))}
        bent = np.array([[0.0, 1.0], [0.0, 0.0], [1.0, 0.0]])
        parts.append(KitPart("bracket", len(holes), values, (bent,)))
    return tuple(parts)


def _beside(document: Document, cut: CutCounts) -> Iterator[KitPart]:
    """Parts that go with the sheet by their kind, in the order of their numbers."""
    last = cut.sheet
    for kind in dict.fromkeys(part.kind for part in document.attached):
        own = [part.kind == kind for part in document.attached]
        mine = list(compress(document.attached, own))
        first, last = last, last + sum(compress(cut.beside, own))
        values = {
            "panels": str(sum(len(part.mesh.faces) for part in mine)),
            "cut": str(last - first),
            "first": str(first + 1),
            "last": str(last),
        }
        quads = mine[0].require_flat()[mine[0].mesh.faces]
        how = ("_plain" if document.boards is None else "") + ("_cut" if last > first else "")
        stock = stock_of_part(document, mine[0])
        if stock is not None:
            how = "_own_of" if stock.material else "_own"
            values |= _said_of(stock, document) | {"material": stock.material}
        note = f"{kind}{how}_note"
        yield KitPart(kind, len(mine), values, tuple(map(_closed, quads)), note)


@record
class CutCounts:
    """How many parts the sheet, or the membrane, is cut in."""

    sheet: int  # of the sheet itself; 1 where it is not split, 0 where there is none
    # of every part that goes with it, numbered after those; 0 where parts have no numbers
    beside: tuple[int, ...]
    strips: int  # glued under joints

    @classmethod
    def of(cls, document: Document, workshop: Workshop) -> CutCounts:
        """Those of the layout that drawings have."""
        if not has_sheet(document):
            return cls(0, tuple(0 for _ in document.attached), 0)
        parts = lay_out(document, workshop).parts
        drawn = cut_of_sheet(document)
        ends = np.cumsum([len(part.mesh.faces) for part in drawn.parts])
        # Panels of a part are of the sheet, or of one that goes with it.
        of = [
            int(np.searchsorted(ends, part.panels.min(initial=ends[-1]), "right")) for part in parts
        ]
        numbered = [of for of, part in zip(of, parts, strict=True) if part.number]
        counts = iter([numbered.count(1 + k) for k in range(len(drawn.attached))])
        beside = tuple(next(counts) if has_sheet(part) else 0 for part in document.attached)
        return cls(of.count(0), beside, of.count(len(ends)))


def _boards(document: Document) -> Iterator[KitPart]:
    """Boards of the sheet's stock by the face that they are on, those clipped on included."""
    everything, (stock, *_) = laid_flat(document), stocks_of_boards(document)
    boards = everything.boards
    assert isinstance(boards, Boards)
    for side in SIDES:
        seen = seen_from_outside(everything, side)
        there = np.isin(seen.numbers, stock.boards)
        if not there.any():
            continue
        areas, numbers = boards.areas(), seen.numbers[there]
        largest = distinct_corners(seen.outlines[there][first_largest(areas[numbers])])
        values = _said_of(replace(stock, boards=numbers), document)
        yield KitPart(LAYERS[side], len(numbers), values, (_closed(largest),))


def _said_of(stock: BoardStock, document: Document) -> dict[str, str]:
    """How thick boards are, and their area."""
    boards = laid_flat(document).boards
    assert boards is not None
    covered = float(boards.areas()[stock.boards].sum())
    return {"thick": size(stock.thickness, document.unit), "area": area(covered, document.unit)}


def _hinges(fittings: Fittings, unit: str) -> Iterator[KitPart]:
    """Hinges of whole boards, their screws and arms."""
    lengths = fittings.lengths
    longest = first_largest(lengths)
    half, leaf = 0.5 * float(lengths[longest]), float(fittings.leaves[longest])
    low, high = (size(each, unit) for each in (float(lengths.min()), float(lengths.max())))
    values = {"total": size(float(lengths.sum()), unit), "least": low, "most": high}
    leaves = tuple(_rectangle(-half, y, half, y + leaf) for y in (-leaf, 0.0))
    yield KitPart("hinge", len(lengths), values, leaves)
    if fittings.screws:
        values = {"hole": size(fittings.hole, unit)}
        yield KitPart("screw", fittings.screws, values, (_ring(np.zeros(2)),))
    if fittings.arms:
        arm = largest_of(fittings.arms, lambda each: each.area)
        values = {"kinds": str(len(fittings.arms))}
        half = 0.5 * arm.length
        outline = _rectangle(-half, -arm.foot, half, arm.height)
        bend = np.array([[-half, 0.0], [half, 0.0]])
        picture = (outline, bend) if arm.foot else (outline,)
        name = "arm" if any(each.foot for each in fittings.arms) else "block"
        yield KitPart(name, sum(each.count for each in fittings.arms), values, picture)


def _closed(outline: Array) -> Array:
    return np.concatenate([outline, outline[:1]])


def _rectangle(left: float, bottom: float, right: float, top: float) -> Array:
    return _closed(np.array([[left, bottom], [right, bottom], [right, top], [left, top]]))


def _ring(middle: Array) -> Array:
    """A small circle about a point (2,)."""
    turn = np.linspace(0, 2 * np.pi, 17)
    return np.asarray(middle + 0.04 * np.stack([np.cos(turn), np.sin(turn)], axis=-1))


def kit_tools(
    document: Document, facts: KitFacts, parts: tuple[KitPart, ...]
) -> Iterator[tuple[str, Mapping[str, str]]]:
    """What the work asks for: keys of the words of the booklet, with what they say."""
    there = {part.name: part for part in parts}
    if facts.construction in ("", "sandwich"):
        yield "knife", {}
    if facts.construction:
        sawn = [part.values for part in parts if "thick" in part.values]
        yield from (("saw", each) for each in {each["thick"]: each for each in sawn}.values())
    if facts.construction == "sandwich":
        glued = signed_areas(_faces(document)).sum()
        yield "glue", {"area": area(float(glued), document.unit)}
    if facts.construction == "bevel":
        folds = np.isin(document.assignment, ("M", "V"))
        length = float(document.edge_lengths()[folds].sum())
        yield "strip", {"length": size(length, document.unit)}
    for name, tool in (("screw", "screwdriver"), ("bracket", "wrench")):
        if name in there:
            yield "drill", there[name].values
            yield tool, {}
    if "arm" in there:
        yield "vice", {}
    if facts.ties:
        yield ("thread" if facts.model else "cable"), {"length": _all(facts, document.unit)}
    if facts.anchored and not facts.model:
        yield "anchors", {"count": plain(facts.feet)}
    crossed = () if document.ground is None else document.ground.crossed
    measured = (
        *(*facts.sheet, *facts.opened, *facts.ties, *(facts.apart or ())),
        *(each for pair in facts.diagonals for each in pair),
        *(one.apart(other) for one, other in crossed),
    )
    yield (
        "ruler" if facts.model else "tape",
        {"length": size(max(measured), document.unit, bound=True)},
    )


def _faces(document: Document) -> Array:
    """Outlines (B, K, 2) of all boards that are glued on, on the face that is."""
    boards = laid_flat(document).boards
    assert boards is not None
    return np.asarray(boards.outlines[boards.sides != 0, 0, :, :2])


def _all(facts: KitFacts, unit: str) -> str:
    return size(sum(facts.ties), unit)

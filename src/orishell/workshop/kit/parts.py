"""The parts of a shell, each kind with how many there are, a note and a small picture."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

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
from orishell.workshop.boards import SIDES, distinct_corners, has_sheet, seen_from_outside
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
    everything, unit = laid_flat(document), document.unit
    parts: list[KitPart] = []
    cut = CutCounts.of(document, workshop)
    if facts.construction in ("", "sandwich"):
        name = ("membrane" if facts.construction else "sheet") + (
            "" if cut.sheet == 1 else "_parts"
        )
        values = {
            "last": str(cut.sheet),
            "size": box(facts.sheet, unit),
            "area": area(float(document.areas().sum()), unit),
            "panels": str(len(document.mesh.faces)),
        }
        rims = tuple(map(_closed, whole_sheet(document).outlines))
        note = "membrane_plain_note" if name == "membrane" and not facts.flaps else ""
        parts.append(KitPart(name, cut.sheet, values, rims, note))
    if cut.strips:
        parts.append(KitPart("strip", cut.strips, {}, (_rectangle(-1.0, -0.2, 1.0, 0.2),)))
    if facts.construction:
        parts += _boards(everything)
    fittings = fittings_of(document)
    if fittings is not None:
        parts += _hinges(fittings, unit)
    if facts.ties:
        low, high = (size(each, unit) for each in (min(facts.ties), max(facts.ties)))
        values = {"length": low if low == high else f"{low} - {high}"}
        line = np.array([[0.0, 0.0], [1.0, 0.0]])
        parts.append(KitPart("tie", len(facts.ties), values, (line, *map(_ring, line))))
    if facts.flaps:
        flap = document.attached[0]
        quads = flap.require_flat()[flap.mesh.faces]
        values = {"panels": str(facts.flap_panels), "cut": str(cut.flaps)}
        values |= {"first": str(cut.sheet + 1), "last": str(cut.sheet + cut.flaps)}
        note = f"flap{'' if facts.construction else '_plain'}{'_cut' if cut.flaps else ''}_note"
        parts.append(KitPart("flap", facts.flaps, values, tuple(map(_closed, quads)), note))
    return tuple(parts)


@record
class CutCounts:
    """How many parts the sheet, or the membrane, is cut in."""

    sheet: int  # of the sheet itself; 1 where it is not split, 0 where there is none
    flaps: int  # of what is clipped on, numbered after those; 0 where parts have no numbers
    strips: int  # glued under joints

    @classmethod
    def of(cls, document: Document, workshop: Workshop) -> CutCounts:
        """Those of the layout that drawings have."""
        if not has_sheet(document):
            return cls(0, 0, 0)
        count, parts = len(document.mesh.faces), lay_out(document, workshop).parts
        sheet = sum(bool((part.panels < count).any()) for part in parts)
        flaps = sum(part.number > 0 and bool((part.panels >= count).all()) for part in parts)
        return cls(sheet, flaps, sum(not len(part.panels) for part in parts))


def _boards(everything: Document) -> Iterator[KitPart]:
    """Boards by the face that they are on, those that are clipped on included."""
    boards, build, unit = everything.boards, everything.panel, everything.unit
    assert isinstance(boards, Boards)
    assert build is not None
    sandwich = build.construction == "sandwich"
    thick = 0.5 * (build.thickness - build.membrane) if sandwich else build.thickness
    for side in SIDES:
        seen = seen_from_outside(everything, side)
        if not len(seen.numbers):
            continue
        areas = boards.areas()[seen.numbers]
        largest = distinct_corners(seen.outlines[first_largest(areas)])
        values = {"thick": size(thick, unit), "area": area(float(areas.sum()), unit)}
        yield KitPart(LAYERS[side], len(seen.numbers), values, (_closed(largest),))


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
        yield "saw", next(there[side].values for side in LAYERS.values() if side in there)
    if facts.construction == "sandwich":
        glued = signed_areas(_faces(document)).sum()
        yield "glue", {"area": area(float(glued), document.unit)}
    if facts.construction == "bevel":
        folds = np.isin(document.assignment, ("M", "V"))
        length = float(document.edge_lengths()[folds].sum())
        yield "strip", {"length": size(length, document.unit)}
    if "screw" in there:
        yield "drill", there["screw"].values
        yield "screwdriver", {}
    if "arm" in there:
        yield "vice", {}
    if facts.ties:
        yield ("thread" if facts.model else "cable"), {"length": _all(facts, document.unit)}
    if facts.feet and not facts.model:
        yield "anchors", {"count": plain(facts.feet)}
    crossed = () if document.ground is None else document.ground.crossed
    measured = (
        *(*facts.sheet, *facts.opened, *facts.ties, *(facts.apart or ())),
        *(each for pair in facts.diagonals for each in pair),
        *(one.apart(other) for one, other in crossed),
    )
    yield "tape", {"length": size(max(measured), document.unit, bound=True)}


def _faces(document: Document) -> Array:
    """Outlines (B, K, 2) of all boards on the face that is glued."""
    boards = laid_flat(document).boards
    assert boards is not None
    return np.asarray(boards.outlines[:, 0, :, :2])


def _all(facts: KitFacts, unit: str) -> str:
    return size(sum(facts.ties), unit)

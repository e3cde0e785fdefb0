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
from orishell.workshop.assembly import with_clipped
from orishell.workshop.boards import SIDES, distinct_corners, seen_from_outside
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


def kit_parts(document: Document, workshop: Workshop, facts: KitFacts) -> tuple[KitPart, ...]:
    """All kinds of parts, in the order in which they are used; counts are those of the drawings."""
    everything, unit = with_clipped(document), document.unit
    parts: list[KitPart] = []
    if facts.construction in ("", "sandwich"):
        cut = sheet_parts(document, workshop)
        name = ("membrane" if facts.construction else "sheet") + ("" if cut == 1 else "_parts")
        values = {
            "size": box(facts.sheet, unit),
            "area": area(float(document.areas().sum()), unit),
            "panels": str(len(document.mesh.faces)),
        }
        rims = tuple(map(_closed, whole_sheet(document).outlines))
        parts.append(KitPart(name, cut, values, rims))
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
        flap = document.clipped[0]
        quads = flap.require_flat()[flap.mesh.faces]
        values = {"panels": str(facts.clipped_panels)}
        parts.append(KitPart("flap", facts.flaps, values, tuple(map(_closed, quads))))
    return tuple(parts)


def sheet_parts(document: Document, workshop: Workshop) -> int:
    """How many parts the sheet or the membrane is cut in, what is clipped on left out."""
    count = len(document.mesh.faces)
    return sum(bool((part.panels < count).any()) for part in lay_out(document, workshop).parts)


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
        largest = distinct_corners(seen.outlines[int(areas.argmax())])
        values = {"thick": size(thick, unit), "area": area(float(areas.sum()), unit)}
        yield KitPart(LAYERS[side], len(seen.numbers), values, (_closed(largest),))


def _hinges(fittings: Fittings, unit: str) -> Iterator[KitPart]:
    """Hinges of whole boards, their screws and arms."""
    lengths = fittings.lengths
    longest = int(lengths.argmax())
    half, leaf = 0.5 * float(lengths[longest]), float(fittings.leaves[longest])
    low, high = (size(each, unit) for each in (float(lengths.min()), float(lengths.max())))
    values = {"total": size(float(lengths.sum()), unit), "least": low, "most": high}
    leaves = tuple(_rectangle(-half, y, half, y + leaf) for y in (-leaf, 0.0))
    yield KitPart("hinge", len(lengths), values, leaves)
    if fittings.screws:
        values = {"hole": size(fittings.hole, unit)}
        yield KitPart("screw", fittings.screws, values, (_ring(np.zeros(2)),))
    if fittings.arms:
        arm = max(fittings.arms, key=lambda each: each.area)
        values = {"kinds": str(len(fittings.arms))}
        half = 0.5 * arm.length
        outline = _rectangle(-half, -arm.foot, half, arm.height)
        bend = np.array([[-half, 0.0], [half, 0.0]])
        picture = (outline, bend) if arm.foot else (outline,)
        yield KitPart("arm", sum(arm.count for arm in fittings.arms), values, picture)


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
        yield "saw", {}
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
    yield "tape", {"length": size(max(*facts.sheet, *facts.opened), document.unit)}


def _faces(document: Document) -> Array:
    """Outlines (B, K, 2) of all boards on the face that is glued."""
    boards = with_clipped(document).boards
    assert boards is not None
    return np.asarray(boards.outlines[:, 0, :, :2])


def _all(facts: KitFacts, unit: str) -> str:
    return size(sum(facts.ties), unit)

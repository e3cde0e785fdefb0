"""Hinges and arms of whole boards for the workshop: holes in boards, names, and arms to be cut.

Boards are seen from above. Holes of hinges on their top are circles in the layer VALLEY, those of
hinges under them in the layer MOUNTAIN: that is the side to screw from.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from orishell.design.fittings import TRIMMED, ArmKind, Fittings, fit_hinges
from orishell.document import Document, Part
from orishell.motion.hinges import Hinges
from orishell.numerics.arrays import Booleans
from orishell.workshop.boards import LARGEST_ANGLE, LARGEST_NUMBER, seen_from_outside
from orishell.workshop.creases import mean_edge
from orishell.workshop.draw import draw_page
from orishell.workshop.fitted_words import Labels, evened, label_edges, label_middles, ways_across
from orishell.workshop.palettes import Circle, Drawing, Layer, Line, Text
from orishell.workshop.placing import Content, gathered, shifted
from orishell.workshop.settings import Workshop

FACES: dict[int, Layer] = {1: "VALLEY", -1: "MOUNTAIN"}
"""The layer of the holes of a leaf on the top of a board, or under it."""
FREE = 0.5
"""Share of the end of a crease, beside its hinge, that the name of the hinge takes at most."""
BESIDE = 1.5
"""Heights of a name that part numbers keep off the leaf beside it."""


def fittings_of(document: Part) -> Fittings | None:
    """The hinges and arms of a document as parts; None where it has no whole boards on hinges."""
    hinges, build = document.hinges, document.panel
    if not isinstance(hinges, Hinges) or build is None:
        return None
    return fit_hinges(document.require_flat()[document.mesh.faces], hinges, build)


def hinge_names(fittings: Fittings) -> tuple[str, ...]:
    """What hinges are called (H,): "H" and the number of their crease."""
    return tuple(f"H{edge}" for edge in fittings.edges.tolist())


def hinge_labels(document: Document, fittings: Fittings) -> Labels:
    """Names of hinges on both their boards (2 H,), beside the first ends of their creases.

    Those on the first board of each come first.
    """
    boards = seen_from_outside(document, 0)
    outline = np.zeros((len(document.mesh.faces), *boards.outlines.shape[1:]))
    outline[boards.panels] = boards.outlines
    panels = fittings.panels.T.ravel()
    ends = np.concatenate([fittings.ends, fittings.ends[:, ::-1]])
    size = LARGEST_ANGLE * mean_edge(document)
    # From the end of a hinge half way to that of its crease.
    place = -0.5 * TRIMMED / (1 - 2 * TRIMMED)
    names = 2 * hinge_names(fittings)
    labels = label_edges(names, outline[panels], ends, tall=1.5, most=size, share=place, usual=100)
    room = 2 * FREE * abs(place) * np.tile(fittings.lengths, 2)
    letters = np.array([len(name) for name in names])
    return replace(labels, heights=evened(np.minimum(labels.heights, room / letters), size))


def hinged_marks(document: Document, fittings: Fittings) -> list[Content]:
    """What is on every whole board, in the sheet's own coordinates: holes, names, part number."""
    boards = seen_from_outside(document, 0)
    labels = hinge_labels(document, fittings)
    middles, hinge, panels = fittings.holes()
    circles: list[list[Circle]] = [[] for _ in document.mesh.faces]
    for (x, y), side, panel in zip(
        middles.tolist(), fittings.sides[hinge].tolist(), panels.tolist(), strict=True
    ):
        circles[panel].append(Circle(FACES[side], x, y, 0.5 * fittings.hole))
    beside = fittings.panels.T.ravel()
    taken = np.zeros(len(document.mesh.faces))
    width = np.tile(fittings.away + fittings.leaves, 2) + BESIDE * labels.heights
    np.maximum.at(taken, beside, width)
    texts: list[list[Text]] = [[] for _ in document.mesh.faces]
    numbers = label_middles(
        boards.names,
        boards.outlines,
        ways_across(document.require_flat()[document.mesh.faces[boards.panels]]),
        LARGEST_NUMBER * mean_edge(document),
        [(boards.outlines, taken[boards.panels])],
    )
    for panel, text in zip(boards.panels.tolist(), numbers.of(), strict=True):
        texts[panel].append(text)
    shown: Booleans = labels.heights > 0
    for panel, text in zip(beside[shown].tolist(), labels.of(), strict=True):
        texts[panel].append(text)
    return [((), tuple(circles[p]), tuple(texts[p])) for p in boards.panels.tolist()]


def plan_names(document: Document) -> tuple[Text, ...]:
    """Names of all hinges, each once, for a plan; none where there are no such hinges."""
    fittings = fittings_of(document)
    if fittings is None:
        return ()
    first = np.arange(2 * len(fittings.edges)) < len(fittings.edges)
    return hinge_labels(document, fittings).of(first)


LETTERS = 0.4
"""Height of the name of an arm, as a share of its foot, or of a block, at most."""
WIDE = 1.5
"""How many times wider than high the drawing of arms is, about."""


def draw_arms(document: Document, workshop: Workshop) -> Drawing | None:
    """One arm of each kind, as it is cut, with its name and number; None without arms."""
    fittings, build = fittings_of(document), document.panel
    if fittings is None or build is None or not fittings.arms:
        return None
    content = gathered(_in_rows(fittings.arms, fittings.hole, workshop.spacing or build.thickness))
    count, kinds = sum(arm.count for arm in fittings.arms), len(fittings.arms)
    bent = "Bent square along the line: the foot is below it, the fin above; no allowance for bends"
    facts = (
        f"{count} arms of {kinds} {'kind' if kinds == 1 else 'kinds'}, {build.fin:.4g} "
        f"{document.unit} thick",
        bent if any(arm.foot for arm in fittings.arms) else "Blocks, cut square",
    )
    return draw_page(content, f"{document.title}, arms", document.unit, facts, workshop)


def _in_rows(arms: Sequence[ArmKind], hole: float, apart: float) -> Iterator[Content]:
    """Arms in rows from the top, one beside the other, each over its number and a line."""
    letter = LETTERS * min(arm.foot or arm.height for arm in arms)
    sizes = [(arm.length + apart, arm.height + arm.foot + 2 * letter + apart) for arm in arms]
    width = max(np.sqrt(WIDE * sum(x * y for x, y in sizes)), *(x for x, _ in sizes))
    left = top = deep = 0.0
    for arm, (wide, high) in zip(arms, sizes, strict=True):
        if left + wide > width * (1 + 1e-9) and left:
            left, top, deep = 0.0, top - deep, 0.0
        content = _drawn(arm, hole, letter)
        yield shifted(content, left + 0.5 * arm.length, top - arm.height - arm.foot)
        left, deep = left + wide, max(deep, high)


def _drawn(arm: ArmKind, hole: float, letter: float) -> Content:
    """An arm about the middle of its foot's lower edge."""
    half, bend, top = 0.5 * arm.length, arm.foot, arm.foot + arm.height
    rim = np.array([[-half, 0.0], [half, 0.0], [half, top], [-half, top]])
    line = (Line("ENGRAVE", np.array([[-half, bend], [half, bend]])),) if arm.foot else ()
    rows = [
        at
        for at in (
            None if arm.in_foot is None else bend - arm.in_foot,
            None if arm.in_fin is None else top - arm.in_fin,
        )
        if at is not None
    ]
    holes = (Circle("CUT", x, y, 0.5 * hole) for y in rows for x in arm.along.tolist())
    # The name stands between two holes.
    between = float(arm.along[:2].mean()) if len(arm.along) else 0.0
    step = float(np.diff(arm.along[:2])[0]) - hole if len(arm.along) else arm.length
    name = Text(
        "ENGRAVE", between, 0.5 * (bend or top), min(letter, step / len(arm.name)), arm.name
    )
    count = Text("LABEL", 0.0, -letter, letter, f"{arm.name} x {arm.count}")
    below = Line("LABEL", np.array([[-half, -2 * letter], [half, -2 * letter]]))
    return (below, *line, Line("CUT", rim, closed=True)), tuple(holes), (name, count)

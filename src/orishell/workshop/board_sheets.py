"""Drawings of boards: in their places or nested on stock, and the plan of assembly.

Boards of a sandwich are drawn as they are seen from outside, those of the lower face from below, so
that their part numbers can be read when they are glued on. Solid panels are seen from above.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import lru_cache
from itertools import product

import numpy as np

from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.document import Document
from orishell.motion.boards import ARM, KNUCKLE
from orishell.numerics.arrays import Array, Integers
from orishell.workshop.assembly import laid_flat, short_creases
from orishell.workshop.board_stock import BoardStock, stocks_of_boards
from orishell.workshop.boards import (
    MIRRORED,
    SIDES,
    board_labels,
    distinct_corners,
    hung_on,
    seen_from_outside,
    solid_marks,
)
from orishell.workshop.draw import draw_page, drawn_box, require_drawable
from orishell.workshop.hinge_parts import FACES, draw_arms, fittings_of, hinged_marks, plan_names
from orishell.workshop.hung_lines import said_of_lines
from orishell.workshop.layout import KEPT, Known
from orishell.workshop.nesting import nest_parts
from orishell.workshop.palettes import Circle, Drawing, Line, Text
from orishell.workshop.placing import Content, Placement, draw_stock_sheets, gathered, shifted
from orishell.workshop.seams import seam_names, strip_numbers
from orishell.workshop.settings import Workshop
from orishell.workshop.title_block import quoted_size


@record
class BoardPart:
    """A board as it is cut, seen from outside; solid panels are seen from above."""

    number: int  # its number among the boards of the sheet and of what is clipped on
    name: str  # its part number
    panel: int  # the panel that carries it
    side: int  # as in Boards
    outline: Array  # corners (k, 2) of what is cut, counter-clockwise
    # what is engraved
    lines: tuple[Line, ...]
    texts: tuple[Text, ...]
    circles: tuple[Circle, ...] = ()  # holes of hinges, or of bolts

    def content(self) -> Content:
        """What is drawn, the cut last."""
        return (*self.lines, Line("CUT", self.outline, closed=True)), self.circles, self.texts


def board_parts(document: Document) -> tuple[BoardPart, ...]:
    """All boards, those of what is clipped on too: the upper ones, the lower ones, the solid ones.

    Panels are numbered as in :func:`~orishell.workshop.assembly.laid_flat`.
    """
    document = laid_flat(document)
    fittings = fittings_of(document)
    parts: list[BoardPart] = []
    for side in SIDES:
        seen = seen_from_outside(document, side)
        if not len(seen.numbers):
            continue
        if side:
            hung = hung_on(document, seen, side)
            labels = zip(hung.lines, hung.texts, board_labels(document, side), strict=True)
            marks: list[Content] = [(lines, (), (*texts, name)) for lines, texts, name in labels]
        elif fittings is not None:
            marks = hinged_marks(document, fittings)
        else:
            marks = solid_marks(document)
        each = zip(seen.numbers.tolist(), seen.names, seen.panels.tolist(), strict=True)
        drilled = _drilled(document, side)
        parts += [
            BoardPart(
                *(number, name, panel, side, distinct_corners(outline), lines, texts),
                (*circles, *drilled[panel]),
            )
            for (number, name, panel), outline, (lines, circles, texts) in zip(
                each, seen.outlines, marks, strict=True
            )
        ]
    return tuple(parts)


def _drilled(document: Document, side: int) -> list[list[Circle]]:
    """Holes through boards of a side, by their panels (F,)."""
    circles: list[list[Circle]] = [[] for _ in document.mesh.faces]
    holes = document.holes
    if holes is not None:
        middles = holes.middles * (MIRRORED if side < 0 else 1.0)
        for panel, (x, y), wide in zip(
            holes.panels.tolist(), middles.tolist(), holes.diameters.tolist(), strict=True
        ):
            circles[panel].append(Circle("CUT", x, y, 0.5 * wide))
    return circles


def nest_boards(document: Document, workshop: Workshop) -> tuple[Placement, ...]:
    """Where boards lie on the stock, within its margins; one for each of :func:`board_parts`.

    Sheets of boards of another thickness or material follow those of the sheet's own.
    """
    if document.boards is None:
        return ()
    numbers = _numbers(document)
    everything = laid_flat(document)
    outlines = [
        distinct_corners(outline)
        for side in SIDES
        for outline in seen_from_outside(everything, side).outlines
    ]
    found: dict[int, Placement] = {}
    first = 0
    for stock in stocks_of_boards(document):
        of = np.flatnonzero(np.isin(numbers, stock.boards)).tolist()
        mine = [outlines[k] for k in of]
        placed = _nest(Known.by(mine, mine), *workshop.usable_stock, workshop.spacing)
        found |= {
            k: replace(each, sheet=first + each.sheet) for k, each in zip(of, placed, strict=True)
        }
        first += 1 + max((each.sheet for each in placed), default=-1)
    return tuple(found[k] for k in range(len(numbers)))


def _numbers(document: Document) -> Integers:
    """Numbers (B,) of boards in the order in which they are drawn."""
    everything = laid_flat(document)
    return np.concatenate([seen_from_outside(everything, side).numbers for side in SIDES])


def count_board_sheets(document: Document, workshop: Workshop) -> int | None:
    """How many sheets of stock all boards take; None without stock."""
    if workshop.stock is None:
        return None
    return sum(map(len, sheets_of_stocks(document, nest_boards(document, workshop))))


def sheets_of_stocks(document: Document, placed: Sequence[Placement]) -> tuple[range, ...]:
    """The sheets, numbered from 0, that boards of every stock are cut from.

    placed: Where boards lie, see :func:`nest_boards`.
    """
    numbers = _numbers(document)
    sheets = np.array([each.sheet for each in placed])
    found, begin = [], 0
    for stock in stocks_of_boards(document):
        mine = sheets[np.isin(numbers, stock.boards)]
        found.append(range(begin, 1 + int(mine.max(initial=begin - 1))))
        begin = found[-1].stop
    return tuple(found)


@lru_cache(KEPT)
def _nest(
    boards: Known[list[Array]], width: float, height: float, spacing: float
) -> tuple[Placement, ...]:
    return nest_parts(boards.content, width, height, spacing)


LAYERS = {1: "top", -1: "bottom", 0: "panels", ARM: "arms", KNUCKLE: "hinges"}
"""How the files of the layers end."""
_CALLED = {1: "upper boards", -1: "lower boards", 0: "panels", ARM: "arms", KNUCKLE: "hinges"}


@record
class BoardLayer:
    """The boards of one layer, drawn apart so that no cut is made twice."""

    ending: str  # how its file's name ends: "top", "bottom" or "panels", or "gussets"
    title: str
    content: Content
    facts: tuple[str, ...]  # what the title block says


def draw_boards(document: Document, workshop: Workshop) -> Iterator[tuple[str, Drawing]]:
    """Drawings of all boards and how their files' names end; none without boards.

    Without stock there is one for each layer: "-top" and "-bottom", or "-panels" if they are solid.
    With stock the boards of both layers are nested together: "-boards-1", ..., or "-panels-1", ...
    Boards of another thickness or material than the sheet's are drawn by themselves, called by the
    kind of their parts: "-gussets", or "-gussets-9" after eight sheets of other boards. Arms of
    whole boards are drawn one of each kind: "-arms".
    """
    if document.boards is None:
        return
    yield from _draw_boards(document, workshop)
    arms = draw_arms(document, workshop)
    if arms is not None:
        yield "-arms", arms


def _draw_boards(document: Document, workshop: Workshop) -> Iterator[tuple[str, Drawing]]:
    if workshop.stock is None:
        for layer in board_layers(document, workshop):
            page = draw_page(layer.content, layer.title, document.unit, layer.facts, workshop)
            yield f"-{layer.ending}", page
        return
    parts = board_parts(document)
    usual = "boards" if any(part.side for part in parts) else LAYERS[0]
    contents = (part.content() for part in parts)
    places = nest_boards(document, workshop)
    placed = [*zip(contents, places, strict=True)]
    stocks = zip(stocks_of_boards(document), sheets_of_stocks(document, places), strict=True)
    for stock, numbers in stocks:
        name = f"{stock.kind}s" if stock.kind else usual
        title = f"{document.title}, {name}{_in_words(stock, document.unit)}"
        sheets = draw_stock_sheets(placed, title, document.unit, workshop, numbers)
        yield from zip((f"-{name}-{1 + number}" for number in numbers), sheets, strict=True)


def _in_words(stock: BoardStock, unit: str) -> str:
    """What boards of another stock than the sheet's are; nothing of those of the sheet's."""
    return f" {plain(stock.thickness)} {unit} thick{stock.of}" if stock.kind else ""


def board_layers(document: Document, workshop: Workshop) -> tuple[BoardLayer, ...]:
    """The layers of boards as they lie on the sheet, but apart by ``spacing`` at least.

    Where that is 0, it is half their thickness.
    """
    parts = board_parts(document)
    moves = _moves_apart(laid_flat(document), workshop)
    layers = []
    for stock, (side, ending) in product(stocks_of_boards(document), LAYERS.items()):
        there = {*stock.boards.tolist()}
        mine = [part for part in parts if part.side == side and part.number in there]
        if mine:
            mirror = MIRRORED if side < 0 else 1.0
            content = gathered(
                shifted(part.content(), *(moves[part.panel] * mirror).tolist()) for part in mine
            )
            own = f"{stock.kind}s" if stock.kind else ""
            title = f"{document.title}, {own or _CALLED[side]}"
            facts = _facts(document, stock, mine, content)
            layers.append(BoardLayer(own or ending, title, content, facts))
    return tuple(layers)


def _moves_apart(document: Document, workshop: Workshop) -> Array:
    """How far boards (F, 2) move with their panels: away from the origin, by one share of the way.

    The centres of two convex panels lie on either side of a line between them, so that none meet.
    """
    assert document.panel is not None
    clear = workshop.spacing or 0.5 * document.panel.thickness
    flat, mesh = document.require_flat(), document.mesh
    centres = flat[mesh.faces].mean(axis=1)
    creases = np.flatnonzero(mesh.crease)
    if not len(creases):
        return np.zeros_like(centres)
    run = flat[mesh.edges[creases, 1]] - flat[mesh.edges[creases, 0]]
    way = centres[mesh.edge_faces[creases, 1]] - centres[mesh.edge_faces[creases, 0]]
    across = np.abs(run[:, 0] * way[:, 1] - run[:, 1] * way[:, 0]) / np.hypot(*run.T)
    return np.asarray(centres * (clear / float(across.min())))


def _facts(
    document: Document, stock: BoardStock, parts: Sequence[BoardPart], content: Content
) -> tuple[str, ...]:
    build, unit = stock.build, document.unit
    hung = said_of_lines(laid_flat(document))
    size = quoted_size(drawn_box(content)[1], unit)
    if stock.kind:
        said = _in_words(stock, unit)
        drilled = ". Circles are holes for bolts" if any(part.circles for part in parts) else ""
        return f"{len(parts)} {stock.kind}s,{said}, {size}", f"Cut square, seen from above{drilled}"
    if build.construction == "hinged":
        return (
            f"{len(parts)} whole boards, {build.thickness:g} {unit} thick, {size}",
            f"Cut square. Circles are holes: {FACES[1]} from the top, {FACES[-1]} from below. "
            "Names as in hinges.csv",
        )
    if build.construction == "bevel":
        cut = "Cut on the hinge plane; chamfers at the top (T) and bottom (B) in degrees"
        return f"{len(parts)} solid panels, {build.thickness:g} {unit} thick, {size}", cut, *hung
    seen = "Lower face, seen from below" if parts[0].side < 0 else "Upper face, seen from above"
    return f"{len(parts)} boards, {plain(stock.thickness)} {unit} thick, {size}", seen, *hung


def draw_plan(document: Document, workshop: Workshop) -> Drawing:
    """Solid panels in their places, with part numbers, and the creases between them.

    It is seen from above, and nothing of it is cut. What is clipped on at the target lies beside
    the edge that it is clipped on.
    """
    document = laid_flat(document)
    require_drawable(document)
    seen = seen_from_outside(document, 0)
    panels = (Line("ENGRAVE", distinct_corners(outline), closed=True) for outline in seen.outlines)
    creases = short_creases(document, np.flatnonzero(document.mesh.crease))
    seams = seam_names(document, strip_numbers(document))
    names = (*board_labels(document, 0), *plan_names(document), *seams)
    content = (*panels, *creases), (), names
    facts = (
        f"{len(seen.numbers)} panels, {quoted_size(drawn_box(content)[1], document.unit)}",
        "Plan of assembly, seen from above; nothing is cut",
    )
    return draw_page(content, f"{document.title}, plan", document.unit, facts, workshop)

"""The drawings that a workshop cuts: one of the whole sheet, or as many as the stock asks for."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import chain
from pathlib import Path

import numpy as np

from orishell.document import Document
from orishell.motion.quads import signed_areas
from orishell.numerics.arrays import Array
from orishell.workshop.assembly import draw_map, laid_flat, number_text
from orishell.workshop.board_sheets import count_board_sheets, draw_boards, draw_plan
from orishell.workshop.boards import (
    cut_of_sheet,
    distinct_corners,
    has_sheet,
    seen_from_outside,
    sheet_title,
)
from orishell.workshop.creases import made_lengths
from orishell.workshop.cut_parts import CutPart, named_sheet, whole_sheet
from orishell.workshop.draw import (
    cuts_within,
    draw_page,
    draw_part,
    drawn_box,
    part_lines,
    require_drawable,
)
from orishell.workshop.layout import Layout, lay_out, on_its_roll
from orishell.workshop.on_sheet import back_of, with_places
from orishell.workshop.palettes import Drawing
from orishell.workshop.placing import Placement, draw_stock_sheets
from orishell.workshop.settings import Workshop
from orishell.workshop.title_block import quoted_size


@dataclass(frozen=True, slots=True)
class Waste:
    """How much of stock or rolls is used, and how long cuts and creases are (document's unit)."""

    sheets: int  # number of sheets of stock
    # their area; without stock, that of the sheet's bounding rectangle along the axes
    stock_area: float
    used_area: float  # area of all parts, with tabs and strips
    waste: float  # share of the stock that is not used
    # length of all that is cut: outlines, cuts within them and relief holes
    cut_length: float
    # length of all that is scored, engraved, or cut in dashes, along creases, those of tabs and
    # strips too
    crease_length: float


def draw_sheets(document: Document, workshop: Workshop) -> tuple[Drawing, ...]:
    """The drawings to be cut, one for each sheet of stock.

    Without stock, or if the sheet fits it as it is, there is one drawing. Otherwise the first
    one is a map of the whole sheet with the numbers of parts and the names of joints, and not
    to be cut; it is followed by a drawing for every sheet of stock, exactly of its size.

    Where panels are solid there is no sheet to be cut, and one drawing: the plan of assembly.
    """
    if not has_sheet(document):
        return (draw_plan(document, workshop),)
    document = cut_of_sheet(document)
    everything = replace(laid_flat(document), title=sheet_title(document))
    workshop = on_its_roll(document, workshop)
    if workshop.stock is None:
        part = with_places(everything, named_sheet(everything))
        return (draw_part(everything, part, workshop),)
    require_drawable(everything)
    layout = lay_out(document, workshop)
    placed = []
    for part, placement in _placed(layout):
        lines, circles, texts = part_lines(everything, with_places(everything, part), workshop)
        if part.number:
            words = number_text(everything, part, texts)
            texts += (replace(words, angle=-placement.angle),)
        placed.append(((lines, circles, texts), placement))
    drawings = draw_stock_sheets(placed, everything.title, document.unit, workshop)
    if len(layout.parts) == 1:
        return tuple(drawings)
    return (draw_map(document, layout.parts, layout.joints, workshop, layout.sheets), *drawings)


def draw_backs(document: Document, workshop: Workshop) -> tuple[Drawing, ...]:
    """The back of every sheet of :func:`draw_sheets`, with the places of the lower boards.

    None where there is no membrane, or no board on its lower face.
    """
    document = cut_of_sheet(document)
    everything = replace(laid_flat(document), title=sheet_title(document))
    if everything.boards is None or not (everything.boards.sides < 0).any():
        return ()
    title = f"{everything.title}, back"
    workshop = on_its_roll(document, workshop)
    if workshop.stock is None:
        content = back_of(everything, whole_sheet(everything))
        facts = (
            f"Lower face, seen from below, {quoted_size(drawn_box(content)[1], document.unit)}",
            "Places of the lower boards; nothing is cut",
        )
        return (draw_page(content, title, document.unit, facts, workshop),)
    layout = lay_out(document, workshop)
    width, _ = workshop.usable_stock
    placed = [(back_of(everything, part), p.turned_over(width)) for part, p in _placed(layout)]
    return tuple(draw_stock_sheets(placed, title, document.unit, workshop))


def _placed(layout: Layout) -> Iterator[tuple[CutPart, Placement]]:
    if layout.placements is None:
        raise AssertionError("only stock is drawn sheet by sheet")
    return zip(layout.parts, layout.placements, strict=True)


def draw_sheet_files(
    path: Path, document: Document, workshop: Workshop
) -> Iterator[tuple[Path, Drawing]]:
    """The drawings of :func:`draw_sheets` and their files: ``path``, then ``-1``, ``-2``, ...

    Where panels have a thickness the back of the membrane (``-back``, or ``-back-1``, ...) and the
    boards (:func:`~orishell.workshop.board_sheets.draw_boards`) follow.
    """
    sheets, backs = draw_sheets(document, workshop), draw_backs(document, workshop)
    drawn = [(f"-{k}" if k else "", drawing) for k, drawing in enumerate(sheets)]
    numbered = len(sheets) > 1
    drawn += [(f"-back-{k}" if numbered else "-back", back) for k, back in enumerate(backs, 1)]
    for ending, drawing in chain(drawn, draw_boards(document, workshop)):
        yield path.with_stem(path.stem + ending), drawing


def measure_waste(document: Document, workshop: Workshop) -> Waste:
    """How much stock the sheet, or else the solid panels, need and waste; cuts and creases."""
    workshop = on_its_roll(document, workshop)
    if has_sheet(document):
        document = cut_of_sheet(document)
    everything = laid_flat(document)
    within, creases = 0.0, 0.0  # lengths
    if has_sheet(document):
        layout = lay_out(document, workshop)
        outlines = [outline for part in layout.parts for outline in part.outlines]
        made = [made_lengths(everything, part, workshop) for part in layout.parts]
        creases = sum(each.creases for each in made)
        within = sum(each.holes for each in made)
        within += sum(_length(cuts_within(everything, part)) for part in layout.parts)
        sheets = layout.sheets
    else:
        outlines = [*map(distinct_corners, seen_from_outside(everything, 0).outlines)]
        sheets = count_board_sheets(document, workshop) or 1
    if workshop.stock is None:
        stock = float(np.prod(np.ptp(np.concatenate(outlines), axis=0)))
    else:
        stock = sheets * workshop.stock[0] * workshop.stock[1]
    used = sum(float(signed_areas(outline)) for outline in outlines)
    around = [np.stack([outline, np.roll(outline, 1, axis=0)], axis=1) for outline in outlines]
    return Waste(
        sheets=sheets,
        stock_area=stock,
        used_area=used,
        waste=1 - used / stock,
        cut_length=sum(map(_length, around)) + within,
        crease_length=creases,
    )


def _length(lines: Array) -> float:
    """Length of straight lines (L, 2, 2) together."""
    return float(np.hypot(*(lines[:, 1] - lines[:, 0]).T).sum())

"""The drawings that a workshop cuts: one as large as the sheet, or as many as the stock asks for.

A sheet larger than the stock is split into parts (:mod:`~orishell.workshop.splitting`), which get
tabs or strips (:mod:`~orishell.workshop.joints`) and are laid on the stock
(:mod:`~orishell.workshop.nesting`); a map says how they go together
(:mod:`~orishell.workshop.assembly`).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from orishell.document import Document
from orishell.errors import InputError
from orishell.workshop.assembly import draw_map, number_text
from orishell.workshop.draw import draw_part, part_lines, require_drawable
from orishell.workshop.drawing import ORDER, Anchor, Circle, Drawing, Line, Text
from orishell.workshop.fitting import find_turns
from orishell.workshop.joints import Joint, make_parts
from orishell.workshop.nesting import Placement, nest_parts
from orishell.workshop.outline import signed_areas, whole_sheet
from orishell.workshop.part import Part
from orishell.workshop.settings import Workshop
from orishell.workshop.splitting import split_sheet
from orishell.workshop.tabs import choose_joint_width

Array = NDArray[np.float64]

LETTERS = 0.4
"""Height of the words in the margin, as a share of its width."""

TURNED: dict[Anchor, Anchor] = {"start": "end", "middle": "middle", "end": "start"}
"""Anchors of texts that are turned half round."""


@dataclass(frozen=True, slots=True)
class Waste:
    """What of the stock is used, and the machine's way; lengths and areas in the unit.

    Parameters
    ----------
    sheets
        Number of sheets of stock.
    stock_area
        Their area; without stock, that of the sheet's bounding rectangle along the axes.
    used_area
        Area of all parts, with tabs and strips.
    waste
        Share of the stock that is not used.
    cut_length
        Length of all outlines that are cut.
    crease_length
        Length of all creases, those of tabs and strips too.
    """

    sheets: int
    stock_area: float
    used_area: float
    waste: float
    cut_length: float
    crease_length: float


@dataclass(frozen=True, slots=True, eq=False)
class Layout:
    """Where everything is cut.

    Parameters
    ----------
    parts
        The whole sheet, or its parts and then the strips.
    placements
        Where each lies within the margins; None without stock.
    joints
        How parts are joined.
    """

    parts: tuple[Part, ...]
    placements: tuple[Placement, ...] | None
    joints: tuple[Joint, ...] = ()

    @property
    def sheets(self) -> int:
        """Number of sheets that are cut."""
        return 1 if self.placements is None else 1 + max(p.sheet for p in self.placements)


def lay_out(document: Document, workshop: Workshop) -> Layout:
    """Split the sheet as the stock asks for, and lay the parts on it.

    Raises
    ------
    InputError
        If there is no flat sheet, or a panel does not fit the stock.
    """
    whole = whole_sheet(document)
    if workshop.stock is None:
        return Layout((whole,), None)
    width, height = _usable(workshop)
    points = np.concatenate(whole.outlines)
    turns = find_turns(points, width, height)
    if len(turns):
        turned = Placement(0, float(turns[0]), np.zeros(2))
        shift = -turned.move(points).min(axis=0)
        return Layout((whole,), (replace(turned, shift=shift),))
    joint = choose_joint_width(document, workshop)
    split = split_sheet(document, width, height, joint if workshop.joint == "tabs" else 0.0)
    parts, strips, joints = make_parts(document, split, workshop.joint, joint)
    outlines = [part.outlines[0] for part in (*parts, *strips)]
    return Layout((*parts, *strips), nest_parts(outlines, width, height, workshop.spacing), joints)


def draw_sheets(document: Document, workshop: Workshop) -> tuple[Drawing, ...]:
    """What is cut, a drawing for each sheet.

    Without stock, or if the sheet fits it as it is, there is one drawing. Otherwise the first
    one is a map of the whole sheet with the numbers of parts and the names of joints, and not
    to be cut; it is followed by a drawing for every sheet of stock, exactly of its size.

    Parameters
    ----------
    document
        The sheet.
    workshop
        The stock, its margin, and how creases and joints are made.

    Raises
    ------
    InputError
        If there is no flat sheet or no unit, or a panel does not fit the stock.
    """
    if workshop.stock is None:
        return (draw_part(document, whole_sheet(document), workshop),)
    require_drawable(document)
    layout = lay_out(document, workshop)
    drawings = tuple(
        _draw_sheet(document, workshop, layout, number) for number in range(layout.sheets)
    )
    if len(layout.parts) == 1:
        return drawings
    return (draw_map(document, layout.parts, layout.joints, workshop, layout.sheets), *drawings)


def name_sheets(
    path: Path, document: Document, workshop: Workshop
) -> Iterator[tuple[Path, Drawing]]:
    """The drawings of :func:`draw_sheets` and their files: ``path``, then ``-1``, ``-2``, ..."""
    for number, drawing in enumerate(draw_sheets(document, workshop)):
        yield (path.with_stem(f"{path.stem}-{number}") if number else path), drawing


def measure_waste(document: Document, workshop: Workshop) -> Waste:
    """How much stock the sheet needs, and how far the machine goes.

    Raises
    ------
    InputError
        If there is no flat sheet, or a panel does not fit the stock.
    """
    layout = lay_out(document, workshop)
    flat, edges = document.require_flat(), document.mesh.edges
    outlines = [outline for part in layout.parts for outline in part.outlines]
    if workshop.stock is None:
        stock = float(np.prod(np.ptp(np.concatenate(outlines), axis=0)))
    else:
        stock = layout.sheets * workshop.stock[0] * workshop.stock[1]
    used = sum(float(signed_areas(outline)) for outline in outlines)
    around = [outline - np.roll(outline, 1, axis=0) for outline in outlines]
    ends = flat[edges[np.concatenate([part.creases for part in layout.parts])]]
    return Waste(
        sheets=layout.sheets,
        stock_area=stock,
        used_area=used,
        waste=1 - used / stock,
        cut_length=float(sum(np.hypot(*sides.T).sum() for sides in around)),
        crease_length=float(np.hypot(*(ends[:, 1] - ends[:, 0]).T).sum()),
    )


def _usable(workshop: Workshop) -> tuple[float, float]:
    if workshop.stock is None:
        raise AssertionError("only stock has a margin")
    width, height = (side - 2 * workshop.margin for side in workshop.stock)
    if min(width, height) <= 0:
        raise InputError(
            "the margins leave nothing of the stock",
            where="[workshop] margin",
            got=f"{workshop.margin:g}",
            expected=f"less than {min(workshop.stock) / 2:g}",
        )
    return width, height


def _draw_sheet(document: Document, workshop: Workshop, layout: Layout, number: int) -> Drawing:
    """One sheet of stock, in the order of work: marks, creases, holes, cuts."""
    if workshop.stock is None or layout.placements is None:
        raise AssertionError("only stock is drawn sheet by sheet")
    lines: list[Line] = []
    circles: list[Circle] = []
    texts: list[Text] = []
    for part, placement in zip(layout.parts, layout.placements, strict=True):
        if placement.sheet != number:
            continue
        drawn_lines, drawn_circles, drawn_texts = part_lines(document, part, workshop)
        if part.number:
            words = number_text(document, part, drawn_texts)
            drawn_texts += (replace(words, angle=-placement.angle),)
        place = replace(placement, shift=placement.shift + workshop.margin)
        lines += [replace(line, points=place.move(line.points)) for line in drawn_lines]
        circles += [_move_circle(circle, place) for circle in drawn_circles]
        texts += [_move_text(text, place) for text in drawn_texts]
    title = document.title
    if layout.sheets > 1:
        title += f", sheet {number + 1} of {layout.sheets}"
    if workshop.title_block and workshop.margin > 0:
        wide, high = workshop.stock
        says = f"{title}, 1:1 on {wide:g} x {high:g} {document.unit}"
        texts.append(_margin_words(says, wide, workshop.margin))
    lines.sort(key=lambda line: ORDER.index(line.layer))
    return Drawing(
        title, document.unit, *workshop.stock, tuple(lines), tuple(circles), tuple(texts)
    )


def _margin_words(words: str, width: float, margin: float) -> Text:
    height = min(LETTERS * margin, (width - 2 * margin) / len(words))
    return Text("LABEL", margin, margin / 2, height, words, anchor="start")


def _move_circle(circle: Circle, place: Placement) -> Circle:
    ((x, y),) = place.move(np.array([[circle.x, circle.y]])).tolist()
    return replace(circle, x=x, y=y)


def _move_text(text: Text, place: Placement) -> Text:
    """The text where its part lies, the other way round if it would be upside down."""
    ((x, y),) = place.move(np.array([[text.x, text.y]])).tolist()
    angle = float(np.remainder(text.angle + place.angle + np.pi, 2 * np.pi) - np.pi)
    anchor = text.anchor
    if not -np.pi / 2 - 1e-9 < angle <= np.pi / 2 + 1e-9:
        angle -= float(np.copysign(np.pi, angle))
        anchor = TURNED[anchor]
    return replace(text, x=x, y=y, angle=angle, anchor=anchor)

"""A card model: the shell as one sheet without a thickness, at a scale that fits a page."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.conventions.quantities import conversion
from orishell.conventions.record import record
from orishell.design.part import MadeStates
from orishell.document import Document, DocumentState
from orishell.document.joined import AnyPart
from orishell.workshop.assembly import laid_flat
from orishell.workshop.cut_parts import whole_sheet
from orishell.workshop.settings import Workshop
from orishell.workshop.tiling import page_scale, tile_sheet

SHORTEST_MM, SMALLEST_MM = 1.0, 0.5
"""Shorter dashes, and smaller holes, are not cut in card."""


@record
class CardModel:
    """What the files of a card model are written from."""

    document: Document  # in millimetres of the model
    workshop: Workshop  # for one sheet at true size
    scale: float  # size of the model relative to the shell


def make_card_model(document: Document, workshop: Workshop) -> CardModel:
    """The card model of a shell, at ``paper_scale``, or the largest scale that fits ``paper``.

    Creases are made as those of the shell. Sizes in the workshop's settings are the shell's, and to
    scale in its model; dashes that nobody cuts then follow its panels, and holes are left out.

    Raises InputError if it takes more than 400 pages at ``paper_scale``.
    """
    millimetres = conversion(document.require_unit(), "mm")
    bare = _without_boards(document)
    rims = whole_sheet(laid_flat(bare)).outlines
    low = rims[0].min(axis=0)
    placed = tuple((rim - low) * millimetres for rim in rims)
    if workshop.paper_scale == "auto":
        scale = page_scale(placed, workshop.paper)
    else:
        scale = tile_sheet(placed, workshop.paper_scale, workshop.paper).scale
    factor = millimetres * scale
    asked = "auto" if workshop.creases == "score" else workshop.dash
    dash, gap = (each if each == "auto" else each * factor for each in (asked, workshop.corner_gap))
    hole = workshop.relief_hole * factor
    drawn = workshop.replace_unchecked(
        dash=dash if dash == "auto" or dash >= SHORTEST_MM else "auto",
        corner_gap=gap,
        relief_hole=hole if hole >= SMALLEST_MM else 0.0,
        stock=None,
        margin=0.0,
        spacing=0.0,
        joint_width="auto",
        areal_density=0.0,
        paper_scale=1.0,
    )
    return CardModel(_scaled(bare, factor, scale), drawn, scale)


def narrowest_panel(document: Document) -> float:
    """How narrow the narrowest panel of a card model is (mm).

    Its shortest edge, or its area by its longer diagonal if that is less.
    """
    found = []
    for part in document.parts:
        corners = part.require_flat()[part.mesh.faces]
        edges = np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=-1).min(axis=1)
        diagonal = np.linalg.norm(corners[:, 2:] - corners[:, :2], axis=-1).max(axis=1)
        found.append(np.minimum(edges, np.abs(part.areas()) / diagonal))
    return float(np.concatenate(found).min())


def _without_boards(document: Document) -> Document:
    return replace(
        document,
        panel=None,
        boards=None,
        attached=tuple(
            replace(part, panel=None, boards=None, holes=None) for part in document.attached
        ),
        surface=None,
        distances=None,
        loaded=None,
        ground=None,
    )


def _scaled(document: Document, factor: float, scale: float) -> Document:
    """The document in millimetres of the model; ``factor`` makes these of its lengths."""
    return replace(
        _scaled_part(document, factor),
        curves={name: points * factor for name, points in document.curves.items()},
        origin=document.origin * factor,
        attached=tuple(_scaled_part(part, factor) for part in document.attached),
        ties=tuple(replace(tie, length=tie.length * factor) for tie in document.ties),
        model_scale=scale,
    )


def _scaled_part(part: AnyPart, factor: float) -> AnyPart:
    def scaled(number: int) -> DocumentState:
        state = part.states[number]
        return replace(state, positions=state.positions * factor)

    return replace(
        part,
        unit="mm",
        hung=part.hung and part.hung.scaled(factor),
        bears=part.bears and part.bears.scaled(factor),
        flat=part.require_flat() * factor,
        states=MadeStates(len(part.states), scaled),
    )

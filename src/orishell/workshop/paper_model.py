"""The flat sheet as a paper model: to scale, on pages."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from orishell.conventions.quantities import conversion
from orishell.conventions.record import record
from orishell.document import Document
from orishell.numerics.arrays import Array
from orishell.workshop.assembly import laid_flat
from orishell.workshop.board_sheets import board_layers
from orishell.workshop.boards import cut_of_sheet, sheet_title
from orishell.workshop.cut_parts import named_sheet, whole_sheet
from orishell.workshop.draw import part_lines, require_drawable
from orishell.workshop.on_sheet import back_of, with_places
from orishell.workshop.palettes import Circle, Layer, Line, Text, load_palette
from orishell.workshop.placing import Content
from orishell.workshop.settings import Workshop
from orishell.workshop.tiling import Tiling, tile_sheet
from orishell.workshop.title_block import round_length

BAR_MM = 62.0
"""Length of the scale bar at most (mm on paper)."""


@record
class PaperModel:
    """The sheet to be printed and folded; coordinates in mm on paper."""

    title: str
    # the sheet's drawing, from its lower left corner
    lines: tuple[Line, ...]
    texts: tuple[Text, ...]
    circles: tuple[Circle, ...]  # holes
    # corners (L, 2) of the boxes around the lines
    lows: Array
    highs: Array
    colours: dict[Layer, str]
    size: Array  # width and height (2,)
    tiling: Tiling
    bar_mm: float  # length of the scale bar
    bar_says: str  # the same in the document's unit, and in mm on paper
    of_shell: float = 1.0  # size of the document relative to the shell, where it is a model of it
    scored: bool = True  # whether creases are whole lines; else they are cut as they are drawn

    @property
    def says(self) -> str:
        """The scale in words, as in "Scale 1:20"."""
        scale = self.tiling.scale * self.of_shell
        return f"Scale {scale:.6g}:1" if scale > 1 else f"Scale 1:{1 / scale:.6g}"


def make_paper_model(document: Document, workshop: Workshop) -> PaperModel:
    """The paper model of a sheet: creases are scored, but made as they are in a card model."""
    workshop = workshop.replace_unchecked(stock=None)
    if document.model_scale is None:
        workshop = workshop.replace_unchecked(creases="score", corner_gap="auto", relief_hole=0.0)
    document = laid_flat(cut_of_sheet(document))
    require_drawable(document)
    part = with_places(document, named_sheet(document))
    content = part_lines(document, part, workshop)
    title = sheet_title(document)
    model = _to_scale(content, title, document.unit, part.outlines, workshop)
    whole = workshop.creases == "score"
    return replace(model, of_shell=document.model_scale or 1.0, scored=whole)


def make_board_models(
    document: Document, workshop: Workshop, scale: float
) -> Iterator[tuple[str, PaperModel]]:
    """Paper models of the membrane's back and of all layers of boards, and their files' endings."""
    if document.boards is None:
        return
    workshop = workshop.replace_unchecked(paper_scale=scale, stock=None)
    everything = laid_flat(cut_of_sheet(document))
    if (document.boards.sides < 0).any():
        back, title = back_of(everything, whole_sheet(everything)), f"{sheet_title(document)}, back"
        yield "-back", _to_scale(back, title, document.unit, _hull(back), workshop)
    for layer in board_layers(document, workshop):
        around = _hull(layer.content)
        model = _to_scale(layer.content, layer.title, document.unit, around, workshop)
        yield f"-{layer.ending}", model


def _hull(content: Content) -> tuple[Array, ...]:
    """The corners (k, 2) of the convex hull of all lines, as one outline."""
    import shapely

    points = shapely.multipoints(np.concatenate([line.points for line in content[0]]))
    return (shapely.get_coordinates(shapely.convex_hull(points))[:-1],)


def _to_scale(
    content: Content, title: str, unit: str, outlines: tuple[Array, ...], workshop: Workshop
) -> PaperModel:
    """What is drawn within outlines, on pages."""
    lines, circles, texts = content
    low = np.concatenate(outlines).min(axis=0)
    true = conversion(unit, "mm")
    rims = tuple((outline - low) * true for outline in outlines)
    tiling = tile_sheet(rims, workshop.paper_scale, workshop.paper)
    scale = true * tiling.scale
    drawn = tuple(replace(line, points=(line.points - low) * scale) for line in lines)
    x, y = low.tolist()
    placed = tuple(
        replace(t, x=(t.x - x) * scale, y=(t.y - y) * scale, height=t.height * scale) for t in texts
    )
    pens = dict(load_palette("plain").pens) | dict(load_palette(workshop.palette).pens)
    bar = round_length(BAR_MM / scale)
    return PaperModel(
        title=title.encode("cp1252", "replace").decode("cp1252"),
        lines=drawn,
        texts=placed,
        circles=tuple(
            replace(c, x=(c.x - x) * scale, y=(c.y - y) * scale, radius=c.radius * scale)
            for c in circles
        ),
        lows=np.array([line.points.min(axis=0) for line in drawn]),
        highs=np.array([line.points.max(axis=0) for line in drawn]),
        colours={layer: pen.colour for layer, pen in pens.items()},
        size=np.max(np.concatenate(rims), axis=0) * tiling.scale,
        tiling=tiling,
        bar_mm=bar * scale,
        bar_says=f"{bar:g} {unit} = {bar * scale:.4g} mm on paper",
    )

"""Drawings of boards: outlines and part numbers as a workshop gets them, measured with shapely."""

from __future__ import annotations

import itertools
from collections import Counter
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import shapely

from boarded import BUILDS, boarded_document
from documents import demo_document
from orishell.conventions.errors import InputError
from orishell.document import Document
from orishell.motion.boards import Boards
from orishell.workshop import Drawing, Workshop
from orishell.workshop.assembly import laid_flat
from orishell.workshop.board_sheets import board_parts, draw_boards, nest_boards
from orishell.workshop.boards import part_name
from orishell.workshop.layout import require_stock
from orishell.workshop.paper_model import make_board_models, make_paper_model
from orishell.workshop.quantities import measure_quantities
from orishell.workshop.sheets import draw_backs, draw_sheet_files, draw_sheets, measure_waste

STOCK = Workshop(stock=(250.0, 180.0), margin=8.0, spacing=1.5)


def polygons(drawing: Drawing, layer: str = "CUT") -> list[shapely.Polygon]:
    return [
        shapely.Polygon(line.points)
        for line in drawing.lines
        if line.layer == layer and line.closed
    ]


def engraved(drawing: Drawing) -> list[str]:
    return [text.words for text in drawing.texts if text.layer == "ENGRAVE"]


def boards_of(document: Document) -> Boards:
    boards = laid_flat(document).boards
    assert boards is not None
    return boards


def part_names(document: Document, side: int) -> list[str]:
    everything, boards = laid_flat(document), boards_of(document)
    return [part_name(everything, int(k)) for k in np.flatnonzero(boards.sides == side)]


def assert_apart(shapes: list[shapely.Polygon], least: float) -> None:
    tree = shapely.STRtree(shapes)
    pairs = tree.query(shapes, predicate="dwithin", distance=least * (1 - 1e-9)).T.tolist()
    assert [pair for pair in pairs if pair[0] < pair[1]] == []


def test_names_of_files() -> None:
    """Without boards there is one drawing; with them the membrane, its back, and the layers."""

    def names(document: Document, workshop: Workshop) -> list[str]:
        files = draw_sheet_files(Path("pattern.svg"), document, workshop)
        return [path.name for path, _ in files]

    plain = Workshop()
    assert names(demo_document(), plain) == ["pattern.svg"]
    assert names(boarded_document(), plain) == [
        "pattern.svg",
        "pattern-back.svg",
        "pattern-top.svg",
        "pattern-bottom.svg",
    ]
    assert names(boarded_document("bevel"), plain) == ["pattern.svg", "pattern-panels.svg"]
    large = STOCK.replace_unchecked(stock=(1000.0, 700.0))
    assert names(boarded_document(), large) == [
        "pattern.svg",
        "pattern-back.svg",
        "pattern-boards-1.svg",
    ]
    split = names(boarded_document(clipped=True), STOCK)
    sheets = len([name for name in split if name.startswith("pattern-back-")])
    assert sheets > 1
    assert f"pattern-{sheets}.svg" in split
    assert "pattern-boards-1.svg" in split
    assert names(boarded_document("bevel"), large)[-1] == "pattern-panels-1.svg"


@pytest.mark.parametrize("construction", BUILDS)
@pytest.mark.parametrize("clipped", [False, True])
def test_layers_have_the_outlines_of_the_boards(construction: str, *, clipped: bool) -> None:
    """Every board is cut once, of its own area, under its own part number, apart from others."""
    document = boarded_document(construction, clipped=clipped)
    boards = boards_of(document)
    endings = {"-top": 1, "-bottom": -1, "-panels": 0}
    drawn = dict(draw_boards(document, Workshop(spacing=3.0)))
    assert set(drawn) == {
        ending for ending, side in endings.items() if (boards.sides == side).any()
    }
    for ending, drawing in drawn.items():
        side = endings[ending]
        cut = polygons(drawing)
        areas = boards.areas()[boards.sides == side]
        assert sorted(shape.area for shape in cut) == pytest.approx(sorted(areas), rel=1e-9)
        numbers = [words for words in engraved(drawing) if "°" not in words]
        assert sorted(numbers) == sorted(part_names(document, side))
        assert_apart(cut, 1e-6)
        page = shapely.box(0, 0, drawing.width, drawing.height)
        assert all(page.contains(shape) for shape in cut)
    assert Counter(part.side for part in board_parts(document)) == Counter(boards.sides.tolist())


def test_boards_keep_their_distance_across_creases() -> None:
    """With ``spacing`` no two boards of panels beside a crease are nearer than that."""
    document = boarded_document()
    for _, drawing in draw_boards(document, Workshop(spacing=3.0)):
        shapes = polygons(drawing)
        for shape in shapes:
            near = [shape.distance(other) for other in shapes if other is not shape]
            assert min(near) >= 3.0 * (1 - 1e-9)


def test_bottom_boards_are_mirrored_as_seen_from_below() -> None:
    """Turned over, a lower board covers its own place under the sheet."""
    document = boarded_document()
    boards = boards_of(document)
    for part in board_parts(document):
        if part.side < 0:
            lying = shapely.Polygon(boards.outlines[part.number, 0, :, :2])
            turned = shapely.Polygon(part.outline * [-1.0, 1.0])
            assert lying.symmetric_difference(turned).area < 1e-9 * lying.area
            assert shapely.Polygon(part.outline).exterior.is_ccw


@pytest.mark.parametrize("workshop", [Workshop(), STOCK], ids=["whole", "split"])
@pytest.mark.parametrize("clipped", [False, True])
def test_glue_areas(workshop: Workshop, *, clipped: bool) -> None:
    """The membrane has the place of every upper board on its face, of every lower on its back."""
    document = boarded_document(clipped=clipped)
    boards = boards_of(document)
    sheets = draw_sheets(document, workshop)
    fronts = sheets[1:] or sheets
    backs = draw_backs(document, workshop)
    assert len(backs) == len(fronts)
    for side, drawings in ((1, fronts), (-1, backs)):
        numbers = [words for drawing in drawings for words in engraved(drawing)]
        names = part_names(document, side)
        assert sorted(set(numbers) & set(names)) == sorted(names)
        assert all(numbers.count(name) == 1 for name in names)
        areas = [shape.area for d in drawings for shape in polygons(d, "ENGRAVE")]
        for area in boards.areas()[boards.sides == side]:
            assert min(abs(area - found) for found in areas) < 1e-9 * area


def test_backs_are_their_sheets_turned_over() -> None:
    """Mirrored, a back has the rims that are cut, and lower boards' places below upper ones."""
    document = boarded_document(clipped=True)
    assert STOCK.stock is not None
    width, _ = STOCK.stock
    pairs = list(zip(draw_sheets(document, STOCK)[1:], draw_backs(document, STOCK), strict=True))
    assert len(pairs) > 1
    for front, back in pairs:
        mirrored = [
            shapely.Polygon([width, 0] + line.points * [-1, 1])
            for line in back.lines
            if line.closed
        ]
        for shape in polygons(front):
            off = [shape.symmetric_difference(other).area for other in mirrored]
            assert min(off) < 1e-9 * shape.area
        upper = [t for t in front.texts if t.layer == "ENGRAVE" and t.words.endswith("T")]
        for text in back.texts:
            if text.words.endswith("B"):
                nearest = min(upper, key=lambda t: np.hypot(t.x - (width - text.x), t.y - text.y))
                assert nearest.words[:-1] == text.words[:-1]


@pytest.mark.parametrize("construction", BUILDS)
def test_nested_boards_lie_apart_on_the_stock(construction: str) -> None:
    document = boarded_document(construction, clipped=True)
    boards = boards_of(document)
    assert STOCK.stock is not None
    drawings = [drawing for _, drawing in draw_boards(document, STOCK)]
    assert len(drawings) == 1 + max(p.sheet for p in nest_boards(document, STOCK))
    inner = shapely.box(0, 0, *STOCK.stock).buffer(1e-6 - STOCK.margin, join_style="mitre")
    areas: list[float] = []
    numbers: list[str] = []
    for drawing in drawings:
        assert (drawing.width, drawing.height) == STOCK.stock
        shapes = polygons(drawing)
        assert all(inner.contains(shape) for shape in shapes)
        assert_apart(shapes, STOCK.spacing)
        areas += [shape.area for shape in shapes]
        numbers += [words for words in engraved(drawing) if "°" not in words]
    assert sorted(areas) == pytest.approx(sorted(boards.areas()), rel=1e-9)
    assert sorted(numbers) == sorted(
        itertools.chain(*(part_names(document, side) for side in (1, -1, 0)))
    )


def test_words_lie_on_their_boards() -> None:
    """Part numbers and angles lie within what is cut, and do not cover each other."""
    for construction in BUILDS:
        for part in board_parts(boarded_document(construction)):
            shape, boxes = shapely.Polygon(part.outline), []
            for text in part.texts:
                half = 0.5 * text.height * np.array([len(text.words), 1.0])
                box = shapely.affinity.rotate(
                    shapely.box(-half[0], -half[1], half[0], half[1]), text.angle, use_radians=True
                )
                boxes.append(shapely.affinity.translate(box, text.x, text.y))
            assert all(shape.contains(box) for box in boxes)
            number = boxes[-1]
            assert not any(number.intersects(box) for box in boxes[:-1])
            assert part.texts[-1].words == part.name


@pytest.mark.parametrize("clipped", [False, True])
@pytest.mark.parametrize("stock", [None, (420.0, 297.0)])
def test_of_solid_panels_only_these_are_cut(
    stock: tuple[float, float] | None, *, clipped: bool
) -> None:
    """There is no sheet to be cut: a plan shows every panel and its number, and cuts nothing."""
    document = boarded_document("bevel", clipped=clipped)
    areas = boards_of(document).areas()
    workshop = Workshop(stock=stock, margin=5.0, spacing=1.0)
    (_, plan), *sheets = draw_sheet_files(Path("pattern.dxf"), document, workshop)
    assert {line.layer for line in plan.lines} == {"ENGRAVE", "MOUNTAIN", "VALLEY", "LABEL"}
    assert not plan.circles
    numbers = [text.words for text in plan.texts if text.layer == "ENGRAVE"]
    assert sorted(numbers) == sorted(part_names(document, 0))
    assert all("-panels" in path.stem for path, _ in sheets)
    cut = [shape.area for _, drawing in sheets for shape in polygons(drawing)]
    waste = measure_waste(document, workshop)
    assert waste.used_area == pytest.approx(sum(cut), rel=1e-9)
    assert waste.crease_length == 0
    assert waste.sheets == len(sheets)
    bill = measure_quantities(document, workshop).built
    assert bill is not None
    assert bill.stock_sheets == (None if stock is None else waste.sheets)
    if stock is not None:
        require_stock(document, workshop)
    assert sorted(cut) == pytest.approx(sorted(areas), rel=1e-9)


def test_a_solid_panel_too_large_for_its_stock_is_refused() -> None:
    document = boarded_document("bevel")
    small = Workshop(stock=(40.0, 30.0))
    for ask in (require_stock, measure_waste):
        with pytest.raises(InputError, match="stock"):
            ask(document, small)


def test_chamfers_are_half_the_fold_angles() -> None:
    """Without a gap a chamfer halves the fold angle of its crease: every angle is that of one."""
    document = boarded_document("bevel")
    assert document.panel is not None
    half = np.abs(document.fold_angles_deg[document.mesh.crease]) / 2
    height, gap = document.panel.height, document.panel.gap
    expected = np.rad2deg(np.arctan(np.tan(np.deg2rad(half)) - 0.5 * gap / height))
    said = [
        float(text.words.split("°")[0])
        for part in board_parts(document)
        for text in part.texts
        if "°" in text.words
    ]
    assert said
    assert all(np.abs(expected - angle).min() < 0.051 for angle in said)


@pytest.mark.parametrize("construction", BUILDS)
def test_cut_corners_are_cut(construction: str) -> None:
    """Corners cut off at an inner vertex are not there, others are, also of flaps clipped on."""
    plain = boarded_document(construction, clipped=True)
    cut = boarded_document(construction, clipped=True, relief=6.0)
    before, after = board_parts(plain), board_parts(cut)
    assert [part.name for part in before] == [part.name for part in after]
    around = {"1,1", "1,2", "2,1", "2,2"}
    for one, two in zip(before, after, strict=True):
        lost = shapely.Polygon(one.outline).area - shapely.Polygon(two.outline).area
        if one.name.rstrip("TB") not in around:
            assert abs(lost) < 1e-9
            assert len(two.outline) == 4
    assert sum(len(part.outline) > 4 for part in after) >= 4
    drawn = [s.area for _, d in draw_boards(cut, Workshop()) for s in polygons(d)]
    assert sorted(drawn) == pytest.approx(sorted(boards_of(cut).areas()), rel=1e-9)


def test_a_sheet_without_any_board_is_drawn() -> None:
    """Where every panel is beside creases that fold flat there is no board, and nothing to nest."""
    document = boarded_document()
    assert document.boards is not None
    bare = replace(document, boards=document.boards.chosen(np.zeros(len(document.boards), bool)))
    for workshop in (Workshop(), STOCK):
        assert list(draw_boards(bare, workshop)) == []
        assert draw_backs(bare, workshop) == ()
        assert draw_sheets(bare, workshop)


def test_layers_of_the_paper_model_have_its_scale() -> None:
    document, workshop = boarded_document(), Workshop(paper_scale="auto")
    model = make_paper_model(document, workshop)
    layers = dict(make_board_models(document, workshop, model.tiling.scale))
    assert list(layers) == ["-back", "-top", "-bottom"]
    assert {layer.tiling.scale for layer in layers.values()} == {model.tiling.scale}
    boards = boards_of(document)
    for ending, side in (("-top", 1), ("-bottom", -1)):
        cut = [line.points for line in layers[ending].lines if line.layer == "CUT"]
        areas = boards.areas()[boards.sides == side] * model.tiling.scale**2
        found = sorted(shapely.Polygon(points).area for points in cut)
        assert found == pytest.approx(sorted(areas), rel=1e-9)


def test_a_board_larger_than_the_stock_is_refused() -> None:
    with pytest.raises(InputError, match="stock"):
        list(draw_boards(boarded_document(), STOCK.replace_unchecked(stock=(60.0, 60.0))))

"""Drawings of a sheet on stock: what a workshop gets, measured with shapely."""

from __future__ import annotations

import itertools
import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

from documents import FAMILIES, demo_document, slit_document
from orishell.conventions.errors import InputError
from orishell.document import Document
from orishell.workshop import Drawing, Line, Workshop
from orishell.workshop.creases import mean_edge
from orishell.workshop.layout import lay_out
from orishell.workshop.settings import CreaseStyle
from orishell.workshop.settings import Joint as JointKind
from orishell.workshop.sheets import draw_sheets, measure_waste
from samples import examples

TESTS = Path(__file__).parent.parent


def stock_for(family: str, share: float = 0.5) -> Workshop:
    """Landscape stock of a share of the sheet's longer side, with margins and spacing."""
    side = share * float(np.ptp(demo_document(family).require_flat(), axis=0).max())
    return Workshop(stock=(side, 0.75 * side), margin=0.02 * side, spacing=0.01 * side)


def closed(drawing: Drawing) -> list[shapely.Polygon]:
    """What is cut out of a sheet."""
    return [
        shapely.Polygon(line.points)
        for line in drawing.lines
        if line.layer == "CUT" and line.closed
    ]


def assert_cuttable(drawing: Drawing, workshop: Workshop) -> None:
    assert workshop.stock is not None
    width, height = workshop.stock
    assert (drawing.width, drawing.height) == workshop.stock
    rounding = 1e-9 * max(width, height)
    inner = shapely.box(0, 0, width, height).buffer(rounding - workshop.margin, join_style="mitre")
    parts = closed(drawing)
    assert parts
    for part in parts:
        assert inner.contains(part)
    for one, two in itertools.combinations(parts, 2):
        assert one.distance(two) >= workshop.spacing
    work = shapely.union_all(parts).buffer(rounding)
    for line in drawing.lines:
        if line.layer != "LABEL":
            assert work.contains(shapely.LineString(line.points))
    for text in drawing.texts:
        if text.layer == "ENGRAVE":
            assert work.contains(shapely.Point(text.x, text.y))
            assert -np.pi / 2 - 1e-8 < text.angle <= np.pi / 2 + 1e-8
    order = [line.layer == "CUT" for line in drawing.lines]
    assert order == sorted(order)  # the outer cut comes last


@pytest.mark.parametrize("joint", ["tabs", "strips"])
@pytest.mark.parametrize("family", list(FAMILIES))
def test_parts_lie_on_the_stock_and_map_names_them(family: str, joint: JointKind) -> None:
    document = demo_document(family)
    workshop = stock_for(family).replace_unchecked(joint=joint)
    layout = lay_out(document, workshop)
    first, *sheets = draw_sheets(document, workshop)
    assert len(sheets) == layout.sheets > 1
    for sheet in sheets:
        assert_cuttable(sheet, workshop)
    numbers = {str(part.number) for part in layout.parts if part.number}
    names = {joint.name for joint in layout.joints}
    on_map = {text.words for text in first.texts}
    assert on_map >= numbers | names
    engraved = [text.words for sheet in sheets for text in sheet.texts if text.layer == "ENGRAVE"]
    assert sorted(word for word in engraved if word in numbers) == sorted(numbers)
    twice = 2 if joint == "tabs" else 4  # strips bear the name on both halves
    assert all(engraved.count(name) == twice for name in names)
    wide, high = np.ptp(document.require_flat(), axis=0)
    assert first.width > wide
    assert first.height > high
    points = np.concatenate([line.points for line in first.lines])
    assert (points >= 0).all()
    assert (points <= (first.width, first.height)).all()


@pytest.mark.parametrize("family", list(FAMILIES))
def test_what_is_cut_out_is_the_sheet_and_its_joints(family: str) -> None:
    """Areas and scored lengths on the drawings add up to those of the sheet."""
    document, workshop = demo_document(family), stock_for(family)
    layout, sheets = lay_out(document, workshop), draw_sheets(document, workshop)[1:]
    tabs = sum(shapely.Polygon(tab).area for joint in layout.joints for tab in joint.tabs)
    cut = sum(part.area for sheet in sheets for part in closed(sheet))
    assert cut == pytest.approx(document.areas().sum() + tabs, rel=1e-9)
    waste = measure_waste(document, workshop)
    assert waste.used_area == pytest.approx(cut, rel=1e-12)
    assert waste.sheets == len(sheets)
    assert workshop.stock is not None
    assert waste.waste == pytest.approx(1 - cut / (len(sheets) * np.prod(workshop.stock)))
    rims = sum(part.length for sheet in sheets for part in closed(sheet))
    assert waste.cut_length == pytest.approx(rims, rel=1e-9)
    scored = sum(
        shapely.LineString(line.points).length
        for sheet in sheets
        for line in sheet.lines
        if line.layer in ("MOUNTAIN", "VALLEY", "ENGRAVE")
    )
    assert waste.crease_length == pytest.approx(scored, rel=1e-9)


@pytest.mark.slow
@settings(max_examples=examples(8), deadline=None)
@given(
    family=st.sampled_from(list(FAMILIES)),
    share=st.floats(0.25, 1.1),
    shape=st.floats(0.3, 1),
    margin=st.sampled_from([0.0, 0.03]),
    joint=st.sampled_from(["tabs", "strips"]),
)
def test_any_stock(
    family: str, share: float, shape: float, margin: float, joint: JointKind
) -> None:
    document = demo_document(family)
    side = share * float(np.ptp(document.require_flat(), axis=0).max())
    workshop = Workshop(
        stock=(side, shape * side), margin=margin * side, spacing=0.005 * side, joint=joint
    )
    try:
        drawings = draw_sheets(document, workshop)
    except InputError as error:
        if "do not fit the stock" not in str(error):
            raise
        return
    for drawing in drawings[1:] or drawings:
        assert_cuttable(drawing, workshop)


def test_without_stock_there_is_one_drawing_and_the_waste_of_its_box() -> None:
    document = demo_document()
    assert len(draw_sheets(document, Workshop())) == 1
    waste = measure_waste(document, Workshop())
    box = np.prod(np.ptp(document.require_flat(), axis=0))
    assert waste.sheets == 1
    assert waste.waste == pytest.approx(1 - document.areas().sum() / box)
    ends = document.require_flat()[document.mesh.edges]
    length = np.hypot(*(ends[:, 1] - ends[:, 0]).T)
    assert waste.cut_length == pytest.approx(length[~document.mesh.crease].sum())
    assert waste.crease_length == pytest.approx(length[document.mesh.crease].sum())


def test_a_sheet_that_fits_as_it_is_stays_whole_and_is_turned_only_if_need_be() -> None:
    document = demo_document()
    wide, high = np.ptp(document.require_flat(), axis=0)
    for stock in ((wide + 1, high + 1), (high + 1, wide + 1)):
        (drawing,) = draw_sheets(document, Workshop(stock=stock, margin=0.5))
        assert (drawing.width, drawing.height) == stock
        (part,) = closed(drawing)
        assert part.area == pytest.approx(document.areas().sum())
        assert min(part.bounds[:2]) == pytest.approx(0.5)
    upright = draw_sheets(document, Workshop(stock=(wide + 1, high + 1), margin=0.5))[0]
    corners = np.concatenate([line.points for line in upright.lines])
    assert np.ptp(corners, axis=0) == pytest.approx([wide, high])


@pytest.mark.parametrize(
    ("stock", "margin", "key"),
    [((1.0, 1.0), 0.0, "[workshop] stock"), ((10.0, 6.0), 3.0, "[workshop] margin")],
)
def test_impossible_stock_is_refused(stock: tuple[float, float], margin: float, key: str) -> None:
    with pytest.raises(InputError) as caught:
        draw_sheets(demo_document(), Workshop(stock=stock, margin=margin))
    assert caught.value.where == key
    assert caught.value.got
    assert caught.value.expected


def test_a_layout_is_made_once_for_a_flat_sheet_and_its_stock() -> None:
    document, workshop = demo_document(), Workshop(stock=(10.0, 8.0))
    layout = lay_out(document, workshop)
    assert len(layout.parts) > 1
    drawn_otherwise = workshop.replace_unchecked(labels="both", creases="dashes")
    assert lay_out(replace(document, states=(), title="other"), drawn_otherwise) is layout
    assert document.flat is not None
    larger = lay_out(replace(document, flat=document.flat * 1.01), workshop)
    assert larger.parts[0].outlines[0].max() > layout.parts[0].outlines[0].max()
    assert lay_out(document, workshop.replace_unchecked(joint="strips")) is not layout


@pytest.mark.slow
def test_drawings_do_not_depend_on_the_hash_seed() -> None:
    code = (
        f"import sys; sys.path.insert(0, {str(TESTS)!r})\n"
        "from workshop.test_sheets import *\n"
        "for d in draw_sheets(demo_document(), stock_for('parallel-repeating')):\n"
        "    print(d.title, d.texts, [(l.layer, l.points.tolist()) for l in d.lines])\n"
    )
    said = [
        subprocess.run(
            [sys.executable, "-c", code],
            env=os.environ | {"PYTHONHASHSEED": seed},
            capture_output=True,
            check=True,
        ).stdout
        for seed in ("0", "4321")
    ]
    assert len(said[0]) > 10_000
    assert said[0] == said[1]


def length_of(line: Line) -> float:
    points = np.concatenate([line.points, line.points[: int(line.closed)]])
    return float(np.hypot(*np.diff(points, axis=0).T).sum())


MEAN = mean_edge(demo_document())
HOLED = {"relief_hole": 0.05 * MEAN, "corner_gap": 0.02 * MEAN}


@pytest.mark.parametrize("creases", ["score", "dashes", "perforation"])
@pytest.mark.parametrize(
    ("document", "workshop"),
    [
        (demo_document(), Workshop().replace_unchecked(**HOLED)),
        (demo_document(), stock_for("parallel-repeating").replace_unchecked(**HOLED)),
        (slit_document(), Workshop()),
    ],
    ids=["whole", "on stock", "slit"],
)
def test_lengths_are_those_of_what_is_drawn(
    document: Document, workshop: Workshop, creases: CreaseStyle
) -> None:
    """The machine goes along outlines, slits, holes and dashes, as far as they are drawn."""
    workshop = workshop.replace_unchecked(creases=creases)
    sheets = draw_sheets(document, workshop)
    sheets = sheets[len(sheets) > 1 :]  # without the map
    lines = [line for sheet in sheets for line in sheet.lines]
    holes = [circle for sheet in sheets for circle in sheet.circles]
    assert all(hole.layer == "CUT" for hole in holes)
    assert bool(holes) == bool(workshop.relief_hole)
    waste = measure_waste(document, workshop)
    cut = sum(length_of(line) for line in lines if line.layer == "CUT")
    around = sum(2 * np.pi * hole.radius for hole in holes)
    assert waste.cut_length == pytest.approx(cut + around, rel=1e-9)
    along = sum(length_of(line) for line in lines if line.layer not in ("CUT", "LABEL"))
    assert waste.crease_length == pytest.approx(along, rel=1e-9)


def test_lengths_of_what_cannot_be_drawn_are_no_refusal() -> None:
    """The sheet is as it is; its drawing is refused."""
    document, workshop = demo_document(), Workshop(relief_hole=100.0)
    assert measure_waste(document, workshop).crease_length == 0
    with pytest.raises(InputError, match="holes leave too little"):
        draw_sheets(document, workshop)

"""The plan of the ground as a drawing: at true size, and no line goes through words."""

from __future__ import annotations

import csv
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import ezdxf
import numpy as np
import pytest
import shapely

from documents import demo_document
from orishell.document import Document
from orishell.document.ground import GroundFoot, GroundPlan, SweptGround
from orishell.io.format import Settings
from orishell.io.formats.dxf import INSUNITS, write_dxf
from orishell.io.formats.pdf import CAPITALS, write_pdf
from orishell.io.formats.svg import write_svg
from orishell.io.formats.tables import write_tables
from orishell.numerics.arrays import Array
from orishell.workshop.ground_plan import draw_ground, text_box
from orishell.workshop.palettes import Drawing
from orishell.workshop.printed_plan import PAD, ROW, SCALES, print_ground
from orishell.workshop.settings import Paper
from orishell.workshop.tiling import BORDER_MM, PAPERS_MM
from orishell.workshop.title_block import decimal

UNITS = ("mm", "cm", "m", "in", "ft")
ON_THE_GROUND = Settings(ground=True)


def planned(feet: Array, size: float, unit: str = "m") -> Document:
    """A document whose feet (K, 2) stand so, in a square of a size."""
    low = feet.min(axis=0)
    feet = feet - low
    far = float(np.ptp(feet, axis=0).max())
    hull = np.array([[0, 0], [1, 0], [1, 1], [0, 1]]) * far - 0.05 * far
    swept = hull * size + 0.1
    plan = GroundPlan(
        corner=(float(low[0]), float(low[1])),
        feet=tuple(
            GroundFoot(number, (number, 0), x, y, 0.0, 1.0, 2e4, 3e3, 4.0)
            for number, (x, y) in enumerate(feet.tolist(), 1)
        ),
        hull=hull,
        swept=SweptGround(swept, far, far, far**2, 2.5, 1.0, 0.1, 3.0, 0.01, 100),
    )
    return replace(demo_document(), unit=unit, ground=plan)


def arc(count: int, radius: float) -> Array:
    turns = np.linspace(0.1, 2.0, count // 2)
    circle = np.stack([np.cos(turns), np.sin(turns)], axis=-1)
    return np.concatenate([radius * circle, 0.6 * radius * circle])


def lattice(count: int, radius: float) -> Array:
    x = np.linspace(-radius, radius, count // 2)
    return np.concatenate([np.stack([x, np.full_like(x, side)], axis=-1) for side in (0, radius)])


def crowd(count: int, radius: float) -> Array:
    return np.random.default_rng(5).normal(0, radius, (count, 2))


def of(document: Document) -> Drawing:
    drawing = draw_ground(document)
    assert drawing is not None
    return drawing


def require_clear(drawing: Drawing) -> None:
    """No line and no words go through words, and all that is drawn is on the page."""
    boxes = np.array([text_box(text) for text in drawing.texts])
    lines = [
        shapely.LinearRing(line.points) if line.closed else shapely.LineString(line.points)
        for line in drawing.lines
    ]
    rings = [shapely.Point(c.x, c.y).buffer(c.radius) for c in drawing.circles]
    words = shapely.box(*boxes.T)
    tree = shapely.STRtree([*lines, *rings])
    hit = tree.query(words, predicate="intersects")[0]
    assert [drawing.texts[k].words for k in hit] == []
    pairs = shapely.STRtree(words).query(words, predicate="overlaps")
    assert [tuple(drawing.texts[k].words for k in pair) for pair in pairs.T] == []
    points = [line.points for line in drawing.lines]
    everything = np.concatenate([*points, boxes[:, :2], boxes[:, 2:]])
    assert (everything >= 0).all()
    assert (everything <= [drawing.width, drawing.height]).all()


@pytest.mark.parametrize("unit", ["m", "mm", "ft"])
@pytest.mark.parametrize("count", [4, 26, 120])
@pytest.mark.parametrize("shape", [arc, lattice, crowd])
def test_no_line_and_no_words_go_through_words(
    shape: Callable[[int, float], Array], count: int, unit: str
) -> None:
    """With walls beyond the feet, and without."""
    document = planned(shape(count, 40.0 if unit == "ft" else 7.0), 1.1, unit)
    require_clear(of(document))
    plan = document.ground
    assert plan is not None
    away = 0.02 * float(np.ptp(plan.hull))
    walls = (plan.hull[:2] - away, plan.hull[2:] + away)
    require_clear(of(replace(document, ground=replace(plan, walls=walls))))


SMALLEST = 8.0
"""Points: what is read at arm's length."""


@pytest.mark.parametrize(("count", "unit"), [(4, "m"), (30, "mm"), (120, "m"), (400, "m")])
@pytest.mark.parametrize("shape", [arc, lattice, crowd])
def test_printed_words_are_clear_and_large_and_the_table_has_all_feet(
    shape: Callable[[int, float], Array], count: int, unit: str
) -> None:
    document = planned(shape(count, 7.0 if unit == "m" else 7e6), 1.1, unit)
    printed = print_ground(document, "A4")
    assert printed is not None
    assert document.ground is not None
    rows = []
    for page in printed.pages:
        require_clear(page)
        assert min(text.height for text in page.texts) / CAPITALS >= SMALLEST * 25.4 / 72
        ends = [text.words for text in page.texts if text.anchor == "end"]
        rows += [row for row in zip(*[iter(ends)] * 3, strict=True) if row[0] != "foot"]
    assert rows == [
        (str(foot.number), decimal(foot.x, unit), decimal(foot.y, unit))
        for foot in document.ground.feet
    ]


@pytest.mark.parametrize("unit", UNITS)
def test_dxf_is_at_true_size_and_its_audit_finds_nothing(unit: str, tmp_path: Path) -> None:
    document = planned(arc(20, 5.0), 1.2, unit)
    write_dxf(tmp_path / "pattern.dxf", document, ON_THE_GROUND)
    file = ezdxf.readfile(tmp_path / "ground.dxf")
    audit = file.audit()
    assert not audit.errors
    assert not audit.fixes
    assert file.header["$INSUNITS"] == INSUNITS[unit]
    assert document.ground is not None
    (circle,) = file.modelspace().query("CIRCLE")
    corner = np.array(circle.dxf.center)[:2]
    crosses = [
        0.5 * (np.array(line.dxf.start) + np.array(line.dxf.end))[:2] - corner
        for line in file.modelspace().query('LINE[layer=="CUT"]')
    ]
    feet = np.array([(foot.x, foot.y) for foot in document.ground.feet])
    np.testing.assert_allclose(crosses[::2], feet, atol=1e-9)
    np.testing.assert_allclose(crosses[1::2], feet, atol=1e-9)


def test_labels_say_which_feet_have_which_coordinate() -> None:
    document = planned(lattice(8, 3.0), 1.1)
    words = [text.words for text in of(document).texts]
    assert {"1, 5: 0.000", "4, 8: 6.000", "1-4: 0.000", "5-8: 3.000"} <= {*words}
    assert {str(number) for number in range(1, 9)} <= {*words}
    said = " ".join(words)
    assert "North is not known" in said
    assert "20000 N up and 3000 N aside at most" in said


def test_files_are_there_and_table_has_the_feet(tmp_path: Path) -> None:
    document = planned(arc(6, 5.0), 1.2)
    for write, name in (
        (write_svg, "pattern.svg"),
        (write_pdf, "pattern.pdf"),
        (write_tables, "panels.csv"),
    ):
        write(tmp_path / name, document, ON_THE_GROUND)
    assert {"ground.svg", "ground.pdf", "ground.csv"} <= {file.name for file in tmp_path.iterdir()}
    with (tmp_path / "ground.csv").open() as file:
        rows = list(csv.DictReader(file))
    plan = document.ground
    assert plan is not None
    for row, foot in zip(rows, plan.feet, strict=True):
        assert (float(row["x_m"]), float(row["y_m"])) == (foot.x, foot.y)
        assert float(row["world_x_m"]) == plan.corner[0] + foot.x
        assert float(row["pull_N"]) == foot.pull


@pytest.mark.parametrize("radius", [0.05, 3.0, 1e3])
@pytest.mark.parametrize("paper", PAPERS_MM)
def test_it_is_printed_at_the_largest_usual_scale(radius: float, paper: Paper) -> None:
    document = planned(arc(12, radius), 1.2)
    printed = print_ground(document, paper)
    assert printed is not None
    (page,) = printed.pages
    assert (page.width, page.height) == PAPERS_MM[paper]
    assert f"SCALE 1:{printed.scale} ON {paper}" in [text.words for text in page.texts]
    # At true size over the scale: the corner's circle and the crosses at feet.
    assert document.ground is not None
    (circle,) = page.circles
    (first, *_) = document.ground.feet
    (cross, *_) = (line.points.mean(axis=0) for line in page.lines if line.layer == "CUT")
    np.testing.assert_allclose(
        (cross - [circle.x, circle.y]) * printed.scale / 1000, [first.x, first.y], atol=1e-9
    )
    # Between the lines of words and the table the next scale has no room.
    texts = np.array([(text.x, text.y) for text in page.texts if text.anchor != "middle"])
    outlines = np.concatenate([line.points for line in page.lines if line.layer == "ENGRAVE"])
    drawn, middle = np.ptp(outlines, axis=0), outlines[:, 1].mean()
    above = texts[texts[:, 1] > middle, 1].min() - texts[texts[:, 1] < middle, 1].max()
    room = np.array([page.width - 2 * BORDER_MM, above])
    larger = max(
        (each * 1000**k for k in range(3) for each in SCALES if each * 1000**k < printed.scale),
        default=0,
    )
    if larger:
        assert (drawn * printed.scale / larger + 2 * PAD > room - 2 * ROW).any()


def test_a_shell_without_feet_has_no_plan(tmp_path: Path) -> None:
    document = demo_document()
    assert document.ground is None
    assert draw_ground(document) is None
    assert print_ground(document, "A4") is None
    write_svg(tmp_path / "pattern.svg", document, ON_THE_GROUND)
    assert not (tmp_path / "ground.svg").exists()

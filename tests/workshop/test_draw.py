from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from documents import FAMILIES, demo_document, folded_only
from orishell.conventions.errors import InputError
from orishell.conventions.quantities import MILLIMETRES
from orishell.motion.mesh import build_mesh
from orishell.motion.quads import signed_areas
from orishell.workshop import Drawing, Line, Workshop
from orishell.workshop.cut_parts import whole_sheet
from orishell.workshop.draw import draw_part, part_lines
from orishell.workshop.title_block import round_length


def drawn(family: str, unit: str = "m", factor: float = 1.0, **settings: Any) -> Drawing:
    document = demo_document(family)
    document = replace(document, unit=unit, flat=factor * document.require_flat())
    workshop = Workshop(**settings)
    return draw_part(document, whole_sheet(document), workshop)


def points_of(drawing: Drawing, layers: tuple[str, ...]) -> np.ndarray:
    return np.concatenate([line.points for line in drawing.lines if line.layer in layers])


@pytest.mark.parametrize("unit", MILLIMETRES)
@pytest.mark.parametrize("family", FAMILIES)
def test_everything_lies_on_the_page_with_the_title_block_below_the_sheet(
    family: str, unit: str
) -> None:
    drawing = drawn(family, unit, 1000 / MILLIMETRES[unit], labels="both")
    page = (drawing.width, drawing.height)
    everything = points_of(drawing, ("CUT", "MOUNTAIN", "VALLEY", "ENGRAVE", "LABEL"))
    margin = everything.min(axis=0)
    assert (margin * MILLIMETRES[unit] >= 6 - 1e-9).all()
    np.testing.assert_allclose(everything.max(axis=0) + margin, page, rtol=1e-12)
    sheet = points_of(drawing, ("CUT",))
    labels = points_of(drawing, ("LABEL",))
    assert labels[:, 1].max() < sheet[:, 1].min()
    texts = [(text.x, text.y) for text in drawing.texts if text.layer == "LABEL"]
    assert (np.array(texts) > labels.min(axis=0)).all()
    assert (np.array(texts) < labels.max(axis=0)).all()


@pytest.mark.parametrize("family", FAMILIES)
def test_it_is_drawn_one_to_one_and_the_outer_cut_comes_last(family: str) -> None:
    drawing = drawn(family)
    outline = drawing.lines[-1]
    assert (outline.layer, outline.closed) == ("CUT", True)
    area = demo_document(family).areas().sum()
    assert signed_areas(outline.points) == pytest.approx(area, rel=1e-12)
    order = [line.layer for line in drawing.lines if line.layer != "LABEL"]
    assert order == sorted(order, key=["ENGRAVE", "MOUNTAIN", "VALLEY", "CUT"].index)


def test_straight_runs_of_the_outline_are_one_edge() -> None:
    outline = drawn("parallel-repeating").lines[-1].points
    steps = np.roll(outline, -1, axis=0) - outline
    after = np.roll(steps, -1, axis=0)
    turns = np.arctan2(
        steps[:, 0] * after[:, 1] - steps[:, 1] * after[:, 0], (steps * after).sum(1)
    )
    assert np.abs(turns).min() > 1e-9
    # The border has 44 edges; the middle column's two ends lie on straight runs (F creases).
    assert len(outline) < 44


@pytest.mark.parametrize(("family", "factor"), [("orthodiagonal", 1.0), ("orthodiagonal", 0.03)])
def test_the_scale_bar_is_as_long_as_it_says(family: str, factor: float) -> None:
    drawing = drawn(family, "m", factor)
    (end,) = [
        text for text in drawing.texts if text.words.endswith(" m") and text.anchor == "middle"
    ]
    (start,) = [text for text in drawing.texts if text.words == "0"]
    length = float(end.words.removesuffix(" m"))
    bars = [
        line.points
        for line in drawing.lines
        if line.layer == "LABEL" and line.closed and start.x == pytest.approx(line.points[0, 0])
    ]
    assert [np.ptp(bar[:, 0]) for bar in bars] == pytest.approx([length])
    assert end.x - start.x == pytest.approx(length)


def test_the_title_block_says_title_unit_scale_panels_and_lengths() -> None:
    words = [text.words for text in drawn("orthodiagonal", relief_hole=0.01).texts]
    assert {"orthodiagonal", "SCALE 1:1", "UNIT m"} <= set(words)
    document = demo_document("orthodiagonal")
    ends = document.require_flat()[document.mesh.edges]
    lengths = np.hypot(*(ends[:, 1] - ends[:, 0]).T)
    letters = np.array(document.assignment)
    holes = len(document.mesh.inner_vertices())
    cut = lengths[letters == "B"].sum() + holes * np.pi * 0.01
    assert f"{cut:.3f} m" in words
    assert any(word.startswith(f"{len(document.mesh.faces)} panels") for word in words)


def test_a_long_title_stays_in_its_cell() -> None:
    document = demo_document()
    words = "A very long title " * 20
    drawing = draw_part(replace(document, title=words), whole_sheet(document), Workshop())
    (text,) = [text for text in drawing.texts if text.words == words]
    assert drawing.title == words
    assert text.x + 0.9 * text.height * len(words) < drawing.width


def test_the_title_block_can_be_left_out_by_settings_and_palette() -> None:
    document = demo_document()
    for drawing in (
        drawn("parallel-repeating", title_block=False),
        drawn("parallel-repeating", palette="shop"),
    ):
        assert drawing.texts == ()
        size = np.ptp(document.require_flat(), axis=0)
        margin = 0.5 * (drawing.width - size[0])
        assert drawing.height == pytest.approx(size[1] + 2 * margin)


def test_cuts_within_the_sheet_are_drawn_once() -> None:
    faces = np.array([[0, 3, 4, 1], [1, 4, 5, 2], [3, 6, 7, 4], [4, 7, 8, 5]])
    slit = build_mesh(faces, 9).edges
    cut = (slit == [4, 5]).all(axis=1)
    mesh = build_mesh(faces, 9, slit, cut)
    y, x = np.divmod(np.arange(9), 3)
    document = replace(
        demo_document(),
        mesh=mesh,
        flat=np.column_stack([x, -y]).astype(float),
        assignment=tuple(np.select([cut, mesh.crease], ["C", "V"], "B").tolist()),
        fold_angles_deg=np.zeros(len(cut)),
        grid_shape=None,
    )
    lines, _, _ = part_lines(document, whole_sheet(document), Workshop())
    inner, outer = (line for line in lines if line.layer == "CUT")
    assert inner.points.tolist() == [[1, -1], [2, -1]]
    assert signed_areas(outer.points) == 4


def test_marks_of_a_part_are_drawn_first() -> None:
    document = demo_document()
    mark = Line("ENGRAVE", np.array([[0.0, 0.0], [0.1, 0.0]]))
    lines, _, _ = part_lines(document, replace(whole_sheet(document), marks=(mark,)), Workshop())
    assert lines[0] is mark


def test_a_panel_without_an_area_is_named() -> None:
    document = demo_document()
    flat = document.require_flat().copy()
    corners = document.mesh.faces[14]
    flat[corners[2]] = flat[corners[1]]
    with pytest.raises(InputError, match="panel 1,2 has no area"):
        draw_part(replace(document, flat=flat), whole_sheet(document), Workshop())


def test_a_crease_that_is_called_border_is_refused_and_a_joined_one_is_drawn() -> None:
    """Otherwise it would be neither scored nor cut, and nobody would notice."""
    document = demo_document()
    letters = list(document.assignment)
    edge = letters.index("M")
    panels = sorted(map(document.panel_name, document.mesh.edge_faces[edge].tolist()))
    letters[edge] = "B"
    with pytest.raises(InputError, match=f"edge {edge} is no border") as caught:
        draw_part(replace(document, assignment=tuple(letters)), whole_sheet(document), Workshop())
    assert all(panel in caught.value.what for panel in panels)
    count = len(points_of(drawn("parallel-repeating", corner_gap=0.01), ("ENGRAVE",)))
    letters[edge] = "J"
    joined = replace(document, assignment=tuple(letters))
    drawing = draw_part(joined, whole_sheet(joined), Workshop(corner_gap=0.01))
    assert len(points_of(drawing, ("ENGRAVE",))) == count + 2


def test_what_has_no_flat_sheet_or_no_unit_is_refused() -> None:
    document = demo_document()
    with pytest.raises(InputError, match="needs a unit of length"):
        draw_part(replace(document, unit="unit"), whole_sheet(document), Workshop())
    with pytest.raises(InputError, match="no flat sheet"):
        whole_sheet(folded_only(document))


@pytest.mark.parametrize(
    ("most", "length"),
    [(9.99, 5), (10, 10), (0.3, 0.2), (0.1999, 0.1), (4999, 2000), (5e-3, 5e-3)],
)
def test_bars_have_round_lengths(most: float, length: float) -> None:
    assert round_length(most) == length

"""Boards that are clipped on at the target: parts of the flat pattern, and no part of the sheet."""

from __future__ import annotations

import itertools
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import shapely

from documents import EXAMPLES, demo_document
from orishell.design import Design
from orishell.design.stiffeners import Stiffeners
from orishell.design_file import read_design_file
from orishell.document import Document
from orishell.document.from_design import document_of_motion
from orishell.locking import lock_without_clash
from orishell.locking.gussets import with_gussets
from orishell.motion import FoldingMotion
from orishell.numerics.arrays import Array
from orishell.workshop import Drawing, Workshop
from orishell.workshop.assembly import laid_flat, parts_lying
from orishell.workshop.cut_parts import find_outlines
from orishell.workshop.layout import lay_out
from orishell.workshop.quantities import measure_quantities
from orishell.workshop.sheets import draw_sheets, measure_waste
from samples import led_by

SHELLS = ["figure1", "figure2", "canopy"]  # beside canopy's rows, columns go to and fro


@cache
def clipped(example: str) -> Design:
    file = read_design_file(EXAMPLES / f"{example}.toml")
    return file.pattern.design(file.f, file.g).with_clipped_flaps()


@cache
def document_of(example: str) -> Document:
    design = clipped(example)
    return document_of_motion(FoldingMotion(design.mechanism, 3), "m", clipped=design.clipped)


def outlines(drawing: Drawing) -> list[shapely.Polygon]:
    return [
        shapely.Polygon(line.points)
        for line in drawing.lines
        if line.layer == "CUT" and line.closed
    ]


def stock_for(document: Document, share: float) -> Workshop:
    side = share * float(np.ptp(document.require_flat(), axis=0).max())
    return Workshop(stock=(side, 0.75 * side), margin=0.02 * side, spacing=0.01 * side)


def sides(corners: Array) -> Array:
    """The six distances (..., 6) between the corners (..., 4, k) of panels."""
    pairs = np.array(list(itertools.combinations(range(4), 2)))
    return np.asarray(
        np.linalg.norm(corners[..., pairs[:, 0], :] - corners[..., pairs[:, 1], :], axis=-1)
    )


@pytest.mark.parametrize("example", SHELLS)
def test_boards_meet_the_border_columns_at_the_target(example: str) -> None:
    document = document_of(example)
    assert document.grid_shape is not None
    sheet = document.shell.positions.reshape(*document.grid_shape, 3)
    left, right = (board.shell.positions.reshape(-1, 2, 3) for board in document.attached)
    size = float(np.ptp(sheet.reshape(-1, 3), axis=0).max())
    assert np.abs(left[:, 1] - sheet[:, 0]).max() <= 1e-12 * size
    assert np.abs(right[:, 0] - sheet[:, -1]).max() <= 1e-12 * size


@pytest.mark.parametrize("example", SHELLS)
def test_boards_are_the_flaps_of_the_sheet_that_has_them_folded(example: str) -> None:
    """Panels are congruent, flat and at the target, and fold flat onto each other."""
    document, mechanism = document_of(example), clipped(example).clipped
    assert mechanism is not None
    faces = mechanism.grid.faces_vertices().reshape(mechanism.grid.rows - 1, -1, 4)
    flat = mechanism.positions(0.0).reshape(-1, 3)
    for board, column in zip(document.attached, mechanism.flap_columns, strict=True):
        expected = sides(flat[faces[:, column]])
        for points in (board.require_flat(), board.shell.positions):
            found = sides(points[board.mesh.faces])
            assert found == pytest.approx(expected, rel=1e-11, abs=1e-11)
        folds = board.fold_angles_deg[board.mesh.crease]
        assert np.abs(folds) == pytest.approx(180)
        letters = np.array(board.assignment)
        assert set(letters[~board.mesh.crease]) == {"B"}
        assert (letters[board.mesh.crease] == np.where(folds > 0, "V", "M")).all()


def test_panels_of_boards_are_called_by_the_place_beside_the_sheet() -> None:
    document = document_of("figure1")
    assert document.grid_shape is not None
    rows, columns = document.grid_shape
    left, right = document.attached
    assert [left.panel_name(k) for k in (0, 1)] == ["0,-1", "1,-1"]
    assert right.panel_name(rows - 2) == f"{rows - 2},{columns - 1}"
    everything = laid_flat(document)
    assert everything.panel_name(columns) == document.panel_name(columns)
    assert everything.panel_name(len(document.mesh.faces)) == "0,-1"
    assert laid_flat(everything) is everything


@pytest.mark.parametrize("example", SHELLS)
def test_without_stock_boards_lie_beside_the_sheet(example: str) -> None:
    document = document_of(example)
    (drawing,) = draw_sheets(document, Workshop(labels="panels"))
    parts = outlines(drawing)
    assert len(parts) == 1 + len(document.attached) == 3
    for one, two in itertools.combinations(parts, 2):
        assert one.distance(two) > 0
    found = measure_quantities(document, Workshop())
    assert sum(part.area for part in parts) == pytest.approx(found.area, rel=1e-9)
    assert sum(part.length for part in parts) == pytest.approx(found.outline_length, rel=1e-9)
    written = {text.words for text in drawing.texts}
    assert written >= {board.panel_name(0) for board in document.attached}


def test_parts_over_the_sheet_lie_in_rows_below_all_others() -> None:
    """Gussets and flaps, none of them over another, in rows no longer than what lies above."""
    design = replace(clipped("figure1"), clipped=None)
    lock = lock_without_clash(design)
    gussets = with_gussets(design, lock, Stiffeners(kind="gussets", rows="all", share=0.5), 1e-9)
    document = replace(
        document_of("figure1"), attached=(*document_of("figure1").attached, *gussets.attached)
    )
    lying = [
        shapely.Polygon(flat[find_outlines(part.mesh.loops, flat)[0]])
        for part, flat in zip(document.parts, parts_lying(document), strict=True)
    ]
    for one, two in itertools.combinations(lying, 2):
        assert one.distance(two) > 0
    # But for those at the border, which lie beside it.
    rows = [each for each in lying if each.bounds[3] < lying[0].bounds[1]]
    left, low, right, high = shapely.union_all([e for e in lying if e not in rows]).bounds
    assert 20 < len(rows) <= len(gussets.attached) == len(lying) - 3
    for each in rows:
        assert each.bounds[3] < low
        assert left <= each.bounds[0] < each.bounds[2] <= left + max(right - left, high - low)


def test_quantities_count_boards() -> None:
    document, workshop = document_of("figure2"), Workshop(areal_density=2.0)
    bare = measure_quantities(replace(document, attached=()), workshop)
    found = measure_quantities(document, workshop)
    panels = [len(board.mesh.faces) for board in document.attached]
    assert bare.clipped == 0
    assert found.clipped == found.panels - bare.panels == sum(panels)
    more = sum(float(board.areas().sum()) for board in document.attached)
    assert found.area - bare.area == pytest.approx(more)
    assert found.mass_kg == pytest.approx(2 * found.area)


@pytest.mark.parametrize(
    ("example", "share"),
    led_by(
        sorted(itertools.product(SHELLS, [1.5, 0.5]), key=lambda each: each == ("canopy", 0.5)), 5
    ),
)
def test_boards_are_cut_from_the_stock_as_parts_of_their_own(example: str, share: float) -> None:
    """Whole beside a sheet that fits the stock, and split as it is where they are longer."""
    document = document_of(example)
    workshop = stock_for(document, share)
    layout = lay_out(document, workshop)
    own, everything = len(document.mesh.faces), len(laid_flat(document).mesh.faces)
    panels = np.concatenate([part.panels for part in layout.parts])
    assert (np.sort(panels) == np.arange(everything)).all()
    kinds = [set((part.panels >= own).tolist()) for part in layout.parts]
    assert all(len(kind) == 1 for kind in kinds)
    assert [True in kind for kind in kinds] == sorted(True in kind for kind in kinds)
    assert (len(kinds) == 3) == (share > 1)
    first, *sheets = draw_sheets(document, workshop)
    assert len(sheets) == layout.sheets
    cut = [outlines(sheet) for sheet in sheets]
    assert sum(map(len, cut)) == len(layout.parts)
    for parts in cut:
        for one, two in itertools.combinations(parts, 2):
            assert one.distance(two) >= 0.99 * workshop.spacing
    area = sum(part.area for parts in cut for part in parts)
    assert area == pytest.approx(measure_waste(document, workshop).used_area, rel=1e-9)
    assert {str(part.number) for part in layout.parts} <= {text.words for text in first.texts}
    assert any("Clipped on at the target: parts" in text.words for text in first.texts)


@pytest.mark.parametrize("example", SHELLS)
def test_pieces_of_any_sheet_are_parts_of_their_own(example: str) -> None:
    """The same pieces as one sheet, as another program may list them."""
    everything = laid_flat(document_of(example))
    layout = lay_out(everything, stock_for(everything, 0.5))
    for part in layout.parts:
        assert len(set(everything.mesh.pieces[part.panels].tolist())) == 1
        assert len(part.outlines) == 1


def test_layouts_with_and_without_boards_are_not_confused() -> None:
    document = document_of("figure2")
    workshop = stock_for(document, 0.5)
    bare = lay_out(replace(document, attached=()), workshop)
    assert len(lay_out(document, workshop).parts) > len(bare.parts)


def test_a_sheet_without_boards_is_drawn_as_it_is() -> None:
    document = demo_document()
    assert document.attached == ()
    assert laid_flat(document) is document

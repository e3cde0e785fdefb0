"""Seams of strips: both sides bear one name, and the booklet says when strips are joined."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import replace

import numpy as np
import pytest
import shapely

from orishell.design import PanelSpec
from orishell.document import Document
from orishell.document.from_design import document_of_design
from orishell.families.t_hedral import THedralPattern, design_t_hedral
from orishell.solids import build_panels
from orishell.workshop import Workshop
from orishell.workshop.kit.facts import find_facts
from orishell.workshop.kit.parts import kit_parts
from orishell.workshop.kit.steps import kit_steps
from orishell.workshop.layout import lay_out
from orishell.workshop.palettes import Text
from orishell.workshop.sheets import draw_sheets
from strategies import graph

ROWS, STRIPS = 7, 4


def vault(panel: PanelSpec | None = None) -> Document:
    pattern = THedralPattern(rows=ROWS, columns=STRIPS + 1, flap=0, depth=0.2)
    bare = design_t_hedral(graph("-0.5*x**2", -1.5, 1.5), graph("0", 0, 3), pattern)
    design = replace(bare, panel=panel)
    boards = None if panel is None else build_panels(design, bare.mechanism.target_drive).boards
    return document_of_design(design, "m", frames=5, boards=boards)


@pytest.mark.parametrize("stock", [None, (1.5, 5.0), (1.5, 2.0)])
def test_both_sides_of_a_seam_bear_one_name(stock: tuple[float, float] | None) -> None:
    """Also where strips are parts of their own, or are cut in several parts."""
    document, workshop = vault().as_cut(), Workshop(stock=stock)
    parts = lay_out(document, workshop).parts
    if stock is None:
        (drawing,) = draw_sheets(document, workshop)
        words = [text.words for text in drawing.texts if text.words[:4] in {"1-2a", "3-4h"}]
        assert sorted(words) == ["1-2a", "1-2a", "3-4h", "3-4h"]
        return
    panels = shapely.polygons(document.require_flat()[document.mesh.faces])
    found: dict[str, list[tuple[int, int]]] = defaultdict(list)
    for part in parts:
        for mark in part.marks:
            assert isinstance(mark, Text)
            (panel,) = np.flatnonzero(shapely.contains_xy(panels, mark.x, mark.y)).tolist()
            if panel in part.panels:
                found[mark.words].append(divmod(panel, STRIPS))
    seams = [sorted(sides) for sides in found.values() if sides[0][1] != sides[-1][1]]
    assert len(seams) == (ROWS + 1) * (STRIPS - 1)
    for (row, column), (other_row, other_column) in seams:
        assert (other_row, other_column) == (row, column + 1)


@pytest.mark.parametrize(
    "panel",
    [
        None,
        PanelSpec(thickness=0.01, membrane=0.001),
        PanelSpec(thickness=0.01, construction="bevel", gap=0.002),
    ],
    ids=["bare", "sandwich", "bevel"],
)
def test_the_booklet_joins_strips_before_the_shell_is_folded(panel: PanelSpec | None) -> None:
    document, workshop = vault(panel).as_cut(), Workshop()
    facts = find_facts(document)
    parts = kit_parts(document, workshop, facts)
    steps = kit_steps(document, workshop, facts, parts)
    names = [step.name for step in steps]
    assert facts.strips == STRIPS
    assert names.index("join_strips") < names.index("fold")
    (join,) = (step for step in steps if step.name == "join_strips")
    assert join.joined is not None
    assert len(join.joined) == (ROWS + 1) * (STRIPS - 1)


def test_boards_of_strips_lie_on_their_panels() -> None:
    """Those of the document in a state, and those that are cut."""
    document = vault(PanelSpec(thickness=0.01, membrane=0.001))
    cut = document.as_cut()
    assert document.boards is not None
    panels = shapely.polygons(cut.require_flat()[cut.mesh.faces[document.boards.panels]])
    outlines = shapely.polygons(document.boards.outlines[:, 0, :, :2])
    assert shapely.covers(shapely.buffer(panels, 1e-9), outlines).all()
    state = document.state("open")
    np.testing.assert_allclose(document.boards_in(state), cut.boards_in(cut.state("open")))
    corners = state.positions[document.mesh.faces][document.boards.panels]
    middles = document.boards_in(state).mean(axis=(1, 2))
    away = np.linalg.norm(middles - corners.mean(axis=1), axis=-1)
    assert (away < np.linalg.norm(np.ptp(corners, axis=1), axis=-1) / 4).all()

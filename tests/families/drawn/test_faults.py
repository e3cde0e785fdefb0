"""Where a drawn sheet does not fold, place by place."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from orishell.conventions.errors import DesignError
from orishell.families.drawn.design import design_drawn
from orishell.families.drawn.faults import find_faults
from orishell.motion.drawing import Drawing, drawing_of
from orishell.motion.gridding import find_irregular
from patterns import miura, waterbomb


def refused(drawing: Drawing) -> None:
    """Every sheet that has faults is refused."""
    with pytest.raises(DesignError):
        design_drawn(drawing, fold=None, move=None)


def test_a_sheet_that_folds_has_none() -> None:
    assert find_faults(drawing_of(miura())) == ()
    assert [*find_irregular(miura())] == []


def test_a_letter_that_is_wrong_is_marked_at_both_its_ends() -> None:
    drawing = drawing_of(miura())
    drawing.signs.row[2, 2] *= -1
    refused(drawing)
    marks = find_faults(drawing)
    ends = drawing.flat[3, [2, 3]]
    assert sorted((each.x, each.y) for each in marks) == sorted(map(tuple, ends.tolist()))
    assert all("three creases" in each.what for each in marks)


def test_panels_round_a_vertex_out_of_place_are_marked() -> None:
    drawing = drawing_of(miura(9, 10))
    flat = drawing.flat.copy()
    flat[5, 4] += 0.1 * drawing.shortest
    moved = replace(drawing, flat=flat)
    refused(moved)
    marks = find_faults(moved)
    # Its directions changed, and those of the vertices beside it: panels round any of these.
    inner = flat[1:-1, 1:-1]
    middles = (inner[1:, 1:] + inner[1:, :-1] + inner[:-1, 1:] + inner[:-1, :-1]) / 4
    row, column = np.indices(middles.shape[:2])
    near = np.abs(row + 0.5 - 4) + np.abs(column + 0.5 - 3) <= 2
    found = np.array([[each.x, each.y] for each in marks])
    apart = np.linalg.norm(found[:, None] - middles[near], axis=2)
    assert len(found) == near.sum() == 12
    assert apart.min(axis=0).max() < 1e-9


def test_every_panel_that_makes_no_grid_is_marked() -> None:
    pattern = waterbomb()
    marks = [*find_irregular(pattern)]
    assert len(marks) == ((pattern.faces >= 0).sum(axis=1) != 4).sum() > 1
    assert {each.what for each in marks} == {"a panel of 3 vertices"}

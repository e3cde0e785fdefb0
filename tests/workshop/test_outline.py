from random import Random

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from documents import FAMILIES, demo_document
from orishell.motion.quads import signed_areas
from orishell.workshop.cut_parts import (
    find_outlines,
    whole_sheet,
    without_straight,
)


def squares(present: list[list[bool]]) -> tuple[np.ndarray, np.ndarray]:
    """Unit squares of a board, seen from +z, with the vertices numbered row by row."""
    rows, columns = np.nonzero(np.array(present))
    width = len(present[0]) + 1
    corners = np.stack([rows, rows + 1, rows + 1, rows], axis=-1) * width
    faces = corners + np.stack([columns, columns, columns + 1, columns + 1], axis=-1)
    y, x = np.divmod(np.arange((len(present) + 1) * width), width)
    return faces, np.column_stack([x, -y]).astype(float)


@pytest.mark.parametrize("family", FAMILIES)
def test_the_outline_goes_once_along_every_border_edge_and_encloses_all_panels(family: str) -> None:
    document = demo_document(family)
    (outline,) = whole_sheet(document).outlines
    flat, mesh = document.require_flat(), document.mesh
    border = flat[mesh.edges[~mesh.crease]]
    steps = np.roll(outline, -1, axis=0) - outline
    assert len(outline) == len(border)
    assert np.hypot(*steps.T).sum() == pytest.approx(
        np.hypot(*(border[:, 1] - border[:, 0]).T).sum(), rel=1e-12
    )
    assert signed_areas(outline) == pytest.approx(document.areas().sum(), rel=1e-12)


def test_holes_are_clockwise_and_come_after_what_is_around_them() -> None:
    faces, flat = squares([[True] * 3, [True, False, True], [True] * 3])
    outer, hole = find_outlines(faces, flat)
    assert [float(signed_areas(flat[loop])) for loop in (outer, hole)] == [9.0, -1.0]
    assert (outer[0], hole[0]) == (0, 5)


def test_outlines_that_touch_at_a_vertex_do_not_cross() -> None:
    faces, flat = squares([[True, False], [False, True]])
    assert [signed_areas(flat[loop]) for loop in find_outlines(faces, flat)] == [1.0, 1.0]


@given(
    st.lists(st.lists(st.booleans(), min_size=4, max_size=4), min_size=1, max_size=4),
    st.randoms(use_true_random=False),
)
def test_any_board_has_outlines_of_its_area_however_panels_are_listed(
    board: list[list[bool]], random: Random
) -> None:
    faces, flat = squares(board)
    loops = find_outlines(faces, flat)
    assert sum(float(signed_areas(flat[loop])) for loop in loops) == len(faces)
    order = random.sample(range(len(faces)), len(faces))
    turned = np.array([random.random() < 0.5 for _ in faces], dtype=bool)
    others = np.where(turned[:, None], faces[:, ::-1], faces)[order]
    again = find_outlines(others.reshape(-1, 4), flat)
    assert sorted(loop.tolist() for loop in again) == sorted(loop.tolist() for loop in loops)


def test_points_on_straight_runs_are_left_out() -> None:
    square = np.array([[0, 0], [1, 0], [2, 0], [2, 1], [2, 2], [0, 2], [0, 1.5], [0, 1]], float)
    assert without_straight(square).tolist() == [[0, 0], [2, 0], [2, 2], [0, 2]]

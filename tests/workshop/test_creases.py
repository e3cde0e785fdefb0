from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from documents import FAMILIES, demo_document
from orishell.conventions.errors import InputError
from orishell.document import Document
from orishell.motion.mesh import build_mesh
from orishell.workshop import Workshop
from orishell.workshop.creases import crease_lines, mean_edge, relief_holes
from orishell.workshop.cut_parts import whole_sheet
from orishell.workshop.palettes import Line

Array = NDArray[np.float64]
LETTERS = {"MOUNTAIN": "M", "VALLEY": "V"}


def board(rows: int, columns: int, size: float = 1.0) -> Document:
    """Squares in rows and columns, all their creases valleys."""
    numbers = np.arange((rows + 1) * (columns + 1)).reshape(rows + 1, columns + 1)
    faces = np.stack(
        [numbers[:-1, :-1], numbers[1:, :-1], numbers[1:, 1:], numbers[:-1, 1:]], axis=-1
    ).reshape(-1, 4)
    mesh = build_mesh(faces, numbers.size)
    y, x = np.divmod(np.arange(numbers.size), columns + 1)
    names = np.where(mesh.crease, "V", "B")
    return Document(
        "board",
        "mm",
        mesh,
        tuple(names.tolist()),
        size * np.column_stack([x, -y]).astype(float),
        np.zeros(len(mesh.edges)),
        (),
        (rows + 1, columns + 1),
        {},
    )


def lines_of(document: Document, **settings: Any) -> tuple[Line, ...]:
    workshop = Workshop(**settings)
    return crease_lines(document, whole_sheet(document), workshop)


def lengths(lines: list[Line]) -> Array:
    return np.array([np.hypot(*(line.points[1] - line.points[0])) for line in lines])


def edge_lengths(document: Document) -> Array:
    ends = document.require_flat()[document.mesh.edges]
    return np.asarray(np.hypot(*(ends[:, 1] - ends[:, 0]).T))


def creases_of(document: Document, lines: list[Line]) -> NDArray[np.int64]:
    """Number of the folding crease that each line lies on: the one nearest to its ends."""
    ends = document.require_flat()[document.mesh.edges]
    folding = np.array([letter in "MV" for letter in document.assignment])
    first, second = ends[:, 0][None, None], ends[:, 1][None, None]
    points = np.array([line.points for line in lines])[:, :, None]
    beyond = np.hypot(*np.moveaxis(points - first, -1, 0)) + np.hypot(
        *np.moveaxis(points - second, -1, 0)
    )
    away = (beyond - edge_lengths(document)).max(axis=1)
    away[:, ~folding] = np.inf
    assert away.min(axis=1).max() < 1e-9
    return np.asarray(away.argmin(axis=1))


@pytest.mark.parametrize("family", FAMILIES)
def test_scores_have_the_lengths_of_the_creases_by_assignment(family: str) -> None:
    document = demo_document(family)
    lines = lines_of(document)
    letters = np.array(document.assignment)
    for layer, letter in LETTERS.items():
        drawn = lengths([line for line in lines if line.layer == layer]).sum()
        assert drawn == pytest.approx(edge_lengths(document)[letters == letter].sum(), rel=1e-12)
    unfolded = lengths([line for line in lines if line.layer == "ENGRAVE"]).sum()
    assert unfolded == pytest.approx(edge_lengths(document)[letters == "F"].sum(), rel=1e-12)


def test_scores_run_through_vertices_where_nothing_stops_them() -> None:
    straight = lines_of(board(4, 3))
    assert sorted(lengths(list(straight)).tolist()) == [3, 3, 3, 4, 4]
    assert len(lines_of(board(4, 3), corner_gap=0.1)) == 4 * 2 + 3 * 3


def test_a_run_ends_where_the_layer_changes() -> None:
    document = board(4, 2)
    upright = document.mesh.crease & (np.ptp(document.mesh.edges, axis=1) == 3)
    assignment = np.array(document.assignment)
    assignment[np.flatnonzero(upright)[:1]] = "M"
    lines = lines_of(replace(document, assignment=tuple(assignment.tolist())))
    assert lengths([line for line in lines if line.layer == "MOUNTAIN"]).tolist() == [1]
    assert sorted(lengths([line for line in lines if line.layer == "VALLEY"])) == [2, 2, 2, 3]


@pytest.mark.parametrize("family", FAMILIES)
def test_dashes_cut_exactly_their_share_of_every_crease(family: str) -> None:
    document = demo_document(family)
    lines = [
        line for line in lines_of(document, creases="dashes", duty=0.6) if line.layer in LETTERS
    ]
    creases = creases_of(document, lines)
    cut = np.bincount(creases, lengths(lines), minlength=len(document.assignment))
    folding = np.array([letter in "MV" for letter in document.assignment])
    np.testing.assert_allclose(cut[folding] / edge_lengths(document)[folding], 0.6, rtol=1e-9)
    dash = mean_edge(document) / 4
    counts = np.bincount(creases, minlength=len(folding))[folding]
    np.testing.assert_array_equal(
        counts, np.maximum(np.rint(edge_lengths(document)[folding] / dash), 1)
    )


@pytest.mark.parametrize("family", FAMILIES)
def test_lines_are_in_the_layer_of_their_crease(family: str) -> None:
    document = demo_document(family)
    for style in ("dashes", "perforation"):
        lines = [line for line in lines_of(document, creases=style) if line.layer in LETTERS]
        letters = np.array(document.assignment)[creases_of(document, lines)]
        assert letters.tolist() == [LETTERS[line.layer] for line in lines]


@pytest.mark.parametrize("style", ["score", "dashes", "perforation"])
@pytest.mark.parametrize("family", FAMILIES)
def test_nothing_of_a_crease_is_nearer_to_a_vertex_than_the_gap(family: str, style: str) -> None:
    document = demo_document(family)
    gap = 0.05 * mean_edge(document)
    shortest = edge_lengths(document)[document.mesh.crease].min()
    gap = min(gap, 0.4 * shortest)
    points = np.array([line.points for line in lines_of(document, creases=style, corner_gap=gap)])
    flat = document.require_flat()
    away = np.hypot(*np.moveaxis(points.reshape(-1, 1, 2) - flat, -1, 0)).min(axis=1)
    assert away.min() >= gap * (1 - 1e-9)
    if style == "score":
        np.testing.assert_allclose(away, gap, rtol=1e-9)


@given(
    size=st.floats(0.1, 1000),
    share=st.just(0.0) | st.floats(1e-12, 0.4),
    fineness=st.floats(0.1, 60),
    duty=st.floats(0.05, 0.95),
    style=st.sampled_from(["dashes", "perforation"]),
)
def test_any_cuts_are_even_symmetric_apart_and_no_more_than_their_share(
    size: float, share: float, fineness: float, duty: float, style: str
) -> None:
    document = board(1, 2, size=size)
    gap, dash = share * size, size / fineness
    lines = lines_of(document, creases=style, dash=dash, duty=duty, corner_gap=gap)
    spans = np.sort([sorted(-line.points[:, 1]) for line in lines], axis=0)
    small = 1e-9 * size
    np.testing.assert_allclose(spans, size - spans[::-1, ::-1], atol=small)
    cuts, bridges = spans[:, 1] - spans[:, 0], spans[1:, 0] - spans[:-1, 1]
    assert spans[0, 0] >= gap - small
    assert cuts.sum() <= duty * size + small
    assert np.ptp(cuts) <= small
    assert cuts.min() > 0
    if len(bridges):
        assert np.ptp(bridges) <= small
        assert bridges.min() > 0
    if style == "perforation":
        assert cuts[0] <= duty * dash + small
        room = size - 2 * max(gap, 0.5 * (1 - duty) * dash)
        most = max(int((room + (1 - duty) * dash) / dash * (1 + 1e-9)), 1)
        assert len(cuts) == most
        if most * dash <= size and cuts[0] < size - 2 * gap - small:
            assert cuts[0] == pytest.approx(duty * dash, rel=1e-9)
    elif len(cuts) > 1 and 2 * gap < (1 - duty) * size / len(cuts):
        assert cuts.sum() == pytest.approx(duty * size, rel=1e-9)


@pytest.mark.parametrize("family", FAMILIES)
@pytest.mark.parametrize("style", ["score", "dashes"])
def test_holes_are_at_inner_vertices_and_creases_end_at_their_rims(family: str, style: str) -> None:
    document = demo_document(family)
    diameter = 0.1 * edge_lengths(document)[document.mesh.crease].min()
    workshop = Workshop(relief_hole=diameter, corner_gap=0.0, creases="score")
    holes = relief_holes(document, whole_sheet(document), workshop)
    rows, columns = document.grid_shape or (0, 0)
    assert len(holes) == (rows - 2) * (columns - 2)
    assert {hole.radius for hole in holes} == {0.5 * diameter}
    centres = np.array([(hole.x, hole.y) for hole in holes])
    lines = lines_of(document, relief_hole=diameter, creases=style)
    points = np.array([line.points for line in lines]).reshape(-1, 1, 2)
    away = np.hypot(*np.moveaxis(points - centres, -1, 0)).min(axis=1)
    assert away.min() >= 0.5 * diameter * (1 - 1e-9)
    if style == "score":
        inner = np.isclose(away, 0.5 * diameter, rtol=1e-9)
        assert inner.sum() == 4 * len(holes)


@pytest.mark.parametrize("key", ["relief_hole", "corner_gap"])
@pytest.mark.parametrize("family", FAMILIES)
def test_too_large_holes_and_gaps_are_refused_and_the_quoted_limit_works(
    family: str, key: str
) -> None:
    document = demo_document(family)
    with pytest.raises(InputError) as fault:
        lines_of(document, **{key: mean_edge(document)})
    assert fault.value.where == f"[workshop] {key}"
    limit = float(fault.value.expected.removeprefix("at most ").removesuffix(f" {document.unit}"))
    assert lines_of(document, **{key: limit})
    with pytest.raises(InputError):
        lines_of(document, **{key: 1.01 * limit})


def test_the_limits_of_a_board_are_known() -> None:
    document = board(3, 3, size=10.0)
    # Two holes on an edge of 10 mm, a tenth of which stays: 9 mm; gaps twice: 4.5 mm.
    with pytest.raises(InputError, match=r"at most 8\.991 mm"):
        lines_of(document, relief_hole=9.01)
    with pytest.raises(InputError, match=r"at most 4\.495 mm"):
        lines_of(document, corner_gap=4.51)


def test_holes_do_not_reach_across_slender_panels() -> None:
    document = board(3, 3, size=10.0)
    flat = document.require_flat() @ np.array([[1.0, 0.0], [0.95, 0.3]])
    # Rhombi with a short diagonal: (10, 0) - (9.5, 3) has a length of sqrt(9.25).
    with pytest.raises(InputError) as fault:
        lines_of(replace(document, flat=flat), relief_hole=3.0)
    assert fault.value.expected == f"at most {0.9 * 9.25**0.5 * 0.999:.4g} mm"


def test_dashes_too_fine_to_be_written_are_refused() -> None:
    with pytest.raises(InputError, match="too fine"):
        lines_of(board(2, 2), creases="perforation", dash=1e-9)


def test_a_part_without_creases_has_no_lines() -> None:
    assert lines_of(board(1, 1), creases="dashes") == ()

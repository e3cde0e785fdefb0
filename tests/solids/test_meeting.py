"""Where boards of flaps meet at the target: against the corners of the boards as they are there."""

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from orishell.conventions.errors import DesignError
from orishell.design import Construction, PanelSpec, Setback
from orishell.design_file import read_design_file
from orishell.motion import Mechanism
from orishell.motion.boards import Boards
from orishell.numerics.bisection import bisect
from orishell.solids import build_boards, find_meetings, find_stop, largest_folds
from orishell.solids.built import Meetings
from samples import examples, thorough
from strategies import Request, orthodiagonal_requests, requests

EXAMPLES = Path(__file__).parents[2] / "examples"
Built = tuple[Mechanism, PanelSpec, Boards, Meetings]


def built(request: Request, build: PanelSpec) -> Built | None:
    """The sheet with the stop that boards need, and where they meet; None if it has no room."""
    mechanism = request.feasible().mechanism
    try:
        mechanism = mechanism.with_stop(find_stop(mechanism, build))
        folds = largest_folds(mechanism, mechanism.target_drive)
        boards = build_boards(mechanism.positions(0.0), mechanism.grid, build, folds)
    except DesignError:
        return None
    return mechanism, build, boards, find_meetings(mechanism, build, folds, boards)


def example(figure: int) -> Mechanism:
    file = read_design_file(EXAMPLES / f"figure{figure}.toml")
    return file.pattern.design(file.f, file.g).mechanism


def edges_at(mechanism: Mechanism, boards: Boards, found: Meetings, drive: float) -> np.ndarray:
    """Ends (M, 2 boards, 2, 3) of the edges that meet, where the boards are in a state."""
    grid, flat = mechanism.grid, mechanism.positions(0.0)
    positions = mechanism.positions(drive).reshape(-1, 3)
    corners = boards.carried(grid.faces_vertices(), flat.reshape(-1, 3)[:, :2], positions)
    closing = mechanism.fold_angles(mechanism.target_drive).row[found.rows, found.columns]
    level = np.where(closing > 0, -1, 0)
    above, below = (corners[found.boards[:, k], level] for k in (0, 1))
    return np.stack([above[:, [1, 2]], below[:, [0, 3]]], axis=1)


def distances(edges: np.ndarray) -> np.ndarray:
    """How far apart the lines of the two edges are (M,)."""
    way = edges[:, 0, 1] - edges[:, 0, 0]
    way /= np.linalg.norm(way, axis=-1, keepdims=True)
    apart = edges[:, 1, 0] - edges[:, 0, 0]
    across = apart - (apart * way).sum(axis=-1, keepdims=True) * way
    return np.asarray(np.linalg.norm(across, axis=-1))


@thorough
@settings(max_examples=examples(30))
@given(
    st.one_of(requests(), orthodiagonal_requests()),
    st.sampled_from(["sandwich", "bevel"]),
    st.floats(0.002, 0.02),
    st.floats(0.0, 4.0),
)
def test_play_is_that_of_the_boards_as_they_are(
    request: Request, construction: Construction, share: float, gap: float
) -> None:
    """Boards that no gap sets back touch, to 1e-12 of their thickness; others are as far apart."""
    size = float(np.linalg.norm(np.ptp(request.feasible().mechanism.positions(0.0), axis=(0, 1))))
    thickness = share * size / 10
    build = PanelSpec().replace_unchecked(
        largest_setback=Setback(share=0.9),
        thickness=thickness,
        construction=construction,
        membrane=0.0 if construction == "bevel" else 0.1 * thickness,
        gap=gap * thickness,
    )
    made = built(request, build)
    if made is None:
        return
    mechanism, _, boards, found = made
    assert len(found.rows) == (mechanism.grid.rows - 2) * len(mechanism.flap_columns)
    fold = np.abs(mechanism.fold_angles(mechanism.target_drive).row[found.rows, found.columns])
    closed = build.height * np.tan(fold / 2) >= build.gap / 2
    assert np.abs(found.plays[closed]).max(initial=0) < 1e-12 * thickness
    assert (found.plays[~closed] > 0).all()
    assert (found.angles >= -1e-12).all()
    edges = edges_at(mechanism, boards, found, mechanism.target_drive)
    np.testing.assert_allclose(distances(edges), found.plays, rtol=0, atol=1e-13 * size)

    # Both edges are parallel to the crease; their common part is as long as is said.
    positions = mechanism.positions(mechanism.target_drive)
    left, right = (positions[found.rows + 1, found.columns + k] for k in (0, 1))
    way = (right - left) / np.linalg.norm(right - left, axis=-1, keepdims=True)
    along = np.sort(np.einsum("mbkx,mx->mbk", edges - left[:, None, None], way), axis=-1)
    common = np.maximum(along[..., 1].min(axis=1) - along[..., 0].max(axis=1), 0.0)
    np.testing.assert_allclose(found.lengths, common, rtol=0, atol=1e-13 * size)


@pytest.mark.parametrize("figure", [1, 2])
def test_a_flap_turns_by_the_angle_until_its_boards_meet(figure: int) -> None:
    """The motion goes on beyond the target: there the play is gone, and boards would cross."""
    sheet = example(figure)
    build = PanelSpec(
        thickness=0.01, membrane=1e-3, gap=0.09, largest_setback=Setback(length=0.046)
    )
    sheet = sheet.with_stop(np.deg2rad(9.0))
    folds = largest_folds(sheet, sheet.target_drive)
    boards = build_boards(sheet.positions(0.0), sheet.grid, build, folds)
    found = find_meetings(sheet, build, folds, boards)
    first = int(found.angles.argmin())
    assert found.angles[first] > 0.01
    row, column = found.rows[first], found.columns[first]
    met = abs(sheet.fold_angles(sheet.target_drive).row[row, column]) + found.angles[first]

    def is_open(drive: float) -> bool:
        return bool(abs(sheet.fold_angles(drive).row[row, column]) <= met)

    drive = bisect(is_open, sheet.target_drive, sheet.end_drive, relative=1e-15)
    there = distances(edges_at(sheet, boards, found, drive))
    assert there[first] == pytest.approx(0, abs=1e-12)
    before = distances(edges_at(sheet, boards, found, sheet.target_drive))
    assert before[first] == pytest.approx(found.plays[first], abs=1e-13)
    assert found.plays[first] > 1e-4


@pytest.mark.parametrize("figure", [1, 2])
def test_flaps_that_fold_flat_have_no_boards_that_meet(figure: int) -> None:
    """The paper's flaps: no board lies on the closing side of their row creases."""
    sheet, build = example(figure), PanelSpec(thickness=0.01, membrane=1e-3)
    folds = largest_folds(sheet, sheet.target_drive)
    boards = build_boards(sheet.positions(0.0), sheet.grid, build, folds)
    assert len(boards)
    assert not len(find_meetings(sheet, build, folds, boards).rows)


def test_cut_corners_shorten_the_line_of_contact() -> None:
    """Edges stand back by 0.03; corners are cut off at 0.08 from every vertex."""
    sheet, build = example(1).with_stop(np.deg2rad(9.0)), PanelSpec(thickness=0.01, membrane=1e-3)
    folds = largest_folds(sheet, sheet.target_drive)
    flat = sheet.positions(0.0)
    whole, cut = (
        find_meetings(sheet, build, folds, build_boards(flat, sheet.grid, build, folds, relief))
        for relief in (None, np.full(flat.shape[:2], 0.08))
    )
    assert (cut.lengths < whole.lengths - 1e-3).all()
    np.testing.assert_array_equal(cut.plays, whole.plays)

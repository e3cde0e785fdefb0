"""Flaps with a stop: the target as without, its flaps open by so much there, rigid all the way."""

from collections.abc import Callable
from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from orishell.conventions.errors import DesignError
from orishell.design import Design
from orishell.families.orthodiagonal import (
    Orthodiagonal,
    OrthodiagonalPattern,
    design_orthodiagonal,
)
from orishell.families.parallel_repeating import (
    ParallelRepeating,
    ParallelRepeatingPattern,
    design_parallel_repeating,
)
from orishell.motion import diagonal, measure_fold_angles
from orishell.motion.grid import crease_signs
from samples import examples
from strategies import Request, graph, orthodiagonal_requests, pair, requests

Sheet = ParallelRepeating | Orthodiagonal
PARABOLA = graph("-x**2", -1, 1)


def parallel() -> Design:
    g = graph("5*sin(pi*x/10)", 0, 20)
    return design_parallel_repeating(
        PARABOLA, g, ParallelRepeatingPattern(rows=9, columns=11, xi_deg=50)
    )


def orthodiagonal() -> Design:
    g = graph("0.25*sin(pi*x/2)", 0, 4)
    return design_orthodiagonal(PARABOLA, g, OrthodiagonalPattern(rows=9, columns=13, depth=0.12))


def sheet_of(design: Design) -> Sheet:
    assert isinstance(design.mechanism, Sheet)
    return design.mechanism


def largest_stop(sheet: Sheet) -> float:
    """Half the smallest zigzag angle beside a flap, measured at the target."""
    inner = sheet.positions(sheet.target_drive)[:, sheet.inner_columns]
    edges = np.diff(inner[:, [0, -1]], axis=0)
    before, after = -edges[:-1], edges[1:]
    cosine = (before * after).sum(-1) / np.linalg.norm(before, axis=-1)
    return float(np.arccos(cosine / np.linalg.norm(after, axis=-1)).min() / 2)


def panel_distances(positions: np.ndarray) -> np.ndarray:
    """The six distances of the corners of every panel (..., 6)."""
    rows, columns = positions.shape[-3] - 1, positions.shape[-2] - 1
    corners = [positions[..., i : i + rows, j : j + columns, :] for i, j in np.ndindex(2, 2)]
    pairs = [np.linalg.norm(a - b, axis=-1) for a, b in combinations(corners, 2)]
    return np.stack(pairs, axis=-1)


@settings(max_examples=examples(120))
@given(
    st.one_of(requests(), orthodiagonal_requests()),
    st.floats(1e-6, 0.99),
    st.integers(0, 2**32 - 1),
)
def test_any_sheet_whose_flaps_have_a_stop(request: Request, share: float, seed: int) -> None:
    sheet = sheet_of(request.feasible())
    if not sheet.flap_columns:
        assert sheet.with_stop(0.1) is sheet
        return
    stop = share * largest_stop(sheet)
    stopped = sheet.with_stop(stop)
    flat = stopped.positions(0.0)
    size = diagonal(flat)
    target, end = stopped.target_drive, stopped.end_drive

    # The inner columns meet the target as they did, and the motion goes on beyond it.
    assert target < end == np.pi
    inner = stopped.inner_columns
    now, before = stopped.positions(target)[:, inner], sheet.positions(np.pi)[:, inner]
    assert np.abs(now - before).max() < 1e-12 * size

    # Panels are rigid, creases fold as the closed form says, also beyond the target.
    random = np.random.default_rng(seed)
    drives = np.concatenate([[target, end], random.uniform(0, end, 8)])
    states, folds = stopped.positions(drives), stopped.fold_angles(drives)
    # Corners are sums along a row and a column: two of them are off by sqrt(3) eps for each
    # summand, and by some more for the rotations of the first.
    rounding = 2 * (sum(flat.shape[:2]) + 8) * np.finfo(float).eps * size
    # At the end the tightest column is folded flat. The slope of another that is hardly wider is
    # the root of a difference there, and has half of its digits; near the end it loses as many as
    # the end is near, for each summand: a quarter of that was seen.
    eps = np.finfo(float).eps
    left = np.maximum(end - drives, np.sqrt(eps))
    half = np.minimum(np.sqrt(eps), 4 * (sum(flat.shape[:2]) + 8) * eps / left)
    off = np.abs(panel_distances(states) - panel_distances(flat)).reshape(len(drives), -1)
    assert (off.max(axis=1) < rounding + half * size).all()
    # An angle is off by what corners are over the width of the panel, too: 0.01 of that was seen.
    sides = flat.reshape(-1, 3)[sheet.grid.faces_vertices()]
    narrow = np.linalg.norm(np.roll(sides, 1, axis=1) - sides, axis=-1).min()
    least = 1e-11 + 0.2 * rounding / narrow
    measured = measure_fold_angles(states)
    for closed, found in ((folds.row, measured.row), (folds.column, measured.column)):
        difference = np.abs((closed - found + np.pi) % (2 * np.pi) - np.pi)
        assert (difference.reshape(len(drives), -1).max(axis=1, initial=0) < least + half).all()

    # The flap crease that folds most is open by twice the stop; none turns over.
    of_flaps = np.abs(stopped.fold_angles(target).row)[:, list(stopped.flap_columns)]
    assert of_flaps.max() == pytest.approx(np.pi - 2 * stop, abs=1e-12 + half[0])
    signs, paper = (crease_signs(each.fold_angles(1.0)).row for each in (stopped, sheet))
    np.testing.assert_array_equal(signs, paper)


@pytest.mark.parametrize("make", [parallel, orthodiagonal])
def test_flaps_are_as_wide_as_without_a_stop(make: Callable[[], Design]) -> None:
    """Square to their column, in the flat sheet."""

    def widths(stop: float) -> list[float]:
        flat = make().mechanism.with_stop(stop).positions(0.0)
        down = flat[1, 1] - flat[0, 1]
        creases = flat[3, [0, -1]] - flat[3, [1, -2]]
        across = np.linalg.norm(np.cross(creases, down / np.linalg.norm(down)), axis=-1)
        return [float(each) for each in across]

    assert widths(0.2) == pytest.approx(widths(0.0), rel=1e-12)


def test_a_stop_of_nothing_changes_no_bit() -> None:
    for design in (parallel(), orthodiagonal()):
        sheet = design.mechanism
        again = sheet.with_stop(0.2).with_stop(0.0)
        drives = np.linspace(0, np.pi, 7)
        assert again.target_drive == again.end_drive == np.pi
        np.testing.assert_allclose(again.positions(drives), sheet.positions(drives), atol=1e-15)
        fresh = sheet.with_stop(0.0)
        assert (fresh.positions(drives) == sheet.positions(drives)).all()
        assert design.with_stop(0.0).parameters == design.parameters


def test_sheets_without_flaps_have_no_stop() -> None:
    for design in (parallel(), orthodiagonal()):
        bare = sheet_of(design).without_flaps()
        assert bare.with_stop(0.2) is bare
        stopped = sheet_of(design.with_stop(0.2)).without_flaps()
        assert (stopped.positions(1.0) == bare.positions(1.0)).all()
        assert "stop_deg" not in replace(design, mechanism=bare).with_stop(0.2).parameters
        assert design.with_stop(0.2).parameters["stop_deg"] == pytest.approx(np.rad2deg(0.2))


def test_cut_flaps_stay_cut() -> None:
    """Each keeps its share of the row creases of the whole flap."""
    f = pair("1.55*cos(t)", "2.3*sin(t)", 0, np.pi)
    design = design_orthodiagonal(
        f, graph("0.1*cos(2*pi*x)", 0, 6), OrthodiagonalPattern(rows=11, columns=13)
    )
    cut = sheet_of(design).with_stop(0.1)
    assert isinstance(cut, Orthodiagonal)
    assert (cut.kept < 1).any()
    whole = replace(cut, kept=np.ones((2, 1)))
    for drive in (0.0, 1.0, cut.target_drive):
        short, long = (
            np.linalg.norm(np.diff(each.positions(drive)[:, :2], axis=1)[:, 0], axis=-1)
            for each in (cut, whole)
        )
        np.testing.assert_allclose(short, cut.kept[0] * long, rtol=1e-12)


@pytest.mark.parametrize("make", [parallel, orthodiagonal])
def test_a_stop_that_is_too_large_is_refused(make: Callable[[], Design]) -> None:
    """Half the sharpest angle beside the flaps is the limit: just below it works."""
    design = make()
    limit = largest_stop(sheet_of(design))
    design.with_stop(limit * (1 - 1e-9))
    for stop in (limit * (1 + 1e-9), 1.5):
        with pytest.raises(DesignError, match="cannot stop so far short") as refused:
            design.with_stop(stop)
        assert refused.value.keys == ("panel.stop_deg",)
        for remedy in refused.value.candidates:
            value = remedy.changes["panel.stop_deg"]
            assert isinstance(value, float)
            design.with_stop(float(np.deg2rad(value)))

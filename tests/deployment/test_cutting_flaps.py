"""When flaps shut that are cut with errors: two states of a sheet, a sector wrong by an angle."""

from __future__ import annotations

import numpy as np
import pytest

from deployment.test_cutting import fit_of, mechanism
from families.flat_foldable.test_slit_flaps import sheet_of
from orishell.deployment.cutting import measure_cutting
from orishell.deployment.cutting.flaps import Shutting
from orishell.deployment.cutting.gaps import Fit
from orishell.deployment.cutting.shape import Shape
from orishell.deployment.cutting.sheet import CutSheet
from orishell.numerics.arrays import Array


def test_flaps_shut_as_fast_as_the_shell_closes() -> None:
    """Angles between hinges of flaps change as in two states of the sheet without flaps."""
    whole = mechanism("figure1")
    sheet = CutSheet.of(whole, whole.target_drive)
    fit = Fit.of(sheet)
    shutting = Shutting.of(fit, Shape.of(fit))
    assert shutting is not None
    pairs = shutting.pairs
    assert len(pairs.vertices) == 18  # nine rows at either side
    assert np.abs(shutting.lacking).max() < 1e-6  # flaps fold flat
    # By the motion without flaps, as the difference of two states.
    bare = whole.without_flaps()
    places = np.flatnonzero(np.isin(np.arange(sheet.mesh.vertex_count), pairs.vertices))
    step = 1e-5
    at = [bare.positions(bare.target_drive + each).reshape(-1, 3) for each in (-step, step)]
    column = whole.inner_columns.start
    number = np.full(sheet.mesh.vertex_count, -1)
    grid = whole.grid.vertices()[:, whole.inner_columns]
    number[grid.ravel()] = np.arange(grid.size)
    assert column == 1
    assert len(places) == 18
    change = np.diff(
        [_angles(each, number[pairs.ends], number[pairs.vertices]) for each in at], axis=0
    )
    rates = change[0] / (2 * step)
    assert shutting.rates / shutting.rates[0] == pytest.approx(rates / rates[0], rel=1e-3)


def _angles(points: Array, ends: Array, vertices: Array) -> Array:
    """Angles (P,) at vertices between two ends (P, 2)."""
    arms = points[ends] - points[vertices][:, None]
    arms /= np.linalg.norm(arms, axis=-1, keepdims=True)
    return np.asarray(np.arccos((arms[:, 0] * arms[:, 1]).sum(axis=-1)))


def test_flaps_cut_wrong_alone_stop_the_shell_by_their_sectors() -> None:
    """The shell is exact, and one flap's sector too large by a known angle: it shuts earlier."""
    fit = fit_of("figure1")
    sheet = fit.sheet
    shutting = Shutting.of(fit, Shape.of(fit))
    assert shutting is not None
    pairs, which = shutting.pairs, 4
    moves = np.zeros((sheet.loops.size, 2, 1))
    sides = {}
    for side in (0, 1):
        vertex, outer = sheet.flat[pairs.vertices[which]], sheet.flat[pairs.outer[which]]
        hinge = sheet.flat[pairs.ends[which, side]] - vertex
        crease = outer - vertex
        sides[side] = _angle(hinge, crease)
    wider = max(sides, key=lambda side: sides[side])
    flap, outer = pairs.flaps[which, wider], pairs.outer[which]
    turn = 1e-4
    crease = sheet.flat[outer] - sheet.flat[pairs.vertices[which]]
    hinge = sheet.flat[pairs.ends[which, wider]] - sheet.flat[pairs.vertices[which]]
    way = np.sign(hinge[0] * crease[1] - hinge[1] * crease[0])
    moves[sheet.corner(flap, outer), :, 0] = turn * way * np.array([-crease[1], crease[0]])
    errors = moves.reshape(-1, 1)
    stop, _ = shutting.stop(np.zeros((fit.jacobian.shape[1], 1)), errors)
    # Its hinges then enclose the difference of the sectors, more by the turn.
    expected = turn / shutting.rates[which]
    assert stop[0] == pytest.approx(expected, rel=1e-6)
    assert shutting.closing * stop[0] < 0


def _angle(first: Array, second: Array) -> float:
    cosine = first @ second / np.linalg.norm(first) / np.linalg.norm(second)
    return float(np.arccos(cosine))


@pytest.mark.parametrize("stop", [0.0, 0.2])
def test_flaps_beside_the_sheet_and_with_a_stop_are_measured(stop: float) -> None:
    """Slit flaps lack twice the stop to fold flat at the deepest crease, and then still shut."""
    sheet = sheet_of(0, stop=stop)
    fit = Fit.of(CutSheet.of(sheet, sheet.target_drive))
    shutting = Shutting.of(fit, Shape.of(fit))
    assert shutting is not None
    assert shutting.lacking.min() == pytest.approx(2 * stop, abs=1e-6)
    found = measure_cutting(sheet, error=1e-5)
    assert found.flaps is not None
    assert 0 < found.flaps.off < 1e-2
    twice = measure_cutting(sheet, error=2e-5).flaps
    assert twice is not None
    assert twice.off == pytest.approx(2 * found.flaps.off, rel=1e-9)

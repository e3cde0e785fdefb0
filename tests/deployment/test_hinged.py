"""Ties, feet and own weight of whole boards: those of the boards as solids, not of their sheet."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from mechanisms import flat_foldable, parallel, random_net, upright
from orishell.deployment import feet_ties, find_ties, measure_weight
from orishell.deployment.fixings import Fixings
from orishell.deployment.slack import find_slack
from orishell.design import PanelSpec
from orishell.motion import Mechanism, diagonal
from orishell.motion.boards import Boards
from orishell.motion.hinge_lines import IN_CREASES
from orishell.motion.hinges import Hinges
from orishell.numerics.arrays import Array
from orishell.solids.boards import build_boards
from orishell.solids.hinged import find_hinges
from orishell.solids.setbacks import largest_folds

SHEETS: dict[str, Mechanism] = {
    "parallel repeating": parallel(9, 8, plane="bisector", xi_deg=50, flap=0.0),
    "orthodiagonal": upright(7, 6, row="zigzag", depth=0.1, flap=0.0).straightened(),
    "flat-foldable": flat_foldable(random_net(5, 4, 3)),
}
EPSILON = 1e-4


@pytest.fixture(params=SHEETS)
def sheet(request: pytest.FixtureRequest) -> Mechanism:
    return SHEETS[request.param]


def thickness(sheet: Mechanism) -> float:
    return 2e-3 * diagonal(sheet.positions(0.0))


def hinged(sheet: Mechanism) -> Hinges:
    return find_hinges(sheet, PanelSpec(thickness=thickness(sheet), construction="hinged"))


def solids(sheet: Mechanism, hinges: Hinges, drive: float) -> tuple[Boards, Array]:
    """Boards without arms, and corners (B, 2, K, 3) of their outlines in a folded state."""
    flat, grid = sheet.positions(0.0), sheet.grid
    build = PanelSpec(thickness=thickness(sheet), construction="hinged")
    made = build_boards(flat, grid, build, largest_folds(sheet, sheet.target_drive), hinges=hinges)
    boards = made.chosen(~made.arms)
    state = sheet.positions(drive).reshape(-1, 3)
    return boards, boards.carried(grid.faces_vertices(), flat.reshape(-1, 3)[:, :2], state)


def test_ties_are_as_long_as_corners_of_boards_are_apart(sheet: Mechanism) -> None:
    """Corners of solids, the mean of their upper and lower one; they are cut by half a gap of 0."""
    hinges, grid = hinged(sheet), sheet.grid
    last = grid.columns - 1
    first, second, edge = find_ties(
        sheet,
        [((0, 1), (grid.rows - 1, 1)), ((3, 2), (1, 2)), ((0, last), (2, last))],
        sheet.target_drive,
        hinges,
    )
    _, corners = solids(sheet, hinges, sheet.target_drive)
    middle = corners.mean(axis=1).reshape(grid.rows - 1, grid.columns - 1, -1, 3)

    def apart(above: tuple[int, int, int], below: tuple[int, int, int]) -> float:
        return float(np.linalg.norm(middle[above] - middle[below]))

    assert first.length == pytest.approx(apart((0, 1, 0), (grid.rows - 2, 1, 1)), rel=1e-9)
    assert second.length == pytest.approx(apart((1, 2, 0), (2, 2, 1)), rel=1e-9)
    assert edge.length == pytest.approx(apart((0, last - 1, 3), (1, last - 1, 2)), rel=1e-9)


def pairs_of(sheet: Mechanism, hinges: Hinges) -> Fixings:
    rows, columns = range(sheet.grid.rows), range(sheet.grid.columns)
    found = np.array([(a, b, c) for a in rows for b in rows for c in columns if b > a + 1])
    return Fixings(sheet, found[:, :2], found[:, 2], hinges)


def test_accelerations_are_bounded(sheet: Mechanism) -> None:
    """Second differences of vectors between ends reach from 10 to 100 % of their bounds."""
    pairs = pairs_of(sheet, hinged(sheet))
    for drive in (0.3, 0.7 * sheet.target_drive, 0.95 * sheet.end_drive):
        around = drive + EPSILON * np.array([-1.0, 0.0, 1.0])
        places = pairs.at(around)
        apart = places[..., 1, :] - places[..., 0, :]
        second = np.linalg.norm(np.diff(apart, n=2, axis=0)[0], axis=-1) / EPSILON**2
        bound = pairs.accelerations(around[:1], around[-1:])[0]
        assert (second <= bound * (1 + 1e-4) + 1e-6).all()
        plain = replace(pairs, hinges=IN_CREASES).accelerations(around[:1], around[-1:])[0]
        assert (bound > plain).all()


def test_what_is_proved_slack_is_slack(sheet: Mechanism) -> None:
    pairs = pairs_of(sheet, hinged(sheet))
    limit = 0.999 * sheet.end_drive
    found = find_slack(pairs, limit)
    places = pairs.at(np.linspace(sheet.target_drive, limit, 801))
    apart = np.linalg.norm(places[..., 1, :] - places[..., 0, :], axis=-1)
    slack = (apart[1:] < apart[0] * (1 - 1e-9)).all(axis=0)
    assert slack[found.proved].all()
    assert found.proved[slack].mean() > 0.9


def test_own_weight_is_that_of_solids() -> None:
    """Heights of the centre of mass over the feet, and their distance, by volumes of the boards."""
    sheet = SHEETS["orthodiagonal"]
    hinges, grid = hinged(sheet), sheet.grid
    found = measure_weight(sheet, (0, grid.rows - 1), None, hinges=hinges, states=4)
    panels = measure_weight(sheet, (0, grid.rows - 1), None, states=4)
    assert not np.allclose(found.energy, panels.energy, rtol=1e-3)
    for drive, energy, span in zip(found.drives, found.energy, found.span, strict=True):
        boards, corners = solids(sheet, hinges, drive)
        middle = corners.mean(axis=1).reshape(grid.rows - 1, grid.columns - 1, -1, 3)
        first = np.concatenate([middle[0, :, 0], middle[0, -1:, 3]])
        last = np.concatenate([middle[-1, :, 1], middle[-1, -1:, 2]])
        surfaces = boards.surfaces(corners)
        p, q, r = np.moveaxis(surfaces.vertices[surfaces.triangles], 1, 0)
        volume = np.einsum("ti,ti->t", p, np.cross(q, r)) / 6
        centre = (volume[:, None] * (p + q + r) / 4).sum(axis=0) / volume.sum()
        along = (last - first).mean(axis=0)
        # Its feet stay level at the target; other states are turned until they are.
        up = np.array([0.0, 0.0, 1.0]) - along[2] * along / (along @ along)
        height = (centre - 0.5 * (first + last).mean(axis=0)) @ up / np.linalg.norm(up)
        assert energy == pytest.approx(height, abs=1e-6 * diagonal(sheet.positions(0.0)))
        assert span == pytest.approx(np.linalg.norm(last - first, axis=-1).mean(), rel=1e-9)


def test_in_the_flat_sheet_ties_are_as_long_as_those_of_panels(sheet: Mechanism) -> None:
    hinges = hinged(sheet)
    rows = 0, sheet.grid.rows - 1
    pairs = feet_ties(sheet, rows)
    whole = find_ties(sheet, pairs, sheet.target_drive, hinges)
    plain = find_ties(sheet, pairs, sheet.target_drive)
    for board, panel in zip(whole, plain, strict=True):
        assert board.flat == pytest.approx(panel.flat, rel=1e-4)
        assert board.grows is None

"""Second skins under random sheets of both families: rigid, one motion, as far off as asked.

That the second skin and walls keep the contract of folding sheets is asked in ``test_contract.py``.
"""

from __future__ import annotations

import numpy as np
import pytest

from mechanisms import parallel, skin_of
from orishell.families.parallel_repeating import ParallelRepeating
from orishell.motion import diagonal, measure_fold_angles
from orishell.motion.complex import Complex
from orishell.motion.layout import points_of
from orishell.motion.level_skins import LevelSkin, UprightStrip
from orishell.motion.second_skin import INNER, OUTER, SecondSkin
from orishell.motion.skins import Skin
from rigid_rank import freedoms_of_complex, strained
from samples import THOROUGH
from skinned import random_sheet
from t_hedra import random_sheet as random_t_hedron

QUICK, ALL = 16, 150
LEVEL = 1000
"""From this number on sheets are T-hedra, and skins straight below them."""
NUMBERS = (*range(ALL if THOROUGH else QUICK), *range(LEVEL, LEVEL + (ALL if THOROUGH else QUICK)))
FEW = NUMBERS if THOROUGH else (*range(8), *range(LEVEL, LEVEL + 8))


def random_skin(number: int) -> tuple[SecondSkin, Complex]:
    """A skin under a random sheet without flaps, with some of its walls.

    Every second one below a lattice is a staircase of its own.
    """
    draw = np.random.default_rng([number, 3])
    if number >= LEVEL:
        return level_skin(number, draw)
    sheet = random_sheet(number).without_flaps()
    every = slice(0, sheet.grid.columns)
    if number % 2:
        skin = staircase_of_its_own(sheet, every, draw)
        walls = skin.walls()
        chosen = [wall for wall in walls if draw.integers(2)] or [walls[0]]
        return skin, Complex(sheet, skin.carried(chosen))
    half, _ = Skin.under(sheet, every, None).distances()
    gap = float(draw.uniform(0.2, 1.4)) * half
    skin = Skin.under(sheet, every, gap)
    while not (walls := skin.walls()):
        gap *= 0.5
        skin = Skin.under(sheet, every, gap)
    chosen = [wall for wall in walls if draw.integers(2)] or [walls[0]]
    return skin, Complex(sheet, skin.carried(chosen))


def level_skin(number: int, draw: np.random.Generator) -> tuple[LevelSkin, Complex]:
    """A skin straight below a T-hedron, the nearer the less the sheet rises from its ends."""
    sheet = random_t_hedron(number, rows=5, columns=7)
    every = slice(0, sheet.grid.columns)
    gap = float(draw.uniform(0.02, 0.4))
    while not (walls := (skin := sheet.second_skin(every, gap)).walls()):
        gap *= 0.5
    chosen = [wall for wall in walls if draw.integers(2)] or [walls[0]]
    return skin, Complex(sheet, skin.carried(chosen))


def staircase_of_its_own(
    sheet: ParallelRepeating, columns: slice, draw: np.random.Generator
) -> Skin:
    """One of random edges, moved down until it is below the sheet's and walls have room."""
    lattice, mean = sheet.lattice(), float(sheet.lattice().lengths.mean())
    down = 0.05 * mean * np.array([-1.0, 1.0])
    while True:
        edges = 2 * int(draw.integers(1, len(lattice.lengths) + 2))
        steps = np.zeros((edges, 2))
        steps[np.arange(edges), np.arange(edges) % 2] = draw.uniform(0.5, 1.5, edges)
        steps *= np.ptp(lattice.places, axis=0) / steps.sum(axis=0)
        places = lattice.places[0] + np.concatenate([np.zeros((1, 2)), np.cumsum(steps, axis=0)])
        for k in range(40):  # beyond that it is no longer below the sheet
            skin = Skin.along(sheet, columns, places + k * down)
            if skin.shift > 1e-3 * mean and skin.walls():
                return skin


@pytest.mark.parametrize("number", NUMBERS)
def test_panels_stay_what_they_are(number: int) -> None:
    """All distances in every panel with all that hangs on it, and its plane, in 40 states."""
    _, whole = random_skin(number)
    assert max(strained(whole)) < 1e-14


@pytest.mark.parametrize("number", FEW)
def test_it_adds_no_motion_and_takes_none(number: int) -> None:
    """Whichever walls it has, one alone among them."""
    skin, whole = random_skin(number)
    drive = 0.7 * whole.target_drive
    alone = freedoms_of_complex(Complex(whole.sheet, ()), drive)
    assert freedoms_of_complex(whole, drive) == alone
    one = Complex(whole.sheet, skin.carried(skin.walls()[:1]))
    assert freedoms_of_complex(one, drive) == alone


@pytest.mark.parametrize("number", NUMBERS)
def test_lines_lie_on_the_panels_that_they_hang_on(number: int) -> None:
    """In the plane of these, and within them, in states of their own coordinates alone."""
    _, whole = random_skin(number)
    size = diagonal(whole.positions(0.0))
    for drive in np.linspace(0.05, 0.95, 5) * whole.end_drive:
        points, faces = points_of(whole, float(drive)), whole.layout.faces
        for part, hanging in whole.hangings:
            strips = whole.strips[part - 1]
            line = points[whole.firsts[1][part] + strips.grid.vertices()[hanging.line]]
            on = points[faces[whole.panels(hanging.part, hanging.panels, strips.columns)]]
            normal = np.cross(on[:, 1] - on[:, 0], on[:, 3] - on[:, 0])
            normal /= np.linalg.norm(normal, axis=1)[:, None]
            for ends in (line[:-1], line[1:]):
                off = ((ends - on[:, 0]) * normal).sum(axis=1)
                assert np.abs(off).max() < 1e-14 * size
                # On the inner side of all four edges.
                edges = np.roll(on, -1, axis=1) - on
                inside = (np.cross(edges, ends[:, None] - on) * normal[:, None]).sum(axis=-1)
                assert inside.min() > -1e-12 * size**2


@pytest.mark.parametrize("number", NUMBERS)
def test_it_is_as_far_from_the_sheet_as_asked(number: int) -> None:
    """By points all over panels of both skins, of columns that are side by side."""
    skin, whole = random_skin(number)
    gap, most = skin.distances()
    points, layout = points_of(whole, whole.target_drive), whole.layout
    corners = points[layout.faces]
    s, t = (each.ravel()[:, None] for each in np.meshgrid(*[np.linspace(0, 1, 7)] * 2))
    a, b, c, d = corners.swapaxes(0, 1)[..., None, :]
    inside = (1 - s) * ((1 - t) * a + t * b) + s * ((1 - t) * d + t * c)
    outer, inner = (inside[whole.part_of == part] for part in (OUTER, INNER))
    columns = [layout.names[whole.part_of == part, 1] for part in (OUTER, INNER)]
    nearest = np.inf
    for column in range(whole.grid.columns - 1):
        mine = inner[columns[1] == column].reshape(-1, 1, 3)
        near = outer[np.abs(columns[0] - column) <= 1].reshape(1, -1, 3)
        nearest = min(nearest, float(np.linalg.norm(mine - near, axis=-1).min()))
    assert gap * (1 - 1e-9) < nearest
    assert most >= gap


@pytest.mark.parametrize("number", FEW)
def test_vectors_accelerate_no_more_than_edges_in_between(number: int) -> None:
    """Of any two vertices, by differences; the claim of the proof's bounds."""
    _, whole = random_skin(number)
    step, layout = 1e-3, whole.layout
    for share in (0.3, 0.6, 0.9):
        drive = share * whole.end_drive
        near = [points_of(whole, drive + k * step) for k in (-1.0, 0.0, 1.0)]
        swing = (near[0] - 2 * near[1] + near[2]) / step**2
        along, down = whole.edge_accelerations(*(np.array([drive + k * step]) for k in (-1.0, 1.0)))
        first, last = layout.first, layout.last
        low, high = np.minimum(first[:, None], first), np.maximum(last[:, None], last)
        sums = [np.concatenate([[0.0], np.cumsum(each[0])]) for each in (down, along)]
        bound = sum(sums[k][high[..., k]] - sums[k][low[..., k]] for k in (0, 1))
        mine = swing[layout.faces]
        found = np.linalg.norm(mine[:, None, :, None] - mine[None, :, None], axis=-1)
        assert (found.max(axis=(2, 3)) <= bound * (1 + 1e-6) + 1e-6 * np.asarray(bound).max()).all()


def test_it_ends_at_the_height_of_the_ends_of_its_sheet() -> None:
    whole = skin_of(parallel())
    for drive in (0.4, whole.target_drive):
        points, first = points_of(whole, drive), whole.firsts[1]
        sheet, skin = whole.positions(drive), points[first[1] : first[2]]
        ends = skin.reshape(whole.strips[0].grid.rows, -1, 3)[[0, -1], :, 2]
        np.testing.assert_allclose(ends, sheet[[0, -1], :, 2], rtol=0, atol=1e-13)
        assert skin[:, 2].min() > sheet[[0, -1], :, 2].min() - 1e-13


@pytest.mark.parametrize("number", range(ALL if THOROUGH else 6))
def test_columns_are_one_staircase(number: int) -> None:
    """What is asked of a lattice: coordinates, parallel creases, bounds as lengths are."""
    sheet = random_sheet(number).without_flaps()
    lattice, size = sheet.lattice(), diagonal(sheet.positions(0.0))
    for drive in np.linspace(0.1, 0.95, 4) * sheet.end_drive:
        points = sheet.positions(float(drive))
        for column in range(sheet.grid.columns):
            own = points[:, column] - points[0, column]
            solved, *_ = np.linalg.lstsq(lattice.places, own, rcond=None)
            assert np.abs(lattice.places @ solved - own).max() < 1e-14 * size
        along = np.diff(points, axis=1)
        along = along / np.linalg.norm(along, axis=-1)[..., None]
        assert np.abs(along - along[:1]).max() < 1e-12
    _, down = sheet.edge_accelerations(np.array([0.4, 1.0]), np.array([0.5, 1.3]))
    share = down / lattice.lengths
    np.testing.assert_allclose(share, share[:, :1].repeat(share.shape[1], 1), rtol=1e-12)


@pytest.mark.parametrize("number", range(LEVEL, LEVEL + 8))
def test_upright_strips_turn_as_measured(number: int) -> None:
    """About their upright lines, and against the panels that they hang on."""
    _, whole = random_skin(number)
    drives = np.linspace(0.1, 0.9, 5) * whole.end_drive
    for part, strip in enumerate(whole.strips[1:], 2):
        assert isinstance(strip, UprightStrip)
        found = measure_fold_angles(strip.positions(drives)).column
        np.testing.assert_allclose(strip.fold_angles(drives).column, found, rtol=0, atol=1e-12)
        for drive in drives.tolist():
            points, faces = points_of(whole, drive), whole.layout.faces
            for hanging in strip.hung:
                own, on = (
                    points[faces[whole.panels(each, row, strip.columns)]]
                    for each, row in ((part, 0), (hanging.part, hanging.panels))
                )
                normals = [np.cross(p[:, 2] - p[:, 0], p[:, 3] - p[:, 1]) for p in (own, on)]
                one, other = (n / np.linalg.norm(n, axis=1)[:, None] for n in normals)
                cosine = np.abs((one * other).sum(axis=1))
                folds = strip.hung_folds(hanging, drive)
                np.testing.assert_allclose(np.abs(np.cos(folds)), cosine, rtol=0, atol=1e-12)


@pytest.mark.parametrize("number", range(LEVEL, LEVEL + 16))
def test_it_stands_as_high_as_the_ends_of_a_sheet_that_rises(number: int) -> None:
    """Of a T-hedron, at its target; else it ends where the sheet does."""
    skin, whole = random_skin(number)
    assert isinstance(skin, LevelSkin)
    heights = whole.positions(whole.target_drive)[:, 0, 2]
    below = whole.strips[0].positions(whole.target_drive)[:, 0, 2]
    for own, other in ((heights, below), (heights[::-1], below[::-1])):
        crown = int(np.argmax(own))
        rises = crown > 0 and own[: crown + 1].min() > own[0] - skin.shift
        assert other[0] == pytest.approx(own[0] - (0 if rises else skin.shift), abs=1e-12)

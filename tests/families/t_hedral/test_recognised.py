"""T-hedra are known by their vertices, however they lie, and nothing near them is."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from families.t_hedral.test_mechanism import distances
from orishell.families.t_hedral import recognise_t_hedron
from orishell.numerics.arrays import Array
from patterns import egg_box
from t_hedra import random_sheet

TOLERANCE = 1e-6
"""Of vertices, as a share of the size."""


def size_of(points: Array) -> float:
    return float(np.linalg.norm(np.ptp(points.reshape(-1, 3), axis=0)))


def somewhere(points: Array, seed: int) -> Array:
    """The points (rows, columns, 3) moved, mirrored, and listed otherwise."""
    random = np.random.default_rng(seed)
    turn = Rotation.random(random_state=seed).as_matrix()
    turn[2] *= random.choice([-1, 1])
    moved = points @ turn.T + 3 * size_of(points) * random.normal(size=3)
    moved = moved[:: random.choice([-1, 1]), :: random.choice([-1, 1])]
    return moved.swapaxes(0, 1) if random.integers(2) else moved


@pytest.mark.parametrize("seed", range(60))
def test_it_is_known_in_any_state_and_place_with_its_whole_motion(seed: int) -> None:
    """Also where flaps are folded flat; distances of its own states are those of the family."""
    sheet = random_sheet(seed, flaps=seed % 2 == 1)
    for share in (0.2, 0.7, 1.0):
        given = somewhere(sheet.positions(share * sheet.target_drive), seed)
        known = recognise_t_hedron(given, TOLERANCE * size_of(given))
        assert known is not None
        assert known.miss < 1e-12 * size_of(given)
        own, places = known.mechanism, given.reshape(-1, 3)[known.numbers]
        expected = distances(places)
        for part in (0.0, 0.4, 1.0):
            found = distances(own.positions(part * own.end_drive))
            assert np.abs(found - expected).max() < 1e-11 * size_of(given)


@pytest.mark.parametrize("seed", range(40))
def test_a_vertex_that_is_moved_by_a_thousandth_is_none(seed: int) -> None:
    sheet, random = random_sheet(seed), np.random.default_rng(seed)
    given = somewhere(sheet.positions(0.6 * sheet.end_drive), seed)
    size = size_of(given)
    way = random.normal(size=3)
    row, column = (random.integers(count) for count in given.shape[:2])
    way *= size / np.linalg.norm(way)
    given[row, column] += 1e-9 * way
    assert recognise_t_hedron(given, TOLERANCE * size) is not None
    given[row, column] += 1e-3 * way
    assert recognise_t_hedron(given, TOLERANCE * size) is None


def test_other_grids_are_none() -> None:
    random = np.random.default_rng(0)
    rough = random.normal(size=(5, 6, 3))
    box, _ = egg_box()
    flat = np.stack([*np.indices((4, 5)), np.zeros((4, 5))], axis=-1).astype(np.float64)
    arch = np.stack([*np.indices((4, 5)), np.arange(4)[:, None] ** 2 + np.zeros((4, 5))], axis=-1)
    for given in (rough, box.reshape(5, 6, 3), flat, arch):  # rows of the arch fold by themselves
        assert recognise_t_hedron(given, 1e-6 * size_of(given)) is None

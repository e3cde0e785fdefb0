"""The smallest box holds its points, is not larger than any that a search finds, and is known."""

import numpy as np
import pytest
from scipy.optimize import minimize
from scipy.spatial.transform import Rotation

from orishell.deployment import smallest_box

CUBE = np.array([[x, y, z] for x in (0.0, 1) for y in (0.0, 1) for z in (0.0, 1)])
TETRAHEDRON = np.array([[1.0, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]])
OCTAHEDRON = np.concatenate([np.eye(3), -np.eye(3)])


def turned(points: np.ndarray, seed: int = 1) -> np.ndarray:
    return points @ Rotation.random(rng=np.random.default_rng(seed)).as_matrix() + [3.0, -2, 7]


@pytest.mark.parametrize(
    ("points", "sides"),
    [
        (CUBE * [3, 1, 2], (3, 2, 1)),
        (np.concatenate([CUBE, 0.5 * CUBE + 0.25]) * [9, 1, 1e-3], (9, 1, 1e-3)),
        (TETRAHEDRON, (2, 2, 2)),  # it rests on edges only: no face of it lies on a face
        (CUBE[CUBE[:, 2] == 0] * [3, 2, 1], (3, 2, 0)),
        (CUBE[(CUBE[:, 1:] == 0).all(axis=1)] * 5, (5, 0, 0)),
        (np.ones((4, 3)), (0, 0, 0)),
        (np.ones((1, 3)), (0, 0, 0)),
    ],
)
def test_known_bodies(points: np.ndarray, sides: tuple[float, float, float]) -> None:
    points = turned(points)
    box = smallest_box(points)
    np.testing.assert_allclose((box.length, box.width, box.height), sides, atol=1e-13)
    np.testing.assert_allclose(box.axes @ box.axes.T, np.eye(3), atol=1e-14)
    np.testing.assert_allclose(np.ptp(points @ box.axes.T, axis=0), sides, atol=1e-13)
    assert box.volume == pytest.approx(np.prod(sides), abs=1e-12)


def test_a_flat_set_has_the_smallest_rectangle() -> None:
    rng = np.random.default_rng(4)
    for seed in range(20):
        plane = rng.normal(size=(rng.integers(3, 30), 2))
        box = smallest_box(turned(np.pad(plane, ((0, 0), (0, 1))), seed))
        angle = np.linspace(0, np.pi / 2, 2001)
        axes = np.stack([np.cos(angle), np.sin(angle)]), np.stack([-np.sin(angle), np.cos(angle)])
        least = np.prod([np.ptp(plane @ axis, axis=0) for axis in axes], axis=0).min()
        assert least * 0.99 < box.length * box.width <= least
        assert box.height < 1e-13


def searched(points: np.ndarray, rng: np.random.Generator) -> float:
    """The least volume over random turns, the best of which are improved."""
    turns = Rotation.random(1000, rng=rng)
    tried = np.ptp(np.einsum("nij,vj->nvi", turns.as_matrix(), points), axis=1).prod(axis=1)

    def volume(vector: np.ndarray) -> float:
        turn = Rotation.from_rotvec(vector).as_matrix()
        return float(np.ptp(points @ turn.T, axis=0).prod())

    starts = [turns[int(k)].as_rotvec() for k in np.argsort(tried)[:5]]
    return min(float(minimize(volume, start, method="Nelder-Mead").fun) for start in starts)


def test_no_search_finds_a_much_smaller_box_of_random_points() -> None:
    rng = np.random.default_rng(2)
    ratios = []
    for _ in range(12):
        points = rng.normal(size=(rng.integers(4, 30), 3)) * rng.uniform(0.1, 1, 3)
        ratios.append(smallest_box(points).volume / searched(points, rng))
    assert max(ratios) < 1.03
    assert np.median(ratios) < 1 + 1e-9


def test_the_octahedron_is_an_eighth_larger_than_it_could_be() -> None:
    """What the docstring admits: its smallest box rests on edges, and is shortest nowhere."""
    volume = smallest_box(turned(OCTAHEDRON)).volume
    assert volume == pytest.approx(8 / 3, rel=1e-12)
    assert volume / searched(OCTAHEDRON, np.random.default_rng(0)) == pytest.approx(9 / 8, rel=1e-3)


def test_many_points_on_a_sphere() -> None:
    points = np.random.default_rng(3).normal(size=(200, 3))
    points /= np.linalg.norm(points, axis=1)[:, None]
    assert 7 < smallest_box(points).volume < 8


@pytest.mark.parametrize("shape", [np.ones(3), np.array([9.0, 3, 0.01])])
def test_a_body_of_many_corners_has_nearly_the_box_of_all(
    monkeypatch: pytest.MonkeyPatch, shape: np.ndarray
) -> None:
    points = np.random.default_rng(5).normal(size=(450, 3))
    points *= shape / np.linalg.norm(points, axis=1)[:, None]
    found = smallest_box(turned(points))
    monkeypatch.setattr("orishell.deployment.box.MOST_CORNERS", 450)
    assert found.volume < 1.002 * smallest_box(turned(points)).volume

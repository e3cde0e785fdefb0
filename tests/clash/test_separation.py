"""Distances of convex panels: each is proved by a direction along which the gap is as wide."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from brute_force import exact_contacts
from orishell.clash.separation import common_gap, nearest, normals, turning_gap, views_along


def random_quads(seed: int, count: int, spread: float) -> np.ndarray:
    """Convex quadrilaterals (3, 4, P) on circles in random planes."""
    rng = np.random.default_rng(seed)
    angle = np.sort(rng.uniform(0, 2 * np.pi, (count, 4)), axis=1)
    frame = np.linalg.qr(rng.normal(size=(count, 3, 3)))[0]
    circle = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=-1)
    return np.asarray((circle @ frame + spread * rng.normal(size=(count, 1, 3))).T)


def gap_along(direction: np.ndarray, first: np.ndarray, second: np.ndarray) -> np.ndarray:
    """Gap (P,) between pairs seen along directions (3, P), negative if the views overlap."""
    return common_gap(views_along(direction, [(first, second)]))


Corners = list[list[float]]
SQUARE: Corners = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]


def pair(first: Corners, second: Corners) -> tuple[np.ndarray, np.ndarray]:
    return np.array(first, float).T[..., None], np.array(second, float).T[..., None]


@given(st.integers(0, 10_000), st.floats(0.3, 3))
def test_a_distance_is_met_and_cannot_be_less(seed: int, spread: float) -> None:
    # The gap along any direction is at most the distance; where both are equal, both are right.
    first, second = random_quads(seed, 40, spread), random_quads(seed + 1, 40, spread)
    distance, between = nearest(first, second)
    np.testing.assert_allclose(np.linalg.norm(between, axis=0), distance, atol=1e-15)
    apart = distance > 1e-9
    direction = (between / np.where(apart, distance, 1))[:, apart]
    gap = gap_along(direction, first[..., apart], second[..., apart])
    np.testing.assert_allclose(gap, distance[apart], rtol=1e-9, atol=1e-12)


@given(st.integers(0, 10_000))
def test_the_distance_is_zero_just_where_exact_predicates_see_a_crossing(seed: int) -> None:
    first, second = random_quads(seed, 30, 0.7), random_quads(seed + 1, 30, 0.7)
    distance, _ = nearest(first, second)
    faces = np.arange(8).reshape(2, 4)
    for k, apart in enumerate(distance > 0):
        points = np.concatenate([first[..., k].T, second[..., k].T])
        assert apart == (len(exact_contacts(points, faces)) == 0)


@pytest.mark.parametrize(
    ("other", "expected"),
    [
        ([[0.2, 0.2, 1], [0.8, 0.2, 1], [0.8, 0.8, 1], [0.2, 0.8, 1]], 1.0),  # above the middle
        ([[2, 0, 0], [3, 0, 0], [3, 1, 0], [2, 1, 0]], 1.0),  # in the plane, parallel edges
        ([[1, 0, 0], [2, 0, 0], [2, 1, 0], [1, 1, 0]], 0.0),  # an edge in common
        ([[0.2, 0.2, 0], [0.8, 0.2, 0], [0.8, 0.8, 0], [0.2, 0.8, 0]], 0.0),  # inside, coplanar
        ([[0.5, 0.5, -1], [0.5, 0.5, 1], [3, 0.5, 1], [3, 0.5, -1]], 0.0),  # pierced by an edge
        ([[0.5, 0.5, 0.25], [2, 0.5, 2], [3, 0.5, 3], [1, 0.5, 3]], 0.25),  # a corner above
        ([[2, 2, 0], [3, 2, 0], [3, 3, 0], [2, 3, 0]], np.sqrt(2)),  # corner to corner
    ],
)
def test_known_distances(other: Corners, expected: float) -> None:
    first, second = pair(SQUARE, other)
    for a, b in ((first, second), (second, first)):
        assert nearest(a, b)[0][0] == pytest.approx(expected, abs=1e-15)


def test_a_common_gap_is_on_the_same_side_in_both_states() -> None:
    first, above = pair(SQUARE, [[x, y, 1] for x, y, _ in SQUARE])
    below = above - 2 * np.array([0, 0, 1.0])[:, None, None]
    up = normals(first)
    assert common_gap(views_along(up, [(first, above), (first, above)]))[0] == pytest.approx(1)
    assert common_gap(views_along(up, [(first, above), (first, below)]))[0] == pytest.approx(-1)


@given(st.integers(0, 10_000), st.floats(0.3, 3))
def test_a_turning_direction_keeps_panels_apart_all_the_way(seed: int, spread: float) -> None:
    # Corners go straight from the one state to the other; panels need not stay planar for this.
    rng = np.random.default_rng(seed)
    first, second = random_quads(seed, 40, spread), random_quads(seed + 1, 40, spread)
    moved = [each + 0.5 * rng.normal(size=each.shape) for each in (first, second)]
    states = [(first, second), (moved[0], moved[1])]
    directions = [nearest(*state)[1] for state in states]
    directions = [d / np.maximum(np.linalg.norm(d, axis=0), 1e-9) for d in directions]
    gap = turning_gap(*(views_along(direction, states) for direction in directions))
    for share in np.linspace(0, 1, 21):
        at = [(1 - share) * now + share * after for now, after in zip(*states, strict=True)]
        direction = (1 - share) * directions[0] + share * directions[1]
        assert (gap_along(direction, *at) >= gap - 1e-12).all()


def test_a_turning_direction_sees_panels_apart_that_turn_together() -> None:
    # Two long panels close together, turned by half a right angle: no standing direction will do.
    long: Corners = [[0, 0, 0], [10, 0, 0], [10, 1, 0], [0, 1, 0]]
    above: Corners = [[x, y, 0.1] for x, y, _ in long]
    start = pair(long, above)
    cosine = np.sqrt(0.5)
    turn = np.array([[cosine, 0, cosine], [0, 1, 0], [-cosine, 0, cosine]])
    stop = [np.einsum("ij,jpk->ipk", turn, panel) for panel in start]
    states = [start, (stop[0], stop[1])]
    views = [views_along(normals(state[0]), states) for state in states]
    standing = [common_gap(each)[0] for each in views]
    assert max(standing) < 0
    turning = turning_gap(*views)
    assert turning == pytest.approx(0.1 * cosine)


def test_a_panel_of_two_kilometres_is_seen_apart_from_one_beside_it() -> None:
    # Their distance by exact fractions. The line between their nearest points is known to 1e-8 of
    # its direction only, which is three times the distance at the far end of such a panel.
    first = [
        [36.0604150, -4.24261235, -8.73026878e-06],
        [36.0608474, -4.24312865, -2.02983063e-05],
        [45.8331963, 5.32367316, -2.02983063e-05],
        [45.8339908, 5.32539050, -8.73026878e-06],
    ]
    second = [
        [45.8449707, 5.31989116, -8.73026878e-06],
        [49.8398620, 3.31691690, -2.02983063e-05],
        [-1700.38837, 880.908857, -2.02983063e-05],
        [-1704.38326, 882.911831, -8.73026878e-06],
    ]
    corners = np.array(first).T[:, :, None], np.array(second).T[:, :, None]
    distance, between = nearest(*corners)
    assert 5e-6 < distance[0] < 6e-6
    seen = common_gap(views_along(between / distance, [corners]))
    assert seen[0] > 0.999 * distance[0]


def test_panels_side_by_side_are_seen_apart_along_their_plane() -> None:
    """Of a random sheet near 180 degrees: two edges face each other, parallel but for rounding.

    The cross product of these edges is rounding too, and no direction: along it nothing is apart.
    """
    corners = pair(
        [
            [-1.0921022996882066, -0.10846099852366424, -0.3066052602598718],
            [-1.0921022996882066, 8.233174066114833e-15, -3.094335345569309e-15],
            [-0.05220005106511028, 4.94133080165746e-15, -1.8407199281871693e-15],
            [-0.052200051065110276, -0.10846099852366753, -0.30660526025987056],
        ],
        [
            [3.0675068669914496, -0.10846099852367744, -0.30660526025986684],
            [3.0675068669914496, -4.934199536778877e-15, 1.9201265315332006e-15],
            [4.107409286257992, -8.226043341413444e-15, 3.173742154628189e-15],
            [4.107409286257992, -0.10846099852368074, -0.3066052602598657],
        ],
    )
    distance, between = nearest(*corners)
    expected = 3.0675068669914496 + 0.052200051065110276
    assert distance[0] == pytest.approx(expected, rel=1e-12)
    assert gap_along(between / distance, *corners)[0] == pytest.approx(expected, rel=1e-12)

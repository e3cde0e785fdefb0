"""Pieces of surfaces: distances, normals, what lies beside a side, flattened pieces."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from orishell.design import Piece
from orishell.numerics.arrays import Array

CELLS = 64


def cap(half: float = 0.5, cells: int = CELLS) -> Piece:
    """The unit sphere about the origin over a square, rows from the far side to the near one."""
    x = np.linspace(-half, half, cells + 1)
    right, up = np.meshgrid(x, x[::-1])
    points = np.stack([right, up, np.sqrt(1 - right**2 - up**2)], axis=-1)
    return Piece.of_lattice(points, points)


def points_about(piece: Piece, count: int, away: float) -> Array:
    """Random points beside those of a piece, inside its rim."""
    rng = np.random.default_rng(1)
    chosen = piece.vertices[rng.integers(0, len(piece.vertices), count)]
    return chosen * (1 + rng.uniform(-away, away, count))[:, None]


def test_distances_from_a_sphere_are_those_from_its_centre() -> None:
    piece = cap()
    points = points_about(piece, 400, 0.1) + 1e-3
    inside = np.abs(points[:, :2]).max(axis=1) < 0.49
    points = points[inside]
    distances, normals = piece.nearest(points)
    radius = np.linalg.norm(points, axis=-1)
    # Flat triangles alone leave the sphere by cell^2 / 4 = 6e-5; feet that are one triangle off
    # leave away (cell)^2 / 2 = 1e-5.
    assert np.abs(distances - (radius - 1)).max() < 2e-5
    assert np.abs(normals - points / radius[:, None]).max() < 1e-2


def test_on_the_surface_distances_are_of_third_order() -> None:
    rng = np.random.default_rng(2)
    plan = rng.uniform(-0.45, 0.45, (500, 2))
    points = np.column_stack([plan, np.sqrt(1 - (plan**2).sum(axis=1))])
    coarse, fine = (np.abs(cap(cells=n).nearest(points)[0]).max() for n in (16, 32))
    assert coarse < 2e-5
    assert fine < coarse / 6


def test_a_distance_changes_with_its_point_about_as_the_normal_says() -> None:
    """To first order in the size of triangles: their normals turn by 1/64 from side to side."""
    piece = cap()
    points = points_about(piece, 200, 0.02) * 0.99
    points = points[np.abs(points[:, :2]).max(axis=1) < 0.45]
    _, normals = piece.nearest(points)
    assert np.abs(piece.over(points)[1] - normals).max() < 1e-2


def twisted(cells: int = 16) -> Piece:
    """A saddle whose rim twists, z = xy/2 + x^3/10 over |x|, |y| <= 1."""
    x = np.linspace(-1, 1, cells + 1)
    right, up = np.meshgrid(x, x[::-1])
    points = np.stack([right, up, 0.5 * right * up + 0.1 * right**3], axis=-1)
    normals = np.stack([-0.5 * up - 0.3 * right**2, -0.5 * right, np.ones_like(up)], axis=-1)
    return Piece.of_lattice(points, normals / np.linalg.norm(normals, axis=-1, keepdims=True))


def differences(distances: Callable[[Array], Array], points: Array) -> Array:
    """Derivatives (N, 3) of distances by points."""
    steps = 1e-6 * np.eye(3)
    return np.stack(
        [(distances(points + each) - distances(points - each)) / 2e-6 for each in steps], axis=-1
    )


@pytest.mark.parametrize("piece", [cap(cells=16), twisted()])
def test_derivatives_of_distances_are_those_of_differences(piece: Piece) -> None:
    """Everywhere, beyond the rim too, to 1e-8: differences of 1e-6 have 1e-10. n is off by 4 %."""
    rng = np.random.default_rng(3)
    chosen = piece.vertices[rng.integers(0, len(piece.vertices), 400)]
    points = 1.03 * chosen + rng.uniform(-0.1, 0.1, (400, 3))
    distances, slopes = piece.over(points)
    assert np.array_equal(distances, piece.nearest(points)[0])
    assert np.abs(slopes - differences(lambda at: piece.over(at)[0], points)).max() < 1e-8


@pytest.mark.parametrize("side", range(4))
def test_derivatives_of_distances_from_a_side_are_those_of_differences(side: int) -> None:
    """Also where the rim twists: points 0.1 beside the surface, to 1e-8 as above."""
    piece = twisted()
    rng = np.random.default_rng(4)
    chosen = piece.vertices[piece.sides[side]][rng.integers(0, 17, 300)]
    points = chosen + rng.uniform(-0.1, 0.1, (300, 3))
    slopes = piece.beside(side, points)[1]
    assert np.abs(slopes - differences(lambda at: piece.beside(side, at)[0], points)).max() < 1e-8


def test_beyond_the_rim_a_piece_goes_on_in_its_tangent_plane() -> None:
    piece = cap()
    rim = np.array([0.5, 0.0, np.sqrt(0.75)])
    tangent = np.array([np.sqrt(0.75), 0.0, -0.5])
    distances, normals = piece.nearest((rim + 0.2 * tangent + 0.03 * rim)[None])
    assert distances[0] == pytest.approx(0.03, abs=1e-3)
    assert normals[0] == pytest.approx(rim, abs=1e-2)


@pytest.mark.parametrize("side", range(4))
def test_beside_a_side_distances_lie_within_the_surface_and_grow_outwards(side: int) -> None:
    piece = cap()
    # Through the middle of the right side: the tangent plane there, at several distances.
    turn = np.pi / 2 * (1 - side)
    rotation = np.array(
        [[np.cos(turn), -np.sin(turn), 0], [np.sin(turn), np.cos(turn), 0], [0, 0, 1]]
    )
    rim, tangent = np.array([0.5, 0.0, np.sqrt(0.75)]), np.array([np.sqrt(0.75), 0.0, -0.5])
    away = np.array([-0.05, 0.0, 0.1])
    points = rim + away[:, None] * tangent + 0.02 * rim
    distances, slopes = piece.beside(side, points @ rotation.T)
    assert distances == pytest.approx(away, abs=1e-4)
    assert slopes == pytest.approx(np.tile(rotation @ tangent, (3, 1)), abs=1e-3)


def test_sides_run_clockwise_from_corner_to_corner() -> None:
    piece = cap()
    sides = [piece.vertices[side] for side in piece.sides]
    for before, after in zip(sides, sides[1:] + sides[:1], strict=True):
        assert np.array_equal(before[-1], after[0])
    assert sides[0][0, :2] == pytest.approx([-0.5, 0.5])
    assert sides[1][-1, :2] == pytest.approx([0.5, -0.5])


def test_a_flattened_piece_keeps_its_plan_and_has_the_normals_of_its_shape() -> None:
    piece = cap()
    half = piece.flattened(0.5)
    assert half.vertices[:, :2] == pytest.approx(piece.vertices[:, :2], abs=1e-12)
    assert np.ptp(half.vertices[:, 2]) == pytest.approx(0.5 * np.ptp(piece.vertices[:, 2]))
    # The ellipsoid of half the height has the gradient (x, y, 4 z') at its points.
    height = 0.5 * piece.vertices[:, 2]
    gradient = np.column_stack([piece.vertices[:, :2], 4 * height])
    gradient /= np.linalg.norm(gradient, axis=-1, keepdims=True)
    assert half.normals == pytest.approx(gradient, abs=1e-12)


def test_triangles_are_counter_clockwise_seen_from_the_normals() -> None:
    piece = cap()
    p, q, r = (piece.vertices[piece.triangles[:, k]] for k in range(3))
    normals = piece.normals[piece.triangles[:, 0]]
    assert (np.einsum("ij,ij->i", np.cross(q - p, r - p), normals) > 0).all()
    assert np.linalg.norm(np.cross(q - p, r - p), axis=-1).sum() / 2 == pytest.approx(
        1.10257, abs=1e-4
    )  # quadrature of 1/z
    assert piece.diagonal == pytest.approx(np.sqrt(2 + (1 - np.sqrt(0.5)) ** 2), abs=1e-6)

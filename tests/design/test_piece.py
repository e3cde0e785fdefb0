"""Pieces of surfaces: distances, normals, what lies beside a side, flattened pieces."""

from __future__ import annotations

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


def test_a_distance_changes_with_its_point_as_the_normal_says() -> None:
    piece = cap()
    points = points_about(piece, 200, 0.02) * 0.99
    inside = np.abs(points[:, :2]).max(axis=1) < 0.45
    points, step = points[inside], 1e-4
    normals = piece.nearest(points)[1]
    change = np.stack(
        [
            piece.nearest(points + step * axis)[0] - piece.nearest(points - step * axis)[0]
            for axis in np.eye(3)
        ],
        axis=-1,
    ) / (2 * step)
    assert np.abs(change - normals).max() < 1e-2


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
    distances, directions = piece.beside(side, points @ rotation.T)
    assert distances == pytest.approx(away, abs=1e-4)
    assert directions == pytest.approx(np.tile(rotation @ tangent, (3, 1)), abs=1e-3)


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

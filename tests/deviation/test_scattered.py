"""Distances from meshes and formulas: known ones, and those of dense samples."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from orishell.curves import parse_formula_of_two
from orishell.design import FormulaSurface, MeshSurface
from orishell.deviation.measure import measure_distance
from orishell.numerics.arrays import Array


@cache
def cap() -> FormulaSurface:
    formula = parse_formula_of_two("sqrt(1 - x**2 - y**2)", "x", "y")
    return FormulaSurface((formula,), (-0.5, 0.5), (-0.5, 0.5))


@cache
def mesh() -> MeshSurface:
    return MeshSurface.of(cap().piece.vertices, cap().piece.triangles)


def corrugated(height: float = 0.02, count: int = 9) -> Array:
    """A sheet over the cap, its rows by turns above and below it."""
    x = np.linspace(-0.45, 0.45, count)
    right, up = np.meshgrid(x, x[::-1])
    side = np.where(np.arange(count) % 2 == 0, height, -height)[:, None]
    return np.stack([right, up, np.sqrt(1 - right**2 - up**2) + side], axis=-1)


def inside(shell: Array, parts: int) -> Array:
    share = np.linspace(0, 1, parts)
    a, b = (each.ravel()[:, None, None, None] for each in np.meshgrid(share, share))
    low = (1 - b) * shell[:-1, :-1] + b * shell[:-1, 1:]
    high = (1 - b) * shell[1:, :-1] + b * shell[1:, 1:]
    return np.asarray(((1 - a) * low + a * high).reshape(-1, 3))


@pytest.mark.parametrize("which", ["formula", "mesh"])
def test_distances_from_a_sphere_are_those_from_its_centre(which: str) -> None:
    shell = corrugated()
    points = inside(shell, 40)
    known = float(np.abs(np.linalg.norm(points, axis=-1) - 1).max())
    found = measure_distance(shell, cap() if which == "formula" else mesh()).shell_to_surface
    # The mesh lies up to cell^2 / 4 = 1.6e-5 within the sphere; cells are steeper at its rim.
    assert found.max + found.sample_spacing >= known - 3e-5
    assert found.max <= known + found.sample_spacing + 3e-5
    assert found.sample_spacing < 2e-3 * known + 1e-4


def test_bounds_from_scattered_triangles_hold_against_dense_samples() -> None:
    """Of few triangles, whose ridges are sharp, and few samples, both ways."""
    coarse = cap().lattice(0.24)
    surface = MeshSurface.of(coarse.points.reshape(-1, 3), coarse.triangles())
    shell = corrugated(0.05)
    found = measure_distance(shell, surface, samples=1_000)
    dense = measure_distance(shell, surface, samples=60_000)
    for one, other in (
        (found.shell_to_surface, dense.shell_to_surface),
        (found.surface_to_shell, dense.surface_to_shell),
    ):
        assert one.max - other.sample_spacing <= other.max <= one.max + one.sample_spacing
        assert one.rms == pytest.approx(other.rms, rel=0.02)


def test_a_plane_apart_from_a_plane() -> None:
    corners = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0.0]])
    flat = MeshSurface.of(corners, np.array([[0, 1, 2], [0, 2, 3]]))
    x = np.linspace(0, 1, 5)
    right, up = np.meshgrid(x, x[::-1])
    shell = np.stack([right, up, np.full_like(right, 0.1)], axis=-1)
    found = measure_distance(shell, flat)
    for way in (found.shell_to_surface, found.surface_to_shell):
        assert way.max == pytest.approx(0.1, abs=1e-12)
        assert way.rms == pytest.approx(0.1, abs=1e-12)
        assert way.sample_spacing < 1.1e-4


def test_a_mesh_and_a_formula_give_the_same() -> None:
    shell = corrugated()
    one, other = measure_distance(shell, cap()), measure_distance(shell, mesh())
    assert one.max == pytest.approx(other.max, rel=1e-3)
    assert one.rms == pytest.approx(other.rms, rel=1e-2)

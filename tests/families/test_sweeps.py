"""Sweeps over surfaces: known ones are found again, floors are reached, and f and g are the shell.

Figures of floors: the best sweeps with any number of panels, found by another program (numerical
derivatives, other starts); within 10 % of those, or nearer.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from orishell import curve_from_points
from orishell.design import Surface
from orishell.design.piece import Facets, Piece
from orishell.families.longitudinal_linear_repeating.pattern import LongitudinalPattern
from orishell.families.orthodiagonal.pattern import OrthodiagonalPattern
from orishell.families.parallel_repeating.pattern import ParallelRepeatingPattern
from orishell.families.pattern import Pattern
from orishell.families.shared.sweep_fit import SweepLimits, fit_leaning, fit_upright
from orishell.numerics.arrays import Array
from samples import led_by

Height = Callable[[Array, Array], Array]


CELLS = 32


def sphere(x: Array, y: Array) -> Array:
    return np.sqrt(1 - x * x - y * y) - 1


def barrel(x: Array, y: Array) -> Array:
    return np.sqrt(1.25**2 - y * y) - 1.25 + 0 * x


def piece_of(height: Height, ax: float = 1.0, ay: float = 1.0, count: int = CELLS + 1) -> Piece:
    """A piece of z(x, y) over a rectangle, its normals by differences."""
    x, y = np.meshgrid(np.linspace(-ax, ax, count), np.linspace(ay, -ay, count))
    step = 1e-6
    dx = (height(x + step, y) - height(x - step, y)) / (2 * step)
    dy = (height(x, y + step) - height(x, y - step)) / (2 * step)
    normals = np.stack([-dx, -dy, np.ones_like(x)], axis=-1)
    normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
    return Piece.of_lattice(np.stack([x, y, height(x, y)], axis=-1), normals)


def turned(piece: Piece, angle: float) -> Piece:
    c, s = np.cos(angle), np.sin(angle)
    turn = np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])
    facets = Facets(piece.vertices @ turn, piece.normals @ turn, piece.triangles)
    return replace(piece, facets=facets)


@pytest.mark.parametrize(
    ("height", "ax", "ay", "floor"),
    led_by(
        [
            (sphere, 0.5, 0.5, 0.76),
            (lambda x, y: 0.5 * (x * x - y * y) / 2, 1, 1, 3.2),
            (
                lambda x, y: 0.8 * (np.sqrt(1 - x * x / 1.5**2 - y * y) - 1),
                0.825,
                0.55,
                0.73,
            ),
            (lambda x, y: 0.5 * x * y, 1, 1, 3.1),
            (lambda x, y: (x * x - y * y) / 2, 1, 1, 7.8),
            (lambda x, y: 0.2 * (x**3 - 3 * x * y * y), 1, 1, 7.5),
            (lambda x, y: 0.25 * np.sin(np.pi * x) * np.cos(np.pi * y / 2), 1, 1, 6.0),
            (barrel, 1, 1, 0.02),
        ],
    ),
    ids=["cap", "saddle .5", "ellipsoid", "hypar", "saddle 1", "monkey", "free-form", "barrel"],
)
def test_floors_of_moulding_surfaces(height: Height, ax: float, ay: float, floor: float) -> None:
    piece = piece_of(height, ax, ay)
    found = fit_leaning(piece.vertices, SweepLimits("moulding"))
    assert 100 * found.max / piece.diagonal < 1.1 * floor


@pytest.mark.parametrize("angle", led_by([0.4, 2.7, 0.0, 1.5]))
def test_a_cylinder_is_found_whichever_way_it_lies(angle: float) -> None:
    piece = turned(piece_of(barrel), angle)
    for kind in ("moulding", "cylinder"):
        found = fit_upright(piece.vertices, piece.normals, SweepLimits(kind), angle)
        # Half the diagonal of a cell of the lattice.
        assert found.beyond < 1.04 * np.sqrt(2) / CELLS
        assert found.max < 1e-4 * piece.diagonal


def test_a_moulding_surface_is_found() -> None:
    """A quarter of a torus' outside: f, an arc, along a circle."""
    turn, lift = np.meshgrid(np.linspace(0.8, -0.8, 65), np.linspace(0.8, -0.8, 49), indexing="ij")
    radius = 2 + np.sin(lift)
    points = np.stack(
        [radius * np.sin(turn), radius * np.cos(turn), np.cos(lift)], axis=-1
    ).transpose(1, 0, 2)
    normals = np.stack(
        [np.sin(lift) * np.sin(turn), np.sin(lift) * np.cos(turn), np.cos(lift)], axis=-1
    ).transpose(1, 0, 2)
    piece = Piece.of_lattice(points, normals)
    found = fit_upright(piece.vertices, piece.normals, SweepLimits("moulding"))
    assert found.max < 1e-3 * piece.diagonal
    assert found.beyond < 2e-2 * piece.diagonal


FAMILIES: list[Pattern] = [
    ParallelRepeatingPattern(rows=9, columns=9),
    OrthodiagonalPattern(rows=9, columns=9),
    LongitudinalPattern(rows=9, columns=9, sector_deg="auto"),
]


@pytest.mark.parametrize("pattern", FAMILIES, ids=lambda each: type(each).__name__)
@pytest.mark.parametrize("angle", led_by([1.0, 0.0]))
def test_f_and_g_stand_where_the_surface_is(pattern: Pattern, angle: float) -> None:
    piece = turned(piece_of(barrel), angle)
    design = pattern.design_on(SimpleNamespace(piece=piece))
    assert design.approached is not None
    assert isinstance(design.approached.surface, Surface)
    swept = design.approached.surface.lattice(0.05).points.reshape(-1, 3) + design.origin
    assert np.abs(piece.nearest(swept)[0]).max() < 2e-4 * piece.diagonal


@pytest.mark.parametrize("pattern", FAMILIES, ids=lambda each: type(each).__name__)
def test_f_and_g_as_written_are_the_same_shell(pattern: Pattern) -> None:
    """To the last digit: the shell is designed of the points that are written."""
    piece = turned(piece_of(sphere, 0.5, 0.5), 0.3)
    design = pattern.design_on(SimpleNamespace(piece=piece))
    written = design.by_curves
    f, g = (
        curve_from_points(
            written[f"target.{name}.points"], smooth=f"target.{name}.smooth" in written
        )
        for name in "fg"
    )
    keys = {key.removeprefix("pattern."): each for key, each in written.items() if "pattern" in key}
    again = pattern.replace_unchecked(**keys).design(f, g).mechanism
    drive = again.target_drive
    assert drive == design.mechanism.target_drive
    assert (again.positions(drive) == design.mechanism.positions(drive)).all()


def test_a_saddle_is_swept_by_a_convex_arc_where_the_family_needs_one() -> None:
    piece = piece_of(lambda x, y: 0.5 * (x * x - y * y) / 2)
    found = fit_upright(piece.vertices, piece.normals, SweepLimits("cylinder", convex=True))
    assert found.bends(1) or found.bends(-1)

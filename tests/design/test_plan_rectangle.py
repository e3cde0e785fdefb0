"""Parts of meshes over a rectangle in plan: what is cut out, and what is refused by place."""

from __future__ import annotations

import numpy as np
import pytest

from orishell.conventions.errors import InputError
from orishell.curves import parse_formula_of_two
from orishell.design import FormulaSurface, MeshSurface, PlanRectangle
from orishell.families.flat_foldable.pattern import FlatFoldablePattern
from orishell.motion.quads import lengths
from orishell.numerics.arrays import Array, Integers
from samples import thorough

PART = PlanRectangle((0.1, -0.2), (1.1, 0.9), np.deg2rad(25))


def height(x: Array, y: Array) -> Array:
    return np.asarray(0.3 * x * x - 0.2 * x * y)


def grid(cells: int = 40) -> tuple[Array, Integers]:
    """A surface over -1 to 1 each way."""
    x, y = np.meshgrid(np.linspace(-1, 1, cells + 1), np.linspace(-1, 1, cells + 1))
    points = np.stack([x, y, height(x, y)], axis=-1).reshape(-1, 3)
    number = np.arange(len(points)).reshape(cells + 1, cells + 1)
    a, b, c, d = number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1]
    return points, np.stack([a, b, c, a, c, d], axis=-1).reshape(-1, 3)


def plan_area(surface: MeshSurface) -> float:
    p, q, r = np.moveaxis(surface.piece.vertices[surface.piece.triangles], 1, 0)
    return float(0.5 * np.cross(q - p, r - p)[:, 2].sum())


def test_the_part_has_the_area_and_the_corners_of_the_rectangle() -> None:
    surface = MeshSurface.over(PART, *grid())
    assert plan_area(surface) == pytest.approx(1.1 * 0.9, rel=1e-12)
    corners = PART.seen(np.array([surface.piece.vertices[side[0]] for side in surface.piece.sides]))
    assert corners == pytest.approx(PART.corners, abs=1e-12)
    for side, axis in zip(surface.piece.sides, (1, 0, 1, 0), strict=True):
        along = PART.seen(surface.piece.vertices[side])
        assert np.ptp(along[:, axis]) < 1e-12
        assert (np.abs(np.diff(along[:, 1 - axis])) > 0).all()


def test_the_part_has_the_normals_of_the_whole_mesh() -> None:
    """Of 40 cells they are within 2e-3 of the surface's own: its curvature times a cell squared."""
    surface = MeshSurface.over(PART, *grid())
    x, y = surface.piece.vertices[:, :2].T
    true = np.stack([-0.6 * x + 0.2 * y, 0.2 * x, np.ones(len(x))], axis=-1)
    true /= lengths(true)[:, None]
    assert lengths(surface.piece.normals - true).max() < 2e-3


def test_cuts_along_edges_and_through_vertices_leave_no_slivers() -> None:
    surface = MeshSurface.over(PlanRectangle((0.0, 0.0), (1.0, 1.0)), *grid())
    assert len(surface.piece.triangles) == 2 * 20 * 20
    diagonal = MeshSurface.over(PlanRectangle((0.0, 0.0), (0.5, 0.5), np.pi / 4), *grid())
    assert plan_area(diagonal) == pytest.approx(0.25, rel=1e-12)


def test_a_whole_building_serves_as_long_as_the_roof_over_the_rectangle_is_one() -> None:
    """Holes and walls beside the rectangle are left out; triangles face either way."""
    points, triangles = grid()
    holed = np.delete(triangles, [0, 1, 2 * 41, 2 * 41 + 1], axis=0)
    mixed = np.where((np.arange(len(holed)) % 3 == 0)[:, None], holed[:, ::-1], holed)
    wall = np.array([[1, -1, 0], [1, 1, 0], [1, 1, -3.0]]), np.array([[0, 1, 2]])
    both = np.concatenate([points, wall[0]]), np.concatenate([mixed, wall[1] + len(points)])
    assert plan_area(MeshSurface.over(PART, *both)) == pytest.approx(0.99, rel=1e-12)


@thorough
@pytest.mark.slow
def test_a_sheet_fitted_to_part_of_a_mesh_is_the_one_fitted_to_the_formula() -> None:
    """Of 20,000 triangles: 0.057 % of the diagonal was seen, and 0.1 is asked."""
    part, cells = PlanRectangle((0.2, 0.1), (3.5, 3.0), np.deg2rad(20)), 100
    points, triangles = grid(cells)
    points = np.column_stack([3.4 * points[:, :2], points[:, 2]])
    points[:, 2] = np.sqrt(25 - (points[:, :2] ** 2).sum(axis=1))
    formula = FormulaSurface(
        (parse_formula_of_two("sqrt(25 - x**2 - y**2)", "x", "y"),),
        (-1.75, 1.75),
        (-1.5, 1.5),
        part.centre,
        part.turn,
    )
    pattern = FlatFoldablePattern(rows=9, columns=9, direction_deg=0, fold_deg=90)
    sheets = [
        pattern.design_on(surface).mechanism
        for surface in (MeshSurface.over(part, points, triangles), formula)
    ]
    cut, whole = (sheet.positions(sheet.target_drive) for sheet in sheets)
    assert np.abs(cut - whole).max() < 1e-3 * formula.size()


def refused(what: str, vertices: Array, triangles: Integers, part: PlanRectangle = PART) -> str:
    with pytest.raises(InputError, match=what) as error:
        MeshSurface.over(part, vertices, triangles)
    assert error.value.remedy
    return error.value.got


def test_a_rectangle_beyond_the_rim_is_refused_by_place() -> None:
    assert "near (1, " in refused("ends within", *grid(), PlanRectangle((0.7, 0.0), (1.0, 1.0)))
    assert "from (-1, -1)" in refused("no part", *grid(), PlanRectangle((5.0, 0.0), (1.0, 1.0)))


def test_a_hole_within_the_rectangle_is_refused_by_place() -> None:
    points, triangles = grid()
    at = 2 * (40 * 16 + 22)
    assert "(0.125, -0.175" in refused("holes", points, np.delete(triangles, [at, at + 1], axis=0))


def test_two_floors_over_the_rectangle_are_refused() -> None:
    points, triangles = grid()
    low = points - [0, 0, 2]
    got = refused(
        "several pieces",
        np.concatenate([points, low]),
        np.concatenate([triangles, triangles + len(points)]),
    )
    assert got.startswith("2, the smallest near")


def test_what_hangs_over_within_the_rectangle_is_refused_by_place() -> None:
    """An S along x, whose middle third runs back."""
    s = np.linspace(-1, 1, 61)
    x = s - 0.55 * np.sin(np.pi * s) / np.pi * 2
    points = np.stack(np.broadcast_arrays(x[None], s[:, None], 0.5 * s[None]), axis=-1)
    number = np.arange(61 * 61).reshape(61, 61)
    a, b, c, d = number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1]
    triangles = np.stack([a, b, c, a, c, d], axis=-1).reshape(-1, 3)
    got = refused("folds over in plan", points.reshape(-1, 3), triangles)
    assert got.startswith("it hangs over near (")

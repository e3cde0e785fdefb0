"""Surfaces by formulas: points, normals, areas, lattices as close as asked for."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from orishell.conventions.errors import InputError
from orishell.curves import parse_formula_of_two
from orishell.design import FormulaSurface
from orishell.motion.quads import lengths


def graph(text: str, half: float = 0.5, **more: Any) -> FormulaSurface:
    formula = parse_formula_of_two(text, "x", "y")
    return FormulaSurface((formula,), (-half, half), (-half, half), **more)


def torus() -> FormulaSurface:
    """Of radii 2 and 1, a piece of its outer side: its area is known."""
    texts = ("(2+cos(v))*cos(u)", "(2+cos(v))*sin(u)", "sin(v)")
    formulas = tuple(parse_formula_of_two(text, "u", "v") for text in texts)
    return FormulaSurface(formulas, (-0.7, 0.7), (-0.7, 0.7))


def test_normals_of_a_cap_point_away_from_its_centre() -> None:
    surface = graph("sqrt(1 - x**2 - y**2)", turn=0.3)
    u, v = np.array([0.1, -0.5]), np.array([0.3, 0.2])
    assert surface.normals(u, v) == pytest.approx(surface.points(u, v), abs=1e-12)


def test_the_area_of_a_torus() -> None:
    """1.4 (2 * 1.4 + 2 sin 0.7), with the sine of 0.7 and radii 2 and 1."""
    area = 1.4 * (2 * 1.4 + 2 * np.sin(0.7))
    assert torus().area() == pytest.approx(area, rel=1e-4)
    assert torus().area(0.01) == pytest.approx(area, rel=1e-4)


@pytest.mark.parametrize("surface", [graph("sqrt(1 - x**2 - y**2)"), torus(), graph("x*y")])
def test_lattices_are_as_close_as_asked_for(surface: FormulaSurface) -> None:
    step, sagitta = 0.07, 2e-4
    lattice = surface.lattice(step, sagitta)
    for axis in (0, 1):
        assert lengths(np.diff(lattice.points, axis=axis)).max() <= 1.02 * step
    u, v = 0.5 * (lattice.u[1:] + lattice.u[:-1]), 0.5 * (lattice.v[1:] + lattice.v[:-1])
    middle = 0.5 * (lattice.points[:-1, :-1] + lattice.points[1:, 1:])
    gap = surface.points(u[:, None], v[None, :]) - middle
    normals = surface.normals(u[:, None], v[None, :])
    assert np.abs(np.einsum("ijk,ijk->ij", gap, normals)).max() <= sagitta


def test_a_rectangle_in_plan_is_turned_about_its_centre() -> None:
    surface = graph("x + 2*y", centre=(3.0, 1.0), turn=np.pi / 2)
    assert surface.points(np.array(0.0), np.array(0.5)) == pytest.approx([3.0, 1.5, 6.0])
    top = surface.piece.vertices[surface.piece.sides[0]]
    assert top[0] == pytest.approx([2.5, 0.5, 3.5])


def test_what_has_no_tangent_plane_is_refused_by_place() -> None:
    with pytest.raises(InputError, match="not finite") as refused:
        _ = graph("sqrt(1 - x**2 - y**2)", 0.9).piece
    assert refused.value.got == "at x = -0.9, y = -0.9"

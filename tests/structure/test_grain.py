"""Boards with a grain: shares of what they bear along it, across it and in shear, by hand."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest

from orishell.conventions.errors import InputError
from orishell.structure.grain import BOTH_WAYS, Grain, GrainModuli, GrainStrength, grain_turns
from orishell.structure.grain_shares import grain_shares
from orishell.structure.materials import materials
from orishell.structure.mesh.edge_forces import find_edge_forces
from orishell.structure.mesh.hinges import hinge_elements, rigid_stiffness
from orishell.structure.mesh.plane import strains_along, tensors_along
from orishell.structure.mesh.sections import Section
from orishell.structure.mesh.triangle import Facets
from orishell.structure.model import Model

from .test_design_values import PLYWOOD, without_values
from .test_elements import lattice, solve, spread
from .test_materials import read
from .test_stresses import GRID, SECTION, THICK, WIDE, stresses, strip
from .test_verdicts import arch

BIRCH = GrainStrength(
    bending=(42.9, 33.2), tension=(40.0, 35.0), compression=(27.7, 24.3),
    rolling_shear=(2.78, 2.22), panel_shear=9.5,
)  # fmt: skip
"""12 mm of birch plywood (Handbook of Finnish Plywood), MPa."""
MODULI = GrainModuli(bending=(10.7e9, 6.7e9), tension=(9.3e9, 8.1e9), shear=0.62e9)
SQUARE = np.array([[[0.0, 1.0], [0.0, 0.0], [1.0, 0.0], [1.0, 1.0]]])


def test_values_of_the_handbook() -> None:
    """And panel shear of 4.75 MPa by design: 0.6 x 9.5/1.2, lasting loads under a roof."""
    found = materials()["birch plywood"]
    assert found.grain is not None
    for key in BOTH_WAYS:
        np.testing.assert_allclose(getattr(found.grain, key), 1e6 * np.array(getattr(BIRCH, key)))
    design = found.grain.times(found.design_share("permanent", 2))
    assert design.panel_shear == pytest.approx(4.75e6)
    assert design.rolling_shear == pytest.approx((1.39e6, 1.11e6))


@pytest.mark.parametrize(
    ("direct", "bent", "shares"),
    [
        ((20.0, 0.0, 0.0), (0.0, 0.0, 0.0), (20 / 40, 0, 0)),
        ((-20.0, 0.0, 0.0), (0.0, 0.0, 0.0), (20 / 27.7, 0, 0)),
        ((0.0, -10.0, 0.0), (0.0, -5.0, 0.0), (0, 10 / 24.3 + 5 / 33.2, 0)),
        ((0.0, 0.0, -2.0), (8.0, 0.0, 1.0), (8 / 42.9, 0, 3 / 9.5)),
    ],
)
def test_shares_by_hand(direct: Any, bent: Any, shares: Any) -> None:
    """EN 1995-1-1, 6.2.3: tension or compression and bending add up along each axis."""
    found = BIRCH.of_axes(np.array(direct), np.array(bent), solid=True)
    np.testing.assert_allclose(found, shares, rtol=1e-12)


def test_one_of_two_boards_is_pulled_or_pressed_by_bending() -> None:
    found = BIRCH.of_axes(np.array([5.0, 0, 0]), np.array([9.0, 0, 0]), solid=False)
    np.testing.assert_allclose(found, [max(14 / 40, 4 / 27.7), 0, 0])


def test_pull_at_half_a_right_angle_is_borne_by_shear() -> None:
    """19 MPa at 45 degrees are half as much along and across, and all that panel shear bears."""
    tensor = tensors_along(np.array([19.0, 0.0, 0.0]), np.cos(np.pi / 4), np.sin(np.pi / 4))
    found = BIRCH.of_axes(tensor, np.zeros(3), solid=True)
    np.testing.assert_allclose(found, [9.5 / 40, 9.5 / 35, 1.0])
    # Von Mises would have it at 57 % of what bending bears across the grain.
    assert np.linalg.norm(found) == pytest.approx(np.sqrt(1 + (9.5 / 40) ** 2 + (9.5 / 35) ** 2))


def test_rolling_shear_is_one_and_a_half_times_the_mean() -> None:
    assert BIRCH.rolls(np.array([0.0, 1.0])) == pytest.approx(1.5 / 2.22)
    assert BIRCH.rolls(np.array([1.0, 0.0])) == pytest.approx(1.5 / 2.78)


def test_an_unknown_grain_is_the_weaker_either_way() -> None:
    weaker = BIRCH.weaker()
    assert weaker.bending == (33.2, 33.2)
    assert weaker.compression == (24.3, 24.3)
    assert weaker.panel_shear == 9.5


@pytest.mark.parametrize(("grain", "expected"), [("along rows", 0.0), ("along columns", -90.0)])
@pytest.mark.parametrize("turn", [0.0, 0.7])
def test_where_the_grain_runs(grain: Grain, expected: float, turn: float) -> None:
    """From the side that goes down rows run to the left-hand side, by a right angle."""
    c, s = np.cos(turn), np.sin(turn)
    inside, beside = grain_turns(SQUARE @ np.array([[c, s], [-s, c]]), grain)
    assert np.cos(inside[0] - np.deg2rad(90 + expected)) == pytest.approx(1.0)
    # Normals out of the left, lower, right and upper side: left, down, right, up.
    normals = np.deg2rad([180.0, 270.0, 0.0, 90.0])
    np.testing.assert_allclose(np.cos(beside[0] - np.deg2rad(expected) + normals), 1.0)


@pytest.mark.parametrize("grain", ["along rows", "along columns", None])
def test_a_strip_by_hand(grain: Grain | None) -> None:
    """Pulled by 3 N and lifted by 1 N at its end: shares within it, and beside its crease.

    At the clamped end patches have 15/16 of the moment F L there; beside the crease is half of it.
    """
    mesh, moved = strip((3.0, 0.0, 1.0))
    turning = hinge_elements(mesh, GRID, rigid_stiffness(mesh, SECTION)).forces(moved)
    edges = find_edge_forces(
        mesh, GRID, mesh.elements(SECTION).forces(moved), turning, np.zeros((mesh.nodes.size, 3))
    )
    corners = mesh.facets.points[mesh.nodes[:, [0, -1, -1, 0], [0, 0, -1, -1]]][..., :2]
    strength = BIRCH if grain else BIRCH.weaker()
    structure = SimpleNamespace(grain=grain, grain_strength=lambda *_: strength)
    model = SimpleNamespace(
        structure=structure, flat=corners, design=SimpleNamespace(panel=None), thickness=THICK,
        bevelled=False, grid=GRID, mesh=mesh, site=SimpleNamespace(unit="m"),
        panel_at=cast("Callable[[int], Any]", lambda number: (0, number)),
    )  # fmt: skip
    found = grain_shares(cast("Model", model), stresses(mesh, moved), edges, "permanent")
    assert found is not None
    way = 0 if grain == "along rows" else 1
    pull, moment = 3 / WIDE / THICK, 15 / 16 / WIDE
    by_hand = pull / strength.tension[way] + 6 * moment / THICK**2 / strength.bending[way]
    assert found.panels == pytest.approx(by_hand, rel=1e-3)
    assert found.crease is None
    rolls = 1.5 / WIDE / THICK / strength.rolling_shear[way]
    assert found.rolling_shear == pytest.approx(rolls, rel=0.02)
    assert found.panel_shear < 5e-3 * by_hand


def test_a_shell_of_plywood() -> None:
    """All shares are in the utilisation; panels use what shear does at least, and more together."""
    cases: list[dict[str, Any]] = [
        {"name": "snow", "self_weight": True, "snow": {"ground": 500, "arrangement": "undrifted"}},
        {"name": "wind", "wind": {"speed": 26, "terrain": "II", "direction_deg": 90}},
    ]
    keys = without_values({**PLYWOOD, "line_strength": 1e6, "grain": "along columns"})
    found = arch(keys, cases)
    for case, k_mod in zip(found.cases, (0.65, 0.7), strict=True):
        balanced = case.equilibrium
        assert balanced is not None
        used, patches = balanced.utilisation, balanced.in_patches
        assert used.panels is not None
        assert used.panel_shear is not None
        assert used.panels >= used.panel_shear > 0
        # Shear in a patch is at most half the difference of principal stresses.
        radius = np.hypot(
            0.5 * (patches.faces[..., 0] - patches.faces[..., 1]), patches.faces[..., 2]
        )
        assert used.panel_shear * k_mod * 9.5e6 / 1.2 >= 0.5 * radius.min()
    assert "rolling shear" in found.cases[0].said
    given = arch({**keys, "strength": 5e6, "grain": None}, cases[:1]).cases[0].equilibrium
    assert given is not None
    assert given.utilisation.rolling_shear is None
    assert given.utilisation.panels == pytest.approx(given.in_panels[0] / 5e6)


def oriented(facets: Facets, turn: float) -> Section:
    """A section whose grain runs at an angle to the x axis (radians)."""
    axes = facets.axes()
    angle = turn - np.arctan2(axes[:, 0, 1], axes[:, 0, 0])
    seen = strains_along(np.cos(angle), np.sin(angle))
    plane, bending = (
        seen.swapaxes(1, 2) @ each @ seen for each in MODULI.in_axes("along rows", 0.1)
    )
    solid = Section.solid(6.7e9, 0.012, 0.1)
    return replace(solid, grain_in_plane=plane, grain_in_bending=bending)


def test_stiffness_of_the_handbook() -> None:
    found = materials()["birch plywood"]
    assert found.grain_moduli is not None
    assert found.modulus == min(found.grain_moduli.bending)
    plane, bending = MODULI.in_axes("along rows", 0.0)
    np.testing.assert_allclose(6.7e9 * np.diag(plane), [9.3e9, 8.1e9, 0.62e9])
    np.testing.assert_allclose(6.7e9 * np.diag(bending), [10.7e9, 6.7e9, 0.62e9])
    plane, bending = MODULI.in_axes(None, 0.0)
    np.testing.assert_allclose(6.7e9 * np.diag(plane), [8.1e9, 8.1e9, 0.62e9])


@pytest.mark.parametrize("turn", [0.0, 0.4])
def test_a_plate_with_a_grain(turn: float) -> None:
    """Navier's series of a simply supported orthotropic plate, turned as a whole in the plane.

    16 q/(pi^6 m n (D_1 m^4 + 2 (D_12 + 2 D_66) m^2 n^2 + D_2 n^4)) (Timoshenko, Theory of plates
    and shells, section 85).
    """
    c, s = np.cos(turn), np.sin(turn)
    facets, nodes = lattice(16, 16, lambda u, v: [c * u - s * v, s * u + c * v, 0 * u])
    section = oriented(facets, turn)
    rim = np.concatenate([nodes[0], nodes[-1], nodes[:, 0], nodes[:, -1]])
    found = solve(facets, section, spread(facets, [0, 0, -1]), [(rim, (2,)), (nodes, (0, 1, 5))])
    matrix = float(np.max(section.bending)) * MODULI.in_axes("along rows", 0.1)[1]
    odd = np.arange(1, 60, 2)
    m, n = odd[:, None], odd
    stiff = matrix[0, 0] * m**4 + matrix[1, 1] * n**4
    stiff = stiff + 2 * (matrix[0, 1] + 2 * matrix[2, 2]) * m**2 * n**2
    waves = 16 / np.pi**6 / (m * n * stiff) * np.sin(0.5 * np.pi * m) * np.sin(0.5 * np.pi * n)
    assert -found[nodes[8, 8], 2] == pytest.approx(float(waves.sum()), rel=5e-3)


@pytest.mark.parametrize(("turn", "modulus"), [(0.0, 9.3e9), (np.pi / 2, 8.1e9), (0.6, None)])
def test_a_sheet_that_is_pulled(turn: float, modulus: float | None) -> None:
    """At an angle 1/E is c^4/E_1 + s^4/E_2 + (1/G - 2 nu_12/E_1) s^2 c^2 (R. M. Jones, Mechanics
    of composite materials, 1975, section 2.6), along the first side of a triangle."""
    facets, _ = lattice(1, 1, lambda u, v: [u, v, 0 * u])
    section = oriented(facets, turn)
    c, s = np.cos(turn), np.sin(turn)
    nu = 0.1 * np.sqrt(9.3 / 8.1)
    soft = c**4 / 9.3e9 + s**4 / 8.1e9 + (1 / 0.62e9 - 2 * nu / 9.3e9) * s**2 * c**2
    assert facets.axes()[0, 0] == pytest.approx([1, 0, 0])
    found = np.linalg.inv(section.in_plane[0])[0, 0]
    assert found == pytest.approx(soft / 0.012, rel=1e-9)
    assert modulus is None or soft == pytest.approx(1 / modulus)


def test_the_grain_of_a_model_runs_as_it_is_said() -> None:
    """A triangle's matrices are those of the grain, turned by where its panel's row creases run."""
    found = arch(without_values({**PLYWOOD, "line_strength": 1e6, "grain": "along rows"}))
    model, section = found.model, found.model.section
    assert section.grain_in_plane is not None
    plane, _ = MODULI.in_axes("along rows", 0.3)
    corners = model.mesh.facets.points[model.mesh.nodes[:, [0, -1, -1, 0], [0, 0, -1, -1]]]
    rows = (corners[:, 3] - corners[:, 0]) + (corners[:, 2] - corners[:, 1])
    axes = model.mesh.facets.axes()
    along = np.einsum("tkx,tx->tk", axes[:, :2], rows[model.mesh.panels])
    strain = np.stack([along[:, 0] ** 2, along[:, 1] ** 2, 2 * along[:, 0] * along[:, 1]], axis=1)
    strain /= (along**2).sum(axis=1)[:, None]
    energy = np.einsum("ti,tij,tj->t", strain, section.grain_in_plane, strain)
    np.testing.assert_allclose(energy, plane[0, 0], rtol=1e-9)


@pytest.mark.parametrize(
    ("tables", "says"),
    [
        ('material = "steel"\ngrain = "along rows"', "birch plywood"),
        ('modulus = 8e9\ngrain = "along rows"', "birch plywood"),
        ('material = "birch plywood"\ngrain = "across"', "along columns"),
        ('material = "birch plywood"\ngrain = 90', "along columns"),
        ('material = "birch plywood"\ngrain = "along rows"\nstrength = 5e6', "strength"),
    ],
)
def test_bad_values_are_refused(tmp_path: Path, tables: str, says: str) -> None:
    asked = 'supports = [{ at = "feet", kind = "pinned" }]\nthickness = 0.01\n'
    with pytest.raises(InputError, match=says):
        read(tmp_path, f"[structure]\n{asked}{tables}")

"""Boards of two faces on a core: stiffness with shear, and what ends what they bear, by hand."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest

from calculix_tool import run_calculix
from orishell.conventions.errors import InputError
from orishell.numerics.arrays import Array
from orishell.structure.materials import materials
from orishell.structure.mesh.edge_forces import find_edge_forces
from orishell.structure.mesh.hinges import hinge_elements, rigid_stiffness
from orishell.structure.mesh.layup import Core, Layup
from orishell.structure.mesh.sections import Section
from orishell.structure.mesh.triangle import curvatures, plate_stiffness, shear_strains
from orishell.structure.model import Model
from orishell.structure.sandwich_shares import in_sandwich

from .test_buckling import ALONG, Plate
from .test_elements import lattice, solve, spread
from .test_materials import read
from .test_stresses import GRID, LONG, WIDE, stresses, strip
from .test_verdicts import arch

FACES = Core(face=0.001, shear_modulus=20e6, modulus=60e6)
THICK = 0.05
PLATE = Section.board(Layup(70e9, 0.3, FACES), THICK)
BEAM = Section.board(Layup(70e9, 0.0, FACES), THICK)


def some_triangles() -> Array:
    corners = np.random.default_rng(1).normal(size=(40, 3, 2))
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    clockwise = first[:, 0] * second[:, 1] < first[:, 1] * second[:, 0]
    corners[clockwise] = corners[clockwise][:, ::-1]
    return np.asarray(corners)


def batoz(corners: Array, moved: Array, at: Array) -> Array:
    """Rotations beta of DKT at places (p, 3) of one triangle, by values at middles of sides.

    There along a side beta is 1.5 times the slope of the chord less a quarter of both ends', and
    across it their mean (Batoz, Bathe and Ho 1980, equations 15 to 22).
    """
    w, ends = moved[::3], np.stack([moved[2::3], -moved[1::3]], axis=1)
    middles = []
    for i, j in ((0, 1), (1, 2), (2, 0)):
        side = corners[j] - corners[i]
        size = float(np.linalg.norm(side))
        along = side / size
        across = np.array([-along[1], along[0]])
        mean = 0.5 * (ends[i] + ends[j])
        bent = -1.5 * (w[j] - w[i]) / size - 0.5 * mean @ along
        middles.append(bent * along + (mean @ across) * across)
    quadratic = np.concatenate([at * (2 * at - 1), 4 * at * np.roll(at, -1, axis=1)], axis=1)
    return np.asarray(quadratic @ np.stack([*ends, *middles]))


def test_without_shear_it_is_dkt() -> None:
    """Curvatures are slopes of the rotations that Batoz, Bathe and Ho interpolate."""
    moved = np.random.default_rng(2).normal(size=9)
    for corners in some_triangles():
        found = curvatures(corners[None], (0.2, 0.5))[0] @ moved
        coordinates = np.linalg.inv(np.vstack([corners.T, np.ones(3)]))
        place, step = np.array([0.3, 0.2, 0.5]), 1e-3
        slopes = []
        for direction in np.eye(3)[:2]:
            ahead, back = (place + sign * step * coordinates @ direction for sign in (1, -1))
            both = batoz(corners, moved, np.stack([ahead, back]))
            slopes.append((both[0] - both[1]) / (2 * step))
        (xx, yx), (xy, yy) = slopes
        np.testing.assert_allclose(found, [xx, yy, xy + yx], rtol=1e-9, atol=1e-9)


def test_a_stiff_core_is_none() -> None:
    """The stiffness tends to DKT's as shear does, in proportion to the shear flexibility."""
    corners, rigid = some_triangles(), np.diag([1.0, 1.0, 0.4])
    none = np.zeros(len(corners))
    thin = plate_stiffness(corners, rigid, none, none)
    size = np.abs(thin).max(axis=(1, 2))
    apart = []
    for soft in (1e-6, 1e-8):
        found = plate_stiffness(corners, rigid, none + soft, none + 1 / soft)
        apart.append(np.abs(found - thin).max(axis=(1, 2)) / size)
    np.testing.assert_allclose(apart[0], 100 * apart[1], rtol=0.05)
    shortest = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).min(axis=1)
    assert (apart[1] < 50 * 1e-8 / shortest**2).all()


def test_nothing_is_strained_as_triangles_turn() -> None:
    corners = some_triangles()
    x, y = np.moveaxis(corners, -1, 0)[..., None]
    for w, about_x, about_y in ((1 + 0 * x, 0, 0), (y, 1, 0), (-x, 0, 1)):
        moved = np.concatenate([w, about_x + 0 * w, about_y + 0 * w], axis=2).reshape(-1, 9, 1)
        soft = np.full(len(corners), 0.3)
        np.testing.assert_allclose(curvatures(corners, (0.3, 0.3), soft) @ moved, 0, atol=1e-9)
        strained = shear_strains(corners, soft).reshape(-1, 6, 9) @ moved
        np.testing.assert_allclose(strained, 0, atol=1e-9)


def test_sections_by_hand() -> None:
    """12 GPa, skins of 1.5 mm on 20 mm: 2 f E', E' (f d^2/2 + f^3/6), and G d^2/c."""
    found = materials()["GFRP skins on foam"].sandwich
    assert found is not None
    core = Core(found.face, found.core_shear_modulus, found.core_modulus)
    section = Section.board(Layup(12e9, 0.3, core), 0.023)
    plane = 12e9 / 0.91
    assert section.membrane == pytest.approx(0.003 * plane)
    assert section.bending == pytest.approx(plane * (0.0015 * 0.0215**2 / 2 + 0.0015**3 / 6))
    assert section.shear == pytest.approx(16e6 * 0.0215**2 / 0.020)
    # As one solid board with 3/23 of the skins' modulus bending was 2.6 times softer.
    solid = Section.solid(12e9 * 3 / 23, 0.023, 0.3)
    assert section.membrane == pytest.approx(solid.membrane)
    bends = float(np.max(np.asarray(section.bending) / np.asarray(solid.bending)))
    assert bends == pytest.approx(2.626, rel=1e-3)
    assert found.density(0.023) == pytest.approx((3 * 1600 + 20 * 60) / 23)
    assert Layup(12e9, 0.3, core).wrinkling == pytest.approx(0.5 * (12e9 * 60e6 * 16e6) ** (1 / 3))


def test_a_simply_supported_plate_sags_by_bending_and_shear() -> None:
    """Allen's series, 1969: waves of Navier's are 1 + pi^2 D (m^2 + n^2)/(a^2 S) times as large.

    Half of it is shear. By 8 cells 1.3 % stiff, by 16 0.4 %.
    """
    odd = np.arange(1, 80, 2)
    m, n = odd[:, None], odd
    bending, shear = float(np.max(PLATE.bending)), float(np.max(PLATE.shear))
    waves = m**2 + n**2
    terms = np.sin(0.5 * np.pi * m) * np.sin(0.5 * np.pi * n) / (m * n * waves**2)
    both = 16 / np.pi**6 / bending * terms * (1 + np.pi**2 * bending / shear * waves)
    hand = float(both.sum())
    assert hand / float((16 / np.pi**6 / bending * terms).sum()) > 1.9
    for cells, near in ((8, 0.015), (16, 0.004)):
        facets, nodes = lattice(cells, cells, lambda u, v: [u, v, 0 * u])
        held = [
            (nodes[[0, -1]], (2, 3)), (nodes[:, [0, -1]], (2, 4)), (nodes, (0, 1, 5)),
        ]  # fmt: skip
        found = solve(facets, PLATE, spread(facets, [0, 0, -1]), held)
        middle = -found[nodes[cells // 2, cells // 2], 2]
        assert middle == pytest.approx(hand, rel=near)


def test_a_cantilever() -> None:
    """P L^3/(3 E I) + P L/(G A), a fifth of it by shear."""
    facets, nodes = lattice(8, 2, lambda u, v: [u, 0.1 * v, 0 * u])
    load = np.zeros((len(facets.points), 6))
    load[nodes[-1], 2] = [0.25, 0.5, 0.25]
    found = solve(facets, BEAM, load, [(nodes[0], range(6)), (nodes, (1, 5))])
    bending, shear = (0.1 * float(np.max(each)) for each in (BEAM.bending, BEAM.shear))
    hand = 1 / (3 * bending) + 1 / shear
    assert found[nodes[-1, 1], 2] == pytest.approx(hand, rel=2e-3)
    assert 1 / shear > 0.2 * hand


def test_a_column() -> None:
    """1/P = 1/P_E + 1/S, with P_E = 0.83 S; without shear it would bear 1.83 times as much."""
    strip = Plate(1.0, 0.1, ("left", "right"), BEAM)
    (found,) = strip.factors(12, ALONG)
    bending, shear = float(np.max(BEAM.bending)), float(np.max(BEAM.shear))
    euler = np.pi**2 * bending
    hand = 1 / (1 / euler + 1 / shear)
    assert found * np.pi**2 * bending / 0.1**2 == pytest.approx(hand, rel=0.01)
    assert euler > 1.8 * hand


@pytest.mark.parametrize("cells", [3, 5])
def test_calculix_agrees_on_a_plate_of_bricks(cells: int, tmp_path: Path) -> None:
    """Three layers of quadratic bricks, a quarter of the plate, have 1 % or less of difference.

    With 3 and 5 cells of theirs along half a side. Their core bends, too, which is 0.5 % of the
    stiffness, and what it shears is not linear at the rim.
    """
    core_modulus = 2 * 1.3 * FACES.shear_modulus
    deck = tmp_path / "plate.inp"
    deck.write_text(brick_plate(cells, core_modulus))
    (theirs,) = run_calculix(deck).displacements
    facets, nodes = lattice(16, 16, lambda u, v: [u, v, 0 * u])
    held = [(nodes[[0, -1]], (2, 3)), (nodes[:, [0, -1]], (2, 4)), (nodes, (0, 1, 5))]
    found = solve(facets, PLATE, spread(facets, [0, 0, -1]), held)
    assert found[nodes[8, 8], 2] == pytest.approx(theirs[0, 2], rel=0.01)


def brick_plate(cells: int, core_modulus: float) -> str:
    """A deck of a quarter of the plate under a pressure of 1, its middle's displacement printed."""
    levels = np.array([0.0, 0.0005, 0.001, 0.025, 0.049, 0.0495, 0.05])
    side = np.linspace(0, 0.5, 2 * cells + 1)
    count = len(side)

    def node(i: Any, j: Any, k: Any) -> Any:
        return 1 + (k * count + j) * count + i

    i, j, k = (each.ravel() for each in np.meshgrid(*(np.arange(n) for n in (count, count, 7))))
    whole = (i % 2) + (j % 2) + (k % 2) < 2
    i, j, k = (each[whole] for each in (i, j, k))
    number = node(i, j, k)
    lines = ["*NODE, NSET=ALL"]
    lines += [
        f"{n}, {x:.9g}, {y:.9g}, {z:.9g}"
        for n, x, y, z in zip(number, side[i], side[j], levels[k], strict=True)
    ]
    corners = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0)]
    above = [(a, b, 2) for a, b, _ in corners]
    middles = [(1, 0, 0), (2, 1, 0), (1, 2, 0), (0, 1, 0)]
    order = [*corners, *above, *middles, *[(a, b, 2) for a, b, _ in middles]]
    order += [(a, b, 1) for a, b, _ in corners]
    element = 0
    for layer, name in enumerate(("LOW", "CORE", "HIGH")):
        lines.append(f"*ELEMENT, TYPE=C3D20R, ELSET={name}")
        for a in range(0, count - 1, 2):
            for b in range(0, count - 1, 2):
                element += 1
                at = [str(node(a + x, b + y, 2 * layer + z)) for x, y, z in order]
                lines += [f"{element}, {', '.join(at[:10])},", ", ".join(at[10:])]
    for name, modulus in (("FACE", 70e9), ("FOAM", core_modulus)):
        lines += [f"*MATERIAL, NAME={name}", "*ELASTIC", f"{modulus:.9g}, 0.3"]
    for name, material in (("LOW", "FACE"), ("CORE", "FOAM"), ("HIGH", "FACE")):
        lines.append(f"*SOLID SECTION, ELSET={name}, MATERIAL={material}")
    lines.append("*BOUNDARY")
    for places, fixed in (
        (i == 0, (2, 3)),
        (j == 0, (1, 3)),
        (i == count - 1, (1,)),
        (j == count - 1, (2,)),
    ):
        lines += [f"{n}, {axis}, {axis}" for n in number[places] for axis in fixed]
    middle = node(count - 1, count - 1, 0)
    lines += ["*NSET, NSET=MIDDLE", f"{middle}", "*STEP", "*STATIC", "*DLOAD", "HIGH, P2, 1.0"]
    return "\n".join([*lines, "*NODE PRINT, NSET=MIDDLE", "U", "*END STEP", ""])


def test_stresses_of_a_strip_by_hand() -> None:
    """Lifted by 1 N and pressed by 30 N at its end: the core has F/(b d), faces are pressed most
    where the strip is clamped, in patches with 15/16 of the moment there.
    """
    mesh, moved = strip((-30.0, 0.0, 1.0), section=BEAM)
    turning = hinge_elements(mesh, GRID, rigid_stiffness(mesh, BEAM)).forces(moved)
    edges = find_edge_forces(
        mesh, GRID, mesh.elements(BEAM).forces(moved), turning, np.zeros((mesh.nodes.size, 3))
    )
    layup = Layup(70e9, 0.0, FACES)
    model = SimpleNamespace(
        structure=SimpleNamespace(layup=layup), design=SimpleNamespace(panel=None), thickness=THICK,
        bevelled=False, grid=GRID, mesh=mesh,
        panel_at=cast("Callable[[int], Any]", lambda number: (0, number)),
    )  # fmt: skip
    patches = stresses(mesh, moved, BEAM)
    found = in_sandwich(cast("Model", model), patches, edges)
    assert found is not None
    hand = 1 / WIDE / 0.049
    assert np.median(np.abs(patches.across[:, 1])) == pytest.approx(hand, rel=0.03)
    assert hand < found.core_shear < 1.06 * hand  # where it is clamped shear comes from above
    moment = 15 / 16 * LONG / WIDE
    faces = 0.001 * 0.049**2 / 2 + 0.001**3 / 6
    pressure = 30 / WIDE / 0.002 + moment * 0.025 / faces
    assert found.pressure == pytest.approx(pressure, rel=5e-3)
    assert found.wrinkling == pytest.approx(0.5 * (70e9 * 20e6 * 60e6) ** (1 / 3))


GFRP = {"material": "GFRP skins on foam", "modulus": 12e9, "strength": None, "line_strength": 1e6}


def test_shares_of_a_shell() -> None:
    """Of skins by 60 MPa, of the core by 0.63 MPa, of wrinkling by 112.9 MPa."""
    found = arch({**GFRP, "thickness": 0.023})
    case = found.cases[0].equilibrium
    assert case is not None
    used, inside = case.utilisation, case.sandwich
    assert inside is not None
    assert used.panels == pytest.approx(case.in_panels[0] / 60e6)
    assert used.core_shear == pytest.approx(inside.core_shear / 0.63e6)
    assert used.wrinkling == pytest.approx(inside.pressure / 112.9e6, rel=1e-3)
    assert case.unknown == ()


def test_a_core_of_unknown_strength_is_not_known_to_carry() -> None:
    own = {"face": 0.0015, "core_shear_modulus": 4e6, "core_modulus": 8e6}
    found = arch(
        {
            "modulus": 12e9,
            "thickness": 0.023,
            "line_strength": 1e6,
            "sandwich": own,
            "strength": 60e6,
        }
    )
    case = found.cases[0].equilibrium
    assert case is not None
    assert case.unknown == ("core_shear",)
    said = [each.text for each in found.cases[0].findings]
    assert "is loaded in cores of panels in shear, whose strength is not given" in said


ASKED = 'supports = [{ at = "feet", kind = "pinned" }]\n'


@pytest.mark.parametrize(("unit", "size"), [("m", 1.0), ("mm", 1e3)])
def test_a_sandwich_in_any_unit(tmp_path: Path, unit: str, size: float) -> None:
    tables = f'[structure]\nmaterial = "GFRP skins on foam"\nthickness = {0.023 * size}\n{ASKED}'
    found = read(tmp_path, tables, unit)
    assert found.structure is not None
    core = found.structure.layup.core
    assert core is not None
    assert core.face == pytest.approx(0.0015 * size)
    assert core.shear_modulus == pytest.approx(16e6 / size**2)
    assert found.workshop.areal_density == pytest.approx(0.003 * 1600 + 0.020 * 60)
    thin = read(tmp_path, tables + f"sandwich = {{ face = {0.001 * size} }}", unit).structure
    assert thin is not None
    assert thin.layup.core is not None
    assert thin.layup.core.face == pytest.approx(0.001 * size)
    assert thin.layup.core.shear_modulus == pytest.approx(16e6 / size**2)


@pytest.mark.parametrize(
    ("tables", "says"),
    [
        ("modulus = 1e9\nsandwich = { face = 0.001 }", "core_shear_modulus and core_modulus"),
        ("modulus = 1e9\nsandwich = { core_modulus = 1e6 }", "face and core_shear_modulus"),
        ("modulus = 1e9\nsandwich = { face = 0, core_modulus = 1e6 }", "face"),
        ("modulus = 1e9\nsandwich = { face = -1, core_modulus = 1e6 }", "face"),
        ("modulus = 1e9\nsandwich = { skin = 0.001 }", "skin"),
        ("modulus = 1e9\nsandwich = 0.001", "sandwich"),
        ('material = "birch plywood"\nsandwich = { face = 0.001 }', "without a grain"),
        ('material = "GFRP skins on foam"\nsandwich = { face = 0.005 }', "no room for a core"),
        ("sandwich = { face = 0.001, core_shear_modulus = 1e6, core_modulus = 1e6 }", "modulus"),
    ],
)
def test_bad_values_are_refused(tmp_path: Path, tables: str, says: str) -> None:
    with pytest.raises(InputError, match=says):
        read(tmp_path, f"[structure]\n{ASKED}thickness = 0.01\n{tables}")


def test_two_thicknesses_are_refused(tmp_path: Path) -> None:
    """Of a sandwich as of any board: that of panels is one number."""
    panel = '\n[panel]\nconstruction = "bevel"\nthickness = 0.023\ngap = 0.002\n'
    tables = f'[structure]\nmaterial = "GFRP skins on foam"\nthickness = 0.02\n{ASKED}{panel}'
    with pytest.raises(InputError, match="have a thickness already"):
        read(tmp_path, tables)

"""Base rails: bars by hand, what they do to a shell, and what is refused."""

from __future__ import annotations

from pathlib import Path
from typing import Any, cast

import numpy as np
import pytest

from orishell.conventions.errors import InputError
from orishell.conventions.quantities import GRAVITY, Quantities
from orishell.io.formats.calculix import write_calculix
from orishell.shell.rail_order import rail_order
from orishell.structure.mesh.frames import Bar, Frame
from orishell.structure.pages.model_section import model_section
from orishell.structure.results import Analysis

from .test_materials import read
from .test_verdicts import arch

STEEL = 210e9
BAR = Bar(STEEL, STEEL / 2.6, width=0.05, height=0.1, wall=0.025)
UP, SIDEWAYS = 0.05 * 0.1**3 / 12, 0.1 * 0.05**3 / 12
A, B = 1.0, 1.6
RAIL = {"material": "steel", "width": 0.05, "height": 0.08, "wall": 0.004}


def line(*points: tuple[float, float, float]) -> Frame:
    return Frame(np.arange(len(points)), np.array(points), BAR)


def test_a_joint_between_two_others_by_hand() -> None:
    """F/w = 3 E I l/(a^2 b^2), upwards and sideways, and E A (1/a + 1/b) along."""
    stiffness = line((0, 0, 0), (A, 0, 0), (A + B, 0, 0)).stiffness[3:6, 3:6]
    bends = 3 * STEEL * (A + B) / (A * B) ** 2
    along = STEEL * 0.05 * 0.1 * (1 / A + 1 / B)
    by_hand = np.diag([along, bends * SIDEWAYS, bends * UP])
    assert stiffness == pytest.approx(by_hand, rel=1e-9, abs=1e-9 * along)


def test_stress_by_hand() -> None:
    """The moment F a b/l over W, and N/A of a bar that is longer by a thousandth."""
    frame = line((0, 0, 0), (A, 0, 0), (A + B, 0, 0))
    lifted = np.zeros((3, 3))
    lifted[1, 2] = 0.01
    force = 0.01 * 3 * STEEL * UP * (A + B) / (A * B) ** 2
    bent = force * A * B / (A + B) / (UP / 0.05)
    assert frame.stresses(lifted) == pytest.approx([bent, bent])
    pulled = np.zeros((3, 3))
    pulled[2, 0] = 1e-3 * B
    assert frame.stresses(pulled) == pytest.approx([0, 1e-3 * STEEL], abs=1)


def test_hollow_sections_by_hand() -> None:
    """50 x 80 x 4 mm: A = 976 mm2, I = 50 80^3/12 - 42 72^3/12; Bredt's torsion, 4 A^2 t/u."""
    bar = Bar(STEEL, STEEL / 2.6, 0.05, 0.08, 0.004)
    assert bar.area == pytest.approx(976e-6)
    assert bar.inertia[0] == pytest.approx((50 * 80**3 - 42 * 72**3) / 12 * 1e-12)
    assert bar.torsion == pytest.approx(4 * (46 * 76) ** 2 * 4 / (2 * (46 + 76)) * 1e-12)
    # A solid square has 0.1406 a^4 (Roark).
    assert Bar(1, 1, 1, 1, 0.5).torsion == pytest.approx(0.1406, rel=5e-3)


def test_corners_in_plan_cost_nothing_as_a_whole() -> None:
    """Six motions of the whole, and no others, of a line that turns in plan and goes up."""
    frame = line((0, 0, 0), (1, 0.4, 0), (2, -0.3, 0.1), (3.1, 0.5, 0), (4, 0, 0.2))
    matrix = frame.stiffness
    assert np.abs(matrix - matrix.T).max() < 1e-9 * matrix.max()
    whole = np.zeros((15, 6))
    for axis, unit in enumerate(np.eye(3)):
        whole[:, axis] = np.tile(unit, 5)
        whole[:, 3 + axis] = np.cross(unit, frame.points).ravel()
    assert np.abs(matrix @ whole).max() < 1e-7 * matrix.max()
    sizes = np.linalg.eigvalsh(matrix)
    assert sizes[0] > -1e-9 * sizes[-1]


def test_a_corner_twists_the_bar_beside_it() -> None:
    """A Z in plan of bars of length 1, an outer end lifted: it bends both outer bars and twists
    the one between them, 1/k = l^3/(3 E I) twice, and l (l)^2/(G J).

    The middle bar is held against turning about x by what holds its two joints: their
    displacements, and the other outer bar, whose far end is held.
    """
    frame = line((0, 1, 0), (0, 0, 0), (1, 0, 0), (1, 1, 0))
    matrix = frame.stiffness
    by_hand = 2 / (3 * STEEL * UP) + 1 / (BAR.shear * BAR.torsion)
    assert matrix[11, 11] == pytest.approx(1 / by_hand, rel=1e-9)


SLIDING: dict[str, Any] = {
    "supports": [{"at": "feet", "kind": "sliding"}],
    "crease_stiffness": "rigid",
    "line_strength": 1e6,
    "cells": 1,
}
LOAD = {"at": [4, 2], "force": [0.0, 0.0, -500.0]}


def loaded(points: list[dict[str, Any]], keys: dict[str, Any]) -> Analysis:
    return arch({**SLIDING, **keys}, [{"name": "point", "points": points}])


def test_a_shell_on_a_rail_is_one_that_the_rails_forces_act_on() -> None:
    """Without the rail, and with its forces -K u at the feet, the shell is displaced alike."""
    found = loaded([LOAD], {"rail": RAIL}).cases[0].equilibrium
    assert found is not None
    model = found.model
    assert len(model.rails) == 2
    points = [LOAD]
    for rail in model.rails:
        forces = -(rail.stiffness @ found.displacements[rail.nodes].ravel()).reshape(-1, 3)
        for node, force in zip(rail.nodes.tolist(), forces, strict=True):
            at = [node // model.grid.columns, node % model.grid.columns + model.before]
            points.append({"at": at, "force": force.tolist()})
    bare = loaded(points, {}).cases[0].equilibrium
    alone = loaded([LOAD], {}).cases[0].equilibrium
    assert bare is not None
    assert alone is not None
    size = found.displacement.size
    assert bare.displacements == pytest.approx(found.displacements, abs=1e-5 * size)
    # It does something: it is not the shell without it.
    assert abs(alone.displacement.size - size) > 0.01 * size
    most = found.rail
    assert most is not None
    stresses = np.concatenate(
        [each.stresses(found.displacements[each.nodes]) for each in model.rails]
    )
    assert most.size == stresses.max()
    assert found.utilisation.rail == pytest.approx(most.size / 235e6)


def test_three_joints_that_are_no_line_tip() -> None:
    """The middle one is lifted for nothing: the triangle turns about the line of the others."""
    matrix = line((0, 0, 0), (1, 0.3, 0), (2, 0, 0)).stiffness
    assert abs(matrix[5, 5]) < 1e-7 * matrix.max()


def test_a_rail_keeps_the_distances_of_feet_on_the_ground() -> None:
    """With free creases a pull at a foot folds the shell on rough ground; a rail hinders that."""
    ground = {
        "supports": [{"at": "feet", "kind": "friction", "friction": 0.6}],
        "crease_stiffness": "free",
    }
    pull = {"at": [0, 2], "force": [0.0, 0.0, 300.0]}
    sizes = []
    for keys in (ground, {**ground, "rail": RAIL}):
        case = [{"name": "pull", "self_weight": True, "points": [pull]}]
        found = arch({**SLIDING, **keys}, case).cases[0].equilibrium
        assert found is not None
        assert found.residual < 1e-9
        feet = found.model.standing
        assert feet is not None
        first = feet[: len(feet) // 2]
        before = found.model.mesh.facets.points[first]
        apart = np.linalg.norm(np.diff(before, axis=0), axis=1)
        after = np.linalg.norm(np.diff(before + found.displacements[first], axis=0), axis=1)
        sizes.append((float(np.abs(after - apart).max()), found.displacement.size))
    # 1.5 mm without, micrometres with it; and the crown moves by 30 and 18 mm.
    assert sizes[1][0] < 0.02 * sizes[0][0]
    assert sizes[1][1] < 0.7 * sizes[0][1]


def test_its_mass_is_own_weight_and_in_the_order() -> None:
    """Steel of 7850 kg/m3 and 976 mm2, as long as from foot to foot."""
    case = [{"name": "own", "self_weight": True}]
    with_, without = (arch({**SLIDING, **keys}, case) for keys in ({"rail": RAIL}, {}))
    model = with_.model
    feet = model.positions[[0, -1]]
    length = float(np.linalg.norm(np.diff(feet, axis=1), axis=-1).sum())
    mass = 7850 * 976e-6 * length
    more = without.cases[0].load[2] - with_.cases[0].load[2]
    assert more == pytest.approx(mass * GRAVITY)
    (row,) = rail_order(model)
    assert row.item == "base rail"
    assert row.used == pytest.approx(length)
    assert row.mass_kg == pytest.approx(mass)
    assert row.what.replace("\u00a0", " ") == "8 bars, steel, 50 mm x 80 mm, walls of 4 mm"
    assert rail_order(without.model) == ()
    tables = [each for each in model_section(model, Quantities("m")).parts if hasattr(each, "rows")]
    assert "Base rail" in {row[0] for table in tables for row in table.rows}


def test_large_displacements_have_the_rail() -> None:
    """A small load, followed: as by linear theory, to 1e-3."""
    small = {"at": [4, 2], "force": [0.0, 0.0, -5.0]}
    sizes = []
    for nonlinear in (False, True):
        found = loaded([small], {"rail": RAIL, "nonlinear": nonlinear}).cases[0].equilibrium
        assert found is not None
        assert found.rail is not None
        sizes.append((found.displacement.size, found.rail.size))
    assert sizes[1] == pytest.approx(sizes[0], rel=1e-3)


def test_no_deck_is_written_with_a_rail(tmp_path: Path) -> None:
    from types import SimpleNamespace

    found = loaded([LOAD], {"rail": RAIL})
    document: Any = SimpleNamespace(loaded=found.loaded())
    with pytest.raises(InputError, match="base rails are not written"):
        write_calculix(tmp_path / "deck.inp", document, cast("Any", None))


STRUCTURE = (
    '[structure]\nmaterial = "steel"\nthickness = 0.002\n'
    'supports = [{ at = "feet", kind = "pinned" }]\nrail = { %s }\n'
)


@pytest.mark.parametrize(
    ("rail", "says"),
    [
        ("width = 0.05, height = 0.05", "material"),
        ('material = "steel", width = 0.05', "height"),
        ('material = "oak", width = 0.05, height = 0.05', "birch plywood"),
        ('material = "steel", width = 0, height = 0.05', "width"),
        ('material = "steel", width = -0.1, height = 0.05', "width"),
        ('material = "steel", width = 0.05, height = 0.05, wall = 0.025', "solid bar has none"),
        ('material = "steel", width = 0.05, height = 0.05, wall = 0', "wall"),
        ('material = "steel", width = "50 mm", height = 0.05', "width"),
        ('material = "steel", width = 0.05, height = 0.05, walls = 0.003', "Did you mean wall?"),
    ],
)
def test_bad_values_are_refused(tmp_path: Path, rail: str, says: str) -> None:
    with pytest.raises(InputError, match=says):
        read(tmp_path, STRUCTURE % rail)


def test_a_rail_deeper_than_long_is_refused() -> None:
    from orishell.motion.grid import Grid
    from orishell.structure.rail import lay_rails
    from orishell.structure.rail_settings import BaseRail

    points = np.zeros((9, 3))
    points[:3, 0] = 0.0, 0.4, 0.7
    feet = np.array([0, 1, 2])
    for height in (0.39, 0.41):
        asked = BaseRail(material="steel", width=0.05, height=height)
        if height < 0.4:
            assert len(lay_rails(asked, feet, points, (Grid(3, 3), 0), "m")) == 1
            continue
        with pytest.raises(InputError, match=r"deeper than it is long.*0\.41 m.*at most 0\.4 m"):
            lay_rails(asked, feet, points, (Grid(3, 3), 0), "m")


def test_a_shell_without_feet_is_refused() -> None:
    from orishell.motion.grid import Grid
    from orishell.structure.rail import lay_rails
    from orishell.structure.rail_settings import BaseRail

    asked = BaseRail(material="steel", width=0.05, height=0.05)
    points = np.zeros((9, 3))
    for feet in (None, np.array([1, 7])):
        with pytest.raises(InputError, match="no feet that a base rail could join"):
            lay_rails(asked, feet, points, (Grid(3, 3), 0), "m")

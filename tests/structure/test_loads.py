"""Loads against hand calculations on a tent, their totals, and what they must not depend on."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest

from orishell.conventions.errors import InputError
from orishell.motion.grid import Grid
from orishell.numerics.arrays import Array
from orishell.structure.load_settings import (
    LOADS,
    NO_CODE,
    LoadCase,
    PointLoad,
    Snow,
    Terrain,
    Wind,
    Zone,
    loads_of,
)
from orishell.structure.loads import (
    Exposure,
    case_loads,
    gusts,
    peak_pressure,
    require_effects,
    sum_forces,
)
from orishell.structure.mesh.sheet import mesh_sheet

SLOPE = np.deg2rad(40)
SPAN, LENGTH = 4.0, 3.0
RISE = 0.5 * SPAN * np.tan(SLOPE)
PLAN = SPAN * LENGTH
AREA = PLAN / np.cos(SLOPE)
BARE = Wind(speed=26, terrain="II", direction_deg=0.0)
BREEZE = Wind(speed=26, terrain="II", direction_deg=0.0, coefficients=((0.0, 1.0), (180.0, 1.0)))


def tent(slope: float = SLOPE, unit: float = 1.0, *, turned: bool = False) -> Exposure:
    """Two panels of 4 x 3 m in plan, the ridge along y; rows run against x where it is turned."""
    x = unit * SPAN * np.array([-0.5, 0, 0.5])
    y = unit * np.array([0, LENGTH])
    positions = np.empty((3, 2, 3))
    positions[..., 0], positions[..., 1] = np.meshgrid(x, y, indexing="ij")
    positions[..., 2] = (0.5 * unit * SPAN - np.abs(positions[..., 0])) * np.tan(slope)
    if turned:
        positions = positions[::-1]
    grid = Grid(3, 2)
    mesh = mesh_sheet(positions, grid, 3)
    panels = np.repeat(np.arange(2), len(mesh.facets.triangles) // 2)
    mass = np.full(len(panels), 1.9 / unit**2)
    hung = np.zeros(len(mesh.facets.points))
    return Exposure(mesh.facets, panels, grid, 0, mass, hung, "m", 0.0, unit * SPAN, (0, 2))


def case_forces(exposure: Exposure, case: LoadCase, cases: Sequence[LoadCase]) -> Array:
    return sum_forces(exposure, case_loads(exposure, case, cases))


def total(exposure: Exposure, case: LoadCase) -> Array:
    """Sum (3,) of all forces."""
    return np.asarray(case_forces(exposure, case, [case]).sum(axis=0))


@pytest.mark.parametrize(
    ("terrain", "height", "pressure"),
    [
        # II: k_r = 0.19, ln(10/0.05) = 5.29832; c_r = 1.00668, v_m = 26.1737 m/s,
        # I_v = 0.188739, q = 2.321173 * 0.625 * 685.0626 = 993.83.
        ("II", 10.0, 993.83),
        # Below z_min = 2 m: ln 40 = 3.688879; v_m = 18.22306, q = 2.897598 * 0.625 * 332.0799.
        ("II", 1.2, 601.39),
        # IV at 20 m: k_r = 0.19 * 20^0.07 = 0.2343288, ln 20 = 2.995732; v_m = 18.25165,
        # q = 3.336658 * 0.625 * 333.1225 = 694.70.
        ("IV", 20.0, 694.70),
    ],
)
def test_peak_pressure_by_hand(terrain: Terrain, height: float, pressure: float) -> None:
    assert peak_pressure(*gusts(26, terrain, height)) == pytest.approx(pressure, rel=2e-5)


def test_own_weight_is_mass_times_gravity() -> None:
    weight = 9.81 * 1.9 * AREA
    np.testing.assert_allclose(total(tent(), LoadCase(name="g", self_weight=True)), [0, 0, -weight])


def test_flaps_hang_on_their_vertices() -> None:
    hung = np.zeros(len(tent().mesh.points))
    hung[[0, 3]] = 2, 5
    flaps = replace(tent(), hung=hung)
    case = LoadCase(name="g", self_weight=True)
    more = case_forces(flaps, case, [case]) - case_forces(tent(), case, [case])
    np.testing.assert_allclose(more[[0, 3]], [[0, 0, -2 * 9.81], [0, 0, -5 * 9.81]])
    np.testing.assert_allclose(more.sum(axis=0), [0, 0, -7 * 9.81])


def test_pressure_on_the_outer_face_presses_on_the_plan() -> None:
    # The sum of area vectors is the plan's, whatever stands on it.
    np.testing.assert_allclose(
        total(tent(), LoadCase(name="p", pressure=100.0)), [0, 0, -100 * PLAN], atol=1e-9
    )


def test_wind_by_hand() -> None:
    """From -x on a tent of 40 degrees: outer normals at 50 and 130 degrees to where it comes from.

    Coefficients 0.8 - 1.6 * 50/90 = -0.08889 and -0.8 + 0.4 * 40/90 = -0.62222; q at the ridge,
    1.678 m, is that of z_min = 2 m (see above). A face of 7.832 m2 is 6 m2 in plan, 5.0346 m2 from
    the side: suction -0.08889 pulls to -x and up, -0.62222 to +x and up.
    """
    coefficients = ((0.0, 0.8), (90.0, -0.8), (180.0, -0.4))
    found = total(
        tent(),
        LoadCase(
            name="wind",
            wind=Wind(speed=26, terrain="II", direction_deg=0.0, coefficients=coefficients),
        ),
    )
    sideways = 601.39 * 5.0346 * (0.62222 - 0.08889)
    up = 601.39 * 6 * (0.62222 + 0.08889)
    np.testing.assert_allclose(found, [sideways, 0, up], rtol=1e-4, atol=1e-9)


def test_a_coefficient_of_one_all_round_is_pressure() -> None:
    pressure = LoadCase(name="p", pressure=peak_pressure(*gusts(26, "II", RISE)))
    wind = LoadCase(name="w", wind=BREEZE)
    np.testing.assert_allclose(
        case_forces(tent(), wind, [wind]), case_forces(tent(), pressure, [pressure])
    )


def test_zones_are_rows_of_panels() -> None:
    zones = (Zone(rows=(0, 0), coefficient=1.0), Zone(rows=(1, 1), coefficient=-1.0))
    found = total(
        tent(),
        LoadCase(name="w", wind=BARE.replace_unchecked(zones=zones, height=10.0)),
    )
    np.testing.assert_allclose(found, [2 * 993.83 * 5.0346, 0, 0], rtol=1e-4, atol=1e-9)


def test_wind_from_the_other_side_is_the_mirror_image() -> None:
    there, back = (
        total(
            tent(),
            LoadCase(
                name="w", wind=BREEZE.replace_unchecked(direction_deg=way, coefficients=NO_CODE)
            ),
        )
        for way in (0.0, 180.0)
    )
    np.testing.assert_allclose(there, back * [-1, 1, 1], atol=1e-9)
    assert there[0] > 0  # NO_CODE blows it the way that the wind goes


EVERYTHING = LoadCase(
    name="all",
    self_weight=True,
    pressure=30.0,
    snow=Snow(ground=500, arrangement="undrifted"),
    wind=BREEZE.replace_unchecked(coefficients=NO_CODE),
    points=(PointLoad(at=(1, 1), force=(10.0, 20.0, -30.0)),),
)


def test_forces_are_the_same_whichever_way_rows_run() -> None:
    # The panels' normals point down instead of up: the outer face is still the upper one.
    np.testing.assert_allclose(
        total(tent(), EVERYTHING), total(tent(turned=True), EVERYTHING), rtol=1e-12
    )


def test_forces_are_the_same_in_any_unit() -> None:
    """Newtons stay: loads per area are given per square of the unit."""
    per = 1e-6
    small = EVERYTHING.replace_unchecked(
        pressure=30.0 * per, snow=Snow(ground=500 * per, arrangement="undrifted")
    )
    metres = case_forces(tent(), EVERYTHING, [EVERYTHING])
    millimetres = case_forces(replace(tent(unit=1e3), unit="mm"), small, [small])
    np.testing.assert_allclose(millimetres, metres, rtol=1e-12, atol=1e-9)


def test_a_combination_is_the_sum_of_its_cases() -> None:
    dead, snow = (
        LoadCase(name="dead", self_weight=True),
        LoadCase(name="snow", snow=Snow(ground=500, arrangement="undrifted")),
    )
    both = LoadCase(name="both", combine={"dead": 1.35, "snow": 1.5})
    cases = (both, dead, snow)
    parts = [case_forces(tent(), case, cases) for case in (dead, snow)]
    np.testing.assert_allclose(
        case_forces(tent(), both, cases), 1.35 * parts[0] + 1.5 * parts[1], rtol=1e-12
    )


def test_a_point_load_is_at_its_vertex_beside_folded_flaps() -> None:
    # The folding sheet has a column more on either side: its column 2 is column 1 of the mesh.
    case = LoadCase(name="p", points=(PointLoad(at=(2, 2), force=(1.0, 2.0, 3.0)),))
    found = case_forces(replace(tent(), before=1), case, [case])
    place = np.flatnonzero(found.any(axis=1))
    np.testing.assert_allclose(tent().mesh.points[place], [[2, LENGTH, 0]], atol=1e-15)
    np.testing.assert_array_equal(found[place], [[1, 2, 3]])


def test_loads_of_a_combination_are_told_apart() -> None:
    dead, all_ = (
        LoadCase(name="dead", self_weight=True),
        EVERYTHING.replace_unchecked(self_weight=False),
    )
    both = LoadCase(name="both", combine={"dead": 1.35, "all": 1.5})
    loads = case_loads(tent(), both, (dead, all_, both))
    assert [(load.case, load.factor, load.kind) for load in loads] == [
        ("dead", 1.35, "self_weight"),
        ("all", 1.5, "pressure"),
        ("all", 1.5, "snow"),
        ("all", 1.5, "wind"),
        ("all", 1.5, "points"),
    ]
    np.testing.assert_allclose(loads[1].forces.sum(axis=0), [0, 0, -45 * PLAN], atol=1e-9)
    np.testing.assert_allclose(loads[4].forces.sum(axis=0), [15, 30, -45])


@pytest.mark.parametrize(
    ("case", "says"),
    [
        (LoadCase(name="a", points=(PointLoad(at=(3, 0), force=(0, 0, 1)),)), "a row from 0 to 2"),
        (
            LoadCase(name="a", points=(PointLoad(at=(0, 2), force=(0, 0, 1)),)),
            "a column from 0 to 1",
        ),
        (
            LoadCase(
                name="a",
                wind=BARE.replace_unchecked(zones=(Zone(rows=(0, 0), coefficient=1.0),)),
            ),
            "rows 0 to 1",
        ),
        (
            LoadCase(
                name="a",
                wind=BARE.replace_unchecked(zones=(Zone(rows=(0, 2), coefficient=1.0),)),
            ),
            "rows 0 to 1",
        ),
        (
            LoadCase(
                name="a",
                wind=BARE.replace_unchecked(
                    zones=(
                        Zone(rows=(0, 1), coefficient=1.0),
                        Zone(rows=(1, 1), coefficient=1.0),
                    )
                ),
            ),
            "got 0 to 1, 1 to 1",
        ),
        (
            LoadCase(
                name="a",
                snow=Snow(ground=500, shape="cylinder", arrangement="drifted left"),
            ),
            'shape = "valleys"',
        ),
    ],
)
def test_what_is_not_there_is_named(case: LoadCase, says: str) -> None:
    with pytest.raises(InputError, match=r'^\[\[load_case\]\] "a": ') as caught:
        case_forces(replace(tent(), span=None, feet=None), case, [case])
    assert says in str(caught.value)


def test_what_a_new_load_lacks_is_named() -> None:
    """How long it lasts, where its key is; what it does, where the package is loaded."""

    class IcyCase(LoadCase):
        ice: float = 0.0

    others = LoadCase.model_fields.keys() - LOADS.keys()
    with pytest.raises(TypeError, match="load ice of a case has no Loading"):
        loads_of(IcyCase, others)
    with pytest.raises(TypeError, match=r"@load for ice$"):
        require_effects([*LOADS, "ice"])

"""Rules of EN 1991-1-3 and EN 1991-1-4 against hand calculations on tents and zigzags."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest
from pydantic import ValidationError

from orishell.conventions.errors import InputError
from orishell.motion.grid import Grid
from orishell.structure.combinations import arranged
from orishell.structure.load_settings import SHAPES, LoadCase, Snow, Wind
from orishell.structure.loads import Exposure, Load, case_loads
from orishell.structure.mesh.sheet import mesh_sheet

PEAK = 993.83
"""Of 26 m/s in terrain II at 10 m, see test_loads.py (N/m2)."""
SPAN, LENGTH = 4.0, 3.0
TURN = np.deg2rad(30)


def folded(heights: Sequence[float], length: float = LENGTH, turn: float = 0.0) -> Exposure:
    """Panels of equal width across 4 m, folded at these heights, along the axis y; then turned."""
    positions = np.empty((len(heights), 2, 3))
    x = np.linspace(-0.5 * SPAN, 0.5 * SPAN, len(heights))
    positions[..., 0], positions[..., 1] = np.meshgrid(x, [0, length], indexing="ij")
    positions[..., 2] = np.array(heights)[:, None]
    rotation = [[np.cos(turn), np.sin(turn), 0], [-np.sin(turn), np.cos(turn), 0], [0, 0, 1]]
    grid = Grid(len(heights), 2)
    mesh = mesh_sheet(positions @ rotation, grid, 8)
    mass, hung = np.zeros(len(mesh.panels)), np.zeros(len(mesh.facets.points))
    feet = (0, len(heights) - 1)
    return Exposure(mesh.facets, mesh.panels, grid, 0, mass, hung, "m", 0.0, SPAN, feet)


def load(exposure: Exposure, snow: Snow | None = None, wind: Wind | None = None) -> Load:
    (found,) = case_loads(exposure, LoadCase(name="case", snow=snow, wind=wind), ())
    return found


def lever(exposure: Exposure, found: Load) -> float:
    """Moment of vertical forces about the ridge, over their sum: its distance from there."""
    x = exposure.mesh.points @ [np.cos(TURN), np.sin(TURN), 0]
    return float(found.forces[:, 2] @ x / found.forces[:, 2].sum())


@pytest.mark.parametrize(
    ("rise", "most"),
    # mu_3 = 0.2 + 10 h/b: 0.2 + 10 * 0.2/4 = 0.7; at most 2, from h/b = 0.18 on.
    [(0.2, 0.7), (0.72, 2.0), (3.0, 2.0)],
)
def test_drifts_on_a_cylinder_by_hand(rise: float, most: float) -> None:
    """Two triangles over half the width each, mu_3/2 and mu_3 high: 3/8 mu_3 on the mean.

    Their middles are 1 m from the ridge, and one weighs twice as much: 1/3 m on the whole.
    """
    exposure = folded([0, rise, 0], turn=TURN)
    for side, towards in (("left", -1), ("right", 1)):
        asked = Snow.model_validate(
            {"ground": 500.0, "shape": "cylinder", "arrangement": f"drifted {side}"}
        )
        found = load(exposure, snow=asked)
        assert found.force[2] == pytest.approx(-500 * 0.375 * most * SPAN * LENGTH)
        assert lever(exposure, found) == pytest.approx(towards / 3)
        assert f"drifted towards {'-+'[towards > 0]}x: mu_3 = {most:g} there" in found.rule


@pytest.mark.parametrize("rise", [0.2, 6.0])
def test_undrifted_snow_lies_on_any_slope_of_folds(rise: float) -> None:
    # 5.3.2 (2): where it does not slide off, mu is 0.8 at least.
    for shape in ("cylinder", "valleys"):
        asked = Snow.model_validate({"ground": 500.0, "shape": shape, "arrangement": "undrifted"})
        found = load(folded([0, rise, 0]), snow=asked)
        np.testing.assert_allclose(found.force, [0, 0, -500 * 0.8 * SPAN * LENGTH], rtol=1e-12)
        assert not found.caution


@pytest.mark.parametrize(
    ("slope", "valley"),
    # mu_2 of table 5.2: 0.8 + 0.8 * 15/30 = 1.2 at 15 degrees, 1.6 from 30 degrees on.
    [(15, 1.2), (30, 1.6), (45, 1.6)],
)
def test_snow_in_a_valley_by_hand(slope: float, valley: float) -> None:
    """Four panels of 1 m with a valley in the middle: 0.8 outside, from 0.8 to mu_2 inside."""
    asked = Snow(ground=500, shape="valleys", arrangement="in valleys")
    ridge = float(np.tan(np.deg2rad(slope)))
    found = load(folded([0, ridge, 0, ridge, 0]), snow=asked)
    shares = 2 * 0.8 + 2 * 0.5 * (0.8 + valley)
    np.testing.assert_allclose(found.force, [0, 0, -500 * shares * LENGTH], rtol=1e-12)
    # Where creases only step down, there is no valley.
    stepped = load(folded([0, 1, 1.2, 2.2, 0]), snow=asked)
    np.testing.assert_allclose(stepped.force, [0, 0, -500 * 0.8 * SPAN * LENGTH], rtol=1e-12)


def test_snow_on_folds_is_a_vaults_and_a_corrugations() -> None:
    """What is not asked otherwise has the undrifted snow and the drifts of both rules."""
    exposure = folded([0, 1, 0, 1, 0])
    asked = {shape: Snow.model_validate({"ground": 500.0, "shape": shape}) for shape in SHAPES}

    def loads(snow: Snow) -> dict[str | None, list[float]]:
        arranged = {each.arrangement: load(exposure, snow=each) for each in snow.arrangements}
        return {each: found.forces.ravel().tolist() for each, found in arranged.items()}

    assert Snow(ground=500.0) == asked["both"]
    assert loads(asked["both"]) == loads(asked["cylinder"]) | loads(asked["valleys"])


def vault(**asked: object) -> Wind:
    return Wind.model_validate(
        {
            "speed": 26.0, "terrain": "II", "direction_deg": 0.0, "height": 10.0,
            "vault": (0.6, -1.0, -0.4), **asked,
        }
    )  # fmt: skip


@pytest.mark.parametrize("towards", [1, -1])
def test_zones_of_a_vault_by_hand(towards: int) -> None:
    """Quarters of the width, 1 m each: 0.6 on the first, -1 on two, -0.4 on the last.

    Rows of panels are half the width: zones part them. On plan 3 m2 each, from the side 3 m times
    half the rise: 0.5 * 1.5 * 3 = 2.25 m2.
    """
    direction = 0.0 if towards > 0 else 180.0
    found = load(folded([0, 1.5, 0]), wind=vault(direction_deg=direction))
    sideways = PEAK * 2.25 * (0.6 - 1.0 + 1.0 + 0.4)
    up = PEAK * 3 * (2 * 1.0 + 0.4 - 0.6)
    np.testing.assert_allclose(found.force, [towards * sideways, 0, up], rtol=1e-4, atol=1e-9)
    assert "in zones A, B, C of a vault" in found.rule
    assert "f/d = 0.375, h/d = 0" in found.rule
    assert not found.caution


def test_a_vault_beyond_the_figure_is_named() -> None:
    assert "has no pressure coefficients for vaults of f/d = 0.75" in (
        load(folded([0, 3, 0]), wind=vault()).caution
    )
    with pytest.raises(InputError, match="blows across it; got direction_deg = 50"):
        load(folded([0, 1, 0]), wind=vault(direction_deg=50.0))


def test_pressure_inside_is_taken_off() -> None:
    exposure = folded([0, 1.5, 0])
    outside = load(exposure, wind=vault())
    for inside in (0.2, -0.3):
        found = load(exposure, wind=vault(internal=(inside,)))
        more = np.subtract(found.force, outside.force)
        np.testing.assert_allclose(
            more, [0, 0, PEAK * inside * SPAN * LENGTH], rtol=1e-4, atol=1e-9
        )


def test_air_rubs_behind_four_heights() -> None:
    """Along a tent of 12 m, 1.5 m high: 4 h = 6 m is less than 2 b = 8 m, so half is swept."""
    exposure = folded([0, 1.5, 0], length=12)
    still = vault(direction_deg=90.0, vault=None, coefficients=((0.0, 0.0), (180.0, 0.0)))
    found = load(exposure, wind=still.replace_unchecked(friction=0.04))
    area = 6 * 2 * 2.5
    np.testing.assert_allclose(found.force, [0, PEAK * 0.04 * area, 0], rtol=1e-4, atol=1e-9)
    # A tent of 3 m is too short for it.
    short = load(folded([0, 1.5, 0]), wind=still.replace_unchecked(friction=0.04))
    np.testing.assert_array_equal(short.force, [0, 0, 0])


def test_every_arrangement_is_a_case() -> None:
    snow = LoadCase(name="snow", snow=Snow(ground=500, shape="cylinder"))
    wind = LoadCase(name="wind", wind=vault(internal=(0.2, -0.3)))
    both = LoadCase(name="both", combine={"wind": 1.5, "snow": 0.75})
    found = {case.name: case for case in arranged([snow, wind, both])}
    assert list(found)[:5] == [
        "snow, undrifted",
        "snow, drifted left",
        "snow, drifted right",
        "wind, pressure 0.2 inside",
        "wind, suction 0.3 inside",
    ]
    assert len(found) == 5 + 6
    last = found["both, suction 0.3 inside, drifted right"]
    assert last.combine == {"wind, suction 0.3 inside": 1.5, "snow, drifted right": 0.75}
    # One that is named keeps the case's name.
    one = LoadCase(name="snow", snow=Snow(ground=5, shape="valleys", arrangement="in valleys"))
    assert [case.name for case in arranged([one])] == ["snow"]


@pytest.mark.parametrize(
    "asked",
    [
        {"shape": "cylinder", "arrangement": "in valleys"},
        {"shape": "valleys", "arrangement": "drifted left"},
    ],
)
def test_an_arrangement_is_one_of_its_shape(asked: dict[str, str]) -> None:
    with pytest.raises(ValidationError, match="for snow of this shape"):
        Snow.model_validate({"ground": 500.0, **asked})


def test_left_is_the_mirror_image_of_right() -> None:
    exposure = folded([0, 0.8, 1, 0.8, 0])
    left, right = (
        load(exposure, snow=Snow(ground=500, shape="cylinder", arrangement=each)).forces[:, 2]
        for each in ("drifted left", "drifted right")
    )
    x = exposure.mesh.points[:, 0]
    assert left @ x == pytest.approx(-(right @ x))
    assert left.sum() == pytest.approx(right.sum())

"""Materials by name in any unit, and values that can hardly be meant."""

from __future__ import annotations

from pathlib import Path

import pytest

from orishell.conventions.errors import InputError
from orishell.design import PanelSpec
from orishell.design_file import DesignFile, read_design_file
from orishell.structure.load_settings import LoadCase, Snow, Wind
from orishell.structure.materials import materials
from orishell.structure.plausibility import doubts
from orishell.structure.settings import Structure, Support

DESIGN = """
[shell]
family = "parallel-repeating"
unit = "{unit}"
[target.f]
formula = "-x**2"
range = [-1, 1]
[target.g]
formula = "0.1*x"
range = [0, 10]
[pattern]
rows = 5
columns = 7
flap = 0.3
xi_deg = 50
"""
ASKED = """
[structure]
material = "birch plywood"
supports = [{ at = "feet", kind = "pinned" }]
"""


def read(directory: Path, tables: str, unit: str = "m") -> DesignFile:
    path = directory / "shell.toml"
    path.write_text(DESIGN.format(unit=unit) + tables)
    return read_design_file(path)


@pytest.mark.parametrize("name", list(materials()))
def test_every_material_says_where_it_comes_from(name: str) -> None:
    found = materials()[name]
    assert len(found.source) > 40
    assert len(found.conservative) > 40
    assert 0 <= found.poisson <= 0.5
    bare = structure(modulus=found.modulus, strength=found.bears("permanent", 3))
    panel = PanelSpec(thickness=0.01, membrane=0.001, density=found.density)
    assert not list(doubts(bare, "m", panel))


@pytest.mark.parametrize(
    ("unit", "modulus", "strength"),
    # 6.7 GPa, and 0.5 x 33.2/1.2 MPa outdoors, in newtons per square metre, millimetre and inch.
    [("m", 6.7e9, 13.833e6), ("mm", 6700, 13.833), ("in", 6700 * 25.4**2, 13.833 * 25.4**2)],
)
def test_a_material_in_any_unit(tmp_path: Path, unit: str, modulus: float, strength: float) -> None:
    found = read(tmp_path, f"{ASKED}thickness = 0.5", unit).structure
    assert found is not None
    assert found.modulus == pytest.approx(modulus)
    assert found.strength is None
    assert found.bears("permanent", unit) == pytest.approx(strength, rel=1e-4)
    assert found.poisson == 0.3


def test_what_is_given_is_not_taken_from_the_material(tmp_path: Path) -> None:
    given = read(tmp_path, f"{ASKED}thickness = 0.01\nmodulus = 9e9\npoisson = 0.1").structure
    assert given is not None
    assert (given.modulus, given.poisson) == (9e9, 0.1)
    strong = read(tmp_path, f"{ASKED}thickness = 0.01\nstrength = 5e6").structure
    assert strong is not None
    assert strong.bears("short", "m") == 5e6


def test_a_material_weighs_what_nobody_weighed(tmp_path: Path) -> None:
    bare = read(tmp_path, f"{ASKED}thickness = 10", "mm")
    assert bare.workshop.areal_density == pytest.approx(680 * 0.010)
    known = read(tmp_path, f"{ASKED}thickness = 10\n[workshop]\nareal_density = 5", "mm")
    assert known.workshop.areal_density == 5
    panel = "\n[panel]\nthickness = 0.01\nmembrane = 0.001\nmembrane_density = 1000\n"
    thick = read(tmp_path, ASKED + panel).panel
    assert thick is not None
    assert thick.density == 680
    heavy = read(tmp_path, f"{ASKED}{panel}density = 600").panel
    assert heavy is not None
    assert heavy.density == 600


def test_an_unknown_material_is_told_which_there_are(tmp_path: Path) -> None:
    with pytest.raises(InputError) as caught:
        read(tmp_path, ASKED.replace("birch", "oak"))
    assert "[structure] material: " in str(caught.value)
    for name in materials():
        assert f'"{name}"' in str(caught.value)


def structure(**values: object) -> Structure:
    return Structure.model_validate(
        {
            "modulus": 7e9,
            "supports": (Support(at="feet", kind="pinned"),),
            "cases": (LoadCase(name="dead", self_weight=True),),
            **values,
        }
    )


@pytest.mark.parametrize(
    ("values", "unit", "says"),
    [
        ({"modulus": 11.0}, "m", "modulus = 11 is 11 N/m2 (1.1e-8 GPa)"),
        ({"modulus": 11.0}, "m", "1 GPa is 1e9 here"),
        ({"modulus": 11e9}, "mm", "modulus = 1.1e+10 is 1.1e16 N/m2 (1.1e7 GPa)"),
        ({"modulus": 11e9}, "mm", "1 GPa is 1000 here"),
        ({"membrane_modulus": 1.0}, "m", "membrane_modulus = 1 is 1 N/m2"),
        ({"strength": 16.0}, "m", "strength = 16 is 16 N/m2"),
        ({"strength": 1e9}, "m", "strength = 1e+09 is 14.3 % of modulus"),
        (
            {"cases": (LoadCase(name="a", snow=Snow(ground=0.5, arrangement="undrifted")),)},
            "m",
            "load case a: snow of 0.5 on the ground is 0.5 N/m2; 1 kN/m2 is 1000 here",
        ),
        (
            {"cases": (LoadCase(name="a", wind=Wind(speed=0.5, terrain="I", direction_deg=0)),)},
            "m",
            "load case a: wind speed = 0.5 is in metres per second",
        ),
    ],
)
def test_what_can_hardly_be_meant(values: dict[str, object], unit: str, says: str) -> None:
    assert any(says in text for text in doubts(structure(**values), unit, None))


def test_densities_are_by_cubic_metre() -> None:
    light = PanelSpec(thickness=0.01, membrane=0.001, density=0.68, membrane_density=1.0)
    first, second = doubts(structure(), "m", light)
    assert first == "density = 0.68 in [panel] is in kilograms per cubic metre: water has 1000"
    assert second.startswith("membrane_density = 1 ")


def test_usual_values_are_not_doubted() -> None:
    """In metres and in millimetres: 7 GPa, 16 MPa, half a kilonewton of snow."""
    snow = (LoadCase(name="a", snow=Snow(ground=500, arrangement="undrifted")),)
    assert not list(doubts(structure(strength=16e6, cases=snow), "m", None))
    small = (LoadCase(name="a", snow=Snow(ground=500e-6, arrangement="undrifted")),)
    found = doubts(structure(modulus=7000.0, strength=16.0, cases=small), "mm", None)
    assert not list(found)

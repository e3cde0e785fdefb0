"""The tables [structure] and [[load_case]]: what they come to, and what is refused."""

from __future__ import annotations

import math
import re
import tomllib
from pathlib import Path

import pytest

from command_line import orishell
from orishell.design_file import read_design_file, starter_file
from orishell.structure.hinge_lines import LineStrength
from orishell.structure.load_settings import LoadCase, PointLoad, Snow, Wind, Zone
from orishell.structure.settings import Structure, StructureTable, Support

DESIGN = """
[shell]
family = "parallel-repeating"
unit = "m"
[target.f]
formula = "-x**2"
range = [-1, 1]
[target.g]
formula = "5*sin(pi*x/10)"
range = [0, 10]
[pattern]
rows = 5
columns = 7
flap = 0.3
xi_deg = 50
"""
STRUCTURE = """
[structure]
modulus = 270e6
thickness = 0.01
supports = [{ at = "feet", kind = "pinned" }]
"""
CASE = """
[[load_case]]
name = "dead"
self_weight = true
"""
FRICTION = '{ at = [[0, 1], [0, 2]], kind = "friction", friction = 0.5 }'
WIND = 'wind = { speed = 26, terrain = "II", direction_deg = 90'
PANEL = "[panel]\nthickness = 0.01\nmembrane = 0.001\n"


def read(directory: Path, tables: str) -> Structure:
    path = directory / "shell.toml"
    path.write_text(DESIGN + tables)
    structure = read_design_file(path).structure
    assert structure is not None
    return structure


def test_without_the_table_nothing_is_analysed(tmp_path: Path) -> None:
    path = tmp_path / "shell.toml"
    path.write_text(DESIGN)
    assert read_design_file(path).structure is None


def test_what_is_left_out(tmp_path: Path) -> None:
    found = read(tmp_path, STRUCTURE)
    assert found == Structure(
        modulus=270e6,
        poisson=0.3,
        supports=(Support(at="feet", kind="pinned"),),
        cases=(LoadCase(name="self-weight", self_weight=True),),
        thickness=0.01,
    )
    assert found.crease_stiffness == (0, math.inf)
    assert found.tie_stiffness == math.inf


def test_every_key(tmp_path: Path) -> None:
    found = read(
        tmp_path,
        f"""
        {PANEL}
        [structure]
        modulus = 270e6
        poisson = 0.25
        strength = 5.5e6
        membrane_modulus = 1e9
        membrane_strength = 5e7
        crease_stiffness = [5.0, "rigid"]
        crease_strength = 20
        line_strength = 3000
        tie_stiffness = 1.2e6
        tie_strength = 5000
        cells = 2
        refine = 0.02
        supports = [{{ at = "ends", kind = "fixed" }}, {FRICTION}]
        [[load_case]]
        name = "all"
        combine = {{ dead = 1.35, gusts = 1.5 }}
        {CASE}
        [[load_case]]
        name = "gusts"
        pressure = 100
        snow = {{ ground = 500, shape = "cylinder", arrangement = "undrifted" }}
        {WIND}, height = 4, coefficients = [[0, 0.8], [90, -0.8], [180, -0.4]] }}
        points = [{{ at = [5, 4], force = [0, 0, -1000] }}]
        """,
    )
    wind = Wind(
        speed=26,
        terrain="II",
        direction_deg=90.0,
        coefficients=((0.0, 0.8), (90.0, -0.8), (180.0, -0.4)),
        height=4,
    )
    assert found == Structure(
        modulus=270e6,
        poisson=0.25,
        supports=(
            Support(at="ends", kind="fixed"),
            Support(at=((0, 1), (0, 2)), kind="friction", friction=0.5),
        ),
        cases=(
            LoadCase(name="all", combine={"dead": 1.35, "gusts": 1.5}),
            LoadCase(name="dead", self_weight=True),
            LoadCase(
                name="gusts",
                pressure=100,
                snow=Snow(ground=500, shape="cylinder", arrangement="undrifted"),
                wind=wind,
                points=(PointLoad(at=(5, 4), force=(0, 0, -1000)),),
            ),
        ),
        strength=5.5e6,
        membrane_modulus=1e9,
        membrane_strength=5e7,
        crease_strength=20,
        line_strength=LineStrength.alike(3000),
        tie_stiffness=1.2e6,
        tie_strength=5000,
        cells=2,
        refine=0.02,
    ).replace_unchecked(crease_stiffness=(5, math.inf))
    assert [case.name for case in found.analysed] == ["all"]


@pytest.mark.parametrize(
    ("written", "meant"),
    [
        ("5.0", (5, 5)),
        ('"free"', (0, 0)),
        ('"rigid"', (math.inf, math.inf)),
        ('["free", 3]', (0, 3)),
        ("[2, 2]", (2, 2)),
    ],
)
def test_stiffness_of_creases(tmp_path: Path, written: str, meant: tuple[float, float]) -> None:
    found = read(tmp_path, f"{STRUCTURE}crease_stiffness = {written}\n")
    assert found.crease_stiffness == meant


def test_pressure_of_wind_by_zones_or_of_no_code(tmp_path: Path) -> None:
    zones = "zones = [{ rows = [0, 2], coefficient = 0.6 }, { rows = [3, 5], coefficient = -0.4 }]"
    case = f'[[load_case]]\nname = "%s"\n{WIND}%s }}\n'
    first, second = read(
        tmp_path, STRUCTURE + case % ("zones", f", {zones}") + case % ("bare", "")
    ).cases
    assert first.wind is not None
    assert first.wind.zones == (
        Zone(rows=(0, 2), coefficient=0.6),
        Zone(rows=(3, 5), coefficient=-0.4),
    )
    assert second.wind is not None
    assert second.wind.is_of_no_code


def commented(table: str) -> str:
    """What the comments of a starter say of a table."""
    lines = starter_file("parallel-repeating").partition(f"# {table} ")[2].partition("\n\n")[0]
    return "\n".join([table, *(line.removeprefix("# ") for line in lines.splitlines()[1:])])


def test_the_starter_explains_every_key(tmp_path: Path) -> None:
    """What its comments say are tables with all keys; but for examples they are the defaults."""
    structure, case = commented("[structure]"), commented("[[load_case]]")
    loads, _, factors = case.partition("combine")
    asked = tomllib.loads(structure)["structure"]
    assert set(asked) == set(StructureTable.model_fields)
    assert set(tomllib.loads(case)["load_case"][0]) == set(LoadCase.model_fields)
    # There is no membrane without [panel], and no arm; no grain where a strength is given.
    structure = re.sub("(membrane_strength|arm_|grain|sandwich).*", "", structure)
    found = read(tmp_path, f"{structure}\n{loads}")
    assert found.crease_stiffness == (0, math.inf)
    for key in ("poisson", "cells", "refine", "membrane_modulus"):
        assert getattr(found, key) == StructureTable.model_fields[key].default
    others = [CASE, CASE.replace("dead", "snow"), '[[load_case]]\nname = "all"']
    assert len(read(tmp_path, "\n".join([structure, *others, f"combine{factors}"])).cases) == 3


def with_case(lines: str) -> str:
    return f'{STRUCTURE}[[load_case]]\nname = "a"\n{lines}\n'


def with_wind(lines: str) -> str:
    return with_case(f"{WIND}, {lines} }}")


BAD = {
    "no modulus": (STRUCTURE.replace("modulus = 270e6", ""), "[structure] modulus: ", "missing"),
    "no supports": (STRUCTURE.partition("supports")[0], "[structure] supports: ", "missing"),
    "empty supports": (
        STRUCTURE.partition("supports")[0] + "supports = []",
        "[structure] supports: ",
        "1 entries",
    ),
    "negative modulus": (STRUCTURE.replace("270e6", "-1"), "[structure] modulus: ", "got -1"),
    "infinite modulus": (STRUCTURE.replace("270e6", "inf"), "modulus: ", "a finite number"),
    "nan": (f"{STRUCTURE}strength = nan", "[structure] strength: ", "a finite number"),
    "a text": (STRUCTURE.replace("270e6", '"stiff"'), "[structure] modulus: ", "a number"),
    "poisson": (f"{STRUCTURE}poisson = 0.6", "[structure] poisson: ", "at most 0.5"),
    "cells": (f"{STRUCTURE}cells = 33", "[structure] cells: ", "at most 32"),
    "half a cell": (f"{STRUCTURE}cells = 2.5", "[structure] cells: ", "a whole number"),
    "refine": (f"{STRUCTURE}refine = 1", "[structure] refine: ", "less than 1"),
    "unknown key": (f"{STRUCTURE}colour = 1", "[structure] colour: ", "unknown key"),
    "slip of a key": (
        f"{STRUCTURE}tie_strenght = 1",
        "tie_strenght: ",
        "Did you mean tie_strength?",
    ),
    "no place": (
        STRUCTURE.replace('"feet"', '"toes"'),
        "[structure] supports[0] at: ",
        "'feet' or 'ends'",
    ),
    "unknown kind": (STRUCTURE.replace("pinned", "glued"), "supports[0] kind: ", "'sliding'"),
    "unknown key of a support": (
        STRUCTURE.replace('"pinned"', '"pinned", frction = 1'),
        "[structure] supports[0] frction: ",
        "Did you mean friction?",
    ),
    "no friction": (
        STRUCTURE.replace("pinned", "friction"),
        "[structure] supports[0] friction: ",
        "above 0",
    ),
    "friction of a pin": (
        STRUCTURE.replace('"pinned"', '"pinned", friction = 0.3'),
        "[structure] supports[0] friction: ",
        "got 0.3, expected no friction",
    ),
    "half a vertex": (STRUCTURE.replace('"feet"', "[[1]]"), "supports[0] at", "2 entries"),
    "three stiffnesses": (f"{STRUCTURE}crease_stiffness = [1, 2, 3]", "stiffness: ", "2 entries"),
    "turned stiffnesses": (
        f'{STRUCTURE}crease_stiffness = ["rigid", 1]',
        "[structure] crease_stiffness: ",
        "the least stiffness first",
    ),
    "word of a stiffness": (
        f'{STRUCTURE}crease_stiffness = "soft"',
        "[structure] crease_stiffness: ",
        "'free' or 'rigid'",
    ),
    "no thickness": (
        STRUCTURE.replace("thickness = 0.01", ""),
        "[structure] thickness: ",
        "or in [panel]",
    ),
    "two thicknesses": (PANEL + STRUCTURE, "[structure] thickness: ", "got 0.01, and 0.01 in"),
    "no membrane": (
        f"{STRUCTURE}membrane_modulus = 1e9",
        "[structure] membrane_modulus: ",
        'construction = "sandwich"',
    ),
    "no membrane to be strong": (
        f"{STRUCTURE}membrane_strength = 5e7",
        "[structure] membrane_strength: ",
        'construction = "sandwich"',
    ),
    "no arms": (
        f"{STRUCTURE}arm_modulus = 210e9",
        "[structure] arm_modulus: ",
        'construction = "hinged"',
    ),
    "no arms to be strong": (
        f"{STRUCTURE}arm_strength = 235e6",
        "[structure] arm_strength: ",
        'construction = "hinged"',
    ),
    "loads on nothing": (CASE, "[[load_case]]: ", "add the table [structure]"),
    "no load": (with_case(""), "[[load_case]][0]: ", "self_weight, pressure, snow"),
    "no name": (STRUCTURE + CASE.replace('name = "dead"', ""), "[[load_case]][0] name", "missing"),
    "empty name": (STRUCTURE + CASE.replace('"dead"', '""'), "[[load_case]][0] name: ", "one line"),
    "two lines of a name": (
        STRUCTURE + CASE.replace('"dead"', '"a\\nb"'),
        "[[load_case]][0] name: ",
        "one line",
    ),
    "one name twice": (STRUCTURE + CASE + CASE, "[[load_case]][1] name: ", "got 'dead'"),
    "loads and factors": (
        STRUCTURE + CASE + CASE.replace("dead", "all") + "combine = { dead = 1.35 }",
        "[[load_case]][1] combine: ",
        "no combine beside self_weight",
    ),
    "no such case": (
        with_case("combine = { dad = 1 }") + CASE,
        "[[load_case]][0] combine: ",
        "got 'dad', expected one of 'dead'",
    ),
    "nested combination": (
        with_case("combine = { b = 1 }")
        + '[[load_case]]\nname = "b"\ncombine = { dead = 1 }'
        + CASE,
        "[[load_case]][0] combine: ",
        "got 'b', expected one of 'dead'",
    ),
    "infinite factor": (
        with_case("combine = { dead = inf }") + CASE,
        "[[load_case]][0] combine dead: ",
        "a finite number",
    ),
    "unknown key of a case": (with_case("snw = 5"), "[[load_case]][0] snw: ", "Did you mean snow?"),
    "a number for snow": (with_case("snow = 500"), "[[load_case]][0] snow: ", "a table"),
    "no snow": (with_case("snow = { ground = 0 }"), "[0] snow ground: ", "greater than 0"),
    "slip of snow": (with_case("snow = { grund = 5 }"), "[0] snow grund: ", "Did you mean ground?"),
    "shape of snow": (
        with_case('snow = { ground = 5, shape = "ball" }'),
        "[[load_case]][0] snow shape: ",
        "'both', 'cylinder' or 'valleys'",
    ),
    "terrain": (
        with_case('wind = { speed = 9, terrain = "V", direction_deg = 0 }'),
        "[[load_case]][0] wind terrain: ",
        "'IV'",
    ),
    "no direction": (
        with_case('wind = { speed = 9, terrain = "I" }'),
        "[[load_case]][0] wind direction_deg: ",
        "missing",
    ),
    "angles that end early": (
        with_wind("coefficients = [[0, 1], [90, 1]]"),
        "[[load_case]][0] wind coefficients: ",
        "from 0 to 180",
    ),
    "angles that descend": (
        with_wind("coefficients = [[0, 1], [90, 1], [80, 1], [180, 1]]"),
        "[[load_case]][0] wind coefficients: ",
        "ascending",
    ),
    "no coefficients": (
        with_wind("coefficients = []"),
        "[[load_case]][0] wind coefficients: ",
        "from 0 to 180",
    ),
    "two kinds of coefficients": (
        with_wind(
            "coefficients = [[0, 1], [180, 1]], zones = [{ rows = [0, 5], coefficient = 1 }]"
        ),
        "[[load_case]][0] wind zones: ",
        "one of coefficients, zones and vault",
    ),
    "zone turned round": (
        with_wind("zones = [{ rows = [4, 0], coefficient = 1 }]"),
        "[[load_case]][0] wind zones[0] rows: ",
        "the first row, then the last",
    ),
    "slip of a zone": (
        with_wind("zones = [{ rows = [0, 4], coefficient = 1, row = 2 }]"),
        "[[load_case]][0] wind zones[0] row: ",
        "Did you mean rows?",
    ),
    "flat force": (
        with_case("points = [{ at = [0, 0], force = [0, 1] }]"),
        "[[load_case]][0] points[0] force: ",
        "3 entries",
    ),
    "no vertex": (
        with_case("points = [{ at = [0, -1], force = [0, 0, 1] }]"),
        "[[load_case]][0] points[0] at[1]: ",
        "at least 0",
    ),
    "a number for a person": (
        with_case("person = 1000"),
        "[[load_case]][0] person: ",
        "a table",
    ),
    "a person of no weight": (
        with_case("person = { force = 0 }"),
        "[[load_case]][0] person force: ",
        "greater than 0",
    ),
    "a person who pulls": (
        with_case("person = { force = -1000 }"),
        "[[load_case]][0] person force: ",
        "greater than 0",
    ),
    "a side of no panel": (
        with_case('person = { side = "left" }'),
        "[[load_case]][0] person side: ",
        "the panel that has it",
    ),
    "no such side": (
        with_case('person = { at = [0, 0], side = "up" }'),
        "[[load_case]][0] person side: ",
        "'middle'",
    ),
    "a panel before the first": (
        with_case("person = { at = [0, -1] }"),
        "[[load_case]][0] person at[1]: ",
        "at least 0",
    ),
    "a person beyond the last panel": (
        with_case("person = { at = [99, 0] }"),
        '[[load_case]] "a": person at: ',
        "a row from 0 to",
    ),
    "a person and factors": (
        STRUCTURE + CASE + '[[load_case]]\nname = "b"\nperson = {}\ncombine = { dead = 1 }',
        "[[load_case]][1] combine: ",
        "no combine beside person",
    ),
}


@pytest.mark.parametrize("name", BAD)
def test_bad_values_are_one_message_and_nothing_is_written(tmp_path: Path, name: str) -> None:
    tables, where, says = BAD[name]
    (tmp_path / "shell.toml").write_text(DESIGN + tables)
    done = orishell("design", "shell.toml", "--out", "out", cwd=tmp_path)
    assert done.returncode == 2
    assert done.stdout == ""
    assert done.stderr.count("orishell:") == 1
    assert where in done.stderr.splitlines()[0]
    assert says in done.stderr
    assert [path.name for path in tmp_path.iterdir()] == ["shell.toml"]

"""All combinations of EN 1990, against lists that were written by hand, and what governs them."""

from __future__ import annotations

import re
from collections import Counter
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from analysed import analysed
from orishell.cli.structure import summarize_structure
from orishell.conventions.errors import InputError
from orishell.design_file import read_design_file
from orishell.structure.combinations import Combination, Factors, LimitState, combine
from orishell.structure.envelopes import few
from orishell.structure.load_settings import LoadCase, PointLoad, Snow, Wind
from orishell.structure.pages.files import structure_page
from orishell.structure.results import Analysis

ACROSS = Wind(speed=26, terrain="II", direction_deg=90)
DEAD = LoadCase(name="dead", self_weight=True)
SNOW = LoadCase(name="snow", snow=Snow(ground=500, arrangement="undrifted"))
FOUR = (
    DEAD,
    SNOW,
    LoadCase(name="across", wind=ACROSS),
    LoadCase(name="along", wind=ACROSS.replace_unchecked(direction_deg=0.0)),
)
DESIGN = """
[shell]
family = "parallel-repeating"
unit = "m"
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

VARIABLE = (
    # Nothing; one alone; snow and one wind, each leading once. Two winds are never together.
    "",
    " + 1.5 snow",
    " + 1.5 across",
    " + 1.5 along",
    " + 1.5 snow + 0.9 across",  # psi_0 of wind 0.6
    " + 1.5 snow + 0.9 along",
    " + 0.75 snow + 1.5 across",  # psi_0 of snow 0.5
    " + 0.75 snow + 1.5 along",
)
ALL_REDUCED = (  # 6.10a: all with psi_0
    "",
    " + 0.75 snow",
    " + 0.9 across",
    " + 0.9 along",
    " + 0.75 snow + 0.9 across",
    " + 0.75 snow + 0.9 along",
)
SERVICE = {
    # psi_2 of both is 0: the quasi-permanent combination is dead alone, as others without snow and
    # wind, and the frequent one has one variable action, with psi_1 = 0.2.
    "SLS characteristic, frequent, quasi-permanent dead",
    "SLS characteristic dead + snow",
    "SLS characteristic dead + across",
    "SLS characteristic dead + along",
    "SLS characteristic dead + snow + 0.6 across",
    "SLS characteristic dead + snow + 0.6 along",
    "SLS characteristic dead + 0.5 snow + across",
    "SLS characteristic dead + 0.5 snow + along",
    "SLS frequent dead + 0.2 snow",
    "SLS frequent dead + 0.2 across",
    "SLS frequent dead + 0.2 along",
}
EQUILIBRIUM = {f"EQU {dead} dead{rest}" for dead in (1.1, 0.9) for rest in VARIABLE}


def named(found: tuple[Combination, ...]) -> set[str]:
    names = [case.name for case in found]
    assert len(set(names)) == len(names)
    assert all(case.name.startswith(case.limit_state) for case in found)
    return set(names)


def test_dead_snow_and_two_winds_by_6_10() -> None:
    """16 for ULS, 16 for EQU, 11 for SLS."""
    strength = {f"ULS {dead}dead{rest}" for dead in ("1.35 ", "") for rest in VARIABLE}
    found = combine(FOUR, Factors(), "6.10")
    assert named(found) == strength | EQUILIBRIUM | SERVICE
    assert Counter(case.limit_state for case in found) == {"ULS": 16, "EQU": 16, "SLS": 11}
    (one,) = (case for case in found if case.name == "ULS 1.35 dead + 1.5 snow + 0.9 across")
    assert one.combine == {"dead": 1.35, "snow": 1.5, "across": 0.9}


def test_dead_snow_and_two_winds_by_6_10_a_and_b() -> None:
    """12 of 6.10a and 16 of 6.10b, of which own weight with 1 alone is one: 27."""
    a = {f"ULS {dead}dead{rest}" for dead in ("1.35 ", "") for rest in ALL_REDUCED}
    b = {f"ULS {dead}dead{rest}" for dead in ("1.1475 ", "") for rest in VARIABLE}
    assert (len(a), len(b), a & b) == (12, 16, {"ULS dead"})
    assert named(combine(FOUR, Factors(), "6.10a/b")) == a | b | EQUILIBRIUM | SERVICE


def test_arrangements_of_snow_are_alternatives() -> None:
    """Three of them, and nothing or one of two winds.

    For each factor of own weight: nothing, 3 snows, 2 winds, 6 pairs of them that lead in turn: 18.
    """
    snow = SNOW.replace_unchecked(snow=Snow(ground=500, shape="cylinder"))
    found = combine((FOUR[0], snow, *FOUR[2:]), Factors(), "6.10")
    count = Counter(case.limit_state for case in found)
    assert count == {"ULS": 36, "EQU": 36, "SLS": 18 + 5}
    assert all(sum("snow" in part for part in case.combine) <= 1 for case in found)
    (one,) = (c for c in found if c.name == "ULS 1.35 dead + 1.5 snow drifted left + 0.9 along")
    assert one.combine == {"dead": 1.35, "snow, drifted left": 1.5, "along": 0.9}


def test_factors_are_those_that_are_given() -> None:
    factors = Factors(permanent=(1.2, 1.0), variable=1.6, snow=(0.7, 0.5, 0.2))
    names = named(combine(FOUR[:2], factors, "6.10"))
    assert {"ULS 1.2 dead + 1.6 snow", "SLS frequent dead + 0.5 snow"} < names
    assert "SLS quasi-permanent dead + 0.2 snow" in names


def test_loads_that_say_nothing_are_told_what_they_are() -> None:
    crowd = LoadCase(name="crowd", pressure=1000, action="imposed")
    rope = LoadCase(
        name="rope", points=(PointLoad(at=(0, 0), force=(0, 0, -5)),), action="permanent"
    )
    names = named(combine((DEAD, crowd, rope), Factors(), "6.10"))
    assert "ULS 1.35 dead + rope + 1.5 crowd" in names  # each permanent case has its own factor
    for bad, says in (
        (LoadCase(name="crowd", pressure=1000), "permanent"),
        (
            LoadCase(name="both", self_weight=True, snow=Snow(ground=5, arrangement="undrifted")),
            "a case of its own",
        ),
        (LoadCase(name="dead", self_weight=True, action="imposed"), "a case of its own"),
    ):
        with pytest.raises(InputError, match=f'"{bad.name}".*{says}'):
            combine((DEAD, bad), Factors(), "6.10")


def with_states() -> Analysis:
    """The tent's cases, of which it moves under the first: two of ULS, one of EQU, one of SLS."""
    found = analysed()
    states: tuple[LimitState, ...] = ("EQU", "ULS", "ULS", "SLS")
    cases = (
        replace(case, limit_state=state) for case, state in zip(found.cases, states, strict=True)
    )
    return replace(found, cases=tuple(cases))


def test_what_governs_each_limit_state() -> None:
    report = with_states()
    strength, equilibrium, service = report.envelopes
    assert (strength.limit_state, strength.cases, strength.moves) == ("ULS", 2, 0)
    # A tie bears 4 kN of 5, which is more than 1/2.5 of the buckling load, and than 2 of 5.5 MPa.
    assert strength.part == "ties"
    assert strength.share == pytest.approx(0.8)
    assert (equilibrium.case, equilibrium.moves, equilibrium.part) == ("both", 1, None)
    assert service.part == "displacement"
    assert service.share == pytest.approx(0.075)
    # Strength and buckling are not asked for in SLS and EQU: they do not govern, nor fail it.
    assert replace(report, cases=report.cases[3:]).governs is None
    kinds = [{each.kind for each in case.findings} for case in report.cases]
    assert ["buckles" in each for each in kinds] == [False, True, True, False]


def test_of_many_cases_those_that_govern_are_told_in_full() -> None:
    """24 cases of ULS like "wind", each with smaller forces in ties but for one: it is told."""
    report = analysed()
    wind = report.cases[1]
    assert wind.equilibrium is not None
    cases = tuple(
        replace(
            wind,
            name=f"ULS {number}",
            limit_state="ULS",
            equilibrium=replace(
                wind.equilibrium, tie_forces=np.array([1000.0, 4000.0 + 9 * number, 0.0])
            ),
        )
        for number in range(24)
    )
    many = replace(report, cases=cases)
    assert [case.name for case in many.reported_cases] == ["ULS 23"]
    assert [each.cases for each in many.envelopes] == [24]
    page = structure_page(many, title="tent", unit="m", png=b"")
    assert page.count("Reactions of supports") == 1
    assert "ULS 7" in page  # in the table of all
    lines = list(summarize_structure(many, "m", []))
    assert [line for line in lines if line.startswith("ULS ")] == ["ULS 23"]
    cells = [re.split(r"\s{2,}", line.strip()) for line in lines]
    assert ["ULS", "24", "0", "ULS 23, free creases", "ties: 84.1 %"] in cells


def test_a_name_is_not_that_of_a_combination(tmp_path: Path) -> None:
    text = (
        DESIGN
        + """
        [structure]
        modulus = 7e9
        thickness = 0.01
        combinations = "EN 1990"
        supports = [{ at = "feet", kind = "pinned" }]
        [[load_case]]
        name = "dead"
        self_weight = true
    """
    )
    path = tmp_path / "shell.toml"
    path.write_text(text)
    structure = read_design_file(path).structure
    assert structure is not None
    assert [case.name for case in structure.analysed] == [
        "ULS 1.35 dead",
        "ULS dead",
        "EQU 1.1 dead",
        "EQU 0.9 dead",
        "SLS characteristic, frequent, quasi-permanent dead",
    ]
    own = '[[load_case]]\nname = "ULS dead"\ncombine = { dead = 1 }'
    path.write_text(text + own)
    with pytest.raises(InputError, match="got 'ULS dead'"):
        read_design_file(path)
    path.write_text(text + "pressure = 5")
    with pytest.raises(InputError, match="cases of one action each"):
        read_design_file(path)


def test_a_sentence_names_few_cases() -> None:
    assert few(["a", "b"]) == "a; b"
    assert few(list("abcdefg")) == "a; b; c; d; e; and 2 more"
    assert few(list("abcdef")) == "a; b; c; d; e; f"

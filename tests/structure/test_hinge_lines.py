"""What crease lines bear: kinds with their sources, and utilisation of every crease by hand."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_allclose

from orishell.conventions.errors import InputError
from orishell.structure.crease_lines import by_direction, used_lines
from orishell.structure.hinge_lines import DIRECTIONS, LineStrength, hinge_lines
from orishell.structure.mesh.edge_forces import crease_sides
from orishell.structure.pages.crease_tables import crease_head, crease_rows
from orishell.structure.results import Analysis
from orishell.structure.settings import Structure

from .test_materials import read
from .test_verdicts import arch

TABLES = """
[structure]
modulus = {modulus}
supports = [{{ at = "feet", kind = "pinned" }}]
thickness = {thickness}
line_strength = {lines}
"""


def asked(directory: Path, lines: str, unit: str = "m") -> Structure:
    """The table [structure] with what crease lines bear, as a file has it."""
    modulus, thickness = {"m": (8e9, 0.01), "mm": (8e3, 10)}[unit]
    tables = TABLES.format(modulus=modulus, thickness=thickness, lines=lines)
    structure = read(directory, tables, unit).structure
    assert structure is not None
    return structure


def with_lines(found: Analysis, strength: LineStrength | None) -> Analysis:
    """The same analysis with other lines."""
    model = replace(
        found.model, structure=found.model.structure.replace_unchecked(line_strength=strength)
    )
    return replace(found, model=model, cases=tuple(each.of(model) for each in found.cases))


@pytest.mark.parametrize("name", list(hinge_lines()))
def test_every_kind_says_where_it_comes_from(name: str) -> None:
    found = hinge_lines()[name]
    assert len(found.source) > 40
    assert len(found.conservative) > 40
    known = [getattr(found, each) for each in DIRECTIONS if getattr(found, each) is not None]
    assert known
    assert all(100 < each < 1e5 for each in known)


def test_a_bolted_hinge_by_hand() -> None:
    """Bolts of 5 mm every 40 through 9 mm: they bear less than knuckles and edge do."""
    made, design = hinge_lines()["bolted hinge"], 0.6 / 1.3
    bolt = 0.4 * 0.11 * (1 - 0.01 * 5) * 630 * 9 * 5 * design  # N; EN 1995-1-1, 8.36 and 8.9a
    leaf = 235 * 1.5**2 / 6
    assert 2 * 10 * 9 * 9.5 * design > bolt
    assert leaf / (2 + 0.75) / 2 > bolt / 40
    for value in (made.pull, made.push, made.along):
        assert value is not None
        assert 0.98 < value / 1e3 / (bolt / 40) <= 1
    assert made.across is not None
    assert 0.98 < made.across / 1e3 / (leaf / 12) <= 1


def test_calculated_kinds() -> None:
    """By the formulas that their sources name, rounded down by less than 6 %."""
    piano, wooden = hinge_lines()["piano hinge"], hinge_lines()["wooden knuckles"]
    design = 0.6 / 1.3  # k_mod over gamma_M
    diameter, board, density = 4.0, 12.0, 630
    embedment = 0.11 * (1 - 0.01 * diameter) * density  # MPa; EN 1995-1-1, equation 8.36
    bolts = 0.4 * embedment * board * diameter * design / 60  # N/mm; equation 8.9a
    leaf = 235 * 1.2**2 / 6  # N: elastic moment per length of a leaf
    unrolled = leaf / (1.5 + 0.6) / 2
    for found, least in (
        (piano.pull, min(bolts, unrolled)),
        (piano.push, bolts),
        (piano.along, bolts),
        (piano.across, leaf / 12),
        (wooden.pull, 2 * 12 * 2.22 * design / 2),
    ):
        assert found is not None
        assert 0.94 * least < found / 1e3 <= 1.001 * least


@pytest.mark.parametrize(("unit", "per_metre"), [("m", 1.0), ("mm", 1e-3)])
def test_a_kind_in_any_unit(tmp_path: Path, unit: str, per_metre: float) -> None:
    """What is given stands; the rest comes from the kind, or is not known."""
    given = asked(tmp_path, f'{{ kind = "coated fabric", push = {5e3 * per_metre} }}', unit)
    lines = given.line_strength
    assert lines is not None
    known = [getattr(lines, name) for name in DIRECTIONS]
    assert known[:3] == pytest.approx([12e3 * per_metre, 5e3 * per_metre, 6e3 * per_metre])
    assert known[3] is None


@pytest.mark.parametrize(
    ("lines", "says"),
    [
        ('{ kind = "string" }', "piano hinge"),
        ("{ pull = 0 }", "line_strength.pull"),
        ("{ pull = -1.0 }", "line_strength.pull"),
        ("{ pul = 1e3 }", "line_strength.pul"),
        ('"piano hinge"', "line_strength"),
        ("0", "line_strength"),
        ("true", "line_strength"),
        ("{ along = nan }", "line_strength.along"),
        ("[1e3, 2e3]", "line_strength"),
    ],
)
def test_what_is_no_strength_is_refused(tmp_path: Path, lines: str, says: str) -> None:
    with pytest.raises(InputError, match=says):
        asked(tmp_path, lines)


def test_forces_by_direction() -> None:
    """A pull of 3 with a moment of 0.2 over a lever of 0.05: 7 and -1; shear has no sign."""
    found = by_direction(np.array([3.0, -2.0, 1.0, 0.2]), 0.05)
    assert_allclose(found, [[7, 0, 2, 1], [0, 1, 2, 1]])


def test_shares_by_hand() -> None:
    """The rule of fasteners; a direction that nobody knows counts apart."""
    forces = np.array([3.0, 0.0, 4.0, 12.0])
    every = LineStrength(pull=6.0, push=1.0, along=8.0, across=24.0)
    assert float(every.used(forces)) == pytest.approx(math.sqrt(0.75))
    assert not every.unknown(forces)
    some = LineStrength(pull=6.0, along=8.0)
    assert float(some.used(forces)) == pytest.approx(math.sqrt(0.5))
    assert float(some.unknown(forces)) == pytest.approx(12)
    assert float(LineStrength.alike(13.0).used(forces)) == pytest.approx(1)


def rows(found: Analysis) -> list[dict[str, Any]]:
    """The rows of creases.csv; of columns of one name the last one counts."""
    head = crease_head("m")
    return [dict(zip(head, map(str, row), strict=True)) for row in crease_rows(found)]


def test_every_crease_by_hand() -> None:
    """Shares of all creases from the forces along their quarters, free and locked."""
    for stiffness in ("free", "rigid"):
        found = arch({"crease_stiffness": stiffness, "crease_lever": 0.02})
        strength = LineStrength(pull=20e3, push=30e3, along=7e3, across=5e3)
        known = with_lines(found, strength)
        balanced = known.cases[0].equilibrium
        assert balanced is not None
        _, sides = crease_sides(known.model.grid)
        table = rows(known)
        assert len(table) == len(sides)
        for number, row in enumerate(table):
            shares = []
            for panel, edge in sides[number]:
                for normal, along, across, moment in balanced.edges.per_length[panel, edge]:
                    for pull in (normal + moment / 0.02, normal - moment / 0.02):
                        parts = [max(pull, 0) / 20e3, max(-pull, 0) / 30e3]
                        parts += [along / 7e3, across / 5e3]
                        shares.append(math.hypot(*parts))
            # Stretches here are longer than panels are thick: nothing is spread further.
            assert float(row["used of its line"]) == pytest.approx(max(shares), rel=1e-5)
            assert row["case"] == "snow"
        used = used_lines(known.model, balanced.edges)
        assert balanced.used_line is not None
        assert (
            balanced.used_line.size
            == balanced.utilisation.lines
            == pytest.approx(used.max(), rel=1e-9)
        )


def test_lines_are_not_known_where_a_loaded_direction_is_not() -> None:
    """And fail where a known one is used up, whatever is not known."""
    found = arch()
    cloth = LineStrength(pull=70e3, along=70e3)
    case = with_lines(found, cloth).cases[0]
    assert case.carries is None
    assert "loaded in crease lines, whose strength is not given" in case.said
    weak = with_lines(found, cloth.replace_unchecked(pull=50e3)).cases[0]
    assert weak.carries is False
    assert "of the strength of its crease lines at the crease between panels" in weak.said
    whole = with_lines(found, LineStrength.alike(70e3)).cases[0]
    assert whole.carries is True
    assert not rows(found)[0]["used of its line"]


def test_a_locked_crease_is_a_pair_of_forces() -> None:
    """Half the lever arm, twice the pull that the moment asks of the line, which it governs."""
    found = arch({"crease_stiffness": "rigid", "thickness": 0.005})
    sizes = []
    for lever in (0.004, 0.002):
        asked = found.model.structure.replace_unchecked(crease_lever=lever)
        model = replace(found.model, structure=asked)
        balanced = found.cases[0].of(model).equilibrium
        assert balanced is not None
        assert balanced.crease is not None
        assert balanced.lines.size > 0.95 * balanced.crease.moment / lever
        sizes.append(balanced.lines.size)
    assert sizes[1] > 1.5 * sizes[0]

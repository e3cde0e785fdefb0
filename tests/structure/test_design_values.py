"""What panels of a material bear by EN 1995, and displacements that are allowed, by hand."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from orishell.conventions.errors import InputError
from orishell.conventions.record import as_table
from orishell.structure.grain import grain_turns
from orishell.structure.load_settings import LoadCase, PointLoad, Snow, Wind
from orishell.structure.materials import DURATIONS, materials
from orishell.structure.mesh.plane import tensors_along
from orishell.structure.pages.crease_tables import crease_head, crease_rows
from orishell.structure.plausibility import doubts_of_shell

from .test_materials import read
from .test_verdicts import arch

DEAD = LoadCase(name="dead", self_weight=True)
SNOW = LoadCase(name="snow", snow=Snow(ground=500, arrangement="undrifted"))
WIND = LoadCase(name="wind", wind=Wind(speed=20, terrain="II", direction_deg=0))
PLYWOOD = {"material": "birch plywood", "thickness": 0.012}


def without_values(keys: dict[str, Any]) -> dict[str, Any]:
    """Keys of the arch's table with which its modulus and strength are those of the material."""
    return {"modulus": 6.7e9, "poisson": 0.3, **keys, "strength": None}


@pytest.mark.parametrize(
    ("case", "lasts"),
    [
        (DEAD, "permanent"),
        (SNOW, "medium"),
        (WIND, "short"),
        (
            LoadCase(name="both", self_weight=True, snow=Snow(ground=500, arrangement="undrifted")),
            "medium",
        ),
        (LoadCase(name="crowd", pressure=100, duration="long"), "long"),
        (LoadCase(name="man", points=(PointLoad(at=(1, 1), force=(0, 0, -1e3)),)), "medium"),
        (LoadCase(name="winter", combine={"dead": 1.35, "snow": 1.5}), "medium"),
        (LoadCase(name="storm", combine={"dead": 1.35, "snow": 0.75, "wind": 1.5}), "short"),
        (LoadCase(name="calm", combine={"dead": 1.35, "wind": 0.0}), "permanent"),
        (LoadCase(name="blast", combine={"dead": 1.0}, duration="instantaneous"), "instantaneous"),
    ],
)
def test_a_case_lasts_as_long_as_its_shortest_load(case: LoadCase, lasts: str) -> None:
    """EN 1995-1-1, 3.1.3 (2)."""
    assert case.lasts((DEAD, SNOW, WIND)) == lasts


@pytest.mark.parametrize(
    ("service", "factors"),
    # EN 1995-1-1, table 3.1: plywood of EN 636-1, -2 and -3.
    [(1, (0.6, 0.7, 0.8, 0.9, 1.1)), (3, (0.5, 0.55, 0.65, 0.7, 0.9))],
)
def test_plywood_bears_by_class_and_duration(service: Any, factors: tuple[float, ...]) -> None:
    birch = materials()["birch plywood"]
    found = [birch.bears(each, service) for each in DURATIONS]
    assert found == pytest.approx([each * 33.2e6 / 1.2 for each in factors])
    assert birch.creeps(service) == {1: 0.8, 3: 2.5}[service]


def test_other_materials_bear_the_same_however_long() -> None:
    for name, made in materials().items():
        if not made.k_mod:
            assert len({made.bears(each, 3) for each in DURATIONS}) == 1, name
            assert made.creeps(3) == 0


def test_utilisation_of_plywood_by_hand() -> None:
    """0.65/1.2 of what the board bears under snow, 0.7/1.2 under wind, 0.5/1.2 under own weight."""
    cases: list[dict[str, Any]] = [
        {"name": "snow", "self_weight": True, "snow": {"ground": 500, "arrangement": "undrifted"}},
        {"name": "wind", "wind": {"speed": 26, "terrain": "II", "direction_deg": 90}},
        {"name": "own", "self_weight": True},
    ]
    found = arch(without_values({**PLYWOOD, "line_strength": 1e6}), cases)
    shown = found.loaded().cases
    for case, drawn, k_mod in zip(found.cases, shown, (0.65, 0.7, 0.5), strict=True):
        balanced = case.equilibrium
        assert balanced is not None
        assert balanced.strength == pytest.approx(k_mod * 33.2e6 / 1.2, rel=1e-9)
        # Colours of pages are shares of the same strength.
        assert drawn.strength == balanced.strength
        bears = materials()["birch plywood"].grain
        assert bears is not None
        known = bears.weaker().times(k_mod / 1.2)
        patches, along = balanced.in_patches, grain_turns(found.model.flat, None)[0]
        angle = along[balanced.in_patches.panels]
        cs = np.cos(angle), np.sin(angle)
        shares = known.of_axes(
            tensors_along(patches.direct, *cs), tensors_along(patches.bent, *cs), solid=True
        )
        used = balanced.utilisation
        assert used.panels == pytest.approx(np.sqrt((shares**2).sum(axis=1)).max())
        assert used.panel_shear == pytest.approx(shares[:, 2].max())
    own = found.cases[2].equilibrium
    assert own is not None
    # k_def = 2.5 outdoors; snow does not last.
    assert own.crept == pytest.approx(3.5 * own.displacement.size)
    first = found.cases[0].equilibrium
    assert first is not None
    assert first.crept == first.displacement.size


@pytest.mark.parametrize("limit", ["span/100", "height/50", 0.01])
def test_a_limit_of_displacement(limit: str | float) -> None:
    """The arch of 3 m span and its own height; failing where it goes beyond, in words too."""
    found = arch({"displacement_limit": limit, "line_strength": 1e6})
    points = found.model.mesh.facets.points
    height = float(np.ptp(points[:, 2]))
    hand = {"span/100": 0.03, "height/50": height / 50, 0.01: 0.01}[limit]
    assert found.model.displacement_limit == pytest.approx(hand, rel=1e-9)
    case = found.cases[0]
    assert case.equilibrium is not None
    moved = case.equilibrium.displacement.size
    assert any("and may be by" in each.text for each in case.findings) is (moved > hand)
    tight = arch({"displacement_limit": 0.5 * moved, "line_strength": 1e6})
    assert tight.carries is False
    assert "and may be by" in tight.cases[0].said


def test_snow_by_exposure_and_warmth() -> None:
    """C_e and C_t are factors of all of it."""
    loads = []
    for snow in ({}, {"exposure_factor": 0.8, "thermal_factor": 0.9}):
        found = arch(
            {}, [{"name": "s", "snow": {"ground": 500, "arrangement": "undrifted", **snow}}]
        )
        loads.append(found.cases[0].load[2])
    assert loads[1] == pytest.approx(0.72 * loads[0])


@pytest.mark.parametrize(
    ("tables", "says"),
    [
        ('displacement_limit = "width/100"', "span/100"),
        ('displacement_limit = "span/0"', "span/100"),
        ('displacement_limit = "span/ten"', "span/100"),
        ("displacement_limit = 0.0", "displacement_limit"),
        ("displacement_limit = -1.0", "displacement_limit"),
        ("displacement_limit = true", "displacement_limit"),
        ("service_class = 4", "service_class"),
        ("service_class = 2.5", "service_class"),
        ('service_class = "outdoors"', "service_class"),
        ('[[load_case]]\nname = "a"\nself_weight = true\nduration = "ever"', "duration"),
        ('[[load_case]]\nname = "a"\nsnow = { ground = 1, exposure_factor = 0 }', "exposure"),
        ('[[load_case]]\nname = "a"\nsnow = { ground = 1, thermal_factor = 1.5 }', "thermal"),
    ],
)
def test_bad_values_are_refused(tmp_path: Path, tables: str, says: str) -> None:
    asked = (
        '[structure]\nmaterial = "birch plywood"\nthickness = 0.01\n'
        'supports = [{ at = "feet", kind = "pinned" }]\n'
    )
    with pytest.raises(InputError, match=says):
        read(tmp_path, asked + tables)


def test_level_panels_are_named() -> None:
    """A roof whose middle row of panels is level, by its heights; the arch of others is steep."""
    found = arch({"line_strength": 1e6})
    slopes = found.model.mesh.facets.axes()[:, 2, 2]
    steep = np.rad2deg(np.arccos(np.abs(slopes).max()))
    assert steep > 1.2
    assert not any("nearly level" in text for text in found.warnings)
    flat = replace(found.model, site=found.model.site)
    points = found.model.mesh.facets.points * [1, 1, 0.01]
    mesh = replace(found.model.mesh, facets=replace(found.model.mesh.facets, points=points))
    vars(flat)["mesh"] = mesh
    said = list(doubts_of_shell(flat))
    assert any("water stands on them" in text for text in said)


def test_a_plywood_shelter_under_snow_and_a_storm() -> None:
    """Outdoors: strength by EN 1995-1-1, table 3.1 and 2.4.1, crease lines as written of them.

    33.2 MPa k_mod/1.2, k_mod 0.65 for snow (medium) and 0.7 for a storm, which is short. Hinges are
    free, and only their strength against pull is given: shares of all lines to three digits.
    """
    cases: list[dict[str, Any]] = [
        {"name": "dead", "self_weight": True},
        {"name": "snow", "snow": {"ground": 500, "shape": "cylinder", "arrangement": "undrifted"}},
        {"name": "wind", "wind": {"speed": 20, "terrain": "II", "direction_deg": 90}},
        {"name": "winter", "combine": {"dead": 1.35, "snow": 1.5}},
        {"name": "storm", "combine": {"dead": 1.35, "snow": 0.75, "wind": 1.5}},
    ]
    keys = {**PLYWOOD, "thickness": 0.024, "line_strength": {"pull": 20e3}}
    found = arch(without_values(keys), cases)
    by_name = {each["name"]: each["equilibrium"] for each in as_table(found)["cases"]}
    strengths = {name: each["strength"] for name, each in by_name.items()}
    assert strengths == pytest.approx({"winter": 17.983e6, "storm": 19.367e6}, rel=5e-5)
    head, rows = crease_head("m"), [list(map(str, row)) for row in crease_rows(found)]
    pull, used = head.index("pull (N/m)"), head.index("used of its line")
    shares = [float(row[used] or 0) for row in rows]
    assert shares == pytest.approx([float(row[pull]) / 20e3 for row in rows], rel=5e-4)
    assert {row[pull + 1] for row in rows if float(row[pull])} == {"winter", "storm"}
    lines = [by_name[name]["utilisation"]["lines"] for name in by_name]
    assert max(shares) == pytest.approx(max(lines), rel=5e-4)

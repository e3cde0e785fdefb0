"""From the tables of a design file to what the shell does under its loads."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from design_tables import formula, tables
from orishell.conventions.errors import InputError
from orishell.design_file import check_design
from orishell.shell.make import make_shell
from orishell.shell.steps import MEASURES
from orishell.structure.results import Analysis

STORM = {"speed": 26, "terrain": "II", "direction_deg": 90}


def arch(supports: Any = "pinned", **changes: Any) -> dict[str, Any]:
    """A short vault over a parabola of 2 m x 1 m, with own weight as its only case."""
    design = tables(
        "orthodiagonal",
        formula("-x**2", -1, 1),
        formula("0.25*sin(pi*x/2)", 0, 2),
        rows=5,
        columns=5,
        flap=0.15,
        depth=0.12,
        heading_deg=90,
    )
    design["deployment"] = {"flap_attachment": "clipped", "ties": "none"}
    design["workshop"] = {"areal_density": 1.9}
    at = [{"at": "feet", "kind": supports}] if isinstance(supports, str) else supports
    design["structure"] = {"modulus": 270e6, "thickness": 0.01, "cells": 1, "supports": at}
    for name, values in changes.items():
        design[name] = values if isinstance(values, list) else design[name] | values
    return design


def analysed(design: dict[str, Any]) -> Analysis:
    shell = make_shell(
        check_design(design, Path("shell.toml")),
        clash="unexamined",
        skip=("remedies", *MEASURES, "stock"),
    )
    assert shell.report.structure is not None
    return shell.report.structure


def case(**loads: Any) -> list[dict[str, Any]]:
    return [{"name": "case", **loads}]


@pytest.fixture(scope="module")
def winter() -> Analysis:
    """On sliding feet, tied, with flaps."""
    loads = case(self_weight=True, snow={"ground": 500, "arrangement": "undrifted"})
    return analysed(arch("sliding", deployment={"ties": "feet"}, load_case=loads))


def test_reactions_balance_loads(winter: Analysis) -> None:
    for found in winter.cases:
        assert found.equilibrium is not None
        np.testing.assert_allclose(
            np.array(found.load) + found.equilibrium.reaction,
            0.0,
            atol=1e-9 * float(np.linalg.norm(found.load)),
        )
        assert found.equilibrium.residual < 1e-9
        total = np.sum([each.force for each in found.equilibrium.reactions], axis=0)
        np.testing.assert_allclose(total, found.equilibrium.reaction, rtol=1e-12, atol=1e-9)


def test_own_weight_is_that_of_all_panels(winter: Analysis) -> None:
    weight = next(load for load in winter.cases[0].loads if load.kind == "self_weight")
    assert weight.force == pytest.approx([0, 0, -9.81 * winter.model.mass], abs=1e-9)


def test_stiffer_creases_give_less(winter: Analysis) -> None:
    free, rigid = winter.cases
    assert (free.creases, rigid.creases) == ("free", "rigid")
    assert free.equilibrium is not None
    assert rigid.equilibrium is not None
    assert rigid.equilibrium.displacement.size < free.equilibrium.displacement.size


@pytest.mark.parametrize("creases", ["free", "rigid"])
@pytest.mark.parametrize("flap", [0, 0.15])
def test_wind_along_the_ground_drives_a_shell_on_sliding_feet(creases: str, flap: float) -> None:
    # Without flaps and ties nothing is one-sided; with them rounding must not hold it.
    design = arch("sliding", pattern={"flap": flap}, load_case=case(wind=STORM))
    design["structure"]["crease_stiffness"] = creases
    (found,) = analysed(design).cases
    assert found.equilibrium is None
    assert found.in_words().startswith("slides or tips as a whole")


@pytest.mark.parametrize(
    ("supports", "loads"),
    # Wind lifts the shell, and most flaps part; own weight opens it, and nothing ties it.
    [("pinned", {"self_weight": True, "wind": STORM}), ("sliding", {"self_weight": True})],
)
def test_flaps_that_part_hold_nothing(supports: str, loads: dict[str, Any]) -> None:
    standing = [
        each.equilibrium for each in analysed(arch(supports, load_case=case(**loads))).cases
    ]
    assert any(standing)
    for found in filter(None, standing):
        pressing = [each.force for each in found.flaps if each.force]
        assert len(pressing) < len(found.flaps)
        assert min(pressing, default=1.0) > 0


def test_what_panels_weigh_is_asked_for() -> None:
    design = arch(workshop={"areal_density": 0})
    with pytest.raises(InputError, match=r"what panels weigh is not known.*give density") as caught:
        analysed(design)
    assert "membrane" not in str(caught.value)


def test_the_density_of_a_membrane_is_asked_for_beside_that_of_boards() -> None:
    panel = {"thickness": 0.002, "membrane": 0.0005, "density": 600}
    design = arch(workshop={"areal_density": 0})
    design["structure"].pop("thickness")
    with pytest.raises(InputError, match="give membrane_density in"):
        analysed({**design, "panel": panel})


@pytest.mark.parametrize("at", [[[9, 0]], [[0, 9]]])
def test_supports_are_vertices_of_the_sheet(at: list[list[int]]) -> None:
    with pytest.raises(InputError, match=r"supports\[0\]"):
        analysed(arch([{"at": at, "kind": "pinned"}]))

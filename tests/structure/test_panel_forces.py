"""Forces on panels as they are written, where ties, flaps, gussets, rails and edges hold a shell.

Whatever is between panels sums to nothing over the whole shell, and supports bear the loads: by
statics of what ``forces.csv`` says alone.
"""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from orishell.design_file import check_design
from orishell.shell.make import Shell, make_shell
from orishell.shell.steps import MEASURES
from written_forces import Acts, both_sides, by_panel, size, summed, written_forces

SKIP = (*MEASURES, "stock", "verification", "remedies")
ARCH = """
[shell]
family = "orthodiagonal"
unit = "mm"
[target]
f = { formula = "-x**2/1000", range = [-1000, 1000] }
g = { formula = "100*cos(pi*x/500)", range = [0, 2000] }
[pattern]
rows = 5
columns = 5
flap = 0
heading_deg = 90
spacing = "equal"
[workshop]
areal_density = 6e-6
[structure]
modulus = 8000
thickness = 10
cells = 3
supports = [{ at = "feet", kind = "pinned" }]
[[load_case]]
name = "weight, and a lamp"
self_weight = true
points = [{ at = [2, 2], force = [3, 0, -40] }]
"""
RAIL = {"material": "steel", "width": 40, "height": 40, "wall": 3}
KINDS: dict[str, dict[str, Any]] = {
    "flaps and ties": {
        "pattern": {"flap": 150},
        "deployment": {"flap_attachment": "clipped", "ties": "feet"},
        "structure": {"supports": [{"at": "feet", "kind": "friction", "friction": 0.1}]},
    },
    "gussets": {"stiffeners": {"kind": "gussets"}, "structure": {"cells": 4}},
    "a rail": {"structure": {"rail": RAIL}},
    "edges": {
        "structure": {"cells": 4, "supports": [{"at": "feet", "kind": "fixed", "patch": 350}]}
    },
    "boards on hinges": {
        "panel": {"construction": "hinged", "thickness": 10},
        "structure": {"thickness": None, "cells": 4},
        "deployment": {"ties": "folds"},
    },
    "large displacements": {"structure": {"nonlinear": True, "cells": 2}},
}

EXPECTED: dict[str, set[str]] = {
    "flaps and ties": {"tie", "flap", "support"},
    "gussets": {"gusset", "support"},
    "a rail": {"support and rail"},
    "edges": {"support"},
    "boards on hinges": {"tie", "support"},
    "large displacements": {"support"},
}
"""What acts on panels of each beside loads and creases."""


def made(changes: dict[str, dict[str, Any]]) -> Shell:
    tables = tomllib.loads(ARCH)
    for table, keys in changes.items():
        both = tables.get(table, {}) | keys
        tables[table] = {key: value for key, value in both.items() if value is not None}
    return make_shell(check_design(tables, Path("x.toml")), clash="unexamined", skip=SKIP)


def of(rows: list[Acts], *acts: str) -> list[Acts]:
    return [each for each in rows if each.acts in acts]


@pytest.mark.parametrize("kind", KINDS)
def test_all_is_in_balance(tmp_path: Path, kind: str) -> None:
    shell = made(KINDS[kind])
    assert shell.analysis is not None
    written = written_forces(shell.analysis, shell.document, tmp_path / "forces.csv")
    assert len(written) == len(shell.analysis.balanced) > 0
    for (stands, _), rows in zip(shell.analysis.balanced, written.values(), strict=True):
        middle = np.mean([each.at for each in rows], axis=0)
        extent = np.ptp([each.at for each in rows], axis=0).max()
        loads = size(of(rows, "load"))
        near = loads * np.array([*3 * [1e-6], *3 * [1e-6 * extent]])
        for own in by_panel(rows).values():
            assert (np.abs(summed(own, own[0].at)) < near).all()
        sides = both_sides(rows, middle)
        assert (np.abs(sides.sum(axis=1)) < near).all()
        for between in ("tie", "flap", "gusset"):
            assert (np.abs(summed(of(rows, between), middle)) < near).all(), between
        assert {each.acts for each in rows} - {"remainder"} == {"load", "crease", *EXPECTED[kind]}
        lamp = [each for each in of(rows, "load") if each.vertex == (2, 2)]
        assert len(lamp) == (1 if kind == "boards on hinges" else 4)
        assert size(of(rows, "remainder")) < 1e-6 * loads
        outside = [each for each in rows if "support" in each.acts]
        assert (np.abs(summed([*of(rows, "load"), *outside], middle)) < near).all()
        assert np.abs(summed(outside, middle)[:3] - stands.reaction).max() < 1e-6 * loads

"""What notes offer does what they say: the shell is made with it, and they are gone."""

from __future__ import annotations

import tomllib
from copy import deepcopy
from pathlib import Path
from typing import Any

import pytest

from orishell.conventions.errors import InputError
from orishell.conventions.progress import no_progress
from orishell.conventions.row import ORDER, Note
from orishell.design_file import DesignFile, check_design
from orishell.shell.make import make_shell
from orishell.shell.note_remedies import find_mend, find_mendable
from samples import thorough

ARCH: dict[str, Any] = {
    "shell": {"family": "orthodiagonal", "unit": "m"},
    "target": {
        "f": {"formula": "-x**2", "range": [-1, 1]},
        "g": {"formula": "0.25*sin(pi*x/2)", "range": [0, 2]},
    },
    "pattern": {"rows": 5, "columns": 5, "flap": 0, "depth": 0.12, "heading_deg": 90},
}
"""An arch without flaps, larger than any board, which its own weight opens."""
STRAIGHT: dict[str, Any] = {
    "shell": {"family": "parallel-repeating", "unit": "m"},
    "target": {
        "f": {"formula": "0.4*(1-x**2)", "range": [-1, 1]},
        "g": {"formula": "0", "range": [0, 2]},
    },
    "pattern": {"rows": 5, "columns": 5},
}
"""A barrel, most of whose columns stay unfolded."""
LOADED: dict[str, Any] = {
    "structure": {
        "modulus": 9e9,
        "strength": 40e6,
        "crease_stiffness": "free",
        "thickness": 0.05,
        "cells": 2,
        "supports": [{"at": "feet", "kind": "pinned"}],
    },
    "load_case": [{"name": "snow", "snow": {"ground": 500, "arrangement": "undrifted"}}],
}


def read(design: dict[str, Any]) -> DesignFile:
    return check_design(deepcopy(design), Path("shell.toml"), files=False)


SOLID = {
    "pattern": {**ARCH["pattern"], "depth": 0.3},
    "panel": {"construction": "bevel", "thickness": 0.02, "gap": 0.002},
}
CLOTH: dict[str, Any] = {
    "panel": {"thickness": 0.006, "membrane": 0.001},
    "workshop": {"stock": [2.5, 1.25]},
}
DEEP: dict[str, Any] = {
    **STRAIGHT,
    "target": {**STRAIGHT["target"], "g": {"formula": "0.3*sin(pi*x/2)", "range": [0, 2]}},
    "pattern": {"rows": 3, "columns": 5},
}
"""Three rows, whose folds are deep in a shell so low."""
WAVE = {"formula": "0.25*sin(pi*x/2)", "range": [0, 4]}
STEEP: dict[str, Any] = {
    **STRAIGHT,
    "target": {"f": {"formula": "-0.3*x**2", "range": [-1, 1]}, "g": WAVE},
    "pattern": {"rows": 9, "columns": 7, "flap": 0.2, "xi_deg": 50},
}
"""Steep creases, which take a sheet 2.5 times as large as the surface."""
UNTRIMMED: dict[str, Any] = {
    **ARCH,
    "target": {"f": ARCH["target"]["f"], "g": WAVE},
    "pattern": {"rows": 19, "columns": 13, "flap": 0.15, "depth": 0.06},
}
"""Folds so shallow that their ends cannot be trimmed."""
PULLED: dict[str, Any] = {
    **LOADED,
    "load_case": [
        {
            "name": "wind",
            "wind": {"speed": 30.0, "terrain": "II", "direction_deg": 0},
            "self_weight": True,
        }
    ],
    "workshop": {"areal_density": 5.0},
}


def hinged(**panel: Any) -> dict[str, Any]:
    """A short piece of the shelter of whole boards on hinges, on arms of any length."""
    path = Path(__file__).parents[2] / "examples" / "shelter_hinged.toml"
    design = tomllib.loads(path.read_text("utf-8"))
    design["target"]["g"]["range"] = [0, 2]
    design["pattern"]["columns"] = 5
    design["panel"].update(largest_arm=1.0, **panel)
    return {**design, "workshop": {}}


@pytest.mark.parametrize(
    ("design", "about", "changes"),
    [
        (ARCH, "no flaps", {"pattern.flap": "auto"}),
        (ARCH, "opens", {"deployment.ties": "feet"}),
        (ARCH, "board", {"workshop.stock": [2.5, 1.25]}),
        (STRAIGHT, "columns", {"pattern.columns": 2}),
        ({**ARCH, "shell": {**ARCH["shell"], "unit": "mm"}}, "unit", {"shell.unit": "cm"}),
        ({**ARCH, "workshop": {"stock": [2500, 1250]}}, "stock", {"workshop.stock": [2.5, 1.25]}),
        ({**ARCH, **SOLID}, "chamfers", None),
        ({**ARCH, **CLOTH}, "roll", {"workshop.roll": [1.5, 50.0]}),
        (STEEP, "sheet", None),
        (UNTRIMMED, "uneven", {"pattern.depth": 0.18}),
        (DEEP, "depth", {"pattern.rows": 9}),
        (hinged(thickness=0.025, pieces="whole"), "arms", {"pattern.rows": 9}),
        pytest.param(hinged(thickness=0.06, pieces=4), "cut joints", None, marks=thorough),
        pytest.param({**ARCH, **PULLED}, "cells", None, marks=thorough),
        ({**ARCH, **PULLED}, "pulled", None),
    ],
)
def test_what_a_note_offers_does_away_with_it(
    design: dict[str, Any], about: str, changes: dict[str, Any] | None
) -> None:
    file = read(design)
    before = make_shell(file).report
    (note,) = (each for each in before.warnings if getattr(each, "about", None) == about)
    (asked,) = find_mendable(file, [note], before.structure)
    assert (asked.note, asked.about, asked.slow) == (note, about, False)
    mend = find_mend(file, about, no_progress, before)
    assert mend is not None
    assert changes is None or mend.changes == changes
    if about == "depth":  # which is a row of the verdict, too
        rows = [(row.finding, row.sign) for row in before.verdict if row.subject == "depth"]
        assert rows == [(note, "warns")]
    after = make_shell(file.changed(mend.changes)).report
    assert about not in [getattr(note, "about", None) for note in after.warnings]
    if before.structure is not None:
        assert after.structure is not None
        assert ORDER.index(after.structure.sign) >= ORDER.index(before.structure.sign)


def test_a_load_case_without_own_weight_is_given_it() -> None:
    file = read({**ARCH, **LOADED, "workshop": {"areal_density": 20.0}})
    mend = find_mend(file, "weight", no_progress)
    assert mend is not None
    assert mend.changes == {"load_case.0.self_weight": True}
    after = make_shell(file.changed(mend.changes)).report.warnings
    assert not any("own weight is left out" in note for note in after)
    # Without a density nobody knows what it weighs: then it is not offered.
    assert find_mend(read({**ARCH, **LOADED}), "weight", no_progress) is None


def test_what_is_not_known_to_do_it_is_not_offered() -> None:
    # Panels of 3 m fit no board that is sold.
    wide = {**ARCH, "pattern": {**ARCH["pattern"], "rows": 3, "columns": 2}}
    wide["target"] = {
        "f": {"formula": "-x**2/8", "range": [-8, 8]},
        "g": {"formula": "2*sin(pi*x/16)", "range": [0, 16]},
    }
    wide["pattern"]["depth"] = 1.0
    file = read(wide)
    notes = make_shell(file).report.warnings
    assert "board" in [getattr(note, "about", None) for note in notes]
    assert find_mend(file, "board", no_progress) is None


def test_nothing_is_tried_before_somebody_asks() -> None:
    # A search for sizes would be one for each change: that is said, and takes a word.
    file = read({**ARCH, "tolerance": {"surface": 0.05}, "pattern": {"flap": 0}})
    notes = [Note("without flaps", "no flaps"), Note("of nobody's business"), "a plain sentence"]
    (asked,) = find_mendable(file, notes)
    assert (asked.about, asked.slow) == ("no flaps", True)
    with pytest.raises(InputError, match="no note is about that"):
        find_mend(file, "weather", no_progress)


def test_a_kind_of_hinge_is_offered_where_nobody_knows_what_one_bears() -> None:
    file = read({**ARCH, **LOADED})
    (row,) = (each for each in make_shell(file).report.verdict if each.subject == "stands")
    assert "crease lines, whose strength is not given" in row.finding
    assert [*row.changes] == ["structure.line_strength"]
    assert "known what these bear" in row.remedy
    changed = make_shell(file.changed(row.changes)).report
    (after,) = (each for each in changed.verdict if each.subject == "stands")
    assert "strength is not given" not in after.finding

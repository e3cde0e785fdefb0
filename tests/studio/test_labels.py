"""Labels of the pages: there is one for every key, and none for what is no key."""

from __future__ import annotations

import copy
import tomllib
from pathlib import Path
from typing import Any

import pytest

from orishell.design_file import starter_file
from orishell.design_file.file import check_design
from orishell.design_file.tables import FileTable, keys_of
from orishell.families.registry import FAMILIES
from orishell.io.formats import all_formats
from orishell.studio.labels import (
    TABLES,
    WORKSHOP_CHOICES,
    describe_tables,
    describe_tasks,
    describe_workshop,
)

FAMILY = "parallel-repeating"
THICK = {"thickness": 0.02, "membrane": 0.001}
SOLID = {"thickness": 0.02, "gap": 0.001}
GRAIN = {"material": "birch plywood"}
BESIDE: dict[str, dict[str, Any]] = {
    "sandwich": THICK,
    "bevel": SOLID,
    "hinged": {"thickness": 0.02},
    "friction": {"friction": 0.5},
    "along rows": GRAIN,
    "along columns": GRAIN,
}
"""What else a table says that has a choice."""
LOADED: dict[str, Any] = {
    "structure": {
        "material": "steel",
        "thickness": 0.01,
        "supports": [{"at": "feet", "kind": "pinned"}],
    },
    "load_case": [
        {"name": "snow", "snow": {"ground": 400, "arrangement": "undrifted"}},
        {"name": "wind", "wind": {"speed": 26, "terrain": "II", "direction_deg": 0}},
    ],
}
CHOICES = [
    (table, key, choice)
    for table, words in TABLES.items()
    for key, said in words["keys"].items()
    for choice in said["choices"]
]


def test_labelled_keys_are_keys_of_the_file() -> None:
    keys = keys_of(FAMILIES[FAMILY].pattern)
    for table, words in describe_tables().items():
        first, *within = table.split(".")
        assert first in FileTable.model_fields
        if words["keys"]:
            assert set(words["keys"]) <= set(keys.beside((first, *within, "")))


@pytest.mark.parametrize(("table", "key", "choice"), CHOICES)
def test_choices_are_values_of_the_file(table: str, key: str, choice: str) -> None:
    design: dict[str, Any] = tomllib.loads(starter_file(FAMILY))
    if table.partition(".")[0] in LOADED:
        design |= copy.deepcopy(LOADED)
    if table == "target.fit":
        design["target"]["fit"] = {"width": 4}
    if table == "end_wall":
        design["end_wall"] = [{}]
    if key == "sides":
        design["panel"] = {"thickness": 0.01, "membrane": 0.001}
    if table == "stiffeners":
        design["stiffeners"] = {"kind": "gussets"}
    at: Any = design
    for name in table.split("."):
        if isinstance(at, list):
            at = next(each for each in at if name in each)
        at = at.setdefault(name, {})
    at = at[0] if isinstance(at, list) else at
    at |= BESIDE.get(choice, {}) | {key: choice}
    check_design(design, Path("shell.toml"))


@pytest.mark.parametrize("key", WORKSHOP_CHOICES)
def test_choices_of_the_workshop_have_labels(key: str) -> None:
    (parameter,) = (each for each in describe_workshop() if each["key"] == key)
    assert list(WORKSHOP_CHOICES[key]) == parameter["choices"]


def test_the_workshop_is_called_what_its_controls_are_called() -> None:
    words = describe_tables()["workshop"]["keys"]
    assert words["areal_density"]["label"] == "Mass per area"
    assert words["model_scale"]["label"] == "Print scale"


def test_every_format_and_setting_has_its_place_among_the_tasks() -> None:
    tasks = {each["name"]: each for each in describe_tasks()}
    assert {each.task for each in all_formats()} == {"", *tasks} - {"all"}
    assert all(each["formats"] for each in tasks.values())
    assert tasks["all"]["formats"] == [each.name for each in all_formats()]
    shown = [part for each in tasks.values() for part in (each, *each["archives"])]
    settings = [key for each in shown for key in each["settings"]]
    assert set(settings) == {each["key"] for each in describe_workshop()}

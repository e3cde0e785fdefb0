"""The families as the studio lists them: parameters, and an example of each; and the workshop.

The words of families and of the workshop are those of their knobs. The page says all of them as
they are here: beside its controls, in its history, and in messages in place of keys.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict
from typing import Any

from pydantic import BaseModel

from orishell.conventions.table import knobs_of
from orishell.conventions.toml_file import parse_toml
from orishell.design_file import starter_file
from orishell.families.registry import FAMILIES
from orishell.studio.api import Example, Family, KeyWords, Parameter, TableWords
from orishell.workshop import Workshop
from orishell.workshop.palettes import Layer


def describe_families() -> dict[str, Family]:
    """Names, parameters and defaults of all families."""
    return {
        name: {"label": each.label, "what": each.what, "parameters": _parameters(each.pattern)}
        for name, each in FAMILIES.items()
    }


def describe_examples() -> list[Example]:
    """A design of every family to begin with."""
    return [
        {
            "name": name,
            "title": f"{family.label} shell of the paper",
            "text": starter_file(name),
            "design": parse_toml(starter_file(name)),
        }
        for name, family in FAMILIES.items()
    ]


def describe_workshop() -> list[Parameter]:
    """The settings of the table [workshop]."""
    return _parameters(Workshop)


def _parameters(table: type[BaseModel]) -> list[Parameter]:
    parameters: list[Parameter] = []
    for key, knob in knobs_of(table).items():
        field = table.model_fields[key]
        choices = list(knob.choices)
        if knob.choices and field.default == "auto":
            choices.insert(0, "auto")
        said = {name: value for name, value in asdict(knob).items() if value is not None}
        default = None if field.is_required() else field.default
        parameter: Any = {"key": key, **said, "choices": choices, "default": default}
        parameters.append(parameter)
    return parameters


def describe_tables() -> dict[str, TableWords]:
    """Labels of all tables but those of a family's parameters, by the tables' names."""
    workshop = {
        each["key"]: _key(each["label"], each["help"], WORKSHOP_CHOICES.get(each["key"], {}))
        for each in describe_workshop()
    }
    return {**TABLES, "workshop": {"label": "Workshop", "keys": workshop}}


def _key(label: str, text: str, choices: Mapping[str, str] | None = None) -> KeyWords:
    return {"label": label, "help": text, "choices": dict(choices or {})}


TABLES: dict[str, TableWords] = {
    "target": {"label": "Curves", "keys": {}},
    "pattern": {"label": "Pattern", "keys": {}},
    "deployment": {
        "label": "Deployment",
        "keys": {
            "from": _key(
                "Opened from",
                "folded up from the flat sheet, or opened from a pack beyond the target",
                {"flat": "Flat sheet", "pack": "Pack"},
            ),
            "flap_attachment": _key(
                "Flaps",
                "part of the folding sheet, or boards that are put on at the target",
                {"folded": "Of the sheet", "clipped": "Clipped on"},
            ),
            "ties": _key(
                "Ties",
                "what keeps the shell from opening beyond its target",
                {"none": "None", "feet": "Between feet"},
            ),
            "largest_fold_deg": _key("Hinges close to", "180\u00b0: hinges fold flat"),
        },
    },
    "panel": {
        "label": "Panels",
        "keys": {
            "thickness": _key(
                "Thickness", "of a panel, boards and membrane together; 0: none is designed for"
            ),
            "construction": _key(
                "Construction",
                "boards on both faces of a membrane that is their hinge, or solid panels, "
                "chamfered where they close",
                {"sandwich": "Sandwich", "bevel": "Bevel"},
            ),
            "membrane": _key("Membrane", "thickness of the hinge between the boards"),
            "gap": _key("Gap", "between panels at every crease: room for a hinge or a kerf"),
            "stop_deg": _key(
                "Stop of the flaps", "angle by which flaps stop short of folding flat"
            ),
            "largest_setback": _key(
                "Largest setback", "how far boards may stand back from creases"
            ),
        },
    },
    "tolerance": {
        "label": "Tolerance",
        "keys": {
            "surface": _key("Surface", "largest distance between shell and surface"),
            "panel_min": _key("Shortest edge", "of a panel in the flat sheet; empty: any"),
            "panel_max": _key("Longest edge", "of a panel in the flat sheet; empty: any"),
        },
    },
    "shell": {
        "label": "Shell",
        "keys": {
            "family": _key("Family", "the crease pattern's"),
            "unit": _key("Unit", "of all lengths"),
            "ground": _key("Ground", "whether the feet stand on z = 0, or g lies there"),
        },
    },
    "motion": {
        # The page has no section for it: messages keep its name.
        "label": "",
        "keys": {
            "frames": _key("Frames", "states that files have"),
            "contact_tolerance": _key("Contact tolerance", "distance below which panels touch"),
        },
    },
}
WORKSHOP_CHOICES = {
    "palette": {
        "plain": "Plain",
        "lightburn": "LightBurn",
        "glowforge": "Glowforge",
        "epilog": "Epilog",
        "shop": "Laser shop",
        "plotter": "Plotter",
    },
    "creases": {"score": "Scored", "dashes": "Dashes", "perforation": "Perforated"},
    "labels": {
        "none": "None",
        "panels": "Panels",
        "creases": "Creases",
        "both": "Panels and creases",
    },
    "joint": {"tabs": "Tabs", "strips": "Strips"},
}
LAYERS: Mapping[Layer, str] = {
    "CUT": "Cut",
    "MOUNTAIN": "Mountain creases",
    "VALLEY": "Valley creases",
    "ENGRAVE": "Engraved",
    "LABEL": "Beside the work",
}
"""Layers of the workshop's drawings in words."""

"""The families as the studio lists them: parameters, and an example of each; and the workshop.

The words of families and of the workshop are those of their knobs. The page says all of them as
they are here: beside its controls, in its history, and in messages in place of keys.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any

from pydantic import BaseModel

from orishell.conventions.table import knobs_of
from orishell.conventions.toml_file import parse_toml
from orishell.design_file import starter_file
from orishell.families.pattern import AnyPattern
from orishell.families.registry import AUTO, FAMILIES
from orishell.io.formats import all_formats
from orishell.structure.materials import materials
from orishell.studio.info import (
    Example,
    ExportTask,
    Family,
    FileFormat,
    KeyWords,
    MaterialFacts,
    Parameter,
    TableWords,
)
from orishell.workshop import Workshop
from orishell.workshop.palettes import Layer


def describe_families() -> dict[str, Family]:
    """Names, parameters and defaults of all families, the choice among them last."""
    described: dict[str, Family] = {
        name: {
            "label": each.label,
            "what": each.what,
            "borders": each.borders,
            "aims": each.pattern.aims(),
            "parameters": _parameters(each.pattern),
        }
        for name, each in FAMILIES.items()
    }
    any_family: Family = {
        "label": "Automatic",
        "what": "Tries all families; takes the nearest that locks",
        "borders": "flaps",
        "aims": AnyPattern.aims(),
        "parameters": _parameters(AnyPattern),
    }
    return {**described, AUTO: any_family}


def describe_examples() -> list[Example]:
    """A design of every family to begin with."""
    return [
        {
            "name": name,
            "title": f"{family.label} shell{' of the paper' * family.pattern.sweeps()}",
            "text": starter_file(name),
            "design": parse_toml(starter_file(name)),
        }
        for name, family in FAMILIES.items()
    ]


def describe_formats() -> list[FileFormat]:
    """The formats that a shell can be written in."""
    return [
        {
            "name": each.name,
            "file": each.file,
            "what": each.what,
            "needs": "thickness" if each.solid else "loads" if each.analysed else "",
        }
        for each in all_formats()
    ]


def describe_tasks() -> list[ExportTask]:
    """What one writes files for, with the formats that say so, and all formats at the end."""
    tasks: dict[str, Any] = _WORDS["tasks"]
    return [
        {
            "name": name,
            "label": words["label"],
            "what": words["what"],
            "archives": [
                {
                    "name": each["name"],
                    "file": each["file"],
                    "what": each["what"],
                    "needs": "",
                    "settings": each["settings"],
                }
                for each in words.get("archives", ())
            ],
            "formats": [each.name for each in all_formats() if name in (each.task, "all")],
            "settings": words["settings"],
            "state": words["state"],
            "preview": words["preview"],
        }
        for name, words in tasks.items()
    ]


def describe_workshop() -> list[Parameter]:
    """The settings of the table [workshop]."""
    return _parameters(Workshop)


def describe_materials() -> list[MaterialFacts]:
    """What panels may be made of, by name."""
    return [
        {
            "name": name,
            "modulus": each.modulus,
            "strength": each.strength,
            "density": each.density,
            "grain": each.grain is not None,
            "sandwich": each.sandwich is not None,
            "conservative": each.conservative,
        }
        for name, each in materials().items()
    ]


def _parameters(table: type[BaseModel]) -> list[Parameter]:
    parameters: list[Parameter] = []
    for key, knob in knobs_of(table).items():
        field = table.model_fields[key]
        choices = list(knob.choices)
        if knob.choices and field.default == "auto":
            choices.insert(0, "auto")
        said = {name: value for name, value in asdict(knob).items() if value is not None}
        default = None if field.is_required() else field.default
        only = getattr(table, "only", {}).get(key)
        parameter: Any = {
            "key": key,
            **said,
            "choices": choices,
            "default": default,
            "only": only,
        }
        parameters.append(parameter)
    return parameters


def describe_tables() -> dict[str, TableWords]:
    """Labels of all tables but those of a family's parameters, by the tables' names."""
    workshop: dict[str, KeyWords] = {
        each["key"]: {
            "label": each["label"],
            "help": each["help"],
            "unit": each["unit"],
            "choices": WORKSHOP_CHOICES.get(each["key"], {}),
        }
        for each in describe_workshop()
    }
    # Its controls stand in the window of files.
    return {**TABLES, "workshop": {"label": "Export", "keys": workshop}}


_WORDS = parse_toml(Path(__file__).with_name("words.toml").read_text(encoding="utf-8"))
TABLES: dict[str, TableWords] = {
    name: {
        "label": table["label"],
        "keys": {
            key: {
                "label": each["label"],
                "help": each["help"],
                "unit": each.get("unit", ""),
                "choices": each.get("choices", {}),
            }
            for key, each in table.get("keys", {}).items()
        },
    }
    for name, table in _WORDS["tables"].items()
}
WORKSHOP_CHOICES: dict[str, dict[str, str]] = _WORDS["workshop_choices"]
LAYERS: Mapping[Layer, str] = _WORDS["layers"]
"""Layers of the workshop's drawings in words."""

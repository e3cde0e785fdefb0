"""The families as the studio lists them: parameters, and an example of each; and the workshop."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

from pydantic import BaseModel

from orishell.conventions.table import knobs_of
from orishell.conventions.toml_file import parse_toml
from orishell.design_file import starter_file
from orishell.families.registry import FAMILIES
from orishell.studio.api import Example, Family, Parameter
from orishell.workshop import Workshop


def describe_families() -> dict[str, Family]:
    """Names, parameters and defaults of all families."""
    return {name: _describe(name) for name in FAMILIES}


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


def _describe(name: str) -> Family:
    family = FAMILIES[name]
    return {
        "label": family.label,
        "what": family.what,
        "parameters": _parameters(family.pattern),
    }


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

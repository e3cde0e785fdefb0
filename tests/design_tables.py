"""Tables of design files, changed as a refusal says."""

from __future__ import annotations

import copy
from pathlib import Path
from typing import Any

from orishell.design_file import check_design
from orishell.errors import DesignError, Remedy
from orishell.shell.make import Shell, make_shell
from orishell.shell.parts import MEASURES

Tables = dict[str, Any]

DRAWN = (
    "points",
    "path",
    "smooth",
    "svg",
    "id",
    "dxf",
    "layer",
    "handle",
    "unit",
    "part",
    "reverse",
)
"""Keys of a curve that is no formula."""


def tables(family: str, f: Tables, g: Tables, **pattern: Any) -> Tables:
    return {
        "shell": {"family": family, "unit": "m"},
        "target": {"f": f, "g": g},
        "pattern": pattern,
        "motion": {"frames": 2},
    }


def formula(text: str | list[str], start: float, stop: float) -> Tables:
    return {"formula": text, "range": [start, stop]}


def made(design: Tables) -> Shell:
    """The shell, its proof included; distances are not measured."""
    return make_shell(check_design(design, Path("shell.toml")), leave_out=MEASURES)


def refused(design: Tables) -> DesignError | None:
    """Why a shell cannot be made; None if it can."""
    try:
        made(design)
    except DesignError as error:
        return error
    return None


def mended(design: Tables, remedy: Remedy) -> Tables:
    """The tables with what a remedy says typed in."""
    changed = copy.deepcopy(design)
    for key, value in remedy.changes.items():
        *path, name = key.split(".")
        table = changed
        for part in path:
            table = table.setdefault(part, {})
        if name == "formula":
            for other in DRAWN:
                table.pop(other, None)
        if value is None:
            table.pop(name, None)
        else:
            table[name] = value
    return changed

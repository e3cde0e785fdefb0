"""Tables of design files, changed as a refusal says."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from orishell.conventions.errors import DesignError, Remedy
from orishell.design_file import check_design
from orishell.design_file.tables import with_values
from orishell.shell.make import Shell, make_shell
from orishell.shell.steps import MEASURES

Tables = dict[str, Any]


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
    return make_shell(check_design(design, Path("shell.toml")), skip=MEASURES)


def refused(design: Tables) -> DesignError | None:
    """Why a shell cannot be made; None if it can."""
    try:
        made(design)
    except DesignError as error:
        return error
    return None


def mended(design: Tables, remedy: Remedy) -> Tables:
    """The tables with what a remedy says typed in."""
    changed: Tables = with_values(design, remedy.changes)
    return changed

"""Small searches, one of each family, that take tens of milliseconds a design."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from orishell.conventions.toml_file import parse_toml
from orishell.design_file import starter_file
from orishell.search.problem import Problem, parse_problem

PATH = Path("small.toml")

GRIDS: dict[str, dict[str, Any]] = {
    "parallel-repeating": {
        "variables": {
            "pattern.rows": [3, 5, 7],
            "pattern.columns": {"low": 3, "high": 5},
            "pattern.xi_deg": [40, 50, 60],
        },
        "minimise": ["panels", "sheet_area", "deviation.f.max"],
    },
    "orthodiagonal": {
        "variables": {
            "pattern.rows": [3, 5, 7],
            "pattern.columns": {"low": 4, "high": 7},
            "pattern.depth": {"low": 0.06, "high": 0.15, "step": 0.03},
        },
        "minimise": ["panels", "sheet_area", "deviation.f.max"],
    },
    "longitudinal-linear-repeating": {
        "variables": {
            "pattern.rows": {"low": 3, "high": 6},
            "pattern.columns": [3, 5, 7],
            "target.f.scale": [0.9, 1.0, 1.1],
        },
        "minimise": ["panels", "deviation.f.max"],
    },
}
"""A table [search] for the starter file of each family; each variant can be made, one by one."""


def small_problem(family: str, **changes: Any) -> Problem:
    """The small search of a family, keys of its table [search] changed."""
    tables = parse_toml(starter_file(family))
    return parse_problem({**tables, "search": {**GRIDS[family], **changes}}, PATH)


def loaded_tables(**search: Any) -> dict[str, Any]:
    """A short vault over a parabola of 2 m x 1 m, tied, under its own weight and under snow."""
    return {
        "shell": {"family": "orthodiagonal", "unit": "m"},
        "target": {
            "f": {"formula": "-x**2", "range": [-1, 1]},
            "g": {"formula": "0.25*sin(pi*x/2)", "range": [0, 2]},
        },
        "pattern": {"rows": 5, "columns": 5, "flap": 0.15, "depth": 0.12, "heading_deg": 90},
        "motion": {"frames": 3},
        "deployment": {"flap_attachment": "clipped", "ties": "feet"},
        "workshop": {"areal_density": 1.9},
        "structure": {
            "modulus": 270e6,
            "strength": 5e6,
            "crease_strength": 1e5,
            "line_strength": 1e6,
            "tie_strength": 1e6,
            "thickness": 0.01,
            "cells": 1,
            "supports": [{"at": "feet", "kind": "sliding"}],
        },
        "load_case": [
            {"name": "dead", "self_weight": True},
            {
                "name": "snow",
                "self_weight": True,
                "snow": {"ground": 500, "arrangement": "undrifted"},
            },
        ],
        "search": search,
    }

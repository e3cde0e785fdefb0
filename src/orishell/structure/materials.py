"""Materials by name, from ``materials.toml`` beside this file, with the source of each value."""

from __future__ import annotations

import tomllib
from functools import cache
from pathlib import Path

from orishell.conventions.record import record

FILE = Path(__file__).with_suffix(".toml")


@record
class Material:
    """What panels are made of."""

    modulus: float  # Young's modulus (N/m2)
    poisson: float  # Poisson's ratio
    strength: float  # what it bears (N/m2)
    density: float  # mass by volume (kg/m3)
    source: str  # where the values come from
    conservative: str  # what is on the safe side in them, and what is not


@cache
def materials() -> dict[str, Material]:
    """All materials by their names."""
    found = tomllib.loads(FILE.read_text(encoding="utf-8"))
    return {name: Material(**values) for name, values in found.items()}

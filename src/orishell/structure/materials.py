"""Materials by name, from ``materials.toml`` beside this file, with the source of each value."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import field
from functools import cache
from pathlib import Path
from typing import Any, Literal, get_args

from orishell.conventions.record import record
from orishell.structure.grain import GrainModuli, GrainStrength
from orishell.structure.sandwich import MadeSandwich

FILE = Path(__file__).with_suffix(".toml")


Duration = Literal["permanent", "long", "medium", "short", "instantaneous"]
"""How long a load lasts, the load-duration classes of EN 1995-1-1, 2.3.1.2."""
DURATIONS: tuple[Duration, ...] = get_args(Duration)
ServiceClass = Literal[1, 2, 3]
"""Of EN 1995-1-1, 2.3.1.3: indoors, under a roof, outdoors."""


@record
class Material:
    """What panels are made of."""

    modulus: float  # Young's modulus (N/m2)
    poisson: float  # Poisson's ratio
    strength: float  # what it bears, the characteristic value (N/m2)
    # gamma_M; 1 where the strength is on the safe side already, or no code gives one
    partial_factor: float
    density: float  # mass by volume (kg/m3)
    source: str  # where the values come from
    conservative: str  # what is on the safe side in them, and what is not
    sold: Sequence[float]  # how thick its boards are on the market, rising (m)
    sold_source: str  # where these are from
    # by service class: factors of strength by duration of loads, and of creep; empty for what is no
    # wood-based board
    k_mod: Mapping[str, Sequence[float]] = field(default_factory=dict)
    k_def: Mapping[str, float] = field(default_factory=dict)
    # of what is a sandwich: then modulus and strength are those of its faces
    sandwich: MadeSandwich | None = None
    grain: GrainStrength | None = None  # what it bears by its grain, characteristic values (N/m2)
    # how stiff it is by its grain, where it bears by that, too (N/m2)
    grain_moduli: GrainModuli | None = None

    def bears(self, duration: Duration, service: ServiceClass) -> float:
        """Design value of its strength under loads of a duration (N/m2)."""
        return self.strength * self.design_share(duration, service)

    def design_share(self, duration: Duration, service: ServiceClass) -> float:
        """Design values of strength, as a share of characteristic ones: EN 1995-1-1, 2.14."""
        factors = self.k_mod.get(str(service))
        k_mod = 1.0 if factors is None else factors[DURATIONS.index(duration)]
        return k_mod / self.partial_factor

    def density_of(self, thickness: float) -> float:
        """Mass by volume (kg/m3) of boards as thick (m)."""
        return self.density if self.sandwich is None else self.sandwich.density(thickness)

    def creeps(self, service: ServiceClass) -> float:
        """By how many times their first displacement lasting loads displace it further: k_def."""
        return self.k_def.get(str(service), 0.0)


@cache
def materials() -> dict[str, Material]:
    """All materials by their names."""
    found = tomllib.loads(FILE.read_text(encoding="utf-8"))
    return {name: _material(**values) for name, values in found.items()}


def _material(
    *,
    grain: Mapping[str, Any] | None = None,
    grain_moduli: Mapping[str, Any] | None = None,
    sandwich: Mapping[str, Any] | None = None,
    **values: Any,
) -> Material:
    return Material(
        grain=None if grain is None else GrainStrength(**grain),
        grain_moduli=None if grain_moduli is None else GrainModuli(**grain_moduli),
        sandwich=None if sandwich is None else MadeSandwich(**sandwich),
        **values,
    )

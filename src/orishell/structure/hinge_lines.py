"""What crease lines bear as lines: forces per length, by the direction in which they act.

A hinge passes on a pull or a push N square to its line in the plane of a panel, a shear V_in along
it, and a shear V square to the panel. Each has a strength of its own, and together they use

    sqrt((N/N_R)^2 + (V_in/V_in,R)^2 + (V/V_R)^2)

of what the line bears, as fasteners do that are pulled and sheared at once (EN 1995-1-1, 8.3.3,
equation 8.28).

Where something locks a crease, a moment M passes over it as a pair of forces: a pull in the hinge
and a push where panels meet, or the other way round, apart by a lever arm z. Then the line has to
bear N + M/z and N - M/z, too.
"""

from __future__ import annotations

import tomllib
from functools import cache
from pathlib import Path
from typing import Annotated, Any, ClassVar, Literal, Self

import numpy as np
from pydantic import BeforeValidator, Field, field_validator

from orishell.conventions.quantities import conversion
from orishell.conventions.record import record
from orishell.conventions.table import Number, Table, misfit
from orishell.numerics.arrays import Array

FILE = Path(__file__).with_suffix(".toml")
Direction = Literal["pull", "push", "along", "across"]
"""How a crease line may be loaded."""
DIRECTIONS: tuple[Direction, ...] = ("pull", "push", "along", "across")
Strength = Annotated[Number, Field(ge=1e-12, le=1e15)]


@record
class HingeLine:
    """A kind of crease line."""

    source: str  # where the values come from
    conservative: str  # what is on the safe side in them, and what is not
    # what it bears (N/m); None where nobody knows
    pull: float | None = None  # square to the line, in the plane of a panel, out of it
    push: float | None = None  # the same into the panel
    along: float | None = None  # shear along the line
    across: float | None = None  # shear square to a panel


@cache
def hinge_lines() -> dict[str, HingeLine]:
    """All kinds of crease lines by their names."""
    found = tomllib.loads(FILE.read_text(encoding="utf-8"))
    return {name: HingeLine(**values) for name, values in found.items()}


class LineStrength(Table):
    """What crease lines bear, by direction; None where that is not known."""

    SAMPLE: ClassVar = {"kind": "piano hinge"}

    REPORTED: ClassVar = ("kind", *DIRECTIONS)

    # what lines are, by its name in hinge_lines.toml: what is not given is taken from there
    kind: str | None = None
    # what they bear (force per length)
    pull: Strength | None = None  # square to the line, in the plane of a panel, out of it
    push: Strength | None = None  # the same into the panel
    along: Strength | None = None  # shear along the line
    across: Strength | None = None  # shear square to a panel

    @field_validator("kind")
    @classmethod
    def _require_kind(cls, kind: str | None) -> str | None:
        if kind is not None and kind not in hinge_lines():
            names = ", ".join(f'"{name}"' for name in hinge_lines())
            raise misfit(f"one of {names}", kind, choices=tuple(hinge_lines()))
        return kind

    @classmethod
    def alike(cls, strength: float) -> LineStrength:
        """Lines that bear as much in every direction (force per length)."""
        given = cls(pull=strength, push=strength, along=strength, across=strength)
        return cls.model_construct(_fields_set=set(), **dict(given))

    def filled(self, unit: str) -> Self:
        """With the values of its kind where they are not given, per length of a unit."""
        if self.kind is None:
            return self
        made, length = hinge_lines()[self.kind], conversion(unit, "m")
        known = {name: getattr(made, name) for name in DIRECTIONS}
        return self.replace_unchecked(
            **{
                name: None if each is None else each * length
                for name, each in known.items()
                if getattr(self, name) is None
            }
        )

    @property
    def is_known(self) -> bool:
        """Whether it is known in every direction."""
        return None not in [getattr(self, name) for name in DIRECTIONS]

    def used(self, forces: Array) -> Array:
        """The share (...) of what lines bear, as far as known, by forces (..., 4) by direction."""
        strengths = np.array([getattr(self, name) or np.inf for name in DIRECTIONS])
        return np.asarray(np.sqrt(((forces / strengths) ** 2).sum(axis=-1)))

    def unknown(self, forces: Array) -> Array:
        """The size (...) of those forces (..., 4) that act where no strength is known."""
        open_ = np.array([getattr(self, name) is None for name in DIRECTIONS])
        return np.asarray(np.sqrt((np.where(open_, forces, 0.0) ** 2).sum(axis=-1)))


def _alike(given: Any) -> Any:
    """One number is what lines bear in any direction."""
    if isinstance(given, int | float) and not isinstance(given, bool):
        return LineStrength.alike(float(given))
    return given


LineStrengths = Annotated[LineStrength, BeforeValidator(_alike)]
"""What crease lines bear: a number for all directions, or by direction."""

UNKNOWN = LineStrength()
"""Of lines of which nothing is known."""

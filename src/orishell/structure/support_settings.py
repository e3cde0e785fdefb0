"""What holds a shell, as a design file says it: ``supports`` of the table [structure].

Lengths are in the design's unit, masses in kilograms.
"""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal, Self

from pydantic import Field, model_validator
from pydantic_core import PydanticCustomError

from orishell.conventions.table import Number, Several, Table
from orishell.structure.load_settings import GridVertex

SupportKind = Literal["pinned", "fixed", "sliding", "friction"]
"""Held in place; and all panels there clamped; held up only; on the ground, which pushes only."""
Place = Literal["feet", "ends"]
"""The rows that are the shell's feet, or its first and last columns between flaps."""


class Support(Table):
    """What holds some vertices."""

    SAMPLE: ClassVar = {"at": "feet", "kind": "pinned"}

    REPORTED: ClassVar = ("at", "kind", "friction", "edges", "patch", "ballast")

    # the rows that are feet, the first and last columns, or vertices
    at: Place | Annotated[Several[GridVertex], Field(min_length=1)]
    kind: SupportKind  # how they are held
    # coefficient of friction of the ground, under ballast where that holds them
    friction: Annotated[Number, Field(ge=0, le=10)] = 0.0
    # whether edges of panels are held, too, whose ends are both among these vertices
    edges: bool = False
    # radius of what is held around each vertex, as a base plate does; 0 for points (length)
    patch: Annotated[Number, Field(ge=0, le=1e15)] = 0.0
    # mass of the ballast that holds each of these vertices down; 0 where it is held otherwise (kg)
    ballast: Annotated[Number, Field(ge=0, le=1e12)] = 0.0

    @model_validator(mode="after")
    def _check(self) -> Self:
        if self.edges and self.patch:
            raise PydanticCustomError(
                "edges_and_patch", "either edges or patch", {"key": "patch", "got": self.patch}
            )
        for key in ("edges", "patch"):
            if self.kind == "friction" and getattr(self, key):
                raise PydanticCustomError(
                    "broad_friction",
                    "no {key} where kind = friction: on the ground feet stand on points",
                    {"key": key, "got": getattr(self, key)},
                )
        if self.kind == "friction" and self.ballast:
            raise PydanticCustomError(
                "ballast_on_ground",
                "no ballast where kind = friction: with kind = pinned it is judged whether ballast "
                "and friction hold",
                {"key": "ballast", "got": self.ballast},
            )
        if self.kind == "friction" and not self.friction:
            raise PydanticCustomError(
                "no_friction",
                "a value above 0; ground without friction holds like kind = sliding",
                {"key": "friction", "got": self.friction},
            )
        rubs = self.kind == "friction" or (self.ballast and self.kind in {"pinned", "fixed"})
        if self.friction and not rubs:
            raise PydanticCustomError(
                "friction",
                'no friction, or kind = "friction", or "pinned" with ballast',
                {"key": "friction", "got": self.friction},
            )
        return self

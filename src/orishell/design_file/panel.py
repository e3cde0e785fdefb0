"""The table [panel] of a design file: what panels with a thickness are made of."""

from __future__ import annotations

import math
from typing import Annotated, Literal, Self

import numpy as np
from pydantic import Field, model_validator
from pydantic_core import PydanticCustomError

from orishell.conventions.table import Number, Size, Table
from orishell.design import Construction, PanelBuild


class SetbackTable(Table):
    """How far boards may stand back from creases."""

    share: Annotated[Number, Field(gt=0, lt=1)] = 0.5
    length: Annotated[Number, Field(gt=0)] | None = None


class PanelTable(Table):
    """What panels are made of; without a thickness they have none."""

    thickness: Size = 0.0
    construction: Construction = "sandwich"
    membrane: Size = 0.0
    gap: Size = 0.0
    largest_setback: SetbackTable = SetbackTable()
    stop_deg: Annotated[Number, Field(ge=0, le=45)] | Literal["auto"] = "auto"
    density: Size = 0.0
    membrane_density: Size = 0.0

    @model_validator(mode="after")
    def _check(self) -> Self:
        others = self.model_fields_set - {"thickness"}
        if not self.thickness:
            if others:
                raise PydanticCustomError(
                    "no_thickness",
                    "a thickness above 0, because {others} says what thick panels are made of",
                    {"others": ", ".join(sorted(others)), "key": "thickness", "got": 0},
                )
        elif self.construction == "bevel":
            for key in ("membrane", "membrane_density"):
                if getattr(self, key):
                    raise PydanticCustomError(
                        "solid",
                        'no membrane: "bevel" panels are solid. A membrane asks for construction = '
                        '"sandwich"',
                        {"key": key, "got": getattr(self, key)},
                    )
            if not self.gap:
                raise PydanticCustomError(
                    "no_hinge",
                    "a gap above 0: solid panels need room for their hinges. With a membrane "
                    'between boards, construction = "sandwich"',
                    {"key": "gap", "got": self.gap},
                )
        elif not 0 < self.membrane < self.thickness:
            raise PydanticCustomError(
                "no_hinge",
                "the thickness of the membrane between the boards, above 0 and below thickness "
                '({most}): it is their hinge. Without one, construction = "bevel"',
                {"most": self.thickness, "key": "membrane", "got": self.membrane},
            )
        return self

    def settings(self) -> PanelBuild | None:
        """What panels are made of, or None if they have no thickness."""
        if not self.thickness:
            return None
        longest = self.largest_setback.length
        return PanelBuild(
            thickness=self.thickness,
            construction=self.construction,
            membrane=self.membrane,
            gap=self.gap,
            share=self.largest_setback.share,
            setback=math.inf if longest is None else longest,
            stop=None if self.stop_deg == "auto" else float(np.deg2rad(self.stop_deg)),
            density=self.density,
            membrane_density=self.membrane_density,
        )

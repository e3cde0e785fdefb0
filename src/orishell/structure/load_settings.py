"""The table [[load_case]]: what loads a shell.

Lengths are in the design's unit, forces in newtons, wind speeds in metres per second.
"""

from __future__ import annotations

from collections.abc import Sequence, Set
from typing import Annotated, ClassVar, Final, Literal, NamedTuple, Self

import numpy as np
from pydantic import Field, field_validator, model_validator
from pydantic_core import PydanticCustomError

from orishell.conventions.table import Number, Pair, Several, Table, entries
from orishell.structure.materials import DURATIONS, Duration

Terrain = Literal["0", "I", "II", "III", "IV"]
"""Categories of EN 1991-1-4: sea, open, low vegetation, suburb, town."""
NO_CODE: Final = ((0.0, 0.8), (90.0, -1.0), (180.0, -0.4))
"""Pressure coefficients of wind where none are given, of no code: push on what faces the wind, pull
at the crown and in the lee, as about a long arch."""
LARGEST_LOAD = 1e12
"""Loads are smaller than this: what is computed from larger ones would overflow in the end."""
Action = Literal["permanent", "snow", "wind", "imposed", "maintenance"]
"""What a load case is to EN 1990."""
Side = Literal["middle", "left", "bottom", "right", "top"]
"""The middle of a panel, or of one of its sides, as the flat sheet is seen from +z."""
LONGEST = 60
"""Characters of a load case's name."""

Index = Annotated[int, Field(ge=0)]
GridVertex = Pair[Index]
"""Row and column of a vertex of the folding sheet, as for ties."""
Load = Annotated[Number, Field(ge=-LARGEST_LOAD, le=LARGEST_LOAD)]
Coefficient = Annotated[Number, Field(ge=-10, le=10)]
"""Of pressure, positive towards the outer face."""


SHAPES: Final[dict[str, tuple[str, ...]]] = {
    "both": ("undrifted", "drifted left", "drifted right", "in valleys"),
    "cylinder": ("undrifted", "drifted left", "drifted right"),
    "valleys": ("undrifted", "in valleys"),
}
"""Shapes of roofs that snow lies on, and its arrangements there: a folded vault is both."""


class Snow(Table):
    """Snow, down on the plan of panels whose outer face looks up.

    ``ground`` is its load on level ground (force per area). EN 1991-1-3 arranges it on a "cylinder"
    (5.3.5) and in the "valleys" of a corrugation (5.3.4), in several ways, one after the other
    unless ``arrangement`` names one. A folded vault is "both". ``exposure_factor`` and
    ``thermal_factor`` are its C_e and C_t (5.2).
    """

    SAMPLE: ClassVar = {"ground": 500}

    ground: Annotated[Number, Field(gt=0, le=LARGEST_LOAD)]
    exposure_factor: Annotated[Number, Field(gt=0, le=2)] = 1.0
    thermal_factor: Annotated[Number, Field(gt=0, le=1)] = 1.0
    shape: Literal["both", "cylinder", "valleys"] = "both"
    arrangement: Literal["undrifted", "drifted left", "drifted right", "in valleys"] | None = None

    @property
    def arrangements(self) -> tuple[Self, ...]:
        """The snow in each of its arrangements."""
        if self.arrangement is not None:
            return (self,)
        return tuple(self.replace_unchecked(arrangement=each) for each in SHAPES[self.shape])

    @model_validator(mode="after")
    def _check(self) -> Self:
        own = SHAPES[self.shape]
        if self.arrangement is not None and self.arrangement not in own:
            named = ", ".join(f'"{each}"' for each in own)
            raise PydanticCustomError(
                "arrangement",
                "{named}, for snow of this shape",
                {"key": "arrangement", "got": self.arrangement, "named": named},
            )
        return self


class Zone(Table):
    """Rows of panels, the first and the last, with one pressure coefficient."""

    rows: Pair[Index]
    coefficient: Coefficient

    @model_validator(mode="after")
    def _check(self) -> Self:
        if self.rows[0] > self.rows[1]:
            raise PydanticCustomError(
                "rows", "the first row, then the last", {"key": "rows", "got": self.rows}
            )
        return self


class Wind(Table):
    """Wind, square on the panels, by its basic speed (m/s) and the category of the terrain.

    It blows from x to y by ``direction_deg``. ``coefficients`` are pairs of an angle between a
    panel's outer normal and where the wind comes from (degrees) and the coefficient there, straight
    lines between them. Instead of them ``zones`` may name every row of panels once, or ``vault``
    give the coefficients of zones A, B and C of vaulted roofs. ``internal`` are coefficients of the
    pressure inside, one after the other; ``friction`` is that of the air along the surface.
    ``height`` over the ground is where its speed is taken; None for the top of the shell.
    """

    SAMPLE: ClassVar = {"speed": 26, "terrain": "II", "direction_deg": 90}

    speed: Annotated[Number, Field(gt=0, le=200)]
    terrain: Terrain
    direction_deg: Annotated[Number, Field(ge=-360, le=360)]
    coefficients: Several[Pair[Number]] = NO_CODE
    zones: Annotated[Several[Zone], Field(min_length=1)] | None = None
    vault: Annotated[tuple[Coefficient, Coefficient, Coefficient], entries(3)] | None = None
    internal: Several[Coefficient] = ()
    friction: Annotated[Number, Field(ge=0, le=1)] = 0.0
    height: Annotated[Number, Field(gt=0, le=LARGEST_LOAD)] | None = None

    @property
    def direction(self) -> float:
        """Where it blows to, from x to y (radians)."""
        return float(np.deg2rad(self.direction_deg))

    @property
    def is_of_no_code(self) -> bool:
        """Whether its coefficients are those of no code."""
        return self.zones is None and self.vault is None and self.coefficients == NO_CODE

    @property
    def arrangements(self) -> tuple[Self, ...]:
        """The wind with each pressure inside."""
        return tuple(self.replace_unchecked(internal=(each,)) for each in self.internal) or (self,)

    @model_validator(mode="after")
    def _check(self) -> Self:
        kinds = {"coefficients", "zones", "vault"} & self.model_fields_set
        given = {each for each in kinds if getattr(self, each) is not None}
        if len(given) > 1:
            raise PydanticCustomError(
                "two_kinds",
                "one of coefficients, zones and vault",
                {"key": min(given - {"coefficients"}), "got": " and ".join(sorted(given))},
            )
        angles = [angle for angle, _ in self.coefficients]
        if angles != sorted(set(angles)) or angles[:1] + angles[-1:] != [0, 180]:
            raise PydanticCustomError(
                "angles",
                "pairs of an angle and a coefficient, angles ascending from 0 to 180 degrees",
                {"key": "coefficients", "got": list(map(list, self.coefficients))},
            )
        return self


class PointLoad(Table):
    """A force at a vertex, along x, y and z (N)."""

    SAMPLE: ClassVar = {"at": [1, 2], "force": [0, 0, -1000]}

    at: GridVertex
    force: Annotated[tuple[Load, Load, Load], entries(3)]


class Person(Table):
    """A person on the shell, who works there: down, in the middle of a panel or of a side (N).

    Without ``at``, row and column of a panel of the folding sheet, the worst place is found.
    """

    SAMPLE: ClassVar = {"force": 1000}

    force: Annotated[Number, Field(gt=0, le=LARGEST_LOAD)] = 1000.0
    at: GridVertex | None = None
    side: Side = "middle"

    @model_validator(mode="after")
    def _check(self) -> Self:
        if self.at is None and self.side != "middle":
            raise PydanticCustomError(
                "side", "no side, or at, the panel that has it", {"key": "side", "got": self.side}
            )
        return self


class WorstPlace(Person):
    """A person where it is worst."""

    found: str  # how that was found, in words


class Loading(NamedTuple):
    """What a key of a load case is, that is a load."""

    # how long it lasts where a case does not say it: EN 1995-1-1, table 2.2, snow as where it
    # stays. That has no roofs of category H: a person is there for less than a week, table 2.1
    lasts: Duration
    action: Action | None = None  # what it is to EN 1990; None if cases have to say it


class LoadCase(Table):
    """Loads that act together, or factors by which those of other cases do.

    ``pressure`` is on the outer face, square on it (force per area). ``combine`` has factors of
    the loads of other cases by their names; then there are no others here. A case that others
    combine is not analysed on its own. ``action`` says what it is where a code combines cases, and
    ``duration`` how long it lasts, if its loads do not.
    """

    SAMPLE: ClassVar = {"name": "dead", "self_weight": True}

    name: str
    action: Action | None = None
    duration: Duration | None = None
    self_weight: Annotated[bool, Loading("permanent", "permanent")] = False
    pressure: Annotated[Load, Loading("medium")] = 0.0
    snow: Annotated[Snow | None, Loading("medium", "snow")] = None
    wind: Annotated[Wind | None, Loading("short", "wind")] = None
    points: Annotated[Several[PointLoad], Loading("medium")] = ()
    person: Annotated[Person | None, Loading("short", "maintenance")] = None
    combine: dict[str, Annotated[Number, Field(ge=-1e3, le=1e3)]] = Field(default_factory=dict)

    def lasts(self, known: Sequence[LoadCase]) -> Duration:
        """How long it lasts: as it says, or as the shortest of its loads (EN 1995-1-1, 3.1.3).

        known: Cases that it may combine.
        """
        if self.duration is not None:
            return self.duration
        if self.combine:
            parts = [each.lasts(known) for each in known if self.combine.get(each.name)]
        else:
            parts = [each.lasts for name, each in LOADS.items() if getattr(self, name)]
        return max(parts, key=DURATIONS.index, default="permanent")

    @field_validator("name")
    @classmethod
    def _require_line(cls, name: str) -> str:
        if not (name.strip() and name.isprintable() and len(name) <= LONGEST):
            raise PydanticCustomError(
                "name", "one line of 1 to {longest} characters", {"longest": LONGEST}
            )
        return name

    @model_validator(mode="after")
    def _check(self) -> Self:
        loads = [name for name in LOADS if getattr(self, name)]
        if loads and self.combine:
            raise PydanticCustomError(
                "loads_and_factors",
                "no combine beside {loads}: give these loads a case of their own, and combine that",
                {"key": "combine", "got": self.combine, "loads": ", ".join(loads)},
            )
        if not loads and not any(self.combine.values()):
            raise PydanticCustomError(
                "no_load",
                "a load, one of {loads}; or combine, factors of other cases",
                {"loads": ", ".join(LOADS)},
            )
        return self


def loads_of(case: type[Table], others: Set[str]) -> dict[str, Loading]:
    """The keys of a table of load cases that are loads: all but some others.

    Raises TypeError: If one of them does not say how long it lasts.
    """
    found: dict[str, Loading] = {}
    for name, field in case.model_fields.items():
        said = [each for each in field.metadata if isinstance(each, Loading)]
        if not said and name not in others:
            raise TypeError(f"the load {name} of a case has no Loading: how long it lasts")
        if said:
            found[name] = said[0]
    return found


LOADS: Final = loads_of(LoadCase, {"name", "action", "duration", "combine"})
"""The keys of a case that are loads, and what they are."""
OWN_WEIGHT = LoadCase(name="self-weight", self_weight=True)
"""The only case where a design file has none."""

"""Which values the parameters of a family may take, and how the studio shows them.

All that is known of a parameter stands once, at its key in the table [pattern] of its family, which
is what the functions that design take. Angles are in degrees there (``_deg``).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path as FilePath
from typing import (
    TYPE_CHECKING,
    Annotated,
    Any,
    ClassVar,
    Final,
    Literal,
    Protocol,
    Self,
    overload,
    runtime_checkable,
)

import numpy as np
from pydantic import AfterValidator, Field

from orishell.conventions.errors import InputError, Remedy
from orishell.conventions.progress import Progress, no_progress
from orishell.conventions.table import Knob, Number, Table, knobs_of, misfit
from orishell.curves import Curve, run_along_axis, trace_curve
from orishell.design import Design, PiecedSurface, Surface, Turning
from orishell.design.path import Path
from orishell.families.tolerance import Tolerance, Variants
from orishell.motion.drawing import Drawing
from orishell.motion.lattice import InnerStaircase

if TYPE_CHECKING:  # what Called is a kind of
    from pydantic._internal._model_construction import ModelMetaclass as Called
else:
    from orishell.conventions.arguments import Called

Auto = Literal["auto"]


@overload
def in_radians(angle: float) -> float: ...
@overload
def in_radians(angle: float | Auto) -> float | Auto: ...
def in_radians(angle: float | Auto) -> float | Auto:
    """An angle in radians, "auto" as it is.

    Parameters
    ----------
    angle
        As a table has it (degrees).
    """
    return angle if isinstance(angle, str) else float(np.deg2rad(angle))


def _require_odd(rows: int) -> int:
    if rows % 2 == 0:
        middle = f"so that there is a middle row ({rows - 1} or {rows + 1})"
        raise misfit(f"an odd number, {middle}", rows)
    return rows


RowCount = Annotated[int, Field(ge=1, le=10**15)]
OddRowCount = Annotated[RowCount, AfterValidator(_require_odd)]
ColumnCount = Annotated[int, Field(ge=2, le=10**15)]
Length = Annotated[Number, Field(gt=0)]
Width = Annotated[Number, Field(ge=0)]
"""A width that may be 0: then there are no flaps."""

ROWS: Final = Knob("Rows", "Rows of inner vertices, odd", slider=(1, 61), step=2)
COLUMNS: Final = Knob("Columns", "Columns of inner vertices", slider=(2, 61), step=1)
FLAP: Final = Knob("Flap", "Width of the locking flaps; 0 for none", "length")
FLAP_SIDE: Final = Knob(
    "Flaps fold to",
    "End of f to which both flaps fold",
    advanced=True,
)
SPACING: Final = Knob(
    "Spacing",
    "Columns closer together where g bends, or equally far apart",
    advanced=True,
)
PLACEMENT: Final = Knob(
    "Placement",
    "Columns on g, or moved off it to be equally wrong on both sides",
    advanced=True,
)


Aim = Literal["curves", "surface", "drawing", "none"]
"""What a shell follows: f and g, a surface, a drawn sheet, or nothing, where its own numbers say
all."""


class Pattern(Table, metaclass=Called):
    """What every family asks for: rows and columns of inner vertices, and flaps.

    What its shells can follow is said by which of the methods ``design...`` it has.
    """

    rows: Annotated[RowCount, ROWS]
    columns: Annotated[ColumnCount, COLUMNS]

    flap: Annotated[Width | Auto, FLAP] = "auto"

    most: ClassVar[int] = 201
    """The largest number of rows, and of columns, that is tried to meet a tolerance."""
    row_step: ClassVar[int] = 2
    """Numbers of rows that the family makes are 1 and so many more, again and again."""
    ripple: ClassVar[float] = 1.5
    """A shell is farther from its surface than one with fewer columns by such a factor at most."""
    orderly: ClassVar[bool] = False
    """Whether that holds for fewer rows as well, and none is nearer whose column 1 is farther from
    f."""
    closing: ClassVar[Remedy | None] = None
    """A change with which all creases of a shell without flaps may close together."""
    only: ClassVar[Mapping[str, Aim]] = {}
    """Keys that have a meaning only for shells with such a target."""
    unasked: ClassVar[Mapping[str, Any]] = {}
    """Values of keys that a file must give, where it leaves the family open."""

    def lengths(self) -> tuple[str, str] | None:
        """Keys that make a sheet without a target wider, and deeper; None if there are none."""
        return None

    def design(self, f: Curve, g: Curve) -> Design:
        """Design the shell that these parameters and the curves f and g ask for.

        A family that sweeps none is fitted to f swept along g, f's middle on g, as to any surface.
        """
        profile = run_along_axis(trace_curve(f, "f").in_own_frame())
        path = trace_curve(g, "g").in_own_frame()
        middle = profile.curve.position(0.5 * (profile.t[0] + profile.t[-1]))
        design = self.design_on(Surface(profile, middle, Turning(Path.of(path), np.pi / 2)))
        return replace(design, origin=design.origin + np.append(path.origin, 0.0))

    def design_on(self, surface: PiecedSurface, progress: Progress = no_progress) -> Design:
        """Design the shell that these parameters and a surface with a ``piece`` ask for."""
        raise NotImplementedError

    def design_near(self, surface: PiecedSurface, before: Design, progress: Progress) -> Design:
        """Design as ``design_on`` does, from the sheet of a design on another surface nearby."""
        return self.design_on(surface, progress)

    def design_drawn(self, drawing: Drawing) -> Design:
        """Design the shell that these parameters and a drawn sheet ask for."""
        raise NotImplementedError

    def largest_panel(self, surface: PiecedSurface) -> float:
        """An area that a panel over a surface has at least; 0 where none is known before."""
        return 0.0

    @classmethod
    def aims(cls) -> list[Aim]:
        """What its shells can follow: nothing only where they follow no curves."""
        can: dict[Aim, bool] = {
            "curves": cls.sweeps(),
            "surface": cls.follows_surfaces(),
            "drawing": cls.design_drawn is not Pattern.design_drawn,
            "none": not (cls.needs_target() or cls.sweeps()),
        }
        return [aim for aim, possible in can.items() if possible]

    @classmethod
    def sweeps(cls) -> bool:
        """Whether it is designed by curves f and g, or may be, by ``design``."""
        return cls.design is not Pattern.design

    @classmethod
    def needs_target(cls) -> bool:
        """Whether there is no design without a target, by ``design_without_target``."""
        return cls.design_without_target is Pattern.design_without_target

    @classmethod
    def follows_surfaces(cls) -> bool:
        """Whether it makes shells that come near to any surface, by ``design_on``."""
        return cls.design_on is not Pattern.design_on

    def design_without_target(self) -> Design:
        """Design what these parameters alone ask for, in a family that needs no target."""
        raise NotImplementedError

    def idle(self) -> set[str]:
        """Keys that change nothing beside the others, so that nothing is asked of them."""
        return set() if self.flap else {"flap_side"}

    @classmethod
    def knobs(cls) -> dict[str, Knob]:
        """The knobs of all keys that the studio shows, rows and columns first."""
        return knobs_of(cls)

    def sized(self, rows: int, columns: int) -> Self:
        """The pattern with other numbers of rows and columns."""
        return self.model_copy(update={"rows": rows, "columns": columns})

    def variants(self, f: Curve, tolerance: Tolerance) -> Variants[Self]:
        """Patterns of as many rows that fill in what the file leaves open.

        Raises
        ------
        DesignError
            If f cannot be followed at all.
        """
        return Variants([self])

    def distance_from_f(self, f: Curve) -> float:
        """A distance (length) at which column 1 is from f at least, however many columns there are.

        0 where none is known before the sheet is made.

        Raises
        ------
        DesignError
            If there is no such column.
        """
        return 0.0

    def distance_from_g(self, g: Curve) -> float:
        """A distance (length) at which the middle row is from g at least, however many rows are.

        0 where none is known before the sheet is made.

        Raises
        ------
        DesignError
            If there is no such row.
        """
        return 0.0


@runtime_checkable
class TwoStaircases(Protocol):
    """A pattern whose sheets can carry a second skin that follows a curve of its own."""

    def inner_staircase(self, f: Curve, inner: Curve) -> InnerStaircase:
        """The staircase of a second skin, on the lattice of the sheet.

        Raises
        ------
        DesignError
            If the curve has no staircase of the directions that the sheet has.
        """


def _undecided() -> InputError:
    return InputError(
        "the family is still to be chosen",
        keys=("shell.family",),
        remedy="name a family; orishell design tries all and says what each does",
    )


class AnyPattern(Pattern):
    """What a file says of the pattern where its family is to be chosen."""

    def design(self, f: Curve, g: Curve) -> Design:
        """Refuse to design anything before there is a family.

        Raises
        ------
        InputError
            Always.
        """
        raise _undecided()

    def design_on(self, surface: PiecedSurface, progress: Progress = no_progress) -> Design:
        """Refuse to design anything before there is a family.

        Raises
        ------
        InputError
            Always.
        """
        raise _undecided()


@dataclass(frozen=True, slots=True)
class Family:
    """A family as the design file, the studio and the command line know it."""

    name: str  # what the design file calls it
    pattern: type[Pattern]  # its table
    label: str  # what headings call it
    what: str  # what it makes, in a few words
    starter: FilePath  # A design file to begin with
    borders: str = "flaps"  # what the panels beside its inner columns are
    in_strips: bool = False  # whether its shells are made in strips, and not of one flat sheet

    def __post_init__(self) -> None:
        """Refuse a family that designs nothing."""
        if not self.pattern.aims():
            raise TypeError(
                f"{self.pattern.__name__} designs nothing: it has none of design, design_on, "
                "design_drawn and design_without_target"
            )

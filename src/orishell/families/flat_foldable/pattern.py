"""The table [pattern] of the flat-foldable family, and how it is listed."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, ClassVar, Self

from pydantic import Field, model_validator

from orishell.conventions.errors import InputError
from orishell.conventions.table import Knob, Number
from orishell.curves import Curve
from orishell.design import Design
from orishell.families.flat_foldable.design import (
    FOLD,
    SECTOR,
    SIGNED,
    TURN,
    Corners,
    SheetKind,
    design_flat_foldable,
    require_lists,
)
from orishell.families.pattern import (
    Auto,
    ColumnCount,
    Family,
    Length,
    Pattern,
    RowCount,
    Width,
)
from orishell.families.shared.candidates import forgiving

ROWS = Knob("Rows", "Rows of inner vertices", "integer", slider=(1, 61), step=1)
COLUMNS = Knob("Columns", "Columns of inner vertices", "integer", slider=(2, 61), step=1)
SignedAngles = list[Annotated[Number, Field(**SIGNED)]]
Angles = list[Annotated[Number, Field(**FOLD)]]


class FlatFoldablePattern(Pattern):
    """Parameters of the flat-foldable family."""

    row_step: ClassVar[int] = 1
    needs_target: ClassVar[bool] = False

    rows: Annotated[RowCount, ROWS]
    columns: Annotated[ColumnCount, COLUMNS]
    sheet: Annotated[
        SheetKind,
        Knob(
            "Sheet",
            "Miura-ori, an arch, a fan, or what the lists of the design file say",
            "choice",
            choices=("miura", "arch", "fan", "lists"),
        ),
    ] = "miura"
    fold_deg: Annotated[
        Annotated[Number, Field(**FOLD)] | Auto,
        Knob.angle("Fold", "Largest fold angle of the shell", (5, 175), step=1),
    ] = "auto"
    sector_deg: Annotated[
        Annotated[Number, Field(**SECTOR)],
        Knob.angle("Sector angle", "Between rows and columns", (20, 85), step=1, auto=False),
    ] = 60.0
    turn_deg: Annotated[
        Annotated[Number, Field(**TURN)] | Auto,
        Knob.angle("Turn", "How far an arch turns, or a fan spreads", (1, 240), step=1),
    ] = "auto"
    growth: Annotated[
        Length,
        Knob(
            "Growth",
            "Last edge of a column by the first",
            "number",
            slider=(0.2, 5),
            step=0.1,
        ),
    ] = 1.0
    row_length: Annotated[
        Length, Knob("Row edge", "Along the middle row", "number", unit="length")
    ] = 1.0
    column_length: Annotated[
        Length, Knob("Column edge", "First edge of a column", "number", unit="length")
    ] = 1.0
    row_folds_deg: SignedAngles | Auto = "auto"
    column_folds_deg: SignedAngles | Auto = "auto"
    row_angles_deg: Angles | Auto = "auto"
    column_angles_deg: Angles | Auto = "auto"
    row_lengths: list[Length] | Auto = "auto"
    column_lengths: list[Length] | Auto = "auto"
    top_lengths: list[Length] | Auto = "auto"
    bottom_lengths: list[Length] | Auto = "auto"
    left_lengths: list[Length] | Auto = "auto"
    right_lengths: list[Length] | Auto = "auto"
    corners: Corners | Auto = "auto"
    flap: Annotated[
        Width | Auto,
        Knob(
            "Flap", "Width of flaps at straight borders; 0 for none", "number", True, "length"
        ),
    ] = 0.0

    @model_validator(mode="after")
    def _check(self) -> Self:
        require_lists(self)
        return self

    def design(self, f: Curve, g: Curve) -> Design:
        """Refuse f and g: a sheet of this family is designed by its own numbers."""
        raise InputError(
            "this family does not sweep f along g",
            keys=("target.f", "target.g"),
            remedy="remove [target.f] and [target.g]",
        )

    def design_without_target(self) -> Design:
        """Design the sheet alone."""
        return forgiving(self, design_flat_foldable)


FAMILY = Family(
    name="flat-foldable",
    pattern=FlatFoldablePattern,
    label="Flat-foldable",
    what="Quadrilaterals that fold to a flat stack",
    starter=Path(__file__).with_name("starter.toml"),
    borders="a border",
)

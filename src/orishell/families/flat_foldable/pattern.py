"""The table [pattern] of the flat-foldable family, and how it is listed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Annotated, ClassVar, Literal, Self

import numpy as np
from pydantic import Field, model_validator

from orishell.conventions.errors import InputError
from orishell.conventions.progress import Progress, no_progress
from orishell.conventions.table import Knob, Number
from orishell.curves import Curve, run_along_axis, trace_curve
from orishell.design import Design, PiecedSurface, Surface, Turning
from orishell.design.path import Path as Pieces
from orishell.families.flat_foldable.design import (
    FOLD,
    SECTOR,
    SIGNED,
    TURN,
    Corners,
    SheetKind,
    design_flat_foldable,
)
from orishell.families.flat_foldable.fit.design import Asked, design_fitted
from orishell.families.flat_foldable.ground import Ground
from orishell.families.flat_foldable.lists import require_lists
from orishell.families.flat_foldable.locks.flaps import locked
from orishell.families.pattern import (
    Aim,
    Auto,
    ColumnCount,
    Family,
    Length,
    Pattern,
    RowCount,
    Width,
)
from orishell.families.shared.candidates import forgiving

ROWS = Knob("Rows", "Rows of inner vertices", slider=(1, 61), step=1)
COLUMNS = Knob("Columns", "Columns of inner vertices", slider=(2, 61), step=1)
SignedAngles = list[Annotated[Number, Field(**SIGNED)]]
Angles = list[Annotated[Number, Field(**FOLD)]]


class FlatFoldablePattern(Pattern):
    """Parameters of the flat-foldable family."""

    row_step: ClassVar[int] = 1
    sweeps: ClassVar[bool] = False
    needs_target: ClassVar[bool] = False
    only: ClassVar[Mapping[str, Aim]] = {
        **dict.fromkeys(("sheet", "sector_deg", "turn_deg", "growth"), "none"),
        **dict.fromkeys(("row_length", "column_length"), "none"),
        **dict.fromkeys(("edge_ratio", "direction_deg", "border", "ground"), "surface"),
    }

    rows: Annotated[RowCount, ROWS]
    columns: Annotated[ColumnCount, COLUMNS]
    sheet: Annotated[
        SheetKind,
        Knob(
            "Sheet",
            "Miura-ori, an arch, a fan, or what the lists of the design file say",
        ),
    ] = "miura"
    fold_deg: Annotated[
        Annotated[Number, Field(**FOLD)] | Auto,
        Knob.angle("Fold", "Largest fold angle of the shell", (5, 175), step=1),
    ] = "auto"
    sector_deg: Annotated[
        Annotated[Number, Field(**SECTOR)],
        Knob.angle("Sector angle", "Between rows and columns", (20, 85), step=1),
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
            slider=(0.2, 5),
            step=0.1,
        ),
    ] = 1.0
    row_length: Annotated[Length, Knob("Row edge", "Along the middle row", "length")] = 1.0
    column_length: Annotated[Length, Knob("Column edge", "First edge of a column", "length")] = 1.0
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
    edge_ratio: Annotated[
        Annotated[Number, Field(ge=1.5, le=100)],
        Knob(
            "Edge ratio",
            "Longest edge by the shortest, at most, of a sheet fitted to a surface",
            slider=(3, 30),
            step=0.5,
            advanced=True,
        ),
    ] = 10.0
    direction_deg: Annotated[
        Literal[0, 90, 180, 270] | Auto,
        Knob.angle(
            "Direction", "How far rows are turned on the surface", (0, 270), step=90, advanced=True
        ),
    ] = "auto"
    border: Annotated[
        Literal["free", "straight"],
        Knob(
            "Right border",
            "Straight in the flat sheet where one is fitted to a surface, so that flaps lock it",
            advanced=True,
        ),
    ] = "free"
    ground: Annotated[
        Ground,
        Knob(
            "Ground",
            "As fitted, level at its four corners, or with two sides of its rim cut level",
        ),
    ] = "free"
    flap: Annotated[
        Width | Auto,
        Knob("Flap", "Width of flaps that lock the shell; 0 for none", "length"),
    ] = 0.0

    @model_validator(mode="after")
    def _check(self) -> Self:
        require_lists(self)
        return self

    def design(self, f: Curve, g: Curve) -> Design:
        """Fit a sheet to f swept along g, f's middle on g, as to any surface."""
        profile = run_along_axis(trace_curve(f, "f").in_own_frame())
        path = trace_curve(g, "g").in_own_frame()
        middle = profile.curve.position(0.5 * (profile.t[0] + profile.t[-1]))
        design = self.design_on(Surface(profile, middle, Turning(Pieces.of(path), np.pi / 2)))
        return replace(design, origin=design.origin + np.append(path.origin, 0.0))

    def design_on(self, surface: PiecedSurface, progress: Progress = no_progress) -> Design:
        """Fit a sheet of so many rows and columns to a surface with a ``piece``.

        ``fold_deg`` is then the fold angle of the row creases that the fit begins with.

        Raises
        ------
        InputError
            If the table asks for a sheet of its own.
        DesignError
            If none comes near enough that can be made.
        """
        if self.sheet != "miura":
            raise InputError(
                "a sheet that is fitted to a surface begins as a Miura-ori",
                keys=("pattern.sheet",),
                got=f'"{self.sheet}"',
                expected='"miura"',
                remedy='write sheet = "miura", or remove [target.surface]',
            )
        if self.ground != "free" and self.border == "straight":
            raise InputError(
                "creases that end on the ground leave no border straight",
                keys=("pattern.ground", "pattern.border"),
                got=f'"{self.ground}"',
                expected='"free", or border = "free"',
                remedy='write border = "free", or leave ground out',
            )
        design = design_fitted(
            Asked(
                surface=surface,
                rows=self.rows,
                columns=self.columns,
                edge_ratio=self.edge_ratio,
                direction=None if self.direction_deg == "auto" else self.direction_deg,
                fold=None if self.fold_deg == "auto" else float(np.deg2rad(self.fold_deg)),
                straight=self.border == "straight",
                ground=self.ground,
            ),
            progress,
        )
        if not self.flap:
            return design
        return locked(design, self.flap, straight=self.border == "straight")

    def idle(self) -> set[str]:
        """Keys of a fit, of a sheet without a target."""
        return super().idle() | {key for key, aim in self.only.items() if aim == "surface"}

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

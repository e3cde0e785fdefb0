"""The table [pattern] of the flat-foldable family (not in the paper), and how it is listed."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, ClassVar, Literal, Self, TypeVar

import numpy as np
from pydantic import Field, model_validator

from orishell.conventions.arguments import checked
from orishell.conventions.errors import InputError
from orishell.conventions.progress import Progress, no_progress
from orishell.conventions.table import Knob, Number, misfit
from orishell.design import Design, PiecedSurface
from orishell.families.flat_foldable.design import of_lists, of_name
from orishell.families.flat_foldable.fit.design import COVERED, Asked, design_fitted
from orishell.families.flat_foldable.ground import Ground
from orishell.families.flat_foldable.lists import CORNERS, LISTS, SHORTER, Lists
from orishell.families.flat_foldable.locks.flaps import locked
from orishell.families.flat_foldable.named import NamedSheet
from orishell.families.pattern import (
    Aim,
    Auto,
    ColumnCount,
    Family,
    Length,
    Pattern,
    RowCount,
    Width,
    in_radians,
)
from orishell.families.shared.candidates import forgiving

ROWS = Knob("Rows", "Rows of inner vertices", slider=(1, 61), step=1)
COLUMNS = Knob("Columns", "Columns of inner vertices", slider=(2, 61), step=1)
Fold = Annotated[Number, Field(gt=0, lt=180)]
SignedAngles = list[Annotated[Number, Field(gt=-180, lt=180)]]
Angles = list[Fold]
Corners = Annotated[list[Number], Field(min_length=len(CORNERS), max_length=len(CORNERS))]
SheetKind = Literal["miura", "arch", "fan", "lists"]
T = TypeVar("T")


class FlatFoldablePattern(Pattern):
    """Parameters of the flat-foldable family."""

    row_step: ClassVar[int] = 1
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
        Fold | Auto,
        Knob.angle("Fold", "Largest fold angle of the shell", (5, 175), step=1),
    ] = "auto"
    sector_deg: Annotated[
        Annotated[Number, Field(gt=0, lt=90)],
        Knob.angle("Sector angle", "Between rows and columns", (20, 85), step=1),
    ] = 60.0
    turn_deg: Annotated[
        Annotated[Number, Field(ge=-360, le=360)] | Auto,
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
        counts = self.rows, self.columns
        for key, axis in (*LISTS.items(), *SHORTER.items(), ("corners", None)):
            given = getattr(self, key)
            if self.sheet != "lists":
                if given != "auto":
                    raise misfit('"auto", or sheet = "lists"', given, key)
                continue
            if "folds" in key and given == "auto":
                raise misfit('a list of fold angles, or another sheet ("miura")', given, key)
            if given == "auto" or axis is None:
                continue
            count = counts[axis] - (key in SHORTER)
            if len(given) != count:
                raise misfit(f"{count} entries", len(given), key)
            if "folds" in key and 0 in given:
                raise misfit("fold angles other than 0", 0.0, key)
        if self.turn_deg == "auto":
            return self
        if self.sheet in ("miura", "lists"):
            raise misfit('"auto", or sheet = "arch" or "fan"', self.turn_deg, "turn_deg")
        if self.sheet == "arch" and self.turn_deg <= 0:
            raise misfit("an angle above 0 in an arch", self.turn_deg, "turn_deg")
        return self

    def lengths(self) -> tuple[str, str] | None:
        """Of a sheet by its name: the lengths of an edge along rows and down columns."""
        return None if self.sheet == "lists" else ("row_length", "column_length")

    def lists(self) -> Lists:
        """The lists of the sheet, those that are left open as such."""
        assert self.row_folds_deg != "auto"
        assert self.column_folds_deg != "auto"
        return Lists(
            row_folds=np.deg2rad(self.row_folds_deg).tolist(),
            column_folds=np.deg2rad(self.column_folds_deg).tolist(),
            row_angles=_all_in_radians(self.row_angles_deg),
            column_angles=_all_in_radians(self.column_angles_deg),
            row_lengths=_given(self.row_lengths) or [self.row_length] * (self.columns - 1),
            column_lengths=_given(self.column_lengths) or [self.column_length] * (self.rows - 1),
            top=_given(self.top_lengths),
            bottom=_given(self.bottom_lengths),
            left=_given(self.left_lengths),
            right=_given(self.right_lengths),
            corners=_given(self.corners),
        )

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
        return self._fitted(surface, None, progress)

    def design_near(self, surface: PiecedSurface, before: Design, progress: Progress) -> Design:
        """Fit a sheet as ``design_on`` does, from that of a design on another surface nearby."""
        return self._fitted(surface, before, progress)

    def _fitted(self, surface: PiecedSurface, before: Design | None, progress: Progress) -> Design:
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
                fold=_given(in_radians(self.fold_deg)),
                straight=self.border == "straight",
                ground=self.ground,
            ),
            progress,
            begin=None if before is None else before.fitted,
        )
        if not self.flap:
            return design
        return locked(design, self.flap, straight=self.border == "straight")

    def largest_panel(self, surface: PiecedSurface) -> float:
        """The mean panel of the smallest sheet that is taken over a surface."""
        return COVERED * surface.area() / ((self.rows + 1) * (self.columns + 1))

    def idle(self) -> set[str]:
        """Keys of a fit, of a sheet without a target."""
        return super().idle() | {key for key, aim in self.only.items() if aim == "surface"}

    def design_without_target(self) -> Design:
        """Design the sheet alone."""
        return forgiving(self, design_flat_foldable)


@checked()
def design_flat_foldable(pattern: FlatFoldablePattern) -> Design:
    """Design a sheet that folds flat, by a few numbers or by its lists, with no target to meet.

    Parameters
    ----------
    pattern
        Rows, columns, and which sheet is asked for.

    Raises
    ------
    InputError
        If an argument has no meaning.
    DesignError
        If there is no such sheet: the condition, where, by how much, what works.

    Examples
    --------
    >>> design_flat_foldable(FlatFoldablePattern(rows=5, columns=6)).mechanism
    FlatFoldable(7 x 8 vertices, 42 panels, drive to 90 degrees)
    """
    if pattern.sheet == "lists":
        return of_lists(pattern.lists(), _given(in_radians(pattern.fold_deg)), pattern.flap)
    fold = 90.0 if pattern.fold_deg == "auto" else pattern.fold_deg
    named = NamedSheet(
        pattern.rows,
        pattern.columns,
        in_radians(pattern.sector_deg),
        in_radians(fold),
        pattern.row_length,
        pattern.column_length,
        pattern.growth,
    )
    return of_name(named, pattern.sheet, _given(in_radians(pattern.turn_deg)), pattern.flap)


def _given(value: T | Auto) -> T | None:
    return None if isinstance(value, str) else value


def _all_in_radians(angles: list[float] | Auto) -> list[float] | None:
    return None if isinstance(angles, str) else [in_radians(angle) for angle in angles]


FAMILY = Family(
    name="flat-foldable",
    pattern=FlatFoldablePattern,
    label="Flat-foldable",
    what="Quadrilaterals that fold to a flat stack",
    starter=Path(__file__).with_name("starter.toml"),
    borders="a border",
)

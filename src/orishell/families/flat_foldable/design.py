"""Flat-foldable sheets from their own numbers, with no target to meet (not in the paper)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Annotated, Any, Final, Literal

import numpy as np
from pydantic import Field

from orishell.conventions.arguments import checked
from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.formatting import rounded, rounded_down, tidy_degrees
from orishell.conventions.table import Number
from orishell.design import Design, Parameter
from orishell.families.flat_foldable.lists import CORNERS, Lists, describe, require_lists
from orishell.families.flat_foldable.locks.flaps import flap_width, with_any_flaps
from orishell.families.flat_foldable.locks.straight import with_parallel_borders
from orishell.families.flat_foldable.named import NamedSheet
from orishell.families.flat_foldable.net import Net
from orishell.families.flat_foldable.placement import levelled, with_level_ends
from orishell.families.flat_foldable.refusal import find_fault
from orishell.families.pattern import (
    Auto,
    ColumnCount,
    Length,
    Limits,
    RowCount,
    Width,
    in_radians,
)
from orishell.motion import require_resolution
from orishell.numerics.bisection import largest_below

FOLD: Final[Limits] = {"gt": 0, "lt": 180}
SIGNED: Final[Limits] = {"gt": -180, "lt": 180}
SECTOR: Final[Limits] = {"gt": 0, "lt": 90}
TURN: Final[Limits] = {"ge": -360, "le": 360}
"""Limits of angles (degrees)."""
SheetKind = Literal["miura", "arch", "fan", "lists"]
Fold = Annotated[Number, in_radians(FOLD)]
Folds = list[Annotated[Number, in_radians(SIGNED)]]
Angles = list[Annotated[Number, in_radians(FOLD)]]
Corners = Annotated[list[Number], Field(min_length=len(CORNERS), max_length=len(CORNERS))]
SECTOR_ANGLE = float(np.deg2rad(60.0))
TURNS = {"arch": np.deg2rad(120), "fan": np.deg2rad(40)}
"""Turns that are taken where they are left open, or half of them, and so on."""
SMALLEST_TURN = 1e-3
"""The smallest share of a turn that is tried in its place."""


@checked(require_lists)
def design_flat_foldable(
    *,
    rows: RowCount,
    columns: ColumnCount,
    sheet: SheetKind = "miura",
    fold: Fold | Auto = "auto",
    sector: Annotated[Number, in_radians(SECTOR)] = SECTOR_ANGLE,
    turn: Annotated[Number, in_radians(TURN)] | Auto = "auto",
    growth: Length = 1.0,
    row_length: Length = 1.0,
    column_length: Length = 1.0,
    row_folds: Folds | Auto = "auto",
    column_folds: Folds | Auto = "auto",
    row_angles: Angles | Auto = "auto",
    column_angles: Angles | Auto = "auto",
    row_lengths: list[Length] | Auto = "auto",
    column_lengths: list[Length] | Auto = "auto",
    top_lengths: list[Length] | Auto = "auto",
    bottom_lengths: list[Length] | Auto = "auto",
    left_lengths: list[Length] | Auto = "auto",
    right_lengths: list[Length] | Auto = "auto",
    corners: Corners | Auto = "auto",
    flap: Width | Auto = 0.0,
) -> Design:
    """Design a sheet that folds flat, by a few numbers or by its lists.

    Parameters
    ----------
    rows, columns
        Inner vertices m and n.
    sheet
        "miura"; "arch", whose columns turn; "fan", whose columns run apart downwards; or "lists".
    fold
        The largest fold angle at the target (radians); "auto" is 90 degrees, or what lists say.
    sector
        Sector angle between rows and straight columns (radians), in an arch of the rows that fold
        most, in a fan the mean.
    turn
        In an arch the angle by which columns turn from the first to the last row at the target, in
        a fan the angle between the first and the last column of the flat sheet (radians).
    growth
        The last edge of a column by the first.
    row_length, column_length
        Lengths of edges along the middle row, in an arch along rows that fold most, and of the
        first edge of a column.
    row_folds, column_folds
        Lists: fold angles of the first crease of every row and column at the target, valley
        positive (radians).
    row_angles, column_angles
        Sectors left-down of all vertices of the middle row (n) and of the middle column (m)
        (radians), or "auto" for creases that go straight on.
    row_lengths, column_lengths
        Lengths of the edges along the middle row (n-1) and down the middle column (m-1).
    top_lengths, bottom_lengths, left_lengths, right_lengths
        Lengths of the creases that end at the border, or "auto" for those of the edges before them.
    corners
        Corners of the sheet, top left, top right, bottom left, bottom right: two numbers each, the
        shares of the ways from the nearest inner vertex to the border along the row and the column;
        or "auto" for parallelograms.
    flap
        Width of flaps that fold flat at the target, square to their border; "auto" takes the mean
        length of the border's edges, 0 leaves them out. They stand beside the left and the right
        border, where it is straight; borders of named sheets with flaps are.

    Raises
    ------
    InputError
        If an argument has no meaning, or lists are not as long as the sheet needs.
    DesignError
        If there is no such sheet: the condition, where, by how much, what works.

    Examples
    --------
    >>> design_flat_foldable(rows=5, columns=6).mechanism
    FlatFoldable(7 x 8 vertices, 42 panels, drive to 90 degrees)
    """
    if sheet == "lists":
        assert row_folds != "auto"
        assert column_folds != "auto"
        lists = Lists(
            row_folds=row_folds,
            column_folds=column_folds,
            row_angles=_given(row_angles),
            column_angles=_given(column_angles),
            row_lengths=_given(row_lengths) or [row_length] * (columns - 1),
            column_lengths=_given(column_lengths) or [column_length] * (rows - 1),
            top=_given(top_lengths),
            bottom=_given(bottom_lengths),
            left=_given(left_lengths),
            right=_given(right_lengths),
            corners=_given(corners),
        )
        return _listed(lists, None if fold == "auto" else fold, flap)
    named = NamedSheet(
        rows,
        columns,
        sector,
        float(np.pi / 2) if fold == "auto" else fold,
        row_length,
        column_length,
        growth,
    )
    return _named(named, sheet, None if turn == "auto" else turn, flap)


def _listed(lists: Lists, fold: float | None, flap: float | Auto) -> Design:
    net = lists.net()
    if fold is not None:
        share = np.tan(0.5 * fold) / max(np.abs(net.x).max(), np.abs(net.y).max())
        net = replace(net, x=share * net.x, y=share * net.y)
    fault = find_fault(net)
    if fault is not None:
        given = {"row_angles_deg": lists.row_angles, "column_angles_deg": lists.column_angles}
        changes = [Remedy({f"pattern.{key}": "auto"}) for key in given if given[key] is not None]
        if len(changes) > 1:
            changes.append(changes[0] | changes[1])
        raise DesignError(
            fault.condition,
            place=fault.place,
            size=fault.size,
            candidates=changes,
            excess=fault.excess,
        )
    return completed(net, {"sheet": "lists"}, flap=flap)


def _named(named: NamedSheet, sheet: str, turn: float | None, flap: float | Auto) -> Design:
    if sheet == "miura":
        return _checked_named(named, named.miura(), {"sheet": sheet}, flap)
    make: Callable[[float], Net] = named.arch if sheet == "arch" else named.fan

    def works(turn: float) -> bool:
        return find_fault(make(turn)) is None

    if turn is None:
        turn = TURNS[sheet]
        while not works(turn) and turn > SMALLEST_TURN * TURNS[sheet]:
            turn *= 0.5

    described: dict[str, Parameter] = {"sheet": sheet, "turn_deg": tidy_degrees(turn)}
    if not works(turn):
        sign = float(np.sign(turn))
        found = largest_below(lambda size: works(sign * size), abs(turn), smallest=SMALLEST_TURN)
        if found is not None:
            raise _too_large(named, turn, sign * rounded_down(float(np.rad2deg(found))), make(turn))
    return _checked_named(named, make(turn), described, flap, arched=sheet == "arch")


def _too_large(named: NamedSheet, turn: float, most: float, net: Net) -> DesignError:
    """The refusal of a turn (radians), the largest that works being ``most`` (degrees)."""
    fault = find_fault(net)
    assert fault is not None
    asked = tidy_degrees(turn)
    return DesignError(
        f"turn_deg = {asked:g} is too large for {named.rows} rows and {named.columns} columns",
        keys=("pattern.turn_deg",),
        place=fault.place,
        size=f"{fault.condition}; up to {most:g} works",
        candidates=[Remedy({"pattern.turn_deg": rounded(share * most)}) for share in (0.9, 0.5)],
        excess=asked / most - 1,
    )


def _checked_named(
    named: NamedSheet,
    net: Net,
    described: dict[str, Parameter],
    flap: float | Auto,
    *,
    arched: bool = False,
) -> Design:
    if flap:
        net = with_parallel_borders(net)
    fault = find_fault(net)
    if fault is not None:
        raise DesignError(
            fault.condition,
            place=fault.place,
            size=fault.size,
            candidates=[
                *([Remedy({"pattern.growth": 1.0})] if named.growth != 1 else []),
                Remedy({"pattern.sector_deg": 60.0}),
            ],
            excess=fault.excess,
        )
    given: dict[str, Parameter] = {
        **described,
        "sector_deg": tidy_degrees(named.sector),
        "growth": named.growth,
    }
    return completed(net, given, arched=arched, flap=flap)


def completed(
    net: Net, described: dict[str, Parameter], *, arched: bool = False, flap: float | Auto = 0.0
) -> Design:
    """The design of a net, level about the origin, with flaps beside straight borders."""
    bare = levelled(net, arched=arched)
    grows = described.get("growth", 1.0) != 1.0
    require_resolution(bare, [Remedy({"pattern.growth": 1.0})] if grows else [])
    if arched:
        bare = with_level_ends(bare)
    locked = with_any_flaps(bare, None if flap == "auto" else flap) if flap else None
    return Design(
        mechanism=locked or bare,
        parameters={
            **described,
            "fold_deg": tidy_degrees(bare.target_drive),
            "flap": flap_width(locked) if locked else 0.0,
            **describe(bare.sheet),
        },
        targets={},
        closeness={},
        swept=None,
        warnings=(),
        may_stand=True,
    )


def _given(value: Any) -> Any:
    return None if value == "auto" else value

r"""Heights of all hinges of whole boards: as near to the boards as the conditions allow.

Valleys fold upwards, so their hinges lie at or above the upper faces of both boards, those of
mountains at or below both undersides; then the boards fold to 180 degrees. Where sin a = sin b at
all vertices, columns going straight on (rows likewise, turned), with s_i the sign of row i and t
the thickness, boards lying in the middle of the sheet,

    h_row(i) = s_i t/2,    h_column(i, j) = (-1)^i (h_j - t S_i),    S_i = sum_{k<i} (-1)^k s_k,

h_j = t/2 + t max S for columns that begin as valleys, -t/2 + t min S for the others. Row hinges lie
on the faces, column hinges stand off them by up to t (max S - min S): R t where rows alternate,
which is the least. Columns that do not fold need no hinge. Elsewhere a linear program finds the
shortest longest arm, and how high boards lie. All of it grows with the thickness alone.

Axes of hinges with knuckles of radius r stand r off the faces or more if heights are those for
boards of thickness t + 2r, and the boards lie in the middle of these.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.formatting import rounded, rounded_down
from orishell.design import PanelSpec
from orishell.motion import Mechanism, find_assignment
from orishell.motion.grid import CreaseValues
from orishell.motion.hinges import Hinges
from orishell.numerics.arrays import Array
from orishell.solids.hinged.conditions import Vertices
from orishell.solids.hinged.program import least_arms

STRAIGHT = 1e-9
"""Sectors that differ by less than this make a straight column (radians)."""


def find_hinges(mechanism: Mechanism, build: PanelSpec) -> Hinges:
    """The hinges of whole boards of a sheet.

    Raises
    ------
    DesignError
        If the sheet does not fold flat, or arms would be longer than they may.
    """
    vertices = Vertices.of(mechanism.positions(0.0), find_assignment(mechanism))
    unit = closed_form(vertices) or least_arms(vertices)
    hinges = _scaled(unit, build.thickness, build.hinge.knuckle)
    if hinges.longest_arm > build.longest_arm:
        raise _too_long(hinges, build)
    return hinges


def closed_form(vertices: Vertices) -> Hinges | None:
    """The hinges of boards of thickness 1 where columns, or rows, are straight; or None."""
    a, b, mode, signs = vertices.a, vertices.b, vertices.row_mode, vertices.signs
    if ((mode & (np.abs(a - b) <= STRAIGHT)) | vertices.still).all() and signs.row.all():
        row, column = _straight_columns(signs.row[:, 0], signs.column[0])
    elif ((~mode & (np.abs(a + b - np.pi) <= STRAIGHT)) | vertices.still).all() and (
        signs.column.all()
    ):
        turned = _straight_columns(signs.column[0], signs.row[:, 0])
        column, row = turned[0].T, turned[1].T
    else:
        return None
    levels = np.full((len(column), row.shape[1]), -0.5)
    return hinges_of(signs, CreaseValues(row, column), levels)


def _straight_columns(rows: Array, columns: Array) -> tuple[Array, Array]:
    """Heights of rows (R, C+1) and columns (R+1, C) by signs of rows (R,) and columns (C,)."""
    by_turns = (-1.0) ** np.arange(len(rows) + 1)
    sums = np.concatenate([[0.0], np.cumsum(by_turns[:-1] * rows)])
    first = np.where(columns > 0, 0.5 + sums.max(), sums.min() - 0.5)
    folds = np.where(columns == 0, 0.0, 1.0)
    of_rows = np.repeat(0.5 * rows[:, None], len(columns) + 1, axis=1)
    return of_rows, by_turns[:, None] * (first - sums[:, None]) * folds


def hinges_of(signs: CreaseValues, heights: CreaseValues, levels: Array) -> Hinges:
    """Hinges at heights, with boards of thickness 1 at levels (rows-1, columns-1)."""

    def arms(sign: Array, height: Array, level: Array) -> Array:
        off = np.where(sign > 0, height - level - 1.0, level - height)
        return np.where(sign == 0, 0.0, off)

    across, down = (levels[:, :-1], levels[:, 1:]), (levels[:-1], levels[1:])
    return Hinges(
        signs,
        heights,
        levels,
        1.0,
        (
            np.stack([arms(signs.row, heights.row, each) for each in down]),
            np.stack([arms(signs.column, heights.column, each) for each in across]),
        ),
    )


def _scaled(unit: Hinges, thickness: float, knuckle: float) -> Hinges:
    """Those of boards of a thickness, by those of thickness 1; all axes a knuckle off the faces."""
    wide, signs = thickness + 2 * knuckle, unit.signs
    heights = CreaseValues(wide * unit.heights.row, wide * unit.heights.column)
    row, column = (
        wide * each + np.where(sign == 0, 0.0, knuckle)
        for each, sign in zip(unit.arms, (signs.row, signs.column), strict=True)
    )
    levels = wide * unit.levels + knuckle
    return Hinges(signs, heights, levels, thickness, (row, column), knuckle)


THINNER = (0.999, 0.5, 0.1)
"""Shares of the thickness whose arms are as long as they may be that are offered."""


def _too_long(hinges: Hinges, build: PanelSpec) -> DesignError:
    """The refusal of arms that are longer than they may be."""
    needed, most, knuckle = hinges.longest_arm, build.longest_arm, build.hinge.knuckle
    # Arms are as many times the thickness of boards and two knuckles, and a knuckle.
    times = (needed - knuckle) / (build.thickness + 2 * knuckle)
    thinnest = (most - knuckle) / times - 2 * knuckle if times else 0.0
    shares = THINNER if thinnest > 0 else ()
    thinner = [Remedy({"panel.thickness": rounded_down(share * thinnest)}) for share in shares]
    return DesignError(
        "hinges would stand farther off their boards than arms may be long",
        keys=("panel.largest_arm",),
        size=f"arms of {needed:.4g} are needed, {needed / build.thickness:.4g} times the "
        f"thickness, and may be {most:.4g} long",
        candidates=[
            Remedy({"panel.largest_arm": rounded(needed * 1.0005)}),
            *thinner,
        ],
        excess=needed / most - 1 if most > 0 else None,
    )
